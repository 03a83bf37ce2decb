"""Cases by hand for rule Zones: for which values of what is not known, and over all instants of splits, properties hold."""

from fractions import Fraction as F
import re

from cases import num, result, unordered
from make_rules import CUBE, Rule

SOMETHING = {'not': []}


def constraint(text):
    """'2s - t <= -2': whole coefficients without a common factor, as in answers."""
    form, relation, bound = re.match(r'(.*?) (<=|<|=) (\S+)$', text).groups()
    terms = re.findall(r'([+-]?)(\d*)([a-z])', form.replace(' ', ''))
    return {'coefficients': {v: num(int(sign + (n or '1'))) for sign, n, v in terms}, 'relation': relation,
            'bound': num(F(bound))}


def pieces(*texts):
    """Each a list of constraints: '-y < 2, y < 2'."""
    return unordered([unordered([constraint(c) for c in t.split(', ')]) for t in texts])


def part(measure, probability, *texts):
    """A set with this volume, of these pieces; or, if none are told, of some."""
    return {'pieces': pieces(*texts) if texts else SOMETHING, 'measure': num(measure), 'probability': num(probability)}


NOWHERE = {'pieces': [], 'measure': num(0), 'probability': num(0)}


def everywhere(measure):
    return {'measure': num(measure), 'probability': num(1), 'fails': {'pieces': []}}


class Zones(Rule):
    def __init__(self):
        super().__init__('Zones')

    def told(self, note, model, *checks, cube=True, **members):
        """Checks are (formula, verdict) or (formula, verdict, where it holds)."""
        sets = any(len(c) > 2 for c in checks)
        text = (CUBE if cube else '') + model
        text += ''.join('check c%d : %s\n' % (i, c[0]) for i, c in enumerate(checks, 1))
        expected = [{'name': 'c%d' % i, 'verdict': c[1], **({'where': c[2]} if sets else {})}
                    for i, c in enumerate(checks, 1)]
        params = {'text': text, **({'where': True} if sets else {}), **members}
        self.add_next(note, 'model.check', params, result(properties=expected))

    def fault(self, note, method, model, code):
        self.add_next(note, method, {'text': CUBE + model}, {'error': {'code': -32003, 'data': {
            'diagnostics': {'some': [{'code': code, 'severity': 'error'}]}}}})


def meeting(p='nil', q='nil', y='y', z='0', far='12', mass=1):
    """p flies at q, from the height y and z."""
    return ('process p = Cube mass 1 velocity (1,0,0) at translate (0,%s,%s) [%s]\n'
            'process q = Cube mass %s at translate (%s,0,0) [%s]\n' % (y, z, p, mass, far, q))


def plane(n):
    return 'param y in [-%d, %d]\nparam z in [-%d, %d]\n' % (n, n, n, n)


def docking(p, q):
    return plane(5) + meeting('<a, {%s}>. nil' % p, '<~a, {%s}>. nil' % q, z='z')


def gap(low, high, brackets='[]', p='nil', q='nil'):
    """p reaches q at the time g."""
    return 'param g in %s%s, %s%s\n' % (brackets[0], low, high, brackets[1]) + meeting(p, q, y='0', far='2 + g')


SQUARE = '-y < 2, y < 2, -z < 2, z < 2'
SHUT = '-y <= 2, y <= 2, -z <= 2, z <= 2'
BIND, HIT = 'possibly bound(p, q)', 'possibly event bounce(p, q)'


