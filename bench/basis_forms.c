/* basis_forms.c - the forms people know, one direction at a time: the baselines of suite `basis`.
 *
 * Compiled without the compiler's vectorisers, for this is scalar code as published; and once more with them
 * (BENCH_AUTO), so that what a good compiler makes of the same lines is in the tables too. */
#include "basis.h"

#include <math.h>
#include <string.h>

#include "polynomial.h"
#include "sloan.h"

#if defined(BENCH_AUTO)
#  define FORM(name) FN(name##_auto)
#else
#  define FORM(name) FN(name)
#endif

/* A scalar form over all directions: `body` handles direction d, index i of its chunk, with BANDS constant. */
#define PER_DIRECTION(name, body)                                                                        \
    void FORM(name)(const bench_case *self)                                                             \
    {                                                                                                    \
        const basis_input *in = self->input;                                                             \
        switch (in->bands) {                                                                             \
        BANDS_CASE(3, DIRECTION_LOOP(body)) BANDS_CASE(4, DIRECTION_LOOP(body))                          \
        BANDS_CASE(5, DIRECTION_LOOP(body)) BANDS_CASE(6, DIRECTION_LOOP(body))                          \
        BANDS_CASE(8, DIRECTION_LOOP(body)) BANDS_CASE(10, DIRECTION_LOOP(body))                         \
        default: break;                                                                                  \
        }                                                                                                \
    }
#define DIRECTION_LOOP(body)                                                                             \
    enum { N = BANDS * BANDS };                                                                          \
    size_t first, i;                                                                                     \
    for (first = 0; first < DIRECTIONS; first += in->chunk)                                              \
        for (i = 0; i < in->chunk; i++) {                                                                \
            const size_t d = first + i;                                                                  \
            body                                                                                         \
        }

/* ---- values ---- */

#if !defined(BENCH_AUTO)
PER_DIRECTION(values_polynomial, polynomial_values(BANDS, in->dirs + 3 * d, in->y + N * i);)
#endif
PER_DIRECTION(values_sloan, sloan_values(BANDS, in->dirs + 3 * d, in->y + N * i);)

/* ---- derivatives by the angles ---- */

INLINE void angles_by(const int direct, const int bands, const real theta, const real phi, real *y, real *dt,
                      real *dp)
{
    const real st = REAL_SIN(theta), ct = REAL_COS(theta);
    const real dir[3] = { st * REAL_COS(phi), st * REAL_SIN(phi), ct };
    if (direct) m22_direct(0, bands, dir, st, 1 / st, NULL, y, dt, dp, NULL);
    else m22_sloan_like(0, bands, dir, st, ct / st, NULL, y, dt, dp, NULL);
}

#if !defined(BENCH_AUTO)
PER_DIRECTION(angles_direct, angles_by(1, BANDS, in->theta[d], in->phi[d], ANGLE_OUTPUTS(N));)
PER_DIRECTION(angles_sloan_like, angles_by(0, BANDS, in->theta[d], in->phi[d], ANGLE_OUTPUTS(N));)
#endif

/* ---- gradient by v ---- */

/* M22's two routes: derivatives by the angles, each turned by Eq. 23 while it is in a register. */
INLINE void gradient_by(const int direct, const int bands, const real v[3], real *RESTRICT y,
                        real *RESTRICT grad)
{
    const int n2 = bands * bands;
    const real rr = v[0] * v[0] + v[1] * v[1], ir = 1 / REAL_SQRT(rr + v[2] * v[2]), is = 1 / REAL_SQRT(rr);
    const real u[3] = { v[0] * ir, v[1] * ir, v[2] * ir }, st = rr * is * ir;
    const real c = v[0] * is, s = v[1] * is;            /* cos(phi), sin(phi) */
    const real j[5] = { c * u[2] * ir, -s * is, s * u[2] * ir, c * is, -st * ir };
    if (direct) m22_direct(1, bands, u, st, 1 / st, j, y, grad, grad + n2, grad + 2 * n2);
    else m22_sloan_like(1, bands, u, st, v[2] * is, j, y, grad, grad + n2, grad + 2 * n2);
}

INLINE void gradient_polynomial_of(const int bands, const real v[3], real *RESTRICT y, real *RESTRICT grad)
{
    const int n2 = bands * bands;
    const real ir = 1 / REAL_SQRT(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const real u[3] = { v[0] * ir, v[1] * ir, v[2] * ir };
    polynomial_gradient(bands, u, ir, y, grad, grad + n2, grad + 2 * n2);
}

#if !defined(BENCH_AUTO)
PER_DIRECTION(gradient_polynomial, gradient_polynomial_of(BANDS, in->vectors + 3 * d, in->y + N * i,
                                                          in->grad + 3 * N * i);)
PER_DIRECTION(gradient_direct, gradient_by(1, BANDS, in->vectors + 3 * d, in->y + N * i,
                                           in->grad + 3 * N * i);)
#endif
PER_DIRECTION(gradient_sloan_like, gradient_by(0, BANDS, in->vectors + 3 * d, in->y + N * i,
                                               in->grad + 3 * N * i);)

/* ---- Hessian ---- */

INLINE void hessian_polynomial_of(const int bands, const real v[3], real *y, real *grad, real *hess)
{
    const real ir = 1 / REAL_SQRT(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const real u[3] = { v[0] * ir, v[1] * ir, v[2] * ir };
    polynomial_hessian(bands, u, ir, y, grad, hess);
}

#if !defined(BENCH_AUTO)
PER_DIRECTION(hessian_polynomial, hessian_polynomial_of(BANDS, in->vectors + 3 * d, in->y + N * i,
                                                        in->grad + 3 * N * i, in->hess + 6 * N * i);)
#endif

/* ---- sum of c_k Y_k at each direction, and sum of w Y over all: basis, then a loop ---- */

INLINE real dot(const int n2, const real *RESTRICT a, const real *RESTRICT b)
{
    real s[4] = { 0, 0, 0, 0 };         /* four chains: one would wait for each addition */
    int k;
    for (k = 0; k + 4 <= n2; k += 4) {
        s[0] += a[k] * b[k];
        s[1] += a[k + 1] * b[k + 1];
        s[2] += a[k + 2] * b[k + 2];
        s[3] += a[k + 3] * b[k + 3];
    }
    for (; k < n2; k++) s[0] += a[k] * b[k];
    return (s[0] + s[1]) + (s[2] + s[3]);
}

INLINE void accumulate(const int n2, const real w, const real *RESTRICT y, real *RESTRICT sum)
{
    int k;
    for (k = 0; k < n2; k++) sum[k] += w * y[k];
}

#if !defined(BENCH_AUTO)
PER_DIRECTION(reconstruct_polynomial, real y[N]; polynomial_values(BANDS, in->dirs + 3 * d, y);
              in->y[d] = dot(N, in->coeffs, y);)
#endif
PER_DIRECTION(reconstruct_sloan, real y[N]; sloan_values(BANDS, in->dirs + 3 * d, y);
              in->y[d] = dot(N, in->coeffs, y);)
#if !defined(BENCH_AUTO)
PER_DIRECTION(project_polynomial, real y[N]; if (!d) memset(in->y, 0, N * sizeof(real));
              polynomial_values(BANDS, in->dirs + 3 * d, y); accumulate(N, in->weights[d], y, in->y);)
PER_DIRECTION(project_sloan, real y[N]; if (!d) memset(in->y, 0, N * sizeof(real));
              sloan_values(BANDS, in->dirs + 3 * d, y); accumulate(N, in->weights[d], y, in->y);)
#endif
