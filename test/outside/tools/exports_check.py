"""Files of scc export in programs of others: gltf-validator and trimesh, view3dscene's converter, VTK, simulariumio and
Python's csv; what they read is held against the exact states of scc trace."""

import contextlib
import csv
import io
import json
import os
import shutil
import struct
import subprocess
import tarfile
import xml.etree.ElementTree as xml
from fractions import Fraction

import numpy
import trimesh
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from common import MODELS, Run, models, npm_pack

VALIDATOR = "gltf-validator@2.0.0-dev.3.10"
STEPS = ["--steps", "24"]
# With turns, absorption, bonds that come and go, bodies of several parts, one far larger than the others.
MOVING = ["hexokinase", "tumble", "outlet", "docking", "ring", "gears", "capsid", "topple"]


# Exact states


def vector(texts):
    return [Fraction(t) for t in texts]


def turn(q, p):
    """The rotation of a quaternion w, x, y, z, of any length."""
    w, u = q[0], q[1:]

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    once = cross(u, p)
    twice = cross(u, once)
    norm = w * w + sum(x * x for x in u)
    return [p[i] + 2 * (w * once[i] + twice[i]) / norm for i in range(3)]


class Told:
    """A run as scc trace tells it, and the bodies of the model as scc view does."""

    def __init__(self, run, name):
        self.model = f"{MODELS}/{name}.sc"
        lines = [json.loads(line) for line in run.call("trace", self.model, *STEPS).stdout.splitlines()]
        self.rows = [(Fraction(line["time"]), line["state"]) for line in lines if "state" in line]
        self.at = dict(self.rows)
        data = run.path(f"{name}.data.json")
        run.call("view", self.model, "--data", "--graph", "0", "-o", data)
        with open(data, encoding="utf-8") as file:
            page = json.load(file)
        os.remove(data)
        self.leaves = page["leaves"]
        self.solids = page["solids"]
        self.number = {leaf["name"]: i for i, leaf in enumerate(self.leaves)}

    def bodies(self, state):
        """The leaves that are there, with where they are and how they are turned."""
        for process in state["processes"]:
            for leaf in process["leaves"]:
                yield self.number[leaf["name"]], vector(leaf["position"]), vector(leaf.get("turned", "1000"))

    def corners(self, leaf, place, turned):
        """Of each part, in the world."""
        for part in self.leaves[leaf]["parts"]:
            offset = vector(part["offset"])
            corners = [vector(v) for v in self.solids[part["solid"]]["vertices"]]
            placed = [turn(turned, [a + b for a, b in zip(offset, v)]) for v in corners]
            yield [[a + b for a, b in zip(place, v)] for v in placed]

    def everything(self, state):
        return [v for body in self.bodies(state) for part in self.corners(*body) for v in part]


def floats(points):
    return numpy.array([[float(x) for x in p] for p in points])


def near(a, b, size):
    return numpy.allclose(a, b, rtol=0, atol=2e-6 * max(1.0, size))


# glTF


def upright(points):
    """z up becomes y up."""
    return points[:, [0, 2, 1]] * [1, 1, -1]


def chunks(path):
    with open(path, "rb") as file:
        bytes_ = file.read()
    length = struct.unpack_from("<I", bytes_, 12)[0]
    return json.loads(bytes_[20 : 20 + length]), bytes_[20 + length + 8 :]


def numbers(document, binary, index):
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
    offset = view["byteOffset"] + accessor["byteOffset"]
    found = numpy.frombuffer(binary, "<f4", accessor["count"] * width, offset).astype(float)
    return found if width == 1 else found.reshape(-1, width)


def channels(document, binary):
    """(leaf, path) -> times and values; the root is left out."""
    found = {}
    for animation in document.get("animations", []):
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            key = (channel["target"]["node"] - 1, channel["target"]["path"])
            found[key] = tuple(numbers(document, binary, sampler[end]) for end in ("input", "output"))
    return found


