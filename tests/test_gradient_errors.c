/* sh_gradient.h: every situation of the error policy - the status, what is written, and that the rest stays untouched.
 * Also compiled with -ffast-math by tests/matrix.sh: special numbers are made from bits, results looked at as bits. */
#ifndef T
#include "sh_gradient.h"
#include "report.h"

static float  bits_f32(uint32_t u) { float f; memcpy(&f, &u, sizeof f); return f; }
static double bits_f64(uint64_t u) { double f; memcpy(&f, &u, sizeof f); return f; }
static float  nan_f32(void) { return bits_f32(0x7fc00000u); }
static float  inf_f32(void) { return bits_f32(0x7f800000u); }
static double nan_f64(void) { return bits_f64(0x7ff8000000000000u); }
static double inf_f64(void) { return bits_f64(0x7ff0000000000000u); }
static int is_nan_f32(float f) { uint32_t u; memcpy(&u, &f, sizeof u); return (u & 0x7fffffffu) > 0x7f800000u; }
static int is_nan_f64(double f) { uint64_t u; memcpy(&u, &f, sizeof u); return (u & 0x7fffffffffffffffu) > 0x7ff0000000000000u; }

#define BOTH "test_gradient_errors.c"
#include "both.h"

static void status_strings(void **state)
{
    int s, t;
    (void)state;
    for (s = SH_ERROR_GRID; s <= SH_ON_LIGHT; s++) {
        assert_non_null(sh_status_string(s));
        assert_true(strlen(sh_status_string(s)) > 1 && !strchr(sh_status_string(s), ','));
        for (t = SH_ERROR_GRID; t < s; t++) assert_true(strcmp(sh_status_string(s), sh_status_string(t)) != 0);
    }
    assert_string_equal(sh_status_string(999), sh_status_string(-999));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(status_strings),
        BOTH_TESTS(structure), BOTH_TESTS(overlap), BOTH_TESTS(directions), BOTH_TESTS(batches_with_bad_items),
        BOTH_TESTS(angles), BOTH_TESTS(sums_over_directions), BOTH_TESTS(zonal), BOTH_TESTS(sphere), BOTH_TESTS(spheres),
        BOTH_TESTS(grid), BOTH_TESTS(light_field), BOTH_TESTS(nothing_to_do),
    };
    return RUN_TESTS(tests);
}
#else

enum { F(ROOM) = 10 * SH_MAX_BANDS * SH_MAX_BANDS };
static T F(out)[F(ROOM)];                      /* outputs live here: filled, called, looked at */

static void F(fill)(void)
{
    int i;
    for (i = 0; i < F(ROOM); i++) F(out)[i] = (T)(1000 + i);
}

static int F(untouched)(int from, int to)
{
    int i;
    for (i = from; i < to; i++)
        if (F(out)[i] != (T)(1000 + i)) return 0;
    return 1;
}

/* the call returns this error and writes nothing */
#define REFUSED(status, call) do { F(fill)(); assert_int_equal(call, status); assert_true(F(untouched)(0, F(ROOM))); } while (0)
/* NaN and both infinities in each of n numbers at p are refused by the call */
#define REFUSED_NOT_FINITE(p, n, call) do { int at_; for (at_ = 0; at_ < (n); at_++) { const T keep_ = (p)[at_]; \
        (p)[at_] = F(nan)();  REFUSED(SH_ERROR_NOT_FINITE, call); \
        (p)[at_] = F(inf)();  REFUSED(SH_ERROR_NOT_FINITE, call); \
        (p)[at_] = -F(inf)(); REFUSED(SH_ERROR_NOT_FINITE, call); (p)[at_] = keep_; } } while (0)

/* Bits of the single call in a batch; -ffast-math may order sums differently there, so nearness is asked for. */
static int F(same)(const T *a, const T *b, size_t count)
{
#ifdef __FAST_MATH__
    double largest = 0, worst = 0;
    size_t i;
    for (i = 0; i < count; i++) {
        if (fabs((double)b[i]) > largest) largest = fabs((double)b[i]);
        if (fabs((double)(a[i] - b[i])) > worst) worst = fabs((double)(a[i] - b[i]));
    }
    return worst <= 256 * (double)EPS * largest;
#else
    return !memcmp(a, b, count * sizeof *a);
#endif
}

