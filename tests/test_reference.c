/* The references themselves, against sources that share nothing with them: Arb at 128 bits, GSL, brute quadrature. */
#include "report.h"
#include "ref.h"
#include <acb_hypgeom.h>
#include <gsl/gsl_sf_legendre.h>

#define LD_EPS LDBL_EPSILON

static long double arb_to_long_double(const arb_t x)
{
    const double high = arf_get_d(arb_midref(x), ARF_RND_NEAR);
    arb_t low;
    double rest;
    arb_init(low);
    arb_set_d(low, high);
    arb_sub(low, x, low, 192);
    rest = arf_get_d(arb_midref(low), ARF_RND_NEAR);
    arb_clear(low);
    return (long double)high + rest;
}

/* Real Y from Arb's complex one, at the exact direction of v: theta and phi by Arb's atan2. */
static void arb_values(int bands, const double v[3], long double *y)
{
    const long prec = 192;
    arb_t x, t, theta, phi;
    acb_t ctheta, cphi, r;
    int l, m;

    arb_init(x); arb_init(t); arb_init(theta); arb_init(phi);
    acb_init(ctheta); acb_init(cphi); acb_init(r);
    arb_set_d(x, v[0]); arb_mul(t, x, x, prec);
    arb_set_d(x, v[1]); arb_addmul(t, x, x, prec);
    arb_sqrt(t, t, prec);
    arb_set_d(x, v[2]);
    arb_atan2(theta, t, x, prec);
    arb_set_d(x, v[0]);
    arb_set_d(t, v[1]);
    arb_atan2(phi, t, x, prec);
    acb_set_arb(ctheta, theta);
    acb_set_arb(cphi, phi);
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            const long double scale = m ? sqrtl(2.0L) : 1;     /* Condon-Shortley is in Arb's Y */
            acb_hypgeom_spherical_y(r, l, m, ctheta, cphi, prec);
            y[l * (l + 1) + m] = scale * arb_to_long_double(acb_realref(r));
            if (m) y[l * (l + 1) - m] = scale * arb_to_long_double(acb_imagref(r));
        }
    arb_clear(x); arb_clear(t); arb_clear(theta); arb_clear(phi);
    acb_clear(ctheta); acb_clear(cphi); acb_clear(r);
}

static void basis_against_arb(void **state)
{
    row *w = row_open("reference Y, Arb 192 bits", "f64");
    double v[3];
    long double got[REF_MAX], want[REF_MAX];
    int turn, i;

    (void)state;
    for (turn = 0; turn < effort(6); turn++) {
        const int bands = turn ? 32 : REF_MAX_BANDS;
        long double p[3];
        ref_unit(v);
        for (i = 0; i < 3; i++) p[i] = v[i];
        row_case("v %.17g %.17g %.17g", v[0], v[1], v[2]);
        ref_values(bands, p, got);
        arb_values(bands, v, want);
        for (i = 0; i < bands * bands; i++)
            row_check(w, got[i], want[i], 64 * LD_EPS * ref_M(ref_band(i)), i);
    }
    row_close(w);
}

static void basis_against_gsl(void **state)
{
    row *w = row_open("reference Y, GSL", "f64");
    int turn, l, m;

    (void)state;
    for (turn = 0; turn < effort(50); turn++) {
        const double theta = ref_between(0, 3.14159), phi = ref_between(-4, 4);
        const ref_jet angles[2] = { ref_const(theta), ref_const(phi) };
        ref_jet v[3];
        static ref_jet y[REF_MAX];
        v[0] = ref_mul(ref_sin(angles[0]), ref_cos(angles[1]));
        v[1] = ref_mul(ref_sin(angles[0]), ref_sin(angles[1]));
        v[2] = ref_cos(angles[0]);
        ref_basis(32, v, y);
        row_case("theta %.17g phi %.17g", theta, phi);
        for (l = 0; l < 32; l++)
            for (m = 0; m <= l; m++) {
                const double p = gsl_sf_legendre_sphPlm(l, m, cos(theta)) * (m ? sqrt(2.0) : 1.0);
                const long double bound = 1e-13L * ref_M(l);
                row_check(w, p * cos(m * phi), y[l * (l + 1) + m].v, bound, l * (l + 1) + m);
                if (m) row_check(w, p * sin(m * phi), y[l * (l + 1) - m].v, bound, l * (l + 1) - m);
            }
    }
    row_close(w);
}

