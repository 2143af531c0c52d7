/* scene.c - what stands where: the mesh, its room, a picture of one sphere per texel, strings of bulbs, the
 * camera. */
#include "relight.h"

#include <stdlib.h>
#include <string.h>

const material materials[MATERIALS] = {
    { {0.62f, 0.60f, 0.56f}, 0.25f, 0.14f },       /* GLAZE */
    { {0.30f, 0.29f, 0.29f}, 0.12f, 0.12f },       /* FLOOR_LIGHT */
    { {0.04f, 0.04f, 0.05f}, 0.12f, 0.12f },       /* FLOOR_DARK */
    { {0.20f, 0.20f, 0.22f}, 0.03f, 0.60f },       /* WALL */
};

static void hang(lights *l, int i, vec3 at, float radius, vec3 radiance)
{
    const int n = l->count;
    const float sphere[4] = { at.x, at.y, at.z, radius }, rgb[3] = { radiance.x, radiance.y, radiance.z };
    int k;
    for (k = 0; k < 4; k++) l->sphere[k * n + i] = sphere[k];
    for (k = 0; k < 3; k++) l->radiance[k * n + i] = rgb[k];
}

static vec3 mix(vec3 a, vec3 b, float t) { return mad(mul(a, 1 - t), b, t); }

/* The picture: the sun going down behind two ranges of hills. u to the right, v up, 0 to 1. */
static vec3 sunset(float u, float v)
{
    const vec3 zenith = vec(0.04f, 0.05f, 0.32f), rose = vec(0.80f, 0.11f, 0.24f), gold = vec(1.6f, 0.55f, 0.06f);
    const float near = 0.15f + 0.09f * sinf(7 * u + 0.6f) + 0.03f * sinf(19 * u);
    const float far = 0.27f + 0.06f * sinf(9 * u + 2.6f) + 0.03f * sinf(23 * u + 1);
    const float x = (u - 0.37f) * 16 / 9, y = v - 0.50f, up = fmaxf(v - 0.25f, 0) / 0.75f;

    if (v < near) return vec(0.02f, 0.05f, 0.10f);
    if (v < far) return mix(vec(0.10f, 0.05f, 0.22f), vec(0.42f, 0.10f, 0.22f), v / far);
    if (x * x + y * y < 0.24f * 0.24f) return vec(4.0f, 2.3f, 0.8f);
    return up < 0.45f ? mix(gold, rose, up / 0.45f) : mix(rose, zenith, (up - 0.45f) / 0.55f);
}

/* Four fifths of the spheres make the picture, the rest six strings of bulbs across the room, warm on the
 * left, cold on the right. The camera sees the last two; the first are footlights, the others hang above its
 * view. All keep about a cell of an 8^3 grid away from floor and walls: nearer ones are to be evaluated
 * directly, at every point. */
static void hang_all(lights *l, int count, vec3 low, vec3 high)
{
    static const struct { float y, z, sag, power; } string[6] = { {-0.16f, 0.06f, 0, 8}, {0.02f, 0.97f, 0.06f, 30},
        {0.12f, 0.97f, 0.06f, 30}, {0.30f, 0.97f, 0.06f, 30}, {0.62f, 0.98f, 0.30f, 4}, {0.70f, 0.93f, 0.10f, 4} };
    static const vec3 hue[5] = { {1.0f, 0.20f, 0.06f}, {1.0f, 0.50f, 0.12f}, {1.0f, 0.62f, 0.45f},
                                 {0.30f, 0.50f, 1.0f}, {0.08f, 0.65f, 0.85f} };
    const int rows = (int)sqrtf((float)count * 0.8f * 9 / 16), columns = rows * 16 / 9;
    const int texels = rows * columns, bulbs = count - texels;
    const vec3 size = sub(high, low);
    const float width = 0.54f * size.x;
    int i;

    l->count = count;
    l->sphere = need(NULL, 4 * (size_t)count, sizeof *l->sphere);
    l->radiance = need(NULL, 3 * (size_t)count, sizeof *l->radiance);
    for (i = 0; i < texels; i++) {
        const float u = ((float)(i % columns) + 0.5f) / (float)columns;
        const float v = ((float)(i / columns) + 0.5f) / (float)rows;
        const vec3 at = vec(0.14f * size.x + u * width, 0.78f * size.y, 0.22f * size.z + v * width * 9 / 16);
        hang(l, i, add(low, at), 0.42f * width / (float)columns, mul(sunset(u, v), 0.6f));
    }
    for (i = 0; i < bulbs; i++) {
        const int s = 5 - i % 6, k = i / 6, on = (bulbs + s) / 6;
        const float t = ((float)k + 0.5f) / (float)on, h = 3.999f * t, sag = string[s].sag * 4 * t * (1 - t);
        const vec3 at = vec(size.x * (0.14f + 0.72f * t), size.y * string[s].y, size.z * (string[s].z - sag));
        hang(l, texels + i, add(low, at), 0.007f * size.x,
             mul(mix(hue[(int)h], hue[(int)h + 1], h - floorf(h)), string[s].power));
    }
}

