/* check.c - the grid again by the C headers in double precision, and how far the GPU's is from it. */
#include "sh_polygon.h"
#include "gl.h"

#include <float.h>
#include <stdlib.h>

/* One node by the headers: out [3 channels][4 planes][n^2]. */
static void node_by_header(const settings *o, const double point[3], const light *l, int count, double *out)
{
    const int n2 = o->bands * o->bands;
    double *planes = need(NULL, 7 * (size_t)count, sizeof *planes), *rgb = planes + 4 * count;
    int i, k;

    for (i = 0; i < count; i++) {
        for (k = 0; k < 4; k++) planes[k * count + i] = (double)l[i].sphere[k];
        for (k = 0; k < 3; k++) rgb[k * count + i] = (double)l[i].radiance[k];
    }
    if (o->kind == SPHERE_LIGHTS)
        sh_spheres_f64(o->bands, SH_GRADIENT, 3, point, (size_t)count, planes, rgb, out);
    else {
        double *c = need(NULL, 4 * (size_t)n2, sizeof *c), v[3][3];
        for (i = 0; i < 12 * n2; i++) out[i] = 0;
        for (i = 0; i < count; i++) {
            for (k = 0; k < 9; k++) v[k / 3][k % 3] = (double)l[i].corner[k / 3][k % 3];
            if (o->kind == TRIANGLE_LIGHTS) sh_triangle_as_sphere_f64(o->bands, SH_BOTH, point, v[0], v[1], v[2], c, c + n2, NULL);
            else sh_polygon_f64(o->bands, SH_BOTH, point, 3, v[0], c, c + n2);
            for (k = 0; k < 12 * n2; k++) out[k] += rgb[k / (4 * n2) * count + i] * c[k % (4 * n2)];
        }
        free(c);
    }
    free(planes);
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
        const int place[3] = { node % o->nodes[0], node / o->nodes[0] % o->nodes[1], node / (o->nodes[0] * o->nodes[1]) };
        double point[3];
        for (k = 0; k < 3; k++) {
            volatile float step = size[k] / (float)(o->nodes[k] - 1) * (float)place[k];     /* no contraction */
            point[k] = (double)(low[k] + step);
        }
        node_by_header(o, point, now, s->count, cpu);
        for (l = 0; l < o->bands; l++) {
            double worst[2] = { 0, 0 }, largest[2] = { 0, 0 };
            for (i = l * l; i < (l + 1) * (l + 1); i++)
                for (c = 0; c < 3; c++)
                    for (p = 0; p < 4; p++) {
                        const double e = cpu[(4 * c + p) * n2 + i], g = (double)gpu[((node * n2 + i) * 3 + c) * 4 + p];
                        worst[p > 0] = worse(worst[p > 0], fabs(g - e));
                        largest[p > 0] = worse(largest[p > 0], fabs(e));
                    }
            a.value = worse(a.value, worst[0] / (largest[0] * (double)FLT_EPSILON));
            if (largest[1] > 0 || !(worst[1] <= 0)) a.gradient = worse(a.gradient, worst[1] / (largest[1] * (double)FLT_EPSILON));
        }
    }
    free(gpu);
    free(cpu);
    return a;
}
