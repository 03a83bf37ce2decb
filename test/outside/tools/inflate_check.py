"""inflate_check.py SCC WORK: solids of scc inflate against SciPy and trimesh, and its pictures against Pillow.

Heights over all pixels are the solution of the sparse system, as SciPy finds it; simplified solids are watertight for
trimesh, with the volume that their triangles add up to, and nowhere farther than told from the heights over all pixels;
PNG files of every kind that Pillow writes give the same solid as the same picture as a text.
"""

import json
import random
import subprocess
import sys
from fractions import Fraction

try:
    import numpy as np
    import scipy.sparse
    import scipy.sparse.linalg
    import trimesh
    from PIL import Image
except ImportError as error:
    print(f"{error.name} is missing")
    sys.exit(3)

scc, work = sys.argv[1:3]
passed = failed = 0


def count(good, what):
    global passed, failed
    if good:
        passed += 1
    else:
        failed += 1
        print("failed:", what)


def inflate(picture, *options, out="solid.obj"):
    command = [scc, "inflate", f"{work}/{picture}", "--json", "-o", f"{work}/{out}", *options]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def read(out="solid.obj"):
    vertices, faces = [], []
    with open(f"{work}/{out}") as file:
        for line in file:
            word, *rest = line.split()
            if word == "v":
                vertices.append([Fraction(x) for x in rest])
            elif word == "f":
                faces.append([int(x) - 1 for x in rest])
    return vertices, faces


def icons(rng):
    y, x = np.mgrid[0:100, 0:100]
    yield "disc", (x - 49.5) ** 2 + (y - 49.5) ** 2 < 49**2
    yield "square", np.ones((64, 64), bool)
    yield "ring", abs(np.hypot(x - 49.5, y - 49.5) - 35) < 12
    yield "comb", np.where(y < 20, True, x % 8 < 4)[:90, :120]
    for n in range(4):
        h, w = rng.integers(20, 90, 2)
        y, x = np.mgrid[0:h, 0:w]
        blot = np.zeros((h, w), bool)
        cx, cy = w / 2, h / 2
        for _ in range(9):
            r = rng.uniform(3, 12)
            blot |= np.hypot(x - cx, y - cy) < r
            cx, cy = cx + rng.uniform(-r, r), cy + rng.uniform(-r, r)
        blot &= rng.uniform(0, 1, (h, w)) < 0.97
        yield f"blot {n}", blot


def largest_piece(inside):
    from scipy.ndimage import label

    labels, n = label(inside)
    sizes = np.bincount(labels.ravel())[1:]
    return labels == 1 + int(np.argmax(sizes)) if n else inside


def poisson(inside):
    """4 v - sum of neighbours = 4 on the pixels."""
    index = -np.ones(np.array(inside.shape) + 2, int)
    index[1:-1, 1:-1][inside] = np.arange(inside.sum())
    here = index[1:-1, 1:-1][inside]
    rows, columns = [], []
    for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0)):
        there = index[1 + dy : index.shape[0] - 1 + dy, 1 + dx : index.shape[1] - 1 + dx][inside]
        rows.append(here[there >= 0])
        columns.append(there[there >= 0])
    rows, columns = np.concatenate(rows), np.concatenate(columns)
    n = len(here)
    matrix = scipy.sparse.csc_matrix((-np.ones(len(rows)), (rows, columns)), (n, n)) + 4 * scipy.sparse.eye(n, format="csc")
    values = np.zeros(inside.shape)
    values[inside] = scipy.sparse.linalg.spsolve(matrix, 4 * np.ones(n))
    return values


def write(inside):
    with open(f"{work}/icon.pbm", "w") as file:
        file.write(f"P1\n{inside.shape[1]} {inside.shape[0]}\n")
        file.writelines(" ".join(map(str, row)) + "\n" for row in inside.astype(int))


