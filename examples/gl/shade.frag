/* shade.frag - pass 2: the light at a pixel's place, by the grid or by all lights anew, and what leaves there.
 *
 * The light is an SH vector of LIGHT_BANDS bands per channel. It leaves by two dot products with transfer
 * vectors: the clamped cosine about the normal, less what the mesh hides of it; and the GGX lobe about the mirror
 * direction, of SH_BANDS bands, cut by the clamped cosine (MP21, Eq. 11: multiplying the lobe instead of the light
 * is the same, once instead of per channel) and divided by what the cut leaves of it, so that all of a white room
 * comes back. */
#define LIGHT_N (LIGHT_BANDS * LIGHT_BANDS)
#define HIDDEN_N 81                                                     /* what the shadows are stored with */

struct Material { vec3 albedo; float f0, f90, lobe[9]; };

layout(std430, binding = 2) readonly buffer Materials { Material materials[]; };
layout(std430, binding = 3) readonly buffer Hidden { float hidden[]; };        /* [mesh vertex][HIDDEN_N] */
layout(std430, binding = 4) readonly buffer Corners { int corners[]; };     /* [triangle][3]: mesh vertices */
layout(binding = 0) uniform sampler2D places;
layout(binding = 1) uniform sampler2D normals;
layout(binding = 2) uniform sampler2D inside;                           /* of the triangle: u, v, and which */
layout(binding = 3) uniform sampler2D occlusion;
layout(binding = 4) uniform samplerBuffer lights;                  /* [light][6]: struct Light of grid.comp */
layout(binding = 5) uniform samplerBuffer nodes;                        /* [node][coefficient][channel] */
uniform int spheres, light_count, scheme, terms;                   /* terms = LIGHT_N, a loop not to unroll */
uniform ivec3 count;
uniform vec3 origin, cell, eye;
uniform bool occluded, shadowed;
uniform vec2 turn;                                                      /* (cos, sin) of the mesh about z */
uniform int  turning;                                                   /* its triangles */
uniform ivec3 tiles;                                              /* the floor: columns, rows, first vertex */

layout(location = 0) out vec4 radiance;

float gloss[SH_N], diffuse[SH_N];                                       /* the transfer vectors */

/* Ray-traced shadows of the mesh at rest, at the vertices. With the mesh turns what it hides of itself, and
 * of the floor: there a turned shadow is the one at rest of the place turned back. The walls keep theirs. */
void shadows(vec3 place, bool floored, vec3 at)                         /* at: u, v, triangle */
{
    ivec3 corner;
    vec3 share = vec3(1.0 - at.x - at.y, at.xy);
    int first = 3 * int(at.z);
    bool moved = turn.y != 0.0 && (floored || int(at.z) < turning);
    if (floored) {                                               /* its tiles are cut from corner to corner */
        vec2 p = sh_times(vec2(turn.x, -turn.y), place.xy) - origin.xy;
        p = clamp(p / (cell.xy * vec2(count.xy - 1)) * vec2(tiles.xy), vec2(0.0), vec2(tiles.xy));
        ivec2 tile = min(ivec2(p), tiles.xy - 1);
        vec2 f = p - vec2(tile);
        int row = tiles.x + 1, a = tiles.z + tile.y * row + tile.x;
        corner = ivec3(a, f.x > f.y ? a + 1 : a + row, a + row + 1);
        share = vec3(1.0 - max(f.x, f.y), abs(f.x - f.y), min(f.x, f.y));
    } else
        corner = ivec3(corners[first], corners[first + 1], corners[first + 2]);
    float h[SH_N], whole = diffuse[0];
    for (int i = 0; i < SH_N; i++)
        h[i] = i >= LIGHT_N ? 0.0 : share.x * hidden[HIDDEN_N * corner.x + i]
             + share.y * hidden[HIDDEN_N * corner.y + i] + share.z * hidden[HIDDEN_N * corner.z + i];
    if (moved) sh_rotate_z(turn, h);
    for (int i = 0; i < LIGHT_N; i++) diffuse[i] -= h[i];
    float open = max(diffuse[0] / whole, 0.0);                 /* the part of the cosine that sees the room */
    for (int i = 0; i < LIGHT_N; i++) gloss[i] *= open;
}

void transfers(vec3 normal, vec3 mirror, const in float lobe[9])
{
    float g[SH_BANDS];
    for (int l = 0; l < SH_BANDS; l++) g[l] = lobe[l];
    sh_cosine_zonal(normal, mirror, g, gloss);
    float left = max(gloss[0] * sqrt(4.0 * SH_PI), 0.05);
    for (int i = 0; i < LIGHT_N; i++) gloss[i] /= left;
    sh_eval(normal, diffuse);
    for (int l = 0; l < LIGHT_BANDS; l++)
        for (int i = l * l; i < (l + 1) * (l + 1); i++) diffuse[i] *= sh_diffuse_zonal(l);
}

#if PER_PIXEL
/* What of a sphere leaves, diffuse and glossy: sum of g_l Y_lm(u) times the transfers; no coefficient is
 * kept. */
