/* sh_gradient.h, the basis: values, gradients, Hessians, angles, reconstruct, project, identities, equal bits. */
#ifndef T
#include "sh_gradient.h"
#include "report.h"
#include "ref.h"

enum { MAX = SH_MAX_BANDS * SH_MAX_BANDS };
static const int plane_of[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
static ref_jet jets[REF_MAX];

/* The bounds without eps: Y, gradient times |v|, Hessian times |v|^2. */
static long double y_bound(int l) { return (4 + l * (l + 1) / 4.0L) * ref_M(l); }
static long double grad_bound(int l) { return (8 + l * (l + 1) / 4.0L) * ref_G(l); }
static long double hess_bound(int l) { return (16 + l * (l + 1) / 2.0L) * l * (l + 1) * ref_M(l); }

/* poles, quarter turns, and where the library goes from its own cosine and sine to those of the C library */
static const double special_angle[] = { 0, 3.14159265358979323846, 1e-20, 1e-7, 1.5707963267948966, 3.1415, -0.0,
    -3.14159265358979323846, -1.5707963267948966, 0.78539816339744831, 4.71238898038469, 5999.5, -6001, 999999, -1000001, 1e17 };
enum { SPECIALS = sizeof special_angle / sizeof *special_angle - FAST_MATH };  /* gcc then takes the last by x87 */

#define BOTH "test_gradient_basis.c"
#include "both.h"

int main(void)
{
    const struct CMUnitTest tests[] = {
        BOTH_TESTS(convention), BOTH_TESTS(values), BOTH_TESTS(gradient), BOTH_TESTS(hessian), BOTH_TESTS(angles),
        BOTH_TESTS(addition_theorem), BOTH_TESTS(orthonormality), BOTH_TESTS(euler_and_laplace),
        BOTH_TESTS(reconstruct), BOTH_TESTS(project), BOTH_TESTS(project_many), BOTH_TESTS(batches), BOTH_TESTS(optional_outputs),
    };
    return RUN_TESTS(tests);
}
#else

/* The sign, order and axes in one look: Y_1 is -y, +z, -x. */
static void F(convention)(void **state)
{
    static const T axis[3][3] = { { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 } };
    static const T sign[3] = { -1, 1, -1 };
    T y[4];
    int i, k;
    (void)state;
    for (i = 0; i < 3; i++) {
        assert_int_equal(F(sh_eval)(2, axis[i], y), SH_OK);
        assert_true(fabs((double)y[0] - 0.28209479177387814) < 2 * (double)EPS);
        for (k = 0; k < 3; k++)
            assert_true(fabs((double)(y[1 + k] - (k == i ? sign[i] * (T)0.4886025119029199 : 0))) < 2 * (double)EPS);
    }
}

static void F(random_unit)(T v[3], long double exact[3])
{
    double u[3];
    int k;
    ref_unit(u);
    for (k = 0; k < 3; k++) exact[k] = v[k] = (T)u[k];
}

/* Any length the gradient form takes; in double as far as in float and then some. */
static void F(random_vector)(T v[3], ref_jet p[3], long double *length)
{
    const double scale = ref_random() < 0.25 ? 1 : IS_F32 ? ref_log_between(2e-18, 5e17) : ref_log_between(1e-130, 1e130);
    double u[3];
    int k;
    ref_unit(u);
    *length = 0;
    for (k = 0; k < 3; k++) {
        v[k] = (T)(scale * u[k]);
        p[k] = ref_var(v[k], k);
        *length += (long double)v[k] * v[k];
    }
    *length = sqrtl(*length);
}

static void F(values)(void **state)
{
    row *w = row_open("sh_eval values", PRECISION);
    static T y[MAX];
    static long double want[REF_MAX];
    int bands, turn, i;
    (void)state;
    for (bands = 1; bands <= SH_MAX_BANDS; bands++)
        for (turn = 0; turn < effort(bands <= 12 ? 60 : 15); turn++) {
            T v[3];
            long double p[3];
            F(random_unit)(v, p);
            ref_values(bands, p, want);
            assert_int_equal(F(sh_eval)(bands, v, y), SH_OK);
            row_case("bands %d dir %.9g %.9g %.9g", bands, (double)v[0], (double)v[1], (double)v[2]);
            for (i = 0; i < bands * bands; i++) row_check(w, y[i], want[i], (long double)EPS * y_bound(ref_band(i)), i);
        }
    row_close(w);
}

static void F(gradient)(void **state)
{
    row *wy = row_open("sh_eval_grad values", PRECISION), *wg = row_open("sh_eval_grad gradient", PRECISION);
    static T y[MAX], g[3 * MAX];
    int bands, turn, i, k;
    (void)state;
    for (bands = 1; bands <= SH_MAX_BANDS; bands++)
        for (turn = 0; turn < effort(bands <= 12 ? 60 : 15); turn++) {
            const int n2 = bands * bands;
            T v[3];
            ref_jet p[3];
            long double length;
            F(random_vector)(v, p, &length);
            ref_basis(bands, p, jets);
            assert_int_equal(F(sh_eval_grad)(bands, v, y, g), SH_OK);
            row_case("bands %d v %.9g %.9g %.9g", bands, (double)v[0], (double)v[1], (double)v[2]);
            for (i = 0; i < n2; i++) {
                const int l = ref_band(i);
                row_check(wy, y[i], jets[i].v, (long double)EPS * y_bound(l), i);
                for (k = 0; k < 3; k++)
                    row_check(wg, g[k * n2 + i], jets[i].g[k], (long double)EPS * grad_bound(l) / length, i);
            }
        }
    row_close(wy);
    row_close(wg);
}

static void F(hessian)(void **state)
{
    row *wy = row_open("sh_eval_hessian values", PRECISION), *wg = row_open("sh_eval_hessian gradient", PRECISION);
    row *wh = row_open("sh_eval_hessian Hessian", PRECISION);
    static T y[MAX], g[3 * MAX], h[6 * MAX];
    int bands, turn, i, k;
    (void)state;
    for (bands = 1; bands <= SH_MAX_BANDS; bands++)
        for (turn = 0; turn < effort(bands <= 12 ? 60 : 15); turn++) {
            const int n2 = bands * bands;
            T v[3];
            ref_jet p[3];
            long double length;
            F(random_vector)(v, p, &length);
            ref_basis(bands, p, jets);
            assert_int_equal(F(sh_eval_hessian)(bands, v, y, g, h), SH_OK);
            row_case("bands %d v %.9g %.9g %.9g", bands, (double)v[0], (double)v[1], (double)v[2]);
            for (i = 0; i < n2; i++) {
                const int l = ref_band(i);
                row_check(wy, y[i], jets[i].v, (long double)EPS * y_bound(l), i);
                for (k = 0; k < 3; k++)
                    row_check(wg, g[k * n2 + i], jets[i].g[k], (long double)EPS * grad_bound(l) / length, i);
                for (k = 0; k < 6; k++) {
                    /* beyond 1e18 in length the Hessian of a float leaves float's range: below FLT_MIN it is 0 */
                    const long double bound = (long double)EPS * hess_bound(l) / length / length;
                    const long double tiny = IS_F32 ? (long double)FLT_MIN : DBL_MIN;
                    row_check(wh, h[k * n2 + i], jets[i].h[k], bound > tiny ? bound : tiny, i);
                }
            }
        }
    row_close(wy);
    row_close(wg);
    row_close(wh);
}

static void F(angles)(void **state)
{
    row *wy = row_open("sh_eval_angles values", PRECISION), *wt = row_open("sh_eval_angles d/dtheta", PRECISION);
    row *wp = row_open("sh_eval_angles d/dphi", PRECISION);
    static T y[MAX], dt[MAX], dp[MAX];
    int bands, turn, i;
    (void)state;
    for (bands = 1; bands <= SH_MAX_BANDS; bands++)
        for (turn = 0; turn < effort(bands <= 12 ? 60 : 15); turn++) {
            const T theta = (T)(turn < SPECIALS ? special_angle[turn] : ref_between(-1, 4.5));
            const T phi = (T)(turn % 7 == 0   ? special_angle[turn / 7 % SPECIALS]
                              : turn % 7 == 1 ? ref_between(-500, 500)
                              : turn % 7 == 2 ? ref_between(-7000, 7000)
                                              : ref_between(-3.15, 6.3));
            const ref_jet t = ref_var(theta, 0), p = ref_var(phi, 1);
            const ref_jet v[3] = { ref_mul(ref_sin(t), ref_cos(p)), ref_mul(ref_sin(t), ref_sin(p)), ref_cos(t) };
            ref_basis(bands, v, jets);
            assert_int_equal(F(sh_eval_angles)(bands, theta, phi, y, dt, dp), SH_OK);
            row_case("bands %d theta %.9g phi %.9g", bands, (double)theta, (double)phi);
            for (i = 0; i < bands * bands; i++) {
                const int l = ref_band(i);
                row_check(wy, y[i], jets[i].v, (long double)EPS * y_bound(l), i);
                row_check(wt, dt[i], jets[i].g[0], (long double)EPS * grad_bound(l), i);
                row_check(wp, dp[i], jets[i].g[1], (long double)EPS * abs(i - l * (l + 1)) * y_bound(l), i);
            }
        }
    row_close(wy);
    row_close(wt);
    row_close(wp);
}

/* Sum over m of Y_lm(a) Y_lm(b) = (2l+1)/4pi P_l(a.b); at a = b it is M_l squared. */
static void F(addition_theorem)(void **state)
{
    row *w = row_open("addition theorem", PRECISION);
    static T ya[MAX], yb[MAX];
    int turn, l, m, k;
    (void)state;
    for (turn = 0; turn < effort(200); turn++) {
        T a[3], b[3];
        long double pa[3], pb[3], dot = 0, na = 0, nb = 0;
        F(random_unit)(a, pa);
        if (turn & 1) F(random_unit)(b, pb); else { memcpy(b, a, sizeof b); memcpy(pb, pa, sizeof pb); }
        assert_int_equal(F(sh_eval)(SH_MAX_BANDS, a, ya), SH_OK);
        assert_int_equal(F(sh_eval)(SH_MAX_BANDS, b, yb), SH_OK);
        for (k = 0; k < 3; k++) { dot += pa[k] * pb[k]; na += pa[k] * pa[k]; nb += pb[k] * pb[k]; }
        dot /= sqrtl(na * nb);
        if (dot > 1) dot = 1;
        row_case("a %.9g %.9g %.9g b %.9g %.9g %.9g", (double)a[0], (double)a[1], (double)a[2],
                 (double)b[0], (double)b[1], (double)b[2]);
        for (l = 0; l < SH_MAX_BANDS; l++) {
            long double sum = 0, q[3];
            for (m = -l; m <= l; m++) sum += (long double)ya[l * (l + 1) + m] * (long double)yb[l * (l + 1) + m];
            ref_legendre(l, 0, dot, q);
            /* the errors of the two factors, each component within y_bound: Cauchy-Schwarz over 2l+1 of them */
            row_check(w, sum, ref_M(l) * ref_M(l) * q[0],
                      2 * (long double)EPS * y_bound(l) * ref_M(l) * sqrtl(2 * l + 1), l);
        }
    }
    row_close(w);
}

/* Gauss-Legendre in z times the trapezoidal rule in phi integrates products of 32 bands exactly. */
static void F(orthonormality)(void **state)
{
    enum { NZ = SH_MAX_BANDS, NP = 2 * SH_MAX_BANDS };
    row *w = row_open("orthonormality by quadrature", PRECISION);
    static T y[MAX];
    static long double gram[MAX][24];
    static int probe[24];
    long double z[NZ], weight[NZ];
    int a, b, i, j;
    (void)state;
    ref_gauss(NZ, z, weight);
    for (j = 0; j < 24; j++) probe[j] = j < 16 ? j : (int)ref_between(16, MAX);
    memset(gram, 0, sizeof gram);
    for (a = 0; a < NZ; a++)
        for (b = 0; b < NP; b++) {
            const long double s = sqrtl(1 - z[a] * z[a]), phi = 2 * REF_PI * (b + 0.25L) / NP;
            const T v[3] = { (T)(s * cosl(phi)), (T)(s * sinl(phi)), (T)z[a] };
            const long double area = weight[a] * 2 * REF_PI / NP;
            assert_int_equal(F(sh_eval)(SH_MAX_BANDS, v, y), SH_OK);
            for (i = 0; i < MAX; i++)
                for (j = 0; j < 24; j++) gram[i][j] += area * y[i] * y[probe[j]];
        }
    for (i = 0; i < MAX; i++)
        for (j = 0; j < 24; j++) {
            const int li = ref_band(i), lj = ref_band(probe[j]);
            row_case("with %d", probe[j]);
            row_check(w, gram[i][j], i == probe[j], (long double)EPS * 3.5449L * (y_bound(li) + y_bound(lj)), i);
        }
    row_close(w);
}

/* Y(v/|v|) has degree 0: v.grad = 0, H v = -grad; and the trace of H is -l(l+1) Y / |v|^2. */
static void F(euler_and_laplace)(void **state)
{
    row *we = row_open("v . gradient = 0", PRECISION), *wh = row_open("Hessian v = -gradient", PRECISION);
    row *wl = row_open("trace of the Hessian = -l(l+1) Y / v.v", PRECISION);
    static T y[MAX], g[3 * MAX], h[6 * MAX];
    int turn, i, j, k;
    (void)state;
    for (turn = 0; turn < effort(300); turn++) {
        const int n2 = MAX;
        T v[3];
        ref_jet p[3];
        long double length;
        F(random_vector)(v, p, &length);
        if (length > 1e15L || length < 1e-15L) continue;
        assert_int_equal(F(sh_eval_hessian)(SH_MAX_BANDS, v, y, g, h), SH_OK);
        row_case("v %.9g %.9g %.9g", (double)v[0], (double)v[1], (double)v[2]);
        for (i = 0; i < n2; i++) {
            const int l = ref_band(i);
            long double euler = 0, trace = 0;
            for (k = 0; k < 3; k++) {
                long double hv = 0;
                for (j = 0; j < 3; j++) hv += (long double)h[plane_of[k][j] * n2 + i] * v[j];
                row_check(wh, hv, -(long double)g[k * n2 + i],
                          (long double)EPS * (2 * hess_bound(l) + grad_bound(l)) / length, i);
                euler += (long double)v[k] * g[k * n2 + i];
                trace += h[plane_of[k][k] * n2 + i];
            }
            row_check(we, euler, 0, 2 * (long double)EPS * grad_bound(l), i);
            row_check(wl, trace * length * length, -(long double)l * (l + 1) * y[i],
                      (long double)EPS * (3 * hess_bound(l) + l * (l + 1) * y_bound(l)), i);
        }
    }
    row_close(we);
    row_close(wh);
    row_close(wl);
}

/* sh_reconstruct against the sum over the reference basis: all coefficients, those of one order, and one of the last band;
 * directions of any length; one and many alike. */
static void F(reconstruct)(void **state)
{
    row *wv = row_open("sh_reconstruct value", PRECISION), *wg = row_open("sh_reconstruct gradient", PRECISION);
    static T c[MAX], values[40], grads[120], dirs[120];
    ref_jet p[3];
    int bands, turn, i, k;
    (void)state;
    for (bands = 1; bands <= SH_MAX_BANDS; bands++)
        for (turn = 0; turn < effort(12); turn++) {
            const size_t count = (size_t)(turn % 12 * 3 + 1);
            const int order = (int)lroundl(ref_between(-(bands - 1), bands - 1));
            size_t j;
            for (i = 0; i < bands * bands; i++) {
                const int l = ref_band(i), m = i - l * (l + 1);
                c[i] = turn % 3 == 0 || (m == order && (turn % 3 == 1 || l == bands - 1)) ? (T)ref_between(-1, 1) : 0;
            }
            for (j = 0; j < count; j++) {
                long double unused;
                F(random_vector)(dirs + 3 * j, p, &unused);
            }
            assert_int_equal(F(sh_reconstruct_n)(bands, c, count, dirs, values, grads), SH_OK);
            for (j = 0; j < count; j++) {
                T one, grad[3];
                long double value = 0, g[3] = { 0, 0, 0 }, c2 = 0, m2 = 0, d2 = 0, limit;
                for (k = 0; k < 3; k++) {
                    p[k] = ref_var(dirs[3 * j + (size_t)k], k);
                    d2 += p[k].v * p[k].v;
                }
                ref_basis(bands, p, jets);
                for (i = 0; i < bands * bands; i++) {
                    const int l = ref_band(i);
                    value += c[i] * jets[i].v;
                    for (k = 0; k < 3; k++) g[k] += c[i] * jets[i].g[k];
                    c2 += (long double)c[i] * c[i];
                    if (i == l * (l + 1)) m2 += ref_M(l) * ref_M(l);
                }
                limit = (8 + bands * bands / 4.0L) * (long double)EPS * sqrtl(m2 * c2);
                row_case("bands %d dir %.9g %.9g %.9g", bands, (double)dirs[3 * j], (double)dirs[3 * j + 1],
                         (double)dirs[3 * j + 2]);
                row_check(wv, values[j], value, limit, (int)j);
                for (k = 0; k < 3; k++)
                    row_check(wg, grads[3 * j + (size_t)k], g[k], bands * limit / sqrtl(d2), k);
                assert_int_equal(F(sh_reconstruct)(bands, c, dirs + 3 * j, &one, grad), SH_OK);
                assert_memory_equal(&one, values + j, sizeof one);
                assert_memory_equal(grad, grads + 3 * j, sizeof grad);
            }
        }
    row_close(wv);
    row_close(wg);
    for (bands = 1; bands <= SH_MAX_BANDS; bands++) {       /* coefficients near the largest allowed: the same but for the power */
        const int power = IS_F32 ? 88 : 985;
        const T dir[3] = { (T)ref_between(-1, 1), (T)ref_between(-1, 1), (T)ref_between(-1, 1) };
        T one, large;
        for (i = 0; i < bands * bands; i++) c[i] = (T)ref_between(0.5, 1);
        assert_int_equal(F(sh_reconstruct)(bands, c, dir, &one, NULL), SH_OK);
        for (i = 0; i < bands * bands; i++) c[i] = (T)ldexp((double)c[i], power);
        assert_int_equal(F(sh_reconstruct)(bands, c, dir, &large, NULL), SH_OK);
        assert_true(large == (T)ldexp((double)one, power));
    }
}

/* The sum over samples. */
static void F(project)(void **state)
{
    enum { MANY = 1000 };
    row *w = row_open("sh_project_n", PRECISION);
    static T dirs[3 * MANY], weights[MANY], c[MAX];
    static long double want[MAX], y[REF_MAX];
    long double total;
    static const size_t counts[] = { 0, 1, 2, 3, 7, 8, 9, 31, 37, MANY };
    size_t k, j;
    int i, bands;
    (void)state;
    for (j = 0; j < MANY; j++) {
        long double unused[3];
        F(random_unit)(dirs + 3 * j, unused);
        weights[j] = (T)ref_between(-1, 1);
    }
    for (bands = 1; bands <= SH_MAX_BANDS; bands += bands < 12 ? 1 : 4)
        for (k = 0; k < sizeof counts / sizeof *counts; k++) {
            if (counts[k] == MANY && bands > 9) continue;
            memset(want, 0, sizeof want);
            total = 0;
            for (j = 0; j < counts[k]; j++) {
                const long double p[3] = { dirs[3 * j], dirs[3 * j + 1], dirs[3 * j + 2] };
                ref_values(bands, p, y);
                for (i = 0; i < bands * bands; i++) want[i] += weights[j] * y[i];
                total += fabsl((long double)weights[j]);
            }
            for (i = 0; i < bands * bands; i++) c[i] = (T)NAN;
            assert_int_equal(F(sh_project_n)(bands, counts[k], dirs, weights, c), SH_OK);
            row_case("bands %d count %d", bands, (int)counts[k]);
            for (i = 0; i < bands * bands; i++) {
                const int l = ref_band(i);
                row_check(w, c[i], want[i], (8 + l * (l + 1) / 4.0L + (long double)counts[k] / 64) * (long double)EPS
                          * ref_M(l) * total, i);
            }
        }
    row_close(w);
}

/* A cube map's worth of samples of one sign: running sums in T would drift with their number. */
static void F(project_many)(void **state)
{
    enum { MANY = 300000, BANDS = 3 };
    row *wp = row_open("sh_project_n, 300000 samples", PRECISION), *wf = row_open("sh_light_field, 300000 samples", PRECISION);
    static T dirs[3 * MANY], weights[MANY], one[MANY];
    T c[BANDS * BANDS], f[BANDS * BANDS];
    long double sum[BANDS * BANDS] = { 0 }, y[BANDS * BANDS], total = 0;
    int i, j;
    (void)state;
    for (j = 0; j < MANY; j++) {
        long double p[3];
        F(random_unit)(dirs + 3 * j, p);
        weights[j] = (T)(4 * 3.14159265358979 / MANY);
        one[j] = 1;
        ref_values(BANDS, p, y);
        for (i = 0; i < BANDS * BANDS; i++) sum[i] += weights[j] * y[i];
        total += (long double)weights[j];
    }
    assert_int_equal(F(sh_project_n)(BANDS, MANY, dirs, weights, c), SH_OK);
    assert_int_equal(F(sh_light_field)(BANDS, MANY, dirs, weights, one, NULL, NULL, f, NULL), SH_OK);
    for (i = 0; i < BANDS * BANDS; i++) {
        const int l = ref_band(i);
        row_check(wp, c[i], sum[i], (8 + l * (l + 1) / 4.0L + 80) * (long double)EPS * ref_M(l) * total, i);
        row_check(wf, f[i], sum[i], (8 + l * (l + 1) / 4.0L + (IS_F32 ? 0 : MANY / 2)) * (long double)EPS * ref_M(l) * total, i);
    }
    row_close(wp);
    row_close(wf);
}

/* Every batch gives the bits of the single call, whatever the count and the place; nothing is written beyond. */
static void F(batches)(void **state)
{
    enum { COUNT = 37, BLOCKS = (COUNT + SH_BLOCK - 1) / SH_BLOCK };
    static const int some[] = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 16, 17, 31, 32 };
    static T dirs[3 * COUNT], blocked[BLOCKS * 3 * SH_BLOCK], t[COUNT], p[COUNT];
    static T y1[MAX + 1], g1[3 * MAX + 1], h1[6 * MAX + 1];
    static T y[COUNT * MAX + 1], g[3 * COUNT * MAX + 1], h[6 * COUNT * MAX + 1];
    static T yb[BLOCKS * SH_BLOCK * MAX + 1], gb[3 * BLOCKS * SH_BLOCK * MAX + 1], hb[6 * BLOCKS * SH_BLOCK * MAX + 1];
    const T guard = (T)12345;
    size_t turn, c, count, lane, i;
    int k;
    (void)state;
    if (FAST_MATH) skip();
    for (c = 0; c < COUNT; c++) {
        ref_jet unused[3];
        long double length;
        do F(random_vector)(dirs + 3 * c, unused, &length); while (length < 1e-9L || length > 1e9L);
        t[c] = (T)(c % 2 ? special_angle[c / 2 % SPECIALS] : ref_between(-7000, 7000));
        p[c] = (T)(c % 3 ? ref_between(0, 6.2) : special_angle[(c + 7) % SPECIALS]);
    }
    for (c = 0; c < 26; c++) {                                           /* axes and diagonals, and zeros of both signs */
        const int digit[3] = { (int)(c + (c > 12)) % 3 - 1, (int)(c + (c > 12)) / 3 % 3 - 1, (int)(c + (c > 12)) / 9 - 1 };
        for (k = 0; k < 3; k++) dirs[3 * c + (size_t)k] = digit[k] ? (T)digit[k] : c % 2 ? (T)-0.0 : 0;
    }
    for (c = 0; c < BLOCKS * SH_BLOCK; c++)
        for (k = 0; k < 3; k++)
            blocked[(c / SH_BLOCK * 3 + (size_t)k) * SH_BLOCK + c % SH_BLOCK] = dirs[3 * (c % COUNT) + (size_t)k];
    for (turn = 0; turn < sizeof some / sizeof *some; turn++) {
        const int bands = some[turn];
        const size_t n2 = (size_t)(bands * bands);
        for (c = 0; c < COUNT; c++) {                                    /* single calls stay within their outputs too */
            y1[n2] = g1[3 * n2] = h1[6 * n2] = guard;
            assert_int_equal(F(sh_eval)(bands, dirs + 3 * c, y1), SH_OK);
            assert_int_equal(F(sh_eval_grad)(bands, dirs + 3 * c, y1, g1), SH_OK);
            assert_int_equal(F(sh_eval_hessian)(bands, dirs + 3 * c, y1, g1, h1), SH_OK);
            assert_true(y1[n2] == guard && g1[3 * n2] == guard && h1[6 * n2] == guard);
        }
        for (count = 0; count <= COUNT; count += count < 10 ? 1 : 9) {
            y[count * n2] = g[3 * count * n2] = h[6 * count * n2] = guard;
            assert_int_equal(F(sh_eval_hessian_n)(bands, count, dirs, y, g, h), SH_OK);
            for (c = 0; c < count; c++) {
                assert_int_equal(F(sh_eval_hessian)(bands, dirs + 3 * c, y1, g1, h1), SH_OK);
                assert_memory_equal(y + c * n2, y1, n2 * sizeof(T));
                assert_memory_equal(g + c * 3 * n2, g1, 3 * n2 * sizeof(T));
                assert_memory_equal(h + c * 6 * n2, h1, 6 * n2 * sizeof(T));
            }
            assert_int_equal(F(sh_eval_grad_n)(bands, count, dirs, y, g), SH_OK);
            for (c = 0; c < count; c++) {
                assert_int_equal(F(sh_eval_grad)(bands, dirs + 3 * c, y1, g1), SH_OK);
                assert_memory_equal(y + c * n2, y1, n2 * sizeof(T));
                assert_memory_equal(g + c * 3 * n2, g1, 3 * n2 * sizeof(T));
            }
            assert_int_equal(F(sh_eval_n)(bands, count, dirs, y), SH_OK);
            for (c = 0; c < count; c++) {
                assert_int_equal(F(sh_eval)(bands, dirs + 3 * c, y1), SH_OK);
                assert_memory_equal(y + c * n2, y1, n2 * sizeof(T));
            }
            assert_true(y[count * n2] == guard && g[3 * count * n2] == guard && h[6 * count * n2] == guard);
            g[count * n2] = h[count * n2] = guard;
            assert_int_equal(F(sh_eval_angles_n)(bands, count, t, p, y, g, h), SH_OK);
            for (c = 0; c < count; c++) {
                assert_int_equal(F(sh_eval_angles)(bands, t[c], p[c], y1, g1, h1), SH_OK);
                assert_memory_equal(y + c * n2, y1, n2 * sizeof(T));
                assert_memory_equal(g + c * n2, g1, n2 * sizeof(T));
                assert_memory_equal(h + c * n2, h1, n2 * sizeof(T));
            }
            assert_true(y[count * n2] == guard && g[count * n2] == guard && h[count * n2] == guard);
        }
        for (count = 0; count <= BLOCKS; count++) {
            const size_t n = count * SH_BLOCK * n2;
            yb[n] = gb[3 * n] = hb[6 * n] = guard;
            assert_int_equal(F(sh_eval_hessian_blocks)(bands, count, blocked, yb, gb, hb), SH_OK);
            for (lane = 0; lane < count * SH_BLOCK; lane++) {
                const size_t b = lane / SH_BLOCK, s = lane % SH_BLOCK;
                assert_int_equal(F(sh_eval_hessian)(bands, dirs + 3 * (lane % COUNT), y1, g1, h1), SH_OK);
                for (i = 0; i < n2; i++) assert_memory_equal(yb + (b * n2 + i) * SH_BLOCK + s, y1 + i, sizeof(T));
                for (i = 0; i < 3 * n2; i++) assert_memory_equal(gb + (b * 3 * n2 + i) * SH_BLOCK + s, g1 + i, sizeof(T));
                for (i = 0; i < 6 * n2; i++) assert_memory_equal(hb + (b * 6 * n2 + i) * SH_BLOCK + s, h1 + i, sizeof(T));
            }
            assert_int_equal(F(sh_eval_grad_blocks)(bands, count, blocked, yb, gb), SH_OK);
            for (lane = 0; lane < count * SH_BLOCK; lane++) {
                const size_t b = lane / SH_BLOCK, s = lane % SH_BLOCK;
                assert_int_equal(F(sh_eval_grad)(bands, dirs + 3 * (lane % COUNT), y1, g1), SH_OK);
                for (i = 0; i < n2; i++) assert_memory_equal(yb + (b * n2 + i) * SH_BLOCK + s, y1 + i, sizeof(T));
                for (i = 0; i < 3 * n2; i++) assert_memory_equal(gb + (b * 3 * n2 + i) * SH_BLOCK + s, g1 + i, sizeof(T));
            }
            assert_int_equal(F(sh_eval_blocks)(bands, count, blocked, yb), SH_OK);
            for (lane = 0; lane < count * SH_BLOCK; lane++) {
                const size_t b = lane / SH_BLOCK, s = lane % SH_BLOCK;
                assert_int_equal(F(sh_eval)(bands, dirs + 3 * (lane % COUNT), y1), SH_OK);
                for (i = 0; i < n2; i++) assert_memory_equal(yb + (b * n2 + i) * SH_BLOCK + s, y1 + i, sizeof(T));
            }
            assert_true(yb[n] == guard && gb[3 * n] == guard && hb[6 * n] == guard);
        }
    }
}

