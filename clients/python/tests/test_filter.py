"""The client of ``scc successors``, against programs that are none, or end otherwise than they should."""

import os
import tempfile
import unittest

from shapecalculus import successors
from shapecalculus.successors import Filter, FilterFailed, FilterLost

HEADER = '{"format": "scc-successors", "version": %d, "goals": []}' % successors.VERSION


class Programs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        patience, successors.PATIENCE = successors.PATIENCE, 0.3
        self.addCleanup(setattr, successors, "PATIENCE", patience)

    def script(self, text, mode=0o755):
        path = os.path.join(self.folder.name, "scc")
        with open(path, "w", encoding="utf-8") as f:
            f.write("#!/bin/sh\n" + text)
        os.chmod(path, mode)
        return path

    def test_no_header(self):
        below = os.path.join(self.folder.name, "none")
        for scc in (below, self.folder.name, "/bin/true", "/bin/false", "/bin/echo", self.script("", 0o644)):
            with self.subTest(scc), self.assertRaises(FilterFailed) as caught:
                Filter("m.sc", scc=scc)
            self.assertNotIsInstance(caught.exception, FilterLost)
        for text, kind in [
            ("echo '[]'", FilterFailed),
            ("echo '{}'", FilterFailed),
            ("printf '\\377\\n'", FilterFailed),
            ("printf '{'; exit 3", FilterFailed),
            ("printf '{'; exec >&-; exec sleep 600", FilterLost),  # it is ended
            ("echo no >&2; exit 70", FilterLost),
            ("kill -9 $$", FilterLost),
        ]:
            with self.subTest(text), self.assertRaises(FilterFailed) as caught:
                Filter("m.sc", scc=self.script(text))
            self.assertIs(type(caught.exception), kind)

    def test_much_is_said(self):
        """More than a pipe holds, before anything is answered."""
        say = "echo 'warning: a warning of fifty characters or so, no more' >&2"
        many = "i=0; while [ $i -lt 3000 ]; do %s; i=$((i+1)); done\n" % say
        f = Filter("m.sc", scc=self.script(many + "echo '%s'; read line; kill -9 $$" % HEADER))
        with self.assertRaisesRegex(FilterLost, "^warning"):
            f.run(0, [])
        f.close()

    def test_half_a_line(self):
        for end, kind in [("exit 0", FilterFailed), ("kill -9 $$", FilterLost)]:
            f = Filter("m.sc", scc=self.script("echo '%s'; read line; printf '{\"sched'; %s" % (HEADER, end)))
            with self.assertRaises(FilterFailed) as caught:
                f.run(0, [])
            self.assertIs(type(caught.exception), kind)
            f.close()

    def test_deaf(self):
        f = Filter("m.sc", scc=self.script("trap '' TERM; echo '%s'; exec sleep 600" % HEADER))
        f.close()
        self.assertIsNotNone(f.process.returncode)


if __name__ == "__main__":
    unittest.main()
