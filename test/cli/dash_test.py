#!/usr/bin/env python3
"""`-' as the name of an output.

    dash_test.py SCC

Takes each option for a file or folder from the manuals of all commands. An output that a command writes instead of
standard output takes `-' for it. All others refuse `-': exit code 64, and nothing is written. An option that is in
none of the lists below is an error.
"""
import os
import re
import subprocess
import sys
import tempfile

SCC = os.path.abspath(sys.argv[1])
OTHERS = tempfile.TemporaryDirectory()
MODEL, MESH, ICON = (os.path.join(OTHERS.name, name) for name in ("model.sc", "solid.off", "icon.svg"))
TEXT = """param v = 1
shape C = box(1,1,1)
process p = C mass 1 velocity (v,0,0) [nil]
check far : eventually x(p) > 2 within 9
"""
SWEPT = ["sweep", MODEL, "-D", "v=1,2"]
SIMULATED = ["simulate", MODEL, "--runs", "1", "--observe", "x(p)", "--every", "1", "--until", "2"]

# Outputs of which there is one: the command, and the ending of a file for them.
ALONE = {
    ("trace", "-o"): (["trace", MODEL], ".jsonl"),
    ("export", "-o"): (["export", MODEL, "--format", "obj"], ".obj"),
    ("view", "-o"): (["view", MODEL], ".html"),
    ("simulate", "-o"): (SIMULATED, ".csv"),
    ("sweep", "-o"): (SWEPT, ".csv"),
    ("explore", "-o"): (["explore", MODEL, "--format", "aut"], ".aut"),
    ("translate", "-o"): (["translate", MODEL, "--to", "xml"], ".xml"),
    ("check", "--invariant"): (["check", MODEL], None),
}
# Outputs beside another one, or that are no stream.
BESIDE = {
    ("check", "--draw"): ["check", MODEL], ("check", "--sarif"): ["check", MODEL], ("check", "--smt"): ["check", MODEL],
    ("check", "--store"): ["check", MODEL], ("check", "--witness"): ["check", MODEL],
    ("check", "--curve-plot"): ["check", MODEL],
    ("simulate", "--plot"): SIMULATED, ("simulate", "--view"): SIMULATED, ("simulate", "--resume"): SIMULATED, ("simulate", "--store"): SIMULATED,
    ("estimate", "--store"): ["estimate", MODEL], ("sweep", "--plot"): SWEPT, ("sweep", "--resume"): SWEPT, ("sweep", "--store"): SWEPT,
    ("compare", "--write"): ["compare", MODEL, MODEL], ("conform", "--run"): ["conform", MODEL, "run.jsonl"],
    ("shape", "-o"): ["shape", MESH], ("shape", "--svg"): ["shape", MESH], ("shape", "--view"): ["shape", MESH],
    ("inflate", "-o"): ["inflate", ICON], ("decompose", "-o"): ["decompose", MESH],
}
# What is read, where `-' is standard input.
INPUTS = {("trace", "--schedule"), ("export", "--schedule"), ("view", "--schedule"), ("view", "--trace")}
OPTION = re.compile(r" {7}(?:(-\S) \S+, )?(--[a-z-]+)=(?:FILE|OUT|DIR|PREFIX|PAGE|PICTURE)\b")
faults = []


def scc(words, folder):
    return subprocess.run([SCC, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def expect(holds, what):
    if not holds:
        faults.append(what)


def options(folder):
    """Each command with each of its options for files and folders."""
    commands = re.findall(r"^ {7}([a-z]+) ", scc(["--help=plain"], folder).stdout.decode().split("\nCOMMANDS\n")[1].split("\n\n\n")[0], re.M)
    expect(len(commands) > 15, "there are but %d commands" % len(commands))
    for command in commands:
        manual = scc([command, "--help=plain"], folder).stdout.decode()
        for line in manual.splitlines():
            found = OPTION.match(line)
            if found:
                yield command, found.group(1) or found.group(2)


def takes(option, words, ending, folder):
    name = " ".join([option[0], option[1], "-"])
    done = scc([*words, option[1], "-"], folder)
    expect(done.returncode in (0, 1, 2) and done.stdout, "%s: exit code %d, %d bytes: %s" % (
        name, done.returncode, len(done.stdout), done.stderr.decode()))
    if ending:
        file = os.path.join(folder, "there" + ending)
        scc([*words, option[1], file], folder)
        with open(file, "rb") as written:
            expect(written.read() == done.stdout, name + ": not what goes to a file")
        os.remove(file)


def refuses(option, words, folder):
    name = " ".join([option[0], option[1], "-"])
    done = scc([*words, option[1], "-"], folder)
    expect(done.returncode == 64 and not done.stdout, "%s: exit code %d" % (name, done.returncode))
    expect(b"standard" in done.stderr, name + ": it does not say why")


def main():
    count = 0
    with open(MODEL, "w") as file:
        file.write(TEXT)
    with tempfile.TemporaryDirectory() as folder:
        for option in sorted(set(options(folder))):
            count += 1
            if option in ALONE:
                takes(option, *ALONE[option], folder)
            elif option in BESIDE:
                refuses(option, BESIDE[option], folder)
            else:
                expect(option in INPUTS, "%s %s: what does it do with `-'?" % option)
            expect(os.listdir(folder) == [], "%s %s: it made %s" % (*option, os.listdir(folder)))
            for file in os.listdir(folder):
                subprocess.run(["rm", "-r", os.path.join(folder, file)], check=True)
        resumed = [*SIMULATED, "--format", "jsonl"]
        file = os.path.join(folder, "runs.jsonl")
        scc([*resumed, "-o", file], folder)
        with open(file, "rb") as written:
            expect(scc([*resumed, "--resume", file, "-o", "-"], folder).stdout == written.read(), "simulate --resume FILE -o -")
    expect(count == len(ALONE) + len(BESIDE) + len(INPUTS), "%d options in the manuals" % count)
    for fault in faults:
        print("FAULT " + fault)
    print("%d options, %d faults" % (count, len(faults)))
    return 1 if faults else 0


sys.exit(main())
