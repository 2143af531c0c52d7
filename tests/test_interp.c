/* Interpolation: what each scheme reproduces, how smooth it is and how fast it converges, its arithmetic against the
 * textbook form of each scheme in long double, and every documented status. */
#ifndef T
#include "sh_interp.h"
#include "report.h"
#include "ref.h"

#define CHECK(row, got, want, bound, i) row_check(row, (long double)(got), (long double)(want), (long double)(bound), i)
#define LEPS ((long double)EPS)

enum { SCHEMES = SH_BLENDED_TAYLOR2 + 1, X = 10 };     /* planes of every grid here: all of them */
static const char *const scheme_name[SCHEMES] = { "trilinear", "half Taylor", "blended Taylor", "Hermite, zero mixed",
                                                  "Hermite, mixed", "edge Hermite", "blended Taylor 2" };
static const int scheme_planes[SCHEMES] = { 1, 4, 4, 4, 4, 4, 10 };
static const int scheme_order[SCHEMES]  = { 2, 3, 2, 2, 4, 4, 4 };
static const int scheme_smooth[SCHEMES] = { 0, 0, 0, 1, 1, 0, 0 };

/* Does the scheme reproduce x^a y^b z^c, by the table at the top of the header? */
static int reproduces(int scheme, int inner, const int e[3])
{
    int most = 0, above0 = 0, above1 = 0, above2 = 0, a;
    for (a = 0; a < 3; a++) {
        if (e[a] > most) most = e[a];
        above0 += e[a] > 0;
        above1 += e[a] > 1;
        above2 += e[a] > 2;
    }
    switch (scheme) {
    case SH_TRILINEAR: case SH_BLENDED_TAYLOR: return most <= 1;
    case SH_HALF_TAYLOR:     return above1 <= 1 && most <= 2;
    case SH_HERMITE_ZERO:    return above0 <= 1 && most <= 3;
    case SH_HERMITE_MIXED:   return (inner ? above2 : above1) <= 1 && most <= 3;
    default:                 return above1 <= 1 && most <= 3;
    }
}

/* d^k/dx^k x^e */
static long double monomial(long double x, int e, int k)
{
    long double r = 1;
    int i;
    if (k > e) return 0;
    for (i = 0; i < k; i++) r *= e - i;
    for (i = 0; i < e - k; i++) r *= x;
    return r;
}
static const int derivative[X][3] = { {0,0,0}, {1,0,0}, {0,1,0}, {0,0,1}, {2,0,0}, {1,1,0}, {1,0,1}, {0,2,0}, {0,1,1}, {0,0,2} };

/* The schemes as the papers and textbooks write them, for one field of node data held as data[node][X]. */
typedef struct { int count[3]; long double h[3]; const long double *data; } field;

static long double at(const field *f, int i, int j, int k, int plane)
{
    const int x = i < f->count[0] ? i : i - 1, y = j < f->count[1] ? j : j - 1, z = k < f->count[2] ? k : k - 1;
    return f->data[X * (x + f->count[0] * (y + (long)f->count[1] * z)) + plane];
}

/* The difference along the axes of the mask: central where both neighbours exist. */
static long double difference(const field *f, int mask, const int node[3], int plane)
{
    int a, low[3], high[3];
    for (a = 0; a < 3 && !(mask >> a & 1); a++) { }
    if (a == 3) return at(f, node[0], node[1], node[2], plane);
    memcpy(low, node, sizeof low);
    memcpy(high, node, sizeof high);
    low[a] -= low[a] > 0;
    high[a] += high[a] + 1 < f->count[a];
    if (low[a] == high[a]) return 0;
    return (difference(f, mask & ~(1 << a), high, plane) - difference(f, mask & ~(1 << a), low, plane))
         / ((high[a] - low[a]) * f->h[a]);
}

/* Mixed derivative of the axes in the mask at a node, as the header defines it. */
static long double mixed(const field *f, int mask, const int node[3])
{
    long double sum = 0;
    int a, axes = 0;
    for (a = 0; a < 3; a++)
        if (mask >> a & 1) {
            sum += difference(f, mask & ~(1 << a), node, 1 + a);
            axes++;
        }
    return axes ? sum - (axes - 1) * difference(f, mask, node, 0) : at(f, node[0], node[1], node[2], 0);
}

static long double textbook(int scheme, const field *f, const int cell[3], const long double t[3])
{
    long double sum = 0;
    int corner, a, b, mask;

    for (corner = 0; corner < 8; corner++) {
        const int node[3] = { cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2 & 1) };
        long double w = 1, d[3], value = at(f, node[0], node[1], node[2], 0), g = 0, h = 0, H[3], S[3];
        static const int plane[3][3] = { { 4, 5, 6 }, { 5, 7, 8 }, { 6, 8, 9 } };
        for (a = 0; a < 3; a++) {
            const int end = corner >> a & 1;
            const long double x = end ? 1 - t[a] : t[a];                 /* distance from this end */
            w *= 1 - x;
            d[a] = (t[a] - end) * f->h[a];
            H[a] = 1 - x * x * (3 - 2 * x);
            S[a] = (end ? -1 : 1) * x * (1 - x) * (1 - x) * f->h[a];
        }
        for (a = 0; a < 3; a++) g += d[a] * at(f, node[0], node[1], node[2], 1 + a);
        for (a = 0; a < 3; a++)
            for (b = 0; b < 3; b++) h += d[a] * d[b] * at(f, node[0], node[1], node[2], plane[a][b]);
        if (scheme == SH_TRILINEAR || scheme == SH_EDGE_HERMITE) sum += w * value;
        if (scheme == SH_HALF_TAYLOR)     sum += w * (value + g / 2);
        if (scheme == SH_BLENDED_TAYLOR)  sum += w * (value + g);
        if (scheme == SH_BLENDED_TAYLOR2) sum += w * (value + 2 * g / 3 + h / 6);
        if (scheme == SH_HERMITE_ZERO) {
            sum += H[0] * H[1] * H[2] * value;
            for (a = 0; a < 3; a++)
                sum += S[a] * H[(a + 1) % 3] * H[(a + 2) % 3] * at(f, node[0], node[1], node[2], 1 + a);
        }
        if (scheme == SH_HERMITE_MIXED)
            for (mask = 0; mask < 8; mask++) {
                long double u = 1;
                for (a = 0; a < 3; a++) u *= mask >> a & 1 ? S[a] : H[a];
                if (u != 0) sum += u * mixed(f, mask, node);
            }
    }
    if (scheme == SH_EDGE_HERMITE)      /* 12 edges: bilinear weight of the other two axes, cubic minus linear along */
        for (a = 0; a < 3; a++)
            for (corner = 0; corner < 4; corner++) {
                const int o = (a + 1) % 3, p = (a + 2) % 3;
                const long double s0 = t[a] * (1 - t[a]) * (1 - t[a]), s1 = -t[a] * t[a] * (1 - t[a]);
                const long double w = (corner & 1 ? t[o] : 1 - t[o]) * (corner & 2 ? t[p] : 1 - t[p]);
                int n0[3], n1[3];
                long double step;
                n0[a] = cell[a];
                n0[o] = cell[o] + (corner & 1);
                n0[p] = cell[p] + (corner >> 1);
                memcpy(n1, n0, sizeof n1);
                n1[a]++;
                step = at(f, n1[0], n1[1], n1[2], 0) - at(f, n0[0], n0[1], n0[2], 0);
                sum += w * (s0 * (f->h[a] * at(f, n0[0], n0[1], n0[2], 1 + a) - step)
                          + s1 * (f->h[a] * at(f, n1[0], n1[1], n1[2], 1 + a) - step));
            }
    return sum;
}

