"""Pages of scc simulate --view: all runs as bars, and the runs of the table."""
import csv
import io
import json
from fractions import Fraction

from browser import Keys
from browser_test import check, same

MODEL = 'specs/models/brownian.sc'
ASKED = ['--observe', 'x(ligand)', '--observe', 'bound(ligand, pocket)', '--every', '3/2', '--until', '12']


def simulated(scc, model, *arguments):
    """The page of a simulation, and its table: by run and time, the values as fractions."""
    page = scc.file('.html')
    ended = scc.run('simulate', model, '--view', page, *arguments)
    if ended.returncode not in (0, 2, 4):
        raise RuntimeError(f'scc simulate {model}: {ended.stderr}')
    table = {}
    for run, time, *values, _ in list(csv.reader(io.StringIO(ended.stdout)))[1:]:
        table[int(run), Fraction(time)] = [Fraction(value) if value else None for value in values]
    return page, table


def bars(b, observable):
    """The bars that are not empty: what they tell, and whether they have runs of the page, or the one that is seen."""
    return b.js('''
      return [...document.querySelectorAll(`[data-testid="spread-${arguments[0]}"] button.spread-bar`)].map((bar) =>
        [bar.dataset.testid, bar.getAttribute("aria-label"), bar.classList.contains("has"), bar.classList.contains("here")]);''',
      observable)


def runs_of_table(b, scc):
    """Each run of the page is that of the table, at all its times: as plotted, by places of bodies, and in the panel."""
    page, table = simulated(scc, MODEL, '--runs', '60', *ASKED)
    b.open(page)
    shown = b.js('return scc.runs().map((run) => run.name)')
    same('as many runs as fit', shown, [f'run {k}' for k in range(20)])
    check('which is told', 'The page shows 20 of them: 0 to 19.' in b.text('spread-runs'), b.text('spread-runs'))
    times = sorted({time for _, time in table})
    found = b.js('''
      return arguments[0].flatMap((run) => arguments[1].map((time) => {
        scc.open(run);
        scc.seek(time);
        const { bodies } = scc.state(), [first] = scc.plots(), now = scc.spread();
        return [run, time, first.value, bodies.ligand ? bodies.ligand.position[0] : null, now.time, now.run, now.values];
      }));''', list(range(20)), [str(time) for time in times])
    number = lambda text: None if text is None else Fraction(text)  # noqa: E731
    wrong = [(run, time) for run, time, plotted, place, now, seen, values in found
             if [number(plotted), number(place)] != [table[run, Fraction(time)][0]] * 2 or Fraction(now) != Fraction(time)
             or seen != run or [number(value) for value in values] != table[run, Fraction(time)]]
    same('values and places are those of the table', (len(found), wrong), (20 * len(times), []))
    same('the console is told nothing', b.complaints(), [])


def by_bars(b, scc):
    """A bar chooses a run of the page that is in it; the time of the table and that of the scene go together."""
    page, table = simulated(scc, MODEL, '--runs', '200', *ASKED)
    b.open(page)
    b.pick('spread-time', '4')
    b.js('document.querySelector("[data-testid=spread-time]").dispatchEvent(new Event("input"))')
    same('the scene is at that time', Fraction(b.state()['time']), Fraction(6))
    check('which is read out', b.find('spread-time').get_attribute('aria-valuetext') == 't = 6')
    values = [table[run, Fraction(6)][0] for run in range(200)]
    found = bars(b, 0)
    same('a bar for each value', len(found), len(set(values)))
    for (test, words, has, _), value in zip(found, sorted(set(values))):
        runs = [run for run in range(200) if values[run] == value]
        own = [run for run in runs if run < 20]
        check('a bar tells its runs', f': {len(runs)} run' in words and has == bool(own) and words.endswith(
            f'On the page: run{"s" if len(own) > 1 else ""} {", ".join(map(str, own))}.' if own else 'None of them is on the page.'), words)
        for expected in own[:2]:
            before = b.state()['run']
            b.find(test).click()
            seen = b.js('return scc.spread().run')
            check('a bar chooses a run in it', seen in own and (len(own) < 2 or f'run {seen}' != before), (seen, own, before))
            same('at the time', Fraction(b.state()['time']), Fraction(6))
            same('the bar says so', [test for test, *_, here in bars(b, 0) if here], [test])
            check('and how many there are', f'of {len(own)} run' in b.text('spread-told'), b.text('spread-told'))
        if not own:
            before = b.state()['run']
            b.find(test).click()
            check('without a run of the page it says so', b.state()['run'] == before and 'not on the page' in b.text('spread-told'))
    b.find('spread-exact-0').find_element('css selector', 'summary').click()
    mean = sum(values) / 200
    text = b.text('spread-exact-0')
    check('the exact mean on demand', f'{mean.numerator}/{mean.denominator}' in text, text)
    b.find(found[0][0]).click()
    b.keys(Keys.ARROW_RIGHT)
    same('arrows go from bar to bar', b.js('return document.activeElement.dataset.testid'), found[1][0])
    b.js('document.querySelectorAll("[data-testid=run]")[7].click()')
    same('another run is shown at the same time', (b.state()['run'], Fraction(b.state()['time'])), ('run 7', Fraction(6)))
    check('and the panel stays', b.find('spread').is_displayed())
    b.js('scc.seek("10")')
    same('the panel goes with the clock', Fraction(b.js('return scc.spread().time')), Fraction(9))


def apart(b, scc):
    """Runs that have ended are counted apart, and so are those without a value; a page may have no run at all."""
    page, table = simulated(scc, 'specs/models/ruin.sc', '--runs', '50', '--observe', 'x(walker)', '--every', '1', '--until', '20',
                            '--steps', '9')
    b.open(page)
    b.js('scc.open(0)')
    for at in range(21):
        b.js('''const box = document.querySelector("[data-testid=spread-time]"); box.value = arguments[0];
                box.dispatchEvent(new Event("input"));''', str(at))
        there = sum(table[run, Fraction(at)][0] is not None for run in range(50))
        over = b.js('return scc.data.spread.over[arguments[0]]', at)
        none = b.js('return scc.data.spread.cells[arguments[0]][0].none', at)
        same('all runs are counted', there + over + none, 50)
        check('those that had ended are told', over == 0 or f'{over} run' in b.text('spread-apart'), b.text('spread-apart'))
        if none:
            check('those without a value are told', b.text('spread-none-0').startswith(f'{none} run'))
    with open(page, encoding='utf-8') as file:
        text = file.read()
    head, rest = text.split('id="data">', 1)
    data, tail = rest.split('</script>', 1)
    data = json.loads(data)
    data['runs'], data['spread']['shown'] = [], []
    bare = scc.file('.html')
    with open(bare, 'w', encoding='utf-8') as file:
        file.write(head + 'id="data">' + json.dumps(data).replace('<', '\\u003c') + '</script>' + tail)
    b.open(bare)
    check('which is told', 'shows none' in b.text('spread-runs'), b.text('spread-runs'))
    check('a page without runs is shown', b.state()['run'] == 'the beginning', b.state())
    b.size(700, 900)
    b.open(page)
    wide = b.js('return [document.documentElement.scrollWidth, innerWidth]')
    b.size(1400, 900)
    check('nothing is wider than a narrow window', wide[0] <= wide[1], wide)


PARTS = [runs_of_table, by_bars, apart]
