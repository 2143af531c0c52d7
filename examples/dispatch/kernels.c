/* The hot calls of a program, compiled once per instruction set: rules.mk builds this file with different -m flags and names.
 * Everything of shlight is static inline, so each object carries its own kernels and nothing collides. */
#include "kernels.h"
#include "sh_gradient.h"

#define JOIN_(a, b) a##b
#define JOIN(a, b)  JOIN_(a, b)

static int lights(int bands, const float point[3], size_t count, const float *spheres, float *out)
{
    return sh_spheres_f32(bands, SH_GRADIENT, 1, point, count, spheres, NULL, out);
}

static int basis(int bands, size_t blocks, const float *dirs, float *y, float *grad)
{
    return sh_eval_grad_blocks_f32(bands, blocks, dirs, y, grad);
}

const struct kernels JOIN(kernels_, ISA) = { SH_VECTOR_BYTES, SH_WIDE_BYTES, lights, basis };
