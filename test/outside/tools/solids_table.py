"""Which solids of a folder of meshes come through scc, and why the others do not.

  solids_table.py SCC FOLDER [--seconds S] [--triangles N] [--json FILE]

Trimesh judges each file, without scc: its mesh is closed if, after equal points are made one, each edge is in two
triangles. It does not read VRML and X3D: the program assimp turns those into PLY first, if it is installed. A closed
solid comes through if one of these commands accepts it: scc shape --weld --orient --merge; scc decompose --weld
--orient; the same with --union; or with the option that the hint of a refusal names. Of a file that is not closed
only the exit code counts. The table has a column for each command, and below it the refused files with their reasons.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import re
import subprocess
import tempfile

import numpy as np
import trimesh

READ = ("off", "obj", "stl", "ply", "glb", "gltf", "3mf", "wrl", "x3d", "x3dv")
BY_ASSIMP = ("wrl", "x3d", "x3dv")
STAGES = (
    ("shape", ["shape", "--weld", "--orient", "--merge"]),
    ("decompose", ["decompose", "--weld", "--orient"]),
    ("union", ["decompose", "--weld", "--orient", "--union"]),
)
ALLOWED = (0, 3, 4)
COLUMNS = ("files", "closed", "shape", "decompose", "union", "hint", "late", "refused", "not closed", "not judged")


def meshes_of(path, ending):
    """The triangles of a file as trimesh reads them, in one mesh; an exception if it reads none."""
    if ending not in BY_ASSIMP:
        return trimesh.load(path, force="mesh", process=False, skip_materials=True)
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.ply")
        subprocess.run(["assimp", "export", path, out, "-ptv", "-tri"], capture_output=True, timeout=60, check=True)
        return trimesh.load(out, force="mesh", process=False)


def joined(mesh):
    """Triangles between points of which no two are equal, none of them flat to a line or there twice."""
    _, same = np.unique(np.asarray(mesh.vertices, dtype=float) + 0.0, axis=0, return_inverse=True)
    faces = np.asarray(same).reshape(-1)[np.asarray(mesh.faces)]
    whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    faces = faces[whole]
    _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
    return faces[np.sort(first)]


def judge(path):
    """What trimesh has to say: "closed", "open" or "not judged", and the number of triangles."""
    try:
        mesh = meshes_of(path, path.rsplit(".", 1)[-1].lower())
        if not len(mesh.faces) or not np.isfinite(mesh.vertices).all():
            return "not judged", 0
        faces = joined(mesh)
        edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        _, counts = np.unique(edges, axis=0, return_counts=True)
        return ("closed" if len(counts) and (counts == 2).all() else "open"), len(faces)
    except Exception:
        return "not judged", 0


def call(scc, words, seconds):
    """Exit code and the first message; None and a word where the time was over and scc did not stop by itself."""
    try:
        done = subprocess.run([scc, *words, "--seconds", str(seconds)], capture_output=True, text=True,
                              errors="replace", timeout=4 * seconds + 60)
    except subprocess.TimeoutExpired:
        return None, "does not stop"
    return done.returncode, " ".join(done.stderr.split())


def short(message, path):
    found = re.search(r"error\[(SC\d+)\]: (.*?)(?= (?:error|warning|hint|note)\b|$)", message.replace(path, "FILE"))
    return f"{found[1]}: {found[2][:150]}" if found else message[:150]


def outcome(scc, path, seconds):
    """The command that accepts the file, or "late" or "refused"; the reason; exit codes that must not be."""
    bad, reasons, late = [], [], False
    options = []
    for name, words in STAGES:
        code, message = call(scc, [*words, path], seconds)
        if code == 0:
            return name, "", bad
        if code not in ALLOWED:
            bad.append(f"{' '.join(words)}: {code}")
        late = late or code == 4
        reasons.append(short(message, path))
        options += re.findall(r"(--grid \S+|--snap \S+)", message)
    for option in dict.fromkeys(options):
        words = ["shape" if "snap" in option else "decompose", *option.split(), "--weld", "--orient"]
        code, message = call(scc, [*words, path], seconds)
        if code == 0:
            return "hint", option, bad
    return ("late" if late else "refused"), " | ".join(dict.fromkeys(reasons)), bad


def files(folder):
    for place, _, names in sorted(os.walk(folder)):
        for name in sorted(names):
            if name.rsplit(".", 1)[-1].lower() in READ:
                yield os.path.join(place, name)


def one(arguments):
    scc, path, seconds, triangles = arguments
    verdict, size = judge(path)
    if size > triangles:
        return path, "large", size, "", "", []
    if verdict == "closed":
        return path, verdict, size, *outcome(scc, path, seconds)
    code, message = call(scc, [*STAGES[0][1], path], seconds)
    return path, verdict, size, str(code), short(message, path), [] if code in ALLOWED else [f"shape: {code}"]


def main():
    reader = argparse.ArgumentParser()
    reader.add_argument("scc")
    reader.add_argument("folder")
    reader.add_argument("--seconds", type=int, default=60)
    reader.add_argument("--triangles", type=int, default=5000)
    reader.add_argument("--json")
    options = reader.parse_args()
    table, rows, large = collections.defaultdict(collections.Counter), [], 0
    work = [(options.scc, path, options.seconds, options.triangles) for path in files(options.folder)]
    with concurrent.futures.ProcessPoolExecutor(max_workers=1) as pool:
        for row in pool.map(one, work):
            path, verdict, size, how, why, bad = row
            rows.append(row)
            line = table[path.rsplit(".", 1)[-1].lower()]
            if verdict == "large":
                large += 1
                continue
            line["files"] += 1
            line[{"open": "not closed"}.get(verdict, verdict)] += 1
            if verdict == "closed":
                line[how] += 1
            if bad or verdict == "closed" and how in ("late", "refused", "hint"):
                print(f"{os.path.relpath(path, options.folder)} ({size} triangles): {how} {why} {' '.join(bad)}", flush=True)
    print("| format | " + " | ".join(COLUMNS) + " |")
    print("|---" * (len(COLUMNS) + 1) + "|")
    for ending in READ:
        print(f"| {ending} | " + " | ".join(str(table[ending][c]) for c in COLUMNS) + " |")
    total = sum(table.values(), collections.Counter())
    through = sum(total[how] for how in ("shape", "decompose", "union", "hint"))
    share = 100 * through / total["closed"] if total["closed"] else 100
    print(f"{total['closed']} closed solids, of which {through} come through ({share:.1f} %); {large} files of more "
          f"than {options.triangles} triangles were left out")
    if options.json:
        with open(options.json, "w", encoding="utf-8") as out:
            json.dump(rows, out, indent=0)


if __name__ == "__main__":
    main()
