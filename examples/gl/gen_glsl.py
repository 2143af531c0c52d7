#!/usr/bin/env python3
"""Write the generated parts of sh.glsl and polygon.glsl, or with --check compare them with what the files hold.

    gen_glsl.py [--check] [folder]

mpmath at 40 digits; 9 significant digits are printed, which name a float exactly."""
import os
import sys

from mpmath import atan, chebyfit, factorial, fac2, legendre, mp, mpf, pi, sqrt, cos, sin, tan

mp.dps = 40
BANDS = 9                                   # what the shader file can be compiled for; light sums need l = BANDS too
BEGIN, END = "/* BEGIN gen_glsl.py: %s */\n", "/* END gen_glsl.py */\n"


def number(v):
    s = "%.9g" % float(v)
    return s if "." in s or "e" in s else s + ".0"


def K(m):                                   # Q_m^m with its factor: sqrt(2) for m > 0 and Condon-Shortley's sign
    j = sqrt(mpf(2 * m + 1) / (4 * pi) / factorial(2 * m)) * (fac2(2 * m - 1) if m else 1)
    return j * (-1) ** m * (sqrt(mpf(2)) if m else 1)


def A(l, m):
    return sqrt(mpf(4 * l * l - 1) / (l * l - m * m)) if l > m else mpf(0)


def B(l, m):
    return A(l, m) / A(l - 1, m) if l > m + 1 else mpf(0)


def Q(l, m, z):
    q1, q = mpf(0), K(m)
    for k in range(m + 1, l + 1):
        q1, q = q, A(k, m) * z * q - B(k, m) * q1
    return q


def gauss(n):                               # Gauss-Legendre nodes and weights on [-1, 1]
    out = []
    for i in range(n):
        x = cos(pi * (mpf(i) + 0.75) / (n + 0.5))
        for _ in range(60):
            p, p1 = legendre(n, x), legendre(n - 1, x)
            d = n * (p1 - x * p) / (1 - x * x)
            x -= p / d
        p1 = legendre(n - 1, x)
        d = n * p1 / (1 - x * x)
        out.append((x, 2 / ((1 - x * x) * d * d)))
    return out


def basis(l, x, y, z):                      # [2l+1] values
    out = [mpf(0)] * (2 * l + 1)
    u, v = mpf(1), mpf(0)
    for m in range(l + 1):
        q = Q(l, m, z)
        out[l - m] = q * v
        out[l + m] = q * u
        u, v = x * u - y * v, x * v + y * u
    return out


def table(name, what, values):
    lines, line = [], "   "
    for v in values:
        s = " " + number(v) + ","
        if len(line + s) > 106:
            lines.append(line)
            line = "   "
        line += s
    lines.append(line.rstrip(","))
    n = len(values)
    return "/* %s */\nconst float %s[%d] = float[%d](\n%s\n);\n" % (what, name, n, n, "\n".join(lines))


def pack(statements):                       # statements on lines of at most 108 columns
    lines, line = [], "   "
    for s in statements:
        if len(line) + len(s) + 1 > 106:
            lines.append(line)
            line = "   "
        while len(line) + len(s) + 1 > 106:                     # a long sum goes on below, indented
            cut = max(s.rfind(sign, 0, 98) for sign in (" + ", " - "))
            lines.append(line + " " + s[:cut])
            line, s = "       ", s[cut + 1:]
        line += " " + s
    return "\n".join(lines + [line]) + "\n"


def total(terms):                           # 'a*c[0] - b*c[1]'
    s = ""
    for k, (v, i) in enumerate(terms):
        sign = ("-" if v < 0 else "") if k == 0 else (" - " if v < 0 else " + ")
        s += "%s%s*c[%d]" % (sign, number(abs(v)), i)
    return s


def cosine():                               # M_ij = integral of Y_i max(0, z) Y_j: bands l, k; the same for m and -m
    nodes = [((x + 1) / 2, w / 2) for x, w in gauss(BANDS + 2)]
    M = {}
    for m in range(BANDS):
        q = {l: [Q(l, m, z) for z, _ in nodes] for l in range(m, BANDS)}
        for l in range(m, BANDS):
            for k in range(m, l + 1):
                if (l - k) % 2 and l - k != 1:
                    continue
                s = sum(w * z * (1 - z * z) ** m * a * b for (z, w), a, b in zip(nodes, q[l], q[k]))
                M[l, k, m] = s * (pi if m else 2 * pi)
    out = "void sh_cosine_product_local(const in float c[SH_N], out float o[SH_N])\n{\n"
    for l in range(BANDS):
        out += "#if SH_BANDS > %d\n" % l if l else ""
        own, others = [], []
        for m in range(-l, l + 1):
            a = abs(m)
            i = l * (l + 1) + m
            own.append("o[%d] = %s;" % (i, total([(M[l, k, a], k * (k + 1) + m) for k in range(a, l + 1)
                                                  if (l, k, a) in M])))
            for k in range(a, l):
                if (l, k, a) in M:
                    others.append("o[%d] += %s;" % (k * (k + 1) + m, total([(M[l, k, a], i)])))
        out += pack(own + others)
        out += "#endif\n" if l else ""
    return out + "}\n"


