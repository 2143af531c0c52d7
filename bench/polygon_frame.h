/* polygon_frame.h - an edge's light in closed form in the frame of its arc, turned to the world: the row
 * `edge_frame`.
 *
 * In the frame [middle, along, normal] the integrals over the arc are I_0 = gamma, I_k = 2 sin(k gamma/2)/k,
 * and
 *     e_{l,m} = dY_lm/dz(1,0,0)/(l(l+1)) I_m            l >= 1, m >= 0, l+m odd:   light += M e
 *     f_{l,m} = Y_lm(1,0,0) kc (I_{m-1} + I_{m+1})/2,   f_{l,-m} = Y_lm(1,0,0) ks (I_{m-1} - I_{m+1})/2
 *                                                       l+m even:                  gradient += (M f) normal^T
 * with 1/|p| = kc cos + ks sin from the middle. M = Z(a) X^T Z(b) X Z(g), X the rotation by 90 degrees about
 * x: sparse, and it takes l+m odd to sines only, l+m even to cosines only, so that the two vectors share one
 * pass over its entries.
 *
 * Included with V (a real, or a vector of them), V_SQRT(v) and FRAME(name) defined. */
INLINE void FRAME(frame_edge)(const int bands, const int gradient, const polygon_frame *table, const V mid[3],
                              const V along[3], const V mu[3], const V gamma, const V ch, const V sh,
                              const V kc, const V ks, V *RESTRICT out)
{
    enum { MAX = POLYGON_MAX_BANDS, ROW = 2 * MAX - 1 };
    const int size = bands * bands;
    V ca[MAX], sa[MAX], cb[MAX], sb[MAX], cg[MAX], sg[MAX], integral[MAX + 2], x, r, c, s;
    int l, m, i, k;

    /* Euler angles as cosines and sines; the first is anything where the normal is an axis' */
    x = mu[0] + C(1e-18);
    r = x * x + mu[1] * mu[1];
    s = V_SQRT(r);
    ca[0] = cb[0] = cg[0] = 0 * x + 1;
    sa[0] = sb[0] = sg[0] = 0 * x;
    ca[1] = x / s;
    sa[1] = mu[1] / s;
    cb[1] = mu[2];
    sb[1] = s;
    cg[1] = ca[1] * along[1] - sa[1] * along[0];
    sg[1] = ca[1] * mid[1] - sa[1] * mid[0];
    for (m = 2; m < bands; m++) {
        ca[m] = ca[m - 1] * ca[1] - sa[m - 1] * sa[1];
        sa[m] = ca[m - 1] * sa[1] + sa[m - 1] * ca[1];
        cb[m] = cb[m - 1] * cb[1] - sb[m - 1] * sb[1];
        sb[m] = cb[m - 1] * sb[1] + sb[m - 1] * cb[1];
        cg[m] = cg[m - 1] * cg[1] - sg[m - 1] * sg[1];
        sg[m] = cg[m - 1] * sg[1] + sg[m - 1] * cg[1];
    }
    integral[0] = gamma;
    c = ch;
    s = sh;
    for (k = 1; k <= bands; k++) {
        const V next = c * ch - s * sh;
        integral[k] = (C(2) / C(k)) * s;
        s = c * sh + s * ch;
        c = next;
    }
    for (l = 0; l < bands; l++) {
        const int at = l * (l + 1), rows = 2 * l + 1;
        V u[ROW], v[ROW], w[ROW];
        int part;
        for (part = l == 0; part < (gradient ? 2 : 1); part++) {
            /* part 0: e, 1: f; turned about z */
            for (m = l & 1 ? part : 1 - part; m <= l; m += 2) {
                if (!part) {
                    const V e = table->value[at + m] * integral[m];
                    u[l + m] = e * cg[m];
                    u[l - m] = m ? e * sg[m] : u[l];
                } else {
                    const real half = C(0.5) * table->slope[at + m];
                    const V before = integral[m ? m - 1 : 1], fc = half * (kc * (before + integral[m + 1]));
                    const V fs = half * (ks * (before - integral[m + 1]));
                    u[l + m] = m ? fc * cg[m] - fs * sg[m] : fc;
                    u[l - m] = m ? fc * sg[m] + fs * cg[m] : fc;
                }
            }
            /* X: sines (rows below l) of part 0, cosines of part 1; then about z */
            v[l] = 0 * kc;
            for (m = !part; m <= l; m++) {
                const int row = at + (part ? m : -m);
                const real *entry = table->x + table->start[row];
                V sum = 0 * kc;
                for (i = table->first[row]; i < table->last[row]; i += 2) sum += *entry++ * u[i];
                v[l + m] = part ? sum * cb[m] : -(sum * sb[m]);
                if (m) v[l - m] = part ? sum * sb[m] : sum * cb[m];
            }
            /* X^T, and about z once more */
            for (i = 0; i < rows; i++) w[i] = 0 * kc;
            for (i = 0; i < rows; i++) {
                const int row = at - l + i;
                const real *entry = table->x + table->start[row];
                for (k = table->first[row]; k < table->last[row]; k += 2) w[k] += *entry++ * v[i];
            }
            for (m = 0; m <= l; m++) {
                const V cosine = m ? w[l + m] * ca[m] - w[l - m] * sa[m] : w[l];
                const V sine = m ? w[l + m] * sa[m] + w[l - m] * ca[m] : w[l];
                if (!part) {
                    out[at + m] += cosine;
                    if (m) out[at - m] += sine;
                    continue;
                }
                for (k = 0; k < 3; k++) {
                    out[(k + 1) * size + at + m] += cosine * mu[k];
                    if (m) out[(k + 1) * size + at - m] += sine * mu[k];
                }
            }
        }
    }
}
