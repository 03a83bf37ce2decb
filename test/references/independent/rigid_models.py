"""Random rigid models: as text in the language, and as the bodies of rigid.py."""

from fractions import Fraction as F
import random

from rigid import Body
from shapes import rotate, vector
import solids as s

SOLIDS = {
    'Cube': (dict(a=(-1, -1, -1), b=(1, -1, -1), c=(1, 1, -1), d=(-1, 1, -1),
                  e=(-1, -1, 1), f=(1, -1, 1), g=(1, 1, 1), h=(-1, 1, 1)),
             dict(bottom='adcb', top='efgh', left='aehd', right='bcgf', front='abfe', back='dhgc')),
    'Wedge': (dict(a=(-1, -1, -1), b=(2, -1, -1), c=(-1, 2, -1), d=(-1, -1, 1), e=(2, -1, 1), f=(-1, 2, 1)),
              dict(bottom='acb', top='def', left='adfc', front='abed', slope='bcfe')),
    'Tip': (dict(a=(0, 0, 0), b=(2, 0, 0), c=(0, 2, 0), d=(0, 0, 2)),
            dict(xy='acb', yz='adc', zx='abd', slope='bcd')),
}
# Boxes that are glued: parts (name, scale, at, mass) and glues.
COMPOUNDS = [
    ([('u', (1, F(1, 2), F(1, 2)), (0, 0, 0), 1), ('v', (F(1, 2), 1, F(1, 2)), (F(3, 2), F(1, 2), 0), 2)],
     ['u.right ~ v.left']),
    ([('u', (F(1, 2), F(3, 2), 1), (0, 0, 0), 2), ('v', (1, F(1, 2), F(1, 2)), (F(3, 2), 1, 0), 1),
      ('w', (1, F(1, 2), F(1, 2)), (F(3, 2), -1, 0), 1)], ['u.right ~ v.left', 'u.right ~ w.left']),
]
TURNS = [None, None, (1, 0, 0, 1), (3, 1, 0, 0), (5, 1, -2, 1), (2, 0, 1, 0)]


def template(name):
    corners, faces = SOLIDS[name]
    return 'shape %s {\n  vertices %s\n  faces %s\n}\n' % (
        name, ' '.join('%s %s' % (n, vector(c)) for n, c in corners.items()),
        ' '.join('%s [%s]' % (n, ','.join(f)) for n, f in faces.items()))


