#!/usr/bin/env python3
"""Unions of boxes of which some are inside out, by `scc decompose --union`, against a count of cells.

    turned.py SCC --count 1000 --seed 1

Boxes are on a small grid, so that they often overlap, share faces, edges or corners, or lie within each other. The
whole may be sheared, in triangles, and without vertices in common.

Without `--orient`, a cell that only boxes inside out surround is an error (SC0309), whose hint names `--orient`. Else
the volume is that of the cells that more boxes surround than boxes that are inside out. With `--orient`, a box that
lies within an odd number of greater ones is a hollow. Any other is a solid, but for those that are inside out to
begin with and have others around each of their cells, and are no copies. `--weld` changes nothing of that.
"""

import argparse
import itertools
import os
import random
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

SIDE = 6


def cells(box):
    return set(itertools.product(*(range(low, high) for low, high in box)))


def random_box(chance, others):
    if others and chance.random() < 0.4:
        within = chance.choice(others)
        box = []
        for low, high in within:
            a = chance.randint(low, high - 1)
            box.append((a, chance.randint(a + 1, high)))
        return tuple(box)
    box = []
    for _ in range(3):
        low = chance.randint(0, SIDE - 2)
        box.append((low, chance.randint(low + 1, min(SIDE, low + 4))))
    return tuple(box)


def written(chance, boxes, soup):
    """As OFF."""
    a, b = chance.choice([(0, 0), (1, -2)])
    places, lines, numbers = [], [], {}
    for k, (box, inside_out) in enumerate(boxes):
        x, y, z = box
        at = [(x[i & 1], y[i >> 1 & 1], z[i >> 2]) for i in range(8)]
        faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        cut = chance.random() < 0.3
        for f, corners in enumerate(faces):
            corners = corners[::-1] if inside_out else corners
            n = chance.randrange(4)
            p, q, r, s = corners[n:] + corners[:n]
            for own in [(p, q, r), (p, r, s)] if cut else [(p, q, r, s)]:
                row = []
                for i in own:
                    key = (k, f, own, i) if soup else (k, i)
                    if key not in numbers:
                        numbers[key] = len(places)
                        u, v, w = at[i]
                        places.append((u + a * v, v + b * w, w))
                    row.append(numbers[key])
                lines.append(" ".join(map(str, [len(row), *row])))
    chance.shuffle(lines)
    head = ["OFF", f"{len(places)} {len(lines)} 0", *(" ".join(map(str, p)) for p in places)]
    return "\n".join(head + lines) + "\n"


def volume(signed):
    """Of what is surrounded; -1 if a cell has none but boxes that are inside out around it, or if a box is taken away
    whole, and others are left."""
    found, left = 0, set()
    for cell in itertools.product(range(SIDE), repeat=3):
        signs = {k: sign for k, (own, sign) in enumerate(signed) if cell in own}
        if signs and max(signs.values()) < 0:
            return -1
        if sum(signs.values()) > 0:
            found += 1
            left.update(k for k, sign in signs.items() if sign > 0)
    solid = {k for k, (_, sign) in enumerate(signed) if sign > 0}
    return -1 if left and left < solid else found


def oriented(boxes):
    own = [cells(box) for box, _ in boxes]
    depth = [sum(a < b for b in own) for a in own]
    copies = [own.count(a) > 1 for a in own]
    solid = [d % 2 == 0 and not (d == 0 and boxes[k][1] and not copies[k]) for k, d in enumerate(depth)]
    for k in sorted(range(len(own)), key=lambda k: (-len(own[k]), k)):
        if depth[k] == 0 and not solid[k]:
            around = set().union(*(own[other] for other in range(len(own)) if solid[other]))
            solid[k] = not own[k] <= around
    return [(cells, 1 if is_solid else -1) for cells, is_solid in zip(own, solid)]


def run(scc, path, options):
    done = subprocess.run([scc, "decompose", "--union", *options, path], capture_output=True, text=True)
    text = done.stdout + done.stderr
    if done.returncode == 0:
        return Fraction(re.search(r", volume (\S+)", text).group(1))
    if "SC0309" in text and ("--orient" in text or "a part of the surface" in text):
        return -1
    return 0 if "SC0301" in text else text


def compare(scc, folder, seed):
    chance = random.Random(seed)
    boxes = []
    for _ in range(chance.choice([1, 2, 2, 3, 3, 4])):
        boxes.append((random_box(chance, [box for box, _ in boxes]), chance.random() < 0.35))
    soup = chance.random() < 0.2
    path = os.path.join(folder, "boxes.off")
    with open(path, "w", encoding="ascii") as file:
        file.write(written(chance, boxes, soup))
    plain = volume([(cells(box), -1 if inside_out else 1) for box, inside_out in boxes])
    wanted = [([], plain)]
    if not soup:
        turned = volume(oriented(boxes))
        wanted += [(["--orient"], turned), (["--weld", "--orient"], turned)]
        if len({box for box, _ in boxes}) < len(boxes):
            wanted.pop()  # a copy goes by welding
    for options, right in wanted:
        found = run(scc, path, options)
        # Where vertices are not a solid's own, pieces that share faces are one: they may be refused, or not be missed.
        if found != right and not (found == -1 and (soup or "--weld" in options)) and not (soup and right == -1):
            return f"{' '.join(options)}: {found}, and should be {right}"
    return None


def main():
    parser = argparse.ArgumentParser(description="unions of boxes that may be inside out, against a count of cells")
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1, help="of the first scene; the next ones follow")
    parser.add_argument("--keep", metavar="FOLDER", help="the files of wrong scenes")
    asked = parser.parse_args()
    bad = 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(asked.seed, asked.seed + asked.count):
            wrong = compare(asked.scc, folder, seed)
            if wrong:
                bad += 1
                print(f"seed {seed}: {wrong}")
                if asked.keep:
                    os.makedirs(asked.keep, exist_ok=True)
                    os.replace(os.path.join(folder, "boxes.off"), os.path.join(asked.keep, f"{seed}.off"))
    if bad:
        sys.exit(f"{bad} of {asked.count} scenes are wrong")
    if asked.count > 100:
        print(f"{asked.count} scenes: all right")


if __name__ == "__main__":
    main()
