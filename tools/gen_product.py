#!/usr/bin/env python3
"""Write (or, with --check, verify) the generated tables of sh_product.h.

The text between the BEGIN and END lines is a pure function of this file: mpmath at 60 digits,
17 significant digits printed. Every table is proven here by an identity before it is printed."""
import struct
import sys

from mpmath import matrix, lu_solve, mp, mpf, pi, sqrt

mp.dps = 60
BANDS = 16                          # swap and clamp tables
PAIRS = (4, 8, 16)                 # nodes +-z of the rules of the triple product


def legendre(n, z):
    """P_n(z) and P_n'(z)."""
    a, b = mpf(1), z
    if n == 0:
        return a, mpf(0)
    for k in range(2, n + 1):
        a, b = b, ((2 * k - 1) * z * b - (k - 1) * a) / k
    return b, n * (z * b - a) / (z * z - 1)


def gauss(n):
    """Nodes (descending) and weights of the n-point Gauss-Legendre rule on [-1, 1]."""
    nodes = []
    for k in range(n):
        z = mp.cos(pi * (k + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(12):
            p, d = legendre(n, z)
            z -= p / d
        nodes.append((z, 2 / ((1 - z * z) * legendre(n, z)[1] ** 2)))
    assert abs(sum(w for _, w in nodes) - 2) < mpf(10) ** -50
    assert abs(sum(w * z ** (2 * n - 2) for z, w in nodes) - mpf(2) / (2 * n - 1)) < mpf(10) ** -50
    return nodes


def theta_part(bands, z):
    """{(l, m): Y_lm at azimuth 0}, m >= 0, Condon-Shortley sign."""
    s = sqrt(1 - z * z)
    q = {}
    for m in range(bands):
        q[m, m] = mp.fac2(2 * m - 1) * (-s) ** m if m else mpf(1)
        for l in range(m + 1, bands):
            below = q[l - 2, m] if l - 2 >= m else 0
            q[l, m] = ((2 * l - 1) * z * q[l - 1, m] - (l + m - 1) * below) / (l - m)
    return {(l, m): v * sqrt((2 if m else 1) * (2 * l + 1) / (4 * pi) * mp.factorial(l - m) / mp.factorial(l + m))
            for (l, m), v in q.items()}


def basis(l, x, y, z, cache={}):
    """Y_{l,-l} ... Y_{l,l} at the unit vector."""
    key = z
    if key not in cache:
        cache[key] = theta_part(BANDS, z)
    t, r, out = cache[key], sqrt(x * x + y * y), [mpf(0)] * (2 * l + 1)
    c, s = mpf(1), mpf(0)
    for m in range(l + 1):
        out[l + m] = t[l, m] * c
        if m:
            out[l - m] = t[l, m] * s
        c, s = (c * x - s * y) / r, (s * x + c * y) / r
    return out


def swap_matrix(l):
    """Y_lm(x, z, y) = sum_m' S[m][m'] Y_lm'(x, y, z): solved from 2l+1 points, then proven."""
    points = []
    for k in range(2 * l + 1):
        z = mpf(2 * k + 1) / (2 * l + 1) - 1 + mpf(1) / 97
        f = mpf(k) * k * mpf("2.399963")
        r = sqrt(1 - z * z)
        points.append((r * mp.cos(f), r * mp.sin(f), z))
    a = matrix([basis(l, x, y, z) for x, y, z in points])
    b = matrix([basis(l, x, z, y) for x, y, z in points])
    n = 2 * l + 1
    s = matrix(n, n)
    for i in range(n):
        column = lu_solve(a, b[:, i])
        for j in range(n):
            s[i, j] = column[j]
    unit = s * s
    for i in range(n):
        for j in range(n):
            assert abs(s[i, j] - s[j, i]) < mpf(10) ** -30
            assert abs(unit[i, j] - (i == j)) < mpf(10) ** -30
    return s


def classes(l):
    """The rows of band l that a swap of y and z maps to themselves, and the pair it exchanges."""
    even, odd = list(range(0, l + 1, 2)), list(range(1, l + 1, 2))
    cos_even, cos_odd = even, odd
    sin_even, sin_odd = [-m for m in even if m], [-m for m in odd]
    if l % 2 == 0:
        return [cos_even, sin_odd], (cos_odd, sin_even)
    return [cos_odd, sin_even], (cos_even, sin_odd)


def swap_table():
    out, used = [], 0
    for l in range(BANDS):
        s = swap_matrix(l)
        selves, (a, b) = classes(l)
        seen = set()
        for rows, columns in [(c, c) for c in selves] + [(a, b)]:
            for i in rows:
                for j in columns:
                    out.append(s[l + i, l + j])
                    seen |= {(i, j), (j, i)}
        for i in range(-l, l + 1):
            for j in range(-l, l + 1):
                assert (i, j) in seen or abs(s[l + i, l + j]) < mpf(10) ** -30
    return out


def clamp_table():
    """M[m][l][l'] = integral of Y_lm max(0, z) Y_l'm. Per m two symmetric squares, of the rows l = m, m+2, ... and of
    l = m+1, m+3, ...; then the entries (l, l-1), l = m+1 ...; the others are zero."""
    nodes = [((1 + z) / 2, w / 2) for z, w in gauss(BANDS + 2)]
    parts = [theta_part(BANDS, z) for z, _ in nodes]

    def entry(m, l, k):
        total = sum(w * z * p[l, m] * p[k, m] for (z, w), p in zip(nodes, parts))
        return total * (pi if m else 2 * pi)
    out = []
    for m in range(BANDS):
        for first in (m, m + 1):
            rows = range(first, BANDS, 2)
            out += [entry(m, l, k) for l in rows for k in rows]
        for l in range(m + 1, BANDS):
            out.append(entry(m, l, l - 1))
            exact = sqrt(mpf(l * l - m * m) / (4 * l * l - 1)) / 2          # half the bracket of z
            assert abs(out[-1] - exact) < mpf(10) ** -50
            for k in range(l - 3, m - 1, -2):
                assert abs(entry(m, l, k)) < mpf(10) ** -50
    assert abs(out[0] - mpf(1) / 4) < mpf(10) ** -50
    return out


def to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def literal(exact):
    """17 digits that give the nearest double, and, converted to float, the nearest float."""
    if abs(exact) < mpf(10) ** -30:
        return "0"
    text = repr(float(exact))
    f = to_float(float(text))
    bits = struct.unpack("i", struct.pack("f", f))[0]
    near = [struct.unpack("f", struct.pack("i", b))[0] for b in (bits - 1, bits, bits + 1)]
    assert abs(mpf(f) - exact) <= min(abs(mpf(v) - exact) for v in near) * (1 + mpf(10) ** -6), text
    if text.endswith(".0"):
        text = text[:-2]
    return text


def emit(name, values, comment):
    lines = [f"/* {comment} */", f"static const SHI_T SHI_FN({name})[{len(values)}] = {{"]
    row = "   "
    for v in values:
        item = f" SHI_C({literal(v)}),"
        if len(row) + len(item) > 108:
            lines.append(row)
            row = "   "
        row += item
    lines += [row.rstrip(","), "};"]
    return "\n".join(lines)


def block():
    rules, at = [], []
    for pairs in PAIRS:
        half = gauss(2 * pairs)[:pairs]
        at.append(len(rules))
        rules.append(half)
    flat = [z for r in rules for z, _ in r], [sqrt(1 - z * z) for r in rules for z, _ in r], \
        [w for r in rules for _, w in r]
    names = "/".join(str(p) for p in PAIRS)
    out = [emit("shi_swap", swap_table(),
                "Bands 0..15: per band two blocks that y <-> z maps to themselves, and one between two classes.")]
    out.append(emit("shi_clamp", clamp_table(),
                    "Clamped cosine. Per m: the square of rows l = m, m+2, ..., that of m+1, m+3, ..., and (l, l-1), l > m."))
    out.append(emit("shi_node_z", flat[0], f"Gauss-Legendre, the positive nodes of {names} pairs: z,"))
    out.append(emit("shi_node_s", flat[1], "sqrt(1 - z^2),"))
    out.append(emit("shi_node_w", flat[2], "and weight."))
    return "\n".join(out)


def main(path="sh_product.h"):
    text = open(path, encoding="utf-8").read()
    a, b = "/* BEGIN tools/gen_product.py */\n", "\n/* END tools/gen_product.py */"
    i, j = text.index(a) + len(a), text.index(b)
    if "--check" in sys.argv:
        if text[i:j] != block():
            sys.exit(f"{path}: stale tables, run: python3 tools/gen_product.py")
        print(f"{path}: generated tables are current")
    else:
        open(path, "w", encoding="utf-8").write(text[:i] + block() + text[j:])


if __name__ == "__main__":
    main()
