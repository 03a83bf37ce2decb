"""Shows that the comparison can fail: rules are broken on this side, one by one.

    teeth.py --graphs PATH [--lines N] [--seed S] [NAME ...]

Each of these mistakes has to be noticed on one of N random graphs, and is told with the first such line.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from fractions import Fraction
from typing import Any, Dict, List, Set, Tuple

import compare
import formulas
import means
import process
from formulas import Evaluator
from graph import Graph
from means import At, NoValue
from process import Choice, Process
from runs import LOST, WON, Node, Option, Until, Window

Change = Tuple[Any, str, Any]

_decided, _enter, _along, _options = Until.decided, Until.enter, Until.along, Until.options
_choices, _next = At.choices, Evaluator.next
_until, _counted = means.until, means.events_counted
_truth, _tested, _probability = Evaluator._truth, Evaluator.tested, Evaluator.probability


def strict_end(self: Window, elapsed: int) -> bool:
    return self.b is not None and elapsed >= self.b


def late_interval(self: Window, elapsed: int) -> bool:
    """b has not passed yet on an open interval that begins at b."""
    return self.b is not None and elapsed - elapsed % 2 > self.b


def strict_beginning(self: Window, elapsed: int) -> bool:
    return self.a < elapsed and not self.passed(elapsed)


def f_not_before_a(self: Until, f: bool, g: bool, elapsed: int, instant: bool) -> Any:
    return _decided(self, f or elapsed < self.times.a, g, elapsed, instant)


def closed_interval(self: Until, f: bool, g: bool, elapsed: int, instant: bool) -> Any:
    """An open interval has a first position."""
    return _decided(self, f, g, elapsed, True)


def f_at_g(self: Until, f: bool, g: bool, elapsed: int, instant: bool) -> Any:
    """f has to hold at the position of g as well."""
    return _decided(self, f, g, elapsed, False)


def now_does_not_count(self: Until, f: bool, g: bool, elapsed: int, instant: bool) -> Any:
    """g counts only after the first instant."""
    return _decided(self, f, g and elapsed > 0, elapsed, instant)


def ends_of_intervals(self: Until, offset: int) -> int:
    """A run comes to g on an open interval where this ends."""
    return offset + -offset % 4


def rests_won(self: Until, s: int, offset: int, elapsed: int) -> Any:
    """A run that comes to rest has come to g."""
    found, ways = _along(self, s, offset, elapsed)
    resting = not self.graph.states[s].ends
    return found, [(t, WON if resting and n == LOST else n) for t, n in ways]


def first_end(self: Until, s: int, offset: int, elapsed: int) -> Any:
    """A trajectory leads to one state."""
    found, ways = _along(self, s, offset, elapsed)
    return found, ways[:1]


def no_time_where_something_happens(self: Until, node: Node) -> List[Option]:
    found = _options(self, node)
    return [o for o in found if o.discrete] or found


def draws_are_chosen(self: Until, node: Node) -> List[Option]:
    branches = [(o, replace(b, probability=Fraction(1))) for o in _options(self, node) for b in o.branches]
    return [replace(o, branches=(b,)) for o, b in branches]


def named_once(self: Until, node: Node) -> List[Option]:
    """Of two branches to one state the last counts, for both."""
    def once(o: Option) -> Option:
        kept = {b.state: b for b in o.branches}
        total = sum(b.probability for b in kept.values())
        return replace(o, branches=tuple(replace(b, probability=b.probability / total) for b in kept.values()))

    return [once(o) for o in _options(self, node)]


def unknown_before_f(self: Until, s: int, elapsed: int) -> Node:
    """In an unknown state f does not matter."""
    known = self.graph.states[s].known
    return WON if not known and self.favour and not self.times.passed(elapsed) else _enter(self, s, elapsed)


def unknown_before_g(self: Until, s: int, elapsed: int) -> Node:
    """In an unknown state g does not count."""
    return LOST if not self.graph.states[s].known and not self.favour else _enter(self, s, elapsed)


def unknown_after_b(self: Until, s: int, elapsed: int) -> Node:
    """In an unknown state it is never too late."""
    return WON if not self.graph.states[s].known and self.favour else _enter(self, s, elapsed)


def dead_ends_hold(choices: List[Choice], to: Set[Node]) -> bool:
    return all(n in to for c in choices for n in c.nodes())


def fair(nodes: Process, goals: Set[Node]) -> Set[Node]:
    """What goes round within one instant, or for ever, is no run."""
    ends = {n for choices in nodes.values() for c in choices for n in c.nodes() if n not in nodes} - goals
    dead = ends | {n for n in nodes if not nodes[n]}
    return (set(nodes) | goals) - process.some_run({n: c for n, c in nodes.items() if n not in goals}, dead)


def next_after_one_trajectory(self: Evaluator, f: Any, favour: bool) -> Any:
    """The first transition comes in this state, or after one trajectory."""
    states = self.graph.states
    now = [any(f.states[t] for t in s.discrete) if s.known else favour for s in states]
    after = [any(now[t] for t in s.ends) for s in states]
    return self.graph.truth(lambda s: now[s] or after[s], lambda s, i: after[s])


def passing_is_next(self: Evaluator, f: Any, favour: bool) -> Any:
    """The end of a trajectory is a next position."""
    found = _next(self, f, favour)
    after = [any(f.states[t] for t in s.ends) for s in self.graph.states]
    along: Any = found.along
    return self.graph.truth(lambda s: found.states[s] or after[s], lambda s, i: along[s][i] or after[s])


def not_keeps_favour(self: Evaluator, formula: Any, favour: bool) -> Any:
    if formula[0] == "not":
        return formulas.negation(self.truth(formula[1], favour))
    return _truth(self, formula, favour)


def tests_keep_favour(self: Evaluator, which: str, test: str, bound: Fraction, body: Any, favour: bool) -> Any:
    """A test that the probability is small is in doubt as one that it is great."""
    return _tested(self, which, test, bound, body, favour == (test in (">=", ">")))


def same_of_g(self: Evaluator, which: str, body: Any, favour: bool) -> Any:
    """Pmin of G is 1 - Pmin of F."""
    return _probability(self, formulas.OTHER[which] if body[0] == "G" else which, body, favour)


def g_not_counted(e: Any) -> Any:
    """The transition that leads to g is not counted."""
    def earned(o: Option) -> Fraction:
        return _counted(e)(replace(o, branches=tuple(b for b in o.branches if b.node != WON)))

    return earned


def passing_counted(e: Any) -> Any:
    """A trajectory counts as well."""
    return lambda o: _counted(e)(o) + (0 if o.discrete else 1)


def counted_once(e: Any) -> Any:
    """A transition counts once, however much happens by it."""
    def earned(o: Option) -> Fraction:
        return sum((b.probability for b in o.branches if any(x in e for x in b.events)), Fraction(0))

    return earned


def doubts_not_counted(e: Any) -> Any:
    return _counted("T")


def of_the_sure(graph: Graph, g: Any, favour: bool, earned: means.Earned, greatest: bool) -> means.Mean:
    """A scheduler that may avoid g does not make Emax infinite."""
    mean = _until(graph, g, favour, earned, greatest)
    return _until(graph, g, favour, earned, False) if mean == means.INFINITE else mean


def going_round(self: At, greatest: bool) -> means.Mean:
    """x at t is about the schedulers by which a run does come to t."""
    start = (0, Fraction(0))
    try:
        nodes = process.explore([start], self.choices)
    except NoValue:
        return None
    numbers = {n for choices in nodes.values() for c in choices for n in c.nodes() if n not in nodes}
    sure = process.can_be_sure(nodes, numbers)
    if start not in sure:
        return None
    inner = process.within(nodes, sure)
    return process.solve(inner, {n: n for n in numbers}, process.towards(inner, numbers), greatest)[start]


def first_position(self: At, node: Node) -> List[Choice]:
    """x is taken at the first position at t."""
    s, elapsed = node
    if elapsed == self.t and self.graph.states[s].known:
        return [Choice(Fraction(0), ((Fraction(1), self.taken(s, Fraction(0))),))]
    return _choices(self, node)


def unknown_at_t(self: At, node: Node) -> List[Choice]:
    """In an unknown state at t x can be taken."""
    s, elapsed = node
    if elapsed == self.t and not self.graph.states[s].known:
        return [Choice(Fraction(0), ((Fraction(1), self.taken(s, Fraction(0))),))]
    return _choices(self, node)


def dead_end_has_value(self: At, s: int, elapsed: Fraction) -> Fraction:
    return self.taken(s, Fraction(0))


def dead_end_has_none(self: At, s: int, elapsed: Fraction) -> Fraction:
    raise NoValue


def held_too_long(self: At, node: Node) -> List[Choice]:
    """At the end of a trajectory x is taken there, too, before the state."""
    s, elapsed = node
    t = self.graph.states[s].trajectory
    ways = _choices(self, node)
    if t is not None and t.time is not None and elapsed + t.time == self.t:
        ways.append(Choice(Fraction(0), ((Fraction(1), self.taken(s, Fraction(t.time))),)))
    return ways


MISTAKES: Dict[str, List[Change]] = {
    "b itself is too late": [(Window, "passed", strict_end)],
    "b passes where an open interval ends": [(Window, "passed", late_interval)],
    "a itself is too early": [(Window, "counts", strict_beginning)],
    "before a f does not matter": [(Until, "decided", f_not_before_a)],
    "an open interval has a first position": [(Until, "decided", closed_interval)],
    "f is needed at g": [(Until, "decided", f_at_g)],
    "now does not count": [(Until, "decided", now_does_not_count)],
    "the time is that of the end of an open interval": [(Until, "reached", ends_of_intervals)],
    "rest is success": [(Until, "along", rests_won)],
    "a trajectory leads to one state": [(Until, "along", first_end)],
    "time waits for what can happen": [(Until, "options", no_time_where_something_happens)],
    "draws are choices": [(Until, "options", draws_are_chosen)],
    "two branches to one state are one": [(Until, "options", named_once)],
    "f does not matter in an unknown state": [(Until, "enter", unknown_before_f)],
    "g does not count in an unknown state": [(Until, "enter", unknown_before_g)],
    "it is never too late in an unknown state": [(Until, "enter", unknown_after_b)],
    "F holds in dead ends": [(process, "every_way", dead_ends_hold)],
    "runs that go round are none": [(process, "all_runs", fair)],
    "all runs are almost all": [(process, "all_runs", process.is_sure)],
    "the next transition comes after one trajectory": [(Evaluator, "next", next_after_one_trajectory)],
    "the passing of time is a next transition": [(Evaluator, "next", passing_is_next)],
    "doubts under not do not change places": [(Evaluator, "_truth", not_keeps_favour)],
    "doubts under tests do not change places": [(Evaluator, "tested", tests_keep_favour)],
    "Pmin of G is by Pmin of F": [(Evaluator, "probability", same_of_g)],
    "the transition to g is not counted": [(means, "events_counted", g_not_counted)],
    "all that happens by a transition is one": [(means, "events_counted", counted_once)],
    "what is undecided of e does not count": [(means, "events_counted", doubts_not_counted)],
    "the passing of time is counted": [(means, "events_counted", passing_counted)],
    "Emin is about all schedulers": [(process, "can_be_sure", process.is_sure)],
    "Emax is about schedulers that are sure": [(means, "until", of_the_sure)],
    "x at t needs no scheduler but those that come to t": [(At, "mean", going_round)],
    "x is taken at the first position": [(At, "choices", first_position)],
    "x is taken in an unknown state": [(At, "choices", unknown_at_t)],
    "x is taken before the end of a trajectory": [(At, "choices", held_too_long)],
    "x has a value after a dead end": [(At, "over", dead_end_has_value)],
    "x has no value in a dead end": [(At, "over", dead_end_has_none)],
}


def notices(line: compare.Line) -> bool:
    return any(told != found for _, _, told, found in compare.answers(line))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--graphs", required=True)
    parser.add_argument("--lines", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args()
    lines = list(compare.read(options.graphs, options.lines, options.seed))
    unnoticed = 0
    for name in options.names or MISTAKES:
        old = [(owner, key, getattr(owner, key)) for owner, key, _ in MISTAKES[name]]
        for owner, key, value in MISTAKES[name]:
            setattr(owner, key, value)
        line = next((number for number, line in enumerate(lines, 1) if notices(line)), None)
        for owner, key, value in old:
            setattr(owner, key, value)
        unnoticed += line is None
        print(f"{name}: {'not noticed' if line is None else f'noticed on line {line}'}", flush=True)
    sys.exit(1 if unnoticed else 0)


if __name__ == "__main__":
    main()
