/* grid.comp - pass 1: coefficients and gradients of the lights at every node of the grid.
 *
 * One work group per node. Its threads are LANES lights by ROWS rows; each sums what its lights give to its
 * row, and the lanes are added up at the end. FORM selects what a thread keeps while it walks over the lights:
 *
 *     FORWARD   all n^2 coefficients and gradients: ROWS = 1 (M22's "forward")
 *     REVERSE   those of one signed m, m outside the loop over lights: ROWS = 2n-1 (M22's "reverse")
 *     MOMENTS   three sums of plain basis values of one signed m: ROWS = 2n+1. The gradient appears after the
 *               last light, by a small sparse product: d/dx_k [f(d) Y_lm] lies in bands l-1 and l+1, with
 *               radial factors f' + (l+1) f/d and f' - l f/d and coefficients that know nothing of the light.
 *     COEFFICIENTS  those of REVERSE without gradients: what trilinear interpolation needs
 *     EXACT     exact triangles, in the rows of REVERSE; the lanes are nodes of a triangle
 *
 * With TRIANGLES each sphere stands for a triangle (M22, 4.4): its light is scaled by the cosine to the
 * triangle's normal, whose own gradient adds a term along the normal. */
#define FORWARD 0
#define REVERSE 1
#define MOMENTS 2
#define COEFFICIENTS 3
#define EXACT   4
#define LANES   8
#define ROWS    (FORM == FORWARD ? 1 : FORM == MOMENTS ? 2 * SH_BANDS + 1 : 2 * SH_BANDS - 1)

#define TOP     (FORM == MOMENTS ? SH_BANDS : SH_BANDS - 1)             /* the highest band summed */
#define KEPT    (FORM == MOMENTS ? 3 + 3 * TRIANGLES : FORM == COEFFICIENTS ? 1 : 4)     /* sums per coefficient */
#define VALUES  (FORM == FORWARD ? 4 * SH_N : KEPT * (TOP + 1))         /* of a thread */
#define CHUNK   32                                                      /* lights prepared at once */
#define BATCH   4                                                       /* values reduced at once */

layout(local_size_x = LANES, local_size_y = ROWS) in;

struct Light { vec4 sphere, radiance, normal, corner[3]; };
layout(std430, binding = 0) readonly buffer Lights { Light light[]; };
layout(std430, binding = 1) buffer Nodes { vec4 node[]; };              /* [node][coefficient][channel] */
uniform int first, last;                                                /* of the lights */
uniform ivec3 count;
uniform vec3 origin, cell;
uniform bool add;                                                       /* to what the nodes hold */

int place;                                                              /* the node's */
vec3 point;
int row, lane, order;                                                   /* order: m of the row */
vec2 climb[TOP + 1];                                                    /* from l = |m| + j to l + 1 */

shared vec3 u_of[CHUNK], radiance_of[CHUNK];
shared vec3 turn_of[CHUNK];                                             /* gradient of the cosine / cosine */
shared float distance_of[CHUNK], weight_of[3][SH_BANDS + 1][CHUNK];
shared vec3 part[ROWS][BATCH][LANES + 1];
#if FORM == MOMENTS
shared vec3 moment[KEPT][(SH_BANDS + 1) * (SH_BANDS + 1)];
#elif FORM == EXACT
shared sh_node node_of[ROWS][LANES];
shared int octets_of[ROWS];
shared float angle_of[ROWS];
#endif

void put(int i, int plane, vec3 rgb)
{
    int at = (place * SH_N + i) * 3;
    for (int k = 0; k < 3; k++) node[at + k][plane] = rgb[k] + (add ? node[at + k][plane] : 0.0);
}

/* ---- before: one thread per light of the chunk works out what all rows need ---- */

void prepare(int slot, Light light)
{
    float g[SH_BANDS], dg[SH_BANDS];
    vec3 v = light.sphere.xyz - point;
    float d = length(v), cosine = 1.0;
    vec3 u = d > 0.0 ? v / d : vec3(0.0, 0.0, 1.0);
    d = max(d, 1e-18);                                                 /* at the centre: inside, and finite */
    sh_sphere_weights(d, light.sphere.w, g, dg);
#if TRIANGLES
    vec3 n = dot(light.normal.xyz, u) < 0.0 ? -light.normal.xyz : light.normal.xyz;
    cosine = dot(n, u);
    turn_of[slot] = -(n - u * cosine) / (d * max(cosine, 1e-30));
#endif
    u_of[slot] = u;
    distance_of[slot] = d;
    radiance_of[slot] = light.radiance.rgb * cosine;
    for (int l = 0; l < SH_BANDS; l++) {
        weight_of[0][l][slot] = g[l];
#if FORM == MOMENTS                                                     /* at the basis' band: l-1 and l+1 */
        if (l > 0) weight_of[1][l - 1][slot] = dg[l] + float(l + 1) * g[l] / d;
        weight_of[2][l + 1][slot] = dg[l] - float(l) * g[l] / d;
#else
        weight_of[1][l][slot] = dg[l];
#endif
    }
}