def offsets(r):
    r.told('Squares of side 2 overlap iff |y| < 2 and |z| < 2: 16 of 100. At 2 they graze, and touch.',
           docking('right', 'left'), ('possibly touching(p, q)', 'violated', part(16, F(4, 25), SHUT)),
           (BIND, 'violated', part(16, F(4, 25), SQUARE)), (HIT, 'violated', NOWHERE))
    r.told('The edge is at the height z - 1, the face reaches from -1 to 1 with its border: bound iff z >= 0.',
           docking('only [b,c]', 'left'), (BIND, 'violated', part(8, F(2, 25), '-y < 2, y < 2, -z <= 0, z < 2')),
           (HIT, 'violated', part(8, F(2, 25), '-y < 2, y < 2, -z < 2, z < 0')))
    r.told('The vertex c is at (y + 1, z - 1), and on the closed face iff y <= 0 and z >= 0.', docking('only c', 'left'),
           (BIND, 'violated', part(4, F(1, 25), '-y < 2, y <= 0, -z <= 0, z < 2')))
    r.told('And on the face without its border iff y < 0 and z > 0.', docking('only c', 'only left'),
           (BIND, 'violated', part(4, F(1, 25), '-y < 2, y < 0, -z < 0, z < 2')))
    r.told('Two edges along y at the heights z - 1 and -1 are one line iff z = 0: not empty, of probability 0.',
           docking('only [b,c]', 'only [a,d]'), (BIND, 'violated', part(0, 0, '-y < 2, y < 2, z = 0')))
    r.told('Two vertices meet iff z = 0 and y = 0.', docking('only c', 'only d'),
           (BIND, 'violated', part(0, 0, 'y = 0, z = 0')))
    r.told('|y|, |z| < 2 and |y| + |z| < 3: 14 of 36. The tip hits the face iff |y|, |z| <= 1: equal masses, it stops. '
           'Above z = 1 it is an edge or a corner of the top: 3 of 36.',
           OCTAHEDRON + plane(3) + 'process p = Octahedron mass 1 velocity (1,0,0) at translate (0,y,z) [nil]\n'
           'process q = Cube mass 1 at translate (6,0,0) [nil]\n',
           (HIT, 'violated', part(14, F(7, 18), SQUARE + ', y + z < 3, y - z < 3, -y + z < 3, -y - z < 3')),
           ('possibly (vx(p) = 0 and vy(p) = 0 and vz(p) = 0)', 'violated',
            part(4, F(1, 9), '-y <= 1, y <= 1, -z <= 1, z <= 1')),
           ('possibly vz(p) > 0', 'violated', part(3, F(1, 12), '-z < -1, z < 2, y + z < 3, -y + z < 3')))
    r.told('The faces are entered at 4 - x, 4 - y and 4 - z: the least coordinate is the last, and gives the normal.',
           'param x in [-1, 1]\nparam y in [-1, 1]\nparam z in [-1, 1]\n'
           'process p = Cube mass 1 velocity (1,1,1) at translate (x,y,z) [nil]\n'
           'process q = Cube mass 1 at translate (6,6,6) [nil]\n',
           ('possibly (vx(q) = 1 and vy(q) = 0 and vz(q) = 0)', 'violated',
            part(F(8, 3), F(1, 3), 'x - y < 0, x - z < 0, -x <= 1, y <= 1, z <= 1')),
           ('possibly (vx(q) > 0 and vy(q) > 0 and vz(q) > 0)', 'violated', part(0, 0)), (HIT, 'holds', everywhere(8)))
    r.told('|x/2 + 1| < 2 iff -6 < x < 2: 8 of 16.', 'param y in [-8, 8]\n' + meeting(y='y/2 + 1'),
           (HIT, 'violated', part(8, F(1, 2), '-y < 6, y < 2')))
    r.told('Two parameters in one coordinate: s + t < 2, half of a square.',
           'param s in [0, 2]\nparam t in [0, 2]\n' + meeting(y='s + t'),
           (HIT, 'violated', part(2, F(1, 2), '-s <= 0, -t <= 0, s + t < 2')))
    r.told('Three: s + t + u < 1, a corner of a cube.',
           'param s in [0, 1]\nparam t in [0, 1]\nparam u in [0, 1]\n' + meeting(y='1 + s + t + u'),
           (HIT, 'violated', part(F(1, 6), F(1, 6), '-s <= 0, -t <= 0, -u <= 0, s + t + u < 1')))
    r.told('Masses 1 and 3: p comes back with 1/2 from wherever it hits, |y| < 2.', 'param y in [0, 4]\n' + meeting(mass=3),
           ('possibly 2 * vx(p) = -1', 'violated', part(2, F(1, 2), '-y <= 0, y < 2')),
           ('always vx(p) = 1', 'violated', part(2, F(1, 2), '-y <= -2, y <= 4')))
    r.told('Between its ends an open range has no graze.', 'param y in (-2, 2)\n' + meeting(), (HIT, 'holds', everywhere(4)))
    r.told('With them it is violated, for two values only: of probability 1.', 'param y in [-2, 2]\n' + meeting(),
           (HIT, 'violated', part(4, 1, '-y < 2, y < 2')))
    r.told('Half open: the end that belongs to it is a hit.', 'param y in [0, 2)\n' + meeting(), (HIT, 'holds', everywhere(2)))
    r.told('A range that is narrowed to where they meet.', 'param y in [-5, 5]\n' + meeting(), (HIT, 'holds'),
           parameters={'y': [-1, '19/10']})
    r.told('And to a value.', 'param y in [-5, 5]\n' + meeting(), (HIT, 'violated'), parameters={'y': 2})


OCTAHEDRON = """shape Octahedron {
  vertices e (1,0,0) w (-1,0,0) n (0,1,0) s (0,-1,0) u (0,0,1) d (0,0,-1)
  faces enu [e,n,u] nwu [n,w,u] wsu [w,s,u] seu [s,e,u] ned [n,e,d] wnd [w,n,d] swd [s,w,d] esd [e,s,d]
}
"""

PLATE = """compound Plate {
  part low : Cube mass 1
  part high : Cube mass 1 at translate (0,2,%s)
  glue low.back ~ high.front
}
"""

SHIFTED = PLATE.replace('(0,2,%s)', '(h,2,0)')

SPREAD = """compound Beam {
  part base : Cube scaled (6,1,1) mass 1
  part one : Cube mass 1 at translate (0,2,0)
  part two : Cube mass 1 at translate (x,2,0)
  glue base.back ~ one.front
  glue base.back ~ two.front
}
"""

