/* product.h - what the suite `product` and its baselines share. */
#ifndef BENCH_PRODUCT_H
#define BENCH_PRODUCT_H

#include "bench.h"

enum { VECTORS = 64 };

/* Non-zero integrals of Y_i Y_j Y_k, sorted by k: terms start[k] .. start[k+1]-1 are c times the numbers i and j. */
typedef struct gaunt_table {
    int *start;                 /* [n^2 + 1] */
    unsigned char (*pair)[2];
    real *c;
} gaunt_table;

typedef struct product_input {
    int bands;
    size_t n2;
    const real *coeffs, *normals, *cosine;      /* [VECTORS][n2], [VECTORS][3], zonal [bands] */
    gaunt_table general;        /* i <= j: a term is c (a_i b_j + a_j b_i), c halved for i == j */
    gaunt_table zonal, zonal3;  /* a term is c a_i Y_j(normal), the cosine's zonal coefficients inside c */
    real *out, *blocks, *normal_blocks, *out_blocks;
} product_input;

/* product_forms.c, scalar: MP21 Eq. 5, and Eq. 10 with all bands of the cosine and with three; bands 3 5 7 9. */
void FN(product_triple)(const bench_case *self);
void FN(product_zonal)(const bench_case *self);
void FN(product_zonal3)(const bench_case *self);

#endif
