"""The pages of scc serve in a browser: what they ask for while one looks at them.

    live_test.py SCC FOLDER    the program; a folder for its files

What is shown is held against scc trace and against what the oracle answers. The last line is 'N passed, N failed'; it
ends with 3 if something that it needs is not there, and says so last."""
import os
import random
import sys
import time
from fractions import Fraction

import browser
import serve_test
from browser import Browser, Keys, Program
from browser_test import bodies_of_page, bodies_of_trace
from serve_test import Served, check, same

# Rafts that may come apart at any whole time, beside a ball between two walls: of what can happen, the first states that
# are looked at tell little.
RAFTS = '''
split_step 1
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
behaviour Held = omega(rope, {left, right}). Free
behaviour Free = <again, {top}>. nil
fixed west = Cube at translate (-6,-10,0)
fixed east = Cube at translate (6,-10,0)
process ball = Cube mass 1 velocity (7/3,0,0) at translate (0,-10,0) [nil]
for i in 1..6 {
  process raft[i] = p[i] : Cube mass 1 velocity (i/7,0,0) at translate (0,4*i,0) [Held] <rope, {p[i].right, q[i].left}>
                    q[i] : Cube mass 2 velocity (i/7,0,0) at translate (2,4*i,0) [Held]
}
check meet : possibly x(ball) > 3 within 2
'''


class Live(Browser):
    """A browser with served pages."""

    def look(self, served, name, fragment=''):
        self.driver.get_log('browser')
        self.driver.get('about:blank')
        self.driver.get(f'http://127.0.0.1:{served.port}{served.root}view/{name}/' + (f'#{fragment}' if fragment else ''))
        self.settled()

    def settled(self):
        check('the page is ready', self.wait('return document.body && document.body.dataset.ready === "true"'))
        self.idle()

    def idle(self):
        """No answer is waited for."""
        check('all is answered', self.wait('return !scc.busy()'))
        self.js('return new Promise((done) => setTimeout(done))')

    def press(self, test):
        """By keys, as what is drawn anew meanwhile keeps the focus."""
        self.js('document.querySelector(`[data-testid="${arguments[0]}"]`).focus()', test)
        self.keys(Keys.ENTER)

    def plot(self, text):
        field = self.find('plot-input')
        field.clear()
        field.send_keys(text, Keys.ENTER)
        self.idle()

    def values(self):
        return {one['text']: one['value'] for one in self.js('return scc.plots()')}


def steps_shown(b):
    """The steps of the run that is shown, by its choices."""
    return b.js('''
      const { way, run } = scc.state(), { states, runs } = scc.data;
      const base = runs.find((one) => run.endsWith(one.name)), steps = base.steps.slice(0, way ? way.legs : base.steps.length);
      let now = steps.length ? steps[steps.length - 1].to : base.start;
      for (const choice of way ? way.choices : []) {
        const one = states[now].next[choice];
        steps.push({ choice, label: one.label, to: one.to });
        now = one.to;
      }
      return steps;''')


def hold(b, scc, model, what):
    """Every state of the run that is shown is one of scc trace."""
    steps = steps_shown(b)
    lines = scc.trace(model, b.js('return scc.data'), steps)
    states = b.js('return [...Array(arguments[0] + 1).keys()].map((k) => { scc.go(k); return scc.state(); })', len(steps))
    wrong = [k for k, (state, line) in enumerate(zip(states, lines))
             if bodies_of_page(state) != bodies_of_trace(line) or Fraction(state['time']) != Fraction(line['time'])]
    same(f'{what}: states that are others than those of scc trace', wrong, [])
    same(f'{what}: how many', len(states), len(lines))
    return steps


def choosing(b, scc, model, chance):
    """Choice by choice, far beyond what the page had at first."""
    had = b.js('return scc.data.states.length')
    b.js('scc.open(0); scc.go(0)')
    b.idle()
    for k in range(25):
        possible = b.js('return scc.data.states[scc.state().state].next')
        check(f'what is possible after {k} steps is known', possible)
        # Time passes now and then, so that what is known comes to its end.
        choice = len(possible) - 1 if k % 2 else chance.randrange(len(possible))
        check(f'choice {choice} after {k} steps', b.js('return scc.choose(arguments[0])', choice))
        b.idle()
    check('there are more states than at first', b.js('return scc.data.states.length') > had + 20, had)
    check('what is possible is told', 'possible' in b.text('choices-said'), b.text('choices-said'))
    b.all('[data-testid="choices-list"] [role=option]')[-1].click()
    b.idle()
    same('a choice by mouse', b.state()['legs'], 26)
    same('all steps are one way', len(hold(b, scc, model, 'choices')), 26)
    b.js('scc.go(26)')
    b.find('go-on').click()
    b.idle()
    check('going on', len(hold(b, scc, model, 'first choices')) > 26)


