/* main.c - runs the suites. bench --help says how. */
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef BENCH_FLAGS
#  define BENCH_FLAGS "unknown flags"
#endif

typedef struct suite_entry {
    const char *name, *what;
    void (*f32)(void), (*f64)(void);
    double share;               /* of the time */
    int quick;                  /* part of --quick */
} suite_entry;

/* The program of `make bench-quick` has no double and no stream: half the compile time. */
#if defined(BENCH_QUICK)
#  define SUITE(name) bench_##name##_f32, NULL
#else
#  define SUITE(name) bench_##name##_f32, bench_##name##_f64
#endif

static const suite_entry entries[] = {
    { "basis", "values, derivatives, reconstruction, projection", SUITE(basis), 1.5, 1 },
#if !defined(BENCH_QUICK)
    { "stream", "the same to arrays beyond L1 and beyond the caches", SUITE(stream), 1, 0 },
#endif
    { "lights", "648 sphere lights at one point", SUITE(lights), 1, 1 },
    { "grid", "sphere lights over grids", SUITE(grid), 2, 1 },
    { "polygon", "polygon lights", SUITE(polygon), 1, 1 },
    { "product", "clamped-cosine products", SUITE(product), 1, 1 },
    { "interp", "reconstruction from a grid", SUITE(interp), 1, 1 },
};
enum { ENTRIES = sizeof entries / sizeof entries[0] };

const char *bench_isa(void)
{
#if defined(__AVX512F__)
    return "avx512";
#elif defined(__AVX2__) && defined(__FMA__)
    return "avx2";
#elif defined(__AVX__)
    return "avx";
#elif defined(__SSE2__)
    return "sse2";
#elif defined(__aarch64__)
    return "neon";
#elif defined(__wasm_simd128__)
    return "wasm";
#else
    return "scalar";
#endif
}

const char *bench_compiler(void)
{
    static char name[64];
#if defined(__clang__)
    sprintf(name, "clang %d.%d.%d", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    sprintf(name, "gcc %d.%d.%d", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    sprintf(name, "unknown");
#endif
    return name;
}

static void cpu_name(char out[128])
{
    char line[256];
    FILE *f = fopen("/proc/cpuinfo", "r");
    strcpy(out, "unknown CPU");
    while (f && fgets(line, sizeof line, f)) {
        const char *colon = strchr(line, ':');
        if (!strncmp(line, "model name", 10) && colon) {
            snprintf(out, 128, "%s", colon + 2);
            out[strcspn(out, "\n")] = 0;
            break;
        }
    }
    if (f) fclose(f);
}

/* What the CSV's fixed columns have no room for; report.py reads it. */
static void write_machine(const char *csv_path, const char *cpu)
{
    char path[512];
    FILE *f;
    snprintf(path, sizeof path, "%s.machine", csv_path);
    f = fopen(path, "w");
    if (!f) return;
    fprintf(f, "cpu: %s\ncompiler: %s\nisa: %s\nflags: %s\n", cpu, bench_compiler(), bench_isa(), BENCH_FLAGS);
    fclose(f);
}

static void usage(FILE *f)
{
    int i;
    fprintf(f, "usage: bench [--quick] [--check] [--suite NAME,NAME] [--precision f32|f64] [--seconds S]\n"
               "             [--csv FILE] [--verbose]\n"
               "\n"
               "  --quick      f32 only, within a minute; ends with the targets\n"
               "  --check      compare every baseline with the library and stop: exit code 1 if one differs\n"
               "  --verbose    print how close each baseline is\n"
               "  --seconds S  time per suite and precision [4, with --quick 3]\n"
               "  --csv FILE   write one row per case: ns per item, minimum and median\n"
               "\nsuites:\n");
    for (i = 0; i < ENTRIES; i++) fprintf(f, "  %-10s %s\n", entries[i].name, entries[i].what);
}

static int listed(const char *list, const char *name)
{
    const size_t n = strlen(name);
    const char *p = list;
    if (!list) return 1;
    for (; (p = strstr(p, name)) != NULL; p += n)
        if ((p == list || p[-1] == ',') && (p[n] == 0 || p[n] == ',')) return 1;
    return 0;
}

int main(int argc, char **argv)
{
    const char *csv_path = NULL, *suites = NULL, *precision = NULL;
    char cpu[128];
    double seconds = 0;
    int i;

    for (i = 1; i < argc; i++) {
        const char *a = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
        if (!strcmp(a, "--help")) { usage(stdout); return 0; }
        else if (!strcmp(a, "--quick")) bench_option.quick = 1;
        else if (!strcmp(a, "--check")) bench_option.check_only = 1;
        else if (!strcmp(a, "--verbose")) bench_option.verbose = 1;
        else if (!strcmp(a, "--suite") && value) { suites = value; i++; }
        else if (!strcmp(a, "--precision") && value) { precision = value; i++; }
        else if (!strcmp(a, "--csv") && value) { csv_path = value; i++; }
        else if (!strcmp(a, "--seconds") && value && (seconds = atof(value)) > 0) i++;
        else { usage(stderr); return 2; }
    }
#if defined(BENCH_QUICK)
    bench_option.quick = 1;
#endif
    if (seconds <= 0) seconds = bench_option.quick ? 3 : 4;
    cpu_name(cpu);
    if (csv_path) {
        bench_open(csv_path);
        write_machine(csv_path, cpu);
    }
    printf("%s; %s, %s; %s\n", cpu, bench_compiler(), bench_isa(), BENCH_FLAGS);
    for (i = 0; i < ENTRIES; i++) {
        if (!listed(suites, entries[i].name) || (bench_option.quick && !entries[i].quick && !suites)) continue;
        bench_option.seconds = seconds * entries[i].share;
        if (!precision || !strcmp(precision, "f32")) entries[i].f32();
        if (entries[i].f64 && (precision ? !strcmp(precision, "f64") : !bench_option.quick)) entries[i].f64();
    }
    if (!bench_option.check_only && !suites) {
        char path[512];
        snprintf(path, sizeof path, "%s.targets", csv_path ? csv_path : "");
        bench_must_reach(csv_path ? path : NULL);
    }
    bench_close();
    if (bench_failures()) {
        fprintf(stderr, "bench: %d baselines differ from the library\n", bench_failures());
        return 1;
    }
    if (bench_option.check_only) printf("every baseline agrees with the library\n");
    return 0;
}
