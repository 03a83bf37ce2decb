#!/usr/bin/env python3
"""scc agrees with the suite, and the suite has teeth: every mutant of scc is caught, controls are not, and the second
implementation agrees.

    test_suite.py --scc PATH        the last line is 'N passed, N failed'

Each case is asked once; what a mutant would have answered is made from what scc answered.
"""

import argparse
import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
SUITE = os.path.join(HERE, '..', '..', 'specs', 'conformance')
sys.dont_write_bytecode = True
sys.path.insert(0, SUITE)

import mutants
import run
import second


class Recorded(run.Implementation):
    """Remembers the last request and its answer."""

    def call(self, method, params):
        self.last = (method, params, super().call(method, params))
        return self.last[2]


class InProcess:
    """The second implementation, without a process of its own."""
    process, number = True, 1

    def __init__(self):
        self.second = second.Second()

    def call(self, method, params):
        return {'id': 1, **self.second.answer({'method': method, 'params': params})}


class Results:
    def __init__(self):
        self.passed, self.failed = 0, 0

    def say(self, good, text):
        self.passed, self.failed = self.passed + good, self.failed + (not good)
        print('%s %s' % ('ok  ' if good else 'FAIL', text), flush=True)


def manifest():
    with open(os.path.join(SUITE, 'manifest.json'), encoding='utf-8') as f:
        return json.load(f)


def recorded(results, scc):
    """Every case with what scc answers: (case, method, params, answer). Counts those that agree."""
    implementation, found = Recorded([scc, 'oracle'], 60), []
    for entry in manifest()['suites']:
        suite = run.Suite(os.path.join(SUITE, entry['file']), implementation, None)
        for case in suite.cases:
            outcome, why = suite.run(case)
            if outcome == 'agreed':
                results.passed += 1
                found.append((case, *implementation.last))
            else:
                results.say(False, '%s: %s: %s' % (case['id'], outcome, why))
        suite.release()
    implementation.stop()
    return found


def caught_by(name, answers):
    """The first case that notices, or None, and how many answers were changed up to there."""
    changed = 0
    for case, method, params, answer in answers:
        other = mutants.change(name, method, params, answer)
        if other != answer:
            changed += 1
            if run.differs(case['expect'], other, None):
                return case['id'], changed
    return None, changed


def test_mutants(results, answers):
    bad, controls = mutants.names()
    for name in bad:
        first, changed = caught_by(name, answers)
        results.say(first is not None, 'mutant %s: %s' % (
            name, 'caught by ' + first if first else 'NOT caught, of %d answers that it changes' % changed))
    for name in controls:
        first, changed = caught_by(name, answers)
        results.say(changed > 0 and first is None, 'control %s: %s' % (
            name, 'noticed by ' + first if first else '%d answers changed, none noticed' % changed))


def test_proxy(results, scc):
    """scc and a few of them from end to end, through the runner."""
    done = subprocess.run([sys.executable, '-B', os.path.join(SUITE, 'run.py'), '--only', 'rules/Bind', '--', scc, 'oracle'],
                          stdout=subprocess.PIPE, text=True)
    results.say(done.returncode == 0, 'run.py on scc exits with %d' % done.returncode)
    for name, only, code in (('time_late_by_a_billionth', 'rules/Ftoc', 1), ('outcomes_in_another_order', 'rules/Bind', 0),
                             ('an_outcome_is_missing', 'rules/Bind', 1)):
        done = subprocess.run([sys.executable, '-B', os.path.join(SUITE, 'run.py'), '--only', only, '--', sys.executable,
                               '-B', os.path.join(HERE, 'mutants.py'), name, '--', scc, 'oracle'],
                              stdout=subprocess.PIPE, text=True)
        results.say(done.returncode == code, 'run.py on %s exits with %d' % (name, done.returncode))


CRASHES = 'import sys; sys.stdin.readline(); sys.exit(1)'
SILENT = 'import sys, time; sys.stdin.readline(); time.sleep(60)'
BABBLES = 'import sys\nfor line in sys.stdin: print("hello", flush=True)'
REFUSES = ('import sys, json\nfor line in sys.stdin: print(json.dumps({"jsonrpc": "2.0", "id": json.loads(line)["id"], '
           '"error": {"code": -32601, "message": "", "data": {}}}), flush=True)')
ANSWERS = ('import sys, json\nfor line in sys.stdin: print(json.dumps({"jsonrpc": "2.0", "id": json.loads(line)["id"], '
           '%s}), flush=True)')
