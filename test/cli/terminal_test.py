"""What scc does at a terminal: its line of progress, and Ctrl-C.

    terminal_test.py SCC FOLDER MODEL      FOLDER is test/bench/checker; MODEL goes on for ever after its checks

Standard error is a pseudo-terminal; the interrupt is the character that the terminal turns into one.
"""

import os
import pty
import re
import select
import signal
import subprocess
import sys
import time
import unittest

import interrupt

#: Seconds after which nothing is awaited any more: no judgment, but the end of what hangs.
HANG = 600

SCC = FOLDER = ENDLESS = None
LINE = re.compile(r"(\d+) states \(\d+/s\), \d+ to expand, depth \d+, model time [\d.e+]+, \d+ MiB(, at most \d+ \w+ left)?")


def has_terminals():
    """Some containers have no pseudo-terminals: there is nothing to test then, and it is said."""
    try:
        ends = pty.openpty()
    except OSError:
        return False
    for end in ends:
        os.close(end)
    return True


class Session:
    """scc with a terminal of its own, from which only standard output is taken away."""

    def __init__(self, *words):
        self.seen = ""
        out, self.out = os.pipe()
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.dup2(self.out, 1)
            os.execv(SCC, [SCC, *words])
        os.close(self.out)
        self.out = os.fdopen(out)

    def read(self):
        """What the terminal shows next; nothing when it is closed."""
        if not select.select([self.terminal], [], [], 1)[0]:
            return True
        try:
            more = os.read(self.terminal, 65536)
        except OSError:
            return False
        self.seen += more.decode("utf-8", "replace")
        return bool(more)

    def wait_for(self, found):
        end = time.monotonic() + HANG
        while not found(self.seen) and time.monotonic() < end and self.read():
            pass
        return found(self.seen)

    def interrupt(self):
        os.write(self.terminal, b"\x03")

    def wait_for_work(self, seconds):
        """Of the processor, and that Ctrl-C has an answer."""
        while not (interrupt.answers(self.pid) and interrupt.worked(self.pid) >= seconds):
            self.read()

    def end(self):
        """(exit code, standard output)."""
        text = self.out.read()
        while self.read():
            pass
        _, status = os.waitpid(self.pid, 0)
        os.close(self.terminal)
        self.out.close()
        return os.WEXITSTATUS(status) if os.WIFEXITED(status) else -os.WTERMSIG(status), text


def model(name):
    return os.path.join(FOLDER, name + ".sc")


LARGE = ["-D", "n=30", "--states", "100000000", "--memory", "2000"]


class Terminal(unittest.TestCase):
    @unittest.skipUnless(has_terminals(), "no pseudo-terminals here")
    def test_progress_and_interrupt(self):
        session = Session("check", model("bonds"), *LARGE)
        self.assertTrue(session.wait_for(lambda s: "left" in s), session.seen[-300:])
        # From the beginning on, a line says what is done.
        phases = [session.seen.find(what) for what in ("reading the model", "beginning to explore", " states")]
        self.assertTrue(0 <= phases[0] < phases[1] < phases[2], (phases, session.seen[:300]))
        session.interrupt()
        code, text = session.end()
        self.assertEqual(code, 4, text)
        line = LINE.search(session.seen)
        self.assertTrue(line and int(line.group(1)) > 0, session.seen[-300:])
        self.assertTrue("conserved: holds up to the bound: the interruption" in text, text)
        explored = re.search(r"^explored: (\d+) states, .*; not complete: stopped by the interruption$", text, re.M)
        self.assertTrue(explored, text)
        self.assertGreaterEqual(int(explored.group(1)), int(line.group(1)))
        # The line is wiped away in the end.
        self.assertTrue(session.seen.rstrip("^C\r\n").endswith("\x1b[K"), repr(session.seen[-100:]))

    @unittest.skipUnless(has_terminals(), "no pseudo-terminals here")
    def test_interrupt_of_many_states(self):
        """To look over each of them takes longer than a step may, and is not needed to tell what was found."""
        session = Session("check", model("bonds"), *LARGE)
        many = re.compile(r"([2-9]|\d\d)\d{6} states")
        if not session.wait_for(many.search):
            self.skipTest("not fast enough")
        session.interrupt()
        code, text = session.end()
        self.assertEqual(code, 4, text)
        self.assertIn("conserved: holds up to the bound: the interruption", text)
        self.assertRegex(text, r"explored: \d{7,} states")

    @unittest.skipUnless(has_terminals(), "no pseudo-terminals here")
    def test_interrupt_in_json(self):
        session = Session("check", model("bonds"), "--json", *LARGE)
        session.wait_for_work(0.5)
        session.interrupt()
        code, text = session.end()
        self.assertEqual(code, 4, text)
        self.assertIn('"verdict": "holds-up-to-bound"', text)
        self.assertIn('{"limit": "interrupted", "value": null, "origin": "user"}', text)
        self.assertNotIn("states", session.seen)

    def test_no_progress_without_terminal(self):
        command = [SCC, "check", model("bonds"), *LARGE, "--seconds", "2", "--jobs", "1"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=HANG)
        self.assertEqual((done.returncode, done.stderr), (4, ""))
        self.assertIn("holds up to the bound: ", done.stdout)

    def covered(self, text):
        """Of how many states the transitions were counted, and of how many that were found."""
        found = re.search(r"among the transitions of (\d+) of the (\d+) states found: more may fire", text)
        self.assertTrue(found, text)
        return int(found.group(1)), int(found.group(2))

    def test_coverage_within_seconds(self):
        """Its own exploration, which counts, keeps the limit as that of the checks does: it ends. How far both come by then
        is the machine's affair."""
        command = [SCC, "check", ENDLESS, "--coverage", "--seconds", "1"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=HANG)
        self.assertIn(done.returncode, (0, 4), done.stderr)
        self.assertEqual(done.returncode == 0, "2 properties: 2 hold\n" in done.stdout, done.stdout)
        looked_at, states = self.covered(done.stdout)
        self.assertTrue(0 <= looked_at < states, done.stdout)

    def test_coverage_interrupted(self):
        running = subprocess.Popen([SCC, "check", ENDLESS, "--coverage"], stdout=subprocess.PIPE, text=True)
        interrupt.wait(running, 2)
        running.send_signal(signal.SIGINT)
        text = running.communicate(timeout=HANG)[0]
        self.assertEqual(running.returncode, 0, text)
        self.assertTrue(0 < self.covered(text)[0], text)


if __name__ == "__main__":
    SCC, FOLDER, ENDLESS = (os.path.abspath(sys.argv.pop(1)) for _ in range(3))
    result = unittest.main(exit=False).result
    bad = len(result.failures) + len(result.errors)
    if result.skipped:
        print("%d tests were skipped: no pseudo-terminals here" % len(result.skipped))
    print("%d passed, %d failed" % (result.testsRun - bad - len(result.skipped), bad))
    sys.exit(1 if bad else 0)
