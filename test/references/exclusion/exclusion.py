#!/usr/bin/env python3
"""Compares probabilities of walkers that wait (`blocked wait`) with those of an own program on cells.

    test/references/exclusion/exclusion.py SCC [--count N] [--seed N]

Models are random: up to three unit cubes in a room of up to nine cells, each of which draws one of four kicks a step.
A probability is that one of them comes to a cell within some steps. Here a kick takes a walker from cell to cell, and
rule Blocked is about cells alone: no geometry, no time, and no code of scc. Some models are decided without the
reduction of draws, or without any.
"""

import argparse
import itertools
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

KICKS = [(1, 0), (-1, 0), (0, 1), (0, -1)]
ROOMS = [(2, 1), (3, 1), (4, 1), (2, 2), (3, 2), (4, 2), (3, 3)]


def step(cells, kicks, room):
    """The cells after a step: the least set of blocked kicks that rule Blocked asks for is found first."""
    after = [(x + dx, y + dy) for (x, y), (dx, dy) in zip(cells, kicks)]
    walkers = range(len(cells))

    def collide(i, j):
        into = lambda a, b: after[a] == cells[b] and kicks[a] != kicks[b]
        return after[i] == after[j] or into(i, j) or into(j, i)

    blocked = {i for i in walkers if not (0 <= after[i][0] < room[0] and 0 <= after[i][1] < room[1])}
    for i, j in itertools.combinations(walkers, 2):
        if collide(i, j):
            blocked |= {i, j}
    while True:
        more = {i for i in walkers for j in blocked if {cells[i], after[i]} & {cells[j], after[j]}} - blocked
        if not more:
            return tuple(cells[i] if i in blocked else after[i] for i in walkers)
        blocked |= more


def probability(cells, room, steps, goal):
    """That the first walker comes to the goal within so many steps."""
    reached, chances = Fraction(0), {cells: Fraction(1)}
    for left in range(steps, -1, -1):
        later = {}
        for cells, chance in chances.items():
            if cells[0] == goal:
                reached += chance
            elif left:
                for kicks in itertools.product(KICKS, repeat=len(cells)):
                    there = step(cells, kicks, room)
                    later[there] = later.get(there, 0) + chance / 4 ** len(cells)
        chances = later
    return reached


def model(cells, room, steps, goal):
    """The same question as a model: cells are unit cubes in a room whose middle is the origin."""
    at = lambda cell: [Fraction(2 * c + 1 - size, 2) for c, size in zip(cell, room)]
    lines = ["import <solids>", "timestep 1 steady", "blocked wait", "fixed room = solids.Room(%d, %d, 1, 1)" % room]
    for name, cell in zip("abc", cells):
        lines.append("process %s = solids.Cube(1) mass 1 at translate (%s, %s, 0) [nil]" % (name, *at(cell)))
        lines.append("motion %s = choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }" % name)
    x, y = at(goal)
    lines.append("check reached : P = ? [ eventually (x(a) = %s and y(a) = %s) within %d ]" % (x, y, steps))
    return "\n".join(lines) + "\n"


def agrees(answer, expected):
    """Long fractions are printed as rounded decimals."""
    if answer.startswith("about "):
        return abs(Fraction(answer.split()[1]) - expected) <= Fraction(1, 10**6)
    return answer == str(expected)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scc", type=os.path.abspath)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    draw = random.Random(args.seed)
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "walkers.sc")
        for _ in range(args.count):
            room = draw.choice(ROOMS)
            places = list(itertools.product(range(room[0]), range(room[1])))
            walkers = draw.randint(1, min(3, len(places) - 1))
            case = tuple(draw.sample(places, walkers)), room, draw.randint(0, 4 if walkers < 3 else 3), draw.choice(places)
            with open(path, "w") as file:
                file.write(model(*case))
            reductions = draw.choice([[], ["--no-reduce", "draws"], ["--no-reduce", "all"]])
            found = subprocess.run(
                [args.scc, "check", path, "--jobs", "1", *reductions], capture_output=True, text=True
            )
            answers = [line[len("reached: "):] for line in found.stdout.splitlines() if line.startswith("reached: ")]
            if len(answers) != 1 or not agrees(answers[0], probability(*case)):
                failed += 1
                print("expected %s, found %s%s of\n%s" % (
                    probability(*case), found.stdout, found.stderr, model(*case)))
    print("%d passed, %d failed" % (args.count - failed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
