"""What the scene marks, compares and saves."""
import base64
import os
import shlex
import shutil
import struct
import subprocess
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
    for model in ['brownian', 'glycolysis']:
        b.open(scc.view(f'specs/models/{model}.sc', '--graph', '4', '--seconds', '5'))
        check(f'seams are whole within the room of {model}', b.js(SEEN, LIT) > 1000, b.js(SEEN, LIT))
    same('the console is told nothing', b.complaints(), [])


SHADED = """import <solids>
fixed slab = solids.Plank(6, 1/2, 6)
process p = solids.Cube(2) mass 1 at translate (0, 2, 0) [nil]
"""


def shadows(b, scc):
    """Shadows are straight below what has them, and soft."""
    b.prefer(color_scheme='light')
    b.open(scc.view(written(scc, SHADED)))
    seen = b.js("""return [...Array(60).keys()].map((i) => scc.sight([0.3 + i / 30, 0.25, 0.9])).map(({ name, color }) => [name, color[1]])""")
    same('what is looked at', {name for name, _ in seen}, {'slab'})
    lights = [light for _, light in seen]
    check('it is dark below the body, and light beside it', lights[-1] - lights[0] > 25, lights)
    check('from dark to light by small steps', max(abs(y - x) for x, y in zip(lights, lights[1:])) <= 12, lights)
    among = [light for light in lights if lights[0] + 2 < light < lights[-1] - 2]
    check('of which there are many', len(set(among)) >= 6, among)
    same('the console is told nothing', b.complaints(), [])


ABSORBED = """import <solids>
process p = solids.Cube(1) mass 1 velocity (-3, 0, 0) at translate (-6, 0, 0) [nil]
fixed bin = solids.Cube(1) absorb at translate (-13, 0, 0)
process q = solids.Cube(1) mass 1 at translate (1, 0, 0) velocity (1/10, 0, 0) [nil]
check stays : always not (gone(p) and x(q) > 2)
"""


def gone(b, scc):
    """Bodies that a reason is about and that are gone by then are outlined where they were last, within the picture."""
    within = """
      const all = scc.marks()[arguments[0]].map(([, ...at]) => scc.sight(at.map((text) => {
        const [n, d] = text.split("/").map(Number);
        return n / (d || 1);
      })).at);
      const box = document.getElementById("scene"), bar = document.getElementById("scene-tools").getBoundingClientRect();
      return all.every(([x, y]) => x > 0 && y > 0 && x < box.clientWidth && y < bar.top - box.getBoundingClientRect().top);"""
    b.open(scc.view('specs/models/outlet.sc'))
    told = b.js('return scc.marks()')
    same('what the step and those before took away', (told['before'], told['gone']),
         ([['first', '12', '0', '0']], [['second', '12', '0', '0']]))
    check('both are within the picture', b.js(within, 'before') and b.js(within, 'gone'))
    b.js('scc.go(0)')
    same('at the beginning none is gone', b.js('return scc.marks().gone'), [])
    b.open(scc.view(written(scc, ABSORBED)))
    told = b.js('return scc.marks()')
    same('one that a reason names', (told['lit'], [one[0] for one in told['gone']]), (['p', 'q'], ['p']))
    check('it is within the picture', b.js(within, 'gone'))
    b.js('scc.state()')
    b.find('tab-details').click()
    b.all('[data-testid="bodies-list"] [data-index="0"]')[0].click()
    check('its last place is told', 'gone since' in b.text('selected') and 'last position' in b.text('selected'), b.text('selected'))
    b.find('marks').click()
    same('without marks there are none', b.js('return scc.marks().gone'), [])
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


#: Two are bound, and move on while chance may part them.
DRIFTS = """import <solids>
split_step 1/2
behaviour O = <l, {right}>. B
behaviour B = omega(l, {right}) rate 1/2. O
behaviour P = <~l, {left}>. Q
behaviour Q = omega(l, {left}). P
process a = solids.Cube(1) mass 1 velocity (1/3, 0, 0) [O]
process b = solids.Cube(1) mass 1 at translate (3, 0, 0) [P]
check ends : eventually event weak(l)
"""


