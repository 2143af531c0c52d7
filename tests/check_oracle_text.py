"""sh-oracle on bad, degenerate and unusual text: what it writes, the line number on stderr, its exit code."""
import subprocess

FINITE = "error,NaN or infinite input"
COUNT = "error,count out of range"
DIRECTION = "error,direction is zero or its length out of range"
RADIUS = "error,radius or depth or angle out of range"
MATRIX = "error,matrix is not a rotation"
Y = "Y,0.282094806"
FULL, DARK = "c,3.54490781 dx,0 dy,0 dz,0", "c,0 dx,0 dy,0 dz,0"
TEXEL = "0,0,1,1,1,1,0,0,-1\n"

# command line, text, lines of the answer, exit code, part of stderr after "sh-oracle: "
CASES = [
    ("eval --bands 1", "0,0,1\n", Y, 0, ""),
    ("eval --bands 1", "", "", 0, ""),
    ("eval --bands 1", "# 1\n\n   \n\t\r\n  # 2\n", "", 0, ""),
    ("eval --bands 1", "0,0,1", Y, 0, ""),
    ("eval --bands 1", "0,0,1\r\n\r\n0,0,1\r\n", Y + " " + Y, 0, ""),
    ("eval --bands 1", " 0 ,\t0,  1 \t\n+0.,-.5,1e0\n", Y + " " + Y, 0, ""),
    ("eval --bands 1", " " * 100000 + "0,0,1\n", Y, 0, ""),
    ("eval --bands 1", "0,0,1,\n", FINITE, 1, 'line 1: "" is not a decimal number'),
    ("eval --bands 1", "0,,1\n", FINITE, 1, 'line 1: ""'),
    ("eval --bands 1", "0 0 1\n", FINITE, 1, 'line 1: "0 0 1"'),
    ("eval --bands 1", "0,0\n", COUNT, 1, "line 1: 2 numbers do not make x,y,z"),
    ("eval --bands 1", "0,0,1,0\n", COUNT, 1, "line 1: 4 numbers"),
    ("eval --bands 1", "1," * 5000 + "1\n0,0,1\n", COUNT + " " + Y, 1, "line 1: 5001 numbers"),
    ("eval --bands 1", "x" * 5000 + "\n", FINITE, 1, 'line 1: "' + "x" * 40 + '"'),
    ("eval --bands 1", "\n#\n0,0,1\n0,0,one\n0,0,2\n", " ".join([Y, FINITE, Y]), 1, 'line 4: "one"'),
    ("eval --bands 1", "0x1p3,0,1\n", FINITE, 1, 'line 1: "0x1p3"'),
    ("eval --bands 1", "0X1,0,1\n", FINITE, 1, 'line 1: "0X1"'),
    ("eval --bands 1", "0,0,1\0,5\n\0\n", FINITE + " " + FINITE, 1, 'line 1: "1?"'),
    ("eval --bands 1", "0,0,nan\n0,inf,1\n-infinity,0,0\n", " ".join([FINITE] * 3), 1, "line 2: NaN or infinite"),
    ("eval --bands 1", "0,0,1e39\n0,0,1e999\n", FINITE + " " + FINITE, 1, "line 1: NaN"),
    ("eval --bands 1 --precision f64", "0,0,1e39\n0,0,1e309\n", "Y,0.28209479177387814 " + FINITE, 1, "line 2: NaN"),
    ("eval --bands 1", "0,0,0\n1e-30,0,0\n0,1e30,0\n-0,0,-1\n", " ".join([DIRECTION] * 3 + [Y]), 1, "line 3: direction"),
    ("grad --bands 1", "0,0,0\n", DIRECTION, 1, "line 1: direction"),
    ("hessian --bands 1", "0,0,0\n", DIRECTION, 1, "line 1: direction"),
    ("angles --bands 1", "nan,0\n0,1e39\n", FINITE + " " + FINITE, 1, "line 2: NaN"),
    ("cap --bands 1", "0\n1\n1.000001\n-1e-9\n", "zh,0 dzh,0 zh,1.77245402 dzh,1.77245402 " + RADIUS + " " + RADIUS, 1, "line 4: radius"),
    ("sphere --bands 1", "0,0,0,0,0,1,0\n0,0,0,0,0,1,-1\n", DARK + " " + RADIUS, 1, "line 2: radius"),
    ("sphere --bands 1", "0,0,0,0,0,1,1\n1,2,3,1,2,3,1\n", FULL + " " + FULL, 0, "line 2: note: point on or inside a sphere light"),
    ("sphere --bands 1", "0,0,0,nan,0,1,1\n", FINITE, 1, "line 1: NaN"),
    ("polygon --bands 1", "0,0,0,2,1,0,1,0,1,1\n", "error,polygon has fewer than three vertices", 1, "line 1: polygon has fewer"),
    ("polygon --bands 1", "0,0,0,3,1,0,1,0,1,1\n0,0,0,2.5,1,0,1,0,1,1,1,1,1\n0,0,0,-3,1,0,1\n", " ".join([COUNT] * 3), 1, "line 3: count"),
    ("polygon --bands 1", "0,0,0\n", COUNT, 1, "line 1: 3 numbers do not make point(3),vertex count"),
    ("polygon --bands 1", "0,0,0,3,1,0,0,0,0,0,0,1,0\n", "c,0.443113476 dx,0 dy,0 dz,0", 0, "note: point on a polygon light"),
    ("polygon --bands 1", "5,5,0,3,1,0,0,-1,1,0,-1,-1,0\n", DARK, 0, ""),
    ("triangle-as-sphere --bands 1", "0,0,0,1,0,1,1,0,1,1,0,1\n", DARK, 0, ""),
    ("cosine-product --bands 1", "0,0,0,1\n", DIRECTION, 1, "line 1: direction"),
    ("cosine-product --bands 1", "0,0,1,nan\n", "out,nan D,nan", 0, ""),
    ("triple-product --bands 1", "1\n", COUNT, 1, "line 1: 1 numbers"),
    ("triple-product --bands 17", ",".join(["1"] * 578) + "\n", "error,number of bands out of range", 1, "line 1: number of bands"),
    ("rotate --bands 1", "1,0,0,0,1,0,0,0,-1,1\n1,0,0,0,1,0,0,0,1.01,1\n" + "0," * 9 + "1\n", " ".join([MATRIX] * 3), 1, "line 3: matrix"),
    ("rotate --bands 1", "1,0,0,0,1,0,0,0,inf,1\n", FINITE, 1, "line 1: NaN"),
    ("cubemap --bands 1", "", DARK, 0, ""),
    ("cubemap --bands 1", TEXEL * 2, "c,0.564189613 dx,0 dy,0 dz,1.12837923", 0, ""),
    ("cubemap --bands 1", "0,0,1,1,1,inf,0,0,0\n", "c,0.282094806 dx,0 dy,0 dz,0", 0, ""),
    ("cubemap --bands 1", TEXEL + "\n0,0,0,1,1,1,0,0,-1\n" + TEXEL, DIRECTION, 1, "line 3: direction"),
    ("cubemap --bands 1", TEXEL + "0,0,1,1,1,0,0,0,-1\n", RADIUS, 1, "line 2: radius"),
    ("cubemap --bands 1", TEXEL + "0,0,1,1,1\n", COUNT, 1, "line 2: 5 numbers"),
    ("convert --bands 1 --from nonsense", "1\n", "", 2, "unknown convention: nonsense"),
    ("", "", "", 2, "no function given"),
    ("eval grad", "", "", 2, "more than one function: grad"),
    ("evil", "", "", 2, "unknown function: evil"),
    ("eval --bands", "", "", 2, "missing value after: --bands"),
    ("eval --bands 0", "", "", 2, "bad number of bands: 0"),
    ("eval --bands 33", "", "", 2, "bad number of bands: 33"),
    ("eval --bands 3x", "", "", 2, "bad number of bands: 3x"),
    ("eval --precision f16", "", "", 2, "unknown precision: f16"),
    ("eval --convention zoo", "", "", 2, "unknown convention: zoo"),
    ("eval --convention unity --bands 4", "", "", 2, "the convention does not have so many bands"),
    ("polygon --sides in", "", "", 2, "unknown sides: in"),
    ("eval --verbose 1", "", "", 2, "unknown option: --verbose")]