def quarter_turn():                         # f'(R w) = f(w), R: +y -> +z
    nodes, step = gauss(BANDS + 1), 2 * BANDS + 2
    points = [(sqrt(1 - z * z) * cos(2 * pi * (k + mpf(1) / 3) / step),
               sqrt(1 - z * z) * sin(2 * pi * (k + mpf(1) / 3) / step), z, w * 2 * pi / step)
              for z, w in nodes for k in range(step)]
    out = "void sh_rotate_x90(inout float f[SH_N])\n{\n    float c[SH_N] = f;\n"
    for l in range(1, BANDS):
        rows = [[mpf(0)] * (2 * l + 1) for _ in range(2 * l + 1)]
        for x, y, z, w in points:
            to, frm = basis(l, x, y, z), basis(l, x, z, -y)          # R^-1 w: y' = z, z' = -y
            for i in range(2 * l + 1):
                for j in range(2 * l + 1):
                    rows[i][j] += w * to[i] * frm[j]
        out += "#if SH_BANDS > %d\n" % l
        base = l * l
        out += pack("f[%d] = %s;" % (base + i, total([(v, base + j) for j, v in enumerate(row) if abs(v) > 1e-20]))
                    for i, row in enumerate(rows))
        out += "#endif\n"
    return out + "}\n"


def tables():
    ls = [(l, m) for l in range(BANDS + 1) for m in range(l + 1)]
    return "".join([
        table("SH_K", "Q_m^m = K[m]: sqrt((2m+1)!!/(4 pi (2m)!!)), times sqrt(2) and (-1)^m for m > 0",
              [K(m) for m in range(BANDS + 1)]),
        table("SH_A", "Q_l^m = A z Q_{l-1}^m - B Q_{l-2}^m at l(l+1)/2 + m:  A = sqrt((4l^2-1)/(l^2-m^2))",
              [A(l, m) for l, m in ls]),
        table("SH_B", "B = A_l / A_{l-1}", [B(l, m) for l, m in ls])])


def lines():
    return "".join([
        "/* M_ij = integral of Y_i max(0,z) Y_j: equal m, bands of equal parity or neighbours (MP21, Eq. 11) */\n",
        cosine(),
        "\n/* A quarter turn about x that takes +y to +z; its transpose is Rz(pi) X Rz(pi) */\n",
        quarter_turn()])


def arctangent():
    top = tan(pi / 8) ** 2
    c, error = chebyfit(lambda x: (atan(sqrt(x)) / sqrt(x) - 1) / x if x > 1e-20 else mpf(-1) / 3, [mpf(0), top], 5, error=True)
    assert error * top ** 1.5 < 3e-9, error
    return c[::-1]


def rule():
    nodes = sorted(((x + 1) / 2, w / 2) for x, w in gauss(8))
    return (table("SH_GAUSS_AT", "Gauss-Legendre, 8 points on [0, 1]", [x for x, _ in nodes])
            + table("SH_GAUSS", "their weights", [w for _, w in nodes])
            + table("SH_ATAN", "atan(t) = t + t^3 sum of c_k t^2k for |t| <= tan(pi/8), to 3e-9", arctangent()))


def main():
    args = [a for a in sys.argv[1:] if a != "--check"]
    folder = args[0] if args else os.path.dirname(os.path.abspath(__file__))
    for name, what, write in (("sh.glsl", "tables", tables), ("sh.glsl", "straight lines", lines),
                              ("polygon.glsl", "gauss", rule)):
        path = os.path.join(folder, name)
        with open(path) as f:
            old = f.read()
        i = old.index(BEGIN % what) + len(BEGIN % what)
        new = old[:i] + write() + old[old.index(END, i):]
        if "--check" not in sys.argv:
            with open(path, "w") as f:
                f.write(new)
        elif new != old:
            sys.exit("%s: stale constants (%s), run: python3 examples/gl/gen_glsl.py" % (path, what))
        else:
            print("%s: %s are current" % (path, what))


main()
