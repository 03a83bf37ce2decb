#!/usr/bin/env python3
"""Chance over starts against brute force in fractions, which shares no code with scc.

    starts.py SCC [--count N] [--seed S] [--points P]

A model has one or two cubes on a line, or one in a plane, between walls that throw back or take in. Each draws its
velocity at every step; weights may be 0, or depend on the place. `scc check --where --json` gives probabilities and
means as functions of the start. Here each run is followed from one start, by rules Until, Intervals, Event, Draw and
Expectation. Bounds of time are instants of events as often as not, and starts are on borders of pieces as often. The
last line is 'N passed, N failed'.
"""

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction as Q

SHAPES = "shape C = box(2,2,2)\n"


class Skip(Exception):
    """A case of which the text leaves open how it goes on, or that goes on for ever."""


# {1 Models}


def pick(rng, items):
    return items[rng.randrange(len(items))]


class Model:
    def __init__(self, rng):
        self.rng = rng
        self.kind = pick(rng, ["line", "line", "two", "plane"])
        self.step = pick(rng, [Q(1), Q(1), Q(1, 2)])
        self.absorb = {side: rng.random() < 0.2 for side in ("east", "west")}
        self.low, self.high = pick(rng, [(Q(-1), Q(3)), (Q(0), Q(3)), (Q(-2), Q(5, 2)), (Q(-3, 2), Q(4))])
        self.bottom, self.top = pick(rng, [(Q(-1), Q(2)), (Q(-2), Q(1))])
        self.bodies = ["w", "v"] if self.kind == "two" else ["w"]
        self.laws = {b: self.law() for b in self.bodies}
        if self.kind == "two":
            # The second cube is on the left of the first one, and walls are far enough for both.
            self.low -= 4
            self.ranges = {"s": (Q(0), Q(2)), "r": (Q(-4), Q(-2))}
        elif self.kind == "plane":
            self.ranges = {"s": (Q(0), Q(2)), "h": (Q(-1), Q(1))}
        else:
            self.ranges = {"s": pick(rng, [(Q(0), Q(2)), (Q(-1), Q(1)), (Q(1, 2), Q(5, 2))])}
        for name, (low, high) in self.ranges.items():
            if name in ("s", "r"):
                self.ranges[name] = (max(low, self.low), min(high, self.high))
            else:
                self.ranges[name] = (max(low, self.bottom), min(high, self.top))
        self.gone = any(self.absorb.values())
        # Steps that a collision ends.
        self.steady = self.kind != "line" or rng.random() < 0.7
        self.steps = 3 if self.kind == "two" or not self.steady else 4
        self.horizon = pick(rng, [k * self.step / 2 for k in range(1, 2 * (self.steps - 1) + 1)])
        self.check = self.question()

    def law(self):
        """Kicks: velocities, and weights, which may depend on the place (a threshold, below it, and else)."""
        rng, kicks = self.rng, []
        for _ in range(2 if self.kind == "two" or rng.random() < 0.5 else 3):
            vx = pick(rng, [Q(1), Q(-1), Q(2), Q(-2), Q(1, 2), Q(0), Q(-3, 2)])
            vy = pick(rng, [Q(0), Q(1), Q(-1)]) if self.kind == "plane" else Q(0)
            weight = pick(rng, [0, 1, 1, 2, 3])
            other = (pick(rng, [Q(0), Q(1), Q(3, 2)]), pick(rng, [0, 1, 2])) if rng.random() < 0.25 else None
            kicks.append(((vx, vy), weight, other))
        if all(weight == 0 or (other and other[1] == 0) for _, weight, other in kicks):
            kicks[0] = (kicks[0][0], 1, None)
        return kicks

    def draws(self, body, x):
        """Velocities with chances at a place."""
        chances = {}
        for v, weight, other in self.laws[body]:
            if other is not None and x < other[0]:
                weight = other[1]
            if weight:
                chances[v] = chances.get(v, 0) + weight
        total = sum(chances.values())
        if total == 0:
            raise Skip
        return [(v, Q(w, total)) for v, w in chances.items()]

    def atom(self):
        rng = self.rng
        if self.gone:
            return pick(rng, [("gone", "w"), ("event", "absorb", "w"), ("event", "bounce", "w"), ("not", ("gone", "w"))])
        place = pick(rng, [Q(0), Q(1), Q(2), Q(1, 2), self.high, self.low + (2 if self.kind == "two" else 0)])
        relation = pick(rng, ["<", "<=", ">", ">=", "="])
        atoms = [("x", "w", relation, place)] * 3 + [("event", "bounce", "w"), ("vx", "w", pick(rng, ["<", ">"]), Q(0))]
        if self.kind == "plane":
            atoms += [("y", "w", relation, pick(rng, [Q(0), Q(1), self.top]))]
        if self.kind == "two":
            atoms += [("event2", "bounce"), ("event", "bounce", "v"), ("x", "v", relation, place - 2)]
        atom = pick(rng, atoms)
        return ("not", atom) if rng.random() < 0.25 else atom

    def question(self):
        rng, b = self.rng, self.horizon
        side = pick(rng, ["", "", "min", "max"])
        kind = pick(rng, ["F", "F", "U", "U", "G", "at", "time", "count"])
        if kind == "at" and (self.gone or self.kind == "two"):
            kind = "F"
        if kind == "count" and not (self.kind == "line" and self.steady):
            kind = "time"
        a = pick(rng, [Q(0), Q(0), b, b / 2, self.step if self.step <= b else Q(0)])
        if kind == "G":
            a = Q(0)
        f = ("true",) if kind != "U" else self.atom()
        return {"kind": kind, "side": side, "a": a, "b": b, "f": f, "g": self.atom()}

    # Texts.

    def text(self):
        lines = ["model m", f"timestep {self.step}{' steady' if self.steady else ''}"]
        for name, (low, high) in self.ranges.items():
            lines.append(f"param {name} in [{low}, {high}]")
        lines.append(SHAPES)
        height = "h" if self.kind == "plane" else "0"
        lines.append(f"process w = C mass 1 at translate (s, {height}, 0) [nil]")
        if self.kind == "two":
            lines.append("process v = C mass 1 at translate (r, 0, 0) [nil]")
        absorb = {side: " absorb" if self.absorb[side] else "" for side in self.absorb}
        # Walls on two sides are in the lower half of space, and those on the other sides in the upper one.
        lines.append(f"fixed east = box(2,40,40){absorb['east']} at translate ({self.high + 2}, 0, -20)")
        lines.append(f"fixed west = box(2,40,40){absorb['west']} at translate ({self.low - 2}, 0, -20)")
        if self.kind == "plane":
            lines.append(f"fixed north = box(40,2,40) at translate (0, {self.top + 2}, 20)")
            lines.append(f"fixed south = box(40,2,40) at translate (0, {self.bottom - 2}, 20)")
        for body in self.bodies:
            kicks = []
            for (vx, vy), weight, other in self.laws[body]:
                told = weight if other is None else f"(if x < {other[0]} then {other[1]} else {weight})"
                kicks.append(f"({vx}, {vy}, 0) weight {told}")
            lines.append(f"motion {body} = choose {{ {', '.join(kicks)} }}")
        lines.append(f"check c : {self.words()}")
        return "\n".join(lines) + "\n"

    def atom_words(self, atom):
        if atom[0] == "not":
            return f"(not {self.atom_words(atom[1])})"
        if atom[0] in ("x", "y", "vx"):
            return f"{atom[0]}({atom[1]}) {atom[2]} {atom[3]}"
        if atom[0] == "event":
            return f"event {atom[1]}({atom[2]})"
        if atom[0] == "event2":
            return f"event {atom[1]}(v, w)"
        return {"gone": "gone(w)", "true": "true"}[atom[0]]

    def words(self):
        c = self.check
        f, g, a, b, side = self.atom_words(c["f"]), self.atom_words(c["g"]), c["a"], c["b"], c["side"]
        if c["kind"] == "at":
            return f"E{side} = ? [ x(w) at {b} ]"
        if c["kind"] == "time":
            return f"E{side} = ? [ time U ({g} or time >= {b}) ]"
        if c["kind"] == "count":
            return f"E{side} = ? [ event bounce U ({g} or time >= {b}) ]"
        if c["kind"] == "G":
            return f"P{side} = ? [ always not ({g}) within {b} ]"
        return f"P{side} = ? [ {f} U[{a}, {b}] {g} ]"


