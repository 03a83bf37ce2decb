"""The page of scc serve on which models are written, in a browser.

    desk_test.py SCC FOLDER    the program; a folder for its files

The last line is 'N passed, N failed'; it ends with 3 if something that it needs is not there, and says so last."""
import os
import re
import shutil
import signal
import subprocess
import sys
import time

import browser
import serve_test
from browser import ActionChains, Browser, By, Keys
from serve_test import ENDLESS, Served, check, same

DOCKING = 'specs/models/docking.sc'
COLD = '// Kälte: 🧊 – ω\n'


def read(path):
    with open(path, encoding='utf-8', newline='') as file:
        return file.read()


def write(path, text):
    with open(path, 'w', encoding='utf-8', newline='') as file:
        file.write(text)


class Desk(Browser):
    """A browser with desks."""

    def begin(self, scc, folder, name, text=None, **options):
        """Serves a model of its own, and opens its desk."""
        self.path = os.path.join(folder, name)
        if text is None:
            shutil.copy(DOCKING, self.path)
        else:
            write(self.path, text)
        self.served = Served(scc, self.path)
        self.url = f'http://127.0.0.1:{self.served.port}{self.served.root}'
        self.driver.get_log('browser')
        self.load(self.url, **options)
        return self

    def load(self, url, shown=True):
        self.driver.get(url)
        self.settled(shown)

    def settled(self, shown=True):
        check('the page is ready', self.wait('return document.body && document.body.dataset.ready === "true"'))
        self.wait('return desk.state().read')
        if shown:
            check('the model is shown', self.wait('return desk.document() !== null'))

    def end(self):
        same('nothing is told to the console', self.complaints(), [])
        self.driver.get('about:blank')  # or it would tell that the service has gone
        same('the end of the service', self.served.end(), 0)

    def is_read(self):
        return self.wait('return desk.state().read')

    def go(self, index):
        self.js('desk.go(arguments[0])', index)

    def at(self, text, word):
        """Leads the cursor to a word: places are counted in units of UTF-16."""
        self.go(len(text[:text.index(word)].encode('utf-16-le')) // 2)

    def chord(self, modifiers, key):
        chain = ActionChains(self.driver)
        for one in modifiers:
            chain.key_down(one)
        chain.send_keys(key)
        for one in modifiers:
            chain.key_up(one)
        chain.perform()

    def frame(self, script):
        """Of the view that is seen."""
        return self.js('const scc = document.querySelector("iframe.frame:not(.coming)").contentWindow.scc;' + script)

    def problems(self):
        return self.js('return desk.diagnostics()')

    def text_of(self):
        return self.js('return desk.text()')

    def said(self, words):
        return self.wait(f'return document.querySelector("[data-testid=said]").textContent.includes("{words}")')

    def no_problems(self):
        return self.js('return document.querySelector("[data-testid=problems]").parentElement.querySelector(".empty").textContent')

    def notice(self, name):
        return self.wait(f'return document.querySelector(`[data-testid="notice-{name}"]`) !== null')

    def no_notice(self, name):
        return self.wait(f'return document.querySelector(`[data-testid="notice-{name}"]`) === null')


def typing(b):
    """A mistake is told at its place, and mended; the view follows."""
    first = b.js('return desk.document()')
    b.go(0)
    b.js('desk.set(arguments[0] + desk.text())', COLD)
    b.at(b.text_of(), 'ship)\n')
    b.keys('x')
    b.wait('return desk.diagnostics().length > 0')
    same('a mistake and its place', [(d['code'], d['text']) for d in b.problems()], [('SC0201', 'xship')])
    marked = b.js('return [...document.querySelectorAll(".problem-error")].map((e) => e.textContent).join("")')
    same('it is underlined', marked, 'xship')
    same('a sign beside its line', len(b.all('.CodeMirror-gutter-elt .sign-error')), 1)
    same('its row', b.js('return document.querySelector(".problem-row").dataset.code'), 'SC0201')
    check('readers hear how many', b.said('1 error'))
    check('it is not saved', b.find('unsaved').is_displayed())
    check('the view is of an earlier text', b.find('older').is_displayed())
    b.go(0)
    b.keys(Keys.F8)
    lines = b.text_of().split('xship')[0].split('\n')
    same('a key leads there', b.js('return desk.state().place'), {'line': len(lines) - 1, 'ch': len(lines[-1]) + 5})
    mark = b.all('.problem-error')[0]
    ActionChains(b.driver).move_to_element(mark).perform()
    check('the mouse is told what is wrong', b.wait('''
      const tip = document.getElementById("tip");
      return !tip.hidden && tip.textContent.includes("SC0201")'''), b.text('tip'))
    b.at(b.text_of(), 'ship)\n')
    b.keys(Keys.BACKSPACE)
    check('what is mended is told no more', b.wait('return desk.diagnostics().length === 0'))
    check('the view follows', b.wait('return !desk.state().older'))
    check('it is another document', b.js('return desk.document()') != first)
    same('one frame is left', len(b.all('iframe')), 1)


def naming(b):
    """What a name is, and where it is declared."""
    b.at(b.text_of(), 'Docked\n')
    b.chord([Keys.ALT], 'h')
    check('a name is told by a key', b.wait('return !document.getElementById("tip").hidden'))
    check('it says what it is', 'Docked' in b.text('tip') and 'behaviour' in b.text('tip'), b.text('tip'))
    check('to readers as well', b.said('Docked'))
    b.keys(Keys.F12)
    declared = b.text_of().index('behaviour Docked')
    check('to its declaration', b.wait(f'return Math.abs(desk.cursor() - {declared}) < 25'),
          b.js('return desk.cursor()'), declared)
    word = next(e for e in b.all('.cm-def') if e.text == 'tug')
    ActionChains(b.driver).move_to_element(word).perform()
    check('the mouse is told as well', b.wait('''
      const tip = document.getElementById("tip");
      return !tip.hidden && tip.textContent.includes("tug")'''), b.text('tip'))


def offering(b):
    """What can be written at the cursor is listed by a key, follows what is typed, and is written."""
    text = b.text_of()
    b.js('desk.set(desk.text() + "\\nprocess other = ")')
    b.go(len(b.text_of().encode('utf-16-le')) // 2)
    listed = 'return [...document.querySelectorAll("#offers:not([hidden]) .offer-name")].map((e) => e.textContent)'
    shown = 'return !document.getElementById("offers").hidden'
    b.keys('C')
    same('nothing is listed by itself', b.js(listed), [])
    b.keys(Keys.BACKSPACE)
    b.chord([Keys.CONTROL], ' ')
    check('something is listed', b.wait(shown))
    check('shapes', 'Cube' in b.js(listed), b.js(listed))
    check('readers hear of them', b.said(' of '))
    b.keys('Cu')
    check('it follows what is typed', b.wait(listed + '.join() === "Cube"'), b.js(listed))
    b.keys(Keys.ENTER)
    check('what is chosen is written', b.text_of().endswith('\nprocess other = Cube'), b.text_of()[-40:])
    same('then nothing is listed', b.js(listed), [])
    b.keys(' mas')
    b.chord([Keys.CONTROL], ' ')
    check('what fits alone is written at once', b.wait('return desk.text().endsWith("= Cube mass")'), b.text_of()[-40:])
    b.keys(' 1 [')
    b.chord([Keys.CONTROL], ' ')
    check('behaviours are listed', b.wait(shown))
    names = b.js(listed)
    b.keys(Keys.ARROW_DOWN, Keys.TAB)
    check('arrows choose', b.text_of().endswith('[' + names[1]), b.text_of()[-40:])
    b.keys(*[Keys.BACKSPACE] * len(names[1]))
    b.chord([Keys.CONTROL], ' ')
    check('they are listed again', b.wait(shown))
    b.keys(Keys.ESCAPE)
    same('Escape ends it', b.js(listed), [])
    b.keys('\n')
    b.chord([Keys.CONTROL], ' ')
    check('all that can begin here', b.wait(shown))
    b.all('#offers .offer')[0].click()
    same('the mouse chooses', b.js(listed), [])
    b.js('desk.set(arguments[0])', text)
    b.is_read()


def mending(b):
    """A name that is spelt wrongly is mended by the button beside the hint."""
    text = b.text_of()
    b.js('desk.set(desk.text() + "\\nprocess spelt = Kube mass 1 at translate (90, 0, 0) [nil]\\n")')
    check('there is a button', b.wait('return document.querySelector("[data-testid=fix]") !== null'))
    b.all('[data-testid=fix]')[0].click()
    check('the name is mended', b.wait('return desk.text().includes("process spelt = Cube mass 1")'), b.text_of()[-90:])
    b.js('desk.set(arguments[0])', text)
    b.is_read()


# Answers about names are late.
LATE = '''
const fetched = window.fetch;
window.fetch = async (path, how) => {
  if (String(how.body).includes("text.describe")) await new Promise((done) => setTimeout(done, 600));
  return fetched(path, how);
};'''


def late(b):
    """An answer about an earlier text is not told in this one, and leads nowhere."""
    b.js(LATE)
    text = b.text_of()
    for what, key in [('a name', lambda: b.chord([Keys.ALT], 'h')), ('a declaration', lambda: b.keys(Keys.F12))]:
        b.js('desk.set(arguments[0])', text)
        b.at(text, 'Docked\n')
        key()
        b.js('desk.set("// one more line\\n" + desk.text())')
        before = b.js('return desk.cursor()')
        time.sleep(1.2)
        check(f'{what} is not told', b.js('return document.getElementById("tip").hidden'), b.text('tip'))
        same(f'the cursor stays, for {what}', b.js('return desk.cursor()'), before)
    b.js('desk.set(arguments[0])', text)
    b.is_read()


def formatting(b, scc):
    """Formats as scc fmt does, keeps the cursor at its word, and can be undone."""
    untidy = b.text_of().replace('process tug  = Cube', 'process   tug=Cube').replace('[Ready]', '[ Ready ]')
    b.js('desk.set(arguments[0])', untidy)
    b.at(untidy, 'let docked')
    b.chord([Keys.ALT, Keys.SHIFT], 'f')
    path = b.path + '.untidy.sc'
    write(path, untidy)
    wanted = subprocess.run([scc, 'fmt', path], capture_output=True, text=True).stdout
    b.said('Formatted')
    same('formatted as by scc fmt', b.text_of(), wanted)
    after = len(wanted[:wanted.index('let docked')].encode('utf-16-le')) // 2
    check('the cursor stays at its word', 0 <= after - b.js('return desk.cursor()') <= 2, b.js('return desk.cursor()'), after)
    b.chord([Keys.CONTROL], 'z')
    same('it can be undone', b.text_of(), untidy)
    b.chord([Keys.CONTROL], 'y')
    b.js('desk.set(desk.text() + "shape ")')
    b.find('format').click()
    check('what has errors is not formatted, and says so', b.notice('format'))
    b.js('desk.set(arguments[0])', wanted)
    b.is_read()


def saving(b):
    """Saves, and asks what to do when somebody else has written."""
    b.chord([Keys.CONTROL], 's')
    check('it is saved', b.wait('return !desk.state().unsaved'))
    same('what is in the file', read(b.path), b.text_of())
    check('the mark is gone', not b.find('unsaved').is_displayed())
    ours = b.text_of() + '// ours\n'
    theirs = read(b.path) + '// theirs\n'
    write(b.path, theirs)
    b.js('desk.set(arguments[0])', ours)
    b.chord([Keys.CONTROL], 's')
    check('a conflict is told', b.wait('return document.getElementById("conflict").open'))
    same('nothing is written', read(b.path), theirs)
    b.driver.get_log('browser')  # the browser tells of the answer 409
    b.find('conflict-on').click()
    same('one goes on', (b.text_of(), b.js('return desk.state().unsaved')), (ours, True))
    b.find('save').click()
    b.wait('return document.getElementById("conflict").open')
    b.find('conflict-take').click()
    same('what is in the file is taken', (b.text_of(), b.js('return desk.state().unsaved')), (theirs, False))
    b.chord([Keys.CONTROL], 'z')
    same('undo brings the own text back', (b.text_of(), b.js('return desk.state().unsaved')), (ours, True))
    write(b.path, theirs + '// again\n')
    b.find('save').click()
    b.wait('return document.getElementById("conflict").open')
    b.find('conflict-overwrite').click()
    b.wait('return !desk.state().unsaved')
    same('it is written over', read(b.path), ours)
    write(b.path, (ours + '// in lines\n').replace('\n', '\r\n'))
    b.js('desk.set(desk.text() + "// mine\\n")')
    b.find('save').click()
    b.wait('return document.getElementById("conflict").open')
    b.find('conflict-take').click()
    b.js('desk.set(desk.text() + "// on\\n")')
    b.find('save').click()
    b.wait('return !desk.state().unsaved')
    same('lines end as in what was taken', read(b.path), (ours + '// in lines\n// on\n').replace('\n', '\r\n'))
    write(b.path, ours)
    b.js('desk.set(desk.text() + "// mine\\n")')
    b.find('save').click()
    b.wait('return document.getElementById("conflict").open')
    b.find('conflict-take').click()
    os.remove(b.path)
    b.js('desk.set("")')
    b.find('save').click()
    check('nor is there an empty file', b.wait('return document.getElementById("conflict").open'))
    b.find('conflict-on').click()
    b.js('desk.set(arguments[0])', ours)
    b.js('desk.set(desk.text() + "// more\\n")')
    b.find('save').click()
    b.wait('return document.getElementById("conflict").open')
    check('a file that is gone', 'not there' in b.text('conflict'), b.text('conflict'))
    b.find('conflict-overwrite').click()
    b.wait('return !desk.state().unsaved')
    same('it is written anew', read(b.path), ours + '// more\n')
    b.driver.get_log('browser')


def checking(b):
    """Verdicts, each with its run; one check alone."""
    b.is_read()
    b.wait('return desk.state().working === null')
    b.chord([Keys.CONTROL], Keys.ENTER)
    check('verdicts', b.wait('return desk.verdicts().length === 8 && desk.state().working === null'))
    same('they hold', {v['verdict'] for v in b.js('return desk.verdicts()')}, {'holds'})
    check('readers hear of them', b.said('8 hold'))
    b.js('document.querySelector("[data-testid=verdicts]").focus()')
    b.keys(Keys.HOME, Keys.ENTER)
    check('a verdict on all runs has none of its own', b.said('no single run'))
    b.js('desk.set(desk.text() + "check never : always not docked\\ncheck soon : possibly docked\\n")')
    b.is_read()
    check('verdicts are of an earlier text then', b.find('verdicts-older').is_displayed())
    b.find('check').click()
    check('more verdicts', b.wait('return desk.verdicts().length === 10 && desk.state().working === null'))
    run = 'return document.querySelector("iframe.frame:not(.coming)").contentWindow.scc.state().run'
    same('what is violated is shown', b.js(run), 'never')
    b.js('document.querySelector("[data-testid=verdicts]").focus()')
    b.keys(Keys.END, Keys.ENTER)
    check('a verdict leads to its run', b.wait(f'{run} === "soon"'))
    b.js('document.getElementById("which").value = "heats"')
    b.find('check').click()
    check('one check alone', b.wait('return desk.verdicts().length === 1 && desk.state().working === null'))
    same('which', b.js('return desk.verdicts()[0].name'), 'heats')
    b.js('document.getElementById("which").value = ""')


# Two views, one right after the other: which of them were shown. The patience with which a view is awaited never ends here:
# who waits for it waits for ever.
TWO_VIEWS = '''
const timed = window.setTimeout, show = () => Frames.show(desk.document(), "", null);
window.setTimeout = (work, delay, ...rest) => (delay >= 10000 ? timed(() => {}, delay) : timed(work, delay, ...rest));
return Promise.all([show(), show()]).finally(() => { window.setTimeout = timed; });'''


def overtaking(b):
    """A view that comes while another one is loaded takes its place at once."""
    same('the newer one is shown, and nobody waits for the other one', b.js(TWO_VIEWS), [False, True])
    same('one frame is left', len(b.all('iframe')), 1)


def whole(b):
    """What is told of the model as a whole has no place in the text, and hinders nothing."""
    text = b.text_of()
    b.js('desk.set(arguments[0])', text + 'param free in [0, 1]\ncheck less : always x(tug) < free\n')
    b.is_read()
    b.wait('return !desk.state().older && desk.state().working === null')
    b.find('check').click()
    check('that it cannot be checked is told', b.wait('return desk.diagnostics().some((one) => one.place === null)'), b.problems())
    b.find('automatic').click()
    b.js('desk.set(arguments[0])', '// another text\n' + text)
    b.is_read()
    same('what a document was told is not told of another text', b.problems(), [])
    b.find('automatic').click()
    b.js('desk.set(arguments[0])', text + 'x')
    check('nothing is waited for', b.wait('return desk.state().working === null'))
    check('problems are told after it', b.wait('return desk.diagnostics().some((one) => one.severity === "error")'))
    b.js('desk.set(arguments[0])', text)
    b.is_read()
    b.wait('return !desk.state().older && desk.state().working === null')


def reloading(b):
    """A reload keeps what is not saved, the document that is shown, and where one is in it."""
    saved = read(b.path)
    b.go(0)
    b.keys('// unsaved\n')
    b.is_read()
    b.wait('return !desk.state().older && desk.state().working === null')
    shown, text = b.js('return desk.document()'), b.text_of()
    b.frame('scc.go(1)')
    state = b.frame('return scc.state()')
    b.driver.refresh()
    b.settled()
    same('the text is kept', (b.text_of(), b.js('return desk.state().unsaved')), (text, True))
    check('it is told', b.notice('kept'))
    b.wait('return desk.document() !== null')
    same('the same document', b.js('return desk.document()'), shown)
    same('at the same place', b.frame('return scc.state()'), state)
    same('its verdicts', len(b.js('return desk.verdicts()')), 1)
    b.find('go-back').click()
    same('the file is brought back', (b.text_of(), b.js('return desk.state().unsaved')), (saved, False))
    b.served.post(f'view/{shown}/close', {})
    b.driver.refresh()
    b.settled()
    check('a document that is over is made anew', b.js('return desk.document()') not in (None, shown))
    same('without a notice', b.js('return document.getElementById("notices").children.length'), 0)
    b.driver.get_log('browser')  # of the answer 410


def tabs(b):
    """Each tab works on its own."""
    first = b.driver.current_window_handle
    text, shown = b.text_of(), b.js('return desk.document()')
    b.driver.switch_to.new_window('tab')
    b.load(b.url)
    b.js('desk.set(desk.text() + "// of the second tab\\n")')
    check('a document of its own', b.js('return desk.document()') != shown)
    b.js('window.onbeforeunload = null')
    b.driver.switch_to.window(first)
    same('the first tab is as it was', (b.text_of(), b.js('return desk.document()')), (text, shown))
    for handle in b.driver.window_handles:
        if handle != first:
            b.driver.switch_to.window(handle)
            b.driver.close()
    b.driver.switch_to.window(first)


def by_keys(b):
    """Everything without a mouse."""
    b.js('document.activeElement.blur(); document.body.focus()')
    b.js('desk.go(0)')
    b.keys(Keys.TAB)
    check('the tabulator indents', b.text_of().startswith('  '))
    b.keys(Keys.BACKSPACE, Keys.BACKSPACE)
    b.keys(Keys.ESCAPE, Keys.TAB)
    names, unseen = [], []
    for _ in range(40):
        at, visible = b.js('''
          const at = document.activeElement, style = getComputedStyle(at);
          return [at.dataset.testid || at.id || at.tagName,
                  style.outlineStyle !== "none" && style.outlineWidth !== "0px"]''')
        if at in names or at in ('frame', 'BODY'):
            break
        names.append(at)
        unseen += [] if visible else [at]
        b.keys(Keys.TAB)
    same('Escape and the tabulator lead on', names[:2], ['below-splitter', 'verdicts'])
    same('and to the view', (names[-1], at), ('splitter', 'frame'))
    same('one sees where it is', unseen, [])
    b.keys(Keys.F6)
    same('a key leads back to the text', b.js('return document.activeElement.dataset.testid'), 'text')
    b.js('document.body.tabIndex = -1; document.body.focus()')
    names = []
    for _ in range(14):
        b.keys(Keys.TAB)
        names.append(b.js('return document.activeElement.dataset.testid || document.activeElement.className'))
    wanted = ['save', 'format', 'show', 'automatic', 'check', 'which', 'theme', 'help', 'text']
    same('the tabulator leads to all', [name for name in wanted if name not in names], [])
    for line, key, grows in [('splitter', Keys.ARROW_RIGHT, 2), ('below-splitter', Keys.ARROW_UP, -2)]:
        b.js(f'document.querySelector("[data-testid={line}]").focus()')
        value = f'return Number(document.querySelector("[data-testid={line}]").getAttribute("aria-valuenow"))'
        before = b.js(value)
        b.keys(key)
        same(f'arrows move {line}', b.js(value) - before, grows)
    b.keys(Keys.F1)
    check('the help', b.js('return document.getElementById("keys").open'))
    b.keys(Keys.ESCAPE)
    theme = b.js('return document.documentElement.dataset.theme')
    b.find('theme').click()
    inner = 'return document.querySelector("iframe").contentDocument.documentElement.dataset.theme'
    check('dark and light', b.js('return document.documentElement.dataset.theme') != theme)
    check('for the view as well', b.wait(f'return (() => {{ {inner} }})() !== "{theme}"'))
    b.find('theme').click()
    b.find('theme').click()


def sizes(b):
    """Why, choices and events are seen without scrolling. Narrow pages show one side at a time."""
    panels = """
      const { contentDocument: inner, clientHeight: high, clientWidth: wide } = document.querySelector("iframe");
      return ["stage", "tabs-panel", "choices-panel", "events"].map((id) => inner.getElementById(id).getBoundingClientRect())
        .map(({ left, right, top, bottom }) => [left >= 0 && right <= wide, Math.min(bottom, high) - Math.max(0, top)]);"""
    seen = b.js(panels)
    check('in view at once: the scene, why, choices, events', all(within and high >= least for (within, high), least in
                                                                  zip(seen, [240, 150, 40, 150])), seen)
    b.size(420, 800)
    for side, seen, hidden in [('text', 'text-side', 'view-side'), ('view', 'view-side', 'text-side')]:
        b.find(f'to-{side}').click()
        style = 'return getComputedStyle(document.getElementById(arguments[0])).visibility'
        same(f'narrow: {side}', (b.js(style, seen), b.js(style, hidden)), ('visible', 'hidden'))
        check('nothing is beyond the border', b.js('return document.scrollingElement.scrollWidth <= 420'))
    b.find('to-text').click()
    b.size(1400, 900)


def offline(b):
    """While the server does not answer, the text is kept, and it is tried again."""
    b.command('Network.enable')
    network = {'latency': 0, 'downloadThroughput': -1, 'uploadThroughput': -1}
    b.command('Network.emulateNetworkConditions', offline=True, **network)
    b.go(0)
    b.keys('x')
    check('it is told', b.notice('away'))
    b.chord([Keys.CONTROL], 's')
    check('it cannot be saved, and says so', b.notice('save'))
    b.keys('y')
    b.command('Network.emulateNetworkConditions', offline=False, **network)
    check('it goes on when the server is back', b.no_notice('away'))
    check('with the newest text', b.wait('''
      return desk.state().read && desk.diagnostics().length > 0 && desk.text().startsWith("xy")'''))
    b.keys(Keys.BACKSPACE, Keys.BACKSPACE)
    check('and its view', b.wait('return desk.diagnostics().length === 0 && desk.state().working === null'))
    b.driver.get_log('browser')


HOSTILE = '</script><script>window.pwned = 1</script><img src=x onerror="window.pwned = 1">'


def hostile(b, scc, folder):
    """Texts stay texts."""
    text = read(DOCKING)
    b.begin(scc, folder, '<img src=x onerror=alert(1)>.sc', f'// {HOSTILE}\n{text}')
    count = 'return document.querySelectorAll("script, img, link, object, embed").length'
    before = b.js(count)
    b.js('desk.set(desk.text() + arguments[0])', f'\nimport "{HOSTILE.replace(chr(34), "")}"\n')
    b.is_read()
    check('a message with markup', b.wait('return document.querySelector(".problem-row").textContent.includes("<script>")'),
          b.problems())
    b.keys(Keys.F8)
    b.chord([Keys.ALT], 'h')
    b.wait('return !document.getElementById("tip").hidden')
    same('no element of it', b.js(count), before)
    check('and no script', b.js('return window.pwned === undefined'))
    b.js('desk.set("\\u202e\\u2066 " + arguments[0] + " \\u0001\\ud800")', 'n' * 20000)
    b.is_read()
    check('a text that is none', b.wait('return desk.diagnostics().length > 0 && desk.diagnostics()[0].code === "SC0102"'), b.problems())
    check('signs of direction are seen', len(b.all('.cm-invalidchar')) >= 2)
    check('long lines stay within the editor', b.js('return document.scrollingElement.scrollWidth <= 1400'))
    b.end()


def line_ends(b, scc, folder):
    """A file keeps its line ends and its mark; places are right with them."""
    text = ('\ufeff' + COLD + read(DOCKING)).replace('\n', '\r\n')
    b.begin(scc, folder, 'windows.sc', text)
    same('the text', b.text_of(), text)
    b.js('desk.set(desk.text().replace("[Port]", "[Porto]"))')
    b.wait('return desk.diagnostics().length > 0')
    same('places', [d['text'] for d in b.problems()], ['Porto'] * len(b.problems()))
    b.go(0)
    b.keys('// one\n// two')
    b.chord([Keys.CONTROL], 's')
    b.wait('return !desk.state().unsaved')
    same('what is saved', read(b.path), ('\ufeff// one\n// two' + text[1:].replace('\r\n', '\n').replace('[Port]', '[Porto]'))
         .replace('\n', '\r\n'))
    b.end()


def stopping(b, scc, folder):
    """A check that does not end tells how far it is, and ends with what it has; large texts do not freeze the page."""
    b.begin(scc, folder, 'endless.sc', ENDLESS)
    b.find('check').click()
    check('progress', b.wait('return /states/.test(document.getElementById("progress").textContent)'))
    b.driver.refresh()
    b.settled(shown=False)
    check('it goes on over a reload', b.wait('return desk.state().working === "check"'))
    b.go(0)
    b.keys('//')
    check('one can go on writing', b.is_read())
    b.keys(Keys.BACKSPACE, Keys.BACKSPACE)
    b.is_read()
    b.chord([Keys.ALT], '.')
    check('it ends', b.wait('return desk.verdicts().length === 1'))
    check('that it was stopped is said', 'stopped' in b.text('verdicts-count'), b.text('verdicts-count'))
    b.wait('return desk.state().working === null')
    b.js('desk.set(arguments[0] + desk.text())', '// ' + 'x' * 70 + '\n' + ('// ' + 'y' * 70 + '\n') * 14000)
    b.go(0)
    b.keys(*'// many words, quickly')
    check('and is read', b.wait('return desk.state().read'))
    b.js('desk.set("// " + "z".repeat(9000000))')
    check('one of 9 MB is not read, and that is said', b.notice('unread'))
    same('nor is it told to be right', b.no_problems(), 'The text has not been read.')
    b.driver.get_log('browser')  # the browser tells of the answer 413
    b.js('desk.set(arguments[0])', ENDLESS)
    b.is_read()
    same('now it is', b.no_problems(), 'No problems.')
    b.end()


def killed(b, scc, folder):
    """The server ends for ever: the text stays."""
    b.begin(scc, folder, 'killed.sc')
    b.served.process.kill()
    b.served.process.wait()
    b.go(0)
    b.keys('// mine\n')
    check('that the server has gone is told', b.notice('away'))
    check('the text is kept', b.text_of().startswith('// mine'))
    b.js('window.onbeforeunload = null')
    b.driver.get_log('browser')


def plain(b, scc, folder):
    """Where the library of the editor is not there, a plain field is."""
    script = 'Object.defineProperty(window, "CodeMirror", { get: () => undefined, set: () => {} })'
    name = b.command('Page.addScriptToEvaluateOnNewDocument', source=script)['identifier']
    b.begin(scc, folder, 'plain.sc')
    same('a plain field', b.js('return document.activeElement.tagName'), 'TEXTAREA')
    b.js('desk.go(0)')
    b.keys('proces ')
    check('it tells mistakes', b.wait('return desk.diagnostics().length > 0'))
    b.js('document.querySelector("[data-testid=problems]").focus()')
    b.keys(Keys.ARROW_DOWN, Keys.ENTER)
    same('and leads to them', b.js('return [document.activeElement.tagName, document.activeElement.selectionStart]'), ['TEXTAREA', 0])
    b.js('desk.set(desk.text().slice(7))')
    check('what is mended is not unsaved', b.wait('return !desk.state().unsaved && desk.diagnostics().length === 0'))
    b.command('Page.removeScriptToEvaluateOnNewDocument', identifier=name)
    b.driver.get('about:blank')
    b.driver.get_log('browser')  # of the parts of the library
    same('the end of the service', b.served.end(), 0)


def looking(b, scc, folder):
    """The view of a new text is seen from where one looked at the one before, and has the same panels open."""
    b.begin(scc, folder, 'looking.sc')
    edited = lambda script: (b.js(script), b.is_read(), b.wait('return !desk.state().older && desk.state().working === null'))
    edited('desk.set(desk.text().replace("(-4,-1,0)", "(996,499,0)").replace("(4,1/2,0)", "(1004,1001/2,0)"))')
    same('bodies that were moved far away are seen', b.frame('return [scc.inView(), scc.moved()]'), [True, False])
    edited('desk.set(desk.text().replace("(996,499,0)", "(-4,-1,0)").replace("(1004,1001/2,0)", "(4,1/2,0)"))')
    camera = 'return decodeURIComponent(scc.link().split("camera=")[1].split("&")[0])'
    whole = b.frame(camera)
    inside = 'document.querySelector("iframe.frame:not(.coming)").contentDocument'
    for one in ['names', 'plots-switch']:
        b.js(f'{inside}.querySelector("[data-testid={one}]").click()')
    b.driver.switch_to.frame(b.find('frame'))
    ActionChains(b.driver).move_to_element(b.find('scene')).scroll_by_amount(0, 300).click_and_hold() \
        .move_by_offset(60, 20).release().perform()
    b.driver.switch_to.default_content()
    there = b.frame(camera)
    check('one looks from elsewhere', there != whole)
    b.js('desk.set(desk.text().replace("[Ready]", "[nil]"))')
    b.is_read()
    b.wait('return !desk.state().older && desk.state().working === null')
    same('the same camera', b.frame(camera), there)
    edited('desk.set(desk.text().replace("(-4,-1,0)", "(996,499,0)").replace("(4,1/2,0)", "(1004,1001/2,0)"))')
    sees = 'return document.querySelector("iframe.frame:not(.coming)").contentWindow.scc.inView()'
    check('bodies that leave the picture are sought', b.wait(sees))
    edited('desk.set(desk.text().replace("(996,499,0)", "(-4,-1,0)").replace("(1004,1001/2,0)", "(4,1/2,0)"))')
    check('and back', b.wait(sees))
    pressed = f'return {inside}.querySelector(`[data-testid=${{arguments[0]}}]`).getAttribute("aria-pressed")'
    same('the same switches', [b.js(pressed, one) for one in ['names', 'plots-switch', 'grid']], ['true', 'false', 'true'])
    b.js('desk.set(desk.text().replace(/\\btug\\b/g, "boat").replace(/\\bship\\b/g, "quay").replace("(-4,", "(-400,"))')
    b.is_read()
    b.wait('return !desk.state().older && desk.state().working === null')
    check('another model is seen whole', b.wait("""
      const scc = document.querySelector("iframe.frame:not(.coming)").contentWindow.scc;
      return JSON.parse(decodeURIComponent(scc.link().split("camera=")[1].split("&")[0])).distance > 100"""), b.frame(camera))
    b.end()


def ended(b):
    """A document that ends while one looks at it."""
    children = subprocess.run(['pgrep', '-P', str(b.served.process.pid)], capture_output=True, text=True).stdout.split()
    for child in children:
        os.kill(int(child), signal.SIGKILL)
    b.js('document.querySelector("iframe").contentDocument.querySelector("[data-testid=go-on]").click()')
    check('it is told', b.notice('document'))
    before = b.js('return desk.document()')
    b.find('again').click()
    check('and can be shown again', b.wait(f'return desk.document() !== "{before}"'))
    b.driver.get_log('browser')


def without_file(b, scc):
    """Without a model there is one to begin with, and no file."""
    b.served = Served(scc)
    b.load(f'http://127.0.0.1:{b.served.port}{b.served.root}')
    same('a text is downloaded, as there is no file', b.find('save').text, 'Download')
    same('the model has no problems', b.problems(), [])
    b.end()


def words(b):
    """The words that are coloured are those of the reference."""
    with open('specs/language.md', encoding='utf-8') as file:
        listed = re.search(r'```words\n(.*?)```', file.read(), re.S)[1].split()
    same('words of the language', b.js('return Language.words'), listed)


def main(scc, folder):
    why = browser.missing()
    if why:
        print(why)
        return 3
    folder = os.path.join(folder, 'desk')
    os.makedirs(folder, exist_ok=True)
    b = Desk(flags=browser.WITHOUT_SCENES)
    try:
        b.begin(scc, folder, 'docking.sc')
        for part in [words, typing, naming, offering, mending, late]:
            timed(part, b)
        timed(formatting, b, scc)
        for part in [saving, checking, overtaking, whole, reloading, tabs, by_keys, sizes, offline, ended]:
            timed(part, b)
        b.end()
        timed(without_file, b, scc)
        for part in [hostile, line_ends, stopping, plain, killed]:
            timed(part, b, scc, folder)
    finally:
        b.quit()
    b = Desk(950, 500)
    try:
        timed(looking, b, scc, folder)
    finally:
        b.quit()
    print(f'{serve_test.passed} passed, {serve_test.failed} failed')
    return 1 if serve_test.failed else 0


def timed(part, *arguments):
    begun = time.monotonic()
    part(*arguments)
    if os.environ.get('SCC_TIMES'):
        print(f'{part.__name__}: {time.monotonic() - begun:.1f} s')


if __name__ == '__main__':
    sys.exit(main(os.path.abspath(sys.argv[1]), sys.argv[2]))
