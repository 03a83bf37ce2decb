"""The first time of contact of two convex parts that turn, rounded down (rule Cast).

The least k is looked for such that the interiors meet in the course of [k, k+1] 2^-K. That they
do is shown by an instant, at which no plane separates them; that they do not, up to there, by a
plane for each of some intervals that cover all of the time: of a face of one of the two, or along
an edge of each, which turns with them. A plane separates while some polynomials are not negative.
"""

from __future__ import annotations

from fractions import Fraction
from math import ceil, isqrt, lcm
from typing import Any, Iterator, List, Optional, Tuple

from motion import (
    Flight,
    Polynomial,
    Undecided,
    inner,
    minus,
    never_negative,
    outer,
    plus,
    times,
)  # fmt: skip
from solids import Solid
from vectors import Vector, add, apply, cross, dot, sub


class Mover:
    """A part in flight: its vertices as they were, from the centre, when the turn began."""

    def __init__(self, solid: Solid, flight: Flight) -> None:
        self.solid, self.flight = solid, flight
        self.points = list(solid.place.values())

    def placed(self, t: Fraction) -> Solid:
        turn, centre = self.flight.at(t)
        return self.solid.mapped(turn, centre)

    def nearly(self, t: Fraction) -> Tuple[list, list, list]:
        """Where its vertices, faces and edges are at an instant, in floats."""
        turn, centre = self.flight.at(t)
        turn = tuple(tuple(float(x) for x in row) for row in turn)  # type: ignore[assignment]
        offset = tuple(float(x) for x in centre)
        place = {
            name: add(apply(turn, tuple(float(x) for x in p)), offset)  # type: ignore[arg-type]
            for name, p in self.solid.place.items()
        }
        faces = [(name, [place[v] for v in corners]) for name, corners in self.solid.faces]
        edges = [(place[u], place[w]) for u, w in self.solid.edges]
        return list(place.values()), faces, edges


class Grained:
    """A part in flight, in a unit of length in which all its coordinates are whole."""

    def __init__(self, mover: Mover, unit: int) -> None:
        self.flight = mover.flight
        place = {
            name: tuple(int(x * unit) for x in p) for name, p in mover.solid.place.items()
        }
        solid = Solid(list(place.items()), mover.solid.faces)  # type: ignore[arg-type]
        self.points = list(solid.place.values())
        self.edges = [(solid.place[u], solid.place[w]) for u, w in solid.edges]
        self.faces = [
            (n, dot(n, solid.place[corners[0]]))
            for n, (_, corners) in zip(solid.normals(), solid.faces)
        ]


class Casting:
    def __init__(self, a: Mover, b: Mover) -> None:
        self.a, self.b = a, b
        offset = sub(b.flight.centre, a.flight.centre)
        velocity = sub(b.flight.velocity, a.flight.velocity)
        numbers = [x for v in (offset, velocity, *a.points, *b.points) for x in v]
        unit = lcm(*(int(x.denominator) for x in numbers))
        self.between: List[Polynomial] = [
            [int(o * unit), int(v * unit)] for o, v in zip(offset, velocity)  # type: ignore
        ]
        self.one, self.two = Grained(a, unit), Grained(b, unit)
        self._conditions: dict = {}

    # Planes.

    def conditions(self, plane: Any) -> List[Polynomial]:
        """What is not negative while a plane separates the two."""
        if plane not in self._conditions:
            kind, i, j, side = plane
            if kind == "a":
                found = self._face(self.one, self.two, i, self.between)
            elif kind == "b":
                found = self._face(self.two, self.one, i, [minus(p) for p in self.between])
            else:
                found = self._edges(i, j, side)
            self._conditions[plane] = found
        return self._conditions[plane]

    def _face(self, a: Any, b: Any, i: int, between: List[Polynomial]) -> List[Polynomial]:
        normal, height = a.faces[i]
        n = a.flight.turned(normal)
        level = times([height], times(a.flight.d, b.flight.d))
        reach = [times(b.flight.d, p) for p in between]
        found = []
        for r in b.points:
            x = [plus(p, q) for p, q in zip(reach, b.flight.turned(r))]
            found.append(plus(inner(n, x), minus(level)))
        return found

    def _edges(self, i: int, j: int, side: int) -> List[Polynomial]:
        a, b = self.one, self.two
        at_a, to_a = a.edges[i]
        at_b, to_b = b.edges[j]
        along_a, along_b = sub(to_a, at_a), sub(to_b, at_b)
        turned_a, turned_b = a.flight.turned(along_a), b.flight.turned(along_b)
        found = []
        for r in a.points:
            d = cross(sub(r, at_a), along_a)
            if d != (0, 0, 0):
                found.append(minus(inner(a.flight.turned(d), turned_b)))
        for r in b.points:
            d = cross(along_b, sub(r, at_b))
            if d != (0, 0, 0):
                found.append(inner(turned_a, b.flight.turned(d)))
        gap = inner(outer(turned_a, turned_b), self.between)
        gap = plus(gap, inner(turned_a, b.flight.turned(cross(along_b, at_b))))
        gap = plus(gap, minus(inner(a.flight.turned(cross(at_a, along_a)), turned_b)))
        found.append(gap)
        return found if side > 0 else [minus(p) for p in found]

    def planes(self, t: Fraction) -> Iterator[Any]:
        """Planes that come near to separating the two at an instant, the best first (in floats)."""
        a, b = self.a.nearly(t), self.b.nearly(t)
        found = []
        for kind, one, two in (("a", a, b), ("b", b, a)):
            for i, (_, corners) in enumerate(one[1]):
                p, q, r = corners[:3]
                n = unit(cross(sub(q, p), sub(r, q)))
                gap = min(dot(n, sub(x, p)) for x in two[0])
                found.append((-gap, (kind, i, 0, 0)))
        for i, (p, q) in enumerate(a[2]):
            for j, (r, s) in enumerate(b[2]):
                n = unit(cross(sub(q, p), sub(s, r)))
                if n is None:
                    continue
                for side in (1, -1):
                    m = tuple(side * x for x in n)
                    above = max(dot(m, sub(x, p)) for x in a[0])
                    below = min(dot(m, sub(x, r)) for x in b[0])
                    gap = dot(m, sub(r, p))
                    if above < 1e-9 and below > -1e-9:
                        found.append((-gap + 1e-12, ("edges", i, j, side)))
        found.sort()
        for worth, plane in found[:8]:
            if worth < 1e-7:
                yield plane

    def separated(self, low: Fraction, high: Fraction) -> bool:
        """Whether one plane separates the two all the time; no is not a proof."""
        tried = set()
        for t in ((low + high) / 2, low, high):
            for plane in self.planes(t):
                if plane not in tried:
                    tried.add(plane)
                    if all(never_negative(p, low, high) for p in self.conditions(plane)):
                        return True
        return False

    def meet(self, t: Fraction) -> bool:
        """Whether the interiors meet at an instant, exactly."""
        return interiors_meet(self.a.placed(t), self.b.placed(t))

    def first(self, span: Fraction, grid: int, shift: Fraction = Fraction(0)) -> Optional[Fraction]:
        """t- < span, a multiple of 2^-grid that counts from ``shift`` ago; None: never."""
        cell = Fraction(1, 2**grid)

        def start(t: Fraction) -> Fraction:
            return (t + shift) // cell * cell - shift

        def search(low: Fraction, high: Fraction, depth: int) -> Optional[Fraction]:
            if self.separated(low, high):
                return None
            base = start(low)
            if high <= base + cell:
                for i in (1, 2, 3):
                    if self.meet(low + (high - low) * i / 4):
                        return max(base, Fraction(0))
                if depth > 100:
                    raise Undecided("a cast")
                middle = (low + high) / 2
            else:
                middle = start((low + high) / 2)
                if middle <= low:
                    middle = base + cell
            found = search(low, middle, depth + 1)
            return found if found is not None else search(middle, high, depth + 1)

        return search(Fraction(0), span, 0)


