/* polygon.h - what the suite `polygon` and its baselines share. */
#ifndef BENCH_POLYGON_H
#define BENCH_POLYGON_H

#include "bench.h"

enum { POLYGON_MAX_BANDS = 15, POLYGON_MAX_SIDES = 8 };

/* what the closed form in edge frames needs: polygon_frame.h */
typedef struct polygon_frame {
    real value[POLYGON_MAX_BANDS * POLYGON_MAX_BANDS], slope[POLYGON_MAX_BANDS * POLYGON_MAX_BANDS];
    real x[2048];               /* rows of X, every other column from first to last of the band */
    int start[POLYGON_MAX_BANDS * POLYGON_MAX_BANDS], first[POLYGON_MAX_BANDS * POLYGON_MAX_BANDS];
    int last[POLYGON_MAX_BANDS * POLYGON_MAX_BANDS];
} polygon_frame;

typedef struct polygon_input {
    int bands, sides, gradient;
    size_t points;
    const real *point;          /* [points][3] */
    const real *vertices;       /* [sides][3] */
    const real *lobes;          /* [2 bands - 1][3] */
    const real *weights;        /* [n^2][2 bands - 1]: integrals of P_l about the lobes to SH coefficients */
    const polygon_frame *frame;
    const real *legendre;       /* [bands][bands]: P_l = sum of legendre[l][k] z^k */
    real *out;                  /* [points][planes][n^2] */
} polygon_input;

/* polygon_forms.c, scalar; bands 3 5 9 15 */
void FN(polygon_monomial)(const bench_case *self);
void FN(polygon_wang_ramamoorthi)(const bench_case *self);
void FN(polygon_edge_frame)(const bench_case *self);

#endif
