/* sh.glsl - spherical-harmonics lighting in shaders: basis and gradient, sphere and triangle lights,
 *           clamped cosine, zonal lobes, interpolation on a grid of values and gradients
 *
 * USE
 *     Paste or prepend it after #version (and, in GLSL ES, after `precision highp float;`).
 *     GLSL 3.30 and later, GLSL ES 3.00 (WebGL2) and later. No uniform, buffer or texture is declared.
 *
 * CONVENTIONS (those of sh_gradient.h and its neighbours)
 *     basis      real, orthonormal, z polar, index i = l(l+1) + m; SH_BANDS bands l = 0 .. SH_BANDS-1
 *     sign       Sloan's: Y_1 = 0.48860 (-y, +z, -x)
 *     gradients  of a light with respect to the shading point; of Y(v/|v|) with respect to v
 *     lights     unit radiance; multiply by yours
 *     grid       node = vec4(value, d/dx, d/dy, d/dz) per coefficient and channel
 *
 * FUNCTIONS
 *     sh_eval                   Y_i of a unit direction
 *     sh_eval_grad              Y_i(v/|v|) and its gradient, any v but zero; no pole
 *     sh_sphere_weights         g_l and dg_l/dd of a sphere light: L_lm = g_l Y_lm
 *     sh_sphere                 a sphere light's coefficients and gradients
 *     sh_triangle_as_sphere     a two-sided triangle in place of which a sphere shines (M22, 4.4)
 *     sh_rotate_y, sh_rotate_z  rotate a function
 *     sh_cosine_product_local   clamped cosine times a function, about +z (MP21, Eq. 11)
 *     sh_cosine_product         the same about a normal, in the world's frame
 *     sh_cosine_zonal           clamped cosine about a normal times a lobe about another axis
 *     sh_diffuse_zonal          l-th factor of the cosine convolution: irradiance = sum f_l L_lm Y_lm(normal)
 *     sh_grid_weights           corner weights of trilinear, Hermite and edge-Hermite interpolation
 *
 * SOURCES
 *     M22: Mezieres et al. 2022, Recursive analytic spherical harmonics gradient for spherical lights.
 *     MP21: Mezieres and Paulin 2021, Efficient spherical harmonic shading for separable BRDF.
 *     Sloan 2013, Efficient spherical harmonic evaluation.
 */
#ifndef SH_BANDS
#define SH_BANDS 5                  /* 1 .. 9 */
#endif
#define SH_N (SH_BANDS * SH_BANDS)
#define SH_PI 3.14159265

/* both generated, at the end */
void sh_cosine_product_local(const in float c[SH_N], out float o[SH_N]);
void sh_rotate_x90(inout float f[SH_N]);

/* BEGIN gen_glsl.py: tables */
/* Q_m^m = K[m]: sqrt((2m+1)!!/(4 pi (2m)!!)), times sqrt(2) and (-1)^m for m > 0 */
const float SH_K[10] = float[10](
    0.282094792, -0.488602512, 0.546274215, -0.59004359, 0.625835735, -0.656382057, 0.683184105,
    -0.707162733, 0.72892666, -0.748900952
);
/* Q_l^m = A z Q_{l-1}^m - B Q_{l-2}^m at l(l+1)/2 + m:  A = sqrt((4l^2-1)/(l^2-m^2)) */
const float SH_A[55] = float[55](
    0.0, 1.73205081, 0.0, 1.93649167, 2.23606798, 0.0, 1.97202659, 2.09165007, 2.64575131, 0.0,
    1.98431348, 2.04939015, 2.29128785, 3.0, 0.0, 1.98997487, 2.0310096, 2.17124059, 2.48746859,
    3.31662479, 0.0, 1.99304346, 2.02131499, 2.11394182, 2.30136835, 2.67394839, 3.60555128, 0.0,
    1.99489143, 2.01556444, 2.081666, 2.20794022, 2.43086217, 2.85043856, 3.87298335, 0.0, 1.99608993,
    2.01186954, 2.06155281, 2.15322169, 2.30488611, 2.55704156, 3.01780431, 4.12310563, 0.0, 1.9969112,
    2.00935313, 2.04812236, 2.11804417, 2.22917715, 2.40163635, 2.67913751, 3.17706626, 4.35889894, 0.0
);
/* B = A_l / A_{l-1} */
const float SH_B[55] = float[55](
    0.0, 0.0, 0.0, 1.11803399, 0.0, 0.0, 1.01835015, 0.935414347, 0.0, 0.0, 1.00623059, 0.979795897,
    0.866025404, 0.0, 0.0, 1.00285307, 0.991031209, 0.947607083, 0.829156198, 0.0, 0.0, 1.00154202,
    0.995226703, 0.97361012, 0.925184889, 0.806225775, 0.0, 0.0, 1.00092721, 0.997155044, 0.984731928,
    0.959403224, 0.909090909, 0.790569415, 0.0, 0.0, 1.00060078, 0.998166818, 0.990337938, 0.975217387,
    0.948176387, 0.897069522, 0.779193722, 0.0, 0.0, 1.00041144, 0.998749218, 0.993485273, 0.983662845,
    0.96715284, 0.939224604, 0.887777082, 0.77055175, 0.0, 0.0
);
/* END gen_glsl.py */

