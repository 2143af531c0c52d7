/* picture.c - from radiance to a PNG file: glow, exposure, tone curve, labels. */
#include "relight.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#include <stb/stb_easy_font.h>

/* One pass of a Gaussian along x, the result transposed: two passes blur and restore the orientation. */
static void blur(const float *from, float *to, int width, int height, float sigma)
{
    const int reach = (int)(3 * sigma) + 1;
    float *w = need(NULL, (size_t)reach + 1, sizeof *w), sum = 0;
    int i, y;

    for (i = 0; i <= reach; i++) {
        w[i] = expf(-0.5f * (float)(i * i) / (sigma * sigma));
        sum += i ? 2 * w[i] : w[i];
    }
#pragma omp parallel for
    for (y = 0; y < height; y++) {
        int x, k;
        for (x = 0; x < width; x++) {
            float c[3] = { 0, 0, 0 };
            for (k = -reach; k <= reach; k++)
                if (x + k >= 0 && x + k < width) {
                    const float *p = from + 3 * (y * width + x + k), g = w[abs(k)] / sum;
                    c[0] += g * p[0]; c[1] += g * p[1]; c[2] += g * p[2];
                }
            memcpy(to + 3 * (x * height + y), c, sizeof c);
        }
    }
    free(w);
}

void picture_glow(view *w)
{
    static const float sigma[3] = { 0.002f, 0.008f, 0.03f }, share[3] = { 0.12f, 0.06f, 0.04f };
    const size_t values = 3 * (size_t)w->width * (size_t)w->height;
    float *a = need(NULL, values, sizeof *a), *b = need(NULL, values, sizeof *b);
    float *sum = need(NULL, values, sizeof *sum);
    size_t i;
    int k;

    memcpy(sum, w->glow, values * sizeof *sum);
    for (k = 0; k < 3; k++) {
        blur(w->glow, a, w->width, w->height, sigma[k] * (float)w->width);
        blur(a, b, w->height, w->width, sigma[k] * (float)w->width);
        for (i = 0; i < values; i++) sum[i] += share[k] * b[i];
    }
    free(w->glow); free(a); free(b);
    w->glow = sum;
}

/* The exposure that brings the mean luminance of the surfaces to a middle grey. */
float picture_exposure(const view *w, const float *rgb)
{
    double sum = 0, weight = 0;
    int i;
    for (i = 0; i < w->count; i++) {
        const float *c = rgb + 3 * (size_t)i;
        sum += (double)(w->at[i].weight * (0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]));
        weight += (double)w->at[i].weight;
    }
    return sum > 0 ? (float)(0.13 * weight / sum) : 1;
}

static float tone(float x)                    /* Narkowicz 2015, a fit to the ACES curve; then the sRGB one */
{
    const float t = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), y = fminf(fmaxf(t, 0), 1);
    return y <= 0.0031308f ? 12.92f * y : 1.055f * powf(y, 1 / 2.4f) - 0.055f;
}

float *picture_develop(const view *w, const float *rgb, float exposure)
{
    const size_t values = 3 * (size_t)w->width * (size_t)w->height;
    float *out = need(NULL, values, sizeof *out);
    size_t i;
    int k;

    memcpy(out, w->glow, values * sizeof *out);
    for (i = 0; i < (size_t)w->count; i++)
        for (k = 0; k < 3; k++) out[3 * w->at[i].pixel + k] += w->at[i].weight * rgb[3 * i + (size_t)k];
    for (i = 0; i < values; i++) out[i] = tone(exposure * out[i]);
    return out;
}

/* out = zoom |a - b|; the mean of |a - b|. */
double picture_difference(const float *a, const float *b, float zoom, size_t values, float *out)
{
    double sum = 0;
    size_t i;
    for (i = 0; i < values; i++) {
        const float d = fabsf(a[i] - b[i]);
        sum += (double)d;
        out[i] = zoom * d;
    }
    return sum / (double)values;
}

/* ---- sheets: pictures side by side, a label above each ---- */

sheet sheet_new(int width, int height)
{
    sheet s;
    s.width = width;
    s.height = height;
    s.rgb = need(NULL, 3 * (size_t)width * (size_t)height, 1);
    return s;
}

/* The mean of shrink x shrink pixels each. */
void sheet_paste(sheet *s, int left, int top, const float *picture, int width, int height, int shrink)
{
    int x, y, k, i;
    for (y = 0; y < height / shrink; y++)
        for (x = 0; x < width / shrink; x++)
            for (k = 0; k < 3; k++) {
                float sum = 0;
                for (i = 0; i < shrink * shrink; i++)
                    sum += picture[3 * ((y * shrink + i / shrink) * width + x * shrink + i % shrink) + k];
                s->rgb[3 * ((top + y) * s->width + left + x) + k] =
                    (unsigned char)(255 * fminf(sum / (float)(shrink * shrink), 1) + 0.5f);
            }
}

/* A line of white text, as large as fits into width x LABEL pixels. */
void sheet_label(sheet *s, int left, int top, int width, const char *text)
{
    struct { float x, y, z; unsigned char colour[4]; } quad[1024][4];
    char line[256];
    int quads, size, q, x, y;

    snprintf(line, sizeof line, "%s", text);
    size = stb_easy_font_width(line) * 2 + 8 <= width ? 2 : 1;
    quads = stb_easy_font_print(0, 0, line, NULL, quad, sizeof quad);
    for (q = 0; q < quads; q++)
        for (y = (int)quad[q][0].y * size; y < (int)quad[q][2].y * size; y++)
            for (x = 4 + (int)quad[q][0].x * size; x < 4 + (int)quad[q][2].x * size; x++)
                if (x < width && y < LABEL - 4) memset(s->rgb + 3 * ((top + 4 + y) * s->width + left + x), 255, 3);
}

void sheet_write(sheet *s, const char *path)
{
    if (!stbi_write_png(path, s->width, s->height, 3, s->rgb, 3 * s->width)) die("cannot write %s", path);
    free(s->rgb);
}
