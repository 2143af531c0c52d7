"""Golden rows of systems that cannot be installed here: their published constants, transcribed with the file they stand in.

A row is what the system stores for a unit impulse of radiance from direction d. The facts (order, sign, constants, scale) are
theirs; the few lines that evaluate them are ours."""
from math import pi, sqrt, factorial

DIRECTIONS = [(2 / 7, 3 / 7, 6 / 7), (-6 / 7, 2 / 7, -3 / 7)]


def row(name, source, d, values):
    print(",".join([name, source, "coefficients"] + [repr(float(v)) for v in list(d) + list(values)]))


def cubic(c0, c1, c2, c3, x, y, z):
    """Bands 0..3 as most engines write them: the constants carry the signs."""
    out = [c0, c1[0] * y, c1[1] * z, c1[2] * x]
    if c2:
        out += [c2[0] * x * y, c2[1] * y * z, c2[2] * (3 * z * z - 1), c2[3] * x * z, c2[4] * (x * x - y * y)]
    if c3:
        out += [c3[0] * y * (3 * x * x - y * y), c3[1] * x * y * z, c3[2] * y * (5 * z * z - 1), c3[3] * z * (5 * z * z - 3),
                c3[4] * x * (5 * z * z - 1), c3[5] * z * (x * x - y * y), c3[6] * x * (x * x - 3 * y * y)]
    return out


def directxmath(x, y, z):
    p30, p10 = z * (1.865881662950577 * z * z - 1.1195289977703462), 0.48860251190291992 * z
    p20 = 0.94617469575756008 * z * z - 0.31539156525252005
    p31, p21 = -2.2852289973223288 * z * z + 0.45704579946446577, -1.0925484305920792 * z
    s2, c2 = 2 * x * y, x * x - y * y
    s3, c3 = x * s2 + y * c2, x * c2 - y * s2
    return [0.28209479177387814, -0.48860251190291992 * y, p10, -0.48860251190291992 * x,
            0.54627421529603959 * s2, p21 * y, p20, p21 * x, 0.54627421529603959 * c2,
            -0.59004358992664352 * s3, 1.4453057213202771 * z * s2, p31 * y, p30, p31 * x, 1.4453057213202771 * z * c2,
            -0.59004358992664352 * c3]


def legendre(l, m, z):
    """P_l^m without the Condon-Shortley factor."""
    s, a = sqrt(1 - z * z), 1.0
    for k in range(1, m + 1):
        a *= (2 * k - 1) * s
    b = z * (2 * m + 1) * a
    if l == m:
        return a
    for k in range(m + 2, l + 1):
        a, b = b, (z * (2 * k - 1) * b - (k + m - 1) * a) / (k - m)
    return b


def azimuth(m, x, y):
    """(cos m phi, sin m phi)"""
    r, c, s = sqrt(x * x + y * y), 1.0, 0.0
    for _ in range(m):
        c, s = (c * x - s * y) / r, (s * x + c * y) / r
    return c, s


def real_rows(bands, x, y, z, norm, phase):
    out = []
    for l in range(bands):
        for m in range(-l, l + 1):
            a = abs(m)
            c, s = azimuth(a, x, y)
            out.append((-1 if phase and a & 1 else 1) * norm(l, a) * legendre(l, a, z) * (s if m < 0 else c))
    return out


def orthonormal(l, m):
    return sqrt((2 if m else 1) * (2 * l + 1) / (4 * pi) * factorial(l - m) / factorial(l + m))


def n3d(l, m):
    return sqrt((2 if m else 1) * (2 * l + 1) * factorial(l - m) / factorial(l + m))


def sn3d(l, m):
    return sqrt((2 if m else 1) * factorial(l - m) / factorial(l + m))


