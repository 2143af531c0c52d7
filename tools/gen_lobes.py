#!/usr/bin/python3
"""Tables of sh_polygon.h: Gauss-Legendre rules, and lobe sets for the sparse zonal rotation (WR18 section 4.2).

    gen_lobes.py                   rewrite the block of sh_polygon.h from the directions stored in it
    gen_lobes.py --check           the same without writing; fails if the block is stale
    gen_lobes.py --optimise N...   search new directions for the sets of N bands first (L-BFGS, random restarts;
                                   --restarts R, --seed S), keep the better of old and new, rewrite the block

A set for n bands has 2n-1 directions w_d shared by the bands l < n. With A_l[m][d] = sqrt(4 pi/(2l+1)) Y_lm(w_d) the
weights of band l are the pseudo-inverse, W_l = pinv(A_l)^T, so that L_lm = sum_d W_l[m][d] S_l(w_d) * sqrt((2l+1)/(4 pi))
for S_l(w) = integral of P_l(w . u) L(u). The search minimises sum_l tr((A_l A_l^T)^-1)/(2l+1).
Directions are rounded to double, then the weights are computed from those doubles at 50 digits: the block is a pure
function of the stored directions. Nothing here depends on the time, the host or a path."""
import os, re, sys
for v in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(v, "1")
from mpmath import mp, mpf, matrix, sqrt, pi, cos, factorial, lu_solve
mp.dps = 50

SETS = (3, 5, 7, 9, 12, 16)
GAUSS = 16
PATH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "sh_polygon.h")
BEGIN, END = "/* BEGIN tools/gen_lobes.py */\n", "/* END tools/gen_lobes.py */\n"


# ---- exact part ----

def legendre(n, x):
    """P_n and its derivative."""
    a, b = mpf(1), x
    for k in range(2, n + 1):
        a, b = b, ((2 * k - 1) * x * b - (k - 1) * a) / k
    if n == 1:
        return b, mpf(1)
    return b, (n * a - n * x * b) / (1 - x * x)


