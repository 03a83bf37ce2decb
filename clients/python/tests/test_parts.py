"""What the cluster makes of a program that is not scc, or that ends otherwise than it should. Without Ray."""

import os
import tempfile
import types
import unittest

from shapecalculus._parts import NO_PART, Done, Spread, Work, header, run, understood
from shapecalculus._waiting import ClusterFailed, answers, ready

from .support import program

FIRST = '{"format": "scc-simulation"}\n'


class Lost(Exception):
    pass


class Ray:
    """Of Ray what a Spread asks for: tasks are done at once."""

    exceptions = types.SimpleNamespace(
        WorkerCrashedError=Lost, NodeDiedError=Lost, ObjectLostError=Lost, OutOfMemoryError=Lost
    )

    def __init__(self, does):
        self.does = does

    def cluster_resources(self):
        return {"CPU": 1}

    def remote(self, **options):
        return lambda work: types.SimpleNamespace(remote=lambda work, which, asked: (which,))

    def wait(self, futures, num_returns, timeout):
        return futures[:1], futures[1:]

    def get(self, future):
        return self.does(*future)

    def cancel(self, future):
        pass


class Programs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def script(self, text, mode=0o755):
        path = os.path.join(self.folder.name, "scc")
        with open(path, "w", encoding="utf-8") as f:
            f.write(text)
        os.chmod(path, mode)
        return path

    def code(self, scc, command="simulate"):
        work = Work(command, "m.sc", [], "jsonl", scc)
        with self.assertRaises(ClusterFailed) as caught:
            understood(work, header(work, "jsonl").text)
        self.assertTrue(str(caught.exception))
        return caught.exception.code

    def test_what_is_not_scc(self):
        """No exit code of such a program is a verdict."""
        sh = "#!/bin/sh\n"
        for scc, code in [
            (os.path.join(self.folder.name, "none"), 3),
            (self.folder.name, 3),
            ("/bin/true", 3),
            ("/bin/false", 3),
            ("/bin/echo", 3),
            (self.script("no program", 0o644), 3),
        ]:
            with self.subTest(scc):
                self.assertEqual(self.code(scc), code)
        for text, code in [
            (sh + "exit 2", 3),
            (sh + "echo '[1]'", 3),
            (sh + "echo '{\"format\": \"scc-sweep\"}'", 3),
            (sh + "printf '{\"format\": \"scc-simulation\"'", 3),
            (sh + "printf '{\"format\": \"scc-simulation\"}'", 3),
            (sh + "printf '\\377\\n'", 3),
            (sh + "echo '{\"format\": \"scc-simulation\"}'; exit 1", 3),
            (sh + "exec 1>&- 2>&-; exit 1", 3),
            (sh + "echo no >&2; exit 64", 64),
            (sh + "kill -9 $$", 4),
            (sh + "kill -15 $$", 4),
            (sh + "kill -11 $$", 70),
            ("", 3),
        ]:
            with self.subTest(text):
                self.assertEqual(self.code(self.script(text)), code)

    def test_scc(self):
        if program() is None:
            self.skipTest("no scc: name it in the environment variable SCC")
        path = os.path.join(self.folder.name, "m.sc")
        with open(path, "w", encoding="utf-8") as f:
            f.write("import <solids>\nprocess p = solids.Cube(1) mass 1 [nil]\n")
        arguments = ["--runs", "1", "--observe", "time", "--every", "1", "--until", "1"]
        work = Work("simulate", path, arguments, "jsonl", program())
        self.assertEqual(understood(work, header(work, "jsonl").text)["format"], "scc-simulation")
        self.assertEqual(run(work.part(NO_PART, "csv")).text.count(b"\n"), 1)


class Parts(unittest.TestCase):
    def all_of(self, does, count=3):
        first = FIRST.encode()
        parts = Spread(Ray(does), Work("simulate", "m.sc", [], "jsonl", None), count, None, first, first)
        parts.begin()
        return list(parts.run(lambda p: None, None))

    def test_parts_that_are_not_whole(self):
        whole = FIRST + "x\n"
        for code, text, expected in [
            (0, whole, None),
            (2, whole, None),
            (0, FIRST + "x", 3),  # half a line
            (0, "", 3),
            (1, whole, 3),
            (2, "x\n", 3),
            (64, "", 64),
            (4, "", 4),
            (70, "", 4),  # again and again
        ]:
            with self.subTest((code, text)):
                done = Done(code, "", text.encode())
                if expected is None:
                    self.assertEqual([d.text for d in self.all_of(lambda which: done)], [whole.encode()] * 3)
                    continue
                with self.assertRaises(ClusterFailed) as caught:
                    self.all_of(lambda which: done)
                self.assertEqual(caught.exception.code, expected)

    def test_a_part_that_is_lost_is_done_again(self):
        tried = []

        def does(which):
            tried.append(which)
            if len(tried) % 3 == 1:
                raise Lost
            return Done(4, "", b"") if len(tried) % 3 == 2 else Done(0, "", (FIRST + which + "\n").encode())

        texts = [done.text.decode() for done in self.all_of(does)]
        self.assertEqual(texts, [FIRST + "%d/3\n" % k for k in (1, 2, 3)])
        self.assertEqual(len(tried), 9)


class Slow(Exception):
    pass


class Nodes:
    """A Ray that answers at the third time it is asked, and one of whose nodes is that of this process."""

    exceptions = types.SimpleNamespace(GetTimeoutError=Slow)

    def __init__(self, *alive):
        self.alive, self.asked = alive, 0

    def nodes(self):
        return [{"NodeID": str(k), "Alive": alive} for k, alive in enumerate(self.alive)]

    def get_runtime_context(self):
        return types.SimpleNamespace(get_node_id=lambda: "1")

    def get(self, futures, timeout):
        self.asked += 1
        if self.asked < 3:
            raise Slow
        return futures

    def wait(self, futures, num_returns, timeout):
        self.asked += 1
        return (futures[:1], futures[1:]) if self.asked == 3 else ([], futures)


class Waiting(unittest.TestCase):
    def test_as_long_as_there_is_a_node(self):
        self.assertEqual(answers(Nodes(False, True), ["a", "b"]), ["a", "b"])
        self.assertEqual(ready(Nodes(True, True), ["a", "b"]), ["a"])

    def test_not_for_what_is_lost(self):
        """Ray would wait for ever."""
        for alive in ((), (True, False), (False,)):
            for wait in (answers, ready):
                with self.subTest((alive, wait)), self.assertRaisesRegex(ClusterFailed, "is lost") as caught:
                    wait(Nodes(*alive), ["a"])
                self.assertEqual(caught.exception.code, 4)


if __name__ == "__main__":
    unittest.main()
