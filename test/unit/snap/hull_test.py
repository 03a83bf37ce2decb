#!/usr/bin/env python3
"""scc shape --hull, on clouds of points with many in one plane or line: all points are behind all faces, which are those
of a convex solid, whose corners are points of the cloud.

    hull_test.py SCC
"""

import json
import os
import random
import subprocess
import sys
import tempfile

import exact


def hull(scc, path):
    done = subprocess.run([scc, "shape", "--json", "--hull", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=600)
    return json.loads(done.stdout)


def clouds():
    draw = random.Random(3)
    for _ in range(80):
        most, count = draw.choice([(1, 8), (2, 12), (2, 40), (3, 30), (9, 60), (1000, 40)])
        yield [tuple(draw.randint(0, most) for _ in range(3)) for _ in range(draw.randint(4, count))]
    for _ in range(10):
        yield [(draw.randint(0, 3), draw.randint(0, 3), 5) for _ in range(10)]


def flat(points):
    """All in one plane."""
    a = points[0]
    steps = [exact.sub(p, a) for p in points]
    normals = [exact.cross(s, t) for s in steps for t in steps]
    normal = next((n for n in normals if any(n)), None)
    return normal is None or all(exact.dot(normal, s) == 0 for s in steps)


def wrong(report, points):
    if flat(points):
        return [] if report.get("diagnostics") else ["a hull of points in one plane"]
    if not report.get("accepted"):
        return [report.get("diagnostics") or report.get("faults")]
    corners, faces = exact.of_report(report)
    found = list(exact.faults(corners, faces, corners, 0))
    if not {tuple(c) for c in corners} <= set(points):
        found.append("a corner that is no point")
    for face in faces:
        a, b, c = (corners[i] for i in face[:3])
        normal = exact.cross(exact.sub(b, a), exact.sub(c, a))
        if any(exact.dot(normal, exact.sub(p, a)) > 0 for p in points):
            found.append("a point before face %s" % (face,))
    return found


def main():
    scc = os.path.abspath(sys.argv[1])
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "cloud.obj")
        for points in clouds():
            with open(path, "w") as file:
                file.write("".join("v %d %d %d\n" % p for p in points))
            found = wrong(hull(scc, path), points)
            passed += not found
            failed += bool(found)
            if found:
                print("FAIL %s: %s" % (points, found[:3]))
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
