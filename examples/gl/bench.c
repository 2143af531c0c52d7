/* bench.c - M22's Table 2 (the grid, by bands and form), Table 3 (by lights) and Table 5 (interpolation, by bands) as CSV. */
#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *program_name = "gl-bench";

static const char help[] =
    "usage: gl-bench [--quick] [--out FILE]\n"
    "Times the passes as M22's Tables 2, 3 and 5 do and writes FILE [build/gl-bench.csv]; a copy with M22's own figures\n"
    "(RTX 2080) beside ours goes to the terminal. --quick: fewer lights, nodes and pixels, for software renderers.\n"
    "Exit code 0; 2 for a bad command line or file; 77 without OpenGL 4.5.\n";

static const char *const kinds[] = { "spheres", "triangles_as_spheres", "polygons" };
static const char *const forms[] = { "forward", "reverse", "moments", "lobes" };
static FILE *csv;

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The median of some runs after one that compiles; fewer where a run is long. */
static double timed(const settings *o, const stage *s, const light *now, int pass)
{
    double ms[15], sum = 0;
    int i, n = 0;

    passes_lights(now, 1);
    for (i = -1; i < 15 && sum < 600; i++) {
        if (pass == GRID) pass_grid(o, s);
        else if (pass == OCCLUSION) pass_occlusion(o, &s->eye);
        else pass_shading(o, s, &s->eye, 0);
        if (i >= 0) sum += ms[n++] = passes_ms(pass);
        else {
            passes_ms(pass);
            passes_lights(now, s->count);
        }
    }
    qsort(ms, (size_t)n, sizeof *ms, by_value);
    return ms[n / 2];
}

static void row(int table, const settings *o, int many, const char *what, double ms, double m22)
{
    char name[128], *c;
    snprintf(name, sizeof name, "%s", (const char *)glGetString(GL_RENDERER));
    for (c = name; *c; c++)
        if (*c == ',' || *c == '"') *c = ' ';
    fprintf(csv, "%d,%s,%s,%d,%s,%s,%d,%d,%dx%d,%.4f,", table, name, passes_clock(), many, kinds[o->kind], what, o->bands,
            o->nodes[0], o->width, o->height, ms);
    if (m22 > 0) fprintf(csv, "%.2f", m22);
    fprintf(csv, "\n");
    fflush(csv);
    printf("%5d  %6d  %-21s %-12s %5d %10.3f", table, many, kinds[o->kind], what, o->bands, ms);
    if (m22 > 0) printf(" %9.2f", m22);
    printf("\n");
    fflush(stdout);
}

static void use_lights(stage *s, light **now, int count, int kind)
{
    stage_free(s);
    stage_build(s, count, 1);
    *now = need(*now, (size_t)s->count, sizeof **now);
    stage_move(s, kind != SPHERE_LIGHTS, 0, *now);
    passes_lights(*now, s->count);
}

static void shade_rows(int table, settings o, const stage *s, const light *now, double coefficients, double interpolation,
                       double reference)
{
    double build, shade;
    o.form = MOMENTS;
    o.scheme = 5;
    build = timed(&o, s, now, GRID);
    row(table, &o, s->count, "grid", build, coefficients);
    shade = timed(&o, s, now, SHADING);
    row(table, &o, s->count, "edge_hermite", shade, interpolation);
    row(table, &o, s->count, "occlusion", timed(&o, s, now, OCCLUSION), 0);
    o.scheme = PER_POINT;
    row(table, &o, s->count, "per_pixel", timed(&o, s, now, SHADING), reference);
}

