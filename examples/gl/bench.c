/* bench.c - M22's Table 2 (the grid by bands and form), 3 (a frame by lights) and 5 (a frame by bands) as
 * CSV. */
#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *program_name = "gl-bench";

static const char help[] =
    "usage: gl-bench [options]\n"
    "Times the passes as M22's Tables 2, 3 and 5 do and writes a CSV; a copy, with M22's own figures (RTX 2080)\n"
    "beside ours where the work is the same, goes to the terminal.\n"
    "  --size WxH   of the shaded picture [1920x1080 as M22; 640x360 where software renders]\n"
    "  --table N    2, 3 or 5 alone\n"
    "  --quick      64 lights, 4^3 nodes, 320x180\n"
    "  --out FILE   [build/gl-bench.csv]\n"
    "  --help\n"
    "Exit code 0; 2 for a bad command line or file; 77 without OpenGL 4.5.\n";

/* M22, RTX 2080, ms. Table 2, bands 5 to 9: spheres forward and reverse, triangles as spheres, polygons
 * [WCZR20] */
static const double table2[5][4] = { {4.08, 2.22, 2.53, 7.21}, {5.98, 2.96, 3.39, 13.08}, {7.24, 3.77, 4.42, 16.21},
                                     {12.73, 4.76, 5.35, 29.07}, {22.26, 5.18, 5.74, 164.01} };
/* what a frame takes: coefficients, with gradients, interpolation, occlusion, reference */
typedef struct { int lights; double ms[5]; } frame_row;
/* Table 3; 0: not at 1920 x 1080 */
static const frame_row table3[8] = { {242, {0.34, 0.66, 0, 0, 0}}, {512, {0.86, 1.39, 10.17, 1.06, 55.40}},
    {578, {0.84, 1.82, 12.41, 0.98, 76.54}}, {722, {1.19, 2.07, 14.58, 1.21, 119.49}}, {800, {1.46, 2.26, 0, 0, 0}},
    {900, {1.49, 2.63, 11.53, 0.77, 115.51}}, {1793, {3.18, 5.30, 6.73, 0.90, 139.11}},
    {2500, {4.36, 7.84, 11.30, 0.88, 325.07}} };
/* Table 5, 512 lights, bands 5 to 9 */
static const frame_row table5[5] = { {512, {0, 1.39, 7.65, 0, 45.25}}, {512, {0, 1.87, 8.90, 0, 53.77}},
    {512, {0, 2.43, 26.14, 0, 77.18}}, {512, {0, 3.07, 55.57, 0, 98.79}}, {512, {0, 3.35, 132.29, 0, 148.04}} };

static const char *const kinds_of[] = { "spheres", "triangles_as_spheres", "polygons" };
static const char *const forms_of[] = { "forward", "reverse", "moments", "coefficients", "exact" };
static FILE *csv;
static stage s;
static light *now;

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The median of some runs after one that compiles; fewer where a run is long. */
static double timed(const settings *o, int pass)
{
    double ms[15], sum = 0;
    int i, n = 0;

    passes_lights(o, &s, now, 1);
    for (i = -1; i < 15 && sum < 600; i++) {
        if (pass == GRID) pass_grid(o, &s);
        else if (pass == OCCLUSION) pass_occlusion(o, &s.eye);
        else pass_shading(o, &s, &s.eye, 0);
        if (i >= 0) sum += ms[n++] = passes_ms(pass);
        else {
            passes_ms(pass);
            passes_lights(o, &s, now, 0);
        }
    }
    qsort(ms, (size_t)n, sizeof *ms, by_value);
    return ms[n / 2];
}

static void row(int table, const settings *o, const char *what, double ms, double m22)
{
    char name[128], *c;
    snprintf(name, sizeof name, "%s", (const char *)glGetString(GL_RENDERER));
    for (c = name; *c; c++)
        if (*c == ',' || *c == '"') *c = ' ';
    fprintf(csv, "%d,%s,%s,%d,%s,%s,%d,%d,%dx%d,%.4f,", table, name, passes_clock(), s.count, kinds_of[o->kind], what,
            o->bands, o->nodes[0], o->width, o->height, ms);
    if (m22 > 0) fprintf(csv, "%.2f", m22);
    fprintf(csv, "\n");
    fflush(csv);
    printf("%5d  %6d  %-21s %-12s %5d %10.3f", table, s.count, kinds_of[o->kind], what, o->bands, ms);
    if (m22 > 0) printf(" %9.2f", m22);
    printf("\n");
    fflush(stdout);
}

static void use_lights(int count, int kind)
{
    stage_free(&s);
    stage_build(&s, count, STAGE_BARE);
    now = need(now, (size_t)s.count, sizeof *now);
    stage_move(&s, kind != SPHERE_LIGHTS, 0, now);
}

