/* check.c - sh_gradient.h on WebAssembly's 128-bit SIMD, without a C library: vectors against the one-lane double kernels.
 * Exports worst(): the largest error of f32 values, gradients and light sums in eps of their band. tests/wasm/run.sh runs it. */
#include "sh_gradient.h"

void *memcpy(void *to, const void *from, size_t n)
{
    char *t = (char *)to;
    const char *f = (const char *)from;
    while (n--) *t++ = *f++;
    return to;
}
void *memset(void *to, int c, size_t n)
{
    char *t = (char *)to;
    while (n--) *t++ = (char)c;
    return to;
}

enum { BANDS = 6, N = BANDS * BANDS, COUNT = 19 };
static float dirs[3 * COUNT], y[COUNT * N], g[3 * COUNT * N], spheres[4 * COUNT], out[4 * N];
static float many[3 * 100000];
static double d64[3], y64[N], g64[3 * N], s64[4 * COUNT], out64[4 * N];

__attribute__((export_name("worst"))) double worst(void)
{
    static const float point[3] = { 0, 0, 0 };
    static const double point64[3] = { 0, 0, 0 };
    unsigned seed = 1;
    double most = 0;
    int i, k;
    for (i = 0; i < 3 * COUNT; i++) {
        seed = seed * 1664525u + 1013904223u;
        dirs[i] = (float)(seed >> 8) / 8388608.0f - 1;
    }
    for (i = 0; i < COUNT; i++) {
        for (k = 0; k < 3; k++) spheres[k * COUNT + i] = 3 * dirs[3 * i + k];
        spheres[3 * COUNT + i] = 0.01f;
    }
    for (i = 0; i < 4 * COUNT; i++) s64[i] = (double)spheres[i];
    if (sh_eval_grad_n_f32(BANDS, COUNT, dirs, y, g) || sh_spheres_f32(BANDS, SH_GRADIENT, 1, point, COUNT, spheres, NULL, out)
        || sh_spheres_f64(BANDS, SH_GRADIENT, 1, point64, COUNT, s64, NULL, out64)) return -1;
    {   /* as many items as 32-bit addresses hold, not as many as the largest item leaves room for */
        const sh_grid_f32 grid = { { 0, 0, 0 }, { 1, 1, 1 }, { 48, 48, 48 } };
        for (i = 0; i < 100000; i++) many[3 * i] = 1;
        if (sh_project_n_f32(2, 100000, many, many, y) || sh_reconstruct_n_f32(2, y, 100000, many, many, NULL) != SH_ERROR_OVERLAP
            || sh_spheres_grid_f32(BANDS, SH_GRADIENT, 1, &grid, 48 * 48 * 48 - 1, 1, COUNT, spheres, NULL, out)
            || sh_eval_n_f32(BANDS, (size_t)-1 / 256, dirs, y) != SH_ERROR_COUNT) return -3;
        if (sh_eval_grad_n_f32(BANDS, COUNT, dirs, y, g) || sh_spheres_f32(BANDS, SH_GRADIENT, 1, point, COUNT, spheres, NULL, out)) return -4;
    }
    for (i = 0; i < COUNT; i++) {
        const double length = __builtin_sqrt((double)dirs[3 * i] * (double)dirs[3 * i] + (double)dirs[3 * i + 1] * (double)dirs[3 * i + 1]
                                             + (double)dirs[3 * i + 2] * (double)dirs[3 * i + 2]);
        for (k = 0; k < 3; k++) d64[k] = (double)dirs[3 * i + k];
        if (sh_eval_grad_f64(BANDS, d64, y64, g64)) return -2;
        for (k = 0; k < 4 * N; k++) {
            const double e = k < N ? (double)y[i * N + k] - y64[k] : ((double)g[i * 3 * N + k - N] - g64[k - N]) * length / BANDS;
            if (!(__builtin_fabs(e) <= most)) most = __builtin_fabs(e);
        }
    }
    for (k = 0; k < 4 * N; k++) {
        const double e = __builtin_fabs((double)out[k] - out64[k]) / out64[0];
        if (!(e <= most)) most = e;
    }
    return most / 1.1920929e-7;
}