static void F(structure)(void **state)
{
    static const int bad[] = { 0, -1, SH_MAX_BANDS + 1, 1 << 30, -(1 << 30) };
    const T d[3] = { 0, 0, 1 }, zh[2] = { 1, 1 }, sphere[4] = { 0, 0, 3, 1 };
    T *const o = F(out), *const null = NULL;
    F(sh_grid) grid;
    size_t i;
    int k;
    (void)state;
    for (k = 0; k < 3; k++) { grid.origin[k] = 0; grid.cell[k] = 1; grid.count[k] = 2; }
    for (i = 0; i < sizeof bad / sizeof *bad; i++) {
        const int n = bad[i];
        REFUSED(SH_ERROR_BANDS, F(sh_eval)(n, d, o));
        REFUSED(SH_ERROR_BANDS, F(sh_eval_n)(n, 1, d, o));
        REFUSED(SH_ERROR_BANDS, F(sh_eval_grad)(n, d, o, o + 16));
        REFUSED(SH_ERROR_BANDS, F(sh_eval_grad_n)(n, 1, d, o, o + 16));
        REFUSED(SH_ERROR_BANDS, F(sh_eval_hessian)(n, d, o, o + 16, o + 64));
        REFUSED(SH_ERROR_BANDS, F(sh_eval_hessian_n)(n, 1, d, o, o + 16, o + 64));
        REFUSED(SH_ERROR_BANDS, F(sh_eval_angles)(n, 1, 1, o, o + 16, o + 64));
        REFUSED(SH_ERROR_BANDS, F(sh_eval_angles_n)(n, 1, d, d, o, o + 16, o + 64));
        REFUSED(SH_ERROR_BANDS, F(sh_reconstruct)(n, zh, d, o, o + 16));
        REFUSED(SH_ERROR_BANDS, F(sh_reconstruct_n)(n, zh, 1, d, o, o + 16));
        REFUSED(SH_ERROR_BANDS, F(sh_project_n)(n, 1, d, d, o));
        REFUSED(SH_ERROR_BANDS, F(sh_light_field)(n, 1, d, d, d, sphere + 2, d, o, o + 16));
        REFUSED(SH_ERROR_BANDS, F(sh_zonal_cap)(n, (T)0.5, o, o + 64));
        REFUSED(SH_ERROR_BANDS, F(sh_zonal_rotate)(n, zh, d, o));
        REFUSED(SH_ERROR_BANDS, F(sh_zonal_light)(n, d, zh, zh, zh, o, o + 16, o + 64));
        REFUSED(SH_ERROR_BANDS, F(sh_sphere)(n, d, sphere, 1, o, o + 16));
        REFUSED(SH_ERROR_BANDS, F(sh_sphere_hessian)(n, d, sphere, 1, o, o + 16, o + 64));
        REFUSED(SH_ERROR_BANDS, F(sh_spheres)(n, SH_GRADIENT, 1, d, 1, sphere, NULL, o));
        REFUSED(SH_ERROR_BANDS, F(sh_spheres_n)(n, SH_GRADIENT, 1, 1, d, 1, sphere, NULL, o));
        REFUSED(SH_ERROR_BANDS, F(sh_spheres_grid)(n, SH_GRADIENT, 1, &grid, 0, 1, 1, sphere, NULL, o));
    }
    REFUSED(SH_ERROR_NULL, F(sh_eval)(2, null, o));
    REFUSED(SH_ERROR_NULL, F(sh_eval)(2, d, null));
    REFUSED(SH_ERROR_NULL, F(sh_eval_n)(2, 1, null, o));
    REFUSED(SH_ERROR_NULL, F(sh_eval_n)(2, 1, d, null));
    REFUSED(SH_ERROR_NULL, F(sh_eval_blocks)(2, 1, null, o));
    REFUSED(SH_ERROR_NULL, F(sh_eval_grad)(2, null, o, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_eval_grad_blocks)(2, 1, null, o, o + 64));
    REFUSED(SH_ERROR_NULL, F(sh_eval_hessian)(2, null, o, o + 16, o + 64));
    REFUSED(SH_ERROR_NULL, F(sh_eval_hessian_blocks)(2, 1, null, o, o + 64, o + 512));
    REFUSED(SH_ERROR_NULL, F(sh_eval_angles_n)(2, 1, null, d, o, o + 16, o + 64));
    REFUSED(SH_ERROR_NULL, F(sh_eval_angles_n)(2, 1, d, null, o, o + 16, o + 64));
    REFUSED(SH_ERROR_NULL, F(sh_reconstruct)(2, null, d, o, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_reconstruct)(2, zh, null, o, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_project_n)(2, 1, null, d, o));
    REFUSED(SH_ERROR_NULL, F(sh_project_n)(2, 1, d, null, o));
    REFUSED(SH_ERROR_NULL, F(sh_project_n)(2, 1, d, d, null));
    REFUSED(SH_ERROR_NULL, F(sh_light_field)(2, 1, null, d, d, sphere + 2, d, o, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_light_field)(2, 1, d, d, d, null, d, o, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_light_field)(2, 1, d, d, d, sphere + 2, d, null, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_zonal_rotate)(2, null, d, o));
    REFUSED(SH_ERROR_NULL, F(sh_zonal_rotate)(2, zh, null, o));
    REFUSED(SH_ERROR_NULL, F(sh_zonal_rotate)(2, zh, d, null));
    REFUSED(SH_ERROR_NULL, F(sh_zonal_light)(2, null, zh, zh, zh, o, o + 16, o + 64));
    REFUSED(SH_ERROR_NULL, F(sh_zonal_light)(2, d, null, zh, zh, o, o + 16, o + 64));
    REFUSED(SH_ERROR_NULL, F(sh_zonal_light)(2, d, zh, null, zh, o, o + 16, NULL));         /* grad asked, no dzh */
    REFUSED(SH_ERROR_NULL, F(sh_zonal_light)(2, d, zh, zh, null, o, o + 16, o + 64));       /* hess asked, no ddzh */
    REFUSED(SH_ERROR_NULL, F(sh_sphere)(2, null, sphere, 1, o, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_sphere)(2, d, null, 1, o, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_sphere)(2, d, sphere, 1, null, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_spheres)(2, SH_GRADIENT, 1, null, 1, sphere, NULL, o));
    REFUSED(SH_ERROR_NULL, F(sh_spheres)(2, SH_GRADIENT, 1, d, 1, null, NULL, o));
    REFUSED(SH_ERROR_NULL, F(sh_spheres)(2, SH_GRADIENT, 1, d, 1, sphere, NULL, null));
    REFUSED(SH_ERROR_NULL, F(sh_spheres_grid)(2, SH_GRADIENT, 1, NULL, 0, 1, 1, sphere, NULL, o));
    /* counts so large that their size in bytes wraps around */
    REFUSED(SH_ERROR_COUNT, F(sh_eval_n)(2, (size_t)-1 / 2, d, o));
    REFUSED(SH_ERROR_COUNT, F(sh_reconstruct_n)(2, zh, (size_t)-1 / 2, d, o, o + 16));
    REFUSED(SH_ERROR_NULL, F(sh_spheres_n)(2, SH_GRADIENT, 1, 1, NULL, 0, NULL, NULL, o));
    REFUSED(SH_ERROR_NULL, F(sh_spheres)(2, SH_GRADIENT, 1, NULL, 0, NULL, NULL, o));
    REFUSED(SH_ERROR_COUNT, F(sh_eval_blocks)(2, (size_t)-1 / SH_BLOCK + 1, d, o));      /* 8 times that is 0 */
    REFUSED(SH_ERROR_COUNT, F(sh_eval_grad_blocks)(2, (size_t)-1 / SH_BLOCK + 1, d, o, NULL));
    REFUSED(SH_ERROR_COUNT, F(sh_eval_hessian_blocks)(2, (size_t)-1 / SH_BLOCK + 1, d, o, NULL, NULL));
    REFUSED(SH_ERROR_COUNT, F(sh_project_n)(2, (size_t)-1 / 2, d, d, o));
    REFUSED(SH_ERROR_COUNT, F(sh_spheres)(2, SH_GRADIENT, 1, d, (size_t)-1 / 2, sphere, NULL, o));
    REFUSED(SH_ERROR_COUNT, F(sh_spheres)(2, SH_GRADIENT, 0, d, 1, sphere, NULL, o));
    REFUSED(SH_ERROR_COUNT, F(sh_spheres)(2, SH_GRADIENT, -3, d, 1, sphere, NULL, o));
    REFUSED(SH_ERROR_OPTION, F(sh_spheres)(2, 0, 1, d, 1, sphere, NULL, o));
    REFUSED(SH_ERROR_OPTION, F(sh_spheres)(2, 3, 1, d, 1, sphere, NULL, o));
    REFUSED(SH_ERROR_OPTION, F(sh_spheres)(2, 11, 1, d, 1, sphere, NULL, o));
}

