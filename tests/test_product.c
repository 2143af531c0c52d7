/* Rotation, products, lobes, windows: against long double quadrature of the definitions, which knows no rotation matrix,
 * no Gaunt coefficient and no recurrence of the header. */
#ifndef T
#include "sh_product.h"
#include "report.h"
#include "ref.h"

enum { MOST = SH_PRODUCT_BANDS, MOST2 = MOST * MOST, RINGS = 2 * MOST, SPOKES = 3 * MOST + 1, POINTS = RINGS * SPOKES };

/* Points and weights of an exact rule over the sphere, or over the hemisphere z >= 0. */
typedef struct { long double u[POINTS][3], w[POINTS]; int count; } rule;

static void rule_make(rule *r, int rings, int spokes, int hemisphere)
{
    long double z[RINGS], w[RINGS];
    int i, j;

    ref_gauss(rings, z, w);
    r->count = rings * spokes;
    for (i = 0; i < rings; i++)
        for (j = 0; j < spokes; j++) {
            const long double h = hemisphere ? (1 + z[i]) / 2 : z[i], f = 2 * REF_PI * (j + 0.3L) / spokes;
            const long double s = sqrtl((1 - h) * (1 + h));
            long double *u = r->u[i * spokes + j];
            u[0] = s * cosl(f);
            u[1] = s * sinl(f);
            u[2] = h;
            r->w[i * spokes + j] = w[i] / (hemisphere ? 2 : 1) * 2 * REF_PI / spokes;
        }
}

static long double dot_n(int n, const long double *a, const long double *b)
{
    long double s = 0;
    int i;
    for (i = 0; i < n; i++) s += a[i] * b[i];
    return s;
}

