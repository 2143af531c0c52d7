#!/bin/sh
# polygon_map.sh FILE.png - draws where each polygon call fails (docs/polygons.png): polygon_map.c by gnuplot.
set -eu
out=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
${CC:-cc} -std=gnu99 -O2 -I. -o "$work/map" bench/polygon_map.c -lm
for shape in triangle needle; do
    for call in 0 1 2 3; do "$work/map" $shape $call > "$work/$shape$call"; done
done
gnuplot <<END
set terminal pngcairo size 1180,560 font "sans,10" background "white"
set output "$out"
set multiplot layout 2,4 margins 0.075,0.915,0.1,0.92 spacing 0.014,0.04
set cbrange [-8:0]
set palette maxcolors 8 defined (0 '#0b3c5d', 1 '#1f6f8b', 2 '#4fa3a5', 3 '#a7d7c5', \
    4 '#f6f1c7', 5 '#f9c46b', 6 '#ee7f43', 7 '#c22e2e', 8 '#5c0f1e')
set xrange [1:-6]
set yrange [-6:0]
set cbtics ("100 %%" 0, "10 %%" -1, "1 %%" -2, "1e-3" -3, "1e-4" -4, "1e-5" -5, \
    "1e-6" -6, "1e-7" -7, "1e-8" -8) font ",9"
unset key
array title[4] = ["sh_polygon", "sh_polygons_n", "WR18: sh_polygons_zonal_n", "sh_triangle_as_sphere"]
do for [row = 0:1] {
    do for [c = 0:3] {
        unset title
        unset xlabel
        unset ylabel
        unset colorbox
        set xtics ("" 1, "" 0, "" -1, "" -2, "" -3, "" -4, "" -5) scale 0.4
        set ytics ("" 0, "" -1, "" -2, "" -3, "" -4, "" -5) scale 0.4
        if (row == 0) { set title title[c + 1] noenhanced font ",12" offset 0,-0.6 }
        if (row == 1) {
            set xlabel "size / distance" offset 0,0.5
            set xtics ("10" 1, "1" 0, "0.1" -1, "0.01" -2, "1e-3" -3, "1e-4" -4, "1e-5" -5) \
                scale 0.4 font ",9"
        }
        if (c == 0) {
            set ytics ("90°" 0, "6°" -1, "0.6°" -2, "0.06°" -3, "1e-4" -4, "1e-5" -5, "1e-6" -6) \
                scale 0.4 font ",9"
            set ylabel (row == 0 ? "triangle: angle to its plane" : "needle 1:1000: angle to its plane") \
                offset 1,0
        }
        if (row == 1 && c == 3) { set colorbox user origin 0.925,0.1 size 0.014,0.82 }
        plot "$work/".(row == 0 ? "triangle" : "needle").c using 1:2:3 with image
    }
}
END
