#!/usr/bin/env python3
"""The pages of scc simulate --view, against the table that the same command writes.

    simulated_page_test.py SCC MODELS [--all]

For models of all kinds, what a page tells of all runs is what the table has: least, mean and greatest values, how many
runs have which values, and how many have none, because they had ended or otherwise. The runs that it shows are those
of the table: at each time, the numbers that it plots and the places of bodies are those of the table. The last line
is 'N passed, N failed', where each value and each bar counts.
"""
import bisect
import csv
import glob
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

def crowd(count):
    """Many bodies that go about by chance, so that the page tells what changes alone."""
    return f"""import <solids>
timestep 1 steady
resolution 1/2
for i in 0..{count} {{ process p[i] = solids.Cube(1) mass 1 at translate (4*(i mod 10), 2*(i - i mod 10), 0) [nil] }}
motion p[0] = choose {{ (1,0,0) weight 1, (0,0,0) weight 2, (0,0,1/3) weight 1 }}
"""


# Text of a model or its name, observables, and more options.
CASES = [
    ("ruin.sc", ["gone(walker)", "x(walker)", "time"], ["--every", "3/2", "--until", "20", "--runs", "60"]),
    ("ruin.sc", ["x(walker)"], ["--every", "1", "--until", "40", "--runs", "30", "--steps", "7"]),
    ("brownian.sc", ["x(ligand)", "bound(ligand, pocket)", "x(ligand) * y(ligand) / 7"],
     ["--every", "5/3", "--until", "12", "--runs", "100", "--summary"]),
    ("ties.sc", ["time"], ["--every", "1", "--until", "5", "--runs", "25"]),
    ("gravity.sc", ["energy"], ["--every", "1/3", "--until", "2", "--runs", "2"]),
    ("spin.sc", ["energy"], ["--every", "1", "--until", "5", "--runs", "2"]),
    ("hexokinase.sc", ["bonds()"], ["--every", "1/2", "--until", "9", "--runs", "30", "--part", "2/3"]),
    (crowd(5), ["x(p[0])", "z(p[0])"], ["--every", "1", "--until", "9", "--runs", "40", "--jobs", "2"]),
    (crowd(110), ["x(p[0])", "z(p[0])"], ["--every", "4/3", "--until", "9", "--runs", "40"]),
]
SEEN = {"passed": 0, "failed": 0}


def check(what, found, expected):
    SEEN["passed" if found == expected else "failed"] += 1
    if found != expected:
        print(f"{what}\n  found    {str(found)[:300]}\n  expected {str(expected)[:300]}")


def page_data(path):
    with open(path, encoding="utf-8") as file:
        return json.loads(re.search(r'id="data">(.*?)</script>', file.read(), re.S).group(1))


def value(curve, age):
    """What a plotted number is so long after its state."""
    parts = curve.get("pieces") or [{**curve, "from": "0"}]
    at = [p for p in parts if Fraction(p["from"]) == age][:1] or [p for p in parts if Fraction(p["from"]) < age][-1:]
    if "n" not in at[0]:
        return None
    up, down = (sum(Fraction(c) * age**i for i, c in enumerate(at[0][part])) for part in "nd")
    return up / down if down else None


def course(data, run):
    """The states of a run, and the times from which on it is in them."""
    states, times = [run["start"]], [Fraction(0)]
    for step in run["steps"]:
        states.append(step["to"])
        times.append(times[-1] + Fraction(data["labels"][step["label"]].get("duration", "0")))
    return states, times


def plotted(data, run, way, time):
    """The plotted numbers of a run on its course at a time, after all events of the instant; None where it is over before."""
    states, times = way
    last = bisect.bisect_right(times, time) - 1
    if last == len(states) - 1 and times[last] + Fraction(run["rest"]) < time:
        return None
    return [value(curve, time - times[last]) for curve in data["states"][states[last]].get("values", [])]


