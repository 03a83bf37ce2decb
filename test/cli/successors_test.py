#!/usr/bin/env python3
"""Explores models breadth first through `scc successors`, and compares with `scc check --no-reduce order,draws`:
the numbers of states and transitions, the verdicts, and the runs that show them.

    successors_test.py SCC [--states N] [--least N] [--framing lines|batches|news] MODEL ...

This explorer knows nothing of shapes: it has the bytes of states, and what the filter says of them. It is made from
specs/successors.md alone. With --least, at least so many models have to be compared as a whole.
"""

import argparse
import json
import os
import struct
import subprocess
import sys
import tempfile


class Filter:
    """A filter that answers lines."""

    framing = 'lines'

    def __init__(self, scc, model, exploration, arguments=()):
        command = [scc, 'successors', model, '--exploration', str(exploration), '--framing', self.framing, *arguments]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.header = json.loads(self.process.stdout.readline() or 'null')

    def ask(self, line):
        self.process.stdin.write(line.encode() + b'\n')
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def successors(self, state):
        return self.ask(state)

    def run(self, goal, choices):
        return self.ask(json.dumps({'goal': goal, 'choices': choices}))

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        return self.process.wait()


class Batches(Filter):
    """One that answers batches; each is of one state here, and gives what a line does."""

    framing = 'batches'

    def __init__(self, *of):
        super().__init__(*of)
        self.labels = []
        self.lines = Filter(*of)  # for runs

    def send(self, kind, lengths, data=b''):
        body = struct.pack('<II%dI' % len(lengths), kind, len(lengths), *lengths) + data
        self.process.stdin.write(struct.pack('<I', len(body)) + body)
        self.process.stdin.flush()

    def frame(self):
        size, = struct.unpack('<I', self.process.stdout.read(4))
        return self.process.stdout.read(size)

    def successors(self, state):
        goals = len(self.header['goals'])
        data = bytes.fromhex(state)
        self.send(1, [len(data)], data)
        columns = self.frame()
        n, moves, text = struct.unpack_from('<3I', columns)
        follows, count = columns[12], struct.unpack_from('<I', columns, 13)[0]
        at = 12 + n + 4 * n + n * goals
        prints = [columns[at + 16 * i:at + 16 * (i + 1)].hex() for i in range(moves)]
        numbers = struct.unpack_from('<%dI' % moves, columns, at + 16 * moves)
        at += 20 * moves
        assert (n, count, len(columns)) == (1, moves, at + text)
        told = json.loads(columns[at:]) if text else {}
        self.labels += told.get('labels', [])
        note = told.get('notes', [{}])[0]
        targets = self.frame()
        n, size, text = struct.unpack_from('<3I', targets)
        at = 12 + n + n * goals
        lengths = struct.unpack_from('<%dI' % n, targets, at)
        assert n == moves and sum(lengths) == size and len(targets) == at + 4 * n + size + text
        doubts = json.loads(targets[at + 4 * n + size:])['notes'] if text else []
        doubts = {d['index']: d['goals'] for d in doubts}
        successors, begins = [], at + 4 * n
        for i in range(n):
            truths = [bool(t) for t in targets[12 + n + i * goals:12 + n + (i + 1) * goals]]
            found = dict(self.labels[numbers[i]], state=targets[begins:begins + lengths[i]].hex(), fingerprint=prints[i])
            found['goals'] = doubts.get(i, truths)
            if targets[12 + i]:
                found['too_long'] = True
            successors.append(found)
            begins += lengths[i]
        names = ['moves', 'rests', 'ends', 'stops', 'fault', 'error']
        answer = {'follows': names[follows], 'successors': successors}
        return dict(answer, **{k: v for k, v in note.items() if k != 'index'})

    def run(self, goal, choices):
        return self.lines.run(goal, choices)

    def close(self):
        return self.lines.close() or super().close()


