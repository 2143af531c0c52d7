/* sh_product.h - rotation, products, shading and deringing of spherical-harmonics coefficients.
 *
 * USE         #include "sh_product.h"     beside sh_gradient.h; nothing else, no implementation macro.
 *
 * CONVENTION  as sh_gradient.h: orthonormal, polar z, index l(l+1)+m, N = bands^2, Y_1 = 0.4886 (-y, +z, -x).
 *             Other systems' sets: sh_convert_to / sh_convert_from, docs/conventions.md.
 *
 * FUNCTIONS   each with suffix _f32 or _f64; bands 1..16 unless said otherwise; all return a status
 *   rotation   sh_rotation_matrix, _quaternion, _inverse   set-up, once per rotation
 *              sh_rotate, sh_rotate_blocks                 any number of coefficient vectors
 *              sh_mirror, sh_permute_axes                  the 48 symmetries of the axes, improper ones too
 *   products   sh_triple_product, _n, _bands               f times g
 *              sh_cosine_product, _n, _blocks              f times the clamped cosine about a normal
 *              sh_cosine_product_local, _n, _blocks        the same, normal +z
 *              sh_cosine_product_zonal                     the same, cosine cut to a few bands (MP21 Eq. 10)
 *              sh_diffuse_from_product                     irradiance of any product, one multiplication
 *   shading    sh_diffuse, sh_diffuse_n                    irradiance at normals; any zonal lobe: sh_convolve
 *              sh_zonal_cosine, _phong, _ggx               zonal coefficients of lobes
 *   ringing    sh_scale_bands, sh_window, sh_minimum, sh_dering
 *   exchange   sh_convention, sh_convention_name, _size; sh_convert_to, _from, _direction_to, _direction_from
 *
 * DOES NOT    allocate, keep state, print. Arrays need no alignment. In and out may be the same array, or must not overlap
 *             (SH_ERROR_OVERLAP). NaN and Inf in coefficients go through; in geometry (and in sh_dering) they are an error.
 *             Stack, f64 (f32): triple product 52 KiB (35), sh_minimum and sh_dering 130 KiB (70), the others 27 KiB at most.
 *
 * ERROR       eps and M_l as in sh_gradient.h; c = the input vector, |.| its 2-norm, worst over the output: rotation and cosine
 *             products 16 eps |c| to 6 bands, 40 eps |c| to 16; triple product the same with |a| |b|. `make test` sees at
 *             most 3.1 eps |c| (docs/products.md).
 *
 * SOURCES     MP21  Mezieres, Paulin, Efficient spherical harmonic shading for separable BRDF (2021)
 *             KSS02 Kautz, Sloan, Snyder, Fast, arbitrary BRDF shading (2002): rotation as zxzxz
 *             RH01  Ramamoorthi, Hanrahan, An efficient representation for irradiance environment maps (2001)
 *             S08   Sloan, Stupid spherical harmonics (SH) tricks (2008): windowing
 *
 * CONFIG      SH_PRODUCT_FILENAME   this file's name in your tree   ["sh_product.h"]
 *
 * MIT licence, at the end of the file. */
#if !defined(SHI_ROOM)
#ifndef SH_PRODUCT_H
#define SH_PRODUCT_H

#ifndef SH_GRADIENT_FILENAME
#  define SH_GRADIENT_FILENAME "sh_gradient.h"
#endif
#include SH_GRADIENT_FILENAME

#ifndef SH_PRODUCT_FILENAME
#  define SH_PRODUCT_FILENAME "sh_product.h"
#endif

enum { SH_PRODUCT_BANDS = 16 };         /* most bands of rotations and products */
enum { SH_HANN = 1, SH_LANCZOS = 2, SH_GAUSS = 3 };     /* windows */
enum { SHI_KEPT = 1024, SHI_CHUNK = 64 };   /* samples that sh_minimum keeps, and takes at once */

/* Cases of a switch over n that call body(n, ...) with n a constant: its loops unroll, and what hangs on n is decided. */
#define SHI_CASE(n, body, ...) case n: body(n, __VA_ARGS__); break;
#define SHI_CASES_1_TO_8(body, ...) \
    SHI_CASE(1, body, __VA_ARGS__) SHI_CASE(2, body, __VA_ARGS__) SHI_CASE(3, body, __VA_ARGS__) \
    SHI_CASE(4, body, __VA_ARGS__) SHI_CASE(5, body, __VA_ARGS__) SHI_CASE(6, body, __VA_ARGS__) \
    SHI_CASE(7, body, __VA_ARGS__) SHI_CASE(8, body, __VA_ARGS__)
#define SHI_CASES_9_TO_16(body, ...) \
    SHI_CASE(9, body, __VA_ARGS__) SHI_CASE(10, body, __VA_ARGS__) SHI_CASE(11, body, __VA_ARGS__) \
    SHI_CASE(12, body, __VA_ARGS__) SHI_CASE(13, body, __VA_ARGS__) SHI_CASE(14, body, __VA_ARGS__) \
    SHI_CASE(15, body, __VA_ARGS__) SHI_CASE(16, body, __VA_ARGS__)

/* Entries of band l in the table of swaps. */
SHI_INLINE int shi_swap_size(int l)
{
    const int a = l / 2, b = (l + 1) / 2;
    return l % 2 == 0 ? (a + 1) * (a + 1) + 2 * a * a : b * b + (b - 1) * (b - 1) + b * b;
}

/* Output and input may be one array, or must be apart. */
SHI_INLINE int shi_clash(const void *out, size_t out_bytes, const void *in, size_t in_bytes)
{
    return (out != in || out_bytes != in_bytes) && shi_overlap(out, out_bytes, in, in_bytes);
}

/* cs = cosine and sine of a, of b and of g in m = Rz(a) Ry(b) Rz(g), m row-major; SH_ERROR_MATRIX if m mirrors, or its rows'
 * dot products are off by more than the tolerance. */
SHI_INLINE int shi_euler(const double m[9], double tolerance, double cs[6])
{
    double sb, r, det;
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = i; j < 3; j++) {
            const double *const p = m + 3 * i, *const q = m + 3 * j;
            const double dot = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
            if (!(fabs(dot - (i == j)) <= tolerance)) return SH_ERROR_MATRIX;
        }
    det = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6])
        + m[2] * (m[3] * m[7] - m[4] * m[6]);
    if (!(det > 0)) return SH_ERROR_MATRIX;
    sb = sqrt(m[2] * m[2] + m[5] * m[5]);
    if (!(sb > 1e-140)) sb = 0;                 /* its square has no digits left, and no effect */
    cs[0] = sb > 0 ? m[2] / sb : 1;
    cs[1] = sb > 0 ? m[5] / sb : 0;
    r = sqrt(sb * sb + m[8] * m[8]);
    cs[2] = m[8] / r;
    cs[3] = sb / r;
    /* row y of Rz(-a) m = Ry(b) Rz(g), which Ry leaves alone: well defined at b = 0 and pi too */
    cs[4] = cs[0] * m[4] - cs[1] * m[1];
    cs[5] = cs[0] * m[3] - cs[1] * m[0];
    r = sqrt(cs[4] * cs[4] + cs[5] * cs[5]);
    cs[4] /= r;
    cs[5] /= r;
    return SH_OK;
}

/* From the integrals of 2 pi times a function of z times P_l to its coefficients: times sqrt((2l+1)/4pi). */
SHI_INLINE void shi_zonal_scale(int bands, double *zh)
{
    const double over_four_pi = 0.07957747154594767;
    int l;
    for (l = 0; l < bands; l++) zh[l] *= sqrt((2 * l + 1) * over_four_pi);
}

/* Coefficients of (s+1)/(2 pi) max(0, z)^s, from the integrals of (s+1) z^s P_l over [0,1]. */
SHI_INLINE void shi_zonal_power(int bands, double s, double *zh)
{
    int l;
    for (l = 0; l < bands; l++) {
        const double less = (2 * l - 1) / (s + l + 1);      /* one rounding a step where it is small, not four */
        zh[l] = l == 0 ? 1 : l == 1 ? (s + 1) / (s + 2)
              : less < 0.5 ? zh[l - 2] - zh[l - 2] * less : zh[l - 2] * (s - (l - 2)) / (s + l + 1);
    }
    shi_zonal_scale(bands, zh);
}

/* Coefficients of a2 / (pi ((1 + a2) - (1 - a2) z)^2) with a2 = alpha^2. Its Legendre integrals are -Q_l'(p), Q the function
 * of the second kind, p = (1 + a2)/(1 - a2): the decaying solution of l e_{l+1} = (2l+1) p e_l - (l+1) e_{l-1}. Carried as
 * s_l = 1 - e_l/e_{l-1} it has no cancellation downwards; for alpha below 1e-3, where that is long, s_l is so small that it
 * may go upwards from s_1. */
SHI_INLINE void shi_ggx(int bands, double alpha, double *zh)
{
    /* t = 1/p, u = 1 - t */
    const double a2 = alpha * alpha, t = (1 - alpha) * (1 + alpha) / (1 + a2), u = 2 * a2 / (1 + a2);
    double s = 1;
    int l;

    for (l = 0; l < bands; l++) zh[l] = 1;      /* all: gcc 12 loses track of the loop below */
    if (alpha >= 1e-3) {
        for (l = bands + (alpha < 1 ? (int)(20 / (2 * atanh(alpha))) : 0); l > 0; l--) {
            s = ((2 * l + 1) * u + l * t * s) / ((l + 1) + l * u + l * t * s);
            if (l < bands) zh[l] = 1 - s;
        }
    } else {
        s = alpha > 0 ? -2 * a2 / (1 - a2) * (1 + 2 * log(alpha) / (1 - a2)) : 0;
        for (l = 1; l < bands; l++) {
            zh[l] = 1 - s;
            s = (s * ((l + 1) + l * u) - (2 * l + 1) * u) / (l * t * (1 - s));
        }
    }
    for (l = 1; l < bands; l++) zh[l] *= zh[l - 1];
    shi_zonal_scale(bands, zh);
}

/* Weight of band l in a window of a width in bands: S08 for Hann's and Lanczos's. */
SHI_INLINE double shi_window(int kind, double width, int l)
{
    const double x = SHI_PI * l / width;
    if (l == 0) return 1;
    if (kind == SH_GAUSS) return exp(-0.5 * x * x * (l + 1) / l);
    if (l >= width) return 0;
    return kind == SH_HANN ? 0.5 * (1 + cos(x)) : x > 0 ? sin(x) / x : 1;
}

/* Axes of the plane tangent to the unit sphere at v, the first one nearest to the coordinate axis that v is farthest from. */
SHI_INLINE void shi_tangent_axes(const double v[3], double e[2][3])
{
    const int k = fabs(v[0]) < fabs(v[1]) ? (fabs(v[0]) < fabs(v[2]) ? 0 : 2) : fabs(v[1]) < fabs(v[2]) ? 1 : 2;
    double size;
    int i;
    for (i = 0; i < 3; i++) e[0][i] = (i == k) - v[k] * v[i];
    size = sqrt(e[0][0] * e[0][0] + e[0][1] * e[0][1] + e[0][2] * e[0][2]);
    for (i = 0; i < 3; i++) e[0][i] /= size;
    for (i = 0; i < 3; i++) e[1][i] = v[(i + 1) % 3] * e[0][(i + 2) % 3] - v[(i + 2) % 3] * e[0][(i + 1) % 3];
}

/* Step downhill on the unit sphere from v, where a function has these Cartesian derivatives (hess xx xy xz yy yz zz):
 * Newton's, with the eigenvalues of the tangent plane's Hessian made positive. It has no scale: a power of two takes the
 * Hessian's out, so that its squares stay in range. */
SHI_INLINE void shi_newton_step(const double v[3], const double grad[3], const double hess[6], double step[3])
{
    double e[2][3], h[2][2], form[2][3], mean, half, r;
    int i, j, k, exponent;

    shi_tangent_axes(v, e);
    for (j = 0; j < 2; j++) {
        form[j][0] = hess[0] * e[j][0] + hess[1] * e[j][1] + hess[2] * e[j][2];
        form[j][1] = hess[1] * e[j][0] + hess[3] * e[j][1] + hess[4] * e[j][2];
        form[j][2] = hess[2] * e[j][0] + hess[4] * e[j][1] + hess[5] * e[j][2];
    }
    for (j = 0; j < 2; j++)
        for (k = 0; k < 2; k++) h[j][k] = e[j][0] * form[k][0] + e[j][1] * form[k][1] + e[j][2] * form[k][2];
    (void)frexp(fabs(h[0][0]) + fabs(h[0][1]) + fabs(h[1][1]), &exponent);
    for (j = 0; j < 2; j++)
        for (k = 0; k < 2; k++) h[j][k] = ldexp(h[j][k], -exponent);

    mean = 0.5 * (h[0][0] + h[1][1]);                       /* the eigenvalues are mean + r and mean - r */
    half = 0.5 * (h[0][0] - h[1][1]);
    r = sqrt(half * half + h[0][1] * h[0][1]);
    step[0] = step[1] = step[2] = 0;
    for (k = 0; k < 2; k++) {
        const double t = r > 0 ? half / r : 1;              /* cosine of twice the first eigenvector's angle in the plane */
        const double c = sqrt(0.5 * (1 + t)), s = (h[0][1] < 0 ? -1 : 1) * sqrt(0.5 * (1 - t));
        const double x = k ? -s : c, y = k ? c : s;
        const double value = fabs(k ? mean - r : mean + r), least = 1e-6 * (fabs(mean) + r);
        double slope = 0;
        if (!(value > 0)) continue;
        for (i = 0; i < 3; i++) slope += grad[i] * (x * e[0][i] + y * e[1][i]);
        slope = ldexp(slope, -exponent);
        for (i = 0; i < 3; i++) step[i] -= slope / (value > least ? value : least) * (x * e[0][i] + y * e[1][i]);
    }
}

/* Is Y_lm even (1) or odd (-1) under the mirror of axis 0, 1, 2? */
SHI_INLINE int shi_parity(int axis, int l, int m)
{
    const int odd = axis == 0 ? (m < 0) ^ (m & 1) : axis == 1 ? m < 0 : (l + m) & 1;
    return odd ? -1 : 1;
}

/* ---- other systems' conventions: docs/conventions.md is this table for people ---- */

enum {                                  /* where a coefficient stands */
    SHI_ORDER_ACN,                      /* l(l+1) + m, as here */
    SHI_ORDER_FUMA,                     /* W XYZ RSTUV KLMNOPQ */
    SHI_ORDER_COMPLEX,                  /* l(l+1) + m, real and imaginary parts of all m */
    SHI_ORDER_HALF_COMPLEX,             /* ... of m >= 0, m by m */
    SHI_ORDER_TRIANGLES,                /* l(l+1)/2 + m: cosines, then sines */
    SHI_ORDER_SQUARES,                  /* [2][bands][bands]: cosines, then sines */
    SHI_ORDER_PACKED,                   /* a shader's SHA xyzw, SHB xyzw, SHC */
    SHI_ORDER_MONOMIALS                 /* x y z xx yy zz yz zx xy */
};
enum {                                  /* theirs over ours, sign apart; ours are radiance on an orthonormal basis */
    SHI_SCALE_RADIANCE,                 /* 1 */
    SHI_SCALE_PER_PI,                   /* 1/pi */
    SHI_SCALE_IRRADIANCE,               /* the clamped cosine: pi, 2 pi/3, pi/4 */
    SHI_SCALE_FOLDED,                   /* that over pi, times the basis function's constant */
    SHI_SCALE_FOUR_PI,                  /* 1/sqrt(4 pi): factors of basis functions of mean square 1 */
    SHI_SCALE_N3D, SHI_SCALE_SN3D, SHI_SCALE_MAX_N,     /* ambisonics' three */
    SHI_SCALE_HALVES, SHI_SCALE_DOUBLES                 /* 1/sqrt 2, sqrt 2, where m != 0 */
};

typedef struct {
    const char *name;
    signed char order, scale;
    signed char phase;                  /* 1: Condon-Shortley factor in, as here */
    signed char polar;                  /* axis of theirs that is our z: 2; or 1, their x, y, z our y, z, x */
    signed char most;                   /* bands */
} shi_convention;

SHI_INLINE const shi_convention *shi_find_convention(int id)
{
    static const shi_convention list[] = {
        { "sloan",              SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2, 32 },
        { "no-phase",           SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   0, 2, 32 },
        { "directxmath",        SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2,  6 },
        { "d3dx",               SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2,  6 },
        { "m22",                SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2, 32 },
        { "wr18",               SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2, 32 },
        { "pbrt",               SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2, 29 },
        { "google",             SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2, 32 },
        { "tiny-cuda-nn",       SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2,  8 },
        { "3dgs",               SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2,  4 },
        { "unreal",             SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2,  3 },
        { "babylon",            SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   1, 2,  3 },
        { "babylon-polynomial", SHI_ORDER_MONOMIALS,    SHI_SCALE_FOLDED,     0, 2,  3 },
        { "gltf",               SHI_ORDER_ACN,          SHI_SCALE_IRRADIANCE, 1, 2,  3 },
        { "three",              SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   0, 2,  3 },
        { "godot",              SHI_ORDER_ACN,          SHI_SCALE_PER_PI,     0, 2,  3 },
        { "unity",              SHI_ORDER_ACN,          SHI_SCALE_FOLDED,     0, 2,  3 },
        { "unity-packed",       SHI_ORDER_PACKED,       SHI_SCALE_FOLDED,     0, 2,  3 },
        { "filament",           SHI_ORDER_ACN,          SHI_SCALE_FOLDED,     0, 2,  3 },
        { "sh-lib",             SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   0, 2, 32 },
        { "falcor",             SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   0, 2,  4 },
        { "sphericart",         SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   0, 2, 32 },
        { "e3nn",               SHI_ORDER_ACN,          SHI_SCALE_RADIANCE,   0, 1, 12 },
        { "scipy",              SHI_ORDER_COMPLEX,      SHI_SCALE_HALVES,     1, 2, 32 },
        { "mpmath",             SHI_ORDER_COMPLEX,      SHI_SCALE_HALVES,     1, 2, 32 },
        { "sympy",              SHI_ORDER_COMPLEX,      SHI_SCALE_HALVES,     1, 2, 32 },
        { "boost",              SHI_ORDER_COMPLEX,      SHI_SCALE_HALVES,     1, 2, 32 },
        { "healpy",             SHI_ORDER_HALF_COMPLEX, SHI_SCALE_HALVES,     1, 2, 32 },
        { "gsl",                SHI_ORDER_TRIANGLES,    SHI_SCALE_DOUBLES,    0, 2, 32 },
        { "shtools",            SHI_ORDER_SQUARES,      SHI_SCALE_FOUR_PI,    0, 2, 32 },
        { "n3d",                SHI_ORDER_ACN,          SHI_SCALE_N3D,        0, 2, 32 },
        { "sn3d",               SHI_ORDER_ACN,          SHI_SCALE_SN3D,       0, 2, 32 },
        { "fuma",               SHI_ORDER_FUMA,         SHI_SCALE_MAX_N,      0, 2,  4 }
    };
    return id >= 0 && id < (int)(sizeof list / sizeof list[0]) ? list + id : NULL;
}

/* Name of a convention's number, counted from 0; NULL past the last, and for negative ones. */
SH_API const char *sh_convention_name(int convention)
{
    const shi_convention *c = shi_find_convention(convention);
    return c ? c->name : NULL;
}

/* Number of a convention by its name in docs/conventions.md, 0 or more; SH_ERROR_OPTION for an unknown one. */
SH_API int sh_convention(const char *name)
{
    const char *known;
    int id;
    if (!name) return SH_ERROR_NULL;
    for (id = 0; (known = sh_convention_name(id)) != NULL; id++)
        if (strcmp(known, name) == 0) return id;
    return SH_ERROR_OPTION;
}

/* How many numbers one vector of that many bands has there (a complex one counts as two), or a negative status:
 * SH_ERROR_BANDS beyond what the system has, SH_ERROR_OPTION for an unknown one. */
SH_API int sh_convention_size(int convention, int bands)
{
    const shi_convention *c = shi_find_convention(convention);
    if (!c) return SH_ERROR_OPTION;
    if (bands < 1 || bands > c->most) return SH_ERROR_BANDS;
    switch (c->order) {
    case SHI_ORDER_COMPLEX:      case SHI_ORDER_SQUARES:   return 2 * bands * bands;
    case SHI_ORDER_HALF_COMPLEX: case SHI_ORDER_TRIANGLES: return bands * (bands + 1);
    case SHI_ORDER_PACKED:       case SHI_ORDER_MONOMIALS: return bands == 3 ? 9 : SH_ERROR_BANDS;
    default: return bands * bands;
    }
}

