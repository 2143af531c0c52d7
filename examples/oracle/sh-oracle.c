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
typedef struct { int bands, precision, convention, from, sides; const function *function; } options;

struct function {
    const char *name;
    const char *query;              /* as shown by --help */
    const char *layout;             /* of a query: s number, v vector, m matrix, c coefficients; after * repeated */
    const char *components;         /* name:size in output order; N coefficients, V three and H six planes of them,
                                       n one number a band, 1 one number */
    int (*run_f32)(const options *, const float *, size_t, float *);
    int (*run_f64)(const options *, const double *, size_t, double *);
    int whole;                      /* all lines together are one query */
    const char *options, *example;  /* "echo EXAMPLE | sh-oracle NAME OPTIONS" */
};

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
    { "eval", "x,y,z", "v", "Y:N", RUN(eval), 0, "--bands 3", "0.6,0,0.8" },
    { "grad", "x,y,z (any length)", "v", "Y:N :V", RUN(grad), 0, "--bands 2", "3,0,4" },
    { "angles", "theta,phi (radians)", "ss", "Y:N dtheta:N dphi:N", RUN(angles), 0, "--bands 2", "0.5,1.25" },
    { "hessian", "x,y,z (any length)", "v", ":H", RUN(hessian), 0, "--bands 2", "3,0,4" },
    { "cap", "sin of the half-angle", "s", "zh:n dzh:n", RUN(cap), 0, "--bands 5", "0.1" },
    { "sphere", "point(3),center(3),radius", "vvs", "c:N :V", RUN(sphere), 0,
      "--bands 3 --precision f64", "0,0,0,1,2,3,0.5" },
    { "polygon", "point(3),vertex count,vertices(3 each)", "vs*v", "c:N :V", RUN(polygon), 0,
      "--bands 3 --sides front", "0,0,0,3,1,0,2,0,0,2,0,1,2" },
    { "triangle-as-sphere", "point(3),a(3),b(3),c(3)", "vvvv", "c:N :V", RUN(triangle_as_sphere), 0,
      "--bands 2", "0,0,0,1,0,2,0,1,2,0,0,2" },
    { "cosine-product", "normal(3),coefficients(N*N); D is the irradiance", "vc", "out:N D:1", RUN(cosine_product), 0,
      "--bands 2", "0,0,1,1,0,0.5,0" },
    { "triple-product", "a(N*N),b(N*N); D is the integral of a b", "cc", "out:N D:1", RUN(triple_product), 0,
      "--bands 2", "1,0,0.5,0,1,0.25,0,0" },
    { "rotate", "row-major matrix R(9),coefficients(N*N); out(R u) = in(u)", "mc", "out:N", RUN(rotate), 0,
      "--bands 2", "0,-1,0,1,0,0,0,0,1,1,0,0.5,0.25" },
    { "convert", "coefficients as --from has them", "c", "out:N", RUN(convert), 0,
      "--bands 2 --from three --convention n3d", "1,0,0.5,0.25" },
    { "cubemap", "direction(3),solid angle,radiance,depth,normal(3); one texel per line", "vsssv", "c:N :V", RUN(cubemap), 1,
      "--bands 2", "0,0,1,0.01,1,2,0,0,-1" },
};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };

/* ---- command line ---- */
static void usage(FILE *to)
{
    const char *name;
    int i;
    fprintf(to,
        "usage: sh-oracle FUNCTION [--bands N] [--precision f32|f64] [--convention NAME] [--sides front|both|signed]\n\n"
        "Reads one query per line from standard input: comma-separated decimal numbers; blank lines and # lines are\n"
        "skipped. Writes one line per component: its name and its values in index order.\n\n"
        "  --bands N          1..%d bands, N*N coefficients  [3]\n"
        "  --precision P      f32 or f64: which of the library's functions answers  [f32]\n"
        "  --convention NAME  order, sign, scale and axes of everything read and written  [sloan]\n"
        "  --from NAME        ... of the coefficients read  [as --convention; for convert: sloan]\n"
        "  --sides S          which sides of a polygon shine  [both]\n\n"
        "Conventions (docs/conventions.md; Y is written as the coefficients of a unit impulse):", SH_MAX_BANDS);
    for (i = 0; (name = sh_convention_name(i)) != NULL; i++) fprintf(to, "%s%s", i % 8 ? " " : "\n  ", name);
    fprintf(to, "\n\nA bad query writes error,REASON and the program ends with 1; a bad command line ends it with 2.\n");
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
    static const char *const precisions[] = { "f32", "f64" }, *const sides[] = { "both", "front", "signed" };
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
            if ((o->convention = sh_convention(value)) < 0) return bad_usage("unknown convention", value);
        } else if (!strcmp(name, "--from")) {
            if ((o->from = sh_convention(value)) < 0) return bad_usage("unknown convention", value);
        } else if (!strcmp(name, "--sides")) {
            if ((o->sides = choose(value, sides, 3)) < 0) return bad_usage("unknown sides", value);
        } else {
            return bad_usage("unknown option", name);
        }
        i++;
    }
    if (!o->function) return bad_usage("no function given", NULL);
    if (o->from < 0) o->from = o->function->run_f32 == run_convert_f32 ? 0 : o->convention;
    if (sh_convention_size(o->convention, o->bands) < 0 || sh_convention_size(o->from, o->bands) < 0)
        return bad_usage("the convention does not have so many bands", NULL);
    return EXIT_OK;
}

/* ---- lines ---- */
/* The next line of any length without its end, in *line, a NUL as '?'; 0 at the end of the input. */
static int read_line(char **line, size_t *room)
{
    size_t n = 0;
    int c;
    while ((c = getchar()) != EOF && c != '\n') {
        if (n + 2 > *room) *line = (char *)grow(*line, *room = 2 * *room + 256);
        (*line)[n++] = c ? (char)c : '?';
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
    options o = { 3, 0, 0, -1, SH_BOTH, NULL };
    numbers query = { NULL, 0, 64 };
    char *line = NULL;
    size_t room = 0;
    long at = 0;
    int bad = parse_command_line(argc, argv, &o), whole = SH_OK;

    if (bad) return bad;
    query.data = grow(NULL, query.room * sizeof(double));
    while (read_line(&line, &room)) {
        const char *text = line + strspn(line, " \t");
        int status;
        at++;
        if (!*text || *text == '#') continue;
        if (!o.function->whole) query.count = 0;
        status = o.precision ? parse_f64(&o, text, at, &query) : parse_f32(&o, text, at, &query);
        if (whole == SH_OK) whole = status;
        if (!o.function->whole) bad |= answer(&o, &query, status, at);
    }
    if (o.function->whole) bad |= answer(&o, &query, whole, 0);
    free(line);
    free(query.data);
    if (ferror(stdin) || fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "sh-oracle: %s\n", strerror(errno));
        return EXIT_BAD_QUERY;
    }
    return bad ? EXIT_BAD_QUERY : EXIT_OK;
}