# Where an answer has to come before a choice can be taken, it is, and one goes elsewhere at once.
HASTE = '''
const { states } = scc.data;
for (let k = 0; k < 26; k++) {
  scc.go(k);
  const choice = states[scc.state().state].next.findIndex((one) => states[one.to].next === null);
  if (choice < 0) continue;
  scc.choose(choice);
  const late = scc.choose(0);
  scc.go(1);
  return Promise.resolve(late).then((done) => [done, scc.state().legs]);
}'''


def elsewhere(b):
    """An answer does not take one away from where one has gone meanwhile."""
    b.js('scc.open(scc.runs().length - 1)')
    same('where one has gone', b.js(HASTE), [None, 1])
    b.idle()


def addresses(b, served, text):
    """A reload keeps the way; a page that knows nothing of it asks where it leads."""
    state, fragment = b.state(), b.js('return scc.link()')
    check('the address is that of what is shown', b.wait('return location.hash === "#" + scc.link()'))
    check('a link says that it works here only', 'this machine alone' in b.find('cite').get_attribute('title'))
    b.find('cite').click()
    check('also as it is copied', b.wait('return document.getElementById("cite").textContent.endsWith(", for here only")'))
    b.driver.refresh()
    b.settled()
    same('after a reload', b.state(), state)
    other, _ = served.open(text)
    had = b.js('return scc.data.states.length')
    first = b.driver.current_window_handle
    b.driver.switch_to.new_window('tab')
    b.look(served, other, fragment)
    b.idle()
    same('in a second tab', b.state(), state)
    check('it has asked for that alone', b.js('return scc.data.states.length') < had, b.js('return scc.data.states.length'), had)
    b.look(served, other, 'run=0&step=3&way=0.0.99.0')
    check('a way that is not possible is told', 'not possible' in b.text('notice'), b.text('notice'))
    same('nothing is told to the console', b.complaints(), [])
    b.driver.close()
    b.driver.switch_to.window(first)


def formulas(b, served, name):
    """Plots of any number or formula have the values that the oracle tells."""
    texts = ['x(ball)', 'distance2(ball, p[2])', 'bonds(rope)', 'x(ball) > 1 and bound(p[3], q[3])', '1 / (time - 1)']
    for text in texts:
        b.plot(text)
    same('all of them are shown', [text for text in texts if text not in b.values()], [])
    steps = steps_shown(b)
    for legs in range(0, len(steps) + 1, 4):
        b.js('scc.go(arguments[0])', legs)
        path = [step['choice'] for step in steps[:legs]]
        found = b.values()
        for text in texts:
            told = served.rpc(f'view/{name}/ask', 'evaluate', model='m1', path=path, formula=text)
            value = told['value']
            wanted = None if value is None else int(value) if told['kind'] == 'state' else Fraction(value['exact'])
            shown = found[text]
            if wanted is None:
                check(f'{text} after {legs} steps is nothing', not shown[-1:].isdigit(), shown)
            else:
                same(f'{text} after {legs} steps', Fraction(shown), wanted)
    b.js('scc.seek("17/11")')
    same('between events', b.values()['x(ball)'], b.state()['bodies']['ball']['position'][0])
    b.js('scc.choose(0)')
    b.idle()
    check('along another way', Fraction(b.values()['x(ball)']) is not None)

    b.plot('x(nobody) + 1')
    same('what is wrong is marked', b.js('return document.querySelector("[data-testid=plot-wrong] mark").textContent'), 'nobody')
    check('and told', 'nobody' in b.text('plot-wrong') and b.find('plot-wrong').is_displayed(), b.text('plot-wrong'))
    same('it stays to be mended', b.find('plot-input').get_attribute('value'), 'x(nobody) + 1')
    b.find('plot-input').clear()


def verdicts(b, served, name):
    """A formula about whole runs is judged at the state that is shown, and the run that shows it can be seen."""
    text = 'always bonds(rope) > 3 within 2'
    b.plot(text)
    plot = next(one['plot'] for one in b.js('return scc.plots()') if one['text'] == text)
    b.js('scc.open(0); scc.go(1)')
    b.idle()
    b.press(f'judge-{plot}')
    check('a verdict', b.wait('return !scc.busy() && document.querySelector("[data-testid=judged-run]")'))
    told = served.rpc(f'view/{name}/ask', 'evaluate', model='m1', path=[0], formula=text)
    same('its kind', told['verdict'], 'violated')
    check('it is told', told['report']['text'] in b.text(f'judged-{plot}'), b.text(f'judged-{plot}'))
    b.press('judged-run')
    b.idle()
    b.keys(Keys.END)
    b.idle()
    same('the run that shows it', Fraction(b.values()['bonds(rope)']), 3)

    long = 'always x(ball) < 100'
    b.plot(long)
    plot = next(one['plot'] for one in b.js('return scc.plots()') if one['text'] == long)
    b.press(f'judge-{plot}')
    check('one sees that it works', b.wait('return document.querySelector("[data-testid=asking]").textContent'))
    check('it ends', b.wait(f'return !scc.busy() && document.querySelector("[data-testid=judged-{plot}]")'))
    said = b.text(f'judged-{plot}')
    check('it says its bound', 'bound of 20000 states' in said or 'took more time than it may' in said, said)
    same('nothing is seen of work then', b.text('asking'), '')