NOTCH = """compound Notch {
  part floor : Cube mass 1
  part heel : Cube mass 1 at translate (2,0,0)
  part wall : Cube mass 1 at translate (2,2,0)
  glue floor.right ~ heel.left
  glue heel.back ~ wall.front
}
"""


def bodies(r):
    r.told('The plate reaches from -1 to 3: hit iff -2 < y < 4. p.right and high.left touch iff 0 <= y <= 4.',
           PLATE % 0 + 'param y in [-6, 6]\n'
           'process p = Cube mass 1 velocity (1,0,0) at translate (0,y,0) [<a, {right}>. nil]\n'
           'process q = Plate at translate (8,0,0) [<~a, {high.left}>. nil]\n',
           ('possibly touching(p, q)', 'violated', part(6, F(1, 2), '-y <= 2, y <= 4')),
           (BIND, 'violated', part(4, F(1, 3), '-y <= 0, y < 4')))
    r.told('r is bound to q, and higher by h: p comes at the height 2, over q, and hits r iff h > 0. '
           'Both take part in the bounce.',
           'param h in [-1, 1]\nprocess p = Cube mass 1 velocity (1,0,0) at translate (0,2,2) [nil]\n'
           'process q = Cube mass 1 at translate (8,0,0) [nil]\nprocess r = Cube mass 1 at translate (8,2,h) [nil]\n'
           'bond <k, {q.back, r.front}>\n',
           ('possibly event bounce(p, r)', 'violated', part(1, F(1, 2), '-h < 0, h <= 1')),
           (HIT, 'violated', part(1, F(1, 2), '-h < 0, h <= 1')),
           ('possibly 3 * vx(q) = 2', 'violated', part(1, F(1, 2), '-h < 0, h <= 1')))
    r.told('The upper part is h further than the lower one, and is hit iff 0 < y < 4, at 6 + h; the lower one iff |y| < 2, at 6. '
           'Up to y = 2 the one that is nearer decides: bound on 6 of 24, a bounce on 6. The centre is at 8 + h/2.',
           'param h in [-1, 1]\nparam y in [-6, 6]\n' + SHIFTED + 'process p = Cube mass 1 velocity (1,0,0) at translate '
           '(0,y,0) [<a, {right}>. nil]\nprocess q = Plate at translate (8,0,0) [<~a, {high.left}>. nil]\n',
           (BIND, 'violated', part(6, F(1, 4))), (HIT, 'violated', part(6, F(1, 4))),
           ('possibly touching(p, q)', 'violated', part(12, F(1, 2))),
           ('always x(q) >= 8', 'violated', part(12, F(1, 2), '-h <= 0, h <= 1, -y <= 6, y <= 6')),
           ('possibly (event bounce(p, q) or event bind(a)) within 11/2', 'violated',
            part(2, F(1, 12), '-h <= 1, 2h <= -1, -y < 0, y < 4')))
    r.fault('Beyond 2 the glue holds nothing.', 'model.check', 'param h in [-1, 3]\n' + SHIFTED + 'process q = Plate [nil]\n',
            'SC0401')
    r.fault('Parts of one compound interpenetrate where x < 2.', 'model.check', 'param x in [1, 4]\n' + SPREAD +
            'process q = Beam [nil]\n', 'SC0403')
    r.told('Into a notch: it is at the floor at 6 and at the wall at 6 - x. x > 0: the wall first; x < 0: the floor first; '
           'x = 0: both normals count in one response. In any case it comes back as it came.',
           NOTCH + 'param x in [-1, 1]\nfixed n = Notch\n'
           'process p = Cube mass 1 velocity (1,-1,0) at translate (x - 6,8,0) [nil]\n',
           ('possibly (vx(p) = -1 and vy(p) = -1)', 'violated', part(1, F(1, 2), '-x < 0, x <= 1')),
           ('possibly (vx(p) = 1 and vy(p) = 1)', 'violated', part(1, F(1, 2), '-x <= 1, x < 0')),
           ('eventually (vx(p) = -1 and vy(p) = 1)', 'holds', everywhere(2)))
    r.told('Absorbed iff it hits: |y| < 2 of 4.', 'param y in [-4, 4]\nfixed q = Cube absorb at translate (6,0,0)\n'
           'process p = Cube mass 1 velocity (1,0,0) at translate (0,y,0) [nil]\n',
           ('possibly gone(p)', 'violated', part(4, F(1, 2), '-y < 2, y < 2')))
    r.told('It starts at x, comes to 6 in any case, and is turned back by the wall iff y < 2.',
           'param x in [0, 4]\nparam y in [0, 4]\nfixed q = Cube at translate (8,0,0)\n'
           'process p = Cube mass 1 velocity (1,0,0) at translate (x,y,0) [nil]\n',
           ('possibly x(p) = 6', 'holds', everywhere(16)),
           ('possibly x(p) < 0', 'violated', part(8, F(1, 2), '-x <= 0, x <= 4, -y <= 0, y < 2')),
           ('always x(p) >= x(q) - 8', 'violated', part(8, F(1, 2), '-x <= 0, x <= 4, -y <= -2, y <= 4')))
    r.fault('At y in (-2, 2) they interpenetrate from the start.', 'model.check',
            'param y in [-1, 5]\n' + meeting(far='1') + 'check c1 : %s\n' % HIT, 'SC0403')
    r.fault('There is no state to start from.', 'model.load', 'param y in [-5, 5]\n' + meeting(), 'SC0903')
    r.told('Distances are not affine.', 'param y in [-5, 5]\n' + meeting(),
           ('possibly distance2(p, q) < 1', 'undecided', {'probability': None, 'unknown': {'pieces': SOMETHING}}))


