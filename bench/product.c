/* product.c - suite `product`: lighting times the clamped cosine (MP21 Table 2). */
#include "sh_product.h"     /* first: names of ours must not reach it */

#include "product.h"

#include <math.h>
#include <string.h>

#define PER_VECTOR(name, body)                                                      \
    static void name(const bench_case *self)                                        \
    {                                                                               \
        const product_input *in = self->input;                                      \
        size_t i;                                                                   \
        for (i = 0; i < VECTORS; i++) {                                             \
            const real *c = in->coeffs + i * in->n2, *normal = in->normals + 3 * i; \
            real *out = in->out + i * in->n2;                                       \
            body                                                                    \
        }                                                                           \
    }

/* Eq. 11 in the frame of the normal, and with the rotation there and back. */
PER_VECTOR(world, (void)normal; FN(sh_cosine_product_local)(in->bands, c, out);)
PER_VECTOR(world_rotated, FN(sh_cosine_product)(in->bands, normal, c, out);)
/* This library's general product, by quadrature, and its Eq. 10. */
PER_VECTOR(library_triple, real cosine[256]; FN(sh_zonal_rotate)(in->bands, in->cosine, normal, cosine);
           FN(sh_triple_product)(in->bands, cosine, c, out);)
PER_VECTOR(library_zonal, FN(sh_cosine_product_zonal)(in->bands, in->bands, normal, c, out);)
PER_VECTOR(library_zonal3, FN(sh_cosine_product_zonal)(in->bands, 3, normal, c, out);)

static void world_n(const bench_case *self)
{
    const product_input *in = self->input;
    FN(sh_cosine_product_local_n)(in->bands, VECTORS, in->coeffs, in->out);
}

static void world_rotated_n(const bench_case *self)
{
    const product_input *in = self->input;
    FN(sh_cosine_product_n)(in->bands, VECTORS, in->normals, in->coeffs, in->out);
}

static void world_rotated_blocks(const bench_case *self)
{
    const product_input *in = self->input;
    FN(sh_cosine_product_blocks)(in->bands, VECTORS / 8, in->normal_blocks, in->blocks, in->out_blocks);
}

/* ---- Gaunt coefficients for the baselines, by Gauss-Legendre in z and equal steps in phi ---- */

enum { MAX_BANDS = 9, MAX_N2 = MAX_BANDS * MAX_BANDS, Z_NODES = 13, PHI_NODES = 25, NODES = Z_NODES * PHI_NODES };

static void gauss_legendre(double z[Z_NODES], double w[Z_NODES])
{
    int i, k, step;
    for (i = 0; i < Z_NODES; i++) {
        double x = cos(3.141592653589793 * (i + 0.75) / (Z_NODES + 0.5)), slope = 0;
        for (step = 0; step < 20; step++) {
            double p0 = 1, p1 = x;
            for (k = 2; k <= Z_NODES; k++) {
                const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
                p0 = p1;
                p1 = p2;
            }
            slope = Z_NODES * (x * p1 - p0) / (x * x - 1);
            x -= p1 / slope;
        }
        z[i] = x;
        w[i] = 2 / ((1 - x * x) * slope * slope);
    }
}

static void start_table(gaunt_table *g, size_t n2, size_t most)
{
    g->start = bench_alloc(n2 + 1, sizeof *g->start);
    g->pair = bench_alloc(most, sizeof *g->pair);
    g->c = bench_alloc(most, sizeof *g->c);
}

static void put(gaunt_table *g, int *at, int i, int j, double c)
{
    g->pair[*at][0] = (unsigned char)i;
    g->pair[*at][1] = (unsigned char)j;
    g->c[(*at)++] = C(c);
}

