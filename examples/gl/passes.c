/* passes.c - shaders and buffers, and the passes of a frame. */
#include "sh_polygon.h"
#include "gl.h"
#include "gl_shaders.h"                                     /* the shader files as arrays of lines, by rules.mk */

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <stb/stb_easy_font.h>

/* ---- programs: one per shader files and definitions, compiled when first used ---- */

typedef struct { char key[200]; GLuint id; } program;
static program programs[512];
static int     program_count;

static GLuint compile(GLenum type, const char *defines, const char *const *const *files)
{
    static const char *line[4096];
    const GLuint id = glCreateShader(type);
    GLsizei lines = 0;
    GLint good;
    int f, i;

    line[lines++] = "#version 450 core\n";
    line[lines++] = defines;
    for (f = 0; files[f]; f++) {
        line[lines++] = f == 0 ? "#line 1 0\n" : f == 1 ? "#line 1 1\n" : "#line 1 2\n";
        for (i = 0; files[f][i]; i++) line[lines++] = files[f][i];
    }
    glShaderSource(id, lines, line, NULL);
    glCompileShader(id);
    glGetShaderiv(id, GL_COMPILE_STATUS, &good);
    if (!good) {
        static char log[4096];
        glGetShaderInfoLog(id, sizeof log, NULL, log);
        die("a shader does not compile; its definitions are\n%sand the compiler says\n%s", defines, log);
    }
    return id;
}

/* files: lists of files for a compute shader, or for a vertex and a fragment shader, each ended by NULL. */
static GLuint use(const char *const *const *first, const char *const *const *second, const char *format, ...)
{
    program *p;
    GLuint a, b = 0;
    GLint good;
    char key[sizeof p->key];
    va_list args;
    int i, n;

    n = snprintf(key, sizeof key, "/* %p %p */\n", (const void *)first[0], second ? (const void *)second[0] : NULL);
    va_start(args, format);
    vsnprintf(key + n, sizeof key - (size_t)n, format, args);
    va_end(args);
    for (i = 0; i < program_count; i++)
        if (!strcmp(programs[i].key, key)) {
            glUseProgram(programs[i].id);
            return programs[i].id;
        }
    if (program_count == (int)(sizeof programs / sizeof *programs)) die("too many shader programs");
    p = &programs[program_count++];
    strcpy(p->key, key);
    p->id = glCreateProgram();
    a = compile(second ? GL_VERTEX_SHADER : GL_COMPUTE_SHADER, key, first);
    glAttachShader(p->id, a);
    if (second) glAttachShader(p->id, b = compile(GL_FRAGMENT_SHADER, key, second));
    glLinkProgram(p->id);
    glDeleteShader(a);
    if (b) glDeleteShader(b);
    glGetProgramiv(p->id, GL_LINK_STATUS, &good);
    if (!good) {
        char log[2048];
        glGetProgramInfoLog(p->id, sizeof log, NULL, log);
        die("shaders do not link; their definitions are\n%sand the linker says\n%s", key, log);
    }
    glUseProgram(p->id);
    return p->id;
}

#define FILES(...) (const char *const *const []){ __VA_ARGS__, NULL }

static GLint  at(GLuint p, const char *name) { return glGetUniformLocation(p, name); }
static void   set1(GLuint p, const char *name, int v) { glUniform1i(at(p, name), v); }
static void   set2(GLuint p, const char *name, float x, float y) { glUniform2f(at(p, name), x, y); }
static void   set3(GLuint p, const char *name, vec3 v) { glUniform3f(at(p, name), v.x, v.y, v.z); }

/* ---- buffers and targets ---- */

enum { LIGHTS, NODES, MATERIAL_TABLE, AXES, BUFFERS };
enum { PLACES, NORMALS, EMITTED, OPEN_RAW, OPEN, SHADED, REFERENCE, SHOWN, TARGETS };
static GLuint buffer[BUFFERS], texels[BUFFERS], vertices, letters, arrays, letter_array, query[PASSES];
static GLuint target[TARGETS], canvas[TARGETS], depth;
static size_t held_nodes;
static int    held_axes, software, light_count, vertex_count, turning_count;
static int    target_width, target_height, target_samples;

static void store(int which, size_t bytes, const void *data)
{
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer[which]);
    glBufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, data, GL_DYNAMIC_DRAW);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, (GLuint)which, buffer[which]);
    glTextureBuffer(texels[which], GL_RGBA32F, buffer[which]);
}

