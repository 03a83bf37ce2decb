"""Requests about models, to the program."""

import os
import subprocess
import sys
import unittest
from fractions import Fraction

from shapecalculus import FormulaRefused, ModelRefused, NotPossible, Oracle, Stopped, UnknownHandle
from tests.support import CLIENT, MODEL, WithOracle, program


class Models(WithOracle):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.model = cls.oracle.load_model(MODEL)

    def test_load(self):
        model = self.oracle.load_model(MODEL, parameters={"speed": Fraction(1, 2)})
        self.assertEqual(model.parameters, {"speed": Fraction(1, 2)})
        self.assertEqual([leaf.name for leaf in model.leaves], ["p", "q"])
        self.assertEqual([check.name for check in model.checks], ["meets"])
        self.assertEqual((model.rigid, model.resolution), (False, None))
        # The gap is 5.
        self.assertEqual(self.oracle.successors(model).transitions[0].label.duration, 10)
        self.oracle.release_model(model)
        with self.assertRaises(UnknownHandle):
            self.oracle.successors(model)

    def test_a_number_longer_than_python_reads(self):
        squares = "".join("param a%d = a%d * a%d\n" % (i + 1, i, i) for i in range(14))
        model = self.oracle.load_model("param a0 = 7\n" + squares)
        self.assertEqual(model.parameters["a14"], 7 ** 2 ** 14)
        self.oracle.release_model(model)

    def test_refused(self):
        with self.assertRaises(ModelRefused) as caught:
            self.oracle.load_model("process p = Nothing [nil]")
        diagnostic = caught.exception.data["diagnostics"][0]
        self.assertRegex(diagnostic["code"], "^SC[0-9]{4}$")
        self.assertEqual(diagnostic["place"]["start"]["line"], 1)

    def test_absorption(self):
        model = self.oracle.load_model(
            "import <solids> (Cube)\n"
            "process p = Cube(2) mass 1 velocity (1,0,0) [nil]\n"
            "fixed drain = Cube(2) absorb at translate (4,0,0)\n"
        )
        self.assertEqual([leaf.absorbs for leaf in model.leaves], [False, True])
        run = self.oracle.replay(model, [0, "absorb(p, drain)"])
        self.assertEqual(run.labels[-1].between, ("p", "drain"))
        after = self.oracle.successors(model, [0, 0]).state
        self.assertEqual(after.gone, ("p",))
        self.assertRaises(KeyError, after.leaf, "p")
        self.oracle.release_model(model)

    def test_successors(self):
        here = self.oracle.successors(self.model)
        self.assertEqual((here.path, here.time, here.ending), ((), 0, None))
        self.assertEqual([t.label.kind for t in here.transitions], ["time"])
        self.assertEqual(here.state.leaf("q").position, (7, 0, 0))
        self.assertEqual(here.state.process_of("p").velocity, (2, 0, 0))
        self.assertRaises(KeyError, here.state.leaf, "r")
        self.assertRaises(KeyError, here.state.process_of, "r")
        after = self.oracle.successors(self.model, states="all").transitions[0].state
        self.assertEqual(after.leaf("p").position, (5, 0, 0))
        self.assertIsNone(self.oracle.successors(self.model, states="none").state)

    def test_steps(self):
        first = self.oracle.step(self.model, (), 0)
        self.assertEqual((first.path, first.time), ((0,), Fraction(5, 2)))
        second = self.oracle.step(self.model, first.path, 0)
        self.assertEqual((second.label.kind, second.label.name), ("bind", "bond"))
        self.assertIn("Bind", " ".join(second.rules))
        bound = second.state.process_of("p")
        self.assertEqual((len(bound.leaves), [bond.name for bond in bound.bonds]), (2, ["bond"]))
        self.assertEqual(bound.velocity, (Fraction(3, 2), 0, 0))
        by_label = self.oracle.step(self.model, first.path, second.label.text)
        self.assertEqual(by_label, second)

    def test_ties(self):
        bodies = "".join(
            f"process {name} = Cube mass 1 velocity ({v},0,0) at translate ({x},0,0) [nil]\n"
            for name, v, x in (("o", 0, 0), ("u", 1, -1), ("w", -1, 1))
        )
        for setting, chance in (("drawn", Fraction(1, 2)), ("in_turn", None)):
            model = self.oracle.load_model(f"shape Cube = box(1,1,1)\ncollisions {setting}\n{bodies}")
            transitions = self.oracle.successors(model, states="none").transitions
            self.assertEqual([t.chance for t in transitions], [chance, chance])
            self.oracle.release_model(model)

    def test_a_choice_that_is_none(self):
        with self.assertRaises(NotPossible) as caught:
            self.oracle.step(self.model, (0,), 5)
        self.assertEqual(caught.exception.data["at"], 1)
        self.assertEqual(len(caught.exception.data["possible"]), 1)

    def test_replay(self):
        run = self.oracle.replay(self.model, choose="first", steps=10)
        self.assertEqual([label.kind for label in run.labels], ["time", "bind", "time", "strong"])
        self.assertEqual((run.steps, run.time, run.ending), (4, Fraction(9, 2), "quiescent"))
        self.assertEqual(run.lines[0]["type"], "header")
        again = self.oracle.replay(self.model, [0, {"choice": 0}, run.labels[2].text, 0], states="all")
        self.assertEqual(again.labels, run.labels)
        by_chance = self.oracle.replay(self.model, seed=3, states="ends")
        self.assertEqual(by_chance.labels, run.labels)
        self.assertEqual(self.oracle.replay(self.model, choose="random", seed=3, states="ends"), by_chance)
        halfway = self.oracle.replay(self.model, [], offset=1)
        self.assertEqual(halfway.lines[-2]["time"], "1/1")
        with self.assertRaises(NotPossible):
            self.oracle.replay(self.model, [0, 0, 0, 0, 0])

    def test_evaluate(self):
        self.assertIs(self.oracle.evaluate(self.model, "bound(p, q)").value, False)
        self.assertIs(self.oracle.evaluate(self.model, "bound(p, q)", (0, 0)).value, True)
        distance = self.oracle.evaluate(self.model, "x(q) - x(p)", (0,))
        self.assertEqual((distance.kind, distance.value), ("number", 2))
        undefined = self.oracle.evaluate(self.model, "1 / (x(p) - x(p))")
        self.assertIsNone(undefined.value)
        self.assertTrue(undefined.reason)
        temporal = self.oracle.evaluate(self.model, "eventually bound(p, q)", states=1000)
        self.assertEqual((temporal.kind, temporal.verdict), ("temporal", "holds"))
        self.assertTrue(temporal.report)
        with self.assertRaises(FormulaRefused):
            self.oracle.evaluate(self.model, "bound(p, nobody)")

    def test_batches(self):
        with self.oracle.batch() as batch:
            where = [batch.successors(self.model, path) for path in ((), (0,), (0, 0), (9,))]
            value = batch.evaluate(self.model, "x(p)")
        self.assertEqual([f.result().time for f in where[:3]], [0, Fraction(5, 2), Fraction(5, 2)])
        self.assertIsInstance(where[3].error(), NotPossible)
        self.assertEqual(value.result().value, 0)


