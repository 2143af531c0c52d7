/* polygon_ref.h - polygons by adaptive quadrature in the plane, in long double: shares nothing with the
 * header's recurrences, edges or spherical triangles.
 *
 * The fan of vertex 0 is bisected along longest sides until a piece is small against its distance, then
 * integrated by a 20 x 20 Gauss rule of Y(p/|p|) (p.n)/|p|^3 and of its derivative by the point. p.n is a
 * constant of the plane; it is exact when the differences of coordinates fit 21 bits, which the tests see to
 * where it matters. */
#ifndef SH_TESTS_POLYGON_REF_H
#define SH_TESTS_POLYGON_REF_H

#include "ref.h"
#if defined(__clang__)
#  pragma clang diagnostic ignored "-Wdouble-promotion"       /* double to long double is meant */
#endif
#include <math.h>
#include <string.h>

enum { REF_POLYGON_BANDS = 16, REF_POLYGON_SIZE = 256, REF_POLYGON_NODES = 20 };

typedef struct {
    long double c[REF_POLYGON_SIZE],
        g[3][REF_POLYGON_SIZE]; /* sign: positive where vertices run clockwise, i.e. from behind */
    long double solid, slope; /* sum over the fan of |Omega|, of |grad Omega| */
    long double nearest, edge; /* distance of the nearest vertex; of an edge over its length */
} ref_polygon_light;

/* values and tangential gradient by (l-m) recurrences in long double; not ref_basis, whose jets are 100 times
 * slower */
static inline void ref_polygon_basis(int n, const long double u[3], long double *y, long double *g)
{
    static long double norm[REF_POLYGON_BANDS][REF_POLYGON_BANDS];
    long double q[REF_POLYGON_BANDS + 2][REF_POLYGON_BANDS + 2], c[REF_POLYGON_BANDS + 1],
        s[REF_POLYGON_BANDS + 1];
    const int size = n * n;
    int l, m, k;
    if (norm[0][0] == 0)
        for (l = 0; l < REF_POLYGON_BANDS; l++)
            for (m = 0; m <= l; m++) {
                long double f = (2 * l + 1) / (4 * REF_PI) * (m ? 2 : 1);
                for (k = l - m + 1; k <= l + m; k++) f /= k;
                norm[l][m] = (m & 1 ? -1 : 1) * sqrtl(f);
            }
    c[0] = 1;
    s[0] = 0;
    for (m = 1; m <= n; m++) {
        c[m] = u[0] * c[m - 1] - u[1] * s[m - 1];
        s[m] = u[0] * s[m - 1] + u[1] * c[m - 1];
    }
    memset(q, 0, sizeof q);
    for (m = 0; m <= n; m++) {
        q[m][m] = m ? q[m - 1][m - 1] * (2 * m - 1) : 1;
        if (m + 1 <= n) q[m + 1][m] = (2 * m + 1) * u[2] * q[m][m];
        for (l = m + 2; l <= n; l++)
            q[l][m] = ((2 * l - 1) * u[2] * q[l - 1][m] - (l + m - 1) * q[l - 2][m]) / (l - m);
    }
    for (l = 0; l < n; l++)
        for (m = 0; m <= l; m++)
            for (k = 0; k <= (m > 0); k++) {
                const int i = l * l + l + (k ? -m : m);
                const long double *const a = k ? s : c, *const b = k ? c : s, j = norm[l][m];
                const long double fx = m ? m * q[l][m] * a[m - 1] : 0, fz = q[l][m + 1] * a[m];
                const long double fy = m ? m * q[l][m] * (k ? b[m - 1] : -b[m - 1]) : 0;
                const long double r = u[0] * fx + u[1] * fy + u[2] * fz;
                y[i] = j * q[l][m] * a[m];
                g[i] = j * (fx - r * u[0]);
                g[size + i] = j * (fy - r * u[1]);
                g[2 * size + i] = j * (fz - r * u[2]);
            }
}

