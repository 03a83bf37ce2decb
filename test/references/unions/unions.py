#!/usr/bin/env python3
"""Unions of random solids by `scc decompose --union`, against an arrangement of convex pieces in plain fractions.

    unions.py SCC --count 1000 --points 1000 --seed 1

Solids are boxes, hulls of points, and prisms over stars, on a small grid, so that they often share faces, edges or
corners. Others are copies: at the same place, inside, or beside the first one, with a face, an edge or a corner in
common. Some are hollows, which are refused (SC0309) if they reach out of the solids, or if they leave nothing of a
solid. The whole may be turned, made huge or tiny, and its faces come in any order.

Each solid is known by convex pieces, each by its faces. The arrangement splits them until they are disjoint, and adds
up how often each piece of space is surrounded. So the volume of what is surrounded at least once is known exactly. The
parts that scc writes have to be convex and closed, to have this volume, and to contain the right points once.
"""

import argparse
import itertools
import math
import os
import random
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

# {1 Vectors and convex polyhedra: lists of polygons, counter-clockwise from outside}


def sub(p, q):
    return (p[0] - q[0], p[1] - q[1], p[2] - q[2])


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def plane(polygon):
    """n and d with n . x <= d inside."""
    a = polygon[0]
    n = (0, 0, 0)
    for b, c in zip(polygon[1:], polygon[2:]):
        n = tuple(s + t for s, t in zip(n, cross(sub(b, a), sub(c, a))))
    return n, dot(n, a)


def six_volumes(faces):
    return sum(dot(f[0], cross(b, c)) for f in faces for b, c in zip(f[1:], f[2:]))


def clipped(faces, n, d):
    """What the polyhedron has where n . x <= d; [] if that has no volume."""
    heights = {p: dot(n, p) - d for f in faces for p in f}
    if all(h <= 0 for h in heights.values()):
        return faces
    if all(h >= 0 for h in heights.values()):
        return []
    kept, following = [], {}
    for face in faces:
        left = []
        for p, q in zip(face, face[1:] + face[:1]):
            h, k = heights[p], heights[q]
            if h <= 0:
                left.append((p, h == 0))
            if h * k < 0:
                t = Fraction(h) / (h - k)
                left.append((tuple(x + t * (y - x) for x, y in zip(p, q)), True))
        if all(on for _, on in left):
            continue
        kept.append(tuple(p for p, _ in left))
        for (p, at_p), (q, at_q) in zip(left, left[1:] + left[:1]):
            if at_p and at_q:
                following[q] = p
    first = next(iter(following))
    lid, p = [first], following[first]
    while p != first:
        lid.append(p)
        p = following[p]
    return kept + [tuple(lid)]


def without(faces, other):
    """Disjoint convex pieces of the polyhedron outside of another one, and what is in both."""
    pieces = []
    for n, d in map(plane, other):
        outside = clipped(faces, tuple(-x for x in n), -d)
        if outside:
            pieces.append(outside)
        faces = clipped(faces, n, d)
        if not faces:
            break
    return pieces, faces


def six_volumes_of_union(solids):
    """Of the points that are in at least one more solid than hollow."""
    cells = []
    for sign, pieces in solids:
        for piece in pieces:
            rest, more = [piece], []
            for faces, times in cells:
                outside, common = without(faces, piece)
                if not common:
                    more.append((faces, times))
                    continue
                more += [(p, times) for p in outside]
                more.append((common, times + sign))
                rest = [q for p in rest for q in without(p, faces)[0]]
            cells = more + [(p, sign) for p in rest]
    return sum(six_volumes(faces) for faces, times in cells if times > 0)


# {1 Solids: outward faces, and convex pieces}


