"""What the page evaluates by itself, against `scc oracle`: random formulas along runs.

    formulas_test.py SCC WORK [CASES]

Of some models, CASES random numbers and formulas are evaluated in each state of a run of first choices, when it is reached
and later, by the scripts of the page and by the method `values` of the oracle. The last line is 'N passed, N failed'.
"""

import json
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MODELS = ['hexokinase', 'ruin', 'docking', 'enzyme', 'billiard', 'glycolysis', 'pocket', 'gears', 'tumble', 'tumbling', 'capsid', 'lets']
# Definitions of all kinds: of others, of vectors, of whole runs, with names of variables of whoever uses them.
LETS = '''
import <solids>
param k = 3/2
let two = 4 / 2
let up = (0, two, k)
let twice = 2 * up
let near = distance2(p, q) < 5 * k
let far = x(q) > up.y + twice.z
let nearer = near and not far
let pushed = exists q in Cube: x(q) > k
let some = count(p in Cube: x(p) > two)
let drift = (vx(q), x(q) - two, 1)
let length = dot(drift, up)
let soon = possibly near
let below = floor(-two / 3)
let first = energy + momentum.x
let energy = 5
let momentum = up
let second = energy + momentum.y
shape Cube = solids.Cube(1)
process p = Cube mass 1 velocity (1/2, 0, 0) at translate (0, 0, 0) [nil]
process q = Cube mass 2 velocity (-1, 0, 0) at translate (6, 0, 0) [nil]
check near : eventually near
'''
# An irrational instant has a rational beside it, within 10^-12.
NEAR = Fraction(1, 10**9)


