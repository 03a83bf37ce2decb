"""What a person does on a page: by mouse, by keys alone, by addresses, with hostile names, without WebGL."""
import csv
import io
import json
import os
import re
import time
from fractions import Fraction
from urllib.parse import unquote

import browser
from browser import Keys
from browser_test import bodies_of_page, bodies_of_trace, check, same
from scenes import written

HEXOKINASE = 'specs/models/hexokinase.sc'


def focused(b):
    """What has the focus: its mark for tests or its identifier, and whether one sees that it has it."""
    return b.js('''
      const at = document.activeElement, style = getComputedStyle(at);
      return [at.dataset.testid || at.id || at.tagName,
              style.outlineStyle !== "none" && style.outlineWidth !== "0px"]''')


def by_mouse(b, scc):
    """Buttons, lists, the line of time, choices, reasons and rules."""
    b.open(scc.view(HEXOKINASE))
    data = b.js('return scc.data')
    lines = scc.trace(HEXOKINASE, data, data['runs'][-1]['steps'])
    b.js('scc.open(scc.runs().length - 1)')
    for k in range(1, len(lines)):
        b.find('next').click()
        same(f'the button of the next event, {k}', bodies_of_page(b.state()), bodies_of_trace(lines[k]))
    check('the time is shown as an exact number', b.find('time').get_attribute('value') == '2')
    b.find('first').click()
    same('the button of the beginning', b.state()['legs'], 0)

    b.all('[data-testid="events-list"] [data-index="2"]')[0].click()
    same('an event of the list', b.state()['legs'], 2)
    same('the present event is marked', len(b.all('[data-testid="events-list"] [aria-selected="true"]')), 1)
    told = b.wait('''
      const told = document.querySelector("[data-testid=live]").textContent;
      return told.includes("Step 2") && told''')
    check('the present event is told to screen readers', told and 'bind' in told, told)

    b.all('#now [data-testid="rule-Bind"]')[0].click()
    check('the rule of an event', 'Bind' in b.text('rule-head') and 'candidate' in b.text('rule'))

    row = b.all('[data-testid="choices-list"] [role=option]:not([aria-selected=true])')[0]
    label = row.get_attribute('data-label')
    row.click()
    state = b.state()
    check('a choice makes a run of its own', state['way'] is not None and state['legs'] == 3, state)
    step = next(one for one in data['states'][2]['next'] if data['labels'][one['label']]['text'] == label)
    way = data['runs'][-1]['steps'][:2] + [{'choice': None, 'label': step['label']}]
    same('the state of that choice', bodies_of_page(state), bodies_of_trace(scc.trace(HEXOKINASE, data, way)[-1]))

    b.js('document.querySelector("[data-testid=time]").select()')
    b.find('time').send_keys('7/5', Keys.ENTER)
    same('a time that is typed', b.state()['time'], '7/5')
    b.find('tab-details').click()
    b.all('[data-testid="bodies-list"] [data-index="1"]')[0].click()
    same('the exact place of a body', b.text('fact-position'), 'x-9/4= -2.25y8/5= 1.6z0')

    b.find('graph-switch').click()
    same('the states of the graph', len(b.all('[data-testid="graph"] .node')), len(data['states']))
    b.js('document.querySelector("[data-testid=state-9]").dispatchEvent(new MouseEvent("click", {bubbles: true}))')
    same('a state of the graph', b.state()['state'], 9)
    same('the present state is marked in the graph',
         b.js('return [...document.querySelectorAll(".node.here")].map((n) => n.dataset.testid)'), ['state-9'])
    same('the console is told nothing', b.complaints(), [])


NODES = 'return document.querySelectorAll("[data-testid=graph] .node").length'


def graphs(b, scc):
    """The graph around the present state, states in a row as one, probabilities, and a map of many states."""
    b.open(scc.view('specs/models/ruin.sc'))
    data = b.js('scc.open(scc.runs().length - 1); scc.go(0); return scc.data')
    b.find('graph-switch').click()
    same('few states are all drawn', b.js(NODES), len(data['states']))
    b.pick('graph-show', 'near')
    for k in [1, 2]:
        b.pick('graph-steps', str(k))
        now = b.state()['state']
        near = {now}
        for ways in [lambda n: {one['to'] for one in data['states'][n]['next']},
                     lambda n: {m for m, s in enumerate(data['states']) if any(one['to'] == n for one in s['next'])}]:
            edge = {now}
            for _ in range(k):
                edge = set().union(*map(ways, edge)) - {None}
                near |= edge
        drawn = {int(name[6:]) for name in b.js(
            'return [...document.querySelectorAll("[data-testid=graph] .node")].map((n) => n.dataset.testid)')}
        same(f'the states within {k} steps', drawn, near)
    b.js('scc.go(2)')
    same('it follows the present state', b.js('return document.querySelector(".node.here").dataset.testid'),
         f'state-{b.state()["state"]}')
    b.pick('graph-show', 'all')
    words = b.js('return [...document.querySelectorAll(".edge-text")].map((text) => text.textContent)')
    check('probabilities are at edges', '3/5' in words and '2/5' in words, words)
    b.find('graph-labels').click()
    words = b.js('return [...document.querySelectorAll(".edge-text")].map((text) => text.textContent)')
    check('and what happens there, on demand', any('walker draws' in text for text in words), words)
    meet = b.js('''
      const all = [...document.querySelectorAll(".edge-text, .node circle")].map((one) => one.getBoundingClientRect());
      const words = [...document.querySelectorAll(".edge-text")].length;
      return all.slice(0, words).filter((a, i) => all.some((b, k) => k > i &&
        a.left + 2 < b.right && b.left + 2 < a.right && a.top + 3 < b.bottom && b.top + 3 < a.bottom)).length;''')
    same('words do not cover each other', meet, 0)
    note = b.text('graph-note')
    check('why scc check counts otherwise is told', note.startswith('All 18 states') and 'scc check counts' in note, note)
    b.find('graph-legend').click()
    legend = b.js('return document.querySelector(".graph-legend").textContent')
    check('a legend', 'a draw by chance' in legend and 'an absorption' in legend and 'a bond' not in legend, legend)
    # A run without choices is a row of states.
    b.open(scc.view('specs/models/billiard.sc', '--graph', '300', '--seconds', '20'))
    b.js('scc.open(scc.runs().length - 1); scc.go(0)')
    b.find('graph-switch').click()
    b.pick('graph-show', 'all')
    pressed = b.find('graph-fold').get_attribute('aria-pressed')
    if pressed == 'false':
        b.find('graph-fold').click()
    folded = b.js(NODES)
    chains = b.js('return [...document.querySelectorAll(".node.chain title")].map((t) => t.textContent)')
    check('states in a row are one node', chains and 'states in a row' in chains[0], chains)
    b.find('graph-fold').click()
    check('and each its own', b.wait(f'return document.querySelectorAll("[data-testid=graph] .node").length > {folded}'))
    # Many states.
    b.open(scc.view('specs/models/glycolysis.sc', '--graph', '5000', '--seconds', '60'))
    b.js('scc.go(0)')
    b.find('graph-switch').click()
    check('of many, what is near', 1 < b.js(NODES) < 100, b.js(NODES))
    b.find('graph-fold').click()
    b.js('window.ticks = 0; setInterval(() => { window.ticks += 1; }, 1)')
    b.pick('graph-show', 'all')
    check('they are laid out beside the page', b.js('return document.querySelector("[data-testid=graph-waiting]") !== null'))
    check('as a map', b.wait('return document.querySelector("[data-testid=graph-map]") !== null'))
    check('on which the page goes on meanwhile', b.js('return window.ticks') > 3)
    wide = b.wait('''
      const box = document.querySelector("[data-testid=graph-map]"), canvas = box.querySelector("canvas");
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const pen = copy.getContext("2d");
      pen.drawImage(canvas, 0, 0);
      const { data } = pen.getImageData(0, 0, copy.width, copy.height), seen = [];
      for (let i = 3; i < data.length; i += 4) if (data[i] > 200) seen.push(((i - 3) / 4) % copy.width);
      return (Math.max(...new Set(seen)) - Math.min(...[...new Set(seen)].filter((x) => x > 16))) / copy.width;''')
    check('the map takes the width of the panel', wide > 0.8, wide)
    b.js('document.querySelector("[data-testid=graph-map]").focus()')
    b.keys(Keys.ARROW_DOWN, Keys.ENTER)
    check('a state of the map', b.state()['state'] != 0, b.state()['state'])
    same('the console is told nothing', b.complaints(), [])


