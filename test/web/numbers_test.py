"""The page's exact numbers, its floats and its courses against Python's fractions: numbers_test.py WEB [CASES].

Scenes are made at random, a page of data for each, with turning and straight processes, merges and splits, states that
are told by what has changed and states that are not, far from the origin and near it.

Polygons are cut into triangles, and cameras see what is on their rays.
"""

import json
import math
import random
import struct
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "unit/exact"))
import decimals
import decimals_test

draw = random.Random(16)


def text(x):
    return f"{x.numerator}/{x.denominator}"


def bits(x):
    return str(struct.unpack(">Q", struct.pack(">d", x))[0])


def nearest(x):
    """The nearest float: Python rounds the quotient of whole numbers rightly."""
    try:
        return x.numerator / x.denominator
    except OverflowError:
        return float("inf") if x > 0 else float("-inf")


def whole(size):
    return draw.randrange(-(2**size), 2**size + 1)


def rational(size=None):
    size = size or draw.choice([2, 3, 6, 20, 52, 53, 54, 60, 200, 1100, 1200])
    return Fraction(whole(size), draw.choice([1, 1 + abs(whole(size)), 2 ** draw.randrange(0, size + 1)]))


def hard():
    """A number at a tie of rounding, or beside one; some are so small or great that floats have few bits left."""
    odd = 2 * draw.randrange(2**52, 2**53) + 1
    power = draw.choice([0, 3, -60, 900, 969, 970, 971, -1000, -1073, -1074, -1075, -1076, -1100, -1130])
    tie = Fraction(odd) * Fraction(2) ** power
    return draw.choice([-1, 1]) * (tie + draw.choice([0, 0, 1, -1]) * Fraction(1, 3) * Fraction(2) ** (power - 200))


class Page:
    """A scene of single leaves and of pairs, and what is where in it, by Python's fractions."""

    def __init__(self, far):
        self.far = far
        self.leaves = draw.randrange(2, 7)
        self.processes = []
        self.states = []
        self.truth = []

    def vector(self, size=4):
        return [Fraction(whole(size), draw.choice([1, 1, 2, 3, 5, 7])) for _ in range(3)]

    def process(self, leaves):
        spin = draw.random() < 0.5
        entry = {"leaves": [], "bonds": [], "velocity": self.vector(2), "mass": None}
        entry["velocity"] = [v if draw.random() < 0.7 else Fraction(0) for v in entry["velocity"]]
        if spin:
            centre = [a + b for a, b in zip(self.far, self.vector())]
            entry["turn"] = {"centre": centre, "spin": self.vector(2), "since": Fraction(draw.randrange(5), 3)}
        for leaf in leaves:
            place = {"leaf": leaf, "at": [a + b for a, b in zip(self.far, self.vector())], "behaviour": 0}
            if draw.random() < 0.5:
                place["turned"] = [str(1 + draw.randrange(4))] + [str(whole(2)) for _ in range(3)]
            if spin:
                place["arm"] = self.vector()
            entry["leaves"].append(place)
        self.processes.append(entry)
        return len(self.processes) - 1

    def groups(self, leaves):
        leaves = list(leaves)
        draw.shuffle(leaves)
        while leaves:
            size = draw.choice([1, 1, 2])
            yield sorted(leaves[:size])
            leaves = leaves[size:]

    def first(self, index):
        return self.processes[index]["leaves"][0]["leaf"]

    def begin(self):
        come = [self.process(group) for group in self.groups(range(self.leaves))]
        return self.add(None, Fraction(0), [], come, {i: Fraction(0) for i in come})

    def add(self, of, after, gone, come, truth):
        self.states.append({"of": of, "after": after, "gone": gone, "come": come, "next": None, "rests": False,
                            "stuck": None, "values": []})
        self.truth.append(truth)
        return len(self.states) - 1

    def follow(self, state, duration):
        """A state so long after another one, and some processes of it replaced, or absorbed."""
        ages = {i: age + duration for i, age in self.truth[state].items()}
        if not ages:
            return self.add(state, duration, [], [], ages)
        taken = draw.sample(sorted(ages), draw.randrange(0, min(3, len(ages) + 1)))
        free = [place["leaf"] for i in taken for place in self.processes[i]["leaves"]]
        if draw.random() < 0.1:
            free = free[1:]
        come = [self.process(group) for group in self.groups(free)]
        for i in taken:
            del ages[i]
        ages.update({i: Fraction(0) for i in come})
        return self.add(state, duration, [self.first(i) for i in taken], come, ages)

    def again(self, state):
        """The same state, told in another way: in full, all entries new, or all of one age, another one at times."""
        ages = self.truth[state]
        if len(set(ages.values())) == 1 and draw.random() < 0.5:
            age = next(iter(ages.values()))
            age += draw.choice([0, Fraction(1, 2)])
            start = self.add(None, Fraction(0), [], sorted(ages), {i: Fraction(0) for i in ages})
            return self.add(start, age, [], [], {i: age for i in ages})
        come = [self.process(group) for group in self.groups(range(self.leaves))]
        return self.add(None, Fraction(0), [], come, {i: Fraction(0) for i in come})

    def run(self, steps):
        state = self.begin()
        labels, told, where = [], [], [state]
        for _ in range(steps):
            duration = draw.choice([Fraction(0), Fraction(draw.randrange(1, 9), draw.randrange(1, 9))])
            state = self.follow(state, duration)
            if draw.random() < 0.15:
                state = self.again(state)
            labels.append({"kind": "time" if duration else "weak", "text": "", "words": "", "leaves": [],
                           **({"duration": duration} if duration else {})})
            told.append({"choice": None, "label": len(labels) - 1, "to": state, "rules": []})
            where.append(state)
        data = {"solids": [], "behaviours": [{"text": "nil", "origin": None, "open": []}],
                "leaves": [{"name": str(i), "template": "", "fixed": False, "absorbs": False, "mass": None, "parts": []}
                           for i in range(self.leaves)],
                "processes": self.processes, "states": self.states, "labels": labels}
        return data, {"start": where[0], "steps": told, "rest": Fraction(3, 2)}, where


