"""Solids in floats, computed: uniform ones by their mirrors, snub ones by rotations, their duals, prisms, antiprisms,
pyramids, cupolas and what they make when put together.

solids() gives (name, vertices, faces); faces are tuples of vertices, counter-clockwise from outside.
"""

import itertools
import math
import random


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scale(k, a):
    return tuple(k * x for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scale(1 / math.sqrt(dot(a, a)), a)


# Hulls, by turning a plane about edges.


def faces_of(points):
    """The faces of the convex hull of points that all are corners of it, found in floats."""
    centre = scale(1 / len(points), tuple(map(sum, zip(*points))))
    size = max(math.dist(p, centre) for p in points)
    near = 1e-9 * size

    def around(normal, height):
        on = [i for i, p in enumerate(points) if dot(normal, p) > height - near]
        middle = scale(1 / len(on), tuple(map(sum, zip(*(points[i] for i in on)))))
        x = unit(sub(points[on[0]], middle))
        y = cross(normal, x)
        angle = lambda i: math.atan2(dot(sub(points[i], middle), y), dot(sub(points[i], middle), x))
        on.sort(key=angle)
        first = on.index(min(on))
        return tuple(on[first:] + on[:first])

    def beside(a, b, avoid):
        """The face that has the edge from a to b on its left side, the solid being behind it."""
        best = None
        for c in range(len(points)):
            if c in (a, b):
                continue
            normal = cross(sub(points[b], points[a]), sub(points[c], points[a]))
            if dot(normal, normal) < near * near * size * size:
                continue
            normal = unit(normal)
            height = dot(normal, points[a])
            if all(dot(normal, p) <= height + near for p in points):
                best = around(normal, height)
                break
        return best

    # the first face: some triple that has all points behind it
    first = None
    for a, b, c in itertools.combinations(range(len(points)), 3):
        normal = cross(sub(points[b], points[a]), sub(points[c], points[a]))
        if dot(normal, normal) < near * near * size * size:
            continue
        normal = unit(normal)
        side = [dot(normal, sub(p, points[a])) for p in points]
        if max(side) <= near or min(side) >= -near:
            normal = normal if max(side) <= near else scale(-1, normal)
            first = around(normal, dot(normal, points[a]))
            break
    found, open_ = {first}, [first]
    done = set()
    while open_:
        face = open_.pop()
        for a, b in zip(face, face[1:] + face[:1]):
            done.add((a, b))
            if (b, a) in done:
                continue
            other = beside(b, a, face)
            if other not in found:
                found.add(other)
                open_.append(other)
    return sorted(found)


# Uniform solids: orbits of a point under reflections.


def mirrors(p, q):
    """Three planes through the origin at angles pi/p, pi/q and pi/2."""
    c, d = math.cos(math.pi / p), math.cos(math.pi / q)
    m1 = (1.0, 0.0, 0.0)
    m2 = (-c, math.sin(math.pi / p), 0.0)
    y = -d / m2[1]
    return m1, m2, (0.0, y, math.sqrt(1 - y * y))


def reflect(m, v):
    return sub(v, scale(2 * dot(m, v), m))


def orbit(maps, seed):
    points, queue = [], [seed]
    while queue:
        v = queue.pop()
        if all(math.dist(v, w) > 1e-7 for w in points):
            points.append(v)
            queue += [f(v) for f in maps]
    return points


def solve(rows, right):
    """Cramer's rule, for three equations."""
    det = lambda a, b, c: dot(a, cross(b, c))
    columns = list(zip(*rows))
    d = det(*columns)
    return tuple(det(*(columns[:k] + [right] + columns[k + 1:])) / d for k in range(3))


def uniform(p, q, rings):
    ms = mirrors(p, q)
    seed = solve(ms, tuple(map(float, rings)))
    return orbit([lambda v, m=m: reflect(m, v) for m in ms], seed)


def snub(p, q):
    """The orbit under rotations of the point that has equal edges to its images under three of them."""
    a, b, c = mirrors(p, q)
    turn = lambda m, n: (lambda v: reflect(n, reflect(m, v)))
    rotations = [turn(a, b), turn(b, c), turn(c, a)]

    def misfit(x):
        v = unit(x)
        lengths = [math.dist(v, r(v)) for r in rotations]
        return (lengths[0] - lengths[1], lengths[1] - lengths[2], dot(x, x) - 1)

    x = unit(solve((a, b, c), (1.0, 1.0, 1.0)))
    for _ in range(60):
        f = misfit(x)
        h = 1e-7
        rows = list(zip(*[tuple((g - w) / h for g, w in zip(misfit(add(x, scale(h, e))), f))
                          for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]))
        x = sub(x, solve(rows, f))
    return orbit(rotations, unit(x))


# Prisms and what is made of regular polygons, with edges of length 1.


def ring(n, z, turn=0.0, radius=None):
    r = radius or 0.5 / math.sin(math.pi / n)
    return [(r * math.cos(2 * math.pi * (k + turn) / n), r * math.sin(2 * math.pi * (k + turn) / n), z) for k in range(n)]


def radius(n):
    return 0.5 / math.sin(math.pi / n)


def antiprism_height(n):
    gap = radius(n) * 2 * math.sin(math.pi / (2 * n))
    return math.sqrt(1 - gap * gap)


def pyramid_height(n):
    return math.sqrt(1 - radius(n) ** 2)


def cupola_height(n):
    inner, outer = 0.5 / math.tan(math.pi / n), 0.5 / math.tan(math.pi / (2 * n))
    return math.sqrt(1 - (outer - inner) ** 2)


def points_of_johnson_solids():
    for n in (3, 4, 5):
        apex = (0.0, 0.0, pyramid_height(n))
        yield "pyramid-%d" % n, ring(n, 0) + [apex]
        yield "elongated-pyramid-%d" % n, ring(n, 0) + ring(n, -1) + [apex]
        yield "bipyramid-%d" % n, ring(n, 0) + [apex, scale(-1, apex)]
        yield "elongated-bipyramid-%d" % n, ring(n, 0) + ring(n, -1) + [apex, add(scale(-1, apex), (0, 0, -1))]
        h = cupola_height(n)
        base, top = ring(2 * n, 0, 0.5), ring(n, h)
        yield "cupola-%d" % n, base + top
        yield "elongated-cupola-%d" % n, base + top + ring(2 * n, -1, 0.5)
        a = antiprism_height(2 * n)
        yield "gyroelongated-cupola-%d" % n, base + top + ring(2 * n, -a, 1.0)
        yield "orthobicupola-%d" % n, base + top + ring(n, -h)
        yield "gyrobicupola-%d" % n, base + top + ring(n, -h, 0.5)
        yield "elongated-gyrobicupola-%d" % n, base + top + ring(2 * n, -1, 0.5) + ring(n, -1 - h, 0.5)
        yield "gyroelongated-bicupola-%d" % n, base + top + ring(2 * n, -a, 1.0) + ring(n, -a - h, 0.5)
    for n in (4, 5):
        a, apex = antiprism_height(n), pyramid_height(n)
        yield "gyroelongated-pyramid-%d" % n, ring(n, 0) + ring(n, -a, 0.5) + [(0.0, 0.0, apex)]
    icosidodecahedron = uniform(5, 3, (0, 1, 0))
    axis = unit(tuple(map(sum, zip(*[icosidodecahedron[i] for i in next(
        f for f in faces_of(icosidodecahedron) if len(f) == 5)]))))
    yield "rotunda", [p for p in icosidodecahedron if dot(p, axis) > -1e-9]
    icosahedron = uniform(5, 3, (0, 0, 1))
    if len(icosahedron) != 12:
        icosahedron = uniform(5, 3, (1, 0, 0))
    yield "diminished-icosahedron", icosahedron[1:]


def dual(points, faces):
    """About the origin."""
    def plane(face):
        a, b, c = (points[i] for i in face[:3])
        n = cross(sub(b, a), sub(c, a))
        return scale(1 / dot(n, a), n)

    return [plane(f) for f in faces]


def solids():
    names = {(1, 0, 0): "100", (0, 1, 0): "010", (0, 0, 1): "001", (1, 1, 0): "110", (1, 0, 1): "101",
             (0, 1, 1): "011", (1, 1, 1): "111"}
    clouds = []
    for p, q in ((3, 3), (4, 3), (5, 3)):
        clouds += [("uniform-%d%d-%s" % (p, q, name), uniform(p, q, rings)) for rings, name in names.items()]
    clouds += [("snub-%d" % p, snub(p, 3)) for p in (4, 5)]
    made = [(name, points, faces_of(points)) for name, points in clouds]
    made += [("dual-" + name, dual(points, faces)) for name, points, faces in list(made)]
    made += list(points_of_johnson_solids())
    made += [("prism-%d" % n, ring(n, 0.0) + ring(n, 1.0)) for n in (3, 5, 6, 7, 8, 9, 10, 12, 20)]
    made += [("antiprism-%d" % n, ring(n, 0.0) + ring(n, antiprism_height(n), 0.5)) for n in (4, 5, 6, 7, 8, 10, 12)]
    for solid in made:
        yield solid if len(solid) == 3 else (solid[0], solid[1], faces_of(solid[1]))


# What people do to them.


def turned(name, points):
    """At random, by a turn that follows from the name."""
    draw = random.Random(name)
    w, x, y, z = (draw.gauss(0, 1) for _ in range(4))
    n = w * w + x * x + y * y + z * z
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return [tuple(dot(row, p) / n for row in rows) for p in points]


def off(points, faces, digits):
    """As an OFF file, with so many decimals."""
    lines = ["OFF", "%d %d 0" % (len(points), len(faces))]
    lines += [" ".join("%.*f" % (digits, x) for x in p) for p in points]
    lines += [" ".join(map(str, (len(f),) + tuple(f))) for f in faces]
    return "\n".join(lines) + "\n"