def events(b, scc):
    """The list of events: passings of time folded, kinds, a search, pins, exact times; what is typed wrongly."""
    b.open(scc.view('specs/models/billiard.sc', '--graph', '100', '--seconds', '20'))
    data = b.js('scc.open(scc.runs().length - 1); scc.go(0); return scc.data')
    run = data['runs'][-1]
    kinds = [data['labels'][step['label']]['kind'] for step in run['steps']]
    rows = 'return [...document.querySelectorAll("[data-testid=events-list] .row")].map((row) => Number(row.dataset.index))'
    events = [0] + [k + 1 for k, kind in enumerate(kinds) if kind != 'time' or k + 1 == len(kinds)]
    shown = b.js(rows)
    same('without passings of time', shown, events[:len(shown)])
    b.js('scc.go(1)')
    same('a passing of time is shown at the event before', b.js(
        'return document.querySelector("[data-testid=events-list] .row.here").dataset.index'), '0')
    b.pick('events-kind', 'all')
    shown = b.js(rows)
    same('with them', shown, list(range(len(shown))))
    b.pick('events-kind', 'bounce')
    shown = b.js(rows)
    same('of one kind', shown, [k + 1 for k, kind in enumerate(kinds) if kind == 'bounce'][:len(shown)])
    b.pick('events-kind', '')
    b.find('events-search').send_keys('P and Q')
    words = [data['labels'][data_step['label']]['words'] for data_step in run['steps']]
    found = [k + 1 for k, text in enumerate(words) if 'p and q' in text.lower()]
    shown = b.js(rows)
    check('a search finds some', 0 < len(found) < len(events))
    same('a search', shown, found[:len(shown)])
    same('how many it finds', b.text('events-found'), f'{len(found)} of {len(words) + 1}')
    b.find('events-search').send_keys(Keys.ENTER)
    same('Enter goes to the next one', b.state()['legs'], next(k for k in found if k > 1))
    b.find('events-search').send_keys(' nothing')
    check('nothing is found, and it says so', b.js('return document.querySelector("#events .empty:not([hidden])") !== null'))
    b.js('const box = document.querySelector("[data-testid=events-search]"); box.value = ""; box.dispatchEvent(new Event("input"))')
    at = b.state()['legs']
    b.js('document.querySelector("[data-testid=events-list]").focus()')
    b.keys('p')
    b.js('scc.go(0)')
    b.find(f'pinned-{at}').click()
    same('a pinned event', b.state()['legs'], at)
    b.find('pins').find_element('css selector', '.pin-button').click()
    check('it is pinned no more', not b.find('pins').is_displayed())
    # By bodies, also those that nothing happens to.
    b.open(scc.view('specs/models/enzyme.sc'))
    data = b.js('return scc.data')
    run = next(r for r in data['runs'] if r['name'] == b.state()['run'])
    of = [set(data['labels'][step['label']]['leaves']) for step in run['steps']]
    names = [leaf['name'] for leaf in data['leaves']]
    groups = b.js("""return [...document.querySelectorAll("[data-testid=events-body] optgroup")].map((group) =>
      [...group.children].map((option) => option.textContent))""")
    active = [k for k in range(len(names)) if any(k in one for one in of)]
    idle = [k for k in range(len(names)) if k not in active]
    same('bodies with events, and others', groups, [[names[k] for k in all_] for all_ in (active, idle) if all_])
    b.pick('events-body', str(active[0]))
    shown = b.js(rows)
    same('the events of a body', shown, [k + 1 for k, one in enumerate(of) if active[0] in one][:len(shown)])
    check('a body without events is there', idle)
    b.pick('events-body', str(idle[0]))
    empty = b.js('return document.querySelector("#events .empty:not([hidden])").textContent')
    same('one without any', empty, f'{names[idle[0]]} takes part in no event of this run.')
    same('it is selected', b.js('return new URLSearchParams(scc.link()).get("select")'), str(idle[0]))
    b.find('tab-details').click()
    check('and its place is told', 'position' in b.text('selected'), b.text('selected'))
    b.all(f'[data-testid="bodies-list"] [data-index="{active[0]}"]')[0].click()
    b.find('its-events').click()
    same('from a body to its events', b.js(rows), shown)
    b.pick('events-body', '')
    # Long times.
    long = scc.file('.sc')
    with open(long, 'w', encoding='utf-8') as f:
        f.write('import <solids>\nprocess p = solids.Cube(1) mass 1 velocity (104857601/8576123, 0, 0) [nil]\n'
                'fixed w = solids.Cube(1) at translate (1234567/104, 0, 0)\ncheck c : possibly x(p) > 20\n')
    b.open(scc.view(long))
    b.js('scc.open(scc.runs().length - 1); scc.go(2)')
    exact = b.state()['time']
    check('a long time', len(exact) > 15, exact)
    field = b.js('const box = document.querySelector("[data-testid=time]"); return [box.scrollWidth <= box.clientWidth, box.title]')
    check('it is seen whole', field[0] and field[1].startswith(exact), field)
    time_of = 'return document.querySelector("[data-testid=events-list] .row.here .time").textContent'
    check('in the list as a decimal', b.js(time_of).startswith('≈'), b.js(time_of))
    b.find('events-exact').click()
    same('and whole on demand', b.js(time_of), exact)
    for text, said in [('5,3', 'no number'), ('-1', 'begins at 0'), ('1e30', 'ends at'), ('x', 'no number'), ('1/0', 'no number')]:
        b.js('document.querySelector("[data-testid=time]").select()')
        b.find('time').send_keys(text, Keys.ENTER)
        check(f'{text}: what is wrong is said', said in b.text('time-wrong') and b.find('time-wrong').is_displayed(), b.text('time-wrong'))
    b.js('document.querySelector("[data-testid=time]").select()')
    b.find('time').send_keys('0.1', Keys.ENTER)
    same('a decimal is read as it is', (b.state()['time'], b.find('time-wrong').is_displayed()), ('1/10', False))
    for low, high in [(0, 1), (1000, 1000.0000001), (1e15, 1e15 + 2), (0, 1e-9), (-3, 7)]:
        marks = b.js('return Timeline.labels(Timeline.steps(arguments[0], arguments[1], 9)).map(([, text]) => text)', low, high)
        check(f'ticks from {low} to {high} are different', marks and len(set(marks)) == len(marks), marks)
    same('the console is told nothing', b.complaints(), [])


def found_states(b, scc):
    """States of the graph where a formula holds are lit."""
    b.open(scc.view('specs/models/ruin.sc'))
    b.js('scc.go(0)')
    b.find('graph-switch').click()
    states = b.js('return scc.data.states')
    steps = b.js("""
      return scc.data.states.map((state, n) => [n, Meaning.reached(scc.data, n).seats.size < scc.data.leaves.length])""")
    gone = {n for n, is_gone in steps if is_gone}
    check('somebody is gone in some states', 0 < len(gone) < len(states), gone)
    b.find('graph-search').send_keys('gone(walker)', Keys.ENTER)
    b.wait('return document.querySelector("[data-testid=graph-found]").textContent !== ""')
    lit = b.js('return [...document.querySelectorAll("[data-testid=graph] .node.lit")].map((n) => Number(n.dataset.testid.slice(6)))')
    same('they are lit', set(lit), gone)
    check('and counted', f'in {len(gone)} of {len(states)}' in b.text('graph-found'), b.text('graph-found'))
    b.find('graph-next').click()
    check('one goes to the next', b.state()['state'] in gone, b.state()['state'])
    for text, said in [('x(walker)', 'a number'), ('always gone(walker)', 'whole runs'), ('gone(nobody)', 'nobody'), ('gone(walker', 'expected')]:
        b.find('graph-search').clear()
        b.find('graph-search').send_keys(text, Keys.ENTER)
        check(f'{text}: what is wrong is said', said in b.text('graph-found'), b.text('graph-found'))
    same('then none is lit', b.js('return document.querySelectorAll(".node.lit").length'), 0)
    same('the console is told nothing', b.complaints(), [])


def small(b, scc):
    """The list of runs grows with the window; the legend tells channels from bodies; crowds say what can be plotted."""
    b.open(scc.view(HEXOKINASE))
    hidden = 'const box = document.querySelector(".cards"); return box.scrollHeight - box.clientHeight'
    check('in a low window the list scrolls', b.js(hidden) > 0)
    b.size(1400, 1400)
    b.wait('return innerHeight === 1400')
    check('in a tall one all runs are seen', b.js(hidden) <= 1, b.js(hidden))
    b.size(1400, 900)
    names = b.js("""
      const word = Overlay.prototype.word, seen = [];
      Overlay.prototype.word = function (text, ...more) { seen.push(text); return word.call(this, text, ...more); };
      scc.go(0);
      return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
        Overlay.prototype.word = word;
        done(seen);
      })));""")
    check('a body and a channel of one name', 'atp' in names and 'atp (channel)' in names and '~atp (channel)' in names, names)
    model = scc.file('.sc')
    with open(model, 'w', encoding='utf-8') as f:
        f.write('import <solids>\nfor i in 1..200 { process p[i] = solids.Cube(1) mass 1 velocity (1, 0, 0) at translate (0, 2*i, 0) [nil] }\n'
                'check calm : always energy >= 0 within 1\n')
    b.open(scc.view(model))
    check('a crowd has examples of what to plot', 'x(p[1])' in b.find('plot-input').get_attribute('placeholder'))
    b.find('plot-input').send_keys('distance2(p[1], p[200])', Keys.ENTER)
    same('which is plotted', b.js('return scc.plots().slice(-1)[0].value'), str((2 * 199) ** 2))
    same('the console is told nothing', b.complaints(), [])


