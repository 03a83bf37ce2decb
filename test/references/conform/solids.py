"""Convex polyhedra in plain floats: when two of them meet that only translate, by separating axes."""

EPSILON = 1e-9  # lengths and times below it count as 0


def add(u, v):
    return (u[0] + v[0], u[1] + v[1], u[2] + v[2])


def sub(u, v):
    return (u[0] - v[0], u[1] - v[1], u[2] - v[2])


def scale(k, u):
    return (k * u[0], k * u[1], k * u[2])


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def unit(u):
    return scale(1 / dot(u, u) ** 0.5, u)


class Solid:
    """Vertices by name, and faces: a name, and vertex names counter-clockwise from outside."""

    def __init__(self, vertices, faces, stretch=(1.0, 1.0, 1.0)):
        self.vertices = {n: tuple(float(a) * s for a, s in zip(v, stretch)) for n, v in vertices.items()}
        self.normals, edges = {}, {}
        for face, cycle in faces.items():
            a, b, c = (self.vertices[n] for n in cycle[:3])
            self.normals[face] = unit(cross(sub(b, a), sub(c, b)))
            for n, m in zip(cycle, cycle[1:] + cycle[:1]):
                edges[frozenset((n, m))] = sub(self.vertices[m], self.vertices[n])
        self.edges = list(edges.values())

    def highest(self, direction):
        return max(dot(direction, v) for v in self.vertices.values())

    def face_towards(self, direction):
        """The face with this outward normal, or None."""
        for face, normal in self.normals.items():
            if dot(normal, direction) > 1 - EPSILON:
                return face
        return None


AXES = {}


def axes(a, b):
    """The directions from a to b that can separate them, with the gap along each when they lie on one place."""
    if (a, b) not in AXES:
        found = list(a.normals.values()) + [scale(-1.0, n) for n in b.normals.values()]
        for e in a.edges:
            for f in b.edges:
                n = cross(e, f)
                if dot(n, n) > EPSILON:
                    found += [unit(n), scale(-1.0, unit(n))]
        AXES[a, b] = [(n, -b.highest(scale(-1.0, n)) - a.highest(n)) for n in found]
    return AXES[a, b]


def first_contact(a, b, offset, velocity):
    """When b at the offset, with the velocity (both from a), begins to enter a: (time, normal from a to b) or None."""
    entry, normal, leave = None, None, None
    for n, base in axes(a, b):
        gap, speed = base + dot(n, offset), dot(n, velocity)
        if abs(speed) < EPSILON:
            if gap > -EPSILON:
                return None
        elif speed > 0:
            if gap > -EPSILON:
                return None
            leave = -gap / speed if leave is None else min(leave, -gap / speed)
        else:
            time = gap / -speed
            if entry is None or time > entry + EPSILON:
                entry, normal = time, n
    if entry is None or (leave is not None and entry > leave - EPSILON) or entry < -1e-6:
        return None
    return max(entry, 0.0), normal
