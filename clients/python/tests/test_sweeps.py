"""Sweeps: the table of scc as records."""

import io
import math
import os
import shlex
import shutil
import tempfile
import unittest
from fractions import Fraction

from shapecalculus import ServiceError, sweep, sweep_records
from shapecalculus.sweeps import COLUMNS, ESTIMATES, records_of

from .support import program

WALK = """
param p = 1/2
param n = 3
import <solids>
process walker = solids.Cube(1) mass 1 [nil]
fixed left  = solids.Cube(1) absorb at translate (-3, 0, 0)
fixed right = solids.Cube(1) absorb at translate (n + 1, 0, 0)
motion walker = choose { (1, 0, 0) weight p, (-1, 0, 0) weight 1 - p }
check ruin   : P = ? [ eventually event absorb(walker, left) ]
check never  : E = ? [ time U event absorb(walker, left) ]
check likely : P >= 1/2 [ eventually event absorb(walker, left) ]
"""


class Sweeps(unittest.TestCase):
    def setUp(self):
        if program() is None:
            raise unittest.SkipTest("no scc: name it in the environment variable SCC")
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = os.path.join(self.folder.name, "walk.sc")
        with open(self.path, "w", encoding="utf-8") as file:
            file.write(WALK)

    def sweep(self, grid, **options):
        return sweep(self.path, grid, scc=program(), **options)

    def test_closed_form(self):
        records = self.sweep({"n": range(1, 4), "p": [Fraction(1, 3), "0.4", Fraction(2, 3)]}, jobs=2)
        self.assertEqual(len(records), 27)
        for record in records:
            if record["check"] != "ruin":
                continue
            # two steps to the left, n to the right, at each step with r = (1 - p) / p
            n, r = int(record["n"]), (1 - record["p"]) / record["p"]
            exact = (r**2 - r ** (n + 2)) / (1 - r ** (n + 2))
            self.assertEqual((record["low"], record["high"]), (exact, exact))
            likely = next(x for x in records if x["check"] == "likely" and (x["n"], x["p"]) == (n, record["p"]))
            self.assertEqual(likely["verdict"], "holds" if exact >= Fraction(1, 2) else "violated")

    def test_estimates(self):
        for record in self.sweep({"n": [1, 2], "p": ["1/3"]}, estimate=True, runs=20, check="ruin"):
            self.assertEqual(record["runs"], 20)
            self.assertTrue(0 <= record["low"] <= record["estimate"] <= record["high"] <= 1)

    def test_approximate_intervals(self):
        made = {"value": "1/1", "low": "0/1", "high": "2/1", "infinite": False, "approximate": True, "runs": 40}
        found = {"name": "c", "verdict": "estimated", "values": [], "estimate": made, "reasons": []}
        for point in [found, {**found, "estimate": {**made, "approximate": False}}]:
            [record] = records_of([{"parameters": {}, "refused": None, "checks": [point]}])
            self.assertEqual("approximate" in record["why"], point is found)

    def test_parameters_named_like_columns(self):
        for name in [*COLUMNS, *ESTIMATES]:
            point = {"name": "c", "verdict": "holds", "values": [], "reasons": []}
            [record] = records_of([{"parameters": {name: "7/2"}, "refused": None, "checks": [point]}])
            self.assertEqual((record["(%s)" % name], record["verdict"]), (Fraction(7, 2), "holds"))
        with open(self.path, "w", encoding="utf-8") as file:
            file.write(WALK.replace("param p", "param low").replace("weight p", "weight low").replace("1 - p", "1 - low"))
        swept = self.sweep({"low": ["1/3", "1/2"]}, check="ruin")
        self.assertEqual((swept.parameters, swept.columns), (("low",), ("(low)",)))
        self.assertEqual([r["(low)"] for r in swept], [Fraction(1, 3), Fraction(1, 2)])
        self.assertTrue(all(r["low"] == r["high"] != r["(low)"] for r in swept))
        shown = swept._repr_html_()
        self.assertTrue("(low)</th>" in shown and ">1/3<" in shown)
        try:
            self.assertEqual(swept.to_dataframe()["(low)"].tolist(), [Fraction(1, 3), Fraction(1, 2)])
        except ImportError:
            pass  # no pandas
        try:
            drawn = swept.plot()
        except ImportError:
            return  # no matplotlib
        self.assertEqual(drawn.get_xlabel(), "(low)")
        self.assertEqual(list(drawn.lines[0].get_xdata()), [1 / 3, 1 / 2])

    def test_order_and_infinity(self):
        records = self.sweep({"p": ["1/4", "1/2"], "n": [1, 2]})
        self.assertEqual([(r["p"], r["n"]) for r in records[::3]],
                         [(Fraction(1, 4), 1), (Fraction(1, 4), 2), (Fraction(1, 2), 1), (Fraction(1, 2), 2)])
        never = [r for r in records if r["check"] == "never"]
        self.assertTrue(all(r["least_low"] == r["high"] == math.inf for r in never))

    def test_invalid_points(self):
        records = self.sweep({"p": [Fraction(1, 2), 2]})
        self.assertEqual([r["verdict"] for r in records], ["measured", "measured", "holds", "invalid"])
        self.assertEqual((records[3]["p"], records[3]["check"], records[3]["low"]), (2, None, None))
        self.assertRegex(records[3]["why"], "^SC[0-9]{4}: ")

    def test_pandas(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("no pandas")
        frame = pandas.DataFrame(self.sweep({"n": [1, 2]}))
        self.assertEqual(frame[frame["check"] == "ruin"]["low"].tolist(), [Fraction(1, 3), Fraction(1, 2)])

    def script(self, text):
        path = os.path.join(self.folder.name, "scc")
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + text)
        os.chmod(path, 0o755)
        return path

    def test_a_table_that_is_not_whole(self):
        real = shlex.quote(shutil.which(program()) or program())
        for command, there in [("cat", 3), ("head -n 2", 0), ("head -c 600", 0), ("grep -v zzz", 3)]:
            scc = self.script("%s \"$@\" | %s" % (real, command))
            if there:
                self.assertEqual(len(sweep(self.path, {"p": ["1/2"]}, scc=scc)), there)
            else:
                with self.assertRaisesRegex(ServiceError, "no table"):
                    sweep(self.path, {"p": ["1/4", "1/2"]}, scc=scc)

    def test_what_cannot_be(self):
        with self.assertRaisesRegex(ServiceError, "exit code 64"):
            self.sweep({"nothing": [1]})
        with self.assertRaisesRegex(ServiceError, "cannot start"):
            sweep(self.path, {"n": [1]}, scc=os.path.join(self.folder.name, "none"))
        with self.assertRaises(ValueError):
            self.sweep({"n": ["many"]})
        for said in ("", "{", "{}", "[]", "1", '{"grid": [{"values": [1]}]}', "\\377"):
            with self.subTest(said), self.assertRaises(ServiceError):
                sweep(self.path, {"n": [1]}, scc=self.script("printf '%s\\n' '" + said + "'"))
        for ends in ("kill -9 $$", "printf '\\377' >&2; exit 1", "exit 4"):
            with self.subTest(ends), self.assertRaises(ServiceError):
                sweep(self.path, {"n": [1]}, scc=self.script(ends))
        with self.assertRaises(ValueError):
            sweep_records(io.StringIO('{"format": "scc-graph"}\n'))


if __name__ == "__main__":
    unittest.main()
