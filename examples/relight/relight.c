/* relight.c - hundreds of coloured spheres light a teapot through a small grid of spherical harmonics. */
#include "sh_interp.h"
#include "relight.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if defined(_OPENMP)
#  include <omp.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#  include <unistd.h>
#endif

static const char help[] =
    "usage: relight [options]\n"
    "Lights a mesh in a room by spheres and a moon, through a grid of SH coefficients and gradients, by\n"
    "every scheme of sh_interp.h, and compares each with the coefficients computed at every pixel. Writes\n"
    "PREFIX.png (edge Hermite), PREFIX-error.png (100 x the absolute error of each scheme) and\n"
    "PREFIX-polygons.png (triangle lights: exact, as spheres, the difference).\n"
    "  --mesh FILE     an OBJ file in place of the teapot\n"
    "  --up y|z        its upward axis [y]\n"
    "  --lights N      spheres, 1 or more [900]\n"
    "  --no-moon       spheres alone\n"
    "  --grid N        nodes along each axis of the grid, 2 or more [8]\n"
    "  --bands N       bands of the light, 1 to 9 [a table for 5 and one for 9]\n"
    "  --size WxH      of the picture [960x540]\n"
    "  --out PREFIX    of the files [build/demo]\n"
    "  --threads N     [all]\n"
    "  --quick         coarse geometry and shadows, for tests\n"
    "  --help\n";

void die(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fprintf(stderr, "relight: ");
    vfprintf(stderr, format, args);
    fprintf(stderr, "\n");
    va_end(args);
    exit(2);
}

void check(int status)
{
    if (status < 0) die("%s", sh_status_string(status));
}

/* New memory is zero. */
void *need(void *old, size_t count, size_t size)
{
    void *p = old ? realloc(old, (count ? count : 1) * size) : calloc(count ? count : 1, size);
    if (!p) die("out of memory");
    return p;
}

void progress(const char *what, double done)
{
#if defined(__unix__) || defined(__APPLE__)
    if (!isatty(STDERR_FILENO)) return;
    if (done < 1) fprintf(stderr, "\r%-24s %3.0f%%", what, 100 * done);
    else fprintf(stderr, "\r%30s\r", "");
#else
    (void)what; (void)done;
#endif
}

typedef struct {
    const char *mesh, *out;
    int lights, grid, bands, width, height, threads, quick, moon;
    char up;
} options;

static const char *value_of(const char *option, const char *text)
{
    if (!text) die("%s takes a value; --help lists the options", option);
    return text;
}

static int number(const char *option, const char *text, int low, int high)
{
    char *end;
    const long v = strtol(value_of(option, text), &end, 10);
    if (end == text || *end || v < low || v > high)
        die("%s takes a number from %d to %d, not '%s'", option, low, high, text);
    return (int)v;
}

static options parse(int argc, char **argv)
{
    options o = { NULL, "build/demo", 900, 8, 0, 960, 540, 0, 0, 1, 'y' };
    int i;

    for (i = 1; i < argc; i++) {
        const char *name = argv[i], *value = argv[i + 1];
        if (!strcmp(name, "--help")) { fputs(help, stdout); exit(0); }
        if (!strcmp(name, "--quick")) { o.quick = 1; continue; }
        if (!strcmp(name, "--no-moon")) { o.moon = 0; continue; }
        if (!strcmp(name, "--mesh")) o.mesh = value_of(name, value);
        else if (!strcmp(name, "--out")) o.out = value_of(name, value);
        else if (!strcmp(name, "--lights")) o.lights = number(name, value, 1, 1000000);
        else if (!strcmp(name, "--grid")) o.grid = number(name, value, 2, 128);
        else if (!strcmp(name, "--bands")) o.bands = number(name, value, 1, BANDS);
        else if (!strcmp(name, "--threads")) o.threads = number(name, value, 1, 4096);
        else if (!strcmp(name, "--up")) {
            o.up = *value_of(name, value);
            if (strcmp(value, "y") && strcmp(value, "z")) die("--up takes y or z, not '%s'", value);
        } else if (!strcmp(name, "--size")) {
            char end;
            if (sscanf(value_of(name, value), "%dx%d%c", &o.width, &o.height, &end) != 2
                || o.width < 16 || o.height < 16 || o.width > 8192 || o.height > 8192)
                die("--size takes WIDTHxHEIGHT, each from 16 to 8192, not '%s'", value);
        } else
            die("unknown option '%s'; --help lists them", name);
        i++;
    }
    return o;
}

