"""States of a rigid model as scc prints them, and how they move and collide: rules Turn, Bind, Bounce and Split.

All numbers are fractions; bodies are the `Solid`s of a leaf, and what is fixed.
"""

from fractions import Fraction as F

import solids as s


class Difference(Exception):
    """Between scc and what is computed here."""


class Body:
    def __init__(self, parts, fixed):
        self.parts = parts  # name (None for a basic shape) -> Solid
        self.fixed = fixed


def estimate(v):
    """A spin to forty bits of its greatest component, halves away from zero."""
    greatest = max(map(abs, v))
    if greatest == 0:
        return v
    unit = F(1)
    while unit > greatest:
        unit /= 2
    while 2 * unit <= greatest:
        unit *= 2
    unit /= 2 ** 40
    return tuple((1 if x > 0 else -1) * ((2 * abs(x) / unit + 1) // 2) * unit for x in v)


class Leaf:
    def __init__(self, body, name, position, turned):
        self.body, self.name, self.position, self.turned = body, name, position, turned


class Process:
    """`kept` is the angular momentum of a free body about its centre of mass; else None. `lasts` is how long its present
    turn lasts in all, None while one is due."""

    def __init__(self, leaves, velocity, spin, since, bonds, kept=None, lasts=None):
        self.leaves, self.velocity, self.spin, self.since, self.bonds = leaves, velocity, spin, since, bonds
        self.kept, self.lasts = kept, lasts
        self.names = frozenset(l.name for l in leaves)
        self.fixed = any(l.body.fixed for l in leaves)
        self.known = {}

    def moved(self, leaves, velocity=None, spin=None, since=None, kept=None):
        return Process(leaves, self.velocity if velocity is None else velocity,
                       self.spin if spin is None else spin, self.since if since is None else since, self.bonds,
                       self.kept if kept is None else kept, self.lasts)

    def begun(self):
        """A free body keeps the angular momentum that its spin gives it now."""
        if self.kept is None:
            return self
        return self.moved(self.leaves, kept=s.ZERO if self.fixed else s.apply(self.inertia(), self.spin))

    def mass(self):
        if 'mass' not in self.known:
            self.known['mass'] = sum(p.mass for l in self.leaves for p in l.body.parts.values())
        return self.known['mass']

    def centre(self):
        if 'centre' not in self.known:
            c = s.ZERO
            for l in self.leaves:
                m = s.matrix(l.turned)
                for p in l.body.parts.values():
                    c = s.add(c, s.mul(p.mass, s.add(l.position, s.apply(m, p.centroid))))
            self.known['centre'] = s.mul(1 / self.mass(), c)
        return self.known['centre']

    def inertia(self):
        """About the centre of mass: C M C^T for the second moments M of each part, and the parallel axes."""
        if 'inertia' not in self.known:
            centre = self.centre()
            total = [[F(0)] * 3 for _ in range(3)]
            for l in self.leaves:
                m = s.matrix(l.turned)
                for p in l.body.parts.values():
                    r = s.sub(s.add(l.position, s.apply(m, p.centroid)), centre)
                    half = [s.apply(m, row) for row in p.moments]  # M C^T, by rows of M
                    for a in range(3):
                        for b in range(3):
                            total[a][b] += sum(m[a][k] * half[k][b] for k in range(3)) + p.mass * r[a] * r[b]
            self.known['inertia'] = s.inertia_of(total)
        return self.known['inertia']

    def turned_by(self, delta, move=s.ZERO):
        """All leaves turned by a quaternion about the centre of mass, which moves."""
        m, c = s.matrix(delta), self.centre()
        return [Leaf(l.body, l.name, s.add(s.add(c, move), s.apply(m, s.sub(l.position, c))),
                     s.canonical(s.times(delta, l.turned))) for l in self.leaves]

    def delta(self, t):
        """The turn from now until t later: C is not additive."""
        if self.spin == s.ZERO:
            return (1, 0, 0, 0)
        after = s.cayley(s.mul((self.since + t) / 2, self.spin))
        return s.times(after, s.inverse(s.cayley(s.mul(self.since / 2, self.spin))))

    def leaves_at(self, t):
        if self.fixed or t == 0:
            return self.leaves
        return self.turned_by(self.delta(t), s.mul(t, self.velocity))

    def passed(self, t):
        """`since` is kept only of what spins: a state is the same however long nothing has turned."""
        if self.fixed:
            return self
        return self.moved(self.leaves_at(t), since=F(0) if self.spin == s.ZERO else self.since + t)

    def rate(self):
        """The spin that collisions see."""
        if self.kept is None or self.fixed:
            return self.spin
        return s.solve(self.inertia(), self.kept)

    def renewed(self):
        """With a new turn due."""
        return self.moved(self.leaves, spin=self.rate(), since=F(0)).lasting(None)

    def lasting(self, lasts):
        """A turn of this length; None: one is due."""
        made = self.moved(self.leaves)
        made.lasts = lasts
        return made

    def plain_turn(self, timestep):
        """At the start of a turn about the spin that it has."""
        return self.lasting(F(0) if self.spin == s.ZERO else turn_length(timestep, self.spin))

    def turns(self, timestep):
        """The turns that may begin: of a free body with what its angular momentum gives half-way, C I^-1 C^-1 L; or,
        where something would collide with that, as it is."""
        if self.kept is None or self.fixed or self.spin == s.ZERO:
            return [self.plain_turn(timestep)]
        d = turn_length(timestep, self.spin)
        while True:
            half = self.moved(self.turned_by(s.cayley(s.mul(d / 4, estimate(self.spin)))))
            spin = estimate(s.solve(half.inertia(), self.kept))
            if s.dot(spin, spin) * d * d <= F(1, 4):
                return [self.moved(self.leaves, spin=spin).lasting(d), self.plain_turn(timestep)]
            d /= 2

    def velocity_at(self, x):
        if self.fixed:
            return s.ZERO
        return s.add(self.velocity, s.cross(self.spin, s.sub(x, self.centre())))

    def momenta(self):
        p = s.mul(self.mass(), self.velocity)
        own = s.apply(self.inertia(), self.spin) if self.kept is None else self.kept
        return p, s.add(s.cross(self.centre(), p), own)

    def energy(self):
        spin = self.rate()
        return (self.mass() * s.dot(self.velocity, self.velocity) + s.dot(spin, s.apply(self.inertia(), spin))) / 2

    def parts(self, t=F(0)):
        if t not in self.known:
            self.known[t] = [s.Placed(p, l.turned, l.position)
                             for l in self.leaves_at(t) for p in l.body.parts.values()]
        return self.known[t]

    def reaches2(self):
        """Squared, of each part: of its farthest corner from what it turns about."""
        if 'reaches2' not in self.known:
            c = s.ZERO if self.fixed else self.centre()
            self.known['reaches2'] = [max(s.dot(r, r) for r in (s.sub(x, c) for x in p.points)) for p in self.parts()]
        return self.known['reaches2']

    def reach2(self):
        return max(self.reaches2())

    def least_reach2(self):
        return min(self.reaches2())

    def same(self, other):
        return self.difference(other) is None

    def difference(self, other):
        for a, b in zip(self.leaves, other.leaves):
            if a.name != b.name or a.position != b.position or a.turned != b.turned:
                return 'leaf %s: position %s, turned %s; computed %s, %s' % (
                    a.name, show(a.position), a.turned, show(b.position), b.turned)
        for what in ('velocity', 'spin', 'since', 'lasts', 'kept'):
            if getattr(self, what) != getattr(other, what):
                return '%s of %s: %s; computed %s' % (what, self.leaves[0].name, show(getattr(self, what)),
                                                      show(getattr(other, what)))
        return None


def show(v):
    return '(%s)' % ', '.join(map(str, v)) if isinstance(v, tuple) else str(v)


class State:
    def __init__(self, bodies, j):
        def vector(v):
            return tuple(map(F, v))
        self.processes = []
        for p in j['processes']:
            leaves = [Leaf(bodies[l['name']], l['name'], vector(l['position']), tuple(map(int, l['turned'])))
                      for l in p['leaves']]
            bonds = [(b['name'], frozenset(b['ends'])) for b in p['bonds']]
            kept = vector(p['angular_momentum']) if 'angular_momentum' in p else None
            process = Process(leaves, vector(p['velocity']), vector(p['spin']), F(p['since']), bonds, kept)
            self.processes.append(process.lasting(None if p['lasts'] is None else F(p['lasts'])))
        assert j['step'] is None

    def of(self, name):
        return next(p for p in self.processes if name in p.names)


def turn_length(timestep, spin):
    """Delta/2^k for the least k such that |spin| d / 2 <= 1/4."""
    d = timestep
    while s.dot(spin, spin) * d * d > F(1, 4):
        d /= 2
    return d


def bound(p, q, bonds):
    """Rule Bind: momentum and angular momentum are kept; with something fixed the whole is fixed."""
    leaves = sorted(p.leaves + q.leaves, key=lambda l: l.name)
    whole = Process(leaves, s.ZERO, s.ZERO, F(0), bonds, None if p.kept is None else s.ZERO)
    if whole.fixed:
        return whole
    (pp, pl), (qp, ql) = p.momenta(), q.momenta()
    momentum = s.add(pp, qp)
    spin = s.solve(whole.inertia(), s.sub(s.add(pl, ql), s.cross(whole.centre(), momentum)))
    return whole.moved(leaves, s.mul(1 / whole.mass(), momentum), spin).begun()


def piece(whole, after):
    """Reading I-23, of a whole that begins a turn: the spin of the whole, the velocity of the piece's own centre."""
    if after.fixed or whole.fixed:
        return after.moved(after.leaves, s.ZERO, s.ZERO, F(0)).begun()
    return after.moved(after.leaves, whole.velocity_at(after.centre()), whole.spin, F(0)).begun()


def totals(processes):
    momentum, angular, energy = s.ZERO, s.ZERO, F(0)
    for p in processes:
        if not p.fixed:
            a, b = p.momenta()
            momentum, angular, energy = s.add(momentum, a), s.add(angular, b), energy + p.energy()
    return momentum + angular + (energy,)


def rounded_quaternion(k, q):
    """Components in proportion to the greatest, which becomes 2^k, to the nearest integers."""
    top = max(map(abs, q))
    if top <= 2 ** k:
        return q
    return s.canonical(tuple(to_nearest(F(a * 2 ** k, top)) for a in q))


def to_nearest(x):
    """Halves away from zero."""
    n = (2 * abs(x.numerator) + x.denominator) // (2 * x.denominator)
    return n if x >= 0 else -n


def rounded_vector(quantum, v):
    return tuple(to_nearest(a / quantum) * quantum for a in v)


def rounded_motion(p, quantum):
    """What is kept in proportion to the greatest power of two that is at most the trace of the inertia."""
    kept = p.kept
    if kept is not None:
        trace, scale = sum(p.inertia()[i][i] for i in range(3)), F(1)
        while scale > trace:
            scale /= 2
        while 2 * scale <= trace:
            scale *= 2
        kept = rounded_vector(quantum * scale, kept)
    if kept is not None:  # The spin follows from it.
        return p.moved(p.leaves, rounded_vector(quantum, p.velocity), kept=kept).renewed()
    return p.moved(p.leaves, rounded_vector(quantum, p.velocity), rounded_vector(quantum, p.spin)).lasting(None)


def roundings(p, orientation, velocity):
    """What rule Round may make of a process: [most rounded, ..., as it was], as it may wait with each."""
    found = [p]
    if p.fixed:
        return found
    if orientation is not None:
        q = min((l.turned for l in p.leaves), key=lambda q: (max(map(abs, q)), q))
        r = rounded_quaternion(orientation, q)
        if r != q:
            turned = p.moved(p.turned_by(s.times(r, s.inverse(q))))
            found.insert(0, turned.moved(turned.leaves, spin=turned.rate()))  # of a free body, as it is turned now
    if velocity is not None:
        found = [rounded_motion(f, F(1, 2 ** velocity)) for f in found] + found
    return found
