"""Means of what runs earn until g, and of numbers at a time (*Expectation*)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any, Callable, Dict, List, Optional, Tuple, Union

import process
from formulas import Evaluator, plain
from graph import QUARTERS, Graph, Truth
from process import Choice
from runs import EVER, WON, Node, Option, Until

INFINITE = "infinite"
Mean = Union[Fraction, str, None]
Earned = Callable[[Option], Fraction]


def time_passed(option: Option) -> Fraction:
    return Fraction(option.quarters, QUARTERS)


def events_counted(letters: str) -> Earned:
    """All that happens of which e is one of the letters, in the mean of a draw."""
    def earned(option: Option) -> Fraction:
        return sum((b.probability * sum(x in letters for x in b.events) for b in option.branches), Fraction(0))

    return earned


def until(graph: Graph, g: Truth, favour: bool, earned: Earned, greatest: bool) -> Mean:
    """The mean of what is earned until g, from the initial state."""
    runs = Until(graph, EVER, graph.always(), g, favour)
    start = runs.enter(0, 0)
    nodes = process.explore([start], lambda n: [replace(plain(o), earned=earned(o)) for o in runs.options(n)])
    if start not in (process.is_sure if greatest else process.can_be_sure)(nodes, {WON}):
        return INFINITE
    if greatest:
        return process.solve(nodes, {WON: Fraction(0)}, process.first_choices(nodes), True)[start]
    sure = process.can_be_sure(nodes, {WON})
    inner = process.within(nodes, sure)
    return process.solve(inner, {WON: Fraction(0)}, process.towards(inner, {WON}), False)[start]


class NoValue(Exception):
    """The mean of a number at a time is undecided."""


class At:
    """The process of `x at t`: pairs of a state and the elapsed time. Its ends are the numbers taken."""

    def __init__(self, graph: Graph, values: List[Optional[List[int]]], t: Fraction) -> None:
        self.graph, self.values, self.t = graph, values, t

    def taken(self, s: int, offset: Fraction) -> Fraction:
        value = self.values[s]
        if value is None:
            raise NoValue
        return value[0] + value[1] * offset

    def choices(self, node: Node) -> List[Choice]:
        s, elapsed = node
        state = self.graph.states[s]
        if not state.known:
            raise NoValue
        ways: List[Tuple[Tuple[Fraction, Node], ...]] = [((Fraction(1), (t, elapsed)),) for t in state.chosen]
        if state.drawn:
            ways.append(tuple((p, (t, elapsed)) for p, t in state.drawn))
        passing = state.trajectory
        if passing is not None:
            if passing.time is None or elapsed + passing.time > self.t:
                ways.append(((Fraction(1), self.taken(s, self.t - elapsed)),))
            else:
                ways += [((Fraction(1), (t, elapsed + passing.time)),) for t in passing.to]
        elif not ways:
            ways.append(((Fraction(1), self.over(s, elapsed)),))
        return [Choice(Fraction(0), way) for way in ways]

    def over(self, s: int, elapsed: Fraction) -> Fraction:
        """A dead end has a number only if it is come to at t."""
        if elapsed < self.t:
            raise NoValue
        return self.taken(s, Fraction(0))

    def mean(self, greatest: bool) -> Mean:
        start = (0, Fraction(0))
        try:
            nodes = process.explore([start], self.choices)
        except NoValue:
            return None
        numbers = {n for choices in nodes.values() for c in choices for n in c.nodes() if n not in nodes}
        if start not in process.is_sure(nodes, numbers):
            return None
        return process.solve(nodes, {n: n for n in numbers}, process.first_choices(nodes), greatest)[start]


def mean(evaluator: Evaluator, question: Dict[str, Any]) -> Tuple[Mean, Mean]:
    """The least and the most of a mean of README.md."""
    graph, greatest = evaluator.graph, question["which"] == "Emax"
    if "values" in question:
        value = At(graph, question["values"], Fraction(question["at"])).mean(greatest)
        return value, value

    def one(favour: bool) -> Mean:
        if "time until" in question:
            return until(graph, evaluator.truth(question["time until"], favour), favour, time_passed, greatest)
        counted = events_counted("T" if favour else "T?")
        return until(graph, evaluator.truth(question["events until"], favour), favour, counted, greatest)

    return one(True), one(False)
