"""Runs that look for g, f holding before (*Until*, *Intervals*): a decision process."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, List, Optional, Tuple

from graph import QUARTERS, Graph, Trajectory, Truth, representative

WON = "won"
LOST = "lost"
Node = Any
ONE = Fraction(1)


@dataclass(frozen=True)
class Branch:
    """One outcome: its probability, the state (None inside a trajectory), the node there, and the letters of e."""

    probability: Fraction
    state: Optional[int]
    node: Node
    events: str = ""


@dataclass(frozen=True)
class Option:
    """What may be chosen in a node: a transition or a draw, or, if not `discrete`, a trajectory and its end.
    `quarters` is the time that passes on it, until g if it comes to g on the way."""

    discrete: bool
    quarters: int
    branches: Tuple[Branch, ...]


@dataclass(frozen=True)
class Window:
    """The times at which g counts: from `a` to `b`, in quarters, without an end if `b` is None."""

    a: int
    b: Optional[int]

    def counts(self, elapsed: int) -> bool:
        return self.a <= elapsed and not self.passed(elapsed)

    def passed(self, elapsed: int) -> bool:
        return self.b is not None and elapsed > self.b

    def kept(self, elapsed: int) -> int:
        """What has to be remembered of the elapsed time."""
        return min(elapsed, self.a) if self.b is None else elapsed


def window(bounds: List[Optional[int]]) -> Window:
    a, b = bounds
    return Window(QUARTERS * (a or 0), None if b is None else QUARTERS * b)


EVER = Window(0, None)


class Until:
    """The process of `f U[a, b] g`. Its nodes are WON, LOST, and pairs of a state and the elapsed time, where it
    is open. Unknown states are won with `favour`, and lost without (*Truncated*)."""

    def __init__(self, graph: Graph, times: Window, f: Truth, g: Truth, favour: bool) -> None:
        self.graph, self.times, self.f, self.g, self.favour = graph, times, f, g, favour

    def decided(self, f: bool, g: bool, elapsed: int, instant: bool) -> Optional[Node]:
        """WON, LOST, or None if the run has to go on. An open interval has no first position: with g on it f is
        needed there as well."""
        if g and self.times.counts(elapsed) and (instant or f):
            return WON
        if not f or self.times.passed(elapsed):
            return LOST
        return None

    def enter(self, s: int, elapsed: int) -> Node:
        """What a run is at that comes to a state."""
        node = self.decided(self.f.states[s], self.g.states[s], elapsed, True)
        if node is not None:
            return node
        if not self.graph.states[s].known:
            return WON if self.favour else LOST
        return (s, self.times.kept(elapsed))

    def along(self, s: int, offset: int, elapsed: int) -> Tuple[int, List[Tuple[Optional[int], Node]]]:
        """The run goes along the trajectory of s, from an offset on: the instant at which it is decided or
        ends, and what there is to choose there."""
        trajectory = self.graph.states[s].trajectory
        assert trajectory is not None
        f, g = self.f.along[s], self.g.along[s]
        assert f is not None and g is not None
        while not trajectory.ends(offset):
            i = trajectory.piece(offset)
            node = self.decided(f[i], g[i], elapsed, offset % 2 == 0)
            if node is None and self.rests(trajectory, offset, elapsed):
                node = LOST
            if node is not None:
                return self.reached(offset), [(None, node)]
            offset, elapsed = offset + 1, elapsed + 1
        return offset, [(t, self.enter(t, elapsed)) for t in trajectory.to]

    def reached(self, offset: int) -> int:
        """The instant at which what is decided at an offset is come to: the beginning of an open interval."""
        return offset - offset % 2

    def rests(self, trajectory: Trajectory, offset: int, elapsed: int) -> bool:
        """Neither truth nor whether g counts changes any more but that b passes."""
        return trajectory.rests(offset) and elapsed >= self.times.a

    def options(self, node: Node) -> List[Option]:
        s, elapsed = node
        state = self.graph.states[s]
        chosen = zip(state.chosen, state.events[len(state.drawn):])
        found = [Option(True, 0, (Branch(ONE, t, self.enter(t, elapsed), e),)) for t, e in chosen]
        if state.drawn:
            drawn = zip(state.drawn, state.events)
            found.append(Option(True, 0, tuple(Branch(p, t, self.enter(t, elapsed), e) for (p, t), e in drawn)))
        if state.trajectory is not None:
            offset, ways = self.along(s, 1, elapsed + 1)
            found += [Option(False, offset, (Branch(ONE, t, n),)) for t, n in ways]
        return found

    def starts(self) -> Tuple[List[Node], List[Optional[List[List[Node]]]]]:
        """The node in which runs begin from each state, and those of which one is chosen from each piece."""
        states = [self.enter(s, 0) for s in range(len(self.graph.states))]
        inside: List[Optional[List[List[Node]]]] = []
        for s, state in enumerate(self.graph.states):
            t = state.trajectory
            inside.append(None if t is None else [self.within(s, i) for i in range(t.pieces)])
        return states, inside

    def within(self, s: int, piece: int) -> List[Node]:
        return [node for _, node in self.along(s, representative(piece), 0)[1]]
