/* test_polygon_many.c - sums over polygons, WR18's route and its tables, triangle as sphere, tolerance,
 * textures. */
#ifndef T
#if defined(__clang__)
#  pragma clang diagnostic ignored "-Wdouble-promotion"       /* double to long double is meant */
#endif
#include "sh_polygon.h"
#include "report.h"
#include "ref.h"

#define BOTH "test_polygon_many.c"

/* ---- tables, proven without their generator ---- */

/* W_l A_l^T = 1 on every band, with the definition of Y; condition of A_l by power iteration on both ends */
static void lobes(void **state)
{
    static const int sets[6] = { 3, 5, 7, 9, 12, 16 };
    static const double documented[6] = { 1.83, 2.50, 3.01, 3.82, 4.66, 6.08 };
    row *identity = row_open("lobe weights invert the lobes", "f64");
    row *unit = row_open("lobes are unit vectors", "f64");
    row *condition = row_open("worst condition of a band / documented", "f64");
    int s;
    (void)state;
    for (s = 0; s < 6; s++) {
        static long double y[31][256];
        const double *dirs, *weights;
        const int n = shi_lobe_set_f64(sets[s], &dirs, &weights), lobe_count = 2 * n - 1;
        int d, l, i, j, k;
        assert_int_equal(n, sets[s]);
        for (d = 0; d < lobe_count; d++) {
            const long double v[3] = { dirs[3 * d], dirs[3 * d + 1], dirs[3 * d + 2] };
            row_case("%d bands, lobe %d", n, d);
            row_check(unit, v[0] * v[0] + v[1] * v[1] + v[2] * v[2], 1, 4 * (long double)DBL_EPSILON, 0);
            ref_values(n, v, y[d]);
        }
        for (l = 0; l < n; l++) {
            const long double scale = sqrtl(4 * REF_PI / (2 * l + 1));
            long double a[31][31], v[31], high = 0, low = 0;
            row_case("%d bands, band %d", n, l);
            for (i = 0; i < 2 * l + 1; i++)
                for (j = 0; j < 2 * l + 1; j++) {
                    long double sum = 0, gram = 0;
                    for (d = 0; d < lobe_count; d++) {
                        sum += weights[(l * l + i) * lobe_count + d] * scale * y[d][l * l + j];
                        gram += scale * scale * y[d][l * l + i] * y[d][l * l + j];
                    }
                    a[i][j] = gram;
                    row_check(identity, sum, i == j, 16 * (long double)DBL_EPSILON, i);
                }
            for (k = 0; k < 2; k++) {       /* largest eigenvalue, then of (largest - A) */
                for (i = 0; i < 2 * l + 1; i++) v[i] = 1 + i % 3 + 0.1L * i;
                for (d = 0; d < 4000; d++) {
                    long double w[31], norm = 0;
                    for (i = 0; i < 2 * l + 1; i++) {
                        w[i] = 0;
                        for (j = 0; j < 2 * l + 1; j++)
                            w[i] += (k ? (i == j ? high : 0) - a[i][j] : a[i][j]) * v[j];
                        norm += w[i] * w[i];
                    }
                    norm = sqrtl(norm);
                    if (norm == 0) break;
                    for (i = 0; i < 2 * l + 1; i++) v[i] = w[i] / norm;
                    if (k) low = high - norm;
                    else high = norm;
                }
            }
            if (l == 0) low = high;
            row_check(condition, sqrtl(high / low), 0, documented[s], l);
        }
    }
    row_close(identity);
    row_close(unit);
    row_close(condition);
}

/* n-point rules integrate x^0 .. x^(2n-1) */
static void rules(void **state)
{
    row *w = row_open("Gauss rules integrate 2n-1 powers", "f64");
    int n, i, p;
    (void)state;
    for (n = 1; n <= 16; n++)
        for (p = 0; p < 2 * n; p++) {
            long double sum = 0;
            row_case("%d points, power %d", n, p);
            for (i = 0; i < n; i++) {
                double weight;
                const double x = shi_gauss_node(n, i, &weight);
                sum += weight * powl(2 * (long double)x - 1, p);
            }
            row_check(w, sum, p % 2 ? 0 : 1.0L / (p + 1), 4 * (long double)DBL_EPSILON, p);
        }
    row_close(w);
}

/* gcc 12 -O3 -march=native drops the rounding of a (double)(float) chain it vectorises */
static double as_float(double x)
{
    volatile float f = (float)x;
    return (double)f;
}

#include "both.h"

int main(void)
{
    const struct CMUnitTest t[] = { cmocka_unit_test(lobes), cmocka_unit_test(rules),  BOTH_TESTS(sums),
                                    BOTH_TESTS(lanes),       BOTH_TESTS(grids),        BOTH_TESTS(on_light),
                                    BOTH_TESTS(statuses),    BOTH_TESTS(zonal),        BOTH_TESTS(route),
                                    BOTH_TESTS(sphere),      BOTH_TESTS(sphere_cases), BOTH_TESTS(within),
                                    BOTH_TESTS(texture),     BOTH_TESTS(many_sided),   BOTH_TESTS(bent),
                                    BOTH_TESTS(bow_tie),     BOTH_TESTS(cancelling),   BOTH_TESTS(exactly),
                                    BOTH_TESTS(folded),      BOTH_TESTS(scales),       BOTH_TESTS(crowd),
                                    BOTH_TESTS(within_far) };
    return RUN_TESTS(t);
}
#else

/* kind as in test_polygon.c; coordinates in T; *per the perimeter in radians, *kappa sum of angle/distance
 * over edges */
static int F(make)(T *v, T *p, int kind, double ratio, double graze)
{
    static const double l_shape[12] = { 0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2 };
    double u[3], w[3], n[3], d = 0, s = 0, az = ref_between(0, 6.283),
                             lateral = sqrt(fabs(1 - graze * graze)) / ratio;
    const int count = kind == 0 || kind == 4 ? 3 : kind == 1 ? 4 : kind == 2 ? 5 : 6;
    int i, k;
    ref_unit(u);
    do {
        ref_unit(w);
        d = u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
    } while (fabs(d) > 0.9);
    for (k = 0; k < 3; k++) {
        w[k] -= d * u[k];
        s += w[k] * w[k];
    }
    for (k = 0; k < 3; k++) w[k] /= sqrt(s);
    n[0] = u[1] * w[2] - u[2] * w[1];
    n[1] = u[2] * w[0] - u[0] * w[2];
    n[2] = u[0] * w[1] - u[1] * w[0];
    for (i = 0; i < count; i++) {
        const double a = 6.283185307 * (i + ref_between(-0.3, 0.3)) / count;
        double x = kind == 3 ? l_shape[2 * i] - 0.8 : cos(a),
               y = kind == 3 ? l_shape[2 * i + 1] - 0.8 : sin(a);
        if (kind == 4) {
            x = i ? 1 : -1;
            y = i == 2 ? 0.002 : 0;
        }
        for (k = 0; k < 3; k++) v[3 * i + k] = (T)as_float(x * u[k] + y * w[k]);
    }
    for (k = 0; k < 3; k++)
        p[k] = (T)as_float(n[k] * graze / ratio + lateral * (cos(az) * u[k] + sin(az) * w[k]));
    return count;
}

/* what the documented bounds of the fast path are made of: perimeter seen, sum of edge angle / edge distance,
 * angular diameter */
