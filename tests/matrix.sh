#!/bin/sh
# The headers in every language, compiler and instruction set they are written for.
#     tests/matrix.sh quick|full [BUILD]        from the top folder; stops at the first failure and says which line it was
# quick is a part of `make test`; full is `make test-matrix`. A compiler that is not there is a SKIP line, never silence.
set -eu
size=${1:-quick}
work=${2:-build}/matrix
mkdir -p "$work"
W="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Wcast-align -Wundef -Werror"
headers=$(ls sh_*.h)
ref="-std=gnu99 -O2 -ffp-contract=off"

have() { command -v "$1" >/dev/null 2>&1; }
skip() { echo "SKIP $1: no $2"; }
fail() { echo "FAILED: $1" >&2; cat "$work/log" >&2 2>/dev/null || :; exit 1; }
try()  { "$@" >"$work/log" 2>&1 || fail "$*"; }

# ---- languages: each header alone, all together, as a user's warnings see them ----
languages() {
    for cc in gcc clang; do
        have $cc || { skip languages $cc; continue; }
        for std in c99 c11 c17; do
            for h in $headers; do
                printf '#include "%s"\n' "$h" >"$work/one.c"
                try $cc -std=$std $W -I. -fsyntax-only "$work/one.c"
            done
            try $cc -std=$std $W -I. -fsyntax-only "$work/all.c"
        done
        for opt in $optimised; do try $cc -std=c99 $W $opt -I. -c -o "$work/all.o" "$work/all.c"; done
    done
    for cc in g++ clang++; do
        have $cc || { skip languages $cc; continue; }
        for std in c++11 c++17 c++20; do
            for h in $headers; do
                printf '#include "%s"\n' "$h" >"$work/one.cpp"
                try $cc -std=$std $W -I. -fsyntax-only "$work/one.cpp"
            done
        done
        try $cc -std=c++11 $W -O1 -I. -c -o "$work/all-cpp.o" "$work/all.cpp"
        # every body compiled: where g++ drops an unrolling it says so, and calls would be five times slower than in C
        for h in $compiled; do
            printf '#define SH_API\n#include "%s"\n' "$h" >"$work/one.cpp"
            try $cc -std=c++11 $W -O2 -march=native -I. -c -o "$work/all-cpp.o" "$work/one.cpp"
        done
    done
    if have clang; then     # clang-cl: MSVC's target without __GNUC__, here with this system's libc headers, has vectors
        windows="--target=x86_64-pc-windows-msvc -isystem /usr/include -isystem /usr/include/$(gcc -dumpmachine)"
        try clang $windows -mavx2 -mfma -std=c99 $W -I. -fsyntax-only "$work/all.c"
        clang $windows -mavx2 -mfma -std=c99 -I. -E -dM "$work/all.c" | grep -q 'define SH_VECTOR_BYTES 32' || fail "clang-cl: no vectors"
    fi
    echo "ok languages: C99 C11 C17 C++11 C++17 C++20, $(echo "$headers" | wc -w) headers"
}

