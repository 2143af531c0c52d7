/* report.h - error accounting for the tests, and how to write one.
 *
 * A row is one output of one function in one precision. A check is |got - want| / bound with the bound that the
 * header documents: 1.00 is the limit, the row keeps the worst and where it was. NaN is worse than any number.
 * A file tests/test_NAME.c is a cmocka program, built and run by `make test`, that reads itself once per precision:
 *
 *     #ifndef T                                                       // first reading: includes and main
 *     #include "sh_gradient.h"
 *     #include "report.h"                                             // and cmocka, and what cmocka wants before it
 *     #include "ref.h"                                                // long double references
 *     #define BOTH "test_NAME.c"
 *     #include "both.h"                                               // T, F(name), EPS, PRECISION; float, then double
 *     int main(void) { const struct CMUnitTest t[] = { BOTH_TESTS(eval) }; return RUN_TESTS(t); }
 *     #else
 *     static void F(eval)(void **state) {
 *         row *w = row_open("sh_eval values", PRECISION);  (void)state;
 *         for (...) { row_case("bands %d", bands);                     // described once, printed if it is the worst
 *                     row_check(w, y[i], want, bound, i); }            // i = component, printed with the case
 *         row_close(w);                                               // fails the test if the bound was passed
 *     }
 *     #endif
 */
#ifndef SH_TESTS_REPORT_H
#define SH_TESTS_REPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <float.h>
#include <math.h>
#include <cmocka.h>

typedef struct {
    char name[48], precision[4], where[160];
    double worst;      /* in units of the bound; NaN if a NaN was seen */
    long checks;
    int component;
} row;

row *row_open(const char *name, const char *precision);
void row_case(const char *format, ...);
void row_check(row *w, long double got, long double want, long double bound, int component);
int  row_holds(const row *w);              /* at least one check, none beyond its bound */
void row_close_(row *w, const char *file, int line);
#define row_close(w) row_close_(w, __FILE__, __LINE__)
int  row_print(void **state);              /* group teardown: the table, above cmocka's summary */

#define BOTH_TESTS(f) cmocka_unit_test(f##_f32), cmocka_unit_test(f##_f64)
#define RUN_TESTS(t)  cmocka_run_group_tests(t, NULL, row_print)

/* -ffast-math gives up bits of a batch that are those of single calls, and twice the working precision in double */
#ifdef __FAST_MATH__
enum { FAST_MATH = 1 };
#else
enum { FAST_MATH = 0 };
#endif

/* How much random testing: SH_TEST_EFFORT in the environment, 1 by default; effort(100) is 100 times that. */
int effort(int count);

#endif