static void F(measure)(const T *v, const T *p, int count, long double *perimeter, long double *kappa,
                       long double *nearest, long double *size)
{
    long double center[3] = { 0, 0, 0 }, radius = 0, distance = 0;
    int i, k;
    for (i = 0; i < 3 * count; i++) center[i % 3] += (long double)v[i] / count;
    for (i = 0; i < count; i++) {
        long double r = 0;
        for (k = 0; k < 3; k++)
            r += ((long double)v[3 * i + k] - center[k]) * ((long double)v[3 * i + k] - center[k]);
        if (r > radius) radius = r;
    }
    radius = sqrtl(radius);
    for (k = 0; k < 3; k++) distance += ((long double)p[k] - center[k]) * ((long double)p[k] - center[k]);
    distance = sqrtl(distance);
    *size = distance > 4 * radius ? 2 * radius / (distance - radius) : 100;
    *perimeter = *kappa = 0;
    *nearest = 1e300L;
    for (i = 0; i < count; i++) {
        const T *const a = v + 3 * i, *const b = v + 3 * ((i + 1) % count);
        long double x[3], y[3], c = 0, d = 0, e = 0, s = 0, t = 0, g;
        for (k = 0; k < 3; k++) {
            x[k] = (long double)a[k] - (long double)p[k];
            y[k] = (long double)b[k] - (long double)p[k];
            d += x[k] * y[k];
            e += (y[k] - x[k]) * (y[k] - x[k]);
            s -= x[k] * (y[k] - x[k]);
        }
        for (k = 0; k < 3; k++) {
            const long double h = x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3];
            c += h * h;
        }
        g = atan2l(sqrtl(c), d);
        s = e > 0 ? s / e : 0;
        s = s < 0 ? 0 : s > 1 ? 1 : s;
        for (k = 0; k < 3; k++) t += (x[k] + s * (y[k] - x[k])) * (x[k] + s * (y[k] - x[k]));
        t = sqrtl(t);
        *perimeter += g;
        *kappa += g / t;
        if (t < *nearest) *nearest = t;
    }
}

/* one polygon, one point: sh_polygons_n against sh_polygon, with the bound of the header */
static void F(sums)(void **state)
{
    static const int bands_of[5] = { 1, 3, 5, 9, 16 };
    row *values = row_open("sh_polygons_n values", PRECISION),
        *gradient = row_open("sh_polygons_n gradient", PRECISION);
    int i, k, a;
    (void)state;
    for (i = 0; i < effort(4000); i++) {
        T v[18], p[3], out[1024];
        double vd[18], pd[3], c[256], g[768], spread;
        const int n = bands_of[i / 5 % 5], kind = i % 5;
        const double ratio = ref_log_between(1e-5, 4),
                     graze = i % 3 ? ref_between(0.1, 1) : ref_log_between(1e-6, 1);
        const int count = F(make)(v, p, kind, ratio, graze);
        long double perimeter, kappa, nearest, size, grazing = 1;
        for (k = 0; k < 3; k++) pd[k] = (double)p[k];
        for (k = 0; k < 3 * count; k++) vd[k] = (double)v[k];
        F(measure)(v, p, count, &perimeter, &kappa, &nearest, &size);
        if (shi_polygon_engine(n, SH_BOTH, 1, pd, (size_t)count, vd, 0, c, g, &spread) || nearest < 1e-3L)
            continue;
        assert_int_equal(F(sh_polygons_n)(n, SH_GRADIENT, 1, SH_BOTH, 1, p, 1, &count, v, NULL, out), SH_OK);
        /* in double, heights above the plane are rounded: by eps of the distance */
        if (!IS_F32) grazing = 1 + 1 / (long double)graze / 4;
        row_case("kind %d, %d bands, size/distance %.1e, sine %.1e", kind, n, ratio, graze);
        {
            const long double large = size * (n + 1) < (IS_F32 ? 1.3L : 1.7L) ? 0 : 1;
            const long double slope = sqrtl((long double)(g[0] * g[0] + g[n * n] * g[n * n]
                                                          + g[2 * n * n] * g[2 * n * n]))
                                    * sqrtl(4 * REF_PI);
            for (k = 0; k < n * n; k++) {
                const int l = ref_band(k);
                row_check(values, (long double)out[k], (long double)c[k],
                    64 * (long double)EPS * ref_M(l) * (spread * grazing + large * perimeter / 2), k);
                for (a = 0; a < 3; a++)
                    row_check(gradient, (long double)out[(a + 1) * n * n + k], (long double)g[a * n * n + k],
                              64 * (long double)EPS
                                  * ((ref_M(l) * slope + ref_G(l) * spread / nearest) * grazing
                                     + 2 * large * ref_M(l) * kappa),
                              (a + 1) * n * n + k);
            }
        }
    }
    row_close(values);
    row_close(gradient);
}

/* polygons of many sides beside points in the plane of one of them: the sum of sh_polygon's */
static void F(many_sided)(void **state)
{
    enum { BANDS = 6, N = BANDS * BANDS, POINTS = 11, SIDES = 64 };
    row *values = row_open("discs of 3 to 64 sides, values", PRECISION),
        *gradient = row_open("discs of 3 to 64 sides, gradient", PRECISION);
    static T v[3 * (SIDES + 3)], p[3 * POINTS], out[POINTS * 4 * N];
    static const T triangle[9] = { 5, 0, 3, 6, 0, 3, 5, 1, 3 };
    int sides, i, j, k, a;
    (void)state;
    for (sides = 3; sides <= SIDES; sides += sides < 20 ? 1 : 11) {
        const int counts[2] = { sides, 3 };
        for (i = 0; i < sides; i++) {
            const double at = 6.283185307179586 * i / sides;
            v[3 * i] = (T)cos(at);
            v[3 * i + 1] = (T)sin(at);
            v[3 * i + 2] = 0;
        }
        memcpy(v + 3 * sides, triangle, sizeof triangle);
        for (i = 0; i < 3 * POINTS; i++) p[i] = (T)ref_between(-2, 2);
        p[2] = p[14] = 0;                                   /* in the disc's plane, outside */
        p[0] = p[12] = 4;
        p[5] = p[23] = 3;                                   /* in the triangle's */
        assert_int_equal(F(sh_polygons_n)(BANDS, SH_GRADIENT, 1, SH_BOTH, POINTS, p, 2, counts, v, NULL, out), SH_OK);
        for (i = 0; i < POINTS; i++) {
            double want[4 * N];
            long double perimeter = 0, kappa = 0, closest = 1e300L;
            memset(want, 0, sizeof want);
            for (j = 0; j < 2; j++) {
                const T *const from = j ? v + 3 * sides : v;
                double vd[3 * SIDES], pd[3], c[N], g[3 * N];
                long double around, edges, nearest, size;
                for (k = 0; k < 3; k++) pd[k] = (double)p[3 * i + k];
                for (k = 0; k < 3 * counts[j]; k++) vd[k] = (double)from[k];
                assert_int_equal(shi_polygon_engine(BANDS, SH_BOTH, 1, pd, (size_t)counts[j], vd, 0, c, g, NULL), SH_OK);
                for (k = 0; k < N; k++) want[k] += c[k];
                for (k = 0; k < 3 * N; k++) want[N + k] += g[k];
                F(measure)(from, p + 3 * i, counts[j], &around, &edges, &nearest, &size);
                perimeter += around;
                kappa += edges;
                if (nearest < closest) closest = nearest;
            }
            if (closest < 1e-2L) continue;
            row_case("%d sides, point %d", sides, i);
            for (k = 0; k < N; k++) {
                const long double m = (long double)EPS * ref_M(ref_band(k));
                const T *const got = out + i * 4 * N;
                row_check(values, (long double)got[k], (long double)want[k], m * (64 * 12.6L + 32 * perimeter), k);
                for (a = 1; a < 4; a++)
                    row_check(gradient, (long double)got[a * N + k], (long double)want[a * N + k], m * 192 * kappa, a * N + k);
            }
        }
    }
    row_close(values);
    row_close(gradient);
}

