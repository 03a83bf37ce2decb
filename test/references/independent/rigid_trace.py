"""Checks a trace of a rigid model, transition by transition."""

from fractions import Fraction as F
from math import sqrt

from contacts import distance2_to_line, reflected, touching_point
import rigid as r
from rigid import Difference
import solids as s


def require(condition, text, *details):
    if not condition:
        raise Difference(text % tuple(map(r.show, details)) if details else text)


# What lasts between an instant and the next of a grid that is perhaps finer than the one it is measured by.
FRACTIONS = [F(n, 16) for n in (16, 12, 8, 14, 10, 6, 4, 2, 1)] + [F(1, 2 ** k) for k in (5, 6, 7, 8, 10, 12)]

LATER = FRACTIONS + [F(3, 2), F(2), F(3), F(4), F(8)]


class Check:
    """One model. `samples`: instants between two states at which it is looked for interpenetration."""

    def __init__(self, bodies, timestep, resolution, free, orientation, velocity, samples=5):
        self.bodies, self.timestep, self.resolution, self.free = bodies, timestep, resolution, free
        self.orientation, self.velocity, self.samples = orientation, velocity, samples
        self.seen = {}

    def found(self, kind):
        self.seen[kind] = self.seen.get(kind, 0) + 1

    def run(self, lines, longest=20000):
        """All lines of a trace; stops early where numbers have grown too long."""
        state, pending = None, None
        for j in lines:
            if j['type'] == 'state':
                state = r.State(self.bodies, j['state'])
                self.invariants(state)
                require(all(p.since == 0 for p in state.processes), 'a turn goes on at the start')
                self.apart(state, F(0))
            elif j['type'] == 'transition':
                if len(str(j)) > longest:
                    self.found('cut')
                    return
                after = r.State(self.bodies, j['state'])
                kind = j['label']['kind']
                try:
                    if pending is not None:
                        # Time stopped and turns ended before they were over: there must be a contact, if not now
                        # then a little later, as what begins anew turns in another way.
                        require(kind != 'time' or any(self.meets_soon(state.processes, *pair, fractions=LATER)
                                                      for pair in self.pairs(state)),
                                'turns end where nothing collides')
                        pending = None
                    pending = self.transition(kind, j, state, after)
                    self.invariants(after)
                except Difference as d:
                    raise Difference('step %d, %s: %s' % (j['step'], j['label']['text'], d))
                self.found(kind)
                state = after
            elif j['type'] == 'end':
                self.found('end ' + j['ending'])
                if j['ending'] == 'stuck':
                    require(any(self.meets_soon(state.processes, *pair) for pair in self.pairs(state)),
                            'stuck, and nothing collides')

    def pairs(self, state):
        ps = state.processes
        return [(i, j) for i in range(len(ps)) for j in range(i) if not (ps[i].fixed and ps[j].fixed)]

    # Invariants of states

    def invariants(self, state):
        self.apart(state, F(0))
        for i, p in enumerate(state.processes):
            name = p.leaves[0].name
            if p.lasts is None:
                require(p.since == 0, 'a turn of %s is due and goes on', name)
                require(any(i in pair and self.meets_soon(state.processes, *pair, fractions=LATER)
                            for pair in self.pairs(state)), 'a turn of %s is due, and it does not collide', name)
            elif p.spin == s.ZERO:
                require(p.since == p.lasts == 0, 'the turn of %s, which does not spin', name)
            else:
                require(0 <= p.since < p.lasts, 'the turn of %s is over', name)
                require(s.dot(p.spin, p.spin) * p.lasts ** 2 <= F(1, 4), 'the turn of %s is too long', name)
                require(self.free or p.lasts == r.turn_length(self.timestep, p.spin), 'the turn of %s is too short', name)

    def apart(self, state, t):
        """No two parts of different processes interpenetrate t after the state."""
        for i, j in self.pairs(state):
            if self.overlap(state.processes[i], state.processes[j], t):
                raise Difference('%s and %s interpenetrate at %s' % (
                    state.processes[i].leaves[0].name, state.processes[j].leaves[0].name, t))

    def overlap(self, p, q, t):
        """Far pairs are told apart by balls, in floats with room to spare."""
        if not (p.fixed or q.fixed):
            d = [float(a + t * b) for a, b in zip(s.sub(p.centre(), q.centre()), s.sub(p.velocity, q.velocity))]
            if sqrt(s.dot(d, d)) > 1.001 * (sqrt(p.reach2()) + sqrt(q.reach2())) + 1e-6:
                return False
        return any(s.interpenetrate(a, b) for a in p.parts(t) for b in q.parts(t))

    # Collisions

    def grid(self, p, q):
        """A step that is no less than that of the grid on which contacts of some of their parts are looked for."""
        w = sqrt(sum(float(a) ** 2 for a in s.sub(p.velocity, q.velocity)))
        w += sum(sqrt(s.dot(o.spin, o.spin)) * sqrt(o.least_reach2()) for o in (p, q) if not o.fixed)
        step = F(1)
        while step * F(w) > self.resolution:
            step /= 2
        return step

    def meets_soon(self, processes, i, j, d=F(0), fractions=FRACTIONS):
        """Time stops at d: they meet before the next instant of the grid, if they go on as they did."""
        p, q = processes[i], processes[j]
        step = self.grid(p, q)
        return any(self.overlap(p, q, d + f * step) for f in fractions)

    def collide(self, state, names):
        i, j = (state.processes.index(state.of(n)) for n in names)
        require(i != j, 'a process collides with itself')
        for k in (i, j):
            p = state.processes[k]
            require(p.since == 0, 'a collision, and %s turns on', p.leaves[0].name)
        if not self.meets_soon(state.processes, i, j):
            raise Difference('%s and %s do not collide' % tuple(names))
        return state.processes[i], state.processes[j]

    def near(self, p, q):
        """Pairs of parts at most the resolution apart (at least: on the axis that is widest): (axis, a, b)."""
        found = []
        for a in p.parts():
            for b in q.parts():
                axis, width2 = s.widest(a, b)
                if width2 <= self.resolution ** 2:
                    found.append((axis, width2, a, b))
        return found

    # Transitions

    def transition(self, kind, j, before, after):
        """Returns whether it claims that something collides in the next state."""
        label, claim = j['label'], None
        if kind == 'time':
            expected = self.time(F(label['duration']), before)
        elif kind == 'bounce':
            expected = self.bounce(j, before, after)
        elif kind == 'bind':
            expected = self.bind(label, before, after)
        elif kind in ('weak', 'strong'):
            expected = self.split(before, after)
        else:
            raise Difference('label')
        rounds = []
        for i, (p, e) in enumerate(zip(after.processes, expected)):
            if e is None:
                rounds.append(None)
                continue
            if e.lasts is not None and not p.same(e):
                # Whoever collides ends its turn.
                d = F(label['duration']) if kind == 'time' else F(0)
                hits = [q for q in self.pairs(before) if self.meets_soon(before.processes, *q, d, LATER)] \
                    if kind == 'time' else [q for q in self.pairs(after)
                                            if self.meets_soon(after.processes, *q, fractions=LATER)]
                require(any(i in pair for pair in hits), str(p.difference(e)))
                self.found('contacts')
                claim, e = True, e.renewed()
            rounds.append(e)
            self.begins(j, p, e)
        if 'Round' in j['rules'] and None not in rounds:
            self.rounded_totals(j, rounds, after.processes)
        return claim

    def begins(self, j, p, e):
        """A turn that is due begins, or not; any other goes on."""
        if p.lasts is None or e.lasts is not None:
            require(p.same(e), str(p.difference(e)))
            return
        options = self.roundings(j, e)
        for n, o in enumerate(options):
            for m, turn in enumerate(o.turns(self.timestep)):
                if p.same(turn):
                    if 'Round' in j['rules']:
                        self.found('waits' if n else 'rounded')
                    if m:
                        self.found('without midway')
                    return
        raise Difference(str(p.difference(options[0].turns(self.timestep)[0])))

    def time(self, d, before):
        """What is expected, if nothing collides."""
        require(0 < d, 'passes %s', d)
        for p in before.processes:
            require(p.spin == s.ZERO or p.since + d <= p.lasts, 'time passes by %s, and the turn of %s is over', d,
                    p.leaves[0].name)
        for i in range(1, self.samples + 1):
            self.apart(before, d * i / (self.samples + 1))
        self.apart(before, d * F(1023, 1024))
        moved = [p.passed(d) for p in before.processes]
        return [p.renewed() if p.spin != s.ZERO and p.since == p.lasts else p for p in moved]

    def bounce(self, j, before, after):
        p, q = self.collide(before, j['label']['between'])
        if self.free:
            require(p.spin == p.rate() and q.spin == q.rate(), 'a collision of spins that are not of now')
        near = self.near(p, q)
        require(near, 'a bounce, and nothing is within the resolution')
        clean = self.single(p, q, near)
        if clean:
            self.found('bounces computed')
            change = dict(zip((p, q), (o.begun().lasting(None) for o in clean)))
            return [change.get(o, o) for o in before.processes]
        if 'Round' in j['rules']:
            # What the two were before they were rounded is not known: totals only.
            self.found('bounces rounded')
            self.rounded_totals(j, before.processes, after.processes, 6 if p.fixed or q.fixed else 0)
            return [None if o in (p, q) else o for o in before.processes]
        p2, q2 = after.of(p.leaves[0].name), after.of(q.leaves[0].name)
        self.conserved(p, q, p2, q2)
        self.line_of_action(p, q, p2, q2)
        if self.free:  # They have the spins of their next turns by now.
            return [None if o in (p, q) else o for o in before.processes]
        return [o if o not in (p, q) else (p2 if o is p else q2).lasting(None) for o in before.processes]

    def conserved(self, p, q, p2, q2):
        energy = sum(o.energy() for o in (p, q) if not o.fixed)
        require(energy == sum(o.energy() for o in (p2, q2) if not o.fixed), 'kinetic energy')
        if not (p.fixed or q.fixed):
            for a, b, c, d in zip(p.momenta(), q.momenta(), p2.momenta(), q2.momenta()):
                require(s.add(a, b) == s.add(c, d), 'momentum')
        for o, o2 in ((p, p2), (q, q2)):
            require(all(a.position == b.position and a.turned == b.turned for a, b in zip(o.leaves, o2.leaves)),
                    'a bounce moves %s', o.leaves[0].name)
            if o.fixed:
                require(o2.velocity == o2.spin == s.ZERO, 'a fixed body moves')

    def line_of_action(self, p, q, p2, q2):
        """If the impulses have a resultant: both bodies are near its line, and it pushes them apart."""
        a, b = (p, p2) if not p.fixed else (q, q2)
        (m0, l0), (m1, l1) = a.momenta(), b.momenta()
        impulse, torque = s.sub(m1, m0), s.sub(l1, l0)
        require(impulse != s.ZERO, 'a bounce without an impulse')
        if s.dot(impulse, torque) != 0:
            self.found('bounces of several lines')
            return
        self.found('bounces along a line')
        x = s.mul(1 / s.dot(impulse, impulse), s.cross(impulse, torque))
        for o in (p, q):
            points = [x for part in o.parts() for x in part.points]  # of all: there can be several impulses
            require(distance2_to_line(points, x, impulse) <= 4 * self.resolution ** 2,
                    'an impulse misses %s', o.leaves[0].name)

    def single(self, p, q, near):
        """The outcome when one corner meets one face, or one edge another, and nothing else is near; else None."""
        if len(near) != 1:
            return None
        axis, width2, a, b = near[0]
        if width2 <= 0:
            return None
        x = touching_point(axis, a, b, 4 * self.resolution)
        if x is None:
            return None
        return reflected(p, q, axis, x)

    def bind(self, label, before, after):
        names = [e.split('.')[0] for e in label['ends']]
        p, q = self.collide(before, names)
        ends = [e.split('.') for e in label['ends']]
        near = [part_of(before, e) for e in ends]
        _, width2 = s.widest(*near)
        require(width2 <= self.resolution ** 2, 'bound at a distance of %s', float(width2) ** 0.5)
        whole = r.bound(p, q, after.of(names[0]).bonds).lasting(None)
        return self.replaced(before, (p, q), [whole], after)

    def split(self, before, after):
        whole = next(p for p in before.processes if all(p.names != o.names for o in after.processes))
        turning = whole.renewed()
        made = [o for o in after.processes if o.names < whole.names]
        require(frozenset().union(*(o.names for o in made)) == whole.names, 'pieces')
        # Where the pieces are after rounding is not where they were split.
        leaves = {l.name: l for l in whole.leaves}
        pieces = [r.piece(turning, o.moved([leaves[l.name] for l in o.leaves])).lasting(None) for o in made]
        if not whole.fixed:
            old, new = r.totals([turning]), r.totals(pieces)
            require(old == new or any(o.fixed for o in made), 'a split keeps %s, not %s', new, old)
        return self.replaced(before, (whole,), pieces, after)

    def replaced(self, before, gone, new, after):
        rest = [p for p in before.processes if p not in gone] + new
        return [next(p for p in rest if p.names == o.names) for o in after.processes]

    # Rounding

    def roundings(self, j, p):
        if 'Round' not in j['rules']:
            return [p]
        return r.roundings(p, self.orientation, self.velocity)

    def rounded_totals(self, j, before, after, skip=0):
        """What rounding is said to have added to momentum, angular momentum and energy, from number `skip` on."""
        told = tuple(map(F, j['rounded']['momentum'] + j['rounded']['angular'] + [j['rounded']['energy']]))
        change = tuple(b - a for a, b in zip(r.totals(before), r.totals(after)))
        require(told[skip:] == change[skip:], 'rounding adds %s, and is said to add %s', change, told)


def part_of(state, end):
    process = state.of(end[0])
    leaf = next(l for l in process.leaves if l.name == end[0])
    name = end[1] if len(leaf.body.parts) > 1 else None
    return s.Placed(leaf.body.parts[name], leaf.turned, leaf.position)
