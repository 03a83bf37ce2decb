#!/usr/bin/env python3
"""Holds a filter of successors (specs/successors.md) against the cases of successors/cases.json.

    run_successors.py -- COMMAND ...      # scc successors, or another program that is called in the same way
    run_successors.py -- scc successors

COMMAND is called with the options of the cases and the path of a model, and answers lines. Transitions are compared in
any order, fingerprints are worked out from the bytes, and words of reasons are not compared. Exit code 0: all agree.
"""

import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(HERE, 'successors'))
import state_bytes

OF_HEADER = ['format', 'version', 'state_bytes', 'checks', 'goals', 'events', 'horizon', 'initial']


def plain(value):
    """Without the words of reasons."""
    if isinstance(value, dict):
        return {k: True if k in ('undecided', 'reason', 'message') and v else plain(v) for k, v in value.items()}
    return [plain(v) for v in value] if isinstance(value, list) else value


def in_order(answer):
    moves = answer.get('successors', [])
    places = sorted(range(len(moves)), key=lambda k: json.dumps(moves[k], sort_keys=True))
    ahead = [dict(a, met=dict(a['met'], choice=a['met']['choice'] is not None)) if a and a['met'] else a
             for a in answer.get('ahead', [])]
    return dict(answer, successors=[moves[k] for k in places], ahead=ahead)


def same(expected, found):
    return in_order(plain(expected)) == in_order(plain(found))


def wrong_fingerprints(answer, events):
    for move in answer.get('successors', []):
        _, pieces = state_bytes.read(bytes.fromhex(move['state']), events)
        if state_bytes.fingerprint(pieces).hex() != move['fingerprint']:
            yield move['state']


def run(command, given, folder):
    """What differs, a text each."""
    path = os.path.join(folder, 'model.sc')
    with open(path, 'w', encoding='utf-8') as f:
        f.write(given['text'])
    lines = ''.join(c['line'] + '\n' for c in given['cases'])
    done = subprocess.run(command + given['options'] + [path], input=lines, stdout=subprocess.PIPE,
                          universal_newlines=True)
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    if done.returncode != 0 or len(answers) != 1 + len(given['cases']):
        yield 'exit code %d, %d answers to %d lines' % (done.returncode, len(answers) - 1, len(given['cases']))
        return
    header = answers[0]
    for name in OF_HEADER:
        if header.get(name) != given['header'][name]:
            yield 'header, %s: %s expected, and not %s' % (name, given['header'][name], header.get(name))
    for case, answer in zip(given['cases'], answers[1:]):
        if not same(case['expect'], answer):
            yield '%s: %s expected, and not %s' % (case['line'], json.dumps(case['expect']), json.dumps(answer))
        for state in wrong_fingerprints(answer, bool(header['events'])):
            yield '%s: this has another fingerprint' % state


def main():
    if '--' not in sys.argv or sys.argv[-1] == '--':
        sys.exit(__doc__)
    command = sys.argv[sys.argv.index('--') + 1:]
    with open(os.path.join(HERE, 'successors', 'cases.json'), encoding='utf-8') as f:
        models = json.load(f)['models']
    cases = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for given in models:
            cases += len(given['cases'])
            for text in run(command, given, folder):
                failed += 1
                print('%s: %s' % (given['name'], text))
    print('%d models, %d states and lines, %d differences' % (len(models), cases, failed))
    sys.exit(1 if failed or not cases else 0)


if __name__ == '__main__':
    main()