/* The jets' derivatives against fourth-order differences of the values, scale by scale. */
static void derivatives_against_differences(void **state)
{
    row *g = row_open("reference gradient, differences", "f64"), *h = row_open("reference Hessian, differences", "f64");
    static const int plane[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
    static ref_jet at[REF_MAX], step[4][REF_MAX];
    static const double offset[4] = { -2, -1, 1, 2 }, weight[4] = { 1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12 };
    const int bands = 12;
    int turn, i, j, k, s, light;

    (void)state;
    for (turn = 0; turn < effort(20); turn++)
        for (light = 0; light < 2; light++) {
            double u[3];
            long double p[3];
            const long double center[3] = { 0.25L, -0.5L, 0.125L }, radius = ref_between(0.01, 0.7), e = 1e-4L;
            ref_unit(u);
            for (k = 0; k < 3; k++) p[k] = light ? center[k] + u[k] * 1.25L : u[k] * 1.25L;
            row_case("light %d radius %g u %g %g %g", light, (double)radius, u[0], u[1], u[2]);
            for (j = -1; j < 3; j++) {
                for (s = 0; s < 4; s++) {
                    long double q[3];
                    ref_jet v[3];
                    memcpy(q, p, sizeof q);
                    if (j >= 0) q[j] += offset[s] * e;
                    for (k = 0; k < 3; k++) v[k] = ref_var(q[k], k);
                    if (light) ref_sphere(bands, q, center, radius, j < 0 ? at : step[s]);
                    else ref_basis(bands, v, j < 0 ? at : step[s]);
                }
                if (j < 0) continue;
                for (i = 0; i < bands * bands; i++) {
                    long double d = 0, dd[3] = { 0, 0, 0 };
                    for (s = 0; s < 4; s++) {
                        d += weight[s] / e * step[s][i].v;
                        for (k = 0; k < 3; k++) dd[k] += weight[s] / e * step[s][i].g[k];
                    }
                    row_check(g, d, at[i].g[j], 1e-9L, i);
                    for (k = 0; k < 3; k++) row_check(h, dd[k], at[i].h[plane[j][k]], 1e-7L, i);
                }
            }
        }
    row_close(g);
    row_close(h);
}

/* The sphere light from nothing but "integrate Y over the directions that hit it". */
static void sphere_against_quadrature(void **state)
{
    enum { BANDS = 10, NT = BANDS, NP = 2 * BANDS + 1 };
    row *w = row_open("reference sphere, quadrature over the cap", "f64");
    static ref_jet c[REF_MAX];
    long double x[NT], weight[NT], y[BANDS * BANDS], sum[BANDS * BANDS];
    int turn, i, k, a, b;

    (void)state;
    ref_gauss(NT, x, weight);
    for (turn = 0; turn < effort(20); turn++) {
        double u[3], angle = asin(ref_log_between(1e-6, 0.9999));
        const long double origin[3] = { 0, 0, 0 };
        long double center[3], e1[3] = { 0, 0, 0 }, e2[3], n = 0;
        int least;
        ref_unit(u);
        for (k = 0; k < 3; k++) n += (long double)u[k] * u[k];
        for (k = 0; k < 3; k++) center[k] = u[k] / sqrtl(n);
        least = fabsl(center[0]) < 0.6L ? 0 : fabsl(center[1]) < 0.6L ? 1 : 2;
        e1[least] = 1;
        for (k = 0; k < 3; k++) e1[k] -= center[least] * center[k];
        n = sqrtl(e1[0] * e1[0] + e1[1] * e1[1] + e1[2] * e1[2]);
        for (k = 0; k < 3; k++) e1[k] /= n;
        for (k = 0; k < 3; k++)
            e2[k] = center[(k + 1) % 3] * e1[(k + 2) % 3] - center[(k + 2) % 3] * e1[(k + 1) % 3];
        memset(sum, 0, sizeof sum);
        for (a = 0; a < NT; a++)
            for (b = 0; b < NP; b++) {
                const long double half = sinl((long double)angle / 2), t = half * half * (1 + x[a]);   /* 1 - cosine */
                const long double s = sqrtl(t * (2 - t)), phi = 2 * REF_PI * b / NP;
                long double d[3];
                for (k = 0; k < 3; k++) d[k] = (1 - t) * center[k] + s * (cosl(phi) * e1[k] + sinl(phi) * e2[k]);
                ref_values(BANDS, d, y);
                for (i = 0; i < BANDS * BANDS; i++) sum[i] += weight[a] * half * half * 2 * REF_PI / NP * y[i];
            }
        ref_sphere(BANDS, origin, center, sinl((long double)angle), c);
        row_case("angle %g u %g %g %g", angle, u[0], u[1], u[2]);
        for (i = 0; i < BANDS * BANDS; i++)
            row_check(w, c[i].v, sum[i], 200 * LD_EPS * ref_M(ref_band(i)) * c[0].v * 3.5449L, i);
    }
    row_close(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(basis_against_arb),
        cmocka_unit_test(basis_against_gsl),
        cmocka_unit_test(derivatives_against_differences),
        cmocka_unit_test(sphere_against_quadrature),
    };
    return RUN_TESTS(tests);
}
