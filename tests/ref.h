/* ref.h - the definitions in long double, sharing no line and no derivative formula with the headers.
 *
 * A jet carries a value with its gradient and Hessian by up to three variables; arithmetic on jets is the product
 * and chain rule, so every derivative here comes from the definition of the value alone.
 *
 *     ref_jet p[3], y[1024];
 *     for (k = 0; k < 3; k++) p[k] = ref_var(v[k], k);       // the three variables
 *     ref_basis(bands, p, y);                                // y[i].v, y[i].g[k], y[i].h[xx xy xz yy yz zz]
 */
#ifndef SH_TESTS_REF_H
#define SH_TESTS_REF_H

enum { REF_MAX_BANDS = 34, REF_MAX = REF_MAX_BANDS * REF_MAX_BANDS };
#define REF_PI 3.141592653589793238462643383279502884L

typedef struct { long double v, g[3], h[6]; } ref_jet;

ref_jet ref_const(long double value);
ref_jet ref_var(long double value, int variable);
ref_jet ref_add(ref_jet a, ref_jet b);
ref_jet ref_sub(ref_jet a, ref_jet b);
ref_jet ref_mul(ref_jet a, ref_jet b);
ref_jet ref_div(ref_jet a, ref_jet b);
ref_jet ref_scale(long double s, ref_jet a);
ref_jet ref_chain(ref_jet a, long double f, long double f1, long double f2);   /* f(a), given f, f', f'' at a.v */
ref_jet ref_sqrt(ref_jet a);
ref_jet ref_cos(ref_jet a);
ref_jet ref_sin(ref_jet a);

/* d^m P_l / dz^m by the explicit sum, its first and second derivative, to long double precision at |z| <= 1. */
void ref_legendre(int l, int m, long double z, long double q[3]);
/* Y_i(v/|v|), i < bands^2, orthonormal, real, Condon-Shortley sign (Y_1 = -y, +z, -x). */
void ref_basis(int bands, const ref_jet v[3], ref_jet *y);
void ref_values(int bands, const long double v[3], long double *y);
/* Integral of Y_i over the cap of directions within the half-angle about u (any length). */
void ref_cap(int bands, const ref_jet u[3], ref_jet one_minus_cosine, ref_jet *c);
/* The sphere seen from point (outside of it), derivatives by the point. */
void ref_sphere(int bands, const long double point[3], const long double center[3], long double radius, ref_jet *c);
/* Gauss-Legendre nodes and weights on [-1,1], n <= 256. */
void ref_gauss(int n, long double *x, long double *w);

/* Scales of the bounds. */
long double ref_M(int l);      /* sqrt((2l+1)/4pi)         largest |Y_lm|, l2 over m at any direction */
long double ref_G(int l);      /* sqrt(l(l+1)(2l+1)/8pi)   of its gradient */
int ref_band(int i);           /* l of index i */

/* Random numbers: one fixed sequence per program. */
double ref_random(void);                       /* uniform in [0,1) */
double ref_between(double a, double b);        /* uniform */
double ref_log_between(double a, double b);    /* log-uniform, a and b > 0 */
void   ref_unit(double u[3]);                  /* uniform, but half near poles, equator and axes */

#endif