BYTES = 'import sys\nfor line in sys.stdin: sys.stdout.buffer.write(b"\\xff\\n"); sys.stdout.flush()'
NESTS = 'import sys\nfor line in sys.stdin: print("[" * 100000, flush=True)'


def test_runner(results):
    """Implementations that crash, say nothing, or talk nonsense, one that can do nothing, and none."""
    for what, program, code, word in (('crashes', CRASHES, 2, '0 agreed, 0 differed, 10 failed'),
                                      ('is silent', SILENT, 2, '0 agreed, 0 differed, 10 failed'),
                                      ('babbles', BABBLES, 2, '0 agreed, 0 differed, 10 failed'),
                                      ('answers null', ANSWERS % '"result": None', 2, ' 10 failed'),
                                      ('answers a list', ANSWERS % '"result": [1]', 2, ' 10 failed'),
                                      ('answers too little', ANSWERS % '"result": {}', 2, ' 10 failed'),
                                      ('has a text as error', ANSWERS % '"error": "x"', 2, ' 10 failed'),
                                      ('writes no UTF-8', BYTES, 2, ' 10 failed'),
                                      ('nests its answer deeply', NESTS, 2, ' 10 failed'),
                                      ('refuses all', REFUSES, 0, '0 agreed, 0 differed, 0 failed, 10 skipped')):
        timeout = '0.1' if program is SILENT else '600'
        done = subprocess.run([sys.executable, '-B', os.path.join(SUITE, 'run.py'), '--only', 'rules/Ftoc', '--timeout', timeout,
                               '--', sys.executable, '-c', program], stdout=subprocess.PIPE, text=True)
        results.say(done.returncode == code and word in done.stdout, 'run.py on one that %s: %s' % (
            what, done.stdout.strip().split('\n')[-1]))
    for what, words in (('a program that is none', ['--', './no such program']),
                        ('no case at all', ['--only', 'no such case', '--', sys.executable, '-c', REFUSES])):
        done = subprocess.run([sys.executable, '-B', os.path.join(SUITE, 'run.py'), *words], stderr=subprocess.PIPE,
                              text=True)
        results.say(done.returncode == 2 and 'Traceback' not in done.stderr, 'run.py on %s: %s' % (
            what, done.stderr.strip().split('\n')[-1]))


def test_adapter(results):
    """The adapter of README.md."""
    with open(os.path.join(SUITE, 'README.md'), encoding='utf-8') as f:
        shown = f.read().split('```python\n')[1].split('```')[0]
    with open(os.path.join(SUITE, 'example_adapter.py'), encoding='utf-8') as f:
        results.say(f.read() == shown, 'README.md shows example_adapter.py')
    done = subprocess.run([sys.executable, '-B', os.path.join(SUITE, 'run.py'), '--only', 'first_time_of_contact', '--',
                           sys.executable, '-B', os.path.join(SUITE, 'example_adapter.py')],
                          stdout=subprocess.PIPE, text=True)
    last = done.stdout.strip().split('\n')[-1]
    results.say(done.returncode == 0 and not last.startswith('0 agreed'), 'example_adapter.py: ' + last)


def test_second(results, every):
    implementation = InProcess()
    for entry in manifest()['suites']:
        if entry['file'].startswith('geometry/'):
            suite = run.Suite(os.path.join(SUITE, entry['file']), implementation, None)
            wrong, cases = [], suite.cases[::every]
            for case in cases:
                outcome, why = suite.run(case)
                if outcome != 'agreed':
                    wrong.append('%s: %s: %s' % (case['id'], outcome, why))
            results.say(not wrong, 'second implementation on %d cases of %s%s' % (
                len(cases), entry['file'], ''.join('\n  ' + w for w in wrong[:5])))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--scc', required=True)
    parser.add_argument('--every', type=int, default=1, metavar='K', help='ask the second implementation each K-th case '
                        'of a file')
    parser.add_argument('parts', nargs='*', default=['mutants', 'runner', 'second'])
    options = parser.parse_args()
    results = Results()
    scc = os.path.abspath(options.scc)
    if 'mutants' in options.parts:
        test_mutants(results, recorded(results, scc))
        test_proxy(results, scc)
    if 'runner' in options.parts:
        test_runner(results)
        test_adapter(results)
    if 'second' in options.parts:
        test_second(results, options.every)
    print('%d passed, %d failed' % (results.passed, results.failed))
    sys.exit(1 if results.failed else 0)


if __name__ == '__main__':
    main()
