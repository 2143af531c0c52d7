"""Queries and exact answers of sh-oracle's rotation and products, by quadrature that is exact for the bands given: no
rotation matrix of coefficients, no Gaunt coefficient, no recurrence. As check_oracle_lights.py."""
from mpmath import mpf, sqrt, pi, cos, sin
from check_oracle_reference import BITS, basis, fixed, gauss, real, rounded
from check_oracle_lights import cross, unit

_rules = {}


def rule(rings, spokes, hemisphere=False):
    """[(unit vector, fixed weight)], exact to degree 2 rings - 1 in z and spokes - 1 in azimuth."""
    key = rings, spokes, hemisphere
    if key not in _rules:
        angles = [2 * pi * (k + mpf(3) / 10) / spokes for k in range(spokes)]
        turns = [(cos(t), sin(t)) for t in angles]
        points = []
        for z, w in gauss(rings):
            if hemisphere:
                z, w = (1 + z) / 2, w / 2
            s = sqrt((1 - z) * (1 + z))
            points += [([s * c, s * t, z], fixed(w * 2 * pi / spokes)) for c, t in turns]
        _rules[key] = points
    return _rules[key]


_tables = {}


def table(bands, rings, spokes):
    """The rule's weights and basis values."""
    key = bands, rings, spokes
    if key not in _tables:
        _tables[key] = [(u, w, basis(bands, u)[0]) for u, w in rule(rings, spokes)]
    return _tables[key]


def dot(a, b):
    return sum(s * t for s, t in zip(a, b)) >> BITS


def project(samples, size):
    """sum of value times row, fixed point"""
    total = [0] * size
    for value, row in samples:
        for i in range(size):
            total[i] += value * row[i]
    return [real(t >> BITS) for t in total]


def norm(c):
    return sqrt(sum(mpf(t) ** 2 for t in c))


def with_bound(values, size, bands):
    bound = (16 if bands <= 6 else 40) * size
    return [(v, bound) for v in values]


def coefficients(rng, bands, precision):
    """Smooth, white, one alone, or of very different sizes."""
    n, kind = bands * bands, rng.randrange(5)
    c = [rng.gauss(0, 1) for _ in range(n)]
    if kind == 0:
        c = [0.0] * n
        c[rng.randrange(n)] = 1.0
    elif kind == 1:
        c = [t * 10 ** rng.uniform(-8, 8) for t in c]
    elif kind == 2:
        c = [t * 10 ** -10 for t in c]
    return [rounded(t, precision) for t in c]


# ---- rotation ----
def q_rotate(rng, bands, precision):
    x, y, z, w = (rng.gauss(0, 1) for _ in range(4))
    kind = rng.randrange(8)
    if kind == 0:                               # about z; nothing; half a turn
        x = y = 0.0
    elif kind == 1:
        x, y, z, w = rng.choice([(0, 0, 0, 1), (1, 0, 0, 0), (0, 1, 0, 0), (1, 1, 0, 0), (1, 0, 0, 1), (1, 1, 1, 1)])
    elif kind == 2:                             # the polar axis nearly stays, or nearly turns over
        small = 10 ** rng.uniform(-12, -2)
        x, y = x * small, y * small
    elif kind == 3:
        small = 10 ** rng.uniform(-12, -2)
        z, w = z * small, w * small
    s = 2 / (x * x + y * y + z * z + w * w)
    m = [1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),
         s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),
         s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)]
    return [rounded(t, precision) for t in m] + coefficients(rng, bands, precision)


def nearest_rotation(m):
    """The orthogonal factor of a nearly orthogonal matrix, by Newton's iteration."""
    m = [mpf(t) for t in m]
    for _ in range(8):
        c = cross(m[3:6], m[6:9]) + cross(m[6:9], m[0:3]) + cross(m[0:3], m[3:6])
        det = sum(m[i] * c[i] for i in range(3))
        m = [(s + t / det) / 2 for s, t in zip(m, c)]
    return m


def a_rotate(q, bands, options):
    """out_i = integral of f(u) Y_i(R u), f = sum c_i Y_i"""
    m, c = nearest_rotation(q[:9]), [fixed(mpf(t)) for t in q[9:]]
    turned = lambda u: [sum(m[3 * i + k] * u[k] for k in range(3)) for i in range(3)]
    samples = [(w * dot(c, row) >> BITS, basis(bands, turned(u))[0]) for u, w, row in table(bands, bands, 2 * bands)]
    return {"out": with_bound(project(samples, bands * bands), norm(q[9:]), bands)}


# ---- products ----
def q_cosine_product(rng, bands, precision):
    size = rng.choice([1, 1, 1e-17, 1e17, 3])
    return [rounded(t * size, precision) for t in unit(rng, precision)] + coefficients(rng, bands, precision)


def frame(v):
    """Orthonormal x, y, z with z along v."""
    n = sqrt(sum(mpf(t) ** 2 for t in v))
    z = [mpf(t) / n for t in v]
    k = min(range(3), key=lambda i: abs(z[i]))
    x = [(i == k) - z[k] * z[i] for i in range(3)]
    n = sqrt(sum(t * t for t in x))
    x = [t / n for t in x]
    return x, [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]], z


def a_cosine_product(q, bands, options):
    """out_i = integral over the hemisphere of (n.u) f(u) Y_i(u); D of (n.u) f(u)"""
    x, y, z = frame(q[:3])
    c, samples, total = [fixed(mpf(t)) for t in q[3:]], [], 0
    for u, w in rule(bands + 1, 2 * bands, True):
        row = basis(bands, [x[i] * u[0] + y[i] * u[1] + z[i] * u[2] for i in range(3)])[0]
        value = (w * fixed(u[2]) >> BITS) * dot(c, row) >> BITS
        samples.append((value, row))
        total += value
    size = norm(q[3:])
    return {"out": with_bound(project(samples, bands * bands), size, bands),
            "D": with_bound([real(total)], size * 2 * sqrt(pi), bands)}


def q_triple_product(rng, bands, precision):
    return coefficients(rng, bands, precision) + coefficients(rng, bands, precision)


def a_triple_product(q, bands, options):
    """out_i = integral of a b Y_i; D of a b, which is sum a_i b_i"""
    n = bands * bands
    a, b = [fixed(mpf(t)) for t in q[:n]], [fixed(mpf(t)) for t in q[n:]]
    samples = [((w * dot(a, row) >> BITS) * dot(b, row) >> BITS, row)
               for _, w, row in table(bands, (3 * bands) // 2 + 1, 3 * bands)]
    size = norm(q[:n]) * norm(q[n:])
    return {"out": with_bound(project(samples, n), size, bands),
            "D": with_bound([sum(mpf(s) * mpf(t) for s, t in zip(q[:n], q[n:]))], size * 2 * sqrt(pi), bands)}


FUNCTIONS = {
    "cosine-product": (q_cosine_product, a_cosine_product, 16),
    "triple-product": (q_triple_product, a_triple_product, 16),
    "rotate": (q_rotate, a_rotate, 16)}