/* ---- f64 only: convergence on sphere lights, and the schemes side by side on one grid --------------------------- */

enum { B = 5, NB = B * B };

typedef struct { int count; double at[64][4]; } scene;      /* center and radius */

static void sum_lights(const scene *s, const double point[3], double out[X * NB])
{
    double c[NB], g[3 * NB], h[6 * NB];
    int i, k;
    memset(out, 0, X * NB * sizeof *out);
    for (i = 0; i < s->count; i++) {
        assert_int_equal(sh_sphere_hessian_f64(B, point, s->at[i], s->at[i][3], c, g, h), SH_OK);
        for (k = 0; k < NB; k++) out[k] += c[k];
        for (k = 0; k < 3 * NB; k++) out[NB + k] += g[k];
        for (k = 0; k < 6 * NB; k++) out[4 * NB + k] += h[k];
    }
}

/* A light at `distance` from every query, which lies in the middle cell of 4^3 nodes; the cell halves from 1/2. */
static void convergence(void **state)
{
    static const struct { const char *name; double distance; } where[3] = { { "near", 2.2 }, { "mid", 5 }, { "far", 16 } };
    enum { STEPS = 5, PLACES = 40 };
    int place, scheme, w, step, i, k;
    (void)state;
    printf("largest relative error of %d places, one sphere light, 5 bands: cells 1/2 and 1/32, order at each halving\n", PLACES);
    for (w = 0; w < 3; w++)
        for (scheme = 0; scheme < SCHEMES; scheme++) {
            double error[STEPS] = { 0 }, order;
            row *r = row_open("order of convergence", "f64");
            for (place = 0; place < PLACES; place++) {
                scene s;
                double u[3], t[3];
                ref_unit(u);
                s.count = 1;
                for (i = 0; i < 3; i++) { s.at[0][i] = u[i] * where[w].distance; t[i] = ref_between(.2, .8); }
                s.at[0][3] = .2 * where[w].distance;
                for (step = 0; step < STEPS; step++) {
                    const double h = .5 / (1 << step), point[3] = { 0, 0, 0 };
                    static double nodes[64 * X * NB];
                    double got[NB], want[X * NB], size = 0, e = 0;
                    sh_grid_f64 grid = { { 0, 0, 0 }, { 0, 0, 0 }, { 4, 4, 4 } };
                    for (i = 0; i < 3; i++) { grid.cell[i] = h; grid.origin[i] = -(1 + t[i]) * h; }
                    for (k = 0; k < 64; k++) {
                        const double p[3] = { grid.origin[0] + h * (k & 3), grid.origin[1] + h * (k >> 2 & 3),
                                              grid.origin[2] + h * (k >> 4) };
                        sum_lights(&s, p, nodes + k * X * NB);
                    }
                    sum_lights(&s, point, want);
                    assert_int_equal(sh_grid_interp_f64(B, X, 1, &grid, nodes, scheme, SH_CLAMP, point, got), SH_OK);
                    for (k = 0; k < NB; k++) { size += want[k] * want[k]; e += (got[k] - want[k]) * (got[k] - want[k]); }
                    if (!(sqrt(e / size) <= error[step])) error[step] = sqrt(e / size);
                }
            }
            printf("  %-20s %-5s %9.2e %9.2e  ", scheme_name[scheme], where[w].name, error[0], error[STEPS - 1]);
            for (step = 1; step < STEPS; step++) printf(" %5.2f", log2(error[step - 1] / error[step]));
            printf("\n");
            order = log2(error[STEPS - 2] / error[STEPS - 1]);
            row_case("%s, %s", scheme_name[scheme], where[w].name);
            CHECK(r, order, scheme_order[scheme], .25L, scheme);
            row_close(r);
        }
}

/* 24 sphere lights outside of the unit cube, 5 bands, 8^3 nodes: beside what an independent program measured on a scene of
 * its own of this kind. The gap is that between the cube and a light. */
static double scene_random(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) / 16777216.;
}

static void side_by_side(void **state)
{
    static const struct { const char *name; double low, high, r0, r1, seen[SCHEMES]; } where[3] = {
        { "far",  .55, .90, .05, .20, { 1.4e-2, 0, 0, 6.6e-4, 0, 1.7e-4, 5.7e-5 } },
        { "mid",  .12, .25, .05, .20, { 5.8e-2, 0, 0, 6.1e-3, 0, 5.0e-3, 2.6e-3 } },
        { "near", .05, .10, .02, .20, { .15,    0, 0, 3.0e-2, 0, 3.0e-2, 0 } } };
    enum { POINTS = 2000 };
    static double nodes[512 * X * NB], error[3][SCHEMES];
    const sh_grid_f64 grid = { { 0, 0, 0 }, { 1. / 7, 1. / 7, 1. / 7 }, { 8, 8, 8 } };
    row *r = row_open("8^3 grid, beside the known errors, in 2x", "f64");
    int w, i, k, scheme;
    unsigned seed = 1;
    (void)state;
    for (w = 0; w < 3; w++) {
        scene s;
        double size = 0, want[X * NB], got[NB];
        for (s.count = 0; s.count < 24; ) {
            double *light = s.at[s.count], gap = 0, d;
            for (i = 0; i < 3; i++) {
                light[i] = 5 * scene_random(&seed) - 2;
                d = light[i] < 0 ? -light[i] : light[i] > 1 ? light[i] - 1 : 0;
                gap += d * d;
            }
            light[3] = where[w].r0 + (where[w].r1 - where[w].r0) * scene_random(&seed);
            gap = sqrt(gap) - light[3];
            if (gap >= where[w].low && gap <= where[w].high) s.count++;
        }
        for (k = 0; k < 512; k++) {
            const double p[3] = { (k & 7) / 7., (k >> 3 & 7) / 7., (k >> 6) / 7. };
            sum_lights(&s, p, nodes + k * X * NB);
        }
        for (i = 0; i < POINTS; i++) {
            const double p[3] = { scene_random(&seed), scene_random(&seed), scene_random(&seed) };
            sum_lights(&s, p, want);
            for (k = 0; k < NB; k++) size += want[k] * want[k];
            for (scheme = 0; scheme < SCHEMES; scheme++) {
                assert_int_equal(sh_grid_interp_f64(B, X, 1, &grid, nodes, scheme, SH_CLAMP, p, got), SH_OK);
                for (k = 0; k < NB; k++) error[w][scheme] += (got[k] - want[k]) * (got[k] - want[k]);
            }
        }
        for (scheme = 0; scheme < SCHEMES; scheme++) {
            error[w][scheme] = sqrt(error[w][scheme] / size);
            row_case("%s, lights %s: %.3g", scheme_name[scheme], where[w].name, error[w][scheme]);
            if (where[w].seen[scheme] > 0) CHECK(r, log2(error[w][scheme] / where[w].seen[scheme]), 0, 1, scheme);
        }
    }
    printf("relative L2 error, 24 sphere lights, 5 bands, 8^3 nodes, %d points\n  %-20s", POINTS, "");
    for (w = 0; w < 3; w++) printf(" %9s", where[w].name);
    printf("\n");
    for (scheme = 0; scheme < SCHEMES; scheme++) {
        printf("  %-20s", scheme_name[scheme]);
        for (w = 0; w < 3; w++) printf(" %9.2e", error[w][scheme]);
        printf("\n");
    }
    row_close(r);
    for (w = 0; w < 3; w++) {       /* the order of merit on smooth light */
        assert_true(error[w][SH_EDGE_HERMITE] < error[w][SH_HERMITE_ZERO]);
        assert_true(error[w][SH_EDGE_HERMITE] < error[w][SH_HALF_TAYLOR]);
        assert_true(error[w][SH_HERMITE_MIXED] < error[w][SH_EDGE_HERMITE]);
        assert_true(error[w][SH_HERMITE_ZERO] < error[w][SH_TRILINEAR] / 2);
        assert_true(error[w][SH_BLENDED_TAYLOR2] < error[w][SH_EDGE_HERMITE]);
    }
}