/* theirs = factor * ours; of the forms that mix coefficients, of what is mixed */
SHI_INLINE double shi_convention_factor(const shi_convention *c, int l, int m)
{
    static const double cosine[3] = { 1, 2.0 / 3, 0.25 };       /* irradiance / pi over radiance */
    static const double basis[9] = { 0.28209479177387814,
        0.4886025119029199, 0.4886025119029199, 0.4886025119029199,
        1.0925484305920792, 1.0925484305920792, 0.31539156525252, 1.0925484305920792, 0.5462742152960396 };
    static const double peak[4][4] = { { 0.7071067811865476 }, { 1, 1 },
        { 1, 1.1547005383792515, 1.1547005383792515 },
        { 1, 1.1858541225631423, 1.3416407864998738, 1.2649110640673518 } };    /* FuMa over SN3D */
    const int am = m < 0 ? -m : m;
    double f = !c->phase && (m & 1) ? -1 : 1;

    switch (c->scale) {
    case SHI_SCALE_PER_PI:     f *= 0.3183098861837907; break;
    case SHI_SCALE_IRRADIANCE: f *= SHI_PI * cosine[l]; break;
    case SHI_SCALE_FOLDED:     f *= cosine[l] * basis[l * (l + 1) + m]; break;
    case SHI_SCALE_FOUR_PI:    f *= SHI_Y00; break;
    case SHI_SCALE_N3D:        f *= SHI_ROOT_FOUR_PI; break;
    case SHI_SCALE_SN3D:       f *= SHI_ROOT_FOUR_PI / sqrt(2 * l + 1.0); break;
    case SHI_SCALE_MAX_N:      f *= SHI_ROOT_FOUR_PI / sqrt(2 * l + 1.0) * peak[l][am]; break;
    case SHI_SCALE_HALVES:     if (m) f *= 0.7071067811865476; break;
    case SHI_SCALE_DOUBLES:    if (m) f *= 1.4142135623730951; break;
    default: break;
    }
    return f;
}

/* where the coefficient (the real part of a complex one) stands among theirs */
SHI_INLINE int shi_convention_place(const shi_convention *c, int bands, int l, int m)
{
    static const signed char fuma[16] = { 0, 2, 3, 1, 8, 6, 4, 5, 7, 15, 13, 11, 9, 10, 12, 14 };
    const int am = m < 0 ? -m : m;
    switch (c->order) {
    case SHI_ORDER_FUMA:         return fuma[l * (l + 1) + m];
    case SHI_ORDER_COMPLEX:      return 2 * (l * (l + 1) + m);
    case SHI_ORDER_HALF_COMPLEX: return 2 * (am * bands - am * (am - 1) / 2 + l - am) + (m < 0);
    case SHI_ORDER_TRIANGLES:    return (m < 0 ? bands * (bands + 1) / 2 : 0) + l * (l + 1) / 2 + am;
    case SHI_ORDER_SQUARES:      return (m < 0 ? bands * bands : 0) + l * bands + am;
    default:                     return l * (l + 1) + m;
    }
}

#define SHI_FILE SH_PRODUCT_FILENAME
#define SHI_ROOM SHI_INSTANTIATE
#include SH_GRADIENT_FILENAME

#endif /* SH_PRODUCT_H */

/* ================================================================================================================
 * Tables: once per precision.
 * ============================================================================================================= */
#elif SHI_ROOM == SHI_TABLES

