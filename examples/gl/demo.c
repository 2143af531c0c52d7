/* demo.c - hundreds of lights on a grid of spherical harmonics, by the GPU: options, a picture, figures. */
#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

const char *program_name = "gl-demo";

static const char help[] =
    "usage: gl-demo [options]\n"
    "Sums the lights of the relight example, spheres and a moon, on a grid of SH coefficients and gradients in a\n"
    "compute shader, shades every pixel from it in a fragment shader, under ray-traced shadows, and compares: the\n"
    "grid with the C headers, the picture with the lights summed anew at every pixel. Writes a picture and prints\n"
    "figures; or opens a window.\n"
    "  --window        interactive; its keys are shown there\n"
    "  --lights N      spheres, 1 or more [900]\n"
    "  --kind K        spheres, triangles (each taken for a sphere) or polygons (triangles, exact), beside the\n"
    "                  moon, a polygon [spheres]\n"
    "  --bands N       of the light, 3 to 9 [5]\n"
    "  --lobe N        of the glossy lobe, from --bands to 9 [9]\n"
    "  --grid N        nodes along each axis, 2 to 24 [8]\n"
    "  --form F        forward, reverse or moments: how the grid is summed [moments]\n"
    "  --scheme S      trilinear, hermite (no mixed derivatives), edge or pixel [edge]\n"
    "  --size WxH      of the picture [960x540]\n"
    "  --samples N     N x N per pixel of the picture without a window, 1 to 4 [2]\n"
    "  --no-shadows    without the ray-traced shadows\n"
    "  --occlusion     with ambient occlusion in screen space\n"
    "  --time T        seconds into the lights' and the teapot's motion [0]\n"
    "  --out FILE      the picture [build/gl-demo.png]\n"
    "  --error         the window starts with the error's heat map\n"
    "  --frames N      leave the window after N frames and write the last one to FILE\n"
    "  --keys KEYS     pressed one by one, one before each frame of the window\n"
    "  --quick         coarse geometry and shadows\n"
    "  --help\n"
    "Exit code 0; 1 if the grid is off by more than the bound; 2 for a bad command line; 77 without OpenGL 4.5.\n";

const char *const forms[] = { "forward", "reverse", "moments", NULL };
const char *const kinds[] = { "spheres", "triangles", "polygons", NULL };
static const char *const scheme_names[] = { "trilinear", "hermite", "edge", "pixel", NULL };
const char *const scheme_titles[] = { "trilinear", "Hermite, mixed derivatives zero", "edge Hermite",
                                      "per pixel, no grid" };
const int schemes[SCHEMES] = { 0, 3, 5, PER_POINT };      /* SH_TRILINEAR, SH_HERMITE_ZERO, SH_EDGE_HERMITE */

int scheme_index(int scheme) { return scheme == 0 ? 0 : scheme == 3 ? 1 : scheme == 5 ? 2 : 3; }

static int number(const char *option, const char *text, int low, int high)
{
    char *end;
    const long v = strtol(text, &end, 10);
    if (end == text || *end || v < low || v > high)
        die("%s takes a number from %d to %d, not '%s'", option, low, high, text);
    return (int)v;
}

static int choice(const char *option, const char *text, const char *const *of)
{
    int i;
    for (i = 0; of[i]; i++)
        if (!strcmp(of[i], text)) return i;
    die("%s does not know '%s'; --help lists what it takes", option, text);
}