def formulas(b, scc):
    """Any number in a page from disk: drawn, exact, in the address, against another one; and what is wrong is said."""
    b.open(scc.view('specs/models/billiard.sc', '--graph', '50', '--seconds', '20'))
    b.js('scc.open(scc.runs().length - 1); scc.go(0)')
    field = b.find('plot-input')
    check('examples name bodies of the model', 'x(p)' in field.get_attribute('placeholder'), field.get_attribute('placeholder'))
    for text in ['x(p) - x(q)', 'distance2(p, q) < 20', 'always x(p) < 9']:
        field.send_keys(text, Keys.ENTER)
    b.js('scc.seek("7/3")')
    told = {one['text']: one for one in b.js('return scc.plots()')}
    p, q = (Fraction(b.state()['bodies'][name]['position'][0]) for name in 'pq')
    same('an exact value', Fraction(told['x(p) - x(q)']['value']), p - q)
    same('what holds or not', (told['distance2(p, q) < 20']['kind'], told['distance2(p, q) < 20']['value'] in '01'), ('state', True))
    same('what is about runs', told['always x(p) < 9']['kind'], 'temporal')
    check('says who judges it', 'scc check' in b.find('plots').text)
    line = b.js('return [...document.querySelectorAll("[data-testid=plots] figure")].map((f) => (f.querySelector(".plot-line") || { getAttribute: () => "" }).getAttribute("d").length)')
    check('they are drawn', all(size > 20 for size in line[-3:-1]), line)
    link = b.js('return scc.link()')
    b.open(b.shown, link)
    same('an address keeps them', [one['text'] for one in b.js('return scc.plots()')][-3:], list(told)[-3:])
    b.find('plots-phase').click()
    check('one number against another', len(b.js('return document.querySelector("[data-testid=phase] .plot-line").getAttribute("d")')) > 100)
    dot = 'return document.querySelector("[data-testid=phase] .plot-dot").getAttribute("transform")'
    before = b.js(dot)
    b.js('scc.go(0)')
    check('with the present instant', b.js(dot) != before, before)
    field = b.find('plot-input')
    for text, mark in [('x(nobody) + 1', 'nobody'), ('x(p) +', '\u00a0'), ('x(p) ; 2', ';'), ('bonds(nothing)', 'nothing'), ('x(p) and true', 'x(p)')]:
        field.clear()
        field.send_keys(text, Keys.ENTER)
        same(f'{text}: what is wrong is marked', b.js('return document.querySelector("[data-testid=plot-wrong] mark").textContent'), mark)
        same('it stays to be mended', field.get_attribute('value'), text)
    b.open(scc.view('specs/models/glycolysis.sc', '--graph', '4', '--seconds', '5'))
    check('without numbers, what one can do is said', 'such as x(' in b.text('plots-none'), b.text('plots-none'))
    same('the console is told nothing', b.complaints(), [])


def reasons(b, scc):
    """A line of the tree of reasons leads to its instant."""
    b.open(scc.view('specs/models/latch.sc', '--check', 'settles'))
    b.js('scc.open(0)')
    b.find('tab-why').click()
    lines = b.all('[data-testid="reasons"] .reason')
    check('there is a tree of reasons', len(lines) >= 2)
    jump = [line for line in lines if line.find_elements('css selector', '.jump')][-1]
    jump.click()
    instant = jump.find_element('css selector', '.jump').text
    same('a reason leads to its instant', 't = ' + b.state()['time'], instant)


LATE = """import <solids>
process p = solids.Cube(1) mass 1 velocity (2, 0, 0) [nil]
process q = solids.Cube(1) mass 1 at translate (0, 5, 0) [nil]
check far : eventually x(p) >= 9 within 3
check near : AG (time >= 1 => AF[<= 2] x(p) >= 30)
check calm : always x(p) >= 0
"""


def deciding(b, scc):
    """The page opens where a violated check is decided; a check without a run shows none of another one."""
    model = scc.file('.sc')
    with open(model, 'w') as f:
        f.write(LATE)
    b.open(scc.view(model))
    same('the bound that is missed', (b.state()['time'], b.state()['bodies']['p']['position'][0]), ('3', '6'))
    b.js('scc.open(1)')
    same('one that begins later', (b.state()['run'], b.state()['time']), ('near', '3'))
    note = b.find('scene-note')
    check('a run needs no note', not note.is_displayed())
    b.all('[data-testid="run"]')[2].click()
    same('a check without a run: the beginning', (b.state()['run'], b.state()['time'], b.state()['legs']),
         ('calm', '0', 0))
    check('it says so', 'no single run' in note.text, note.text)
    changes = 'return [...document.querySelectorAll("[data-testid=change]")].map((line) => line.textContent)'
    same('nothing has changed', b.js(changes), [])
    link = b.js('return scc.link()')
    b.js('scc.open(0)')
    same('what has changed on the way to the bound', b.js(changes), ['p place (0, 0, 0) → (6, 0, 0)'])
    b.open(b.shown, link)
    same('its link leads to it', b.state()['run'], 'calm')
    b.open(scc.view('specs/models/docking.sc'))
    data = b.js('scc.open(scc.runs().length - 1); return scc.data')
    kinds = [data['labels'][step['label']]['kind'] for step in data['runs'][-1]['steps']]
    b.js('scc.go(arguments[0])', kinds.index('bind') + 1)
    lines = b.js(changes)
    check('a bond is made', any(line.endswith('bond none → made') for line in lines), lines)
    check('velocities before and after', any(' velocity (' in line for line in lines), lines)
    many = scc.file('.sc')
    with open(many, 'w') as f:
        f.write('import <solids>\nfor i in 1..50 { process c[i] = solids.Cube(1) mass 1 velocity (i, 0, 0) at '
                'translate (0, 2*i, 0) [nil] }\ncheck far : eventually x(c[50]) >= 900 within 3\n')
    b.open(scc.view(many))
    lines = b.js('return [...document.querySelectorAll(".changes li")].map((line) => line.textContent)')
    same('of many bodies some are listed', (len(lines), lines[0], lines[-1]),
         (13, 'c[1] place (0, 2, 0) → (3, 2, 0)', 'and others'))
    b.open(scc.view('specs/models/meeting.sc'))
    same('the start of a violated check', (b.state()['run'], b.state()['bodies']['p']['position']),
         ('meets', ['0', '-5/2', '0']))
    same('the head names it', b.driver.find_element('id', 'about').text, 'y = -5/2, z = 0')
    b.js('scc.open(scc.runs().findIndex((run) => run.name === "first choices"))')
    same('and follows', b.driver.find_element('id', 'about').text, 'y = 0, z = 0')


UNDECIDED = """import <solids>
motion choose {(1, 0, 0), (-1, 0, 0), (0, 1, 0)}
fixed drain = box(1, 6, 6) absorb at translate (-40, 0, 0)
process a = solids.Cube(1) mass 1 [nil]
process b = solids.Cube(1) mass 1 at translate (6, 1/2, 0) [nil]
check far : possibly x(a) > 1000000
check near : always x(a) < x(b) + 400
check soon : eventually x(a) = 2 within 3
"""

RANGES = """import <solids>
param y in [-2, 4]
process a = solids.Cube(2) mass 1 velocity (1, 0, 0) at translate (0, y, 0) [nil]
process b = solids.Cube(2) mass 1 at translate (6, 0, 0) [nil]
check meets : possibly vx(b) > 0
check gone : possibly x(b) > 9 and y < -5
"""

GROWS = """import <solids>
process p = solids.Cube(1) mass 1 velocity (3/2, 0, 0) [nil]
motion p = (vx*vx - vx/3, 0, 0)
check c : eventually x(p) > 10000000000 within 6
check d : always vx(p) < 3000
"""


