/* Windows, the minimum on the sphere, and deringing of an HDR sky whose sun rings. */
#ifndef T
#include "sh_product.h"
#include "report.h"
#include "ref.h"

/* Lowest value on a grid of about 0.7 degrees, in long double from the definition; the basis is kept. */
enum { POLAR = 181, AROUND = 360, GRID = POLAR * AROUND };

static long double lowest_on_grid(int bands, const long double *c)
{
    static double (*basis)[81];
    static int made;
    long double low = 1e300L, y[REF_MAX];
    int i, k;

    if (!basis) basis = malloc(GRID * sizeof *basis);
    assert_non_null(basis);
    if (!made) {
        for (i = 0; i < GRID; i++) {
            const long double t = REF_PI * (i / AROUND + 0.5L) / POLAR, f = 2 * REF_PI * (i % AROUND) / AROUND;
            const long double u[3] = { sinl(t) * cosl(f), sinl(t) * sinl(f), cosl(t) };
            ref_values(9, u, y);
            for (k = 0; k < 81; k++) basis[i][k] = (double)y[k];
        }
        made = 1;
    }
    for (i = 0; i < GRID; i++) {
        long double f = 0;
        for (k = 0; k < bands * bands; k++) f += c[k] * (long double)basis[i][k];
        if (f < low) low = f;
    }
    return low;
}

/* Lowest value of sum zh_l Y_l0 over the angle to the axis: a fine scan, then golden sections. */
static long double profile(int bands, const long double *zh, long double t)
{
    const long double u[3] = { sinl(t), 0, cosl(t) };
    long double y[REF_MAX], f = 0;
    int l;
    ref_values(bands, u, y);
    for (l = 0; l < bands; l++) f += zh[l] * y[l * (l + 1)];
    return f;
}
static long double lowest_of_profile(int bands, const long double *zh)
{
    long double low = 1e300L, at = 0, a, b;
    int i;
    for (i = 0; i <= 2000; i++) {
        const long double f = profile(bands, zh, REF_PI * i / 2000);
        if (f < low) { low = f; at = REF_PI * i / 2000; }
    }
    for (a = at - REF_PI / 2000, b = at + REF_PI / 2000, i = 0; i < 60; i++) {
        const long double c = b - (b - a) * 0.6180339887498948482L, d = a + (b - a) * 0.6180339887498948482L;
        if (profile(bands, zh, c) < profile(bands, zh, d)) b = d;
        else a = c;
    }
    return fminl(low, profile(bands, zh, (a + b) / 2));
}

#define BOTH "test_product_ringing.c"
#include "both.h"

int main(void)
{
    const struct CMUnitTest tests[] = { BOTH_TESTS(windows), BOTH_TESTS(minimum), BOTH_TESTS(rings),
                                        BOTH_TESTS(wells),   BOTH_TESTS(bottom), BOTH_TESTS(dering) };
    return RUN_TESTS(tests);
}

#else

static void F(windows)(void **state)
{
    row *w = row_open("windows", PRECISION);
    int kind, l;
    T f[32];

    (void)state;
    for (kind = SH_HANN; kind <= SH_GAUSS; kind++) {
        const T width = (T)6.5;
        assert_int_equal(F(sh_window)(kind, 32, width, f), SH_OK);
        assert_true(f[0] == 1);
        row_case("kind %d", kind);
        for (l = 1; l < 32; l++) {
            const long double x = REF_PI * l / 6.5L;
            const long double want = kind == SH_GAUSS ? expl(-x * x * (l + 1) / (2 * l)) : l >= 6.5L ? 0
                                   : kind == SH_HANN ? cosl(x / 2) * cosl(x / 2) : sinl(x) / x;
            row_check(w, (long double)f[l], want, 2 * (long double)EPS, l);
            assert_true(f[l] <= f[l - 1]);
        }
        assert_int_equal(F(sh_window)(kind, 32, 0, f), SH_ERROR_OPTION);
        assert_int_equal(F(sh_window)(kind, 33, width, f), SH_ERROR_BANDS);
    }
    assert_int_equal(F(sh_window)(0, 3, 3, f), SH_ERROR_OPTION);
    assert_int_equal(F(sh_window)(SH_HANN, 3, (T)NAN, f), SH_ERROR_OPTION);
    row_close(w);
}