class Random:
    """Formulas of a model, at random."""

    def __init__(self, chance, data):
        self.chance = chance
        self.leaves = [leaf['name'] for leaf in data['leaves']]
        self.templates = sorted({leaf['template'] for leaf in data['leaves'] if leaf['template'].isidentifier()})
        self.origins = sorted({b['origin'] for b in data['behaviours'] if b['origin'] and b['origin'].isidentifier()})
        named = {one['channel'] for b in data['behaviours'] for one in b['open']}
        self.channels = sorted(named | {bond['name'] for p in data['processes'] for bond in p['bonds']})
        self.parameters = sorted(data['parameters'])
        self.lets = list(data.get('lets', {}))
        # What quantifiers range over: templates, and families by the names of their members.
        families = {name.split('[')[0] for name in self.leaves if name.endswith(']')}
        self.over = self.templates + sorted(families) + self.leaves[:2]
        self.bound = []

    def atoms(self):
        """Each atom of some bodies."""
        some = list(dict.fromkeys(self.leaves[:3] + self.leaves[-2:]))
        one = ['x', 'y', 'z', 'vx', 'vy', 'vz', 'wx', 'wy', 'wz', 'speed2', 'spin2', 'size', 'gone']
        yield from (f'{name}({leaf})' for name in one for leaf in some)
        yield from (f'{name}({p}, {q})' for name in ['distance2', 'bound', 'same'] for p in some[:3] for q in some[:3])
        yield from (f'offers({leaf}, {co}{channel})' for leaf in some for co in ['', '~'] for channel in self.channels[:3])
        yield from (f'bonds({channel}, {p}, {q})' for channel in self.channels[:2] for p in some[:2] for q in some[:3])
        yield from (f'behaviour({leaf}) {op} {name}' for leaf in some for op in ['=', '!='] for name in self.origins[:4])
        yield from ['processes', 'time', 'momentum.x', 'momentum.z', 'bonds()', 'quiescent', 'energy', 'angular.x', 'angular.y', 'angular.z']
        yield from (f'count(q in {over} : {what})' for over in self.over for what in ['x(q) > 0', 'gone(q)', 'speed2(q) > 1/2'])
        yield from (f'{what} q in {over} : not gone(q) and x(q) <= 1e2' for over in self.over for what in ['forall', 'exists'])
        yield from ['1e-3 + 2^-7', '1.5E2 - 12e+1', 'floor(-7/2) + ceil(5/3)', '-7 mod 3 + mod(9, 4)', 'round(-5/2, 1)', 'sign(-1e-9)',
                    'dot((1, 2, 3), (4, 5, 6))', 'cross((1, 0, 0), (0, 1, 0)).z', '(1, 2, 3) = (1, 2, 3)', '-(1, 2, 3).z']
        # What the model defines, by itself and within others, as far as both take it.
        yield from (form % name for name in self.lets for form in
                    ['%s', 'not %s', '%s + 1', '-%s.y', '%s = 2', '%s > 1 / 2', 'floor(%s)', 'floor(%s.x)',
                     f'count(q in {self.over[0]} : %s)', f'count(q in {self.over[0]} : x(q) < %s)', f'dot(%s, (x({some[0]}), 1, 2))'])
        # What is refused.
        yield from ['(1, 2, 3)', 'dot(1, 2)', 'floor(time)', '(1, 2, 3) < (1, 2, 3)', '(time).x', 'min()', 'abs(1, 2)', '2^3', '1 + (1, 2, 3)',
                    '(1, 2, 3).w', 'true + 1', 'if true then 1 else (1, 2, 3)', 'mod(1)', 'dot((1, 2, 3))', 'cross((1, 2, 3), 1).x']

    def leaf(self):
        return self.chance.choice(self.bound or self.leaves) if self.chance.random() < 0.5 else self.chance.choice(self.leaves)

    def constant(self):
        return self.chance.choice(['0', '1', '2', '5/2', '-3', '0.25', '7', *self.parameters])

    def number(self, depth):
        pick, leaf = self.chance, self.leaf
        if depth == 0:
            kind = pick.randrange(9)
            if kind < 4:
                name = pick.choice(['x', 'y', 'z', 'vx', 'vy', 'vz', 'wx', 'wz', 'speed2', 'spin2', 'size'])
                return f'{name}({leaf()})'
            if kind == 4:
                return f'distance2({leaf()}, {leaf()})'
            if kind == 5:
                return pick.choice(['processes', 'time', 'momentum.x', 'momentum.y', 'bonds()', 'energy', 'angular.x', 'angular.z'])
            if kind == 6 and self.channels:
                channel = pick.choice(self.channels)
                return pick.choice([f'bonds({channel})', f'bonds({channel}, {leaf()}, {leaf()})'])
            return self.constant()
        a, b = self.number(depth - 1), self.number(depth - 1)
        kind = pick.randrange(10)
        if kind < 4:
            return f'({a} {"+-*/"[kind]} {b})'
        if kind == 4:
            return pick.choice([f'min({a}, {b})', f'max({a}, {b})', f'abs({a})', f'sign({b})'])
        if kind == 5:
            return f'(if {self.truth(depth - 1)} then {a} else {b})'
        if kind == 6:
            return '(' + self.each('count') + ')' if self.templates else f'-({a})'
        if kind == 7:
            return pick.choice([f'dot({self.vector(depth - 1)}, {self.vector(0)})', f'{self.vector(depth)}.{pick.choice("xyz")}'])
        return f'{a} - {b} * 2'

    def vector(self, depth):
        """A vector within brackets, or a call."""
        pick = self.chance
        kind = pick.randrange(5) if depth > 0 else 0
        if kind == 0:
            leaf = self.leaf()
            return pick.choice([f'(x({leaf}), y({leaf}), z({leaf}))', f'(vx({leaf}), vy({leaf}), {self.constant()})',
                                f'({self.number(0)}, 1e-1, {self.number(0)})'])
        a, b = self.vector(depth - 1), self.vector(depth - 1)
        if kind == 1:
            return f'cross({a}, {b})'
        if kind == 2:
            return f'({a} {pick.choice("+-")} {b})'
        if kind == 3:
            return f'({self.number(0)} * {a})'
        return f'(if {self.truth(0)} then {a} else {b} / 3)'

    def each(self, what):
        variable = f'v{len(self.bound)}'
        over = self.chance.choice(self.over)
        self.bound.append(variable)
        body = self.truth(0)
        self.bound.pop()
        text = f'{variable} in {over} : {body}'
        return f'count({text})' if what == 'count' else f'({what} {text})'

    def truth(self, depth):
        pick, leaf = self.chance, self.leaf
        if depth == 0:
            kind = pick.randrange(8)
            if kind == 0:
                return f'{pick.choice(["bound", "same"])}({leaf()}, {leaf()})'
            if kind == 1:
                return f'gone({leaf()})'
            if kind == 2 and self.origins:
                return f'behaviour({leaf()}) {pick.choice(["=", "!="])} {pick.choice(self.origins)}'
            if kind == 3 and self.channels:
                return f'offers({leaf()}, {pick.choice(["", "~"])}{pick.choice(self.channels)})'
            if kind == 4:
                return pick.choice(['true', 'false', 'quiescent'])
            return f'{self.number(0)} {pick.choice(["<", "<=", ">", ">=", "=", "!="])} {self.number(0)}'
        kind = pick.randrange(6)
        a, b = self.truth(depth - 1), self.truth(depth - 1)
        if kind < 3:
            return f'({a} {["and", "or", "=>"][kind]} {b})'
        if kind == 3:
            return f'not {a} and {b}'
        if kind == 4 and self.templates:
            return self.each(pick.choice(['forall', 'exists']))
        if kind == 5 and pick.randrange(3) == 0:
            return f'{self.vector(depth - 1)} {pick.choice(["=", "!="])} {self.vector(0)}'
        return f'{self.number(depth)} {pick.choice(["<", ">=", "="])} {self.number(depth - 1)}'


