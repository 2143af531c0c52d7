/* demo.c - hundreds of lights on a grid of spherical harmonics, by the GPU: a picture with figures, or a window. */
#include "gl.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

const char *program_name = "gl-demo";

static const char help[] =
    "usage: gl-demo [options]\n"
    "Sums the lights of the relight example on a grid of spherical-harmonics coefficients and gradients in a compute\n"
    "shader, shades every pixel from it in a fragment shader, and compares: the grid with the C headers, the picture\n"
    "with the lights summed anew at every pixel. Writes a picture and prints figures; or opens a window.\n"
    "  --window        interactive; its keys are shown there\n"
    "  --lights N      1 or more [720]\n"
    "  --kind K        spheres, triangles (each taken for a sphere) or polygons (triangles, exact) [spheres]\n"
    "  --bands N       of the light, 3 to 9 [5]\n"
    "  --lobe N        of the glossy lobe, from --bands to 9 [9]\n"
    "  --grid N        nodes along each axis, 2 to 24 [8]\n"
    "  --form F        forward, reverse or moments: how the grid is summed [moments]\n"
    "  --scheme S      trilinear, hermite (no mixed derivatives), edge or pixel [edge]\n"
    "  --size WxH      of the picture [960x540]\n"
    "  --samples N     N x N per pixel of the picture without a window, 1 to 4 [2]\n"
    "  --no-occlusion  without the ambient occlusion in screen space\n"
    "  --time T        seconds into the lights' and the teapot's motion [0]\n"
    "  --out FILE      the picture [build/gl-demo.png]\n"
    "  --error         the window starts with the error's heat map\n"
    "  --frames N      leave the window after N frames and write the last one to FILE\n"
    "  --quick         coarse geometry\n"
    "  --help\n"
    "Exit code 0; 1 if the grid is off by more than the bound; 2 for a bad command line; 77 without OpenGL 4.5.\n";

typedef struct { settings o; int lights, window, frames, quick, error; const char *out; double time; } options;

static const char *const forms[] = { "forward", "reverse", "moments", NULL };
static const char *const kinds[] = { "spheres", "triangles", "polygons", NULL };
static const char *const scheme_names[] = { "trilinear", "hermite", "edge", "pixel", NULL };
static const char *const scheme_titles[] = { "trilinear", "Hermite, mixed derivatives zero", "edge Hermite", "per pixel, no grid" };
static const int schemes[] = { 0, 3, 5, PER_POINT };       /* SH_TRILINEAR, SH_HERMITE_ZERO, SH_EDGE_HERMITE */

enum { ERROR_SCALE = 40 };

static int scheme_index(int scheme) { return scheme == 0 ? 0 : scheme == 3 ? 1 : scheme == 5 ? 2 : 3; }

