#!/usr/bin/env python3
"""scc conform and scc diff against a float simulator: its traces conform, and those with a fault do not.

conform_test.py SCC ROOT: ROOT is the folder that specs/ is in. The last line is `N passed, N failed`.
"""

import copy
from fractions import Fraction
import json
import os
import re
import subprocess
import sys
import tempfile
import warnings

warnings.filterwarnings('ignore', category=DeprecationWarning)
try:
    import jsonschema
except ImportError:  # then the reports are not held against their schemas
    jsonschema = None

from faults import FAULTS
from float_sim import csv, jsonl, simulate

TOLERANCE = '1e-9'
SEEDS = {'billiard': [1, 2], 'relay': [1], 'chain': [1, 2], 'gravity': [1, 2], 'dimer': [1, 2, 3], 'latch': [1, 3, 4],
         'enzyme': [1, 2, 3], 'crystals': [1, 2]}
VALIDATORS = {}
HERE = os.path.dirname(os.path.abspath(__file__))


def read_schemas(root):
    folder = os.path.join(root, 'specs', 'schema')
    store = {}
    for name in os.listdir(folder):
        if name.endswith('.schema.json'):
            with open(os.path.join(folder, name), encoding='utf-8') as file:
                schema = json.load(file)
            store[schema['$id']] = schema
    for name in ('conform', 'diff'):
        schema = store[name + '.schema.json']
        resolver = jsonschema.RefResolver(base_uri='', referrer=schema, store=store)
        VALIDATORS[name] = jsonschema.Draft202012Validator(schema, resolver=resolver)


