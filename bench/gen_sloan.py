#!/usr/bin/env python3
"""Prints bench/sloan.h: the recurrences of Sloan 2013 and M22 as straight-line scalar code.

    python3 bench/gen_sloan.py > bench/sloan.h

For each m the column of Legendre derivatives X_l^m = (-1)^m J_lm Q_l^m (M22 Eq. 30) goes up in l: the first four
members are explicit polynomials in z (M22 Eq. 32, with the z^2 that Eq. 8.4 lost), the rest follow from the two
before. Every factor is folded into one constant at full digits. `bands` is a compile-time constant at every call, so
the guards vanish and each band count gets its own body.
"""
import sys
from mpmath import mp, mpf, sqrt, pi, factorial

mp.dps = 40
MAX = 10


def norm(l, m):
    """(-1)^m J_lm: normalisation with the Condon-Shortley factor."""
    j = sqrt((2 * l + 1) / (4 * pi) * factorial(l - m) / factorial(l + m))
    return (-1) ** m * j * (sqrt(2) if m else 1)


def odd_factorial(m):
    r = mpf(1)
    for i in range(1, 2 * m, 2):
        r *= i
    return r


def c(value):
    return 'C(%s)' % mp.nstr(value, 17, min_fixed=-5, max_fixed=20)


def signed(value):
    """' + C(v)' or ' - C(v)', for the second term of a sum."""
    return (' - ' if value < 0 else ' + ') + c(abs(value))


def legendre(l, m):
    """Explicit coefficients of Q_{m+j}^m, j = l - m < 4, highest power of z first, two powers apart."""
    q = odd_factorial(m)
    j = l - m
    if j == 0:
        return [q]
    if j == 1:
        return [q * (2 * m + 1)]
    if j == 2:
        return [q * (2 * m + 1) * (2 * m + 3) / 2, -q * (2 * m + 1) / 2]
    a = q * (2 * m + 1) * (2 * m + 3) * (2 * m + 5) / 6
    return [a, -q * 3 * (2 * m + 1) * (2 * m + 3) / 6]


def ratios(l, m):
    """X_l = a z X_{l-1} + b X_{l-2}"""
    return (mpf(2 * l - 1) / (l - m) * norm(l, m) / norm(l - 1, m),
            -mpf(l + m - 1) / (l - m) * norm(l, m) / norm(l - 2, m))


def x_expression(l, m, x):
    """Right-hand side of X_l^m; x(l) names an earlier member of the column."""
    j = l - m
    if j < 4:
        k = [norm(l, m) * v for v in legendre(l, m)]
        return (c(k[0]), c(k[0]) + ' * z', c(k[0]) + ' * zz' + (signed(k[1]) if j > 1 else ''),
                'z * (' + c(k[0]) + ' * zz' + (signed(k[1]) if j > 1 else '') + ')')[j]
    a, b = ratios(l, m)
    return '%s * z * %s%s * %s' % (c(a), x(l - 1), signed(b), x(l - 2))


def z_expression(l, m, x, z):
    """Right-hand side of Z_l^m = d X_l^m / d theta (M22 Eq. 33); sz = sin(theta) cos(theta)."""
    j = l - m
    if j < 4:
        k = [norm(l, m) * v for v in legendre(l, m)]
        return ('', c(-k[0]) + ' * st', c(-2 * k[0]) + ' * sz',
                'st * (' + c(-3 * k[0]) + ' * zz' + (signed(-k[1]) if j > 1 else '') + ')')[j]
    a, b = ratios(l, m)
    return '%s * (z * %s - st * %s)%s * %s' % (c(a), z(l - 1), x(l - 1), signed(b), z(l - 2))


def declare(names):
    """Zero-initialised declarations, wrapped."""
    line = '    real ' + ', '.join('%s = 0' % n for n in names) + ';'
    while len(line) > 108:
        cut = line.rfind(',', 0, 108)
        print(line[:cut + 1])
        line = '        ' + line[cut + 1:]
    print(line)


def advance(m, out):
    """(u, v) = (x + iy)^m"""
    if m == 1:
        out('u = x; v = y;')
    elif m > 1:
        out('t = x * u - y * v; v = x * v + y * u; u = t;')


def emit(line):
    """One line, or several, broken after a statement, each within 110 columns."""
    indent = '    '
    while len(indent + line) > 110:
        cut = line.rfind('; ', 0, 108 - len(indent)) + 1 or line.rfind(' - ', 0, 108 - len(indent))
        print(indent + line[:cut])
        indent, line = '        ', line[cut + 1:]
    print(indent + line)


def values():
    print('/* Y of a unit direction: Sloan 2013. */')
    print('INLINE void sloan_values(const int bands, const real dir[3], real *RESTRICT out)')
    print('{')
    emit('const real x = dir[0], y = dir[1], z = dir[2], zz = z * z;')
    emit('real u = 1, v = 0, t;')
    declare(['q%d' % l for l in range(MAX)])
    for m in range(MAX):
        print()
        if m:
            emit('if (bands <= %d) return;' % m)
        advance(m, emit)
        for l in range(m, MAX):
            i = l * l + l
            store = 'out[%d] = q%d;' % (i, l) if m == 0 else \
                'out[%d] = q%d * u; out[%d] = q%d * v;' % (i + m, l, i - m, l)
            value = 'q%d = %s; ' % (l, x_expression(l, m, lambda k: 'q%d' % k))
            emit(('if (bands > %d) { ' % l if l > m else '{ ') + value + store + ' }')
    print('}')