static options parse(int argc, char **argv)
{
    static const char *const valued[] = { "--lights", "--kind", "--bands", "--lobe", "--grid", "--form", "--scheme",
                                          "--size", "--samples", "--time", "--out", "--frames", "--keys", NULL };
    options a;
    settings *o = &a.o;
    int i, k;

    memset(&a, 0, sizeof a);
    a.lights = 900; a.how = STAGE_FULL; a.out = "build/gl-demo.png";
    o->bands = 5; o->lobe_bands = MAX_BANDS; o->form = MOMENTS; o->scheme = 5;
    o->nodes[0] = o->nodes[1] = o->nodes[2] = 8;
    o->shadows = 1; o->samples = 2; o->width = 960; o->height = 540;
    for (i = 1; i < argc; i++) {
        const char *name = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        if (!strcmp(name, "--help")) { fputs(help, stdout); exit(0); }
        if (!strcmp(name, "--window")) { a.window = 1; continue; }
        if (!strcmp(name, "--error")) { a.error = 1; continue; }
        if (!strcmp(name, "--quick")) { a.how = STAGE_COARSE; continue; }
        if (!strcmp(name, "--no-shadows")) { o->shadows = 0; continue; }
        if (!strcmp(name, "--occlusion")) { o->occlusion = 1; continue; }
        for (k = 0; valued[k] && strcmp(valued[k], name); k++) {}
        if (!valued[k]) die("unknown option '%s'; --help lists them", name);
        if (!v) die("%s takes a value; --help lists the options", name);
        i++;
        if (!strcmp(name, "--lights")) a.lights = number(name, v, 1, MAX_LIGHTS);
        if (!strcmp(name, "--kind")) o->kind = choice(name, v, kinds);
        if (!strcmp(name, "--bands")) o->bands = number(name, v, MIN_BANDS, MAX_BANDS);
        if (!strcmp(name, "--lobe")) o->lobe_bands = number(name, v, MIN_BANDS, MAX_BANDS);
        if (!strcmp(name, "--grid")) o->nodes[0] = o->nodes[1] = o->nodes[2] = number(name, v, 2, 24);
        if (!strcmp(name, "--form")) o->form = choice(name, v, forms);
        if (!strcmp(name, "--scheme")) o->scheme = schemes[choice(name, v, scheme_names)];
        if (!strcmp(name, "--samples")) o->samples = number(name, v, 1, 4);
        if (!strcmp(name, "--frames")) a.frames = number(name, v, 1, 1000000);
        if (!strcmp(name, "--out")) a.out = v;
        if (!strcmp(name, "--keys")) a.keys = v;
        if (!strcmp(name, "--time")) {
            char *end;
            a.time = strtod(v, &end);
            if (end == v || *end || !(a.time >= 0 && a.time < 1e6))
                die("--time takes seconds from 0 to 1000000, not '%s'", v);
        }
        if (!strcmp(name, "--size")) {
            char more;
            if (sscanf(v, "%dx%d%c", &o->width, &o->height, &more) != 2 || o->width < 64 || o->height < 64
                || o->width > 4096 || o->height > 4096)
                die("--size takes WIDTHxHEIGHT, each from 64 to 4096, not '%s'", v);
        }
    }
    if (o->lobe_bands < o->bands) o->lobe_bands = o->bands;
    return a;
}

void write_png(const char *path, const unsigned char *rgb, int width, int height)
{
    if (!stbi_write_png(path, width, height, 3, rgb, 3 * width)) die("cannot write %s", path);
}

/* ---- the picture and its figures ---- */

/* The time of a pass once its shaders are compiled: a first run with few lights, and then the one that
 * counts. */
static double timed(const settings *o, const stage *s, const light *now, int pass, int as_reference)
{
    int few;
    for (few = 1; few >= 0; few--) {
        passes_lights(o, s, now, few);
        if (pass == GRID) pass_grid(o, s);
        else pass_shading(o, s, &s->eye, as_reference);
        passes_ms(pass);
    }
    return passes_ms(pass);
}

/* A third of the picture's size, under it. */
static void paste_small(unsigned char *page, int width, int left, int top, const unsigned char *rgb, int height)
{
    int x, y, k, i;
    for (y = 0; y < height / 3; y++)
        for (x = 0; x < width / 3; x++)
            for (k = 0; k < 3; k++) {
                int sum = 4;
                for (i = 0; i < 9; i++) sum += rgb[3 * ((3 * y + i / 3) * width + 3 * x + i % 3) + k];
                page[3 * ((top + y) * width + left + x) + k] = (unsigned char)(sum / 9);
            }
}

void label(const settings *o, float zoom, const char *text) { letters_draw(o, 12 * zoom, 12 * zoom, zoom, text); }

typedef struct { double mean, largest; } difference;

static difference against_reference(settings o, float exposure)
{
    const size_t pixels = (size_t)o.width * (size_t)o.height;
    difference d = { 0, 0 };
    float *rgba;
    size_t i;

    o.error_scale = ERROR_SCALE;                            /* the picture's alpha is then the error */
    pass_picture(&o, exposure);
    rgba = passes_image(&o, PICTURE);
    for (i = 0; i < pixels; i++) {
        const double e = (double)rgba[4 * i + 3];
        d.mean += e / (double)pixels;
        d.largest = worse(d.largest, e);
    }
    free(rgba);
    return d;
}

static void say_whether(const char *text, double ms, const agreement *g, int *good)
{
    printf("%-15s %9.2f   values %.1f, gradients %.1f\n", text, ms, g->value, g->gradient);
    *good = *good && g->value <= AGREEMENT_BOUND && g->gradient <= AGREEMENT_BOUND;
}

