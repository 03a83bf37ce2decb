#!/usr/bin/env python3
"""Exit codes under broken streams, and under signals: 0, 1 and 2 come from finished verdicts only.

    test/limits/streams.py SCC MODELS [--all] [--only TEXT] [--verbose]

MODELS is specs/models. Each way a command may end is run with its streams whole; then with each state of standard
input, output and error, alone and together, under a limit of open files or of the size of files, and with SIGPIPE as
it is and ignored. A standard error that is lost changes nothing. A standard output that is lost makes the code 74, or 4
where a reader has gone, if there was something to print. Then each command is signalled while it waits for its input,
while it works, and while it begins: from its first instruction on each command with --json prints one document, whose
exit code is that of the process. Nothing asks a clock: a signal is sent once the system tells that it is caught or
held, or that the pipe is open.

Without --all, a share of it, a few seconds.
"""

import argparse
import collections
import fcntl
import json
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

HANG = 120  # seconds until a run is taken to be one that does not end; nothing else depends on it
SQUARE = b"P2\n8 8\n1\n" + b"0 0 0 0 0 0 0 0 " * 2 + b"0 0 1 1 1 1 0 0 " * 4 + b"0 0 0 0 0 0 0 0 " * 2

ENDLESS = """shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)  e (-1,-1,1)  f (1,-1,1)  g (1,1,1)  h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
process p = Cube mass 1 velocity (1,0,0) [nil]
motion p = (vx + dt, vy, vz)
"""

Case = collections.namedtuple("Case", "name args code prints reads", defaults=(True, False))
Done = collections.namedtuple("Done", "code out err")


