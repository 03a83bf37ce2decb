"""Sets of parameters. The first are written by hand, as the schema says; the expected values are found by hand."""

import json
import math
import os
import subprocess
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

from shapecalculus import LimitExceeded, ModelRefused, Polyhedron, Where, wheres
from tests.support import MODEL, WithOracle, program


def constraint(relation, bound, **coefficients):
    return {
        "coefficients": {name: "%d/1" % a for name, a in coefficients.items()},
        "relation": relation,
        "bound": "%d/1" % bound,
    }


def between(name, low, high, relation):
    return [constraint(relation, -low, **{name: -1}), constraint(relation, high, **{name: 1})]


RANGE = between("y", -5, 5, "<=") + between("z", -5, 5, "<=")
SQUARE = between("y", -2, 2, "<") + between("z", -2, 2, "<")
NOTHING = {"pieces": [], "measure": "0/1"}

CUBES = {
    "parameters": ["y", "z"],
    "pieces": [SQUARE],
    "measure": "16/1",
    "probability": "4/25",
    "range": RANGE,
    "fails": {
        "pieces": [
            between("y", -2, 2, "<") + [constraint("<=", -2, z=1), constraint("<=", 5, z=-1)],
            between("y", -2, 2, "<") + [constraint("<=", -2, z=-1), constraint("<=", 5, z=1)],
            between("z", -5, 5, "<=") + [constraint("<=", -2, y=1), constraint("<=", 5, y=-1)],
            between("z", -5, 5, "<=") + [constraint("<=", -2, y=-1), constraint("<=", 5, y=1)],
        ],
        "measure": "84/1",
    },
    "unknown": NOTHING,
}


class Sets(unittest.TestCase):
    def test_outcomes(self):
        where = Where.from_json(CUBES)
        for y in range(-5, 6):
            for z in range(-5, 6):
                expected = abs(y) < 2 and abs(z) < 2
                self.assertEqual(where.contains((y, z)), expected)
                self.assertEqual(where.outcome({"z": z, "y": y}), "holds" if expected else "fails")
        almost = Fraction(2) - Fraction(1, 10**300)
        self.assertTrue(where.contains((almost, "-1.9")))
        self.assertTrue(where.contains([Decimal("1.5"), 0.25]))
        self.assertEqual((where.probability, where.holds.measure), (Fraction(4, 25), 16))
        self.assertEqual(where.probability_between, (Fraction(4, 25), Fraction(4, 25)))
        self.assertTrue(where.unknown.is_empty)
        self.assertFalse(where.fails.is_empty)

    def test_wrong_points(self):
        where = Where.from_json(CUBES)
        for point in ((1,), (1, 2, 3), "12", {"y": 1}, {"y": 1, "z": 2, "w": 3}, (1, float("nan"))):
            with self.assertRaises(ValueError):
                where.contains(point)
        with self.assertRaises(ValueError):
            where.outcome((6, 0))

    def test_matrices(self):
        square = Where.from_json(CUBES).holds.pieces[0]
        self.assertEqual(square.A, ((-1, 0), (1, 0), (0, -1), (0, 1)))
        self.assertEqual((square.b, square.relations), ((2, 2, 2, 2), ("<",) * 4))
        line = Polyhedron.from_json(["s", "t"], [constraint("=", -2, s=2, t=-1)])
        self.assertEqual((line.A, line.b), (((2, -1),), (-2,)))
        self.assertTrue(line.contains((Fraction(1, 3), Fraction(8, 3))))
        self.assertFalse(line.contains((Fraction(1, 3), Fraction(8, 3) + Fraction(1, 10**50))))
        self.assertTrue(Polyhedron.from_json([], []).contains(()))

    def test_unknown(self):
        below, rest = [constraint("<", 1, x=1)], [constraint("<=", -1, x=-1)]
        answer = {
            "parameters": ["x"], "pieces": [below], "measure": "1/1", "probability": None,
            "probability_between": ["1/4", "1/1"], "range": between("x", 0, 4, "<="), "fails": NOTHING,
            "unknown": {"pieces": [rest], "measure": "3/1"},
        }
        where = Where.from_json(answer)
        self.assertIsNone(where.probability)
        self.assertEqual(where.probability_between, (Fraction(1, 4), 1))
        self.assertEqual([where.outcome([x]) for x in (0, 1, 4)], ["holds", "unknown", "unknown"])

    def test_refused(self):
        with self.assertRaises(ValueError):
            Polyhedron.from_json(["x"], [constraint("<", 1, y=1)])
        with self.assertRaises(ValueError):
            Polyhedron.from_json(["x"], [constraint(">", 1, x=1)])

    def test_report(self):
        report = {"properties": [{"name": "meets", "where": CUBES}, {"name": "other"}]}
        found = wheres(report)
        self.assertEqual(list(found), ["meets"])
        self.assertEqual(found["meets"], Where.from_json(CUBES))


RANGED = (
    MODEL.replace("param speed = 2", "param speed = 2\nparam y in [-5, 5]\nparam z in (-5, 5]")
    .replace("at translate (7,0,0)", "at translate (7,y,z)")
    .replace("eventually", "possibly")
)


