#!/usr/bin/env python3
"""What `scc check --parametric k` says of k is what `scc check -D k=VALUE` says of each value.

    parametric_test.py SCC [--count N] [--seed N] [--values N] [--sympy]

Random models: one or two walkers between walls, whose weights depend on k and on the place; bonds that break with a
chance that depends on k, chosen freely or not; walkers that diffuse. Functions and sets of their checks are compared
at random values, and next to the ends of each set. With --sympy (from PyPI), chances and mean times of walks on a line
are also solved by SymPy as functions. The last line is 'N passed, N failed'.
"""
import argparse
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

WEIGHTS = ["k", "1 - k", "1 + k", "2 - k", "k*k", "k*(1 - k)", "1/(1 + k)", "k/(2 - k)", "1", "2", "3"]
CHANCES = ["k", "(1 - k)", "(k/2)", "(1 - k*k)", "(k/(1 + k))", "1/2", "1/3",
           "(k*k + (1 - k)*(1 - k))", "(2*k*(1 - k))"]  # both are 1/2 at k = 1/2, and on one side of it elsewhere
RANGES = [("0", "1"), ("0", "1/2"), ("1/5", "9/10")]
BOUNDS = ["1/10", "1/4", "1/3", "1/2", "3/4", "9/10", "1", "0"]


def weight(rng):
    plain = rng.choice(WEIGHTS)
    if rng.random() < 0.25:
        return f"(if x <= {rng.choice([0, 1])} then {plain} else {rng.choice(WEIGHTS)})"
    return plain


def nested(rng, measure, question):
    """A question, or another one with a test of its probability as an operand."""
    if not measure.startswith("P") or rng.random() < 0.7:
        return comparison(rng, measure, question)
    test = f"P {rng.choice(['<', '<=', '>', '>='])} {rng.choice(BOUNDS)} [ {question} ]"
    forms = [("P", "eventually {}"), ("P", "always {} within 2"), ("E", "time U {}"), ("E", "event weak U {}"),
             ("P", "{} U[1, 2] true"), ("P", "true U {}")]
    outer, form = rng.choice(forms)
    return comparison(rng, outer, form.format(f"(not {test})"))


def comparison(rng, measure, question):
    """A question for a number, or a comparison of it."""
    if rng.random() < 0.5:
        return f"{measure} = ? [ {question} ]"
    return f"{measure} {rng.choice(['<', '<=', '>', '>='])} {rng.choice(BOUNDS)} [ {question} ]"


def walk(rng):
    """A walker on a line between two walls, and its weights of steps to the right, to the left and of none."""
    left, right = -rng.choice([1, 2, 3]), rng.choice([1, 2, 3])
    stay = weight(rng) if rng.random() < 0.3 else None
    weights = [weight(rng), weight(rng), stay]
    kicks = [f"({v}, 0, 0) weight {w}" for v, w in zip((1, -1, 0), weights) if w is not None]
    text = f"""timestep 1
process w = solids.Cube(1) mass 1 [nil]
fixed low  = solids.Cube(1) absorb at translate ({left - 1}, 0, 0)
fixed high = solids.Cube(1) absorb at translate ({right + 1}, 0, 0)
motion w = choose {{ {", ".join(kicks)} }}
"""
    questions = [
        ("P", "eventually event absorb(w, high)"),
        ("P", f"eventually gone(w) within {rng.choice([1, 2, 3, 5])}"),
        ("P", f"(x(w) >= 0) U[1, {rng.choice([2, 4])}] (x(w) = 1)"),
        ("E", "time U gone(w)"),
        ("E", f"(if gone(w) then 0 else x(w)) at {rng.choice(['1', '3/2', '3'])}"),
    ]
    return text, [nested(rng, *q) for q in questions], (left, right, weights)


def release(rng):
    """Bonds that break by chance; which one does may be left to choose."""
    free = rng.random() < 0.5
    first, second, third = (rng.choice(CHANCES) for _ in range(3))
    middle = ("omega(bond, {right}). Quick + omega(bond, {right}). Slow" if free
              else f"omega(bond, {{right}}) chance {third}. Quick + omega(m, {{left}}) chance {second}. Won")
    text = f"""split_step 1
behaviour A on solids.Cube(1) = {middle}
behaviour B on solids.Cube(1) = omega(bond, {{left}}). nil
behaviour Quick on solids.Cube(1) = omega(m, {{left}}) chance {first}. Won
behaviour Slow on solids.Cube(1) = omega(m, {{left}}) chance {second}. Won
behaviour Won on solids.Cube(1) = nil
behaviour C on solids.Cube(1) = omega(m, {{right}}). nil
process c = solids.Cube(1) mass 1 at translate (-1, 0, 0) [C]
process a = solids.Cube(1) mass 1 [A]
process b = solids.Cube(1) mass 1 at translate (1, 0, 0) [B]
bond <bond, {{a.right, b.left}}>
bond <m, {{c.right, a.left}}>
"""
    within = rng.choice([0, 1, 2, 3])
    questions = [
        ("P", f"eventually behaviour(a) = Won within {within}"),
        (rng.choice(["Pmin", "Pmax"]), f"eventually behaviour(a) = Won within {within + 1}"),
        ("P", "bound(a, b) U behaviour(a) = Won"),
        (rng.choice(["Emin", "Emax"]), "event weak U behaviour(a) = Won"),
        ("E", f"bonds(m) at {within}"),
    ]
    return text, [nested(rng, *q) for q in questions], None


