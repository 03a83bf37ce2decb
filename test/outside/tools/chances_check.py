#!/usr/bin/env python3
"""Numbers over starts as scc check --smt writes them, against JSON, by Z3 (z3-solver of PyPI).

    chances_check.py SCC [--count N] [--seed S]

Of random models (test/references/starts) each piece of JSON has the value that SMT-LIB has there, for all starts: that
another value is impossible is proved by Z3. Pieces are disjoint, and cover the ranges. The last line is
'N passed, N failed'.
"""

import argparse
import itertools
import json
import os
import random
import subprocess
import sys
import tempfile

try:
    import z3
except ImportError as error:
    print(f"not run: {error}")
    sys.exit(3)

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
sys.path.insert(0, os.path.join(ROOT, "test", "references", "starts"))
import starts  # noqa: E402


def real(text):
    return z3.RealVal(str(text))


def linear(coefficients, variables, constant="0"):
    return z3.Sum([real(constant)] + [real(a) * variables[n] for n, a in coefficients.items()])


def inside(piece, variables):
    def row(r):
        left, right = linear(r["coefficients"], variables), real(r["bound"])
        return {"<": left < right, "<=": left <= right, "=": left == right}[r["relation"]]

    return z3.And([row(r) for r in piece])


def end(part, name, variables):
    """The value of an end in a part; None if it is infinite or not known."""
    if name + "_form" in part:
        form = part[name + "_form"]
        return linear(form["coefficients"], variables, form["constant"])
    return None if part[name] is None else real(part[name])


def impossible(*claims):
    solver = z3.Solver()
    solver.add(*claims)
    return solver.check() == z3.unsat


def judge(side, script, title, variables, box):
    """Name and truth of each comparison of one side."""
    pieces = [(part, inside(piece, variables)) for part in side["parts"] for piece in part["pieces"]]
    yield "disjoint", all(impossible(box, p, q) for (_, p), (_, q) in itertools.combinations(pieces, 2))
    unknown = [inside(piece, variables) for piece in side.get("unknown", {"pieces": []})["pieces"]]
    said = z3.And(z3.parse_smt2_string(script + f"(assert |{title}-unknown|)"))
    yield "unknown", impossible(box, said != z3.Or(unknown))
    yield "cover", impossible(box, z3.Not(z3.Or([p for _, p in pieces] + unknown)))
    yield "known", impossible(z3.Or(unknown), z3.Or([p for _, p in pieces]))
    for name in ("low", "high"):
        for part, piece in pieces:
            value = end(part, name, variables)
            if value is None:
                asked = script + f"(assert |{title}-{name}-infinite|)"
                yield name + " infinite", impossible(box, piece, z3.Not(z3.And(z3.parse_smt2_string(asked))))
            else:
                result = z3.Real("result")
                asked = script + f"(declare-const result Real)(assert (= result |{title}-{name}|))"
                yield name, impossible(box, piece, z3.And(z3.parse_smt2_string(asked)), result != value)
                asked = script + f"(assert |{title}-{name}-infinite|)"
                yield name + " finite", impossible(box, piece, z3.And(z3.parse_smt2_string(asked)))


def try_model(scc, number, seed, folder):
    rng = random.Random(f"{seed}/{number}")
    model = starts.Model(rng)
    path, smt = os.path.join(folder, "m.sc"), os.path.join(folder, "m.smt2")
    with open(path, "w", encoding="utf-8") as file:
        file.write(model.text())
    if os.path.exists(smt):
        os.remove(smt)
    bounds = ["--depth", str(rng.choice([3, 80]))]
    words = [scc, "check", path, "--where", "--json", "--smt", smt, "--states", "3000"] + bounds
    report = json.loads(subprocess.run(words, capture_output=True, encoding="utf-8", check=False).stdout)
    found = report["properties"][0].get("starts") if report.get("properties") else None
    if not found or not os.path.exists(smt):
        return
    with open(smt, encoding="utf-8") as file:
        script = file.read()
    variables = {name: z3.Real(name) for name in model.ranges}
    box = z3.And([z3.And(real(a) <= variables[n], variables[n] <= real(b)) for n, (a, b) in model.ranges.items()])
    for side in found:
        title = "c" if "c-low" in script else f"c-{side['over']}"
        for what, right in judge(side, script, title, variables, box):
            yield what, right, model


def main():
    parser = argparse.ArgumentParser(description="numbers over starts in SMT-LIB, by Z3")
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    passed, failed, kinds = 0, 0, {}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.count):
            for what, right, model in try_model(options.scc, number, options.seed, folder):
                kinds[what] = kinds.get(what, 0) + 1
                passed, failed = passed + right, failed + (not right)
                if not right:
                    print(f"{what}, model {number} of seed {options.seed}\n{model.text()}", flush=True)
    print(", ".join(f"{n} {what}" for what, n in sorted(kinds.items())))
    print(f"{passed} passed, {failed} failed")
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
