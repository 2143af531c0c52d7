/* targets.c - what this library set out to reach in float, and what the run just measured. Informative: machines
 * differ, so a miss is a mark in the table and never an exit code. */
#include "bench.h"

#include <stdio.h>

/* Arithmetic of the moment form per light, counted once per FMA = 2, square root and division = 1, from the kernel's
 * own formulas: about 34 for the direction and the half-angle; per band 10 for P_l, P'_l and the weight, 16 with the
 * two weights of the gradient, 44 with the three of the Hessian; per column 6 for U_m, V_m; per (l, m) a recurrence
 * step by differences (5, the first of a column 1), its products with U and V (2, one for m = 0) and an FMA for each
 * moment that band has. */
double bench_light_flops(int n, int planes)
{
    const int top = n - 1 + (planes == 1 ? 0 : planes == 4 ? 1 : 2);
    double flops = 34 + (planes == 1 ? 10.0 : planes == 4 ? 16.0 : 44.0) * n;
    int l, m;
    for (m = 0; m <= top; m++) {
        flops += m ? 6 : 0;
        for (l = m; l <= top; l++) {
            const int pair = m ? 2 : 1;
            int moments = l < n;
            if (planes >= 4) moments += (l >= 1) + (l <= n - 2);
            if (planes >= 10) moments += (l >= 2) + (l < n) + (l <= n - 3);
            flops += (l - m < 2 ? l - m : 5) + pair + 2 * pair * moments;
        }
    }
    return flops;
}

typedef struct target {
    const char *what, *suite, *kernel;
    const char *base, *impl;    /* ratio = time of base / time of impl, of the same suite, kernel and bands */
    int bands;
    double at_least;
} target;

static const target ratios[] = {
    { "basis values, blocks over sloan", "basis", "values", "sloan", "library_blocks", 5, 7 },
    { "basis values, blocks over sloan", "basis", "values", "sloan", "library_blocks", 10, 7 },
    { "basis gradient, blocks over sloan_like", "basis", "gradient", "sloan_like", "library_blocks", 5, 9 },
    { "basis gradient, blocks over sloan_like", "basis", "gradient", "sloan_like", "library_blocks", 10, 9 },
    { "basis gradient, blocks over polynomial", "basis", "gradient", "polynomial", "library_blocks", 5, 4 },
    { "basis gradient, blocks over polynomial", "basis", "gradient", "polynomial", "library_blocks", 10, 4 },
    { "basis gradient, one per call over sloan_like", "basis", "gradient", "sloan_like", "library", 5, 2 },
    { "basis gradient, one per call over sloan_like", "basis", "gradient", "sloan_like", "library", 10, 2 },
    { "reconstruct, fused over sloan + dot", "basis", "reconstruct", "sloan", "library", 5, 12 },
    { "reconstruct, fused over sloan + dot", "basis", "reconstruct", "sloan", "library", 10, 12 },
    { "lights gradient over per_light", "lights", "gradient", "per_light", "library", 5, 14 },
    { "lights gradient over per_light", "lights", "gradient", "per_light", "library", 9, 14 },
    { "lights values over per_light", "lights", "values", "per_light", "library", 5, 9 },
    { "lights values over per_light", "lights", "values", "per_light", "library", 9, 9 },
    { "product, Eq. 11 over the general product", "product", "clamped_cosine", "triple", "world", 9, 40 },
    { "product, Eq. 11 and rotation over general", "product", "clamped_cosine", "triple", "world_rotated", 9, 10 },
    { "polygon, WR18 over monomials (triangles)", "polygon", "values", "monomial", "wang_ramamoorthi", 9, 2 },
    { "polygon gradient over scalar WR18", "polygon", "gradient", "wang_ramamoorthi", "library", 9, 6 },
};

static FILE *listing;           /* the same for report.py: tab-separated */

static void line(const char *what, int bands, const char *goal, double measured, const char *unit, int pass)
{
    if (listing) fprintf(listing, "%s\t%d\t%s\t%.2f%s\t%s\n", what, bands, goal, measured, unit, pass ? "yes" : "no");
    printf("  %-46s %5d  %10s  %9.2f%-4s %s\n", what, bands, goal, measured, unit, pass ? "yes" : "NO");
}

static double library(const char *suite, const char *kernel, int bands)
{
    return bench_minimum(suite, kernel, "library", 32, bands);
}

void bench_must_reach(const char *path)
{
    static const double rtx2080_ms[] = { 2.22, 2.96, 3.77, 4.76, 5.18 };    /* M22 Table 2, "Ours rev." */
#if defined(__clang__)
    const double least = 0.6;
#else
    const double least = 0.5;
#endif
    char goal[32];
    size_t i;
    int bands;

    listing = path ? fopen(path, "w") : NULL;
    printf("\n==== targets, f32, from the minima of this run\n  %-46s %5s  %10s  %9s\n", "", "bands", "target",
           "measured");
    for (i = 0; i < sizeof ratios / sizeof ratios[0]; i++) {
        const target *t = &ratios[i];
        const double base = bench_minimum(t->suite, t->kernel, t->base, 32, t->bands);
        const double ours = bench_minimum(t->suite, t->kernel, t->impl, 32, t->bands);
        if (base <= 0 || ours <= 0) continue;
        sprintf(goal, ">= %gx", t->at_least);
        line(t->what, t->bands, goal, base / ours, "x", base / ours >= t->at_least);
    }
    for (bands = 5; bands <= 9; bands += 4) {
        const double v = library("lights", "values", bands), g = library("lights", "gradient", bands);
        const double h = library("lights", "hessian", bands), fma = bench_minimum("lights", "floor", "fma", 32, 0);
        if (v <= 0 || g <= 0 || h <= 0) continue;
        line("lights, gradient over values (time)", bands, "<= 2.4x", g / v, "x", g / v <= 2.4);
        line("lights, Hessian over values (time)", bands, "<= 4.5x", h / v, "x", h / v <= 4.5);
        sprintf(goal, ">= %g", least);
        line("lights gradient, fraction of FMA rate", bands, goal, bench_light_flops(bands, 4) * fma / g, "",
             bench_light_flops(bands, 4) * fma / g >= least);
    }
    for (bands = 5; bands <= 9; bands++) {
        const double ms = library("grid", "gradient", bands) * 512e-6;
        if (ms <= 0) continue;
        sprintf(goal, "<= %.2f ms", rtx2080_ms[bands - 5]);
        line("grid 8x8x8, 648 lights, gradient, one core", bands, goal, ms, " ms", ms <= rtx2080_ms[bands - 5]);
    }
    if (listing) fclose(listing);
}
