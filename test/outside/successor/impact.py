"""Elastic response of rigid bodies (rule Impact), and what bonds and splits do to motion."""

from __future__ import annotations

from fractions import Fraction
from typing import List, NamedTuple, Optional, Sequence, Tuple

import response
from near import Contact
from vectors import ZERO, Matrix, Vector, add, cross, dot, scale, solve, sub


class Rigid(NamedTuple):
    """A rigid body in the world; one without a mass is fixed."""

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
        if self.mass is None or self.inertia is None:
            return self
        turn = solve(self.inertia, cross(sub(x, self.centre), impulse))
        assert turn is not None
        return self._replace(
            velocity=add(self.velocity, scale(1 / self.mass, impulse)),
            spin=add(self.spin, tuple(turn)),  # type: ignore[arg-type]
        )


def relative(a: Rigid, b: Rigid, x: Vector) -> Vector:
    return sub(b.at(x), a.at(x))


def approaches(contact: Contact, a: Rigid, b: Rigid) -> bool:
    return any(all(dot(n, relative(a, b, x)) < 0 for n in contact.normals) for x in contact.region)


def bounce(
    contacts: Sequence[Contact], tight: Sequence[List[Vector]], a: Rigid, b: Rigid
) -> Optional[Tuple[Rigid, Rigid]]:
    """What two bodies that collide become; None where nothing would change (Persistent).

    ``tight`` are the normals of each contact where its gap is closed.
    """
    approaching = [approaches(c, a, b) for c in contacts]
    for everything in (False, True):
        rows: List[Tuple[Vector, Vector]] = []
        for i, c in enumerate(contacts):
            if not approaching[i]:
                continue
            others = [t for j, t in enumerate(tight) if j != i]
            for n in c.normals:
                if everything or not response.covered(tight[i], n, others):
                    rows += [(n, x) for x in c.region]
        if not rows:
            continue
        after = reflect(rows, a, b)
        if after != (a, b):
            return after
    return None


def reflect(rows: List[Tuple[Vector, Vector]], a: Rigid, b: Rigid) -> Tuple[Rigid, Rigid]:
    """q + 2 proj(-q): impulses k n at the corners x that stop what approaches, twice."""
    speeds = [dot(n, relative(a, b, x)) for n, x in rows]
    rest_a, rest_b = (body._replace(velocity=ZERO, spin=ZERO) for body in (a, b))
    gram = []
    for n, x in rows:  # the change of each speed by a unit of each impulse
        moved = rest_a.pushed(x, scale(-1, n)), rest_b.pushed(x, n)
        gram.append([dot(m, relative(*moved, y)) for m, y in rows])
    weights = nonnegative(gram, speeds)
    for (n, x), k in zip(rows, weights):
        if k:
            a, b = a.pushed(x, scale(-2 * k, n)), b.pushed(x, scale(2 * k, n))
    return a, b


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
