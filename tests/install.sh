#!/bin/sh
# Installs with make and with cmake, and uses each way of finding the library from a folder outside the tree.
#     tests/install.sh [BUILD]
set -eu
top=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r tests/consumer "$work/consumer"
fail() { echo "FAILED: install: $1" >&2; cat "$work/log" >&2 2>/dev/null || :; exit 1; }
try()  { "$@" >"$work/log" 2>&1 || fail "$*"; }
version=$(sed -n 's/^# *define SH_VERSION_[A-Z]* *\([0-9]*\).*/\1/p' sh_gradient.h | paste -sd.)

try make install PREFIX="$work/by make"
listing() { (cd "$1" && find . -type f | sort); }
listing "$work/by make" >"$work/files"
for h in sh_*.h; do grep -qx "./include/shlight/$h" "$work/files" || fail "make install left out $h"; done

if command -v pkg-config >/dev/null; then
    make install PREFIX="$work/prefix" >"$work/log" 2>&1 || fail "make install"
    PKG_CONFIG_PATH="$work/prefix/lib/pkgconfig"; export PKG_CONFIG_PATH
    [ "$(pkg-config --modversion shlight)" = "$version" ] || fail "pkg-config says version $(pkg-config --modversion shlight), not $version"
    # shellcheck disable=SC2046
    (cd "$work/consumer" && try cc -O1 main.c $(pkg-config --cflags --libs shlight) -o "$work/consumer-pc")
    [ "$("$work/consumer-pc")" = "$version" ] || fail "the pkg-config consumer"
    echo "ok install: pkg-config, version $version"
else echo "SKIP install: no pkg-config"; fi

if command -v cmake >/dev/null; then
    try cmake -S . -B "$work/b" -DCMAKE_INSTALL_PREFIX="$work/by cmake"
    try cmake --install "$work/b"
    listing "$work/by cmake" >"$work/files2"
    cmp -s "$work/files" "$work/files2" || fail "make install and cmake --install differ: $(diff "$work/files" "$work/files2")"
    for use in "CMAKE_PREFIX_PATH=$work/by cmake" "CMAKE_PREFIX_PATH=$work/by make" "SHLIGHT_SOURCE=$top"; do
        rm -rf "$work/cb"
        try cmake -S "$work/consumer" -B "$work/cb" "-D$use" -DSHLIGHT_VERSION="$version"
        try cmake --build "$work/cb"
        [ "$("$work/cb/consumer")" = "$version" ] || fail "the consumer with $use"
    done
    rm -rf "$work/cb"
    if cmake -S "$work/consumer" -B "$work/cb" "-DCMAKE_PREFIX_PATH=$work/by make" -DSHLIGHT_VERSION=99 >"$work/log" 2>&1; then
        fail "version 99 was found"
    fi
    echo "ok install: cmake, find_package and add_subdirectory"
else echo "SKIP install: no cmake"; fi
