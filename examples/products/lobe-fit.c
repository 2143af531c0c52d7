/* lobe-fit: how well a band-limited zonal GGX lobe stands for GGX, as relative L2 distance over the sphere.
 *
 *   cut       what the bands leave out of sh_zonal_ggx's own lobe (by Parseval, exact)
 *   view      distance of that lobe, uncut and turned to the mirror direction, from the density of reflected directions
 *             D(h) (n.h) / (4 v.h) at a view angle: at 0 it is the lobe itself, beyond that GGX stretches and the zonal lobe
 *             does not */
#include "sh_product.h"
#include <stdio.h>

static double ggx(double a2, double cosine)
{
    const double d = cosine * cosine * (a2 - 1) + 1;
    return cosine > 0 ? a2 / (3.141592653589793 * d * d) : 0;
}

static double view_distance(double alpha, double degrees)
{
    enum { RINGS = 1500, SPOKES = 600 };
    const double a2 = alpha * alpha, t = degrees * 0.017453292519943295, v[3] = { sin(t), 0, cos(t) }, r[3] = { -v[0], 0, v[2] };
    double gap = 0, all = 0;
    int i, j;

    for (i = 0; i < RINGS; i++) {                   /* rings about r, denser towards it */
        const double e = (i + 0.5) / RINGS, z = 1 - 2 * e * e * e, w = 6 * e * e / RINGS, s = sqrt((1 - z) * (1 + z));
        for (j = 0; j < SPOKES; j++) {
            const double f = 6.283185307179586 * (j + 0.5) / SPOKES, x = s * cos(f), y = s * sin(f);
            const double u[3] = { z * r[0] + x * r[2], y, z * r[2] - x * r[0] };
            const double h[3] = { u[0] + v[0], u[1], u[2] + v[2] }, size = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
            const double vh = (v[0] * h[0] + v[2] * h[2]) / size, nh = h[2] / size;
            const double p = size > 1e-12 ? ggx(a2, nh) * nh / (4 * vh) : 0, q = ggx(a2, sqrt((1 + z) / 2)) / 4;
            gap += w * (p - q) * (p - q);
            all += w * p * p;
        }
    }
    return sqrt(gap / all);
}

int main(void)
{
    static const double alphas[] = { 0.1, 0.2, 0.3, 0.5, 0.7, 1.0 };
    static const int cuts[] = { 3, 5, 9, 16 };
    static const double views[] = { 0, 20, 40, 60 };
    int i, k, l, bad = 0;

    printf("alpha    cut to 3      5      9     16 bands      view 0     20     40     60 degrees\n");
    for (i = 0; i < 6; i++) {
        const double a2 = alphas[i] * alphas[i];
        double zh[SH_MAX_BANDS], all = 0, kept;
        /* integral of the squared lobe: 2 pi times that of a2^2 / (pi^2 ((1 + a2) - (1 - a2) z)^4) */
        if (alphas[i] < 1) all = 2 * a2 * a2 / (3 * 3.141592653589793 * (1 - a2)) * (1 / pow(2 * a2, 3) - 1 / 8.0);
        else all = 1 / 12.566370614359172;
        sh_zonal_ggx_f64(SH_MAX_BANDS, alphas[i], zh);
        printf("%5.2f        ", alphas[i]);
        for (k = 0, l = 0, kept = 0; k < 4; k++) {
            for (; l < cuts[k]; l++) kept += zh[l] * zh[l];
            printf(" %6.4f", sqrt(fmax(0, 1 - kept / all)));
            if (!(kept <= all * (1 + 1e-12))) bad = 1;
        }
        printf("               ");
        for (k = 0; k < 4; k++) printf(" %6.3f", view_distance(alphas[i], views[k]));
        printf("\n");
        if (!(view_distance(alphas[i], 0) < 1e-6)) bad = 1;
    }
    if (bad) printf("the lobe is not GGX at normal incidence\n");
    return bad;
}