#define BOTH "test_interp.c"
#include "both.h"

int main(void)
{
    const struct CMUnitTest tests[] = {
        BOTH_TESTS(polynomials), BOTH_TESTS(arithmetic), BOTH_TESTS(gradients), BOTH_TESTS(smoothness),
        BOTH_TESTS(outside), BOTH_TESTS(one_node), BOTH_TESTS(many), BOTH_TESTS(fused), BOTH_TESTS(last_face), BOTH_TESTS(scattered),
        BOTH_TESTS(statuses), cmocka_unit_test(convergence), cmocka_unit_test(side_by_side)
    };
    return RUN_TESTS(tests);
}

#else /* once per precision ------------------------------------------------------------------------------------------ */

#define GRID F(sh_grid)

static T F(random)(void) { return (T)ref_between(-1, 1); }

/* Points whose place in the cell a float holds exactly: cells are powers of two, the origin a multiple of them. */
static const GRID F(exact_grid) = { { (T)-.5, (T)1, (T).25 }, { (T).25, (T).5, (T).125 }, { 5, 6, 7 } };

static void F(exact_point)(const GRID *g, int cell[3], long double t[3], T point[3])
{
    int a;
    for (a = 0; a < 3; a++) {
        cell[a] = g->count[a] > 1 ? (int)(ref_random() * (g->count[a] - 1)) : 0;
        t[a] = g->count[a] > 1 ? floorl((long double)ref_random() * 262145) / 262144 : 0;
        point[a] = (T)((long double)g->origin[a] + (cell[a] + t[a]) * (long double)g->cell[a]);
    }
}

static void F(polynomials)(void **state)
{
    const GRID *g = &F(exact_grid);
    row *r = row_open("polynomials reproduced", PRECISION), *q = IS_F32 ? NULL : row_open("polynomials not reproduced", PRECISION);
    static T nodes[5 * 6 * 7 * X];
    int e[3], scheme, i, k, p, turn;
    (void)state;
    for (e[2] = 0; e[2] < 5; e[2]++)
    for (e[1] = 0; e[1] < 5; e[1]++)
    for (e[0] = 0; e[0] < 5; e[0]++) {
        for (k = 0; k < 5 * 6 * 7; k++) {
            const int n[3] = { k % 5, k / 5 % 6, k / 30 };
            for (p = 0; p < X; p++) {
                long double v = 1;
                for (i = 0; i < 3; i++)     /* in units of the cell, so that all planes have one size */
                    v *= monomial((n[i] - 2.25L) / 4, e[i], derivative[p][i]) * powl(.25L / (long double)g->cell[i], derivative[p][i]);
                nodes[k * X + p] = (T)v;
            }
        }
        for (scheme = 0; scheme < SCHEMES; scheme++) {
            long double worst = 0;
            int inner;
            for (inner = 0; inner < 2; inner++) {
                const int yes = reproduces(scheme, inner, e);
                worst = 0;
                for (turn = 0; turn < 24; turn++) {
                    int cell[3];
                    long double t[3], want = 1;
                    T point[3], got;
                    F(exact_point)(g, cell, t, point);
                    for (i = 0; i < 3; i++) {       /* inner: every neighbour exists; else a border cell of all axes */
                        const int to = inner ? 1 + turn % (g->count[i] - 3) : turn >> i & 1 ? g->count[i] - 2 : 0;
                        point[i] += (T)(to - cell[i]) * g->cell[i];
                        want *= monomial((to + t[i] - 2.25L) / 4, e[i], 0);
                    }
                    assert_int_equal(F(sh_grid_interp)(1, X, 1, g, nodes, scheme, SH_CLAMP, point, &got), SH_OK);
                    row_case("%s x^%d y^%d z^%d", scheme_name[scheme], e[0], e[1], e[2]);
                    if (yes) CHECK(r, got, want, 32 * LEPS, turn);
                    if (!(fabsl((long double)got - want) <= worst)) worst = fabsl((long double)got - want);
                }
                if (!yes && q) CHECK(q, 0, 1e-9L, worst, inner);      /* an error of 1e-9 at least */
            }
        }
    }
    row_close(r);
    if (q) row_close(q);
}

/* Random data (no smoothness at all) on grids with axes of 1, 2, 3 and more nodes, against the textbook. */
static void F(arithmetic)(void **state)
{
    enum { N = 9, CHANNELS = 2, MOST = 5 * 6 * 7 };
    row *r = row_open("grid schemes against the textbook", PRECISION);
    static T nodes[MOST * CHANNELS * X * N];
    static long double data[MOST * X];
    int turn, scheme, i, k, p, c, a, sizes;
    (void)state;
    for (sizes = 0; sizes < 12; sizes++) {
        static const int counts[12][3] = { {5,6,7}, {1,6,7}, {5,1,7}, {5,6,1}, {1,1,7}, {1,1,1}, {2,2,2}, {3,3,3}, {2,6,3}, {4,1,2}, {1,3,1}, {3,5,4} };
        GRID g = F(exact_grid);
        int total;
        memcpy(g.count, counts[sizes], sizeof g.count);
        total = g.count[0] * g.count[1] * g.count[2];
        for (i = 0; i < total * CHANNELS; i++)
            for (p = 0; p < X; p++)
                for (k = 0; k < N; k++) {
                    T unit = 1;     /* derivatives per cell are of size 1 */
                    for (a = 0; a < 3; a++) unit /= derivative[p][a] == 2 ? g.cell[a] * g.cell[a] : derivative[p][a] ? g.cell[a] : 1;
                    nodes[(i * X + p) * N + k] = F(random)() * unit;
                }
        for (scheme = 0; scheme < SCHEMES; scheme++)
            for (turn = 0; turn < effort(40); turn++) {
                field f;
                int cell[3];
                long double t[3];
                T point[3], got[CHANNELS * N];
                F(exact_point)(&g, cell, t, point);
                assert_int_equal(F(sh_grid_interp)(3, X, CHANNELS, &g, nodes, scheme, turn & 1, point, got), SH_OK);
                f.data = data;
                for (a = 0; a < 3; a++) { f.count[a] = g.count[a]; f.h[a] = g.count[a] > 1 ? (long double)g.cell[a] : 0; }
                c = turn % CHANNELS;
                k = turn % N;
                for (i = 0; i < total; i++)
                    for (p = 0; p < X; p++) data[i * X + p] = (long double)nodes[((i * CHANNELS + c) * X + p) * N + k];
                row_case("%s, grid %d %d %d, cell %d %d %d, t %.6Lf %.6Lf %.6Lf", scheme_name[scheme], g.count[0], g.count[1],
                         g.count[2], cell[0], cell[1], cell[2], t[0], t[1], t[2]);
                CHECK(r, got[c * N + k], textbook(scheme, &f, cell, t), 8 * LEPS, k);
            }
    }
    row_close(r);
}

