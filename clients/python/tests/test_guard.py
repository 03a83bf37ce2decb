"""The guard: 0, 1 and 2 come from finished verdicts only, whatever happens to the worker and to any stream."""

import contextlib
import errno
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from .support import CLIENT

PROGRAM = ("-S", os.path.join(CLIENT, "tests", "guarded.py"))
REPORT = b"report\n"
STREAMS = ("there", "closed", "full", "gone")


def environment():
    return dict(os.environ, PYTHONPATH=os.path.join(CLIENT, "src"), PYTHONDONTWRITEBYTECODE="1")


@contextlib.contextmanager
def started(words, out="there", err="there", before=lambda: None):
    """A program with such streams, and with signals as by default, whoever has ignored them before."""
    with contextlib.ExitStack() as files:

        def stream(how):
            if how == "gone":
                reader, writer = os.pipe()
                os.close(reader)
                files.callback(os.close, writer)
                return writer
            if how == "full":
                return files.enter_context(open("/dev/full", "wb"))
            return subprocess.PIPE if how == "there" else subprocess.DEVNULL

        def prepare():
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                signal.signal(number, signal.SIG_DFL)
            for fd, how in ((1, out), (2, err)):
                if how == "closed":
                    os.close(fd)
            before()

        p = subprocess.Popen(words, stdout=stream(out), stderr=stream(err), env=environment(), preexec_fn=prepare)
        try:
            yield p
        finally:
            p.kill()
            p.communicate()


def run(*words, **how):
    with started([sys.executable, *words], **how) as p:
        out, err = p.communicate(timeout=120)
        return p.returncode, out or b"", (err or b"").decode()


def guarded(*words, **how):
    return run(*PROGRAM, *map(str, words), **how)


def lives(pid):
    try:
        with open("/proc/%d/stat" % pid) as f:
            return f.read().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


class Endings(unittest.TestCase):
    def test_verdicts(self):
        for code in (0, 1, 2, 3):
            self.assertEqual(guarded("verdict", code), (code, REPORT, ""))

    def test_without_a_verdict(self):
        """However the worker ends."""
        ended = [("exit", code) for code in (0, 1, 2, 3, 70)] + [("sys-exit", code) for code in (0, 1)]
        ended += [("signal", int(number)) for number in (signal.SIGKILL, signal.SIGSEGV, signal.SIGABRT)]
        for words in [*ended, ("closes",)]:
            with self.subTest(words):
                code, out, said = guarded(*words)
                self.assertEqual((code, out), (4, b""))
                self.assertRegex(said, r"guarded: the work is lost.*; go on\n$")

    def test_a_report_alone_is_no_verdict(self):
        for how in (0, 1, 2):
            self.assertEqual(guarded("after-report", how)[:2], (4, REPORT))

    def test_exceptions(self):
        for words, code, said in [
            (("failed", 3), 3, "guarded: no\n"),
            (("failed", 64), 64, "guarded: no\n"),
            (("failed", 1), 70, "guarded: no\n"),  # as of a program that ended so
            (("fault",), 70, "IndexError"),
            (("base",), 70, "GeneratorExit"),
            (("memory",), 4, "a limit of resources"),
            (("thread",), 4, "a limit of resources"),
            (("errno", errno.EMFILE), 4, "a limit of resources"),
            (("errno", errno.ENOSPC), 74, "cannot write"),
            (("interrupt",), 4, "interrupted; go on"),
        ]:
            with self.subTest(words):
                found, out, text = guarded(*words)
                self.assertEqual((found, out), (code, b""))
                self.assertIn(said, text)

    def test_nothing_after_a_verdict_changes_it(self):
        self.assertEqual(guarded("many")[0], 0)
        self.assertEqual(guarded("slow-ending", 1)[:2], (1, REPORT))


class Streams(unittest.TestCase):
    def test_standard_output_is_the_report_alone(self):
        code, out, err = guarded("notices")
        self.assertEqual((code, out, err.count("notice")), (0, REPORT, 6))
        self.assertEqual(guarded("notices", err="closed")[:2], (0, REPORT))

    def test_all_streams_and_endings(self):
        ways = [(("verdict", 1), 1), (("failed", 3), 3), (("exit", 1), 4)]
        writes = {"there": None, "closed": 74, "full": 74, "gone": 4}
        for words, expected in ways:
            for out in STREAMS:
                for err in STREAMS:
                    with self.subTest((words, out, err)):
                        code, text, said = guarded(*words, out=out, err=err)
                        whole = words[0] == "verdict"
                        self.assertEqual(code, writes[out] if whole and writes[out] else expected)
                        self.assertEqual(text, REPORT if whole and out == "there" else b"")
                        self.assertNotEqual((code == 74, "cannot write" in said), (True, err != "there"))

    def test_without_any_stream(self):
        def close():
            os.close(0)

        self.assertEqual(guarded("verdict", 1, out="closed", err="closed", before=close)[0], 74)
        self.assertEqual(guarded("failed", 3, out="closed", err="closed", before=close)[0], 3)
        self.assertEqual(guarded("verdict", 1, before=close)[:2], (1, REPORT))

    def test_a_slow_reader(self):
        with started([sys.executable, *PROGRAM, "many"]) as p:
            out = b""
            while True:
                piece = os.read(p.stdout.fileno(), 997)
                if not piece:
                    break
                out += piece
            self.assertEqual((p.wait(60), len(out)), (0, 400_000 + len(REPORT)))

    def test_a_reader_that_goes(self):
        with started([sys.executable, *PROGRAM, "many"]) as p:
            os.read(p.stdout.fileno(), 10)
            p.stdout.close()
            self.assertEqual(p.wait(60), 4)


