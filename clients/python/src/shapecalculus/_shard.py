"""A shard of an exploration: the states whose fingerprints it owns, level by level. Knows nothing of Ray.

States are found breadth first. A state of a level has a *rank*, its place among those of its level in the order in
which a search by itself would find them; a state that is found has as *key* the rank of the state before it and the
place of the transition between: among all ways to it, the least one counts. So it does not matter who finds a state
first, and on how many machines.
"""

from __future__ import annotations

import pickle
from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Set, Tuple

import numpy as np

from ._files import BadFile, get_file, place, put_file
from .successors import Filter, FilterFailed

CHOICES = 1 << 24
BATCH = 2048
FAULT, ERROR = 4, 5


def owner_of(fingerprint: bytes, owners: int) -> int:
    return int.from_bytes(fingerprint[:4], "little") % owners


def prints_of(data: bytes) -> Any:
    """Fingerprints one after the other, as an array of as many rows of four numbers."""
    return np.frombuffer(data, "<u4").reshape(-1, 4)


def words(prints: Any) -> Tuple[Any, Any]:
    """Each fingerprint as two numbers."""
    two = np.ascontiguousarray(prints).view("<u8")
    return two[:, 0], two[:, 1]


def first_of_each(data: bytes) -> Any:
    """Of fingerprints one after the other, the places where each is for the first time, in order."""
    low, high = words(prints_of(data))
    _, first, same = np.unique(low, return_index=True, return_inverse=True)
    if bool((high[first][same] != high).any()):
        # Hardly ever have two of them half of their bits in common.
        first = np.unique(np.stack([low, high]), axis=1, return_index=True)[1]
    return np.sort(first)


@dataclass
class Found:
    """States that are new to some owner, as columns."""

    keys: Any  # of 64 bits
    prints: Any
    before: Any  # fingerprints
    too_long: Any
    goals: Any  # a row for each state
    states: List[bytes]

    def __len__(self) -> int:
        return len(self.keys)

    def picked(self, order: Any) -> "Found":
        states = [self.states[i] for i in order.tolist()] if self.states else []
        return Found(
            self.keys[order],
            self.prints[order],
            self.before[order],
            self.too_long[order],
            self.goals[order],
            states,
        )

    def bare(self) -> "Found":
        """What the way to a state takes, and no more."""
        return Found(self.keys, self.prints, self.before, self.too_long, self.goals[:, :0], [])

    def place(self, fingerprint: bytes) -> int:
        return int(np.flatnonzero((self.prints == prints_of(fingerprint)[0]).all(axis=1))[0])


def together(parts: Sequence[Found], goals: int) -> Found:
    if not parts:
        none = np.zeros((0, 4), "<u4")
        return Found(np.zeros(0, np.int64), none, none, np.zeros(0, "u1"), np.zeros((0, goals), "u1"), [])
    columns = [
        np.concatenate([getattr(f, name) for f in parts])
        for name in ("keys", "prints", "before", "too_long", "goals")
    ]
    return Found(*columns, [s for f in parts for s in f.states])


@dataclass
class Expanded:
    """What an owner tells of the expansion of its part of a level."""

    transitions: int
    faults: List[Tuple[int, str]]  # rank and reason
    ends: List[str]  # why runs end in dead ends
    ahead: List[Tuple[int, int, int]]  # rank, goal, 1 met or 2 in doubt


def file_name(folder: str, owner: int, level: int) -> str:
    return place(folder, "%d-%d.shard" % (owner, level))


