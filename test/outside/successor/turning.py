"""The successors of a state of a rigid model (chapter 4 of the rule book)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

import cast
import contact
import impact
import near
import steps
import terms
from draws import waits
from masses import NOTHING, from_moment, plus, point_inertia, second_moment
from model import Model, Part, rotation
from motion import STILL, Flight, inverse, product, whole
from rest import Rest
from rounding import estimate
from solids import Solid
from states import Body, Bond, Process, State
from straight import Rules, Stopped, members
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


class Meeting:
    """Two parts of two processes in contact."""

    def __init__(
        self,
        first: Tuple[str, Part],
        second: Tuple[str, Part],
        found: near.Contact,
        one: Solid,
        two: Solid,
    ) -> None:
        self.leaf1, self.part1 = first
        self.leaf2, self.part2 = second
        self.contact, self.solids = found, (one, two)


class Turning(Rest, Rules):
    def __init__(self, model: Model) -> None:
        super().__init__(model)
        self.free = model.settings.get("dynamics") == "free_body"
        self.resolution = Fraction(model.settings.get("resolution") or default_resolution(model))
        self._inertias: Dict[str, Matrix] = {}
        self._known: Dict[Any, Any] = {}  # of processes by where they are and how they move

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
        if not process.lasts:
            return replace(process, bodies=bodies)
        after = replace(process, bodies=bodies, since=process.since + d)
        return self.ended(after) if after.since == process.lasts else after

    def ended(self, process: Process) -> Process:
        """A turn is over, and a new one due: what is seen is exactly so."""
        return replace(process, since=Fraction(0), lasts=None, spin=self.spin_now(process))

    def length(self, spin: Vector, d: Fraction) -> Fraction:
        """The greatest d / 2^k such that |w| d / 2 <= 1/4; 0 for what does not spin."""
        if spin == ZERO:
            return Fraction(0)
        while dot(spin, spin) * d * d > Fraction(1, 4):
            d /= 2
        return d

    def plainly(self, process: Process) -> Process:
        """A turn begins, about the spin that there is."""
        return replace(process, lasts=self.length(process.spin, self.model.timestep))

    def renewed(self, process: Process) -> Process:
        """A turn begins; of a free body, about the spin half-way through it."""
        if not self.free or self.is_fixed(process) or process.spin == ZERO:
            return self.plainly(process)
        d = self.length(process.spin, self.model.timestep)
        while True:
            spin = self.midway(process, d)
            if self.length(spin, d) == d:
                return replace(process, spin=spin, lasts=d)
            d /= 2

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
        """The time since the last of the present turns of two processes began."""
        return min(process.since for process in (p, q) if process.spin != ZERO)

    def far(self, p: Process, q: Process, span: Fraction) -> bool:
        """Whether two processes are too far apart to meet within a span: their balls do not."""
        reach = Fraction(0)
        for process in (p, q):
            reach += self.radius(process)
            reach += cast.root(dot(process.velocity, process.velocity)) * span
        d = sub(self.centre(q), self.centre(p))
        return dot(d, d) > reach * reach

    def known(self, what: Callable[..., Any], *processes: Process) -> Any:
        """What depends on nothing but where processes are and how they move, worked out once."""
        key = (what.__name__, *(course(process) for process in processes))
        if key not in self._known:
            self._known[key] = what(*processes)
        return self._known[key]

    def radius(self, process: Process) -> Fraction:
        """No less than the distance of any point of a process from its centre (Cast, Round)."""
        return self.known(self._radius, process)

    def _radius(self, process: Process) -> Fraction:
        return max(cast.reach(mover) for _, _, mover in self.movers(process))

    def worlds(self, process: Process) -> List[Solid]:
        """All parts of a process, in the world."""
        return [
            self.world(body, part)
            for name, body in process.bodies.items()
            for part in self.leaf(name).parts
        ]

    def neither_spins(self, p: Process, q: Process) -> bool:
        return p.spin == ZERO and q.spin == ZERO

    def straight(self, p: Process, q: Process) -> Optional[Fraction]:
        """Rule Ftoc for two processes of which neither spins."""
        w = sub(q.velocity, p.velocity)
        times = [
            contact.first_time_of_contact(a, b, ZERO, w)
            for a in self.worlds(p)
            for b in self.worlds(q)
        ]
        return min((t for t in times if t is not None), default=None)

    def to_collision_of(self, p: Process, q: Process, span: Fraction) -> Optional[Fraction]:
        """t- of two processes, if it is at most the span."""
        if self.neither_spins(p, q):
            return self.straight(p, q)
        found: List[Fraction] = []
        for _, _, casting, grid, shift in self.casts(p, q):
            reach = span + Fraction(1, 2**grid)
            if not self.far(p, q, reach):
                t = casting.first(reach, grid, shift)
                if t is not None and t <= span:
                    found.append(t)
        return min(found) if found else None

    def collides(self, p: Process, q: Process) -> bool:
        """Whether t- is 0 (or t*, where neither spins) for some parts of two processes."""
        if self.neither_spins(p, q):
            return self.straight(p, q) == 0
        for _, _, casting, grid, shift in self.casts(p, q):
            cell = Fraction(1, 2**grid)
            reach = cell - shift % cell
            if not self.far(p, q, reach) and casting.first(reach, grid, shift) == 0:
                return True
        return False

    def colliding(self, processes: Any) -> List[Tuple[int, int]]:
        """The collisions of some processes, by their numbers."""
        found = []
        for i, j in combinations(range(len(processes)), 2):
            p, q = processes[i], processes[j]
            if self.is_fixed(p) and self.is_fixed(q):
                continue
            if self.known(self.collides, p, q):
                found.append((i, j))
        return found

    def hit(self, state: State) -> List[Process]:
        return [state.processes[i] for pair in self.colliding(state.processes) for i in pair]

    def collisions(self, state: State) -> List[Tuple[Process, Process, List[Any]]]:
        """Processes that collide now (rule Cast), with all their contacts."""
        found = []
        for i, j in self.colliding(state.processes):
            p, q = state.processes[i], state.processes[j]
            found.append((p, q, self.known(self.meetings, p, q)))
        return found

    def meetings(self, p: Process, q: Process) -> List[Meeting]:
        """All contacts of parts of two processes (rule Near)."""
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

    def contacts(self, p: Process, q: Process) -> List[Any]:
        return self.meetings(p, q)

    def touching_features(self, pair: Meeting) -> Any:
        return pair.contact.pairs

    def bind(self, p: Process, q: Process, bond: Bond, new: Dict[str, Body]) -> Process:
        bodies = {**p.bodies, **q.bodies, **new}
        joined = Process(ZERO, None, bodies, p.bonds | q.bonds | {bond})
        if self.is_fixed(joined):
            momentum = ZERO if self.free else None
            return replace(joined, momentum=momentum)
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
        return replace(joined, momentum=angular if self.free else None)

    def bounces(self, cluster: List[Any]) -> List[Tuple[Process, Process]]:
        """Rule Impact, of two or of all that hang together (I-32)."""
        old = members(cluster)
        bodies = [self.rigid(p) for p in old]
        at = {id(p): i for i, p in enumerate(old)}
        rows = []
        for p, q, pairs in cluster:
            i, j = at[id(p)], at[id(q)]
            contacts, solids = [m.contact for m in pairs], [m.solids for m in pairs]
            found = impact.rows(contacts, solids, bodies[i], bodies[j])
            rows += [(i, j, n, x) for n, x in found]
        after = impact.reflect_all(rows, bodies)
        if after == bodies:
            raise Stopped("persistent contact")
        return [(p, self.pushed(p, body)) for p, body in zip(old, after)]

    def pushed(self, process: Process, after: impact.Rigid) -> Process:
        if after.mass is None:
            return replace(process, since=Fraction(0), lasts=None)
        momentum = apply(after.inertia, after.spin) if self.free else None  # type: ignore
        moved = replace(process, velocity=after.velocity, spin=after.spin, momentum=momentum)
        return replace(moved, since=Fraction(0), lasts=None)

    def driven(self, process: Process, impulse: Vector, x: Vector) -> Process:
        return self.pushed(process, self.rigid(process).pushed(x, impulse))

    def contact_of(
        self, body1: Body, part1: Part, body2: Body, part2: Part
    ) -> Tuple[List[Vector], Vector]:
        """The normals of two parts in contact (rule Near), and the mean of the corners of where
        they touch."""
        found = near.find(self.world(body1, part1), self.world(body2, part2), self.resolution)
        assert found is not None, "what is bound is in contact"
        total = ZERO
        for corner in found.region:
            total = add(total, corner)
        return found.normals, scale(Fraction(1, len(found.region)), total)

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

    # Turns begin and end.

    def settled(self, state: State, kind: str) -> State:
        """The end of each transition: ends of turns, Steer, Round, beginnings of turns."""
        state = self.at_contact(state)
        return self.finished(self.after_steering(state, kind))

    def finished(self, state: State) -> State:
        return state if waits(state) else self.begin_turns(self.at_contact(state))

    def at_contact(self, state: State) -> State:
        """The turns that go on of all processes that collide end."""
        while True:
            hit = {i for pair in self.colliding(state.processes) for i in pair}
            going = [i for i in hit if state.processes[i].lasts]
            if not going:
                return state
            processes = tuple(
                self.ended(p) if i in going else p for i, p in enumerate(state.processes)
            )
            state = replace(state, processes=processes)

    def steered(self, process: Process, time: Fraction, dt: Fraction) -> Process:
        """A law is asked when the turn is over."""
        over = self.stopped(process) if steps.is_steered(self, process) else process
        return super().steered(over, time, dt)

    def stopped(self, process: Process) -> Process:
        return self.ended(process)

    def begin_turns(self, state: State) -> State:
        """All turns that are due, of what does not collide, begin at once."""
        processes = list(state.processes)
        hit = {i for pair in self.colliding(processes) for i in pair}
        due = [i for i, p in enumerate(processes) if p.lasts is None and i not in hit]
        processes = self.rounded(processes, due)
        plainly = [self.plainly(p) if i in due else p for i, p in enumerate(processes)]
        begun = [self.renewed(p) if i in due else p for i, p in enumerate(processes)]
        return replace(state, processes=tuple(self.at_once(plainly, begun)))

    def spin_seen(self, process: Process) -> Vector:
        return self.spin_now(process)

    def spun(self, process: Process, spin: Vector) -> Process:
        """What is free keeps the angular momentum of the spin that is given (I-24)."""
        momentum = apply(self.inertia(process), spin) if self.free else process.momentum
        return replace(process, spin=spin, since=Fraction(0), momentum=momentum)

    def seen(self, process: Process, name: str) -> Tuple[Vector, Vector]:
        x = self.centroid(name, process.bodies[name])
        r = sub(x, self.centre(process))
        return x, add(process.velocity, cross(self.spin_now(process), r))

    def delay(self, state: State) -> Optional[Fraction]:
        """Rule Time."""
        if self.at_rest(state):
            return None
        events = [p.lasts - p.since for p in state.processes if p.lasts]
        events += [p.step.remaining for p in state.processes if p.step is not None]
        for process in state.processes:
            h = self.horizon(process)
            if h is not None:
                events.append(h)
            if process.clock is not None:
                events.append(self.model.split_step - process.clock)
        for p, q in combinations(state.processes, 2):
            if self.neither_spins(p, q):
                t = self.straight(p, q)
                if t is not None:
                    events.append(t)
        instant = self.to_split_instant(state)
        if instant is not None:
            events.append(instant)
        if state.step is not None and (events or self.goes_on(state)):
            events.append(state.step.remaining)
        if not events:
            return None
        least = min(events)
        for p, q in combinations(state.processes, 2):
            if not self.neither_spins(p, q):
                t = self.to_collision_of(p, q, least)
                if t is not None:
                    least = min(least, t)
        return least

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
            processes.append(self.begun(steps.having(self, piece, None)))
        state = State(tuple(processes), self.first_step(), since=self.first_instant())
        return self.settled(state, "initial")


def course(process: Process) -> Any:
    """Where a process is, and how it moves."""
    places = tuple((name, body.position, body.turned) for name, body in process.bodies.items())
    return process.velocity, process.spin, process.since, process.momentum, places


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
