"""Queries and exact answers of sh-oracle's basis and light functions. Each has a generator of awkward queries,
(rng, bands, precision) -> numbers, and a solver, (numbers, bands, options) -> {component: [(exact, bound in eps)]} or
None to skip."""
import math
from mpmath import mpf, sqrt, pi, cos, sin
from check_oracle_reference import BITS, Basis, M, G, bands_of, fixed, gauss, legendre, real, rounded

REACH = {"f32": 18, "f64": 150}                 # lengths are from 10^-REACH to 10^REACH
TINY = {"f32": (-45, -38), "f64": (-323, -308)}  # denormal numbers


def y_bound(l):
    return (4 + mpf(l * (l + 1)) / 4) * M(l)


def gradient_bound(l):
    return (8 + mpf(l * (l + 1)) / 4) * G(l)


def sign(rng):
    return rng.choice([-1.0, 1.0])


def unit(rng, precision):
    """A direction, half of them awkward: on an axis, near a pole, near a plane of symmetry, with denormal parts."""
    v, kind = [rng.gauss(0, 1) for _ in range(3)], rng.randrange(12)
    if kind == 0:
        v = [0.0, 0.0, 0.0]
        v[rng.choice([0, 1, 2, 2])] = sign(rng)
    elif kind == 1:
        v = [sign(rng) * 10 ** rng.uniform(-25, 0), sign(rng) * 10 ** rng.uniform(-25, 0), sign(rng)]
    elif kind == 2:
        v[rng.randrange(3)] *= 10 ** rng.uniform(-20, -1)
    elif kind == 3:
        v[rng.randrange(3)] = 0.0
    elif kind == 4:
        v = [0.0, 0.0, sign(rng)]
        v[rng.randrange(2)] = sign(rng) * 10 ** rng.uniform(*TINY[precision])
    elif kind == 5:                             # rounded to few digits, as people type them
        v = [round(t, 1) for t in v]
    n = math.sqrt(sum(t * t for t in v))
    return [t / n for t in v] if n > 0 else [0.0, 0.0, 1.0]


def length(rng, precision):
    """1; nearly 1, across the border of the fast path; or anything allowed."""
    kind = rng.randrange(4)
    reach = REACH[precision] - 0.01
    return (1.0 if kind == 0 else 1 + sign(rng) * 10 ** rng.uniform(-8, -1) if kind == 1
            else 10 ** rng.uniform(-reach, reach) if kind == 2 else 10 ** rng.uniform(-3, 3))


def q_direction(rng, bands, precision):
    n = length(rng, precision)
    v = [rounded(t * n, precision) for t in unit(rng, precision)]
    return v if any(abs(t) > 10.0 ** -REACH[precision] for t in v) else [0.0, 0.0, 1.0]


def a_eval(q, bands, options):
    return {"Y": [(t, y_bound(l)) for t, l in zip(Basis(bands, q).y, bands_of(bands))]}


def a_grad(q, bands, options):
    b, ls = Basis(bands, q, 1), bands_of(bands)
    answer = {"Y": [(t, y_bound(l)) for t, l in zip(b.y, ls)]}
    for name, grad in zip(("dx", "dy", "dz"), b.grad):
        answer[name] = [(g, gradient_bound(l) / b.rho) for g, l in zip(grad, ls)]
    return answer


def q_hessian(rng, bands, precision):           # 1/|v|^2 has to be a number too
    v = q_direction(rng, bands, precision)
    n = math.sqrt(sum((t / max(map(abs, v))) ** 2 for t in v)) * max(map(abs, v))
    return v if abs(math.log10(n)) < REACH[precision] * 0.9 else [rounded(t / n, precision) for t in v]


def a_hessian(q, bands, options):
    b, ls = Basis(bands, q, 2), bands_of(bands)
    bound = lambda l: (16 + mpf(l * (l + 1)) / 2) * l * (l + 1) * M(l) / b.rho ** 2
    names = "xx", "xy", "xz", "yy", "yz", "zz"
    return {name: [(h, bound(l)) for h, l in zip(hess, ls)] for name, hess in zip(names, b.hess)}


def q_angles(rng, bands, precision):
    near_pole = rng.choice([0, 1, 2]) * math.pi + sign(rng) * 10 ** rng.uniform(-25, 0)
    theta = rng.choice([0.0, math.pi, -math.pi, math.pi / 2, near_pole, rng.uniform(-20, 20), rng.uniform(0, math.pi),
                        10 ** rng.uniform(0, 37)])
    phi = rng.choice([0.0, math.pi, rng.randrange(-8, 9) * math.pi / 4, rng.uniform(-7, 7), 10 ** rng.uniform(-30, 0),
                      sign(rng) * 10 ** rng.uniform(0, 37)])
    return [rounded(theta, precision), rounded(phi, precision)]


