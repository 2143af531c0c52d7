/* sh_gradient.h, the lights: caps, zonal lights, spheres, sums of spheres, grids, sampled light fields. */
#ifndef T
#include "sh_gradient.h"
#include "report.h"
#include "ref.h"

enum { MAX = SH_MAX_BANDS * SH_MAX_BANDS };
static ref_jet jets[REF_MAX];
static long double want[10 * MAX], bound[10 * MAX];

static long double y_bound(int l) { return (4 + l * (l + 1) / 4.0L) * ref_M(l); }
static long double grad_bound(int l) { return (8 + l * (l + 1) / 4.0L) * ref_G(l); }
static long double hess_bound(int l) { return (16 + l * (l + 1) / 2.0L) * l * (l + 1) * ref_M(l); }

/* What the bounds of a sphere light are made of, at sin of the half-angle s and distance rho. */
typedef struct { long double omega, slope, curvature, steep, rho; } cap_scale;

static cap_scale scale_of(long double radius, long double rho)
{
    const long double s = radius / rho, alpha = sqrtl((rho - radius) * (rho + radius)) / rho;
    const long double q = s * s / (alpha * rho);
    cap_scale c;
    c.omega = 2 * REF_PI * s * s / (1 + alpha);
    c.slope = 2 * REF_PI * q;
    c.curvature = 2 * REF_PI * (3 * q / rho + q * q / alpha);
    c.steep = s > 0.995L ? 1 / (alpha * alpha) : 1;
    c.rho = rho;
    return c;
}

static long double sphere_bound(int plane, int l, cap_scale c)
{
    const long double f[3] = { 24 * ref_M(l) * c.omega,
                               32 * (ref_M(l) * c.slope + ref_G(l) * c.omega / c.rho),
                               64 * (ref_M(l) * (c.curvature + c.slope / c.rho) + 2 * ref_G(l) * c.slope / c.rho)
                                   + (16 + l * (l + 1) / 2.0L) * l * (l + 1) * ref_M(l) * c.omega / (c.rho * c.rho) };
    return f[plane == 0 ? 0 : plane < 4 ? 1 : 2] * c.steep;
}

static long double jet_plane(const ref_jet *a, int plane)
{
    return plane == 0 ? a->v : plane < 4 ? a->g[plane - 1] : a->h[plane - 4];
}

