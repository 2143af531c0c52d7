#!/bin/sh
# test.sh BUILD - the README's first program is first.c and prints what the README says; recipes.c gives what it should.
set -eu
build=$1
fail() { echo "FAILED: $*" >&2; exit 1; }
block() { awk -v n="$1" '/^```/ { inside = !inside; if (inside) at++; next } inside && at == n' README.md; }

block 1 >"$build/first.readme"
sed 1d examples/first/first.c | diff - "$build/first.readme" || fail "README.md shows another program than examples/first/first.c"
block 2 | sed 1d >"$build/first.readme"
"$build/first" | diff - "$build/first.readme" || fail "README.md shows other numbers than build/first prints"

"$build/recipes" | awk '
    $1 == "sky"    { up = $4 + 0; aside = $6 + 0; sky = up > 3.1316 && up < 3.1516 && aside > 1.5608 && aside < 1.5808 }
    $1 == "lights" { there = $NF; from = $6 + 0; lights = from > there * 0.9995 && from < there * 1.0005 }
    END { exit !(sky && lights) }' || fail "recipes: $("$build/recipes")"
echo "first and recipes: as the README says"