def gauss(n):
    """Nodes >= 0 in rising order, with weights, of the n-point rule on [-1, 1]."""
    out = []
    for i in range((n + 1) // 2):
        x = cos(pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
        if n % 2 and i == n // 2:
            x = mpf(0)
        else:
            for _ in range(100):
                p, d = legendre(n, x)
                x -= p / d
                if abs(p / d) < mpf(10) ** -45:
                    break
        d = legendre(n, x)[1]
        out.append((x, 2 / ((1 - x * x) * d * d)))
    return out[::-1]


def basis(n, x, y, z, one=mpf(1)):
    """Rows l of Y_lm(x, y, z), Condon-Shortley factor included; works on mpf and on numpy arrays."""
    c, s, out = [one], [0 * one], [[None] * (2 * l + 1) for l in range(n)]
    for m in range(1, n):
        c, s = c + [-(x * c[-1] - y * s[-1])], s + [-(x * s[-1] + y * c[-1])]
    for m in range(n):
        q = {m: one}
        for k in range(1, 2 * m, 2):
            q[m] = q[m] * k
        if m + 1 < n:
            q[m + 1] = (2 * m + 1) * z * q[m]
        for l in range(m + 2, n):
            q[l] = ((2 * l - 1) * z * q[l - 1] - (l + m - 1) * q[l - 2]) / (l - m)
        for l in range(m, n):
            j = NORM[l, m] if isinstance(one, mpf) else float(NORM[l, m])
            out[l][l + m] = j * q[l] * c[m]
            if m:
                out[l][l - m] = j * q[l] * s[m]
    return out


NORM = {(l, m): sqrt((2 * l + 1) / (4 * pi) * factorial(l - m) / factorial(l + m) * (2 if m else 1))
        for l in range(18) for m in range(l + 1)}


def weights(n, dirs):
    """Bands l < n of W_l[m][d], from directions taken as exact doubles (not quite unit: normalised here)."""
    cols = []
    for d in dirs:
        x, y, z = (mpf(v) for v in d)
        r = sqrt(x * x + y * y + z * z)
        cols.append(basis(n, x / r, y / r, z / r))
    out = []
    for l in range(n):
        k = 2 * l + 1
        a = matrix(k, len(dirs))
        for d, col in enumerate(cols):
            for m in range(k):
                a[m, d] = sqrt(4 * pi / k) * col[l][m]
        b = (a * a.T) ** -1
        w = b * a
        out.append([[w[m, d] for d in range(len(dirs))] for m in range(k)])
    return out


# ---- text ----

def array(name, values, per_line=4):
    text = "static const double %s[%d] = {\n" % (name, len(values))
    for i in range(0, len(values), per_line):
        text += "    " + ", ".join(repr(float(v)) for v in values[i:i + per_line])
        text += ",\n" if i + per_line < len(values) else "\n"
    return text + "};\n"


def block(dirs):
    rules = [gauss(n) for n in range(1, GAUSS + 1)]
    text = "/* Gauss-Legendre on [-1,1], nodes >= 0 and their weights: the n-point rule starts at n*n/4 */\n"
    text += array("shi_gauss_x", [x for r in rules for x, _ in r])
    text += array("shi_gauss_w", [w for r in rules for _, w in r])
    for n in SETS:
        c = condition(n, dirs[n])
        text += "/* %d bands: %d lobes, condition of the worst band %.2f */\n" % (n, 2 * n - 1, c)
        text += array("shi_lobes_%d" % n, [v for d in dirs[n] for v in d], 3)
        text += "/* ... weights [l(l+1)+m][lobe] */\n"
        text += array("shi_weights_%d" % n, [w for band in weights(n, dirs[n]) for row in band for w in row])
    return text


def stored(text):
    """Directions in the header, per set."""
    out = {}
    for n in SETS:
        m = re.search(r"shi_lobes_%d\[\d+\] = \{(.*?)\}" % n, text, re.S)
        if m:
            v = [float(t) for t in m.group(1).replace("\n", " ").split(",")]
            out[n] = [tuple(v[i:i + 3]) for i in range(0, len(v), 3)]
    return out


# ---- search (numpy, scipy) ----

def bands(n, dirs):
    import numpy as np
    d = np.asarray(dirs, float)
    d = d / np.sqrt((d * d).sum(1))[:, None]
    y = basis(n, d[:, 0], d[:, 1], d[:, 2], np.ones(len(d)))
    return [np.sqrt(4 * np.pi / (2 * l + 1)) * np.array(y[l]) for l in range(n)]


def condition(n, dirs):
    """Largest condition number of a band; the text shows two decimals, far above the noise of the SVD."""
    import numpy as np
    return max(np.linalg.cond(a) for a in bands(n, dirs))


def cost(v, n):
    """Objective and its gradient by the free vectors v (normalised inside)."""
    import numpy as np
    v = v.reshape(-1, 3)
    r = np.sqrt((v * v).sum(1))
    u = v / r[:, None]
    value, grad = 0.0, np.zeros_like(u)
    y = bands(n + 1, u)
    for l in range(n):
        a = y[l]
        b = np.linalg.inv(a @ a.T)
        value += np.trace(b) / (2 * l + 1)
        h = -2 * (b @ b @ a) / (2 * l + 1)                 # d value / d a
        grad += np.einsum("md,mdk->dk", h, slopes(l, u))
    grad = (grad - (grad * u).sum(1)[:, None] * u) / r[:, None]
    return value, grad.ravel()


def slopes(l, u):
    """d/du of sqrt(4 pi/(2l+1)) Y_lm as a polynomial: [m][d][3], by U' and V' with dQ_l^m/dz = Q_l^{m+1}."""
    import numpy as np
    x, y, z = u.T
    c, s = [np.ones_like(x)], [0 * x]
    for m in range(1, l + 1):
        c, s = c + [-(x * c[-1] - y * s[-1])], s + [-(x * s[-1] + y * c[-1])]
    out = np.zeros((2 * l + 1, len(x), 3))
    q = [None] * (l + 2)
    for m in range(l + 1):                                  # Q_l^m(z)
        p0 = np.ones_like(z)
        for k in range(1, 2 * m, 2):
            p0 = p0 * k
        p1 = (2 * m + 1) * z * p0
        if l == m:
            q[m] = p0
        else:
            for k in range(m + 2, l + 1):
                p0, p1 = p1, ((2 * k - 1) * z * p1 - (k + m - 1) * p0) / (k - m)
            q[m] = p1
    q[l + 1] = 0 * z
    for m in range(l + 1):
        j = float(NORM[l, m]) * np.sqrt(4 * np.pi / (2 * l + 1))
        cm, sm = (c[m - 1], s[m - 1]) if m else (0 * x, 0 * x)
        out[l + m] = j * np.stack([-m * q[m] * cm, m * q[m] * sm, q[m + 1] * c[m]], 1)
        if m:
            out[l - m] = j * np.stack([-m * q[m] * sm, -m * q[m] * cm, q[m + 1] * s[m]], 1)
    return out


def search(n, restarts, seed, start=None):
    import numpy as np
    from scipy.optimize import minimize
    rng, best = np.random.default_rng(seed + n), None
    k = 2 * n - 1
    for r in range(restarts + (start is not None)):
        if r == restarts:
            v = np.array(start)
        else:                                               # a jittered half-sphere spiral: w and -w are one lobe
            t = (np.arange(k) + 0.5) / k
            a = np.pi * (3 - np.sqrt(5)) * np.arange(k)
            v = np.stack([np.sqrt(1 - t * t) * np.cos(a), np.sqrt(1 - t * t) * np.sin(a), t], 1)
            v += rng.normal(size=v.shape) * rng.choice([0.1, 0.3, 1.0])
        try:
            o = minimize(cost, v.ravel(), args=(n,), jac=True, method="L-BFGS-B",
                         options=dict(maxiter=3000, maxfun=5000, maxcor=20, ftol=1e-13, gtol=1e-8))
        except np.linalg.LinAlgError:
            continue
        d = o.x.reshape(-1, 3)
        d = d / np.sqrt((d * d).sum(1))[:, None]
        d[d[:, 2] < 0] *= -1
        c = condition(n, d)
        if best is None or c < best[0]:
            best = (c, [tuple(float(x) for x in row) for row in d])
            print("%2d bands, start %3d: objective %.6f condition %.4f" % (n, r, o.fun, c), file=sys.stderr, flush=True)
    return best[1]


def main(argv):
    text = open(PATH).read()
    i, j = text.index(BEGIN) + len(BEGIN), text.index(END)
    dirs = stored(text)
    if "--optimise" in argv:
        option = lambda name, default: int(argv[argv.index(name) + 1]) if name in argv else default
        restarts, seed = option("--restarts", 40), option("--seed", 1)
        named = [int(a) for k, a in enumerate(argv) if a.isdigit() and argv[k - 1] not in ("--restarts", "--seed")]
        for n in named or SETS:
            dirs[n] = search(n, restarts, seed, dirs.get(n))
    new = block(dirs)
    if "--check" in argv:
        if text[i:j] != new:
            sys.exit("sh_polygon.h: stale tables, run tools/gen_lobes.py")
        print("sh_polygon.h: tables are current")
    else:
        open(PATH, "w").write(text[:i] + new + text[j:])


if __name__ == "__main__":
    main(sys.argv[1:])