static void compare(const scene *s, const view *w, const float *blocked, const options *o, int bands)
{
    method at[] = {
        { "per pixel",           PER_POINT,          0,       0,           0, 0, 0, 0, NULL },
        { "trilinear",           SH_TRILINEAR,       o->grid, SH_VALUES,   0, 0, 0, 0, NULL },
        { "trilinear",           SH_TRILINEAR,   2 * o->grid, SH_VALUES,   0, 0, 0, 0, NULL },
        { "half Taylor",         SH_HALF_TAYLOR,     o->grid, SH_GRADIENT, 0, 0, 0, 0, NULL },
        { "blended Taylor",      SH_BLENDED_TAYLOR,  o->grid, SH_GRADIENT, 0, 0, 0, 0, NULL },
        { "Hermite, no mixed",   SH_HERMITE_ZERO,    o->grid, SH_GRADIENT, 0, 0, 0, 0, NULL },
        { "Hermite, mixed",      SH_HERMITE_MIXED,   o->grid, SH_GRADIENT, 0, 0, 0, 0, NULL },
        { "edge Hermite",        SH_EDGE_HERMITE,    o->grid, SH_GRADIENT, 0, 0, 0, 0, NULL },
        { "blended Taylor 2 *",  SH_BLENDED_TAYLOR2, o->grid, SH_HESSIAN,  0, 0, 0, 0, NULL },
    };
    enum { METHODS = sizeof at / sizeof *at };
    const size_t values = 3 * (size_t)o->width * (size_t)o->height;
    const int shrink = o->width >= 640 ? 2 : 1, width = o->width / shrink, height = o->height / shrink;
    float exposure, *reference;
    sheet errors = sheet_new(3 * width, 3 * (height + LABEL));
    char text[256];
    int i;

    shade(s, w, blocked, bands, at, METHODS);
    exposure = picture_exposure(w, at[0].rgb);
    reference = picture_develop(w, at[0].rgb, exposure);
    if (s->p.count) sprintf(text, " and a moon of %d sides", s->p.corners);
    printf("\n%d spheres%s, %d bands, %d x %d pixels, %d points shaded\n", s->l.count, s->p.count ? text : "", bands,
           o->width, o->height, w->count);
    printf("%-20s %5s %10s %10s %10s %9s\n", "scheme", "nodes", "build ms", "shade ms", "error/1000", "speed-up");
    for (i = 0; i < METHODS; i++) {
        float *picture = picture_develop(w, at[i].rgb, exposure);
        const int left = i % 3 * width, top = i / 3 * (height + LABEL);
        char nodes[16] = "-";

        if (at[i].scheme == SH_EDGE_HERMITE) {
            sheet whole = sheet_new(o->width, o->height);
            sprintf(text, "%.200s.png", o->out);
            sheet_paste(&whole, 0, 0, picture, o->width, o->height, 1);
            sheet_write(&whole, text);
        }
        if (at[i].scheme != PER_POINT) {
            at[i].error = picture_difference(picture, reference, 100, values, picture);
            sprintf(nodes, "%d^3", at[i].nodes);
        }
        printf("%-20s %5s %10.2f %10.2f %10.3f %8.1fx\n", at[i].name, nodes, 1e3 * at[i].build, 1e3 * at[i].shade,
               1e3 * at[i].error, at[0].shade / (at[i].build + at[i].shade));
        if (i == 0) sprintf(text, "%d bands per pixel; 100 x the error of:", bands);
        else sprintf(text, "%s %s  error %.3fe-3", at[i].name, nodes, 1e3 * at[i].error);
        sheet_label(&errors, left, top, width, text);
        sheet_paste(&errors, left, top + LABEL, picture, o->width, o->height, shrink);
        free(picture);
        free(at[i].rgb);
    }
    if (s->p.count) printf("* polygons have no Hessian: the moon is evaluated at every point\n");
    printf("error: mean absolute difference of the picture from per pixel, sRGB values 0 to 1\n");
    sprintf(text, "%.200s-error.png", o->out);
    sheet_write(&errors, text);
    free(reference);
}

int main(int argc, char **argv)
{
    const options o = parse(argc, argv);
    char polygons[256];
    scene room, s;
    view w;
    float *blocked;

#if defined(_OPENMP)
    if (o.threads) omp_set_num_threads(o.threads);
#endif
    scene_build(&room, o.mesh, o.up, o.lights, o.quick);
    scene_copy(&s, &room);
    if (o.moon) scene_add_moon(&s);
    view_trace(&w, &s, o.width, o.height);
    picture_glow(&w);
    blocked = trace_blocked(&room, BANDS, o.quick ? 128 : 1024);
    if (o.bands) compare(&s, &w, blocked, &o, o.bands);
    else {
        compare(&s, &w, blocked, &o, 5);
        compare(&s, &w, blocked, &o, 9);
    }
    sprintf(polygons, "%.200s-polygons.png", o.out);
    lamps_compare(&room, blocked, o.bands ? o.bands : 9, o.grid, o.quick ? 5 : 19, o.width / 2, o.height / 2,
                  polygons);
    printf("\nwrote %.200s.png, %.200s-error.png, %s\n", o.out, o.out, polygons);
    scene_free_copy(&s);
    scene_free_copy(&room);
    free(room.l.sphere); free(room.l.radiance); free(w.at); free(w.glow); free(blocked);
    return 0;
}
