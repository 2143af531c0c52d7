"""Golden rows from Python packages: scipy, mpmath, sympy, healpy. Each prints what its own function returns."""
import math
import sys

DIRECTIONS = [(2 / 7, 3 / 7, 6 / 7), (-6 / 7, 2 / 7, -3 / 7)]
BANDS = 5


def row(name, source, d, values):
    print(",".join([name, source, "coefficients"] + [repr(float(v)) for v in list(d) + list(values)]))


def interleave(values):
    return [part for v in values for part in (v.real, v.imag)]


def complex_rows(name, source, y):
    """A unit impulse at d has the coefficients conj(Y_lm(d)), order l^2 + l + m."""
    for d in DIRECTIONS:
        polar, azimuth = math.acos(d[2]), math.atan2(d[1], d[0])
        row(name, source, d, interleave([complex(y(l, m, polar, azimuth)).conjugate()
                                         for l in range(BANDS) for m in range(-l, l + 1)]))


def main():
    import scipy
    import scipy.special
    if hasattr(scipy.special, "sph_harm_y"):
        complex_rows("scipy", f"scipy {scipy.__version__} special.sph_harm_y(l; m; polar; azimuth)", scipy.special.sph_harm_y)
    else:
        complex_rows("scipy", f"scipy {scipy.__version__} special.sph_harm(m; l; azimuth; polar)",
                     lambda l, m, t, p: scipy.special.sph_harm(m, l, p, t))
    import mpmath
    complex_rows("mpmath", f"mpmath {mpmath.__version__} spherharm(l; m; polar; azimuth)", mpmath.spherharm)
    try:
        import sympy
        complex_rows("sympy", f"sympy {sympy.__version__} Ynm(l; m; polar; azimuth)",
                     lambda l, m, t, p: sympy.Ynm(l, m, sympy.Float(t, 25), sympy.Float(p, 25)).expand(func=True).evalf(20))
    except ImportError:
        print("SKIP sympy is not installed", file=sys.stderr)
    try:
        import healpy
        import numpy
        # alm2map of one coefficient at a time, at one pixel centre: a_lm of an impulse is its conjugate value there
        nside, lmax = 8, BANDS - 1
        for pixel in (100, 500):
            d = healpy.pix2vec(nside, pixel)
            size = healpy.Alm.getsize(lmax)
            values = []
            for i in range(size):
                m = healpy.Alm.getlm(lmax, i)[1]
                parts = []
                for unit in (1, 1j):
                    alm = numpy.zeros(size, complex)
                    alm[i] = unit
                    parts.append(healpy.alm2map(alm, nside, lmax=lmax, pixwin=False, verbose=False)[pixel]
                                 if "verbose" in healpy.alm2map.__code__.co_varnames else
                                 healpy.alm2map(alm, nside, lmax=lmax)[pixel])
                # f = a_l0 Y + 2 Re(a_lm Y): the two parts are Re and -Im of Y, doubled for m > 0
                values.append(complex(parts[0], parts[1] if m else 0) / (2 if m else 1))
            row("healpy", f"healpy {healpy.__version__} alm2map", d, interleave(values))
    except ImportError:
        print("SKIP healpy is not installed", file=sys.stderr)


main()
