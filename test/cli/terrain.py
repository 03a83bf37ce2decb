"""Random heights over a square, a solid with very many reflex edges, as OFF.

    terrain.py N      with N times N squares of two triangles each
"""

import random
import sys


def terrain(n):
    chance = random.Random(1)
    points = [(x, y, chance.randint(1000, 2000)) for y in range(n + 1) for x in range(n + 1)]
    at = lambda x, y: y * (n + 1) + x
    faces = []
    for y in range(n):
        for x in range(n):
            a, b, c, d = at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)
            faces += [(a, b, c), (a, c, d)]
    floor = len(points)
    points += [(0, 0, 0), (n, 0, 0), (n, n, 0), (0, n, 0)]
    o, p, q, r = range(floor, floor + 4)
    there = range(n + 1)
    faces.append((r, q, p, o))
    faces.append((o, p, *(at(x, 0) for x in reversed(there))))
    faces.append((p, q, *(at(n, y) for y in reversed(there))))
    faces.append((q, r, *(at(x, n) for x in there)))
    faces.append((r, o, *(at(0, y) for y in there)))
    lines = ["OFF", f"{len(points)} {len(faces)} 0"] + [" ".join(map(str, p)) for p in points]
    return "\n".join(lines + [" ".join(map(str, (len(f), *f))) for f in faces]) + "\n"


if __name__ == "__main__":
    print(terrain(int(sys.argv[1])), end="")