def gltf(run, name, told):
    path = run.path(f"{name}.glb")
    run.call("export", told.model, *STEPS, "-o", path)
    document, binary = chunks(path)
    first = told.rows[0][1]
    points = floats(told.everything(first))
    size = numpy.abs(points).max()

    scene = trimesh.load(path, process=False)
    seen = scene.to_mesh().vertices
    expected = upright(points)
    low_high = numpy.array([expected.min(0), expected.max(0)])
    run.ok(near(scene.bounds, low_high, size), f"{name}: trimesh sees {scene.bounds}, not {low_high}")
    if len(points) <= 1000:
        gaps = numpy.abs(expected[:, None] - seen[None]).max(2).min(1)
        run.ok(gaps.max() < 2e-6 * max(1.0, size), f"{name}: trimesh misses a corner by {gaps.max()}")

    # at all instants of the trace: places between keys by even motion, as players do
    tracks = channels(document, binary)
    centre = document["nodes"][0]["translation"]
    centre = numpy.array([centre[0], -centre[2], centre[1]])
    last = {time: state for time, state in told.rows}
    for time, state in last.items():
        for leaf, place, turned in told.bodies(state):
            place = floats([place])[0]
            if (leaf, "translation") in tracks:
                times, values = tracks[leaf, "translation"]
                shown = [numpy.interp(float(time), times, values[:, i]) for i in range(3)]
            else:
                shown = document["nodes"][1 + leaf].get("translation", [0, 0, 0])
            run.ok(near(numpy.array(shown) + centre, place, size), f"{name}: leaf {leaf} at {time}: {shown}, not {place}")
            if (leaf, "rotation") in tracks:
                times, values = tracks[leaf, "rotation"]
                key = numpy.abs(times - float(time)).argmin()
                if abs(times[key] - float(time)) < 1e-6:
                    greatest = max(abs(x) for x in turned)
                    q = numpy.array([float(x / greatest) for x in turned[1:] + turned[:1]])
                    q = q / numpy.linalg.norm(q)
                    run.ok(abs(abs(q @ values[key]) - 1) < 1e-6, f"{name}: leaf {leaf} is turned otherwise at {time}")
    for (leaf, path_), (_, values) in tracks.items():
        if path_ == "rotation":
            half = numpy.clip((values[:-1] * values[1:]).sum(1), -1, 1)
            run.ok((2 * numpy.arccos(half)).max() < 0.1001, f"{name}: leaf {leaf} turns far between two keys")
    gone = set(range(len(told.leaves))) - {body[0] for body in told.bodies(told.rows[-1][1])}
    scaled = {leaf for leaf, what in tracks if what == "scale"}
    run.ok(gone == scaled, f"{name}: {scaled} vanish, and {gone} are gone")
    return path


JUDGE = """
const validator = require("./package"), fs = require("fs");
const one = (path) => validator.validateBytes(new Uint8Array(fs.readFileSync(path))).then((r) => r.issues, () => null);
Promise.all(process.argv.slice(2).map(one)).then((all) => console.log(JSON.stringify(all)));
"""


def validate(run, paths):
    with npm_pack(VALIDATOR, run.folder) as pack:
        pack.extractall(run.folder, **({"filter": "data"} if hasattr(tarfile, "data_filter") else {}))
    with open(run.path("judge.js"), "w", encoding="utf-8") as file:
        file.write(JUDGE)
    # A validator that accepts everything would be of no use.
    broken = run.path("broken.glb")
    with open(paths[0], "rb") as file, open(broken, "wb") as to:
        to.write(file.read().replace(b'"mesh":0', b'"mesh":9'))
    done = subprocess.run(["node", run.path("judge.js"), *paths, broken], capture_output=True, text=True, timeout=6000)
    verdicts = json.loads(done.stdout)
    for path, issues in zip(paths, verdicts):
        good = issues is not None and issues["numErrors"] == issues["numWarnings"] == 0
        run.ok(good, f"{os.path.basename(path)}: {issues and issues['messages'][:3]}")
    run.ok(verdicts[-1] is None or verdicts[-1]["numErrors"] > 0, "a mesh that is not there was taken for valid")