class Answers(WithOracle):
    """What the program says of two cubes, one of which comes with an offset that is not known."""

    def judge(self, where):
        self.assertEqual((where.parameters, where.probability), (("y", "z"), Fraction(4, 25)))
        self.assertEqual(where.holds.measure + where.fails.measure + where.unknown.measure, 100)
        for y, z in ((0, 0), (2, 0), ("1.99", "-1.99"), (5, 5), (-2, 1)):
            inside = abs(Fraction(y)) < 2 and abs(Fraction(z)) < 2
            self.assertEqual(where.outcome((y, z)), "holds" if inside else "fails")
        with self.assertRaises(ValueError):
            where.outcome((0, -5))

    def test_oracle(self):
        self.judge(self.oracle.check(RANGED, where=True).where["meets"])
        on_line = self.oracle.check(RANGED, where=True, parameters={"z": "1.5"}, seconds=60).where["meets"]
        self.assertEqual((on_line.parameters, on_line.probability), (("y",), Fraction(2, 5)))
        with self.oracle.batch() as batch:
            later = batch.check(RANGED, where=True)
        self.judge(later.result().where["meets"])
        with self.assertRaises(ModelRefused):
            self.oracle.check(MODEL, where=True)
        with self.assertRaises(LimitExceeded):
            self.oracle.check(RANGED, states=10**9)

    def test_verdicts(self):
        found = self.oracle.check(RANGED)
        self.assertEqual((found.verdicts, found.where), ({"meets": "violated"}, {}))
        ranges = found.report["properties"][0]["over"]["ranges"]
        self.assertEqual([r["parameter"] for r in ranges], ["y", "z"])
        narrowed = {"y": (-1, Fraction(1, 2)), "z": ["0", 1]}
        self.assertEqual(self.oracle.check(RANGED, parameters=narrowed).verdicts, {"meets": "holds"})
        self.assertEqual(self.oracle.check(MODEL).verdicts, {"meets": "holds"})
        with self.assertRaises(ModelRefused):
            self.oracle.check(RANGED, parameters={"y": (0, 6)})
        with self.assertRaises(ModelRefused):
            self.oracle.load_model(RANGED)

    def test_numbers_by_start(self):
        asked = "check far : E = ? [ x(p) + y at 1 ]\ncheck bound : E = ? [ time U bound(p, q) ]\n"
        found = self.oracle.check(RANGED + asked, where=True)
        far, bound = (found[name].starts["greatest"] for name in ("far", "bound"))
        self.assertEqual((far.low, far.high, far.mean), (-3, 7, (Fraction(2), Fraction(2))))
        self.assertEqual(far.at({"y": Fraction(1, 3), "z": 0}), (Fraction(7, 3), Fraction(7, 3)))
        self.assertEqual((bound.low, bound.high, bound.mean), (Fraction(5, 2), None, (math.inf, math.inf)))
        self.assertEqual(bound.at((0, 0)), (Fraction(5, 2), Fraction(5, 2)))
        self.assertEqual(bound.at((3, 0)), (math.inf, math.inf))
        self.assertEqual({part.low_form is None for part in far.parts + bound.parts}, {True, False})
        with self.assertRaises(ValueError):
            far.at((6, 0))
        with self.assertRaises(ValueError):
            self.oracle.check(RANGED + asked)["far"].starts["least"].at((0, 0))
        self.assertEqual(found["meets"].starts, {})

    def test_numbers_that_are_lost(self):
        model = (
            "timestep 1\nparam d in [0, 1]\nprocess w = box(1, 1, 1) mass 1 at translate (d, 0, 0) [nil]\n"
            "fixed out = box(1, 9, 9) absorb at translate (-2, 0, 0)\n"
            "motion w = choose { (1, 0, 0) weight 1, (-1, 0, 0) weight 1 }\n"
            "check once : E = ? [ x(w) at 1 ]\ncheck twice : E = ? [ x(w) at 3/2 ]\ncheck gone : E = ? [ time U gone(w) ]\n"
        )
        found = self.oracle.check(model, where=True, depth=9)
        once, twice, gone = (found[name].starts["least"] for name in ("once", "twice", "gone"))
        half = Fraction(1, 2)
        self.assertEqual((once.low, once.high, once.mean, once.unknown.measure), (0, 1, (half, half), 0))
        self.assertEqual((once.at((half,)), once.at((0,))), ((half, half), (None, None)))
        self.assertEqual((twice.low, twice.high, twice.mean, twice.unknown.measure), (half, 1, None, half))
        self.assertIsNone(gone.unknown)

    def test_starts(self):
        simple = self.oracle.load_model(RANGED, start="simple")
        self.assertEqual(simple.parameters, {"speed": 2, "y": 0, "z": 0})
        self.assertEqual(self.oracle.evaluate(simple, "possibly bound(p, q)").verdict, "holds")
        narrow = self.oracle.load_model(RANGED, parameters={"y": (2, 4)}, start="simple")
        self.assertEqual(narrow.parameters, {"speed": 2, "y": 3, "z": 0})
        self.assertEqual(self.oracle.evaluate(narrow, "possibly bound(p, q)").verdict, "violated")
        seventh = self.oracle.load_model(RANGED, parameters={"z": 1}, start="random", seed=7)
        again = self.oracle.load_model(RANGED, parameters=seventh.parameters)
        self.assertEqual((again.parameters, again.parameters["z"]), (seventh.parameters, 1))
        self.assertEqual(self.oracle.load_model(RANGED, parameters={"z": 1}, seed=7).parameters, seventh.parameters)
        self.assertNotEqual(self.oracle.load_model(RANGED, seed=8).parameters["y"], seventh.parameters["y"])
        for wrong in ({"start": "random"}, {"start": "simple", "seed": 1}):
            with self.assertRaises(ValueError):
                self.oracle.load_model(RANGED, **wrong)

    def test_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cubes.sc")
            with open(path, "w", encoding="utf-8") as file:
                file.write(RANGED)
            done = subprocess.run([program(), "check", "--where", "--json", path], stdout=subprocess.PIPE, timeout=600)
        self.judge(wheres(json.loads(done.stdout))["meets"])
