#!/usr/bin/env python3
"""Hostile models under limits: whatever a model does, scc keeps its limits and gives its report.

    test/limits/hostile.py SCC [--seconds S] [--memory MIB] [--addresses MIB] [--only TEXT] [--signal] [--loose]

Runs `scc check --json --seconds S --memory MIB` on models that grow: in numbers, states, formulas, bodies, faces. With
--signal there is no limit of seconds, and the program is interrupted after S seconds of the processor instead. With --addresses it is the
system that limits what there is (ulimit -v), to so much more than the program needs to begin. Of each run: the report is
one whole JSON document with a verdict for every check, the exit code is a documented one; and, as a bar, it takes no more
than 2 s over the limit, and no more memory than a tenth and 64 MiB over it. How long it takes says little on a busy machine, and is not
judged with --loose. Prints a line each, and counts.
"""

import argparse
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'cli'))
import interrupt

CUBE = """shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
"""
SIDES = '{left, right, top, bottom, front, back}'


def law(text, checks='check c : always x(p) > -1\n', settings=''):
    return settings + CUBE + 'process p = Cube mass 1 velocity (3/7,1,-1/3) [nil]\nmotion p = (%s)\n%s' % (text, checks)


def walls(inner, settings='', checks='check c : always x(p0) < 1000\n'):
    """A closed box of six walls, with what is in it."""
    text = settings + CUBE
    for axis in range(3):
        for side, name in ((-1, 'low'), (1, 'high')):
            at, size = [0, 0, 0], [12, 12, 12]
            at[axis], size[axis] = 20 * side, 1
            text += 'fixed %s%d = Cube scaled (%d,%d,%d) at translate (%d,%d,%d)\n' % (name, axis, *size, *at)
    return text + inner + checks


