/* test_polygon.c - sh_polygon.h against quadrature in the plane, against itself (invariants), and at every
 * degenerate row. */
#ifndef T
#include "sh_polygon.h"
#include "report.h"
#include "ref.h"
#include "polygon_ref.h"

#define BOTH "test_polygon.c"

/* Shapes on a grid of 2^-20, so that every difference and, at the heights used, every determinant is exact in
 * long double. */
typedef struct { int count; double v[3 * 8], point[3]; const char *name; } scene_of;

/* gcc 12 -O3 -march=native drops the rounding of a (double)(float) chain it vectorises */
static double as_float(double x)
{
    volatile float f = (float)x;
    return (double)f;
}

static double grid(double x) { return floor(x * 1048576 + 0.5) / 1048576; }

/* kind 0 triangle, 1 quadrilateral, 2 pentagon, 3 L, 4 needle 1:1000; ratio size/distance, graze = sine of
 * the angle to the plane */
static void make_scene(scene_of *s, int kind, double ratio, double graze, int turned)
{
    static const char *const names[5] = { "triangle", "quad", "pentagon", "L", "needle" };
    static const double l_shape[12] = { 0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2 };
    double xy[12], u[3] = { 1, 0, 0 }, v[3] = { 0, 1, 0 }, w[3] = { 0, 0, 1 }, d = 0, n = 0,
                   az = ref_between(0, 6.283), lateral, scale = 1;
    int i, k;
    s->name = names[kind];
    s->count = kind == 0 || kind == 4 ? 3 : kind == 1 ? 4 : kind == 2 ? 5 : 6;
    for (i = 0; i < s->count; i++) {
        const double a = 6.283185307 * (i + ref_between(-0.3, 0.3)) / s->count;
        xy[2 * i] = kind == 3 ? l_shape[2 * i] - 0.8 : cos(a);
        xy[2 * i + 1] = kind == 3 ? l_shape[2 * i + 1] - 0.8 : sin(a);
    }
    if (kind == 4) {
        xy[0] = -1;
        xy[1] = 0;
        xy[2] = 1;
        xy[3] = ref_between(-0.5, 0.5);
        xy[4] = xy[2] - xy[3] * 0.002;
        xy[5] = xy[3] + 0.002;
    }
    if (turned) {
        ref_unit(u);
        do {
            ref_unit(v);
            d = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        } while (fabs(d) > 0.9);
        for (k = 0; k < 3; k++) {
            v[k] -= d * u[k];
            n += v[k] * v[k];
        }
        for (k = 0; k < 3; k++) v[k] /= sqrt(n);
        w[0] = u[1] * v[2] - u[2] * v[1];
        w[1] = u[2] * v[0] - u[0] * v[2];
        w[2] = u[0] * v[1] - u[1] * v[0];
    }
    /* far away: shrink the light rather than move the point, coordinates stay on the grid of floats */
    if (ratio < 1e-2) scale = ldexp(1, (int)floor(log2(ratio / 1e-2)));
    lateral = sqrt(fabs(1 - graze * graze)) / ratio;
    for (i = 0; i < s->count; i++)
        for (k = 0; k < 3; k++)
            s->v[3 * i + k] = as_float(scale * grid(xy[2 * i] * u[k] + xy[2 * i + 1] * v[k]));
    for (k = 0; k < 3; k++) {
        const double h = w[k] * graze / ratio + lateral * (cos(az) * u[k] + sin(az) * v[k]);
        s->point[k] = as_float(scale * (turned ? h : grid(h)));
    }
    if (!turned) s->point[2] = as_float(scale * ldexp(floor(ldexp(graze / ratio, 30) + 1), -30));
}

/* The closed form in each edge's own frame in long double: e, f in the frame [middle, mu x middle,
 * mu], turned to the world by quadrature over the sphere. Shares nothing with the header but the polygon.
 * Positive from behind; l >= 1. */
