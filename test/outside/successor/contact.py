"""Two convex solids: Contact, Touching, Highest, Approach and Ftoc, by brute force.

The obstacle of A and B is the Minkowski difference: the offsets of B for which the two have a
point in common. It is the set where n.x <= h(n), for the directions n of its facets, and each
facet of it is orthogonal to a face of one of the two or to an edge of each. So all these
directions are tried, and those along which the difference has a facet are kept.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from math import lcm
from typing import FrozenSet, Iterable, List, Optional, Tuple

from solids import Feature, Solid
from vectors import ZERO, Vector, cross, dot, primitive, rank, scale, sub

Facet = Tuple[Vector, Fraction]  # n and h(n)


@lru_cache(maxsize=2000)
def facets(a: Solid, b: Solid) -> List[Facet]:
    """The facets of the obstacle of a and b, as outward normals and heights.

    All is computed in whole numbers, over the common denominator of the coordinates.
    """
    everything = [x for p in (*a.place.values(), *b.place.values()) for x in p]
    common = lcm(*(Fraction(x).denominator for x in everything))
    points_a = [whole(p, common) for p in a.place.values()]
    points_b = [whole(p, common) for p in b.place.values()]
    tried = {primitive(n) for n in a.normals()}
    tried |= {primitive(scale(-1, n)) for n in b.normals()}
    lines_a = {primitive(sub(a.place[w], a.place[u])) for u, w in a.edges}
    lines_b = {primitive(sub(b.place[w], b.place[u])) for u, w in b.edges}
    for u in lines_a:
        for w in lines_b:
            n = primitive(cross(u, w))
            if n is not None:
                tried |= {n, scale(-1, n)}
    found = []
    for n in sorted(tried):
        heights_a = [dot(n, p) for p in points_a]
        heights_b = [dot(n, p) for p in points_b]
        high, low = max(heights_a), min(heights_b)
        on_a = [p for p, h in zip(points_a, heights_a) if h == high]
        on_b = [p for p, h in zip(points_b, heights_b) if h == low]
        spans = [sub(p, on_a[0]) for p in on_a] + [sub(p, on_b[0]) for p in on_b]
        if rank(spans) == 2:
            found.append((n, Fraction(high - low, common)))
    return found


def whole(p: Vector, common: int) -> Vector:
    return tuple(int(x * common) for x in p)  # type: ignore[return-value]


def relation(a: Solid, b: Solid, offset: Vector) -> str:
    """Rule Contact: "apart", "touching" or "interpenetrating"."""
    touching = False
    for n, h in facets(a, b):
        at = dot(n, offset)
        if at > h:
            return "apart"
        touching = touching or at == h
    return "touching" if touching else "interpenetrating"


def tight(a: Solid, b: Solid, offset: Vector) -> List[Vector]:
    """Of two solids that touch, the normals of the facets of the obstacle that hold the offset."""
    return [n for n, h in facets(a, b) if dot(n, offset) == h]


def approaching(a: Solid, b: Solid, offset: Vector, velocity: Vector) -> bool:
    """Rule Approach, of two solids that touch; ``velocity`` is that of b less that of a."""
    return all(dot(n, velocity) < 0 for n in tight(a, b, offset))


def first_time_of_contact(
    a: Solid, b: Solid, offset: Vector, velocity: Vector
) -> Optional[Fraction]:
    """Rule Ftoc for two solids: the instant t >= 0 right after which the interiors meet."""
    if velocity == ZERO:
        return None
    enters: Optional[Fraction] = None
    leaves: Optional[Fraction] = None
    for n, h in facets(a, b):
        gap, speed = dot(n, offset) - h, dot(n, velocity)
        if speed == 0:
            if gap >= 0:
                return None
        else:
            t = Fraction(-gap) / speed
            if speed < 0:
                enters = t if enters is None else max(enters, t)
            else:
                leaves = t if leaves is None else min(leaves, t)
    assert enters is not None and leaves is not None
    return enters if 0 <= enters < leaves else None


def first_meeting(
    a: List[Vector], b: List[Vector], offset: Vector, velocity: Vector
) -> Optional[Fraction]:
    """The least t >= 0 at which two closed features have a point in common (reading I-33).

    That is when the offset of b from a is in the difference of the two, a convex set of any
    dimension. It is the set where n.x <= h(n) for the normals n of its facets: orthogonal to two
    edges, or to one and to a plane of two, or, where it is flat, on both sides along it.
    """
    lines = {primitive(sub(q, p)) for points in (a, b) for p, q in combinations(points, 2)}
    enters, leaves = Fraction(0), None
    for n in directions(frozenset(lines)):
        height = max(dot(n, p) for p in a) - min(dot(n, q) for q in b)
        gap, speed = dot(n, offset) - height, dot(n, velocity)
        if speed == 0:
            if gap > 0:
                return None
        elif speed < 0:
            enters = max(enters, Fraction(-gap) / speed)
        else:
            t = Fraction(-gap) / speed
            leaves = t if leaves is None else min(leaves, t)
    return None if leaves is not None and leaves < enters else enters


@lru_cache(maxsize=2000)
def directions(lines: FrozenSet[Vector]) -> List[Vector]:
    """All directions that ``first_meeting`` tries, of two features with these lines."""
    axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    planes = {primitive(cross(u, w)) for u in lines for w in [*lines, *axes]}
    planes.discard(None)
    inner = {primitive(cross(n, u)) for n in planes for u in lines}
    inner.discard(None)
    normals = {*axes, *lines, *planes, *inner}
    return sorted(normals | {scale(-1, n) for n in normals})


def zero_is_inside(points: Iterable[Vector]) -> bool:
    """Whether 0 is in the relative interior of the convex hull of the points.

    It is not iff they lie on one side of some plane through 0, not all on it; that plane can be
    turned until as many of the points are on it as span a plane of what all of them span.
    """
    points = list(points)
    others = list({primitive(p) for p in points if p != ZERO})
    dimension = rank(others)
    if dimension == 0:
        return True
    if dimension == 1:
        planes = [others[0]]
    elif dimension == 2:
        first = others[0]
        up = next(cross(first, p) for p in others if cross(first, p) != ZERO)
        planes = [cross(up, p) for p in others]
    else:
        planes = [cross(p, q) for p, q in combinations(others, 2)]
    for n in planes:
        if n == ZERO:
            continue
        signs = {(h > 0) - (h < 0) for h in (dot(n, p) for p in others)}
        if (1 in signs) != (-1 in signs):
            return False
    return True


def touch(points_a: List[Vector], points_b: List[Vector]) -> bool:
    """Reading I-3: the relative interiors of two features have a point in common."""
    return zero_is_inside(sub(p, q) for p in points_a for q in points_b)


def touching_pairs(a: Solid, b: Solid, offset: Vector) -> List[Tuple[Feature, Feature, int]]:
    """Rule Touching: all pairs of features that touch, with the dimension of the contact.

    What the two have in common lies in each plane that separates them; so do features with a
    relative interior that meets it. Of the others all pairs are tried.
    """
    planes = [(n, max(dot(n, p) for p in a.place.values())) for n in tight(a, b, offset)]

    def lies(points: List[Vector]) -> bool:
        return all(dot(n, p) == h for n, h in planes for p in points)

    near_a = [(f, a.points(f)) for f in a.features()]
    near_b = [
        (f, [(p[0] + offset[0], p[1] + offset[1], p[2] + offset[2]) for p in b.points(f)])
        for f in b.features()
    ]
    near_a = [(f, ps) for f, ps in near_a if lies(ps)]
    near_b = [(f, ps) for f, ps in near_b if lies(ps)]
    found = []
    for f, points_a in near_a:
        for g, points_b in near_b:
            if touch(points_a, points_b):
                found.append((f, g, dimension(points_a, points_b)))
    return found


def dimension(points_a: List[Vector], points_b: List[Vector]) -> int:
    """The dimension of the intersection of two sets whose relative interiors meet."""
    spans_a = [sub(p, points_a[0]) for p in points_a]
    spans_b = [sub(p, points_b[0]) for p in points_b]
    return rank(spans_a) + rank(spans_b) - rank(spans_a + spans_b)