/* BEGIN tools/gen_product.py */
/* Bands 0..15: per band two blocks that y <-> z maps to themselves, and one between two classes. */
static const SHI_T SHI_FN(shi_swap)[1032] = {
    SHI_C(1), SHI_C(1), SHI_C(-1), SHI_C(-0.5), SHI_C(-0.8660254037844386), SHI_C(-0.8660254037844386),
    SHI_C(0.5), SHI_C(1), SHI_C(-1), SHI_C(-0.25), SHI_C(-0.9682458365518543), SHI_C(-0.9682458365518543),
    SHI_C(0.25), SHI_C(1), SHI_C(0.6123724356957945), SHI_C(0.7905694150420949), SHI_C(0.7905694150420949),
    SHI_C(-0.6123724356957945), SHI_C(0.375), SHI_C(0.5590169943749475), SHI_C(0.739509972887452),
    SHI_C(0.5590169943749475), SHI_C(0.5), SHI_C(-0.6614378277661477), SHI_C(0.739509972887452),
    SHI_C(-0.6614378277661477), SHI_C(0.125), SHI_C(-0.75), SHI_C(-0.6614378277661477),
    SHI_C(-0.6614378277661477), SHI_C(0.75), SHI_C(0.3535533905932738), SHI_C(0.9354143466934853),
    SHI_C(0.9354143466934853), SHI_C(-0.3535533905932738), SHI_C(0.125), SHI_C(0.4050462936504913),
    SHI_C(0.9057110466368399), SHI_C(0.4050462936504913), SHI_C(0.8125), SHI_C(-0.4192627457812106),
    SHI_C(0.9057110466368399), SHI_C(-0.4192627457812106), SHI_C(0.0625), SHI_C(-0.5),
    SHI_C(-0.8660254037844386), SHI_C(-0.8660254037844386), SHI_C(0.5), SHI_C(-0.4841229182759271),
    SHI_C(-0.5229125165837972), SHI_C(-0.701560760020114), SHI_C(-0.6614378277661477),
    SHI_C(-0.30618621784789724), SHI_C(0.6846531968814576), SHI_C(-0.57282196186948),
    SHI_C(0.795495128834866), SHI_C(-0.19764235376052372), SHI_C(-0.3125), SHI_C(-0.45285552331841994),
    SHI_C(-0.49607837082461076), SHI_C(-0.6716932893813962), SHI_C(-0.45285552331841994), SHI_C(-0.53125),
    SHI_C(-0.1711632992203644), SHI_C(0.6952686081652184), SHI_C(-0.49607837082461076),
    SHI_C(-0.1711632992203644), SHI_C(0.8125), SHI_C(-0.2538762001448738), SHI_C(-0.6716932893813962),
    SHI_C(0.6952686081652184), SHI_C(-0.2538762001448738), SHI_C(0.03125), SHI_C(0.625),
    SHI_C(0.5929270612815711), SHI_C(0.5077524002897476), SHI_C(0.5929270612815711), SHI_C(0.0625),
    SHI_C(-0.8028270361665706), SHI_C(0.5077524002897476), SHI_C(-0.8028270361665706), SHI_C(0.3125),
    SHI_C(-0.19764235376052372), SHI_C(-0.4330127018922193), SHI_C(-0.879452954966893), SHI_C(-0.5625),
    SHI_C(-0.6846531968814576), SHI_C(0.46351240544347894), SHI_C(-0.8028270361665706),
    SHI_C(0.5863019699779287), SHI_C(-0.10825317547305482), SHI_C(-0.078125), SHI_C(-0.24356964481437338),
    SHI_C(-0.4487939567607835), SHI_C(-0.8562442974262661), SHI_C(-0.24356964481437338), SHI_C(-0.609375),
    SHI_C(-0.5700448858423344), SHI_C(0.4943528756111367), SHI_C(-0.4487939567607835),
    SHI_C(-0.5700448858423344), SHI_C(0.671875), SHI_C(-0.14905300022139775), SHI_C(-0.8562442974262661),
    SHI_C(0.4943528756111367), SHI_C(-0.14905300022139775), SHI_C(0.015625), SHI_C(0.3125),
    SHI_C(0.5863019699779287), SHI_C(0.7473912964438374), SHI_C(0.5863019699779287), SHI_C(0.5),
    SHI_C(-0.6373774391990981), SHI_C(0.7473912964438374), SHI_C(-0.6373774391990981), SHI_C(0.1875),
    SHI_C(0.41339864235384227), SHI_C(0.42961647140211), SHI_C(0.47495887979908324),
    SHI_C(0.6472598492877494), SHI_C(0.5740991584648074), SHI_C(0.4198446513295126),
    SHI_C(0.07328774624724109), SHI_C(-0.6991205412874092), SHI_C(0.5385527481129402),
    SHI_C(-0.10364452469860624), SHI_C(-0.78125), SHI_C(0.2981060004427955), SHI_C(0.4576818286211503),
    SHI_C(-0.7927281808728639), SHI_C(0.3983608994994363), SHI_C(-0.05846339666834283), SHI_C(0.2734375),
    SHI_C(0.3921843874378479), SHI_C(0.4113264556590057), SHI_C(0.4576818286211503),
    SHI_C(0.6267066542400439), SHI_C(0.3921843874378479), SHI_C(0.5), SHI_C(0.32775276505317236), SHI_C(0),
    SHI_C(-0.6991205412874092), SHI_C(0.4113264556590057), SHI_C(0.32775276505317236), SHI_C(-0.28125),
    SHI_C(-0.7302075903467452), SHI_C(0.3332926407453366), SHI_C(0.4576818286211503), SHI_C(0),
    SHI_C(-0.7302075903467452), SHI_C(0.5), SHI_C(-0.0855816496101822), SHI_C(0.6267066542400439),
    SHI_C(-0.6991205412874092), SHI_C(0.3332926407453366), SHI_C(-0.0855816496101822), SHI_C(0.0078125),
    SHI_C(-0.546875), SHI_C(-0.5310201708739509), SHI_C(-0.4943528756111367), SHI_C(-0.4178044361600293),
    SHI_C(-0.5310201708739509), SHI_C(-0.265625), SHI_C(0.2181912506838897), SHI_C(0.7745021082121081),
    SHI_C(-0.4943528756111367), SHI_C(0.2181912506838897), SHI_C(0.703125), SHI_C(-0.4621937330546575),
    SHI_C(-0.4178044361600293), SHI_C(0.7745021082121081), SHI_C(-0.4621937330546575), SHI_C(0.109375),
    SHI_C(0.1307281291459493), SHI_C(0.27421763710600383), SHI_C(0.4576818286211503),
    SHI_C(0.8356088723200586), SHI_C(0.38081430021731066), SHI_C(0.6051536478449089),
    SHI_C(0.47134697278119864), SHI_C(-0.516334738808072), SHI_C(0.5908647000371574),
    SHI_C(0.338020432074749), SHI_C(-0.7088310138883597), SHI_C(0.184877493221863),
    SHI_C(0.6991205412874092), SHI_C(-0.6665852814906732), SHI_C(0.2567449488305466), SHI_C(-0.03125),
    SHI_C(0.0546875), SHI_C(0.16792332234534904), SHI_C(0.2954323500185787), SHI_C(0.4624247721758373),
    SHI_C(0.8171255055356399), SHI_C(0.16792332234534904), SHI_C(0.453125), SHI_C(0.577279787559724),
    SHI_C(0.38725105410605404), SHI_C(-0.5322256665703469), SHI_C(0.2954323500185787),
    SHI_C(0.577279787559724), SHI_C(0.140625), SHI_C(-0.7162405240429014), SHI_C(0.21608307321780204),
    SHI_C(0.4624247721758373), SHI_C(0.38725105410605404), SHI_C(-0.7162405240429014), SHI_C(0.34765625),
    SHI_C(-0.048317644050206957), SHI_C(0.8171255055356399), SHI_C(-0.5322256665703469),
    SHI_C(0.21608307321780204), SHI_C(-0.048317644050206957), SHI_C(0.00390625), SHI_C(-0.21875),
    SHI_C(-0.4215855488510013), SHI_C(-0.5854685623498498), SHI_C(-0.656993626300895),
    SHI_C(-0.4215855488510013), SHI_C(-0.5625), SHI_C(-0.20252314682524564), SHI_C(0.6817945071647321),
    SHI_C(-0.5854685623498498), SHI_C(-0.20252314682524564), SHI_C(0.71875), SHI_C(-0.3156095293238149),
    SHI_C(-0.656993626300895), SHI_C(0.6817945071647321), SHI_C(-0.3156095293238149), SHI_C(0.0625),
    SHI_C(-0.36685490255855924), SHI_C(-0.3754879637718099), SHI_C(-0.39636409043643195),
    SHI_C(-0.44314852502786806), SHI_C(-0.6090493921755238), SHI_C(-0.5130142237306876),
    SHI_C(-0.42961647140211), SHI_C(-0.25194555463432966), SHI_C(0.05633673867912483),
    SHI_C(0.6968469725305549), SHI_C(-0.4943528756111367), SHI_C(-0.13799626353637262),
    SHI_C(0.3921843874378479), SHI_C(0.6723290616859426), SHI_C(-0.3615761395439417),
    SHI_C(-0.4576818286211503), SHI_C(0.2981060004427955), SHI_C(0.6051536478449089),
    SHI_C(-0.5683291712335379), SHI_C(0.11158481919598204), SHI_C(-0.38519665736315783),
    SHI_C(0.7526807559068452), SHI_C(-0.5093126879064569), SHI_C(0.15944009087467617),
    SHI_C(-0.016572815184059706), SHI_C(-0.24609375), SHI_C(-0.3512368283228746),
    SHI_C(-0.3618292555284191), SHI_C(-0.38377788032373783), SHI_C(-0.4306629552848579),
    SHI_C(-0.5936279171365733), SHI_C(-0.3512368283228746), SHI_C(-0.46484375), SHI_C(-0.3661888014143114),
    SHI_C(-0.18922142726223226), SHI_C(0.10058119679362292), SHI_C(0.6932080600734395),
    SHI_C(-0.3618292555284191), SHI_C(-0.3661888014143114), SHI_C(0.015625), SHI_C(0.4585145534256519),
    SHI_C(0.6137165055779011), SHI_C(-0.38452264694764726), SHI_C(-0.38377788032373783),
    SHI_C(-0.18922142726223226), SHI_C(0.4585145534256519), SHI_C(0.462890625), SHI_C(-0.6114934630648914),
    SHI_C(0.13594928558824104), SHI_C(-0.4306629552848579), SHI_C(0.10058119679362292),
    SHI_C(0.6137165055779011), SHI_C(-0.6114934630648914), SHI_C(0.23046875), SHI_C(-0.026921970218926214),
    SHI_C(-0.5936279171365733), SHI_C(0.6932080600734395), SHI_C(-0.38452264694764726),
    SHI_C(0.13594928558824104), SHI_C(-0.026921970218926214), SHI_C(0.001953125), SHI_C(0.4921875),
    SHI_C(0.4829869223773041), SHI_C(0.462853538862457), SHI_C(0.4267298778757764),
    SHI_C(0.35797110294949086), SHI_C(0.4829869223773041), SHI_C(0.328125), SHI_C(0.034938562148434216),
    SHI_C(-0.3543293897015177), SHI_C(-0.7295804257628147), SHI_C(0.462853538862457),
    SHI_C(0.034938562148434216), SHI_C(-0.484375), SHI_C(-0.5041938375082048), SHI_C(0.5437971423529642),
    SHI_C(0.4267298778757764), SHI_C(-0.3543293897015177), SHI_C(-0.5041938375082048), SHI_C(0.62890625),
    SHI_C(-0.20644078533943455), SHI_C(0.35797110294949086), SHI_C(-0.7295804257628147),
    SHI_C(0.5437971423529642), SHI_C(-0.20644078533943455), SHI_C(0.03515625), SHI_C(-0.09472152853892297),
    SHI_C(-0.19515618744994995), SHI_C(-0.31049159295683837), SHI_C(-0.4645646483537033),
    SHI_C(-0.800447720175637), SHI_C(-0.27885262964960544), SHI_C(-0.4861359120657514), SHI_C(-0.5390625),
    SHI_C(-0.3156095293238149), SHI_C(0.5437971423529642), SHI_C(-0.44538102542935076),
    SHI_C(-0.49410588440130926), SHI_C(0.017469281074217108), SHI_C(0.7057243619147634),
    SHI_C(-0.24319347525427157), SHI_C(-0.574869423013283), SHI_C(-0.09110862335695782),
    SHI_C(0.6925528980529664), SHI_C(-0.42100604954085874), SHI_C(0.06594508990677396),
    SHI_C(-0.6200241379499873), SHI_C(0.6878550219704731), SHI_C(-0.36479021288140734),
    SHI_C(0.09631896879639025), SHI_C(-0.008734640537108554), SHI_C(-0.041015625),
    SHI_C(-0.12498474027950122), SHI_C(-0.21561916177558219), SHI_C(-0.32136177701094576),
    SHI_C(-0.46501810346249056), SHI_C(-0.7852959200243154), SHI_C(-0.12498474027950122),
    SHI_C(-0.349609375), SHI_C(-0.4953107286295218), SHI_C(-0.49716719187291986),
    SHI_C(-0.25433782432394114), SHI_C(0.5522286086008462), SHI_C(-0.21561916177558219),
    SHI_C(-0.4953107286295218), SHI_C(-0.3857421875), SHI_C(0.1403500730508221), SHI_C(0.6844881147156696),
    SHI_C(-0.26675176057529504), SHI_C(-0.32136177701094576), SHI_C(-0.49716719187291986),
    SHI_C(0.1403500730508221), SHI_C(0.6279296875), SHI_C(-0.47810190182411116), SHI_C(0.08352321608098984),
    SHI_C(-0.46501810346249056), SHI_C(-0.25433782432394114), SHI_C(0.6844881147156696),
    SHI_C(-0.47810190182411116), SHI_C(0.1474609375), SHI_C(-0.014842464993721351),
    SHI_C(-0.7852959200243154), SHI_C(0.5522286086008462), SHI_C(-0.26675176057529504),
    SHI_C(0.08352321608098984), SHI_C(-0.014842464993721351), SHI_C(0.0009765625), SHI_C(0.1640625),
    SHI_C(0.32021721143623744), SHI_C(0.45838141911581126), SHI_C(0.5616312736128571),
    SHI_C(0.5873680453541246), SHI_C(0.32021721143623744), SHI_C(0.5), SHI_C(0.41751216299648086), SHI_C(0),
    SHI_C(-0.6878550219704731), SHI_C(0.45838141911581126), SHI_C(0.41751216299648086), SHI_C(-0.18359375),
    SHI_C(-0.6461272852542291), SHI_C(0.4054416537188952), SHI_C(0.5616312736128571), SHI_C(0),
    SHI_C(-0.6461272852542291), SHI_C(0.5), SHI_C(-0.1307281291459493), SHI_C(0.5873680453541246),
    SHI_C(-0.6878550219704731), SHI_C(0.4054416537188952), SHI_C(-0.1307281291459493), SHI_C(0.01953125),
    SHI_C(0.3332125126901468), SHI_C(0.3384602766747063), SHI_C(0.3503396702080488),
    SHI_C(0.3729650597455687), SHI_C(0.41975832570891686), SHI_C(0.5799794739346789),
    SHI_C(0.4676500767008183), SHI_C(0.4165517012619427), SHI_C(0.3101412445205158),
    SHI_C(0.13689999147558637), SHI_C(-0.13594928558824104), SHI_C(-0.6887500841864173),
    SHI_C(0.4563797439667157), SHI_C(0.23534953642800108), SHI_C(-0.13435455876499874),
    SHI_C(-0.49510851970963143), SHI_C(-0.5572262544360347), SHI_C(0.4032907544404998),
    SHI_C(0.43552935783159685), SHI_C(-0.04764183952207214), SHI_C(-0.5227282829425685),
    SHI_C(-0.3242569866383592), SHI_C(0.636036888060459), SHI_C(-0.1584741601909983),
    SHI_C(0.4002238600878185), SHI_C(-0.39401846316690065), SHI_C(-0.4078478567647231),
    SHI_C(0.6555375364309216), SHI_C(-0.2950124033243931), SHI_C(0.038323079824899575),
    SHI_C(0.3348513054006444), SHI_C(-0.7064132096745745), SHI_C(0.5687166644377318),
    SHI_C(-0.24930093301108064), SHI_C(0.05695963504460033), SHI_C(-0.004580484140452568),
    SHI_C(0.2255859375), SHI_C(0.3210916115348498), SHI_C(0.327712753728473), SHI_C(0.34046896063984994),
    SHI_C(0.36352137351394465), SHI_C(0.41010741896821795), SHI_C(0.5677680121268567),
    SHI_C(0.3210916115348498), SHI_C(0.43359375), SHI_C(0.3707723731751881), SHI_C(0.2609451018728005),
    SHI_C(0.09287104240600579), SHI_C(-0.1646427610602156), SHI_C(-0.6838127439397529),
    SHI_C(0.327712753728473), SHI_C(0.3707723731751881), SHI_C(0.11669921875), SHI_C(-0.22371382266342774),
    SHI_C(-0.5118449979939587), SHI_C(-0.5041134430506248), SHI_C(0.41874807556621113),
    SHI_C(0.34046896063984994), SHI_C(0.2609451018728005), SHI_C(-0.22371382266342774), SHI_C(-0.525390625),
    SHI_C(-0.19810985037948722), SHI_C(0.6469680498067143), SHI_C(-0.17913734136900075),
    SHI_C(0.36352137351394465), SHI_C(0.09287104240600579), SHI_C(-0.5118449979939587),
    SHI_C(-0.19810985037948722), SHI_C(0.6572265625), SHI_C(-0.35144583567747545),
    SHI_C(0.05033324767520176), SHI_C(0.41010741896821795), SHI_C(-0.1646427610602156),
    SHI_C(-0.5041134430506248), SHI_C(0.6469680498067143), SHI_C(-0.35144583567747545), SHI_C(0.091796875),
    SHI_C(-0.008111937366130932), SHI_C(0.5677680121268567), SHI_C(-0.6838127439397529),
    SHI_C(0.41874807556621113), SHI_C(-0.17913734136900075), SHI_C(0.05033324767520176),
    SHI_C(-0.008111937366130932), SHI_C(0.00048828125), SHI_C(-0.451171875), SHI_C(-0.44527394981164053),
    SHI_C(-0.4327284968965728), SHI_C(-0.411606902650539), SHI_C(-0.3772439575924829),
    SHI_C(-0.31494102773717564), SHI_C(-0.44527394981164053), SHI_C(-0.345703125),
    SHI_C(-0.1537458019148663), SHI_C(0.11374333288754637), SHI_C(0.42195411222921914),
    SHI_C(0.6838127439397529), SHI_C(-0.4327284968965728), SHI_C(-0.1537458019148663), SHI_C(0.2568359375),
    SHI_C(0.5266841578094051), SHI_C(0.3192552937163579), SHI_C(-0.5863645904404216),
    SHI_C(-0.411606902650539), SHI_C(0.11374333288754637), SHI_C(0.5266841578094051), SHI_C(0.1572265625),
    SHI_C(-0.6578502218344809), SHI_C(0.28767847243653455), SHI_C(-0.3772439575924829),
    SHI_C(0.42195411222921914), SHI_C(0.3192552937163579), SHI_C(-0.6578502218344809), SHI_C(0.3720703125),
    SHI_C(-0.08071275769896041), SHI_C(-0.31494102773717564), SHI_C(0.6838127439397529),
    SHI_C(-0.5863645904404216), SHI_C(0.28767847243653455), SHI_C(-0.08071275769896041),
    SHI_C(0.0107421875), SHI_C(0.07271293151947768), SHI_C(0.14842464993721352), SHI_C(0.23130311098294945),
    SHI_C(0.3292855221204312), SHI_C(0.46435521203002894), SHI_C(0.7714448170238041),
    SHI_C(0.21528718442430275), SHI_C(0.392578125), SHI_C(0.49003980202465125), SHI_C(0.4549733315501855),
    SHI_C(0.2016453772202499), SHI_C(-0.5583307674216148), SHI_C(0.34870255998744387),
    SHI_C(0.48401456158383843), SHI_C(0.27404717188285704), SHI_C(-0.23408184791529116),
    SHI_C(-0.6570560409822064), SHI_C(0.28725880996301434), SHI_C(0.46435521203002894),
    SHI_C(0.3412299986626391), SHI_C(-0.3023781926844805), SHI_C(-0.54296875), SHI_C(0.5211093425562566),
    SHI_C(-0.10066649535040352), SHI_C(0.547185319322111), SHI_C(-0.0744624903933916),
    SHI_C(-0.5893083378135775), SHI_C(0.5549212755610587), SHI_C(-0.19834078136318262),
    SHI_C(0.021967230232816392), SHI_C(0.5583307674216148), SHI_C(-0.6838127439397529),
    SHI_C(0.438795080232816), SHI_C(-0.1643876985351626), SHI_C(0.03311684562072885),
    SHI_C(-0.002392079826936697), SHI_C(0.0322265625), SHI_C(0.09777214802323383),
    SHI_C(0.16692864173800467), SHI_C(0.24350992753551057), SHI_C(0.33508120677026226),
    SHI_C(0.4629434161121707), SHI_C(0.7587119201958606), SHI_C(0.09777214802323383), SHI_C(0.279052734375),
    SHI_C(0.4164100890134727), SHI_C(0.4761056429933383), SHI_C(0.41417145645063463),
    SHI_C(0.15605819373554447), SHI_C(-0.5626758194697987), SHI_C(0.16692864173800467),
    SHI_C(0.4164100890134727), SHI_C(0.438232421875), SHI_C(0.169168490257519), SHI_C(-0.3044794790810335),
    SHI_C(-0.6262948451479777), SHI_C(0.3051538078026774), SHI_C(0.24350992753551057),
    SHI_C(0.4761056429933383), SHI_C(0.169168490257519), SHI_C(-0.40478515625), SHI_C(-0.45029618794257004),
    SHI_C(0.5523295183520038), SHI_C(-0.11714425878649873), SHI_C(0.33508120677026226),
    SHI_C(0.41417145645063463), SHI_C(-0.3044794790810335), SHI_C(-0.45029618794257004),
    SHI_C(0.59912109375), SHI_C(-0.24672049987442993), SHI_C(0.02985112124179073),
    SHI_C(0.4629434161121707), SHI_C(0.15605819373554447), SHI_C(-0.6262948451479777),
    SHI_C(0.5523295183520038), SHI_C(-0.24672049987442993), SHI_C(0.055908203125),
    SHI_C(-0.0044013077093066275), SHI_C(0.7587119201958606), SHI_C(-0.5626758194697987),
    SHI_C(0.3051538078026774), SHI_C(-0.11714425878649873), SHI_C(0.02985112124179073),
    SHI_C(-0.0044013077093066275), SHI_C(0.000244140625), SHI_C(-0.12890625), SHI_C(-0.25337986301296467),
    SHI_C(-0.36815240573389746), SHI_C(-0.46568005127581963), SHI_C(-0.5323474991612915),
    SHI_C(-0.5323474991612915), SHI_C(-0.25337986301296467), SHI_C(-0.427734375),
    SHI_C(-0.45121414845245256), SHI_C(-0.26921970218926217), SHI_C(0.1354151016536168),
    SHI_C(0.677075508268084), SHI_C(-0.36815240573389746), SHI_C(-0.45121414845245256), SHI_C(-0.134765625),
    SHI_C(0.3829320604110147), SHI_C(0.5281280336913607), SHI_C(-0.46599532384531833),
    SHI_C(-0.46568005127581963), SHI_C(-0.26921970218926217), SHI_C(0.3829320604110147), SHI_C(0.421875),
    SHI_C(-0.5894426409355918), SHI_C(0.19648088031186392), SHI_C(-0.5323474991612915),
    SHI_C(0.1354151016536168), SHI_C(0.5281280336913607), SHI_C(-0.5894426409355918), SHI_C(0.263671875),
    SHI_C(-0.048828125), SHI_C(-0.5323474991612915), SHI_C(0.677075508268084), SHI_C(-0.46599532384531833),
    SHI_C(0.19648088031186392), SHI_C(-0.048828125), SHI_C(0.005859375), SHI_C(-0.3074218129566329),
    SHI_C(-0.3108956160203436), SHI_C(-0.3184795503863352), SHI_C(-0.3318480940147475),
    SHI_C(-0.35516344310694486), SHI_C(-0.4014726115157063), SHI_C(-0.5567423409670437),
    SHI_C(-0.43236470658687337), SHI_C(-0.39838364181026775), SHI_C(-0.32847213547974063),
    SHI_C(-0.21780190046617978), SHI_C(-0.0555010634311829), SHI_C(0.18821326330232457),
    SHI_C(0.678612571558936), SHI_C(-0.4249309483699303), SHI_C(-0.27693877404913597),
    SHI_C(-0.014846480269053488), SHI_C(0.28960676761644083), SHI_C(0.5153070105080421),
    SHI_C(0.45482644910810605), SHI_C(-0.4315526536043392), SHI_C(-0.411606902650539),
    SHI_C(-0.08325159514677434), SHI_C(0.3401263585622531), SHI_C(0.4910808413705736),
    SHI_C(0.08745006771444902), SHI_C(-0.6480332918680836), SHI_C(0.19800993746085563),
    SHI_C(-0.3904845939068701), SHI_C(0.16673428435381696), SHI_C(0.509231931100859),
    SHI_C(0.012788868021199995), SHI_C(-0.6298998453365656), SHI_C(0.3994322681708115),
    SHI_C(-0.06261624017238017), SHI_C(-0.35710955873299804), SHI_C(0.44139922820051),
    SHI_C(0.2393823416358453), SHI_C(-0.6432686200313908), SHI_C(0.43555891764461224),
    SHI_C(-0.1291298516424652), SHI_C(0.012448778109357385), SHI_C(-0.29759129894416503),
    SHI_C(0.6620988423007649), SHI_C(-0.5984558540896132), SHI_C(0.3216343100156954),
    SHI_C(-0.10537715749466425), SHI_C(0.018989684065068416), SHI_C(-0.0012448778109357384),
    SHI_C(-0.20947265625), SHI_C(-0.29765989046048263), SHI_C(-0.30213623022215325),
    SHI_C(-0.31041546806428333), SHI_C(-0.3242183823181274), SHI_C(-0.3476854804962826),
    SHI_C(-0.39367628467146953), SHI_C(-0.546710125728941), SHI_C(-0.29765989046048263),
    SHI_C(-0.4068603515625), SHI_C(-0.36391209618543363), SHI_C(-0.2898652297541092),
    SHI_C(-0.1798975173291183), SHI_C(-0.02352665791279057), SHI_C(0.20778181666966614),
    SHI_C(0.6732900378401131), SHI_C(-0.30213623022215325), SHI_C(-0.36391209618543363),
    SHI_C(-0.185791015625), SHI_C(0.0699817507661273), SHI_C(0.3371734947145533), SHI_C(0.5099181023924697),
    SHI_C(0.40940679470381547), SHI_C(-0.44220987944028806), SHI_C(-0.31041546806428333),
    SHI_C(-0.2898652297541092), SHI_C(0.0699817507661273), SHI_C(0.4073486328125),
    SHI_C(0.4361716267268865), SHI_C(-0.0075199672027643745), SHI_C(-0.6420073365552852),
    SHI_C(0.2152077452426001), SHI_C(-0.3242183823181274), SHI_C(-0.1798975173291183),
    SHI_C(0.3371734947145533), SHI_C(0.4361716267268865), SHI_C(-0.13818359375), SHI_C(-0.5838399855303429),
    SHI_C(0.43932900265328106), SHI_C(-0.07492571967068562), SHI_C(-0.3476854804962826),
    SHI_C(-0.02352665791279057), SHI_C(0.5099181023924697), SHI_C(-0.0075199672027643745),
    SHI_C(-0.5838399855303429), SHI_C(0.4993896484375), SHI_C(-0.1671048503760762),
    SHI_C(0.017467148463445048), SHI_C(-0.39367628467146953), SHI_C(0.20778181666966614),
    SHI_C(0.40940679470381547), SHI_C(-0.6420073365552852), SHI_C(0.43932900265328106),
    SHI_C(-0.1671048503760762), SHI_C(0.033447265625), SHI_C(-0.0023733181268583473),
    SHI_C(-0.546710125728941), SHI_C(0.6732900378401131), SHI_C(-0.44220987944028806),
    SHI_C(0.2152077452426001), SHI_C(-0.07492571967068562), SHI_C(0.017467148463445048),
    SHI_C(-0.0023733181268583473), SHI_C(0.0001220703125), SHI_C(0.4189453125), SHI_C(0.4148974367736945),
    SHI_C(0.4064292512256359), SHI_C(0.3926479600121577), SHI_C(0.37169141324941796),
    SHI_C(0.339306285779468), SHI_C(0.28231989495348686), SHI_C(0.4148974367736945), SHI_C(0.346435546875),
    SHI_C(0.21308945636308815), SHI_C(0.022873774761468183), SHI_C(-0.2093118259149121),
    SHI_C(-0.4546259651624846), SHI_C(-0.6414171763893822), SHI_C(0.4064292512256359),
    SHI_C(0.21308945636308815), SHI_C(-0.099853515625), SHI_C(-0.3927106491276923),
    SHI_C(-0.47892214576016834), SHI_C(-0.16815157853950086), SHI_C(0.6062791384743805),
    SHI_C(0.3926479600121577), SHI_C(0.022873774761468183), SHI_C(-0.3927106491276923),
    SHI_C(-0.41845703125), SHI_C(0.10677294225083157), SHI_C(0.6173094616875336),
    SHI_C(-0.35143277635949616), SHI_C(0.37169141324941796), SHI_C(-0.2093118259149121),
    SHI_C(-0.47892214576016834), SHI_C(0.10677294225083157), SHI_C(0.56982421875),
    SHI_C(-0.4854084188827522), SHI_C(0.13017755780506604), SHI_C(0.339306285779468),
    SHI_C(-0.4546259651624846), SHI_C(-0.16815157853950086), SHI_C(0.6173094616875336),
    SHI_C(-0.4854084188827522), SHI_C(0.179931640625), SHI_C(-0.029048630881423742),
    SHI_C(0.28231989495348686), SHI_C(-0.6414171763893822), SHI_C(0.6062791384743805),
    SHI_C(-0.35143277635949616), SHI_C(0.13017755780506604), SHI_C(-0.029048630881423742),
    SHI_C(0.003173828125), SHI_C(-0.058097261762847484), SHI_C(-0.11794190764567768),
    SHI_C(-0.18176068675697232), SHI_C(-0.25312379436441274), SHI_C(-0.339306285779468),
    SHI_C(-0.4610264579147936), SHI_C(-0.7469482322128054), SHI_C(-0.1726077671937847),
    SHI_C(-0.32292413190190605), SHI_C(-0.4270695087087198), SHI_C(-0.4571188818230337),
    SHI_C(-0.3755605799168351), SHI_C(-0.11638109588227706), SHI_C(0.5656767784571852),
    SHI_C(-0.28180798175816646), SHI_C(-0.437482016057551), SHI_C(-0.3750436280620985),
    SHI_C(-0.07526503464061599), SHI_C(0.35648134650374186), SHI_C(0.5940298123825668),
    SHI_C(-0.32081276509794054), SHI_C(-0.3811533258158146), SHI_C(-0.40964323385175955),
    SHI_C(-0.01107548459200562), SHI_C(0.46051523295669194), SHI_C(0.35738968834541424),
    SHI_C(-0.5738873206469336), SHI_C(0.13282910411488658), SHI_C(-0.463898924695541),
    SHI_C(-0.20312265248042521), SHI_C(0.43385279709812374), SHI_C(0.29827230784788966),
    SHI_C(-0.6164553198483437), SHI_C(0.2913120475459437), SHI_C(-0.03826860491488222),
    SHI_C(-0.5175864740813926), SHI_C(0.18542476450635262), SHI_C(0.4662379665713912),
    SHI_C(-0.60740303427372), SHI_C(0.323486328125), SHI_C(-0.08193528147472123),
    SHI_C(0.00698685938537802), SHI_C(-0.508959428669202), SHI_C(0.6685584961684895),
    SHI_C(-0.48804529210874026), SHI_C(0.22655408120134224), SHI_C(-0.06601961563959942),
    SHI_C(0.010764359221215138), SHI_C(-0.0006459353786778786), SHI_C(-0.02618408203125),
    SHI_C(-0.07922078790244208), SHI_C(-0.13441384053565325), SHI_C(-0.1937979050602535),
    SHI_C(-0.260764110372212), SHI_C(-0.34235127309753577), SHI_C(-0.4587698292994161),
    SHI_C(-0.7360310321948932), SHI_C(-0.07922078790244208), SHI_C(-0.22894287109375),
    SHI_C(-0.3519946462291138), SHI_C(-0.4286700817965402), SHI_C(-0.4353591060883349),
    SHI_C(-0.33946218116365456), SHI_C(-0.08164841007914406), SHI_C(0.5676375357348944),
    SHI_C(-0.13441384053565325), SHI_C(-0.3519946462291138), SHI_C(-0.42730712890625),
    SHI_C(-0.3049217387440265), SHI_C(0.0065124826332197535), SHI_C(0.39408144000834733),
    SHI_C(0.5614223389213959), SHI_C(-0.33455403583971705), SHI_C(-0.1937979050602535),
    SHI_C(-0.4286700817965402), SHI_C(-0.3049217387440265), SHI_C(0.12091064453125),
    SHI_C(0.48155741518097483), SHI_C(0.2684838288199568), SHI_C(-0.5876246481159815),
    SHI_C(0.14766124989354926), SHI_C(-0.260764110372212), SHI_C(-0.4353591060883349),
    SHI_C(0.0065124826332197535), SHI_C(0.48155741518097483), SHI_C(0.15130615234375),
    SHI_C(-0.6128105829754559), SHI_C(0.33148487801281024), SHI_C(-0.04703173659316891),
    SHI_C(-0.34235127309753577), SHI_C(-0.33946218116365456), SHI_C(0.39408144000834733),
    SHI_C(0.2684838288199568), SHI_C(-0.6128105829754559), SHI_C(0.39044189453125),
    SHI_C(-0.10997049821990883), SHI_C(0.010104037837881882), SHI_C(-0.4587698292994161),
    SHI_C(-0.08164841007914406), SHI_C(0.5614223389213959), SHI_C(-0.5876246481159815),
    SHI_C(0.33148487801281024), SHI_C(-0.10997049821990883), SHI_C(0.01971435546875),
    SHI_C(-0.0012729891122201056), SHI_C(-0.7360310321948932), SHI_C(0.5676375357348944),
    SHI_C(-0.33455403583971705), SHI_C(0.14766124989354926), SHI_C(-0.04703173659316891),
    SHI_C(0.010104037837881882), SHI_C(-0.0012729891122201056), SHI_C(6.103515625e-05),
    SHI_C(0.104736328125), SHI_C(0.2067696700235564), SHI_C(0.30302356320529844),
    SHI_C(0.38948564307572286), SHI_C(0.46003667446804863), SHI_C(0.50316903057893),
    SHI_C(0.48779241888341757), SHI_C(0.2067696700235564), SHI_C(0.365234375), SHI_C(0.43030351350995694),
    SHI_C(0.36422508440437623), SHI_C(0.1434001480037931), SHI_C(-0.22655408120134224),
    SHI_C(-0.6588920813546223), SHI_C(0.30302356320529844), SHI_C(0.43030351350995694),
    SHI_C(0.282958984375), SHI_C(-0.09319906476906367), SHI_C(-0.4623404021301448),
    SHI_C(-0.40579961606642534), SHI_C(0.5057981593970751), SHI_C(0.38948564307572286),
    SHI_C(0.36422508440437623), SHI_C(-0.09319906476906367), SHI_C(-0.484375), SHI_C(-0.180861906029806),
    SHI_C(0.6122976786381156), SHI_C(-0.2543940626495204), SHI_C(0.46003667446804863),
    SHI_C(0.1434001480037931), SHI_C(-0.4623404021301448), SHI_C(-0.180861906029806), SHI_C(0.610595703125),
    SHI_C(-0.37606850032574635), SHI_C(0.08413292809775204), SHI_C(0.50316903057893),
    SHI_C(-0.22655408120134224), SHI_C(-0.40579961606642534), SHI_C(0.6122976786381156),
    SHI_C(-0.37606850032574635), SHI_C(0.119140625), SHI_C(-0.017040945670522605),
    SHI_C(0.48779241888341757), SHI_C(-0.6588920813546223), SHI_C(0.5057981593970751),
    SHI_C(-0.2543940626495204), SHI_C(0.08413292809775204), SHI_C(-0.017040945670522605),
    SHI_C(0.001708984375), SHI_C(0.2868322475216263), SHI_C(0.2892734170499993), SHI_C(0.29448597000911825),
    SHI_C(0.30327852628212976), SHI_C(0.3173919676413941), SHI_C(0.34093366339296705),
    SHI_C(0.38658243724628416), SHI_C(0.5375210658092722), SHI_C(0.40394834339674734),
    SHI_C(0.3799989517881342), SHI_C(0.3310846973421977), SHI_C(0.2548302051726636),
    SHI_C(0.14649116500376397), SHI_C(-0.004034788545175393), SHI_C(-0.22417598874858996),
    SHI_C(-0.6679372780061419), SHI_C(0.3987358883300917), SHI_C(0.2939937969789269),
    SHI_C(0.10229863635764282), SHI_C(-0.13928971533740286), SHI_C(-0.3705763371895693),
    SHI_C(-0.4986790403639875), SHI_C(-0.3676962675793226), SHI_C(0.4511125698993196),
    SHI_C(0.3895683206208762), SHI_C(0.15517261518701916), SHI_C(-0.19016394045597712),
    SHI_C(-0.43714995515444194), SHI_C(-0.37120770160461297), SHI_C(0.08785819408987404),
    SHI_C(0.6309382445457112), SHI_C(-0.23086421787197636), SHI_C(0.37554324061629185),
    SHI_C(-0.028644157129432864), SHI_C(-0.42205711248781647), SHI_C(-0.3286846927857338),
    SHI_C(0.2539450395738432), SHI_C(0.5265829461539954), SHI_C(-0.4718255238142185),
    SHI_C(0.08708585413032799), SHI_C(0.3548550075792854), SHI_C(-0.24359565946994083),
    SHI_C(-0.4413458436801352), SHI_C(0.20261879347603617), SHI_C(0.49112388946794067),
    SHI_C(-0.5435040325942546), SHI_C(0.20437310147934784), SHI_C(-0.023040751274049497),
    SHI_C(0.3234380722040837), SHI_C(-0.46324573850344275), SHI_C(-0.1050106271406714),
    SHI_C(0.5839881896848066), SHI_C(-0.522590193401676), SHI_C(0.23024942986358732),
    SHI_C(-0.05090507668957293), SHI_C(0.0038890459770688454), SHI_C(0.2687605329046361),
    SHI_C(-0.6218157656172929), SHI_C(0.6108093071126828), SHI_C(-0.3774278547018198),
    SHI_C(0.15456205830431868), SHI_C(-0.04058420260175331), SHI_C(0.006042788719252369),
    SHI_C(-0.00033430331878977424)
};
/* Clamped cosine. Per m: the square of rows l = m, m+2, ..., that of m+1, m+3, ..., and (l, l-1), l > m. */
static const SHI_T SHI_FN(shi_clamp)[872] = {
    SHI_C(0.25), SHI_C(0.13975424859373686), SHI_C(-0.03125), SHI_C(0.014084184669781208),
    SHI_C(-0.008052940675034493), SHI_C(0.005221033506622864), SHI_C(-0.003662109375),
    SHI_C(0.0027116460973425085), SHI_C(0.13975424859373686), SHI_C(0.3125), SHI_C(0.1135503269824112),
    SHI_C(-0.025194555463432966), SHI_C(0.011704499799297611), SHI_C(-0.006909448758668814),
    SHI_C(0.004606158095740839), SHI_C(-0.0033073227297708333), SHI_C(-0.03125), SHI_C(0.1135503269824112),
    SHI_C(0.31640625), SHI_C(0.10915243119080437), SHI_C(-0.023152204440724168), SHI_C(0.01051865105065155),
    SHI_C(-0.006154378255208333), SHI_C(0.004094859510633384), SHI_C(0.014084184669781208),
    SHI_C(-0.025194555463432966), SHI_C(0.10915243119080437), SHI_C(0.3173828125),
    SHI_C(0.10774814842187942), SHI_C(-0.0223543360226151), SHI_C(0.009985466865489411),
    SHI_C(-0.005777305799247409), SHI_C(-0.008052940675034493), SHI_C(0.011704499799297611),
    SHI_C(-0.023152204440724168), SHI_C(0.10774814842187942), SHI_C(0.3177642822265625),
    SHI_C(0.10712982703638076), SHI_C(-0.0219647102591517), SHI_C(0.009703446595521662),
    SHI_C(0.005221033506622864), SHI_C(-0.006909448758668814), SHI_C(0.01051865105065155),
    SHI_C(-0.0223543360226151), SHI_C(0.10712982703638076), SHI_C(0.3179512023925781),
    SHI_C(0.10680429626951411), SHI_C(-0.021746066123256365), SHI_C(-0.003662109375),
    SHI_C(0.004606158095740839), SHI_C(-0.006154378255208333), SHI_C(0.009985466865489411),
    SHI_C(-0.0219647102591517), SHI_C(0.10680429626951411), SHI_C(0.3180563449859619),
    SHI_C(0.10661217956934511), SHI_C(0.0027116460973425085), SHI_C(-0.0033073227297708333),
    SHI_C(0.004094859510633384), SHI_C(-0.005777305799247409), SHI_C(0.009703446595521662),
    SHI_C(-0.021746066123256365), SHI_C(0.10661217956934511), SHI_C(0.3181212544441223), SHI_C(0.375),
    SHI_C(0.09547032697824667), SHI_C(-0.014959798558692783), SHI_C(0.005240784322265132),
    SHI_C(-0.0024576283968980304), SHI_C(0.0013519895610218222), SHI_C(-0.000823974609375),
    SHI_C(0.0005395515867661667), SHI_C(0.09547032697824667), SHI_C(0.328125), SHI_C(0.10283161391475143),
    SHI_C(-0.018679337333780518), SHI_C(0.007240029530694556), SHI_C(-0.0036509753316374353),
    SHI_C(0.0021210448620655386), SHI_C(-0.0013486559932851779), SHI_C(-0.014959798558692783),
    SHI_C(0.10283161391475143), SHI_C(0.322265625), SHI_C(0.10453477033418887), SHI_C(-0.01985343790484751),
    SHI_C(0.00800929462859141), SHI_C(-0.0041782249880723986), SHI_C(0.0024975212346585226),
    SHI_C(0.005240784322265132), SHI_C(-0.018679337333780518), SHI_C(0.10453477033418887),
    SHI_C(0.3204345703125), SHI_C(0.10518585304140377), SHI_C(-0.0203684095453341),
    SHI_C(0.008383207734248327), SHI_C(-0.004455727934631057), SHI_C(-0.0024576283968980304),
    SHI_C(0.007240029530694556), SHI_C(-0.01985343790484751), SHI_C(0.10518585304140377),
    SHI_C(0.31963348388671875), SHI_C(0.10550198739076756), SHI_C(-0.02063903847570763),
    SHI_C(0.00859259211195694), SHI_C(0.0013519895610218222), SHI_C(-0.0036509753316374353),
    SHI_C(0.00800929462859141), SHI_C(-0.0203684095453341), SHI_C(0.10550198739076756),
    SHI_C(0.3192129135131836), SHI_C(0.10567897700051579), SHI_C(-0.02079859483616288),
    SHI_C(-0.000823974609375), SHI_C(0.0021210448620655386), SHI_C(-0.0041782249880723986),
    SHI_C(0.008383207734248327), SHI_C(-0.02063903847570763), SHI_C(0.10567897700051579),
    SHI_C(0.3189650774002075), SHI_C(0.10578794060372737), SHI_C(0.0005395515867661667),
    SHI_C(-0.0013486559932851779), SHI_C(0.0024975212346585226), SHI_C(-0.004455727934631057),
    SHI_C(0.00859259211195694), SHI_C(-0.02079859483616288), SHI_C(0.10578794060372737),
    SHI_C(0.31880686059594154), SHI_C(0.28867513459481287), SHI_C(0.25819888974716115),
    SHI_C(0.253546276418555), SHI_C(0.25197631533948484), SHI_C(0.251259453814803),
    SHI_C(0.2508726030021272), SHI_C(0.2506402059138015), SHI_C(0.2504897164340598),
    SHI_C(0.25038669783359574), SHI_C(0.2503130871608794), SHI_C(0.25025866535630953),
    SHI_C(0.2502172968684897), SHI_C(0.25018511664883786), SHI_C(0.2501595914621521),
    SHI_C(0.25013900473690126), SHI_C(0.1875), SHI_C(0.11692679333668567), SHI_C(-0.028969525340217434),
    SHI_C(0.013865811991639726), SHI_C(-0.008243136238346745), SHI_C(0.005491807558204098),
    SHI_C(-0.003930108404275136), SHI_C(0.002955245750095354), SHI_C(0.11692679333668567),
    SHI_C(0.30078125), SHI_C(0.10839403848055944), SHI_C(-0.02377884568681301), SHI_C(0.011015354141569306),
    SHI_C(-0.006513128680801643), SHI_C(0.004357072338275085), SHI_C(-0.003141340082550164),
    SHI_C(-0.028969525340217434), SHI_C(0.10839403848055944), SHI_C(0.3115234375),
    SHI_C(0.10711626449453274), SHI_C(-0.02254269584678302), SHI_C(0.01018208372614344),
    SHI_C(-0.005937242667055174), SHI_C(0.003944098382645249), SHI_C(0.013865811991639726),
    SHI_C(-0.02377884568681301), SHI_C(0.10711626449453274), SHI_C(0.3147125244140625),
    SHI_C(0.10667792548222904), SHI_C(-0.022032262037203095), SHI_C(0.009798566126281424),
    SHI_C(-0.0056498428156851795), SHI_C(-0.008243136238346745), SHI_C(0.011015354141569306),
    SHI_C(-0.02254269584678302), SHI_C(0.10667792548222904), SHI_C(0.3160820007324219),
    SHI_C(0.10647437649388217), SHI_C(-0.021770393573316508), SHI_C(0.009588290176983167),
    SHI_C(0.005491807558204098), SHI_C(-0.006513128680801643), SHI_C(0.01018208372614344),
    SHI_C(-0.022032262037203095), SHI_C(0.10647437649388217), SHI_C(0.31679463386535645),
    SHI_C(0.1063629904649787), SHI_C(-0.021617881741036637), SHI_C(-0.003930108404275136),
    SHI_C(0.004357072338275085), SHI_C(-0.005937242667055174), SHI_C(0.009798566126281424),
    SHI_C(-0.021770393573316508), SHI_C(0.1063629904649787), SHI_C(0.3172125220298767),
    SHI_C(0.10629531972852367), SHI_C(0.002955245750095354), SHI_C(-0.003141340082550164),
    SHI_C(0.003944098382645249), SHI_C(-0.0056498428156851795), SHI_C(0.009588290176983167),
    SHI_C(-0.021617881741036637), SHI_C(0.10629531972852367), SHI_C(0.3174784986767918), SHI_C(0.3125),
    SHI_C(0.09568319307746789), SHI_C(-0.01666463203726683), SHI_C(0.006237781024480981),
    SHI_C(-0.0030604646998437924), SHI_C(0.0017397696305834014), SHI_C(-0.0010870213965435034),
    SHI_C(0.09568319307746789), SHI_C(0.31640625), SHI_C(0.10204961310635259), SHI_C(-0.019099225796492134),
    SHI_C(0.007590284101547585), SHI_C(-0.003906418876176411), SHI_C(0.002307628059549936),
    SHI_C(-0.01666463203726683), SHI_C(0.10204961310635259), SHI_C(0.3173828125),
    SHI_C(0.10395032550202087), SHI_C(-0.0199925950896889), SHI_C(0.008164321995676783),
    SHI_C(-0.004306149497973653), SHI_C(0.006237781024480981), SHI_C(-0.019099225796492134),
    SHI_C(0.10395032550202087), SHI_C(0.3177642822265625), SHI_C(0.10476871136571785),
    SHI_C(-0.02041969142179008), SHI_C(0.008462190597823724), SHI_C(-0.0030604646998437924),
    SHI_C(0.007590284101547585), SHI_C(-0.0199925950896889), SHI_C(0.10476871136571785),
    SHI_C(0.3179512023925781), SHI_C(0.1051951515442241), SHI_C(-0.02065697441187727),
    SHI_C(0.0017397696305834014), SHI_C(-0.003906418876176411), SHI_C(0.008164321995676783),
    SHI_C(-0.02041969142179008), SHI_C(0.1051951515442241), SHI_C(0.3180563449859619),
    SHI_C(0.10544540978699828), SHI_C(-0.0010870213965435034), SHI_C(0.002307628059549936),
    SHI_C(-0.004306149497973653), SHI_C(0.008462190597823724), SHI_C(-0.02065697441187727),
    SHI_C(0.10544540978699828), SHI_C(0.3181212544441223), SHI_C(0.22360679774997896),
    SHI_C(0.23904572186687872), SHI_C(0.2439750182371333), SHI_C(0.24618298195866548),
    SHI_C(0.2473637224590768), SHI_C(0.2480694691784169), SHI_C(0.2485250608738542),
    SHI_C(0.24883630089671974), SHI_C(0.2490583770684494), SHI_C(0.24922239313961342),
    SHI_C(0.24934697319895074), SHI_C(0.24944382578492943), SHI_C(0.24952061317347599),
    SHI_C(0.24958252127842895), SHI_C(0.15625), SHI_C(0.1014873520059889), SHI_C(-0.02634909680318758),
    SHI_C(0.013047255093640027), SHI_C(-0.007951320532350724), SHI_C(0.005397493333686522),
    SHI_C(-0.003919311382764076), SHI_C(0.1014873520059889), SHI_C(0.28125), SHI_C(0.10268544239251104),
    SHI_C(-0.022598508721496356), SHI_C(0.010501219501339013), SHI_C(-0.0062324884583062476),
    SHI_C(0.004186208641472086), SHI_C(-0.02634909680318758), SHI_C(0.10268544239251104),
    SHI_C(0.301513671875), SHI_C(0.10411725449339872), SHI_C(-0.021900790627379263),
    SHI_C(0.009882193965836618), SHI_C(-0.0057595329980374135), SHI_C(0.013047255093640027),
    SHI_C(-0.022598508721496356), SHI_C(0.10411725449339872), SHI_C(0.308685302734375),
    SHI_C(0.10483105514473454), SHI_C(-0.02163378351846284), SHI_C(0.009607771872163473),
    SHI_C(-0.007951320532350724), SHI_C(0.010501219501339013), SHI_C(-0.021900790627379263),
    SHI_C(0.10483105514473454), SHI_C(0.31206321716308594), SHI_C(0.10522360958655295),
    SHI_C(-0.021500460642523415), SHI_C(0.005397493333686522), SHI_C(-0.0062324884583062476),
    SHI_C(0.009882193965836618), SHI_C(-0.02163378351846284), SHI_C(0.10522360958655295),
    SHI_C(0.31392574310302734), SHI_C(0.10546022219391844), SHI_C(-0.003919311382764076),
    SHI_C(0.004186208641472086), SHI_C(-0.0057595329980374135), SHI_C(0.009607771872163473),
    SHI_C(-0.021500460642523415), SHI_C(0.10546022219391844), SHI_C(0.31506239622831345), SHI_C(0.2734375),
    SHI_C(0.09068895911128047), SHI_C(-0.016744558788556883), SHI_C(0.006535364217562338),
    SHI_C(-0.0033075238622993597), SHI_C(0.0019255721228216495), SHI_C(-0.0012260083310355067),
    SHI_C(0.09068895911128047), SHI_C(0.30078125), SHI_C(0.09917039068159131), SHI_C(-0.018965932105722765),
    SHI_C(0.007678870945475868), SHI_C(-0.0040143087211338925), SHI_C(0.002402760232301361),
    SHI_C(-0.016744558788556883), SHI_C(0.09917039068159131), SHI_C(0.308990478515625),
    SHI_C(0.10213633765589672), SHI_C(-0.019849277148046563), SHI_C(0.008186790048666636),
    SHI_C(-0.004357168840256312), SHI_C(0.006535364217562338), SHI_C(-0.018965932105722765),
    SHI_C(0.10213633765589672), SHI_C(0.312530517578125), SHI_C(0.10352981372862166),
    SHI_C(-0.020295983473636408), SHI_C(0.008461105991799408), SHI_C(-0.0033075238622993597),
    SHI_C(0.007678870945475868), SHI_C(-0.019849277148046563), SHI_C(0.10352981372862166),
    SHI_C(0.3143763542175293), SHI_C(0.10429749305865571), SHI_C(-0.020554246615935867),
    SHI_C(0.0019255721228216495), SHI_C(-0.0040143087211338925), SHI_C(0.008186790048666636),
    SHI_C(-0.020295983473636408), SHI_C(0.10429749305865571), SHI_C(0.3154599666595459),
    SHI_C(0.10476581092682431), SHI_C(-0.0012260083310355067), SHI_C(0.002402760232301361),
    SHI_C(-0.004357168840256312), SHI_C(0.008461105991799408), SHI_C(-0.020554246615935867),
    SHI_C(0.10476581092682431), SHI_C(0.31615013675764203), SHI_C(0.18898223650461363),
    SHI_C(0.2182178902359924), SHI_C(0.23028309323591914), SHI_C(0.23652495839563303),
    SHI_C(0.2401922307076307), SHI_C(0.24253562503633297), SHI_C(0.24412603961850166),
    SHI_C(0.24525573579398632), SHI_C(0.2460873954740066), SHI_C(0.24671758189758447),
    SHI_C(0.2472066162365221), SHI_C(0.24759378423606915), SHI_C(0.24790557605364025), SHI_C(0.13671875),
    SHI_C(0.09068895911128047), SHI_C(-0.024168688810087074), SHI_C(0.012226546899950112),
    SHI_C(-0.007578489230929756), SHI_C(0.005214473958899825), SHI_C(-0.0038282097866682505),
    SHI_C(0.09068895911128047), SHI_C(0.26318359375), SHI_C(0.09733528798461707),
    SHI_C(-0.021542648916559298), SHI_C(0.010054002102697223), SHI_C(-0.005991292854545474),
    SHI_C(0.0040398703803643425), SHI_C(-0.024168688810087074), SHI_C(0.09733528798461707),
    SHI_C(0.2904510498046875), SHI_C(0.10086386594025099), SHI_C(-0.021256577801147293),
    SHI_C(0.009599862266657903), SHI_C(-0.005599203584734195), SHI_C(0.012226546899950112),
    SHI_C(-0.021542648916559298), SHI_C(0.10086386594025099), SHI_C(0.30136871337890625),
    SHI_C(0.10264568299068334), SHI_C(-0.02119912055467532), SHI_C(0.00941464962733753),
    SHI_C(-0.007578489230929756), SHI_C(0.010054002102697223), SHI_C(-0.021256577801147293),
    SHI_C(0.10264568299068334), SHI_C(0.30689120292663574), SHI_C(0.10365588849622906),
    SHI_C(-0.02118759330676623), SHI_C(0.005214473958899825), SHI_C(-0.005991292854545474),
    SHI_C(0.009599862266657903), SHI_C(-0.02119912055467532), SHI_C(0.10365588849622906),
    SHI_C(0.31008280813694), SHI_C(0.10428135983941415), SHI_C(-0.0038282097866682505),
    SHI_C(0.0040398703803643425), SHI_C(-0.005599203584734195), SHI_C(0.00941464962733753),
    SHI_C(-0.02118759330676623), SHI_C(0.10428135983941415), SHI_C(0.3120969298761338), SHI_C(0.24609375),
    SHI_C(0.0853808320093531), SHI_C(-0.016355599828558814), SHI_C(0.006568868816400914),
    SHI_C(-0.0034001012057294053), SHI_C(0.0020154730374406576), SHI_C(0.0853808320093531),
    SHI_C(0.28564453125), SHI_C(0.0957568951799578), SHI_C(-0.018612093128686138),
    SHI_C(0.007644105080687562), SHI_C(-0.004045700920063772), SHI_C(-0.016355599828558814),
    SHI_C(0.0957568951799578), SHI_C(0.2996063232421875), SHI_C(0.09982960250652928),
    SHI_C(-0.01956849347086798), SHI_C(0.008137465623515356), SHI_C(0.006568868816400914),
    SHI_C(-0.018612093128686138), SHI_C(0.09982960250652928), SHI_C(0.30617523193359375),
    SHI_C(0.10187926065926786), SHI_C(-0.020074970681451112), SHI_C(-0.0034001012057294053),
    SHI_C(0.007644105080687562), SHI_C(-0.01956849347086798), SHI_C(0.10187926065926786),
    SHI_C(0.3097951412200928), SHI_C(0.10306147750264276), SHI_C(0.0020154730374406576),
    SHI_C(-0.004045700920063772), SHI_C(0.008137465623515356), SHI_C(-0.020074970681451112),
    SHI_C(0.10306147750264276), SHI_C(0.3120035380125046), SHI_C(0.16666666666666666),
    SHI_C(0.20100756305184242), SHI_C(0.2172620473133704), SHI_C(0.22645540682891915),
    SHI_C(0.232210182006412), SHI_C(0.23606684260939012), SHI_C(0.23878346647045964),
    SHI_C(0.2407717061715384), SHI_C(0.24227185592617448), SHI_C(0.24343224778007383),
    SHI_C(0.24434864022973415), SHI_C(0.245085170549213), SHI_C(0.123046875), SHI_C(0.08266963511438942),
    SHI_C(-0.022395827419073224), SHI_C(0.0114955204287016), SHI_C(-0.007212703857875456),
    SHI_C(0.005013425880201436), SHI_C(0.08266963511438942), SHI_C(0.24755859375),
    SHI_C(0.09253747823372736), SHI_C(-0.020595521921560833), SHI_C(0.009653012475680314),
    SHI_C(-0.005774218806882073), SHI_C(-0.022395827419073224), SHI_C(0.09253747823372736),
    SHI_C(0.279632568359375), SHI_C(0.0976409378564292), SHI_C(-0.02063130009349429),
    SHI_C(0.009332348741095618), SHI_C(0.0114955204287016), SHI_C(-0.020595521921560833),
    SHI_C(0.0976409378564292), SHI_C(0.29367828369140625), SHI_C(0.10034075453225594),
    SHI_C(-0.02075256480865203), SHI_C(-0.007212703857875456), SHI_C(0.009653012475680314),
    SHI_C(-0.02063130009349429), SHI_C(0.10034075453225594), SHI_C(0.30118972063064575),
    SHI_C(0.10192928886062745), SHI_C(0.005013425880201436), SHI_C(-0.005774218806882073),
    SHI_C(0.009332348741095618), SHI_C(-0.02075256480865203), SHI_C(0.10192928886062745),
    SHI_C(0.3057004362344742), SHI_C(0.2255859375), SHI_C(0.08056640625), SHI_C(-0.015827505807542618),
    SHI_C(0.006489830451080116), SHI_C(-0.0034167210822150435), SHI_C(0.0020540005799625513),
    SHI_C(0.08056640625), SHI_C(0.27191162109375), SHI_C(0.09232711721066526), SHI_C(-0.018171525263024325),
    SHI_C(0.0075478474816205055), SHI_C(-0.004034643996355012), SHI_C(-0.015827505807542618),
    SHI_C(0.09232711721066526), SHI_C(0.2902069091796875), SHI_C(0.09735952388482746),
    SHI_C(-0.019221438467414743), SHI_C(0.008048117134090354), SHI_C(0.006489830451080116),
    SHI_C(-0.018171525263024325), SHI_C(0.09735952388482746), SHI_C(0.2994060516357422),
    SHI_C(0.1000339336341673), SHI_C(-0.019800055530842457), SHI_C(-0.0034167210822150435),
    SHI_C(0.0075478474816205055), SHI_C(-0.019221438467414743), SHI_C(0.1000339336341673),
    SHI_C(0.3047056496143341), SHI_C(0.10163591480459815), SHI_C(0.0020540005799625513),
    SHI_C(-0.004034643996355012), SHI_C(0.008048117134090354), SHI_C(-0.019800055530842457),
    SHI_C(0.10163591480459815), SHI_C(0.30804372299462557), SHI_C(0.15075567228888181),
    SHI_C(0.18698939800169143), SHI_C(0.20568833780186058), SHI_C(0.21693045781865616),
    SHI_C(0.22429801051997722), SHI_C(0.22941573387056177), SHI_C(0.23312620206007845),
    SHI_C(0.2359071298478354), SHI_C(0.23804761428476168), SHI_C(0.23973165074269207),
    SHI_C(0.24108117612465366), SHI_C(0.11279296875), SHI_C(0.07643200399332753),
    SHI_C(-0.02093782212059415), SHI_C(0.010859563434804683), SHI_C(-0.006876018539990537),
    SHI_C(0.004817058345471408), SHI_C(0.07643200399332753), SHI_C(0.2341461181640625),
    SHI_C(0.0882816095260456), SHI_C(-0.01974604903821194), SHI_C(0.009290566832145786),
    SHI_C(-0.005576320676232924), SHI_C(-0.02093782212059415), SHI_C(0.0882816095260456),
    SHI_C(0.26947784423828125), SHI_C(0.09456248169701174), SHI_C(-0.020035599286710132),
    SHI_C(0.009079500645342593), SHI_C(0.010859563434804683), SHI_C(-0.01974604903821194),
    SHI_C(0.09456248169701174), SHI_C(0.28603971004486084), SHI_C(0.09802904223365949),
    SHI_C(-0.0203082234168508), SHI_C(-0.006876018539990537), SHI_C(0.009290566832145786),
    SHI_C(-0.020035599286710132), SHI_C(0.09802904223365949), SHI_C(0.295301154255867),
    SHI_C(0.1001362439062678), SHI_C(0.004817058345471408), SHI_C(-0.005576320676232924),
    SHI_C(0.009079500645342593), SHI_C(-0.0203082234168508), SHI_C(0.1001362439062678),
    SHI_C(0.30104272929020226), SHI_C(0.20947265625), SHI_C(0.07633906136745099),
    SHI_C(-0.0152740478515625), SHI_C(0.0063615884472875825), SHI_C(-0.0033938191245671137),
    SHI_C(0.07633906136745099), SHI_C(0.2596588134765625), SHI_C(0.08906223826202615),
    SHI_C(-0.017704010009765625), SHI_C(0.007420948520683811), SHI_C(-0.0152740478515625),
    SHI_C(0.08906223826202615), SHI_C(0.28118133544921875), SHI_C(0.09488164587573808),
    SHI_C(-0.01884548600420681), SHI_C(0.0063615884472875825), SHI_C(-0.017704010009765625),
    SHI_C(0.09488164587573808), SHI_C(0.29258430004119873), SHI_C(0.09811350207634846),
    SHI_C(-0.0033938191245671137), SHI_C(0.007420948520683811), SHI_C(-0.01884548600420681),
    SHI_C(0.09811350207634846), SHI_C(0.2993973344564438), SHI_C(0.1386750490563073),
    SHI_C(0.17541160386140583), SHI_C(0.19553847221876072), SHI_C(0.20819138611089075),
    SHI_C(0.21677749238103), SHI_C(0.22291128503014113), SHI_C(0.2274623714700579),
    SHI_C(0.2309401076758503), SHI_C(0.23366150977305888), SHI_C(0.2358333153182891), SHI_C(0.104736328125),
    SHI_C(0.07140865321622805), SHI_C(-0.019718710986092246), SHI_C(0.010306951289214475),
    SHI_C(-0.006572102474744333), SHI_C(0.07140865321622805), SHI_C(0.222564697265625),
    SHI_C(0.08450582698602976), SHI_C(-0.018982627754766022), SHI_C(0.008961646735608859),
    SHI_C(-0.019718710986092246), SHI_C(0.08450582698602976), SHI_C(0.26009273529052734),
    SHI_C(0.09166924993489528), SHI_C(-0.0194736688710137), SHI_C(0.010306951289214475),
    SHI_C(-0.018982627754766022), SHI_C(0.09166924993489528), SHI_C(0.27865171432495117),
    SHI_C(0.09576891945897358), SHI_C(-0.006572102474744333), SHI_C(0.008961646735608859),
    SHI_C(-0.0194736688710137), SHI_C(0.09576891945897358), SHI_C(0.28941742330789566),
    SHI_C(0.196380615234375), SHI_C(0.07264258735218454), SHI_C(-0.014737298507753172),
    SHI_C(0.006213307192900079), SHI_C(-0.003349954825720339), SHI_C(0.07264258735218454),
    SHI_C(0.248748779296875), SHI_C(0.08601934299364053), SHI_C(-0.01723759916301536),
    SHI_C(0.00727979585525676), SHI_C(-0.014737298507753172), SHI_C(0.08601934299364053),
    SHI_C(0.2726733684539795), SHI_C(0.09247039401367821), SHI_C(-0.01846102412251098),
    SHI_C(0.006213307192900079), SHI_C(-0.01723759916301536), SHI_C(0.09247039401367821),
    SHI_C(0.2858966588973999), SHI_C(0.09618554147337921), SHI_C(-0.003349954825720339),
    SHI_C(0.00727979585525676), SHI_C(-0.01846102412251098), SHI_C(0.09618554147337921),
    SHI_C(0.29404173558577895), SHI_C(0.12909944487358058), SHI_C(0.16568337391590282),
    SHI_C(0.1866272256725398), SHI_C(0.20025046972870356), SHI_C(0.20975189918866174),
    SHI_C(0.21669453555438456), SHI_C(0.22194427061597977), SHI_C(0.22602116787360346),
    SHI_C(0.2292561846935535), SHI_C(0.0981903076171875), SHI_C(0.06725396747013578),
    SHI_C(-0.018682935805547717), SHI_C(0.009824101265935711), SHI_C(-0.00629908592037179),
    SHI_C(0.06725396747013578), SHI_C(0.21247291564941406), SHI_C(0.08114204281783985),
    SHI_C(-0.018294114530200637), SHI_C(0.00866211561653764), SHI_C(-0.018682935805547717),
    SHI_C(0.08114204281783985), SHI_C(0.25146543979644775), SHI_C(0.08896950843921667),
    SHI_C(-0.018946216995920744), SHI_C(0.009824101265935711), SHI_C(-0.018294114530200637),
    SHI_C(0.08896950843921667), SHI_C(0.2716018259525299), SHI_C(0.09358973029766669),
    SHI_C(-0.00629908592037179), SHI_C(0.00866211561653764), SHI_C(-0.018946216995920744),
    SHI_C(0.09358973029766669), SHI_C(0.2836463206913322), SHI_C(0.1854705810546875),
    SHI_C(0.06939673696325264), SHI_C(-0.01423228991152055), SHI_C(0.006059179094378998),
    SHI_C(0.06939673696325264), SHI_C(0.23900413513183594), SHI_C(0.08320680105960798),
    SHI_C(-0.01678553519858409), SHI_C(-0.01423228991152055), SHI_C(0.08320680105960798),
    SHI_C(0.2647191286087036), SHI_C(0.0901600863905795), SHI_C(0.006059179094378998),
    SHI_C(-0.01678553519858409), SHI_C(0.0901600863905795), SHI_C(0.27943751215934753),
    SHI_C(0.12126781251816648), SHI_C(0.15737789507292674), SHI_C(0.17875929966870285),
    SHI_C(0.19304683562633607), SHI_C(0.20323471117426511), SHI_C(0.21081851067789195),
    SHI_C(0.2166445612065605), SHI_C(0.2212312597720623), SHI_C(0.09273529052734375),
    SHI_C(0.0637449732652911), SHI_C(-0.01779036238940069), SHI_C(0.009399054390481726),
    SHI_C(0.0637449732652911), SHI_C(0.2035961151123047), SHI_C(0.07812877886136893),
    SHI_C(-0.01767051413554442), SHI_C(-0.01779036238940069), SHI_C(0.07812877886136893),
    SHI_C(0.24354159832000732), SHI_C(0.08645715098192894), SHI_C(0.009399054390481726),
    SHI_C(-0.01767051413554442), SHI_C(0.08645715098192894), SHI_C(0.26492127776145935),
    SHI_C(0.17619705200195312), SHI_C(0.06652739257887458), SHI_C(-0.013763119227733307),
    SHI_C(0.005906284421763836), SHI_C(0.06652739257887458), SHI_C(0.23025751113891602),
    SHI_C(0.08061382055500235), SHI_C(-0.016353761039668253), SHI_C(-0.013763119227733307),
    SHI_C(0.08061382055500235), SHI_C(0.2573069930076599), SHI_C(0.0879644851756816),
    SHI_C(0.005906284421763836), SHI_C(-0.016353761039668253), SHI_C(0.0879644851756816),
    SHI_C(0.2732509057968855), SHI_C(0.11470786693528089), SHI_C(0.15018785229652767),
    SHI_C(0.17176468085745134), SHI_C(0.18650096164806276), SHI_C(0.19720265943665385),
    SHI_C(0.20529392068381325), SHI_C(0.21159387716633613), SHI_C(0.08809852600097656),
    SHI_C(0.060730922679085655), SHI_C(-0.017011670665738828), SHI_C(0.009021998479557087),
    SHI_C(0.060730922679085655), SHI_C(0.1957188844680786), SHI_C(0.07541385277898272),
    SHI_C(-0.017103172681725964), SHI_C(-0.017011670665738828), SHI_C(0.07541385277898272),
    SHI_C(0.23625460267066956), SHI_C(0.08412009105936406), SHI_C(0.009021998479557087),
    SHI_C(-0.017103172681725964), SHI_C(0.08412009105936406), SHI_C(0.2586124644149095),
    SHI_C(0.16818809509277344), SHI_C(0.06397250943481662), SHI_C(-0.013329359898287702),
    SHI_C(0.06397250943481662), SHI_C(0.22236406803131104), SHI_C(0.07822276171496723),
    SHI_C(-0.013329359898287702), SHI_C(0.07822276171496723), SHI_C(0.25040504336357117),
    SHI_C(0.1091089451179962), SHI_C(0.14388861576723855), SHI_C(0.16550318531021113),
    SHI_C(0.18053418676968802), SHI_C(0.19161876796126628), SHI_C(0.20011120378952102),
    SHI_C(0.08409404754638672), SHI_C(0.058105917252848305), SHI_C(-0.016325065174360574),
    SHI_C(0.058105917252848305), SHI_C(0.18867254257202148), SHI_C(0.07295392234578744),
    SHI_C(-0.016325065174360574), SHI_C(0.07295392234578744), SHI_C(0.2295379564166069),
    SHI_C(0.1611802577972412), SHI_C(0.061681666006869744), SHI_C(-0.012928783298868733),
    SHI_C(0.061681666006869744), SHI_C(0.2152022123336792), SHI_C(0.0760144093058307),
    SHI_C(-0.012928783298868733), SHI_C(0.0760144093058307), SHI_C(0.24397402303293347),
    SHI_C(0.10425720702853739), SHI_C(0.13831281496162492), SHI_C(0.15986105077709065),
    SHI_C(0.1750752438129634), SHI_C(0.1864426061386177), SHI_C(0.0805901288986206),
    SHI_C(0.055793166160583496), SHI_C(-0.015714045138673614), SHI_C(0.055793166160583496),
    SHI_C(0.1823240965604782), SHI_C(0.07071320312403126), SHI_C(-0.015714045138673614),
    SHI_C(0.07071320312403126), SHI_C(0.2233300672378391), SHI_C(0.15498101711273193),
    SHI_C(0.05961416565209959), SHI_C(0.05961416565209959), SHI_C(0.20867086946964264), SHI_C(0.1),
    SHI_C(0.13333333333333333), SHI_C(0.15474611514754322), SHI_C(0.17006182216855167),
    SHI_C(0.07749050855636597), SHI_C(0.05373548275066231), SHI_C(0.05373548275066231),
    SHI_C(0.1765676587820053), SHI_C(0.14944598078727722), SHI_C(0.05773708857721931),
    SHI_C(0.05773708857721931), SHI_C(0.20268611144274473), SHI_C(0.09622504486493763),
    SHI_C(0.12885189058084473), SHI_C(0.15008340284214078), SHI_C(0.07472299039363861),
    SHI_C(0.05188930501367126), SHI_C(0.05188930501367126), SHI_C(0.17131802276708186),
    SHI_C(0.14446444809436798), SHI_C(0.09284766908852593), SHI_C(0.12479126063921447),
    SHI_C(0.07223222404718399), SHI_C(0.13994993409141898), SHI_C(0.08980265101338746),
    SHI_C(0.06997496704570949)
};
/* Gauss-Legendre, the positive nodes of 4/8/16 pairs: z, */
static const SHI_T SHI_FN(shi_node_z)[28] = {
    SHI_C(0.9602898564975363), SHI_C(0.7966664774136267), SHI_C(0.525532409916329),
    SHI_C(0.1834346424956498), SHI_C(0.9894009349916499), SHI_C(0.9445750230732326),
    SHI_C(0.8656312023878318), SHI_C(0.755404408355003), SHI_C(0.6178762444026438),
    SHI_C(0.45801677765722737), SHI_C(0.2816035507792589), SHI_C(0.09501250983763744),
    SHI_C(0.9972638618494816), SHI_C(0.9856115115452684), SHI_C(0.9647622555875064),
    SHI_C(0.9349060759377397), SHI_C(0.8963211557660521), SHI_C(0.84936761373257),
    SHI_C(0.7944837959679424), SHI_C(0.7321821187402897), SHI_C(0.6630442669302152),
    SHI_C(0.5877157572407623), SHI_C(0.5068999089322294), SHI_C(0.42135127613063533),
    SHI_C(0.33186860228212767), SHI_C(0.23928736225213706), SHI_C(0.1444719615827965),
    SHI_C(0.04830766568773832)
};
/* sqrt(1 - z^2), */
static const SHI_T SHI_FN(shi_node_s)[28] = {
    SHI_C(0.2790042858236075), SHI_C(0.6044191623082141), SHI_C(0.8507735809999836),
    SHI_C(0.9830319078913426), SHI_C(0.14520946882916727), SHI_C(0.32829563778125675),
    SHI_C(0.5006821561156306), SHI_C(0.6552588647533338), SHI_C(0.7862753630903645),
    SHI_C(0.8889435479176897), SHI_C(0.9595308437921698), SHI_C(0.9954760785545541),
    SHI_C(0.07392421693232977), SHI_C(0.16902647221500952), SHI_C(0.26312314644232065),
    SHI_C(0.35489523690054975), SHI_C(0.4434054416966582), SHI_C(0.5278017210489558),
    SHI_C(0.6072853513335957), SHI_C(0.6811089083230232), SHI_C(0.748580189486052),
    SHI_C(0.809067480925366), SHI_C(0.8620049201277784), SHI_C(0.9068975146636389),
    SHI_C(0.943325622899806), SHI_C(0.970948792813717), SHI_C(0.989508894511019), SHI_C(0.9988325031935043)
};
/* and weight. */
static const SHI_T SHI_FN(shi_node_w)[28] = {
    SHI_C(0.10122853629037626), SHI_C(0.22238103445337448), SHI_C(0.31370664587788727),
    SHI_C(0.362683783378362), SHI_C(0.027152459411754096), SHI_C(0.062253523938647894),
    SHI_C(0.09515851168249279), SHI_C(0.12462897125553388), SHI_C(0.14959598881657674),
    SHI_C(0.16915651939500254), SHI_C(0.18260341504492358), SHI_C(0.1894506104550685),
    SHI_C(0.007018610009470096), SHI_C(0.01627439473090567), SHI_C(0.02539206530926206),
    SHI_C(0.03427386291302143), SHI_C(0.04283589802222668), SHI_C(0.050998059262376175),
    SHI_C(0.058684093478535544), SHI_C(0.06582222277636185), SHI_C(0.0723457941088485),
    SHI_C(0.07819389578707031), SHI_C(0.08331192422694675), SHI_C(0.08765209300440381),
    SHI_C(0.09117387869576389), SHI_C(0.09384439908080457), SHI_C(0.09563872007927486),
    SHI_C(0.0965400885147278)
};
/* END tools/gen_product.py */