def a_angles(q, bands, options):
    theta, phi = mpf(q[0]), mpf(q[1])
    ct, st, cp, sp = cos(theta), sin(theta), cos(phi), sin(phi)
    b, ls = Basis(bands, [st * cp, st * sp, ct], 1), bands_of(bands)
    along = lambda i, d: sum(b.grad[k][i] * d[k] for k in range(3))
    by_theta, by_phi = [ct * cp, ct * sp, -st], [-st * sp, st * cp, mpf(0)]
    return {"Y": [(y, y_bound(l)) for y, l in zip(b.y, ls)],
            "dtheta": [(along(i, by_theta), gradient_bound(l)) for i, l in enumerate(ls)],
            "dphi": [(along(i, by_phi), max(1, abs(i - l * (l + 1))) * y_bound(l)) for i, l in enumerate(ls)]}


# ---- caps and spheres ----
def cap_profile(bands, s):
    """cos, 1 - cos, 2 pi times the integral of P_l over [cos, 1], and P_l(cos), for sin(half-angle) s."""
    alpha = sqrt((1 - s) * (1 + s))
    kappa = s * s / (1 + alpha)

    def P(l, t):
        t = fixed(t)
        return real(legendre(l, 0, t, t * t >> BITS))

    nodes = [(1 - kappa * (1 + x) / 2, w * kappa / 2) for x, w in gauss(bands // 2 + 1)]
    integrals = [2 * pi * sum(w * P(l, t) for t, w in nodes) for l in range(bands)]
    return alpha, kappa, integrals, [P(l, alpha) for l in range(bands)]


def steepness(s):
    return 1 / ((1 - s) * (1 + s)) if s > 0.995 else 1


def ratio(rng):
    return rng.choice([1e-6, 0.99, 0.995, 0.999, 0.9999, 0.99999, 10 ** rng.uniform(-6, -0.01),
                       rng.uniform(0.1, 0.99), 1 - 10 ** rng.uniform(-5, -1)])


def q_cap(rng, bands, precision):
    tiny = 10 ** rng.uniform(1 - REACH[precision], 0)
    return [rounded(rng.choice([0.0, 1.0, ratio(rng), ratio(rng), tiny]), precision)]


def a_cap(q, bands, options):
    s = mpf(q[0])
    _, kappa, f, p = cap_profile(bands, s)
    omega, steep = 2 * pi * kappa, steepness(min(s, mpf("0.99999")))
    return {"zh": [(M(l) * f[l], 24 * M(l) * omega * steep) for l in range(bands)],
            "dzh": [(M(l) * 2 * pi * s * p[l], 32 * M(l) * 2 * pi * s * steep) for l in range(bands)]}


def sphere_answer(q, bands, factor=1, slope=None):
    """Light of a sphere times `factor`, whose gradient by the point is `slope`; None inside."""
    point, center, r = [mpf(t) for t in q[:3]], [mpf(t) for t in q[3:6]], mpf(q[6])
    b, ls = Basis(bands, [c - p for c, p in zip(center, point)], 1), bands_of(bands)
    if b.rho <= r:
        return None
    s = r / b.rho
    alpha, kappa, f, p = cap_profile(bands, s)
    omega, steep = 2 * pi * kappa, steepness(s)
    change = 2 * pi * s * s / (alpha * b.rho)
    answer = {"c": [(factor * f[l] * y, abs(factor) * 24 * M(l) * omega * steep) for y, l in zip(b.y, ls)]}
    slope = slope or [mpf(0)] * 3
    turn = sqrt(sum(t * t for t in slope)) * omega
    bound = lambda l: 32 * (abs(factor) * (M(l) * change + G(l) * omega / b.rho) * steep + M(l) * turn)
    for k, name in enumerate(("dx", "dy", "dz")):
        # f(rho) Y(u): rho and u change by minus the point's move; df/drho = -2 pi P_l(alpha) s^2/(alpha rho)
        answer[name] = [(factor * (change * p[l] * y * b.u[k] - f[l] * g) + slope[k] * f[l] * y, bound(l))
                        for y, g, l in zip(b.y, b.grad[k], ls)]
    return answer


def q_sphere(rng, bands, precision):
    """Sizes 1, usual and extreme; the point at the origin, near, or far away in the light's own units."""
    reach = REACH[precision] - 6
    size = rng.choice([1, 10 ** rng.uniform(-6, 6), 10 ** rng.uniform(-reach, reach)])
    away = rng.choice([0, size, size * 10 ** rng.uniform(0, 4)])
    point = [rounded(away * rng.uniform(-2, 2), precision) for _ in range(3)]
    center = [rounded(p + size * t, precision) for p, t in zip(point, unit(rng, precision))]
    d = math.sqrt(sum(((a - b) / size) ** 2 for a, b in zip(center, point))) * size
    return point + center + [rounded(d * ratio(rng), precision)]


def a_sphere(q, bands, options):
    return sphere_answer(q, bands) if q[:3] != q[3:6] else None


def q_triangle(rng, bands, precision):
    size = rng.choice([1, 10 ** rng.uniform(-6, 6)])
    point = [rng.choice([0, 1, size, 100 * size]) * rng.uniform(-1, 1) for _ in range(3)]
    middle = [p + size * rng.choice([1, 3, 30]) * t for p, t in zip(point, unit(rng, precision))]
    thin = rng.choice([1, 1, 1e-3])
    a, b = [rng.gauss(0, 1) for _ in range(3)], [rng.gauss(0, 1) for _ in range(3)]
    corners = [[m + size * rng.uniform(0.01, 1) * (s * x + t * thin * y) for m, x, y in zip(middle, a, b)]
               for s, t in ((0, 0), (1, 0), (rng.random(), 1))]
    return [rounded(t, precision) for t in point + corners[0] + corners[1] + corners[2]]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def a_triangle(q, bands, options):
    """M22 Eq. 24-28: the sphere of the triangle's area at its centroid, times |cos| of the angle to the normal."""
    x, a, b, c = ([mpf(t) for t in q[i:i + 3]] for i in (0, 3, 6, 9))
    normal = cross([s - t for s, t in zip(b, a)], [s - t for s, t in zip(c, a)])
    area2 = sqrt(sum(t * t for t in normal))
    y = [(r + s + t) / 3 for r, s, t in zip(a, b, c)]
    v = [s - t for s, t in zip(y, x)]
    d = sqrt(sum(t * t for t in v))
    if area2 == 0 or d == 0:
        return None
    # counter-clockwise as seen from the point is the front: n.(point - y) > 0
    n = [t / area2 for t in normal]
    cosine = -sum(s * t for s, t in zip(n, v)) / d
    slope = [s / d + t * cosine / d ** 2 for s, t in zip(n, v)]             # of cosine, by the point
    sides = options.sides if options else "both"
    flip = -1 if sides == "both" and cosine < 0 else 0 if sides == "front" and cosine < 0 else 1
    answer = sphere_answer([x[0], x[1], x[2], y[0], y[1], y[2], sqrt(area2 / (2 * pi))], bands, flip * cosine,
                           [flip * t for t in slope])
    return answer and {name: [(w, bound + 8 * abs(w)) for w, bound in values] for name, values in answer.items()}


# ---- light fields ----
def q_cubemap(rng, bands, precision):
    """Texels around a plane, a sphere's inside, or anything; some without parallax or normal."""
    q = []
    for _ in range(rng.choice([1, 2, 6])):
        u = unit(rng, precision)
        n = unit(rng, precision)
        if abs(sum(s * t for s, t in zip(u, n))) < 0.01:
            n = [-t for t in u]
        scale = rng.choice([1, 1, 7.5])
        q += [t * scale for t in u] + [rng.uniform(0, 0.1), rng.uniform(0, 20), 10 ** rng.uniform(-2, 2)]
        q += [0.0, 0.0, 0.0] if rng.random() < 0.1 else [t * scale for t in n]
    return [rounded(t, precision) for t in q]


def a_cubemap(q, bands, options):
    """c = sum dw I Y, grad c = -sum dw I/r (grad_S Y + Y (n/(n.w) - 3 w)), A04 Eq. 10-13; no normal, no n term."""
    ls, texels = bands_of(bands), [q[i:i + 9] for i in range(0, len(q), 9)]
    total, bound = [[mpf(0)] * (bands * bands) for _ in range(4)], [[mpf(0)] * bands for _ in range(2)]
    count = mpf(len(texels))
    for texel in texels:
        t = [mpf(v) for v in texel]
        b = Basis(bands, t[:3], 1)
        power, n = t[3] * t[4], sqrt(sum(v * v for v in t[6:9]))
        facing = sum(v * w for v, w in zip(t[6:9], b.u)) / n if n else mpf(1)
        if n and abs(facing) < mpf("1.1e-3"):
            return None
        e = [(t[6 + k] / n / facing if n else 0) - 3 * b.u[k] for k in range(3)]
        near, steep = power / t[5], 1 / abs(facing)
        for i in range(bands * bands):
            total[0][i] += power * b.y[i]
            for k in range(3):
                total[1 + k][i] -= near * (b.grad[k][i] * b.rho + b.y[i] * e[k])
        for l in range(bands):
            bound[0][l] += abs(power) * (y_bound(l) + M(l) * (2 + count / 4))
            bound[1][l] += abs(near) * (gradient_bound(l) + (3 + steep) * y_bound(l) + 4 * M(l) * steep ** 2
                                        + (G(l) + 4 * M(l) * steep) * (4 + count / 4))
    return {name: [(v, bound[min(k, 1)][l]) for v, l in zip(total[k], ls)]
            for k, name in enumerate(("c", "dx", "dy", "dz"))}


FUNCTIONS = {       # name: generator, solver, most bands
    "eval": (q_direction, a_eval, 32), "grad": (q_direction, a_grad, 32), "hessian": (q_hessian, a_hessian, 32),
    "angles": (q_angles, a_angles, 32), "cap": (q_cap, a_cap, 32), "sphere": (q_sphere, a_sphere, 32),
    "triangle-as-sphere": (q_triangle, a_triangle, 32), "cubemap": (q_cubemap, a_cubemap, 32)}
