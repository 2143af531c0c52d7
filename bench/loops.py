#!/usr/bin/env python3
"""Innermost loops of a function and what they do: the bench's way of looking for spills.

    objdump -d --no-show-raw-insn OBJECT | python3 bench/loops.py FUNCTION [MIN_STORES]

Per loop: instructions, vector arithmetic, loads from and stores to the stack (spills, if they are vectors), other
vector loads and stores. A loop is the code from a backward jump's target to the jump, with no such pair inside.
"""
import re
import sys


def functions(lines):
    name, body = None, []
    for line in lines:
        head = re.match(r'^[0-9a-f]+ <(.+)>:$', line)
        if head:
            if name:
                yield name, body
            name, body = head.group(1), []
        else:
            m = re.match(r'^\s*([0-9a-f]+):\s+(\S+)\s*(.*)$', line)
            if m:
                body.append((int(m.group(1), 16), m.group(2), m.group(3)))
    if name:
        yield name, body


def loops(body):
    """(first, last) indices of innermost loops."""
    index = {address: i for i, (address, _, _) in enumerate(body)}
    found = []
    for i, (_, op, args) in enumerate(body):
        target = re.match(r'^([0-9a-f]+)', args) if op.startswith('j') else None
        if target and int(target.group(1), 16) in index and index[int(target.group(1), 16)] <= i:
            found.append((index[int(target.group(1), 16)], i))
    return [f for f in found if not any(g != f and f[0] <= g[0] and g[1] <= f[1] for g in found)]


def describe(body):
    count = dict.fromkeys(('instructions', 'arithmetic', 'fma', 'spill stores', 'spill loads', 'stores', 'loads'), 0)
    for _, op, args in body:
        count['instructions'] += 1
        if not re.search(r'%[xyz]mm', args):
            continue
        if re.match(r'v?f?n?m(add|sub)', op) or op.startswith('vfn') or op.startswith('vfm'):
            count['fma'] += 1
        elif re.match(r'v?(add|sub|mul|div|sqrt|max|min|and|xor)', op):
            count['arithmetic'] += 1
        memory = re.search(r'(-?0x[0-9a-f]+)?\(%(\w+)', args)
        if not memory or memory.group(2) == 'rip':
            continue
        stack = memory.group(2) in ('rsp', 'rbp')
        store = op.startswith(('vmov', 'mov')) and args.rstrip().endswith(')')
        count[('spill ' if stack else '') + ('stores' if store else 'loads')] += 1
    return count


def main(wanted, least=0):
    for name, body in functions(sys.stdin):
        if wanted not in name:
            continue
        for first, last in loops(body):
            c = describe(body[first:last + 1])
            if c['stores'] + c['fma'] < least:
                continue
            text = ', '.join('%d %s' % (v, k) for k, v in c.items() if v)
            print('%s+%x: %s' % (name, body[first][0] - body[0][0], text))


if len(sys.argv) < 2:
    sys.exit(__doc__)
main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1)
