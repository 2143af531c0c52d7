/* check.c - the grid again by the C headers in double precision, and how far the GPU's is from it. */
#include "sh_polygon.h"
#include "gl.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* Adds rgb[c] times c[4][n2] to out[3][4][n2]. */
static void add_light(int n2, const float rgb[3], const double *c, double *out)
{
    int i;
    for (i = 0; i < 12 * n2; i++) out[i] += (double)rgb[i / (4 * n2)] * c[i % (4 * n2)];
}

static void wide(const float *from, int count, double *to)
{
    while (count-- > 0) to[count] = (double)from[count];
}

/* One node by the headers: out[3 channels][4 planes][n2]. The moon is one polygon here, not triangles. */
static void node_by_header(const settings *o, const stage *s, const double point[3], const light *l, double *out)
{
    const int n2 = o->bands * o->bands, count = s->count;
    double *c = need(NULL, 4 * (size_t)n2, sizeof *c);
    double *p = need(NULL, 7 * (size_t)count + 3 * (size_t)s->moon_corners, sizeof *p), *rgb = p + 4 * count, v[9];
    int i, k;

    if (o->kind == SPHERE_LIGHTS) {
        for (i = 0; i < count; i++) {
            for (k = 0; k < 4; k++) p[k * count + i] = (double)l[i].sphere[k];
            for (k = 0; k < 3; k++) rgb[k * count + i] = (double)l[i].radiance[k];
        }
        sh_spheres_f64(o->bands, SH_GRADIENT, 3, point, (size_t)count, p, rgb, out);
    } else {
        memset(out, 0, 12 * (size_t)n2 * sizeof *out);
        for (i = 0; i < count; i++) {
            for (k = 0; k < 3; k++) wide(l[i].corner[k], 3, v + 3 * k);
            if (o->kind == POLYGON_LIGHTS) sh_polygon_f64(o->bands, SH_BOTH, point, 3, v, c, c + n2);
            else sh_triangle_as_sphere_f64(o->bands, SH_BOTH, point, v, v + 3, v + 6, c, c + n2, NULL);
            add_light(n2, l[i].radiance, c, out);
        }
    }
    if (s->moon) {
        wide(s->moon_corner, 3 * s->moon_corners, p);
        sh_polygon_f64(o->bands, SH_BOTH, point, (size_t)s->moon_corners, p, c, c + n2);
        add_light(n2, l[count].radiance, c, out);
    }
    free(c);
    free(p);
}

agreement check_grid(const settings *o, const stage *s, const light *now)
{
    const int n2 = o->bands * o->bands, nodes = o->nodes[0] * o->nodes[1] * o->nodes[2];
    const vec3 d = sub(s->high, s->low);
    const float low[3] = { s->low.x, s->low.y, s->low.z }, size[3] = { d.x, d.y, d.z };
    float *gpu = passes_nodes(o);
    double *cpu = need(NULL, 12 * (size_t)n2, sizeof *cpu);
    agreement a = { 0, 0 };
    int node, l, i, c, p, k;

    for (node = 0; node < nodes; node++) {
        const int row = node / o->nodes[0];
        const int place[3] = { node % o->nodes[0], row % o->nodes[1], row / o->nodes[1] };
        double point[3];
        for (k = 0; k < 3; k++) {
            volatile float step = size[k] / (float)(o->nodes[k] - 1) * (float)place[k];   /* no contraction */
            point[k] = (double)(low[k] + step);
        }
        node_by_header(o, s, point, now, cpu);
        for (l = 0; l < o->bands; l++) {
            double worst[2] = { 0, 0 }, largest[2] = { 0, 0 };
            for (i = l * l; i < (l + 1) * (l + 1); i++)
                for (c = 0; c < 3; c++)
                    for (p = 0; p < 4; p++) {
                        const double e = cpu[(4 * c + p) * n2 + i];
                        const double g = (double)gpu[((node * n2 + i) * 3 + c) * 4 + p];
                        worst[p > 0] = worse(worst[p > 0], fabs(g - e));
                        largest[p > 0] = worse(largest[p > 0], fabs(e));
                    }
            a.value = worse(a.value, worst[0] / (largest[0] * (double)FLT_EPSILON));
            if (largest[1] > 0 || !(worst[1] <= 0))
                a.gradient = worse(a.gradient, worst[1] / (largest[1] * (double)FLT_EPSILON));
        }
    }
    free(gpu);
    free(cpu);
    return a;
}