static int number(const char *option, const char *text, int low, int high)
{
    char *end;
    const long v = strtol(text, &end, 10);
    if (end == text || *end || v < low || v > high) die("%s takes a number from %d to %d, not '%s'", option, low, high, text);
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
    static const char *const valued[] = { "--lights", "--kind", "--bands", "--lobe", "--grid", "--form", "--scheme", "--size",
                                          "--samples", "--time", "--out", "--frames", NULL };
    options a;
    settings *o = &a.o;
    int i, k;

    memset(&a, 0, sizeof a);
    a.lights = 720; a.out = "build/gl-demo.png";
    o->bands = 5; o->lobe_bands = MAX_BANDS; o->form = MOMENTS; o->scheme = 5; o->lanes = 8;
    o->nodes[0] = o->nodes[1] = o->nodes[2] = 8;
    o->occlusion = 1; o->samples = 2; o->width = 960; o->height = 540;
    for (i = 1; i < argc; i++) {
        const char *name = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        if (!strcmp(name, "--help")) { fputs(help, stdout); exit(0); }
        if (!strcmp(name, "--window")) { a.window = 1; continue; }
        if (!strcmp(name, "--error")) { a.error = 1; continue; }
        if (!strcmp(name, "--quick")) { a.quick = 1; continue; }
        if (!strcmp(name, "--no-occlusion")) { o->occlusion = 0; continue; }
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
        if (!strcmp(name, "--time")) {
            char *end;
            a.time = strtod(v, &end);
            if (end == v || *end || !(a.time >= 0 && a.time < 1e6)) die("--time takes seconds from 0 to 1000000, not '%s'", v);
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

static void write_png(const char *path, const unsigned char *rgb, int width, int height)
{
    if (!stbi_write_png(path, width, height, 3, rgb, 3 * width)) die("cannot write %s", path);
}

/* ---- without a window ---- */

/* The time of a pass once its shaders are compiled: a first run with one light, and then the one that counts. */
static double timed_grid(const settings *o, const stage *s, const light *now)
{
    passes_lights(now, 1);
    pass_grid(o, s);
    passes_ms(GRID);
    passes_lights(now, s->count);
    pass_grid(o, s);
    return passes_ms(GRID);
}

static double timed_shading(const settings *o, const stage *s, const light *now, int as_reference)
{
    passes_lights(now, 1);
    pass_shading(o, s, &s->eye, as_reference);
    passes_ms(SHADING);
    passes_lights(now, s->count);
    pass_shading(o, s, &s->eye, as_reference);
    return passes_ms(SHADING);
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

static void label(const settings *o, float zoom, const char *text) { passes_text(o, 12 * zoom, 12 * zoom, zoom, text); }

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

static int headless(const options *a, const stage *s, light *now)
{
    settings o = a->o;
    const size_t bytes = 3 * (size_t)o.width * (size_t)o.height;
    unsigned char *page = need(NULL, bytes + bytes / 3, 1), *part;
    double grid_ms = 0, pixel_ms;
    float exposure = 0;
    char text[200];
    int i, good = 1;

    printf("%s, %s\n", (const char *)glGetString(GL_RENDERER), (const char *)glGetString(GL_VERSION));
    printf("%d %s, %d bands, lobes of %d, grid %d x %d x %d, %d x %d pixels; times by the %s\n\n", s->count, kinds[o.kind], o.bands,
           o.lobe_bands, o.nodes[0], o.nodes[1], o.nodes[2], o.width, o.height, passes_clock());

    printf("pass                   ms   off sh_*.h by eps of the band's maximum (bound %d)\n", AGREEMENT_BOUND);
    for (i = FORWARD; i <= MOMENTS; i++) {
        agreement g;
        double ms;
        o.form = i == MOMENTS ? a->o.form : i < a->o.form ? i : i + 1;          /* the chosen one last: it stays */
        if (o.kind == POLYGON_LIGHTS && i < MOMENTS) continue;
        progress("grid", i / 3.0);
        ms = timed_grid(&o, s, now);
        g = check_grid(&o, s, now);
        progress("grid", 1);
        sprintf(text, "grid, %s", o.kind == POLYGON_LIGHTS ? "lobes" : forms[o.form]);
        printf("%-15s %9.2f   values %.1f, gradients %.1f\n", text, ms, g.value, g.gradient);
        good = good && g.value <= AGREEMENT_BOUND && g.gradient <= AGREEMENT_BOUND;
        grid_ms = ms;
    }
    o.samples = 1;
    for (i = 0; i < 2; i++) {                               /* the second run is free of compiling */
        pass_surfaces(&o, &s->eye);
        pass_occlusion(&o, &s->eye);
        passes_ms(OCCLUSION);
    }
    printf("%-15s %9.2f\n%-15s %9.2f\n\n", "surfaces", passes_ms(SURFACES), "occlusion", passes_ms(OCCLUSION));

    printf("shading                                  ms   MAE x 1e3   largest   grid + shading over per pixel\n");
    progress("per pixel", 0.3);
    o.scheme = PER_POINT;
    pixel_ms = timed_shading(&o, s, now, 1);
    progress("per pixel", 1);
    printf("%-34s %8.2f\n", scheme_titles[3], pixel_ms);
    for (i = 0; i < 3; i++) {
        const double ms = (o.scheme = schemes[i], timed_shading(&o, s, now, 0));
        difference d;
        if (i == 0) exposure = passes_exposure(&o);
        d = against_reference(o, exposure);
        printf("%-34s %8.2f   %9.3f   %7.4f   %.1fx\n", scheme_titles[i], ms, 1e3 * d.mean, d.largest, pixel_ms / (grid_ms + ms));
        sprintf(text, "%s: %d x error, MAE %.2f / 1000", scheme_names[i], ERROR_SCALE, 1e3 * d.mean);
        label(&o, 3, text);
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
    if (!good) fprintf(stderr, "gl-demo: the GPU's grid is off by more than %d eps of the band's maximum\n", AGREEMENT_BOUND);
    free(part);
    free(page);
    return !good;
}

/* ---- with one ---- */

typedef struct { options *a; stage *s; double x, y, yaw, pitch, distance; int drag, heat, moving, shown, changed; } view_state;
static view_state state;

static const char keys[] =
    "drag orbit   wheel distance   space move   esc leave\n"
    "b B bands   g G grid   l L lights   k kind   f form\n"
    "s scheme   e error, 20 x   o occlusion   h this text";

static int step(int v, int by, int low, int high) { return v + by < low ? low : v + by > high ? high : v + by; }

static void on_key(GLFWwindow *w, int key, int scan, int action, int mods)
{
    settings *o = &state.a->o;
    const int by = mods & GLFW_MOD_SHIFT ? -1 : 1;
    (void)scan;
    if (action == GLFW_RELEASE) return;
    switch (key) {
    case GLFW_KEY_ESCAPE: glfwSetWindowShouldClose(w, 1); break;
    case GLFW_KEY_SPACE: state.moving = !state.moving; break;
    case GLFW_KEY_B: o->bands = step(o->bands, by, MIN_BANDS, MAX_BANDS); break;
    case GLFW_KEY_G: o->nodes[0] = o->nodes[1] = o->nodes[2] = step(o->nodes[0], by, 2, 24); break;
    case GLFW_KEY_L: state.a->lights = by > 0 ? step(2 * state.a->lights, 0, 1, 8192) : step(state.a->lights / 2, 0, 1, 8192);
                     state.changed = 1; break;
    case GLFW_KEY_K: o->kind = (o->kind + 1) % 3; break;
    case GLFW_KEY_F: o->form = (o->form + 1) % 3; break;
    case GLFW_KEY_S: o->scheme = schemes[(scheme_index(o->scheme) + 1) % 4]; break;
    case GLFW_KEY_E: state.heat = !state.heat; break;
    case GLFW_KEY_O: o->occlusion = !o->occlusion; break;
    case GLFW_KEY_H: state.shown = !state.shown; break;
    default: break;
    }
    if (o->lobe_bands < o->bands) o->lobe_bands = o->bands;
}

static void on_button(GLFWwindow *w, int button, int action, int mods)
{
    (void)mods;
    if (button == GLFW_MOUSE_BUTTON_LEFT) state.drag = action == GLFW_PRESS;
    glfwGetCursorPos(w, &state.x, &state.y);
}

static void on_move(GLFWwindow *w, double x, double y)
{
    (void)w;
    if (state.drag) {
        state.yaw -= 0.006 * (x - state.x);
        state.pitch = fmin(fmax(state.pitch + 0.006 * (y - state.y), 0.02), 1.4);
    }
    state.x = x;
    state.y = y;
}

static void on_wheel(GLFWwindow *w, double x, double y)
{
    (void)w; (void)x;
    state.distance = fmin(fmax(state.distance * exp(-0.1 * y), 4), 30);
}

static camera orbit(const stage *s)
{
    camera c = s->eye;
    const float k = (float)(state.distance * cos(state.pitch));
    c.eye = add(c.at, vec(k * (float)sin(state.yaw), -k * (float)cos(state.yaw), (float)(state.distance * sin(state.pitch))));
    return c;
}

static int interactive(options *a, stage *s, GLFWwindow *w)
{
    light *now = need(NULL, (size_t)s->count, sizeof *now);
    const vec3 from = sub(s->eye.eye, s->eye.at);
    float exposure = 0;
    double ms[PASSES] = { 0 }, reference_ms = 0, clock = a->time, last = glfwGetTime(), fps = 0;
    int frames = 0;

    state.a = a; state.s = s; state.shown = 1; state.heat = a->error; state.moving = a->frames == 0;
    state.distance = sqrt((double)dot(from, from));
    state.yaw = atan2((double)from.x, -(double)from.y);
    state.pitch = asin((double)from.z / state.distance);
    glfwSetKeyCallback(w, on_key);
    glfwSetMouseButtonCallback(w, on_button);
    glfwSetCursorPosCallback(w, on_move);
    glfwSetScrollCallback(w, on_wheel);
    a->o.samples = 1;
    while (!glfwWindowShouldClose(w)) {
        settings *o = &a->o, t;
        const double seconds = glfwGetTime();
        camera c;
        char text[700];
        int width, height;

        glfwGetFramebufferSize(w, &width, &height);
        if (width < 64 || height < 64) { glfwWaitEvents(); continue; }
        o->width = width;
        o->height = height;
        if (state.changed) {
            stage_free(s);
            passes_close();
            stage_build(s, a->lights, a->quick);
            passes_open(s);
            now = need(now, (size_t)s->count, sizeof *now);
            state.changed = 0;
        }
        if (state.moving) clock += seconds - last;
        fps = frames < 2 ? 0 : frames == 2 ? 1 / fmax(seconds - last, 1e-6) : 0.9 * fps + 0.1 / fmax(seconds - last, 1e-6);
        last = seconds;
        o->turn = (float)(0.3 * clock);
        stage_move(s, o->kind != SPHERE_LIGHTS, clock, now);
        passes_lights(now, s->count);
        c = orbit(s);
        pass_grid(o, s);
        pass_surfaces(o, &c);
        pass_occlusion(o, &c);
        pass_shading(o, s, &c, 0);
        ms[SHADING] = passes_ms(SHADING);
        t = *o;
        if (state.heat) {
            t.scheme = PER_POINT;
            pass_shading(&t, s, &c, 1);
            reference_ms = passes_ms(SHADING);
            t = *o;
            t.error_scale = 20;
        }
        if (frames % 32 == 0) exposure = passes_exposure(o);
        pass_picture(&t, exposure);
        ms[GRID] = passes_ms(GRID); ms[SURFACES] = passes_ms(SURFACES); ms[OCCLUSION] = passes_ms(OCCLUSION);
        ms[PICTURE] = passes_ms(PICTURE);
        if (state.shown) {
            int n = sprintf(text, "%.80s   %.1f frames/s\n%d %s   %d bands   grid %d^3   %s   %s\n"
                            "grid %.2f   surfaces %.2f   occlusion %.2f   shading %.2f   picture %.2f ms",
                            (const char *)glGetString(GL_RENDERER), fps, s->count, kinds[o->kind], o->bands, o->nodes[0],
                            o->kind == POLYGON_LIGHTS ? "lobes" : forms[o->form], scheme_titles[scheme_index(o->scheme)],
                            ms[GRID], ms[SURFACES], ms[OCCLUSION], ms[SHADING], ms[PICTURE]);
            if (state.heat) n += sprintf(text + n, "\nerror against per pixel (%.2f ms), 20 x", reference_ms);
            sprintf(text + n, "\n\n%s", keys);
            label(&t, t.width < 1200 ? 1 : 2, text);
        }
        passes_show(&t, width, height);
        glfwSwapBuffers(w);
        glfwPollEvents();
        if (++frames == a->frames) {
            unsigned char *rgb = passes_picture(&t);
            write_png(a->out, rgb, width, height);
            free(rgb);
            break;
        }
    }
    free(now);
    return 0;
}

static void complain(int code, const char *text) { fprintf(stderr, "gl: GLFW: %s (0x%x)\n", text, (unsigned)code); }

static GLFWwindow *open_window(int width, int height)
{
    GLFWwindow *w;

    glfwSetErrorCallback(complain);
    if (!glfwInit()) return NULL;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    w = glfwCreateWindow(width, height, "spherical harmonics on a grid", NULL, NULL);
    if (!w) return NULL;
    glfwMakeContextCurrent(w);
    glfwSwapInterval(1);
    return context_enough() ? w : NULL;
}

int main(int argc, char **argv)
{
    options a = parse(argc, argv);
    GLFWwindow *w = NULL;
    stage s;
    light *now;
    int code;

    if (a.window ? !(w = open_window(a.o.width, a.o.height)) : !context_headless()) {
        if (a.window) glfwTerminate();
        return MISSING;
    }
    stage_build(&s, a.lights, a.quick);
    passes_open(&s);
    if (w) code = interactive(&a, &s, w);
    else {
        now = need(NULL, (size_t)s.count, sizeof *now);
        a.o.turn = (float)(0.3 * a.time);
        stage_move(&s, a.o.kind != SPHERE_LIGHTS, a.time, now);
        passes_lights(now, s.count);
        code = headless(&a, &s, now);
        free(now);
    }
    passes_close();
    if (w) glfwTerminate();
    context_close();
    stage_free(&s);
    return code;
}
