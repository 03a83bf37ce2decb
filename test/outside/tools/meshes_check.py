"""Meshes between scc shape and trimesh: what trimesh makes, in every format that it writes, is read and mended; what is
written is read by trimesh, watertight, with the same volume; so are the parts of scc decompose, all of them convex. With `--models FOLDER` after the two folders, the files of
that folder (trimesh's `models`, say) are read too, and what came of each is counted.
"""

import base64
import collections
import json
import os
import re
import subprocess
import sys
from fractions import Fraction

import numpy as np
import trimesh
from trimesh import creation

from common import Run

MEND = ["--weld", "--orient", "--merge"]
READ = ("off", "obj", "stl", "ply", "glb", "gltf", "3mf")
SECONDS = 600
LARGEST = 3_000_000


def shapes():
    turned = trimesh.transformations.euler_matrix(0.1, 0.2, 0.3)
    yield "box", creation.box(), True
    yield "box, turned", creation.box(transform=turned), True
    yield "icosphere", creation.icosphere(subdivisions=1), True
    yield "uv_sphere", creation.uv_sphere(count=[8, 8]), True
    yield "capsule", creation.capsule(count=[8, 8]), True
    yield "cylinder", creation.cylinder(1, 2, sections=12), True
    yield "cone", creation.cone(1, 2, sections=12), True
    yield "torus", creation.torus(2, 0.5, major_sections=12, minor_sections=8), False
    yield "annulus", creation.annulus(1, 2, 1, sections=12), False
    yield "axis", creation.axis(), False


def whole_gltf(parts):
    """As one file, with the data inside."""
    root = json.loads(parts["model.gltf"])
    for b in root["buffers"]:
        b["uri"] = "data:application/octet-stream;base64," + base64.b64encode(parts[b["uri"]]).decode()
    return json.dumps(root)


def export(mesh, kind):
    data = mesh.export(file_type=kind)
    if isinstance(data, dict):
        data = whole_gltf(data)
    return data.encode() if isinstance(data, str) else data


def sizes(text):
    found = re.search(r"^vertices: (\d+), edges: (\d+), faces: (\d+)$", text, re.M)
    return tuple(map(int, found.groups())) if found else None


def same_points(run, name, path, mesh):
    """The box around all is that of trimesh, to single precision."""
    done = run.call("shape", "--json", "--hull", path)
    report = json.loads(done.stdout)
    points = np.array([[float(Fraction(x)) for x in v["position"]] for v in report["vertices"]])
    gap = np.abs(np.array([points.min(0), points.max(0)]) - mesh.bounds).max()
    run.ok(gap < 1e-6, f"{name}: the box is off by {gap}")


def read_back(run, name, path, convex):
    """scc writes, and trimesh reads."""
    for ending in ("off", "obj", "stl", "ply"):
        out = run.path("out." + ending)
        done = run.call("shape", *(MEND if convex else ["--hull"]), path, "-o", out, "--round", "--json")
        report = json.loads(done.stdout)
        if not report.get("accepted"):
            run.skip(f"{name}, {ending}", "coordinates are rounded, and it is not quite convex")
            continue
        volume = float(Fraction(report["mass_properties"]["volume"]))
        if ending == "off" and max(len(f["corners"]) for f in report["faces"]) > 4:
            run.skip(name, "trimesh fails on faces of more than four corners in OFF files")
            continue
        mesh = trimesh.load(out, force="mesh")
        run.ok(mesh.is_watertight and mesh.is_winding_consistent, f"{name}, {ending}: not watertight")
        run.ok(abs(mesh.volume - volume) < 1e-6 * abs(volume), f"{name}, {ending}: {mesh.volume}, not {volume}")


def made(run):
    for name, mesh, convex in shapes():
        for kind in ("off", "obj", "stl", "stl_ascii", "ply", "glb", "gltf", "3mf"):
            path = run.path("in." + kind.split("_")[0])
            with open(path, "wb") as file:
                file.write(export(mesh, kind))
            done = run.call("shape", *MEND, path)
            if run.ok(sizes(done.stdout) is not None, f"{name}, {kind}: {done.stderr[:200]}"):
                same_points(run, f"{name}, {kind}", path, mesh)
        read_back(run, name, path, convex)
        read_back(run, name + ", hull", path, False)


