#!/usr/bin/env python3
"""Means of numbers at a time over starts of which some have no mean, against the ordinary checker at single starts.

    values.py SCC [--count N] [--seed S]

Walls may take walkers in. Then their places have no value, and no mean has one in which such a run counts. What
`scc check --where` knows of the mean at a start is held against `scc check -D` there: nothing is known if and only if the
mean of the single start is undecided, and otherwise both have the same ends. What is said of a uniform start is held
against the integral of the parts. The last line is 'N passed, N failed'.
"""

import argparse
import os
import random
import sys
import tempfile
from fractions import Fraction as Q

from starts import at, ends, is_unknown, pick
from undecided import checked, single

LOW, HIGH = Q(0), Q(1)
POINTS = [Q(0), Q(1, 5), Q(1, 4), Q(1, 2), Q(2, 3), Q(1)]
WALKS = ["(1,0,0) weight 1, (-1,0,0) weight 1", "(1,0,0) weight 2, (-1,0,0) weight 1, (0,0,0) weight 1",
         "(1/2,0,0) weight 1, (-1,0,0) weight 3", "(2,0,0) weight 1, (0,0,0) weight 1",
         "(1,0,0) weight (if x < 1/2 then 1 else 2), (-1,0,0) weight 1"]
WALLS = {"a": ["-3/2", "-2", "-5/2", "-3"], "b": ["5/2", "3", "7/2", "4"]}


def model(rng):
    """Its parameters and its text."""
    two = rng.random() < 0.35
    parameters = ["d", "e"] if two else ["d"]
    seen = rng.choice(["w", "v"] if two else ["w"])
    other = rng.choice(["x(v)", "vx(w)"]) if two else "vx(w)"
    number = rng.choice([f"x({seen})", f"vx({seen})", f"2 * x({seen}) - 1", f"x(w) + {other}",
                         f"max(x({seen}), 1)", "if gone(w) then 1 else 0", "if gone(w) then 5 else x(w)",
                         f"if x({seen}) > 1 then 1 else 0"])
    # Two walkers that are drawn anew whenever they bounce have too many runs.
    lines = ["timestep 1 steady" if two else f"timestep {rng.choice(['1', '1', '1/2'])}{rng.choice(['', ' steady'])}"]
    lines += [f"param {name} in [{LOW}, {HIGH}]" for name in parameters]
    lines.append("process w = box(1,1,1) mass 1 at translate (d, 0, 0) [nil]")
    if two:
        # On its own track, or to the left on that of the other one.
        lines.append(f"process v = box(1,1,1) mass 1 at translate (e{rng.choice([', 3, 0', ' - 2, 0, 0'])}) [nil]")
    for wall in "ab":
        place = Q(rng.choice(WALLS[wall])) - (2 if two and wall == "a" else 0)
        lines.append(f"fixed {wall} = box(1,9,9){rng.choice(['', ' absorb'])} at translate ({place}, 0, 0)")
    walks = WALKS[:1] + WALKS[2:] if two else WALKS
    lines += [f"motion {name} = choose {{ {rng.choice(walks)} }}" for name in (["w", "v"] if two else ["w"])]
    side = rng.choice(["", "", "min", "max"])
    lines.append(f"check c : E{side} = ? [ {number} at {rng.choice(['1/2', '1', '3/2'] + ['2'] * (not two))} ]")
    return parameters, "\n".join(lines) + "\n"


def same_mean(side, parameters):
    """Of one parameter: the mean is the integral of the parts, or null where something unknown has a length."""
    if len(parameters) > 1:
        return True

    def length(piece):
        low, high = LOW, HIGH
        for row in piece:
            a, bound = Q(row["coefficients"]["d"]), Q(row["bound"])
            if row["relation"] == "=" or a < 0:
                low = max(low, bound / a)
            if row["relation"] == "=" or a > 0:
                high = min(high, bound / a)
        return high - low, {"d": (low + high) / 2}

    if any(length(piece)[0] > 0 for piece in side.get("unknown", {"pieces": []})["pieces"]):
        return side["mean"] is None
    total = [Q(0), Q(0)]
    for part in side["parts"]:
        for piece in part["pieces"]:
            width, middle = length(piece)
            for i, end in enumerate(ends(part, middle)):
                total[i] += width * end
    return side["mean"] is not None and [Q(side["mean"]["low"]), Q(side["mean"]["high"])] == total


def main():
    parser = argparse.ArgumentParser(description="numbers at a time that have no value for some starts")
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    passed, failed, partly, refused = 0, 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "m.sc")
        for number in range(options.count):
            rng = random.Random(f"{options.seed}/{number}")
            parameters, text = model(rng)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            report = checked(options.scc, path, "--where")
            over = {side["over"]: side for side in report.get("starts", [])}
            partly += any("unknown" in side for side in over.values())
            refused += not over

            def judge(is_right, told):
                nonlocal passed, failed
                passed, failed = passed + is_right, failed + (not is_right)
                if not is_right:
                    print(f"model {number} of seed {options.seed}, {told}")
                    print(text, flush=True)

            for name, side in over.items():
                judge(same_mean(side, parameters), f"{name}: the mean {side['mean']} is not that of its parts")
            for d in POINTS:
                point = {name: d if name == "d" else pick(rng, POINTS) for name in parameters}
                values = [word for name, x in point.items() for word in ("-D", f"{name}={x}")]
                alone = checked(options.scc, path, *values)
                where = ", ".join(f"{name} = {x}" for name, x in point.items())
                if alone["verdict"] == "undecided":
                    known = bool(over) and not any(is_unknown(side, point) for side in over.values())
                    judge(not known, f"at {where}: undecided, over starts it is not: {report['text']}")
                    continue
                judge(bool(over), f"at {where}: {alone['text']}, over starts: {report['text']}")
                for name, found in single(alone).items() if over else []:
                    known = None if is_unknown(over[name], point) else at(over[name], point)
                    judge(known == found, f"at {where}, {name}: {found}, over starts: {known}")
    print(f"{options.count} models, {partly} known for some starts alone, {refused} for none")
    print(f"{passed} passed, {failed} failed")
    return 0 if failed == 0 and passed > 0 and partly > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
