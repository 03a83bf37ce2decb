#!/usr/bin/env python3
"""Runs an implementation of the Shape Calculus against the conformance suite.

    run.py [options] [-- COMMAND ...]        (default: scc oracle)

COMMAND answers JSON-RPC 2.0 requests, one a line, on its standard input and output (specs/oracle.md). README.md tells
how cases are written and compared. Exit codes: 0 all that ran agreed, 1 something differed, 2 something failed.
"""

import argparse
import json
import os
import queue
import subprocess
import sys
import threading
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
UNSUPPORTED = -32601
OUTCOMES = ('agreed', 'differed', 'failed', 'skipped')


class Failure(Exception):
    """No answer, or one that is none."""


class Implementation:
    def __init__(self, command, timeout):
        self.command, self.timeout, self.process, self.number = command, timeout, None, 0

    def start(self):
        self.number += 1
        self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding='utf-8',
                                        errors='replace')
        self.lines = queue.Queue()
        threading.Thread(target=self.read, args=(self.process.stdout, self.lines), daemon=True).start()

    @staticmethod
    def read(stream, lines):
        for line in stream:
            lines.put(line)
        lines.put(None)

    def stop(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            self.process = None

    def send(self, text):
        """One line there and one back; a crash or a long silence ends the process, the next request starts another."""
        if not self.process:
            self.start()
        try:
            self.process.stdin.write(text + '\n')
            self.process.stdin.flush()
            line = self.lines.get(timeout=self.timeout)
        except (OSError, queue.Empty) as fault:
            self.stop()
            raise Failure('no answer in time' if isinstance(fault, queue.Empty) else 'it has ended') from None
        if line is None:
            self.stop()
            raise Failure('it has ended')
        try:
            return json.loads(line)
        except (ValueError, RecursionError):
            raise Failure('not JSON: ' + line[:200]) from None

    def call(self, method, params):
        request = {'jsonrpc': '2.0', 'id': 1, 'method': method, 'params': params}
        answer = self.send(json.dumps(request))
        if not isinstance(answer, dict) or answer.get('id') != 1 or ('result' in answer) == ('error' in answer) \
                or 'error' in answer and not isinstance(answer['error'], dict):
            self.stop()  # who is out of step stays so
            raise Failure('not an answer: %s' % json.dumps(answer)[:200])
        return answer


def number(value):
    """The value of a number in any of its forms; None for what is none."""
    if isinstance(value, dict):
        exact, near = number(value.get('exact')), value.get('float')
        if exact is not None and isinstance(near, float) and abs(near) < 1e300:
            return exact if abs(Fraction(near) - exact) <= 1e-9 * max(1, abs(exact)) else None
        value = value.get('exact', near)
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        return None
    try:
        return Fraction(value)
    except (ValueError, ZeroDivisionError, OverflowError):
        return None


def differs(expected, found, tolerance, at='answer'):
    """None, or where and how the two differ. README.md, 'Comparing', tells the rules."""
    if isinstance(expected, dict) and set(expected) == {'exact', 'float'}:
        x, y = number(expected['exact']), number(found)
        same = y is not None and (x == y if tolerance is None else abs(x - y) <= tolerance * max(1, abs(x)))
        return None if same else '%s: %s expected, %s found' % (at, expected['exact'], json.dumps(found))
    if isinstance(expected, dict) and len(expected) == 1 and set(expected) <= {'set', 'some', 'one of', 'not'}:
        (how, items), = expected.items()
        if how == 'one of':
            ways = [differs(e, found, tolerance, at) for e in items]
            return None if None in ways else ways[0]
        if how == 'not':
            return None if differs(items, found, tolerance, at) else '%s: %s found' % (at, json.dumps(found))
        if not isinstance(found, list):
            return '%s: a list expected, %s found' % (at, json.dumps(found))
        left = list(found)
        for item in items:
            match = next((i for i, f in enumerate(left) if differs(item, f, tolerance) is None), None)
            if match is None:
                return '%s: nothing like %s found among %s' % (at, json.dumps(item), json.dumps(left))
            del left[match]
        return '%s: not expected: %s' % (at, json.dumps(left)) if left and how == 'set' else None
    if isinstance(expected, dict) and isinstance(found, dict):
        for name, value in expected.items():
            if name not in found:
                return '%s.%s is missing' % (at, name)
            difference = differs(value, found[name], tolerance, '%s.%s' % (at, name))
            if difference:
                return difference
        return None
    if isinstance(expected, list) and isinstance(found, list):
        if len(expected) != len(found):
            return '%s: %d items expected, %d found' % (at, len(expected), len(found))
        ways = (differs(e, f, tolerance, '%s[%d]' % (at, i)) for i, (e, f) in enumerate(zip(expected, found)))
        return next((w for w in ways if w), None)
    same = type(expected) is type(found) and expected == found
    return None if same else '%s: %s expected, %s found' % (at, json.dumps(expected), json.dumps(found))


class Suite:
    """The cases of one file, with the handles of what they share."""

    def __init__(self, path, implementation, tolerance):
        with open(path, encoding='utf-8') as f:
            document = json.load(f)
        self.given, self.cases = document.get('given', {}), document['cases']
        self.implementation, self.tolerance, self.handles = implementation, tolerance, {}

    def handle(self, name):
        """What the implementation calls a thing that is given; it forgets all when it has been started again."""
        key = (self.implementation.number, name)
        if not self.implementation.process or key not in self.handles:
            given = self.given[name]
            answer = self.implementation.call(given['method'], self.filled(given['params']))
            key = (self.implementation.number, name)
            self.handles[key] = answer if 'error' in answer else answer['result'][given['handle']]
        if isinstance(self.handles[key], dict):
            raise LookupError(self.handles[key])
        return self.handles[key]

    def filled(self, params):
        if isinstance(params, str) and params.startswith('@'):
            return self.handle(params[1:])
        if isinstance(params, list):
            return [self.filled(p) for p in params]
        return {n: self.filled(p) for n, p in params.items()} if isinstance(params, dict) else params

    def release(self):
        for (start, name), handle in self.handles.items():
            release = self.given[name].get('release')
            if release and start == self.implementation.number and isinstance(handle, str):
                try:
                    self.implementation.call(release, {self.given[name]['handle']: handle})
                except Failure:
                    return

    def path(self, model, along):
        """The choices that lead along these labels, whatever the order of an implementation is."""
        path = []
        for label in along:
            answer = self.implementation.call('successors', {'model': model, 'path': path, 'states': 'none'})
            if 'error' in answer:
                raise LookupError(answer)
            found = [t['choice'] for t in answer['result']['transitions']
                     if differs(label, t['label'], self.tolerance) is None]
            if not found:
                raise LookupError({'error': {'code': None, 'message': 'no transition like %s' % json.dumps(label)}})
            path.append(found[0])
        return path

    def run(self, case):
        """(outcome, why)."""
        try:
            params = self.filled(case['params'])
            if 'along' in case:
                params['path'] = self.path(params['model'], case['along'])
            answer = self.implementation.call(case['method'], params)
        except LookupError as fault:
            answer = fault.args[0]
            if not isinstance(answer, dict):  # a member that is missing
                return 'failed', 'an answer of no known form: %r' % fault
        except Failure as fault:
            return 'failed', str(fault)
        except (TypeError, AttributeError) as fault:  # what the case stands on has an answer of no known form
            return 'failed', 'an answer of no known form: %r' % fault
        if 'error' in answer and answer['error'].get('code') == UNSUPPORTED:
            return 'skipped', 'not supported'
        try:
            difference = differs(case['expect'], answer, self.tolerance)
        except (TypeError, KeyError) as fault:
            return 'failed', 'an answer of no known form: %r' % fault
        return ('differed', difference) if difference else ('agreed', None)


def table(rules, order):
    print('%-14s %8s %8s %8s %8s' % ('rule', *OUTCOMES))
    for rule in order:
        if rule in rules:
            print('%-14s %8d %8d %8d %8d' % (rule, *[rules[rule].get(o, 0) for o in OUTCOMES]))


def main():
    parser = argparse.ArgumentParser(description='Runs an implementation against the conformance suite.')
    parser.add_argument('--only', action='append', metavar='TEXT', help='cases whose id or file has this in it, or '
                        'that are of this rule or method; may be repeated')
    parser.add_argument('--tolerance', type=float, help='let numbers differ by this, relative to the greater of 1 and '
                        'the expected one; exact if not given')
    parser.add_argument('--timeout', type=float, default=60, help='seconds for an answer')
    parser.add_argument('--suite', default=HERE, help='the folder of manifest.json')
    parser.add_argument('--json', metavar='FILE', help='write the outcome of each case')
    parser.add_argument('--verbose', action='store_true', help='say what was done with each case')
    parser.add_argument('command', nargs='*', default=['scc', 'oracle'])
    options = parser.parse_args()
    tolerance = None if options.tolerance is None else Fraction(options.tolerance)
    with open(os.path.join(options.suite, 'manifest.json'), encoding='utf-8') as f:
        manifest = json.load(f)
    implementation = Implementation(options.command, options.timeout)
    try:
        implementation.start()
    except OSError as fault:
        parser.error('cannot start %s: %s' % (options.command[0], fault))
    total, rules, outcomes = dict.fromkeys(OUTCOMES, 0), {}, []
    for file in [s['file'] for s in manifest['suites']]:
        suite = Suite(os.path.join(options.suite, file), implementation, tolerance)
        for case in suite.cases:
            keys = case['rules'] + [case['method']]
            if options.only and not any(o in keys or o in case['id'] or o in file for o in options.only):
                continue
            outcome, why = suite.run(case)
            total[outcome] += 1
            outcomes.append({'id': case['id'], 'file': file, 'outcome': outcome, 'why': why})
            for rule in case['rules']:
                rules.setdefault(rule, dict.fromkeys(OUTCOMES, 0))[outcome] += 1
            if options.verbose or outcome in ('differed', 'failed'):
                print('%s: %s%s' % (outcome, case['id'], ': ' + why if why else ''), flush=True)
        suite.release()
    implementation.stop()
    if not outcomes:
        parser.error('there is no such case')
    table(rules, manifest['rules'])
    print(', '.join('%d %s' % (total[o], o) for o in OUTCOMES))
    if options.json:
        with open(options.json, 'w', encoding='utf-8') as f:
            json.dump({'suite': manifest['version'], 'total': total, 'rules': rules, 'cases': outcomes}, f, indent=1)
    return 2 if total['failed'] else 1 if total['differed'] else 0


if __name__ == '__main__':
    sys.exit(main())