static void F(overlap)(void **state)
{
    T *const o = F(out);
    const T d[3] = { 0, 0, 1 };
    int k;
    (void)state;
    for (k = 0; k < 3; k++) {
        REFUSED(SH_ERROR_OVERLAP, F(sh_eval)(3, o + k, o));                       /* input inside the output */
        REFUSED(SH_ERROR_OVERLAP, F(sh_eval)(1, o + 100, o + 100 + k));
        REFUSED(SH_ERROR_OVERLAP, F(sh_eval_n)(3, 4, o + 36 - 1 - k, o));
        REFUSED(SH_ERROR_OVERLAP, F(sh_eval_grad)(3, d, o, o + 8 - k));           /* outputs on each other */
        REFUSED(SH_ERROR_OVERLAP, F(sh_eval_grad)(3, o + 27 + 8 - k, o, o + 9));
        REFUSED(SH_ERROR_OVERLAP, F(sh_eval_hessian)(3, d, o, o + 9, o + 35 - k));
        REFUSED(SH_ERROR_OVERLAP, F(sh_eval_hessian)(3, d, o + 9 + 53 - k, NULL, o + 9));
        REFUSED(SH_ERROR_OVERLAP, F(sh_spheres)(3, SH_GRADIENT, 1, o + 35 - k, 1, o + 100, NULL, o));
        REFUSED(SH_ERROR_OVERLAP, F(sh_spheres)(3, SH_GRADIENT, 1, d, 1, o + 35 - k, NULL, o));
        REFUSED(SH_ERROR_OVERLAP, F(sh_spheres)(3, SH_GRADIENT, 1, d, 3, o + 100, o + 35 - k, o));
        REFUSED(SH_ERROR_OVERLAP, F(sh_project_n)(3, 2, o + 8 - k, d, o));
        REFUSED(SH_ERROR_OVERLAP, F(sh_reconstruct_n)(3, o, 2, o + 100, o + 8 - k, NULL));
        REFUSED(SH_ERROR_OVERLAP, F(sh_reconstruct_n)(3, o, 2, o + 100, NULL, o + 105 - k));
        REFUSED(SH_ERROR_OVERLAP, F(sh_sphere)(3, d, o + 8 - k, (T)0.5, o, NULL));
        REFUSED(SH_ERROR_OVERLAP, F(sh_sphere)(3, d, o + 100, (T)0.5, o, o + 8 - k));
        REFUSED(SH_ERROR_OVERLAP, F(sh_zonal_rotate)(3, o + 8 - k, d, o));
        REFUSED(SH_ERROR_OVERLAP, F(sh_zonal_light)(3, d, o + 8 - k, o + 110, o + 110, o, o + 16, o + 48));
        REFUSED(SH_ERROR_OVERLAP, F(sh_zonal_light)(3, d, o + 110, o + 42 - k, o + 110, o, o + 16, o + 48));
        REFUSED(SH_ERROR_OVERLAP, F(sh_light_field)(3, 1, o + 8 - k, d + 2, d + 2, d + 2, d, o, o + 64));
        REFUSED(SH_ERROR_OVERLAP, F(sh_light_field)(3, 1, d, d + 2, d + 2, d + 2, d, o, o + 8 - k));
    }
}

