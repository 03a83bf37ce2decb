#!/usr/bin/env python3
"""scc shape --hull --snap, on clouds of rounded points: corners of solids, alone and with points in their faces, on their
edges and inside them. The solid that they were made of has to come out: its corners, its faces.

    cloud_test.py SCC [K]    with each K-th of them, 1 unless told
"""

import itertools
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

import exact
import solids

DISTANCE = "2e-5"


def mean(points):
    return tuple(sum(c) / len(points) for c in zip(*points))


def with_others(points, faces, draw):
    """Points in faces, on edges, inside."""
    found = list(points)
    for face in faces:
        corners = [points[i] for i in face]
        weights = [draw.random() + 0.1 for _ in corners]
        found.append(tuple(sum(w * c[k] for w, c in zip(weights, corners)) / sum(weights) for k in range(3)))
        a, b = corners[0], corners[1]
        found.append(solids.scale(0.5, solids.add(a, b)))
    centre = mean(points)
    found += [mean([centre, centre, draw.choice(points)]) for _ in range(5)]
    return found


def clouds():
    draw = random.Random(7)
    for name, points, faces in solids.solids():
        turned = solids.turned(name, points)
        yield name, points, points, faces
        yield name + ", turned", turned, turned, faces
        if len(points) <= 30:
            yield name + ", with others", turned, with_others(turned, faces, draw), faces


def snapped(scc, path):
    words = [scc, "shape", "--json", "--hull", "--snap", DISTANCE, path]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=600)
    return json.loads(done.stdout)


def wrong(report, rounded, count, faces):
    if not report.get("accepted"):
        return [report.get("diagnostics") or report.get("faults")]
    after, found = exact.of_report(report)
    places = [int(vertex["name"][1:]) for vertex in report["vertices"]]
    if sorted(places) != list(range(count)):
        return ["its corners are %s" % places]
    back = [None] * count
    for k, place in enumerate(places):
        back[place] = after[k]
    found = [tuple(places[k] for k in face) for face in found]
    faults = list(exact.faults(rounded[:count], found, back, DISTANCE))
    if {frozenset(f) for f in found} != {frozenset(f) for f in faces}:
        faults.append("%d faces, and not %d" % (len(found), len(faces)))
    return faults


def main():
    scc, every = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    passed = failed = bent = 0
    slowest = 0.0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "cloud.obj")
        for name, corners, points, faces in itertools.islice(clouds(), 0, None, every):
            rounded = [tuple("%.5f" % x for x in p) for p in points]
            with open(path, "w") as file:
                file.write("".join("v %s %s %s\n" % p for p in rounded))
            started = time.monotonic()
            found = wrong(snapped(scc, path), rounded, len(corners), faces)
            slowest = max(slowest, time.monotonic() - started)
            as_they_are = [[Fraction(x) for x in p] for p in rounded[:len(corners)]]
            bent += any(exact.faults(rounded[:len(corners)], faces, as_they_are, DISTANCE))
            passed += not found
            failed += bool(found)
            if found:
                print("FAIL %s: %s" % (name, found[:3]))
    print("%d of them had bent faces before; the slowest took %.2f s" % (bent, slowest))
    if bent < 100 / every:
        print("FAIL: hardly anything was bent")
        failed += 1
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
