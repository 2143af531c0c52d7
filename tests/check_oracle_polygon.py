#!/usr/bin/env python3
"""sh-oracle's polygons against 100 digits: values and gradients to the documented bounds, both precisions.

    check_oracle_polygon.py ORACLE [--queries N] [--seed S] [--place P] [--shape S] [--self-check N]

Shares nothing with the library or its C tests. The light is the divergence theorem's sum over the edges,
    l(l+1) L_lm = sum_e integral mu.grad Y_lm dt,    dL/dx = sum_e mu integral Y_lm/|p| dt,
whose integrands are trigonometric polynomials on the great circle of the edge: taken at equal steps around it
and integrated term by term in closed form. Basis functions are Rodrigues' sums, solid angles the signed fan,
arithmetic is fixed point of 384 bits. --self-check compares that with quadrature of the surface integral
itself. Inputs are rounded to the precision under test first, so both sides get the same numbers. Prints the
worst error per place and precision in units of the bound,
    64 eps M_l sum |Omega_fan|,    64 eps sum_fan (M_l |grad Omega_fan| + G_l Omega_fan/d),
d the nearest vertex's distance, 1000 eps within 1e-3 of an edge; exits 1 if one passes 1."""
import argparse
import math
import random
import struct
import subprocess
import sys
from mpmath import mp, mpf, sqrt, pi, factorial, cos, sin, atan2

from check_oracle_reference import gauss

mp.dps = 100
BITS = 384
EPS = {"f32": mpf(2) ** -23, "f64": mpf(2) ** -52}


def rounded(x, precision):
    return struct.unpack("f", struct.pack("f", x))[0] if precision == "f32" else float(x)


def M(l):
    return sqrt(mpf(2 * l + 1) / (4 * pi))


def G(l):
    return sqrt(mpf(l * (l + 1) * (2 * l + 1)) / (8 * pi))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def minus(a, b):
    return [s - t for s, t in zip(a, b)]


def length(a):
    return sqrt(dot(a, a))


# ---- the basis in fixed point ----
def fixed(x):
    return int(mp.nint(mp.ldexp(x, BITS)))


_sums = {}


