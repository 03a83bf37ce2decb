"""What a snapped solid has to be, judged with fractions alone."""

import json
import subprocess
from fractions import Fraction


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def faults(before, faces, after, distance):
    """Why this is no convex polyhedron with these faces, or has a vertex farther away than that."""
    distance = Fraction(distance)
    for v, (p, q) in enumerate(zip(before, after)):
        step = sub([Fraction(x) for x in p], q)
        if dot(step, step) > distance * distance:
            yield "vertex %d is too far" % v
    for face in faces:
        a, b, c = (after[i] for i in face[:3])
        normal = cross(sub(b, a), sub(c, a))
        height = dot(normal, a)
        for v, p in enumerate(after):
            side = dot(normal, p) - height
            if v in face and side != 0:
                yield "vertex %d is off face %s" % (v, face)
            if v not in face and side >= 0:
                yield "vertex %d is not behind face %s" % (v, face)
        for i in range(len(face)):
            p, q, r = (after[face[(i + k) % len(face)]] for k in range(3))
            if dot(normal, cross(sub(q, p), sub(r, q))) <= 0:
                yield "face %s does not turn left" % (face,)


def snapped(scc, path, distance, timeout=600):
    """The report of scc shape --snap."""
    words = [scc, "shape", "--json", "--snap", distance, path]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=timeout)
    return json.loads(done.stdout)


def of_report(report):
    """Vertices, and faces as tuples of places."""
    names = {vertex["name"]: i for i, vertex in enumerate(report["vertices"])}
    points = [[Fraction(x) for x in vertex["position"]] for vertex in report["vertices"]]
    return points, [tuple(names[c] for c in face["corners"]) for face in report["faces"]]
