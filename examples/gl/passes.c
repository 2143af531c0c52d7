/* passes.c - buffers and targets, and the passes of a frame. */
#include "gl.h"
#include "gl_shaders.h"                                 /* the shader files as arrays of lines, by rules.mk */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---- buffers and targets ---- */

enum { LIGHTS, NODES, MATERIAL_TABLE, HIDDEN, CORNERS, BUFFERS };         /* bound where the shaders say */
enum { PLACES, NORMALS, EMITTED, INSIDE, OPEN_RAW, OPEN, SHADED, REFERENCE, SHOWN, TARGETS };
static GLuint buffer[BUFFERS], texels[BUFFERS], vertices, arrays, query[PASSES], target[TARGETS], canvas[TARGETS], depth;
static size_t held_nodes;
static int    software, sphere_count, light_count, vertex_count, turning_count;
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

void passes_open(const stage *s)
{
    const char *renderer = (const char *)glGetString(GL_RENDERER);
    int i;

    software = strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe") || strstr(renderer, "SwiftShader");
    glGenBuffers(BUFFERS, buffer);
    glCreateTextures(GL_TEXTURE_BUFFER, BUFFERS, texels);
    glGenQueries(PASSES, query);
    glCreateBuffers(1, &vertices);
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
    store(HIDDEN, (size_t)s->hides * 81 * sizeof(float), s->hidden);
    store(CORNERS, (size_t)s->vertices * sizeof(int), s->index);
    letters_open();
    send_materials();
}

void passes_close(void)
{
    programs_close();
    letters_close();
    glDeleteBuffers(BUFFERS, buffer);
    glDeleteTextures(BUFFERS, texels);
    glDeleteBuffers(1, &vertices);
    glDeleteVertexArrays(1, &arrays);
    glDeleteQueries(PASSES, query);
    if (target_width) {
        glDeleteTextures(TARGETS, target);
        glDeleteFramebuffers(TARGETS, canvas);
        glDeleteRenderbuffers(1, &depth);
    }
    target_width = 0;
    held_nodes = 0;
}

void passes_lights(const settings *o, const stage *s, const light *now, int few)
{
    const int exact = o->kind == POLYGON_LIGHTS, moon = few && s->moon ? 1 : s->moon;
    const int first = few ? s->count - 1 : 0, count = s->count - first + moon;
    const int room = count > 4096 ? count : 4096;           /* llvmpipe compiles anew for another size */

    store(LIGHTS, (size_t)room * sizeof *now, NULL);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)((size_t)count * sizeof *now), now + first);
    sphere_count = exact ? 0 : s->count - first;
    light_count = count;
}

