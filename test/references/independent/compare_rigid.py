#!/usr/bin/env python3
"""Runs scc on random rigid models, and checks every transition with exact fractions: see rigid_trace.py.

The last line is `N passed, N failed`.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

from rigid import Difference
import rigid_models
from rigid_trace import Check


def run(scc, path, seed, steps, samples, seen):
    model = rigid_models.Model(seed)
    with open(path, 'w') as f:
        f.write(model.text())
    done = subprocess.run([scc, 'trace', path, '--choose', 'random:%d' % seed, '--steps', str(min(steps, model.steps))],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=20)
    if done.returncode not in (0, 2):
        raise Difference('exit code %d: %s' % (done.returncode, done.stderr.strip()[:600]))
    check = Check(model.bodies, model.timestep, model.the_resolution(), model.free, model.orientation,
                  model.velocity, samples)
    try:
        check.run(map(json.loads, done.stdout.splitlines()))
    finally:
        for kind, n in check.seen.items():
            seen[kind] = seen.get(kind, 0) + n


def main():
    if hasattr(sys, 'set_int_max_str_digits'):
        sys.set_int_max_str_digits(0)
    parser = argparse.ArgumentParser()
    parser.add_argument('--scc', required=True)
    parser.add_argument('--count', type=int, default=40)
    parser.add_argument('--seed', type=int, default=1, help='of the first model; the others follow')
    parser.add_argument('--steps', type=int, default=20, help='of a run, at most')
    parser.add_argument('--samples', type=int, default=4, help='instants between two states')
    options = parser.parse_args()
    passed, failed, seen = 0, 0, {}
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'model.sc')
        for seed in range(options.seed, options.seed + options.count):
            try:
                run(options.scc, path, seed, options.steps, options.samples, seen)
                passed += 1
            except subprocess.TimeoutExpired:  # numbers can grow without bound
                print('model %d: too slow' % seed, flush=True)
                seen['too slow'] = seen.get('too slow', 0) + 1
            except Difference as fault:
                failed += 1
                print('model %d: %s' % (seed, str(fault)[:1500]), flush=True)
    print('seen: %s' % ', '.join('%d %s' % (n, k) for k, n in sorted(seen.items())))
    print('%d passed, %d failed' % (passed, failed))
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