/* the same bits for a point wherever it sits in the batch, and however many there are; values alone are the
 * values */
static void F(lanes)(void **state)
{
    enum { POINTS = 37, N = 36 };
    static T v[3 * 15], p[3 * POINTS], all[POINTS * 4 * N], one[4 * N], values[POINTS * N];
    static const int counts[3] = { 4, 5, 6 };
    int i, k, at = 0;
    (void)state;
    for (i = 0; i < 3; i++) {
        T unused[3];
        at += F(make)(v + 3 * at, unused, i + 1, 1, 0.5);
    }
    for (i = 0; i < 3 * POINTS; i++) p[i] = (T)ref_between(-4, 4);
    for (i = 0; i < 9; i++) p[3 * 8 + i] = p[i % 3];            /* a vector of like points */
    assert_int_equal(F(sh_polygons_n)(6, SH_GRADIENT, 1, SH_BOTH, POINTS, p, 3, counts, v, NULL, all), SH_OK);
    assert_int_equal(F(sh_polygons_n)(6, SH_VALUES, 1, SH_BOTH, POINTS, p, 3, counts, v, NULL, values),
                     SH_OK);
    for (i = 0; i < POINTS; i++) {
        /* node counts follow the vector a point shares: equal to the bound, not to the bit */
        F(sh_polygons)(6, SH_GRADIENT, 1, SH_BOTH, p + 3 * i, 3, counts, v, NULL, one);
        for (k = 0; k < N; k++) {
            assert_true(fabs((double)(one[k] - all[4 * N * i + k]))
                        <= 64 * (double)EPS * (double)one[0] * sqrt(2 * ref_band(k) + 1));
            assert_true(fabs((double)(values[N * i + k] - all[4 * N * i + k]))
                        <= 64 * (double)EPS * (double)one[0] * sqrt(2 * ref_band(k) + 1));
        }
    }
}

/* a grid is its nodes, any range of it; channels are separate sums; sides add up */
static void F(grids)(void **state)
{
    enum { N = 16, NODES = 3 * 2 * 4 };
    static T v[3 * 9], p[3 * NODES], grid_out[NODES * 5 * 4 * N], point_out[NODES * 5 * 4 * N],
        single[NODES * 4 * N], radiance[10];
    static const int counts[2] = { 4, 5 };
    static union { F(sh_grid) grid; T out[NODES * 4 * N]; } over;
    F(sh_grid) g = { { -1, -2, (T)-1.5 }, { (T)0.75, 1, (T)0.875 }, { 3, 2, 4 } };
    T unused[3];
    int i, k, c, at;
    (void)state;
    at = F(make)(v, unused, 1, 1, 0.5);
    F(make)(v + 3 * at, unused, 2, 1, 0.5);
    for (i = 0; i < 10; i++) radiance[i] = (T)ref_between(0, 2);
    for (i = 0; i < NODES; i++) {
        p[3 * i] = g.origin[0] + (T)(i % 3) * g.cell[0];
        p[3 * i + 1] = g.origin[1] + (T)(i / 3 % 2) * g.cell[1];
        p[3 * i + 2] = g.origin[2] + (T)(i / 6) * g.cell[2];
    }
    assert_int_equal(
        F(sh_polygons_n)(4, SH_GRADIENT, 5, SH_BOTH, NODES, p, 2, counts, v, radiance, point_out), SH_OK);
    assert_int_equal(
        F(sh_polygons_grid)(4, SH_GRADIENT, 5, SH_BOTH, &g, 0, NODES, 2, counts, v, radiance, grid_out),
        SH_OK);
    assert_memory_equal(grid_out, point_out, sizeof grid_out);
    assert_int_equal(
        F(sh_polygons_grid)(4, SH_GRADIENT, 5, SH_BOTH, &g, 8, 8, 2, counts, v, radiance, grid_out), SH_OK);
    assert_memory_equal(grid_out, point_out + 8 * 20 * N, 8 * 20 * N * sizeof *grid_out);
    for (c = 0; c < 5; c++) {
        assert_int_equal(
            F(sh_polygons_n)(4, SH_GRADIENT, 1, SH_BOTH, NODES, p, 2, counts, v, radiance + 2 * c, single),
            SH_OK);
        for (i = 0; i < NODES; i++)
            for (k = 0; k < 4 * N; k++)
                assert_true(fabs((double)(single[4 * N * i + k] - point_out[(5 * i + c) * 4 * N + k]))
                            <= 64 * (double)EPS * (1 + fabs((double)single[4 * N * i])));
    }
    assert_int_equal(
        F(sh_polygons_grid)(4, SH_GRADIENT, 5, SH_BOTH, &g, 20, 5, 2, counts, v, radiance, grid_out),
        SH_ERROR_COUNT);
    over.grid = g;
    assert_int_equal(F(sh_polygons_grid)(4, SH_GRADIENT, 1, SH_BOTH, &over.grid, 0, NODES, 2, counts, v, NULL, over.out),
                     SH_ERROR_OVERLAP);
}

/* points in the plane of a light, within a batch of others: as sh_polygon */
static void F(on_light)(void **state)
{
    static const T v[12] = { -1, -1, 0, 3, -1, 0, 3, 3, 0, -1, 3, 0 };
    static const T p[15] = { 0, 0, 1, (T)0.5, 1, 0, 5, 5, 0, 1, -1, 0, 3, 3, 0 };
    static const int counts[1] = { 4 };
    T out[5 * 256], c[64], g[192];
    int i, k;
    (void)state;
    assert_int_equal(F(sh_polygons_n)(8, SH_GRADIENT, 1, SH_BOTH, 5, p, 1, counts, v, NULL, out),
                     SH_ON_LIGHT);
    for (i = 1; i < 5; i++) {
        F(sh_polygon)(8, SH_BOTH, p + 3 * i, 4, v, c, g);
        for (k = 0; k < 64; k++) assert_true(out[256 * i + k] == c[k]);
        for (k = 0; k < 192; k++) assert_true(out[256 * i + 64 + k] == g[k]);
    }
    assert_int_equal(F(sh_polygons_zonal_n)(8, SH_GRADIENT, 1, SH_BOTH, 5, p, 1, counts, v, NULL, out),
                     SH_ON_LIGHT);
    for (i = 1; i < 5; i++) {
        F(sh_polygon)(8, SH_BOTH, p + 3 * i, 4, v, c, g);
        for (k = 0; k < 64; k++) assert_true(out[256 * i + k] == c[k]);
    }
}