static void edge_frames(int n, const double *point, int count, const double *v, long double *c,
                        long double *g)
{
    static long double x[17], w[17], world[REF_POLYGON_SIZE], local[REF_POLYGON_SIZE];
    const int size = n * n;
    int i, j, k, l, m, a, b;
    ref_gauss(17, x, w);
    for (k = 0; k < size; k++) c[k] = 0;
    for (k = 0; k < 3 * size; k++) g[k] = 0;
    for (i = 0; i < count; i++) {
        const double *const from = v + 3 * i, *const to = v + 3 * ((i + 1) % count);
        long double A[3], E[3], N[3], u[3], mid[3], third[3], r = 0, len = 0, dot = 0, ew = 0, gamma, k0, k1,
                                                              kc, ks, I[20], e[REF_POLYGON_SIZE],
                                                              f[REF_POLYGON_SIZE];
        for (k = 0; k < 3; k++) {
            A[k] = (long double)from[k] - point[k];
            E[k] = (long double)to[k] - from[k];
            r += A[k] * A[k];
        }
        r = sqrtl(r);
        for (k = 0; k < 3; k++) {
            N[k] = A[(k + 1) % 3] * E[(k + 2) % 3] - A[(k + 2) % 3] * E[(k + 1) % 3];
            len += N[k] * N[k];
            dot += A[k] * (A[k] + E[k]);
            ew += E[k] * A[k] / r;
        }
        len = sqrtl(len);
        if (len == 0) continue;
        gamma = atan2l(len, dot);
        k0 = 1 / r;
        k1 = -ew / len;
        for (k = 0; k < 3; k++) N[k] /= len;
        for (k = 0; k < 3; k++)
            u[k] = (N[(k + 1) % 3] * A[(k + 2) % 3] - N[(k + 2) % 3] * A[(k + 1) % 3]) / r;
        for (k = 0; k < 3; k++) mid[k] = A[k] / r * cosl(gamma / 2) + u[k] * sinl(gamma / 2);
        for (k = 0; k < 3; k++)
            third[k] = N[(k + 1) % 3] * mid[(k + 2) % 3] - N[(k + 2) % 3] * mid[(k + 1) % 3];
        kc = k0 * cosl(gamma / 2) + k1 * sinl(gamma / 2);
        ks = -k0 * sinl(gamma / 2) + k1 * cosl(gamma / 2);
        I[0] = gamma;
        for (k = 1; k < 20; k++) I[k] = 2 * sinl(k * gamma / 2) / k;
        memset(e, 0, sizeof e);
        memset(f, 0, sizeof f);
        for (l = 0; l < n; l++)
            for (m = 0; m <= l; m++) {
                long double q0[3], q1[3], norm = (2 * l + 1) / (4 * REF_PI) * (m ? 2 : 1);
                for (k = l - m + 1; k <= l + m; k++) norm /= k;
                norm = (m & 1 ? -1 : 1) * sqrtl(norm);
                ref_legendre(l, m, 0, q0);
                ref_legendre(l, m + 1, 0, q1);
                if (l) e[l * l + l + m] = norm * (m < l ? q1[0] : 0) / (l * (l + 1)) * I[m];
                f[l * l + l + m] = norm * q0[0] * kc * (I[m ? m - 1 : 1] + I[m + 1]) / 2;
                if (m) f[l * l + l - m] = norm * q0[0] * ks * (I[m - 1] - I[m + 1]) / 2;
            }
        for (a = 0; a < 17; a++)
            for (b = 0; b < 34; b++) {
                const long double t = REF_PI * b / 17, st = sqrtl(1 - x[a] * x[a]),
                                  weight = w[a] * REF_PI / 17;
                const long double d[3] = { st * cosl(t), st * sinl(t), x[a] };
                long double own[3], se[REF_POLYGON_BANDS], sf[REF_POLYGON_BANDS];
                own[0] = own[1] = own[2] = 0;
                for (k = 0; k < 3; k++) {
                    own[0] += d[k] * mid[k];
                    own[1] += d[k] * third[k];
                    own[2] += d[k] * N[k];
                }
                ref_values(n, d, world);
                ref_values(n, own, local);
                for (l = 0; l < n; l++) {
                    se[l] = sf[l] = 0;
                    for (j = l * l; j < (l + 1) * (l + 1); j++) {
                        se[l] += e[j] * local[j];
                        sf[l] += f[j] * local[j];
                    }
                    for (j = l * l; j < (l + 1) * (l + 1); j++) {
                        c[j] += weight * se[l] * world[j];
                        for (k = 0; k < 3; k++) g[k * size + j] += weight * sf[l] * world[j] * N[k];
                    }
                }
            }
    }
}

static double sign_of(const ref_polygon_light *r) { return r->c[0] < 0 ? -1 : 1; }

#include "both.h"

int main(void)
{
    const struct CMUnitTest t[] = { BOTH_TESTS(accuracy),    BOTH_TESTS(extremes),   BOTH_TESTS(solid_angle),
                                    BOTH_TESTS(sides),       BOTH_TESTS(in_plane),   BOTH_TESTS(degenerate),
                                    BOTH_TESTS(statuses),    BOTH_TESTS(invariants), BOTH_TESTS(crossing),
                                    BOTH_TESTS(differences), BOTH_TESTS(winding),    BOTH_TESTS(switches),
                                    BOTH_TESTS(edge_frame),  BOTH_TESTS(feet) };
    return RUN_TESTS(t);
}
#else

static void F(compare)(row *values, row *gradient, int bands, const scene_of *s, const ref_polygon_light *r)
{
    T point[3], v[24], c[256], g[768];
    const long double limit = r->edge < 1e-3L ? 1000 : 64;
    int i, k;
    for (k = 0; k < 3; k++) point[k] = (T)s->point[k];
    for (k = 0; k < 3 * s->count; k++) v[k] = (T)s->v[k];
    assert_int_equal(F(sh_polygon)(bands, SH_BOTH, point, (size_t)s->count, v, c, g), SH_OK);
    for (i = 0; i < bands * bands; i++) {
        const int l = ref_band(i);
        row_check(values, (long double)c[i], (long double)sign_of(r) * r->c[i],
                  limit * (long double)EPS * ref_M(l) * r->solid, i);
        for (k = 0; k < 3; k++)
            row_check(gradient, (long double)g[k * bands * bands + i], (long double)sign_of(r) * r->g[k][i],
                      limit * (long double)EPS * (ref_M(l) * r->slope + ref_G(l) * r->solid / r->nearest),
                      k * bands * bands + i);
    }
}

/* every shape, size/distance 1e-6 .. 10, any angle */
static void F(accuracy)(void **state)
{
    static const int counts[5] = { 1, 3, 5, 9, 16 };
    row *values = row_open("sh_polygon values", PRECISION),
        *gradient = row_open("sh_polygon gradient", PRECISION);
    int i;
    (void)state;
    for (i = 0; i < effort(100); i++) {
        scene_of s;
        ref_polygon_light r;
        const int bands = counts[i / 5 % 5];
        const double ratio = i % 3 ? ref_log_between(1e-6, 10) : ref_log_between(0.05, 3),
                     graze = ref_between(0.05, 1);
        make_scene(&s, i % 5, ratio, graze, i % 2);
        ref_polygon(bands, s.point, s.count, s.v, &r);
        row_case("%s, %d bands, size/distance %.1e, sine %.2g", s.name, bands, ratio, graze);
        F(compare)(values, gradient, bands, &s, &r);
    }
    row_close(values);
    row_close(gradient);
}

/* grazing to 1e-6, beside and above the light; the gradient's reference loses 1/height above it and is left
 * out there in f64 */
