"""Contact within resolution (rule Near), by trying all pairs of features."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, List, Optional, Sequence, Tuple

import contact
from solids import Feature, Solid
from vectors import ZERO, Vector, add, cross, dot, primitive, scale, solve, sub

Pairs = List[Tuple[Feature, Feature, int]]


class Contact:
    """What two parts in contact have: normals from the first to the second, pairs, corners."""

    def __init__(
        self, gap: Vector, normals: List[Vector], pairs: Pairs, region: List[Vector]
    ) -> None:
        self.gap, self.normals, self.pairs, self.region = gap, normals, pairs, region
        self.plane: Optional[Tuple[Vector, Fraction]] = None


def shortest(a: Solid, b: Solid) -> Tuple[Vector, Vector]:
    """Where the shortest vector from one to the other begins and ends; they do not interpenetrate.

    It joins a vertex or edge of one with a feature of the other, orthogonal to both, and its ends
    are in both: all are tried whose boxes are near enough.
    """
    boxes_a = [(f, box(a.points(f))) for f in a.features()]
    boxes_b = [(g, box(b.points(g))) for g in b.features()]
    pairs = [
        (gap2(x, y), i, j, f, g)
        for i, (f, x) in enumerate(boxes_a)
        for j, (g, y) in enumerate(boxes_b)
        if DIMENSION[f[0]] + DIMENSION[g[0]] <= 2
    ]
    best: Optional[Tuple[Fraction, Vector, Vector]] = None
    for least, _, _, f, g in sorted(pairs):
        if best is not None and least >= best[0]:
            break
        ends = between(a, f, b, g)
        if ends is not None:
            d = sub(ends[1], ends[0])
            if best is None or dot(d, d) < best[0]:
                best = (dot(d, d), ends[0], ends[1])
    assert best is not None
    return best[1], best[2]


DIMENSION = {"vertex": 0, "edge": 1, "face": 2}


def box(points: Sequence[Vector]) -> List[Tuple[Fraction, Fraction]]:
    """The least box along the axes that holds some points."""
    return [(min(p[i] for p in points), max(p[i] for p in points)) for i in range(3)]


def gap2(a: Sequence[Tuple[Fraction, Fraction]], b: Sequence[Tuple[Fraction, Fraction]]) -> Any:
    """The squared distance of two boxes."""
    gaps = [max(low - top, floor - high, 0) for (low, high), (floor, top) in zip(a, b)]
    return sum(gap * gap for gap in gaps)


def between(a: Solid, f: Feature, b: Solid, g: Feature) -> Optional[Tuple[Vector, Vector]]:
    """The ends of the vector orthogonal to two features, if they are in these."""
    ps, qs = a.points(f), b.points(g)
    spans_p = [sub(p, ps[0]) for p in (ps[1:2] if f[0] == "edge" else ps[1:3])]
    spans_q = [sub(q, qs[0]) for q in (qs[1:2] if g[0] == "edge" else qs[1:3])]
    spans = spans_p + [scale(-1, q) for q in spans_q]
    d0 = sub(qs[0], ps[0])
    p, q = ps[0], qs[0]
    if spans:
        weights = solve([[dot(u, w) for w in spans] for u in spans], [dot(u, d0) for u in spans])
        if weights is None:
            return None  # parallel: other pairs have this distance too
        for k, u in zip(weights, spans_p):
            p = add(p, scale(k, u))
        for k, u in zip(weights[len(spans_p) :], spans_q):
            q = add(q, scale(k, u))
    return (p, q) if inside(p, ps) and inside(q, qs) else None


def inside(p: Vector, corners: Sequence[Vector]) -> bool:
    """Whether a point of the plane (or line) of a feature is in the feature."""
    if len(corners) == 1:
        return p == corners[0]
    if len(corners) == 2:
        u = sub(corners[1], corners[0])
        d = sub(p, corners[0])
        return cross(u, d) == ZERO and 0 <= dot(u, d) <= dot(u, u)
    n = cross(sub(corners[1], corners[0]), sub(corners[2], corners[1]))
    for u, w in zip(corners, list(corners[1:]) + [corners[0]]):
        if dot(n, cross(sub(w, u), sub(p, u))) < 0:
            return False
    return True


def touching(a: Solid, b: Solid) -> Contact:
    """Of two solids that touch: rules Touching and Highest; the region lies in the highest pair."""
    pairs = contact.touching_pairs(a, b, ZERO)
    normals = contact.tight(a, b, ZERO)
    most = max(d for _, _, d in pairs)
    highest = [(f, g) for f, g, d in pairs if d == most]
    f, g = next(
        (f, g) for f, g in highest
        if all(x in a.closure(frozenset([f])) and y in b.closure(frozenset([g]))
               for x, y, _ in pairs)
    )  # fmt: skip
    region = common(a.points(f), b.points(g), normals[0])
    return Contact(ZERO, normals, pairs, region)


def find(a: Solid, b: Solid, resolution: Fraction) -> Optional[Contact]:
    """The contact of two parts that do not interpenetrate; None if they are farther apart."""
    p, q = shortest(a, b)
    d = sub(q, p)
    if dot(d, d) > resolution * resolution:
        return None
    if d == ZERO:
        return touching(a, b)
    middle = dot(d, add(p, q)) / 2
    f = contact_feature(a, d, middle, resolution, -1)
    g = contact_feature(b, d, middle, resolution, 1)
    pairs: Pairs = []
    for x in features_in(a, f):
        for y in features_in(b, g):
            ps = [projected(r, d, middle) for r in a.points(x)]
            qs = [projected(r, d, middle) for r in b.points(y)]
            if contact.touch(ps, qs):
                pairs.append((x, y, contact.dimension(ps, qs)))
    ps = [projected(r, d, middle) for r in a.points(f)]
    qs = [projected(r, d, middle) for r in b.points(g)]
    normal = primitive(d)
    assert normal is not None
    found = Contact(d, [normal], pairs, common(ps, qs, d))
    found.plane = (normal, dot(normal, scale(Fraction(1, 2), add(p, q))))
    return found


def features_in(solid: Solid, f: Feature) -> List[Feature]:
    return sorted(solid.closure(frozenset([f])))


def projected(r: Vector, n: Vector, height: Fraction) -> Vector:
    """Orthogonally onto the plane n.x = height."""
    return add(r, scale((height - dot(n, r)) / dot(n, n), n))


def contact_feature(
    solid: Solid, n: Vector, height: Fraction, resolution: Fraction, side: int
) -> Feature:
    """The smallest feature that holds all vertices within the resolution of the plane."""

    def holding(corners: set) -> List[Feature]:
        return [f for f in solid.features() if corners <= set(f[1])]

    limit = resolution * resolution * dot(n, n)
    near = {v for v, p in solid.place.items() if (dot(n, p) - height) ** 2 <= limit}
    found = holding(near)
    if not found:  # the one nearest to the plane
        least = min(side * dot(n, p) for p in solid.place.values())
        near = {v for v, p in solid.place.items() if side * dot(n, p) == least}
        found = holding(near)
    return min(found, key=lambda f: len(f[1]))


def common(ps: List[Vector], qs: List[Vector], n: Vector) -> List[Vector]:
    """The corners of the intersection of two convex polygons, segments or points of one plane."""
    found = set()
    for p in ps:
        if inside_flat(p, qs, n):
            found.add(p)
    for q in qs:
        if inside_flat(q, ps, n):
            found.add(q)
    for a, b in sides(ps):
        for c, d in sides(qs):
            x = crossing(a, b, c, d, n)
            if x is not None:
                found.add(x)
    return extreme(list(found), n)


def sides(ps: List[Vector]) -> List[Tuple[Vector, Vector]]:
    if len(ps) == 1:
        return []
    if len(ps) == 2:
        return [(ps[0], ps[1])]
    return list(zip(ps, ps[1:] + ps[:1]))


def inside_flat(p: Vector, corners: List[Vector], n: Vector) -> bool:
    if len(corners) <= 2:
        return inside(p, corners)
    turns = [dot(n, cross(sub(w, u), sub(p, u))) for u, w in sides(corners)]
    return all(t >= 0 for t in turns) or all(t <= 0 for t in turns)


def crossing(a: Vector, b: Vector, c: Vector, d: Vector, n: Vector) -> Optional[Vector]:
    u, w = sub(b, a), sub(d, c)
    below = dot(n, cross(u, w))
    if below == 0:
        return None
    k = Fraction(dot(n, cross(sub(c, a), w))) / below
    m = Fraction(dot(n, cross(sub(c, a), u))) / below
    return add(a, scale(k, u)) if 0 <= k <= 1 and 0 <= m <= 1 else None


def extreme(points: List[Vector], n: Vector) -> List[Vector]:
    """The corners of the convex hull of points of a plane: those in no hull of the others."""
    found = []
    for p in points:
        others = [sub(q, p) for q in points if q != p]
        if not others:
            return [p]
        if not any(zero_in_segment(u, w) for u in others for w in others) and not any(
            zero_in_triangle(u, w, x, n) for u in others for w in others for x in others
        ):
            found.append(p)
    return found


def zero_in_segment(u: Vector, w: Vector) -> bool:
    return cross(u, w) == ZERO and dot(u, w) < 0


def zero_in_triangle(u: Vector, w: Vector, x: Vector, n: Vector) -> bool:
    return all(dot(n, cross(y, z)) > 0 for y, z in ((u, w), (w, x), (x, u)))
