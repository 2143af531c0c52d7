/* bench.h - the benchmark's harness: cases, interleaved timing, checks, tables.
 *
 * A suite registers cases; the harness then
 *   1. runs each once and compares what it wrote with the first case registered for the same kernel and bands
 *      (the library's), so that a wrong baseline fails before it is timed;
 *   2. finds for each the number of calls that takes a few tens of microseconds: one sample;
 *   3. goes round-robin over all cases, one sample each, until the suite's time is used up: what slows the machine
 *      down for a while slows every case, and ratios survive;
 *   4. prints minimum ns per item by bands with the ratio to the kernel's base, and appends CSV rows.
 *
 * Suites are compiled once per precision (BENCH_PRECISION 32 or 64), the harness once.
 */
#ifndef BENCH_H
#define BENCH_H

#include <stddef.h>

enum {
    BENCH_OUTPUTS = 3,          /* arrays a case may write */
    BENCH_PLANES = 10,          /* parts of one of them */
    BENCH_MAX_THREADS = 256
};

typedef struct bench_output {
    void *data;
    size_t numbers;             /* per item held */
    size_t planes;              /* they consist of: each is compared by its own largest number; 0 means 1 */
} bench_output;

typedef struct bench_case {
    const char *kernel, *impl;
    int bands;
    size_t items;               /* processed by one call of run; times are per item */
    void (*run)(const struct bench_case *self);
    const void *input;          /* the suite's own */
    bench_output out[BENCH_OUTPUTS];
    size_t held;                /* items whose outputs are in out after a call */
    size_t lanes;               /* layout of out: [held/lanes][numbers][lanes]; 0 means 1 */
    double tolerance;           /* of the check, relative to the largest of the plane; 0: no check */
    double flops, bytes;        /* per item: arithmetic done, numbers stored; 0: not counted */
    int group;                  /* cases are compared within a group */
    int column;                 /* of the printed table, where that is not the bands */
} bench_case;

typedef struct bench_options {
    double seconds;             /* per suite and precision */
    int quick, check_only, verbose;
} bench_options;

extern bench_options bench_option;

/* Starts a suite: clears the cases, adds the floors. `item` names what times are per, `regime` where output goes. */
void bench_suite(const char *name, int precision, const char *item, const char *regime);
void bench_add(const bench_case *c);
/* The impl that ratios of this kernel are taken to. */
void bench_base(const char *kernel, const char *impl);
/* Checks, times, prints, writes CSV, frees what bench_alloc gave out. */
void bench_run(void);

/* 64-byte aligned, zeroed, freed by bench_run; never NULL. */
void *bench_alloc(size_t count, size_t size);
/* Uniform in [0, 1): the same sequence in every run. */
double bench_random(void);
double bench_seconds(void);
int bench_failures(void);
/* Minimum ns per item, or 0 when that case did not run. */
double bench_minimum(const char *suite, const char *kernel, const char *impl, int precision, int bands);
void bench_open(const char *csv_path);
void bench_close(void);
const char *bench_isa(void);
const char *bench_compiler(void);
/* Prints targets and measurements; writes them to path unless it is NULL. */
void bench_must_reach(const char *path);
/* Arithmetic per light of the moment form; see targets.c for how it is counted. */
double bench_light_flops(int bands, int planes);

#define BENCH_DECLARE(name) void name##_f32(void); void name##_f64(void)
BENCH_DECLARE(bench_basis);
BENCH_DECLARE(bench_stream);
BENCH_DECLARE(bench_lights);
BENCH_DECLARE(bench_grid);
BENCH_DECLARE(bench_polygon);
BENCH_DECLARE(bench_product);
BENCH_DECLARE(bench_interp);
#undef BENCH_DECLARE

/* Peak kernels of one precision: a call of run does `amount` operations (flops or bytes stored). */
typedef struct bench_floor { void (*run)(void); double amount; } bench_floor;
bench_floor bench_fma_f32(void);
bench_floor bench_fma_f64(void);
bench_floor bench_store_l1(void);
bench_floor bench_store_dram(void);

#if defined(BENCH_PRECISION)
#  if BENCH_PRECISION == 32
typedef float real;
#    define FN(name) name##_f32
#    define REAL_SQRT sqrtf
#    define REAL_SIN sinf
#    define REAL_COS cosf
#    define REAL_ATAN2 atan2f
#    define REAL_ACOS acosf
#    define REAL_EPS 1.1920929e-7
#  else
typedef double real;
#    define FN(name) name##_f64
#    define REAL_SQRT sqrt
#    define REAL_SIN sin
#    define REAL_COS cos
#    define REAL_ATAN2 atan2
#    define REAL_ACOS acos
#    define REAL_EPS 2.220446049250313e-16
#  endif
#  define C(x) ((real)(x))
#  define INLINE static inline __attribute__((always_inline, unused))
#  define RESTRICT __restrict__
/* Spells a switch over the band counts that a suite measures, each with its own constant body. */
#  define BANDS_CASE(n, body) case n: { enum { BANDS = n }; body } break;
#endif

#endif
