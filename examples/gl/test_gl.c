/* test_gl.c - the GPU's grid against the C headers on small cases, and its picture against the relight
 * example's. */
#include "sh_interp.h"
#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *program_name = "test-gl";
static int failures;

static void expect(const char *what, double seen, double bound)
{
    const int good = seen <= bound;                         /* NaN fails */
    printf("%s %-58s %10.4g of %g\n", good ? "ok  " : "FAIL", what, seen, bound);
    failures += !good;
}

static settings small(int bands, int nodes)
{
    settings o;
    memset(&o, 0, sizeof o);
    o.bands = o.lobe_bands = bands;
    o.nodes[0] = nodes; o.nodes[1] = nodes + 1; o.nodes[2] = nodes - 1;
    o.shadows = o.samples = 1; o.width = 320; o.height = 240; o.scheme = SH_EDGE_HERMITE;
    return o;
}

/* ---- the grid ---- */

static agreement agree(const settings *o, const stage *s, const light *now)
{
    passes_lights(o, s, now, 0);
    pass_grid(o, s);
    return check_grid(o, s, now);
}

static void grids(const stage *s, light *now)
{
    static const char *const kind[] = { "spheres", "triangles as spheres", "polygons" };
    static const char *const form[] = { "forward", "reverse", "moments" };
    char what[100];
    int bands;

    for (bands = 3; bands <= 9; bands += 3) {
        settings o = small(bands, 4);
        for (o.kind = SPHERE_LIGHTS; o.kind <= POLYGON_LIGHTS; o.kind++)
            for (o.form = FORWARD; o.form <= (o.kind == POLYGON_LIGHTS ? FORWARD : MOMENTS); o.form++) {
                agreement a;
                if (o.form == FORWARD && bands > 3 && o.kind != POLYGON_LIGHTS) continue;       /* slow to compile */
                stage_move(s, o.kind != SPHERE_LIGHTS, 0, now);
                a = agree(&o, s, now);
                sprintf(what, "%d %s and the moon, %s, %d bands", s->count, kind[o.kind],
                        o.kind == POLYGON_LIGHTS ? "exact" : form[o.form], bands);
                expect(what, worse(a.value, a.gradient), AGREEMENT_BOUND);
            }
    }
}

/* One sphere right above, right below, at a distance from 1.001 radii to a million, and around the node. */
static void one_sphere(const stage *s)
{
    static const float at[7][4] = { {0, 0, 2, 0.5f}, {0, 0, -2, 0.5f}, {2, 0, 0, 1.99f}, {0, 1, 0, 1e-6f},
                                    {1, 2, 3, 0.4f}, {0.1f, 0, 0, 0.5f}, {0, 0, 0, 1} };
    stage t = *s;
    int i, k;

    t.count = 1;
    t.moon = t.moon_corners = 0;
    for (i = 0; i < 7; i++) {
        settings o = small(6, 2);
        const float node[3] = { s->low.x, s->low.y, s->low.z };
        char what[100];
        light l;

        memset(&l, 0, sizeof l);
        for (k = 0; k < 3; k++) {
            o.nodes[k] = 2 + (k == 1);
            l.sphere[k] = node[k] + at[i][k];
            l.radiance[k] = 1;
        }
        l.sphere[3] = at[i][3];
        for (o.form = FORWARD; o.form <= MOMENTS; o.form++) {
            const agreement a = agree(&o, &t, &l);
            if (i < 5) {                            /* relative to each band's maximum at each node: strict */
                sprintf(what, "one sphere at %g %g %g, radius %g, form %d", (double)at[i][0], (double)at[i][1],
                        (double)at[i][2], (double)at[i][3], o.form);
                expect(what, worse(a.value, a.gradient), AGREEMENT_BOUND);
            } else {                                        /* inside: 2 sqrt(pi), nothing else */
                float *gpu = passes_nodes(&o);
                double off = 0;
                for (k = 0; k < 36 * 12; k++) {
                    const double exact = k == 0 || k == 4 || k == 8 ? 3.544907701811032 : 0;
                    off = worse(off, fabs((double)gpu[k] - exact));
                }
                free(gpu);
                sprintf(what, "inside a sphere, form %d", o.form);
                expect(what, off, 1e-6);
            }
        }
    }
}

