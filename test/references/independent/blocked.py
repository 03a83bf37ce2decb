"""Rule Blocked, written naively: walkers that stop, and kicks that are not taken."""

from itertools import combinations

from boxes import entry, inside

ZERO = (0, 0, 0)


class Blocked:
    def walks(self, p):
        return self.blocked != 'bounce' and self.chooses(p)

    def yields(self, p):
        """Whether it takes a share of the change of a bounce."""
        return not self.fixed(p) and not self.walks(p)

    def stopping(self, p, q, pairs):
        """The walkers that are to stop in what may be a collision without candidates."""
        if not pairs or self.candidates(p, q):
            return []
        p_runs, q_runs = self.meet(p, q._replace(velocity=ZERO)), self.meet(p._replace(velocity=ZERO), q)
        return [x for x, own, other in ((p, p_runs, q_runs), (q, q_runs, p_runs)) if self.walks(x) and (own or not other)]

    def meet(self, p, q):
        return self.approaching_parts(p, q) != []

    def stopped(self, state):
        while self.blocked != 'bounce':
            met = self.collisions(state)
            bound = {x for p, q, _ in met if self.candidates(p, q) for x in (p, q)}
            stops = {x for p, q, pairs in met for x in self.stopping(p, q, pairs)} - bound
            if not stops:
                break
            state = self.standing(state, stops)
        return state

    def standing(self, state, which):
        return state._replace(processes=tuple(p._replace(velocity=ZERO) if p in which else p for p in state.processes))

    def waiting_for_room(self, state, drawn):
        """Kicks that are blocked are taken back: of the processes whose first leaves have drawn."""
        if self.blocked != 'wait':
            return state
        kicked = {p for p in state.processes if p.leaves[0].name in drawn}
        blocked = {x for pair in combinations(state.processes, 2) if kicked & set(pair) and self.run_together(*pair)
                   for x in pair if x in kicked}
        while True:
            more = {p for p in kicked - blocked for q in blocked if self.sweeps_meet(p, q)}
            if not more:
                return self.standing(state, blocked)
            blocked |= more

    def run_together(self, p, q):
        w = tuple(b - a for a, b in zip(p.velocity, q.velocity))
        times = [t for t in (entry(x[4], x[5], w) for x in self.part_pairs(p, q)) if t is not None]
        if not times or min(times) >= self.timestep:
            return False
        return not self.candidates(self.later(p, min(times)), self.later(q, min(times)))

    def later(self, p, t):
        leaves = [l._replace(position=tuple(a + t * v for a, v in zip(l.position, p.velocity))) for l in p.leaves]
        return p._replace(leaves=tuple(leaves))

    def sweeps_meet(self, p, q):
        """Whether two parts interpenetrate, one at some time of its path, the other at any other of its own."""
        return any(meets_within(x[4], x[5], [self.timestep * v for v in p.velocity],
                                [self.timestep * v for v in q.velocity]) for x in self.part_pairs(p, q))


def meets_within(box, at, first, second):
    """Whether at + t second - s first is inside the box for some s and t in [0, 1]. The s for which there is a t
    make an interval; at its ends two bounds of t cross, or one is met whatever t is."""
    bounds = [(0, 1, 1), (0, -1, 0)]
    for i in range(3):
        bounds += [(-first[i], second[i], box[i][1] - at[i]), (first[i], -second[i], at[i] - box[i][0])]
    cuts = {0, 1}
    for (a, b, c), (d, e, f) in combinations(bounds + [(1, 0, 1)], 2):
        if a * e != b * d:
            cuts.add((c * e - b * f) / (a * e - b * d))
    cuts = sorted(s for s in cuts if 0 <= s <= 1)
    return any(some_t(box, at, first, second, s) for s in cuts + [(a + b) / 2 for a, b in zip(cuts, cuts[1:])])


def some_t(box, at, first, second, s):
    """On the segment from t = 0 to t = 1, a coordinate leaves the box at two instants at most."""
    start = [a - s * v for a, v in zip(at, first)]
    cuts = {0, 1}
    for i in range(3):
        if second[i] != 0:
            cuts |= {(edge - start[i]) / second[i] for edge in box[i]}
    cuts = sorted(t for t in cuts if 0 <= t <= 1)
    looks = cuts + [(a + b) / 2 for a, b in zip(cuts, cuts[1:])]
    return any(inside(box, [a + t * v for a, v in zip(start, second)]) for t in looks)
