#!/usr/bin/env python3
"""Write (or, with --check, verify) the table room of sh_gradient.h.

The text between the BEGIN and END lines is a pure function of this file: exact rational
arithmetic, one square root at 50 digits, 17 significant digits printed."""
import struct
import sys
from fractions import Fraction
from math import factorial

from mpmath import mp, mpf, pi, sqrt

mp.dps = 50
TOP = 33            # highest l: 32 bands, and two more for the Hessians of moments
POLYNOMIAL_BANDS = 10
BANDS = 32
NODES = (BANDS - 2) // 2


def odd_factorial(k):                       # (2k-1)!!
    return Fraction(factorial(2 * k), 2 ** k * factorial(k))


def beta(l, m):
    """q_l = z q_{l-1} - beta q_{l-2}, monic in z; a column begins with q_m = 1 and q_{m-1} = 0."""
    return Fraction(0) if l == m else Fraction((l - 1) ** 2 - m * m, (2 * l - 1) * (2 * l - 3))


def norm2(l, m):
    """(4 pi) J_lm^2 times the square of the leading coefficient of Q_l^m."""
    lead = odd_factorial(l) / factorial(l - m)
    return (2 if m else 1) * (2 * l + 1) * Fraction(factorial(l - m), factorial(l + m)) * lead ** 2


def slope2(l, m):
    """Square of J_lm / J_l,m+1: the derivative of column m from column m+1."""
    return Fraction((l - m) * (l + m + 1), 1 if m else 2)


def pole(l, m):
    """J_lm Q_l^m(1) = M_l sqrt((2 if m) (l+m)!/(l-m)!) / (2^m m!)."""
    v = (2 if m else 1) * (2 * l + 1) * Fraction(factorial(l + m), factorial(l - m)) / Fraction(2 ** m * factorial(m)) ** 2
    return sqrt(frac(v) / (4 * pi))


def norm(l, m):
    v = norm2(l, m)
    return sqrt(mpf(v.numerator) / v.denominator / (4 * pi))


def horner(m):
    """Rows d = 0, 1, ...: N q_{m+d}^m = z^(d&1) sum_k row[k] t^k with t = z^2 - 1/2."""
    rows = []
    for d in range(POLYNOMIAL_BANDS - m):
        l = m + d
        if d == 0:
            row = [Fraction(1)]
        else:
            row = list(rows[d - 1])
            if d % 2 == 0:                  # z * z R(t) = (t + 1/2) R(t)
                row = [a / 2 + b for a, b in zip(row + [Fraction(0)], [Fraction(0)] + row)]
            if d > 1:
                for k, v in enumerate(rows[d - 2]):
                    row[k] -= beta(l, m) * v
        rows.append(row)
    return [[mpf(v.numerator) / v.denominator * norm(m + d, m) for v in row] for d, row in enumerate(rows)]