def cubes(cells):
    """The boundary of a solid of unit cubes."""
    points, faces = {}, []
    for cell in cells:
        for axis in range(3):
            for side in (0, 1):
                step = np.eye(3, dtype=int)[axis] * (2 * side - 1)
                if tuple(np.array(cell) + step) in cells:
                    continue
                u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
                start = np.array(cell) + side * np.eye(3, dtype=int)[axis]
                ring = [tuple(start), tuple(start + u), tuple(start + u + v), tuple(start + v)]
                face = [points.setdefault(p, len(points)) for p in ring]
                faces.append(face if side else face[::-1])
    return trimesh.Trimesh(np.array(list(points)), trimesh.geometry.triangulate_quads(faces), process=False)


def spiked(count):
    """A sphere of triangles, every third corner of which is pulled out."""
    ball = creation.icosphere(subdivisions=count)
    far = np.where(np.arange(len(ball.vertices)) % 3 == 0, 1.5, 1.0)
    rounded = np.round(ball.vertices * far[:, None] * 1024) / 1024
    return trimesh.Trimesh(rounded, ball.faces, process=False)


def concave():
    """Names, and files or meshes."""
    yield "clamp.obj", "specs/models/parts/clamp.obj"
    yield "ell.off", "test/cli/ell.off"
    yield "hollow.off", "test/cli/hollow.off"
    square = [(x, y, 0) for x in range(4) for y in range(4)]
    yield "U", cubes({(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 0, 1), (2, 0, 1)})
    yield "ring of cubes", cubes({c for c in square if c not in [(1, 1, 0), (1, 2, 0), (2, 1, 0), (2, 2, 0)]})
    yield "hollow cube", cubes({(x, y, z) for x in range(3) for y in range(3) for z in range(3)} - {(1, 1, 1)})
    yield "star", spiked(0)
    yield "star of 320 faces", spiked(2)


def in_floats(path):
    """An OBJ file whose fractions p/q are floats."""
    with open(path, encoding="utf-8") as file:
        text = re.sub(r"(-?\d+)/(\d+)", lambda m: repr(int(m[1]) / int(m[2])), file.read())
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def parts_of(run, name, source):
    """scc cuts it into parts, of which trimesh makes a mesh each. Floats: volumes agree to 1e-9 of the whole."""
    path, out = run.path("solid.obj"), run.path("parts.obj")
    if isinstance(source, str):
        run.call("shape", source, "-o", path)
    else:
        with open(path, "wb") as file:
            file.write(export(source, "obj"))
    whole = trimesh.load(path, force="mesh")
    done = run.call("decompose", path, "-o", out, "--json")
    if not run.ok(done.returncode == 0, f"{name}: {done.stdout[-300:]}"):
        return
    report = json.loads(done.stdout)
    wanted = float(Fraction(report["volume"]))
    run.ok(abs(whole.volume - wanted) < 1e-9 * wanted, f"{name}: volume {whole.volume} in trimesh, not {wanted}")
    in_floats(out)
    parts = trimesh.load(out, force="scene", split_objects=True, process=False).geometry
    run.ok(len(parts) == len(report["parts"]), f"{name}: {len(parts)} parts, not {len(report['parts'])}")
    bad = [part for part, mesh in parts.items()
           if not (mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0 and mesh.is_convex)]
    run.ok(not bad, f"{name}: not watertight and convex: {bad}")
    total = sum(mesh.volume for mesh in parts.values())
    run.ok(abs(total - wanted) < 1e-9 * wanted, f"{name}: the parts have the volume {total}, not {wanted}")


def outcome(run, path):
    if os.path.getsize(path) > LARGEST:
        return "left out: more than 3 MB"
    try:
        done = run.call("shape", *MEND, path, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return f"more than {SECONDS} s"
    run.ok(done.returncode in (0, 3, 74), f"{path}: exit code {done.returncode}")
    if "convex closed polyhedron: yes" in done.stdout:
        return "a convex solid"
    if sizes(done.stdout):
        return "read"
    print(f"  {os.path.basename(path)}: {done.stderr.splitlines()[0][-120:] if done.stderr else done.returncode}")
    return "refused"


def others(run, folder):
    table = collections.defaultdict(collections.Counter)
    for place, _, names in sorted(os.walk(folder)):
        for name in sorted(names):
            ending = name.rsplit(".", 1)[-1].lower()
            if ending in READ:
                table[ending][outcome(run, os.path.join(place, name))] += 1
    for ending in READ:
        print(f"  {ending}: " + ", ".join(f"{n} {what}" for what, n in sorted(table[ending].items())))


def main():
    run = Run("Meshes between scc and trimesh")
    made(run)
    for name, source in concave():
        parts_of(run, name, source)
    if sys.argv[3:4] == ["--models"]:
        others(run, sys.argv[4])
    run.end()


main()
