/* sh_interp.h - lighting anywhere, from coefficients and gradients at grid nodes or scattered samples
 *
 * USE
 *     #include "sh_interp.h"        needs sh_gradient.h beside it, nothing else
 *
 *     sh_grid_f32 grid = { { 0, 0, 0 }, { .5f, .5f, .5f }, { 8, 8, 8 } };      origin, cell, nodes per axis
 *     sh_spheres_grid_f32(5, SH_GRADIENT, 3, &grid, 0, 512, count, spheres, radiance, nodes);
 *     sh_grid_interp_f32(5, SH_GRADIENT, 3, &grid, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, coeffs);
 *
 * DATA
 *     A node's block is [channels][planes][N]: per channel the value (planes SH_VALUES = 1), then d/dx, d/dy, d/dz
 *     (SH_GRADIENT = 4), then xx, xy, xz, yy, yz, zz (SH_HESSIAN = 10). Node (i, j, k) stands at
 *     origin + (i, j, k) cell and is number i + count[0] (j + count[1] k): x fastest.
 *     Any field will do, whatever made it: sphere lights, polygons, cube maps, their sum.
 *
 * SCHEMES           planes error smooth reads  reproduces x^a y^b z^c with
 *     SH_TRILINEAR       1  h^2    C0      8   a, b, c <= 1
 *     SH_HALF_TAYLOR     4  h^3    C0     32   at most one of a, b, c above 1, and that 2
 *     SH_BLENDED_TAYLOR  4  h^2    C0     32   a, b, c <= 1; A04's Eq. 15 with the cell's weights
 *     SH_HERMITE_ZERO    4  h^2    C1     32   at most one of a, b, c above 0, and that <= 3; the papers' Hermite
 *     SH_HERMITE_MIXED   4  h^4    C1    160   at most one above 2, and that 3; next to a border as SH_EDGE_HERMITE
 *     SH_EDGE_HERMITE    4  h^4    C0     32   at most one of a, b, c above 1, and that <= 3
 *     SH_BLENDED_TAYLOR2 10 h^4    C0     80   the same
 *     h is the cell; reads are planes of N numbers per query and channel, and the cost is theirs.
 *     SH_EDGE_HERMITE is the one to use: its 32 data per cell determine exactly its 32 monomials, all cubics among
 *     them, and 12 of degree 4 and 5. SH_HERMITE_MIXED has half its error far from lights, for 5 times its reads.
 *     Within about a cell of a light no scheme is good: evaluate such a light at the point itself.
 *
 * HOW
 *     Every scheme is linear in the data, so a query is a list of (where, weight), and one kernel sums N
 *     coefficients of such a list. The weights are products of weights along the axes. Let L be the linear weights
 *     of a cell's two ends, H the smoothstep ones, P the cubic from values and slopes. Then
 *         Qx Qy Qz + (Px - Qx) Qy Qz + Qx (Py - Qy) Qz + Qx Qy (Pz - Qz)
 *     is edge Hermite with Q = L; the tensor Hermite without mixed derivatives with Q = H; and with Q = the cubic
 *     whose slopes are grid differences D, the tensor Hermite whose mixed derivatives are
 *         f_xy = Dx f_y + Dy f_x - Dx Dy f        f_xyz = Dx Dy f_z + Dx Dz f_y + Dy Dz f_x - 2 Dx Dy Dz f
 *     whose error is the product of two differences' errors. The Taylor schemes have Q = L and P - Q = c times the
 *     slopes' share of the series, c = 1/2 or 1, and 2/3 with 1/6 of the Hessian's.
 *
 * FUNCTIONS (each _f32 and _f64)
 *     sh_grid_interp, _n          coefficients at a point, at many points
 *     sh_grid_gradient, _n        and the interpolant's derivatives
 *     sh_grid_dot, _n             their dot product with a transfer vector, coefficients never stored
 *     sh_sample_taylor            Taylor series of one sample
 *     sh_samples_blend            inverse-distance blend of several, finite and exact at a sample
 *
 * STATUS as in sh_gradient.h
 *
 * CONFIG (define before the first include)
 *     SH_INTERP_FILENAME          the name this file has in your tree     ["sh_interp.h"]
 *
 * SOURCES
 *     A04   Annen et al. 2004, spherical harmonic gradients for mid-range illumination
 *     M22   Mezieres et al. 2022, whose grid this reads (their Hermite is that of Wu et al. 2020)
 */
#if !defined(SHI_ROOM)
#ifndef SH_INTERP_H
#define SH_INTERP_H

#ifndef SH_GRADIENT_FILENAME
#  define SH_GRADIENT_FILENAME "sh_gradient.h"
#endif
#include SH_GRADIENT_FILENAME
#ifndef SH_INTERP_FILENAME
#  define SH_INTERP_FILENAME "sh_interp.h"
#endif

enum sh_scheme {
    SH_TRILINEAR, SH_HALF_TAYLOR, SH_BLENDED_TAYLOR, SH_HERMITE_ZERO, SH_HERMITE_MIXED, SH_EDGE_HERMITE, SH_BLENDED_TAYLOR2
};
enum sh_outside { SH_CLAMP, SH_EXTRAPOLATE };

#define SHI_TERMS      160          /* longest list: SH_HERMITE_MIXED, 64 values and 3 * 32 slopes */
#define SHI_AXIS_NODES (1 << 24)    /* beyond it a float has no place left inside a cell */
#define SHI_REACH      1024         /* cells an extrapolated query may leave the grid by; clamped there */

/* One scheme on one grid: which numbers of the data a query takes, relative to its cell's first node. */
typedef struct {
    int scheme, taps[3];        /* nodes along an axis: 1 (it has no other), 2, 4 (with the cell's neighbours) */
    int neighbours;             /* which of these exist, for taps of 4: bit 2a below, bit 2a + 1 above */
    size_t step[3];             /* numbers from one node to the next */
    size_t n, terms;            /* coefficients; length of the list, a multiple of 4 */
    ptrdiff_t offset[SHI_TERMS];
} shi_stencil;