def parting(b, served):
    """What is told of a way that leaves a state by an event says nothing of how time passes there in another run."""
    name, _ = served.open(RAFTS + 'check half : possibly x(ball) = 7/6', 'all')
    b.look(served, name)
    half = b.js('return scc.runs().findIndex((run) => run.name === "half")')
    b.js('scc.open(arguments[0]); scc.go(0); scc.choose(0)', half)
    b.idle()
    for text in ['x(ball)', 'x(ball) < 1']:
        b.plot(text)
    b.js('scc.open(arguments[0]); scc.seek("1/2")', half)
    b.idle()
    same('values while time passes', b.values(), {'x(ball)': '7/6', 'x(ball) < 1': '0'})


def graph(b):
    """The drawing of states grows."""
    b.js('scc.open(0); scc.go(0)')
    b.find('graph-switch').click()
    note = b.text('graph-note')
    check('the graph says what it shows', 'looked at' in note, note)
    check('and has what is near', len(b.all('[data-testid="graph"] .node')) > 1)
    b.pick('graph-show', 'all')
    check('and all of it', b.wait('return document.querySelectorAll("[data-testid=graph] .node").length > 100 || '
                                  'document.querySelector("[data-testid=graph-map]") !== null'))
    b.pick('graph-show', 'near')
    b.keys(Keys.END)
    b.idle()
    b.js('return scc.choose(0)')
    b.idle()
    same('the present state is there', len(b.all('[data-testid="graph"] .node.here')), 1)
    b.find('graph-switch').click()


# The next requests are answered as told, before they get to the server.
AS_TOLD = '''
const fetched = window.fetch, answers = arguments[0];
window.fetch = (...request) => {
  const answer = answers.shift();
  if (answer === undefined) return fetched(...request);
  return answer === 0 ? Promise.reject(new TypeError("lost")) : Promise.resolve(new Response("{}", { status: answer }));
};'''


def hindrances(b):
    """What is lost is asked again; what is busy, too."""
    b.keys(Keys.END)
    b.js(AS_TOLD, [0, 503, 503])
    b.js('return scc.choose(0)')
    b.idle()
    for _ in range(6):
        b.js('return scc.choose(0)')
        b.idle()
    check('a lost request is no matter', not b.find('served').is_displayed())
    same('nothing is told to the console', b.complaints(), [])
    b.js(AS_TOLD, [0, 0])
    b.js('window.late = scc.choose(0), null')
    check('more of them are told', b.wait('return !document.querySelector("[data-testid=served]").hidden'))
    b.idle()
    check('until there is an answer', not b.find('served').is_displayed())


def endings(b, served, name, text):
    """A document that is over says so, and can still be looked at; a server that has gone is asked again."""
    served.post(f'view/{name}/close', {})
    b.plot('time + 1')
    check('it is told that it is over', 'not served any more' in b.text('served'), b.text('served'))
    b.js('scc.go(0)')
    same('what is known stays', b.state()['legs'], 0)
    name, _ = served.open(text)
    b.look(served, name)
    same('the end of the service', served.end(), 0)
    b.js('window.late = null')
    b.find('plot-input').send_keys('time + 2', Keys.ENTER)
    check('a server that has gone is told', b.wait('return !document.querySelector("[data-testid=served]").hidden'))
    check('and asked again', 'again' in b.text('served'), b.text('served'))


def main(program, folder):
    lacking = browser.missing()
    if lacking:
        print(lacking)
        return 3
    begun = time.monotonic()
    scc = Program(os.path.abspath(program), folder)
    model = scc.file('.sc')
    with open(model, 'w', encoding='utf-8') as file:
        file.write(RAFTS)
    served = Served(program, model)
    b = Live(flags=browser.WITHOUT_SCENES)
    try:
        name, told = served.open(RAFTS)
        same('the document', told['state'], 'ready')
        b.look(served, name)
        choosing(b, scc, model, random.Random(16))
        elsewhere(b)
        b.js('scc.open(scc.runs().length - 1); scc.go(20)')
        b.idle()
        formulas(b, served, name)
        addresses(b, served, RAFTS)
        verdicts(b, served, name)
        graph(b)
        hindrances(b)
        same('nothing is told to the console in all', b.complaints(), [])
        parting(b, served)
        b.look(served, name)
        endings(b, served, name, RAFTS)
    finally:
        b.quit()
        served.end()
    print(f'{time.monotonic() - begun:.0f} s')
    print(f'{serve_test.passed} passed, {serve_test.failed} failed')
    return 1 if serve_test.failed else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2]))