/* The returned gradient is the derivative of the returned value: central differences of the textbook. */
static void F(gradients)(void **state)
{
    enum { MOST = 5 * 6 * 7 };
    const GRID *g = &F(exact_grid);
    row *r = row_open("gradient of the interpolant", PRECISION), *v = row_open("its value: that of sh_grid_interp", PRECISION);
    static T nodes[MOST * X];
    static long double data[MOST * X];
    int scheme, turn, i, a;
    (void)state;
    for (i = 0; i < MOST * X; i++) nodes[i] = F(random)();
    for (i = 0; i < MOST * X; i++) data[i] = (long double)nodes[i];
    for (scheme = 0; scheme < SCHEMES; scheme++)
        for (turn = 0; turn < effort(50); turn++) {
            const long double step = 1 / 65536.L;
            field f;
            int cell[3];
            long double t[3];
            T point[3], got[4], value;
            F(exact_point)(g, cell, t, point);
            assert_int_equal(F(sh_grid_gradient)(1, X, 1, g, nodes, scheme, SH_CLAMP, point, got), SH_OK);
            assert_int_equal(F(sh_grid_interp)(1, X, 1, g, nodes, scheme, SH_CLAMP, point, &value), SH_OK);
            row_case("%s, cell %d %d %d", scheme_name[scheme], cell[0], cell[1], cell[2]);
            CHECK(v, got[0], value, 0, 0);
            f.data = data;
            for (a = 0; a < 3; a++) { f.count[a] = g->count[a]; f.h[a] = (long double)g->cell[a]; }
            for (a = 0; a < 3; a++) {
                long double high[3], low[3];
                memcpy(high, t, sizeof high);
                memcpy(low, t, sizeof low);
                if (t[a] == 1 && cell[a] + 2 < g->count[a]) continue;     /* a node: the next cell's, and C0 has two */
                if (t[a] == 0 && cell[a] > 0 && !scheme_smooth[scheme]) continue;
                high[a] += step;
                low[a] -= step;
                CHECK(r, got[1 + a], (textbook(scheme, &f, cell, high) - textbook(scheme, &f, cell, low)) / (2 * step * f.h[a]),
                          (16 * LEPS + 4 * step * step) / f.h[a], a);
            }
        }
    row_close(r);
    row_close(v);
}

/* Across the face between two cells: no jump of the value, and of the gradient none where the table says C1 and one
 * where it says C0. */
static void F(smoothness)(void **state)
{
    enum { MOST = 5 * 6 * 7 };
    const GRID *g = &F(exact_grid);
    row *r = row_open("continuity across faces", PRECISION), *q = row_open("C1 across faces", PRECISION);
    static T nodes[MOST * X];
    double jump[SCHEMES] = { 0 };
    int scheme, turn, i, a;
    (void)state;
    for (i = 0; i < MOST * X; i++) nodes[i] = F(random)();
    for (scheme = 0; scheme < SCHEMES; scheme++) {
        for (turn = 0; turn < 60; turn++) {
            const int axis = turn % 3, face = 1 + turn % (g->count[axis] - 2);
            const T away = g->cell[axis] * (T)ldexp(1, IS_F32 ? -16 : -40);
            const double near = (double)(away / g->cell[axis]);
            int cell[3];
            long double t[3];
            T point[3], low[4], high[4];
            F(exact_point)(g, cell, t, point);
            point[axis] = g->origin[axis] + (T)face * g->cell[axis] - away;
            assert_int_equal(F(sh_grid_gradient)(1, X, 1, g, nodes, scheme, SH_CLAMP, point, low), SH_OK);
            point[axis] = g->origin[axis] + (T)face * g->cell[axis] + away;
            assert_int_equal(F(sh_grid_gradient)(1, X, 1, g, nodes, scheme, SH_CLAMP, point, high), SH_OK);
            row_case("%s, axis %d, face %d", scheme_name[scheme], axis, face);
            CHECK(r, high[0], low[0], 32 * near + 16 * (double)EPS, axis);
            for (a = 0; a < 3; a++) {
                if (scheme_smooth[scheme]) CHECK(q, high[1 + a], low[1 + a], (256 * near + 64 * (double)EPS) / (double)g->cell[a], a);
                if (fabs((double)(high[1 + a] - low[1 + a])) > jump[scheme]) jump[scheme] = fabs((double)(high[1 + a] - low[1 + a]));
            }
        }
        if (!scheme_smooth[scheme]) assert_true(jump[scheme] > .05);
    }
    row_close(r);
    row_close(q);
}

static void F(outside)(void **state)
{
    enum { MOST = 5 * 6 * 7 };
    const GRID *g = &F(exact_grid);
    row *r = row_open("clamped = nearest point of the grid", PRECISION), *q = row_open("extrapolated = the border's polynomial", PRECISION);
    row *f = row_open("extrapolation stops at 1024 cells", PRECISION);
    static T nodes[MOST * X];
    static long double data[MOST * X];
    int scheme, turn, i, a;
    (void)state;
    for (i = 0; i < MOST * X; i++) nodes[i] = F(random)();
    for (i = 0; i < MOST * X; i++) data[i] = (long double)nodes[i];
    for (scheme = 0; scheme < SCHEMES; scheme++)
        for (turn = 0; turn < effort(40); turn++) {
            field fd;
            int cell[3], out = 1 + turn % 7;
            long double t[3], u[3], size = 1;
            T inside[3], point[3], near[4], got[4], far[4];
            F(exact_point)(g, cell, t, inside);
            memcpy(point, inside, sizeof point);
            memcpy(u, t, sizeof u);
            for (a = 0; a < 3; a++)
                if (out >> a & 1) {
                    const int high = ref_random() < .5;
                    cell[a] = high ? g->count[a] - 2 : 0;
                    u[a] = high ? 1 + t[a] : -t[a];
                    inside[a] = g->origin[a] + (T)(cell[a] + high) * g->cell[a];
                    point[a] = g->origin[a] + (T)(cell[a] + u[a]) * g->cell[a];
                    size *= 8;
                }
            row_case("%s, axes %d, t %Lg %Lg %Lg", scheme_name[scheme], out, u[0], u[1], u[2]);
            assert_int_equal(F(sh_grid_gradient)(1, X, 1, g, nodes, scheme, SH_CLAMP, inside, near), SH_OK);
            assert_int_equal(F(sh_grid_gradient)(1, X, 1, g, nodes, scheme, SH_CLAMP, point, got), SH_OK);
            CHECK(r, got[0], near[0], 0, 0);
            for (a = 0; a < 3; a++)
                if (out >> a & 1 && u[a] != 0 && u[a] != 1) CHECK(r, got[1 + a], 0, 0, 1 + a);
            assert_int_equal(F(sh_grid_interp)(1, X, 1, g, nodes, scheme, SH_EXTRAPOLATE, point, got), SH_OK);
            fd.data = data;
            for (a = 0; a < 3; a++) { fd.count[a] = g->count[a]; fd.h[a] = (long double)g->cell[a]; }
            CHECK(q, got[0], textbook(scheme, &fd, cell, u), 16 * size * LEPS, 0);
            for (a = 0; a < 3; a++)
                if (out >> a & 1) {
                    point[a] = u[a] > .5L ? g->origin[a] + (T)(g->count[a] - 1 + 1024) * g->cell[a] : g->origin[a] - 1024 * g->cell[a];
                    inside[a] = u[a] > .5L ? (T)1e30 : (T)-1e30;
                }
            assert_int_equal(F(sh_grid_interp)(1, X, 1, g, nodes, scheme, SH_EXTRAPOLATE, point, near), SH_OK);
            for (a = 0; a < 3; a++) if (out >> a & 1) point[a] = inside[a];
            assert_int_equal(F(sh_grid_interp)(1, X, 1, g, nodes, scheme, SH_EXTRAPOLATE, point, far), SH_OK);
            CHECK(f, far[0], near[0], 0, 0);
        }
    row_close(r);
    row_close(q);
    row_close(f);
}

