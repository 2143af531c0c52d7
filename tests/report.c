#include "report.h"

enum { ROWS = 256 };
static row rows[ROWS];
static int row_count;
static char current[160];

row *row_open(const char *name, const char *precision)
{
    row *w = NULL;
    int i;
    for (i = 0; i < row_count; i++)
        if (!strcmp(rows[i].name, name) && !strcmp(rows[i].precision, precision)) w = &rows[i];
    if (!w) {
        assert_true(row_count < ROWS);
        w = &rows[row_count++];
        snprintf(w->name, sizeof w->name, "%s", name);
        snprintf(w->precision, sizeof w->precision, "%s", precision);
    }
    row_case("-");
    return w;
}

void row_case(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(current, sizeof current, format, args);
    va_end(args);
}

void row_check(row *w, long double got, long double want, long double bound, int component)
{
    const long double error = fabsl(got - want);
    /* a bound of 0 asks for equality; the ratio of 0/0 there is 0 */
    const double e = error == 0 && bound >= 0 ? 0.0 : (double)(error / bound);
    w->checks++;
    if (isnan(w->worst)) return;
    if (!(e <= w->worst)) {                                         /* NaN is always worse */
        w->worst = e;
        w->component = component;
        memcpy(w->where, current, sizeof current);
    }
}

int row_holds(const row *w) { return w->checks > 0 && w->worst <= 1; }

void row_close_(row *w, const char *file, int line)
{
    if (row_holds(w)) return;
    print_error("%s %s: %g of its bound at component %d, %s\n", w->name, w->precision, w->worst, w->component, w->where);
    _fail(file, line);
}

int row_print(void **state)
{
    FILE *csv = getenv("SH_TEST_CSV") ? fopen(getenv("SH_TEST_CSV"), "a") : NULL;
    int i, bad = 0;
    (void)state;
    if (row_count) printf("\n%-40s %-4s %10s  %-7s worst at\n", "row", "", "checks", "/bound");
    for (i = 0; i < row_count; i++) {
        const row *w = &rows[i];
        const int ok = row_holds(w);
        printf("%-40s %-4s %10ld  %-7.3g %s[%d] %s\n", w->name, w->precision, w->checks, w->worst, ok ? "" : "FAIL ",
               w->component, w->where);
        if (csv) fprintf(csv, "%s,%s,%ld,%.3g\n", w->name, w->precision, w->checks, w->worst);
        bad += !ok;
    }
    printf("\n");
    fflush(stdout);
    if (csv) fclose(csv);
    return bad;
}

int effort(int count)
{
    const char *text = getenv("SH_TEST_EFFORT");
    const double n = count * (text ? atof(text) : 1.0);
    return n < 1 ? 1 : (int)n;
}

#ifdef SH_TESTS_PLAIN_CMOCKA_H
int plain_failures;
#endif
