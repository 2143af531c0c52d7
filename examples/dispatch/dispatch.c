/* One binary, several instruction sets: the widest that this processor has is picked when the program starts.
 * Prints what each finds for the same lights; they agree to rounding, not to the bit. */
#include "kernels.h"

#include <math.h>
#include <stdio.h>

enum { BANDS = 5, N = BANDS * BANDS, LIGHTS = 100 };

static const struct kernels *pick(const char **name)
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) { *name = "avx512"; return &kernels_avx512; }
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))         { *name = "avx2";   return &kernels_avx2; }
#endif
    *name = "base";
    return &kernels_base;
}

int main(void)
{
    static const float point[3] = { 0.1f, 0.2f, 0.3f };
    static float spheres[4 * LIGHTS], reference[4 * N], out[4 * N];
    const char *name;
    const struct kernels *const best = pick(&name), *const base = &kernels_base;
    float worst = 0;
    int i;
    for (i = 0; i < LIGHTS; i++) {
        const float a = 0.7f * (float)i, b = 0.05f * (float)i;
        spheres[i]              = 3 * cosf(a);
        spheres[LIGHTS + i]     = 3 * sinf(a);
        spheres[2 * LIGHTS + i] = b - 2.5f;
        spheres[3 * LIGHTS + i] = 0.1f;
    }
    if (base->lights(BANDS, point, LIGHTS, spheres, reference) != 0 || best->lights(BANDS, point, LIGHTS, spheres, out) != 0)
        return 1;
    for (i = 0; i < 4 * N; i++) worst = fmaxf(worst, fabsf(out[i] - reference[i]) / fabsf(reference[0]));
    printf("base: %d-byte vectors, L_00 = %.6f\n", base->vector_bytes, (double)reference[0]);
    printf("%s: %d-byte vectors, %d in sums, L_00 = %.6f\n", name, best->vector_bytes, best->wide_bytes, (double)out[0]);
    printf("largest difference %.1e of L_00\n", (double)worst);
    return !(worst < 1e-5f);
}