static void F(minimum)(void **state)
{
    row *w = row_open("minimum on the sphere", PRECISION), *wd = row_open("its value at its direction", PRECISION);
    const int octaves = sizeof(T) == 4 ? 20 : 900;
    int turn, i, k;

    (void)state;
    for (turn = 0; turn < effort(36); turn++) {
        const int bands = 1 + turn % 9, n = bands * bands;
        const double scale = turn / 9 % 2 ? 1e20 : 1;                   /* where v + 1 is v */
        T c[81], u[3], value = 0;
        long double lc[81], v[3], y[81], f = 0, size = 0, low;

        for (i = 0; i < n; i++) { c[i] = (T)(scale * ref_between(-1, 1)); lc[i] = (long double)c[i]; size += lc[i] * lc[i]; }
        size = sqrtl(size) * bands / 3.5L;
        assert_int_equal(F(sh_minimum)(bands, c, u, &value), SH_OK);
        low = lowest_on_grid(bands, lc);
        row_case("bands %d, scale %g", bands, scale);
        /* never above the grid's lowest, and below it by no more than the grid can miss: curvature bands^2 at half a cell */
        row_check(w, fmaxl(0, (long double)value - low), 0, 16 * (long double)EPS * size, 0);
        row_check(w, fmaxl(0, low - (long double)value), 0, size * bands * bands * 8e-5L + 16 * (long double)EPS * size, 1);
        for (i = 0; i < 3; i++) v[i] = (long double)u[i];
        /* times a power of two it is the same minimum, however large or small the squares of the coefficients would be */
        for (k = -octaves; k <= octaves; k += 2 * octaves) {
            T scaled[81], there[3], other = 0;
            for (i = 0; i < n; i++) scaled[i] = (T)ldexp((double)c[i], k);
            assert_int_equal(F(sh_minimum)(bands, scaled, there, &other), SH_OK);
            assert_true(FAST_MATH || (ldexp((double)value, k) == (double)other && !memcmp(u, there, sizeof u)));
        }
        ref_values(bands, v, y);
        for (i = 0; i < n; i++) f += lc[i] * y[i];
        row_check(wd, (long double)value, f, 40 * (long double)EPS * size, 0);
    }
    row_close(w); row_close(wd);
}

/* Zonal functions about any axis, whose minima are rings: the lowest ring is found, and the bottom of it; deringed, none is
 * below zero. */
static void F(rings)(void **state)
{
    row *w = row_open("minimum of zonal functions", PRECISION), *wd = row_open("deringed zonal functions", PRECISION);
    int turn, l, k;

    (void)state;
    for (turn = 0; turn < effort(60); turn++) {
        const int bands = 2 + turn % 8, n = bands * bands;
        T zh[9], factors[9] = { 0 }, c[81], out[81], axis[3], value = 0, width = 0;
        long double want[9], size = 0;
        double u[3];

        ref_unit(u);
        for (k = 0; k < 3; k++) axis[k] = (T)u[k];
        for (l = 0; l < bands; l++) {
            zh[l] = (T)(turn % 3 ? ref_between(-1, 1) : floor(ref_between(-1, 2)));
            want[l] = (long double)zh[l];
        }
        if (turn < 8) zh[0] += 1;
        want[0] = (long double)zh[0];
        for (l = 0; l < bands; l++) size += want[l] * want[l];
        size = sqrtl(size) * bands / 3.5L;
        assert_int_equal(F(sh_zonal_rotate)(bands, zh, axis, c), SH_OK);
        assert_int_equal(F(sh_minimum)(bands, c, NULL, &value), SH_OK);
        row_case("bands %d, turn %d", bands, turn);
        row_check(w, (long double)value, lowest_of_profile(bands, want), 40 * (long double)EPS * size, 0);
        if (!(zh[0] > 0)) continue;
        assert_int_equal(F(sh_dering)(1 + turn % 3, bands, 1, c, out, &width), SH_OK);
        if (width > 0) {
            F(sh_window)(1 + turn % 3, bands, width, factors);
            for (l = 0; l < bands; l++) want[l] *= (long double)factors[l];
        }
        for (k = 0; k < n && width == 0; k++) assert_true(out[k] == c[k]);
        row_check(wd, fminl(0, lowest_of_profile(bands, want)), 0, 40 * (long double)EPS * size, 0);
    }
    row_close(w); row_close(wd);
}