/* As struct Material of shade.frag lays it out. */
static void send_materials(void)
{
    float to[MATERIALS][16];
    int i;

    memset(to, 0, sizeof to);
    for (i = 0; i < MATERIALS; i++) {
        const material *m = &materials[i];
        memcpy(to[i], m->albedo, sizeof m->albedo);
        to[i][3] = m->f0;
        to[i][4] = fmaxf(1 - sqrtf(m->alpha), m->f0);
        stage_lobe(MAX_BANDS, m->alpha, to[i] + 5);
    }
    store(MATERIAL_TABLE, sizeof to, to);
}

/* As buffer Axes of grid.comp: a set of the header's lobes, and what turns sums about them to coefficients. */
static int axes(int bands) { return 2 * (bands | 1) - 1; }

static void send_axes(int bands)
{
    static const double *const lobes[] = { shi_lobes_3, shi_lobes_5, shi_lobes_7, shi_lobes_9 };
    static const double *const weights[] = { shi_weights_3, shi_weights_5, shi_weights_7, shi_weights_9 };
    static float to[17 * 4 + 81 * 17];
    const int set = bands / 2 - 1;
    int i;

    if (held_axes == bands) return;
    for (i = 0; i < 3 * axes(bands); i++) to[i / 3 * 4 + i % 3] = (float)lobes[set][i];
    for (i = 0; i < bands * bands * axes(bands); i++) {
        const int l = (int)sqrtf((float)(i / axes(bands)) + 0.5f);
        to[17 * 4 + i] = (float)(weights[set][i] * sqrt((2 * l + 1) / 12.566370614359172));
    }
    store(AXES, sizeof to, to);
    held_axes = bands;
}

void passes_open(const stage *s)
{
    const char *renderer = (const char *)glGetString(GL_RENDERER);
    int i;

    software = strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe") || strstr(renderer, "SwiftShader");
    glGenBuffers(BUFFERS, buffer);
    glCreateTextures(GL_TEXTURE_BUFFER, BUFFERS, texels);
    glGenQueries(PASSES, query);
    glCreateBuffers(1, &vertices);
    glCreateBuffers(1, &letters);
    glNamedBufferData(vertices, (GLsizeiptr)(7 * (size_t)s->vertices * sizeof(float)), s->vertex, GL_STATIC_DRAW);
    glCreateVertexArrays(1, &arrays);
    glVertexArrayVertexBuffer(arrays, 0, vertices, 0, 7 * sizeof(float));
    for (i = 0; i < 3; i++) {                               /* position, normal, material */
        glVertexArrayAttribFormat(arrays, (GLuint)i, i < 2 ? 3 : 1, GL_FLOAT, GL_FALSE, 12 * (GLuint)i);
        glVertexArrayAttribBinding(arrays, (GLuint)i, 0);
        glEnableVertexArrayAttrib(arrays, (GLuint)i);
    }
    vertex_count = s->vertices;
    turning_count = s->turning;
    glCreateVertexArrays(1, &letter_array);
    glVertexArrayVertexBuffer(letter_array, 0, letters, 0, 2 * sizeof(float));
    glVertexArrayAttribFormat(letter_array, 0, 2, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(letter_array, 0, 0);
    glEnableVertexArrayAttrib(letter_array, 0);
    send_materials();
}

void passes_close(void)
{
    int i;
    for (i = 0; i < program_count; i++) glDeleteProgram(programs[i].id);
    program_count = 0;
    glDeleteBuffers(BUFFERS, buffer);
    glDeleteTextures(BUFFERS, texels);
    glDeleteBuffers(1, &vertices);
    glDeleteBuffers(1, &letters);
    glDeleteVertexArrays(1, &arrays);
    glDeleteVertexArrays(1, &letter_array);
    glDeleteQueries(PASSES, query);
    if (target_width) {
        glDeleteTextures(TARGETS, target);
        glDeleteFramebuffers(TARGETS, canvas);
        glDeleteRenderbuffers(1, &depth);
    }
    target_width = held_axes = 0;
    held_nodes = 0;
}

void passes_lights(const light *now, int count)
{
    const int room = count > 4096 ? count : 4096;           /* llvmpipe compiles anew for another size */
    store(LIGHTS, (size_t)room * sizeof *now, NULL);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)((size_t)count * sizeof *now), now);
    light_count = count;
}

