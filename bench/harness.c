/* harness.c - see bench.h. One suite at a time lives in file-scope state: a program, not a library. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum {
    MAX_CASES = 512, MAX_ROUNDS = 400, MIN_ROUNDS = 7, MAX_BLOCKS = 4096, MAX_RESULTS = 8192, MAX_BASES = 32,
    MAX_COLUMNS = 16
};

typedef struct timed_case {
    bench_case c;
    size_t calls;                       /* per sample */
    double sample[MAX_ROUNDS];          /* ns per item */
    double min, median;
} timed_case;

typedef struct result {
    const char *suite, *kernel, *impl;
    int precision, bands;
    double min;
} result;

bench_options bench_option = { 4.0, 0, 0, 0 };

static struct {
    const char *name, *item, *regime;
    int precision;
    timed_case *cases;
    int count;
    void *blocks[MAX_BLOCKS];
    int block_count;
    struct { const char *kernel, *impl; } base[MAX_BASES];
    int base_count;
} suite;

static result results[MAX_RESULTS];
static int result_count, failures;
static FILE *csv;
static volatile double observed;        /* what was computed ends here */

static void die(const char *what)
{
    fprintf(stderr, "bench: %s\n", what);
    exit(2);
}

double bench_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_random(void)
{
    static uint64_t state = 0x9e3779b97f4a7c15u;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * (1.0 / 9007199254740992.0);
}

void *bench_alloc(size_t count, size_t size)
{
    const size_t bytes = (count * size + 63) / 64 * 64;
    void *p = NULL;
    if (suite.block_count == MAX_BLOCKS) die("too many arrays");
    if (posix_memalign(&p, 64, bytes ? bytes : 64) != 0) die("out of memory");
    memset(p, 0, bytes);
    suite.blocks[suite.block_count++] = p;
    return p;
}

int bench_failures(void) { return failures; }

/* ---- registration ---- */

static void run_floor(const bench_case *self)
{
    const bench_floor *f = self->input;
    f->run();
}

static void add_floor(const char *impl, bench_floor f)
{
    bench_case c;
    bench_floor *copy = bench_alloc(1, sizeof *copy);
    *copy = f;
    memset(&c, 0, sizeof c);
    c.kernel = "floor";
    c.impl = impl;
    c.items = (size_t)f.amount;
    c.run = run_floor;
    c.input = copy;
    bench_add(&c);
}

void bench_suite(const char *name, int precision, const char *item, const char *regime)
{
    suite.name = name;
    suite.item = item;
    suite.regime = regime;
    suite.precision = precision;
    suite.count = suite.base_count = 0;
    if (!suite.cases) suite.cases = calloc(MAX_CASES, sizeof *suite.cases);
    if (!suite.cases) die("out of memory");
    if (bench_option.check_only) return;
    add_floor("fma", precision == 32 ? bench_fma_f32() : bench_fma_f64());
    add_floor("l1_store", bench_store_l1());
    if (!strcmp(name, "stream")) add_floor("dram_store", bench_store_dram());
}

void bench_add(const bench_case *c)
{
    timed_case *t = &suite.cases[suite.count];
    if (suite.count == MAX_CASES) die("too many cases");
    memset(t, 0, sizeof *t);
    t->c = *c;
    if (!t->c.lanes) t->c.lanes = 1;
    if (!t->c.column) t->c.column = c->bands;
    suite.count++;
}

void bench_base(const char *kernel, const char *impl)
{
    if (suite.base_count == MAX_BASES) die("too many kernels");
    suite.base[suite.base_count].kernel = kernel;
    suite.base[suite.base_count++].impl = impl;
}

/* ---- check ---- */

static double number(const bench_case *c, int output, size_t item, size_t k)
{
    const bench_output *o = &c->out[output];
    const size_t at = (item / c->lanes * o->numbers + k) * c->lanes + item % c->lanes;
    return suite.precision == 32 ? (double)((const float *)o->data)[at] : ((const double *)o->data)[at];
}

static void observe(const bench_case *c)
{
    int o;
    for (o = 0; o < BENCH_OUTPUTS; o++)
        if (c->out[o].data && c->held) observed = observed + number(c, o, c->held - 1, c->out[o].numbers - 1);
}

static void poison(const bench_case *c)
{
    int o;
    for (o = 0; o < BENCH_OUTPUTS; o++) {
        const size_t items = (c->held + c->lanes - 1) / c->lanes * c->lanes;
        if (c->out[o].data)             /* all ones is a NaN */
            memset(c->out[o].data, 0xff, items * c->out[o].numbers * (size_t)(suite.precision / 8));
    }
}

/* Compares case i with the first of its kernel, bands, column, group and shape. Outputs may share memory, so what
 * is expected is copied. */