class Limits(unittest.TestCase):
    @unittest.skipIf(program() is None, "no scc")
    def test_seconds(self):
        # A cube that goes to and fro between two others for ever.
        text = MODEL.split("behaviour")[0] + """
            behaviour Still on Cube = nil
            fixed left = Cube at translate (-6,0,0) [Still]
            fixed right = Cube at translate (6,0,0) [Still]
            process p = Cube mass 1 velocity (1,0,0) [Still]
        """
        with Oracle(program(), seconds=30, timeout=600) as oracle:
            model = oracle.load_model(text)
            with self.assertRaises(Stopped) as caught:
                oracle.replay(model, choose="first", steps=100_000, states="ends", seconds="1/100")
            self.assertEqual(caught.exception.data["limit"], "seconds")
            self.assertEqual(oracle.successors(model).time, 0)


def python(*words):
    """What a program prints, errors as well."""
    env = dict(os.environ, SCC=program(), PYTHONPATH=os.path.join(CLIENT, "src"))
    done = subprocess.run(
        [sys.executable, "-B", *words],
        env=env, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600,
    )
    return done.stdout


class Readme(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(os.path.join(CLIENT, "README.md")) as file:
            cls.readme = file.read()

    @unittest.skipIf(program() is None, "no scc")
    def test_first_example(self):
        example = self.readme.split("```python\n")[1].split("```")[0]
        self.assertEqual(python("-c", example), example.split("# ")[-1])

    @unittest.skipIf(program() is None, "no scc")
    def test_tour(self):
        pinned = self.readme.split("<!-- output of examples/tour.py -->\n```\n")[1].split("```")[0]
        self.assertEqual(python(os.path.join(CLIENT, "examples", "tour.py")), pinned)


if __name__ == "__main__":
    unittest.main()