/* Every form of the grid, the chosen one last: it stays. The time of that one. */
static double grids(settings o, const stage *s, const light *now, int *good)
{
    const int chosen = o.form;
    double ms = 0;
    char text[40];
    int i;

    printf("pass                   ms   off sh_*.h by eps of the band's maximum (bound %d)\n", AGREEMENT_BOUND);
    for (i = FORWARD; i <= MOMENTS; i++) {
        agreement g;
        o.form = i == MOMENTS ? chosen : i < chosen ? i : i + 1;
        if (o.kind == POLYGON_LIGHTS && i < MOMENTS) continue;
        progress("grid", i / 3.0);
        ms = timed(&o, s, now, GRID, 0);
        g = check_grid(&o, s, now);
        progress("grid", 1);
        sprintf(text, "grid, %s", o.kind == POLYGON_LIGHTS ? "exact" : forms[o.form]);
        say_whether(text, ms, &g, good);
    }
    return ms;
}

static int headless(const options *a, const stage *s, light *now)
{
    settings o = a->o;
    const size_t bytes = 3 * (size_t)o.width * (size_t)o.height;
    unsigned char *page = need(NULL, bytes + bytes / 3, 1), *part;
    double grid_ms, pixel_ms;
    float exposure = 0;
    char text[200];
    int i, good = 1;

    printf("%s, %s\n", (const char *)glGetString(GL_RENDERER), (const char *)glGetString(GL_VERSION));
    printf("%d %s and a moon of %d sides, %d bands, lobes of %d, grid %d x %d x %d, %d x %d pixels; times by the %s\n\n",
           s->count, kinds[o.kind], s->moon_corners, o.bands, o.lobe_bands, o.nodes[0], o.nodes[1], o.nodes[2],
           o.width, o.height, passes_clock());
    grid_ms = grids(o, s, now, &good);
    o.samples = 1;
    for (i = 0; i < 2; i++) {                               /* the second run is free of compiling */
        pass_surfaces(&o, &s->eye);
        pass_occlusion(&o, &s->eye);
        passes_ms(OCCLUSION);
    }
    printf("%-15s %9.2f\n", "surfaces", passes_ms(SURFACES));
    if (o.occlusion) printf("%-15s %9.2f\n", "occlusion", passes_ms(OCCLUSION));

    printf("\nshading                                  ms  error/1000   largest   grid + shading over per pixel\n");
    progress("per pixel", 0.3);
    o.scheme = PER_POINT;
    pixel_ms = timed(&o, s, now, SHADING, 1);
    progress("per pixel", 1);
    printf("%-34s %8.2f\n", scheme_titles[3], pixel_ms);
    for (i = 0; i < 3; i++) {
        double ms;
        difference d;
        o.scheme = schemes[i];
        ms = timed(&o, s, now, SHADING, 0);
        if (i == 0) exposure = passes_exposure(&o);
        d = against_reference(o, exposure);
        printf("%-34s %8.2f   %9.3f   %7.4f   %.1fx\n", scheme_titles[i], ms, 1e3 * d.mean, d.largest,
               pixel_ms / (grid_ms + ms));
        sprintf(text, "%s: %d x error, mean %.2f / 1000", scheme_names[i], ERROR_SCALE, 1e3 * d.mean);
        label(&o, (float)o.width / 320, text);
        part = passes_picture(&o);
        paste_small(page, o.width, i * (o.width / 3), o.height, part, o.height);
        free(part);
    }

    o = a->o;
    pass_surfaces(&o, &s->eye);
    pass_occlusion(&o, &s->eye);
    pass_shading(&o, s, &s->eye, 0);
    pass_picture(&o, exposure);
    passes_ms(PICTURE);
    pass_picture(&o, exposure);
    printf("%-34s %8.2f\n", "tone, glow, sRGB", passes_ms(PICTURE));
    part = passes_picture(&o);
    memcpy(page, part, bytes);
    write_png(a->out, page, o.width, o.height + o.height / 3);
    printf("\n%s: %s; below, the error of three schemes\n", a->out, scheme_titles[scheme_index(o.scheme)]);
    if (!good)
        fprintf(stderr, "gl-demo: the GPU's grid is off by more than %d eps of the band's maximum\n", AGREEMENT_BOUND);
    free(part);
    free(page);
    return !good;
}

int main(int argc, char **argv)
{
    options a = parse(argc, argv);
    stage s;
    light *now;
    int code;

    if (!(a.window ? window_open(a.o.width, a.o.height) : context_headless())) return MISSING;
    stage_build(&s, a.lights, a.how);
    passes_open(&s);
    if (a.window) code = window_run(&a, &s);
    else {
        now = need(NULL, (size_t)(s.count + s.moon), sizeof *now);
        a.o.turn = (float)(0.3 * a.time);
        stage_move(&s, a.o.kind != SPHERE_LIGHTS, a.time, now);
        code = headless(&a, &s, now);
        free(now);
    }
    passes_close();
    if (a.window) window_close();
    else context_close();
    stage_free(&s);
    return code;
}
