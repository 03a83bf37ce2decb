"""Rule Near, naively: the shortest vector between two solids, and what touches when it is closed."""

from fractions import Fraction as F
from itertools import product

from geometry import (ZERO, add, cross, dimension, dot, inside, mean, newell, primitive, relation, scale, slabs, sub,
                      boxes_meet, crossing)


class Unknown(Exception):
    """No single feature holds what is near the plane."""


def foot(point, corners):
    """The point of a feature's line or plane that is nearest to a point."""
    if len(corners) == 1:
        return corners[0]
    if len(corners) == 2:
        d = sub(corners[1], corners[0])
        return add(corners[0], scale(dot(sub(point, corners[0]), d) / dot(d, d), d))
    n = newell(corners)
    return sub(point, scale(dot(sub(point, corners[0]), n) / dot(n, n), n))


def between(f, g):
    """The shortest vector from the inside of one feature to that of another, if it is orthogonal to both."""
    if len(f) == 1:
        at = foot(f[0], g)
        return sub(at, f[0]) if inside(at, g) else None
    if len(g) == 1:
        at = foot(g[0], f)
        return sub(g[0], at) if inside(at, f) else None
    if len(f) == 2 and len(g) == 2:
        d, e = sub(f[1], f[0]), sub(g[1], g[0])
        n = cross(d, e)
        if primitive(n) is None:
            return None  # then an end of one is as near
        r = sub(g[0], f[0])
        s, t = dot(cross(r, e), n) / dot(n, n), dot(cross(r, d), n) / dot(n, n)
        return sub(add(g[0], scale(t, e)), add(f[0], scale(s, d))) if 0 < s < 1 and 0 < t < 1 else None
    return None  # a vertex or an edge pair is as near


def shortest(a, b):
    """From A to B, which do not touch."""
    found = [between(a.corners(f), b.corners(g)) for f, g in product(a.features(), b.features())]
    return min((d for d in found if d is not None), key=lambda d: dot(d, d))


def contact_feature(solid, normal, height, resolution):
    """The smallest feature that holds all vertices within the resolution of the plane."""
    near = {v for v, p in solid.vertices.items()
            if (dot(normal, p) - height) ** 2 <= resolution ** 2 * dot(normal, normal)}
    holding = [f for f in solid.features() if near <= f]
    if not near or not holding:
        raise Unknown()
    return min(holding, key=len)


def near(a, b, offset, resolution):
    """None if they are farther apart than the resolution; else (gap, plane, region, pairs, highest)."""
    b = b.moved(offset)
    gap = shortest(a, b)
    if dot(gap, gap) > resolution ** 2:
        return None
    normal = tuple(F(k) for k in primitive(gap))
    height = (max(dot(normal, p) for p in a.points) + min(dot(normal, p) for p in b.points)) / 2
    f, g = (contact_feature(x, normal, height, resolution) for x in (a, b))

    def flat(solid, feature):
        return [sub(p, scale((dot(normal, p) - height) / dot(normal, normal), normal)) for p in solid.corners(feature)]
    mine = {x: flat(a, x) for x in a.features() if x <= f}
    other = {x: flat(b, x) for x in b.features() if x <= g}
    corners = []
    for x, y in product(mine, other):
        if boxes_meet(mine[x], other[y]):
            at = crossing(mine[x], other[y])
            if at is not None and inside(at, mine[x]) and inside(at, other[y]):
                corners.append((x, y, at))
    pairs = {}
    for x, y in product(mine, other):
        points = {at for m, n, at in corners if m <= x and n <= y}
        if points:
            middle = mean(list(points))
            if inside(middle, mine[x]) and inside(middle, other[y]):
                pairs[x, y] = dimension(points)
    region = {at for _, _, at in corners}
    middle = mean(list(region))
    (best,) = [(x, y) for x, y in pairs if inside(middle, mine[x]) and inside(middle, other[y])]
    return gap, (normal, height), region, pairs, best
