"""Runs of an estimate that many make: what is no run, and what is lost. Without Ray."""

import os
import tempfile
import types
import unittest

from shapecalculus._estimation import Question, Runs, do_runs
from shapecalculus._parts import Done
from shapecalculus._waiting import ClusterFailed

ASKED = {"wanted": {"turn": 1, "from": 10, "to": 40}, "of": "x"}


class Lost(Exception):
    pass


class Ray:
    """Of Ray what a Runs asks for: tasks are done at once."""

    exceptions = types.SimpleNamespace(
        WorkerCrashedError=Lost, NodeDiedError=Lost, ObjectLostError=Lost, OutOfMemoryError=Lost
    )

    def __init__(self, does):
        self.does = does

    def cluster_resources(self):
        return {"CPU": 1}

    def remote(self, **options):
        return lambda work: types.SimpleNamespace(remote=lambda question, *rest: rest)

    def wait(self, futures, num_returns, timeout):
        return futures[-1:], futures[:-1]  # the last one first

    def get(self, future):
        return self.does(*future)


class Programs(unittest.TestCase):
    def made(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scc")
            with open(path, "w", encoding="utf-8") as f:
                f.write("#!/bin/sh\n" + text)
            os.chmod(path, 0o755)
            return do_runs(Question("m.sc", ["--seed=1"], path), 1, 10, 12, "x")

    def test_what_is_no_run_is_refused(self):
        head = 'echo \'{"runs": {}, "of": "x"}\'; '
        self.assertEqual(self.made(head + "echo a; echo b"), Done(0, "", b"a\nb\n"))
        for text, code in [
            (head + "echo a", 70),  # too few
            (head + "echo a; printf b", 70),  # half a line
            ("echo '{\"of\": \"y\"}'; echo a; echo b", 3),  # of another model or build
            ("echo '[]'", 70),
            ("echo nonsense", 70),
            ("true", 70),
            ("echo no >&2; exit 64", 64),
            ("kill -9 $$", 4),
        ]:
            with self.subTest(text):
                self.assertEqual(self.made(text).code, code)

    def test_it_is_asked_for_these(self):
        done = self.made("echo '{\"of\": \"x\"}'; echo $5; echo $4")
        self.assertEqual(done.text, b"1:10-12\n--make\n")


class Parts(unittest.TestCase):
    def all_of(self, does):
        written = []
        Runs(Ray(does), Question("m.sc", [], None)).make(ASKED, written.append)
        return b"".join(written)

    def test_runs_are_in_order_however_they_come(self):
        does = lambda turn, first, upto, of: Done(0, "", b"%d\n" % first)  # noqa: E731
        self.assertEqual(self.all_of(does), b"10\n20\n30\n")

    def test_what_is_lost_is_made_again(self):
        tried = []

        def does(turn, first, upto, of):
            tried.append(first)
            if tried.count(first) == 1:
                raise Lost
            return Done(4, "", b"") if tried.count(first) == 2 else Done(0, "", b"%d\n" % first)

        self.assertEqual(self.all_of(does), b"10\n20\n30\n")
        self.assertEqual(len(tried), 9)

    def test_what_fails_again_and_again(self):
        for code, expected in [(4, 4), (70, 4), (3, 3), (64, 64)]:
            with self.subTest(code), self.assertRaises(ClusterFailed) as caught:
                self.all_of(lambda *which: Done(code, "no\n", b""))
            self.assertEqual(caught.exception.code, expected)


if __name__ == "__main__":
    unittest.main()
