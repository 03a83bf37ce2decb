"""lib/solids/polyhedra against the Parma Polyhedra Library (pplpy): random polyhedra, not necessarily closed.

    systems_check.py SCC FOLDER [COUNT [SEED]]    COUNT pairs, 26 questions for each; 100 if it is not said

The program that asks lib/solids/polyhedra, test/outside/systems/operations.exe, stands in the same build as SCC.
"""

import json
import os
import subprocess
import sys
from fractions import Fraction
from math import lcm

from common import Run, absent

try:
    import ppl
except ImportError:
    absent("there is no pplpy")


def expression(coefficients, constant=0):
    return sum((a * ppl.Variable(i) for i, a in enumerate(coefficients) if a), ppl.Linear_Expression(constant))


def constraint(c):
    normal, relation, right = c
    left = expression(normal, -right)
    if relation == 0:
        return left == 0
    return left < 0 if relation < 0 else left <= 0


def polyhedron(n, constraints):
    result = ppl.NNC_Polyhedron(n, "universe")
    for c in constraints:
        result.add_constraint(constraint(c))
    return result


def same(p, q):
    return p.contains(q) and q.contains(p)


def negations(c):
    normal, relation, right = c
    opposite = [-a for a in normal]
    if relation == 0:
        return [(normal, -1, right), (opposite, -1, -right)]
    return [(opposite, 1 if relation < 0 else -1, -right)]


def difference(p, constraints):
    """Pieces of p outside of the constraints."""
    inside = ppl.NNC_Polyhedron(p)
    for c in constraints:
        for other in negations(c):
            piece = ppl.NNC_Polyhedron(inside)
            piece.add_constraint(constraint(other))
            if not piece.is_empty():
                yield piece
        inside.add_constraint(constraint(c))


def hull(n, polyhedra):
    result = ppl.NNC_Polyhedron(n, "empty")
    for p in polyhedra:
        result.poly_hull_assign(p)
    return result


def integers(numbers):
    """The numbers times a common denominator, and that."""
    fractions = [Fraction(x) for x in numbers]
    common = lcm(*(x.denominator for x in fractions)) if fractions else 1
    return [int(x * common) for x in fractions], common




def onto(p, n, kept):
    """The variables kept, in that order: new ones are equal to them, and the others are turned away."""
    forms = [[0] + [1 if j == i else 0 for j in range(n)] for i in kept]
    return image(p, n, forms)


def image(p, n, forms):
    m = len(forms)
    if m == 0:
        return ppl.NNC_Polyhedron(0, "empty" if p.is_empty() else "universe")
    # y first, so that x can be cut off: x_i is variable m + i
    result = ppl.NNC_Polyhedron(m, "universe")
    result.concatenate_assign(p)
    for k, f in enumerate(forms):
        (constant, *coefficients), common = integers(f)
        result.add_constraint(expression([0] * m + coefficients, constant) == common * ppl.Variable(k))
    result.remove_higher_space_dimensions(m)
    return result


def preimage(p, n, forms, m):
    """The points y of the space of dimension m that the forms map into p."""
    result = ppl.NNC_Polyhedron(m, "universe")
    result.concatenate_assign(p)
    for i, f in enumerate(forms):
        (constant, *coefficients), common = integers(f)
        result.add_constraint(expression(coefficients, constant) == common * ppl.Variable(m + i))
    result.remove_higher_space_dimensions(m)
    return result


def at(point, p):
    """Whether p has the point."""
    n = p.space_dimension()
    alone = ppl.NNC_Polyhedron(n, "universe")
    for i, x in enumerate(point):
        x = Fraction(x)
        alone.add_constraint(x.denominator * ppl.Variable(i) == x.numerator)
    return p.contains(alone)


def bound(p, f, upper):
    if p.is_empty():
        return None
    (constant, *coefficients), common = integers(f)
    e = expression(coefficients, constant)
    answer = p.maximize(e) if upper else p.minimize(e)
    if not answer["bounded"]:
        return "unbounded"
    value, closed = (("sup_n", "sup_d"), "maximum") if upper else (("inf_n", "inf_d"), "minimum")
    value = Fraction(int(answer[value[0]]), int(answer[value[1]])) / common
    return [str(value), bool(answer[closed])]




def interior(p):
    """The relative interior: its constraints, made strict."""
    result = ppl.NNC_Polyhedron(p.space_dimension(), "universe")
    for c in p.minimized_constraints():
        e = sum((c.coefficient(ppl.Variable(i)) * ppl.Variable(i) for i in range(c.space_dimension())),
                ppl.Linear_Expression(c.inhomogeneous_term()))
        result.add_constraint(e == 0 if c.is_equality() else e > 0)
    return result


