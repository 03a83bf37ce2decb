"""The commands of scc as functions: options, results, errors, interruptions."""

import inspect
import json
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from fractions import Fraction

import shapecalculus
from shapecalculus import CommandFailed, Oracle, RequestError, ServiceError, check, estimate, simulate, sweep, trace, view
from tests.support import CLIENT, MODEL, program

MODELS = os.path.join(CLIENT, os.pardir, os.pardir, "specs", "models")
WALK = """
import <solids>
process p = solids.Cube(1) mass 1 [nil]
motion p = choose { (1, 0, 0) weight 1, (-1, 0, 0) weight 1 }
check far : P = ? [ eventually x(p) >= 2 within 4 ]
"""
# Its states never recur.
LONG = WALK.replace("within 4", "") + "check never : always x(p) < 100000000\n"


def model(name):
    return os.path.join(MODELS, name + ".sc")


@unittest.skipIf(program() is None, "no scc: name it in the environment variable SCC")
class Commands(unittest.TestCase):
    def setUp(self):
        os.environ.setdefault("SCC", program())
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def text(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()


class Signatures(Commands):
    def test_they_are_those_of_scc(self):
        """After a change of options: signatures.py SCC > src/shapecalculus/commands.py."""
        script = os.path.join(CLIENT, "signatures.py")
        made = subprocess.run([sys.executable, "-B", script, program()], capture_output=True, check=True, text=True)
        with open(os.path.join(CLIENT, "src", "shapecalculus", "commands.py"), encoding="utf-8") as file:
            self.assertEqual(file.read(), made.stdout)

    def test_unknown_options(self):
        for function in (check, estimate, simulate, sweep, trace, view):
            with self.assertRaises(TypeError):
                function(WALK, nothing=1)

    def test_wrong_values(self):
        for options in ({"where": 1}, {"states": 1.5}, {"shortest": 3}, {"define": {"p": object()}}):
            with self.subTest(options), self.assertRaises(TypeError):
                check(WALK, **options)
        with self.assertRaises(TypeError):
            check(7)


class Every(Commands):
    """Each option once."""

    def options(self, command, one):
        """Values for all options of a command: those of ``one``, and what their names stand for."""
        folder = {"store": "kept", "witness": "runs"}
        known = {"depth": 40, "bits": 5000, "memory": 2000, "seconds": 100, "states": 5000, "time": Fraction(41, 2),
                 "jobs": 1, "seed": 7, "steps": 900, "until": "4", "axes": ["y", "z"], "no_reduce": ["order", "time"],
                 "shortest": "time", "graph": 50, "check": "meets", "width": Fraction(1, 4)}
        known.update((name, self.path(command + "." + kind)) for name, kind in [
            ("draw", "svg"), ("invariant", "txt"), ("sarif", "sarif"), ("smt", "smt2"), ("output", "out"),
            ("plot", "svg"), *folder.items()])
        known.update(one)
        return known

    def each(self, function, source, one, needed=(), leave=()):
        """Calls it with each option by itself, besides those that it needs."""
        values = self.options(function.__name__, one)
        names = [name for name, p in inspect.signature(function).parameters.items()
                 if name not in ("model", "scc", "progress", "options", *needed, *leave)]
        for name in names:
            parameter = inspect.signature(function).parameters[name]
            value = values[name] if name in values else True if parameter.default is False else None
            self.assertIsNotNone(value, "no value for the option " + name)
            with self.subTest(command=function.__name__, option=name):
                given = {other: values[other] for other in needed}
                given.update(value if isinstance(value, dict) and "=" in value else {name: value})
                given.pop("=", None)
                result = function(source, **given)
                self.assertIn(result.run.exit_code, (0, 1, 2), result.run.messages)
                words = result.run.command
                self.assertTrue(any(w.split("=")[0] == "--" + name.strip("_").replace("_", "-") for w in words), words)

    def test_check(self):
        self.each(check, model("meeting"), {
            "define": {"y": (0, 1), "z": "[0,1)"}, "slice": {"=": 1, "slice": {"z": 0}, "axes": "y",
                                                             "draw": self.path("slice.svg")},
            "store": {"=": 1, "store": self.path("kept"), "define": {"y": 0, "z": 0}},
            "shortest": {"=": 1, "shortest": "time", "define": {"y": 0, "z": 0}},
            "axes": {"=": 1, "axes": ["y", "z"], "draw": self.path("axes.svg")},
            "coverage": {"=": 1, "coverage": True, "define": {"y": 0, "z": 0}},
            "hash_compact": {"=": 1, "hash_compact": True, "define": {"y": 0, "z": 0}},
        }, leave=("curve", "curve_plot", "parametric"))
        self.assertIn("<svg", self.text("check.svg"))
        check(WALK, curve="far", curve_plot=self.path("curve.svg"))
        self.assertIn("<svg", self.text("curve.svg"))
        check("param k in (0, 1)\n" + WALK.replace("weight 1,", "weight k,"), parametric="k")

    def test_estimate(self):
        self.each(estimate, WALK + "param a = 1\n", {
            "define": {"a": 2}, "check": ["far"], "property": "P = ? [ eventually x(p) > 1 within 3 ]",
            "free": "evenly", "most": 100, "confidence": "0.9",
            "runs": {"=": 1, "runs": 20, "most": None},
            "effort": {"=": 1, "effort": 20, "levels": "x(p) >= 1", "check": ["far"], "runs": 5, "most": None},
            "levels": {"=": 1, "levels": "x(p) >= 1", "check": ["far"], "runs": 5, "most": None}},
            needed=("most",))

    def test_simulate(self):
        needed = {"runs": 3, "observe": ["x(p)", "y(p)"], "every": 1, "until": 4}
        kept = self.path("kept.jsonl")
        simulate(WALK, output=kept, **needed)
        self.each(simulate, WALK + "param a = 1\n", {
            **needed, "define": {"a": 2}, "decimals": 2, "format": "csv", "part": "1/2",
            "resume": {"=": 1, "resume": kept, "define": {}, "runs": 4}, "steps": 900,
            "quantiles": {"=": 1, "quantiles": ["1/4", Fraction(3, 4)], "summary": True},
            "plot": {"=": 1, "plot": self.path("simulate.svg"), "summary": True},
            "view": self.path("simulate.html"),
        }, needed=tuple(needed), leave=("resume",))
        whole = simulate(WALK, resume=kept, **{**needed, "runs": 5})
        self.assertEqual([run.number for run in whole.runs], [0, 1, 2, 3, 4])

    def test_sweep(self):
        runs = {"confidence": "0.9", "free": "evenly", "normal": True, "seed": 7, "steps": 900, "until": 50, "runs": 20}
        looks = {"most": 100, "width": "1/2", "estimate": True}
        estimates = {name: {"=": 1, "estimate": True, "check": ["far"], "runs": 20, name: value}
                     for name, value in runs.items()}
        estimates.update((name, {"=": 1, "estimate": True, "check": ["far"], name: value})
                         for name, value in looks.items())
        self.each(sweep, WALK + "param a = 1\n", {
            **estimates, "define": {"a": "1..2"}, "format": "csv", "part": "2/2", "check": ["far"],
            "decimals": {"=": 1, "decimals": 3, "format": "csv"}}, needed=("define",), leave=("resume",))
        kept = self.path("kept.jsonl")
        first = sweep(WALK + "param a = 1\n", {"a": [1, 2]}, output=kept)
        self.assertEqual(sweep(WALK + "param a = 1\n", {"a": [1, 2]}, resume=kept), first)

    def test_trace(self):
        schedule = self.path("run.jsonl")
        trace(MODEL, steps=2, output=schedule)
        self.each(trace, MODEL, {"define": {"speed": "1/2"}, "choose": "random:3", "start": "simple", "states": "ends",
                                 "schedule": schedule, "full": {"=": 1, "full": True, "human": True}})

    def test_view(self):
        schedule = self.path("run.jsonl")
        trace(MODEL, steps=2, output=schedule)
        values = {"define": {"speed": 1}, "schedule": schedule, "trace": schedule, "plot": ["x(p)", "x(q)"],
                  "svg": Fraction(3, 2)}
        for name, value in (("from_", (1, 1, 1)), ("up", "0,0,1"), ("width", 300), ("without", "q"), ("names", True),
                            ("camera", 'camera={"at":["0","0","0"],"distance":9,"turn":0,"height":1}')):
            values[name] = {"=": 1, "svg": 1, name: value}
        self.each(view, MODEL, values)
        self.assertIn("<svg", view(MODEL, svg=0, from_=(-1, "1/2", 1), up=(0, 1, 0)).content)


class Results(Commands):
    def test_check(self):
        checked = check(model("hexokinase"))
        self.assertEqual((checked.verdicts["reaction"], checked.verdicts["surely"]), ("holds", "violated"))
        self.assertEqual((checked.stopped_by, checked.complete, checked.run.exit_code), ((), True, 1))
        self.assertIsNotNone(checked["reaction"].witness)
        self.assertEqual(pickle.loads(pickle.dumps(checked)), checked)

    def test_where(self):
        self.assertEqual(check(model("meeting"), where=True).where["meets"].probability, Fraction(7, 18))

    def test_what_stopped_it(self):
        for bound, value in (("states", 40), ("depth", 9), ("time", 3)):
            with self.subTest(bound):
                checked = check(LONG, **{bound: value})
                self.assertEqual([(b.limit, b.value, b.origin) for b in checked.stopped_by], [(bound, value, "user")])
                self.assertEqual([b.limit for b in checked["never"].bounds], [bound])
                self.assertFalse(checked.complete)
        checked = check(LONG, seconds="1/2", states=10**7, jobs=1)
        self.assertEqual([b.limit for b in checked.stopped_by], ["seconds"])
        self.assertEqual(checked["never"].bounds[0].value, Fraction(1, 2))
        self.assertFalse(checked.interrupted)
        with Oracle(program()) as oracle:
            checked = oracle.check(LONG, states=40)
        self.assertEqual(([b.limit for b in checked.stopped_by], checked.run), (["states"], None))
        self.assertEqual([b.limit for b in checked["never"].bounds], ["states"])

    def test_numbers(self):
        self.assertEqual(check(WALK)["far"].value, Fraction(3, 8))
        mean = WALK + "check mean : E = ? [ time U x(p) = 1 ]\n"
        self.assertEqual(check(mean, states=100)["mean"].value, None)

    def test_curve(self):
        checked = check(WALK + "check other : P = ? [ eventually x(p) >= 9 within 1 ]\n", curve="far")
        rows = [(point.time, point.after, point.value) for point in checked["far"].curve]
        expected = [(0, 0), (2, Fraction(1, 4)), (4, Fraction(3, 8))]
        self.assertEqual(rows, [((Fraction(t), Fraction(t)), False, Fraction(p)) for t, p in expected])
        self.assertEqual(checked["far"].curve[-1].value, checked["far"].value)
        self.assertEqual(checked["other"].curve, ())
        self.assertEqual(pickle.loads(pickle.dumps(checked)), checked)

    def test_estimate(self):
        far = estimate(WALK, runs=200)["far"]
        self.assertTrue(far.low <= Fraction(3, 8) <= far.high)
        self.assertEqual((far.kind, far.runs, sum(far.counts.values())), ("probability", 200, 200))

    def test_simulate(self):
        result = simulate(WALK, runs=4, observe=["x(p)", "time"], every=1, until=2)
        self.assertEqual((len(result.runs), result.times), (4, (0, 1, 2)))
        self.assertEqual(len(result.rows), 12)
        self.assertTrue(all(row["(time)"] == row["time"] for row in result.rows))
        self.assertTrue(all(isinstance(row["x(p)"], Fraction) for row in result.rows))
        moments = simulate(WALK, runs=4, observe="x(p)", every=1, until=2, summary=True).summary
        last = [run.values[-1][0] for run in result.runs]
        self.assertEqual((moments[-1].mean, moments[-1].count), (Fraction(sum(last), 4), 4))

    def test_trace(self):
        run = trace(MODEL)
        self.assertEqual([step.label.kind for step in run.steps], ["time", "bind", "time", "strong"])
        self.assertEqual((run.ending, run.time, run.last.leaf("q").position), ("quiescent", Fraction(9, 2), (10, 0, 0)))
        self.assertEqual([row["x"] for row in trace(MODEL, time=1).rows], [0, 7, 2, 7])
        ends = trace(MODEL, states="ends")
        self.assertEqual([row["step"] for row in ends.rows], [0, 0, 4, 4])

    def test_view(self):
        viewed = view(model("hexokinase"), output=self.path("page.html"))
        self.assertEqual(viewed.content, self.text("page.html"))
        self.assertIn("leaves", view(MODEL, data=True).data)

    def test_a_loaded_model(self):
        with Oracle(program()) as oracle:
            loaded = oracle.load_model(MODEL, parameters={"speed": 1})
            shapes = "import <solids>\nshape C = solids.Cube(1)\n"
            beside = oracle.load_model('import "s.sc" (C)\nprocess p = C mass 1 [nil]\n', files={"s.sc": shapes})
        self.assertEqual(trace(loaded, steps=1).time, 5)
        self.assertEqual(trace(loaded, steps=1, define={"speed": 5}).time, 1)
        self.assertEqual(len(trace(beside).initial.processes), 1)

    def test_names_that_are_not_ascii(self):
        with self.assertRaises(CommandFailed) as caught:
            check("// größe – 大\nprocess größe = Nothing [nil]\n")
        self.assertEqual((caught.exception.code, caught.exception.place.line), ("SC0104", 2))
        self.assertIn("ö", caught.exception.message)
        self.assertEqual(trace("// größe – 大\n" + MODEL).ending, "quiescent")
        path = self.path("größe 大.sc")
        with open(path, "w", encoding="utf-8") as file:
            file.write("// größe 大\n" + MODEL)
        self.assertEqual(trace(path).ending, "quiescent")
        with self.assertRaises(CommandFailed) as caught:
            trace(self.path("größe.sc"))
        self.assertEqual(caught.exception.place.file, self.path("größe.sc"))

    def test_a_thousand_bodies(self):
        text = ("import <solids>\nfor i in 1..1000 { process p[i] = solids.Cube(1) mass 1 velocity (0, 1, 0) "
                "at translate (2 * i, 0, 0) [nil] }\n")
        run = trace(text, time=1, states="ends")
        self.assertEqual((len(run.last.processes), run.last.leaf("p[1000]").position), (1000, (2000, 1, 0)))
        result = simulate(text, runs=1, observe=["y(p[%d])" % i for i in (1, 1000)], every=1, until=1)
        self.assertEqual(result.runs[0].values[1], (1, 1))

    def test_tables(self):
        results = [check(WALK), estimate(WALK, runs=5), trace(MODEL), sweep(MODEL, {"speed": [1]}),
                   simulate(WALK, runs=2, observe="x(p)", every=1, until=1),
                   simulate(WALK, runs=2, observe="x(p)", every=1, until=1, summary=True)]
        for result in results:
            try:
                import pandas  # noqa: F401
            except ImportError:
                with self.assertRaisesRegex(ImportError, "need pandas"):
                    result.to_dataframe()
                continue
            exact, floats = result.to_dataframe(), result.to_dataframe(as_float=True)
            self.assertEqual((len(exact), list(exact.columns)), (len(result.rows), list(floats.columns)))
            numbers = [x for row in exact.to_dict("records") for x in row.values() if isinstance(x, Fraction)]
            self.assertTrue(numbers)
            self.assertFalse([x for row in floats.to_dict("records") for x in row.values() if isinstance(x, Fraction)])


class Errors(Commands):
    def test_no_grid(self):
        for define, expected in (({}, "needs a parameter"), ({"speed": []}, "speed has no values")):
            with self.assertRaisesRegex(ValueError, expected):
                sweep(MODEL, define)

    def test_places(self):
        for function, options in ((check, {}), (estimate, {}), (trace, {}), (view, {}),
                                  (simulate, {"runs": 1, "observe": "time", "every": 1, "until": 1})):
            with self.subTest(function.__name__), self.assertRaises(CommandFailed) as caught:
                function("param a = 1\nprocess p = Nothing [nil]\n", **options)
            error = caught.exception
            self.assertEqual((error.code, error.place.line, error.exit_code), ("SC0201", 2, 3))
            self.assertEqual((error.place.file, error.place.column), ("<model>", 13))
            self.assertRegex(error.message, "Nothing")
            self.assertEqual(pickle.loads(pickle.dumps(error)).place, error.place)

    def test_numbers_that_are_too_long(self):
        long = Fraction(10**5000, 3)
        for call in (lambda: check(MODEL, define={"speed": long}), lambda: check(MODEL, time=long),
                     lambda: check(MODEL.replace("= 2", "in [0, 6]"), define={"speed": (1, long)}),
                     lambda: sweep(MODEL, {"speed": [1, long]})):
            with self.assertRaisesRegex(CommandFailed, r"at\s+most\s+4000\s+digits"):
                call()
        with Oracle(program()) as oracle:
            with self.assertRaisesRegex(RequestError, "limit `digits`"):
                oracle.load_model(MODEL, parameters={"speed": long})

    def test_places_in_other_files(self):
        path = os.path.abspath(self.path("bad.sc"))
        with open(path, "w", encoding="utf-8") as file:
            file.write("shape X {\n")
        for text, expected in (('import "%s"\n' % path, path), ("shape X {\n", "<model>")):
            with self.assertRaises(CommandFailed) as caught:
                check(text)
            self.assertEqual(caught.exception.place.file, expected)

    def test_nothing(self):
        with self.assertRaises(CommandFailed) as caught:
            check("")
        self.assertEqual(caught.exception.code, "SC0112")

    def test_usage(self):
        with self.assertRaises(CommandFailed) as caught:
            check(WALK, shortest="longest")
        self.assertEqual((caught.exception.exit_code, caught.exception.code), (64, None))

    def test_files(self):
        with self.assertRaises(CommandFailed) as caught:
            check(self.path("none.sc"))
        self.assertEqual(caught.exception.code, "SC0101")
        with self.assertRaises(CommandFailed) as caught:
            simulate(WALK, runs=1, observe="x(p)", every=1, until=1, output=self.path("no/where"))
        self.assertEqual((caught.exception.exit_code, caught.exception.code), (74, "SC0103"))
        # A file beside the result: what was found is there.
        away = self.path("no/where.svg")
        grid = {"runs": 1, "observe": "x(p)", "every": 1, "until": 1}
        meeting, swept = os.path.join(MODELS, "meeting.sc"), WALK + "param a = 1\n"
        for ask in (lambda: check(WALK, witness=away), lambda: check(WALK, sarif=away), lambda: check(meeting, smt=away),
                    lambda: simulate(WALK, plot=away, **grid), lambda: sweep(swept, {"a": [1, 2]}, plot=away)):
            with self.assertRaises(CommandFailed) as caught:
                ask()
            again = pickle.loads(pickle.dumps(caught.exception))
            for failed in (caught.exception, again):
                self.assertEqual((failed.exit_code, failed.code), (74, "SC0103"))
                self.assertEqual(failed.result.run.exit_code, 74)

    def test_no_program(self):
        with self.assertRaisesRegex(ServiceError, "cannot start"):
            check(WALK, scc=self.path("none"))
        with self.assertRaises(ServiceError):
            check(WALK, scc="/bin/cat")


def used_below():
    """The seconds of the processor that each process below this one has used."""
    below, found = {os.getpid()}, {}
    for pid in map(int, filter(str.isdigit, os.listdir("/proc"))):
        try:
            with open("/proc/%d/stat" % pid, encoding="utf-8") as file:
                fields = file.read().rsplit(")", 1)[1].split()
        except OSError:
            continue
        found[pid] = (int(fields[1]), (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK"))
    for _ in range(4):
        below |= {pid for pid, (parent, _) in found.items() if parent in below}
    return {pid: used for pid, (_, used) in found.items() if pid in below and pid != os.getpid()}


class Interruptions(Commands):
    def setUp(self):
        super().setUp()
        # The tests may run in the background of a shell, where SIGINT is ignored.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)

    def interrupted(self, function, *arguments, **options):
        """The result of a call that SIGINT interrupts once scc has worked for 0.2 seconds. It starts in less, and writes
        thousands of steps in a second."""

        before = used_below()

        def interrupt():
            while not any(used >= 0.2 for pid, used in used_below().items() if pid not in before):
                time.sleep(0.05)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt, daemon=True)
        thread.start()
        try:
            return function(*arguments, **options)
        finally:
            thread.join()

    def test_results(self):
        checked = self.interrupted(check, LONG, states=10**8, jobs=1)
        self.assertTrue(checked.interrupted, checked.stopped_by)
        self.assertEqual([b.limit for b in checked.stopped_by], ["interrupted"])
        self.assertEqual(checked["never"].bounds[0].limit, "interrupted")
        result = self.interrupted(simulate, LONG, runs=10**7, observe="x(p)", every=100, until=100)
        self.assertTrue(result.interrupted and 0 < len(result.runs) < 10**7)
        self.assertTrue(self.interrupted(estimate, LONG, most=10**7, steps=10**6).interrupted)
        run = self.interrupted(trace, LONG, steps=10**8, states="ends")
        self.assertEqual((run.interrupted, run.ending), (True, "interrupted"))
        self.assertTrue(run.steps)
        # Objects of a long trace are made when they are looked at, so that Ctrl-C is answered before.
        run = self.interrupted(trace, LONG, steps=10**8)
        self.assertEqual((run.ending, run.time > 0, len(repr(run)) < 200), ("interrupted", True, True))
        self.assertFalse({"lines", "steps"} & set(vars(run)))
        self.assertEqual(run.time, run.steps[-1].time)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_twice(self):
        """The second SIGINT is no longer waited for. The program is one of its own, as signals go on until it ends."""
        scc, started = self.path("scc"), self.path("started")
        with open(scc, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\ntrap '' INT\n: > '%s'\nsleep 1000\n" % started)
        os.chmod(scc, 0o755)
        program = ("import signal, sys; from shapecalculus import check\n"
                   "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
                   "try: check('', scc=sys.argv[1])\n"
                   "except KeyboardInterrupt: signal.signal(signal.SIGINT, signal.SIG_IGN); print('left')\n")
        child = subprocess.Popen([sys.executable, "-B", "-c", program, scc], stdout=subprocess.PIPE,
                                 env=dict(os.environ, PYTHONPATH=os.pathsep.join(sys.path)))
        while not os.path.exists(started):
            time.sleep(0.05)
        for _ in range(30):
            if child.poll() is None:
                child.send_signal(signal.SIGINT)
                time.sleep(2)
        child.kill()
        with child.stdout:
            self.assertEqual((child.stdout.read().strip(), child.returncode), (b"left", 0))

    def test_progress(self):
        lines = []
        simulate(WALK, runs=2000, observe="x(p)", every=1, until=100, progress=lines.append)
        self.assertEqual(lines[:2], ["reading the model", "0 of 2000 runs"])
        self.assertRegex(lines[2], "^[0-9]+ of 2000 runs$")
        del lines[:]
        check(LONG.replace("check far", "// "), states=100000, jobs=1, progress=lines.append)
        self.assertEqual(lines[:2], ["reading the model", "beginning to explore"])
        self.assertRegex(lines[2], "^[0-9]+ states ")


class Readme(Commands):
    def test_tutorial(self):
        """Its cells run one after the other, in one program; what each prints stands below it."""
        with open(os.path.join(CLIENT, "README.md"), encoding="utf-8") as file:
            part = file.read().split("## The commands of scc\n")[1].split("\n## ")[0]
        blocks = part.split("```")[1::2]
        code = "".join(block[len("python\n"):] for block in blocks if block.startswith("python\n"))
        printed = "".join(block[1:] for block in blocks if block.startswith("\n"))
        environment = dict(os.environ, PYTHONPATH=os.path.join(CLIENT, "src"))
        root = os.path.join(CLIENT, os.pardir, os.pardir)
        done = subprocess.run([sys.executable, "-B", "-c", code], cwd=root, env=environment, capture_output=True, text=True)
        self.assertEqual((done.stderr, done.stdout), ("", printed))


if __name__ == "__main__":
    unittest.main()