def ready(delay):
    return ('%s <a, {right}>. nil' % delay, '<~a, {left}>. nil')


def times(r):
    r.told('They meet at 4. What expires at that instant has expired.',
           'param d in [0, 8]\n' + meeting(*ready('eps(d).'), y='0', far='6'),
           (BIND, 'violated', part(4, F(1, 2), '-d <= 0, d <= 4')), (HIT, 'violated', part(4, F(1, 2), '-d < -4, d <= 8')))
    r.told('They collide at once: only an eps of length 0 has expired.',
           'param d in [0, 1]\n' + meeting(*ready('eps(d).'), y='0', far='2'), (BIND, 'violated', part(0, 0, 'd = 0')),
           (HIT, 'violated', part(1, 1, '-d < 0, d <= 1')))
    r.told('Of a range without 0 none has.', 'param d in (0, 1]\n' + meeting(*ready('eps(d).'), y='0', far='2'),
           (BIND, 'violated', NOWHERE), (HIT, 'holds', everywhere(1)))
    named = 'behaviour K on Cube = eps(%s). Z\nbehaviour Z on Cube = nil\nprocess p = Cube mass 1 [K]\n'
    r.told('Where an eps has the length 0, the name behind it is the origin at once, as it is later elsewhere.',
           'param d in [0, 1]\n' + named % 'd', ('eventually behaviour(p) = Z', 'holds', everywhere(1)),
           ('possibly behaviour(p) = K', 'violated', part(1, 1, '-d < 0, d <= 1')),
           ('possibly (time = 0 and behaviour(p) = Z)', 'violated', part(0, 0, 'd = 0')))
    r.told('So it is where two parameters coincide.', 'param d in [1, 2]\nparam e in [0, 1]\n' + named % 'd - e',
           ('eventually behaviour(p) = Z', 'holds', everywhere(1)),
           ('always behaviour(p) = Z', 'violated', part(0, 0, 'd = 1, e = 1')))
    r.told('Ready at d + (4 - e), met at 4: iff d <= e.',
           'param d in [0, 4]\nparam e in [0, 4]\n' + meeting(*ready('eps(d). eps(4 - e).'), y='0', far='6'),
           (BIND, 'violated', part(8, F(1, 2), '-d <= 0, e <= 4, d - e <= 0')))
    reaction = ('param d in [0, 3]\nparam e in [0, 3]\nprocess p = Cube mass 1 [eps(d). rho({<b, {right}>}). nil]\n'
                'process q = Cube mass 1 at translate (2,0,0) [eps(e). rho({<b, {left}>}). nil]\n'
                'bond <b, {p.right, q.left}>\n')
    r.told('A strong split when both are ready, at the greater of d and e.', reaction,
           ('possibly (not bound(p, q)) within 2', 'violated', part(4, F(4, 9), '-d <= 0, d <= 2, -e <= 0, e <= 2')),
           ('always bound(p, q) within 2', 'violated', part(5, F(5, 9))),
           ('eventually not bound(p, q)', 'holds', everywhere(9)))
    r.told('They meet at g. What happens at exactly 4 counts.', gap(0, 6),
           ('possibly vx(q) = 1 within 4', 'violated', part(4, F(2, 3), '-g <= 0, g <= 4')),
           ('always vx(q) = 0 within 4', 'violated', part(2, F(1, 3), '-g < -4, g <= 6')),
           ('eventually event bounce(p, q) within 4', 'violated', part(4, F(2, 3), '-g <= 0, g <= 4')))
    r.told('Up to the meeting, at which x(p) = g: x(p) < 3 iff g < 3, as the instant before the event counts.', gap(0, 6),
           ('A[ x(p) < 3 U vx(q) = 1 ]', 'violated', part(3, F(1, 2), '-g <= 0, g < 3')),
           ('A[ x(p) <= 3 U vx(q) = 1 ]', 'violated', part(3, F(1, 2), '-g <= 0, g <= 3')),
           ('E[ vx(p) = 1 U x(p) = 3 ]', 'violated', part(3, F(1, 2), '-g <= -3, g <= 6')))
    r.told('x(p) = 1 comes in any case; q is set moving iff |y| < 2.', 'param y in [0, 4]\n' + meeting(),
           ('x(p) = 1 leads_to vx(q) = 1', 'violated', part(2, F(1, 2), '-y <= 0, y < 2')),
           ('eventually vx(q) = 1', 'violated', part(2, F(1, 2), '-y <= 0, y < 2')),
           ('AG EF vx(q) = 1', 'violated', part(2, F(1, 2), '-y <= 0, y < 2')),
           ('eventually x(p) = 1', 'holds', everywhere(4)))