def undecided(b, scc):
    """What is undecided says so, and so does a run that does not decide; each run leads to the instant that its facts are about."""
    card = lambda name: b.driver.find_element('css selector', f'[data-run="{name}"]').click()
    note = lambda: b.text('scene-note') if b.find('scene-note').is_displayed() else ''
    b.open(scc.view(written(scc, UNDECIDED), '--states', '2000'))
    card('far')
    check('where a run to what is not explored leads', 'unexplored' in b.text('why'), b.text('why'))
    same('its run needs no note', note(), '')
    last = b.js('return scc.runs().find((run) => run.name === "far")') and b.state()
    b.find('deciding').click()
    check('a press leads there', b.state()['legs'] > last['legs'] and b.state()['time'] != '0', b.state()['time'])
    card('near')
    check('what holds up to a bound is about all runs', 'no single run' in note(), note())
    b.open(scc.view(written(scc, 'import <solids>\nfixed drain = box(1, 6, 6) absorb at translate (6, 0, 0)\n'
                                 'process b = solids.Cube(1) mass 1 velocity (1, 0, 0) [nil]\ncheck all : always x(b) < 100\n')))
    card('all')
    check('without a run, what is undecided is no verdict about all runs',
          note().startswith('It is undecided') and 'A verdict' not in b.text('why'), (note(), b.text('why')))
    b.open(scc.view(written(scc, RANGES)))
    card('meets')
    check('a run that does not decide says so over the scene', note().startswith('No run from there does otherwise'), note())
    card('first choices')
    same('another run does not', note(), '')
    b.find('tab-where').click()
    b.js('const menu = document.querySelector("[data-testid=where-check]"); menu.value = [...menu.options].find((o) => o.text === "gone").value; '
         'menu.dispatchEvent(new Event("change", { bubbles: true }))')
    words = b.js('return document.querySelector(".where-legend").textContent')
    check('what is so everywhere is not so in 1 of the ranges', 'everywhere in the ranges' in words and ' in 1 of' not in words, words)
    # Of a network without bodies, too.
    b.open(scc.view(written(scc, 'network nil\ncheck late : possibly time > 4\n')))
    b.find('deciding').click()
    same('time alone', b.state()['time'], '5')

    b.open(scc.view(written(scc, GROWS)))
    same('long numbers: which run', b.state()['run'], 'c')
    whole = b.js('return scc.data.runs[0].facts.join()')
    check('the file has them whole', re.search(r'\d{25}/\d{25}', whole), whole)
    words = b.text('why') + b.text('now')
    check('they are told by their decimals', '~' in words and not re.search(r'\d{20}', words), words)
    same('the console is told nothing', b.complaints(), [])


def narrow(b, scc):
    """In small windows: the values of the start, the top of the help; everywhere, lists are as wide as their words."""
    page = scc.view('specs/models/meeting.sc')
    for size in [(400, 700), (800, 600), (1400, 900)]:
        b.size(*size)
        b.open(page)
        about = b.driver.find_element('id', 'about')
        same(f'{size}: the start is told', (about.is_displayed(), about.text), (True, 'y = -5/2, z = 0'))
        b.find('help').click()
        same(f'{size}: help begins with its head', b.js('return document.getElementById("keys").scrollTop'), 0)
        b.find('keys-close').click()
        for test in ['events-kind', 'events-body']:
            # Beside the words there is room for the arrow of the list.
            room = b.js("""
              const menu = document.querySelector(`[data-testid="${arguments[0]}"]`), pen = document.createElement("canvas").getContext("2d");
              pen.font = getComputedStyle(menu).font;
              return menu.clientWidth - pen.measureText(menu.selectedOptions[0].text).width;""", test)
            check(f'{size}: {test} shows its words', room > 20, room)
        wide = b.js('return [document.documentElement.scrollWidth, innerWidth]')
        check(f'{size}: nothing is wider than the window', wide[0] <= wide[1], wide)
    b.size(1400, 900)


def contrast(b, scc):
    """From the run of a check to the nearest one that does otherwise, at the step after which they part, and back."""
    b.open(scc.view('specs/models/ruin.sc'))
    names = lambda: b.js('return [...document.querySelectorAll("[data-run]")].map((card) => card.dataset.run)')
    check('the page opens on the violated check', 'ends, otherwise' in names(), names())
    b.js('scc.open(scc.runs().findIndex((run) => run.name === "rich"))')
    check('it is listed beside that alone', 'ends, otherwise' not in names(), names())
    check('none where every run does so', b.js('return document.querySelector("[data-testid=contrast]")') is None)
    b.js('scc.open(scc.runs().findIndex((run) => run.name === "ends"))')
    check('listed beside its check', 'ends, otherwise' in names(), names())
    press = 'document.querySelector("[data-testid=contrast]").click()'
    b.js(press)
    runs = b.js('return scc.data.runs')
    [(k, other)] = [(k, run) for k, run in enumerate(runs) if run.get('contrast') is not None]
    same('where they part', (b.state()['run'], b.state()['legs']), ('ends, otherwise', other['contrast']))
    shared = lambda run: [step['label'] for step in run['steps'][:other['contrast']]]
    same('steps in common', shared(other), shared(runs[k - 1]))
    check('it gets there', 'gone(walker) holds' in b.find('why').text, b.find('why').text)
    b.js(press)
    same('and back', (b.state()['run'], b.state()['legs']), ('ends', other['contrast']))


def starts(b, scc):
    """Where a check holds: another start leads to the run from there."""
    b.open(scc.view('specs/models/meeting.sc'))
    same('all tabs are in one row', len(set(b.js('return [...document.querySelectorAll("#tabs button")].map((t) => t.offsetTop)'))), 1)
    b.find('tab-where').click()
    b.js("""
      const box = document.querySelectorAll('[data-testid=where] .sample')[40].getBoundingClientRect();
      document.querySelector('[data-testid=where]').dispatchEvent(new MouseEvent('click', { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2 }));""")
    run = b.js('return document.querySelector("[data-testid=where] .sample.here").dataset.run')
    first = b.state()
    b.js('document.querySelector("[data-testid=where]").focus()')
    b.keys(Keys.ARROW_UP)
    moved = b.js('return document.querySelector("[data-testid=where] .sample.here").dataset.run')
    check('the arrows lead to another start', run != moved, (run, moved))
    check('a run from there is shown', b.state()['bodies'] != first['bodies'])
    where = b.js('return scc.data.where')
    texts = b.js("""
      return [...document.querySelectorAll('[data-testid=where] .axis')].map((t) => {
        const box = t.getBoundingClientRect();
        return [t.textContent, box.left + box.width / 2, box.top + box.height / 2];
      })""")
    numbers = [(float(text), x, y) for text, x, y in texts if re.fullmatch(r'-?[0-9.]+', text)]
    below = max(y for _, _, y in numbers)
    across = [(value, x) for value, x, y in numbers if abs(y - below) < 2]
    up = [(value, y) for value, x, y in numbers if abs(y - below) >= 2]
    check('numbers stand along both axes', len(across) > 2 and len(up) > 2, texts)
    check('across they grow to the right', sorted(across) == sorted(across, key=lambda one: one[1]), across)
    check('and upwards', sorted(up) == sorted(up, key=lambda one: -one[1]), up)
    ranges = [(float(Fraction(a['low']['value'])), float(Fraction(a['high']['value']))) for a in where['axes']]
    check('all within the ranges', all(low <= value <= high for value, _ in across + up for low, high in [ranges[0] if (value, _) in across else ranges[1]]))
    told = b.js("""
      const svg = document.querySelector('[data-testid=where]'), dot = document.querySelectorAll('[data-testid=where] .sample')[arguments[0]];
      const box = dot.getBoundingClientRect();
      svg.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2 }));
      return document.querySelector('[data-testid=where-told]').textContent;""", 3)
    sample = where['samples'][3]['at']
    check('the start under the pointer is named', all(f'{name} = ' in told for name in sample), told)
    any_start(b, scc)


CLEFT = """model cleft
timestep 1 steady
import <solids>
param d in [0, 3]
param h in [0, 2]
behaviour Site   on solids.Cube(2) = <site, {top}>. nil
behaviour Ligand on solids.Cube(2) = <~site, {bottom}>. nil
fixed membrane   = box(24, 4, 2) at translate (0, 0, -5/2)
fixed receptor   = solids.Cube(2) scaled (1, 1, 1/4) at translate (0, 0, -5/4) [Site]
process ligand   = solids.Cube(2) mass 1 at translate (d, 0, 1/2 + h) [Ligand]
motion ligand    = choose { (1, 0, 0), (-1, 0, 0), (0, 0, 1), (0, 0, -1) }
check binds  : P = ? [ eventually bound(ligand, receptor) within 2 ]
check likely : P >= 1/8 [ eventually bound(ligand, receptor) within 2 ]
"""