static void F(directions)(void **state)
{
    static const double lengths[] = { 0, 1e-25, 1e25 };
    static const double lengths_f64[] = { 0, 1e-160, 1e160 };
    T *const o = F(out), zh[2] = { 1, 1 };
    int i, k;
    (void)state;
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) {
            T v[3] = { 0, 0, 0 };
            v[k] = (T)(IS_F32 ? lengths[i] : lengths_f64[i]);
            REFUSED(SH_ERROR_DIRECTION, F(sh_eval)(2, v, o));
            REFUSED(SH_ERROR_DIRECTION, F(sh_eval_grad)(2, v, o, o + 16));
            REFUSED(SH_ERROR_DIRECTION, F(sh_eval_hessian)(2, v, o, o + 16, o + 64));
            REFUSED(SH_ERROR_DIRECTION, F(sh_eval)(17, v, o));
            REFUSED(SH_ERROR_DIRECTION, F(sh_eval_hessian)(17, v, o, o + 289, o + 4 * 289));
            REFUSED(SH_ERROR_DIRECTION, F(sh_reconstruct)(1, zh, v, o, o + 16));
            REFUSED(SH_ERROR_DIRECTION, F(sh_project_n)(2, 1, v, zh, o));
            REFUSED(SH_ERROR_DIRECTION, F(sh_zonal_rotate)(2, zh, v, o));
            REFUSED(SH_ERROR_DIRECTION, F(sh_zonal_light)(2, v, zh, zh, zh, o, o + 16, o + 64));
        }
    {
        T v[3] = { 0, (T)0.6, (T)0.8 };
        REFUSED_NOT_FINITE(v, 3, F(sh_eval)(2, v, o));
        REFUSED_NOT_FINITE(v, 3, F(sh_eval)(14, v, o));
        REFUSED_NOT_FINITE(v, 3, F(sh_eval_grad)(2, v, o, o + 16));
        REFUSED_NOT_FINITE(v, 3, F(sh_eval_hessian)(2, v, o, o + 16, o + 64));
        REFUSED_NOT_FINITE(v, 3, F(sh_reconstruct)(1, zh, v, o, o + 16));
        REFUSED_NOT_FINITE(v, 3, F(sh_project_n)(2, 1, v, zh, o));
        REFUSED_NOT_FINITE(v, 3, F(sh_zonal_rotate)(2, zh, v, o));
        REFUSED_NOT_FINITE(v, 3, F(sh_zonal_light)(2, v, zh, zh, zh, o, o + 16, o + 64));
    }
}

/* One bad direction among many: its outputs stay, the others have their bits, the call says so. */
static void F(batches_with_bad_items)(void **state)
{
    enum { COUNT = 21 };
    static const int some[] = { 1, 3, 9, 12 };
    T v[3 * COUNT], blocked[9 * SH_BLOCK], one[10 * 144], c[144];
    static T y[COUNT * 144], g[3 * COUNT * 144], h[6 * COUNT * 144], values[COUNT], grads[3 * COUNT];
    int s, bad, kind, k;
    size_t i, j;
    (void)state;
    for (s = 0; s < 4; s++)
        for (bad = 0; bad < COUNT; bad += 5)
            for (kind = 0; kind < 2; kind++) {
                const int bands = some[s], error = kind ? SH_ERROR_NOT_FINITE : SH_ERROR_DIRECTION;
                const size_t n2 = (size_t)(bands * bands);
                for (i = 0; i < 3 * COUNT; i++) v[i] = (T)((double)(i * 37 % 17) - 7.5);
                for (k = 0; k < 3; k++) v[3 * bad + k] = kind ? (k == 1 ? F(nan)() : 1) : 0;
                for (i = 0; i < n2; i++) c[i] = (T)(1 + (double)i);
                for (i = 0; i < COUNT * n2; i++) y[i] = 77;
                for (i = 0; i < 3 * COUNT * n2; i++) g[i] = 77;
                for (i = 0; i < 6 * COUNT * n2; i++) h[i] = 77;
                for (i = 0; i < COUNT; i++) values[i] = grads[3 * i] = grads[3 * i + 1] = grads[3 * i + 2] = 77;
                assert_int_equal(F(sh_eval_hessian_n)(bands, COUNT, v, y, g, h), error);
                assert_int_equal(F(sh_reconstruct_n)(bands, c, COUNT, v, values, grads), error);
                for (i = 0; i < COUNT; i++) {
                    if (i == (size_t)bad) {
                        for (j = 0; j < n2; j++) assert_true(y[i * n2 + j] == 77);
                        for (j = 0; j < 3 * n2; j++) assert_true(g[3 * i * n2 + j] == 77);
                        for (j = 0; j < 6 * n2; j++) assert_true(h[6 * i * n2 + j] == 77);
                        assert_true(values[i] == 77 && grads[3 * i] == 77 && grads[3 * i + 1] == 77 && grads[3 * i + 2] == 77);
                        continue;
                    }
                    assert_int_equal(F(sh_eval_hessian)(bands, v + 3 * i, one, one + n2, one + 4 * n2), SH_OK);
                    assert_true(F(same)(y + i * n2, one, n2));
                    assert_true(F(same)(g + 3 * i * n2, one + n2, 3 * n2));
                    assert_true(F(same)(h + 6 * i * n2, one + 4 * n2, 6 * n2));
                    assert_int_equal(F(sh_reconstruct)(bands, c, v + 3 * i, one, one + 1), SH_OK);
                    assert_true(F(same)(values + i, one, 1));
                    assert_true(F(same)(grads + 3 * i, one + 1, 3));
                }
                for (i = 0; i < COUNT * n2; i++) y[i] = 77;
                assert_int_equal(F(sh_eval_n)(bands, COUNT, v, y), error);
                for (j = 0; j < n2; j++) assert_true(y[(size_t)bad * n2 + j] == 77);
                for (i = 0; i < 2 * SH_BLOCK; i++)
                    for (k = 0; k < 3; k++)
                        blocked[(i / SH_BLOCK * 3 + (size_t)k) * SH_BLOCK + i % SH_BLOCK] = v[3 * i + (size_t)k];
                for (i = 0; i < COUNT * n2; i++) y[i] = 77;
                assert_int_equal(F(sh_eval_blocks)(bands, 2, blocked, y), bad < 2 * SH_BLOCK ? error : SH_OK);
                for (i = 0; i < 2 * SH_BLOCK; i++) {
                    T got[144];
                    for (j = 0; j < n2; j++) got[j] = y[(i / SH_BLOCK * n2 + j) * SH_BLOCK + i % SH_BLOCK];
                    if (i == (size_t)bad) {
                        for (j = 0; j < n2; j++) assert_true(got[j] == 77);
                        continue;
                    }
                    assert_int_equal(F(sh_eval)(bands, v + 3 * i, one), SH_OK);
                    assert_true(F(same)(got, one, n2));
                }
            }
}