def ligand(rng):
    """A walker that diffuses along a line, with a bond that breaks by chance."""
    text = f"""timestep 1 steady
split_step 1
behaviour Free on solids.Cube(1) = <b, {{right}}>. omega(b, {{right}}) chance {rng.choice(CHANCES)}. Free
behaviour Site on solids.Cube(1) = <~b, {{left}}>. omega(b, {{left}}). Site
process w = solids.Cube(1) mass 1 [Free]
fixed s = solids.Cube(1) at translate (2, 0, 0) [Site]
fixed low = solids.Cube(1) at translate (-2, 0, 0)
motion w = diffuse((1/2, 0, 0))
"""
    questions = [
        ("P", f"true U[{rng.choice([1, 2])}, 3] (not bound(w, s))"),
        ("P", f"eventually event weak within {rng.choice([2, 3, 4])}"),
        ("E", "event bind U event weak"),
        ("E", f"bonds(b) at {rng.choice([2, 3])}"),
    ]
    return text, [nested(rng, *q) for q in questions], None


def exact(text):
    return Fraction(text)


def of_polynomial(coefficients, x):
    """The coefficients are those of 1, x, x^2, ..."""
    value = Fraction(0)
    for c in reversed(coefficients):
        value = value * x + exact(c)
    return value


def side(end, x):
    """-1, 0 or 1: x is below an end, at it, or above."""
    if isinstance(end, str):
        value = exact(end)
        return (x > value) - (x < value)
    low, high = exact(end["low"]), exact(end["high"])
    if x <= low or x >= high:
        return 1 if x >= high else -1
    here, there = of_polynomial(end["root_of"], x), of_polynomial(end["root_of"], high)
    if here == 0:
        return 0
    return 1 if (here > 0) == (there > 0) else -1


def in_sets(sets, x):
    def inside(s):
        low, high = side(s["low"], x), side(s["high"], x)
        return (low > 0 or (low == 0 and s["low_included"])) and (high < 0 or (high == 0 and s["high_included"]))
    return any(inside(s) for s in sets)


def values_at(function, x):
    """What the pieces at x say: numbers, or None where it is infinite."""
    found = set()
    for piece in function["pieces"]:
        if side(piece["low"], x) >= 0 and side(piece["high"], x) <= 0:
            f = piece["function"]
            found.add(None if f is None else of_polynomial(f["numerator"], x) / of_polynomial(f["denominator"], x))
    return found


def run(scc, path, *words):
    result = subprocess.run([scc, "check", path, "--json", "--jobs", "1", *words], capture_output=True, text=True,
                            check=False)
    if result.returncode > 2:
        raise RuntimeError(f"{words}: exit code {result.returncode}: {result.stdout[:800]} {result.stderr[:400]}")
    return json.loads(result.stdout)


def ends_of(report):
    """The ends of all pieces and sets; where they are not rational, numbers on both sides of them."""
    found = []
    for p in report["properties"]:
        d = p.get("dependence")
        if d is not None:
            pieces = [piece for f in d.get("functions", []) for piece in f["pieces"]] + (d.get("holds") or [])
            for end in [s[name] for s in pieces for name in ("low", "high")]:
                found += [exact(end)] if isinstance(end, str) else [exact(end["low"]), exact(end["high"])]
    return found


def within_another(formula):
    """Whether an operand has a test of a probability, which other values of k may pass or fail."""
    return re.search("P(min|max)? [<>]", formula.split("[", 1)[1]) is not None