/* ---- basis: Y_{l,m} = Q_l^m(z) Re (x+iy)^m,  Y_{l,-m} = Q_l^m(z) Im (x+iy)^m ---- */

/* One climb of l at fixed m: Q_l^m and dQ_l^m/dz, and both of l-1. */
struct sh_column { float q, q1, d, d1; };

sh_column sh_first(int m)
{
    return sh_column(SH_K[m], 0.0, 0.0, 0.0);
}

/* From l-1 to l, with the constants of (l, m). */
vec2 sh_step(int l, int m)
{
    return vec2(SH_A[l * (l + 1) / 2 + m], SH_B[l * (l + 1) / 2 + m]);
}

void sh_climb(inout sh_column c, vec2 s, float z)
{
    c = sh_column(s.x * z * c.q - s.y * c.q1, c.q, s.x * (z * c.d + c.q) - s.y * c.d1, c.d);
}

/* (a+ib)(c+id) */
vec2 sh_times(vec2 p, vec2 q)
{
    return vec2(p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x);
}

void sh_eval(vec3 u, out float y[SH_N])
{
    vec2 e = vec2(1.0, 0.0);                                    /* (x+iy)^m */
    for (int m = 0; m < SH_BANDS; m++) {
        sh_column c = sh_first(m);
        for (int l = m; l < SH_BANDS; l++) {
            y[l * (l + 1) - m] = c.q * e.y;
            y[l * (l + 1) + m] = c.q * e.x;
            sh_climb(c, sh_step(l + 1, m), u.z);
        }
        e = sh_times(e, u.xy);
    }
}

/* The gradient of Q(z) Re (x+iy)^m as a polynomial, with e = (x+iy)^m, e1 = (x+iy)^(m-1).
 * For the imaginary part turn e and e1 by -i. */
vec3 sh_polynomial_grad(sh_column c, int m, vec2 e, vec2 e1)
{
    return vec3(float(m) * c.q * vec2(e1.x, -e1.y), c.d * e.x);
}

void sh_eval_grad(vec3 v, out float y[SH_N], out vec3 grad[SH_N])
{
    float distance = length(v);
    vec3 u = v / distance;
    vec2 e = vec2(1.0, 0.0), e1 = vec2(0.0);
    for (int m = 0; m < SH_BANDS; m++) {
        sh_column c = sh_first(m);
        for (int l = m; l < SH_BANDS; l++) {
            int i = l * (l + 1);
            vec3 sine = sh_polynomial_grad(c, m, vec2(e.y, -e.x), vec2(e1.y, -e1.x));
            vec3 cosine = sh_polynomial_grad(c, m, e, e1);
            y[i - m] = c.q * e.y;
            y[i + m] = c.q * e.x;
            grad[i - m] = (sine - u * dot(u, sine)) / distance;  /* the part along the sphere */
            grad[i + m] = (cosine - u * dot(u, cosine)) / distance;
            sh_climb(c, sh_step(l + 1, m), u.z);
        }
        e1 = e;
        e = sh_times(e, u.xy);
    }
}

/* ---- lights ---- */

/* A sphere of this radius at this distance: L_lm = g_l Y_lm(direction), dg = dg/ddistance.
 * With s = radius/distance and alpha the cosine of the half-angle: g_0 = 2 pi s^2/(1+alpha),
 * g_l = 2 pi s^2 P'_l(alpha)/(l(l+1)), without the cancellation of M22, Eq. 9. Inside: light all around. */
void sh_sphere_weights(float distance, float radius, out float g[SH_BANDS], out float dg[SH_BANDS])
{
    bool inside = distance <= radius;
    float s = inside ? 0.0 : radius / distance;
    float alpha = sqrt((1.0 - s) * (1.0 + s));
    float scale = 2.0 * SH_PI * s * s, slope = inside ? 0.0 : -scale / (alpha * distance);
    float p1 = 0.0, p = 1.0, dp = 0.0;                          /* P_{l-1}, P_l, P'_l */
    for (int l = 0; l < SH_BANDS; l++) {
        g[l] = scale * (l == 0 ? 1.0 / (1.0 + alpha) : dp / float(l * (l + 1)));
        dg[l] = slope * p;
        float next = (float(2 * l + 1) * alpha * p - float(l) * p1) / float(l + 1);
        dp = float(l + 1) * p + alpha * dp;
        p1 = p;
        p = next;
    }
    if (inside) g[0] = 4.0 * SH_PI;
}

/* Any circularly symmetric light about v = light - point: g_l Y_lm and the gradients by the point. */
void sh_zonal_light(vec3 v, const in float g[SH_BANDS], const in float dg[SH_BANDS],
                    out float c[SH_N], out vec3 grad[SH_N])
{
    sh_eval_grad(v, c, grad);
    vec3 u = normalize(v);
    for (int l = 0; l < SH_BANDS; l++)
        for (int i = l * l; i < (l + 1) * (l + 1); i++) {
            grad[i] = -(dg[l] * c[i] * u + g[l] * grad[i]);
            c[i] *= g[l];
        }
}

