/* mesh.c - triangle meshes: the Utah teapot, OBJ files, the room. */
#include "relight.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Arrays that grow by one double when their count reaches a power of two. */
#define GROW(array, n) do { \
    if (((n) & ((n) - 1)) == 0) (array) = need((array), (n) ? 2 * (size_t)(n) : 1, sizeof *(array)); } while (0)

static int add_vertex(mesh *m, vec3 p, vec3 n)
{
    GROW(m->v, m->vertices);
    m->v[m->vertices].p = p;
    m->v[m->vertices].n = n;
    return m->vertices++;
}

static void add_triangle(mesh *m, int a, int b, int c, int kind)
{
    triangle *t;
    GROW(m->t, m->triangles);
    t = &m->t[m->triangles++];
    t->v[0] = a; t->v[1] = b; t->v[2] = c;
    t->material = kind;
}

void mesh_add(mesh *m, vec3 a, vec3 b, vec3 c, int kind)
{
    const vec3 n = unit(cross(sub(b, a), sub(c, a)));
    const int i = add_vertex(m, a, n), j = add_vertex(m, b, n);
    add_triangle(m, i, j, add_vertex(m, c, n), kind);
}

/* ---- the teapot ----
 * Martin Newell's control points (1975), in Blinn's proportions. Rim, body, lid and bottom are revolved: a row is
 * radius, length of the handles of its four quarter circles, height. Handle and spout are mirrored in y: a row is
 * one side x z, other side x z, half width. Every three rows make a patch with the row that follows: 32 in all. */

static const float outside[10][3] = {
    {1.4f, .784f, 2.4f}, {1.3375f, .749f, 2.53125f}, {1.4375f, .805f, 2.53125f}, {1.5f, .84f, 2.4f},
    {1.75f, .98f, 1.875f}, {2, 1.12f, 1.35f}, {2, 1.12f, .9f}, {2, 1.12f, .45f}, {1.5f, .84f, .225f},
    {1.5f, .84f, .15f} };
static const float lid[7][3] = { {0, 0, 3.15f}, {.8f, .45f, 3.15f}, {0, 0, 2.85f}, {.2f, .112f, 2.7f},
    {.4f, .224f, 2.55f}, {1.3f, .728f, 2.55f}, {1.3f, .728f, 2.4f} };
static const float bottom[4][3] = { {1.5f, .84f, .15f}, {1.5f, .84f, .075f}, {1.425f, .798f, 0}, {0, 0, 0} };
static const float handle[7][5] = {
    {-1.6f, 2.025f, -1.5f, 2.25f, .3f}, {-2.3f, 2.025f, -2.5f, 2.25f, .3f}, {-2.7f, 2.025f, -3, 2.25f, .3f},
    {-2.7f, 1.8f, -3, 1.8f, .3f}, {-2.7f, 1.575f, -3, 1.35f, .3f}, {-2.5f, 1.125f, -2.65f, .9375f, .3f},
    {-2, .9f, -1.9f, .6f, .3f} };
static const float spout[7][5] = {
    {1.7f, 1.425f, 1.7f, .6f, .66f}, {2.6f, 1.425f, 3.1f, .825f, .66f}, {2.3f, 2.1f, 2.4f, 2.025f, .25f},
    {2.7f, 2.4f, 3.3f, 2.4f, .25f}, {2.8f, 2.475f, 3.525f, 2.49375f, .25f}, {2.9f, 2.475f, 3.45f, 2.5125f, .15f},
    {2.8f, 2.4f, 3.2f, 2.4f, .15f} };

/* A cubic at t: the point for d = 0, the derivative for d = 1. */
static vec3 bezier(const vec3 c[4], float t, int d)
{
    const float s = 1 - t;
    const float value[4] = { s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t };
    const float slope[4] = { -3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t };
    const float *w = d ? slope : value;
    return mad(mad(mad(mul(c[0], w[0]), c[1], w[1]), c[2], w[2]), c[3], w[3]);
}

