"""Ten tasks on the pages, each within three clicks: what a person clicks, and what is then seen.

A list that one chooses from counts as a click, and so does a key. With the environment's WALK=FOLDER a screenshot of each task
is saved there, to be looked at.
"""
import os

from browser import Keys, Select
from browser_test import check, same

HEXOKINASE = 'specs/models/hexokinase.sc'
MEETING = 'specs/models/meeting.sc'


class Walk:
    """Clicks on a page, counted."""

    def __init__(self, b):
        self.b = b
        self.clicks = 0

    def click(self, what):
        """An element, or the mark of one."""
        self.clicks += 1
        (self.b.find(what) if isinstance(what, str) else what).click()

    def choose(self, test, value):
        self.clicks += 1
        Select(self.b.find(test)).select_by_value(value)

    def write(self, test, text):
        self.click(test)
        self.b.find(test).send_keys(text, Keys.ENTER)

    def row(self, test, text):
        """The row of a list that has this text."""
        return next(row for row in self.b.all(f'[data-testid="{test}"] .row') if text in row.text)


def why(walk, b):
    """Why is it violated? The page opens at the instant that decides: its verdict, its reasons, their bodies marked."""
    return b.text('verdict').startswith('violated') and b.js('return scc.marks().lit') == ['atp', 'glucose']


def compare(walk, b):
    """Compare with a run that succeeds: Compare both."""
    walk.click('contrast-compare')
    return 'otherwise' in b.js('return scc.compared().run')


def follow(walk, b):
    """Follow a body: its name in Why, Follow, to the beginning."""
    walk.click(b.find('marked').find_element('css selector', 'button'))
    walk.click('follow')
    walk.click('first')
    camera = 'scc.sight([0, 0, 0]); return scc.link().split("camera=")[1].split("&")[0]'
    before = b.js(camera)
    b.js('scc.seek("3/4")')
    return b.js(camera) != before


def open_site(walk, b):
    """Which site is open? Bodies, a body."""
    walk.click('tab-details')
    walk.click(walk.row('bodies-list', 'enzyme'))
    return '~atp on ' in b.text('fact-offers')


def binding(walk, b):
    """When do they bind? Events: a bond is made; the first of them."""
    walk.choose('events-kind', 'bind')
    walk.click(b.all('[data-testid="events-list"] .row')[0])
    legs, run = b.state()['legs'], b.js('return scc.data.runs.find((run) => run.name === scc.state().run)')
    labels = b.js('return scc.data.labels')
    kinds = [labels[step['label']]['kind'] for step in run['steps']]
    return legs == kinds.index('bind') + 1 and ' bind by ' in b.text('now-words')


def another(walk, b):
    """Another outcome: one event back, another choice."""
    walk.click('previous')
    choices = [row for row in b.all('[data-testid="choices-list"] .row, [data-testid="choice"]') if 'taken' not in row.text]
    walk.click(choices[0])
    return b.state()['way'] is not None


def position(walk, b):
    """An exact position: Bodies, a body."""
    walk.click('tab-details')
    walk.click(walk.row('bodies-list', 'atp'))
    shown = [b_.text for b_ in b.all('[data-testid="fact-position"] .exact')]
    return shown == b.state()['bodies']['atp']['position']


def distance(walk, b):
    """Plot a distance: the field of Plots, the formula."""
    walk.write('plot-input', 'distance2(atp, glucose)')
    return any(plot['text'] == 'distance2(atp, glucose)' and plot['value'] for plot in b.js('return scc.plots()'))


def picture(walk, b):
    """A picture for a paper: Save, a size, Save."""
    walk.click('export')
    walk.choose('export-size', '85')
    told = b.text('export-told')
    saved = b.js("""
      window.saved = null;
      const create = URL.createObjectURL;
      URL.createObjectURL = (blob) => { window.saved = blob; return create(blob); };
      return true;""")
    walk.click('export-save')
    return saved and '1004' in told and b.wait('return window.saved && window.saved.size > 1000')


def start(walk, b):
    """A start in a region: Where, a place of the drawing."""
    walk.click('tab-where')
    walk.click('where')
    return ': ' in b.text('where-verdicts')


TASKS = [(HEXOKINASE, task) for task in [why, compare, follow, open_site, binding, another, position, distance, picture]] + [(MEETING, start)]


def ten_tasks(b, scc):
    """Each of the tasks takes at most three clicks."""
    folder = os.environ.get('WALK')
    b.prefer(color_scheme='light')
    pages = {model: scc.view(model) for model in {model for model, _ in TASKS}}
    for k, (model, task) in enumerate(TASKS, 1):
        b.open(pages[model])
        if task in (open_site, another):
            b.js('scc.go(0)' if task is open_site else 'scc.go(3)')
        walk = Walk(b)
        check(f'task {k}, {task.__doc__}', task(walk, b))
        check(f'task {k} takes at most three clicks', walk.clicks <= 3, walk.clicks)
        if folder:
            b.js('return new Promise((done) => setTimeout(done, 500))')
            b.driver.save_screenshot(os.path.join(folder, f'{k}-{task.__name__}.png'))
            print(f'| {k} | {walk.clicks} | {task.__doc__} |')
        same(f'task {k}: the console is told nothing', b.complaints(), [])


PARTS = [ten_tasks]
