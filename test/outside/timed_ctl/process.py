"""Finite decision processes, exactly: what some or all runs come to, probabilities and means.

A process tells of each node what may be chosen there: a list of `Choice`. What is not among its nodes is an
end, as goals are. In a node without a choice a run is over.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Callable, Dict, Iterable, List, Set, Tuple

from runs import Node

ZERO = Fraction(0)


@dataclass(frozen=True)
class Choice:
    """What is earned by the choice, and where it leads, with probabilities."""

    earned: Fraction
    ways: Tuple[Tuple[Fraction, Node], ...]

    def nodes(self) -> List[Node]:
        return [n for _, n in self.ways]


Process = Dict[Node, List[Choice]]
Policy = Dict[Node, Choice]
Values = Dict[Node, Fraction]


def explore(starts: Iterable[Node], choices: Callable[[Node], List[Choice]]) -> Process:
    """All that is reached from the nodes `starts`. A node is an end if it is no tuple."""
    process: Process = {}
    todo = [n for n in starts if isinstance(n, tuple)]
    while todo:
        node = todo.pop()
        if node not in process:
            process[node] = choices(node)
            todo += [n for c in process[node] for n in c.nodes() if isinstance(n, tuple) and n not in process]
    return process


def grown(process: Process, goals: Set[Node], joins: Callable[[List[Choice], Set[Node]], bool]) -> Set[Node]:
    """The least set with the goals in it to which each node belongs that `joins` it."""
    found, more = set(goals), True
    while more:
        more = False
        for node in reversed(process):
            if node not in found and joins(process[node], found):
                found.add(node)
                more = True
    return found


def some_way(choices: List[Choice], to: Set[Node]) -> bool:
    return any(n in to for c in choices for n in c.nodes())


def every_way(choices: List[Choice], to: Set[Node]) -> bool:
    return bool(choices) and all(n in to for c in choices for n in c.nodes())


def every_choice(choices: List[Choice], to: Set[Node]) -> bool:
    return bool(choices) and all(any(n in to for n in c.nodes()) for c in choices)


def some_run(process: Process, goals: Set[Node]) -> Set[Node]:
    """From where some run comes to a goal, which is where the greatest probability is positive."""
    return grown(process, goals, some_way)


def all_runs(process: Process, goals: Set[Node]) -> Set[Node]:
    """From where all runs come to a goal, those of probability 0 among them."""
    return grown(process, goals, every_way)


def surely_possible(process: Process, goals: Set[Node]) -> Set[Node]:
    """From where the least probability is positive: whatever is chosen, there is a way on to a goal."""
    return grown(process, goals, every_choice)


def can_be_sure(process: Process, goals: Set[Node]) -> Set[Node]:
    """From where the greatest probability to come to a goal is 1."""
    inside = set(process) | goals
    while True:
        def joins(choices: List[Choice], found: Set[Node]) -> bool:
            return any(inside.issuperset(c.nodes()) and not found.isdisjoint(c.nodes()) for c in choices)

        kept = grown(process, goals, joins)
        if kept == inside:
            return kept
        inside = kept


def is_sure(process: Process, goals: Set[Node]) -> Set[Node]:
    """From where the least probability to come to a goal is 1: no way leads to where it may be avoided."""
    positive = surely_possible(process, goals)
    ends = {n for choices in process.values() for c in choices for n in c.nodes()}
    avoiding = (set(process) | ends) - positive
    return (set(process) | goals) - some_run({n: c for n, c in process.items() if n not in goals}, avoiding)


def towards(process: Process, goals: Set[Node]) -> Policy:
    """A choice for each node from which a goal can be reached, by which it is with a positive probability."""
    policy: Policy = {}
    found, more = set(goals), True
    while more:
        fresh: Policy = {}
        for node, choices in process.items():
            if node not in found:
                for c in choices:
                    if any(n in found for n in c.nodes()):
                        fresh[node] = c
                        break
        policy.update(fresh)
        found |= set(fresh)
        more = bool(fresh)
    return policy


def components(process: Process) -> List[List[Node]]:
    """Strongly connected components, each after those that it leads to (Tarjan, without recursion)."""
    index: Dict[Node, int] = {}
    low: Dict[Node, int] = {}
    stack: List[Node] = []
    held: Set[Node] = set()
    found: List[List[Node]] = []

    def following(node: Node) -> Iterable[Node]:
        return iter([n for c in process[node] for n in c.nodes() if n in process])

    for root in process:
        if root in index:
            continue
        work = [(root, following(root))]
        index[root] = low[root] = len(index)
        stack.append(root)
        held.add(root)
        while work:
            node, rest = work[-1]
            for n in rest:
                if n not in index:
                    index[n] = low[n] = len(index)
                    stack.append(n)
                    held.add(n)
                    work.append((n, following(n)))
                    break
                if n in held:
                    low[node] = min(low[node], index[n])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    component: List[Node] = []
                    while not component or component[-1] != node:
                        component.append(stack.pop())
                        held.discard(component[-1])
                    found.append(component)
    return found


def worth(choice: Choice, values: Values) -> Fraction:
    return choice.earned + sum((p * values[n] for p, n in choice.ways), ZERO)


def of_policy(nodes: List[Node], policy: Policy, values: Values) -> Values:
    """The values of nodes by a policy, where all others are known: Gauss and Jordan."""
    rows: List[Tuple[Dict[Node, Fraction], Fraction]] = []
    inside = set(nodes)
    for node in nodes:
        row, right = {node: Fraction(1)}, policy[node].earned
        for p, n in policy[node].ways:
            if n in inside:
                row[n] = row.get(n, ZERO) - p
            else:
                right += p * values[n]
        rows.append((row, right))
    for k, node in enumerate(nodes):
        pick = next(i for i in range(k, len(rows)) if rows[i][0].get(node, ZERO) != 0)
        rows[k], rows[pick] = rows[pick], rows[k]
        row, right = rows[k]
        by = row[node]
        row, right = {n: x / by for n, x in row.items()}, right / by
        rows[k] = (row, right)
        for i, (other, value) in enumerate(rows):
            factor = other.get(node, ZERO)
            if i != k and factor != 0:
                for n, x in row.items():
                    other[n] = other.get(n, ZERO) - factor * x
                rows[i] = (other, value - factor * right)
    return {node: rows[k][1] for k, node in enumerate(nodes)}


def solve(process: Process, ends: Values, policy: Policy, greatest: bool) -> Values:
    """Policy iteration. By the policy it begins with, runs have to come to an end with probability 1. That
    stays so, as only choices that are strictly better are taken in the place of others."""
    values, policy = dict(ends), dict(policy)
    for nodes in components(process):
        better = True
        while better:
            better = False
            values.update(of_policy(nodes, policy, values))
            for node in nodes:
                for c in process[node]:
                    gain = worth(c, values) - worth(policy[node], values)
                    if (gain > 0) if greatest else (gain < 0):
                        policy[node] = c
                        better = True
    return values


def within(process: Process, inside: Set[Node]) -> Process:
    """The process of those that never leave a set of nodes."""
    return {n: [c for c in process[n] if inside.issuperset(c.nodes())] for n in process if n in inside}


def first_choices(process: Process) -> Policy:
    return {node: choices[0] for node, choices in process.items()}


def probabilities(process: Process, goal: Node, greatest: bool) -> Values:
    """The greatest or the least probability to come to a goal, of each node from which it is not 0."""
    positive = (some_run if greatest else surely_possible)(process, {goal})
    inner = {n: c for n, c in process.items() if n in positive}
    ends = {n: ZERO for c in process.values() for x in c for n in x.nodes() if n not in inner}
    ends[goal] = Fraction(1)
    return solve(inner, ends, towards(inner, {goal}) if greatest else first_choices(inner), greatest)
