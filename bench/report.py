#!/usr/bin/env python3
"""Writes docs/performance.md (to standard output) from the benchmark's CSVs.

    python3 bench/report.py MAIN.csv [OTHER.csv ...] > docs/performance.md

MAIN.csv comes from `make bench` and fills the tables; the others, from `make bench-quick` with another compiler or
other flags, fill further columns of the table of targets. Beside each CSV lie FILE.machine and FILE.targets.
"""
import csv
import os
import sys

# M22 Table 2, "Ours rev.", ms for 8^3 nodes and 648 lights, 5..9 bands, RTX 2080
RTX2080 = [2.22, 2.96, 3.77, 4.76, 5.18]


class Run:
    """One CSV with what lies beside it."""

    def __init__(self, path):
        self.rows = {}
        with open(path) as f:
            for r in csv.DictReader(f):
                key = (r['suite'], r['kernel'], r['impl'], r['precision'], int(r['bands']), int(r['items']))
                self.rows[key] = float(r['ns_min'])
        self.machine = dict(line.rstrip('\n').split(': ', 1) for line in open(path + '.machine'))
        self.targets = []
        if os.path.exists(path + '.targets'):
            self.targets = [line.rstrip('\n').split('\t') for line in open(path + '.targets')]

    def columns(self, suite, kernel, precision, by=4):
        return sorted({k[by] for k in self.rows if k[:2] == (suite, kernel) and k[3] == precision})

    def impls(self, suite, kernel, precision):
        seen = []
        for k in self.rows:
            if k[:2] == (suite, kernel) and k[3] == precision and k[2] not in seen:
                seen.append(k[2])
        return seen

    def value(self, suite, kernel, impl, precision, column, by=4):
        for k, v in self.rows.items():
            if k[:4] == (suite, kernel, impl, precision) and k[by] == column:
                return v
        return None

    def label(self):
        return '%s, `%s`, %s' % (self.machine['compiler'], self.machine['flags'], self.machine['isa'])


def number(x):
    if x is None:
        return '–'
    return '%.0f' % x if x >= 1000 else '%.3g' % x


def table(run, suite, kernel, base=None, precision='f32', by=4, scale=1.0):
    """Markdown table: impls down, bands (or items) across, the ratio to base in brackets."""
    columns = run.columns(suite, kernel, precision, by)
    if not columns:
        return
    print('| %s | %s |' % (kernel, ' | '.join(str(c) for c in columns)))
    print('|---|' + '--:|' * len(columns))
    for impl in run.impls(suite, kernel, precision):
        cells = []
        for c in columns:
            v = run.value(suite, kernel, impl, precision, c, by)
            b = run.value(suite, kernel, base, precision, c, by) if base else None
            text = number(v * scale if v is not None else None)
            if v and b and impl != base:
                text += ' (%.1f×)' % (b / v)
            cells.append(text)
        print('| `%s` | %s |' % (impl, ' | '.join(cells)))
    print()


def floors(run, suite, precision='f32'):
    f = lambda impl: run.value(suite, 'floor', impl, precision, 0)
    fma, store, dram = f('fma'), f('l1_store'), f('dram_store')
    text = 'Floor in the same run: %.0f GFLOP/s, %.0f GB/s stored into L1' % (1 / fma, 1 / store)
    print(text + (', %.0f GB/s into memory.' % (1 / dram) if dram else '.') + '\n')


def store_fraction(run, precision='f32'):
    """How much of the L1 store bandwidth the blocked basis reaches."""
    size = 4 if precision == 'f32' else 8
    print('Fraction of the L1 store bandwidth (bytes written / time / floor), blocked layout:\n')
    columns = run.columns('basis', 'values', precision)
    store = run.value('basis', 'floor', 'l1_store', precision, 0)
    print('| kernel | %s |' % ' | '.join(str(c) for c in columns))
    print('|---|' + '--:|' * len(columns))
    for kernel, planes in (('values', 1), ('gradient', 4), ('hessian', 10)):
        cells = ['%.0f %%' % (100 * planes * n * n * size * store /
                              run.value('basis', kernel, 'library_blocks', precision, n)) for n in columns]
        print('| %s | %s |' % (kernel, ' | '.join(cells)))
    print()


