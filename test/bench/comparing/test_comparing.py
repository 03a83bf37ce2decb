"""Tests of what the comparison says, and of the generator of shapes and pairs.

    test_comparing.py GEOMETRY_EXE
"""

import contextlib
import io
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from checker import programs, tables  # noqa: E402
from comparing import answers, gas, turning  # noqa: E402

HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
GEOMETRY = None


class Turning(unittest.TestCase):
    def test_least(self):
        def rows(ns):
            return [{"query": "all", "name": "scc", "ns": ns, "answers": ["never"]}]

        self.assertEqual(turning.least([rows(3.0), rows(1.0), rows(2.0)])[("all", "scc")]["ns"], 1.0)

    def test_differences(self):
        own = ["never", "hit 0.5", "hit 0.25", "inside", "hit 0.125"]
        other = ["never", "hit 0.75", "never", "hit 0", "failed 0.125"]
        self.assertEqual(turning.differences(own, other), ([2, 3], 0.25))

    def test_counts(self):
        self.assertEqual(turning.Comparison.counts(["never", "hit 0.5", "never"]), "1 hit, 2 never")

    def test_missed(self):
        """The shares of the processes are added up, and one that finds something wrong is heard."""
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "missed")
            with open(program, "w") as file:
                file.write("#!/bin/sh\necho '   checked hits'\necho \"all $2 1 2 3 4 5 6\"\n[ $6 = 0 ]\n")
            os.chmod(program, 0o755)
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                alone = turning.missed(program, 7, 1, "hull", 1)
                together = turning.missed(program, 7, 1, "hull", 2)
        self.assertEqual((alone, together), (0, 1))
        self.assertEqual(said.getvalue().splitlines()[-1].split(), ["all", "7", "2", "4", "6", "8", "10", "12"])


class Checking(unittest.TestCase):
    """The chain in Promela, and the runs of the model checkers."""

    def test_promela(self):
        text = programs.promela(3)
        self.assertEqual(text.count("d_step"), 3)
        self.assertEqual(text.count("::"), 4)
        self.assertIn("byte bonds = N;", text)

    def test_spin_counts(self):
        class Said(programs.Spin):
            def build(self, n):
                return "said"

        said = "State-vector 20 byte, depth reached 4, errors: 0\n        8 states, stored\n       12 states, matched\n" \
               "       20 transitions (= stored+matched)\n"
        measure, programs.measure = programs.measure, lambda command, timeout: (said, 0.5, 1024)
        try:
            run = Said("SPIN, COLLAPSE", "", [], 1).chain(3)
        finally:
            programs.measure = measure
        self.assertEqual((run.states, run.transitions, run.note), (8, 19, "holds"))

    def test_rounds_have_to_agree(self):
        runs = iter([programs.Run(8, 19, 2.0, 300), programs.Run(8, 19, 1.0, 400)])
        best = tables.best(lambda: next(runs), 2)
        self.assertEqual((best.seconds, best.memory), (1.0, 300))
        runs = iter([programs.Run(8, 19, 2.0, 300), programs.Run(8, 18, 1.0, 400)])
        self.assertRaises(programs.Failed, tables.best, lambda: next(runs), 2)


class Judging(unittest.TestCase):
    def test_casts(self):
        exact = ["collide 1/2 | touch 1/2", "never | never", "never | touch 3", "inside | touch 0",
                 "collide 1 | touch 1"]
        right = answers.Casts(exact, ["hit 0.5", "never", "never", "inside", "hit 1.0"])
        self.assertEqual((right.missed, right.spurious, right.grazes, right.late), (0, 0, 0, 0))
        wrong = answers.Casts(exact, ["never", "hit 2", "hit 3", "never", "hit 1.25"])
        self.assertEqual((wrong.missed, wrong.spurious, wrong.grazes, wrong.late), (2, 1, 1, 1))
        self.assertEqual(wrong.error, 0.25)

    def test_time_that_is_no_number(self):
        self.assertEqual(answers.Casts(["collide 1 | touch 1"], ["hit nan"]).late, 1)

    def test_contacts(self):
        exact = ["apart", "apart", "inside", "inside", "touching", "touching"]
        found = answers.Contacts(exact, ["apart", "meet", "meet", "apart", "apart", "touching"])
        self.assertEqual((found.missed, found.spurious, found.touch, found.touching), (1, 1, 1, 2))

    def test_own_answers(self):
        self.assertEqual(answers.wrong(["a", "b", "c"], ["a", "x"]), 2)