static void check_case(int i)
{
    const bench_case *c = &suite.cases[i].c, *r = c;
    int j, o;
    if (c->tolerance <= 0) return;
    for (j = 0; j < i && r == c; j++) {
        const bench_case *d = &suite.cases[j].c;
        if (d->tolerance > 0 && d->bands == c->bands && d->column == c->column && d->held == c->held &&
            d->group == c->group && d->out[0].numbers == c->out[0].numbers && !strcmp(d->kernel, c->kernel))
            r = d;
    }
    if (r == c) return;
    for (o = 0; o < BENCH_OUTPUTS; o++) {
        const size_t numbers = c->out[o].numbers, total = c->held * numbers;
        const size_t plane = numbers / (c->out[o].planes ? c->out[o].planes : 1);
        double *expected, largest[BENCH_PLANES] = { 0 }, worst = 0;
        size_t k, at = 0;
        if (!c->out[o].data || !total) continue;
        expected = malloc(total * sizeof *expected);
        if (!expected) die("out of memory");
        poison(r);
        r->run(r);
        for (k = 0; k < total; k++) {
            double *most = &largest[k % numbers / plane];
            expected[k] = number(r, o, k / numbers, k % numbers);
            if (!(fabs(expected[k]) <= *most)) *most = fabs(expected[k]);
        }
        poison(c);
        c->run(c);
        for (k = 0; k < total; k++) {
            const double e = fabs(number(c, o, k / numbers, k % numbers) - expected[k]) / largest[k % numbers / plane];
            if (!(e <= worst)) { worst = e; at = k; }       /* NaN is always worse */
        }
        if (!(worst <= c->tolerance)) {
            failures++;
            fprintf(stderr,
                    "bench: WRONG %s %s %s f%d bands %d: output %d item %zu number %zu differs from %s by %.3g of the "
                    "largest, allowed %.3g\n",
                    suite.name, c->kernel, c->impl, suite.precision, c->bands, o, at / numbers, at % numbers, r->impl,
                    worst, c->tolerance);
        } else if (bench_option.verbose) {
            printf("  %s %s %s f%d bands %d output %d: within %.2g of %s (allowed %.2g)\n", suite.name, c->kernel,
                   c->impl, suite.precision, c->bands, o, worst, r->impl, c->tolerance);
        }
        free(expected);
    }
}

/* ---- timing ---- */