/* Planes a scheme reads; 0 for a number that is no scheme. */
SHI_INLINE int shi_scheme_planes(int scheme)
{
    return scheme == SH_TRILINEAR ? 1 : scheme == SH_BLENDED_TAYLOR2 ? 10
         : scheme > SH_TRILINEAR && scheme < SH_BLENDED_TAYLOR2 ? 4 : 0;
}

/* Value and gradient at the 8 nodes of a cell: what most schemes read, for which loops are unrolled. */
SHI_INLINE int shi_is_usual(int planes, const int taps[3])
{
    return planes == 4 && taps[0] == 2 && taps[1] == 2 && taps[2] == 2;
}

/* Slopes are taken at the two ends of the cell only. */
SHI_INLINE int shi_is_end(int taps, int tap) { return taps < 4 || tap == 1 || tap == 2; }

/* The offsets, in the order in which the kernel below writes the weights. A neighbour that does not exist has
 * weight 0 and the offset of the cell's end. */
SHI_KERNEL size_t shi_stencil_list(int planes, int tx, int ty, int tz, ptrdiff_t n, ptrdiff_t at[3][4], ptrdiff_t *offset)
{
    size_t k = 0;
    int x, y, z, p;

    for (z = 0; z < tz; z++)
        for (y = 0; y < ty; y++)
            for (x = 0; x < tx; x++) {
                const ptrdiff_t node = at[0][x] + at[1][y] + at[2][z];
                offset[k++] = node;
                if (planes == 1) continue;
                if (shi_is_end(tx, x)) offset[k++] = node + n;
                if (shi_is_end(ty, y)) offset[k++] = node + 2 * n;
                if (shi_is_end(tz, z)) offset[k++] = node + 3 * n;
                for (p = 4; p < planes; p++) offset[k++] = node + p * n;
            }
    while (k % 4) offset[k++] = 0;
    return k;
}

/* Fills in the list of a stencil whose other members are set; again whenever its neighbours change. */
SHI_INLINE void shi_stencil_offsets(shi_stencil *s)
{
    const int planes = shi_scheme_planes(s->scheme), *taps = s->taps;
    const ptrdiff_t n = (ptrdiff_t)s->n;
    ptrdiff_t at[3][4];
    int a;

    for (a = 0; a < 3; a++) {
        const ptrdiff_t step = (ptrdiff_t)s->step[a];
        at[a][0] = s->neighbours >> 2 * a & 1 ? -step : 0;
        at[a][1] = taps[a] == 4 ? 0 : step;
        at[a][2] = step;
        at[a][3] = s->neighbours >> (2 * a + 1) & 1 ? 2 * step : step;
    }
    s->terms = shi_is_usual(planes, taps) ? shi_stencil_list(4, 2, 2, 2, n, at, s->offset)
                                          : shi_stencil_list(planes, taps[0], taps[1], taps[2], n, at, s->offset);
}

#define SHI_FILE SH_INTERP_FILENAME
#define SHI_ROOM SHI_INSTANTIATE
#include SH_GRADIENT_FILENAME

#endif /* SH_INTERP_H */

#elif SHI_ROOM == SHI_TABLES /* -------------------------------------------------------------------------------- */

/* A block of queries in their cells. */
typedef struct {
    SHI_T h[3];                         /* the cell; 0 along an axis of one node */
    SHI_T t[3][SH_BLOCK];               /* place in the cell, 0 .. 1 inside */
    SHI_T rate[3][SH_BLOCK];            /* dt/dpoint */
    SHI_T lower[3][SH_BLOCK];           /* for 4 taps: 1/2 where the cell has a neighbour below, else 0 ... */
    SHI_T upper[3][SH_BLOCK];           /* ... and above */
    size_t first[SH_BLOCK];             /* the number of the data where the cell's first node begins */
    int neighbours[SH_BLOCK];           /* as in shi_stencil; -1 for a point that is not finite */
} SHI_FN(shi_cells);

#elif SHI_ROOM == SHI_KERNELS && (SHI_LANES == 1 || defined(SHI_MANY_LANES)) /* -------------------------------- */

/* Weights of the nodes along one axis, lanes are queries: q and d of the value, Q and P - Q above; s of the slope, e of the
 * second derivative. */
typedef struct { SHI_V q[4], d[4], s[4], e[4]; } SHI_KN(shi_axis_weights);

/* They are linear in six polynomials of the place t in the cell h: with rate = 1/h in place of NULL, those are replaced by
 * their derivatives, and so are the weights. lower, upper as in shi_cells. */
SHI_KERNEL void SHI_KN(shi_axis)(int scheme, int taps, SHI_T h, const SHI_T *at, const SHI_T *rate, const SHI_T *lower,
                                 const SHI_T *upper, SHI_KN(shi_axis_weights) *v)
{
    const SHI_V t = SHI_LOAD(at), u = SHI_C(1) - t, zero = SHI_SPLAT(SHI_C(0));
    SHI_V l0 = u, l1 = t, b = t * u, bt = b * t, bu = b * u, skew = b * (u - t);
    int i;

    if (rate) {
        const SHI_V r = SHI_LOAD(rate);
        l0 = -r;
        l1 = r;
        bt = t * (SHI_C(2) * u - t) * r;
        bu = u * (u - SHI_C(2) * t) * r;
        skew = ((u - t) * (u - t) - SHI_C(2) * b) * r;
        b = (u - t) * r;
    }
    for (i = 0; i < 4; i++) v->d[i] = v->s[i] = v->e[i] = zero;
    v->q[0] = l0;
    v->q[1] = l1;
    if (scheme == SH_TRILINEAR) return;
    if (scheme == SH_HALF_TAYLOR || scheme == SH_BLENDED_TAYLOR || scheme == SH_BLENDED_TAYLOR2) {
        const SHI_T c = scheme == SH_HALF_TAYLOR ? SHI_C(0.5) : scheme == SH_BLENDED_TAYLOR ? SHI_C(1)
                      : SHI_C(0.66666666666666667);         /* 2/3 */
        const SHI_T sixth = SHI_C(0.16666666666666667);
        v->s[0] = (c * h) * b;
        v->s[1] = -v->s[0];
        v->e[0] = (h * h * sixth) * bt;
        v->e[1] = (h * h * sixth) * bu;
    } else if (taps < 4) {
        if (scheme == SH_HERMITE_ZERO) {
            v->q[0] += skew;
            v->q[1] -= skew;
        } else {
            v->d[0] = skew;
            v->d[1] = -skew;
        }
        v->s[0] = h * bu;
        v->s[1] = -(h * bt);
    } else {    /* Q's slopes: (1 - g) f1 - (1 - 2g) f0 - g f-1, central with g = 1/2, one-sided with 0 */
        const SHI_V g = SHI_LOAD(lower), k = SHI_LOAD(upper);
        v->d[0] = g * bu;
        v->d[1] = (SHI_C(1) - SHI_C(2) * g) * bu - (SHI_C(1) - k) * bt;
        v->d[2] = (SHI_C(1) - SHI_C(2) * k) * bt - (SHI_C(1) - g) * bu;
        v->d[3] = k * bt;
        v->q[0] = -v->d[0];
        v->q[1] = (l0 + skew) - v->d[1];
        v->q[2] = (l1 - skew) - v->d[2];
        v->q[3] = -v->d[3];
        v->s[1] = h * bu;
        v->s[2] = -(h * bt);
    }
}