static inline void ref_polygon_triangle(int n, const long double *a, const long double *b,
                                        const long double *c, long double height, const long double *area,
                                        ref_polygon_light *out, long double slope[3], long double *solid,
                                        int depth)
{
    static long double x[REF_POLYGON_NODES], w[REF_POLYGON_NODES], y[REF_POLYGON_SIZE],
        g[3 * REF_POLYGON_SIZE];
    const long double *v[3];
    long double side[3] = { 0, 0, 0 }, middle[3], d = 0, radius = 0;
    int i, j, k, longest;
    if (w[0] == 0) ref_gauss(REF_POLYGON_NODES, x, w);
    v[0] = a;
    v[1] = b;
    v[2] = c;
    for (k = 0; k < 3; k++) {
        middle[k] = (a[k] + b[k] + c[k]) / 3;
        d += middle[k] * middle[k];
    }
    for (i = 0; i < 3; i++) {
        long double r = 0;
        for (k = 0; k < 3; k++) {
            side[i] += (v[(i + 1) % 3][k] - v[i][k]) * (v[(i + 1) % 3][k] - v[i][k]);
            r += (v[i][k] - middle[k]) * (v[i][k] - middle[k]);
        }
        if (r > radius) radius = r;
    }
    longest = side[0] > side[1] ? (side[0] > side[2] ? 0 : 2) : (side[1] > side[2] ? 1 : 2);
    if (sqrtl(radius) > 0.5L * sqrtl(d) && depth < 300) {
        long double half[3];
        const long double *const p = v[longest], *const q = v[(longest + 1) % 3],
                                 *const r = v[(longest + 2) % 3];
        for (k = 0; k < 3; k++) {
            middle[k] = (p[k] + q[k]) / 2;
            half[k] = area[k] / 2;
        }
        ref_polygon_triangle(n, p, middle, r, height / 2, half, out, slope, solid, depth + 1);
        ref_polygon_triangle(n, middle, q, r, height / 2, half, out, slope, solid, depth + 1);
        return;
    }
    for (i = 0; i < REF_POLYGON_NODES; i++)
        for (j = 0; j < REF_POLYGON_NODES; j++) {
            const long double s = (x[i] + 1) / 2, t = (x[j] + 1) / 2, weight = w[i] * w[j] / 4 * s;
            long double p[3], u[3], r = 0, e, f[3];
            int q;
            for (k = 0; k < 3; k++) {
                p[k] = a[k] + s * ((1 - t) * (b[k] - a[k]) + t * (c[k] - a[k]));
                r += p[k] * p[k];
            }
            r = sqrtl(r);
            for (k = 0; k < 3; k++) u[k] = p[k] / r;
            e = weight * height / (r * r * r);
            for (k = 0; k < 3; k++) f[k] = weight * area[k] / (r * r * r) - 3 * e * u[k] / r;
            ref_polygon_basis(n, u, y, g);
            *solid += e;
            for (k = 0; k < 3; k++) slope[k] -= f[k];
            for (q = 0; q < n * n; q++) {
                out->c[q] += e * y[q];
                for (k = 0; k < 3; k++) out->g[k][q] -= e / r * g[k * n * n + q] + f[k] * y[q];
            }
        }
}

static inline void ref_polygon(int n, const double *point, int count, const double *v, ref_polygon_light *out)
{
    int i, k;
    memset(out, 0, sizeof *out);
    out->nearest = out->edge = 1e300L;
    for (i = 1; i + 1 < count; i++) {
        long double a[3], b[3], c[3], area[3], slope[3] = { 0, 0, 0 }, solid = 0, height;
        for (k = 0; k < 3; k++) {
            a[k] = (long double)v[k] - point[k];
            b[k] = (long double)v[3 * i + k] - point[k];
            c[k] = (long double)v[3 * i + 3 + k] - point[k];
        }
        for (k = 0; k < 3; k++) {
            const int p = (k + 1) % 3, q = (k + 2) % 3;
            area[k] = ((long double)v[3 * i + p] - v[p]) * ((long double)v[3 * i + 3 + q] - v[q])
                    - ((long double)v[3 * i + q] - v[q]) * ((long double)v[3 * i + 3 + p] - v[p]);
        }
        height = a[0] * area[0] + a[1] * area[1] + a[2] * area[2];
        if (height == 0) continue;
        ref_polygon_triangle(n, a, b, c, height, area, out, slope, &solid, 0);
        out->solid += fabsl(solid);
        out->slope += sqrtl(slope[0] * slope[0] + slope[1] * slope[1] + slope[2] * slope[2]);
    }
    for (i = 0; i < count; i++) {
        const double *const a = v + 3 * i, *const b = v + 3 * ((i + 1) % count);
        long double d = 0, e = 0, s = 0, t = 0;
        for (k = 0; k < 3; k++) {
            d += ((long double)a[k] - point[k]) * ((long double)a[k] - point[k]);
            e += ((long double)b[k] - a[k]) * ((long double)b[k] - a[k]);
            s += ((long double)point[k] - a[k]) * ((long double)b[k] - a[k]);
        }
        if (sqrtl(d) < out->nearest) out->nearest = sqrtl(d);
        if (e == 0) continue;
        s = s < 0 ? 0 : s > e ? 1 : s / e;
        for (k = 0; k < 3; k++) {
            const long double h = a[k] + s * ((long double)b[k] - a[k]) - point[k];
            t += h * h;
        }
        if (sqrtl(t / e) < out->edge) out->edge = sqrtl(t / e);
    }
}

#endif
