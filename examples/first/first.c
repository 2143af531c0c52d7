/* first.c - what a sphere of light sends to a point, and how it changes when the point moves. */
#include "sh_gradient.h"
#include <stdio.h>

int main(void)
{
    const float point[3] = { 0, 0, 0 }, center[3] = { 1, 2, 2 }, radius = 0.5f;
    float coeffs[4], grad[3][4];    /* 2 bands: N = 4 coefficients; a plane of N each for d/dx, d/dy, d/dz */
    const int status = sh_sphere_f32(2, point, center, radius, coeffs, grad[0]);
    int i;
    if (status < 0) return puts(sh_status_string(status)), 1;
    for (i = 0; i < 4; i++) printf("%d %9.6f   %9.6f %9.6f %9.6f\n", i, (double)coeffs[i],
                                   (double)grad[0][i], (double)grad[1][i], (double)grad[2][i]);
    return 0;
}
