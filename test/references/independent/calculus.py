"""The translational calculus on axis-aligned boxes, written naively from specs/rulebook.md.

Nothing here is clever or fast, and nothing is shared with the interpreter: a body is a
list of boxes, a feature is a product of three points or open intervals, and every rule
of the rule book is a loop over all that it quantifies over.
"""

from collections import namedtuple
from fractions import Fraction as F
from itertools import combinations, product

from behaviours import age, age_origin, canonical, horizon, least, offers
from boxes import AXES, Body, Part, approaching, entry, inside, obstacle, on_surface, touching_pairs
from blocked import Blocked
from draws import Draws

__all__ = ['AXES', 'Body', 'Calculus', 'Leaf', 'Part', 'Process', 'State', 'ZERO', 'canonical', 'inside', 'minus',
           'obstacle', 'plus', 'times', 'touching_pairs']


# States ---------------------------------------------------------------------------------

Leaf = namedtuple('Leaf', 'name position behaviour origin')
# bonds: a frozenset of (name, frozenset of two (leaf, part, vertex names))
# draw: while somebody waits to draw, 'waits' or the velocity to come (draws.py)
Process = namedtuple('Process', 'velocity clock leaves bonds draw', defaults=[None])
# step: None, or (time left, 'moving' | 'due' | 'steered')
State = namedtuple('State', 'processes step time')


def plus(u, v):
    return tuple(a + b for a, b in zip(u, v))


def minus(u, v):
    return tuple(a - b for a, b in zip(u, v))


def times(k, u):
    return tuple(k * a for a in u)


ZERO = (F(0), F(0), F(0))