PUT = '''
/* What to do with a value and its two derivatives: keep them, or turn them into x, y, z by M22 Eq. 23, whose matrix
 * is j = { x theta, x phi, y theta, y phi, z theta }. */
INLINE void sloan_put(const int cartesian, const real *RESTRICT j, const int i, const real value, const real theta,
                      const real phi, real *RESTRICT out, real *RESTRICT d0, real *RESTRICT d1, real *RESTRICT d2)
{
    out[i] = value;
    d0[i] = cartesian ? j[0] * theta + j[1] * phi : theta;
    d1[i] = cartesian ? j[2] * theta + j[3] * phi : phi;
    if (cartesian) d2[i] = j[4] * theta;
}

/* The same for m = 0, where nothing depends on phi. */
INLINE void sloan_put_zonal(const int cartesian, const real *RESTRICT j, const int i, const real value,
                            const real theta, real *RESTRICT out, real *RESTRICT d0, real *RESTRICT d1,
                            real *RESTRICT d2)
{
    out[i] = value;
    d0[i] = cartesian ? j[0] * theta : theta;
    d1[i] = cartesian ? j[2] * theta : 0;
    if (cartesian) d2[i] = j[4] * theta;
}
#define PUT(i, value, theta, phi) sloan_put(cartesian, j, i, value, theta, phi, out, d0, d1, d2)
#define PUT_ZONAL(i, value, theta) sloan_put_zonal(cartesian, j, i, value, theta, out, d0, d1, d2)'''


def put(l, m, q, derivative):
    """Both members of the pair (l, +-m), or the zonal one."""
    i = l * l + l
    if m == 0:
        emit('    PUT_ZONAL(%d, %s, %s);' % (i, q, derivative))
    else:
        emit('    t = %s;' % derivative)
        emit('    PUT(%d, %s * u, t * u, -(%s * mv));' % (i + m, q, q))
        emit('    PUT(%d, %s * v, t * v, %s * mu);' % (i - m, q, q))


def sloan_like():
    print('''
/* Y and its derivatives: M22 Eq. 17, 31-33. cot = cos(theta)/sin(theta); (x, y, z) is the unit direction,
 * st = sin(theta). As printed there, singular on the z axis. */
INLINE void m22_sloan_like(const int cartesian, const int bands, const real dir[3], const real st,
                           const real cot, const real *RESTRICT j, real *RESTRICT out, real *RESTRICT d0,
                           real *RESTRICT d1, real *RESTRICT d2)
{''')
    emit('const real x = dir[0], y = dir[1], z = dir[2], zz = z * z, sz = st * z;')
    emit('real u = 1, v = 0, t, mc, mu, mv;')
    declare(['q%d' % l for l in range(MAX)])
    declare(['z%d' % l for l in range(1, MAX)])
    for m in range(MAX):
        print()
        if m:
            emit('if (bands <= %d) return;' % m)
            advance(m, emit)
            emit('mc = %s * cot; mu = %s * u; mv = %s * v;' % (c(mpf(m)), c(mpf(m)), c(mpf(m))))
        for l in range(m, MAX):
            q = 'q%d' % l
            emit('if (bands > %d) {' % l if l > m else '{')
            emit('    %s = %s;' % (q, x_expression(l, m, lambda k: 'q%d' % k)))
            if l > m:
                emit('    z%d = %s;' % (l, z_expression(l, m, lambda k: 'q%d' % k, lambda k: 'z%d' % k)))
            z = 'z%d' % l if l > m else ''
            put(l, m, q, (z or '0') if m == 0 else '%s * mc' % q + (' + ' + z if z else ''))
            emit('}')
    print('}')


def direct():
    print('''
/* The same by M22 Eq. 17-19: the derivative of P_l^m from P_l^{m-1} and P_l^{m+1}; is = 1/sin(theta). */
INLINE void m22_direct(const int cartesian, const int bands, const real dir[3], const real st,
                       const real is, const real *RESTRICT j, real *RESTRICT out, real *RESTRICT d0,
                       real *RESTRICT d1, real *RESTRICT d2)
{''')
    emit('const real x = dir[0], y = dir[1], z = dir[2], zz = z * z;')
    emit('real u = 1, v = 0, t, mu, mv;')
    name = lambda l, m: 'q%d%d' % (m, l)
    for m in range(MAX):
        declare([name(l, m) for l in range(m, MAX)])

    def column(m):
        for l in range(m, MAX):
            emit(('if (bands > %d) ' % l) + '%s = %s;' % (name(l, m), x_expression(l, m, lambda k: name(k, m))))
    column(0)
    for m in range(MAX):
        print()
        if m:
            emit('if (bands <= %d) return;' % m)
            advance(m, emit)
            emit('mu = %s * u; mv = %s * v;' % (c(mpf(m)), c(mpf(m))))
        if m + 1 < MAX:
            column(m + 1)
        for l in range(m, MAX):
            above = norm(l, m) / norm(l, m + 1) if l > m else 0
            if m == 0:
                d = '%s * st * %s' % (c(-above), name(l, 1)) if l else '0'
            else:
                below = mpf((l - m + 1) * (l + m)) / 2 * norm(l, m) / norm(l, m - 1)
                d = '%s * is * %s' % (c(below), name(l, m - 1))
                d += '%s * st * %s' % (signed(-above / 2), name(l, m + 1)) if l > m else ''
            emit('if (bands > %d) {' % l)
            put(l, m, name(l, m), d)
            emit('}')
    print('}')


print('''/* sloan.h - scalar SH recurrences, straight-line, bands 1..%d.
 * Generated by bench/gen_sloan.py, which states the forms; do not edit. */
''' % MAX)
values()
print(PUT)
sloan_like()
direct()
print('\n#undef PUT\n#undef PUT_ZONAL')
