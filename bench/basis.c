/* basis.c - suite `basis`: values, derivatives, reconstruction and projection (what M22 Table 1 compares). */
#include "sh_gradient.h"     /* first: names of ours must not reach it */

#include "basis.h"

#include <math.h>
#include <string.h>

enum { OUTPUT_BYTES = 20480 };

static const int basis_bands[] = { 3, 4, 5, 6, 8, 10 };

/* The library's batch calls, one per chunk. */
#define PER_CHUNK(name, call)                                                                            \
    static void name(const bench_case *self)                                                             \
    {                                                                                                    \
        const basis_input *in = self->input;                                                             \
        size_t first;                                                                                    \
        for (first = 0; first < DIRECTIONS; first += in->chunk) { call; }                                \
    }

/* The library, one call per direction. */
#define PER_CALL(name, call)                                                                             \
    static void name(const bench_case *self)                                                             \
    {                                                                                                    \
        const basis_input *in = self->input;                                                             \
        const size_t n2 = (size_t)(in->bands * in->bands);                                               \
        size_t first, i;                                                                                 \
        for (first = 0; first < DIRECTIONS; first += in->chunk)                                          \
            for (i = 0; i < in->chunk; i++) { const size_t d = first + i; call; }                        \
    }

/* ---- values ---- */

PER_CALL(values_library, FN(sh_eval)(in->bands, in->dirs + 3 * d, in->y + n2 * i))
PER_CHUNK(values_library_n, FN(sh_eval_n)(in->bands, in->chunk, in->dirs + 3 * first, in->y))
PER_CHUNK(values_library_blocks,
          FN(sh_eval_blocks)(in->bands, in->chunk / SH_BLOCK, in->dir_blocks + 3 * first, in->y))

/* ---- derivatives by the angles: y, then d/dtheta and d/dphi in the space of grad, [chunk][n^2] each ---- */

PER_CALL(angles_library, FN(sh_eval_angles)(in->bands, in->theta[d], in->phi[d], ANGLE_OUTPUTS(n2)))
PER_CHUNK(angles_library_n,
          FN(sh_eval_angles_n)(in->bands, in->chunk, in->theta + first, in->phi + first, in->y, in->grad,
                               in->grad + in->chunk * (size_t)(in->bands * in->bands)))

/* ---- gradient by v ---- */

PER_CALL(gradient_library,
         FN(sh_eval_grad)(in->bands, in->vectors + 3 * d, in->y + n2 * i, in->grad + 3 * n2 * i))
PER_CHUNK(gradient_library_n,
          FN(sh_eval_grad_n)(in->bands, in->chunk, in->vectors + 3 * first, in->y, in->grad))
PER_CHUNK(gradient_library_blocks,
          FN(sh_eval_grad_blocks)(in->bands, in->chunk / SH_BLOCK, in->vector_blocks + 3 * first, in->y, in->grad))

/* ---- Hessian ---- */

PER_CALL(hessian_library, FN(sh_eval_hessian)(in->bands, in->vectors + 3 * d, in->y + n2 * i,
                                              in->grad + 3 * n2 * i, in->hess + 6 * n2 * i))
PER_CHUNK(hessian_library_n,
          FN(sh_eval_hessian_n)(in->bands, in->chunk, in->vectors + 3 * first, in->y, in->grad, in->hess))
PER_CHUNK(hessian_library_blocks,
          FN(sh_eval_hessian_blocks)(in->bands, in->chunk / SH_BLOCK, in->vector_blocks + 3 * first, in->y, in->grad,
                                     in->hess))

/* ---- sum of c_k Y_k at each direction, and sum of w Y over all: basis, then a loop ---- */

static void reconstruct_library(const bench_case *self)
{
    const basis_input *in = self->input;
    FN(sh_reconstruct_n)(in->bands, in->coeffs, DIRECTIONS, in->dirs, in->y, NULL);
}

static void project_library(const bench_case *self)
{
    const basis_input *in = self->input;
    FN(sh_project_n)(in->bands, DIRECTIONS, in->dirs, in->weights, in->y);
}

/* ---- other people's libraries, where installed; double precision is what GSL has ---- */

#if defined(BENCH_GSL) && BENCH_PRECISION == 64
#include <gsl/gsl_sf_legendre.h>

/* cos(m phi), sin(m phi) times sqrt(2), by the same recurrence the others use */
static void gsl_spread(int bands, real cos_phi, real sin_phi, const double *p, real *y, real *dp)
{
    real c = M_SQRT2, s = 0, t;
    int l, m;
    for (l = 0; l < bands; l++) {
        y[l * l + l] = p[gsl_sf_legendre_array_index((size_t)l, 0)];
        if (dp) dp[l * l + l] = 0;
    }
    for (m = 1; m < bands; m++) {
        t = c * cos_phi - s * sin_phi; s = c * sin_phi + s * cos_phi; c = t;
        for (l = m; l < bands; l++) {
            const real v = p[gsl_sf_legendre_array_index((size_t)l, (size_t)m)];
            y[l * l + l + m] = v * c;
            y[l * l + l - m] = v * s;
            if (dp) {
                dp[l * l + l + m] = -m * v * s;
                dp[l * l + l - m] = m * v * c;
            }
        }
    }
}

