"""Elastic response in translation: the projection on a cone, and inner corners (I-13)."""

from __future__ import annotations

from itertools import combinations
from typing import List, Sequence

from vectors import ZERO, Vector, add, cross, dot, primitive, scale, solve


def project(normals: Sequence[Vector], w: Vector) -> Vector:
    """The projection of w on the cone that the normals span: the point of it nearest to w.

    It is a combination p, with coefficients >= 0, of some independent normals, with w - p
    orthogonal to each of these and to no normal at an acute angle. All subsets are tried.
    """
    distinct = sorted({primitive(n) for n in normals})
    for size in range(0, 4):
        for chosen in combinations(distinct, size):
            gram = [[dot(m, n) for n in chosen] for m in chosen]
            weights = solve(gram, [dot(m, w) for m in chosen])
            if weights is None or any(k < 0 for k in weights):
                continue
            p = ZERO
            for k, n in zip(weights, chosen):
                p = add(p, scale(k, n))
            rest = (w[0] - p[0], w[1] - p[1], w[2] - p[2])
            if all(dot(n, rest) <= 0 for n in distinct):
                return p
    raise AssertionError("a cone has a nearest point")


def covered(own: Sequence[Vector], n: Vector, others: Sequence[Sequence[Vector]]) -> bool:
    """Whether the facet with normal n of one obstacle lies behind other obstacles (I-13).

    All is seen near the present offset, where an obstacle is the cone m.x <= 0 of its tight
    normals m, and the facet is a plane cone. Lines m.x = 0 of the other obstacles cut this cone
    into sectors; a point x + e n, for x inside a sector and a small e > 0, is in an obstacle iff
    m.x < 0, or m.x = 0 and m.n <= 0, for all normals m of it.
    """
    for x in sectors(own, n, others):
        if not any(all(behind(m, n, x) for m in normals) for normals in others):
            return False
    return True


def behind(m: Vector, n: Vector, x: Vector) -> bool:
    at = dot(m, x)
    return at < 0 or (at == 0 and dot(m, n) <= 0)


def sectors(own: Sequence[Vector], n: Vector, others: Sequence[Sequence[Vector]]) -> List[Vector]:
    """A point inside each of the sectors of a facet; see ``covered``."""
    rays = set()
    for normals in [own] + list(others):
        for m in normals:
            ray = primitive(cross(n, m))
            if ray is not None:
                rays.add(ray)
                rays.add((-ray[0], -ray[1], -ray[2]))
    some = next(r for r in (cross(n, e) for e in ((1, 0, 0), (0, 1, 0))) if r != ZERO)
    for r in (some, cross(n, some)):
        rays.add(primitive(r))
        rays.add(primitive(scale(-1, r)))
    turned = sorted_by_angle(list(rays), n)
    inside = []
    for r, s in zip(turned, turned[1:] + turned[:1]):
        x = add(r, s)  # less than half a turn between the two: some and its quarter turns are there
        if all(dot(m, x) < 0 for m in own if m != n):
            inside.append(x)
    return inside


def sorted_by_angle(rays: List[Vector], n: Vector) -> List[Vector]:
    """Counter-clockwise about n, all in the plane orthogonal to n."""
    from functools import cmp_to_key

    first = rays[0]

    def half(r: Vector) -> int:
        side = dot(n, cross(first, r))
        return 0 if side > 0 or (side == 0 and dot(first, r) > 0) else 1

    def compare(r: Vector, s: Vector) -> int:
        if half(r) != half(s):
            return half(r) - half(s)
        side = dot(n, cross(r, s))
        return -1 if side > 0 else (1 if side < 0 else 0)

    return sorted(rays, key=cmp_to_key(compare))


def directions(pairs: Sequence[Sequence[Vector]], approaching: Sequence[bool]) -> List[Vector]:
    """The directions that count, of all touching pairs of parts with their tight normals (I-13)."""
    everything, kept = [], []
    for i, own in enumerate(pairs):
        if not approaching[i]:
            continue
        others = [normals for j, normals in enumerate(pairs) if j != i]
        for n in own:
            everything.append(n)
            if not covered(own, n, others):
                kept.append(n)
    return kept or everything


def reflect(normals: Sequence[Vector], w: Vector) -> Vector:
    """Rule Response: w + 2 proj(-w), the relative velocity after the collision."""
    return add(w, scale(2, project(normals, scale(-1, w))))
