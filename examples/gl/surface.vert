/* surface.vert - what the camera sees: the mesh, or with LIGHTS one small sphere or one triangle per light. */
struct Light { vec4 sphere, radiance, normal, corner[3]; };
layout(std430, binding = 0) readonly buffer Lights { Light light[]; };

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float material;
uniform vec3 eye, right, up, ahead;
uniform vec2 view, turn;                /* half the view at distance 1; (cos, sin) about z */
uniform int first;                      /* of the lights */

out vec3 at, n;
out vec2 share;                         /* the second and third corner's */
flat out float kind;
flat out vec3 glow;

vec3 turned(vec3 v) { return vec3(turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y, v.z); }

/* Corner of a sphere of 16 by 10 quads. */
vec3 ball(int vertex)
{
    int quad = vertex / 6, corner = vertex % 6;
    int i = quad % 16 + (corner == 1 || corner == 2 || corner == 4 ? 1 : 0);
    int j = quad / 16 + (corner > 1 && corner != 3 ? 1 : 0);
    float a = float(i) * 0.39269908, b = float(j) * 0.31415927;
    return vec3(sin(b) * cos(a), sin(b) * sin(a), cos(b));
}

void main()
{
#if LIGHTS
    Light l = light[first + gl_InstanceID];
    at = l.normal.w > 0.0 ? l.corner[gl_VertexID % 3].xyz : l.sphere.xyz + l.sphere.w * ball(gl_VertexID);
    n = vec3(0.0, 0.0, 1.0);
    kind = -1.0;
    glow = l.radiance.rgb;
#else
    at = turned(position);
    n = turned(normal);
    kind = material;
    glow = vec3(0.0);
#endif
    share = vec2(gl_VertexID % 3 == 1, gl_VertexID % 3 == 2);
    vec3 v = at - eye;
    float depth = dot(v, ahead), near = 0.05, far = 100.0;
    float z = (depth * (far + near) - 2.0 * far * near) / (far - near);
    gl_Position = vec4(dot(v, right) / view.x, dot(v, up) / view.y, z, depth);
}
