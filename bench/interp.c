/* interp.c - suite `interp`: lighting at many points from an 8x8x8 grid, by scheme (M22 Table 5). */
#include "sh_interp.h"     /* first: names of ours must not reach it */

#include "bench.h"

#include <string.h>

enum { SIDE = 8, NODES = SIDE * SIDE * SIDE, CHANNELS = 3, POINTS = 256, LIGHTS = 24 };

typedef struct interp_input {
    int bands, scheme, planes;
    size_t n2;
    FN(sh_grid) grid;
    const real *nodes, *points, *transfers;
    real *coeffs, *values;      /* [POINTS][CHANNELS][n2], [POINTS][CHANNELS] */
} interp_input;

static const struct {
    const char *name;
    int scheme, planes;
} schemes[] = {
    { "trilinear", SH_TRILINEAR, SH_VALUES },
    { "half_taylor", SH_HALF_TAYLOR, SH_GRADIENT },
    { "blended_taylor", SH_BLENDED_TAYLOR, SH_GRADIENT },
    { "hermite_zero", SH_HERMITE_ZERO, SH_GRADIENT },
    { "hermite_mixed", SH_HERMITE_MIXED, SH_GRADIENT },
    { "edge_hermite", SH_EDGE_HERMITE, SH_GRADIENT },
    { "blended_taylor2", SH_BLENDED_TAYLOR2, SH_HESSIAN },
};

static void many(const bench_case *self)
{
    const interp_input *in = self->input;
    FN(sh_grid_interp_n)(in->bands, in->planes, CHANNELS, &in->grid, in->nodes, in->scheme, SH_CLAMP, POINTS,
                         in->points, in->coeffs);
}

static void one_by_one(const bench_case *self)
{
    const interp_input *in = self->input;
    size_t i;
    for (i = 0; i < POINTS; i++)
        FN(sh_grid_interp)(in->bands, in->planes, CHANNELS, &in->grid, in->nodes, in->scheme, SH_CLAMP,
                           in->points + 3 * i, in->coeffs + i * CHANNELS * in->n2);
}

/* What `fused` saves: the coefficients written, read again, and multiplied with the transfer vector. */
static void many_then_dot(const bench_case *self)
{
    const interp_input *in = self->input;
    size_t i, c, k;
    many(self);
    for (i = 0; i < POINTS; i++)
        for (c = 0; c < CHANNELS; c++) {
            const real *a = in->coeffs + (i * CHANNELS + c) * in->n2, *b = in->transfers + i * in->n2;
            real s[8] = { 0 };
            for (k = 0; k + 8 <= in->n2; k += 8) {
                size_t j;
                for (j = 0; j < 8; j++) s[j] += a[k + j] * b[k + j];
            }
            for (; k < in->n2; k++) s[0] += a[k] * b[k];
            in->values[i * CHANNELS + c] = ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
        }
}

static void fused(const bench_case *self)
{
    const interp_input *in = self->input;
    FN(sh_grid_dot_n)(in->bands, in->planes, CHANNELS, &in->grid, in->nodes, in->scheme, SH_CLAMP, POINTS, in->points,
                      in->transfers, in->values);
}

static void add(const interp_input *in, const char *kernel, const char *impl, void (*run)(const bench_case *),
                int dot)
{
    bench_case c;
    memset(&c, 0, sizeof c);
    c.kernel = kernel;
    c.impl = impl;
    c.bands = in->bands;
    c.items = POINTS;
    c.run = run;
    c.input = in;
    c.held = POINTS;
    c.tolerance = 200 * REAL_EPS;
    c.out[0].data = dot ? in->values : in->coeffs;
    c.out[0].numbers = CHANNELS * (dot ? 1 : in->n2);
    bench_add(&c);
}

static real *random_numbers(size_t count, double low, double high)
{
    real *p = bench_alloc(count, sizeof(real));
    size_t i;
    for (i = 0; i < count; i++) p[i] = C(low + (high - low) * bench_random());
    return p;
}

void FN(bench_interp)(void)
{
    real *spheres, *radiance;
    const real *points;
    size_t i, k;
    int bands, p;

    bench_suite("interp", BENCH_PRECISION, "point",
                "8x8x8 nodes, 3 channels, scattered points: nodes come from L2 or L3, output from L2");
    spheres = bench_alloc(4 * LIGHTS, sizeof(real));
    radiance = random_numbers(CHANNELS * LIGHTS, 0.2, 1);
    for (i = 0; i < LIGHTS; i++) {
        for (k = 0; k < 3; k++) {
            const double side = bench_random() < 0.5 ? -1 : 1;
            spheres[k * LIGHTS + i] = C(side * (2 + 2 * bench_random()));
        }
        spheres[3 * LIGHTS + i] = C(0.1 + 0.3 * bench_random());
    }
    points = random_numbers(3 * POINTS, -1, 1);
    for (bands = 5; bands <= 9; bands++) {
        const size_t n2 = (size_t)(bands * bands);
        const real *transfers = random_numbers(POINTS * n2, -1, 1);
        real *nodes[SH_HESSIAN + 1] = { NULL };
        FN(sh_grid) grid;
        for (k = 0; k < 3; k++) {
            grid.origin[k] = -1;
            grid.cell[k] = C(2) / C(SIDE - 1);
            grid.count[k] = SIDE;
        }
        for (p = 0; p < 3; p++) {
            static const int planes[3] = { SH_VALUES, SH_GRADIENT, SH_HESSIAN };
            real *out = bench_alloc(NODES * CHANNELS * (size_t)planes[p] * n2, sizeof(real));
            FN(sh_spheres_grid)(bands, planes[p], CHANNELS, &grid, 0, NODES, LIGHTS, spheres, radiance, out);
            nodes[planes[p]] = out;
        }
        for (i = 0; i < sizeof schemes / sizeof schemes[0]; i++) {
            interp_input *in = bench_alloc(1, sizeof *in);
            in->bands = bands;
            in->n2 = n2;
            in->scheme = schemes[i].scheme;
            in->planes = schemes[i].planes;
            in->grid = grid;
            in->nodes = nodes[schemes[i].planes];
            in->points = points;
            in->transfers = transfers;
            in->coeffs = bench_alloc(POINTS * CHANNELS * n2, sizeof(real));
            in->values = bench_alloc(POINTS * CHANNELS, sizeof(real));
            if (bands == 5) bench_base(schemes[i].name, "library");
            add(in, schemes[i].name, "library", many, 0);
            add(in, schemes[i].name, "library_one", one_by_one, 0);
            add(in, schemes[i].name, "library_dot", many_then_dot, 1);
            add(in, schemes[i].name, "fused", fused, 1);
        }
    }
    bench_run();
}