class Calculus(Draws, Blocked):
    def __init__(self, bodies, definitions, timestep, split_step, together=False, by_contact=False, cyclic=False,
                 blocked='bounce', steady=False):
        self.blocked, self.steady = blocked, steady
        self.together, self.by_contact, self.cyclic = together, by_contact, cyclic
        self.bodies = bodies
        self.definitions = definitions
        self.timestep = timestep
        self.split_step = split_step
        self.steered = any(b.law for b in bodies.values())

    # Processes

    def process(self, velocity, leaves, bonds):
        """With its split clock just set, if it needs one."""
        p = Process(velocity, None, tuple(sorted(leaves)), frozenset(bonds))
        return p._replace(clock=F(0)) if self.weak_splits(p) else p

    def state(self, processes, step, time):
        return State(tuple(sorted(processes, key=lambda p: p.leaves[0].name)), step, time)

    def fixed(self, p):
        return any(self.bodies[l.name].fixed for l in p.leaves)

    def mass(self, p):
        return sum(self.bodies[l.name].mass for l in p.leaves)

    def become(self, leaf, behaviour):
        origin = behaviour[1] if behaviour[0] == 'name' else None
        return leaf._replace(behaviour=behaviour, origin=origin)

    def horizon(self, p):
        return least([horizon(l.behaviour, self.definitions) for l in p.leaves])

    def leaf_offers(self, leaf, kind):
        return [o for o in offers(leaf.behaviour, self.definitions) if o[0][0] == kind]

    def active(self, sites, part, feature):
        """Is the feature of the part in the closure of the sites?"""
        return any(part == s[0] and feature <= s[1] for s in sites)

    # Collisions

    def part_pairs(self, p, q):
        for l in p.leaves:
            for m in q.leaves:
                for a in self.bodies[l.name].parts:
                    for b in self.bodies[m.name].parts:
                        yield l, a, m, b, obstacle(a, b), minus(m.position, l.position)

    def collisions(self, state):
        """All (P, Q, the pairs of parts that touch and approach)."""
        found = []
        for p, q in combinations(state.processes, 2):
            pairs = self.approaching_parts(p, q)
            if pairs or (self.by_contact and self.candidates(p, q)):
                found.append((p, q, pairs))
        return found

    def approaching_parts(self, p, q):
        w = minus(q.velocity, p.velocity)
        return [x for x in self.part_pairs(p, q) if approaching(x[4], x[5], w)]

    def candidates(self, p, q):
        """Rule Bind, of two that collide: (bond, the two leaves continued). All their parts that touch (I-12)."""
        found = []
        for l, a, m, b, box, offset in self.part_pairs(p, q):
            touching = touching_pairs(a, b, offset) if on_surface(box, offset) else []
            for o1, rest1 in self.leaf_offers(l, 'open'):
                for o2, rest2 in self.leaf_offers(m, 'open'):
                    if o1[1] != o2[1] or o1[2] == o2[2]:
                        continue
                    such = [(d, f, g) for d, f, g in touching
                            if self.active(o1[3], a.name, f) and self.active(o2[3], b.name, g)]
                    highest = max([d for d, _, _ in such], default=None)
                    for d, f, g in such:
                        if d == highest:
                            bond = (o1[1], frozenset([(l.name, a.name, f), (m.name, b.name, g)]))
                            found.append((bond, self.become(l, rest1), self.become(m, rest2)))
        return found

    def bind(self, p, q, candidate):
        bond, new_l, new_m = candidate
        changed = {new_l.name: new_l, new_m.name: new_m}
        leaves = [changed.get(l.name, l) for l in p.leaves + q.leaves]
        if self.fixed(p) or self.fixed(q):
            velocity = ZERO
        else:
            mp, mq = self.mass(p), self.mass(q)
            velocity = times(1 / F(mp + mq), plus(times(mp, p.velocity), times(mq, q.velocity)))
        return self.process(velocity, leaves, p.bonds | q.bonds | {bond})

    def closings(self, p):
        """Rule Close: (bond, the process with it), of two leaves that no bond joins."""
        found = []
        for l, m in combinations(p.leaves, 2) if self.cyclic else ():
            if any({l.name, m.name} == {e[0] for e in ends} for _, ends in p.bonds):
                continue
            for bond, new_l, new_m in self.candidates(p._replace(leaves=(l,)), p._replace(leaves=(m,))):
                leaves = [new_l if x is l else new_m if x is m else x for x in p.leaves]
                found.append((bond, self.process(p.velocity, leaves, p.bonds | {bond})))
        return found

    def directions(self, p, q, approaching_pairs):
        """The separating directions of reading I-13, as (axis, sign)."""
        touching = [x for x in self.part_pairs(p, q) if on_surface(x[4], x[5])]

        def signs(x, i):
            """On which sides of the present offset the obstacle lies, near it."""
            box, at = x[4], x[5]
            return [s for s in (-1, 1) if (at[i] > box[i][0] or s > 0) and (at[i] < box[i][1] or s < 0)]

        def octants(x):
            return set(product(*[signs(x, i) for i in AXES]))

        kept, every = set(), set()
        for x in approaching_pairs:
            box, at = x[4], x[5]
            others = set()
            for y in touching:
                if y[1] is not x[1] or y[3] is not x[3]:
                    others |= octants(y)
            for i in AXES:
                for side in (-1, 1):
                    if at[i] != box[i][0 if side < 0 else 1]:
                        continue
                    every.add((i, side))
                    # The octants just outside the facet: all covered by other pairs?
                    outside = [tuple(side if j == i else o[j] for j in AXES) for o in octants(x)]
                    if not all(o in others for o in outside):
                        kept.add((i, side))
        return kept or every

    def bounce(self, met):
        """All that collide at once: q + 2 proj(-q). Boxes push each other along the axes, each by itself."""
        members = sorted({x for p, q, _ in met for x in (p, q)}, key=lambda p: p.leaves[0].name)
        after = {p: list(p.velocity) for p in members}
        for i in AXES:
            rows = [(p, q, side) for p, q, pairs in met for axis, side in self.directions(p, q, pairs) if axis == i]
            for p, change in self.pushed(members, rows, i).items():
                after[p][i] += 2 * change
        return members, [self.process(tuple(after[p]), p.leaves, p.bonds) for p in members]

    def pushed(self, members, rows, i):
        """The projection of minus the velocities on the cone of the rows: all sets of rows that may push are tried."""
        weight = {p: 1 / F(self.mass(p)) if self.yields(p) else F(0) for p in members}
        speed = [side * (q.velocity[i] - p.velocity[i]) for p, q, side in rows]

        def change(row, p):
            first, second, side = row
            return weight[p] * side * ((p is second) - (p is first))

        def gain(row, by):
            first, second, side = row
            return side * (change(by, second) - change(by, first))
        for size in range(len(rows) + 1):
            for chosen in combinations(range(len(rows)), size):
                x = solved([[gain(rows[k], rows[l]) for l in chosen] for k in chosen], [-speed[k] for k in chosen])
                if x is None or any(a < 0 for a in x):
                    continue
                if all(speed[k] + sum(a * gain(row, rows[l]) for a, l in zip(x, chosen)) >= 0
                       for k, row in enumerate(rows)):
                    return {p: sum((a * change(rows[l], p) for a, l in zip(x, chosen)), F(0)) for p in members}
        raise AssertionError('no projection')

    def clusters(self, met):
        """What is resolved at once: one by one (I-8), or all that hang together by what moves (I-32)."""
        found = []
        for x in met:
            if self.stopping(*x):
                continue
            mine = [x]
            for other in list(found):
                shared = {p for m in other for p in m[:2]} & set(x[:2])
                if self.together and any(self.yields(p) for p in shared):
                    found.remove(other)
                    mine = other + mine
            found.append(mine)
        return found

    # Splits

    def weak_splits(self, p):
        """Rule WeakSplit: (bond, changed leaves)."""
        leaves = {l.name: l for l in p.leaves}
        found = []
        for bond in p.bonds:
            (l1, part1, f1), (l2, part2, f2) = bond[1]
            for o1, rest1 in self.leaf_offers(leaves[l1], 'weak'):
                for o2, rest2 in self.leaf_offers(leaves[l2], 'weak'):
                    if (o1[1] == bond[0] == o2[1] and self.active(o1[2], part1, f1)
                            and self.active(o2[2], part2, f2)):
                        found.append((bond, [self.become(leaves[l1], rest1), self.become(leaves[l2], rest2)]))
        return found

    def strong_splits(self, p):
        """Rule StrongSplit: (set of bonds, changed leaves), by trying all sets."""
        leaves = {l.name: l for l in p.leaves}
        found = []
        bonds = sorted(p.bonds, key=repr)
        for size in range(1, len(bonds) + 1):
            for chosen in combinations(bonds, size):
                if not connected(chosen):
                    continue
                ends = sorted({end[0] for b in chosen for end in b[1]})
                choices = []
                for name in ends:
                    mine = [(b[0], end) for b in chosen for end in b[1] if end[0] == name]
                    choices.append([self.become(leaves[name], rest)
                                    for o, rest in self.leaf_offers(leaves[name], 'strong')
                                    if self.matches(list(o[1]), mine)])
                for changed in product(*choices):
                    found.append((frozenset(chosen), list(changed)))
        return found

    def matches(self, entries, ends):
        """One to one."""
        if len(entries) != len(ends):
            return False
        if not entries:
            return True
        name, (_, part, feature) = ends[0]
        return any(entries[i][0] == name and self.active(entries[i][1], part, feature)
                   and self.matches(entries[:i] + entries[i + 1:], ends[1:])
                   for i in range(len(entries)))

    def split(self, p, released, changed):
        changed = {l.name: l for l in changed}
        leaves = [changed.get(l.name, l) for l in p.leaves]
        bonds = p.bonds - released
        pieces = []
        while leaves:
            names = {leaves[0].name}
            while True:
                more = {e[0] for b in bonds for e in b[1] if names & {x[0] for x in b[1]}} - names
                if not more:
                    break
                names |= more
            mine = [b for b in bonds if any(e[0] in names for e in b[1])]
            pieces.append(self.process(p.velocity, [l for l in leaves if l.name in names], mine))
            leaves = [l for l in leaves if l.name not in names]
        return pieces

    # Time and steering

    def first_time_of_binding(self, p, q):
        """Reading I-33: the least time at which features meet that are open on compatible channels."""
        w = minus(q.velocity, p.velocity)
        for l, a, m, b, _, offset in self.part_pairs(p, q):
            for o1, _ in self.leaf_offers(l, 'open'):
                for o2, _ in self.leaf_offers(m, 'open'):
                    if o1[1] != o2[1] or o1[2] == o2[2]:
                        continue
                    for f, fe in a.features.items():
                        for g, ge in b.features.items():
                            if self.active(o1[3], a.name, f) and self.active(o2[3], b.name, g):
                                yield first_meeting(fe, ge, offset, w)

    def first_time_of_contact(self, state):
        times_ = []
        if self.by_contact:
            times_ += [t for p, q in combinations(state.processes, 2) for t in self.first_time_of_binding(p, q)]
        for p, q in combinations(state.processes, 2):
            w = minus(q.velocity, p.velocity)
            times_ += [entry(x[4], x[5], w) for x in self.part_pairs(p, q)]
        return least(times_)

    def delay(self, state, jump):
        splits = [self.split_step - p.clock for p in state.processes if p.clock is not None]
        step = state.step[0] if state.step and (self.steerable(state) or not jump) else None
        return least([step, self.first_time_of_contact(state)]
                     + [self.horizon(p) for p in state.processes] + splits)

    def steerable(self, state):
        return any(self.under_law(p) for p in state.processes)

    def pass_time(self, state, d):
        processes = []
        for p in state.processes:
            leaves = []
            for l in p.leaves:
                new = age(l.behaviour, d, self.definitions)
                origin = age_origin(l.behaviour, l.origin, d, self.definitions)
                leaves.append(Leaf(l.name, plus(l.position, times(d, p.velocity)), new, origin))
            aged = self.process(p.velocity, leaves, p.bonds)
            if {bond for bond, _ in self.weak_splits(aged)} <= {bond for bond, _ in self.weak_splits(p)}:
                aged = aged._replace(clock=None if p.clock is None else (p.clock + d) % self.split_step)
            processes.append(aged)
        step = None
        if state.step:
            left = state.step[0] - d
            while left < 0:  # rule Jump: the steps passed over steer nothing
                left += self.timestep
            step = (left, 'due' if left == 0 else 'moving')
        return self.state(processes, step, state.time + d)

    def settle(self, state):
        """Rule Steer, if it is due and nothing collides, or the draws to come before."""
        state = self.stopped(state)
        if state.step and state.step[1] == 'due' and not self.collisions(state):
            dt = self.timestep - state.step[0]
            return self.waiting(state, dt) or self.steer(state, dt)
        return state

    def steer(self, state, dt):
        processes, drawn = [], [p.leaves[0].name for p in state.processes if self.chooses(p)]
        for p in state.processes:
            if p.draw is not None:
                p = p._replace(velocity=p.draw, draw=None)
            elif not self.fixed(p):
                (velocity,) = self.choices(p, state.time, dt)
                p = p._replace(velocity=velocity)
            processes.append(p)
        after = self.state(processes, (self.timestep, 'steered'), state.time)
        return self.stopped(self.waiting_for_room(after, drawn))

    def initial(self, processes):
        s = self.state(processes, None, F(0))
        if self.steered:
            s = self.settle(s._replace(step=(self.timestep, 'due')))
        return s

    # Rule Successors

    def successors(self, state, jump=False):
        """All transitions: a set of (label, next state). Where all that has a law is held by something
        fixed, steps steer nothing, and time may jump over their ends."""
        first = self.first_to_draw(state)
        if first:
            return self.draws(state, first, self.timestep - state.step[0])
        found = set()

        def replace(old, new, step):
            processes = [p for p in state.processes if p not in old] + list(new)
            return self.settle(self.state(processes, step, state.time))

        urgent = False
        for p in state.processes:
            for bonds, changed in self.strong_splits(p):
                urgent = True
                found.add((('strong', bonds), replace([p], self.split(p, bonds, changed), state.step)))
            for bond, whole in self.closings(p):
                urgent = True
                found.add((('close', bond), replace([p], [whole], state.step)))
            if p.clock == 0:
                for bond, changed in self.weak_splits(p):
                    pieces = self.split(p, frozenset([bond]), changed)
                    found.add((('weak', bond), replace([p], pieces, state.step)))
        step = state.step
        if step and step[1] == 'moving' and not self.steady:
            step = (step[0], 'due')
        for cluster in self.clusters(self.collisions(state)):
            urgent = True
            bindings = [(p, q, candidate) for p, q, _ in cluster for candidate in self.candidates(p, q)]
            for p, q, candidate in bindings:
                label = ('bind', candidate[0])
                found.add((label, replace([p, q], [self.bind(p, q, candidate)], step)))
            if not bindings:
                members, after = self.bounce(cluster)
                between = frozenset([frozenset(l.name for l in x.leaves) for x in members])
                found.add((('bounce', between), replace(members, after, step)))
        if not urgent:
            d = self.delay(state, jump)
            if d is not None:
                found.add((('time', d), self.settle(self.pass_time(state, d))))
        return found


