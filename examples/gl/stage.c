/* stage.c - the relight example's scene as buffers, and how it moves. */
#include "sh_product.h"
#include "gl.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- what relight's files ask for ---- */

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

void check(int status)
{
    if (status < 0) die("%s", sh_status_string(status));
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

/* M22, Eq. 24-25: the sphere at the triangle's centroid whose disc has its area; from the corners as they are
 * rounded. */
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

/* The mesh as relight shades it: corners with normal and material, and which vertex of the mesh each is. */
static void put_mesh(stage *s, const scene *r)
{
    int i, k;

    s->turning = 3 * r->casters;
    s->vertices = 3 * r->m.triangles;
    s->vertex = need(NULL, 7 * (size_t)s->vertices, sizeof *s->vertex);
    s->index = need(NULL, (size_t)s->vertices, sizeof *s->index);
    for (i = 0; i < r->m.triangles; i++)
        for (k = 0; k < 3; k++) {
            const int at = 3 * i + k;
            float *v = s->vertex + 7 * at;
            s->index[at] = r->m.t[i].v[k];
            put(v, r->m.v[s->index[at]].p);
            put(v + 3, r->m.v[s->index[at]].n);
            v[6] = (float)r->m.t[i].material;
        }
    s->floor = r->m.t[r->casters].v[0];
    s->columns = r->m.t[r->casters].v[2] - s->floor - 2;
    for (i = r->casters; r->m.t[i].material != WALL; i++) {}
    s->rows = (i - r->casters) / (2 * s->columns);
}

static void put_spheres(stage *s, const lights *l)
{
    int i, k;
    for (i = 0; i < l->count; i++)
        for (k = 0; k < 4; k++) {
            s->lights[i].sphere[k] = l->sphere[k * l->count + i];
            if (k < 3) s->lights[i].radiance[k] = l->radiance[k * l->count + i];
        }
}

/* The moon in the triangles that relight shows it in. */
static void put_moon(stage *s, const scene *r)
{
    int i, k;

    s->moon_corners = r->p.corners;
    s->moon_corner = need(NULL, 3 * (size_t)r->p.corners, sizeof *s->moon_corner);
    memcpy(s->moon_corner, r->p.vertex, 3 * (size_t)r->p.corners * sizeof *s->moon_corner);
    for (i = 0; i < s->moon; i++) {
        const int *v = r->m.t[r->m.triangles - s->moon + i].v;
        light *l = &s->lights[s->count + i];
        for (k = 0; k < 3; k++) {
            put(l->corner[k], r->m.v[v[k]].p);
            l->radiance[k] = r->p.radiance[k];
        }
        take_for_a_sphere(l);
    }
}

void stage_build(stage *s, int count, int how)
{
    scene room, lit;

    memset(s, 0, sizeof *s);
    scene_build(&room, NULL, 'y', count, how != STAGE_FULL);
    s->low = room.low;
    s->high = room.high;
    s->eye = room.c;
    put_mesh(s, &room);
    scene_copy(&lit, &room);
    if (how != STAGE_BARE) {
        s->hides = room.m.vertices;
        s->hidden = trace_blocked(&room, MAX_BANDS, how == STAGE_FULL ? 1024 : 128);
        scene_add_moon(&lit);
    }
    s->count = count;
    s->moon = lit.m.triangles - room.m.triangles;
    s->lights = need(NULL, (size_t)(s->count + s->moon), sizeof *s->lights);
    put_spheres(s, &room.l);
    put_moon(s, &lit);
    scene_free_copy(&lit);
    scene_free_copy(&room);
    free(room.l.sphere); free(room.l.radiance);
}

/* A wave runs through the spheres; the moon stands. As a triangle a sphere keeps its area and centre and
 * faces the teapot. */
void stage_move(const stage *s, int triangles, double time, light *now)
{
    int i, k;

    memcpy(now + s->count, s->lights + s->count, (size_t)s->moon * sizeof *now);
    for (i = 0; i < s->count; i++) {
        const vec3 from = get(s->lights[i].sphere);
        const float wave = 0.9f * from.x + 0.7f * from.z, t = (float)time, swing = time > 0 ? 0.16f : 0;
        light *l = &now[i];
        vec3 at, n, x, y;

        *l = s->lights[i];
        at = mad(from, vec(0.4f * sinf(1.1f * t + wave), sinf(1.7f * t + wave), sinf(1.3f * t + 0.8f * wave)), swing);
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
    free(s->index);
    free(s->hidden);
    free(s->moon_corner);
    free(s->lights);
}