void scene_build(scene *s, const char *obj, char up, int count, int quick)
{
    static const camera stand = { {-1.8f, -13.6f, 3.5f}, {-0.9f, 0, 2.35f}, 0.80f };

    memset(s, 0, sizeof *s);
    s->low = vec(-7, -5, 0);
    s->high = vec(5, 5, 6.5f);
    s->c = stand;
    if (obj) mesh_read_obj(&s->m, obj, up);
    else mesh_teapot(&s->m, quick ? 8 : 20);
    mesh_place(&s->m, -0.5f, vec(6, 5, 3.2f));
    s->casters = s->m.triangles;
    mesh_add_room(&s->m, s->low, s->high, quick ? 0.5f : 0.125f);
    hang_all(&s->l, count, s->low, s->high);
}

void scene_copy(scene *s, const scene *from)
{
    *s = *from;
    mesh_copy(&s->m, &from->m);
    memset(&s->p, 0, sizeof s->p);
}

void scene_free_copy(scene *s)
{
    free(s->m.v); free(s->m.t); free(s->p.sides); free(s->p.vertex); free(s->p.radiance);
}

/* To be seen, it is cut into triangles across, from its first and last corner on: enough for a triangle or a
 * moon. */
void scene_add_lamp(scene *s, const vec3 *corner, int corners, vec3 radiance)
{
    lamps *p = &s->p;
    const int n = p->count++;
    const float rgb[3] = { radiance.x, radiance.y, radiance.z };
    int i, k;

    p->sides = need(p->sides, (size_t)n + 1, sizeof *p->sides);
    p->vertex = need(p->vertex, 3 * (size_t)(p->corners + corners), sizeof *p->vertex);
    p->radiance = need(p->radiance, 3 * ((size_t)n + 1), sizeof *p->radiance);
    p->sides[n] = corners;
    for (i = 0; i < corners; i++, p->corners++) memcpy(p->vertex + 3 * p->corners, &corner[i], 3 * sizeof(float));
    for (k = 2; k >= 0; k--) {
        memmove(p->radiance + k * (n + 1), p->radiance + k * n, (size_t)n * sizeof(float));
        p->radiance[k * (n + 1) + n] = rgb[k];
    }
    for (i = 0, k = corners - 1; i + 1 < k; i++, k--) {
        mesh_add(&s->m, corner[i], corner[i + 1], corner[k], LAMP + n);
        if (i + 1 < k - 1) mesh_add(&s->m, corner[i + 1], corner[k - 1], corner[k], LAMP + n);
    }
}

/* A concave polygon of 30 sides: two arcs from horn to horn. Dim, because in its plane, where one side gives
 * way to the other, the light of a polygon has a kink that no grid can follow. */
void scene_add_moon(scene *s)
{
    const vec3 middle = vec(2.6f, 2.2f, 4.2f);
    vec3 corner[30];
    int i;

    for (i = 0; i < 16; i++) {
        const float a = 2.2f * ((float)i / 7.5f - 1), x = 0.85f * cosf(a), z = 0.85f * sinf(a);
        corner[i] = add(middle, vec(x, 0, z));
        if (i > 0 && i < 15) corner[30 - i] = add(middle, vec(0.5f * x - 0.25f, 0, 0.85f * z));
    }
    scene_add_lamp(s, corner, 30, vec(0.25f, 0.65f, 0.85f));
}
