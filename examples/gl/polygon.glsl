/* polygon.glsl - the light of a triangle about an axis: S_l = integral of P_l(axis . w) over its directions,
 * and the gradient of S_l by the shading point. After sh.glsl; a, b, c are the corners less that point.
 *
 * Wang and Ramamoorthi 2018 (WR18), in a form that keeps its accuracy: no cross product of unit vectors, -c^2
 * in place of a^2 + b^2 - 1, bands l >= 1 without the solid angle. The gradient is carried along the boundary.
 * Both lose accuracy as (distance/size)^2: triangles that look small are integrated by 7 or 64 points instead. */

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

/* One edge A to B. */
void sh_edge_zonal(vec3 from, vec3 to, vec3 axis, inout float s[SH_BANDS], inout vec3 grad[SH_BANDS])
{
    vec3 edge = to - from, normal = cross(from, edge);
    float area = length(normal), near = length(from), both = near * length(to);
    if (area == 0.0) return;
    vec3 mu = normal / area, w = from / near;
    float cosine = dot(from, to) / both, sine = area / both, gamma = sh_atan(area, dot(from, to));
    float a = dot(w, axis), b = dot(cross(mu, w), axis), c = dot(mu, axis);
    float z0 = a, z1 = a * cosine + b * sine, d0 = b, d1 = b * cosine - a * sine;
    float k0 = 1.0 / near, k1 = -dot(edge, w) / area, k = k0 * a + k1 * b;
    float K0 = -k1, K1 = k0 * sine - k1 * cosine;

    float p0 = 1.0, p1 = 1.0, p0_ = 0.0, p1_ = 0.0;             /* P_l(z0), P_l(z1); a trailing _: of l-1 */
    float B = gamma, B_ = 0.0, D = 0.0, D_ = 0.0, G = K1 - K0, G_ = 0.0, H = 0.0, H_ = 0.0;
    grad[0] += mu * G;
    for (int l = 1; l < SH_BANDS; l++) {
        float f = float(l), g = 2.0 * f - 1.0;
        float B2 = (g * (d0 * p0 - d1 * p1 - c * c * D) + (f - 1.0) * (f - 1.0) * B_) / (f * f);
        float D2 = D_ + g * B, H2 = H_ + g * G;
        float q0 = (g * z0 * p0 - (f - 1.0) * p0_) / f, q1 = (g * z1 * p1 - (f - 1.0) * p1_) / f;
        float G2 = (q1 * K1 - q0 * K0 + k * D2 - H) / (f + 1.0);
        s[l] += c * D2 / (f * (f + 1.0));
        grad[l] += mu * G2;
        B_ = B; B = B2; D_ = D; D = D2; G_ = G; G = G2; H_ = H; H = H2;
        p0_ = p0; p0 = q0; p1_ = p1; p1 = q1;
    }
}

/* One point of a rule for small triangles; area2 = (b-a) x (c-a). */
void sh_point_zonal(float weight, vec3 p, vec3 area2, vec3 axis,
                    inout float s[SH_BANDS], inout vec3 grad[SH_BANDS])
{
    float r = inversesqrt(dot(p, p)), t = dot(p, axis) * r, facing = dot(p, area2) * r;
    float w = weight * r * r, k = w * facing;
    vec3 u = p * r, across = (axis - u * t) * (k * r), along = (w * r) * (area2 - 3.0 * facing * u);
    float q = 1.0, q_ = 0.0, dq = 0.0;                          /* P_l(t), P_{l-1}, P'_l */
    for (int l = 0; l < SH_BANDS; l++) {
        s[l] += k * q;
        grad[l] -= dq * across + q * along;
        float next = (float(2 * l + 1) * t * q - float(l) * q_) / float(l + 1);
        dq = float(l + 1) * q + t * dq;
        q_ = q;
        q = next;
    }
}

/* Positive from either side. */
void sh_triangle_zonal(vec3 a, vec3 b, vec3 c, vec3 axis, out float s[SH_BANDS], out vec3 grad[SH_BANDS])
{
    vec3 area2 = cross(b - a, c - a), middle = (a + b + c) / 3.0;
    float det = dot(a, area2), size = max(length(b - a), max(length(c - b), length(a - c)));
    for (int l = 0; l < SH_BANDS; l++) {
        s[l] = 0.0;
        grad[l] = vec3(0.0);
    }
    if (float(SH_BANDS) * size < 0.7 * length(middle)) {        /* Radon's rule of degree 5 */
        const float near = 0.470142064, wide = 0.101286507;     /* (6 +- sqrt 15)/21 */
        const float near_weight = 0.0661970764, wide_weight = 0.0629695903;     /* (155 +- sqrt 15)/2400 */
        sh_point_zonal(0.1125, middle, area2, axis, s, grad);
        for (int k = 0; k < 3; k++) {
            vec3 corner = k == 0 ? a : k == 1 ? b : c;
            sh_point_zonal(near_weight, corner + 3.0 * near * (middle - corner), area2, axis, s, grad);
            sh_point_zonal(wide_weight, corner + 3.0 * wide * (middle - corner), area2, axis, s, grad);
        }
    } else if (size < 0.5 * length(middle)) {                   /* Gauss in u and v at a + u (b-a) + uv (c-b) */
        for (int k = 0; k < 64; k++) {
            float u = SH_GAUSS_AT[k >> 3], v = SH_GAUSS_AT[k & 7];
            sh_point_zonal(u * SH_GAUSS[k >> 3] * SH_GAUSS[k & 7], a + u * ((b - a) + v * (c - b)), area2, axis, s, grad);
        }
    } else {
        float x = length(a), y = length(b), z = length(c);      /* van Oosterom and Strackee 1983 */
        s[0] = 2.0 * sh_atan(det, x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
        sh_edge_zonal(a, b, axis, s, grad);
        sh_edge_zonal(b, c, axis, s, grad);
        sh_edge_zonal(c, a, axis, s, grad);
    }
    if (det < 0.0)
        for (int l = 0; l < SH_BANDS; l++) {
            s[l] = -s[l];
            grad[l] = -grad[l];
        }
}
