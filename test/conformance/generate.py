#!/usr/bin/env python3
"""Writes specs/conformance: the cases of the suite, and its manifest.

    generate.py --scc PATH [--out FOLDER] [--check]

Nothing is written that `scc oracle` and an independent computation (geometry.py, turning.py, and those of
test/references/independent), or what is expected by hand, do not agree on: the suite is made in a new place, run, and
put in place when all of it agrees.
Deterministic: the same files each time. With --check nothing is written, and the files must be those that are there.
"""

import argparse
import filecmp
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, '..', '..')
SUITE = os.path.join(ROOT, 'specs', 'conformance')
sys.dont_write_bytecode = True
sys.path.insert(0, SUITE)
sys.path.insert(0, os.path.join(SUITE, 'successors'))

import cases
import make_geometry
import make_invalid
import make_models
import make_rules
import make_successors
import make_turning
import run


def entries(rulebook):
    """The ids of definitions, rules and readings. Laws follow of them, and have no cases of their own; nor has what is
    done to files around the calculus."""
    chapters = re.split(r'^(?=## )', rulebook, flags=re.M)
    return [i for c in chapters if not re.match(r'## \d+\. (Laws|Around the calculus)\n', c) for i in re.findall(r'^### (\S+)', c, re.M)]


def make(scc, folder):
    with open(os.path.join(ROOT, 'specs', 'rulebook.md'), encoding='utf-8') as f:
        rulebook = f.read()
    ids = entries(rulebook)
    semantics = re.search(r'^This is version (\w+) of the semantics', rulebook, re.M).group(1)
    implementation = run.Implementation([scc, 'oracle'], 60)
    invalid, codes, commands = make_invalid.suite(SUITE)
    suites = (make_rules.all_suites() + make_geometry.all_suites(SUITE) + make_turning.all_suites()
              + make_models.all_suites(implementation, os.path.join(ROOT, 'specs')) + [invalid])
    make_successors.write(scc, implementation, os.path.join(ROOT, 'specs'), folder)
    implementation.stop()
    for suite in suites:
        suite.write(folder)
        for case in suite.cases:
            for code in re.findall(r'SC\d{4}', json.dumps(case['expect'])):
                known = codes.setdefault(code, {'cases': [], 'commands': []})['cases']
                if case['id'] not in known:
                    known.append(case['id'])
    cases.write_manifest(folder, suites, semantics, ids, {c: codes[c] for c in sorted(codes)}, commands)
    return sum(len(s.cases) for s in suites)


def files(folder):
    found = []
    for top in ['manifest.json', 'rules', 'geometry', 'models', 'invalid/cases.json', 'invalid/faults.json', 'successors/cases.json']:
        path = os.path.join(folder, top)
        if os.path.isfile(path):
            found.append(top)
        for at, _, names in os.walk(path):
            found += [os.path.relpath(os.path.join(at, n), folder) for n in names]
    return sorted(found)


def main():
    parser = argparse.ArgumentParser(description='Writes the conformance suite.')
    parser.add_argument('--scc', required=True)
    parser.add_argument('--out', default=SUITE)
    parser.add_argument('--check', action='store_true')
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        count = make(options.scc, folder)
        command = [sys.executable, '-B', os.path.join(SUITE, 'run.py'), '--suite', folder, '--', options.scc, 'oracle']
        if subprocess.run(command).returncode != 0:
            sys.exit('generate: scc and what was computed do not agree; nothing is written')
        new, old = files(folder), files(options.out)
        changed = [f for f in new if f not in old or not filecmp.cmp(os.path.join(folder, f), os.path.join(
            options.out, f), shallow=False)]
        gone = [f for f in old if f not in new]
        if options.check:
            sys.exit('generate: not up to date: %s' % ', '.join(changed + gone) if changed or gone else 0)
        for f in changed:
            os.makedirs(os.path.dirname(os.path.join(options.out, f)), exist_ok=True)
            shutil.copyfile(os.path.join(folder, f), os.path.join(options.out, f))
        for f in gone:
            os.remove(os.path.join(options.out, f))
        print('%d cases; %d files changed, %d removed' % (count, len(changed), len(gone)))


if __name__ == '__main__':
    main()
