#!/bin/sh
# plot.sh CSV FOLDER - writes FOLDER/bench-*.svg from the benchmark's CSV with gnuplot; without it says so and ends.
set -eu
csv=$1
out=$2
if ! command -v gnuplot >/dev/null 2>&1; then
    echo "bench/plot.sh: gnuplot is not installed, no plots" >&2
    exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# rows SUITE KERNEL IMPL [X]: "x ns" of the f32 rows; X is bands (default) or items
rows() {
    awk -F, -v s="$1" -v k="$2" -v i="$3" -v x="${4:-bands}" \
        '$1 == s && $2 == k && $3 == i && $4 == "f32" { print (x == "bands" ? $5 : $6), $9 }' "$csv"
}

# speedup SUITE KERNEL BASE IMPL: "bands ratio"
speedup() {
    rows "$1" "$2" "$3" > "$work/base"
    rows "$1" "$2" "$4" | awk -v base="$work/base" \
        'BEGIN { while ((getline line < base) > 0) { split(line, f, " "); b[f[1]] = f[2] } }
         $1 in b { print $1, b[$1] / $2 }'
}

# the same colour for an implementation in every plot; others take theirs in turn
colour() {
    case $1 in
    polynomial) echo "#999999" ;;
    sloan | sloan_like) echo "#d55e00" ;;
    direct) echo "#e69f00" ;;
    library) echo "#0072b2" ;;
    library_n) echo "#56b4e9" ;;
    library_blocks) echo "#009e73" ;;
    esac
}

# draw FILE TITLE XLABEL YLABEL LOG FILES...: one curve per data file, named after it
draw() {
    file=$1 title=$2 x=$3 y=$4 log=$5
    shift 5
    curves=
    for f in "$@"; do
        [ -s "$f" ] || continue
        name=$(basename "$f")
        lc=$(colour "$name")
        curves="$curves${curves:+, }'$f' with linespoints lw 2 pt 7 ps 0.6 ${lc:+lc rgb '$lc'} title '$(echo "$name" | tr _ ' ')'"
    done
    [ -n "$curves" ] || return 0
    gnuplot <<EOF
set terminal svg size 840,440 font "sans,13" background "white"
set output "$out/bench-$file.svg"
set title "$title"
set xlabel "$x"
set ylabel "$y"
set key outside right top reverse Left samplen 2
set grid lc rgb "#dddddd"
set linetype cycle 8
set for [i = 1:8] linetype i lc rgb word("#0072b2 #d55e00 #009e73 #cc79a7 #56b4e9 #e69f00 #000000 #999999", i)
$(case $x in bands) echo "set xtics 1" ;; esac)
$log
plot $curves
EOF
    echo "$out/bench-$file.svg"
}

for kernel in values gradient hessian reconstruct project angles; do
    d=$work/$kernel
    mkdir "$d" "$d/ratio"
    base=$(case $kernel in values | reconstruct | project) echo sloan ;; hessian) echo polynomial ;; *) echo sloan_like ;; esac)
    for impl in polynomial sloan direct sloan_like library library_n library_blocks; do
        rows basis $kernel $impl > "$d/$impl"
        speedup basis $kernel "$base" $impl > "$d/ratio/$impl"
    done
    draw "basis-$kernel" "basis $kernel, f32" bands "ns per direction" "set logscale y" \
        "$d"/polynomial "$d"/sloan "$d"/direct "$d"/sloan_like "$d"/library "$d"/library_n "$d"/library_blocks
    draw "basis-$kernel-speedup" "basis $kernel, f32: times faster than $(echo $base | tr _ ' ')" bands ratio "set yrange [0:*]" \
        "$d"/ratio/library "$d"/ratio/library_n "$d"/ratio/library_blocks "$d"/ratio/polynomial
done

mkdir "$work/lights" "$work/ratio" "$work/polygon" "$work/product"
for kernel in values gradient hessian; do
    rows lights $kernel per_light > "$work/lights/${kernel}_per_light"
    rows lights $kernel library > "$work/lights/${kernel}_library"
    speedup lights $kernel per_light library > "$work/ratio/$kernel"
done
draw lights "648 sphere lights at a point, f32" bands "ns per light" "set logscale y" "$work"/lights/*
draw lights-speedup "sphere lights, f32: times faster than one light after the other" bands ratio "set yrange [0:*]" "$work"/ratio/*

for impl in monomial wang_ramamoorthi library; do
    for kernel in values gradient; do rows polygon $kernel $impl > "$work/polygon/${kernel}_$impl"; done
done
draw polygon "a triangle seen from many points, f32" bands "ns per point" "set logscale y" "$work"/polygon/*

for impl in triple zonal zonal3 world world_rotated world_n world_rotated_n; do
    rows product clamped_cosine $impl > "$work/product/$impl"
done
draw product "clamped-cosine product, f32" bands "ns per vector" "set logscale y" "$work"/product/*

mkdir "$work/interp"
for scheme in trilinear half_taylor blended_taylor hermite_zero hermite_mixed edge_hermite; do
    rows interp $scheme library > "$work/interp/$scheme"
done
draw interp "coefficients between the nodes of a grid, f32" bands "ns per query" "set logscale y" "$work"/interp/*

# Whole grids: cost by the number of lights and of nodes (M22 Fig. 13, 14). ns per item times items, in ms.
for by in lights nodes; do
    mkdir "$work/grid_$by"
    for kernel in values gradient; do
        for impl in library library_threads; do
            rows grid_$by $kernel $impl items | awk '{ print $1, $1 * $2 * 1e-6 }' > "$work/grid_$by/${kernel}_$impl"
        done
    done
    case $by in lights) over="a grid of 8 x 8 x 8 nodes" ;; *) over="a grid lit by 648 lights" ;; esac
    draw "grid-$by" "$over, 5 bands, f32" "$by" ms "set logscale xy" "$work"/grid_$by/*
done
