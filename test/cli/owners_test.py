#!/usr/bin/env python3
"""Explores models by several owners (`scc successors --owner K/N`), and compares with `scc check --no-reduce order,draws`:
the numbers of states and transitions, the depth, the verdicts, and the runs that show them; probabilities and means,
number by number. In the order of time, with `scc check --shortest time`. With --each, each property by itself: most
explorations end early then. With --evaluated N, so many properties at least must have been more than searches.

    owners_test.py SCC [--states N] [--least N] [--evaluated N] [--owners N,...] [--order levels|time|any] [--each] MODEL ...

What is done here of owners is what specs/successors.md says, and no more.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

from successors_test import Filter, checked, kind_of


class Owners:
    """All owners of one exploration."""

    def __init__(self, scc, model, exploration, count, arguments=()):
        command = [scc, 'successors', model, '--exploration', str(exploration), *arguments]
        self.processes = [subprocess.Popen([*command, '--owner', '%d/%d' % (k + 1, count)], stdin=subprocess.PIPE,
                                           stdout=subprocess.PIPE) for k in range(count)]
        self.headers = [json.loads(p.stdout.readline() or 'null') for p in self.processes]
        self.header = self.headers[0]
        self.kept = []

    def explore(self, restore=(), **asked):
        ports = [h['owner']['port'] for h in self.headers]
        asked = dict({'peers': ['127.0.0.1:%d' % port for port in ports], 'secret': 'a secret', 'run': '1', 'order': 'levels'}, **asked)
        for k, p in enumerate(self.processes):
            mine = dict(asked, restore=restore[k]) if restore else asked
            p.stdin.write(json.dumps(mine).encode() + b'\n')
            p.stdin.flush()
        for line in self.processes[0].stdout:
            told = json.loads(line)
            if 'found' in told:
                return told
            if 'kept' in told:
                self.kept.append(told)
                # It may keep another level.
                self.processes[0].stdin.write(b'\n')
                self.processes[0].stdin.flush()
        raise SystemExit('the first owner has ended: %s' % self.close())

    def close(self):
        """The exit codes."""
        for p in self.processes:
            p.stdin.close()
        rests = [p.stdout.read() for p in self.processes[1:]]
        self.kept += [json.loads(line) for rest in rests for line in rest.splitlines()]
        return [p.wait() for p in self.processes]

    def stop(self):
        for p in self.processes:
            p.kill()
            p.wait()
            p.stdin.close()
            p.stdout.close()


def verdict(plan, found, runs):
    """True, False, or None where it is not known."""
    if plan is None:
        return None
    (kind, of), = plan.items()
    if kind == 'now':
        return of if of in (True, False) else None
    if kind in ('possibly', 'always'):
        sought = kind == 'possibly'
        if of in runs:
            return sought
        return (not sought) if of not in found['open'] and of not in found['doubts'] else None
    parts = [verdict(p, found, runs) for p in of]
    decisive = kind == 'any'
    return decisive if decisive in parts else None if None in parts else not decisive


def served(header, order):
    """Without bounds of time, unless that is the order."""
    bounded = header['horizon'] is not None or any(g['within'] is not None for g in header['goals'])
    return order == 'time' or not bounded


#: How many properties were compared that are more than searches.
evaluated = 0


def concluded(header, found, there):
    """What is wrong with the verdicts of properties that are more than searches. They have no runs."""
    global evaluated
    wrong = []
    known = {c['check']: c for c in found.get('conclusions', [])}
    for k, check in enumerate(header['checks']):
        if check['plan'] is not None or check['premise']:
            continue
        here, said = known[k], there[check['name']]
        evaluated += 1
        if (here['verdict'], here.get('values')) != (said['verdict'], said.get('values')):
            wrong.append('%s: %s, and check says %s' % (check['name'], here, said['text']))
    return wrong


def compared(scc, path, there, count, order, states, folder, named=()):
    """What one exploration finds, and what is wrong with it; None where it is not one to compare."""
    number, last = 0, 1
    sums, wrong, early = [0, 0, 0, True], [], False
    while number < last:
        number += 1
        owners = Owners(scc, path, number, count, named)
        if owners.header is None:
            owners.stop()
            return None
        last = owners.header['explorations']
        if not served(owners.header, order):
            owners.stop()
            return None
        found = owners.explore(order=order, states=states, evaluate=True)
        codes = owners.close()
        if any(codes):
            wrong.append('exit codes %s' % codes)
        explored, runs = found['found'], {r['goal']: r['choices'] for r in found['runs']}
        complete = found['stopped'] is None and not found['faults'] and not found['too_long']
        sums = [sums[0] + explored['states'], sums[1] + explored['transitions'], max(sums[2], explored['depth']), sums[3] and complete]
        if order != 'any' and (owners.header['explorations'] == 1 or found['cycle'] is not None):
            wrong += cycle_differs(scc, path, number, found['cycle'], there['zeno'], named)
        early = early or found['stopped'] == 'early' and any(c['plan'] is None for c in owners.header['checks'])
        if order != 'any' or complete:
            wrong += concluded(owners.header, found, {p['name']: p for p in there['properties']})
        verdicts = {p['name']: p['verdict'] for p in there['properties']}
        for c in owners.header['checks']:
            if c['plan'] is None or c['premise']:
                continue
            here, said = verdict(c['plan'], found, runs), verdicts[c['name']]
            said = said['kind'] if isinstance(said, dict) else said
            if said not in kind_of(here, c['plan']) and not (order == 'any' and states and not complete):
                wrong.append('%s: %s, and check says %s' % (c['name'], here, said))
            (kind, goal), = c['plan'].items()
            if kind in ('possibly', 'always') and goal in runs:
                wrong += replayed(scc, path, number, c['name'], goal, runs[goal], folder, order, named)
    # What is more than a search may end scc check earlier or later.
    early = early or there['explored']['decided_early']
    if not early and order != 'any' or there['explored']['complete'] and sums[3]:
        names = ['states', 'transitions', 'depth', 'complete']
        for name, here in zip(names, sums):
            if here != there['explored'][name] and not (name == 'depth' and order != 'levels'):
                wrong.append('%s: %s, and check has %s' % (name, here, there['explored'][name]))
    return wrong


def cycle_differs(scc, path, exploration, found, there, named):
    """Of a cycle in which no time passes: whether it is that of check, in numbers and labels."""
    if found is None or there is None:
        return [] if found is there else ['a cycle without time: %s, and check has %s' % (found, there and there['cycle'])]
    lines = Filter(scc, path, exploration, named)
    answer = lines.ask(json.dumps({'cycle': found['from'], 'choices': found['choices']}))
    lines.close()
    if 'error' in answer:
        return ['the cycle is refused: %s' % answer['error']]
    here = [choice['label'] for choice in answer['schedule']['choices']]
    same = answer['cycle'] == there['cycle'] and here == [step['label']['text'] for step in there['steps']]
    return [] if same else ['another cycle than that of check']


def replayed(scc, path, exploration, name, goal, choices, folder, order, named):
    """Whether the run is one, and the same as that of check where owners go in step."""
    lines = Filter(scc, path, exploration, named)
    answer = lines.run(goal, choices)
    lines.close()
    if 'error' in answer:
        return ['%s: the run is refused: %s' % (name, answer['error'])]
    if order == 'any':
        return []
    with open(os.path.join(folder, name + '.json'), encoding='utf-8') as f:
        there = json.load(f)
    return [] if answer['schedule'] == there and answer['check'] == name else ['%s: another run than that of check' % name]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('scc')
    parser.add_argument('models', nargs='+')
    parser.add_argument('--states', type=int, default=3000)
    parser.add_argument('--least', type=int, default=0)
    parser.add_argument('--evaluated', type=int, default=0)
    parser.add_argument('--owners', default='1,2,3')
    parser.add_argument('--order', choices=['levels', 'time', 'any'], default='levels')
    parser.add_argument('--each', action='store_true')
    parser.add_argument('--verbose', action='store_true')
    given = parser.parse_args()
    done, failed = 0, 0
    for path in given.models:
        with tempfile.TemporaryDirectory() as folder:
            shortest = ['--shortest', 'time'] if given.order == 'time' else []
            whole = checked(given.scc, path, given.states, folder, *shortest)
            if 'explored' not in whole:
                continue
            for name in [p['name'] for p in whole['properties']] if given.each else [None]:
                named = [] if name is None else ['--check', name]
                there = checked(given.scc, path, given.states, folder, *shortest, *named) if named else whole
                for count in map(int, given.owners.split(',')):
                    wrong = compared(given.scc, path, there, count, given.order, given.states, folder, named)
                    if given.verbose:
                        said = 'not compared' if wrong is None else 'DIFFERS' if wrong else 'same'
                        print(path, name or '', count, said, flush=True)
                    if wrong is None:
                        break
                    for text in wrong:
                        print('%s %s, %d owners: %s' % (path, name or '', count, text))
                    failed += bool(wrong)
                else:
                    done += 1
    print('%d %s compared, %d differ; %d verdicts of more than searches' % (
        done, 'properties' if given.each else 'models', failed, evaluated))
    sys.exit(1 if failed or done < given.least or evaluated < given.evaluated else 0)


if __name__ == '__main__':
    main()
