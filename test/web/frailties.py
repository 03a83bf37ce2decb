"""Pages that are not whole, tiny bodies, refused formulas and reasons that are told once."""
import json
import re
import time
from urllib.parse import unquote

from browser import Keys
from browser_test import check, same
from scenes import SEEN, written

CUBES = """import <solids>
process a = solids.Cube({0}) mass 1 velocity ({0}, 0, 0) [nil]
process b = solids.Cube({0}) mass 1 at translate (3*{0}, {0}, 0) [nil]
"""


def still(b, script):
    """What a script gives once the camera has arrived, however busy the machine is."""
    found, before = b.js(script), None
    while found != before:
        time.sleep(0.3)
        found, before = b.js(script), found
    return found


def tiny(b, scc):
    """The picture of bodies does not depend on how large they are, at first and after Fit, and zooming is bounded alike."""
    b.prefer(color_scheme='light')
    sight = 'return Object.values(scc.floats()).map((p) => scc.sight(p).at.map(Math.round))'
    ink = 'return document.querySelector("#scene canvas").toDataURL().length'
    pictures = []
    for k in [0, 3, 6, 8, 9, 12, 15, -6, -9, -12, -15]:
        b.open(scc.view(written(scc, CUBES.format(f'1e{-k}'))))
        first = b.js(sight)
        b.js('scc.sight([0, 0, 0]); document.querySelector("#scene canvas").focus()')
        b.keys('z', 'z', 'z')
        b.find('fit').click()
        b.js('return new Promise((done) => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 500))')
        again = still(b, sight)
        camera = json.loads(unquote(b.js('return scc.link()').split('camera=', 1)[1].split('&')[0]))
        pictures.append((k, first, again, camera['distance'] * 10.0 ** k, b.js(ink)))
    _, first, again, distance, size = pictures[0]
    for k, *found in pictures[1:]:
        same(f'where bodies are, 10^-{k}', found[:2], [first, again])
        check(f'how far away the camera is, 10^-{k}', abs(found[2] / distance - 1) < 1e-3, (found[2], distance))
        check(f'as much is drawn, 10^-{k}', 0.9 < found[3] / size < 1.1, (found[3], size))
    same('the console is told nothing', b.complaints(), [])


#: Keeps the words that are drawn on each canvas, with their boxes.
KEEP_WORDS = '''
const pen = CanvasRenderingContext2D.prototype, { fillText, clearRect } = pen;
window.words = new Map();
pen.clearRect = function (...box) { words.set(this.canvas, []); return clearRect.apply(this, box); };
pen.fillText = function (text, x, y) {
  const m = this.measureText(text), all = words.get(this.canvas) || [];
  all.push([text, x - m.actualBoundingBoxLeft, y - m.actualBoundingBoxAscent, x + m.actualBoundingBoxRight, y + m.actualBoundingBoxDescent]);
  words.set(this.canvas, all);
  return fillText.call(this, text, x, y);
};
'''
WORDS = 'scc.sight([0, 0, 0]); return words.get(document.querySelectorAll("#scene canvas")[1])'
FAR = """import <solids>
process a = solids.Cube({1}) mass 1 at translate ({0}, 5*{1}, 0) velocity ({1}, 0, 0) [nil]
process b = solids.Cube({1}) mass 1 at translate ({0} + 8*{1}, 5*{1}, 0) [nil]
"""


def meet(one, other):
    _, a, b, c, d = one
    _, e, f, g, h = other
    return a < g - 0.5 and e < c - 0.5 and b < h - 0.5 and f < d - 0.5