POCKET = """param s in [0, 6]
param t in [0, 6]
fixed p = Cube [<a, {left, right}>. nil]
process q = Cube mass 1 velocity (1,0,0) at translate (-4 - s,0,0) [<~a, {left, right}>. nil]
process r = Cube mass 1 velocity (-2,0,0) at translate (4 + t,0,0) [<~a, {left, right}>. nil]
"""

LINE = """param s in [1, 3]
param t in [1, 3]
process m = Cube mass 1 [nil]
process l = Cube mass 1 velocity (1,0,0) at translate (-2 - s,0,0) [nil]
process r = Cube mass 1 velocity (-1,0,0) at translate (2 + t,0,0) [nil]
"""


def ties(r):
    r.told('Arrivals at 2 + s and (2 + t) / 2: q may be first iff 2s + 2 <= t, a triangle of 4 of 36; surely iff 2s + 2 < t.',
           POCKET, (BIND, 'violated', part(4, F(1, 9), '-s <= 0, t <= 6, 2s - t <= -2')),
           ('always not bound(p, r)', 'violated', part(4, F(1, 9), '-s <= 0, t <= 6, 2s - t < -2')),
           ('(possibly bound(p, q)) and (possibly bound(p, r))', 'violated', part(0, 0)))
    walls = (ranges(g=(0, 4)) + 'fixed east = Cube at translate (4 + g,0,0)\nfixed north = Cube at translate (0,26,0)\n'
             'process p = Cube mass 1 velocity (1,0,0) [nil]\n'
             'process r = Cube mass 1 velocity (0,1,0) at translate (0,20,0) [nil]\n')
    east = 'event bounce(p, east)'
    r.told('p is at its wall after 2 + g, and r at its own after 4: either may be next at g = 2.', walls,
           ('EX ' + east, 'violated', part(2, F(1, 2), '-g <= 0, g <= 2')),
           ('AX ' + east, 'violated', part(2, F(1, 2), '-g <= 0, g < 2')),
           ('EX EX ' + east, 'violated', part(2, F(1, 2), '-g <= -2, g <= 4')),
           ('E[ x(p) < 1 U x(p) >= 1 and EX %s ]' % east, 'violated', part(2, F(1, 2), '-g <= 0, g <= 2')),
           ('EX EX EX true', 'violated', NOWHERE))
    r.told('Who comes first drives m away, who comes second drives it back to 0; at once, in turn, they undo each other.',
           LINE, ('possibly x(m) > 0', 'violated', part(2, F(1, 2), '-s <= -1, t <= 3, s - t < 0')),
           ('possibly x(m) < 0', 'violated', part(2, F(1, 2), '-t <= -1, s <= 3, -s + t < 0')),
           ('always x(m) = 0', 'violated', part(0, 0)), ('possibly vx(m) = 1', 'holds', everywhere(4)))
    r.told('Together they do not move it: vx(m) = 1 unless s = t.', 'collisions together\n' + LINE,
           ('possibly vx(m) = 1', 'violated', {**part(4, 1), 'fails': {'measure': num(0), 'pieces': SOMETHING}}),
           ('always x(m) = 0', 'violated', part(0, 0)))


def dimer(p, q, step='any', more=''):
    return ('split_step %s\n%sprocess p = Cube mass 1 [%s]\nprocess q = Cube mass 1 at translate (2,0,0) [%s]\n'
            'bond <b, {p.right, q.left}>\n' % (step, more, p, q))


def window(step):
    return dimer('omega(b, {right}). eps(1). <c, {front}>. nil', 'omega(b, {left}). eps(2). <a, {back}>. nil', step) + (
        'process s = Cube mass 1 velocity (0,1,0) at translate (0,-17/4,0) [<~c, {back}>. nil]\n'
        'process r = Cube mass 1 velocity (0,-1,0) at translate (2,11/2,0) [<~a, {front}>. nil]\n')


FREE = ('omega(b, {right}). nil', 'omega(b, {left}). nil')
BOTH = 'possibly (bound(p, s) and bound(q, r))'
ONE = 'possibly (bound(%s) and not bound(%s) and time > 5) within 6'
P_ONLY, Q_ONLY = ONE % ('p, s', 'q, r'), ONE % ('q, r', 'p, s')
STRUCK = ('omega(b, {right}). eps(1/2). <c, {front}>. nil', 'omega(b, {left}). nil')
STRIKER = 'process s = Cube mass 1 velocity (0,1,0) at translate (0,-2 - g,0) [<~c, {back}>. nil]\n'
ALONE = 'possibly (event bounce(p, s) and not bound(p, q)) within 4'


