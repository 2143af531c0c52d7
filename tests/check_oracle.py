#!/usr/bin/env python3
"""sh-oracle against mpmath: awkward random queries, every answer to the bound the library documents.

    check_oracle.py ORACLE [--queries N] [--bands few|all|N] [--seed S] [--function NAME] [--convention NAME]

check_oracle_reference.py has the mathematics, _lights and _products the queries and exact answers per function,
_conventions the other systems, _text the behaviour on bad input; polygons have a check of their own. Inputs are
rounded to the precision under test first, so both sides get the same numbers. Prints the worst error per function
and precision in units of the bound; exits 1 if one passes 1."""
import argparse
import random
import subprocess
import sys
from mpmath import mpf
import check_oracle_conventions
import check_oracle_lights
import check_oracle_products
import check_oracle_text
from check_oracle_reference import EPS

FUNCTIONS = dict(check_oracle_lights.FUNCTIONS, **check_oracle_products.FUNCTIONS)
SIDES = ("both", "front", "signed")


def ask(options, function, bands, precision, queries, more=()):
    """The oracle's answers: one {component: [numbers]} per query."""
    whole = function == "cubemap"
    answers = []
    for group in [[q] for q in queries] if whole else [queries]:
        lines = [q[i:i + 9] for q in group for i in range(0, len(q), 9)] if whole else group
        text = "# queries\n\n" + "".join(",".join("%.17g" % t for t in line) + "\n" for line in lines)
        command = [options.oracle, function, "--bands", str(bands), "--precision", precision, *more]
        run = subprocess.run(command, input=text, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             universal_newlines=True)
        if run.returncode != 0:
            sys.exit(f"{' '.join(command)}: exit {run.returncode}\n{run.stderr[:500]}")
        rows = [line.split(",") for line in run.stdout.splitlines()]
        names = [row[0] for row in rows]
        per = len(rows) // len(group)
        if per * len(group) != len(rows) or names != names[:per] * len(group):
            sys.exit(f"{function}: answers and queries do not match")
        for i in range(0, len(rows), per):
            answers.append({row[0]: [float(t) for t in row[1:]] for row in rows[i:i + per]})
    return answers


class Worst:
    """The largest error of one component, in units of its bound."""

    def __init__(self):
        self.error, self.checks, self.where = mpf(0), 0, ""

    def check(self, got, want, eps, where):
        if len(got) != len(want):
            sys.exit(f"{where}: {len(got)} values, wanted {len(want)}")
        for i, (value, (exact, bound)) in enumerate(zip(got, want)):
            error = abs(mpf(value) - exact)
            error = error / (bound * eps) if error else error
            self.checks += 1
            if not error <= self.error:
                self.error, self.where = error, "[%d] %s" % (i, where)

    def report(self, name, component, precision):
        bad = not self.error <= 1
        print("%-18s %-12s %-4s %8d  %-7.3g %s" % (name, component, precision, self.checks, float(self.error),
                                                   "FAIL " + self.where if bad else self.where[:150]))
        return bad


def bands_to_try(options, most):
    if options.bands == "all":
        return range(1, most + 1)
    if options.bands == "few":
        return [n for n in (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 21, 32) if n <= most]
    return [min(int(options.bands), most)]


def check_function(options, rng, name):
    make, solve, most = FUNCTIONS[name]
    bad = 0
    for precision in ("f32", "f64"):
        worst = {}
        for bands in bands_to_try(options, most):
            options.sides = rng.choice(SIDES)
            asked, answers = [], []
            for _ in range(options.queries):
                q = make(rng, bands, precision)
                a = solve(q, bands, options)
                if a:
                    asked.append(q)
                    answers.append(a)
            if not asked:
                continue
            got_all = ask(options, name, bands, precision, asked, ["--sides", options.sides])
            for q, exact, got in zip(asked, answers, got_all):
                if list(got) != list(exact):
                    sys.exit(f"{name}: components {list(got)}, wanted {list(exact)}")
                where = "--bands %d --sides %s: %s" % (bands, options.sides, ",".join("%.17g" % t for t in q))
                for component, values in exact.items():
                    worst.setdefault(component, Worst()).check(got[component], values, EPS[precision], where)
        for component, w in worst.items():
            bad += w.report(name, component, precision)
    return bad


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("oracle")
    parser.add_argument("--queries", type=int, default=2, help="per function, precision and band count")
    parser.add_argument("--bands", default="few")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--function", choices=list(FUNCTIONS) + ["conventions", "text"])
    parser.add_argument("--convention")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    bad = 0
    print("%-18s %-12s %-4s %8s  %-7s worst at" % ("oracle", "", "", "checks", "/bound"))
    for name in FUNCTIONS:
        if options.function in (None, name) and not options.convention:
            bad += check_function(options, rng, name)
    if options.function in (None, "conventions"):
        bad += check_oracle_conventions.check(options, rng, ask, Worst)
    if options.function in (None, "text") and not options.convention:
        bad += check_oracle_text.check(options.oracle)
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
