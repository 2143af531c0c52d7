/* surface.frag - a pixel's place, normal, material and triangle; the lights' own glow apart. */
in vec3 at, n;
in vec2 share;
flat in float kind;
flat in vec3 glow;
uniform vec3 eye;
uniform int drawn;                      /* triangles before this call's */

layout(location = 0) out vec4 place;    /* and material; -1 a light, -2 nothing */
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 emitted;
layout(location = 3) out vec4 inside;   /* the second and third corner's share, which triangle */

void main()
{
    vec3 face = cross(dFdx(at), dFdy(at)), m = normalize(n), d = at - eye;
    if ((dot(face, d) > 0.0) == (dot(face, m) > 0.0)) m = -m;           /* seen from behind */
    place = vec4(at, kind);
    normal = vec4(m, 0.0);
    emitted = vec4(glow, 1.0);
    inside = vec4(share, float(drawn + gl_PrimitiveID), 0.0);
}