def any_start(b, scc):
    """What is so at any start, on borders as well, is what `scc check` says of that start alone."""
    model = scc.file('.sc')
    with open(model, 'w') as f:
        f.write(CLEFT)
    b.open(scc.view(model))
    b.find('tab-where').click()
    # Corners and borders of the regions, and starts within them.
    for d, h in [('0', '1/2'), ('5/2', '1/2'), ('1', '0'), ('2', '1'), ('3', '0.25'), ('1.3', '3/2'), ('7/3', '13/10'), ('3', '2')]:
        for k, text in enumerate([d, h]):
            b.find(f'where-start-{k}').clear()
            b.find(f'where-start-{k}').send_keys(text, *([Keys.ENTER] if k else []))
        verdicts = b.js('return [...document.querySelectorAll("[data-testid=where-verdicts] .judged li")].map((li) => li.textContent)')
        ended = scc.run('check', model, '-D', f'd={d}', '-D', f'h={h}', '--json')
        one = {p['name']: p for p in json.loads(ended.stdout)['properties']}
        value = re.search(r'^binds: (\S+?),?( |$)', scc.run('check', model, '-D', f'd={d}', '-D', f'h={h}').stdout, re.M)[1]
        expected = {'likely': {'holds': 'holds', 'violated': 'fails'}[one['likely']['verdict']], 'binds': value}
        found = {line.split(': ')[0]: line.split(': ')[1].split(' ')[0] for line in verdicts}
        same(f'what is so at d = {d}, h = {h}', found, expected)
    b.pick('where-check', '1')
    colours = b.js('return [...new Set([...document.querySelectorAll("svg.where .area")].map((area) => getComputedStyle(area).fill))]')
    told = b.js('return [...document.querySelectorAll("[data-testid=where-values] li")].map((li) => li.textContent.split(" ")[0])')
    same('each value has a colour and a place in the legend', (len(colours), told), (4, ['0', '1/16', '5/64', '5/16', '3/8']))
    for text, words in [('4', 'd is from 0 to 3'), ('x', 'is no number')]:
        b.find('where-start-0').clear()
        b.find('where-start-0').send_keys(text, Keys.ENTER)
        check(f'{text} is refused', words in b.text('where-wrong') and b.find('where-wrong').is_displayed(), b.text('where-wrong'))
    b.js("""
      const svg = document.querySelector('[data-testid=where]'), box = svg.getBoundingClientRect(), scale = box.width / svg.viewBox.baseVal.width;
      svg.dispatchEvent(new MouseEvent('click', { clientX: box.left + (58 + 248 * 0.8) * scale, clientY: box.top + (8 + 248 * 0.55) * scale }));""")
    check('any place can be clicked', b.js('return document.querySelector("svg.where .cross").getAttribute("visibility")') == 'visible')
    command = b.text('where-command')
    check('and how to see the run from there is told', ' -D d=' in command and ' -D h=' in command, command)
    before = b.state()['bodies']
    b.find('where-nearest').click()
    check('the nearest run is shown', b.state()['bodies'] != before)
    same('the console is told nothing', b.complaints(), [])


def onwards(b, scc):
    """From a choice on by what is possible first, to where the run ends."""
    b.open(scc.view('specs/models/enzyme.sc'))
    data = b.js('return scc.data')
    b.js('scc.open(scc.runs().length - 1)')
    at = next(k for k, step in enumerate(data['runs'][-1]['steps']) if len(b.js(
        'scc.go(arguments[0]); return scc.data.states[scc.state().state].next', k)) > 1)
    b.js('scc.go(arguments[0]); scc.choose(1)', at)
    b.find('go-on').click()
    b.keys(Keys.END)
    state = b.state()
    steps = [{'choice': step['choice'], 'label': step['label']} for step in data['runs'][-1]['steps'][:at]]
    now = data['runs'][-1]['steps'][at - 1]['to'] if at else data['runs'][-1]['start']
    for choice in state['way']['choices']:
        one = data['states'][now]['next'][choice]
        steps.append({'choice': choice, 'label': one['label']})
        now = one['to']
    check('there are more steps', len(steps) > at + 1, len(steps))
    same('where they lead', bodies_of_page(state),
         bodies_of_trace(scc.trace('specs/models/enzyme.sc', data, steps)[-1]))


def far_away(b, scc):
    """Bodies so far from the origin that floats from there could not tell them apart are seen, and plotted."""
    model = scc.file('.sc')
    with open('specs/models/gas.sc', encoding='utf-8') as f:
        shape = f.read().split('shape Cube', 1)[1].split('for i', 1)[0]
    with open(model, 'w', encoding='utf-8') as f:
        f.write('shape Cube' + shape + """
process p = Cube mass 1 velocity (1,0,0)  at translate (1e40, 0, 0) [nil]
process q = Cube mass 1 velocity (-1,0,0) at translate (1e40 + 6, 0, 0) [nil]
check meets : possibly x(q) - x(p) <= 2 and x(p) > 0
""")
    b.open(scc.view(model))
    b.wait('return scc.link().includes("camera=")')
    camera = json.loads(unquote(b.js('return scc.link()').split('camera=', 1)[1].split('&')[0]))
    check('the camera is as far from them as they are large', 5 < camera['distance'] < 100, camera)
    near = Fraction(camera['at'][0]) - 10**40
    check('it looks at them', -2 < near < 8, camera)
    same('nothing is said on the console', b.complaints(), [])
    b.js('scc.go(1)')
    same('nor at another instant', b.complaints(), [])
    # What changes by 1 is seen to change, and what is tiny has its own scale.
    for where, by in [('1e12', '1'), ('0', '1e-9'), ('-1e12', '1')]:
        b.open(scc.view(written(scc, f'process p = box({by}, {by}, {by}) mass 1 velocity ({by}, 0, 0) at translate ({where}, 0, 0) [nil]\n'
                                     f'check c : eventually x(p) > {where} + 9*{by} within 2\n')))
        heights = b.js("""
          const line = document.querySelector("[data-testid=plot-0] path.plot-line").getAttribute("d");
          return line.slice(1).split("L").map((at) => Number(at.split(" ")[1]));""")
        check(f'a change by {by} at {where} is drawn', max(heights) - min(heights) > 30, heights)
        marks = b.js('return [...document.querySelectorAll("[data-testid=plot-0] .plot-tick")].map((t) => t.textContent)')
        check(f'its marks differ, at {where}', len(set(marks)) == len(marks) > 1, marks)


def by_keys(b, scc):
    """Everything without a mouse."""
    b.open(scc.view(HEXOKINASE))
    b.js('scc.open(scc.runs().length - 1); document.body.focus()')
    seen, unseen = [], []
    for _ in range(80):
        b.keys(Keys.TAB)
        name, visible = focused(b)
        if name == 'BODY' or (seen and name == seen[0]):
            break
        seen.append(name)
        if not visible:
            unseen.append(name)
    check('a link of a file says nothing of a machine', 'machine' not in b.find('cite').get_attribute('title'))
    wanted = ['theme', 'help', 'graph-switch', 'plots-switch', 'cite', 'tab-why', 'play', 'next', 'time',
              'timeline', 'choices-list', 'events-list']
    same('the tabulator leads to all', [name for name in wanted if name not in seen], [])
    same('one sees where it is', unseen, [])

    b.js('document.activeElement.blur()')
    b.keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
    same('an arrow leads to the next event', b.state()['legs'], 2)
    b.keys(Keys.ARROW_LEFT)
    same('an arrow leads back', b.state()['legs'], 1)
    b.keys(Keys.END)
    same('the end', b.state()['legs'], b.js('return scc.runs().slice(-1)[0].steps'))
    b.keys(Keys.HOME)
    same('the beginning', b.state()['legs'], 0)
    b.keys(Keys.SPACE)
    check('space plays', b.wait('return scc.state().playing && scc.state().time !== "0"'))
    b.keys(Keys.SPACE)
    check('space pauses', not b.state()['playing'])
    denominator = Fraction(b.state()['time']).denominator
    check('played time is of the grid', 2**20 % denominator == 0, denominator)
    b.keys('.')
    check('a little on in time', Fraction(b.state()['time']) > 0)
    b.keys('+', '+', '-')
    same('the speed', b.text('speed'), '× 2')

    b.keys('?')
    check('the help opens', b.js('return document.querySelector("[data-testid=keys]").open'))
    b.keys(Keys.ESCAPE)
    check('the help closes', not b.js('return document.querySelector("[data-testid=keys]").open'))

    b.keys(Keys.HOME, Keys.ARROW_RIGHT, 'x')
    same('the list of choices has the focus', focused(b)[0], 'choices-list')
    before = b.state()['state']
    b.keys(Keys.ARROW_DOWN, Keys.ENTER)
    state = b.state()
    to = b.js('return scc.data.states[arguments[0]].next[1].to', before)
    check('a choice by keys', state['way'] is not None and state['state'] == to, state)

    b.keys('b', Keys.ARROW_DOWN)
    check('a body by keys', b.js('return document.querySelector("[data-testid=selected] h3") !== null'))
    b.js('document.activeElement.blur()')
    b.keys(Keys.ESCAPE)
    check('nothing is selected', b.js('return document.querySelector("[data-testid=selected] h3") === null'))
    name = b.state()['run']
    b.keys('[')
    check('the run before', b.js('return document.querySelector(".card.here").dataset.run') != name)

    b.keys('g')
    check('the graph opens', b.wait('return !document.getElementById("graph-panel").hidden'))
    b.js('document.querySelector(".node[tabindex=\\"0\\"]").focus()')
    b.keys(Keys.ARROW_DOWN, Keys.ENTER)
    same('a state of the graph by keys', b.js('return document.activeElement.dataset.testid'),
         f'state-{b.state()["state"]}')
    b.js('document.activeElement.blur()')
    for key, tool in [('n', 'names'), ('v', 'velocities'), ('r', 'trails')]:
        b.keys(key)
        same(f'the scene has {tool}', b.find(tool).get_attribute('aria-pressed'), 'true')
    b.keys('o', 'f')
    b.find('spins').click()
    for _ in range(3):
        b.keys(Keys.ARROW_LEFT)
        b.js('return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))')
    b.js('document.activeElement.blur()')
    theme = b.js('return document.documentElement.dataset.theme')
    b.keys('t')
    check('dark and light', b.js('return document.documentElement.dataset.theme') != theme)
    same('the console is told nothing', b.complaints(), [])