/* A frame whose third row is n: u' = m u has u'_z = u.n; columns of the transpose are the axes. */
static void frame(const long double n[3], long double m[9])
{
    const long double len = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const int k = fabsl(n[0]) < fabsl(n[1]) ? 0 : 1;
    long double e[3] = { 0, 0, 0 }, d, *x = m, *y = m + 3, *z = m + 6;
    int i;

    for (i = 0; i < 3; i++) z[i] = n[i] / len;
    e[k] = 1;
    d = z[k];
    for (i = 0; i < 3; i++) x[i] = e[i] - d * z[i];
    d = sqrtl(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (i = 0; i < 3; i++) x[i] /= d;
    y[0] = z[1] * x[2] - z[2] * x[1];
    y[1] = z[2] * x[0] - z[0] * x[2];
    y[2] = z[0] * x[1] - z[1] * x[0];
}

/* out = projection of max(0, n.u) f(u) */
static void ref_cosine_product(int bands, const long double n[3], const long double *c, long double *out)
{
    static rule r;
    static int made;
    long double m[9], y[MOST2];
    int p, i;

    if (made != bands) { rule_make(&r, bands + 1, 2 * bands + 1, 1); made = bands; }
    frame(n, m);
    for (i = 0; i < bands * bands; i++) out[i] = 0;
    for (p = 0; p < r.count; p++) {
        long double u[3], f;
        for (i = 0; i < 3; i++) u[i] = m[i] * r.u[p][0] + m[3 + i] * r.u[p][1] + m[6 + i] * r.u[p][2];
        ref_values(bands, u, y);
        f = r.w[p] * r.u[p][2] * dot_n(bands * bands, c, y);
        for (i = 0; i < bands * bands; i++) out[i] += f * y[i];
    }
}

/* out_i Y_i(R u) = c_i Y_i(u), R row-major and orthonormal */
static void ref_rotate(int bands, const long double m[9], const long double *c, long double *out)
{
    static rule r;
    static int made;
    long double y[MOST2];
    int p, i;

    if (made != bands) { rule_make(&r, bands, 2 * bands + 1, 0); made = bands; }
    for (i = 0; i < bands * bands; i++) out[i] = 0;
    for (p = 0; p < r.count; p++) {
        long double u[3], f;
        ref_values(bands, r.u[p], y);
        f = r.w[p] * dot_n(bands * bands, c, y);
        for (i = 0; i < 3; i++) u[i] = m[3 * i] * r.u[p][0] + m[3 * i + 1] * r.u[p][1] + m[3 * i + 2] * r.u[p][2];
        ref_values(bands, u, y);
        for (i = 0; i < bands * bands; i++) out[i] += f * y[i];
    }
}

static void ref_triple(int na, const long double *a, int nb, const long double *b, int n, long double *out)
{
    static rule r;
    static long double y[POINTS][MOST2];
    static int made;
    const int most = na > nb ? (na > n ? na : n) : nb > n ? nb : n;
    int p, i;

    if (made != most) {
        rule_make(&r, (3 * most) / 2 + 1, 3 * most + 1, 0);
        for (p = 0; p < r.count; p++) ref_values(most, r.u[p], y[p]);
        made = most;
    }
    for (i = 0; i < n * n; i++) out[i] = 0;
    for (p = 0; p < r.count; p++) {
        const long double f = r.w[p] * dot_n(na * na, a, y[p]) * dot_n(nb * nb, b, y[p]);
        for (i = 0; i < n * n; i++) out[i] += f * y[p][i];
    }
}

/* The rotation nearest to a nearly orthonormal matrix: m <- (m + m^-T)/2. */
static void polar(long double m[9])
{
    int turn, i;
    for (turn = 0; turn < 6; turn++) {
        long double c[9], det;
        for (i = 0; i < 9; i++) {
            const int r = i / 3, k = i % 3, r1 = (r + 1) % 3, r2 = (r + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
            c[i] = m[3 * r1 + k1] * m[3 * r2 + k2] - m[3 * r1 + k2] * m[3 * r2 + k1];
        }
        det = m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
        for (i = 0; i < 9; i++) m[i] = (m[i] + c[i] / det) / 2;
    }
}

static void matrix_of(const long double q[4], long double m[9])
{
    const long double x = q[0], y = q[1], z = q[2], w = q[3], s = 2 / (x * x + y * y + z * z + w * w);
    m[0] = 1 - s * (y * y + z * z); m[1] = s * (x * y - z * w); m[2] = s * (x * z + y * w);
    m[3] = s * (x * y + z * w); m[4] = 1 - s * (x * x + z * z); m[5] = s * (y * z - x * w);
    m[6] = s * (x * z - y * w); m[7] = s * (y * z + x * w); m[8] = 1 - s * (x * x + y * y);
}

static long double norm2(int n, const long double *c) { return sqrtl(dot_n(n, c, c)); }
static int limit(int bands) { return bands <= 6 ? 16 : 40; }        /* products and rotation, in eps |c|_2 */

#define BOTH "test_product.c"
#include "both.h"

int main(void)
{
    const struct CMUnitTest tests[] = {
        BOTH_TESTS(rotate), BOTH_TESTS(rotate_edges), BOTH_TESTS(axes), BOTH_TESTS(triple), BOTH_TESTS(cosine),
        BOTH_TESTS(zonal_and_diffuse), BOTH_TESTS(batches), BOTH_TESTS(lobes), BOTH_TESTS(refusals)
    };
    return RUN_TESTS(tests);
}

#else /* once per precision */

/* Random vectors, a peak (the basis at a direction), and a single coefficient. */
static void F(light)(int bands, int kind, T *c)
{
    const int n = bands * bands;
    int i;
    if (kind == 1) {
        double u[3];
        long double v[3], y[MOST2];
        ref_unit(u);
        for (i = 0; i < 3; i++) v[i] = (long double)u[i];
        ref_values(bands, v, y);
        for (i = 0; i < n; i++) c[i] = (T)y[i];
    } else for (i = 0; i < n; i++) c[i] = kind == 2 ? (T)0 : (T)ref_between(-1, 1);
    if (kind == 2) c[(int)(ref_random() * n)] = 1;
}

static void F(widen)(int n, const T *c, long double *w)
{
    int i;
    for (i = 0; i < n; i++) w[i] = (long double)c[i];
}

static void F(rotate)(void **state)
{
    row *wq = row_open("rotate by quaternion, 1-6 bands", PRECISION), *wq2 = row_open("rotate by quaternion, 7-16 bands", PRECISION);
    row *wm = row_open("rotate by matrix, 1-6 bands", PRECISION), *wm2 = row_open("rotate by matrix, 7-16 bands", PRECISION);
    static const int sizes[] = { 1, 2, 3, 4, 5, 6, 7, 9, 12, 16 };
    int s, turn, i, k;

    (void)state;
    for (s = 0; s < 10; s++)
        for (turn = 0; turn < effort(sizes[s] > 9 ? 3 : 10); turn++) {
            const int bands = sizes[s], n = bands * bands;
            T q[4], m[9], c[MOST2], out[MOST2];
            long double lq[4], lm[9], lc[MOST2], want[MOST2];
            F(sh_rotation) r;

            F(light)(bands, turn % 3, c);
            F(widen)(n, c, lc);
            for (i = 0; i < 4; i++) q[i] = (T)ref_between(-1, 1);
            if (turn % 4 == 1) q[0] = q[1] = 0;                 /* about z: b = 0 */
            if (turn % 4 == 2) q[2] = q[3] = 0;                 /* b = pi */
            if (turn % 4 == 3) { q[0] *= (T)1e-4; q[1] *= (T)1e-5; }
            F(widen)(4, q, lq);
            matrix_of(lq, lm);
            for (i = 0; i < 9; i++) m[i] = (T)lm[i];
            for (k = 0; k < 2; k++) {
                row *w = k ? (bands <= 6 ? wm : wm2) : bands <= 6 ? wq : wq2;
                if (k) { F(widen)(9, m, lm); polar(lm); }
                assert_int_equal(k ? F(sh_rotation_matrix)(m, &r) : F(sh_rotation_quaternion)(q, &r), SH_OK);
                assert_int_equal(F(sh_rotate)(bands, &r, 1, c, out), SH_OK);
                ref_rotate(bands, lm, lc, want);
                row_case("bands %d, light %d, turn %d", bands, turn % 3, turn);
                for (i = 0; i < n; i++)
                    row_check(w, (long double)out[i], want[i], limit(bands) * (long double)EPS * norm2(n, lc), i);
            }
        }
    row_close(wq); row_close(wq2); row_close(wm); row_close(wm2);
}

static void F(rotate_edges)(void **state)
{
    static const T identity[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, half[9] = { 1, 0, 0, 0, -1, 0, 0, 0, -1 };
    static const T mirror[9] = { 1, 0, 0, 0, 1, 0, 0, 0, -1 }, big[9] = { 2, 0, 0, 0, 2, 0, 0, 0, 2 };
    T c[MOST2], d[MOST2], m[9], q[4] = { 0, 0, 0, 0 };
    row *w = row_open("rotation there and back", PRECISION);
    F(sh_rotation) r, back;
    int i, turn;

    (void)state;
    F(light)(MOST, 0, c);
    assert_int_equal(F(sh_rotation_matrix)(identity, &r), SH_OK);
    F(sh_rotate)(MOST, &r, 1, c, d);
    row_case("identity");
    for (i = 0; i < MOST2; i++) row_check(w, (long double)d[i], (long double)c[i], 40 * (long double)EPS * 16, i);
    assert_int_equal(F(sh_rotation_matrix)(half, &r), SH_OK);           /* b = pi: y and z change sign */
    F(sh_rotate)(MOST, &r, 1, c, d);
    F(sh_mirror)(MOST, 1, 1, d, d);
    F(sh_mirror)(MOST, 2, 1, d, d);
    row_case("half turn about x");
    for (i = 0; i < MOST2; i++) row_check(w, (long double)d[i], (long double)c[i], 40 * (long double)EPS * 16, i);
    for (i = 0; i < 4; i++) q[i] = (T)ref_between(-1, 1);
    assert_int_equal(F(sh_rotation_quaternion)(q, &r), SH_OK);
    assert_int_equal(F(sh_rotation_inverse)(&r, &back), SH_OK);
    F(sh_rotate)(MOST, &r, 1, c, d);
    F(sh_rotate)(MOST, &back, 1, d, d);
    row_case("inverse");
    for (i = 0; i < MOST2; i++) row_check(w, (long double)d[i], (long double)c[i], 80 * (long double)EPS * 16, i);
    for (turn = 20; turn < 320; turn++) {                                 /* a hair off the identity */
        q[0] = (T)(0.25 * pow(10, -turn));
        q[1] = (T)(-0.5 * pow(10, -turn));
        q[2] = 0;
        q[3] = 1;
        assert_int_equal(F(sh_rotation_quaternion)(q, &r), SH_OK);
        F(sh_rotate)(MOST, &r, 1, c, d);
        row_case("1e-%d from the identity", turn);
        for (i = 0; i < MOST2; i++) row_check(w, (long double)d[i], (long double)c[i], 40 * (long double)EPS * 16, i);
    }
    row_close(w);

    assert_int_equal(F(sh_rotation_matrix)(mirror, &r), SH_ERROR_MATRIX);
    assert_int_equal(F(sh_rotation_matrix)(big, &r), SH_ERROR_MATRIX);
    memcpy(m, identity, sizeof m);
    m[1] = (T)0.01;
    assert_int_equal(F(sh_rotation_matrix)(m, &r), SH_ERROR_MATRIX);
    m[1] = (T)NAN;
    assert_int_equal(F(sh_rotation_matrix)(m, &r), SH_ERROR_NOT_FINITE);
    q[0] = q[1] = q[2] = q[3] = 0;
    assert_int_equal(F(sh_rotation_quaternion)(q, &r), SH_ERROR_MATRIX);
    q[2] = (T)INFINITY;
    assert_int_equal(F(sh_rotation_quaternion)(q, &r), SH_ERROR_NOT_FINITE);
    q[0] = (T)3e-18; q[1] = (T)-2e-18; q[2] = 0; q[3] = (T)1e-18;
    assert_int_equal(F(sh_rotation_quaternion)(q, &r), SH_OK);
    q[0] = (T)3e17; q[1] = (T)-2e17; q[2] = 0; q[3] = (T)1e17;
    assert_int_equal(F(sh_rotation_quaternion)(q, &back), SH_OK);
    F(sh_rotate)(3, &r, 1, c, d);
    F(sh_rotate)(3, &back, 1, c, m);
    for (i = 0; i < 9; i++) assert_true(fabs((double)d[i] - (double)m[i]) <= 16 * (double)EPS * 3);
}

/* All 48: the function is carried along. */
static void F(axes)(void **state)
{
    row *w = row_open("axis permutations and mirrors", PRECISION);
    int code, i, k;

    (void)state;
    for (code = 0; code < 6 * 8; code++) {
        static const int perm[6][3] = { {1,2,3}, {2,1,3}, {1,3,2}, {3,1,2}, {2,3,1}, {3,2,1} };
        T c[MOST2], d[MOST2];
        long double lc[MOST2], ld[MOST2], y[MOST2];
        int axes[3];

        for (k = 0; k < 3; k++) axes[k] = perm[code / 8][k] * (code >> k & 1 ? -1 : 1);
        F(light)(MOST, 0, c);
        assert_int_equal(F(sh_permute_axes)(MOST, axes, 1, c, d), SH_OK);
        F(widen)(MOST2, c, lc);
        F(widen)(MOST2, d, ld);
        row_case("axes %d %d %d", axes[0], axes[1], axes[2]);
        for (i = 0; i < 4; i++) {
            double u[3];
            long double v[3], p[3], f;
            ref_unit(u);
            for (k = 0; k < 3; k++) v[k] = (long double)u[k];
            for (k = 0; k < 3; k++) p[k] = axes[k] < 0 ? -v[-axes[k] - 1] : v[axes[k] - 1];
            ref_values(MOST, v, y);
            f = dot_n(MOST2, lc, y);
            ref_values(MOST, p, y);
            row_check(w, dot_n(MOST2, ld, y), f, 40 * (long double)EPS * norm2(MOST2, lc) * MOST / 3.5L, i);
        }
    }
    row_close(w);
    {
        static const int flip[3] = { -2, 1, 3 }, bad[3][3] = { {1,1,2}, {0,1,2}, {1,2,4} };
        static const int quarter_back[3] = { 2, -1, 3 };
        T c[25], d[25];
        F(light)(5, 0, c);
        F(sh_permute_axes)(5, flip, 1, c, d);
        F(sh_permute_axes)(5, quarter_back, 1, d, d);
        assert_memory_equal(c, d, sizeof c);                            /* about z: exact */
        for (i = 0; i < 3; i++) assert_int_equal(F(sh_permute_axes)(5, bad[i], 1, c, d), SH_ERROR_OPTION);
        assert_int_equal(F(sh_permute_axes)(5, NULL, 1, c, d), SH_ERROR_NULL);
        assert_int_equal(F(sh_permute_axes)(5, NULL, 0, NULL, NULL), SH_OK);
        assert_int_equal(F(sh_permute_axes)(5, flip, 0, NULL, d), SH_OK);
    }
}

static void F(triple)(void **state)
{
    row *w = row_open("triple product, 1-6 bands", PRECISION), *w2 = row_open("triple product, 7-16 bands", PRECISION);
    row *wm = row_open("triple product, mixed bands", PRECISION);
    static const int sizes[] = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 16 };
    static const int mixed[][3] = { {9,3,9}, {9,3,11}, {3,9,9}, {5,5,9}, {16,1,16}, {4,6,2}, {2,2,12} };
    T a[MOST2], b[MOST2], out[MOST2];
    long double la[MOST2], lb[MOST2], want[MOST2];
    int s, turn, i;

    (void)state;
    for (s = 0; s < 12; s++)
        for (turn = 0; turn < effort(9); turn++) {
            const int bands = sizes[s], n = bands * bands;
            F(light)(bands, turn % 3, a);
            F(light)(bands, turn / 3 % 3, b);
            F(widen)(n, a, la);
            F(widen)(n, b, lb);
            ref_triple(bands, la, bands, lb, bands, want);
            assert_int_equal(F(sh_triple_product)(bands, a, b, out), SH_OK);
            row_case("bands %d, lights %d %d", bands, turn % 3, turn / 3 % 3);
            for (i = 0; i < n; i++)
                row_check(bands <= 6 ? w : w2, (long double)out[i], want[i],
                          limit(bands) * (long double)EPS * norm2(n, la) * norm2(n, lb), i);
        }
    for (s = 0; s < 7; s++)
        for (turn = 0; turn < effort(3); turn++) {
            const int na = mixed[s][0], nb = mixed[s][1], n = mixed[s][2], most = na > n ? na : n;
            F(light)(na, turn % 3, a);
            F(light)(nb, 0, b);
            F(widen)(na * na, a, la);
            F(widen)(nb * nb, b, lb);
            ref_triple(na, la, nb, lb, n, want);
            assert_int_equal(F(sh_triple_product_bands)(na, a, nb, b, n, out), SH_OK);
            row_case("bands %d x %d -> %d", na, nb, n);
            for (i = 0; i < n * n; i++)
                row_check(wm, (long double)out[i], want[i],
                          limit(most) * (long double)EPS * norm2(na * na, la) * norm2(nb * nb, lb), i);
        }
    row_close(w); row_close(w2); row_close(wm);
    F(light)(9, 0, a);
    F(light)(9, 0, b);
    F(sh_triple_product)(9, a, b, out);
    F(sh_triple_product)(9, a, b, a);                                   /* in place */
    assert_memory_equal(a, out, 81 * sizeof *a);
    memset(a, 0, sizeof a);
    a[0] = a[6] = a[20] = 1;                                            /* zonal even times zonal even */
    F(sh_triple_product)(9, a, a, out);
    for (i = 0; i < 81; i++) {
        const int l = ref_band(i), zonal = i == l * (l + 1) && l % 2 == 0;
        if (!zonal) assert_true(out[i] == 0);                           /* symmetry is kept to the bit */
    }
}

static void F(cosine)(void **state)
{
    row *wl = row_open("cosine product local, 1-6 bands", PRECISION), *wl2 = row_open("cosine product local, 7-16 bands", PRECISION);
    row *ww = row_open("cosine product world, 1-6 bands", PRECISION), *ww2 = row_open("cosine product world, 7-16 bands", PRECISION);
    row *wd = row_open("irradiance from a product", PRECISION);
    static const int sizes[] = { 1, 2, 3, 4, 5, 6, 7, 9, 12, 16 };
    static const long double up[3] = { 0, 0, 1 };
    int s, turn, i, k;

    (void)state;
    for (s = 0; s < 10; s++)
        for (turn = 0; turn < effort(sizes[s] > 9 ? 3 : 9); turn++) {
            const int bands = sizes[s], n = bands * bands;
            T c[MOST2], out[MOST2], normal[3], e;
            long double lc[MOST2], want[MOST2], ln[3], scale;
            double u[3];

            F(light)(bands, turn % 3, c);
            F(widen)(n, c, lc);
            scale = limit(bands) * (long double)EPS * norm2(n, lc);
            assert_int_equal(F(sh_cosine_product_local)(bands, c, out), SH_OK);
            ref_cosine_product(bands, up, lc, want);
            row_case("bands %d, light %d", bands, turn % 3);
            for (i = 0; i < n; i++) row_check(bands <= 6 ? wl : wl2, (long double)out[i], want[i], scale, i);
            ref_unit(u);
            for (k = 0; k < 3; k++) normal[k] = (T)(u[k] * (turn % 3 == 1 ? 1.01e-18 : turn % 3 == 2 ? 1e17 : 1));
            F(widen)(3, normal, ln);
            assert_int_equal(F(sh_cosine_product)(bands, normal, c, out), SH_OK);
            ref_cosine_product(bands, ln, lc, want);
            row_case("bands %d, light %d, normal %g %g %g", bands, turn % 3, (double)normal[0], (double)normal[1], (double)normal[2]);
            for (i = 0; i < n; i++) row_check(bands <= 6 ? ww : ww2, (long double)out[i], want[i], scale, i);
            F(sh_diffuse_from_product)(out, &e);
            row_check(wd, (long double)e, want[0] * 2 * sqrtl(REF_PI), scale * 3.55L, 0);
        }
    for (k = 20; k < (IS_F32 ? 45 : 320); k++) {                         /* a hair off a pole */
        const int bands = 9, n = bands * bands;
        T c[MOST2], out[MOST2], normal[3];
        long double lc[MOST2], want[MOST2], ln[3] = { 0, 0, k % 2 ? -1 : 1 };
        normal[0] = (T)pow(10, -k);
        normal[1] = (T)(-0.5 * pow(10, -k));
        normal[2] = k % 2 ? -1 : 1;
        F(light)(bands, 0, c);
        F(widen)(n, c, lc);
        assert_int_equal(F(sh_cosine_product)(bands, normal, c, out), SH_OK);
        ref_cosine_product(bands, ln, lc, want);
        row_case("normal 1e-%d off the pole", k);
        for (i = 0; i < n; i++)
            row_check(ww2, (long double)out[i], want[i], limit(bands) * (long double)EPS * norm2(n, lc), i);
    }
    row_close(wl); row_close(wl2); row_close(ww); row_close(ww2); row_close(wd);
}

static void F(zonal_and_diffuse)(void **state)
{
    row *wz = row_open("cosine product zonal (Eq. 10)", PRECISION), *wd = row_open("diffuse", PRECISION);
    row *we = row_open("diffuse = 2 sqrt(pi) T_00", PRECISION);
    static rule r;
    int turn, i, k, l;

    (void)state;
    rule_make(&r, 24, 5, 1);
    for (turn = 0; turn < effort(24); turn++) {
        const int bands = 1 + turn % 12, n = bands * bands, zb = turn % 2 ? 3 : bands;
        T c[MOST2], out[MOST2], normal[3], e, t;
        long double lc[MOST2], cosine[MOST2], y[MOST2], want[MOST2], zh[MOST], ln[3], len, sum = 0;
        double u[3];

        F(light)(bands, turn % 3, c);
        F(widen)(n, c, lc);
        ref_unit(u);
        for (k = 0; k < 3; k++) normal[k] = (T)u[k];
        F(widen)(3, normal, ln);
        len = norm2(3, ln);
        for (k = 0; k < 3; k++) ln[k] /= len;
        for (l = 0; l < MOST; l++) zh[l] = 0;
        for (i = 0; i < r.count; i++) {                                 /* the cosine's ZH by quadrature */
            ref_values(MOST, r.u[i], y);
            for (l = 0; l < MOST; l++) zh[l] += r.w[i] * r.u[i][2] * y[l * (l + 1)];
        }
        ref_values(MOST, ln, y);
        for (i = 0; i < zb * zb; i++) cosine[i] = sqrtl(4 * REF_PI / (2 * ref_band(i) + 1)) * zh[ref_band(i)] * y[i];
        ref_triple(bands, lc, zb, cosine, bands, want);
        assert_int_equal(F(sh_cosine_product_zonal)(bands, zb, normal, c, out), SH_OK);
        row_case("bands %d, zonal bands %d", bands, zb);
        for (i = 0; i < n; i++)
            row_check(wz, (long double)out[i], want[i], limit(bands) * (long double)EPS * norm2(n, lc) * norm2(zb * zb, cosine), i);
        for (i = 0; i < n; i++) sum += sqrtl(4 * REF_PI / (2 * ref_band(i) + 1)) * zh[ref_band(i)] * y[i] * lc[i];
        assert_int_equal(F(sh_diffuse)(bands, c, normal, &e), SH_OK);
        row_check(wd, (long double)e, sum, limit(bands) * (long double)EPS * norm2(n, lc), 0);
        for (k = 0; k < 3; k++) normal[k] *= (T)(turn % 2 ? 3000 : 0.001);              /* any length */
        assert_int_equal(F(sh_diffuse)(bands, c, normal, &e), SH_OK);
        row_check(wd, (long double)e, sum, limit(bands) * (long double)EPS * norm2(n, lc), 0);
        F(sh_cosine_product)(bands, normal, c, out);
        F(sh_diffuse_from_product)(out, &t);
        row_check(we, (long double)t, (long double)e, 2 * limit(bands) * (long double)EPS * norm2(n, lc) * 3.55L, 0);
    }
    row_close(wz); row_close(wd); row_close(we);
}

/* Many at once and blocks have the bits of one at a time; a bad normal spoils only its own. */
static void F(batches)(void **state)
{
    enum { COUNT = 23, BLOCKS = 3 };
    static T c[COUNT * MOST2], one[COUNT * MOST2], all[COUNT * MOST2], block[BLOCKS * 8 * MOST2], bout[BLOCKS * 8 * MOST2];
    static T normals[COUNT * 3], bn[BLOCKS * 3 * 8], b[COUNT * MOST2];
    static const int sizes[] = { 1, 2, 3, 5, 9, 16 };
    F(sh_rotation) r;
    T q[4];
    int s, i, v;

    (void)state;
    for (i = 0; i < 4; i++) q[i] = (T)ref_between(-1, 1);
    F(sh_rotation_quaternion)(q, &r);
    for (s = 0; s < 6; s++) {
        const int bands = sizes[s], n = bands * bands;
        size_t bytes = (size_t)n * sizeof(T);
        int count;
        for (v = 0; v < COUNT; v++) {
            double u[3];
            F(light)(bands, 0, c + v * n);
            F(light)(bands, 0, b + v * n);
            ref_unit(u);
            for (i = 0; i < 3; i++) normals[3 * v + i] = (T)u[i];
        }
        for (v = 0; v < BLOCKS * 8; v++) {
            for (i = 0; i < n; i++) block[(v / 8 * n + i) * 8 + v % 8] = c[(v < COUNT ? v : 0) * n + i];
            for (i = 0; i < 3; i++) bn[(v / 8 * 3 + i) * 8 + v % 8] = normals[(v < COUNT ? v : 0) * 3 + i];
        }
        for (count = 0; count <= COUNT; count += count < 9 ? 1 : 7) {
            for (v = 0; v < count; v++) assert_int_equal(F(sh_rotate)(bands, &r, 1, c + v * n, one + v * n), SH_OK);
            assert_int_equal(F(sh_rotate)(bands, &r, (size_t)count, c, all), SH_OK);
            assert_memory_equal(one, all, bytes * (size_t)count);
            for (v = 0; v < count; v++) F(sh_cosine_product)(bands, normals + 3 * v, c + v * n, one + v * n);
            assert_int_equal(F(sh_cosine_product_n)(bands, (size_t)count, normals, c, all), SH_OK);
            assert_memory_equal(one, all, bytes * (size_t)count);
            for (v = 0; v < count; v++) F(sh_triple_product)(bands, c + v * n, b + v * n, one + v * n);
            assert_int_equal(F(sh_triple_product_n)(bands, (size_t)count, c, b, all), SH_OK);
            assert_memory_equal(one, all, bytes * (size_t)count);
            for (v = 0; v < count; v++) F(sh_cosine_product_local)(bands, c + v * n, one + v * n);
            memcpy(all, c, bytes * (size_t)count);
            assert_int_equal(F(sh_cosine_product_local_n)(bands, (size_t)count, all, all), SH_OK);     /* in place */
            assert_memory_equal(one, all, bytes * (size_t)count);
        }
        assert_int_equal(F(sh_cosine_product_local_n)(bands, COUNT, c, all), SH_OK);
        assert_int_equal(F(sh_cosine_product_local_blocks)(bands, BLOCKS, block, bout), SH_OK);
        for (v = 0; v < COUNT; v++)
            for (i = 0; i < n; i++) assert_true(bout[(v / 8 * n + i) * 8 + v % 8] == all[v * n + i]);
        F(sh_rotate)(bands, &r, COUNT, c, all);
        assert_int_equal(F(sh_rotate_blocks)(bands, &r, BLOCKS, block, bout), SH_OK);
        for (v = 0; v < COUNT; v++)
            for (i = 0; i < n; i++) assert_true(bout[(v / 8 * n + i) * 8 + v % 8] == all[v * n + i]);
        F(sh_cosine_product_n)(bands, COUNT, normals, c, all);
        assert_int_equal(F(sh_cosine_product_blocks)(bands, BLOCKS, bn, block, bout), SH_OK);
        for (v = 0; v < COUNT; v++)
            for (i = 0; i < n; i++) assert_true(bout[(v / 8 * n + i) * 8 + v % 8] == all[v * n + i]);
        for (v = 0; v < COUNT; v++) F(sh_diffuse)(bands, c, normals + 3 * v, one + v);
        F(sh_diffuse_n)(bands, c, COUNT, normals, all);
        assert_memory_equal(one, all, COUNT * sizeof *one);
        F(sh_cosine_product_n)(bands, COUNT, normals, c, all);
        memcpy(one, all, sizeof one);
        for (i = 0; i < 3; i++) normals[3 * 5 + i] = 0;
        normals[3 * 17] = (T)NAN;
        memset(all, 0x55, sizeof all);
        assert_int_equal(F(sh_cosine_product_n)(bands, COUNT, normals, c, all), SH_ERROR_NOT_FINITE);      /* the last bad one */
        for (v = 0; v < COUNT; v++) {
            static const unsigned char untouched[4] = { 0x55, 0x55, 0x55, 0x55 };
            if (v == 5 || v == 17) assert_memory_equal(all + v * n, untouched, 4);
            else assert_memory_equal(all + v * n, one + v * n, bytes);
        }
    }
}

static void F(lobes)(void **state)
{
    row *wc = row_open("zonal cosine", PRECISION), *wp = row_open("zonal Phong", PRECISION), *wg = row_open("zonal GGX", PRECISION);
    static const T powers[] = { 0, 1, 2, 5, (T)12.5, 80, 1000 };
    static const T alphas[] = { (T)1e-5, (T)0.0009, (T)0.001, (T)0.01, (T)0.04, (T)0.1, (T)0.25, (T)0.5, (T)0.9, (T)0.9999, 1 };
    static long double x[256], g[256];
    T zh[SH_MAX_BANDS];
    int i, k, l;

    (void)state;
    ref_gauss(256, x, g);
    F(sh_zonal_cosine)(SH_MAX_BANDS, zh);
    for (l = 0; l < SH_MAX_BANDS; l++) {
        long double want = 0, q[3];
        for (i = 0; i < 256; i++) {
            const long double z = (1 + x[i]) / 2;
            ref_legendre(l, 0, z, q);
            want += REF_PI * g[i] * z * q[0] * ref_M(l);
        }
        row_case("cosine");
        row_check(wc, (long double)zh[l], want, 8 * (long double)EPS * fabsl((long double)zh[l]) + 1e-17L, l);
    }
    F(sh_zonal_phong)(SH_MAX_BANDS, IS_F32 ? (T)3.4e38 : (T)1.7e308, zh);            /* a mirror, to rounding */
    row_case("the largest power");
    for (l = 0; l < SH_MAX_BANDS; l++) row_check(wp, (long double)zh[l], ref_M(l), 8 * (long double)EPS * ref_M(l), l);
    for (k = 0; k < 7 + effort(60); k++) {          /* z = t^2; high powers: z^(s+1) = e^-y */
        const T power = k < 7 ? powers[k] : (T)ref_log_between(1, 1e4);
        F(sh_zonal_phong)(SH_MAX_BANDS, power, zh);
        for (l = 0; l < SH_MAX_BANDS; l++) {
            long double want = 0, q[3];
            for (i = 0; i < 256; i++) {
                const long double t = (1 + x[i]) / 2, s = (long double)power, y = 60 * t;
                ref_legendre(l, 0, s < 100 ? t * t : expl(-y / (s + 1)), q);
                want += g[i] / 2 * (s < 100 ? 2 * powl(t, 2 * s + 1) : 60 * expl(-y) / (s + 1)) * q[0];
            }
            row_case("s = %.17g", (double)power);
            row_check(wp, (long double)zh[l], want * ((long double)power + 1) * ref_M(l), 8 * (long double)EPS * ref_M(l), l);
        }
    }
    for (k = 0; k < 11; k++) {      /* by the distribution of h: tan^2 h = a^2 (1-p)/p, z = cos 2h; p in dyadic pieces down to 0 */
        static const int some[] = { 0, 1, 2, 8, 31 };
        const long double a = (long double)alphas[k];
        int piece, n;
        assert_int_equal(F(sh_zonal_ggx)(SH_MAX_BANDS, alphas[k], zh), SH_OK);
        for (n = 0; n < 5; n++) {
            long double want = 0, q[3];
            l = some[n];
            for (piece = 0; piece < 50; piece++)
                for (i = 0; i < 256; i++) {
                    const long double hi = ldexpl(1, -piece), lo = piece == 49 ? 0 : hi / 2;
                    const long double p = lo + (hi - lo) * (1 + x[i]) / 2, t2 = a * a * (1 - p) / p;
                    ref_legendre(l, 0, (1 - t2) / (1 + t2), q);
                    want += (hi - lo) * g[i] / 2 * q[0];
                }
            row_case("alpha = %g", (double)alphas[k]);
            row_check(wg, (long double)zh[l], want * ref_M(l), 16 * (long double)EPS * ref_M(l), l);
        }
    }
    row_close(wc); row_close(wp); row_close(wg);
    F(sh_zonal_ggx)(9, 0, zh);
    for (l = 0; l < 9; l++) assert_true(fabs((double)zh[l] - (double)ref_M(l)) <= 2 * (double)EPS);
    assert_int_equal(F(sh_zonal_ggx)(9, (T)1.5, zh), SH_ERROR_OPTION);
    assert_int_equal(F(sh_zonal_ggx)(9, (T)NAN, zh), SH_ERROR_OPTION);
    assert_int_equal(F(sh_zonal_phong)(9, (T)-1, zh), SH_ERROR_OPTION);
}

static void F(refusals)(void **state)
{
    static T a[4 * MOST2], out[4 * MOST2];
    static const T normal[3] = { 0, 0, 1 };
    F(sh_rotation) r;
    T q[4] = { 0, 0, 0, 1 };

    (void)state;
    F(sh_rotation_quaternion)(q, &r);
    assert_int_equal(F(sh_rotate)(0, &r, 1, a, out), SH_ERROR_BANDS);
    assert_int_equal(F(sh_rotate)(17, &r, 1, a, out), SH_ERROR_BANDS);
    assert_int_equal(F(sh_rotate)(3, NULL, 1, a, out), SH_ERROR_NULL);
    assert_int_equal(F(sh_rotate)(3, &r, 1, NULL, out), SH_ERROR_NULL);
    assert_int_equal(F(sh_rotate)(3, &r, 0, NULL, NULL), SH_OK);
    assert_int_equal(F(sh_rotate)(3, &r, 2, a, a + 1), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_rotate)(3, &r, (size_t)-1, a, out), SH_ERROR_COUNT);
    assert_int_equal(F(sh_triple_product)(3, a, a, a + 5), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_triple_product)(17, a, a, out), SH_ERROR_BANDS);
    assert_int_equal(F(sh_triple_product)(3, a, NULL, out), SH_ERROR_NULL);
    assert_int_equal(F(sh_triple_product_bands)(3, a, 5, out, 5, a), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_cosine_product)(3, NULL, a, out), SH_ERROR_NULL);
    assert_int_equal(F(sh_cosine_product)(17, normal, a, out), SH_ERROR_BANDS);
    assert_int_equal(F(sh_cosine_product)(3, normal, a, a + 1), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_cosine_product)(3, out + 8, a, out), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_cosine_product_blocks)(3, 1, out + 71, a, out), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_cosine_product_local)(3, a, NULL), SH_ERROR_NULL);
    assert_int_equal(F(sh_mirror)(3, 3, 1, a, out), SH_ERROR_OPTION);
    assert_int_equal(F(sh_convolve)(3, NULL, a, out), SH_ERROR_NULL);
    assert_int_equal(F(sh_diffuse)(33, a, normal, out), SH_ERROR_BANDS);
    assert_int_equal(F(sh_diffuse)(2, a, normal, a + 3), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_diffuse_n)(2, NULL, 0, NULL, NULL), SH_OK);
    assert_int_equal(F(sh_rotate)(2, NULL, 0, NULL, NULL), SH_OK);
    assert_int_equal(F(sh_rotate_blocks)(2, NULL, 0, NULL, NULL), SH_OK);
    assert_int_equal(F(sh_scale_bands)(3, out + 8, a, out), SH_ERROR_OVERLAP);
    out[0] = out[1] = 0; out[2] = 1;
    assert_int_equal(F(sh_cosine_product_zonal)(3, 3, out, a, out), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_minimum)(3, a, out, out + 2), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_dering)(SH_HANN, 3, 1, a, out, out + 8), SH_ERROR_OVERLAP);
    {   /* a bad normal spoils only its own output, at every band count */
        T n3[9] = { 0, 0, 1, 0, 0, 0, 0, 1, 0 }, e[3];
        int bands;
        for (bands = 1; bands < 6; bands++) {
            e[0] = e[1] = e[2] = 7;
            assert_int_equal(F(sh_diffuse_n)(bands, a, 3, n3, e), SH_ERROR_DIRECTION);
            assert_true(e[0] != 7 && e[1] == 7 && e[2] != 7);
            assert_int_equal(F(sh_diffuse)(bands, a, n3 + 3, e + 1), SH_ERROR_DIRECTION);
            assert_true(e[1] == 7);
        }
    }
    {   /* NaN and Inf in coefficients go through, and stay in their band or order where the operation does */
        T c[25] = { 0 }, d[25];
        int i, bad = 0;
        c[6] = (T)NAN;
        assert_int_equal(F(sh_rotate)(5, &r, 1, c, d), SH_OK);
        for (i = 0; i < 25; i++) {
            const T v[1] = { d[i] };
            const int finite = F(shi_finite)(v, 1);
            bad += !finite;
            if (i < 4 || i > 8) assert_true(finite);
        }
        assert_true(bad > 0);
        assert_int_equal(F(sh_cosine_product)(5, normal, c, d), SH_OK);
        assert_false(F(shi_finite)(d, 25));
        assert_int_equal(F(sh_triple_product)(5, c, c, d), SH_OK);
        assert_false(F(shi_finite)(d, 25));
    }
}

#endif