def splits(r):
    r.told('Split at t, p opens at t + 1 and is reached at 9/4, q at t + 2 and 7/2: both iff t <= 5/4, q alone iff '
           '5/4 < t <= 3/2, p alone never.', window('any'), (BOTH, 'holds'), (Q_ONLY, 'holds'), (P_ONLY, 'violated'))
    r.told('No whole number is in (5/4, 3/2].', window('1'), (BOTH, 'holds'), (Q_ONLY, 'violated'), (P_ONLY, 'violated'))
    r.told('Splits come at any instant, and may be put off for ever.', dimer(*FREE),
           ('possibly (event split(b) and time = 1/3)', 'holds'), ('possibly (event split(b) and time = 0)', 'holds'),
           ('eventually not bound(p, q)', 'violated'), ('EG bound(p, q)', 'holds'), ('AG EF not bound(p, q)', 'holds'))
    r.told('What is next may come at any instant.', dimer(*FREE), ('EX (event split(b) and time = 1/3)', 'holds'),
           ('AX time > 1/3', 'violated'), ('AX event split(b)', 'holds'), ('EX EX true', 'violated'))
    r.told('But not on the grid.', dimer(*FREE, step='1'), ('possibly (event split(b) and time = 1/3)', 'violated'))
    r.fault('Other requests look at the instants of a grid.', 'model.load', dimer(*FREE), 'SC0902')
    r.told('s is there at g: p is struck while released, and not open, by a split in (g - 1/2, g]; open by one up to g - 1/2. '
           'At g = 0 the split comes at the instant of the collision, before it.',
           dimer(*STRUCK, more='param g in [0, 4]\n') + STRIKER, (ALONE, 'holds', everywhere(4)),
           ('possibly bound(p, s)', 'violated', part(F(7, 2), F(7, 8), '-2g <= -1, g <= 4')))
    r.told('On the grid of 1 it is struck iff g is in [k, k + 1/2): half of all, in pieces.',
           dimer(*STRUCK, step='1', more='param g in [0, 4]\n') + STRIKER, (ALONE, 'violated', part(2, F(1, 2))))
    late = ('eps(d). omega(b, {right}). nil', 'omega(b, {left}). nil')
    r.told('No split before both are ready, at d.', dimer(*late, more='param d in [0, 4]\n'),
           ('possibly (event split(b) and time < 2)', 'violated', part(2, F(1, 2), '-d <= 0, d < 2')),
           ('possibly (event split(b) and time <= 2)', 'violated', part(2, F(1, 2), '-d <= 0, d <= 2')),
           ('always bound(p, q) within 2', 'violated', part(2, F(1, 2), '-d < -2, d <= 4')))
    fleeting = ('<a, {right}>. omega(a, {right}). nil', '<~a, {left}>. omega(a, {left}). nil')
    r.told('A bond that is made at g is released at g or at any later instant.',
           'split_step any\n' + gap(0, 6, p=fleeting[0], q=fleeting[1]),
           ('possibly (event split(a) and time <= 3)', 'violated', part(3, F(1, 2), '-g <= 0, g <= 3')),
           ('possibly (event split(a) and time < 3)', 'violated', part(3, F(1, 2), '-g <= 0, g < 3')),
           ('possibly (event split(a) and time = 6)', 'holds', everywhere(6)))
    pushed = ('omega(b, {right}) push(1). nil', 'omega(b, {left}). nil')
    r.told('Pushed off with the velocity 1, p is at the wall 2 + g after the split: at 3 the earliest iff g <= 1; ever.',
           dimer(*pushed, more='param g in [0, 2]\nfixed w = Cube at translate (-4 - g,0,0)\n'),
           ('possibly (event bounce(p, w) and time <= 3)', 'violated', part(1, F(1, 2), '-g <= 0, g <= 1')),
           ('possibly (event bounce(p, w) and time = 100)', 'holds', everywhere(2)),
           ('eventually event bounce(p, w)', 'violated', NOWHERE))

# Timed systems: nothing moves, and what happens is that bonds are released. A bond with the static interval [l, u] of a
# time Petri net (P. Merlin, A study of the recoverability of computing systems, 1974) may be released from l on, and is at u.


def in_interval(bond, side, low, high, rest='nil'):
    due = 'rho({<%s, {%s}>}). %s' % (bond, side, rest)
    if low == high:
        return 'eps(%s). %s' % (high, due)
    return 'eps(%s). omega(%s, {%s}). %s + eps(%s). %s' % (low, bond, side, rest, high, due)


def at_any_time(bond, side):
    return 'omega(%s, {%s}). nil + rho({<%s, {%s}>}). nil' % (bond, side, bond, side)