def links(b, scc):
    """An address leads to what it was taken from; one that is wrong is told, and does no harm."""
    page = scc.view(HEXOKINASE)
    b.open(page)
    b.js('scc.open(scc.runs().length - 1); scc.go(1); scc.choose(1); scc.go(0, "1/3")')
    b.find('tab-details').click()
    b.all('[data-testid="bodies-list"] [data-index="2"]')[0].click()
    state, link = b.state(), b.js('return scc.link()')
    b.open(page, link)
    same('an address', b.state(), state)
    check('the selection of an address', 'glucose' in b.text('selected'))
    b.open(scc.view('specs/models/hexokinase.sc'))
    for name in ['names', 'trails', 'grid', 'graph-switch', 'plots-phase', 'graph-labels', 'graph-fold']:
        b.find(name).click()
    b.pick('graph-show', 'near')
    b.pick('graph-steps', '2')
    b.find('graph-search').send_keys('bonds() > 0', Keys.ENTER)
    for text in ['x(atp)', 'bonds() + 1']:
        b.find('plot-input').send_keys(text, Keys.ENTER)
    b.find('plots-choose').click()
    b.js('[...document.querySelectorAll(".plot-menu input")][0].click()')
    # The scene is seen anew beside the graph.
    b.js('return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 100))))')
    link = b.js('return scc.link()')
    sight = """return [["names", "trails", "grid", "marks", "graph-switch", "graph-labels", "graph-fold", "plots-phase"].map((name) =>
        document.querySelector(`[data-testid="${name}"]`).getAttribute("aria-pressed")),
      ["graph-show", "graph-steps", "graph-search"].map((name) => document.querySelector(`[data-testid="${name}"]`).value),
      scc.plots().map((plot) => plot.text), document.querySelectorAll(".chart.phase").length,
      document.querySelector("[data-testid=graph-found]").textContent]"""
    b.wait('return document.querySelector("[data-testid=graph-found]").textContent !== ""')
    seen = b.js(sight)
    same('what is switched', seen[:2], [['true', 'true', 'false', 'true', 'true', 'true', seen[0][6], 'true'], ['near', '2', 'bonds() > 0']])
    b.open(b.shown, link)
    b.wait('return document.querySelector("[data-testid=graph-found]").textContent !== ""')
    same('an address has what is switched, the plots and the graph', b.js(sight), seen)
    same('and is the same again', b.js('return scc.link()'), link)
    check('nothing of it is told to be wrong', not b.find('notice').is_displayed(), b.text('notice'))
    b.js('for (let k = 0; k < 12; k++) { const box = document.querySelector("[data-testid=plot-input]"); '
         'box.value = "1" + " + 1".repeat(900 + k); box.form.requestSubmit(); }')
    check('an address has a bounded size', len(b.js('return scc.link()')) <= 16000, len(b.js('return scc.link()')))
    page = scc.view(HEXOKINASE)
    for wrong in ['switched=constructor', 'switched=names.names.__proto__', 'numbers=99', 'numbers=0.x', 'against=2', 'graph=all.open.100',
                  'graph=toString', 'plot=' + 'x' * 5000, 'find=' + '%28' * 5000, 'run=99', 'run=0&step=1e9&time=1/0', 'run=0&way=1.2.3.4.5', 'time=%E0%A4%A', 'camera=%7B',
                  'select=7777', 'select=__proto__', 'run=0&way=99999999999999999999.0', '%', 'x' * 5000]:
        b.open(page, wrong)
        same(f'a wrong address, {wrong[:40]}', b.complaints(), [])
        if '=' in wrong:
            check(f'a wrong address is told, {wrong[:40]}', b.find('notice').is_displayed())


def plots(b, scc):
    """The numbers of the plots, saved: exact, and the floats nearest to them."""
    b.open(scc.view('specs/models/docking.sc'))
    b.js('scc.open(0)')
    text = b.js('''
      let saved = null;
      const create = URL.createObjectURL;
      URL.createObjectURL = (blob) => { saved = blob; return create(blob); };
      document.querySelector("[data-testid=plots-csv]").click();
      URL.createObjectURL = create;
      return saved.text();''')
    rows = list(csv.reader(io.StringIO(text)))
    check('a row for each position of the run', len(rows) >= b.js('return scc.runs()[0].steps') + 2)
    wrong = [row for row in rows[1:] for at in [1, *range(4, len(row), 2)]
             if row[at] and float(row[at + 1]) != float(Fraction(row[at]))]
    same('floats are the nearest', wrong, [])
    drawn = b.js('''
      let saved = null;
      const create = URL.createObjectURL;
      URL.createObjectURL = (blob) => { saved = blob; return create(blob); };
      document.querySelector("[data-testid=plots-svg]").click();
      URL.createObjectURL = create;
      return saved.text();''')
    check('the plots as a drawing', drawn.startswith('<svg xmlns="http://www.w3.org/2000/svg"') and '<path' in drawn,
          drawn[:200])
    for k in range(13):
        b.find('plot-input').send_keys(f'time + {k}', Keys.ENTER)
    last = b.text('plot-note')
    same('no more than so many are shown', len(b.all('figure.plot')), 12)
    check('and which one is left out is told', 'time + 0.' in last and b.find('plot-note').is_displayed(), last)
    b.find('plot-input').send_keys('time + 12', Keys.ENTER)
    check('a plot again leaves none out', not b.find('plot-note').is_displayed())
    b.find('plots-choose').click()
    b.js('[...document.querySelectorAll(".plot-menu label")].find((one) => one.textContent === "time + 0").querySelector("input").click()')
    check('nor is one left out in silence that is chosen', 'time + 1.' in b.text('plot-note'), b.text('plot-note'))


def upright(b, scc):
    """Another axis points up: the floor lies below the bodies along it, the address says so, and the button too."""
    page = scc.view('specs/models/gravity.sc')
    b.open(page)
    same('y is up at first', (b.find('up').text, b.js('return scc.look().up')), ('Up: y', 'y'))
    for axis, at in [('z', 2), ('x', 0), ('y', 1), ('z', 2)]:
        b.js('document.activeElement.blur()')
        b.keys('u')
        look = b.js('return scc.look()')
        same(f'{axis} is up', (b.find('up').text, look['up']), (f'Up: {axis}', axis))
        ball = Fraction(b.state()['bodies']['ball']['position'][at])
        check(f'the floor is below the body along {axis}', ball - 8 <= Fraction(look['floor']) < ball, (ball, look))
        check(f'one looks from above, along {axis}', 0 < look['from'][at] < 1, look)
    b.find('projection').click()
    link, floor = b.js('return scc.link()'), look['floor']
    b.open(page, link)
    same('an address keeps the axis', (b.find('up').text, b.find('projection').text), ('Up: z', 'Parallel'))
    look = b.js('return scc.look()')
    same('and the floor', (look['up'], look['floor']), ('z', floor))
    b.find('names').click()
    same('another button changes neither', (b.js('return scc.look().up'), b.js('return scc.link()').replace('&switched=names', '')),
         ('z', link))
    same('the console is told nothing', b.complaints(), [])


SLAB = """import <solids>
fixed slab = solids.Plank(8, 8, 1)
process p = solids.Cube(1) mass 1 velocity (0, 1/10, 0) at translate (0, 12, 0) [nil]
check there : always y(p) >= 0
"""


