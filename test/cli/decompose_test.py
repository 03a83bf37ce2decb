"""What scc does with a solid that takes long to be cut into parts: progress, Ctrl-C, and the bound of seconds; alone,
and in a model.

    decompose_test.py SCC
"""

import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest

import interrupt
import terminal_test
from terminal_test import HANG, Session, has_terminals
from terrain import terrain

SIDE = 60
LINE = re.compile(r"(looking at \d+ faces|cutting: \d+ cells? looked at)")


class Long(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.mesh = self.file("terrain.off", terrain(SIDE))

    def file(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    @unittest.skipUnless(has_terminals(), "no pseudo-terminals here")
    def test_progress_and_interrupt(self):
        session = Session("decompose", self.mesh, "-o", self.mesh + ".obj")
        self.assertTrue(session.wait_for(lambda s: "looking at" in s or "cutting" in s), session.seen[-300:])
        session.interrupt()
        code, text = session.end()
        self.assertEqual((code, text), (4, ""))
        self.assertTrue(LINE.search(session.seen), session.seen[-300:])
        told = "scc: interrupted: nothing was written"
        self.assertIn(told, session.seen)
        self.assertFalse(os.path.exists(self.mesh + ".obj"))

    def test_seconds(self):
        done = subprocess.run([terminal_test.SCC, "decompose", self.mesh, "--seconds", "0.5"],
                              capture_output=True, text=True, timeout=HANG)
        told = "scc: the limit of 0.5 seconds has passed: nothing was written\n"
        self.assertEqual((done.returncode, done.stdout, done.stderr), (4, "", told))

    def test_seconds_in_json(self):
        done = subprocess.run([terminal_test.SCC, "decompose", self.mesh, "--seconds", "0.5", "--json"],
                              capture_output=True, text=True, timeout=HANG)
        self.assertEqual((done.returncode, done.stderr), (4, ""))
        report = json.loads(done.stdout)
        self.assertEqual((report["format"], report["exit"], report["diagnostics"]), ("scc-diagnostics", 4, []))

    def test_in_a_model(self):
        """The cutting is a step of reading the model, which has some seconds left to end by itself."""
        self.file("large.off", terrain(3 * SIDE))
        text = 'compound C = decompose "large.off" mass 1\nprocess p = C [nil]\ncheck still : always vx(p) = 0\n'
        model = self.file("model.sc", text)
        running = subprocess.Popen([terminal_test.SCC, "check", model], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        interrupt.wait(running, 0.5)
        running.send_signal(signal.SIGINT)
        out, err = running.communicate(timeout=HANG)
        told = "scc: interrupted, and the step that was under way did not end\n"
        self.assertEqual((running.returncode, out, err), (4, "", told))


if __name__ == "__main__":
    terminal_test.SCC = os.path.abspath(sys.argv.pop(1))
    result = unittest.main(exit=False).result
    bad = len(result.failures) + len(result.errors)
    print("%d passed, %d failed" % (result.testsRun - bad - len(result.skipped), bad))
    sys.exit(1 if bad else 0)
