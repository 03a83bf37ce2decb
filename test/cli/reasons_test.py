#!/usr/bin/env python3
"""Reasons name the bodies that they are about, also where bodies are interchangeable.

    reasons_test.py SCC [--count N] [--seed N]

Random models of pairs that are far from each other: p0 and q0, p1 and q1, and so on. Whatever two bodies a report names
in one event have to be of one pair. The last line is 'N passed, N failed', where each named pair counts.
"""
import argparse
import random
import re
import subprocess
import sys
import tempfile

FORMULAS = [
    "EF (event bounce and AF energy = {n})",
    "AG (event bounce => EF[1,1] event bounce)",
    "AG not EX event bounce",
    "EX EX event bounce",
    "EG EF event bounce",
    "AG EF event bounce",
    "E[not event bind U event bounce and EX not event bounce]",
    "EF (event weak and EX event bounce)",
    "AG (event bind => AF event weak)",
    "EF (event bind and EF (event weak and EF event bounce))",
    "P >= 1/2 [ eventually event bind ]",
]
NAMED = re.compile(r"(?:bounce|bind|weak|release|keep)\((?:a, )?([pq])(\d)(?:\.\w+)?, ([pq])(\d)")


def model(chance):
    pairs = chance.randint(2, 3)
    free = chance.choice(["omega(a, {right}). nil", "omega(a, {right}) chance 1/2. nil"])
    binds = chance.random() < 0.6
    lines = ["model pairs", "import <solids>"]
    if binds:
        lines += [f"behaviour A on solids.Cube(2) = <a, {{right}}>. {free}",
                  "behaviour B on solids.Cube(2) = <~a, {left}>. nil"]
    first, second = ("[A]", "[B]") if binds else ("[nil]", "[nil]")
    for i in range(pairs):
        apart = 2 + chance.choice([4, 6, 8])
        lines += [f"process p{i} = solids.Cube(2) mass 1 velocity (1,0,0) at translate (0,{100 * i},0) {first}",
                  f"process q{i} = solids.Cube(2) mass 1 velocity (-1,0,0) at translate ({apart},{100 * i},0) {second}"]
    formulas = chance.sample(FORMULAS, 4)
    return "\n".join(lines + [f"check c{j} : {f.format(n=pairs)}" for j, f in enumerate(formulas)]) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance, passed, failed = random.Random(options.seed), 0, 0
    for _ in range(options.count):
        text = model(chance)
        with tempfile.NamedTemporaryFile("w", suffix=".sc") as file:
            file.write(text)
            file.flush()
            done = subprocess.run([options.scc, "check", file.name, "--states", "3000", "--full"],
                                  capture_output=True, text=True)
        wrong = [m for m in NAMED.findall(done.stdout) if m[1] != m[3]]
        if done.returncode not in (0, 1, 2) or "fault of scc" in done.stdout or wrong:
            failed += 1
            print(text, done.returncode, done.stderr, wrong, sep="\n")
        else:
            passed += len(NAMED.findall(done.stdout))
    if passed < options.count:
        failed += 1
        print("few pairs are named")
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed > 0)


main()