def beyond(b, scc):
    """Two runs after the last step that is told of one: for ever, by its repeated steps, or not at all."""
    def both(one, two):
        """Shows a run, and compares with another; what is told of it at a time."""
        for call, name in [('open', one), ('compare', two)]:
            check(f'there is a run {name}', b.js(
                'const k = scc.runs().findIndex((run) => run.name === arguments[1]); scc[arguments[0]](k); return k >= 0',
                call, name))
        return lambda time: b.js('scc.seek(arguments[0]); return scc.compared()', time)

    # One walks from 1 to 0 and back for ever, the other one is absorbed at time 4.
    b.open(scc.view('specs/models/ruin.sc'))
    at = both('ends, otherwise', 'ends')
    told = at('3')
    same('what repeats goes on', (told['time'], told['parts'], told['followed'], told['differences']), ('3', '3', True, []))
    check('both events of the first difference are told', told['words'].count('at time 3') == 2, told['words'])
    same('and it is where the period says', at('4')['differences'], ['walker (there alone)'])
    at = both('ends', 'ends, otherwise')
    told = at('2')
    check('a difference after the end of the run is told', 'after the end of what is shown of this run' in told['words'], told['words'])
    same('no button leads there', len(b.all('[data-testid="compare-difference"]')), 0)
    b.wait('return document.querySelector("[data-testid=live]").textContent.includes("time 2")')
    b.keys('j')
    same('and no key', (b.state()['time'], b.text('live')), ('2', told['words']))
    at = both('rich', 'ruined')
    same('what rests is over', at('3')['now'], 'Nothing differs now. Nothing more happens in the other run.')

    b.open(scc.view('specs/models/capsid.sc'))
    words = 'The same as far as both are followed: 2 events, until time 1.'
    at = both('first choices', 'pairs')
    same('as far as both are followed', (at('1/2')['words'], at('1/2')['parts'], at('1/2')['differences']), (words, None, []))
    for time in ['1', '2']:
        told = at(time)
        same('a beginning is not compared after its end', (told['now'], told['differences'], told['followed']),
             ('The other run is not followed further.', [], False))
    check('nor drawn', b.js(SEEN, [0, 0x80, 0x9c]) == 0)
    same('the other way about', both('pairs', 'first choices')('1')['words'], words)

    # One goes on by the same steps elsewhere, for ever.
    b.open(scc.view(written(scc, DRIFTS)))
    told = both('ends', 'ends, otherwise')('0')
    here, there = [run for run in b.js('return scc.data.runs') if run['name'].startswith('ends')]
    labels = b.js('return scc.data.labels')
    length = lambda run: sum(Fraction(labels[step['label']].get('duration', '0')) for step in run['steps'])
    check('it parts after the end of what is shown of it', length(there) > length(here), (length(here), length(there)))
    check('what is drawn anew there is told', 'Then here: a and b are to keep' in told['words'] and
          'There: a and b are to release' in told['words'] and told['words'].count('at time 7') == 2, told['words'])
    same('and when', told['parts'], '7')
    # What rests goes straight on.
    b.open(scc.view(written(scc, """import <solids>
process p = solids.Cube(1) mass 1 velocity (1, 0, 0) [nil]
process q = solids.Cube(1) mass 1 at translate (0, 5, 0) velocity (0, 0, 0) [nil]
check soon : possibly x(p) >= 2
check late : possibly x(p) >= 9
""")))
    told = both('late', 'soon')('5')
    same('what rests goes straight on', (told['differences'], told['time'], told['followed'], told['now']),
         ([], '5', True, 'Nothing differs now. Nothing more happens in the other run.'))
    same('the console is told nothing', b.complaints(), [])


SAVED = '''
const done = arguments[1];
scc.file(arguments[0]).then((bytes) => {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  done(btoa(text));
}, (error) => done("! " + error));
'''


def saved(b, **wishes):
    """The bytes of the file that is saved."""
    text = b.driver.execute_async_script(SAVED, wishes)
    if text.startswith('!'):
        raise RuntimeError(text)
    return base64.b64decode(text)


def chunks(png):
    """The parts of a file of PNG, by their names."""
    found, at = {}, 8
    while at < len(png):
        size, = struct.unpack('>I', png[at:at + 4])
        found.setdefault(png[at + 4:at + 8].decode(), png[at + 8:at + 8 + size])
        at += size + 12
    return found


def size_of(png):
    return struct.unpack('>II', chunks(png)['IHDR'][:8])


