/* polygon_forms.c - polygon lights by zonal integrals about 2n-1 lobes: WR18's recurrence on Legendre polynomials, and
 * the recurrence on monomials of Snyder 1996 that it replaced (WR18 section 4.1 and Table 2). The baselines of suite
 * `polygon`, for convex polygons that run positively about the point, as everywhere in WR18.
 *
 * WR18 Algorithm 1 with its slips mended: 1/l on B_{l-2}, S_0 from interior angles, B_1 accumulated. Its gradient is
 * boundary transport: d S_l/dx = sum over edges of mu_e times the integral of P_l(z)/|p| along the edge. */
#include "polygon.h"

#include <math.h>
#include <string.h>

#if defined(BENCH_AUTO)
#  define FORM(name) FN(name##_auto)
#else
#  define FORM(name) FN(name)
#endif

typedef struct edge {
    real w[3], lambda[3], mu[3];        /* frame: vertex direction, along the edge, normal of its great circle */
    real angle, c, s;                   /* gamma, its cosine and sine */
    real k0, k1, big_k0, big_k1;        /* 1/|p| = k0 cos + k1 sin; its integral at 0 and at gamma */
} edge;

INLINE void cross(const real a[3], const real b[3], real out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

INLINE real dot3(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Lines 2-8 of Algorithm 1; returns S_0. */
INLINE real prepare(const int sides, const int gradient, const real point[3], const real *vertices, edge *e)
{
    real p[POLYGON_MAX_SIDES][3], length[POLYGON_MAX_SIDES], angle = C(6.283185307179586);
    int i, k;
    for (i = 0; i < sides; i++) {
        for (k = 0; k < 3; k++) p[i][k] = vertices[3 * i + k] - point[k];
        length[i] = REAL_SQRT(dot3(p[i], p[i]));
        for (k = 0; k < 3; k++) e[i].w[k] = p[i][k] / length[i];
    }
    for (i = 0; i < sides; i++) {
        const int next = i + 1 < sides ? i + 1 : 0;
        real inverse;
        cross(e[i].w, e[next].w, e[i].mu);
        inverse = 1 / REAL_SQRT(dot3(e[i].mu, e[i].mu));
        for (k = 0; k < 3; k++) e[i].mu[k] *= inverse;
        cross(e[i].mu, e[i].w, e[i].lambda);
        e[i].c = dot3(e[i].w, e[next].w);
        e[i].angle = REAL_ACOS(e[i].c);
        e[i].s = 1 / inverse;
        if (gradient) {         /* 1/|p| at both ends determines k0, k1 */
            e[i].k0 = 1 / length[i];
            e[i].k1 = (1 / length[next] - e[i].k0 * e[i].c) * inverse;
            e[i].big_k0 = -e[i].k1;
            e[i].big_k1 = e[i].k0 * e[i].s - e[i].k1 * e[i].c;
        }
    }
    for (i = 0; i < sides; i++) {
        const real turn = dot3(e[i].mu, e[i + 1 < sides ? i + 1 : 0].mu);
        angle -= REAL_ACOS(turn > 1 ? 1 : turn < -1 ? -1 : turn);
    }
    return angle;
}

/* S_l about one lobe, l < bands, and (gradient) the three planes of its gradient: sum[1 or 4][bands]. Eq. 29-32. */
INLINE void legendre_lobe(const int bands, const int gradient, const int sides, const edge *edges, const real omega[3],
                          const real s0, real *RESTRICT sum)
{
    real b_total[POLYGON_MAX_BANDS + 1];
    int l, i, k;
    for (l = 0; l < (gradient ? 4 : 1) * bands; l++) sum[l] = 0;
    for (l = 0; l < bands; l++) b_total[l] = 0;
    for (i = 0; i < sides; i++) {
        const edge *e = &edges[i];
        const real a = dot3(omega, e->w), b = dot3(omega, e->lambda), c = dot3(omega, e->mu);
        const real z = a * e->c + b * e->s, up = a * e->s - b * e->c, sag = a * a + b * b - 1;
        const real ab = e->k0 * a + e->k1 * b;
        real b1 = e->angle, b2 = 0, d1 = 0, d2 = 0;             /* B_{l-1}, B_{l-2}, D_{l-1}, D_{l-2} */
        real pz1 = 1, pz2 = 0, pa1 = 1, pa2 = 0;                /* P_{l-1}, P_{l-2} at z and at a */
        real h1 = 0, h2 = 0, g1 = 0;
        b_total[0] += c * e->angle;
        if (gradient) {
            g1 = e->big_k1 - e->big_k0;
            for (k = 0; k < 3; k++) sum[(k + 1) * bands] += e->mu[k] * g1;
        }
        for (l = 1; l < bands; l++) {
            const real inverse = 1 / C(l), odd = C(2 * l - 1);
            const real cl = inverse * (up * pz1 + b * pa1 + sag * d1 + C(l - 1) * b2);      /* Eq. 31 */
            const real bl = odd * inverse * cl - C(l - 1) * inverse * b2;                   /* Eq. 30 */
            const real dl = odd * b1 + d2;                                                  /* Eq. 32 */
            const real pz = (odd * z * pz1 - C(l - 1) * pz2) * inverse;
            const real pa = (odd * a * pa1 - C(l - 1) * pa2) * inverse;
            b_total[l] += c * bl;
            if (gradient) {
                const real gl = (pz * e->big_k1 - pa * e->big_k0 + ab * dl - h1) / C(l + 1);
                const real hl = h2 + odd * g1;
                for (k = 0; k < 3; k++) sum[(k + 1) * bands + l] += e->mu[k] * gl;
                h2 = h1;
                h1 = hl;
                g1 = gl;
            }
            b2 = b1; b1 = bl;
            d2 = d1; d1 = dl;
            pz2 = pz1; pz1 = pz;
            pa2 = pa1; pa1 = pa;
        }
    }
    sum[0] = s0;
    if (bands > 1) sum[1] = C(0.5) * b_total[0];
    for (l = 2; l < bands; l++)                                 /* Eq. 29 */
        sum[l] = (C(2 * l - 1) * b_total[l - 1] + C((l - 2) * (l - 1)) * sum[l - 2]) / C(l * (l + 1));
}

/* The same by integrals of z^k, then O(n) of them combined for each P_l. */
INLINE void monomial_lobe(const int bands, const int gradient, const int sides, const edge *edges, const real omega[3],
                          const real s0, const real *legendre, real *RESTRICT sum)
{
    real boundary[POLYGON_MAX_BANDS], t[4][POLYGON_MAX_BANDS];
    int l, i, k, axis;
    for (l = 0; l < bands; l++) boundary[l] = t[0][l] = t[1][l] = t[2][l] = t[3][l] = 0;
    for (i = 0; i < sides; i++) {
        const edge *e = &edges[i];
        const real a = dot3(omega, e->w), b = dot3(omega, e->lambda), c = dot3(omega, e->mu);
        const real z = a * e->c + b * e->s, d0 = b, d1 = b * e->c - a * e->s, aabb = a * a + b * b;
        const real ab = e->k0 * a + e->k1 * b;
        real i1 = e->angle, i2 = 0, z0k = 1, z1k = 1;           /* integrals of z^{k-1}, z^{k-2}; powers k-1 at the ends */
        boundary[0] += c * e->angle;
        if (gradient)
            for (axis = 0; axis < 3; axis++) t[axis + 1][0] += e->mu[axis] * (e->big_k1 - e->big_k0);
        for (k = 1; k < bands; k++) {
            const real ik = (d0 * z0k - d1 * z1k + C(k - 1) * aabb * i2) / C(k);
            z0k *= a;
            z1k *= z;
            boundary[k] += c * ik;
            if (gradient) {
                const real jk = (z1k * e->big_k1 - z0k * e->big_k0 + C(k) * ab * i1) / C(k + 1);
                for (axis = 0; axis < 3; axis++) t[axis + 1][k] += e->mu[axis] * jk;
            }
            i2 = i1;
            i1 = ik;
        }
    }
    t[0][0] = s0;
    if (bands > 1) t[0][1] = C(0.5) * boundary[0];
    for (k = 2; k < bands; k++) t[0][k] = (boundary[k - 1] + C(k - 1) * t[0][k - 2]) / C(k + 1);
    for (axis = 0; axis < (gradient ? 4 : 1); axis++)
        for (l = 0; l < bands; l++) {
            real s = 0;
            for (k = l & 1; k <= l; k += 2) s += legendre[l * bands + k] * t[axis][k];
            sum[axis * bands + l] = s;
        }
}

/* Algorithm 1 around either: all lobes, then the sparse rotation. */
INLINE void polygon_light(const int monomial, const int bands, const int gradient, const polygon_input *in,
                          const real point[3], real *RESTRICT out)
{
    enum { MAX = POLYGON_MAX_BANDS, LOBES = 2 * MAX - 1 };
    const int lobes = 2 * bands - 1, planes = gradient ? 4 : 1;
    edge edges[POLYGON_MAX_SIDES];
    real sums[4 * MAX], by_band[4][MAX][LOBES];
    const real s0 = prepare(in->sides, gradient, point, in->vertices, edges);
    int d, l, i, plane;
    for (d = 0; d < lobes; d++) {
        if (monomial) monomial_lobe(bands, gradient, in->sides, edges, in->lobes + 3 * d, s0, in->legendre, sums);
        else legendre_lobe(bands, gradient, in->sides, edges, in->lobes + 3 * d, s0, sums);
        for (plane = 0; plane < planes; plane++)
            for (l = 0; l < bands; l++) by_band[plane][l][d] = sums[plane * bands + l];
    }
    for (plane = 0; plane < planes; plane++)
        for (l = 0, i = 0; l < bands; l++)
            for (; i < (l + 1) * (l + 1); i++) {
                const real *w = in->weights + (size_t)(i * lobes);
                real s[4] = { 0, 0, 0, 0 };                     /* chains that do not wait for each other */
                for (d = 0; d + 4 <= lobes; d += 4) {
                    s[0] += w[d] * by_band[plane][l][d];
                    s[1] += w[d + 1] * by_band[plane][l][d + 1];
                    s[2] += w[d + 2] * by_band[plane][l][d + 2];
                    s[3] += w[d + 3] * by_band[plane][l][d + 3];
                }
                for (; d < lobes; d++) s[0] += w[d] * by_band[plane][l][d];
                out[plane * bands * bands + i] = (s[0] + s[1]) + (s[2] + s[3]);
            }
}

#define POINT_LOOP(monomial, gradient)                                                                     \
    size_t i;                                                                                              \
    for (i = 0; i < in->points; i++)                                                                       \
        polygon_light(monomial, BANDS, gradient, in, in->point + 3 * i,                                    \
                      in->out + i * (gradient ? 4 : 1) * BANDS * BANDS);
#define ALL_BANDS(monomial, gradient)                                                                      \
    switch (in->bands) {                                                                                   \
    BANDS_CASE(3, POINT_LOOP(monomial, gradient)) BANDS_CASE(5, POINT_LOOP(monomial, gradient))            \
    BANDS_CASE(7, POINT_LOOP(monomial, gradient)) BANDS_CASE(9, POINT_LOOP(monomial, gradient))            \
    BANDS_CASE(12, POINT_LOOP(monomial, gradient)) BANDS_CASE(15, POINT_LOOP(monomial, gradient))          \
    default: break;                                                                                        \
    }

void FORM(polygon_monomial)(const bench_case *self)
{
    const polygon_input *in = self->input;
    if (in->gradient) {
        ALL_BANDS(1, 1)
    } else {
        ALL_BANDS(1, 0)
    }
}

void FORM(polygon_wang_ramamoorthi)(const bench_case *self)
{
    const polygon_input *in = self->input;
    if (in->gradient) {
        ALL_BANDS(0, 1)
    } else {
        ALL_BANDS(0, 0)
    }
}