/* ================================================================================================================
 * Kernels: once per lane type. Lanes are coefficient vectors; in the triple product they are nodes of the
 * quadrature. A band is passed by its middle element: d[m], m = -l..l.
 * ============================================================================================================= */
#elif SHI_ROOM == SHI_KERNELS

/* Turn band l about z by the angle whose multiples' cosines and sines are c[m], s[m]. */
SHI_INLINE void SHI_KN(shi_prod_turn)(int l, SHI_V *d, const SHI_V *c, const SHI_V *s)
{
    int m;
    for (m = 1; m <= l; m++) {
        const SHI_V p = d[m], q = d[-m];
        d[m] = c[m] * p - s[m] * q;
        d[-m] = s[m] * p + c[m] * q;
    }
}

/* ... and back by it: a function of its own, or other products would be fused. */
SHI_INLINE void SHI_KN(shi_prod_turn_back)(int l, SHI_V *d, const SHI_V *c, const SHI_V *s)
{
    int m;
    for (m = 1; m <= l; m++) {
        const SHI_V p = d[m], q = d[-m];
        d[m] = c[m] * p + s[m] * q;
        d[-m] = c[m] * q - s[m] * p;
    }
}

/* d = k d in place: n <= 8 elements of d a step apart. */
SHI_KERNEL void SHI_KN(shi_prod_square_of)(const int n, const SHI_T *k, SHI_V *d, int step)
{
    SHI_V v[SH_PRODUCT_BANDS / 2];
    int i, j;

    SHI_UNROLL
    for (j = 0; j < n; j++) v[j] = d[j * step];
    SHI_UNROLL
    for (i = 0; i < n; i++) {
        SHI_V a = k[i * n] * v[0];
        SHI_UNROLL
        for (j = 1; j < n; j++) a += k[i * n + j] * v[j];
        d[i * step] = a;
    }
}