/* A node's weights, v along the three axes, for the planes its scheme reads; returns where the next node's go. */
SHI_KERNEL SHI_T *SHI_KN(shi_node_weights)(const SHI_KN(shi_axis_weights) v[3], int planes, const int *taps,
                                           int x, int y, int z, SHI_T *w)
{
    const SHI_V qx = v[0].q[x], qy = v[1].q[y], qz = v[2].q[z], qq = qy * qz;
    const SHI_V sx = v[0].s[x], sy = v[1].s[y], sz = v[2].s[z];
    const SHI_V c = SHI_SPLAT(SHI_C(0.75));         /* of s s: 1/6 of the Hessian's twice xy from 2/3 of slopes */

    SHI_STORE(w, qx * (qq + (v[1].d[y] * qz + qy * v[2].d[z])) + v[0].d[x] * qq); w += SH_BLOCK;
    if (planes == 1) return w;
    if (shi_is_end(taps[0], x)) { SHI_STORE(w, sx * qq); w += SH_BLOCK; }
    if (shi_is_end(taps[1], y)) { SHI_STORE(w, qx * (sy * qz)); w += SH_BLOCK; }
    if (shi_is_end(taps[2], z)) { SHI_STORE(w, qx * (qy * sz)); w += SH_BLOCK; }
    if (planes == 4) return w;
    SHI_STORE(w,                v[0].e[x] * qq);
    SHI_STORE(w + SH_BLOCK,     c * sx * (sy * qz));
    SHI_STORE(w + 2 * SH_BLOCK, c * sx * (qy * sz));
    SHI_STORE(w + 3 * SH_BLOCK, qx * (v[1].e[y] * qz));
    SHI_STORE(w + 4 * SH_BLOCK, c * qx * (sy * sz));
    SHI_STORE(w + 5 * SH_BLOCK, qx * (qy * v[2].e[z]));
    return w + 6 * SH_BLOCK;
}

/* The three axes of one vector of queries, from number `lane` of the block on; along = 0, 1, 2: with the derivative of that
 * axis, -1: none. */
SHI_KERNEL void SHI_KN(shi_three_axes)(int scheme, const int *taps, int along, const SHI_FN(shi_cells) *c, int lane,
                                       SHI_KN(shi_axis_weights) v[3])
{
    int a;
    SHI_UNROLL
    for (a = 0; a < 3; a++)
        SHI_KN(shi_axis)(scheme, taps[a], c->h[a], c->t[a] + lane, along == a ? c->rate[a] + lane : NULL, c->lower[a] + lane,
                         c->upper[a] + lane, v + a);
}

/* Weights of a block of queries, w[terms][SH_BLOCK]: of the value (along = -1), or of its derivative by coordinate `along`. */
SHI_INLINE void SHI_KN(shi_weights)(const shi_stencil *s, int along, const SHI_FN(shi_cells) *c, SHI_T *w)
{
    const int planes = shi_scheme_planes(s->scheme), *taps = s->taps, two[3] = { 2, 2, 2 };
    const int usual = shi_is_usual(planes, taps);
    SHI_KN(shi_axis_weights) v[3];
    int lane, x, y, z;

    for (lane = 0; usual && lane + SHI_W <= SH_BLOCK; lane += SHI_W) {      /* the loops below, unrolled */
        SHI_T *o = w + lane;
        SHI_KN(shi_three_axes)(s->scheme, two, along, c, lane, v);
        SHI_UNROLL
        for (z = 0; z < 2; z++) {
            o = SHI_KN(shi_node_weights)(v, 4, two, 0, 0, z, o);
            o = SHI_KN(shi_node_weights)(v, 4, two, 1, 0, z, o);
            o = SHI_KN(shi_node_weights)(v, 4, two, 0, 1, z, o);
            o = SHI_KN(shi_node_weights)(v, 4, two, 1, 1, z, o);
        }
    }
    for (; lane + SHI_W <= SH_BLOCK; lane += SHI_W) {
        SHI_T *o = w + lane;
        SHI_KN(shi_three_axes)(s->scheme, taps, along, c, lane, v);
        for (z = 0; z < taps[2]; z++)
            for (y = 0; y < taps[1]; y++)
                for (x = 0; x < taps[0]; x++) o = SHI_KN(shi_node_weights)(v, planes, taps, x, y, z, o);
        for (; o < w + s->terms * SH_BLOCK; o += SH_BLOCK) SHI_STORE(o, SHI_SPLAT(SHI_C(0)));
    }
}

/* Where the v-th of some vectors of coefficients is: side by side but the last, which may overlap the one before it
 * (the same numbers again), so that nothing beyond the n coefficients is touched. */
#define SHI_AT(v) ((v) + 1 < vectors ? (size_t)((v) * SHI_W) : last)

