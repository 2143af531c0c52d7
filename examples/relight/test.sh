#!/bin/sh
# test.sh PROGRAM FOLDER - the relight example: its answers to bad input, OBJ in all its forms, its table
set -eu
relight=$1 out=$2/test-relight
mkdir -p "$out"
quick="--quick --size 64x36"

# refuses MESSAGE ARGUMENTS...: exit code 2 and the message
refuses()
{
    message=$1; shift
    code=0; "$relight" "$@" >"$out/stdout" 2>"$out/stderr" || code=$?
    if [ $code -ne 2 ] || ! grep -q -- "$message" "$out/stderr"; then
        echo "FAIL: relight $*: exit code $code, expected 2 and '$message'; it said:"; cat "$out/stderr"; exit 1
    fi
}

# obj TEXT: a file of that text
obj() { printf "$1" >"$out/test.obj"; }

refuses "takes a number from 1"     --lights 0
refuses "takes a number from 2"     --grid 1
refuses "takes a number from 1 to 9" --bands 10
refuses "takes a number"            --lights many
refuses "takes WIDTHxHEIGHT"        --size 64
refuses "takes y or z"              --up x
refuses "takes a value"             --mesh
refuses "unknown option"            --verbose
refuses "cannot open"               --mesh "$out/missing.obj"
refuses "cannot"                    --mesh "$out"
refuses "cannot write"              $quick --lights 9 --bands 1 --out "$out/missing/demo"
obj '';                                  refuses "holds no face"           --mesh "$out/test.obj"
obj 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';       refuses "holds no face"           --mesh "$out/test.obj"
obj 'v 0 0\n';                           refuses "obj:1: three numbers"    --mesh "$out/test.obj"
obj 'v 0 0 nan\n';                       refuses "obj:1: three numbers"    --mesh "$out/test.obj"
obj 'v 0 0 0\nv 1 0 0\nf 1 2 3\n';       refuses "obj:3: position 3 of 2"  --mesh "$out/test.obj"
obj 'v 0 0 0\nv 1 0 0\nf 1 2 0\n';       refuses "obj:3: position 0 of 2"  --mesh "$out/test.obj"
obj 'v 0 0 0\nv 1 0 0\nf 1 2 -3\n';      refuses "obj:3: position -3 of 2" --mesh "$out/test.obj"
obj 'v 0 0 0\nv 1 0 0\nf 1 2\n';         refuses "three corners or more"   --mesh "$out/test.obj"
obj 'v 0 0 0\nv 1 0 0\nf 1 2 x\n';       refuses "a face corner is"        --mesh "$out/test.obj"
obj 'v 0 0 0\nv 1 0 0\nf 1/ 2/ 1/\n';      refuses "a face corner is"        --mesh "$out/test.obj"
obj 'v 0 0 0\nv 1 0 0\nf 1//1 2 1\n';    refuses "normal 1 of 0"           --mesh "$out/test.obj"
obj 'v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n'; refuses "no extent"            --mesh "$out/test.obj"
obj 'v 0 0 0\0';                         refuses "zero byte"               --mesh "$out/test.obj"

# one tetrahedron in every form of index gives one picture
n='vn 0 -1 0\nvn -1 0 0\nvn 0 0 -1\nvn 1 1 1\n'
v='v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\n'
for faces in 'f 1//1 2//1 4//1\nf 1//2 4//2 3//2\nf 1//3 3//3 2//3\nf 2//4 3//4 4//4\n' \
             'f 1/1/1 2/1/1 4/1/1\r\nf 1/1/2\t4/1/2 3/1/2 \r\nf 1/1/3 3/1/3 2/1/3\r\nf 2/1/4 3/1/4 4/1/4' \
             '# negative\nf -4//-4 -3//-4 -1//-4\nf -4//-3 -1//-3 -2//-3\nf -4//-2 -2//-2 -3//-2\nf -3//-1 -2//-1 -1//-1\n' \
             '# clockwise\nf 1//1 4//1 2//1\nf 1//2 3//2 4//2\nf 1//3 2//3 3//3\nf 2//4 4//4 3//4\n'
do
    obj "$v$n$faces"
    "$relight" $quick --lights 50 --bands 3 --mesh "$out/test.obj" --out "$out/form" >/dev/null
    [ -f "$out/first.png" ] || cp "$out/form.png" "$out/first.png"
    cmp "$out/first.png" "$out/form.png"
done
rm "$out/first.png"

# spheres alone
"$relight" $quick --no-moon --lights 50 --bands 3 --out "$out/moonless" >"$out/moonless.txt"
grep -q "^50 spheres, 3 bands" "$out/moonless.txt" || { echo "FAIL: relight --no-moon"; cat "$out/moonless.txt"; exit 1; }

# the same bits from one thread and from several; edge Hermite on 8^3 nodes beats trilinear on 16^3
"$relight" $quick --threads 1 --out "$out/one" >"$out/one.txt"
"$relight" $quick --threads 3 --out "$out/three" >"$out/three.txt"
cmp "$out/one.png" "$out/three.png"
cmp "$out/one-error.png" "$out/three-error.png"
awk '/^trilinear +16\^3/ { linear = $5 } /^edge Hermite +8\^3/ { n++; if (!($6 > 0 && $6 < linear)) bad = 1
     printf "relight: error/1000 of edge Hermite 8^3 %s, of trilinear 16^3 %s\n", $6, linear } END { exit bad || n != 2 }' "$out/one.txt" ||
    { echo "FAIL: relight: edge Hermite on 8^3 nodes does not beat trilinear on 16^3"; exit 1; }
awk '/^a square/ { fine = $8 } /^the square/ { n++; if (!(fine > 0 && fine < $8 / 4)) bad = 1
     printf "relight: error/1000 of 50 triangles as spheres %s, of 2 %s\n", fine, $8 } END { exit bad || n != 1 }' "$out/one.txt" ||
    { echo "FAIL: relight: small triangles are not better spheres than large ones"; exit 1; }
echo "relight: ok"
