"""The truth of formulas, and probabilities (*Next*, *Until*, *Intervals*, *Probability*, *Truncated*).

Each is evaluated twice: with `favour` everything that is not known is taken for it, and without it, against it.
"""

from __future__ import annotations

import operator
from fractions import Fraction
from typing import Any, Callable, Dict, List, Optional, Set, Tuple

import process
from graph import Graph, Truth, mapped
from process import Choice, Process
from runs import WON, Node, Option, Until, window

Formula = Any
Letters = Tuple[str, List[Optional[str]]]
Numbers = Tuple[List[Fraction], List[Optional[List[Fraction]]]]
TESTS: Dict[str, Callable[[Fraction, Fraction], bool]] = {
    "<": operator.lt, "<=": operator.le, ">=": operator.ge, ">": operator.gt}
OTHER = {"Pmin": "Pmax", "Pmax": "Pmin", "A": "E", "E": "A"}


def negation(truth: Truth) -> Truth:
    return Truth([not x for x in truth.states], mapped(operator.not_, truth.along))


def joined(how: Callable[[Any], bool], truths: List[Truth]) -> Truth:
    """`all` or `any` of truths."""
    along = [a and [how(column) for column in zip(*(t.along[s] or [] for t in truths))]
             for s, a in enumerate(truths[0].along)]
    return Truth([how(column) for column in zip(*(t.states for t in truths))], along)


def plain(option: Option) -> Choice:
    return Choice(Fraction(0), tuple((b.probability, b.node) for b in option.branches))


class Evaluator:
    """What is true in one graph."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self._known: Dict[Tuple[str, bool], Truth] = {}

    def truth(self, formula: Formula, favour: bool) -> Truth:
        key = (str(formula), favour)
        if key not in self._known:
            self._known[key] = self._truth(formula, favour)
        return self._known[key]

    def _truth(self, formula: Formula, favour: bool) -> Truth:
        if isinstance(formula, str):
            return self.graph.predicate(formula, favour)
        head, rest = formula[0], formula[1:]
        if head == "not":
            return negation(self.truth(rest[0], not favour))
        if head in ("and", "or"):
            return joined(all if head == "and" else any, [self.truth(f, favour) for f in rest])
        if head == "X":
            if rest[0] == "A":
                return negation(self.next(self.truth(["not", rest[1]], not favour), not favour))
            return self.next(self.truth(rest[1], favour), favour)
        quantifier, body = rest[0], [head] + rest[1:]
        if isinstance(quantifier, str):
            return self.quantified(quantifier, body, favour)
        which, test, bound = quantifier
        return self.tested(which, test, Fraction(bound), body, favour)

    def next(self, f: Truth, favour: bool) -> Truth:
        """EX f: where some run takes a discrete transition, and f holds where the first leads."""
        states = self.graph.states
        holds = [any(f.states[t] for t in s.discrete) if s.known else favour for s in states]
        more = True
        while more:
            more = False
            for i, s in enumerate(states):
                if not holds[i] and any(holds[t] for t in s.ends):
                    holds[i] = more = True
        return self.graph.truth(lambda s: holds[s], lambda s, i: any(holds[t] for t in states[s].ends))

    def until(self, body: Formula, favour: bool) -> Until:
        """The process of `F` and `U`."""
        head, bounds, *sides = body
        f = self.graph.always() if head == "F" else self.truth(sides[0], favour)
        return Until(self.graph, window(bounds), f, self.truth(sides[-1], favour), favour)

    def explored(self, until: Until) -> Tuple[Process, List[Node], List[Optional[List[List[Node]]]]]:
        states, inside = until.starts()
        starts = states + [n for a in inside for nodes in a or [] for n in nodes]
        return process.explore(starts, lambda n: [plain(o) for o in until.options(n)]), states, inside

    def quantified(self, quantifier: str, body: Formula, favour: bool) -> Truth:
        if body[0] == "G":
            return negation(self.quantified(OTHER[quantifier], opposite(body), not favour))
        nodes, states, inside = self.explored(self.until(body, favour))
        some = quantifier == "E"
        won: Set[Node] = (process.some_run if some else process.all_runs)(nodes, {WON})
        how = any if some else all
        return Truth([n in won for n in states], mapped(lambda ns: how(n in won for n in ns), inside))

    def tested(self, which: str, test: str, bound: Fraction, body: Formula, favour: bool) -> Truth:
        """Doubts of a test that the probability is small are those of a negation."""
        states, inside = self.probability(which, body, favour if test in (">=", ">") else not favour)
        holds = TESTS[test]
        return Truth([holds(x, bound) for x in states], mapped(lambda x: holds(x, bound), inside))

    def probability(self, which: str, body: Formula, favour: bool) -> Numbers:
        """Pmin or Pmax in each state and on each piece."""
        if body[0] == "G":
            states, inside = self.probability(OTHER[which], opposite(body), not favour)
            return [1 - x for x in states], mapped(lambda x: 1 - x, inside)
        nodes, starts, pieces = self.explored(self.until(body, favour))
        values = process.probabilities(nodes, WON, which == "Pmax")
        best = max if which == "Pmax" else min

        def value(node: Node) -> Fraction:
            return values.get(node, Fraction(0))

        return [value(n) for n in starts], mapped(lambda nodes: best(map(value, nodes)), pieces)

    def letters(self, formula: Formula) -> Letters:
        """The truth as README.md writes it."""
        against, favour = self.truth(formula, False), self.truth(formula, True)
        along = zip(against.along, favour.along)
        return text(against.states, favour.states), [text(a, b) if a and b else None for a, b in along]


def opposite(body: Formula) -> Formula:
    """`F` not f, of `G` f."""
    return ["F", body[1], ["not", body[2]]]


def text(against: List[bool], favour: List[bool]) -> str:
    return "".join("T" if a else "?" if b else "." for a, b in zip(against, favour))
