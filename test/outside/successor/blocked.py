"""Walkers that do not bounce (rule Blocked)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any, Iterator, List, Set, Tuple

import contact
import steps
from states import Process, State
from vectors import ZERO, Vector, add, dot, scale, sub

Row = Tuple[List[Fraction], Fraction, bool]  # a.x <= b, or a.x < b if strict


class Blocked:
    """Rule Blocked, of the rules of a model."""

    model: Any

    def is_walker(self, process: Process) -> bool:
        """A steered process with a leaf whose law chooses, where walkers do not bounce."""
        if self.model.blocked == "bounce":
            return False
        return steps.is_steered(self, process) and self.draws(process)  # type: ignore[attr-defined]

    # Stop.

    def runs_into(self, p: Process, q: Process) -> bool:
        """Whether p would collide with q if q were at rest."""
        at_rest = replace(q, velocity=ZERO)
        return self.collision(p, at_rest) is not None  # type: ignore[attr-defined]

    def has_outcome(self, meeting: Any) -> bool:
        """Whether a collision has a candidate of Bind, or is with what absorbs."""
        p, q, pairs = meeting
        rules: Any = self
        absorbed = any(True for _ in rules.taken([meeting]))
        return absorbed or any(True for _ in rules.candidates(p, q, pairs))

    def to_stop(self, meeting: Any) -> Iterator[Process]:
        """The walkers of a collision without candidates that are to stop."""
        p, q, _ = meeting
        if self.has_outcome(meeting):
            return
        for one, other in ((p, q), (q, p)):
            if self.is_walker(one):
                if self.runs_into(one, other) or not self.runs_into(other, one):
                    yield one

    def stopped_walkers(self, state: State) -> State:
        """With the velocity 0 for all walkers that are to stop, until there are none."""
        rules: Any = self
        while self.model.blocked != "bounce":
            meetings = rules.collisions(state)
            bound = {id(p) for m in meetings if self.has_outcome(m) for p in m[:2]}
            stops = {id(p) for m in meetings for p in self.to_stop(m)} - bound
            if not stops:
                break
            state = self.at_rest(state, stops)
        return state

    def at_rest(self, state: State, stops: Set[int]) -> State:
        processes = [replace(p, velocity=ZERO) if id(p) in stops else p for p in state.processes]
        return replace(state, processes=tuple(processes))

    # Wait.

    def without_blocked_kicks(self, state: State, drawn: List[Any]) -> State:
        """Of a state with new velocities: with 0 for the walkers whose kicks are blocked. Walkers
        that have drawn now are known by their leaves."""
        if self.model.blocked != "wait":
            return state
        kicked = [p for p in state.processes if set(p.bodies) in drawn and self.is_walker(p)]
        here = {id(p) for p in kicked}
        stuck: Set[int] = set()
        for p, q in combinations(state.processes, 2):
            if here & {id(p), id(q)} and self.run_together(p, q):
                stuck |= here & {id(p), id(q)}
        while True:
            more = {
                id(p) for p in kicked for q in kicked
                if id(p) not in stuck and id(q) in stuck and self.sweeps_meet(p, q)
            }  # fmt: skip
            if not more:
                return self.at_rest(state, stuck)
            stuck |= more

    def run_together(self, p: Process, q: Process) -> bool:
        """Whether two first collide before the timestep is over, and have no candidate there."""
        rules: Any = self
        w = sub(q.velocity, p.velocity)
        first: List[Fraction] = []
        for _, part1, at1 in rules.parts(p):
            for _, part2, at2 in rules.parts(q):
                t = contact.first_time_of_contact(part1.solid, part2.solid, sub(at2, at1), w)
                first += [t] if t is not None and t < self.model.timestep else []
        if not first:
            return False
        p, q = rules.moved(p, min(first)), rules.moved(q, min(first))
        return not self.has_outcome((p, q, rules.collision(p, q)))

    def sweeps_meet(self, p: Process, q: Process) -> bool:
        """Whether the interiors of the sweeps of two walkers meet: those of two of their parts."""
        rules: Any = self
        paths = [scale(self.model.timestep, x.velocity) for x in (p, q)]
        return any(
            swept(part1.solid, part2.solid, sub(at2, at1), *paths)
            for _, part1, at1 in rules.parts(p)
            for _, part2, at2 in rules.parts(q)
        )


def swept(a: Any, b: Any, offset: Vector, path_a: Vector, path_b: Vector) -> bool:
    """Whether there are s and t in [0, 1] such that the interior of a, moved by s times its path,
    meets that of b, moved by t times its own: offset + t path_b - s path_a is inside the obstacle."""
    rows: List[Row] = [
        ([-dot(n, path_a), dot(n, path_b)], h - dot(n, offset), True) for n, h in contact.facets(a, b)
    ]
    for i in range(2):
        unit = [Fraction(i == k) for k in range(2)]
        rows += [(unit, Fraction(1), False), ([-x for x in unit], Fraction(0), False)]
    return solvable(rows)


def solvable(rows: List[Row]) -> bool:
    """Whether inequalities have a solution, by the elimination of one unknown after the other."""
    while rows and rows[0][0]:
        above = [row for row in rows if row[0][0] > 0]
        below = [row for row in rows if row[0][0] < 0]
        left = [(row[0][1:], row[1], row[2]) for row in rows if row[0][0] == 0]
        for a, b, strict in above:
            for c, d, also in below:
                sums = [x / a[0] - y / c[0] for x, y in zip(a[1:], c[1:])]
                left.append((sums, b / a[0] - d / c[0], strict or also))
        rows = left
    return all(0 < b or (b == 0 and not strict) for _, b, strict in rows)
