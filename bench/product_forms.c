/* product_forms.c - the clamped-cosine product as MP21 starts from: sums over the non-zero Gaunt coefficients. The
 * baselines of suite `product`. MP21 generates code for each term; at 9 bands that is a third of a megabyte, so a
 * table that stays in L2 is the form for a CPU. */
#include "product.h"

#include <math.h>

#include "sloan.h"

/* Y at the normal. */
static void normal_basis(int bands, const real normal[3], real *y)
{
    switch (bands) {
    BANDS_CASE(3, sloan_values(BANDS, normal, y);)
    BANDS_CASE(5, sloan_values(BANDS, normal, y);)
    BANDS_CASE(7, sloan_values(BANDS, normal, y);)
    BANDS_CASE(9, sloan_values(BANDS, normal, y);)
    default: break;
    }
}

/* Eq. 5: the coefficients are symmetric in i and j, which halves the terms. */
static void general_product(const gaunt_table *g, size_t n2, const real *a, const real *b, real *out)
{
    size_t k;
    for (k = 0; k < n2; k++) {
        const int end = g->start[k + 1];
        real s0 = 0, s1 = 0;            /* two chains that do not wait for each other */
        int t = g->start[k];
        for (; t + 2 <= end; t += 2) {
            const int i = g->pair[t][0], j = g->pair[t][1], p = g->pair[t + 1][0], q = g->pair[t + 1][1];
            s0 += g->c[t] * (a[i] * b[j] + a[j] * b[i]);
            s1 += g->c[t + 1] * (a[p] * b[q] + a[q] * b[p]);
        }
        if (t < end) {
            const int i = g->pair[t][0], j = g->pair[t][1];
            s0 += g->c[t] * (a[i] * b[j] + a[j] * b[i]);
        }
        out[k] = s0 + s1;
    }
}

/* Eq. 10: zonal coefficients folded into the constants, bands where the cosine has none left out. */
static void zonal_product(const gaunt_table *g, size_t n2, const real *a, const real *y, real *out)
{
    size_t k;
    for (k = 0; k < n2; k++) {
        const int end = g->start[k + 1];
        real s0 = 0, s1 = 0;
        int t = g->start[k];
        for (; t + 2 <= end; t += 2) {
            s0 += g->c[t] * a[g->pair[t][0]] * y[g->pair[t][1]];
            s1 += g->c[t + 1] * a[g->pair[t + 1][0]] * y[g->pair[t + 1][1]];
        }
        if (t < end) s0 += g->c[t] * a[g->pair[t][0]] * y[g->pair[t][1]];
        out[k] = s0 + s1;
    }
}

void FN(product_triple)(const bench_case *self)
{
    const product_input *in = self->input;
    size_t v;
    for (v = 0; v < VECTORS; v++) {
        real cosine[100];
        int l, i;
        normal_basis(in->bands, in->normals + 3 * v, cosine);
        for (l = 0, i = 0; l < in->bands; l++) {                /* zonal coefficients turned to the normal */
            const real scale = in->cosine[l] * REAL_SQRT(C(12.566370614359172) / C(2 * l + 1));
            for (; i < (l + 1) * (l + 1); i++) cosine[i] *= scale;
        }
        general_product(&in->general, in->n2, cosine, in->coeffs + v * in->n2, in->out + v * in->n2);
    }
}

void FN(product_zonal)(const bench_case *self)
{
    const product_input *in = self->input;
    size_t v;
    for (v = 0; v < VECTORS; v++) {
        real y[100];
        normal_basis(in->bands, in->normals + 3 * v, y);
        zonal_product(&in->zonal, in->n2, in->coeffs + v * in->n2, y, in->out + v * in->n2);
    }
}

void FN(product_zonal3)(const bench_case *self)
{
    const product_input *in = self->input;
    size_t v;
    for (v = 0; v < VECTORS; v++) {
        real y[100];
        normal_basis(3, in->normals + 3 * v, y);
        zonal_product(&in->zonal3, in->n2, in->coeffs + v * in->n2, y, in->out + v * in->n2);
    }
}