static void F(statuses)(void **state)
{
    static const T v[12] = { -1, -1, 0, 3, -1, 0, 3, 3, 0, -1, 3, 0 }, p[3] = { 0, 0, 1 };
    static const int counts[1] = { 4 }, two[1] = { 2 };
    volatile size_t wrapping = (size_t)-1 / 8;     /* a count known when compiling would be a warning */
    T out[64], bad[6] = { 0, 0, 1, 0, 0, 0 };
    int i;
    (void)state;
    for (i = 0; i < 64; i++) out[i] = 7;
    assert_int_equal(F(sh_polygons_n)(4, 2, 1, SH_BOTH, 1, p, 1, counts, v, NULL, out), SH_ERROR_OPTION);
    assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 0, SH_BOTH, 1, p, 1, counts, v, NULL, out), SH_ERROR_COUNT);
    {   /* no radiance is 1 in every channel */
        T one[16], three[48];
        assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 1, SH_BOTH, 1, p, 1, counts, v, NULL, one), SH_OK);
        assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 3, SH_BOTH, 1, p, 1, counts, v, NULL, three), SH_OK);
        for (i = 0; i < 3; i++) assert_memory_equal(three + 16 * i, one, sizeof one);
    }
    assert_int_equal(F(sh_polygons_n)(2, SH_VALUES, 1, SH_BOTH, wrapping, p, 1, counts, v, NULL, out), SH_ERROR_COUNT);
    assert_int_equal(F(sh_polygons_zonal_n)(2, SH_VALUES, 1, SH_BOTH, wrapping, p, 1, counts, v, NULL, out), SH_ERROR_COUNT);
    assert_int_equal(F(sh_polygons_n)(17, SH_VALUES, 1, SH_BOTH, 1, p, 1, counts, v, NULL, out),
                     SH_ERROR_BANDS);
    assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 1, 5, 1, p, 1, counts, v, NULL, out), SH_ERROR_OPTION);
    assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 1, SH_BOTH, 1, NULL, 1, counts, v, NULL, out),
                     SH_ERROR_NULL);
    assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 1, SH_BOTH, 1, p, 1, NULL, v, NULL, out), SH_ERROR_NULL);
    assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 1, SH_BOTH, 1, p, 1, two, v, NULL, out),
                     SH_ERROR_VERTICES);
    assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 1, SH_BOTH, 0, p, 1, counts, v, NULL, out), SH_OK);
    for (i = 0; i < 64; i++) assert_true(out[i] == 7);
    {   /* a point that is not finite leaves its own output only */
        const unsigned char infinity32[4] = { 0, 0, 0x80, 0x7f },
                            infinity64[8] = { 0, 0, 0, 0, 0, 0, 0xf0, 0x7f };
        memcpy(&bad[1], IS_F32 ? infinity32 : infinity64, sizeof bad[1]);
        assert_int_equal(F(sh_polygons_n)(4, SH_VALUES, 1, SH_BOTH, 2, bad, 1, counts, v, NULL, out),
                         SH_ERROR_NOT_FINITE);
        assert_true(out[0] == 7);
    }
    /* no polygons: zeros */
    assert_int_equal(F(sh_polygons_n)(4, SH_GRADIENT, 1, SH_BOTH, 1, p, 0, NULL, NULL, NULL, out), SH_OK);
    for (i = 0; i < 64; i++) assert_true(out[i] == 0);
}

/* zonal integrals: the coefficients projected on the axis; sum over a band of squares by the addition
 * theorem */
static void F(zonal)(void **state)
{
    row *values = row_open("sh_polygon_zonal values", PRECISION),
        *gradient = row_open("sh_polygon_zonal gradient", PRECISION);
    int i, k, l, a;
    (void)state;
    for (i = 0; i < effort(300); i++) {
        T v[18], p[3], axis[3], s[16], sg[48];
        double vd[18], pd[3], u[3], c[256], g[768], spread;
        long double y[256], axis_l[3], perimeter, kappa, nearest, size;
        const double ratio = ref_log_between(1e-5, 4);
        const int count = F(make)(v, p, i % 5, ratio, ref_between(0.05, 1));
        ref_unit(u);
        for (k = 0; k < 3; k++) {
            pd[k] = (double)p[k];
            axis[k] = (T)u[k] * 3;
            axis_l[k] = (long double)axis[k];
        }
        for (k = 0; k < 3 * count; k++) vd[k] = (double)v[k];
        F(measure)(v, p, count, &perimeter, &kappa, &nearest, &size);
        if (shi_polygon_engine(16, SH_BOTH, 1, pd, (size_t)count, vd, 0, c, g, &spread) || nearest < 1e-2L)
            continue;
        ref_values(16, axis_l, y);
        assert_int_equal(F(sh_polygon_zonal)(16, axis, p, (size_t)count, v, s, sg), SH_OK);
        row_case("kind %d, size/distance %.1e, solid angle %.2g", i % 5, ratio, spread);
        for (l = 0; l < 16; l++) {
            long double want = 0, slope[3] = { 0, 0, 0 };
            for (k = l * l; k < (l + 1) * (l + 1); k++) {
                want += 4 * REF_PI / (2 * l + 1) * y[k] * c[k];
                for (a = 0; a < 3; a++) slope[a] += 4 * REF_PI / (2 * l + 1) * y[k] * g[256 * a + k];
            }
            row_check(values, (long double)s[l], want, 64 * (long double)EPS * spread, l);
            for (a = 0; a < 3; a++)
                row_check(gradient, (long double)sg[16 * a + l], slope[a],
                          64 * (long double)EPS * (kappa + spread / nearest * (l + 1)), 16 * a + l);
        }
    }
    row_close(values);
    row_close(gradient);
}

/* WR18's route equals the direct one, absolutely */
static void F(route)(void **state)
{
    row *values = row_open("sh_polygons_zonal_n values", PRECISION),
        *gradient = row_open("sh_polygons_zonal_n gradient", PRECISION);
    int i, k, a, n;
    (void)state;
    for (i = 0; i < effort(300); i++) {
        T v[36], p[3], out[2048], radiance[4] = { 1, 2, (T)0.5, (T)0.25 };
        double sum[256], slope[768], c[256], g[768];
        long double perimeter = 0, kappa = 0, lines = 0;
        int counts[2], j, at = 0, bad = 0;
        n = 1 + i % 16;
        memset(sum, 0, sizeof sum);
        memset(slope, 0, sizeof slope);
        for (j = 0; j < 2; j++) {
            long double one, edge, nearest, size;
            double vd[18], pd[3];
            T q[3];
            counts[j] = F(make)(v + 3 * at, j ? q : p, (i + j) % 5, i % 4 ? ref_between(0.2, 1) : ref_log_between(1e-4, 0.2),
                                ref_between(0.2, 1));
            if (j == 0 && i % 3 == 2) {                     /* nearly in line with an edge, which is seen end-on */
                const double away = ref_between(0.1, 3);
                for (k = 0; k < 3; k++)
                    p[k] = (T)as_float((double)v[k] - away * (double)(v[3 + k] - v[k]) + ref_log_between(1e-7, 0.1));
            }
            for (k = 0; k < 3; k++) pd[k] = (double)p[k];
            for (k = 0; k < 3 * counts[j]; k++) vd[k] = (double)v[3 * at + k];
            F(measure)(v + 3 * at, p, counts[j], &one, &edge, &nearest, &size);
            perimeter += one;
            kappa += edge;
            for (k = 0; k < counts[j]; k++) {               /* distances of the edges' lines */
                const double *const from = vd + 3 * k, *const to = vd + 3 * ((k + 1) % counts[j]);
                long double d[3], r[3], dd = 0, rd = 0, rr = 0;
                for (a = 0; a < 3; a++) {
                    d[a] = (long double)to[a] - (long double)from[a];
                    r[a] = (long double)from[a] - (long double)pd[a];
                    dd += d[a] * d[a];
                    rd += r[a] * d[a];
                    rr += r[a] * r[a];
                }
                lines += 1 / sqrtl(fmaxl(rr - rd * rd / dd, 1e-30L));
            }
            if (nearest < 0.02L) bad = 1;
            if (shi_polygon_engine(n, i % 3, 1, pd, (size_t)counts[j], vd, 0, c, g, NULL)) bad = 1;
            for (k = 0; k < n * n; k++) sum[k] += (double)radiance[j] * c[k];
            for (k = 0; k < 3 * n * n; k++) slope[k] += (double)radiance[j] * g[k];
            at += counts[j];
        }
        if (bad) continue;
        assert_int_equal(F(sh_polygons_zonal_n)(n, SH_GRADIENT, 2, i % 3, 1, p, 2, counts, v, radiance, out),
                         SH_OK);
        row_case("%d bands, sides %d", n, i % 3);
        for (k = 0; k < n * n; k++) {
            const int l = ref_band(k);
            row_check(values, (long double)out[k], (long double)sum[k],
                      24 * (long double)EPS * ref_M(l) * (2 + perimeter), k);
            for (a = 0; a < 3; a++)
                row_check(gradient, (long double)out[(a + 1) * n * n + k], (long double)slope[a * n * n + k],
                          (long double)EPS * ref_M(l) * (128 * kappa + 8 * lines), (a + 1) * n * n + k);
        }
    }
    row_close(values);
    row_close(gradient);
}

