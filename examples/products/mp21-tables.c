/* mp21-tables: the operation counts (Fig. 2) and errors (Table 1) of Mezieres and Paulin, Efficient spherical harmonic
 * shading for separable BRDF (2021), by the library's own products.
 *
 * Counts: the products applied to unit vectors show which entries exist. One multiplication, one addition for each entry of a
 * matrix, one multiplication more for an entry of a triple product.
 * Errors: their scenes are not published, so a sphere stands under a ring of spherical lights; the reference integrates each
 * light's disc, cosine and lobe directly, as the paper's reference samples each light. Values are radiance, clamped at 0. */
#include "sh_product.h"
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 9, MOST2 = MOST * MOST };

static int nonzero(const double *v, int n)
{
    int i, count = 0;
    for (i = 0; i < n; i++) count += fabs(v[i]) > 1e-13;
    return count;
}

/* Entries of the triple product whose second factor has only the coefficients that use[] marks. */
static long triple_entries(int bands, const char *use)
{
    const int n = bands * bands;
    static double a[MOST2], b[MOST2], out[MOST2];
    long count = 0;
    int i, j;

    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) {
            if (!use[j]) continue;
            memset(a, 0, sizeof a);
            memset(b, 0, sizeof b);
            a[i] = b[j] = 1;
            sh_triple_product_f64(bands, a, b, out);
            count += nonzero(out, n);
        }
    return count;
}

static long matrix_entries(int bands, int swap)
{
    static const int swap_yz[3] = { 1, 3, 2 };
    const int n = bands * bands;
    static double a[MOST2], out[MOST2];
    long count = 0;
    int i;

    for (i = 0; i < n; i++) {
        memset(a, 0, sizeof a);
        a[i] = 1;
        if (swap) sh_permute_axes_f64(bands, swap_yz, 1, a, out);
        else sh_cosine_product_local_f64(bands, a, out);
        count += nonzero(out, n);
    }
    return count;
}

static int counts(void)
{
    static const long triple_of[4] = { 83, 1158, 6460, 23621 }, clamp_of[4] = { 19, 77, 191, 377 };
    int bands, bad = 0;

    printf("Operations of a product with a clamped cosine (MP21 Fig. 2), entries in brackets\n");
    printf("bands      Eq. 5 [1]          Eq. 10 [2]    Eq. 10, l<3 [3]  Eq. 11 + rotation [4]      Eq. 11 [6]\n");
    for (bands = 2; bands <= MOST; bands++) {
        char all[MOST2], even[MOST2], three[MOST2];
        long triple, zonal, zonal3, clamp, swap, turn, rotated;
        int l, m;

        for (l = 0; l < bands; l++)
            for (m = -l; m <= l; m++) {
                const int i = l * (l + 1) + m;
                all[i] = 1;
                even[i] = l < 2 || l % 2 == 0;          /* the cosine has no odd band above 1 */
                three[i] = l < 3;
            }
        triple = triple_entries(bands, all);
        zonal = triple_entries(bands, even);
        zonal3 = triple_entries(bands, three);
        clamp = matrix_entries(bands, 0);
        swap = matrix_entries(bands, 1);
        turn = bands * (bands - 1) / 2;                 /* pairs (m, -m): 4 multiplications, 2 additions */
        rotated = 2 * clamp + 4 * (2 * swap) + 4 * (6 * turn);
        printf("%5d %9ld (%6ld) %9ld (%6ld) %9ld (%6ld) %12ld (%4ld + 4 x %4ld) %6ld (%4ld)\n", bands, 3 * triple, triple,
               3 * zonal, zonal, 3 * zonal3, zonal3, rotated, clamp, swap, 2 * clamp, clamp);
        if (bands % 2 && (triple != triple_of[(bands - 3) / 2] || clamp != clamp_of[(bands - 3) / 2])) bad = 1;
    }
    if (bad) printf("the entries at 3, 5, 7, 9 bands are not those of the mathematics\n");
    return bad;
}

/* ---- errors ---- */

typedef struct { double to[3], cosine, radiance; } disc;        /* a distant spherical light: axis, half-angle */

static double dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void unit(double *v)
{
    const double s = 1 / sqrt(dot3(v, v));
    v[0] *= s; v[1] *= s; v[2] *= s;
}

/* The lobe the specular term has about its axis, by its 9-band ZH or exactly: a normalised Phong lobe. */
static double lobe(double shininess, double z) { return z > 0 ? (shininess + 1) / 6.283185307179586 * pow(z, shininess) : 0; }

/* Integral over a disc of max(0, n.u) (albedo/pi + gloss lobe(r.u)) by 24 x 48 points. */
static double integrate(const disc *d, const double *n, const double *r, double albedo, double gloss, double shininess)
{
    double x[3] = { 0, 0, 0 }, y[3], sum = 0;
    int i, j, k;

    x[fabs(d->to[0]) < 0.6 ? 0 : 1] = 1;
    for (k = 0, sum = dot3(x, d->to); k < 3; k++) x[k] -= sum * d->to[k];
    unit(x);
    for (k = 0; k < 3; k++) y[k] = d->to[(k + 1) % 3] * x[(k + 2) % 3] - d->to[(k + 2) % 3] * x[(k + 1) % 3];
    for (i = 0, sum = 0; i < 24; i++) {
        const double z = d->cosine + (1 - d->cosine) * (i + 0.5) / 24, s = sqrt(1 - z * z);
        for (j = 0; j < 48; j++) {
            const double f = 6.283185307179586 * (j + 0.5 * (i & 1)) / 48;
            double u[3], c;
            for (k = 0; k < 3; k++) u[k] = z * d->to[k] + s * (cos(f) * x[k] + sin(f) * y[k]);
            c = dot3(n, u);
            if (c > 0) sum += c * (albedo / 3.141592653589793 + gloss * lobe(shininess, dot3(r, u)));
        }
    }
    return sum * d->radiance * 6.283185307179586 * (1 - d->cosine) / (24 * 48);
}