# {1 Brute force}

LESS = {"<": lambda x, y: x < y, "<=": lambda x, y: x <= y, ">": lambda x, y: x > y, ">=": lambda x, y: x >= y,
        "=": lambda x, y: x == y}


class Runs:
    """All runs from one start, with the best way to go on where several collisions are at one instant."""

    def __init__(self, model, start, best, rest):
        """What happens after many draws of one instant counts as [rest]: least or greatest."""
        self.m, self.best, self.rest = model, best, rest
        self.c = model.check
        if model.kind == "plane":
            bodies = {"w": (start["s"], start["h"], Q(0), Q(0))}
        else:
            bodies = {"w": (start["s"], Q(0), Q(0), Q(0))}
        if model.kind == "two":
            bodies["v"] = (start["r"], Q(0), Q(0), Q(0))
        self.start = bodies
        self.horizon = model.check["b"]
        self.of_time = model.check["kind"] in ("at", "time", "count")

    def value(self):
        return self.instant(self.start, Q(0), None, True, Q(0), True, 0, Q(0))

    # What holds at a position, after an event, or inside a trajectory at an offset.

    def atom(self, atom, bodies, event):
        kind = atom[0]
        if kind == "true":
            return True
        if kind == "not":
            return not self.atom(atom[1], bodies, event)
        if kind == "event":
            return event is not None and event[0] == atom[1] and atom[2] in event[1]
        if kind == "event2":
            return event is not None and event[0] == atom[1] and set(event[1]) == {"v", "w"}
        if kind == "gone":
            return "w" not in bodies
        index = {"x": 0, "y": 1, "vx": 2}[kind]
        return LESS[atom[2]](bodies[atom[1]][index], atom[3])

    def roots(self, atom, bodies, lasts):
        if atom[0] == "not":
            return self.roots(atom[1], bodies, lasts)
        if atom[0] in ("x", "y"):
            i = {"x": 0, "y": 1}[atom[0]]
            b = bodies[atom[1]]
            if b[i + 2] != 0:
                t = (atom[3] - b[i]) / b[i + 2]
                if 0 < t < lasts:
                    return {t}
        return set()

    @staticmethod
    def moved(bodies, t):
        return {n: (x + vx * t, y + vy * t, vx, vy) for n, (x, y, vx, vy) in bodies.items()}

    # Collisions that are due at this instant: (event, names, bodies after).

    def collisions(self, bodies):
        m, found, busy = self.m, [], []
        for n, (x, y, vx, vy) in bodies.items():
            hits = []
            for side, at, out in (("east", m.high, 1), ("west", m.low, -1)):
                if x == at and vx * out > 0:
                    hits.append((side, (x, y, -vx, vy)))
            if m.kind == "plane":
                for at, out in ((m.top, 1), (m.bottom, -1)):
                    if y == at and vy * out > 0:
                        hits.append(("side", (x, y, vx, -vy)))
            if len(hits) > 1 and any(m.absorb.get(side) for side, _ in hits):
                raise Skip
            if len(hits) > 1:
                # A corner: whichever wall comes first, the other one follows, or both come at once.
                found.append(("bounce", (n,), {**bodies, n: (x, y, -vx, -vy)}))
                busy.append({n})
                continue
            for side, after in hits:
                if m.absorb.get(side):
                    found.append(("absorb", (n,), {k: b for k, b in bodies.items() if k != n}))
                else:
                    found.append(("bounce", (n,), {**bodies, n: after}))
                busy.append({n})
        if len(bodies) == 2:
            w, v = bodies["w"], bodies["v"]
            if w[0] - v[0] == 2:
                if v[2] > w[2]:
                    swapped = {"w": (w[0], w[1], v[2], w[3]), "v": (v[0], v[1], w[2], v[3])}
                    found.append(("bounce", ("w", "v"), swapped))
                    busy.append({"w", "v"})
                if any(b in ({"w"}, {"v"}) for b in busy):
                    raise Skip  # three bodies in a row
        return found

    def delay(self, bodies, time, ends):
        m = self.m
        delays = [ends - time]
        for x, y, vx, vy in bodies.values():
            if vx > 0:
                delays.append((m.high - x) / vx)
            if vx < 0:
                delays.append((m.low - x) / vx)
            if m.kind == "plane" and vy > 0:
                delays.append((m.top - y) / vy)
            if m.kind == "plane" and vy < 0:
                delays.append((m.bottom - y) / vy)
        if len(bodies) == 2 and bodies["v"][2] > bodies["w"][2]:
            delays.append((bodies["w"][0] - bodies["v"][0] - 2) / (bodies["v"][2] - bodies["w"][2]))
        return min(delays)

    # Values. A position is looked at when it is entered: what counts so far is the truth of f before, or a count.

    def after_many(self, time):
        c = self.c
        if c["kind"] == "at":
            return self.m.low if self.rest == "least" else self.m.high
        if c["kind"] == "time":
            return time if self.rest == "least" else max(time, c["b"])
        return Q(0) if self.rest == "least" else Q(1)

    def instant(self, bodies, time, event, before, count, due, depth, ends):
        """From a state, at an instant of which draws are due or not, or have been made (None): that is once in an
        instant. [ends] is when the step ends."""
        if depth > 24 and not self.m.steady:
            return self.after_many(time)
        if depth > 60:
            raise Skip
        c = self.c
        if self.of_time:
            if c["kind"] != "at" and (time >= c["b"] or self.atom(c["g"], bodies, event)):
                return time if c["kind"] == "time" else count
        else:
            if before and c["a"] <= time <= c["b"] and self.atom(c["g"], bodies, event):
                return Q(1)
            before = before and self.atom(c["f"], bodies, event)
            if not before or time > c["b"]:
                return Q(0)
        hits = self.collisions(bodies)
        if hits:
            values = [
                self.instant(after, time, (kind, names), before, count + (kind == "bounce"),
                             due if due is None else due or not self.m.steady, depth + 1, ends)
                for kind, names, after in hits
            ]
            return self.best(values)
        if due and bodies:
            return self.drawn(bodies, time, sorted(bodies, key=lambda n: bodies[n][:2]), {}, before, count, depth)
        return self.flow(bodies, time, before, count, ends)

    def drawn(self, bodies, time, waiting, given, before, count, depth):
        """The positions between draws of one instant are like the one before, but after no event."""
        first, *rest = waiting
        total = Q(0)
        for v, chance in self.m.draws(first, bodies[first][0]):
            now = {**given, first: v}
            if rest:
                ok = before
                if not self.of_time:
                    if before and self.c["a"] <= time <= self.c["b"] and self.atom(self.c["g"], bodies, None):
                        total += chance
                        continue
                    ok = before and self.atom(self.c["f"], bodies, None)
                    if not ok:
                        continue
                elif self.c["kind"] != "at" and self.atom(self.c["g"], bodies, None):
                    total += chance * (time if self.c["kind"] == "time" else count)
                    continue
                total += chance * self.drawn(bodies, time, rest, now, ok, count, depth)
            else:
                after = {n: (bodies[n][0], bodies[n][1], *now[n]) for n in bodies}
                total += chance * self.instant(after, time, None, before, count, None, depth + 1, time + self.m.step)
        return total

    def flow(self, bodies, time, before, count, ends):
        c = self.c
        if c["kind"] == "at" and time == c["b"]:
            return bodies["w"][0]
        if time >= self.horizon and not self.of_time:
            return Q(0)
        lasts = self.delay(bodies, time, ends) if bodies else self.horizon - time + 1
        if c["kind"] == "at" and time + lasts > c["b"]:
            return self.moved(bodies, c["b"] - time)["w"][0]
        cuts = set()
        if c["kind"] != "at":
            cuts = self.roots(c["g"], bodies, lasts) | self.roots(c["f"], bodies, lasts)
        for t in (c["a"] - time, c["b"] - time):
            if 0 < t < lasts:
                cuts.add(t)
        cuts = sorted(cuts) + [lasts]
        low = Q(0)
        for high in cuts:
            # the open piece, and then the point at its end, unless that is the state that follows
            middle, there = self.moved(bodies, (low + high) / 2), self.moved(bodies, high)
            if self.of_time:
                if c["kind"] != "at":
                    if self.atom(c["g"], middle, None):
                        return time + low if c["kind"] == "time" else count
                    if high < lasts and (time + high >= c["b"] or self.atom(c["g"], there, None)):
                        return time + high if c["kind"] == "time" else count
            else:
                f, g = self.atom(c["f"], middle, None), self.atom(c["g"], middle, None)
                inside = max(time + low, c["a"]) < time + high and time + low < min(time + high, c["b"])
                if before and f and g and inside:
                    return Q(1)
                before = before and f
                if high < lasts:
                    if before and c["a"] <= time + high <= c["b"] and self.atom(c["g"], there, None):
                        return Q(1)
                    before = before and self.atom(c["f"], there, None)
                if not before:
                    return Q(0)
            low = high
        now = time + lasts
        if not bodies:
            return Q(0) if not self.of_time else c["b"] if c["kind"] == "time" else count
        return self.instant(self.moved(bodies, lasts), now, None, before, count, now == ends, 0, ends)


