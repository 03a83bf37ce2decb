"""The successors of a state of a rigid model (chapter 4 of the rule book)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any, Dict, Iterator, List, Optional, Tuple

import cast
import contact
import impact
import near
import terms
from model import Model, Part, rotation
from motion import Flight, Quaternion, inverse, product, whole
from solids import Solid
from states import Body, Bond, Process, State, Step
from straight import Rules
from vectors import (
    ZERO,
    Matrix,
    Vector,
    add,
    apply,
    cross,
    dot,
    multiply,
    scale,
    solve,
    sub,
    transpose,
)  # fmt: skip

STILL: Quaternion = (1, 0, 0, 0)


class Meeting:
    """Two parts of two processes in contact."""

    def __init__(
        self, first: Tuple[str, Part], second: Tuple[str, Part],
        found: near.Contact, one: Solid, two: Solid,
    ) -> None:  # fmt: skip
        self.leaf1, self.part1 = first
        self.leaf2, self.part2 = second
        self.contact, self.solids = found, (one, two)


class Turning(Rules):
    def __init__(self, model: Model) -> None:
        super().__init__(model)
        self.free = model.settings.get("dynamics") == "free_body"
        self.resolution = Fraction(model.settings.get("resolution") or default_resolution(model))
        self._inertias: Dict[str, Matrix] = {}

    # Masses.

    def inertia_of_leaf(self, name: str) -> Matrix:
        """About the leaf's centroid, as the leaf was declared."""
        if name not in self._inertias:
            leaf = self.leaf(name)
            total = NOTHING
            for part in leaf.parts:
                total = plus(total, second_moment(part.solid, part.mass, leaf.centroid))
            self._inertias[name] = from_moment(total)
        return self._inertias[name]

    def centroid(self, name: str, body: Body) -> Vector:
        turn = rotation([Fraction(q) for q in body.turned or STILL])
        return add(body.position, apply(turn, self.leaf(name).centroid))

    def centre(self, process: Process) -> Vector:
        """The centre of mass; of a process with something fixed, which never turns, any point."""
        if self.is_fixed(process):
            return next(iter(process.bodies.values())).position
        total = ZERO
        for name, body in process.bodies.items():
            total = add(total, scale(self.leaf(name).mass, self.centroid(name, body)))
        return scale(1 / self.mass(process), total)

    def inertia(self, process: Process) -> Matrix:
        """About the centre of mass (rule Mass, parallel axes)."""
        centre, total = self.centre(process), NOTHING
        for name, body in process.bodies.items():
            turn = rotation([Fraction(q) for q in body.turned or STILL])
            own = multiply(multiply(turn, self.inertia_of_leaf(name)), transpose(turn))
            r = sub(self.centroid(name, body), centre)
            total = plus(total, plus(own, point_inertia(self.leaf(name).mass, r)))
        return total

    def rigid(self, process: Process) -> impact.Rigid:
        """A process in a collision: with the spin of its angular momentum if bodies are free."""
        centre = self.centre(process)
        if self.is_fixed(process):
            return impact.Rigid(None, centre, None, ZERO, ZERO)
        return impact.Rigid(
            self.mass(process), centre, self.inertia(process), process.velocity,
            self.spin_now(process),
        )  # fmt: skip

    def spin_now(self, process: Process) -> Vector:
        if not self.free or self.is_fixed(process):
            return process.spin
        found = solve(self.inertia(process), process.momentum or ZERO)
        assert found is not None
        return tuple(found)  # type: ignore[return-value]

    # Turns.

    def flight(self, process: Process) -> Flight:
        return Flight(self.centre(process), process.velocity, process.spin, process.since)

    def movers(self, process: Process) -> List[Tuple[str, Part, cast.Mover]]:
        """All parts in flight: with their vertices as they were when the turn began."""
        flight = self.flight(process)
        turn, centre = flight.at(Fraction(0))
        back = transpose(turn)
        found = []
        for name, body in process.bodies.items():
            own = rotation([Fraction(q) for q in body.turned or STILL])
            linear = multiply(back, own)
            offset = apply(back, sub(body.position, centre))
            for part in self.leaf(name).parts:
                found.append((name, part, cast.Mover(part.solid.mapped(linear, offset), flight)))
        return found

    def world(self, body: Body, part: Part) -> Solid:
        turn = rotation([Fraction(q) for q in body.turned or STILL])
        return part.solid.mapped(turn, body.position)

    def moved(self, process: Process, d: Fraction) -> Process:
        """Where a process is after the time d of its turn."""
        half = scale(Fraction(1, 2), process.spin)
        before = (Fraction(1), *scale(process.since, half))
        after = (Fraction(1), *scale(process.since + d, half))
        step = product(after, inverse(before))
        turn = rotation([Fraction(x) for x in step])
        centre = self.centre(process)
        there = add(centre, scale(d, process.velocity))
        bodies = {}
        for name, body in process.bodies.items():
            bodies[name] = replace(
                body,
                position=add(there, apply(turn, sub(body.position, centre))),
                turned=whole(product(step, body.turned or STILL)),
            )
        since = process.since + d if process.spin != ZERO else Fraction(0)
        return replace(process, bodies=bodies, since=since)

    def left(self, process: Process) -> Optional[Fraction]:
        """Of the turn of what spins."""
        if process.lasts is None or process.spin == ZERO:
            return None
        return process.lasts - process.since

    def due(self, process: Process) -> Process:
        """A turn is due: with the spin that collisions see."""
        return replace(process, since=Fraction(0), lasts=None, spin=self.spin_now(process))

    def length(self, spin: Vector) -> Fraction:
        """Of a turn (reading I-20)."""
        d = self.model.timestep
        while dot(spin, spin) * d * d > Fraction(1, 4):
            d /= 2
        return d if spin != ZERO else Fraction(0)

    def plain(self, process: Process) -> Process:
        return replace(process, lasts=self.length(process.spin))

    def midway(self, process: Process) -> Process:
        """With the spin half-way through a turn, from the angular momentum, and that turn."""
        if not self.free or process.spin == ZERO:
            return self.plain(process)
        d, start = self.length(process.spin), estimate(process.spin)
        while True:
            turn = Flight(ZERO, ZERO, start, Fraction(0)).at(d / 2)[0]
            back = apply(transpose(turn), process.momentum or ZERO)
            found = solve(self.inertia(process), back)
            assert found is not None
            spin = estimate(apply(turn, tuple(found)))  # type: ignore[arg-type]
            if dot(spin, spin) * d * d <= Fraction(1, 4):
                return replace(process, spin=spin, lasts=d)
            d /= 2

    # Casts.

    def casts(
        self, p: Process, q: Process
    ) -> Iterator[Tuple[Tuple[str, Part], Tuple[str, Part], cast.Casting, int, Fraction]]:
        if self.is_fixed(p) and self.is_fixed(q):
            return
        for name1, part1, mover1 in self.movers(p):
            for name2, part2, mover2 in self.movers(q):
                grid = cast.grid(mover1, mover2, self.resolution)
                casting = cast.Casting(mover1, mover2)
                yield (name1, part1), (name2, part2), casting, grid, self.shift(p, q)

    def shift(self, p: Process, q: Process) -> Fraction:
        """How long ago the grid of instants began: with the last of their turns."""
        return min(x.since for x in (p, q) if x.spin != ZERO)

    def exactly(self, p: Process, q: Process) -> Optional[Fraction]:
        """Where neither spins: the instant itself (rule Ftoc)."""
        w, found = sub(q.velocity, p.velocity), []
        if w == ZERO:
            return None
        for name1, part1, _ in self.parts(p):
            for name2, part2, _ in self.parts(q):
                one = self.world(p.bodies[name1], part1)
                two = self.world(q.bodies[name2], part2)
                t = contact.first_time_of_contact(one, two, ZERO, w)
                if t is not None:
                    found.append(t)
        return min(found) if found else None

    def far(self, p: Process, q: Process, span: Fraction) -> bool:
        """Whether two processes are too far apart to meet within a span: their balls do not."""
        reach = Fraction(0)
        for process in (p, q):
            centre = self.centre(process)
            most = max(
                dot(sub(x, centre), sub(x, centre))
                for name, part, at in self.parts(process)
                for x in self.world(process.bodies[name], part).place.values()
            )
            reach += cast.root(most)
            reach += cast.root(dot(process.velocity, process.velocity)) * span
        d = sub(self.centre(q), self.centre(p))
        return dot(d, d) > reach * reach

    def to_collision_of(self, p: Process, q: Process, most: Optional[Fraction]) -> Any:
        """The time until two processes collide, if it is at most ``most``."""
        if p.spin == ZERO and q.spin == ZERO:
            t = self.exactly(p, q)
            return t if t is None or most is None or t <= most else None
        assert most is not None
        if self.far(p, q, most + 1):
            return None
        found = []
        for _, _, casting, grid, shift in self.casts(p, q):
            cell = Fraction(1, 2**grid)
            after = ((most + shift) // cell + 1) * cell - shift
            t = casting.first(after, grid, shift)
            if t is not None:
                found.append(t)
        return min(found) if found else None

    def delay(self, state: State) -> Optional[Fraction]:
        """Rule Time; what is known to be at rest is accepted as it is told."""
        events = []
        for process in state.processes:
            for event in (self.horizon(process), self.left(process)):
                if event is not None:
                    events.append(event)
            if process.clock is not None:
                events.append(self.model.split_step - process.clock)
        if state.step is not None and self.goes_on(state):
            events.append(state.step.remaining)
        most = min(events) if events else None
        for p, q in combinations(state.processes, 2):
            t = self.to_collision_of(p, q, most)
            if t is not None:
                events.append(t)
        if state.step is not None and events:
            events.append(state.step.remaining)
        return min(events) if events else None

    def collisions(self, state: State) -> List[Tuple[Process, Process, List[Any]]]:
        """Processes that collide now: t- is 0 for some parts of theirs (rule Cast)."""
        found = []
        for p, q in combinations(state.processes, 2):
            if self.to_collision_of(p, q, Fraction(0)) == 0:
                found.append((p, q, self.meetings(p, q)))
        return found

    def meetings(self, p: Process, q: Process) -> List[Meeting]:
        found = []
        for name1, body1 in p.bodies.items():
            for part1 in self.leaf(name1).parts:
                one = self.world(body1, part1)
                for name2, body2 in q.bodies.items():
                    for part2 in self.leaf(name2).parts:
                        two = self.world(body2, part2)
                        seen = near.find(one, two, self.resolution)
                        if seen is not None:
                            found.append(Meeting((name1, part1), (name2, part2), seen, one, two))
        return found

    # What the rules of chapter 3 ask for.

    def touching_features(self, pair: Meeting) -> Any:
        return pair.contact.pairs

    def bind(self, p: Process, q: Process, bond: Bond, new: Dict[str, Body]) -> Process:
        bodies = {**p.bodies, **q.bodies, **new}
        joined = Process(ZERO, None, bodies, p.bonds | q.bonds | {bond}, lasts=None)
        if self.is_fixed(joined):
            momentum = ZERO if self.free else None
            return self.begun(replace(joined, momentum=momentum))
        m1, m2 = self.mass(p), self.mass(q)
        velocity = scale(1 / (m1 + m2), add(scale(m1, p.velocity), scale(m2, q.velocity)))
        centre, angular = self.centre(joined), ZERO
        for body in (self.rigid(p), self.rigid(q)):
            assert body.mass is not None and body.inertia is not None
            own = apply(body.inertia, body.spin)
            arm = sub(body.centre, centre)
            angular = add(angular, add(own, cross(arm, scale(body.mass, body.velocity))))
        spin = solve(self.inertia(joined), angular)
        joined = replace(joined, velocity=velocity, spin=tuple(spin))  # type: ignore[arg-type]
        return self.begun(replace(joined, momentum=angular if self.free else None))

    def bounce(
        self, p: Process, q: Process, pairs: List[Meeting]
    ) -> Optional[Tuple[Process, Process]]:
        after = impact.bounce(
            [m.contact for m in pairs], [m.solids for m in pairs], self.rigid(p), self.rigid(q)
        )
        if after is None:
            return None
        return self.begun(self.pushed(p, after[0])), self.begun(self.pushed(q, after[1]))

    def pushed(self, process: Process, after: impact.Rigid) -> Process:
        if after.mass is None:
            return replace(process, lasts=None)
        momentum = apply(after.inertia, after.spin) if self.free else None  # type: ignore
        return replace(
            process, velocity=after.velocity, spin=after.spin, momentum=momentum,
            since=Fraction(0), lasts=None,
        )  # fmt: skip

    def piece(self, process: Process, piece: Process) -> Process:
        """Reading I-23: the rigid motion of the whole."""
        if self.is_fixed(process):
            momentum = ZERO if self.free else None
            return replace(piece, velocity=ZERO, spin=ZERO, momentum=momentum, lasts=None)
        spin = self.spin_now(process)
        arm = sub(self.centre(piece), self.centre(process))
        velocity = add(process.velocity, cross(spin, arm))
        momentum = apply(self.inertia(piece), spin) if self.free else None
        return replace(piece, velocity=velocity, spin=spin, momentum=momentum, lasts=None)

    # Turns that end and begin, and steps.

    def colliding(self, state: State) -> List[Process]:
        return [p for pair in self.collisions(state) for p in pair[:2]]

    def at_contact(self, state: State) -> State:
        """The turns of what collides end; again, until none does whose turn goes on."""
        while True:
            hit = self.colliding(state)
            old = [
                p for p in state.processes
                if p.lasts is not None and p.spin != ZERO and (self.free or p.since > 0)
                and any(p is h for h in hit)
            ]  # fmt: skip
            if not old:
                return state
            state = state.having(old, [self.due(p) for p in old])

    def turns_begin(self, state: State) -> State:
        hit = self.colliding(state)
        old = [p for p in state.processes if p.lasts is None and not any(p is h for h in hit)]
        chosen = {id(p): self.midway(p) for p in old}
        while True:
            after = state.having(old, list(chosen.values()))
            new = self.colliding(after)
            waiting = [
                p for p in old
                if chosen[id(p)].spin != p.spin and any(chosen[id(p)] is h for h in new)
            ]  # fmt: skip
            if not waiting:
                return after
            for p in waiting:
                chosen[id(p)] = self.plain(p)

    def settled(self, state: State, kind: str) -> State:
        over = [p for p in state.processes if self.left(p) == 0]
        state = self.at_contact(state.having(over, [self.due(p) for p in over]))
        step = state.step
        if step is not None:
            if step.phase == "moving" and (step.remaining == 0 or kind in ("bind", "bounce")):
                step = replace(step, phase="due")
            if step.phase == "due" and not self.collisions(state):
                dt = self.model.timestep - step.remaining
                law = [p for p in state.processes if self.has_law(p)]
                new = [self.steered(self.due(p), state.time, dt) for p in law]
                state = state.having(law, new)
                step = replace(step, remaining=self.model.timestep, phase="steered")
            state = replace(state, step=step)
        return self.turns_begin(self.at_contact(state))

    def has_law(self, process: Process) -> bool:
        laws = any(self.leaf(name).law is not None for name in process.bodies)
        return laws and not self.is_fixed(process)

    def seen(self, process: Process, name: str) -> Tuple[Vector, Vector]:
        x = self.centroid(name, process.bodies[name])
        r = sub(x, self.centre(process))
        return x, add(process.velocity, cross(self.spin_now(process), r))

    def initial(self) -> State:
        bodies, motions = {}, {}
        for name, leaf in self.model.initial_leaves.items():
            term = leaf["term"]
            bodies[name] = Body(leaf["position"], term, terms.origin_of(term), STILL)
            motions[name] = leaf["velocity"], leaf["spin"]
        declared = Process(ZERO, None, bodies, frozenset(self.model.initial_bonds))
        processes = []
        for piece in self.pieces(declared):
            velocity, spin, momentum = ZERO, ZERO, ZERO
            if not self.is_fixed(piece):
                for name in piece.bodies:
                    velocity = add(velocity, scale(self.leaf(name).mass, motions[name][0]))
                velocity = scale(1 / self.mass(piece), velocity)
                spin = motions[next(iter(piece.bodies))][1]
                momentum = apply(self.inertia(piece), spin)
            piece = replace(
                piece, velocity=velocity, spin=spin, lasts=None,
                momentum=momentum if self.free else None,
            )  # fmt: skip
            processes.append(self.begun(piece))
        step = Step(self.model.timestep, "due") if self.model.steered else None
        return self.settled(State(tuple(processes), step), "initial")


# Tensors.

NOTHING: Matrix = (ZERO, ZERO, ZERO)


def plus(m: Matrix, n: Matrix) -> Matrix:
    return tuple(add(a, b) for a, b in zip(m, n))  # type: ignore[return-value]


def product_of(a: Vector, b: Vector) -> Matrix:
    return tuple(scale(x, b) for x in a)  # type: ignore[return-value]


def second_moment(solid: Solid, mass: Any, about: Vector) -> Matrix:
    """The integral of x x^T over a uniform solid of this mass, x from a point."""
    total, volume = NOTHING, Fraction(0)
    for _, corners in solid.faces:
        a = sub(solid.place[corners[0]], about)
        for u, w in zip(corners[1:], corners[2:]):
            b, c = sub(solid.place[u], about), sub(solid.place[w], about)
            six = dot(a, cross(b, c))
            volume += Fraction(six) / 6
            whole_sum = add(a, add(b, c))
            inner = product_of(whole_sum, whole_sum)
            for x in (a, b, c):
                inner = plus(inner, product_of(x, x))
            total = plus(total, tuple(scale(Fraction(six) / 120, r) for r in inner))  # type: ignore
    return tuple(scale(Fraction(mass) / volume, r) for r in total)  # type: ignore[return-value]


def from_moment(m: Matrix) -> Matrix:
    trace = m[0][0] + m[1][1] + m[2][2]
    return tuple(tuple((trace if i == j else 0) - m[i][j] for j in range(3)) for i in range(3))  # type: ignore[return-value]


def point_inertia(mass: Any, r: Vector) -> Matrix:
    return from_moment(tuple(scale(mass, row) for row in product_of(r, r)))  # type: ignore


def estimate(v: Vector) -> Vector:
    """Components rounded to multiples of 2^(e-40), 2^e <= the greatest < 2^(e+1)."""
    from model import nearest

    most = max(abs(x) for x in v)
    if most == 0:
        return v
    e = exponent(most)
    step = Fraction(2) ** (e - 40)
    return tuple(nearest(x, step) for x in v)  # type: ignore[return-value]


def exponent(x: Fraction) -> int:
    """The e with 2^e <= x < 2^(e+1)."""
    e = x.numerator.bit_length() - x.denominator.bit_length()
    while Fraction(2) ** e > x:
        e -= 1
    while Fraction(2) ** (e + 1) <= x:
        e += 1
    return e


def default_resolution(model: Model) -> Fraction:
    """The greatest power of two that is at most 2^-20 times the shortest edge of all bodies."""
    edges = [
        sub(part.solid.place[u], part.solid.place[w])
        for leaf in model.leaves.values()
        for part in leaf.parts
        for u, w in part.solid.edges
    ]
    least = min(dot(e, e) for e in edges)
    power = Fraction(2) ** 40
    while power * power > least:
        power /= 2
    return power / 2**20
