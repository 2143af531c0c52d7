#include "ref.h"
#include <assert.h>
#include <math.h>
#include <string.h>

/* ---- jets ---- */
static const int HI[6] = { 0, 0, 0, 1, 1, 2 }, HJ[6] = { 0, 1, 2, 1, 2, 2 };

ref_jet ref_const(long double value)
{
    ref_jet r;
    memset(&r, 0, sizeof r);
    r.v = value;
    return r;
}

ref_jet ref_var(long double value, int variable)
{
    ref_jet r = ref_const(value);
    r.g[variable] = 1;
    return r;
}

static ref_jet combine(long double s, ref_jet a, long double t, ref_jet b)
{
    int k;
    a.v = s * a.v + t * b.v;
    for (k = 0; k < 3; k++) a.g[k] = s * a.g[k] + t * b.g[k];
    for (k = 0; k < 6; k++) a.h[k] = s * a.h[k] + t * b.h[k];
    return a;
}

ref_jet ref_add(ref_jet a, ref_jet b) { return combine(1, a, 1, b); }
ref_jet ref_sub(ref_jet a, ref_jet b) { return combine(1, a, -1, b); }
ref_jet ref_scale(long double s, ref_jet a) { return combine(s, a, 0, a); }

ref_jet ref_mul(ref_jet a, ref_jet b)
{
    ref_jet r;
    int k;
    r.v = a.v * b.v;
    for (k = 0; k < 3; k++) r.g[k] = a.v * b.g[k] + a.g[k] * b.v;
    for (k = 0; k < 6; k++)
        r.h[k] = a.v * b.h[k] + a.h[k] * b.v + a.g[HI[k]] * b.g[HJ[k]] + a.g[HJ[k]] * b.g[HI[k]];
    return r;
}

ref_jet ref_chain(ref_jet a, long double f, long double f1, long double f2)
{
    ref_jet r;
    int k;
    r.v = f;
    for (k = 0; k < 3; k++) r.g[k] = f1 * a.g[k];
    for (k = 0; k < 6; k++) r.h[k] = f1 * a.h[k] + f2 * a.g[HI[k]] * a.g[HJ[k]];
    return r;
}

ref_jet ref_div(ref_jet a, ref_jet b)
{
    const long double i = 1 / b.v;
    return ref_mul(a, ref_chain(b, i, -i * i, 2 * i * i * i));
}

ref_jet ref_sqrt(ref_jet a)
{
    const long double s = sqrtl(a.v);
    return ref_chain(a, s, 1 / (2 * s), -1 / (4 * s * a.v));
}

ref_jet ref_cos(ref_jet a) { return ref_chain(a, cosl(a.v), -sinl(a.v), -cosl(a.v)); }
ref_jet ref_sin(ref_jet a) { return ref_chain(a, sinl(a.v), cosl(a.v), -sinl(a.v)); }

/* ---- pairs of doubles: 32 digits, because the explicit sum below cancels 12 of them at l = 33 ---- */
typedef struct { double hi, lo; } pair;

static pair pair_sum(double a, double b)
{
    pair r;
    volatile double s = a + b, t = s - a;
    r.hi = s;
    r.lo = (a - (s - t)) + (b - t);
    return r;
}

static pair pair_add(pair a, pair b)
{
    pair s = pair_sum(a.hi, b.hi), t = pair_sum(a.lo, b.lo);
    s = pair_sum(s.hi, s.lo + t.hi);
    return pair_sum(s.hi, s.lo + t.lo);
}

static pair pair_product(double a, double b)            /* Dekker's split: no fma asked for */
{
    const double ca = 134217729.0 * a, cb = 134217729.0 * b;
    const double ah = ca - (ca - a), al = a - ah, bh = cb - (cb - b), bl = b - bh;
    pair r;
    r.hi = a * b;
    r.lo = ((ah * bh - r.hi) + ah * bl + al * bh) + al * bl;
    return r;
}

static pair pair_mul(pair a, pair b)
{
    pair r = pair_product(a.hi, b.hi);
    return pair_sum(r.hi, r.lo + (a.hi * b.lo + a.lo * b.hi));
}

static pair pair_of(long double x)
{
    pair r;
    r.hi = (double)x;
    r.lo = (double)(x - (long double)r.hi);
    return r;
}

static pair pair_div_integer(pair a, int n)
{
    const double q = a.hi / n;
    const pair p = pair_product(q, n);
    return pair_sum(q, (((a.hi - p.hi) - p.lo) + a.lo) / n);
}

static pair sum_coefficient[REF_MAX_BANDS][REF_MAX_BANDS][REF_MAX_BANDS / 2 + 1];

