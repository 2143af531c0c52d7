/* gl.h - the rooms of the GL example, and what they hand each other.
 *
 *     context.c    an OpenGL 4.5 context without a window, by EGL
 *     stage.c      the relight example's scene as buffers: mesh, shadows, lights, materials    -> stage
 *     programs.c   shader programs
 *     passes.c     buffers; grid, surfaces, occlusion, shading, picture                        -> frame
 *     letters.c    text on the picture
 *     check.c      the grid again by the C headers                                             -> agreement
 *     demo.c       make gl-demo: options, a picture and figures
 *     window.c     the same, live
 *     bench.c      make gl-bench: M22's Tables 2, 3 and 5
 */
#ifndef GL_EXAMPLE_H
#define GL_EXAMPLE_H

#include "../relight/relight.h"

#include <epoxy/gl.h>

extern const char *program_name;                            /* of demo.c and the others, for messages */
enum { MISSING = 77 };                                      /* exit code without a usable OpenGL */

/* context.c ---- 0 without a usable OpenGL, after a message that says what is missing */
int  context_headless(void);
int  context_enough(void);                                  /* whether the current context will do */
void context_close(void);

/* passes.c ---- */
enum { FORWARD, REVERSE, MOMENTS, COEFFICIENTS, EXACT };    /* grid.comp says what they are */
enum { SPHERE_LIGHTS, TRIANGLE_LIGHTS, POLYGON_LIGHTS };  /* spheres, triangles as spheres, exact triangles */
enum { MIN_BANDS = 3, MAX_BANDS = 9, MAX_LIGHTS = 1 << 16 };
typedef struct {
    int bands, lobe_bands, form, kind, scheme;              /* scheme of sh_interp.h, or PER_POINT */
    int nodes[3];
    int shadows, occlusion, samples;                        /* 0 or 1; 0 or 1; pixels per pixel and axis */
    int width, height;                                      /* of the picture */
    float turn, error_scale;                                /* of the mesh; 0 or the heat map's */
} settings;

/* stage.c ---- */
typedef struct { float sphere[4], radiance[4], normal[4], corner[3][4]; } light;    /* as the shaders lay it out */
typedef struct {
    float *vertex;                                          /* [vertices][7]: position, normal, material */
    int *index;                                             /* [vertices]: the same vertex of the mesh */
    float *hidden;                                  /* [hides][81]: trace_blocked's, of the mesh's vertices */
    int vertices, turning, hides;                           /* the first `turning` turn about z */
    int columns, rows, floor;                            /* the floor's tiles, its first vertex of the mesh */
    light *lights;                                          /* [count + moon] */
    int count, moon;                                        /* spheres; exact triangles after them */
    float *moon_corner;                                     /* the polygon they make, [moon_corners][3] */
    int moon_corners;
    vec3 low, high;                                         /* the grid's box */
    camera eye;
} stage;
enum { STAGE_BARE, STAGE_COARSE, STAGE_FULL };              /* BARE: coarse, no moon, no shadows */
void stage_build(stage *s, int count, int how);
void stage_move(const stage *s, int triangles, double time, light *now);   /* where the lights are, as what */
void stage_lobe(int bands, float alpha, float *lobe);        /* the GGX lobe of a roughness, band by band */
void stage_free(stage *s);

/* programs.c ---- files: lists of files, each ended by NULL, of a compute shader or of two shaders that draw */
#define FILES(...) (const char *const *const []){ __VA_ARGS__, NULL }
GLuint program_use(const char *const *const *first, const char *const *const *second, const char *defines, ...);
void   programs_close(void);
void   set1(GLuint p, const char *name, int v);
void   set1f(GLuint p, const char *name, float v);
void   set2(GLuint p, const char *name, float x, float y);
void   set3(GLuint p, const char *name, vec3 v);
void   set3i(GLuint p, const char *name, int x, int y, int z);

/* passes.c ---- */
enum { GRID, SURFACES, OCCLUSION, SHADING, PICTURE, PASSES };
void   passes_open(const stage *s);
void   passes_close(void);
void   passes_lights(const settings *o, const stage *s, const light *now, int few);   /* few: one of a sort */
void   pass_grid(const settings *o, const stage *s);
void   pass_surfaces(const settings *o, const camera *c);
void   pass_occlusion(const settings *o, const camera *c);
void   pass_shading(const settings *o, const stage *s, const camera *c, int as_reference);
void   pass_picture(const settings *o, float exposure);
double passes_ms(int pass);                                 /* of its last run; waits for it */
const char *passes_clock(void);                             /* what timed it */
float  passes_exposure(const settings *o);                  /* from what was shaded last */
float *passes_nodes(const settings *o);                     /* [node][coefficient][channel][4], free it */
float *passes_image(const settings *o, int which);          /* of a pass, [height][width][4], free it */
unsigned char *passes_picture(const settings *o);           /* [height][width][3] from the top, free it */
void   passes_onto_picture(const settings *o);              /* what is drawn next */
void   passes_show(const settings *o, int width, int height);           /* on the window */

/* letters.c ---- */
void letters_open(void);
void letters_close(void);
void letters_draw(const settings *o, float x, float y, float zoom, const char *text);

/* check.c ---- largest difference of the GPU's grid from the C headers in double precision, over nodes,
 * bands, channels and axes, in units of FLT_EPSILON times the node's largest value (gradient) in the band. */
typedef struct { double value, gradient; } agreement;
enum { AGREEMENT_BOUND = 64 };
agreement check_grid(const settings *o, const stage *s, const light *now);

/* The larger of two that are not negative; NaN if either is. */
static inline double worse(double a, double b) { return !(a + b == a + b) ? a + b : a > b ? a : b; }

/* demo.c and window.c ---- */
typedef struct {
    settings o;
    int lights, window, frames, how, error;
    const char *out, *keys;
    double time;
} options;
extern const char *const forms[], *const kinds[], *const scheme_titles[];
enum { SCHEMES = 4, ERROR_SCALE = 40 };
extern const int schemes[SCHEMES];
int  scheme_index(int scheme);
void label(const settings *o, float zoom, const char *text);
void write_png(const char *path, const unsigned char *rgb, int width, int height);
int  window_open(int width, int height);                    /* 0 without one, after a message */
int  window_run(options *a, stage *s);
void window_close(void);

#endif