static void F(extremes)(void **state)
{
    row *values = row_open("sh_polygon grazing values", PRECISION),
        *gradient = row_open("sh_polygon grazing gradient", PRECISION);
    row *above = row_open("sh_polygon grazing, above, values", PRECISION),
        *unused = row_open("sh_polygon grazing, above, gradient", "f32");
    int i;
    (void)state;
    for (i = 0; i < effort(30) || !values->checks || !above->checks; i++) {
        scene_of s;
        ref_polygon_light r;
        const int bands = 12;
        const double ratio = i % 2 ? ref_log_between(0.1, 0.45) : ref_log_between(0.05, 4),
                     graze = ref_log_between(1e-6, 1e-2);
        make_scene(&s, i % 5, ratio, graze, 0);
        ref_polygon(bands, s.point, s.count, s.v, &r);
        row_case("%s, size/distance %.1e, sine %.1e", s.name, ratio, graze);
        if (r.solid < 0.1L) {
            F(compare)(values, gradient, bands, &s, &r);
        } else {
            row scratch;
            memset(&scratch, 0, sizeof scratch);
            F(compare)(above, IS_F32 ? unused : &scratch, bands, &s, &r);
        }
    }
    row_close(values);
    row_close(gradient);
    row_close(above);
    if (IS_F32) row_close(unused);
}

/* known solid angles: an octant, a cube's face from its middle, a rectangle by arcsine */
static void F(solid_angle)(void **state)
{
    static const T octant[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, origin[3] = { 0, 0, 0 };
    static const T face[12] = { -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1 };
    row *w = row_open("sh_polygon_solid_angle, known", PRECISION);
    T omega = 0, g[3];
    int i, k;
    (void)state;
    row_case("octant");
    assert_int_equal(F(sh_polygon_solid_angle)(SH_BOTH, origin, 3, octant, &omega, NULL), SH_OK);
    row_check(w, (long double)omega, REF_PI / 2, 4 * (long double)EPS, 0);
    row_case("face of a cube");
    assert_int_equal(F(sh_polygon_solid_angle)(SH_BOTH, origin, 4, face, &omega, g), SH_OK);
    row_check(w, (long double)omega, 2 * REF_PI / 3, 4 * (long double)EPS, 0);
    /* on its axis Omega(h) = 4 asin(1/(1+h^2)), h = 1 - z */
    row_check(w, (long double)g[0], 0, 4 * (long double)EPS, 1);
    row_check(w, (long double)g[2], 8 / (2 * sqrtl(3)), 8 * (long double)EPS, 3);
    for (i = 0; i < effort(50); i++) {
        const T h = (T)grid(ref_log_between(1e-5, 1e3)), point[3] = { 0, 0, 1 - h };
        const long double hh = 1 - (long double)point[2], want = 4 * atan2l(1, hh * sqrtl(2 + hh * hh));
        row_case("square at height %g", (double)h);
        F(sh_polygon_solid_angle)(SH_BOTH, point, 4, face, &omega, g);
        row_check(w, (long double)omega, want, 8 * (long double)EPS * want, 0);
        for (k = 0; k < 2; k++) row_check(w, (long double)g[k], 0, 16 * (long double)EPS * want / hh, 1 + k);
    }
    row_close(w);
}

/* from the front vertices run counter-clockwise: both +, signed +, front +; from behind both +, signed -,
 * front 0; reversed */
static void F(sides)(void **state)
{
    static const T quad[12] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 };
    static const T front[3] = { (T)0.25, (T)0.125, 2 }, behind[3] = { (T)0.25, (T)0.125, -2 };
    T back[12], c[3][25], g[3][75], d[3][25], e[3][75];
    int i, k;
    (void)state;
    for (i = 0; i < 12; i++) back[i] = quad[3 * (3 - i / 3) + i % 3];
    for (k = 0; k < 3; k++) {
        assert_int_equal(F(sh_polygon)(5, k, front, 4, quad, c[k], g[k]), SH_OK);
        assert_int_equal(F(sh_polygon)(5, k, behind, 4, quad, d[k], e[k]), SH_OK);
    }
    assert_true(c[SH_BOTH][0] > 0 && d[SH_BOTH][0] > 0);
    for (i = 0; i < 25; i++) {
        assert_true(c[SH_FRONT][i] == c[SH_BOTH][i] && c[SH_SIGNED][i] == c[SH_BOTH][i]);
        assert_true(d[SH_FRONT][i] == 0 && d[SH_SIGNED][i] == -d[SH_BOTH][i]);
    }
    for (i = 0; i < 75; i++) {
        assert_true(g[SH_FRONT][i] == g[SH_BOTH][i] && g[SH_SIGNED][i] == g[SH_BOTH][i]);
        assert_true(e[SH_FRONT][i] == 0 && e[SH_SIGNED][i] == -e[SH_BOTH][i]);
    }
    F(sh_polygon)(5, SH_FRONT, front, 4, back, c[0], g[0]);
    F(sh_polygon)(5, SH_SIGNED, behind, 4, back, c[1], g[1]);
    assert_true(c[0][0] == 0 && c[1][0] > 0);
}