def bars(name, cell, values):
    check(name + " without a value", cell["none"], sum(v is None for v in values))
    there = sorted(v for v in values if v is not None)
    if not there:
        check(name + " has nothing", set(cell), {"none"})
        return
    mean = sum(there) / len(there)
    found = [Fraction(cell[key]) for key in ("least", "greatest")]
    check(name, found, [there[0], there[-1]])
    if isinstance(cell["mean"], str):
        check(name, Fraction(cell["mean"]), mean)
    else:
        check(name, len(str(mean)) > 400 and abs(Fraction(cell["mean"]["near"]) / mean - 1) < Fraction(1, 10**18), True)
    start, width, counts = Fraction(cell["from"]), Fraction(cell["width"]), cell["counts"]
    own = [0] * len(counts)
    for v in there:
        own[(v - start) // width] += 1
        if cell.get("single"):
            check(name + " of a single value", (v - start) % width, 0)
    check(name + " bars", counts, own)
    check(name + " few bars", len(counts) <= 26 and counts[0] > 0 and counts[-1] > 0, True)


def one(scc, work, text, observables, options):
    model, page, table = (os.path.join(work, name) for name in ("m.sc", "page.html", "table.csv"))
    if text.endswith(".sc"):
        model = text
    else:
        with open(model, "w", encoding="utf-8") as file:
            file.write(text)
    asked = [word for o in observables for word in ("--observe", o)]
    done = subprocess.run([scc, "simulate", model, *asked, *options, "--view", page, "-o", table], capture_output=True,
                          text=True, timeout=600)
    if done.returncode not in (0, 2):
        raise RuntimeError(f"{text}: {done.stderr}")
    if "--summary" in options:
        rest = [option for option in options if option != "--summary"]
        subprocess.run([scc, "simulate", model, *asked, *rest, "-o", table], timeout=600, stderr=subprocess.DEVNULL)
    with open(table, encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))[1:]
    data = page_data(page)
    spread = data["spread"]
    name = os.path.basename(model) + " " + " ".join(options)
    number = lambda cell: Fraction(cell) if cell else None  # noqa: E731
    runs = {}
    for row in rows:
        runs.setdefault(int(row[0]), []).append(row)
    check(name + ": runs", (spread["made"], spread["asked"], spread["first"]), (len(runs), len(runs), min(runs)))
    check(name + ": observables", spread["observables"], observables)
    check(name + ": shown", [s["run"] for s in spread["shown"]], sorted(runs)[:20])
    check(name + ": as many runs", len(data["runs"]), len(spread["shown"]))
    for i, at in enumerate(spread["times"]):
        check(name + ": time", Fraction(at), Fraction(rows[i][1]))
        # What has ended before has no values: it is counted apart.
        over = [k for k, lines in runs.items() if lines[i][-1] and Fraction(ended_at(lines[i][-1])) < Fraction(at)]
        check(f"{name}: over before {at}", (spread["over"][i], spread["cut"][i]), (len(over), 0))
        for k in range(len(observables)):
            there = [number(lines[i][2 + k]) for n, lines in runs.items() if n not in over]
            bars(f"{name}: {observables[k]} at {at}", spread["cells"][i][k], there)
    numbers = [k for k, o in enumerate(observables) if not o.startswith(("gone", "bound"))]
    for shown, run in zip(spread["shown"], data["runs"]):
        check(name + ": name", run["name"], f"run {shown['run']}")
        way = course(data, run)
        for i, at in enumerate(spread["times"]):
            own = [number(cell) for cell in runs[shown["run"]][i][2:-1]]
            check(f"{name}: run {shown['run']} at {at}", [number(v) for v in shown["values"][i]], own)
            seen = plotted(data, run, way, Fraction(at))
            if seen is None:
                check(f"{name}: run {shown['run']} is over at {at}", own, [None] * len(own))
            else:
                check(f"{name}: run {shown['run']} plotted at {at}", seen, [own[k] for k in numbers])


def interrupted(scc, work):
    """A page that is written after Ctrl-C has the runs of the table, and those that were cut short apart."""
    model, page, table = (os.path.join(work, name) for name in ("i.sc", "i.html", "i.csv"))
    with open(model, "w", encoding="utf-8") as file:
        file.write(crowd(5))
    command = subprocess.Popen([scc, "simulate", model, "--observe", "x(p[0])", "--every", "40", "--until", "4000", "--runs", "100000",
                                "--jobs", "2", "--view", page, "-o", table], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    time.sleep(1.5)
    command.send_signal(signal.SIGINT)
    told = command.communicate(timeout=300)[1].decode()
    check("interrupted: the exit code", command.returncode, 4)
    with open(table, encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))[1:]
    data = page_data(page)
    spread = data["spread"]
    runs = {}
    for row in rows:
        runs.setdefault(int(row[0]), []).append(row)
    check("interrupted: runs", (spread["made"], spread["asked"]), (len(runs), 100000))
    shown = f"the page shows {len(data['runs'])} run{'' if len(data['runs']) == 1 else 's'}, as many as there was time for"
    check("interrupted: which is told", shown in told, spread["hurried"])
    check("interrupted: cut short", spread["cut"][-1], sum("interrupted" in lines[0][-1] for lines in runs.values()))
    check("interrupted: in order of time", (spread["cut"], spread["over"][-1]), (sorted(spread["cut"]), 0))
    for i, cells in enumerate(spread["cells"]):
        there = sum(lines[i][2] != "" for lines in runs.values())
        check("interrupted: none is dropped", sum(cells[0].get("counts", [])), there)
        check("interrupted: all are counted", there + cells[0]["none"] + spread["over"][i] + spread["cut"][i], len(runs))
    for shown, run in zip(spread["shown"], data["runs"]):
        way = course(data, run)
        for i, at in enumerate(spread["times"]):
            own = [Fraction(cell) if cell else None for cell in runs[shown["run"]][i][2:-1]]
            check("interrupted: values", [v and Fraction(v) for v in shown["values"][i]], own)
            seen = plotted(data, run, way, Fraction(at))
            check("interrupted: plotted", seen is None or own[0] is None or seen == own, True)


def ended_at(text):
    return re.search(r"at time (-?[0-9/]+)", text).group(1)


def main():
    scc, models = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    cases = list(CASES)
    if "--all" in sys.argv:
        for path in sorted(glob.glob(os.path.join(models, "*.sc"))):
            cases.append((path, ["time", "bonds()"], ["--every", "2/3", "--until", "4", "--runs", "5", "--steps", "40"]))
    with tempfile.TemporaryDirectory() as work:
        interrupted(scc, work)
        for text, observables, options in cases:
            text = os.path.join(models, text) if text.endswith(".sc") else text
            try:
                one(scc, work, text, observables, options)
            except RuntimeError as error:
                if "--all" not in sys.argv:
                    SEEN["failed"] += 1
                print(error)
    print(f"{SEEN['passed']} passed, {SEEN['failed']} failed")
    sys.exit(1 if SEEN["failed"] or SEEN["passed"] == 0 else 0)


main()