static void values_gsl(const bench_case *self)
{
    const basis_input *in = self->input;
    const size_t lmax = (size_t)in->bands - 1, n2 = (size_t)(in->bands * in->bands);
    double p[256];
    size_t first, i;
    for (first = 0; first < DIRECTIONS; first += in->chunk)
        for (i = 0; i < in->chunk; i++) {
            const real *u = in->dirs + 3 * (first + i), is = 1 / sqrt(u[0] * u[0] + u[1] * u[1]);
            gsl_sf_legendre_array_e(GSL_SF_LEGENDRE_SPHARM, lmax, u[2], -1, p);
            gsl_spread(in->bands, u[0] * is, u[1] * is, p, in->y + n2 * i, NULL);
        }
}

static void angles_gsl(const bench_case *self)
{
    const basis_input *in = self->input;
    const size_t lmax = (size_t)in->bands - 1, n2 = (size_t)(in->bands * in->bands);
    double p[256], dp[256];
    real unused[256];
    size_t first, i;
    for (first = 0; first < DIRECTIONS; first += in->chunk)
        for (i = 0; i < in->chunk; i++) {
            const real theta = in->theta[first + i], phi = in->phi[first + i], c = cos(phi), s = sin(phi);
            gsl_sf_legendre_deriv_alt_array_e(GSL_SF_LEGENDRE_SPHARM, lmax, cos(theta), -1, p, dp);
            gsl_spread(in->bands, c, s, p, in->y + n2 * i, in->grad + n2 * (in->chunk + i));
            gsl_spread(in->bands, c, s, dp, in->grad + n2 * i, unused);
        }
}
#endif

#if defined(BENCH_BOOST)
void FN(bench_boost)(int bands, const real dir[3], real *y);
PER_CALL(values_boost, FN(bench_boost)(in->bands, in->dirs + 3 * d, in->y + n2 * i))
#endif

/* ---- registration ---- */

static const real *to_blocks(const real *plain)
{
    real *out = bench_alloc(3 * DIRECTIONS, sizeof *out);
    size_t i, k;
    for (i = 0; i < DIRECTIONS; i++)
        for (k = 0; k < 3; k++) out[(i / SH_BLOCK * 3 + k) * SH_BLOCK + i % SH_BLOCK] = plain[3 * i + k];
    return out;
}

static void add(const basis_input *in, const char *kernel, const char *impl, void (*run)(const bench_case *))
{
    const size_t n2 = (size_t)(in->bands * in->bands);
    const double stored = (double)(n2 * sizeof(real));
    bench_case c;
    memset(&c, 0, sizeof c);
    c.kernel = kernel;
    c.impl = impl;
    c.bands = in->bands;
    c.items = DIRECTIONS;
    c.run = run;
    c.input = in;
    c.lanes = strcmp(impl, "library_blocks") ? 1 : SH_BLOCK;
    c.held = in->chunk;
    c.tolerance = 200 * REAL_EPS;       /* the directions keep off the poles, where M22's forms lose digits */
    c.out[0].data = in->y;
    c.out[0].numbers = n2;
    if (!strcmp(kernel, "values")) {
        c.bytes = stored;
    } else if (!strcmp(kernel, "angles")) {
        c.out[1].data = in->grad;
        c.out[1].numbers = n2;
        c.out[2].data = in->grad + n2 * in->chunk;
        c.out[2].numbers = n2;
        c.bytes = 3 * stored;
    } else if (!strcmp(kernel, "reconstruct")) {
        c.held = DIRECTIONS;
        c.out[0].numbers = 1;
        c.flops = 3.0 * (double)n2;             /* Horner in z: an FMA per coefficient and its share of the column */
    } else if (!strcmp(kernel, "project")) {
        c.held = 1;
        c.flops = 2.0 * (double)n2 + 3.0 * (double)n2;  /* the basis at 3 per member, one FMA each */
    } else {
        c.out[1].data = in->grad;
        c.out[1].numbers = 3 * n2;
        c.out[1].planes = 3;
        c.bytes = 4 * stored;
        if (!strcmp(kernel, "hessian")) {
            c.out[2].data = in->hess;
            c.out[2].numbers = 6 * n2;
            c.out[2].planes = 6;
            c.bytes = 10 * stored;
        }
    }
    bench_add(&c);
}

/* As many directions as keep the output in two thirds of L1, at least two blocks: a divisor of DIRECTIONS. */
static size_t chunk_of(size_t numbers)
{
    static const size_t blocks[] = { 60, 30, 20, 15, 12, 10, 6, 5, 4, 3 };
    size_t k;
    for (k = 0; k < sizeof blocks / sizeof blocks[0]; k++)
        if (SH_BLOCK * blocks[k] * numbers * sizeof(real) <= OUTPUT_BYTES) return SH_BLOCK * blocks[k];
    return 16;
}

