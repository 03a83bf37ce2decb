"""scc shape --snap on the solids of npm's package `polyhedra` (Platonic, Archimedean and Johnson solids, prisms, antiprisms),
as they are, and turned at random and rounded to five decimals. None of the package becomes part of this project.
"""

import json
import os
import sys
import time

from common import Run, npm_pack

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..", "..")
sys.path.insert(0, os.path.join(ROOT, "test", "unit", "snap"))

import exact  # noqa: E402
import solids  # noqa: E402

DISTANCE = "1e-5"


def fetched(folder):
    with npm_pack("polyhedra@1.0.0", folder) as tar:
        for member in tar.getmembers():
            if member.name.startswith("package/data/") and member.name.endswith(".json"):
                yield from json.load(tar.extractfile(member)).values()


def main():
    run = Run("Solids of others are snapped")
    slowest = 0.0
    path = run.path("solid.off")
    for solid in fetched(run.folder):
        name, points, faces = solid["name"], solid["vertex"], [tuple(f) for f in solid["face"]]
        for way, vertices, digits in ((name, points, 17), (name + ", turned", solids.turned(name, points), 5)):
            with open(path, "w") as file:
                file.write(solids.off(vertices, faces, digits))
            started = time.monotonic()
            report = exact.snapped(run.scc, path, DISTANCE)
            took = time.monotonic() - started
            slowest = max(slowest, took)
            wrong = [report.get("diagnostics", "refused")]
            if report.get("accepted"):
                after, found = exact.of_report(report)
                before = [tuple("%.*f" % (digits, x) for x in p) for p in vertices]
                wrong = list(exact.faults(before, found, after, DISTANCE))
                if [set(f) for f in found] != [set(f) for f in faces]:
                    wrong.append("other faces")
            run.ok(not wrong, f"{way}: {wrong[:3]}")
    print(f"  the slowest took {slowest:.2f} s")
    run.end()


main()
