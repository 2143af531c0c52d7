/* both.h - reads the file named by BOTH twice: T float, then T double. */
#define T         float
#define F(name)   name##_f32
#define EPS       FLT_EPSILON
#define PRECISION "f32"
#define IS_F32    1
#include BOTH
#undef  T
#undef  F
#undef  EPS
#undef  PRECISION
#undef  IS_F32
#define T         double
#define F(name)   name##_f64
#define EPS       DBL_EPSILON
#define PRECISION "f64"
#define IS_F32    0
#include BOTH
#undef  T
#undef  F
#undef  EPS
#undef  PRECISION
#undef  IS_F32
