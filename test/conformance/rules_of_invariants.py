"""Cases by hand for rule Invariants: what a set of states proves that no run leaves, where exploring has no end."""

from cases import result
from make_rules import CUBE, Rule

LANES = ('fixed west = Cube at translate (-6,0,0)\nfixed east = Cube at translate (6,0,0)\n'
         'process b = Cube mass 1 velocity (1,0,0) at translate (%s,0,0) [nil]\n'
         'process c = Cube mass 1 velocity (1,0,0) at translate (%s,0,0) [nil]\n')


class Invariants(Rule):
    def __init__(self):
        super().__init__('Invariants')

    def told(self, note, model, *checks, found=True, **members):
        """Checks are (formula, verdict, whether it rests on an invariant)."""
        text = CUBE + model + ''.join('check c%d : %s\n' % (i, c[0]) for i, c in enumerate(checks, 1))
        expected = [{'name': 'c%d' % i, 'verdict': c[1], **({'by_invariant': True} if c[2] else {})}
                    for i, c in enumerate(checks, 1)]
        answer = {'properties': expected, **({'invariants': [{'kinds': {'not': []}}]} if found else {})}
        self.add_next(note, 'model.check', {'text': text, **members}, result(**answer))


def never_again(r):
    r.told('b goes to and fro between -4 and 4; c has left before. The next states have c ever farther off.',
           'param x in [0, 2]\n' + LANES % ('x', '10'),
           ('always not touching(b, c)', 'holds', True), ('always x(b) <= 4', 'holds', True),
           ('always x(b) >= -4', 'holds', True), ('possibly x(b) > 4', 'violated', True),
           ('always x(c) <= 13', 'violated', False), limits={'depth': 10})
    r.told('The same of one start, where it is asked for.', LANES % ('1/3', '10'),
           ('always not touching(b, c)', 'holds', True), ('always x(b) <= 4', 'holds', True),
           ('possibly x(b) > 4', 'violated', True), prove=True)
    r.told('With a bound of time, what never comes does not come in time.', LANES % ('1/3', '10'),
           ('always x(b) <= 4 within 1000', 'holds', True), prove=True)
    r.told('At 4 it is at the wall: a border that is reached, and not proved away.',
           'param x in [0, 2]\n' + LANES % ('x', '10'),
           ('always x(b) < 4', 'violated', False), ('possibly x(b) = 4', 'holds', False), limits={'depth': 10}, found=False)


def where(r):
    r.told('Two that stand apart by a gap g > 0, and one that goes to and fro beside them: c flies off.',
           'param g in (0, 1]\n' + LANES % ('0', '10')
           + 'process d = Cube mass 1 at translate (0,5,0) [nil]\nprocess e = Cube mass 1 at translate (2 + g,5,0) [nil]\n',
           ('always not touching(d, e)', 'holds', True), ('always not touching(b, d)', 'holds', True),
           limits={'depth': 8})
    r.told('A bond that may be released at any time; the pieces stay where they are, and c goes on its way.',
           'split_step any\n' + LANES % ('0', '10')
           + 'process d = Cube mass 1 at translate (0,5,0) [omega(a, {right}). nil]\n'
             'process e = Cube mass 1 at translate (2,5,0) [omega(a, {left}). nil]\n'
             'bond <a, {d.right, e.left}>\n',
           ('always touching(d, e)', 'holds', True), ('always x(e) = 2', 'holds', True),
           ('possibly bonds() = 0', 'holds', False), limits={'depth': 12})


def nothing(r):
    r.told('What surely comes is not proved by a set of states: it is explored, up to the bound.',
           LANES % ('1/3', '10'), ('possibly x(c) > 12', 'holds', False), prove=True, found=False,
           limits={'depth': 20})


def suites():
    r = Invariants()
    never_again(r)
    where(r)
    nothing(r)
    return [r]
