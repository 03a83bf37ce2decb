"""A timed graph as README.md writes it, and the positions of it.

Offsets and times are counted in *quarters*: the even number 2 m is the instant m / 2. The odd number 2 m + 1
stands for all instants of the open interval (m / 2, (m + 1) / 2). So 4 n is the instant n. Truth changes at
whole offsets alone. Halves are needed for runs that begin in the middle of an open interval: from there whole
times come at halves.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Callable, Dict, List, Optional, Tuple

QUARTERS = 4


@dataclass(frozen=True)
class Trajectory:
    """The passing of time: `time` in whole units, None if it lasts for ever; `to` is where it leads."""

    time: Optional[int]
    to: Tuple[int, ...]
    pieces: int

    def piece(self, offset: int) -> int:
        """The number of the piece at an offset in quarters: (0, 1) is 0, the instant 1 is 1, (1, 2) is 2."""
        whole, rest = divmod(offset, QUARTERS)
        return min(2 * whole - (0 if rest else 1), self.pieces - 1)

    def ends(self, offset: int) -> bool:
        return self.time is not None and offset >= QUARTERS * self.time

    def rests(self, offset: int) -> bool:
        """Nothing changes any more after this offset."""
        return self.time is None and self.piece(offset) == self.pieces - 1


@dataclass(frozen=True)
class State:
    """`drawn` are branches with their probabilities, `chosen` single transitions, which come after them. `events` are the letters
    of each of these: of e, for all that happens by it."""

    known: bool
    drawn: Tuple[Tuple[Fraction, int], ...]
    chosen: Tuple[int, ...]
    events: Tuple[str, ...]
    trajectory: Optional[Trajectory]

    @property
    def discrete(self) -> Tuple[int, ...]:
        """Where the discrete transitions lead."""
        return self.chosen + tuple(t for _, t in self.drawn)

    @property
    def ends(self) -> Tuple[int, ...]:
        """Where the trajectory leads."""
        return () if self.trajectory is None else self.trajectory.to


@dataclass(frozen=True)
class Truth:
    """The truth of a formula: in each state, and on each piece of the trajectory of each state."""

    states: List[bool]
    along: List[Optional[List[bool]]]


def mapped(how: Callable[[Any], Any], along: List[Any]) -> List[Any]:
    """A function of what is told of each piece, where there are pieces."""
    return [None if pieces is None else [how(x) for x in pieces] for pieces in along]


def representative(piece: int) -> int:
    """An instant of the piece, in quarters: that of an instant itself, or the middle of an open interval."""
    return 2 * (piece + 1)


class Graph:
    """The states of a line, and the truth of its predicates, as letters."""

    def __init__(self, states: List[Dict[str, Any]]) -> None:
        self.states = [_state(s) for s in states]
        self._letters = [s["truth"] for s in states]
        self._inside: List[Any] = [(s.get("trajectory") or {}).get("truth") for s in states]

    def truth(self, in_state: Any, inside: Any) -> Truth:
        """A truth from what tells it of a state, and of a state and the number of a piece."""
        numbers = range(len(self.states))
        return Truth([in_state(s) for s in numbers], [self._along(s, inside) for s in numbers])

    def _along(self, s: int, inside: Any) -> Optional[List[bool]]:
        trajectory = self.states[s].trajectory
        return None if trajectory is None else [inside(s, i) for i in range(trajectory.pieces)]

    def predicate(self, name: str, favour: bool) -> Truth:
        """What is undecided of a predicate is true with `favour`, and false without."""
        yes = "T?" if favour else "T"
        return self.truth(lambda s: self._letters[s][name] in yes, lambda s, i: self._inside[s][name][i] in yes)

    def always(self) -> Truth:
        return self.truth(lambda s: True, lambda s, i: True)


def _state(state: Dict[str, Any]) -> State:
    if not state["known"]:
        return State(False, (), (), (), None)
    edges = state["transitions"]
    drawn = tuple((Fraction(e["probability"]), e["to"]) for e in edges if "probability" in e)
    chosen = tuple(e["to"] for e in edges if "probability" not in e)
    time = state["trajectory"]
    passing = time and Trajectory(time["time"], tuple(time["to"]), len(time["truth"]["p"]))
    return State(True, drawn, chosen, tuple(e["events"] for e in edges), passing)