# ---- leaks: names and macros without our prefix, writable globals, two units in one program ----
leaks() {
    printf '#include <math.h>\n#include <stddef.h>\n#include <string.h>\n#include <float.h>\n#include <limits.h>\n' >"$work/std.c"
    gcc -std=c99 -E -dM "$work/std.c" | sort >"$work/std.macros"
    gcc -std=c99 -E -dM -I. "$work/all.c" | sort >"$work/all.macros"
    comm -13 "$work/std.macros" "$work/all.macros" | awk '$2 !~ /^(SH_|SHI_)/' >"$work/log"
    [ ! -s "$work/log" ] || fail "macros without the prefix SH_ or SHI_"
    # every name a translation unit gets to see: functions, types, variables, enumeration constants
    if have clang; then
        for unit in std all; do
            clang -std=c99 -w -I. -fsyntax-only -Xclang -ast-dump -fno-color-diagnostics "$work/$unit.c" |
                awk '/^[|`]-(Function|Typedef|Record|Enum|Var)Decl / || /^[| ] [|`]-EnumConstantDecl / {
                    sub(/ \047.*/, ""); sub(/ definition$/, "");
                    if ($NF !~ /^(struct|union|<.*|.*>|col:.*|line:.*|invalid)$/) print $NF }' | grep -v '^__builtin' | sort -u >"$work/$unit.names"
        done
        comm -13 "$work/std.names" "$work/all.names" >"$work/names"
        grep -qx sh_eval_f32 "$work/names" || fail "the list of names did not see sh_eval_f32"
        grep -vE '^(sh_|SH_|shi_|SHI_)' "$work/names" >"$work/log" && fail "names without the prefix sh_, SH_ or shi_"
    else skip names clang; fi
    # tables must be read-only: nothing in .data or .bss (address tables live in .data.rel.ro)
    printf '#define SH_API\n#include "all.c"\n' >"$work/open.c"
    gcc -std=c99 -O1 -fPIC -fkeep-static-consts -I. -c -o "$work/open.o" "$work/open.c"
    objdump -t "$work/open.o" | awk '$4 ~ /^\.(data|bss|tdata|tbss)$/ && $NF !~ /^\./ || / \*COM\* /' >"$work/log"
    [ ! -s "$work/log" ] || fail "writable global data"
    nm "$work/open.o" | grep -q ' T sh_eval_f32' || fail "nm did not see sh_eval_f32"
    nm -g --defined-only "$work/open.o" | awk '$3 !~ /^shi?_/' >"$work/log"
    [ ! -s "$work/log" ] || fail "external names without the prefix"
    # two units: static inline by default
    printf '#include "all.c"\nint second(float *y);\nint second(float *y) { float d[3] = {0, 0, 1}; return sh_eval_f32(2, d, y); }\n' >"$work/b.c"
    printf '#include "all.c"\nint second(float *y);\nint main(void) { float y[4], z[4], d[3] = {0, 0, 1};\n return sh_eval_f32(2, d, y) || second(z) || memcmp(y, z, sizeof y); }\n' >"$work/a.c"
    try gcc -std=c99 $W -O1 -I. "$work/a.c" "$work/b.c" -o "$work/two" -lm
    try "$work/two"
    # widths that the target does not have are refused by name
    for width in -DSH_VECTOR_BYTES=8 "-DSH_VECTOR_BYTES=16 -DSH_WIDE_BYTES=64" "-DSH_VECTOR_BYTES=0 -DSH_WIDE_BYTES=16"; do
        gcc -std=gnu99 $width -I. -fsyntax-only "$work/all.c" 2>&1 | grep -q '#error "SH_[A-Z]*_BYTES' || fail "$width is taken"
    done
    echo "ok leaks: macros, names, writable data, two translation units, widths"
}

# ---- instruction sets: the tests' own bounds, compiled again ----
# run NAME EFFORT COMMAND...: build tests/$t.c with it and run it, for every test in $suite; two builds at a time
run() {
    name=$1; effort=$2; shift 2
    SH_TEST_EFFORT=$effort; export SH_TEST_EFFORT
    set -- "$@" $W -Wno-double-promotion -I. -Itests $cmocka      # long double references; the headers are checked above
    for t in $suite; do
        "$@" -o "$work/$name-$t" "tests/$t.c" $helpers $libs -lm >"$work/$name-$t.log" 2>&1 &
        builds="$builds $!"
        case $builds in *" "*" "*) wait_builds ;; esac
    done
    wait_builds
    for t in $suite; do
        [ -x "$work/$name-$t" ] || { cp "$work/$name-$t.log" "$work/log"; fail "$* tests/$t.c"; }
        try $emulator "$work/$name-$t"
        rm -f "$work/$name-$t" "$work/$name-$t.log"
    done
    echo "ok $name:" $suite
}
builds=
wait_builds() { wait $builds || :; builds=; }

helpers_with() {      # helpers_with NAME COMMAND...: the references compiled by that compiler
    name=$1; shift
    helpers="$work/$name-ref.o $work/$name-report.o"
    for h in ref report; do try "$@" $cmocka -Itests -c -o "$work/$name-$h.o" "tests/$h.c"; done
}