/* In the plane outside, inside, on an edge, on a vertex */
static void F(in_plane)(void **state)
{
    static const T quad[12] = { -1, -1, 0, 3, -1, 0, 3, 3, 0, -1, 3, 0 };
    static const T outside[3] = { 4, 1, 0 }, beside[3] = { 4, -1, 0 }, inside[3] = { (T)0.5, 1, 0 };
    static const T edge[3] = { 1, -1, 0 }, vertex[3] = { 3, 3, 0 };
    row *w = row_open("sh_polygon in its plane", PRECISION);
    T c[256], g[768], near[256], near_g[768];
    int i, side;
    (void)state;
    for (side = SH_BOTH; side <= SH_SIGNED; side++) {
        assert_int_equal(F(sh_polygon)(16, side, outside, 4, quad, c, g), SH_OK);
        for (i = 0; i < 256; i++) assert_true(c[i] == 0);
        for (i = 0; i < 768 && side != SH_SIGNED; i++) assert_true(g[i] == 0);
        assert_int_equal(F(sh_polygon)(16, side, beside, 4, quad, c, NULL), SH_OK);
        for (i = 0; i < 256; i++) assert_true(c[i] == 0);
        assert_int_equal(F(sh_polygon)(16, side, inside, 4, quad, c, g), SH_ON_LIGHT);
        row_case("inside, sides %d", side);
        for (i = 0; i < 256; i++) {     /* the front looks down: hemisphere about -z, only m = 0 */
            static const double share[16] = { 1, 0.5, 0, -1. / 8, 0, 1. / 16, 0, -5. / 128, 0, 7. / 256, 0,
                -21. / 1024, 0, 33. / 2048, 0, -429. / 32768 };
            const int l = ref_band(i), m = i - l * l - l;
            const long double want = m ? 0 : 2 * REF_PI * share[l] * ref_M(l) * (l % 2 ? -1 : 1);
            row_check(w, (long double)c[i], want, 16 * (long double)EPS * ref_M(l), i);
        }
        assert_int_equal(F(sh_polygon)(16, side, edge, 4, quad, near, near_g), SH_ON_LIGHT);
        row_case("on an edge, sides %d", side);
        for (i = 0; i < 256; i++)
            row_check(w, (long double)near[i], (long double)c[i] / 2, 8 * (long double)EPS, i);
        for (i = 0; i < 768; i++) assert_true(near_g[i] == 0);
        assert_int_equal(F(sh_polygon)(16, side, vertex, 4, quad, near, near_g), SH_ON_LIGHT);
        row_case("on a vertex, sides %d", side);
        for (i = 0; i < 256; i++)
            row_check(w, (long double)near[i], (long double)c[i] / 4, 8 * (long double)EPS, i);
        for (i = 0; i < 768; i++) assert_true(near_g[i] == 0);
    }
    row_close(w);
    /* the gradient inside the light is the front side's: continuous with a point just above it */
    w = row_open("sh_polygon gradient meets the plane", PRECISION);
    {
        const T step = IS_F32 ? (T)9.5367431640625e-07 : (T)9.094947017729282e-13,
                up[3] = { (T)0.5, 1, step };
        F(sh_polygon)(8, SH_BOTH, inside, 4, quad, c, g);
        F(sh_polygon)(8, SH_BOTH, up, 4, quad, near, near_g);
        for (i = 0; i < 192; i++)
            row_check(w, (long double)near_g[i], (long double)g[i], 64 * (long double)step, i);
        F(sh_polygon)(8, SH_SIGNED, outside, 4, quad, c, g);
        for (i = 0; i < 3; i++) near[i] = outside[i];
        near[2] = step;
        F(sh_polygon)(8, SH_SIGNED, near, 4, quad, c, near_g);
        for (i = 0; i < 192; i++)
            row_check(w, (long double)near_g[i], (long double)g[i], 64 * (long double)step, i);
    }
    row_close(w);
}

/* repeated and collinear vertices change nothing; zero area is exactly zero */
static void F(degenerate)(void **state)
{
    static const T point[3] = { (T)0.3, (T)-0.2, 1 };
    static const T quad[12] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 };
    static const T more[27] = { -1, -1, 0, -1, -1, 0, 0, -1, 0, 1, -1, 0, 1, -1, 0, 1, 1, 0,
        0, 1, 0, -1, 1, 0, -1, 0, 0 };
    static const T line[12] = { 0, 0, 0, 1, 2, 3, 2, 4, 6, -1, -2, -3 };
    static const T same[9] = { 1, 2, 3, 1, 2, 3, 1, 2, 3 };
    static const T spike[15] = { -1, -1, 0, 1, -1, 0, 5, -1, 0, 1, -1, 0, -1, 1, 0 };
    static const T plain[9] = { -1, -1, 0, 1, -1, 0, -1, 1, 0 }, at[3] = { 1, 2, 3 };
    row *w = row_open("sh_polygon with repeated vertices", PRECISION);
    T c[144], g[432], d[144], e[432];
    int i;
    (void)state;
    F(sh_polygon)(12, SH_BOTH, point, 4, quad, c, g);
    assert_int_equal(F(sh_polygon)(12, SH_BOTH, point, 9, more, d, e), SH_OK);
    for (i = 0; i < 144; i++)
        row_check(w, (long double)d[i], (long double)c[i], 16 * (long double)EPS * ref_M(ref_band(i)), i);
    for (i = 0; i < 432; i++)
        row_check(w, (long double)e[i], (long double)g[i], 32 * (long double)EPS * (ref_M(11) + ref_G(11)),
                  i);
    F(sh_polygon)(12, SH_BOTH, point, 3, plain, c, g);
    assert_int_equal(F(sh_polygon)(12, SH_BOTH, point, 5, spike, d, e), SH_OK);
    row_case("an edge there and back");
    for (i = 0; i < 144; i++)
        row_check(w, (long double)d[i], (long double)c[i], 16 * (long double)EPS * ref_M(ref_band(i)), i);
    row_close(w);
    assert_int_equal(F(sh_polygon)(12, SH_BOTH, point, 4, line, c, g), SH_OK);
    for (i = 0; i < 144; i++) assert_true(c[i] == 0);
    for (i = 0; i < 432; i++) assert_true(g[i] == 0);
    assert_int_equal(F(sh_polygon)(12, SH_BOTH, at, 3, same, c, g), SH_OK);
    for (i = 0; i < 144; i++) assert_true(c[i] == 0);
}

