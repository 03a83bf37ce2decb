#!/usr/bin/env python3
"""The pages of scc view in a browser: browser_test.py SCC WORK [K], with each K-th model, 1 unless told. The last line is
'N passed, N failed'.

Everything that a page shows is held against scc trace, which makes it by other means: states of the kernel, not
what has changed since an earlier one. Ends with 3 if there is no browser.
"""
import glob
import os
import random
import re
import sys
import traceback
from fractions import Fraction

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import browser  # noqa: E402

TALLY = {'passed': 0, 'failed': 0}


def check(what, holds, told=''):
    TALLY['passed' if holds else 'failed'] += 1
    if not holds:
        print(f'failed: {what} {told}', flush=True)
    return holds


def same(what, found, expected):
    return check(what, found == expected, f'\n  found    {str(found)[:600]}\n  expected {str(expected)[:600]}')


def exact(vector):
    return [Fraction(x) for x in vector]


def bodies_of_page(state):
    return {name: (exact(body['position']), exact(body['velocity']), body['behaviour'])
            for name, body in state['bodies'].items()}


def bodies_of_trace(line):
    return {leaf['name']: (exact(leaf['position']), exact(process['velocity']), leaf['behaviour'])
            for process in line['state']['processes'] for leaf in process['leaves']}


# Reads the states of a run in one go: of each position, what the page tells.
WALK = '''
scc.open(arguments[0]);
const all = [];
for (let k = 0; k <= arguments[1]; k++) {
  scc.go(k);
  all.push(scc.state());
}
return all;
'''


def hold_against_trace(name, states, lines):
    """Whether states of the page are those of a trace, one by one."""
    for k, (state, line) in enumerate(zip(states, lines)):
        if Fraction(state['time']) != Fraction(line['time']):
            return same(f'{name}: time after {k} steps', state['time'], line['time'])
        if bodies_of_page(state) != bodies_of_trace(line):
            return same(f'{name}: state after {k} steps', bodies_of_page(state), bodies_of_trace(line))
    return same(f'{name}: number of states', len(states), len(lines))


def steps_of(run):
    """The steps of a run up to where nothing happens any more; after that, time alone is told to pass."""
    return [step for step in run.get('steps') or [] if not step.get('tail')]


def runs(b, scc, model, data):
    """Every run of the page, event by event, against scc trace."""
    seen = set()
    for at, entry in enumerate(b.js('return scc.runs()')):
        run = data['runs'][entry['index']]
        steps = steps_of(run)[:60]
        key = (run['start'], tuple((step['to'], step['label']) for step in steps))
        if key in seen or len(seen) == 5:
            continue
        seen.add(key)
        lines = scc.trace(model, data, steps, run.get('values'))
        name = f'{os.path.basename(model)}, run {run["name"]}'
        hold_against_trace(name, b.js(WALK, at, len(steps)), lines)


def alternatives(b, scc, model, data):
    """Choices that a run did not take, against scc trace."""
    tried = 0
    for at, entry in enumerate(b.js('return scc.runs()')):
        run = data['runs'][entry['index']]
        state = run['start']
        steps = steps_of(run)
        for k, step in enumerate(steps):
            possible = data['states'][state]['next'] or []
            others = [i for i, one in enumerate(possible) if i != step['choice'] and one['to'] is not None]
            if others and tried < 3:
                tried += 1
                choice = others[-1]
                b.js('scc.open(arguments[0]); scc.go(arguments[1])', at, k)
                way = steps[:k] + [{'choice': choice, 'label': possible[choice]['label']}]
                name = f'{os.path.basename(model)}, run {run["name"]}, choice {choice} after {k} steps'
                check(f'{name} is possible', b.js('return scc.choose(arguments[0])', choice))
                line = scc.trace(model, data, way, run.get('values'))[-1]
                same(name, bodies_of_page(b.state()), bodies_of_trace(line))
            state = step['to']
        if tried >= 3:
            return


# The exact state and the floats of the scene at times of the first choices.
AT = '''
scc.open(scc.runs().findIndex((run) => run.name === "first choices"));
return arguments[0].map((time) => {
  scc.seek(time);
  return [scc.state(), scc.floats()];
});
'''


