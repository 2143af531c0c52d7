/* gl.h - the rooms of the GL example, and what they hand each other.
 *
 *     context.c   an OpenGL 4.5 context without a window, by EGL
 *     stage.c     the relight example's scene as buffers: mesh, lights, materials      -> stage
 *     passes.c    shaders and buffers; grid, surfaces, occlusion, shading, picture     -> frame
 *     check.c     the same by the C headers                                             -> agreement
 *     demo.c      make gl-demo: a picture and figures; or, by GLFW, a window
 *     bench.c     make gl-bench: M22's Tables 2, 3 and 5
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

/* stage.c ---- */
typedef struct { float sphere[4], radiance[4], normal[4], corner[3][4]; } light;    /* as the shaders lay it out */
typedef struct {
    float *vertex;                                          /* [vertices][7]: position, normal, material */
    int vertices, turning;                                  /* the first ones turn about z */
    light *lights;
    int count;
    vec3 low, high;                                         /* the grid's box */
    camera eye;
} stage;
void stage_build(stage *s, int count, int quick);
void stage_move(const stage *s, int triangles, double time, light *now);    /* where the lights are, as what */
void stage_lobe(int bands, float alpha, float *lobe);        /* the GGX lobe of a roughness, band by band */
void stage_free(stage *s);

/* passes.c ---- */
enum { FORWARD, REVERSE, MOMENTS, LOBES };                  /* grid.comp says what they are */
enum { SPHERE_LIGHTS, TRIANGLE_LIGHTS, POLYGON_LIGHTS };    /* spheres, triangles as spheres, exact triangles */
enum { MIN_BANDS = 3, MAX_BANDS = 9, MAX_LIGHTS = 1 << 16 };
typedef struct {
    int bands, lobe_bands, form, kind, scheme;              /* scheme of sh_interp.h, or PER_POINT */
    int nodes[3], lanes;
    int occlusion, samples;                                 /* 0 or 1; pixels per pixel and axis */
    int width, height;                                      /* of the picture */
    float turn, error_scale;                                /* of the mesh; 0 or the heat map's */
} settings;
enum { GRID, SURFACES, OCCLUSION, SHADING, PICTURE, PASSES };
typedef struct { double ms[PASSES]; float exposure; } frame;

void   passes_open(const stage *s);
void   passes_close(void);
void   passes_lights(const light *now, int count);
void   pass_grid(const settings *o, const stage *s);
void   pass_surfaces(const settings *o, const camera *c);
void   pass_occlusion(const settings *o, const camera *c);
void   pass_shading(const settings *o, const stage *s, const camera *c, int as_reference);
void   pass_picture(const settings *o, float exposure);
double passes_ms(int pass);                                 /* of its last run; waits for it */
const char *passes_clock(void);                             /* what timed it */
float  passes_exposure(const settings *o);                  /* from what was shaded last */
float *passes_nodes(const settings *o);                     /* [node][coefficient][channel][4], free it */
float *passes_image(const settings *o, int which);          /* SURFACES: places; GRID: normals; SHADING: radiance */
unsigned char *passes_picture(const settings *o);           /* [height][width][3] from the top, free it */
void   passes_show(const settings *o, int width, int height);           /* on the window */
void   passes_text(const settings *o, float x, float y, float zoom, const char *text);

/* The larger of two that are not negative; NaN if either is. */
static inline double worse(double a, double b) { return !(a + b == a + b) ? a + b : a > b ? a : b; }

/* check.c ---- largest difference of the GPU's grid from the C headers in double precision, over nodes, bands, channels
 * and axes, in units of FLT_EPSILON times the node's largest value (gradient) in the band. */
typedef struct { double value, gradient; } agreement;
enum { AGREEMENT_BOUND = 64 };
agreement check_grid(const settings *o, const stage *s, const light *now);

#endif
