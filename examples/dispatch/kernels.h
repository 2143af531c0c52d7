#ifndef DISPATCH_KERNELS_H
#define DISPATCH_KERNELS_H

#include <stddef.h>

struct kernels {
    int vector_bytes, wide_bytes;
    int (*lights)(int bands, const float point[3], size_t count, const float *spheres, float *out);    /* out[4][N] */
    int (*basis)(int bands, size_t blocks, const float *dirs, float *y, float *grad);                  /* blocked   */
};

extern const struct kernels kernels_base, kernels_avx2, kernels_avx512;

#endif