/* ---- during: a light's part in the sums of a thread ---- */

vec2 power(vec2 p, int m)
{
    vec2 e = vec2(1.0, 0.0);
    while (m-- > 0) e = sh_times(e, p);
    return e;
}

#if FORM == EXACT
void accumulate(sh_node p, vec3 radiance, inout vec3 sum[VALUES])
{
    int m = abs(order);
    vec2 e1 = m > 0 ? power(p.u.xy, m - 1) : vec2(0.0), e = m > 0 ? sh_times(e1, p.u.xy) : vec2(1.0, 0.0);
    if (order < 0) { e = vec2(e.y, -e.x); e1 = vec2(e1.y, -e1.x); }     /* the imaginary parts */
    sh_column c = sh_first(m);
    for (int j = 0; j <= TOP; j++) {
        if (m + j <= TOP) {
            vec4 part = sh_node_part(p, c, m + j, m, e, e1);
            for (int k = 0; k < 4; k++) sum[4 * j + k] += part[k] * radiance;
        }
        sh_climb(c, climb[j], p.u.z);
    }
}

/* One triangle per row: each row works out the nodes of its own, one per lane, and sums up those of all. */
void add_triangles(int start, inout vec3 sum[VALUES])
{
    bool mine = start + row < last;
    int i = min(start + row, last - 1), most = 0;
    sh_seen t = sh_triangle_of(SH_BANDS, point, light[i].corner[0].xyz, light[i].corner[1].xyz, light[i].corner[2].xyz);
    if (lane == 0) {
        octets_of[row] = mine ? t.octets : 0;
        angle_of[row] = mine ? t.angle : 0.0;
        radiance_of[row] = light[i].radiance.rgb;
    }
    barrier();
    for (int r = 0; r < ROWS; r++) {
        most = max(most, octets_of[r]);
        if (order == 0 && lane == 0) sum[0] += angle_of[r] * SH_K[0] * radiance_of[r];
    }
    for (int octet = 0; octet < most; octet++) {
        if (mine && octet < t.octets) node_of[row][lane] = sh_triangle_node(t, octet, lane);
        barrier();
        for (int r = 0; r < ROWS; r++)
            if (octet < octets_of[r]) accumulate(node_of[r][lane], radiance_of[r], sum);
        barrier();
    }
}
#elif FORM == FORWARD
void accumulate(int slot, inout vec3 sum[VALUES])
{
    float g[SH_BANDS], dg[SH_BANDS], c[SH_N];
    vec3 grad[SH_N], radiance = radiance_of[slot];
    for (int l = 0; l < SH_BANDS; l++) {
        g[l] = weight_of[0][l][slot];
        dg[l] = weight_of[1][l][slot];
    }
    sh_zonal_light(u_of[slot] * distance_of[slot], g, dg, c, grad);
    for (int i = 0; i < SH_N; i++) {
#if TRIANGLES
        grad[i] += c[i] * turn_of[slot];
#endif
        sum[4 * i] += radiance * c[i];
        for (int k = 0; k < 3; k++) sum[4 * i + 1 + k] += radiance * grad[i][k];
    }
}
#else
void accumulate(int slot, inout vec3 sum[VALUES])
{
    int m = abs(order);
    vec3 u = u_of[slot], radiance = radiance_of[slot];
    vec2 e1 = m > 0 ? power(u.xy, m - 1) : vec2(0.0), e = m > 0 ? sh_times(e1, u.xy) : vec2(1.0, 0.0);
    if (order < 0) { e = vec2(e.y, -e.x); e1 = vec2(e1.y, -e1.x); }     /* the imaginary parts */
    sh_column c = sh_first(m);
    for (int j = 0; j <= TOP; j++) {
        int l = m + j;
        if (l <= TOP) {
#if FORM == MOMENTS
        vec3 y = radiance * (c.q * e.x);
        if (l < SH_BANDS) sum[KEPT * j] += weight_of[0][l][slot] * y;
        if (l < SH_BANDS - 1) sum[KEPT * j + 1] += weight_of[1][l][slot] * y;
        if (l > 0) sum[KEPT * j + 2] += weight_of[2][l][slot] * y;
#if TRIANGLES
        if (l < SH_BANDS)
            for (int k = 0; k < 3; k++) sum[KEPT * j + 3 + k] += (weight_of[0][l][slot] * turn_of[slot][k]) * y;
#endif
#else
        float y = c.q * e.x, g = weight_of[0][l][slot];
        sum[KEPT * j] += (g * y) * radiance;
#if FORM == REVERSE
        vec3 t = sh_polynomial_grad(c, m, e, e1);
        vec3 grad = -(weight_of[1][l][slot] * y * u + (g / distance_of[slot]) * (t - u * dot(u, t)));
#if TRIANGLES
        grad += (g * y) * turn_of[slot];
#endif
        for (int k = 0; k < 3; k++) sum[4 * j + 1 + k] += grad[k] * radiance;
#endif
#endif
        }
        sh_climb(c, climb[j], u.z);
    }
}
#endif

