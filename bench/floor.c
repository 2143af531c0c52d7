/* floor.c - what this machine allows: multiply-add rate, store bandwidth into L1 and into memory.
 *
 * Measured beside the kernels, in the same rounds, with the widest registers of the target. */
#include "bench.h"

#include <stdlib.h>

#if defined(__AVX512F__)
#  define BYTES 64
#elif defined(__AVX__)
#  define BYTES 32
#else
#  define BYTES 16
#endif

typedef float vector_f32 __attribute__((vector_size(BYTES)));
typedef double vector_f64 __attribute__((vector_size(BYTES)));

#if defined(__GNUC__)
#  define OPAQUE(p) __asm__ volatile("" : : "r"(p) : "memory")     /* p's memory may be read and written here */
#endif

/* Twelve chains hide the latency of two pipes at 4 cycles and leave registers for the operands. Contraction makes
 * each line one FMA where the target has it; without FMA it is a multiplication and an addition, the same count. */
#define FMA_KERNEL(name, element, vector)                                                                     \
    static element name##_sink[BYTES / sizeof(element)];                                                      \
    static void name##_run(void)                                                                              \
    {                                                                                                         \
        vector a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, k, d, sum;                                   \
        int i;                                                                                                \
        __builtin_memcpy(&k, name##_sink, sizeof k);                                                          \
        k = k * (element)0 + (element)0.999;                                                                  \
        d = k * (element)0.001;                                                                               \
        a0 = a1 = a2 = a3 = a4 = a5 = a6 = a7 = a8 = a9 = a10 = a11 = d;                                      \
        for (i = 0; i < FMA_STEPS; i++) {                                                                     \
            a0 = a0 * k + d; a1 = a1 * k + d; a2 = a2 * k + d; a3 = a3 * k + d;                               \
            a4 = a4 * k + d; a5 = a5 * k + d; a6 = a6 * k + d; a7 = a7 * k + d;                               \
            a8 = a8 * k + d; a9 = a9 * k + d; a10 = a10 * k + d; a11 = a11 * k + d;                           \
            __asm__ volatile("" : "+" REGISTER(a0), "+" REGISTER(a1), "+" REGISTER(a2), "+" REGISTER(a3),     \
                             "+" REGISTER(a4), "+" REGISTER(a5), "+" REGISTER(a6), "+" REGISTER(a7),          \
                             "+" REGISTER(a8), "+" REGISTER(a9), "+" REGISTER(a10), "+" REGISTER(a11));       \
        }                                                                                                     \
        sum = a0 + a1 + a2 + a3 + a4 + a5 + a6 + a7 + a8 + a9 + a10 + a11;                                    \
        __builtin_memcpy(name##_sink, &sum, sizeof sum);                                                      \
    }                                                                                                         \
    bench_floor name(void)                                                                                    \
    {                                                                                                         \
        bench_floor f = { name##_run, 2.0 * 12 * FMA_STEPS * (BYTES / sizeof(element)) };                     \
        return f;                                                                                             \
    }

enum { FMA_STEPS = 1000 };
#if defined(__x86_64__) || defined(__i386__)
#  define REGISTER(a) "x"(a)
#else
#  define REGISTER(a) "w"(a)
#endif
FMA_KERNEL(bench_fma_f32, float, vector_f32)
FMA_KERNEL(bench_fma_f64, double, vector_f64)

static void fill(vector_f32 *p, size_t count, float value)
{
    vector_f32 v = { 0 };
    size_t i;
    v = v + value;
    for (i = 0; i + 4 <= count; i += 4) {
        p[i] = v;
        p[i + 1] = v;
        p[i + 2] = v;
        p[i + 3] = v;
        OPAQUE(p);
    }
}

enum { L1_BYTES = 16384 };
static const size_t dram_bytes = (size_t)128 << 20;     /* beyond the last-level caches this runs on */

static void store_l1_run(void)
{
    static vector_f32 block[L1_BYTES / BYTES];
    fill(block, L1_BYTES / BYTES, 1.5f);
}

static void store_dram_run(void)
{
    static void *block;
    if (!block && posix_memalign(&block, 64, dram_bytes) != 0) abort();
    fill(block, dram_bytes / BYTES, 1.5f);
}

bench_floor bench_store_l1(void)
{
    bench_floor f = { store_l1_run, L1_BYTES };
    return f;
}

bench_floor bench_store_dram(void)
{
    bench_floor f = { store_dram_run, (double)dram_bytes };
    return f;
}