class Matching(unittest.TestCase):
    EXACT = [(1.0, 0, 1), (2.0, 2, -1), (3.0, 0, 2), (4.0, 3, -4)]

    def test_all_found(self):
        found = [(1.01, 0, 1), (2.01, 2, -1), (2.99, 0, 2), (4.0, 3, -4)]
        self.assertEqual(gas.matched(self.EXACT, found), (4, 0, 0))

    def test_missed_event_taints_what_follows(self):
        found = [(2.01, 2, -1), (4.0, 3, -4)]
        self.assertEqual(gas.matched(self.EXACT, found), (3, 1, 0))

    def test_spurious_event(self):
        found = [(0.5, 1, 3)] + [(t, a, b) for t, a, b in self.EXACT]
        # 1 and 3 are not clean; 0 meets 1, and 2 meets 0: only 2 at the wall is left to be asked for.
        self.assertEqual(gas.matched(self.EXACT, found), (1, 0, 1))

    def test_a_contact_serves_once(self):
        self.assertEqual(gas.matched([(1.0, 0, 1), (1.05, 0, 1)], [(1.0, 0, 1)]), (2, 1, 0))


class Generating(unittest.TestCase):
    KINDS = ["general", "aligned", "near", "inside"]

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def generate(self, name, *words):
        path = os.path.join(self.folder.name, name)
        with open(path, "w") as file:
            subprocess.run([sys.executable, os.path.join(HERE, "generate")] + list(words), stdout=file, check=True)
        return path

    def geometry(self, *words):
        return subprocess.run([GEOMETRY] + list(words), stdout=subprocess.PIPE, text=True)

    def test_same_bytes(self):
        texts = []
        for name in "ab":
            with open(self.generate(name, "shape", "hull:30", "7")) as file:
                texts.append(file.read())
        first, second = texts
        self.assertEqual(first, second)
        self.assertEqual(first.split()[0], "30")

    def test_answers_are_those_of_all_separating_axes(self):
        for kind, sample in (("tetrahedron", 40), ("plank", 40), ("prism:6", 20), ("hull:14", 4)):
            shape = self.generate("shape", "shape", kind, "5")
            for task in self.KINDS:
                pairs = self.generate("pairs", "pairs", task, "9", str(sample), shape)
                checked = self.geometry(shape, pairs, "--check", str(sample))
                self.assertEqual((task, checked.returncode), (task, 0), checked.stdout)
                self.assertIn("%d pairs checked, 0 wrong" % sample, checked.stdout)

    def test_kinds_are_what_they_say(self):
        shape = self.generate("shape", "shape", "plank", "2")
        found = {}
        for task in self.KINDS:
            pairs = self.generate("pairs", "pairs", task, "3", "200", shape)
            found[task] = self.geometry(shape, pairs, "--answers").stdout.splitlines()
            self.assertEqual(len(found[task]), 200)
        self.assertTrue(all(a.startswith("inside") for a in found["inside"]))
        self.assertGreater(sum(a.startswith("never | touch") for a in found["aligned"]), 50)
        self.assertGreater(sum(a.startswith("collide") for a in found["general"]), 50)

    def test_two_shapes(self):
        shapes = [self.generate(kind, "shape", kind, "4") for kind in ("plank", "tetrahedron")]
        pairs = self.generate("pairs", "pairs", "near", "1", "30", *shapes)
        self.assertEqual(self.geometry(*shapes, pairs, "--check", "30").returncode, 0)


if __name__ == "__main__":
    GEOMETRY = os.path.abspath(sys.argv.pop())
    result = unittest.main(exit=False, verbosity=0).result
    bad = len(result.failures) + len(result.errors)
    print("%d passed, %d failed" % (result.testsRun - bad, bad))
    sys.exit(1 if bad else 0)