/* Two wells closer than the search's samples, in a narrow valley: (x^2 - a^2)^2 + p x + y^2 about any axes, whose lowest value
 * lies on y = 0. */
static void F(wells)(void **state)
{
    static const long double node[5] = { -0.90617984593866399280L, -0.53846931010568309104L, 0, 0.53846931010568309104L,
                                         0.90617984593866399280L };
    static const long double weight[5] = { 0.23692688505618908751L, 0.47862867049936646804L, 0.56888888888888888889L,
                                           0.47862867049936646804L, 0.23692688505618908751L };
    row *w = row_open("minimum of two wells", PRECISION);
    int turn, i, j, k;
    (void)state;
    for (turn = 0; turn < effort(400); turn++) {
        const int bands = 5 + turn % 3 * 2, n = bands * bands;
        const long double a = (long double)ref_log_between(0.04, 0.15), p = (turn & 1 ? 1 : -1) * a * a * a * (long double)ref_between(0.05, 1);
        double e[3], f[3], d = 0, size = 0;
        long double sum[81] = { 0 }, y[REF_MAX], norm = 0, x, low;
        T c[81], value = 0;
        ref_unit(e);
        ref_unit(f);
        for (k = 0; k < 3; k++) d += e[k] * f[k];
        for (k = 0; k < 3; k++) size += (f[k] - d * e[k]) * (f[k] - d * e[k]);
        for (k = 0; k < 3; k++) f[k] = (f[k] - d * e[k]) / sqrt(size);
        for (i = 0; i < 5; i++)                             /* exact for products of degree 8 */
            for (j = 0; j < 10; j++) {
                const long double r = sqrtl(1 - node[i] * node[i]), turned = 2 * REF_PI * j / 10;
                const long double u[3] = { r * cosl(turned), r * sinl(turned), node[i] };
                long double ue = 0, uf = 0;
                for (k = 0; k < 3; k++) {
                    ue += u[k] * (long double)e[k];
                    uf += u[k] * (long double)f[k];
                }
                ref_values(5, u, y);
                for (k = 0; k < 25; k++)
                    sum[k] += weight[i] * REF_PI / 5 * y[k] * ((ue * ue - a * a) * (ue * ue - a * a) + p * ue + uf * uf);
            }
        for (k = 0; k < n; k++) {
            c[k] = (T)sum[k];
            norm += sum[k] * sum[k];
        }
        x = p > 0 ? -a : a;
        for (i = 0; i < 60; i++) x -= (4 * x * (x * x - a * a) + p) / (12 * x * x - 4 * a * a);
        low = (x * x - a * a) * (x * x - a * a) + p * x;
        row_case("bands %d, a %g, p %g, turn %d", bands, (double)a, (double)p, turn);
        assert_int_equal(F(sh_minimum)(bands, c, NULL, &value), SH_OK);
        row_check(w, (long double)value, low, 40 * (long double)EPS * sqrtl(norm) * bands / 3.5L, 0);
    }
    row_close(w);
}

/* Two wells, the deeper one's lowest point at one of the search's samples: its descent ends where it began. */
static void F(bottom)(void **state)
{
    row *w = row_open("minimum at a sample", PRECISION);
    int turn, k;
    (void)state;
    for (turn = 0; turn < effort(300); turn++) {
        const int bands = 3 + turn % 4, n = bands * bands, points = 24 * n + 64, i = (int)(ref_random() * points);
        const double z = 1 - (2 * i + 1.0) / points, r = sqrt(1 - z * z), turned = 2.399963229728653 * i;
        const T u[3] = { (T)(r * cos(turned)), (T)(r * sin(turned)), (T)z }, opposite[3] = { -u[0], -u[1], -u[2] };
        T zh[6], deep[36], other[36], c[36], at, value;
        long double norm = 0;
        F(sh_zonal_phong)(bands, 8, zh);
        F(sh_zonal_rotate)(bands, zh, u, deep);
        F(sh_zonal_rotate)(bands, zh, opposite, other);
        for (k = 0; k < n; k++) {
            c[k] = -deep[k] - (T)0.95 * other[k];
            norm += (long double)c[k] * (long double)c[k];
        }
        F(sh_reconstruct)(bands, c, u, &at, NULL);
        assert_int_equal(F(sh_minimum)(bands, c, NULL, &value), SH_OK);
        row_case("bands %d, sample %d", bands, i);
        row_check(w, fmaxl(0, (long double)value - (long double)at), 0, 40 * (long double)EPS * sqrtl(norm) * bands / 3.5L, 0);
    }
    row_close(w);
}