def hull_of_points(points):
    """The faces of the hull, by all planes through three points; [] if it is flat."""
    points, faces, seen = sorted(set(points)), [], set()
    for a, b, c in itertools.permutations(points, 3):
        n = cross(sub(b, a), sub(c, a))
        if n == (0, 0, 0) or any(dot(n, sub(p, a)) > 0 for p in points):
            continue
        on = frozenset(p for p in points if dot(n, sub(p, a)) == 0)
        if on in seen:
            continue
        if len(on) == len(points):
            return []
        seen.add(on)
        turn = lambda p, q, r: dot(n, cross(sub(q, p), sub(r, p)))
        start, ring = min(on), []
        p = start
        while True:
            ring.append(p)
            q = None
            for r in sorted(on):
                if r == p:
                    continue
                side = 1 if q is None else turn(p, q, r)
                if q is None or side < 0 or (side == 0 and dot(sub(r, p), sub(r, p)) > dot(sub(q, p), sub(q, p))):
                    q = r
            p = q
            if p == start:
                break
        faces.append(tuple(ring))
    return faces


def box(low, high):
    return hull_of_points(list(itertools.product(*zip(low, high))))


def prism(ring, low, high):
    """Over a polygon, counter-clockwise."""
    n = len(ring)
    at = lambda k, z: (*ring[k % n], z)
    walls = [(at(k, low), at(k + 1, low), at(k + 1, high), at(k, high)) for k in range(n)]
    return [tuple(at(k, low) for k in reversed(range(n))), tuple(at(k, high) for k in range(n)), *walls]


def random_box(chance):
    low = [chance.randint(0, 4) for _ in range(3)]
    faces = box(low, [x + chance.randint(1, 4) for x in low])
    return faces, [faces]


def random_hull(chance):
    while True:
        points = [tuple(chance.randint(0, 6) for _ in range(3)) for _ in range(chance.randint(4, 8))]
        faces = hull_of_points(points)
        if faces:
            return faces, [faces]