def pair(bond, low, high, before=None):
    """A pair that `bond` holds together. With `before`, a bond and its interval, that one is released first."""
    y = 10 * (ord(bond) - ord('a'))
    then = in_interval(bond, 'right', low, high)
    text = 'process %s2 = Cube mass 1 at translate (2,%s,0) [%s]\nbond <%s, {%s1.right, %s2.left}>\n' % (
        bond, y, at_any_time(bond, 'left'), bond, bond, bond)
    if before:
        first, low, high = before
        then = in_interval(first, 'left', low, high, '(%s)' % then)
        text += 'process %s2 = Cube mass 1 at translate (-2,%s,0) [%s]\nbond <%s, {%s1.left, %s2.right}>\n' % (
            first, y, at_any_time(first, 'right'), first, bond, first)
    return 'process %s1 = Cube mass 1 at translate (0,%s,0) [%s]\n' % (bond, y, then) + text


def released(bond, owner=None):
    return 'not bound(%s1, %s2)' % (owner or bond, bond)


def ranges(**ranges):
    return ''.join('param %s in [%d, %d]\n' % (v, low, high) for v, (low, high) in ranges.items())


def timed(r):
    a_first, b_first = (F_FIRST % (released(x), released(y)) for x, y in ('ab', 'ba'))
    r.told('Two clocks that run out at d and at e (the race of R. Alur, T. Henzinger and M. Vardi, Parametric real-time reasoning, '
           '1993): a may be first iff d <= e, and is iff d < e.',
           ranges(d=(0, 4), e=(0, 3)) + pair('a', 'd', 'd') + pair('b', 'e', 'e'),
           ('possibly ' + a_first, 'violated', part(F(9, 2), F(3, 8), '-d <= 0, e <= 3, d - e <= 0')),
           ('always not ' + b_first, 'violated', part(F(9, 2), F(3, 8), '-d <= 0, e <= 3, d - e < 0')))
    r.told('Transitions of a time Petri net with the intervals [1, d] and [c, 5] (B. Berthomieu and M. Diaz, Modeling and '
           'verification of time dependent systems, 1991): b may be first iff c <= d, a is for sure iff d < c.',
           'split_step any\n' + ranges(c=(0, 5), d=(1, 5)) + pair('a', '1', 'd') + pair('b', 'c', '5'),
           ('possibly ' + b_first, 'violated', part(12, F(3, 5), '-c <= 0, -d <= -1, d <= 5, c - d <= 0')),
           ('always not ' + b_first, 'violated', part(8, F(2, 5), 'c <= 5, -d <= -1, -c + d < 0')),
           ('possibly ' + a_first, 'holds', everywhere(20)))
    r.told('A gate (b) begins to go down r after a train was seen, and takes from 1 to l; the train (a) is there after t at the '
           'earliest (the railroad crossing of R. Alur and D. Dill, A theory of timed automata, 1994): safe iff r + l < t.',
           'split_step any\n' + ranges(l=(1, 3), r=(0, 3), t=(0, 6))
           + pair('b', '1', 'l').replace('[eps(1)', '[eps(r). (eps(1)', 1).replace('. nil]', '. nil)]', 1)
           + pair('a', 't', '20'),
           ('always not ' + a_first, 'violated', part(15, F(5, 12), '-l <= -1, l <= 3, -r <= 0, r <= 3, t <= 6, l + r - t < 0')))
    r.told("L. Lamport's account of Fischer's protocol (A fast mutual exclusion algorithm, 1987): who found the lock free sets it after "
           'u at the latest, and looks again w after that. One may look (a) before the other one has set it (b) iff w <= u.',
           'split_step any\n' + ranges(u=(0, 4), w=(0, 4)) + pair('a', 'w', 'w', before=('s', '0', 'u')) + pair('b', '0', 'u'),
           ('always not ' + a_first, 'violated', part(8, F(1, 2), '-u <= 0, w <= 4, u - w < 0')))
    r.told('Two tasks one after the other, of 1 to 2 and of 2 to c, and a deadline d (the regions of A. Cimatti, L. Palopoli and Y. '
           'Ramadian, Symbolic computation of schedulability regions, 2008): it is kept iff 2 + c <= d.',
           'split_step any\n' + ranges(c=(2, 4), d=(3, 8)) + pair('a', '2', 'c', before=('s', '1', '2')),
           ('always (time > d => %s)' % released('a'), 'violated', part(6, F(3, 5), '-c <= -2, c <= 4, d <= 8, c - d <= -2')),
           ('possibly (%s and time <= d)' % released('a'), 'holds', everywhere(10)),
           ('possibly (%s and time < 3)' % released('a'), 'violated', NOWHERE))
    r.told('A static hazard (J. Brzozowski and C.-J. Seger, Asynchronous circuits, 1995): an input is at an AND gate after d (a), and '
           'what two gates with the delays i and j make of it (b) after i + j; the gate is never on iff d > i + j.',
           ranges(d=(0, 4), i=(0, 2), j=(0, 2)) + pair('a', 'd', 'd') + pair('b', 'j', 'j', before=('s', 'i', 'i')),
           ('always not ' + a_first, 'violated', part(8, F(1, 2), 'd <= 4, -i <= 0, i <= 2, -j <= 0, j <= 2, -d + i + j < 0')))