/* sum[v] of the list: weights w[k * SH_BLOCK] times the numbers at from + offset[k]. */
SHI_KERNEL void SHI_KN(shi_list)(const int vectors, size_t last, size_t terms, const ptrdiff_t *offset,
                                 const SHI_T *w, const SHI_T *from, SHI_V *sum)
{
    size_t k;
    int v;

    SHI_UNROLL
    for (v = 0; v < vectors; v++) sum[v] = SHI_SPLAT(SHI_C(0));
    for (k = 0; k < terms; k += 4, offset += 4, w += 4 * SH_BLOCK) {
        const SHI_T *a = from + offset[0], *b = from + offset[1], *c = from + offset[2], *d = from + offset[3];
        const SHI_V wa = SHI_SPLAT(w[0]), wb = SHI_SPLAT(w[SH_BLOCK]);
        const SHI_V wc = SHI_SPLAT(w[2 * SH_BLOCK]), wd = SHI_SPLAT(w[3 * SH_BLOCK]);
        SHI_UNROLL
        for (v = 0; v < vectors; v++)
            sum[v] += wa * SHI_LOAD(a + SHI_AT(v)) + wb * SHI_LOAD(b + SHI_AT(v))
                    + wc * SHI_LOAD(c + SHI_AT(v)) + wd * SHI_LOAD(d + SHI_AT(v));
    }
}

/* ... stored at out[n] */
SHI_KERNEL void SHI_KN(shi_list_store)(const int vectors, size_t last, size_t terms, const ptrdiff_t *offset,
                                       const SHI_T *w, const SHI_T *from, SHI_T *out)
{
    SHI_V sum[8];
    int v;
    SHI_KN(shi_list)(vectors, last, terms, offset, w, from, sum);
    SHI_UNROLL
    for (v = 0; v < vectors; v++) SHI_STORE(out + SHI_AT(v), sum[v]);
}

/* *dot += the sums times the transfer; `tail` is the transfer of the last vector, 0 where it overlaps. */
SHI_KERNEL void SHI_KN(shi_list_dot)(const int vectors, size_t last, size_t terms, const ptrdiff_t *offset,
                                     const SHI_T *w, const SHI_T *from, const SHI_T *transfer, const SHI_T *tail,
                                     SHI_V *dot)
{
    SHI_V sum[8];
    int v;
    SHI_KN(shi_list)(vectors, last, terms, offset, w, from, sum);
    SHI_UNROLL
    for (v = 0; v < vectors; v++) *dot += sum[v] * SHI_LOAD(v + 1 < vectors ? transfer + v * SHI_W : tail);
}

/* How many vectors to sum at a time of those left, and a list for that number: up to 8, as many accumulators as hide an
 * addition's latency and fit in registers. */
#if SHI_LANES == 1 && SH_VECTOR_BYTES       /* what a register is too wide for: one coefficient, or four */
#define SHI_PASS(left) ((left) < 4 ? 1 : 4)
#define SHI_VECTORS(now, list, ...) if (now == 4) list(4, __VA_ARGS__); else list(1, __VA_ARGS__);
#else
#define SHI_PASS(left) ((left) <= 8 ? (left) : (left) < 16 ? ((left) + 1) / 2 : 8)
#define SHI_VECTORS(now, list, ...) \
    switch (now) { \
    case 1: list(1, __VA_ARGS__); break;  case 2: list(2, __VA_ARGS__); break;  case 3: list(3, __VA_ARGS__); break; \
    case 4: list(4, __VA_ARGS__); break;  case 5: list(5, __VA_ARGS__); break;  case 6: list(6, __VA_ARGS__); break; \
    case 7: list(7, __VA_ARGS__); break;  default: list(8, __VA_ARGS__); break; \
    }
#endif

/* n coefficients of the list. 0, with nothing done, if a vector holds more than n. */
SHI_INLINE int SHI_KN(shi_gather)(size_t n, size_t terms, const ptrdiff_t *offset, const SHI_T *w,
                                  const SHI_T *from, SHI_T *out)
{
    const size_t lanes = (size_t)SHI_W;
    size_t left = (n + lanes - 1) / lanes, now;

    if (n < lanes) return 0;
    for (; left; left -= now, n -= now * lanes, from += now * lanes, out += now * lanes) {
        const size_t last = (now = SHI_PASS(left)) == left ? n - lanes : (now - 1) * lanes;
        SHI_VECTORS(now, SHI_KN(shi_list_store), last, terms, offset, w, from, out)
    }
    return 1;
}

/* The same, for the dot product with transfer[n]. */
SHI_INLINE int SHI_KN(shi_gather_dot)(size_t n, size_t terms, const ptrdiff_t *offset, const SHI_T *w,
                                      const SHI_T *from, const SHI_T *transfer, SHI_T *value)
{
    const size_t lanes = (size_t)SHI_W;
    size_t left = (n + lanes - 1) / lanes, now;
    const size_t rest = n - (left - 1) * lanes;     /* what the last vector does not share with the one before */
    SHI_T end[SHI_W];
    SHI_V dot, group = SHI_SPLAT(SHI_C(0)), total = group;      /* at most 8, 12 and 11 additions one after another */
    int pass;

    if (n < lanes) return 0;
    memset(end, 0, sizeof end);
    memcpy(end + lanes - rest, transfer + n - rest, rest * sizeof *end);
    for (pass = 1; left; left -= now, n -= now * lanes, from += now * lanes, transfer += now * lanes, pass++) {
        const size_t last = (now = SHI_PASS(left)) == left ? n - lanes : (now - 1) * lanes;
        const SHI_T *const tail = now == left ? end : transfer + last;
        dot = SHI_SPLAT(SHI_C(0));
        SHI_VECTORS(now, SHI_KN(shi_list_dot), last, terms, offset, w, from, transfer, tail, &dot)
        group += dot;
        if (pass % 12 == 0) {
            total += group;
            group = SHI_SPLAT(SHI_C(0));
        }
    }
    *value = SHI_SUM(total + group);
    return 1;
}
#undef SHI_VECTORS
#undef SHI_PASS
#undef SHI_AT

#elif SHI_ROOM == SHI_PUBLIC /* -------------------------------------------------------------------------------- */

/* A call: what, where, and for whom. One form for all of the grid's functions; `transfers` for the fused ones. */
typedef struct {
    int bands, planes, channels, scheme, outside, planes_out;
    const SHI_FN(sh_grid) *grid;
    const SHI_T *nodes;
    size_t count;
    const SHI_T *points, *transfers;
    SHI_T *out;                 /* [count][channels][planes_out][n], or [count][channels] dot products */
} SHI_FN(shi_query);