SHI_NOINLINE void SHI_KN(shi_prod_square)(int n, const SHI_T *k, SHI_V *d, int step)
{
    switch (n) {
        SHI_CASES_1_TO_8(SHI_KN(shi_prod_square_of), k, d, step)
    default: break;
    }
}

/* p = k q and q = k^T p at once: n <= 8 elements each, of p upwards and of q downwards by 2 */
SHI_KERNEL void SHI_KN(shi_prod_exchange_of)(const int n, const SHI_T *k, SHI_V *p, SHI_V *q)
{
    SHI_V a[SH_PRODUCT_BANDS / 2], b[SH_PRODUCT_BANDS / 2];
    int i, j;

    SHI_UNROLL
    for (j = 0; j < n; j++) { a[j] = p[2 * j]; b[j] = q[-2 * j]; }
    SHI_UNROLL
    for (i = 0; i < n; i++) {
        SHI_V s = k[i * n] * b[0], t = k[i] * a[0];
        SHI_UNROLL
        for (j = 1; j < n; j++) {
            s += k[i * n + j] * b[j];
            t += k[j * n + i] * a[j];
        }
        p[2 * i] = s;
        q[-2 * i] = t;
    }
}

/* Exchange y and z in band l, k its part of the table. A basis function is even or odd in x, y and z; the swap keeps x and
 * exchanges the other two, so of the classes cos even m, cos odd m, sin even m, sin odd m two map to themselves and two to
 * each other. */
SHI_NOINLINE void SHI_KN(shi_prod_swap)(int l, const SHI_T *k, SHI_V *d)
{
    const int half = (l + 1) / 2;
    SHI_V *p, *q;

    if (l % 2 == 0) {
        SHI_KN(shi_prod_square)(half + 1, k, d, 2);
        k += (half + 1) * (half + 1);
        SHI_KN(shi_prod_square)(half, k, d - 1, -2);
        k += half * half;
        p = d + 1;
        q = d - 2;
    } else {
        SHI_KN(shi_prod_square)(half, k, d + 1, 2);
        k += half * half;
        SHI_KN(shi_prod_square)(half - 1, k, d - 2, -2);
        k += (half - 1) * (half - 1);
        p = d;
        q = d - 1;
    }
    switch (half) {
        SHI_CASES_1_TO_8(SHI_KN(shi_prod_exchange_of), k, p, q)
    default: break;
    }
}

/* Multiply by max(0, z) in column m, of s rows l = m, m+1, ...: a row meets the rows of its parity through a square of k, and
 * its two neighbours; sign picks the cosines (1) or the sines (-1). */
SHI_KERNEL void SHI_KN(shi_prod_column_of)(const int s, int m, int sign, const SHI_T *k, SHI_V *d)
{
    const int even = (SH_PRODUCT_BANDS - m + 1) / 2, odd = (SH_PRODUCT_BANDS - m) / 2;
    const SHI_T *const k1 = k + even * even, *const e = k1 + odd * odd;
    SHI_V v[SH_PRODUCT_BANDS];
    int at[SH_PRODUCT_BANDS], i, j;

    SHI_UNROLL
    for (i = 0; i < s; i++) {
        at[i] = (m + i) * (m + i + 1) + sign * m;
        v[i] = d[at[i]];
    }
    SHI_UNROLL
    for (i = 0; i < s; i += 2) {
        SHI_V a = k[i / 2 * even] * v[0];
        SHI_UNROLL
        for (j = 2; j < s; j += 2) a += k[i / 2 * even + j / 2] * v[j];
        if (i > 0) a += e[i - 1] * v[i - 1];
        if (i + 1 < s) a += e[i] * v[i + 1];
        d[at[i]] = a;
    }
    SHI_UNROLL
    for (i = 1; i < s; i += 2) {
        SHI_V a = k1[i / 2 * odd] * v[1];
        SHI_UNROLL
        for (j = 3; j < s; j += 2) a += k1[i / 2 * odd + j / 2] * v[j];
        a += e[i - 1] * v[i - 1];
        if (i + 1 < s) a += e[i] * v[i + 1];
        d[at[i]] = a;
    }
}

