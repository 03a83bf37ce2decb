#!/usr/bin/env python3
"""Limits of the system on the memory and the stack of the process: 0, 1 and 2 come from finished verdicts only.

    test/limits/memory.py SCC [--all] [--step KIB] [--verbose]

Runs commands under limits of addresses (ulimit -v), of data (ulimit -d) and of the stack (ulimit -s), from those under which
not even the libraries can be loaded to those that are enough. Each run ends as it does without a limit, with the same output; or with code 4,
says that a limit of memory or of the stack was met, and names no limit but the one that is set. What it writes to standard error
beside that is what it writes without a limit. Below what the system needs to load
the program, nothing of it runs: 126, 127, or a signal. Without --all, a share: every 37th run. In both cases, two commands run
in finer steps of the limit of data: one that does next to nothing, while the program begins, and one that needs a deep stack.
"""

import argparse
import collections
import functools
import os
import re
import resource
import subprocess
import sys
import tempfile

LONG = """param v = 1
shape C = box(1,1,1)
process p = C mass 1 velocity (v,0,0) [nil]
motion p = (vx + dt, vy, vz)
check far : always x(p) < 3000
"""
DEEP = LONG.replace("3000", " + ".join(["x(p)"] * 9000))
SHORT = LONG.replace("3000", "5").replace("always", "possibly")
COMMANDS = [
    ["--version"], ["check", "short.sc"], ["check", "--json", "short.sc"], ["check", "long.sc", "--states", "2000"],
    ["check", "short.sc", "--jobs", "2"], ["fmt", "short.sc"], ["trace", "short.sc", "--steps", "20"],
    ["sweep", "short.sc", "-D", "v=1..3"], ["sweep", "long.sc", "-D", "v=1,2", "--states", "2000"],
    ["explore", "short.sc", "--format", "aut", "-o", "-", "--states", "50"], ["compare", "short.sc", "short.sc", "--states", "50"],
    ["view", "short.sc", "-o", "page.html"], ["shape", "ell.off"], ["decompose", "ell.off"], ["check", "invalid.sc"],
    ["simulate", "short.sc", "--runs", "2", "--observe", "x(p)", "--every", "1", "--until", "3"],
    ["check", "--json", "long.sc", "--jobs", "2", "--states", "2000"], ["check", "none.sc"], ["fmt", "--none"], ["check", "deep.sc"], ["fmt", "deep.sc"],
]
# Limits of data, in KiB: OCaml 5 allocates while its own modules begin, and takes the stack from this memory.
FINE = [(["--version"], range(10000, 20000, 80)), (["fmt", "deep.sc"], range(20000, 40000, 250))]
STOPPED = 4
OF_MEMORY = re.compile(r"memory|no stack left|Cannot allocate|not enough", re.IGNORECASE)
NAMED = re.compile(r"limit of (\d+) MiB")

Done = collections.namedtuple("Done", "code out err")


def limits(step):
    """KiB of each limit. Close to where the program begins each step counts; later there is more room."""
    memory = [*range(1000, 60000, step), *range(60000, 200000, 10 * step)]
    return [
        ("addresses", resource.RLIMIT_AS, memory), ("data", resource.RLIMIT_DATA, memory),
        ("the stack", resource.RLIMIT_STACK, [*range(20, 200, 12), *range(200, 1300, step // 5)]),
    ]


def limited(limit, kib):
    def change():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if limit is not None:
            resource.setrlimit(limit, (kib * 1024, kib * 1024))

    return change


def run(command, folder, limit=None, kib=0, **environment):
    done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=120,
                          preexec_fn=limited(limit, kib), env={**os.environ, **environment})
    return Done(done.returncode, done.stdout, done.stderr.decode("utf-8", "replace"))


def loads(scc, folder, limit, kib):
    """Whether the system loads the program and its libraries: then it would run them."""
    try:
        return run([scc], folder, limit, kib, LD_TRACE_LOADED_OBJECTS="1").code == 0
    except OSError:
        return False


def strange(done, whole):
    """Lines on standard error that are none of scc."""
    known = whole.err.splitlines()
    return [line for line in done.err.splitlines() if line not in known and not line.startswith("scc: ")]


def fault(done, whole, kib):
    """What is wrong with a run of the program; nothing where all is well."""
    if strange(done, whole):
        return "it says: " + strange(done, whole)[0]
    if done.code == STOPPED:
        told = done.err + done.out.decode("utf-8", "replace")
        if not OF_MEMORY.search(told):
            return "code 4, and no word of memory: " + told[-200:]
        other = {n for n in NAMED.findall(told) if int(n) != kib // 1024}
        return "a limit of %s MiB is told of" % ", ".join(other) if other else None
    # A verdict stands without the run that shows it, if the report says so.
    if done.code == whole.code and b"left out" in done.out and OF_MEMORY.search(done.out.decode("utf-8", "replace")):
        return None
    if (done.code, done.out) != (whole.code, whole.out):
        return "code %d instead of %d%s: %s" % (
            done.code, whole.code, "" if done.out == whole.out else ", and another output", done.err[-200:])
    return None


def runs(step, every):
    """Each run that is made: the command, and the limit's name, kind and KiB."""
    number = 0
    for name, limit, sizes in limits(step):
        for kib in sizes:
            for words in COMMANDS:
                number += 1
                if number % every == 0:
                    yield words, name, limit, kib
    for words, sizes in FINE:
        for kib in sizes:
            yield words, "data", resource.RLIMIT_DATA, kib


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scc", type=os.path.abspath)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--step", type=int, default=500)
    parser.add_argument("--verbose", action="store_true")
    args = parser.parse_args()
    here = os.path.dirname(os.path.abspath(__file__))
    passed, failed, unloaded, seen = 0, 0, 0, collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("long.sc", LONG), ("deep.sc", DEEP), ("short.sc", SHORT), ("invalid.sc", SHORT + "check x : y\n")):
            with open(os.path.join(folder, name), "w") as file:
                file.write(text)
        with open(os.path.join(here, "..", "cli", "ell.off")) as mesh, open(os.path.join(folder, "ell.off"), "w") as copy:
            copy.write(mesh.read())
        wholes = {tuple(words): run([args.scc, *words], folder) for words in COMMANDS}
        loaded = functools.lru_cache(None)(lambda limit, kib: loads(args.scc, folder, limit, kib))
        for words, name, limit, kib in runs(args.step, 1 if args.all else 37):
            try:
                done = run([args.scc, *words], folder, limit, kib)
            except (OSError, subprocess.SubprocessError) as e:
                done = Done(126, b"", str(e))
            if done.code in (126, 127) or done.code < 0:
                wrong = "code %d: %s" % (done.code, done.err[-200:]) if loaded(limit, kib) else None
                unloaded += not loaded(limit, kib)
            else:
                wrong = fault(done, wholes[tuple(words)], kib)
            seen[done.code] += 1
            passed, failed = (passed, failed + 1) if wrong else (passed + 1, failed)
            if wrong or args.verbose:
                what = "%s, %d KiB of %s" % (" ".join(words), kib, name)
                print("%s %s: %s" % ("FAULT" if wrong else "ok   ", what, wrong or done.code), flush=True)
    print("not loaded: %d; codes: %s" % (unloaded, dict(sorted(seen.items()))))
    # Without either there was no limit that counts.
    if seen[STOPPED] == 0 or seen[0] == 0:
        print("no run was stopped, or all were")
        failed += 1
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
