"""The geometry of the rule book, computed naively and exactly from its definitions, with fractions.

Nothing here is clever, and nothing is shared with the interpreter: a solid is accepted when its faces are those of
the convex hull of its vertices, found by trying all triples; two bodies are compared along every axis that may
separate them; features touch if the point in the middle of what they share lies inside both; a response tries
every set of directions that may act.

Definitions 4.1 to 4.5 and rules Mass, Contact, Touching, Highest, Approach, Ftoc and Response.
"""

from fractions import Fraction as F
from functools import lru_cache
from itertools import combinations, product
from math import gcd, lcm

ZERO = (F(0), F(0), F(0))


def add(u, v):
    return tuple(a + b for a, b in zip(u, v))


def sub(u, v):
    return tuple(a - b for a, b in zip(u, v))


def scale(k, u):
    return tuple(k * a for a in u)


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def det(u, v, w):
    return dot(u, cross(v, w))


def mean(points):
    return scale(F(1, len(points)), tuple(sum(c) for c in zip(*points)))


def primitive(v):
    """The integer vector without a common factor that has the direction of v; None for zero."""
    v = [F(a) for a in v]
    common = 1
    for a in v:
        common = common * a.denominator // gcd(common, a.denominator)
    ints = [int(a * common) for a in v]
    factor = gcd(gcd(abs(ints[0]), abs(ints[1])), abs(ints[2]))
    return tuple(a // factor for a in ints) if factor else None


# Definition 4.1, Definition 4.2 ---------------------------------------------------------


def rotations(face):
    return {tuple(face[i:]) + tuple(face[:i]) for i in range(len(face))}


def rotation_equivalent(face, other):
    return tuple(other) in rotations(tuple(face))


def closure(faces, features):
    """Features as frozensets of vertices: a face by its corners."""
    tuples = {frozenset(f): f for f in faces}
    found, todo = set(), list(features)
    while todo:
        f = todo.pop()
        if f in found:
            continue
        found.add(f)
        if f in tuples:
            corners = tuples[f]
            todo += [frozenset((corners[i - 1], corners[i])) for i in range(len(corners))]
        elif len(f) == 2:
            todo += [frozenset((v,)) for v in f]
    return found


# Definition 4.3 -------------------------------------------------------------------------


def whole(points):
    """The same, so many times as large that coordinates are integers."""
    k = lcm(*(F(a).denominator for p in points for a in p))
    return [tuple(int(a * k) for a in p) for p in points]


def hull(points):
    """The facets of the convex hull of distinct points, as tuples of indices, counter-clockwise seen from outside,
    of extreme points alone. None if all points lie in one plane."""
    points = whole(points)
    found = {}
    n = len(points)
    for i, j, k in combinations(range(n), 3):
        if any({i, j, k} <= f for f in found):
            continue
        normal = cross(sub(points[j], points[i]), sub(points[k], points[i]))
        if normal == ZERO or normal == (0, 0, 0):
            continue
        heights = [dot(normal, sub(p, points[i])) for p in points]
        for sign in (1, -1):
            if all(sign * h <= 0 for h in heights):
                on = frozenset(m for m in range(n) if heights[m] == 0)
                if len(on) == n:
                    return None
                found[on] = scale(sign, normal)
    return [around(points, on, normal) for on, normal in found.items()] or None


def around(points, indices, normal):
    """The extreme ones of points of a plane, counter-clockwise seen against the normal: wrapped one by one."""
    start = min(indices, key=lambda m: points[m])
    order = [start]
    while True:
        here = order[-1]
        best = None
        for m in indices:
            if points[m] == points[here]:
                continue
            if best is None:
                best = m
                continue
            turn = det(sub(points[best], points[here]), sub(points[m], points[here]), normal)
            far = dot(sub(points[m], points[here]), sub(points[m], points[here]))
            best_far = dot(sub(points[best], points[here]), sub(points[best], points[here]))
            if turn < 0 or (turn == 0 and far > best_far):
                best = m
        if best == start:
            return tuple(order)
        order.append(best)


def accepted(vertices, faces):
    """Definition 4.3 as E0 to E5 read it (I-2): the faces are the facets of a solid, each listed once."""
    n = len(vertices)
    if not faces or any(v not in range(n) for f in faces for v in f) or len(set(vertices)) < n or n < 4:
        return False
    facets = hull(vertices)
    if facets is None or len(facets) != len(faces):
        return False
    left = [rotations(f) for f in facets]
    for face in faces:
        same = [r for r in left if tuple(face) in r]
        if not same:
            return False
        left.remove(same[0])
    return set(range(n)) == {v for f in faces for v in f}


def printed_conditions(vertices, faces):
    """The numbers of the printed conditions of Definition 4.3 that fail, in the readings I-1 and I-2."""
    n = len(vertices)
    vertices = whole(vertices)
    failed = set()
    if n < 4 or len(faces) < 4:
        failed.add(1)
    own = [tuple(f) for f in faces if all(v in range(n) for v in f)]
    if len(own) < len(faces):
        failed.add(2)
    if all(primitive(cross(sub(q, p), sub(r, p))) is None for p, q, r in combinations(vertices, 3)):
        failed.add(3)
    if not all(is_convex_polygon([vertices[v] for v in f]) for f in own):
        failed.add(4)
    if any(rotation_equivalent(f, g) for f, g in combinations(own, 2)):
        failed.add(5)
    edges = {}
    for number, f in enumerate(own):
        for i in range(len(f)):
            edges.setdefault(frozenset((f[i - 1], f[i])), []).append((number, f[i - 1], f[i]))
    if angle_fails(vertices, own, edges):
        failed.add(6)
    if n - len(edges) + len(faces) != 2:
        failed.add(7)
    return failed


def newell(corners):
    """Twice the area of the polygon, as a vector."""
    total = ZERO
    for i in range(len(corners)):
        total = add(total, cross(sub(corners[i - 1], corners[0]), sub(corners[i], corners[0])))
    return total


def is_convex_polygon(corners):
    """Planar, simple, strictly convex: every other corner lies strictly to the left of every side."""
    if len(corners) < 3:
        return False
    normal = newell(corners)
    if primitive(normal) is None or any(dot(normal, sub(c, corners[0])) != 0 for c in corners):
        return False
    for i in range(len(corners)):
        a, b = corners[i - 1], corners[i]
        others = [corners[j] for j in range(len(corners)) if j != i and j != (i - 1) % len(corners)]
        if any(det(sub(b, a), sub(c, a), normal) <= 0 for c in others):
            return False
    return True


def angle_fails(vertices, faces, edges):
    """Condition 6, on the side of the surface on which fewer edges fail."""
    normals = [newell([vertices[v] for v in f]) if len(f) > 2 else ZERO for f in faces]
    behind, front = 0, 0
    for uses in edges.values():
        if len(uses) != 2 or uses[0][0] == uses[1][0]:
            if len(uses) == 2:
                behind, front = behind + 1, front + 1
            continue
        sides = []
        for (f, _, _), (g, v, w) in ((uses[0], uses[1]), (uses[1], uses[0])):
            inward = cross(normals[g], sub(vertices[w], vertices[v]))
            s = dot(normals[f], inward)
            sides.append((s > 0) - (s < 0))
        if sides == [0, 0] and dot(normals[uses[0][0]], normals[uses[1][0]]) < 0:
            same_way = uses[0][1:] == uses[1][1:]
            behind, front = behind + same_way, front + same_way
        else:
            behind += sides != [-1, -1]
            front += sides != [1, 1]
    return min(behind, front) > 0


# Solids ---------------------------------------------------------------------------------


class Solid:
    """A convex solid: vertices by name, and faces as tuples of these names, by name."""

    def __init__(self, vertices, faces):
        self.vertices = {n: tuple(F(a) for a in v) for n, v in vertices.items()}
        self.faces = {n: tuple(f) for n, f in faces.items()}
        self.points = list(self.vertices.values())
        self.edges = {frozenset((f[i - 1], f[i])) for f in self.faces.values() for i in range(len(f))}
        self.names = {frozenset(f): n for n, f in self.faces.items()}

    def features(self):
        """Every feature, as the frozenset of its corners."""
        return ([frozenset((v,)) for v in self.vertices] + sorted(self.edges, key=sorted)
                + [frozenset(f) for f in self.faces.values()])

    def corners(self, feature):
        """In order around a face."""
        name = self.names.get(feature)
        return [self.vertices[v] for v in (self.faces[name] if name else sorted(feature))]

    def times(self, k):
        """With integers for coordinates: k times as large."""
        other = Solid({}, self.faces)
        other.vertices = {n: tuple(int(a * k) for a in v) for n, v in self.vertices.items()}
        other.points = list(other.vertices.values())
        return other

    def denominator(self):
        return lcm(*(a.denominator for p in self.points for a in p))

    def moved(self, offset):
        return self.image(lambda v: add(v, offset))

    def image(self, f):
        return Solid({n: f(v) for n, v in self.vertices.items()}, self.faces)

    def face_normals(self):
        return {primitive(newell(self.corners(frozenset(f)))) for f in self.faces.values()}

    def edge_directions(self):
        found = set()
        for e in self.edges:
            v, w = self.corners(e)
            direction = primitive(sub(w, v))
            found.add(max(direction, scale(-1, direction)))
        return found


def feature_of(solid, text):
    """A feature from its name: a face, a vertex, or an edge [v,w]."""
    if text.startswith('['):
        return frozenset(v.strip() for v in text[1:-1].split(','))
    return frozenset(solid.faces[text]) if text in solid.faces else frozenset((text,))


def name_of(solid, feature):
    if feature in solid.names:
        return solid.names[feature]
    return '[%s]' % ','.join(sorted(feature)) if len(feature) == 2 else next(iter(feature))


def mass_properties(solid):
    """Volume, centroid and inertia about the centroid for density 1: cut into tetrahedra about a point inside."""
    middle = mean(solid.points)
    volume, first = F(0), ZERO
    second = [[F(0)] * 3 for _ in range(3)]
    for face in solid.faces.values():
        corners = [solid.vertices[v] for v in face]
        for i in range(1, len(corners) - 1):
            tetrahedron = [middle, corners[0], corners[i], corners[i + 1]]
            v = det(*[sub(p, middle) for p in tetrahedron[1:]]) / 6
            volume += v
            first = add(first, scale(v, mean(tetrahedron)))
            total = tuple(sum(c) for c in zip(*tetrahedron))
            for a, b in product(range(3), repeat=2):
                second[a][b] += v / 20 * (sum(p[a] * p[b] for p in tetrahedron) + total[a] * total[b])
    centroid = scale(1 / volume, first)
    for a, b in product(range(3), repeat=2):
        second[a][b] -= volume * centroid[a] * centroid[b]
    trace = sum(second[a][a] for a in range(3))
    inertia = tuple(tuple((trace if a == b else 0) - second[a][b] for b in range(3)) for a in range(3))
    return volume, centroid, inertia


# Contact, Ftoc, Approach ----------------------------------------------------------------


def axes(a, b):
    """All directions that may separate the two, each with its opposite."""
    found = a.face_normals() | b.face_normals()
    for d, e in product(a.edge_directions(), b.edge_directions()):
        n = primitive(cross(d, e))
        if n is not None:
            found.add(n)
    return found | {scale(-1, n) for n in found}


def reach(solid, n):
    return max(dot(n, p) for p in solid.points)


@lru_cache(maxsize=256)
def slabs(a, b):
    """(n, h): the interiors of A, and of B moved by r, can meet only if n.r < h; together they say when."""
    return [(n, reach(a, n) + reach(b, scale(-1, n))) for n in sorted(axes(a, b))]


def relation(a, b, offset):
    room = min(h - dot(n, offset) for n, h in slabs(a, b))
    return 'apart' if room < 0 else 'touching' if room == 0 else 'interpenetrating'


def first_time_of_contact(a, b, offset, velocity):
    """'never', 'inside', or a time: the interiors meet on an open interval of time, one bound from each axis."""
    start, end = None, None
    for n, h in slabs(a, b):
        speed, room = dot(n, velocity), h - dot(n, offset)
        if speed == 0:
            if room <= 0:
                return 'never'
        elif speed > 0:
            end = room / speed if end is None else min(end, room / speed)
        else:
            start = room / speed if start is None else max(start, room / speed)
    if start is None:
        return 'inside'
    if start >= end or end <= 0:
        return 'never'
    return 'inside' if start < 0 else start


def approaching(a, b, offset, velocity):
    return relation(a, b, offset) == 'touching' and first_time_of_contact(a, b, offset, velocity) == 0


# Touching, Highest ----------------------------------------------------------------------


def inside(point, corners):
    """Is the point in the relative interior of the feature?"""
    if len(corners) == 1:
        return point == corners[0]
    if len(corners) == 2:
        u, v = corners
        along = sub(v, u)
        t = dot(sub(point, u), along)
        return primitive(cross(along, sub(point, u))) is None and 0 < t < dot(along, along)
    normal = newell(corners)
    # Of a face, strictly to the left of each side.
    return dot(normal, sub(point, corners[0])) == 0 and all(
        det(sub(corners[i], corners[i - 1]), sub(point, corners[i - 1]), normal) > 0 for i in range(len(corners)))


def crossing(f, g):
    """The one point that the lines or planes of two features share; None if there is none, or more than one."""
    if len(f) > len(g):
        f, g = g, f
    if len(f) == 1:
        return f[0]
    if len(f) > 2:
        return None
    p, d = f[0], sub(f[1], f[0])
    if len(g) == 2:
        e = sub(g[1], g[0])
        normal = cross(d, e)
        if primitive(normal) is None or dot(normal, sub(g[0], p)) != 0:
            return None
        t = F(dot(cross(sub(g[0], p), e), normal)) / dot(normal, normal)
    else:
        normal = newell(g)
        if dot(normal, d) == 0:
            return None
        t = F(dot(normal, sub(g[0], p))) / dot(normal, d)
    return add(p, scale(t, d))


def boxes_meet(f, g):
    """Of two features, as lists of corners; to save time."""
    return not any(max(p[i] for p in f) < min(p[i] for p in g) or max(p[i] for p in g) < min(p[i] for p in f)
                   for i in range(3))


def dimension(points):
    points = list(points)
    if len(points) == 1:
        return 0
    d = sub(points[1], points[0])
    return 1 if all(primitive(cross(d, sub(p, points[0]))) is None for p in points) else 2


@lru_cache(maxsize=4)
def meeting(a, b, offset):
    """A, and B moved by the offset, k times as large and with integers for coordinates; k; and where a feature of A
    and one of B cross in one point that lies inside both: (feature, feature, point). These are the corners of what A
    and B share, and of what any two of their faces or edges share."""
    b = b.moved(offset)
    k = lcm(a.denominator(), b.denominator())
    a, b = a.times(k), b.times(k)
    found = []
    mine, other = ([(f, x.corners(f)) for f in x.features()] for x in (a, b))
    for (f, x), (g, y) in product(mine, other):
        if boxes_meet(x, y):
            at = crossing(x, y)
            if at is not None and inside(at, x) and inside(at, y):
                found.append((f, g, at))
    return a, b, k, found


def touching(a, b, offset):
    """Every pair of features whose relative interiors intersect (I-3), with the dimension of what they share."""
    a, b, _, corners = meeting(a, b, tuple(offset))
    found = {}
    for f, g in product(a.features(), b.features()):
        points = {at for x, y, at in corners if x <= f and y <= g}
        if points:
            middle = mean(list(points))
            if inside(middle, a.corners(f)) and inside(middle, b.corners(g)):
                found[f, g] = dimension(points)
    return found


def region(a, b, offset):
    """The corners of the common points of two touching bodies, about the reference point of A."""
    _, _, k, corners = meeting(a, b, tuple(offset))
    return {scale(F(1, k), at) for _, _, at in corners}


def highest(a, b, offset):
    """The pair of features that have the middle of the contact region inside (I-4)."""
    middle = mean(list(region(a, b, offset)))
    moved = b.moved(offset)
    (f,) = [f for f in a.features() if inside(middle, a.corners(f))]
    (g,) = [g for g in b.features() if inside(middle, moved.corners(g))]
    return f, g


# Response -------------------------------------------------------------------------------


def separating(a, b, offset):
    """The extreme directions that separate two touching bodies: those that no others make up."""
    cone = [n for n, h in slabs(a, b) if dot(n, offset) == h]
    return {n for n in cone if projection([m for m in cone if m != n], n) != n}


def projection(cone, v):
    """The point nearest to v of the cone that the directions span, by trying all sets that may act."""
    v = tuple(F(a) for a in v)
    cone = sorted(set(cone))
    for size in range(4):
        for act in combinations(cone, size):
            lengths = solve([[dot(m, n) for n in act] for m in act], [dot(m, v) for m in act])
            if lengths is None or any(k < 0 for k in lengths):
                continue
            at = ZERO
            for k, n in zip(lengths, act):
                at = add(at, scale(k, n))
            if all(dot(n, sub(v, at)) <= 0 for n in cone):
                return at
    raise AssertionError('no nearest point')


def solve(matrix, right):
    """The solution of a regular system; None if it is singular."""
    rows = [[F(a) for a in row] + [F(b)] for row, b in zip(matrix, right)]
    n = len(rows)
    for i in range(n):
        pivot = next((r for r in range(i, n) if rows[r][i] != 0), None)
        if pivot is None:
            return None
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [a / rows[i][i] for a in rows[i]]
        for r in range(n):
            if r != i and rows[r][i] != 0:
                rows[r] = [a - rows[r][i] * b for a, b in zip(rows[r], rows[i])]
    return [row[-1] for row in rows]


def share(change, mass_a, mass_b):
    """What a change of the relative velocity does to each; a mass of None is of a fixed body."""
    if mass_a is None:
        return ZERO, change
    if mass_b is None:
        return scale(-1, change), ZERO
    whole = mass_a + mass_b
    return scale(-mass_b / whole, change), scale(mass_a / whole, change)


def bounce(cone, mass_a, velocity_a, mass_b, velocity_b):
    """Rule Response, with the directions from A to B that span the cone."""
    w = sub(velocity_b, velocity_a)
    of_a, of_b = share(scale(2, projection(cone, scale(-1, w))), mass_a, mass_b)
    return add(velocity_a, of_a), add(velocity_b, of_b)


# Reading I-13, for boxes along the axes --------------------------------------------------


def box_directions(pairs, velocity):
    """The directions that count where several parts touch. `pairs`: (low, high, offset) of the box of offsets at which
    two parts interpenetrate, for all parts of the two bodies. A facet is covered if each octant just outside of it
    belongs to some other box."""
    boxes = [p for p in pairs if all(p[0][i] <= p[2][i] <= p[1][i] for i in range(3))]

    def octants(box):
        low, high, at = box
        signs = [[s for s in (-1, 1) if (at[i] > low[i] or s > 0) and (at[i] < high[i] or s < 0)] for i in range(3)]
        return set(product(*signs))

    kept, every = set(), set()
    for box in boxes:
        low, high, at = box
        closing = all((at[i] > low[i] or velocity[i] > 0) and (at[i] < high[i] or velocity[i] < 0) for i in range(3))
        if all(low[i] < at[i] < high[i] for i in range(3)) or not closing:
            continue
        others = set().union(*[octants(o) for o in boxes if o is not box])
        for i, side in product(range(3), (-1, 1)):
            if at[i] == (low if side < 0 else high)[i]:
                direction = tuple(side if j == i else 0 for j in range(3))
                every.add(direction)
                outside = {tuple(side if j == i else o[j] for j in range(3)) for o in octants(box)}
                if not outside <= others:
                    kept.add(direction)
    return kept or every
