/* shading-paths: the four ways of MP21 Fig. 3 to shade a point from spherical-harmonics light, on one scene, against direct
 * integration. A light L, a visibility V (an SH vector), a clamped cosine and a glossy lobe M:
 *
 *   irradiance map   D = cosine * L at n,  S = M * L at r        two convolutions, per light; no visibility, no cosine in S
 *   cosine product   T = cosine x L,       D = 2 sqrt(pi) T_00   one product per point; no visibility
 *   transfer (PRT)   T = L x (cosine x V), the bracket baked     one triple product per point, or for D alone a dot product
 *   general          T = (cosine x L) x V                        everything dynamic: both products per point
 *
 * S = T . M, M the lobe's ZH turned to the mirror direction r. The first two are compared with the light unoccluded. */
#include "sh_product.h"
#include <stdio.h>
#include <stdlib.h>

enum { BANDS = 9, N = BANDS * BANDS };

static const float to_light[3] = { 0.48f, -0.36f, 0.8f }, to_blocker[3] = { 0.0f, -0.6f, 0.8f };
static const float light_half = 0.5f, blocker_half = 0.35f, shininess = 12.0f;

static float dot(int n, const float *a, const float *b)
{
    double s = 0;
    int i;
    for (i = 0; i < n; i++) s += (double)a[i] * (double)b[i];
    return (float)s;
}

/* Integral over the sphere by rings: visible light x cosine x (1, lobe), and the lobe without the cosine. */
static void reference(const float n[3], const float r[3], int blocked, double *diffuse, double *specular, double *bare)
{
    enum { RINGS = 1000, SPOKES = 2000 };
    int i, j;

    *diffuse = *specular = *bare = 0;
    for (i = 0; i < RINGS; i++)
        for (j = 0; j < SPOKES; j++) {
            const double z = 1 - (2 * i + 1.0) / RINGS, s = sqrt(1 - z * z), f = 6.283185307179586 * (j + 0.5) / SPOKES;
            const float u[3] = { (float)(s * cos(f)), (float)(s * sin(f)), (float)z };
            const double c = (double)dot(3, n, u), m = (double)dot(3, r, u);
            double w = 12.566370614359172 / RINGS / SPOKES, lobe;
            if ((double)dot(3, to_light, u) < cos((double)light_half)) continue;
            if (blocked && (double)dot(3, to_blocker, u) > cos((double)blocker_half)) continue;
            lobe = m > 0 ? ((double)shininess + 1) / 6.283185307179586 * pow(m, (double)shininess) : 0;
            *bare += w * lobe;
            if (c > 0) { *diffuse += w * c; *specular += w * c * lobe; }
        }
}

static int line(const char *name, float d, double want_d, float s, double want_s)
{
    const double ed = fabs((double)d - want_d), es = fabs((double)s - want_s);
    printf("%-26s diffuse %7.4f (error %7.4f)   specular %7.4f (error %7.4f)\n", name, (double)d, ed, (double)s, es);
    return !(ed <= 0.03 && es <= 0.03);
}

int main(void)
{
    float zh[BANDS], light[N], visibility[N], lobe[N], convolved[N], t[N], baked[N], d, s;
    float n[3] = { 0.2f, -0.1f, 1.0f }, eye[3] = { -0.5f, 0.3f, 0.9f }, r[3], c;
    double want_d, want_s, want_bare, open_d, open_s;
    int i, bad = 0;

    c = 1 / sqrtf(dot(3, n, n));
    for (i = 0; i < 3; i++) n[i] *= c;
    c = 1 / sqrtf(dot(3, eye, eye));
    for (i = 0; i < 3; i++) eye[i] *= c;
    c = 2 * dot(3, n, eye);
    for (i = 0; i < 3; i++) r[i] = c * n[i] - eye[i];

    sh_zonal_cap_f32(BANDS, sinf(light_half), zh, NULL);                /* the light: a disc of radiance 1 */
    sh_zonal_rotate_f32(BANDS, zh, to_light, light);
    sh_zonal_cap_f32(BANDS, sinf(blocker_half), zh, NULL);              /* visibility: 1 outside of another disc */
    sh_zonal_rotate_f32(BANDS, zh, to_blocker, visibility);
    for (i = 0; i < N; i++) visibility[i] = (i == 0 ? 3.5449077f : 0.0f) - visibility[i];
    sh_zonal_phong_f32(BANDS, shininess, zh);
    sh_zonal_rotate_f32(BANDS, zh, r, lobe);

    reference(n, r, 0, &open_d, &open_s, &want_bare);
    printf("without visibility (direct integration: diffuse %.4f, specular %.4f)\n", open_d, open_s);
    sh_diffuse_f32(BANDS, light, n, &d);                                /* irradiance map */
    sh_convolve_f32(BANDS, zh, light, convolved);
    sh_reconstruct_f32(BANDS, convolved, r, &s, NULL);
    bad |= line("  irradiance map", d, open_d, s, want_bare);
    sh_cosine_product_f32(BANDS, n, light, t);                          /* cosine product */
    sh_diffuse_from_product_f32(t, &d);
    bad |= line("  cosine product", d, open_d, dot(N, t, lobe), open_s);

    reference(n, r, 1, &want_d, &want_s, &want_bare);
    printf("with visibility (direct integration: diffuse %.4f, specular %.4f)\n", want_d, want_s);
    sh_cosine_product_f32(BANDS, n, visibility, baked);                 /* transfer: baked per vertex */
    sh_triple_product_f32(BANDS, light, baked, t);
    bad |= line("  transfer (PRT)", dot(N, light, baked), want_d, dot(N, t, lobe), want_s);
    sh_cosine_product_f32(BANDS, n, light, t);                          /* general */
    sh_triple_product_f32(BANDS, t, visibility, t);
    sh_diffuse_from_product_f32(t, &d);
    bad |= line("  general", d, want_d, dot(N, t, lobe), want_s);
    if (bad) printf("an error is larger than 9 bands should leave\n");
    return bad;
}