#: Pixels of pictures, of which a mask says what is there: where it is not clear, or not white, as glass is. How many both have, and how many
#: one of them has alone.
MASKS = '''
const [one, two, width, height, done] = arguments;
async function mask(address, there) {
  const image = new Image();
  image.src = address;
  await image.decode();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const pen = canvas.getContext("2d");
  pen.drawImage(image, 0, 0);
  const { data } = pen.getImageData(0, 0, width, height), all = [];
  for (let i = 0; i < data.length; i += 4) all.push(there(data[i], data[i + 1], data[i + 2], data[i + 3]));
  return all;
}
(async () => {
  const a = await mask(one, (r, g, b, alpha) => alpha > 40), b = await mask(two, (r, g, b) => r + g + b < 762);
  // Pixels of one of them that are more than two pixels away from the other one: lines differ in their widths.
  const away = (one, two) => one.filter((x, i) => {
    if (!x) return false;
    for (let dy = -2; dy <= 2; dy++) for (let dx = -2; dx <= 2; dx++) if (two[i + dy * width + dx]) return false;
    return true;
  }).length;
  done([a.filter((x, i) => x && b[i]).length, away(a, b) + away(b, a)]);
})().catch((error) => done(String(error)));
'''


def blank(b, scc, body=''):
    page = scc.file('.html')
    with open(page, 'w', encoding='utf-8') as f:
        f.write(f'<!DOCTYPE html><body data-ready="true">{body}')
    b.open(page)


def address(kind, content):
    return f'data:{kind};base64,{base64.b64encode(content).decode()}'


def drawn(b, scc, model):
    """What the command on the page draws, as SVG, with the schedule that the page saves for it."""
    command = shlex.split(b.js('return scc.command({size: "own", pixels: arguments[0]})', b.js('return scene.clientWidth')))
    path = scc.file('.svg')
    command[-1] = path
    command[2] = model
    if '--schedule' in command:
        schedule = command[command.index('--schedule') + 1] = scc.file('.json')
        with open(schedule, 'w', encoding='utf-8') as f:
            f.write(b.js('return JSON.stringify(scc.schedule())'))
    ended = scc.run(*command[1:])
    if ended.returncode != 0:
        raise RuntimeError(f'{command}: {ended.stderr}')
    with open(path, 'rb') as f:
        return f.read()


#: A wall that hides what moves, and what is beside it; all around it is empty.
WALL = """import <solids>
fixed wall = box(1/2, 12, 12) at translate (5, 0, 0)
process a = solids.Cube(1) mass 1 velocity (1, 0, 0) [nil]
process b = solids.Cube(1) mass 1 velocity (0, 0, 0) at translate (8, 2, 0) [nil]
check m : always vx(a) >= 0
"""

#: Models, scripts that lead to a state and a camera.
SIGHTS = [
    (HEXOKINASE, ''),
    ('specs/models/docking.sc', 'scc.open(scc.runs().length - 1); scc.seek("7/4")'),
    ('specs/models/latch.sc', 'document.getElementById("tool-projection").click()'),
    ('specs/models/capsid.sc', 'document.getElementById("tool-up").click()'),
    ('specs/models/gears.sc', 'document.getElementById("tool-up").click(); document.getElementById("tool-up").click()'),
    ('specs/models/brownian.sc', ''),
    ('specs/models/glycolysis.sc', 'document.getElementById("tool-projection").click()'),
    ('specs/models/exclusion.sc', ''),
    ('specs/models/billiard.sc', 'document.getElementById("tool-up").click()'),
    ('specs/models/ligand.sc', ''),
]


def silhouettes(b, scc):
    """The command on the page draws what the page shows, in the same frame: all bodies of both cover the same."""
    wall = written(scc, WALL)
    for model, script in [*SIGHTS, (wall, ''), (wall, 'document.getElementById("tool-projection").click()'),
                          (wall, 'document.getElementById("tool-up").click()')]:
        if not os.path.exists(model):
            check(f'{model} is there', False)
            continue
        b.open(scc.view(model))
        b.js(script)
        b.js('for (const of of ["marks", "grid"]) document.getElementById("tool-" + of).click()')
        wide = b.js('return scene.clientWidth')
        svg = drawn(b, scc, model)
        png = saved(b, kind='png', size='own', pixels=wide, background='transparent', legend=False, bar=False,
                    clock=False, axes=False)
        # The words below the drawing are left out.
        width, height = size_of(png)
        blank(b, scc)
        both, apart = b.driver.execute_async_script(MASKS, address('image/png', png), address('image/svg+xml', svg),
                                                     width, height)
        check(f'{model}: one silhouette', both > 2000 and apart <= 2, (both, apart))