class Model:
    def __init__(self, seed):
        self.rng = rng = random.Random(seed)
        self.timestep = rng.choice([F(1), F(1, 2), F(1, 2), F(1, 3), F(2)])
        self.free = rng.random() < 0.4
        self.resolution = rng.choice([None, None, F(1, 2 ** 10), F(1, 2 ** 30), F(1, 1000)])
        self.orientation = rng.choice([None, 10, 20, 40])
        self.velocity = rng.choice([None, 8, 20, 40]) if self.orientation else None
        # Numbers grow without it: quickly with every bounce, and those of a free body with every step.
        self.steps = 20 if self.velocity else 2 if self.free else 10
        self.plain = rng.random() < 0.3  # everything along axes, where faces and edges meet flush
        self.bodies, self.lines, self.edges = {}, [], []
        self.lively = rng.random() < 0.6
        self.shapes = [self.shape(i) for i in range(rng.choice([1, 2, 2]))]
        self.places = []
        for i in range(rng.choice([2, 2, 2, 3, 3, 4])):
            self.body('p%d' % i, i)
        if rng.random() < 0.3:
            self.pair()
        if rng.random() < 0.5:
            self.wall()

    def solid(self, name, scale, at, mass, turn=None):
        corners, faces = SOLIDS[name]
        placed = {}
        for n, c in corners.items():
            c = s.add(tuple(F(k) * a for k, a in zip(scale, c)), at)
            placed[n] = rotate(turn, c) if turn else c
        solid = s.Solid(placed, faces, mass)
        self.edges += [s.dot(d, d) for d in (s.sub(solid.corners[i], solid.corners[j]) for i, j in solid.edges)]
        return solid

    def shape(self, i):
        """Name, text, and a function from (mass, turn) to parts; channels by role."""
        rng, name = self.rng, 'Body%d' % i
        if rng.random() < 0.3:
            parts, glues = rng.choice(COMPOUNDS)
            lines = ['  part %s : Cube scaled %s mass %s at translate %s\n' % (n, vector(k), m, vector(at))
                     for n, k, at, m in parts] + ['  glue %s\n' % g for g in glues]
            text = 'compound %s {\n%s}\n' % (name, ''.join(lines))
            return name, text, True, lambda mass, turn: {
                n: self.solid('Cube', k, at, F(m), turn) for n, k, at, m in parts}, ['u.right', 'u.left', 'v.right']
        base = rng.choice(['Cube', 'Cube', 'Cube', 'Wedge', 'Tip'])
        scale = tuple(rng.choice([F(1), F(1), F(1, 2), F(1, 4), F(3, 2)]) for _ in range(3))
        text = 'shape %s = %s scaled %s\n' % (name, base, vector(scale))
        return name, text, False, lambda mass, turn: {
            None: self.solid(base, scale, s.ZERO, mass, turn)}, list(SOLIDS[base][1])

    def clear(self, parts, at):
        """No closer than a little to what is there: by balls."""
        for p in parts.values():
            c = s.add(at, p.centroid)
            for d, radius2 in self.places:
                if float(s.dot(s.sub(c, d), s.sub(c, d))) ** 0.5 <= float(p.radius2) ** 0.5 + float(radius2) ** 0.5:
                    return False
        return True

    def settle(self, parts, span):
        while True:
            at = tuple(F(self.rng.randint(-4 * span, 4 * span), 4) for _ in range(3))
            if self.plain:
                at = (F(round(at[0])), F(round(at[1] / 4), 2), F(round(at[2] / 4), 2))
            if self.clear(parts, at):
                self.places += [(s.add(at, p.centroid), p.radius2) for p in parts.values()]
                return at
            span += 1

    def motion(self, at):
        """Aimed at something that is there, or at the origin."""
        rng = self.rng
        target = rng.choice(self.places)[0] if self.places[1:] and rng.random() < 0.8 else s.ZERO
        aim = s.sub(target, at)
        speed = rng.choice([F(1, 4), F(1, 3), F(1, 2)])
        velocity = tuple(F(round(8 * a * speed), 8) for a in aim)
        spin = tuple(F(rng.randint(-6, 6), rng.choice([2, 3, 4, 8])) for _ in range(3))
        if self.plain:
            spin = (F(0), F(0), rng.choice([F(0), F(1, 2), F(-1, 3), F(1)]))
            velocity = (velocity[0] or F(1, 2), F(0), rng.choice([F(0), F(0), F(1, 8)]))
        return (velocity, spin if rng.random() < 0.85 else s.ZERO)

    def behaviour(self, shape, role):
        rng = self.rng
        if not self.lively:
            return 'nil'
        name, bar = 'B%d' % len(self.lines), '~' if role % 2 else ''
        sites = '{%s}' % ', '.join(shape[4])
        end = rng.choice(['nil', 'eps(%s). rho({<k, %s>}). nil' % (F(1, 2), sites),
                          'eps(%s). omega(k, %s). nil' % (F(rng.randint(1, 9), 8), sites)])
        self.lines.append('behaviour %s on %s = <%sk, %s>. %s\n' % (name, shape[0], bar, sites, end))
        return name

    def body(self, name, role):
        rng = self.rng
        shape, turn = rng.choice(self.shapes), None if self.plain else rng.choice(TURNS)
        mass = F(rng.choice([1, 1, 2, 3, 7]), rng.choice([1, 1, 2]))
        parts = shape[3](mass, turn)
        at = self.settle(parts, 3)
        velocity, spin = self.motion(at)
        self.bodies[name] = Body(parts, False)
        b = self.behaviour(shape, role)
        self.lines.append('process %s = %s %s velocity %s spin %s at translate %s%s [%s]\n' % (
            name, shape[0], '' if shape[2] else 'mass (%s)' % mass, vector(velocity), vector(spin), vector(at),
            ' * rotate quaternion %s' % vector(turn) if turn else '', b))

    def pair(self):
        """Two cubes that are bound at the start, and move as one."""
        rng = self.rng
        scale = (F(1), F(1, 2), F(1, 2))
        parts = self.solid('Cube', scale, s.ZERO, F(2))
        around = {'both': self.solid('Cube', (F(2), F(1, 2), F(1, 2)), (F(1), F(0), F(0)), F(2))}
        at = self.settle(around, 5)
        velocity, spin = self.motion(at)
        other = s.add(velocity, s.cross(spin, (F(2), F(0), F(0))))
        self.bodies['l'], self.bodies['r'] = Body({None: parts}, False), Body({None: parts}, False)
        b = rng.choice(['nil', 'eps(3/8). rho({<k, {left, right}>}). nil', 'omega(k, {left, right}). nil'])
        leaf = '%s : Cube scaled (1,1/2,1/2) mass 2 velocity %s spin %s at translate %s [%s]'
        self.lines.append('process pair = %s\n  <k, {l.right, r.left}> %s\n' % (
            leaf % ('l', vector(velocity), vector(spin), vector(at), b),
            leaf % ('r', vector(other), vector(spin), vector(s.add(at, (2, 0, 0))), b)))

    def wall(self):
        axis, side = self.rng.randrange(3), self.rng.choice([-1, 1])
        far = max(float(abs(c[axis])) + float(r2) ** 0.5 for c, r2 in self.places)
        scale = tuple(F(1) if i == axis else F(20) for i in range(3))
        at = tuple(F(side * (int(far) + 2)) if i == axis else F(0) for i in range(3))
        self.bodies['wall'] = Body({None: self.solid('Cube', scale, s.ZERO, None)}, True)
        self.lines.append('fixed wall = Cube scaled %s at translate %s\n' % (vector(scale), vector(at)))

    def the_resolution(self):
        """Given, or the greatest power of two that is at most 2^-20 of the shortest edge."""
        if self.resolution is not None:
            return self.resolution
        least2 = min(self.edges) / 2 ** 40
        power = F(1)
        while power * power > least2:
            power /= 2
        while 4 * power * power <= least2:
            power *= 2
        return power

    def text(self):
        settings = ['timestep %s\n' % self.timestep, 'dynamics %s\n' % ('free_body' if self.free else 'constant_spin')]
        if self.resolution is not None:
            settings.append('resolution %s\n' % self.resolution)
        if self.orientation is not None:
            settings.append('round orientation 2^-%d\n' % self.orientation)
        if self.velocity is not None:
            settings.append('round velocity 2^-%d\n' % self.velocity)
        return ''.join(['model random\n'] + settings + [template(n) for n in SOLIDS]
                       + [shape[1] for shape in self.shapes] + self.lines)
