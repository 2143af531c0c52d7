/* lights_forms.c - spherical lights as M22 prints them: Eq. 9-16 for each light, accumulated. The baseline of suites
 * `lights` and `grid`. Like basis_forms.c it is compiled as scalar code and (BENCH_AUTO) as the compiler likes. */
#include "lights.h"

#include <math.h>
#include <string.h>

#include "polynomial.h"
#include "sloan.h"

#if defined(BENCH_AUTO)
#  define FORM(name) FN(name##_auto)
#else
#  define FORM(name) FN(name)
#endif

/* g_l = sqrt(4 pi/(2l+1)) times Eq. 9, and its derivatives by the distance (planes >= 4: Eq. 13, 14, 16; planes 10:
 * g'', which M22 leaves to future work). p[l+1] holds P_l, p[0] = P_{-1} = 1. */
INLINE void zonal(const int bands, const int planes, const real d, const real r, real *g, real *dg, real *ddg)
{
    const real s = r / d, alpha = REAL_SQRT(1 - s * s);         /* Eq. 10: sin(a), cos(a) */
    const real da = -r / (d * REAL_SQRT(d * d - r * r));        /* Eq. 13, along the direction */
    const real q = s * s / (alpha * d), two_pi = C(6.283185307179586);
    real p[16], derivative = 0;
    int l;
    p[0] = p[1] = 1;
    p[2] = alpha;
    for (l = 2; l <= bands + 1; l++) p[l + 1] = (C(2 * l - 1) * alpha * p[l] - C(l - 1) * p[l - 1]) / C(l);
    g[0] = two_pi * (1 - alpha);
    for (l = 1; l < bands; l++) g[l] = two_pi / C(2 * l + 1) * (p[l] - p[l + 2]);
    if (planes < 4) return;
    dg[0] = two_pi * da * s;
    for (l = 1; l < bands; l++) {                               /* Eq. 16 */
        const real o = (C(l + 2) * (alpha * p[l + 2] - p[l + 3]) - C(l) * (alpha * p[l] - p[l + 1])) /
                       (alpha * alpha - 1);
        dg[l] = -two_pi / C(2 * l + 1) * da * s * o;
    }
    if (planes < 10) return;
    for (l = 0; l < bands; l++) {
        if (l > 0) derivative = C(l) * p[l] + alpha * derivative;
        ddg[l] = two_pi * (p[l + 1] * (3 * q / d + q * q / alpha) - derivative * q * q);
    }
}

INLINE void one_light(const int bands, const int planes, const real x[3], const real center[3], const real r,
                      const real radiance, real *RESTRICT out)
{
    enum { MAX = 100 };
    const int n2 = bands * bands;
    const real v[3] = { center[0] - x[0], center[1] - x[1], center[2] - x[2] };
    const real rr = v[0] * v[0] + v[1] * v[1], dd = rr + v[2] * v[2], d = REAL_SQRT(dd), id = 1 / d;
    const real u[3] = { v[0] * id, v[1] * id, v[2] * id };
    real y[MAX], grad[3 * MAX], g[16], dg[16], ddg[16];
    int l, k, i;

    zonal(bands, planes, d, r, g, dg, ddg);
    if (planes == 1) {
        sloan_values(bands, u, y);
        for (l = 0, i = 0; l < bands; l++) {
            const real w = radiance * g[l];
            for (; i < (l + 1) * (l + 1); i++) out[i] += w * y[i];
        }
        return;
    }
    if (planes == 4) {                                          /* Eq. 21-23 */
        const real is = 1 / REAL_SQRT(rr), st = rr * is * id, c = v[0] * is, s = v[1] * is;
        const real j[5] = { c * u[2] * id, -s * is, s * u[2] * id, c * is, -st * id };
        m22_sloan_like(1, bands, u, st, v[2] * is, j, y, grad, grad + n2, grad + 2 * n2);
        for (l = 0, i = 0; l < bands; l++) {                    /* Eq. 12 */
            const real w = radiance * g[l], e = radiance * dg[l], ex = e * u[0], ey = e * u[1], ez = e * u[2];
            for (; i < (l + 1) * (l + 1); i++) {
                out[i] += w * y[i];
                out[n2 + i] -= w * grad[i] + ex * y[i];
                out[2 * n2 + i] -= w * grad[n2 + i] + ey * y[i];
                out[3 * n2 + i] -= w * grad[2 * n2 + i] + ez * y[i];
            }
        }
        return;
    } else {
        real hess[6 * MAX];
        polynomial_hessian(bands, u, id, y, grad, hess);
        for (l = 0, i = 0; l < bands; l++) {
            const real w = radiance * g[l], e = radiance * dg[l], f = radiance * ddg[l], h = e * id;
            for (; i < (l + 1) * (l + 1); i++) {
                int a, b, plane = 4;
                out[i] += w * y[i];
                for (k = 0; k < 3; k++) out[(k + 1) * n2 + i] -= w * grad[k * n2 + i] + e * u[k] * y[i];
                for (a = 0; a < 3; a++)
                    for (b = a; b < 3; b++, plane++)
                        out[plane * n2 + i] += (f - h) * y[i] * u[a] * u[b] + (a == b ? h * y[i] : 0) +
                                               e * (u[a] * grad[b * n2 + i] + grad[a * n2 + i] * u[b]) +
                                               w * hess[(plane - 4) * n2 + i];
            }
        }
    }
}

#define LIGHT_LOOP(planes)                                                                                 \
    size_t i;                                                                                              \
    for (i = 0; i < scene->count; i++) {                                                                   \
        const real *s = scene->spheres;                                                                    \
        const real center[3] = { s[i], s[scene->count + i], s[2 * scene->count + i] };                     \
        one_light(BANDS, planes, point, center, s[3 * scene->count + i], scene->radiance[i], out);         \
    }
#define ALL_BANDS(planes)                                                                                  \
    switch (bands) {                                                                                       \
    BANDS_CASE(5, LIGHT_LOOP(planes)) BANDS_CASE(6, LIGHT_LOOP(planes)) BANDS_CASE(7, LIGHT_LOOP(planes))  \
    BANDS_CASE(8, LIGHT_LOOP(planes)) BANDS_CASE(9, LIGHT_LOOP(planes))                                    \
    default: break;                                                                                        \
    }

void FORM(per_light)(int bands, int planes, const real point[3], const lights_scene *scene, real *out)
{
    memset(out, 0, (size_t)(planes * bands * bands) * sizeof *out);
    if (planes == 1) {
        ALL_BANDS(1)
    } else if (planes == 4) {
        ALL_BANDS(4)
    } else {
#if !defined(BENCH_AUTO)        /* the polynomials' Hessian is long; one body of it is enough */
        ALL_BANDS(10)
#endif
    }
}