def walls(b, scc):
    """Of a room the near walls are cut away: what is in it is seen as any other body, and so is the far wall."""
    b.open(scc.view('specs/models/crowds/pore.sc', '-D', 'n=4', '--graph', '4', '--seconds', '5'))
    wall, post, moving = b.js('return [[5, 1.3, 0.5], [0, 1.3, 0.5], [-4, -1, 0.5]].map((at) => scc.sight(at))')
    same('what is picked in a room', [s['name'] for s in (wall, post, moving)], ['room', 'upper', 'p[3]'])
    same('nothing is seen through another one', [s['color'][3] for s in (wall, post, moving)], [255] * 3)
    lights = [max(s['color'][:3]) for s in (wall, post)]
    check('a body in the room is not of the colour of its wall', lights[0] > lights[1] + 20, lights)
    for model, room, bodies in [('glycolysis', 'cell', ['e[1]', 'e[2]', 'atp[1]', 'glucose[2]']), ('brownian', 'box', ['pocket', 'ligand'])]:
        b.open(scc.view(f'specs/models/{model}.sc', '--graph', '4', '--seconds', '5'))
        at = b.js('return Object.fromEntries(Object.entries(scc.floats()))')
        seen = {name: b.js('return scc.sight(arguments[0])', at[name]) for name in bodies}
        same(f'bodies in the {room} of {model}', {name: s['name'] for name, s in seen.items()}, {name: name for name in bodies})
        same(f'are opaque, in {model}', {s['color'][3] for s in seen.values()}, {255})
        middle = b.js('return [...Array(9).keys()].map((i) => scc.sight([i - 4, 0, 0])).filter((s) => s.name === arguments[0])', room)
        check(f'the {room} itself is picked where nothing else is, in {model}', middle)
    # A room of six walls: those before the bodies are cut away.
    b.open(scc.view('specs/models/billiard.sc', '--graph', '4', '--seconds', '5'))
    for up in 'xyz':
        seen = b.js('return Object.entries(scc.floats()).filter(([name]) => name.length === 1).map(([name, at]) => [name, scc.sight(at).name])')
        same(f'bodies within walls, {up}', seen, [['p', 'p'], ['q', 'q']])
        b.find('up').click()
    # A large body that hides nothing is whole, and else it is cut.
    b.open(scc.view(written(scc, SLAB)))
    near = 'return [3.5, 2, 0].map((y) => scc.sight([0, y, 0.5])).filter((s) => s.name === "slab").length'
    check('a wall that hides nothing is whole', b.js(near) > 0, b.js('return scc.sight([0, 3.5, 0.5])'))
    same('and what is beside it is seen', b.js('return scc.sight([0, 12, 0]).name'), 'p')
    b.open(scc.view(written(scc, SLAB.replace('(0, 12, 0)', '(0, 0, -4)'))))
    same('one that hides something is cut', b.js('return scc.sight([0, 0, -4]).name'), 'p')
    same('the console is told nothing', b.complaints(), [])


def camera_of(b):
    return json.loads(unquote(b.js('return scc.link()').split('camera=', 1)[1].split('&')[0]))


#: Of two runs, the first is over soon, and the second one leads far up.
ELSEWHERE = """import <solids>
process a = solids.Cube(1) mass 1 velocity (1/8, 0, 0) [nil]
process b = solids.Cube(1) mass 1 velocity (0, 4, 0) at translate (5, 0, 0) [nil]
check soon : eventually x(a) > 3 within 1/4
check late : eventually x(a) > 9 within 10
"""


def framed(b, scc):
    """The bodies are brought into view beside the legend and above the buttons, until the user moves the camera."""
    b.open(scc.view('specs/models/glycolysis.sc', '--graph', '4', '--seconds', '5'))
    spots = """
      const box = document.getElementById("scene").getBoundingClientRect();
      const bar = document.getElementById("scene-tools").getBoundingClientRect();
      return [Object.values(scc.floats()).map((p) => scc.sight(p).at), box.width, bar.top - box.top];"""

    def check_all(what, wide=True):
        all_, width, below = b.js(spots)
        check(f'{what}: all bodies are within the picture', all(90 < x < width and 0 < y < below for x, y in all_), (all_, width, below))
        if not wide:
            return
        # Of their middles; a scene that is much wider than high has free sides.
        wide, part = max(x for x, _ in all_) - min(x for x, _ in all_), 0.3 * min(width, 2 * below)
        check(f'{what}: they take a good part of it', wide > part, (wide, part, all_))

    def sized(*size):
        b.size(*size)
        b.js('return new Promise((done) => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 400))')

    check_all('at first')
    first = camera_of(b)
    sized(900, 900)
    check_all('in a narrow page')
    moved = camera_of(b)
    check('the camera has moved', moved != first, moved)
    b.js('document.querySelector("#scene canvas").focus()')
    b.keys('z')
    mine = camera_of(b)
    check('a key moves it', mine != moved, mine)
    sized(1400, 900)
    same('then it stays', camera_of(b), mine)
    # Another run leads elsewhere.
    b.open(scc.view(written(scc, ELSEWHERE)))
    check_all('at the first check')
    for index, what in [(1, 'at the second check'), (0, 'and back')]:
        b.all('[data-testid="run"]')[index].click()
        sized(1400, 900)
        check_all(what, wide=False)
    same('the console is told nothing', b.complaints(), [])


LEGEND = """import <solids>
for i in 1..14 { process cube[i] = solids.Cube(1) mass 1 at translate (-3 + 2*i, 10 - i/2, 0) velocity (0, 0, i) [nil] }
process a_body_with_a_rather_long_name_indeed = solids.Cube(2) mass 1 at translate (-4, 9, 0) velocity (0, 0, 0) [nil]
"""


def legend(b, scc):
    """The legend is where it covers no body, if there is such a corner; and it can be left out."""
    model = scc.file('.sc')
    with open(model, 'w') as f:
        f.write(LEGEND)
    page = scc.view(model)
    corners = set()
    for size in [(1400, 900), (700, 900), (1100, 500)]:
        b.size(*size)
        b.open(page)
        for up in range(3):
            found = b.js("""
              scc.sight([0, 0, 0]);
              const { legend, box: [left, top, right, bottom] } = scc.look(), covered = (at) => left < at[0] && at[0] < right && top < at[1] && at[1] < bottom;
              return [legend, Object.values(scc.floats()).filter((p) => covered(scc.sight(p).at)).length];""")
            corners.add(found[0])
            same(f'no body is below the legend, {size}, {up}', found[1], 0)
            b.find('up').click()
            b.js('return new Promise((done) => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 500))')
    check('it is not always in one corner', len(corners) > 1, corners)
    b.size(1400, 900)
    b.open(page)
    seen = b.js('return document.querySelectorAll("#scene canvas")[1].toDataURL()')
    b.find('legend').click()
    b.js('scc.sight([0, 0, 0])')
    check('it can be left out', b.js('return document.querySelectorAll("#scene canvas")[1].toDataURL()') != seen)
    check('a link keeps that', 'switched=legend' in b.js('return scc.link()'))
    same('the console is told nothing', b.complaints(), [])


def keys_after_menus(b, scc):
    """Keys work on the page after one has chosen from a list with the pointer, and after Escape in a field."""
    b.open(scc.view(HEXOKINASE))
    b.js('scc.go(0)')
    box = b.find('events-kind')
    b.js('arguments[0].dispatchEvent(new PointerEvent("pointerdown", { bubbles: true })); arguments[0].focus()', box)
    b.pick('events-kind', 'all')
    b.keys(Keys.ARROW_RIGHT)
    same('an arrow goes on in the run', (b.state()['legs'], box.get_property('value')), (1, 'all'))
    b.js('arguments[0].focus()', box)
    b.keys(Keys.ARROW_DOWN)
    same('with keys one stays in the list', b.js('return document.activeElement.dataset.testid'), 'events-kind')
    b.keys(Keys.ESCAPE)
    b.find('plot-input').send_keys('x')
    b.keys(Keys.ESCAPE, Keys.HOME)
    same('after Escape in a field', b.state()['legs'], 0)
    same('the console is told nothing', b.complaints(), [])


HOSTILE = ['</script><script>window.pwned = 1</script><img src=x onerror="window.pwned = 1">',
           'א' * 40 + '\u202e reversed \u2066 \u0000 &lt;b&gt;', 'long' * 2500]