static vec3 surface(vec3 c[4][4], float u, float v, int du, int dv)
{
    vec3 row[4];
    int i;
    for (i = 0; i < 4; i++) row[i] = bezier(c[i], v, dv);
    return bezier(row, u, du);
}

static void add_patch(mesh *m, vec3 c[4][4], int steps)
{
    const int first = m->vertices, row = steps + 1;
    int i, j;

    for (i = 0; i <= steps; i++)
        for (j = 0; j <= steps; j++) {
            const float u = (float)i / (float)steps, v = (float)j / (float)steps;
            const float us = u + (0.5f - u) * 1e-3f;       /* the normal from just inside: poles have none */
            add_vertex(m, surface(c, u, v, 0, 0), unit(cross(surface(c, us, v, 1, 0), surface(c, us, v, 0, 1))));
        }
    for (i = 0; i < steps; i++)
        for (j = 0; j < steps; j++) {
            const int a = first + i * row + j;
            add_triangle(m, a, a + row, a + row + 1, GLAZE);
            add_triangle(m, a, a + row + 1, a + 1, GLAZE);
        }
}

static void add_revolved(mesh *m, const float (*row)[3], int rows, int steps)
{
    static const float turn[4][2] = { {1, 0}, {0, 1}, {-1, 0}, {0, -1} };
    vec3 c[4][4];
    int k, q, i, j;

    for (k = 0; k + 3 < rows; k += 3)
        for (q = 0; q < 4; q++) {
            for (i = 0; i < 4; i++) {
                const float r = row[k + i][0], h = row[k + i][1], x[4] = { r, r, h, 0 }, y[4] = { 0, h, r, r };
                for (j = 0; j < 4; j++)
                    c[i][j] = vec(x[j] * turn[q][0] - y[j] * turn[q][1], x[j] * turn[q][1] + y[j] * turn[q][0],
                                  row[k + i][2]);
            }
            add_patch(m, c, steps);
        }
}

static void add_mirrored(mesh *m, const float (*row)[5], int steps)
{
    vec3 c[4][4];
    int k, side, i, j;

    for (k = 0; k < 6; k += 3)
        for (side = 0; side < 2; side++) {
            for (i = 0; i < 4; i++)
                for (j = 0; j < 4; j++) {
                    const float *r = row[k + i] + (j < 2 ? 0 : 2), w = j == 0 || j == 3 ? 0 : row[k + i][4];
                    c[i][side ? j : 3 - j] = vec(r[0], side ? w : -w, r[1]);   /* turned, so that normals point out */
                }
            add_patch(m, c, steps);
        }
}

void mesh_teapot(mesh *m, int steps)
{
    add_revolved(m, outside, 10, steps);
    add_revolved(m, lid, 7, steps);
    add_revolved(m, bottom, 4, steps);
    add_mirrored(m, handle, steps);
    add_mirrored(m, spout, steps);
}

/* ---- OBJ ---- v, vn and f are read, the rest of the format is skipped */

static char *read_text(const char *path)
{
    FILE *f = fopen(path, "rb");
    char *text = NULL;
    size_t size = 0, got;

    if (!f) die("cannot open %s", path);
    do {
        text = need(text, size + 65537, 1);
        got = fread(text + size, 1, 65536, f);
        size += got;
    } while (got > 0);
    if (ferror(f)) die("cannot read %s", path);
    fclose(f);
    text[size] = 0;
    if (strlen(text) != size) die("%s is not an OBJ file: it holds a zero byte", path);
    return text;
}

typedef struct {
    const char *path;
    char up;
    int line, positions, normals;
    vec3 *position, *normal;
    int *head;                  /* of each position: its first vertex, or -1 */
    int *next, *with;   /* of each vertex: the next one at its position; its normal, or -1 for a smooth one */
} reader;