static long double distance(const long double a[3], const long double b[3])
{
    return sqrtl((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

#define BOTH "test_gradient_lights.c"
#include "both.h"

int main(void)
{
    const struct CMUnitTest tests[] = {
        BOTH_TESTS(cap), BOTH_TESTS(zonal_rotate), BOTH_TESTS(zonal_light), BOTH_TESTS(sphere), BOTH_TESTS(close_sphere),
        BOTH_TESTS(sums), BOTH_TESTS(sums_are_sums), BOTH_TESTS(points_and_grids), BOTH_TESTS(turned_scene),
        BOTH_TESTS(crowd), BOTH_TESTS(light_field), BOTH_TESTS(light_field_converges),
    };
    return RUN_TESTS(tests);
}
#else

static void F(cap)(void **state)
{
    row *w[2], *wd[2];
    T zh[SH_MAX_BANDS], dzh[SH_MAX_BANDS];
    const ref_jet up[3] = { ref_const(0), ref_const(0), ref_const(1) };
    int bands, turn, l;
    (void)state;
    w[0] = row_open("sh_zonal_cap, l <= 8", PRECISION);
    w[1] = row_open("sh_zonal_cap, l > 8", PRECISION);
    wd[0] = row_open("sh_zonal_cap d/d(half-angle), l <= 8", PRECISION);
    wd[1] = row_open("sh_zonal_cap d/d(half-angle), l > 8", PRECISION);
    for (bands = 1; bands <= SH_MAX_BANDS; bands++)
        for (turn = 0; turn < effort(30); turn++) {
            const T s = (T)(turn == 0 ? 1 : turn == 1 ? 1e-6 : turn == 2 ? 0.9999 : ref_log_between(1e-6, 1));
            const long double cosine = sqrtl((1 - (long double)s) * (1 + (long double)s));
            ref_jet t = ref_const((long double)s * s / (1 + cosine));       /* 1 - cos, by the angle */
            t.g[0] = s;
            t.h[0] = cosine;
            ref_cap(bands, up, t, jets);
            assert_int_equal(F(sh_zonal_cap)(bands, s, zh, dzh), SH_OK);
            row_case("bands %d sin %.9g", bands, (double)s);
            for (l = 0; l < bands; l++) {
                const ref_jet c = jets[l * (l + 1)];
                row_check(w[l > 8], zh[l], c.v, 24 * (long double)EPS * ref_M(l) * 2 * REF_PI * t.v, l);
                row_check(wd[l > 8], dzh[l], c.g[0], 32 * (long double)EPS * ref_M(l) * 2 * REF_PI * s, l);
            }
        }
    for (l = 0; l < 2; l++) { row_close(w[l]); row_close(wd[l]); }
}

static void F(zonal_rotate)(void **state)
{
    row *w = row_open("sh_zonal_rotate", PRECISION);
    T zh[SH_MAX_BANDS];
    static T c[MAX];
    static long double y[REF_MAX];
    int turn, i, k;
    (void)state;
    for (turn = 0; turn < effort(400); turn++) {
        const int bands = 1 + turn % SH_MAX_BANDS;
        double u[3];
        T v[3];
        long double p[3];
        ref_unit(u);
        for (k = 0; k < 3; k++) p[k] = v[k] = (T)u[k];
        for (i = 0; i < bands; i++) zh[i] = (T)ref_between(-1, 1);
        ref_values(bands, p, y);
        assert_int_equal(F(sh_zonal_rotate)(bands, zh, v, c), SH_OK);
        row_case("bands %d dir %.9g %.9g %.9g", bands, (double)v[0], (double)v[1], (double)v[2]);
        for (i = 0; i < bands * bands; i++) {
            const int l = ref_band(i);
            const long double a = zh[l] / ref_M(l);
            row_check(w, c[i], a * y[i], (long double)EPS * fabsl(a) * y_bound(l), i);
        }
    }
    row_close(w);
}

/* Any f(rho): zh and its derivatives are free numbers here, so nothing of the cap can hide in the answer. */
static void F(zonal_light)(void **state)
{
    row *w[3];
    T f[3][SH_MAX_BANDS];
    static T c[MAX], g[3 * MAX], h[6 * MAX];
    int turn, i, k, l, m;
    (void)state;
    w[0] = row_open("sh_zonal_light values", PRECISION);
    w[1] = row_open("sh_zonal_light gradient", PRECISION);
    w[2] = row_open("sh_zonal_light Hessian", PRECISION);
    for (turn = 0; turn < effort(400); turn++) {
        const int bands = 1 + turn % SH_MAX_BANDS, n2 = bands * bands;
        const double size = ref_log_between(1e-6, 1e6);
        double u[3];
        T v[3];
        ref_jet p[3], r2 = ref_const(0), rho, y[1];
        ref_unit(u);
        for (k = 0; k < 3; k++) {
            v[k] = (T)(size * u[k]);
            p[k] = ref_sub(ref_const(v[k]), ref_var(0, k));          /* the point moves, the light stays */
            r2 = ref_add(r2, ref_mul(p[k], p[k]));
        }
        rho = ref_sqrt(r2);
        ref_basis(bands, p, jets);
        for (k = 0; k < 3; k++)
            for (l = 0; l < bands; l++) f[k][l] = (T)(ref_between(-1, 1) / pow(size, k));
        assert_int_equal(F(sh_zonal_light)(bands, v, f[0], f[1], f[2], c, g, h), SH_OK);
        row_case("bands %d to_light %.9g %.9g %.9g", bands, (double)v[0], (double)v[1], (double)v[2]);
        for (l = 0; l < bands; l++)
            for (m = -l; m <= l; m++) {
                const long double f0 = fabsl((long double)f[0][l]) / ref_M(l), f1 = fabsl((long double)f[1][l]) / ref_M(l);
                const long double f2 = fabsl((long double)f[2][l]) / ref_M(l), d = rho.v;
                i = l * (l + 1) + m;
                y[0] = ref_mul(ref_chain(rho, f[0][l], f[1][l], f[2][l]), ref_scale(1 / ref_M(l), jets[i]));
                row_check(w[0], c[i], y->v, (long double)EPS * f0 * y_bound(l), i);
                for (k = 0; k < 3; k++)
                    row_check(w[1], g[k * n2 + i], y->g[k],
                              (long double)EPS * (f1 * y_bound(l) + f0 * grad_bound(l) / d), i);
                for (k = 0; k < 6; k++)
                    row_check(w[2], h[k * n2 + i], y->h[k], (long double)EPS * (f2 * y_bound(l) + f1 * y_bound(l) / d
                              + 2 * f1 * grad_bound(l) / d + f0 * hess_bound(l) / (d * d)), i);
            }
    }
    for (k = 0; k < 3; k++) row_close(w[k]);
}

/* A light of size/distance s in direction u, at any scale and place; returns the exact distance. */
static long double F(random_sphere)(double s, double size, T point[3], T center[3], T *radius,
                                    long double p[3], long double c[3])
{
    const int at_origin = ref_random() < 0.3;
    double u[3], d2 = 0;
    int k;
    ref_unit(u);
    for (k = 0; k < 3; k++) {
        point[k] = at_origin ? 0 : (T)(size * ref_between(-1, 1));
        center[k] = (T)((double)point[k] + size * u[k]);
        p[k] = point[k];
        c[k] = center[k];
        d2 += (double)((c[k] - p[k]) * (c[k] - p[k]));
    }
    *radius = (T)(s * sqrt(d2));
    return distance(p, c);
}

static void F(sphere)(void **state)
{
    row *w[6];
    static T c[MAX], g[3 * MAX], h[6 * MAX], c1[MAX], g1[3 * MAX];
    static const double ratios[] = { 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999, 0.9999 };
    int bands, turn, i, k;
    (void)state;
    for (k = 0; k < 2; k++) {
        w[3 * k + 0] = row_open(k ? "sh_sphere values, l > 8" : "sh_sphere values, l <= 8", PRECISION);
        w[3 * k + 1] = row_open(k ? "sh_sphere gradient, l > 8" : "sh_sphere gradient, l <= 8", PRECISION);
        w[3 * k + 2] = row_open(k ? "sh_sphere_hessian Hessian, l > 8" : "sh_sphere_hessian Hessian, l <= 8", PRECISION);
    }
    for (bands = 1; bands <= SH_MAX_BANDS; bands++)
        for (turn = 0; turn < effort(bands <= 12 ? 52 : 13); turn++) {
            const int n2 = bands * bands;
            const double s = turn < 26 ? ratios[turn % 13] : ref_log_between(1e-6, 0.9999);
            const double size = turn % 2 ? 1 : ref_log_between(1e-6, 1e6);
            T point[3], center[3], radius;
            long double p[3], q[3], rho;
            cap_scale scale;
            rho = F(random_sphere)(s, size, point, center, &radius, p, q);
            if (!(radius < rho)) continue;
            ref_sphere(bands, p, q, radius, jets);
            scale = scale_of(radius, rho);
            assert_int_equal(F(sh_sphere_hessian)(bands, point, center, radius, c, g, h), SH_OK);
            assert_int_equal(F(sh_sphere)(bands, point, center, radius, c1, g1), SH_OK);
            row_case("bands %d r/d %.6g d %.3g u %.6Lg %.6Lg %.6Lg", bands, s, (double)rho, (q[0] - p[0]) / rho,
                     (q[1] - p[1]) / rho, (q[2] - p[2]) / rho);
            for (i = 0; i < n2; i++) {
                const int l = ref_band(i);
                row_check(w[i < 81 ? 0 : 3], c[i], jets[i].v, (long double)EPS * sphere_bound(0, l, scale), i);
                row_check(w[i < 81 ? 0 : 3], c1[i], jets[i].v, (long double)EPS * sphere_bound(0, l, scale), i);
                for (k = 0; k < 3; k++) {
                    row_check(w[i < 81 ? 1 : 4], g[k * n2 + i], jets[i].g[k], (long double)EPS * sphere_bound(1, l, scale), i);
                    row_check(w[i < 81 ? 1 : 4], g1[k * n2 + i], jets[i].g[k], (long double)EPS * sphere_bound(1, l, scale), i);
                }
                for (k = 0; k < 6; k++)
                    row_check(w[i < 81 ? 2 : 5], h[k * n2 + i], jets[i].h[k], (long double)EPS * sphere_bound(4, l, scale), i);
            }
            assert_int_equal(F(sh_sphere)(bands, point, center, radius, c, NULL), SH_OK);
            for (i = 0; i < n2; i++)
                row_check(w[i < 81 ? 0 : 3], c[i], jets[i].v, (long double)EPS * sphere_bound(0, ref_band(i), scale), i);
        }
    for (k = 0; k < 6; k++) row_close(w[k]);
    w[0] = row_open("sh_sphere, worst lights known / stated", PRECISION);
    for (turn = 0; turn < 2; turn++) {                      /* found by climbing, for float and 32 bands */
        static const float found[2][4] = { { -0.0719443113f, -1.31885028f, -0.010741285f, 0.000322446664f },
                                           { -0.000105554922f, 0.528029501f, 0.00137302245f, 0.000128581756f } };
        const long double stated = IS_F32 ? 1.1L : 1;
        T point[3] = { 0, 0, 0 }, center[3];
        long double p[3] = { 0, 0, 0 }, q[3], rho = 0;
        cap_scale scale;
        for (k = 0; k < 3; k++) {
            center[k] = (T)found[turn][k];
            q[k] = (long double)center[k];
            rho += q[k] * q[k];
        }
        ref_sphere(SH_MAX_BANDS, p, q, (long double)found[turn][3], jets);
        scale = scale_of((long double)found[turn][3], sqrtl(rho));
        assert_int_equal(F(sh_sphere)(SH_MAX_BANDS, point, center, (T)found[turn][3], c, NULL), SH_OK);
        row_case("light %d", turn);
        for (i = 0; i < MAX; i++)
            row_check(w[0], c[i], jets[i].v, stated * (long double)EPS * sphere_bound(0, ref_band(i), scale), i);
    }
    row_close(w[0]);
}

/* A scene: spheres [4][count] and radiance [channels][count]; also what the sum should be, and its bound
 * as sh_spheres_n documents it. */
static void F(scene)(int bands, int planes, int channels, const T point[3], size_t count, T *spheres, T *radiance,
                     double far_scale)
{
    const long double p[3] = { point[0], point[1], point[2] };
    size_t j;
    int ch, pl, i, n2 = bands * bands;
    memset(want, 0, sizeof want);
    memset(bound, 0, sizeof bound);
    (void)channels;
    for (j = 0; j < count; j++) {
        long double c[3], rho;
        double u[3], d = far_scale * ref_between(0.5, 3);
        int k;
        ref_unit(u);
        for (k = 0; k < 3; k++) {
            spheres[(size_t)k * count + j] = (T)((double)point[k] + d * u[k]);
            c[k] = spheres[(size_t)k * count + j];
        }
        rho = distance(p, c);
        spheres[3 * count + j] = (T)((double)rho * ref_log_between(1e-4, 0.98));
        for (ch = 0; ch < 4; ch++) radiance[(size_t)ch * count + j] = (T)ref_between(0, 2);
        ref_sphere(bands, p, c, spheres[3 * count + j], jets);
        for (pl = 0; pl < planes; pl++)
            for (i = 0; i < n2; i++) {
                want[pl * n2 + i] += radiance[j] * jet_plane(&jets[i], pl);
                bound[pl * n2 + i] += fabsl((long double)radiance[j]) * (long double)EPS
                                      * (1 + (long double)count / 64 / (pl ? 32 : 24))
                                      * sphere_bound(pl, ref_band(i), scale_of(spheres[3 * count + j], rho));
            }
    }
}

static void F(sums)(void **state)
{
    enum { MANY = 648 };
    static T spheres[4 * MANY], radiance[4 * MANY], out[4 * 10 * MAX + 1];
    static const size_t counts[] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 16, 17, 31, 37 };
    static const int planes[] = { 1, 4, 10 };
    static const char *const names[] = { "sh_spheres values, l <= 8", "sh_spheres gradient, l <= 8", "sh_spheres Hessian, l <= 8",
        "sh_spheres values, l > 8", "sh_spheres gradient, l > 8", "sh_spheres Hessian, l > 8" };
    const T guard = (T)12345;
    int bands, turn, i, pl, ch;
    row *w[6];
    (void)state;
    for (i = 0; i < 6; i++) w[i] = row_open(names[i], PRECISION);
    for (bands = 1; bands <= SH_MAX_BANDS; bands += bands < 12 ? 1 : 5)
        for (turn = 0; turn < 48; turn++) {
            const int n2 = bands * bands, np = planes[turn % 3], channels = 1 + turn / 3 % 4;
            const size_t count = turn == 47 && bands <= 9 ? MANY : counts[turn % 15], block = (size_t)(np * n2);
            const T point[3] = { (T)ref_between(-2, 2), (T)ref_between(-2, 2), (T)ref_between(-2, 2) };
            F(scene)(bands, np, channels, point, count, spheres, radiance, turn % 5 == 4 ? 1e4 : 1);
            if (count) memcpy(radiance + (size_t)(channels - 1) * count, radiance, count * sizeof(T));
            out[(size_t)channels * block] = guard;
            assert_int_equal(F(sh_spheres)(bands, np, channels, point, count, spheres, radiance, out), SH_OK);
            assert_true(out[(size_t)channels * block] == guard);
            row_case("bands %d planes %d channels %d count %d", bands, np, channels, (int)count);
            /* the first and the last channel have the radiance that the sum was made with */
            for (ch = 0; ch < channels; ch += channels > 1 ? channels - 1 : 1)
                for (pl = 0; pl < np; pl++)
                    for (i = 0; i < n2; i++)
                        row_check(w[(pl == 0 ? 0 : pl < 4 ? 1 : 2) + (i < 81 ? 0 : 3)], out[(size_t)ch * block + (size_t)(pl * n2 + i)],
                                  want[pl * n2 + i], bound[pl * n2 + i], i);
        }
    for (i = 0; i < 6; i++) row_close(w[i]);
}

/* The moment form against the sum of single lights of the library itself; and radiance NULL is radiance 1. */
static void F(sums_are_sums)(void **state)
{
    enum { COUNT = 37 };
    row *w = row_open("sh_spheres = sum of sh_sphere_hessian", PRECISION);
    static T spheres[4 * COUNT], radiance[4 * COUNT], out[10 * MAX], ones[10 * MAX], c[MAX], g[3 * MAX], h[6 * MAX];
    static long double sum[10 * MAX];
    const T point[3] = { (T)0.25, (T)-0.5, (T)1.25 };
    size_t j;
    int bands, i, pl;
    (void)state;
    for (bands = 1; bands <= 16; bands++) {
        const int n2 = bands * bands;
        F(scene)(bands, 10, 1, point, COUNT, spheres, radiance, 1);
        memset(sum, 0, sizeof sum);
        for (j = 0; j < COUNT; j++) {
            const T center[3] = { spheres[j], spheres[COUNT + j], spheres[2 * COUNT + j] };
            assert_int_equal(F(sh_sphere_hessian)(bands, point, center, spheres[3 * COUNT + j], c, g, h), SH_OK);
            for (pl = 0; pl < 10; pl++)
                for (i = 0; i < n2; i++)
                    sum[pl * n2 + i] += radiance[j] * (pl == 0 ? c[i] : pl < 4 ? g[(pl - 1) * n2 + i] : h[(pl - 4) * n2 + i]);
        }
        assert_int_equal(F(sh_spheres)(bands, 10, 1, point, COUNT, spheres, radiance, out), SH_OK);
        row_case("bands %d", bands);
        for (i = 0; i < 10 * n2; i++) row_check(w, out[i], sum[i], 2 * bound[i], i);
        for (j = 0; j < COUNT; j++) radiance[j] = 1;
        assert_int_equal(F(sh_spheres)(bands, 10, 1, point, COUNT, spheres, radiance, out), SH_OK);
        assert_int_equal(F(sh_spheres)(bands, 10, 1, point, COUNT, spheres, NULL, ones), SH_OK);
        assert_memory_equal(out, ones, (size_t)(10 * n2) * sizeof(T));
    }
    row_close(w);
}

/* Points and nodes give the bits of the single call; a grid cut into ranges gives the bits of the whole. */
static void F(points_and_grids)(void **state)
{
    enum { COUNT = 13, NX = 3, NY = 2, NZ = 4, NODES = NX * NY * NZ, CHANNELS = 2 };
    static T spheres[4 * COUNT], radiance[4 * COUNT], one[CHANNELS * 10 * 81], points[3 * NODES];
    static T all[NODES * CHANNELS * 10 * 81 + 1], part[NODES * CHANNELS * 10 * 81];
    static const int planes[] = { 1, 4, 10 };
    F(sh_grid) grid;
    const T zero[3] = { 0, 0, 0 };
    const T guard = (T)12345;
    int bands, turn, i, status, inside;
    size_t n, cut;
    (void)state;
    grid.count[0] = NX; grid.count[1] = NY; grid.count[2] = NZ;
    for (i = 0; i < 3; i++) {          /* multiples of 1/8: the nodes are exact in any order of operations */
        grid.origin[i] = (T)(-0.25 * i - 0.125);
        grid.cell[i] = (T)(0.125 + 0.25 * i);
    }
    for (n = 0; n < NODES; n++) {
        points[3 * n + 0] = grid.origin[0] + grid.cell[0] * (T)(n % NX);
        points[3 * n + 1] = grid.origin[1] + grid.cell[1] * (T)(n / NX % NY);
        points[3 * n + 2] = grid.origin[2] + grid.cell[2] * (T)(n / NX / NY);
    }
    for (bands = 1; bands <= 9; bands += 2)
        for (turn = 0; turn < 3; turn++) {
            const int np = planes[turn];
            const size_t block = (size_t)(CHANNELS * np * bands * bands);
            F(scene)(bands, 1, CHANNELS, zero, COUNT, spheres, radiance, 3);
            all[NODES * block] = guard;
            status = F(sh_spheres_n)(bands, np, CHANNELS, NODES, points, COUNT, spheres, radiance, all);
            assert_true(all[NODES * block] == guard);
            for (n = 0, inside = SH_OK; n < NODES; n++) {                  /* some of the nodes are in a light */
                const int s = F(sh_spheres)(bands, np, CHANNELS, points + 3 * n, COUNT, spheres, radiance, one);
                assert_true(s == SH_OK || s == SH_INSIDE);
                if (s) inside = s;
                assert_memory_equal(one, all + n * block, block * sizeof(T));
            }
            assert_int_equal(status, inside);
            assert_int_equal(F(sh_spheres_grid)(bands, np, CHANNELS, &grid, 0, NODES, COUNT, spheres, radiance, part), inside);
            assert_memory_equal(part, all, NODES * block * sizeof(T));
            for (cut = 0; cut <= NODES; cut += 5) {
                memset(part, 0, sizeof part);
                const int a = F(sh_spheres_grid)(bands, np, CHANNELS, &grid, 0, cut, COUNT, spheres, radiance, part);
                const int b = F(sh_spheres_grid)(bands, np, CHANNELS, &grid, cut, NODES - cut, COUNT, spheres,
                                                 radiance, part + cut * block);
                assert_int_equal(a | b, inside);
                assert_memory_equal(part, all, NODES * block * sizeof(T));
            }
        }
}

/* Turn lights and point together: the light arriving from a turned direction stays, the gradient turns with it. */
static void F(turned_scene)(void **state)
{
    enum { BANDS = 12, COUNT = 9 };
    row *w = row_open("sh_spheres, scene turned", PRECISION), *wg = row_open("sh_spheres gradient, scene turned", PRECISION);
    static T spheres[4 * COUNT], turned[4 * COUNT], radiance[4 * COUNT];
    static T a[4 * BANDS * BANDS], b[4 * BANDS * BANDS];
    static long double ya[REF_MAX], yb[REF_MAX];
    int turn, i, k, m;
    size_t j;
    (void)state;
    for (turn = 0; turn < effort(40); turn++) {
        const T point[3] = { 0, 0, 0 };
        long double r[3][3], q[4], n = 0, da[3], db[3], va = 0, vb = 0, ga[3] = { 0, 0, 0 }, gb[3] = { 0, 0, 0 };
        long double limit = 0, limit_g = 0;
        double u[3];
        for (k = 0; k < 4; k++) { q[k] = ref_between(-1, 1); n += q[k] * q[k]; }
        for (k = 0; k < 4; k++) q[k] /= sqrtl(n);
        for (i = 0; i < 3; i++)
            for (k = 0; k < 3; k++) {
                const int o = 3 - i - k;
                r[i][k] = i == k ? 1 - 2 * (q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - q[1 + i] * q[1 + i])
                                 : 2 * (q[1 + i] * q[1 + k] + ((k + 1) % 3 == i ? 1 : -1) * q[0] * q[1 + o]);
            }
        F(scene)(BANDS, 4, 1, point, COUNT, spheres, radiance, 1);
        for (j = 0; j < COUNT; j++) {
            for (i = 0; i < 3; i++) {
                long double s = 0;
                for (k = 0; k < 3; k++) s += r[i][k] * spheres[(size_t)k * COUNT + j];
                turned[(size_t)i * COUNT + j] = (T)s;
            }
            turned[3 * COUNT + j] = spheres[3 * COUNT + j];
        }
        ref_unit(u);
        for (i = 0; i < 3; i++) {
            da[i] = u[i];
            db[i] = r[i][0] * u[0] + r[i][1] * u[1] + r[i][2] * u[2];
        }
        ref_values(BANDS, da, ya);
        ref_values(BANDS, db, yb);
        assert_int_equal(F(sh_spheres)(BANDS, 4, 1, point, COUNT, spheres, radiance, a), SH_OK);
        assert_int_equal(F(sh_spheres)(BANDS, 4, 1, point, COUNT, turned, radiance, b), SH_OK);
        for (m = 0; m < BANDS * BANDS; m++) {
            va += a[m] * ya[m];
            vb += b[m] * yb[m];
            for (k = 0; k < 3; k++) {
                ga[k] += a[(k + 1) * BANDS * BANDS + m] * ya[m];
                gb[k] += b[(k + 1) * BANDS * BANDS + m] * yb[m];
            }
            limit += 2 * bound[m] * ref_M(ref_band(m));
            limit_g += 2 * sqrtl(3) * bound[BANDS * BANDS + m] * ref_M(ref_band(m));
        }
        row_case("turn %d", turn);
        row_check(w, vb, va, limit, 0);
        for (i = 0; i < 3; i++)
            row_check(wg, gb[i], r[i][0] * ga[0] + r[i][1] * ga[1] + r[i][2] * ga[2], limit_g, i);
    }
    row_close(w);
    row_close(wg);
}

/* One light 20000 times over: running sums would drift with their number. */
static void F(crowd)(void **state)
{
    enum { COUNT = 20000, BANDS = 4, N = BANDS * BANDS };
    row *w = row_open("sh_spheres, 20000 lights", PRECISION);
    static T spheres[4 * COUNT];
    static const T origin[3] = { 0, 0, 0 }, center[3] = { (T)1.1, (T)0.7, (T)-1.3 };
    T one[N], slopes[3 * N], sum[4 * N];
    int i, k;
    (void)state;
    for (i = 0; i < COUNT; i++) {
        for (k = 0; k < 3; k++) spheres[k * COUNT + i] = center[k];
        spheres[3 * COUNT + i] = (T)0.3;
    }
    assert_int_equal(F(sh_sphere)(BANDS, origin, center, (T)0.3, one, slopes), SH_OK);
    assert_int_equal(F(sh_spheres)(BANDS, SH_GRADIENT, 1, origin, COUNT, spheres, NULL, sum), SH_OK);
    for (i = 0; i < 4 * N; i++) {
        const int l = ref_band(i % N);
        const long double size = COUNT * one[0] / ref_M(0), x = i < N ? one[i] : slopes[i - N];
        row_check(w, sum[i], COUNT * x,
                  (2 * 32 + 64 + COUNT / 256) * (long double)EPS * size * (ref_M(l) + (i < N ? 0 : ref_G(l))), i);
    }
    row_close(w);
}

/* Each texel is a small piece of surface dA = dw r^2/|n.w| that stays where it is while the point moves: the jet of
 * I Y(p/|p|) |n.p|/|p|^3 dA gives its value and gradient. */
static void F(light_field)(void **state)
{
    enum { COUNT = 37 };
    row *w = row_open("sh_light_field values", PRECISION), *wg = row_open("sh_light_field gradient", PRECISION);
    static T dirs[3 * COUNT], area[COUNT], radiance[COUNT], depth[COUNT], normals[3 * COUNT], c[MAX], g[3 * MAX];
    int turn, i, k;
    size_t j;
    (void)state;
    for (turn = 0; turn < effort(60); turn++) {
        const int bands = 1 + turn % (turn % 3 ? 9 : SH_MAX_BANDS), n2 = bands * bands;
        const size_t count = (size_t)(turn * 5 % (COUNT + 1));
        memset(want, 0, sizeof want);
        memset(bound, 0, sizeof bound);
        for (j = 0; j < count; j++) {
            ref_jet p[3], dot = ref_const(0), r2 = ref_const(0), weight;
            const double tiny = IS_F32 ? 1e-30 : 1e-200, length = j % 3 == 0 ? 1 : j % 3 == 1 ? tiny : 1 / tiny;
            double u[3], n[3], cosine = 0;
            ref_unit(u);
            do {
                ref_unit(n);
                cosine = n[0] * u[0] + n[1] * u[1] + n[2] * u[2];
            } while (fabs(cosine) < 0.2);
            area[j] = (T)ref_between(0.001, 0.1);
            radiance[j] = (T)ref_between(0, 3);
            depth[j] = (T)ref_log_between(0.1, 10);
            for (k = 0; k < 3; k++) {
                dirs[3 * j + (size_t)k] = (T)u[k];
                normals[3 * j + (size_t)k] = (T)(n[k] * length);
                p[k] = ref_sub(ref_const((long double)depth[j] * dirs[3 * j + (size_t)k]), ref_var(0, k));
                dot = ref_add(dot, ref_scale(normals[3 * j + (size_t)k], p[k]));
                r2 = ref_add(r2, ref_mul(p[k], p[k]));
            }
            weight = ref_div(dot, ref_mul(r2, ref_sqrt(r2)));
            weight = ref_scale(area[j] * radiance[j] / weight.v, weight);
            ref_basis(bands, p, jets);
            for (i = 0; i < n2; i++) {
                const int l = ref_band(i);
                const long double e = (long double)EPS * area[j] * radiance[j];
                const ref_jet t = ref_mul(weight, jets[i]);
                want[i] += t.v;
                bound[i] += e * y_bound(l);
                for (k = 0; k < 3; k++) {
                    want[(k + 1) * n2 + i] += t.g[k];
                    bound[(k + 1) * n2 + i] += e / depth[j] * (grad_bound(l) + 8 * y_bound(l) / fabs(cosine));
                }
            }
        }
        assert_int_equal(F(sh_light_field)(bands, count, dirs, area, radiance, depth, normals, c, g), SH_OK);
        row_case("bands %d count %d", bands, (int)count);
        for (i = 0; i < n2; i++) {
            row_check(w, c[i], want[i], bound[i], i);
            for (k = 0; k < 3; k++) row_check(wg, g[k * n2 + i], want[(k + 1) * n2 + i], bound[(k + 1) * n2 + i], i);
        }
    }
    row_close(w);
    row_close(wg);
}

/* One wall of a cubic room seen from its middle, a planar emitter: halving the texels quarters the gradient's error. */
static void F(light_field_converges)(void **state)
{
    enum { BANDS = 5, FINE = 64, NODES = 48, N2 = BANDS * BANDS };
    row *w = row_open("sh_light_field, planar emitter, 64^2", PRECISION);
    static T dirs[3 * FINE * FINE], area[FINE * FINE], one[FINE * FINE], depth[FINE * FINE], normals[3 * FINE * FINE];
    T c[N2], g[3 * N2];
    long double x[NODES], weight[NODES], error[2], worst = 0;
    int round, i, k, a, b;
    (void)state;
    ref_gauss(NODES, x, weight);
    memset(want, 0, sizeof want);
    for (a = 0; a < NODES; a++)
        for (b = 0; b < NODES; b++) {
            ref_jet p[3], r2 = ref_const(0), t;
            const long double at[3] = { x[a], x[b], 1 };
            for (k = 0; k < 3; k++) {
                p[k] = ref_sub(ref_const(at[k]), ref_var(0, k));
                r2 = ref_add(r2, ref_mul(p[k], p[k]));
            }
            ref_basis(BANDS, p, jets);
            t = ref_scale(weight[a] * weight[b], ref_div(p[2], ref_mul(r2, ref_sqrt(r2))));
            for (i = 0; i < N2; i++) {
                const ref_jet v = ref_mul(t, jets[i]);
                for (k = 0; k < 3; k++) want[k * N2 + i] += v.g[k];
            }
        }
    for (i = 0; i < 3 * N2; i++) if (fabsl(want[i]) > worst) worst = fabsl(want[i]);
    for (round = 0; round < 2; round++) {
        const int size = round ? FINE : FINE / 2;
        for (a = 0; a < size; a++)
            for (b = 0; b < size; b++) {
                const int j = a * size + b;
                const double s = (a + 0.5) * 2 / size - 1, t = (b + 0.5) * 2 / size - 1, r = sqrt(s * s + t * t + 1);
                dirs[3 * j] = (T)(s / r);
                dirs[3 * j + 1] = (T)(t / r);
                dirs[3 * j + 2] = (T)(1 / r);
                area[j] = (T)(4.0 / size / size / (r * r * r));
                one[j] = 1;
                depth[j] = (T)r;
                normals[3 * j] = normals[3 * j + 1] = 0;
                normals[3 * j + 2] = -1;
            }
        assert_int_equal(F(sh_light_field)(BANDS, (size_t)(size * size), dirs, area, one, depth, normals, c, g), SH_OK);
        error[round] = 0;
        for (i = 0; i < 3 * N2; i++)
            if (!(fabsl(g[i] - want[i]) <= error[round])) error[round] = fabsl(g[i] - want[i]);
    }
    row_case("32^2: %.3Lg of the largest, 64^2: %.3Lg", error[0] / worst, error[1] / worst);
    row_check(w, error[1] / worst, 0, 3e-4L, 0);                       /* a second-order rule: 2.6e-4 at 64^2 */
    row_close(w);
    assert_true(error[1] < error[0] / 3.5L);
}

/* |y - x|^2 - r^2 decides the gradient of a light that nearly touches the point, whatever the compiler contracts. Band 0:
 * L = 2 pi Y_00 (1 - sqrt(1 - (r/d)^2)). */
static void F(close_sphere)(void **state)
{
    row *const w = row_open("sh_sphere gradient, r/d 0.98 to 0.995", PRECISION);
    int turn, k;
    (void)state;
    if (FAST_MATH && sizeof(T) == sizeof(double)) skip();
    for (turn = 0; turn < 2000; turn++) {
        T point[3], center[3], radius, c, g[3];
        long double u[3], dd = 0, d, far, slope;
        for (k = 0; k < 3; k++) {
            point[k] = (T)ref_between(-4, 4);
            center[k] = (T)((double)point[k] + ref_between(-1, 1));
            u[k] = (long double)point[k] - (long double)center[k];
            dd += u[k] * u[k];
        }
        d = sqrtl(dd);
        radius = (T)(ref_between(0.98, 0.995) * (double)d);
        far = (long double)radius * (long double)radius / dd;
        slope = -2 * 3.14159265358979323846264338327950288L * 0.28209479177387814347403972578038629L * far / (d * sqrtl(1 - far));
        assert_int_equal(F(sh_sphere)(1, point, center, radius, &c, g), SH_OK);
        row_case("point %.17g %.17g %.17g center %.17g %.17g %.17g radius %.17g", (double)point[0], (double)point[1],
                 (double)point[2], (double)center[0], (double)center[1], (double)center[2], (double)radius);
        for (k = 0; k < 3; k++) row_check(w, g[k], slope * u[k] / d, 8 * (long double)EPS * fabsl(slope), k);
    }
    row_close(w);
}
#endif
