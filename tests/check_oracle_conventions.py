"""sh-oracle --convention NAME against each system's definition as docs/conventions.md words it, derived here and
nowhere else: order, sign, scale and axes of what every function reads and writes."""
import subprocess
from mpmath import mpf, mpc, sqrt, pi
from check_oracle_lights import FUNCTIONS as LIGHTS
from check_oracle_products import FUNCTIONS as PRODUCTS
from check_oracle_reference import EPS, bands_of, rounded

COSINE = [pi, 2 * pi / 3, pi / 4]                           # irradiance over radiance of bands 0, 1, 2


def scaled(factor, phase):
    """Order l^2+l+m, each number factor(l) times the coefficient, (-1)^m in or out; c is in the library's convention."""
    return lambda c, bands: [factor(l) * (1 if phase else (-1) ** abs(i - l * (l + 1))) * c[i]
                             for i, l in enumerate(bands_of(bands))]


def complex_set(c, bands, l, m):
    """a_lm = integral of f conj(Y_lm), Y_lm with the Condon-Shortley factor."""
    a, i = abs(m), l * (l + 1)
    if m == 0:
        return mpc(c[i])
    positive = mpc(c[i + a], -c[i - a]) / sqrt(mpf(2))      # Y_lm = (R_lm + i R_l,-m)/sqrt 2, R of Sloan's sign
    return positive if m > 0 else (-1) ** a * positive.conjugate()


def parts(values):
    return [t for v in values for t in (v.real, v.imag)]


def polynomial(c, monomials):
    """Irradiance/pi of bands 0..2 as coefficients of the named polynomials of the normal."""
    k = [sqrt(t / pi) for t in (mpf(1) / 4, mpf(3) / 4, mpf(15) / 4, mpf(5) / 16, mpf(15) / 16)]
    # the same function in powers of the normal; without (-1)^m: y z x  xy yz 3z^2-1 xz x^2-y^2
    e = [COSINE[l] / pi * (-1) ** abs(i - l * (l + 1)) * c[i] for i, l in enumerate(bands_of(3))]
    p = {"1": k[0] * e[0] - k[3] * e[6], "y": k[1] * e[1], "z": k[1] * e[2], "x": k[1] * e[3],
         "xy": k[2] * e[4], "yz": k[2] * e[5], "xz": k[2] * e[7],
         "zz": 3 * k[3] * e[6], "xx": k[4] * e[8], "yy": -k[4] * e[8]}
    if monomials == "packed":                               # SHA.(n,1) + SHB.(xy yz zz zx) + SHC (xx - yy)
        return [p["x"], p["y"], p["z"], p["1"], p["xy"], p["yz"], p["zz"], p["xz"], p["xx"]]
    if monomials == "babylon":                              # homogeneous: 1 = xx + yy + zz
        return [p["x"], p["y"], p["z"]] + [p[k] + p["1"] for k in ("xx", "yy", "zz")] + [p["yz"], p["xz"], p["xy"]]
    return [p["1"] + p["zz"] / 3, p["y"], p["z"], p["x"], p["xy"], p["yz"], p["zz"] / 3, p["xz"], p["xx"]]


def square(c, bands):
    """cilm[2][l][m] of the 4-pi-normalised basis: the integral of f Y/(4 pi), Y^2 averaging 1."""
    out = [[[mpf(0)] * bands for _ in range(bands)] for _ in range(2)]
    for i, l in enumerate(bands_of(bands)):
        m = i - l * (l + 1)
        out[m < 0][l][abs(m)] = (-1) ** abs(m) * c[i] * sqrt(4 * pi) / (4 * pi)
    return [t for part in out for row in part for t in row]


def gsl(c, bands):
    """f = sum over m >= 0 of P_lm (a cos m phi + b sin m phi), P_lm orthonormal, no (-1)^m."""
    tables = [[], []]
    for l in range(bands):
        for m in range(l + 1):
            for k, i in enumerate((l * (l + 1) + m, l * (l + 1) - m)):
                tables[k].append((-1) ** m * c[i] * (sqrt(mpf(2)) if m else 1) if m or not k else mpf(0))
    return tables[0] + tables[1]


def healpy(c, bands):
    return parts([complex_set(c, bands, l, m) for m in range(bands) for l in range(m, bands)])


def fuma(c, bands):
    """Letters W XYZ RSTUV KLMNOPQ; every function has maximum 1 on the sphere, W 1/sqrt 2."""
    m = {}
    for i, l in enumerate(bands_of(bands)):
        m[l, i - l * (l + 1)] = (-1) ** abs(i - l * (l + 1)) * c[i] * sqrt(4 * pi / (2 * l + 1))       # SN3D
    highest = {(1, 1): 1, (2, 0): 1, (2, 1): sqrt(mpf(3)) / 2, (2, 2): sqrt(mpf(3)) / 2, (3, 0): 1,
               (3, 1): sqrt(mpf(32) / 45), (3, 2): sqrt(mpf(5)) / 3, (3, 3): sqrt(mpf(5) / 8)}      # of SN3D functions
    order = [(1, 1), (1, -1), (1, 0)] + [(2, k) for k in (0, 1, -1, 2, -2)]
    order += [(3, k) for k in (0, 1, -1, 2, -2, 3, -3)]
    out = [m[0, 0] / sqrt(mpf(2))]
    return out + [m[k] / highest.get((k[0], abs(k[1])), 1) for k in order if k[0] < bands]