static vec3 read_vec(const reader *r, const char *s)
{
    float x[3];
    char *end;
    int i;
    for (i = 0; i < 3; i++, s = end) {
        x[i] = strtof(s, &end);
        if (end == s || !(fabsf(x[i]) < 1e18f)) die("%s:%d: three numbers expected", r->path, r->line);
    }
    return r->up == 'y' ? vec(x[0], -x[2], x[1]) : vec(x[0], x[1], x[2]);
}

/* One index of a corner: from 1, or from -1 backwards. */
static int read_index(const reader *r, char **s, int count, const char *what)
{
    char *end;
    const long i = strtol(*s, &end, 10);
    if (end == *s || strchr(" \t\r\n", **s)) die("%s:%d: a face corner is v, v/vt, v//vn or v/vt/vn", r->path, r->line);
    if (i == 0 || i > count || i < -(long)count)
        die("%s:%d: %s %ld of %d", r->path, r->line, what, i, count);
    *s = end;
    return (int)(i > 0 ? i - 1 : i + count);
}

static int read_corner(reader *r, mesh *m, char **s)
{
    const int p = read_index(r, s, r->positions, "position");
    int n = -1, i;

    if (**s == '/') {
        ++*s;
        if (**s != '/') read_index(r, s, INT_MAX, "texture coordinate");
        if (**s == '/') { ++*s; n = read_index(r, s, r->normals, "normal"); }
    }
    if (**s && !strchr(" \t\r\n", **s))
        die("%s:%d: a face corner is v, v/vt, v//vn or v/vt/vn", r->path, r->line);
    for (i = r->head[p]; i >= 0; i = r->next[i])
        if (r->with[i] == n) return i;
    GROW(r->next, m->vertices);
    GROW(r->with, m->vertices);
    i = add_vertex(m, r->position[p], n < 0 ? vec(0, 0, 0) : unit(r->normal[n]));
    r->next[i] = r->head[p];
    r->with[i] = n;
    return r->head[p] = i;
}

/* A polygon as a fan; corners without a normal collect the area-weighted face normals. */
static void read_face(reader *r, mesh *m, char *s)
{
    int corner[3], k = 0, i;

    for (;; k++) {
        s += strspn(s, " \t\r");
        if (*s == '\n' || *s == '#' || !*s) break;
        if (k > 2) corner[1] = corner[2];
        corner[k > 2 ? 2 : k] = read_corner(r, m, &s);
        if (k < 2) continue;
        add_triangle(m, corner[0], corner[1], corner[2], GLAZE);
        for (i = 0; i < 3; i++)
            if (r->with[corner[i]] < 0) {
                const vec3 a = m->v[corner[0]].p;
                vec3 *n = &m->v[corner[i]].n;
                *n = add(*n, cross(sub(m->v[corner[1]].p, a), sub(m->v[corner[2]].p, a)));
            }
    }
    if (k < 3) die("%s:%d: a face has three corners or more, this one %d", r->path, r->line, k);
}

void mesh_read_obj(mesh *m, const char *path, char up)
{
    char *text = read_text(path), *s = text;
    double volume = 0;
    reader r;
    int i;

    memset(&r, 0, sizeof r);
    r.path = path;
    r.up = up;
    for (r.line = 1; *s; r.line++) {
        s += strspn(s, " \t");
        if (s[0] == 'v' && (s[1] == ' ' || s[1] == '\t')) {
            GROW(r.position, r.positions);
            GROW(r.head, r.positions);
            r.head[r.positions] = -1;
            r.position[r.positions++] = read_vec(&r, s + 2);
        } else if (s[0] == 'v' && s[1] == 'n') {
            GROW(r.normal, r.normals);
            r.normal[r.normals++] = read_vec(&r, s + 2);
        } else if (s[0] == 'f' && (s[1] == ' ' || s[1] == '\t'))
            read_face(&r, m, s + 2);
        s += strcspn(s, "\n");
        s += *s == '\n';
    }
    if (m->triangles == 0) die("%s holds no face", path);
    for (i = 0; i < m->triangles; i++) {
        const int *v = m->t[i].v;
        volume += (double)dot(m->v[v[0]].p, cross(m->v[v[1]].p, m->v[v[2]].p));
    }
    for (i = 0; volume < 0 && i < m->triangles; i++) {     /* inside out: the faces run clockwise */
        const int second = m->t[i].v[1];
        m->t[i].v[1] = m->t[i].v[2];
        m->t[i].v[2] = second;
    }
    for (i = 0; i < m->vertices; i++) m->v[i].n = unit(mul(m->v[i].n, volume < 0 && r.with[i] < 0 ? -1 : 1));
    free(r.position); free(r.normal); free(r.head); free(r.next); free(r.with);
    free(text);
}