def instants(b, scc, model, data, chance):
    """Between events: what the page shows against scc trace --time, exact, and to the last float."""
    run = next((run for run in data['runs'] if run['name'] == 'first choices'), None)
    if run is None:
        return
    ended = sum(Fraction(data['labels'][step['label']].get('duration') or 0) for step in steps_of(run))
    times = sorted(Fraction(chance.randrange(1, 2**20), 2**20) * ended for _ in range(1))
    states = b.js(AT, [str(time) for time in times]) if ended > 0 else []
    for time, (state, floats) in zip(times, states):
        name = f'{os.path.basename(model)} at {time}'
        line = scc.trace(model, data, None, None, '--time', str(time), '--states', 'ends')[-1]
        # Behaviours that wait are told as they were at the last event.
        expected = {body: at[:2] for body, at in bodies_of_trace(line).items()}
        found = {body: at[:2] for body, at in bodies_of_page(state).items()}
        if same(f'{name}, time', Fraction(state['time']), Fraction(line['time'])) and same(name, found, expected):
            same(f'{name}, in floats', floats, {body: [float(x) for x in at[0]] for body, at in expected.items()})


# Without a graphics card, drawing is what takes the time: of so many models one is drawn.
DRAWN = 8


def models(scc, every):
    """Models of the project; most of them by the texts and lists of their pages alone."""
    chance = random.Random(16)
    drawing, plain = browser.Browser(640, 480), browser.Browser(640, 480, flags=browser.WITHOUT_SCENES)
    try:
        for k, model in enumerate(sorted(glob.glob('specs/models/*.sc'))[::every]):
            one_model(plain if k % DRAWN else drawing, scc, model, chance)
    finally:
        drawing.quit()
        plain.quit()


# Where the page is when a run is opened, and whether that is the end of it.
OPENED = 'scc.open(arguments[0]); const { legs, time } = scc.state(); return [legs, time];'


# How runs end that decide a check; others are runs from a start about which a verdict is.
DECISIVE = ('state', 'instant', 'rests', 'stops', 'repeats', 'passes', 'goes_on')


def ends(b, model, data):
    """A run that is shown for a violated check is opened at the instant that the text about its end names."""
    for at, entry in enumerate(b.js('return scc.runs()')):
        run = data['runs'][entry['index']]
        if not run['check'] or run['check']['verdict'] != 'violated' or run['finish'] not in DECISIVE:
            continue
        legs, time = b.js(OPENED, at)
        name = f'{os.path.basename(model)}, end of {run["name"]}'
        same(f'{name}: steps', legs, len(steps_of(run)))
        named = re.search(r'ends at time (\S+)$|, until time (\S+)$', run['ending'][0] if run['ending'] else '')
        if named and re.fullmatch(r'-?[0-9/]+', named[1] or named[2]):
            same(f'{name}: time', Fraction(time), Fraction(named[1] or named[2]))


def one_model(b, scc, model, chance):
    name = os.path.basename(model)
    page = scc.view(model)
    if not check(f'{name}: the page opens', b.open(page), b.complaints()):
        return
    data = b.js('return scc.data')
    ends(b, model, data)
    runs(b, scc, model, data)
    alternatives(b, scc, model, data)
    instants(b, scc, model, data, chance)
    same(f'{name}: the console is told nothing', b.complaints(), [])


def told(part, *arguments):
    try:
        part(*arguments)
    except Exception:  # the other parts are still told
        traceback.print_exc()
        check(part.__name__, False)


def main():
    os.makedirs(sys.argv[2], exist_ok=True)
    scc = browser.Program(os.path.abspath(sys.argv[1]), sys.argv[2])
    lacking = browser.missing()
    if lacking:
        print(lacking)
        sys.exit(3)
    import frailties
    import pages
    import pictured
    import scenes
    import simulated
    import walk
    told(models, scc, int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    b = browser.Browser()
    try:
        for part in pages.PARTS + scenes.PARTS + pictured.PARTS + frailties.PARTS + simulated.PARTS + walk.PARTS:
            told(part, b, scc)
    finally:
        b.quit()
    pages.without_webgl(scc)
    print(f'{TALLY["passed"]} passed, {TALLY["failed"]} failed')
    sys.exit(1 if TALLY['failed'] else 0)


if __name__ == '__main__':
    # The other files of the tests name this one.
    sys.modules['browser_test'] = sys.modules['__main__']
    main()