def words(b, scc):
    """No two numbers at the floor are written alike, and no word of the scene is on another one or cut off."""
    script = b.command('Page.addScriptToEvaluateOnNewDocument', source=KEEP_WORDS)['identifier']
    axes = set('xyz')
    for at, size in [('0', '1'), ('1e17', '1'), ('0', '1e15'), ('1e30', '1e15'), ('3', '1e-15'), ('7e7', '1e-4'), ('-2e8', '1e5'),
                     ('1e12', '1e8'), ('1/7', '1e-8')]:
        b.open(scc.view(written(scc, FAR.format(at, size))))
        found = b.js(WORDS)
        numbers = [text for text, *_ in found if re.search(r'[0-9]', text)][1:]  # the scale comes first
        reds = [text.split(' = ')[-1] for text in numbers]
        check(f'{at}, {size}: there are numbers', len(reds) >= 3, found)
        twice = {text for text in reds if reds.count(text) > 1}
        check(f'{at}, {size}: both axes have a number alike at most once', all(reds.count(text) == 2 for text in twice), reds)
        check(f'{at}, {size}: they are short', all(len(text) <= 30 for text in reds), reds)
    for model in ['eject', 'hexokinase', 'association', 'glycolysis', 'brownian', 'ring']:
        for size in [(400, 700), (1400, 900)]:
            b.size(*size)
            b.open(scc.view(f'specs/models/{model}.sc'))
            for what in ['at first', 'names']:
                if what == 'names':
                    b.find('names').click()
                found, width = b.js(WORDS), b.js('return document.getElementById("scene").clientWidth')
                on = [(p[0], q[0]) for i, p in enumerate(found) for q in found[:i] if meet(p, q)]
                same(f'{model}, {size}, {what}: no word is on another one', on, [])
                marked = [w[0] for w in found if '→' in w[0] and not 0 <= w[1] <= w[3] <= width]
                same(f'{model}, {size}, {what}: what has changed is told in full', marked, [])
    check('the axes have names', axes <= {text for text, *_ in found}, found)
    b.size(1400, 900)
    b.command('Page.removeScriptToEvaluateOnNewDocument', identifier=script)
    same('the console is told nothing', b.complaints(), [])


def long_formulas(b, scc):
    """The page goes on while formulas of a thousand terms are drawn."""
    b.open(scc.view('specs/models/gears.sc'))
    for term in ['x(driver) / {0}', 'vx(driver) * y(driven)']:
        text = ' + '.join(term.format(i + 1) for i in range(1000))
        most = b.js('''
          const box = document.querySelector("[data-testid=plot-input]");
          box.value = arguments[0];
          box.form.requestSubmit();
          return new Promise((done) => {
            let last = performance.now(), most = 0, count = 0;
            const on = () => {
              most = Math.max(most, performance.now() - last);
              last = performance.now();
              if (count++ < 20) setTimeout(on); else done(most);
            };
            setTimeout(on);
          });''', text)
        # At most some instants at once, of the hundreds that are drawn; it took minutes.
        check(f'{term}: the page is held for a moment at most', most < 5000, most)
        value = b.js('return scc.plots().at(-1)')
        check(f'{term}: its value is exact', value['text'] == text and re.fullmatch(r'-?\d+(/\d+)?', value['value']), str(value)[-200:])
    same('the console is told nothing', b.complaints(), [])


def refused(b, scc):
    """A formula that is refused changes nothing, however many plots there are."""
    b.open(scc.view(written(scc, CUBES.format('1') + 'check c : always x(a) <= 9 within 2\n')))
    seen = 'return [scc.plots().map((plot) => plot.text), document.querySelectorAll("figure.plot").length]'
    for count in [0, 4, 12]:
        while len(b.all('figure.plot')) < count:
            b.find('plot-input').send_keys(f'time + {len(b.all("figure.plot"))}', Keys.ENTER)
        before = b.js(seen)
        for text in ['x(nobody)', 'x(a) +', '\U0001f600', 'x(a) \U0001f600 1']:
            b.js('const box = document.querySelector("[data-testid=plot-input]"); box.value = arguments[0]; box.form.requestSubmit()', text)
            check(f'{text} is refused', b.find('plot-wrong').is_displayed())
            same(f'{text}, beside {count} plots', b.js(seen), before)
            check(f'none gave way to {text}', not b.find('plot-note').is_displayed(), b.text('plot-note'))
            if '\U0001f600' in text:
                same('a sign is told whole', b.js('return document.querySelector("[data-testid=plot-wrong] mark").textContent'), '\U0001f600')
                check('in words as well', '“\U0001f600”' in b.text('plot-wrong'), b.text('plot-wrong'))
            b.js('document.querySelector("[data-testid=plot-input]").value = ""')
    b.open(scc.view(written(scc, 'import <solids>\nprocess Big = solids.Cube(1) mass 1 [nil]\ncheck c : always x(Big) < 9\n')))
    b.find('plots-choose').click()
    b.js('for (const box of document.querySelectorAll(".plot-menu input:checked")) box.click()')
    check('names are as they are written', 'x(Big)' in b.text('plots-none') and 'x(big)' not in b.text('plots-none'), b.text('plots-none'))
    b.open(scc.view(written(scc, 'import <solids>\nfixed f = solids.Cube(1)\n')))
    check('no body is named where none moves', 'x(' not in b.find('plot-input').get_attribute('placeholder'))
    same('the console is told nothing', b.complaints(), [])


