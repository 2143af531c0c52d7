/* shade.c - grids of coefficients, their reconstruction at every point of the view, and shading.
 *
 * The light at a point is an SH vector. It leaves a glossy surface by two dot products with transfer vectors: one for
 * the clamped cosine about the normal less what is blocked, one for the GGX lobe about the mirror direction. The
 * transfers depend on the view alone: a moving light needs a new grid, a reconstruction and the dot products. */
#include "relight.h"
#include "sh_interp.h"
#include "sh_product.h"

#include <stdlib.h>
#include <time.h>

#define PI 3.14159265f

static const struct { float albedo[3], f0, roughness; } materials[] = {
    { {0.78f, 0.76f, 0.72f}, 0.05f, 0.30f },       /* GLAZE */
    { {0.34f, 0.33f, 0.33f}, 0.06f, 0.30f },       /* FLOOR_LIGHT */
    { {0.05f, 0.05f, 0.06f}, 0.06f, 0.30f },       /* FLOOR_DARK */
    { {0.20f, 0.20f, 0.22f}, 0.03f, 0.80f },       /* WALL */
};
enum { MATERIALS = 4, BLOCK = 128, MAX_N2 = BANDS * BANDS };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void check(int status)
{
    if (status < 0) die("%s", sh_status_string(status));
}

static float *grid_build(const scene *s, const sh_grid_f32 *g, int planes, int bands)
{
    const size_t size = 3 * (size_t)planes * (size_t)(bands * bands), chunk = 8;
    const long nodes = (long)g->count[0] * g->count[1] * g->count[2];
    float *coeffs = need(NULL, (size_t)nodes * size, sizeof *coeffs);
    long first;

#pragma omp parallel for schedule(dynamic)
    for (first = 0; first < nodes; first += (long)chunk)
        check(sh_spheres_grid_f32(bands, planes, 3, g, (size_t)first, nodes - first < (long)chunk ? (size_t)(nodes - first) : chunk,
                                  (size_t)s->l->count, s->l->sphere, s->l->radiance, coeffs + (size_t)first * size));
    return coeffs;
}

/* What a thread works on: points, their transfers, colours (albedo / pi, Fresnel), and the light there, packed. */
typedef struct {
    float place[BLOCK][3], diffuse[BLOCK][MAX_N2], gloss[BLOCK][MAX_N2], tint[BLOCK][4], light[BLOCK * 3 * MAX_N2];
} block;

static void transfer(const scene *s, int bands, const float *cosine, const float (*ggx)[BANDS], const point *p, block *b, int i)
{
    const int n2 = bands * bands, *v = s->m->t[p->triangle].v, mat = p->material;
    const float share[3] = { 1 - p->u - p->v, p->u, p->v }, facing = fmaxf(dot(p->n, p->out), 0);
    const vec3 mirror = sub(mul(p->n, 2 * dot(p->n, p->out)), p->out);
    const float edge = 1 - facing, f0 = materials[mat].f0, f90 = fmaxf(1 - materials[mat].roughness, f0);
    float *d = b->diffuse[i], open;
    int k, j;

    b->place[i][0] = p->p.x; b->place[i][1] = p->p.y; b->place[i][2] = p->p.z;
    check(sh_zonal_rotate_f32(bands, cosine, &p->n.x, d));
    check(sh_zonal_rotate_f32(bands, ggx[mat], &mirror.x, b->gloss[i]));
    open = 1 / d[0];
    for (k = 0; k < 3; k++) {
        const float *blocked = s->blocked + (size_t)v[k] * MAX_N2;
        for (j = 0; j < n2; j++) d[j] -= share[k] * blocked[j];
    }
    open *= d[0];
    for (k = 0; k < 3; k++) b->tint[i][k] = materials[mat].albedo[k] / PI;
    b->tint[i][3] = fmaxf(open, 0) * (f0 + (f90 - f0) * edge * edge * edge * edge * edge);         /* Schlick 1994 */
}