/* An axis of one node is constant: the bits do not depend on the coordinate, nor on origin and cell there. */
static void F(one_node)(void **state)
{
    row *r = row_open("axis of one node", PRECISION);
    T nodes[4 * 4 * X], a_value[4], b_value[4];
    int scheme, axis, i;
    (void)state;
    for (i = 0; i < 4 * 4 * X; i++) nodes[i] = F(random)();
    for (scheme = 0; scheme < SCHEMES; scheme++)
        for (axis = 0; axis < 3; axis++) {
            GRID g = { { 0, 0, 0 }, { 1, 1, 1 }, { 4, 4, 4 } }, other;
            T p[3] = { (T)1.3, (T)2.6, (T).4 };
            g.count[axis] = 1;
            g.count[(axis + 1) % 3] = 2;
            g.count[(axis + 2) % 3] = 2;
            other = g;
            other.cell[axis] = 0;
            other.origin[axis] = 17;
            assert_int_equal(F(sh_grid_gradient)(1, X, 1, &g, nodes, scheme, SH_EXTRAPOLATE, p, a_value), SH_OK);
            p[axis] = (T)-1e9;
            assert_int_equal(F(sh_grid_gradient)(1, X, 1, &other, nodes, scheme, SH_EXTRAPOLATE, p, b_value), SH_OK);
            row_case("%s, axis %d", scheme_name[scheme], axis);
            for (i = 0; i < 4; i++) CHECK(r, b_value[i], a_value[i], 0, i);
            CHECK(r, a_value[1 + axis], 0, 0, 1 + axis);
        }
    row_close(r);
}

/* Many points give the bits of one, for every band count, count and channel; nothing beyond the output is written. */
static void F(many)(void **state)
{
    enum { CHANNELS = 3, POINTS = 19, NODES = 3 * 4 * 2, GUARD = 16 };
    const GRID g = { { (T)-.3, (T).1, 0 }, { (T).3, (T).7, (T)1.1 }, { 3, 4, 2 } };
    row *r = row_open("many points = one point, to the bit", PRECISION);
    int bands, scheme, i, count;
    (void)state;
    for (bands = 1; bands <= SH_MAX_BANDS; bands += bands < 10 ? 1 : 11) {
        const size_t n = (size_t)(bands * bands), one = CHANNELS * 4 * n;
        T *nodes = malloc(NODES * CHANNELS * X * n * sizeof *nodes), *out = malloc((POINTS * one + GUARD) * sizeof *out);
        T *single = malloc(one * sizeof *single), *transfer = malloc(POINTS * n * sizeof *transfer), points[3 * POINTS];
        size_t k;
        assert_true(nodes && out && single && transfer);
        for (k = 0; k < NODES * CHANNELS * X * n; k++) nodes[k] = F(random)();
        for (k = 0; k < POINTS * n; k++) transfer[k] = F(random)();
        for (i = 0; i < 3 * POINTS; i++) points[i] = 3 * F(random)();
        for (scheme = 0; scheme < SCHEMES; scheme++)
            for (count = 0; count <= POINTS; count += count < 9 ? 1 : 5) {
                int form;
                for (form = 0; form < 3; form++) {
                    const size_t size = form == 0 ? CHANNELS * n : form == 1 ? one : CHANNELS;
                    row_case("bands %d, %s, count %d, form %d", bands, scheme_name[scheme], count, form);
                    for (k = 0; k < POINTS * one + GUARD; k++) out[k] = 77;
                    switch (form) {
                    case 0: i = F(sh_grid_interp_n)(bands, X, CHANNELS, &g, nodes, scheme, count & 1, (size_t)count, points, out); break;
                    case 1: i = F(sh_grid_gradient_n)(bands, X, CHANNELS, &g, nodes, scheme, count & 1, (size_t)count, points, out); break;
                    default: i = F(sh_grid_dot_n)(bands, X, CHANNELS, &g, nodes, scheme, count & 1, (size_t)count, points, transfer, out);
                    }
                    assert_int_equal(i, SH_OK);
                    for (k = 0; k < GUARD; k++) CHECK(r, out[(size_t)count * size + k], 77, 0, -1);
                    for (i = 0; i < count; i++) {
                        const T *p = points + 3 * i;
                        switch (form) {
                        case 0: F(sh_grid_interp)(bands, X, CHANNELS, &g, nodes, scheme, count & 1, p, single); break;
                        case 1: F(sh_grid_gradient)(bands, X, CHANNELS, &g, nodes, scheme, count & 1, p, single); break;
                        default: F(sh_grid_dot)(bands, X, CHANNELS, &g, nodes, scheme, count & 1, p, transfer + (size_t)i * n, single);
                        }
                        CHECK(r, memcmp(single, out + (size_t)i * size, size * sizeof *single) != 0, 0, 0, i);
                    }
                }
            }
        free(nodes); free(out); free(single); free(transfer);
    }
    row_close(r);
}