static void add_bands(const basis_input *shared, int bands)
{
    const size_t n2 = (size_t)(bands * bands);
    basis_input *in[4];
    static const size_t planes[4] = { 1, 4, 3, 10 };    /* values, gradient, angles, Hessian */
    int k;
    for (k = 0; k < 4; k++) {
        real *coeffs = bench_alloc(n2, sizeof(real));
        size_t i;
        in[k] = bench_alloc(1, sizeof *in[k]);
        *in[k] = *shared;
        for (i = 0; i < n2; i++) coeffs[i] = C(2 * bench_random() - 1);
        in[k]->bands = bands;
        in[k]->chunk = chunk_of(planes[k] * n2);
        in[k]->coeffs = coeffs;
        in[k]->y = bench_alloc(n2 * in[k]->chunk + DIRECTIONS, sizeof(real));
        in[k]->grad = bench_alloc(3 * n2 * in[k]->chunk, sizeof(real));
        in[k]->hess = bench_alloc(6 * n2 * in[k]->chunk, sizeof(real));
    }
    add(in[0], "values", "library", values_library);
    add(in[0], "values", "library_n", values_library_n);
    add(in[0], "values", "library_blocks", values_library_blocks);
    add(in[0], "values", "polynomial", FN(values_polynomial));
    add(in[0], "values", "sloan", FN(values_sloan));
    add(in[0], "values", "sloan_auto", FN(values_sloan_auto));
    add(in[1], "gradient", "library", gradient_library);
    add(in[1], "gradient", "library_n", gradient_library_n);
    add(in[1], "gradient", "library_blocks", gradient_library_blocks);
    add(in[1], "gradient", "polynomial", FN(gradient_polynomial));
    add(in[1], "gradient", "direct", FN(gradient_direct));
    add(in[1], "gradient", "sloan_like", FN(gradient_sloan_like));
    add(in[1], "gradient", "sloan_like_auto", FN(gradient_sloan_like_auto));
    add(in[2], "angles", "library", angles_library);
    add(in[2], "angles", "library_n", angles_library_n);
    add(in[2], "angles", "direct", FN(angles_direct));
    add(in[2], "angles", "sloan_like", FN(angles_sloan_like));
    add(in[0], "reconstruct", "library", reconstruct_library);
    add(in[0], "reconstruct", "polynomial", FN(reconstruct_polynomial));
    add(in[0], "reconstruct", "sloan", FN(reconstruct_sloan));
    add(in[0], "reconstruct", "sloan_auto", FN(reconstruct_sloan_auto));
    add(in[0], "project", "library", project_library);
    add(in[0], "project", "polynomial", FN(project_polynomial));
    add(in[0], "project", "sloan", FN(project_sloan));
    add(in[3], "hessian", "library", hessian_library);
    add(in[3], "hessian", "library_n", hessian_library_n);
    add(in[3], "hessian", "library_blocks", hessian_library_blocks);
    add(in[3], "hessian", "polynomial", FN(hessian_polynomial));
#if defined(BENCH_GSL) && BENCH_PRECISION == 64
    add(in[0], "values", "gsl", values_gsl);
    add(in[2], "angles", "gsl", angles_gsl);
#endif
#if defined(BENCH_BOOST)
    if (!bench_option.quick) add(in[0], "values", "boost", values_boost);
#endif
}

void FN(bench_basis)(void)
{
    basis_input shared;
    real *dirs, *vectors, *theta, *phi, *weights;
    size_t i, k;

    bench_suite("basis", BENCH_PRECISION, "direction", "the output block is reused and stays in L1");
    bench_base("values", "sloan");
    bench_base("gradient", "sloan_like");
    bench_base("angles", "sloan_like");
    bench_base("reconstruct", "sloan");
    bench_base("project", "sloan");
    bench_base("hessian", "polynomial");
    dirs = bench_alloc(3 * DIRECTIONS, sizeof(real));
    vectors = bench_alloc(3 * DIRECTIONS, sizeof(real));
    theta = bench_alloc(DIRECTIONS, sizeof(real));
    phi = bench_alloc(DIRECTIONS, sizeof(real));
    weights = bench_alloc(DIRECTIONS, sizeof(real));
    for (i = 0; i < DIRECTIONS; i++) {
        const double t = 0.1 + 2.9415926535897931 * bench_random(), p = 6.283185307179586 * bench_random();
        const double u[3] = { sin(t) * cos(p), sin(t) * sin(p), cos(t) }, length = 0.5 + 1.5 * bench_random();
        theta[i] = C(t);
        phi[i] = C(p);
        weights[i] = C(bench_random());
        for (k = 0; k < 3; k++) {
            dirs[3 * i + k] = C(u[k]);
            vectors[3 * i + k] = C(length * u[k]);
        }
    }
    memset(&shared, 0, sizeof shared);
    shared.dirs = dirs;
    shared.vectors = vectors;
    shared.dir_blocks = to_blocks(dirs);
    shared.vector_blocks = to_blocks(vectors);
    shared.theta = theta;
    shared.phi = phi;
    shared.weights = weights;
    for (k = 0; k < sizeof basis_bands / sizeof basis_bands[0]; k++) add_bands(&shared, basis_bands[k]);
    bench_run();
}
