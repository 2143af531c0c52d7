#!/bin/sh
# sizes.sh BUILD HEADER... - lines and bytes of each header, how long a file that includes it takes to compile at -O2, the
# machine code each group of functions becomes, and the stack that calls take.
set -eu
build=$1
shift
cc=${CC:-cc}
work=$build/sizes
mkdir -p "$work"

seconds() { # of processor time, the least of three runs of a command
    for _ in 1 2 3; do
        sh -c '"$@"; times' seconds "$@" | awk 'NR == 2 { gsub(/[ms]/, " "); print $1 * 60 + $2 + $3 * 60 + $4 }'
    done | sort -n | head -n 1
}

text() { # bytes of machine code and constants in an object
    size "$1" | awk 'NR == 2 { print $1 }'
}

echo "$($cc --version | head -n 1), -O2"
printf '%-16s %7s %9s %12s\n' header lines bytes "compile s"
present=
for h in "$@"; do
    [ -f "$h" ] || continue
    present="$present $h"
    echo "#include \"$h\"" > "$work/one.c"
    printf '%-16s %7d %9d %12s\n' "$h" "$(wc -l < "$h")" "$(wc -c < "$h")" \
        "$(seconds $cc -O2 -I. -c -o "$work/one.o" "$work/one.c")"
done
for h in $present; do echo "#include \"$h\""; done > "$work/all.c"
printf '%-16s %7s %9s %12s   (target: < 0.5)\n' "all headers" "" "" "$(seconds $cc -O2 -I. -c -o "$work/all.o" "$work/all.c")"

# Public functions as external symbols, so that each can be kept alone: what a program pays for the groups it calls.
echo
printf '%-34s %12s %12s\n' "code of a group, f32 (bytes)" "-O2" "-O2 native"
group() { # NAME HEADER FUNCTION...
    name=$1 header=$2
    shift 2
    [ -f "$header" ] || return 0
    {
        echo "#include \"$header\""
        echo "void *const keep_$$[] = {"
        for f in "$@"; do echo "    (void *)${f}_f32,"; done
        echo "};"
    } > "$work/group.c"
    if ! $cc -O2 -w -I. -c -o "$work/group.o" "$work/group.c" 2>"$work/group.log"; then
        printf '%-34s %12s\n' "$name" "does not build"
        return 0
    fi
    plain=$(text "$work/group.o")
    $cc -O2 -march=native -w -I. -c -o "$work/group.o" "$work/group.c"
    printf '%-34s %12d %12d\n' "$name" "$plain" "$(text "$work/group.o")"
}
group "basis values"                 sh_gradient.h sh_eval sh_eval_n sh_eval_blocks
group "basis gradients"              sh_gradient.h sh_eval_grad sh_eval_grad_n sh_eval_grad_blocks
group "basis Hessians"               sh_gradient.h sh_eval_hessian sh_eval_hessian_n sh_eval_hessian_blocks
group "derivatives by angles"        sh_gradient.h sh_eval_angles sh_eval_angles_n
group "reconstruct, project"         sh_gradient.h sh_reconstruct sh_reconstruct_n sh_project_n
group "one sphere light"             sh_gradient.h sh_sphere
group "sums of sphere lights, grids" sh_gradient.h sh_spheres sh_spheres_n sh_spheres_grid
group "one polygon"                  sh_polygon.h sh_polygon
group "sums of polygons, grids"      sh_polygon.h sh_polygons sh_polygons_n sh_polygons_grid
group "interpolation"                sh_interp.h sh_grid_interp sh_grid_interp_n sh_grid_dot_n
group "rotation"                     sh_product.h sh_rotation_matrix sh_rotate
group "clamped-cosine product"       sh_product.h sh_cosine_product sh_cosine_product_n
group "triple product"               sh_product.h sh_triple_product

for option in "" -march=native; do
    echo
    printf '%-26s %5s %9s %9s\n' "stack, KiB, -O2 $option" bands f32 f64
    $cc -std=gnu11 -O2 $option -w -I. -o "$work/stack" bench/stack.c -lm -lpthread
    "$work/stack"
done