def nodes(m):
    """1/2 - t for column m's nodes t of Newton's form in t = z^2, multiples of 1/1024: each where (1 - t)^(m/4), half the power that
    the column is multiplied by, times the distances from those before is largest (Leja's points)."""
    score = [(1024 - i) ** m for i in range(1025)]
    found = []
    for _ in range(NODES - m // 2):
        found.append(max(range(1025), key=lambda i: score[i]))
        score = [s * (i - found[-1]) ** 4 for i, s in enumerate(score)]
    return [mpf(512 - i) / 1024 for i in found]


def profile(l):
    k = max(l, 1)
    return [mpf(l), mpf(l + 1), mpf(1 - 2 * l), 1 / mpf(k), 1 / mpf(k * (k + 1)), mpf(2 * l + 1), mpf(l * l - 1),
            mpf(l * (l + 1)), mpf(l * (l + 2))]


def to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def digits(exact):
    text = repr(float(exact))
    bits = struct.unpack("I", struct.pack("f", float(exact)))[0]
    near = [struct.unpack("f", struct.pack("I", max(bits + d, 0)))[0] for d in (-1, 0, 1)]
    best = min(near, key=lambda v: abs(mpf(v) - exact))
    assert to_float(float(exact)) == best, f"{text}: rounding through double misses the nearest float"
    return text


def table(name, size, comment, values):
    assert len(values) == size
    out = [f"/* {comment} */", f"static const SHI_T SHI_FN({name})[{size}] = {{"]
    line = "   "
    for v in values:
        item = f" SHI_C({digits(v)}),"
        if len(line) + len(item) > 108:
            out.append(line)
            line = "   "
        line += item
    return "\n".join(out + [line.rstrip(","), "};"])


def frac(f):
    return mpf(f.numerator) / f.denominator


def block():
    polynomials = {m: horner(m) for m in range(POLYNOMIAL_BANDS)}
    pairs = [(l, m) for l in range(TOP + 1) for m in range(l + 1)]
    line = [(l, abs(m)) for l in range(POLYNOMIAL_BANDS) for m in range(-l, l + 1)]
    flat = [(polynomials[m][l - m] + [mpf(0)] * 5)[k] for k in range((POLYNOMIAL_BANDS + 1) // 2) for l, m in line]
    newton = [nodes(m) for m in range(BANDS - 2)]
    rows = sum(([newton[m][k] for m in range(BANDS - 2 - 2 * k)] for k in range(NODES)), [])
    return "\n".join([
        table("shi_beta", len(pairs), "[l(l+1)/2 + m]: monic q_l = z q_{l-1} - beta q_{l-2}",
              [frac(beta(l, m)) for l, m in pairs]),
        table("shi_norm", len(pairs), "[l(l+1)/2 + m]: times monic q_l^m it is the normalised one", [norm(l, m) for l, m in pairs]),
        table("shi_pole", len(pairs), "[l(l+1)/2 + m]: norm included, q_l^m at z = 1", [pole(l, m) for l, m in pairs]),
        table("shi_ratio", len(pairs), "[l(l+1)/2 + m]: (2l-1)/(l+m), l >= 1", [mpf(max(2 * l - 1, 0)) / max(l + m, 1) for l, m in pairs]),
        table("shi_slope", len(pairs), "[l(l+1)/2 + m]: norm included, d q_l^m / dz = slope q_l^{m+1}",
              [sqrt(frac(slope2(l, m))) for l, m in pairs]),
        table("shi_root", 72, "[k]: sqrt(k)", [sqrt(mpf(k)) for k in range(72)]),
        table("shi_inverse_root", TOP + 3, "[l]: 1/sqrt(4 l^2 - 1), l >= 1",
              [mpf(0)] + [1 / sqrt(mpf(4 * l * l - 1)) for l in range(1, TOP + 3)]),
        table("shi_profile", 9 * BANDS, "[9 l]: l, l+1, 1-2l, 1/l, 1/(l(l+1)), 2l+1, l^2-1, l(l+1), l(l+2); quotients for l >= 1",
              sum((profile(l) for l in range(BANDS)), [])),
        table("shi_zonal", TOP + 1, "[l]: Y_l0(+z) = sqrt((2l+1)/(4 pi))", [sqrt((2 * l + 1) / (4 * pi)) for l in range(TOP + 1)]),
        table("shi_horner", len(flat) + 16, "[100 k + l(l+1) + m]: q_l^|m| = z^((l-m)&1) sum_k c_k (z^2 - 1/2)^k, norm included; "
              "and room to read a register", flat + [mpf(0)] * 16),
        table("shi_node", len(rows) + 16, "[k(31-k) + m]: 1/2 - node k < (31-m)/2 of column m's form of Newton; and room to read a register",
              rows + [mpf(0)] * 16),
        table("shi_line_slope", len(line), "[l(l+1) + m]: shi_slope by coefficient", [sqrt(frac(slope2(l, m))) for l, m in line]),
    ])


def main():
    path = "sh_gradient.h"
    with open(path) as f:
        text = f.read()
    a, b = "/* BEGIN tools/gen_gradient.py */\n", "\n/* END tools/gen_gradient.py */"
    i, j = text.index(a) + len(a), text.index(b)
    if "--check" in sys.argv:
        if text[i:j] != block():
            sys.exit(f"{path}: tables are not what tools/gen_gradient.py prints; run make tables")
        print(f"{path}: tables are current")
    else:
        text = text[:i] + block() + text[j:]
        with open(path, "w") as f:
            f.write(text)


main()
