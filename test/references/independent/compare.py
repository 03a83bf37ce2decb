#!/usr/bin/env python3
"""Runs scc on random models and checks every transition against the naive calculus.

For each model: one random run; at each of its states the number of transitions; for the
first few states with a choice, every transition, its label and the whole next state.
The last line is `N passed, N failed`.
"""

import argparse
from fractions import Fraction as F
import json
import os
import random
import subprocess
import sys
import tempfile

import explore
import generate
from reading import Difference, Output


def run(scc, arguments):
    done = subprocess.run([scc] + arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=600)
    return done.returncode, done.stdout, done.stderr


def lines_of(scc, arguments, codes=(0,)):
    code, out, err = run(scc, arguments)
    if code not in codes:
        raise Difference('exit code %d: %s' % (code, err.strip()[:600]))
    return [json.loads(line) for line in out.splitlines()], err


def show(item):
    """For reports: sets and fractions made readable."""
    if isinstance(item, F):
        return str(item)
    if isinstance(item, (frozenset, set)):
        return '{%s}' % ', '.join(sorted(map(show, item)))
    if isinstance(item, tuple):
        return '(%s)' % ', '.join(map(show, item))
    return repr(item)


def expect(what, scc, naive):
    if scc != naive:
        raise Difference('%s\n  scc:   %s\n  naive: %s' % (what, show(scc), show(naive)))


def formula(model, rng, depth):
    names = list(model.bodies)
    p, q = rng.choice(names), rng.choice(names)
    if depth > 0 and rng.random() < 0.4:
        f, g = formula(model, rng, depth - 1), formula(model, rng, depth - 1)
        return rng.choice([explore.conjunction(f, g), explore.implication(f, g), explore.negation(f)])
    relation = rng.choice(list(explore.RELATIONS))
    axis = rng.randrange(model.flat)
    kinds = [lambda: explore.speed(p, axis, relation, F(rng.randint(-2, 2), 2)),
             lambda: explore.size(model.bodies, p, relation, rng.randint(1, 5))]
    if not model.bodies[p].fixed:  # its masses mean nothing, and hence no centre of mass
        kinds += [lambda: explore.coordinate(model.bodies, p, axis, relation, F(rng.randint(-8, 8), 4))] * 2
    if p != q:
        kinds += [lambda: explore.touching(model.bodies, p, q)] * 2 + [
            lambda: explore.bound_together(p, q), lambda: explore.same(p, q)]
    used = model.channels()
    if used:
        kinds += [lambda: explore.bonds(rng.choice(used), relation, rng.randint(0, 2))] * 2
    own = [n for n, s in model.on.items() if s is model.bodies[p].shape]
    if own:
        kinds += [lambda: explore.behaviour(p, rng.choice(own))]
    return rng.choice(kinds)()


def question(model, rng, graph):
    """A random property and its verdict."""
    f = formula(model, rng, 2)
    within = rng.choice([None, None, F(0), F(1), F(1, 2), F(3, 2), F(2), F(3)])
    kind = rng.choice(['possibly', 'always', 'eventually'])
    text = '%s (%s)%s' % (kind, f[0], '' if within is None else ' within %s' % within)
    if kind == 'possibly':
        return text, 'holds' if explore.possibly(graph, f, within) else 'violated'
    if kind == 'always':
        return text, 'violated' if explore.possibly(graph, explore.negation(f), within) else 'holds'
    return text, explore.eventually(graph, f, within)


