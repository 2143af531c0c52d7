/* stack.c - the stack that calls take, whole: each runs in a thread whose stack was painted. For bench/sizes.sh. */
#include "sh_gradient.h"
#include "sh_interp.h"
#include "sh_polygon.h"
#include "sh_product.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROOM = 4 << 20, MOST = 1024, PAINT = 0xa5, COUNT = 64 };

typedef struct { int bands; size_t used; } order;

#define STACKS(T, F) \
    static T F(in)[4 * COUNT], F(vertices)[12], F(out)[10 * MOST * COUNT], F(dirs)[3 * COUNT]; \
    static const int F(four)[1] = { 4 }; \
    static void F(fill)(void) \
    { \
        int i; \
        for (i = 0; i < 4 * COUNT; i++) F(in)[i] = (T)(1 + i % 7); \
        for (i = 0; i < 3 * COUNT; i++) F(dirs)[i] = (T)(1 + i % 5); \
        for (i = 0; i < 12; i++) F(vertices)[i] = (T)(i % 3 == 2 ? 2 : i == 3 || i == 6 || i == 7 || i == 10); \
    } \
    static int F(gradients)(int n) { return F(sh_eval_grad_n)(n, COUNT, F(dirs), F(out), F(out) + MOST * COUNT); } \
    static int F(project)(int n) { return F(sh_project_n)(n, COUNT, F(dirs), F(in), F(out)); } \
    static int F(lights)(int n) { return F(sh_spheres)(n, SH_HESSIAN, 1, F(in), COUNT, F(in), NULL, F(out)); } \
    static int F(polygon)(int n) { return F(sh_polygon)(n, SH_BOTH, F(in), 4, F(vertices), F(out), F(out) + MOST); } \
    static int F(polygons)(int n) \
    { \
        return F(sh_polygons_n)(n, SH_GRADIENT, 1, SH_BOTH, COUNT, F(dirs), 1, F(four), F(vertices), NULL, F(out)); \
    } \
    static int F(triple)(int n) { return F(sh_triple_product)(n, F(in), F(in), F(out)); } \
    static int F(minimum)(int n) { return F(sh_minimum)(n, F(in), F(out), NULL); }
#define F32(name) name##_f32
#define F64(name) name##_f64
STACKS(float, F32)
STACKS(double, F64)

static const struct {
    const char *name;
    int bands;
    int (*call[2])(int);
} calls[] = {
    { "sh_eval_grad_n", 5, { gradients_f32, gradients_f64 } },
    { "sh_eval_grad_n", 20, { gradients_f32, gradients_f64 } },
    { "sh_project_n", 5, { project_f32, project_f64 } },
    { "sh_spheres, Hessian", 5, { lights_f32, lights_f64 } },
    { "sh_spheres, Hessian", 32, { lights_f32, lights_f64 } },
    { "sh_polygon, gradient", 16, { polygon_f32, polygon_f64 } },
    { "sh_polygons_n, gradient", 10, { polygons_f32, polygons_f64 } },
    { "sh_polygons_n, gradient", 16, { polygons_f32, polygons_f64 } },
    { "sh_triple_product", 16, { triple_f32, triple_f64 } },
    { "sh_minimum", 8, { minimum_f32, minimum_f64 } },
};

static int (*chosen)(int);
static int chosen_bands, status;
static void *run(void *nothing) { return status = chosen ? chosen(chosen_bands) : 0, nothing; }

static double used(int (*call)(int), int bands)
{
    unsigned char *const stack = aligned_alloc(4096, ROOM);
    pthread_attr_t how;
    pthread_t thread;
    size_t i, free_bytes = 0;
    if (!stack) exit(1);
    for (i = 0; i < ROOM; i++) stack[i] = PAINT;
    chosen = call;
    chosen_bands = bands;
    if (pthread_attr_init(&how) || pthread_attr_setstack(&how, stack, ROOM) || pthread_create(&thread, &how, run, NULL)
        || pthread_join(thread, NULL) || status < 0) {
        fprintf(stderr, "stack: %s\n", sh_status_string(status));
        exit(1);
    }
    while (stack[free_bytes] == PAINT) free_bytes++;
    free(stack);
    return (double)(ROOM - free_bytes) / 1024;
}

int main(void)
{
    const double none = used(NULL, 0);
    size_t i;
    fill_f32();
    fill_f64();
    for (i = 0; i < sizeof calls / sizeof *calls; i++)
        printf("%-26s %5d %9.0f %9.0f\n", calls[i].name, calls[i].bands, used(calls[i].call[0], calls[i].bands) - none,
               used(calls[i].call[1], calls[i].bands) - none);
    return 0;
}
