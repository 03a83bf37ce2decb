"""Which program is called, and what is said about one that cannot be started."""

import os
import stat
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

from shapecalculus import Oracle, ServiceError, _program, check

from .support import CLIENT

MODEL = "process p = Nothing [nil]\n"


class Choice(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.carried = os.path.join(folder.name, "scc")
        for patch in (mock.patch.object(_program, "CARRIED", self.carried), mock.patch.dict(os.environ)):
            patch.start()
            self.addCleanup(patch.stop)
        os.environ.pop("SCC", None)

    def carry(self, content, mode=0o755):
        with open(self.carried, "wb") as file:
            file.write(content)
        os.chmod(self.carried, mode)

    def test_order(self):
        self.assertEqual(_program.scc_path(None), "scc")
        self.carry(b"#!/bin/sh\n")
        self.assertEqual(_program.scc_path(None), self.carried)
        os.environ["SCC"] = "/the/one"
        self.assertEqual(_program.scc_path(None), "/the/one")
        self.assertEqual(_program.scc_path("mine"), "mine")

    def assert_refused(self, words):
        for start in (lambda: Oracle(), lambda: check(MODEL)):
            with self.assertRaisesRegex(ServiceError, words):
                start()

    def test_another_machine(self):
        # The head of a program for s390x.
        self.carry(b"\x7fELF\x02\x02\x01" + bytes(9) + b"\x00\x02\x00\x16" + bytes(100))
        self.assert_refused("cannot start .* for another machine than this one .* environment variable SCC")

    def test_no_right_to_run(self):
        self.carry(b"#!/bin/sh\n", stat.S_IRUSR)
        self.assert_refused("without the right to run programs")

    def test_no_loader(self):
        self.carry(b"#!/there/is/no/loader\n")
        self.assert_refused("a library or the loader that it names is missing")

    def test_no_program(self):
        os.environ["PATH"] = "/there/is/nothing"
        self.assert_refused("name the program in the environment variable SCC, or put it on the PATH")


class Command(unittest.TestCase):
    """The command `scc` of a wheel."""

    def run_main(self, carried, *words):
        text = "import sys; from shapecalculus import _program as p; p.CARRIED = sys.argv.pop(1); sys.exit(p.main())"
        environment = dict(os.environ, PYTHONPATH=os.path.join(CLIENT, "src"))
        return subprocess.run(
            [sys.executable, "-c", text, carried, *words], env=environment, capture_output=True, text=True, check=False
        )

    def test_becomes_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            carried = os.path.join(folder, "scc")
            with open(carried, "w", encoding="utf-8") as file:
                file.write('#!/bin/sh\necho "$@"\nexit 2\n')
            os.chmod(carried, 0o755)
            done = self.run_main(carried, "check", "a b")
        self.assertEqual((done.returncode, done.stdout), (2, "check a b\n"))

    def test_says_why_not(self):
        done = self.run_main("/there/is/no/scc", "check")
        self.assertEqual((done.returncode, done.stdout), (69, ""))
        self.assertIn("scc: cannot start /there/is/no/scc: No such file or directory", done.stderr)


if __name__ == "__main__":
    unittest.main()