GONE = """import <solids>
timestep 1 steady
process p = solids.Cube(1) mass 1 [nil]
motion p = choose { (1,0,0) weight 1, (-1,0,0) weight 2 }
fixed a = solids.Cube(1) absorb at translate (-4,0,0)
fixed b = solids.Cube(1) absorb at translate (5,0,0)
check gone_p : P >= 99/100 [ eventually gone(p) within 6 ]
"""


def once(b, scc):
    """What stands under Because does not stand under How it ends as well."""
    for model in [written(scc, GONE), 'specs/models/latch.sc', 'specs/models/pendulum.sc']:
        b.open(scc.view(model))
        for at in range(len(b.js('return scc.runs()'))):
            b.js('scc.open(arguments[0])', at)
            words = b.js('return document.getElementById("why").textContent')
            check(f'{model}: no heading of a terminal', 'why:' not in words, words[:400])
            same(f'{model}: the claim is told once', words.count('the least probability is'), 'Pmin' in words)


def partial(b, scc):
    """A page that is cut off says so, wherever it is cut; so does one whose data is not right."""
    with open(scc.view(written(scc, CUBES.format('1'))), encoding='utf-8') as file:
        text = file.read()

    def opened(what, text, says):
        path = scc.file('.html')
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)
        b.shown = path
        b.driver.get('file://' + path)
        notice = b.js('const box = document.querySelector(".notice:not([hidden])"); return box ? box.textContent : ""')
        check(f'{what}: it is said', re.search(says, notice), notice)

    body, data, scripts = text.index('<body>'), text.index('id="data">'), text.index('</script>', text.index('id="data">'))
    for at in [body + 10, (body + data) // 2, data + 12, (data + scripts) // 2, scripts + 30, (scripts + len(text)) // 2, text.rindex('</script>') - 1]:
        opened(f'cut after {at} of {len(text)} signs', text[:at], 'This page is not whole')
    given = json.loads(text[data + 10:scripts])

    def changed(what, says, **members):
        opened(what, text[:data + 10] + json.dumps({**given, **members}).replace('<', '\\u003c') + text[scripts:], says)

    run = given['runs'][0]
    says = 'cannot be shown: the file '
    changed('no runs', says + 'holds no runs', runs=[])
    for start in [-1, 99, 'x', 0.5]:
        changed(f'start {start}', says, runs=[{**run, 'start': start}])
    for step in [{'choice': 0, 'label': 0, 'to': 99, 'rules': []}, {'choice': 0, 'label': 99, 'to': 0, 'rules': []}]:
        changed(f'step {step}', says, runs=[{**run, 'steps': [step]}])
    b.complaints()


def addresses(b, scc):
    """Whatever part of an address is not followed is told."""
    page = scc.view(written(scc, CUBES.format('1')))
    for wrong in ['step=-1', 'run=0&step=99', 'step=1x', 'time=-1', 'time=99999999', 'select=0.0.face.999', 'select=0.9.face.0', 'select=0.0.nose.1',
                  'select=0.0.face.x', 'select=0.0', 'size=0x0', 'size=axb', 'size=3', 'nothing=1', 'way=0.1']:
        b.open(page, wrong)
        check(f'{wrong} is told', b.text('notice').startswith('The address was not followed in all'), b.text('notice'))
    for right in ['step=0', 'run=0&step=0&time=0', 'time=1/2', 'select=0', 'select=0.0.face.1', 'size=800x600']:
        b.open(page, right)
        check(f'{right} is followed', not b.find('notice').is_displayed(), b.text('notice'))
    same('the console is told nothing', b.complaints(), [])


PARTS = [tiny, words, long_formulas, refused, once, partial, addresses]
