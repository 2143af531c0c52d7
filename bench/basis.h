/* basis.h - what the suite `basis` and its baselines share. */
#ifndef BENCH_BASIS_H
#define BENCH_BASIS_H

#include "bench.h"

enum { DIRECTIONS = 480 };

typedef struct basis_input {
    int bands;
    size_t chunk;                       /* directions whose outputs are kept: the block that is reused */
    const real *dirs, *vectors;         /* [DIRECTIONS][3]: unit; of lengths 0.5 .. 2 */
    const real *dir_blocks, *vector_blocks;     /* the same, [DIRECTIONS/8][3][8] */
    const real *theta, *phi;            /* [DIRECTIONS] */
    const real *coeffs, *weights;       /* [n^2]; [DIRECTIONS] */
    real *y, *grad, *hess;              /* chunk times n^2, 3 n^2, 6 n^2 */
} basis_input;

/* Where direction i of a chunk puts y, d/dtheta and d/dphi: the latter two share the space of grad. */
#define ANGLE_OUTPUTS(n2) in->y + (n2) * i, in->grad + (n2) * i, in->grad + (n2) * (in->chunk + i)

/* The baselines of basis_forms.c: as scalar code, and (auto) with the compiler's vectoriser let loose on the
 * loops, across directions too. */
#define BASIS_FORM(name) void FN(name)(const bench_case *self);
BASIS_FORM(values_polynomial) BASIS_FORM(values_sloan) BASIS_FORM(values_sloan_auto)
BASIS_FORM(angles_direct) BASIS_FORM(angles_sloan_like)
BASIS_FORM(gradient_polynomial) BASIS_FORM(gradient_direct)
BASIS_FORM(gradient_sloan_like) BASIS_FORM(gradient_sloan_like_auto)
BASIS_FORM(hessian_polynomial)
BASIS_FORM(reconstruct_polynomial) BASIS_FORM(reconstruct_sloan) BASIS_FORM(reconstruct_sloan_auto)
BASIS_FORM(project_polynomial) BASIS_FORM(project_sloan)
#undef BASIS_FORM

#endif