isas() {
    suite=$1 emulator= cmocka= libs=-lcmocka
    helpers_with host gcc $ref
    run gcc-scalar 0.2 gcc -std=c99 -O1 $few -DSH_VECTOR_BYTES=0
    run gcc-sse2 0.2 gcc -std=gnu11 -O1 $few -msse2
    if grep -qw avx2 /proc/cpuinfo 2>/dev/null && grep -qw fma /proc/cpuinfo; then
        run gcc-avx2 0.2 gcc -std=gnu99 -O1 $few -mavx2 -mfma
    else skip gcc-avx2 "avx2 and fma"; fi
    if [ "$size" = full ]; then
        run gcc-native-O3 0.5 gcc -std=gnu99 -O3 -march=native
        run gcc-O0 0.1 gcc -std=gnu99 -O0 $few
        run gcc-nocontract 0.2 gcc -std=gnu99 -O2 -march=native -ffp-contract=off
        # the bodies that `make sanitize` leaves out: unrolled, in the widest lanes
        suite=test_gradient_basis
        run gcc-native-sanitized 0.1 gcc -std=gnu99 -O1 -march=native -fsanitize=address,undefined -fno-sanitize-recover=all
        suite=$1
        for bytes in 16 32; do run gcc-native-$bytes 0.1 gcc -std=gnu99 -O2 $few -march=native -DSH_VECTOR_BYTES=$bytes; done
    fi
    if have clang; then
        run clang-native 0.2 clang -std=gnu17 -O1 $few -march=native
        if [ "$size" = full ]; then
            run clang-native-O3 0.2 clang -std=gnu17 -O3 -march=native
            run clang-sse2 0.2 clang -std=c99 -O2 $few
            run clang-scalar 0.1 clang -std=c99 -O2 $few -DSH_VECTOR_BYTES=0
        fi
    else skip clang-native clang; fi
}

# NaN and Inf must be seen, and degenerate input defined, where the compiler may assume that there are none; signs of
# zeros must not matter
fast_math() {
    suite="test_gradient_errors test_gradient_basis test_gradient_lights" emulator= cmocka= libs=-lcmocka
    helpers_with host gcc $ref
    run gcc-fast-math 0.2 gcc -std=gnu99 -O1 $few -march=native -ffast-math
    run gcc-fast-math-scalar 0.2 gcc -std=gnu99 -O1 $few -ffast-math -DSH_VECTOR_BYTES=0
    suite=test_gradient_errors
    if have clang; then run clang-fast-math 1 clang -std=gnu99 -O1 $few -march=native -ffast-math; else skip clang-fast-math clang; fi
}

others() {
    suite=$1 cmocka=-Itests/plain libs=
    if have aarch64-linux-gnu-gcc && have qemu-aarch64; then
        emulator=qemu-aarch64
        helpers_with aarch64 aarch64-linux-gnu-gcc $ref
        case $suite in *interp*)      # all of them
            echo "SKIP aarch64 test_gradient_lights: long double is software there, and that in qemu takes over ten minutes"
            suite=$(echo "$suite" | grep -v test_gradient_lights) ;;
        esac
        run aarch64 0.02 aarch64-linux-gnu-gcc -std=gnu99 -O1 $few -static
        emulator=
    else skip aarch64 "aarch64-linux-gnu-gcc and qemu-aarch64"; fi
    if have x86_64-w64-mingw32-gcc; then
        for std in c99 gnu17; do try x86_64-w64-mingw32-gcc -std=$std $W -O1 -I. -c -o "$work/all.obj" "$work/all.c"; done
        for before in windows.h complex.h; do       # which define near, far, small, I ...
            try x86_64-w64-mingw32-gcc -std=gnu99 $W -O1 $few -I. -include $before -c -o "$work/all.obj" "$work/all.c"
        done
        echo "ok mingw: compiles, after windows.h and complex.h too"
    else skip mingw x86_64-w64-mingw32-gcc; fi
}

: >"$work/all.c"
for h in $headers; do printf '#include "%s"\n' "$h" >>"$work/all.c"; done
cp "$work/all.c" "$work/all.cpp"
optimised="-O0 -O2"
compiled=sh_gradient.h
few=-DSH_UNROLLED_BANDS=3     # the unit tests themselves run with every body, at this machine's best
gradient="test_gradient_errors test_gradient_basis test_gradient_lights"
case $size in
quick)
    languages; leaks; isas "$gradient"; fast_math; others test_gradient_errors ;;
full)
    optimised="-O0 -O1 -O2 -O3"
    compiled=$headers
    all=$(cd tests && ls test_*.c | sed 's/\.c$//' | grep -v test_reference)
    languages; leaks; isas "$all"; fast_math; others "$all" ;;
languages|leaks|fast_math) $size ;;
isas|others) $size "$gradient" ;;
*) echo "usage: tests/matrix.sh quick|full|languages|leaks|isas|fast_math|others [BUILD]" >&2; exit 2 ;;
esac
rm -f "$work/log"