/* A sky brighter towards the horizon, a dark ground, and a sun of half a degree 50000 times the sky. */
static void F(sky)(int bands, T *c)
{
    static const T sun[3] = { (T)0.6, (T)0.48, (T)0.64 };
    const int n = bands * bands;
    T zh[9], disc[81];
    int i;

    memset(c, 0, (size_t)n * sizeof *c);
    c[0] = (T)1.2;
    if (bands > 1) c[2] = (T)0.5;
    if (bands > 2) c[6] = (T)-0.2;
    F(sh_zonal_cap)(bands, (T)0.00465, zh, NULL);
    F(sh_zonal_rotate)(bands, zh, sun, disc);
    for (i = 0; i < n; i++) c[i] += 50000 * disc[i];
}

static void F(dering)(void **state)
{
    row *w = row_open("deringed sky, minimum above zero", PRECISION), *wt = row_open("a window 0.1 % wider is too wide", PRECISION);
    int bands, kind, i, channel;

    (void)state;
    for (bands = 3; bands <= 9; bands += 2)
        for (kind = SH_HANN; kind <= SH_GAUSS; kind++) {
            const int n = bands * bands;
            T c[3 * 81], out[3 * 81], width = 0, wider[9], test[81], low;
            long double lc[81], size = 0;

            F(sky)(bands, c);
            for (i = 0; i < n; i++) {
                c[n + i] = i ? (T)0.8 * c[i] : c[0];            /* channels that ring less */
                c[2 * n + i] = i ? (T)0.5 * c[i] : c[0];
            }
            for (i = 0; i < n; i++) { lc[i] = (long double)c[i]; size += lc[i] * lc[i]; }
            size = sqrtl(size);
            assert_true(lowest_on_grid(bands, lc) < -0.1L * size);      /* it rings */
            assert_int_equal(F(sh_dering)(kind, bands, 3, c, out, &width), SH_OK);
            assert_true(width > 0);
            row_case("bands %d, kind %d, width %g", bands, kind, (double)width);
            for (channel = 0; channel < 3; channel++) {
                const T *o = out + channel * n;
                assert_true(o[0] == c[channel * n]);                    /* the mean stays */
                for (i = 0; i < n; i++) lc[i] = (long double)o[i];
                row_check(w, fminl(0, lowest_on_grid(bands, lc)), 0, 16 * (long double)EPS * size, channel);
            }
            F(sh_window)(kind, bands, width * (T)1.001, wider);
            F(sh_scale_bands)(bands, wider, c, test);
            F(sh_minimum)(bands, test, NULL, &low);
            row_check(wt, low < 0 ? 0 : 1, 0, 0.5L, 0);
        }
    row_close(w); row_close(wt);
    {
        T c[9] = { 1, 0, (T)0.1, 0, 0, 0, 0, 0, 0 }, out[9], width = 5;
        assert_int_equal(F(sh_dering)(SH_HANN, 3, 1, c, out, &width), SH_OK);      /* nothing to do */
        assert_true(width == 0);
        assert_memory_equal(c, out, sizeof c);
        c[0] = -1;
        assert_int_equal(F(sh_dering)(SH_HANN, 3, 1, c, out, &width), SH_ERROR_OPTION);
        c[0] = 1; c[2] = (T)NAN;
        assert_int_equal(F(sh_dering)(SH_HANN, 3, 1, c, out, &width), SH_ERROR_NOT_FINITE);
        assert_int_equal(F(sh_dering)(SH_HANN, 3, 1, c, c, &width), SH_ERROR_OVERLAP);
        assert_int_equal(F(sh_dering)(SH_HANN, 3, 0, c, out, &width), SH_ERROR_COUNT);
        assert_int_equal(F(sh_dering)(9, 3, 1, c, out, &width), SH_ERROR_OPTION);
    }
}

#endif