/* triangle as sphere against its definition (M22 Eq. 24-28) by jets; its error bound against the exact
 * triangle */
static void F(sphere)(void **state)
{
    row *values = row_open("sh_triangle_as_sphere values", PRECISION),
        *gradient = row_open("sh_triangle_as_sphere gradient", PRECISION);
    row *bound = row_open("sh_triangle_as_sphere error / its bound", PRECISION);
    int i, k, a;
    (void)state;
    for (i = 0; i < effort(200); i++) {
        T v[18], p[3], c[81], g[243], error = 0;
        double vd[9], pd[3], exact[81], spread;
        const double ratio = ref_log_between(1e-4, 0.6), graze = ref_log_between(1e-3, 1);
        ref_jet sphere[81], y[3], normal[3], dot = ref_const(0), d2 = ref_const(0), cosine;
        long double e1[3], e2[3], n[3], area = 0, center[3], point[3], total = 0;
        F(make)(v, p, i % 4 ? 0 : 4, ratio, graze);
        for (k = 0; k < 9; k++) vd[k] = (double)v[k];
        for (k = 0; k < 3; k++) {
            pd[k] = (double)p[k];
            point[k] = (long double)p[k];
            e1[k] = (long double)v[3 + k] - (long double)v[k];
            e2[k] = (long double)v[6 + k] - (long double)v[k];
            center[k] = ((long double)v[k] + (long double)v[3 + k] + (long double)v[6 + k]) / 3;
        }
        for (k = 0; k < 3; k++) {
            n[k] = e1[(k + 1) % 3] * e2[(k + 2) % 3] - e1[(k + 2) % 3] * e2[(k + 1) % 3];
            area += n[k] * n[k];
        }
        area = sqrtl(area);
        for (k = 0; k < 3; k++) {
            normal[k] = ref_const(n[k] / area);
            y[k] = ref_sub(ref_var(point[k], k), ref_const(center[k]));
            d2 = ref_add(d2, ref_mul(y[k], y[k]));
            dot = ref_add(dot,
                          ref_mul(normal[k], ref_sub(ref_var(point[k], k), ref_const((long double)v[k]))));
        }
        cosine = ref_div(dot, ref_sqrt(d2));
        if (cosine.v < 0) cosine = ref_scale(-1, cosine);
        ref_sphere(9, point, center, sqrtl(area / (2 * REF_PI)), sphere);
        assert_int_equal(F(sh_triangle_as_sphere)(9, SH_BOTH, p, v, v + 3, v + 6, c, g, &error), SH_OK);
        row_case("%s, size/distance %.1e, sine %.1e", i % 4 ? "triangle" : "needle", ratio, graze);
        for (k = 0; k < 81; k++) {
            const int l = ref_band(k);
            const long double scale = sqrtl(4 * REF_PI) * sphere[0].v * cosine.v, d = sqrtl(d2.v);
            ref_jet want = ref_mul(cosine, sphere[k]);
            row_check(values, (long double)c[k], want.v, 24 * (long double)EPS * ref_M(l) * scale, k);
            for (a = 0; a < 3; a++)
                row_check(gradient, (long double)g[81 * a + k], want.g[a],
                          32 * (long double)EPS
                              * (ref_M(l) * (2 * scale / d + scale / cosine.v / d) + ref_G(l) * scale / d),
                          81 * a + k);
        }
        if (shi_polygon_engine(9, SH_BOTH, 1, pd, 3, vd, 0, exact, NULL, &spread) == SH_OK) {
            for (k = 0; k < 81; k++) total += ((long double)c[k] - exact[k]) * ((long double)c[k] - exact[k]);
            row_check(bound, sqrtl(total), 0, (long double)error + 256 * (long double)EPS * spread, 0);
        }
    }
    row_close(values);
    row_close(gradient);
    row_close(bound);
}

/* M22's corners: in the plane, without area, inside the sphere, on the centroid; sides */
static void F(sphere_cases)(void **state)
{
    static const T a[3] = { 0, 0, 0 }, b[3] = { 3, 0, 0 }, c[3] = { 0, 3, 0 };
    static const T flat[3] = { 9, 1, 0 }, near[3] = { 1, 1, (T)0.25 }, centroid[3] = { 1, 1, 0 };
    static const T front[3] = { 1, 2, 5 }, behind[3] = { 1, 2, -5 };
    T out[25], g[75], d[25], h[75], error = 0;
    int i;
    (void)state;
    assert_int_equal(F(sh_triangle_as_sphere)(5, SH_BOTH, flat, a, b, c, out, g, NULL), SH_OK);
    for (i = 0; i < 25; i++) assert_true(out[i] == 0);
    for (i = 0; i < 75; i++) assert_true(g[i] == 0);
    assert_int_equal(F(sh_triangle_as_sphere)(5, SH_SIGNED, flat, a, b, c, out, g, NULL), SH_OK);
    assert_true(out[0] == 0 && g[50] > 0);
    assert_int_equal(F(sh_triangle_as_sphere)(5, SH_BOTH, front, a, b, b, out, g, &error), SH_OK);
    for (i = 0; i < 25; i++) assert_true(out[i] == 0);
    assert_true(error == 0);
    assert_int_equal(F(sh_triangle_as_sphere)(5, SH_BOTH, near, a, b, c, out, g, &error), SH_INSIDE);
    assert_true(fabs((double)out[0] - 3.5449077018110320546) < 8 * (double)EPS);
    for (i = 1; i < 25; i++) assert_true(out[i] == 0);
    assert_true((double)error > 1e30);
    assert_int_equal(F(sh_triangle_as_sphere)(5, SH_BOTH, centroid, a, b, c, out, g, &error), SH_INSIDE);
    for (i = 0; i < 25; i++) assert_true(out[i] == 0);
    F(sh_triangle_as_sphere)(5, SH_SIGNED, front, a, b, c, out, g, NULL);
    F(sh_triangle_as_sphere)(5, SH_SIGNED, behind, a, b, c, d, h, NULL);
    assert_true(out[0] > 0 && d[0] == -out[0]);
    F(sh_triangle_as_sphere)(5, SH_FRONT, behind, a, b, c, d, h, NULL);
    for (i = 0; i < 25; i++) assert_true(d[i] == 0);
    for (i = 0; i < 75; i++) assert_true(h[i] == 0);
    assert_int_equal(F(sh_triangle_as_sphere)(33, SH_BOTH, front, a, b, c, out, g, NULL), SH_ERROR_BANDS);
    assert_int_equal(F(sh_triangle_as_sphere)(5, 4, front, a, b, c, out, g, NULL), SH_ERROR_OPTION);
    assert_int_equal(F(sh_triangle_as_sphere)(5, SH_BOTH, front, NULL, b, c, out, g, NULL), SH_ERROR_NULL);
}

