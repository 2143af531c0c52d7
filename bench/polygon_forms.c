/* polygon_forms.c - polygon lights by zonal integrals about 2n-1 lobes: WR18's recurrence on Legendre
 * polynomials, and the recurrence on monomials of Snyder 1996 that it replaced (WR18 section 4.1 and Table
 * 2); and by the closed form in each edge's frame. The baselines of suite `polygon`, for convex polygons that
 * run positively about the point, as everywhere in WR18.
 *
 * WR18 Algorithm 1 with its slips mended: 1/l on B_{l-2}, S_0 from interior angles, B_1 accumulated. Its
 * gradient is boundary transport: d S_l/dx = sum over edges of mu_e times the integral of P_l(z)/|p| along
 * the edge. */
#include "polygon.h"

#include <math.h>
#include <string.h>

typedef struct edge {
    real w[3], lambda[3], mu[3]; /* frame: vertex direction, along the edge, normal of its great circle */
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
        real length_inverse;
        cross(e[i].w, e[next].w, e[i].mu);
        length_inverse = 1 / REAL_SQRT(dot3(e[i].mu, e[i].mu));
        for (k = 0; k < 3; k++) e[i].mu[k] *= length_inverse;
        cross(e[i].mu, e[i].w, e[i].lambda);
        e[i].c = dot3(e[i].w, e[next].w);
        e[i].angle = REAL_ACOS(e[i].c);
        e[i].s = 1 / length_inverse;
        if (gradient) {         /* 1/|p| at both ends determines k0, k1 */
            e[i].k0 = 1 / length[i];
            e[i].k1 = (1 / length[next] - e[i].k0 * e[i].c) * length_inverse;
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

/* 1/l and (2l-1)/l^2 and the like are constants of the forms */
static const real inverse[POLYGON_MAX_BANDS + 2] = {
    C(0.0), C(1.0), C(1.0) / 2, C(1.0) / 3, C(1.0) / 4, C(1.0) / 5, C(1.0) / 6, C(1.0) / 7, C(1.0) / 8,
    C(1.0) / 9,
    C(1.0) / 10, C(1.0) / 11, C(1.0) / 12, C(1.0) / 13, C(1.0) / 14, C(1.0) / 15, C(1.0) / 16
};

/* S_l about one lobe, l < bands, and (gradient) the three planes of its gradient: sum[1 or 4][bands]. Eq.
 * 29-32.
 * Degrees outside, edges inside, as Algorithm 1 has them: edges do not wait for each other. A vertex belongs
 * to two edges, so P_l(omega.w) is computed once for both. */
INLINE void legendre_lobe(const int bands, const int gradient, const int sides, const edge *edges,
                          const real omega[3], const real s0, real *RESTRICT sum)
{
    enum { M = POLYGON_MAX_SIDES };
    real a[M], c[M], up[M], b[M], sag[M], ab[M], b1[M], b2[M], d1[M], d2[M], h1[M], h2[M], g1[M];
    real p[M], p1[M], total1 = 0;
    int l, i, k;
    for (k = 0; k < (gradient ? 4 : 1); k++) sum[k * bands] = 0;
    for (i = 0; i < sides; i++) {
        const edge *e = &edges[i];
        a[i] = dot3(omega, e->w);
        b[i] = dot3(omega, e->lambda);
        c[i] = dot3(omega, e->mu);
        up[i] = a[i] * e->s - b[i] * e->c;
        sag[i] = a[i] * a[i] + b[i] * b[i] - 1;
        ab[i] = e->k0 * a[i] + e->k1 * b[i];
        b1[i] = e->angle;                                       /* B_{l-1}, B_{l-2}, D_{l-1}, D_{l-2} */
        b2[i] = d1[i] = d2[i] = h1[i] = h2[i] = p1[i] = 0;
        p[i] = 1;                                               /* P_{l-1}, P_{l-2} */
        g1[i] = e->big_k1 - e->big_k0;
        total1 += c[i] * e->angle;
        for (k = 0; k < 3 && gradient; k++) sum[(k + 1) * bands] += e->mu[k] * g1[i];
    }
    sum[0] = s0;
    for (l = 1; l < bands; l++) {
        const real odd = C(2 * l - 1), next_p = odd * inverse[l], next_p1 = C(l - 1) * inverse[l];
        real total = 0, g[3] = { 0, 0, 0 }, q[M];
        for (i = 0; i < sides; i++) q[i] = next_p * (a[i] * p[i]) - next_p1 * p1[i];
        for (i = 0; i < sides; i++) {
            const int j = i + 1 < sides ? i + 1 : 0;
            const edge *e = &edges[i];
            const real cl = up[i] * p[j] + b[i] * p[i] + sag[i] * d1[i]
                          + C(l - 1) * b2[i]; /* l times Eq. 31 */
            const real bl = next_p * inverse[l] * cl - next_p1 * b2[i];                         /* Eq. 30 */
            const real dl = odd * b1[i] + d2[i];                                                /* Eq. 32 */
            total += c[i] * bl;
            if (gradient) {
                const real gl = (q[j] * e->big_k1 - q[i] * e->big_k0 + ab[i] * dl - h1[i]) * inverse[l + 1];
                const real hl = h2[i] + odd * g1[i];
                for (k = 0; k < 3; k++) g[k] += e->mu[k] * gl;
                h2[i] = h1[i]; h1[i] = hl;
                g1[i] = gl;
            }
            b2[i] = b1[i]; b1[i] = bl;
            d2[i] = d1[i]; d1[i] = dl;
        }
        for (i = 0; i < sides; i++) {
            p1[i] = p[i];
            p[i] = q[i];
        }
        sum[l] = l == 1 ? C(0.5) * total1 :                     /* Eq. 25, 29 */
            (odd * total1 + C((l - 2) * (l - 1)) * sum[l - 2]) * (inverse[l] * inverse[l + 1]);
        for (k = 0; k < 3 && gradient; k++) sum[(k + 1) * bands + l] = g[k];
        total1 = total;
    }
}

/* The same by integrals of z^k, then O(n) of them combined for each P_l. */
INLINE void monomial_lobe(const int bands, const int gradient, const int sides, const edge *edges,
                          const real omega[3], const real s0, const real *legendre, real *RESTRICT sum)
{
    enum { M = POLYGON_MAX_SIDES };
    real a[M], c[M], d0[M], d1[M], aabb[M], ab[M], i1[M], i2[M], zk[M], t[4][POLYGON_MAX_BANDS], total1 = 0;
    int l, i, k, axis;
    for (axis = 0; axis < 4; axis++) t[axis][0] = 0;
    for (i = 0; i < sides; i++) {
        const edge *e = &edges[i];
        const real b = dot3(omega, e->lambda);
        a[i] = dot3(omega, e->w);
        c[i] = dot3(omega, e->mu);
        d0[i] = b;
        d1[i] = b * e->c - a[i] * e->s;
        aabb[i] = a[i] * a[i] + b * b;
        ab[i] = e->k0 * a[i] + e->k1 * b;
        i1[i] = e->angle;                                       /* integrals of z^{k-1}, z^{k-2} */
        i2[i] = 0;
        zk[i] = 1;                                              /* z^{k-1} at the vertex */
        total1 += c[i] * e->angle;
        for (axis = 0; axis < 3 && gradient; axis++) t[axis + 1][0] += e->mu[axis] * (e->big_k1 - e->big_k0);
    }
    t[0][0] = s0;
    for (k = 1; k < bands; k++) {
        real total = 0, g[3] = { 0, 0, 0 }, next[M];
        for (i = 0; i < sides; i++) next[i] = zk[i] * a[i];
        for (i = 0; i < sides; i++) {
            const int j = i + 1 < sides ? i + 1 : 0;
            const edge *e = &edges[i];
            const real ik = (d0[i] * zk[i] - d1[i] * zk[j] + C(k - 1) * (aabb[i] * i2[i])) * inverse[k];
            total += c[i] * ik;
            if (gradient) {
                const real jk = (next[j] * e->big_k1 - next[i] * e->big_k0 + C(k) * (ab[i] * i1[i]))
                              * inverse[k + 1];
                for (axis = 0; axis < 3; axis++) g[axis] += e->mu[axis] * jk;
            }
            i2[i] = i1[i];
            i1[i] = ik;
        }
        for (i = 0; i < sides; i++) zk[i] = next[i];
        t[0][k] = k == 1 ? C(0.5) * total1 : (total1 + C(k - 1) * t[0][k - 2]) * inverse[k + 1];
        for (axis = 0; axis < 3 && gradient; axis++) t[axis + 1][k] = g[axis];
        total1 = total;
    }
    for (axis = 0; axis < (gradient ? 4 : 1); axis++)
        for (l = 0; l < bands; l++) {
            real s = 0;
            for (k = l & 1; k <= l; k += 2) s += legendre[l * bands + k] * t[axis][k];
            sum[axis * bands + l] = s;
        }
}

/* Algorithm 1 around either: all lobes, then the sparse rotation. */
INLINE void polygon_light(const int monomial, const int bands, const int gradient, const int sides,
                          const polygon_input *in, const real point[3], real *RESTRICT out)
{
    enum { MAX = POLYGON_MAX_BANDS, LOBES = 2 * MAX - 1 };
    const int lobes = 2 * bands - 1, planes = gradient ? 4 : 1;
    edge edges[POLYGON_MAX_SIDES];
    real sums[4 * MAX], by_band[4][MAX][LOBES];
    const real s0 = prepare(sides, gradient, point, in->vertices, edges);
    int d, l, i, plane;
    for (d = 0; d < lobes; d++) {
        if (monomial) monomial_lobe(bands, gradient, sides, edges, in->lobes + 3 * d, s0, in->legendre, sums);
        else legendre_lobe(bands, gradient, sides, edges, in->lobes + 3 * d, s0, sums);
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

#define V real
#define V_SQRT REAL_SQRT
#define FRAME(name) name
#include "polygon_frame.h"

INLINE void frame_light(const int bands, const int gradient, const int sides, const polygon_input *in,
                        const real point[3], real *RESTRICT out)
{
    edge edges[POLYGON_MAX_SIDES];
    const real s0 = prepare(sides, 1, point, in->vertices, edges);
    int i, k;
    for (i = 0; i < (gradient ? 4 : 1) * bands * bands; i++) out[i] = 0;
    for (i = 0; i < sides; i++) {
        const edge *e = &edges[i];
        const real ch = REAL_SQRT(C(0.5) + C(0.5) * e->c), sh = C(0.5) * e->s / ch;
        real mid[3], along[3];
        for (k = 0; k < 3; k++) {
            mid[k] = ch * e->w[k] + sh * e->lambda[k];
            along[k] = ch * e->lambda[k] - sh * e->w[k];
        }
        frame_edge(bands, gradient, in->frame, mid, along, e->mu, e->angle, ch, sh, e->k0 * ch + e->k1 * sh,
                   e->k1 * ch - e->k0 * sh, out);
    }
    out[0] = s0 * C(0.28209479177387814);
}

#define POINT_LOOP(monomial, gradient)                                                                     \
    size_t i;                                                                                              \
    for (i = 0; i < in->points; i++) {                                                                     \
        const real *at = in->point + 3 * i;                                                                \
        real *out = in->out + i * (gradient ? 4 : 1) * BANDS * BANDS;                                      \
        if (monomial == 2) frame_light(BANDS, gradient, in->sides, in, at, out);                           \
        else if (in->sides == 3) polygon_light(monomial, BANDS, gradient, 3, in, at, out);                 \
        else polygon_light(monomial, BANDS, gradient, in->sides, in, at, out);                             \
    }
#define ALL_BANDS(monomial, gradient)                                                                      \
    switch (in->bands) {                                                                                   \
    BANDS_CASE(3, POINT_LOOP(monomial, gradient)) BANDS_CASE(5, POINT_LOOP(monomial, gradient))            \
    BANDS_CASE(9, POINT_LOOP(monomial, gradient)) BANDS_CASE(15, POINT_LOOP(monomial, gradient))           \
    default: break;                                                                                        \
    }

void FN(polygon_monomial)(const bench_case *self)
{
    const polygon_input *in = self->input;
    if (in->gradient) {
        ALL_BANDS(1, 1)
    } else {
        ALL_BANDS(1, 0)
    }
}

void FN(polygon_wang_ramamoorthi)(const bench_case *self)
{
    const polygon_input *in = self->input;
    if (in->gradient) {
        ALL_BANDS(0, 1)
    } else {
        ALL_BANDS(0, 0)
    }
}

void FN(polygon_edge_frame)(const bench_case *self)
{
    const polygon_input *in = self->input;
    if (in->gradient) {
        ALL_BANDS(2, 1)
    } else {
        ALL_BANDS(2, 0)
    }
}
