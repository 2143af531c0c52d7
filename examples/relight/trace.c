/* trace.c - a bounding volume hierarchy over triangles and spheres, and the rays through it. */
#include "sh_gradient.h"
#include "relight.h"

#include <limits.h>
#include <stdlib.h>

#define PI   3.14159265f
#define TINY 1e-20f
#define SEAM 1e-5f           /* triangles overlap a little: no ray slips between */

/* ---- the hierarchy: binned surface-area heuristic, two children side by side ---- */

typedef struct { vec3 low, high; int first, count; } node;        /* count 0: children at first, first + 1 */
typedef struct { vec3 low, high, middle; int item; } box;         /* item: triangle, or triangles + light */
typedef struct { float t, u, v; int item; } hit;                  /* item -1: none */
typedef struct { const mesh *m; const lights *l; int triangles, nodes; node *at; int *item; } bvh;

static float axis_of(vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

static float area(vec3 low, vec3 high)
{
    const vec3 d = sub(high, low);
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

static vec3 centre(const lights *l, int i)
{
    return vec(l->sphere[i], l->sphere[l->count + i], l->sphere[2 * l->count + i]);
}

static float radius(const lights *l, int i) { return l->sphere[3 * l->count + i]; }

static box box_of(const bvh *b, int item)
{
    box x;
    x.item = item;
    if (item < b->triangles) {
        const int *v = b->m->t[item].v;
        const vec3 p = b->m->v[v[0]].p, q = b->m->v[v[1]].p, r = b->m->v[v[2]].p;
        x.low = lower(p, lower(q, r));
        x.high = upper(p, upper(q, r));
    } else {
        const vec3 c = centre(b->l, item - b->triangles);
        const float r = radius(b->l, item - b->triangles);
        x.low = sub(c, vec(r, r, r));
        x.high = add(c, vec(r, r, r));
    }
    x.middle = mul(add(x.low, x.high), 0.5f);
    return x;
}

enum { BINS = 16, LEAF = 4 };

/* Where to cut boxes[0..count) along which axis; the number that goes left, 0 when a leaf is as cheap. */
static int split(box *boxes, int count, vec3 low, vec3 high)
{
    vec3 mid_low = boxes[0].middle, mid_high = mid_low;
    float best = area(low, high) * (float)count, best_at = 0, best_scale = 0;
    int best_axis = -1, best_bin = 0, axis, i, left;

    for (i = 1; i < count; i++) {
        mid_low = lower(mid_low, boxes[i].middle);
        mid_high = upper(mid_high, boxes[i].middle);
    }
    for (axis = 0; axis < 3; axis++) {
        const float at = axis_of(mid_low, axis), width = axis_of(mid_high, axis) - at;
        const float scale = BINS * 0.999f / width;
        struct { vec3 low, high; int count; } bin[BINS];
        float right_area[BINS];
        vec3 l, h;
        int n;

        if (!(width > 0)) continue;
        for (i = 0; i < BINS; i++) {
            bin[i].low = vec(1e30f, 1e30f, 1e30f);
            bin[i].high = mul(bin[i].low, -1);
            bin[i].count = 0;
        }
        for (i = 0; i < count; i++) {
            const int k = (int)((axis_of(boxes[i].middle, axis) - at) * scale);
            bin[k].low = lower(bin[k].low, boxes[i].low);
            bin[k].high = upper(bin[k].high, boxes[i].high);
            bin[k].count++;
        }
        l = bin[BINS - 1].low;
        h = bin[BINS - 1].high;
        for (i = BINS - 1; i > 0; i--) {
            l = lower(l, bin[i].low);
            h = upper(h, bin[i].high);
            right_area[i] = area(l, h);
        }
        l = bin[0].low;
        h = bin[0].high;
        for (i = 1, n = 0; i < BINS; i++) {
            float cost;
            l = lower(l, bin[i - 1].low);
            h = upper(h, bin[i - 1].high);
            n += bin[i - 1].count;
            cost = area(l, h) * (float)n + right_area[i] * (float)(count - n) + area(low, high);
            if (n > 0 && n < count && (cost < best || (best_axis < 0 && count > 4 * LEAF))) {
                best = cost; best_axis = axis; best_bin = i; best_at = at; best_scale = scale;
            }
        }
    }
    if (best_axis < 0) return 0;
    for (i = left = 0; i < count; i++)
        if ((int)((axis_of(boxes[i].middle, best_axis) - best_at) * best_scale) < best_bin) {
            const box t = boxes[i];
            boxes[i] = boxes[left];
            boxes[left++] = t;
        }
    return left;
}

static void build(bvh *b, int at, box *boxes, int first, int count)
{
    node *n = &b->at[at];
    int i, left;

    n->low = boxes[first].low;
    n->high = boxes[first].high;
    for (i = 1; i < count; i++) {
        n->low = lower(n->low, boxes[first + i].low);
        n->high = upper(n->high, boxes[first + i].high);
    }
    left = count > LEAF ? split(boxes + first, count, n->low, n->high) : 0;
    n->first = left ? b->nodes : first;
    n->count = left ? 0 : count;
    if (!left) return;
    b->nodes += 2;
    build(b, n->first, boxes, first, left);
    build(b, n->first + 1, boxes, first + left, count - left);
}

/* Over the mesh's first triangles and the lights, or NULL. */
static bvh *bvh_build(const mesh *m, int triangles, const lights *l)
{
    const int items = triangles + (l ? l->count : 0);
    bvh *b = need(NULL, 1, sizeof *b);
    box *boxes = need(NULL, (size_t)items, sizeof *boxes);
    int i;

    b->m = m;
    b->l = l;
    b->triangles = triangles;
    b->at = need(NULL, 2 * (size_t)items, sizeof *b->at);
    b->item = need(NULL, (size_t)items, sizeof *b->item);
    b->nodes = 1;
    for (i = 0; i < items; i++) boxes[i] = box_of(b, i);
    build(b, 0, boxes, 0, items);
    for (i = 0; i < items; i++) b->item[i] = boxes[i].item;
    free(boxes);
    return b;
}

static void bvh_free(bvh *b)
{
    free(b->at);
    free(b->item);
    free(b);
}

/* ---- rays ---- */

/* Moeller and Trumbore 1997. Shadow rays pass through back faces: a vertex inside a closed part is not in its
 * shade. */
static void meet_triangle(const bvh *b, int item, vec3 from, vec3 d, int shadow, hit *h)
{
    const int *v = b->m->t[item].v;
    const vec3 a = b->m->v[v[0]].p, e = sub(b->m->v[v[1]].p, a), f = sub(b->m->v[v[2]].p, a);
    const vec3 p = cross(d, f), s = sub(from, a), q = cross(s, e);
    const float k = 1.0f / dot(e, p);
    const float u = dot(s, p) * k, w = dot(d, q) * k, t = dot(f, q) * k;

    if (u >= -SEAM && w >= -SEAM && u + w <= 1 + SEAM && t > 0 && t < h->t && (k > 0 || !shadow)) {   /* NaN never */
        h->t = t; h->u = u; h->v = w; h->item = item;
    }
}

static void meet_sphere(const bvh *b, int item, vec3 from, vec3 d, hit *h)
{
    const vec3 c = sub(centre(b->l, item - b->triangles), from);
    const float r = radius(b->l, item - b->triangles), along = dot(c, d);
    const vec3 off = mad(c, d, -along);
    const float inside = r * r - dot(off, off), t = inside > 0 ? along - sqrtf(inside) : -1;

    if (t > 0 && t < h->t) { h->t = t; h->u = h->v = 0; h->item = item; }
}

static float enter(const node *n, vec3 from, vec3 over, float far)                    /* or > far */
{
    const vec3 a = sub(n->low, from), z = sub(n->high, from);
    const vec3 s = vec(a.x * over.x, a.y * over.y, a.z * over.z), e = vec(z.x * over.x, z.y * over.y, z.z * over.z);
    const vec3 in = lower(s, e), out = upper(s, e);
    const float t = fmaxf(fmaxf(in.x, in.y), fmaxf(in.z, 0));

    return t <= fminf(fminf(out.x, out.y), fminf(out.z, far)) ? t : 2e30f;
}

static hit traverse(const bvh *b, vec3 from, vec3 d, int any)
{
    const vec3 over = vec(1 / (d.x != 0 ? d.x : TINY), 1 / (d.y != 0 ? d.y : TINY), 1 / (d.z != 0 ? d.z : TINY));
    int stack[128], top = 0, i;
    hit h;

    h.t = 1e30f; h.u = h.v = 0; h.item = -1;
    if (enter(&b->at[0], from, over, h.t) <= h.t) stack[top++] = 0;
    while (top > 0) {
        const node *n = &b->at[stack[--top]];
        if (n->count) {
            for (i = n->first; i < n->first + n->count; i++) {
                if (b->item[i] < b->triangles) meet_triangle(b, b->item[i], from, d, any, &h);
                else meet_sphere(b, b->item[i], from, d, &h);
            }
            if (any && h.item >= 0) break;
        } else {
            const float s = enter(&b->at[n->first], from, over, h.t), t = enter(&b->at[n->first + 1], from, over, h.t);
            const int near = t < s;                                               /* pushed last, met first */
            if (top > 126) break;
            if ((near ? s : t) <= h.t) stack[top++] = n->first + !near;
            if ((near ? t : s) <= h.t) stack[top++] = n->first + near;
        }
    }
    return h;
}

static hit bvh_closest(const bvh *b, vec3 from, vec3 d) { return traverse(b, from, d, 0); }
static int bvh_blocked(const bvh *b, vec3 from, vec3 d) { return traverse(b, from, d, 1).item >= 0; }

/* ---- what the camera sees: one ray per pixel, SUB x SUB where neighbours differ ---- */

enum { SUB = 3 };

typedef struct { vec3 n; float t; int kind; } seen;            /* kind: material, or -1 - light, or NOTHING */
enum { NOTHING = INT_MAX };
typedef struct {
    const camera *c;
    const mesh *m;
    const lights *l;
    const lamps *p;
    bvh *b;
    vec3 right, up, ahead;
    int width, height;
} eye;

static vec3 ray(const eye *e, float x, float y)                    /* x, y in pixels */
{
    const float k = e->c->width / (float)e->width;
    return unit(mad(mad(e->ahead, e->right, (x - 0.5f * (float)e->width) * k),
                    e->up, (0.5f * (float)e->height - y) * k));
}

static spot spot_of(const eye *e, const hit *h, vec3 d)
{
    const int *v = e->m->t[h->item].v;
    const vertex *a = &e->m->v[v[0]], *b = &e->m->v[v[1]], *c = &e->m->v[v[2]];
    const vec3 face = cross(sub(b->p, a->p), sub(c->p, a->p));
    spot p;

    p.p = mad(e->c->eye, d, h->t);
    p.n = unit(mad(mad(mul(a->n, 1 - h->u - h->v), b->n, h->u), c->n, h->v));
    if ((dot(face, d) > 0) == (dot(face, p.n) > 0)) p.n = mul(p.n, -1);               /* seen from behind */
    p.out = mul(d, -1);
    p.u = h->u;
    p.v = h->v;
    p.weight = 1;
    p.pixel = 0;
    p.triangle = h->item;
    p.material = e->m->t[h->item].material;
    return p;
}

static seen look(const eye *e, int x, int y)
{
    const vec3 d = ray(e, (float)x + 0.5f, (float)y + 0.5f);
    const hit h = bvh_closest(e->b, e->c->eye, d);
    seen s;

    s.t = h.t;
    s.n = mul(d, -1);
    s.kind = NOTHING;
    if (h.item >= e->m->triangles) s.kind = -1 - (h.item - e->m->triangles);
    else if (h.item >= 0) {
        const spot p = spot_of(e, &h, d);
        s.n = p.n;
        s.kind = p.material;
    }
    return s;
}

static int differ(const seen *a, const seen *b)
{
    return a->kind != b->kind || dot(a->n, b->n) < 0.9f || fabsf(a->t - b->t) > 0.04f * fminf(a->t, b->t);
}

static int add_points(const eye *e, int x, int y, int sub, spot *to, float *glow)
{
    const float share = 1.0f / (float)(sub * sub);
    int i, k, count = 0;

    for (i = 0; i < sub * sub; i++) {
        const float dx = ((float)(i % sub) + 0.5f) / (float)sub, dy = ((float)(i / sub) + 0.5f) / (float)sub;
        const vec3 d = ray(e, (float)x + dx, (float)y + dy);
        const hit h = bvh_closest(e->b, e->c->eye, d);
        if (h.item >= e->m->triangles) {
            const float *rgb = e->l->radiance + h.item - e->m->triangles;
            for (k = 0; k < 3; k++) glow[k] += share * rgb[k * e->l->count];
        } else if (h.item >= 0 && e->m->t[h.item].material >= LAMP) {
            const float *rgb = e->p->radiance + e->m->t[h.item].material - LAMP;
            for (k = 0; k < 3; k++) glow[k] += share * rgb[k * e->p->count];
        } else if (h.item >= 0) {
            to[count] = spot_of(e, &h, d);
            to[count].weight = share;
            to[count++].pixel = y * e->width + x;
        }
    }
    return count;
}

void view_trace(view *w, const scene *s, int width, int height)
{
    const size_t pixels = (size_t)width * (size_t)height;
    seen *first = need(NULL, pixels, sizeof *first);
    spot **row = need(NULL, (size_t)height, sizeof *row);
    int *count = need(NULL, (size_t)height, sizeof *count), y, done = 0;
    eye e;

    e.c = &s->c; e.m = &s->m; e.l = &s->l; e.p = &s->p; e.width = width; e.height = height;
    e.b = bvh_build(e.m, e.m->triangles, e.l);
    e.ahead = unit(sub(s->c.at, s->c.eye));
    e.right = unit(cross(e.ahead, vec(0, 0, 1)));
    e.up = cross(e.right, e.ahead);
    w->width = width;
    w->height = height;
    w->glow = need(NULL, 3 * pixels, sizeof *w->glow);

#pragma omp parallel for schedule(dynamic, 4)
    for (y = 0; y < height; y++) {
        int x;
        for (x = 0; x < width; x++) first[y * width + x] = look(&e, x, y);
    }
#pragma omp parallel for schedule(dynamic, 4)
    for (y = 0; y < height; y++) {
        int x;
        row[y] = need(NULL, (size_t)width * SUB * SUB, sizeof **row);
        count[y] = 0;
        for (x = 0; x < width; x++) {
            const seen *a = &first[y * width + x];
            const int edge = (x > 0 && differ(a, a - 1)) || (x + 1 < width && differ(a, a + 1))
                          || (y > 0 && differ(a, a - width)) || (y + 1 < height && differ(a, a + width));
            count[y] += add_points(&e, x, y, edge ? SUB : 1, row[y] + count[y], w->glow + 3 * (y * width + x));
        }
        row[y] = need(row[y], (size_t)count[y], sizeof **row);
#pragma omp critical
        progress("rays of the view", (double)++done / height);
    }
    for (y = w->count = 0; y < height; y++) w->count += count[y];
    w->at = need(NULL, (size_t)w->count, sizeof *w->at);
    for (y = done = 0; y < height; y++) {
        int i;
        for (i = 0; i < count[y]; i++) w->at[done++] = row[y][i];
        free(row[y]);
    }
    bvh_free(e.b);
    free(first); free(row); free(count);
}

/* ---- shadows: precomputed transfer [Sloan, Kautz, Snyder 2002], kept as what is missing from the exact cosine ---- */

float *trace_blocked(const scene *s, int bands, int rays)
{
    const mesh *m = &s->m;
    const int n2 = bands * bands;
    float *blocked = need(NULL, (size_t)m->vertices * (size_t)n2, sizeof *blocked);
    vec3 *direction = need(NULL, (size_t)rays, sizeof *direction);
    float *y = need(NULL, (size_t)rays * (size_t)n2, sizeof *y);
    bvh *b = bvh_build(m, s->casters, NULL);
    int i, done = 0;

    for (i = 0; i < rays; i++) {                          /* a golden spiral: even, and the same everywhere */
        const float z = 1 - (2 * (float)i + 1) / (float)rays, r = sqrtf(1 - z * z), a = 2.39996323f * (float)i;
        direction[i] = vec(r * cosf(a), r * sinf(a), z);
    }
    check(sh_eval_n_f32(bands, (size_t)rays, &direction->x, y));
#pragma omp parallel for schedule(dynamic, 64)
    for (i = 0; i < m->vertices; i++) {
        const vec3 n = m->v[i].n, from = mad(m->v[i].p, n, 2e-3f);
        float *to = blocked + (size_t)i * (size_t)n2;
        int k, j;

        for (k = 0; k < rays; k++) {
            const float cosine = dot(n, direction[k]), weight = cosine * 4 * PI / (float)rays;
            if (cosine > 0 && bvh_blocked(b, from, direction[k]))
                for (j = 0; j < n2; j++) to[j] += weight * y[k * n2 + j];
        }
#pragma omp critical
        if (++done % 256 == 0 || done == m->vertices) progress("rays of the shadows", (double)done / m->vertices);
    }
    bvh_free(b);
    free(direction); free(y);
    return blocked;
}