class Shard:
    def __init__(
        self,
        number: int,
        owners: int,
        model: str,
        arguments: Sequence[str],
        scc: Optional[str],
        digest: str,
        folder: Optional[str],
    ):
        self.number, self.owners, self.folder = number, owners, folder
        self.filter = Filter(model, arguments, scc=scc)
        if self.filter.header["digest"] != digest:
            raise FilterFailed("%s is another text here than where the check was asked for" % model)
        self.known: Set[bytes] = set()
        self.levels: List[Found] = []  # without their states, but for the last one
        self.ranks: Any = np.zeros(0, np.int64)  # of the states of the last level
        self.told_of: Set[bytes] = set()  # what this owner has told somebody of
        self.sending: List[bytes] = []  # those of them that may still be lost
        self.counts: List[Tuple[Any, Any]] = []  # ranks of the last level, with how many transitions they have
        self.pending = self.nothing()

    def nothing(self) -> Found:
        return together([], self.filter.goals)

    # Levels ---------------------------------------------------------------------------

    def begin(self, fingerprint: bytes, state: bytes, too_long: int) -> None:
        """The initial state is this owner's."""
        prints = prints_of(fingerprint)
        goals = np.zeros((1, self.filter.goals), "u1")
        self.pending = Found(
            np.zeros(1, np.int64), prints, np.zeros((1, 4), "<u4"), np.array([too_long], "u1"), goals, [state]
        )

    def commit(self, level: int, ranks: Any) -> None:
        """What was taken in is a level, and kept."""
        if self.levels:
            self.levels[-1] = self.levels[-1].bare()
        self.levels.append(self.pending)
        self._know(self.pending)
        self.ranks = np.array(ranks, np.int64)
        self.sending = []
        self.roll_back()
        if self.folder is not None:
            put_file(file_name(self.folder, self.number, level), pickle.dumps((self.levels[-1], self.ranks), 5))

    def _know(self, found: Found) -> None:
        data = found.prints.tobytes()
        self.known.update(data[i : i + 16] for i in range(0, len(data), 16))

    def restore(self, level: int) -> None:
        """To what was kept up to a level."""
        assert self.folder is not None
        self.roll_back()
        self.known, self.levels, self.told_of = set(), [], set()
        for k in range(level + 1):
            data = get_file(file_name(self.folder, self.number, k))
            if data is None:
                raise BadFile("%s is not there" % file_name(self.folder, self.number, k))
            found, self.ranks = pickle.loads(data)
            self.levels.append(found if k == level else found.bare())
            self._know(found)

    def roll_back(self) -> None:
        """To the last level that was kept."""
        self.told_of.difference_update(self.sending)
        self.sending, self.pending, self.counts = [], self.nothing(), []

    def expand(self) -> Tuple[Expanded, List[Found]]:
        """The states of the last level; and for each owner, what is found of its states."""
        out: List[List[Found]] = [[] for _ in range(self.owners)]
        told = Expanded(0, [], [], [])
        self.roll_back()
        wanted = np.flatnonzero(self.levels[-1].too_long == 0)
        for at in range(0, len(wanted), BATCH):
            self._batch(self.levels[-1], wanted[at : at + BATCH], out, told)
        return told, [together(parts, self.filter.goals) for parts in out]

    def _batch(self, last: Found, part: Any, out: List[List[Found]], told: Expanded) -> None:
        moves = self.filter.expand([last.states[i] for i in part.tolist()])
        ranks = self.ranks[part]
        told.transitions += int(moves.counts.sum())
        self.counts.append((ranks, moves.counts))
        for index, note in moves.notes.items():
            self._note(int(ranks[index]), int(moves.follows[index]), note, told)
        data, told_of = moves.fingerprints, self.told_of
        fresh = [k for k in first_of_each(data).tolist() if data[16 * k : 16 * k + 16] not in told_of]
        if not fresh:
            return
        sending = [data[16 * k : 16 * k + 16] for k in fresh]
        told_of.update(sending)
        self.sending += sending
        places = np.array(fresh)
        prints = prints_of(data)[places]
        begins = np.concatenate([[0], np.cumsum(moves.counts, dtype=np.int64)])
        sources = np.searchsorted(begins, places, side="right") - 1
        targets = self.filter.targets(fresh)
        keys = ranks[sources] * CHOICES + places - begins[sources]
        found = Found(keys, prints, last.prints[part[sources]], targets.too_long, targets.goals, targets.states)
        homes = prints[:, 0] % self.owners
        for j in range(self.owners):
            mine = np.flatnonzero(homes == j)
            if len(mine):
                out[j].append(found.picked(mine))

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

    def absorb(self, parts: Sequence[Found]) -> Tuple[Any, List[Tuple[int, int, int]]]:
        """What others and itself have found of its states. The keys of those that are new, in order; and the goals
        that hold or are undecided there: key, goal, 1 or 2."""
        found = together([f for f in parts if len(f)], self.filter.goals)
        data, known = found.prints.tobytes(), self.known
        fresh = np.array([i for i in range(len(found)) if data[16 * i : 16 * i + 16] not in known], np.int64)
        low, high = words(found.prints[fresh])
        # The least key of each fingerprint.
        order = fresh[np.lexsort((found.keys[fresh], high, low))]
        low, high = words(found.prints[order])
        first = np.ones(len(order), bool)
        first[1:] = (low[1:] != low[:-1]) | (high[1:] != high[:-1])
        order = order[first]
        self.pending = found.picked(order[np.argsort(found.keys[order])])
        keys, goals = self.pending.keys, self.pending.goals
        return keys, [(int(keys[i]), int(g), int(goals[i, g])) for i, g in zip(*np.nonzero(goals))]

    # Questions ------------------------------------------------------------------------

    def transitions_up_to(self, rank: int) -> int:
        """Of the states of the last level up to a rank."""
        return sum(int(counts[ranks <= rank].sum()) for ranks, counts in self.counts)

    def too_long(self) -> int:
        return int(self.levels[-1].too_long.sum())

    def fingerprint_of(self, value: int, by_rank: bool) -> Optional[bytes]:
        """Of a state of the last level, by its rank; or of one that was taken in, by its key. Or of another owner."""
        found, values = (self.levels[-1], self.ranks) if by_rank else (self.pending, self.pending.keys)
        places = np.flatnonzero(values == value)
        return found.prints[places[0]].tobytes() if len(places) else None

    def step_to(self, level: int, fingerprint: bytes) -> Tuple[bytes, int]:
        """The state before one of a level, and the choice that leads from there."""
        found = self.levels[level]
        i = found.place(fingerprint)
        return found.before[i].tobytes(), int(found.keys[i]) % CHOICES

    def level(self) -> int:
        """The last one that was kept."""
        return len(self.levels) - 1
