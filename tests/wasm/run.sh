#!/bin/sh
# Compile check.c for WebAssembly SIMD with clang, see that the vectors are there, run it in node. SKIP names what is missing.
set -eu
out=${1:-build/wasm}
mkdir -p "$out"
for tool in clang wasm-ld node; do
    command -v $tool >/dev/null 2>&1 || { echo "SKIP wasm: no $tool"; exit 0; }
done
here=$(dirname "$0")
# the two headers that a C library would bring, for what sh_gradient.h calls
cat >"$out/math.h" <<'H'
double sqrt(double); float sqrtf(float); double fabs(double); float fabsf(float);
double sin(double); float sinf(float); double cos(double); float cosf(float);
H
cat >"$out/string.h" <<'H'
#include <stddef.h>
void *memcpy(void *, const void *, size_t); void *memset(void *, int, size_t);
H
clang --target=wasm32 -msimd128 -std=gnu99 -O2 -fno-math-errno -Wall -Wextra -Werror -DSH_UNROLLED_BANDS=6 \
    -I"$out" -I"$here/../.." -nostdlib -Wl,--no-entry -o "$out/check.wasm" "$here/check.c"
cat >"$out/run.js" <<'J'
const bytes = require("fs").readFileSync(process.argv[2]);
WebAssembly.instantiate(bytes, {}).then(({ instance }) => {
    const worst = instance.exports.worst(), ok = worst >= 0 && worst < 40;
    console.log(`wasm simd128: worst error ${worst.toFixed(2)} eps (bound 40)  ${ok ? "ok" : "FAIL"}`);
    process.exit(ok ? 0 : 1);
});
J
node "$out/run.js" "$out/check.wasm"