/* The fused dot product is that of the interpolated coefficients; fewer planes stored, the same coefficients. */
static void F(fused)(void **state)
{
    enum { NODES = 4 * 3 * 5 };
    const GRID g = { { 0, 0, 0 }, { (T).3, (T).7, (T)1.1 }, { 4, 3, 5 } };
    row *r = row_open("fused dot product", PRECISION), *q = row_open("planes beyond the scheme's are not read", PRECISION);
    int bands, scheme, turn, p;
    (void)state;
    for (bands = 1; bands <= SH_MAX_BANDS; bands += bands < 12 ? 1 : 4) {
        const size_t n = (size_t)(bands * bands);
        T *nodes = malloc(NODES * X * n * sizeof *nodes), *less = malloc(NODES * X * n * sizeof *less);
        T *c = malloc(n * sizeof *c), *d = malloc(n * sizeof *d), *transfer = malloc(n * sizeof *transfer);
        size_t k, i;
        assert_true(nodes && less && c && d && transfer);
        for (k = 0; k < NODES * X * n; k++) nodes[k] = F(random)();
        for (scheme = 0; scheme < SCHEMES; scheme++) {
            const int planes = scheme_planes[scheme];
            for (i = 0; i < NODES; i++)
                for (p = 0; p < planes; p++) memcpy(less + (i * (size_t)planes + (size_t)p) * n, nodes + (i * X + (size_t)p) * n, n * sizeof *less);
            for (turn = 0; turn < 6; turn++) {
                const T point[3] = { F(random)(), 2 * F(random)(), 5 * F(random)() };
                long double want = 0, size = 0;
                T got;
                for (k = 0; k < n; k++) transfer[k] = F(random)();
                assert_int_equal(F(sh_grid_interp)(bands, X, 1, &g, nodes, scheme, SH_CLAMP, point, c), SH_OK);
                assert_int_equal(F(sh_grid_interp)(bands, planes, 1, &g, less, scheme, SH_CLAMP, point, d), SH_OK);
                assert_int_equal(F(sh_grid_dot)(bands, X, 1, &g, nodes, scheme, SH_CLAMP, point, transfer, &got), SH_OK);
                for (k = 0; k < n; k++) { want += (long double)c[k] * (long double)transfer[k]; size += fabsl((long double)c[k] * (long double)transfer[k]); }
                row_case("bands %d, %s", bands, scheme_name[scheme]);
                CHECK(r, got, want, 16 * LEPS * (size + 1e-3L), 0);
                CHECK(q, memcmp(c, d, n * sizeof *c) != 0, 0, 0, 0);
            }
        }
        free(nodes); free(less); free(c); free(d); free(transfer);
    }
    for (turn = 0; turn < effort(200); turn++) {         /* equal products of one sign, whose roundings agree */
        static T ones[SH_MAX_BANDS * SH_MAX_BANDS], transfer[SH_MAX_BANDS * SH_MAX_BANDS];
        const GRID one = { { 0, 0, 0 }, { 1, 1, 1 }, { 1, 1, 1 } };
        const T x = (T)ref_between(.5, 1), point[3] = { 0, 0, 0 };
        T got;
        int k;
        bands = turn % 2 ? 32 : 16;
        for (k = 0; k < bands * bands; k++) ones[k] = 1, transfer[k] = x;
        assert_int_equal(F(sh_grid_dot)(bands, X, 1, &one, ones, SH_TRILINEAR, SH_CLAMP, point, transfer, &got), SH_OK);
        row_case("bands %d, all transfers %.9g", bands, (double)x);
        CHECK(r, got, bands * bands * (long double)x, 16 * LEPS * bands * bands * (long double)x, 0);
    }
    row_close(r);
    row_close(q);
}

/* Derivative d of a polynomial at x: its terms' exponents and coefficients. */
static long double F(polynomial)(int terms, int e[][3], const long double *c, const T x[3], const int d[3])
{
    long double sum = 0;
    int i, a;
    for (i = 0; i < terms; i++) {
        long double v = c[i];
        for (a = 0; a < 3; a++) v *= monomial((long double)x[a], e[i][a], d[a]);
        sum += v;
    }
    return sum;
}

/* The border of a clamped axis, however origin + 3 cell is rounded: the derivative of its cell. */
static void F(last_face)(void **state)
{
    row *r = row_open("slope at the border", PRECISION);
    int turn;
    (void)state;
    for (turn = 0; turn < effort(2000); turn++) {
        static const T nodes[4] = { 0, 1, 2, 3 };
        F(sh_grid) grid = { { 0, 0, 0 }, { 1, 1, 1 }, { 4, 1, 1 } };
        T point[3] = { 0, 0, 0 }, out[4];
        long double moved;
        grid.cell[0] = (T)ref_log_between(1e-3, 1e3);
        grid.origin[0] = turn % 2 ? 0 : (T)ref_between(-1, 1) * grid.cell[0] * (T)(turn % 4 ? 1 : 10000);
        point[0] = grid.origin[0] + 3 * grid.cell[0];
        moved = (long double)EPS * fabsl((long double)grid.origin[0] / (long double)grid.cell[0]);
        assert_int_equal(F(sh_grid_gradient)(1, SH_VALUES, 1, &grid, nodes, SH_TRILINEAR, SH_CLAMP, point, out), SH_OK);
        row_case("origin %.9g, cell %.9g", (double)grid.origin[0], (double)grid.cell[0]);
        CHECK(r, out[0], 3, 16 * 3 * LEPS + moved, 0);
        CHECK(r, out[1], 1 / (long double)grid.cell[0], 16 * 3 * LEPS / (long double)grid.cell[0], 1);
        assert_int_equal(F(sh_grid_gradient)(1, SH_VALUES, 1, &grid, nodes, SH_TRILINEAR, SH_CLAMP, grid.origin, out), SH_OK);
        CHECK(r, out[1], 1 / (long double)grid.cell[0], 16 * 3 * LEPS / (long double)grid.cell[0], 2);
    }
    row_close(r);
}