def targets(runs):
    runs = [r for r in runs if r.targets]
    if not runs:
        return
    print('| | bands | target | %s |' % ' | '.join(r.label() for r in runs))
    print('|---|--:|--:|' + '--:|' * len(runs))
    for what, bands, goal, _, _ in runs[0].targets:
        cells = []
        for r in runs:
            hit = [t for t in r.targets if t[0] == what and t[1] == bands]
            cells.append('%s%s' % (hit[0][3], '' if hit[0][4] == 'yes' else ' (missed)') if hit else '–')
        print('| %s | %s | %s | %s |' % (what, bands, goal.replace('>=', '≥').replace('<=', '≤'), ' | '.join(cells)))
    print()


def span(run, suite, kernel, impl, base, precision='f32'):
    """'0.9-1.1': how many times the base's time an impl takes, over the bands."""
    ratios = [run.value(suite, kernel, impl, precision, n) / run.value(suite, kernel, base, precision, n)
              for n in run.columns(suite, kernel, precision)]
    return '%.2f–%.2f' % (min(ratios), max(ratios))


def heading(text):
    print('## %s\n' % text)


def main(paths):
    runs = [Run(p) for p in paths if os.path.exists(p)]
    main_run = runs[0]
    m = main_run.machine
    print('# Performance\n')
    print('Generated by bench/report.py (`make performance-doc`) from the CSVs of `make bench` or `make bench-quick`; do not edit.\n')
    print('%s, one core unless said otherwise; %s.\n' % (m['cpu'], main_run.label()))
    print('Times are minima of many rounds in which all cases of a suite take turns, in ns per item; in brackets how many '
          'times faster than the base of that table. Ratios within a table hold on other machines of the kind, times '
          'drift. `library` is one call per item (or the fused call), `library_n` a batch in the plain layout, '
          '`library_blocks` in the blocked one. The other rows are the forms people know, written as scalar code as fast '
          'as their form allows and compared with the library before they are timed; `_auto` is the same source with the '
          "compiler's vectoriser let loose.\n")
    heading('Targets')
    print('What the project set out to reach, float, and what was measured.\n')
    targets(runs)

    heading('Basis (M22 Table 1)')
    floors(main_run, 'basis')
    for kernel, base in (('values', 'sloan'), ('gradient', 'sloan_like'), ('angles', 'sloan_like'), ('hessian', 'polynomial'),
                         ('reconstruct', 'sloan'), ('project', 'sloan')):
        table(main_run, 'basis', kernel, base)
    print('M22 finds its "Sloan\'s like" form faster than its "Direct" one and both faster than polynomials, by up to three '
          'times. Here, all three written with the same care, `direct` takes %s and `polynomial` %s times as long as '
          '`sloan_like`: the order of the three is a matter of the compiler.\n'
          % (span(main_run, 'basis', 'gradient', 'direct', 'sloan_like'),
             span(main_run, 'basis', 'gradient', 'polynomial', 'sloan_like')))
    store_fraction(main_run)
    if main_run.columns('basis', 'values', 'f64'):
        print('In double, where GSL and Boost can be compared:\n')
        table(main_run, 'basis', 'values', 'sloan', 'f64')
        table(main_run, 'basis', 'angles', 'sloan_like', 'f64')
        table(main_run, 'basis', 'gradient', 'sloan_like', 'f64')

    print('Inner loops were looked at with `make bench-loops` (bench/loops.py over objdump): instructions, FMAs, loads from and '
          'stores to the stack per loop.\n')

    if main_run.columns('stream', 'values', 'f32'):
        heading('Arrays')
        print('5 bands written to an array, by the number of directions: in L2, and beyond every cache. The fused calls '
              'store no basis.\n')
        floors(main_run, 'stream')
        for kernel, base in (('values', 'sloan'), ('gradient', None), ('reconstruct', None), ('project', None)):
            table(main_run, 'stream', kernel, base, by=5)

    heading('Sphere lights (M22 Table 2, Fig. 10, 13, 14)')
    print('648 lights at one point, ns per light:\n')
    floors(main_run, 'lights')
    for kernel in ('values', 'gradient', 'hessian'):
        table(main_run, 'lights', kernel, 'per_light')
    print('8×8×8 nodes, 648 lights, ms for the grid; M22 prints the last row for coefficients and gradients on an RTX 2080:\n')
    for kernel in ('values', 'gradient', 'hessian'):
        table(main_run, 'grid', kernel, 'per_light', scale=512e-6)
        if kernel == 'gradient':
            print('RTX 2080 (M22 Table 2, 5–9 bands): %s ms.\n' % ', '.join('%.2f' % t for t in RTX2080))
    for suite, what in (('grid_lights', 'lights'), ('grid_nodes', 'nodes')):
        for kernel in ('values', 'gradient'):
            columns = main_run.columns(suite, kernel, 'f32', 5)
            if not columns:
                continue
            print('%s at 5 bands by the number of %s, ms:\n' % (kernel.capitalize(), what))
            print('| %s | %s |' % (what, ' | '.join(str(c) for c in columns)))
            print('|---|' + '--:|' * len(columns))
            for impl in main_run.impls(suite, kernel, 'f32'):
                cells = [number(main_run.value(suite, kernel, impl, 'f32', c, 5) * c * 1e-6) for c in columns]
                print('| `%s` | %s |' % (impl, ' | '.join(cells)))
            print()

    heading('Polygons (WR18 Table 2)')
    print('One polygon seen from many points, ns per point. `library`: many points per call; `library_one`: one point '
          "per call, in double inside; `library_zonal`: WR18's route in its robust form, in double inside; `edge_frame`: "
          "the closed form in each edge's frame, scalar, and in the library's lanes.\n")
    print('WR18 reports its recurrence two to four times faster than monomials, on a GPU. On a CPU monomials written with '
          'equal care take %s times as long for values and %s for gradients of a triangle: they need fewer operations per '
          'edge and degree, which pays for combining them. What they lose is accuracy: in float every digit beyond nine '
          'bands.\n' % (span(main_run, 'polygon', 'values', 'monomial', 'wang_ramamoorthi'),
                        span(main_run, 'polygon', 'gradient', 'monomial', 'wang_ramamoorthi')))
    for suite, sides in (('polygon', 3), ('polygon4', 4), ('polygon8', 8)):
        if main_run.columns(suite, 'values', 'f32'):
            print('%d sides:\n' % sides)
            for kernel in ('values', 'gradient'):
                table(main_run, suite, kernel, 'wang_ramamoorthi')

    heading('Clamped-cosine products (MP21 Table 2)')
    print('`triple`, `zonal`, `zonal3`: MP21 Eq. 5 and 10 as sums over Gaunt coefficients; `world`: Eq. 11; '
          '`world_rotated`: with rotation to the normal and back. ns per vector.\n')
    table(main_run, 'product', 'clamped_cosine', 'triple')

    heading('Interpolation (M22 Table 5)')
    print('8×8×8 nodes, 3 channels, scattered points, ns per point. `library_dot`: interpolate, then a dot product with a '
          'transfer vector; `fused`: both in one call.\n')
    for kernel in ('trilinear', 'half_taylor', 'blended_taylor', 'hermite_zero', 'hermite_mixed', 'edge_hermite',
                   'blended_taylor2'):
        table(main_run, 'interp', kernel)


if len(sys.argv) < 2:
    sys.exit(__doc__)
main(sys.argv[1:])