static float chance(void)                                   /* -1 to 1 */
{
    static unsigned state = 1;
    state = state * 1664525u + 1013904223u;
    return (float)(state >> 8) / 8388608.0f - 1;
}

static vec3 direction(void)
{
    vec3 v;
    do v = vec(chance(), chance(), chance()); while (!(dot(v, v) < 1 && dot(v, v) > 0.01f));
    return unit(v);
}

/* One triangle, from sizes of 1/50 of its distance to 6 times it, seen from 210 nodes up to 60 degrees off
 * its normal: closer to its plane the value goes to zero, and its relative error grows with 1/cosine. */
static void one_triangle(const stage *s)
{
    static const float size[] = { 0.02f, 0.07f, 0.12f, 0.2f, 0.35f, 0.6f, 1, 1.6f, 3, 6 };
    stage t = *s;
    unsigned i;
    int bands, k;

    t.count = 1;
    t.moon = t.moon_corners = 0;
    for (bands = 3; bands <= 9; bands += 3) {
        double worst = 0;
        char what[100];
        for (i = 0; i < sizeof size / sizeof *size; i++) {
            for (k = 0; k < 20; k++) {
                settings o = small(bands, 6);
                const vec3 middle = mul(direction(), 3), n = direction();
                vec3 off, u, v;
                agreement a;
                light l;
                int j;

                do off = direction(); while (fabsf(dot(off, n)) < 0.6f);
                memset(&l, 0, sizeof l);
                u = unit(cross(n, direction()));
                v = cross(n, u);
                for (j = 0; j < 3; j++) {
                    const float around = 2.0943951f * ((float)j + 0.3f * chance());
                    const vec3 corner = add(mul(u, size[i] * cosf(around)), mul(v, size[i] * sinf(around)));
                    l.corner[j][0] = middle.x + corner.x;
                    l.corner[j][1] = middle.y + corner.y;
                    l.corner[j][2] = middle.z + corner.z;
                    l.radiance[j] = 1;
                }
                t.low = sub(add(middle, off), vec(0.05f, 0.05f, 0.05f));
                t.high = add(t.low, vec(0.1f, 0.1f, 0.1f));
                o.kind = POLYGON_LIGHTS;
                a = agree(&o, &t, &l);
                worst = worse(worst, worse(a.value, a.gradient));
            }
        }
        sprintf(what, "one triangle, of 1/50 to 6 times its distance, %d bands", bands);
        expect(what, worst, AGREEMENT_BOUND);
    }
}

/* ---- the picture ---- */

/* relight's, of the same room, moon and shadows, the mesh turned about z. */
static void relight(int count, float turn, view *w, method *at, int methods, const settings *o)
{
    const vec3 x = vec(cosf(turn), sinf(turn), 0), y = vec(-sinf(turn), cosf(turn), 0), z = vec(0, 0, 1);
    scene room, lit;
    float *blocked;
    int i, floor;

    memset(w, 0, sizeof *w);
    scene_build(&room, NULL, 'y', count, 1);
    floor = room.m.t[room.casters].v[0];
    for (i = 0; i < floor; i++) {
        vertex *v = &room.m.v[i];
        v->p = mad(mad(mul(x, v->p.x), y, v->p.y), z, v->p.z);
        v->n = mad(mad(mul(x, v->n.x), y, v->n.y), z, v->n.z);
    }
    scene_copy(&lit, &room);
    scene_add_moon(&lit);
    view_trace(w, &lit, o->width, o->height);
    blocked = trace_blocked(&room, BANDS, 128);
    shade(&lit, w, blocked, o->bands, at, methods);
    free(blocked); free(room.l.sphere); free(room.l.radiance);
    scene_free_copy(&lit);
    scene_free_copy(&room);
}

/* Radiance, channel by channel, of pixels that relight took one ray for. */
typedef struct { double mean, share; int pixels; } image_difference;