class News(Batches):
    """One that tells only of what it has not told before, for two homes. Each third answer is forgotten and told again."""

    def __init__(self, *of):
        super().__init__(*of)
        self.asked = 0
        initial = bytes.fromhex(self.header['initial']['fingerprint'])
        assert [self.meet(initial), self.meet(initial), self.keep(0), self.meet(initial)] == [1, 1, 1, 0]

    def meet(self, fingerprint):
        self.send(5, [], fingerprint)
        return struct.unpack('<2I', self.frame())[1]

    def keep(self, how):
        self.send(6, [how])
        return struct.unpack('<I', self.frame())[0]

    def told(self, data):
        self.send(4, [2, len(data)], data)
        return [self.frame() for _ in range(3)]

    def successors(self, state):
        frames = self.told(bytes.fromhex(state))
        self.asked += 1
        if self.asked % 3 == 0:
            self.keep(1)
            again = self.told(bytes.fromhex(state))
            assert again == frames, 'it is told in another way'
        self.keep(0)
        n, homes, text = struct.unpack_from('<3I', frames[0])
        count, follows = struct.unpack_from('<IB', frames[0], 12)
        assert (n, homes, len(frames[0])) == (1, 2, 17 + len(self.header['goals']) + text)
        note = json.loads(frames[0][-text:])['notes'][0] if text else {}
        found = sorted((m for home in (0, 1) for m in self.home(home, frames[1 + home])), key=lambda m: m['choice'])
        names = ['moves', 'rests', 'ends', 'stops', 'fault', 'error']
        answer = {'follows': names[follows], 'successors': found, 'transitions': count}
        return dict(answer, **{k: v for k, v in note.items() if k != 'index'})

    def home(self, home, frame):
        n, size, text = struct.unpack_from('<3I', frame)
        goals, at = len(self.header['goals']), 12 + 16 * n
        sources, choices, lengths = (struct.unpack_from('<%dI' % n, frame, at + 4 * n * k) for k in range(3))
        at += 12 * n
        doubts = {d['index']: d['goals'] for d in json.loads(frame[-text:])['notes']} if text else {}
        begins = at + n + n * goals
        assert sources == (0,) * n and sum(lengths) == size and begins + size + text == len(frame)
        for i in range(n):
            fingerprint = frame[12 + 16 * i:28 + 16 * i]
            assert int.from_bytes(fingerprint[:4], 'little') % 2 == home, 'it is told to another home'
            truths = [bool(t) for t in frame[at + n + i * goals:at + n + (i + 1) * goals]]
            found = {'choice': choices[i], 'fingerprint': fingerprint.hex(), 'goals': doubts.get(i, truths)}
            if frame[at + i]:
                found['too_long'] = True
            yield dict(found, state=frame[begins:begins + lengths[i]].hex())
            begins += lengths[i]


class Search:
    """One exploration. States are numbered as they are found."""

    def __init__(self, filter, most):
        self.filter = filter
        header = filter.header
        self.goals = header['goals']
        self.met = [None] * len(self.goals)  # the state where, or after which, a goal is met
        self.doubts = [False] * len(self.goals)
        self.searches = all(c['plan'] is not None for c in header['checks'])
        self.number, self.states, self.before = {}, [], []
        self.transitions, self.complete, self.most = 0, True, most
        self.too_long = set()
        self.add(header['initial'], None)
        self.explore()

    def add(self, found, before):
        i = len(self.states)
        self.number[found['fingerprint']] = i
        self.states.append(found['state'])
        self.before.append(before)
        if found.get('too_long'):
            self.too_long.add(i)
        for g, truth in enumerate(found['goals']):
            self.look(g, i, truth is True, truth not in (True, False))

    def look(self, goal, state, is_met, is_doubtful):
        if self.met[goal] is None:
            if is_met:
                self.met[goal] = state
            elif is_doubtful:
                self.doubts[goal] = True

    def enough(self):
        checks = self.filter.header['checks']
        return bool(checks) and self.searches and all(m is not None for m in self.met)

    def explore(self):
        i = 0
        while i < len(self.states):
            if self.enough():
                self.complete = False
                return
            if i in self.too_long:
                self.complete = False
            elif not self.expand(i):
                self.complete = False
                return
            i += 1

    def expand(self, i):
        answer = self.filter.successors(self.states[i])
        if answer['follows'] == 'error' or 'error' in answer:
            raise SystemExit('a state that was told is refused: %s' % answer)
        if answer['follows'] == 'fault':
            self.complete = False
            return True
        moves = answer['successors']
        fresh = {m['fingerprint'] for m in moves if m['fingerprint'] not in self.number}
        if 'transitions' in answer and len(fresh) < len(moves):
            raise SystemExit('something is told that is known: %s' % answer)
        if len(self.states) + len(fresh) > self.most:
            return False
        self.transitions += answer.get('transitions', len(moves))
        for k, m in enumerate(moves):
            if m['fingerprint'] not in self.number:
                self.add(m, (i, m.get('choice', k)))
        for g, ahead in enumerate(answer.get('ahead', [])):
            if ahead:
                self.look(g, i, ahead['met'] is not None, ahead['doubt'] is not None)
        return True

    def choices(self, i):
        found = []
        while self.before[i] is not None:
            i, k = self.before[i]
            found.append(k)
        return found[::-1]

    def verdict(self, plan):
        """True, False, or None where it is not known."""
        if plan is None:
            return None
        (kind, of), = plan.items()
        if kind == 'now':
            return of if of in (True, False) else None
        if kind in ('possibly', 'always'):
            sought = kind == 'possibly'
            if self.met[of] is not None:
                return sought
            return (not sought) if self.complete and not self.doubts[of] else None
        parts = [self.verdict(p) for p in of]
        decisive = kind == 'any'
        return decisive if decisive in parts else None if None in parts else not decisive