def cases(folder, models):
    """Every command, and every exit code that it can be brought to."""

    def m(name):
        return os.path.join(models, name + ".sc")

    def f(name):
        return os.path.join(folder, name)

    for name, text in (
            ("endless.sc", ENDLESS),
            ("holds.sc", ENDLESS + "check c : always x(p) > -5 within 2\n"),
            ("violated.sc", ENDLESS + "check c : always x(p) < 1 within 3\n"),
            ("undecided.sc", ENDLESS + "check c : always 1 / x(p) > -5 within 2\n"),
            ("bad.sc", "model bad\n?"),
            ("warned.sc", ENDLESS + "shape Spare = Cube\ncheck c : always x(p) > -5 within 2\n"),
            ("graph.aut", "des (0, 1, 2)\n(0, \"a\", 1)\n"), ("other.aut", "des (0, 1, 2)\n(0, \"b\", 1)\n")):
        with open(f(name), "w") as file:
            file.write(text)
    with open(f("solid.off"), "w") as file:
        file.write("OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
    with open(f("square.pgm"), "wb") as file:
        file.write(SQUARE)
    with open(f("holds.jsonl"), "w") as file:
        file.write('{"type": "header", "format": "scc-trace", "version": 1}\n')
    nowhere = "/nowhere/file"
    found = [
        Case("version", ["--version"], 0),
        Case("help", ["--help"], 0),
        Case("help-command", ["check", "--help"], 0),
        Case("help-groff", ["trace", "--help=groff"], 0),
        Case("nothing", [], 64, False),
        Case("no-command", ["nonsense"], 64, False),
        Case("check-0", ["check", f("holds.sc")], 0),
        Case("check-1", ["check", f("violated.sc")], 1),
        Case("check-2", ["check", f("undecided.sc")], 2),
        Case("check-3", ["check", f("bad.sc")], 3, False),
        Case("check-4", ["check", f("endless.sc"), "--seconds", "0.01", "--bits", "10000000", "--states",
                         "1000000000"], 4),
        Case("check-64", ["check", f("holds.sc"), "--nonsense"], 64, False),
        Case("check-74", ["check", f("holds.sc"), "--sarif", nowhere], 74),
        Case("check-json-0", ["check", f("holds.sc"), "--json"], 0),
        Case("check-json-3", ["check", f("bad.sc"), "--json"], 3),
        Case("check-stats", ["check", f("holds.sc"), "--stats"], 0),
        Case("check-warned", ["check", f("warned.sc")], 0),
        Case("check-none", ["check", f("none.sc")], 3, False),
        Case("check-jobs", ["check", m("hexokinase"), "--jobs", "2"], 1),
        Case("check-input", ["check", "-"], 3, False, True),
        Case("trace-0", ["trace", m("drift"), "--time", "2"], 0),
        Case("trace-3", ["trace", f("bad.sc")], 3, False),
        Case("trace-64", ["trace", f("holds.sc"), "--time", "x"], 64, False),
        Case("trace-input", ["trace", "-"], 3, False, True),
        Case("simulate-0", ["simulate", m("ruin"), "--runs", "2", "--observe", "x(walker)", "--every", "1", "--until", "2"], 0),
        Case("simulate-jobs", ["simulate", m("ruin"), "--runs", "4", "--jobs", "2", "--observe", "x(walker)", "--every", "1",
                               "--until", "2"], 0),
        Case("simulate-3", ["simulate", f("bad.sc"), "--runs", "1", "--observe", "x(p)", "--every", "1", "--until", "1"], 3, False),
        Case("estimate-3", ["estimate", f("bad.sc")], 3, False),
        Case("sweep-0", ["sweep", m("chain"), "-D", "n=2,3"], 0),
        Case("sweep-3", ["sweep", f("bad.sc"), "-D", "n=1"], 3),
        Case("view-64", ["view", f("holds.sc"), "--nonsense"], 64, False),
        Case("view-0", ["view", f("holds.sc"), "-o", f("page.html")], 0, False),
        Case("view-74", ["view", f("holds.sc"), "-o", nowhere], 74, False),
        Case("export-0", ["export", m("drift"), "--time", "1", "-o", f("run.csv")], 0, False),
        Case("export-74", ["export", m("drift"), "--time", "1", "-o", nowhere + ".csv"], 74, False),
        Case("explore-0", ["explore", m("hexokinase"), "--format", "aut", "-o", "-"], 0),
        Case("explore-file", ["explore", m("hexokinase"), "-o", f("g.aut")], 0, False),
        Case("explore-2", ["explore", m("hexokinase"), "-o", "-", "--format", "dot"], 0),
        Case("explore-74", ["explore", m("hexokinase"), "-o", nowhere + ".aut"], 74, False),
        Case("explain-3", ["explain", f("bad.sc")], 3, False),
        Case("compare-0", ["compare", f("graph.aut"), f("graph.aut")], 0),
        Case("compare-1", ["compare", f("graph.aut"), f("other.aut")], 1),
        Case("compare-3", ["compare", f("graph.aut"), f("bad.sc")], 3, False),
        Case("compare-64", ["compare", "-", "-"], 64, False),
        Case("conform-3", ["conform", f("holds.sc"), f("bad.sc")], 3, False),
        Case("diff-3", ["diff", f("bad.sc"), f("bad.sc")], 3, False),
        Case("shape-0", ["shape", f("solid.off")], 0),
        Case("shape-json-74", ["shape", f("solid.off"), "--json", "--svg", nowhere, "-o", nowhere + ".off"], 74),
        Case("shape-page-74", ["shape", f("solid.off"), "--json", "--view", nowhere], 74),
        Case("shape-3", ["shape", f("bad.sc")], 3, False),
        Case("inflate-0", ["inflate", f("square.pgm"), "-o", f("square.off")], 0),
        Case("inflate-3", ["inflate", f("bad.sc"), "-o", f("square.off")], 3, False),
        Case("decompose-0", ["decompose", f("ell.off")], 0),
        Case("decompose-74", ["decompose", f("ell.off"), "--json", "-o", nowhere + ".obj"], 74),
        Case("inflate-74", ["inflate", f("square.pgm"), "--json", "-o", nowhere + ".off"], 74),
        Case("check-json-74", ["check", f("violated.sc"), "--json", "--sarif", nowhere, "--witness", nowhere + "-runs"], 74),
        Case("compare-74", ["compare", f("graph.aut"), f("other.aut"), "--json", "--write", nowhere], 74),
        Case("conform-74", ["conform", f("holds.sc"), f("holds.jsonl"), "--json", "--run", nowhere], 74),
        Case("decompose-3", ["decompose", f("bad.sc")], 3, False),
        Case("oracle-0", ["oracle"], 0, False, True),
        Case("oracle-64", ["oracle", "--seconds", "x"], 64, False),
        Case("successors-0", ["successors", m("hexokinase")], 0, True, True),
        Case("successors-3", ["successors", f("bad.sc")], 3, False),
        Case("fmt-0", ["fmt", m("drift")], 0),
        Case("fmt-3", ["fmt", f("bad.sc")], 3, False),
        Case("fmt-input", ["fmt", "-"], 3, False, True),
        Case("translate-0", ["translate", m("drift"), "--to", "xml"], 0),
        Case("translate-3", ["translate", f("bad.sc"), "--to", "xml"], 3, False),
        Case("serve-64", ["serve", "-"], 64, False),
    ]
    return found


# --- states of streams ---

def closed(n):
    return lambda: os.close(n)


def null(n):
    def put():
        fd = os.open("/dev/null", os.O_RDWR)
        os.dup2(fd, n)
    return put


def full(n):
    def put():
        fd = os.open("/dev/full", os.O_RDWR)
        os.dup2(fd, n)
    return put


def gone(n):
    """A pipe whose reader has ended."""
    def put():
        out, into = os.pipe()
        os.close(out)
        os.dup2(into, n)
        os.close(into)
    return put


def folder_of(n):
    def put():
        fd = os.open("/", os.O_RDONLY)
        os.dup2(fd, n)
    return put


def unread_input():
    """A file that is open for writing alone."""
    fd = os.open("/dev/null", os.O_WRONLY)
    os.dup2(fd, 0)


ERRORS = {"2 closed": closed(2), "2 full": full(2), "2 gone": gone(2)}
OUTPUTS = {"1 closed": closed(1), "1 full": full(1), "1 gone": gone(1)}
INPUTS = {"0 closed": closed(0), "0 folder": folder_of(0), "0 not for reading": unread_input}


class Sweep:
    def __init__(self, args, folder):
        self.args, self.folder = args, folder
        self.count, self.faults = 0, []

    def run(self, words, *changes, sigpipe=signal.SIG_DFL, keep=None):
        def begin():
            signal.signal(signal.SIGPIPE, sigpipe)
            for change in changes:
                change()

        env = dict(os.environ, TERM="xterm", LC_ALL="C")
        done = subprocess.run([self.args.scc, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, preexec_fn=begin, restore_signals=False, timeout=HANG, cwd=self.folder, env=env)
        self.count += 1
        return Done(done.returncode, done.stdout, done.stderr)

    def expect(self, what, done, codes, out=None):
        wrong = done.code not in codes or (out is not None and done.out != out)
        if wrong:
            self.faults.append(what)
        if wrong or self.args.verbose:
            told = done.err.decode("utf-8", "replace").strip()[-200:]
            print("%s %s: exit code %s for %s %s" % ("FAULT" if wrong else "ok   ", what, done.code, sorted(codes), told),
                  flush=True)

    # --- streams ---

    def whole(self, case):
        done = self.run(case.args)
        self.expect(case.name, done, {case.code} if not case.reads else {0, 3, case.code})
        if bool(done.out) != case.prints and not case.reads:
            self.expect(case.name + ": what it prints", done, set())
        if "--json" in case.args:
            self.documented(case.name, done)
        return done

    def documented(self, what, done):
        """One document, with the exit code of the process."""
        try:
            told = json.loads(done.out)["exit"]
        except ValueError:
            told = None
        if told != done.code:
            self.expect(what + ": its document has the exit code %s" % told, done, set())

    def streams(self, case, whole, pick):
        exact = "--stats" not in case.args and case.code != 4
        out = whole.out if exact else None
        pipes = (signal.SIG_DFL, signal.SIG_IGN)
        for name, change in pick(ERRORS):
            for sigpipe in pipes:
                self.expect("%s, %s" % (case.name, name), self.run(case.args, change, sigpipe=sigpipe), {whole.code}, out)
        for name, change in pick(OUTPUTS):
            lost = {4 if name == "1 gone" else 74} if whole.out else {whole.code}
            if whole.code == 74:
                lost.add(74)  # another output is lost, too
            for sigpipe in pipes:
                self.expect("%s, %s" % (case.name, name), self.run(case.args, change, sigpipe=sigpipe), lost)
        for name, change in pick(INPUTS):
            codes, kept = ({3}, None) if case.reads and case.name != "successors-3" else ({whole.code}, out)
            self.expect("%s, %s" % (case.name, name), self.run(case.args, change), codes, kept)
        lost = {74} if whole.out else {whole.code}
        for name, change in pick(OUTPUTS):
            for other, also in pick(ERRORS):
                if "gone" not in name:
                    self.expect("%s, %s, %s" % (case.name, name, other), self.run(case.args, change, also), lost)
        if not case.reads:
            self.expect(case.name + ", all closed", self.run(case.args, closed(0), closed(1), closed(2)), lost)

    def files(self, case, whole, pick):
        """Too few open files: a verdict is the one that it is, and whole, or none."""
        for n, _ in pick({n: None for n in range(3, 13)}):
            limit = (lambda n: lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (n, n)))(n)
            done = self.run(case.args, limit)
            what = "%s, %d open files" % (case.name, n)
            if done.code in (0, 1, 2):
                exact = "--stats" not in case.args
                self.expect(what, done, {whole.code}, whole.out if exact else None)
            else:
                # 127 and 126 are of what loads the program.
                self.expect(what, done, {3, 4, 64, 74, 126, 127})

    def midway(self, case, whole, pick):
        """Standard output is a file that may not become as large as it would."""
        for part, _ in pick({0.1: None, 0.5: None, 0.9: None}):
            size = int(len(whole.out) * part)
            path = os.path.join(self.folder, "out")

            def change():
                os.dup2(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o666), 1)
                resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

            if size < len(whole.out) and "-o" not in case.args:
                self.expect("%s, up to %d bytes" % (case.name, size), self.run(case.args, change), {74})

    def unblocking(self, case, whole):
        """Standard output is a pipe that would rather fail than wait, and whose reader is late."""
        out, into = os.pipe()
        fcntl.fcntl(into, fcntl.F_SETFL, os.O_NONBLOCK)
        fcntl.fcntl(into, fcntl.F_SETPIPE_SZ, 4096) if hasattr(fcntl, "F_SETPIPE_SZ") else None
        running = subprocess.Popen([self.args.scc, *case.args], stdin=subprocess.DEVNULL, stdout=into,
                                   stderr=subprocess.DEVNULL, cwd=self.folder)
        os.close(into)
        with open(out, "rb") as file:
            text = file.read()
        self.count += 1
        done = Done(running.wait(HANG), text, b"")
        self.expect(case.name + ", a late reader", done, {whole.code}, whole.out)

    # --- signals ---

    def caught(self, pid, number, masks=("SigCgt",)):
        """Waits until the program has said that it catches (or holds) a signal; False where it has ended."""
        while True:
            try:
                with open("/proc/%d/status" % pid) as file:
                    lines = dict(line.split(":", 1) for line in file if ":" in line)
            except FileNotFoundError:
                return False
            if lines["State"].split()[0] == "Z":
                return False
            if any(int(lines[mask], 16) >> (number - 1) & 1 for mask in masks):
                return True

    def asleep(self, pid, number, output=None):
        """Waits until the program waits, and lets a signal through: where an output is named, to write to it."""
        while True:
            if output is not None and not self.in_call_on(pid, output):
                time.sleep(0.001)
                continue
            with open("/proc/%d/status" % pid) as file:
                lines = dict(line.split(":", 1) for line in file if ":" in line)
            held = int(lines["SigBlk"], 16) >> (number - 1) & 1
            if lines["State"].split()[0] == "S" and not held and int(lines["SigCgt"], 16) >> (number - 1) & 1:
                return
            time.sleep(0.001)

    @staticmethod
    def in_call_on(pid, output):
        """Whether the first argument of the system call that the program is in is this descriptor; true if the system
        does not tell."""
        try:
            with open("/proc/%d/syscall" % pid) as file:
                words = file.read().split()
        except OSError:
            return True
        return len(words) > 1 and int(words[1], 16) == output

    def started(self, words, **more):
        return subprocess.Popen([self.args.scc, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                cwd=self.folder, **more)

    def ended(self, running):
        out, err = running.communicate(timeout=HANG)
        self.count += 1
        return Done(running.returncode, out, err)

    def of_input(self, words, number):
        """While it waits for standard input."""
        read, write = os.pipe()
        running = self.started(words, stdin=read)
        os.close(read)
        self.caught(running.pid, number)
        running.send_signal(number)
        self.expect("%s, %s at its input" % (" ".join(words), number.name), self.ended(running), {4})
        os.close(write)

    def of_pipe(self, words, number, opened):
        """While it waits for a named pipe: for somebody to open it, or for what is to come."""
        path = os.path.join(self.folder, "pipe")
        if not os.path.exists(path):
            os.mkfifo(path)
        running = self.started([path if w == "PIPE" else w for w in words], stdin=subprocess.DEVNULL)
        if opened:
            into = os.open(path, os.O_WRONLY)
        self.caught(running.pid, number)
        running.send_signal(number)
        what = "%s, %s at a pipe%s" % (" ".join(words), number.name, "" if opened else " that nobody opens")
        self.expect(what, self.ended(running), {4})
        if opened:
            os.close(into)

    def at_work(self, words, number, codes, steps, out=None):
        """After so many looks at what it does."""
        running = self.started(words, stdin=subprocess.DEVNULL)
        self.caught(running.pid, number)
        for _ in range(steps):
            self.caught(running.pid, number)
        running.send_signal(number)
        done = self.ended(running)
        self.expect("%s, %s after %d looks" % (" ".join(words), number.name, steps), done, codes)
        if b"did not end" in done.err:
            self.expect("%s: a step that does not end" % " ".join(words), done, set())

    def early(self, words, number, steps, whole):
        """From the first instruction of the program on: after so many looks. Not signalled, it ends as in whole."""
        running = self.started(words, stdin=subprocess.DEVNULL)
        for _ in range(steps + 1):
            self.caught(running.pid, number, ("SigBlk", "SigCgt"))
        running.send_signal(number)
        done = self.ended(running)
        what = "%s, %s at its beginning, after %d looks" % (" ".join(words), number.name, steps)
        self.expect(what, done, {4, whole.code})
        self.documented(what, done)

    def late(self, words, number, whole):
        """While it waits to write its document, into a pipe that is full: the work is done, and nothing changes."""
        out, into = os.pipe()
        fcntl.fcntl(into, fcntl.F_SETPIPE_SZ, 4096)
        filled = os.write(into, b" " * 4096)
        running = subprocess.Popen([self.args.scc, *words], stdin=subprocess.DEVNULL, stdout=into, stderr=subprocess.PIPE,
                                   cwd=self.folder)
        os.close(into)
        self.asleep(running.pid, number, output=1)
        running.send_signal(number)
        with open(out, "rb") as file:
            text = file.read()[filled:]
        done = Done(running.wait(HANG), text, running.stderr.read())
        running.stderr.close()
        self.count += 1
        self.expect("%s, %s as it writes its document" % (" ".join(words), number.name), done, {whole.code}, whole.out)

    def serving(self, number):
        running = self.started(["serve"], stdin=subprocess.DEVNULL)
        told = running.stdout.readline()
        running.send_signal(number)
        done = self.ended(running)
        self.expect("serve, %s" % number.name, done._replace(out=told), {0}, told)

    def unserved(self, pick):
        """A service whose address nobody can learn has no use."""
        for name, change in pick(OUTPUTS):
            self.expect("serve, " + name, self.run(["serve"], change), {4 if name == "1 gone" else 74})

    def without_hangup(self):
        """What nohup has started goes on when the terminal is closed."""
        def begin():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)

        running = self.started(["fmt", "-"], stdin=subprocess.PIPE, preexec_fn=begin)
        self.caught(running.pid, signal.SIGINT)
        running.send_signal(signal.SIGHUP)
        out, err = running.communicate(ENDLESS.encode(), timeout=HANG)
        self.expect("fmt -, SIGHUP under nohup", Done(running.returncode, out, err), {0})


