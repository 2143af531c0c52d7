#!/usr/bin/env python3
"""Prints bench/polynomial.h: SH as explicit Cartesian polynomials and their derivatives, straight-line scalar code.

    python3 bench/gen_polynomial.py > bench/polynomial.h

The form people paste from Sloan 2008: Y_{l,+m} = A_m(x,y) p_lm(z), Y_{l,-m} = B_m(x,y) p_lm(z), every factor written
out as a polynomial, no recurrence. A_m and B_m are the real and imaginary part of (x + iy)^m. Gradients are those
products differentiated term by term; what they share (A_{m-1} in d A_m/dx, powers of the coordinates, m p) is
written once, as a careful programmer or a symbolic tool would. The chain rule through v/|v| then follows.
`bands` is a compile-time constant at every call, so the guards vanish.
"""
from math import comb
from mpmath import mp, mpf, sqrt, pi, factorial

mp.dps = 40
MAX = 10


def norm(l, m):
    """(-1)^m J_lm: normalisation with the Condon-Shortley factor."""
    j = sqrt((2 * l + 1) / (4 * pi) * factorial(l - m) / factorial(l + m))
    return (-1) ** m * j * (sqrt(2) if m else 1)


def c(value):
    return 'C(%s)' % mp.nstr(value, 17, min_fixed=-5, max_fixed=20)


def term(value):
    return (' - ' if value < 0 else ' + ') + c(abs(value))