static void F(angles)(void **state)
{
    T *const o = F(out), a[2] = { (T)0.5, (T)0.25 };
    int l, m;
    (void)state;
    REFUSED_NOT_FINITE(a, 2, F(sh_eval_angles)(3, a[0], a[1], o, o + 16, o + 64));
    REFUSED_NOT_FINITE(a, 2, F(sh_eval_angles_n)(3, 1, a, a + 1, o, o + 16, o + 64));
    /* at the pole phi moves nothing, theta moves along the meridian phi: only m = 1 and -1 tilt */
    assert_int_equal(F(sh_eval_angles)(4, 0, (T)0.5, o, o + 16, o + 32), SH_OK);
    for (l = 0; l < 4; l++)
        for (m = -l; m <= l; m++) {
            const int i = l * (l + 1) + m;
            assert_true(o[32 + i] == 0);
            assert_true((o[16 + i] != 0) == (m == 1 || m == -1));
        }
}

static void F(sums_over_directions)(void **state)
{
    T *const o = F(out), c[4] = { 1, 2, 3, 4 }, v[6] = { 0, (T)0.6, (T)0.8, 1, 0, 0 }, w[2] = { 1, 2 };
    (void)state;
    /* NaN among coefficients or weights is data: it comes out where it belongs */
    c[2] = F(nan)();
    assert_int_equal(F(sh_reconstruct)(2, c, v, o, NULL), SH_OK);
    assert_true(F(is_nan)(o[0]));
    w[1] = F(nan)();
    assert_int_equal(F(sh_project_n)(2, 2, v, w, o), SH_OK);
    assert_true(F(is_nan)(o[0]));
    /* outputs may be left out */
    c[2] = 3;
    F(fill)();
    assert_int_equal(F(sh_reconstruct_n)(2, c, 2, v, NULL, NULL), SH_OK);
    assert_int_equal(F(sh_reconstruct_n)(2, c, 2, v, NULL, o), SH_OK);
    assert_true(F(untouched)(6, F(ROOM)) && !F(untouched)(0, 6));
}

static void F(zonal)(void **state)
{
    T *const o = F(out), s[1] = { (T)0.5 }, zh[2] = { 1, 1 };
    const T d[3] = { 0, 0, 2 };
    (void)state;
    REFUSED_NOT_FINITE(s, 1, F(sh_zonal_cap)(3, s[0], o, o + 16));
    REFUSED(SH_ERROR_RADIUS, F(sh_zonal_cap)(3, (T)-0.25, o, o + 16));
    REFUSED(SH_ERROR_RADIUS, F(sh_zonal_cap)(3, (T)1.0001, o, o + 16));
    assert_int_equal(F(sh_zonal_cap)(3, 0, o, o + 16), SH_OK);
    assert_true(o[0] == 0 && o[1] == 0 && o[2] == 0);
    assert_int_equal(F(sh_zonal_cap)(3, (T)0.5, NULL, o), SH_OK);
    assert_int_equal(F(sh_zonal_cap)(3, (T)0.5, o, NULL), SH_OK);
    zh[1] = F(nan)();                                                   /* coefficients: data */
    assert_int_equal(F(sh_zonal_rotate)(2, zh, d, o), SH_OK);
    assert_true(F(is_nan)(o[2]) && o[0] == o[0] && !F(is_nan)(o[0]));
}