/* (-1)^k (2l-2k)! / (2^l k! (l-k)! (l-2k-m)!), the coefficient of z^(l-2k-m) in d^m P_l / dz^m */
static void fill_coefficients(void)
{
    static int done;
    int l, m, k, i;
    if (done) return;
    for (l = 0; l < REF_MAX_BANDS; l++)
        for (m = 0; m <= l; m++)
            for (k = 0; 2 * k + m <= l; k++) {
                pair c = pair_of(k & 1 ? -1 : 1);
                for (i = l - 2 * k - m + 1; i <= 2 * l - 2 * k; i++) c = pair_mul(c, pair_of(i));
                for (i = 1; i <= k; i++) c = pair_div_integer(c, i);
                for (i = 1; i <= l - k; i++) c = pair_div_integer(c, i);
                for (i = 1; i <= l; i++) c = pair_div_integer(c, 2);
                sum_coefficient[l][m][k] = c;
            }
    done = 1;
}

static void powers(long double z, pair p[REF_MAX_BANDS])
{
    int i;
    p[0] = pair_of(1);
    for (i = 1; i < REF_MAX_BANDS; i++) p[i] = pair_mul(p[i - 1], pair_of(z));
}

static void legendre(int l, int m, const pair z[REF_MAX_BANDS], long double q[3])
{
    int k, d, i;
    for (d = 0; d < 3; d++) {
        pair s = pair_of(0);
        for (k = 0; 2 * k + m + d <= l; k++) {
            const int e = l - 2 * k - m;
            pair t = sum_coefficient[l][m][k];
            for (i = 0; i < d; i++) t = pair_mul(t, pair_of(e - i));
            s = pair_add(s, pair_mul(t, z[e - d]));
        }
        q[d] = (long double)s.hi + (long double)s.lo;
    }
}

void ref_legendre(int l, int m, long double z, long double q[3])
{
    pair p[REF_MAX_BANDS];
    fill_coefficients();
    powers(z, p);
    legendre(l, m, p, q);
}

/* ---- basis ---- */
long double ref_M(int l) { return sqrtl((2 * l + 1) / (4 * REF_PI)); }
long double ref_G(int l) { return sqrtl((long double)(l * (l + 1)) * (2 * l + 1) / (8 * REF_PI)); }
int ref_band(int i)
{
    int l = 0;
    while ((l + 1) * (l + 1) <= i) l++;
    return l;
}

static long double normalisation(int l, int m)       /* m >= 0, Condon-Shortley sign included */
{
    long double ratio = 1;
    int k;
    for (k = l - m + 1; k <= l + m; k++) ratio *= k;
    return (m & 1 ? -1 : 1) * sqrtl((m ? 2 : 1) * (2 * l + 1) / (4 * REF_PI * ratio));
}

void ref_basis(int bands, const ref_jet v[3], ref_jet *y)
{
    static long double scale[REF_MAX_BANDS][REF_MAX_BANDS];
    ref_jet u[3], r2 = ref_const(0), re = ref_const(1), im = ref_const(0);
    pair z[REF_MAX_BANDS];
    int l, m, k;

    assert(bands <= REF_MAX_BANDS);
    if (scale[0][0] == 0)
        for (l = 0; l < REF_MAX_BANDS; l++)
            for (m = 0; m <= l; m++) scale[l][m] = normalisation(l, m);
    fill_coefficients();
    for (k = 0; k < 3; k++) r2 = ref_add(r2, ref_mul(v[k], v[k]));
    for (k = 0; k < 3; k++) u[k] = ref_div(v[k], ref_sqrt(r2));
    powers(u[2].v, z);
    for (m = 0; m < bands; m++) {
        for (l = m; l < bands; l++) {
            long double q[3];
            ref_jet a;
            legendre(l, m, z, q);
            a = ref_scale(scale[l][m], ref_chain(u[2], q[0], q[1], q[2]));
            y[l * (l + 1) + m] = ref_mul(a, re);
            if (m) y[l * (l + 1) - m] = ref_mul(a, im);
        }
        {   /* (x + iy)^(m+1) */
            const ref_jet next = ref_sub(ref_mul(re, u[0]), ref_mul(im, u[1]));
            im = ref_add(ref_mul(re, u[1]), ref_mul(im, u[0]));
            re = next;
        }
    }
}

void ref_values(int bands, const long double v[3], long double *y)
{
    static ref_jet jets[REF_MAX];
    const ref_jet p[3] = { ref_const(v[0]), ref_const(v[1]), ref_const(v[2]) };
    int i;
    ref_basis(bands, p, jets);
    for (i = 0; i < bands * bands; i++) y[i] = jets[i].v;
}