def legendre(l, m, derivative=0):
    """{power of z: coefficient} of the m-th derivative of P_l, normalised, differentiated further."""
    out = {}
    for k in range(l // 2 + 1):
        power = l - 2 * k
        value = mpf((-1) ** k * comb(l, k) * comb(2 * l - 2 * k, l)) / mpf(2) ** l
        for _ in range(m + derivative):
            value *= power
            power -= 1
        if value != 0:
            out[power] = value * norm(l, m)
    return out


def horner(p):
    """A polynomial in z with powers two apart, by Horner in zz = z*z."""
    if not p:
        return 'C(0.0)'
    powers = sorted(p, reverse=True)
    text = c(p[powers[0]])
    for k in powers[1:]:
        text = '%s * zz%s' % (text if text.startswith('C') and ' ' not in text else '(' + text + ')', term(p[k]))
    odd = powers[-1] % 2
    if odd:
        text = '%s * z' % ('(' + text + ')' if len(powers) > 1 else text)
    return text


def binary_form(m, imaginary):
    """A_m or B_m, by Horner in xx with powers of yy, the odd factors x and y in front."""
    weights = [(-1) ** (k // 2) * comb(m, k) for k in range(1 if imaginary else 0, m + 1, 2)]
    odd = (['x'] if (m - (1 if imaginary else 0)) % 2 else []) + (['y'] if imaginary else [])
    text = ''
    for k, w in enumerate(weights):
        body = {0: '', 1: 'yy'}.get(k, 'y%d' % (2 * k))
        factor = [] if abs(w) == 1 and body else ['C(%d.0)' % abs(w)]
        body = ' * '.join(factor + ([body] if body else []))
        if k:
            text = text if text in ('', 'C(1.0)') else '(%s) * ' % text if ' ' in text else text + ' * '
            text = ('' if text == 'C(1.0)' else text) + 'xx' + (' - ' if w < 0 else ' + ') + body
        else:
            text = body
    if text == 'C(1.0)':
        return ' * '.join(odd)
    if not odd:
        return text
    return ' * '.join(odd + ['(' + text + ')' if ' ' in text else text])


def emit(line, indent=4):
    """One line, or several, broken after a statement, each within 110 columns."""
    start = indent
    while start + len(line) > 110:
        cut = max(line.rfind(mark, 0, 108 - start) for mark in ('; ', ', ')) + 1
        cut = cut or max(line.rfind(mark, 0, 108 - start) for mark in (' + ', ' - '))
        print(' ' * start + line[:cut])
        start, line = indent + 4, line[cut + 1:]
    print(' ' * start + line)


def forms():
    """A_m and B_m for every m; what a band count does not use costs nothing."""
    emit('const real xx = x * x, yy = y * y, zz = z * z, y4 = yy * yy, y6 = y4 * yy, y8 = y4 * y4;')
    for m in range(1, MAX):
        emit('const real a%d = %s;' % (m, binary_form(m, False)))
        emit('const real b%d = %s;' % (m, binary_form(m, True)))


def band(l, body):
    print()
    if l:
        emit('if (bands <= %d) return;' % l)
    for m in range(l + 1):
        body(l, m)


def values():
    print('/* Y of a unit direction. */')
    print('INLINE void polynomial_values(const int bands, const real dir[3], real *RESTRICT out)')
    print('{')
    emit('const real x = dir[0], y = dir[1], z = dir[2];')
    forms()

    def body(l, m):
        i = l * l + l
        p = horner(legendre(l, m))
        if m == 0:
            emit('out[%d] = %s;' % (i, p))
        elif l == m:
            emit('out[%d] = %s * a%d; out[%d] = %s * b%d;' % (i + m, p, m, i - m, p, m))
        else:
            emit('{ const real p = %s; out[%d] = p * a%d; out[%d] = p * b%d; }' % (p, i + m, m, i - m, m))
    for l in range(MAX):
        band(l, body)
    print('}')


def product(weight, name, m):
    """weight * A_m or B_m, with A_0 = 1 and B_0 = 0; None for zero."""
    if weight is None or m < 0 or (m == 0 and name == 'b'):
        return None
    return weight if m == 0 else '%s * %s%d' % (weight, name, m)


def total(*terms):
    """A sum of products, each (sign, text); zero products (None) drop out."""
    text = ''
    for sign, body in terms:
        if body is not None:
            text += ((' - ' if sign < 0 else ' + ') if text else ('-' if sign < 0 else '')) + body
    return text or '0'


def times(factor, text):
    return None if text is None else '%s * %s' % (factor, text)


def scaled(k, text):
    """k * text for a small integer k."""
    return None if k == 0 or text is None else text if k == 1 else 'C(%d.0) * %s' % (k, text)


def factors(l, m):
    """Statements for p, d = p', e = p'' and which of d, e is not zero."""
    p, d, e = (legendre(l, m, k) for k in range(3))
    text = 'p = %s;' % horner(p)
    text += ' d = %s;' % horner(d) if d else ''
    return text, ('d' if d else None), (horner(e) if e else None)


def gradient():
    print('''
/* Y and its gradient by v, u = v/|v|, ir = 1/|v|: grad = (F' - u (u.F')) / |v|. Per (l, m), by Euler's theorem
 * in x and y: u.F' = A b with b = m p + z p', and dz = A e with e = (p' - z b) / |v|. */
INLINE void polynomial_gradient(const int bands, const real u[3], const real ir, real *RESTRICT out,
                                real *RESTRICT gx, real *RESTRICT gy, real *RESTRICT gz)
{''')
    emit('const real x = u[0], y = u[1], z = u[2], xr = x * ir, yr = y * ir;')
    emit('real p, d, mp, b, e;')
    forms()
    for m in range(1, MAX):
        emit('const real xa{0} = xr * a{0}, ya{0} = yr * a{0}, xb{0} = xr * b{0}, yb{0} = yr * b{0};'.format(m))

    def side(i, m, name, other, sign):
        """One of the pair: F = p name_m, dx = m p name_{m-1}, dy = sign m p other_{m-1}, dz = d name_m."""
        emit('out[%d] = p * %s%d; gx[%d] = %s; gy[%d] = %s; gz[%d] = e * %s%d;'
             % (i, name, m, i, total((1, product('mp', name, m - 1)), (-1, 'x%s%d * b' % (name, m))),
                i, total((sign, product('mp', other, m - 1)), (-1, 'y%s%d * b' % (name, m))), i, name, m))

    def body(l, m):
        i = l * l + l
        text, d, _ = factors(l, m)
        if l == 0:
            emit('out[0] = %s; gx[0] = 0; gy[0] = 0; gz[0] = 0;' % horner(legendre(0, 0)))
        elif m == 0:
            emit(text + ' b = z * d; e = (d - z * b) * ir;')
            emit('out[%d] = p; gx[%d] = -xr * b; gy[%d] = -yr * b; gz[%d] = e;' % (i, i, i, i))
        else:
            emit(text + ' mp = %s * ir; b = %s; e = %s * ir;' %
                 (scaled(m, 'p'), total((1, scaled(m, 'p')), (1, times('z', d))),
                  '(%s)' % total((1, d), (-1, 'z * b'))))
            side(i + m, m, 'a', 'b', -1)
            side(i - m, m, 'b', 'a', 1)
    for l in range(MAX):
        band(l, body)
    print('}')


def hessian():
    print('''
/* As above with the Hessian: planes x y z, then xx xy xz yy yz zz, n2 apart.
 * (P F'' P - k P - u t^T - t u^T)/|v|^2 = (F'' - k - u b^T - b u^T)/|v|^2 with t = P F', k = u.F', w = F'' u,
 * b = t + w - (u.w + k)/2 u; w and k by Euler's theorem in x and y: F is homogeneous there. */
INLINE void polynomial_hessian(const int bands, const real u[3], const real ir, real *RESTRICT out,
                               real *RESTRICT grad, real *RESTRICT hess)
{''')
    emit('const real x = u[0], y = u[1], z = u[2], ir2 = ir * ir;')
    emit('const int n2 = bands * bands;')
    emit('real f, fx, fy, fz, fxx, fxy, fxz, fyz, fzz, tx, ty, tz, wx, wy, wz, bx, by, bz, k, h, p, d, e;')
    forms()

    def side(i, m, d, e, name, other, sign):
        have = {'fx': (1, product(scaled(m, 'p'), name, m - 1)), 'fy': (sign, product(scaled(m, 'p'), other, m - 1)),
                'fz': (1, product(d, name, m)),
                'fxx': (1, product(scaled(m * (m - 1), 'p'), name, m - 2)),
                'fxy': (sign, product(scaled(m * (m - 1), 'p'), other, m - 2)),
                'fxz': (1, product(scaled(m, d), name, m - 1)), 'fyz': (sign, product(scaled(m, d), other, m - 1)),
                'fzz': (1, product(e, name, m))}
        one = {key: key if body else None for key, (_, body) in have.items()}
        emit('f = %s; ' % product('p', name, m) +
             ' '.join('%s = %s;' % (key, total(body)) for key, body in have.items() if body[1]))
        emit('k = %s;' % total((1, scaled(m, 'f') if m else None), (1, times('z', one['fz']))))
        emit('wx = %s; wy = %s; wz = %s;' % (
            total((1, scaled(m - 1, one['fx'])), (1, times('z', one['fxz']))),
            total((1, scaled(m - 1, one['fy'])), (1, times('z', one['fyz']))),
            total((1, scaled(m, one['fz'])), (1, times('z', one['fzz'])))))
        emit('h = C(0.5) * (x * wx + y * wy + z * wz + k);')
        for axis in 'xyz':
            emit('t{0} = {1}; b{0} = t{0} + w{0} - h * {0};'.format(
                axis, total((1, one['f' + axis]), (-1, '%s * k' % axis))))
        emit('out[%d] = f; grad[%d] = tx * ir; grad[n2 + %d] = ty * ir; grad[2 * n2 + %d] = tz * ir;' % (i, i, i, i))
        planes = [('x', 'x', 1, 'fxx'), ('x', 'y', 1, 'fxy'), ('x', 'z', 1, 'fxz'),
                  ('y', 'y', -1, 'fxx'), ('y', 'z', 1, 'fyz'), ('z', 'z', 1, 'fzz')]
        for plane, (r, s, sgn, key) in enumerate(planes):
            both = [(-1, 'C(2.0) * %s * b%s' % (r, r))] if r == s else \
                [(-1, '%s * b%s' % (r, s)), (-1, '%s * b%s' % (s, r))]
            emit('hess[%d * n2 + %d] = (%s) * ir2;'
                 % (plane, i, total((sgn, one[key]), (-1, 'k' if r == s else None), *both)))

    def body(l, m):
        i = l * l + l
        text, d, e = factors(l, m)
        emit(text + (' e = %s;' % e if e else ''))
        if l == 0:
            emit('out[0] = p;')
            emit(' '.join('grad[%d * n2] = 0;' % k for k in range(3)))
            emit(' '.join('hess[%d * n2] = 0;' % k for k in range(6)))
        elif m == 0:
            side(i, 0, d, 'e' if e else None, 'a', 'b', -1)
        else:
            side(i + m, m, d, 'e' if e else None, 'a', 'b', -1)
            side(i - m, m, d, 'e' if e else None, 'b', 'a', 1)
    for l in range(MAX):
        band(l, body)
    print('}')


print('''/* polynomial.h - SH as explicit Cartesian polynomials, scalar, bands 1..%d.
 * Generated by bench/gen_polynomial.py, which states the form; do not edit. */
''' % MAX)
values()
gradient()
hessian()
