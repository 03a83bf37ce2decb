#!/usr/bin/env python3
"""Solids of cubes whose faces are rectangles of any size, by `scc decompose`, against the number of cubes.

    polycubes.py SCC --count 1000 --seed 1

A corner of a rectangle is often within the side of another one, where `--merge` has to put it into that side. Some
rectangles are two triangles, some are turned over, and faces share vertices or do not. Options come in any order.
"""

import argparse
import os
import random
import re
import subprocess
import sys
import tempfile


def cubes(chance):
    found = {(0, 0, 0)}
    for _ in range(chance.randint(0, 6)):
        cube = list(chance.choice(sorted(found)))
        cube[chance.randrange(3)] += chance.choice((1, -1))
        found.add(tuple(cube))
    return found


def rectangles(chance, found):
    """Corners of each, counter-clockwise from outside."""
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            squares = {}
            for cube in found:
                beside = list(cube)
                beside[axis] += 2 * side - 1
                if tuple(beside) not in found:
                    squares.setdefault(cube[axis] + side, set()).add((cube[u], cube[v]))
            for level, left in sorted(squares.items()):
                while left:
                    a, b = chance.choice(sorted(left))
                    m = n = 1
                    while chance.random() < 0.7 and all((a + m, b + j) in left for j in range(n)):
                        m += 1
                    while chance.random() < 0.7 and all((a + i, b + n) in left for i in range(m)):
                        n += 1
                    left -= {(a + i, b + j) for i in range(m) for j in range(n)}
                    corners = []
                    for x, y in ((a, b), (a + m, b), (a + m, b + n), (a, b + n)):
                        point = [0, 0, 0]
                        point[axis], point[u], point[v] = level, x, y
                        corners.append(tuple(point))
                    yield corners if side else corners[::-1]


def written(chance, found):
    faces = []
    for face in rectangles(chance, found):
        p, q, r, s = face
        faces += [[p, q, r], [p, r, s]] if chance.random() < 0.3 else [face]
    turned = chance.choice((0, 0.2, 1))
    faces = [face[::-1] if chance.random() < turned else face for face in faces]
    chance.shuffle(faces)
    share, numbers, places, lines = chance.random() < 0.5, {}, [], []
    for i, face in enumerate(faces):
        row = []
        for p in face:
            key = p if share else (i, p)
            if key not in numbers:
                numbers[key] = len(places)
                places.append(p)
            row.append(numbers[key])
        lines.append(" ".join(map(str, [len(row), *row])))
    head = ["OFF", f"{len(places)} {len(lines)} 0", *(" ".join(map(str, p)) for p in places)]
    return "\n".join(head + lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description="solids of cubes with faces of any size, against their number")
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1, help="of the first solid; the next ones follow")
    parser.add_argument("--keep", metavar="FOLDER", help="the files of wrong solids")
    asked = parser.parse_args()
    bad = 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "cubes.off")
        for seed in range(asked.seed, asked.seed + asked.count):
            chance = random.Random(seed)
            found = cubes(chance)
            with open(path, "w", encoding="ascii") as file:
                file.write(written(chance, found))
            options = ["--weld", "--orient", "--merge", "--union"]
            chance.shuffle(options)
            done = subprocess.run([asked.scc, "decompose", *options, path], capture_output=True, text=True)
            volume = re.search(r", volume (\S+)", done.stdout)
            if not volume or volume.group(1) != str(len(found)):
                bad += 1
                print(f"seed {seed}: {volume and volume.group(1)}, and should be {len(found)}; {done.stderr}")
                if asked.keep:
                    os.makedirs(asked.keep, exist_ok=True)
                    os.replace(path, os.path.join(asked.keep, f"{seed}.off"))
    if bad:
        sys.exit(f"{bad} of {asked.count} solids are wrong")
    if asked.count > 100:
        print(f"{asked.count} solids: all right")


if __name__ == "__main__":
    main()