/* A04's scattered samples. */
static void F(scattered)(void **state)
{
    enum { COUNT = 50, N = 9, CHANNELS = 2 };
    row *r = row_open("Taylor series and blends", PRECISION), *q = row_open("a blend at a sample", PRECISION);
    row *g = row_open("gradient of a blend at a sample", PRECISION), *far = row_open("blend of two, Eq. 16", PRECISION);
    row *ring = row_open("blend of ones", PRECISION);
    static T samples[3 * COUNT], blocks[COUNT * CHANNELS * X * N], got[CHANNELS * N], got2[CHANNELS * N];
    static const int stored[3] = { SH_VALUES, SH_GRADIENT, SH_HESSIAN };
    int order, turn, i, k, a, c, p, count;
    (void)state;
    for (i = 0; i < 3 * COUNT; i++) samples[i] = F(random)();
    for (order = 0; order < 3; order++) {
        const int planes = stored[order];
        for (turn = 0; turn < effort(30); turn++) {
            long double poly[CHANNELS * N][20];
            const T power = turn % 3 == 0 ? 2 : (T)ref_between(.5, turn % 6 == 1 ? 64 : 6);
            T point[3];
            int e[20][3], terms = 0;
            for (k = 0; k <= order; k++)                            /* polynomials of total degree <= order */
                for (i = 0; i < 27; i++)
                    if (i % 3 + i / 3 % 3 + i / 9 == k) { e[terms][0] = i % 3; e[terms][1] = i / 3 % 3; e[terms++][2] = i / 9; }
            for (k = 0; k < CHANNELS * N; k++)
                for (i = 0; i < terms; i++) poly[k][i] = (long double)ref_between(-1, 1);
            for (i = 0; i < COUNT; i++)
                for (c = 0; c < CHANNELS; c++)
                    for (p = 0; p < planes; p++)
                        for (k = 0; k < N; k++)
                            blocks[((i * CHANNELS + c) * planes + p) * N + k] =
                                (T)F(polynomial)(terms, e, poly[c * N + k], samples + 3 * i, derivative[p]);
            for (a = 0; a < 3; a++) point[a] = 2 * F(random)();
            for (count = 1; count <= COUNT; count += count < 5 ? 1 : 15) {
                if (count == 1) assert_int_equal(F(sh_sample_taylor)(3, planes, CHANNELS, samples, blocks, point, got), SH_OK);
                else assert_int_equal(F(sh_samples_blend)(3, planes, CHANNELS, power, (size_t)count, samples, blocks, point, got), SH_OK);
                row_case("order %d, power %g, %d samples", order, (double)power, count);
                for (k = 0; k < CHANNELS * N; k++) {
                    long double most = 0;                           /* sum of magnitudes of a sample's terms */
                    for (i = 0; i < count; i++) {
                        const T *b = blocks + (i * CHANNELS + k / N) * planes * N + k % N;
                        long double d = 0, s[3] = { fabsl((long double)b[0]), 0, 0 };
                        for (a = 0; a < 3; a++) d += powl((long double)point[a] - samples[3 * i + a], 2);
                        for (p = 1; p < planes; p++) s[p < 4 ? 1 : 2] += powl((long double)b[p * N], 2) * (p == 5 || p == 6 || p == 8 ? 2 : 1);
                        most = fmaxl(most, s[0] + sqrtl(s[1] * d) + sqrtl(s[2]) * d / 2);
                    }
                    CHECK(r, got[k], F(polynomial)(terms, e, poly[k], point, derivative[0]), (12 + 2 * (long double)power) * LEPS * most, k);
                }
            }
        }
        /* random data from here on: at a sample the sample, to the bit; its gradient nearby */
        for (i = 0; i < COUNT * CHANNELS * planes * N; i++) blocks[i] = F(random)();
        for (turn = 0; turn < COUNT; turn++) {
            row_case("order %d, sample %d", order, turn);
            assert_int_equal(F(sh_samples_blend)(3, planes, CHANNELS, 2, COUNT, samples, blocks, samples + 3 * turn, got), SH_OK);
            for (k = 0; k < CHANNELS * N; k++)
                CHECK(q, got[k], blocks[(turn * CHANNELS + k / N) * planes * N + k % N], 0, k);
            for (a = 0; a < 3 && planes > 1; a++) {
                const T step = IS_F32 ? (T)1e-3 : (T)1e-6;
                T near[3];
                memcpy(near, samples + 3 * turn, sizeof near);
                near[a] += step;
                assert_int_equal(F(sh_samples_blend)(3, planes, CHANNELS, 4, COUNT, samples, blocks, near, got2), SH_OK);
                for (k = 0; k < CHANNELS * N; k++)
                    CHECK(g, (got2[k] - got[k]) / (near[a] - samples[3 * turn + a]), blocks[(turn * CHANNELS + k / N) * planes * N + (1 + a) * N + k % N],
                              4 * ((long double)step + LEPS / (long double)step), k);
            }
        }
    }
    {   /* samples in one place share its weight; distances from 1e-18 to 1e17 keep the weights of Eq. 16 */
        T two[6] = { 1, 2, 3, 1, 2, 3 }, values[2] = { 4, 8 }, at[3] = { 1, 2, 3 }, value, scale;
        assert_int_equal(F(sh_samples_blend)(1, 1, 1, 2, 2, two, values, at, &value), SH_OK);
        row_case("two samples in one place");
        CHECK(far, value, 6, 0, 0);
        for (scale = (T)1e-18; scale < (T)1e17; scale *= 10) {
            const T s[6] = { scale, 0, 0, 0, -3 * scale, 0 }, o[3] = { 0, 0, 0 };
            assert_int_equal(F(sh_samples_blend)(1, 1, 1, 2, 2, s, values, o, &value), SH_OK);
            row_case("distances %g and %g", (double)scale, 3 * (double)scale);
            CHECK(far, value, (4 * 9 + 8) / 10.L, 8 * 8 * LEPS, 0);
        }
    }
    for (turn = 0; turn < effort(400); turn++) {        /* ones: a near sample among many at one distance; ever nearer ones */
        enum { MANY = 4096 };
        static T line[3 * MANY], ones[MANY];
        const int many = turn % 8 == 0 ? MANY : (int)ref_log_between(2, 600);
        const T start = (T)ref_between(1, 6), power = (T)(turn % 2 ? ref_between(.5, 2) : ref_between(2, 64)), at[3] = { 0, 0, 0 };
        T value;
        for (i = 0; i < many; i++) {
            line[3 * i] = turn % 4 < 2 ? i ? start : 1 : start * (1 + (T)(many - i) / (T)(8 * many));
            ones[i] = 1;
        }
        assert_int_equal(F(sh_samples_blend)(1, 1, 1, power, (size_t)many, line, ones, at, &value), SH_OK);
        row_case("%d ones, power %g, from %.9g, kind %d", many, (double)power, (double)start, turn % 4);
        CHECK(ring, value, 1, (12 + 2 * (long double)power + many / 64) * LEPS, 0);
    }
    row_close(ring);
    row_close(r);
    row_close(q);
    row_close(g);
    row_close(far);
}

/* Every documented status; outputs untouched by an error. */
static void F(statuses)(void **state)
{
    enum { NODES = 8, N = 4 };
    static const T bad[4] = { (T)NAN, (T)-NAN, (T)INFINITY, (T)-INFINITY };
    const GRID g = { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } };
    T nodes[NODES * X * N], out[4 * N], point[6] = { (T).5, (T).5, (T).5, (T).25, (T).25, (T).25 }, transfer[2 * N];
    static const int wrong_bands[4] = { 0, -1, SH_MAX_BANDS + 1, 1 << 20 };
    T *const inside[3] = { nodes + 3, nodes + NODES * 4 * N - 1, point };
    int i, a, k, scheme;
    GRID h;
    (void)state;
    for (i = 0; i < NODES * X * N; i++) nodes[i] = 1;
    for (i = 0; i < 2 * N; i++) transfer[i] = 1;
    for (i = 0; i < 4 * N; i++) out[i] = 77;
