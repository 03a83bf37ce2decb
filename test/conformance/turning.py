"""Bodies that turn, naively and exactly: rules Turn, Cast and Impact for two convex solids that do not touch, or touch
exactly, without inner corners.

A cast advances as far as the gap between the two allows at the greatest speed that any point can have, again and
again; it ends in the cell of the grid at whose far end the two interpenetrate. An impact tries every set of corners
that may act.
"""

from fractions import Fraction as F
from itertools import combinations
from math import isqrt, lcm

from geometry import ZERO, add, axes, cross, dot, mass_properties, primitive, scale, solve, sub


def apply(matrix, v):
    return tuple(dot(row, v) for row in matrix)


def cayley(u):
    """The rotation by 2 atan|u| about u."""
    n = dot(u, u)
    hat = ((0, -u[2], u[1]), (u[2], 0, -u[0]), (-u[1], u[0], 0))
    return tuple(tuple(((1 - n) * (i == j) + 2 * u[i] * u[j] + 2 * hat[i][j]) / F(1 + n) for j in range(3))
                 for i in range(3))


def rotation(q):
    """Of the quaternion w + xi + yj + zk, of any length: the Cayley map of (x, y, z) / w, or its limit."""
    w, x, y, z = (F(a) for a in q)
    n = w * w + x * x + y * y + z * z
    u, hat = (x, y, z), ((0, -z, y), (z, 0, -x), (-y, x, 0))
    return tuple(tuple(((w * w - dot(u, u)) * (i == j) + 2 * u[i] * u[j] + 2 * w * hat[i][j]) / n for j in range(3))
                 for i in range(3))


class Body:
    """A solid in the world as it is now, its velocity, its spin, the point that it turns about, and how long ago its turn
    began."""

    def __init__(self, solid, velocity=ZERO, spin=ZERO, centre=None, since=F(0)):
        self.solid, self.velocity, self.spin, self.since = solid, velocity, spin, since
        self.centre = mass_properties(solid)[1] if centre is None else centre

    def at(self, t):
        if self.spin == ZERO:
            return self.solid.moved(scale(t, self.velocity))
        back = cayley(scale(-self.since / 2, self.spin))
        turn = cayley(scale((self.since + t) / 2, self.spin))
        there = add(self.centre, scale(t, self.velocity))
        return self.solid.image(lambda p: add(there, apply(turn, apply(back, sub(p, self.centre)))))

    def speed(self):
        """No point is faster, about the centre: spin times reach."""
        reach = max(dot(sub(p, self.centre), sub(p, self.centre)) for p in self.solid.points)
        return root(dot(self.spin, self.spin)) * root(reach)


def root(q):
    """A little more than the square root."""
    big = 2 ** 40
    return F(isqrt(int(q * big * big)) + (q != 0), big)


def gap(a, b):
    """The greatest separation along an axis, a little less than it: negative if they interpenetrate."""
    k = lcm(a.denominator(), b.denominator())
    a, b = a.times(k), b.times(k)
    best = None
    for n in axes(a, b):
        room = min(dot(n, q) for q in b.points) - max(dot(n, p) for p in a.points)
        length = F(room, k) / (root(dot(n, n)) if room > 0 else 1)
        best = length if best is None else max(best, length)
    return best


def speed_bound(a, b):
    w = sub(b.velocity, a.velocity)
    return root(dot(w, w)) + a.speed() + b.speed()


def grid_of(bound, resolution):
    k = 0
    while bound / 2 ** k > resolution:
        k += 1
    return k


class Undecided(Exception):
    pass


def turn_phase(a, b):
    """Of the grid of rule Cast: since the last of their turns began."""
    return min((o.since for o in (a, b) if o.spin != ZERO), default=F(0))


def cast(a, b, span, grid, limit=600, phase=F(0)):
    """'never', 'inside', or the last instant of the grid before they first interpenetrate; now, if that was before. The
    grid began to count so long ago."""
    cell, bound, t = F(1, 2 ** grid), speed_bound(a, b), F(0)
    for _ in range(limit):
        room = gap(a.at(t), b.at(t))
        if room < 0:
            if t == 0:
                return 'inside'
            raise Undecided('not seen coming')
        step = room / bound if bound else span + 1
        after = t + step
        if after > span:
            return 'never'
        begun = (t + phase) // cell * cell - phase
        end = min(begun + cell, span)
        if after < end:
            if gap(a.at(end), b.at(end)) < 0:
                return max(begun, F(0))
            if step < cell / 2 ** 20:
                raise Undecided('too close')
        t = F(int(after * 2 ** (grid + 24)), 2 ** (grid + 24))
    raise Undecided('too many steps')


# Rule Impact ----------------------------------------------------------------------------


class Mass:
    """Of a body: mass (None for a fixed one), inertia about its centre of mass, and that point."""

    def __init__(self, mass, inertia, centre):
        self.mass, self.inertia, self.centre = mass, inertia, centre

    def respond(self, impulse, at):
        """The change of velocity and of spin by an impulse at a point."""
        if self.mass is None:
            return ZERO, ZERO
        moment = cross(sub(at, self.centre), impulse)
        return scale(F(1) / self.mass, impulse), tuple(solve([list(r) for r in self.inertia], list(moment)))


def mass_of(solid, mass):
    volume, centre, inertia = mass_properties(solid)
    if mass is None:
        return Mass(None, None, centre)
    return Mass(mass, tuple(scale(mass / volume, row) for row in inertia), centre)


def velocity_at(mass, motion, point):
    v, spin = motion
    return add(v, cross(spin, sub(point, mass.centre)))


def impact(a, motion_a, b, motion_b, rows):
    """Motions after the impact; `rows` are (normal from A to B, corner). None if nothing approaches."""
    def relative(x, m, n):
        return sub(velocity_at(b, n, x), velocity_at(a, m, x))

    before = [dot(n, relative(x, motion_a, motion_b)) for n, x in rows]
    if all(s >= 0 for s in before):
        return None
    matrix = []
    for n, x in rows:
        da, db = a.respond(scale(-1, n), x), b.respond(n, x)
        matrix.append([dot(m, relative(y, da, db)) for m, y in rows])
    columns = range(len(rows))
    for size in range(1, len(rows) + 1):
        for act in combinations(columns, size):
            lengths = solve([[matrix[j][i] for j in act] for i in act], [-before[i] for i in act])
            if lengths is None or any(k < 0 for k in lengths):
                continue
            full = {i: k for i, k in zip(act, lengths)}
            if all(before[i] + sum(k * matrix[j][i] for j, k in full.items()) >= 0 for i in columns):
                return changed(a, motion_a, b, motion_b, [(2 * k, rows[j]) for j, k in full.items()])
    raise AssertionError('no impact')


def changed(a, motion_a, b, motion_b, impulses):
    for k, (n, x) in impulses:
        da, db = a.respond(scale(-k, n), x), b.respond(scale(k, n), x)
        motion_a = tuple(add(u, d) for u, d in zip(motion_a, da))
        motion_b = tuple(add(u, d) for u, d in zip(motion_b, db))
    return motion_a, motion_b
