"""Solids to ask about, and offsets at which two of them are in every kind of contact."""

from fractions import Fraction as F
import random

from geometry import ZERO, Solid, add, axes, dot, hull, mean, reach, scale, sub
from turning import apply, rotation

QUATERNIONS = [(1, 0, 0, 1), (1, 1, 1, 1), (2, 1, 0, 0), (3, 0, 1, 0), (1, 2, -1, 1), (4, 1, 2, -2)]


def cube(half=1):
    h = F(half)
    corners = dict(a=(-h, -h, -h), b=(h, -h, -h), c=(h, h, -h), d=(-h, h, -h),
                   e=(-h, -h, h), f=(h, -h, h), g=(h, h, h), h=(-h, h, h))
    return Solid(corners, dict(bottom='adcb', top='efgh', left='aehd', right='bcgf', front='abfe', back='dhgc'))


def box(x, y, z):
    return cube().image(lambda v: (v[0] * x, v[1] * y, v[2] * z))


def of_points(points):
    """The convex hull, with names v0... and f0..., from a corner that comes first in each face."""
    points = [tuple(F(a) for a in p) for p in points]
    facets = hull(points)
    used = sorted({v for f in facets for v in f})
    names = {v: 'v%d' % i for i, v in enumerate(used)}
    faces = sorted(min(tuple(used.index(v) for v in f[i:] + f[:i]) for i in range(len(f))) for f in facets)
    return Solid({names[v]: points[v] for v in used},
                 {'f%d' % i: tuple('v%d' % v for v in f) for i, f in enumerate(faces)})


def tetrahedron():
    return of_points([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)])


def octahedron():
    return of_points([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)])


def pyramid():
    return of_points([(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0), (0, 0, 2)])


def wedge():
    return of_points([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (-1, 0, 1), (1, 0, 1)])


def prism():
    ring = [(2, 0), (1, 2), (-1, 2), (-2, 0), (-1, -2), (1, -2)]
    return of_points([(x, y, z) for z in (-1, 1) for x, y in ring])


def random_hull(rng, count=7, size=3):
    while True:
        points = {tuple(rng.randint(-size, size) for _ in range(3)) for _ in range(count)}
        if len(points) > 4 and hull([tuple(F(a) for a in p) for p in sorted(points)]):
            return of_points(sorted(points))


def turned(solid, q):
    matrix = rotation(q)
    return solid.image(lambda v: apply(matrix, v))


def named():
    return {'cube': cube(), 'plank': box(2, F(1, 2), 1), 'tetrahedron': tetrahedron(), 'octahedron': octahedron(),
            'pyramid': pyramid(), 'wedge': wedge(), 'prism': prism()}


def support(solid, n):
    """The vertices farthest along n."""
    most = reach(solid, n)
    return [p for p in solid.points if dot(n, p) == most]


def weighted(rng, points):
    """A vertex, the middle, or some point between."""
    if rng.random() < 0.4:
        return rng.choice(points)
    if rng.random() < 0.5:
        return mean(points)
    weights = [F(rng.randint(0, 3)) for _ in points]
    whole = sum(weights)
    if whole == 0:
        return mean(points)
    at = ZERO
    for w, p in zip(weights, points):
        at = add(at, scale(w / whole, p))
    return at


def touching_offset(rng, a, b):
    """An offset on the surface of the obstacle of A and B, where often several features meet."""
    n = rng.choice(sorted(axes(a, b))) if rng.random() < 0.8 else tuple(rng.randint(-3, 3) for _ in range(3))
    if n == (0, 0, 0):
        n = (1, 0, 0)
    p, q = weighted(rng, support(a, n)), weighted(rng, support(b, scale(-1, n)))
    return sub(p, q), n


def some_vector(rng, size=3, halves=True):
    return tuple(F(rng.randint(-2 * size, 2 * size), 2) if halves else F(rng.randint(-size, size)) for _ in range(3))


def seeded(name):
    return random.Random('conformance ' + name)