def check(oracle):
    bad = 0
    for arguments, text, want, code, said in CASES:
        run = subprocess.run([oracle] + arguments.split(), input=text.encode(), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        got = run.stdout.decode().splitlines()
        wanted = []
        for word in want.split(" ") if want else []:            # status strings have spaces, components a comma
            if "," in word or not wanted:
                wanted.append(word)
            else:
                wanted[-1] += " " + word
        heard = run.stderr.decode()
        if got != wanted or run.returncode != code or (said and "sh-oracle: " not in heard) or said not in heard or (heard and not said):
            bad += 1
            print("FAIL sh-oracle %s <<< %r: %r, exit %d, %r" % (arguments, text[:60], got[:6], run.returncode, heard[:200]))
    help_ = subprocess.run([oracle, "--help"], stdout=subprocess.PIPE, universal_newlines=True)
    examples = [line.strip() for line in help_.stdout.splitlines() if line.strip().startswith("echo ")]
    for line in examples:
        run = subprocess.run(line.replace("sh-oracle", oracle), shell=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if run.returncode or run.stderr or not run.stdout:
            bad += 1
            print("FAIL", line, run.stderr)
    print("%-18s %-12s %-4s %8d  %s" % ("text", "", "", len(CASES) + len(examples), "%d wrong" % bad if bad else "as documented"))
    return bad + (len(examples) < 12)