/* The grid of every kind of light in every form. */
static void grid_rows(settings o, int lights_wanted, int m22)
{
    for (o.kind = SPHERE_LIGHTS; o.kind <= POLYGON_LIGHTS; o.kind++) {
        const double *const theirs = table2[o.bands - 5];
        use_lights(lights_wanted, o.kind);
        if (o.kind == POLYGON_LIGHTS) row(2, &o, forms_of[EXACT], timed(&o, GRID), m22 ? theirs[3] : 0);
        else
            for (o.form = FORWARD; o.form <= MOMENTS; o.form++) {
                const int at = o.kind == SPHERE_LIGHTS && o.form < MOMENTS ? o.form
                             : o.kind == TRIANGLE_LIGHTS && o.form == REVERSE ? 2 : -1;
                row(2, &o, forms_of[o.form], timed(&o, GRID), m22 && at >= 0 ? theirs[at] : 0);
            }
    }
}

/* All that a frame takes, and the same without a grid. */
static void frame_rows(int table, settings o, const frame_row *theirs, int m22)
{
    const int full = m22 && o.width == 1920 && o.height == 1080;
    o.form = COEFFICIENTS;
    row(table, &o, "coefficients", timed(&o, GRID), m22 ? theirs->ms[0] : 0);
    o.form = MOMENTS;
    row(table, &o, "gradients", timed(&o, GRID), m22 ? theirs->ms[1] : 0);
    row(table, &o, "edge_hermite", timed(&o, SHADING), full ? theirs->ms[2] : 0);
    row(table, &o, "occlusion", timed(&o, OCCLUSION), full ? theirs->ms[3] : 0);
    o.scheme = PER_POINT;
    row(table, &o, "per_pixel", timed(&o, SHADING), full ? theirs->ms[4] : 0);
}

int main(int argc, char **argv)
{
    const char *out = "build/gl-bench.csv";
    settings o;
    int quick = 0, table = 0, i, bands;
    char more;

    memset(&o, 0, sizeof o);
    for (i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--help")) { fputs(help, stdout); return 0; }
        else if (!strcmp(argv[i], "--quick")) quick = 1;
        else if (!strcmp(argv[i], "--out") && i + 1 < argc) out = argv[++i];
        else if (!strcmp(argv[i], "--table") && i + 1 < argc) {
            table = atoi(argv[++i]);
            if (table != 2 && table != 3 && table != 5) die("--table takes 2, 3 or 5, not '%s'", argv[i]);
        } else if (!strcmp(argv[i], "--size") && i + 1 < argc) {
            if (sscanf(argv[++i], "%dx%d%c", &o.width, &o.height, &more) != 2 || o.width < 64 || o.height < 64
                || o.width > 4096 || o.height > 4096)
                die("--size takes WIDTHxHEIGHT, each from 64 to 4096, not '%s'", argv[i]);
        } else die("unknown option '%s'; --help lists them", argv[i]);
    }
    if (!context_headless()) { context_close(); return MISSING; }
    if (!(csv = fopen(out, "w"))) die("cannot write %s", out);
    stage_build(&s, 64, STAGE_BARE);
    passes_open(&s);
    if (!o.width) {
        const int soft = strcmp(passes_clock(), "GPU timer") != 0;
        o.width = quick ? 320 : soft ? 640 : 1920;
        o.height = quick ? 180 : soft ? 360 : 1080;
    }
    o.lobe_bands = MAX_BANDS;
    o.samples = o.occlusion = 1;
    o.scheme = 5;                                           /* SH_EDGE_HERMITE */
    o.nodes[0] = o.nodes[1] = o.nodes[2] = quick ? 4 : 8;
    fprintf(csv, "table,renderer,clock,lights,kind,what,bands,nodes,size,ms,m22_rtx2080_ms\n");
    printf("%s, %s, times by the %s; %d x %d pixels, %d^3 nodes; M22: RTX 2080\n", (const char *)glGetString(GL_RENDERER),
           (const char *)glGetString(GL_VERSION), passes_clock(), o.width, o.height, o.nodes[0]);
    printf("%5s  %6s  %-21s %-12s %5s %10s %9s\n", "table", "lights", "kind", "what", "bands", "ms", "M22 ms");

    for (bands = 5; bands <= 9 && (!table || table == 2); bands += quick ? 4 : 1) {
        o.bands = bands;
        grid_rows(o, quick ? 64 : 648, !quick);
    }
    o.kind = SPHERE_LIGHTS;
    o.bands = 5;
    passes_lights(&o, &s, now, 0);
    pass_surfaces(&o, &s.eye);
    pass_occlusion(&o, &s.eye);
    for (i = 0; i < (quick ? 1 : 8) && (!table || table == 3); i++) {
        use_lights(quick ? 64 : table3[i].lights, o.kind);
        frame_rows(3, o, &table3[i], !quick);
    }
    for (bands = 5; bands <= 9 && (!table || table == 5); bands += quick ? 4 : 1) {
        o.bands = bands;
        use_lights(quick ? 64 : 512, o.kind);
        frame_rows(5, o, &table5[bands - 5], !quick);
    }
    fclose(csv);
    printf("%s\n", out);
    free(now);
    passes_close();
    context_close();
    stage_free(&s);
    return 0;
}
