/* Every convention against golden rows printed by the system itself, or evaluated from its published constants:
 * tests/conventions/golden.csv says which; `make check-conventions` prints them anew. And there and back. */
#ifndef T
#include "sh_product.h"
#include "report.h"
#include "ref.h"

#define BOTH "test_product_conventions.c"
#include "both.h"

/* Constants printed with six digits by the system allow no more; Babylon's polynomial has 0.886277 for 0.886227. */
static double tolerance(const char *name)
{
    static const char *const six[] = { "three", "google", "unreal", "godot" };
    size_t i;
    for (i = 0; i < 4; i++) if (strcmp(name, six[i]) == 0) return 2e-6;
    return strcmp(name, "babylon-polynomial") == 0 ? 2e-5 : 4e-15;
}

static void golden(void **state)
{
    FILE *f = fopen("tests/conventions/golden.csv", "r");
    static char line[16384], seen[64];   /* seen: by convention */
    row *w = row_open("golden rows, exact systems", "f64"), *w6 = row_open("golden rows, six-digit systems", "f64");
    int id, rows = 0;

    (void)state;
    assert_non_null(f);
    while (fgets(line, sizeof line, f)) {
        char *name = strtok(line, ","), *source = strtok(NULL, ","), *kind = strtok(NULL, ","), *field;
        double d[3], u[3] = { 0, 0, 0 }, values[512], theirs[512], c[25], bound;
        long double v[3], y[25];
        int count = 0, i, bands;

        if (name[0] == '#') continue;
        id = sh_convention(name);
        assert_true(id >= 0);
        for (i = 0; i < 3; i++) d[i] = strtod(strtok(NULL, ","), NULL);
        while ((field = strtok(NULL, ",")) != NULL && count < 512) values[count++] = strtod(field, NULL);
        assert_int_equal(sh_convert_direction_from_f64(id, d, u), SH_OK);
        for (i = 0; i < 3; i++) v[i] = (long double)u[i];
        ref_values(5, v, y);
        for (i = 0; i < 25; i++) c[i] = (double)y[i];
        row_case("%s: %s", name, source);
        if (strcmp(kind, "irradiance") == 0) {
            const double n[3] = { 6.0 / 7, 3.0 / 7, 2.0 / 7 };
            double e;
            assert_int_equal(sh_diffuse_f64(3, c, n, &e), SH_OK);
            row_check(w6, (long double)values[0], (long double)e, 2e-6L, 0);
            rows++;
            continue;
        }
        for (bands = 1; bands <= 5 && sh_convention_size(id, bands) != count; bands++) ;
        assert_true(bands <= 5);
        assert_int_equal(sh_convert_to_f64(id, bands, c, theirs), SH_OK);
        bound = tolerance(name);
        for (i = 0; i < count; i++)
            row_check(bound < 1e-10 ? w : w6, (long double)theirs[i], (long double)values[i],
                      (long double)(bound * (fabs(values[i]) > 1 ? fabs(values[i]) : 1)), i);
        seen[id] = 1;
        rows++;
    }
    fclose(f);
    row_close(w);
    row_close(w6);
    for (id = 0; sh_convention_name(id); id++) {
        if (!seen[id]) print_error("no golden row for %s\n", sh_convention_name(id));
        assert_true(seen[id]);
    }
    assert_true(id == 33 && rows >= 66);
}

static void names(void **state)
{
    int id;
    (void)state;
    for (id = 0; sh_convention_name(id); id++) assert_int_equal(sh_convention(sh_convention_name(id)), id);
    assert_int_equal(sh_convention("nothing"), SH_ERROR_OPTION);
    assert_int_equal(sh_convention(NULL), SH_ERROR_NULL);
    assert_null(sh_convention_name(-1));
    assert_int_equal(sh_convention_size(sh_convention("unity"), 4), SH_ERROR_BANDS);
    assert_int_equal(sh_convention_size(sh_convention("unity-packed"), 2), SH_ERROR_BANDS);
    assert_int_equal(sh_convention_size(sh_convention("scipy"), 5), 50);
    assert_int_equal(sh_convention_size(sh_convention("healpy"), 5), 30);
    assert_int_equal(sh_convention_size(999, 5), SH_ERROR_OPTION);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(golden), cmocka_unit_test(names), BOTH_TESTS(round_trip) };
    return RUN_TESTS(tests);
}

#else

/* To the bit where only order, sign and axes differ; within an eps where a factor is folded in. */
static void F(round_trip)(void **state)
{
    static const char *const scaled[] = { "babylon-polynomial", "gltf", "godot", "unity", "unity-packed", "filament", "scipy", "mpmath",
                                          "sympy", "boost", "healpy", "gsl", "shtools", "n3d", "sn3d", "fuma" };
    static T c[1024], back[1024], theirs[2049];
    row *w = row_open("there and back, scaled systems", PRECISION);
    int id, i, bands;
    size_t k;

    (void)state;
    for (id = 0; sh_convention_name(id); id++) {
        T d[3] = { (T)0.1, (T)0.2, (T)0.3 }, e[3];
        int exact = 1;
        for (k = 0; k < sizeof scaled / sizeof scaled[0]; k++) if (strcmp(scaled[k], sh_convention_name(id)) == 0) exact = 0;
        for (bands = 1; bands <= 32; bands++) {
            const int size = sh_convention_size(id, bands), n = bands * bands;
            if (size < 0) {
                assert_int_equal(F(sh_convert_to)(id, bands, c, theirs), SH_ERROR_BANDS);
                continue;
            }
            for (i = 0; i < n; i++) c[i] = (T)ref_between(-1, 1);
            theirs[size] = 77;
            assert_int_equal(F(sh_convert_to)(id, bands, c, theirs), SH_OK);
            assert_true(theirs[size] == 77);
            assert_int_equal(F(sh_convert_from)(id, bands, theirs, back), SH_OK);
            if (exact) assert_memory_equal(c, back, (size_t)n * sizeof *c);
            row_case("%s, %d bands", sh_convention_name(id), bands);
            for (i = 0; i < n; i++)         /* packed and monomial forms add band 0 and 2: relative to the largest */
                row_check(w, (long double)back[i], (long double)c[i],
                          (long double)EPS * (size == 9 && !exact ? 8 : fabsl((long double)c[i]) + 1e-30L), i);
        }
        F(sh_convert_direction_to)(id, d, e);
        F(sh_convert_direction_from)(id, e, e);
        assert_memory_equal(d, e, sizeof d);
    }
    row_close(w);
    assert_int_equal(F(sh_convert_to)(0, 3, NULL, theirs), SH_ERROR_NULL);
    assert_int_equal(F(sh_convert_to)(0, 3, theirs, theirs), SH_ERROR_OVERLAP);
    assert_int_equal(F(sh_convert_from)(999, 3, theirs, c), SH_ERROR_OPTION);
}

#endif