def e3nn(x, y, z):
    """_spherical_harmonics.py: sh_1 = x, y, z; sh_2 = sqrt3 xz, sqrt3 xy, y^2 - (x^2+z^2)/2, sqrt3 yz, sqrt3/2 (z^2-x^2);
    normalization 'integral' multiplies by sqrt((2l+1)/4pi)."""
    a, b = sqrt(3 / (4 * pi)), sqrt(5 / (4 * pi))
    return [sqrt(1 / (4 * pi)), a * x, a * y, a * z, b * sqrt(3) * x * z, b * sqrt(3) * x * y, b * (y * y - 0.5 * (x * x + z * z)),
            b * sqrt(3) * y * z, b * sqrt(3) / 2 * (z * z - x * x)]


def fuma(x, y, z):
    """AmbiX to FuMa by the factors and letters of the format's table (Malham; A. sursound list 2018-04-14)."""
    a = real_rows(4, x, y, z, sn3d, False)
    s2, s45, s95, s85 = 2 / sqrt(3), sqrt(45 / 32), 3 / sqrt(5), sqrt(8 / 5)
    return [a[0] / sqrt(2), a[3], a[1], a[2],                                               # W X Y Z
            a[6], s2 * a[7], s2 * a[5], s2 * a[8], s2 * a[4],                               # R S T U V
            a[12], s45 * a[13], s45 * a[11], s95 * a[14], s95 * a[10], s85 * a[15], s85 * a[9]]   # K L M N O P Q


def folded(x, y, z):
    """K^2 times the cosine's pi, 2pi/3, pi/4 over pi, monomials without sign: E/pi as a polynomial of the normal."""
    p = [1, y, z, x, y * x, y * z, 3 * z * z - 1, z * x, x * x - y * y]
    k = [1 / 4, 3 / 4, 3 / 4, 3 / 4, 15 / 4, 15 / 4, 5 / 16, 15 / 4, 15 / 16]
    c = [pi] + [2 * pi / 3] * 3 + [pi / 4] * 5
    return [k[i] / (pi * pi) * c[i] * p[i] for i in range(9)]