void sh_sphere(vec3 point, vec3 center, float radius, out float c[SH_N], out vec3 grad[SH_N])
{
    float g[SH_BANDS], dg[SH_BANDS];
    vec3 v = center - point;
    sh_sphere_weights(length(v), radius, g, dg);
    if (v == vec3(0.0)) v.z = 1.0;                              /* inside every direction is as good */
    sh_zonal_light(v, g, dg, c, grad);
}

/* M22, Eq. 24-28: a sphere at the centroid whose disc has the triangle's area, times |cos| to the normal. */
void sh_triangle_as_sphere(vec3 point, vec3 p0, vec3 p1, vec3 p2, out float c[SH_N], out vec3 grad[SH_N])
{
    vec3 center = (p0 + p1 + p2) / 3.0, area2 = cross(p1 - p0, p2 - p0);
    vec3 v = center - point, n = normalize(area2), u = normalize(v);
    if (dot(n, v) < 0.0) n = -n;
    float cosine = dot(n, u);
    sh_sphere(point, center, sqrt(length(area2) / (2.0 * SH_PI)), c, grad);
    for (int i = 0; i < SH_N; i++) {
        grad[i] = grad[i] * cosine - c[i] * (n - u * cosine) / length(v);
        c[i] *= cosine;
    }
}

/* ---- rotation, clamped cosine ---- */

/* angle = (cos, sin); f'(Rz w) = f(w) */
void sh_rotate_z(vec2 angle, inout float f[SH_N])
{
    vec2 e = angle;
    for (int m = 1; m < SH_BANDS; m++) {
        for (int l = m; l < SH_BANDS; l++) {
            int i = l * (l + 1);
            vec2 t = sh_times(e, vec2(f[i + m], f[i - m]));
            f[i + m] = t.x;
            f[i - m] = t.y;
        }
        e = sh_times(e, angle);
    }
}

/* Takes +z towards +x: Rx(-90) Rz(b) Rx(90) = Rz(pi) Rx(90) Rz(pi+b) Rx(90). */
void sh_rotate_y(vec2 angle, inout float f[SH_N])
{
    sh_rotate_x90(f);
    sh_rotate_z(-angle, f);
    sh_rotate_x90(f);
    sh_rotate_z(vec2(-1.0, 0.0), f);
}

/* (cos, sin) of the turns about y, then z, that take +z to the unit normal. */
void sh_frame(vec3 normal, out vec2 y, out vec2 z)
{
    float s = length(normal.xy);
    y = vec2(normal.z, s);
    z = s > 0.0 ? normal.xy / s : vec2(1.0, 0.0);
}

void sh_cosine_product(vec3 normal, const in float c[SH_N], out float o[SH_N])
{
    vec2 y, z;
    float f[SH_N] = c;
    sh_frame(normal, y, z);
    sh_rotate_z(vec2(z.x, -z.y), f);
    sh_rotate_y(vec2(y.x, -y.y), f);
    sh_cosine_product_local(f, o);
    sh_rotate_y(y, o);
    sh_rotate_z(z, o);
}

/* The lobe sum g_l Y_lm(axis) Y_lm(w), cut by the cosine: in the normal's frame the lobe is one sh_eval. */
void sh_cosine_zonal(vec3 normal, vec3 axis, const in float g[SH_BANDS], out float o[SH_N])
{
    vec2 y, z;
    float c[SH_N];
    sh_frame(normal, y, z);
    vec2 turned = sh_times(vec2(z.x, -z.y), axis.xy);
    sh_eval(vec3(y.x * turned.x - y.y * axis.z, turned.y, y.y * turned.x + y.x * axis.z), c);
    for (int l = 0; l < SH_BANDS; l++)
        for (int i = l * l; i < (l + 1) * (l + 1); i++) c[i] *= g[l];
    sh_cosine_product_local(c, o);
    sh_rotate_y(y, o);
    sh_rotate_z(z, o);
}

/* pi, 2 pi/3, pi/4, 0, -pi/24, 0, pi/64, 0, -pi/128: the cosine's share of band l. */
float sh_diffuse_zonal(int l)
{
    return l == 0 ? SH_PI : l == 1 ? SH_PI * 2.0 / 3.0 : l == 2 ? SH_PI / 4.0 : l == 4 ? -SH_PI / 24.0
         : l == 6 ? SH_PI / 64.0 : l == 8 ? -SH_PI / 128.0 : 0.0;
}

/* ---- interpolation in one cell of a grid ---- */

const int SH_TRILINEAR = 0, SH_HERMITE_ZERO = 3, SH_EDGE_HERMITE = 5;   /* as in sh_interp.h */

/* Corner k = (k&1, k>>1&1, k>>2) of a cell, t in [0,1]^3: coefficient = sum over k of dot(w[k], node k) where
 * node = vec4(value, gradient) and w = (weight of the value, weights of the gradient).
 * Edge Hermite is trilinear plus a cubic along each of the 12 edges; it reproduces all cubics. */
