/* polygon_map.c - where each polygon call fails: relative error over size/distance and angle, for
 * bench/polygon_map.sh.
 *
 *     polygon_map SHAPE CALL      SHAPE triangle or needle; CALL 0 sh_polygon, 1 sh_polygons_n, 2
 *                                 sh_polygons_zonal_n, 3 sh_triangle_as_sphere
 *
 * Prints log10(size/distance), log10(sine of the angle to the plane), log10 |float - exact| / |exact| over
 * all coefficients of 9 bands. Exact is sh_polygon_f64 of the same numbers. */
#include "sh_polygon.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BANDS = 9, SIZE = BANDS * BANDS, COLUMNS = 128, ROWS = 96, TURNS = 3 };

/* norm of the error over the norm; the worst of a few azimuths, so that the map does not speckle */
static double error_at(const double *shape, int call, double ratio, double sine)
{
    const double scale = ratio < 0.1 ? ratio : 1,
                 distance = ratio < 0.1 ? 1 : 1 / ratio; /* floats far from 0 */
    double worst = 0;
    int turn, i;
    for (turn = 0; turn < TURNS; turn++) {
        const double azimuth = 0.7 + 2.1 * turn, side = distance * sqrt(1 - sine * sine);
        const int count = 3;
        double exact[SIZE], x[3], w[9], sum = 0, norm = 0;
        volatile float p0, v0;      /* gcc 12 drops the rounding of a (double)(float) chain it vectorises */
        float p[3], v[9], got[SIZE];
        p[0] = (float)(side * cos(azimuth));
        p[1] = (float)(side * sin(azimuth));
        p[2] = (float)(distance * sine);
        for (i = 0; i < 9; i++) {
            v[i] = v0 = (float)(scale * shape[i]);
            w[i] = (double)v0;
        }
        for (i = 0; i < 3; i++) {
            p0 = p[i];
            x[i] = (double)p0;
        }
        sh_polygon_f64(BANDS, SH_BOTH, x, 3, w, exact, NULL);
        if (call == 0) sh_polygon_f32(BANDS, SH_BOTH, p, 3, v, got, NULL);
        if (call == 1) sh_polygons_n_f32(BANDS, SH_VALUES, 1, SH_BOTH, 1, p, 1, &count, v, NULL, got);
        if (call == 2) sh_polygons_zonal_n_f32(BANDS, SH_VALUES, 1, SH_BOTH, 1, p, 1, &count, v, NULL, got);
        if (call == 3) sh_triangle_as_sphere_f32(BANDS, SH_BOTH, p, v, v + 3, v + 6, got, NULL, NULL);
        for (i = 0; i < SIZE; i++) {
            sum += ((double)got[i] - exact[i]) * ((double)got[i] - exact[i]);
            norm += exact[i] * exact[i];
        }
        if (!(sum <= worst * worst * norm)) worst = sqrt(sum / norm);
    }
    return worst;
}

int main(int argc, char **argv)
{
    static const double triangle[9] = { -0.52, -0.31, 0, 0.49, -0.23, 0, 0.04, 0.55, 0 };
    static const double needle[9] = { -0.5, -0.02, 0, 0.5, 0.02, 0, 0.5, 0.021, 0 };
    int row, column;
    if (argc != 3 || (strcmp(argv[1], "triangle") && strcmp(argv[1], "needle"))) {
        fprintf(stderr, "usage: polygon_map triangle|needle 0|1|2|3\n");
        return 2;
    }
    for (row = 0; row < ROWS; row++) {
        for (column = 0; column < COLUMNS; column++) {
            const double ratio = 1 - 7.0 * column / (COLUMNS - 1), sine = -6.0 * row / (ROWS - 1);
            const double e = error_at(argv[1][0] == 'n' ? needle : triangle, atoi(argv[2]), pow(10, ratio),
                                      pow(10, sine));
            printf("%g %g %g\n", ratio, sine, log10(e > 1e-9 ? e : 1e-9));
        }
        printf("\n");
    }
    return 0;
}
