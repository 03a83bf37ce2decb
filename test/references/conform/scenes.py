"""Models of specs/models, and one of this folder, written down once more for the float simulator."""

from solids import Solid

CUBE = dict(a=(-1, -1, -1), b=(1, -1, -1), c=(1, 1, -1), d=(-1, 1, -1),
            e=(-1, -1, 1), f=(1, -1, 1), g=(1, 1, 1), h=(-1, 1, 1))
UPRIGHT = dict(bottom=list('adcb'), top=list('efgh'), left=list('aehd'), right=list('bcgf'), front=list('abfe'),
               back=list('dhgc'))
LYING = dict(back=list('adcb'), front=list('efgh'), left=list('aehd'), right=list('bcgf'), bottom=list('abfe'),
             top=list('dhgc'))
OCTAHEDRON = dict(e=(1, 0, 0), w=(-1, 0, 0), n=(0, 1, 0), s=(0, -1, 0), u=(0, 0, 1), d=(0, 0, -1))
OCTANTS = {x + y + z: [x, y, z] if (x == 'e') ^ (y == 's') ^ (z == 'd') else [x, z, y]
           for x in 'ew' for y in 'ns' for z in 'ud'}
NIL = ('nil',)


class Scene:
    def __init__(self, path, bodies, definitions=None, bonds=(), timestep=1.0, split_step=1.0, time=10.0,
                 parameters=()):
        self.path, self.bodies, self.definitions, self.bonds = path, bodies, definitions or {}, list(bonds)
        self.timestep, self.split_step, self.time, self.parameters = timestep, split_step, time, list(parameters)


def body(name, solid, at, velocity=(0, 0, 0), mass=1.0, behaviour=NIL, fixed=False, law=None):
    return dict(name=name, solid=solid, at=tuple(map(float, at)), velocity=tuple(map(float, velocity)),
                mass=float(mass), behaviour=behaviour, fixed=fixed, law=law)


def box(name, size, at):
    return body(name, Solid(CUBE, UPRIGHT, size), at, fixed=True)


def walls(room, thick):
    """Six walls about a room of half that size, numbered as in billiard.sc."""
    found = []
    for i in range(3):
        for side in (-1, 1):
            size = [float(room)] * 3
            size[i] = float(thick)
            at = [0, 0, 0]
            at[i] = side * (room + thick)
            found.append(box('wall[%d]' % (len(found) + 1), tuple(size), at))
    return found


def billiard():
    cube = Solid(CUBE, UPRIGHT)
    return Scene('specs/models/billiard.sc', walls(4, 1) + [
        body('p', cube, (-2.5, -1, 0), (1, 1, 0)), body('q', cube, (2, 0.5, 0), (-1, 1, 0))], time=20.0)


def chain(path='specs/models/chain.sc', n=4):
    cube = Solid(CUBE, UPRIGHT)
    free = ('call', 'Free')
    definitions = {
        'Free': ('sum', ('open', 'link', False, ['right'], ('call', 'Head')),
                 ('open', 'link', True, ['left'], ('call', 'Tail'))),
        'Head': ('open', 'link', True, ['left'], NIL),
        'Tail': ('open', 'link', False, ['right'], NIL),
    }
    bodies = [body('c[%d]' % i, cube, (3 * i, 0, 0), (1 if i == 1 else 0, 0, 0), behaviour=free)
              for i in range(1, n + 1)]
    return Scene(path, bodies, definitions, time=2.0 * n * n, parameters=[('n', n)])


def relay():
    return chain('specs/models/relay.sc', 6)


def dimer():
    cube = Solid(CUBE, UPRIGHT)
    definitions = {
        'Left': ('delay', 2.0, ('weak', 'bond', ['right'], ('call', 'Loose'))),
        'Right': ('delay', 1.0, ('sum', ('weak', 'bond', ['left'], ('call', 'Loose')), ('delay', 0.5, NIL))),
        'Loose': NIL,
        'Fuse': ('delay', 3.0, ('strong', [('bond', ['left', 'right'])], ('call', 'Loose'))),
    }
    bodies = [body('w1', cube, (0, 0, 0), behaviour=('call', 'Left')),
              body('w2', cube, (2, 0, 0), behaviour=('call', 'Right')),
              body('s1', cube, (0, 10, 0), behaviour=('call', 'Fuse')),
              body('s2', cube, (2, 10, 0), mass=2, behaviour=('call', 'Fuse'))]
    bonds = [('bond', (('w1', 'right'), ('w2', 'left'))), ('bond', (('s1', 'right'), ('s2', 'left')))]
    return Scene('specs/models/dimer.sc', bodies, definitions, bonds, timestep=0.25, split_step=0.5, time=6.0)