static void F(sphere)(void **state)
{
    static const double inside[] = { 1, 1.5, 1e6 };
    T *const o = F(out), p[3] = { (T)0.5, 0, 0 }, c[3] = { (T)0.5, 1, 0 }, r[1] = { (T)0.5 };
    int i, k;
    (void)state;
    REFUSED_NOT_FINITE(p, 3, F(sh_sphere)(3, p, c, r[0], o, o + 16));
    REFUSED_NOT_FINITE(c, 3, F(sh_sphere)(3, p, c, r[0], o, o + 16));
    REFUSED_NOT_FINITE(r, 1, F(sh_sphere)(3, p, c, r[0], o, o + 16));
    REFUSED_NOT_FINITE(c, 3, F(sh_sphere_hessian)(3, p, c, r[0], o, o + 16, o + 64));
    REFUSED(SH_ERROR_RADIUS, F(sh_sphere)(3, p, c, (T)-0.5, o, o + 16));
    F(fill)();
    assert_int_equal(F(sh_sphere_hessian)(2, p, c, 0, o, o + 4, o + 16), SH_OK);       /* radius 0: dark */
    for (i = 0; i < 40; i++) assert_true(o[i] == 0);
    assert_true(F(untouched)(40, F(ROOM)));
    for (k = 0; k < 4; k++) {                                                          /* on it, inside it, at its center */
        F(fill)();
        assert_int_equal(k < 3 ? F(sh_sphere_hessian)(2, p, c, (T)inside[k], o, o + 4, o + 16)
                               : F(sh_sphere_hessian)(2, c, c, 1, o, o + 4, o + 16), SH_INSIDE);
        assert_true(fabs((double)o[0] - 3.5449077018110318) < 4 * (double)EPS);
        for (i = 1; i < 40; i++) assert_true(o[i] == 0);
        assert_true(F(untouched)(40, F(ROOM)));
    }
    F(fill)();
    assert_int_equal(F(sh_sphere)(2, c, c, 0, o, o + 4), SH_OK);                        /* no size, at the point */
    for (i = 0; i < 16; i++) assert_true(o[i] == 0);
    assert_true(F(untouched)(16, F(ROOM)));
    {   /* radii whose square leaves the range hold every point in range; SH_INSIDE of one light is SH_INSIDE of the sum */
        const T most = IS_F32 ? (T)3.3e38 : (T)1.7e308;
        T radius = 1;
        while (radius < most / 32) {
            T light[4];
            radius *= 32;
            for (i = 0; i < 3; i++) light[i] = c[i];
            light[3] = radius;
            F(fill)();
            assert_int_equal(F(sh_sphere_hessian)(2, p, c, radius, o, o + 4, o + 16), SH_INSIDE);
            assert_true(fabs((double)o[0] - 3.5449077018110318) < 4 * (double)EPS && o[1] == 0 && o[4] == 0 && o[16] == 0);
            assert_int_equal(F(sh_spheres)(2, SH_GRADIENT, 1, p, 1, light, NULL, o), SH_INSIDE);
            assert_true(fabs((double)o[0] - 3.5449077018110318) < 4 * (double)EPS && o[1] == 0 && o[4] == 0);
        }
    }
    {   /* at the shortest distance the basis' Hessian leaves the range of float, the light's does not */
        const T d = IS_F32 ? (T)1.0842e-18 : (T)1.1e-150, from[3] = { 0, 0, 0 }, to[3] = { 0, 0, d };
        static T h[6 * SH_MAX_BANDS * SH_MAX_BANDS], values[SH_MAX_BANDS * SH_MAX_BANDS];
        int bands;
        for (bands = 20; bands <= SH_MAX_BANDS; bands++) {
            assert_int_equal(F(sh_sphere_hessian)(bands, from, to, d / 128, values, NULL, h), SH_OK);
            assert_true(F(shi_finite)(h, (size_t)(6 * bands * bands)));
        }
    }
}

