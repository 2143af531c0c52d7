/* stage.c - the relight example's scene as buffers, and how it moves. */
#include "sh_product.h"
#include "gl.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- what relight's rooms ask for ---- */

void die(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fprintf(stderr, "%s: ", program_name);
    vfprintf(stderr, format, args);
    fprintf(stderr, "\n");
    va_end(args);
    exit(2);
}

void *need(void *old, size_t count, size_t size)
{
    void *p = old ? realloc(old, (count ? count : 1) * size) : calloc(count ? count : 1, size);
    if (!p) die("out of memory");
    return p;
}

void progress(const char *what, double done)
{
    if (!isatty(STDERR_FILENO)) return;
    if (done < 1) fprintf(stderr, "\r%-24s %3.0f%%", what, 100 * done);
    else fprintf(stderr, "\r%30s\r", "");
}

/* ---- the stage ---- */

static void put(float *to, vec3 v) { to[0] = v.x; to[1] = v.y; to[2] = v.z; }
static vec3 get(const float *v) { return vec(v[0], v[1], v[2]); }

void stage_build(stage *s, int count, int quick)
{
    scene r;
    int i, k;

    memset(s, 0, sizeof *s);
    memset(&r, 0, sizeof r);
    scene_build(&r, NULL, 'y', count, quick);
    s->low = r.low;
    s->high = r.high;
    s->eye = r.c;
    s->turning = 3 * r.casters;
    s->vertices = 3 * r.m.triangles;
    s->vertex = need(NULL, 7 * (size_t)s->vertices, sizeof *s->vertex);
    for (i = 0; i < r.m.triangles; i++)
        for (k = 0; k < 3; k++) {
            float *v = s->vertex + 7 * (3 * i + k);
            put(v, r.m.v[r.m.t[i].v[k]].p);
            put(v + 3, r.m.v[r.m.t[i].v[k]].n);
            v[6] = (float)r.m.t[i].material;
        }
    s->count = r.l.count;
    s->lights = need(NULL, (size_t)s->count, sizeof *s->lights);
    for (i = 0; i < s->count; i++)
        for (k = 0; k < 4; k++) {
            s->lights[i].sphere[k] = r.l.sphere[k * s->count + i];
            if (k < 3) s->lights[i].radiance[k] = r.l.radiance[k * s->count + i];
        }
    free(r.m.v); free(r.m.t); free(r.l.sphere); free(r.l.radiance);
}

/* M22, Eq. 24-25: the sphere at the triangle's centroid whose disc has its area; from the corners as they are rounded. */
static void take_for_a_sphere(light *l)
{
    double u[3], v[3], n[3], area2 = 0;
    int k;

    for (k = 0; k < 3; k++) {
        u[k] = (double)l->corner[1][k] - (double)l->corner[0][k];
        v[k] = (double)l->corner[2][k] - (double)l->corner[0][k];
        l->sphere[k] = (float)(((double)l->corner[0][k] + (double)l->corner[1][k] + (double)l->corner[2][k]) / 3);
    }
    for (k = 0; k < 3; k++) {
        n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
        area2 += n[k] * n[k];
    }
    area2 = sqrt(area2);
    for (k = 0; k < 3; k++) l->normal[k] = (float)(n[k] / area2);
    l->normal[3] = 1;
    l->sphere[3] = (float)sqrt(area2 / 6.283185307179586);
}

/* A wave runs through the lights. As a triangle it keeps its area and centre and faces the teapot. */
void stage_move(const stage *s, int triangles, double time, light *now)
{
    int i, k;

    for (i = 0; i < s->count; i++) {
        const vec3 from = get(s->lights[i].sphere);
        const float wave = 0.9f * from.x + 0.7f * from.z, t = (float)time, swing = time > 0 ? 0.16f : 0;
        light *l = &now[i];
        vec3 at, n, x, y;

        *l = s->lights[i];
        at = add(from, mul(vec(0.4f * sinf(1.1f * t + wave), sinf(1.7f * t + wave), sinf(1.3f * t + 0.8f * wave)), swing));
        put(l->sphere, at);
        if (!triangles) continue;
        n = unit(sub(vec(0, 0, 0.8f), at));
        x = unit(fabsf(n.z) < 0.9f ? cross(n, vec(0, 0, 1)) : cross(n, vec(1, 0, 0)));
        y = cross(n, x);
        for (k = 0; k < 3; k++) {                           /* area (3 sqrt(3)/4) R^2 = pi r^2 */
            const float a = 0.7f * (float)i + 2.0943951f * (float)k, r = l->sphere[3] * 1.5551203f;
            put(l->corner[k], add(at, add(mul(x, r * cosf(a)), mul(y, r * sinf(a)))));
        }
        take_for_a_sphere(l);
    }
}

/* Of the light's L_lm, lobe[l] L_lm Y_lm(mirror) leaves towards the eye. */
void stage_lobe(int bands, float alpha, float *lobe)
{
    int l;
    sh_zonal_ggx_f32(bands, alpha, lobe);
    for (l = 0; l < bands; l++) lobe[l] *= sqrtf(12.5663706f / (float)(2 * l + 1));
}

void stage_free(stage *s)
{
    free(s->vertex);
    free(s->lights);
}