void sh_grid_weights(int scheme, vec3 t, vec3 cell, out vec4 w[8])
{
    vec3 s = t * t * (3.0 - 2.0 * t);                           /* Hermite's value and slope polynomials */
    vec3 slope0 = t * (1.0 - t) * (1.0 - t), slope1 = -t * t * (1.0 - t);
    for (int k = 0; k < 8; k++) {
        bvec3 far = bvec3((k & 1) != 0, (k & 2) != 0, (k & 4) != 0);
        vec3 line = mix(1.0 - t, t, vec3(far)), cubic = mix(1.0 - s, s, vec3(far));
        vec3 slope = cell * mix(slope0, slope1, vec3(far));
        vec3 side = line.yzx * line.zxy;                        /* bilinear across the edge along x, y, z */
        if (scheme == SH_TRILINEAR)
            w[k] = vec4(line.x * side.x, vec3(0.0));
        else if (scheme == SH_HERMITE_ZERO)
            w[k] = vec4(cubic.x * cubic.y * cubic.z, slope * cubic.yzx * cubic.zxy);
        else
            w[k] = vec4(line.x * side.x + dot(cubic - line, side), slope * side);
    }
}

/* ---- products and turns, each constant in its place ---- */

/* BEGIN gen_glsl.py: straight lines */
/* M_ij = integral of Y_i max(0,z) Y_j: equal m, bands of equal parity or neighbours (MP21, Eq. 11) */
void sh_cosine_product_local(const in float c[SH_N], out float o[SH_N])
{
    o[0] = 0.25*c[0];
#if SH_BANDS > 1
    o[1] = 0.1875*c[1]; o[2] = 0.288675135*c[0] + 0.375*c[2]; o[3] = 0.1875*c[3];
    o[0] += 0.288675135*c[2];
#endif
#if SH_BANDS > 2
    o[4] = 0.15625*c[4]; o[5] = 0.223606798*c[1] + 0.3125*c[5];
    o[6] = 0.139754249*c[0] + 0.25819889*c[2] + 0.3125*c[6]; o[7] = 0.223606798*c[3] + 0.3125*c[7];
    o[8] = 0.15625*c[8]; o[1] += 0.223606798*c[5]; o[0] += 0.139754249*c[6]; o[2] += 0.25819889*c[6];
    o[3] += 0.223606798*c[7];
#endif
#if SH_BANDS > 3
    o[9] = 0.13671875*c[9]; o[10] = 0.188982237*c[4] + 0.2734375*c[10];
    o[11] = 0.116926793*c[1] + 0.239045722*c[5] + 0.30078125*c[11];
    o[12] = 0.095470327*c[2] + 0.253546276*c[6] + 0.328125*c[12];
    o[13] = 0.116926793*c[3] + 0.239045722*c[7] + 0.30078125*c[13];
    o[14] = 0.188982237*c[8] + 0.2734375*c[14]; o[15] = 0.13671875*c[15]; o[4] += 0.188982237*c[10];
    o[1] += 0.116926793*c[11]; o[5] += 0.239045722*c[11]; o[2] += 0.095470327*c[12];
    o[6] += 0.253546276*c[12]; o[3] += 0.116926793*c[13]; o[7] += 0.239045722*c[13];
    o[8] += 0.188982237*c[14];
#endif
#if SH_BANDS > 4
    o[16] = 0.123046875*c[16]; o[17] = 0.166666667*c[9] + 0.24609375*c[17];
    o[18] = 0.101487352*c[4] + 0.21821789*c[10] + 0.28125*c[18];
    o[19] = 0.0956831931*c[5] + 0.243975018*c[11] + 0.31640625*c[19];
    o[20] = -0.03125*c[0] + 0.113550327*c[6] + 0.251976315*c[12] + 0.31640625*c[20];
    o[21] = 0.0956831931*c[7] + 0.243975018*c[13] + 0.31640625*c[21];
    o[22] = 0.101487352*c[8] + 0.21821789*c[14] + 0.28125*c[22];
    o[23] = 0.166666667*c[15] + 0.24609375*c[23]; o[24] = 0.123046875*c[24]; o[9] += 0.166666667*c[17];
    o[4] += 0.101487352*c[18]; o[10] += 0.21821789*c[18]; o[5] += 0.0956831931*c[19];
    o[11] += 0.243975018*c[19]; o[0] += -0.03125*c[20]; o[6] += 0.113550327*c[20];
    o[12] += 0.251976315*c[20]; o[7] += 0.0956831931*c[21]; o[13] += 0.243975018*c[21];
    o[8] += 0.101487352*c[22]; o[14] += 0.21821789*c[22]; o[15] += 0.166666667*c[23];
#endif
#if SH_BANDS > 5
    o[25] = 0.112792969*c[25]; o[26] = 0.150755672*c[16] + 0.225585938*c[26];
    o[27] = 0.0906889591*c[9] + 0.201007563*c[17] + 0.263183594*c[27];
    o[28] = 0.0906889591*c[10] + 0.230283093*c[18] + 0.30078125*c[28];
    o[29] = -0.0289695253*c[1] + 0.108394038*c[11] + 0.246182982*c[19] + 0.311523438*c[29];
    o[30] = -0.0149597986*c[2] + 0.102831614*c[12] + 0.251259454*c[20] + 0.322265625*c[30];
    o[31] = -0.0289695253*c[3] + 0.108394038*c[13] + 0.246182982*c[21] + 0.311523438*c[31];
    o[32] = 0.0906889591*c[14] + 0.230283093*c[22] + 0.30078125*c[32];
    o[33] = 0.0906889591*c[15] + 0.201007563*c[23] + 0.263183594*c[33];
    o[34] = 0.150755672*c[24] + 0.225585938*c[34]; o[35] = 0.112792969*c[35]; o[16] += 0.150755672*c[26];
    o[9] += 0.0906889591*c[27]; o[17] += 0.201007563*c[27]; o[10] += 0.0906889591*c[28];
    o[18] += 0.230283093*c[28]; o[1] += -0.0289695253*c[29]; o[11] += 0.108394038*c[29];
    o[19] += 0.246182982*c[29]; o[2] += -0.0149597986*c[30]; o[12] += 0.102831614*c[30];
    o[20] += 0.251259454*c[30]; o[3] += -0.0289695253*c[31]; o[13] += 0.108394038*c[31];
    o[21] += 0.246182982*c[31]; o[14] += 0.0906889591*c[32]; o[22] += 0.230283093*c[32];
    o[15] += 0.0906889591*c[33]; o[23] += 0.201007563*c[33]; o[24] += 0.150755672*c[34];
#endif
#if SH_BANDS > 6
    o[36] = 0.104736328*c[36]; o[37] = 0.138675049*c[25] + 0.209472656*c[37];
    o[38] = 0.0826696351*c[16] + 0.186989398*c[26] + 0.247558594*c[38];
    o[39] = 0.085380832*c[17] + 0.217262047*c[27] + 0.285644531*c[39];
    o[40] = -0.0263490968*c[4] + 0.102685442*c[18] + 0.236524958*c[28] + 0.301513672*c[40];
    o[41] = -0.016664632*c[5] + 0.102049613*c[19] + 0.247363722*c[29] + 0.317382812*c[41];
    o[42] = 0.0140841847*c[0] - 0.0251945555*c[6] + 0.109152431*c[20] + 0.250872603*c[30]
        + 0.317382812*c[42];
    o[43] = -0.016664632*c[7] + 0.102049613*c[21] + 0.247363722*c[31] + 0.317382812*c[43];
    o[44] = -0.0263490968*c[8] + 0.102685442*c[22] + 0.236524958*c[32] + 0.301513672*c[44];
    o[45] = 0.085380832*c[23] + 0.217262047*c[33] + 0.285644531*c[45];
    o[46] = 0.0826696351*c[24] + 0.186989398*c[34] + 0.247558594*c[46];
    o[47] = 0.138675049*c[35] + 0.209472656*c[47]; o[48] = 0.104736328*c[48]; o[25] += 0.138675049*c[37];
    o[16] += 0.0826696351*c[38]; o[26] += 0.186989398*c[38]; o[17] += 0.085380832*c[39];
    o[27] += 0.217262047*c[39]; o[4] += -0.0263490968*c[40]; o[18] += 0.102685442*c[40];
    o[28] += 0.236524958*c[40]; o[5] += -0.016664632*c[41]; o[19] += 0.102049613*c[41];
    o[29] += 0.247363722*c[41]; o[0] += 0.0140841847*c[42]; o[6] += -0.0251945555*c[42];
    o[20] += 0.109152431*c[42]; o[30] += 0.250872603*c[42]; o[7] += -0.016664632*c[43];
    o[21] += 0.102049613*c[43]; o[31] += 0.247363722*c[43]; o[8] += -0.0263490968*c[44];
    o[22] += 0.102685442*c[44]; o[32] += 0.236524958*c[44]; o[23] += 0.085380832*c[45];
    o[33] += 0.217262047*c[45]; o[24] += 0.0826696351*c[46]; o[34] += 0.186989398*c[46];
    o[35] += 0.138675049*c[47];
#endif
#if SH_BANDS > 7
    o[49] = 0.0981903076*c[49]; o[50] = 0.129099445*c[36] + 0.196380615*c[50];
    o[51] = 0.076432004*c[25] + 0.175411604*c[37] + 0.234146118*c[51];
    o[52] = 0.0805664062*c[26] + 0.205688338*c[38] + 0.271911621*c[52];
    o[53] = -0.0241686888*c[9] + 0.097335288*c[27] + 0.226455407*c[39] + 0.29045105*c[53];
    o[54] = -0.0167445588*c[10] + 0.0991703907*c[28] + 0.240192231*c[40] + 0.308990479*c[54];
    o[55] = 0.013865812*c[1] - 0.0237788457*c[11] + 0.107116264*c[29] + 0.248069469*c[41]
        + 0.314712524*c[55];
    o[56] = 0.00524078432*c[2] - 0.0186793373*c[12] + 0.10453477*c[30] + 0.250640206*c[42]
        + 0.32043457*c[56];
    o[57] = 0.013865812*c[3] - 0.0237788457*c[13] + 0.107116264*c[31] + 0.248069469*c[43]
        + 0.314712524*c[57];
    o[58] = -0.0167445588*c[14] + 0.0991703907*c[32] + 0.240192231*c[44] + 0.308990479*c[58];
    o[59] = -0.0241686888*c[15] + 0.097335288*c[33] + 0.226455407*c[45] + 0.29045105*c[59];
    o[60] = 0.0805664062*c[34] + 0.205688338*c[46] + 0.271911621*c[60];
    o[61] = 0.076432004*c[35] + 0.175411604*c[47] + 0.234146118*c[61];
    o[62] = 0.129099445*c[48] + 0.196380615*c[62]; o[63] = 0.0981903076*c[63]; o[36] += 0.129099445*c[50];
    o[25] += 0.076432004*c[51]; o[37] += 0.175411604*c[51]; o[26] += 0.0805664062*c[52];
    o[38] += 0.205688338*c[52]; o[9] += -0.0241686888*c[53]; o[27] += 0.097335288*c[53];
    o[39] += 0.226455407*c[53]; o[10] += -0.0167445588*c[54]; o[28] += 0.0991703907*c[54];
    o[40] += 0.240192231*c[54]; o[1] += 0.013865812*c[55]; o[11] += -0.0237788457*c[55];
    o[29] += 0.107116264*c[55]; o[41] += 0.248069469*c[55]; o[2] += 0.00524078432*c[56];
    o[12] += -0.0186793373*c[56]; o[30] += 0.10453477*c[56]; o[42] += 0.250640206*c[56];
    o[3] += 0.013865812*c[57]; o[13] += -0.0237788457*c[57]; o[31] += 0.107116264*c[57];
    o[43] += 0.248069469*c[57]; o[14] += -0.0167445588*c[58]; o[32] += 0.0991703907*c[58];
    o[44] += 0.240192231*c[58]; o[15] += -0.0241686888*c[59]; o[33] += 0.097335288*c[59];
    o[45] += 0.226455407*c[59]; o[34] += 0.0805664062*c[60]; o[46] += 0.205688338*c[60];
    o[35] += 0.076432004*c[61]; o[47] += 0.175411604*c[61]; o[48] += 0.129099445*c[62];
#endif
#if SH_BANDS > 8
    o[64] = 0.0927352905*c[64]; o[65] = 0.121267813*c[49] + 0.185470581*c[65];
    o[66] = 0.0714086532*c[36] + 0.165683374*c[50] + 0.222564697*c[66];
    o[67] = 0.0763390614*c[37] + 0.195538472*c[51] + 0.259658813*c[67];
    o[68] = -0.0223958274*c[16] + 0.0925374782*c[38] + 0.216930458*c[52] + 0.279632568*c[68];
    o[69] = -0.0163555998*c[17] + 0.0957568952*c[39] + 0.232210182*c[53] + 0.299606323*c[69];
    o[70] = 0.0130472551*c[4] - 0.0225985087*c[18] + 0.104117254*c[40] + 0.242535625*c[54]
        + 0.308685303*c[70];
    o[71] = 0.00623778102*c[5] - 0.0190992258*c[19] + 0.103950326*c[41] + 0.248525061*c[55]
        + 0.317764282*c[71];
    o[72] = -0.00805294068*c[0] + 0.0117044998*c[6] - 0.0231522044*c[20] + 0.107748148*c[42]
        + 0.250489716*c[56] + 0.317764282*c[72];
    o[73] = 0.00623778102*c[7] - 0.0190992258*c[21] + 0.103950326*c[43] + 0.248525061*c[57]
        + 0.317764282*c[73];
    o[74] = 0.0130472551*c[8] - 0.0225985087*c[22] + 0.104117254*c[44] + 0.242535625*c[58]
        + 0.308685303*c[74];
    o[75] = -0.0163555998*c[23] + 0.0957568952*c[45] + 0.232210182*c[59] + 0.299606323*c[75];
    o[76] = -0.0223958274*c[24] + 0.0925374782*c[46] + 0.216930458*c[60] + 0.279632568*c[76];
    o[77] = 0.0763390614*c[47] + 0.195538472*c[61] + 0.259658813*c[77];
    o[78] = 0.0714086532*c[48] + 0.165683374*c[62] + 0.222564697*c[78];
    o[79] = 0.121267813*c[63] + 0.185470581*c[79]; o[80] = 0.0927352905*c[80]; o[49] += 0.121267813*c[65];
    o[36] += 0.0714086532*c[66]; o[50] += 0.165683374*c[66]; o[37] += 0.0763390614*c[67];
    o[51] += 0.195538472*c[67]; o[16] += -0.0223958274*c[68]; o[38] += 0.0925374782*c[68];
    o[52] += 0.216930458*c[68]; o[17] += -0.0163555998*c[69]; o[39] += 0.0957568952*c[69];
    o[53] += 0.232210182*c[69]; o[4] += 0.0130472551*c[70]; o[18] += -0.0225985087*c[70];
    o[40] += 0.104117254*c[70]; o[54] += 0.242535625*c[70]; o[5] += 0.00623778102*c[71];
    o[19] += -0.0190992258*c[71]; o[41] += 0.103950326*c[71]; o[55] += 0.248525061*c[71];
    o[0] += -0.00805294068*c[72]; o[6] += 0.0117044998*c[72]; o[20] += -0.0231522044*c[72];
    o[42] += 0.107748148*c[72]; o[56] += 0.250489716*c[72]; o[7] += 0.00623778102*c[73];
    o[21] += -0.0190992258*c[73]; o[43] += 0.103950326*c[73]; o[57] += 0.248525061*c[73];
    o[8] += 0.0130472551*c[74]; o[22] += -0.0225985087*c[74]; o[44] += 0.104117254*c[74];
    o[58] += 0.242535625*c[74]; o[23] += -0.0163555998*c[75]; o[45] += 0.0957568952*c[75];
    o[59] += 0.232210182*c[75]; o[24] += -0.0223958274*c[76]; o[46] += 0.0925374782*c[76];
    o[60] += 0.216930458*c[76]; o[47] += 0.0763390614*c[77]; o[61] += 0.195538472*c[77];
    o[48] += 0.0714086532*c[78]; o[62] += 0.165683374*c[78]; o[63] += 0.121267813*c[79];
#endif
}