/* the guarantee of sh_polygon_within, and that every way is taken */
/* Needles from so far that a plain sum of position and edge would lose their width. */
static void F(within_far)(void **state)
{
    row *w = row_open("sh_polygon_within, needles from afar", PRECISION);
    int turn, i;
    (void)state;
    for (turn = 0; turn < effort(300); turn++) {
        const double width = pow(10, ref_between(-7, 0)), distance = pow(10, ref_between(1, 8));
        const T v[9] = { 0, 0, 0, 1, 0, 0, (T)0.5, (T)width, 0 };
        T p[3], c[9], want[9], error;
        double u[3];
        int used;
        long double norm = 0;
        ref_unit(u);
        if (fabs(u[2]) < 1e-3) continue;
        for (i = 0; i < 3; i++) p[i] = (T)(distance * u[i]);
        assert_int_equal(F(sh_polygon)(3, SH_BOTH, p, 3, v, want, NULL), SH_OK);
        for (i = 0; i < 9; i++) norm += (long double)want[i] * (long double)want[i];
        norm = sqrtl(norm);
        assert_int_equal(F(sh_polygon_within)(3, SH_BOTH, (T)(1e-3L * norm), p, 3, v, c, NULL, &error, &used), SH_OK);
        row_case("width %g distance %g used %d", width, distance, used);
        for (i = 0; i < 9; i++) row_check(w, c[i], want[i], (long double)error + 128 * (long double)EPS * norm, i);
    }
    row_close(w);
}

/* Points in the plane of a parallelogram that rounding has bent: never light from the wrong side, and the calls agree. */
static void F(bent)(void **state)
{
    row *w = row_open("parallelograms bent by rounding, in plane", PRECISION);
    const int four = 4;
    int turn, i, k, side;
    (void)state;
    for (turn = 0; turn < effort(4000); turn++) {
        T v[12], p[3], one[3][4], many[3][4];
        double u[3], t[3], a = ref_between(-0.5, 1.5), b = ref_between(-0.5, 1.5), c = 0;
        for (k = 0; k < 3; k++) {
            u[k] = ref_between(-1, 1);
            t[k] = ref_between(-1, 1);
        }
        for (k = 0; k < 3; k++) c += pow(u[(k + 1) % 3] * t[(k + 2) % 3] - u[(k + 2) % 3] * t[(k + 1) % 3], 2);
        if (c < 0.04 || fabs(fmax(fabs(a - 0.5), fabs(b - 0.5)) - 0.5) < 0.02) continue;    /* thin, or next to an edge */
        for (k = 0; k < 3; k++) {
            v[k] = 0;
            v[3 + k] = (T)u[k];
            v[6 + k] = (T)(u[k] + t[k]);
            v[9 + k] = (T)t[k];
            p[k] = (T)(u[k] * a + t[k] * b);
        }
        row_case("turn %d, %g %g", turn, a, b);
        for (side = SH_BOTH; side <= SH_SIGNED; side++) {
            assert_true(F(sh_polygon)(2, side, p, 4, v, one[side], NULL) >= 0);
            assert_true(F(sh_polygons)(2, SH_VALUES, 1, side, p, 1, &four, v, NULL, many[side]) >= 0);
            for (i = 0; i < 4 && IS_F32; i++)        /* in double the height itself is rounded, and with it which side it is */
                row_check(w, many[side][i], one[side][i], 400 * (long double)EPS * ref_M(i > 0), i);
        }
        row_check(w, many[SH_BOTH][0], one[SH_BOTH][0], 400 * (long double)EPS * ref_M(0), 0);
        assert_true((double)one[SH_BOTH][0] > -1e-12);
        assert_true(one[SH_FRONT][0] == 0 || one[SH_FRONT][0] == one[SH_BOTH][0]);
        assert_true(one[SH_SIGNED][0] == one[SH_BOTH][0] || one[SH_SIGNED][0] == -one[SH_BOTH][0]);
    }
    row_close(w);
}

/* A polygon that crosses itself: its side is that of its signed area in every call, from where the smaller lobe fills more of
 * the view too. */
static void F(bow_tie)(void **state)
{
    row *w = row_open("bow tie, three calls", PRECISION);
    const int four = 4;
    int turn, side, i;
    (void)state;
    for (turn = 0; turn < effort(600); turn++) {
        const T cut = (T)ref_between(0.2, 0.8);
        const T v[12] = { 0, 0, 0, 2, 1, 0, 2, 0, 0, 0, cut, 0 };
        const T p[3] = { (T)ref_between(-1, 3), (T)ref_between(-1, 2), (T)((turn & 1 ? 1 : -1) * ref_between(0.05, 1)) };
        for (side = SH_BOTH; side <= SH_SIGNED; side++) {
            T one[25], many[25], zonal[25];
            assert_int_equal(F(sh_polygon)(5, side, p, 4, v, one, NULL), SH_OK);
            assert_int_equal(F(sh_polygons)(5, SH_VALUES, 1, side, p, 1, &four, v, NULL, many), SH_OK);
            assert_int_equal(F(sh_polygons_zonal_n)(5, SH_VALUES, 1, side, 1, p, 1, &four, v, NULL, zonal), SH_OK);
            row_case("turn %d, side %d", turn, side);
            for (i = 0; i < 25; i++) {
                row_check(w, (long double)many[i], (long double)one[i], 400 * (long double)EPS * ref_M(ref_band(i)), i);
                row_check(w, (long double)zonal[i], (long double)one[i], 24 * (long double)EPS * ref_M(ref_band(i)) * (2 + 8), i);
            }
        }
    }
    row_close(w);
}

/* A whole number from -2^bits to 2^bits. */
static long long F(whole)(int bits) { return llround(ref_between(-1, 1) * ldexp(1, bits)); }

/* Bow ties of whole numbers whose halves cancel exactly, in any plane: every point is behind. */
static void F(cancelling)(void **state)
{
    const int six = 6;
    int turn, side, i, k;
    (void)state;
    for (turn = 0; turn < effort(2000); turn++) {
        long long u[2][3], at[6][2] = { { -1, -1 }, { 1, 1 }, { 1, -1 }, { -1, 1 }, { -1, -1 }, { -1, -1 } }, area = turn % 8;
        const int from = (int)ref_between(0, 5.99);
        T v[18], p[3], one[25], many[25], zonal[25];
        for (i = 0; i < 2; i++)
            for (k = 0; k < 3; k++) u[i][k] = turn % 2 ? i == k : F(whole)(8);
        while (area) {
            for (i = 0; i < 12; i++) at[i / 2][i % 2] = F(whole)(2);
            for (area = 0, i = 0; i < 6; i++) area += at[i][0] * at[(i + 1) % 6][1] - at[i][1] * at[(i + 1) % 6][0];
        }
        for (i = 0; i < 6; i++)
            for (k = 0; k < 3; k++) v[3 * i + k] = (T)(at[(i + from) % 6][0] * u[0][k] + at[(i + from) % 6][1] * u[1][k]);
        for (k = 0; k < 3; k++) p[k] = (T)ref_between(-8, 8);
        if (turn % 8 == 0) p[0] = p[1] = 0;
        for (side = SH_FRONT; side >= SH_BOTH; side--) {
            assert_int_equal(F(sh_polygon)(5, side, p, 6, v, one, NULL), SH_OK);
            assert_int_equal(F(sh_polygons)(5, SH_VALUES, 1, side, p, 1, &six, v, NULL, many), SH_OK);
            assert_int_equal(F(sh_polygons_zonal_n)(5, SH_VALUES, 1, side, 1, p, 1, &six, v, NULL, zonal), SH_OK);
            for (i = 0; i < 25; i++) {
                const T near = 4000 * EPS * (side == SH_BOTH);
                assert_true(fabsl((long double)many[i] - (long double)one[i]) <= (long double)near);
                assert_true(fabsl((long double)zonal[i] - (long double)one[i]) <= (long double)near);
                assert_true(side != SH_FRONT || one[i] == 0);
            }
        }
    }
}

