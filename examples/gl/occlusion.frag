/* occlusion.frag - ambient occlusion in screen space: how much of a small hemisphere lies behind what is
 * seen. With BLUR the second pass: the mean of 4 x 4 pixels on a surface, which takes away the first one's
 * pattern. */
layout(binding = 0) uniform sampler2D places;
layout(binding = 1) uniform sampler2D normals;
layout(binding = 2) uniform sampler2D raw;
uniform vec3 eye, right, up, ahead;
uniform vec2 view;

layout(location = 0) out float open;

const float reach = 0.55;               /* in the scene's units */
const int   rays = 16;

float seen(vec3 place, vec3 normal, float turn)
{
    float blocked = 0.0;
    vec3 x = normalize(abs(normal.z) < 0.9 ? cross(normal, vec3(0, 0, 1)) : cross(normal, vec3(1, 0, 0)));
    vec3 y = cross(normal, x);
    for (int i = 0; i < rays; i++) {    /* a golden spiral, cosine-weighted, lengths from short to long */
        float k = (float(i) + 0.5) / float(rays), a = 2.39996323 * float(i) + turn, s = sqrt(k);
        float far = reach * mix(0.1, 1.0, fract(k * 7.0 + turn));
        vec3 p = place + normal * 0.02 + far * (s * cos(a) * x + s * sin(a) * y + sqrt(1.0 - k) * normal) - eye;
        float depth = dot(p, ahead);
        vec2 uv = vec2(dot(p, right) / view.x, dot(p, up) / view.y) / depth * 0.5 + 0.5;
        vec4 there = textureLod(places, uv, 0.0);
        float nearer = depth - dot(there.xyz - eye, ahead);
        if (there.w >= 0.0 && nearer > 0.01) blocked += clamp(1.5 - nearer / reach, 0.0, 1.0);
    }
    return 1.0 - blocked / float(rays);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 place = texelFetch(places, pixel, 0);
    vec3 normal = texelFetch(normals, pixel, 0).xyz;
    open = 1.0;
    if (place.w < 0.0) return;
#if BLUR
    float sum = 0.0, weight = 0.0;
    for (int i = 0; i < 16; i++) {
        ivec2 p = pixel + ivec2(i % 4 - 2, i / 4 - 2);
        vec3 d = texelFetch(places, p, 0).xyz - place.xyz;
        float w = abs(dot(d, normal)) < 0.05 && dot(d, d) < reach * reach ? 1.0 : 1e-4;
        sum += w * texelFetch(raw, p, 0).x;
        weight += w;
    }
    open = sum / weight;
#else
    open = seen(place.xyz, normal, float((pixel.x & 3) * 4 + (pixel.y & 3)) * 0.39269908);
#endif
}