def random_star(chance):
    """Corners around a centre, of which there are some in each quarter: the pieces are prisms over triangles."""
    quarters = [[(2, 0), (3, 1), (2, 2), (1, 3), (1, 1), (3, 0), (2, 1), (1, 2)]]
    for _ in range(3):
        quarters.append([(-y, x) for x, y in quarters[-1]])
    ring = []
    for quarter in quarters:
        by_ray = {}
        for x, y in chance.sample(quarter, chance.randint(1, 3)):
            by_ray.setdefault((x // math.gcd(x, y), y // math.gcd(x, y)), (x, y))
        ring += by_ray.values()
    angle = lambda p: [(p[0] > 0 <= p[1]), (p[0] <= 0 < p[1]), (p[0] < 0 >= p[1]), True].index(True)
    slope = lambda p: [Fraction(p[1], p[0] or 1), Fraction(-p[0], p[1] or 1)][angle(p) % 2]
    ring.sort(key=lambda p: (angle(p), slope(p)))
    x, y, low = (chance.randint(2, 4) for _ in range(3))
    high = low + chance.randint(1, 3)
    ring = [(x + a, y + b) for a, b in ring]
    order = chance.choice([(0, 1, 2), (1, 2, 0), (2, 0, 1)])
    moved = lambda faces: [tuple(tuple(p[k] for k in order) for p in f) for f in faces]
    triangles = [((x, y), p, q) for p, q in zip(ring, ring[1:] + ring[:1])]
    return moved(prism(ring, low, high)), [moved(prism(t, low, high)) for t in triangles]


def mapped(solid, f):
    faces, pieces = solid
    of_faces = lambda list: [tuple(f(p) for p in face) for face in list]
    return of_faces(faces), [of_faces(piece) for piece in pieces]


def copy(chance, solid):
    """At the same place, inside, or moved by its own size along some axes."""
    kind = chance.choice(["same", "inside", "beside", "beside", "beside"])
    points = [p for f in solid[0] for p in f]
    if kind == "same":
        return solid
    if kind == "inside":
        middle = [Fraction(sum(p[k] for p in points), len(points)) for k in range(3)]
        return mapped(solid, lambda p: tuple((x + m) / 2 for x, m in zip(p, middle)))
    size = [max(p[k] for p in points) - min(p[k] for p in points) for k in range(3)]
    by = [chance.choice([0, 0, 1, -1, Fraction(1, 2)]) for _ in range(3)]
    return mapped(solid, lambda p: tuple(x + s * t for x, s, t in zip(p, size, by)))


def turning(chance):
    """A rotation by a quaternion, times the square of its length, and a scale."""
    w, x, y, z = chance.choice([(1, 0, 0, 0), (chance.randint(1, 3), *(chance.randint(-3, 3) for _ in range(3)))])
    scale = chance.choice([Fraction(1)] * 4 + [Fraction(10) ** 50, Fraction(1, 10**50), Fraction(1, 3)])
    rows = [
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    ]
    return lambda p: tuple(scale * dot(row, p) for row in rows)


def scene(chance):
    """Solids with their signs."""
    solids = []
    for _ in range(chance.choice([1, 2, 2, 3, 3, 4])):
        make = chance.choice([random_box, random_hull, random_star])
        made = copy(chance, chance.choice(solids)[1]) if solids and chance.random() < 0.4 else make(chance)
        solids.append((1, made))
    if chance.random() < 0.2:
        faces, pieces = copy(chance, chance.choice(solids)[1])
        solids.append((-1, (faces, pieces)))
    turn = turning(chance)
    return [(sign, mapped(solid, turn)) for sign, solid in solids]


# {1 Files}


def written(chance, solids):
    """As OFF: all faces in any order, from any corner on; corners are shared within a solid or not at all."""
    faces = []
    for number, (sign, (outside, _)) in enumerate(solids):
        for face in outside:
            face = face if sign > 0 else face[::-1]
            k = chance.randrange(len(face))
            faces.append([(number, p) for p in face[k:] + face[:k]])
    chance.shuffle(faces)
    share, numbers, places, lines = chance.random() < 0.5, {}, [], []
    for i, face in enumerate(faces):
        row = []
        for number, p in face:
            key = (number, p) if share else (i, p)
            if key not in numbers:
                numbers[key] = len(places)
                places.append(p)
            row.append(numbers[key])
        lines.append(" ".join(map(str, [len(row), *row])))
    head = ["OFF", f"{len(places)} {len(faces)} 0", *(" ".join(map(str, p)) for p in places)]
    return "\n".join(head + lines) + "\n"


def parts_of(text):
    """The parts of an OBJ file, each by its faces."""
    points, parts = [], []
    for line in text.splitlines():
        word, *rest = line.split()
        if word == "o":
            parts.append([])
        elif word == "v":
            points.append(tuple(map(Fraction, rest)))
        else:
            parts[-1].append(tuple(points[int(k) - 1] for k in rest))
    return parts


# {1 Comparison}


def convex_and_closed(faces):
    edges = {(p, q) for f in faces for p, q in zip(f, f[1:] + f[:1])}
    points = {p for f in faces for p in f}
    flat = all(dot(n, p) == d for f in faces for n, d in [plane(f)] for p in f)
    behind = all(dot(n, p) <= d for n, d in map(plane, faces) for p in points)
    return flat and behind and len(edges) == sum(map(len, faces)) and all((q, p) in edges for p, q in edges)


def position(planes, x):
    """1 inside, 0 on the surface, -1 outside."""
    heights = [dot(n, x) - d for n, d in planes]
    return 1 if all(h < 0 for h in heights) else -1 if any(h > 0 for h in heights) else 0


def wrong_point(chance, solids, parts, count):
    points = [p for _, (faces, _) in solids for f in faces for p in f]
    low, high = ([choose(p[k] for p in points) for k in range(3)] for choose in (min, max))
    known = [(sign, [list(map(plane, piece)) for piece in pieces]) for sign, (_, pieces) in solids]
    cut = [list(map(plane, part)) for part in parts]
    for _ in range(count):
        x = tuple(a + (b - a) * Fraction(chance.randint(-50, 1050), 1000) for a, b in zip(low, high))
        positions = [(sign, position(planes, x)) for sign, pieces in known for planes in pieces]
        if any(at == 0 for _, at in positions):
            continue
        there = sum(sign for sign, at in positions if at > 0) > 0
        found = [position(planes, x) for planes in cut]
        strictly, at_all = sum(at > 0 for at in found), sum(at >= 0 for at in found)
        if strictly > 1 or (at_all > 0) != there:
            return x
    return None


def taken_whole(solids, volume):
    """Whether hollows leave nothing of one of the solids: it adds all of its volume to the union."""
    if all(sign > 0 for sign, _ in solids):
        return False
    signed = [(sign, pieces) for sign, (_, pieces) in solids]

    def added(pieces):
        return six_volumes_of_union(signed + [(len(solids), pieces)]) - volume

    return any(added(pieces) == six_volumes_of_union([(1, pieces)]) for sign, pieces in signed if sign > 0)


def compare(scc, folder, seed, points):
    """What is wrong, or None; and the number of parts."""
    chance = random.Random(seed)
    solids = scene(chance)
    path, out = os.path.join(folder, "scene.off"), os.path.join(folder, "parts.obj")
    with open(path, "w", encoding="ascii") as file:
        file.write(written(chance, solids))
    volume = six_volumes_of_union([(sign, pieces) for sign, (_, pieces) in solids])
    names = ["--names"] if chance.random() < 0.3 else []
    done = subprocess.run([scc, "decompose", "--union", path, "-o", out, *names], capture_output=True, text=True)
    solid = six_volumes_of_union([(1, pieces) for sign, (_, pieces) in solids if sign > 0])
    if solid != six_volumes_of_union([(1, pieces) for _, (_, pieces) in solids]):
        # A hollow reaches out of the solids.
        return (None if done.returncode == 3 and "SC0309" in done.stderr else "a hollow reaches out"), 0
    if volume == 0:
        return (None if done.returncode == 3 and re.search("SC03", done.stderr) else "nothing is surrounded"), 0
    if taken_whole(solids, volume):
        return (None if done.returncode == 3 and "SC0309" in done.stderr else "a solid is taken away whole"), 0
    if done.returncode != 0:
        return f"exit code {done.returncode}: {done.stderr}", 0
    with open(out, encoding="ascii") as file:
        parts = parts_of(file.read())
    if not all(map(convex_and_closed, parts)):
        return "a part is not convex", len(parts)
    if sum(map(six_volumes, parts)) != volume:
        return f"the volume is {sum(map(six_volumes, parts)) / 6} and should be {volume / 6}", len(parts)
    x = wrong_point(chance, solids, parts, points)
    return (None if x is None else f"the point {x} is wrong"), len(parts)


def main():
    parser = argparse.ArgumentParser(description="unions by scc decompose, against an arrangement of convex pieces")
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--points", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1, help="of the first scene; the next ones follow")
    parser.add_argument("--keep", metavar="FOLDER", help="the files of wrong scenes")
    asked = parser.parse_args()
    bad, parts = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(asked.seed, asked.seed + asked.count):
            wrong, count = compare(asked.scc, folder, seed, asked.points)
            parts += count
            if wrong:
                bad += 1
                print(f"seed {seed}: {wrong}")
                if asked.keep:
                    os.makedirs(asked.keep, exist_ok=True)
                    os.replace(os.path.join(folder, "scene.off"), os.path.join(asked.keep, f"{seed}.off"))
    if bad or parts < asked.count:
        sys.exit(f"{bad} of {asked.count} scenes are wrong, {parts} parts")
    if asked.count > 100:
        print(f"{asked.count} scenes, {parts} parts, {asked.points} points each: all right")


if __name__ == "__main__":
    main()
