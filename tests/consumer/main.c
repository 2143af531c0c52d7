/* What somebody writes who installed shlight: found through CMake or pkg-config, from a folder of its own. */
#include "sh_gradient.h"
#include "sh_interp.h"
#include "sh_polygon.h"
#include "sh_product.h"
#include <stdio.h>

int main(void)
{
    const float point[3] = { 0, 0, 0 }, center[3] = { 0, 0, 2 };
    float c[9], irradiance;
    if (sh_sphere_f32(3, point, center, 0.5f, c, NULL) || sh_diffuse_f32(3, c, center, &irradiance)) return 1;
    printf("%d.%d.%d\n", SH_VERSION_MAJOR, SH_VERSION_MINOR, SH_VERSION_PATCH);
    return !(c[0] > 0.05f && c[0] < 0.06f);
}