def judge(case):
    """Name and truth of each comparison."""
    n = case["n"]
    p, q = polyhedron(n, case["p"]), polyhedron(n, case["q"])
    empty = p.is_empty()
    yield "empty", case["empty"] == empty
    yield "universe", case["universe"] == p.is_universe()
    yield "dimension", case["dimension"] == (-1 if empty else p.affine_dimension())
    yield "bounded", case["bounded"] == p.is_bounded()
    yield "closed", case["closed"] == p.is_topologically_closed()
    minimal = polyhedron(n, case["minimal"])
    yield "minimal", same(minimal, p)
    if not empty:
        mine = case["minimal"]
        theirs = list(p.minimized_constraints())
        yield "equalities", sum(c[1] == 0 for c in mine) == sum(c.is_equality() for c in theirs)
        yield "no constraint too many", not any(
            polyhedron(n, mine[:i] + mine[i + 1:]) == p for i in range(len(mine)))
    if p.is_topologically_closed() and not empty:
        yield "size", len(case["minimal"]) == len(list(p.minimized_constraints()))
    closure = ppl.NNC_Polyhedron(p)
    closure.topological_closure_assign()
    yield "closure", same(polyhedron(n, case["closure"]), closure)
    if empty:
        yield "no point", case["point"] is None and case["interior"] is None
    else:
        yield "point", at(case["point"], p)
        yield "interior", at(case["interior"], interior(p))
    yield "supremum", case["supremum"] == bound(p, case["form"], True)
    yield "infimum", case["infimum"] == bound(p, case["form"], False)
    kept = case["onto"]
    yield "projection", same(polyhedron(len(kept), case["projection"]), onto(p, n, kept))
    forms = case["forms"]
    yield "image", same(polyhedron(len(forms), case["image"]), image(p, n, forms))
    yield "preimage", same(polyhedron(2, case["preimage"]), preimage(p, n, case["back"], 2))

    yield "included", case["included"] == q.contains(p)
    yield "equal", case["equal"] == (p == q)
    yield "disjoint", case["disjoint"] == p.is_disjoint_from(q)
    both = ppl.NNC_Polyhedron(p)
    both.intersection_assign(q)
    yield "intersection", same(polyhedron(n, case["intersection"]), both)
    left = [polyhedron(n, piece) for piece in case["difference"]]
    wanted = ppl.NNC_Polyhedron(p)
    wanted.poly_difference_assign(q)
    yield "hull of the difference", same(hull(n, left), wanted)
    yield "pieces", all(not x.is_empty() and x.is_disjoint_from(q) and p.contains(x) for x in left)
    yield "pieces disjoint", all(x.is_disjoint_from(y) for i, x in enumerate(left) for y in left[:i])
    rest = list(difference(p, case["q"]))
    for piece in case["difference"]:
        rest = [r for x in rest for r in difference(x, piece)]
    yield "difference", not rest
    join, joined = polyhedron(n, case["join"]), hull(n, [p, q])
    yield "join", join.contains(joined)
    convex = not any(True for x in difference(joined, case["p"]) for _ in difference(x, case["q"]))
    if convex:
        yield "merge", case["merge"] is not None and same(polyhedron(n, case["merge"]), joined)
    else:
        yield "no merge", case["merge"] is None
    widened = polyhedron(n, case["widening"])
    yield "widening", widened.contains(join)
    parts = [polyhedron(n, part) for part in case["parts"]]
    apart = all(x.is_disjoint_from(y) for i, x in enumerate(parts) for y in parts[:i])
    yield "disjoint union", apart and same(hull(n, parts), joined) and all(
        not any(True for x in difference(part, case["p"]) for _ in difference(x, case["q"])) for part in parts)


def main():
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 100
    seed = sys.argv[4] if len(sys.argv) > 4 else "1"
    run = Run("Polyhedra that are not closed, against PPL")
    program = os.path.join(os.path.dirname(run.scc), "..", "test", "outside", "systems", "operations.exe")
    if not os.path.exists(program):
        absent("operations.exe has not been built")
    with subprocess.Popen([program, str(count), seed], stdout=subprocess.PIPE, text=True) as asked:
        for number, line in enumerate(asked.stdout):
            case = json.loads(line)
            for what, right in judge(case):
                run.ok(right, f"{what}, case {number} of seed {seed}" + ("" if right else ": " + line.strip()[:1500]))
    if asked.returncode != 0 or number + 1 != count:
        run.ok(False, "operations.exe did not end well")
    run.end()


main()