def unit(n: Any) -> Any:
    size = dot(n, n) ** 0.5
    return None if size < 1e-12 else tuple(x / size for x in n)


def interiors_meet(a: Solid, b: Solid) -> bool:
    """Whether no plane of a face, and none along an edge of each, separates two solids."""
    points_a, points_b = list(a.place.values()), list(b.place.values())

    def separates(n: Vector) -> bool:
        return max(dot(n, p) for p in points_a) <= min(dot(n, p) for p in points_b)

    for n in a.normals():
        if separates(n):
            return False
    for n in b.normals():
        if separates((-n[0], -n[1], -n[2])):
            return False
    lines_a = [sub(a.place[w], a.place[u]) for u, w in a.edges]
    lines_b = [sub(b.place[w], b.place[u]) for u, w in b.edges]
    for u in distinct(lines_a):
        for w in distinct(lines_b):
            n = cross(u, w)
            if n != (0, 0, 0) and (separates(n) or separates((-n[0], -n[1], -n[2]))):
                return False
    return True


def distinct(lines: List[Vector]) -> List[Vector]:
    """One of each two that are parallel."""
    found: List[Vector] = []
    for line in lines:
        if not any(cross(line, other) == (0, 0, 0) for other in found):
            found.append(line)
    return found


def speed_bound(a: Mover, b: Mover) -> Fraction:
    """S of rule Cast: no less than the speed of any point of one as seen from any of the other."""
    w = sub(b.flight.velocity, a.flight.velocity)
    found = root(dot(w, w))
    for mover in (a, b):
        spin = mover.flight.spin
        found += root(dot(spin, spin)) * reach(mover)
    return up(found)


def reach(mover: Mover) -> Fraction:
    """The short number that is no less than the distance of any point of a part from the centre."""
    _, c = mover.solid.volume_and_centroid()
    radius2 = max(dot(sub(r, c), sub(r, c)) for r in mover.points)
    return root(dot(c, c)) + root(radius2)


def size(q: Fraction) -> int:
    return q.numerator.bit_length() - q.denominator.bit_length()


def root(q: Fraction, digits: int = 20) -> Fraction:
    """The square root, rounded up to a short number (Cast, Constants)."""
    q = Fraction(q)
    if q == 0:
        return q
    k = (digits - size(q)) // 2
    n = ceil(q * Fraction(4) ** k)
    found = isqrt(n)
    return (found if found * found == n else found + 1) / Fraction(2) ** k


def up(q: Fraction) -> Fraction:
    """Rounded up to a short number."""
    q = Fraction(q)
    if q == 0:
        return q
    k = 10 - size(q)
    return ceil(q * Fraction(2) ** k) / Fraction(2) ** k


def grid(a: Mover, b: Mover, resolution: Fraction) -> int:
    """The least K >= 0 with S 2^-K <= resolution."""
    s, k = speed_bound(a, b), 0
    while s > resolution * 2**k:
        k += 1
    return k