SHI_NOINLINE void SHI_KN(shi_prod_column)(int s, int m, int sign, const SHI_T *k, SHI_V *d)
{
    switch (s) {
        SHI_CASES_1_TO_8(SHI_KN(shi_prod_column_of), m, sign, k, d)
        SHI_CASES_9_TO_16(SHI_KN(shi_prod_column_of), m, sign, k, d)
    default: break;
    }
}

/* All columns, k the table from column 0 on. */
SHI_INLINE void SHI_KN(shi_prod_clamp)(int bands, const SHI_T *k, SHI_V *d)
{
    int m;
    for (m = 0; m < bands; m++) {
        const int even = (SH_PRODUCT_BANDS - m + 1) / 2, odd = (SH_PRODUCT_BANDS - m) / 2;
        SHI_KN(shi_prod_column)(bands - m, m, 1, k, d);
        if (m) SHI_KN(shi_prod_column)(bands - m, m, -1, k, d);
        k += even * even + odd * odd + SH_PRODUCT_BANDS - 1 - m;
    }
}

/* Cosine and sine of m times the angle of (c, s), m < bands. */
SHI_INLINE void SHI_KN(shi_prod_multiples)(int bands, const SHI_V *c, const SHI_V *s, SHI_V *cm, SHI_V *sm)
{
    int m;
    sm[0] = SHI_SPLAT(0);
    cm[0] = sm[0] + SHI_C(1);
    if (bands > 1) { cm[1] = *c; sm[1] = *s; }
    for (m = 2; m < bands; m++) {               /* from halves: the error grows with log m, not with m */
        const int a = m / 2, b = m - a;
        cm[m] = cm[a] * cm[b] - sm[a] * sm[b];
        sm[m] = cm[a] * sm[b] + sm[a] * cm[b];
    }
}

/* f times the clamped cosine about a normal per lane: turn the normal to +z (Rz then Ry = swap Rz swap), multiply, back. */
SHI_INLINE void SHI_KN(shi_prod_cosine)(int bands, const SHI_T *swap, const SHI_T *clamp, const SHI_V n[3], SHI_V *d)
{
    SHI_V ca[SH_PRODUCT_BANDS], sa[SH_PRODUCT_BANDS], cb[SH_PRODUCT_BANDS], sb[SH_PRODUCT_BANDS];
    const SHI_T least = SHI_BITS == 32 ? SHI_C(1e-30) : SHI_C(1e-280 * (SHI_BITS == 64));
    SHI_V zero, one, x, y, z, big, scale, s2, s, r, c;
    const SHI_T *k = swap;
    int l;

    zero = SHI_SPLAT(0);
    one = zero + SHI_C(1);
    x = SHI_ABS(n[0]); y = SHI_ABS(n[1]); z = SHI_ABS(n[2]);
    big = SHI_SELECT(x > y, x, y);
    big = SHI_SELECT(z > big, z, big);
    scale = one / big;
    x = n[0] * scale; y = n[1] * scale; z = n[2] * scale;
    s2 = x * x + y * y;
    s = SHI_SQRT(s2);
    r = one / SHI_SQRT(s2 + z * z);
    c = one / SHI_SELECT(s2 > zero + least, s, one);
    x = SHI_SELECT(s2 > zero + least, x * c, one);      /* at the pole any azimuth will do, next to it s has no digits left */
    y = SHI_SELECT(s2 > zero + least, y * c, zero);
    z = z * r; s = s * r;
    SHI_KN(shi_prod_multiples)(bands, &x, &y, ca, sa);
    SHI_KN(shi_prod_multiples)(bands, &z, &s, cb, sb);

    for (l = 1; l < bands; l++) {
        SHI_V *e = d + l * (l + 1);
        k += shi_swap_size(l - 1);
        SHI_KN(shi_prod_turn_back)(l, e, ca, sa);
        SHI_KN(shi_prod_swap)(l, k, e);
        SHI_KN(shi_prod_turn)(l, e, cb, sb);         /* Ry(-b) = swap Rz(b) swap */
        SHI_KN(shi_prod_swap)(l, k, e);
    }
    SHI_KN(shi_prod_clamp)(bands, clamp, d);
    for (k = swap, l = 1; l < bands; l++) {
        SHI_V *e = d + l * (l + 1);
        k += shi_swap_size(l - 1);
        SHI_KN(shi_prod_swap)(l, k, e);
        SHI_KN(shi_prod_turn_back)(l, e, cb, sb);
        SHI_KN(shi_prod_swap)(l, k, e);
        SHI_KN(shi_prod_turn)(l, e, ca, sa);
    }
}

/* angle[6][SH_PRODUCT_BANDS], as in sh_rotation: about z, y (as swap Rz back swap), z, the last angle first. */
SHI_INLINE void SHI_KN(shi_prod_rotate)(int bands, const SHI_T *swap, const SHI_V *angle, SHI_V *d)
{
    int l;
    for (l = 1; l < bands; l++) {
        SHI_V *e = d + l * (l + 1);
        swap += shi_swap_size(l - 1);
        SHI_KN(shi_prod_turn)(l, e, angle + 4 * SH_PRODUCT_BANDS, angle + 5 * SH_PRODUCT_BANDS);
        SHI_KN(shi_prod_swap)(l, swap, e);
        SHI_KN(shi_prod_turn_back)(l, e, angle + 2 * SH_PRODUCT_BANDS, angle + 3 * SH_PRODUCT_BANDS);
        SHI_KN(shi_prod_swap)(l, swap, e);
        SHI_KN(shi_prod_turn)(l, e, angle, angle + SH_PRODUCT_BANDS);
    }
}

SHI_INLINE void SHI_KN(shi_prod_swap_bands)(int bands, const SHI_T *swap, SHI_V *d)
{
    int l;
    for (l = 1; l < bands; l++) {
        swap += shi_swap_size(l - 1);
        SHI_KN(shi_prod_swap)(l, swap, d + l * (l + 1));
    }
}

/* Complex Fourier coefficients in azimuth of a function at height z: re[m], im[m], m = -(bands-1) .. bands-1, and at -z:
 * 2 SH_PRODUCT_BANDS further on. y holds Y_lm at azimuth 0, m >= 0, elements SH_BLOCK apart. */
SHI_INLINE void SHI_KN(shi_prod_fourier)(int bands, const SHI_T *y, const SHI_T *c, SHI_V *re, SHI_V *im)
{
    const int other = 2 * SH_PRODUCT_BANDS;
    int l, m;

    for (m = 0; m < bands; m++) {
        const SHI_T half = m ? SHI_C(0.5) : SHI_C(1);
        SHI_V e, o, f, g;
        e = SHI_SPLAT(0);
        o = f = g = e;
        for (l = m; l < bands; l += 2) {
            const SHI_V t = SHI_LOAD(y + (l * (l + 1) + m) * SH_BLOCK);
            e += c[l * (l + 1) + m] * t;
            f += c[l * (l + 1) - m] * t;
        }
        for (l = m + 1; l < bands; l += 2) {
            const SHI_V t = SHI_LOAD(y + (l * (l + 1) + m) * SH_BLOCK);
            o += c[l * (l + 1) + m] * t;
            g += c[l * (l + 1) - m] * t;
        }
        re[m] = half * (e + o);
        re[other + m] = half * (e - o);
        if (m) {
            re[-m] = re[m];
            re[other - m] = re[other + m];
            im[-m] = half * (f + g);
            im[other - m] = half * (f - g);
            im[m] = -im[-m];
            im[other + m] = -im[other - m];
        } else {
            im[0] = SHI_SPLAT(0);
            im[other] = im[0];
        }
    }
}

/* Product by sampling: exact, because pairs of Gauss nodes integrate the polynomial of degree na + nb + n - 3 in z, and in
 * azimuth the product of the two Fourier series is formed instead of sampled. Its terms t at +z and u at -z, real and
 * imaginary, become their sum and difference: for the rows even and odd in z. */
SHI_INLINE void SHI_KN(shi_prod_triple)(int pairs, int na, int nb, int n, int stride, const SHI_T *y, const SHI_T *weight,
                                        const SHI_T *a, const SHI_T *b, SHI_T *out)
{
    SHI_V sum[SH_PRODUCT_BANDS * SH_PRODUCT_BANDS];
    SHI_V ar[4 * SH_PRODUCT_BANDS], ai[4 * SH_PRODUCT_BANDS];
    SHI_V br[4 * SH_PRODUCT_BANDS], bi[4 * SH_PRODUCT_BANDS];
    const int other = 2 * SH_PRODUCT_BANDS, mid = SH_PRODUCT_BANDS;
    int g, i, j, l, m;

    for (g = 0; g < pairs; g += SHI_W) {
        const SHI_T *at = y + (size_t)(g / SH_BLOCK) * (size_t)stride * SH_BLOCK + g % SH_BLOCK;
        const SHI_V w = SHI_C(SHI_TAU) * SHI_LOAD(weight + g);

        SHI_KN(shi_prod_fourier)(na, at, a, ar + mid, ai + mid);
        SHI_KN(shi_prod_fourier)(nb, at, b, br + mid, bi + mid);
        for (m = 0; m < n; m++) {
            const int first = m - nb + 1 > 1 - na ? m - nb + 1 : 1 - na;
            const int last = m + nb - 1 < na - 1 ? m + nb - 1 : na - 1;
            SHI_V tr, ti, ur, ui, t;
            tr = SHI_SPLAT(0);
            ti = ur = ui = tr;
            for (j = first; j <= last; j++) {
                const int p = mid + j, q = mid + m - j;
                tr += ar[p] * br[q] - ai[p] * bi[q];
                ti += ar[p] * bi[q] + ai[p] * br[q];
                ur += ar[other + p] * br[other + q] - ai[other + p] * bi[other + q];
                ui += ar[other + p] * bi[other + q] + ai[other + p] * br[other + q];
            }
            t = w * (tr + ur); ur = w * (tr - ur); tr = t;
            t = w * (ti + ui); ui = w * (ti - ui); ti = t;
            for (l = m; l < n; l++) {
                const int k = l * (l + 1);
                const int odd = (l - m) & 1;
                t = SHI_LOAD(at + (k + m) * SH_BLOCK);
                if (g == 0) sum[k + m] = SHI_SPLAT(0);
                sum[k + m] += t * (odd ? ur : tr);
                if (m == 0) continue;
                if (g == 0) sum[k - m] = SHI_SPLAT(0);
                sum[k - m] -= t * (odd ? ui : ti);
            }
        }
    }
    for (i = 0; i < n * n; i++) out[i] = SHI_SUM(sum[i]);
}

/* ---- from arrays to lanes and back ---- */

/* a[i] lane j <-> a[j] lane i */
SHI_KERNEL void SHI_KN(shi_prod_mirror_lanes)(SHI_V *a)
{
#if SHI_LANES > 1
    SHI_V b[SHI_W];
    int i, step;
    SHI_UNROLL
    for (step = 1; step < SHI_W; step *= 2) {               /* a perfect shuffle per step */
        SHI_UNROLL
        for (i = 0; i < SHI_W / 2; i++) SHI_KN(shi_zip)(a[i], a[i + SHI_W / 2], &b[2 * i], &b[2 * i + 1]);
        SHI_UNROLL
        for (i = 0; i < SHI_W; i++) a[i] = b[i];
    }
#else
    (void)a;
#endif
}

/* SHI_W vectors of n numbers from the first on: plain [count][n], or blocks [n][SH_BLOCK], which have no rest. Lanes past the
 * end repeat the last vector. */
SHI_INLINE void SHI_KN(shi_prod_enter)(int n, int plain, size_t first, size_t count, const SHI_T *in, SHI_V *d)
{
    const size_t left = count - first, size = (size_t)n;
    const SHI_T *from[SHI_W];
    int r, i;

    memset(d, 0, sizeof *d);                    /* gcc 12 cannot see that n >= 1 */
    if (!plain) {
        in += first / SH_BLOCK * size * SH_BLOCK + first % SH_BLOCK;
        for (r = 0; r < n; r++) d[r] = SHI_LOAD(in + r * SH_BLOCK);
        return;
    }
    for (i = 0; i < SHI_W; i++) from[i] = in + (first + ((size_t)i < left ? (size_t)i : left - 1)) * size;
    for (r = 0; n >= SHI_W; r = r + 2 * SHI_W <= n ? r + SHI_W : n - SHI_W) {
        SHI_V a[SHI_W];
        SHI_UNROLL
        for (i = 0; i < SHI_W; i++) a[i] = SHI_LOAD(from[i] + r);
        SHI_KN(shi_prod_mirror_lanes)(a);
        SHI_UNROLL
        for (i = 0; i < SHI_W; i++) d[r + i] = a[i];
        if (r + SHI_W >= n) return;
    }
    for (r = 0; r < n; r++) {
        SHI_T t[SHI_W];
        for (i = 0; i < SHI_W; i++) t[i] = from[i][r];
        d[r] = SHI_LOAD(t);
    }
}

/* The way back; lanes with skip[i] set are not written (skip may be NULL). */
SHI_INLINE void SHI_KN(shi_prod_leave)(int n, int plain, size_t first, size_t count, const char *skip, const SHI_V *d,
                                       SHI_T *out)
{
    const size_t left = count - first, size = (size_t)n;
    const size_t next = plain ? size : 1;
    const int step = plain ? 1 : SH_BLOCK;
    int r, i;

    out += plain ? first * size : first / SH_BLOCK * size * SH_BLOCK + first % SH_BLOCK;
    if (!skip && !plain) {
        for (r = 0; r < n; r++) SHI_STORE(out + r * SH_BLOCK, d[r]);
        return;
    }
    if (!skip && n >= SHI_W && left >= SHI_W) {
        for (r = 0;; r = r + 2 * SHI_W <= n ? r + SHI_W : n - SHI_W) {
            SHI_V a[SHI_W];
            SHI_UNROLL
            for (i = 0; i < SHI_W; i++) a[i] = d[r + i];
            SHI_KN(shi_prod_mirror_lanes)(a);
            SHI_UNROLL
            for (i = 0; i < SHI_W; i++) SHI_STORE(out + (size_t)i * size + r, a[i]);
            if (r + SHI_W >= n) return;
        }
    }
    for (r = 0; r < n; r++) {
        SHI_T t[SHI_W];
        SHI_STORE(t, d[r]);
        for (i = 0; i < SHI_W && (size_t)i < left; i++)
            if (!skip || !skip[i]) out[(size_t)i * next + (size_t)(r * step)] = t[i];
    }
}

/* All vectors, plain or in blocks; angle as in shi_prod_rotate. */
SHI_INLINE void SHI_KN(shi_prod_rotate_all)(int bands, int plain, const SHI_T *swap, const SHI_T *angle, size_t count,
                                            const SHI_T *in, SHI_T *out)
{
    SHI_V a[6 * SH_PRODUCT_BANDS], d[SH_PRODUCT_BANDS * SH_PRODUCT_BANDS];
    size_t v;
    int i;

    for (i = 0; i < 6 * SH_PRODUCT_BANDS; i++) a[i] = SHI_SPLAT(angle[i]);
    for (v = 0; v < count; v += SHI_W) {
        SHI_KN(shi_prod_enter)(bands * bands, plain, v, count, in, d);
        SHI_KN(shi_prod_rotate)(bands, swap, a, d);
        SHI_KN(shi_prod_leave)(bands * bands, plain, v, count, NULL, d, out);
    }
}

/* Which of the lanes' normals have no direction; the status of the last, SH_OK if all have one. */
SHI_INLINE int SHI_KN(shi_prod_bad_normals)(const SHI_V n[3], char *bad)
{
    SHI_T t[3][SHI_W];
    int status = SH_OK, i, k;

    for (k = 0; k < 3; k++) SHI_STORE(t[k], n[k]);
    for (i = 0; i < SHI_W; i++) {
        SHI_T u[3];
        for (k = 0; k < 3; k++) u[k] = t[k][i];
        bad[i] = !SHI_ONE(shi_in_range)(u[0] * u[0] + u[1] * u[1] + u[2] * u[2], SHI_MIN2, SHI_MAX2);
        if (bad[i]) status = SHI_FN(shi_direction_status)(u);
    }
    return status;
}

/* normals: NULL for +z. A bad one leaves its output alone; returns the status of the last. */
SHI_INLINE int SHI_KN(shi_prod_cosine_all)(int bands, int plain, const SHI_T *swap, const SHI_T *clamp, size_t count,
                                           const SHI_T *normals, const SHI_T *in, SHI_T *out)
{
    SHI_V n[3], d[SH_PRODUCT_BANDS * SH_PRODUCT_BANDS];
    char bad[SHI_W];
    int status = SH_OK;
    size_t v;

    for (v = 0; v < count; v += SHI_W) {
        int now = SH_OK;
        SHI_KN(shi_prod_enter)(bands * bands, plain, v, count, in, d);
        if (normals) {
            SHI_KN(shi_prod_enter)(3, plain, v, count, normals, n);
            if (!SHI_KN(shi_in_range)(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], SHI_MIN2, SHI_MAX2))
                now = SHI_KN(shi_prod_bad_normals)(n, bad);
            SHI_KN(shi_prod_cosine)(bands, swap, clamp, n, d);
        } else SHI_KN(shi_prod_clamp)(bands, clamp, d);
        SHI_KN(shi_prod_leave)(bands * bands, plain, v, count, now ? bad : NULL, d, out);
        if (now) status = now;
    }
    return status;
}

/* y <-> z in all vectors, plain */
SHI_INLINE void SHI_KN(shi_prod_swap_all)(int bands, const SHI_T *swap, size_t count, const SHI_T *in, SHI_T *out)
{
    SHI_V d[SH_PRODUCT_BANDS * SH_PRODUCT_BANDS];
    size_t v;

    for (v = 0; v < count; v += SHI_W) {
        SHI_KN(shi_prod_enter)(bands * bands, 1, v, count, in, d);
        SHI_KN(shi_prod_swap_bands)(bands, swap, d);
        SHI_KN(shi_prod_leave)(bands * bands, 1, v, count, NULL, d, out);
    }
}

/* ================================================================================================================
 * Public functions: once per precision.
 * ============================================================================================================= */
#elif SHI_ROOM == SHI_PUBLIC

/* ---- rotation ---- */

/* A rotation, ready for use: cosines, then sines, of the multiples of a, b and g in Rz(a) Ry(b) Rz(g). */
typedef struct { SHI_T angle[6][SH_PRODUCT_BANDS]; } SHI_FN(sh_rotation);

/* The checked matrix, as multiples of its three angles in double. */
SHI_INLINE int SHI_FN(shi_rotation)(const double m[9], SHI_FN(sh_rotation) *r)
{
    double cs[6];
    int i, k;
    const int status = shi_euler(m, sqrt((double)SHI_EPS), cs);

    if (status) return status;
    for (k = 0; k < 3; k++) {
        double c = 1, s = 0;
        for (i = 0; i < SH_PRODUCT_BANDS; i++) {
            const double t = c * cs[2 * k] - s * cs[2 * k + 1];
            r->angle[2 * k][i] = (SHI_T)c;
            r->angle[2 * k + 1][i] = (SHI_T)s;
            s = s * cs[2 * k] + c * cs[2 * k + 1];
            c = t;
        }
    }
    return SH_OK;
}

/* Set up r, once per rotation, from a matrix that takes old directions to new ones: u' = m u.
 *   m   row-major. One that mirrors, or is not orthonormal within sqrt(eps), is SH_ERROR_MATRIX
 * Error:  a few eps per angle, which sh_rotate's bound includes. */
SH_API int SHI_FN(sh_rotation_matrix)(const SHI_T m[9], SHI_FN(sh_rotation) *r)
{
    double d[9];
    int i;

    if (!m || !r) return SH_ERROR_NULL;
    if (!SHI_FN(shi_finite)(m, 9)) return SH_ERROR_NOT_FINITE;
    for (i = 0; i < 9; i++) d[i] = (double)m[i];
    return SHI_FN(shi_rotation)(d, r);
}

/* The same from a quaternion x, y, z, w of any length from 1e-18 to 1e18; a shorter or longer one is SH_ERROR_MATRIX. */
SH_API int SHI_FN(sh_rotation_quaternion)(const SHI_T q[4], SHI_FN(sh_rotation) *r)
{
    double d[9], x, y, z, w, s;

    if (!q || !r) return SH_ERROR_NULL;
    if (!SHI_FN(shi_finite)(q, 4)) return SH_ERROR_NOT_FINITE;
    x = (double)q[0]; y = (double)q[1]; z = (double)q[2]; w = (double)q[3];
    s = x * x + y * y + z * z + w * w;
    if (!(s >= 0.99e-36 && s <= 1.01e36)) return SH_ERROR_MATRIX;
    s = 2 / s;
    d[0] = 1 - s * (y * y + z * z); d[1] = s * (x * y - z * w);     d[2] = s * (x * z + y * w);
    d[3] = s * (x * y + z * w);     d[4] = 1 - s * (x * x + z * z); d[5] = s * (y * z - x * w);
    d[6] = s * (x * z - y * w);     d[7] = s * (y * z + x * w);     d[8] = 1 - s * (x * x + y * y);
    return SHI_FN(shi_rotation)(d, r);
}

