"""Builds what is measured, and runs it: how to call each program, and how to read what it says."""

import json
import os
import re
import shutil
import subprocess
import tempfile

from comparing.peers import ROOT, RUST_HINT, Missing, run, say

HERE = os.path.dirname(os.path.abspath(__file__))
# Options of scc that switch what makes a state space smaller. One place to change when they change.
REDUCTIONS = ["symmetry", "translation", "order", "jump", "slice"]
ALL_OFF = ["--no-reduce", "all"]
# The graph of the calculus: that time passes over the ends of steps that change nothing is one of its rules (Jump).
WHOLE = ["--no-reduce", "symmetry,translation,order,slice,drift"]


def without(names):
    return ["--no-reduce", ",".join(names)] if names else []


class Failed(Exception):
    """A run that did not end well; the text says how."""


class Run:
    """What one run of one program said, and what it took: seconds of the processor, and peak memory in bytes."""

    def __init__(self, states, transitions, seconds, memory, note=""):
        self.states, self.transitions = states, transitions
        self.seconds, self.memory, self.note = seconds, memory, note


def measure(command, timeout, codes=(0,)):
    """(output, seconds of user and system, bytes of the peak resident set). GNU time is small, so that what it says
    of its child's memory is the child's: a child of Python would begin with what Python holds."""
    with tempfile.NamedTemporaryFile("r") as report:
        timed = ["time", "-q", "-o", report.name, "-f", "%U %S %M"] + command
        timed[0] = shutil.which("time")
        try:
            done = subprocess.run(timed, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=timeout)
        except subprocess.TimeoutExpired:
            raise Failed("more than %d s" % timeout) from None
        figures = report.read().split()
    if done.returncode not in codes or len(figures) != 3:
        said = (done.stderr or done.stdout).strip().splitlines()
        raise Failed("exit code %d: %s" % (done.returncode, said[-1] if said else ""))
    return done.stdout, float(figures[0]) + float(figures[1]), int(figures[2]) * 1024


class Scc:
    """scc check of a model of this folder."""

    name = "scc"

    def __init__(self, program, prefix, timeout):
        self.program, self.prefix, self.timeout = program, prefix, timeout
        manual = subprocess.run([program, "check", "--help=plain"], stdout=subprocess.PIPE, text=True).stdout
        self.reduces = "--no-reduce" in manual

    def check(self, model, n, options=(), timeout=None):
        path = os.path.join(HERE, model + ".sc")
        command = [self.program, "check", path, "-D", "n=%d" % n, "--json"] + list(options)
        # 2 and 4 are bounds that were reached; 1 is a property that is violated, which none of these is.
        out, seconds, memory = measure(self.prefix + command, timeout or self.timeout, codes=(0, 2, 4))
        answer = json.loads(out)
        explored = answer["explored"]
        note = "; ".join(p["text"] for p in answer["properties"])
        return Run(explored["states"], explored["transitions"], seconds, memory, note)

    def unreduced(self):
        return WHOLE if self.reduces else []

    def chain(self, n):
        # All that counts is explored: the bounds only have to be out of the way.
        options = ["--states", str(2 ** (n + 1)), "--memory", "16384"] + self.unreduced()
        return self.check("bonds", n, options)


class Stateright:
    def __init__(self, version, program, mode, prefix, timeout):
        self.name = "stateright %s, %s" % (version, mode)
        self.program, self.mode, self.prefix, self.timeout = program, mode, prefix, timeout

    def chain(self, n):
        out, seconds, memory = measure(self.prefix + [self.program, self.mode, str(n)], self.timeout)
        said = dict(line.split() for line in out.splitlines())
        return Run(int(said["states"]), int(said["transitions"]), seconds, memory, said["conserved"])


def promela(n):
    """chain-n in Promela. The loop has one choice for each bond and one for time; the text is all of the model, since
    a choice by index would take steps of its own."""
    splits = "".join(
        "  :: d_step { bond[%d] -> bond[%d] = 0; bonds--; pieces++; assert(bonds + pieces == N + 1) }\n" % (b, b)
        for b in range(n))
    return ("#define N %d\nbit bond[N] = 1;\nbyte bonds = N;\nbyte pieces = 1;\n\n"
            "active proctype chain() {\nend:\n  do\n%s  :: bonds > 0\n  od\n}\n" % (n, splits))