def gas(n, behaviour='nil', spin='', definitions='', **more):
    inner = definitions
    for i in range(n):
        x, y, z = 3 * (i % 5) - 6, 3 * (i // 5 % 5) - 6, 3 * (i // 25 % 5) - 6
        v = ((7 * i) % 5 - 2, (3 * i) % 7 - 3, (5 * i) % 3 - 1)
        inner += 'process p%d = Cube mass %d velocity (%d,%d/3,%d/7) %s at translate (%d,%d,%d) [%s]\n' % (
            i, 1 + i % 3, *v, spin and 'spin ' + spin, x, y, z, behaviour)
    return walls(inner, **more)


def nested(n, settings=''):
    checks = ''
    for i in range(n):
        checks += 'check n%d : AG (x(p) > %d => AF (x(p) < %d and EG (y(p) > -%d => EF z(p) < %d)))\n' % (i, i, -i, i + 1, i)
    return settings + """motion p = (if x > 5 then 0 - 1 else if x < -5 then 1 else if vx = 0 then 1 else vx, 0 - vy / 2, vz)
""" + CUBE + 'process p = Cube mass 1 velocity (3/7,1,0) [nil]\n' + checks


STICKY = 'behaviour B on Cube = <a, %s>. C + <~a, %s>. C + omega(a, %s). B\nbehaviour C on Cube = omega(a, %s). B + eps(1/3). C\n' % (
    SIDES, SIDES, SIDES, SIDES)
SPINS = 'dynamics constant_spin\n'
FREE = 'dynamics free_body\n'
ROUND = 'round orientation 2^-20\nround velocity 2^-20\n'

MODELS = {
    'square': law('vx*vx*2, 0, 0'),
    'cube': law('vx*vx*vx+1/3, vy, vz'),
    'power-16': law('*'.join(['vx'] * 16) + ' + 1/7, 0, 0'),
    'power-200': law('*'.join(['(vx+1/3)'] * 200) + ', 0, 0'),
    'quotient': law('vx/(vy+1/3), vy/(vx+2/7), 1/(vz+1/5)'),
    'mixed': law('vx*vy+1/3, vy*vz-1/5, vz*vx+1/7'),
    'harmonic': law('vx+1/(x*x+1), vy+1/(y*y+2), vz'),
    'position': law('x*x+1/3, y*x+1/7, z*y'),
    'time': law('time*time*vx/7+1/3, time/3, vz/(time+1)'),
    'by-dt': law('vx*dt/3+1/7, vy*dt*dt+1/11, vz', settings='timestep 1/97\n'),
    'fine-steps': law('vx+dt/3, vy, vz', settings='timestep 1/100000000\n'),
    'no-end': law('0-vx, 0-vy*2/3, vz/7', checks='check c : AF x(p) > 100\ncheck d : AG AF AG x(p) < 5\n'),
    'gas-5': gas(5),
    'gas-40': gas(40),
    'gas-100': gas(100),
    'gas-orders': gas(30, checks='check c : AG AF x(p0) < 0\n'),
    'sticky-6': gas(6, behaviour='B', definitions=STICKY),
    'sticky-20': gas(20, behaviour='B', definitions=STICKY),
    'sticky-nested': gas(6, behaviour='B', definitions=STICKY, checks='check c : AG (x(p0) > 0 => AF x(p0) < 0)\n'),
    'sticky-fine': gas(6, behaviour='B', definitions=STICKY, settings='split_step 1/1000\n'),
    'spin-2': gas(2, spin='(1/3,1/5,1)', settings=SPINS),
    'spin-5': gas(5, spin='(1/3,1/5,1)', settings=SPINS),
    'spin-20': gas(20, spin='(1/3,1/5,1)', settings=SPINS),
    'spin-round': gas(8, spin='(1/3,1/5,1)', settings=SPINS + ROUND),
    'spin-fast': gas(3, spin='(1000,333/7,1)', settings=SPINS),
    'spin-fine': gas(3, spin='(1/3,1/5,1)', settings=SPINS + 'resolution 1/10000000000000\n'),
    'spin-sticky': gas(5, behaviour='B', definitions=STICKY, spin='(1/3,1/5,1)', settings=SPINS),
    'free-3': gas(3, spin='(1/3,1/5,1)', settings=FREE),
    'free-round': gas(8, spin='(1/3,1/5,1)', settings=FREE + ROUND),
    'together': gas(30, settings='collisions together\n'),
    'contact': gas(12, behaviour='B', definitions=STICKY, settings='binding contact\n'),
    'nested-1': nested(1),
    'nested-6': nested(6),
    'nested-30': nested(30),
    'nested-fine': nested(6, settings='timestep 1/1000\n'),
    'degree-150': gas(2, checks='check c : always %s < 1\n' % '*'.join(['x(p0)'] * 150)),
    'degree-many': gas(3, checks='check c : AG (%s)\n' % ' or '.join('%s < %d' % ('*'.join(['x(p%d)' % (i % 3)] * (20 + i)), i) for i in range(40))),
    'distances': gas(20, checks='check c : AG (%s)\n' % ' and '.join('distance2(p%d, p%d) > 0' % (i, j) for i in range(20) for j in range(i))),
    'touching': gas(20, checks='check c : AG (%s)\n' % ' or '.join('touching(p%d, p%d)' % (i, j) for i in range(20) for j in range(i))),
    'touching-spin': gas(5, spin='(1/3,1/5,1)', settings=SPINS, checks='check c : AG (%s)\n' % ' or '.join('touching(p%d, p%d)' % (i, j) for i in range(5) for j in range(i))),
    'energy': gas(30, checks='check c : always energy > 0 and momentum.x*momentum.y < 100000000\n'),
    'long-start': law('vx, vy, vz', checks='check c : always x(p) > -1 within 1000000\n').replace('3/7', '1/3' + '0' * 900),
    'deep': gas(4, checks='check c : %sx(p0) > 0%s\n' % ('AG (EF (' * 40, '))' * 40)),
    'until': gas(5, checks='check c : A[x(p0) < 5 U E[x(p1) > -5 U A[y(p2) < 4 U z(p3) > 0]]]\n'),
    'bounded': gas(5, checks=''.join('check c%d : AG[%d,%d] EF[1,%d] x(p0) > %d\n' % (i, i, i + 40, i + 9, i % 5) for i in range(12))),
    'time-seen': gas(4, checks='check c : AG (time > 100000 => AF x(p0) < 0)\ncheck d : eventually time = 99999999\n'),
    'crowd-free': CUBE + ''.join('process p%d = Cube mass 1 velocity (%d,%d,0) at translate (%d,%d,0) [nil]\n' % (i, 1 - i % 3, 1 - i % 2, 3 * (i % 30), 3 * (i // 30)) for i in range(900)) + 'check c : always x(p0) < 1000\ncheck d : AG x(p7) < 10000\n',
    'ticks': gas(8, behaviour='T', definitions='behaviour T on Cube = eps(1/97). V\nbehaviour V on Cube = eps(1/89). T\n', checks='check c : AG AF x(p0) < 0\n'),
    'sums': gas(6, behaviour='S', definitions='behaviour S on Cube = %s\n' % ' + '.join('eps(%d/97). S' % i for i in range(1, 60))),
    'rattle': CUBE + 'fixed w = Cube at translate (-3,0,0)\nfixed e = Cube at translate (3,0,0)\n' + ''.join(
        'process p%d = Cube scaled (1/%d,1/9,1/9) mass %d velocity (%d,0,0) at translate (%d/16,0,0) [nil]\n' % (i, 40 + i, 1 + i, 1000 * (1 - 2 * (i % 2)) + i, 3 * i - 12) for i in range(8)) + 'check c : AG AF x(p0) > 0\n',
}


def with_addresses(mib):
    """What a process does first: it has so many MiB of addresses."""
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (mib * 2**20, mib * 2**20))


def least_addresses(scc):
    """The MiB that it takes to begin: other versions of OCaml set much aside."""
    for mib in range(16, 4096, 4):
        if subprocess.run([scc, '--version'], capture_output=True, preexec_fn=with_addresses(mib)).returncode == 0:
            return mib
    return 4096


def limited(args, name):
    command = [args.scc, 'check', '--json']
    if not args.addresses:
        command += ['--memory', str(args.memory)]
    if not args.signal:
        command += ['--seconds', str(args.seconds)]
    return command + ['--states', '100000000', name]


def faults_of(args, text, code, output, took, peak):
    found = []
    if code not in (0, 1, 2, 4):
        found.append('exit code %d' % code)
    try:
        report = json.loads(output)
        told = [p['name'] for p in report['properties']]
        asked = [line.split()[1] for line in text.split('\n') if line.startswith('check ')]
        if told != asked:
            found.append('verdicts for %s' % told)
    except (ValueError, KeyError) as e:
        found.append('no report: %s' % e)
    if not args.loose and took > args.seconds + 2:
        found.append('%.1f s' % took)
    if peak > args.memory * 1.1 + 64:
        found.append('%d MiB' % peak)
    return found


def interrupted(process, seconds):
    """When it has an answer to that, and has worked so many seconds of the processor."""
    try:
        while not (interrupt.answers(process.pid) and interrupt.worked(process.pid) >= seconds):
            time.sleep(0.01)
        os.kill(process.pid, signal.SIGINT)
    except (OSError, StopIteration):
        pass  # it has ended by itself


def run(args, name, text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name + '.sc')
        with open(path, 'w') as f:
            f.write(text)
        start = time.monotonic()
        process = subprocess.Popen(
            limited(args, path), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            preexec_fn=with_addresses(args.addresses) if args.addresses else None,
        )
        stopper = threading.Thread(target=lambda: interrupted(process, args.seconds))
        if args.signal:
            stopper.start()
        chunks = []
        reader = threading.Thread(target=lambda: chunks.append(process.stdout.read()))
        complaints = threading.Thread(target=lambda: chunks.append(None) or process.stderr.read())
        reader.start()
        complaints.start()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if args.signal:
            stopper.join()
        reader.join()
        complaints.join()
        took = time.monotonic() - start
        output = b''.join(c for c in chunks if c)
        return faults_of(args, text, process.returncode, output, took, usage.ru_maxrss / 1024), took, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('scc')
    parser.add_argument('--seconds', type=float, default=5)
    parser.add_argument('--memory', type=int, default=300)
    parser.add_argument('--addresses', type=int, default=0)
    parser.add_argument('--only', default='')
    parser.add_argument('--signal', action='store_true')
    parser.add_argument('--loose', action='store_true')
    args = parser.parse_args()
    if args.addresses:
        args.addresses += least_addresses(args.scc)
    passed = failed = 0
    for name, text in MODELS.items():
        if args.only not in name:
            continue
        faults, took, peak = run(args, name, 'model hostile\n' + text)
        print('%s %-14s %5.1f s %4d MiB %s' % ('FAIL' if faults else 'ok  ', name, took, peak, '; '.join(faults)), flush=True)
        if faults:
            failed += 1
        else:
            passed += 1
    print('%d passed, %d failed' % (passed, failed))
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
