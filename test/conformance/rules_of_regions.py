"""By hand: regions of contact, in the notation of the original calculus."""

from make_rules import BIND, TIME, Rule, binds, bounces
from cases import load

# A slab from -4 to 4 along x and y, with its top at z = 0, and a small cube that comes down on it.
SLAB = """shape Slab = box(8, 8, 2)
shape Die = box(1, 1, 1)
%s
behaviour Open on Slab = <dock, %s>. nil
process slab = <Slab, 8, (0, 0, -1), (0, 0, 0)> [Open]
process die = <Die, 1, (%s, 5/2), (0, 0, -1)> [<~dock, bottom>. nil]
"""
PATCH = 'region patch on Slab = polygon((-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))'


class Original(Rule):
    """Texts whose name says their notation."""

    def model(self, body, cube=False):
        params = load(body)
        params['params']['name'] = 'model.osc'
        for name, thing in self.given.items():
            if thing == params:
                return '@' + name
        return self.give('model %d' % (len(self.given) + 1), params)


def regions():
    r = Original('Regions')

    def event(note, declared, region, at, docks):
        text = SLAB % (declared, region, at)
        formula = 'possibly event bind(dock)' if docks else 'always not event bind(dock)'
        r.verdict(note, text, formula, 'holds')

    event('A die lands on the patch, and binds.', PATCH, 'patch', '0, 0', True)
    event('It lands beside it, on the same face.', PATCH, 'patch', '3, 0', False)
    event('Its side ends where the patch begins: the region is closed.', PATCH, 'patch', '3/2, 0', True)
    event('A ring: the patch is taken out of the top.', PATCH, 'top - patch', '0, 0', False)
    event('Half of the top.', '', 'top ∩ half((1, 0, 0), 0)', '2, 0', True)
    event('The other half.', '', 'top ∩ half((1, 0, 0), 0)', '-2, 0', False)
    event('All but the inside of the top.', '', 'surface() ∖ interior(top)', '0, 0', False)
    event('A union.', PATCH, 'patch ∪ (top * half((1, 0, 0), 2))', '3, 0', True)
    event('Where neither of the two is.', PATCH, 'patch ∪ (top * half((1, 0, 0), 2))', '-3, 0', False)
    uncut = SLAB % ('', 'top', '0, 0')
    r.outcomes('A region that is a feature.', uncut, [TIME], [binds('dock', 'slab.top', 'die.bottom')])
    alike = uncut.replace('box(1, 1, 1)', 'polyhedron((0, 0, -1/2), (1, 0, 1/2), (-1, 1, 1/2), (-1, -1, 1/2))')
    alike = alike.replace('shape Slab', 'region tip on Die = point((0, 0, -1/2))\nshape Slab').replace('bottom', 'tip')
    r.outcomes('A polyhedron told by its points; one of them is a region.', alike, [TIME],
               [binds('dock', 'slab.top', 'die.tip')])
    ball = uncut.replace('box(1, 1, 1)', 'sphere(1)').replace('bottom', 'cap((0, 0, -1), 2/3)')
    r.outcomes('The ball is inscribed: its lowest point is at z = -1.', 'curved inscribed 1/5\n' + ball, [TIME],
               [binds('dock', 'slab.top', 'die.south')])
    r.outcomes('A cap on the other side.', 'curved inscribed 1/5\n' + ball.replace('-1), 2/3', '1), 2/3'), [TIME],
               [bounces('slab', 'die')])
    r.add_next('Nothing says as which polyhedron the ball is taken.', 'model.load', {'text': ball, 'name': 'model.osc'},
               {'error': {'code': -32003, 'data': {'diagnostics': {'some': [{'code': 'SC0365', 'severity': 'error'}]}}}})
    r.value('The parts of a body have its mass: 8 and 1, of which the second has the velocity -1.',
            SLAB % (PATCH, 'patch', '0, 0'), [TIME, BIND], 'momentum.z', -1)
    return r


def suites():
    return [regions()]