/* Points exactly in a tilted triangle, on its edge, and in its plane outside, of whole numbers. */
static void F(exactly)(void **state)
{
    row *w = row_open("points in tilted planes", PRECISION);
    const int three = 3;
    int turn, i, k;
    (void)state;
    for (turn = 0; turn < effort(6000); turn++) {
        const int bits = IS_F32 ? 6 + turn / 3 % 16 : 6 + turn / 3 % 44, kind = turn % 3;
        const int want = kind == 2 ? SH_OK : SH_ON_LIGHT;
        long double area = 0;
        T v[9], p[3], one[9], slope[27], many[36];
        for (i = 0; i < 9; i++) v[i] = (T)(4 * F(whole)(bits - 2));
        for (k = 0; k < 3; k++)
            p[k] = kind == 0 ? v[k] / 2 + v[3 + k] / 4 + v[6 + k] / 4 : kind == 1 ? (v[k] + v[3 + k]) / 2 : v[k] + v[3 + k] - v[6 + k];
        row_case("kind %d, %d bits", kind, bits);
        for (k = 0; k < 3; k++) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            area += fabsl(((long double)v[3 + a] - v[a]) * ((long double)v[6 + b] - v[b])
                          - ((long double)v[3 + b] - v[b]) * ((long double)v[6 + a] - v[a]));
        }
        if (area == 0) continue;
        assert_int_equal(F(sh_polygon)(3, SH_BOTH, p, 3, v, one, slope), want);
        assert_int_equal(F(sh_polygons)(3, SH_GRADIENT, 1, SH_BOTH, p, 1, &three, v, NULL, many), want);
        for (i = 0; i < 9; i++) row_check(w, (long double)many[i], (long double)one[i], 64 * (long double)EPS * 4, i);
        for (i = 0; i < 27; i++)
            if (kind == 2) row_check(w, (long double)many[9 + i], 0, 0, i);
    }
    row_close(w);
}

/* Quadrilaterals folded along their diagonal, up to closing: the fan of vertex 0 fills them. */
static void F(folded)(void **state)
{
    row *w = row_open("folded quadrilaterals", PRECISION);
    const int four = 4;
    int turn, i, k, side;
    (void)state;
    for (turn = 0; turn < effort(2000); turn++) {
        const double d = ref_log_between(0.1, 20), up = ref_between(-1, 1) * d;
        const double q[5][3] = { { 0, -5, 0 }, { ref_between(0.5, 3), ref_between(-1, 1), d }, { 0, 5, 0 },
                                 { ref_between(-3, -0.5), ref_between(-1, 1), d }, { ref_between(-1, 1), ref_between(-2, 2), up } };
        T v[12], p[3], one[16], many[16];
        for (i = 0; i < 4; i++)
            for (k = 0; k < 3; k++) v[3 * i + k] = (T)q[i][k];
        for (k = 0; k < 3; k++) p[k] = (T)q[4][k];
        for (side = SH_BOTH; side <= SH_SIGNED; side++) {
            assert_int_equal(F(sh_polygon)(4, side, p, 4, v, one, NULL), SH_OK);
            assert_int_equal(F(sh_polygons)(4, SH_VALUES, 1, side, p, 1, &four, v, NULL, many), SH_OK);
            row_case("depth %g, height %g, side %d", d, up, side);
            for (i = 0; i < 16; i++)
                row_check(w, (long double)many[i], (long double)one[i], (1000 + 32 * 20) * (long double)EPS * ref_M(ref_band(i)), i);
        }
    }
    row_close(w);
}

/* Many small polygons in one place, whose roundings agree. */
static void F(crowd)(void **state)
{
    enum { MOST = 20000 };
    static T v[9 * MOST];
    static int counts[MOST];
    row *w = row_open("many polygons in one place", PRECISION);
    int turn, i, k;
    (void)state;
    for (turn = 0; turn < effort(40); turn++) {
        const int many = (int)ref_log_between(100, turn % 10 ? 4000 : MOST);
        const T p[3] = { 0, 0, 0 };
        double pd[3] = { 0, 0, 0 }, vd[9], want[9], size;
        T got[9];
        for (i = 0; i < 9; i++) v[i] = (T)(ref_between(-0.1, 0.1) + (i % 3 == 2 ? 2 : 0));
        for (i = 9; i < 9 * many; i++) v[i] = v[i - 9];
        for (i = 0; i < many; i++) counts[i] = 3;
        for (i = 0; i < 9; i++) vd[i] = (double)v[i];
        (void)shi_polygon_engine(3, SH_BOTH, 1, pd, 3, vd, 0, want, NULL, &size);
        assert_int_equal(F(sh_polygons)(3, SH_VALUES, 1, SH_BOTH, p, (size_t)many, counts, v, NULL, got), SH_OK);
        row_case("%d triangles of solid angle %g", many, size);
        for (k = 0; k < 9; k++)
            row_check(w, (long double)got[k], many * (long double)want[k],
                      (64 + (many < 128 ? many : 128) / 2.0L + many / 256.0L) * many * (long double)size * (long double)EPS * ref_M(ref_band(k)), k);
    }
    row_close(w);
}

/* Scenes at every power of two: the same coefficients. */
static void F(scales)(void **state)
{
    row *w = row_open("scenes of any size", PRECISION);
    const int three = 3;
    T unit[12], want[25];
    int scene, power, i;
    (void)state;
    for (scene = 0; scene < effort(30); scene++)
        for (power = 0; power <= (IS_F32 ? 100 : 900); power++) {
            const int e = power % 2 ? -(power + 1) / 2 : power / 2;
            T v[12], many[100];
            for (i = 0; i < 12; i++) {
                if (power == 0) unit[i] = (T)ref_between(-1, 1);
                v[i] = (T)ldexp((double)unit[i], e);
            }
            assert_int_equal(F(sh_polygons)(5, SH_GRADIENT, 1, SH_BOTH, v + 9, 1, &three, v, NULL, many), SH_OK);
            if (power == 0) memcpy(want, many, sizeof want);
            row_case("scene %d times 2^%d", scene, e);
            for (i = 0; i < 25; i++)
                row_check(w, (long double)many[i], (long double)want[i], 2000 * (long double)EPS * ref_M(ref_band(i)), i);
        }
    row_close(w);
}

