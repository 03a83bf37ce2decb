"""Convex solids that turn, exactly: mass, places at an instant, separating axes. Nothing here is shared with scc.

Floats only choose which axis to try first; whether it separates is decided over integers.
"""

from fractions import Fraction as F
from math import gcd, sqrt

ZERO = (F(0), F(0), F(0))


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(k, a):
    return (k * a[0], k * a[1], k * a[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def apply(m, v):
    return (dot(m[0], v), dot(m[1], v), dot(m[2], v))


def determinant(m):
    return dot(m[0], cross(m[1], m[2]))


def solve(m, v):
    """x with m x = v, for a symmetric m (Cramer)."""
    d = determinant(m)
    return tuple(dot(v, cross(m[(i + 1) % 3], m[(i + 2) % 3])) / d for i in range(3))


# Quaternions (w, x, y, z) of integers, as scc prints them: no common factor, the first that is not 0 positive.

def canonical(q):
    g = 0
    for a in q:
        g = gcd(g, a)
    lead = next(a for a in q if a)
    g = -g if lead < 0 else g
    return tuple(a // g for a in q)


def times(p, q):
    w = p[0] * q[0] - dot(p[1:], q[1:])
    v = add(add(mul(p[0], q[1:]), mul(q[0], p[1:])), cross(p[1:], q[1:]))
    return (w,) + v


def inverse(q):
    return (q[0], -q[1], -q[2], -q[3])


def cayley(u):
    """1 + u, over integers."""
    d = 1
    for a in u:
        d = d * a.denominator // gcd(d, a.denominator)
    return canonical((d,) + tuple(int(a * d) for a in u))


def matrix(q):
    w, x, y, z = q
    n = w * w + x * x + y * y + z * z
    return ((F(w * w + x * x - y * y - z * z, n), F(2 * (x * y - w * z), n), F(2 * (x * z + w * y), n)),
            (F(2 * (x * y + w * z), n), F(w * w - x * x + y * y - z * z, n), F(2 * (y * z - w * x), n)),
            (F(2 * (x * z - w * y), n), F(2 * (y * z + w * x), n), F(w * w - x * x - y * y + z * z, n)))


class Solid:
    """A part of a body: corners by name (about the body's reference point), faces by name, mass (None: fixed)."""

    def __init__(self, corners, faces, mass):
        self.names = list(corners)
        self.corners = [tuple(map(F, corners[n])) for n in self.names]
        self.faces = [[self.names.index(n) for n in f] for f in faces.values()]
        self.face_names = {f: frozenset(ns) for f, ns in faces.items()}
        self.edges = sorted({tuple(sorted((f[i - 1], f[i]))) for f in self.faces for i in range(len(f))})
        self.mass = mass
        self.integrals()
        self.radius2 = max(dot(r, r) for r in (sub(c, self.centroid) for c in self.corners))

    def integrals(self):
        """Centroid, and the second moments about it for the given mass: sums of signed tetrahedra."""
        volume, first, second = F(0), ZERO, [[F(0)] * 3 for _ in range(3)]
        for f in self.faces:
            for i in range(1, len(f) - 1):
                vs = [self.corners[f[0]], self.corners[f[i]], self.corners[f[i + 1]]]
                six = determinant(vs)
                s = add(add(vs[0], vs[1]), vs[2])
                volume += six / 6
                first = add(first, mul(six / 24, s))
                for a in range(3):
                    for b in range(3):
                        second[a][b] += six / 120 * (sum(v[a] * v[b] for v in vs) + s[a] * s[b])
        c = mul(1 / volume, first)
        self.centroid = c
        density = (self.mass or F(1)) / volume
        self.moments = [[density * (second[a][b] - volume * c[a] * c[b]) for b in range(3)] for a in range(3)]


def inertia_of(moments):
    trace = moments[0][0] + moments[1][1] + moments[2][2]
    return tuple(tuple((trace if a == b else 0) - moments[a][b] for b in range(3)) for a in range(3))


class Placed:
    """A solid at an instant: corners are integers over one denominator."""

    def __init__(self, solid, turned, position):
        self.solid = solid
        m = matrix(turned)
        points = [add(position, apply(m, c)) for c in solid.corners]
        d = 1
        for p in points:
            for a in p:
                d = d * a.denominator // gcd(d, a.denominator)
        self.den = d
        self.points = points
        self.ints = [tuple(a.numerator * (d // a.denominator) for a in p) for p in points]
        self.floats = [tuple(a / d for a in p) for p in self.ints]
        self.centroid = add(position, apply(m, solid.centroid))
        self.axes = None

    def directions(self):
        """Normals of faces and directions of edges as pairs (integers, floats); parallel ones once."""
        if self.axes is None:
            edges, normals = [], []
            for i, j in self.solid.edges:
                self.note(edges, sub(self.ints[j], self.ints[i]))
            for f in self.solid.faces:
                p = self.ints[f[0]]
                self.note(normals, cross(sub(self.ints[f[1]], p), sub(self.ints[f[2]], p)))
            self.axes = normals, edges
        return self.axes

    @staticmethod
    def note(found, v):
        v = reduced(v)
        if all(cross(v, w) != (0, 0, 0) for w, _ in found):
            found.append((v, unit(v)))


def reduced(v):
    g = gcd(gcd(v[0], v[1]), v[2])
    return (v[0] // g, v[1] // g, v[2] // g)


def unit(v):
    shift = max(0, max(abs(a).bit_length() for a in v) - 900)
    f = [(a >> shift) * 1.0 for a in v]
    top = max(map(abs, f))
    f = [a / top for a in f]
    length = sqrt(dot(f, f))
    return tuple(a / length for a in f)


def gap(a, b, axis):
    """How far b is above a along an axis of integers, or a above b: (numerator, denominator, sign of the axis)."""
    low = [min(dot(axis, p) for p in s.ints) for s in (a, b)]
    high = [max(dot(axis, p) for p in s.ints) for s in (a, b)]
    above = low[1] * a.den - high[0] * b.den
    below = low[0] * b.den - high[1] * a.den
    return (above, a.den * b.den, 1) if above >= below else (below, a.den * b.den, -1)


def gap_float(a, b, u):
    pa = [u[0] * p[0] + u[1] * p[1] + u[2] * p[2] for p in a.floats]
    pb = [u[0] * p[0] + u[1] * p[1] + u[2] * p[2] for p in b.floats]
    return max(min(pb) - max(pa), min(pa) - max(pb))


def axes_of(a, b):
    """All axes that can separate, the most promising first: vectors, or pairs of edges that they are normal to."""
    na, ea = a.directions()
    nb, eb = b.directions()
    found = [(gap_float(a, b, u), v) for v, u in na + nb]
    for v, u in ea:
        for w, x in eb:
            c = cross(u, x)
            length = sqrt(dot(c, c))
            if length > 1e-9:
                found.append((gap_float(a, b, mul(1 / length, c)), (v, w)))
            elif cross(v, w) != (0, 0, 0):
                found.append((0.0, (v, w)))
    found.sort(key=lambda f: -f[0])
    return [v for _, v in found]


def direction(v):
    """Of an axis that is given as a vector or as two edges."""
    return v if isinstance(v[0], int) else reduced(cross(*v))


def interpenetrate(a, b):
    """Whether the interiors meet: no axis separates them."""
    apart = tuple(round(1024 * (p - q)) for p, q in zip(map(float, a.centroid), map(float, b.centroid)))
    if apart != (0, 0, 0) and gap(a, b, apart)[0] >= 0:
        return False
    return all(gap(a, b, direction(v))[0] < 0 for v in axes_of(a, b))


def widest(a, b):
    """The axis from a to b with the widest gap, and that gap squared (negative: they overlap on it).

    No distance is less than that; it is the distance where a face meets a vertex, or an edge an edge."""
    axis = direction(axes_of(a, b)[0])
    above, den, sign = gap(a, b, axis)
    return mul(sign, axis), F(above * abs(above), den * den * dot(axis, axis))
