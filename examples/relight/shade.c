/* shade.c - grids of coefficients, their reconstruction at every point of the view, and shading.
 *
 * The light at a point is an SH vector. It leaves a glossy surface by two dot products with transfer vectors: one for
 * the clamped cosine about the normal less what is blocked, one for the clamped cosine times the GGX lobe about the
 * mirror direction (MP21's product, taken once on the side of the view). The transfers know nothing of the light: when
 * lights move, a new grid, a reconstruction and the dot products are all there is to do. */
#include "sh_interp.h"
#include "sh_polygon.h"
#include "sh_product.h"
#include "relight.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#define PI 3.14159265f

enum { BLOCK = 128, MAX_N2 = BANDS * BANDS };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The scene's triangle lights at one node, each as a sphere: out[3][4][n2]. */
static void add_as_spheres(const lamps *p, const float node[3], int bands, float *out)
{
    const int n = 4 * bands * bands;
    float coeffs[4 * MAX_N2];
    int i, j, k;

    for (i = 0; i < p->count; i++) {
        const float *v = p->vertex + 9 * i;
        check(sh_triangle_as_sphere_f32(bands, SH_BOTH, node, v, v + 3, v + 6, coeffs, coeffs + n / 4, NULL));
        for (k = 0; k < 3; k++)
            for (j = 0; j < n; j++) out[k * n + j] += p->radiance[k * p->count + i] * coeffs[j];
    }
}

static void add_to(float *sum, const float *more, size_t count)
{
    size_t i;
    for (i = 0; i < count; i++) sum[i] += more[i];
}

typedef struct { sh_grid_f32 grid; float *coeffs /* [nodes][3][planes][n2] */; } field;

/* Polygons have no Hessian: a grid with Hessians holds the spheres alone, shade() adds the polygons at the
 * points. */
static field field_build(const scene *s, method *m, int bands)
{
    enum { CHUNK = 16 };
    const size_t size = 3 * (size_t)m->planes * (size_t)(bands * bands);
    const int n = m->nodes, nodes = n * n * n;
    const vec3 cell = mul(sub(s->high, s->low), 1 / (float)(n - 1));
    const double start = now();
    field f = { { { s->low.x, s->low.y, s->low.z }, { cell.x, cell.y, cell.z }, { n, n, n } }, NULL };
    int i, done = 0;

    f.coeffs = need(NULL, (size_t)nodes * size, sizeof *f.coeffs);
#pragma omp parallel for schedule(dynamic)
    for (i = 0; i < nodes; i += CHUNK) {
        const int count = nodes - i < CHUNK ? nodes - i : CHUNK;
        float *out = f.coeffs + (size_t)i * size;
        int j;

        check(sh_spheres_grid_f32(bands, m->planes, 3, &f.grid, (size_t)i, (size_t)count, (size_t)s->l.count,
                                  s->l.sphere, s->l.radiance, out));
        if (m->as_spheres) {
            for (j = i; j < i + count; j++) {
                const float node[3] = { s->low.x + cell.x * (float)(j % n), s->low.y + cell.y * (float)(j / n % n),
                                        s->low.z + cell.z * (float)(j / n / n) };
                add_as_spheres(&s->p, node, bands, out + (size_t)(j - i) * size);
            }
        } else if (m->planes != SH_HESSIAN && s->p.count) {
            float *more = need(NULL, (size_t)count * size, sizeof *more);
            check(sh_polygons_grid_f32(bands, m->planes, 3, SH_BOTH, &f.grid, (size_t)i, (size_t)count,
                                       (size_t)s->p.count, s->p.sides, s->p.vertex, s->p.radiance, more));
            add_to(out, more, (size_t)count * size);
            free(more);
        }
#pragma omp critical
        progress("grids", (double)(done += count) / nodes);
    }
    m->build = now() - start;
    return f;
}

/* What a thread works on: points, their transfers, colours (albedo / pi, Fresnel), and the light there,
 * packed. */
typedef struct {
    float place[BLOCK][3], normal[BLOCK][3], tint[BLOCK][4];
    float diffuse[BLOCK * MAX_N2], gloss[BLOCK * MAX_N2], light[BLOCK * 3 * MAX_N2], more[BLOCK * 3 * MAX_N2];
} block;