static void F(statuses)(void **state)
{
    static const T point[3] = { 0, 0, 1 }, quad[12] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 };
    T c[64], g[192], bad[12], far_away[3], omega = 0;
    int i;
    (void)state;
    for (i = 0; i < 64; i++) c[i] = 7;
    assert_int_equal(F(sh_polygon)(3, SH_BOTH, point, 2, quad, c, g), SH_ERROR_VERTICES);
    assert_int_equal(F(sh_polygon)(3, SH_BOTH, point, 0, quad, c, g), SH_ERROR_VERTICES);
    assert_int_equal(F(sh_polygon)(0, SH_BOTH, point, 4, quad, c, g), SH_ERROR_BANDS);
    assert_int_equal(F(sh_polygon)(17, SH_BOTH, point, 4, quad, c, g), SH_ERROR_BANDS);
    assert_int_equal(F(sh_polygon)(3, 3, point, 4, quad, c, g), SH_ERROR_OPTION);
    assert_int_equal(F(sh_polygon)(3, SH_BOTH, NULL, 4, quad, c, g), SH_ERROR_NULL);
    assert_int_equal(F(sh_polygon)(3, SH_BOTH, point, 4, NULL, c, g), SH_ERROR_NULL);
    assert_int_equal(F(sh_polygon)(3, SH_BOTH, point, 4, quad, NULL, g), SH_ERROR_NULL);
    assert_int_equal(F(sh_polygon)(3, SH_BOTH, point, 4, quad, c, c), SH_ERROR_OVERLAP);
    memcpy(bad, quad, sizeof bad);
    assert_int_equal(F(sh_polygon)(3, SH_BOTH, point, 4, bad, bad, NULL), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_polygon_within)(3, SH_BOTH, 0, point, 4, quad, c, c + 8, NULL, NULL), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_polygon_within)(3, SH_BOTH, 0, point, 4, quad, c, NULL, c + 8, NULL), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_polygon_solid_angle)(SH_BOTH, point, 4, quad, c, c), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_polygon_zonal)(3, quad, point, 4, quad, c, c + 2), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_triangle_as_sphere)(2, SH_BOTH, point, quad, quad + 3, quad + 6, c, NULL, c + 3), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_triangle_as_sphere)(2, SH_BOTH, point, bad, quad + 3, quad + 6, bad, NULL, NULL), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_polygon_within)(3, SH_BOTH, 0, point, 4, bad, bad, NULL, NULL, NULL), SH_ERROR_OVERLAP);
    for (i = 0; i < 2; i++) {
        const unsigned char bytes[2][8] = { { 0, 0, 0xc0, 0x7f, 0, 0, 0xf8, 0x7f },
                                            { 0, 0, 0x80, 0x7f, 0, 0, 0xf0, 0x7f } }; /* NaN, infinity */
        memcpy(bad, quad, sizeof bad);
        memset(&bad[5], 0, sizeof bad[5]);
        memcpy((char *)&bad[5] + sizeof bad[5] - 2, bytes[i] + (IS_F32 ? 2 : 6), 2);
        assert_int_equal(F(sh_polygon)(3, SH_BOTH, point, 4, bad, c, g), SH_ERROR_NOT_FINITE);
        memcpy(far_away, point, sizeof far_away);
        far_away[1] = bad[5];
        assert_int_equal(F(sh_polygon)(3, SH_BOTH, far_away, 4, quad, c, g), SH_ERROR_NOT_FINITE);
        assert_int_equal(F(sh_polygon_solid_angle)(SH_BOTH, far_away, 4, quad, &omega, NULL),
                         SH_ERROR_NOT_FINITE);
    }
    for (i = 0; i < 64; i++) assert_true(c[i] == 7);
    assert_int_equal(F(sh_polygon)(3, SH_BOTH, point, 4, quad, c, NULL), SH_OK);
}

