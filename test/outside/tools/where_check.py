"""What is said of sets of parameters, at random: against Z3 (z3-solver), a volume of its own, and the JSON schema.

    where_check.py SCC FOLDER [COUNT [SEED]]    COUNT sets, some 20 questions for each; 100 if it is not said

The program that makes them, test/outside/where/sets.exe, stands in the same build as SCC.
"""

import itertools
import json
import os
import re
import subprocess
import sys
import xml.etree.ElementTree
from fractions import Fraction
from math import factorial

from common import Run, absent

try:
    import jsonschema
    import referencing
    import z3
except ImportError as error:
    absent(f"there is no {error.name}")

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
sys.path.insert(0, os.path.join(ROOT, "clients", "python", "src"))

from shapecalculus import Where  # noqa: E402

# Volumes, by triangulation. A polyhedron is a list of (row, bound): row . x <= bound.


def solve(rows, bounds):
    """The one solution of as many equations as variables; None if there is none, or more than one."""
    n = len(rows)
    table = [list(row) + [bound] for row, bound in zip(rows, bounds)]
    for column in range(n):
        pivot = next((i for i in range(column, n) if table[i][column] != 0), None)
        if pivot is None:
            return None
        table[column], table[pivot] = table[pivot], table[column]
        table[column] = [x / table[column][column] for x in table[column]]
        for i in range(n):
            if i != column and table[i][column] != 0:
                table[i] = [x - table[i][column] * y for x, y in zip(table[i], table[column])]
    return tuple(row[-1] for row in table)


def determinant(rows):
    rows, result = [list(row) for row in rows], Fraction(1)
    for column in range(len(rows)):
        pivot = next((i for i in range(column, len(rows)) if rows[i][column] != 0), None)
        if pivot is None:
            return Fraction(0)
        if pivot != column:
            rows[column], rows[pivot], result = rows[pivot], rows[column], -result
        result *= rows[column][column]
        for i in range(column + 1, len(rows)):
            factor = rows[i][column] / rows[column][column]
            rows[i] = [x - factor * y for x, y in zip(rows[i], rows[column])]
    return result


def rank(points):
    """The dimension of the points' affine hull."""
    base, rows, found = points[0], [], 0
    rows = [[x - y for x, y in zip(p, base)] for p in points[1:]]
    for column in range(len(base)):
        pivot = next((row for row in rows if row[column] != 0), None)
        if pivot is not None:
            found += 1
            rows.remove(pivot)
            rows = [[x - row[column] / pivot[column] * y for x, y in zip(row, pivot)] for row in rows]
    return found


def simplices(vertices, tight, dimension):
    """Simplices of a face, each by its corners: from its first vertex to the facets that do not have it."""
    if dimension == 0:
        return [[vertices[0]]]
    first, found, seen = vertices[0], [], set()
    for border in tight:
        facet = tuple(v for v in vertices if v in border)
        if facet and first not in facet and facet not in seen and rank(facet) == dimension - 1:
            seen.add(facet)
            found += [[first] + rest for rest in simplices(facet, tight, dimension - 1)]
    return found


def volume(n, polyhedron):
    vertices = set()
    for some in itertools.combinations(polyhedron, n):
        point = solve([row for row, _ in some], [bound for _, bound in some])
        if point is not None and all(dot(row, point) <= bound for row, bound in polyhedron):
            vertices.add(point)
    vertices = sorted(vertices)
    if len(vertices) <= n or rank(vertices) < n:
        return Fraction(0)
    tight = [frozenset(v for v in vertices if dot(row, v) == bound) for row, bound in polyhedron]
    edges = ([[x - y for x, y in zip(v, corners[0])] for v in corners[1:]] for corners in simplices(vertices, tight, n))
    return sum(abs(determinant(rows)) for rows in edges) / factorial(n)


def dot(row, point):
    return sum((a * x for a, x in zip(row, point)), Fraction(0))


def halves(polyhedron):
    """The constraints of a piece of the client as inequalities that are not strict."""
    for row, bound, relation in zip(polyhedron.A, polyhedron.b, polyhedron.relations):
        yield row, bound
        if relation == "=":
            yield tuple(-a for a in row), -bound


# Formulas.


def formula(variables, rows):
    """Of rows (coefficients, relation, bound)."""
    def one(row, relation, bound):
        left = z3.Sum([z3.RealVal(0)] + [z3.RealVal(str(a)) * x for a, x in zip(row, variables)])
        right = z3.RealVal(str(bound))
        return {"<": left < right, "<=": left <= right, "=": left == right}[relation]
    return z3.And([one(*row) for row in rows])


RELATIONS = {-1: "<", 0: "=", 1: "<="}


def given(variables, polyhedra):
    return z3.Or([formula(variables, [(a, RELATIONS[r], b) for a, r, b in p]) for p in polyhedra])


def said(variables, region):
    return z3.Or([formula(variables, zip(p.A, p.relations, p.b)) for p in region.pieces])


def impossible(*claims):
    solver = z3.Solver()
    solver.add(*claims)
    return solver.check() == z3.unsat


# Texts.


def truth(text, values):
    """Whether what the words of a piece say is so at a point."""
    if text == "everywhere":
        return True
    text = re.sub(r"(?<![<>])=", "==", text)
    text = re.sub(r"(\d) ?(?=[a-z])", r"\1*", text)
    text = re.sub(r"(\d+)", r"Fraction(\1)", text)
    return all(eval(part, {"Fraction": Fraction}, values) for part in text.split(", "))