# {1 What scc says}


def fraction(text):
    return Q(text) if text is not None else None


def holds(row, point):
    left = sum((Q(a) * point[n] for n, a in row["coefficients"].items()), Q(0))
    return LESS[row["relation"]](left, Q(row["bound"]))


def ends(part, point):
    def form(name):
        if name + "_form" in part:
            f = part[name + "_form"]
            return sum((Q(a) * point[n] for n, a in f["coefficients"].items()), Q(f["constant"]))
        return fraction(part[name])

    return form("low"), form("high")


def is_unknown(side, point):
    """Whether nothing is known of a mean at a point."""
    return any(all(holds(row, point) for row in piece) for piece in side.get("unknown", {"pieces": []})["pieces"])


def at(side, point):
    found = [p for p in side["parts"] if any(all(holds(r, point) for r in piece) for piece in p["pieces"])]
    assert len(found) == 1, f"{len(found)} parts have the start {point}"
    return ends(found[0], point)


def borders(side):
    """Values of single parameters at which a piece ends."""
    for part in side["parts"]:
        for piece in part["pieces"]:
            for row in piece:
                if len(row["coefficients"]) == 1:
                    (name, a), = row["coefficients"].items()
                    if Q(a) != 0:
                        yield name, Q(row["bound"]) / Q(a)


