#!/usr/bin/env python3
"""The page of scc shape --view in a browser: solid_test.py SCC WORK. The last line is 'N passed, N failed'.

Ends with 3 if there is no browser.
"""
import os
import subprocess
import sys
from fractions import Fraction

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import browser  # noqa: E402
from browser_test import TALLY, check, same  # noqa: E402

# A prism over an L, which is not convex.
ELL = '''OFF
12 8 0
0 0 0
2 0 0
2 1 0
1 1 0
1 2 0
0 2 0
0 0 1
2 0 1
2 1 1
1 1 1
1 2 1
0 2 1
6 5 4 3 2 1 0
6 6 7 8 9 10 11
4 0 1 7 6
4 1 2 8 7
4 2 3 9 8
4 3 4 10 9
4 4 5 11 10
4 5 0 6 11
'''
TENT = '''shape Tent = hull { a (0, 0, 0)  b (1, 0, 0)  c (0, 1, 0)  d (0, 0, 1) }
'''

# A solid smaller than any float of a graphics card, so far away that a double cannot tell it from a point.
FAR = """OFF
4 4 0
1e40 0 0
1e40 1e-45 0
10000000000000000000000000000000000000000.000000000000000000000000000000000000000000001 0 0
1e40 0 1e-45
3 0 1 2
3 0 3 1
3 1 3 2
3 0 2 3
"""


def page(scc, work, name, argument, text):
    path = os.path.join(work, name)
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)
    html = os.path.join(work, name + '.html')
    done = subprocess.run([scc, 'shape', path + argument, '--view', html], capture_output=True, text=True)
    return done, html


def main(scc, work):
    if browser.missing():
        print(browser.missing())
        return 3
    os.makedirs(work, exist_ok=True)
    b = browser.Browser()
    try:
        done, html = page(scc, work, 'ell.off', '', ELL)
        same('a refused solid', done.returncode, 3)
        b.open(html)
        same('it is told', b.text('verdict'), 'refused')
        report = b.js('return scc.data.report')
        same('the report is that of the program, which has advice besides', done.stdout[:len(report)], report)
        check('what to do is told after it', done.stdout[len(report):].startswith('for convex parts'), done.stdout[len(report):])
        wrong = b.js('return scc.data.wrong')
        same('a row for all that is wrong', len(b.all('[data-testid="faults"] button')), len(wrong))
        check('faults and conditions', {w['badge'] for w in wrong} >= {'1', '2', 'c4', 'c6'}, wrong)
        b.all('[data-testid="faults"] button')[0].click()
        same('choosing one', b.js('return scc.chosen()'), {'wrong': 0})
        check('it is told where', '(1, 1, ' in b.text('here'), b.text('here'))

        done, html = page(scc, work, 'tent.sc', ':Tent', TENT)
        same('an accepted solid', done.returncode, 0)
        b.open(html)
        same('it is told, too', b.text('verdict'), 'accepted')
        check('nothing is wrong', not b.find('faults').is_displayed())
        data = b.js('return scc.data')
        corners = {v['name']: [Fraction(x) for x in v['at']] for v in data['vertices']}
        same('its vertices', corners['d'], [0, 0, 1])
        b.wait('return scc.spots() && scc.spots().vertices.length === 4')
        spots = b.js('return scc.spots()')
        nearest = min(range(4), key=lambda v: spots['vertices'][v]['depth'])
        spot = spots['vertices'][nearest]
        same('pointing at the nearest vertex', b.js('return scc.pick(arguments[0], arguments[1])', spot['x'], spot['y']),
             {'vertex': nearest})
        seen = {(found or {}).get('face') for found in
                (b.js('return scc.pick(arguments[0], arguments[1])', f['x'], f['y']) for f in spots['faces'])}
        check('pointing at faces', len(seen - {None}) >= 1, seen)
        rows = b.all('[data-testid="all"] button')
        same('a row for each face and vertex', len(rows), 8)
        rows[0].click()
        check('a face is told with its corners', b.text('here').count('(') == 3, b.text('here'))
        same('it is marked', rows[0].get_attribute('aria-pressed'), 'true')
        done, html = page(scc, work, 'far.off', '', FAR)
        same('a small solid far away', done.returncode, 0)
        b.open(html)
        b.wait('return scc.spots() && scc.spots().vertices.length === 4')
        spots = b.js('return scc.spots()')
        found = [b.js('return scc.pick(arguments[0], arguments[1])', f['x'], f['y']) for f in spots['faces']]
        check('it is there to be pointed at', any((f or {}).get('face') is not None for f in found), found)
        width = max(v['x'] for v in spots['vertices']) - min(v['x'] for v in spots['vertices'])
        check('as large as any other', width > 200, width)
        b.size(400, 700)
        b.open(html)
        panels = b.js("""return [...document.querySelectorAll(".panel")].filter((panel) => !panel.hidden).map((panel) =>
          [panel.querySelector(".tab").clientHeight, panel.getBoundingClientRect().right])""")
        check('in a narrow window each panel has room', all(high >= 24 and right <= 400 for high, right in panels), panels)
        check('and one scrolls to them', b.js('return document.scrollingElement.scrollHeight') > 900)
        same('words on the console', b.complaints(), [])
    finally:
        b.quit()
    done, _ = page(scc, work, 'none', '', 'OFF\n')
    check('what cannot be read has no page', done.returncode == 3)
    done = subprocess.run([scc, 'shape', os.path.join(work, 'ell.off'), '--view', '/nowhere/x.html'], capture_output=True)
    same('a page that cannot be written', done.returncode, 74)
    print(f'{TALLY["passed"]} passed, {TALLY["failed"]} failed')
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2]))
