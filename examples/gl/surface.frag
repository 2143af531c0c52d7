/* surface.frag - a pixel's place, normal and material; the lights' own glow apart. */
in vec3 at, n;
flat in float kind;
flat in vec3 glow;
uniform vec3 eye;

layout(location = 0) out vec4 place;    /* and material; -1 a light, -2 nothing */
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 emitted;

void main()
{
    vec3 face = cross(dFdx(at), dFdy(at)), m = normalize(n), d = at - eye;
    if ((dot(face, d) > 0.0) == (dot(face, m) > 0.0)) m = -m;           /* seen from behind */
    place = vec4(at, kind);
    normal = vec4(m, 0.0);
    emitted = vec4(glow, 1.0);
}
