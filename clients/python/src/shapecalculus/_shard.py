"""A shard of an exploration: the states whose fingerprints it owns, level by level. Knows nothing of Ray.

States are found breadth first. A state of a level has a *rank*, its place among those of its level in the order in
which a search by itself would find them; a state that is found has as *key* the rank of the state before it and the
place of the transition between: among all ways to it, the least one counts. So it does not matter who finds a state
first, and on how many machines.
"""

from __future__ import annotations

import pickle
from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Tuple

import numpy as np

from ._files import BadFile, Folder
from .successors import Filter, FilterFailed, States, Told

CHOICES = 1 << 24
BATCH = 2048
FAULT, ERROR = 4, 5


def owner_of(fingerprint: bytes, owners: int) -> int:
    return int.from_bytes(fingerprint[:4], "little") % owners


def prints_of(data: bytes) -> Any:
    """Fingerprints one after the other, as an array of as many rows of four numbers."""
    return np.frombuffer(data, "<u4").reshape(-1, 4)


@dataclass
class Found:
    """States that are new to some owner, as columns."""

    keys: Any  # of 64 bits
    before: Any  # fingerprints
    states: States

    def __len__(self) -> int:
        return len(self.keys)

    def picked(self, order: Any) -> "Found":
        if np.array_equal(order, np.arange(len(self))):
            return self
        s = self.states
        data = s.data.tobytes()
        ends = np.cumsum(s.lengths, dtype=np.int64)
        ends, lengths = ends[order], s.lengths[order]
        cut = b"".join([data[i:j] for i, j in zip((ends - lengths).tolist(), ends.tolist())])
        states = States(s.prints[order], s.too_long[order], s.goals[order], lengths, np.frombuffer(cut, "u1"))
        return Found(self.keys[order], self.before[order], states)

    def bare(self) -> "Found":
        """What the way to a state takes, and no more."""
        s = self.states
        none = np.zeros(0, "u1")
        states = States(s.prints, s.too_long, np.zeros((len(self), 0), "u1"), none, none)
        return Found(self.keys, self.before, states)

    def place(self, fingerprint: bytes) -> int:
        return int(np.flatnonzero((self.states.prints == prints_of(fingerprint)[0]).all(axis=1))[0])


def together(parts: Sequence[Found], goals: int) -> Found:
    if len(parts) == 1:
        return parts[0]
    if not parts:
        none, byte = np.zeros((0, 4), "<u4"), np.zeros(0, "u1")
        states = States(none, byte, np.zeros((0, goals), "u1"), np.zeros(0, "<u4"), byte)
        return Found(np.zeros(0, np.int64), none, states)
    keys, before = (np.concatenate([getattr(f, name) for f in parts]) for name in ("keys", "before"))
    names = ("prints", "too_long", "goals", "lengths", "data")
    return Found(keys, before, States(*(np.concatenate([getattr(f.states, n) for f in parts]) for n in names)))


@dataclass
class Expanded:
    """What an owner tells of the expansion of its part of a level."""

    transitions: int
    faults: List[Tuple[int, str]]  # rank and reason
    ends: List[str]  # why runs end in dead ends
    ahead: List[Tuple[int, int, int]]  # rank, goal, 1 met or 2 in doubt


def file_name(owner: int, level: int) -> str:
    return "%d-%d.shard" % (owner, level)