/* ---- after: the sum over the lanes, and where it goes ---- */

void store(int value, vec3 total)
{
#if FORM == FORWARD
    put(value / 4, value % 4, total);
#else
    int l = abs(order) + value / KEPT, i = l * (l + 1) + order;
    if (l > TOP) return;
#if FORM == MOMENTS
    moment[value % KEPT][i] = total;
#else
    put(i, value % KEPT, total);
#endif
#endif
}

void reduce(const in vec3 sum[VALUES])
{
    for (int base = 0; base < VALUES; base += BATCH) {
        for (int k = 0; k < BATCH; k++)
            if (base + k < VALUES) part[row][k][lane] = sum[base + k];
        barrier();
        if (lane < BATCH && base + lane < VALUES) {
            vec3 total = vec3(0.0);
            for (int k = 0; k < LANES; k++) total += part[row][lane][k];
            store(base + lane, total);
        }
        barrier();
    }
}

#if FORM == MOMENTS
/* Y_{l,m} + i Y_{l,-m} of a sum; at m = 0 times sqrt(2), at m = -1 minus the conjugate of m = 1. */
mat2x3 pair(int sum, int l, int m)
{
    int i = l * (l + 1), s = abs(m);
    if (s > l) return mat2x3(0.0);
    if (m == 0) return mat2x3(sqrt(2.0) * moment[sum][i], vec3(0.0));
    return mat2x3(float(sign(m)) * moment[sum][i + s], moment[sum][i - s]);
}

/* x, y and z times Y_lm, l climbing (step = 1) or falling (-1): the neighbours m+1, m-1 and m. */
void couple(int sum, int l, int m, int step, out mat2x3 x, out mat2x3 y, out mat2x3 z)
{
    float top = float(step > 0 ? l + 1 : l), f = float(m), scale = inversesqrt(4.0 * top * top - 1.0);
    float s = float(step), t = step > 0 ? top : top - 1.0;
    mat2x3 right = pair(sum, l + step, m + 1) * (-s * 0.5 * scale * sqrt((t + s * f) * (t + s * f + 1.0)));
    mat2x3 left  = pair(sum, l + step, m - 1) * ( s * 0.5 * scale * sqrt((t - s * f) * (t - s * f + 1.0)));
    x = right + left;
    y = mat2x3(right[1] - left[1], left[0] - right[0]);
    z = pair(sum, l + step, m) * (scale * sqrt(top * top - f * f));
}

void finish(int l, int m)
{
    mat2x3 x = mat2x3(0.0), y = x, z = x, x1, y1, z1;
    int i = l * (l + 1), s = abs(m);
    couple(2, l, s, 1, x, y, z);
    if (l > 0) {
        couple(1, l, s, -1, x1, y1, z1);
        x += x1; y += y1; z += z1;
    }
    float scale = m == 0 ? -sqrt(0.5) : -1.0;                           /* by the point, not by the light */
    int part = m < 0 ? 1 : 0;
    vec3 grad[3] = vec3[3](scale * x[part], scale * y[part], scale * z[part]);
    put(i + m, 0, moment[0][i + m]);
    for (int k = 0; k < 3; k++) {
#if TRIANGLES
        grad[k] += moment[3 + k][i + m];
#endif
        put(i + m, 1 + k, grad[k]);
    }
}
#endif

void main()
{
    place = int(gl_WorkGroupID.x);
    precise vec3 at = cell * vec3(place % count.x, place / count.x % count.y, place / (count.x * count.y));
    at += origin;                                                    /* rounded twice, as the check does it */
    point = at;
    lane = int(gl_LocalInvocationID.x);
    row = int(gl_LocalInvocationID.y);
    order = row - ROWS / 2;
    for (int j = 0; j <= TOP; j++) climb[j] = sh_step(min(abs(order) + j + 1, TOP + 1), abs(order));

    vec3 sum[VALUES];
    for (int i = 0; i < VALUES; i++) sum[i] = vec3(0.0);
#if FORM == EXACT
    for (int start = first; start < last; start += ROWS) {
        add_triangles(start, sum);
        barrier();
    }
#else
    for (int start = first; start < last; start += CHUNK) {
        int here = min(CHUNK, last - start);
        for (int i = int(gl_LocalInvocationIndex); i < here; i += LANES * ROWS) prepare(i, light[start + i]);
        barrier();
        for (int i = lane; i < here; i += LANES) accumulate(i, sum);
        barrier();
    }
#endif
    reduce(sum);
#if FORM == MOMENTS
    for (int i = int(gl_LocalInvocationIndex); i < SH_N; i += LANES * ROWS) {
        int l = int(sqrt(float(i) + 0.5));
        finish(l, i - l * (l + 1));
    }
#endif
}