/* Textures for the picture's size, each with a framebuffer that draws into it; PLACES draws the first four. */
static void targets(const settings *o)
{
    static const GLenum four[4] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                                    GL_COLOR_ATTACHMENT3 };
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
    glNamedFramebufferTexture(canvas[PLACES], GL_COLOR_ATTACHMENT3, target[INSIDE], 0);
    glNamedFramebufferRenderbuffer(canvas[PLACES], GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    glNamedFramebufferDrawBuffers(canvas[PLACES], 4, four);
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
    set3i(p, "count", o->nodes[0], o->nodes[1], o->nodes[2]);
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

static void add_lights(const settings *o, const stage *s, int form, int first, int last)
{
    const GLuint p = program_use(FILES(sh_glsl, polygon_glsl, grid_comp), NULL,
                                 "#define SH_BANDS %d\n#define FORM %d\n#define TRIANGLES %d\n", o->bands, form,
                                 form != EXACT && o->kind == TRIANGLE_LIGHTS);
    set1(p, "first", first);
    set1(p, "last", last);
    set1(p, "add", first > 0);
    grid(p, o, s);
    glDispatchCompute((GLuint)(o->nodes[0] * o->nodes[1] * o->nodes[2]), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void pass_grid(const settings *o, const stage *s)
{
    const size_t terms = 12 * (size_t)(o->bands * o->bands);
    const size_t bytes = (size_t)(o->nodes[0] * o->nodes[1] * o->nodes[2]) * terms * sizeof(float);

    if (bytes != held_nodes) store(NODES, held_nodes = bytes, NULL);
    begin(GRID);
    if (sphere_count > 0) add_lights(o, s, o->form, 0, sphere_count);
    if (light_count > sphere_count) add_lights(o, s, EXACT, sphere_count, light_count);
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
    glClearBufferfv(GL_COLOR, 3, black);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1, 0);
    glEnable(GL_DEPTH_TEST);
    glBindVertexArray(arrays);
    p = program_use(FILES(surface_vert), FILES(surface_frag), "#define LIGHTS 0\n");
    see(p, o, c);
    set2(p, "turn", cosf(o->turn), sinf(o->turn));
    set1(p, "drawn", 0);
    glDrawArrays(GL_TRIANGLES, 0, turning_count);
    set2(p, "turn", 1, 0);
    set1(p, "drawn", turning_count / 3);
    glDrawArrays(GL_TRIANGLES, turning_count, vertex_count - turning_count);
    p = program_use(FILES(surface_vert), FILES(surface_frag), "#define LIGHTS 1\n");
    see(p, o, c);
    set1(p, "first", 0);
    glDrawArraysInstanced(GL_TRIANGLES, 0, o->kind == SPHERE_LIGHTS ? 16 * 10 * 6 : 3, sphere_count);
    set1(p, "first", sphere_count);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 3, light_count - sphere_count);
    glGenerateTextureMipmap(target[EMITTED]);
    end();
}

void pass_occlusion(const settings *o, const camera *c)
{
    const int width = o->width * o->samples, height = o->height * o->samples;
    int blur;

    begin(OCCLUSION);
    for (blur = 0; blur < 2 && o->occlusion; blur++) {
        see(program_use(FILES(whole_vert), FILES(occlusion_frag), "#define BLUR %d\n", blur), o, c);
        glBindTextureUnit(0, target[PLACES]);
        glBindTextureUnit(1, target[NORMALS]);
        glBindTextureUnit(2, target[OPEN_RAW]);
        whole(blur ? OPEN : OPEN_RAW, width, height);
    }
    end();
}

void pass_shading(const settings *o, const stage *s, const camera *c, int as_reference)
{
    const GLuint p = program_use(FILES(whole_vert), FILES(sh_glsl, polygon_glsl, shade_frag),
                                 "#define SH_BANDS %d\n#define LIGHT_BANDS %d\n#define PER_PIXEL %d\n",
                                 o->lobe_bands, o->bands, o->scheme == PER_POINT);
    begin(SHADING);
    set1(p, "spheres", sphere_count);
    set1(p, "light_count", light_count);
    set1(p, "scheme", o->scheme);
    set1(p, "terms", o->bands * o->bands);
    set1(p, "occluded", o->occlusion);
    set1(p, "shadowed", o->shadows && s->hides > 0);
    set1(p, "turning", turning_count / 3);
    set2(p, "turn", cosf(o->turn), sinf(o->turn));
    set3i(p, "tiles", s->columns, s->rows, s->floor);
    set3(p, "eye", c->eye);
    grid(p, o, s);
    glBindTextureUnit(0, target[PLACES]);
    glBindTextureUnit(1, target[NORMALS]);
    glBindTextureUnit(2, target[INSIDE]);
    glBindTextureUnit(3, target[OPEN]);
    glBindTextureUnit(4, texels[LIGHTS]);
    glBindTextureUnit(5, texels[NODES]);
    whole(as_reference ? REFERENCE : SHADED, o->width * o->samples, o->height * o->samples);
    end();
}

void pass_picture(const settings *o, float exposure)
{
    const GLuint p = program_use(FILES(whole_vert), FILES(final_frag), "#define SAMPLES %d\n", o->samples);
    begin(PICTURE);
    set1f(p, "exposure", exposure);
    set1f(p, "scale", o->error_scale);
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

/* The exposure that brings the mean luminance of the surfaces to relight's middle grey. */
float passes_exposure(const settings *o)
{
    float *rgba = passes_image(o, SHADING);
    const size_t pixels = (size_t)(o->width * o->height) * (size_t)(o->samples * o->samples);
    double sum = 0, count = 0;
    size_t i;

    for (i = 0; i < pixels; i++) {
        const float *c = rgba + 4 * i;
        sum += (double)(0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]);
        count += (double)c[3];
    }
    free(rgba);
    return sum > 0 ? (float)(0.13 * count / sum) : 1;
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

void passes_onto_picture(const settings *o)
{
    glBindFramebuffer(GL_FRAMEBUFFER, canvas[SHOWN]);
    glViewport(0, 0, o->width, o->height);
    glDisable(GL_DEPTH_TEST);
}
