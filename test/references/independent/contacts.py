"""Where two solids touch, what an elastic impulse does there, and how far a solid is from a line."""

from fractions import Fraction as F
from math import isqrt

import solids as s


def distance2_to_line(points, x, along):
    """Squared, from a convex solid to the line through x: in the plane across it, from a polygon to the origin."""
    u = s.cross(along, (F(1), F(0), F(0)) if along[1] or along[2] else (F(0), F(1), F(0)))
    v = s.cross(along, u)
    uu, vv = s.dot(u, u), s.dot(v, v)
    flat = [(s.dot(u, d), s.dot(v, d)) for d in (s.sub(p, x) for p in points)]
    least = None
    for i, a in enumerate(flat):
        for b in flat[:i]:
            d = (b[0] - a[0], b[1] - a[1])
            length2 = d[0] ** 2 / uu + d[1] ** 2 / vv
            t = 0 if length2 == 0 else min(F(1), max(F(0), -(a[0] * d[0] / uu + a[1] * d[1] / vv) / length2))
            e = (a[0] + t * d[0], a[1] + t * d[1])
            e = e[0] ** 2 / uu + e[1] ** 2 / vv
            least = e if least is None or e < least else least
    inside = not any(outside(flat, a, b) for i, a in enumerate(flat) for b in flat[:i] if a != b)
    return F(0) if inside else least


def outside(flat, a, b):
    """All points lie on one side of the line through a and b, and the origin strictly on the other."""
    n = (a[1] - b[1], b[0] - a[0])
    here = n[0] * a[0] + n[1] * a[1]
    sides = [n[0] * p[0] + n[1] * p[1] - here for p in flat]
    return (all(x >= 0 for x in sides) and here > 0) or (all(x <= 0 for x in sides) and here < 0)


def touching_point(axis, a, b, room):
    """The point of the witness plane where a corner meets a face or an edge an edge, or None if it is neither.

    The axis points from a to b. Corners within `room` of the extreme ones count as extreme."""
    room = room * (isqrt(s.dot(axis, axis)) + 1)
    heights = [[s.dot(axis, x) for x in o.points] for o in (a, b)]
    top, low = max(heights[0]), min(heights[1])
    above = [x for x, h in zip(a.points, heights[0]) if h >= top - room]
    below = [x for x, h in zip(b.points, heights[1]) if h <= low + room]
    middle = (top + low) / 2
    nn = s.dot(axis, axis)

    def on_plane(x):
        return s.add(x, s.mul((middle - s.dot(axis, x)) / nn, axis))
    if len(above) == 1 and len(below) >= 3:
        return on_plane(above[0]) if inside_polygon(axis, below, above[0]) else None
    if len(below) == 1 and len(above) >= 3:
        return on_plane(below[0]) if inside_polygon(axis, above, below[0]) else None
    if len(above) == 2 and len(below) == 2:
        d, e, c = s.sub(above[1], above[0]), s.sub(below[1], below[0]), s.sub(below[0], above[0])
        n = s.cross(d, e)
        if s.cross(n, axis) != s.ZERO:
            return None
        t = s.dot(s.cross(c, e), n) / s.dot(n, n)
        u = s.dot(s.cross(c, d), n) / s.dot(n, n)
        return on_plane(s.add(above[0], s.mul(t, d))) if 0 < t < 1 and 0 < u < 1 else None
    return None


def inside_polygon(axis, corners, x):
    """Strictly, along the axis: no line through two corners has all on one side and x on the other or on it."""
    for i, a in enumerate(corners):
        for b in corners[:i]:
            n = s.cross(axis, s.sub(b, a))
            sides = [s.dot(n, s.sub(c, a)) for c in corners]
            here = s.dot(n, s.sub(x, a))
            if (all(v >= 0 for v in sides) and here <= 0) or (all(v <= 0 for v in sides) and here >= 0):
                return False
    return True


def reflected(p, q, n, x):
    """An elastic impulse along n at x."""
    w = s.dot(n, s.sub(q.velocity_at(x), p.velocity_at(x)))
    if w >= 0:
        return None
    inverse, arms = F(0), []
    for o in (p, q):
        arm = None if o.fixed else s.cross(s.sub(x, o.centre()), n)
        arms.append(arm)
        if arm is not None:
            inverse += s.dot(n, n) / o.mass() + s.dot(arm, s.solve(o.inertia(), arm))
    impulse = -2 * w / inverse
    made = []
    for o, arm, sign in ((p, arms[0], -1), (q, arms[1], 1)):
        if arm is None:
            made.append(o)
        else:
            made.append(o.moved(o.leaves, s.add(o.velocity, s.mul(sign * impulse / o.mass(), n)),
                                s.add(o.spin, s.mul(sign * impulse, s.solve(o.inertia(), arm)))))
    return made