static void make_tables(product_input *in)
{
    static double y[MAX_N2][NODES], yy[NODES];
    const double step = 6.283185307179586 / PHI_NODES;
    double z[Z_NODES], w[Z_NODES], column[256];
    const int n2 = (int)in->n2;
    int i, j, k, q, general = 0, zonal = 0, zonal3 = 0;
    gauss_legendre(z, w);
    for (q = 0; q < NODES; q++) {
        const double zq = z[q / PHI_NODES], r = sqrt(1 - zq * zq), p = step * (q % PHI_NODES);
        const double dir[3] = { r * cos(p), r * sin(p), zq };
        sh_eval_f64(in->bands, dir, column);
        for (i = 0; i < n2; i++) y[i][q] = column[i];
    }
    start_table(&in->general, in->n2, 12200);           /* 9 bands: 23621 terms, the symmetric ones once */
    start_table(&in->zonal, in->n2, 24000);
    start_table(&in->zonal3, in->n2, 24000);
    for (k = 0; k < n2; k++) {
        in->general.start[k] = general;
        in->zonal.start[k] = zonal;
        in->zonal3.start[k] = zonal3;
        for (i = 0; i < n2; i++) {
            for (q = 0; q < NODES; q++) yy[q] = y[i][q] * y[k][q] * w[q / PHI_NODES] * step;
            for (j = 0; j < n2; j++) {
                const int l = j < 1 ? 0 : j < 4 ? 1 : j < 9 ? 2 : (int)sqrt(j + 0.5);
                const double f = (double)in->cosine[l] * sqrt(12.566370614359172 / (2 * l + 1));
                double c = 0;
                for (q = 0; q < NODES; q++) c += yy[q] * y[j][q];
                if (fabs(c) < 1e-10) continue;
                if (i <= j) put(&in->general, &general, i, j, i == j ? c / 2 : c);
                if (fabs(f) < 1e-6) continue;
                put(&in->zonal, &zonal, i, j, c * f);
                if (l < 3) put(&in->zonal3, &zonal3, i, j, c * f);
            }
        }
    }
    in->general.start[n2] = general;
    in->zonal.start[n2] = zonal;
    in->zonal3.start[n2] = zonal3;
}

/* ---- registration ---- */

/* Cases of one group compute the same and are compared: 1 the whole cosine's bands, 2 three of them, 0 nothing here
 * (Eq. 11 keeps what a cut cosine loses). */
static void add(const product_input *in, const char *impl, void (*run)(const bench_case *), int group)
{
    bench_case c;
    memset(&c, 0, sizeof c);
    c.kernel = "clamped_cosine";
    c.impl = impl;
    c.bands = in->bands;
    c.items = VECTORS;
    c.run = run;
    c.input = in;
    c.held = VECTORS;
    c.lanes = !strcmp(impl, "world_rotated_blocks") ? 8 : 1;
    c.tolerance = group ? 200 * REAL_EPS : 0;
    c.group = group;
    c.out[0].data = c.lanes == 8 ? in->out_blocks : in->out;
    c.out[0].numbers = in->n2;
    bench_add(&c);
}

void FN(bench_product)(void)
{
    int bands;
    bench_suite("product", BENCH_PRECISION, "vector", "64 vectors, each with its own normal; all in L1 or L2");
    bench_base("clamped_cosine", "triple");
    for (bands = 3; bands <= 9; bands += 2) {
        product_input *in = bench_alloc(1, sizeof *in);
        const size_t n2 = (size_t)(bands * bands);
        real *coeffs = bench_alloc(VECTORS * n2, sizeof(real)), *normals = bench_alloc(3 * VECTORS, sizeof(real));
        real *cosine = bench_alloc((size_t)bands, sizeof(real));
        size_t i, k;
        in->bands = bands;
        in->n2 = n2;
        in->blocks = bench_alloc(VECTORS * n2, sizeof(real));
        in->normal_blocks = bench_alloc(3 * VECTORS, sizeof(real));
        in->out = bench_alloc(VECTORS * n2, sizeof(real));
        in->out_blocks = bench_alloc(VECTORS * n2, sizeof(real));
        for (i = 0; i < VECTORS; i++) {
            const double z = 2 * bench_random() - 1, r = sqrt(1 - z * z), p = 6.283185307179586 * bench_random();
            const double u[3] = { r * cos(p), r * sin(p), z };
            for (k = 0; k < 3; k++) {
                normals[3 * i + k] = C(u[k]);
                in->normal_blocks[(i / 8 * 3 + k) * 8 + i % 8] = C(u[k]);
            }
            for (k = 0; k < n2; k++) {
                coeffs[i * n2 + k] = C(2 * bench_random() - 1);
                in->blocks[(i / 8 * n2 + k) * 8 + i % 8] = coeffs[i * n2 + k];
            }
        }
        FN(sh_zonal_cosine)(bands, cosine);
        in->coeffs = coeffs;
        in->normals = normals;
        in->cosine = cosine;
        make_tables(in);
        add(in, "library_triple", library_triple, 1);
        add(in, "triple", FN(product_triple), 1);
        add(in, "library_zonal", library_zonal, 1);
        add(in, "zonal", FN(product_zonal), 1);
        add(in, "library_zonal3", library_zonal3, 2);
        add(in, "zonal3", FN(product_zonal3), 2);
        add(in, "world", world, 0);
        add(in, "world_rotated", world_rotated, 0);
        add(in, "world_n", world_n, 0);
        add(in, "world_rotated_n", world_rotated_n, 0);
        add(in, "world_rotated_blocks", world_rotated_blocks, 0);
    }
    bench_run();
}
