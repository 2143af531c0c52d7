/* polygon.c - suites `polygon` (triangles), `polygon4`, `polygon8`: one polygon light seen from many points
 * (WR18 Table 2). */
#include "sh_polygon.h"     /* first: names of ours must not reach it */

#include "polygon.h"

#include <math.h>
#include <string.h>

enum { POINTS = 64 };

static const int polygon_bands[] = { 3, 5, 9, 15 };

/* The default: many points per call. */
static void library(const bench_case *self)
{
    const polygon_input *in = self->input;
    FN(sh_polygons_n)(in->bands, in->gradient ? SH_GRADIENT : SH_VALUES, 1, SH_BOTH, in->points, in->point, 1,
                      &in->sides, in->vertices, NULL, in->out);
}

/* WR18's route in its robust form. */
static void library_zonal(const bench_case *self)
{
    const polygon_input *in = self->input;
    FN(sh_polygons_zonal_n)(in->bands, in->gradient ? SH_GRADIENT : SH_VALUES, 1, SH_BOTH, in->points, in->point, 1,
                            &in->sides, in->vertices, NULL, in->out);
}

/* The closed form in each edge's own frame, one point per call: at full accuracy everywhere, in double inside. */
static void edge_frame(const bench_case *self)
{
    const polygon_input *in = self->input;
    const size_t n2 = (size_t)(in->bands * in->bands);
    size_t i;
    for (i = 0; i < in->points; i++) {
        real *out = in->out + i * n2 * (in->gradient ? 4 : 1);
        FN(sh_polygon)(in->bands, SH_BOTH, in->point + 3 * i, (size_t)in->sides, in->vertices, out,
                       in->gradient ? out + n2 : NULL);
    }
}

/* ---- tables of the lobe forms ---- */

/* 2n-1 directions on a spiral over half the sphere: far from the best set, but of condition below 50 in every band,
 * and what they cost does not depend on where they are. */
static real *make_lobes(int bands)
{
    const int lobes = 2 * bands - 1;
    real *out = bench_alloc(3 * (size_t)lobes, sizeof(real));
    int d;
    for (d = 0; d < lobes; d++) {
        const double z = (d + 0.3) / (lobes - 0.4), r = sqrt(1 - z * z), p = 3.883222077450933 * d;
        out[3 * d] = C(r * cos(p));
        out[3 * d + 1] = C(r * sin(p));
        out[3 * d + 2] = C(z);
    }
    return out;
}

/* The integral of P_l about lobe d is sum over m of B_dm L_lm, B_dm = 4 pi/(2l+1) Y_lm(lobe d): weights are the
 * pseudo-inverse (B^T B)^-1 B^T, by Gauss-Jordan in double. */
static real *make_weights(int bands, const real *lobes)
{
    enum { MAX = POLYGON_MAX_BANDS, SIZE = 2 * MAX - 1 };
    static double y[SIZE][MAX * MAX], m[SIZE][2 * SIZE];
    const int count = 2 * bands - 1;
    real *out = bench_alloc((size_t)(bands * bands * count), sizeof(real));
    int l, d, i, j, k;
    for (d = 0; d < count; d++) {
        const double dir[3] = { (double)lobes[3 * d], (double)lobes[3 * d + 1], (double)lobes[3 * d + 2] };
        sh_eval_f64(bands, dir, y[d]);
    }
    for (l = 0; l < bands; l++) {
        const int size = 2 * l + 1, at = l * l;
        const double scale = 12.566370614359172 / size;
        for (i = 0; i < size; i++)
            for (j = 0; j < size; j++) {
                m[i][j] = 0;
                m[i][size + j] = i == j;
                for (d = 0; d < count; d++) m[i][j] += scale * y[d][at + i] * scale * y[d][at + j];
            }
        for (i = 0; i < size; i++) {            /* symmetric positive definite: no pivoting needed */
            const double pivot = 1 / m[i][i];
            for (j = 0; j < 2 * size; j++) m[i][j] *= pivot;
            for (k = 0; k < size; k++) {
                const double f = m[k][i];
                if (k == i) continue;
                for (j = 0; j < 2 * size; j++) m[k][j] -= f * m[i][j];
            }
        }
        for (i = 0; i < size; i++)
            for (d = 0; d < count; d++) {
                double sum = 0;
                for (j = 0; j < size; j++) sum += m[i][size + j] * scale * y[d][at + j];
                out[(at + i) * count + d] = C(sum);
            }
    }
    return out;
}