static image_difference compare(const settings *o, const view *w, const float *relit, const float *rgba, int walls,
                                double off)
{
    image_difference d = { 0, 0, 0 };
    double sum = 0;
    int k, c;

    for (k = 0; k < w->count; k++) {
        const spot *p = &w->at[k];
        const int x = p->pixel % o->width, y = o->height - 1 - p->pixel / o->width;
        double pixel = 0, difference = 0;
        if (p->weight < 1 || (p->material == WALL && !walls)) continue;
        for (c = 0; c < 3; c++) {
            const double cpu = (double)relit[3 * k + c], gpu = (double)rgba[4 * (y * o->width + x) + c];
            pixel += cpu;
            difference += fabs(gpu - cpu);
        }
        sum += pixel;
        d.mean += difference;
        d.share += !(difference <= off * pixel);
        d.pixels++;
    }
    d.mean /= sum;
    d.share /= d.pixels;
    return d;
}

static void shaded(const settings *o, const stage *s, const light *now)
{
    passes_lights(o, s, now, 0);
    pass_grid(o, s);
    pass_surfaces(o, &s->eye);
    pass_shading(o, s, &s->eye, 0);
}

static void picture(const stage *s, light *now)
{
    static const int scheme[2] = { PER_POINT, SH_EDGE_HERMITE };
    settings o = small(5, 8);
    method at[2];
    view w;
    int i;

    o.nodes[0] = o.nodes[1] = o.nodes[2] = 8;
    o.form = MOMENTS;
    memset(at, 0, sizeof at);
    for (i = 0; i < 2; i++) {
        at[i].scheme = scheme[i];
        at[i].nodes = 8;
        at[i].planes = SH_GRADIENT;
    }
    stage_move(s, 0, 0, now);
    relight(s->count, 0, &w, at, 2, &o);
    for (i = 0; i < 2; i++) {
        image_difference d;
        float *rgba;
        char what[100];

        o.scheme = scheme[i];
        shaded(&o, s, now);
        rgba = passes_image(&o, SHADING);
        d = compare(&o, &w, at[i].rgb, rgba, 1, 5e-4);
        sprintf(what, "picture, %s: mean difference from relight's", i ? "edge Hermite" : "per pixel");
        expect(what, d.mean, 3e-5);
        sprintf(what, "  share of %d pixels off by more than 1/2000", d.pixels);
        expect(what, d.share, 2e-4);
        expect("  pixels compared, of all", -(double)d.pixels / (o.width * o.height), -0.5);
        free(rgba);
        free(at[i].rgb);
    }
    free(w.at); free(w.glow);
}

/* The teapot turned: shadows traced anew against those at rest, turned with it. The walls keep theirs, so
 * they are left out; 128 rays of one pattern leave some noise. */
static void turned(const stage *s, light *now)
{
    settings o = small(5, 8);
    method at[1];
    image_difference d, none;
    view w;
    float *rgba;

    o.nodes[0] = o.nodes[1] = o.nodes[2] = 8;
    o.form = MOMENTS;
    o.turn = 0.8f;
    memset(at, 0, sizeof at);
    at[0].scheme = SH_EDGE_HERMITE;
    at[0].nodes = 8;
    at[0].planes = SH_GRADIENT;
    stage_move(s, 0, 0, now);
    relight(s->count, o.turn, &w, at, 1, &o);
    shaded(&o, s, now);
    rgba = passes_image(&o, SHADING);
    d = compare(&o, &w, at[0].rgb, rgba, 0, 0.1);
    free(rgba);
    o.shadows = 0;
    shaded(&o, s, now);
    rgba = passes_image(&o, SHADING);
    none = compare(&o, &w, at[0].rgb, rgba, 0, 0.1);
    expect("picture, the teapot turned: mean difference", d.mean, 0.02);
    expect("  share of pixels off by more than 1/10", d.share, 0.03);
    expect("  share of that difference in the one without shadows", d.mean / none.mean, 0.2);
    free(rgba); free(at[0].rgb); free(w.at); free(w.glow);
}

int main(void)
{
    stage s;
    light *now;

    if (!context_headless()) {
        context_close();
        return MISSING;
    }
    printf("%s\n", (const char *)glGetString(GL_RENDERER));
    stage_build(&s, 64, STAGE_COARSE);
    now = need(NULL, (size_t)(s.count + s.moon), sizeof *now);
    passes_open(&s);
    one_sphere(&s);
    one_triangle(&s);
    grids(&s, now);
    picture(&s, now);
    turned(&s, now);
    free(now);
    passes_close();
    context_close();
    stage_free(&s);
    if (failures) printf("%d failures\n", failures);
    return failures != 0;
}
