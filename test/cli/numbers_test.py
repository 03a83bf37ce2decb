#!/usr/bin/env python3
"""Numbers on the command line, for each option of each command that has a value, as the manuals list them.

    numbers_test.py SCC [--all]

A negative number after an option means what it means when it is joined to the option. The option takes it, or it is
refused with words about the option. For an option that is a model time, a depth or a number of transitions, 0 is
accepted; for one of runs, states, processes, seconds or a step of time, it is refused. Each name of an option is tried
with one number; with --all, with all of them.
"""

import os
import re
import subprocess
import sys
import tempfile

SCC = os.path.abspath(sys.argv[1])
NEGATIVE = ["-5", "-1/2", "-.5", "-0"]
MODEL = "nowhere.sc"  # no option is so good that a command goes on without its file
FIRST = {"compare": [MODEL, MODEL], "diff": [MODEL, MODEL], "conform": [MODEL, MODEL], "oracle": []}
NEEDED = {
    "simulate": {"--runs": "1", "--observe": "time", "--every": "1", "--until": "1"},
    "sweep": {"--define": "x=1"},
    "explore": {"--output": "written.json", "--format": "json"},
    "export": {"--output": "written.obj"},
    "serve": {"--port": "0"},  # it would serve a model that is not there
}
# Options that stand beside a flag alone.
FLAGS = {("sweep", "--steps"): ["--estimate"], ("sweep", "--until"): ["--estimate"]}
FROM_ZERO = {"--time", "--until", "--depth", "--steps", "--at", "--svg", "--tolerance", "--graph", "--decimals"}
FROM_ONE = {"--runs", "--most", "--effort", "--states", "--jobs", "--seconds", "--every", "--memory", "--bits"}


def scc(*words):
    done = subprocess.run([SCC, *words], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
    return done.returncode, done.stdout, done.stderr


def manual(*words):
    return scc(*words, "--help=plain")[1]


def options(text):
    """The options with a value, by the longest of their names: all their names, and whether the value is text."""
    found = {}
    for line in re.findall(r"^       (-.*)", text, re.M):
        names = re.findall(r"(?:^|, )(--?[A-Za-z][a-z-]*)", line)
        if re.search(r"--[a-z-]+=[^\[]|^-[A-Za-z] ", line) and "--help" not in names:
            found[max(names, key=len)] = names
    return found


def call(command, option, words):
    needed = NEEDED.get(command, {})
    rest = [word for name, value in needed.items() if name != option for word in (name, value)]
    return scc(command, *words, *rest, *FLAGS.get((command, option), []), *FIRST.get(command, [MODEL]))


def joined(name, value):
    return name + ("=" if name.startswith("--") else "") + value


def main():
    commands = re.findall(r"^       ([a-z]+) ", manual().split("\nCOMMANDS")[1].split("\nCOMMON")[0], re.M)
    tried, wrong, zeros = 0, [], set()
    for command in commands:
        for option, names in options(manual(command)).items():
            for name in names:
                for value in NEGATIVE if "--all" in sys.argv else [NEGATIVE[tried % len(NEGATIVE)]]:
                    apart, together = call(command, option, [name, value]), call(command, option, [joined(name, value)])
                    tried += 1
                    if apart != together or "unknown option" in apart[2]:
                        wrong.append((command, name, value, apart, together))
            code, _, error = call(command, option, [option, "0"])
            if command != "serve" and option in FROM_ZERO | FROM_ONE:
                zeros.add(option)
                if (code == 64) != (option in FROM_ONE) or (code == 64 and option not in error):
                    wrong.append((command, option, "0", code, error))
    for fault in wrong:
        print(*fault)
    if tried < 150 or zeros != FROM_ZERO | FROM_ONE:
        wrong.append(None)
        print("too little was tried:", tried, sorted((FROM_ZERO | FROM_ONE) - zeros))
    print("%d numbers after options, %d wrong" % (tried, len(wrong)))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        main()
