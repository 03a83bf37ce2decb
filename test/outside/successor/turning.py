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

    def renewed(self, process: Process, d: Fraction) -> Process:
        """A new turn, of length d."""
        if not self.free or self.is_fixed(process):
            return replace(process, since=Fraction(0))
        return replace(process, since=Fraction(0), spin=self.midway(process, d))

    def midway(self, process: Process, d: Fraction) -> Vector:
        """The spin half-way through a turn of length d, from the angular momentum."""
        start = estimate(self.spin_now(process))
        turn = Flight(ZERO, ZERO, start, Fraction(0)).at(d / 2)[0]
        back = apply(transpose(turn), process.momentum or ZERO)
        found = solve(self.inertia(process), back)
        assert found is not None
        return estimate(apply(turn, tuple(found)))  # type: ignore[arg-type]

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
        """How long ago the grid of instants began."""
        return Fraction(0)

    def span(self, state: State) -> Fraction:
        assert state.step is not None
        return state.step.remaining

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

    def to_collision_of(self, p: Process, q: Process, span: Fraction) -> Optional[Fraction]:
        if span <= 0 or self.far(p, q, span):
            return None
        found = []
        for _, _, casting, grid, shift in self.casts(p, q):
            t = casting.first(span, grid, shift)
            if t is not None:
                found.append(t)
        return min(found) if found else None

    def to_collision(self, state: State) -> Optional[Fraction]:
        found = []
        for p, q in combinations(state.processes, 2):
            t = self.to_collision_of(p, q, self.span(state))
            if t is not None:
                found.append(t)
        return min(found) if found else None

    def collisions(self, state: State) -> List[Tuple[Process, Process, List[Any]]]:
        """Processes that collide now: t- is 0 for some parts of theirs (rule Cast)."""
        found = []
        for p, q in combinations(state.processes, 2):
            span = self.span(state)
            if span <= 0:
                span = self.model.timestep
            if self.far(p, q, span):
                continue
            if any(self.collide_at_once(cast, span) for cast in self.casts(p, q)):
                found.append((p, q, self.meetings(p, q)))
        return found

    def collide_at_once(self, cast: Any, span: Fraction) -> bool:
        _, _, casting, grid, shift = cast
        cell = Fraction(1, 2**grid)
        return bool(casting.first(min(span, cell - shift % cell), grid, shift) == 0)

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
        joined = Process(ZERO, None, bodies, p.bonds | q.bonds | {bond})
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
            return process
        momentum = apply(after.inertia, after.spin) if self.free else None  # type: ignore
        return replace(process, velocity=after.velocity, spin=after.spin, momentum=momentum)

    def piece(self, process: Process, piece: Process) -> Process:
        """Reading I-23: the rigid motion of the whole."""
        if self.is_fixed(process):
            momentum = ZERO if self.free else None
            return replace(piece, velocity=ZERO, spin=ZERO, momentum=momentum)
        spin = self.spin_now(process)
        arm = sub(self.centre(piece), self.centre(process))
        velocity = add(process.velocity, cross(spin, arm))
        momentum = apply(self.inertia(piece), spin) if self.free else None
        return replace(piece, velocity=velocity, spin=spin, momentum=momentum)

    # Steps.

    def begun_step(self, state: State, phase: str) -> State:
        """A new movement step, short enough for all spins (Turn), with new turns."""
        length = self.short(self.model.timestep, state.processes)
        processes = tuple(self.renewed(p, length) for p in state.processes)
        return replace(state, processes=processes, step=Step(length, phase, length))

    def short(self, d: Fraction, processes: Any) -> Fraction:
        for process in processes:
            spin = self.spin_now(process)
            while dot(spin, spin) * d * d > Fraction(1, 4):
                d /= 2
        return d

    def settled(self, state: State, kind: str) -> State:
        step = state.step
        assert step is not None
        if kind in ("weak", "strong", "bind", "bounce") and step.phase != "due":
            remaining = (
                self.short(step.remaining, state.processes) if step.remaining else step.remaining
            )
            step = replace(
                step, remaining=remaining, length=step.length - step.remaining + remaining
            )
            state = replace(state, step=step)
        collides = bool(self.collisions(state))
        if kind == "time" and collides:
            processes = tuple(
                replace(p, since=Fraction(0), spin=self.spin_now(p)) for p in state.processes
            )
            state = replace(state, processes=processes)
        if step.phase == "moving" and (step.remaining == 0 or kind in ("bind", "bounce")):
            step = replace(step, phase="due")
        state = replace(state, step=step)
        if step.phase == "due" and not collides:
            dt = step.length - step.remaining
            processes = tuple(self.renewed(p, self.model.timestep) for p in state.processes)
            processes = tuple(self.steered(p, state.time, dt) for p in processes)
            return self.begun_step(replace(state, processes=processes), "steered")
        return state

    def seen(self, process: Process, name: str) -> Tuple[Vector, Vector]:
        x = self.centroid(name, process.bodies[name])
        r = sub(x, self.centre(process))
        return x, add(process.velocity, cross(self.spin_now(process), r))

    def goes_on(self, state: State) -> bool:
        """Whether steps are to come. Where something spins they are, but for states of which it
        can be proved that nothing meets (Quiescent): these are accepted as they are told."""
        if super().goes_on(state) or any(p.spin != ZERO for p in state.processes):
            return True
        for p, q in combinations(state.processes, 2):
            w = sub(q.velocity, p.velocity)
            for name1, part1, _ in self.parts(p):
                for name2, part2, _ in self.parts(q):
                    one = self.world(p.bodies[name1], part1)
                    two = self.world(q.bodies[name2], part2)
                    if contact.first_time_of_contact(one, two, ZERO, w) is not None:
                        return True
        return False

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
                piece, velocity=velocity, spin=spin, momentum=momentum if self.free else None
            )
            processes.append(self.begun(piece))
        step = Step(self.model.timestep, "due", self.model.timestep)
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
