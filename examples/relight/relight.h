/* relight.h - the rooms of the relight example, and what they hand each other.
 *
 *     mesh.c      triangle meshes: the teapot, OBJ files, the room           -> mesh
 *     scene.c     materials, lights, camera: what stands where               -> scene
 *     trace.c     a bounding volume hierarchy and rays through it            -> view, blocked
 *     shade.c     grids of coefficients, reconstruction, shading             -> method.rgb
 *     lamps.c     triangle lights: exact, and each as a sphere
 *     picture.c   exposure, glow, tone curve, labels, PNG files
 *     relight.c   options, the order of work, the table
 */
#ifndef RELIGHT_H
#define RELIGHT_H

#include <math.h>
#include <stddef.h>

typedef struct { float x, y, z; } vec3;

static inline vec3 vec(float x, float y, float z) { vec3 v; v.x = x; v.y = y; v.z = z; return v; }
static inline vec3 add(vec3 a, vec3 b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline vec3 sub(vec3 a, vec3 b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline vec3 mul(vec3 a, float s) { return vec(a.x * s, a.y * s, a.z * s); }
static inline vec3 mad(vec3 a, vec3 b, float s) { return add(a, mul(b, s)); }
static inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline vec3 cross(vec3 a, vec3 b)
{
    return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline vec3 unit(vec3 a)
{
    const float d = dot(a, a);
    return d > 0.0f ? mul(a, 1.0f / sqrtf(d)) : vec(0, 0, 1);
}
static inline vec3 lower(vec3 a, vec3 b) { return vec(fminf(a.x, b.x), fminf(a.y, b.y), fminf(a.z, b.z)); }
static inline vec3 upper(vec3 a, vec3 b) { return vec(fmaxf(a.x, b.x), fmaxf(a.y, b.y), fmaxf(a.z, b.z)); }

/* relight.c: a message and exit code 2; the same for a bad status or no memory; a line where a person looks */
#if defined(__GNUC__)
__attribute__((__noreturn__, __format__(__printf__, 1, 2)))
#endif
void  die(const char *format, ...);
void  check(int status);
void *need(void *old, size_t count, size_t size);
void  progress(const char *what, double done);

/* mesh.c ---- z is up */
typedef struct { vec3 p, n; } vertex;
typedef struct { int v[3], material; } triangle;
typedef struct { vertex *v; triangle *t; int vertices, triangles; } mesh;
enum { GLAZE, FLOOR_LIGHT, FLOOR_DARK, WALL, MATERIALS, LAMP = MATERIALS };    /* LAMP + i: polygon light i */

void mesh_teapot(mesh *m, int steps);                      /* Newell's 32 patches, steps x steps quads each */
void mesh_read_obj(mesh *m, const char *path, char up);
void mesh_add(mesh *m, vec3 a, vec3 b, vec3 c, int kind);
void mesh_copy(mesh *to, const mesh *from);
void mesh_place(mesh *m, float turn, vec3 room_for);        /* turn about z, fit into a box, stand on z = 0 */
void mesh_add_room(mesh *m, vec3 low, vec3 high, float step);

/* scene.c */
typedef struct { float albedo[3], f0, alpha; } material;
typedef struct { float *sphere /* [4][count] x y z r */, *radiance /* [3][count] */; int count; } lights;
typedef struct { int count, corners, *sides; float *vertex /* [corners][3] */, *radiance /* [3][count] */; } lamps;
typedef struct { vec3 eye, at; float width /* of the view at distance 1 */; } camera;
typedef struct {
    mesh m;
    int casters;                                             /* its first triangles, which cast shadows */
    lights l;
    lamps p;                                                /* polygon lights, in the mesh, too, to be seen */
    camera c;
    vec3 low, high;                                          /* the room, and what a grid covers */
} scene;
extern const material materials[MATERIALS];
void scene_build(scene *s, const char *obj /* or NULL: the teapot */, char up, int lights, int quick);
void scene_copy(scene *s, const scene *from);             /* all but its polygon lights; shares the spheres */
void scene_add_lamp(scene *s, const vec3 *corner, int corners, vec3 radiance);
void scene_add_moon(scene *s);
void scene_free_copy(scene *s);

/* trace.c */
typedef struct {                                             /* a place to shade, and its share of a pixel */
    vec3 p, n, out;                                          /* position, normal, direction to the eye */
    float u, v, weight;
    int pixel, triangle, material;
} spot;
typedef struct {
    int width, height, count;
    spot *at;                                                /* [count], pixels in order */
    float *glow;                                             /* [width*height][3] the lights seen directly */
} view;
void view_trace(view *w, const scene *s, int width, int height);

/* blocked[vertex][n2]: what the casters hide of the clamped cosine at each vertex */
float *trace_blocked(const scene *s, int bands, int rays);

/* shade.c */
enum { BANDS = 9, PER_POINT = -1 };                         /* the shadows' bands; a scheme: no grid at all */
typedef struct {
    const char *name;
    int scheme, nodes, planes, as_spheres;             /* of sh_interp.h; along each axis; lamps as spheres */
    double build, shade, error;                              /* seconds, seconds, mean absolute error */
    float *rgb;                                              /* [points][3] */
} method;
void shade(const scene *s, const view *w, const float *blocked, int bands, method *at, int methods);

/* lamps.c */
void lamps_compare(const scene *room, const float *blocked, int bands, int nodes, int pieces, int width, int height,
                   const char *path);

/* picture.c */
enum { LABEL = 24 };                                         /* pixels */
typedef struct { int width, height; unsigned char *rgb; } sheet;
void   picture_glow(view *w);
float  picture_exposure(const view *w, const float *rgb);
float *picture_develop(const view *w, const float *rgb, float exposure);     /* [pixels][3], 0 to 1, sRGB */
double picture_difference(const float *a, const float *b, float zoom, size_t values, float *out);     /* the mean */
sheet  sheet_new(int width, int height);
void   sheet_paste(sheet *s, int left, int top, const float *picture, int width, int height, int shrink);
void   sheet_label(sheet *s, int left, int top, int width, const char *text);
void   sheet_write(sheet *s, const char *path);

#endif
