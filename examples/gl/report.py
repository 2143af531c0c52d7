#!/usr/bin/env python3
"""Writes docs/gl.md (to standard output) from gl-bench's CSVs: report.py [--note TEXT] FILE.csv ... > docs/gl.md

A row of a later file replaces the same row of an earlier one; each renderer gets tables of its own."""
import csv
import sys

args = sys.argv[1:]
note = args[1] if args[:1] == ['--note'] else ''
rows = {}
for path in args[2:] if note else args:
    with open(path) as f:
        for r in csv.DictReader(f):
            key = r['renderer'], int(r['table']), int(r['lights']), r['kind'], r['what'], int(r['bands'])
            rows[key] = r


def ms(r):
    v = float(r['ms'])
    return '%.0f' % v if v >= 100 else '%.1f' % v if v >= 10 else '%.2f' % v


def cell(key):
    r = rows.get(key)
    if not r:
        return '–'
    return ms(r) + (' (%s)' % r['m22_rtx2080_ms'] if r['m22_rtx2080_ms'] else '')


def table(head, lines):
    print('| ' + ' | '.join(head) + ' |')
    print('|---|' + '--:|' * (len(head) - 1))
    for line in lines:
        print('| ' + ' | '.join(line) + ' |')
    print()


print('''# The GPU path, measured

Written by examples/gl/report.py from the CSV of `make gl-bench`; do not edit. Milliseconds; in brackets what Mézières
et al. 2022 (M22) print for an RTX 2080, where the work is the same. A software renderer is no GPU: its columns say how
the forms compare there, and nothing about a graphics card.
''')
if note:
    print(note + '\n')
for renderer in sorted({k[0] for k in rows}):
    mine = [k for k in rows if k[0] == renderer]
    some = rows[mine[0]]
    print('## %s\n\nTimed by the %s, %s^3 nodes.\n' % (renderer, some['clock'], some['nodes']))
    grids = [k for k in mine if k[1] == 2]
    if grids:
        bands = sorted({k[5] for k in grids})
        print('The grid with gradients, %d lights, by bands (M22 Table 2; its polygons are Wu et al. 2020).\n'
              '`moments` is the form of this library, `forward` and `reverse` are M22\'s loops, `exact` integrates along edges.\n'
              % grids[0][2])
        kinds = []
        for k in grids:
            if k[3:5] not in kinds:
                kinds.append(k[3:5])
        table(['lights, form'] + [str(b) for b in bands],
              [['%s, %s' % (kind.replace('_', ' '), form)]
               + [cell((renderer, 2, grids[0][2], kind, form, b)) for b in bands] for kind, form in kinds])
    whats = ['coefficients', 'gradients', 'edge_hermite', 'occlusion', 'per_pixel']
    for number, by, text in ((3, 2, 'A frame by lights, 5 bands (M22 Table 3)'), (5, 5, 'A frame by bands (M22 Table 5)')):
        frames = [k for k in mine if k[1] == number]
        if not frames:
            continue
        print('%s, %s pixels: the grid without and with gradients, edge Hermite with\n'
              'shading, occlusion, and every light at every pixel.\n' % (text, rows[frames[0]]['size']))
        lines = []
        for v in sorted({k[by] for k in frames}):
            lights, b = (v, frames[0][5]) if by == 2 else (frames[0][2], v)
            lines.append([str(v)] + [cell((renderer, number, lights, 'spheres', w, b)) for w in whats])
        table(['lights' if by == 2 else 'bands'] + [w.replace('_', ' ') for w in whats], lines)