def product(a, b):
    return [a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]]


def turn(q, v):
    """The vector turned by the quaternion, as the product q v q*, divided by the square of its length."""
    r = product(product(q, [Fraction(0), *v]), [q[0], -q[1], -q[2], -q[3]])
    return [x / sum(y * y for y in q) for x in r[1:]]


def expected(entry, place, age):
    """The position of a leaf's reference point and its orientation's columns, as the data's format says."""
    moved = [age * v for v in entry["velocity"]]
    q = [Fraction(x) for x in place.get("turned", [1, 0, 0, 0])]
    start = place["at"]
    if "turn" in entry:
        u = [s * (entry["turn"]["since"] + age) / 2 for s in entry["turn"]["spin"]]
        start = [a + b for a, b in zip(entry["turn"]["centre"], turn([Fraction(1), *u], place["arm"]))]
        q = product([Fraction(1), *u], q)
    axes = [turn(q, [Fraction(int(i == j)) for i in range(3)]) for j in range(3)]
    return [a + b for a, b in zip(start, moved)], [axes[j][i] for i in range(3) for j in range(3)]


def course_case():
    far = draw.choice([[Fraction(0)] * 3, [Fraction(10**6), Fraction(1), Fraction(-(10**6), 3)],
                       [Fraction(10**30), Fraction(-(10**30), 7), Fraction(0)]])
    page = Page(far)
    data, run, where = page.run(draw.randrange(0, 9))
    starts = [Fraction(0)]
    for step in run["steps"]:
        starts.append(starts[-1] + data["labels"][step["label"]].get("duration", Fraction(0)))
    questions, answers = [], []
    for _ in range(6):
        legs = draw.randrange(len(starts))
        until = starts[legs + 1] if legs + 1 < len(starts) else starts[-1] + run["rest"]
        grid = draw.choice([1, 2**20, 3, 10])
        age = (until - starts[legs]) * Fraction(draw.randrange(grid + 1), grid)
        time = starts[legs] + age
        named = draw.random() < 0.5
        if not named:
            legs = max(k for k in range(len(starts)) if starts[k] <= time)
            age = time - starts[legs]
        target = [a + b for a, b in zip(far, page.vector())]
        if draw.random() < 0.2:
            target = page.processes[0]["leaves"][0]["at"]
        if draw.random() < 0.1:
            target = [Fraction(0)] * 3
        questions.append({"legs": legs if named else None, "time": time, "target": target})
        answers.append((target, {i: a + age for i, a in page.truth[where[legs]].items()}))

    def check(found):
        for bodies, (target, ages) in zip(found, answers):
            assert [page.first(body[0]) for body in bodies] == sorted(map(page.first, ages))
            for index, age, places in bodies:
                entry = page.processes[index]
                assert Fraction(age) == ages[index] or ("turn" not in entry and not any(entry["velocity"]))
                for place, got in zip(entry["leaves"], places):
                    position, matrix = expected(entry, place, ages[index])
                    assert [Fraction(x) for x in got["position"]] == position
                    assert [Fraction(x) for x in got["matrix"]] == matrix
                    floats = [bits(nearest(a - b)) for a, b in zip(position, target)]
                    assert got["floats"] == floats, (got["floats"], floats)
                    assert got["turned"] == [bits(nearest(x)) for x in matrix]

    return ["course", data, run, questions], check