def hostile(b, scc):
    """Texts of a model stay text, whatever they are."""
    long = 'n' * 10000
    model = scc.file('.sc')
    with open(HEXOKINASE, encoding='utf-8') as f:
        text = f.read()
    with open(model, 'w', encoding='utf-8') as f:
        comments = ['// ' + one.replace('\0', '') for one in HOSTILE]
        f.write('\n'.join([*comments, re.sub(r'\bglucose\b', long, text)]))
    pages = [scc.view(model)]
    # And with names that no model can have, as the page must not rely on that.
    with open(pages[0], encoding='utf-8') as f:
        page = f.read()
    head, rest = page.split('id="data">', 1)
    data, tail = rest.split('</script>', 1)
    data = json.loads(data)
    data['name'] = data['model'] = HOSTILE[0]
    for i, leaf in enumerate(data['leaves']):
        leaf['name'] = leaf['template'] = leaf['parts'][0]['name'] = HOSTILE[i % 3]
    for i, label in enumerate(data['labels']):
        label['words'] = label['text'] = HOSTILE[i % 3]
    for i, run in enumerate(data['runs']):
        run['name'] = HOSTILE[i % 3]
        if run['check']:
            run['check'].update(formula=HOSTILE[0], text=HOSTILE[2])
    for i, behaviour in enumerate(data['behaviours']):
        behaviour['text'] = HOSTILE[i % 3]
    for plot in data['plots']:
        plot['text'] = HOSTILE[0]
    for solid in data['solids']:
        for face in solid['faces']:
            face['name'] = HOSTILE[0]
    data['rules'] = {name: HOSTILE[0] + text for name, text in data['rules'].items()}
    pages.append(scc.file('.html'))
    with open(pages[1], 'w', encoding='utf-8') as f:
        f.write(head + 'id="data">' + json.dumps(data).replace('<', '\\u003c') + '</script>' + tail)
    for page in pages:
        b.open(page)
        count = 'return document.querySelectorAll("script, img, iframe, style, link").length'
        before = b.js(count)
        b.find('graph-switch').click()
        for tab in ['why', 'details', 'rule', 'model']:
            b.find(f'tab-{tab}').click()
        b.find('tab-details').click()
        b.all('[data-testid="bodies-list"] [role=option]')[1].click()
        for _ in range(5):
            b.find('next').click()
        b.js('document.querySelector("#now .link").click()')
        check('no text becomes a script', b.js('return window.pwned === undefined'))
        same('no text becomes an element', b.js(count), before)
        same('nothing is refused by the policy, nothing goes wrong', b.complaints(), [])
        for width in [1400, 400]:
            b.size(width, 900)
            narrow = b.wait(f'return document.scrollingElement.scrollWidth <= {width}')
            check(f'long names stay within {width} pixels', narrow, b.js('''
              return [...document.querySelectorAll("body *")]
                .filter((e) => e.getBoundingClientRect().right > innerWidth).map((e) => e.id || e.className).slice(0, 20)'''))
        b.size(1400, 900)


def motion(b, scc):
    """Who wants no motion sees events one by one."""
    b.prefer(reduced_motion='reduce', color_scheme='dark')
    b.open(scc.view('specs/models/docking.sc'))
    same('dark, as the system is', b.js('return document.documentElement.dataset.theme'), 'dark')
    b.js('scc.go(0)')
    b.find('faster').click()
    b.find('faster').click()
    b.find('play').click()
    check('playing goes on', b.wait('return scc.state().legs >= 2'))
    b.find('play').click()
    now = b.state()
    instants = b.js('''
      return [...Array(arguments[0] + 1).keys()].map((k) => { scc.go(k); return scc.state().time; })''', now['legs'])
    check('at instants of events alone', now['time'] in instants, now['time'])
    b.prefer(reduced_motion='no-preference', color_scheme='light')
    for tool in ['names', 'velocities', 'spins', 'trails', 'projection', 'fit']:
        b.find(tool).click()
    for legs in range(8):
        b.js('scc.go(arguments[0]); return new Promise((done) => requestAnimationFrame(() => done()))', legs)
    same('the scene with all that it can show', b.complaints(), [])


def no_states_beyond(b, scc):
    """A choice that leads beyond what the file holds says so."""
    b.open(scc.view(HEXOKINASE, '--graph', '3'))
    data = b.js('return scc.data')
    b.js('scc.open(scc.runs().length - 1)')
    for k in range(b.js('return scc.runs().slice(-1)[0].steps') + 1):
        b.js('scc.go(arguments[0])', k)
        rows = b.all('[data-testid="choices-list"] .away')
        if rows:
            rows[0].click()
            check('a state that is not in the file', 'not in the file' in b.text('choices-said'))
            same('nothing else is shown then', b.state()['legs'], k)
            return
    check('the file holds no choice beyond its states', all(one['to'] is not None for state in data['states']
                                                            for one in state['next'] or []))


LARGE = '''
model large
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
for i in 1..499 {
  process p[i] = Cube mass 1 velocity (1 + i/100,0,0) at translate (0,4*i,0) [nil]
  process q[i] = Cube mass 1 velocity (-1,0,0) at translate (8,4*i,0) [nil]
}
fixed left  = Cube scaled (1,3000,10) at translate (-10,0,0)
fixed right = Cube scaled (1,3000,10) at translate (20,0,0)
check near : always distance2(p[1], q[1]) >= 0 within 1
'''


def large(b, scc):
    """1 000 bodies, 10 000 events: the page is not large, and nor is what it lists (test/bench/view takes its times)."""
    model, run = scc.file('.sc'), scc.file('.jsonl')
    with open(model, 'w', encoding='utf-8') as f:
        f.write(LARGE)
    scc.run('trace', '--steps', '10000', '--states', 'ends', '-o', run, model)
    page = scc.view(model, '--trace', run)
    size = os.path.getsize(page)
    check('it is less than 20 MB', size < 20e6, size)
    b.open(page)
    check('the list holds what is seen alone', 0 < len(b.all('[data-testid="events-list"] .row')) < 60)
    b.js('document.activeElement.blur()')
    b.keys(Keys.END)
    same('the end of it', b.state()['legs'], 10000)
    check('the last row is there', b.all('[data-testid="events-list"] [data-index="10000"][aria-selected="true"]'))
    # What is about all bodies is evaluated piece by piece.
    b.js('window.ticks = 0; setInterval(() => { window.ticks += 1; }, 1)')
    b.find('plot-input').send_keys('bonds() + 3', Keys.ENTER)
    check('a number about all bodies is on its way', b.js('return scc.busy()'))
    check('it is drawn', b.wait('return !scc.busy() && document.querySelectorAll(".plot .plot-line").length > 1'))
    check('the page goes on meanwhile', b.js('return window.ticks') > 3, b.js('return window.ticks'))
    same('its value', b.js('return scc.plots()[scc.plots().length - 1].value'), '3')
    rows = b.js('return [...document.querySelectorAll(".plot .plot-line")].pop().getAttribute("d")')
    check('along the whole run', len(set(re.findall(r'[ML][0-9.]+ ([0-9.]+)', rows))) == 1 and len(rows) > 1000, rows[:200])
    # A number that was not computed tells what one can do instead, whole.
    b.open(scc.view('specs/models/gas.sc', '-D', 'n=6', '--graph', '2', '--seconds', '5'))
    why = b.js('return document.querySelector("[data-testid^=plot-why-]").textContent')
    check('what is not computed says what to choose', why.endswith('choose a number of some bodies'), why)
    same('the console is told nothing', b.complaints(), [])


def lost_context(b, scc):
    """When the graphics card forgets all, the page goes on, and the scene comes back as it was."""
    b.open(scc.view(HEXOKINASE))
    b.js('scc.open(scc.runs().length - 1); scc.go(1)')
    at = [float(Fraction(x)) for x in b.state()['bodies']['atp']['position']]
    before = b.js('return scc.sight(arguments[0])', at)
    check('a body is seen', before['color'][3] == 255, before)
    b.js("""
      const canvas = document.querySelector("#scene canvas");
      window.lose = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
      for (const what of ["lost", "restored"]) canvas.addEventListener("webglcontext" + what, () => { window.context = what; });
      window.lose.loseContext();""")
    b.wait('return window.context === "lost"')
    b.js('scc.go(2)')
    same('the page goes on without it', b.state()['legs'], 2)
    b.js('scc.go(1); window.lose.restoreContext()')
    b.wait('return window.context === "restored"')
    same('all is drawn anew', b.js('return scc.sight(arguments[0])', at), before)
    same('the console is told nothing else', [said for said in b.complaints() if 'CONTEXT_LOST' not in said], [])


def without_webgl(scc):
    """Where no scene can be drawn, the page says why, and all else is there."""
    b = browser.Browser(flags=browser.WITHOUT_SCENES)
    try:
        b.open(scc.view(HEXOKINASE))
        check('why there is no scene', 'cannot be drawn' in b.text('scene-why'), b.text('scene-why'))
        b.js('scc.go(0)')
        b.keys(Keys.ARROW_RIGHT)
        same('all else is there', b.state()['legs'], 1)
    finally:
        b.quit()


PARTS = [by_mouse, graphs, found_states, events, formulas, small, reasons, deciding, undecided, narrow, contrast, starts, onwards, by_keys, links, plots, upright, walls, framed, legend, keys_after_menus, hostile, far_away, motion, lost_context, no_states_beyond, large]
