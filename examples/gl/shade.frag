/* shade.frag - pass 2: the light at a pixel's place, by the grid or by all lights anew, and what leaves there.
 *
 * The light is an SH vector of LIGHT_BANDS bands per channel. It leaves by two dot products with transfer
 * vectors: the clamped cosine about the normal, and the GGX lobe about the mirror direction, of SH_BANDS bands,
 * cut by the clamped cosine (MP21, Eq. 11: multiplying the lobe instead of the light is the same, once instead
 * of per channel) and divided by what the cut leaves of it, so that all of a white room comes back. */
#define LIGHT_N (LIGHT_BANDS * LIGHT_BANDS)

struct Material { vec3 albedo; float f0, f90, lobe[9]; };

layout(std430, binding = 2) readonly buffer Materials { Material materials[]; };
layout(std430, binding = 3) readonly buffer Axes { vec4 axis[17]; float axis_weight[]; };   /* as in grid.comp */
layout(binding = 0) uniform sampler2D places;
layout(binding = 1) uniform sampler2D normals;
layout(binding = 2) uniform sampler2D occlusion;
layout(binding = 3) uniform samplerBuffer lights;                       /* [light][6]: struct Light of grid.comp */
layout(binding = 4) uniform samplerBuffer nodes;                        /* [node][coefficient][channel] */
uniform int light_count, scheme, terms;                                 /* terms = LIGHT_N, a loop not to unroll */
uniform ivec3 count;
uniform vec3 origin, cell, eye;
uniform bool occluded;

layout(location = 0) out vec4 radiance;

float gloss[SH_N], diffuse[SH_N];                                       /* the transfer vectors */

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

#if PER_PIXEL && POLYGONS
/* Exact triangles: the zonal sum about the normal gives the irradiance, those about the fixed axes the rest. */
void gather(vec3 point, vec3 normal, out vec3 d, out vec3 g)
{
    float s[SH_BANDS], along[AXES * LIGHT_BANDS];                       /* along: the lobe's transfer */
    vec3 unused[SH_BANDS];
    for (int j = 0; j < AXES; j++)
        for (int l = 0; l < LIGHT_BANDS; l++) {
            float sum = 0.0;
            for (int i = l * l; i < (l + 1) * (l + 1); i++) sum += gloss[i] * axis_weight[i * AXES + j];
            along[j * LIGHT_BANDS + l] = sum;
        }
    d = vec3(0.0);
    g = vec3(0.0);
    for (int i = 0; i < light_count; i++) {
        vec3 a = texelFetch(lights, 6 * i + 3).xyz - point, b = texelFetch(lights, 6 * i + 4).xyz - point;
        vec3 c = texelFetch(lights, 6 * i + 5).xyz - point, rgb = texelFetch(lights, 6 * i + 1).rgb;
        for (int j = -1; j < AXES; j++) {
            float t = 0.0;
            sh_triangle_zonal(a, b, c, j < 0 ? normal : axis[j].xyz, s, unused);
            for (int l = 0; l < LIGHT_BANDS; l++)
                t += s[l] * (j < 0 ? sh_diffuse_zonal(l) * float(2 * l + 1) / (4.0 * SH_PI)
                                   : along[j * LIGHT_BANDS + l]);
            if (j < 0) d += t * rgb;
            else g += t * rgb;
        }
    }
}
#elif PER_PIXEL
/* sum over lights of sum g_l t_lm Y_lm(u): no coefficient is kept */
void gather(vec3 point, vec3 normal, out vec3 d, out vec3 g)
{
    d = vec3(0.0);
    g = vec3(0.0);
    for (int i = 0; i < light_count; i++) {
        vec4 sphere = texelFetch(lights, 6 * i), triangle = texelFetch(lights, 6 * i + 2);
        float weight[SH_BANDS], slope[SH_BANDS], distance = length(sphere.xyz - point);
        vec3 u = (sphere.xyz - point) / max(distance, 1e-30), rgb = texelFetch(lights, 6 * i + 1).rgb;
        vec2 e = vec2(1.0, 0.0), t = vec2(0.0);
        sh_sphere_weights(distance, sphere.w, weight, slope);
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
        if (triangle.w > 0.0) t *= abs(dot(triangle.xyz, u));           /* a triangle as a sphere */
        d += rgb * t.x;
        g += rgb * t.y;
    }
}
#else
/* Every scheme is a sum over the cell's corners: eight weights, then one dot product per corner and channel. */
void gather(vec3 point, vec3 normal, out vec3 d, out vec3 g)
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
    vec4 place = texelFetch(places, pixel, 0);
    if (place.w < 0.0) {
        radiance = vec4(0.0);
        return;
    }
    Material m = materials[int(place.w)];
    vec3 normal = texelFetch(normals, pixel, 0).xyz, view = normalize(eye - place.xyz), d, g;
    float facing = dot(normal, view), fresnel = m.f0 + (m.f90 - m.f0) * pow(1.0 - max(facing, 0.0), 5.0);
    transfers(normal, 2.0 * facing * normal - view, m.lobe);
    gather(place.xyz, normal, d, g);
    radiance = vec4(m.albedo / SH_PI * max(d, vec3(0.0)) + fresnel * max(g, vec3(0.0)), 1.0);
    if (occluded) radiance.rgb *= texelFetch(occlusion, pixel, 0).x;
}
