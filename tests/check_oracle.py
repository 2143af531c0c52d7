#!/usr/bin/env python3
"""sh-oracle against mpmath: random queries, every answer to the bounds the library documents, both precisions.

    check_oracle.py ORACLE [--queries N] [--seed S] [--function NAME]

Shares nothing with the library or its C tests: associated Legendre functions from their definition as a finite sum at 60
digits, derivatives from the derivative of that sum, lights from their defining integral over the cap. Inputs are rounded
to the precision under test first, so both sides get the same numbers. Prints the worst error per function and precision
in units of the bound; exits 1 if one passes 1."""
import argparse
import math
import random
import struct
import subprocess
import sys
from mpmath import mp, mpf, sqrt, pi, factorial, cos, sin

mp.dps = 60
EPS = {"f32": mpf(2) ** -23, "f64": mpf(2) ** -52}


def rounded(x, precision):
    return struct.unpack("f", struct.pack("f", x))[0] if precision == "f32" else float(x)


# ---- the basis, as polynomials of the unit direction ----
def M(l):
    return sqrt(mpf(2 * l + 1) / (4 * pi))


def G(l):
    return sqrt(mpf(l * (l + 1) * (2 * l + 1)) / (8 * pi))


_sums = {}


def legendre_sum(l, m):
    """[(coefficient, power)] of d^m P_l / dz^m, from Rodrigues' formula by the binomial theorem."""
    if (l, m) not in _sums:
        _sums[l, m] = [(mpf((-1) ** k * math.comb(l, k) * math.perm(2 * l - 2 * k, l + m)) / (2 ** l * math.factorial(l)),
                        l - m - 2 * k) for k in range((l - m) // 2 + 1)] if m <= l else []
    return _sums[l, m]


class Basis:
    """Values, gradients and Hessians of Y(v/|v|) at v, all l < bands."""

    def __init__(self, bands, v, derivatives=0):
        self.rho = sqrt(sum(t * t for t in v))
        self.u = u = [t / self.rho for t in v]
        powers = [mpf(1)]
        for _ in range(bands + 2):
            powers.append(powers[-1] * u[2])
        xy = [mp.mpc(1)]
        for _ in range(bands):
            xy.append(xy[-1] * mp.mpc(u[0], u[1]))
        q = lambda l, m: sum((c * powers[p] for c, p in legendre_sum(l, m)), mpf(0))
        self.y, self.grad, self.hess = [], [], []
        for l in range(bands):
            qs = [q(l, m) for m in range(l + 3)]
            for m in range(-l, l + 1):
                a = abs(m)
                scale = (-1) ** a * M(l) * sqrt(factorial(l - a) / factorial(l + a) * (2 if a else 1))
                part = (lambda c: c.imag) if m < 0 else (lambda c: c.real)
                p = [xy[a], a * xy[a - 1] if a else mp.mpc(0), a * (a - 1) * xy[a - 2] if a > 1 else mp.mpc(0)]
                value = scale * qs[a] * part(p[0])
                self.y.append(value)
                if derivatives < 1:
                    continue
                # the homogeneous extension of degree 0: differentiate F(x,y,z) = Q(z) Re/Im (x+iy)^m, then project
                j = mp.mpc(0, 1)
                f1 = [scale * qs[a] * part(p[1]), scale * qs[a] * part(j * p[1]), scale * qs[a + 1] * part(p[0])]
                k = sum(u[i] * f1[i] for i in range(3))
                t = [f1[i] - u[i] * k for i in range(3)]
                self.grad.append([t[i] / self.rho for i in range(3)])
                if derivatives < 2:
                    continue
                f2 = [[scale * qs[a] * part(p[2]), scale * qs[a] * part(j * p[2]), scale * qs[a + 1] * part(p[1])],
                      [0, -scale * qs[a] * part(p[2]), scale * qs[a + 1] * part(j * p[1])],
                      [0, 0, scale * qs[a + 2] * part(p[0])]]
                for r in range(3):
                    for c in range(r):
                        f2[r][c] = f2[c][r]
                P = [[(r == c) - u[r] * u[c] for c in range(3)] for r in range(3)]
                h = []
                for r in range(3):
                    for c in range(r, 3):
                        s = sum(P[r][i] * f2[i][o] * P[o][c] for i in range(3) for o in range(3))
                        h.append((s - k * P[r][c] - u[r] * t[c] - t[r] * u[c]) / self.rho ** 2)
                self.hess.append(h)


def bands_of(count):
    return [l for l in range(count) for _ in range(2 * l + 1)]


def y_bound(l):
    return (4 + mpf(l * (l + 1)) / 4) * M(l)


def gradient_bound(l):
    return (8 + mpf(l * (l + 1)) / 4) * G(l)


# ---- one generator and one answer per function; an answer is {component: [(exact, bound in eps)]} ----
def unit(rng):
    """A direction; one in four is a pole, an axis, or very near one."""
    v = [rng.gauss(0, 1) for _ in range(3)]
    kind = rng.random()
    if kind < 0.25:
        axis = rng.choice([0, 1, 2, 2, 2])
        v = [0.0, 0.0, 0.0]
        v[axis] = rng.choice([-1.0, 1.0])
        if kind < 0.15:
            v[(axis + 1) % 3] = 10 ** rng.uniform(-12, -1)
    n = math.sqrt(sum(t * t for t in v))
    return [t / n for t in v]


def q_eval(rng, bands, precision):
    return [rounded(t, precision) for t in unit(rng)]


def a_eval(q, bands):
    y = Basis(bands, [mpf(t) for t in q]).y
    return {"Y": [(t, y_bound(l)) for t, l in zip(y, bands_of(bands))]}


def q_grad(rng, bands, precision):
    length = rng.choice([1, 10 ** rng.uniform(-17.9, 17.9), 1.5e-18, 9e17])
    return [rounded(t * length, precision) for t in unit(rng)]


def a_grad(q, bands):
    b, ls = Basis(bands, [mpf(t) for t in q], 1), bands_of(bands)
    answer = {"Y": [(t, y_bound(l)) for t, l in zip(b.y, ls)]}
    for k, name in enumerate(["dx", "dy", "dz"]):
        answer[name] = [(g[k], gradient_bound(l) / b.rho) for g, l in zip(b.grad, ls)]
    return answer


def q_hessian(rng, bands, precision):
    return [rounded(t * 10 ** rng.uniform(-12, 12), precision) for t in unit(rng)]


def a_hessian(q, bands):
    b, ls = Basis(bands, [mpf(t) for t in q], 2), bands_of(bands)
    bound = lambda l: (16 + mpf(l * (l + 1)) / 2) * l * (l + 1) * M(l) / b.rho ** 2
    return {name: [(h[k], bound(l)) for h, l in zip(b.hess, ls)] for k, name in enumerate(["xx", "xy", "xz", "yy", "yz", "zz"])}


def q_angles(rng, bands, precision):
    theta = rng.choice([0.0, math.pi, math.pi / 2, 10 ** rng.uniform(-12, 0), rng.uniform(0, math.pi)])
    return [rounded(theta, precision), rounded(rng.uniform(-math.pi, 2 * math.pi), precision)]


def a_angles(q, bands):
    theta, phi = mpf(q[0]), mpf(q[1])
    ct, st, cp, sp = cos(theta), sin(theta), cos(phi), sin(phi)
    b, ls = Basis(bands, [st * cp, st * sp, ct], 1), bands_of(bands)
    along = lambda g, d: sum(s * t for s, t in zip(g, d))
    return {"Y": [(t, y_bound(l)) for t, l in zip(b.y, ls)],
            "dtheta": [(along(g, [ct * cp, ct * sp, -st]), gradient_bound(l)) for g, l in zip(b.grad, ls)],
            "dphi": [(along(g, [-st * sp, st * cp, mpf(0)]), gradient_bound(l)) for g, l in zip(b.grad, ls)]}


_gauss = {}


def gauss(n):
    if n not in _gauss:
        nodes = []
        for i in range(n):
            x = cos(pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
            for _ in range(8):
                p0, p1 = mpf(1), x
                for k in range(2, n + 1):
                    p0, p1 = p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k
                d = n * (p0 - x * p1) / (1 - x * x)
                x -= p1 / d
            nodes.append((x, 2 / ((1 - x * x) * d * d)))
        _gauss[n] = nodes
    return _gauss[n]


def cap_profile(bands, s):
    """2 pi times the integral of P_l over [alpha, 1], and P_l(alpha), for sin(half-angle) s."""
    alpha = sqrt((1 - s) * (1 + s))
    kappa = s * s / (1 + alpha)
    P = lambda l, t: sum((c * t ** p for c, p in legendre_sum(l, 0)), mpf(0))
    nodes = [(1 - kappa * (1 + x) / 2, w * kappa / 2) for x, w in gauss(bands // 2 + 1)]
    return alpha, kappa, [2 * pi * sum(w * P(l, t) for t, w in nodes) for l in range(bands)], [P(l, alpha) for l in range(bands)]


def ratio(rng):
    return rng.choice([1e-6, 0.999, 0.9999, 0.99, 10 ** rng.uniform(-6, -0.01), rng.uniform(0.1, 0.99)])


def q_cap(rng, bands, precision):
    return [rounded(ratio(rng), precision)]


def a_cap(q, bands):
    s = mpf(q[0])
    alpha, kappa, f, p = cap_profile(bands, s)
    omega, steep = 2 * pi * kappa, 1 / (alpha * alpha) if s > 0.995 else 1
    return {"zh": [(M(l) * f[l], 24 * M(l) * omega * steep) for l in range(bands)],
            "dzh": [(M(l) * 2 * pi * s * p[l], 32 * M(l) * 2 * pi * s * steep) for l in range(bands)]}


def q_sphere(rng, bands, precision):
    size = rng.choice([1, 1, 10 ** rng.uniform(-6, 6)])
    point = [0.0, 0.0, 0.0] if rng.random() < 0.4 else [rounded(size * rng.uniform(-2, 2), precision) for _ in range(3)]
    u = unit(rng)
    center = [rounded(p + size * t, precision) for p, t in zip(point, u)]
    d = math.sqrt(sum((a - b) ** 2 for a, b in zip(center, point)))
    return point + center + [rounded(d * ratio(rng), precision)]


def a_sphere(q, bands):
    q = [mpf(t) for t in q]
    b, ls, r = Basis(bands, [q[3 + k] - q[k] for k in range(3)], 1), bands_of(bands), q[6]
    if b.rho <= r:
        return None
    s = r / b.rho
    alpha, kappa, f, p = cap_profile(bands, s)
    omega, slope = 2 * pi * kappa, 2 * pi * s * s / (alpha * b.rho)
    steep = 1 / (alpha * alpha) if s > 0.995 else 1
    answer = {"c": [(f[l] * y, 24 * M(l) * omega * steep) for y, l in zip(b.y, ls)]}
    for k, name in enumerate(["dx", "dy", "dz"]):
        # d/dx of f(rho) Y(u): rho and u change by minus the point's move; df/drho = -2 pi P_l(alpha) s^2/(alpha rho)
        answer[name] = [(slope * p[l] * y * b.u[k] - f[l] * g[k], 32 * (M(l) * slope + G(l) * omega / b.rho) * steep)
                        for y, g, l in zip(b.y, b.grad, ls)]
    return answer


FUNCTIONS = {"eval": (q_eval, a_eval, 32), "grad": (q_grad, a_grad, 32), "hessian": (q_hessian, a_hessian, 32),
             "angles": (q_angles, a_angles, 32), "cap": (q_cap, a_cap, 32), "sphere": (q_sphere, a_sphere, 32)}


# ---- running ----
def ask(oracle, function, bands, precision, queries):
    """The oracle's answers: one {component: [numbers]} per query."""
    text = "# queries\n\n" + "".join(",".join("%.17g" % t for t in q) + "\n" for q in queries)
    run = subprocess.run([oracle, function, "--bands", str(bands), "--precision", precision], input=text,
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    if run.returncode != 0:
        sys.exit(f"{function} --bands {bands} --precision {precision}: exit {run.returncode}\n{run.stderr[:500]}")
    lines = [line.split(",") for line in run.stdout.splitlines()]
    names = [line[0] for line in lines]
    per = len(lines) // len(queries)
    if per * len(queries) != len(lines) or names != names[:per] * len(queries):
        sys.exit(f"{function}: answers and queries do not match")
    return [{line[0]: [float(t) for t in line[1:]] for line in lines[i:i + per]} for i in range(0, len(lines), per)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("oracle")
    parser.add_argument("--queries", type=int, default=4, help="per function, precision and band count")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--function", choices=FUNCTIONS)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    bad = 0
    print("%-10s %-10s %-4s %9s  %-7s worst at" % ("oracle", "component", "", "checks", "/bound"))
    for name in [options.function] if options.function else FUNCTIONS:
        make, solve, most = FUNCTIONS[name]
        for precision in ("f32", "f64"):
            worst = {}
            for bands in range(1, most + 1):
                count = options.queries if bands <= 12 else max(1, options.queries // 4)
                wanted = [(q, a) for q, a in ((q, solve(q, bands)) for q in (make(rng, bands, precision) for _ in range(count))) if a]
                if not wanted:
                    continue
                for (q, exact), got in zip(wanted, ask(options.oracle, name, bands, precision, [q for q, _ in wanted])):
                    if sorted(got) != sorted(exact):
                        sys.exit(f"{name}: components {sorted(got)}, wanted {sorted(exact)}")
                    for component, values in exact.items():
                        if len(got[component]) != len(values):
                            sys.exit(f"{name} {component}: {len(got[component])} values, wanted {len(values)}")
                        w = worst.setdefault(component, [mpf(0), 0, ""])
                        for i, (value, (want, bound)) in enumerate(zip(got[component], values)):
                            error = abs(mpf(value) - want)
                            e = error / (bound * EPS[precision]) if error else mpf(0)
                            w[1] += 1
                            if not e <= w[0]:
                                w[0], w[2] = e, "[%d] bands %d: %s" % (i, bands, ",".join("%.9g" % t for t in q))
            for component, (e, checks, where) in worst.items():
                ok = e <= 1
                bad += not ok
                print("%-10s %-10s %-4s %9d  %-7.3g %s%s" % (name, component, precision, checks, float(e), "" if ok else "FAIL ", where))
    sys.exit(1 if bad else 0)


main()