static void F(within)(void **state)
{
    row *w = row_open("sh_polygon_within error / its bound", PRECISION),
        *given = row_open("... / tolerance", PRECISION);
    int ways[4] = { 0, 0, 0, 0 }, i, k;
    (void)state;
    for (i = 0; i < effort(1500); i++) {
        T v[18], p[3], c[81], error = 0;
        double vd[18], pd[3], exact[81], spread;
        long double total = 0;
        const double ratio = ref_log_between(1e-3, 2), tolerance = ref_log_between(1e-8, 1e-1);
        const int count = F(make)(v, p, i % 5, ratio, ref_between(0.02, 1)), n = 1 + i % 9;
        int used;
        for (k = 0; k < 3; k++) pd[k] = (double)p[k];
        for (k = 0; k < 3 * count; k++) vd[k] = (double)v[k];
        if (shi_polygon_engine(n, SH_SIGNED, 1, pd, (size_t)count, vd, 0, exact, NULL, &spread)) continue;
        assert_int_equal(
            F(sh_polygon_within)(n, SH_SIGNED, (T)tolerance, p, (size_t)count, v, c, NULL, &error, &used),
            SH_OK);
        for (k = 0; k < n * n; k++) total += ((long double)c[k] - exact[k]) * ((long double)c[k] - exact[k]);
        row_case("kind %d, %d bands, size/distance %.1e, tolerance %.1e, way %d", i % 5, n, ratio, tolerance,
                 used);
        row_check(w, sqrtl(total), 0, (long double)error + 64 * (long double)EPS * spread * n, 0);
        row_check(given, sqrtl(total), 0, (long double)tolerance + 64 * (long double)EPS * spread * n, 0);
        ways[used]++;
    }
    for (i = 0; i < 4; i++) assert_true(ways[i] >= effort(1500) / 75 || effort(1500) < 400);
    {   /* the center of one triangle of the fan at the point, of a quadrilateral that is not flat: nothing bounds that */
        static const T v[12] = { 1, (T)-0.125, 0, -2, 0, 0, 1, (T)0.125, 0, 1, 0, (T)0.25 }, p[3] = { 0, 0, 0 };
        T c[4], exact[4], error = 0;
        long double total = 0;
        int used = 0;
        assert_int_equal(F(sh_polygon)(2, SH_SIGNED, p, 4, v, exact, NULL), SH_OK);
        assert_int_equal(F(sh_polygon_within)(2, SH_SIGNED, (T)0.5, p, 4, v, c, NULL, &error, &used), SH_OK);
        for (k = 0; k < 4; k++) total += ((long double)c[k] - exact[k]) * ((long double)c[k] - exact[k]);
        row_case("a point in the middle of a fan triangle, way %d", used);
        row_check(w, sqrtl(total), 0, (long double)error + 64 * (long double)EPS * 13, 0);
    }
    row_close(w);
    row_close(given);
}

/* texels apart, merged, and left out; the pieces tile the quad */
static void F(texture)(void **state)
{
    enum { W = 5, H = 7 };
    static const T quad[12] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 }, p[3] = { (T)0.25, (T)0.5, 1 };
    static T texels[H * W * 2], vertices[W * H * 12], radiance[2 * W * H], out[2 * 25], merged[2 * 25],
        whole[25];
    row *w = row_open("sh_textured_quad", PRECISION);
    int counts[W * H], i, k;
    size_t pieces, n;
    (void)state;
    for (i = 0; i < H * W; i++) {
        texels[2 * i] = 1;
        texels[2 * i + 1] = i % W < 2 ? (T)0.5 : (T)(0.5 + 0.01 * ref_between(-1, 1));
    }
    assert_int_equal(F(sh_textured_quad)(quad, W, H, 2, texels, (T)0.02, 0, &pieces, NULL, NULL, NULL),
                     SH_OK);
    assert_int_equal(pieces, 1);
    assert_int_equal(
        F(sh_textured_quad)(quad, W, H, 2, texels, 0, W * H, &pieces, counts, vertices, radiance), SH_OK);
    assert_true(pieces > 1 && pieces <= W * H);
    assert_int_equal(F(sh_polygons)(5, SH_VALUES, 2, SH_BOTH, p, pieces, counts, vertices, radiance, out),
                     SH_OK);
    F(sh_polygon)(5, SH_BOTH, p, 4, quad, whole, NULL);
    row_case("a channel of one radiance is the quad");
    for (k = 0; k < 25; k++)
        row_check(w, (long double)out[k], (long double)whole[k],
                  64 * (long double)EPS * ref_M(ref_band(k)) * 3.6L, k);
    for (i = 0; i < 4; i++) {
        const T tolerance = (T)(0.002 * (1 << i));
        double size = 0, error = 0;
        assert_int_equal(
            F(sh_textured_quad)(quad, W, H, 2, texels, tolerance, W * H, &n, counts, vertices, radiance),
            SH_OK);
        assert_true(n <= pieces);
        F(sh_polygons)(5, SH_VALUES, 2, SH_BOTH, p, n, counts, vertices, radiance, merged);
        row_case("merged within %g: %d pieces", (double)tolerance, (int)n);
        for (k = 0; k < 25; k++) {
            size += (double)whole[k] * (double)whole[k];
            error += (double)(merged[25 + k] - out[25 + k]) * (double)(merged[25 + k] - out[25 + k]);
        }
        row_check(w, sqrtl((long double)error), 0,
                  (long double)tolerance * 2 * sqrtl((long double)size) + 64 * (long double)EPS, 25);
    }
    for (i = 0; i < H * W * 2; i++) texels[i] = 0;
    texels[2 * 17] = 3;
    assert_int_equal(F(sh_textured_quad)(quad, W, H, 2, texels, 0, W * H, &n, counts, vertices, radiance),
                     SH_OK);
    assert_int_equal(n, 1);
    assert_true(radiance[0] == 3 && radiance[1] == 0);
    row_case("one texel lit: its square");
    {
        const T square[12] = { (T)(-1 + 2 * 2 / 5.), (T)(-1 + 2 * 3 / 7.), 0,
                               (T)(-1 + 2 * 3 / 5.), (T)(-1 + 2 * 3 / 7.), 0,
                               (T)(-1 + 2 * 3 / 5.), (T)(-1 + 2 * 4 / 7.), 0,
                               (T)(-1 + 2 * 2 / 5.), (T)(-1 + 2 * 4 / 7.), 0 };
        for (k = 0; k < 12; k++)
            row_check(w, (long double)vertices[k], (long double)square[k], 4 * (long double)EPS, k);
    }
    for (i = 0; i < 3; i++) {                               /* NaN and infinity stay where they are */
        static const T bad[3] = { (T)NAN, (T)INFINITY, -(T)INFINITY };
        int lost = 0;
        for (k = 0; k < H * W * 2; k++) texels[k] = 1;
        texels[2 * 17] = bad[i];
        assert_int_equal(F(sh_textured_quad)(quad, W, H, 2, texels, 1, W * H, &n, counts, vertices, radiance), SH_OK);
        assert_true(n > 1);
        for (k = 0; k < (int)n; k++)
            if (radiance[k] == 1) assert_true(radiance[n + (size_t)k] == 1);
            else lost++;
        assert_int_equal(lost, 1);
    }
    for (i = 0; i < H * W * 2; i++) texels[i] = 0;
    texels[2 * 17] = 3;
    n = 0;
    assert_int_equal(F(sh_textured_quad)(quad, W, H, 2, texels, 0, 0, &n, counts, vertices, radiance),
                     SH_ERROR_COUNT);
    assert_int_equal(n, 1);                                 /* the number that does not fit */
    assert_int_equal(F(sh_textured_quad)(quad, W, H, 2, texels, 0, W * H, &n, counts, texels, radiance), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_textured_quad)(quad, W, H, 2, texels, 0, W * H, &n, counts, vertices, vertices + 11), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_textured_quad)(quad, W, H, 2, texels, 0, W * H, &n, (int *)(void *)vertices, vertices, radiance),
                     SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_textured_quad)(quad, W, H, 2, texels, 0, W * H, (size_t *)(void *)texels, counts, vertices, radiance),
                     SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_textured_quad)(quad, 0, H, 2, texels, 0, 0, &n, NULL, NULL, NULL), SH_ERROR_COUNT);
    assert_int_equal(F(sh_textured_quad)(NULL, W, H, 2, texels, 0, 0, &n, NULL, NULL, NULL), SH_ERROR_NULL);
    row_close(w);
}

#endif