def by_schedule(b, scc):
    """A run of one's own is drawn by its schedule, and so is a state before the last one of its instant."""
    b.open(scc.view(HEXOKINASE))
    whole = b.js('return scc.schedule()')
    same('the run of a check, as it is shown', len(whole['choices']), b.state()['legs'])
    b.js('scc.go(2)')
    run = b.js('return scc.schedule()')
    same('a state within an instant', len(run['choices']), 2)
    svg = drawn(b, scc, HEXOKINASE).decode()
    check('its bond is drawn', '&lt;atp, {enzyme.floorA.top, atp.bottom}&gt;' in svg)
    last = scc.file('.svg')
    scc.run('view', HEXOKINASE, '--check', 'surely', '--svg', '2', '-o', last)
    with open(last, encoding='utf-8') as f:
        check('and it is split at the end of that instant', '&lt;atp,' not in f.read())


def pictures(b, scc):
    """PNG for papers and for screens, white or transparent, with what is chosen."""
    b.prefer(color_scheme='dark')
    b.open(scc.view(HEXOKINASE))
    wide, high = b.js('return [scene.clientWidth, scene.clientHeight]')
    for mm, pixels in [('85', 1004), ('180', 2126)]:
        png = saved(b, kind='png', size=mm)
        same(f'{mm} mm at 300 dpi', (size_of(png)[0], chunks(png).get('pHYs')), (pixels, struct.pack('>IIB', 11811, 11811, 1)))
        check('as high as the page has it', abs(size_of(png)[1] - pixels * high / wide) <= 1)
    bare = dict(kind='png', size='own', pixels=300, legend=False, bar=False, clock=False, axes=False)
    corner = """
      const [address] = arguments, done = arguments[1], image = new Image();
      image.onload = () => {
        const canvas = document.createElement("canvas"), pen = canvas.getContext("2d");
        pen.drawImage(image, 0, 0);
        done([...pen.getImageData(1, 1, 1, 1).data]);
      };
      image.src = address;"""
    white, clear, page = [saved(b, **bare, background=of) for of in ('white', 'transparent', 'page')]
    with_words = saved(b, **{**bare, 'clock': True}, background='white')
    check('the clock is written where it is wanted', with_words != white)
    before = b.js('return [scc.look(), document.querySelector("#scene canvas").width]')
    same('afterwards the page is as it was', before[1], wide)
    blank(b, scc)
    colors = [b.driver.execute_async_script(corner, address('image/png', one)) for one in (white, clear, page)]
    same('backgrounds', colors, [[255, 255, 255, 255], [0, 0, 0, 0], [0x16, 0x1b, 0x22, 255]])
    b.prefer(color_scheme='light')


README = 'specs/pictures/page.png'
#: How much pixels of two pictures of one size differ in the mean, of 255.
APART = """
  const [one, two, done] = arguments;
  async function pixels(address) {
    const image = new Image(), canvas = document.createElement("canvas"), pen = canvas.getContext("2d");
    image.src = address;
    await image.decode();
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    pen.drawImage(image, 0, 0);
    return pen.getImageData(0, 0, canvas.width, canvas.height).data;
  }
  (async () => {
    const [a, b] = [await pixels(one), await pixels(two)];
    done(a.length !== b.length ? 255 : a.reduce((sum, x, i) => sum + Math.abs(x - b[i]), 0) / a.length);
  })().catch((error) => done(String(error)));"""


