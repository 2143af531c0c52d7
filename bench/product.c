/* product.c - suite `product`: lighting times the clamped cosine (MP21 Table 2). */
#include "bench.h"

#include <math.h>
#include <string.h>

#include "sh_product.h"

enum { VECTORS = 64 };

typedef struct product_input {
    int bands;
    size_t n2;
    const real *coeffs, *normals, *cosine;      /* [VECTORS][n2], [VECTORS][3], zonal [bands] */
    real *out, *blocks, *normal_blocks, *out_blocks;
} product_input;

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

/* MP21 Eq. 5: the cosine's zonal coefficients turned to the normal, then the general product. */
PER_VECTOR(triple, real cosine[256]; FN(sh_zonal_rotate)(in->bands, in->cosine, normal, cosine);
           FN(sh_triple_product)(in->bands, cosine, c, out);)
/* Eq. 10 with all bands of the cosine, and with three. */
PER_VECTOR(zonal, FN(sh_cosine_product_zonal)(in->bands, in->bands, normal, c, out);)
PER_VECTOR(zonal3, FN(sh_cosine_product_zonal)(in->bands, 3, normal, c, out);)
/* Eq. 11 in the frame of the normal, and with the rotation there and back. */
PER_VECTOR(world, (void)normal; FN(sh_cosine_product_local)(in->bands, c, out);)
PER_VECTOR(world_rotated, FN(sh_cosine_product)(in->bands, normal, c, out);)

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

static void triple_n(const bench_case *self)
{
    const product_input *in = self->input;
    real *cosines = in->out_blocks;
    size_t i;
    for (i = 0; i < VECTORS; i++)
        FN(sh_zonal_rotate)(in->bands, in->cosine, in->normals + 3 * i, cosines + i * in->n2);
    FN(sh_triple_product_n)(in->bands, VECTORS, cosines, in->coeffs, in->out);
}

/* check: cases that compute the same thing are compared; `world` does not (its normal is +z), nor does a cut cosine. */
static void add(const product_input *in, const char *impl, void (*run)(const bench_case *), int check)
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
    c.tolerance = check ? 200 * REAL_EPS : 0;
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
        add(in, "triple", triple, 1);
        add(in, "zonal", zonal, 1);
        add(in, "zonal3", zonal3, 0);
        add(in, "world", world, 0);
        add(in, "world_rotated", world_rotated, 0);
        add(in, "triple_n", triple_n, 1);
        add(in, "world_n", world_n, 0);
        add(in, "world_rotated_n", world_rotated_n, 0);
        add(in, "world_rotated_blocks", world_rotated_blocks, 0);
    }
    bench_run();
}