def told(lines, values):
    """What the lines of a report say of a point."""
    elsewhere, outcome, current = None, None, None
    for line in lines[:-1]:  # the last one is the probability
        if line.startswith("  "):
            text = re.sub(r"^  (or )?", "", re.sub(r" \(no [a-z]+\)$", "", line))
            if truth(text, values):
                outcome = current
        elif line.endswith(" where"):
            current = line.split()[0]
        elif line.endswith("everywhere"):
            return line.split()[0]
        elif line == "not known anywhere":
            return "unknown"
        elif line.endswith("elsewhere"):
            elsewhere = line.split()[0]
    return {"not": "unknown"}.get(outcome or elsewhere, outcome or elsewhere)


CORNER = re.compile(r"^\(?[a-z]+(?:, [a-z]+\))? = \(?([^),]+)(?:, ([^)]+)\))?\n(?:[A-Z]: )?(.*)$")
NAMES = {"holds": "holds", "fails": "fails", "not known": "unknown"}


def corners(picture):
    """The points that a picture names, with the outcome that it tells."""
    for title in picture.iter("{http://www.w3.org/2000/svg}title"):
        found = CORNER.match(title.text)
        if found and (found[3] in NAMES or found[3] == "out of range"):
            yield [Fraction(x) for x in found.groups()[:2] if x is not None], NAMES.get(found[3])


def schema():
    resources = []
    for name in ("common",):
        with open(os.path.join(ROOT, "specs", "schema", name + ".schema.json")) as file:
            resources.append((name + ".schema.json", referencing.Resource.from_contents(json.load(file))))
    registry = referencing.Registry().with_resources(resources)
    return jsonschema.Draft202012Validator({"$ref": "common.schema.json#/$defs/where"}, registry=registry)


def outcome(where, point):
    try:
        return where.outcome(point)
    except ValueError:
        return None


def judge(case, validator):
    """Name and truth of each comparison."""
    yield "schema", validator.is_valid(case["where"])
    where = Where.from_json(case["where"])
    names, n = where.parameters, len(where.parameters)
    x = [z3.Real(name) for name in names]
    box = formula(x, zip(where.range.A, where.range.relations, where.range.b))

    # what was asked, and what JSON says
    holds, fails, unknown = (said(x, region) for region in (where.holds, where.fails, where.unknown))
    asked, denied = given(x, case["holds"]), given(x, case["fails"])
    yield "holds", impossible(holds != z3.And(box, asked))
    yield "fails", impossible(fails != z3.And(box, denied))
    yield "unknown", impossible(unknown != z3.And(box, z3.Not(asked), z3.Not(denied)))
    pieces = [formula(x, zip(p.A, p.relations, p.b)) for r in (where.holds, where.fails, where.unknown) for p in r.pieces]
    yield "disjoint", all(impossible(p, q) for p, q in itertools.combinations(pieces, 2))
    yield "not empty", not any(impossible(p) for p in pieces)

    # SMT-LIB says the same as JSON
    for suffix, json_says in (("holds", holds), ("fails", fails), ("unknown", unknown)):
        asserted, said_there = z3.parse_smt2_string(f"{case['smt']}(assert it-{suffix})")
        yield "SMT-LIB: " + suffix, impossible(said_there != json_says)
        yield "SMT-LIB: range", impossible(asserted != box)

    # measures
    for name in ("holds", "fails", "unknown"):
        region = getattr(where, name)
        measured = sum((volume(n, list(halves(p))) for p in region.pieces), Fraction(0))
        yield "measure: " + name, measured == region.measure
    whole = volume(n, list(halves(where.range)))
    yield "whole", whole == where.holds.measure + where.fails.measure + where.unknown.measure
    high = (where.holds.measure + where.unknown.measure) / whole
    yield "probability", where.probability_between == (where.holds.measure / whole, high)
    yield "one probability", (where.probability is None) == (where.unknown.measure != 0)

    # words and pictures, at points
    step = (Fraction(1, 2), Fraction(1, 2), Fraction(1), Fraction(2))[n - 1]
    grid = [k * step - 3 for k in range(int(6 / step) + 1)]
    points = [p for p in itertools.product(grid, repeat=n) if where.range.contains(p)]
    yield "words", all(told(case["lines"], dict(zip(names, p))) == where.outcome(p) for p in points)
    if case["svg"] is not None:
        picture = xml.etree.ElementTree.fromstring(case["svg"])
        if n < 3:
            found = list(corners(picture))
            yield "corners", bool(found) and all(outcome(where, p) == told_there for p, told_there in found)


def main():
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 100
    seed = sys.argv[4] if len(sys.argv) > 4 else "1"
    run = Run("Sets of parameters, against Z3")
    program = os.path.join(os.path.dirname(run.scc), "..", "test", "outside", "where", "sets.exe")
    if not os.path.exists(program):
        absent("sets.exe has not been built")
    validator, number = schema(), -1
    with subprocess.Popen([program, str(count), seed], stdout=subprocess.PIPE, text=True) as asked:
        for number, line in enumerate(asked.stdout):
            case = json.loads(line)
            for what, right in judge(case, validator):
                run.ok(right, f"{what}, case {number} of seed {seed}" + ("" if right else ": " + line.strip()[:1500]))
    if asked.returncode != 0 or number + 1 != count:
        run.ok(False, "sets.exe did not end well")
    run.end()


main()
