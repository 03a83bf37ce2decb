"""By hand: regions of contact, in the notation of the original calculus."""

from make_rules import BIND, TIME, Rule, binds, bounces
from cases import load

# A slab from -4 to 4 along x and y, with its top at z = 0, and a small body that comes down on it. The notation of a file is
# told by its name: shapes, regions and behaviours are a module of the model.
MODULE = """%s
shape Slab = box(8, 8, 2)
shape Die = %s
%s
behaviour Open on Slab = <dock, %s>. nil
behaviour Shut on Die = <~dock, %s>. nil
"""
MODEL = """import "regions.osc" (Slab, Die, Open, Shut)
process slab = %s velocity (0, 0, 0) at translate (0, 0, -1) [Open]
process die = Die mass 1 velocity (0, 0, -1) at translate (%s, 5/2) [Shut]
"""
PATCH = 'region patch on Slab = polygon((-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))'


class Original(Rule):
    """Models with a module in the original notation."""

    def model(self, body, cube=False):
        text, module = body
        thing = load(text, files={'regions.osc': module})
        for name, known in self.given.items():
            if known == thing:
                return '@' + name
        return self.give('model %d' % (len(self.given) + 1), thing)


def of(region, at='0, 0', declared='', cut=True, die='box(1, 1, 1)', end='bottom', setting=''):
    """A slab that is cut is a compound with its mass as an argument."""
    return (MODEL % ('Slab(8)' if cut else 'Slab mass 8', at), MODULE % (setting, die, declared, region, end))


def regions():
    r = Original('Regions')

    def event(note, docks, region, at, **more):
        formula = 'possibly event bind(dock)' if docks else 'always not event bind(dock)'
        r.verdict(note, of(region, at, **more), formula, 'holds')

    event('A die lands on the patch, and binds.', True, 'patch', '0, 0', declared=PATCH)
    event('It lands beside it, on the same face.', False, 'patch', '3, 0', declared=PATCH)
    event('Its side ends where the patch begins: the region is closed.', True, 'patch', '3/2, 0', declared=PATCH)
    event('A ring: the patch is taken out of the top.', False, 'top - patch', '0, 0', declared=PATCH)
    event('Half of the top.', True, 'top ∩ half((1, 0, 0), 0)', '2, 0')
    event('The other half.', False, 'top ∩ half((1, 0, 0), 0)', '-2, 0')
    event('All but the inside of the top.', False, 'surface() ∖ interior(top)', '0, 0', cut=False)
    event('A union.', True, 'patch ∪ (top * half((1, 0, 0), 2))', '3, 0', declared=PATCH)
    event('Where neither of the two is.', False, 'patch ∪ (top * half((1, 0, 0), 2))', '-3, 0', declared=PATCH)
    r.outcomes('A region that is a feature.', of('top', cut=False), [TIME], [binds('dock', 'slab.top', 'die.bottom')])
    tip = 'polyhedron((0, 0, -1/2), (1, 0, 1/2), (-1, 1, 1/2), (-1, -1, 1/2))'
    r.outcomes('A polyhedron told by its points; one of them is a region.',
               of('top', cut=False, die=tip, end='tip', declared='region tip on Die = point((0, 0, -1/2))'), [TIME],
               [binds('dock', 'slab.top', 'die.tip')])
    ball = {'cut': False, 'die': 'sphere(1)', 'setting': 'curved inscribed 1/5'}
    r.outcomes('The ball is inscribed: its lowest point is at z = -1.', of('top', end='cap((0, 0, -1), 2/3)', **ball), [TIME],
               [binds('dock', 'slab.top', 'die.south')])
    r.outcomes('A cap on the other side.', of('top', end='cap((0, 0, 1), 2/3)', **ball), [TIME],
               [bounces('slab', 'die')])
    text, module = of('top', cut=False, die='sphere(1)', end='south')
    r.add_next('Nothing says as which polyhedron the ball is taken.', 'model.load',
               {'text': text, 'files': {'regions.osc': module}},
               {'error': {'code': -32003, 'data': {'diagnostics': {'some': [{'code': 'SC0365', 'severity': 'error'}]}}}})
    r.value('The parts of a body have its mass: 8 and 1, of which the second has the velocity -1.',
            of('patch', declared=PATCH), [TIME, BIND], 'momentum.z', -1)
    return r


def suites():
    return [regions()]