def check_icon(name, inside):
    inside = largest_piece(inside)
    write(inside)
    height, width = inside.shape
    exact = poisson(inside)
    for profile in "diffused", "round":
        report = inflate("icon.pbm", "--faces", "all", "--profile", profile)
        radius, off = float(Fraction(report["radius"])), float(Fraction(report["distances"]["solution"]))
        wanted = exact / radius if profile == "diffused" else np.sqrt(exact)
        vertices, faces = read()
        met, gap = 0, 0.0
        for x, y, z in vertices:
            column, row = x + Fraction(width - 1, 2), Fraction(height - 1, 2) - y
            if z > 0:
                met += 1
                gap = max(gap, abs(float(z) - wanted[int(row), int(column)]))
        count(met == inside.sum() == report["pixels"], f"{name}: a height for each pixel")
        count(gap <= off + 1e-8, f"{name}, {profile}: {gap} from SciPy's solution, {off} told")
        heights = {(x, y): z for x, y, z in vertices if z >= 0}
        for n in 60, 300:
            try:
                report = inflate("icon.pbm", "--faces", str(n), "--profile", profile)
            except subprocess.CalledProcessError:
                continue
            check_simplified(f"{name}, {profile}, {n} faces", report, heights, *read())


def check_simplified(name, report, heights, vertices, faces):
    mesh = trimesh.load(f"{work}/solid.obj", process=False)
    count(len(mesh.faces) == report["faces"], f"{name}: as many faces as told")
    count(mesh.is_watertight and mesh.is_winding_consistent, f"{name}: watertight")
    count(mesh.euler_number == 2 - 2 * report["holes"], f"{name}: holes")
    volume = sum(np.dot(a, np.cross(b, c)) for a, b, c in ([np.array(vertices[v], object) for v in f] for f in faces)) / 6
    count(volume > 0 and abs(mesh.volume - float(volume)) < 1e-6 * float(volume), f"{name}: volume")
    # Vertices within the outline stand on the surface; its triangles are near the heights over all pixels.
    told = float(Fraction(report["distances"]["surface"]))
    front = [f for f in faces[: len(faces) // 2]]
    points = np.array([(float(x), float(y)) for x, y in heights])
    z = np.array([float(h) for h in heights.values()])
    simple = np.zeros(len(points))
    for f in front:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = [tuple(map(float, vertices[v])) for v in f]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        v = ((cx - bx) * (points[:, 1] - by) - (cy - by) * (points[:, 0] - bx)) / area
        w = ((ax - cx) * (points[:, 1] - cy) - (ay - cy) * (points[:, 0] - cx)) / area
        within = (v >= -1e-12) & (w >= -1e-12) & (v + w <= 1 + 1e-12)
        simple[within] = (v * az + w * bz + (1 - v - w) * cz)[within]
    count(np.max(np.abs(simple - z)) <= told + 1e-8, f"{name}: {np.max(np.abs(simple - z))} from the surface, {told} told")


def check_pictures(rng):
    size = (23, 17)
    grey = Image.fromarray((rng.uniform(0, 1, size[::-1]) < 0.8).astype(np.uint8) * 90 + 20)
    kinds = [("1", {}), ("L", {}), ("P", {}), ("RGB", {}), ("LA", {}), ("RGBA", {}), ("I;16", {})]
    for mode, options in kinds:
        inside = largest_piece(np.array(grey) > 60)
        black = Image.fromarray(np.where(inside, 0, 255).astype(np.uint8))
        if mode == "I;16":
            image = Image.fromarray(np.where(inside, 0, 65535).astype(np.uint16))
        elif mode in ("LA", "RGBA"):
            image = Image.new(mode, size, 0)
            image.putalpha(Image.fromarray(np.where(inside, 200, 50).astype(np.uint8)))
        else:
            image = black.convert(mode)
        image.save(f"{work}/icon.png", **options)
        write(inside)
        inflate("icon.png", "--faces", "all", out="png.obj")
        inflate("icon.pbm", "--faces", "all", out="pbm.obj")
        count(read("png.obj") == read("pbm.obj"), f"PNG as Pillow writes {mode}")


rng = np.random.default_rng(18)
random.seed(18)
for name, inside in icons(rng):
    check_icon(name, inside)
check_pictures(rng)
print(f"{passed} passed, {failed} failed")
