/* polygon.glsl - the exact light of a triangle, and its gradient by the shading point. After sh.glsl.
 *
 * The light is a sum over nodes, eight at a time so that eight threads can share it. A triangle that looks
 * small is integrated over its surface by 7, 28 or 112 points (Radon's rule of degree 5). Any other is integrated
 * along its edges by the divergence theorem on the sphere: with mu the edge's normal and u on its arc,
 *
 *     L_lm = sum over edges of the integral of  mu . grad Y_lm(u) / (l(l+1)) dt      l > 0; L_00 = angle Y_00
 *     gradient of L_lm = the same of  mu Y_lm(u) / distance dt
 *
 * Unlike the recurrences of Wang and Ramamoorthi 2018 this loses one power of distance/size, not two.
 *
 *     sh_triangle       coefficients and gradients, positive from either side
 *     sh_triangle_of    a triangle as it is seen from a point,
 *     sh_triangle_node  and its nodes: for shaders that share them out or keep sums of their own
 */

/* BEGIN gen_glsl.py: gauss */
/* Gauss-Legendre, 8 points on [0, 1] */
const float SH_GAUSS_AT[8] = float[8](
    0.0198550718, 0.101666761, 0.237233795, 0.408282679, 0.591717321, 0.762766205, 0.898333239,
    0.980144928
);
/* their weights */
const float SH_GAUSS[8] = float[8](
    0.0506142681, 0.111190517, 0.156853323, 0.181341892, 0.181341892, 0.156853323, 0.111190517,
    0.0506142681
);
/* atan(t) = t + t^3 sum of c_k t^2k for |t| <= tan(pi/8), to 3e-9 */
const float SH_ATAN[5] = float[5](
    -0.333333318, 0.199995405, -0.142639556, 0.107437315, -0.0645192821
);
/* END gen_glsl.py */

/* The builtin may be off by thousands of units in the last place; this is not. */
float sh_atan(float y, float x)
{
    float far = max(abs(x), abs(y)), near = min(abs(x), abs(y));
    bool wide = near > 0.414213562 * far;
    float t = wide ? (near - far) / (near + far) : far > 0.0 ? near / far : 0.0, z = t * t, p = SH_ATAN[4];
    for (int k = 3; k >= 0; k--) p = p * z + SH_ATAN[k];
    t += t * z * p;
    if (wide) t += SH_PI / 4.0;
    if (abs(y) > abs(x)) t = SH_PI / 2.0 - t;
    if (x < 0.0) t = SH_PI - t;
    return y < 0.0 ? -t : t;
}

/* L_lm += k Y + (along . grad Y) / (l(l+1));  its gradient += flux Y - slope (grad Y along the sphere) */
struct sh_node { vec3 u, along, flux; float k, slope; };

/* Seen from a point, with the front side there. angle: what L_00 has beyond its nodes. panels: per edge, or
 * 0. */
struct sh_seen { vec3 corner[3], area2; float angle; int octets, panels; };

float sh_cosine(vec3 a, vec3 b)
{
    return dot(a, b) * inversesqrt(dot(a, a) * dot(b, b));
}

/* bands: for how many the nodes are to do. */
sh_seen sh_triangle_of(int bands, vec3 point, vec3 a, vec3 b, vec3 c)
{
    sh_seen t;
    vec3 area2 = cross(b - a, c - a), p = a - point, q = b - point, r = c - point;
    float size = max(length(b - a), max(length(c - b), length(a - c)));
    float looks = float(bands) * size / length((p + q + r) / 3.0);
    bool front = dot(p, area2) >= 0.0;
    t.area2 = front ? area2 : -area2;
    t.corner = vec3[3](p, front ? q : r, front ? r : q);
    t.angle = 0.0;
    t.panels = 0;
    t.octets = looks < 0.7 ? 1 : looks < 1.4 ? 4 : 16;
    if (looks > 2.0) {                                          /* an arc of 0.75 takes 8 nodes at 9 bands */
        float x = length(p), y = length(q), z = length(r);
        float wide = min(sh_cosine(p, q), min(sh_cosine(q, r), sh_cosine(r, p)));
        t.panels = wide > 0.7317 ? 1 : wide > 0.0707 ? 2 : 4;
        t.octets = 3 * t.panels;
        t.angle = 2.0 * sh_atan(abs(dot(p, area2)),             /* van Oosterom and Strackee 1983 */
                                x * y * z + dot(p, q) * z + dot(q, r) * x + dot(r, p) * y);
    }
    return t;
}