class Comparison:
    def __init__(self, scc, folder, steps, branches, walkers=False, states=150, questions=12):
        self.walkers = walkers
        self.scc, self.folder, self.steps, self.branches = scc, folder, steps, branches
        self.states, self.questions = states, questions
        self.seen = {}

    def model(self, seed):
        model = generate.Model(seed, switches=True, walkers=self.walkers)
        path = os.path.join(self.folder, 'model.sc')
        with open(path, 'w') as f:
            f.write(model.text())
        # A law of motion can double the digits of every number at each collision.
        steps = min(self.steps, 10) if model.calculus.steered else self.steps
        lines, _ = lines_of(self.scc, ['trace', path, '--choose', 'random:%d' % seed, '--steps', str(steps)])
        output = Output(model.bodies)
        state = model.initial()
        expect('initial state', output.state(lines[1]['state'], '0'), state)
        choices, left = [], self.branches
        for line in lines[2:-1]:
            successors = self.successors(model, state, output.label(line['label'], state))
            if line['of'] > 1 and left > 0:
                left -= 1
                self.all_choices(path, output, state, choices, line['of'], successors)
            label = output.label(line['label'], state)
            after = output.state(line['state'], line['time'])
            self.found(label[0])
            if len(json.dumps(line)) > 20000:  # a law of motion can make numbers without bound
                return
            self.check(choices, successors, label, after, line['of'])
            choices.append(line['choice'])
            state = after
        self.ending(lines[-1], steps, state, model)

    def properties(self, seed):
        """Explores the model both ways, if it is small: counts, and verdicts on random properties."""
        model = generate.Model(seed, switches=True, walkers=self.walkers)
        if any('time' in t for t in model.law_texts):
            return
        try:
            drawing = any(body.chooses for body in model.bodies.values())
            graph = explore.Graph(model.calculus, model.initial(), self.states)
        except explore.TooMany:
            return
        self.found('explored with draws' if drawing else 'explored')
        rng = random.Random(seed)
        questions = [question(model, rng, graph) for _ in range(self.questions)]
        path = os.path.join(self.folder, 'check.sc')
        with open(path, 'w') as f:
            f.write(model.text())
            f.write('check all : always processes >= 0\n')
            for i, (text, _) in enumerate(questions):
                f.write('check q%d : %s\n' % (i, text))
        self.verdicts(path, questions, [])
        counts = self.verdicts(path, questions, ['--no-reduce', 'symmetry,translation,order,slice,drift,draws'])
        if graph.jumps:
            return
        if counts['states'] != len(graph.edges) or counts['transitions'] != graph.transitions():
            raise Difference('explored by scc: %d states, %d transitions; naive: %d, %d' % (
                counts['states'], counts['transitions'], len(graph.edges), graph.transitions()))

    def verdicts(self, path, questions, options):
        """The verdicts of scc with some options; what it explored."""
        code, out, err = run(self.scc, ['check', path, '--json'] + options)
        if code not in (0, 1, 2):
            raise Difference('check: exit code %d: %s' % (code, (out + err)[:600]))
        report = json.loads(out)
        for (text, expected), p in zip([('all', 'holds')] + questions, report['properties']):
            self.found(text.split()[0] + ' ' + expected)
            expect('check ' + ' '.join([text] + options), p['verdict'], expected)
        return report['explored']

    def successors(self, model, state, label):
        """With the jump over movement steps, if scc takes it."""
        plain = model.calculus.successors(state)
        jumping = model.calculus.successors(state, jump=True)
        return jumping if label[0] == 'time' and label in {l for l, _ in jumping} else plain

    def found(self, kind):
        self.seen[kind] = self.seen.get(kind, 0) + 1

    def check(self, choices, successors, label, after, of):
        where = 'after the choices %s' % choices
        if (label, after) not in successors:
            same = {s for l, s in successors if l == label}
            if not same:
                expect(where + ': label', label, tuple(l for l, _ in successors))
            expect(where + ': state after ' + show(label), after, next(iter(same)) if len(same) == 1 else same)
        if of != len(successors):
            raise Difference('%s: scc has %d transitions, naive %d: %s' % (
                where, of, len(successors), show({l for l, _ in successors})))

    def all_choices(self, path, output, state, choices, of, successors):
        """Takes each transition of the state at the end of the choices."""
        found = set()
        schedule = os.path.join(self.folder, 'schedule.json')
        for i in range(of):
            with open(schedule, 'w') as f:
                json.dump({'format': 'scc-schedule', 'version': 1,
                           'choices': [{'choice': n} for n in choices + [i]]}, f)
            lines, _ = lines_of(self.scc, ['trace', path, '--schedule', schedule])
            line = lines[1 + len(choices) + 1]
            found.add((output.label(line['label'], state), output.state(line['state'], line['time'])))
        if found != successors:
            raise Difference('after the choices %s: the transitions differ\n  only scc:   %s\n  only naive: %s' % (
                choices, show(found - successors), show(successors - found)))

    def ending(self, end, steps, state, model):
        if end['steps'] < steps:
            if model.calculus.successors(state, jump=True):
                raise Difference('scc ends (%s), naive goes on' % end['ending'])
            if end['ending'] != 'quiescent':
                raise Difference('ending %s' % end['ending'])


def main():
    if hasattr(sys, 'set_int_max_str_digits'):
        sys.set_int_max_str_digits(0)
    parser = argparse.ArgumentParser()
    parser.add_argument('--scc', required=True)
    parser.add_argument('--count', type=int, default=100)
    parser.add_argument('--seed', type=int, default=1, help='of the first model; the others follow')
    parser.add_argument('--steps', type=int, default=25)
    parser.add_argument('--branches', type=int, default=4, help='states of a run whose transitions are all taken')
    parser.add_argument('--walkers', action='store_true', help='that do not bounce (rule Blocked), in all models')
    options = parser.parse_args()
    passed, failed = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        comparison = Comparison(options.scc, folder, options.steps, options.branches, options.walkers)
        for seed in range(options.seed, options.seed + options.count):
            try:
                comparison.model(seed)
                comparison.properties(seed)
                passed += 1
            except (Difference, AssertionError, subprocess.TimeoutExpired) as fault:
                failed += 1
                print('model %d: %s' % (seed, fault), flush=True)
    print('seen: %s' % ', '.join('%d %s' % (n, k) for k, n in sorted(comparison.seen.items())))
    print('%d passed, %d failed' % (passed, failed))
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