def sliding(p, q, x='2', y='3 + y', z='z'):
    """q glides down along the right side of p, which is fixed: their sides are level when y is 0."""
    return ('fixed p = Cube [<a, {%s}>. nil]\n'
            'process q = Cube mass 1 velocity (0,-1,0) at translate (%s,%s,%s) [<~a, {%s}>. nil]\n' % (p, x, y, z, q))


def contacts(r):
    """Reading I-33."""
    way = ranges(y=(0, 6), z=(-4, 4))
    r.told('The sides come to touch after 1 + y, if they are not too high or too low, and be it by an edge.',
           'binding contact\n' + way + sliding('right', 'left'),
           (BIND, 'violated', part(24, F(1, 2), '-z <= 2, z <= 2, -y <= 0, y <= 6')),
           ('always (time > 4 => bound(p, q)) within 10', 'violated',
            part(12, F(1, 4), '-y <= 0, y <= 3, -z <= 2, z <= 2')),
           ('possibly (not bound(p, q) and time >= 4) within 4', 'violated', part(36, F(3, 4))),
           (HIT, 'violated', NOWHERE))
    r.told('They never collide.', way + sliding('right', 'left'), (BIND, 'violated', NOWHERE))
    r.told('The edge is at the height -1, and on the closed face iff z - 1 <= -1 <= z + 1.',
           'binding contact\n' + way + sliding('[b,c]', 'left'),
           (BIND, 'violated', part(12, F(1, 4), '-y <= 0, y <= 6, -z <= 2, z <= 0')))
    r.told('The corners come to meet iff z is 2, after 5 + y: then they stay bound.', 'binding contact\n' + way + sliding('f', 'd'),
           (BIND, 'violated', part(0, 0, '-y <= 0, y <= 6, z = 2')),
           ('possibly (bound(p, q) and time >= 7) within 7', 'violated', part(0, 0, '-y <= 0, y <= 2, z = 2')))
    r.told('It passes at the distance g: they touch iff g is 0.',
           'binding contact\n' + ranges(g=(0, 1)) + sliding('right', 'left', x='2 + g', y='4', z='0'),
           (BIND, 'violated', part(0, 0, 'g = 0')))
    r.told('A lid that is at rest binds when it opens.',
           'binding contact\n' + ranges(t=(0, 4)) + 'process p = Cube mass 1 [<a, {top}>. nil]\n'
           'process q = Cube mass 1 at translate (0,0,2) [eps(t). <~a, {bottom}>. nil]\n',
           ('eventually bound(p, q)', 'holds', everywhere(4)),
           ('always (time > 1 => bound(p, q)) within 5', 'violated', part(1, F(1, 4), '-t <= 0, t <= 1')))


F_FIRST = '(%s and not (%s))'


def starts():
    """Walks over ranges of starts."""
    r = Rule('Starts')
    walk = ('timestep 1 steady\nparam s in [0, 3]\nfixed wall = Cube at translate (6,0,0)\n'
            'process w = Cube mass 1 at translate (s,0,0) [nil]\nmotion w = ')

    def told(note, law, within, high, mean, *checks):
        hit = 'eventually event bounce(w, wall) within %s' % within
        text = CUBE + walk + law + '\ncheck p : P = ? [ %s ]\n' % hit
        text += ''.join('check c%d : %s [ %s ]\n' % (i, c[0], hit) for i, c in enumerate(checks, 1))
        values = {'low': num(0), 'high': num(high), 'mean': {'low': num(mean), 'high': num(mean)}}
        expected = [{'name': 'p', 'verdict': 'measured',
                     'starts': [{'over': side, **values} for side in ('least', 'greatest')]}]
        expected += [{'name': 'c%d' % i, 'verdict': c[1]} for i, c in enumerate(checks, 1)]
        r.add_next(note, 'model.check', {'text': text}, result(properties=expected))

    even, uneven = 'choose { (1,0,0), (-1,0,0) }', 'choose { (1,0,0) weight 2, (-1,0,0) }'
    told('From 3 the wall is met after one step to the right, and from nowhere else.', even, 1, F(1, 2), 0,
         ('P <= 1/2', 'holds'), ('P < 1/2', 'violated'), ('P >= 1/2', 'violated'))
    told('From [2, 3) after two: a third of the starts, with 1/4.', even, 2, F(1, 2), F(1, 12), ('P <= 1/4', 'violated'))
    told('With 4/9, and from 3 with 2/3.', uneven, 2, F(2, 3), F(4, 27), ('P <= 2/3', 'holds'), ('P <= 1/2', 'violated'))
    told('A law that depends on the place cuts the range at 2.', '(if x >= 2 then 1 else -1, 0, 0)', 2, 1, F(1, 3),
         ('P >= 1', 'violated'), ('P >= 0', 'holds'))
    return r


def suites():
    r = Zones()
    offsets(r)
    bodies(r)
    times(r)
    ties(r)
    splits(r)
    timed(r)
    contacts(r)
    return [r, starts()]
