/* sh_gradient.h - spherical harmonics, their derivatives, and the light of spheres
 *
 * USE
 *     #include "sh_gradient.h"      copy this one file; no other file, no implementation macro, libm only
 *
 * CONVENTIONS (shared by every sh_*.h)
 *     basis      real, orthonormal over the sphere, z polar: integral of Y_i Y_j = [i == j]
 *     index      i = l(l+1) + m, l = 0 .. bands-1, m = -l .. l; N = bands^2 coefficients
 *     sign       Sloan's: the Condon-Shortley factor (-1)^m is in, so Y_1 = 0.48860 (-y, +z, -x)
 *     precision  every function exists as _f32 and _f64, from the same lines
 *     gradient   of lights: by the shading point; of the basis: by the vector v in Y(v/|v|)
 *     planes     [1][N] value; [3][N] d/dx d/dy d/dz; [6][N] xx xy xz yy yz zz
 *     light      unit radiance unless a radiance is passed
 *
 * FUNCTIONS (search for SHI_FN(sh_eval))               one item; _n many, plain layout; _blocks many, blocked
 *     sh_eval, _n, _blocks                            basis values
 *     sh_eval_grad, _n, _blocks                       ... and Cartesian gradient, no pole, any length of v
 *     sh_eval_hessian, _n, _blocks                    ... and Hessian
 *     sh_eval_angles, _n                              ... and derivatives by theta and phi (M22)
 *     sh_reconstruct, _n                              sum c_i Y_i and its gradient, basis never stored
 *     sh_project_n                                    sum of weighted samples
 *     sh_light_field                                  samples with depth and normal: coefficients and gradient (A04)
 *     sh_zonal_cap, sh_zonal_rotate, sh_zonal_light   caps, zonal harmonics to any axis, any f(distance)
 *     sh_sphere, sh_sphere_hessian                    one spherical light
 *     sh_spheres, _n, _grid                           sums of many, with radiance per channel
 *     sh_status_string                                what a returned status means
 *
 * STATUS
 *     0 SH_OK; < 0 an error, outputs untouched; > 0 a defined degenerate case. Where each item has outputs of its own
 *     (_n, _blocks), a bad direction leaves its own untouched, the others are written, and the call returns the error of the
 *     last bad one. Of several mistakes in a call it returns one; a count of 0 needs no arrays.
 *     Nothing prints, allocates or keeps state; errno means nothing (libm may set it).
 *
 * CONFIG (define before the first include)
 *     SH_API                storage of public functions              [static inline]
 *     SH_VECTOR_BYTES       0, 16, 32: register width                [widest the compiler targets]
 *     SH_WIDE_BYTES         the same or 64: width for sums           [64 with AVX-512F]
 *     SH_UNROLLED_BANDS     1..10: bodies unrolled up to this band count; smaller is less code where it is a variable [10]
 *     SH_GRADIENT_FILENAME  the name this file has in your tree      ["sh_gradient.h"]
 *     The widths follow the compiler's target; fused multiply-add needs -ffp-contract=fast (GCC's default in GNU dialects).
 *
 * DOES NOT
 *     denormal or overflowing geometry: lengths from 1e-18 to 1e18 in float (1e-150 .. 1e150 in double); the bounds hold
 *     for results that are not denormal, of sums of spheres beyond 10 bands for magnitudes above 1e-31 (1e-300)
 *     bit-identity between instruction sets or compilers; within one build, -ffast-math aside, a batch has the bits of
 *     its single items (sums of polygons: to rounding)
 *
 * SOURCES
 *     M22   Mezieres et al. 2022, spherical lights and SH gradients (equation numbers are theirs)
 *     A04   Annen et al. 2004, spherical harmonic gradients for mid-range illumination
 *     S13   Sloan 2013, efficient spherical harmonic evaluation
 *
 * ERRORS in comments: eps = FLT_EPSILON or DBL_EPSILON, M_l = sqrt((2l+1)/(4 pi)), G_l = sqrt(l(l+1)(2l+1)/(8 pi)).
 *
 * HOW THIS FILE WORKS
 *     It includes itself. SHI_ROOM names the part being compiled: kernels once per lane type (a scalar, or a GCC/Clang
 *     vector), tables and public functions once per precision. Kernels use operators and the leaf operations only.
 */
#if !defined(SHI_ROOM)
#ifndef SH_GRADIENT_H
#define SH_GRADIENT_H

#include <math.h>
#include <stddef.h>
#include <string.h>

#define SH_VERSION_MAJOR 1
#define SH_VERSION_MINOR 0
#define SH_VERSION_PATCH 0

enum { SH_MAX_BANDS = 32 };                             /* basis, lights, interpolation                         */
enum { SH_BLOCK = 8 };                                  /* items in a block of the blocked layout, every ISA    */
enum { SH_VALUES = 1, SH_GRADIENT = 4, SH_HESSIAN = 10 };   /* planes of N: value; + gradient; + Hessian        */

enum {
    SH_ON_LIGHT = 2,                /* the point lies on a polygon light                                        */
    SH_INSIDE = 1,                  /* the point lies on or inside a sphere light                               */
    SH_OK = 0,
    SH_ERROR_NULL = -1,             /* a required pointer is NULL                                               */
    SH_ERROR_BANDS = -2,            /* bands outside the function's range                                       */
    SH_ERROR_COUNT = -3,            /* a count or a number of channels is not valid                             */
    SH_ERROR_OVERLAP = -4,          /* input and output overlap                                                 */
    SH_ERROR_DIRECTION = -5,        /* zero direction, or a length out of range                                 */
    SH_ERROR_NOT_FINITE = -6,       /* NaN or infinity in geometry                                              */
    SH_ERROR_RADIUS = -7,           /* a radius, depth or angle out of range                                    */
    SH_ERROR_VERTICES = -8,         /* fewer than three vertices                                                */
    SH_ERROR_MATRIX = -9,           /* not a rotation                                                           */
    SH_ERROR_OPTION = -10,          /* an unknown option or number of planes, or a parameter out of range       */
    SH_ERROR_GRID = -11             /* an axis without nodes, or a cell size that is not positive               */
};

/* ---- configuration ---- */

#if (defined(__GNUC__) || defined(__clang__)) && !defined(__TINYC__)      /* clang-cl is not __GNUC__ */
#  define SHI_GNU
#endif
#if defined(SHI_GNU)
#  define SHI_INLINE   static __inline__ __attribute__((__unused__))
#  define SHI_KERNEL   static __inline__ __attribute__((__always_inline__, __unused__))
#  if defined(__OPTIMIZE__)
#    define SHI_NOINLINE static __attribute__((__noinline__, __unused__))
#  else                     /* a debug build leaves out only what is called inline */
#    define SHI_NOINLINE SHI_INLINE
#  endif
#elif defined(_MSC_VER)
#  define SHI_INLINE   static __inline
#  define SHI_KERNEL   static __forceinline
#  define SHI_NOINLINE static __declspec(noinline)
#else
#  define SHI_INLINE   static inline
#  define SHI_KERNEL   static inline
#  define SHI_NOINLINE static inline
#endif
#ifndef SH_API
#  define SH_API SHI_INLINE
#endif

#ifndef SH_VECTOR_BYTES
#  if !defined(SHI_GNU)
#    define SH_VECTOR_BYTES 0
#  elif defined(__AVX__)
#    define SH_VECTOR_BYTES 32
#  elif defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__)
#    define SH_VECTOR_BYTES 16
#  else
#    define SH_VECTOR_BYTES 0
#  endif
#endif
#ifndef SH_WIDE_BYTES
#  if SH_VECTOR_BYTES == 32 && defined(__AVX512F__)
#    define SH_WIDE_BYTES 64
#  else
#    define SH_WIDE_BYTES SH_VECTOR_BYTES
#  endif
#endif
#if SH_VECTOR_BYTES != 0 && SH_VECTOR_BYTES != 16 && SH_VECTOR_BYTES != 32
#  error "SH_VECTOR_BYTES is 0, 16 or 32"
#endif
#if SH_WIDE_BYTES != SH_VECTOR_BYTES && (SH_WIDE_BYTES != 64 || SH_VECTOR_BYTES == 0 || !defined(__AVX512F__))
#  error "SH_WIDE_BYTES is SH_VECTOR_BYTES or, with AVX-512F, 64"
#endif
#if defined(__x86_64__) && SH_VECTOR_BYTES == 32 && !defined(__AVX__)
#  error "SH_VECTOR_BYTES 32 needs AVX"
#endif
#ifndef SH_UNROLLED_BANDS
#  define SH_UNROLLED_BANDS 10
#endif
#if SH_UNROLLED_BANDS < 1 || SH_UNROLLED_BANDS > 10
#  error "SH_UNROLLED_BANDS is 1 to 10"
#endif
#ifndef SH_GRADIENT_FILENAME
#  define SH_GRADIENT_FILENAME "sh_gradient.h"
#endif

#if defined(__clang__)
#  define SHI_UNROLL _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__) && __GNUC__ >= 8 && defined(__OPTIMIZE__)
#  define SHI_UNROLL _Pragma("GCC unroll 64")
#else
#  define SHI_UNROLL
#endif
#if defined(SHI_GNU)
#  define SHI_RARELY(condition) __builtin_expect((condition), 0)
#else
#  define SHI_RARELY(condition) (condition)
#endif
#if defined(__has_builtin)
#  if __has_builtin(__builtin_elementwise_sqrt)
#    define SHI_SQRT_ELEMENTWISE
#  endif
#  if __has_builtin(__builtin_shufflevector)
#    define SHI_SHUFFLE
#  endif
#endif

#define SHI_STAGE 32768                                 /* bytes of stack that batches stage blocks in: one, or as many as ... */
#define SHI_WARM (SHI_STAGE / 4)                        /* ... leave the first cache room for what they become; ... */
#define SHI_BIG_STAGE 131072                            /* ... of many bands one may take so many */
#define SHI_POOL 720                                    /* vectors on the stack: weights of a block of lights ... */
#define SHI_SUMS 992                                    /* ... running sums ... */
#define SHI_LIGHTS_AT_ONCE 11                           /* ... and most vectors in a block: at 16 rows would evict each other */
#define SHI_POLYNOMIAL_BANDS 10                         /* bands whose columns shi_horner has as polynomials */
#if defined(__AVX512VL__) || defined(__aarch64__)       /* beyond, columns that run at once: what 32 or 16 registers hold; */
#  define SHI_ABREAST 6                                 /* the ring holds twice as many */
#else
#  define SHI_ABREAST 4
#endif
#define SHI_PROFILE 9                                   /* numbers per band in shi_profile */
#define SHI_TABLE_AT(l, m) ((l) * ((l) + 1) / 2 + (m))  /* index into tables by band and m */

#define SHI_POLYNOMIAL_SIZE 100                         /* coefficients of SHI_POLYNOMIAL_BANDS bands */
#define SHI_HORNER(l, m, k) (SHI_FN(shi_horner)[(k) * SHI_POLYNOMIAL_SIZE + (l) * ((l) + 1) + (m)])
/* index into what shi_sum_form fills, and to the node of its Newton's form */
#define SHI_FORM_AT(parity, k, sign, m) ((((parity) * (SH_MAX_BANDS / 2) + (k)) * 2 + (sign)) * SH_MAX_BANDS + (m))
#define SHI_NODES(k, m) ((k) * (SH_MAX_BANDS - 1 - (k)) + (m))

#define SHI_MOST(numbers) ((size_t)-1 / 16 / (size_t)(numbers))        /* items of so many numbers: half the addresses */

#define SHI_PI           3.14159265358979323846
#define SHI_TAU          6.28318530717958647693
#define SHI_ROOT_FOUR_PI 3.54490770181103205460
#define SHI_Y00          0.28209479177387814347

/* sums take at least a column at a time, of 34 bands or of 12 in three channels, weights at least a vector */
typedef char shi_sums_fit[SHI_SUMS >= 2 * 6 * (SH_MAX_BANDS + 2) && SHI_SUMS >= 3 * 2 * 6 * 12
                          && SHI_POOL >= (2 + 6) * (SH_MAX_BANDS + 2) + 1 ? 1 : -1];

#define SHI_CAT_(a, b) a##b
#define SHI_CAT(a, b)  SHI_CAT_(a, b)

/* return fixed(n, ...), a body for each band count up to SH_UNROLLED_BANDS, or any(n, ...), one for all beyond */
#define SHI_BODY(k, fixed, ...) \
    case k: if (k <= SH_UNROLLED_BANDS) return fixed(k <= SH_UNROLLED_BANDS ? k : 1, __VA_ARGS__); break;
#define SHI_BANDS(n, fixed, any, ...) \
    switch (n) { \
        SHI_BODY(1, fixed, __VA_ARGS__) SHI_BODY(2, fixed, __VA_ARGS__) SHI_BODY(3, fixed, __VA_ARGS__) \
        SHI_BODY(4, fixed, __VA_ARGS__) SHI_BODY(5, fixed, __VA_ARGS__) SHI_BODY(6, fixed, __VA_ARGS__) \
        SHI_BODY(7, fixed, __VA_ARGS__) SHI_BODY(8, fixed, __VA_ARGS__) SHI_BODY(9, fixed, __VA_ARGS__) \
        SHI_BODY(10, fixed, __VA_ARGS__) \
    default: break; \
    } \
    return any(n, __VA_ARGS__);

/* ---- rooms ---- */

#define SHI_INSTANTIATE 1       /* compile the rooms of SHI_FILE for every precision and lane type              */
#define SHI_PRECISION   2       /* ... for one precision, SHI_BITS                                              */
#define SHI_TABLES      3       /* once per precision                                                           */
#define SHI_KERNELS     4       /* once per lane type, SHI_LANES                                                */
#define SHI_BASIS       5       /* the basis kernels, twice per lane type: unrolled, and for any band count     */
#define SHI_PUBLIC      6       /* once per precision                                                           */

/* What the rooms are written in:
 *     SHI_T  SHI_I        float or double, and the integer of its size; SHI_C(x) a constant, SHI_LIBM(sqrt) a function of it
 *     SHI_V  SHI_M        a lane or a register of them, SHI_W of them; the mask that comparing two gives
 *     SHI_FN(x)           x_f32 or x_f64, what exists once per precision
 *     SHI_KN(x)           x_f32x8: x once per lane type. From outside: SHI_ONE(x) of one lane, SHI_MANY(x) of a register,
 *                         SHI_WIDE(x) of the widest
 *     SHI_BN(x)           in the basis room x_fixed or x_any: for a constant band count, loops (SHI_LOOP) unrolled, and for any
 *     SHI_KERNEL          always inline;  SHI_INLINE may be;  SHI_NOINLINE never, where it keeps registers or stack apart */
#define SHI_W           SHI_LANES
#define SHI_KN(name)    SHI_CAT(SHI_CAT(SHI_FN(name), x), SHI_LANES)
#define SHI_V           SHI_KN(shi_vector)
#define SHI_M           SHI_KN(shi_mask)
#define SHI_U           SHI_KN(shi_unsigned)
#define SHI_D           SHI_KN(shi_doubles)
#define SHI_SPLAT(s)    SHI_KN(shi_splat)(s)
#define SHI_LOAD(p)     SHI_KN(shi_load)(p)
#define SHI_STORE(p, v) SHI_KN(shi_store)(p, v)
#define SHI_PUT(p, v, single) SHI_KN(shi_put)(p, v, single)
#define SHI_SQRT(v)     SHI_KN(shi_sqrt)(v)
#define SHI_RSQRT(v)    SHI_KN(shi_rsqrt)(v)
#define SHI_RSQRT_ROUGHLY(v) SHI_KN(shi_rsqrt_roughly)(v)
#define SHI_FMA(a, b, c) SHI_KN(shi_fma)(a, b, c)
#define SHI_FNMA(a, b, c) SHI_KN(shi_fnma)(a, b, c)
#define SHI_ABS(v)      SHI_KN(shi_abs)(v)
#define SHI_SUM(v)      SHI_KN(shi_sum)(v)
#define SHI_ANY(m)      SHI_KN(shi_any)(m)
#define SHI_KEEP(v)     SHI_KN(shi_keep)(v)
#define SHI_BITS_OF(v)  SHI_KN(shi_bits)(v)

/* what each status means, for people */
SH_API const char *sh_status_string(int status)
{
    switch (status) {
    case SH_ON_LIGHT:         return "point on a polygon light";
    case SH_INSIDE:           return "point on or inside a sphere light";
    case SH_OK:               return "ok";
    case SH_ERROR_NULL:       return "required pointer is NULL";
    case SH_ERROR_BANDS:      return "number of bands out of range";
    case SH_ERROR_COUNT:      return "count out of range";
    case SH_ERROR_OVERLAP:    return "input and output overlap";
    case SH_ERROR_DIRECTION:  return "direction is zero or its length out of range";
    case SH_ERROR_NOT_FINITE: return "NaN or infinite input";
    case SH_ERROR_RADIUS:     return "radius or depth or angle out of range";
    case SH_ERROR_VERTICES:   return "polygon has fewer than three vertices";
    case SH_ERROR_MATRIX:     return "matrix is not a rotation";
    case SH_ERROR_OPTION:     return "unknown option or parameter out of range";
    case SH_ERROR_GRID:       return "grid axis without nodes or cell size not positive";
    default:                  return "unknown status";
    }
}

enum { SHI_IS_INSIDE = 1, SHI_NOT_FINITE = 2, SHI_BAD_RADIUS = 4 };     /* what a sum of lights met */

SHI_INLINE int shi_abs(int i) { return i < 0 ? -i : i; }

/* items in that many blocks, or more than any call takes */
SHI_INLINE size_t shi_block_items(size_t blocks)
{
    return blocks > (size_t)-1 / SH_BLOCK ? (size_t)-1 : blocks * SH_BLOCK;
}

/* 1 if the byte ranges share a byte; a NULL or empty range shares none */
SHI_INLINE int shi_overlap(const void *a, size_t a_bytes, const void *b, size_t b_bytes)
{
    const char *p = (const char *)a, *q = (const char *)b;
    return p && q && a_bytes && b_bytes && p < q + b_bytes && q < p + a_bytes;
}

/* band and order of coefficient i, of the first 10 bands; constants where loops are unrolled */
static const signed char shi_band_of[SHI_POLYNOMIAL_SIZE] = {
    0,
    1, 1, 1,
    2, 2, 2, 2, 2,
    3, 3, 3, 3, 3, 3, 3,
    4, 4, 4, 4, 4, 4, 4, 4, 4,
    5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5,
    6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6,
    7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7,
    8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8,
    9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9
};
static const signed char shi_order_of[SHI_POLYNOMIAL_SIZE] = {
    0,
    -1, 0, 1,
    -2, -1, 0, 1, 2,
    -3, -2, -1, 0, 1, 2, 3,
    -4, -3, -2, -1, 0, 1, 2, 3, 4,
    -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5,
    -6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6,
    -7, -6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7,
    -8, -7, -6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8,
    -9, -8, -7, -6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9
};

#define SHI_FILE SH_GRADIENT_FILENAME
#define SHI_ROOM SHI_INSTANTIATE
#include SH_GRADIENT_FILENAME

#endif /* SH_GRADIENT_H */

/* ================================================================================================================
 * Instantiation: SHI_FILE's rooms for every precision and lane type. Every sh_*.h enters here.
 * ============================================================================================================= */
#elif SHI_ROOM == SHI_INSTANTIATE

#undef  SHI_ROOM
#define SHI_ROOM SHI_PRECISION
#define SHI_BITS 32
#include SH_GRADIENT_FILENAME
#undef  SHI_BITS
#define SHI_BITS 64
#include SH_GRADIENT_FILENAME
#undef  SHI_BITS
#undef  SHI_ROOM
#undef  SHI_FILE

#elif SHI_ROOM == SHI_PRECISION

#if SHI_BITS == 32
#  define SHI_T         float
#  define SHI_I         int
#  define SHI_FN(name)  SHI_CAT(name, _f32)
#  define SHI_EPS       1.1920929e-7f
#  define SHI_MIN2      1e-36f              /* range of a squared length */
#  define SHI_MAX2      1e37f
#  define SHI_VAST      1e19f               /* a radius that holds all points in range */
#  define SHI_NEAR      1e-4f               /* | |v|^2 - 1 | below which one Newton step normalises v */
#  define SHI_LIBM(name) SHI_CAT(name, f)
#else
#  define SHI_T         double
#  define SHI_I         long long
#  define SHI_FN(name)  SHI_CAT(name, _f64)
#  define SHI_EPS       2.220446049250313e-16
#  define SHI_MIN2      1e-301
#  define SHI_MAX2      1e301
#  define SHI_VAST      1e151
#  define SHI_NEAR      4e-9
#  define SHI_LIBM(name) name
#endif
#define SHI_C(c)        ((SHI_T)(c))

#define SHI_ONE(name)   SHI_CAT(SHI_FN(name), x1)

#undef  SHI_ROOM
#define SHI_ROOM SHI_TABLES
#include SHI_FILE

#undef  SHI_ROOM
#define SHI_ROOM SHI_KERNELS
#define SHI_BYTES (SHI_BITS / 8)
#define SHI_LANES 1
#define SHI_SELECT(m, a, b) ((m) ? (a) : (b))
#define SHI_CONVERT(v, type) ((type)(v))
#include SHI_FILE
#undef  SHI_LANES
#undef  SHI_BYTES
#undef  SHI_SELECT
#undef  SHI_CONVERT
#define SHI_SELECT(m, a, b) ((SHI_V)(((m) & (SHI_M)(a)) | (~(m) & (SHI_M)(b))))
#define SHI_CONVERT(v, type) __builtin_convertvector(v, type)
#if SH_VECTOR_BYTES
#  define SHI_BYTES SH_VECTOR_BYTES
#  if SH_VECTOR_BYTES * 8 / SHI_BITS == 2
#    define SHI_LANES 2
#  elif SH_VECTOR_BYTES * 8 / SHI_BITS == 4
#    define SHI_LANES 4
#  else
#    define SHI_LANES 8
#  endif
#  define SHI_MANY_LANES SHI_LANES        /* tells kernels that they are the register-wide instance */
#  include SHI_FILE
#  undef  SHI_LANES
#  undef  SHI_BYTES
#  undef  SHI_MANY_LANES
#endif
#if SH_WIDE_BYTES > SH_VECTOR_BYTES
#  define SHI_BYTES SH_WIDE_BYTES
#  if SH_WIDE_BYTES * 8 / SHI_BITS == 8
#    define SHI_LANES 8
#  else
#    define SHI_LANES 16
#  endif
#  include SHI_FILE
#  undef  SHI_LANES
#  undef  SHI_BYTES
#endif
#undef  SHI_SELECT
#undef  SHI_CONVERT

/* kernels by lane type: SHI_ONE one lane, SHI_MANY a register, SHI_WIDE the widest register */
#if SH_VECTOR_BYTES == 0
#  define SHI_MANY(name) SHI_ONE(name)
#elif SH_VECTOR_BYTES * 8 / SHI_BITS == 2
#  define SHI_MANY(name) SHI_CAT(SHI_FN(name), x2)
#elif SH_VECTOR_BYTES * 8 / SHI_BITS == 4
#  define SHI_MANY(name) SHI_CAT(SHI_FN(name), x4)
#else
#  define SHI_MANY(name) SHI_CAT(SHI_FN(name), x8)
#endif
#if SH_WIDE_BYTES == SH_VECTOR_BYTES
#  define SHI_WIDE(name) SHI_MANY(name)
#elif SHI_BITS == 32
#  define SHI_WIDE(name) SHI_CAT(SHI_FN(name), x16)
#else
#  define SHI_WIDE(name) SHI_CAT(SHI_FN(name), x8)
#endif
#undef  SHI_ROOM
#define SHI_ROOM SHI_PUBLIC
#include SHI_FILE

#undef SHI_ONE
#undef SHI_MANY
#undef SHI_WIDE
#undef SHI_T
#undef SHI_I
#undef SHI_FN
#undef SHI_EPS
#undef SHI_MIN2
#undef SHI_MAX2
#undef SHI_VAST
#undef SHI_NEAR
#undef SHI_LIBM
#undef SHI_C
#undef  SHI_ROOM
#define SHI_ROOM SHI_PRECISION

/* ================================================================================================================
 * Kernels: once per lane type.
 * ============================================================================================================= */
#elif SHI_ROOM == SHI_KERNELS

/* ---- leaf operations: all that differs between a lane and a register ---- */

#if SHI_LANES == 1
typedef SHI_T SHI_V;
typedef SHI_I SHI_M;
typedef double SHI_D;                                       /* as many lanes of double */
#else
__extension__ typedef SHI_T SHI_V __attribute__((__vector_size__(SHI_BYTES)));
__extension__ typedef SHI_I SHI_M __attribute__((__vector_size__(SHI_BYTES)));
__extension__ typedef unsigned SHI_I SHI_U __attribute__((__vector_size__(SHI_BYTES)));
__extension__ typedef double SHI_D __attribute__((__vector_size__(8 * SHI_LANES)));
#endif

SHI_KERNEL SHI_V SHI_LOAD(const SHI_T *p)          { SHI_V v; memcpy(&v, p, sizeof v); return v; }
SHI_KERNEL void  SHI_STORE(SHI_T *p, SHI_V v)      { memcpy(p, &v, sizeof v); }
SHI_KERNEL void  SHI_PUT(SHI_T *p, SHI_V v, int single)    /* all lanes, or the first */
{
    if (single) memcpy(p, &v, sizeof(SHI_T));
    else memcpy(p, &v, sizeof v);
}
SHI_KERNEL SHI_M SHI_BITS_OF(SHI_V v)              { SHI_M m; memcpy(&m, &v, sizeof m); return m; }
SHI_KERNEL SHI_M SHI_KN(shi_sign)(SHI_V v)                  /* the sign bit alone */
{
    return SHI_BITS_OF(v) & ~(SHI_I)(((unsigned long long)1 << (SHI_BITS - 1)) - 1);
}
SHI_KERNEL SHI_V SHI_KN(shi_flip)(SHI_V v, SHI_M signs)     /* -v where the sign bit is set */
{
    const SHI_M m = SHI_BITS_OF(v) ^ signs;
    memcpy(&v, &m, sizeof v);
    return v;
}
SHI_KERNEL SHI_V SHI_KN(shi_reverse)(SHI_V v)
{
#if SHI_LANES == 1
    return v;
#elif defined(SHI_SHUFFLE) && SHI_LANES == 2
    return __builtin_shufflevector(v, v, 1, 0);
#elif defined(SHI_SHUFFLE) && SHI_LANES == 4
    return __builtin_shufflevector(v, v, 3, 2, 1, 0);
#elif defined(SHI_SHUFFLE) && SHI_LANES == 8
    return __builtin_shufflevector(v, v, 7, 6, 5, 4, 3, 2, 1, 0);
#else
    SHI_V r = v;
    int i;
    for (i = 0; i < SHI_W; i++) r[i] = v[SHI_W - 1 - i];
    return r;
#endif
}
#if SHI_LANES == 1
SHI_KERNEL SHI_V SHI_SPLAT(SHI_T s)                { return s; }
SHI_KERNEL SHI_V SHI_SQRT(SHI_V v)                 { return SHI_LIBM(sqrt)(v); }
SHI_KERNEL SHI_V SHI_ABS(SHI_V v)                  { return SHI_LIBM(fabs)(v); }
SHI_KERNEL SHI_V SHI_RSQRT(SHI_V v)                { return SHI_C(1) / SHI_LIBM(sqrt)(v); }
SHI_KERNEL SHI_V SHI_RSQRT_ROUGHLY(SHI_V v)        { return SHI_RSQRT(v); }
SHI_KERNEL SHI_T SHI_KN(shi_first)(SHI_V v)        { return v; }
SHI_KERNEL SHI_T SHI_SUM(SHI_V v)                  { return v; }
SHI_KERNEL int   SHI_ANY(SHI_M m)                  { return m != 0; }
SHI_KERNEL SHI_V SHI_KEEP(SHI_V v)                 { return v; }
#else
SHI_KERNEL SHI_V SHI_SPLAT(SHI_T s)                { SHI_V v; memset(&v, 0, sizeof v); return s - v; }
SHI_KERNEL SHI_T SHI_KN(shi_first)(SHI_V v)        { return v[0]; }
SHI_KERNEL SHI_V SHI_ABS(SHI_V v)
{
    const SHI_M m = SHI_BITS_OF(v) & (SHI_I)(((unsigned long long)1 << (SHI_BITS - 1)) - 1);
    memcpy(&v, &m, sizeof v);
    return v;
}
/* IEEE square root per lane; a loop of sqrtf stays scalar unless -fno-math-errno (gcc 12, clang 14) */
SHI_KERNEL SHI_V SHI_SQRT(SHI_V v)
{
#if defined(SHI_SQRT_ELEMENTWISE)
    return __builtin_elementwise_sqrt(v);
#elif defined(__SSE2__) && SHI_BYTES == 16 && SHI_BITS == 32
    return __builtin_ia32_sqrtps(v);
#elif defined(__SSE2__) && SHI_BYTES == 16
    return __builtin_ia32_sqrtpd(v);
#elif defined(__AVX__) && SHI_BYTES == 32 && SHI_BITS == 32
    return __builtin_ia32_sqrtps256(v);
#elif defined(__AVX__) && SHI_BYTES == 32
    return __builtin_ia32_sqrtpd256(v);
#elif defined(__AVX512F__) && SHI_BYTES == 64 && SHI_BITS == 32 && defined(__clang__)
    return __builtin_ia32_sqrtps512(v, 4);
#elif defined(__AVX512F__) && SHI_BYTES == 64 && defined(__clang__)
    return __builtin_ia32_sqrtpd512(v, 4);
#elif defined(__AVX512F__) && SHI_BYTES == 64 && SHI_BITS == 32
    return __builtin_ia32_sqrtps512_mask(v, v, (short)-1, 4);
#elif defined(__AVX512F__) && SHI_BYTES == 64
    return __builtin_ia32_sqrtpd512_mask(v, v, (char)-1, 4);
#else
    int i;
    for (i = 0; i < SHI_W; i++) v[i] = SHI_LIBM(sqrt)(v[i]);
    return v;
#endif
}
/* 1/sqrt to 14 bits at least, the same on every machine of an instruction set */
SHI_KERNEL SHI_V SHI_RSQRT_ROUGHLY(SHI_V v)
{
#if defined(__AVX512F__) && SHI_BYTES == 64 && SHI_BITS == 32
    return __builtin_ia32_rsqrt14ps512_mask(v, v, (unsigned short)-1);
#elif defined(__AVX512VL__) && SHI_BYTES == 32 && SHI_BITS == 32
    return __builtin_ia32_rsqrt14ps256_mask(v, v, (unsigned char)-1);
#else
    return SHI_C(1) / SHI_SQRT(v);
#endif
}
/* 1/sqrt to 1 ulp: with a Newton step where that is faster than to divide */
SHI_KERNEL SHI_V SHI_RSQRT(SHI_V v)
{
#if defined(__AVX512F__) && SHI_BYTES == 64 && SHI_BITS == 32
    const SHI_V e = SHI_RSQRT_ROUGHLY(v);
    const SHI_V h = SHI_C(0.5) * e, r = SHI_C(0.5) - (v * e) * h;
    return e + e * r;
#else
    return SHI_C(1) / SHI_SQRT(v);
#endif
}
/* pairwise: lane i with lane i + half, in ever narrower registers */
SHI_KERNEL SHI_T SHI_SUM(SHI_V v)
{
#if SHI_LANES == 2
    return v[0] + v[1];
#elif SHI_BYTES == 16
    __extension__ typedef SHI_T part __attribute__((__vector_size__(16)));
    const part p = v;
#elif SHI_BYTES == 32
    __extension__ typedef SHI_T part __attribute__((__vector_size__(16)));
    part t[2], p;
    memcpy(t, &v, sizeof t);
    p = t[0] + t[1];
#else
    __extension__ typedef SHI_T half __attribute__((__vector_size__(32)));
    __extension__ typedef SHI_T part __attribute__((__vector_size__(16)));
    half h[2];
    part t[2], p;
    memcpy(h, &v, sizeof h);
    h[0] += h[1];
    memcpy(t, &h[0], sizeof t);
    p = t[0] + t[1];
#endif
#if SHI_LANES > 2 && SHI_BITS == 32
    return (p[0] + p[2]) + (p[1] + p[3]);
#elif SHI_LANES > 2
    return p[0] + p[1];
#endif
}
/* a lane whose sign bit is set, as in the mask of a comparison that holds */
SHI_KERNEL int SHI_ANY(SHI_M m)
{
#if defined(__AVX__) && SHI_BYTES >= 32
    __extension__ typedef SHI_T half __attribute__((__vector_size__(32)));
    half t[SHI_BYTES / 32];
    memcpy(t, &m, sizeof t);
#  if SHI_BITS == 32
    return (__builtin_ia32_movmskps256(t[0]) | __builtin_ia32_movmskps256(t[SHI_BYTES / 32 - 1])) != 0;
#  else
    return (__builtin_ia32_movmskpd256(t[0]) | __builtin_ia32_movmskpd256(t[SHI_BYTES / 32 - 1])) != 0;
#  endif
#elif defined(__SSE2__) && SHI_BYTES == 16 && SHI_BITS == 32
    return __builtin_ia32_movmskps((SHI_V)m) != 0;
#elif defined(__SSE2__) && SHI_BYTES == 16
    return __builtin_ia32_movmskpd((SHI_V)m) != 0;
#else
    unsigned long long t[SHI_BYTES / 8], any = 0;
    int i;
    memcpy(t, &m, sizeof t);
    SHI_UNROLL
    for (i = 0; i < SHI_BYTES / 8; i++) any |= t[i];
    return (any & (SHI_BITS == 32 ? 0x8000000080000000u : 0x8000000000000000u)) != 0;
#endif
}
/* v in a register: without it gcc folds one load into every use, and loads are the scarce port in sums */
SHI_KERNEL SHI_V SHI_KEEP(SHI_V v)
{
#if defined(__AVX512F__)
    __asm__("" : "+v"(v));
#elif defined(__SSE2__)
    __asm__("" : "+x"(v));
#endif
    return v;
}
/* a0 b0 a1 b1 ..., lower and upper half */
SHI_KERNEL void SHI_KN(shi_zip)(SHI_V a, SHI_V b, SHI_V *lo, SHI_V *hi)
{
#if defined(SHI_SHUFFLE) && SHI_LANES == 2
    *lo = __builtin_shufflevector(a, b, 0, 2);
    *hi = __builtin_shufflevector(a, b, 1, 3);
#elif defined(SHI_SHUFFLE) && SHI_LANES == 4
    *lo = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    *hi = __builtin_shufflevector(a, b, 2, 6, 3, 7);
#elif defined(SHI_SHUFFLE) && SHI_LANES == 8
    *lo = __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
    *hi = __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
#else
    int i;
    for (i = 0; i < SHI_W; i++) {
        if (i < SHI_W / 2) { (*lo)[2 * i] = a[i]; (*lo)[2 * i + 1] = b[i]; }
        else               { (*hi)[2 * i - SHI_W] = a[i]; (*hi)[2 * i + 1 - SHI_W] = b[i]; }
    }
#endif
}
/* for one direction with its coefficients in the lanes: lane numbers come from loops, and are constants once those are
 * unrolled */
#if defined(SHI_SHUFFLE) && defined(SHI_MANY_LANES) && SHI_LANES >= 4
#define SHI_BY_LINE
/* lane i: of a and b side by side, lane from[i] */
SHI_KERNEL SHI_V SHI_KN(shi_choose)(SHI_V a, SHI_V b, SHI_M from)
{
#if !defined(__clang__)
    return __builtin_shuffle(a, b, from);
#elif defined(__AVX512VL__) && SHI_BYTES == 32 && SHI_BITS == 32        /* else clang makes long chains of blends */
    return __builtin_ia32_vpermi2varps256(a, from, b);
#elif defined(__AVX512VL__) && SHI_BYTES == 32
    return __builtin_ia32_vpermi2varpd256(a, from, b);
#else
    SHI_V v = a;
    int i;
    SHI_UNROLL
    for (i = 0; i < SHI_W; i++) v[i] = from[i] < SHI_W ? a[from[i] & (SHI_W - 1)] : b[from[i] & (SHI_W - 1)];
    return v;
#endif
}
#endif
#endif
/* a in the lanes with a flag, b in the others */
SHI_KERNEL SHI_V SHI_KN(shi_blend)(const int *flags, SHI_V a, SHI_V b)
{
    SHI_I lane[SHI_W];
    SHI_M m;
    int i;
    SHI_UNROLL
#if defined(SHI_BY_LINE) && !defined(__clang__)
    for (i = 0; i < SHI_W; i++) lane[i] = flags[i] ? i : SHI_W + i;
    memcpy(&m, lane, sizeof m);
    return SHI_KN(shi_choose)(a, b, m);
#else
    for (i = 0; i < SHI_W; i++) lane[i] = flags[i] ? -1 : 0;
    memcpy(&m, lane, sizeof m);
    return SHI_SELECT(m, a, b);
#endif
}
/* a in the lanes i with i & bits = value, b in the others */
SHI_KERNEL SHI_V SHI_KN(shi_where)(int bits, int value, SHI_V a, SHI_V b)
{
    int flags[SHI_W], i;
    SHI_UNROLL
    for (i = 0; i < SHI_W; i++) flags[i] = (i & bits) == value;
    return SHI_KN(shi_blend)(flags, a, b);
}

/* a*b + c, rounded once where the target can: wherever a batch must have the bits of single calls, since what the compiler
 * contracts may differ from one inlined copy to the next. Elsewhere contraction is left to it. */
SHI_KERNEL SHI_V SHI_FMA(SHI_V a, SHI_V b, SHI_V c)
{
#if SHI_LANES == 1 && SHI_BITS == 32 && (defined(__FMA__) || defined(__aarch64__))
    return __builtin_fmaf(a, b, c);
#elif SHI_LANES == 1 && (defined(__FMA__) || defined(__aarch64__))
    return __builtin_fma(a, b, c);
#elif SHI_BYTES == 16 && SHI_BITS == 32 && defined(__FMA__)
    return __builtin_ia32_vfmaddps(a, b, c);
#elif SHI_BYTES == 16 && defined(__FMA__)
    return __builtin_ia32_vfmaddpd(a, b, c);
#elif SHI_BYTES == 32 && SHI_BITS == 32 && defined(__FMA__)
    return __builtin_ia32_vfmaddps256(a, b, c);
#elif SHI_BYTES == 32 && defined(__FMA__)
    return __builtin_ia32_vfmaddpd256(a, b, c);
#elif SHI_BYTES == 64 && SHI_BITS == 32 && defined(__clang__)
    return __builtin_ia32_vfmaddps512_mask(a, b, c, (unsigned short)-1, 4);
#elif SHI_BYTES == 64 && defined(__clang__)
    return __builtin_ia32_vfmaddpd512_mask(a, b, c, (unsigned char)-1, 4);
#elif SHI_BYTES == 64 && SHI_BITS == 32
    return __builtin_ia32_vfmaddps512_mask(a, b, c, -1, 4);
#elif SHI_BYTES == 64
    return __builtin_ia32_vfmaddpd512_mask(a, b, c, (unsigned char)-1, 4);
#elif defined(__aarch64__)
    int i;                                              /* gcc and clang make one fmla of it */
    for (i = 0; i < SHI_W; i++)
        c[i] = SHI_BITS == 32 ? (SHI_T)__builtin_fmaf((float)a[i], (float)b[i], (float)c[i])
                              : (SHI_T)__builtin_fma((double)a[i], (double)b[i], (double)c[i]);
    return c;
#else
    return a * b + c;
#endif
}
/* c - a*b; gcc 12 would keep -a in a register */
SHI_KERNEL SHI_V SHI_FNMA(SHI_V a, SHI_V b, SHI_V c)
{
#if SHI_BYTES == 32 && SHI_BITS == 32 && defined(__FMA__) && !defined(__clang__)
    return __builtin_ia32_vfnmaddps256(a, b, c);
#elif SHI_BYTES == 32 && defined(__FMA__) && !defined(__clang__)
    return __builtin_ia32_vfnmaddpd256(a, b, c);
#else
    return SHI_FMA(-a, b, c);
#endif
}
/* P_l(z)'s recurrence, and its derivatives', by differences: b_l = p_{l-1} - p_l = r t p_{l-1} + (r - 1) b_{l-1}, t = 1 - |z|
 * and r = (2l-1)/(l+m). Two multiply-adds where they are fused; else three products, whose roundings weigh less */
SHI_KERNEL SHI_V SHI_KN(shi_fall)(SHI_V r, SHI_V t, SHI_V p, SHI_V b)
{
#if defined(__FMA__) || defined(__aarch64__)
    return SHI_FMA(r, SHI_FMA(t, p, b), -b);
#else
    return (r * t) * p + (r - 1) * b;
#endif
}
/* what rounding took from s = d * d: one multiply-add where there is a fused one, else Dekker's product */
SHI_KERNEL SHI_V SHI_KN(shi_square_error)(SHI_V d, SHI_V s)
{
#if defined(__FMA__) || defined(__aarch64__)
    return SHI_FMA(d, d, -s);
#else
    const SHI_V u = SHI_SPLAT(SHI_C(SHI_BITS == 32 ? 4097.0 : 134217729.0)) * d, hi = u - (u - d), lo = d - hi;
    return ((hi * hi - s) + (hi + hi) * lo) + lo * lo;
#endif
}
/* cosine and sine of |a| <= pi/2: sine/a and cosine in a^2 are mpmath.chebyfit's on [0, (pi/2)^2], 5 and 6 terms for float
 * (errors 4.3e-9, 2.3e-10), 10 and 10 for double (7e-21) */
SHI_KERNEL void SHI_KN(shi_cos_sin_near)(SHI_V a, SHI_V *c, SHI_V *s)
{
#if SHI_BITS == 32
    enum { SINES = 5, COSINES = 6 };
    static const float sines[5] = { 0.99999999569880902f, -0.16666657947846011f, 0.0083330501706717732f,
        -0.00019809017408678004f, 2.6051076353347881e-6f };
    static const float cosines[6] = { 0.99999999977915403f, -0.49999999355437857f, 0.041666636159723193f,
        -0.0013888360284403018f, 2.4760109673159874e-5f, -2.6050657493719743e-7f };
#else
    enum { SINES = 10, COSINES = 10 };
    static const double sines[10] = { 1.0, -0.16666666666666667, 0.008333333333333333, -0.0001984126984126967,
        2.7557319223940713e-6, -2.5052108378602197e-8, 1.6059043206300948e-10, -7.6471277399664175e-13,
        2.8102145350022103e-15, -7.9825189617838324e-18 };
    static const double cosines[10] = { 1.0, -0.5, 0.04166666666666666, -0.001388888888888853,
        2.4801587301492642e-5, -2.755731920965447e-7, 2.0876755666578905e-9, -1.1470670165323271e-11,
        4.7768722491448073e-14, -1.5119827834217994e-16 };
#endif
    const SHI_V square = a * a;
    SHI_V sine = SHI_SPLAT(sines[SINES - 1]), cosine = SHI_SPLAT(cosines[COSINES - 1]);
    int i;
    SHI_UNROLL
    for (i = SINES - 2; i >= 0; i--) sine = SHI_FMA(sine, square, SHI_SPLAT(sines[i]));
    SHI_UNROLL
    for (i = COSINES - 2; i >= 0; i--) cosine = SHI_FMA(cosine, square, SHI_SPLAT(cosines[i]));
    *s = a * sine;
    *c = cosine;
}
/* of |a| <= SHI_MOST_ANGLE, to an ulp of 1: by what k quarter turns leave, pi/2 in pieces whose products with k are exact */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)             /* could put the pieces together again: the C library instead */
#define SHI_MOST_ANGLE SHI_C(0)
#else
#define SHI_MOST_ANGLE (SHI_BITS == 32 ? SHI_C(6000) : SHI_C(1e6))
#endif
SHI_KERNEL void SHI_KN(shi_cos_sin_turned)(SHI_V a, SHI_V *c, SHI_V *s)
{
#if SHI_BITS == 32
    static const float quarter[3] = { 1.5703125f, 0.0004837512969970703125f, 7.549789954891882e-8f };
#else
    static const double quarter[3] = { 1.57079632673412561416626, 6.077100506303965976595549e-11, 2.022266248795950732e-21 };
#endif
    const SHI_V half = SHI_SELECT((SHI_M)(a < SHI_SPLAT(0)), SHI_SPLAT(SHI_C(-0.5)), SHI_SPLAT(SHI_C(0.5)));
    const SHI_M k = SHI_CONVERT(SHI_FMA(SHI_SPLAT(SHI_C(0.63661977236758134308)), a, half), SHI_M);
    const SHI_M odd = -(k & 1), minus = SHI_KN(shi_sign)(SHI_SPLAT(-1));
    const SHI_V turns = SHI_CONVERT(k, SHI_V);
    SHI_V cosine, sine;
    int i;
    SHI_UNROLL
    for (i = 0; i < 3; i++) a = SHI_FNMA(turns, SHI_SPLAT(quarter[i]), a);
    SHI_KN(shi_cos_sin_near)(a, &cosine, &sine);
    *c = SHI_KN(shi_flip)(SHI_SELECT(odd, sine, cosine), -(((k + 1) & 2) >> 1) & minus);
    *s = SHI_KN(shi_flip)(SHI_SELECT(odd, cosine, sine), -((k & 2) >> 1) & minus);
}
/* (c, s) times (x, y) as complex numbers */
SHI_KERNEL void SHI_KN(shi_turn)(SHI_V x, SHI_V y, SHI_V *c, SHI_V *s)
{
    const SHI_V t = SHI_FMA(x, *c, -(y * *s));
    *s = SHI_FMA(x, *s, y * *c);
    *c = t;
}
/* (x, y) squared; additions, for machines whose multipliers are busy */
SHI_KERNEL void SHI_KN(shi_square)(SHI_V x, SHI_V y, SHI_V *c, SHI_V *s)
{
    const SHI_V xy = x * y;
    *c = (x - y) * (x + y);
    *s = xy + xy;
}
/* c[m], s[m] = U_m, V_m from those below, U_m + i V_m = (-x - iy)^m: by the power of two below m, the short way */
SHI_KERNEL void SHI_KN(shi_power)(int m, const SHI_V u[4], SHI_V *c, SHI_V *s)
{
    const int h = m >= 16 ? 16 : m >= 8 ? 8 : m >= 4 ? 4 : m >= 2 ? 2 : 1;
    if (m < 2) {
        c[m] = m ? -u[0] : SHI_SPLAT(1);
        s[m] = m ? -u[1] : SHI_SPLAT(0);
    } else if (m == h) {
        SHI_KN(shi_square)(c[h / 2], s[h / 2], &c[m], &s[m]);
    } else {
        c[m] = c[m - h];
        s[m] = s[m - h];
        SHI_KN(shi_turn)(c[h], s[h], &c[m], &s[m]);
    }
}

/* the same for all m < n in loops, which have no use for the above */
SHI_KERNEL void SHI_KN(shi_powers_below)(int n, const SHI_V u[4], SHI_V *c, SHI_V *s)
{
    SHI_V ch = -u[0], sh = -u[1];
    int h, m;
    for (m = 0; m < 2; m++) SHI_KN(shi_power)(m, u, c, s);
    for (h = 2; h < n; h *= 2) {
        SHI_KN(shi_square)(ch, sh, &ch, &sh);
        c[h] = ch;
        s[h] = sh;
        for (m = 1; m < h && h + m < n; m++) {
            SHI_V x = c[m], y = s[m];
            SHI_KN(shi_turn)(ch, sh, &x, &y);
            c[h + m] = x;
            s[h + m] = y;
        }
    }
}

/* the same with the orders in the lanes: register r from order r W on */
SHI_KERNEL void SHI_KN(shi_powers)(int n, const SHI_V u[4], SHI_V *c, SHI_V *s)
{
    SHI_V hc[SH_MAX_BANDS / 2 + 1], hs[SH_MAX_BANDS / 2 + 1];       /* of powers of two, in all lanes */
    int r, h;
    hc[1] = -u[0];
    hs[1] = -u[1];
    SHI_UNROLL
    for (h = 2; h < SH_MAX_BANDS; h *= 2)
        if (h < n) SHI_KN(shi_square)(hc[h / 2], hs[h / 2], &hc[h], &hs[h]);
    c[0] = SHI_KN(shi_where)(1, 1, hc[1], SHI_SPLAT(1));
    s[0] = SHI_KN(shi_where)(1, 1, hs[1], SHI_SPLAT(0));
    SHI_UNROLL
    for (h = 2; h < SHI_W; h *= 2) {
        SHI_V tc = c[0], ts = s[0];
        if (h < n - 1) SHI_KN(shi_turn)(hc[h], hs[h], &tc, &ts);
        if (h < n) {
            c[0] = SHI_KN(shi_where)(2 * h - 1, h, hc[h], SHI_KN(shi_where)(h, h, tc, c[0]));
            s[0] = SHI_KN(shi_where)(2 * h - 1, h, hs[h], SHI_KN(shi_where)(h, h, ts, s[0]));
        }
    }
    SHI_UNROLL
    for (r = 1; r < SH_MAX_BANDS / SHI_W; r++) {
        const int m = r * SHI_W, top = m >= 16 ? 16 : m >= 8 ? 8 : m >= 4 ? 4 : 2;
        if (m < n) {
            c[r] = c[r - top / SHI_W];
            s[r] = s[r - top / SHI_W];
            SHI_KN(shi_turn)(hc[top], hs[top], &c[r], &s[r]);
            if (m == top) {
                c[r] = SHI_KN(shi_where)(SHI_W - 1, 0, hc[top], c[r]);
                s[r] = SHI_KN(shi_where)(SHI_W - 1, 0, hs[top], s[r]);
            }
        }
    }
    SHI_UNROLL
    for (r = 0; r < SH_MAX_BANDS / SHI_W; r++)          /* or clang sees through them and takes lanes one by one */
        if (r * SHI_W < n) {
            c[r] = SHI_KEEP(c[r]);
            s[r] = SHI_KEEP(s[r]);
        }
}

/* |y - x|^2 - r^2 in twice the working precision, d = y - x: what is left decides everything near a light.
 * Float computes in double; double carries the rounding errors along (Knuth's sum). */
SHI_KERNEL SHI_V SHI_KN(shi_gap)(const SHI_V y[3], const SHI_T x[3], SHI_V r)
{
#if SHI_BITS == 32
    const SHI_D a = SHI_CONVERT(y[0], SHI_D) - (double)x[0], b = SHI_CONVERT(y[1], SHI_D) - (double)x[1];
    const SHI_D c = SHI_CONVERT(y[2], SHI_D) - (double)x[2], d = SHI_CONVERT(r, SHI_D);
    return SHI_CONVERT(a * a + b * b + c * c - d * d, SHI_V);
#else
    SHI_V sum = SHI_SPLAT(0), low = SHI_SPLAT(0);
    int k;
    for (k = 0; k < 4; k++) {                       /* d0^2 + d1^2 + d2^2 - r^2 */
        const SHI_V p = k < 3 ? y[k] : r, q = SHI_SPLAT(k < 3 ? x[k] : 0), sign = SHI_SPLAT(k < 3 ? 1 : -1);
        const SHI_V d = p - q, t = d - p, e = (p - (d - t)) - (q + t);          /* p - q = d + e */
        const SHI_V s = d * d, f = SHI_KN(shi_square_error)(d, s);              /* d * d = s + f */
        const SHI_V n = sum + sign * s, w = n - sum;
        low = low + ((sum - (n - w)) + (sign * s - w)) + sign * (f + (d + d) * e);
        sum = n;
    }
    return sum + low;
#endif
}

/* lanes not in [lo, hi], of positive numbers; by bits, so NaN and infinity are out with -ffast-math too */
SHI_KERNEL SHI_M SHI_KN(shi_out_of)(SHI_V v, SHI_T lo, SHI_T hi)
{
#if SHI_LANES == 1
    SHI_I a, b;
    const SHI_M m = SHI_BITS_OF(v);
    memcpy(&a, &lo, sizeof a);
    memcpy(&b, &hi, sizeof b);
    return m < a || m > b;
#else
    unsigned SHI_I a, b;                /* which wrap; the sign bit is all that SHI_ANY looks at */
    const SHI_U m = (SHI_U)v;
    memcpy(&a, &lo, sizeof a);
    memcpy(&b, &hi, sizeof b);
    return (SHI_M)((m - a) | (b - m));
#endif
}
SHI_KERNEL int SHI_KN(shi_in_range)(SHI_V v, SHI_T lo, SHI_T hi)
{
    return !SHI_ANY(SHI_KN(shi_out_of)(v, lo, hi));
}
/* alone: all lanes hold the same, so one look is enough */
SHI_KERNEL int SHI_KN(shi_all_in_range)(SHI_V v, int alone, SHI_T lo, SHI_T hi)
{
    return alone ? SHI_ONE(shi_in_range)(SHI_KN(shi_first)(v), lo, hi) : SHI_KN(shi_in_range)(v, lo, hi);
}

/* |v|^2 - 1, and x^2 + y^2 */
SHI_KERNEL SHI_V SHI_KN(shi_excess)(const SHI_V v[3], SHI_V *r2)
{
    *r2 = SHI_FMA(v[0], v[0], v[1] * v[1]);
    return SHI_FMA(v[2], v[2], SHI_SPLAT(-1)) + *r2;
}

/* u = v/|v| = v + s v of a v with a small excess e, and u[3] = z^2 - 1/2 = 1/2 - (x^2 + y^2), exact to eps/4 at the poles
 * and the equator: what rounding does to x^2 + y^2 is in e as well, and cancels. 1 + s = 1/sqrt(1 + e) is 1 - e/2 where
 * `unit` holds (everywhere if NULL), one term more elsewhere. The length is right to eps/4. Returns s */
SHI_KERNEL SHI_V SHI_KN(shi_polish)(const SHI_V v[3], SHI_V e, SHI_V r2, const SHI_M *unit, SHI_V u[4])
{
    SHI_V s = SHI_C(-0.5) * e, shrunk = e;
    if (unit) {
        s = SHI_SELECT(*unit, s, e * SHI_FMA(SHI_SPLAT(SHI_C(0.375)), e, SHI_SPLAT(SHI_C(-0.5))));
        shrunk = SHI_SELECT(*unit, e, SHI_FMA(-e, e, e));
    }
    u[0] = SHI_FMA(v[0], s, v[0]);              /* no loop: an array that a loop walks stays in memory */
    u[1] = SHI_FMA(v[1], s, v[1]);
    u[2] = SHI_FMA(v[2], s, v[2]) + SHI_SPLAT(0);       /* no -0 */
    u[3] = SHI_FMA(r2, shrunk, SHI_C(0.5) - r2);
    return s;
}

/* unit vectors and 1/length of vectors of any length; 0 if one is out of range. Nearly unit ones, the usual case, take a
 * shorter path; what a lane gets does not depend on the path that its neighbours need */
SHI_KERNEL int SHI_KN(shi_unit)(const SHI_V v[3], int alone, SHI_V u[4], SHI_V *inverse)
{
    SHI_V r2;
    const SHI_V e = SHI_KN(shi_excess)(v, &r2), off = SHI_ABS(e);
    if (SHI_RARELY(!SHI_KN(shi_all_in_range)(off, alone, 0, SHI_NEAR))) {
        const SHI_M unit = alone ? SHI_BITS_OF(SHI_SPLAT(0)) : (SHI_M)(off <= SHI_SPLAT(SHI_NEAR));
        const SHI_V length2 = SHI_FMA(v[2], v[2], r2), scale = SHI_SELECT(unit, SHI_SPLAT(1), SHI_RSQRT_ROUGHLY(length2));
        SHI_V w[3], left;
        w[0] = v[0] * scale;
        w[1] = v[1] * scale;
        w[2] = v[2] * scale;
        left = SHI_KN(shi_excess)(w, &r2);
        *inverse = SHI_FMA(scale, SHI_KN(shi_polish)(w, left, r2, &unit, u), scale);
        return SHI_KN(shi_all_in_range)(length2, alone, SHI_MIN2, SHI_MAX2);
    }
    *inverse = SHI_C(1) + SHI_KN(shi_polish)(v, e, r2, NULL, u);
    return 1;
}

/* unit vector from cosine and sine of theta, of phi, as shi_polish has it */
SHI_KERNEL void SHI_KN(shi_angles_unit)(const SHI_V f[4], SHI_V u[4])
{
    u[0] = f[1] * f[2];
    u[1] = f[1] * f[3];
    u[2] = f[0];
    u[3] = SHI_FNMA(f[1], f[1], SHI_SPLAT(SHI_C(0.5)));
}

#if defined(SHI_SHUFFLE) && SHI_LANES > 1
#define SHI_PIECE (128 / SHI_BITS)                      /* lanes of 16 bytes: shuffles within such pieces are the cheap ones */
/* of every piece, these elements of a and, counted on, of b */
#define SHI_PICK(i, piece) ((i) / SHI_PIECE * SHI_LANES + (piece) * SHI_PIECE + (i) % SHI_PIECE)
#if SHI_BITS == 32
#define SHI_PICKS(piece, i, j, k, l) SHI_PICK(i, piece), SHI_PICK(j, piece), SHI_PICK(k, piece), SHI_PICK(l, piece)
#else
#define SHI_PICKS(piece, i, j) SHI_PICK(i, piece), SHI_PICK(j, piece)
#endif
#if SHI_BYTES == 16
#define SHI_IN_PIECES(a, b, ...) __builtin_shufflevector(a, b, SHI_PICKS(0, __VA_ARGS__))
#elif SHI_BYTES == 32
#define SHI_IN_PIECES(a, b, ...) __builtin_shufflevector(a, b, SHI_PICKS(0, __VA_ARGS__), SHI_PICKS(1, __VA_ARGS__))
#else
#define SHI_IN_PIECES(a, b, ...) __builtin_shufflevector(a, b, SHI_PICKS(0, __VA_ARGS__), SHI_PICKS(1, __VA_ARGS__), \
                                                         SHI_PICKS(2, __VA_ARGS__), SHI_PICKS(3, __VA_ARGS__))
#endif
#if defined(__AVX__) && !defined(__clang__) && SHI_BITS == 32      /* gcc would load b and shuffle, clang inserts */
#define SHI_JOIN(a, b) __builtin_ia32_vinsertf128_ps256(__builtin_ia32_ps256_ps(a), b, 1)
#elif defined(__AVX__) && !defined(__clang__)
#define SHI_JOIN(a, b) __builtin_ia32_vinsertf128_pd256(__builtin_ia32_pd256_pd(a), b, 1)
#elif SHI_BITS == 32
#define SHI_JOIN(a, b) __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7)
#else
#define SHI_JOIN(a, b) __builtin_shufflevector(a, b, 0, 1, 2, 3)
#endif
/* the pieces at p, p + step, ... */
SHI_KERNEL SHI_V SHI_KN(shi_load_pieces)(const SHI_T *p, int step)
{
    __extension__ typedef SHI_T piece __attribute__((__vector_size__(16), __aligned__(SHI_BITS / 8), __may_alias__));
#define SHI_AT_PIECE(i) (*(const piece *)(p + (i) * step))
#if SHI_BYTES == 16
    (void)step;
    return SHI_AT_PIECE(0);
#elif SHI_BYTES == 32
    return SHI_JOIN(SHI_AT_PIECE(0), SHI_AT_PIECE(1));
#elif SHI_BITS == 32
    return __builtin_shufflevector(SHI_JOIN(SHI_AT_PIECE(0), SHI_AT_PIECE(1)), SHI_JOIN(SHI_AT_PIECE(2), SHI_AT_PIECE(3)),
                                   0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#else
    return __builtin_shufflevector(SHI_JOIN(SHI_AT_PIECE(0), SHI_AT_PIECE(1)), SHI_JOIN(SHI_AT_PIECE(2), SHI_AT_PIECE(3)),
                                   0, 1, 2, 3, 4, 5, 6, 7);
#endif
#undef SHI_AT_PIECE
}
/* a piece of 16 bytes to each p + i step */
SHI_KERNEL void SHI_KN(shi_store_pieces)(SHI_T *p, int step, SHI_V v)
{
    __extension__ typedef SHI_T piece __attribute__((__vector_size__(16)));
    piece t[SHI_BYTES / 16];
    int i;
    memcpy(t, &v, sizeof v);
    SHI_UNROLL
    for (i = 0; i < SHI_BYTES / 16; i++) memcpy(p + i * step, &t[i], sizeof t[i]);
}
#endif

/* W vectors from the first `lanes` of W triples; the last one again past the end */
SHI_KERNEL void SHI_KN(shi_load3)(const SHI_T *p, int lanes, SHI_V v[3])
{
#if SHI_LANES == 1
    (void)lanes;
    v[0] = p[0];
    v[1] = p[1];
    v[2] = p[2];
#else
    SHI_T t[3 * SHI_W];
#if defined(SHI_PIECE)
    SHI_V a, b, c;
#endif
    int i;
    if (lanes < SHI_W) {
        for (i = 0; i < SHI_W; i++) memcpy(t + 3 * i, p + 3 * (i < lanes ? i : lanes - 1), 3 * sizeof *t);
        p = t;
    }
#if defined(SHI_PIECE)                                  /* x0 y0 z0 x1 | y1 z1 x2 y2 | z2 x3 y3 z3 */
    a = SHI_KN(shi_load_pieces)(p, 3 * SHI_PIECE);
    b = SHI_KN(shi_load_pieces)(p + SHI_PIECE, 3 * SHI_PIECE);
    c = SHI_KN(shi_load_pieces)(p + 2 * SHI_PIECE, 3 * SHI_PIECE);
#if SHI_BITS == 32
    v[0] = SHI_IN_PIECES(b, c, 2, 3, 5, 6);
    v[1] = SHI_IN_PIECES(a, b, 1, 2, 4, 5);
    v[2] = SHI_IN_PIECES(v[1], c, 1, 3, 4, 7);
    v[1] = SHI_IN_PIECES(v[1], v[0], 0, 2, 5, 7);
    v[0] = SHI_IN_PIECES(a, v[0], 0, 3, 4, 6);
#else
    v[0] = SHI_IN_PIECES(a, b, 0, 3);
    v[1] = SHI_IN_PIECES(a, c, 1, 2);
    v[2] = SHI_IN_PIECES(b, c, 0, 3);
#endif
#else
    for (i = 0; i < SHI_W; i++) {
        v[0][i] = p[3 * i];
        v[1][i] = p[3 * i + 1];
        v[2][i] = p[3 * i + 2];
    }
#endif
#endif
}

/* `lanes` numbers, then the last one again */
SHI_KERNEL SHI_V SHI_KN(shi_load_some)(const SHI_T *p, int lanes)
{
    SHI_T t[SHI_W];
    int i;
    if (lanes == SHI_W) return SHI_LOAD(p);
    for (i = 0; i < SHI_W; i++) t[i] = p[i < lanes ? i : lanes - 1];
    return SHI_LOAD(t);
}

/* v[3] to W triples */
SHI_KERNEL void SHI_KN(shi_store3)(SHI_T *p, const SHI_V v[3])
{
#if defined(SHI_PIECE) && SHI_BYTES == 64               /* number n = r W + i: x or y of its triple, then z where it is */
#define SHI_XY(r, i) (((r) * SHI_W + (i)) / 3 + (((r) * SHI_W + (i)) % 3 == 1 ? SHI_W : 0))
#define SHI_AND_Z(r, i) (((r) * SHI_W + (i)) % 3 == 2 ? SHI_W + ((r) * SHI_W + (i)) / 3 : (i))
#define SHI_8(f, r, i) f(r, i), f(r, (i) + 1), f(r, (i) + 2), f(r, (i) + 3), f(r, (i) + 4), f(r, (i) + 5), f(r, (i) + 6), \
                       f(r, (i) + 7)
#if SHI_LANES == 16
#define SHI_EACH(f, r) SHI_8(f, r, 0), SHI_8(f, r, 8)
#else
#define SHI_EACH(f, r) SHI_8(f, r, 0)
#endif
#define SHI_TRIPLES(r) \
    SHI_STORE(p + (r) * SHI_W, __builtin_shufflevector(__builtin_shufflevector(v[0], v[1], SHI_EACH(SHI_XY, r)), v[2], \
                                                       SHI_EACH(SHI_AND_Z, r)))
    SHI_TRIPLES(0);
    SHI_TRIPLES(1);
    SHI_TRIPLES(2);
#undef SHI_TRIPLES
#undef SHI_EACH
#undef SHI_8
#undef SHI_AND_Z
#undef SHI_XY
#elif defined(SHI_PIECE) && SHI_BITS == 32
    const SHI_V a = SHI_IN_PIECES(v[0], v[1], 0, 2, 4, 6), b = SHI_IN_PIECES(v[1], v[2], 1, 3, 5, 7);
    const SHI_V c = SHI_IN_PIECES(v[2], v[0], 0, 2, 5, 7);
    SHI_KN(shi_store_pieces)(p, 3 * SHI_PIECE, SHI_IN_PIECES(a, c, 0, 2, 4, 6));
    SHI_KN(shi_store_pieces)(p + SHI_PIECE, 3 * SHI_PIECE, SHI_IN_PIECES(b, a, 0, 2, 5, 7));
    SHI_KN(shi_store_pieces)(p + 2 * SHI_PIECE, 3 * SHI_PIECE, SHI_IN_PIECES(c, b, 1, 3, 5, 7));
#elif defined(SHI_PIECE)
    SHI_KN(shi_store_pieces)(p, 3 * SHI_PIECE, SHI_IN_PIECES(v[0], v[1], 0, 2));
    SHI_KN(shi_store_pieces)(p + SHI_PIECE, 3 * SHI_PIECE, SHI_IN_PIECES(v[2], v[0], 0, 3));
    SHI_KN(shi_store_pieces)(p + 2 * SHI_PIECE, 3 * SHI_PIECE, SHI_IN_PIECES(v[1], v[2], 1, 3));
#else
    SHI_T t[3][SHI_W];
    int i, k;
    for (k = 0; k < 3; k++) SHI_STORE(t[k], v[k]);
    for (i = 0; i < SHI_W; i++)
        for (k = 0; k < 3; k++) p[3 * i + k] = t[k][i];
#endif
}

/* cosine and sine of finite angles, large ones by the C library */
SHI_KERNEL void SHI_KN(shi_cos_sin)(SHI_V a, SHI_V *c, SHI_V *s)
{
    SHI_T angle[SHI_W], cosine[SHI_W], sine[SHI_W];
    int i;
    if (SHI_KN(shi_in_range)(SHI_ABS(a), 0, SHI_MOST_ANGLE)) {
        SHI_KN(shi_cos_sin_turned)(a, c, s);
        return;
    }
    SHI_STORE(angle, a);
    for (i = 0; i < SHI_W; i++) {
        cosine[i] = SHI_LIBM(cos)(angle[i]);
        sine[i] = SHI_LIBM(sin)(angle[i]);
        if (SHI_ONE(shi_in_range)(SHI_ONE(shi_abs)(angle[i]), 0, SHI_MOST_ANGLE))
            SHI_ONE(shi_cos_sin_turned)(angle[i], &cosine[i], &sine[i]);
    }
    *c = SHI_LOAD(cosine);
    *s = SHI_LOAD(sine);
}

/* W directions, ready for the basis */
typedef struct {
    SHI_V u[4], inverse;
    int good;
} SHI_KN(shi_direction);
#define SHI_IN_BLOCK (SHI_W < SH_BLOCK ? SH_BLOCK / SHI_W : 1)
SHI_KERNEL void SHI_KN(shi_direct_block)(const SHI_T *d, SHI_KN(shi_direction) *o)     /* [3][8] */
{
    SHI_V v[3];
    v[0] = SHI_LOAD(d);
    v[1] = SHI_LOAD(d + SH_BLOCK);
    v[2] = SHI_LOAD(d + 2 * SH_BLOCK);
    o->good = SHI_KN(shi_unit)(v, 0, o->u, &o->inverse);
}
SHI_KERNEL void SHI_KN(shi_direct_plain)(const SHI_T *d, size_t count, SHI_KN(shi_direction) *o)       /* [count][3] */
{
    SHI_V v[3];
    SHI_KN(shi_load3)(d, count < SHI_W ? (int)count : SHI_W, v);
    o->good = SHI_KN(shi_unit)(v, 0, o->u, &o->inverse);
}

#if defined(SHI_PIECE) && SHI_BYTES <= 32
/* W rows of W elements, `pitch` apart, to W rows of out: a piece of W rows at a time */
SHI_KERNEL void SHI_KN(shi_transpose_square)(const SHI_T *rows, int pitch, SHI_T *out, size_t stride)
{
    SHI_V a[SHI_PIECE], b[SHI_PIECE];
    int first, i;
    SHI_UNROLL
    for (first = 0; first < SHI_W; first += SHI_PIECE) {
        SHI_UNROLL
        for (i = 0; i < SHI_PIECE; i++)
            a[i] = SHI_KN(shi_load_pieces)(rows + i * pitch + first, SHI_PIECE * pitch);
#if SHI_PIECE == 4
        b[0] = SHI_IN_PIECES(a[0], a[2], 0, 4, 1, 5);
        b[1] = SHI_IN_PIECES(a[0], a[2], 2, 6, 3, 7);
        b[2] = SHI_IN_PIECES(a[1], a[3], 0, 4, 1, 5);
        b[3] = SHI_IN_PIECES(a[1], a[3], 2, 6, 3, 7);
        a[0] = SHI_IN_PIECES(b[0], b[2], 0, 4, 1, 5);
        a[1] = SHI_IN_PIECES(b[0], b[2], 2, 6, 3, 7);
        a[2] = SHI_IN_PIECES(b[1], b[3], 0, 4, 1, 5);
        a[3] = SHI_IN_PIECES(b[1], b[3], 2, 6, 3, 7);
#else
        b[0] = SHI_IN_PIECES(a[0], a[1], 0, 2);
        b[1] = SHI_IN_PIECES(a[0], a[1], 1, 3);
        a[0] = b[0];
        a[1] = b[1];
#endif
        SHI_UNROLL
        for (i = 0; i < SHI_PIECE; i++) SHI_STORE(out + (size_t)(first + i) * stride, a[i]);
    }
}
#define SHI_SQUARES
#endif

/* block[rows][W], rows `pitch` elements apart, to W rows of out, `stride` apart, the first `lanes` of them */
SHI_KERNEL void SHI_KN(shi_transpose_block)(const SHI_T *block, int pitch, int rows, SHI_T *out, size_t stride, int lanes)
{
    int r, i;
#if defined(SHI_SQUARES)
    if (lanes == SHI_W && rows >= SHI_W) {
        for (r = 0; r + 1 < rows; r += SHI_W) {
            if (r + SHI_W > rows) r = rows - SHI_W;                 /* the last square overlaps the one before */
            SHI_KN(shi_transpose_square)(block + r * pitch, pitch, out + r, stride);
        }
        SHI_UNROLL
        for (i = 0; i < SHI_W && r < rows; i++) out[(size_t)i * stride + (size_t)r] = block[r * pitch + i];
        return;
    }
#endif
    for (i = 0; i < lanes; i++)
        for (r = 0; r < rows; r++) out[(size_t)i * stride + (size_t)r] = block[r * pitch + i];
}
#undef SHI_SQUARES

/* block[rows][8] to 8 rows of out */
SHI_INLINE void SHI_KN(shi_scatter)(const SHI_T *block, int rows, SHI_T *out, size_t stride, int lanes)
{
    int i;
    for (i = 0; i < lanes; i += SHI_W)
        SHI_KN(shi_transpose_block)(block + i, SH_BLOCK, rows, out + (size_t)i * stride, stride,
                                    lanes - i < SHI_W ? lanes - i : SHI_W);
}

/* ---- basis: the bodies in the SHI_BASIS room, unrolled for a band count known when compiling, and for any ---- */

#undef  SHI_ROOM
#define SHI_ROOM SHI_BASIS
#define SHI_LOOP
#define SHI_FIXED 0
#define SHI_COLUMN SH_MAX_BANDS
#define SHI_RING (2 * SHI_ABREAST)
#define SHI_BN(name) SHI_KN(SHI_CAT(name, _any))
#include SH_GRADIENT_FILENAME
#undef  SHI_LOOP
#undef  SHI_FIXED
#undef  SHI_BN
#undef  SHI_COLUMN
#undef  SHI_RING
#define SHI_LOOP SHI_UNROLL
#define SHI_FIXED 1
#define SHI_COLUMN SHI_POLYNOMIAL_BANDS
#define SHI_RING 3
#define SHI_BN(name) SHI_KN(SHI_CAT(name, _fixed))
#include SH_GRADIENT_FILENAME
#undef  SHI_LOOP
#undef  SHI_FIXED
#undef  SHI_BN
#undef  SHI_COLUMN
#undef  SHI_RING
#undef  SHI_ROOM
#define SHI_ROOM SHI_KERNELS

/* ---- drivers: a body per band count where that pays; only the functions a program calls are compiled ---- */

SHI_NOINLINE int SHI_KN(shi_blocks_values)(int n, size_t blocks, const SHI_T *dirs, SHI_T *y)
{
    const size_t yn = (size_t)(n * n * SH_BLOCK);
    SHI_BANDS(n, SHI_KN(shi_blocks_fixed), SHI_KN(shi_blocks_any), SH_VALUES, blocks, dirs, y, yn, SH_BLOCK, y, 0, 0, y, 0, 0)
}
SHI_NOINLINE int SHI_KN(shi_blocks_both)(int n, size_t blocks, const SHI_T *dirs, SHI_T *y, size_t yn, SHI_T *g, size_t gn)
{
    SHI_BANDS(n, SHI_KN(shi_blocks_fixed), SHI_KN(shi_blocks_any), SH_GRADIENT, blocks, dirs, y, yn, SH_BLOCK, g, gn,
              SH_BLOCK, g, 0, 0)
}
SHI_NOINLINE int SHI_KN(shi_blocks_gradient)(int n, size_t blocks, const SHI_T *dirs, SHI_T *y, SHI_T *g)
{
    SHI_T discard[3 * SH_UNROLLED_BANDS * SH_UNROLLED_BANDS * SH_BLOCK];
    const size_t size = (size_t)(n * n * SH_BLOCK);
    if (n > SH_UNROLLED_BANDS)
        return SHI_KN(shi_blocks_any)(n, SH_GRADIENT, blocks, dirs, y ? y : discard, y ? size : 0, y ? SH_BLOCK : 0,
                                      g ? g : discard, g ? 3 * size : 0, g ? SH_BLOCK : 0, discard, 0, 0);
    return SHI_KN(shi_blocks_both)(n, blocks, dirs, y ? y : discard, y ? size : 0, g ? g : discard, g ? 3 * size : 0);
}
SHI_NOINLINE int SHI_KN(shi_blocks_hessian)(int n, size_t blocks, const SHI_T *dirs, SHI_T *y, SHI_T *g, SHI_T *h)
{
    SHI_T discard[SH_BLOCK];
    const size_t size = (size_t)(n * n * SH_BLOCK);
    return SHI_KN(shi_blocks_any)(n, SH_HESSIAN, blocks, dirs, y ? y : discard, y ? size : 0, y ? SH_BLOCK : 0,
                                  g ? g : discard, g ? 3 * size : 0, g ? SH_BLOCK : 0,
                                  h ? h : discard, h ? 6 * size : 0, h ? SH_BLOCK : 0);
}

/* plain layout: up to 8 blocks on the stack, transposed; stage holds at least one block of all planes */
SHI_KERNEL int SHI_KN(shi_plain_with)(int n, int planes, size_t count, const SHI_T *dirs, SHI_T *y, SHI_T *g, SHI_T *h,
                                      SHI_T *stage)
{
    const size_t size = (size_t)(n * n), block = size * SH_BLOCK;
    SHI_T v[8][3][SH_BLOCK];
    const size_t fit = SHI_WARM / (block * (size_t)planes * sizeof(SHI_T)), most = fit < 1 ? 1 : fit < 8 ? fit : 8;
    SHI_T *const gb = stage + most * block, *const hb = gb + 3 * most * block;
    int status = SH_OK, i, k, bad;
    size_t p, b, items;
    for (p = 0; p < count; p += items, dirs += 3 * items) {
        items = count - p < most * SH_BLOCK ? count - p : most * SH_BLOCK;
        for (b = 0; b * SH_BLOCK < items; b++)
            for (i = 0; i < SH_BLOCK; i += SHI_W) {
                const size_t at = b * SH_BLOCK + (size_t)i, first = at < items ? at : items - 1, rest = items - first;
                SHI_V d[3];
                SHI_KN(shi_load3)(dirs + 3 * first, rest < SHI_W ? (int)rest : SHI_W, d);
                for (k = 0; k < 3; k++) SHI_STORE(v[b][k] + i, d[k]);
            }
        bad = planes == SH_VALUES   ? SHI_KN(shi_blocks_values)(n, b, v[0][0], stage)
            : planes == SH_GRADIENT ? SHI_KN(shi_blocks_gradient)(n, b, v[0][0], stage, gb)
                                    : SHI_KN(shi_blocks_hessian)(n, b, v[0][0], stage, gb, hb);
        if (bad) {
            status = SHI_FN(shi_one_by_one)(n, planes, items, dirs, 1, 3, y ? y + p * size : stage, y != NULL, y ? n * n : 0,
                                            g ? g + p * 3 * size : stage, g != NULL, g ? 3 * n * n : 0,
                                            h ? h + p * 6 * size : stage, h != NULL, h ? 6 * n * n : 0);
            continue;
        }
        for (b = 0; b * SH_BLOCK < items; b++) {
            const size_t at = p + b * SH_BLOCK;
            const int lanes = items - b * SH_BLOCK < SH_BLOCK ? (int)(items - b * SH_BLOCK) : SH_BLOCK;
            if (y) SHI_KN(shi_scatter)(stage + b * block, n * n, y + at * size, size, lanes);
            if (g) SHI_KN(shi_scatter)(gb + b * 3 * block, 3 * n * n, g + at * 3 * size, 3 * size, lanes);
            if (h) SHI_KN(shi_scatter)(hb + b * 6 * block, 6 * n * n, h + at * 6 * size, 6 * size, lanes);
        }
    }
    return status;
}

SHI_NOINLINE int SHI_KN(shi_plain)(int n, int planes, size_t count, const SHI_T *dirs, SHI_T *y, SHI_T *g, SHI_T *h)
{
    SHI_T stage[SHI_STAGE / sizeof(SHI_T)];
    return SHI_KN(shi_plain_with)(n, planes, count, dirs, y, g, h, stage);
}
SHI_NOINLINE int SHI_KN(shi_plain_big)(int n, int planes, size_t count, const SHI_T *dirs, SHI_T *y, SHI_T *g, SHI_T *h)
{
    SHI_T stage[SHI_BIG_STAGE / sizeof(SHI_T)];
    return SHI_KN(shi_plain_with)(n, planes, count, dirs, y, g, h, stage);
}

/* y, dt, dp [N][W] */
SHI_NOINLINE int SHI_KN(shi_angles_from)(int n, const SHI_V f[4], SHI_T *y, SHI_T *dt, SHI_T *dp)
{
    SHI_BANDS(n, SHI_KN(shi_angles_fixed), SHI_KN(shi_angles_any), f, y, dt, dp)
}

/* one direction: y, dt, dp [N] */
SHI_NOINLINE int SHI_KN(shi_single_angles_from)(int n, const SHI_T f[4], SHI_T *y, SHI_T *dt, SHI_T *dp)
{
#if defined(SHI_BY_LINE)
    SHI_BANDS(n, SHI_KN(shi_line_angles), SHI_ONE(shi_angles_from), f, y, dt, dp)
#else
    return SHI_ONE(shi_angles_from)(n, f, y, dt, dp);
#endif
}
/* the same from the angles, y, dt, dp may be NULL */
SHI_NOINLINE int SHI_KN(shi_single_angles)(int n, SHI_T theta, SHI_T phi, SHI_T *y, SHI_T *dt, SHI_T *dp)
{
    SHI_T discard[SH_MAX_BANDS * SH_MAX_BANDS], f[4];
    if (!SHI_FN(shi_finite)(&theta, 1) || !SHI_FN(shi_finite)(&phi, 1)) return SH_ERROR_NOT_FINITE;
#if SHI_LANES == 1
    SHI_KN(shi_cos_sin)(theta, &f[0], &f[1]);
    SHI_KN(shi_cos_sin)(phi, &f[2], &f[3]);
#else
    {
        SHI_V c, s;
        SHI_KN(shi_cos_sin)(SHI_KN(shi_where)(1, 1, SHI_SPLAT(phi), SHI_SPLAT(theta)), &c, &s);
        f[0] = c[0];
        f[1] = s[0];
        f[2] = c[1];
        f[3] = s[1];
    }
#endif
    return SHI_KN(shi_single_angles_from)(n, f, y ? y : discard, dt ? dt : discard, dp ? dp : discard);
}

/* theta[count], phi[count] to y, dt, dp [count][N] or NULL; stage[3][N][W] */
SHI_KERNEL int SHI_KN(shi_angles_with)(int n, size_t count, const SHI_T *theta, const SHI_T *phi, SHI_T *y, SHI_T *dt, SHI_T *dp,
                                       SHI_T *stage)
{
    const int size = n * n;
    const size_t step = (size_t)size;
    SHI_T *const out[3] = { y, dt, dp };
    int status = SH_OK, i, k;
    size_t p;
    for (p = 0; p < count; p += SHI_W) {
        const int lanes = count - p < SHI_W ? (int)(count - p) : SHI_W;
        SHI_V f[4];
        if (!SHI_FN(shi_finite)(theta + p, (size_t)lanes) || !SHI_FN(shi_finite)(phi + p, (size_t)lanes)) {
            for (i = 0; i < lanes; i++) {
                const size_t at = p + (size_t)i;
                const int bad = SHI_KN(shi_single_angles)(n, theta[at], phi[at], y ? y + at * step : NULL,
                                                          dt ? dt + at * step : NULL, dp ? dp + at * step : NULL);
                status = bad ? bad : status;
            }
            continue;
        }
        SHI_KN(shi_cos_sin)(SHI_KN(shi_load_some)(theta + p, lanes), &f[0], &f[1]);
        SHI_KN(shi_cos_sin)(SHI_KN(shi_load_some)(phi + p, lanes), &f[2], &f[3]);
        SHI_KN(shi_angles_from)(n, f, stage, stage + size * SHI_W, stage + 2 * size * SHI_W);
        for (k = 0; k < 3; k++)
            if (out[k])
                SHI_KN(shi_transpose_block)(stage + k * size * SHI_W, SHI_W, size, out[k] + p * step, step, lanes);
    }
    return status;
}
SHI_NOINLINE int SHI_KN(shi_angles)(int n, size_t count, const SHI_T *theta, const SHI_T *phi, SHI_T *y, SHI_T *dt, SHI_T *dp)
{
    SHI_T stage[SHI_STAGE / sizeof(SHI_T)];
    return SHI_KN(shi_angles_with)(n, count, theta, phi, y, dt, dp, stage);
}
SHI_NOINLINE int SHI_KN(shi_angles_big)(int n, size_t count, const SHI_T *theta, const SHI_T *phi, SHI_T *y, SHI_T *dt,
                                        SHI_T *dp)
{
    SHI_T stage[SHI_BIG_STAGE / sizeof(SHI_T)];
    return SHI_KN(shi_angles_with)(n, count, theta, phi, y, dt, dp, stage);
}

/* one direction by the looped bodies: a function of its own, so that the unrolled ones do not pay for its stack frame */
SHI_NOINLINE int SHI_KN(shi_single_any)(int n, int planes, const SHI_T v[3], SHI_T *y, int ys, SHI_T *g, int gs,
                                        SHI_T *h, int hs)
{
    return planes == SH_VALUES   ? SHI_KN(shi_one_any)(n, SH_VALUES, v, y, ys, g, 0, h, 0)
         : planes == SH_GRADIENT ? SHI_KN(shi_one_any)(n, SH_GRADIENT, v, y, ys, g, gs, h, 0)
                                 : SHI_KN(shi_one_any)(n, SH_HESSIAN, v, y, ys, g, gs, h, hs);
}
SHI_KERNEL int SHI_KN(shi_single_beyond)(int n, int planes, const SHI_T *v, SHI_T *y, SHI_T *g)
{
    return SHI_KN(shi_single_any)(n, planes, v, y, 1, g, planes == SH_GRADIENT, g, 0);
}
#if !defined(SHI_BY_LINE)
SHI_KERNEL int SHI_KN(shi_one_line)(int n, int planes, const SHI_T *v, SHI_T *y, SHI_T *g)
{
    return SHI_KN(shi_one_fixed)(n, planes, v, y, 1, g, planes == SH_GRADIENT, g, 0);
}
#endif
SHI_NOINLINE int SHI_KN(shi_single_values)(int n, const SHI_T v[3], SHI_T *y)
{
    SHI_BANDS(n, SHI_KN(shi_one_line), SHI_KN(shi_single_beyond), SH_VALUES, v, y, y)
}
SHI_NOINLINE int SHI_KN(shi_single_both)(int n, const SHI_T v[3], SHI_T *y, SHI_T *g)
{
    SHI_BANDS(n, SHI_KN(shi_one_line), SHI_KN(shi_single_beyond), SH_GRADIENT, v, y, g)
}
/* y or g may be NULL */
SHI_NOINLINE int SHI_KN(shi_single_gradient)(int n, const SHI_T v[3], SHI_T *y, SHI_T *g)
{
    SHI_T discard[3 * SH_UNROLLED_BANDS * SH_UNROLLED_BANDS];
    if (n > SH_UNROLLED_BANDS)
        return SHI_KN(shi_single_any)(n, SH_GRADIENT, v, y ? y : discard, y != NULL, g ? g : discard, g != NULL,
                                      discard, 0);
    return SHI_KN(shi_single_both)(n, v, y ? y : discard, g ? g : discard);
}
SHI_NOINLINE int SHI_KN(shi_single_hessian)(int n, const SHI_T v[3], SHI_T *y, SHI_T *g, SHI_T *h)
{
    SHI_T discard;
    return SHI_KN(shi_single_any)(n, SH_HESSIAN, v, y ? y : &discard, y != NULL, g ? g : &discard, g != NULL,
                                  h ? h : &discard, h != NULL);
}

/* ---- sum c_i Y_i at W directions, the basis never stored ----
 *
 * Once per call each column's polynomial A_m(z) = sum_l c_lm norm q_l^m is brought to E(t) + z O(t), then Horner's rule takes
 * one multiply-add per coefficient. Up to SH_UNROLLED_BANDS t = z^2 - 1/2: on [-1/2, 1/2] the terms of band l grow by
 * (1 + sqrt 2)^(l/2) at worst (52 at l = 9), in z by its square. Beyond, Newton's form about shi_node, where they do not. */

/* W coefficients, 0 where there are none */
SHI_KERNEL SHI_V SHI_KN(shi_load_within)(int n, const SHI_T *coeffs, int at)
{
    SHI_T t[SHI_W];
    int i;
    if (at >= 0 && at + SHI_W <= n * n) return SHI_LOAD(coeffs + at);
    SHI_UNROLL
    for (i = 0; i < SHI_W; i++) t[i] = at + i >= 0 && at + i < n * n ? coeffs[at + i] : 0;
    return SHI_LOAD(t);
}
/* c_lm and c_l,-m of the orders first .. first+W-1; beyond m = l of no use */
SHI_KERNEL void SHI_KN(shi_band_pairs)(int n, const SHI_T *coeffs, int l, int first, SHI_V *c, SHI_V *s)
{
    const int middle = l * (l + 1);
    *c = SHI_KN(shi_load_within)(n, coeffs, middle + first);
    *s = SHI_KN(shi_reverse)(SHI_KN(shi_load_within)(n, coeffs, middle - first - (SHI_W - 1)));
}

/* a[parity of l][k][cos, then sin][m]: coefficient of t^k in column m's E or O, W orders m at a time */
SHI_KERNEL int SHI_KN(shi_sum_form_fixed)(int n, const SHI_T *coeffs, SHI_T *a)
{
    const SHI_V zero = SHI_SPLAT(0);
    int first, l, k, i;
    SHI_UNROLL
    for (first = 0; first < n; first += SHI_W) {
        SHI_V c[SHI_POLYNOMIAL_BANDS], s[SHI_POLYNOMIAL_BANDS];
        SHI_UNROLL
        for (l = first; l < n; l++) {
            int has[SHI_W];
            SHI_UNROLL
            for (i = 0; i < SHI_W; i++) has[i] = first + i <= l;
            SHI_KN(shi_band_pairs)(n, coeffs, l, first, &c[l], &s[l]);
            c[l] = SHI_KN(shi_blend)(has, c[l], zero);
            s[l] = SHI_KN(shi_blend)(has, s[l], zero);
        }
        SHI_UNROLL
        for (k = 0; k < n; k++) {                                       /* parity k & 1, power k / 2 */
            SHI_V p = zero, q = zero;
            SHI_UNROLL
            for (l = k > first ? k : first + ((first + k) & 1); l < n; l += 2) {
                const SHI_V h = SHI_LOAD(&SHI_HORNER(l, first, k / 2));
                p = SHI_FMA(h, c[l], p);
                q = SHI_FMA(h, s[l], q);
            }
            SHI_STORE(a + SHI_FORM_AT(k & 1, k / 2, 0, first), p);
            SHI_STORE(a + SHI_FORM_AT(k & 1, k / 2, 1, first), q);
        }
    }
    return 1;
}
/* The same in Newton's form, sum_k a_k prod_{j<k} (t - t_j), t = z^2. There z times an even polynomial keeps its a_k, z times
 * an odd one has a_{k-1} + t_k a_k: so q_l = z q_{l-1} - beta q_{l-2} gives the form of each monic q_l^m */
SHI_NOINLINE int SHI_KN(shi_sum_form_any)(int n, const SHI_T *coeffs, SHI_T *a)
{
    static const SHI_T one_hot[32] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
    static const SHI_T alternating[17] = { 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1 };
    const SHI_V zero = SHI_SPLAT(0);
    SHI_V q[2][SH_MAX_BANDS / 2];                                  /* q_l takes the place of q_{l-2} */
    int first, l, k;
    for (first = 0; first < n; first += SHI_W) {
        for (k = 0; k <= (n - 1 - first) / 2; k++) {
            q[0][k] = q[1][k] = zero;
            SHI_STORE(a + SHI_FORM_AT(0, k, 0, first), zero);
            SHI_STORE(a + SHI_FORM_AT(0, k, 1, first), zero);
            SHI_STORE(a + SHI_FORM_AT(1, k, 0, first), zero);
            SHI_STORE(a + SHI_FORM_AT(1, k, 1, first), zero);
        }
        for (l = first; l < n; l++) {
            SHI_V *const q0 = q[l & 1], *const q1 = q[!(l & 1)], c, s;
            const SHI_V norm = SHI_LOAD(SHI_FN(shi_norm) + SHI_TABLE_AT(l, first));
            const SHI_V minus_beta = -SHI_LOAD(SHI_FN(shi_beta) + SHI_TABLE_AT(l, first));
            const SHI_V even = SHI_LOAD(alternating + ((l + first) & 1)), mixed = SHI_SPLAT(1) - SHI_C(0.5) * even;
            SHI_V before = SHI_LOAD(one_hot + (l - first < SHI_W ? 15 - (l - first) : 16));      /* q_m^m = 1 */
            SHI_KN(shi_band_pairs)(n, coeffs, l, first, &c, &s);
            c *= norm;
            s *= norm;
            for (k = 0; k <= (l - first) / 2; k++) {
                const SHI_V times = SHI_FNMA(even, SHI_LOAD(SHI_FN(shi_node) + SHI_NODES(k, first)), mixed);   /* t_k or 1 */
                SHI_T *const p = a + SHI_FORM_AT(l & 1, k, 0, first), *const r = a + SHI_FORM_AT(l & 1, k, 1, first);
                q0[k] = SHI_FMA(even, before, SHI_FMA(times, q1[k], minus_beta * q0[k]));
                before = q1[k];
                SHI_STORE(p, SHI_FMA(q0[k], c, SHI_LOAD(p)));
                SHI_STORE(r, SHI_FMA(q0[k], s, SHI_LOAD(r)));
            }
        }
    }
    return 1;
}
SHI_NOINLINE int SHI_KN(shi_sum_form)(int n, const SHI_T *coeffs, SHI_T *a)
{
    SHI_BANDS(n, SHI_KN(shi_sum_form_fixed), SHI_KN(shi_sum_form_any), coeffs, a)
}

/* (a, b) += (x + iy) (p, q) */
SHI_KERNEL void SHI_KN(shi_add_turned)(SHI_V x, SHI_V y, const SHI_V p[2], SHI_V a[2])
{
    const SHI_V p0 = p[0], p1 = p[1];
    a[0] = SHI_FMA(x, p0, SHI_FMA(-y, p1, a[0]));
    a[1] = SHI_FMA(x, p1, SHI_FMA(y, p0, a[1]));
}

/* sums of the columns m and up, divided by w^m, w = iy - x, whose powers have the signs (-1)^m: value, derivative by z,
 * derivative by w */
typedef struct { SHI_V value[2], by_z[2], by_w[2]; } SHI_KN(shi_sum_of);

/* Horner's rule in w: column m's polynomial ab and its derivative join the `above` columns beyond it */
SHI_KERNEL void SHI_KN(shi_sum_column)(int above, int with_grad, const SHI_V u[4], SHI_V ab[2], SHI_V dab[2],
                                       SHI_KN(shi_sum_of) *sum)
{
    const SHI_V x = -u[0], y = u[1];
    if (with_grad) {
        SHI_V next[2];
        next[0] = sum->value[0];
        next[1] = sum->value[1];
        if (above > 1) {
            SHI_KN(shi_add_turned)(x, y, sum->by_w, next);
            SHI_KN(shi_add_turned)(x, y, sum->by_z, dab);
        }
        sum->by_w[0] = next[0];
        sum->by_w[1] = next[1];
        sum->by_z[0] = dab[0];
        sum->by_z[1] = dab[1];
    }
    if (above > 0) SHI_KN(shi_add_turned)(x, y, sum->value, ab);
    sum->value[0] = ab[0];
    sum->value[1] = ab[1];
}

/* Re sum (A_m(z) + i B_m(z)) w^m, the columns' polynomials by Horner's rule */
SHI_KERNEL void SHI_KN(shi_sum_horner)(int n, int with_grad, const SHI_T *a, const SHI_V u[4], SHI_KN(shi_sum_of) *sum)
{
    const SHI_V z = u[2], t = u[3], z2 = z + z;
    int m, parity, sign, k;
    SHI_UNROLL
    for (m = n - 1; m >= 0; m--) {
        SHI_V ab[2], dab[2];
        ab[0] = ab[1] = dab[0] = dab[1] = SHI_SPLAT(0);
        SHI_UNROLL
        for (parity = 0; parity < 2; parity++) {
            if (parity < n - m) {
                SHI_UNROLL
                for (sign = 0; sign < 2; sign++) {
                    SHI_V h, d = SHI_SPLAT(0);
                    if (m == 0 && sign) continue;
                    k = (n - 1 - m - parity) / 2;
                    h = SHI_SPLAT(a[SHI_FORM_AT((m + parity) & 1, k, sign, m)]);
                    SHI_UNROLL
                    for (k--; k >= 0; k--) {
                        if (with_grad) d = d * t + h;
                        h = h * t + a[SHI_FORM_AT((m + parity) & 1, k, sign, m)];
                    }
                    ab[sign] = parity ? z * h + ab[sign] : h;
                    if (with_grad) dab[sign] = parity ? z2 * (z * d) + (h + dab[sign]) : z2 * d;
                }
            }
        }
        SHI_KN(shi_sum_column)(n - 1 - m, with_grad, u, ab, dab, sum);
    }
}

/* the same by Newton's form */
SHI_KERNEL void SHI_KN(shi_sum_newton)(int n, int with_grad, const SHI_T *a, const SHI_V u[4], SHI_KN(shi_sum_of) *sum)
{
    const SHI_V z = u[2], z2 = z + z;
    int m, k, i;
    for (m = n - 1; m >= 0; m--) {
        const int last = (n - 1 - m) / 2;
        const SHI_T *e = a + SHI_FORM_AT(m & 1, last, 0, m), *o = a + SHI_FORM_AT(!(m & 1), last, 0, m);
        SHI_V h[4], d[4], ab[2], dab[2];
        SHI_UNROLL
        for (i = 0; i < 2; i++) {
            h[i] = SHI_SPLAT(e[i * SH_MAX_BANDS]);
            h[2 + i] = SHI_SPLAT(o[i * SH_MAX_BANDS]);
            d[i] = d[2 + i] = SHI_SPLAT(0);
        }
        for (k = last - 1; k >= 0; k--) {
            const SHI_V t = u[3] + SHI_FN(shi_node)[SHI_NODES(k, m)];      /* z^2 - t_k: at the poles u[3] is better than z */
            e -= 2 * SH_MAX_BANDS, o -= 2 * SH_MAX_BANDS;
            SHI_UNROLL
            for (i = 0; i < 4; i++) {
                if (with_grad) d[i] = SHI_FMA(d[i], t, h[i]);
                h[i] = SHI_FMA(h[i], t, SHI_SPLAT((i < 2 ? e : o)[i % 2 * SH_MAX_BANDS]));
            }
        }
        SHI_UNROLL
        for (i = 0; i < 2; i++) {
            ab[i] = SHI_FMA(z, h[2 + i], h[i]);
            dab[i] = SHI_FMA(z2, SHI_FMA(z, d[2 + i], d[i]), h[2 + i]);
        }
        SHI_KN(shi_sum_column)(n - 1 - m, with_grad, u, ab, dab, sum);
    }
}

/* directions are normalised one register ahead, as in shi_blocks */
SHI_KERNEL int SHI_KN(shi_sums)(int n, int horner, int with_grad, const SHI_T *a, size_t count, const SHI_T *dirs,
                               SHI_T *values, SHI_T *grads)
{
    SHI_KN(shi_direction) now, next;
    int status = SH_OK, i, k;
    size_t p;
    SHI_KN(shi_direct_plain)(dirs, count, &next);
    for (p = 0; p < count; p += SHI_W) {
        const int lanes = count - p < SHI_W ? (int)(count - p) : SHI_W;
        SHI_KN(shi_sum_of) sum;
        SHI_V gradient[3];
        now = next;
        if (count - p > SHI_W) SHI_KN(shi_direct_plain)(dirs + 3 * (p + SHI_W), count - p - SHI_W, &next);
        for (k = 0; k < 2; k++) sum.value[k] = sum.by_z[k] = sum.by_w[k] = SHI_SPLAT(0);
        if (horner) SHI_KN(shi_sum_horner)(n, with_grad, a, now.u, &sum);
        else SHI_KN(shi_sum_newton)(n, with_grad, a, now.u, &sum);
        if (with_grad) {
            const SHI_V f[3] = { -sum.by_w[0], -sum.by_w[1], sum.by_z[0] };
            const SHI_V radial = SHI_FMA(now.u[0], f[0], SHI_FMA(now.u[1], f[1], now.u[2] * f[2]));
            for (k = 0; k < 3; k++) gradient[k] = now.inverse * (f[k] - radial * now.u[k]);
        }
        if (now.good && lanes == SHI_W) {
            if (values) SHI_STORE(values + p, sum.value[0]);
            if (with_grad) SHI_KN(shi_store3)(grads + 3 * p, gradient);
        } else {
            SHI_T out[4][SHI_W];
            SHI_STORE(out[0], sum.value[0]);
            for (k = 0; k < 3 && with_grad; k++) SHI_STORE(out[k + 1], gradient[k]);
            for (i = 0; i < lanes; i++) {
                const SHI_T *const d = dirs + 3 * (p + (size_t)i);
                if (!now.good && !SHI_ONE(shi_in_range)(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], SHI_MIN2, SHI_MAX2)) {
                    status = SHI_FN(shi_direction_status)(d);
                    continue;
                }
                if (values) values[p + (size_t)i] = out[0][i];
                for (k = 0; k < 3 && with_grad; k++) grads[3 * (p + (size_t)i) + (size_t)k] = out[k + 1][i];
            }
        }
    }
    return status;
}

/* a body per band count up to SH_UNROLLED_BANDS by powers, beyond by Newton's form */
SHI_KERNEL int SHI_KN(shi_sum_values_fixed)(int n, const SHI_T *a, size_t count, const SHI_T *dirs, SHI_T *values)
{
    return SHI_KN(shi_sums)(n, 1, 0, a, count, dirs, values, NULL);
}
SHI_KERNEL int SHI_KN(shi_sum_values_any)(int n, const SHI_T *a, size_t count, const SHI_T *dirs, SHI_T *values)
{
    return SHI_KN(shi_sums)(n, 0, 0, a, count, dirs, values, NULL);
}
SHI_KERNEL int SHI_KN(shi_sum_gradient_fixed)(int n, const SHI_T *a, size_t count, const SHI_T *dirs, SHI_T *values,
                                              SHI_T *grads)
{
    return SHI_KN(shi_sums)(n, 1, 1, a, count, dirs, values, grads);
}
SHI_KERNEL int SHI_KN(shi_sum_gradient_any)(int n, const SHI_T *a, size_t count, const SHI_T *dirs, SHI_T *values,
                                            SHI_T *grads)
{
    return SHI_KN(shi_sums)(n, 0, 1, a, count, dirs, values, grads);
}
SHI_NOINLINE int SHI_KN(shi_sum_values)(int n, const SHI_T *a, size_t count, const SHI_T *dirs, SHI_T *values)
{
    SHI_BANDS(n, SHI_KN(shi_sum_values_fixed), SHI_KN(shi_sum_values_any), a, count, dirs, values)
}
SHI_NOINLINE int SHI_KN(shi_sum_gradient)(int n, const SHI_T *a, size_t count, const SHI_T *dirs, SHI_T *values, SHI_T *grads)
{
    SHI_BANDS(n, SHI_KN(shi_sum_gradient_fixed), SHI_KN(shi_sum_gradient_any), a, count, dirs, values, grads)
}

/* ---- sums of spherical lights at a point ---- */

#define SHI_ALL_KINDS 6
#define SHI_EXTRA_BANDS(kinds) ((kinds) == 1 ? 0 : (kinds) == 3 ? 1 : 2)
/* Moments of a band j: sums over lights of weight(l) Y_jm. A light at distance rho has the coefficients f_l(rho) Y_lm, and
 * by the recurrences of x_k Y_lm its gradient (M22 Eq. 12) is a combination of w- Y_{l-1} and w+ Y_{l+1}, w- = f' + (l+1)
 * f/rho, w+ = f' - l f/rho. Doing so twice gives w-- Y_{l-2}, lap Y_l and w++ Y_{l+2}, lap the radial Laplacian.
 * Kind 0 is f_l, l = j;  1 w-, l = j+1;  2 w+, l = j-1;  3 w--, l = j+2;  4 lap, l = j;  5 w++, l = j-2. */

/* W lights as seen from a point. Geometry, powers and weights are three loops over a block of nb such: in each, the
 * long chains of one vector overlap with its neighbours'. */
typedef struct {
    SHI_V x, y;             /* -(center - point)/d, or the other way for z < 0: powers of -x - iy carry the sign */
    SHI_M side;             /* z's sign bit */
    SHI_V inverse;          /* 1/d */
    SHI_V alpha, kappa;     /* cos of the half-angle; 1 - cos, or 2 inside: the whole sky in band 0, s2 = 0 for the others */
    SHI_V s2, q;            /* (r/d)^2; s2/(alpha d) */
} SHI_KN(shi_light);

/* 1 - |z|, to an eps of its own, from r2 = x^2 + y^2 of a unit vector; and what else hangs on z */
SHI_KERNEL SHI_V SHI_KN(shi_light_polar)(SHI_V x, SHI_V y, SHI_V z, SHI_V r2, SHI_KN(shi_light) *o)
{
    o->side = SHI_KN(shi_sign)(z);
    o->x = SHI_KN(shi_flip)(x, o->side);
    o->y = SHI_KN(shi_flip)(y, o->side);
    return r2 / (SHI_C(1) + SHI_ABS(z));
}

/* returns 1 - |z|; adds to flags: inside, not finite, negative radius. A register with nothing of the kind, and no light
 * that fills half of the point's sky, meets no selection */
SHI_KERNEL SHI_V SHI_KN(shi_light_geometry)(const SHI_T point[3], const SHI_V center[3], SHI_V radius, int kinds,
                                            SHI_M flags[3], SHI_KN(shi_light) *o)
{
    const SHI_V zero = SHI_SPLAT(0), one = SHI_SPLAT(1);
    const SHI_V dx = point[0] - center[0], dy = point[1] - center[1], dz = center[2] - point[2];
    const SHI_V r2 = SHI_FMA(dx, dx, SHI_FMA(dy, dy, dz * dz)), rough = SHI_FMA(-radius, radius, r2);
    const SHI_M signs = SHI_KN(shi_sign)(SHI_FMA(SHI_SPLAT(SHI_C(-0.5)), r2, rough)) | SHI_KN(shi_sign)(radius);
    const int plain = !SHI_ANY(signs | SHI_KN(shi_out_of)(rough, SHI_MIN2, SHI_MAX2));
    SHI_V gap = rough, length = r2, hole = gap, s, inverse, inverse_gap, x, y, z, xy, e, half, alpha;
    SHI_M inside = SHI_BITS_OF(zero), none = inside;
    if (SHI_RARELY(!plain)) {
        const SHI_M close = (SHI_M)(rough < SHI_C(0.5) * r2), vast = (SHI_M)(radius > SHI_VAST) & (SHI_M)(r2 < SHI_MAX2);
        if (SHI_ANY(close)) gap = SHI_SELECT(close, SHI_KN(shi_gap)(center, point, radius), rough);
        gap = SHI_SELECT(vast, -one, gap);              /* its square would overflow */
        inside = (SHI_M)(gap <= zero) & (SHI_M)(radius > zero);
        none = (SHI_M)(radius == zero) | inside;
        hole = SHI_SELECT(none, one, gap);
        length = SHI_SELECT((SHI_M)(r2 < SHI_MIN2), one, r2);
        flags[0] |= inside;
        flags[1] |= SHI_KN(shi_out_of)(SHI_ABS(gap) + SHI_ABS(radius), 0, SHI_C(SHI_BITS == 32 ? 3e38 : 1e308));
        flags[1] |= (SHI_M)(r2 < SHI_MIN2) & (SHI_M)(radius > zero) & ~inside;
        flags[2] |= (SHI_M)(radius < zero);
    }
    inverse = SHI_RSQRT(length);
    inverse_gap = SHI_RSQRT(hole);
    s = radius * inverse;
    x = dx * inverse;
    y = dy * inverse;
    z = dz * inverse;
    xy = SHI_FMA(x, x, y * y);
    if (!plain) s = SHI_SELECT(none, zero, s);
    o->s2 = s * s;
    alpha = (gap * inverse_gap) * inverse;
    if (!plain) alpha = SHI_SELECT(none, one, alpha);
    o->kappa = o->s2 / (SHI_C(1) + alpha);
    if (kinds > 1) {
        o->inverse = inverse;
        o->q = o->s2 * inverse_gap;
    }
    if (kinds == SHI_ALL_KINDS) o->alpha = alpha;
    if (!plain) o->kappa = SHI_SELECT(inside, one + one, o->kappa);
    e = SHI_FMA(z, z, SHI_SPLAT(-1)) + xy;              /* as shi_polish */
    half = SHI_C(-0.5) * e;
    return SHI_KN(shi_light_polar)(SHI_FMA(x, half, x), SHI_FMA(y, half, y), SHI_FMA(z, half, z), SHI_FMA(-e, xy, xy), o);
}

/* c, s [levels]: U_m, V_m times radiance, nb vectors from one m to the next */
SHI_KERNEL void SHI_KN(shi_light_powers)(SHI_V x, SHI_V y, SHI_V radiance, int levels, int nb, SHI_V *c, SHI_V *s)
{
    SHI_V uc = x * radiance, us = y * radiance;
    int m;
    c[0] = radiance;                            /* V_0 = 0 is not read */
    for (m = 1; m < levels; m++) {
        c[m * nb] = uc;
        s[m * nb] = us;
        SHI_KN(shi_turn)(x, y, &uc, &us);
    }
}

/* w[kinds][levels], nb vectors from one band to the next; of odd bands times z's sign */
SHI_KERNEL void SHI_KN(shi_light_weights)(int n, int kinds, const SHI_KN(shi_light) *o, int levels, int nb, SHI_V *w)
{
    const SHI_T tau = SHI_C(SHI_TAU);
    const SHI_V zero = SHI_SPLAT(0), q = kinds > 1 ? o->q : zero;
    const SHI_V inverse = kinds > 1 ? SHI_KN(shi_flip)(o->inverse, o->side) : zero;
    const SHI_V bend = kinds == SHI_ALL_KINDS ? tau * (q * (SHI_C(3) * o->inverse + q / o->alpha)) : zero;
    const SHI_V k = tau * o->s2, k1 = -tau * q, square = tau * (q * q);
    SHI_M here = SHI_BITS_OF(zero), there = o->side;            /* signs of bands l, and l - 1 and l + 1 */
    SHI_V p = SHI_SPLAT(1), step = zero, slope = zero;
    int l;
#define SHI_WEIGHT(kind, band) w[((kind) * levels + (band)) * nb]
    if (kinds >= 3) SHI_WEIGHT(2, 0) = zero;            /* low bands that a kind does not reach; nobody reads the high */
    if (kinds == SHI_ALL_KINDS) SHI_WEIGHT(5, 0) = SHI_WEIGHT(5, 1) = zero;
    for (l = 0; l < n; l++) {
        const SHI_T *const b = SHI_FN(shi_profile) + SHI_PROFILE * l;
        SHI_V f = tau * o->kappa;
        if (l > 0) {                                    /* P_l' and P_l by differences, as in shi_cap; step = l (P_l - P_{l-1}) */
            slope = SHI_FMA(-o->kappa, slope, SHI_FMA(SHI_SPLAT(b[0]), p, slope));
            step = SHI_FMA(b[2] * o->kappa, p, step);
            p = SHI_FMA(SHI_SPLAT(b[3]), step, p);
            f = SHI_KN(shi_flip)(k * (b[4] * slope), here);
        }
        SHI_WEIGHT(0, l) = f;
        if (kinds >= 3) {
            const SHI_V g = f * inverse, f1 = SHI_KN(shi_flip)(k1 * p, there);
            if (l > 0) SHI_WEIGHT(1, l - 1) = f1 + b[1] * g;
            SHI_WEIGHT(2, l + 1) = f1 - b[0] * g;
            if (kinds == SHI_ALL_KINDS) {                       /* f'', f'/rho and f/rho^2 */
                const SHI_V f2 = SHI_KN(shi_flip)(SHI_FMA(p, bend, -(slope * square)), here);
                const SHI_V f1i = f1 * inverse, gi = g * inverse;
                if (l > 1) SHI_WEIGHT(3, l - 2) = f2 + (b[5] * f1i + b[6] * gi);
                SHI_WEIGHT(4, l) = f2 + (SHI_C(2) * f1i - b[7] * gi);
                SHI_WEIGHT(5, l + 2) = f2 - (b[5] * f1i - b[8] * gi);
            }
        }
        there = here;
        here ^= o->side;
    }
#undef SHI_WEIGHT
}

/* which kinds row j of the moments has, by its distance e = j - (n-1) from the light's top band: bits of kinds */
#define SHI_KINDS_AT(e) (((e) <= 0 ? 1u : 0u) | ((e) <= -1 ? 2u : 0u) | ((e) <= 1 ? 4u : 0u) \
                       | ((e) <= -2 ? 8u : 0u) | ((e) <= 0 ? 16u : 0u) | ((e) <= 2 ? 32u : 0u))

/* `rows` bands of column m, the last one at distance e_last, over the nb vectors of a block: M22's reverse order on a
 * CPU, the sums in registers. first: the column starts here; more: it goes on. sum[rows][kinds][2] */
SHI_KERNEL void SHI_KN(shi_light_rows)(int rows, int kinds, int e_last, int zonal, int first, int more, int nb,
                                       const SHI_T ratio[4], const SHI_V *polar, const SHI_V *c, const SHI_V *s,
                                       const SHI_V *w, int kind_stride, SHI_V *qa, SHI_V *qb, SHI_V *sum)
{
    SHI_V a[2 * SHI_ALL_KINDS], b[2 * SHI_ALL_KINDS];
    const int slots = rows * kinds;
    int i, t;
    SHI_UNROLL
    for (t = 0; t < slots; t++) {
        a[t] = sum[2 * t];
        b[t] = sum[2 * t + 1];
    }
    for (i = 0; i < nb; i++) {
        SHI_V qc[4], qs[4], q = SHI_SPLAT(1), fall = SHI_SPLAT(0);
        const SHI_V ti = polar[i], ci = c[i], si = zonal ? ci : s[i];
        if (!first) {
            q = qa[i];
            fall = qb[i];
        }
        SHI_UNROLL
        for (t = 0; t < rows; t++) {
            const int one = first && t == 0;
            if (!one) fall = first && t == 1 ? ti : SHI_KN(shi_fall)(SHI_SPLAT(ratio[t]), ti, q, fall);
            if (!one) q = q - fall;
            if (kinds == 1) {                       /* one weight goes into q, several meet q c and q s */
                const SHI_V wq = one ? w[t * nb + i] : w[t * nb + i] * q;
                a[t] += wq * ci;
                if (!zonal) b[t] += wq * si;
            } else {
                qc[t] = one ? ci : q * ci;
                if (!zonal) qs[t] = one ? si : q * si;
            }
        }
        if (more) {
            qa[i] = q;
            qb[i] = fall;
        }
        SHI_UNROLL
        for (t = 0; t < slots; t++) {
            const int r = t / kinds, k = t % kinds;
            if (kinds > 1 && (SHI_KINDS_AT(e_last - (rows - 1 - r)) >> k & 1u)) {
                const SHI_V weight = SHI_KEEP(w[k * kind_stride + r * nb + i]);
                a[t] += weight * qc[r];
                if (!zonal) b[t] += weight * qs[r];
            }
        }
    }
    SHI_UNROLL
    for (t = 0; t < slots; t++) {
        sum[2 * t] = a[t];
        sum[2 * t + 1] = b[t];
    }
}

/* column m of a block: bands m .. top in groups whose sums fit 16 registers, qa and qb [nb] to carry the recurrence
 * from one to the next. sum[top-m+1][kinds][2] */
SHI_KERNEL void SHI_KN(shi_light_column)(int n, int kinds, int m, int nb, const SHI_V *pool, int levels, SHI_V *qa, SHI_V *qb,
                                         SHI_V *sum)
{
    const int top = n - 1 + SHI_EXTRA_BANDS(kinds);
    const SHI_V *c = pool + m * nb, *v = c + levels * nb, *w = pool + 2 * levels * nb, *polar = w + kinds * levels * nb;
    SHI_T ratio[4];
    int j = m, i, rows;
#define SHI_ROWS_OF(r, e, zonal, first) \
        SHI_KN(shi_light_rows)(r, kinds, e, zonal, first, j + (r) <= top, nb, ratio, polar, c, v, w + j * nb, levels * nb, \
                               qa, qb, sum)
#define SHI_GROUP(r, e) do { \
        rows = (r); \
        for (i = 0; i < (r); i++) ratio[i] = SHI_FN(shi_ratio)[SHI_TABLE_AT(j + i, m)]; \
        if (m == 0 && j == m) SHI_ROWS_OF(r, e, 1, 1); \
        else if (m == 0) SHI_ROWS_OF(r, e, 1, 0); \
        else if (j == m) SHI_ROWS_OF(r, e, 0, 1); \
        else SHI_ROWS_OF(r, e, 0, 0); \
    } while (0)
    for (; j <= top; j += rows, sum += 2 * rows * kinds) {
        const int left = top - j + 1;
        if (kinds == 1) {
            if (left >= 4) SHI_GROUP(4, 0);
            else if (left == 3) SHI_GROUP(3, 0);
            else if (left == 2) SHI_GROUP(2, 0);
            else SHI_GROUP(1, 0);
        } else if (kinds == 3) {
            if (left > 3) SHI_GROUP(2, -2);
            else if (left == 3) SHI_GROUP(3, 1);
            else if (left == 2) SHI_GROUP(2, 1);
            else SHI_GROUP(1, 1);
        } else {
            if (left > 4) SHI_GROUP(1, -2);
            else if (left == 4) SHI_GROUP(1, -1);
            else if (left == 3) SHI_GROUP(1, 0);
            else if (left == 2) SHI_GROUP(2, 2);
            else SHI_GROUP(1, 2);
        }
    }
#undef SHI_GROUP
#undef SHI_ROWS_OF
}

/* W items of four planes from `first`; past the end the last item again */
SHI_KERNEL void SHI_KN(shi_load_light)(const SHI_T *spheres, size_t count, size_t first, SHI_V center[3], SHI_V *radius)
{
    SHI_T t[4][SHI_W];
    int i, k;
    if (count - first >= SHI_W) {
        center[0] = SHI_LOAD(spheres + first);
        center[1] = SHI_LOAD(spheres + count + first);
        center[2] = SHI_LOAD(spheres + 2 * count + first);
        *radius = SHI_LOAD(spheres + 3 * count + first);
        return;
    }
    for (i = 0; i < SHI_W; i++) {
        const size_t at = first + (size_t)i < count ? first + (size_t)i : count - 1;
        for (k = 0; k < 4; k++) t[k][i] = spheres[(size_t)k * count + at];
    }
    for (k = 0; k < 3; k++) center[k] = SHI_LOAD(t[k]);
    *radius = SHI_LOAD(t[3]);
}

/* W radiances or weights from `first`; 0 past the end, 1 for NULL */
SHI_KERNEL SHI_V SHI_KN(shi_load_radiance)(const SHI_T *radiance, size_t count, size_t first)
{
    SHI_T t[SHI_W];
    int i;
    if (count - first >= SHI_W) return radiance ? SHI_LOAD(radiance + first) : SHI_SPLAT(1);
    for (i = 0; i < SHI_W; i++) t[i] = first + (size_t)i >= count ? 0 : radiance ? radiance[first + (size_t)i] : 1;
    return SHI_LOAD(t);
}

/* W directions in place of lights: geometry without a profile. Returns 0 if one is out of range */
SHI_KERNEL int SHI_KN(shi_sample_geometry)(const SHI_T *dirs, size_t count, size_t first, SHI_V *polar, SHI_KN(shi_light) *o)
{
    SHI_KN(shi_direction) d;
    SHI_KN(shi_direct_plain)(dirs + 3 * first, count - first, &d);
    o->inverse = d.inverse;
    *polar = SHI_KN(shi_light_polar)(-d.u[0], -d.u[1], d.u[2], SHI_FMA(d.u[0], d.u[0], d.u[1] * d.u[1]), o);
    return d.good;
}

/* adds the sums of columns m0 .. m1-1, over their lanes, to moments[channels][kinds][levels^2] */
SHI_KERNEL void SHI_KN(shi_moments_add)(int n, int kinds, int channels, int m0, int m1, int levels, const SHI_V *sums,
                                        SHI_T *moments)
{
    int channel, m, j, k;
    for (channel = 0; channel < channels; channel++)
        for (m = m0; m < m1; m++)
            for (j = m; j < levels; j++)
                for (k = 0; k < kinds; k++, sums += 2) {
                    SHI_T *const out = moments + (channel * kinds + k) * levels * levels + j * j + j;
                    if (!(SHI_KINDS_AT(j - (n - 1)) >> k & 1u)) continue;           /* nobody reads it */
                    out[m] += SHI_FN(shi_pole)[SHI_TABLE_AT(j, m)] * SHI_SUM(sums[0]);
                    if (m) out[-m] += SHI_FN(shi_pole)[SHI_TABLE_AT(j, m)] * SHI_SUM(sums[1]);
                }
}

/* moments[channels][kinds][levels^2] of items: spheres[4][count] as seen from a point, or with point NULL
 * dirs[count][3]. radiance[channels][count] or NULL. A block's geometry and weights serve every channel;
 * columns are taken as many at a time as their sums fit the stack. Returns SHI_IS_INSIDE and so on */
SHI_KERNEL int SHI_KN(shi_moments)(int n, int kinds, int channels, const SHI_T *point, size_t count, const SHI_T *items,
                                   const SHI_T *radiance, SHI_T *moments)
{
    const int levels = n + SHI_EXTRA_BANDS(kinds), plane = levels * levels;
    const int fit = SHI_POOL / ((2 + kinds) * levels + 1);
    const int at_once = fit > SHI_LIGHTS_AT_ONCE ? SHI_LIGHTS_AT_ONCE : fit;
    const size_t most = (size_t)(128 / at_once * at_once) * SHI_W;          /* that lanes add up, or their rounding would grow */
    SHI_V pool[SHI_POOL], sums[SHI_SUMS], qa[SHI_LIGHTS_AT_ONCE], qb[SHI_LIGHTS_AT_ONCE];
    SHI_KN(shi_light) lights[SHI_LIGHTS_AT_ONCE];
    SHI_M flags[3];
    int bad = 0, m0, m1, m, j, i, channel;
    memset(flags, 0, sizeof flags);
    memset(moments, 0, (size_t)(channels * kinds * plane) * sizeof *moments);
    for (i = 0; i < at_once; i++) qa[i] = qb[i] = SHI_SPLAT(0);    /* or gcc sees them unset */
    for (m0 = 0; m0 < levels; m0 = m1) {
        int size = 0, at = 0;
        size_t first, next;
        for (m1 = m0; m1 < levels && channels * (size + 2 * kinds * (levels - m1)) <= SHI_SUMS; m1++)
            size += 2 * kinds * (levels - m1);
        for (first = 0; first < count; first = next) {
            const size_t vectors = (count - first + SHI_W - 1) / SHI_W;
            const int nb = vectors < (size_t)at_once ? (int)vectors : at_once;
            SHI_V *const weights = pool + 2 * levels * nb, *const polar = weights + kinds * levels * nb;
            if (first % most == 0) memset(sums, 0, (size_t)(channels * size) * sizeof sums[0]);
            for (i = 0; i < nb; i++) {
                const size_t one = first + (size_t)i * SHI_W;
                if (point) {
                    SHI_V center[3], radius;
                    SHI_KN(shi_load_light)(items, count, one, center, &radius);
                    polar[i] = SHI_KN(shi_light_geometry)(point, center, radius, kinds, flags, &lights[i]);
                } else if (!SHI_KN(shi_sample_geometry)(items, count, one, &polar[i], &lights[i])) {
                    bad = SHI_NOT_FINITE;
                }
            }
            for (i = 0; i < nb && point; i++) SHI_KN(shi_light_weights)(n, kinds, &lights[i], levels, nb, weights + i);
            for (j = 0; j < levels && !point; j++)
                for (i = 0; i < nb; i++)
                    weights[j * nb + i] = j & 1 ? SHI_KN(shi_flip)(SHI_SPLAT(1), lights[i].side) : SHI_SPLAT(1);
            for (channel = 0, at = 0; channel < channels; channel++) {
                const SHI_T *const power = radiance ? radiance + (size_t)channel * count : NULL;
                for (i = 0; i < nb; i++)
                    SHI_KN(shi_light_powers)(lights[i].x, lights[i].y,
                                             SHI_KN(shi_load_radiance)(power, count, first + (size_t)i * SHI_W),
                                             levels, nb, pool + i, pool + levels * nb + i);
                for (m = m0; m < m1; at += 2 * kinds * (levels - m), m++)
                    SHI_KN(shi_light_column)(n, kinds, m, nb, pool, levels, qa, qb, sums + at);
            }
            next = first + (size_t)at_once * SHI_W;
            if (next >= count || next % most == 0)
                SHI_KN(shi_moments_add)(n, kinds, channels, m0, m1, levels, sums, moments);
        }
    }
    return bad | (SHI_ANY(flags[0]) ? SHI_IS_INSIDE : 0) | (SHI_ANY(flags[1]) ? SHI_NOT_FINITE : 0)
         | (SHI_ANY(flags[2]) ? SHI_BAD_RADIUS : 0);
}
SHI_NOINLINE int SHI_KN(shi_moments_values)(int n, int channels, const SHI_T *point, size_t count,
                                            const SHI_T *spheres, const SHI_T *radiance, SHI_T *moments)
{
    return SHI_KN(shi_moments)(n, 1, channels, point, count, spheres, radiance, moments);
}
SHI_NOINLINE int SHI_KN(shi_moments_gradient)(int n, int channels, const SHI_T *point, size_t count,
                                              const SHI_T *spheres, const SHI_T *radiance, SHI_T *moments)
{
    return SHI_KN(shi_moments)(n, 3, channels, point, count, spheres, radiance, moments);
}
SHI_NOINLINE int SHI_KN(shi_moments_hessian)(int n, int channels, const SHI_T *point, size_t count,
                                             const SHI_T *spheres, const SHI_T *radiance, SHI_T *moments)
{
    return SHI_KN(shi_moments)(n, SHI_ALL_KINDS, channels, point, count, spheres, radiance, moments);
}

#undef SHI_BY_LINE
#undef SHI_PIECE
#undef SHI_PICK
#undef SHI_PICKS
#undef SHI_JOIN
#undef SHI_IN_PIECES

/* ================================================================================================================
 * Basis: values, gradient, Hessian of W directions at once.
 *
 * Y_lm = q_l^m(z) U_m, Y_l,-m = q_l^m(z) V_m with U_m + i V_m = (-x - iy)^m, which carries Sloan's sign, and
 * q_l^m = J_lm d^m P_l / dz^m (S13; M22 Eq. 7-8). So the derivative of column m is column m+1 up to a constant, a sweep over
 * m with the next one or two columns at hand has all derivatives, and nothing is divided by sin(theta).
 *
 * A column's worst place is the pole, where P_l' = l(l+1)/2 magnifies what is wrong with z. So near it z enters through
 * x^2 + y^2, which is small: as t = 1/2 - (x^2 + y^2) in polynomials of degree (l-m)/2 (up to 10 bands: fewer operations
 * than the recurrence, and terms that grow only by (1 + sqrt 2)^((l-m)/2)), or as w = (x^2 + y^2)/(1 + |z|) in the
 * recurrence of the differences p_l - p_{l-1} of p_l = q_l^m(|z|) / q_l^m(1).
 * ============================================================================================================= */
#elif SHI_ROOM == SHI_BASIS

/* what the columns need of a unit vector: z, and t or 1 - |z| */
SHI_KERNEL void SHI_BN(shi_polar)(const SHI_V u[4], SHI_V a[2])
{
    a[0] = u[2];
#if SHI_FIXED
    a[1] = u[3];
#else
    a[1] = SHI_FMA(u[0], u[0], u[1] * u[1]) / (SHI_C(1) + SHI_ABS(u[2]));
#endif
}

/* column[m % SHI_RING][l] = q_l^m for l = m .. n-1, norm included; called for m = 0, 1, ... */
#if SHI_FIXED
SHI_KERNEL void SHI_BN(shi_column)(int m, int n, const SHI_V a[2], SHI_V (*column)[SHI_COLUMN])
{
    SHI_V *const q = column[m % SHI_RING];
    int l, k;
    SHI_LOOP
    for (l = m; l < n; l++) {
        SHI_V h = SHI_SPLAT(SHI_HORNER(l, m, (l - m) / 2));
        SHI_LOOP
        for (k = (l - m) / 2 - 1; k >= 0; k--) h = SHI_FMA(h, a[1], SHI_SPLAT(SHI_HORNER(l, m, k)));
        q[l] = (l - m) & 1 ? h * a[0] : h;
    }
}
#else
/* The recurrence is a chain: SHI_ABREAST columns from m on run at once, each from its own m on. From row to row move: l,
 * its place in the tables, and in values' output those of l, m and l, -m */
typedef struct {
    SHI_V t, p[SHI_ABREAST], fall[SHI_ABREAST];
    SHI_M flip[2];                                  /* sign bits of z^(l-m), even and odd */
    ptrdiff_t l, row, up, down;
} SHI_KN(shi_run);
SHI_KERNEL void SHI_KN(shi_run_start)(int m, const SHI_V a[2], int stride, SHI_KN(shi_run) *o)
{
    int j;
    o->t = a[1];
    o->flip[0] = SHI_BITS_OF(SHI_SPLAT(0));
    o->flip[1] = SHI_KN(shi_sign)(a[0]);
    SHI_UNROLL
    for (j = 0; j < SHI_ABREAST; j++) {
        o->p[j] = SHI_SPLAT(1);
        o->fall[j] = SHI_SPLAT(0);
    }
    o->l = m;
    o->row = SHI_TABLE_AT(m, m);
    o->up = (m * m + 2 * m) * stride;
    o->down = m * m * stride;
}
/* One row: q_l^{m+j} of the first `started` columns, the last of which begins here unless all run, to column[j][l], or for
 * values times U and V to y. `odd` is that of l - m */
SHI_KERNEL void SHI_KN(shi_run_row)(int odd, int started, int begins, int values, SHI_KN(shi_run) *o,
                                    SHI_V (*column)[SHI_COLUMN], const SHI_V *c, const SHI_V *s, SHI_T *y, int stride)
{
    const SHI_T *const ratio = SHI_FN(shi_ratio) + o->row, *const pole = SHI_FN(shi_pole) + o->row;
    SHI_V q[SHI_ABREAST];
    int j;
    SHI_UNROLL
    for (j = 0; j < started; j++) {
        if (j < started - begins) {
            o->fall[j] = SHI_KN(shi_fall)(SHI_KEEP(SHI_SPLAT(ratio[j])), o->t, o->p[j], o->fall[j]);
            o->p[j] = o->p[j] - o->fall[j];
        }
        q[j] = SHI_KN(shi_flip)(pole[j] * o->p[j], o->flip[(odd + j) & 1]);
    }
    SHI_UNROLL
    for (j = 0; j < started; j++) {
        if (!values) {
            column[j][o->l] = q[j];
        } else {
            SHI_STORE(y + (o->down - j * stride), q[j] * s[j]);     /* order 0 puts its sine where its cosine comes */
            SHI_STORE(y + (o->up + j * stride), q[j] * c[j]);
        }
    }
    o->l++;
    o->row += o->l;
    o->up += 2 * o->l * stride;
    o->down += 2 * o->l * stride;
}
SHI_KERNEL void SHI_KN(shi_run_columns)(int m, int n, int values, const SHI_V a[2], SHI_V (*column)[SHI_COLUMN],
                                        const SHI_V *c, const SHI_V *s, SHI_T *y, int stride)
{
    SHI_KN(shi_run) o;
    int k;
    SHI_KN(shi_run_start)(m, a, stride, &o);
    SHI_UNROLL
    for (k = 0; k < SHI_ABREAST; k++)
        if (m + k < n) SHI_KN(shi_run_row)(k & 1, k + 1, 1, values, &o, column, c, s, y, stride);
    for (k = n - m - SHI_ABREAST; k > 0; k -= 2) {
        SHI_KN(shi_run_row)(0, SHI_ABREAST, 0, values, &o, column, c, s, y, stride);
        if (k > 1) SHI_KN(shi_run_row)(1, SHI_ABREAST, 0, values, &o, column, c, s, y, stride);
    }
}
/* functions of their own, or gcc keeps the columns in memory as they run */
SHI_NOINLINE void SHI_KN(shi_columns)(int m, int n, const SHI_V a[2], SHI_V (*column)[SHI_COLUMN])
{
    SHI_KN(shi_run_columns)(m, n, 0, a, column, NULL, NULL, NULL, 0);
}
SHI_NOINLINE void SHI_KN(shi_columns_values)(int m, int n, const SHI_V a[2], const SHI_V *c, const SHI_V *s, SHI_T *y,
                                             int stride)
{
    SHI_KN(shi_run_columns)(m, n, 1, a, NULL, c, s, y, stride);
}
SHI_KERNEL void SHI_BN(shi_column)(int m, int n, const SHI_V a[2], SHI_V (*column)[SHI_COLUMN])
{
    if (m % SHI_ABREAST == 0 && m < n) SHI_KN(shi_columns)(m, n, a, column + m % SHI_RING);
}
#endif

/* c[m], s[m] = U_m, V_m; called for m = 0, 1, ... */
SHI_KERNEL void SHI_BN(shi_order)(int m, int n, const SHI_V u[4], SHI_V *c, SHI_V *s)
{
#if SHI_FIXED
    (void)n;
    SHI_KN(shi_power)(m, u, c, s);
#else
    if (m == 0) SHI_KN(shi_powers_below)(n, u, c, s);
#endif
}

/* y[N], `stride` elements from one coefficient to the next */
SHI_KERNEL void SHI_BN(shi_values)(int n, int single, const SHI_V u[4], SHI_T *y, int stride)
{
#if SHI_FIXED
    SHI_V a[2], column[SHI_RING][SHI_COLUMN], c[SHI_COLUMN], s[SHI_COLUMN];
    int l, m;
    SHI_BN(shi_polar)(u, a);
    SHI_BN(shi_column)(0, n, a, column);
    SHI_LOOP
    for (l = 0; l < n; l++) SHI_PUT(y + (l * l + l) * stride, column[0][l], single);
    SHI_LOOP
    for (m = 1; m < n; m++) {
        const SHI_V *const q = column[m % SHI_RING];
        SHI_BN(shi_order)(m, n, u, c, s);
        SHI_BN(shi_column)(m, n, a, column);
        SHI_LOOP
        for (l = m; l < n; l++) {
            SHI_T *const at = y + (l * l + l) * stride;
            SHI_PUT(at + m * stride, q[l] * c[m], single);
            SHI_PUT(at - m * stride, q[l] * s[m], single);
        }
    }
#else
    SHI_V a[2], c[SH_MAX_BANDS + SHI_ABREAST], s[SH_MAX_BANDS + SHI_ABREAST];
    int m;
    (void)single;                               /* one direction goes by its orders */
    SHI_BN(shi_polar)(u, a);
    SHI_BN(shi_order)(0, n, u, c, s);
    for (m = 0; m < n; m += SHI_ABREAST) SHI_KN(shi_columns_values)(m, n, a, c + m, s + m, y, stride);
#endif
}

/* y[N], g[3][N] = dY(v/|v|)/dv at u = v/|v|, inverse = 1/|v|; with a stride of 0 all stores of an output go to one place, unread.
 * Normalises the register of directions at `ahead` too, after the last read of u: earlier, gcc spills */
SHI_KERNEL void SHI_BN(shi_gradient)(int n, int single, const SHI_V u[4], SHI_V inverse, SHI_T *y, int y_stride, SHI_T *g,
                                     int stride, const SHI_T *ahead, SHI_KN(shi_direction) *next)
{
    const SHI_V z = u[2], xi = -u[0] * inverse, yi = -u[1] * inverse, zero = SHI_SPLAT(0);
    SHI_T *const gx = g, *const gy = gx + n * n * stride, *const gz = gy + n * n * stride;
    SHI_V a[2], column[SHI_RING][SHI_COLUMN], c[SHI_COLUMN], s[SHI_COLUMN];
    int l, m;
    SHI_BN(shi_polar)(u, a);
    SHI_BN(shi_column)(0, n, a, column);
    if (ahead) SHI_KN(shi_direct_block)(ahead, next);
    SHI_LOOP
    for (m = 0; m < n; m++) {
        const SHI_V *const q0 = column[m % SHI_RING], *const q1 = column[(m + 1) % SHI_RING];
        const SHI_V mi = SHI_C(-m) * inverse, mc = mi * (m ? c[m - 1] : zero), ms = mi * (m ? s[m - 1] : zero);
        SHI_V ic, is, xc, xs, vc, vs;
        SHI_BN(shi_column)(m + 1, n, a, column);
        SHI_BN(shi_order)(m, n, u, c, s);
        ic = inverse * c[m];
        is = inverse * s[m];
        xc = xi * c[m];
        xs = xi * s[m];
        vc = yi * c[m];
        vs = yi * s[m];
        SHI_LOOP
        for (l = m; l < n; l++) {
            const SHI_V q = q0[l], d = l > m ? SHI_FN(shi_slope)[SHI_TABLE_AT(l, m)] * q1[l] : SHI_SPLAT(0);
            const SHI_V b = l > m ? SHI_FMA(z, d, m ? SHI_C(m) * q : zero) : SHI_C(m) * q;     /* u.F', over U_m */
            const SHI_V e = SHI_FNMA(z, b, d);                                                 /* F'_z - z u.F' */
            const int at = l * l + l;
            if (m == 0) {
                SHI_PUT(y + at * y_stride, q, single);
                SHI_PUT(gx + at * stride, l ? SHI_FMA(xi, b, zero) : d, single);
                SHI_PUT(gy + at * stride, l ? SHI_FMA(yi, b, zero) : d, single);
                SHI_PUT(gz + at * stride, l ? inverse * e : d, single);
            } else {
                const SHI_V qc = q * mc, qs = q * ms;
                SHI_PUT(y + (at + m) * y_stride, q * c[m], single);
                SHI_PUT(y + (at - m) * y_stride, q * s[m], single);
                SHI_PUT(gx + (at + m) * stride, SHI_FMA(xc, b, qc), single);
                SHI_PUT(gx + (at - m) * stride, SHI_FMA(xs, b, qs), single);
                SHI_PUT(gy + (at + m) * stride, SHI_FMA(vc, b, -qs), single);
                SHI_PUT(gy + (at - m) * stride, SHI_FMA(vs, b, qc), single);
                SHI_PUT(gz + (at + m) * stride, ic * e, single);
                SHI_PUT(gz + (at - m) * stride, is * e, single);
            }
        }
    }
}

#if !SHI_FIXED
/* Value, gradient and Hessian of coefficients. With P = q_l^m(z) U_m, t = P' - (u.P') u and p = P'' u + t - (u.P''u + u.P')
 * u / 2 the gradient of Y(v/|v|) is t / |v| and its Hessian (P'' - u p' - p u' - (u.P') I) / |v|^2; U_m is homogeneous in
 * x and y, so that all but U_m and its derivatives is shared by m and -m: of[] (u.P')/U, q, d, t_z/U, s, p_z/U,
 * (e - u.P')/U, with d, e the derivatives of q and p = U_x (u.P')/U - s U u */
SHI_KERNEL void SHI_KN(shi_second_shared)(SHI_V z, SHI_V m, SHI_V q, SHI_V d, SHI_V e, SHI_V of[7])
{
    const SHI_V b = SHI_FMA(z, d, m * q), wz = SHI_FMA(z, e, m * d);                /* u.P', (P''u)_z over U */
    const SHI_V half = SHI_C(0.5) * SHI_FMA(z, wz, SHI_FMA(m, b - q, b));           /* (P''u)_x = U_x (b - q) */
    of[0] = b;
    of[1] = q;
    of[2] = d;
    of[3] = SHI_FNMA(z, b, d);
    of[4] = b + half;
    of[5] = SHI_FNMA(z, of[4], wz + d);
    of[6] = e - b;
}
/* f[] = U, U_x, U_y, U_xx, U_xy; i = 1/|v| in two steps: its square may overflow. part: 1 value and gradient, 2 Hessian,
 * 3 both */
SHI_KERNEL void SHI_KN(shi_second)(int part, const SHI_V u[4], SHI_V inverse, const SHI_V of[7], const SHI_V f[5],
                                   SHI_T *y, SHI_T *g, int g_plane, SHI_T *h, int plane)
{
    const SHI_V b = of[0], q = of[1], d = of[2];
    const SHI_V f0 = inverse * f[0], f1 = inverse * f[1], f2 = inverse * f[2], xx = (inverse * f[3]) * q;
    const SHI_V k = f0 * b, s = f0 * of[4];
    const SHI_V px = SHI_FMA(f1, b, -(s * u[0])), py = SHI_FMA(f2, b, -(s * u[1])), pz = f0 * of[5];
    if (part & 1) {
        SHI_STORE(y, f[0] * q);
        SHI_STORE(g, SHI_FMA(f1, q, -(k * u[0])));
        SHI_STORE(g + g_plane, SHI_FMA(f2, q, -(k * u[1])));
        SHI_STORE(g + 2 * g_plane, f0 * of[3]);
    }
    if (part & 2) {
        SHI_STORE(h, inverse * SHI_FMA(SHI_C(-2) * u[0], px, xx - k));
        SHI_STORE(h + plane, inverse * SHI_FMA(inverse * f[4], q, -SHI_FMA(u[0], py, u[1] * px)));
        SHI_STORE(h + 2 * plane, inverse * SHI_FMA(f1, d, -SHI_FMA(u[0], pz, u[2] * px)));
        SHI_STORE(h + 3 * plane, inverse * SHI_FMA(SHI_C(-2) * u[1], py, -xx - k));
        SHI_STORE(h + 4 * plane, inverse * SHI_FMA(f2, d, -SHI_FMA(u[1], pz, u[2] * py)));
        SHI_STORE(h + 5 * plane, inverse * SHI_FMA(SHI_C(-2) * u[2], pz, f0 * of[6]));
    }
}
/* f of orders m and -m from c[0], c[-1], c[-2] = U_m, U_{m-1}, U_{m-2} and s likewise, 0 where there is none */
SHI_KERNEL void SHI_KN(shi_second_orders)(SHI_V m, const SHI_V *c, const SHI_V *s, SHI_V cosine[5], SHI_V sine[5])
{
    const SHI_V m2 = m * (m - SHI_C(1));
    cosine[0] = c[0];
    cosine[1] = sine[2] = -m * c[-1];
    cosine[2] = m * s[-1];
    cosine[3] = sine[4] = m2 * c[-2];
    cosine[4] = -m2 * s[-2];
    sine[0] = s[0];
    sine[1] = -m * s[-1];
    sine[3] = m2 * s[-2];
}

/* column m and the two after it, q[], to orders m and -m */
SHI_KERNEL void SHI_KN(shi_second_column)(int part, int n, int m, const SHI_V u[4], SHI_V inverse, const SHI_V *const q[3],
                                          const SHI_V *c, const SHI_V *s, SHI_T *y, int y_stride, SHI_T *g, int g_stride,
                                          SHI_T *h, int stride)
{
    const int plane = n * n * stride, g_plane = n * n * g_stride;
    const SHI_V zero = SHI_SPLAT(0);
    SHI_V cosine[5], sine[5];
    int l;
    SHI_KN(shi_second_orders)(SHI_SPLAT(SHI_C(m)), c, s, cosine, sine);
    for (l = m; l < n; l++) {
        const SHI_T *const slope = SHI_FN(shi_slope) + SHI_TABLE_AT(l, m);
        const SHI_V d = l > m ? slope[0] * q[1][l] : zero, e = l > m + 1 ? (slope[0] * slope[1]) * q[2][l] : zero;
        const int up = l * l + l + m, down = up - 2 * m;
        SHI_V of[7];
        SHI_KN(shi_second_shared)(u[2], SHI_SPLAT(SHI_C(m)), q[0][l], d, e, of);
        SHI_KN(shi_second)(part, u, inverse, of, cosine, y + up * y_stride, g + up * g_stride, g_plane, h + up * stride, plane);
        if (m)
            SHI_KN(shi_second)(part, u, inverse, of, sine, y + down * y_stride, g + down * g_stride, g_plane,
                               h + down * stride, plane);
    }
}

/* y[N], g[3][N], h[6][N] of Y(v/|v|) */
SHI_KERNEL void SHI_KN(shi_hessian)(int n, const SHI_V u[4], SHI_V inverse, SHI_T *y, int y_stride, SHI_T *g, int g_stride,
                                    SHI_T *h, int stride)
{
    /* ten planes a multiple of 4 KiB apart meet in one set of a cache of 8 ways: then value and gradient first */
    const int apart = stride && n * n * stride * (int)sizeof(SHI_T) % 4096 == 0;
    SHI_V a[2], column[SHI_RING][SHI_COLUMN], c[2 + SHI_COLUMN], s[2 + SHI_COLUMN];
    int m, k;
    c[0] = c[1] = s[0] = s[1] = SHI_SPLAT(0);
    SHI_BN(shi_polar)(u, a);
    SHI_BN(shi_column)(0, n, a, column);
    SHI_BN(shi_column)(1, n, a, column);
    for (m = 0; m < n; m++) {
        const SHI_V *q[3];
        SHI_BN(shi_column)(m + 2, n, a, column);
        SHI_BN(shi_order)(m, n, u, c + 2, s + 2);
        for (k = 0; k < 3; k++) q[k] = column[(m + k) % SHI_RING];
        if (!apart) {
            SHI_KN(shi_second_column)(3, n, m, u, inverse, q, c + 2 + m, s + 2 + m, y, y_stride, g, g_stride, h, stride);
        } else {
            SHI_KN(shi_second_column)(1, n, m, u, inverse, q, c + 2 + m, s + 2 + m, y, y_stride, g, g_stride, h, stride);
            SHI_KN(shi_second_column)(2, n, m, u, inverse, q, c + 2 + m, s + 2 + m, y, y_stride, g, g_stride, h, stride);
        }
    }
}

#if SHI_LANES > 1
/* ---- one direction, W orders of a band in the lanes ---- */

/* `count` numbers, by two moves of `part` that may overlap */
SHI_KERNEL int SHI_KN(shi_put_ends)(int part, const SHI_T *lane, int count, SHI_T *out)
{
    const size_t bytes = (size_t)(part < SHI_W ? part : SHI_W) * sizeof *out;
    SHI_T first[SHI_W], last[SHI_W];
    if (part > SHI_W || part > count) return 0;
    memcpy(first, lane, bytes);
    memcpy(last, lane + count - part, bytes);
    memcpy(out, first, bytes);
    memcpy(out + count - part, last, bytes);
    return 1;
}
SHI_KERNEL void SHI_KN(shi_put_few)(const SHI_T *lane, int count, SHI_T *out)
{
    (void)(SHI_KN(shi_put_ends)(8, lane, count, out) || SHI_KN(shi_put_ends)(4, lane, count, out)
           || SHI_KN(shi_put_ends)(2, lane, count, out) || SHI_KN(shi_put_ends)(1, lane, count, out));
}
/* coefficients (l, m), (l, m+1), ... and (l, -m), (l, -m-1), ..., as many as there are; a stride of 0 discards */
SHI_KERNEL void SHI_KN(shi_put_orders)(int l, int m, SHI_V up, SHI_V down, SHI_T *y, int stride)
{
    const int count = l + 1 - m < SHI_W ? l + 1 - m : SHI_W;
    SHI_T *const above = y + (l * l + l + m) * stride, *const below = y + (l * l + l - m - count + 1) * stride;
    SHI_T u[SHI_W], d[SHI_W], *const lowest = d + SHI_W - count;
    int k;
    SHI_STORE(u, up);
    SHI_STORE(d, SHI_KN(shi_reverse)(down));
    if (stride == 1) {
        SHI_KN(shi_put_few)(lowest, count, below);
        SHI_KN(shi_put_few)(u, count, above);           /* order 0 puts its sine where its cosine comes */
    } else if (stride) {
        for (k = 0; k < count; k++) below[k * stride] = lowest[k];
        for (k = 0; k < count; k++) above[k * stride] = u[k];
    }
}

/* columns `order` + j, j = 0, 1, 2, run as in shi_run, and the band they have come to */
typedef struct {
    SHI_V order, band, p[3], fall[3];
    SHI_M flip[2];                                  /* sign bits of z^(l-m), even and odd l - m in the first lane */
} SHI_KN(shi_orders);
SHI_KERNEL void SHI_KN(shi_orders_start)(int m, const SHI_V a[2], SHI_KN(shi_orders) *o)
{
    SHI_T lane[SHI_W];
    int k;
    SHI_UNROLL
    for (k = 0; k < SHI_W; k++) lane[k] = SHI_C(k);
    o->order = SHI_LOAD(lane) + SHI_C(m);
    o->band = SHI_SPLAT(SHI_C(m));
    SHI_UNROLL
    for (k = 0; k < 3; k++) {
        o->p[k] = SHI_SPLAT(1);
        o->fall[k] = SHI_SPLAT(0);
    }
    SHI_UNROLL
    for (k = 0; k < 2; k++) o->flip[k] = SHI_KN(shi_sign)(SHI_KN(shi_where)(1, !k, a[0], SHI_SPLAT(0)));
}
/* q_l^{m+j}, orders m, m+1, ..., to the bit as shi_run_row has it; void where m + j > l */
SHI_KERNEL SHI_V SHI_KN(shi_orders_row)(int j, int l, int m, const SHI_V a[2], SHI_KN(shi_orders) *o)
{
    const SHI_T *const ratio = SHI_FN(shi_ratio) + SHI_TABLE_AT(l, m) + j;
    const SHI_T *const pole = SHI_FN(shi_pole) + SHI_TABLE_AT(l, m) + j;
    const SHI_M begun = (SHI_M)(o->order + SHI_C(j) < o->band);
    o->fall[j] = SHI_KN(shi_fall)(SHI_SELECT(begun, SHI_LOAD(ratio), SHI_SPLAT(0)), a[1], o->p[j], o->fall[j]);
    o->p[j] = o->p[j] - o->fall[j];
    return SHI_KN(shi_flip)(SHI_LOAD(pole) * o->p[j], o->flip[(l - m + j) & 1]);
}
/* value and gradient of orders m and -m from q_l^m and its derivative d, c[0], c[-1] = U_m, U_{m-1} and s likewise, to
 * the bit as shi_gradient has them, which has no terms in m for m = 0 */
SHI_KERNEL void SHI_KN(shi_orders_gradient)(SHI_V m, const SHI_V u[4], SHI_V inverse, SHI_V q, SHI_V d, const SHI_V *c,
                                            const SHI_V *s, SHI_T (*up)[SHI_W], SHI_T (*down)[SHI_W])
{
    const SHI_V zero = SHI_SPLAT(0), xi = -u[0] * inverse, yi = -u[1] * inverse, mi = m * inverse, less = (zero - m) * inverse;
    const SHI_V qm = SHI_SELECT((SHI_M)(m > zero), q, zero), b = SHI_FMA(u[2], d, m * qm), e = SHI_FNMA(u[2], b, d);
    SHI_STORE(up[0], q * c[0]);
    SHI_STORE(up[1], SHI_FMA(xi * c[0], b, qm * (less * c[-1])));
    SHI_STORE(up[2], SHI_FMA(yi * c[0], b, qm * (mi * s[-1])));
    SHI_STORE(up[3], (inverse * c[0]) * e);
    SHI_STORE(down[0], q * s[0]);
    SHI_STORE(down[1], SHI_FMA(xi * s[0], b, qm * (less * s[-1])));
    SHI_STORE(down[2], SHI_FMA(yi * s[0], b, qm * (less * c[-1])));
    SHI_STORE(down[3], (inverse * s[0]) * e);
}

/* What a batch gives, to the bit: y[N], g[3][N], h[6][N], as far as planes say. Returns 0, and writes nothing, when the
 * direction is out of range */
SHI_KERNEL int SHI_KN(shi_one_any)(int n, int planes, const SHI_T v[3], SHI_T *y, int ys, SHI_T *g, int gs, SHI_T *h, int hs)
{
    SHI_T before[2][2 + SH_MAX_BANDS];                          /* [0][2 + m] = U_m, [1][2 + m] = V_m */
    SHI_V w[3], u[4], inverse, a[2], c[SH_MAX_BANDS / SHI_W], s[SH_MAX_BANDS / SHI_W];
    int l, m, k;
    for (k = 0; k < 3; k++) w[k] = SHI_KEEP(SHI_SPLAT(v[k]));
    if (!SHI_KN(shi_unit)(w, 1, u, &inverse)) return 0;
    SHI_BN(shi_polar)(u, a);
    SHI_KN(shi_powers)(n, u, c, s);
    for (k = 0; k < 2; k++) before[0][k] = before[1][k] = 0;
    for (m = 0; m < n && planes > SH_VALUES; m += SHI_W) {
        SHI_STORE(before[0] + 2 + m, c[m / SHI_W]);
        SHI_STORE(before[1] + 2 + m, s[m / SHI_W]);
    }
    for (m = 0; m < n; m += SHI_W) {
        SHI_KN(shi_orders) o;
        SHI_V mc[3], ms[3], cosine[5], sine[5];                 /* U and V of orders m - 2, m - 1, m */
        SHI_KN(shi_orders_start)(m, a, &o);
        for (k = 0; k < 2 && planes > SH_VALUES; k++) {
            mc[k] = SHI_LOAD(before[0] + m + k);
            ms[k] = SHI_LOAD(before[1] + m + k);
        }
        mc[2] = c[m / SHI_W];
        ms[2] = s[m / SHI_W];
        if (planes == SH_HESSIAN) SHI_KN(shi_second_orders)(o.order, mc + 2, ms + 2, cosine, sine);
        for (l = m; l < n; l++, o.band += SHI_C(1)) {
            const SHI_T *const slope = SHI_FN(shi_slope) + SHI_TABLE_AT(l, m);
            const SHI_V q = SHI_KN(shi_orders_row)(0, l, m, a, &o), zero = SHI_SPLAT(0);
            SHI_T up[SH_HESSIAN][SHI_W], down[SH_HESSIAN][SHI_W];
            SHI_V d = zero;
            if (planes > SH_VALUES) {
                d = SHI_LOAD(slope) * SHI_KN(shi_orders_row)(1, l, m, a, &o);
                d = SHI_SELECT((SHI_M)(o.order < o.band), d, zero);
            }
            if (planes == SH_VALUES) {
                SHI_STORE(up[0], q * mc[2]);
                SHI_STORE(down[0], q * ms[2]);
            } else if (planes == SH_GRADIENT) {
                SHI_KN(shi_orders_gradient)(o.order, u, inverse, q, d, mc + 2, ms + 2, up, down);
            } else {
                SHI_V of[7], e = (SHI_LOAD(slope) * SHI_LOAD(slope + 1)) * SHI_KN(shi_orders_row)(2, l, m, a, &o);
                e = SHI_SELECT((SHI_M)(o.order + SHI_C(1) < o.band), e, zero);
                SHI_KN(shi_second_shared)(u[2], o.order, q, d, e, of);
                SHI_KN(shi_second)(3, u, inverse, of, cosine, up[0], up[1], SHI_W, up[4], SHI_W);
                SHI_KN(shi_second)(3, u, inverse, of, sine, down[0], down[1], SHI_W, down[4], SHI_W);
            }
            SHI_KN(shi_put_orders)(l, m, SHI_LOAD(up[0]), SHI_LOAD(down[0]), y, ys);
            SHI_UNROLL
            for (k = 1; k < SH_GRADIENT && k < planes; k++)
                SHI_KN(shi_put_orders)(l, m, SHI_LOAD(up[k]), SHI_LOAD(down[k]), g + (k - 1) * n * n * gs, gs);
            SHI_UNROLL
            for (k = SH_GRADIENT; k < planes; k++)
                SHI_KN(shi_put_orders)(l, m, SHI_LOAD(up[k]), SHI_LOAD(down[k]), h + (k - SH_GRADIENT) * n * n * hs, hs);
        }
    }
    return 1;
}
#endif
#endif

/* dirs[blocks][3][8] to y[N][8], g[3 N][8], h[6 N][8] per block, yn, gn, hn elements apart (0: each block over the
 * last); a stride ys, gs, hs of 0 discards an output of the looped body. A block is normalised while the one before is
 * evaluated: the chain of the one fills the gaps of the other. Registers with a bad direction come last, lane by lane */
SHI_KERNEL int SHI_BN(shi_blocks)(int n, int planes, size_t blocks, const SHI_T *dirs, SHI_T *y, size_t yn, int ys,
                                  SHI_T *g, size_t gn, int gs, SHI_T *h, size_t hn, int hs)
{
    SHI_KN(shi_direction) now[SHI_IN_BLOCK], next[SHI_IN_BLOCK];
    const int meanwhile = planes == SH_GRADIENT && SHI_IN_BLOCK == 1;      /* shi_gradient sees to it */
    int status = SH_OK, all_good = 1, i;
    size_t b;
    for (i = 0; i < SHI_IN_BLOCK && blocks > 0; i++) SHI_KN(shi_direct_block)(dirs + i * SHI_W, &next[i]);
    for (b = 0; b < blocks; b++) {
        SHI_UNROLL
        for (i = 0; i < SHI_IN_BLOCK; i++) now[i] = next[i];
        for (i = 0; i < SHI_IN_BLOCK && b + 1 < blocks && !meanwhile; i++)
            SHI_KN(shi_direct_block)(dirs + (b + 1) * (3 * SH_BLOCK) + i * SHI_W, &next[i]);
        for (i = 0; i < SHI_IN_BLOCK; i++) {
            const SHI_T *const ahead = meanwhile && b + 1 < blocks ? dirs + (b + 1) * (3 * SH_BLOCK) + i * SHI_W : NULL;
            SHI_T *const yb = y + b * yn + (ys ? i * SHI_W : 0), *const gb = g + b * gn + (gs ? i * SHI_W : 0);
            SHI_T *const hb = h + b * hn + (hs ? i * SHI_W : 0);
            if (SHI_RARELY(!now[i].good)) {
                all_good = 0;
                if (ahead) SHI_KN(shi_direct_block)(ahead, &next[i]);
            } else if (planes == SH_VALUES) {
                SHI_BN(shi_values)(n, 0, now[i].u, yb, ys);
            } else if (planes == SH_GRADIENT) {
                SHI_BN(shi_gradient)(n, 0, now[i].u, now[i].inverse, yb, ys, gb, gs, ahead, &next[i]);
            } else {
                SHI_KN(shi_hessian)(n, now[i].u, now[i].inverse, yb, ys, gb, gs, hb, hs);
            }
        }
    }
    for (b = 0; b < blocks && SHI_RARELY(!all_good); b++)
        for (i = 0; i < SH_BLOCK; i += SHI_W) {
            const SHI_T *const d = dirs + b * (3 * SH_BLOCK) + i;
            SHI_KN(shi_direct_block)(d, next);
            if (!next->good) {
                const int bad = SHI_FN(shi_one_by_one)(n, planes, SHI_W, d, SH_BLOCK, 1, y + b * yn + (ys ? i : 0), ys, ys != 0,
                                                       g + b * gn + (gs ? i : 0), gs, gs != 0, h + b * hn + (hs ? i : 0), hs,
                                                       hs != 0);
                status = bad ? bad : status;
            }
        }
    return status;
}

/* y, dtheta, dphi [N][W] from f = cosine and sine of theta, of phi. dq/dtheta is -sin theta dq/dz, the next column again, and
 * dU_m/dtheta = m cos theta U_m/sin(theta), whose quotient is U_{m-1} without its last sine */
SHI_KERNEL int SHI_BN(shi_angles)(int n, const SHI_V f[4], SHI_T *y, SHI_T *dt, SHI_T *dp)
{
    const SHI_V ct = f[0], minus_st = -f[1], cp = f[2], sp = f[3], zero = SHI_SPLAT(0);
    SHI_V u[4], a[2], column[SHI_RING][SHI_COLUMN], c[SHI_COLUMN], s[SHI_COLUMN];
    int l, m;
    SHI_KN(shi_angles_unit)(f, u);
    SHI_BN(shi_polar)(u, a);
    SHI_BN(shi_column)(0, n, a, column);
    SHI_LOOP
    for (m = 0; m < n; m++) {
        const SHI_V *const q0 = column[m % SHI_RING], *const q1 = column[(m + 1) % SHI_RING];
        const SHI_V mt = SHI_C(m) * ct;
        SHI_V less_c = zero, less_s = zero;
        SHI_BN(shi_column)(m + 1, n, a, column);
        SHI_BN(shi_order)(m, n, u, c, s);
        if (m) {
            less_c = SHI_FNMA(cp, c[m - 1], sp * s[m - 1]);
            less_s = SHI_FNMA(cp, s[m - 1], -(sp * c[m - 1]));
        }
        SHI_LOOP
        for (l = m; l < n; l++) {
            const SHI_V q = q0[l], t = minus_st * (l > m ? SHI_FN(shi_slope)[SHI_TABLE_AT(l, m)] * q1[l] : zero);
            const int at = l * l + l;
            if (m == 0) {
                SHI_STORE(y + at * SHI_W, q);
                SHI_STORE(dt + at * SHI_W, t + zero);           /* no -0, as where orders are in the lanes */
                SHI_STORE(dp + at * SHI_W, zero);
            } else {
                const SHI_V w = mt * q, yc = q * c[m], ys = q * s[m];
                SHI_STORE(y + (at + m) * SHI_W, yc);
                SHI_STORE(y + (at - m) * SHI_W, ys);
                SHI_STORE(dt + (at + m) * SHI_W, SHI_FMA(w, less_c, t * c[m]));
                SHI_STORE(dt + (at - m) * SHI_W, SHI_FMA(w, less_s, t * s[m]));
                SHI_STORE(dp + (at + m) * SHI_W, SHI_C(-m) * ys);
                SHI_STORE(dp + (at - m) * SHI_W, SHI_C(m) * yc);
            }
        }
    }
    return SH_OK;
}

#if SHI_FIXED && defined(SHI_BY_LINE)
/* One direction with its coefficients 1, 2, ... in the lanes, register k from the index shi_line_at on: the last
 * overlaps the one before if it can */
#define SHI_LINE_REGISTERS ((SHI_POLYNOMIAL_SIZE - 2) / SHI_W + 1)
#define SHI_ORDER_REGISTERS ((SHI_POLYNOMIAL_BANDS - 1) / SHI_W + 1)
SHI_KERNEL int SHI_KN(shi_line_at)(int n, int k)
{
    const int at = 1 + k * SHI_W, last = n * n - SHI_W;
    return at > last && last > 0 ? last : at;
}
SHI_KERNEL void SHI_KN(shi_put_line)(int n, int at, SHI_V v, SHI_T *out)
{
    int i;
    if (at + SHI_W <= n * n) SHI_STORE(out + at, v);
    else for (i = 0; i < n * n - at; i++) out[at + i] = v[i];
}

/* of order m - 1 for orders m in register r; order 0 its own */
SHI_KERNEL SHI_V SHI_KN(shi_line_before)(int r, const SHI_V *c)
{
    SHI_I lane[SHI_W];
    SHI_M from;
    int i;
    SHI_UNROLL
    for (i = 0; i < SHI_W; i++) lane[i] = i ? SHI_W + i - 1 : r ? SHI_W - 1 : 0;
    memcpy(&from, lane, sizeof from);
    return SHI_KN(shi_choose)(c[r ? r - 1 : 0], c[r], from);
}
/* to coefficients from orders: u[m] or, m < 0, v[-m] */
SHI_KERNEL SHI_V SHI_KN(shi_line_spread)(int n, int k, const SHI_V *u, const SHI_V *v)
{
    const int at = SHI_KN(shi_line_at)(n, k), top = at + SHI_W <= n * n ? shi_band_of[at + SHI_W - 1] : n - 1;
    SHI_I lane[SHI_W];
    SHI_M from;
    SHI_V out;
    int beyond[SHI_W], r, i;
    SHI_UNROLL
    for (i = 0; i < SHI_W; i++) {
        const int m = shi_order_of[at + i];
        lane[i] = shi_abs(m) % SHI_W + (m < 0 ? SHI_W : 0);
    }
    memcpy(&from, lane, sizeof from);
    out = SHI_KN(shi_choose)(u[0], v[0], from);
    SHI_UNROLL
    for (r = 1; r < SHI_ORDER_REGISTERS; r++) {             /* a number of turns that clang knows before `at` */
        SHI_UNROLL
        for (i = 0; i < SHI_W; i++) beyond[i] = shi_abs(shi_order_of[at + i]) >= r * SHI_W;
        if (r * SHI_W <= top) out = SHI_KN(shi_blend)(beyond, SHI_KN(shi_choose)(u[r], v[r], from), out);
    }
    return out;
}
/* q_l^|m| */
SHI_KERNEL SHI_V SHI_KN(shi_line_column)(int n, int k, const SHI_V u[4])
{
    const int at = SHI_KN(shi_line_at)(n, k), top = at + SHI_W <= n * n ? shi_band_of[at + SHI_W - 1] : n - 1;
    SHI_V q = SHI_LOAD(&SHI_HORNER(0, at, top / 2));
    int odd[SHI_W], i;
    SHI_UNROLL
    for (i = SHI_POLYNOMIAL_BANDS / 2 - 2; i >= 0; i--)
        if (i < top / 2) q = SHI_FMA(q, u[3], SHI_LOAD(&SHI_HORNER(0, at, i)));
    SHI_UNROLL
    for (i = 0; i < SHI_W; i++) odd[i] = (shi_band_of[at + i] - shi_order_of[at + i]) & 1;
    return q * SHI_KN(shi_blend)(odd, u[2], SHI_SPLAT(1));
}
/* from q_l^|m| to q_l^{|m|+1}, which stands at the orders |m|+1 and -|m|-1: from the same register if it is in it. The
 * last order, |m| = l, keeps its own, which is positive */
SHI_KERNEL SHI_V SHI_KN(shi_line_next)(int n, int k, const SHI_V *q)
{
    const int at = SHI_KN(shi_line_at)(n, k);
    SHI_V v = q[k];
    int r, i;
    SHI_UNROLL
    for (r = k - 1; r <= k + 1; r++) {
        const int first = SHI_KN(shi_line_at)(n, r), exists = r >= 0 && 1 + r * SHI_W < n * n;
        SHI_I lane[SHI_W];
        SHI_M from;
        int any = 0;
        SHI_UNROLL
        for (i = 0; i < SHI_W; i++) {
            const int l = shi_band_of[at + i], m = shi_abs(shi_order_of[at + i]);
            const int up = l * (l + 1) + m + 1, down = l * (l + 1) - m - 1;
            const int is_here = (up >= at && up < at + SHI_W) || (down >= at && down < at + SHI_W);
            const int source = up >= first && up < first + SHI_W ? up - first : down - first;
            const int has = exists && m < l && (r == k || !is_here) && source >= 0 && source < SHI_W;
            lane[i] = has ? SHI_W + source : i;
            any |= has;
        }
        memcpy(&from, lane, sizeof from);
        if (any) v = SHI_KN(shi_choose)(v, q[r], from);
    }
    return v;
}

/* orders and columns of a unit vector, and what derives the orders: U_x = V_y, U_y and V_x or, for angles, U and V over
 * sin(theta) */
typedef struct {
    SHI_V u[4], c[SH_MAX_BANDS / SHI_W], s[SH_MAX_BANDS / SHI_W], q[SHI_LINE_REGISTERS], slope[3][SHI_ORDER_REGISTERS];
} SHI_KN(shi_line);
SHI_KERNEL void SHI_KN(shi_line_start)(int n, SHI_KN(shi_line) *o)
{
    int k;
    SHI_KN(shi_powers)(n, o->u, o->c, o->s);
    SHI_UNROLL
    for (k = 0; 1 + k * SHI_W < n * n; k++) o->q[k] = SHI_KN(shi_line_column)(n, k, o->u);
}
/* of register k: d/dz of q_l^|m|, |m|, and q itself but 0 for m = 0, which has no such terms in shi_gradient and shi_angles */
SHI_KERNEL void SHI_KN(shi_line_terms)(int n, int k, const SHI_V *q, SHI_V *d, SHI_V *order, SHI_V *qm)
{
    const int at = SHI_KN(shi_line_at)(n, k);
    SHI_T m[SHI_W];
    int zonal[SHI_W], j;
    SHI_UNROLL
    for (j = 0; j < SHI_W; j++) {
        zonal[j] = shi_order_of[at + j] == 0;
        m[j] = SHI_C(shi_abs(shi_order_of[at + j]));
    }
    *d = SHI_LOAD(SHI_FN(shi_line_slope) + at) * SHI_KN(shi_line_next)(n, k, q);
    *order = SHI_LOAD(m);
    *qm = SHI_KN(shi_blend)(zonal, SHI_SPLAT(0), q[k]);
}
/* for every register, in two loops: clang 14 unrolls none as long as both, and g++ none with a ?: in its condition */
#define SHI_LINE_EACH(n, k, put) do { \
        const int all = (n * n + SHI_W - 2) / SHI_W, half = SHI_LINE_REGISTERS / 2, first = all < half ? all : half; \
        SHI_UNROLL \
        for (k = 0; k < first; k++) put; \
        SHI_UNROLL \
        for (k = half; k < all; k++) put; \
    } while (0)

SHI_KERNEL void SHI_KN(shi_line_put)(int n, int planes, int k, const SHI_KN(shi_line) *o, SHI_V inverse, SHI_T *y, SHI_T *g)
{
    const int at = SHI_KN(shi_line_at)(n, k);
    const SHI_V f = SHI_KN(shi_line_spread)(n, k, o->c, o->s);
    SHI_KN(shi_put_line)(n, at, o->q[k] * f, y);
    if (planes == SH_GRADIENT) {
        const SHI_V ux = SHI_KN(shi_line_spread)(n, k, o->slope[0], o->slope[2]);
        const SHI_V uy = SHI_KN(shi_line_spread)(n, k, o->slope[1], o->slope[0]);
        SHI_V d, order, qm, b;
        SHI_KN(shi_line_terms)(n, k, o->q, &d, &order, &qm);
        b = SHI_FMA(o->u[2], d, order * qm);
        SHI_KN(shi_put_line)(n, at, SHI_FMA((-o->u[0] * inverse) * f, b, qm * ux), g);
        SHI_KN(shi_put_line)(n, at, SHI_FMA((-o->u[1] * inverse) * f, b, qm * uy), g + n * n);
        SHI_KN(shi_put_line)(n, at, (inverse * f) * SHI_FNMA(o->u[2], b, d), g + 2 * n * n);
    }
}
/* What shi_values and shi_gradient give, to the bit: y[N] and, if planes say so, g[3][N]. Returns 0, and writes
 * nothing, when the direction is out of range */
SHI_KERNEL int SHI_KN(shi_one_line)(int n, int planes, const SHI_T v[3], SHI_T *y, SHI_T *g)
{
    SHI_KN(shi_line) o;
    SHI_V w[3], inverse;
    int r, k, j;
    for (k = 0; k < 3; k++) w[k] = SHI_KEEP(SHI_SPLAT(v[k]));       /* or gcc multiplies before it spreads */
    if (!SHI_KN(shi_unit)(w, 1, o.u, &inverse)) return 0;
    SHI_KN(shi_line_start)(n, &o);
    y[0] = SHI_HORNER(0, 0, 0);
    if (planes == SH_GRADIENT) {
        g[0] = g[n * n] = g[2 * n * n] = 0;
        SHI_UNROLL
        for (r = 0; r * SHI_W < n; r++) {
            SHI_T plus[SHI_W], minus[SHI_W];
            SHI_UNROLL
            for (j = 0; j < SHI_W; j++) {
                plus[j] = SHI_C(r * SHI_W + j);
                minus[j] = SHI_C(-r * SHI_W - j);
            }
            o.slope[0][r] = (SHI_LOAD(minus) * inverse) * SHI_KN(shi_line_before)(r, o.c);
            o.slope[1][r] = (SHI_LOAD(plus) * inverse) * SHI_KN(shi_line_before)(r, o.s);
            o.slope[2][r] = -o.slope[1][r];
        }
    }
    SHI_LINE_EACH(n, k, SHI_KN(shi_line_put)(n, planes, k, &o, inverse, y, g));
    return 1;
}

SHI_KERNEL void SHI_KN(shi_line_put_angles)(int n, int k, const SHI_KN(shi_line) *o, const SHI_V f[4], SHI_T *y, SHI_T *dt,
                                            SHI_T *dp)
{
    const int at = SHI_KN(shi_line_at)(n, k);
    const SHI_V e = SHI_KN(shi_line_spread)(n, k, o->c, o->s), other = SHI_KN(shi_line_spread)(n, k, o->s, o->c);
    const SHI_V less = SHI_KN(shi_line_spread)(n, k, o->slope[0], o->slope[1]);
    SHI_T minus[SHI_W];
    SHI_V d, order, qm;
    int j;
    SHI_UNROLL
    for (j = 0; j < SHI_W; j++) minus[j] = SHI_C(-shi_order_of[at + j]);
    SHI_KN(shi_line_terms)(n, k, o->q, &d, &order, &qm);
    SHI_KN(shi_put_line)(n, at, o->q[k] * e, y);
    SHI_KN(shi_put_line)(n, at, SHI_FMA((order * f[0]) * qm, less, (-f[1] * d) * e), dt);
    SHI_KN(shi_put_line)(n, at, SHI_LOAD(minus) * (qm * other), dp);
}
/* what shi_angles gives, to the bit: y, dt, dp [N] */
SHI_KERNEL int SHI_KN(shi_line_angles)(int n, const SHI_T part[4], SHI_T *y, SHI_T *dt, SHI_T *dp)
{
    SHI_KN(shi_line) o;
    SHI_V f[4];
    int r, k;
    for (k = 0; k < 4; k++) f[k] = SHI_KEEP(SHI_SPLAT(part[k]));
    SHI_KN(shi_angles_unit)(f, o.u);
    SHI_KN(shi_line_start)(n, &o);
    SHI_UNROLL
    for (r = 0; r * SHI_W < n; r++) {
        const SHI_V c = SHI_KN(shi_line_before)(r, o.c), s = SHI_KN(shi_line_before)(r, o.s);
        o.slope[0][r] = SHI_FNMA(f[2], c, f[3] * s);
        o.slope[1][r] = SHI_FNMA(f[2], s, -(f[3] * c));
    }
    o.slope[0][0] = SHI_KN(shi_where)(SHI_W - 1, 0, SHI_SPLAT(0), o.slope[0][0]);
    y[0] = SHI_HORNER(0, 0, 0);
    dt[0] = dp[0] = 0;
    SHI_LINE_EACH(n, k, SHI_KN(shi_line_put_angles)(n, k, &o, f, y, dt, dp));
    return SH_OK;
}
#undef SHI_LINE_EACH
#endif

#if SHI_LANES == 1 || (SHI_FIXED && !defined(SHI_BY_LINE))
/* the same by the registers' first lane */
SHI_KERNEL int SHI_BN(shi_one)(int n, int planes, const SHI_T d[3], SHI_T *y, int ys, SHI_T *g, int gs, SHI_T *h, int hs)
{
    SHI_V v[3], u[4], inverse;
    int k;
    for (k = 0; k < 3; k++) v[k] = SHI_SPLAT(d[k]);
    if (!SHI_KN(shi_unit)(v, 1, u, &inverse)) return 0;
    if (planes == SH_VALUES) SHI_BN(shi_values)(n, 1, u, y, ys);
    else if (planes == SH_GRADIENT) SHI_BN(shi_gradient)(n, 1, u, inverse, y, ys, g, gs, NULL, NULL);
#if !SHI_FIXED
    else SHI_KN(shi_hessian)(n, u, inverse, y, ys, g, gs, h, hs);
#endif
    (void)h, (void)hs;
    return 1;
}
#endif

/* ================================================================================================================
 * Public functions: once per precision. They check, and call a kernel.
 * ============================================================================================================= */
#elif SHI_ROOM == SHI_PUBLIC

/* ---- what the public functions share ---- */

/* structural checks of a basis call: `needed` is its required output, or any pointer */
SHI_INLINE int SHI_FN(shi_check_basis)(int bands, size_t count, const SHI_T *v, const SHI_T *needed,
                                       const SHI_T *y, const SHI_T *g, const SHI_T *h)
{
    const size_t item = sizeof *v, in = 3 * count * item, size = (size_t)bands * (size_t)bands * count * item;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (count == 0) return SH_OK;
    if (count > SHI_MOST(6 * bands * bands)) return SH_ERROR_COUNT;
    if (!v || !needed) return SH_ERROR_NULL;
    if (shi_overlap(v, in, y, size) || shi_overlap(v, in, g, 3 * size) || shi_overlap(v, in, h, 6 * size)
        || shi_overlap(y, size, g, 3 * size) || shi_overlap(y, size, h, 6 * size) || shi_overlap(g, 3 * size, h, 6 * size))
        return SH_ERROR_OVERLAP;
    return SH_OK;
}

/* directions one at a time, with the bits of single calls: the status of the last bad one, whose outputs stay as they
 * are */
SHI_NOINLINE int SHI_FN(shi_one_by_one)(int n, int planes, size_t count, const SHI_T *dirs, int axis, int next,
                                        SHI_T *y, int ys, int y_next, SHI_T *g, int gs, int g_next, SHI_T *h, int hs, int h_next)
{
    SHI_T t[4 * SH_UNROLLED_BANDS * SH_UNROLLED_BANDS];
    const int size = n * n, direct = planes == SH_HESSIAN || n > SH_UNROLLED_BANDS;
    int status = SH_OK, ok, k;
    size_t p;
    for (p = 0; p < count; p++, dirs += next, y += y_next, g += g_next, h += h_next) {
        SHI_T v[3];
        for (k = 0; k < 3; k++) v[k] = dirs[k * axis];
        if (direct) ok = SHI_MANY(shi_single_any)(n, planes, v, y, ys, g, gs, h, hs);
        else ok = planes == SH_VALUES ? SHI_MANY(shi_single_values)(n, v, t) : SHI_MANY(shi_single_both)(n, v, t, t + size);
        if (!ok) status = SHI_FN(shi_direction_status)(v);
        for (k = 0; k < size && ok && !direct; k++) y[k * ys] = t[k];
        for (k = 0; k < 3 * size && ok && !direct && planes == SH_GRADIENT; k++) g[k * gs] = t[size + k];
    }
    return status;
}

/* plain layout: through blocks while one fits a stage and its planes do not meet in the same cache sets, else one by one;
 * in double that is soon as fast for gradients */
SHI_NOINLINE int SHI_FN(shi_batch)(int n, int planes, size_t count, const SHI_T *dirs, SHI_T *y, SHI_T *g, SHI_T *h)
{
    SHI_T discard[SH_BLOCK];
    const int s = n * n;
    const size_t plane = (size_t)(s * SH_BLOCK) * sizeof(SHI_T);
    const size_t most = SHI_BITS == 64 && planes == SH_GRADIENT ? SHI_BIG_STAGE / 2 : SHI_BIG_STAGE;
    if (plane * (size_t)planes <= SHI_STAGE) return SHI_MANY(shi_plain)(n, planes, count, dirs, y, g, h);
    if (plane * (size_t)planes <= most && plane % 16384) return SHI_MANY(shi_plain_big)(n, planes, count, dirs, y, g, h);
    return SHI_FN(shi_one_by_one)(n, planes, count, dirs, 1, 3, y ? y : discard, y != NULL, y ? s : 0,
                                  g ? g : discard, g != NULL, g ? 3 * s : 0, h ? h : discard, h != NULL, h ? 6 * s : 0);
}

/* L_lm = f_l Y_lm of a cap, s and alpha sine and cosine of its half-angle: f_0 = 2 pi s^2/(1+alpha), f_l = 2 pi s^2
 * P_l'(alpha)/(l(l+1)); with P_l(alpha) and P_l'. They run by differences in kappa = 1 - alpha = s^2/(1+alpha): the rounding
 * of alpha, times l^2 for small lights, does not enter. */
SHI_INLINE void SHI_FN(shi_cap)(int n, SHI_T s, SHI_T alpha, SHI_T *f, SHI_T *legendre, SHI_T *slopes)
{
    const SHI_T tau = SHI_C(SHI_TAU), s2 = s * s, kappa = s2 / (1 + alpha);
    SHI_T p = 1, fall = 0, slope = 0;                           /* P_l, P_{l-1} - P_l, P_l' */
    int l;
    for (l = 0; l < n; l++) {
        if (l > 0) {
            slope = slope + (SHI_C(l) * p - kappa * slope);
            fall = SHI_ONE(shi_fall)(SHI_FN(shi_ratio)[SHI_TABLE_AT(l, 0)], kappa, p, fall);
            p = p - fall;
        }
        f[l] = l ? tau * s2 * slope * SHI_FN(shi_profile)[SHI_PROFILE * l + 4] : tau * kappa;       /* 1/(l (l+1)) */
        legendre[l] = p;
        slopes[l] = slope;
    }
}

/* f(d) Y_lm(v/d) and its derivatives by the shading point, from f, f', f'' */
SHI_NOINLINE int SHI_FN(shi_symmetric)(int n, const SHI_T v[3], const SHI_T *f, const SHI_T *f1, const SHI_T *f2,
                                       SHI_T *c, SHI_T *g, SHI_T *h)
{
    SHI_T gradient[3 * SH_MAX_BANDS * SH_MAX_BANDS], u[4], inverse, scaled[3];
    const SHI_T up = h && v[0] * v[0] + v[1] * v[1] + v[2] * v[2] < SHI_C(1e-20) ? SHI_C(1152921504606846976.0) : 1;   /* 2^60 */
    const int size = n * n;
    int l, k, j, p;
    if (h && !g) g = gradient;
    for (k = 0; k < 3; k++) scaled[k] = up * v[k];              /* the basis' Hessian at v could overflow, f times that not */
    if (!SHI_ONE(shi_unit)(v, 1, u, &inverse)
        || !(h ? SHI_MANY(shi_single_hessian)(n, scaled, c, g, h) : g ? SHI_MANY(shi_single_gradient)(n, v, c, g)
                                                                  : SHI_MANY(shi_single_values)(n, v, c)))
        return SHI_FN(shi_direction_status)(v);
    for (l = 0; l < n; l++) {
        const SHI_T by_u[3] = { f1[l] * u[0], f1[l] * u[1], f1[l] * u[2] }, by_y = f[l], by_d = up * f[l];
        const int end = (l + 1) * (l + 1);
        int at;
        for (at = l * l; at < end && h; at++) {
            const SHI_T y = c[at], d[3] = { up * g[at], up * g[size + at], up * g[2 * size + at] };
            for (k = 0, p = 0; k < 3; k++)
                for (j = k; j < 3; j++, p++) {
                    SHI_T *const x = h + p * size + at;
                    *x = f2[l] * y * u[k] * u[j] + f1[l] * (inverse * y * ((k == j) - u[k] * u[j]) + (u[k] * d[j] + d[k] * u[j]))
                       + f[l] * *x * up * up;
                }
        }
        for (k = 0; k < 3 && g; k++)
            for (at = l * l; at < end; at++) g[k * size + at] = -(by_u[k] * c[at] + by_d * g[k * size + at]);
        for (at = l * l; at < end; at++) c[at] = by_y * c[at];
    }
    return SH_OK;
}

SHI_NOINLINE int SHI_FN(shi_sphere)(int n, const SHI_T x[3], const SHI_T y[3], SHI_T r, SHI_T *c, SHI_T *g, SHI_T *h)
{
    SHI_T f[SH_MAX_BANDS], f1[SH_MAX_BANDS], f2[SH_MAX_BANDS], v[3], u[4], inverse, gap;
    const size_t size = (size_t)(n * n) * sizeof *c;
    int k, l, inside;
    if (!SHI_FN(shi_finite)(x, 3) || !SHI_FN(shi_finite)(y, 3) || !SHI_FN(shi_finite)(&r, 1)) return SH_ERROR_NOT_FINITE;
    if (r < 0) return SH_ERROR_RADIUS;
    for (k = 0; k < 3; k++) v[k] = y[k] - x[k];
    gap = r > SHI_VAST && v[0] * v[0] + v[1] * v[1] + v[2] * v[2] < SHI_MAX2 ? -1 : SHI_ONE(shi_gap)(y, x, r);
    inside = r > 0 && gap <= 0;
    if (r > 0 && !inside) {
        SHI_T s, alpha, q;
        if (!SHI_ONE(shi_unit)(v, 1, u, &inverse)) return SH_ERROR_DIRECTION;
        s = r * inverse;
        alpha = SHI_LIBM(sqrt)(gap) * inverse;
        q = s * s * inverse / alpha;                            /* d alpha / dd */
        SHI_FN(shi_cap)(n, s, alpha, f, f1, f2);
        for (l = 0; l < n; l++) {                               /* f' and f'' by d, from P_l and P_l' */
            const SHI_T p = f1[l], slope = f2[l];
            f1[l] = -SHI_C(SHI_TAU) * p * q;
            f2[l] = SHI_C(SHI_TAU) * (p * (3 * q * inverse + q * q / alpha) - slope * q * q);
        }
        return SHI_FN(shi_symmetric)(n, v, f, f1, f2, c, g, h);
    }
    memset(c, 0, size);
    if (g) memset(g, 0, 3 * size);
    if (h) memset(h, 0, 6 * size);
    if (inside) c[0] = SHI_C(SHI_ROOT_FOUR_PI);
    return inside ? SH_INSIDE : SH_OK;
}

SHI_NOINLINE int SHI_FN(shi_light_field)(int n, size_t count, const SHI_T *dirs, const SHI_T *solid_angles,
                                         const SHI_T *radiance,
                                         const SHI_T *depth, const SHI_T *normals, SHI_T *coeffs, SHI_T *grad)
{
    double sum[4][SH_MAX_BANDS * SH_MAX_BANDS];
    SHI_T y[SH_MAX_BANDS * SH_MAX_BANDS], g[3 * SH_MAX_BANDS * SH_MAX_BANDS];
    const int size = n * n;
    size_t t;
    int i, k;
    for (k = 0; k < 4; k++)
        for (i = 0; i < size; i++) sum[k][i] = 0;
    for (t = 0; t < count; t++) {
        const SHI_T *const w = dirs + 3 * t, *a;
        const SHI_T power = solid_angles[t] * radiance[t];
        SHI_T u[4], normal[3], inverse, facing, least, scale, largest = 0;
        if (!SHI_MANY(shi_single_gradient)(n, w, y, grad ? g : NULL)) return SHI_FN(shi_direction_status)(w);
        for (i = 0; i < size; i++) sum[0][i] += (double)(power * y[i]);
        if (!grad) continue;
        a = normals + 3 * t;
        if (depth[t] <= 0) return SH_ERROR_RADIUS;
        if (!SHI_FN(shi_finite)(a, 3) || SHI_FN(shi_is_nan)(depth[t])) return SH_ERROR_NOT_FINITE;
        if (!SHI_FN(shi_finite)(depth + t, 1)) continue;
        (void)SHI_ONE(shi_unit)(w, 1, u, &inverse);
        for (k = 0; k < 3; k++) largest = SHI_LIBM(fabs)(a[k]) > largest ? SHI_LIBM(fabs)(a[k]) : largest;
        for (k = 0; k < 3; k++) normal[k] = largest > 0 ? a[k] / largest : 0;                  /* of any length */
        least = SHI_C(1e-3) * SHI_LIBM(sqrt)(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        facing = normal[0] * u[0] + normal[1] * u[1] + normal[2] * u[2];
        if (SHI_LIBM(fabs)(facing) < least) facing = facing < 0 ? -least : least;
        scale = power / depth[t];
        for (k = 0; k < 3; k++) {
            const SHI_T e = (least > 0 ? normal[k] / facing : 0) - 3 * u[k];
            for (i = 0; i < size; i++) sum[k + 1][i] -= (double)(scale * (g[k * size + i] / inverse + y[i] * e));
        }
    }
    for (i = 0; i < size; i++) coeffs[i] = (SHI_T)sum[0][i];
    for (i = 0; i < 3 * size && grad; i++) grad[i] = (SHI_T)sum[1 + i / size][i % size];
    return SH_OK;
}

/* ---- sums of spherical lights ---- */

SHI_INLINE int SHI_FN(shi_check_grid)(const SHI_FN(sh_grid) *g, size_t first, size_t nodes)
{
    size_t all = 1;
    int k;
    for (k = 0; k < 3; k++) {
        if (!SHI_FN(shi_finite)(&g->origin[k], 1) || !SHI_FN(shi_finite)(&g->cell[k], 1)) return SH_ERROR_NOT_FINITE;
        if (g->count[k] < 1 || !(g->cell[k] > 0 || g->count[k] == 1)) return SH_ERROR_GRID;
        if (all > (size_t)-1 / (size_t)g->count[k]) return SH_ERROR_COUNT;
        all *= (size_t)g->count[k];
    }
    return first > all || nodes > all - first ? SH_ERROR_COUNT : SH_OK;
}

/* where sums are taken: at[count][3] or, `at` NULL, nodes first, first + 1, ... of a grid */
typedef struct {
    size_t count, first;
    const SHI_T *at;
    const SHI_FN(sh_grid) *grid;
} SHI_FN(shi_places);

SHI_INLINE void SHI_FN(shi_place)(const SHI_FN(shi_places) *o, size_t i, SHI_T x[3])
{
    if (o->at) {
        memcpy(x, o->at + 3 * i, 3 * sizeof *x);
    } else {
        const SHI_FN(sh_grid) *const g = o->grid;
        const size_t node = o->first + i, nx = (size_t)g->count[0], ny = (size_t)g->count[1];
        x[0] = g->origin[0] + (SHI_T)(node % nx) * g->cell[0];
        x[1] = g->origin[1] + (SHI_T)(node / nx % ny) * g->cell[1];
        x[2] = g->origin[2] + (SHI_T)(node / nx / ny) * g->cell[2];
    }
}

SHI_INLINE int SHI_FN(shi_places_overlap)(const SHI_FN(shi_places) *o, const SHI_T *out, size_t bytes)
{
    return shi_overlap(o->at, 3 * o->count * sizeof *out, out, bytes) || shi_overlap(o->grid, sizeof *o->grid, out, bytes);
}

/* a sum of spheres as it was asked for */
typedef struct {
    int bands, planes, channels;
    SHI_FN(shi_places) places;
    size_t count;
    const SHI_T *spheres, *radiance;
} SHI_FN(shi_lights);

SHI_INLINE int SHI_FN(shi_check_lights)(const SHI_FN(shi_lights) *o, const SHI_T *out)
{
    const size_t item = sizeof *out, channels = (size_t)o->channels, points = o->places.count;
    const size_t bytes = points * channels * (size_t)o->planes * (size_t)o->bands * (size_t)o->bands * item;
    if (o->bands < 1 || o->bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (o->planes != SH_VALUES && o->planes != SH_GRADIENT && o->planes != SH_HESSIAN) return SH_ERROR_OPTION;
    if (o->channels < 1) return SH_ERROR_COUNT;
    if (points == 0) return SH_OK;
    if (points > SHI_MOST(o->planes * o->bands * o->bands + 3) / channels || o->count > SHI_MOST(4) / channels)
        return SH_ERROR_COUNT;
    if (!(o->places.at || o->places.grid) || (o->count && !o->spheres) || !out) return SH_ERROR_NULL;
    if (o->places.grid) {
        const int status = SHI_FN(shi_check_grid)(o->places.grid, o->places.first, points);
        if (status) return status;
    }
    if (SHI_FN(shi_places_overlap)(&o->places, out, bytes) || shi_overlap(o->spheres, 4 * o->count * item, out, bytes)
        || shi_overlap(o->radiance, channels * o->count * item, out, bytes)) return SH_ERROR_OVERLAP;
    return SH_OK;
}

/* out[axis](l,m), l < n: derivative by the shading point of the coefficients whose moments at l-1 are `lower` and at
 * l+1 `upper` (both indexed l(l+1)+m), by the recurrences of x_k Y_lm */
SHI_INLINE void SHI_FN(shi_derive)(int n, const SHI_T *lower, const SHI_T *upper, SHI_T *gx, SHI_T *gy, SHI_T *gz)
{
    const SHI_T *const root = SHI_FN(shi_root), half = SHI_C(0.5), root_half = SHI_C(0.70710678118654752);
    int l, m;
    for (l = 0; l < n; l++) {
        const SHI_T h0 = SHI_FN(shi_inverse_root)[l], h1 = SHI_FN(shi_inverse_root)[l + 1];
        /* rows l-1 and l+1, at m = 0 */
        const SHI_T *const b = lower + l * (l - 1), *const t = upper + (l + 1) * (l + 2);
        const int at = l * (l + 1);
        for (m = 0; m <= l; m++) {
            const SHI_T up1 = root[l + m + 2] * root[l + m + 1] * h1, zt = root[l + m + 1] * root[l - m + 1] * h1;
            const SHI_T up0 = m + 1 < l ? root[l - m] * root[l - m - 1] * h0 : 0;
            const SHI_T zb = m < l ? root[l + m] * root[l - m] * h0 : 0;
            SHI_T uc = up1 * t[m + 1], us = up1 * t[-m - 1], dc = 0, ds = 0;
            if (m + 1 < l) {
                uc -= up0 * b[m + 1];
                us -= up0 * b[-m - 1];
            }
            gz[at + m] = -(zt * t[m] + (m < l ? zb * b[m] : 0));
            if (m == 0) {
                gx[at] = root_half * uc;
                gy[at] = root_half * us;
                continue;
            }
            gz[at - m] = -(zt * t[-m] + (m < l ? zb * b[-m] : 0));
            {
                const SHI_T k = m == 1 ? root[2] : 1;
                const SHI_T dn1 = k * root[l - m + 2] * root[l - m + 1] * h1;
                const SHI_T dn0 = k * root[l + m] * root[l + m - 1] * h0;
                dc = dn0 * b[m - 1] - dn1 * t[m - 1];
                if (m > 1) ds = dn0 * b[1 - m] - dn1 * t[1 - m];
            }
            gx[at + m] = half * (uc + dc);
            gx[at - m] = half * (us + ds);
            gy[at + m] = half * (us - ds);
            gy[at - m] = half * (dc - uc);
        }
    }
}

#define SHI_SPHERES_WORK(n, channels) ((channels) * SHI_ALL_KINDS * ((n) + 2) * ((n) + 2) + 7 * ((n) + 1) * ((n) + 1))
/* `channels` of them from `channel` on at a point x: out[channels][planes][N]; `work` is that of
 * SHI_SPHERES_WORK: moments per channel, and derivatives. Returns shi_moments' bits */
SHI_INLINE int SHI_FN(shi_spheres_at)(const SHI_FN(shi_lights) *o, int channel, int channels, const SHI_T x[3], SHI_T *work,
                                      SHI_T *out)
{
    const int n = o->bands, planes = o->planes, size = n * n;
    const int kinds = planes == SH_VALUES ? 1 : planes == SH_GRADIENT ? 3 : SHI_ALL_KINDS;
    const int levels = n + SHI_EXTRA_BANDS(kinds), plane = levels * levels;
    const SHI_T *const radiance = o->radiance ? o->radiance + (size_t)channel * o->count : NULL;
    const int flags =
        planes == SH_VALUES     ? SHI_WIDE(shi_moments_values)(n, channels, x, o->count, o->spheres, radiance, work)
        : planes == SH_GRADIENT ? SHI_WIDE(shi_moments_gradient)(n, channels, x, o->count, o->spheres, radiance, work)
                                : SHI_WIDE(shi_moments_hessian)(n, channels, x, o->count, o->spheres, radiance, work);
    SHI_T *const spare = work + channels * kinds * plane;
    int k;
    if (flags & ~SHI_IS_INSIDE) return flags;
    for (; channels > 0; channels--, work += kinds * plane, out += planes * size) {
        memcpy(out, work, (size_t)size * sizeof *out);
        if (planes != SH_VALUES)
            SHI_FN(shi_derive)(n, work + plane, work + 2 * plane, out + size, out + 2 * size, out + 3 * size);
        if (planes == SH_HESSIAN) {
            const int wide = (n + 1) * (n + 1);
            SHI_T *const below = spare, *const above = below + 3 * wide, *const unused = above + 3 * wide;
            SHI_T *const h = out + 4 * size;
            SHI_FN(shi_derive)(n - 1, work + 3 * plane, work + 4 * plane, below, below + wide, below + 2 * wide);
            SHI_FN(shi_derive)(n + 1, work + 4 * plane, work + 5 * plane, above, above + wide, above + 2 * wide);
            for (k = 0; k < 3; k++)                             /* rows x, y, z: columns xx xy xz, - yy yz, - - zz */
                SHI_FN(shi_derive)(n, below + k * wide, above + k * wide, k == 0 ? h : unused,
                                   k == 2 ? unused : h + (k ? 3 : 1) * size, h + (k == 0 ? 2 : k == 1 ? 4 : 5) * size);
        }
    }
    return flags;
}

/* work holds `most` channels */
SHI_INLINE int SHI_FN(shi_spheres_with)(const SHI_FN(shi_lights) *o, int most, SHI_T *work, SHI_T *out)
{
    const size_t block = (size_t)(o->bands * o->bands * o->planes);
    int status = SH_OK, c;
    size_t p;
    for (p = 0; p < o->places.count; p++) {
        SHI_T x[3];
        SHI_FN(shi_place)(&o->places, p, x);
        if (!SHI_FN(shi_finite)(x, 3)) {
            status = SH_ERROR_NOT_FINITE;
            continue;
        }
        for (c = 0; c < o->channels; c += most) {
            const int channels = o->channels - c < most ? o->channels - c : most;
            const int flags = SHI_FN(shi_spheres_at)(o, c, channels, x, work,
                                                     out + (p * (size_t)o->channels + (size_t)c) * block);
            if ((flags & SHI_NOT_FINITE) && !SHI_FN(shi_finite)(o->spheres, 4 * o->count)) return SH_ERROR_NOT_FINITE;
            if (flags & SHI_BAD_RADIUS) return SH_ERROR_RADIUS;
            if (flags & SHI_NOT_FINITE) {                       /* too far from a light: this point alone */
                status = SH_ERROR_DIRECTION;
                break;
            }
            if (flags && status == SH_OK) status = SH_INSIDE;
        }
    }
    return status;
}

/* less stack to 10 bands */
SHI_NOINLINE int SHI_FN(shi_spheres_10)(const SHI_FN(shi_lights) *o, SHI_T *out)
{
    SHI_T work[SHI_SPHERES_WORK(10, 3)];
    return SHI_FN(shi_spheres_with)(o, 3, work, out);
}
SHI_NOINLINE int SHI_FN(shi_spheres_32)(const SHI_FN(shi_lights) *o, SHI_T *out)
{
    SHI_T work[SHI_SPHERES_WORK(SH_MAX_BANDS, 1)];
    return SHI_FN(shi_spheres_with)(o, 1, work, out);
}
SHI_INLINE int SHI_FN(shi_spheres)(const SHI_FN(shi_lights) *o, SHI_T *out)
{
    const int status = SHI_FN(shi_check_lights)(o, out);
    return status || !o->places.count ? status
         : o->bands <= 10             ? SHI_FN(shi_spheres_10)(o, out)
                                      : SHI_FN(shi_spheres_32)(o, out);
}

/* ---- basis ---- */

/* Basis values at a direction.
 *   bands  1..32
 *   dir    any length from 1e-18 to 1e18 (double 1e-150 to 1e150); it is normalised
 *   y      [N]
 * Error:  |y - exact| <= (4 + l(l+1)/4) eps M_l.
 * Source: S13; M22 Eq. 7-8. */
SH_API int SHI_FN(sh_eval)(int bands, const SHI_T dir[3], SHI_T *y)
{
    const int status = SHI_FN(shi_check_basis)(bands, 1, dir, y, y, NULL, NULL);
    if (status) return status;
    return SHI_MANY(shi_single_values)(bands, dir, y) ? SH_OK : SHI_FN(shi_direction_status)(dir);
}

/* Basis values of many directions.
 *   dirs  [count][3]
 *   y     [count][N]
 * Directions that are nearly unit, | |v|^2 - 1 | < 1e-4 (double 4e-9), take a Newton step, the others are first scaled. */
SH_API int SHI_FN(sh_eval_n)(int bands, size_t count, const SHI_T *dirs, SHI_T *y)
{
    const int status = SHI_FN(shi_check_basis)(bands, count, dirs, y, y, NULL, NULL);
    return status || !count ? status : SHI_FN(shi_batch)(bands, SH_VALUES, count, dirs, y, NULL, NULL);
}

/* The same in the blocked layout, stored as the registers hold it.
 *   dirs  [blocks][3][8], SH_BLOCK = 8 directions a block (fill the last one up with any direction)
 *   y     [blocks][N][8] */
SH_API int SHI_FN(sh_eval_blocks)(int bands, size_t blocks, const SHI_T *dirs, SHI_T *y)
{
    const int status = SHI_FN(shi_check_basis)(bands, shi_block_items(blocks), dirs, y, y, NULL, NULL);
    return status || !blocks ? status : SHI_MANY(shi_blocks_values)(bands, blocks, dirs, y);
}

/* Values and gradient of Y(v/|v|) by v, finite everywhere, the poles included.
 *   v     any length from 1e-18 to 1e18 (double 1e-150 to 1e150)
 *   y     [N] or NULL
 *   grad  [3][N] or NULL
 * Error:  y as sh_eval; |grad - exact| <= (8 + l(l+1)/4) eps G_l / |v|.
 * Source: dQ_l^m/dz = Q_l^{m+1}, in place of M22 Eq. 23, which divides by sin(theta). */
SH_API int SHI_FN(sh_eval_grad)(int bands, const SHI_T v[3], SHI_T *y, SHI_T *grad)
{
    const int status = SHI_FN(shi_check_basis)(bands, 1, v, v, y, grad, NULL);
    if (status) return status;
    if (!(y && grad ? SHI_MANY(shi_single_both)(bands, v, y, grad) : SHI_MANY(shi_single_gradient)(bands, v, y, grad)))
        return SHI_FN(shi_direction_status)(v);
    return SH_OK;
}

/* Many: v[count][3], y[count][N] or NULL, grad[count][3][N] or NULL. */
SH_API int SHI_FN(sh_eval_grad_n)(int bands, size_t count, const SHI_T *v, SHI_T *y, SHI_T *grad)
{
    const int status = SHI_FN(shi_check_basis)(bands, count, v, v, y, grad, NULL);
    return status || !count ? status : SHI_FN(shi_batch)(bands, SH_GRADIENT, count, v, y, grad, NULL);
}

/* Blocked: v[blocks][3][8], y[blocks][N][8] or NULL, grad[blocks][3][N][8] or NULL. */
SH_API int SHI_FN(sh_eval_grad_blocks)(int bands, size_t blocks, const SHI_T *v, SHI_T *y, SHI_T *grad)
{
    const int status = SHI_FN(shi_check_basis)(bands, shi_block_items(blocks), v, v, y, grad, NULL);
    return status || !blocks ? status : SHI_MANY(shi_blocks_gradient)(bands, blocks, v, y, grad);
}

/* Values, gradient and Hessian of Y(v/|v|) by v.
 *   y, grad  as above
 *   hess     [6][N]: xx xy xz yy yz zz, or NULL
 * Error:  |hess - exact| <= (16 + l(l+1)/2) eps l(l+1) M_l / |v|^2.
 * Source: the same sweep with two columns ahead. */
SH_API int SHI_FN(sh_eval_hessian)(int bands, const SHI_T v[3], SHI_T *y, SHI_T *grad, SHI_T *hess)
{
    const int status = SHI_FN(shi_check_basis)(bands, 1, v, v, y, grad, hess);
    if (status) return status;
    return SHI_MANY(shi_single_hessian)(bands, v, y, grad, hess) ? SH_OK : SHI_FN(shi_direction_status)(v);
}

/* Many: v[count][3], y[count][N], grad[count][3][N], hess[count][6][N]; any output may be NULL. */
SH_API int SHI_FN(sh_eval_hessian_n)(int bands, size_t count, const SHI_T *v, SHI_T *y, SHI_T *grad, SHI_T *hess)
{
    const int status = SHI_FN(shi_check_basis)(bands, count, v, v, y, grad, hess);
    return status || !count ? status : SHI_FN(shi_batch)(bands, SH_HESSIAN, count, v, y, grad, hess);
}

/* Blocked: v[blocks][3][8], y[blocks][N][8], grad[blocks][3][N][8], hess[blocks][6][N][8]; any output may be NULL. */
SH_API int SHI_FN(sh_eval_hessian_blocks)(int bands, size_t blocks, const SHI_T *v, SHI_T *y, SHI_T *grad, SHI_T *hess)
{
    const int status = SHI_FN(shi_check_basis)(bands, shi_block_items(blocks), v, v, y, grad, hess);
    return status || !blocks ? status : SHI_MANY(shi_blocks_hessian)(bands, blocks, v, y, grad, hess);
}

/* Values and derivatives by the polar angle theta and the azimuth phi, in radians; outputs [N], each may be NULL.
 *   bands       1..32
 *   theta, phi  finite (else SH_ERROR_NOT_FINITE), any theta
 * At a pole dtheta is the derivative along the meridian phi, and dphi is 0: moving phi there moves nothing.
 * Error:  y, dtheta as sh_eval_grad at |v| = 1, dphi m times the bound of y; angles are taken as exact.
 * Source: M22 Eq. 17-22; dq/dtheta = -sin(theta) q' from the next column in place of the recurrences of Eq. 30-33. */
SH_API int SHI_FN(sh_eval_angles)(int bands, SHI_T theta, SHI_T phi, SHI_T *y, SHI_T *dtheta, SHI_T *dphi)
{
    const size_t out = (size_t)bands * (size_t)bands * sizeof *y;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (shi_overlap(y, out, dtheta, out) || shi_overlap(y, out, dphi, out) || shi_overlap(dtheta, out, dphi, out))
        return SH_ERROR_OVERLAP;
    return SHI_MANY(shi_single_angles)(bands, theta, phi, y, dtheta, dphi);
}

/* Many: theta[count], phi[count]; y, dtheta, dphi [count][N] or NULL. */
SH_API int SHI_FN(sh_eval_angles_n)(int bands, size_t count, const SHI_T *theta, const SHI_T *phi,
                                    SHI_T *y, SHI_T *dtheta, SHI_T *dphi)
{
    const size_t size = (size_t)bands * (size_t)bands, in = count * sizeof *theta, out = count * size * sizeof *theta;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (count == 0) return SH_OK;
    if (count > SHI_MOST(bands * bands)) return SH_ERROR_COUNT;
    if (!theta || !phi) return SH_ERROR_NULL;
    if (shi_overlap(theta, in, y, out) || shi_overlap(theta, in, dtheta, out) || shi_overlap(theta, in, dphi, out)
        || shi_overlap(phi, in, y, out) || shi_overlap(phi, in, dtheta, out) || shi_overlap(phi, in, dphi, out)
        || shi_overlap(y, out, dtheta, out) || shi_overlap(y, out, dphi, out) || shi_overlap(dtheta, out, dphi, out))
        return SH_ERROR_OVERLAP;
    return size * 3 * SH_VECTOR_BYTES > SHI_STAGE ? SHI_MANY(shi_angles_big)(bands, count, theta, phi, y, dtheta, dphi)
                                                  : SHI_MANY(shi_angles)(bands, count, theta, phi, y, dtheta, dphi);
}

/* ---- sums over directions ---- */

/* value = sum c_i Y_i(d/|d|) at many directions, and its gradient by d; the basis is never stored.
 *   bands   1..32
 *   coeffs  [N], beyond 10 bands of up to 1e26 (double 1e296)
 *   dirs    [count][3], lengths as in sh_eval_grad
 *   values  [count] or NULL
 *   grads   [count][3] or NULL
 * Error:  |value - exact| <= (8 + n^2/4) eps sqrt(sum_l M_l^2) |coeffs|_2 over n bands, gradients n times that / |d|.
 * Source: M22 Eq. 8 with the sums over l and over m by Horner's rule, beyond 10 bands about Leja points (Newton's form). */
SH_API int SHI_FN(sh_reconstruct_n)(int bands, const SHI_T *coeffs, size_t count, const SHI_T *dirs, SHI_T *values,
                                    SHI_T *grads)
{
    SHI_T a[2 * SH_MAX_BANDS * SH_MAX_BANDS];
    const size_t item = sizeof *coeffs, size = (size_t)bands * (size_t)bands;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (count == 0) return SH_OK;
    if (count > SHI_MOST(3)) return SH_ERROR_COUNT;
    if (!coeffs || !dirs) return SH_ERROR_NULL;
    if (shi_overlap(dirs, 3 * count * item, values, count * item)
        || shi_overlap(dirs, 3 * count * item, grads, 3 * count * item)
        || shi_overlap(coeffs, size * item, values, count * item) || shi_overlap(coeffs, size * item, grads, 3 * count * item)
        || shi_overlap(values, count * item, grads, 3 * count * item)) return SH_ERROR_OVERLAP;
    SHI_MANY(shi_sum_form)(bands, coeffs, a);
    if (grads) return SHI_WIDE(shi_sum_gradient)(bands, a, count, dirs, values, grads);
    return values ? SHI_WIDE(shi_sum_values)(bands, a, count, dirs, values) : SH_OK;
}

/* One direction: value and grad[3], each may be NULL. For many directions sh_reconstruct_n shares the preparation of coeffs. */
SH_API int SHI_FN(sh_reconstruct)(int bands, const SHI_T *coeffs, const SHI_T dir[3], SHI_T *value, SHI_T *grad)
{
    return SHI_FN(sh_reconstruct_n)(bands, coeffs, 1, dir, value, grad);
}

/* coeffs = sum_k weights[k] Y(dirs[k]): the projection of samples, weight = value x solid angle.
 *   bands    1..32
 *   dirs     [count][3], lengths as in sh_eval; a bad one is an error of the call
 *   weights  [count]
 *   coeffs   [N], overwritten; count 0 gives zeros
 * Error:  |coeffs - exact| <= (8 + l(l+1)/4 + min(count, 160)/2) eps M_l sum |weights|. */
SH_API int SHI_FN(sh_project_n)(int bands, size_t count, const SHI_T *dirs, const SHI_T *weights, SHI_T *coeffs)
{
    const size_t size = (size_t)bands * (size_t)bands, item = sizeof *coeffs, most = 4096;
    double total[SH_MAX_BANDS * SH_MAX_BANDS], lost[SH_MAX_BANDS * SH_MAX_BANDS];       /* of the sums of so many */
    SHI_T sum[SH_MAX_BANDS * SH_MAX_BANDS];
    size_t p, i;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (count > SHI_MOST(3)) return SH_ERROR_COUNT;
    if (!coeffs || (count && (!dirs || !weights))) return SH_ERROR_NULL;
    if (shi_overlap(dirs, 3 * count * item, coeffs, size * item) || shi_overlap(weights, count * item, coeffs, size * item))
        return SH_ERROR_OVERLAP;
    for (i = 0; i < size; i++) total[i] = lost[i] = 0;
    for (p = 0; p < count; p += most) {
        if (SHI_WIDE(shi_moments_values)(bands, 1, NULL, count - p < most ? count - p : most, dirs + 3 * p, weights + p, sum))
            return SHI_FN(shi_finite)(dirs, 3 * count) ? SH_ERROR_DIRECTION : SH_ERROR_NOT_FINITE;
        for (i = 0; i < size; i++) {                            /* Neumaier: rounding stops growing with count */
            const double add = (double)sum[i], all = total[i] + add;
            lost[i] += fabs(total[i]) >= fabs(add) ? (total[i] - all) + add : (add - all) + total[i];
            total[i] = all;
        }
    }
    for (i = 0; i < size; i++) coeffs[i] = (SHI_T)(total[i] + lost[i]);
    return SH_OK;
}

/* Coefficients of a light field seen from one point, and their gradient by that point, from samples with depth and normal
 * (the texels of a cube map rendered there).
 *   bands         1..32
 *   dirs          [count][3], lengths as in sh_eval; a bad one is an error of the call
 *   solid_angles  [count], steradians
 *   radiance      [count]; NaN goes through
 *   depth         [count], distance along the direction, > 0 (else SH_ERROR_RADIUS); infinity means no parallax
 *   normals       [count][3] of the surface seen, any length and either orientation; zero: the orientation term is left out
 *   coeffs        [N]
 *   grad          [3][N] or NULL
 * The gradient is exact for planar emitters up to the sampling. At a silhouette n.w goes to 0: |n.w| is taken as at
 * least 1e-3 |n|, which bounds what a grazing texel can add.
 * Error:  |coeffs - exact| <= (8 + l(l+1)/4) eps M_l sum |solid_angles radiance|, however many samples (double: + count/2).
 * Source: A04 Eq. 10-13, with the same signed normal in both terms. */
SH_API int SHI_FN(sh_light_field)(int bands, size_t count, const SHI_T *dirs, const SHI_T *solid_angles,
                                  const SHI_T *radiance,
                                  const SHI_T *depth, const SHI_T *normals, SHI_T *coeffs, SHI_T *grad)
{
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (count > SHI_MOST(3)) return SH_ERROR_COUNT;
    if (!coeffs || (count && (!dirs || !solid_angles || !radiance || (grad && (!depth || !normals))))) return SH_ERROR_NULL;
    {
        const void *in[5];
        const size_t item = sizeof *coeffs, size = (size_t)(bands * bands) * item;
        size_t k;
        in[0] = dirs;
        in[1] = normals;
        in[2] = solid_angles;
        in[3] = radiance;
        in[4] = depth;
        for (k = 0; k < 5; k++) {
            const size_t bytes = count * item * (k < 2 ? 3 : 1);
            if (shi_overlap(in[k], bytes, coeffs, size) || shi_overlap(in[k], bytes, grad, 3 * size)) return SH_ERROR_OVERLAP;
        }
        if (shi_overlap(coeffs, size, grad, 3 * size)) return SH_ERROR_OVERLAP;
    }
    return SHI_FN(shi_light_field)(bands, count, dirs, solid_angles, radiance, depth, normals, coeffs, grad);
}

/* ---- zonal harmonics ---- */

/* Zonal harmonics of a cap of unit radiance about +z, and their derivative by its half-angle.
 *   sin_half_angle  0..1; a spherical light of radius r at distance d has r/d
 *   zh, dzh         [bands], zh_l = L_l0; each may be NULL
 * Error:  |zh - exact| <= 24 eps M_l Omega, |dzh - exact| <= 32 eps M_l dOmega, Omega = 2 pi (1 - cos) the solid angle and
 *         dOmega = 2 pi sin its derivative; x 1/(1 - sin^2) above 0.995.
 * Source: M22 Eq. 9, 14 without their cancellation: zh_l = M_l 2 pi s^2 P_l'(alpha) / (l(l+1)). */
SH_API int SHI_FN(sh_zonal_cap)(int bands, SHI_T sin_half_angle, SHI_T *zh, SHI_T *dzh)
{
    SHI_T f[SH_MAX_BANDS], legendre[SH_MAX_BANDS], slopes[SH_MAX_BANDS];
    const SHI_T s = sin_half_angle;
    int l;
    if (bands < 1 || bands > SH_MAX_BANDS) return SH_ERROR_BANDS;
    if (shi_overlap(zh, (size_t)bands * sizeof *zh, dzh, (size_t)bands * sizeof *dzh)) return SH_ERROR_OVERLAP;
    if (!SHI_FN(shi_finite)(&s, 1)) return SH_ERROR_NOT_FINITE;
    if (!(s >= 0 && s <= 1)) return SH_ERROR_RADIUS;
    SHI_FN(shi_cap)(bands, s, SHI_LIBM(sqrt)((SHI_C(1) - s) * (SHI_C(1) + s)), f, legendre, slopes);
    for (l = 0; l < bands; l++) {
        if (zh) zh[l] = SHI_FN(shi_zonal)[l] * f[l];
        if (dzh) dzh[l] = SHI_FN(shi_zonal)[l] * (SHI_C(SHI_TAU) * legendre[l] * s);
    }
    return SH_OK;
}

/* Coefficients of a zonal function about any axis: coeffs_lm = sqrt(4 pi/(2l+1)) zh_l Y_lm(dir).
 *   zh      [bands]
 *   dir     as in sh_eval
 *   coeffs  [N]
 * Error:  that of sh_eval times |zh_l|/M_l.
 * Source: M22 Eq. 11. */
SH_API int SHI_FN(sh_zonal_rotate)(int bands, const SHI_T *zh, const SHI_T dir[3], SHI_T *coeffs)
{
    int status = SHI_FN(shi_check_basis)(bands, 1, dir, coeffs, coeffs, NULL, NULL), l, m;
    if (!status && !zh) status = SH_ERROR_NULL;
    if (!status && shi_overlap(zh, (size_t)bands * sizeof *zh, coeffs, (size_t)(bands * bands) * sizeof *zh))
        status = SH_ERROR_OVERLAP;
    if (!status) status = SHI_FN(sh_eval)(bands, dir, coeffs);
    if (status) return status;
    for (l = 0; l < bands; l++) {
        const SHI_T f = zh[l] / SHI_FN(shi_zonal)[l];
        for (m = -l; m <= l; m++) coeffs[l * (l + 1) + m] *= f;
    }
    return SH_OK;
}

/* Coefficients of any circularly symmetric light, its profile given, and their derivatives by the shading point.
 *   to_light  center - point, length d
 *   zh        [bands]: zonal harmonics of the light as seen from distance d
 *   dzh       [bands]: their derivative by d; needed for grad and hess
 *   ddzh      [bands]: second derivative; needed for hess
 *   coeffs    [N];  grad [3][N] or NULL;  hess [6][N] or NULL
 * Error:  that of sh_eval_grad and sh_eval_hessian times the profile.
 * Source: M22 Eq. 11, 12; Hessian by differentiating once more. */
SH_API int SHI_FN(sh_zonal_light)(int bands, const SHI_T to_light[3], const SHI_T *zh, const SHI_T *dzh, const SHI_T *ddzh,
                                  SHI_T *coeffs, SHI_T *grad, SHI_T *hess)
{
    SHI_T f[3][SH_MAX_BANDS];
    const int status = SHI_FN(shi_check_basis)(bands, 1, to_light, coeffs, coeffs, grad, hess);
    int l;
    if (status) return status;
    if (!zh || ((grad || hess) && !dzh) || (hess && !ddzh)) return SH_ERROR_NULL;
    for (l = 0; l < 3; l++) {
        const SHI_T *const in = l == 0 ? zh : l == 1 ? dzh : ddzh;
        const size_t size = (size_t)(bands * bands) * sizeof *in, read = (size_t)bands * sizeof *in;
        if (shi_overlap(in, read, coeffs, size) || shi_overlap(in, read, grad, 3 * size) || shi_overlap(in, read, hess, 6 * size))
            return SH_ERROR_OVERLAP;
    }
    for (l = 0; l < bands; l++) {
        const SHI_T k = SHI_C(1) / SHI_FN(shi_zonal)[l];
        f[0][l] = k * zh[l];
        f[1][l] = grad || hess ? k * dzh[l] : 0;
        f[2][l] = hess ? k * ddzh[l] : 0;
    }
    return SHI_FN(shi_symmetric)(bands, to_light, f[0], f[1], f[2], coeffs, grad, hess);
}

/* ---- spherical lights ---- */

/* Coefficients of a spherical light of unit radiance, their gradient and Hessian by the shading point.
 *   point, center  finite; distance 1e-18..1e18 (double 1e-150..1e150)
 *   radius         >= 0; 0 gives zeros
 *   coeffs         [N];  grad [3][N] or NULL;  hess [6][N] or NULL
 * A point on or inside the sphere sees light everywhere: L_00 = 2 sqrt(pi), the rest 0, status SH_INSIDE.
 * Error:  |coeffs - exact| <= 24 eps M_l Omega, |grad - exact| <= 32 eps (M_l |grad Omega| + G_l Omega/d),
 *         |hess - exact| <= 64 eps (M_l (|Omega''| + |Omega'|/d) + 2 G_l |Omega'|/d) + (16 + l(l+1)/2) l(l+1) eps M_l Omega/d^2;
 *         all x 1/(1 - (r/d)^2) above r/d = 0.995. Omega(d) = 2 pi (1 - sqrt(1 - (r/d)^2)), ' = d/dd.
 *         In float the first is up to 1.1 times as much at l = 31, near the equator.
 * Source: M22 Eq. 9-16 in a form without cancellation, for every r/d. */
SH_API int SHI_FN(sh_sphere_hessian)(int bands, const SHI_T point[3], const SHI_T center[3], SHI_T radius,
                                     SHI_T *coeffs, SHI_T *grad, SHI_T *hess)
{
    int status = SHI_FN(shi_check_basis)(bands, 1, point, center, coeffs, grad, hess);
    if (!status) status = SHI_FN(shi_check_basis)(bands, 1, center, coeffs, coeffs, grad, hess);
    if (status) return status;
    return SHI_FN(shi_sphere)(bands, point, center, radius, coeffs, grad, hess);
}

/* sh_sphere_hessian without the Hessian. */
SH_API int SHI_FN(sh_sphere)(int bands, const SHI_T point[3], const SHI_T center[3], SHI_T radius, SHI_T *coeffs, SHI_T *grad)
{
    return SHI_FN(sh_sphere_hessian)(bands, point, center, radius, coeffs, grad, NULL);
}

/* Sums of many spherical lights at many points.
 *   bands     1..32
 *   planes    SH_VALUES, SH_GRADIENT or SH_HESSIAN
 *   channels  >= 1
 *   point     [points][3]
 *   spheres   [4][count]: every x, then every y, z, and radius >= 0; count 0 gives zeros
 *   radiance  [channels][count] of either sign, or NULL: 1
 *   out       [points][channels][planes][N]; for one channel and SH_GRADIENT: values, d/dx, d/dy, d/dz
 * Status SH_INSIDE when a point is on or inside a light, which then adds 2 sqrt(pi) to L_00 and nothing to derivatives.
 * A light that is not valid is an error before anything is written; a point that is not finite, or further from a light or nearer
 * to it than sh_sphere allows (SH_ERROR_DIRECTION), is an error of its own outputs.
 * Stack:  130 KiB in float with AVX-512, 145 in double; with Hessians of 32 bands 175 and 230 (docs/architecture.md).
 * Error:  the sum over the lights of sh_sphere_hessian's bounds, plus (min(count, 128)/2 + count/256) eps of the sum of
 *         magnitudes.
 * Source: M22 Eq. 12 in moment form: d/dx_k of f(d) Y_l is a fixed sparse combination of (f' + (l+1)f/d) Y_{l-1} and
 *         (f' - l f/d) Y_{l+1}, so lights share three running sums, and six with Hessians; M22 5.1's reverse order. */
SH_API int SHI_FN(sh_spheres_n)(int bands, int planes, int channels, size_t points, const SHI_T *point,
                                size_t count, const SHI_T *spheres, const SHI_T *radiance, SHI_T *out)
{
    const SHI_FN(shi_lights) o = { bands, planes, channels, { points, 0, point, NULL }, count, spheres, radiance };
    return SHI_FN(shi_spheres)(&o, out);
}

/* One point: out[channels][planes][N]. */
SH_API int SHI_FN(sh_spheres)(int bands, int planes, int channels, const SHI_T point[3],
                              size_t count, const SHI_T *spheres, const SHI_T *radiance, SHI_T *out)
{
    return SHI_FN(sh_spheres_n)(bands, planes, channels, 1, point, count, spheres, radiance, out);
}

/* Nodes first .. first+nodes-1 of a grid (x fastest): out[nodes][channels][planes][N] holds those nodes only, so a
 * job system gives each job a range. A range beyond the grid is SH_ERROR_COUNT; the rest as sh_spheres_n. */
SH_API int SHI_FN(sh_spheres_grid)(int bands, int planes, int channels, const SHI_FN(sh_grid) *grid, size_t first,
                                   size_t nodes, size_t count, const SHI_T *spheres, const SHI_T *radiance, SHI_T *out)
{
    const SHI_FN(shi_lights) o = { bands, planes, channels, { nodes, first, NULL, grid }, count, spheres, radiance };
    return SHI_FN(shi_spheres)(&o, out);
}

/* ================================================================================================================
 * Tables and types: once per precision.
 * ============================================================================================================= */
#elif SHI_ROOM == SHI_TABLES

/* Nodes at origin + (i, j, k) cell, x fastest. A count of 1 makes the field constant along that axis. */
typedef struct SHI_FN(sh_grid) {
    SHI_T origin[3];
    SHI_T cell[3];
    int   count[3];
} SHI_FN(sh_grid);

/* no NaN or infinity among v[count]; looks at exponent bits, so that -ffast-math cannot remove it */
SHI_INLINE int SHI_FN(shi_finite)(const SHI_T *v, size_t count)
{
    const SHI_T limit = SHI_BITS == 32 ? SHI_C(3.4028234663852886e38) : SHI_C(1.7976931348623157e308 * (SHI_BITS == 64));
    SHI_I most, bits;
    size_t i;
    memcpy(&most, &limit, sizeof most);
    for (i = 0; i < count; i++) {
        memcpy(&bits, v + i, sizeof bits);
        bits &= (SHI_I)(((unsigned long long)1 << (SHI_BITS - 1)) - 1);
        if (bits > most) return 0;
    }
    return 1;
}

SHI_INLINE int SHI_FN(shi_is_nan)(SHI_T v)
{
    SHI_I bits, infinity = SHI_BITS == 32 ? (SHI_I)0x7f800000 : (SHI_I)(0x7ff00000LL << (SHI_BITS == 64 ? 32 : 0));
    memcpy(&bits, &v, sizeof bits);
    return (bits & (SHI_I)(((unsigned long long)1 << (SHI_BITS - 1)) - 1)) > infinity;
}

/* why a direction was refused */
SHI_INLINE int SHI_FN(shi_direction_status)(const SHI_T v[3])
{
    return SHI_FN(shi_finite)(v, 3) ? SH_ERROR_DIRECTION : SH_ERROR_NOT_FINITE;
}

SHI_NOINLINE int SHI_FN(shi_one_by_one)(int n, int planes, size_t count, const SHI_T *dirs, int axis, int next,
                                        SHI_T *y, int ys, int y_next, SHI_T *g, int gs, int g_next, SHI_T *h, int hs, int h_next);

/* BEGIN tools/gen_gradient.py */
/* [l(l+1)/2 + m]: monic q_l = z q_{l-1} - beta q_{l-2} */
static const SHI_T SHI_FN(shi_beta)[595] = {
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.3333333333333333), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.26666666666666666), SHI_C(0.2), SHI_C(0.0), SHI_C(0.0), SHI_C(0.2571428571428571),
    SHI_C(0.22857142857142856), SHI_C(0.14285714285714285), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.25396825396825395), SHI_C(0.23809523809523808), SHI_C(0.19047619047619047),
    SHI_C(0.1111111111111111), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25252525252525254),
    SHI_C(0.24242424242424243), SHI_C(0.21212121212121213), SHI_C(0.16161616161616163),
    SHI_C(0.09090909090909091), SHI_C(0.0), SHI_C(0.0), SHI_C(0.2517482517482518),
    SHI_C(0.24475524475524477), SHI_C(0.22377622377622378), SHI_C(0.1888111888111888),
    SHI_C(0.13986013986013987), SHI_C(0.07692307692307693), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.2512820512820513), SHI_C(0.24615384615384617), SHI_C(0.23076923076923078),
    SHI_C(0.20512820512820512), SHI_C(0.16923076923076924), SHI_C(0.12307692307692308),
    SHI_C(0.06666666666666667), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25098039215686274),
    SHI_C(0.24705882352941178), SHI_C(0.23529411764705882), SHI_C(0.21568627450980393),
    SHI_C(0.18823529411764706), SHI_C(0.15294117647058825), SHI_C(0.10980392156862745),
    SHI_C(0.058823529411764705), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25077399380804954),
    SHI_C(0.2476780185758514), SHI_C(0.23839009287925697), SHI_C(0.22291021671826625),
    SHI_C(0.20123839009287925), SHI_C(0.17337461300309598), SHI_C(0.1393188854489164),
    SHI_C(0.09907120743034056), SHI_C(0.05263157894736842), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.2506265664160401), SHI_C(0.24812030075187969), SHI_C(0.24060150375939848),
    SHI_C(0.22807017543859648), SHI_C(0.21052631578947367), SHI_C(0.18796992481203006),
    SHI_C(0.16040100250626566), SHI_C(0.12781954887218044), SHI_C(0.09022556390977443),
    SHI_C(0.047619047619047616), SHI_C(0.0), SHI_C(0.0), SHI_C(0.2505175983436853),
    SHI_C(0.2484472049689441), SHI_C(0.2422360248447205), SHI_C(0.2318840579710145),
    SHI_C(0.21739130434782608), SHI_C(0.19875776397515527), SHI_C(0.17598343685300208),
    SHI_C(0.14906832298136646), SHI_C(0.11801242236024845), SHI_C(0.08281573498964803),
    SHI_C(0.043478260869565216), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25043478260869567),
    SHI_C(0.24869565217391304), SHI_C(0.24347826086956523), SHI_C(0.23478260869565218),
    SHI_C(0.22260869565217392), SHI_C(0.20695652173913043), SHI_C(0.18782608695652173),
    SHI_C(0.16521739130434782), SHI_C(0.1391304347826087), SHI_C(0.10956521739130434),
    SHI_C(0.07652173913043478), SHI_C(0.04), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25037037037037035),
    SHI_C(0.24888888888888888), SHI_C(0.24444444444444444), SHI_C(0.23703703703703705),
    SHI_C(0.22666666666666666), SHI_C(0.21333333333333335), SHI_C(0.19703703703703704),
    SHI_C(0.17777777777777778), SHI_C(0.15555555555555556), SHI_C(0.13037037037037036),
    SHI_C(0.10222222222222223), SHI_C(0.07111111111111111), SHI_C(0.037037037037037035), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.2503192848020434), SHI_C(0.24904214559386972), SHI_C(0.24521072796934865),
    SHI_C(0.2388250319284802), SHI_C(0.22988505747126436), SHI_C(0.21839080459770116),
    SHI_C(0.20434227330779056), SHI_C(0.18773946360153257), SHI_C(0.1685823754789272),
    SHI_C(0.14687100893997446), SHI_C(0.12260536398467432), SHI_C(0.09578544061302682),
    SHI_C(0.06641123882503193), SHI_C(0.034482758620689655), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.25027808676307006), SHI_C(0.24916573971078976), SHI_C(0.24582869855394884),
    SHI_C(0.24026696329254726), SHI_C(0.2324805339265851), SHI_C(0.22246941045606228),
    SHI_C(0.21023359288097887), SHI_C(0.19577308120133483), SHI_C(0.17908787541713014),
    SHI_C(0.16017797552836485), SHI_C(0.13904338153503892), SHI_C(0.11568409343715239),
    SHI_C(0.09010011123470522), SHI_C(0.06229143492769744), SHI_C(0.03225806451612903), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.25024437927663734), SHI_C(0.24926686217008798), SHI_C(0.24633431085043989),
    SHI_C(0.24144672531769307), SHI_C(0.23460410557184752), SHI_C(0.22580645161290322),
    SHI_C(0.21505376344086022), SHI_C(0.20234604105571846), SHI_C(0.187683284457478),
    SHI_C(0.1710654936461388), SHI_C(0.15249266862170088), SHI_C(0.13196480938416422),
    SHI_C(0.10948191593352884), SHI_C(0.08504398826979472), SHI_C(0.05865102639296188),
    SHI_C(0.030303030303030304), SHI_C(0.0), SHI_C(0.0), SHI_C(0.2502164502164502),
    SHI_C(0.24935064935064935), SHI_C(0.24675324675324675), SHI_C(0.24242424242424243),
    SHI_C(0.23636363636363636), SHI_C(0.22857142857142856), SHI_C(0.21904761904761905),
    SHI_C(0.2077922077922078), SHI_C(0.19480519480519481), SHI_C(0.1800865800865801),
    SHI_C(0.16363636363636364), SHI_C(0.14545454545454545), SHI_C(0.12554112554112554),
    SHI_C(0.1038961038961039), SHI_C(0.08051948051948052), SHI_C(0.05541125541125541),
    SHI_C(0.02857142857142857), SHI_C(0.0), SHI_C(0.0), SHI_C(0.2501930501930502),
    SHI_C(0.2494208494208494), SHI_C(0.2471042471042471), SHI_C(0.24324324324324326),
    SHI_C(0.23783783783783785), SHI_C(0.2308880308880309), SHI_C(0.22239382239382238),
    SHI_C(0.21235521235521235), SHI_C(0.20077220077220076), SHI_C(0.18764478764478765),
    SHI_C(0.17297297297297298), SHI_C(0.15675675675675677), SHI_C(0.138996138996139),
    SHI_C(0.11969111969111969), SHI_C(0.09884169884169884), SHI_C(0.07644787644787644),
    SHI_C(0.05250965250965251), SHI_C(0.02702702702702703), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.25017325017325015), SHI_C(0.2494802494802495), SHI_C(0.24740124740124741),
    SHI_C(0.24393624393624394), SHI_C(0.2390852390852391), SHI_C(0.23284823284823286),
    SHI_C(0.22522522522522523), SHI_C(0.21621621621621623), SHI_C(0.20582120582120583),
    SHI_C(0.19404019404019404), SHI_C(0.18087318087318088), SHI_C(0.16632016632016633),
    SHI_C(0.15038115038115038), SHI_C(0.13305613305613306), SHI_C(0.11434511434511435),
    SHI_C(0.09424809424809424), SHI_C(0.07276507276507277), SHI_C(0.0498960498960499),
    SHI_C(0.02564102564102564), SHI_C(0.0), SHI_C(0.0), SHI_C(0.2501563477173233), SHI_C(0.24953095684803),
    SHI_C(0.24765478424015008), SHI_C(0.24452782989368355), SHI_C(0.2401500938086304),
    SHI_C(0.23452157598499063), SHI_C(0.22764227642276422), SHI_C(0.21951219512195122),
    SHI_C(0.2101313320825516), SHI_C(0.19949968730456535), SHI_C(0.18761726078799248),
    SHI_C(0.17448405253283303), SHI_C(0.16010006253908693), SHI_C(0.14446529080675422),
    SHI_C(0.1275797373358349), SHI_C(0.10944340212632896), SHI_C(0.0900562851782364),
    SHI_C(0.06941838649155722), SHI_C(0.047529706066291436), SHI_C(0.024390243902439025), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.25014180374361883), SHI_C(0.2495745887691435), SHI_C(0.24787294384571754),
    SHI_C(0.2450368689733409), SHI_C(0.2410663641520136), SHI_C(0.23596142938173567),
    SHI_C(0.22972206466250708), SHI_C(0.22234826999432786), SHI_C(0.21384004537719795),
    SHI_C(0.2041973908111174), SHI_C(0.19342030629608623), SHI_C(0.18150879183210436),
    SHI_C(0.16846284741917186), SHI_C(0.1542824730572887), SHI_C(0.13896766874645491),
    SHI_C(0.12251843448667045), SHI_C(0.10493477027793534), SHI_C(0.08621667612024958),
    SHI_C(0.06636415201361316), SHI_C(0.04537719795802609), SHI_C(0.023255813953488372), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.2501291989664083), SHI_C(0.2496124031007752), SHI_C(0.24806201550387597),
    SHI_C(0.2454780361757106), SHI_C(0.24186046511627907), SHI_C(0.2372093023255814),
    SHI_C(0.23152454780361756), SHI_C(0.2248062015503876), SHI_C(0.21705426356589147),
    SHI_C(0.2082687338501292), SHI_C(0.19844961240310077), SHI_C(0.1875968992248062),
    SHI_C(0.17571059431524547), SHI_C(0.16279069767441862), SHI_C(0.14883720930232558),
    SHI_C(0.1338501291989664), SHI_C(0.11782945736434108), SHI_C(0.10077519379844961),
    SHI_C(0.082687338501292), SHI_C(0.06356589147286822), SHI_C(0.043410852713178294),
    SHI_C(0.022222222222222223), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25011820330969264),
    SHI_C(0.24964539007092199), SHI_C(0.24822695035460993), SHI_C(0.2458628841607565),
    SHI_C(0.2425531914893617), SHI_C(0.23829787234042554), SHI_C(0.233096926713948),
    SHI_C(0.22695035460992907), SHI_C(0.2198581560283688), SHI_C(0.21182033096926714),
    SHI_C(0.2028368794326241), SHI_C(0.19290780141843972), SHI_C(0.18203309692671396),
    SHI_C(0.1702127659574468), SHI_C(0.1574468085106383), SHI_C(0.14373522458628843),
    SHI_C(0.12907801418439716), SHI_C(0.11347517730496454), SHI_C(0.09692671394799054),
    SHI_C(0.07943262411347518), SHI_C(0.06099290780141844), SHI_C(0.04160756501182033),
    SHI_C(0.02127659574468085), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25010855405992183),
    SHI_C(0.2496743378202345), SHI_C(0.24837168910117238), SHI_C(0.24620060790273557),
    SHI_C(0.24316109422492402), SHI_C(0.23925314806773773), SHI_C(0.23447676943117673),
    SHI_C(0.228831958315241), SHI_C(0.22231871471993053), SHI_C(0.21493703864524533),
    SHI_C(0.2066869300911854), SHI_C(0.19756838905775076), SHI_C(0.18758141554494137),
    SHI_C(0.17672600955275727), SHI_C(0.16500217108119844), SHI_C(0.15240990013026487),
    SHI_C(0.1389491966999566), SHI_C(0.12462006079027356), SHI_C(0.1094224924012158),
    SHI_C(0.09335649153278333), SHI_C(0.07642205818497612), SHI_C(0.058619192357794184),
    SHI_C(0.03994789405123752), SHI_C(0.02040816326530612), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.2501000400160064), SHI_C(0.24969987995198079), SHI_C(0.24849939975990396),
    SHI_C(0.24649859943977592), SHI_C(0.24369747899159663), SHI_C(0.24009603841536614),
    SHI_C(0.23569427771108442), SHI_C(0.2304921968787515), SHI_C(0.22448979591836735),
    SHI_C(0.21768707482993196), SHI_C(0.21008403361344538), SHI_C(0.20168067226890757),
    SHI_C(0.19247699079631853), SHI_C(0.18247298919567828), SHI_C(0.1716686674669868),
    SHI_C(0.1600640256102441), SHI_C(0.14765906362545017), SHI_C(0.13445378151260504),
    SHI_C(0.12044817927170869), SHI_C(0.1056422569027611), SHI_C(0.09003601440576231),
    SHI_C(0.07362945178071229), SHI_C(0.056422569027611044), SHI_C(0.03841536614645858),
    SHI_C(0.0196078431372549), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25009248982611915),
    SHI_C(0.24972253052164262), SHI_C(0.2486126526082131), SHI_C(0.24676285608583057),
    SHI_C(0.244173140954495), SHI_C(0.24084350721420644), SHI_C(0.23677395486496486),
    SHI_C(0.23196448390677027), SHI_C(0.22641509433962265), SHI_C(0.22012578616352202),
    SHI_C(0.21309655937846836), SHI_C(0.20532741398446172), SHI_C(0.19681834998150202),
    SHI_C(0.18756936736958935), SHI_C(0.17758046614872364), SHI_C(0.16685164631890492),
    SHI_C(0.15538290788013318), SHI_C(0.14317425083240842), SHI_C(0.13022567517573067),
    SHI_C(0.11653718091009989), SHI_C(0.10210876803551609), SHI_C(0.08694043655197928),
    SHI_C(0.07103218645948946), SHI_C(0.05438401775804662), SHI_C(0.03699593044765076),
    SHI_C(0.018867924528301886), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25008576329331045),
    SHI_C(0.2497427101200686), SHI_C(0.24871355060034306), SHI_C(0.2469982847341338),
    SHI_C(0.24459691252144083), SHI_C(0.24150943396226415), SHI_C(0.23773584905660378),
    SHI_C(0.2332761578044597), SHI_C(0.2281303602058319), SHI_C(0.22229845626072042),
    SHI_C(0.2157804459691252), SHI_C(0.2085763293310463), SHI_C(0.2006861063464837),
    SHI_C(0.19210977701543738), SHI_C(0.18284734133790737), SHI_C(0.17289879931389365),
    SHI_C(0.16226415094339622), SHI_C(0.1509433962264151), SHI_C(0.13893653516295026),
    SHI_C(0.12624356775300172), SHI_C(0.11286449399656946), SHI_C(0.09879931389365351),
    SHI_C(0.08404802744425385), SHI_C(0.0686106346483705), SHI_C(0.05248713550600343),
    SHI_C(0.03567753001715266), SHI_C(0.01818181818181818), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.2500797448165869), SHI_C(0.24976076555023924), SHI_C(0.24880382775119617),
    SHI_C(0.24720893141945774), SHI_C(0.24497607655502393), SHI_C(0.24210526315789474),
    SHI_C(0.23859649122807017), SHI_C(0.23444976076555024), SHI_C(0.22966507177033493),
    SHI_C(0.22424242424242424), SHI_C(0.21818181818181817), SHI_C(0.21148325358851675),
    SHI_C(0.20414673046251994), SHI_C(0.19617224880382775), SHI_C(0.1875598086124402),
    SHI_C(0.17830940988835725), SHI_C(0.16842105263157894), SHI_C(0.15789473684210525),
    SHI_C(0.1467304625199362), SHI_C(0.13492822966507176), SHI_C(0.12248803827751197),
    SHI_C(0.10940988835725678), SHI_C(0.09569377990430622), SHI_C(0.08133971291866028),
    SHI_C(0.06634768740031897), SHI_C(0.05071770334928229), SHI_C(0.03444976076555024),
    SHI_C(0.017543859649122806), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25007433838834375),
    SHI_C(0.24977698483496877), SHI_C(0.2488849241748439), SHI_C(0.24739815640796908),
    SHI_C(0.24531668153434433), SHI_C(0.24264049955396966), SHI_C(0.23936961046684507),
    SHI_C(0.23550401427297057), SHI_C(0.2310437109723461), SHI_C(0.22598870056497175),
    SHI_C(0.22033898305084745), SHI_C(0.21409455842997324), SHI_C(0.2072554267023491),
    SHI_C(0.19982158786797502), SHI_C(0.19179304192685104), SHI_C(0.1831697888789771),
    SHI_C(0.17395182872435325), SHI_C(0.1641391614629795), SHI_C(0.15373178709485577),
    SHI_C(0.14272970561998216), SHI_C(0.1311329170383586), SHI_C(0.11894142134998513),
    SHI_C(0.10615521855486174), SHI_C(0.0927743086529884), SHI_C(0.07879869164436515),
    SHI_C(0.06422836752899197), SHI_C(0.04906333630686887), SHI_C(0.033303597977995834),
    SHI_C(0.01694915254237288), SHI_C(0.0), SHI_C(0.0), SHI_C(0.2500694637399278),
    SHI_C(0.24979160878021672), SHI_C(0.24895804390108364), SHI_C(0.24756876910252848),
    SHI_C(0.24562378438455126), SHI_C(0.243123089747152), SHI_C(0.24006668519033064),
    SHI_C(0.23645457071408724), SHI_C(0.23228674631842178), SHI_C(0.22756321200333426),
    SHI_C(0.22228396776882467), SHI_C(0.21644901361489302), SHI_C(0.21005834954153932),
    SHI_C(0.20311197554876353), SHI_C(0.19560989163656572), SHI_C(0.1875520978049458),
    SHI_C(0.17893859405390386), SHI_C(0.16976938038343983), SHI_C(0.16004445679355375),
    SHI_C(0.14976382328424562), SHI_C(0.13892747985551543), SHI_C(0.12753542650736316),
    SHI_C(0.11558766323978883), SHI_C(0.10308419005279244), SHI_C(0.090025006946374),
    SHI_C(0.07641011392053348), SHI_C(0.06223951097527091), SHI_C(0.047513198110586276),
    SHI_C(0.03223117532647958), SHI_C(0.01639344262295082), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.25006505334374185), SHI_C(0.2498048399687744), SHI_C(0.24902419984387197),
    SHI_C(0.24772313296903462), SHI_C(0.2459016393442623), SHI_C(0.24355971896955503),
    SHI_C(0.24069737184491283), SHI_C(0.2373145979703357), SHI_C(0.23341139734582358),
    SHI_C(0.22898776997137654), SHI_C(0.22404371584699453), SHI_C(0.2185792349726776),
    SHI_C(0.2125943273484257), SHI_C(0.20608899297423888), SHI_C(0.1990632318501171),
    SHI_C(0.19151704397606037), SHI_C(0.1834504293520687), SHI_C(0.17486338797814208),
    SHI_C(0.1657559198542805), SHI_C(0.156128024980484), SHI_C(0.14597970335675253),
    SHI_C(0.13531095498308612), SHI_C(0.12412177985948478), SHI_C(0.11241217798594848),
    SHI_C(0.10018214936247723), SHI_C(0.08743169398907104), SHI_C(0.0741608118657299),
    SHI_C(0.06036950299245381), SHI_C(0.04605776736924278), SHI_C(0.0312256049960968),
    SHI_C(0.015873015873015872), SHI_C(0.0), SHI_C(0.0), SHI_C(0.25006105006105006),
    SHI_C(0.24981684981684982), SHI_C(0.2490842490842491), SHI_C(0.24786324786324787),
    SHI_C(0.24615384615384617), SHI_C(0.24395604395604395), SHI_C(0.24126984126984127),
    SHI_C(0.23809523809523808), SHI_C(0.23443223443223443), SHI_C(0.23028083028083027),
    SHI_C(0.22564102564102564), SHI_C(0.2205128205128205), SHI_C(0.2148962148962149),
    SHI_C(0.2087912087912088), SHI_C(0.2021978021978022), SHI_C(0.19511599511599512),
    SHI_C(0.18754578754578755), SHI_C(0.1794871794871795), SHI_C(0.17094017094017094),
    SHI_C(0.1619047619047619), SHI_C(0.1523809523809524), SHI_C(0.14236874236874236),
    SHI_C(0.13186813186813187), SHI_C(0.12087912087912088), SHI_C(0.1094017094017094),
    SHI_C(0.09743589743589744), SHI_C(0.08498168498168499), SHI_C(0.07203907203907203),
    SHI_C(0.05860805860805861), SHI_C(0.04468864468864469), SHI_C(0.03028083028083028),
    SHI_C(0.015384615384615385), SHI_C(0.0), SHI_C(0.0)
};
/* [l(l+1)/2 + m]: times monic q_l^m it is the normalised one */
static const SHI_T SHI_FN(shi_norm)[595] = {
    SHI_C(0.28209479177387814), SHI_C(0.4886025119029199), SHI_C(0.4886025119029199),
    SHI_C(0.94617469575756), SHI_C(1.0925484305920792), SHI_C(0.5462742152960396), SHI_C(1.865881662950577),
    SHI_C(2.2852289973223288), SHI_C(1.4453057213202771), SHI_C(0.5900435899266435),
    SHI_C(3.7024941420321507), SHI_C(4.683325804901024), SHI_C(3.3116114351514603),
    SHI_C(1.7701307697799304), SHI_C(0.6258357354491761), SHI_C(7.367870314565686),
    SHI_C(9.511879675109636), SHI_C(7.190305177459986), SHI_C(4.403144694917254), SHI_C(2.075662314881041),
    SHI_C(0.6563820568401701), SHI_C(14.684485723822167), SHI_C(19.226504963118135),
    SHI_C(15.199886781996238), SHI_C(10.133257854664159), SHI_C(5.550213908015966),
    SHI_C(2.366619162231752), SHI_C(0.6831841051919143), SHI_C(29.29395479525012), SHI_C(38.75225965289993),
    SHI_C(31.64108750981626), SHI_C(22.373627542308046), SHI_C(13.491805046726768),
    SHI_C(6.745902523363384), SHI_C(2.6459606618019), SHI_C(0.7071627325245962), SHI_C(58.47336811322075),
    SHI_C(77.96449081762766), SHI_C(65.22977295619205), SHI_C(48.17538005652622), SHI_C(31.097074109356495),
    SHI_C(17.24955311049054), SHI_C(7.9849914908931385), SHI_C(2.9157066406993195),
    SHI_C(0.7289266601748299), SHI_C(116.76612339861902), SHI_C(156.65819363306454),
    SHI_C(133.59855642218116), SHI_C(102.03758292357897), SHI_C(69.32088705839595),
    SHI_C(41.427153718316575), SHI_C(21.392890190908638), SHI_C(9.263393182848905),
    SHI_C(3.1773176489546975), SHI_C(0.7489009518531883), SHI_C(233.2401488132579),
    SHI_C(314.50095250160916), SHI_C(272.3658143807966), SHI_C(213.66132344050345),
    SHI_C(151.08137068207222), SHI_C(95.552248675107), SHI_C(53.41533086012586), SHI_C(25.910241313366303),
    SHI_C(10.577811721687949), SHI_C(3.4318952998917145), SHI_C(0.76739511822199), SHI_C(465.9981473192521),
    SHI_C(630.9644742184684), SHI_C(553.3924520111509), SHI_C(443.7010619683857), SHI_C(324.0334405721099),
    SHI_C(214.32797505560748), SHI_C(127.3297907354854), SHI_C(67.10869211945669),
    SHI_C(30.791579703357485), SHI_C(11.925527539452185), SHI_C(3.680297698805311),
    SHI_C(0.7846421057871968), SHI_C(931.1869186329141), SHI_C(1265.2338749567052),
    SHI_C(1121.5099624332224), SHI_C(915.7090498031087), SHI_C(686.7817873523314), SHI_C(471.1284193302729),
    SHI_C(293.8001883843744), SHI_C(165.10145272850033), SHI_C(82.55072636425017), SHI_C(36.02809068931077),
    SHI_C(13.304254200257635), SHI_C(3.9232105289359844), SHI_C(0.8008219957839717),
    SHI_C(1860.9958320181306), SHI_C(2536.1098254794856), SHI_C(2268.3655872709032),
    SHI_C(1880.8293850829407), SHI_C(1442.5302883539441), SHI_C(1020.0229489620598),
    SHI_C(661.8782894664664), SHI_C(391.5724767185117), SHI_C(209.30429285302665), SHI_C(99.78190650193226),
    SHI_C(41.611931535496446), SHI_C(14.712039483509942), SHI_C(4.161193153549645),
    SHI_C(0.8160771188376283), SHI_C(3719.6171874538936), SHI_C(5081.964558407622),
    SHI_C(4580.8209488573475), SHI_C(3848.6594059099402), SHI_C(3008.635455278777),
    SHI_C(2182.693568043675), SHI_C(1464.195357659166), SHI_C(903.7209947430105), SHI_C(509.76739144504444),
    SHI_C(260.3656926812673), SHI_C(118.84013590165654), SHI_C(47.53605436066261),
    SHI_C(16.147194793928204), SHI_C(4.394709780272119), SHI_C(0.830522083064524), SHI_C(7435.100318253493),
    SHI_C(10180.930404053195), SHI_C(9239.043795985812), SHI_C(7851.6774337783345),
    SHI_C(6239.880490966099), SHI_C(4627.619225676053), SHI_C(3193.3606493895777),
    SHI_C(2042.4803340950257), SHI_C(1204.5891834675137), SHI_C(650.5525121799841),
    SHI_C(318.7043411453399), SHI_C(139.76109909474178), SHI_C(53.794072123058086),
    SHI_C(17.60824338884482), SHI_C(4.624151256630012), SHI_C(0.8442506508573726), SHI_C(14862.9380228203),
    SHI_C(20391.782735795834), SHI_C(18615.06565356631), SHI_C(15979.08068301569),
    SHI_C(12882.746704733094), SHI_C(9738.441138331606), SHI_C(6886.117767100319), SHI_C(4540.571593129748),
    SHI_C(2780.5208859359977), SHI_C(1572.9001389409368), SHI_C(816.1378072162844),
    SHI_C(384.7310519102359), SHI_C(162.57854272405683), SHI_C(60.38015494295202), SHI_C(19.09388150936025),
    SHI_C(4.849850753230681), SHI_C(0.8573405888380251), SHI_C(29713.016051075683),
    SHI_C(40836.63454475266), SHI_C(37474.26593155346), SHI_C(32453.666284899024),
    SHI_C(26498.307560189467), SHI_C(20369.411052992633), SHI_C(14713.133558815287),
    SHI_C(9960.838507029463), SHI_C(6299.787417464844), SHI_C(3706.4698815161005),
    SHI_C(2017.5466570463266), SHI_C(1008.7733285231633), SHI_C(458.8494520607931),
    SHI_C(187.32450438409904), SHI_C(67.28894837384405), SHI_C(20.602948605549727), SHI_C(5.07209532485536),
    SHI_C(0.8698571719206281), SHI_C(59403.100967937695), SHI_C(81768.03601647902),
    SHI_C(75386.40432394543), SHI_C(65802.64841619547), SHI_C(54334.74866668553), SHI_C(42391.40026478217),
    SHI_C(31199.22582727859), SHI_C(21615.45771586466), SHI_C(14059.6369016055), SHI_C(8556.422534823749),
    SHI_C(4851.035601328402), SHI_C(2547.8887219438066), SHI_C(1230.7471792351603),
    SHI_C(541.4565694665139), SHI_C(214.02950169692065), SHI_C(74.515507921532), SHI_C(22.134404124649148),
    SHI_C(5.291134612069973), SHI_C(0.8818557686783288), SHI_C(118765.05692964203),
    SHI_C(163706.33347629564), SHI_C(151562.61399242262), SHI_C(133230.97533021256),
    SHI_C(111122.31502092743), SHI_C(87849.90358421799), SHI_C(65740.84813465356),
    SHI_C(46485.799516968524), SHI_C(30990.53301131235), SHI_C(19424.34453718327),
    SHI_C(11406.367863053993), SHI_C(6247.524977796668), SHI_C(3173.745862468157),
    SHI_C(1484.3837062559016), SHI_C(632.9433390407085), SHI_C(242.7226904841872), SHI_C(82.05524583274546),
    SHI_C(23.687309134978253), SHI_C(5.507187510272245), SHI_C(0.8933837843499495),
    SHI_C(237455.8740969271), SHI_C(327720.24115564727), SHI_C(304557.09815456136),
    SHI_C(269426.96587660525), SHI_C(226756.5810332238), SHI_C(181405.26482657902),
    SHI_C(137787.18981458593), SHI_C(99218.11652784846), SHI_C(67605.75060476371),
    SHI_C(43488.583590291004), SHI_C(26333.645101268587), SHI_C(14956.505374127739),
    SHI_C(7931.884779674074), SHI_C(3905.3900952254317), SHI_C(1772.0418811542065), SHI_C(733.695043138053),
    SHI_C(273.4319985352212), SHI_C(89.90388731214061), SHI_C(25.260811578777112), SHI_C(5.720447362900643),
    SHI_C(0.904482145093491), SHI_C(474777.11693723145), SHI_C(655998.8585156241), SHI_C(611722.0897659768),
    SHI_C(544283.7184106214), SHI_C(461840.04981309565), SHI_C(373447.34658177436),
    SHI_C(287479.9014361852), SHI_C(210413.7425871077), SHI_C(146197.22189128873), SHI_C(96238.79327892317),
    SHI_C(59876.987873634265), SHI_C(35105.995946656316), SHI_C(19325.214737970746),
    SHI_C(9942.74095541143), SHI_C(4753.539378043409), SHI_C(2096.113840275918), SHI_C(844.0916977914627),
    SHI_C(306.18423983137177), SHI_C(98.05743409682317), SHI_C(26.854134292953134), SHI_C(5.93108606277937),
    SHI_C(0.9151864484003309), SHI_C(949308.9660842745), SHI_C(1313015.9536742573),
    SHI_C(1228213.9605043288), SHI_C(1098547.9626407686), SHI_C(939094.180953554), SHI_C(766767.1879177),
    SHI_C(597460.1794244981), SHI_C(443782.28026221704), SHI_C(313801.45974384266),
    SHI_C(210881.3292583732), SHI_C(134411.00161760376), SHI_C(81052.88364753535), SHI_C(46102.59321001302),
    SHI_C(24642.87263338277), SHI_C(12321.436316691384), SHI_C(5729.351510990861), SHI_C(2459.023560788289),
    SHI_C(964.5083939110692), SHI_C(341.00521292293143), SHI_C(106.5121338515986), SHI_C(28.46656517192062),
    SHI_C(6.1392573321292305), SHI_C(0.9255278664595892), SHI_C(1898169.2454242075),
    SHI_C(2627896.3249829863), SHI_C(2465185.267576454), SHI_C(2215503.9926095987),
    SHI_C(1906802.2370740036), SHI_C(1570736.8681938748), SHI_C(1237487.1307427394),
    SHI_C(931546.4701025613), SHI_C(669242.7404589863), SHI_C(458199.18174495257),
    SHI_C(298442.97268182435), SHI_C(184541.2996388242), SHI_C(108056.32066772738),
    SHI_C(59730.37864686287), SHI_C(31052.34522760704), SHI_C(15112.066716796398), SHI_C(6844.418432755793),
    SHI_C(2863.225653779889), SHI_C(1095.3156006573656), SHI_C(377.91978631201584),
    SHI_C(115.26445422597175), SHI_C(30.09744901000499), SHI_C(6.345099375493046),
    SHI_C(0.9355338639199108), SHI_C(3795514.543255239), SHI_C(5259219.223827723), SHI_C(4946505.749665884),
    SHI_C(4465066.964337582), SHI_C(3866861.420715012), SHI_C(3211253.622111928), SHI_C(2555587.647261145),
    SHI_C(1947359.7345737007), SHI_C(1419370.1167822452), SHI_C(988322.4914520733),
    SHI_C(656454.8326080223), SHI_C(415178.4904131844), SHI_C(249491.22260907842),
    SHI_C(142083.95328568405), SHI_C(76445.08651625842), SHI_C(38709.47426756585),
    SHI_C(18361.515856977934), SHI_C(8110.7608685342675), SHI_C(3311.204258940312),
    SHI_C(1236.8794367611108), SHI_C(416.9519730739766), SHI_C(124.31106068614315),
    SHI_C(31.746180676387944), SHI_C(6.548737047439375), SHI_C(0.9452287742977996),
    SHI_C(7589510.728842222), SHI_C(10524757.726355655), SHI_C(9922836.744868793), SHI_C(8993334.532749241),
    SHI_C(7833089.522141664), SHI_C(6553632.887438834), SHI_C(5264004.609721966), SHI_C(4056187.9659829163),
    SHI_C(2995693.3465515845), SHI_C(2118275.0797020476), SHI_C(1432215.3570364586),
    SHI_C(924491.0376641189), SHI_C(568677.2585403997), SHI_C(332617.99318964756),
    SHI_C(184503.26609033943), SHI_C(96754.32899591993), SHI_C(47783.557176620845),
    SHI_C(22119.488836373264), SHI_C(9540.823292274505), SHI_C(3805.4720280050014),
    SHI_C(1389.5619144621803), SHI_C(458.1249964854143), SHI_C(133.64879743463587),
    SHI_C(33.41219935865897), SHI_C(6.750283640247019), SHI_C(0.9546342673902561),
    SHI_C(15176214.426415378), SHI_C(21061206.38138421), SHI_C(19900969.427196138),
    SHI_C(18104263.185697153), SHI_C(15852002.971686527), SHI_C(13354100.446408605),
    SHI_C(10818057.781708352), SHI_C(8421846.5609383), SHI_C(6295709.300841275), SHI_C(4514887.123450874),
    SHI_C(3102559.416288173), SHI_C(2040230.5043699043), SHI_C(1281837.7808569074),
    SHI_C(768006.2992204648), SHI_C(437830.95434625464), SHI_C(236867.32599088838),
    SHI_C(121220.71873660594), SHI_C(58457.8215090666), SHI_C(26438.544546428373),
    SHI_C(11147.469171538263), SHI_C(4348.569186257585), SHI_C(1553.7211598871731),
    SHI_C(501.46134807442445), SHI_C(143.274670878407), SHI_C(35.09498367172936), SHI_C(6.949842370673866),
    SHI_C(0.9637697316868012), SHI_C(30347223.943446208), SHI_C(42144104.848712), SHI_C(39904742.13932733),
    SHI_C(36427879.03522757), SHI_C(32052260.201177765), SHI_C(27173625.673672587),
    SHI_C(22187172.453963544), SHI_C(17437015.269704014), SHI_C(13181144.574535051),
    SHI_C(9575879.526766285), SHI_C(6679040.303291174), SHI_C(4467316.542166631), SHI_C(2861372.6014402728),
    SHI_C(1752225.7093771917), SHI_C(1023910.8325367919), SHI_C(569651.3994336156),
    SHI_C(300930.0545525921), SHI_C(150465.02727629605), SHI_C(70929.89407899186),
    SHI_C(31374.126998598644), SHI_C(12943.976467670509), SHI_C(4943.062663068935),
    SHI_C(1729.7116130174081), SHI_C(546.9828392378763), SHI_C(153.18583521797856),
    SHI_C(36.794047473817805), SHI_C(7.1475076260442485), SHI_C(0.9726525898033295),
    SHI_C(60684770.06686966), SHI_C(84328567.95192592), SHI_C(80001103.96450995), SHI_C(73265886.20511542),
    SHI_C(64758506.206598796), SHI_C(55226239.65346443), SHI_C(45422384.855935164),
    SHI_C(36012000.78228492), SHI_C(27504619.91860493), SHI_C(20221798.73929094), SHI_C(14298971.016342202),
    SHI_C(9714237.89622209), SHI_C(6332908.305776177), SHI_C(3956136.4552346575), SHI_C(2364243.7368636085),
    SHI_C(1349031.3343214104), SHI_C(733275.8384740645), SHI_C(378662.01474484423),
    SHI_C(185169.37813308343), SHI_C(85412.26504953545), SHI_C(36984.595663833716),
    SHI_C(14944.033367622515), SHI_C(5591.5452838161045), SHI_C(1917.8842098694597),
    SHI_C(594.7106473599805), SHI_C(163.37957981531372), SHI_C(38.50893626493904), SHI_C(7.343366016052452),
    SHI_C(0.9812985606338352), SHI_C(121351499.32499845), SHI_C(168732412.46903887),
    SHI_C(160360235.24606898), SHI_C(147300281.76957878), SHI_C(130747466.31119809),
    SHI_C(112115027.41669156), SHI_C(92840062.92597917), SHI_C(74207550.06779122), SHI_C(57221412.24520064),
    SHI_C(42537936.75434694), SHI_C(30462049.22073652), SHI_C(20994518.577360205),
    SHI_C(13910740.354227623), SHI_C(8850138.353030106), SHI_C(5398533.784331375),
    SHI_C(3152064.6383417146), SHI_C(1758137.6559680668), SHI_C(934642.7383640691),
    SHI_C(472266.7065745036), SHI_C(226080.4734826191), SHI_C(102132.74724205372),
    SHI_C(43331.254893640704), SHI_C(17161.734226813736), SHI_C(6296.635016637138),
    SHI_C(2118.5865490866017), SHI_C(644.6653572009765), SHI_C(173.85331806388606),
    SHI_C(40.23922406892403), SHI_C(7.537497266402169), SHI_C(0.9897218787411788),
    SHI_C(242669287.55897382), SHI_C(337605562.34251577), SHI_C(321390920.2597741),
    SHI_C(296043581.02143764), SHI_C(263814141.92615327), SHI_C(227379194.83202162),
    SHI_C(189482662.36001804), SHI_C(152606923.4412007), SHI_C(118726142.3004013), SHI_C(89171360.6780432),
    SHI_C(64610789.12779333), SHI_C(45126132.56043054), SHI_C(30351507.751584772), SHI_C(19637323.51055426),
    SHI_C(12206198.191891953), SHI_C(7278370.374374782), SHI_C(4156242.370633462), SHI_C(2268380.75628749),
    SHI_C(1180502.7735517349), SHI_C(584197.3663621662), SHI_C(274012.85340324463),
    SHI_C(121334.93090161472), SHI_C(50478.38248507522), SHI_C(19611.575704966443),
    SHI_C(7060.974268393492), SHI_C(2332.1630447972543), SHI_C(696.8669981935219),
    SHI_C(184.60457753562144), SHI_C(41.98451071963938), SHI_C(7.7299749826760165),
    SHI_C(0.9979354791501392), SHI_C(485275441.6444945), SHI_C(675474827.5362041), SHI_C(644039978.0328891),
    SHI_C(594801927.1358453), SHI_C(532007016.8894507), SHI_C(460731591.61784124), SHI_C(386219150.3426744),
    SHI_C(313265097.18252134), SHI_C(245745360.53249484), SHI_C(186345645.987145),
    SHI_C(136501889.12514427), SHI_C(96521411.44516376), SHI_C(65827056.243302256),
    SHI_C(43256850.57135687), SHI_C(27358034.442208726), SHI_C(16631462.34334867), SHI_C(9703792.453240428),
    SHI_C(5424584.891248763), SHI_C(2899562.5897890357), SHI_C(1478492.6226217924),
    SHI_C(717174.2646783672), SHI_C(329852.1867409973), SHI_C(143278.63413498976), SHI_C(58493.25744560686),
    SHI_C(22308.453078998937), SHI_C(7887.229224971031), SHI_C(2558.955067317767), SHI_C(751.3350781793009),
    SHI_C(195.63099121971072), SHI_C(43.74441948729376), SHI_C(7.920867306958054),
    SHI_C(1.0059511539353299), SHI_C(970432400.6073183), SHI_C(1351444780.4894617),
    SHI_C(1290445577.8127282), SHI_C(1194720453.6016278), SHI_C(1072294423.5165429),
    SHI_C(932807869.0348123), SHI_C(786289153.5627842), SHI_C(642002405.504569), SHI_C(507547466.1753649),
    SHI_C(388320534.24925804), SHI_C(287362192.9912655), SHI_C(205544917.23994067),
    SHI_C(142000558.02280363), SHI_C(94667038.68186909), SHI_C(60841046.64992703),
    SHI_C(37651648.895614274), SHI_C(22407212.98372115), SHI_C(12804121.704983514),
    SHI_C(7013106.286860978), SHI_C(3674424.690386253), SHI_C(1837212.3451931265), SHI_C(874202.4981938156),
    SHI_C(394558.59270862537), SHI_C(168240.34921948094), SHI_C(67446.18700826768),
    SHI_C(25267.656718891634), SHI_C(8778.089231684653), SHI_C(2799.301073048045), SHI_C(808.0886140335485),
    SHI_C(206.93028970030755), SHI_C(45.518594992624436), SHI_C(8.11023748522498),
    SHI_C(1.0137796856531225), SHI_C(1940642007.8027549), SHI_C(2703821003.046999),
    SHI_C(2585347373.888792), SHI_C(2399100828.9790335), SHI_C(2160271151.8260384),
    SHI_C(1887189305.4357607), SHI_C(1599050497.810971), SHI_C(1313754042.361401),
    SHI_C(1046185775.8280673), SHI_C(807149849.4648045), SHI_C(603011456.3257688), SHI_C(435976562.6150224),
    SHI_C(304837384.31029576), SHI_C(205967623.47599167), SHI_C(134358462.93349057),
    SHI_C(84532012.51044297), SHI_C(51234136.52012597), SHI_C(29874378.54227913), SHI_C(16732998.918186879),
    SHI_C(8987062.059449522), SHI_C(4618955.984393581), SHI_C(2266306.372569891), SHI_C(1058590.2709153148),
    SHI_C(469169.9923885751), SHI_C(196513.68496513972), SHI_C(77410.53294267537), SHI_C(28504.86871400358),
    SHI_C(9736.26621008456), SHI_C(3053.5367247193763), SHI_C(867.1461595561958), SHI_C(218.5002941457552),
    SHI_C(47.30670136614906), SHI_C(8.298144360028767), SHI_C(1.0214309616376818)
};
/* [l(l+1)/2 + m]: norm included, q_l^m at z = 1 */
static const SHI_T SHI_FN(shi_pole)[595] = {
    SHI_C(0.28209479177387814), SHI_C(0.4886025119029199), SHI_C(0.4886025119029199),
    SHI_C(0.63078313050504), SHI_C(1.0925484305920792), SHI_C(0.5462742152960396),
    SHI_C(0.7463526651802308), SHI_C(1.8281831978578629), SHI_C(1.4453057213202771),
    SHI_C(0.5900435899266435), SHI_C(0.8462843753216345), SHI_C(2.676186174229157),
    SHI_C(2.8385240872726802), SHI_C(1.7701307697799304), SHI_C(0.6258357354491761),
    SHI_C(0.9356025796273888), SHI_C(3.6235732095655755), SHI_C(4.793536784973324),
    SHI_C(3.913906395482003), SHI_C(2.075662314881041), SHI_C(0.6563820568401701),
    SHI_C(1.0171072362820548), SHI_C(4.660970900149851), SHI_C(7.369642076119388), SHI_C(7.369642076119388),
    SHI_C(5.045649007287242), SHI_C(2.366619162231752), SHI_C(0.6831841051919143),
    SHI_C(1.0925484305920792), SHI_C(5.7812228852811085), SHI_C(10.620784618679583),
    SHI_C(12.516714708983523), SHI_C(10.378311574405206), SHI_C(6.226986944643124), SHI_C(2.6459606618019),
    SHI_C(0.7071627325245962), SHI_C(1.1631066229203195), SHI_C(6.978639737521918),
    SHI_C(14.596872269917103), SHI_C(19.764258484728707), SHI_C(19.13666099037323),
    SHI_C(13.799642488392433), SHI_C(7.452658724833596), SHI_C(2.9157066406993195),
    SHI_C(0.7289266601748299), SHI_C(1.2296226898414837), SHI_C(8.248559763485094),
    SHI_C(19.34458735524795), SHI_C(29.549345281036445), SHI_C(32.621593909833386),
    SHI_C(27.29318362618504), SHI_C(17.617674274865937), SHI_C(8.71848770150485), SHI_C(3.1773176489546975),
    SHI_C(0.7489009518531883), SHI_C(1.2927207364566027), SHI_C(9.587073569946648),
    SHI_C(24.907947778572495), SHI_C(42.3353705888304), SHI_C(52.387348347963126), SHI_C(49.69900240686679),
    SHI_C(37.043449265226606), SHI_C(21.819150579676887), SHI_C(10.021084788967531),
    SHI_C(3.4318952998917145), SHI_C(0.76739511822199), SHI_C(1.3528790949515024),
    SHI_C(10.990841724215146), SHI_C(31.328719087760867), SHI_C(58.61066659644311),
    SHI_C(80.25596051321608), SHI_C(84.93492509943577), SHI_C(71.48339129009707), SHI_C(48.43935671780333),
    SHI_C(26.392782602877844), SHI_C(11.357645275668748), SHI_C(3.680297698805311),
    SHI_C(0.7846421057871968), SHI_C(1.4104739588693906), SHI_C(12.456968712917199),
    SHI_C(38.6467290864053), SHI_C(78.88730540772507), SHI_C(118.3309581115876), SHI_C(137.99642488392433),
    SHI_C(129.0838356288327), SHI_C(98.44558672009957), SHI_C(61.52849170006223), SHI_C(31.32877451244415),
    SHI_C(12.725808365463825), SHI_C(3.9232105289359844), SHI_C(0.8008219957839717),
    SHI_C(1.4658075357087597), SHI_C(13.982912700449553), SHI_C(46.900114982475536),
    SHI_C(103.7000560142647), SHI_C(169.01041364696098), SHI_C(215.11513724563713),
    SHI_C(221.00979404793313), SHI_C(186.78736777628384), SHI_C(131.04268769928626),
    SHI_C(76.35485019278295), SHI_C(36.618499751236875), SHI_C(14.123557904169544),
    SHI_C(4.161193153549645), SHI_C(0.8160771188376283), SHI_C(1.5191269449366245),
    SHI_C(15.56641901200821), SHI_C(56.125521923153094), SHI_C(133.60546594293683),
    SHI_C(234.99944364648877), SHI_C(323.92437879372795), SHI_C(362.1584652760835),
    SHI_C(335.2935864553778), SHI_C(260.05524896906616), SHI_C(169.71985893297423),
    SHI_C(92.95939519418467), SHI_C(42.25427054281121), SHI_C(15.549150542301232), SHI_C(4.394709780272119),
    SHI_C(0.830522083064524), SHI_C(1.5706373285785544), SHI_C(17.205469890442554), SHI_C(66.3582654082746),
    SHI_C(169.18104510248065), SHI_C(319.32222002745056), SHI_C(473.63139301272145),
    SHI_C(571.9642462474885), SHI_C(574.8750245688748), SHI_C(487.37401446041935),
    SHI_C(350.94940120667343), SHI_C(214.9117396229112), SHI_C(111.3804927651582), SHI_C(48.22916811032794),
    SHI_C(17.00106258233293), SHI_C(4.624151256630012), SHI_C(0.8442506508573726),
    SHI_C(1.6205112036071436), SHI_C(18.898245746582223), SHI_C(77.63246619509357),
    SHI_C(211.0245344348222), SHI_C(425.3335469570598), SHI_C(675.1960737008361), SHI_C(875.2988242980541),
    SHI_C(948.1831372824154), SHI_C(870.9618258949689), SHI_C(684.292236938833), SHI_C(461.5803492549397),
    SHI_C(267.043577744146), SHI_C(131.65425929156103), SHI_C(54.536914142021175),
    SHI_C(18.477949847767984), SHI_C(4.849850753230681), SHI_C(0.8573405888380251),
    SHI_C(1.6688952945311364), SHI_C(20.64309473234451), SHI_C(89.98116382022654), SHI_C(259.753245768018),
    SHI_C(556.7300472679734), SHI_C(941.515941563742), SHI_C(1303.4697979185264), SHI_C(1512.776956796169),
    SHI_C(1494.9439922793847), SHI_C(1270.4580980601472), SHI_C(933.5922239502468),
    SHI_C(594.1041425137934), SHI_C(326.53216138832585), SHI_C(153.81484230952415),
    SHI_C(61.17177124894914), SHI_C(19.97861682962398), SHI_C(5.07209532485536), SHI_C(0.8698571719206281),
    SHI_C(1.7159156293944244), SHI_C(22.438508472516858), SHI_C(103.43641320885615),
    SHI_C(316.0034620962089), SHI_C(717.5609954337152), SHI_C(1287.6171708160753),
    SHI_C(1895.3211566708655), SHI_C(2344.8518142958224), SHI_C(2478.4401508842157),
    SHI_C(2262.495963442987), SHI_C(1795.8004984672882), SHI_C(1243.3099217931067),
    SHI_C(750.7196870408015), SHI_C(393.7865959756465), SHI_C(177.89465076107692), SHI_C(68.12846438540069),
    SHI_C(21.5019925782306), SHI_C(5.291134612069973), SHI_C(0.8818557686783288), SHI_C(1.761681409986482),
    SHI_C(24.28310244090471), SHI_C(118.0293677042838), SHI_C(380.4298896428338), SHI_C(912.2388285797407),
    SHI_C(1730.8514810135314), SHI_C(2698.4388455595404), SHI_C(3543.5853260086496),
    SHI_C(3986.5334917597306), SHI_C(3886.8543799264003), SHI_C(3309.537249192998),
    SHI_C(2471.874826754456), SHI_C(1621.9634874530138), SHI_C(933.6664098317219), SHI_C(469.2089617599075),
    SHI_C(203.92454613652174), SHI_C(75.40211779225258), SHI_C(23.04711159078965), SHI_C(5.507187510272245),
    SHI_C(0.8933837843499495), SHI_C(1.8062879984608917), SHI_C(26.175599897817232),
    SHI_C(133.79035104979422), SHI_C(453.7051546889372), SHI_C(1145.549362585313), SHI_C(2291.098725170626),
    SHI_C(3770.4645433901796), SHI_C(5236.157789625546), SHI_C(6243.7202254106405),
    SHI_C(6470.838360426909), SHI_C(5877.4308159762495), SHI_C(4703.765817907495), SHI_C(3326.064706955877),
    SHI_C(2078.5444165856766), SHI_C(1145.2221958394873), SHI_C(553.1948766002785),
    SHI_C(231.9340029155307), SHI_C(82.98820367274519), SHI_C(24.613098461372573), SHI_C(5.720447362900643),
    SHI_C(0.904482145093491), SHI_C(1.8498192550829797), SHI_C(28.114818599199573),
    SHI_C(150.74892027770738), SHI_C(536.5193394047704), SHI_C(1422.6617367406502),
    SHI_C(2990.9750189464603), SHI_C(5180.520696984555), SHI_C(7583.505789147919), SHI_C(9550.212976588746),
    SHI_C(10477.866365876765), SHI_C(10104.488395286995), SHI_C(8617.13665712856), SHI_C(6522.41921281544),
    SHI_C(4388.297615531721), SHI_C(2622.5094281787074), SHI_C(1387.701551576613), SHI_C(646.1339825495625),
    SHI_C(261.9512445836877), SHI_C(90.8824998946166), SHI_C(26.199155407759154), SHI_C(5.93108606277937),
    SHI_C(0.9151864484003309), SHI_C(1.89234939151512), SHI_C(30.099659691608046),
    SHI_C(168.93392103673065), SHI_C(629.5795519061858), SHI_C(1749.1381074694978),
    SHI_C(3856.0462676619436), SHI_C(7010.749772439945), SHI_C(10786.86941319138),
    SHI_C(14301.503455952587), SHI_C(16552.13634319374), SHI_C(16879.93324111864),
    SHI_C(15268.474103737706), SHI_C(12303.259839645363), SHI_C(8852.804434693895),
    SHI_C(5691.088565160361), SHI_C(3263.772997403756), SHI_C(1663.4539590061363), SHI_C(748.4103703178348),
    SHI_C(294.00335997893126), SHI_C(99.08105474567313), SHI_C(27.804552028387583),
    SHI_C(6.1392573321292305), SHI_C(0.9255278664595892), SHI_C(1.9339444569737623),
    SHI_C(32.129098351712784), SHI_C(188.37353657223827), SHI_C(733.6095265360458), SHI_C(2130.94310916991),
    SHI_C(4915.046958436878), SHI_C(9357.970610030445), SHI_C(15095.195057327646), SHI_C(21011.62227253919),
    SHI_C(25574.53219655039), SHI_C(27485.186648786166), SHI_C(26265.589012280678),
    SHI_C(22428.516453980792), SHI_C(17166.22469588462), SHI_C(11792.818746938858),
    SHI_C(7269.581701810495), SHI_C(4012.7004492889328), SHI_C(1974.8623908090442),
    SHI_C(860.4029524543647), SHI_C(328.1164036197347), SHI_C(107.58015727757363),
    SHI_C(29.428616809782657), SHI_C(6.345099375493046), SHI_C(0.9355338639199108),
    SHI_C(1.974663542417147), SHI_C(34.20217583320439), SHI_C(209.09533133415002), SHI_C(849.3492509943578),
    SHI_C(2574.453098162397), SHI_C(6200.1040940374705), SHI_C(12335.454700113949),
    SHI_C(20813.45730818855), SHI_C(30340.56708236595), SHI_C(38731.841852475714), SHI_C(43734.40700339513),
    SHI_C(44004.653078765245), SHI_C(39665.2582586231), SHI_C(32146.109771564275), SHI_C(23472.4559623257),
    SHI_C(15451.462126870229), SHI_C(9161.59003138866), SHI_C(4880.101541879104), SHI_C(2324.341963722574),
    SHI_C(982.485793739322), SHI_C(364.31548285612706), SHI_C(116.37631213170847), SHI_C(31.07073002369884),
    SHI_C(6.548737047439375), SHI_C(0.9452287742977996), SHI_C(2.014559765517849), SHI_C(36.31799266030658),
    SHI_C(231.12629000267438), SHI_C(977.554617445119), SHI_C(3086.46519398688), SHI_C(7746.966153292691),
    SHI_C(16074.825132918499), SHI_C(28311.964898468697), SHI_C(43126.404402349675),
    SHI_C(57601.61566873468), SHI_C(68155.15078633507), SHI_C(71990.11744192665), SHI_C(68269.46826041739),
    SHI_C(58360.1832240766), SHI_C(45090.13565568889), SHI_C(31527.288827252632), SHI_C(19949.341989823308),
    SHI_C(11407.63345940336), SHI_C(5877.224479942147), SHI_C(2714.338710957975), SHI_C(1115.0284055258833),
    SHI_C(402.6248340801036), SHI_C(125.46621799986224), SHI_C(32.730317739094495),
    SHI_C(6.750283640247019), SHI_C(0.9546342673902561), SHI_C(2.0536810833075387),
    SHI_C(38.475702763812706), SHI_C(254.49285257872236), SHI_C(1118.9970951395135),
    SHI_C(3674.2061307983636), SHI_C(9595.236970324737), SHI_C(20728.080914817085),
    SHI_C(38036.71718003076), SHI_C(60422.58533576947), SHI_C(84255.26975047054), SHI_C(104218.01300882958),
    SHI_C(115260.62263858928), SHI_C(114658.73537773007), SHI_C(103045.75861215677),
    SHI_C(83921.60116448501), SHI_C(62049.03875940346), SHI_C(41677.92294725746), SHI_C(25419.170733068117),
    SHI_C(14050.975300595026), SHI_C(7015.750309997262), SHI_C(3147.3284580673526),
    SHI_C(1258.3960094484348), SHI_C(443.0678897752418), SHI_C(134.8467490620301), SHI_C(34.40684673698957),
    SHI_C(6.949842370673866), SHI_C(0.9637697316868012), SHI_C(2.0920709679710012),
    SHI_C(40.67450839826158), SHI_C(279.2209460729475), SHI_C(1274.4634224340575), SHI_C(4345.340930329528),
    SHI_C(11788.614431470163), SHI_C(26469.749287219252), SHI_C(50520.87898917242),
    SHI_C(83541.05113858654), SHI_C(121382.33318342076), SHI_C(156625.54675744908),
    SHI_C(180948.99620128985), SHI_C(188337.68651487574), SHI_C(177435.08896065454),
    SHI_C(151822.94919773508), SHI_C(118253.08788588208), SHI_C(83943.55596397362),
    SHI_C(54316.41856492411), SHI_C(32006.256580853933), SHI_C(17137.657393888898),
    SHI_C(8307.787655165723), SHI_C(3625.8157892777726), SHI_C(1412.9497748954632),
    SHI_C(485.66733783607214), SHI_C(144.51493888488542), SHI_C(36.09982016299105),
    SHI_C(7.1475076260442485), SHI_C(0.9726525898033295), SHI_C(2.129768972944957),
    SHI_C(42.913655711397055), SHI_C(305.3360132376932), SHI_C(1444.755316363585),
    SHI_C(5107.9814067800335), SHI_C(14375.133894747672), SHI_C(33499.168631131324),
    SHI_C(66397.44317567266), SHI_C(114101.74098901838), SHI_C(172439.05167305598),
    SHI_C(231672.36328085116), SHI_C(279010.21525002405), SHI_C(303154.0110556776),
    SHI_C(298635.81474855304), SHI_C(267703.5521695175), SHI_C(218943.0303632911),
    SHI_C(163636.11531056257), SHI_C(111839.99107692095), SHI_C(69882.73303389449),
    SHI_C(39868.988156941865), SHI_C(20716.533940255547), SHI_C(9765.86775455731), SHI_C(4152.333093420091),
    SHI_C(1579.0470338547868), SHI_C(530.4451743176498), SHI_C(154.46796637084205),
    SHI_C(37.80877378739469), SHI_C(7.343366016052452), SHI_C(0.9812985606338352),
    SHI_C(2.1668112103298047), SHI_C(45.192430862111706), SHI_C(332.8630387142), SHI_C(1630.6891981641456),
    SHI_C(5970.694513028188), SHI_C(17407.416242142077), SHI_C(42042.90449043634), SHI_C(86413.15143722593),
    SHI_C(154089.1514907636), SHI_C(241824.8929819722), SHI_C(337690.08541589946), SHI_C(423157.8727700245),
    SHI_C(478982.18902094045), SHI_C(492260.6517536544), SHI_C(461138.42311534635),
    SHI_C(394895.35305836744), SHI_C(309743.58428249706), SHI_C(222778.86887535182),
    SHI_C(146964.0277105162), SHI_C(88867.79620743275), SHI_C(49179.31316465315), SHI_C(24839.304166302205),
    SHI_C(11402.939776956675), SHI_C(4729.439680276338), SHI_C(1757.0414761164798),
    SHI_C(577.4227505647024), SHI_C(164.70314342894468), SHI_C(39.53327276946922), SHI_C(7.537497266402169),
    SHI_C(0.9897218787411788), SHI_C(2.203230756026887), SHI_C(47.51015660257084), SHI_C(361.8265729092416),
    SHI_C(1833.0959333388234), SHI_C(6942.510536717584), SHI_C(20942.920479893808),
    SHI_C(52357.301199734524), SHI_C(111443.74544486178), SHI_C(205916.6353289771),
    SHI_C(335090.8522697984), SHI_C(485592.77844433574), SHI_C(632057.3192168361), SHI_C(743955.0031556517),
    SHI_C(796056.3319708634), SHI_C(777564.7582666423), SHI_C(695475.0625569616), SHI_C(570894.855260007),
    SHI_C(430715.1610297111), SHI_C(298868.3687233766), SHI_C(190715.07346467485),
    SHI_C(111816.62327682426), SHI_C(60123.211515047835), SHI_C(29560.543904055263),
    SHI_C(13232.36638272004), SHI_C(5359.72095954611), SHI_C(1947.2833273240233), SHI_C(626.6208155031848),
    SHI_C(175.2179041016068), SHI_C(41.27290884303532), SHI_C(7.7299749826760165),
    SHI_C(0.9979354791501392), SHI_C(2.2390579955406924), SHI_C(49.866189255524354),
    SHI_C(392.2507538679096), SHI_C(2052.8205850271543), SHI_C(8032.931154030308),
    SHI_C(25044.200806470097), SHI_C(64731.17155791516), SHI_C(142510.6215643569),
    SHI_C(272499.16509408475), SHI_C(459183.82833699655), SHI_C(689540.6241876013),
    SHI_C(930832.3524181645), SHI_C(1137390.124993435), SHI_C(1264850.6377532918), SHI_C(1285652.865605452),
    SHI_C(1198411.1580832058), SHI_C(1026986.621135634), SHI_C(810498.3165325059), SHI_C(589673.5858653295),
    SHI_C(395625.93697072973), SHI_C(244681.12895464106), SHI_C(139331.46375981023),
    SHI_C(72901.1632100667), SHI_C(34937.73616696059), SHI_C(15267.919511226073), SHI_C(6045.787675759078),
    SHI_C(2150.119511966915), SHI_C(678.0595537444761), SHI_C(186.00979493021674), SHI_C(43.02729785635452),
    SHI_C(7.920867306958054), SHI_C(1.0059511539353299), SHI_C(2.274320920733615), SHI_C(52.25991602994521),
    SHI_C(424.1593273702995), SHI_C(2290.722179581669), SHI_C(9251.937348304236), SHI_C(29779.168071999076),
    SHI_C(79488.62694628163), SHI_C(180798.96377477574), SHI_C(357335.32757910335),
    SHI_C(622731.7352260756), SHI_C(967741.9469824046), SHI_C(1352952.2007584965),
    SHI_C(1713591.0978505595), SHI_C(1977220.4975198763), SHI_C(2087626.4421379848),
    SHI_C(2024028.9306724048), SHI_C(1806807.2182121372), SHI_C(1487958.885586466),
    SHI_C(1131928.675383272), SHI_C(795947.7719865455), SHI_C(517366.0517912546), SHI_C(310654.17559712665),
    SHI_C(172074.98543942595), SHI_C(87728.61125831201), SHI_C(41031.30079326034), SHI_C(17523.776374091),
    SHI_C(6790.275193389851), SHI_C(2365.8938030861436), SHI_C(731.7586200459924),
    SHI_C(197.07646638124527), SHI_C(44.79607761178913), SHI_C(8.11023748522498), SHI_C(1.0137796856531225),
    SHI_C(2.309045385777095), SHI_C(54.69075262782123), SHI_C(457.57566544761477), SHI_C(2547.673483377462),
    SHI_C(10609.997200071912), SHI_C(35221.35555671562), SHI_C(96992.05024982932),
    SHI_C(227677.43065931185), SHI_C(464599.3538292608), SHI_C(836374.4280042456),
    SHI_C(1343416.2550208059), SHI_C(1942576.6952881964), SHI_C(2546739.532834241),
    SHI_C(3044386.203249274), SHI_C(3333539.7686791406), SHI_C(3355689.778255769), SHI_C(3114340.684563985),
    SHI_C(2670525.1052723792), SHI_C(2119040.433992173), SHI_C(1557409.9622483694),
    SHI_C(1060583.6060156827), SHI_C(669058.6276484414), SHI_C(390646.0764048518),
    SHI_C(210773.49214221828), SHI_C(104836.41987581781), SHI_C(47904.62322031859),
    SHI_C(20014.515636768214), SHI_C(7595.8428272034225), SHI_C(2594.9469602010818),
    SHI_C(787.7371705858482), SHI_C(208.4156651851819), SHI_C(46.578905960516), SHI_C(8.298144360028767),
    SHI_C(1.0214309616376818)
};
/* [l(l+1)/2 + m]: (2l-1)/(l+m), l >= 1 */
static const SHI_T SHI_FN(shi_ratio)[595] = {
    SHI_C(0.0), SHI_C(1.0), SHI_C(0.5), SHI_C(1.5), SHI_C(1.0), SHI_C(0.75), SHI_C(1.6666666666666667),
    SHI_C(1.25), SHI_C(1.0), SHI_C(0.8333333333333334), SHI_C(1.75), SHI_C(1.4), SHI_C(1.1666666666666667),
    SHI_C(1.0), SHI_C(0.875), SHI_C(1.8), SHI_C(1.5), SHI_C(1.2857142857142858), SHI_C(1.125), SHI_C(1.0),
    SHI_C(0.9), SHI_C(1.8333333333333333), SHI_C(1.5714285714285714), SHI_C(1.375),
    SHI_C(1.2222222222222223), SHI_C(1.1), SHI_C(1.0), SHI_C(0.9166666666666666), SHI_C(1.8571428571428572),
    SHI_C(1.625), SHI_C(1.4444444444444444), SHI_C(1.3), SHI_C(1.1818181818181819),
    SHI_C(1.0833333333333333), SHI_C(1.0), SHI_C(0.9285714285714286), SHI_C(1.875),
    SHI_C(1.6666666666666667), SHI_C(1.5), SHI_C(1.3636363636363635), SHI_C(1.25),
    SHI_C(1.1538461538461537), SHI_C(1.0714285714285714), SHI_C(1.0), SHI_C(0.9375),
    SHI_C(1.8888888888888888), SHI_C(1.7), SHI_C(1.5454545454545454), SHI_C(1.4166666666666667),
    SHI_C(1.3076923076923077), SHI_C(1.2142857142857142), SHI_C(1.1333333333333333), SHI_C(1.0625),
    SHI_C(1.0), SHI_C(0.9444444444444444), SHI_C(1.9), SHI_C(1.7272727272727273), SHI_C(1.5833333333333333),
    SHI_C(1.4615384615384615), SHI_C(1.3571428571428572), SHI_C(1.2666666666666666), SHI_C(1.1875),
    SHI_C(1.1176470588235294), SHI_C(1.0555555555555556), SHI_C(1.0), SHI_C(0.95),
    SHI_C(1.9090909090909092), SHI_C(1.75), SHI_C(1.6153846153846154), SHI_C(1.5), SHI_C(1.4),
    SHI_C(1.3125), SHI_C(1.2352941176470589), SHI_C(1.1666666666666667), SHI_C(1.105263157894737),
    SHI_C(1.05), SHI_C(1.0), SHI_C(0.9545454545454546), SHI_C(1.9166666666666667),
    SHI_C(1.7692307692307692), SHI_C(1.6428571428571428), SHI_C(1.5333333333333334), SHI_C(1.4375),
    SHI_C(1.3529411764705883), SHI_C(1.2777777777777777), SHI_C(1.2105263157894737), SHI_C(1.15),
    SHI_C(1.0952380952380953), SHI_C(1.0454545454545454), SHI_C(1.0), SHI_C(0.9583333333333334),
    SHI_C(1.9230769230769231), SHI_C(1.7857142857142858), SHI_C(1.6666666666666667), SHI_C(1.5625),
    SHI_C(1.4705882352941178), SHI_C(1.3888888888888888), SHI_C(1.3157894736842106), SHI_C(1.25),
    SHI_C(1.1904761904761905), SHI_C(1.1363636363636365), SHI_C(1.0869565217391304),
    SHI_C(1.0416666666666667), SHI_C(1.0), SHI_C(0.9615384615384616), SHI_C(1.9285714285714286), SHI_C(1.8),
    SHI_C(1.6875), SHI_C(1.588235294117647), SHI_C(1.5), SHI_C(1.4210526315789473), SHI_C(1.35),
    SHI_C(1.2857142857142858), SHI_C(1.2272727272727273), SHI_C(1.173913043478261), SHI_C(1.125),
    SHI_C(1.08), SHI_C(1.0384615384615385), SHI_C(1.0), SHI_C(0.9642857142857143),
    SHI_C(1.9333333333333333), SHI_C(1.8125), SHI_C(1.7058823529411764), SHI_C(1.6111111111111112),
    SHI_C(1.5263157894736843), SHI_C(1.45), SHI_C(1.380952380952381), SHI_C(1.3181818181818181),
    SHI_C(1.2608695652173914), SHI_C(1.2083333333333333), SHI_C(1.16), SHI_C(1.1153846153846154),
    SHI_C(1.0740740740740742), SHI_C(1.0357142857142858), SHI_C(1.0), SHI_C(0.9666666666666667),
    SHI_C(1.9375), SHI_C(1.8235294117647058), SHI_C(1.7222222222222223), SHI_C(1.631578947368421),
    SHI_C(1.55), SHI_C(1.4761904761904763), SHI_C(1.4090909090909092), SHI_C(1.3478260869565217),
    SHI_C(1.2916666666666667), SHI_C(1.24), SHI_C(1.1923076923076923), SHI_C(1.1481481481481481),
    SHI_C(1.1071428571428572), SHI_C(1.0689655172413792), SHI_C(1.0333333333333334), SHI_C(1.0),
    SHI_C(0.96875), SHI_C(1.9411764705882353), SHI_C(1.8333333333333333), SHI_C(1.736842105263158),
    SHI_C(1.65), SHI_C(1.5714285714285714), SHI_C(1.5), SHI_C(1.434782608695652), SHI_C(1.375), SHI_C(1.32),
    SHI_C(1.2692307692307692), SHI_C(1.2222222222222223), SHI_C(1.1785714285714286),
    SHI_C(1.1379310344827587), SHI_C(1.1), SHI_C(1.064516129032258), SHI_C(1.03125), SHI_C(1.0),
    SHI_C(0.9705882352941176), SHI_C(1.9444444444444444), SHI_C(1.8421052631578947), SHI_C(1.75),
    SHI_C(1.6666666666666667), SHI_C(1.5909090909090908), SHI_C(1.5217391304347827),
    SHI_C(1.4583333333333333), SHI_C(1.4), SHI_C(1.3461538461538463), SHI_C(1.2962962962962963),
    SHI_C(1.25), SHI_C(1.206896551724138), SHI_C(1.1666666666666667), SHI_C(1.1290322580645162),
    SHI_C(1.09375), SHI_C(1.0606060606060606), SHI_C(1.0294117647058822), SHI_C(1.0),
    SHI_C(0.9722222222222222), SHI_C(1.9473684210526316), SHI_C(1.85), SHI_C(1.7619047619047619),
    SHI_C(1.6818181818181819), SHI_C(1.608695652173913), SHI_C(1.5416666666666667), SHI_C(1.48),
    SHI_C(1.4230769230769231), SHI_C(1.3703703703703705), SHI_C(1.3214285714285714),
    SHI_C(1.2758620689655173), SHI_C(1.2333333333333334), SHI_C(1.1935483870967742), SHI_C(1.15625),
    SHI_C(1.121212121212121), SHI_C(1.088235294117647), SHI_C(1.0571428571428572),
    SHI_C(1.0277777777777777), SHI_C(1.0), SHI_C(0.9736842105263158), SHI_C(1.95),
    SHI_C(1.8571428571428572), SHI_C(1.7727272727272727), SHI_C(1.6956521739130435), SHI_C(1.625),
    SHI_C(1.56), SHI_C(1.5), SHI_C(1.4444444444444444), SHI_C(1.3928571428571428),
    SHI_C(1.3448275862068966), SHI_C(1.3), SHI_C(1.2580645161290323), SHI_C(1.21875),
    SHI_C(1.1818181818181819), SHI_C(1.1470588235294117), SHI_C(1.1142857142857143),
    SHI_C(1.0833333333333333), SHI_C(1.054054054054054), SHI_C(1.0263157894736843), SHI_C(1.0),
    SHI_C(0.975), SHI_C(1.9523809523809523), SHI_C(1.8636363636363635), SHI_C(1.7826086956521738),
    SHI_C(1.7083333333333333), SHI_C(1.64), SHI_C(1.5769230769230769), SHI_C(1.5185185185185186),
    SHI_C(1.4642857142857142), SHI_C(1.4137931034482758), SHI_C(1.3666666666666667),
    SHI_C(1.3225806451612903), SHI_C(1.28125), SHI_C(1.2424242424242424), SHI_C(1.2058823529411764),
    SHI_C(1.1714285714285715), SHI_C(1.1388888888888888), SHI_C(1.1081081081081081),
    SHI_C(1.0789473684210527), SHI_C(1.0512820512820513), SHI_C(1.025), SHI_C(1.0),
    SHI_C(0.9761904761904762), SHI_C(1.9545454545454546), SHI_C(1.8695652173913044),
    SHI_C(1.7916666666666667), SHI_C(1.72), SHI_C(1.6538461538461537), SHI_C(1.5925925925925926),
    SHI_C(1.5357142857142858), SHI_C(1.4827586206896552), SHI_C(1.4333333333333333),
    SHI_C(1.3870967741935485), SHI_C(1.34375), SHI_C(1.303030303030303), SHI_C(1.2647058823529411),
    SHI_C(1.2285714285714286), SHI_C(1.1944444444444444), SHI_C(1.162162162162162),
    SHI_C(1.131578947368421), SHI_C(1.1025641025641026), SHI_C(1.075), SHI_C(1.048780487804878),
    SHI_C(1.0238095238095237), SHI_C(1.0), SHI_C(0.9772727272727273), SHI_C(1.9565217391304348),
    SHI_C(1.875), SHI_C(1.8), SHI_C(1.7307692307692308), SHI_C(1.6666666666666667),
    SHI_C(1.6071428571428572), SHI_C(1.5517241379310345), SHI_C(1.5), SHI_C(1.4516129032258065),
    SHI_C(1.40625), SHI_C(1.3636363636363635), SHI_C(1.3235294117647058), SHI_C(1.2857142857142858),
    SHI_C(1.25), SHI_C(1.2162162162162162), SHI_C(1.1842105263157894), SHI_C(1.1538461538461537),
    SHI_C(1.125), SHI_C(1.0975609756097562), SHI_C(1.0714285714285714), SHI_C(1.0465116279069768),
    SHI_C(1.0227272727272727), SHI_C(1.0), SHI_C(0.9782608695652174), SHI_C(1.9583333333333333),
    SHI_C(1.88), SHI_C(1.8076923076923077), SHI_C(1.7407407407407407), SHI_C(1.6785714285714286),
    SHI_C(1.6206896551724137), SHI_C(1.5666666666666667), SHI_C(1.5161290322580645), SHI_C(1.46875),
    SHI_C(1.4242424242424243), SHI_C(1.3823529411764706), SHI_C(1.3428571428571427),
    SHI_C(1.3055555555555556), SHI_C(1.2702702702702702), SHI_C(1.236842105263158),
    SHI_C(1.205128205128205), SHI_C(1.175), SHI_C(1.146341463414634), SHI_C(1.119047619047619),
    SHI_C(1.0930232558139534), SHI_C(1.0681818181818181), SHI_C(1.0444444444444445),
    SHI_C(1.0217391304347827), SHI_C(1.0), SHI_C(0.9791666666666666), SHI_C(1.96),
    SHI_C(1.8846153846153846), SHI_C(1.8148148148148149), SHI_C(1.75), SHI_C(1.6896551724137931),
    SHI_C(1.6333333333333333), SHI_C(1.5806451612903225), SHI_C(1.53125), SHI_C(1.4848484848484849),
    SHI_C(1.4411764705882353), SHI_C(1.4), SHI_C(1.3611111111111112), SHI_C(1.3243243243243243),
    SHI_C(1.2894736842105263), SHI_C(1.2564102564102564), SHI_C(1.225), SHI_C(1.1951219512195121),
    SHI_C(1.1666666666666667), SHI_C(1.1395348837209303), SHI_C(1.1136363636363635),
    SHI_C(1.0888888888888888), SHI_C(1.065217391304348), SHI_C(1.0425531914893618),
    SHI_C(1.0208333333333333), SHI_C(1.0), SHI_C(0.98), SHI_C(1.9615384615384615),
    SHI_C(1.8888888888888888), SHI_C(1.8214285714285714), SHI_C(1.7586206896551724), SHI_C(1.7),
    SHI_C(1.6451612903225807), SHI_C(1.59375), SHI_C(1.5454545454545454), SHI_C(1.5),
    SHI_C(1.457142857142857), SHI_C(1.4166666666666667), SHI_C(1.3783783783783783),
    SHI_C(1.3421052631578947), SHI_C(1.3076923076923077), SHI_C(1.275), SHI_C(1.2439024390243902),
    SHI_C(1.2142857142857142), SHI_C(1.186046511627907), SHI_C(1.1590909090909092),
    SHI_C(1.1333333333333333), SHI_C(1.108695652173913), SHI_C(1.0851063829787233), SHI_C(1.0625),
    SHI_C(1.0408163265306123), SHI_C(1.02), SHI_C(1.0), SHI_C(0.9807692307692307), SHI_C(1.962962962962963),
    SHI_C(1.8928571428571428), SHI_C(1.8275862068965518), SHI_C(1.7666666666666666),
    SHI_C(1.7096774193548387), SHI_C(1.65625), SHI_C(1.606060606060606), SHI_C(1.5588235294117647),
    SHI_C(1.5142857142857142), SHI_C(1.4722222222222223), SHI_C(1.4324324324324325),
    SHI_C(1.394736842105263), SHI_C(1.358974358974359), SHI_C(1.325), SHI_C(1.2926829268292683),
    SHI_C(1.2619047619047619), SHI_C(1.2325581395348837), SHI_C(1.2045454545454546),
    SHI_C(1.1777777777777778), SHI_C(1.1521739130434783), SHI_C(1.127659574468085),
    SHI_C(1.1041666666666667), SHI_C(1.0816326530612246), SHI_C(1.06), SHI_C(1.0392156862745099),
    SHI_C(1.0192307692307692), SHI_C(1.0), SHI_C(0.9814814814814815), SHI_C(1.9642857142857142),
    SHI_C(1.896551724137931), SHI_C(1.8333333333333333), SHI_C(1.7741935483870968), SHI_C(1.71875),
    SHI_C(1.6666666666666667), SHI_C(1.6176470588235294), SHI_C(1.5714285714285714),
    SHI_C(1.5277777777777777), SHI_C(1.4864864864864864), SHI_C(1.4473684210526316),
    SHI_C(1.4102564102564104), SHI_C(1.375), SHI_C(1.3414634146341464), SHI_C(1.3095238095238095),
    SHI_C(1.2790697674418605), SHI_C(1.25), SHI_C(1.2222222222222223), SHI_C(1.1956521739130435),
    SHI_C(1.1702127659574468), SHI_C(1.1458333333333333), SHI_C(1.1224489795918366), SHI_C(1.1),
    SHI_C(1.0784313725490196), SHI_C(1.0576923076923077), SHI_C(1.0377358490566038),
    SHI_C(1.0185185185185186), SHI_C(1.0), SHI_C(0.9821428571428571), SHI_C(1.9655172413793103), SHI_C(1.9),
    SHI_C(1.8387096774193548), SHI_C(1.78125), SHI_C(1.7272727272727273), SHI_C(1.6764705882352942),
    SHI_C(1.6285714285714286), SHI_C(1.5833333333333333), SHI_C(1.5405405405405406), SHI_C(1.5),
    SHI_C(1.4615384615384615), SHI_C(1.425), SHI_C(1.3902439024390243), SHI_C(1.3571428571428572),
    SHI_C(1.3255813953488371), SHI_C(1.2954545454545454), SHI_C(1.2666666666666666),
    SHI_C(1.2391304347826086), SHI_C(1.2127659574468086), SHI_C(1.1875), SHI_C(1.163265306122449),
    SHI_C(1.14), SHI_C(1.1176470588235294), SHI_C(1.0961538461538463), SHI_C(1.0754716981132075),
    SHI_C(1.0555555555555556), SHI_C(1.0363636363636364), SHI_C(1.0178571428571428), SHI_C(1.0),
    SHI_C(0.9827586206896551), SHI_C(1.9666666666666666), SHI_C(1.903225806451613), SHI_C(1.84375),
    SHI_C(1.7878787878787878), SHI_C(1.7352941176470589), SHI_C(1.6857142857142857),
    SHI_C(1.6388888888888888), SHI_C(1.5945945945945945), SHI_C(1.5526315789473684),
    SHI_C(1.5128205128205128), SHI_C(1.475), SHI_C(1.4390243902439024), SHI_C(1.4047619047619047),
    SHI_C(1.372093023255814), SHI_C(1.3409090909090908), SHI_C(1.3111111111111111),
    SHI_C(1.2826086956521738), SHI_C(1.2553191489361701), SHI_C(1.2291666666666667),
    SHI_C(1.2040816326530612), SHI_C(1.18), SHI_C(1.1568627450980393), SHI_C(1.1346153846153846),
    SHI_C(1.1132075471698113), SHI_C(1.0925925925925926), SHI_C(1.0727272727272728),
    SHI_C(1.0535714285714286), SHI_C(1.0350877192982457), SHI_C(1.0172413793103448), SHI_C(1.0),
    SHI_C(0.9833333333333333), SHI_C(1.967741935483871), SHI_C(1.90625), SHI_C(1.8484848484848484),
    SHI_C(1.7941176470588236), SHI_C(1.7428571428571429), SHI_C(1.6944444444444444),
    SHI_C(1.6486486486486487), SHI_C(1.605263157894737), SHI_C(1.564102564102564), SHI_C(1.525),
    SHI_C(1.4878048780487805), SHI_C(1.4523809523809523), SHI_C(1.4186046511627908),
    SHI_C(1.3863636363636365), SHI_C(1.3555555555555556), SHI_C(1.326086956521739),
    SHI_C(1.297872340425532), SHI_C(1.2708333333333333), SHI_C(1.2448979591836735), SHI_C(1.22),
    SHI_C(1.196078431372549), SHI_C(1.1730769230769231), SHI_C(1.150943396226415),
    SHI_C(1.1296296296296295), SHI_C(1.1090909090909091), SHI_C(1.0892857142857142),
    SHI_C(1.0701754385964912), SHI_C(1.0517241379310345), SHI_C(1.0338983050847457),
    SHI_C(1.0166666666666666), SHI_C(1.0), SHI_C(0.9838709677419355), SHI_C(1.96875),
    SHI_C(1.9090909090909092), SHI_C(1.8529411764705883), SHI_C(1.8), SHI_C(1.75),
    SHI_C(1.7027027027027026), SHI_C(1.6578947368421053), SHI_C(1.6153846153846154), SHI_C(1.575),
    SHI_C(1.5365853658536586), SHI_C(1.5), SHI_C(1.4651162790697674), SHI_C(1.4318181818181819), SHI_C(1.4),
    SHI_C(1.3695652173913044), SHI_C(1.3404255319148937), SHI_C(1.3125), SHI_C(1.2857142857142858),
    SHI_C(1.26), SHI_C(1.2352941176470589), SHI_C(1.2115384615384615), SHI_C(1.1886792452830188),
    SHI_C(1.1666666666666667), SHI_C(1.1454545454545455), SHI_C(1.125), SHI_C(1.105263157894737),
    SHI_C(1.0862068965517242), SHI_C(1.0677966101694916), SHI_C(1.05), SHI_C(1.0327868852459017),
    SHI_C(1.0161290322580645), SHI_C(1.0), SHI_C(0.984375), SHI_C(1.9696969696969697),
    SHI_C(1.911764705882353), SHI_C(1.8571428571428572), SHI_C(1.8055555555555556),
    SHI_C(1.7567567567567568), SHI_C(1.7105263157894737), SHI_C(1.6666666666666667), SHI_C(1.625),
    SHI_C(1.5853658536585367), SHI_C(1.5476190476190477), SHI_C(1.5116279069767442),
    SHI_C(1.4772727272727273), SHI_C(1.4444444444444444), SHI_C(1.4130434782608696),
    SHI_C(1.3829787234042554), SHI_C(1.3541666666666667), SHI_C(1.3265306122448979), SHI_C(1.3),
    SHI_C(1.2745098039215685), SHI_C(1.25), SHI_C(1.2264150943396226), SHI_C(1.2037037037037037),
    SHI_C(1.1818181818181819), SHI_C(1.1607142857142858), SHI_C(1.1403508771929824),
    SHI_C(1.1206896551724137), SHI_C(1.1016949152542372), SHI_C(1.0833333333333333),
    SHI_C(1.0655737704918034), SHI_C(1.0483870967741935), SHI_C(1.0317460317460319), SHI_C(1.015625),
    SHI_C(1.0), SHI_C(0.9848484848484849)
};
/* [l(l+1)/2 + m]: norm included, d q_l^m / dz = slope q_l^{m+1} */
static const SHI_T SHI_FN(shi_slope)[595] = {
    SHI_C(0.0), SHI_C(1.0), SHI_C(0.0), SHI_C(1.7320508075688772), SHI_C(2.0), SHI_C(0.0),
    SHI_C(2.449489742783178), SHI_C(3.1622776601683795), SHI_C(2.449489742783178), SHI_C(0.0),
    SHI_C(3.1622776601683795), SHI_C(4.242640687119285), SHI_C(3.7416573867739413),
    SHI_C(2.8284271247461903), SHI_C(0.0), SHI_C(3.872983346207417), SHI_C(5.291502622129181),
    SHI_C(4.898979485566356), SHI_C(4.242640687119285), SHI_C(3.1622776601683795), SHI_C(0.0),
    SHI_C(4.58257569495584), SHI_C(6.324555320336759), SHI_C(6.0), SHI_C(5.477225575051661),
    SHI_C(4.69041575982343), SHI_C(3.4641016151377544), SHI_C(0.0), SHI_C(5.291502622129181),
    SHI_C(7.3484692283495345), SHI_C(7.0710678118654755), SHI_C(6.6332495807108), SHI_C(6.0),
    SHI_C(5.0990195135927845), SHI_C(3.7416573867739413), SHI_C(0.0), SHI_C(6.0), SHI_C(8.366600265340756),
    SHI_C(8.12403840463596), SHI_C(7.745966692414834), SHI_C(7.211102550927978), SHI_C(6.48074069840786),
    SHI_C(5.477225575051661), SHI_C(4.0), SHI_C(0.0), SHI_C(6.708203932499369), SHI_C(9.38083151964686),
    SHI_C(9.16515138991168), SHI_C(8.831760866327848), SHI_C(8.366600265340756), SHI_C(7.745966692414834),
    SHI_C(6.928203230275509), SHI_C(5.830951894845301), SHI_C(4.242640687119285), SHI_C(0.0),
    SHI_C(7.416198487095663), SHI_C(10.392304845413264), SHI_C(10.198039027185569),
    SHI_C(9.899494936611665), SHI_C(9.486832980505138), SHI_C(8.94427190999916), SHI_C(8.246211251235321),
    SHI_C(7.3484692283495345), SHI_C(6.164414002968976), SHI_C(4.47213595499958), SHI_C(0.0),
    SHI_C(8.12403840463596), SHI_C(11.40175425099138), SHI_C(11.224972160321824), SHI_C(10.954451150103322),
    SHI_C(10.583005244258363), SHI_C(10.099504938362077), SHI_C(9.486832980505138),
    SHI_C(8.717797887081348), SHI_C(7.745966692414834), SHI_C(6.48074069840786), SHI_C(4.69041575982343),
    SHI_C(0.0), SHI_C(8.831760866327848), SHI_C(12.409673645990857), SHI_C(12.24744871391589), SHI_C(12.0),
    SHI_C(11.661903789690601), SHI_C(11.224972160321824), SHI_C(10.677078252031311), SHI_C(10.0),
    SHI_C(9.16515138991168), SHI_C(8.12403840463596), SHI_C(6.782329983125268), SHI_C(4.898979485566356),
    SHI_C(0.0), SHI_C(9.539392014169456), SHI_C(13.416407864998739), SHI_C(13.2664991614216),
    SHI_C(13.038404810405298), SHI_C(12.727922061357855), SHI_C(12.328828005937952),
    SHI_C(11.832159566199232), SHI_C(11.224972160321824), SHI_C(10.488088481701515),
    SHI_C(9.591663046625438), SHI_C(8.48528137423857), SHI_C(7.0710678118654755), SHI_C(5.0990195135927845),
    SHI_C(0.0), SHI_C(10.246950765959598), SHI_C(14.422205101855956), SHI_C(14.2828568570857),
    SHI_C(14.071247279470288), SHI_C(13.784048752090222), SHI_C(13.416407864998739),
    SHI_C(12.96148139681572), SHI_C(12.409673645990857), SHI_C(11.74734012447073),
    SHI_C(10.954451150103322), SHI_C(10.0), SHI_C(8.831760866327848), SHI_C(7.3484692283495345),
    SHI_C(5.291502622129181), SHI_C(0.0), SHI_C(10.954451150103322), SHI_C(15.427248620541512),
    SHI_C(15.297058540778355), SHI_C(15.0996688705415), SHI_C(14.832396974191326),
    SHI_C(14.491376746189438), SHI_C(14.071247279470288), SHI_C(13.564659966250536),
    SHI_C(12.96148139681572), SHI_C(12.24744871391589), SHI_C(11.40175425099138), SHI_C(10.392304845413264),
    SHI_C(9.16515138991168), SHI_C(7.615773105863909), SHI_C(5.477225575051661), SHI_C(0.0),
    SHI_C(11.661903789690601), SHI_C(16.431676725154983), SHI_C(16.30950643030009), SHI_C(16.1245154965971),
    SHI_C(15.874507866387544), SHI_C(15.556349186104045), SHI_C(15.165750888103101),
    SHI_C(14.696938456699069), SHI_C(14.142135623730951), SHI_C(13.490737563232042),
    SHI_C(12.727922061357855), SHI_C(11.832159566199232), SHI_C(10.770329614269007),
    SHI_C(9.486832980505138), SHI_C(7.874007874011811), SHI_C(5.656854249492381), SHI_C(0.0),
    SHI_C(12.36931687685298), SHI_C(17.435595774162696), SHI_C(17.320508075688775),
    SHI_C(17.146428199482248), SHI_C(16.911534525287763), SHI_C(16.61324772583615),
    SHI_C(16.24807680927192), SHI_C(15.811388300841896), SHI_C(15.297058540778355),
    SHI_C(14.696938456699069), SHI_C(14.0), SHI_C(13.19090595827292), SHI_C(12.24744871391589),
    SHI_C(11.135528725660043), SHI_C(9.797958971132712), SHI_C(8.12403840463596), SHI_C(5.830951894845301),
    SHI_C(0.0), SHI_C(13.076696830622021), SHI_C(18.439088914585774), SHI_C(18.33030277982336),
    SHI_C(18.16590212458495), SHI_C(17.944358444926362), SHI_C(17.663521732655695),
    SHI_C(17.320508075688775), SHI_C(16.911534525287763), SHI_C(16.431676725154983),
    SHI_C(15.874507866387544), SHI_C(15.231546211727817), SHI_C(14.491376746189438),
    SHI_C(13.638181696985855), SHI_C(12.649110640673518), SHI_C(11.489125293076057),
    SHI_C(10.099504938362077), SHI_C(8.366600265340756), SHI_C(6.0), SHI_C(0.0), SHI_C(13.784048752090222),
    SHI_C(19.44222209522358), SHI_C(19.339079605813716), SHI_C(19.183326093250876),
    SHI_C(18.973665961010276), SHI_C(18.708286933869708), SHI_C(18.384776310850235), SHI_C(18.0),
    SHI_C(17.549928774784245), SHI_C(17.029386365926403), SHI_C(16.431676725154983),
    SHI_C(15.748015748023622), SHI_C(14.966629547095765), SHI_C(14.071247279470288),
    SHI_C(13.038404810405298), SHI_C(11.832159566199232), SHI_C(10.392304845413264),
    SHI_C(8.602325267042627), SHI_C(6.164414002968976), SHI_C(0.0), SHI_C(14.491376746189438),
    SHI_C(20.445048300260872), SHI_C(20.346989949375804), SHI_C(20.199009876724155), SHI_C(20.0),
    SHI_C(19.748417658131498), SHI_C(19.44222209522358), SHI_C(19.078784028338912),
    SHI_C(18.65475810617763), SHI_C(18.16590212458495), SHI_C(17.60681686165901), SHI_C(16.97056274847714),
    SHI_C(16.24807680927192), SHI_C(15.427248620541512), SHI_C(14.491376746189438),
    SHI_C(13.416407864998739), SHI_C(12.165525060596439), SHI_C(10.677078252031311),
    SHI_C(8.831760866327848), SHI_C(6.324555320336759), SHI_C(0.0), SHI_C(15.198684153570664),
    SHI_C(21.447610589527216), SHI_C(21.354156504062622), SHI_C(21.213203435596427),
    SHI_C(21.02379604162864), SHI_C(20.784609690826528), SHI_C(20.493901531919196),
    SHI_C(20.149441679609886), SHI_C(19.748417658131498), SHI_C(19.28730152198591),
    SHI_C(18.76166303929372), SHI_C(18.16590212458495), SHI_C(17.4928556845359), SHI_C(16.73320053068151),
    SHI_C(15.874507866387544), SHI_C(14.89966442575134), SHI_C(13.784048752090222),
    SHI_C(12.489995996796797), SHI_C(10.954451150103322), SHI_C(9.055385138137417), SHI_C(6.48074069840786),
    SHI_C(0.0), SHI_C(15.905973720586866), SHI_C(22.44994432064365), SHI_C(22.360679774997898),
    SHI_C(22.22611077089287), SHI_C(22.045407685048602), SHI_C(21.817424229271428),
    SHI_C(21.540659228538015), SHI_C(21.213203435596427), SHI_C(20.83266665599966),
    SHI_C(20.396078054371138), SHI_C(19.8997487421324), SHI_C(19.339079605813716),
    SHI_C(18.708286933869708), SHI_C(18.0), SHI_C(17.204650534085253), SHI_C(16.30950643030009),
    SHI_C(15.297058540778355), SHI_C(14.142135623730951), SHI_C(12.806248474865697),
    SHI_C(11.224972160321824), SHI_C(9.273618495495704), SHI_C(6.6332495807108), SHI_C(0.0),
    SHI_C(16.61324772583615), SHI_C(23.45207879911715), SHI_C(23.366642891095847), SHI_C(23.2379000772445),
    SHI_C(23.065125189341593), SHI_C(22.847319317591726), SHI_C(22.58317958127243),
    SHI_C(22.271057451320086), SHI_C(21.908902300206645), SHI_C(21.494185260204677),
    SHI_C(21.02379604162864), SHI_C(20.493901531919196), SHI_C(19.8997487421324), SHI_C(19.235384061671343),
    SHI_C(18.49324200890693), SHI_C(17.663521732655695), SHI_C(16.73320053068151),
    SHI_C(15.684387141358123), SHI_C(14.491376746189438), SHI_C(13.114877048604), SHI_C(11.489125293076057),
    SHI_C(9.486832980505138), SHI_C(6.782329983125268), SHI_C(0.0), SHI_C(17.320508075688775),
    SHI_C(24.454038521274967), SHI_C(24.372115213907882), SHI_C(24.24871130596428),
    SHI_C(24.08318915758459), SHI_C(23.874672772626646), SHI_C(23.62202362203543),
    SHI_C(23.323807579381203), SHI_C(22.978250586152114), SHI_C(22.58317958127243),
    SHI_C(22.135943621178654), SHI_C(21.633307652783937), SHI_C(21.071307505705477),
    SHI_C(20.445048300260872), SHI_C(19.748417658131498), SHI_C(18.973665961010276),
    SHI_C(18.110770276274835), SHI_C(17.146428199482248), SHI_C(16.06237840420901),
    SHI_C(14.832396974191326), SHI_C(13.416407864998739), SHI_C(11.74734012447073),
    SHI_C(9.695359714832659), SHI_C(6.928203230275509), SHI_C(0.0), SHI_C(18.027756377319946),
    SHI_C(25.45584412271571), SHI_C(25.37715508089904), SHI_C(25.25866188063018), SHI_C(25.099800796022265),
    SHI_C(24.899799195977465), SHI_C(24.657656011875904), SHI_C(24.372115213907882),
    SHI_C(24.041630560342615), SHI_C(23.664319132398465), SHI_C(23.2379000772445),
    SHI_C(22.759613353482084), SHI_C(22.22611077089287), SHI_C(21.633307652783937),
    SHI_C(20.97617696340303), SHI_C(20.248456731316587), SHI_C(19.44222209522358),
    SHI_C(18.547236990991408), SHI_C(17.549928774784245), SHI_C(16.431676725154983),
    SHI_C(15.165750888103101), SHI_C(13.711309200802088), SHI_C(12.0), SHI_C(9.899494936611665),
    SHI_C(7.0710678118654755), SHI_C(0.0), SHI_C(18.734993995195193), SHI_C(26.457513110645905),
    SHI_C(26.38181191654584), SHI_C(26.267851073127396), SHI_C(26.115129714401192),
    SHI_C(25.92296279363144), SHI_C(25.69046515733026), SHI_C(25.41653005427767), SHI_C(25.099800796022265),
    SHI_C(24.73863375370596), SHI_C(24.331050121192877), SHI_C(23.874672772626646),
    SHI_C(23.366642891095847), SHI_C(22.80350850198276), SHI_C(22.181073012818835),
    SHI_C(21.494185260204677), SHI_C(20.73644135332772), SHI_C(19.8997487421324), SHI_C(18.973665961010276),
    SHI_C(17.944358444926362), SHI_C(16.792855623746664), SHI_C(15.491933384829668), SHI_C(14.0),
    SHI_C(12.24744871391589), SHI_C(10.099504938362077), SHI_C(7.211102550927978), SHI_C(0.0),
    SHI_C(19.44222209522358), SHI_C(27.459060435491963), SHI_C(27.386127875258307),
    SHI_C(27.27636339397171), SHI_C(27.129319932501073), SHI_C(26.94438717061496),
    SHI_C(26.720778431774775), SHI_C(26.457513110645905), SHI_C(26.153393661244042),
    SHI_C(25.80697580112788), SHI_C(25.41653005427767), SHI_C(24.979991993593593), SHI_C(24.49489742783178),
    SHI_C(23.958297101421877), SHI_C(23.366642891095847), SHI_C(22.715633383201094), SHI_C(22.0),
    SHI_C(21.213203435596427), SHI_C(20.346989949375804), SHI_C(19.390719429665317),
    SHI_C(18.33030277982336), SHI_C(17.146428199482248), SHI_C(15.811388300841896), SHI_C(14.2828568570857),
    SHI_C(12.489995996796797), SHI_C(10.295630140987), SHI_C(7.3484692283495345), SHI_C(0.0),
    SHI_C(20.149441679609886), SHI_C(28.460498941515414), SHI_C(28.39013913315678),
    SHI_C(28.284271247461902), SHI_C(28.142494558940577), SHI_C(27.964262908219126),
    SHI_C(27.748873851023216), SHI_C(27.49545416973504), SHI_C(27.202941017470888),
    SHI_C(26.870057685088806), SHI_C(26.49528259898354), SHI_C(26.076809620810597),
    SHI_C(25.612496949731394), SHI_C(25.099800796022265), SHI_C(24.535688292770594),
    SHI_C(23.916521486202797), SHI_C(23.2379000772445), SHI_C(22.494443758403985), SHI_C(21.6794833886788),
    SHI_C(20.784609690826528), SHI_C(19.79898987322333), SHI_C(18.708286933869708), SHI_C(17.4928556845359),
    SHI_C(16.1245154965971), SHI_C(14.560219778561036), SHI_C(12.727922061357855),
    SHI_C(10.488088481701515), SHI_C(7.483314773547883), SHI_C(0.0), SHI_C(20.85665361461421),
    SHI_C(29.46183972531247), SHI_C(29.393876913398138), SHI_C(29.29163703175362),
    SHI_C(29.154759474226502), SHI_C(28.982753492378876), SHI_C(28.77498913987632),
    SHI_C(28.53068523537421), SHI_C(28.24889378365107), SHI_C(27.92848008753788), SHI_C(27.568097504180443),
    SHI_C(27.16615541441225), SHI_C(26.720778431774775), SHI_C(26.229754097208), SHI_C(25.69046515733026),
    SHI_C(25.099800796022265), SHI_C(24.454038521274967), SHI_C(23.748684174075834),
    SHI_C(22.978250586152114), SHI_C(22.135943621178654), SHI_C(21.213203435596427),
    SHI_C(20.199009876724155), SHI_C(19.078784028338912), SHI_C(17.832554500127006),
    SHI_C(16.431676725154983), SHI_C(14.832396974191326), SHI_C(12.96148139681572),
    SHI_C(10.677078252031311), SHI_C(7.615773105863909), SHI_C(0.0), SHI_C(21.563858652847824),
    SHI_C(30.463092423455635), SHI_C(30.397368307141328), SHI_C(30.298514815086232),
    SHI_C(30.166206257996713), SHI_C(30.0), SHI_C(29.79932885150268), SHI_C(29.563490998188964),
    SHI_C(29.29163703175362), SHI_C(28.982753492378876), SHI_C(28.635642126552707),
    SHI_C(28.24889378365107), SHI_C(27.820855486487112), SHI_C(27.349588662354687),
    SHI_C(26.832815729997478), SHI_C(26.267851073127396), SHI_C(25.65151067676132),
    SHI_C(24.979991993593593), SHI_C(24.24871130596428), SHI_C(23.45207879911715), SHI_C(22.58317958127243),
    SHI_C(21.633307652783937), SHI_C(20.591260281974), SHI_C(19.44222209522358), SHI_C(18.16590212458495),
    SHI_C(16.73320053068151), SHI_C(15.0996688705415), SHI_C(13.19090595827292), SHI_C(10.862780491200215),
    SHI_C(7.745966692414834), SHI_C(0.0), SHI_C(22.271057451320086), SHI_C(31.464265445104548),
    SHI_C(31.400636936215164), SHI_C(31.304951684997057), SHI_C(31.176914536239792),
    SHI_C(31.016124838541646), SHI_C(30.822070014844883), SHI_C(30.59411708155671),
    SHI_C(30.331501776206203), SHI_C(30.033314835362415), SHI_C(29.698484809834994),
    SHI_C(29.32575659723036), SHI_C(28.91366458960192), SHI_C(28.460498941515414),
    SHI_C(27.964262908219126), SHI_C(27.422618401604176), SHI_C(26.832815729997478),
    SHI_C(26.19160170741759), SHI_C(25.495097567963924), SHI_C(24.73863375370596),
    SHI_C(23.916521486202797), SHI_C(23.021728866442675), SHI_C(22.045407685048602),
    SHI_C(20.97617696340303), SHI_C(19.79898987322333), SHI_C(18.49324200890693), SHI_C(17.029386365926403),
    SHI_C(15.362291495737216), SHI_C(13.416407864998739), SHI_C(11.045361017187261),
    SHI_C(7.874007874011811), SHI_C(0.0), SHI_C(22.978250586152114), SHI_C(32.46536616149585),
    SHI_C(32.4037034920393), SHI_C(32.31098884280702), SHI_C(32.18695387886216), SHI_C(32.03123475609393),
    SHI_C(31.843366656181317), SHI_C(31.622776601683793), SHI_C(31.368774282716245),
    SHI_C(31.080540535840107), SHI_C(30.757112998459398), SHI_C(30.397368307141328), SHI_C(30.0),
    SHI_C(29.563490998188964), SHI_C(29.086079144497972), SHI_C(28.5657137141714), SHI_C(28.0),
    SHI_C(27.386127875258307), SHI_C(26.720778431774775), SHI_C(26.0), SHI_C(25.219040425836983),
    SHI_C(24.372115213907882), SHI_C(23.45207879911715), SHI_C(22.44994432064365),
    SHI_C(21.354156504062622), SHI_C(20.149441679609886), SHI_C(18.81488772222678),
    SHI_C(17.320508075688775), SHI_C(15.620499351813308), SHI_C(13.638181696985855),
    SHI_C(11.224972160321824), SHI_C(8.0), SHI_C(0.0), SHI_C(23.68543856465402), SHI_C(33.46640106136302),
    SHI_C(33.406586176980134), SHI_C(33.31666249791537), SHI_C(33.19638534539566), SHI_C(33.04542328371661),
    SHI_C(32.863353450309965), SHI_C(32.64965543462902), SHI_C(32.4037034920393), SHI_C(32.12475680841802),
    SHI_C(31.811947441173732), SHI_C(31.464265445104548), SHI_C(31.080540535840107),
    SHI_C(30.659419433511783), SHI_C(30.199337741083), SHI_C(29.698484809834994), SHI_C(29.154759474226502),
    SHI_C(28.5657137141714), SHI_C(27.92848008753788), SHI_C(27.23967694375247), SHI_C(26.49528259898354),
    SHI_C(25.69046515733026), SHI_C(24.819347291981714), SHI_C(23.874672772626646),
    SHI_C(22.847319317591726), SHI_C(21.72556098240043), SHI_C(20.493901531919196),
    SHI_C(19.131126469708992), SHI_C(17.60681686165901), SHI_C(15.874507866387544),
    SHI_C(13.856406460551018), SHI_C(11.40175425099138), SHI_C(8.12403840463596), SHI_C(0.0)
};
/* [k]: sqrt(k) */
static const SHI_T SHI_FN(shi_root)[72] = {
    SHI_C(0.0), SHI_C(1.0), SHI_C(1.4142135623730951), SHI_C(1.7320508075688772), SHI_C(2.0),
    SHI_C(2.23606797749979), SHI_C(2.449489742783178), SHI_C(2.6457513110645907), SHI_C(2.8284271247461903),
    SHI_C(3.0), SHI_C(3.1622776601683795), SHI_C(3.3166247903554), SHI_C(3.4641016151377544),
    SHI_C(3.605551275463989), SHI_C(3.7416573867739413), SHI_C(3.872983346207417), SHI_C(4.0),
    SHI_C(4.123105625617661), SHI_C(4.242640687119285), SHI_C(4.358898943540674), SHI_C(4.47213595499958),
    SHI_C(4.58257569495584), SHI_C(4.69041575982343), SHI_C(4.795831523312719), SHI_C(4.898979485566356),
    SHI_C(5.0), SHI_C(5.0990195135927845), SHI_C(5.196152422706632), SHI_C(5.291502622129181),
    SHI_C(5.385164807134504), SHI_C(5.477225575051661), SHI_C(5.5677643628300215), SHI_C(5.656854249492381),
    SHI_C(5.744562646538029), SHI_C(5.830951894845301), SHI_C(5.916079783099616), SHI_C(6.0),
    SHI_C(6.082762530298219), SHI_C(6.164414002968976), SHI_C(6.244997998398398), SHI_C(6.324555320336759),
    SHI_C(6.4031242374328485), SHI_C(6.48074069840786), SHI_C(6.557438524302), SHI_C(6.6332495807108),
    SHI_C(6.708203932499369), SHI_C(6.782329983125268), SHI_C(6.855654600401044), SHI_C(6.928203230275509),
    SHI_C(7.0), SHI_C(7.0710678118654755), SHI_C(7.14142842854285), SHI_C(7.211102550927978),
    SHI_C(7.280109889280518), SHI_C(7.3484692283495345), SHI_C(7.416198487095663), SHI_C(7.483314773547883),
    SHI_C(7.54983443527075), SHI_C(7.615773105863909), SHI_C(7.681145747868608), SHI_C(7.745966692414834),
    SHI_C(7.810249675906654), SHI_C(7.874007874011811), SHI_C(7.937253933193772), SHI_C(8.0),
    SHI_C(8.06225774829855), SHI_C(8.12403840463596), SHI_C(8.18535277187245), SHI_C(8.246211251235321),
    SHI_C(8.306623862918075), SHI_C(8.366600265340756), SHI_C(8.426149773176359)
};
/* [l]: 1/sqrt(4 l^2 - 1), l >= 1 */
static const SHI_T SHI_FN(shi_inverse_root)[36] = {
    SHI_C(0.0), SHI_C(0.5773502691896257), SHI_C(0.25819888974716115), SHI_C(0.1690308509457033),
    SHI_C(0.12598815766974242), SHI_C(0.10050378152592121), SHI_C(0.08362420100070908),
    SHI_C(0.07161148740394328), SHI_C(0.06262242910851495), SHI_C(0.055641488407465724),
    SHI_C(0.05006261743217589), SHI_C(0.045501575519329006), SHI_C(0.04170288281141495),
    SHI_C(0.03849001794597505), SHI_C(0.03573708449459316), SHI_C(0.033351867298253506),
    SHI_C(0.03126526997403612), SHI_C(0.029424494316824985), SHI_C(0.027788500718836418),
    SHI_C(0.02632490632463282), SHI_C(0.025007816164017767), SHI_C(0.023816275411477045),
    SHI_C(0.022733144649015782), SHI_C(0.021744269101781406), SHI_C(0.02083785592827065),
    SHI_C(0.02000400120040014), SHI_C(0.019234326202820506), SHI_C(0.018521694664415903),
    SHI_C(0.017859990659227328), SHI_C(0.01724394251251618), SHI_C(0.016668981963846228),
    SHI_C(0.016131130616527576), SHI_C(0.015626907697949846), SHI_C(0.01515325460564539),
    SHI_C(0.014707472779848216), SHI_C(0.014287172234821078)
};
/* [9 l]: l, l+1, 1-2l, 1/l, 1/(l(l+1)), 2l+1, l^2-1, l(l+1), l(l+2); quotients for l >= 1 */
static const SHI_T SHI_FN(shi_profile)[288] = {
    SHI_C(0.0), SHI_C(1.0), SHI_C(1.0), SHI_C(1.0), SHI_C(0.5), SHI_C(1.0), SHI_C(-1.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(1.0), SHI_C(2.0), SHI_C(-1.0), SHI_C(1.0), SHI_C(0.5), SHI_C(3.0), SHI_C(0.0),
    SHI_C(2.0), SHI_C(3.0), SHI_C(2.0), SHI_C(3.0), SHI_C(-3.0), SHI_C(0.5), SHI_C(0.16666666666666666),
    SHI_C(5.0), SHI_C(3.0), SHI_C(6.0), SHI_C(8.0), SHI_C(3.0), SHI_C(4.0), SHI_C(-5.0),
    SHI_C(0.3333333333333333), SHI_C(0.08333333333333333), SHI_C(7.0), SHI_C(8.0), SHI_C(12.0), SHI_C(15.0),
    SHI_C(4.0), SHI_C(5.0), SHI_C(-7.0), SHI_C(0.25), SHI_C(0.05), SHI_C(9.0), SHI_C(15.0), SHI_C(20.0),
    SHI_C(24.0), SHI_C(5.0), SHI_C(6.0), SHI_C(-9.0), SHI_C(0.2), SHI_C(0.03333333333333333), SHI_C(11.0),
    SHI_C(24.0), SHI_C(30.0), SHI_C(35.0), SHI_C(6.0), SHI_C(7.0), SHI_C(-11.0), SHI_C(0.16666666666666666),
    SHI_C(0.023809523809523808), SHI_C(13.0), SHI_C(35.0), SHI_C(42.0), SHI_C(48.0), SHI_C(7.0), SHI_C(8.0),
    SHI_C(-13.0), SHI_C(0.14285714285714285), SHI_C(0.017857142857142856), SHI_C(15.0), SHI_C(48.0),
    SHI_C(56.0), SHI_C(63.0), SHI_C(8.0), SHI_C(9.0), SHI_C(-15.0), SHI_C(0.125),
    SHI_C(0.013888888888888888), SHI_C(17.0), SHI_C(63.0), SHI_C(72.0), SHI_C(80.0), SHI_C(9.0),
    SHI_C(10.0), SHI_C(-17.0), SHI_C(0.1111111111111111), SHI_C(0.011111111111111112), SHI_C(19.0),
    SHI_C(80.0), SHI_C(90.0), SHI_C(99.0), SHI_C(10.0), SHI_C(11.0), SHI_C(-19.0), SHI_C(0.1),
    SHI_C(0.00909090909090909), SHI_C(21.0), SHI_C(99.0), SHI_C(110.0), SHI_C(120.0), SHI_C(11.0),
    SHI_C(12.0), SHI_C(-21.0), SHI_C(0.09090909090909091), SHI_C(0.007575757575757576), SHI_C(23.0),
    SHI_C(120.0), SHI_C(132.0), SHI_C(143.0), SHI_C(12.0), SHI_C(13.0), SHI_C(-23.0),
    SHI_C(0.08333333333333333), SHI_C(0.00641025641025641), SHI_C(25.0), SHI_C(143.0), SHI_C(156.0),
    SHI_C(168.0), SHI_C(13.0), SHI_C(14.0), SHI_C(-25.0), SHI_C(0.07692307692307693),
    SHI_C(0.005494505494505495), SHI_C(27.0), SHI_C(168.0), SHI_C(182.0), SHI_C(195.0), SHI_C(14.0),
    SHI_C(15.0), SHI_C(-27.0), SHI_C(0.07142857142857142), SHI_C(0.004761904761904762), SHI_C(29.0),
    SHI_C(195.0), SHI_C(210.0), SHI_C(224.0), SHI_C(15.0), SHI_C(16.0), SHI_C(-29.0),
    SHI_C(0.06666666666666667), SHI_C(0.004166666666666667), SHI_C(31.0), SHI_C(224.0), SHI_C(240.0),
    SHI_C(255.0), SHI_C(16.0), SHI_C(17.0), SHI_C(-31.0), SHI_C(0.0625), SHI_C(0.003676470588235294),
    SHI_C(33.0), SHI_C(255.0), SHI_C(272.0), SHI_C(288.0), SHI_C(17.0), SHI_C(18.0), SHI_C(-33.0),
    SHI_C(0.058823529411764705), SHI_C(0.0032679738562091504), SHI_C(35.0), SHI_C(288.0), SHI_C(306.0),
    SHI_C(323.0), SHI_C(18.0), SHI_C(19.0), SHI_C(-35.0), SHI_C(0.05555555555555555),
    SHI_C(0.0029239766081871343), SHI_C(37.0), SHI_C(323.0), SHI_C(342.0), SHI_C(360.0), SHI_C(19.0),
    SHI_C(20.0), SHI_C(-37.0), SHI_C(0.05263157894736842), SHI_C(0.002631578947368421), SHI_C(39.0),
    SHI_C(360.0), SHI_C(380.0), SHI_C(399.0), SHI_C(20.0), SHI_C(21.0), SHI_C(-39.0), SHI_C(0.05),
    SHI_C(0.002380952380952381), SHI_C(41.0), SHI_C(399.0), SHI_C(420.0), SHI_C(440.0), SHI_C(21.0),
    SHI_C(22.0), SHI_C(-41.0), SHI_C(0.047619047619047616), SHI_C(0.0021645021645021645), SHI_C(43.0),
    SHI_C(440.0), SHI_C(462.0), SHI_C(483.0), SHI_C(22.0), SHI_C(23.0), SHI_C(-43.0),
    SHI_C(0.045454545454545456), SHI_C(0.001976284584980237), SHI_C(45.0), SHI_C(483.0), SHI_C(506.0),
    SHI_C(528.0), SHI_C(23.0), SHI_C(24.0), SHI_C(-45.0), SHI_C(0.043478260869565216),
    SHI_C(0.0018115942028985507), SHI_C(47.0), SHI_C(528.0), SHI_C(552.0), SHI_C(575.0), SHI_C(24.0),
    SHI_C(25.0), SHI_C(-47.0), SHI_C(0.041666666666666664), SHI_C(0.0016666666666666668), SHI_C(49.0),
    SHI_C(575.0), SHI_C(600.0), SHI_C(624.0), SHI_C(25.0), SHI_C(26.0), SHI_C(-49.0), SHI_C(0.04),
    SHI_C(0.0015384615384615385), SHI_C(51.0), SHI_C(624.0), SHI_C(650.0), SHI_C(675.0), SHI_C(26.0),
    SHI_C(27.0), SHI_C(-51.0), SHI_C(0.038461538461538464), SHI_C(0.0014245014245014246), SHI_C(53.0),
    SHI_C(675.0), SHI_C(702.0), SHI_C(728.0), SHI_C(27.0), SHI_C(28.0), SHI_C(-53.0),
    SHI_C(0.037037037037037035), SHI_C(0.0013227513227513227), SHI_C(55.0), SHI_C(728.0), SHI_C(756.0),
    SHI_C(783.0), SHI_C(28.0), SHI_C(29.0), SHI_C(-55.0), SHI_C(0.03571428571428571),
    SHI_C(0.0012315270935960591), SHI_C(57.0), SHI_C(783.0), SHI_C(812.0), SHI_C(840.0), SHI_C(29.0),
    SHI_C(30.0), SHI_C(-57.0), SHI_C(0.034482758620689655), SHI_C(0.0011494252873563218), SHI_C(59.0),
    SHI_C(840.0), SHI_C(870.0), SHI_C(899.0), SHI_C(30.0), SHI_C(31.0), SHI_C(-59.0),
    SHI_C(0.03333333333333333), SHI_C(0.001075268817204301), SHI_C(61.0), SHI_C(899.0), SHI_C(930.0),
    SHI_C(960.0), SHI_C(31.0), SHI_C(32.0), SHI_C(-61.0), SHI_C(0.03225806451612903),
    SHI_C(0.0010080645161290322), SHI_C(63.0), SHI_C(960.0), SHI_C(992.0), SHI_C(1023.0)
};
/* [l]: Y_l0(+z) = sqrt((2l+1)/(4 pi)) */
static const SHI_T SHI_FN(shi_zonal)[34] = {
    SHI_C(0.28209479177387814), SHI_C(0.4886025119029199), SHI_C(0.63078313050504),
    SHI_C(0.7463526651802308), SHI_C(0.8462843753216345), SHI_C(0.9356025796273888),
    SHI_C(1.0171072362820548), SHI_C(1.0925484305920792), SHI_C(1.1631066229203195),
    SHI_C(1.2296226898414837), SHI_C(1.2927207364566027), SHI_C(1.3528790949515024),
    SHI_C(1.4104739588693906), SHI_C(1.4658075357087597), SHI_C(1.5191269449366245),
    SHI_C(1.5706373285785544), SHI_C(1.6205112036071436), SHI_C(1.6688952945311364),
    SHI_C(1.7159156293944244), SHI_C(1.761681409986482), SHI_C(1.8062879984608917),
    SHI_C(1.8498192550829797), SHI_C(1.89234939151512), SHI_C(1.9339444569737623), SHI_C(1.974663542417147),
    SHI_C(2.014559765517849), SHI_C(2.0536810833075387), SHI_C(2.0920709679710012),
    SHI_C(2.129768972944957), SHI_C(2.1668112103298047), SHI_C(2.203230756026887),
    SHI_C(2.2390579955406924), SHI_C(2.274320920733615), SHI_C(2.309045385777095)
};
/* [100 k + l(l+1) + m]: q_l^|m| = z^((l-m)&1) sum_k c_k (z^2 - 1/2)^k, norm included; and room to read a register */
static const SHI_T SHI_FN(shi_horner)[516] = {
    SHI_C(0.28209479177387814), SHI_C(0.4886025119029199), SHI_C(0.4886025119029199),
    SHI_C(0.4886025119029199), SHI_C(0.5462742152960396), SHI_C(1.0925484305920792),
    SHI_C(0.15769578262626), SHI_C(1.0925484305920792), SHI_C(0.5462742152960396),
    SHI_C(0.5900435899266435), SHI_C(1.4453057213202771), SHI_C(0.6855686991966986),
    SHI_C(-0.1865881662950577), SHI_C(0.6855686991966986), SHI_C(1.4453057213202771),
    SHI_C(0.5900435899266435), SHI_C(0.6258357354491761), SHI_C(1.7701307697799304),
    SHI_C(1.18271836969695), SHI_C(0.3345232717786446), SHI_C(-0.343803027474414),
    SHI_C(0.3345232717786446), SHI_C(1.18271836969695), SHI_C(1.7701307697799304),
    SHI_C(0.6258357354491761), SHI_C(0.6563820568401701), SHI_C(2.075662314881041),
    SHI_C(1.7123340480233764), SHI_C(1.198384196243331), SHI_C(-0.3397099883967727),
    SHI_C(-0.4970388704270503), SHI_C(-0.3397099883967727), SHI_C(1.198384196243331),
    SHI_C(1.7123340480233764), SHI_C(2.075662314881041), SHI_C(0.6563820568401701),
    SHI_C(0.6831841051919143), SHI_C(2.366619162231752), SHI_C(2.2705420532792586),
    SHI_C(2.3030131487873087), SHI_C(0.11515065743936544), SHI_C(-1.0195873844077799),
    SHI_C(-0.1509768553856175), SHI_C(-1.0195873844077799), SHI_C(0.11515065743936544),
    SHI_C(2.3030131487873087), SHI_C(2.2705420532792586), SHI_C(2.366619162231752),
    SHI_C(0.6831841051919143), SHI_C(0.7071627325245962), SHI_C(2.6459606618019), SHI_C(2.854035682961432),
    SHI_C(3.6324090510418223), SHI_C(0.8996388697081907), SHI_C(-0.9403819714455881),
    SHI_C(-0.6887785078166945), SHI_C(0.1963172961220142), SHI_C(-0.6887785078166945),
    SHI_C(-0.9403819714455881), SHI_C(0.8996388697081907), SHI_C(3.6324090510418223),
    SHI_C(2.854035682961432), SHI_C(2.6459606618019), SHI_C(0.7071627325245962), SHI_C(0.7289266601748299),
    SHI_C(2.9157066406993195), SHI_C(3.4601629793870265), SHI_C(5.174865933147162),
    SHI_C(2.0332702302271555), SHI_C(-0.30881653882388604), SHI_C(-1.08336161378291),
    SHI_C(-0.3680142049083823), SHI_C(0.3470010481466383), SHI_C(-0.3680142049083823),
    SHI_C(-1.08336161378291), SHI_C(-0.30881653882388604), SHI_C(2.0332702302271555),
    SHI_C(5.174865933147162), SHI_C(3.4601629793870265), SHI_C(2.9157066406993195),
    SHI_C(0.7289266601748299), SHI_C(0.7489009518531883), SHI_C(3.1773176489546975),
    SHI_C(4.086791110080399), SHI_C(6.921229179411617), SHI_C(3.5334925230328844),
    SHI_C(1.0194248096822933), SHI_C(-1.2119848650425105), SHI_C(-1.2846015040594343),
    SHI_C(0.31818174868912225), SHI_C(0.49653220922798197), SHI_C(0.31818174868912225),
    SHI_C(-1.2846015040594343), SHI_C(-1.2119848650425105), SHI_C(1.0194248096822933),
    SHI_C(3.5334925230328844), SHI_C(6.921229179411617), SHI_C(4.086791110080399),
    SHI_C(3.1773176489546975), SHI_C(0.7489009518531883), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.94617469575756), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(2.2852289973223288), SHI_C(1.865881662950577), SHI_C(2.2852289973223288), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(3.3116114351514603), SHI_C(4.683325804901024), SHI_C(0.5289277345760215),
    SHI_C(4.683325804901024), SHI_C(3.3116114351514603), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(4.403144694917254), SHI_C(7.190305177459986), SHI_C(3.1706265583698783),
    SHI_C(-0.8186522571739652), SHI_C(3.1706265583698783), SHI_C(7.190305177459986),
    SHI_C(4.403144694917254), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(5.550213908015966),
    SHI_C(10.133257854664159), SHI_C(6.909039446361926), SHI_C(1.7478640875561942),
    SHI_C(-2.3361681833353445), SHI_C(1.7478640875561942), SHI_C(6.909039446361926),
    SHI_C(10.133257854664159), SHI_C(5.550213908015966), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(6.745902523363384), SHI_C(13.491805046726768), SHI_C(12.04733790739664), SHI_C(7.301789425342213),
    SHI_C(-3.455183990031287), SHI_C(-3.840990576300278), SHI_C(-3.455183990031287),
    SHI_C(7.301789425342213), SHI_C(12.04733790739664), SHI_C(13.491805046726768), SHI_C(6.745902523363384),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(7.9849914908931385), SHI_C(17.24955311049054),
    SHI_C(18.658244465613897), SHI_C(16.058460018842073), SHI_C(-1.254418710696001),
    SHI_C(-8.6960393604277), SHI_C(-1.104042614725147), SHI_C(-8.6960393604277), SHI_C(-1.254418710696001),
    SHI_C(16.058460018842073), SHI_C(18.658244465613897), SHI_C(17.24955311049054),
    SHI_C(7.9849914908931385), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(9.263393182848905),
    SHI_C(21.392890190908638), SHI_C(26.80580534714602), SHI_C(28.543894671104216),
    SHI_C(4.501658070157895), SHI_C(-9.82342326633685), SHI_C(-6.025315139733252),
    SHI_C(1.6378958485779138), SHI_C(-6.025315139733252), SHI_C(-9.82342326633685),
    SHI_C(4.501658070157895), SHI_C(28.543894671104216), SHI_C(26.80580534714602),
    SHI_C(21.392890190908638), SHI_C(9.263393182848905), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(3.7024941420321507), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(9.511879675109636), SHI_C(7.367870314565686),
    SHI_C(9.511879675109636), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(15.199886781996238), SHI_C(19.226504963118135), SHI_C(2.0024298714302953),
    SHI_C(19.226504963118135), SHI_C(15.199886781996238), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(22.373627542308046), SHI_C(31.64108750981626),
    SHI_C(13.414243726003821), SHI_C(-3.3800717071442445), SHI_C(13.414243726003821),
    SHI_C(31.64108750981626), SHI_C(22.373627542308046), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(31.097074109356495), SHI_C(48.17538005652622),
    SHI_C(32.614886478096025), SHI_C(7.796449081762767), SHI_C(-13.044059040641551),
    SHI_C(7.796449081762767), SHI_C(32.614886478096025), SHI_C(48.17538005652622),
    SHI_C(31.097074109356495), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(41.427153718316575), SHI_C(69.32088705839595), SHI_C(63.023212982210545),
    SHI_C(35.36432375881266), SHI_C(-23.037969651921255), SHI_C(-22.666365130320163),
    SHI_C(-23.037969651921255), SHI_C(35.36432375881266), SHI_C(63.023212982210545),
    SHI_C(69.32088705839595), SHI_C(41.427153718316575), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(14.684485723822167), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(38.75225965289993), SHI_C(29.29395479525012), SHI_C(38.75225965289993), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(65.22977295619205), SHI_C(77.96449081762766), SHI_C(7.796449081762767),
    SHI_C(77.96449081762766), SHI_C(65.22977295619205), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(102.03758292357897), SHI_C(133.59855642218116), SHI_C(55.29112716461101),
    SHI_C(-13.737190988072825), SHI_C(55.29112716461101), SHI_C(133.59855642218116),
    SHI_C(102.03758292357897), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(58.47336811322075), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(156.65819363306454), SHI_C(116.76612339861902), SHI_C(156.65819363306454),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0)
};
/* [k(31-k) + m]: 1/2 - node k < (31-m)/2 of column m's form of Newton; and room to read a register */
static const SHI_T SHI_FN(shi_node)[256] = {
    SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5),
    SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5),
    SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5),
    SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(0.5), SHI_C(-0.5),
    SHI_C(-0.2998046875), SHI_C(-0.1669921875), SHI_C(-0.0712890625), SHI_C(0.0), SHI_C(0.0556640625),
    SHI_C(0.099609375), SHI_C(0.13671875), SHI_C(0.1669921875), SHI_C(0.1923828125), SHI_C(0.2138671875),
    SHI_C(0.2333984375), SHI_C(0.25), SHI_C(0.2646484375), SHI_C(0.27734375), SHI_C(0.2890625),
    SHI_C(0.2998046875), SHI_C(0.3095703125), SHI_C(0.318359375), SHI_C(0.326171875), SHI_C(0.3330078125),
    SHI_C(0.33984375), SHI_C(0.345703125), SHI_C(0.3515625), SHI_C(0.357421875), SHI_C(0.3623046875),
    SHI_C(0.3662109375), SHI_C(0.37109375), SHI_C(0.0), SHI_C(0.1318359375), SHI_C(0.205078125),
    SHI_C(0.25390625), SHI_C(0.2890625), SHI_C(-0.2373046875), SHI_C(-0.1923828125), SHI_C(-0.1513671875),
    SHI_C(-0.1142578125), SHI_C(-0.0810546875), SHI_C(-0.0517578125), SHI_C(-0.0244140625), SHI_C(0.0),
    SHI_C(0.0224609375), SHI_C(0.04296875), SHI_C(0.0615234375), SHI_C(0.0791015625), SHI_C(0.095703125),
    SHI_C(0.1103515625), SHI_C(0.1240234375), SHI_C(0.13671875), SHI_C(0.1494140625), SHI_C(0.16015625),
    SHI_C(0.1708984375), SHI_C(0.1806640625), SHI_C(0.1904296875), SHI_C(0.2890625), SHI_C(-0.470703125),
    SHI_C(-0.423828125), SHI_C(-0.375), SHI_C(-0.3291015625), SHI_C(0.3486328125), SHI_C(0.36328125),
    SHI_C(0.3759765625), SHI_C(0.38671875), SHI_C(0.3955078125), SHI_C(0.40234375), SHI_C(0.4091796875),
    SHI_C(0.4150390625), SHI_C(0.419921875), SHI_C(0.423828125), SHI_C(0.4287109375), SHI_C(0.431640625),
    SHI_C(0.435546875), SHI_C(0.4384765625), SHI_C(0.4404296875), SHI_C(0.443359375), SHI_C(0.4453125),
    SHI_C(0.447265625), SHI_C(0.44921875), SHI_C(-0.3291015625), SHI_C(0.36328125), SHI_C(0.3896484375),
    SHI_C(0.4072265625), SHI_C(0.419921875), SHI_C(-0.3896484375), SHI_C(-0.359375), SHI_C(-0.3310546875),
    SHI_C(-0.302734375), SHI_C(-0.2763671875), SHI_C(-0.2509765625), SHI_C(-0.2265625),
    SHI_C(-0.2041015625), SHI_C(-0.1826171875), SHI_C(-0.162109375), SHI_C(-0.142578125), SHI_C(-0.125),
    SHI_C(-0.107421875), SHI_C(-0.0908203125), SHI_C(-0.0751953125), SHI_C(-0.060546875),
    SHI_C(-0.0458984375), SHI_C(0.419921875), SHI_C(-0.0966796875), SHI_C(-0.3115234375),
    SHI_C(-0.2451171875), SHI_C(-0.4345703125), SHI_C(0.4423828125), SHI_C(0.248046875),
    SHI_C(0.2705078125), SHI_C(0.2890625), SHI_C(0.3046875), SHI_C(0.09375), SHI_C(0.1162109375),
    SHI_C(0.1357421875), SHI_C(0.1533203125), SHI_C(0.1689453125), SHI_C(0.18359375), SHI_C(0.197265625),
    SHI_C(0.2099609375), SHI_C(0.220703125), SHI_C(0.2314453125), SHI_C(-0.4345703125), SHI_C(0.4482421875),
    SHI_C(0.0361328125), SHI_C(-0.4658203125), SHI_C(-0.15234375), SHI_C(-0.0859375), SHI_C(0.4560546875),
    SHI_C(-0.0185546875), SHI_C(0.013671875), SHI_C(-0.3798828125), SHI_C(0.46484375), SHI_C(0.4677734375),
    SHI_C(0.4697265625), SHI_C(-0.3115234375), SHI_C(-0.294921875), SHI_C(-0.2783203125),
    SHI_C(-0.2626953125), SHI_C(-0.2470703125), SHI_C(-0.15234375), SHI_C(-0.40625), SHI_C(-0.484375),
    SHI_C(0.1142578125), SHI_C(0.1611328125), SHI_C(0.2138671875), SHI_C(-0.4365234375), SHI_C(0.462890625),
    SHI_C(-0.4052734375), SHI_C(0.466796875), SHI_C(-0.369140625), SHI_C(-0.3515625), SHI_C(-0.3349609375),
    SHI_C(0.4716796875), SHI_C(0.4736328125), SHI_C(0.474609375), SHI_C(0.1611328125), SHI_C(0.2431640625),
    SHI_C(0.4609375), SHI_C(0.466796875), SHI_C(0.4716796875), SHI_C(-0.45703125), SHI_C(-0.05078125),
    SHI_C(-0.4248046875), SHI_C(0.466796875), SHI_C(0.0419921875), SHI_C(0.314453125), SHI_C(0.326171875),
    SHI_C(-0.1044921875), SHI_C(-0.0830078125), SHI_C(0.4716796875), SHI_C(-0.49609375), SHI_C(0.296875),
    SHI_C(-0.1611328125), SHI_C(-0.4765625), SHI_C(0.4794921875), SHI_C(-0.2763671875),
    SHI_C(-0.2451171875), SHI_C(-0.2138671875), SHI_C(-0.185546875), SHI_C(-0.1591796875),
    SHI_C(-0.134765625), SHI_C(-0.4765625), SHI_C(0.009765625), SHI_C(-0.0732421875), SHI_C(0.3330078125),
    SHI_C(-0.2392578125), SHI_C(-0.314453125), SHI_C(0.416015625), SHI_C(0.42578125), SHI_C(0.431640625),
    SHI_C(-0.4404296875), SHI_C(-0.2392578125), SHI_C(0.4814453125), SHI_C(-0.3740234375),
    SHI_C(-0.4296875), SHI_C(0.3564453125), SHI_C(0.138671875), SHI_C(0.171875), SHI_C(-0.46484375),
    SHI_C(0.3564453125), SHI_C(-0.2109375), SHI_C(0.4853515625), SHI_C(0.0302734375), SHI_C(0.078125),
    SHI_C(-0.16015625), SHI_C(0.078125), SHI_C(0.3056640625), SHI_C(0.119140625), SHI_C(-0.4912109375),
    SHI_C(-0.38671875), SHI_C(-0.3603515625), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0), SHI_C(0.0),
    SHI_C(0.0), SHI_C(0.0), SHI_C(0.0)
};
/* [l(l+1) + m]: shi_slope by coefficient */
static const SHI_T SHI_FN(shi_line_slope)[100] = {
    SHI_C(0.0), SHI_C(0.0), SHI_C(1.0), SHI_C(0.0), SHI_C(0.0), SHI_C(2.0), SHI_C(1.7320508075688772),
    SHI_C(2.0), SHI_C(0.0), SHI_C(0.0), SHI_C(2.449489742783178), SHI_C(3.1622776601683795),
    SHI_C(2.449489742783178), SHI_C(3.1622776601683795), SHI_C(2.449489742783178), SHI_C(0.0), SHI_C(0.0),
    SHI_C(2.8284271247461903), SHI_C(3.7416573867739413), SHI_C(4.242640687119285),
    SHI_C(3.1622776601683795), SHI_C(4.242640687119285), SHI_C(3.7416573867739413),
    SHI_C(2.8284271247461903), SHI_C(0.0), SHI_C(0.0), SHI_C(3.1622776601683795), SHI_C(4.242640687119285),
    SHI_C(4.898979485566356), SHI_C(5.291502622129181), SHI_C(3.872983346207417), SHI_C(5.291502622129181),
    SHI_C(4.898979485566356), SHI_C(4.242640687119285), SHI_C(3.1622776601683795), SHI_C(0.0), SHI_C(0.0),
    SHI_C(3.4641016151377544), SHI_C(4.69041575982343), SHI_C(5.477225575051661), SHI_C(6.0),
    SHI_C(6.324555320336759), SHI_C(4.58257569495584), SHI_C(6.324555320336759), SHI_C(6.0),
    SHI_C(5.477225575051661), SHI_C(4.69041575982343), SHI_C(3.4641016151377544), SHI_C(0.0), SHI_C(0.0),
    SHI_C(3.7416573867739413), SHI_C(5.0990195135927845), SHI_C(6.0), SHI_C(6.6332495807108),
    SHI_C(7.0710678118654755), SHI_C(7.3484692283495345), SHI_C(5.291502622129181),
    SHI_C(7.3484692283495345), SHI_C(7.0710678118654755), SHI_C(6.6332495807108), SHI_C(6.0),
    SHI_C(5.0990195135927845), SHI_C(3.7416573867739413), SHI_C(0.0), SHI_C(0.0), SHI_C(4.0),
    SHI_C(5.477225575051661), SHI_C(6.48074069840786), SHI_C(7.211102550927978), SHI_C(7.745966692414834),
    SHI_C(8.12403840463596), SHI_C(8.366600265340756), SHI_C(6.0), SHI_C(8.366600265340756),
    SHI_C(8.12403840463596), SHI_C(7.745966692414834), SHI_C(7.211102550927978), SHI_C(6.48074069840786),
    SHI_C(5.477225575051661), SHI_C(4.0), SHI_C(0.0), SHI_C(0.0), SHI_C(4.242640687119285),
    SHI_C(5.830951894845301), SHI_C(6.928203230275509), SHI_C(7.745966692414834), SHI_C(8.366600265340756),
    SHI_C(8.831760866327848), SHI_C(9.16515138991168), SHI_C(9.38083151964686), SHI_C(6.708203932499369),
    SHI_C(9.38083151964686), SHI_C(9.16515138991168), SHI_C(8.831760866327848), SHI_C(8.366600265340756),
    SHI_C(7.745966692414834), SHI_C(6.928203230275509), SHI_C(5.830951894845301), SHI_C(4.242640687119285),
    SHI_C(0.0)
};
/* END tools/gen_gradient.py */

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