static void F(spheres)(void **state)
{
    enum { COUNT = 11 };
    T *const o = F(out), lights[4 * COUNT], radiance[2 * COUNT], p[6] = { (T)0.25, (T)0.5, (T)0.125, 0, 0, 0 };
    T one[36], two[36];
    int i, j;
    (void)state;
    for (i = 0; i < COUNT; i++) {
        lights[i] = (T)(2 + i);
        lights[COUNT + i] = (T)(3 - i);
        lights[2 * COUNT + i] = (T)(i % 3);
        lights[3 * COUNT + i] = (T)0.5;
        radiance[i] = 1;
        radiance[COUNT + i] = 2;
    }
    REFUSED_NOT_FINITE(lights, 4 * COUNT, F(sh_spheres)(3, SH_GRADIENT, 1, p, COUNT, lights, NULL, o));
    REFUSED_NOT_FINITE(p, 3, F(sh_spheres)(3, SH_GRADIENT, 1, p, COUNT, lights, NULL, o));
    for (i = 0; i < COUNT; i++) {
        const T keep = lights[3 * COUNT + i];
        lights[3 * COUNT + i] = (T)-0.5;
        REFUSED(SH_ERROR_RADIUS, F(sh_spheres)(3, SH_GRADIENT, 2, p, COUNT, lights, radiance, o));
        REFUSED(SH_ERROR_RADIUS, F(sh_spheres_n)(3, SH_HESSIAN, 2, 2, p, COUNT, lights, radiance, o));
        REFUSED(SH_ERROR_RADIUS, F(sh_spheres_n)(3, SH_VALUES, 2, 2, p, COUNT, lights, radiance, o));
        lights[3 * COUNT + i] = keep;
    }
    /* radius 0 adds nothing: the sum without that light */
    for (i = 0; i < COUNT; i++) radiance[i] = i == 4 ? 0 : 1;
    assert_int_equal(F(sh_spheres)(3, SH_GRADIENT, 1, p, COUNT, lights, radiance, one), SH_OK);
    lights[3 * COUNT + 4] = 0;
    assert_int_equal(F(sh_spheres)(3, SH_GRADIENT, 1, p, COUNT, lights, NULL, two), SH_OK);
    for (i = 0; i < 36; i++) assert_true(fabs((double)(one[i] - two[i])) <= 4 * (double)EPS);
    /* a light around the point adds 2 sqrt(pi) times its radiance to L_00 and nothing else, and the status says so */
    lights[4] = p[0]; lights[COUNT + 4] = p[1]; lights[2 * COUNT + 4] = p[2] + (T)0.125;
    lights[3 * COUNT + 4] = (T)0.25;
    assert_int_equal(F(sh_spheres)(3, SH_GRADIENT, 1, p, COUNT, lights, NULL, two), SH_INSIDE);
    for (i = 0; i < 36; i++)
        assert_true(fabs((double)(two[i] - one[i]) - (i ? 0 : 3.5449077018110318)) <= 16 * (double)EPS);
    for (j = 0; j < 3; j++) {                      /* the light is exactly at the point; then of no size there */
        lights[2 * COUNT + 4] = p[2];
        lights[3 * COUNT + 4] = j < 2 ? (T)(0.25 + j) : 0;
        assert_int_equal(F(sh_spheres)(3, SH_HESSIAN, 1, p, COUNT, lights, NULL, o), j < 2 ? SH_INSIDE : SH_OK);
        for (i = 0; i < 36; i++)
            assert_true(fabs((double)(o[i] - one[i]) - (i || j == 2 ? 0 : 3.5449077018110318)) <= 16 * (double)EPS);
        for (i = 36; i < 90; i++) assert_true(!F(is_nan)(o[i]));
    }
    /* one bad point among points: its outputs stay */
    lights[3 * COUNT + 4] = 0;
    p[4] = F(nan)();
    F(fill)();
    assert_int_equal(F(sh_spheres_n)(3, SH_GRADIENT, 1, 2, p, COUNT, lights, NULL, o), SH_ERROR_NOT_FINITE);
    assert_true(F(untouched)(36, F(ROOM)) && !F(untouched)(0, 36));
    p[0] = IS_F32 ? (T)1e20 : (T)1e160;             /* nor are those of a finite one out of range, and the next is written */
    p[4] = 0;
    F(fill)();
    assert_int_equal(F(sh_spheres_n)(3, SH_GRADIENT, 1, 2, p, COUNT, lights, NULL, o), SH_ERROR_DIRECTION);
    assert_true(F(untouched)(0, 36) && !F(untouched)(36, 72) && F(untouched)(72, F(ROOM)));
    lights[3] = F(nan)();                           /* a light that is not finite comes first, wherever the points are */
    REFUSED(SH_ERROR_NOT_FINITE, F(sh_spheres_n)(3, SH_GRADIENT, 1, 2, p, COUNT, lights, NULL, o));
    lights[3] = 5;
    p[0] = (T)0.25;
    {   /* a light nearer than lengths may be */
        const T origin[3] = { 0, 0, 0 }, near = IS_F32 ? (T)5e-19 : (T)1e-151, light[4] = { near, 0, 0, near * (T)0.8 };
        F(fill)();
        REFUSED(SH_ERROR_DIRECTION, F(sh_spheres)(2, SH_VALUES, 1, origin, 1, light, NULL, o));
        REFUSED(SH_ERROR_DIRECTION, F(sh_sphere)(2, origin, light, light[3], o, NULL));
    }
    /* NaN radiance is data, of its own channel */
    radiance[COUNT + 3] = F(nan)();
    assert_int_equal(F(sh_spheres)(3, SH_GRADIENT, 2, p, COUNT, lights, radiance, o), SH_OK);
    assert_true(F(is_nan)(o[36]) && !F(is_nan)(o[0]));
}

static void F(grid)(void **state)
{
    T *const o = F(out), light[4] = { 5, 5, 5, 1 };
    F(sh_grid) g, b;
    int k;
    (void)state;
    for (k = 0; k < 3; k++) { g.origin[k] = 0; g.cell[k] = 1; g.count[k] = 2; }
    for (k = 0; k < 3; k++) {
        b = g; b.count[k] = 0;  REFUSED(SH_ERROR_GRID, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &b, 0, 1, 1, light, NULL, o));
        b = g; b.count[k] = -4; REFUSED(SH_ERROR_GRID, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &b, 0, 1, 1, light, NULL, o));
        b = g; b.cell[k] = 0;   REFUSED(SH_ERROR_GRID, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &b, 0, 1, 1, light, NULL, o));
        b = g; b.cell[k] = -1;  REFUSED(SH_ERROR_GRID, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &b, 0, 1, 1, light, NULL, o));
        b = g;
        REFUSED_NOT_FINITE(b.cell + k, 1, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &b, 0, 1, 1, light, NULL, o));
        REFUSED_NOT_FINITE(b.origin + k, 1, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &b, 0, 1, 1, light, NULL, o));
    }
    REFUSED(SH_ERROR_COUNT, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &g, 0, 9, 1, light, NULL, o));     /* beyond its 8 nodes */
    REFUSED(SH_ERROR_COUNT, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &g, 8, 1, 1, light, NULL, o));
    REFUSED(SH_ERROR_COUNT, F(sh_spheres_grid)(2, SH_GRADIENT, 1, &g, (size_t)-1, 2, 1, light, NULL, o));
    b = g;                                                                   /* one node on an axis needs no cell size */
    b.count[1] = 1;
    b.cell[1] = 0;
    assert_int_equal(F(sh_spheres_grid)(2, SH_GRADIENT, 1, &b, 0, 4, 1, light, NULL, o), SH_OK);
}

