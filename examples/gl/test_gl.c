/* test_gl.c - the GPU's grid against the C headers on small cases, and its picture against the relight example's. */
#include "sh_interp.h"
#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *program_name = "test-gl";
static int failures;

void check(int status)                                      /* for relight's rooms */
{
    if (status < 0) die("%s", sh_status_string(status));
}

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
    o.lanes = 8; o.samples = 1; o.width = 320; o.height = 240; o.scheme = SH_EDGE_HERMITE;
    return o;
}

/* ---- the grid ---- */

static void grids(stage *s, light *now)
{
    static const char *const kinds[] = { "spheres", "triangles as spheres", "polygons" };
    static const char *const forms[] = { "forward", "reverse", "moments", "lobes" };
    char what[100];
    int kind, form, bands;

    for (kind = SPHERE_LIGHTS; kind <= POLYGON_LIGHTS; kind++)
        for (form = kind == POLYGON_LIGHTS ? LOBES : FORWARD; form <= (kind == POLYGON_LIGHTS ? LOBES : MOMENTS); form++)
            for (bands = 3; bands <= 9; bands += 3) {
                settings o = small(bands, 4);
                agreement a;
                if (form == FORWARD && bands > 3) continue;         /* seconds to compile on llvmpipe */
                o.kind = kind;
                o.form = form;
                stage_move(s, kind != SPHERE_LIGHTS, 0, now);
                passes_lights(now, s->count);
                pass_grid(&o, s);
                a = check_grid(&o, s, now);
                sprintf(what, "grid of %d %s, %s, %d bands", s->count, kinds[kind], forms[form], bands);
                expect(what, worse(a.value, a.gradient), AGREEMENT_BOUND);
            }
}

/* One light right above, right below, at a distance from 1.001 radii to a million, and around the node. */
static void one_light(const stage *s)
{
    static const float at[7][4] = { {0, 0, 2, 0.5f}, {0, 0, -2, 0.5f}, {2, 0, 0, 1.99f}, {0, 1, 0, 1e-6f}, {1, 2, 3, 0.4f},
                                    {0.1f, 0, 0, 0.5f}, {0, 0, 0, 1} };
    stage t = *s;
    char what[100];
    int i, form;

    t.count = 1;
    for (i = 0; i < 7; i++)
        for (form = FORWARD; form <= MOMENTS; form++) {
            settings o = small(6, 2);
            const float centre[3] = { s->low.x, s->low.y, s->low.z };
            const int first[3] = { 2, 3, 2 };
            light l;
            agreement a;
            float *node;
            int k;

            memset(&l, 0, sizeof l);
            for (k = 0; k < 3; k++) {
                o.nodes[k] = first[k];
                l.sphere[k] = centre[k] + at[i][k];
                l.radiance[k] = 1;
            }
            l.sphere[3] = at[i][3];
            o.form = form;
            passes_lights(&l, 1);
            pass_grid(&o, s);
            if (i < 5) {                                    /* relative to each band's maximum at each node: strict */
                a = check_grid(&o, &t, &l);
                sprintf(what, "one light at %g %g %g, radius %g, form %d", (double)at[i][0], (double)at[i][1], (double)at[i][2],
                        (double)at[i][3], form);
                expect(what, worse(a.value, a.gradient), AGREEMENT_BOUND);
            } else {                                        /* inside: 2 sqrt(pi), nothing else */
                double off = 0;
                node = passes_nodes(&o);
                for (k = 0; k < 36 * 12; k++) off = worse(off, fabs((double)node[k] - (k == 0 || k == 4 || k == 8 ? 3.544907701811032 : 0)));
                free(node);
                sprintf(what, "inside a light, form %d", form);
                expect(what, off, 1e-6);
            }
        }
}

/* ---- the picture ---- */

static void picture(const stage *s, light *now)
{
    static const int scheme[2] = { PER_POINT, SH_EDGE_HERMITE };
    settings o = small(5, 8);
    method at[2];
    scene r;
    view w;
    float *blocked, none = 0;
    int i, k;

    memset(&r, 0, sizeof r);
    memset(&w, 0, sizeof w);
    memset(at, 0, sizeof at);
    scene_build(&r, NULL, 'y', s->count, 1);
    r.p.radiance = &none;                                   /* of no polygon lights */
    view_trace(&w, &r, o.width, o.height);
    blocked = need(NULL, (size_t)r.m.vertices * BANDS * BANDS, sizeof *blocked);        /* no shadows here */
    for (i = 0; i < 2; i++) {
        at[i].scheme = scheme[i];
        at[i].nodes = 8;
        at[i].planes = SH_GRADIENT;
    }
    shade(&r, &w, blocked, o.bands, at, 2);

    o.nodes[0] = o.nodes[1] = o.nodes[2] = 8;
    o.form = MOMENTS;
    stage_move(s, 0, 0, now);
    passes_lights(now, s->count);
    pass_grid(&o, s);
    pass_surfaces(&o, &s->eye);
    for (i = 0; i < 2; i++) {
        double sum = 0, off = 0, worst = 0;
        float *rgba;
        int count = 0, far = 0;
        char what[100];

        o.scheme = scheme[i];
        pass_shading(&o, s, &s->eye, 0);
        rgba = passes_image(&o, SHADING);
        for (k = 0; k < w.count; k++) {
            const spot *p = &w.at[k];
            const int x = p->pixel % o.width, y = o.height - 1 - p->pixel / o.width;
            double pixel = 0, difference = 0;
            int c;
            if (p->weight < 1) continue;                    /* part of an antialiased pixel */
            for (c = 0; c < 3; c++) {
                const double cpu = (double)at[i].rgb[3 * k + c], gpu = (double)rgba[4 * (y * o.width + x) + c];
                pixel += cpu;
                difference += fabs(gpu - cpu);
            }
            sum += pixel;
            off += difference;
            count++;
            far += !(difference <= 2e-3 * pixel);
            worst = worse(worst, difference / pixel);
        }
        sprintf(what, "picture, %s: mean difference from relight's", i ? "edge Hermite" : "per pixel");
        expect(what, off / sum, 1e-4);
        sprintf(what, "  share of %d pixels off by more than 1/500 (worst %.2g)", count, worst);
        expect(what, (double)far / count, 1e-3);
        expect("  pixels compared, of all", -(double)count / (o.width * o.height), -0.5);
        free(rgba);
        free(at[i].rgb);
    }
    free(blocked); free(w.at); free(w.glow); free(r.m.v); free(r.m.t); free(r.l.sphere); free(r.l.radiance);
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
    stage_build(&s, 64, 1);
    now = need(NULL, (size_t)s.count, sizeof *now);
    passes_open(&s);
    one_light(&s);
    grids(&s, now);
    picture(&s, now);
    free(now);
    passes_close();
    context_close();
    stage_free(&s);
    if (failures) printf("%d failures\n", failures);
    return failures != 0;
}