/* ---- quadrature ---- */
void ref_gauss(int n, long double *x, long double *w)
{
    int i, k, turn;
    for (i = 0; i < n; i++) {
        long double t = cosl(REF_PI * (i + 0.75L) / (n + 0.5L)), p = 0, d = 0;
        for (turn = 0; turn < 100; turn++) {
            long double a = 1, b = 0, step;
            for (k = 0; k < n; k++) {                  /* Bonnet; d from (1-t^2) P' = n (P_{n-1} - t P_n) */
                const long double c = ((2 * k + 1) * t * a - k * b) / (k + 1);
                b = a;
                a = c;
            }
            p = a;
            d = n * (b - t * a) / (1 - t * t);
            step = p / d;
            t -= step;
            if (fabsl(step) < 1e-18L) break;
        }
        x[i] = t;
        w[i] = 2 / ((1 - t * t) * d * d);
    }
}

/* ---- lights ---- */
/* Funk-Hecke: the integral of Y_i over the cap is 2 pi Y_i(u) times the integral of P_l over [cosine, 1], which
 * Gauss-Legendre takes exactly. */
void ref_cap(int bands, const ref_jet u[3], ref_jet one_minus_cosine, ref_jet *c)
{
    enum { NODES = REF_MAX_BANDS / 2 + 1 };
    static long double x[NODES], w[NODES];
    int i, l, m;

    if (w[0] == 0) ref_gauss(NODES, x, w);
    ref_basis(bands, u, c);
    for (l = 0; l < bands; l++) {
        ref_jet sum = ref_const(0);
        for (i = 0; i < NODES; i++) {
            const ref_jet t = ref_sub(ref_const(1), ref_scale((1 + x[i]) / 2, one_minus_cosine));
            long double q[3];
            ref_legendre(l, 0, t.v, q);
            sum = ref_add(sum, ref_scale(w[i] / 2, ref_chain(t, q[0], q[1], q[2])));
        }
        sum = ref_scale(2 * REF_PI, ref_mul(sum, one_minus_cosine));
        for (m = -l; m <= l; m++) c[l * (l + 1) + m] = ref_mul(sum, c[l * (l + 1) + m]);
    }
}

void ref_sphere(int bands, const long double point[3], const long double center[3], long double radius, ref_jet *c)
{
    ref_jet d[3], r2 = ref_const(0), rho, s, cosine;
    int k;
    for (k = 0; k < 3; k++) {
        d[k] = ref_sub(ref_const(center[k]), ref_var(point[k], k));
        r2 = ref_add(r2, ref_mul(d[k], d[k]));
    }
    rho = ref_sqrt(r2);
    s = ref_div(ref_const(radius), rho);
    cosine = ref_div(ref_sqrt(ref_mul(ref_sub(rho, ref_const(radius)), ref_add(rho, ref_const(radius)))), rho);
    ref_cap(bands, d, ref_div(ref_mul(s, s), ref_add(ref_const(1), cosine)), c);
}

/* ---- random numbers: splitmix64 (Steele, Lea, Flood 2014) ---- */
static unsigned long long random_state = 20250101;

double ref_random(void)
{
    unsigned long long z = random_state += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

double ref_between(double a, double b) { return a + (b - a) * ref_random(); }
double ref_log_between(double a, double b) { return a * pow(b / a, ref_random()); }

void ref_unit(double u[3])
{
    const double phi = ref_between(0, 2 * (double)REF_PI), where = ref_random();
    double z = ref_between(-1, 1), s = sqrt(1 - z * z);
    if (where < 0.25) {                             /* where columns of high bands vary most: z small, or s small */
        const double large = cos(s = ref_log_between(1e-4, 0.3));
        z = ref_random() < 0.5 ? -sin(s) : sin(s);
        s = large;
        if (where < 0.125) {
            s = fabs(z);
            z = z < 0 ? -large : large;
        }
    }
    u[0] = s * cos(phi);
    u[1] = s * sin(phi);
    u[2] = z;
    if (ref_random() < 0.125) {
        const int axis = (int)ref_between(0, 3), other = (axis + 1 + (ref_random() < 0.5)) % 3;
        u[0] = u[1] = u[2] = 0;
        u[axis] = ref_random() < 0.5 ? -1 : 1;
        if (ref_random() < 0.5) {
            u[other] = ref_log_between(1e-30, 1e-2);
            u[axis] *= sqrt(1 - u[other] * u[other]);
        }
    }
}