def normed_sum(l, m, k):
    """[(coefficient, power)] of the k-th derivative of Q_l^m in z, times the norm of Y_lm, sign (-1)^m in."""
    if (l, m, k) not in _sums:
        norm = (-1) ** m * M(l) * sqrt(factorial(l - m) / factorial(l + m) * (2 if m else 1))
        o = m + k
        _sums[l, m, k] = [(fixed(norm * mpf((-1) ** j * math.comb(l, j) * math.perm(2 * l - 2 * j, l + o))
                                 / (2 ** l * factorial(l))), l - o - 2 * j)
                          for j in range((l - o) // 2 + 1)] if o <= l else []
    return _sums[l, m, k]


def basis(bands, u, mu=None):
    """Y at the unit vector u and, with mu orthogonal to u, mu.grad Y; fixed point in and out."""
    x, y, z = u
    zs, c, s = [1 << BITS], [1 << BITS], [0]
    for _ in range(bands):
        zs.append(zs[-1] * z >> BITS)
        c.append((x * c[-1] - y * s[-1]) >> BITS)
        s.append((x * s[-1] + y * c[-2]) >> BITS)
    values, slopes = [0] * bands ** 2, [0] * bands ** 2
    for l in range(bands):
        for m in range(l + 1):
            q = sum(k * zs[p] for k, p in normed_sum(l, m, 0)) >> BITS
            values[l * l + l + m] = q * c[m] >> BITS
            if m:
                values[l * l + l - m] = q * s[m] >> BITS
            if mu is None:
                continue
            d = (sum(k * zs[p] for k, p in normed_sum(l, m, 1)) >> BITS) * mu[2] >> BITS
            if m:
                q *= m
                dc, ds = c[m - 1] * mu[0] - s[m - 1] * mu[1], s[m - 1] * mu[0] + c[m - 1] * mu[1]
                slopes[l * l + l + m] = (d * c[m] + q * (dc >> BITS)) >> BITS
                slopes[l * l + l - m] = (d * s[m] + q * (ds >> BITS)) >> BITS
            else:
                slopes[l * l + l] = d * c[0] >> BITS
    return values, slopes


# ---- one edge ----
_circle = {}


def circle(n):
    """(sin, cos) of k pi j/n, [k][j]"""
    if n not in _circle:
        _circle[n] = [[(sin(pi * k * j / n), cos(pi * k * j / n)) for j in range(n)] for k in range(n + 2)]
    return _circle[n]


def edge(bands, a, b):
    """(mu, integrals of mu.grad Y dt, of Y/|p| dt, of 1/|p| dt), or None if seen as a point."""
    normal, r = cross(a, minus(b, a)), length(a)
    size = length(normal)
    if size == 0:
        return None
    mu, w = [t / size for t in normal], [t / r for t in a]
    la = cross(mu, w)
    g = atan2(size, dot(a, b))
    k0, k1 = 1 / r, -dot(minus(b, a), w) / size
    n = bands
    table = circle(n)
    sg, cg = [sin(k * g) for k in range(n + 2)], [cos(k * g) for k in range(n + 2)]

    def cosine(f, k, j):
        """integral over [0,g] of cos(f t - k t_j); and of the sine"""
        st, ct = table[k][j]
        if f == 0:
            return g * ct, -g * st
        sf = sg[f] if f > 0 else -sg[-f]
        cf = cg[abs(f)]
        return (sf * ct - cf * st + st) / f, (ct - cf * ct - sf * st) / f

    # weights of the samples: W for a function of its parity, V for one times k0 cos t + k1 sin t
    W, V = [[mpf(0)] * n for _ in range(2)], [[mpf(0)] * n for _ in range(2)]
    for j in range(n):
        for k in range(n):
            scale = mpf(1 if k == 0 else 2) / n
            W[k % 2][j] += scale * cosine(k, k, j)[0]
            up, down = cosine(k + 1, k, j), cosine(k - 1, k, j)
            V[k % 2][j] += scale / 2 * (k0 * (up[0] + down[0]) + k1 * (up[1] - down[1]))
    W, V = [[fixed(t) for t in row] for row in W], [[fixed(t) for t in row] for row in V]
    fmu = [fixed(t) for t in mu]
    flux, slope = [0] * n * n, [0] * n * n
    for j in range(n):
        st, ct = table[1][j]
        y, d = basis(n, [fixed(ct * w[i] + st * la[i]) for i in range(3)], fmu)
        for l in range(n):
            we, ve = W[(l + 1) % 2][j], V[l % 2][j]
            for i in range(l * l, (l + 1) * (l + 1)):
                flux[i] += d[i] * we
                slope[i] += y[i] * ve
    back = lambda t: mp.ldexp(mpf(t), -2 * BITS)
    return mu, [back(t) for t in flux], [back(t) for t in slope], k0 * sg[1] + k1 * (1 - cg[1])


def solid_angle(a, b, c):
    """positive where a, b, c run counter-clockwise seen from behind"""
    x, y, z = length(a), length(b), length(c)
    return 2 * atan2(dot(a, cross(minus(b, a), minus(c, a))),
                     x * y * z + dot(a, b) * z + dot(b, c) * x + dot(a, c) * y)


def solid_slope(vertices):
    """|gradient| of a triangle's solid angle"""
    total = [mpf(0)] * 3
    for i in range(3):
        e = edge(1, vertices[i], vertices[(i + 1) % 3])
        if e:
            total = [t + m * e[3] for t, m in zip(total, e[0])]
    return length(total)


class Light:
    """Exact coefficients and gradient of a polygon, and what its bounds are made of."""

    def __init__(self, bands, point, vertices, sides):
        p = [mpf(t) for t in point]
        v = [[mpf(vertices[3 * i + k]) - p[k] for k in range(3)] for i in range(len(vertices) // 3)]
        count = len(v)
        fan = [(v[0], v[i], v[i + 1]) for i in range(1, count - 1)]
        normals = [cross(minus(b, a), minus(c, a)) for a, b, c in fan]
        dets = [dot(f[0], n) for f, n in zip(fan, normals)]
        area = [sum(n[k] for n in normals) for k in range(3)]
        seen = {(d > 0) == (dot(n, area) > 0) for d, n in zip(dets, normals) if abs(dot(n, area)) > mpf("1e-6") * dot(area, area)}
        self.scale = scale = max(length(t) for t in v)
        self.flat = all(t == 0 for t in dets)
        self.near = min(length(t) for t in v)
        # the side is that of most of the surface, or of what is seen of a bent one; no side to speak of if regions cancel
        self.sided = abs(sum(dets)) > mpf("0.02") * sum(abs(t) for t in dets)
        if self.flat or self.near < mpf("1e-30") * scale:
            self.flat = True
            return
        v = [[t / scale for t in w] for w in v]
        n2 = bands * bands
        self.c, self.g = [mpf(0)] * n2, [[mpf(0)] * n2 for _ in range(3)]
        self.gap = mpf(10) ** 9
        for i in range(count):
            a, b = v[i], v[(i + 1) % count]
            d = minus(b, a)
            if dot(d, d) > 0:
                t = min(max(-dot(a, d) / dot(d, d), mpf(0)), mpf(1))
                self.gap = min(self.gap, length([s + t * o for s, o in zip(a, d)]) / length(d))
            e = edge(bands, a, b)
            if e is None:
                continue
            for l in range(bands):
                for i2 in range(l * l, (l + 1) * (l + 1)):
                    if l:
                        self.c[i2] += e[1][i2] / (l * (l + 1))
                    for k in range(3):
                        self.g[k][i2] += e[0][k] * e[2][i2] / scale
        omegas = [solid_angle(*[[t / scale for t in w] for w in f]) for f in fan]
        self.c[0] = sum(omegas) * M(0)
        self.solid = sum(abs(t) for t in omegas)
        self.slope = sum(solid_slope(f) for f in fan)
        self.whole = length([t[0] for t in self.g]) / M(0)
        behind = sum(omegas if len(seen) > 1 else dets) > 0
        sign = -1 if sides == "signed" else 0 if sides == "front" and behind else 1 if behind else -1
        self.c = [sign * t for t in self.c]
        self.g = [[sign * t for t in g] for g in self.g]

    def bounds(self, bands):
        factor = 1000 if self.gap < mpf("1e-3") else 64
        ls = [l for l in range(bands) for _ in range(2 * l + 1)]
        return ([factor * M(l) * self.solid for l in ls],
                [factor * (M(l) * self.slope + G(l) * self.solid / self.near) for l in ls])


# ---- the surface integral itself ----
def unit_gauss(n):
    """[(node, weight)] over [0, 1]"""
    return [((1 + x) / 2, w / 2) for x, w in gauss(n)]


def surface(bands, a, b, c, depth=0):
    """integral of Y over the directions of a triangle in space, halved until small against its distance"""
    v, sides = [a, b, c], [length(minus(b, a)), length(minus(c, b)), length(minus(a, c))]
    middle = [sum(t) / 3 for t in zip(a, b, c)]
    if max(length(minus(t, middle)) for t in v) > length(middle) / 3 and depth < 60:
        i = sides.index(max(sides))
        p, q, r = v[i], v[(i + 1) % 3], v[(i + 2) % 3]
        half = [(s + t) / 2 for s, t in zip(p, q)]
        parts = surface(bands, p, half, r, depth + 1), surface(bands, half, q, r, depth + 1)
        return [s + t for s, t in zip(*parts)]
    total, det = [0] * bands ** 2, dot(a, cross(minus(b, a), minus(c, a)))
    nodes = unit_gauss(16)
    for s, ws in nodes:
        for t, wt in nodes:
            p = [a[k] + s * ((1 - t) * (b[k] - a[k]) + t * (c[k] - a[k])) for k in range(3)]
            r = length(p)
            weight = fixed(ws * wt * s * det / r ** 3)
            y = basis(bands, [fixed(x / r) for x in p])[0]
            for i in range(bands ** 2):
                total[i] += y[i] * weight
    return [mp.ldexp(mpf(t), -2 * BITS) if isinstance(t, int) else t for t in total]


def self_check(rng, cases):
    """The reference against quadrature of its definition, value and (by differences) gradient."""
    worst = mpf(0)
    for case in range(cases):
        shape, bands = SHAPES[case % len(SHAPES)], 4
        point, vertices = scene(rng, shape, "far" if case % 2 else "low", "f64", milder=True)
        exact = Light(bands, point, vertices, "signed")

        def direct(moved):
            v = [[mpf(vertices[3 * i + k]) - moved[k] for k in range(3)] for i in range(len(vertices) // 3)]
            parts = [surface(bands, v[0], v[i], v[i + 1]) for i in range(1, len(v) - 1)]
            return [-sum(t) for t in zip(*parts)]
        here = direct([mpf(t) for t in point])
        worst = max(worst, max(abs(s - t) for s, t in zip(here, exact.c)) / exact.solid)
        k, h = case % 3, exact.near * mpf("1e-15")
        ends = [direct([mpf(t) + (h * o if i == k else 0) for i, t in enumerate(point)]) for o in (-1, 1)]
        for i in range(bands ** 2):
            slope = (ends[1][i] - ends[0][i]) / (2 * h)
            worst = max(worst, abs(slope - exact.g[k][i]) / (exact.slope + exact.solid / exact.near))
    print("reference against surface quadrature: %d cases, worst difference %.1e" % (cases, float(worst)))
    return worst < mpf("1e-14")


# ---- scenes ----
SHAPES = ["triangle", "quad", "pentagon", "L", "needle", "bowtie", "star", "octagon"]
PLACES = ["far", "near", "grazing", "low", "edge", "vertex", "line", "moved"]
L_SHAPE = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]


def outline(rng, shape):
    if shape == "L":
        a, b = rng.uniform(0.5, 1.5), rng.uniform(0.5, 1.5)
        xy = [(x - a, y - b) for x, y in L_SHAPE]
    elif shape == "needle":
        xy = [(-1, 0), (1, rng.uniform(-0.5, 0.5))]
        t = rng.uniform(-0.9, 1)
        xy.append((t, (t + 1) / 2 * xy[1][1] + 0.002))
    elif shape == "bowtie":
        xy = [(-1, -1), (rng.uniform(0.3, 0.9), 0.8), (0.9, -0.7), (-1, rng.uniform(0, 0.6))]
    else:
        n = {"triangle": 3, "quad": 4, "pentagon": 5, "star": 5, "octagon": 8}[shape]
        turns = [2 * math.pi * (i + rng.uniform(-0.3, 0.3)) / n for i in range(n)]
        xy = [(math.cos(a), math.sin(a)) for a in turns]
        if shape == "star":
            xy = [xy[2 * i % 5] for i in range(5)]
    k = rng.randrange(len(xy))
    xy = xy[k:] + xy[:k]
    return xy[::-1] if rng.random() < 0.5 else xy


def frame(rng):
    if rng.random() < 0.3:
        k = rng.randrange(3)
        return [[int(i == (k + j) % 3) for i in range(3)] for j in range(3)]
    while True:
        w, u = [rng.gauss(0, 1) for _ in range(3)], [rng.gauss(0, 1) for _ in range(3)]
        n = math.sqrt(dot(w, w))
        w = [t / n for t in w]
        d = dot(u, w)
        u = [s - d * t for s, t in zip(u, w)]
        n = math.sqrt(dot(u, u))
        if n > 0.1:
            u = [t / n for t in u]
            return [u, cross(w, u), w]


def scene(rng, shape, place, precision, milder=False):
    log = lambda lo, hi: 10 ** rng.uniform(lo, hi)
    xy = outline(rng, shape)
    low = log(-0.7, -0.2) if milder else rng.choice([log(-6, -1)] * 3 + [log(-3, 0), log(-12, -6)])
    turn = rng.uniform(0, 2 * math.pi)
    move = 0
    if place == "moved":
        place = rng.choice(PLACES[:-1])
        move = log(0, 3)
    i = rng.randrange(len(xy))
    (ax, ay), (bx, by) = xy[i], xy[(i + 1) % len(xy)]
    if place == "far":
        d = 1 / log(-0.6, -0.3) if milder else 1 / log(-6, 1)
        s = rng.uniform(0.05, 1)
        at = [d * math.sqrt(1 - s * s) * math.cos(turn), d * math.sqrt(1 - s * s) * math.sin(turn), d * s]
    elif place == "near":
        d = 1 / log(-0.7, 0.7)
        s = rng.uniform(0.02, 1)
        at = [d * math.sqrt(1 - s * s) * math.cos(turn), d * math.sqrt(1 - s * s) * math.sin(turn), d * s]
    elif place == "grazing":
        d = 1 / log(-3, 0.3)
        at = [d * math.cos(turn), d * math.sin(turn), d * log(-6, -1)]
    elif place == "low":
        r = rng.uniform(0, 0.9)
        at = [r * math.cos(turn), r * math.sin(turn), low]
    elif place in ("edge", "line"):                             # line: also far beyond its ends, seen end on
        t = rng.uniform(-0.1, 1.1) if place == "edge" else rng.choice([-1, 1]) * log(-2, 1)
        n, out = math.hypot(bx - ax, by - ay), low * math.cos(turn)
        at = [ax + t * (bx - ax) + out * (by - ay) / n, ay + t * (by - ay) - out * (bx - ax) / n,
              low * math.sin(turn)]
    else:
        z = rng.uniform(-1, 1) * rng.choice([1, 0.01])
        side = low * math.sqrt(1 - z * z)
        at = [ax + side * math.cos(turn), ay + side * math.sin(turn), low * z]
    if rng.random() < 0.5:
        at[2] = -at[2]
    u, v, w = frame(rng)
    size = rng.choice([1, 1, log(-3, 3), log(-9, 9)])
    zero = rng.choice([[0, 0, 0], at, [rng.uniform(-1, 1) for _ in range(3)]])
    shift = [move * rng.uniform(-1, 1) for _ in range(3)]

    def world(p):
        p = minus(p, zero)
        p = [p[0] * u[k] + p[1] * v[k] + p[2] * w[k] + shift[k] for k in range(3)]
        return [rounded(size * t, precision) for t in p]
    return world(at), [t for x, y in xy for t in world([x, y, 0])]


# ---- triangle as sphere: M22 Eq. 24-28 with the sphere's light from its integral over the cap ----
def triangle_sphere(bands, q, sides):
    q = [mpf(t) for t in q]
    x, a, b, c = q[0:3], q[3:6], q[6:9], q[9:12]
    n = cross(minus(b, a), minus(c, a))
    area = length(n) / 2
    if area == 0:
        return None
    n = [t / (2 * area) for t in n]
    y = minus([sum(t) / 3 for t in zip(a, b, c)], x)
    d, r = length(y), sqrt(area / pi)
    u = [t / d for t in y]
    cosine = -dot(n, minus(a, x)) / d
    n = [-t for t in n]                                         # towards the front, as cosine is
    if abs(cosine) < mpf("1e-25"):
        return None
    f = cosine if sides == "signed" else max(cosine, 0) if sides == "front" else abs(cosine)
    lit = 0 if sides == "front" and cosine < 0 else -1 if sides == "both" and cosine < 0 else 1
    df = [-lit * (n[k] - u[k] * cosine) / d for k in range(3)]  # by the point
    n2, s = bands * bands, r / d
    ls = [l for l in range(bands) for _ in range(2 * l + 1)]
    steep = 1 / (1 - s * s) if s > mpf("0.995") else 1
    if s >= 1:
        light, grad = [2 * sqrt(pi)] + [mpf(0)] * (n2 - 1), [[mpf(0)] * n2 for _ in range(3)]
        omega, domega, steep = 4 * pi, mpf(0), 1
    else:
        alpha = sqrt((1 - s) * (1 + s))
        kappa = s * s / (1 + alpha)
        term = lambda l, j: mpf((-1) ** j * math.comb(l, j) * math.perm(2 * l - 2 * j, l))
        P = [[(term(l, j), l - 2 * j) for j in range(l // 2 + 1)] for l in range(bands)]
        at = lambda l, t: sum((k * t ** p for k, p in P[l]), mpf(0)) / (2 ** l * factorial(l))
        nodes = unit_gauss(bands // 2 + 1)
        g = [2 * pi * sum(w * kappa * at(l, 1 - kappa * t) for t, w in nodes) for l in range(bands)]
        omega, domega = 2 * pi * kappa, 2 * pi * s * s / (alpha * d)
        fu = [fixed(t) for t in u]
        down = lambda t: mp.ldexp(mpf(t), -BITS)
        e = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        tangents = [[e[k][i] - u[k] * u[i] for i in range(3)] for k in range(3)]
        light = None
        grad = []
        for k in range(3):
            values, slopes = basis(bands, fu, [fixed(t) for t in tangents[k]])
            light = [g[l] * down(t) for t, l in zip(values, ls)]
            grad.append([domega * at(l, alpha) * down(values[i]) * u[k] - g[l] * down(slopes[i]) / d
                         for i, l in enumerate(ls)])
    answer = {"c": [(f * t, abs(f) * (24 * M(l) * omega * steep + 8 * abs(t))) for t, l in zip(light, ls)]}
    turn = length(df)
    for k, name in enumerate(["dx", "dy", "dz"]):
        bound = lambda l: 32 * steep * (abs(f) * (M(l) * domega + G(l) * omega / d) + M(l) * omega * turn)
        answer[name] = [(f * grad[k][i] + df[k] * light[i], bound(l)) for i, l in enumerate(ls)]
    return answer


# ---- running ----
def ask(oracle, function, bands, precision, sides, queries):
    text = "".join(",".join("%.17g" % t for t in q) + "\n" for q in queries)
    command = [oracle, function, "--bands", str(bands), "--precision", precision, "--sides", sides]
    run = subprocess.run(command, input=text, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                         universal_newlines=True)
    if run.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit {run.returncode}\n{run.stderr[:500]}")
    lines = [line.split(",") for line in run.stdout.splitlines()]
    names = ["c", "dx", "dy", "dz"] * len(queries)
    if [line[0] for line in lines] != names:
        sys.exit(f"{function}: answers and queries do not match")
    lines = [(line[0], [float(t) for t in line[1:]]) for line in lines]
    return [dict(lines[i:i + 4]) for i in range(0, len(lines), 4)]


class Worst:
    def __init__(self):
        self.rows = {}

    def check(self, row, precision, component, got, exact, where):
        key = row, "value" if component == "c" else "gradient", precision
        w = self.rows.setdefault(key, [mpf(0), 0, ""])
        if len(got) != len(exact):
            sys.exit(f"{row} {component}: {len(got)} values, wanted {len(exact)}")
        for i, (value, (want, bound)) in enumerate(zip(got, exact)):
            error = abs(mpf(value) - want)
            e = (error / (bound * EPS[precision]) if bound else mpf(10) ** 9) if error else mpf(0)
            w[1] += 1
            if not e <= w[0]:
                w[0], w[2] = e, "%s[%d] %s" % (component, i, where)

    def show(self):
        bad = 0
        print("%-20s %-9s %-4s %9s  %-7s worst at" % ("polygon", "component", "", "checks", "/bound"))
        for (row, component, precision), (e, checks, where) in self.rows.items():
            bad += not e <= 1
            print("%-20s %-9s %-4s %9d  %-7.3g %s%s"
                  % (row, component, precision, checks, float(e), "" if e <= 1 else "FAIL ", where))
        return bad


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("oracle")
    parser.add_argument("--queries", type=int, default=4, help="per place, shape and precision")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--place", choices=PLACES + ["as-sphere"])
    parser.add_argument("--shape", choices=SHAPES)
    parser.add_argument("--precision", choices=list(EPS))
    parser.add_argument("--bands", type=int, help="of every query; otherwise 1 .. 16, mostly few")
    parser.add_argument("--self-check", type=int, default=0, help="cases: reference against definition")
    options = parser.parse_args()
    rng, worst, ok = random.Random(options.seed), Worst(), True
    if options.self_check:
        ok = self_check(random.Random(options.seed), options.self_check)
    for place in [options.place] if options.place else PLACES + ["as-sphere"]:
        for precision in [options.precision] if options.precision else EPS:
            groups = {}
            shapes = ["triangle", "needle"] if place == "as-sphere" else SHAPES
            for shape in [options.shape] if options.shape else shapes:
                for _ in range(options.queries):
                    most = 32 if place == "as-sphere" else 16
                    bands = options.bands or rng.choice([1, 2, 3, 4, 5, 6, rng.randint(1, most),
                                                         rng.randint(7, most)])
                    sides = rng.choice(["both", "both", "front", "signed"])
                    where = rng.choice(PLACES) if place == "as-sphere" else place
                    point, vertices = scene(rng, shape, where, precision)
                    groups.setdefault((bands, sides), []).append((shape, point, vertices))
            for (bands, sides), cases in groups.items():
                function = "triangle-as-sphere" if place == "as-sphere" else "polygon"
                queries = [point + ([] if place == "as-sphere" else [len(vertices) // 3]) + vertices
                           for _, point, vertices in cases]
                answers = ask(options.oracle, function, bands, precision, sides, queries)
                for (shape, point, vertices), query, got in zip(cases, queries, answers):
                    where = "--bands %d --sides %s %s: " % (bands, sides, shape)
                    where += ",".join("%.17g" % t for t in query)
                    if place == "as-sphere":
                        answer = triangle_sphere(bands, query, sides)
                        if answer is None:
                            continue
                        exact = [answer[k] for k in ("c", "dx", "dy", "dz")]
                    else:
                        light = Light(bands, point, vertices, sides)
                        if light.flat or not light.sided:
                            continue
                        b = light.bounds(bands)
                        exact = [list(zip(light.c, b[0]))] + [list(zip(g, b[1])) for g in light.g]
                    for component, pairs in zip(("c", "dx", "dy", "dz"), exact):
                        worst.check(place, precision, component, got[component], pairs, where)
    bad = worst.show()
    sys.exit(1 if bad or not ok else 0)


if __name__ == "__main__":
    main()