/* The rotation back, exact; the two may be the same object. */
SH_API int SHI_FN(sh_rotation_inverse)(const SHI_FN(sh_rotation) *r, SHI_FN(sh_rotation) *inverse)
{
    int i, k;

    if (!r || !inverse) return SH_ERROR_NULL;
    for (i = 0; i < SH_PRODUCT_BANDS; i++) {
        SHI_T t[6];
        for (k = 0; k < 6; k++) t[k] = r->angle[k][i];
        for (k = 0; k < 6; k++) inverse->angle[k][i] = k & 1 ? -t[6 - k] : t[4 - k];
    }
    return SH_OK;
}

/* Arguments that most calls share, count vectors in and out of 1 .. `most` bands, one array or apart; O(1). */
SHI_INLINE int SHI_FN(shi_check_vectors)(int bands, int most, size_t count, const SHI_T *in, const SHI_T *out)
{
    size_t size;
    if (bands < 1 || bands > most) return SH_ERROR_BANDS;
    if (count > SHI_MOST(bands * bands + 3)) return SH_ERROR_COUNT;
    if (count && (!in || !out)) return SH_ERROR_NULL;
    size = (size_t)(bands * bands) * sizeof(SHI_T);
    if (count && shi_clash(out, count * size, in, count * size)) return SH_ERROR_OVERLAP;
    return SH_OK;
}

SHI_INLINE int SHI_FN(shi_rotate)(int bands, int plain, const SHI_FN(sh_rotation) *r, size_t count, const SHI_T *in, SHI_T *out)
{
    const int status = SHI_FN(shi_check_vectors)(bands, SH_PRODUCT_BANDS, count, in, out);
    if (status || !count) return status;
    if (!r) return SH_ERROR_NULL;
    SHI_MANY(shi_prod_rotate_all)(bands, plain, SHI_FN(shi_swap), r->angle[0], count, in, out);
    return SH_OK;
}

/* Rotate coefficient vectors: sum out_i Y_i(R u) = sum in_i Y_i(u).
 *   bands     1..16
 *   r         from sh_rotation_matrix, _quaternion or _inverse
 *   in, out   [count][N], the same array or apart
 * Error:  16 eps |in| to 6 bands, 40 eps to 16, for an orthonormal matrix.
 * Source: KSS02, with the exchange S of y and z in the place of the turn by 90 degrees: Ry(b) = S Rz(-b) S, one symmetric
 *         table, and no transposed code. */
SH_API int SHI_FN(sh_rotate)(int bands, const SHI_FN(sh_rotation) *r, size_t count, const SHI_T *in, SHI_T *out)
{
    return SHI_FN(shi_rotate)(bands, 1, r, count, in, out);
}

/* The same for in, out [blocks][N][SH_BLOCK]. */
SH_API int SHI_FN(sh_rotate_blocks)(int bands, const SHI_FN(sh_rotation) *r, size_t blocks, const SHI_T *in, SHI_T *out)
{
    return SHI_FN(shi_rotate)(bands, 0, r, shi_block_items(blocks), in, out);
}

/* Mirror: sum out_i Y_i(M u) = sum in_i Y_i(u), M the change of sign of an axis. Exact.
 *   bands     1..32
 *   axis      0 (x), 1 (y) or 2 (z); another one is SH_ERROR_OPTION
 *   in, out   [count][N], the same array or apart */
SH_API int SHI_FN(sh_mirror)(int bands, int axis, size_t count, const SHI_T *in, SHI_T *out)
{
    const int status = SHI_FN(shi_check_vectors)(bands, SH_MAX_BANDS, count, in, out);
    size_t v;
    int l, m;

    if (status) return status;
    if (axis < 0 || axis > 2) return SH_ERROR_OPTION;
    for (v = 0; v < count; v++)
        for (l = 0; l < bands; l++)
            for (m = -l; m <= l; m++, in++, out++) *out = shi_parity(axis, l, m) < 0 ? -*in : *in;
    return SH_OK;
}

/* x <-> y in one vector: azimuth becomes 90 degrees less azimuth. */
SHI_INLINE void SHI_FN(shi_exchange_x_y)(int bands, SHI_T *c)
{
    int l, m;
    for (l = 1; l < bands; l++) {
        SHI_T *d = c + l * (l + 1);
        for (m = 1; m <= l; m++) {
            const SHI_T p = d[m], q = d[-m];
            d[m] = m & 1 ? (m & 2 ? -q : q) : (m & 2 ? -p : p);
            d[-m] = m & 1 ? (m & 2 ? -p : p) : (m & 2 ? q : -q);
        }
    }
}

/* Rename axes: sum out_i Y_i(u') = sum in_i Y_i(u), where u'[k] = +u[|axes[k]| - 1], or its negative where axes[k] < 0.
 *   bands     1..16
 *   axes      any of the 48 signed permutations of 1, 2, 3 (else SH_ERROR_OPTION): { 1, -3, 2 } takes a y-up world to a z-up
 *             one, { 1, 3, -2 } back
 *   in, out   [count][N], the same array or apart
 * Error:  as sh_rotate; exact when z stays on its axis. */
SH_API int SHI_FN(sh_permute_axes)(int bands, const int axes[3], size_t count, const SHI_T *in, SHI_T *out)
{
    const int status = SHI_FN(shi_check_vectors)(bands, SH_PRODUCT_BANDS, count, in, out);
    const int x_y = 0, y_z = 1;
    int a[3], k, steps[3], used = 0;
    size_t v, n;

    if (status) return status;
    if (!axes) return count ? SH_ERROR_NULL : SH_OK;
    for (k = 0; k < 3; k++) a[k] = axes[k] < 0 ? -(axes[k] + 1) : axes[k] - 1;
    if ((unsigned)a[0] > 2 || (unsigned)a[1] > 2 || (unsigned)a[2] > 2
        || a[0] == a[1] || a[0] == a[2] || a[1] == a[2]) return SH_ERROR_OPTION;
    n = (size_t)(bands * bands);
    if (count && in != out) memmove(out, in, count * n * sizeof *out);
    /* exchanges of neighbours, applied in order: the one for z to its place first, then x and y */
    if (a[2] == 0) steps[used++] = x_y;
    if (a[2] < 2) steps[used++] = y_z;
    if (a[2] < 2 ? a[0] == 2 : a[0] == 1) steps[used++] = x_y;
    for (k = 0; k < used; k++)
        if (steps[k] == y_z) SHI_MANY(shi_prod_swap_all)(bands, SHI_FN(shi_swap), count, out, out);
        else
            for (v = 0; v < count; v++) SHI_FN(shi_exchange_x_y)(bands, out + v * n);
    for (k = 0; k < 3; k++)
        if (axes[k] < 0) SHI_FN(sh_mirror)(bands, k, count, out, out);
    return SH_OK;
}

/* ---- products ---- */

/* Products of na and nb bands to n bands, count of each. The basis at the nodes is made once, at azimuth 0: the fewest pairs
 * of nodes, 4, 8 or 16, that integrate the degree and fill the lanes. */
SHI_INLINE int SHI_FN(shi_products)(int na, int nb, int n, size_t count, const SHI_T *a, const SHI_T *b, SHI_T *out)
{
    const int most = na > nb ? (na > n ? na : n) : nb > n ? nb : n;
    SHI_T y[2 * SH_PRODUCT_BANDS * SH_PRODUCT_BANDS * SH_BLOCK], dirs[2 * 3 * SH_BLOCK];
    size_t v, bytes;
    int pairs = 4, first = 0, size, i;

    if (na < 1 || nb < 1 || n < 1 || most > SH_PRODUCT_BANDS) return SH_ERROR_BANDS;
    size = most * most;
    if (count > SHI_MOST(size)) return SH_ERROR_COUNT;
    if (!count) return SH_OK;
    if (!a || !b || !out) return SH_ERROR_NULL;
    bytes = count * (size_t)(n * n) * sizeof(SHI_T);
    if (shi_clash(out, bytes, a, count * (size_t)(na * na) * sizeof(SHI_T))
        || shi_clash(out, bytes, b, count * (size_t)(nb * nb) * sizeof(SHI_T))) return SH_ERROR_OVERLAP;
    while (4 * pairs - 1 < na + nb + n - 3 || pairs * SHI_BITS < SH_VECTOR_BYTES * 8) {
        first += pairs;
        pairs *= 2;
    }
    for (i = 0; i < 2 * SH_BLOCK; i++) {
        SHI_T *d = dirs + i / SH_BLOCK * 3 * SH_BLOCK + i % SH_BLOCK;
        const int k = first + (i < pairs ? i : 0);
        d[0] = SHI_FN(shi_node_s)[k];
        d[SH_BLOCK] = 0;
        d[2 * SH_BLOCK] = SHI_FN(shi_node_z)[k];
    }
    SHI_FN(sh_eval_blocks)(most, pairs > SH_BLOCK ? 2 : 1, dirs, y);
    for (v = 0; v < count; v++)
        SHI_MANY(shi_prod_triple)(pairs, na, nb, n, size, y, SHI_FN(shi_node_w) + first,
                             a + v * (size_t)(na * na), b + v * (size_t)(nb * nb), out + v * (size_t)(n * n));
    return SH_OK;
}

/* Coefficients of the product of two functions.
 *   bands_a, bands_b, bands_out   1..16 each; what the product has beyond bands_out is left out
 *   a, b, out                     [bands_a^2], [bands_b^2], [bands_out^2]; out is a or b (of its size), or apart from both
 * Error:  16 eps |a| |b| to 6 bands, 40 eps to 16.
 * Source: MP21 Eq. 5, summed over a grid on which it is exact: Gauss nodes in z and Fourier series in azimuth, O(bands^3)
 *         against O(bands^5) of the table of real Gaunt coefficients, and no table. */
SH_API int SHI_FN(sh_triple_product_bands)(int bands_a, const SHI_T *a, int bands_b, const SHI_T *b, int bands_out, SHI_T *out)
{
    return SHI_FN(shi_products)(bands_a, bands_b, bands_out, 1, a, b, out);
}

/* out = a times b, all [N] with the same bands 1..16; the rest as sh_triple_product_bands. */
SH_API int SHI_FN(sh_triple_product)(int bands, const SHI_T *a, const SHI_T *b, SHI_T *out)
{
    return SHI_FN(shi_products)(bands, bands, bands, 1, a, b, out);
}

/* The same, count times: a, b, out [count][N]. */
SH_API int SHI_FN(sh_triple_product_n)(int bands, size_t count, const SHI_T *a, const SHI_T *b, SHI_T *out)
{
    return SHI_FN(shi_products)(bands, bands, bands, count, a, b, out);
}

SHI_INLINE int SHI_FN(shi_cosine_local)(int bands, int plain, size_t count, const SHI_T *coeffs, SHI_T *out)
{
    const int status = SHI_FN(shi_check_vectors)(bands, SH_PRODUCT_BANDS, count, coeffs, out);
    if (status) return status;
    SHI_MANY(shi_prod_cosine_all)(bands, plain, SHI_FN(shi_swap), SHI_FN(shi_clamp), count, NULL, coeffs, out);
    return SH_OK;
}

SHI_INLINE int SHI_FN(shi_cosine)(int bands, int plain, size_t count, const SHI_T *normals, const SHI_T *coeffs, SHI_T *out)
{
    const int status = SHI_FN(shi_check_vectors)(bands, SH_PRODUCT_BANDS, count, coeffs, out);
    if (status) return status;
    if (count && !normals) return SH_ERROR_NULL;
    if (shi_overlap(normals, 3 * count * sizeof *out, out, count * (size_t)(bands * bands) * sizeof *out))
        return SH_ERROR_OVERLAP;
    return SHI_MANY(shi_prod_cosine_all)(bands, plain, SHI_FN(shi_swap), SHI_FN(shi_clamp), count, normals, coeffs, out);
}

/* Coefficients of max(0, z) f(u), exact for the bands given: the cosine is never cut to a few bands.
 *   bands         1..16
 *   coeffs, out   [count][N], the same array or apart
 * Error:  16 eps |coeffs| to 6 bands, 40 eps to 16.
 * Source: MP21 Eq. 11. */
SH_API int SHI_FN(sh_cosine_product_local_n)(int bands, size_t count, const SHI_T *coeffs, SHI_T *out)
{
    return SHI_FN(shi_cosine_local)(bands, 1, count, coeffs, out);
}

/* One vector: coeffs, out [N]. */
SH_API int SHI_FN(sh_cosine_product_local)(int bands, const SHI_T *coeffs, SHI_T *out)
{
    SHI_T d[SH_PRODUCT_BANDS * SH_PRODUCT_BANDS];   /* gcc 12 warns of 16 bands in a caller's smaller array */
    const int status = SHI_FN(shi_check_vectors)(bands, SH_PRODUCT_BANDS, 1, coeffs, out);
    if (status) return status;
    memcpy(d, coeffs, (size_t)(bands * bands) * sizeof *d);
    SHI_ONE(shi_prod_clamp)(bands, SHI_FN(shi_clamp), d);
    memcpy(out, d, (size_t)(bands * bands) * sizeof *d);
    return SH_OK;
}

/* The same for coeffs, out [blocks][N][SH_BLOCK]. */
SH_API int SHI_FN(sh_cosine_product_local_blocks)(int bands, size_t blocks, const SHI_T *coeffs, SHI_T *out)
{
    return SHI_FN(shi_cosine_local)(bands, 0, shi_block_items(blocks), coeffs, out);
}

/* Coefficients of max(0, n.u) f(u), a normal n for each vector: turned to +z, multiplied, turned back, which is MP21's "zxzx"
 * rotation cut to two angles.
 *   bands         1..16
 *   normals       [count][3], of any length from 1e-18 to 1e18 (double 1e-150 to 1e150), apart from out. A zero one is
 *                 SH_ERROR_DIRECTION, NaN or Inf in one SH_ERROR_NOT_FINITE: its output is left alone, the others are written
 *   coeffs, out   [count][N], the same array or apart
 * Error:  16 eps |coeffs| to 6 bands, 40 eps to 16.
 * Source: MP21 Eq. 11. */
SH_API int SHI_FN(sh_cosine_product_n)(int bands, size_t count, const SHI_T *normals, const SHI_T *coeffs, SHI_T *out)
{
    return SHI_FN(shi_cosine)(bands, 1, count, normals, coeffs, out);
}

/* One vector: coeffs, out [N]. */
SH_API int SHI_FN(sh_cosine_product)(int bands, const SHI_T normal[3], const SHI_T *coeffs, SHI_T *out)
{
    return SHI_FN(shi_cosine)(bands, 1, 1, normal, coeffs, out);
}

/* The same for normals [blocks][3][SH_BLOCK] and coeffs, out [blocks][N][SH_BLOCK]. */
SH_API int SHI_FN(sh_cosine_product_blocks)(int bands, size_t blocks, const SHI_T *normals, const SHI_T *coeffs, SHI_T *out)
{
    return SHI_FN(shi_cosine)(bands, 0, shi_block_items(blocks), normals, coeffs, out);
}

/* Irradiance, the integral over the sphere, from a cosine-weighted product T of any bands: 2 sqrt(pi) T_00 (MP21 Eq. 9), the
 * first of product[N] times a constant. */
SH_API int SHI_FN(sh_diffuse_from_product)(const SHI_T *product, SHI_T *irradiance)
{
    if (!product || !irradiance) return SH_ERROR_NULL;
    *irradiance = SHI_C(SHI_ROOT_FOUR_PI) * product[0];
    return SH_OK;
}

/* ---- zonal lobes: zh[l] is the coefficient (l, 0) of a function of the angle to +z ---- */

/* max(0, cos): irradiance when light is convolved with it. zh [bands], bands 1..32.
 * Error:  8 eps of each.
 * Source: RH01. */
SH_API int SHI_FN(sh_zonal_cosine)(int bands, SHI_T *zh)
{
    double z[SH_MAX_BANDS];
    int l;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (!zh) return SH_ERROR_NULL;
    shi_zonal_power(bands, 1, z);
    for (l = 0; l < bands; l++) zh[l] = (SHI_T)(SHI_PI * z[l]);
    return SH_OK;
}

/* Phong: (s+1)/(2 pi) max(0, cos)^s, integral 1 over the sphere. zh [bands], bands 1..32.
 *   s   0 or more; negative or not finite: SH_ERROR_OPTION
 * Error:  8 eps M_l. */
SH_API int SHI_FN(sh_zonal_phong)(int bands, SHI_T s, SHI_T *zh)
{
    double z[SH_MAX_BANDS];
    int l;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (!SHI_FN(shi_finite)(&s, 1) || !(s >= 0)) return SH_ERROR_OPTION;
    if (!zh) return SH_ERROR_NULL;
    shi_zonal_power(bands, (double)s, z);
    for (l = 0; l < bands; l++) zh[l] = (SHI_T)z[l];
    return SH_OK;
}

/* GGX: the density of the mirrored direction when microfacet normals are GGX-distributed and the view is along the normal,
 * D(theta/2; alpha)/4, integral 1 over the sphere. zh [bands], bands 1..32.
 *   alpha   roughness squared, 0 (a mirror: the delta) to 1 (constant); outside is SH_ERROR_OPTION
 * No table and no fit: the lobe is 1/(p - z)^2 up to scale, whose coefficients are Legendre functions of the second kind. How
 * far it is from GGX at other views: docs/products.md.
 * Error:  16 eps M_l. */
SH_API int SHI_FN(sh_zonal_ggx)(int bands, SHI_T alpha, SHI_T *zh)
{
    double z[SH_MAX_BANDS];
    int l;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (!SHI_FN(shi_finite)(&alpha, 1) || !(alpha >= 0 && alpha <= 1)) return SH_ERROR_OPTION;
    if (!zh) return SH_ERROR_NULL;
    shi_ggx(bands, (double)alpha, z);
    for (l = 0; l < bands; l++) zh[l] = (SHI_T)z[l];
    return SH_OK;
}

/* ---- shading ---- */

/* Multiply band l by factors[l].
 *   bands     1..32
 *   factors   [bands], apart from out
 *   in, out   [N], the same array or apart
 * Error:  one rounding. */
SH_API int SHI_FN(sh_scale_bands)(int bands, const SHI_T *factors, const SHI_T *in, SHI_T *out)
{
    const int status = SHI_FN(shi_check_vectors)(bands, SH_MAX_BANDS, 1, in, out);
    int l, m;
    if (status) return status;
    if (!factors) return SH_ERROR_NULL;
    if (shi_overlap(factors, (size_t)bands * sizeof *factors, out, (size_t)(bands * bands) * sizeof *out))
        return SH_ERROR_OVERLAP;
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) out[l * (l + 1) + m] = factors[l] * in[l * (l + 1) + m];
    return SH_OK;
}

/* Convolve with a zonal lobe: out(n) is the integral of lobe(angle(n, u)) f(u). With sh_zonal_cosine: irradiance.
 *   bands     1..32
 *   zh        [bands]
 *   in, out   [N], the same array or apart
 * Error:  2 eps of each coefficient.
 * Source: RH01. */
SH_API int SHI_FN(sh_convolve)(int bands, const SHI_T *zh, const SHI_T *in, SHI_T *out)
{
    SHI_T factors[SH_MAX_BANDS];
    int l;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (!zh || !in || !out) return SH_ERROR_NULL;
    for (l = 0; l < bands; l++) factors[l] = (SHI_T)(sqrt((2 * SHI_TAU) / (2 * l + 1)) * (double)zh[l]);
    return SHI_FN(sh_scale_bands)(bands, factors, in, out);
}

/* Irradiance at normals from one radiance vector: the exact cosine convolution.
 *   bands        1..32
 *   coeffs       [N]
 *   normals      [count][3], any length from 1e-18 to 1e18 (double 1e-150 to 1e150); they are normalised
 *   irradiance   [count]; divide by pi and multiply by the albedo for the radiance that leaves
 * A bad normal leaves its own output untouched and the call returns its status.
 * Error:  16 eps |coeffs| to 6 bands, 40 eps to 16, beyond that of sh_reconstruct.
 * Source: RH01. */
SH_API int SHI_FN(sh_diffuse_n)(int bands, const SHI_T *coeffs, size_t count, const SHI_T *normals, SHI_T *irradiance)
{
    SHI_T zh[SH_MAX_BANDS], c[SH_MAX_BANDS * SH_MAX_BANDS];
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (!count) return SH_OK;
    if (count > SHI_MOST(3)) return SH_ERROR_COUNT;
    if (!coeffs || !normals || !irradiance) return SH_ERROR_NULL;
    if (shi_overlap(coeffs, (size_t)(bands * bands) * sizeof *coeffs, irradiance, count * sizeof *irradiance))
        return SH_ERROR_OVERLAP;
    SHI_FN(sh_zonal_cosine)(bands, zh);
    SHI_FN(sh_convolve)(bands, zh, coeffs, c);
    return SHI_FN(sh_reconstruct_n)(bands, c, count, normals, irradiance, NULL);
}

/* One normal: irradiance [1]. */
SH_API int SHI_FN(sh_diffuse)(int bands, const SHI_T *coeffs, const SHI_T normal[3], SHI_T *irradiance)
{
    return SHI_FN(sh_diffuse_n)(bands, coeffs, 1, normal, irradiance);
}