WAITING = [
    ["check", "-"], ["check", "-", "--json"], ["trace", "-"], ["fmt", "-"], ["estimate", "-"], ["view", "-"],
    ["explore", "-", "--format", "aut", "-o", "-"], ["simulate", "-", "--runs", "1", "--observe", "x(p)", "--every", "1", "--until", "1"], ["sweep", "-", "-D", "n=1"],
    ["export", "-", "-o", "x.csv"], ["explain", "-"], ["compare", "-", "graph.aut"], ["compare", "graph.aut", "-"],
    ["conform", "holds.sc", "-"], ["diff", "-", "holds.sc"], ["shape", "-"], ["inflate", "-", "-o", "x.off"], ["decompose", "-"],
    ["translate", "-", "--to", "xml"], ["oracle"],
]
PIPES = [["check", "PIPE"], ["successors", "PIPE"], ["compare", "PIPE", "graph.aut"], ["trace", "holds.sc", "--schedule", "PIPE"],
         ["fmt", "PIPE"], ["inflate", "PIPE", "-o", "x.off"], ["conform", "holds.sc", "PIPE"]]
WORKING = [
    (["check", "LONG"], {4, 2}), (["check", "LONG", "--json"], {4, 2}), (["explore", "LONG", "-o", "x.json"], {4}),
    (["explore", "LONG", "--format", "dot", "-o", "-"], {4}), (["compare", "LONG", "LONG"], {4, 2}),
    (["compare", "LONG", "LONG", "--modulo", "trace"], {4, 2}), (["trace", "LONG", "--time", "1000000"], {4}),
    (["simulate", "LONG", "--runs", "1000000", "--observe", "x(p)", "--every", "1", "--until", "9"], {4}),
    (["view", "LONG", "-o", "x.html"], {4, 0}),
]
BEGINNING = [
    ["check", "holds.sc", "--json"], ["compare", "holds.sc", "violated.sc", "--json", "--states", "50"], ["decompose", "ell.off", "--json"],
    ["conform", "holds.sc", "run.jsonl", "--json"], ["diff", "run.jsonl", "run.jsonl", "--json"],
    ["estimate", "chance.sc", "--runs", "5", "--json"], ["explain", "runs/c.json", "--json"],
    ["inflate", "square.pgm", "--json", "-o", "square.off"], ["shape", "solid.off", "--json"],
]
SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scc", type=os.path.abspath)
    parser.add_argument("models", type=os.path.abspath)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--verbose", action="store_true")
    args = parser.parse_args()
    draw = random.Random(47)
    for number in SIGNALS:  # nohup, and shells for what runs beside them, ignore some
        signal.signal(number, signal.default_int_handler if number == signal.SIGINT else signal.SIG_DFL)

    def pick(states):
        items = list(states.items())
        return items if args.all else [draw.choice(items)]

    with tempfile.TemporaryDirectory() as folder:
        sweep = Sweep(args, folder)
        here = os.path.dirname(os.path.abspath(__file__))
        with open(os.path.join(here, "..", "cli", "ell.off")) as mesh, open(os.path.join(folder, "ell.off"), "w") as copy:
            copy.write(mesh.read())
        for case in cases(folder, args.models):
            if args.only not in case.name:
                continue
            whole = sweep.whole(case)
            sweep.streams(case, whole, pick)
            sweep.files(case, whole, pick)
            if whole.out and case.code != 4:
                sweep.midway(case, whole, pick)
                sweep.unblocking(case, whole)
        for words in WAITING:
            if args.only in " ".join(words):
                for _, number in pick({n.name: n for n in SIGNALS}):
                    sweep.of_input(words, number)
        for words in PIPES:
            if args.only in " ".join(words):
                for _, number in pick({n.name: n for n in SIGNALS}):
                    for opened in (False, True):
                        sweep.of_pipe(words, number, opened)
        with open(os.path.join(folder, "long.sc"), "w") as file:
            file.write(ENDLESS.replace("vx + dt", "if vx > 1000000 then 0 else vx + dt"))
        for words, codes in WORKING:
            if args.only in " ".join(words):
                words = ["long.sc" if w == "LONG" else w for w in words]
                for _, number in pick({n.name: n for n in SIGNALS}):
                    for steps in (0, 10, 1000, 10000, 50000) if args.all else (0, draw.choice((300, 3000))):
                        sweep.at_work(words, number, codes, steps)
        sweep.run(["check", "violated.sc", "--witness", "runs"])
        with open(os.path.join(folder, "run.jsonl"), "wb") as file:
            file.write(sweep.run(["trace", "holds.sc", "--time", "2"]).out)
        with open(os.path.join(folder, "chance.sc"), "w") as file:
            file.write(ENDLESS + "check c : P >= 1/2 [ eventually x(p) > 2 within 2 ]\n")
        for words in BEGINNING:
            if args.only in " ".join(words):
                whole = sweep.run(words)
                for _, number in pick({n.name: n for n in SIGNALS}):
                    for steps in range(0, 300, 3) if args.all else (0, 10, draw.randrange(20, 200)):
                        sweep.early(words, number, steps, whole)
                    sweep.late(words, number, whole)
        if args.only in "serve":
            for _, number in pick({n.name: n for n in SIGNALS}):
                sweep.serving(number)
            sweep.unserved(pick)
        if args.only in "nohup":
            sweep.without_hangup()
        print("%d runs, %d faults" % (sweep.count, len(sweep.faults)))
        sys.exit(1 if sweep.faults else 0)


if __name__ == "__main__":
    main()
