#!/usr/bin/env python3
"""scc shape --hull --faces N, judged with fractions: a convex solid of at most N faces with all points behind them, each
face touching the hull, and as far beyond it as is told, to forty bits.

    faces_test.py SCC [K]    with each K-th of them, 1 unless told
"""

import itertools
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

import exact


def run(scc, path, *words):
    done = subprocess.run([scc, "shape", "--json", "--hull", path, *words], stdout=subprocess.PIPE, timeout=600)
    return done.returncode, json.loads(done.stdout)


def of_cloud(report):
    points, faces = exact.of_report(report)
    return [[Fraction(x) for x in p] for p in points], faces


def to_segment(a, b, x):
    ab = exact.sub(b, a)
    t = min(max(exact.dot(exact.sub(x, a), ab) / exact.dot(ab, ab), 0), 1)
    gap = exact.sub(x, [p + t * q for p, q in zip(a, ab)])
    return exact.dot(gap, gap)


def to_face(corners, x):
    """The square of the distance from a convex polygon."""
    normal = exact.cross(exact.sub(corners[1], corners[0]), exact.sub(corners[2], corners[0]))
    edges = list(zip(corners, corners[1:] + corners[:1]))
    if all(exact.dot(normal, exact.cross(exact.sub(b, a), exact.sub(x, a))) >= 0 for a, b in edges):
        height = exact.dot(normal, exact.sub(x, corners[0]))
        return height * height / exact.dot(normal, normal)
    return min(to_segment(a, b, x) for a, b in edges)


def wrong(most, points, hull, report):
    if not report.get("accepted"):
        return [report.get("diagnostics") or report.get("faults")]
    corners, faces = of_cloud(report)
    found = list(exact.faults(corners, faces, corners, 0))
    if len(faces) > most:
        found.append("%d faces" % len(faces))
    for face in faces:
        a, b, c = (corners[i] for i in face[:3])
        normal = exact.cross(exact.sub(b, a), exact.sub(c, a))
        highest = max(exact.dot(normal, exact.sub(p, a)) for p in points)
        if highest != 0:
            found.append("a point at %s before face %s" % (highest, face))
    inner, sides = of_cloud(hull)
    squared = max(min(to_face([inner[i] for i in f], x) for f in sides) for x in corners)
    told = Fraction(report["simplified"]["beyond"])
    if report["simplified"]["faces_of_hull"] != len(sides):
        found.append("another number of faces of the hull")
    if len(sides) <= most and (told != 0 or corners != inner):
        found.append("not the hull, which has few faces")
    # beyond by less than two in 2^40
    if told * told < squared or (told * (1 - Fraction(1, 2**38))) ** 2 > squared:
        found.append("%s, and %s squared" % (told, squared))
    return found


def clouds():
    draw = random.Random(4)
    for i in range(24):
        most, count = draw.choice([(3, 40), (9, 40), (1000, 30), (10**9, 30)])
        yield draw.choice([6, 7, 9, 12, 20, 40]), [[draw.randint(0, most) for _ in range(3)] for _ in range(count)]
    yield 8, [[draw.randint(0, 1000), draw.randint(0, 3), draw.randint(0, 100000)] for _ in range(40)]
    ball = []
    for i in range(300):
        z = 1 - 2 * (i + 0.5) / 300
        r = math.sqrt(1 - z * z)
        ball.append([round(1000 * c) for c in (r * math.cos(2.4 * i), r * math.sin(2.4 * i), z)])
    yield 30, ball
    yield 4, ball


def main():
    scc, every = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "cloud.obj")
        for most, points in itertools.islice(clouds(), 0, None, every):
            with open(path, "w") as file:
                file.write("".join("v %d %d %d\n" % tuple(p) for p in points))
            found = wrong(most, points, run(scc, path)[1], run(scc, path, "--faces", str(most))[1])
            passed += not found
            failed += bool(found)
            if found:
                print("FAIL %d faces of %d points: %s" % (most, len(points), found[:3]))
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
