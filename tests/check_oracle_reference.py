"""What check_oracle*.py compare with: definitions in fixed point, 96 decimal digits after the point.

Shares nothing with the library or its C tests: Legendre functions are Rodrigues' formula as a finite sum, derivatives
the derivative of that sum, quadrature is Gauss's."""
import math
import struct
from mpmath import mp, mpf, sqrt, pi, cos
from mpmath.libmp import from_man_exp

mp.prec = 340
BITS = 320
ONE = 1 << BITS
EPS = {"f32": mpf(2) ** -23, "f64": mpf(2) ** -52}


def rounded(x, precision):
    """The number the oracle reads: x in the precision under test."""
    return struct.unpack("f", struct.pack("f", x))[0] if precision == "f32" else float(x)


def fixed(x):
    return int(mp.ldexp(x, BITS))


def real(n):
    return mp.make_mpf(from_man_exp(n, -BITS))


def M(l):
    return sqrt(mpf(2 * l + 1) / (4 * pi))


def G(l):
    return sqrt(mpf(l * (l + 1) * (2 * l + 1)) / (8 * pi))


def bands_of(count):
    return [l for l in range(count) for _ in range(2 * l + 1)]


_sums, _scales, _gauss = {}, {}, {}


def legendre_sum(l, m):
    """Coefficients of d^m P_l / dz^m by falling powers z^(l-m), z^(l-m-2), ...: Rodrigues by the binomial theorem."""
    if (l, m) not in _sums:
        over = 2 ** l * math.factorial(l)
        _sums[l, m] = [((-1) ** k * math.comb(l, k) * math.perm(2 * l - 2 * k, l + m) << BITS) // over
                       for k in range((l - m) // 2 + 1)] if m <= l else []
    return _sums[l, m]


def legendre(l, m, z, z2):
    total = 0
    for c in legendre_sum(l, m):
        total = (total * z2 >> BITS) + c
    return total * z >> BITS if (l - m) & 1 else total


def scale_of(l, m):
    """The norm of (l, |m|) with the factor (-1)^m."""
    if (l, m) not in _scales:
        square = mpf(math.factorial(l - m)) / math.factorial(l + m) * (2 if m else 1)
        _scales[l, m] = fixed((-1) ** m * M(l) * sqrt(square))
    return _scales[l, m]


def basis(bands, u, derivatives=0):
    """Fixed-point rows at a unit direction: [Y], or [Y, dx dy dz] of Y(v/|v|), or those and [xx xy xz yy yz zz]."""
    x, y, z = (fixed(t) for t in u)
    z2, rows = z * z >> BITS, [[] for _ in range((1, 4, 10)[derivatives])]
    c, s = [ONE], [0]                                       # Re, Im of (x + iy)^m
    for m in range(bands):
        c.append(c[m] * x - s[m] * y >> BITS)
        s.append(c[m] * y + s[m] * x >> BITS)
    for l in range(bands):
        q = [legendre(l, m, z, z2) for m in range(l + 1 + derivatives)]
        for m in range(-l, l + 1):
            a = abs(m)
            k = scale_of(l, a)
            # F = Q(z) f(x, y), f = Re or Im (x+iy)^a; df = a (g, h), d2f/dx2 = a(a-1) gg, d2f/dxdy = a(a-1) gh
            f = s[a] if m < 0 else c[a]
            k0 = k * q[a] >> BITS
            rows[0].append(k0 * f >> BITS)
            if not derivatives:
                continue
            g, h = ((s[a - 1], c[a - 1]) if m < 0 else (c[a - 1], -s[a - 1])) if a else (0, 0)
            k1 = k * q[a + 1] >> BITS
            d = [a * (k0 * g >> BITS), a * (k0 * h >> BITS), k1 * f >> BITS]
            along = x * d[0] + y * d[1] + z * d[2] >> BITS
            t = [d[0] - (x * along >> BITS), d[1] - (y * along >> BITS), d[2] - (z * along >> BITS)]
            for i in range(3):
                rows[1 + i].append(t[i])
            if derivatives < 2:
                continue
            gg, gh = ((s[a - 2], c[a - 2]) if m < 0 else (c[a - 2], -s[a - 2])) if a > 1 else (0, 0)
            xx, xy = a * (a - 1) * (k0 * gg >> BITS), a * (a - 1) * (k0 * gh >> BITS)
            xz, yz = a * (k1 * g >> BITS), a * (k1 * h >> BITS)
            hess = [[xx, xy, xz], [xy, -xx, yz], [xz, yz, (k * q[a + 2] >> BITS) * f >> BITS]]
            hu = [hess[i][0] * x + hess[i][1] * y + hess[i][2] * z >> BITS for i in range(3)]
            v, uhu = (x, y, z), hu[0] * x + hu[1] * y + hu[2] * z >> BITS
            row = 4
            for i in range(3):
                for j in range(i, 3):                       # P H P - along P - u t' - t u'
                    vv = v[i] * v[j] >> BITS
                    rows[row].append(hess[i][j] + (vv * (uhu + along) - (i == j) * along * ONE
                                                   - v[i] * (hu[j] + t[j]) - (hu[i] + t[i]) * v[j] >> BITS))
                    row += 1
    return rows


class Basis:
    """Values, gradients and Hessians of Y(v/|v|) by v at v, all l < bands, as mpf."""

    def __init__(self, bands, v, derivatives=0):
        v = [mpf(t) for t in v]
        self.rho = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
        self.u = [t / self.rho for t in v]
        rows = basis(bands, self.u, derivatives)
        self.y = [real(n) for n in rows[0]]
        self.grad = [[real(n) / self.rho for n in row] for row in rows[1:4]]
        self.hess = [[real(n) / self.rho ** 2 for n in row] for row in rows[4:]]


def gauss(n):
    """[(node, weight)] over [-1, 1]"""
    if n not in _gauss:
        nodes = []
        for i in range(n):
            x = cos(pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
            for _ in range(9):
                p0, p1 = mpf(1), x
                for k in range(2, n + 1):
                    p0, p1 = p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k
                d = n * (p0 - x * p1) / (1 - x * x)
                x -= p1 / d
            nodes.append((x, 2 / ((1 - x * x) * d * d)))
        _gauss[n] = nodes
    return _gauss[n]
