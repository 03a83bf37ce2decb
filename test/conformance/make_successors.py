"""Cases of successors for programs: states of small models as bytes, and what follows them.

A state is only written where three agree: the filter; an independent reader of specs/state-bytes.md, by which the bytes
say what `scc oracle` says of the state that the same choices lead to (whose transitions the naive calculus and cases by
hand hold: make_models.py); and fingerprints that are worked out from the bytes."""

from fractions import Fraction as F
import json
import os
import subprocess
import sys
import tempfile

import state_bytes

# States of the whole network, each by itself: reductions are scc's own.
OPTIONS = ['--no-reduce', 'symmetry,translation,slice,time,drift']
STATES = 12
LINES = ['', '00', '0102', 'zz', 'ff', '7b']
MODELS = ['association', 'chain', 'clasp', 'enzymes', 'figure4', 'figure5', 'ligand', 'outlet', 'raft', 'relay', 'rounded',
          'tumbling', 'vertex']


class Disagreement(Exception):
    pass


def hold(condition, what):
    if not condition:
        raise Disagreement(what)


def number(text):
    return None if text is None else F(text)


def numbers(vector):
    return [F(a) for a in vector]


def hold_process(read, told, names):
    hold([names[l['body']] for l in read['leaves']] == [l['name'] for l in told['leaves']], 'bodies')
    for l, m in zip(read['leaves'], told['leaves']):
        hold(l['position'] == numbers(m['position']), 'position')
        hold((l['origin'] > 0) == (m['origin'] is not None), 'origin')
        if 'turned' in m:
            hold(l.get('turned', [1, 0, 0, 0]) == [int(a) for a in m['turned']], 'turned')
    hold(read['velocity'] == numbers(told['velocity']), 'velocity')
    hold(read.get('clock') == number(told['clock']), 'clock')
    if 'spin' in told:
        hold(read.get('spin', [0, 0, 0]) == numbers(told['spin']), 'spin')
    if told.get('draw') is not None:
        hold(read['draw'] == (told['draw'] if told['draw'] == 'waits' else numbers(told['draw'])), 'draw')
    ends = sorted(sorted(names[e['body']] for e in b['ends']) for b in read['bonds'])
    there = sorted(sorted(e[:e.rindex('.')] if e not in names else e for e in b['ends']) for b in told['bonds'])
    for mine, yours in zip(ends, there):
        hold(all(y == m or y.startswith(m + '.') for m, y in zip(mine, yours)), 'bonds')
    hold(len(ends) == len(there), 'bonds')


def hold_state(data, told, names, events):
    read, pieces = state_bytes.read(data, events)
    hold(len(read['processes']) == len(told['processes']), 'processes')
    for p, q in zip(read['processes'], told['processes']):
        hold_process(p, q, names)
    step = told.get('step')
    hold((read['step'] is None) == (step is None), 'step')
    if step is not None:
        hold(read['step'] == {'remaining': F(step['remaining']), 'phase': step['phase']}, 'step')
    return state_bytes.fingerprint(pieces).hex()


class Filter:
    def __init__(self, scc, path):
        self.process = subprocess.Popen([scc, 'successors'] + OPTIONS + [path], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, universal_newlines=True)
        self.header = json.loads(self.process.stdout.readline())

    def ask(self, line):
        self.process.stdin.write(line + '\n')
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        return self.process.wait()


def walk(filter, implementation, handle, names):
    """States of the model as cases, breadth first."""
    events = bool(filter.header['events'])
    initial = filter.header['initial']
    todo, seen, cases = [([], initial)], {initial['fingerprint']}, []
    while todo and len(cases) < STATES:
        path, found = todo.pop(0)
        answer = filter.ask(found['state'])
        told = implementation.call('successors', {'model': handle, 'path': path, 'states': 'all'})['result']
        hold(hold_state(bytes.fromhex(found['state']), told['state'], names, events) == answer['fingerprint'],
             'fingerprint')
        moves = answer['successors']
        hold(len(moves) == len(told['transitions']), 'transitions')
        for k, (move, t) in enumerate(zip(moves, told['transitions'])):
            hold(move['label'] == t['label']['text'], 'label')
            hold(F(move['duration']) == F(t['label'].get('duration', 0)), 'duration')
            hold(move.get('chance') == t['label'].get('chance'), 'chance')
            made = hold_state(bytes.fromhex(move['state']), t['state'], names, events)
            hold(made == move['fingerprint'], 'fingerprint')
            if made not in seen:
                seen.add(made)
                todo.append((path + [k], move))
        cases.append({'line': found['state'], 'expect': answer})
    return cases


def of_model(scc, implementation, specs, name):
    path = os.path.join(specs, 'models', name + '.sc')
    with open(path, encoding='utf-8') as f:
        text = f.read()
    loaded = implementation.call('model.load', {'text': text})
    if 'error' in loaded:
        raise Disagreement('it is not loaded: %s' % loaded['error'])
    handle, names = loaded['result']['model'], [l['name'] for l in loaded['result']['leaves']]
    filter = Filter(scc, path)
    cases = walk(filter, implementation, handle, names)
    for line in LINES:
        answer = filter.ask(line)
        hold(answer['error']['code'] == 'SC0920', 'a line that is no state')
        cases.append({'line': line, 'expect': answer})
    hold(filter.close() == 0, 'exit code')
    implementation.call('model.release', {'model': handle})
    header = {k: filter.header[k] for k in
              ['format', 'version', 'state_bytes', 'checks', 'goals', 'events', 'horizon', 'initial']}
    return {'name': name, 'options': OPTIONS, 'text': text, 'header': header, 'cases': cases}


def write(scc, implementation, specs, folder):
    """The file; how many states and lines it has."""
    models = []
    for name in MODELS:
        try:
            models.append(of_model(scc, implementation, specs, name))
        except Disagreement as e:
            sys.exit('successors of %s: %s' % (name, e))
    head = {'format': 'scc-conformance-successors', 'version': 1,
            'about': 'States as bytes, and what follows them, for filters of successors: specs/successors.md.'}
    path = os.path.join(folder, 'successors', 'cases.json')
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w', encoding='utf-8') as f:
        f.write(json.dumps(head)[:-1] + ', "models": [\n')
        for i, m in enumerate(models):
            cases = ',\n'.join(json.dumps(c) for c in m['cases'])
            rest = json.dumps({k: v for k, v in m.items() if k != 'cases'})[:-1]
            f.write('%s, "cases": [\n%s]}%s\n' % (rest, cases, ',' if i + 1 < len(models) else ''))
        f.write(']}\n')
    return sum(len(m['cases']) for m in models)
