#!/usr/bin/env python3
"""Re-verify tests/conventions/golden.csv against the real packages (make check-conventions), or write it (--write).

three and @babylonjs/core are installed by npm into the build folder, GSL and Boost are compiled against, scipy, mpmath, sympy
and healpy are imported; whatever is missing is named and its stored rows are left as they are. Rows of systems that cannot be
installed are recomputed from their published constants (sources.py)."""
import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
GOLDEN = os.path.join(HERE, "golden.csv")
PACKAGES = ["three@0.187.0", "@babylonjs/core@9.34.0"]


def run(command, **more):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)
    return done.stdout if done.returncode == 0 else None


def collect(build):
    os.makedirs(build, exist_ok=True)
    rows, missing = [], []
    script = os.path.join(build, "three_babylon.mjs")
    shutil.copy(os.path.join(HERE, "three_babylon.mjs"), script)
    out = None
    if shutil.which("npm") and shutil.which("node"):
        if run(["npm", "install", "--prefix", build, "--no-audit", "--no-fund", "--no-save"] + PACKAGES) is not None:
            out = run(["node", script])
    rows += out.splitlines() if out else []
    missing += [] if out else ["three", "babylon", "babylon-polynomial", "gltf"]
    for name, command in (("gsl", [os.environ.get("CC", "cc"), "gsl.c", "-lgsl", "-lgslcblas", "-lm"]),
                          ("boost", [os.environ.get("CXX", "c++"), "boost.cpp"])):
        program = os.path.join(os.path.abspath(build), name)
        built = run(command[:1] + ["-o", program] + command[1:], cwd=HERE)
        out = run([program]) if built is not None else None
        rows += out.splitlines() if out else []
        missing += [] if out else [name]
    out = run([sys.executable, os.path.join(HERE, "packages.py")]) or ""
    rows += out.splitlines()
    missing += [n for n in ("scipy", "mpmath", "sympy", "healpy") if not any(r.startswith(n + ",") for r in rows)]
    rows += run([sys.executable, os.path.join(HERE, "sources.py")]).splitlines()
    return rows, missing


def parse(lines):
    table = {}
    for line in lines:
        fields = line.split(",")
        key = (fields[0], fields[2], tuple(round(float(v), 9) for v in fields[3:6]))
        table[key] = (fields[1], [float(v) for v in fields[6:]])
    return table


def main():
    rows, missing = collect(sys.argv[1])
    if "--write" in sys.argv:
        if missing:
            sys.exit("cannot write: missing " + ", ".join(missing))
        with open(GOLDEN, "w", encoding="utf-8") as f:
            f.write("# convention,what printed it,kind,direction x,y,z,values: of a unit impulse from that direction\n")
            f.write("\n".join(rows) + "\n")
        print(f"{len(rows)} rows written")
        return
    stored, fresh = parse([r for r in open(GOLDEN, encoding="utf-8").read().splitlines() if not r.startswith("#")]), parse(rows)
    bad = 0
    for key, (source, values) in stored.items():
        if key[0] in missing:
            continue
        if key not in fresh:
            print("gone:", key, source)
            bad += 1
            continue
        worst = max(abs(a - b) for a, b in zip(values, fresh[key][1])) if len(values) == len(fresh[key][1]) else 1
        if not worst <= 4e-15 * max(1, max(abs(v) for v in values)):
            print("differs:", key, source, "now", fresh[key][0], worst)
            bad += 1
    for name in missing:
        print("SKIP", name, "is not installed here: its stored rows stand unverified in this run")
    print(f"{len(stored)} golden rows, {len(fresh)} printed now, {bad} wrong")
    sys.exit(bad != 0)


main()