int main(int argc, char **argv)
{
    /* M22: Table 2, bands 5 to 9: spheres forward and reverse, triangles as spheres, polygons (Wu et al. 2020) */
    static const double table2[5][4] = { {4.08, 2.22, 2.53, 7.21}, {5.98, 2.96, 3.39, 13.08}, {7.24, 3.77, 4.42, 16.21},
                                         {12.73, 4.76, 5.35, 29.07}, {22.26, 5.18, 5.74, 164.01} };
    /* Table 3: lights, coefficients and gradients, interpolation, reference */
    static const double table3[8][4] = { {242, 0.66, 10.51, 30.50}, {512, 1.39, 10.17, 55.40}, {578, 1.82, 12.41, 76.54},
                                         {722, 2.07, 14.58, 119.49}, {800, 2.26, 28.56, 133.01}, {900, 2.63, 11.53, 115.51},
                                         {1793, 5.30, 6.73, 139.11}, {2500, 7.84, 11.30, 325.07} };
    /* Table 5: 512 lights, bands 5 to 9 */
    static const double table5[5][3] = { {1.39, 7.65, 45.25}, {1.87, 8.90, 53.77}, {2.43, 26.14, 77.18}, {3.07, 55.57, 98.79},
                                         {3.35, 132.29, 148.04} };
    const char *out = "build/gl-bench.csv";
    settings o;
    stage s;
    light *now = NULL;
    int quick = 0, i;

    for (i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--help")) { fputs(help, stdout); return 0; }
        else if (!strcmp(argv[i], "--quick")) quick = 1;
        else if (!strcmp(argv[i], "--out") && i + 1 < argc) out = argv[++i];
        else die("unknown option '%s'; --help lists them", argv[i]);
    }
    if (!context_headless()) { context_close(); return MISSING; }
    if (!(csv = fopen(out, "w"))) die("cannot write %s", out);
    memset(&o, 0, sizeof o);
    o.lobe_bands = MAX_BANDS; o.lanes = 8; o.samples = 1; o.occlusion = 1; o.scheme = 5;
    o.nodes[0] = o.nodes[1] = o.nodes[2] = quick ? 4 : 8;
    o.width = quick ? 320 : 1920;
    o.height = quick ? 180 : 1080;
    fprintf(csv, "table,renderer,clock,lights,kind,what,bands,nodes,size,ms,m22_rtx2080_ms\n");
    stage_build(&s, quick ? 64 : 648, 1);
    passes_open(&s);
    printf("%s, %s, times by the %s; M22: RTX 2080\n", (const char *)glGetString(GL_RENDERER),
           (const char *)glGetString(GL_VERSION), passes_clock());
    printf("%5s  %6s  %-21s %-12s %5s %10s %9s\n", "table", "lights", "kind", "what", "bands", "ms", "M22 ms");

    for (o.bands = 5; o.bands <= 9; o.bands += quick ? 4 : 1)
        for (o.kind = SPHERE_LIGHTS; o.kind <= POLYGON_LIGHTS; o.kind++) {
            use_lights(&s, &now, quick ? 64 : 648, o.kind);
            for (o.form = o.kind == POLYGON_LIGHTS ? LOBES : quick ? REVERSE : FORWARD;
                 o.form <= (o.kind == POLYGON_LIGHTS ? LOBES : MOMENTS); o.form++)
                row(2, &o, s.count, forms[o.form], timed(&o, &s, now, GRID),
                    quick ? 0 : o.kind == POLYGON_LIGHTS ? table2[o.bands - 5][3]
                    : o.kind == TRIANGLE_LIGHTS ? (o.form == REVERSE ? table2[o.bands - 5][2] : 0)
                    : o.form == FORWARD ? table2[o.bands - 5][0] : o.form == REVERSE ? table2[o.bands - 5][1] : 0);
        }
    o.kind = SPHERE_LIGHTS;
    o.bands = 5;
    pass_surfaces(&o, &s.eye);
    pass_occlusion(&o, &s.eye);
    for (i = 0; i < (quick ? 1 : 8); i++) {
        use_lights(&s, &now, quick ? 64 : (int)table3[i][0], o.kind);
        shade_rows(3, o, &s, now, quick ? 0 : table3[i][1], quick ? 0 : table3[i][2], quick ? 0 : table3[i][3]);
    }
    use_lights(&s, &now, quick ? 64 : 512, o.kind);
    for (o.bands = 5; o.bands <= 9; o.bands += quick ? 4 : 1)
        shade_rows(5, o, &s, now, quick ? 0 : table5[o.bands - 5][0], quick ? 0 : table5[o.bands - 5][1], quick ? 0 : table5[o.bands - 5][2]);
    fclose(csv);
    printf("%s\n", out);
    free(now);
    passes_close();
    context_close();
    stage_free(&s);
    return 0;
}