class Test:
    def __init__(self, scc, root, folder):
        self.scc, self.root, self.folder = scc, root, folder
        self.passed = self.failed = 0

    def count(self, ok, what, why):
        self.passed += ok
        self.failed += not ok
        if not ok:
            print('%s: %s' % (what, why))

    def write(self, scene, items, form):
        path = os.path.join(self.folder, 'trace.' + form)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(csv(items) if form == 'csv' else jsonl(items, scene.parameters))
        return path

    def check_schema(self, report):
        name = {'scc-conform': 'conform', 'scc-diff': 'diff'}.get(report['format'])
        if name and jsonschema:
            error = jsonschema.exceptions.best_match(VALIDATORS[name].iter_errors(report))
            self.count(error is None, 'schema of ' + report['format'], error and error.message[:300])

    def run(self, *words):
        done = subprocess.run([self.scc] + list(words) + ['--json'], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, timeout=600)
        try:
            report = json.loads(done.stdout)
            self.check_schema(report)
            return done.returncode, report
        except ValueError:
            return done.returncode, dict(verdict='none', error=done.stdout + done.stderr)

    def conform(self, scene, items, form):
        model = os.path.join(self.root if '/' in scene.path else HERE, scene.path)
        defined = [w for n, v in scene.parameters for w in ('-D', '%s=%s' % (n, v))]
        return self.run('conform', model, self.write(scene, items, form), '--tolerance', TOLERANCE, *defined)

    def accepted(self, name, seed):
        scene, items = simulate(name, seed)
        for form in ('csv', 'jsonl'):
            code, report = self.conform(scene, items, form)
            ok = code == 0 and report['verdict'] == 'conforms' and report['run']['transitions'] > 0
            self.count(ok, '%s %d as %s' % (name, seed, form), json.dumps(report)[:600])

    def rejected(self, name, seed, what, change, kind, rule, form):
        scene, items = simulate(name, seed)
        change(items)
        code, report = self.conform(scene, items, form)
        title = '%s: %s, as %s' % (name, what, form)
        if rule is None:
            codes = [d['code'] for d in report.get('diagnostics', [])]
            self.count(code == 3 and codes[:1] == [kind], title, 'exit code %d, %s' % (code, codes))
            return
        told = report.get('divergence') or {}
        found = (code, told.get('kind'), told.get('rules', [None])[0])
        self.count(found == (1, kind, rule) and told['why'] != '', title,
                   '%s instead of %s: %s' % (found, (1, kind, rule), told.get('why', report)))

    def recorded(self, model):
        """A trace of scc itself: as it is; with floats; and with one number changed."""
        path = os.path.join(self.root, 'specs', 'models', model)
        done = subprocess.run([self.scc, 'trace', path, '--choose', 'random:1', '--steps', '24'],
                              stdout=subprocess.PIPE, universal_newlines=True, timeout=600)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        for line in lines:
            if line['type'] == 'transition':  # what others cannot know
                del line['choice'], line['of'], line['rules'], line['step'], line['label']['text']

        def check(changed, *options):
            file = os.path.join(self.folder, 'trace.jsonl')
            with open(file, 'w', encoding='utf-8') as out:
                out.write(''.join(json.dumps(line) + '\n' for line in changed))
            return self.run('conform', path, file, *options)

        code, report = check(lines)
        self.count(code == 0, '%s, exact' % model, json.dumps(report)[:600])
        tolerance = '1/1000' if any('"turned"' in line for line in done.stdout.splitlines()[1:2]) else TOLERANCE
        code, report = check([floats(line) for line in lines], '--tolerance', tolerance)
        self.count(code == 0, '%s, floats' % model, json.dumps(report)[:600])
        states = [line for line in lines if 'state' in line]
        velocity = states[len(states) // 2]['state']['processes'][-1]['velocity']
        velocity[1] = str(Fraction(velocity[1]) + Fraction(1, 10 ** 6))
        code, report = check(lines)
        told = report.get('divergence') or {}
        self.count((code, told.get('kind')) == (1, 'wrong-velocity'), '%s, changed' % model, json.dumps(report)[:600])

    def told_apart(self, name, seed, change):
        """scc diff: of a trace and itself in the other format; of it and one with a fault."""
        scene, items = simulate(name, seed)
        one, two = self.write(scene, items, 'csv'), self.write(scene, items, 'jsonl')
        code, report = self.run('diff', one, two, '--tolerance', TOLERANCE)
        self.count(code == 0 and report['verdict'] == 'same', 'diff of %s with itself' % name, report)
        items = copy.deepcopy(items)
        change(items)
        code, report = self.run('diff', one, self.write(scene, items, 'jsonl'), '--tolerance', TOLERANCE)
        self.count(code == 1 and report['verdict'] == 'different', 'diff of %s with a fault' % name, report)


def floats(value):
    """The same with each number as a float, but what no simulator has."""
    if isinstance(value, dict):
        return {k: v if k == 'parameters' else floats(v) for k, v in value.items() if k not in ('behaviour', 'origin')}
    if isinstance(value, list):
        return [floats(v) for v in value]
    if isinstance(value, str) and re.fullmatch('-?[0-9]+(/[0-9]+)?', value):
        return float(Fraction(value))
    return value


def is_open(model):
    """Its start, or the instants of its splits, are left open: traces are compared with models that are known."""
    with open(model, encoding='utf-8') as file:
        return re.search(r'^(param \w+ in [\[(]|split_step any)', file.read(), re.M) is not None


def main():
    scc, root = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    if jsonschema:
        read_schemas(root)
    with tempfile.TemporaryDirectory() as folder:
        test = Test(scc, root, folder)
        for name, seeds in SEEDS.items():
            for seed in seeds:
                test.accepted(name, seed)
        for fault in FAULTS:
            # CSV has no bonds in its states
            for form in ('jsonl',) if fault[4] == 'wrong-bonds' else ('csv', 'jsonl'):
                test.rejected(*fault, form)
        for model in sorted(os.listdir(os.path.join(root, 'specs', 'models'))):
            if model.endswith('.sc') and not is_open(os.path.join(root, 'specs', 'models', model)):
                test.recorded(model)
        for name, seed, _, change, kind, _ in FAULTS:
            if name in ('latch', 'chain', 'gravity') and kind != 'wrong-bonds':
                test.told_apart(name, seed, change)
    print('%d passed, %d failed' % (test.passed, test.failed))
    return 1 if test.failed or len(FAULTS) < 20 else 0


if __name__ == '__main__':
    sys.exit(main())
