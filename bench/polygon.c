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
    FN(sh_polygons_zonal_n)(in->bands, in->gradient ? SH_GRADIENT : SH_VALUES, 1, SH_BOTH, in->points,
                            in->point, 1, &in->sides, in->vertices, NULL, in->out);
}

/* One point per call: full accuracy everywhere, in double inside. */
static void library_one(const bench_case *self)
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

/* The closed form in edge frames in the library's own lanes, with its own geometry of vertices and arcs: what
 * separates it from `library` is closed form against Gauss nodes alone. */
#define CAT3_(a, b, c) a##b##c
#define CAT3(a, b, c)  CAT3_(a, b, c)
#if SH_VECTOR_BYTES == 0
#  define MANY(name) CAT3(FN(name), x, 1)
#elif SH_VECTOR_BYTES * 8 / BENCH_PRECISION == 2
#  define MANY(name) CAT3(FN(name), x, 2)
#elif SH_VECTOR_BYTES * 8 / BENCH_PRECISION == 4
#  define MANY(name) CAT3(FN(name), x, 4)
#else
#  define MANY(name) CAT3(FN(name), x, 8)
#endif
#define V MANY(shi_vector)
#define V_SQRT MANY(shi_sqrt)
#define FRAME(name) name##_lanes
#include "polygon_frame.h"