/* Textures for the picture's size, each with a framebuffer that draws into it; PLACES draws the first three. */
static void targets(const settings *o)
{
    static const GLenum three[3] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2 };
    const int width = o->width * o->samples, height = o->height * o->samples;
    int i, levels = 1;

    if (o->width == target_width && o->height == target_height && o->samples == target_samples) return;
    if (target_width) {
        glDeleteTextures(TARGETS, target);
        glDeleteFramebuffers(TARGETS, canvas);
        glDeleteRenderbuffers(1, &depth);
    }
    while ((width | height) >> levels) levels++;
    glCreateTextures(GL_TEXTURE_2D, TARGETS, target);
    glCreateFramebuffers(TARGETS, canvas);
    glCreateRenderbuffers(1, &depth);
    glNamedRenderbufferStorage(depth, GL_DEPTH_COMPONENT32F, width, height);
    for (i = 0; i < TARGETS; i++) {
        const GLenum format = i == OPEN || i == OPEN_RAW ? GL_R8 : i == EMITTED ? GL_RGBA16F : GL_RGBA32F;
        glTextureStorage2D(target[i], i == EMITTED ? levels : 1, format, i == SHOWN ? o->width : width,
                           i == SHOWN ? o->height : height);
        glTextureParameteri(target[i], GL_TEXTURE_MIN_FILTER, i == EMITTED ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST);
        glTextureParameteri(target[i], GL_TEXTURE_MAG_FILTER, i == EMITTED ? GL_LINEAR : GL_NEAREST);
        glTextureParameteri(target[i], GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(target[i], GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glNamedFramebufferTexture(canvas[i], GL_COLOR_ATTACHMENT0, target[i], 0);
    }
    glNamedFramebufferTexture(canvas[PLACES], GL_COLOR_ATTACHMENT1, target[NORMALS], 0);
    glNamedFramebufferTexture(canvas[PLACES], GL_COLOR_ATTACHMENT2, target[EMITTED], 0);
    glNamedFramebufferRenderbuffer(canvas[PLACES], GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    glNamedFramebufferDrawBuffers(canvas[PLACES], 3, three);
    target_width = o->width;
    target_height = o->height;
    target_samples = o->samples;
}

static void whole(int to, int width, int height)            /* one triangle over a target */
{
    glBindFramebuffer(GL_FRAMEBUFFER, canvas[to]);
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(arrays);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static void see(GLuint p, const settings *o, const camera *c)
{
    const vec3 ahead = unit(sub(c->at, c->eye)), right = unit(cross(ahead, vec(0, 0, 1)));
    set3(p, "eye", c->eye);
    set3(p, "ahead", ahead);
    set3(p, "right", right);
    set3(p, "up", cross(right, ahead));
    set2(p, "view", 0.5f * c->width, 0.5f * c->width * (float)o->height / (float)o->width);
}

static void grid(GLuint p, const settings *o, const stage *s)
{
    const vec3 d = sub(s->high, s->low);
    glUniform3i(at(p, "count"), o->nodes[0], o->nodes[1], o->nodes[2]);
    set3(p, "origin", s->low);
    set3(p, "cell", vec(d.x / (float)(o->nodes[0] - 1), d.y / (float)(o->nodes[1] - 1),
                        d.z / (float)(o->nodes[2] - 1)));
}

/* ---- the passes ---- */

/* By the GPU's timer queries; by the wall's clock for software, where queries do not see compute shaders. */
static double started, clocked[PASSES];
static int    running;

static double now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static void begin(int pass)
{
    running = pass;
    if (software) {
        glFinish();
        started = now_ms();
    } else glBeginQuery(GL_TIME_ELAPSED, query[pass]);
}

static void end(void)
{
    if (software) {
        glFinish();
        clocked[running] = now_ms() - started;
    } else glEndQuery(GL_TIME_ELAPSED);
}

double passes_ms(int pass)
{
    GLuint64 ns = 0;
    if (software) return clocked[pass];
    glGetQueryObjectui64v(query[pass], GL_QUERY_RESULT, &ns);
    return 1e-6 * (double)ns;
}

const char *passes_clock(void) { return software ? "wall clock" : "GPU timer"; }

void pass_grid(const settings *o, const stage *s)
{
    const int nodes = o->nodes[0] * o->nodes[1] * o->nodes[2], n = o->bands;
    const int form = o->kind == POLYGON_LIGHTS ? LOBES : o->form;
    const int rows = form == FORWARD ? 1 : form == MOMENTS ? 2 * n + 1 : form == LOBES ? axes(n) : 2 * n - 1;
    const size_t bytes = (size_t)nodes * (size_t)(n * n) * 12 * sizeof(float);
    GLuint p;

    if (bytes != held_nodes) store(NODES, held_nodes = bytes, NULL);
    if (form == LOBES) send_axes(n);
    p = use(FILES(sh_glsl, polygon_glsl, grid_comp), NULL,
            "#define SH_BANDS %d\n#define FORM %d\n#define TRIANGLES %d\n"
            "#define LANES %d\n#define ROWS %d\n",
            n, form, o->kind == TRIANGLE_LIGHTS, o->lanes, rows);
    set1(p, "lights", light_count);
    set1(p, "add", 0);
    grid(p, o, s);
    begin(GRID);
    glDispatchCompute((GLuint)nodes, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    end();
}

void pass_surfaces(const settings *o, const camera *c)
{
    static const float nothing[4] = { 0, 0, 0, -2 }, black[4] = { 0, 0, 0, 0 };
    GLuint p;

    targets(o);
    begin(SURFACES);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas[PLACES]);
    glViewport(0, 0, o->width * o->samples, o->height * o->samples);
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_COLOR, 1, black);
    glClearBufferfv(GL_COLOR, 2, black);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1, 0);
    glEnable(GL_DEPTH_TEST);
    glBindVertexArray(arrays);
    p = use(FILES(surface_vert), FILES(surface_frag), "#define LIGHTS 0\n");
    see(p, o, c);
    set2(p, "turn", cosf(o->turn), sinf(o->turn));
    glDrawArrays(GL_TRIANGLES, 0, turning_count);
    set2(p, "turn", 1, 0);
    glDrawArrays(GL_TRIANGLES, turning_count, vertex_count - turning_count);
    p = use(FILES(surface_vert), FILES(surface_frag), "#define LIGHTS 1\n");
    see(p, o, c);
    glDrawArraysInstanced(GL_TRIANGLES, 0, o->kind == SPHERE_LIGHTS ? 12 * 8 * 6 : 3, light_count);
    glGenerateTextureMipmap(target[EMITTED]);
    end();
}

void pass_occlusion(const settings *o, const camera *c)
{
    const int width = o->width * o->samples, height = o->height * o->samples;
    int blur;

    begin(OCCLUSION);
    for (blur = 0; blur < 2 && o->occlusion; blur++) {
        see(use(FILES(whole_vert), FILES(occlusion_frag), "#define BLUR %d\n", blur), o, c);
        glBindTextureUnit(0, target[PLACES]);
        glBindTextureUnit(1, target[NORMALS]);
        glBindTextureUnit(2, target[OPEN_RAW]);
        whole(blur ? OPEN : OPEN_RAW, width, height);
    }
    end();
}

void pass_shading(const settings *o, const stage *s, const camera *c, int as_reference)
{
    const int pixel = o->scheme == PER_POINT, polygons = pixel && o->kind == POLYGON_LIGHTS;
    const GLuint p = use(FILES(whole_vert), FILES(sh_glsl, polygon_glsl, shade_frag),
                         "#define SH_BANDS %d\n#define LIGHT_BANDS %d\n#define PER_PIXEL %d\n"
                         "#define POLYGONS %d\n#define AXES %d\n",
                         o->lobe_bands, o->bands, pixel, polygons, polygons ? axes(o->bands) : 0);
    if (polygons) send_axes(o->bands);
    begin(SHADING);
    set1(p, "light_count", light_count);
    set1(p, "scheme", o->scheme);
    set1(p, "terms", o->bands * o->bands);
    set1(p, "occluded", o->occlusion);
    set3(p, "eye", c->eye);
    grid(p, o, s);
    glBindTextureUnit(0, target[PLACES]);
    glBindTextureUnit(1, target[NORMALS]);
    glBindTextureUnit(2, target[OPEN]);
    glBindTextureUnit(3, texels[LIGHTS]);
    glBindTextureUnit(4, texels[NODES]);
    whole(as_reference ? REFERENCE : SHADED, o->width * o->samples, o->height * o->samples);
    end();
}

void pass_picture(const settings *o, float exposure)
{
    const GLuint p = use(FILES(whole_vert), FILES(final_frag), "#define SAMPLES %d\n", o->samples);
    begin(PICTURE);
    glUniform1f(at(p, "exposure"), exposure);
    glUniform1f(at(p, "scale"), o->error_scale);
    glBindTextureUnit(0, target[SHADED]);
    glBindTextureUnit(1, target[EMITTED]);
    glBindTextureUnit(2, target[REFERENCE]);
    whole(SHOWN, o->width, o->height);
    end();
}

/* ---- what comes back ---- */

float *passes_nodes(const settings *o)
{
    const size_t count = (size_t)(o->nodes[0] * o->nodes[1] * o->nodes[2]) * (size_t)(o->bands * o->bands) * 12;
    float *to = need(NULL, count, sizeof *to);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(buffer[NODES], 0, (GLsizeiptr)(count * sizeof *to), to);
    return to;
}

static float *image(int which, int width, int height)
{
    float *to = need(NULL, 4 * (size_t)width * (size_t)height, sizeof *to);
    glGetTextureImage(target[which], 0, GL_RGBA, GL_FLOAT, (GLsizei)(16 * (size_t)width * (size_t)height), to);
    return to;
}

float *passes_image(const settings *o, int which)
{
    const int from = which == SURFACES ? PLACES : which == GRID ? NORMALS : which == PICTURE ? SHOWN : SHADED;
    const int samples = which == PICTURE ? 1 : o->samples;
    return image(from, o->width * samples, o->height * samples);
}

/* The exposure that brings the geometric mean of the surfaces' luminance to a darker middle grey. */
float passes_exposure(const settings *o)
{
    float *rgba = passes_image(o, SHADING);
    const size_t pixels = (size_t)(o->width * o->height) * (size_t)(o->samples * o->samples);
    double sum = 0, count = 0;
    size_t i;

    for (i = 0; i < pixels; i++) {
        const float *c = rgba + 4 * i, y = 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2];
        if (!(y > 0) || !(c[3] > 0)) continue;
        sum += (double)logf(y);
        count++;
    }
    free(rgba);
    return count > 0 ? 0.12f / expf((float)(sum / count)) : 1;
}

