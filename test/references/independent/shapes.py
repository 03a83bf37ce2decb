"""Shapes and laws of motion to choose from, each as text and as something to calculate with."""

from fractions import Fraction as F

import calculus as c

TEMPLATES = {
    'Cube': """shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
""",
    'Brick': """shape Brick {
  vertices v0 (0,0,0)  v1 (2,0,0)  v2 (0,1,0)  v3 (2,1,0)
           v4 (0,0,1)  v5 (2,0,1)  v6 (0,1,1)  v7 (2,1,1)
  faces    xl [v0,v4,v6,v2]  xh [v1,v3,v7,v5]  yl [v0,v1,v5,v4]
           yh [v2,v6,v7,v3]  zl [v0,v2,v3,v1]  zh [v4,v5,v7,v6]
}
""",
}
CORNERS = {
    'Cube': dict(a=(-1, -1, -1), b=(1, -1, -1), c=(1, 1, -1), d=(-1, 1, -1),
                 e=(-1, -1, 1), f=(1, -1, 1), g=(1, 1, 1), h=(-1, 1, 1)),
    'Brick': {'v%d' % i: (2 * (i & 1), i >> 1 & 1, i >> 2) for i in range(8)},
}
FACES = {
    'Cube': dict(bottom='adcb', top='efgh', left='aehd', right='bcgf', front='abfe', back='dhgc'),
    'Brick': dict(xl=['v0', 'v4', 'v6', 'v2'], xh=['v1', 'v3', 'v7', 'v5'], yl=['v0', 'v1', 'v5', 'v4'],
                  yh=['v2', 'v6', 'v7', 'v3'], zl=['v0', 'v2', 'v3', 'v1'], zh=['v4', 'v5', 'v7', 'v6']),
}
QUATERNIONS = [(1, 0, 0, 1), (1, 1, 0, 0), (1, 0, -1, 0), (1, 1, 1, 1), (0, 1, 0, 0), (2, 0, 2, 0)]


def rotate(q, v):
    """The rotation of the quaternion w + xi + yj + zk, not normalised."""
    w, x, y, z = map(F, q)
    n = w * w + x * x + y * y + z * z
    rows = ((w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z))
    return tuple(sum(r * a for r, a in zip(row, v)) / n for row in rows)


def vector(v):
    return '(%s)' % ', '.join(str(a) for a in v)


class Shape:
    """A basic shape or a compound: its parts as (name, template, scale, move, mass)."""

    def __init__(self, name, parts, text):
        self.name, self.parts, self.text = name, parts, text

    def placed(self, turn, move):
        """Parts for a body whose position is the image of the origin: no move is applied."""
        made = []
        for name, template, scale, at, mass in self.parts:
            corners = {}
            for n, v in CORNERS[template].items():
                v = c.plus(tuple(F(a) * s for a, s in zip(v, scale)), at)
                corners[n] = rotate(turn, v) if turn else tuple(map(F, v))
            faces = {frozenset(vs): f for f, vs in FACES[template].items()}
            made.append(c.Part(name, corners, faces, mass))
        return made


def site_text(parts, site, rng=None):
    part = next(p for p in parts if p.name == site[0])
    prefix = '' if site[0] is None else site[0] + '.'
    if site[1] in part.faces:
        return prefix + part.faces[site[1]]
    names = sorted(site[1])
    if rng:
        rng.shuffle(names)
    return '%s[%s]' % (prefix, ','.join(names))


LAWS = [
    lambda k: ('(vx, vy, vz - %s*dt)' % k, lambda e: (e['vx'], e['vy'], e['vz'] - k * e['dt'])),
    lambda k: ('(vx - %s*dt, vy, vz)' % k, lambda e: (e['vx'] - k * e['dt'], e['vy'], e['vz'])),
    lambda k: ('(vx - %s*vx*dt/4, vy - %s*vy*dt/4, vz)' % (k, k),
               lambda e: (e['vx'] - k * e['vx'] * e['dt'] / 4, e['vy'] - k * e['vy'] * e['dt'] / 4, e['vz'])),
    lambda k: ('(-1, vy, 0)', lambda e: (F(-1), e['vy'], F(0))),
    lambda k: ('(if vx = 0 then %s else vx, vy, vz)' % k,
               lambda e: (k if e['vx'] == 0 else e['vx'], e['vy'], e['vz'])),
    lambda k: ('(if x > %s then -1 else 1, if z >= y then vy else -vy, vz)' % k,
               lambda e: (F(-1) if e['x'] > k else F(1), e['vy'] if e['z'] >= e['y'] else -e['vy'], e['vz'])),
    lambda k: ('(vx - x*dt, vy + dt/mass, vz)',
               lambda e: (e['vx'] - e['x'] * e['dt'], e['vy'] + e['dt'] / e['mass'], e['vz'])),
    lambda k: ('(vx + %s*dt*(2 - time), vy, vz)' % k,
               lambda e: (e['vx'] + k * e['dt'] * (2 - e['time']), e['vy'], e['vz'])),
]

# Laws that choose (rule Draw): velocities with weights. With the timestep for k the first ones lead to few places.
RETURNS = [
    lambda k: ('choose { (-x/(%s), 0, 0), (0, -y/(%s), 0) weight 2, (0, 0, 0) }' % (k, k),
               lambda e: [((-e['x'] / k, F(0), F(0)), F(1)), ((F(0), -e['y'] / k, F(0)), F(2)),
                          ((F(0), F(0), F(0)), F(1))]),
    lambda k: ('choose { (-2*x/(%s), 0, 0), (0, 0, 0) weight x*x }' % k,
               lambda e: [((-2 * e['x'] / k, F(0), F(0)), F(1)), ((F(0), F(0), F(0)), e['x'] ** 2)]),
]
CHOICES = RETURNS + [
    lambda k: ('choose { (vx, vy, vz) + (%s, 0, 0), (vx, vy, vz) - (%s, 0, 0) weight 3 }' % (k, k),
               lambda e: [((e['vx'] + k, e['vy'], e['vz']), F(1)), ((e['vx'] - k, e['vy'], e['vz']), F(3))]),
    lambda k: ('choose { (%s, 0, 0) weight mass, (-1, vy, 0) weight if y > 0 then 1 else 0, (%s, 0, 0) }' % (k, k),
               lambda e: [((k, F(0), F(0)), e['mass']), ((F(-1), e['vy'], F(0)), F(e['y'] > 0)),
                          ((k, F(0), F(0)), F(1))]),
    lambda k: ('choose { for i in -1..1: (i, 0, 0) weight 2 - i*i }',
               lambda e: [((F(i), F(0), F(0)), F(2 - i * i)) for i in (-1, 0, 1)]),
    lambda k: ('choose { (0, 0, 0), (0, -1, 0) weight %s + dt }' % k,
               lambda e: [((F(0), F(0), F(0)), F(1)), ((F(0), F(-1), F(0)), k + e['dt'])]),
]
