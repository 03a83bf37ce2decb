#!/usr/bin/env python3
"""Orientations that diffuse (rule Diffuse), over many simulated steps.

    diffusing.py SCC [--steps N] [--seed S]

One run of `scc trace` with rounded orientations. For each axis of the world, and lags of 1, 2 and 3 steps, the mean of
u.u' over the run is held against (1 - c Delta)^lag, where c is the sum of the constants of the other two axes. The
standard error is that of means over blocks of 100 steps. Each turn is one of those that the rule allows, and each kind
comes as often as its chance says. What is more than 4.5 standard errors away fails. The last line is 'N passed, N failed'.
"""

import argparse
import collections
import json
import math
import os
import subprocess
import sys
import tempfile
from fractions import Fraction as Q

CONSTANTS = (Q(1, 8), Q(1, 4), Q(1, 10))
STEP = Q(1, 4)
MODEL = f"""
dynamics constant_spin
round orientation 2^-40
resolution 1/1024
timestep {STEP}
process p = box(2, 1, 1) mass 1 [nil]
motion p = diffuse(0, turning = ({CONSTANTS[0]}, {CONSTANTS[1]}, {CONSTANTS[2]}))
check c : always time >= 0
"""


def turned(quaternion):
    """The images of the three axes."""
    w, x, y, z = quaternion
    n = w * w + x * x + y * y + z * z
    return (
        ((w * w + x * x - y * y - z * z) / n, 2 * (x * y + w * z) / n, 2 * (x * z - w * y) / n),
        (2 * (x * y - w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z + w * x) / n),
        (2 * (x * z + w * y) / n, 2 * (y * z - w * x) / n, (w * w - x * x - y * y + z * z) / n),
    )


def relative(a, b):
    """The turn from a to b about axes of the world, as a matrix: the images of the axes."""
    return [[sum(a[k][i] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def run(scc, steps, seed, folder):
    """The orientations at the ends of all steps, and how often each spin was drawn."""
    path = os.path.join(folder, "m.sc")
    with open(path, "w", encoding="utf-8") as file:
        file.write(MODEL)
    words = [scc, "trace", path, "--choose", f"random:{seed}", "--time", str(steps * STEP)]
    found, spins, chances = [], collections.Counter(), {}
    with subprocess.Popen(words, stdout=subprocess.PIPE, encoding="utf-8") as trace:
        for line in trace.stdout:
            event = json.loads(line)
            if event.get("label", {}).get("kind") == "draw":
                spin = tuple(event["label"]["spin"])
                spins[spin] += 1
                chances[spin] = Q(event["label"]["chance"])
            if "state" in event and event["type"] != "header":
                state = event["state"]
                if Q(event["time"]) % STEP == 0 and state["processes"][0]["draw"] == "waits":
                    found.append(turned([float(Q(q)) for q in state["processes"][0]["leaves"][0]["turned"]]))
    return found, spins, chances


def blocks(values, size=100):
    """Mean and standard error, by the means of blocks."""
    means = [sum(values[i : i + size]) / size for i in range(0, len(values) - size + 1, size)]
    mean = sum(means) / len(means)
    return mean, math.sqrt(sum((m - mean) ** 2 for m in means) / (len(means) - 1) / len(means))


def main():
    parser = argparse.ArgumentParser(description="orientations that diffuse, over many steps")
    parser.add_argument("scc")
    parser.add_argument("--steps", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        found, spins, chances = run(options.scc, options.steps, options.seed, folder)
    passed = failed = 0

    def check(name, expected, value, error):
        nonlocal passed, failed
        away = abs(value - expected) / error if error else 0 if abs(value - expected) < 1e-9 else math.inf
        print(f"  {name}: {value:.6f}, by the rule {expected:.6f}, {away:.1f} standard errors")
        passed, failed = passed + (away <= 4.5), failed + (away > 4.5)

    total = sum(spins.values())
    for spin in sorted(spins):
        p = float(chances[spin])
        check("spin " + ", ".join(spin), p, spins[spin] / total, math.sqrt(p * (1 - p) / total))
    for axis, name in enumerate("xyz"):
        kept = 1 - float(STEP) * float(sum(CONSTANTS) - CONSTANTS[axis])
        for lag in (1, 2, 3):
            turns = (relative(a, b) for a, b in zip(found, found[lag:]))
            check(f"{name}, {lag} steps", kept**lag, *blocks([t[axis][axis] for t in turns]))
        other = (axis + 1) % 3
        turns = (relative(a, b) for a, b in zip(found, found[1:]))
        check(f"{name} and the next axis", 0.0, *blocks([t[axis][other] for t in turns]))
    print(f"{len(found) - 1} steps")
    print(f"{passed} passed, {failed} failed")
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
