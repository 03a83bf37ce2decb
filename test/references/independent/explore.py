"""All reachable states of a small model, and properties of its runs decided from them, naively.

A formula is sampled: along a stretch of time its atoms change only at finitely many instants, all
rational here, so it is looked at there and once between any two.
"""

from fractions import Fraction as F

import calculus as c


class TooMany(Exception):
    pass


class Graph:
    """States without absolute time. `edges[s]`: (duration, next state); duration None for no time."""

    def __init__(self, calculus, initial, limit):
        self.calculus = calculus
        self.initial = initial._replace(time=F(0))
        self.edges = {}
        self.jumps = False  # over movement steps that steer nothing: scc may take more or fewer of these
        todo = [self.initial]
        while todo:
            s = todo.pop()
            if s in self.edges:
                continue
            if len(self.edges) >= limit or long_numbers(s):
                raise TooMany()
            jump = not calculus.steerable(s)
            self.jumps |= jump and s.step is not None
            self.edges[s] = [(l[1] if l[0] == 'time' else None, n._replace(time=F(0)))
                             for l, n in calculus.successors(s, jump)]
            todo += [n for _, n in self.edges[s]]

    def transitions(self):
        return sum(len(e) for e in self.edges.values())


def long_numbers(state):
    """A law of motion can double the digits of every number at each collision."""
    return any(a.denominator > 10 ** 9 for p in state.processes for l in p.leaves for a in l.position)


# Formulas -------------------------------------------------------------------------------
# An atom is (text, changes, holds): `changes(state)` are the instants at which it may change on
# the stretch of time that begins in the state, `holds(state, t)` its value t after.


def leaf_of(state, name):
    return next((p, l) for p in state.processes for l in p.leaves if l.name == name)


def coordinate(bodies, name, axis, relation, bound):
    letter = 'xyz'[axis]
    centre = bodies[name].centroid()[axis]

    def changes(state):
        p, l = leaf_of(state, name)
        return [(bound - l.position[axis] - centre) / p.velocity[axis]] if p.velocity[axis] != 0 else []

    def holds(state, t):
        p, l = leaf_of(state, name)
        return RELATIONS[relation](l.position[axis] + centre + t * p.velocity[axis], bound)
    return '%s(%s) %s %s' % (letter, name, relation, bound), changes, holds


RELATIONS = {'=': lambda a, b: a == b, '<=': lambda a, b: a <= b, '<': lambda a, b: a < b,
             '>=': lambda a, b: a >= b, '>': lambda a, b: a > b, '!=': lambda a, b: a != b}


def constant(text, value):
    return text, lambda state: [], lambda state, t: value(state)


def speed(name, axis, relation, bound):
    return constant('v%s(%s) %s %s' % ('xyz'[axis], name, relation, bound),
                    lambda s: RELATIONS[relation](leaf_of(s, name)[0].velocity[axis], bound))


def bonds(name, relation, bound):
    return constant('bonds(%s) %s %s' % (name, relation, bound), lambda s: RELATIONS[relation](
        sum(b[0] == name for p in s.processes for b in p.bonds), bound))


def bound_together(p, q):
    return constant('bound(%s, %s)' % (p, q), lambda s: any(
        {e[0] for e in b[1]} == {p, q} for x in s.processes for b in x.bonds))


def same(p, q):
    return constant('same(%s, %s)' % (p, q), lambda s: leaf_of(s, p)[0] is leaf_of(s, q)[0])


def size(bodies, name, relation, bound):
    return constant('size(%s) %s %s' % (name, relation, bound), lambda s: RELATIONS[relation](
        sum(len(bodies[l.name].parts) for l in leaf_of(s, name)[0].leaves), bound))


def behaviour(name, definition):
    return constant('behaviour(%s) = %s' % (name, definition), lambda s: leaf_of(s, name)[1].origin == definition)


def touching(bodies, p, q):
    def boxes(state):
        (a, l), (b, m) = leaf_of(state, p), leaf_of(state, q)
        w = c.minus(b.velocity, a.velocity)
        offset = c.minus(m.position, l.position)
        return w, offset, [c.obstacle(x, y) for x in bodies[p].parts for y in bodies[q].parts]

    def changes(state):
        w, offset, obstacles = boxes(state)
        return [(edge - offset[i]) / w[i] for box in obstacles for i in c.AXES if w[i] != 0 for edge in box[i]]

    def holds(state, t):
        w, offset, obstacles = boxes(state)
        at = c.plus(offset, c.times(t, w))
        return any(all(box[i][0] <= at[i] <= box[i][1] for i in c.AXES) for box in obstacles)
    return 'touching(%s, %s)' % (p, q), changes, holds


def negation(f):
    return 'not (%s)' % f[0], f[1], lambda s, t: not f[2](s, t)


def conjunction(f, g):
    return '(%s and %s)' % (f[0], g[0]), lambda s: f[1](s) + g[1](s), lambda s, t: f[2](s, t) and g[2](s, t)


def implication(f, g):
    return '((%s) => %s)' % (f[0], g[0]), lambda s: f[1](s) + g[1](s), lambda s, t: not f[2](s, t) or g[2](s, t)


# Properties -----------------------------------------------------------------------------


def instants(formula, state, duration, more=()):
    """Where to look on [0, duration], or on [0, infinity) for None."""
    cuts = {F(0)} | {t for t in list(formula[1](state)) + list(more) if t > 0}
    if duration is not None:
        cuts = {t for t in cuts if t < duration} | {duration}
    cuts = sorted(cuts)
    looks = cuts + [(a + b) / 2 for a, b in zip(cuts, cuts[1:])]
    return sorted(looks + ([cuts[-1] + 1] if duration is None else []))


def somewhere(formula, state, duration, left):
    """Does it hold at some instant of the stretch that is not after `left`?"""
    more = [] if left is None else [left]
    return any(formula[2](state, t) for t in instants(formula, state, duration, more)
               if left is None or t <= left)


def stretches(graph, state):
    """(duration of the stretch or 0, next state); (None, None) for the ray of a quiescent state."""
    edges = graph.edges[state]
    return [(d or F(0), n) for d, n in edges] or [(None, None)]


def possibly(graph, formula, within):
    todo, seen = [(graph.initial, within)], set()
    while todo:
        node = todo.pop()
        if node in seen:
            continue
        seen.add(node)
        state, left = node
        for d, n in stretches(graph, state):
            if somewhere(formula, state, d, left):
                return True
            if n is not None and (left is None or d <= left):
                todo.append((n, None if left is None else left - d))
    return False


def eventually(graph, formula, within):
    """Whether every run, however it goes on, meets it: 'holds' or 'violated'."""
    edges, todo = {}, [(graph.initial, within)]
    while todo:
        node = todo.pop()
        if node in edges:
            continue
        edges[node] = []
        state, left = node
        if formula[2](state, F(0)):
            continue
        for d, n in stretches(graph, state):
            if somewhere(formula, state, d, left):
                continue
            if n is None or (left is not None and d > left):
                return 'violated'
            after = (n, None if left is None else left - d)
            if not formula[2](n, F(0)):
                edges[node].append(after)
                todo.append(after)
    # A run avoids it iff it goes round, within one instant or not: ends are taken away, again and again.
    while True:
        ends = [n for n, e in edges.items() if not any(m in edges for m in e)]
        if not ends:
            return 'violated' if edges else 'holds'
        for n in ends:
            del edges[n]
