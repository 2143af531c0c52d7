#!/bin/sh
# make deps: installs what tests, benchmarks and demos need. The headers themselves need nothing.
# Debian and its kin: apt-get, as root or through sudo; silent when everything is there. Elsewhere: prints the list.
set -eu

# package, or package:command where any other provider of the command will do
need="
    gcc:gcc g++:g++ make:make clang:clang lld:wasm-ld cmake:cmake pkg-config:pkg-config git:git
    libcmocka-dev libgsl-dev libflint-dev libflint-arb-dev
    python3 python3-mpmath python3-numpy python3-scipy
    libpng-dev libstb-dev gnuplot-nox:gnuplot libboost-math-dev
    libepoxy-dev libegl-dev libegl1 libgl1-mesa-dri libglfw3-dev glslang-tools xvfb xauth libgl1 libopengl0
    qemu-user:qemu-aarch64 gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-mingw-w64-x86-64
    nodejs:node npm:npm
"

if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
    echo "No apt-get here. Tests, benchmarks and demos want these (Debian names) from your own package manager:"
    for entry in $need; do echo "    ${entry%%:*}"; done
    exit 0
fi

missing=
for entry in $need; do
    package=${entry%%:*}
    case $entry in *:*) command -v "${entry##*:}" >/dev/null 2>&1 && continue ;; esac
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) || status=
    [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

root=
if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null 2>&1 || { echo "make deps: as root, run: apt-get install$missing" >&2; exit 1; }
    root=sudo
fi
echo "make deps: installing$missing"
install="$root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends"
# shellcheck disable=SC2086
{ $install $missing || { $root apt-get update -qq && $install $missing; }; } >/dev/null