static int errors(void)
{
    static const struct { const char *name; double albedo, gloss, shininess; } look[3] = {
        { "mixed", 0.5, 0.3, 20 }, { "diffuse", 0.8, 0.02, 8 }, { "glossy", 0.2, 0.8, 40 } };
    static const char *const way[4] = { "Eq. 5 (triple product)", "Eq. 10", "Eq. 10, l<3", "Eq. 11 with rotation" };
    static const double paper[4][3] = { { 2.4488, 0.2609, 5.1379 }, { 2.3652, 0.2609, 4.9844 }, { 2.8814, 0.5933, 5.2027 },
                                        { 2.1968, 0.2156, 4.9212 } };
    enum { LIGHTS = 12, NORMALS = 600 };
    disc lights[LIGHTS];
    double light[MOST2] = { 0 }, square[4][3] = { { 0 } }, cosine_zh[MOST], rms[4][3];
    int i, j, k, w, bad = 0;

    for (i = 0; i < LIGHTS; i++) {                      /* three rings, half-angles from 5 to 25 degrees */
        const double f = 2.399963 * i, z = 0.9 - 1.5 * (i + 0.5) / LIGHTS, s = sqrt(1 - z * z);
        double zh[MOST], c[MOST2], half = 0.09 + 0.35 * (i % 4) / 3;
        lights[i].to[0] = s * cos(f); lights[i].to[1] = s * sin(f); lights[i].to[2] = z;
        lights[i].cosine = cos(half);
        lights[i].radiance = 0.25 / (1 - cos(half)) / LIGHTS;
        sh_zonal_cap_f64(MOST, sin(half), zh, NULL);
        sh_zonal_rotate_f64(MOST, zh, lights[i].to, c);
        for (j = 0; j < MOST2; j++) light[j] += lights[i].radiance * c[j];
    }
    sh_zonal_cosine_f64(MOST, cosine_zh);
    for (i = 0; i < NORMALS; i++) {
        const double z = 1 - (2 * i + 1.0) / NORMALS, f = 2.399963229728653 * i, s = sqrt(1 - z * z);
        const double n[3] = { s * cos(f), s * sin(f), z };
        double eye[3] = { 0.3, -2.0, 0.8 }, r[3], t[4][MOST2], turned[MOST2], c;

        unit(eye);
        c = 2 * dot3(n, eye);
        if (c <= 0) continue;                           /* not seen */
        for (k = 0; k < 3; k++) r[k] = c * n[k] - eye[k];
        sh_zonal_rotate_f64(MOST, cosine_zh, n, turned);
        sh_triple_product_f64(MOST, light, turned, t[0]);
        sh_cosine_product_zonal_f64(MOST, MOST, n, light, t[1]);
        sh_cosine_product_zonal_f64(MOST, 3, n, light, t[2]);
        sh_cosine_product_f64(MOST, n, light, t[3]);
        for (k = 0; k < 3; k++) {
            double want = 0, zh[MOST], m[MOST2];
            for (j = 0; j < LIGHTS; j++) want += integrate(&lights[j], n, r, look[k].albedo, look[k].gloss, look[k].shininess);
            sh_zonal_phong_f64(MOST, look[k].shininess, zh);
            sh_zonal_rotate_f64(MOST, zh, r, m);
            for (w = 0; w < 4; w++) {
                double diffuse, specular = 0, got;
                sh_diffuse_from_product_f64(t[w], &diffuse);
                for (j = 0; j < MOST2; j++) specular += t[w][j] * m[j];
                got = fmax(0, look[k].albedo / 3.141592653589793 * diffuse + look[k].gloss * specular);
                square[w][k] += (got - want) * (got - want) / NORMALS;
            }
        }
    }
    printf("\nRMSE x 100 of the shading (MP21 Table 1 in brackets; their scenes, so only the order compares)\n%-24s", "");
    for (k = 0; k < 3; k++) printf("%10s         ", look[k].name);
    printf("\n");
    for (w = 0; w < 4; w++) {
        printf("%-24s", way[w]);
        for (k = 0; k < 3; k++) {
            rms[w][k] = 100 * sqrt(square[w][k]);
            printf("%10.4f (%6.4f)", rms[w][k], paper[w][k]);
        }
        printf("\n");
    }
    for (k = 0; k < 3; k++)
        for (w = 0; w < 3; w++) if (!(rms[3][k] <= rms[w][k])) bad = 1;
    printf(bad ? "Eq. 11 is NOT the most accurate\n" : "Eq. 11 is the most accurate in all three, as in the paper\n");
    return bad;
}

int main(void)
{
    const int bad = counts();
    return errors() | bad;
}
