/* lamps.c - polygon lights: the exact light of triangles, each triangle replaced by a sphere, and what that
 * costs. After M22's Fig. 12, 16 and 17: many small triangles, where the replacement is good; few large and
 * narrow ones. */
#include "sh_interp.h"
#include "relight.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void lamp(scene *s, vec3 a, vec3 b, vec3 c)
{
    const vec3 corner[3] = { a, b, c };
    scene_add_lamp(s, corner, 3, vec(4.0f, 2.7f, 1.5f));
}

/* A square in 2 n^2 triangles, with corner at and edges u and v. */
static void hang_square(scene *s, vec3 at, vec3 u, vec3 v, int n)
{
    const vec3 du = mul(u, 1 / (float)n), dv = mul(v, 1 / (float)n);
    int i;
    for (i = 0; i < n * n; i++) {
        const vec3 p = mad(mad(at, du, (float)(i % n)), dv, (float)(i / n));
        lamp(s, p, add(p, du), add(p, add(du, dv)));
        lamp(s, p, add(p, add(du, dv)), add(p, dv));
    }
}

/* The same square's inscribed star: narrow rays, 1 : 30. */
static void hang_star(scene *s, vec3 at, vec3 u, vec3 v, int rays)
{
    const vec3 middle = mad(mad(at, u, 0.5f), v, 0.5f);
    int i;
    for (i = 0; i < rays; i++) {
        const float a = 6.2831853f * (float)i / (float)rays, c = cosf(a), k = sinf(a);
        const vec3 along = add(mul(u, c), mul(v, k)), across = add(mul(u, -k), mul(v, c));
        lamp(s, mad(middle, along, 0.55f), mad(mad(middle, along, 0.05f), across, 0.008f),
             mad(mad(middle, along, 0.05f), across, -0.008f));
    }
}

/* Large, dim, far behind the camera: what the lamps do not reach is dark and not black. */
static const float fill_sphere[4] = { -3, -18, 8, 2.5f }, fill_radiance[3] = { 0.35f, 0.48f, 0.7f };

static void one_fill_light(lights *l, float power)
{
    int k;
    l->count = 1;
    l->sphere = need(NULL, 4, sizeof *l->sphere);
    l->radiance = need(NULL, 3, sizeof *l->radiance);
    memcpy(l->sphere, fill_sphere, sizeof fill_sphere);
    for (k = 0; k < 3; k++) l->radiance[k] = power * fill_radiance[k];
}

void lamps_compare(const scene *room, const float *blocked, int bands, int nodes, int pieces, int width, int height,
                   const char *path)
{
    static const char *const format[3] = { "a square in %d triangles", "the square in %d triangles",
                                           "a star of %d needles" };
    static const float zoom[3] = { 1000, 10, 50 };
    const vec3 at = vec(-5.4f, -1.6f, 2.5f), u = vec(1.4f, 2.0f, 0), v = vec(0.6f, -0.4f, 2.3f);
    sheet out = sheet_new(3 * width, 3 * (height + LABEL));
    int row, i;

    printf("\nTriangle lights, %d bands, edge Hermite on %d^3 nodes: exact, and each triangle as a sphere; ms for the grid\n", bands,
           nodes);
    printf("%-26s %12s %12s %10s\n", "light", "grid, exact", "as spheres", "error/1000");
    for (row = 0; row < 3; row++) {
        method of[2] = { { "exact", SH_EDGE_HERMITE, nodes, SH_GRADIENT, 0, 0, 0, 0, NULL },
                         { "as spheres", SH_EDGE_HERMITE, nodes, SH_GRADIENT, 1, 0, 0, 0, NULL } };
        const size_t values = 3 * (size_t)width * (size_t)height;
        scene s;
        float *picture[3], exposure;
        char name[64], text[128];
        view w;

        scene_copy(&s, room);
        one_fill_light(&s.l, row == 2 ? 0.08f : 1);               /* the star is as much smaller */
        if (row == 2) hang_star(&s, at, u, v, 16);
        else hang_square(&s, at, u, v, row ? 1 : pieces);
        sprintf(name, format[row], s.p.count);
        view_trace(&w, &s, width, height);
        picture_glow(&w);
        shade(&s, &w, blocked, bands, of, 2);
        exposure = picture_exposure(&w, of[0].rgb);
        for (i = 0; i < 2; i++) picture[i] = picture_develop(&w, of[i].rgb, exposure);
        picture[2] = need(NULL, values, sizeof **picture);
        of[1].error = picture_difference(picture[1], picture[0], zoom[row], values, picture[2]);
        printf("%-26s %12.1f %12.1f %10.3f\n", name, 1e3 * of[0].build, 1e3 * of[1].build, 1e3 * of[1].error);
        for (i = 0; i < 3; i++) {
            if (i == 0) sprintf(text, "%s: exact", name);
            if (i == 1) sprintf(text, "each triangle as a sphere");
            if (i == 2) sprintf(text, "%g x the difference, error %.3fe-3", (double)zoom[row], 1e3 * of[1].error);
            sheet_label(&out, i * width, row * (height + LABEL), width, text);
            sheet_paste(&out, i * width, row * (height + LABEL) + LABEL, picture[i], width, height, 1);
            free(picture[i]);
        }
        free(of[0].rgb); free(of[1].rgb); free(w.at); free(w.glow); free(s.l.sphere); free(s.l.radiance);
        scene_free_copy(&s);
    }
    sheet_write(&out, path);
}