class Shard:
    def __init__(
        self,
        number: int,
        owners: int,
        model: str,
        arguments: Sequence[str],
        scc: Optional[str],
        digest: str,
        folder: Optional[Folder],
    ):
        self.number, self.owners, self.folder = number, owners, folder
        self.filter = Filter(model, arguments, scc=scc)
        if self.filter.header["digest"] != digest:
            raise FilterFailed("%s is another text here than where the check was asked for" % model)
        self.levels: List[Found] = []  # without their states, but for the last one
        self.saved = -1  # the last level that is in a file
        self.ranks: Any = np.zeros(0, np.int64)  # of the states of the last level
        self.counts: List[Tuple[Any, Any]] = []  # ranks of the last level, with how many transitions they have
        self.pending = self.mine = self.nothing()

    def nothing(self) -> Found:
        return together([], self.filter.goals)

    # Levels ---------------------------------------------------------------------------

    def begin(self, fingerprint: bytes, state: bytes, too_long: int) -> None:
        """The initial state is this owner's."""
        prints, goals = prints_of(fingerprint), np.zeros((1, self.filter.goals), "u1")
        lengths, data = np.array([len(state)], "<u4"), np.frombuffer(state, "u1")
        states = States(prints, np.array([too_long], "u1"), goals, lengths, data)
        self.filter.meet(prints)
        self.pending = Found(np.zeros(1, np.int64), np.zeros((1, 4), "<u4"), states)

    def commit(self, level: int, ranks: Any) -> None:
        """What was taken in is a level."""
        if self.levels:
            self.levels[-1] = self.levels[-1].bare()
        self.levels.append(self.pending)
        self.ranks = np.array(ranks, np.int64)
        self.filter.keep()
        self.roll_back()

    def save(self, level: int, ranks: Any) -> None:
        """What was taken in is a level, and all levels are in files: each file has those after the one that it
        names."""
        self.commit(level, ranks)
        if self.folder is not None:
            data = pickle.dumps((self.saved, self.levels[self.saved + 1 :], self.ranks), 5)
            self.folder.put(file_name(self.number, level), data)
            self.saved = level

    def restore(self, level: int) -> None:
        """To what was saved with a level."""
        assert self.folder is not None
        self.filter.forget(all_of_it=True)
        self.levels, self.saved, at = [], level, level
        while at >= 0:
            name = file_name(self.number, at)
            data = self.folder.get(name)
            if data is None:
                raise BadFile("%s is not there" % self.folder.file(name))
            before, levels, ranks = pickle.loads(data)
            if at == level:
                self.ranks = ranks
            else:
                levels[-1] = levels[-1].bare()
            self.levels, at = levels + self.levels, before
        for found in self.levels:
            self.filter.meet(found.states.prints)
        self.filter.keep()
        self.roll_back()

    def roll_back(self) -> None:
        """To the last level. What the filter has told since then may be lost: it is told again."""
        self.filter.forget()
        self.pending, self.mine, self.counts = self.nothing(), self.nothing(), []

    def expand(self) -> Tuple[Expanded, List[Found]]:
        """The states of the last level; and for each owner, what is found of its states. The filter tells a state once,
        when it is found first: by the least key that this owner has for it, as states are expanded by rank."""
        self.roll_back()
        out: List[List[Found]] = [[] for _ in range(self.owners)]
        told = Expanded(0, [], [], [])
        last, ranks = self.levels[-1], self.ranks
        if last.states.too_long.any():
            wanted = np.flatnonzero(last.states.too_long == 0)
            last, ranks = last.picked(wanted), ranks[wanted]
        at = 0
        for part in self.filter.news(last.states.lengths, last.states.data, self.owners, BATCH):
            here = slice(at, at + len(part.counts))
            self._part(ranks[here], last.states.prints[here], part, out, told)
            at = here.stop
        return told, [together(parts, self.filter.goals) for parts in out]

    def _part(self, ranks: Any, prints: Any, part: Told, out: List[List[Found]], told: Expanded) -> None:
        told.transitions += int(part.counts.sum())
        self.counts.append((ranks, part.counts))
        for index, note in part.notes.items():
            self._note(int(ranks[index]), int(part.follows[index]), note, told)
        for home, news in zip(out, part.homes):
            if len(news.sources):
                keys = ranks[news.sources] * CHOICES + news.choices
                home.append(Found(keys, prints[news.sources], news.states))

    def _note(self, rank: int, follows: int, note: Any, told: Expanded) -> None:
        if follows == ERROR:
            raise FilterFailed("a state that the filter told is refused: %s" % note["error"]["message"])
        if "reason" in note:
            reason = note["reason"]["message"]
            if follows == FAULT:
                told.faults.append((rank, reason))
            else:
                told.ends.append(reason)
        for goal, ahead in enumerate(note.get("ahead", [])):
            if ahead and ahead["met"]:
                told.ahead.append((rank, goal, 1))
            elif ahead and ahead["doubt"]:
                told.ahead.append((rank, goal, 2))

    def absorb(self, parts: Sequence[Found]) -> Tuple[Any, List[Tuple[int, int, int]], int]:
        """What others and itself have found of its states. The keys of those that are new, in order; the goals that
        hold or are undecided there: key, goal, 1 or 2; and how many of them are too long."""
        found = together([f for f in parts if len(f)], self.filter.goals)
        order = np.argsort(found.keys, kind="stable")
        which = self.filter.meet(found.states.prints)[order]
        # Of each state that is new, the first place in this order: what is written last stays.
        places = np.arange(len(order))
        first = np.zeros(int(which.max(initial=0)) + 1, np.int64)
        first[which[::-1]] = places[::-1]
        self.pending = found.picked(order[(which > 0) & (first[which] == places)])
        keys, goals = self.pending.keys, self.pending.states.goals
        told = [(int(keys[i]), int(g), int(goals[i, g])) for i, g in zip(*np.nonzero(goals))]
        return keys, told, int(self.pending.states.too_long.sum())

    # Questions ------------------------------------------------------------------------

    def transitions_up_to(self, rank: int) -> int:
        """Of the states of the last level up to a rank."""
        return sum(int(counts[ranks <= rank].sum()) for ranks, counts in self.counts)

    def fingerprint_of(self, value: int, by_rank: bool) -> Optional[bytes]:
        """Of a state of the last level, by its rank; or of one that was taken in, by its key. Or of another owner."""
        found, values = (self.levels[-1], self.ranks) if by_rank else (self.pending, self.pending.keys)
        places = np.flatnonzero(values == value)
        return found.states.prints[places[0]].tobytes() if len(places) else None

    def step_to(self, level: int, fingerprint: bytes) -> Tuple[bytes, int]:
        """The state before one of a level, and the choice that leads from there."""
        found = self.levels[level]
        i = found.place(fingerprint)
        return found.before[i].tobytes(), int(found.keys[i]) % CHOICES

    def level(self) -> int:
        """The last one."""
        return len(self.levels) - 1
