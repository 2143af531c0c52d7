/* final.frag - from radiance to the picture: glow, exposure, the ACES curve, sRGB; SAMPLES^2 pixels to one. */
layout(binding = 0) uniform sampler2D shaded;
layout(binding = 1) uniform sampler2D emitted;          /* with mipmaps: the wider the glow, the coarser */
layout(binding = 2) uniform sampler2D reference;
uniform float exposure, scale;                          /* scale > 0: a heat map of that times the error */

layout(location = 0) out vec4 colour;

vec3 tone(vec3 x)                                       /* Narkowicz 2015; then the sRGB curve */
{
    vec3 y = clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
    return mix(12.92 * y, 1.055 * pow(y, vec3(1.0 / 2.4)) - 0.055, greaterThan(y, vec3(0.0031308)));
}

/* black, violet, orange, yellow, white */
vec3 heat(float t)
{
    t = clamp(t, 0.0, 1.0);
    float blue = t < 0.5 ? 0.7 * sin(6.2831853 * t) : 3.0 * t - 2.0;
    return clamp(vec3(2.4 * t - 0.05, 2.0 * t - 0.75, blue), 0.0, 1.0);
}

vec3 glow(vec2 uv)
{
    vec3 sum = vec3(0.0);
    for (int level = 2; level < 7; level++)
        for (int k = 0; k < 9; k++) {                   /* a tent over each level hides its texels */
            vec2 d = vec2(k % 3 - 1, k / 3 - 1);
            vec2 w = 1.0 - 0.5 * abs(d), at = uv + d / vec2(textureSize(emitted, level));
            sum += w.x * w.y / 4.0 * 0.045 * textureLod(emitted, at, float(level)).rgb;
        }
    return sum;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) * SAMPLES;
    vec3 sum = vec3(0.0), error = vec3(0.0);
    vec3 bloom = glow((vec2(pixel) + 0.5 * float(SAMPLES)) / vec2(textureSize(shaded, 0)));
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        ivec2 p = pixel + ivec2(i % SAMPLES, i / SAMPLES);
        vec3 light = texelFetch(emitted, p, 0).rgb + bloom;
        vec3 a = tone(exposure * (texelFetch(shaded, p, 0).rgb + light));
        sum += a;
        if (scale > 0.0) error += a - tone(exposure * (texelFetch(reference, p, 0).rgb + light));
    }
    sum /= float(SAMPLES * SAMPLES);
    error = abs(error) / float(SAMPLES * SAMPLES);
    float mean = (error.r + error.g + error.b) / 3.0;
    colour = scale > 0.0 ? vec4(heat(scale * mean), mean) : vec4(sum, 1.0);
}