FRAMINGS = {'lines': Filter, 'batches': Batches, 'news': News}


def checked(scc, model, states, folder, *options):
    command = [scc, 'check', model, '--no-reduce', 'order,draws', '--json', '--states', str(states), '--witness', folder, *options]
    return json.loads(subprocess.run(command, stdout=subprocess.PIPE).stdout)


def kind_of(verdict, plan):
    """What check calls it: a bound that was given is no proof, and what is never met up to it is no doubt."""
    return {True: ('holds',), False: ('violated',), None: ('undecided', 'holds-up-to-bound')}[verdict]


def differences(scc, path, states, make):
    """What differs; None where the model is not one to compare: not loaded, with more than searches, or bounds of time."""
    with tempfile.TemporaryDirectory() as folder:
        report = checked(scc, path, states, folder)
        if 'explored' not in report:
            return None
        first = make(scc, path, 1)
        if first.header is None:
            return None
        searches, filters = [], [first]
        for k in range(2, first.header['explorations'] + 1):
            filters.append(make(scc, path, k))
        served = all(f.header['horizon'] is None and all(g['within'] is None for g in f.header['goals'])
                     and (report['explored']['complete'] or all(c['plan'] is not None for c in f.header['checks']))
                     for f in filters)
        if not served:
            for f in filters:
                f.close()
            return None
        wrong = []
        searches = [Search(f, states) for f in filters]
        here = [sum(len(s.states) for s in searches), sum(s.transitions for s in searches), all(s.complete for s in searches)]
        there = [report['explored'][k] for k in ('states', 'transitions', 'complete')]
        if here != there:
            wrong.append('states, transitions, complete: %s, and check has %s' % (here, there))
        verdicts = {p['name']: p for p in report['properties']}
        for s in searches:
            for c in s.filter.header['checks']:
                if c['plan'] is None or c['premise']:
                    continue
                verdict = s.verdict(c['plan'])
                there = verdicts[c['name']]['verdict']['kind'] if isinstance(verdicts[c['name']]['verdict'], dict) \
                    else verdicts[c['name']]['verdict']
                if there not in kind_of(verdict, c['plan']):
                    wrong.append('%s: %s, and check says %s' % (c['name'], verdict, there))
                (kind, goal), = c['plan'].items()
                if kind in ('possibly', 'always') and s.met[goal] is not None:
                    wrong += same_run(s, c['name'], goal, folder)
        for f in filters:
            if f.close() != 0:
                wrong.append('the filter does not end well')
        return wrong


def same_run(search, name, goal, folder):
    answer = search.filter.run(goal, search.choices(search.met[goal]))
    if 'error' in answer:
        return ['%s: the run is refused: %s' % (name, answer['error'])]
    with open(os.path.join(folder, name + '.json'), encoding='utf-8') as f:
        there = json.load(f)
    here = answer['schedule']
    if here != there or answer['check'] != name:
        return ['%s: another run than that of check: %s, %s' % (name, here, there)]
    return []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('scc')
    parser.add_argument('models', nargs='+')
    parser.add_argument('--states', type=int, default=3000)
    parser.add_argument('--least', type=int, default=0)
    parser.add_argument('--framing', choices=sorted(FRAMINGS), default='lines')
    parser.add_argument('--verbose', action='store_true')
    given = parser.parse_args()
    compared, failed = 0, 0
    for path in given.models:
        wrong = differences(given.scc, path, given.states, FRAMINGS[given.framing])
        if given.verbose:
            print(path, 'not compared' if wrong is None else 'same' if not wrong else 'DIFFERS', flush=True)
        if wrong is not None:
            compared += 1
            failed += bool(wrong)
            for text in wrong:
                print('%s: %s' % (path, text))
    print('%d models compared, %d differ' % (compared, failed))
    sys.exit(1 if failed or compared < given.least else 0)


if __name__ == '__main__':
    main()