# ParaView


def series(run, name, told):
    path = run.path(f"{name}.pvd")
    run.call("export", told.model, *STEPS, "-o", path)
    sets = xml.parse(path).getroot().findall("Collection/DataSet")
    times = sorted({time for time, _ in told.rows})
    run.ok([float(s.get("timestep")) for s in sets] == [float(t) for t in times], f"{name}: other times")
    for time, entry in zip(times, sets):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(run.path(entry.get("file")))
        reader.Update()
        drawn = reader.GetOutput()
        points = vtk_to_numpy(drawn.GetPoints().GetData())
        arrays = drawn.GetCellData()
        cells = {key: vtk_to_numpy(arrays.GetArray(key)) for key in ("leaf", "part", "bond")}
        names = drawn.GetFieldData().GetAbstractArray("leaves")
        run.ok(drawn.GetFieldData().GetArray("TimeValue").GetValue(0) == float(time), f"{name}: the time of a step")
        run.ok([names.GetValue(i) for i in range(names.GetNumberOfValues())] == [l["name"] for l in told.leaves],
               f"{name}: other names")
        state = told.at[time]
        bonds = sum(len(process["bonds"]) for process in state["processes"])
        run.ok(drawn.GetNumberOfLines() == bonds, f"{name}: {drawn.GetNumberOfLines()} lines, {bonds} bonds")
        wanted = {}
        for leaf, place, turned in told.bodies(state):
            for part, corners in enumerate(told.corners(leaf, place, turned)):
                faces = told.solids[told.leaves[leaf]["parts"][part]["solid"]]["faces"]
                wanted[leaf, part] = [floats([corners[c] for c in face["corners"]]) for face in faces]
        same = sum(map(len, wanted.values())) == drawn.GetNumberOfPolys()
        for i in range(bonds, drawn.GetNumberOfCells()):
            cell = drawn.GetCell(i).GetPointIds()
            shown = points[[cell.GetId(k) for k in range(cell.GetNumberOfIds())]]
            left = wanted.get((cells["leaf"][i], cells["part"][i]), [])
            # faces come in the order of the solid; every coordinate is the nearest float
            same = same and bool(left) and numpy.array_equal(left.pop(0), shown)
        run.ok(same, f"{name}: other faces at {time}")


# The others


def obj(run, name, told):
    path = run.path(f"{name}.obj")
    run.call("export", told.model, *STEPS, "-o", path)
    mesh = trimesh.load(path, process=False, force="mesh")
    points = floats(told.everything(told.rows[-1][1]))
    run.ok(numpy.array_equal(mesh.bounds, [points.min(0), points.max(0)]), f"{name}: the state has other bounds")
    run.ok(mesh.volume > 0, f"{name}: faces look inward")


def table(run, name, told):
    path = run.path(f"{name}.csv")
    run.call("export", told.model, *STEPS, "--observe", "energy", "--observe", "time > 1", "-o", path)
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    run.ok([Fraction(row["time"]) for row in rows] == [time for time, _ in told.rows], f"{name}: other times")
    for row in rows:
        exact = all(row[f"{key} (float)"] == "" or float(row[f"{key} (float)"]) == float(Fraction(row[key]))
                    for key in ("time", "energy"))
        late = "true" if Fraction(row["time"]) > 1 else "false"
        run.ok(exact and row["time > 1"] == late, f"{name}: {row}")