def connected(bonds):
    reached, left = [bonds[0]], list(bonds[1:])
    while True:
        ends = {e[0] for b in reached for e in b[1]}
        near = [b for b in left if ends & {e[0] for e in b[1]}]
        if not near:
            return not left
        reached += near
        left = [b for b in left if b not in near]


def solved(rows, right):
    """The solution of a square system, or None."""
    rows = [list(r) + [b] for r, b in zip(rows, right)]
    for c in range(len(rows)):
        pivot = next((r for r in range(c, len(rows)) if rows[r][c] != 0), None)
        if pivot is None:
            return None
        rows[c], rows[pivot] = rows[pivot], rows[c]
        for r in range(len(rows)):
            if r != c:
                factor = rows[r][c] / rows[c][c]
                rows[r] = [x - factor * y for x, y in zip(rows[r], rows[c])]
    return [row[-1] / row[c] for c, row in enumerate(rows)]


def first_meeting(f, g, offset, w):
    """The least t >= 0 at which f and g + offset + t w have a point in common, for products of closed intervals."""
    start, end = F(0), None
    for i in AXES:
        low, high = f[i][0] - g[i][1] - offset[i], f[i][1] - g[i][0] - offset[i]
        if w[i] == 0:
            if low > 0 or high < 0:
                return None
            continue
        one, two = sorted([low / F(w[i]), high / F(w[i])])
        start = max(start, one)
        end = two if end is None else min(end, two)
    return start if end is None or start <= end else None