INLINE void frame_lanes(const int bands, const int gradient, const polygon_input *in)
{
    enum { W = MANY(shi_polygon_lanes), MOST = 4 * POLYGON_MAX_BANDS * POLYGON_MAX_BANDS };
    const int rows = (gradient ? 4 : 1) * bands * bands;
    size_t p;
    for (p = 0; p < in->points; p += W) {
        V x[3], out[MOST], omega;
        MANY(shi_mask) bad;
        MANY(shi_seen) first, a, b;
        MANY(shi_arc_seen) arc;
        int i;
        MANY(shi_load3)(in->point + 3 * p, W, x);
        bad = (MANY(shi_mask))(x[0] != x[0]);
        for (i = 0; i < rows; i++) out[i] = MANY(shi_splat)(0);
        omega = out[0];
        MANY(shi_polygon_see)(x, in->vertices, &first);
        a = first;
        for (i = 0; i < in->sides; i++) {
            const real *from = in->vertices + 3 * i, *to = i + 1 < in->sides ? from + 3 : in->vertices;
            const real e[3] = { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
            V c, s;
            if (i + 1 < in->sides) MANY(shi_polygon_see)(x, to, &b);
            else b = first;
            (void)MANY(shi_polygon_arc)(&a, &b, e, 0, 0, &arc, &bad);
            if (i > 0 && i + 1 < in->sides) {
                const V even = 1 + first.w[0] * a.w[0] + first.w[1] * a.w[1] + first.w[2] * a.w[2]
                             + first.w[0] * b.w[0] + first.w[1] * b.w[1] + first.w[2] * b.w[2]
                             + a.w[0] * b.w[0] + a.w[1] * b.w[1] + a.w[2] * b.w[2];
                double n[3];
                FN(shi_fan_normal)(in->vertices, from, to, n);
                omega += 2 * MANY(shi_polygon_angle)(MANY(shi_polygon_height)(x, in->vertices, n)
                                                     * first.inverse * a.inverse * b.inverse, even);
            }
            MANY(shi_cos_sin_near)(arc.half, &c, &s);
            frame_edge_lanes(bands, gradient, in->frame, arc.mid, arc.along, arc.mu, 2 * arc.half, c, s,
                             arc.k0, arc.k1, out);
            a = b;
        }
        out[0] = omega * C(0.28209479177387814);
        MANY(shi_transpose_block)((const real *)(const void *)out, W, rows, in->out + p * (size_t)rows,
                                  (size_t)rows, W);
    }
}

static void edge_frame_lanes(const bench_case *self)
{
    const polygon_input *in = self->input;
    if (in->gradient) {
        switch (in->bands) {
        BANDS_CASE(3, frame_lanes(BANDS, 1, in);) BANDS_CASE(5, frame_lanes(BANDS, 1, in);)
        BANDS_CASE(9, frame_lanes(BANDS, 1, in);) BANDS_CASE(15, frame_lanes(BANDS, 1, in);)
        default: break;
        }
    } else {
        switch (in->bands) {
        BANDS_CASE(3, frame_lanes(BANDS, 0, in);) BANDS_CASE(5, frame_lanes(BANDS, 0, in);)
        BANDS_CASE(9, frame_lanes(BANDS, 0, in);) BANDS_CASE(15, frame_lanes(BANDS, 0, in);)
        default: break;
        }
    }
}

/* ---- tables of the lobe forms ---- */

/* 2n-1 directions on a spiral over half the sphere: far from the best set, but of condition below 50 in every
 * band, and what they cost does not depend on where they are. */
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

/* The integral of P_l about lobe d is sum over m of B_dm L_lm, B_dm = 4 pi/(2l+1) Y_lm(lobe d): weights are
 * the pseudo-inverse (B^T B)^-1 B^T, by Gauss-Jordan in double. */
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

/* X by a product rule: integrals of Y_i(R u) Y_j(u), R the rotation by 90 degrees about x. */
static polygon_frame *make_frame(int bands)
{
    enum { MAX = POLYGON_MAX_BANDS, SIZE = MAX * MAX };
    static double x[SIZE][SIZE], y[SIZE], turned[SIZE], grad[3 * SIZE];
    const double axis[3] = { 1, 0, 0 };
    polygon_frame *out = bench_alloc(1, sizeof *out);
    int l, i, j, a, b, entries = 0;
    sh_eval_grad_f64(bands, axis, y, grad);
    for (l = 0, i = 0; l < bands; l++)
        for (; i < (l + 1) * (l + 1); i++) {
            out->slope[i] = C(y[i]);
            out->value[i] = l ? C(grad[2 * bands * bands + i] / (l * (l + 1))) : 0;
        }
    memset(x, 0, sizeof x);
    for (a = 0; a < 16; a++)
        for (b = 0; b < 32; b++) {
            double w;
            const double z = 2 * shi_gauss_node(16, a, &w) - 1, r = sqrt(1 - z * z),
                         p = 6.283185307179586 * b / 32;
            const double u[3] = { r * cos(p), r * sin(p), z }, v[3] = { u[0], -u[2], u[1] };
            w *= 2 * 6.283185307179586 / 32;
            sh_eval_f64(bands, u, y);
            sh_eval_f64(bands, v, turned);
            for (l = 0, i = 0; l < bands; l++)
                for (; i < (l + 1) * (l + 1); i++)
                    for (j = l * l; j < (l + 1) * (l + 1); j++) x[i][j] += w * turned[i] * y[j];
        }
    for (l = 0, i = 0; l < bands; l++)
        for (; i < (l + 1) * (l + 1); i++) {
            out->start[i] = entries;
            out->first[i] = out->last[i] = 0;
            for (j = 0; j < 2 * l + 1; j++) {
                if (fabs(x[i][l * l + j]) < 1e-12) continue;
                if (!out->last[i]) out->first[i] = j;
                out->last[i] = j + 1;
            }
            for (j = out->first[i]; j < out->last[i]; j += 2) out->x[entries++] = C(x[i][l * l + j]);
        }
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

    bench_suite(name, BENCH_PRECISION, "point",
                "one polygon seen from 64 points, about as far as it is wide");
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
            /* float: WR18 as printed loses what its lobes' condition and cos^-1 cost; monomials lose a digit
             * more with each band or two, all of them beyond nine. Double shows that both are right. */
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
            in->frame = make_frame(bands);
            in->out = bench_alloc(POINTS * (size_t)(planes * bands * bands), sizeof(real));
            add(in, "library", library, wr);
            add(in, "library_one", library_one, wr);
            add(in, "library_zonal", library_zonal, wr);
            add(in, "edge_frame_lanes", edge_frame_lanes, wr);
            add(in, "edge_frame", FN(polygon_edge_frame), wr);
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