def readme(b, scc):
    """The picture of the README is the one that the page saves. By hand: PICTURE=FILE saves it anew."""
    b.prefer(color_scheme='light')
    b.open(scc.view(HEXOKINASE))
    b.js('scc.open(scc.runs().findIndex((run) => run.name === "first choices")); scc.seek("1")')
    for name in ['marks', 'names']:
        b.find(name).click()
    png = saved(b, kind='png', size='own', pixels=900, background='white', legend=True, bar=True, clock=True, axes=True)
    if os.environ.get('PICTURE'):
        with open(os.environ['PICTURE'], 'wb') as f:
            f.write(png)
    with open(README, 'rb') as f:
        kept = f.read()
    blank(b, scc)
    apart = b.driver.execute_async_script(APART, address('image/png', png), address('image/png', kept))
    # Letters and edges are drawn a little differently by other versions and fonts.
    check('the picture of the README', isinstance(apart, (int, float)) and apart < 4, apart)


FILMED = """
  const [time] = arguments, done = arguments[1], film = document.querySelector("video");
  // A busy browser may have sought, and no picture of it yet.
  const draw = (tries) => {
    const canvas = document.createElement("canvas"), pen = canvas.getContext("2d");
    [canvas.width, canvas.height] = [film.videoWidth, film.videoHeight];
    pen.drawImage(film, 0, 0);
    const data = pen.getImageData(0, 0, canvas.width, canvas.height).data;
    if (tries > 0 && data.every((x, i) => i % 4 !== 3 || x === 0)) setTimeout(draw, 100, tries - 1);
    else done([...data.filter((_, i) => i % 4 !== 3)]);
  };
  film.onseeked = () => draw(50);
  film.currentTime = time;"""


def films(b, scc):
    """A film decodes, is as long as playing takes, and has the same bytes each time."""
    b.open(scc.view(HEXOKINASE))
    b.keys('+', '+', '+')
    where, wishes = b.state(), dict(kind='film', size='own', pixels=160, rate=10)
    film = saved(b, **wishes)
    same('the same each time', saved(b, **wishes) == film, True)
    same('afterwards the page is where it was', b.state(), where)
    wide, high = b.js('return [scene.clientWidth, scene.clientHeight]')
    if shutil.which('ffprobe'):
        path = scc.file('.webm')
        with open(path, 'wb') as f:
            f.write(film)
        told = subprocess.run(['ffprobe', '-v', 'error', '-count_frames', '-show_entries', 'stream=nb_read_frames:format=duration',
                               '-of', 'csv=p=0', path], capture_output=True, text=True).stdout.split()
        check('ffprobe counts its frames', told and told[0] == '25' and abs(float(told[1]) - 2.5) < 0.05, told)
    blank(b, scc, f'<video muted src="{address("video/webm", film)}"></video>')
    seen = b.wait('const film = document.querySelector("video"); return film.error ? [film.error.message] : '
                  'film.readyState > 1 && [film.duration, film.videoWidth, film.videoHeight]')
    # Time 2 at 1/5 a second is 10 seconds, 4 events take half a second each; all of it 8 times as fast; the end is seen
    # for a second.
    check('it decodes, and is so long', len(seen) == 3 and abs(seen[0] - (12 / 8 + 1)) <= 0.2, seen)
    same('and so large', seen[1:], [160, 2 * round(160 * high / wide / 2)])
    first, again, later = [b.driver.execute_async_script(FILMED, time) for time in (0.02, 0.05, 2.3)]
    apart = lambda one, two: sum(abs(x - y) for x, y in zip(one, two)) / len(one)
    check('its pictures move', apart(first, later) > 2 and apart(first, again) < 1, (apart(first, later), apart(first, again)))


def dialog(b, scc):
    """Saving by keys alone."""
    b.open(scc.view(HEXOKINASE))
    b.keys('i')
    check('the dialog opens', b.find('export-dialog').is_displayed())
    same('keys of the page do nothing then', (b.keys(Keys.HOME), b.state()['legs'])[1], 5)
    check('how large it is', 'pixels' in b.text('export-told'), b.text('export-told'))
    Select(b.find('export-kind')).select_by_value('svg')
    command = b.text('export-command')
    check('the command', command.startswith('scc view hexokinase.sc ') and ' --schedule hexokinase.json --svg 2 ' in command, command)
    Select(b.find('export-kind')).select_by_value('film')
    check('how long it is', ' 13.0 s ' in b.text('export-told'), b.text('export-told'))
    b.keys(Keys.ESCAPE)
    check('and closes', not b.find('export-dialog').is_displayed())
    same('the console is told nothing', b.complaints(), [])


PARTS = [marks, shadows, gone, compared, beyond, silhouettes, by_schedule, pictures, readme, films, dialog]