/* The product with a cosine cut to a few bands: what others compute, for comparison. sh_cosine_product is both faster and exact.
 *   bands         1..16
 *   zonal_bands   1..16 of the cosine: 3 hold most of its energy, `bands` of them are MP21's full Eq. 10
 *   normal        as in sh_cosine_product
 *   coeffs, out   [N], the same array or apart
 * Error:  as sh_triple_product.
 * Source: MP21 Eq. 10. */
SH_API int SHI_FN(sh_cosine_product_zonal)(int bands, int zonal_bands, const SHI_T normal[3], const SHI_T *coeffs, SHI_T *out)
{
    SHI_T zh[SH_PRODUCT_BANDS], cosine[SH_PRODUCT_BANDS * SH_PRODUCT_BANDS];
    int status;

    if (bands < 1 || bands > SH_PRODUCT_BANDS
        || zonal_bands < 1 || zonal_bands > SH_PRODUCT_BANDS) return SH_ERROR_BANDS;
    if (!normal || !coeffs || !out) return SH_ERROR_NULL;
    SHI_FN(sh_zonal_cosine)(zonal_bands, zh);
    status = SHI_FN(sh_zonal_rotate)(zonal_bands, zh, normal, cosine);
    if (status) return status;
    if (shi_overlap(normal, 3 * sizeof *normal, out, (size_t)(bands * bands) * sizeof *out)) return SH_ERROR_OVERLAP;
    return SHI_FN(shi_products)(bands, zonal_bands, bands, 1, coeffs, cosine, out);
}

/* ---- other systems ---- */

/* Our coefficients as another system keeps them, one channel: docs/conventions.md says what each number is.
 *   convention   from sh_convention
 *   bands        1 to what the system has
 *   ours         [N]
 *   theirs       [sh_convention_size(convention, bands)], apart from ours
 * Error:  none where the systems differ in order, sign and axes; else each number is within one eps (sn3d: 1.5), there and
 *         back too.
 *         Forms that mix coefficients (unity-packed, babylon-polynomial): within 8 eps of the largest of them. */
SH_API int SHI_FN(sh_convert_to)(int convention, int bands, const SHI_T *ours, SHI_T *theirs)
{
    const shi_convention *c = shi_find_convention(convention);
    const int size = sh_convention_size(convention, bands);
    int l, m;

    if (size < 0) return size;
    if (!ours || !theirs) return SH_ERROR_NULL;
    if (shi_overlap(ours, (size_t)(bands * bands) * sizeof *ours, theirs, (size_t)size * sizeof *theirs))
        return SH_ERROR_OVERLAP;
    memset(theirs, 0, (size_t)size * sizeof *theirs);
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) {
            const SHI_T v = (SHI_T)(shi_convention_factor(c, l, m) * (double)ours[l * (l + 1) + m]);
            if (c->order == SHI_ORDER_COMPLEX) {    /* a_m = (c_m - i c_-m)/sqrt 2, a_-m = (-1)^m its conjugate */
                const int i = 2 * (l * (l + 1) + (m < 0 ? -m : m)), j = 2 * (l * (l + 1) - (m < 0 ? -m : m));
                const SHI_T flipped = m & 1 ? -v : v;
                if (m >= 0) { theirs[j] = flipped; theirs[i] = v; }
                else { theirs[i + 1] = -v; theirs[j + 1] = flipped; }
            } else {
                const int conjugate = c->order == SHI_ORDER_HALF_COMPLEX && m < 0;
                theirs[shi_convention_place(c, bands, l, m)] = conjugate ? -v : v;
            }
        }
    if (c->order == SHI_ORDER_PACKED) {             /* SHA xyzw, SHB xyzw, SHC */
        SHI_T t[9];
        memcpy(t, theirs, sizeof t);
        theirs[0] = t[3]; theirs[1] = t[1]; theirs[2] = t[2]; theirs[3] = t[0] - t[6];
        theirs[4] = t[4]; theirs[5] = t[5]; theirs[6] = 3 * t[6]; theirs[7] = t[7]; theirs[8] = t[8];
    } else if (c->order == SHI_ORDER_MONOMIALS) {   /* x y z xx yy zz yz zx xy */
        SHI_T t[9];
        memcpy(t, theirs, sizeof t);
        theirs[0] = t[3]; theirs[1] = t[1]; theirs[2] = t[2];
        theirs[3] = t[0] - t[6] + t[8]; theirs[4] = t[0] - t[6] - t[8]; theirs[5] = t[0] + 2 * t[6];
        theirs[6] = t[5]; theirs[7] = t[7]; theirs[8] = t[4];
    }
    return SH_OK;
}

/* The way back. Of complex sets the part m >= 0 is read: the function is real. */
SH_API int SHI_FN(sh_convert_from)(int convention, int bands, const SHI_T *theirs, SHI_T *ours)
{
    const shi_convention *c = shi_find_convention(convention);
    const int size = sh_convention_size(convention, bands);
    SHI_T t[9];
    int l, m;

    if (size < 0) return size;
    if (!ours || !theirs) return SH_ERROR_NULL;
    if (shi_overlap(ours, (size_t)(bands * bands) * sizeof *ours, theirs, (size_t)size * sizeof *theirs))
        return SH_ERROR_OVERLAP;
    if (c->order == SHI_ORDER_PACKED) {
        t[3] = theirs[0]; t[1] = theirs[1]; t[2] = theirs[2]; t[6] = theirs[6] / 3; t[0] = theirs[3] + t[6];
        t[4] = theirs[4]; t[5] = theirs[5]; t[7] = theirs[7]; t[8] = theirs[8];
        theirs = t;
    } else if (c->order == SHI_ORDER_MONOMIALS) {
        t[3] = theirs[0]; t[1] = theirs[1]; t[2] = theirs[2];
        t[0] = (theirs[3] + theirs[4] + theirs[5]) / 3; t[8] = (theirs[3] - theirs[4]) / 2;
        t[6] = (2 * theirs[5] - theirs[3] - theirs[4]) / 6;
        t[5] = theirs[6]; t[7] = theirs[7]; t[4] = theirs[8];
        theirs = t;
    }
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) {
            const int imaginary = m < 0 && (c->order == SHI_ORDER_COMPLEX || c->order == SHI_ORDER_HALF_COMPLEX);
            SHI_T v = theirs[c->order == SHI_ORDER_COMPLEX && m < 0 ? 2 * (l * (l + 1) - m) + 1
                                                              : shi_convention_place(c, bands, l, m)];
            if (imaginary) v = -v;
            ours[l * (l + 1) + m] = (SHI_T)((double)v / shi_convention_factor(c, l, m));
        }
    return SH_OK;
}

/* A direction, or a derivative by one, in their axes and in ours. in and out may be the same array. */
SH_API int SHI_FN(sh_convert_direction_to)(int convention, const SHI_T ours[3], SHI_T theirs[3])
{
    const shi_convention *c = shi_find_convention(convention);
    SHI_T x, y, z;

    if (!c) return SH_ERROR_OPTION;
    if (!ours || !theirs) return SH_ERROR_NULL;
    x = ours[0]; y = ours[1]; z = ours[2];
    theirs[0] = c->polar == 1 ? y : x;
    theirs[1] = c->polar == 1 ? z : y;
    theirs[2] = c->polar == 1 ? x : z;
    return SH_OK;
}

/* The way back. */
SH_API int SHI_FN(sh_convert_direction_from)(int convention, const SHI_T theirs[3], SHI_T ours[3])
{
    const shi_convention *c = shi_find_convention(convention);
    SHI_T x, y, z;

    if (!c) return SH_ERROR_OPTION;
    if (!ours || !theirs) return SH_ERROR_NULL;
    x = theirs[0]; y = theirs[1]; z = theirs[2];
    ours[0] = c->polar == 1 ? z : x;
    ours[1] = c->polar == 1 ? x : y;
    ours[2] = c->polar == 1 ? y : z;
    return SH_OK;
}

/* ---- ringing ---- */

SHI_INLINE void SHI_FN(shi_window_factors)(int kind, int bands, double width, SHI_T *factors)
{
    int l;
    for (l = 0; l < bands; l++) factors[l] = (SHI_T)shi_window(kind, width, l);
}

/* Factors of a window, for sh_scale_bands. SH_HANN, SH_LANCZOS (zero from the width on), SH_GAUSS (the heat kernel of the
 * sphere: the only one of the three that never makes a minimum lower).
 *   kind      one of these three; another one is SH_ERROR_OPTION
 *   bands     1..32
 *   width     in bands, positive (else SH_ERROR_OPTION)
 *   factors   [bands]; factors[0] is 1
 * Error:  2 eps.
 * Source: S08. */
SH_API int SHI_FN(sh_window)(int kind, int bands, SHI_T width, SHI_T *factors)
{
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (kind < SH_HANN || kind > SH_GAUSS || !SHI_FN(shi_finite)(&width, 1) || !(width > 0)) return SH_ERROR_OPTION;
    if (!factors) return SH_ERROR_NULL;
    SHI_FN(shi_window_factors)(kind, bands, (double)width, factors);
    return SH_OK;
}

/* From u downhill to a local minimum, by Newton's method with halved steps; its value, and where in u. */
SHI_NOINLINE SHI_T SHI_FN(shi_descend)(int bands, const SHI_T *c, SHI_T u[3])
{
    SHI_T y[10 * SH_MAX_BANDS * SH_MAX_BANDS];              /* the planes of SH_HESSIAN */
    const int n = bands * bands;
    double best = 0;
    int turn, i, k, halved, goes_on = 1;

    for (turn = 0; turn < 50 && goes_on; turn++) {
        double f[10] = { 0 }, v[3], s[3], step, part;

        SHI_FN(sh_eval_hessian)(bands, u, y, y + n, y + 4 * n);
        for (i = 0; i < n; i++)
            for (k = 0; k < 10; k++) f[k] += (double)c[i] * (double)y[k * n + i];
        best = f[0];
        for (k = 0; k < 3; k++) v[k] = (double)u[k];
        shi_newton_step(v, f + 1, f + 4, s);
        step = sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
        part = step > 0.5 / bands ? 0.5 / (bands * step) : 1;
        goes_on = 0;
        for (halved = 0; halved < 20 && part * step > 1e-8; halved++, part *= 0.5) {
            SHI_T w[3];
            double at[3], size, there = 0;
            for (i = 0; i < 3; i++) at[i] = v[i] + part * s[i];
            size = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
            for (i = 0; i < 3; i++) w[i] = (SHI_T)(at[i] / size);
            SHI_FN(sh_eval)(bands, w, y);
            for (i = 0; i < n; i++) there += (double)c[i] * (double)y[i];
            if (!(there < best)) continue;
            for (i = 0; i < 3; i++) u[i] = w[i];
            best = there;
            goes_on = part * step > 1e-5;                   /* the next step would be about its square */
            break;
        }
    }
    return (SHI_T)best;
}

/* The sum at the points of a spiral, number i of them at height 1 - (2i + 1)/points and golden angles apart; the latest
 * SHI_KEPT of them are kept, number i at i % SHI_KEPT. */
typedef struct {
    int points, reach;              /* two within 1.6 spacings of each other are at most `reach` numbers apart */
    SHI_T dirs[3 * SHI_KEPT], values[SHI_KEPT];
} SHI_FN(shi_spiral);

/* Samples from number `first`, a multiple of SHI_CHUNK, on; returns the number after the last. */
SHI_NOINLINE int SHI_FN(shi_spiral_chunk)(int bands, const SHI_T *c, int first, SHI_FN(shi_spiral) *s)
{
    const int at = first % SHI_KEPT, count = s->points - first < SHI_CHUNK ? s->points - first : SHI_CHUNK;
    int i;
    for (i = 0; i < count; i++) {
        const double z = 1 - (2 * (first + i) + 1.0) / s->points, r = sqrt(1 - z * z), f = 2.399963229728653 * (first + i);
        s->dirs[3 * (at + i)] = (SHI_T)(r * cos(f));
        s->dirs[3 * (at + i) + 1] = (SHI_T)(r * sin(f));
        s->dirs[3 * (at + i) + 2] = (SHI_T)z;
    }
    SHI_FN(sh_reconstruct_n)(bands, c, (size_t)count, s->dirs + 3 * at, s->values + at, NULL);
    return first + count;
}

/* Is no sample within 1.6 spacings of number i lower, and no earlier one as low? */
SHI_INLINE int SHI_FN(shi_is_lowest)(const SHI_FN(shi_spiral) *s, int i)
{
    const SHI_T *const d = s->dirs + 3 * (i % SHI_KEPT), value = s->values[i % SHI_KEPT];
    const double apart = 1 - 16.0 / s->points;
    int j;
    for (j = i > s->reach ? i - s->reach : 0; j <= i + s->reach && j < s->points; j++) {
        const SHI_T *const e = s->dirs + 3 * (j % SHI_KEPT), other = s->values[j % SHI_KEPT];
        if ((other < value || (other <= value && j < i)) && (double)(d[0] * e[0] + d[1] * e[1] + d[2] * e[2]) > apart) return 0;
    }
    return 1;
}

/* Downhill again from about the lowest place found, while that helps: wells closer than samples share one, and the lower may
 * have been left out. */
SHI_NOINLINE SHI_T SHI_FN(shi_lowest_about)(int bands, const SHI_T *c, double spacing, SHI_T best, SHI_T where[3])
{
    int turn, i, k, found = 1;
    for (turn = 0; turn < 8 && found; turn++) {
        const double w[3] = { (double)where[0], (double)where[1], (double)where[2] };
        double e[2][3];
        shi_tangent_axes(w, e);
        for (found = 0, i = 0; i < 32 && !found; i++) {
            static const double turns[8][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 },
                                                { 0.7, 0.7 }, { -0.7, 0.7 }, { -0.7, -0.7 }, { 0.7, -0.7 } };
            const double away = spacing * (i < 8 ? 0.8 : i < 16 ? 1.6 : i < 24 ? 3.2 : 0.4);
            SHI_T u[3], value;
            for (k = 0; k < 3; k++) u[k] = (SHI_T)(w[k] + away * (turns[i % 8][0] * e[0][k] + turns[i % 8][1] * e[1][k]));
            value = SHI_FN(shi_descend)(bands, c, u);
            if (!(value < best)) continue;
            found = best - value > SHI_EPS * (value < 0 ? -value : value);
            best = value;
            for (k = 0; k < 3; k++) where[k] = u[k];
        }
    }
    return best;
}

/* The smallest value and where; or, if `negative` will do, the first one below zero that is found. */
SHI_NOINLINE SHI_T SHI_FN(shi_lowest)(int bands, const SHI_T *c, int negative, SHI_T where[3])
{
    SHI_FN(shi_spiral) s;
    SHI_T best, lowest = 0, highest = 0;
    int first, end, i, k, next = 0, descended = 0;

    s.points = 24 * bands * bands + 64;
    s.reach = (int)sqrt(8.0 * s.points) + 1;
    for (first = 0; first < s.points; first = end) {
        end = SHI_FN(shi_spiral_chunk)(bands, c, first, &s);
        for (i = first; i < end; i++) {
            const SHI_T value = s.values[i % SHI_KEPT];
            if (i == 0 || value > highest) highest = value;
            if (i == 0 || value < lowest) {
                lowest = value;
                for (k = 0; k < 3; k++) where[k] = s.dirs[3 * (i % SHI_KEPT) + k];
            }
            if (negative && lowest < 0) return lowest;
        }
    }
    best = lowest;
    for (first = 0; first < s.points; first = end) {
        end = SHI_FN(shi_spiral_chunk)(bands, c, first, &s);
        for (; next < s.points && (next + s.reach < end || end == s.points); next++) {     /* those with all neighbours kept */
            SHI_T u[3], value;
            if (!(s.values[next % SHI_KEPT] <= lowest + SHI_C(0.1) * (highest - lowest))) continue;
            if (!SHI_FN(shi_is_lowest)(&s, next)) continue;
            for (k = 0; k < 3; k++) u[k] = s.dirs[3 * (next % SHI_KEPT) + k];
            value = SHI_FN(shi_descend)(bands, c, u);
            if (!descended || value < best) {               /* the first one takes the place of the sample */
                descended = 1;
                best = value;
                for (k = 0; k < 3; k++) where[k] = u[k];
            }
            if (negative && best < 0) return best;
        }
    }
    return SHI_FN(shi_lowest_about)(bands, c, sqrt(2 * SHI_TAU / s.points), best, where);
}

/* Smallest value of sum c_i Y_i on the sphere, and where.
 *   bands    1..32
 *   coeffs   [N], of any scale: to 1e27 in float and 1e295 in double
 *   dir      [3], a unit vector; NULL or apart from value
 *   value    [1] or NULL
 * Samples 24 bands^2 + 64 points of a spiral and goes downhill from all that have no lower neighbour and lie within a tenth of
 * the range of the lowest: between samples the sum cannot fall further than that (Bernstein's inequality). Of wells closer to
 * each other than samples the search goes down one, and into others only about the lowest.
 * Error:  40 eps |coeffs| bands/3.5. */
SH_API int SHI_FN(sh_minimum)(int bands, const SHI_T *coeffs, SHI_T *dir, SHI_T *value)
{
    SHI_T where[3] = { 0, 0, 1 }, low;
    int k;

    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (!coeffs) return SH_ERROR_NULL;
    if (shi_overlap(dir, 3 * sizeof *dir, value, sizeof *value)) return SH_ERROR_OVERLAP;
    low = SHI_FN(shi_lowest)(bands, coeffs, 0, where);
    if (value) *value = low;
    for (k = 0; dir && k < 3; k++) dir[k] = where[k];
    return SH_OK;
}

/* Are all channels non-negative, band l times factors[l] (NULL: as they are)? */
SHI_INLINE int SHI_FN(shi_non_negative)(int bands, int channels, const SHI_T *factors, const SHI_T *in)
{
    SHI_T windowed[SH_MAX_BANDS * SH_MAX_BANDS], where[3];
    int c;

    for (c = 0; c < channels; c++, in += bands * bands) {
        if (factors) SHI_FN(sh_scale_bands)(bands, factors, in, windowed);
        if (!(SHI_FN(shi_lowest)(bands, factors ? windowed : in, 1, where) >= 0)) return 0;
    }
    return 1;
}

/* Does a window of width 1/inverse_width suffice to make them so? */
SHI_INLINE int SHI_FN(shi_window_suffices)(int kind, int bands, int channels, double inverse_width, const SHI_T *in)
{
    SHI_T factors[SH_MAX_BANDS];
    SHI_FN(shi_window_factors)(kind, bands, 1 / inverse_width, factors);
    return SHI_FN(shi_non_negative)(bands, channels, factors, in);
}

/* Window a light just enough to make it non-negative: the widest window of a kind, the same for all channels.
 *   kind       as in sh_window
 *   bands      1..32
 *   channels   1..65536
 *   in, out    [channels][N], apart. A channel whose mean is not positive cannot be mended: SH_ERROR_OPTION; NaN or Inf in one,
 *              or sums that leave the numbers' range, are SH_ERROR_NOT_FINITE
 *   width      the width used, in bands, or 0 if none was needed; NULL or apart from out
 * The minimum of the result, as sh_minimum finds it, is not negative; at a width 1e-5 larger it is (Hann and Lanczos, whose
 * minimum is not monotonic in the width: the widest in a scan in steps of 1/16 of the inverse width, then refined).
 * Source: S08 for the windows; their width is found here. */
SH_API int SHI_FN(sh_dering)(int kind, int bands, int channels, const SHI_T *in, SHI_T *out, SHI_T *width)
{
    double low = 0, high;
    size_t bytes;
    SHI_T factors[SH_MAX_BANDS];
    int c, k, n;

    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (channels < 1 || channels > 1 << 16) return SH_ERROR_COUNT;
    if (kind < SH_HANN || kind > SH_GAUSS) return SH_ERROR_OPTION;
    if (!in || !out) return SH_ERROR_NULL;
    n = bands * bands;
    bytes = (size_t)(channels * n) * sizeof *in;
    if (shi_overlap(in, bytes, out, bytes) || shi_overlap(width, sizeof *width, out, bytes)) return SH_ERROR_OVERLAP;
    if (!SHI_FN(shi_finite)(in, bytes / sizeof *in)) return SH_ERROR_NOT_FINITE;
    for (c = 0; c < channels; c++)
        if (!(in[c * n] > 0)) return SH_ERROR_OPTION;
    if (SHI_FN(shi_non_negative)(bands, channels, NULL, in)) {
        memcpy(out, in, bytes);
        if (width) *width = 0;
        return SH_OK;
    }
    for (high = 1.0 / 16; !SHI_FN(shi_window_suffices)(kind, bands, channels, high, in); high += high < 1 ? 1.0 / 16 : high) {
        low = high;
        if (high > 64) return SH_ERROR_NOT_FINITE;          /* the range of the numbers is exceeded */
    }
    for (k = 0; k < 40 && high - low > 1e-6 * high; k++) {
        const double middle = 0.5 * (low + high);
        if (SHI_FN(shi_window_suffices)(kind, bands, channels, middle, in)) high = middle;
        else low = middle;
    }
    SHI_FN(shi_window_factors)(kind, bands, 1 / high, factors);
    for (c = 0; c < channels; c++) SHI_FN(sh_scale_bands)(bands, factors, in + c * n, out + c * n);
    if (width) *width = (SHI_T)(1 / high);
    return SH_OK;
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
