"""Elastic response of rigid bodies (rule Impact), and what bonds and splits do to motion."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt
from typing import List, NamedTuple, Optional, Sequence, Tuple

import contact
import response
from cast import root
from near import Contact
from solids import Solid
from vectors import ZERO, Matrix, Vector, add, cross, dot, scale, solve, sub


Row = Tuple[int, int, Vector, Vector]  # two bodies by their numbers, a normal and a corner


class Rigid(NamedTuple):
    """A rigid body in the world; without a mass it is fixed, without an inertia it never turns."""

    mass: Optional[Fraction]
    centre: Vector
    inertia: Optional[Matrix]
    velocity: Vector
    spin: Vector

    def at(self, x: Vector) -> Vector:
        """The velocity of the body at a point."""
        return add(self.velocity, cross(self.spin, sub(x, self.centre)))

    def pushed(self, x: Vector, impulse: Vector) -> "Rigid":
        """After an impulse at a point."""
        if self.mass is None:
            return self
        if self.inertia is None:
            return self._replace(velocity=add(self.velocity, scale(1 / self.mass, impulse)))
        turn = solve(self.inertia, cross(sub(x, self.centre), impulse))
        assert turn is not None
        return self._replace(
            velocity=add(self.velocity, scale(1 / self.mass, impulse)),
            spin=add(self.spin, tuple(turn)),  # type: ignore[arg-type]
        )


def unit(v: Vector) -> Vector:
    """Along a vector, of the length 1 or, where its own length is not rational, a little less
    (I-36)."""
    square = Fraction(dot(v, v))
    length = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return scale(1 / (length if length**2 == square else root(square, 80)), v)


def relative(a: Rigid, b: Rigid, x: Vector) -> Vector:
    return sub(b.at(x), a.at(x))


def approaches(met: Contact, a: Rigid, b: Rigid) -> bool:
    return any(all(dot(n, relative(a, b, x)) < 0 for n in met.normals) for x in met.region)


def bounce(
    contacts: Sequence[Contact], solids: Sequence[Tuple[Solid, Solid]], a: Rigid, b: Rigid
) -> Optional[Tuple[Rigid, Rigid]]:
    """What two bodies that collide become; None where nothing would change (Persistent)."""
    kept = rows(contacts, solids, a, b)
    if not kept:
        return None
    after = reflect_all([(0, 1, n, x) for n, x in kept], [a, b])
    return None if after == [a, b] else (after[0], after[1])


def rows(
    contacts: Sequence[Contact], solids: Sequence[Tuple[Solid, Solid]], a: Rigid, b: Rigid
) -> List[Tuple[Vector, Vector]]:
    """The normals that count of two bodies that collide, each with a corner that it is taken at.

    ``solids`` are the two parts of each contact, in the world.
    """
    approaching = [i for i, c in enumerate(contacts) if approaches(c, a, b)]
    kept: List[Tuple[Vector, Vector]] = []
    for i in approaching:
        kept += [(n, x) for n in counting(contacts, solids, i) for x in contacts[i].region]
    if not any(dot(n, relative(a, b, x)) < 0 for n, x in kept):
        kept = [
            (n, x) for i in approaching for n in contacts[i].normals for x in contacts[i].region
        ]
    return kept


def counting(
    contacts: Sequence[Contact], solids: Sequence[Tuple[Solid, Solid]], i: int
) -> Sequence[Vector]:
    """The normals of a contact that count (I-13), where its own gap is closed."""
    closed = scale(-1, contacts[i].gap)
    own = contact.tight(*solids[i], closed)
    others = []
    for j, (one, two) in enumerate(solids):
        if j == i or contact.relation(one, two, closed) == "apart":
            continue
        # One that interpenetrates has no tight normals: its obstacle is all around.
        others.append(contact.tight(one, two, closed))
    left = [n for n in own if not response.covered(own, n, others)]
    return contacts[i].normals if len(left) == len(own) else left


def reflect_all(rows: List[Row], bodies: List[Rigid]) -> List[Rigid]:
    """q + 2 proj(-q): impulses k n at the corners x that stop what approaches, twice."""

    def speed(row: Row, there: List[Rigid]) -> Fraction:
        i, j, n, x = row
        return dot(n, relative(there[i], there[j], x))

    def pushed(row: Row, k: Fraction, there: List[Rigid]) -> List[Rigid]:
        i, j, n, x = row
        found = list(there)
        found[i], found[j] = there[i].pushed(x, scale(-k, n)), there[j].pushed(x, scale(k, n))
        return found

    still = [body._replace(velocity=ZERO, spin=ZERO) for body in bodies]
    gram = []
    for row in rows:  # the change of each speed by a unit of each impulse
        moved = pushed(row, Fraction(1), still)
        gram.append([speed(other, moved) for other in rows])
    weights = nonnegative(gram, [speed(row, bodies) for row in rows])
    for row, k in zip(rows, weights):
        if k:
            bodies = pushed(row, 2 * k, bodies)
    return bodies


def nonnegative(gram: List[List[Fraction]], speeds: List[Fraction]) -> List[Fraction]:
    """k >= 0 with gram k + speeds >= 0, zero where k > 0 (Lawson and Hanson, exactly)."""
    n = len(speeds)
    weights = [Fraction(0)] * n
    passive: List[int] = []
    while True:
        slack = [
            sum((g * k for g, k in zip(gram[i], weights)), Fraction(0)) + speeds[i]
            for i in range(n)
        ]
        worst = [(slack[i], i) for i in range(n) if i not in passive and slack[i] < 0]
        if not worst:
            return weights
        passive.append(min(worst)[1])
        while True:
            inner = solve(
                [[gram[i][j] for j in passive] for i in passive], [-speeds[i] for i in passive]
            )
            assert inner is not None
            if all(k > 0 for k in inner):
                weights = [Fraction(0)] * n
                for i, k in zip(passive, inner):
                    weights[i] = k
                break
            step = min(weights[i] / (weights[i] - k) for i, k in zip(passive, inner) if k <= 0)
            for i, k in zip(passive, inner):
                weights[i] += step * (k - weights[i])
            passive = [i for i in passive if weights[i] > 0]
