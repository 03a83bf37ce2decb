#!/usr/bin/env python3
"""How effort grows with models: linearly, or nearly so.

    test/limits/growth.py EFFORT [--only TEXT] [--size N] [--ratios]

Runs EFFORT (effort.ml: the program, which tells in the end how many words it has allocated) on models of three sizes, N,
2 N and 4 N. Of what is linear the second difference is twice the first, of what is quadratic four times, of what is cubic
eight times; more than 3 times is a failure, and more than 5.5 where each state has, or tells, all bodies or all that is
left of a term, or where the pieces of a set are compared in pairs. The count is the same on every run, and knows no clock. What only looks through a list or an array allocates
nothing, and is not seen. Prints a line for each case that fails, and counts.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile

LINEAR, QUADRATIC = 3, 5.5
CUBE = 'shape C = box(1,1,1)\n'
DEEP = ['check', '--jobs', '1', '--depth', '1000000', '--states', '1000000']


def bouncing(formula, more=''):
    """A body between two walls, whose start is not known: a zone for each bounce and each flight."""
    return f'''param u in [0, 1]
param v in [0, 1]
{CUBE}process p = C mass 1 velocity (1,0,0) at translate (u + 2,0,0) [nil]
fixed hi = C at translate (8,0,0)
fixed lo = C at translate (0,0,0)
{more}check c : {formula}
'''


OTHER = '''process q = C mass 1 velocity (1,0,0) at translate (v + 2,10,0) [nil]
fixed hi2 = C at translate (8,10,0)
fixed lo2 = C at translate (0,10,0)
'''


def ageing(formula):
    return f'''param u in [1, 2]
timestep 1
{CUBE}behaviour K on C = eps(u). K
process p = C mass 1 velocity (1,0,0) [K]
check c : {formula}
'''


def walking(n, check):
    return f'''timestep 1 steady
process p = box(1/4,1/4,1/4) mass 1 [nil]
fixed hi = box(1/4,1/4,1/4) absorb at translate (4 + 1/4,0,0)
motion p = choose {{ (1,0,0) weight 1, (0,0,0) weight 1 }}
''' + ''.join(f'check c{i} : {check(i)}\n' for i in range(n))


def family(n, formula):
    return f'''{CUBE}for i in 0..{n - 1} {{ process q[i] = C mass 1 velocity (1,0,0) at translate (3*i,0,0) [nil] }}
check c : {formula}
'''


def passing(n):
    """A body that goes faster and faster past many others."""
    bodies = ''.join(f'process p{i} = C mass 1 at translate ({5 * i},9,0) [nil]\n' for i in range(n))
    return f'timestep 1\n{CUBE}{bodies}process q = C mass 1 [nil]\nmotion q = (vx + dt, vy, vz)\ncheck c : possibly bound(p0, p1)\n'


def prefixes(n):
    return f'{CUBE}behaviour B on C = {"eps(1). " * n}nil\nprocess p = C mass 1 [B]\ncheck c : always x(p) < 5\n'


def intervals(n):
    """A set of n intervals of the parameter."""
    parts = ' or '.join(f'(x(p) > {2 * i}/{2 * n} and x(p) < {2 * i + 1}/{2 * n})' for i in range(n))
    return f'param u in [0, 1]\n{CUBE}process p = C mass 1 at translate (u,0,0) [nil]\ncheck c : possibly ({parts})\n'


def groups(n):
    """n groups of two pairs that collide at one instant, of which nobody asks (rule Order)."""
    pairs = ''.join(f'process p{i}{j} = C mass 1 velocity (1,0,0) at translate (0,{9 * i + j},0) [nil]\n'
                    f'process q{i}{j} = C mass 1 velocity (-1,0,0) at translate (4,{9 * i + j},0) [nil]\n'
                    for i in range(n) for j in (0, 1))
    seen = "process r = C mass 1 velocity (0,0,1) at translate (0,-9,0) [nil]\n"
    return f"{CUBE}{pairs}{seen}check c : possibly x(r) > 1\n"


def crowd(n):
    """n bodies that walk at random, of which each draws at each step."""
    return f'''timestep 1 steady
{CUBE}for i in 1..{n} {{ process p[i] = C mass 1 at translate (0, 3*i, 0) [nil] }}
motion p = choose {{ (1,0,0), (-1,0,0) }}
check c : always count(q in p : x(q) > 9) = 0
'''


TRACE = 'run.jsonl'  # where it is among the arguments, a trace of four steps of the crowd is written there before

# What is run on a model of a size: name, N, arguments, the model.
CASES = [
    ('zones possibly', 50, DEEP, lambda n: bouncing(f'possibly (time > {3 * n} and x(p) < 3)')),
    ('zones always', 50, DEEP, lambda n: bouncing(f'always time < {3 * n}')),
    ('zones two bodies', 25, DEEP, lambda n: bouncing(f'possibly (time > {3 * n} and x(p) + x(q) < 6)', OTHER)),
    ('zones EG', 50, DEEP, lambda n: bouncing(f'EG[0, {3 * n}] x(p) < 100')),
    ('zones EG two bodies', 12, DEEP, lambda n: bouncing(f'EG[0, {3 * n}] x(p) < 100 + x(q)', OTHER)),
    ('zones AU', 50, DEEP, lambda n: bouncing(f'A[x(p) < 100 U[0, {3 * n}] time > {3 * n - 1}]')),
    ('zones --where', 50, DEEP + ['--where'], lambda n: bouncing(f'possibly (time > {3 * n} and x(p) < 3)')),
    ('where intervals', 20, DEEP + ['--where'], intervals),
    ('zones delays', 50, DEEP, lambda n: ageing(f'possibly x(p) > {n}')),
    ('checks AG EF', 100, DEEP, lambda n: walking(n, lambda i: f'AG EF (gone(p) or x(p) > {i})')),
    ('checks EG', 100, DEEP, lambda n: walking(n, lambda i: f'EG (gone(p) or x(p) < {i})')),
    ('checks alike', 200, DEEP, lambda n: walking(n, lambda i: 'AG EF gone(p)')),
    ('checks leads_to', 100, DEEP, lambda n: walking(n, lambda i: f'gone(p) leads_to gone(p) within {i}')),
    ('checks always', 100, DEEP, lambda n: walking(n, lambda i: f'always (gone(p) or x(p) < {i})')),
    ('count', 100, DEEP, lambda n: family(n, 'always count(p in q : x(p) < 0) = 0')),
    ('count in time', 100, DEEP, lambda n: family(n, f'eventually count(p in q : x(p) > {3 * n}) = {n} within 10')),
    ('forall', 100, DEEP, lambda n: family(n, 'always forall p in q : x(p) >= 0')),
    ('bodies that a report looks at', 100, ['check', '--jobs', '1', '--states', '20'], passing),
    ('collisions of one instant', 20, ['check', '--jobs', '1', '--states', '100000'], groups),
    ('prefixes check', 200, DEEP, prefixes),
    ('prefixes json', 200, DEEP + ['--json'], prefixes),
    ('prefixes trace', 200, ['trace', '-o', os.devnull], prefixes),
    ('prefixes explore', 200, ['explore', '--format', 'json', '-o', os.devnull], prefixes),
    ('prefixes view', 200, ['view', '--data', '-o', os.devnull], prefixes),
    ('crowd view', 110, ['view', '--data', '-o', os.devnull, '--trace', TRACE], crowd),
    ('prefixes fmt', 500, ['fmt'], prefixes),
    ('prefixes xml', 500, ['translate', '-o', os.devnull, '--to', 'xml'], prefixes),
]


MAY_BE_QUADRATIC = ['where intervals', 'collisions of one instant', 'prefixes check', 'prefixes json', 'prefixes trace',
                    'prefixes explore', 'prefixes view']
UNDECIDED = ['bodies that a report looks at']  # these meet a bound; all others are decided


def words(effort, arguments, text, folder, codes):
    path = os.path.join(folder, 'model.sc')
    with open(path, 'w') as out:
        out.write(text)
    if TRACE in arguments:
        trace = [effort, 'trace', '--time', '4', '--choose', 'random:1', '--states', 'ends', '-o', TRACE, path]
        subprocess.run(trace, capture_output=True, timeout=300, cwd=folder)
    done = subprocess.run([effort] + arguments + [path], capture_output=True, timeout=300, cwd=folder)
    told = re.search(rb'^(\d+) words$', done.stderr, re.M)
    if done.returncode not in codes or not told:
        return None, f'exit code {done.returncode}: {(done.stderr + done.stdout).decode(errors="replace")[:300]}'
    return int(told[1]), None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('effort')
    parser.add_argument('--only', default='')
    parser.add_argument('--size', type=int, default=0, help='N of all cases')
    parser.add_argument('--ratios', action='store_true', help='a line for each case')
    given = parser.parse_args()
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, size, arguments, model in CASES:
            if given.only not in name:
                continue
            size = given.size or size
            codes = (2,) if name in UNDECIDED else (0, 1)
            found = [words(os.path.abspath(given.effort), arguments, model(size * k), folder, codes) for k in (1, 2, 4)]
            wrong = [why for _, why in found if why]
            if wrong:
                ratio, line = None, f'{name}: {wrong[0]}'
            else:
                small, middle, large = (count for count, _ in found)
                ratio = (large - middle) / max(1, middle - small)
                line = f'{name}: {small}, {middle}, {large} words at {size}, {2 * size}, {4 * size}: {ratio:.2f} times'
            good = ratio is not None and ratio <= (QUADRATIC if name in MAY_BE_QUADRATIC else LINEAR)
            passed, failed = passed + good, failed + (not good)
            if given.ratios or not good:
                print(line, flush=True)
    print(f'{passed} passed, {failed} failed')
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
