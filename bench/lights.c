/* lights.c - suites `lights` (many sphere lights at one point) and `grid`, `grid_lights`, `grid_nodes` (over grids:
 * M22 Table 2, Fig. 10, 13, 14). */
#include "sh_gradient.h"     /* first: names of ours must not reach it */

#include "lights.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#if defined(_OPENMP)
#  include <omp.h>
#endif

enum { LIGHTS = 648, GRID_SIDE = 8 };

typedef struct lights_input {
    const lights_scene *scene;
    int bands, planes, side, threads;
    real point[3];
    real *out;
} lights_input;

/* Lights around the cube [-1, 1]^3, which holds the points: distances 2.5 to 7, angular radii as in a room. */
static lights_scene *make_scene(size_t count)
{
    lights_scene *scene = bench_alloc(1, sizeof *scene);
    real *spheres = bench_alloc(4 * count, sizeof(real)), *radiance = bench_alloc(count, sizeof(real));
    size_t i, k;
    for (i = 0; i < count; i++) {
        double v[3], rr;
        do {
            for (k = 0, rr = 0; k < 3; k++) {
                v[k] = 2 * bench_random() - 1;
                rr += v[k] * v[k];
            }
        } while (rr > 1 || rr < 0.4 || v[0] * v[0] + v[1] * v[1] < 0.1);
        for (k = 0; k < 3; k++) spheres[k * count + i] = C(7 * v[k]);
        spheres[3 * count + i] = C(0.2 + 0.6 * bench_random());
        radiance[i] = C(0.5 + bench_random());
    }
    scene->count = count;
    scene->spheres = spheres;
    scene->radiance = radiance;
    return scene;
}

static FN(sh_grid) make_grid(int side)
{
    FN(sh_grid) grid;
    int k;
    for (k = 0; k < 3; k++) {
        grid.origin[k] = -1;
        grid.cell[k] = C(2) / C(side - 1);
        grid.count[k] = side;
    }
    return grid;
}

/* ---- one point ---- */

static void point_library(const bench_case *self)
{
    const lights_input *in = self->input;
    FN(sh_spheres)(in->bands, in->planes, 1, in->point, in->scene->count, in->scene->spheres, in->scene->radiance,
                   in->out);
}

static void point_per_light(const bench_case *self)
{
    const lights_input *in = self->input;
    FN(per_light)(in->bands, in->planes, in->point, in->scene, in->out);
}

static void point_per_light_auto(const bench_case *self)
{
    const lights_input *in = self->input;
    FN(per_light_auto)(in->bands, in->planes, in->point, in->scene, in->out);
}

/* ---- a grid; threads are the caller's: each takes ranges of nodes ---- */

static void grid_library(const bench_case *self)
{
    const lights_input *in = self->input;
    const FN(sh_grid) grid = make_grid(in->side);
    const int nodes = in->side * in->side * in->side;
    const size_t block = (size_t)(in->planes * in->bands * in->bands);
    int first;
#if defined(_OPENMP)
#  pragma omp parallel for schedule(dynamic) num_threads(in->threads)
#endif
    for (first = 0; first < nodes; first += 16) {
        const int left = nodes - first;
        FN(sh_spheres_grid)(in->bands, in->planes, 1, &grid, (size_t)first, (size_t)(left < 16 ? left : 16),
                            in->scene->count, in->scene->spheres, in->scene->radiance,
                            in->out + (size_t)first * block);
    }
}

static void grid_per_light(const bench_case *self)
{
    const lights_input *in = self->input;
    const FN(sh_grid) grid = make_grid(in->side);
    const size_t block = (size_t)(in->planes * in->bands * in->bands);
    int i, j, k;
    real *out = in->out;
    for (k = 0; k < in->side; k++)
        for (j = 0; j < in->side; j++)
            for (i = 0; i < in->side; i++, out += block) {
                const real at[3] = { -1 + grid.cell[0] * C(i), -1 + grid.cell[1] * C(j), -1 + grid.cell[2] * C(k) };
                FN(per_light)(in->bands, in->planes, at, in->scene, out);
            }
}

/* ---- registration ---- */

static const char *kernel_name(int planes)
{
    return planes == SH_VALUES ? "values" : planes == SH_GRADIENT ? "gradient" : "hessian";
}

/* items: what ns are per; nodes: how many the output holds; column: the table's column, 0 for the bands */
static bench_case make_case(const lights_input *in, const char *impl, void (*run)(const bench_case *),
                            size_t items, int nodes, int column)
{
    const size_t n2 = (size_t)(in->bands * in->bands);
    bench_case c;
    memset(&c, 0, sizeof c);
    c.kernel = kernel_name(in->planes);
    c.impl = impl;
    c.bands = in->bands;
    c.column = column;
    c.items = items;
    c.run = run;
    c.input = in;
    c.out[0].data = in->out;
    c.out[0].numbers = n2 * (size_t)in->planes;
    c.out[0].planes = (size_t)in->planes;
    c.held = (size_t)nodes;
    /* M22's Eq. 9 and 16 subtract nearly equal Legendre values: they keep 3 digits in float here, which is enough to
     * see a wrong sign or factor; in double the same check is sharp. */
    c.tolerance = BENCH_PRECISION == 32 ? 5e-3 : 1e-9;
    return c;
}