/* A quarter turn about x that takes +y to +z; its transpose is Rz(pi) X Rz(pi) */
void sh_rotate_x90(inout float f[SH_N])
{
    float c[SH_N] = f;
#if SH_BANDS > 1
    f[1] = 1.0*c[2]; f[2] = -1.0*c[1]; f[3] = 1.0*c[3];
#endif
#if SH_BANDS > 2
    f[4] = 1.0*c[7]; f[5] = -1.0*c[5]; f[6] = -0.5*c[6] - 0.866025404*c[8]; f[7] = -1.0*c[4];
    f[8] = -0.866025404*c[6] + 0.5*c[8];
#endif
#if SH_BANDS > 3
    f[9] = -0.790569415*c[12] + 0.612372436*c[14]; f[10] = -1.0*c[10];
    f[11] = -0.612372436*c[12] - 0.790569415*c[14]; f[12] = 0.790569415*c[9] + 0.612372436*c[11];
    f[13] = -0.25*c[13] - 0.968245837*c[15]; f[14] = -0.612372436*c[9] + 0.790569415*c[11];
    f[15] = -0.968245837*c[13] + 0.25*c[15];
#endif
#if SH_BANDS > 4
    f[16] = -0.935414347*c[21] + 0.353553391*c[23]; f[17] = -0.75*c[17] + 0.661437828*c[19];
    f[18] = -0.353553391*c[21] - 0.935414347*c[23]; f[19] = 0.661437828*c[17] + 0.75*c[19];
    f[20] = 0.375*c[20] + 0.559016994*c[22] + 0.739509973*c[24];
    f[21] = 0.935414347*c[16] + 0.353553391*c[18];
    f[22] = 0.559016994*c[20] + 0.5*c[22] - 0.661437828*c[24];
    f[23] = -0.353553391*c[16] + 0.935414347*c[18];
    f[24] = 0.739509973*c[20] - 0.661437828*c[22] + 0.125*c[24];
#endif
#if SH_BANDS > 5
    f[25] = 0.70156076*c[30] - 0.684653197*c[32] + 0.197642354*c[34];
    f[26] = -0.5*c[26] + 0.866025404*c[28];
    f[27] = 0.522912517*c[30] + 0.306186218*c[32] - 0.795495129*c[34];
    f[28] = 0.866025404*c[26] + 0.5*c[28];
    f[29] = 0.484122918*c[30] + 0.661437828*c[32] + 0.572821962*c[34];
    f[30] = -0.70156076*c[25] - 0.522912517*c[27] - 0.484122918*c[29];
    f[31] = 0.125*c[31] + 0.405046294*c[33] + 0.905711047*c[35];
    f[32] = 0.684653197*c[25] - 0.306186218*c[27] - 0.661437828*c[29];
    f[33] = 0.405046294*c[31] + 0.8125*c[33] - 0.419262746*c[35];
    f[34] = -0.197642354*c[25] + 0.795495129*c[27] - 0.572821962*c[29];
    f[35] = 0.905711047*c[31] - 0.419262746*c[33] + 0.0625*c[35];
#endif
#if SH_BANDS > 6
    f[36] = 0.879452955*c[43] - 0.463512405*c[45] + 0.108253175*c[47];
    f[37] = -0.3125*c[37] + 0.802827036*c[39] - 0.5077524*c[41];
    f[38] = 0.433012702*c[43] + 0.684653197*c[45] - 0.58630197*c[47];
    f[39] = 0.802827036*c[37] - 0.0625*c[39] - 0.592927061*c[41];
    f[40] = 0.197642354*c[43] + 0.5625*c[45] + 0.802827036*c[47];
    f[41] = -0.5077524*c[37] - 0.592927061*c[39] - 0.625*c[41];
    f[42] = -0.3125*c[42] - 0.452855523*c[44] - 0.496078371*c[46] - 0.671693289*c[48];
    f[43] = -0.879452955*c[36] - 0.433012702*c[38] - 0.197642354*c[40];
    f[44] = -0.452855523*c[42] - 0.53125*c[44] - 0.171163299*c[46] + 0.695268608*c[48];
    f[45] = 0.463512405*c[36] - 0.684653197*c[38] - 0.5625*c[40];
    f[46] = -0.496078371*c[42] - 0.171163299*c[44] + 0.8125*c[46] - 0.2538762*c[48];
    f[47] = -0.108253175*c[36] + 0.58630197*c[38] - 0.802827036*c[40];
    f[48] = -0.671693289*c[42] + 0.695268608*c[44] - 0.2538762*c[46] + 0.03125*c[48];
#endif
#if SH_BANDS > 7
    f[49] = -0.647259849*c[56] + 0.699120541*c[58] - 0.298106*c[60] + 0.0584633967*c[62];
    f[50] = -0.1875*c[50] + 0.637377439*c[52] - 0.747391296*c[54];
    f[51] = -0.47495888*c[56] - 0.0732877462*c[58] + 0.78125*c[60] - 0.398360899*c[62];
    f[52] = 0.637377439*c[50] - 0.5*c[52] - 0.58630197*c[54];
    f[53] = -0.429616471*c[56] - 0.419844651*c[58] + 0.103644525*c[60] + 0.792728181*c[62];
    f[54] = -0.747391296*c[50] - 0.58630197*c[52] - 0.3125*c[54];
    f[55] = -0.413398642*c[56] - 0.574099158*c[58] - 0.538552748*c[60] - 0.457681829*c[62];
    f[56] = 0.647259849*c[49] + 0.47495888*c[51] + 0.429616471*c[53] + 0.413398642*c[55];
    f[57] = -0.078125*c[57] - 0.243569645*c[59] - 0.448793957*c[61] - 0.856244297*c[63];
    f[58] = -0.699120541*c[49] + 0.0732877462*c[51] + 0.419844651*c[53] + 0.574099158*c[55];
    f[59] = -0.243569645*c[57] - 0.609375*c[59] - 0.570044886*c[61] + 0.494352876*c[63];
    f[60] = 0.298106*c[49] - 0.78125*c[51] - 0.103644525*c[53] + 0.538552748*c[55];
    f[61] = -0.448793957*c[57] - 0.570044886*c[59] + 0.671875*c[61] - 0.149053*c[63];
    f[62] = -0.0584633967*c[49] + 0.398360899*c[51] - 0.792728181*c[53] + 0.457681829*c[55];
    f[63] = -0.856244297*c[57] + 0.494352876*c[59] - 0.149053*c[61] + 0.015625*c[63];
#endif
#if SH_BANDS > 8
    f[64] = -0.835608872*c[73] + 0.516334739*c[75] - 0.184877493*c[77] + 0.03125*c[79];
    f[65] = -0.109375*c[65] + 0.462193733*c[67] - 0.774502108*c[69] + 0.417804436*c[71];
    f[66] = -0.457681829*c[73] - 0.471346973*c[75] + 0.708831014*c[77] - 0.256744949*c[79];
    f[67] = 0.462193733*c[65] - 0.703125*c[67] - 0.218191251*c[69] + 0.494352876*c[71];
    f[68] = -0.274217637*c[73] - 0.605153648*c[75] - 0.338020432*c[77] + 0.666585281*c[79];
    f[69] = -0.774502108*c[65] - 0.218191251*c[67] + 0.265625*c[69] + 0.531020171*c[71];
    f[70] = -0.130728129*c[73] - 0.3808143*c[75] - 0.5908647*c[77] - 0.699120541*c[79];
    f[71] = 0.417804436*c[65] + 0.494352876*c[67] + 0.531020171*c[69] + 0.546875*c[71];
    f[72] = 0.2734375*c[72] + 0.392184387*c[74] + 0.411326456*c[76] + 0.457681829*c[78]
        + 0.626706654*c[80];
    f[73] = 0.835608872*c[64] + 0.457681829*c[66] + 0.274217637*c[68] + 0.130728129*c[70];
    f[74] = 0.392184387*c[72] + 0.5*c[74] + 0.327752765*c[76] - 0.699120541*c[80];
    f[75] = -0.516334739*c[64] + 0.471346973*c[66] + 0.605153648*c[68] + 0.3808143*c[70];
    f[76] = 0.411326456*c[72] + 0.327752765*c[74] - 0.28125*c[76] - 0.73020759*c[78] + 0.333292641*c[80];
    f[77] = 0.184877493*c[64] - 0.708831014*c[66] + 0.338020432*c[68] + 0.5908647*c[70];
    f[78] = 0.457681829*c[72] - 0.73020759*c[76] + 0.5*c[78] - 0.0855816496*c[80];
    f[79] = -0.03125*c[64] + 0.256744949*c[66] - 0.666585281*c[68] + 0.699120541*c[70];
    f[80] = 0.626706654*c[72] - 0.699120541*c[74] + 0.333292641*c[76] - 0.0855816496*c[78]
        + 0.0078125*c[80];
#endif
}
/* END gen_glsl.py */
