/* lights.h - what the suites `lights` and `grid` and their baseline share. */
#ifndef BENCH_LIGHTS_H
#define BENCH_LIGHTS_H

#include "bench.h"

typedef struct lights_scene {
    size_t count;
    const real *spheres;        /* [4][count]: x, y, z, radius */
    const real *radiance;       /* [count] */
} lights_scene;

/* M22 as printed, one light after the other: [planes][n^2] overwritten with the sum. As scalar code, and (auto) with
 * the compiler's vectoriser. planes 1, 4 or 10; bands 5..9. */
void FN(per_light)(int bands, int planes, const real point[3], const lights_scene *scene, real *out);
void FN(per_light_auto)(int bands, int planes, const real point[3], const lights_scene *scene, real *out);

#endif