static void F(light_field)(void **state)
{
    T *const o = F(out), dir[3] = { 0, 0, 1 }, area[1] = { (T)0.1 }, one[1] = { 1 }, depth[1] = { 2 }, normal[3] = { 0, 0, -1 };
    T near_edge[3] = { 1, 0, 0 };
    int i;
    (void)state;
    REFUSED_NOT_FINITE(dir, 3, F(sh_light_field)(2, 1, dir, area, one, depth, normal, o, o + 16));
    REFUSED_NOT_FINITE(normal, 3, F(sh_light_field)(2, 1, dir, area, one, depth, normal, o, o + 16));
    depth[0] = F(nan)();
    REFUSED(SH_ERROR_NOT_FINITE, F(sh_light_field)(2, 1, dir, area, one, depth, normal, o, o + 16));
    depth[0] = 0;
    REFUSED(SH_ERROR_RADIUS, F(sh_light_field)(2, 1, dir, area, one, depth, normal, o, o + 16));
    depth[0] = -1;
    REFUSED(SH_ERROR_RADIUS, F(sh_light_field)(2, 1, dir, area, one, depth, normal, o, o + 16));
    depth[0] = F(inf)();                                                     /* the sky: no parallax */
    assert_int_equal(F(sh_light_field)(2, 1, dir, area, one, depth, normal, o, o + 16), SH_OK);
    assert_true(o[0] > 0);
    for (i = 0; i < 12; i++) assert_true(o[16 + i] == 0);
    depth[0] = 2;                                                            /* values alone: no depth, no normals */
    F(fill)();
    assert_int_equal(F(sh_light_field)(2, 1, dir, area, one, NULL, NULL, o, NULL), SH_OK);
    assert_true(F(untouched)(4, F(ROOM)) && !F(untouched)(0, 4));
    assert_int_equal(F(sh_light_field)(2, 1, dir, area, one, depth, near_edge, o, o + 16), SH_OK);   /* n.w = 0: clamped */
    for (i = 0; i < 12; i++) assert_true(!F(is_nan)(o[16 + i]) && fabs((double)o[16 + i]) < 100);
    one[0] = F(nan)();                                                       /* radiance is data */
    assert_int_equal(F(sh_light_field)(2, 1, dir, area, one, depth, normal, o, o + 16), SH_OK);
    assert_true(F(is_nan)(o[0]));
}

/* Count 0 is fine, also without arrays; sums over nothing are zeros. */
static void F(nothing_to_do)(void **state)
{
    T *const o = F(out);
    const T d[3] = { 0, 0, 1 };
    int i;
    (void)state;
    REFUSED(SH_OK, F(sh_eval_n)(3, 0, NULL, NULL));
    REFUSED(SH_OK, F(sh_eval_n)(3, 0, d, o));
    REFUSED(SH_OK, F(sh_eval_blocks)(3, 0, NULL, NULL));
    REFUSED(SH_OK, F(sh_eval_grad_n)(3, 0, d, o, o + 64));
    REFUSED(SH_OK, F(sh_eval_hessian_blocks)(3, 0, NULL, NULL, NULL, NULL));
    REFUSED(SH_OK, F(sh_eval_angles_n)(3, 0, NULL, NULL, o, o + 9, o + 18));
    REFUSED(SH_OK, F(sh_reconstruct_n)(3, d, 0, NULL, o, o + 9));
    REFUSED(SH_OK, F(sh_spheres_n)(3, SH_GRADIENT, 1, 0, NULL, 0, NULL, NULL, o));
    REFUSED(SH_ERROR_BANDS, F(sh_eval_n)(0, 0, NULL, NULL));
    REFUSED(SH_ERROR_BANDS, F(sh_reconstruct_n)(0, d, 0, NULL, o, o + 9));
    REFUSED(SH_ERROR_BANDS, F(sh_eval_angles_n)(0, 0, NULL, NULL, o, o + 9, o + 18));
    F(fill)();
    assert_int_equal(F(sh_project_n)(3, 0, NULL, NULL, o), SH_OK);
    for (i = 0; i < 9; i++) assert_true(o[i] == 0);
    assert_true(F(untouched)(9, F(ROOM)));
    F(fill)();
    assert_int_equal(F(sh_light_field)(3, 0, NULL, NULL, NULL, NULL, NULL, o, o + 9), SH_OK);
    for (i = 0; i < 36; i++) assert_true(o[i] == 0);
    F(fill)();
    assert_int_equal(F(sh_spheres)(3, SH_HESSIAN, 2, d, 0, NULL, NULL, o), SH_OK);
    for (i = 0; i < 180; i++) assert_true(o[i] == 0);
    assert_true(F(untouched)(180, F(ROOM)));
}
#undef REFUSED
#undef REFUSED_NOT_FINITE
#endif
