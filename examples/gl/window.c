/* window.c - the demo live: orbit, lights, bands, grid, forms, schemes, error; by GLFW. */
#include "gl.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <stdio.h>
#include <stdlib.h>

static GLFWwindow *window;
static struct {
    options *a;
    double x, y, yaw, pitch, distance;                      /* the mouse; the camera's orbit */
    int drag, heat, moving, shown, changed;
} state;

static const char keys[] =
    "drag orbit   wheel distance   space move   esc leave\n"
    "b B bands   g G grid   l L lights   k kind   f form\n"
    "s scheme   e error, 40 x   r shadows   o occlusion   h this text";

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
    case GLFW_KEY_L:
        state.a->lights = step(by > 0 ? 2 * state.a->lights : state.a->lights / 2, 0, 1, 8192);
        state.changed = 1;
        break;
    case GLFW_KEY_K: o->kind = (o->kind + 1) % 3; break;
    case GLFW_KEY_F: o->form = (o->form + 1) % 3; break;
    case GLFW_KEY_S: o->scheme = schemes[(scheme_index(o->scheme) + 1) % 4]; break;
    case GLFW_KEY_E: state.heat = !state.heat; break;
    case GLFW_KEY_R: o->shadows = !o->shadows; break;
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
    const double k = state.distance * cos(state.pitch), up = state.distance * sin(state.pitch);
    camera c = s->eye;
    c.eye = add(c.at, vec((float)(k * sin(state.yaw)), (float)(-k * cos(state.yaw)), (float)up));
    return c;
}

static void start(options *a, const stage *s)
{
    const vec3 from = sub(s->eye.eye, s->eye.at);
    state.a = a;
    state.shown = 1;
    state.heat = a->error;
    state.moving = a->frames == 0;
    state.distance = sqrt((double)dot(from, from));
    state.yaw = atan2((double)from.x, -(double)from.y);
    state.pitch = asin((double)from.z / state.distance);
    glfwSetKeyCallback(window, on_key);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_move);
    glfwSetScrollCallback(window, on_wheel);
}

static void readout(const settings *o, const stage *s, const double ms[PASSES], double reference_ms, double fps)
{
    char text[700];
    int n = sprintf(text, "%.80s   %.1f frames/s\n%d %s, moon   %d bands   grid %d^3   %s   %s\n"
                    "grid %.2f   surfaces %.2f   occlusion %.2f   shading %.2f   picture %.2f ms",
                    (const char *)glGetString(GL_RENDERER), fps, s->count, kinds[o->kind], o->bands, o->nodes[0],
                    o->kind == POLYGON_LIGHTS ? "exact" : forms[o->form], scheme_titles[scheme_index(o->scheme)],
                    ms[GRID], ms[SURFACES], ms[OCCLUSION], ms[SHADING], ms[PICTURE]);
    if (o->error_scale > 0)
        n += sprintf(text + n, "\nerror against per pixel (%.2f ms), %d x", reference_ms, ERROR_SCALE);
    sprintf(text + n, "\n\n%s", keys);
    label(o, o->width < 1200 ? 1 : 2, text);
}

int window_run(options *a, stage *s)
{
    light *now = need(NULL, (size_t)(s->count + s->moon), sizeof *now);
    float exposure = 0;
    double ms[PASSES] = { 0 }, reference_ms = 0, clock = a->time, last = glfwGetTime(), fps = 0;
    int frames = 0, k;

    start(a, s);
    while (!glfwWindowShouldClose(window)) {
        const double seconds = glfwGetTime(), rate = 1 / fmax(seconds - last, 1e-6);
        settings t;
        camera c;
        int width, height;

        glfwGetFramebufferSize(window, &width, &height);
        if (width < 64 || height < 64) { glfwWaitEvents(); continue; }
        if (state.changed) {                                /* another number of lights */
            stage_free(s);
            passes_close();
            stage_build(s, a->lights, a->how);
            passes_open(s);
            now = need(now, (size_t)(s->count + s->moon), sizeof *now);
            state.changed = 0;
        }
        if (a->keys && *a->keys) {
            const int key = (unsigned char)*a->keys++, small = key >= 'a' && key <= 'z';
            on_key(window, small ? key - 'a' + GLFW_KEY_A : key, 0, GLFW_PRESS, small ? 0 : GLFW_MOD_SHIFT);
        }
        if (state.moving) clock += seconds - last;
        fps = frames < 2 ? 0 : frames == 2 ? rate : 0.9 * fps + 0.1 * rate;
        last = seconds;

        t = a->o;                                           /* the frame's settings */
        t.samples = 1;
        t.width = width;
        t.height = height;
        t.turn = (float)(0.3 * clock);
        stage_move(s, t.kind != SPHERE_LIGHTS, clock, now);
        passes_lights(&t, s, now, 0);
        c = orbit(s);
        pass_grid(&t, s);
        pass_surfaces(&t, &c);
        pass_occlusion(&t, &c);
        if (state.heat) {
            t.scheme = PER_POINT;
            pass_shading(&t, s, &c, 1);
            reference_ms = passes_ms(SHADING);
            t.scheme = a->o.scheme;
            t.error_scale = ERROR_SCALE;
        }
        pass_shading(&t, s, &c, 0);
        if (frames % 32 == 0) exposure = passes_exposure(&t);
        pass_picture(&t, exposure);
        for (k = 0; k < PASSES; k++) ms[k] = passes_ms(k);
        if (state.shown) readout(&t, s, ms, reference_ms, fps);
        passes_show(&t, width, height);
        glfwSwapBuffers(window);
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

int window_open(int width, int height)
{
    glfwSetErrorCallback(complain);
    if (!glfwInit()) return 0;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    window = glfwCreateWindow(width, height, "spherical harmonics on a grid", NULL, NULL);
    if (window) {
        glfwMakeContextCurrent(window);
        glfwSwapInterval(1);
        if (context_enough()) return 1;
    }
    glfwTerminate();
    return 0;
}

void window_close(void) { glfwTerminate(); }
