"""A process that is killed leaves no scc behind."""

import os
import signal
import subprocess
import sys
import time
import unittest

from .support import CLIENT, program

ENDLESS = """
import <solids>
process a = solids.Cube(1) mass 1 [nil]
process b = solids.Cube(1) mass 1 at translate (100, 0, 0) [nil]
process c = solids.Cube(1) mass 1 at translate (200, 0, 0) [nil]
timestep 1
motion a = choose { (1, 0, 0) weight 1, (0, 1, 0) weight 1, (0, 0, 1) weight 1 }
motion b = choose { (1, 0, 0) weight 1, (0, 1, 0) weight 1, (0, 0, 1) weight 1 }
motion c = choose { (1, 0, 0) weight 1, (0, 1, 0) weight 1, (0, 0, 1) weight 1 }
check never : always x(a) < 1000000
"""

CALLS = {
    "check": "check(model, states=10**9, jobs=2)",
    "oracle": "Oracle().check(model, states=10**6)",
}


def processes(word):
    """The processes whose environment contains a word, which are those that a test has started, but for its own."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open("/proc/%s/environ" % name, "rb") as file:
                ours = word.encode() in file.read()
            with open("/proc/%s/stat" % name, encoding="ascii", errors="replace") as file:
                state = file.read().rsplit(")", 1)[1].split()[0]
        except OSError:
            continue
        if ours and state != "Z":
            found.append(int(name))
    return found


def wait(condition, seconds=600):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True


@unittest.skipIf(program() is None, "no scc: name it in the environment variable SCC")
@unittest.skipUnless(sys.platform.startswith("linux"), "a service of Linux")
class Killed(unittest.TestCase):
    def killed(self, call, least):
        mark = "SHAPECALCULUS_TEST=%d-%d" % (os.getpid(), time.monotonic_ns())
        name, value = mark.split("=")
        environment = dict(os.environ, PYTHONPATH=os.path.join(CLIENT, "src"), SCC=program(), **{name: value})
        text = "from shapecalculus import Oracle, check\nmodel = %r\n%s\n" % (ENDLESS, call)
        parent = subprocess.Popen([sys.executable, "-c", text], env=environment)
        try:
            self.assertTrue(wait(lambda: len(processes(mark)) >= least), "it was not started")
            time.sleep(0.5)
            self.assertIsNone(parent.poll(), "it has ended by itself")
            parent.kill()
            parent.wait()
            self.assertTrue(wait(lambda: not processes(mark)), "something is left")
        finally:
            for left in processes(mark):
                os.kill(left, signal.SIGKILL)
            parent.wait()

    def test_command_with_workers(self):
        self.killed(CALLS["check"], 3)

    def test_oracle(self):
        self.killed(CALLS["oracle"], 2)


if __name__ == "__main__":
    unittest.main()