class Spin:
    """Spin makes a program for each n, in a folder for each way to compile it."""

    VARIANTS = {"SPIN, depth first": [], "SPIN, COLLAPSE": ["-DCOLLAPSE"], "SPIN, breadth first": ["-DBFS"]}

    def __init__(self, name, work, prefix, timeout):
        self.name, self.prefix, self.timeout = name, prefix, timeout
        self.folder = os.path.join(work, re.sub(r"\W+", "-", name.lower()))

    def build(self, n):
        folder = os.path.join(self.folder, str(n))
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, "chain.pml"), "w") as file:
            file.write(promela(n))
        # Every transition counts, so no partial order reduction.
        compile_ = ["gcc", "-O3", "-DSAFETY", "-DNOREDUCE", "-DMEMLIM=65536"] + self.VARIANTS[self.name]
        for command in (["spin", "-a", "chain.pml"], compile_ + ["-o", "pan", "pan.c"]):
            code, output = run(command, cwd=folder)
            if code != 0:
                raise Failed("%s: %s" % (command[0], output.strip()[-300:]))
        return os.path.join(folder, "pan")

    def chain(self, n):
        # As many places in the hash table as states: its default would be too large for most n.
        command = [self.build(n), "-m10000", "-w%d" % max(n, 10)]
        out, seconds, memory = measure(self.prefix + command, self.timeout)

        def number(what):
            found = re.search(r"^ *([\d.e+]+) %s" % what, out, re.M)
            if not found:
                raise Failed("it does not say how many %s" % what)
            return int(float(found.group(1)))

        holds = re.search(r"errors: 0\b", out) is not None
        # Its transitions are the states that it stored and those that it met again: no transition leads to the first.
        return Run(number("states, stored"), number(r"transitions \(") - 1, seconds, memory,
                   "holds" if holds else "violated")


def build_scc():
    """The program scc itself, as it is released."""
    target = os.path.join(ROOT, os.environ.get("DUNE_BUILD_DIR", "_release"))
    code, output = run(["sh", "-c", ". scripts/dependencies.sh && require build"], cwd=ROOT)
    if code != 0:
        raise Missing("scc's own dependencies:\n" + output)
    code, output = run(["dune", "build", "--profile", "release", "--build-dir", target, "bin/main.exe"], cwd=ROOT)
    if code != 0:
        raise Missing("scc does not build:\n" + output)
    return os.path.join(target, "default", "bin", "main.exe")


def build_stateright(work, prefix, timeout):
    if shutil.which("cargo") is None:
        raise Missing("stateright: no cargo; it needs %s" % RUST_HINT)
    target = os.path.join(work, "cargo-checker")
    code, output = run(["cargo", "build", "--release", "--locked", "--target-dir", target],
                       cwd=os.path.join(HERE, "rust"))
    if code != 0:
        raise Missing("stateright does not build (the crates come from crates.io):\n%s" % output)
    return [Stateright(version, os.path.join(target, "release", "chain-" + name), mode, prefix, timeout)
            for name, version in (("now", "0.31"), ("before", "0.30")) for mode in ("bits", "bools", "bodies")]


def build_spin(work, prefix, timeout):
    for program in ("spin", "gcc"):
        if shutil.which(program) is None:
            raise Missing("SPIN: no %s; apt-get install spin gcc" % program)
    return [Spin(name, work, prefix, timeout) for name in Spin.VARIANTS]


def build_peers(work, prefix, timeout):
    """The programs that could be built, and what is missing, in words."""
    os.makedirs(work, exist_ok=True)
    programs, missing = [], []
    for name, build in (("stateright", build_stateright), ("SPIN", build_spin)):
        say("building %s" % name)
        try:
            programs += build(work, prefix, timeout)
        except Missing as lack:
            missing.append(str(lack))
            say("  left out: %s" % lack)
    return programs, missing
