/* shade.frag - pass 2: the light at a pixel's place, by the grid or by all lights anew, and what leaves its surface.
 *
 * The light is an SH vector of LIGHT_BANDS bands per channel. It leaves by two dot products with transfer vectors: the
 * clamped cosine about the normal, and the GGX lobe about the mirror direction (both zonal; SH_BANDS = 9 bands), the
 * lobe cut by the clamped cosine too when CUT is set, and divided by what the cut leaves of it. */
#define LIGHT_N (LIGHT_BANDS * LIGHT_BANDS)

struct Light { vec4 sphere, radiance, normal, corner[3]; };
struct Material { vec3 albedo; float f0, f90, lobe[9]; };

layout(std430, binding = 0) readonly buffer Lights { Light light[]; };
layout(std430, binding = 1) readonly buffer Nodes { vec4 node[]; };     /* [node][coefficient][channel] */
layout(std430, binding = 2) readonly buffer Materials { Material materials[]; };
layout(binding = 0) uniform sampler2D places;
layout(binding = 1) uniform sampler2D normals;
layout(binding = 2) uniform sampler2D occlusion;
uniform int lights;
uniform ivec3 count;
uniform vec3 origin, cell, eye;
uniform bool occluded;

layout(location = 0) out vec4 radiance;

float gloss[SH_N], diffuse[SH_N];                                       /* the transfer vectors */

void transfers(vec3 normal, vec3 mirror, const in float lobe[9])
{
    sh_eval(normal, diffuse);
    for (int i = 0; i < LIGHT_N; i++) diffuse[i] *= sh_diffuse_zonal(int(sqrt(float(i) + 0.5)));
#if CUT
    float g[SH_BANDS];
    for (int l = 0; l < SH_BANDS; l++) g[l] = lobe[l];
    sh_cosine_zonal(normal, mirror, g, gloss);
    float left = max(gloss[0] * sqrt(4.0 * SH_PI), 0.05);
    for (int i = 0; i < LIGHT_N; i++) gloss[i] /= left;
#else
    sh_eval(mirror, gloss);
    for (int i = 0; i < LIGHT_N; i++) gloss[i] *= lobe[int(sqrt(float(i) + 0.5))];
#endif
}

#if PER_PIXEL
/* sum over lights of sum g_l t_lm Y_lm(u): no coefficient is kept */
void gather(vec3 point, out vec3 d, out vec3 g)
{
    d = vec3(0.0);
    g = vec3(0.0);
    for (int i = 0; i < lights; i++) {
        float weight[SH_BANDS], slope[SH_BANDS], distance = length(light[i].sphere.xyz - point);
        vec3 u = (light[i].sphere.xyz - point) / max(distance, 1e-30);
        vec2 e = vec2(1.0, 0.0), t = vec2(0.0);
        sh_sphere_weights(distance, light[i].sphere.w, weight, slope);
        for (int m = 0; m < LIGHT_BANDS; m++) {
            sh_column c = sh_first(m);
            for (int l = m; l < LIGHT_BANDS; l++) {
                int k = l * (l + 1);
                float q = weight[l] * c.q;
                t += q * e.x * vec2(diffuse[k + m], gloss[k + m]);
                if (m > 0) t += q * e.y * vec2(diffuse[k - m], gloss[k - m]);
                sh_climb(c, l + 1, m, u.z);
            }
            e = sh_times(e, u.xy);
        }
        if (light[i].normal.w > 0.0) t *= abs(dot(light[i].normal.xyz, u));     /* a triangle as a sphere */
        d += light[i].radiance.rgb * t.x;
        g += light[i].radiance.rgb * t.y;
    }
}
#else
/* Every scheme is a sum over the cell's corners: eight vec4 weights, then one dot product per corner and channel. */
void gather(vec3 point, out vec3 d, out vec3 g)
{
    vec4 w[8];
    vec3 p = clamp((point - origin) / cell, vec3(0.0), vec3(count - 1));
    ivec3 first = min(ivec3(p), count - 2);
    int at[8];
    sh_grid_weights(SCHEME, p - vec3(first), cell, w);
    for (int k = 0; k < 8; k++) {
        ivec3 c = first + ivec3(k & 1, k >> 1 & 1, k >> 2);
        at[k] = (c.x + count.x * (c.y + count.y * c.z)) * LIGHT_N * 3;
    }
    d = vec3(0.0);
    g = vec3(0.0);
    for (int i = 0; i < LIGHT_N; i++) {
        vec3 c = vec3(0.0);
        for (int k = 0; k < 8; k++) {
            int j = at[k] + 3 * i;
#if SCHEME == 0                                                         /* SH_TRILINEAR reads no gradient */
            c += w[k].x * vec3(node[j].x, node[j + 1].x, node[j + 2].x);
#else
            c += vec3(dot(w[k], node[j]), dot(w[k], node[j + 1]), dot(w[k], node[j + 2]));
#endif
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
    gather(place.xyz, d, g);
    radiance = vec4(m.albedo / SH_PI * max(d, vec3(0.0)) + fresnel * max(g, vec3(0.0)), 1.0);
    if (occluded) radiance.rgb *= texelFetch(occlusion, pixel, 0).x;
}