/* An output left out changes no bit of the others. */
static void F(optional_outputs)(void **state)
{
    static T y[MAX], g[3 * MAX], h[6 * MAX], y1[MAX], g1[3 * MAX], h1[6 * MAX];
    const T v[3] = { (T)0.25, (T)-1.5, (T)0.75 };
    const int bands = 11;
    const size_t n2 = 121 * sizeof(T);
    (void)state;
    if (FAST_MATH) skip();
    assert_int_equal(F(sh_eval_hessian)(bands, v, y, g, h), SH_OK);
    assert_int_equal(F(sh_eval_hessian)(bands, v, NULL, NULL, h1), SH_OK);
    assert_memory_equal(h, h1, 6 * n2);
    assert_int_equal(F(sh_eval_hessian)(bands, v, y1, NULL, h1), SH_OK);
    assert_memory_equal(y, y1, n2);
    assert_int_equal(F(sh_eval_hessian)(bands, v, NULL, g1, NULL), SH_OK);
    assert_memory_equal(g, g1, 3 * n2);
    assert_int_equal(F(sh_eval_grad)(bands, v, y, g), SH_OK);
    assert_int_equal(F(sh_eval_grad)(bands, v, NULL, g1), SH_OK);
    assert_memory_equal(g, g1, 3 * n2);
    assert_int_equal(F(sh_eval_grad)(bands, v, y1, NULL), SH_OK);
    assert_memory_equal(y, y1, n2);
    assert_int_equal(F(sh_eval_angles)(bands, v[0], v[1], y, g, h), SH_OK);
    assert_int_equal(F(sh_eval_angles)(bands, v[0], v[1], NULL, g1, NULL), SH_OK);
    assert_memory_equal(g, g1, n2);
    assert_int_equal(F(sh_eval_angles)(bands, v[0], v[1], NULL, NULL, h1), SH_OK);
    assert_memory_equal(h, h1, n2);
    assert_int_equal(F(sh_eval_angles)(bands, v[0], v[1], y1, NULL, NULL), SH_OK);
    assert_memory_equal(y, y1, n2);
}
#endif