static void shade_point(const block *b, int i, int n2, float rgb[3])
{
    const float *d = b->diffuse[i], *g = b->gloss[i], *l = b->light + 3 * i * n2;
    float dr = 0, dg = 0, db = 0, gr = 0, gg = 0, gb = 0;
    int j;

#pragma omp simd reduction(+ : dr, dg, db, gr, gg, gb)
    for (j = 0; j < n2; j++) {
        dr += d[j] * l[j]; dg += d[j] * l[n2 + j]; db += d[j] * l[2 * n2 + j];
        gr += g[j] * l[j]; gg += g[j] * l[n2 + j]; gb += g[j] * l[2 * n2 + j];
    }
    rgb[0] = b->tint[i][0] * fmaxf(dr, 0) + b->tint[i][3] * fmaxf(gr, 0);
    rgb[1] = b->tint[i][1] * fmaxf(dg, 0) + b->tint[i][3] * fmaxf(gg, 0);
    rgb[2] = b->tint[i][2] * fmaxf(db, 0) + b->tint[i][3] * fmaxf(gb, 0);
}

void shade(const scene *s, int bands, method *at, int methods)
{
    const int n2 = bands * bands, points = s->w->count;
    sh_grid_f32 *grid = need(NULL, (size_t)methods, sizeof *grid);
    float **coeffs = need(NULL, (size_t)methods, sizeof *coeffs);
    float cosine[BANDS], ggx[MATERIALS][BANDS];
    int i, threads = 0, done = 0;

    check(sh_zonal_cosine_f32(bands, cosine));
    for (i = 0; i < MATERIALS; i++) check(sh_zonal_ggx_f32(bands, materials[i].roughness, ggx[i]));
    for (i = 0; i < methods; i++) {
        const vec3 size = sub(s->high, s->low);
        const int n = at[i].nodes;
        const float cell[3] = { size.x / (float)(n - 1), size.y / (float)(n - 1), size.z / (float)(n - 1) };
        const float origin[3] = { s->low.x, s->low.y, s->low.z };
        int k;

        at[i].rgb = need(at[i].rgb, 3 * (size_t)points, sizeof *at[i].rgb);
        at[i].shade = at[i].build = 0;
        if (at[i].scheme == PER_POINT) continue;
        for (k = 0; k < 3; k++) {
            grid[i].origin[k] = origin[k];
            grid[i].cell[k] = cell[k];
            grid[i].count[k] = n;
        }
        at[i].build = now();
        coeffs[i] = grid_build(s, &grid[i], at[i].planes, bands);
        at[i].build = now() - at[i].build;
        progress("grids", (double)(i + 1) / methods);
    }
#pragma omp parallel
    {
        block *b = need(NULL, 1, sizeof *b);
        double *spent = need(NULL, (size_t)methods, sizeof *spent);
        int first, k, j;

#pragma omp for schedule(dynamic)
        for (first = 0; first < points; first += BLOCK) {
            const int count = points - first < BLOCK ? points - first : BLOCK;
            for (j = 0; j < count; j++) transfer(s, bands, cosine, (const float (*)[BANDS])ggx, &s->w->at[first + j], b, j);
            for (k = 0; k < methods; k++) {
                const double start = now();
                if (at[k].scheme == PER_POINT)
                    check(sh_spheres_n_f32(bands, SH_VALUES, 3, (size_t)count, b->place[0], (size_t)s->l->count,
                                           s->l->sphere, s->l->radiance, b->light));
                else
                    check(sh_grid_interp_n_f32(bands, at[k].planes, 3, &grid[k], coeffs[k], at[k].scheme, SH_CLAMP,
                                               (size_t)count, b->place[0], b->light));
                for (j = 0; j < count; j++) shade_point(b, j, n2, at[k].rgb + 3 * (size_t)(first + j));
                spent[k] += now() - start;
            }
#pragma omp critical
            if ((done += count) % (64 * BLOCK) < BLOCK) progress("shading", (double)done / points);
        }
#pragma omp critical
        {
            for (k = 0; k < methods; k++) at[k].shade += spent[k];
            threads++;
        }
        free(b);
        free(spent);
    }
    for (i = 0; i < methods; i++) {
        at[i].shade /= threads;                                  /* all of them work all the time */
        free(coeffs[i]);
    }
    free(coeffs);
    free(grid);
}