static double sample(const timed_case *t)
{
    const double start = bench_seconds();
    size_t i;
    for (i = 0; i < t->calls; i++) t->c.run(&t->c);
    return bench_seconds() - start;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int measure(void)
{
    const double target = 30e-6;
    double end;
    int i, round;
    for (i = 0; i < suite.count; i++) {
        timed_case *t = &suite.cases[i];
        for (t->calls = 1; sample(t) < target && t->calls < (size_t)1 << 24; ) t->calls *= 2;
    }
    end = bench_seconds() + bench_option.seconds;
    for (round = 0; round < MAX_ROUNDS && (round < MIN_ROUNDS || bench_seconds() < end); round++)
        for (i = 0; i < suite.count; i++) {
            timed_case *t = &suite.cases[i];
            t->c.run(&t->c);                                /* its code and data back into the caches */
            t->sample[round] = sample(t) * 1e9 / ((double)t->calls * (double)t->c.items);
            observe(&t->c);
        }
    for (i = 0; i < suite.count; i++) {
        timed_case *t = &suite.cases[i];
        qsort(t->sample, (size_t)round, sizeof t->sample[0], ascending);
        t->min = t->sample[0];
        t->median = t->sample[round / 2];
    }
    return round;
}

/* ---- reports ---- */

static const timed_case *find(const char *kernel, const char *impl, int column)
{
    int i;
    for (i = 0; i < suite.count; i++) {
        const timed_case *t = &suite.cases[i];
        if (t->c.column == column && !strcmp(t->c.kernel, kernel) && !strcmp(t->c.impl, impl)) return t;
    }
    return NULL;
}

/* Distinct columns of a kernel, in order of registration; returns how many. */
static int kernel_columns(const char *kernel, int columns[MAX_COLUMNS])
{
    int i, j, n = 0;
    for (i = 0; i < suite.count; i++) {
        const bench_case *c = &suite.cases[i].c;
        if (strcmp(c->kernel, kernel)) continue;
        for (j = 0; j < n && columns[j] != c->column; j++) { }
        if (j == n && n < MAX_COLUMNS) columns[n++] = c->column;
    }
    return n;
}

static const char *base_of(const char *kernel)
{
    int i;
    for (i = 0; i < suite.base_count; i++)
        if (!strcmp(suite.base[i].kernel, kernel)) return suite.base[i].impl;
    return NULL;
}

/* A cell 16 wide: ns, and how many times faster than the base (0: none). */
static void print_cell(double ns, double ratio)
{
    char text[32];
    if (ns >= 1000) sprintf(text, "%.0f", ns);
    else sprintf(text, "%.4g", ns);
    if (ratio > 0) printf("%9s%6.*fx", text, ratio < 10 ? 2 : 1, ratio);
    else printf("%16s", text);
}

static void print_kernel(const char *kernel)
{
    const timed_case *fma = find("floor", "fma", 0), *store = find("floor", "l1_store", 0);
    const char *base = base_of(kernel);
    int columns[MAX_COLUMNS], n = kernel_columns(kernel, columns), i, k;

    printf("\n%s %s f%d: ns per %s%s%s\n  %-18s", suite.name, kernel, suite.precision, suite.item,
           base ? ", times faster than " : "", base ? base : "", "");
    for (k = 0; k < n; k++) printf("%16d", columns[k]);
    printf("\n");
    for (i = 0; i < suite.count; i++) {
        const bench_case *c = &suite.cases[i].c;
        int earlier = 0, j, counted = 0;
        for (j = 0; j < i; j++)
            earlier |= !strcmp(suite.cases[j].c.kernel, kernel) && !strcmp(suite.cases[j].c.impl, c->impl);
        if (strcmp(c->kernel, kernel) || earlier) continue;
        printf("  %-18s", c->impl);
        for (k = 0; k < n; k++) {
            const timed_case *t = find(kernel, c->impl, columns[k]);
            const timed_case *b = base ? find(kernel, base, columns[k]) : NULL;
            if (!t) printf("%16s", "-");
            else print_cell(t->min, b ? b->min / t->min : 0);
            counted |= t && (t->c.flops > 0 || t->c.bytes > 0);
        }
        printf("\n");
        if (!counted || !fma || !store) continue;
        printf("  %-18s", "  of the floor");
        for (k = 0; k < n; k++) {
            const timed_case *t = find(kernel, c->impl, columns[k]);
            const double f = t ? t->c.flops * fma->min / t->min : 0;
            const double s = t ? t->c.bytes * store->min / t->min : 0;
            if (!t || (f <= 0 && s <= 0)) printf("%16s", "");
            else printf("%9.0f%% %-6s", 100 * (f > s ? f : s), f > s ? "fma" : "store");
        }
        printf("\n");
    }
}

static void print_suite(int rounds)
{
    const timed_case *dram = find("floor", "dram_store", 0);
    int i, j;
    printf("\n==== %s f%d: minimum of %d interleaved rounds; %s\n", suite.name, suite.precision, rounds,
           suite.regime);
    printf("floor: FMA %.1f GFLOP/s, L1 store %.1f GB/s", 1 / find("floor", "fma", 0)->min,
           1 / find("floor", "l1_store", 0)->min);
    if (dram) printf(", DRAM store %.1f GB/s", 1 / dram->min);
    printf("\n");
    for (i = 0; i < suite.count; i++) {
        int earlier = !strcmp(suite.cases[i].c.kernel, "floor");
        for (j = 0; j < i; j++) earlier |= !strcmp(suite.cases[j].c.kernel, suite.cases[i].c.kernel);
        if (!earlier) print_kernel(suite.cases[i].c.kernel);
    }
    fflush(stdout);
}

static void record(void)
{
    int i;
    for (i = 0; i < suite.count; i++) {
        const timed_case *t = &suite.cases[i];
        result *r = &results[result_count];
        if (result_count == MAX_RESULTS) die("too many results");
        r->suite = suite.name;
        r->kernel = t->c.kernel;
        r->impl = t->c.impl;
        r->precision = suite.precision;
        r->bands = t->c.bands;
        r->min = t->min;
        result_count++;
        if (csv)
            fprintf(csv, "%s,%s,%s,f%d,%d,%zu,%s,%s,%.6g,%.6g\n", suite.name, t->c.kernel, t->c.impl,
                    suite.precision, t->c.bands, t->c.items, bench_isa(), bench_compiler(), t->min, t->median);
    }
    if (csv) fflush(csv);
}

void bench_run(void)
{
    int i;
    for (i = 0; i < suite.count; i++) check_case(i);
    if (!bench_option.check_only) {
        const int rounds = measure();
        print_suite(rounds);
        record();
    }
    for (i = 0; i < suite.block_count; i++) free(suite.blocks[i]);
    suite.block_count = 0;
}

double bench_minimum(const char *name, const char *kernel, const char *impl, int precision, int bands)
{
    int i;
    for (i = 0; i < result_count; i++) {
        const result *r = &results[i];
        if (r->precision == precision && r->bands == bands && !strcmp(r->suite, name) &&
            !strcmp(r->kernel, kernel) && !strcmp(r->impl, impl))
            return r->min;
    }
    return 0;
}

void bench_open(const char *path)
{
    csv = fopen(path, "w");
    if (!csv) {
        perror(path);
        exit(2);
    }
    fprintf(csv, "suite,kernel,impl,precision,bands,items,isa,compiler,ns_min,ns_median\n");
}

void bench_close(void)
{
    if (csv && fclose(csv) != 0) die("the CSV could not be written");
    free(suite.cases);
}
