/* sh-oracle - the library's answers as text, to check another implementation against: sign, order, axes, values, gradients.
 *
 *     echo 0,0,1 | build/sh-oracle eval --bands 3
 *
 * One query per line in, one line per component out. To add a function: a run_ function in functions.h, a row in the
 * table below. This file reads the command line and the lines; functions.h, read once per precision, has all numbers. */
#include "sh_gradient.h"
#include "sh_polygon.h"
#include "sh_product.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_OK = 0, EXIT_BAD_QUERY = 1, EXIT_USAGE = 2 };

typedef struct function function;
typedef struct { int bands, precision, convention, sides; const function *function; } options;

struct function {
    const char *name;
    const char *query;              /* as shown by --help */
    int scalars, vectors;           /* numbers in a query: scalars, then vectors of bands^2 coefficients */
    const char *components;         /* name:size in output order; size N is bands^2, n is bands, 1 is one number */
    int (*run_f32)(const options *, const float *, size_t, float *);
    int (*run_f64)(const options *, const double *, size_t, double *);
    int shape;                      /* of the input */
    const char *options, *example;  /* "echo EXAMPLE | sh-oracle NAME OPTIONS" */
};
enum { FIXED = 0, LONGER, WHOLE };  /* so many numbers; at least so many; all lines together are one query */

/* Numbers of a query, whatever the precision; grows and is reused from line to line. */
typedef struct { void *data; size_t count, room; } numbers;

static void *grow(void *data, size_t bytes)
{
    data = realloc(data, bytes);
    if (!data) { fprintf(stderr, "sh-oracle: out of memory\n"); exit(EXIT_BAD_QUERY); }
    return data;
}

static void complain(long line, int status)
{
    fprintf(stderr, "sh-oracle: ");
    if (line) fprintf(stderr, "line %ld: ", line);
    fprintf(stderr, "%s%s\n", status > 0 ? "note: " : "", sh_status_string(status));
}

#define T          float
#define F(name)    name##_f32
#define PARSE      strtof
#define DIGITS     "%.9g"
#include "functions.h"
#undef  T
#undef  F
#undef  PARSE
#undef  DIGITS
#define T          double
#define F(name)    name##_f64
#define PARSE      strtod
#define DIGITS     "%.17g"
#include "functions.h"

/* ---- the functions ---- */
#define RUN(name) run_##name##_f32, run_##name##_f64

static const function functions[] = {
    { "eval", "x,y,z", 3, 0, "Y:N", RUN(eval), FIXED, "--bands 3", "0.6,0,0.8" },
    { "grad", "x,y,z (any length)", 3, 0, "Y:N dx:N dy:N dz:N", RUN(grad), FIXED, "--bands 2", "3,0,4" },
    { "angles", "theta,phi (radians)", 2, 0, "Y:N dtheta:N dphi:N", RUN(angles), FIXED, "--bands 2", "0.5,1.25" },
    { "hessian", "x,y,z (any length)", 3, 0, "xx:N xy:N xz:N yy:N yz:N zz:N", RUN(hessian), FIXED, "--bands 2", "3,0,4" },
    { "cap", "sin of the half-angle", 1, 0, "zh:n dzh:n", RUN(cap), FIXED, "--bands 5", "0.1" },
    { "sphere", "point(3),center(3),radius", 7, 0, "c:N dx:N dy:N dz:N", RUN(sphere), FIXED,
      "--bands 3 --precision f64", "0,0,0,1,2,3,0.5" },
    { "polygon", "point(3),vertex count,vertices(3 each)", 4, 0, "c:N dx:N dy:N dz:N", RUN(polygon), LONGER,
      "--bands 3 --sides front", "0,0,0,3,1,0,2,0,0,2,0,1,2" },
    { "triangle-as-sphere", "point(3),a(3),b(3),c(3)", 12, 0, "c:N dx:N dy:N dz:N", RUN(triangle_as_sphere), FIXED,
      "--bands 2", "0,0,0,1,0,2,0,1,2,0,0,2" },
    { "cosine-product", "normal(3),coefficients(N*N); D is the irradiance", 3, 1, "out:N D:1", RUN(cosine_product), FIXED,
      "--bands 2", "0,0,1,1,0,0.5,0" },
    { "triple-product", "a(N*N),b(N*N); D is the integral of a b", 0, 2, "out:N D:1", RUN(triple_product), FIXED,
      "--bands 2", "1,0,0.5,0,1,0.25,0,0" },
    { "rotate", "row-major matrix R(9),coefficients(N*N); out(R u) = in(u)", 9, 1, "out:N", RUN(rotate), FIXED,
      "--bands 2", "0,-1,0,1,0,0,0,0,1,1,0,0.5,0.25" },
    { "cubemap", "direction(3),solid angle,radiance,depth,normal(3); one texel per line", 9, 0,
      "c:N dx:N dy:N dz:N", RUN(cubemap), WHOLE, "--bands 2", "0,0,1,0.01,1,2,0,0,-1" },
};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };

/* ---- command line ---- */
static void usage(FILE *to)
{
    int i;
    fprintf(to,
        "usage: sh-oracle FUNCTION [--bands N] [--precision f32|f64] [--convention NAME] [--sides front|both|signed]\n\n"
        "Reads one query per line from standard input: comma-separated decimal numbers; blank lines and # lines are\n"
        "skipped. Writes one line per component: its name and its values in index order.\n\n"
        "  --bands N          1..%d bands, N*N coefficients  [3]\n"
        "  --precision P      f32 or f64: which of the library's functions answers  [f32]\n"
        "  --convention NAME  sloan or no-phase: how coefficients are written and read  [sloan]\n"
        "  --sides S          which sides of a polygon shine  [both]\n\n"
        "A bad query writes error,REASON and the program ends with 1; a bad command line ends it with 2.\n",
        SH_MAX_BANDS);
    for (i = 0; i < FUNCTIONS; i++)
        fprintf(to, "\n  %-19s %s\n      echo %s | sh-oracle %s %s\n", functions[i].name, functions[i].query,
                functions[i].example, functions[i].name, functions[i].options);
}

static int bad_usage(const char *what, const char *value)
{
    fprintf(stderr, "sh-oracle: %s%s%s\n\n", what, value ? ": " : "", value ? value : "");
    usage(stderr);
    return EXIT_USAGE;
}

static int choose(const char *value, const char *const names[], int count)
{
    int i;
    for (i = 0; i < count; i++)
        if (!strcmp(value, names[i])) return i;
    return -1;
}

static int parse_command_line(int argc, char **argv, options *o)
{
    static const char *const precisions[] = { "f32", "f64" }, *const conventions[] = { "sloan", "no-phase" };
    static const char *const sides[] = { "both", "front", "signed" };
    int i;

    for (i = 1; i < argc; i++) {
        const char *name = argv[i], *value = argv[i + 1];
        if (!strcmp(name, "--help") || !strcmp(name, "-h")) { usage(stdout); exit(EXIT_OK); }
        if (name[0] != '-') {
            int k;
            if (o->function) return bad_usage("more than one function", name);
            for (k = 0; k < FUNCTIONS; k++)
                if (!strcmp(name, functions[k].name)) o->function = &functions[k];
            if (!o->function) return bad_usage("unknown function", name);
            continue;
        }
        if (!value && !strncmp(name, "--", 2)) return bad_usage("missing value after", name);
        if (!strcmp(name, "--bands")) {
            char *end;
            const long n = strtol(value, &end, 10);
            if (*end || end == value || n < 1 || n > SH_MAX_BANDS) return bad_usage("bad number of bands", value);
            o->bands = (int)n;
        } else if (!strcmp(name, "--precision")) {
            if ((o->precision = choose(value, precisions, 2)) < 0) return bad_usage("unknown precision", value);
        } else if (!strcmp(name, "--convention")) {
            if ((o->convention = choose(value, conventions, 2)) < 0) return bad_usage("unknown convention", value);
        } else if (!strcmp(name, "--sides")) {
            if ((o->sides = choose(value, sides, 3)) < 0) return bad_usage("unknown sides", value);
        } else {
            return bad_usage("unknown option", name);
        }
        i++;
    }
    return o->function ? EXIT_OK : bad_usage("no function given", NULL);
}

/* ---- lines ---- */
/* The next line of any length without its end, in *line; 0 at the end of the input. */
static int read_line(char **line, size_t *room)
{
    size_t n = 0;
    int c;
    while ((c = getchar()) != EOF && c != '\n') {
        if (n + 2 > *room) *line = (char *)grow(*line, *room = 2 * *room + 256);
        (*line)[n++] = (char)c;
    }
    if (c == EOF && n == 0) return 0;
    if (*room == 0) *line = (char *)grow(*line, *room = 256);
    if (n && (*line)[n - 1] == '\r') n--;
    (*line)[n] = 0;
    return 1;
}

static int answer(const options *o, const numbers *q, int status, long line)
{
    return o->precision ? answer_f64(o, q, status, line) : answer_f32(o, q, status, line);
}

int main(int argc, char **argv)
{
    options o = { 3, 0, 0, 0, NULL };
    numbers query = { NULL, 0, 0 };
    char *line = NULL;
    size_t room = 0;
    long at = 0;
    int bad = parse_command_line(argc, argv, &o), whole = SH_OK;

    if (bad) return bad;
    while (read_line(&line, &room)) {
        const char *text = line + strspn(line, " \t");
        int status;
        at++;
        if (!*text || *text == '#') continue;
        if (o.function->shape != WHOLE) query.count = 0;
        status = o.precision ? parse_f64(&o, text, at, &query) : parse_f32(&o, text, at, &query);
        if (status != SH_OK) whole = status;
        if (o.function->shape != WHOLE) bad |= answer(&o, &query, status, at);
    }
    if (o.function->shape == WHOLE) bad |= answer(&o, &query, whole, 0);
    free(line);
    free(query.data);
    if (ferror(stdin) || fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "sh-oracle: %s\n", strerror(errno));
        return EXIT_BAD_QUERY;
    }
    return bad ? EXIT_BAD_QUERY : EXIT_OK;
}
