#!/usr/bin/env python3
"""scc shape --snap, on solids whose decimals are rounded: what it gives is judged by exact.py.

    snap_test.py SCC [K]    with each K-th of them, 1 unless told
"""

import itertools
import os
import sys
import tempfile
import time
from fractions import Fraction

import exact
import solids

DISTANCE = "1e-5"


def texts(name, points, faces):
    """The solid as files: as it is, turned, flat, far away, inside out."""
    yield name, points, faces, 5
    yield name + ", turned", solids.turned(name, points), faces, 5
    if len(points) <= 12:
        yield name + ", in six digits", solids.turned(name + "!", points), faces, 6
        flat = [(x, y, z / 50) for x, y, z in points]
        yield name + ", flat", flat, faces, 5
        yield name + ", far away", [(x + 1000, y, z - 777) for x, y, z in points], faces, 5
        yield name + ", inside out", points, [tuple(reversed(f)) for f in faces], 5


def main():
    scc, every = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    passed = failed = rounded = 0
    slowest = 0.0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "solid.off")
        for solid in itertools.islice(solids.solids(), 0, None, every):
            for name, points, faces, digits in texts(*solid):
                with open(path, "w") as file:
                    file.write(solids.off(points, faces, digits))
                started = time.monotonic()
                report = exact.snapped(scc, path, DISTANCE)
                slowest = max(slowest, time.monotonic() - started)
                if not report.get("accepted"):
                    print("FAIL %s: %s" % (name, report.get("diagnostics") or report.get("faults")))
                    failed += 1
                    continue
                after, faces_after = exact.of_report(report)
                before = [tuple("%.*f" % (digits, x) for x in p) for p in points]
                if name.endswith("inside out"):
                    faces = [tuple(reversed(f)) for f in faces]
                same = [set(f) for f in faces_after] == [set(f) for f in faces]
                wrong = list(exact.faults(before, faces, after, DISTANCE))
                rounded += any(exact.faults(before, faces, [[Fraction(x) for x in p] for p in before], DISTANCE))
                if wrong or not same:
                    print("FAIL %s: %s" % (name, wrong[:3] or "other faces"))
                    failed += 1
                else:
                    passed += 1
    print("%d of them were no convex polyhedra before; the slowest took %.2f s" % (rounded, slowest))
    if rounded < 100 / every:
        print("FAIL: hardly anything had to be moved")
        failed += 1
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
