/* stream.c - suite `stream`: the basis at 5 bands written to arrays that fit L2 and that fit no cache, beside the
 * fused calls that store nothing. Large arrays cost what memory costs, whoever computes. */
#include "sh_gradient.h"     /* first: names of ours must not reach it */

#include "bench.h"

#include <math.h>
#include <string.h>

#include "sloan.h"

enum { BANDS = 5, N2 = BANDS * BANDS };

typedef struct stream_input {
    size_t count;
    const real *dirs, *blocks, *weights, *coeffs;
    real *y, *grad;
} stream_input;

#define STREAM(name, body)                              \
    static void name(const bench_case *self)            \
    {                                                   \
        const stream_input *in = self->input;           \
        body                                            \
    }

STREAM(values_sloan, size_t i;
       for (i = 0; i < in->count; i++) sloan_values(BANDS, in->dirs + 3 * i, in->y + N2 * i);)
STREAM(values_n, FN(sh_eval_n)(BANDS, in->count, in->dirs, in->y);)
STREAM(values_blocks, FN(sh_eval_blocks)(BANDS, in->count / SH_BLOCK, in->blocks, in->y);)
STREAM(gradient_n, FN(sh_eval_grad_n)(BANDS, in->count, in->dirs, in->y, in->grad);)
STREAM(gradient_blocks, FN(sh_eval_grad_blocks)(BANDS, in->count / SH_BLOCK, in->blocks, in->y, in->grad);)
STREAM(reconstruct, FN(sh_reconstruct_n)(BANDS, in->coeffs, in->count, in->dirs, in->y, NULL);)
STREAM(reconstruct_grad, FN(sh_reconstruct_n)(BANDS, in->coeffs, in->count, in->dirs, in->y, in->grad);)
STREAM(project, FN(sh_project_n)(BANDS, in->count, in->dirs, in->weights, in->y);)

static void add(const stream_input *in, const char *kernel, const char *impl, void (*run)(const bench_case *),
                size_t numbers, size_t gradient_numbers)
{
    bench_case c;
    memset(&c, 0, sizeof c);
    c.kernel = kernel;
    c.impl = impl;
    c.bands = BANDS;
    c.column = (int)in->count;
    c.items = in->count;
    c.run = run;
    c.input = in;
    c.held = numbers ? in->count : 1;
    c.lanes = strcmp(impl, "library_blocks") ? 1 : SH_BLOCK;
    c.tolerance = 400 * REAL_EPS;
    c.out[0].data = in->y;
    c.out[0].numbers = numbers ? numbers : N2;
    c.out[1].data = gradient_numbers ? in->grad : NULL;
    c.out[1].numbers = gradient_numbers;
    c.bytes = numbers >= N2 ? (double)((numbers + gradient_numbers) * sizeof(real)) : 0;
    bench_add(&c);
}

void FN(bench_stream)(void)
{
    static const size_t counts[] = { 1024, 262144 };
    unsigned k;
    bench_suite("stream", BENCH_PRECISION, "direction", "5 bands written to an array, by its directions (columns)");
    bench_base("values", "sloan");
    bench_base("gradient", "library_n");
    for (k = 0; k < sizeof counts / sizeof counts[0]; k++) {
        stream_input *in = bench_alloc(1, sizeof *in);
        const size_t count = bench_option.check_only ? 64 : counts[k];
        real *dirs = bench_alloc(3 * count, sizeof(real)), *blocks = bench_alloc(3 * count, sizeof(real));
        real *weights = bench_alloc(count, sizeof(real)), *coeffs = bench_alloc(N2, sizeof(real));
        size_t i, a;
        for (i = 0; i < count; i++) {
            const double z = 2 * bench_random() - 1, r = sqrt(1 - z * z), p = 6.283185307179586 * bench_random();
            const double u[3] = { r * cos(p), r * sin(p), z };
            for (a = 0; a < 3; a++) blocks[(i / SH_BLOCK * 3 + a) * SH_BLOCK + i % SH_BLOCK] = dirs[3 * i + a] = C(u[a]);
            weights[i] = C(bench_random());
        }
        for (i = 0; i < N2; i++) coeffs[i] = C(2 * bench_random() - 1);
        in->count = count;
        in->dirs = dirs;
        in->blocks = blocks;
        in->weights = weights;
        in->coeffs = coeffs;
        in->y = bench_alloc(N2 * count, sizeof(real));
        in->grad = bench_alloc(3 * N2 * count, sizeof(real));
        add(in, "values", "library_n", values_n, N2, 0);
        add(in, "values", "library_blocks", values_blocks, N2, 0);
        add(in, "values", "sloan", values_sloan, N2, 0);
        add(in, "gradient", "library_n", gradient_n, N2, 3 * N2);
        add(in, "gradient", "library_blocks", gradient_blocks, N2, 3 * N2);
        add(in, "reconstruct", "library", reconstruct, 1, 0);
        add(in, "reconstruct_gradient", "library", reconstruct_grad, 1, 3);
        add(in, "project", "library", project, 0, 0);
        if (bench_option.check_only) break;
    }
    bench_run();
}
