#!/usr/bin/env python3
"""Several outputs of one command.

    outputs_test.py SCC

For each command with several outputs, and each of them, that one cannot be written: the exit code is 74, or 4 where
the reader of standard output has ended, and all others are written as they are without a fault. Two outputs that are
one file, by links of either kind, are refused with 64 before anything is written, and so is an output that is an input.
Options for outputs are those of `dash_test.py`, which reads them from the manuals.
"""
import itertools
import os
import re
import subprocess
import sys
import tempfile

SCC = os.path.abspath(sys.argv[1])
HERE = os.path.dirname(os.path.abspath(__file__))
INPUTS = {
    "walk.sc": """shape C = box(1,1,1)
process a = C mass 1 at translate (0,0,0) [nil]
process b = C mass 1 at translate (5,0,0) [nil]
timestep 1
motion a = choose { (1,0,0) weight 1, (-1,0,0) weight 1 }
check near : P = ? [ eventually x(a) > 1 within 3 ]
check far : always x(a) < 1 within 2
""",
    "range.sc": """param v in [1, 3]
shape C = box(1,1,1)
process p = C mass 1 at translate (v,0,0) velocity (1,0,0) [nil]
check fast : always x(p) < 4 within 2
""",
    "value.sc": """import "unit.sc"
param v = 1
shape M = mesh "cube.obj"
process p = unit.C mass 1 velocity (v,0,0) [nil]
process q = M mass 1 at translate (0,9,0) [nil]
check far : eventually x(p) > 2 within 9
""",
    "unit.sc": "shape C = box(1,1,1)\n",
    "cube.obj": "".join(f"v {x} {y} {z}\n" for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n",
    "two.svg": '<svg xmlns="http://www.w3.org/2000/svg" width="30" height="12" viewBox="0 0 30 12">'
    '<rect x="1" y="1" width="10" height="10"/><rect x="16" y="2" width="8" height="8"/></svg>\n',
}
SIMULATED = ["simulate", "walk.sc", "--observe", "x(a)", "--every", "1", "--until", "3", "--runs", "4"]
# Words, the options with the names of their files, and whether there is a report on standard output.
SEVERAL = [
    (["check", "walk.sc", "--curve", "near"],
     [("--sarif", "o.sarif"), ("--curve-plot", "o.svg"), ("--witness", "w")], True),
    (["check", "range.sc", "--where"], [("--sarif", "o.sarif"), ("--smt", "o.smt2"), ("--draw", "o.svg")], True),
    (["check", "value.sc"], [("--sarif", "o.sarif"), ("--invariant", "o.txt")], True),
    (["check", "value.sc", "--json"], [("--sarif", "o.sarif"), ("--invariant", "o.txt")], True),
    (SIMULATED, [("--plot", "o.svg"), ("--view", "o.html")], True),
    (SIMULATED, [("-o", "o.csv"), ("--plot", "o.svg"), ("--view", "o.html")], False),
    (SIMULATED + ["--summary"], [("-o", "o.csv"), ("--view", "o.html")], False),
    (["sweep", "value.sc", "-D", "v=1,2"], [("--plot", "o.svg")], True),
    (["sweep", "value.sc", "-D", "v=1,2"], [("-o", "o.csv"), ("--plot", "o.svg")], False),
    (["shape", "cube.obj"], [("-o", "o.sc"), ("--svg", "o.svg"), ("--view", "o.html")], True),
    (["shape", "cube.obj", "--round"], [("-o", "o.off"), ("--svg", "o.svg")], True),
    (["shape", "cube.obj", "--json"], [("--svg", "o.svg"), ("--view", "o.html")], True),
    (["decompose", "cube.obj", "--union"], [("-o", "o.sc")], True),
    (["inflate", "two.svg", "--pieces", "each"], [("-o", "o.obj")], True),
    (["compare", "value.sc", "value.sc"], [("--write", "o")], True),
    (["conform", "value.sc", "run.jsonl"], [("--run", "o.json")], True),
]
# One output, and all that is read.
READING = [
    (["trace", "value.sc", "--schedule", "run.jsonl"], [("-o", "o")], ["value.sc", "unit.sc", "cube.obj", "run.jsonl"]),
    (["view", "value.sc", "--trace", "run.jsonl"], [("-o", "o")], ["value.sc", "unit.sc", "cube.obj", "run.jsonl"]),
    (["export", "value.sc", "--schedule", "run.jsonl", "--format", "obj"], [("-o", "o")],
     ["value.sc", "unit.sc", "cube.obj", "run.jsonl"]),
    (["explore", "value.sc", "--format", "aut"], [("-o", "o")], ["value.sc", "unit.sc", "cube.obj"]),
    (["translate", "value.sc"], [("-o", "o")], ["value.sc"]),
    (["sweep", "value.sc", "-D", "v=1,2"], [("-o", "o.csv"), ("--plot", "o.svg")], ["value.sc", "unit.sc"]),
    (SIMULATED, [("-o", "o"), ("--plot", "o.svg"), ("--view", "o.html")], ["walk.sc"]),
    (["check", "value.sc"], [("--sarif", "o"), ("--invariant", "o")], ["value.sc", "unit.sc"]),
    (["check", "range.sc"], [("--smt", "o"), ("--draw", "o")], ["range.sc"]),
    (["check", "walk.sc", "--curve", "near"], [("--curve-plot", "o")], ["walk.sc"]),
    (["shape", "cube.obj"], [("--svg", "o"), ("--view", "o")], ["cube.obj"]),
    (["shape", "unit.sc:C"], [("-o", "o.sc"), ("--svg", "o"), ("--view", "o")], ["unit.sc"]),
    (["inflate", "two.svg"], [("-o", "o.obj")], []),
    (["conform", "value.sc", "run.jsonl"], [("--run", "o")], ["value.sc", "unit.sc", "run.jsonl"]),
    (["compare", "g-1.aut", "g-2.aut"], [("--write", "g")], ["g-1.aut"]),
]
IN_PLACE = [["shape", "cube.obj", "-o", "cube.obj"], ["decompose", "cube.obj", "-o", "cube.obj"],
            SIMULATED + ["--format", "jsonl", "--resume", "runs.jsonl", "-o", "runs.jsonl"]]
count = 0
faults = []


def expect(holds, *what):
    global count
    count += 1
    if not holds:
        faults.append(" ".join(str(w) for w in what))


def scc(words, folder, stdout=subprocess.PIPE, **more):
    return subprocess.run([SCC, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=stdout, stderr=subprocess.PIPE,
                          **more)


def fresh():
    folder = tempfile.TemporaryDirectory()
    for name, text in INPUTS.items():
        with open(os.path.join(folder.name, name), "w", encoding="ascii") as file:
            file.write(text)
    return folder


def contents(folder):
    """All files below a folder but for inputs, with their bytes; links are not followed."""
    found = {}
    for at, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(at, name)
            shown = os.path.relpath(path, folder)
            if shown not in INPUTS and not os.path.islink(path):
                with open(path, "rb") as file:
                    found[shown] = file.read()
    return found


def asked(words, outputs):
    return words + [word for pair in outputs for word in pair]


def comparable(files):
    """A report in SARIF has the exit code and what could not be written."""
    return {name: text for name, text in files.items() if not name.endswith(".sarif")}


def failing(words, outputs, report):
    folder = fresh()
    whole = scc(asked(words, outputs), folder.name)
    expect(whole.returncode in (0, 1, 2), words, whole)
    there = contents(folder.name)
    expect(len(there) >= len(outputs), words, "wrote", sorted(there))
    expect(not report or whole.stdout, words, "prints nothing")
    if report:
        for how in ("full", "closed", "unread"):
            folder = fresh()
            if how == "full":
                with open("/dev/full", "wb") as full:
                    done = scc(asked(words, outputs), folder.name, stdout=full)
            elif how == "closed":
                done = scc(asked(words, outputs), folder.name, stdout=None, preexec_fn=lambda: os.close(1))
            else:
                read, write = os.pipe()
                os.close(read)
                done = scc(asked(words, outputs), folder.name, stdout=write)
                os.close(write)
            expect(done.returncode == (4 if how == "unread" else 74), words, how, done)
            found = contents(folder.name)
            expect(found.keys() == there.keys() and comparable(found) == comparable(there), words, outputs, how,
                   sorted(found), sorted(there))
    for bad, (option, name) in enumerate(outputs):
        for elsewhere in ("/dev/full", "nowhere/" + name):
            if elsewhere == "/dev/full" and option in ("--witness", "--write") or words[0] == "inflate":
                continue
            if elsewhere == "/dev/full" and words[0] in ("shape", "decompose") and option == "-o":
                continue
            folder = fresh()
            chosen = [pair if k != bad else (option, elsewhere) for k, pair in enumerate(outputs)]
            done = scc(asked(words, chosen), folder.name)
            expect(done.returncode == 74, words, option, elsewhere, done)
            found = contents(folder.name)
            wanted = {k: v for k, v in there.items() if k.split("/")[0] != name and not k.startswith(name + "-")}
            expect(found.keys() == wanted.keys() and comparable(found) == comparable(wanted), words, option, elsewhere,
                   sorted(found), sorted(wanted))
            if report and "--json" not in words:
                expect(done.stdout == whole.stdout, words, option, elsewhere, "prints", done.stdout)


def pieces():
    """Each piece of a drawing has a file of its own."""
    for bad, other in (("o-1.obj", "o-2.obj"), ("o-2.obj", "o-1.obj")):
        folder = fresh()
        os.mkdir(os.path.join(folder.name, bad))
        done = scc(["inflate", "two.svg", "--pieces", "each", "-o", "o.obj"], folder.name)
        expect(done.returncode == 74 and done.stdout and list(contents(folder.name)) == [other], bad, done)


def one_file(words, outputs):
    for (first, name), (second, own) in itertools.permutations(outputs, 2):
        ending = os.path.splitext(own)[1]
        if words[0] == "shape" and "-o" in (first, second) and second != "-o":
            continue  # the ending of -o selects its format
        rest = [pair for pair in outputs if pair[0] not in (first, second)]
        named = ("same", "spelt") if ending == os.path.splitext(name)[1] or words[0] != "shape" else ()
        for how in (*named, "link", "dangling", "hard"):
            folder = fresh()
            path, other = os.path.join(folder.name, name), "other" + ending
            if how in ("link", "hard"):
                with open(path, "w", encoding="ascii") as file:
                    file.write("old\n")
            if how == "same":
                other = name
            elif how == "spelt":
                other = "../" + os.path.basename(folder.name) + "/./" + name
            elif how == "hard":
                os.link(path, os.path.join(folder.name, other))
            else:
                os.symlink(name, os.path.join(folder.name, other))
            before = contents(folder.name)
            done = scc(asked(words, [(first, name), (second, other)] + rest), folder.name)
            expect(done.returncode == 64 and b"name the same f" in done.stderr and not done.stdout, words, first, second,
                   how, done)
            expect(contents(folder.name) == before, words, first, second, how, "wrote")


def overwriting(words, outputs, inputs):
    for option, name in outputs:
        rest = [pair for pair in outputs if pair[0] != option and pair[1] != name and words[0] != "shape"]
        for target in inputs:
            for how in ("same", "link", "hard"):
                folder = fresh()
                other = target
                if option == "--write":
                    other = "g" if how == "same" else "h"
                elif how != "same":
                    other = "other" + os.path.splitext(name)[1]
                if how != "same":
                    link = os.link if how == "hard" else os.symlink
                    link(os.path.join(folder.name, target),
                         os.path.join(folder.name, other + ("-1.aut" if option == "--write" else "")))
                before, old = contents(folder.name), open(os.path.join(folder.name, target), "rb").read()
                done = scc(asked(words, [(option, other)] + rest), folder.name)
                expect(done.returncode == 64 and not done.stdout, words, option, target, how, done)
                expect(contents(folder.name) == before and open(os.path.join(folder.name, target), "rb").read() == old,
                       words, option, target, how, "wrote")


def in_place():
    for words in IN_PLACE:
        folder = fresh()
        expect(scc(SIMULATED + ["--format", "jsonl", "-o", "runs.jsonl"], folder.name).returncode == 0, "runs")
        done = scc(words, folder.name)
        expect(done.returncode == 0, words, done)


def is_complete():
    """No option for an output is missing here."""
    with open(os.path.join(HERE, "dash_test.py"), encoding="utf-8") as file:
        known = set(re.findall(r'\("([a-z]+)", "(-[a-z-]+)"\): ', file.read()))
    tried = {(case[0][0], option) for case in SEVERAL + READING for option, _ in case[1]}
    # A store is written while the work is done, and a file that is continued is an input.
    left = {pair for pair in known - tried if pair[1] not in ("--store", "--resume")}
    expect(not left, "not tried:", sorted(left))


def within_the_store():
    folder = fresh()
    done = scc(SIMULATED + ["--store", "s", "-o", "s/states"], folder.name)
    expect(done.returncode == 64 and not os.path.exists(os.path.join(folder.name, "s")), "store", done)


def among_files_of_one_option():
    folder = fresh()
    os.mkdir(os.path.join(folder.name, "w"))
    os.symlink("o-1.obj", os.path.join(folder.name, "o-2.obj"))
    for words in (["check", "walk.sc", "--witness", "w", "--sarif", "w/far.json"],
                  ["inflate", "two.svg", "--pieces", "each", "-o", "o.obj"]):
        done = scc(words, folder.name)
        expect(done.returncode == 64 and not done.stdout and not contents(folder.name), words, done)


with fresh() as made:
    for command, name in (("trace", "run.jsonl"), ("explore", "g-1.aut"), ("explore", "g-2.aut")):
        scc([command, "value.sc", "-o", name], made)
        with open(os.path.join(made, name), encoding="ascii") as text:
            INPUTS[name] = text.read()
for words, outputs, report in SEVERAL:
    failing(words, outputs, report)
    if all(option not in ("--witness", "--write") for option, _ in outputs):
        one_file(words, outputs)
for words, outputs, inputs in READING:
    overwriting(words, outputs, inputs)
pieces()
in_place()
is_complete()
within_the_store()
among_files_of_one_option()
for fault in faults:
    print(fault)
print(f"{count - len(faults)} passed, {len(faults)} failed")
sys.exit(1 if faults else 0)