/* P_l as polynomials, by Bonnet's recurrence. */
static real *make_legendre(int bands)
{
    enum { MAX = POLYGON_MAX_BANDS };
    double p[MAX][MAX];
    real *out = bench_alloc((size_t)(bands * bands), sizeof(real));
    int l, k;
    memset(p, 0, sizeof p);
    p[0][0] = 1;
    for (l = 1; l < bands; l++)
        for (k = 0; k <= l; k++)
            p[l][k] = ((k ? (2 * l - 1) * p[l - 1][k - 1] : 0) - (l > 1 ? (l - 1) * p[l - 2][k] : 0)) / l;
    for (l = 0; l < bands; l++)
        for (k = 0; k < bands; k++) out[l * bands + k] = C(p[l][k]);
    return out;
}

/* ---- registration ---- */

static void add(const polygon_input *in, const char *impl, void (*run)(const bench_case *), double tolerance)
{
    const size_t n2 = (size_t)(in->bands * in->bands);
    bench_case c;
    memset(&c, 0, sizeof c);
    c.kernel = in->gradient ? "gradient" : "values";
    c.impl = impl;
    c.bands = in->bands;
    c.items = in->points;
    c.run = run;
    c.input = in;
    c.held = in->points;
    c.tolerance = tolerance;
    c.out[0].data = in->out;
    c.out[0].planes = in->gradient ? 4 : 1;
    c.out[0].numbers = n2 * c.out[0].planes;
    bench_add(&c);
}

static void suite(const char *name, int sides)
{
    real *points, *vertices;
    size_t i, b;
    int gradient, k;

    bench_suite(name, BENCH_PRECISION, "point", "one polygon seen from 64 points, about as far as it is wide");
    bench_base("values", "wang_ramamoorthi");
    bench_base("gradient", "wang_ramamoorthi");
    points = bench_alloc(3 * POINTS, sizeof(real));
    vertices = bench_alloc(3 * (size_t)sides, sizeof(real));
    for (i = 0; i < 3 * POINTS; i++) points[i] = C(bench_random() - 0.5);
    for (k = 0; k < sides; k++) {               /* a tilted ring above the points, positive about them */
        const double p = 6.283185307179586 * (k + 0.1) / sides;
        vertices[3 * k] = C(cos(p) + 0.3);
        vertices[3 * k + 1] = C(sin(p) - 0.2);
        vertices[3 * k + 2] = C(1.7 + 0.4 * cos(p) - 0.3 * sin(p));
    }
    for (gradient = 0; gradient < 2; gradient++)
        for (b = 0; b < sizeof polygon_bands / sizeof polygon_bands[0]; b++) {
            polygon_input *in = bench_alloc(1, sizeof *in);
            const int bands = polygon_bands[b], planes = gradient ? 4 : 1;
            /* float: WR18 as printed loses what its lobes' condition and cos^-1 cost; monomials lose a digit more
             * with each band or two, all of them beyond nine. Double shows that both are right. */
            const double wr = BENCH_PRECISION == 32 ? 3e-3 : 1e-11;
            const double mono = BENCH_PRECISION == 32 ? (bands <= 5 ? 3e-2 : 0) : 1e-8;
            in->bands = bands;
            in->sides = sides;
            in->gradient = gradient;
            in->points = POINTS;
            in->point = points;
            in->vertices = vertices;
            in->lobes = make_lobes(bands);
            in->weights = make_weights(bands, in->lobes);
            in->legendre = make_legendre(bands);
            in->out = bench_alloc(POINTS * (size_t)(planes * bands * bands), sizeof(real));
            add(in, "library", library, wr);
            add(in, "edge_frame", edge_frame, wr);
            add(in, "library_zonal", library_zonal, wr);
            add(in, "monomial", FN(polygon_monomial), mono);
            add(in, "wang_ramamoorthi", FN(polygon_wang_ramamoorthi), wr);
        }
    bench_run();
}

void FN(bench_polygon)(void)
{
    suite("polygon", 3);
    if (bench_option.quick) return;
    suite("polygon4", 4);
    suite("polygon8", 8);
}
