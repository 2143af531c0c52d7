/* recipes.c - the usual jobs, each beside what it should give: a cube map to irradiance; sphere and polygon lights on one grid,
 * read back and shaded between its nodes. */
#include "sh_gradient.h"
#include "sh_interp.h"
#include "sh_polygon.h"
#include "sh_product.h"

#include <stdio.h>
#include <stdlib.h>

enum { BANDS = 5, N = BANDS * BANDS };

static void check(int status)
{
    if (status >= 0) return;                    /* SH_INSIDE and SH_ON_LIGHT are results */
    fprintf(stderr, "recipes: %s\n", sh_status_string(status));
    exit(1);
}

/* A cube map of a sky of radiance 1 over ground of radiance 0. A texel's weight is its radiance times its solid angle;
 * colour is one call per channel. */
static void cube_map(void)
{
    enum { EDGE = 32, TEXELS = 6 * EDGE * EDGE };
    static float dirs[3 * TEXELS], weights[TEXELS];
    static const float up[3] = { 0, 0, 1 }, aside[3] = { 1, 0, 0 };
    float light[N], e[2];
    int face, i, j, at = 0;
    for (face = 0; face < 6; face++)
        for (j = 0; j < EDGE; j++)
            for (i = 0; i < EDGE; i++, at++) {
                const float s = (2 * (float)i + 1) / EDGE - 1, t = (2 * (float)j + 1) / EDGE - 1, r = sqrtf(1 + s * s + t * t);
                float *const d = dirs + 3 * at;
                d[face / 2] = face & 1 ? -1.0f : 1.0f;
                d[(face / 2 + 1) % 3] = s;
                d[(face / 2 + 2) % 3] = t;      /* any length: it is normalised */
                weights[at] = (d[2] > 0 ? 1.0f : 0.0f) * 4 / ((float)(EDGE * EDGE) * r * r * r);
            }
    check(sh_project_n_f32(BANDS, TEXELS, dirs, weights, light));
    check(sh_diffuse_f32(BANDS, light, up, e));
    check(sh_diffuse_f32(BANDS, light, aside, e + 1));
    printf("sky     irradiance up %.3f, aside %.3f (a half sky: pi, pi/2)\n", (double)e[0], (double)e[1]);
}

/* Lights of both kinds on one grid. sh_spheres_grid and sh_polygons_grid each write all they are given: add the second. */
static void grid(void)
{
    enum { NODES = 8, LIGHTS = 3, BLOCK = 4 * N };
    static const float spheres[4][LIGHTS] = { { 3, -2, 0.5f }, { 0.5f, 3, -2 }, { 2, 1, 2.5f }, { 0.5f, 0.3f, 0.4f } };   /* x, y, z, r */
    static const float lamp[12] = { -1, -1, 3,  -1, 1, 3,  1, 1, 3,  1, -1, 3 };       /* shines down: its front is below */
    static const int corners[1] = { 4 };
    static const float radiance[LIGHTS] = { 5, 8, 3 }, lamp_radiance[1] = { 2 };
    static float nodes[NODES * NODES * NODES * BLOCK], more[NODES * NODES * NODES * BLOCK];
    const sh_grid_f32 g = { { 0, 0, 0 }, { 1.0f / 7, 1.0f / 7, 1.0f / 7 }, { NODES, NODES, NODES } };
    const float point[3] = { 0.41f, 0.57f, 0.33f }, normal[3] = { 0.2f, 0.3f, 0.9f };
    float between[N], there[N], lamp_there[N], e[2];
    size_t i;
    check(sh_spheres_grid_f32(BANDS, SH_GRADIENT, 1, &g, 0, NODES * NODES * NODES, LIGHTS, spheres[0], radiance, nodes));
    check(sh_polygons_grid_f32(BANDS, SH_GRADIENT, 1, SH_FRONT, &g, 0, NODES * NODES * NODES, 1, corners, lamp, lamp_radiance, more));
    for (i = 0; i < sizeof nodes / sizeof *nodes; i++) nodes[i] += more[i];
    check(sh_grid_interp_f32(BANDS, SH_GRADIENT, 1, &g, nodes, SH_EDGE_HERMITE, SH_CLAMP, point, between));

    check(sh_spheres_f32(BANDS, SH_VALUES, 1, point, LIGHTS, spheres[0], radiance, there));
    check(sh_polygons_f32(BANDS, SH_VALUES, 1, SH_FRONT, point, 1, corners, lamp, lamp_radiance, lamp_there));
    for (i = 0; i < N; i++) there[i] += lamp_there[i];

    check(sh_diffuse_f32(BANDS, between, normal, e));
    check(sh_diffuse_f32(BANDS, there, normal, e + 1));
    printf("lights  irradiance from the grid %.4f, from the lights %.4f\n", (double)e[0], (double)e[1]);
}

int main(void)
{
    cube_map();
    grid();
    return 0;
}