/* a polygon is its parts; vertices may start anywhere; scale, shift and permuted axes */
static void F(invariants)(void **state)
{
    row *split = row_open("sh_polygon = its parts", PRECISION),
        *order = row_open("sh_polygon, first vertex moved", PRECISION);
    row *scale = row_open("sh_polygon, scaled by 2^k", PRECISION),
        *shift = row_open("sh_polygon, shifted", PRECISION);
    row *axes = row_open("sh_polygon, axes permuted", PRECISION);
    int i, j, k;
    (void)state;
    for (i = 0; i < effort(60); i++) {
        scene_of s;
        T p[3], v[24], c[64] = { 0 }, g[192] = { 0 }, d[64], e[192], q[3], u[24];
        const int kind = 1 + i % 3;
        long double omega;
        make_scene(&s, kind, ref_log_between(1e-3, 3), ref_between(0.1, 1), 0);
        for (k = 0; k < 3; k++) p[k] = (T)s.point[k];
        for (k = 0; k < 3 * s.count; k++) v[k] = (T)s.v[k];
        F(sh_polygon)(8, SH_SIGNED, p, (size_t)s.count, v, c, g);
        omega = fabsl((long double)c[0]) * sqrtl(4 * REF_PI);
        row_case("%s", s.name);
        {   /* two parts, cut at vertex 2 */
            T total[64], slopes[192];
            memcpy(u, v, 9 * sizeof v[0]);
            F(sh_polygon)(8, SH_SIGNED, p, 3, u, total, slopes);
            memcpy(u + 3, v + 6, (size_t)(3 * s.count - 6) * sizeof v[0]);
            F(sh_polygon)(8, SH_SIGNED, p, (size_t)s.count - 1, u, d, e);
            for (k = 0; k < 64; k++) {
                const long double sum = fabsl((long double)total[0]) + fabsl((long double)d[0]);
                row_check(split, (long double)total[k] + (long double)d[k], (long double)c[k],
                          64 * (long double)EPS * ref_M(ref_band(k)) * sum * 4, k);
            }
        }
        for (j = 0; j < 3 * s.count; j++) u[j] = v[(j + 3) % (3 * s.count)];
        F(sh_polygon)(8, SH_SIGNED, p, (size_t)s.count, u, d, e);
        for (k = 0; k < 64; k++)
            row_check(order, (long double)d[k], (long double)c[k],
                      64 * (long double)EPS * ref_M(ref_band(k)) * omega * 2, k);
        for (k = 0; k < 3; k++) q[k] = p[k] * 1024;
        for (k = 0; k < 3 * s.count; k++) u[k] = v[k] * 1024;
        F(sh_polygon)(8, SH_SIGNED, q, (size_t)s.count, u, d, e);
        for (k = 0; k < 64; k++) row_check(scale, (long double)d[k], (long double)c[k], 0, k);
        for (k = 0; k < 192; k++) row_check(scale, (long double)e[k], (long double)g[k] / 1024, 0, k);
        for (k = 0; k < 3; k++) {
            volatile float moved = (float)p[k] + 4;             /* -ffast-math would not round here */
            q[k] = (T)moved;
            p[k] = q[k] - 4;
        }
        for (k = 0; k < 3 * s.count; k++) {
            volatile float moved = (float)v[k] + 4;
            u[k] = (T)moved;
            v[k] = u[k] - 4;
        }
        F(sh_polygon)(8, SH_SIGNED, p, (size_t)s.count, v, c, g);
        F(sh_polygon)(8, SH_SIGNED, q, (size_t)s.count, u, d, e);
        for (k = 0; k < 64; k++) row_check(shift, (long double)d[k], (long double)c[k], 0, k);
        /* (x,y,z) -> (y,z,x): band 1 follows as the axes do, and every band keeps its norm */
        for (k = 0; k < 3; k++) q[k] = p[(k + 1) % 3];
        for (k = 0; k < 3 * s.count; k++) u[k] = v[k / 3 * 3 + (k + 1) % 3];
        F(sh_polygon)(8, SH_SIGNED, q, (size_t)s.count, u, d, e);
        row_check(axes, (long double)d[3], (long double)c[1], 64 * (long double)EPS * omega, 3);
        row_check(axes, -(long double)d[1], (long double)c[2], 64 * (long double)EPS * omega, 1);
        for (k = 0; k < 8; k++) {
            long double a = 0, b = 0;
            for (j = k * k; j < (k + 1) * (k + 1); j++) {
                a += (long double)c[j] * (long double)c[j];
                b += (long double)d[j] * (long double)d[j];
            }
            row_check(axes, sqrtl(b), sqrtl(a), 128 * (long double)EPS * ref_M(k) * omega * sqrtl(2 * k + 1),
                      k);
        }
    }
    row_close(split);
    row_close(order);
    row_close(scale);
    row_close(shift);
    row_close(axes);
}

/* a point that crosses the plane: signed is smooth outside; from inside, both sides' limits add up to the
 * whole sphere's band 0 */
static void F(crossing)(void **state)
{
    static const T quad[12] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 };
    row *w = row_open("sh_polygon across its plane", PRECISION);
    int i, k;
    (void)state;
    for (i = 2; i < (IS_F32 ? 30 : 40); i++) {
        const T h = (T)ldexp(1, -i), up[3] = { (T)1.5, (T)0.25, h }, down[3] = { (T)1.5, (T)0.25, -h };
        const T above[3] = { (T)0.25, (T)-0.5, h }, below[3] = { (T)0.25, (T)-0.5, -h };
        T c[25] = { 0 }, g[75] = { 0 }, d[25] = { 0 }, e[75] = { 0 };
        row_case("height 2^-%d", i);
        F(sh_polygon)(5, SH_SIGNED, up, 4, quad, c, g);
        F(sh_polygon)(5, SH_SIGNED, down, 4, quad, d, e);
        for (k = 0; k < 25; k++) {      /* mirrored in z: odd in h for even l-m */
            const int l = ref_band(k), m = k - l * l - l, odd = (l + m) & 1;
            row_check(w, (long double)d[k], (odd ? 1 : -1) * (long double)c[k],
                      32 * (long double)EPS * ref_M(l) * fabsl((long double)c[0]), k);
            row_check(w, (long double)e[50 + k], (odd ? -1 : 1) * (long double)g[50 + k],
                      32 * (long double)EPS * (ref_M(l) + ref_G(l)) * fabsl((long double)g[50]), 50 + k);
        }
        F(sh_polygon)(5, SH_BOTH, above, 4, quad, c, g);
        F(sh_polygon)(5, SH_BOTH, below, 4, quad, d, e);
        row_check(w, (long double)c[0], (long double)d[0], 0, 0);
    }
    row_close(w);
}

/* the gradient is the derivative: central differences of the values, in double */
static void F(differences)(void **state)
{
    row *w = row_open("sh_polygon gradient by differences", PRECISION);
    int i, k, j;
    (void)state;
    for (i = 0; i < effort(40); i++) {
        scene_of s;
        T p[3], v[24], c[100], g[300];
        double vd[24], pd[3], a[100], b[100];
        make_scene(&s, i % 4, ref_log_between(0.05, 2), ref_between(0.2, 1), 1);
        for (k = 0; k < 3; k++) p[k] = (T)s.point[k];
        for (k = 0; k < 3 * s.count; k++) {
            vd[k] = s.v[k];
            v[k] = (T)s.v[k];
        }
        F(sh_polygon)(10, SH_BOTH, p, (size_t)s.count, v, c, g);
        row_case("%s", s.name);
        for (k = 0; k < 3; k++) {
            const double h = 1e-5;
            double far2[100], near2[100];
            memcpy(pd, s.point, sizeof pd);
            pd[k] = s.point[k] + h;
            sh_polygon_f64(10, SH_BOTH, pd, (size_t)s.count, vd, a, NULL);
            pd[k] = s.point[k] - h;
            sh_polygon_f64(10, SH_BOTH, pd, (size_t)s.count, vd, b, NULL);
            pd[k] = s.point[k] + 2 * h;
            sh_polygon_f64(10, SH_BOTH, pd, (size_t)s.count, vd, far2, NULL);
            pd[k] = s.point[k] - 2 * h;
            sh_polygon_f64(10, SH_BOTH, pd, (size_t)s.count, vd, near2, NULL);
            for (j = 0; j < 100; j++)
                row_check(w, (long double)g[100 * k + j],
                          (8 * ((long double)a[j] - b[j]) - ((long double)far2[j] - near2[j]))
                              / (12 * (long double)h),
                          (IS_F32 ? 2e-5L : 2e-8L) * (1 + fabsl((long double)c[0])), 100 * k + j);
        }
    }
    row_close(w);
}

