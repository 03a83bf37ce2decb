"""What the scene marks, compares and saves."""
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


PARTS = [marks]