def points(rng, model, side, count):
    known = {}
    for name, x in borders(side):
        known.setdefault(name, set()).add(x)
    for _ in range(count):
        point = {}
        for name, (low, high) in model.ranges.items():
            exact = sorted(x for x in known.get(name, ()) if low <= x <= high)
            if exact and rng.random() < 0.4:
                point[name] = pick(rng, exact)
            elif rng.random() < 0.5:
                parts = pick(rng, [2, 4, 6, 8])
                point[name] = low + (high - low) * Q(rng.randrange(parts + 1), parts)
            else:
                point[name] = low + (high - low) * Q(rng.randrange(1, 97), 97)
        if "r" not in point or point["s"] - point["r"] >= 2:
            yield point


class Counts:
    def __init__(self):
        self.passed = self.failed = self.skipped = self.exact = self.refused = 0
        self.kinds = {}


def sides(model):
    return {"": ["least", "greatest"], "min": ["least"], "max": ["greatest"]}[model.check["side"]]


def try_model(scc, number, seed, count, counts, folder):
    rng = random.Random(f"{seed}/{number}")
    model = Model(rng)
    path = os.path.join(folder, "m.sc")
    with open(path, "w", encoding="utf-8") as file:
        file.write(model.text())
    words = [scc, "check", path, "--where", "--json", "--states", "3000", "--depth", "80"]
    done = subprocess.run(words, capture_output=True, encoding="utf-8", check=False)
    try:
        report = json.loads(done.stdout)
        found = report["properties"][0].get("starts")
    except (ValueError, KeyError, IndexError):
        found = None
    if not found:
        if os.environ.get("SHOW"):
            print(done.stdout[-600:], done.stderr[-600:], model.text())
        counts.refused += 1
        return
    by_side = {side["over"]: side for side in found}
    for point in points(rng, model, found[0], count):
        for side in sides(model):
            best = min if side == "least" else max
            if model.check["kind"] == "G":
                best = max if side == "least" else min
            try:
                least, most = (Runs(model, point, best, rest).value() for rest in ("least", "greatest"))
            except Skip:
                counts.skipped += 1
                continue
            if model.check["kind"] == "G":
                least, most = 1 - most, 1 - least
            if is_unknown(by_side[side], point):
                counts.skipped += 1
                continue
            low, high = at(by_side[side], point)
            if low == high:
                counts.exact += 1
            kind = f"{model.kind}{'' if model.steady else ' redrawn'} {model.check['kind']}"
            counts.kinds[kind] = counts.kinds.get(kind, 0) + 1
            if (low is not None and low <= most) and (high is None or least <= high):
                counts.passed += 1
            else:
                counts.failed += 1
                where = ", ".join(f"{n} = {x}" for n, x in point.items())
                print(f"model {number} of seed {seed}, at {where}, {side}: {least} to {most}, scc: {low} to {high}")
                print(model.text(), flush=True)
                return


def main():
    parser = argparse.ArgumentParser(description="chance over starts against brute force")
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--points", type=int, default=16)
    options = parser.parse_args()
    counts = Counts()
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.count):
            try_model(options.scc, number, options.seed, options.points, counts, folder)
    print(f"{options.count} models ({counts.refused} without values), {counts.exact} exact, {counts.skipped} starts skipped")
    for kind in sorted(counts.kinds):
        print(f"  {counts.kinds[kind]:6} {kind}")
    print(f"{counts.passed} passed, {counts.failed} failed")
    return 0 if counts.failed == 0 and counts.passed > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
