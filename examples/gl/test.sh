#!/bin/sh
# test.sh FOLDER - the GL example: its shader files in every dialect, grid and picture against the CPU, bad input, a window
set -eu
build=$1 gl=${0%/*} out=$1/test-gl.d
mkdir -p "$out"

skip() { echo "SKIP: $1: $2"; }
fail() { echo "FAIL: $1"; exit 1; }

# ---- the shader files compile: sh.glsl alone in four dialects, every program as the passes define it ----

# dialect VERSION BANDS: a fragment shader that calls all of sh.glsl
dialect()
{
    { printf '#version %s\nprecision highp float;\nprecision highp int;\n#define SH_BANDS %d\n' "$1" "$2"
      cat "$gl/sh.glsl" "$gl/polygon.glsl"
      cat <<'END'
uniform vec3 p;
out vec4 colour;
void main()
{
    float y[SH_N], o[SH_N], g[SH_BANDS], dg[SH_BANDS];
    vec3 grad[SH_N];
    vec4 w[8];
    sh_eval(normalize(p), y);
    sh_cosine_product(normalize(p.zxy), y, o);
    sh_eval_grad(p, y, grad);
    sh_sphere(p, p.yzx, 0.1, o, grad);
    sh_triangle_as_sphere(p, p.yzx, p.zxy, p.xzy, y, grad);
    sh_sphere_weights(p.x, p.y, g, dg);
    sh_cosine_zonal(normalize(p), normalize(p.yzx), g, o);
    sh_grid_weights(SH_EDGE_HERMITE, fract(p), p, w);
    colour = w[0] + vec4(o[0], y[SH_N - 1] * sh_diffuse_zonal(0), grad[0].xy);
    sh_triangle(p, p.yzx, p.zxy, p.xzy, y, grad);
    colour += vec4(grad[SH_N - 1], y[SH_N - 1]);
}
END
    } > "$out/dialect.frag"
    glslangValidator "$out/dialect.frag" > "$out/log" || { cat "$out/log"; fail "sh.glsl, GLSL $1, $2 bands"; }
}

# program STAGE DEFINES FILES...
program()
{
    stage=$1 defines=$2; shift 2
    { printf '#version 450 core\n'; printf "$defines"; for f; do cat "$gl/$f"; done; } > "$out/program.$stage"
    glslangValidator "$out/program.$stage" > "$out/log" || { cat "$out/log"; fail "$* with $defines"; }
}

if command -v glslangValidator > /dev/null; then
    for version in "330 core" "450 core" "300 es" "310 es"; do
        for bands in 1 2 3 4 5 6 7 8 9; do dialect "$version" $bands; done
    done
    for n in 3 6 9; do
        define="#define SH_BANDS $n\n"
        for form in 0 1 2 3; do
            for triangles in 0 1; do
                program comp "$define#define FORM $form\n#define TRIANGLES $triangles\n" sh.glsl polygon.glsl grid.comp
            done
        done
        program comp "$define#define FORM 4\n#define TRIANGLES 0\n" sh.glsl polygon.glsl grid.comp
        define="#define SH_BANDS 9\n#define LIGHT_BANDS $n\n"
        for pixel in 0 1; do program frag "$define#define PER_PIXEL $pixel\n" sh.glsl polygon.glsl shade.frag; done
    done
    for flag in 0 1; do
        program vert "#define LIGHTS $flag\n" surface.vert
        program frag "#define BLUR $flag\n" occlusion.frag
    done
    for n in 1 2; do program frag "#define SAMPLES $n\n" final.frag; done
    program frag "" surface.frag; program vert "" whole.vert; program vert "" text.vert; program frag "" text.frag
    # and in a compute shader of GLSL ES 3.10
    { printf '#version 310 es\nprecision highp float;\n'; cat "$gl/sh.glsl" "$gl/polygon.glsl"
      cat <<'END'
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer B { float b[]; };
void main()
{
    float y[SH_N];
    vec3 g[SH_N];
    sh_sphere(vec3(0.0), vec3(b[0], 1.0, 2.0), 0.5, y, g);
    b[0] = y[0] + g[1].x;
    sh_triangle(vec3(0.0), vec3(b[0], 1.0, 2.0), vec3(1.0), vec3(2.0, 1.0, 1.0), y, g);
    b[1] = y[0] + g[1].x;
}
END
    } > "$out/es.comp"
    glslangValidator "$out/es.comp" > "$out/log" || { cat "$out/log"; fail "sh.glsl in a GLSL ES 3.10 compute shader"; }
    echo "ok   shader files compile: GLSL 3.30, 4.50, ES 3.00 (WebGL2), ES 3.10"
else
    skip "shader files in every dialect" "no glslangValidator (Debian: glslang-tools)"
fi

# ---- bad input ----

if [ ! -x "$build/gl-demo" ] || [ ! -x "$build/test-gl" ]; then
    skip "GL example" "not built: pkg-config finds no epoxy or glfw3 (Debian: libepoxy-dev libglfw3-dev)"; exit 0
fi
refuses()
{
    message=$1; shift
    code=0; "$build/gl-demo" "$@" > "$out/stdout" 2> "$out/stderr" || code=$?
    if [ $code -ne 2 ] || ! grep -q -- "$message" "$out/stderr"; then
        cat "$out/stderr"; fail "gl-demo $*: exit code $code, expected 2 and '$message'"
    fi
}
refuses "takes a number from 3 to 9"  --bands 10
refuses "takes a number from 1"       --lights 0
refuses "takes WIDTHxHEIGHT"          --size 320
refuses "does not know 'cubes'"       --kind cubes
refuses "takes a value"               --grid
refuses "unknown option"              --verbose
"$build/gl-demo" --help | grep -q -- "--window" || fail "gl-demo --help"
echo "ok   bad command lines are refused"

# ---- no OpenGL: exactly what is missing, and exit code 77 ----

# misses MESSAGE COMMAND...
misses()
{
    message=$1; shift
    code=0; "$@" > /dev/null 2> "$out/stderr" || code=$?
    if [ $code -ne 77 ] || ! grep -q -- "$message" "$out/stderr"; then
        cat "$out/stderr"; fail "$*: exit code $code, expected 77 and '$message'"
    fi
}
misses "GLFW: .*DISPLAY" env -u DISPLAY -u WAYLAND_DISPLAY "$build/gl-demo" --window
misses "no OpenGL 4.5 core context" env MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330 \
    "$build/gl-demo"
misses "no headless OpenGL: " env __EGL_VENDOR_LIBRARY_FILENAMES=/nothing "$build/gl-demo"
echo "ok   without a display, OpenGL 4.5 or an EGL driver: said, exit code 77"

# ---- grid and picture ----

code=0
"$build/test-gl" 2> "$out/stderr" || code=$?
if [ $code -eq 77 ]; then skip "GL example" "$(head -n 1 "$out/stderr")"; exit 0; fi
[ $code -eq 0 ] || { cat "$out/stderr"; fail "test-gl"; }

small="--quick --lights 64 --size 320x240 --lobe 5"
"$build/gl-demo" $small --samples 1 --out "$out/demo.png" > "$out/stdout" || { cat "$out/stdout"; fail "gl-demo"; }
grep "grid, moments" "$out/stdout"
[ -s "$out/demo.png" ] || fail "gl-demo wrote no picture"

# ---- the window: three frames, then every key ----

if command -v xvfb-run > /dev/null; then
    in_window() { xvfb-run -a -s "-screen 0 640x480x24" "$build/gl-demo" --window $small --out "$out/window.png" "$@"; }
    in_window --frames 3 2> "$out/stderr" || { cat "$out/stderr"; fail "gl-demo --window under Xvfb"; }
    [ -s "$out/window.png" ] || fail "gl-demo --window wrote no picture"
    small="--quick --lights 16 --size 96x96 --bands 3 --lobe 3"
    in_window --frames 26 --keys "kkfffsssserorohh bBgGlL" > "$out/stdout" 2> "$out/stderr" ||
        { cat "$out/stderr"; fail "gl-demo --window --keys"; }
    echo "ok   a window of three frames under Xvfb, and one with every key pressed"
else
    skip "window" "no xvfb-run (Debian: xvfb)"
fi
