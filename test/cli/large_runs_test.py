#!/usr/bin/env python3
"""Runs of more than 100 bodies in the data of scc view, against those of fewer.

    large_runs_test.py SCC [--count N] [--seed N]

A run of more than 100 bodies is told by what changes, and not state by state. Random small models get bodies that rest
far away: a few of them, or so many that there are more than 100. The corners of the place where they are stay the same.
All runs have to have the same steps, times, ends and values of plots. The last line is 'N passed, N failed', where each
run counts.
"""
import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

WORDS = {
    "checks": ["eventually x(p0) >= {n} within {t}", "always x(p0) <= {n} within {t}", "eventually distance2(p0, p1) <= {n} within {t}",
               "always abs(y(p1)) <= {n}", "eventually gone(p0) within {t}", "possibly x(p1) >= {n}", "always vx(p0) = vx(p0) within {t}",
               "EF (x(p0) > x(p1))", "eventually y(p0) + y(p1) > {n} within {t}", "AG x(p1) < {n}"],
    "laws": ["", "", "", "timestep 1\nmotion p0 = (vx, vy - 1/2, vz)", "timestep 1/2\nmotion p1 = (0, vy, 1)",
             "timestep 1 steady\nmotion p0 = choose { (1,0,0) weight 1, (-1,0,0) weight 2 }"],
}


def near(chance):
    """The bodies that do something, and what is asked of them."""
    v = lambda: chance.choice([-2, -1, 0, 0, 1, 2])
    lines = ["import <solids>"]
    free = "behaviour A on solids.Cube(1) = <a, {right}>. nil\nbehaviour B on solids.Cube(1) = <~a, {left}>. nil"
    first, second = chance.choice([("[nil]", "[nil]"), ("[A]", "[B]")])
    lines += [free] if first == "[A]" else []
    lines += [f"process p0 = solids.Cube(1) mass 1 velocity ({v()}, {v()}, 0) {first}",
              f"process p1 = solids.Cube(1) mass 2 velocity ({v()}, {v()}, 0) at translate ({chance.randint(2, 6)}, 0, 0) {second}"]
    if chance.random() < 0.4:
        lines.append(f"fixed wall = solids.Cube(1) {chance.choice(['', 'absorb'])} at translate ({chance.choice([-5, -3, 9, 12])}, 0, 0)")
    lines.append(chance.choice(WORDS["laws"]))
    for i, text in enumerate(chance.sample(WORDS["checks"], 3)):
        lines.append(f"check c{i} : " + text.format(n=chance.choice([-3, 4, 9, 90]), t=chance.choice(["2", "7/2", "5"])))
    return "\n".join(lines) + "\n"


def far(count):
    """Bodies that rest, in the same place whatever their number is: that far away none is ever met."""
    lines = ["process f[0] = solids.Cube(1) mass 1 at translate (0, 0, 100000) [nil]",
             "process f[1] = solids.Cube(1) mass 1 at translate (40, 60, 100000) [nil]"]
    return "\n".join(lines) + f"\nfor i in 2..{count} {{ process f[i] = solids.Cube(1) mass 1 at translate (2*(i mod 10), (i - i mod 10) / 5, 100000) [nil] }}\n"


def data(scc, work, text):
    """What scc view tells of a model, or None with what it says."""
    path = os.path.join(work, "m.sc")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    done = subprocess.run([scc, "view", "--data", "--graph", "40", "--states", "60", "-o", os.path.join(work, "m.json"), path], capture_output=True, text=True,
                          timeout=300)
    if done.returncode not in (0, 1):
        return None, done.stderr
    with open(os.path.join(work, "m.json"), encoding="utf-8") as file:
        return json.load(file), ""


def value(curve, age):
    parts = curve.get("pieces") or [{**curve, "from": "0"}]
    at = [p for p in parts if Fraction(p["from"]) == age][:1] or [p for p in parts if Fraction(p["from"]) < age][-1:]
    if "n" not in at[0]:
        return at[0].get("none")
    sums = [sum(Fraction(c) * age**i for i, c in enumerate(at[0][part])) for part in "nd"]
    return sums[0] / sums[1] if sums[1] else "not defined"


def told(data, run):
    """A run in the terms of the model: what is the same whatever the numbers of rows are."""
    lines = [(run["name"], run.get("finish"), run.get("ending"), run.get("facts"), run.get("cycle"))]
    if run["start"] is None:
        return lines
    labels = data["labels"]
    ways = [(labels[s["label"]]["text"], labels[s["label"]].get("duration", "0"), s.get("tail"), s["rules"], s["to"]) for s in run["steps"]]
    state, time = run["start"], Fraction(0)
    for text, lasts, *_, to in ways + [("end", run["rest"], None, [], None)]:
        lasts, curves = Fraction(lasts), data["states"][state].get("values")
        values = [[value(curve, age) for age in (Fraction(0), lasts / 3, lasts)] for curve in curves] if curves else curves
        lines.append((text, time, lasts, values, data["states"][state]["rests"]))
        state, time = to, time + lasts
    return lines


def differs(few, many):
    """The first line in which two runs differ; what large runs leave out of values is no difference."""
    for a, b in zip(few, many):
        if a[:3] != b[:3] or len(a) == 5 and a[4] != b[4]:
            return a, b
        for x, y in zip(a[3] or [], b[3] or []):
            if x != y and "it takes all bodies" not in str(y):
                return a, b
        if (a[3] is None) != (b[3] is None):
            return a, b
    return None if len(few) == len(many) else (few[-1], many[-1])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=6)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    scc = os.path.abspath(args.scc)
    passed = failed = 0
    with tempfile.TemporaryDirectory() as work:
        for seed in range(args.seed, args.seed + args.count):
            text = near(random.Random(seed))
            documents = [data(scc, work, text + far(count)) for count in (4, 110)]
            if None in [found for found, _ in documents]:
                print(f"seed {seed}: {documents[0][1]}{documents[1][1]}\n{text}")
                failed += 1
                continue
            few, many = ([told(found, run) for run in found["runs"]] for found, _ in documents)
            for a, b in zip(few, many):
                found = differs(a, b)
                passed, failed = passed + (found is None), failed + (found is not None)
                if found:
                    print(f"seed {seed}: of few bodies\n  {found[0]}\nof many\n  {found[1]}\n{text}")
            if len(few) != len(many):
                print(f"seed {seed}: {len(few)} and {len(many)} runs\n{text}")
                failed += 1
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed or passed == 0 else 0)


main()
