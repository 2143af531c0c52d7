/* plain/cmocka.h - the few parts of cmocka that the tests use, in front of it on the include path where there is no
 * cmocka: cross compilers under qemu, memory sanitizer. A failed assertion is printed and counted, the test goes on. */
#ifndef SH_TESTS_PLAIN_CMOCKA_H
#define SH_TESTS_PLAIN_CMOCKA_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct CMUnitTest { const char *name; void (*function)(void **); };
extern int plain_failures;

static inline void _fail(const char *file, int line)
{
    if (plain_failures++ < 20) printf("%s:%d: failed\n", file, line);
}

#define plain_assert(x)                do { if (!(x)) _fail(__FILE__, __LINE__); } while (0)
#define assert_true(x)                 plain_assert(x)
#define assert_false(x)                plain_assert(!(x))
#define assert_int_equal(a, b)         plain_assert((a) == (b))
#define assert_int_not_equal(a, b)     plain_assert((a) != (b))
#define assert_null(a)                 plain_assert(!(a))
#define assert_non_null(a)             plain_assert(a)
#define assert_memory_equal(a, b, n)   plain_assert(!memcmp(a, b, n))
#define assert_memory_not_equal(a,b,n) plain_assert(memcmp(a, b, n))
#define assert_string_equal(a, b)      plain_assert(!strcmp(a, b))
#define assert_in_range(a, lo, hi)     plain_assert((a) >= (lo) && (a) <= (hi))
#define fail_msg(...)                  do { printf(__VA_ARGS__); printf("\n"); _fail(__FILE__, __LINE__); } while (0)
#define fail()                         _fail(__FILE__, __LINE__)
#define skip()                         return
#define print_error                    printf
#define print_message                  printf
#define cmocka_unit_test(f)            { #f, f }
#define cmocka_run_group_tests(t, setup, teardown) \
    plain_run(t, sizeof(t) / sizeof *(t), teardown)

static inline int plain_run(const struct CMUnitTest *tests, size_t count, int (*teardown)(void **))
{
    size_t i;
    for (i = 0; i < count; i++) {
        const int before = plain_failures;
        tests[i].function(NULL);
        if (plain_failures != before) printf("FAILED %s\n", tests[i].name);
    }
    if (teardown && teardown(NULL)) plain_failures++;
    printf("%d tests, %d failures\n", (int)count, plain_failures);
    return plain_failures != 0;
}
#endif