same, plain = scaled(lambda l: 1, True), scaled(lambda l: 1, False)
everything = lambda c, bands: parts([complex_set(c, bands, l, i - l * (l + 1)) for i, l in enumerate(bands_of(bands))])
unity = lambda c, bands: polynomial(list(c) + [mpf(0)] * (9 - len(c)), "unity")[:bands * bands]
SYSTEMS = {     # name: (from our coefficients to theirs, most bands, which of our axes theirs are)
    "sloan": (same, 32), "directxmath": (same, 6), "d3dx": (same, 6), "m22": (same, 32), "wr18": (same, 32),
    "pbrt": (same, 29), "google": (same, 32), "tiny-cuda-nn": (same, 8), "3dgs": (same, 4), "unreal": (same, 3),
    "babylon": (same, 3), "no-phase": (plain, 32), "three": (plain, 3), "sh-lib": (plain, 32), "falcor": (plain, 4),
    "sphericart": (plain, 32), "e3nn": (plain, 12, (1, 2, 0)), "gltf": (scaled(lambda l: COSINE[l], True), 3),
    "godot": (scaled(lambda l: 1 / pi, False), 3), "unity": (unity, 3), "filament": (unity, 3),
    "unity-packed": (lambda c, bands: polynomial(c, "packed"), 3),
    "babylon-polynomial": (lambda c, bands: polynomial(c, "babylon"), 3), "shtools": (square, 32), "gsl": (gsl, 32),
    "healpy": (healpy, 32), "scipy": (everything, 32), "mpmath": (everything, 32), "sympy": (everything, 32),
    "boost": (everything, 32), "n3d": (scaled(lambda l: sqrt(4 * pi), False), 32),
    "sn3d": (scaled(lambda l: sqrt(4 * pi / (2 * l + 1)), False), 32), "fuma": (fuma, 4)}
ONLY_3 = ("unity-packed", "babylon-polynomial")
# function: its query, v a vector, s a number, m a matrix, c coefficients
LAYOUTS = {"eval": "v", "grad": "v", "hessian": "v", "sphere": "vvs", "cosine-product": "vc", "triple-product": "cc",
           "rotate": "mc"}
SECOND = {"xx": (0, 0), "xy": (0, 1), "xz": (0, 2), "yy": (1, 1), "yz": (1, 2), "zz": (2, 2)}


def encode(query, layout, bands, axes, theirs, precision):
    """The query in the system's axes and numbers."""
    out, at = [], 0
    for kind in layout:
        n = {"v": 3, "s": 1, "m": 9, "c": bands * bands}[kind]
        part = query[at:at + n]
        at += n
        if kind == "v":
            part = [part[axes[i]] for i in range(3)]
        elif kind == "m":
            part = [part[3 * axes[i] + axes[k]] for i in range(3) for k in range(3)]
        elif kind == "c":
            part = theirs([mpf(t) for t in part], bands)
        out += [rounded(float(t), precision) for t in part]
    return out


def decode_names(exact, axes):
    """Whose values the components in their axes have: their dx is our derivative by axis axes[0]."""
    names = {"d" + "xyz"[i]: "d" + "xyz"[axes[i]] for i in range(3)}
    for name, pair in SECOND.items():
        names[name] = "".join("xyz"[k] for k in sorted(axes[i] for i in pair))
    return [(name, names.get(name, name)) for name in exact]


def linear(theirs, values, bands):
    """Exact values in their numbers; one bound for all, from the largest of ours and the map's largest entry."""
    count, top = len(values), max(bound for _, bound in values)
    unit = max(max(abs(t) for t in theirs([mpf(i == k) for i in range(count)], bands)) for k in range(count))
    return [(e, 4 * top * unit + 4 * abs(e)) for e in theirs([v for v, _ in values], bands)]


def unknown(oracle):
    """Conventions that the program lists and this file does not define."""
    text = subprocess.run([oracle, "--help"], stdout=subprocess.PIPE, universal_newlines=True).stdout
    names = text.split("impulse):")[1].split("A bad query")[0].split()
    return sorted(set(names) ^ set(SYSTEMS))


def check(options, rng, ask, Worst):
    bad = len(unknown(options.oracle))
    if bad:
        print("FAIL conventions not on both sides:", *unknown(options.oracle))
    for name, (theirs, most, *more) in SYSTEMS.items():
        if options.convention not in (None, name):
            continue
        axes = more[0] if more else (0, 1, 2)
        for precision in ("f32", "f64"):
            worst = Worst()
            largest = min(most, 5 if options.bands == "few" else 16)
            for bands in (3,) if name in ONLY_3 else sorted({1, 2, 3, largest}):
                for function, layout in LAYOUTS.items():
                    make, solve, limit = (PRODUCTS if function in PRODUCTS else LIGHTS)[function]
                    if bands > limit:
                        continue
                    for _ in range(options.queries if options.bands != "few" else 1):
                        q = make(rng, bands, precision)
                        exact = solve(q, bands, None)
                        if not exact:
                            continue
                        asked = encode(q, layout, bands, axes, theirs, precision)
                        got = ask(options, function, bands, precision, [asked], ["--convention", name])[0]
                        where = "%s --convention %s --bands %d: %s" % (function, name, bands,
                                                                       ",".join("%.17g" % t for t in asked))
                        for component, source in decode_names(exact, axes):
                            want = exact[source] if component == "D" else linear(theirs, exact[source], bands)
                            worst.check(got[component], want, EPS[precision], where)
            bad += worst.report("convention", name[:12], precision)
    return bad
