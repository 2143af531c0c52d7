/* fuzz_polygon.c - finite input, finite output: raw bits as coordinates, every call of sh_polygon.h, both
 * precisions.
 *
 *     fuzz_polygon [rounds [seed]]        prints the first offending input and ends with 1
 *     clang -fsanitize=fuzzer,address -DSH_FUZZER ...      the same checks under libFuzzer */
#include "sh_polygon.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static int finite_f32(const float *v, size_t n) { return shi_finite_f32(v, n); }
static int finite_f64(const double *v, size_t n) { return shi_finite_f64(v, n); }

#define FUZZ(T, F) \
    static const char *fuzz##F(const T *in, int vertices, int bands, int sides) \
    { \
        static T c[1024], g[3072], out[2 * 4 * 256 * 2], s[16], gs[48]; \
        const T *const point = in, *const v = in + 3; \
        const size_t n = (size_t)(bands * bands); \
        T omega, error, r[4] = { 1, 2, 3, 4 }; \
        int counts[2], used, status; \
        status = sh_polygon##F(bands, sides, point, (size_t)vertices, v, c, g); \
        if (status < 0) \
            return status == SH_ERROR_NOT_FINITE && !finite##F(in, (size_t)(3 + 3 * vertices)) \
                     ? NULL \
                     : "sh_polygon refuses"; \
        if (!finite##F(c, n) || !finite##F(g, 3 * n)) \
            return finite##F(c, n) ? "sh_polygon gradient" : "sh_polygon"; \
        if (c[0] * c[0] > (T)400 * (T)vertices * (T)vertices) \
            return "sh_polygon, too bright"; \
        if (sh_polygon_solid_angle##F(sides, point, (size_t)vertices, v, &omega, g) < 0 \
            || !finite##F(&omega, 1) || !finite##F(g, 3)) \
            return "sh_polygon_solid_angle"; \
        if (sh_triangle_as_sphere##F(bands, sides, point, v, v + 3, v + 6, c, g, &error) < 0 \
            || !finite##F(c, n) || !finite##F(g, 3 * n) || !finite##F(&error, 1)) \
            return "sh_triangle_as_sphere"; \
        status = sh_polygon_zonal##F(bands, v + 3, point, (size_t)vertices, v, s, gs); \
        if (status >= 0 && (!finite##F(s, (size_t)bands) || !finite##F(gs, 3 * (size_t)bands))) \
            return "sh_polygon_zonal"; \
        if (sh_polygon_within##F(bands, sides, (T)1e-3, point, (size_t)vertices, v, c, g, &error, &used) < 0 \
            || !finite##F(c, n) || !finite##F(g, 3 * n) || !finite##F(&error, 1)) \
            return "sh_polygon_within"; \
        counts[0] = vertices; \
        counts[1] = 3; \
        if (sh_polygons_n##F(bands, SH_GRADIENT, 2, sides, 2, in, 2, counts, v, r, out) < 0 \
            || !finite##F(out, 2 * 2 * 4 * n)) \
            return "sh_polygons_n"; \
        if (sh_polygons_zonal_n##F(bands, SH_GRADIENT, 1, sides, 1, in, 1, counts, v, r, out) < 0 \
            || !finite##F(out, 4 * n)) \
            return "sh_polygons_zonal_n"; \
        return NULL; \
    }
FUZZ(float, _f32)
FUZZ(double, _f64)

/* bytes to coordinates: raw bits, or small grid numbers that meet planes, edges and vertices */
static int run(const uint8_t *data, size_t size)
{
    enum { MOST = 20, NUMBERS = 3 * (1 + MOST + 3) };       /* a point, a polygon, a triangle */
    float f[NUMBERS];
    double d[NUMBERS];
    const char *bad;
    int vertices, bands, sides, kind, i, k;
    if (size < 8) return 0;
    vertices = 3 + data[0] % (data[4] % 2 ? MOST - 2 : 5);
    bands = 1 + data[1] % 16;
    sides = data[2] % 3;
    kind = data[3] % 4;
    for (i = 0; i < NUMBERS; i++) {
        uint64_t bits = 0;
        for (k = 0; k < 8; k++) bits = bits << 8 | data[(4 + (size_t)i * 8 + (size_t)k) % size];
        bits *= 0x9e3779b97f4a7c15u;
        if (kind == 0) {
            const uint32_t low = (uint32_t)(bits >> 32);
            memcpy(&f[i], &low, 4);
            memcpy(&d[i], &bits, 8);
        } else if (kind == 1) {
            f[i] = (float)((int)(bits >> 61) - 4);
            d[i] = (double)((int)(bits >> 61) - 4);
        } else if (kind == 2) {
            f[i] = i % 3 == 2 ? 1.0f : (float)((int)(bits >> 60) - 8) * 0.25f;
            d[i] = (double)f[i];
        } else {
            f[i] = (float)(1 + (double)(bits >> 40) * 1e-9);
            d[i] = 1 + (double)(bits >> 11) * 1e-18;
        }
        if (!shi_finite_f32(&f[i], 1)) f[i] = 3e38f;
        if (!shi_finite_f64(&d[i], 1)) d[i] = 1e308;
    }
    bad = fuzz_f32(f, vertices, bands, sides);
    if (bad) {
        printf("%s_f32: bands %d sides %d vertices %d kind %d:", bad, bands, sides, vertices, kind);
        for (i = 0; i < 12 + 3 * vertices; i++) printf(" %.9g", (double)f[i]);
        printf("\n");
        return 1;
    }
    bad = fuzz_f64(d, vertices, bands, sides);
    if (bad) {
        printf("%s_f64: bands %d sides %d vertices %d kind %d:", bad, bands, sides, vertices, kind);
        for (i = 0; i < 12 + 3 * vertices; i++) printf(" %.17g", d[i]);
        printf("\n");
        return 1;
    }
    return 0;
}

#if defined(SH_FUZZER)
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (run(data, size)) abort();
    return 0;
}
#else
int main(int argc, char **argv)
{
    const long rounds = argc > 1 ? atol(argv[1]) : 2000;
    uint64_t state = argc > 2 ? (uint64_t)atol(argv[2]) : 1;
    uint8_t data[300];
    long r;
    size_t i;
    for (r = 0; r < rounds; r++) {
        for (i = 0; i < sizeof data; i++) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            data[i] = (uint8_t)(state >> 56);
        }
        if (run(data, sizeof data)) {
            printf("round %ld\n", r);
            return 1;
        }
    }
    printf("fuzz_polygon: %ld rounds, every output finite\n", rounds);
    return 0;
}
#endif