def latch():
    cube = Solid(CUBE, UPRIGHT)
    definitions = {
        'Open': ('open', 'dock', False, ['right'], ('call', 'Held')),
        'Shut': ('open', 'dock', True, ['left'], ('call', 'Held')),
        'Held': ('weak', 'dock', ['left', 'right'], NIL),
    }
    return Scene('specs/models/latch.sc', [
        body('p', cube, (-3, 0, 0), (1, 0, 0), behaviour=('call', 'Open')),
        body('q', cube, (3, 0, 0), (-1, 0, 0), behaviour=('call', 'Shut'))], definitions)


def gravity():
    def law(v, dt):
        return (v[0], v[1] - 8.0 * dt, v[2])

    return Scene('specs/models/gravity.sc', [
        body('floor', Solid(CUBE, LYING, (10.0, 1.0, 10.0)), (0, -1, 0), fixed=True),
        body('ball', Solid(CUBE, LYING), (0, 4.25, 0), (1, 0, 0), mass=2, law=law)], timestep=0.25, time=5.0)


def enzyme():
    cube = Solid(CUBE, LYING)

    def law(away):
        return lambda v, dt: (0.0, away if v[1] == 0 else v[1], 0.0)

    def bound(name, sites, free, other=None):
        release = ('weak', name, sites, ('call', free))
        if other is None:
            return release
        reaction = ('strong', [(name, sites)], ('call', other[1]))
        return ('sum', release, ('delay', other[0], reaction) if other[0] else reaction)

    definitions = {
        'Free': ('sum', ('sum', ('open', 's', True, ['top'], ('call', 'WithS')),
                         ('open', 'p', True, ['top'], ('call', 'WithP'))),
                 ('open', 'i', True, ['bottom'], ('call', 'WithI'))),
        'WithS': bound('s', ['top'], 'Free', (0, 'Free')),
        'WithP': bound('p', ['top'], 'Free', (0, 'Free')),
        'WithI': bound('i', ['bottom'], 'Free'),
        'Substrate': ('open', 's', False, ['bottom'], ('call', 'BoundS')),
        'BoundS': bound('s', ['bottom'], 'Substrate', (2.0, 'Product')),
        'Product': ('open', 'p', False, ['bottom'], ('call', 'BoundP')),
        'BoundP': bound('p', ['bottom'], 'Product', (2.0, 'Substrate')),
        'Inhibitor': ('open', 'i', False, ['top'], ('call', 'Inhibits')),
        'Inhibits': bound('i', ['top'], 'Inhibitor'),
    }
    return Scene('specs/models/enzyme.sc', [
        body('enzyme', cube, (0, 0, 0), behaviour=('call', 'Free'), fixed=True),
        body('lid', cube, (0, 5, 0), fixed=True),
        body('floor', cube, (0, -6, 0), fixed=True),
        body('molecule', cube, (0, 3, 0), (0, -1, 0), behaviour=('call', 'Substrate'), law=law(1.0)),
        body('inhibitor', cube, (0, -4, 0), (0, 1, 0), behaviour=('call', 'Inhibitor'), law=law(-1.0))],
        definitions, time=25.0)


def crystals():
    stone = Solid(OCTAHEDRON, OCTANTS)
    return Scene('crystals.sc', walls(4, 1) + [
        body('a', stone, (-2, 0.375, 0), (1, 0, 0)),
        body('b', stone, (2, 0, 0), (-1, 0.25, 0.125), mass=2),
        body('c', stone, (0.125, 2, -1.5), (0.25, -0.75, 0.5), mass=3)], time=8.0)


SCENES = dict(billiard=billiard, chain=chain, relay=relay, dimer=dimer, latch=latch, gravity=gravity, enzyme=enzyme,
              crystals=crystals)