/* ---- the room ---- */

void mesh_copy(mesh *to, const mesh *from)
{
    int i;
    memset(to, 0, sizeof *to);
    for (i = 0; i < from->vertices; i++) add_vertex(to, from->v[i].p, from->v[i].n);
    for (i = 0; i < from->triangles; i++)
        add_triangle(to, from->t[i].v[0], from->t[i].v[1], from->t[i].v[2], from->t[i].material);
}

void mesh_place(mesh *m, float turn, vec3 room_for)
{
    const float c = cosf(turn), s = sinf(turn);
    vec3 low = vec(1e30f, 1e30f, 1e30f), high = mul(low, -1), size, at;
    float scale;
    int i;

    for (i = 0; i < m->vertices; i++) {
        const vec3 p = m->v[i].p, n = m->v[i].n;
        m->v[i].p = vec(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
        m->v[i].n = vec(c * n.x - s * n.y, s * n.x + c * n.y, n.z);
        low = lower(low, m->v[i].p);
        high = upper(high, m->v[i].p);
    }
    size = sub(high, low);
    scale = fminf(fminf(room_for.x / fmaxf(size.x, 1e-18f), room_for.y / fmaxf(size.y, 1e-18f)),
                  room_for.z / fmaxf(size.z, 1e-18f));
    if (!(scale < 1e17f)) die("the mesh has no extent");
    at = vec(0.5f * (low.x + high.x), 0.5f * (low.y + high.y), low.z);
    for (i = 0; i < m->vertices; i++) m->v[i].p = mul(sub(m->v[i].p, at), scale);
}

/* nu x nv quads from a corner; the normal is u x v. Floors alternate two materials in unit tiles. */
static void add_sheet(mesh *m, vec3 corner, vec3 u, vec3 v, float step, int kind)
{
    const int nu = (int)ceilf(sqrtf(dot(u, u)) / step), nv = (int)ceilf(sqrtf(dot(v, v)) / step);
    const int first = m->vertices, row = nu + 1;
    const vec3 n = unit(cross(u, v));
    int i, j;

    for (j = 0; j <= nv; j++)
        for (i = 0; i <= nu; i++)
            add_vertex(m, mad(mad(corner, u, (float)i / (float)nu), v, (float)j / (float)nv), n);
    for (j = 0; j < nv; j++)
        for (i = 0; i < nu; i++) {
            const int a = first + j * row + i;
            const vec3 p = m->v[a].p;
            const int odd = ((int)floorf(p.x + 0.5f * step) + (int)floorf(p.y + 0.5f * step)) & 1;
            add_triangle(m, a, a + 1, a + row + 1, kind == WALL ? WALL : odd ? FLOOR_LIGHT : FLOOR_DARK);
            add_triangle(m, a, a + row + 1, a + row, kind == WALL ? WALL : odd ? FLOOR_LIGHT : FLOOR_DARK);
        }
}

void mesh_add_room(mesh *m, vec3 low, vec3 high, float step)
{
    const vec3 x = vec(high.x - low.x, 0, 0), y = vec(0, high.y - low.y, 0), z = vec(0, 0, high.z - low.z);
    add_sheet(m, low, x, y, step, FLOOR_LIGHT);
    add_sheet(m, add(low, y), x, z, 4 * step, WALL);
    add_sheet(m, low, y, z, 4 * step, WALL);
    add_sheet(m, add(add(low, x), y), mul(y, -1), z, 4 * step, WALL);
}