class Signals(unittest.TestCase):
    def deaf(self, *words, **how):
        """A worker that hears nothing, and a process that it has started."""
        streams = contextlib.ExitStack()
        self.addCleanup(streams.close)
        p = streams.enter_context(started([sys.executable, *PROGRAM, *(words or ["deaf"])], **how))
        return p, [int(pid) for pid in p.stderr.readline().split()[1:]]

    def gone(self, pids):
        end = time.monotonic() + 60
        while any(map(lives, pids)) and time.monotonic() < end:
            time.sleep(0.01)
        self.assertEqual((len(pids), [p for p in pids if lives(p)]), (2, []))

    def test_each_is_heard_and_nothing_is_left(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number):
                p, pids = self.deaf()
                p.send_signal(number)
                self.assertEqual(p.communicate(timeout=60)[1], b"guarded: interrupted; go on\n")
                self.assertEqual(p.returncode, 4)
                self.gone(pids)

    def test_nobody_reads(self):
        with started([sys.executable, *PROGRAM, "many"]) as p:
            os.read(p.stdout.fileno(), 1)
            time.sleep(0.2)  # most likely it waits by now
            p.send_signal(signal.SIGTERM)
            self.assertEqual(p.wait(60), 4)

    def test_after_a_verdict(self):
        p, pids = self.deaf("slow-ending", "1")
        self.assertEqual(p.stdout.read(), REPORT)
        p.send_signal(signal.SIGTERM)
        self.assertEqual(p.wait(60), 1)
        self.gone(pids)

    def test_what_was_ignored_stays_so(self):
        def ignore():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)

        p, pids = self.deaf(before=ignore)
        p.send_signal(signal.SIGHUP)
        os.kill(pids[0], signal.SIGKILL)
        self.assertRegex(p.communicate(timeout=60)[1], b"the work is lost .signal 9.")
        self.gone(pids)

    def test_what_was_blocked_is_heard(self):
        p, pids = self.deaf(before=lambda: signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGTERM]))
        p.send_signal(signal.SIGTERM)
        self.assertEqual(p.wait(60), 4)
        self.gone(pids)

    def test_a_guard_that_is_killed(self):
        p, pids = self.deaf()
        p.kill()
        self.assertEqual(p.wait(60), -signal.SIGKILL)
        self.gone(pids)


COMMAND = ("-m", "shapecalculus.cluster_command")

#: A module in the place of Ray, whose `init` does something.
RAY = """
import os, sys, types
from shapecalculus import cluster_command
def init(**options):
    print("(raylet) is terminated"); os.write(1, b"(raylet) is terminated\\n")
    %s
sys.modules["ray"] = types.SimpleNamespace(is_initialized=lambda: False, init=init, shutdown=lambda: None)
sys.exit(cluster_command.main(sys.argv[1:]))
"""


class Command(unittest.TestCase):
    def test_help_and_usage(self):
        code, out, said = run(*COMMAND, "--help")
        self.assertEqual((code, out[:18], said), (0, b"usage: scc-cluster", ""))
        self.assertEqual(run(*COMMAND, "check", "--help", out="full")[0], 74)
        self.assertEqual(run(*COMMAND, "check", "--help", out="closed")[0], 74)
        for err in STREAMS:
            self.assertEqual(run(*COMMAND, "check", err=err)[:2], (64, b""))

    def test_without_ray(self):
        program = "import sys; sys.modules['ray'] = None\nfrom shapecalculus import cluster_command\n"
        with tempfile.TemporaryDirectory() as folder:
            model = os.path.join(folder, "m.sc")
            with open(model, "w") as file:
                file.write("process p = box(1, 1, 1) mass 1 at translate (0, 0, 0) velocity (1, 0, 0) [nil]\n")
                file.write("check far : possibly x(p) >= 2\n")
            code, out, said = run("-c", program + "sys.exit(cluster_command.main(['check', %r]))" % model)
        self.assertEqual((code, out), (64, b""))
        self.assertIn("pip install", said)


if __name__ == "__main__":
    unittest.main()