def differences(scc, path, report, low, high, rng, count):
    """How functions and plain values differ at some values: texts, and how many were compared."""
    wrong, compared = [], 0
    tiny = (high - low) / 1000
    ends = {e for e in ends_of(report) if low < e < high}
    near = sorted(e + d for e in ends for d in (-tiny, tiny))
    points = set(rng.sample(sorted(ends), min(2 * count, len(ends)))) | set(rng.sample(near, min(count, len(near))))
    points |= {low + (high - low) * Fraction(rng.randint(1, 99), 100) for _ in range(count)}
    for x in sorted(p for p in points if low < p < high):
        plain = {p["name"]: p for p in run(scc, path, "-D", f"k={x}")["properties"]}
        for p in report["properties"]:
            d, other = p.get("dependence"), plain[p["name"]]
            if within_another(p["formula"]):
                compared += 1
                if d is not None or p["verdict"] != "undecided":
                    wrong.append(f"{p['formula']}: {p['text']}, though k matters within")
                continue
            if d is None:
                wrong.append(f"{p['formula']}: {p['text']}")
                continue
            if d.get("holds") is not None:
                compared += 1
                if in_sets(d["holds"], x) != (other["verdict"] == "holds"):
                    wrong.append(f"{p['formula']} at {x}: {other['text']}, and not so as a function")
            for v in other.get("values") or []:
                compared += 1
                number = None if v["low"] is None else exact(v["low"])
                same = [f for f in d["functions"] if f["side"] == v["over"]] or d["functions"]
                if values_at(same[0], x) != {number}:
                    wrong.append(f"{p['formula']} at {x}: {number}, as a function {values_at(same[0], x)}")
    return wrong, compared


def solved(report, line):
    """Walks on a line as SymPy solves them: the chance to come to the right end, and the mean time until it is over.
    Texts about functions that differ, and how many were compared."""
    import sympy  # by hand only

    k = sympy.Symbol("k")
    left, right, weights = line

    def at(place, text):
        if text is None:
            return sympy.Integer(0)
        conditional = re.fullmatch(r"\(if x <= (\d) then (.*) else (.*)\)", text)
        if conditional:
            text = conditional.group(2 if place <= int(conditional.group(1)) else 3)
        return sympy.sympify(text, rational=True)

    places = range(left + 1, right)
    h = {p: sympy.Symbol(f"h{p - left}") for p in places}
    t = {p: sympy.Symbol(f"t{p - left}") for p in places}
    chances, times = [], []
    for p in places:
        up, down, stay = (at(p, w) for w in weights)
        chances.append(up * h.get(p + 1, 1) + down * h.get(p - 1, 0) - (up + down) * h[p])
        times.append(up * t.get(p + 1, 0) + down * t.get(p - 1, 0) - (up + down) * t[p] + up + down + stay)
    expected = {"absorb(w, high)": sympy.solve(chances, list(h.values()))[h[0]],
                "time U gone(w)": sympy.solve(times, list(t.values()))[t[0]]}
    wrong, compared = [], 0
    for p in report["properties"]:
        for words, function in expected.items():
            if p.get("dependence") and words in p["formula"] and "within" not in p["formula"]:
                compared += 1
                [piece] = p["dependence"]["functions"][0]["pieces"]
                polynomials = [sum(sympy.Rational(c) * k**i for i, c in enumerate(piece["function"][name]))
                               for name in ("numerator", "denominator")]
                if sympy.cancel(polynomials[0] / polynomials[1] - function) != 0:
                    wrong.append(f"{p['formula']}: SymPy: {sympy.cancel(function)}, here {polynomials}")
    return wrong, compared


EQUAL = re.compile(r"are equal for k = (?:root of .* in \((\S+), (\S+)\),[^:]*|(\S+)): there two summands")


def without_equal(scc, path, low, high):
    """The report for a range that leaves out values at which two summands are one term (rule Lot), and the range."""
    for _ in range(4):
        try:
            return run(scc, path, "--parametric", "k", "-D", f"k=({low}, {high})"), low, high
        except RuntimeError as error:
            found = EQUAL.search(str(error))
            if found is None:
                raise
            left, right = (Fraction(found[i] or found[3]) for i in (1, 2))
            if not low < right or not left < high:
                raise
            # the longer one of both sides
            low, high = (right, high) if high - right >= left - low else (low, left)
    raise RuntimeError("no range is without such values")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=6)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--values", type=int, default=2)
    parser.add_argument("--sympy", action="store_true")
    options = parser.parse_args()
    passed = failed = 0
    scc = os.path.abspath(options.scc)
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.count):
            rng = random.Random(f"{options.seed} {number}")
            low, high = rng.choice(RANGES)
            text, checks, line = rng.choice([walk, walk, release, ligand])(rng)
            head = f"model m\nimport <solids>\nparam k in ({low}, {high})\n"
            text = head + text + "".join(f"check c{i} : {c}\n" for i, c in enumerate(checks))
            path = os.path.join(folder, "m.sc")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            try:
                report, low, high = without_equal(scc, path, Fraction(low), Fraction(high))
                wrong, compared = differences(scc, path, report, low, high, rng, options.values)
                if options.sympy and line is not None:
                    more, others = solved(report, line)
                    wrong, compared = wrong + more, compared + others
            except RuntimeError as error:
                wrong, compared = [str(error)], 0
            passed += compared
            failed += len(wrong)
            if wrong:
                print(f"model {number} of seed {options.seed}:\n{text}" + "\n".join(wrong))
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed or not passed else 0)


if __name__ == "__main__":
    main()