def at(piece, age):
    """A function of time at a time, or None; and whether that is clear."""
    pieces = piece.get('pieces') or [{**piece, 'from': '0/1'}]
    froms = [Fraction(one['from']) for one in pieces]
    clear = all(f == age or abs(f - age) > NEAR for f in froms)
    exactly = [one for one, f in zip(pieces, froms) if f == age]
    found = exactly[0] if exactly else [one for one, f in zip(pieces, froms) if f < age][-1]
    if 'n' not in found:
        # What turns for ever is followed from turn to turn by the page alone.
        return None, clear and 'turn' not in found['none']
    n, d = (sum((Fraction(c) * age**i for i, c in enumerate(found[part])), Fraction(0)) for part in 'nd')
    return (n / d if d else None), clear


def ask(scc, requests):
    lines = ''.join(json.dumps({'jsonrpc': '2.0', 'id': k, **one}) + '\n' for k, one in enumerate(requests))
    ended = subprocess.run([scc, 'oracle'], input=lines, capture_output=True, text=True)
    return [json.loads(line) for line in ended.stdout.splitlines()]


def model(scc, work, name, chance, cases):
    """What differs, in words; and how many values are the same."""
    path = ROOT / 'specs/models' / f'{name}.sc'
    if name == 'lets':
        path = work / 'lets.sc'
        path.write_text(LETS)
    file = work / f'{name}.json'
    ended = subprocess.run([scc, 'view', str(path), '--data', '-o', str(file), '--graph', '50', '--seconds', '60'], capture_output=True, text=True)
    if ended.returncode not in (0, 1, 2):
        return [ended.stderr], 0
    data = json.loads(file.read_text())
    index = next(k for k, run in enumerate(data['runs']) if run['name'] == 'first choices')
    steps = [step for step in data['runs'][index]['steps'] if not step.get('tail')][:24]
    make = Random(chance, data)
    formulas = list(make.atoms()) + [make.number(chance.randrange(3)) if chance.random() < 0.5 else make.truth(chance.randrange(3)) for _ in range(cases)]
    times, legs, now = [], [], Fraction(0)
    for k in range(len(steps) + 1):
        label = data['labels'][steps[k]['label']] if k < len(steps) else {}
        d = Fraction(label.get('duration', 0)) if k < len(steps) else Fraction(0)
        # The end is the next state's.
        ages = [Fraction(0)] + ([d * Fraction(chance.randrange(1, 64), 64) for _ in range(2)] if d else [])
        for age in ages:
            times.append((k, age))
            legs.append([k, str(now + age)])
        now += d
    page = subprocess.run(['node', str(ROOT / 'test/web/formulas.js'), str(ROOT / 'web'), str(file), str(index)],
                          input=json.dumps([legs, formulas]), capture_output=True, text=True)
    if page.returncode:
        return [page.stderr], 0
    load = {'method': 'model.load', 'params': {'text': data['text'], 'parameters': data['parameters']}}
    path = [step['choice'] for step in steps]
    answers = ask(scc, [load] + [{'method': 'values', 'params': {'model': 'm1', 'path': path, 'formula': text}} for text in formulas])[1:]
    wrong, same, values = [], 0, 0
    for text, found, answer in zip(formulas, json.loads(page.stdout), answers):
        if 'error' in answer or isinstance(found, dict):
            # scc refuses two things of which the page knows no more than a value, or that there is none: a behaviour of
            # another template, and a constant that divides by zero.
            why = answer.get('error', {}).get('message', '')
            known = 'is a behaviour on' in why or 'division by zero' in why
            # Events in what a model defines are not known to the page.
            known = known or 'events can be asked for' in str(found)
            if ('error' in answer) != isinstance(found, dict) and not known:
                wrong.append(f'{name}: {text}: {found} and {answer.get("error")}')
            continue
        for (k, age), value in zip(times, found):
            expected, clear = at(answer['result']['values'][k], age)
            if clear and (None if value is None else Fraction(value)) != expected:
                wrong.append(f'{name}: {text}, {age} after {k} steps: {value} and {expected}')
                break
            same += 1
            values += expected is not None
    if values < 5 * cases:
        wrong.append(f'{name}: of {cases} formulas only {values} values')
    return wrong, same


def main():
    scc, work = sys.argv[1], Path(sys.argv[2])
    cases = int(sys.argv[3]) if len(sys.argv) > 3 else 60
    work.mkdir(parents=True, exist_ok=True)
    chance, passed, failed = random.Random(7), 0, 0
    for name in MODELS:
        wrong, same = model(scc, work, name, chance, cases)
        passed, failed = passed + (not wrong), failed + bool(wrong)
        print(f'{name}: {same} values', *wrong[:6], sep='\n  ')
    print(f'{passed} passed, {failed} failed')


if __name__ == '__main__':
    main()