#define IS(status, call) do { int i_; assert_int_equal(call, status); for (i_ = 0; i_ < 4 * N; i_++) assert_true(out[i_] == 77); } while (0)
#define ALL(status, bands, planes, channels, grid, nodes, scheme, outside, count, points, transfer) do { \
        if ((count) == 1) { \
            IS(status, F(sh_grid_interp)(bands, planes, channels, grid, nodes, scheme, outside, points, out)); \
            IS(status, F(sh_grid_gradient)(bands, planes, channels, grid, nodes, scheme, outside, points, out)); \
            IS(status, F(sh_grid_dot)(bands, planes, channels, grid, nodes, scheme, outside, points, transfer, out)); } \
        IS(status, F(sh_grid_interp_n)(bands, planes, channels, grid, nodes, scheme, outside, count, points, out)); \
        IS(status, F(sh_grid_gradient_n)(bands, planes, channels, grid, nodes, scheme, outside, count, points, out)); \
        IS(status, F(sh_grid_dot_n)(bands, planes, channels, grid, nodes, scheme, outside, count, points, transfer, out)); } while (0)
    ALL(SH_ERROR_NULL, 2, 4, 1, NULL, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer);
    ALL(SH_ERROR_NULL, 2, 4, 1, &g, NULL, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer);
    ALL(SH_ERROR_NULL, 2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, NULL, transfer);
    ALL(SH_OK, 2, 4, 1, &g, NULL, SH_EDGE_HERMITE, SH_CLAMP, 0, NULL, NULL);                /* nothing to do */
    IS(SH_ERROR_NULL, F(sh_grid_interp)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, NULL));
    IS(SH_ERROR_NULL, F(sh_grid_gradient)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, NULL));
    IS(SH_ERROR_NULL, F(sh_grid_dot)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, transfer, NULL));
    IS(SH_ERROR_NULL, F(sh_grid_dot)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, NULL, out));
    IS(SH_ERROR_NULL, F(sh_grid_dot_n)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 2, point, NULL, out));
    for (k = 0; k < 4; k++) {
        ALL(SH_ERROR_BANDS, wrong_bands[k], 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer);
        IS(SH_ERROR_BANDS, F(sh_sample_taylor)(wrong_bands[k], 4, 1, point, nodes, transfer, out));
        IS(SH_ERROR_BANDS, F(sh_samples_blend)(wrong_bands[k], 4, 1, 2, 2, point, nodes, transfer, out));
    }
    ALL(SH_ERROR_COUNT, 2, 4, 0, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer);
    ALL(SH_ERROR_COUNT, 2, 4, -3, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer);
    ALL(SH_ERROR_COUNT, 2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, (size_t)-1 / 4, point, transfer);
    /* a scheme needs its planes; planes, scheme and outside are those of the enums */
    for (scheme = 0; scheme < SCHEMES; scheme++)
        for (k = -1; k < 12; k++) {
            const int fits = (k == 1 || k == 4 || k == 10) && k >= scheme_planes[scheme];
            if (!fits) ALL(SH_ERROR_OPTION, 2, k, 1, &g, nodes, scheme, SH_CLAMP, 1, point, transfer);
        }
    ALL(SH_ERROR_OPTION, 2, 10, 1, &g, nodes, -1, SH_CLAMP, 1, point, transfer);
    ALL(SH_ERROR_OPTION, 2, 10, 1, &g, nodes, SCHEMES, SH_CLAMP, 1, point, transfer);
    ALL(SH_ERROR_OPTION, 2, 10, 1, &g, nodes, SH_TRILINEAR, 2, 1, point, transfer);
    ALL(SH_ERROR_OPTION, 2, 10, 1, &g, nodes, SH_TRILINEAR, -1, 1, point, transfer);
    /* grids */
    for (a = 0; a < 3; a++) {
        static const T wrong_cell[4] = { 0, -1, (T)1e-19, (T)2e18 };
        static const int wrong_count[2] = { 0, -2 };
        for (k = 0; k < 4; k++) { h = g; h.cell[a] = wrong_cell[k]; ALL(SH_ERROR_GRID, 2, 4, 1, &h, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer); }
        for (k = 0; k < 2; k++) { h = g; h.count[a] = wrong_count[k]; ALL(SH_ERROR_GRID, 2, 4, 1, &h, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer); }
        for (k = 0; k < 4; k++) { h = g; h.origin[a] = bad[k]; ALL(SH_ERROR_NOT_FINITE, 2, 4, 1, &h, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer); }
        for (k = 0; k < 4; k++) { h = g; h.cell[a] = bad[k]; ALL(SH_ERROR_NOT_FINITE, 2, 4, 1, &h, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer); }
        h = g;
        h.count[a] = (1 << 24) + 1;                     /* a float has no place left inside a cell */
        ALL(SH_ERROR_COUNT, 2, 4, 1, &h, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer);
    }
    h = g;
    h.count[0] = h.count[1] = h.count[2] = 1 << 24;     /* more numbers than an address can reach */
    ALL(SH_ERROR_COUNT, 2, 4, 1, &h, nodes, SH_EDGE_HERMITE, SH_CLAMP, 1, point, transfer);
    /* points: the first and the last of a batch */
    for (k = 0; k < 4; k++)
        for (a = 0; a < 6; a++) {
            const T keep = point[a];
            point[a] = bad[k];
            if (a < 3) ALL(SH_ERROR_NOT_FINITE, 2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_EXTRAPOLATE, 1, point, transfer);
            {   /* in a batch the other point's outputs are written */
                const int good = a < 3;
                assert_int_equal(F(sh_grid_interp_n)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 2, point, out), SH_ERROR_NOT_FINITE);
                for (i = 0; i < 2 * N; i++) { assert_true((out[i] == 77) == (i / N != good)); out[i] = 77; }
                assert_int_equal(F(sh_grid_dot_n)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 2, point, transfer, out), SH_ERROR_NOT_FINITE);
                for (i = 0; i < 2; i++) { assert_true((out[i] == 77) == (i != good)); out[i] = 77; }
            }
            if (a < 3) IS(SH_ERROR_NOT_FINITE, F(sh_sample_taylor)(2, 4, 1, point, nodes, transfer, out));
            if (a < 3) IS(SH_ERROR_NOT_FINITE, F(sh_sample_taylor)(2, 4, 1, transfer, nodes, point, out));
            IS(SH_ERROR_NOT_FINITE, F(sh_samples_blend)(2, 4, 1, 2, 2, point, nodes, transfer, out));
            point[a] = keep;
        }
    /* an output inside an input */
    for (k = 0; k < 3; k++) {
        if (k < 2 || a) assert_int_equal(F(sh_grid_interp)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, inside[k]), SH_ERROR_OVERLAP);
        assert_int_equal(F(sh_grid_dot)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, transfer, inside[k]), SH_ERROR_OVERLAP);
        assert_int_equal(F(sh_samples_blend)(2, 4, 1, 2, NODES, nodes + NODES * 4 * N, nodes, point, inside[k]), SH_ERROR_OVERLAP);
    }
    assert_int_equal(F(sh_grid_dot)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, transfer, transfer + 3), SH_ERROR_OVERLAP);
    for (i = 0; i < NODES * X * N; i++) assert_true(nodes[i] == 1);
    for (i = 0; i < 2 * N; i++) assert_true(transfer[i] == 1);
    /* samples */
    IS(SH_ERROR_NULL, F(sh_sample_taylor)(2, 4, 1, NULL, nodes, point, out));
    IS(SH_ERROR_NULL, F(sh_sample_taylor)(2, 4, 1, point, NULL, point, out));
    IS(SH_ERROR_NULL, F(sh_sample_taylor)(2, 4, 1, point, nodes, NULL, out));
    IS(SH_ERROR_NULL, F(sh_sample_taylor)(2, 4, 1, point, nodes, point, NULL));
    IS(SH_ERROR_COUNT, F(sh_samples_blend)(2, 4, 1, 2, 0, point, nodes, point, out));
    IS(SH_ERROR_COUNT, F(sh_samples_blend)(2, 4, 0, 2, 2, point, nodes, point, out));
    IS(SH_ERROR_COUNT, F(sh_samples_blend)(2, 4, 1, 2, (size_t)-1 / 8, point, nodes, point, out));
    IS(SH_ERROR_OPTION, F(sh_sample_taylor)(2, 3, 1, point, nodes, point, out));
    IS(SH_ERROR_OPTION, F(sh_samples_blend)(2, 4, 1, 0, 2, point, nodes, point, out));
    IS(SH_ERROR_OPTION, F(sh_samples_blend)(2, 4, 1, -1, 2, point, nodes, point, out));
    IS(SH_ERROR_OPTION, F(sh_samples_blend)(2, 4, 1, 65, 2, point, nodes, point, out));
    IS(SH_ERROR_OPTION, F(sh_samples_blend)(2, 4, 1, (T)NAN, 2, point, nodes, point, out));
    transfer[0] = (T)2e18;      /* too far from the samples for a square in float */
    IS(SH_ERROR_NOT_FINITE, F(sh_samples_blend)(2, 4, 1, 2, 2, point, nodes, transfer, out));
    /* nothing to do is fine, whatever the arrays are; structure is still checked */
    IS(SH_OK, F(sh_grid_interp_n)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 0, NULL, NULL));
    IS(SH_OK, F(sh_grid_gradient_n)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 0, NULL, NULL));
    IS(SH_OK, F(sh_grid_dot_n)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 0, NULL, NULL, NULL));
    IS(SH_ERROR_BANDS, F(sh_grid_interp_n)(0, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, 0, NULL, NULL));
    /* NaN in the data is data: it comes out where it went in, and only there */
    nodes[3 * 4 * N + 2] = (T)NAN;
    assert_int_equal(F(sh_grid_interp)(2, 4, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, out), SH_OK);
    for (i = 0; i < N; i++) assert_true(!F(shi_finite)(out + i, 1) == (i == 2));
#undef ALL
#undef IS
}
#endif
