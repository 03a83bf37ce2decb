"""The successors of a state of a translational model (chapters 1 to 3 of the rule book)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import combinations, permutations, product
from typing import Any, Dict, FrozenSet, Iterator, List, Optional, Tuple

import contact
import impact
import response
import steps
import terms
from blocked import Blocked
from draws import Draws, waits
from lots import Lots, lots_wait
from model import Leaf, Model, Part
from rounding import Rounding
from solids import Feature, Solid
from states import Body, Bond, Process, State, Step
from vectors import IDENTITY, ZERO, Vector, add, scale, sub

Transition = Tuple[Any, State]
Meeting = Tuple[Process, Process, List[Any]]  # two processes, and their touching pairs of parts
Released = Dict[Bond, Fraction]  # bonds that are released, with their pushes (I-36)


STEERED = Step(Fraction(0), "steered")


class Stopped(Exception):
    """A state whose transitions cannot be computed (rule Persistent)."""


class Pair:
    """Two parts of two processes that touch."""

    def __init__(self, first: Tuple[str, Part], second: Tuple[str, Part], offset: Vector) -> None:
        self.leaf1, self.part1 = first
        self.leaf2, self.part2 = second
        self.offset = offset
        self.tight = contact.tight(self.part1.solid, self.part2.solid, offset)

    def approaches(self, w: Vector) -> bool:
        """Rule Approach."""
        return contact.approaching(self.part1.solid, self.part2.solid, self.offset, w)


class Rules(Draws, Blocked, Lots, Rounding):
    """The rules over one model."""

    def __init__(self, model: Model) -> None:
        self.model = model

    # Bodies and processes.

    def leaf(self, name: str) -> Leaf:
        return self.model.leaves[name]

    def is_fixed(self, process: Process) -> bool:
        return any(self.leaf(name).fixed for name in process.bodies)

    def mass(self, process: Process) -> Fraction:
        return sum((self.leaf(name).mass for name in process.bodies), Fraction(0))

    def parts(self, process: Process) -> Iterator[Tuple[str, Part, Vector]]:
        for name, body in process.bodies.items():
            for part in self.leaf(name).parts:
                yield name, part, body.position

    # Behaviours of a leaf.

    def summands(self, name: str, body: Body) -> List[terms.Term]:
        return list(terms.summands(body.term, self.model.lookup(self.leaf(name))))

    def becomes(self, body: Body, then: terms.Term) -> Body:
        return replace(body, term=then, origin=terms.origin_of(then))

    # Collisions.

    def touching(self, p: Process, q: Process) -> List[Pair]:
        found = []
        for name1, part1, at1 in self.parts(p):
            for name2, part2, at2 in self.parts(q):
                offset = sub(at2, at1)
                if contact.relation(part1.solid, part2.solid, offset) == "touching":
                    found.append(Pair((name1, part1), (name2, part2), offset))
        return found

    def collision(self, p: Process, q: Process) -> Optional[List[Pair]]:
        """All touching pairs of parts of two processes that collide; None if they do not."""
        w = sub(q.velocity, p.velocity)
        if w == ZERO:
            return None
        pairs = self.touching(p, q)
        return pairs if any(pair.approaches(w) for pair in pairs) else None

    def collisions(self, state: State) -> List[Meeting]:
        """What is resolved before time passes: collisions, and what binds by contact (I-33)."""
        found = []
        for p, q in combinations(state.processes, 2):
            pairs = self.collision(p, q)
            if pairs is None and self.model.by_contact:
                touching = self.touching(p, q)
                if any(True for _ in self.candidates(p, q, touching)):
                    pairs = touching
            if pairs is not None:
                found.append((p, q, pairs))
        return found

    def colliding(self, processes: List[Process]) -> List[Tuple[int, int]]:
        """The collisions of some processes, by their numbers."""
        numbered = combinations(enumerate(processes), 2)
        return [(i, j) for (i, p), (j, q) in numbered if self.collision(p, q) is not None]

    def hit(self, state: State) -> List[Process]:
        """All processes of which something is to be resolved before time passes."""
        return members(self.collisions(state))

    def clusters(self, state: State) -> List[List[Meeting]]:
        """Collisions that are resolved as one: those that hang together (I-32), or each."""
        left = [m for m in self.collisions(state) if not any(True for _ in self.to_stop(m))]
        if not self.model.together:
            return [[meeting] for meeting in left]
        found = []
        while left:
            cluster = [left.pop(0)]
            grown = True
            while grown:
                moving = {id(p) for m in cluster for p in m[:2] if not self.takes_nothing(p)}
                more = [m for m in left if id(m[0]) in moving or id(m[1]) in moving]
                left = [m for m in left if not any(m is other for other in more)]
                cluster += more
                grown = bool(more)
            found.append(cluster)
        return found

    def touching_features(self, pair: Pair) -> List[Tuple[Feature, Feature, int]]:
        return contact.touching_pairs(pair.part1.solid, pair.part2.solid, pair.offset)

    def candidates(
        self, p: Process, q: Process, pairs: List[Pair]
    ) -> Iterator[Tuple[Bond, Dict[str, Body]]]:
        """Rule Bind, wherever the two touch (I-12): bonds, and what the two leaves become."""
        for pair in pairs:
            body1, body2 = p.bodies[pair.leaf1], q.bodies[pair.leaf2]
            open1 = [s for s in self.summands(pair.leaf1, body1) if s[0] == "open"]
            open2 = [s for s in self.summands(pair.leaf2, body2) if s[0] == "open"]
            matching = [
                (s1, s2) for s1 in open1 for s2 in open2 if s1[2] == s2[2] and s1[1] != s2[1]
            ]
            if not matching:
                continue
            features = self.touching_features(pair)
            for s1, s2 in matching:
                active1, active2 = s1[3], s2[3]
                both = [
                    ((pair.part1.name, f1), (pair.part2.name, f2), dimension)
                    for f1, f2, dimension in features
                    if (pair.part1.name, f1) in active1 and (pair.part2.name, f2) in active2
                ]
                highest = max((d for _, _, d in both), default=None)
                for site1, site2, dimension in both:
                    if dimension == highest:
                        bond = (s1[2], frozenset({(pair.leaf1, site1), (pair.leaf2, site2)}))
                        yield (
                            bond,
                            {
                                pair.leaf1: self.becomes(body1, s1[4]),
                                pair.leaf2: self.becomes(body2, s2[4]),
                            },
                        )

    def bind(self, p: Process, q: Process, bond: Bond, new: Dict[str, Body]) -> Process:
        if self.is_fixed(p) or self.is_fixed(q):
            velocity = ZERO
        else:
            m1, m2 = self.mass(p), self.mass(q)
            velocity = scale(1 / (m1 + m2), add(scale(m1, p.velocity), scale(m2, q.velocity)))
        bodies = {**p.bodies, **q.bodies, **new}
        return Process(velocity, None, bodies, p.bonds | q.bonds | {bond})

    def normals(self, p: Process, q: Process, pairs: List[Pair]) -> List[Vector]:
        """The directions that count in a collision (I-13)."""
        w = sub(q.velocity, p.velocity)
        return response.directions(
            [pair.tight for pair in pairs], [pair.approaches(w) for pair in pairs]
        )

    def takes_nothing(self, process: Process) -> bool:
        """Whether a process takes no share of the change of a bounce."""
        return self.is_fixed(process) or self.is_walker(process)

    def bounce(self, p: Process, q: Process, pairs: List[Pair]) -> Tuple[Process, Process]:
        """Rule Bounce, with rule Response."""
        w = sub(q.velocity, p.velocity)
        normals = self.normals(p, q, pairs)
        change = sub(response.reflect(normals, w), w)
        if self.takes_nothing(p):
            share1, share2 = Fraction(0), Fraction(1)
        elif self.takes_nothing(q):
            share1, share2 = Fraction(1), Fraction(0)
        else:
            m1, m2 = self.mass(p), self.mass(q)
            share1, share2 = m2 / (m1 + m2), m1 / (m1 + m2)
        after1 = replace(p, velocity=sub(p.velocity, scale(share1, change)), lasts=None)
        after2 = replace(q, velocity=add(q.velocity, scale(share2, change)), lasts=None)
        return after1, after2

    def bounce_all(self, cluster: List[Meeting]) -> List[Tuple[Process, Process]]:
        """Reading I-32: one bounce of all processes of a cluster, as old and new ones."""
        old = members(cluster)
        bodies = [
            impact.Rigid(
                None if self.takes_nothing(p) else self.mass(p), ZERO, None, p.velocity, ZERO
            )
            for p in old
        ]
        at = {id(p): i for i, p in enumerate(old)}
        rows = [
            (at[id(p)], at[id(q)], n, ZERO)
            for p, q, pairs in cluster
            for n in self.normals(p, q, pairs)
        ]
        after = impact.reflect_all(rows, bodies)
        return [(p, replace(p, velocity=b.velocity, lasts=None)) for p, b in zip(old, after)]

    def bounces(self, cluster: List[Meeting]) -> List[Tuple[Process, Process]]:
        """What takes part in a bounce, and what it becomes."""
        if self.model.together:
            return self.bounce_all(cluster)
        p, q, pairs = cluster[0]
        return list(zip((p, q), self.bounce(p, q, pairs)))

    def resolutions(self, state: State) -> Iterator[Transition]:
        for cluster in self.clusters(state):
            bound = False
            for p, taker in self.taken(cluster):
                bound = True
                yield ("absorb", self.first(p), taker), state.having([p], [])
            for p, q, pairs in cluster:
                for bond, new in self.candidates(p, q, pairs):
                    bound = True
                    whole = steps.joined(self, p, q, self.bind(p, q, bond, new))
                    yield ("bind",) + bond, state.having([p, q], [self.begun(whole)])
            if not bound:
                changes = self.bounces(cluster)
                order = list(self.model.leaves)
                names = tuple(sorted((self.first(p) for p, _ in changes), key=order.index))
                after = [self.begun(steps.struck(p)) for _, p in changes]
                label = ("bounce", names, self.hits(cluster))
                yield label, state.having([p for p, _ in changes], after)

    def taken(self, cluster: List[Meeting]) -> Iterator[Tuple[Process, str]]:
        """Rule Absorb: who is gone, and the leaf that took it."""
        for p, q, _ in cluster:
            for one, other in ((p, q), (q, p)):
                taker = next((name for name in other.bodies if self.leaf(name).absorbs), None)
                if taker and (not self.model.by_contact or self.collision(p, q) is not None):
                    yield one, taker

    def hits(self, cluster: List[Meeting]) -> FrozenSet[Any]:
        """Who touches in a bounce: pairs of parts."""
        return frozenset(
            frozenset({self.named(pair.leaf1, pair.part1), self.named(pair.leaf2, pair.part2)})
            for _, _, pairs in cluster
            for pair in pairs
        )

    def named(self, leaf: str, part: Part) -> str:
        return leaf if part.name is None else "%s.%s" % (leaf, part.name)

    def first(self, process: Process) -> str:
        """The first leaf of a process, in the order of declaration."""
        return next(name for name in self.model.leaves if name in process.bodies)

    # Closings.

    def contacts(self, p: Process, q: Process) -> List[Any]:
        """All pairs of parts of two that touch."""
        return self.touching(p, q)

    def unbound(self, process: Process) -> Iterator[Tuple[str, str]]:
        """Every two leaves of a process that no bond joins."""
        joined = [{leaf for leaf, _ in ends} for _, ends in process.bonds]
        for pair in combinations(process.bodies, 2):
            if set(pair) not in joined:
                yield pair

    def closings(self, state: State) -> Iterator[Transition]:
        """Rule Close: bonds that close rings (I-37)."""
        for process in state.processes if self.model.cyclic else ():
            for pair in self.unbound(process):
                p, q = (replace(process, bodies={leaf: process.bodies[leaf]}) for leaf in pair)
                for bond, new in self.candidates(p, q, self.contacts(p, q)):
                    bodies = {**process.bodies, **new}
                    whole = replace(process, bodies=bodies, bonds=process.bonds | {bond})
                    yield ("close",) + bond, state.having([process], [self.begun(whole)])

    # Splits.

    def releases(self, process: Process) -> Iterator[Tuple[Released, Dict[str, Body]]]:
        """Rule WeakSplit: bonds that may be released, and what the two leaves become."""
        for bond in process.bonds:
            name, ends = bond
            offers = []
            for leaf, site in ends:
                body = process.bodies[leaf]
                offers.append(
                    [
                        (leaf, s)
                        for s in self.summands(leaf, body)
                        if s[0] == "weak" and s[1] == name and site in s[2] and self.is_free(s)
                    ]
                )
            for chosen in product(*offers):
                yield self.outcome(process, [bond], dict(chosen))

    def is_free(self, summand: terms.Term) -> bool:
        """Whether a summand is a free choice, and not left to chance (Lot)."""
        return summand[3] is None

    def outcome(
        self, process: Process, bonds: List[Bond], chosen: Dict[str, terms.Term]
    ) -> Tuple[Released, Dict[str, Body]]:
        """What is released, and what leaves become, by a summand of each."""
        pushes = {
            bond: sum((chosen[leaf][-2] for leaf, _ in bond[1]), Fraction(0)) for bond in bonds
        }
        new = {leaf: self.becomes(process.bodies[leaf], s[-1]) for leaf, s in chosen.items()}
        return pushes, new

    def reactions(self, process: Process) -> Iterator[Tuple[Released, Dict[str, Body]]]:
        """Rule StrongSplit: sets of bonds that hang together, and what their leaves become."""
        bonds = list(process.bonds)
        for size in range(1, len(bonds) + 1):
            for chosen in combinations(bonds, size):
                if not hangs_together(chosen):
                    continue
                at: Dict[str, list] = {}
                for name, ends in chosen:
                    for leaf, site in ends:
                        at.setdefault(leaf, []).append((name, site))
                offers = []
                for leaf, released in at.items():
                    body = process.bodies[leaf]
                    offers.append(
                        [
                            (leaf, s)
                            for s in self.summands(leaf, body)
                            if s[0] == "strong" and self.reacts(s[1], released)
                        ]
                    )
                for summands in product(*offers):
                    yield self.outcome(process, list(chosen), dict(summands))

    def reacts(self, entries: Any, released: list) -> bool:
        """Whether bonds and entries match one to one."""
        if len(entries) != len(released):
            return False
        return any(
            all(n == name and site in active for (name, active), (n, site) in zip(order, released))
            for order in permutations(entries)
        )

    def fall_apart(
        self, process: Process, released: Released, new: Dict[str, Body]
    ) -> List[Process]:
        """The pieces without some bonds; each keeps the motion of the whole (I-11), and is driven
        by what pushes it (I-36)."""
        bodies = {**process.bodies, **new}
        whole = replace(process, bodies=bodies, bonds=process.bonds - set(released))
        phase = process.step.phase if process.step else None
        pieces = [self.piece(process, piece) for piece in self.pieces(whole)]
        for bond, push in released.items():
            if push:
                pieces = self.driven_apart(pieces, bond, push)
        return [self.begun(steps.having(self, piece, phase)) for piece in pieces]

    def pieces(self, process: Process) -> List[Process]:
        """What hangs together by bonds."""
        found, left = [], list(process.bodies)
        while left:
            names = {left[0]}
            grown = True
            while grown:
                grown = False
                for _, ends in process.bonds:
                    ends_at = {leaf for leaf, _ in ends}
                    if ends_at & names and not ends_at <= names:
                        names |= ends_at
                        grown = True
            left = [name for name in left if name not in names]
            bonds = frozenset(b for b in process.bonds if all(leaf in names for leaf, _ in b[1]))
            bodies = {name: body for name, body in process.bodies.items() if name in names}
            found.append(Process(process.velocity, None, bodies, bonds))
        return found

    def piece(self, process: Process, piece: Process) -> Process:
        """Reading I-11: a piece has the motion that it had in the whole."""
        return piece

    def driven_apart(self, pieces: List[Process], bond: Bond, push: Fraction) -> List[Process]:
        """Reading I-36: with the pieces of the two ends of a bond driven apart."""
        places = []
        for leaf, (part, _) in bond[1]:
            i = next(i for i, piece in enumerate(pieces) if leaf in piece.bodies)
            places.append((i, pieces[i].bodies[leaf], self.leaf(leaf).by_name[part]))
        (i, *one), (j, *two) = places
        normals, x = self.contact_of(*one, *two)
        impulse = scale(push, impact.unit(self.line(normals, one, two)))
        driven = list(pieces)
        driven[i] = self.driven(driven[i], scale(-1, impulse), x)
        driven[j] = self.driven(driven[j], impulse, x)
        return driven

    def line(self, normals: List[Vector], one: List[Any], two: List[Any]) -> Vector:
        """Along which two parts are driven apart: their only normal, or that of the centroids."""
        if len(normals) == 1:
            return normals[0]
        here, there = (self.world(*place).volume_and_centroid()[1] for place in (one, two))
        return sub(there, here)

    def world(self, body: Body, part: Part) -> Solid:
        """A part where its body is."""
        return part.solid.mapped(IDENTITY, body.position)

    def contact_of(
        self, body1: Body, part1: Part, body2: Body, part2: Part
    ) -> Tuple[List[Vector], Vector]:
        """The normals of two parts in contact, from the first to the second, and the middle of
        where they touch: any point, since nothing turns."""
        offset = sub(body2.position, body1.position)
        return contact.tight(part1.solid, part2.solid, offset), ZERO

    def driven(self, process: Process, impulse: Vector, x: Vector) -> Process:
        """After an impulse at a point; what is fixed takes nothing."""
        if self.is_fixed(process):
            return process
        change = scale(1 / self.mass(process), impulse)
        return replace(process, velocity=add(process.velocity, change))

    def splits(self, state: State) -> Iterator[Transition]:
        for process in state.processes:
            for released, new in self.reactions(process):
                pieces = self.fall_apart(process, released, new)
                label = ("strong", frozenset(told(released)))
                yield label, state.having([process], pieces)
            if process.clock == 0:
                for released, new in self.releases(process):
                    pieces = self.fall_apart(process, released, new)
                    yield ("weak", *told(released)[0]), state.having([process], pieces)

    # Clocks.

    def begun(self, process: Process) -> Process:
        """With its split clock set anew, by a discrete transition (I-9)."""
        enabled = next(self.releases(process), None) is not None
        return replace(process, clock=Fraction(0) if enabled else None)

    # Time.

    def horizon(self, process: Process) -> Optional[Fraction]:
        found = []
        for name, body in process.bodies.items():
            h = terms.horizon(body.term, self.model.lookup(self.leaf(name)))
            if h is not None:
                found.append(h)
        return min(found) if found else None

    def to_collision(self, state: State) -> Optional[Fraction]:
        """Rule Ftoc."""
        found = []
        for p, q in combinations(state.processes, 2):
            w = sub(q.velocity, p.velocity)
            if w == ZERO:
                continue
            for _, part1, at1 in self.parts(p):
                for _, part2, at2 in self.parts(q):
                    t = contact.first_time_of_contact(part1.solid, part2.solid, sub(at2, at1), w)
                    if t is not None:
                        found.append(t)
        return min(found) if found else None

    def to_binding(self, state: State) -> Optional[Fraction]:
        """Reading I-33: until features of two compatible channels that are open now meet."""
        found = []
        for p, q in combinations(state.processes, 2):
            w = sub(q.velocity, p.velocity)
            if w == ZERO:
                continue
            for leaf1, leaf2, s1, s2 in self.compatible(p, q):
                one, two = p.bodies[leaf1].position, q.bodies[leaf2].position
                for a in self.listed(leaf1, s1):
                    for b in self.listed(leaf2, s2):
                        t = contact.first_meeting(a, b, sub(two, one), w)
                        if t is not None:
                            found.append(t)
        return min(found) if found else None

    def listed(self, leaf: str, summand: terms.Term) -> List[List[Vector]]:
        """The corners of the features of a channel that are in no others of it, from the
        reference point of the leaf."""
        parts, found = self.leaf(leaf).by_name, []
        for part, feature in summand[3]:
            corners = set(feature[1])
            if not any(p == part and corners < set(f[1]) for p, f in summand[3]):
                found.append(parts[part].solid.points(feature))
        return found

    def compatible(
        self, p: Process, q: Process
    ) -> Iterator[Tuple[str, str, terms.Term, terms.Term]]:
        """Open channels of two processes that are co-named: their leaves and summands."""
        for leaf1, body1 in p.bodies.items():
            for leaf2, body2 in q.bodies.items():
                for s1 in self.summands(leaf1, body1):
                    for s2 in self.summands(leaf2, body2):
                        if s1[0] == s2[0] == "open" and s1[2] == s2[2] and s1[1] != s2[1]:
                            yield leaf1, leaf2, s1, s2

    def delay(self, state: State) -> Optional[Fraction]:
        """Rule Time: how long time passes; None if it never ends (Quiescent)."""
        events = []
        ftoc = self.to_collision(state)
        if ftoc is not None:
            events.append(ftoc)
        if self.model.by_contact:
            meeting = self.to_binding(state)
            if meeting is not None:
                events.append(meeting)
        for process in state.processes:
            if process.step is not None:
                events.append(process.step.remaining)
            h = self.horizon(process)
            if h is not None:
                events.append(h)
            if process.clock is not None:
                events.append(self.model.split_step - process.clock)
        instant = self.to_split_instant(state)
        if instant is not None:
            events.append(instant)
        if state.step is not None and (events or self.goes_on(state)):
            events.append(state.step.remaining)
        return min(events) if events else None

    def goes_on(self, state: State) -> bool:
        """Whether movement steps follow each other even if no other event is to come."""
        return any(steps.is_steered(self, process) for process in state.processes)

    def moved(self, process: Process, d: Fraction) -> Process:
        """Where a process is after the time d."""
        bodies = {
            name: replace(body, position=add(body.position, scale(d, process.velocity)))
            for name, body in process.bodies.items()
        }
        return replace(process, bodies=bodies)

    def passed(self, state: State, d: Fraction) -> State:
        processes = []
        for process in state.processes:
            bodies = {}
            for name, body in process.bodies.items():
                lookup = self.model.lookup(self.leaf(name))
                term, origin = terms.aged(body.term, body.origin, d, lookup)
                bodies[name] = replace(body, term=term, origin=origin)
            after = steps.passed(self.moved(replace(process, bodies=bodies), d), d)
            processes.append(replace(after, clock=self.aged_clock(process, after, d)))
        step = state.step
        if step is not None:
            step = replace(step, remaining=step.remaining - d, phase="moving")
        after = State(tuple(processes), step, state.time + d, self.since(state, d))
        return self.pending(after)

    def releasable(self, process: Process) -> set:
        return {bond for released, _ in self.releases(process) for bond in released}

    def aged_clock(self, before: Process, after: Process, d: Fraction) -> Optional[Fraction]:
        """Readings I-9 and I-16: 0 where a further bond has become releasable."""
        old, new = self.releasable(before), self.releasable(after)
        if not new:
            return None
        if before.clock is None or new - old:
            return Fraction(0)
        return (before.clock + d) % self.model.split_step

    # Steering.

    def settled(self, state: State, kind: str) -> State:
        """The end of each transition: Steer, and Round where velocities are rounded."""
        if not waits(state):
            state = self.stopped_walkers(state)
        return self.finished(self.after_steering(state, kind))

    def finished(self, state: State) -> State:
        """The end of each transition after Steer, unless somebody waits to draw (Draw)."""
        if not waits(state):
            state = self.stopped_walkers(state)
        rounds = "velocity" in self.model.rounding and not waits(state)
        return self.begin_turns(state) if rounds else state

    def begin_turns(self, state: State) -> State:
        """All turns that are due, of what neither collides nor binds by contact (I-33), begin at
        once: of the length 0."""
        processes, hit = list(state.processes), {id(p) for p in self.hit(state)}
        due = [i for i, p in enumerate(processes) if p.lasts is None and id(p) not in hit]
        rounded = self.rounded_velocities(processes, due)
        begun = [replace(p, lasts=Fraction(0)) if i in due else p for i, p in enumerate(rounded)]
        return replace(state, processes=tuple(begun))

    def after_steering(self, state: State, kind: str) -> State:
        """Rule Steer: what is due after a transition (I-15)."""
        step = state.step
        if step and step.phase == "moving" and (step.remaining == 0 or self.ends_step(kind)):
            state = replace(state, step=Step(step.remaining, "due"))
        asked = [] if lots_wait(state) else self.asked(state)
        if not asked:
            return state
        return self.to_draw(state, asked) or self.steer_all(state, asked)

    def ends_step(self, kind: str) -> bool:
        """Whether a transition of a kind ends the step of the network (I-35)."""
        return kind in ("bind", "bounce", "absorb") and not self.model.steady

    def asked(self, state: State) -> List[Process]:
        """The processes whose laws are asked now: with steps of their own those that do not
        collide and whose steps are over (I-31), and else all, if nothing collides."""
        over = [p for p in state.processes if (p.step or state.step or STEERED).phase == "due"]
        if not over:
            return []
        hit = {id(p) for p in self.hit(state)}
        if self.model.local:
            return [p for p in over if id(p) not in hit]
        return [] if hit else over

    def steer_all(self, state: State, asked: List[Process]) -> State:
        """With new velocities of all whose laws are asked, and their next steps begun."""
        dt = self.since_asked(state)
        new = [self.steered(p, state.time, dt) for p in asked]
        if self.model.local:
            return state.having(asked, [steps.begun(self, p) for p in new])
        return replace(state.having(asked, new), step=Step(self.model.timestep, "steered"))

    def seen(self, process: Process, name: str) -> Tuple[Vector, Vector]:
        """The place and the velocity of a leaf, as its law sees them."""
        at = process.bodies[name].position
        return add(at, self.leaf(name).centroid), process.velocity

    def steered(self, process: Process, time: Fraction, dt: Fraction) -> Process:
        if not steps.is_steered(self, process):
            return process
        motion = process.draw
        if motion is None:
            (motion,) = self.ways(process, time, dt)
        moved = replace(process, velocity=motion[:3], lasts=None, draw=None)
        return self.spun(moved, motion[3:]) if len(motion) == 6 else moved

    def spun(self, process: Process, spin: Vector) -> Process:
        """With a spin that a law gives, which no law does in translation."""
        raise AssertionError("a spin where nothing turns")

    # States.

    def initial(self) -> State:
        """Rule Successors: as declared, split clocks set, the first steer done."""
        bodies, velocities = {}, {}
        for name, leaf in self.model.initial_leaves.items():
            term = leaf["term"]
            bodies[name] = Body(leaf["position"], term, terms.origin_of(term))
            velocities[name] = leaf["velocity"]
        whole = Process(ZERO, None, bodies, frozenset(self.model.initial_bonds))
        processes = []
        for piece in self.pieces(whole):
            velocity = velocities[next(iter(piece.bodies))]
            piece = steps.having(self, replace(piece, velocity=velocity), None)
            processes.append(self.begun(piece))
        state = State(tuple(processes), self.first_step(), since=self.first_instant())
        return self.settled(state, "time")

    def first_instant(self) -> Optional[Fraction]:
        """The start counts as a split instant of the network, but no lots are drawn then."""
        return Fraction(0) if self.model.lots else None

    def first_step(self) -> Optional[Step]:
        """Of the network, before its first steer."""
        whole = self.model.steered and not self.model.local
        return Step(self.model.timestep, "due") if whole else None

    def successors(self, state: State) -> List[Transition]:
        """All transitions, in no order."""
        drawings = self.drawings(state)
        if drawings:
            return drawings
        lots = self.drawings_of_lots(state)
        if lots:
            return [(label, self.settled(after, label[0])) for label, after in lots]
        found = [*self.splits(state), *self.closings(state), *self.resolutions(state)]
        urgent = any(label[0] != "weak" for label, _ in found)
        if not urgent:
            d = self.delay(state)
            if d is not None:
                found.append((("time", d), self.passed(state, d)))
        return [(label, self.settled(after, label[0])) for label, after in found]


def told(released: Released) -> List[Any]:
    """What a label says of bonds that are released: the push of each, if it is not 0."""
    return [(*bond, push or None) for bond, push in released.items()]


def members(cluster: List[Meeting]) -> List[Process]:
    """All processes that take part in some collisions, each once."""
    found: List[Process] = []
    for meeting in cluster:
        found += [p for p in meeting[:2] if not any(p is other for other in found)]
    return found


def hangs_together(bonds: Any) -> bool:
    """Whether bonds make one connected piece."""
    reached = {leaf for leaf, _ in bonds[0][1]}
    left = list(bonds[1:])
    while left:
        more = [b for b in left if any(leaf in reached for leaf, _ in b[1])]
        if not more:
            return False
        for b in more:
            reached |= {leaf for leaf, _ in b[1]}
        left = [b for b in left if b not in more]
    return True