unsigned char *passes_picture(const settings *o)
{
    float *rgba = image(SHOWN, o->width, o->height);
    unsigned char *to = need(NULL, 3 * (size_t)o->width * (size_t)o->height, 1);
    int x, y, k;

    for (y = 0; y < o->height; y++)
        for (x = 0; x < o->width; x++)
            for (k = 0; k < 3; k++) {
                const float v = rgba[4 * ((o->height - 1 - y) * o->width + x) + k];
                to[3 * (y * o->width + x) + k] = (unsigned char)(255 * fminf(fmaxf(v, 0), 1) + 0.5f);
            }
    free(rgba);
    return to;
}

void passes_show(const settings *o, int width, int height)
{
    glBlitNamedFramebuffer(canvas[SHOWN], 0, 0, 0, o->width, o->height, 0, 0, width, height,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

static void letters_or_panel(const float *corner, int corners)
{
    glNamedBufferData(letters, (GLsizeiptr)(2 * (size_t)corners * sizeof(float)), corner, GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, corners);
}

void passes_text(const settings *o, float x, float y, float zoom, const char *text)
{
    static struct { float x, y, z; unsigned char colour[4]; } quad[4096][4];
    static float corner[4096 * 12];
    char *const t = (char *)(size_t)text;
    const float r = (float)stb_easy_font_width(t) + 4, b = (float)stb_easy_font_height(t) + 2;
    const float panel[12] = { -4, -4, r, -4, r, b, -4, -4, r, b, -4, b };
    const int quads = stb_easy_font_print(0, 0, t, NULL, quad, sizeof quad);
    const GLuint p = use(FILES(text_vert), FILES(text_frag), "\n");
    int i, k;

    for (i = 0; i < quads; i++)
        for (k = 0; k < 6; k++) {
            static const int of[6] = { 0, 1, 2, 0, 2, 3 };
            corner[12 * i + 2 * k] = quad[i][of[k]].x;
            corner[12 * i + 2 * k + 1] = quad[i][of[k]].y;
        }
    glBindFramebuffer(GL_FRAMEBUFFER, canvas[SHOWN]);
    glViewport(0, 0, o->width, o->height);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(letter_array);
    set2(p, "size", (float)o->width, (float)o->height);
    set2(p, "at", x, y);
    glUniform1f(at(p, "zoom"), zoom);
    glUniform4f(at(p, "ink"), 0.02f, 0.02f, 0.03f, 0.6f);
    letters_or_panel(panel, 6);
    glUniform4f(at(p, "ink"), 1, 1, 1, 1);
    letters_or_panel(corner, 6 * quads);
    glDisable(GL_BLEND);
}