vec2 of_sphere(vec3 v, float radius)
{
    float weight[SH_BANDS], slope[SH_BANDS], distance = length(v);
    vec3 u = v / max(distance, 1e-30);
    vec2 e = vec2(1.0, 0.0), t = vec2(0.0);
    sh_sphere_weights(distance, radius, weight, slope);
    for (int m = 0; m < LIGHT_BANDS; m++) {
        sh_column c = sh_first(m);
        for (int l = m; l < LIGHT_BANDS; l++) {
            int k = l * (l + 1);
            float q = weight[l] * c.q;
            t += q * e.x * vec2(diffuse[k + m], gloss[k + m]);
            if (m > 0) t += q * e.y * vec2(diffuse[k - m], gloss[k - m]);
            sh_climb(c, sh_step(l + 1, m), u.z);
        }
        e = sh_times(e, u.xy);
    }
    return t;
}

/* The same of a triangle, exactly: along . grad Y is c.q times one and c.d times the other pair of numbers. */
vec2 of_triangle(sh_seen seen)
{
    vec2 t = seen.angle * SH_K[0] * vec2(diffuse[0], gloss[0]);
    for (int k = 0; k < 8 * seen.octets; k++) {
        sh_node p = sh_triangle_node(seen, k >> 3, k & 7);
        vec2 e = vec2(1.0, 0.0), e1 = vec2(0.0);
        for (int m = 0; m < LIGHT_BANDS; m++) {
            sh_column c = sh_first(m);
            vec2 across = float(m) * sh_times(p.along.xy, e1), up = p.along.z * e;
            for (int l = m; l < LIGHT_BANDS; l++) {
                int i = l * (l + 1);
                vec2 y = p.k * c.q * e + (c.q * across + c.d * up) / float(max(i, 1));
                t += y.x * vec2(diffuse[i + m], gloss[i + m]);
                if (m > 0) t += y.y * vec2(diffuse[i - m], gloss[i - m]);
                sh_climb(c, sh_step(l + 1, m), p.u.z);
            }
            e1 = e;
            e = sh_times(e, p.u.xy);
        }
    }
    return t;
}

void gather(vec3 point, out vec3 d, out vec3 g)
{
    d = vec3(0.0);
    g = vec3(0.0);
    for (int i = 0; i < light_count; i++) {
        vec3 rgb = texelFetch(lights, 6 * i + 1).rgb;
        vec2 t;
        if (i < spheres) {
            vec4 sphere = texelFetch(lights, 6 * i), triangle = texelFetch(lights, 6 * i + 2);
            t = of_sphere(sphere.xyz - point, sphere.w);
            if (triangle.w > 0.0) t *= abs(dot(triangle.xyz, normalize(sphere.xyz - point)));   /* one for the other */
        } else
            t = of_triangle(sh_triangle_of(LIGHT_BANDS, point, texelFetch(lights, 6 * i + 3).xyz,
                                           texelFetch(lights, 6 * i + 4).xyz, texelFetch(lights, 6 * i + 5).xyz));
        d += rgb * t.x;
        g += rgb * t.y;
    }
}
#else
/* Every scheme is a sum over the cell's corners: eight weights, then one dot product per corner and channel. */
void gather(vec3 point, out vec3 d, out vec3 g)
{
    vec4 w[8];
    vec3 p = clamp((point - origin) / cell, vec3(0.0), vec3(count - 1));
    ivec3 first = min(ivec3(p), count - 2);
    int at[8];
    sh_grid_weights(scheme, p - vec3(first), cell, w);
    for (int k = 0; k < 8; k++) {
        ivec3 c = first + ivec3(k & 1, k >> 1 & 1, k >> 2);
        at[k] = (c.x + count.x * (c.y + count.y * c.z)) * LIGHT_N * 3;
    }
    d = vec3(0.0);
    g = vec3(0.0);
    for (int i = 0; i < terms; i++) {
        vec3 c = vec3(0.0);
        for (int k = 0; k < 8; k++) {
            int j = at[k] + 3 * i;
            c += vec3(dot(w[k], texelFetch(nodes, j)), dot(w[k], texelFetch(nodes, j + 1)),
                      dot(w[k], texelFetch(nodes, j + 2)));
        }
        d += diffuse[i] * c;
        g += gloss[i] * c;
    }
}
#endif

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 place = texelFetch(places, pixel, 0);                          /* and material */
    if (place.w < 0.0) {
        radiance = vec4(0.0);
        return;
    }
    Material m = materials[int(place.w)];
    vec3 normal = texelFetch(normals, pixel, 0).xyz, view = normalize(eye - place.xyz), d, g;
    float facing = dot(normal, view), fresnel = m.f0 + (m.f90 - m.f0) * pow(1.0 - max(facing, 0.0), 5.0);
    transfers(normal, 2.0 * facing * normal - view, m.lobe);
    if (shadowed) shadows(place.xyz, place.w == 1.0 || place.w == 2.0, texelFetch(inside, pixel, 0).xyz);
    gather(place.xyz, d, g);
    radiance = vec4(m.albedo / SH_PI * max(d, vec3(0.0)) + fresnel * max(g, vec3(0.0)), 1.0);
    if (occluded) radiance.rgb *= texelFetch(occlusion, pixel, 0).x;
}
