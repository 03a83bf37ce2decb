#!/usr/bin/env python3
"""Chance over starts where predicates are undecided, against the ordinary checker at single starts.

    undecided.py SCC [--count N] [--seed S]

A walker may be taken in by a wall. Then its place has no value, and predicates on it are undecided from there on. What
`scc check --where` knows of a probability or a mean at a start is held against `scc check -D` there: both have the
same ends. The last line is 'N passed, N failed'.
"""

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction as Q

from starts import at, fraction

POINTS = [Q(0), Q(1, 5), Q(1, 2), Q(2, 3), Q(1)]


def model(rng):
    walls = ["", " absorb"]
    walk = rng.choice(["(1,0,0) weight 1, (-1,0,0) weight 1", "(1,0,0) weight 2, (-1,0,0) weight 1, (0,0,0) weight 1",
                       "(1/2,0,0) weight 1, (-1,0,0) weight 3"])
    place = rng.choice([f"x(w) >= {rng.choice(['3/2', '2', '5/2', '7/3'])}", f"x(w) <= {rng.choice(['-1', '-3/2', '-1/3'])}",
                        f"x(w) = {rng.choice(['1', '-1', '1/2'])}", "speed2(w) = 1"])
    end = rng.choice(["1", "3/2", "2", "5/2", "3"])
    claim = rng.choice(["x(w) <= 2", "x(w) > -2", "x(w) < 5/2", f"not ({place})"])
    check = rng.choice([
        f"E = ? [ time U {place} or time >= {end} ]",
        f"E = ? [ event bounce U {place} or time >= {end} ]",
        f"P = ? [ eventually {place} or time >= {end} and gone(w) within 3 ]",
        f"P = ? [ eventually {place} within {end} ]",
        f"P = ? [ ({claim}) U[<= {end}] ({place}) ]",
        f"P = ? [ ({claim}) U[<= 3] time >= {end} ]",
        f"P = ? [ always {claim} within {end} ]",
    ])
    return (f"timestep 1\nparam d in [0, 1]\nprocess w = box(1,1,1) mass 1 at translate (d, 0, 0) [nil]\n"
            f"fixed a = box(1,9,9){rng.choice(walls)} at translate ({rng.choice(['-2', '-5/2', '-3'])}, 0, 0)\n"
            f"fixed b = box(1,9,9){rng.choice(walls)} at translate ({rng.choice(['3', '7/2', '4'])}, 0, 0)\n"
            f"motion w = choose {{ {walk} }}\ncheck c : {check}\n")


def checked(scc, path, *options):
    done = subprocess.run([scc, "check", path, "--json", *options], capture_output=True, encoding="utf-8", check=False)
    report = json.loads(done.stdout)
    if "properties" not in report:
        sys.exit(done.stdout + open(path, encoding="utf-8").read())
    return report["properties"][0]


def single(found):
    """The ends of what is known at one start, by side."""
    return {value["over"]: (fraction(value["low"]), fraction(value["high"])) for value in found["values"]}


def main():
    parser = argparse.ArgumentParser(description="undecided predicates over starts")
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    passed, failed, open_ = 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "m.sc")
        for number in range(options.count):
            text = model(random.Random(f"{options.seed}/{number}"))
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            over = {side["over"]: side for side in checked(options.scc, path, "--where")["starts"]}
            for d in POINTS:
                for side, ends in single(checked(options.scc, path, "-D", f"d={d}")).items():
                    known = at(over[side], {"d": d})
                    open_ += ends[0] != ends[1]
                    if known == ends:
                        passed += 1
                    else:
                        failed += 1
                        print(f"model {number} of seed {options.seed}, at d = {d}, {side}: {ends}, over starts: {known}")
                        print(text, flush=True)
    print(f"{options.count} models, {open_} times an interval")
    print(f"{passed} passed, {failed} failed")
    return 0 if failed == 0 and passed > 0 and open_ > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