/* k-th point of the rule, on the whole triangle or on one of 4 or of 16. */
sh_node sh_surface_node(sh_seen t, int part, int k)
{
    vec3 middle = (t.corner[0] + t.corner[1] + t.corner[2]) / 3.0, p = middle;
    float weight = k == 0 ? 0.1125 : k < 4 ? 0.0661970764 : k < 7 ? 0.0629695903 : 0.0;  /* (155 +- sqrt 15)/2400 */
    if (k > 0) p = mix(t.corner[k % 3], middle, k < 4 ? 1.41042619 : 0.303859522);      /* (6 +- sqrt 15)/7 */
    for (int pieces = t.octets; pieces > 1; pieces >>= 2) {     /* one at each corner, one in the middle */
        p = (part & 3) < 3 ? 0.5 * (t.corner[part & 3] + p) : 0.5 * (3.0 * middle - p);
        weight *= 0.25;
        part >>= 2;
    }
    float r = inversesqrt(dot(p, p)), facing = dot(p, t.area2) * r, w = weight * r * r, k0 = w * facing;
    vec3 u = p * r;
    return sh_node(u, vec3(0.0), -(w * r) * (t.area2 - 3.0 * facing * u), k0, k0 * r);
}

/* k-th node of a panel of an edge, on the chord between directions: no angle is computed that the ends of two
 * edges could disagree about, and what is linear along the edge, 1/distance, is so on the chord, before u is
 * normalised. */
sh_node sh_edge_node(sh_seen t, int edge, int panel, int k)
{
    vec3 a = t.corner[edge], b = t.corner[(edge + 1) % 3];
    float near_a = inversesqrt(dot(a, a)), near_b = inversesqrt(dot(b, b)), g = SH_GAUSS_AT[k];
    a *= near_a;
    b *= near_b;
    for (int halves = t.panels; halves > 1; halves >>= 1) {
        vec3 middle = a + b;
        float r = inversesqrt(dot(middle, middle)), near = (near_a + near_b) * r;
        if ((panel & 1) != 0) {
            a = middle * r;
            near_a = near;
        } else {
            b = middle * r;
            near_b = near;
        }
        panel >>= 1;
    }
    vec3 p = a + g * (b - a);
    float r = inversesqrt(dot(p, p));
    vec3 along = cross(a, b - a) * (SH_GAUSS[k] * r * r);       /* mu dt */
    return sh_node(p * r, along, along * (mix(near_a, near_b, g) * r), 0.0, 0.0);
}

/* k-th of eight nodes of an octet. */
sh_node sh_triangle_node(sh_seen t, int octet, int k)
{
    if (t.panels == 0) return sh_surface_node(t, octet, k);
    return sh_edge_node(t, octet % 3, octet / 3, k);
}

/* What a node adds to one coefficient, value first: c, e and e1 as for sh_polynomial_grad, band l. */
vec4 sh_node_part(sh_node p, sh_column c, int l, int m, vec2 e, vec2 e1)
{
    float y = c.q * e.x;
    vec3 grad = sh_polynomial_grad(c, m, e, e1);
    return vec4(p.k * y + dot(p.along, grad) / float(max(l * (l + 1), 1)),
                p.flux * y - p.slope * (grad - p.u * dot(p.u, grad)));
}

void sh_triangle(vec3 point, vec3 a, vec3 b, vec3 c, out float coeffs[SH_N], out vec3 grad[SH_N])
{
    sh_seen t = sh_triangle_of(SH_BANDS, point, a, b, c);
    for (int i = 0; i < SH_N; i++) {
        coeffs[i] = i == 0 ? t.angle * SH_K[0] : 0.0;
        grad[i] = vec3(0.0);
    }
    for (int k = 0; k < 8 * t.octets; k++) {
        sh_node p = sh_triangle_node(t, k / 8, k % 8);
        vec2 e = vec2(1.0, 0.0), e1 = vec2(0.0);
        for (int m = 0; m < SH_BANDS; m++) {
            sh_column column = sh_first(m);
            for (int l = m; l < SH_BANDS; l++) {
                int i = l * (l + 1);
                vec4 cosine = sh_node_part(p, column, l, m, e, e1);
                vec4 sine = sh_node_part(p, column, l, m, vec2(e.y, -e.x), vec2(e1.y, -e1.x));
                coeffs[i + m] += cosine.x;
                grad[i + m] += cosine.yzw;
                if (m > 0) {
                    coeffs[i - m] += sine.x;
                    grad[i - m] += sine.yzw;
                }
                sh_climb(column, sh_step(l + 1, m), p.u.z);
            }
            e1 = e;
            e = sh_times(e, p.u.xy);
        }
    }
}