/* An axis as the queries see it: in cells from the origin, a query is clamped to low .. high and lies in cell
 * 0 .. top. An axis of one node has low = high = top = inverse = 0. */
typedef struct { SHI_T origin, inverse, low, high, edge, top; } SHI_FN(shi_range);

/* Checks what a call is given beside its points, O(1), and prepares its stencil. */
SHI_INLINE int SHI_FN(shi_grid_stencil)(const SHI_FN(shi_query) *c, shi_stencil *s)
{
    const SHI_FN(sh_grid) *g = c->grid;
    const int reads = shi_scheme_planes(c->scheme);
    double bytes;
    int a;

    if (c->bands < 1 || c->bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (c->channels < 1) return SH_ERROR_COUNT;
    if (c->planes != SH_VALUES && c->planes != SH_GRADIENT && c->planes != SH_HESSIAN) return SH_ERROR_OPTION;
    if (!reads || reads > c->planes) return SH_ERROR_OPTION;
    if (c->outside != SH_CLAMP && c->outside != SH_EXTRAPOLATE) return SH_ERROR_OPTION;
    if (!g || (c->count && !c->nodes)) return SH_ERROR_NULL;
    if (!SHI_FN(shi_finite)(g->origin, 3) || !SHI_FN(shi_finite)(g->cell, 3)) return SH_ERROR_NOT_FINITE;
    s->scheme = c->scheme;
    s->neighbours = 0;
    s->n = (size_t)c->bands * (size_t)c->bands;
    s->step[0] = s->n * (size_t)c->planes * (size_t)c->channels;
    bytes = (double)s->n * c->planes * c->channels * (double)sizeof(SHI_T);
    for (a = 0; a < 3; a++) {
        const int count = g->count[a];
        if (count < 1) return SH_ERROR_GRID;
        if (count > 1 && !(g->cell[a] >= SHI_C(1e-18) && g->cell[a] <= SHI_C(1e18))) return SH_ERROR_GRID;
        bytes *= count;
        if (count > SHI_AXIS_NODES || bytes > (double)((size_t)-1 / 2)) return SH_ERROR_COUNT;
        if (a < 2) s->step[a + 1] = s->step[a] * (size_t)count;
        s->taps[a] = count == 1 ? 1 : count == 2 || c->scheme != SH_HERMITE_MIXED ? 2 : 4;
    }
    shi_stencil_offsets(s);
    return SH_OK;
}

/* A query's cell, the place t in it and rate = dt/dpoint. The error of t is that of a point moved by
 * 2 eps |point - origin|. */
SHI_INLINE size_t SHI_FN(shi_locate)(const SHI_FN(shi_range) *r, SHI_T point, SHI_T *t, SHI_T *rate)
{
    const SHI_T x = (point - r->origin) * r->inverse;
    const SHI_T inside = x > r->low ? x < r->high ? x : r->high : r->low;     /* low for NaN: infinity times 0 */
    const SHI_T ahead = inside > 0 ? inside : 0, cell = ahead < r->top ? ahead : r->top;
    const int i = (int)cell;

    *t = inside - (SHI_T)i;
    /* the last node, however it is rounded, is inside */
    *rate = x >= r->low && x <= r->edge ? r->inverse : 0;
    return (size_t)i;
}

/* One list, in registers if a vector holds no more than n coefficients. */
SHI_INLINE void SHI_FN(shi_gather)(size_t n, size_t terms, const ptrdiff_t *offset, const SHI_T *w,
                                   const SHI_T *from, SHI_T *out)
{
    if (SHI_MANY(shi_gather)(n, terms, offset, w, from, out)) return;
    SHI_ONE(shi_gather)(n, terms, offset, w, from, out);
}

SHI_INLINE void SHI_FN(shi_gather_dot)(size_t n, size_t terms, const ptrdiff_t *offset, const SHI_T *w,
                                       const SHI_T *from, const SHI_T *transfer, SHI_T *value)
{
    if (SHI_MANY(shi_gather_dot)(n, terms, offset, w, from, transfer, value)) return;
    SHI_ONE(shi_gather_dot)(n, terms, offset, w, from, transfer, value);
}

/* The axes as the queries see them. */
SHI_INLINE void SHI_FN(shi_ranges)(const SHI_FN(shi_query) *c, SHI_FN(shi_range) range[3])
{
    const SHI_T reach = c->outside == SH_EXTRAPOLATE ? SHI_C(SHI_REACH) : 0;
    int a;

    memset(range, 0, 3 * sizeof *range);
    for (a = 0; a < 3; a++)
        if (c->grid->count[a] > 1) {
            range[a].origin = c->grid->origin[a];
            range[a].inverse = 1 / c->grid->cell[a];
            range[a].low = -reach;
            range[a].high = (SHI_T)(c->grid->count[a] - 1) + reach;
            range[a].edge = range[a].high * (1 + 4 * SHI_EPS)      /* where the last node may be rounded to */
                          + SHI_EPS * SHI_LIBM(fabs)(range[a].origin) * range[a].inverse;
            range[a].top = (SHI_T)(c->grid->count[a] - 2);
        }
}

/* The cells of `count` queries, at most SH_BLOCK; SH_ERROR_NOT_FINITE if one of the points is not. */
SHI_INLINE int SHI_FN(shi_locate_block)(const SHI_FN(shi_query) *c, const shi_stencil *s, const SHI_FN(shi_range) range[3],
                                        const SHI_T *points, size_t count, SHI_FN(shi_cells) *cells)
{
    int a, status = SH_OK;
    size_t q;

    for (q = 0; q < count; q++, points += 3) {
        cells->first[q] = 0;
        cells->neighbours[q] = 0;
        if (!SHI_FN(shi_finite)(points, 3)) {
            status = SH_ERROR_NOT_FINITE;
            cells->neighbours[q] = -1;
            continue;
        }
        for (a = 0; a < 3; a++) {
            const size_t i = SHI_FN(shi_locate)(&range[a], points[a], &cells->t[a][q], &cells->rate[a][q]);
            cells->first[q] += s->step[a] * i;
            if (s->taps[a] == 4) {
                const int lower = i > 0, upper = i + 2 < (size_t)c->grid->count[a];
                cells->neighbours[q] |= lower << 2 * a | upper << (2 * a + 1);
                cells->lower[a][q] = lower ? SHI_C(0.5) : 0;
                cells->upper[a][q] = upper ? SHI_C(0.5) : 0;
            }
        }
    }
    return status;
}

/* Queries in blocks of SH_BLOCK: their cells, then their weights in lanes, then one list each. */
SHI_INLINE int SHI_FN(shi_grid_queries)(const SHI_FN(shi_query) *c, shi_stencil *s)
{
    const size_t channels = (size_t)c->channels, planes_out = (size_t)c->planes_out;
    SHI_T w[SHI_TERMS * SH_BLOCK];
    SHI_FN(shi_range) range[3];
    SHI_FN(shi_cells) cells;
    size_t done, q, items, channel, p;
    int a, status = SH_OK;

    SHI_FN(shi_ranges)(c, range);
    memset(&cells, 0, sizeof cells);
    for (a = 0; a < 3; a++) cells.h[a] = c->grid->count[a] > 1 ? c->grid->cell[a] : 0;
    for (done = 0; done < c->count; done += items) {
        items = c->count - done < (size_t)SH_BLOCK ? c->count - done : (size_t)SH_BLOCK;
        if (SHI_FN(shi_locate_block)(c, s, range, c->points + 3 * done, items, &cells) != SH_OK) status = SH_ERROR_NOT_FINITE;
        for (p = 0; p < planes_out; p++) {
            SHI_MANY(shi_weights)(s, (int)p - 1, &cells, w);
            for (q = 0; q < items; q++) {
                const SHI_T *from = c->nodes + cells.first[q];
                if (cells.neighbours[q] < 0) continue;
                if (cells.neighbours[q] != s->neighbours) {
                    s->neighbours = cells.neighbours[q];
                    shi_stencil_offsets(s);
                }
                for (channel = 0; channel < channels; channel++, from += s->n * (size_t)c->planes) {
                    const size_t item = (done + q) * channels + channel;
                    if (c->transfers)
                        SHI_FN(shi_gather_dot)(s->n, s->terms, s->offset, w + q, from,
                                               c->transfers + (done + q) * s->n, c->out + item);
                    else
                        SHI_FN(shi_gather)(s->n, s->terms, s->offset, w + q, from, c->out + (item * planes_out + p) * s->n);
                }
            }
        }
    }
    return status;
}

/* Checks and answers a call on a grid. */
SHI_NOINLINE int SHI_FN(shi_grid_call)(const SHI_FN(shi_query) *c)
{
    const size_t channels = (size_t)c->channels;
    shi_stencil s;
    size_t out;
    const int status = SHI_FN(shi_grid_stencil)(c, &s);

    if (status != SH_OK || c->count == 0) return status;
    if (c->count > SHI_MOST(SH_HESSIAN * s.n) / channels) return SH_ERROR_COUNT;
    if (!c->points || !c->out) return SH_ERROR_NULL;
    out = c->count * channels * (c->transfers ? 1 : (size_t)c->planes_out * s.n) * sizeof(SHI_T);
    if (shi_overlap(c->out, out, c->nodes, s.step[2] * (size_t)c->grid->count[2] * sizeof(SHI_T))
        || shi_overlap(c->out, out, c->points, 3 * c->count * sizeof(SHI_T))
        || shi_overlap(c->out, out, c->transfers, c->count * s.n * sizeof(SHI_T))) return SH_ERROR_OVERLAP;
    return SHI_FN(shi_grid_queries)(c, &s);
}

/* Coefficients at many points, out of the grid's nodes.
 *   bands      1..32
 *   planes     SH_VALUES, SH_GRADIENT or SH_HESSIAN: what the nodes store; at least what the scheme reads
 *   channels   >= 1
 *   grid       origin, cell and nodes per axis. An axis of one node is constant: its origin and cell need only be finite. Other
 *              cells are 1e-18 .. 1e18, no axis has more than 2^24 nodes. Gradients of SH_BLENDED_TAYLOR2 need
 *              cell_i^2 / cell_j in the range of T too, for any two axes
 *   nodes      [nodes][channels][planes][N], the layout of sh_spheres_grid
 *   scheme     enum sh_scheme
 *   outside    SH_CLAMP: a point outside of the grid gets the coefficients of the nearest point inside;
 *              SH_EXTRAPOLATE: the border cell's polynomial, up to 1024 cells out and clamped there; the weights of Hermite
 *              schemes that far out times a cell, of SH_BLENDED_TAYLOR2 times two, must be in the range of T
 *   points     [count][3], any finite points
 *   coeffs     [count][channels][N], overlapping no input
 * Status SH_ERROR_NOT_FINITE: a point is not, its outputs are untouched, those of the others are written.
 * NaN among the coefficients of a node comes out of every query that reads the node.
 * Error:  <= 8 eps of the largest |value|, cell |slope|, cell^2 |Hessian| read, for the long sums of SH_HERMITE_MIXED and
 *         SH_BLENDED_TAYLOR2 24 eps (`make test` sees 2.1), at a point moved by 2 eps |point - origin|;
 *         extrapolated t cells out, times (1 + 2|t|)^3 per axis.
 *         One call's point has the bits that it has in any batch.
 * Source: the table on top; M22 5.1 for the grid, A04 Eq. 15 for SH_BLENDED_TAYLOR with the cell's weights. */
SH_API int SHI_FN(sh_grid_interp_n)(int bands, int planes, int channels, const SHI_FN(sh_grid) *grid,
                                    const SHI_T *nodes, int scheme, int outside, size_t count,
                                    const SHI_T *points, SHI_T *coeffs)
{
    const SHI_FN(shi_query) call = { bands, planes, channels, scheme, outside, SH_VALUES, grid, nodes,
                                     count, points, NULL, coeffs };
    return SHI_FN(shi_grid_call)(&call);
}

/* One point: coeffs[channels][N]. Many points in one call cost 0.5 to 0.7 of it each. */
SH_API int SHI_FN(sh_grid_interp)(int bands, int planes, int channels, const SHI_FN(sh_grid) *grid,
                                  const SHI_T *nodes, int scheme, int outside, const SHI_T point[3], SHI_T *coeffs)
{
    return SHI_FN(sh_grid_interp_n)(bands, planes, channels, grid, nodes, scheme, outside, 1, point, coeffs);
}

/* The interpolant with its exact derivatives by the point, in the layout of a node with gradients: a grid resampled
 * is a grid, and a point interpolated is a sample for sh_sample_taylor.
 *   out   [count][channels][4][N]: coefficients (the bits of sh_grid_interp), d/dx, d/dy, d/dz; overlapping no input
 * Derivatives across the border of a clamped query are 0, on the border, wherever rounding puts it, those of its cell. At an
 * inner face of a C0 scheme they are those of one of its two cells: which, is a matter of rounding.
 * Error:  <= 16 eps of the largest datum as above, per cell size; SH_HERMITE_MIXED and SH_BLENDED_TAYLOR2 80 eps.
 * Source: the same sums with the weights' derivatives. */
SH_API int SHI_FN(sh_grid_gradient_n)(int bands, int planes, int channels, const SHI_FN(sh_grid) *grid,
                                      const SHI_T *nodes, int scheme, int outside, size_t count,
                                      const SHI_T *points, SHI_T *out)
{
    const SHI_FN(shi_query) call = { bands, planes, channels, scheme, outside, SH_GRADIENT, grid, nodes,
                                     count, points, NULL, out };
    return SHI_FN(shi_grid_call)(&call);
}

/* One point: out[channels][4][N]. */
SH_API int SHI_FN(sh_grid_gradient)(int bands, int planes, int channels, const SHI_FN(sh_grid) *grid,
                                    const SHI_T *nodes, int scheme, int outside, const SHI_T point[3], SHI_T *out)
{
    return SHI_FN(sh_grid_gradient_n)(bands, planes, channels, grid, nodes, scheme, outside, 1, point, out);
}

/* Dot products of the coefficients at many points, each with its transfer vector, N coefficients never stored.
 *   transfers   [count][N], one for all channels
 *   values      [count][channels], overlapping no input
 * Error:  <= 16 eps of the sum of magnitudes, beyond that of the coefficients.
 * Source: A04 Eq. 3. */
SH_API int SHI_FN(sh_grid_dot_n)(int bands, int planes, int channels, const SHI_FN(sh_grid) *grid,
                                 const SHI_T *nodes, int scheme, int outside, size_t count,
                                 const SHI_T *points, const SHI_T *transfers, SHI_T *values)
{
    const SHI_FN(shi_query) call = { bands, planes, channels, scheme, outside, SH_VALUES, grid, nodes,
                                     count, points, transfers, values };
    return !transfers && count ? SH_ERROR_NULL : SHI_FN(shi_grid_call)(&call);
}

/* One point and transfer[N]: values[channels]. */
SH_API int SHI_FN(sh_grid_dot)(int bands, int planes, int channels, const SHI_FN(sh_grid) *grid,
                               const SHI_T *nodes, int scheme, int outside, const SHI_T point[3],
                               const SHI_T *transfer, SHI_T *values)
{
    return SHI_FN(sh_grid_dot_n)(bands, planes, channels, grid, nodes, scheme, outside, 1, point, transfer, values);
}

/* ---- scattered samples ---- */

/* Weight at distance r relative to that at the distance `nearest`: (nearest/r)^power, 1 where r is no longer. */
SHI_INLINE SHI_T SHI_FN(shi_falloff)(SHI_T nearest, SHI_T r, SHI_T power)
{
    SHI_T x;
    if (!(r > nearest)) return 1;
    x = nearest / r;
    return power == 2 ? x * x : (SHI_T)pow((double)x, (double)power);
}

/* The Taylor series of one sample as a list: weight times { 1; d; d d / 2 } for its planes from `at` on. */
SHI_INLINE size_t SHI_FN(shi_taylor_terms)(size_t k, int planes, ptrdiff_t n, const SHI_T d[3], SHI_T weight,
                                           ptrdiff_t at, ptrdiff_t *offset, SHI_T *w)
{
    const SHI_T h = weight * SHI_C(0.5);
    SHI_T v[10];
    int p;

    v[0] = weight; v[1] = weight * d[0]; v[2] = weight * d[1]; v[3] = weight * d[2];
    v[4] = h * d[0] * d[0]; v[5] = v[1] * d[1]; v[6] = v[1] * d[2];
    v[7] = h * d[1] * d[1]; v[8] = v[2] * d[2]; v[9] = h * d[2] * d[2];
    for (p = 0; p < planes; p++, k++) {
        offset[k] = at + p * n;
        w[k * SH_BLOCK] = v[p];
    }
    return k;
}

/* d = point - sample and its length; negative if a component is beyond 1e18 */
SHI_INLINE SHI_T SHI_FN(shi_difference)(const SHI_T point[3], const SHI_T sample[3], SHI_T d[3])
{
    SHI_T large = 0, sum = 0;
    int a;

    for (a = 0; a < 3; a++) {
        d[a] = point[a] - sample[a];
        large = d[a] > large ? d[a] : -d[a] > large ? -d[a] : large;
    }
    if (large == 0) return 0;
    if (!(large <= SHI_C(1e18))) return -1;
    for (a = 0; a < 3; a++) sum += (d[a] / large) * (d[a] / large);
    return large * SHI_LIBM(sqrt)(sum);
}

/* The samples' weights from their distances, and then one list, in parts of at most SHI_TERMS; checks first. */
SHI_NOINLINE int SHI_FN(shi_samples)(int bands, int planes, int channels, SHI_T power, size_t count,
                                     const SHI_T *samples, const SHI_T *blocks, const SHI_T *point, SHI_T *coeffs)
{
    const size_t n = (size_t)(bands > 0 ? bands : 0) * (size_t)(bands > 0 ? bands : 0);
    const size_t out = n * (size_t)(channels > 0 ? channels : 0) * sizeof(SHI_T);
    size_t block, j, done, k, i, channel;
    SHI_T nearest = 0, total = 0, d[3], sums[8 * sizeof(size_t)], w[SHI_TERMS * SH_BLOCK], part[SH_MAX_BANDS * SH_MAX_BANDS];
    ptrdiff_t offset[SHI_TERMS];

    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (planes != SH_VALUES && planes != SH_GRADIENT && planes != SH_HESSIAN) return SH_ERROR_OPTION;
    if (!SHI_FN(shi_finite)(&power, 1) || !(power > 0 && power <= SHI_C(64))) return SH_ERROR_OPTION;
    if (channels < 1 || count < 1 || count > SHI_MOST(n * (size_t)planes + 3) / (size_t)channels) return SH_ERROR_COUNT;
    if (!samples || !blocks || !point || !coeffs) return SH_ERROR_NULL;
    block = n * (size_t)planes * (size_t)channels;
    if (shi_overlap(coeffs, out, blocks, count * block * sizeof *blocks)
        || shi_overlap(coeffs, out, samples, 3 * count * sizeof *samples)
        || shi_overlap(coeffs, out, point, 3 * sizeof *point)) return SH_ERROR_OVERLAP;
    if (!SHI_FN(shi_finite)(point, 3) || !SHI_FN(shi_finite)(samples, 3 * count)) return SH_ERROR_NOT_FINITE;
    for (j = 0; j < count; j++) {
        const SHI_T r = SHI_FN(shi_difference)(point, samples + 3 * j, d);
        if (r < 0) return SH_ERROR_NOT_FINITE;
        if (j == 0 || r < nearest) nearest = r;
    }
    /* weights relative to the nearest sample's: 1 for it, at most 1 for the others, whatever the distances; added up in pairs,
     * pairs of pairs and so on: sums[i] is that of 2^i samples where bit i of j is set */
    for (j = 0; j < count; j++) {
        SHI_T sum = SHI_FN(shi_falloff)(nearest, SHI_FN(shi_difference)(point, samples + 3 * j, d), power);
        for (i = 0; j >> i & 1; i++) sum += sums[i];
        sums[i] = sum;
    }
    for (i = 0; count >> i; i++)
        if (count >> i & 1) total += sums[i];
    for (done = 0; done < count; done = j) {
        for (j = done, k = 0; j < count && k + (size_t)planes <= SHI_TERMS; j++) {
            const SHI_T r = SHI_FN(shi_difference)(point, samples + 3 * j, d);
            const SHI_T weight = SHI_FN(shi_falloff)(nearest, r, power) / total;
            const ptrdiff_t at = (ptrdiff_t)((j - done) * block);
            k = SHI_FN(shi_taylor_terms)(k, planes, (ptrdiff_t)n, d, weight, at, offset, w);
        }
        for (; k % 4; k++) {
            offset[k] = 0;
            w[k * SH_BLOCK] = 0;
        }
        for (channel = 0; channel < (size_t)channels; channel++) {
            const SHI_T *from = blocks + done * block + channel * (size_t)planes * n;
            SHI_T *o = coeffs + channel * n;
            SHI_FN(shi_gather)(n, k, offset, w, from, done ? part : o);
            for (i = 0; done && i < n; i++) o[i] += part[i];
        }
    }
    return SH_OK;
}

/* Inverse-distance blend of the Taylor series of scattered samples: sum of w_j (f_j + g_j . d_j + ...), d_j = point -
 * sample j, w_j proportional to 1/|d_j|^power.
 *   bands     1..32
 *   planes    SH_VALUES, SH_GRADIENT, SH_HESSIAN: the samples' series are of order 0, 1 (A04), 2
 *   channels  >= 1
 *   power     in (0, 64] (else SH_ERROR_OPTION), A04's b: 2 is the usual one; above 1 the blend has the samples'
 *             gradients at the samples
 *   count     >= 1
 *   samples   [count][3], each coordinate within 1e18 of the point's (else SH_ERROR_NOT_FINITE)
 *   blocks    [count][channels][planes][N]
 *   coeffs    [channels][N], overlapping no input
 *   point     [3]
 * At a sample the blend is that sample, to the bit but for the sign of zero (Eq. 16 is 0/0 there), if all data are finite;
 * samples in one place share its weight. Polynomials of the samples' order are reproduced. Cost: count * planes reads of N
 * numbers, so choose few.
 * Error:  <= (12 + 2 power + count/64) eps of the largest |f_j| + |g_j| |d_j| + |H_j| |d_j|^2/2, 2-norms.
 * Source: A04 Eq. 14-16. */
SH_API int SHI_FN(sh_samples_blend)(int bands, int planes, int channels, SHI_T power, size_t count,
                                    const SHI_T *samples, const SHI_T *blocks, const SHI_T point[3], SHI_T *coeffs)
{
    return SHI_FN(shi_samples)(bands, planes, channels, power, count, samples, blocks, point, coeffs);
}

/* The Taylor series of one sample, at a point: a blend of one. Its error grows as (|d| / distance of the nearest
 * light)^(order + 1).
 *   sample[3], block[channels][planes][N], coeffs[channels][N]
 * Error:  of rounding, as sh_samples_blend.
 * Source: A04 Eq. 4 and 14, with Hessians the next order. */
SH_API int SHI_FN(sh_sample_taylor)(int bands, int planes, int channels, const SHI_T sample[3], const SHI_T *block,
                                    const SHI_T point[3], SHI_T *coeffs)
{
    return SHI_FN(shi_samples)(bands, planes, channels, 1, 1, sample, block, point, coeffs);
}

#endif /* rooms */

/*
 * MIT License
 *
 * Copyright (c) 2026 the shlight authors
 *
 * Permission is hereby granted, free of charge, to any person obtaining a copy
 * of this software and associated documentation files (the "Software"), to deal
 * in the Software without restriction, including without limitation the rights
 * to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
 * copies of the Software, and to permit persons to whom the Software is
 * furnished to do so, subject to the following conditions:
 *
 * The above copyright notice and this permission notice shall be included in all
 * copies or substantial portions of the Software.
 *
 * THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
 * IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
 * FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
 * AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
 * LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
 * OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
 * SOFTWARE.
 */