static void transfers(const scene *s, const float *blocked, int bands, const spot *p, int count, block *b)
{
    const int n2 = bands * bands;
    float cosine[BANDS], ggx[MATERIALS][BANDS];
    int i, j, k;

    check(sh_zonal_cosine_f32(bands, cosine));
    for (i = 0; i < MATERIALS; i++) check(sh_zonal_ggx_f32(bands, materials[i].alpha, ggx[i]));
    for (i = 0; i < count; i++) {
        const vec3 r = sub(mul(p[i].n, 2 * dot(p[i].n, p[i].out)), p[i].out);
        const float mirror[3] = { r.x, r.y, r.z };
        memcpy(b->place[i], &p[i].p, sizeof b->place[i]);
        memcpy(b->normal[i], &p[i].n, sizeof b->normal[i]);
        check(sh_zonal_rotate_f32(bands, cosine, b->normal[i], b->diffuse + i * n2));
        check(sh_zonal_rotate_f32(bands, ggx[p[i].material], mirror, b->gloss + i * n2));
    }
    check(sh_cosine_product_n_f32(bands, (size_t)count, b->normal[0], b->gloss, b->gloss));
    for (i = 0; i < count; i++) {
        const material *m = &materials[p[i].material];
        const float share[3] = { 1 - p[i].u - p[i].v, p[i].u, p[i].v }, away = 1 - fmaxf(dot(p[i].n, p[i].out), 0);
        const float f90 = fmaxf(1 - sqrtf(m->alpha), m->f0), fresnel = m->f0 + (f90 - m->f0) * powf(away, 5);
        float *d = b->diffuse + i * n2, open = 1 / d[0], under_white;

        for (k = 0; k < 3; k++) {
            const float *hidden = blocked + (size_t)s->m.t[p[i].triangle].v[k] * MAX_N2;
            for (j = 0; j < n2; j++) d[j] -= share[k] * hidden[j];
        }
        open = fmaxf(open * d[0], 0);                          /* the part of the cosine that sees the room */
        check(sh_diffuse_from_product_f32(b->gloss + i * n2, &under_white));
        b->tint[i][3] = open * fresnel / fmaxf(under_white, 0.05f);    /* Schlick 1994; a white room comes back */
        for (k = 0; k < 3; k++) b->tint[i][k] = m->albedo[k] / PI;
    }
}

static void shade_point(const block *b, int i, int n2, float rgb[3])
{
    const float *d = b->diffuse + i * n2, *g = b->gloss + i * n2, *l = b->light + 3 * i * n2;
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

void shade(const scene *s, const view *w, const float *blocked, int bands, method *at, int methods)
{
    field *f = need(NULL, (size_t)methods, sizeof *f);
    int i, threads = 0, done = 0;

    for (i = 0; i < methods; i++) {
        at[i].rgb = need(NULL, 3 * (size_t)w->count, sizeof *at[i].rgb);
        if (at[i].scheme != PER_POINT) f[i] = field_build(s, &at[i], bands);
    }
#pragma omp parallel
    {
        block *b = need(NULL, 1, sizeof *b);
        double *spent = need(NULL, (size_t)methods, sizeof *spent);
        int first, k, j;

#pragma omp for schedule(dynamic)
        for (first = 0; first < w->count; first += BLOCK) {
            const int count = w->count - first < BLOCK ? w->count - first : BLOCK;
            transfers(s, blocked, bands, w->at + first, count, b);
            for (k = 0; k < methods; k++) {
                const double start = now();
                if (at[k].scheme == PER_POINT)
                    check(sh_spheres_n_f32(bands, SH_VALUES, 3, (size_t)count, b->place[0],
                                           (size_t)s->l.count, s->l.sphere, s->l.radiance, b->light));
                else
                    check(sh_grid_interp_n_f32(bands, at[k].planes, 3, &f[k].grid, f[k].coeffs, at[k].scheme,
                                               SH_CLAMP, (size_t)count, b->place[0], b->light));
                if ((at[k].scheme == PER_POINT || at[k].planes == SH_HESSIAN) && s->p.count) {
                    check(sh_polygons_n_f32(bands, SH_VALUES, 3, SH_BOTH, (size_t)count, b->place[0],
                                            (size_t)s->p.count, s->p.sides, s->p.vertex, s->p.radiance, b->more));
                    add_to(b->light, b->more, (size_t)(count * 3 * bands * bands));
                }
                for (j = 0; j < count; j++) shade_point(b, j, bands * bands, at[k].rgb + 3 * (first + j));
                spent[k] += now() - start;
            }
#pragma omp critical
            if ((done += count) % (64 * BLOCK) < BLOCK || done == w->count)
                progress("shading", (double)done / w->count);
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
        free(f[i].coeffs);
    }
    free(f);
}