def trajectory(run, name, told):
    from simulariumio import FileConverter, InputFileData

    path = run.path(f"{name}.simularium")
    run.call("export", told.model, *STEPS, "-o", path)
    with contextlib.redirect_stdout(io.StringIO()):
        data = FileConverter(InputFileData(file_path=path))._data
    agents = data.agent_data
    for frame, time in ((0, told.rows[0][0]), (len(agents.times) - 1, told.rows[-1][0])):
        if abs(agents.times[frame] - float(time)) > 1e-9:
            run.ok(False, f"{name}: frame {frame} is at {agents.times[frame]}, not {time}")
            continue
        state = told.at[time]
        bodies = list(told.bodies(state))
        bonds = sum(len(process["bonds"]) for process in state["processes"])
        run.ok(agents.n_agents[frame] == len(bodies) + bonds, f"{name}: {agents.n_agents[frame]} agents at {time}")
        places = {int(agents.unique_ids[frame][k]): k for k in range(len(bodies))}
        for leaf, place, turned in bodies:
            k = places[leaf]
            run.ok(numpy.array_equal(agents.positions[frame][k], floats([place])[0]), f"{name}: leaf {leaf} at {time}")
            x, y, z = agents.rotations[frame][k]
            rotation = trimesh.transformations.euler_matrix(x, y, z, "rxyz")[:3, :3]
            wanted = floats([turn(turned, [Fraction(i == j) for i in range(3)]) for j in range(3)]).T
            run.ok(numpy.allclose(rotation, wanted, atol=1e-9), f"{name}: leaf {leaf} is turned otherwise at {time}")
            shown = agents.types[frame][k]
            run.ok(shown.split("#")[0] == told.leaves[leaf]["template"], f"{name}: leaf {leaf} is a {shown}")
    for display in agents.display_data.values():
        if display.display_type.value == "OBJ":
            form = trimesh.load(run.path(display.url), process=False, force="mesh")
            run.ok(form.volume > 0, f"{name}: {display.url}")


def converter(run):
    """The converter of view3dscene; its package is fetched, not installed."""
    found = shutil.which("tovrmlx3d")
    if found or not shutil.which("apt-get"):
        return found
    folder = run.path("view3dscene")
    os.mkdir(folder)
    subprocess.run(["apt-get", "download", "view3dscene"], cwd=folder, capture_output=True, timeout=120)
    for package in os.listdir(folder):
        subprocess.run(["dpkg-deb", "-x", package, "."], cwd=folder, capture_output=True, timeout=120)
    program = os.path.join(folder, "usr/bin/tovrmlx3d")
    return program if os.path.exists(program) else None


def x3d(run, name, told, program):
    path = run.path(f"{name}.x3d")
    run.call("export", told.model, *STEPS, "-o", path)
    done = subprocess.run([program, path, "--encoding=xml"], capture_output=True, text=True, timeout=600)
    run.ok(done.returncode == 0 and "arning" not in done.stderr, f"{name}: {done.stderr[:300]}")
    written, read = xml.parse(path).getroot(), xml.fromstring(done.stdout)
    kinds = ["Transform", "Shape", "PositionInterpolator", "OrientationInterpolator", "TimeSensor", "ROUTE", "Coordinate"]
    for kind in kinds:
        pair = [len(list(root.iter(kind))) for root in (written, read)]
        run.ok(pair[0] == pair[1], f"{name}: {pair[1]} of {pair[0]} {kind} were read")
    ways = {node.get("DEF"): node for node in read.iter("PositionInterpolator")}
    size = numpy.abs(floats(told.everything(told.rows[0][1]))).max()
    moved = [float(x) for x in written.find("Scene/Transform/Transform").get("translation").split()]
    for leaf, place, _ in told.bodies(told.rows[-1][1]):
        if f"way_{leaf}" in ways:
            end = [float(x) for x in ways[f"way_{leaf}"].get("keyValue").replace(",", " ").split()][-3:]
            run.ok(near(numpy.array(end) + moved, floats([place])[0], size), f"{name}: leaf {leaf} ends at {end}")


def main():
    run = Run("exports, as other programs read them")
    program = converter(run)
    if program is None:
        run.skip("X3D", "there is no view3dscene")
    paths = []
    for name in models():
        told = Told(run, name)
        paths.append(gltf(run, name, told))
        table(run, name, told)
        if name in MOVING:
            series(run, name, told)
            obj(run, name, told)
            trajectory(run, name, told)
            if program:
                x3d(run, name, told, program)
    validate(run, paths)
    run.end()


main()