static lights_input *make_input(const lights_scene *scene, int bands, int planes, int side)
{
    lights_input *in = bench_alloc(1, sizeof *in);
    const size_t nodes = (size_t)(side * side * side);
    in->scene = scene;
    in->bands = bands;
    in->planes = planes;
    in->side = side;
    in->threads = 1;
    in->point[0] = C(0.2);
    in->point[1] = C(-0.1);
    in->point[2] = C(0.3);
    in->out = bench_alloc(nodes * (size_t)(planes * bands * bands), sizeof(real));
    return in;
}

static const int all_planes[] = { SH_VALUES, SH_GRADIENT, SH_HESSIAN };

void FN(bench_lights)(void)
{
    const lights_scene *scene;
    int bands, k;
    bench_suite("lights", BENCH_PRECISION, "light", "648 lights summed at one point");
    bench_base("values", "per_light");
    bench_base("gradient", "per_light");
    bench_base("hessian", "per_light");
    scene = make_scene(LIGHTS);
    for (k = 0; k < 3; k++)
        for (bands = 5; bands <= 9; bands++) {
            const lights_input *in = make_input(scene, bands, all_planes[k], 1);
            bench_case c = make_case(in, "library", point_library, LIGHTS, 1, 0);
            c.flops = bench_light_flops(bands, in->planes);
            bench_add(&c);
            c = make_case(in, "per_light", point_per_light, LIGHTS, 1, 0);
            bench_add(&c);
            if (in->planes == SH_HESSIAN) continue;
            c = make_case(in, "per_light_auto", point_per_light_auto, LIGHTS, 1, 0);
            bench_add(&c);
        }
    bench_run();
}

static int all_threads(void)
{
#if defined(_OPENMP)
    return omp_get_max_threads();
#else
    return 1;
#endif
}

static void add_grid(const lights_scene *scene, int bands, int planes, int side, size_t items, int column,
                     int baseline)
{
    lights_input *in = make_input(scene, bands, planes, side), *parallel = bench_alloc(1, sizeof *parallel);
    const int nodes = side * side * side;
    bench_case c = make_case(in, "library", grid_library, items, nodes, column);
    c.flops = bench_light_flops(bands, planes) * (double)scene->count * nodes / (double)items;
    bench_add(&c);
    if (all_threads() > 1) {
        *parallel = *in;
        parallel->threads = all_threads();
        c = make_case(parallel, "library_threads", grid_library, items, nodes, column);
        bench_add(&c);
    }
    if (baseline) {
        c = make_case(in, "per_light", grid_per_light, items, nodes, column);
        bench_add(&c);
    }
}

void FN(bench_grid)(void)
{
    static const int sides[] = { 4, 6, 8, 12, 16, 24, 32 };
    const lights_scene *scene;
    size_t count;
    unsigned k;
    int bands, p;

    bench_suite("grid", BENCH_PRECISION, "node", "648 lights on 8x8x8 nodes, written to an array");
    bench_base("values", "per_light");
    bench_base("gradient", "per_light");
    scene = make_scene(LIGHTS);
    for (p = 0; p < (bench_option.quick ? 2 : 3); p++)
        for (bands = 5; bands <= 9; bands++) {
            const int nodes = GRID_SIDE * GRID_SIDE * GRID_SIDE;
            /* a baseline of a tenth of a second per sample is for the full run */
            add_grid(scene, bands, all_planes[p], GRID_SIDE, (size_t)nodes, 0, !bench_option.quick && p < 2);
        }
    bench_run();
    if (bench_option.quick || bench_option.check_only) return;

    bench_suite("grid_lights", BENCH_PRECISION, "light", "8x8x8 nodes, by the number of lights (columns)");
    for (p = 0; p < 2; p++)
        for (count = 64; count <= 4096; count *= 2)
            add_grid(make_scene(count), 5, all_planes[p], GRID_SIDE, count, (int)count, 0);
    bench_run();

    bench_suite("grid_nodes", BENCH_PRECISION, "node", "648 lights, by the number of nodes (columns)");
    scene = make_scene(LIGHTS);
    for (p = 0; p < 2; p++)
        for (k = 0; k < sizeof sides / sizeof sides[0]; k++) {
            const int nodes = sides[k] * sides[k] * sides[k];
            add_grid(scene, 5, all_planes[p], sides[k], (size_t)nodes, nodes, 0);
        }
    bench_run();
}