/* a bow tie: each half with its winding, behind it everywhere as its halves cancel; twice around: twice */
static void F(winding)(void **state)
{
    static const T p[3] = { (T)0.125, (T)0.25, 1 };
    static const T bow[12] = { -2, -1, 0, 2, 1, 0, 2, -1, 0, -2, 1, 0 };
    static const T left[9] = { -2, -1, 0, 0, 0, 0, -2, 1, 0 }, right[9] = { 0, 0, 0, 2, 1, 0, 2, -1, 0 };
    static const T twice[24] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0,
        -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 };
    row *w = row_open("sh_polygon, windings", PRECISION);
    T c[64] = { 0 }, a[64] = { 0 }, b[64] = { 0 };
    int i;
    (void)state;
    assert_int_equal(F(sh_polygon)(8, SH_SIGNED, p, 4, bow, c, NULL), SH_OK);
    F(sh_polygon)(8, SH_SIGNED, p, 3, left, a, NULL);
    F(sh_polygon)(8, SH_SIGNED, p, 3, right, b, NULL);
    row_case("bow tie");
    for (i = 0; i < 64; i++)
        row_check(w, (long double)c[i], (long double)a[i] + (long double)b[i],
                  64 * (long double)EPS * ref_M(ref_band(i)), i);
    assert_int_equal(F(sh_polygon)(8, SH_BOTH, p, 4, bow, a, NULL), SH_OK);
    assert_int_equal(F(sh_polygon)(8, SH_FRONT, p, 4, bow, b, NULL), SH_OK);
    row_case("bow tie, both sides");
    for (i = 0; i < 64; i++) row_check(w, (long double)a[i], -(long double)c[i], 0, i);
    row_case("bow tie, front side");
    for (i = 0; i < 64; i++) row_check(w, (long double)b[i], 0, 0, i);
    {
        T many[64], behind[3] = { p[0], p[1], -p[2] };
        static const int corners[1] = { 4 };
        assert_int_equal(F(sh_polygons_n)(8, SH_VALUES, 1, SH_BOTH, 1, p, 1, corners, bow, NULL, many), SH_OK);
        row_case("bow tie among many");
        for (i = 0; i < 64; i++) row_check(w, (long double)many[i], (long double)a[i], 64 * (long double)EPS, i);
        assert_int_equal(F(sh_polygon)(8, SH_FRONT, behind, 4, bow, b, NULL), SH_OK);
        row_case("bow tie, front side, other way");
        for (i = 0; i < 64; i++) row_check(w, (long double)b[i], 0, 0, i);
    }
    assert_int_equal(F(sh_polygon)(8, SH_SIGNED, p, 8, twice, c, NULL), SH_OK);
    F(sh_polygon)(8, SH_SIGNED, p, 4, twice, a, NULL);
    row_case("twice around");
    for (i = 0; i < 64; i++)
        row_check(w, (long double)c[i], 2 * (long double)a[i], 64 * (long double)EPS * ref_M(ref_band(i)) * 2,
                  i);
    row_close(w);
}

/* the solid angle at which edges give way to the surface: no step, whatever side a point falls on */
static void F(switches)(void **state)
{
    row *w = row_open("sh_polygon across its switch", PRECISION);
    const double limit = IS_F32 ? 1e-6 : 0.25;
    int i, k;
    (void)state;
    for (i = 0; i < 20; i++) {
        T v[9] = { -1, (T)-0.5, 0, 1, (T)-0.75, 0, (T)0.25, 1, 0 }, p[3] = { (T)0.5, (T)0.25, 0 }, c[144],
          d[144], g[432], e[432], omega = 0;
        double lo = 0.1, hi = 1e5;
        for (k = 0; k < 200 && hi / lo > 1 + 4 * (double)EPS; k++) {
            const double mid = sqrt(lo * hi);
            p[2] = (T)mid;
            p[0] = (T)(0.5 + i * mid / 10);
            F(sh_polygon_solid_angle)(SH_BOTH, p, 3, v, &omega, NULL);
            if ((double)omega > limit) lo = mid;
            else hi = mid;
        }
        p[2] = (T)(lo * (1 - 8 * (double)EPS));
        F(sh_polygon)(12, SH_BOTH, p, 3, v, c, g);
        p[2] = (T)(hi * (1 + 8 * (double)EPS));
        F(sh_polygon)(12, SH_BOTH, p, 3, v, d, e);
        row_case("slant %d", i);
        for (k = 0; k < 144; k++)
            row_check(w, (long double)d[k], (long double)c[k],
                      (128 + 64 * ref_G(ref_band(k)) / ref_M(ref_band(k))) * (long double)EPS
                          * ref_M(ref_band(k)) * (long double)limit,
                      k);
    }
    row_close(w);
}

/* Polygons whose fan has triangles without area, or thin ones, and points whose foot is on the line through two of their
 * vertices: the sum of the pieces that they are made of, none of which is thin. */