def main():
    c2 = [1.0925484305920792, -1.0925484305920792, 0.31539156525252005, -1.0925484305920792, 0.5462742152960396]
    c3 = [-0.5900435899266435, 2.890611442640554, -0.4570457994644658, 0.3731763325901154, -0.4570457994644658,
          1.445305721320277, -0.5900435899266435]
    for d in DIRECTIONS:
        x, y, z = d
        row("sloan", "Sloan 2013 appendix: (-1)^m P_l^m; K_lm", d, real_rows(5, x, y, z, orthonormal, True))
        row("no-phase", "the same without (-1)^m", d, real_rows(5, x, y, z, orthonormal, False))
        row("directxmath", "microsoft/DirectXMath SHMath/DirectXSH.cpp sh_eval_basis_3", d, directxmath(x, y, z))
        row("d3dx", "the same: DirectXSH is D3DXSH's successor by its own documentation", d, directxmath(x, y, z))
        row("m22", "Mezieres et al. 2022 Eq. 8 and 19 (Eq. 6 is printed without the factor)", d,
            real_rows(5, x, y, z, orthonormal, True))
        row("wr18", "Wang and Ramamoorthi 2018 Eq. 7 leaves the sign open: Sloan's is taken", d,
            real_rows(5, x, y, z, orthonormal, True))
        row("pbrt", "mmp/pbrt-v2 src/core/sh.cpp legendrep: neg = (-1)^l on the diagonal", d,
            real_rows(5, x, y, z, orthonormal, True))
        g1, g2 = [-0.488603, 0.488603, -0.488603], [1.092548, -1.092548, 0.315392, -1.092548, 0.546274]
        row("google", "google/spherical-harmonics sh/spherical_harmonics.cc HardcodedSH*", d, cubic(0.282095, g1, g2, [
            -0.590044, 2.890611, -0.457046, 0.373176, -0.457046, 1.445306, -0.590044], x, y, z))
        row("unreal", "Unreal Engine Shaders/Private/SHCommon.ush SHBasisFunction3", d, cubic(0.282095, g1, g2, None, x, y, z))
        row("3dgs", "graphdeco-inria/diff-gaussian-rasterization cuda_rasterizer/auxiliary.h SH_C*; forward.cu signs", d,
            cubic(0.28209479177387814, [-0.4886025119029199, 0.4886025119029199, -0.4886025119029199], c2, c3, x, y, z))
        row("tiny-cuda-nn", "NVlabs/tiny-cuda-nn encodings/spherical_harmonics.h", d,
            cubic(0.28209479177387814, [-0.48860251190291987, 0.48860251190291987, -0.48860251190291987],
                  [1.0925484305920792, -1.0925484305920792, 0.94617469575755997 / 3, -1.0925484305920792, 0.54627421529603959],
                  None, x, y, z))
        row("godot", "godotengine/godot modules/lightmapper_rd/lm_compute.glsl MODE_LIGHT_PROBES: sum times 4/rays", d,
            [v / pi for v in cubic(0.282095, [0.488603] * 3, [1.092548, 1.092548, 0.315392, 1.092548, 0.546274], None, x, y, z)])
        row("filament", "google/filament libs/ibl/src/CubemapSH.cpp computeIrradianceSH3Bands", d, folded(x, y, z))
        row("unity", "pema99/SHTools SHTools.cs: irradiance coefficient times basis constant over pi; order of UnityCG ShadeSH9", d,
            folded(x, y, z))
        u = folded(x, y, z)
        row("unity-packed", "unity_SHAr SHBr SHC from SphericalHarmonicsL2: (3 1 2 0-6) (4 5 3*6 7) (8)", d,
            [u[3], u[1], u[2], u[0] - u[6], u[4], u[5], 3 * u[6], u[7], u[8]])
        row("sh-lib", "andrewwillmott/sh-lib SHLib.cpp kSH_Y_* (y z x; no signs)", d,
            cubic(sqrt(1 / (4 * pi)), [sqrt(3 / (4 * pi))] * 3, [sqrt(15 / (4 * pi)), sqrt(15 / (4 * pi)), sqrt(5 / (16 * pi)),
                  sqrt(15 / (4 * pi)), sqrt(15 / (16 * pi))], None, x, y, z))
        q = sqrt(pi)
        row("falcor", "NVIDIAGameWorks/Falcor Source/Falcor/Utils/Math/SphericalHarmonics.slang eval_SH", d,
            cubic(1 / (2 * q), [sqrt(3) / (2 * q)] * 3, [sqrt(15) / (2 * q), sqrt(15) / (2 * q), sqrt(5) / (4 * q),
                  sqrt(15) / (2 * q), sqrt(15) / (4 * q)], [sqrt(70) / (8 * q), sqrt(105) / (2 * q), sqrt(42) / (8 * q),
                  sqrt(7) / (4 * q), sqrt(42) / (8 * q), sqrt(105) / (4 * q), sqrt(70) / (8 * q)], x, y, z))
        row("sphericart", "lab-cosmo/sphericart docs/src/maths.rst: F_l^m = (-1)^m sqrt(...) against P_l^m with the factor", d,
            real_rows(5, x, y, z, orthonormal, False))
        row("e3nn", "e3nn/e3nn e3nn/o3/_spherical_harmonics.py; normalization integral", d, e3nn(x, y, z))
        row("n3d", "AmbiX (Nachbar et al. 2011): ACN; N3D", d, real_rows(5, x, y, z, n3d, False))
        row("sn3d", "AmbiX (Nachbar et al. 2011): ACN; SN3D", d, real_rows(5, x, y, z, sn3d, False))
        row("fuma", "FuMa maxN over SN3D: 1/sqrt2; 1; 2/sqrt3; sqrt(45/32); 3/sqrt5; sqrt(8/5)", d, fuma(x, y, z))
        table = [[[0.0] * 5 for _ in range(5)] for _ in range(2)]
        for l in range(5):
            for m in range(l + 1):
                c, s = azimuth(m, x, y)
                table[0][l][m] = n3d(l, m) * legendre(l, m, z) * c / (4 * pi)
                table[1][l][m] = n3d(l, m) * legendre(l, m, z) * s / (4 * pi)
        row("shtools", "shtools.github.io real-spherical-harmonics: 4pi norm; no phase; cilm[2][l][m]", d,
            [v for part in table for line in part for v in line])


main()
