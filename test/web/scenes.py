"""What the scene marks, compares and saves."""
from fractions import Fraction

from browser import Keys, Select
from browser_test import check, same

HEXOKINASE = 'specs/models/hexokinase.sc'

MARKED = """import <solids>
process p = solids.Cube(1) mass 1 velocity (2, 0, 0) [nil]
process q = solids.Cube(1) mass 1 at translate (0, 5, 0) [nil]
process pq = solids.Cube(1) mass 1 velocity (0, 0, 1) at translate (0, -5, 0) [nil]
check far : eventually x(p) >= 9 within 3
check both : eventually (x(pq) >= 9 or x(p) >= 9) within 3
check calm : always x(q) >= 0
"""


def written(scc, text):
    model = scc.file('.sc')
    with open(model, 'w', encoding='utf-8') as f:
        f.write(text)
    return model


#: Whether the picture has a pixel of about this colour.
SEEN = '''
scc.sight([0, 0, 0]);
const canvas = document.querySelector("#scene canvas"), copy = document.createElement("canvas");
[copy.width, copy.height] = [canvas.width, canvas.height];
const pen = copy.getContext("2d");
pen.drawImage(canvas, 0, 0);
const all = pen.getImageData(0, 0, copy.width, copy.height).data, [r, g, b] = arguments[0];
let count = 0;
for (let i = 0; i < all.length; i += 4)
  if (all[i + 3] > 200 && Math.abs(all[i] - r) + Math.abs(all[i + 1] - g) + Math.abs(all[i + 2] - b) < 24) count++;
return count;
'''
LIT = [0x7c, 0x3a, 0xed]


def marks(b, scc):
    """The bodies that reasons name, and what the last step has changed, in the scene."""
    b.prefer(color_scheme='light')
    b.open(scc.view(written(scc, MARKED)))
    told = b.js('return scc.marks()')
    same('the page opens with the body that the reason names', told['lit'], ['p'])
    same('where bodies were', told['before'], [['p', '0', '0', '0'], ['pq', '0', '-5', '0']])
    check('it has a seam', b.js(SEEN, LIT) > 100)
    check('the reason leads to it', b.text('marked') == 'Marked in the scene: p', b.text('marked'))
    b.keys('m')
    same('marks can be left out', (b.js('return scc.marks()')['lit'], b.js(SEEN, LIT)), ([], 0))
    b.keys('m')
    b.js('scc.open(1)')
    same('a name is not the beginning of another one', b.js('return scc.marks().lit'), ['p', 'pq'])
    b.all('[data-testid="run"]')[2].click()
    same('a check without a run has no reasons', b.js('return scc.marks().lit'), [])
    b.js('scc.open(0); scc.go(0)')
    same('at the beginning nothing has changed', b.js('return scc.marks().before'), [])
    b.find('play').click()
    same('while it is played, steps are not marked', b.js('return scc.marks().before'), [])
    b.find('play').click()

    b.open(scc.view(HEXOKINASE))
    told = b.js('return scc.marks()')
    same('bodies of several reasons', told['lit'], ['atp', 'glucose'])
    same('behaviours before and after', told['words'],
         ['enzyme: WithGlucose → Empty', 'glucose: GlucoseBound → Glucose'])
    same('the ends of a bond that is split', [(one.split()[0], one.split()[-1]) for one in told['ends']],
         [('enzyme', 'split'), ('glucose', 'split')])
    b.js('scc.go(4)')
    same('of a bond that is made', [one.split()[-1] for one in b.js('return scc.marks().ends')], ['made', 'made'])
    same('the console is told nothing', b.complaints(), [])


def compared(b, scc):
    """A second run: outlines in the scene, where both part, switching at the same time, numbers of both."""
    b.prefer(color_scheme='light')
    b.open(scc.view(HEXOKINASE))
    same('nothing is compared at first', (b.js('return scc.compared()'), b.find('compare').is_displayed()), (None, False))
    runs = b.js('return scc.data.runs')
    [(k, other)] = [(k, run) for k, run in enumerate(runs) if run.get('contrast') is not None]
    first = runs[k - 1]
    b.keys('k')
    told = b.js('return scc.compared()')
    same('the natural second run is the one that does otherwise', told['run'], other['name'])
    check('its outlines are seen', b.js(SEEN, [0, 0x80, 0x9c]) > 50)
    # The first event that differs, by the data alone.
    labels = b.js('return scc.data.labels')
    events = [[labels[s['label']]['words'] for s in run['steps'] if not labels[s['label']].get('duration')]
              for run in (first, other)]
    at = next(i for i, (one, two) in enumerate(zip(*events)) if one != two)
    check('where they part, in words', all(run[at] in told['words'] for run in events), told['words'])
    check('and it is shown', b.text('compare-words') == told['words'] and b.find('compare').is_displayed())
    here = b.state()
    b.keys('k')
    there = b.state()
    same('switching keeps the time', (there['run'], there['time']), (other['name'], here['time']))
    same('the first one is then the other', b.js('return scc.compared().run'), first['name'])
    differ = {name for name in here['bodies'] if here['bodies'][name] != there['bodies'][name]}
    same('what differs', {text.split(' ')[0] for text in b.js('return scc.compared().differences')}, differ)
    b.find('compare-switch').click()
    same('and back to where one was', b.state(), here)
    link = b.js('return scc.link()')
    b.keys('j')
    state = b.state()
    taken = [s['label'] for s in first['steps'][:state['legs']]]
    same('to where they part', [labels[i]['words'] for i in taken if not labels[i].get('duration')], events[0][:at])
    same('there nothing differs yet', b.js('return scc.compared().differences'), [])
    b.keys(Keys.ARROW_RIGHT)
    check('one event on it does', b.js('return scc.compared().differences') != [])
    b.open(b.shown, link)
    same('a link has both runs', (b.state()['run'], b.js('return scc.compared().run')), (first['name'], other['name']))
    Select(b.find('compare-with')).select_by_index(0)
    same('compared with none', (b.js('return scc.compared()'), b.find('compare').is_displayed()), (None, False))
    b.find('contrast-compare').click()
    same('a button at the reasons', b.js('return scc.compared().run'), other['name'])

    b.open(scc.view('specs/models/meeting.sc'))
    b.js('scc.compare(scc.runs().findIndex((run) => run.name === "y = 0, z = 3/2")); scc.seek("7")')
    told = b.js('return scc.compared()')
    same('any two runs', (told['words'], told['time']), ('The runs begin in different states.', '7'))
    same('both numbers are plotted', len(b.all('.chart .plot-line.other')), len(b.all('.chart')))
    heights = b.js("""return [...document.querySelectorAll(".chart")].map((chart) =>
      [...chart.querySelectorAll("path")].map((path) => path.getAttribute("d")))""")
    check('and differ', any(len(set(pair)) > 1 for pair in heights), heights)
    b.js('scc.seek("100")')
    check('one run may be over before the other', Fraction(b.js('return scc.compared().time')) <= Fraction(b.state()['time']))
    b.js('scc.compare(scc.runs().findIndex((run) => run.name === "first choices")); scc.go(0)')
    b.find('play').click()
    b.wait('return Number(document.querySelector("[data-testid=timeline]").getAttribute("aria-valuenow")) > 0')
    b.find('play').click()
    same('one clock', b.js('return scc.compared().time'), b.state()['time'])
    same('the console is told nothing', b.complaints(), [])


PARTS = [marks, compared]