static void F(feet)(void **state)
{
    static const struct { int count, pieces; double xy[20], piece[36]; } shapes[] = {
        { 4, 1, { 0, 0, 1, 1, 2, 2, 2, 0 }, { 0, 0, 2, 2, 2, 0 } },                             /* the middle of an edge */
        { 5, 1, { 0, 0, 0, -3, 3, 0, 2, 0, 1, 0 }, { 0, 0, 0, -3, 3, 0 } },                     /* more of them */
        { 7, 1, { 0, -2, 2, 0, 0, -1, 0, -1, 0, 0, 0, 0, 0, -1 }, { 0, -2, 2, 0, 0, -1 } },     /* there and back */
        { 10, 4, { 0, 0, 3, 0, 3, 3, 0, 3, 0, 0, 1, 1, 1, 2, 2, 2, 2, 1, 1, 1 },                /* a frame, by a bridge */
          { 0, 0, 3, 0, 3, 3, 0, 0, 3, 3, 0, 3, 1, 1, 1, 2, 2, 2, 1, 1, 2, 2, 2, 1 } },
        { 8, 6, { 0, 3, 0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3 },                             /* U */
          { 0, 0, 1, 0, 1, 3, 0, 0, 1, 3, 0, 3, 1, 0, 2, 0, 2, 1, 1, 0, 2, 1, 1, 1, 2, 0, 3, 0, 3, 3, 2, 0, 3, 3, 2, 3 } },
        { 4, 1, { 0, 0, 3, 3, 3, 1, 1.5, 0.5 }, { 0, 0, 3, 3, 3, 1 } }
    };
    row *w = row_open("sums of pieces, foot on a line", PRECISION);
    int turn, i, k, side;
    (void)state;
    for (turn = 0; turn < effort(6000); turn++) {
        const int shape = turn % 6, count = shapes[shape].count, pieces = shapes[shape].pieces, axis = turn / 6 % 3;
        const int from = (int)ref_between(0, count - 0.01), a = (int)ref_between(0, count - 0.01), b = (int)ref_between(0, count - 0.01);
        const double along = ref_between(-0.5, 1.5), height = (turn & 1 ? -1 : 1) * ref_log_between(1e-15, 1e-1);
        const double *const xy = shapes[shape].xy;
        const int x = axis, y = (axis + 1) % 3, z = (axis + 2) % 3;
        double pd[3], vd[30], one[4], fan, size;
        long double want[4] = { 0, 0, 0, 0 };
        T p[3], v[30], c[4];
        p[x] = (T)(xy[2 * a] + along * (xy[2 * b] - xy[2 * a]));
        p[y] = (T)(xy[2 * a + 1] + along * (xy[2 * b + 1] - xy[2 * a + 1]));
        p[z] = (T)height;
        for (i = 0; i < count; i++) {
            v[3 * i + x] = (T)xy[2 * ((i + from) % count)];
            v[3 * i + y] = (T)xy[2 * ((i + from) % count) + 1];
            v[3 * i + z] = 0;
        }
        for (k = 0; k < 3; k++) pd[k] = (double)p[k];
        for (k = 0; k < 3 * count; k++) vd[k] = (double)v[k];
        (void)shi_polygon_engine(1, SH_SIGNED, 1, pd, (size_t)count, vd, 0, one, NULL, &fan);
        for (i = 0; i < pieces; i++) {
            for (k = 0; k < 3; k++) {
                vd[3 * k + x] = shapes[shape].piece[6 * i + 2 * k];
                vd[3 * k + y] = shapes[shape].piece[6 * i + 2 * k + 1];
                vd[3 * k + z] = 0;
            }
            (void)shi_polygon_engine(2, SH_SIGNED, 1, pd, 3, vd, 0, one, NULL, &size);
            for (k = 0; k < 4; k++) want[k] += (long double)one[k];
            if (fan < size) fan = size;
        }
        row_case("shape %d from %d, line %d %d at %g, height %g", shape, from, a, b, along, height);
        for (side = SH_BOTH; side <= SH_SIGNED; side++) {
            const int front = want[0] > 0;
            const long double sign = side == SH_SIGNED || front ? 1 : side == SH_FRONT ? 0 : -1;
            assert_int_equal(F(sh_polygon)(2, side, p, (size_t)count, v, c, NULL), SH_OK);
            for (k = 0; k < 4; k++) row_check(w, (long double)c[k], sign * want[k], 1000 * (long double)EPS * ref_M(k > 0) * (long double)fan, k);
        }
    }
    row_close(w);
}

/* the published alternative, the closed form in the edge's frame, agrees */
static void F(edge_frame)(void **state)
{
    row *w = row_open("sh_polygon = closed form in edge frames", PRECISION),
        *gw = row_open("... gradient", PRECISION);
    int i, k;
    (void)state;
    for (i = 0; i < effort(10); i++) {
        static long double c[81], g[243];
        scene_of s;
        T p[3], v[24], got[81], slope[243];
        long double omega;
        make_scene(&s, i % 4, ref_log_between(0.2, 3), ref_between(0.1, 1), 1);
        for (k = 0; k < 3; k++) p[k] = (T)s.point[k];
        for (k = 0; k < 3 * s.count; k++) v[k] = (T)s.v[k];
        assert_int_equal(F(sh_polygon)(9, SH_SIGNED, p, (size_t)s.count, v, got, slope), SH_OK);
        edge_frames(9, s.point, s.count, s.v, c, g);
        omega = fabsl((long double)got[0]) * sqrtl(4 * REF_PI);
        row_case("%s, solid angle %.2g", s.name, (double)omega);
        for (k = 1; k < 81; k++)
            row_check(w, -(long double)got[k], c[k], 64 * (long double)EPS * ref_M(ref_band(k)) * omega, k);
        for (k = 0; k < 243; k++)
            row_check(gw, -(long double)slope[k], g[k],
                      64 * (long double)EPS * (ref_M(ref_band(k % 81)) + ref_G(ref_band(k % 81)))
                          * (omega + fabsl((long double)slope[0]) + fabsl((long double)slope[81])
                             + fabsl((long double)slope[162])),
                      k);
    }
    row_close(w);
    row_close(gw);
}

#endif