def star():
    """A polygon around the origin, seen from there as a whole, with even coordinates."""
    rays = {(1, 0): 9, (0, 1): 9, (-1, 0): 9, (0, -1): 9}
    for _ in range(draw.randrange(0, 30)):
        x, y = draw.randrange(-9, 10), draw.randrange(-9, 10)
        if (x, y) != (0, 0):
            by = math.gcd(x, y)
            rays[x // by, y // by] = draw.randrange(1, 12)
    return [(2 * x * far, 2 * y * far) for (x, y), far in
            sorted(rays.items(), key=lambda ray: math.atan2(ray[0][1], ray[0][0]))]


def spiral():
    """A corridor of width 2 that winds inwards."""
    turns, out, back, at, way = draw.randrange(2, 9), [], [], [0, 0], 0
    for k in range(turns, 0, -1):
        dx, dy = [(1, 0), (0, 1), (-1, 0), (0, -1)][way]
        out.append(tuple(at))
        # The wall of the corridor that is at its left.
        back.append((at[0] + 2 * (-dy + (dx if out[1:] else 0)), at[1] + 2 * (dx + (dy if out[1:] else 0))))
        at = [at[0] + 8 * k * dx, at[1] + 8 * k * dy]
        way = (way + 1) % 4
    dx, dy = [(1, 0), (0, 1), (-1, 0), (0, -1)][(way + 3) % 4]
    return [*out, tuple(at), (at[0] - 2 * dy, at[1] + 2 * dx), *back[::-1]]


def twice(*corners):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, corners[1:] + corners[:1]))


def polygon_case():
    corners = draw.choice([star, spiral])()
    full = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        full += [a] + [((a[0] + b[0]) // 2, (a[1] + b[1]) // 2)] * (draw.random() < 0.2)
    first = draw.randrange(len(full))
    full = full[first:] + full[:first]
    if draw.random() < 0.5:
        full.reverse()

    # All triangles have the sense of the polygon, and together its area: then they cover it once.
    def check(found):
        areas = [twice(*(full[i] for i in triangle)) for triangle in found]
        assert sum(areas) == twice(*full), (sum(areas), twice(*full))
        assert all((area > 0) == (twice(*full) > 0) for area in areas), areas

    return ["triangles", full], check


def crossing_case():
    """A polygon that crosses itself: there is an answer, of its corners."""
    full = [(draw.randrange(5), draw.randrange(5)) for _ in range(draw.randrange(0, 12))]

    def check(found):
        assert len(found) <= max(0, len(full) - 2) and all(0 <= i < len(full) for t in found for i in t), found

    return ["triangles", full], check


def camera_case():
    turn, height, distance = draw.uniform(-4, 4), draw.uniform(-1.5, 1.5), 10 ** draw.uniform(-5, 5)
    back = [math.cos(height) * math.sin(turn), math.sin(height), math.cos(height) * math.cos(turn)]
    parallel = draw.random() < 0.5
    near, far = (-9 * distance, 7 * distance) if parallel else (distance / 100, 7 * distance)
    x, y = draw.uniform(-1, 1), draw.uniform(-1, 1)
    lens = [parallel, draw.uniform(0.1, 1) * (distance if parallel else 1), draw.uniform(0.3, 3), near, far]

    def check(found):
        first, last, middle, up = found
        for got, told in [(first, (x, y, -1)), (last, (x, y, 1)), (middle[:2], (0, 0))]:
            assert all(abs(a - b) < 1e-6 for a, b in zip(got, told)), (got, told)
        if distance > 2:
            assert abs(up[0]) < 1e-6 and up[1] > 0, up

    return ["camera", back, distance, [0, 1, 0], lens, [x, y]], check


def equals(value):
    def check(found):
        assert found == value, (found, value)
    return check


def cases(count):
    python = {"add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b,
              "div": lambda a, b: a / b}
    for _ in range(count):
        a, b = rational(), rational()
        for op, of in python.items():
            if op != "div" or b != 0:
                value = of(a, b)
                short = str(value.numerator) if value.denominator == 1 else text(value)
                yield ["binary", op, text(a), text(b)], equals(short)
        b = draw.choice([b, a, a + Fraction(1, 10**30)])
        yield ["cmp", text(a), text(b)], equals((a > b) - (a < b))
        for x in (a, rational() * rational(), hard()):
            yield ["float", text(x)], equals(bits(nearest(x) if x else 0.0))
        finite = nearest(a)
        if abs(finite) != float("inf"):
            exact = Fraction(finite)
            yield ["back", text(a)], equals(str(exact))
    for _ in range(3 * count):
        x, digits = decimals_test.number(), draw.randrange(1, 13)
        shown = decimals.significant(x, digits)
        yield ["decimal", text(x), digits], equals([shown, decimals.is_it(x, shown)])
    for _ in range(count):
        yield course_case()
        yield polygon_case()
        yield crossing_case()
        yield camera_case()


def main():
    web = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    asked = list(cases(count))
    lines = "".join(json.dumps(question, default=text) + "\n" for question, _ in asked)
    node = subprocess.run(["node", str(Path(__file__).with_name("numbers.js")), web], input=lines,
                          stdout=subprocess.PIPE, text=True, check=True)
    answers = node.stdout.splitlines()
    assert len(answers) == len(asked), (len(answers), len(asked))
    for answer, (question, check) in zip(answers, asked):
        try:
            check(json.loads(answer))
        except AssertionError as wrong:
            print("wrong:", json.dumps(question, default=text)[:2000], answer[:2000], wrong)
            print("0 passed, 1 failed")
            sys.exit(1)
    print(f"{len(asked)} cases of the page's numbers, courses, triangles and cameras are as they must be")
    print("1 passed, 0 failed")


if __name__ == "__main__":
    main()
