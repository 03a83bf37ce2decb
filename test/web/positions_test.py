"""Where the page puts bodies, against scc trace: at some instants of every model. And where the runs of its checks end,
against what their verdicts say (ends_test.py).

    positions_test.py SCC WORK

The exact places and rotations have to be those of the state, and the floats that are drawn the nearest ones to them,
relative to whatever is looked at. The last line is 'N passed, N failed', of models and of their ends.
"""

import json
import random
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

from ends_test import ends

ROOT = Path(__file__).resolve().parents[2]
INSTANTS = 6
TARGETS = [[Fraction(0)] * 3, [Fraction(10, 3), Fraction(-7, 3), Fraction(1, 3)], [Fraction(10**40, 7), Fraction(1, 7), Fraction(0)]]


def matrix(quaternion):
    """The rotation of an integer quaternion, by rows."""
    w, x, y, z = (int(q) for q in quaternion)
    n = w * w + x * x + y * y + z * z
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return [Fraction(m, n) for row in rows for m in row]


def last_state(scc, model, *options):
    """The state that a run ends with, and at which time that is."""
    arguments = [scc, 'trace', model, '--start', 'simple', '--states', 'ends', *options]
    lines = subprocess.run(arguments, capture_output=True, text=True).stdout.splitlines()
    states = [json.loads(line) for line in lines]
    return [s for s in states if 'state' in s][-1]['state'], Fraction(states[-1]['time'])


def state_at(scc, model, time, choices, over, schedule):
    """The state that a run of so many choices (the first ones, until a time) has at a time."""
    if time <= over:
        options = ['--time', str(time)]
    else:
        choices = [{'choice': 0} for _ in range(choices)]
        offset = time - over
        schedule.write_text(json.dumps({'format': 'scc-schedule', 'version': 1, 'choices': choices,
                                        'offset': f'{offset.numerator}/{offset.denominator}'}))
        options = ['--schedule', str(schedule)]
    state, end = last_state(scc, model, *options)
    return state if end == time else None


def faults(found, state):
    """What differs at one instant, in words."""
    told = {leaf['name']: leaf for process in state['processes'] for leaf in process['leaves']}
    if set(told) != set(found):
        yield f'bodies {sorted(found)} and not {sorted(told)}'
        return
    for name, leaf in told.items():
        place = found[name]
        position = [Fraction(x) for x in leaf['position']]
        turned = matrix(leaf.get('turned', ['1', '0', '0', '0']))
        if [Fraction(x) for x in place['position']] != position:
            yield f'{name} is at {place["position"]}, and not at {leaf["position"]}'
        if [Fraction(x) for x in place['matrix']] != turned:
            yield f'{name} is turned otherwise'
        for target, floats in zip(TARGETS, place['floats']):
            # A quotient of integers is rounded right.
            if floats[:3] != [float(x - t) for x, t in zip(position, target)]:
                yield f'{name} is drawn at {floats[:3]}'
            if floats[3:] != [float(m) for m in turned]:
                yield f'{name} is drawn turned otherwise'


def check(scc, model, work):
    """What is wrong with a model, in words; at how many instants it was looked at; and what is said of its ends."""
    data = work / (model.stem + '.json')
    made = subprocess.run([scc, 'view', '--data', '--seconds', '300', '--graph', '0', str(model), '-o', str(data)],
                          capture_output=True, text=True)
    if made.returncode != 0:
        return [made.stderr], 0, ([], 0, 0)
    return *bodies(scc, model, work, data), ends(ROOT, data)


def bodies(scc, model, work, data):
    """What is wrong with the places of bodies, in words; and at how many instants they were looked at."""
    document = json.loads(data.read_text())
    index = next(i for i, run in enumerate(document['runs']) if run['name'] == 'first choices')
    run = document['runs'][index]
    durations = [Fraction(document['labels'][s['label']].get('duration', '0')) for s in run['steps']]
    end = sum(durations, Fraction(0)) + Fraction(run['rest'])
    generator = random.Random(model.stem)
    times = [end * Fraction(generator.randrange(1, 99991), 99991) for _ in range(INSTANTS)]
    answer = subprocess.run(['node', str(ROOT / 'test/web/positions.js'), str(ROOT / 'web'), str(data), str(index)]
                            + [str(t) for t in times], capture_output=True, text=True)
    if answer.returncode != 0:
        return [answer.stderr], 0
    steps = [(s, d) for s, d in zip(run['steps'], durations) if 'tail' not in s]
    over = sum((d for _, d in steps), Fraction(0))
    wrong, looked = [], 0
    for time, found in zip(times, json.loads(answer.stdout)):
        state = state_at(scc, str(model), time, len(steps), over, work / (model.stem + '.schedule.json'))
        if state is None:
            wrong.append(f'no trace ends at {time}')
        else:
            looked += 1
            wrong += [f'at {time}: {fault}' for fault in faults(found, state)]
    return wrong, looked


def main():
    if hasattr(sys, 'set_int_max_str_digits'):
        sys.set_int_max_str_digits(0)  # places of bodies may be longer
    scc, work = sys.argv[1], Path(sys.argv[2])
    models = sorted((ROOT / 'specs/models').glob('*.sc')) + sorted((ROOT / 'specs/models/laws').glob('*.sc'))
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda model: check(scc, model, work), models))
    failed, read, said = 0, 0, 0
    for model, (wrong, _, (ended, known, all_facts)) in zip(models, results):
        read, said = read + known, said + all_facts
        for faults_of in (wrong, ended):
            if faults_of:
                failed += 1
                print(f'{model.stem}: ' + '; '.join(faults_of[:3]))
    # Facts of a form that is not read are few.
    few = 5 * read < 4 * said
    print(f'bodies were looked at at {sum(looked for _, looked, _ in results)} instants')
    print(f'{read} facts of {said} were read at the ends of runs' + (': too few' if few else ''))
    print(f'{2 * len(models) - failed} passed, {failed + few} failed')


if __name__ == '__main__':
    main()
