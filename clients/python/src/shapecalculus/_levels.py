"""One exploration of a model by owners in step, level by level: see specs/cluster.md."""

from __future__ import annotations

import copy
import json
import time
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from ._files import BadFile, CannotKeep, Folder
from ._shard import CHOICES, Expanded, Found, Shard, owner_of
from ._waiting import MOST_TRIES, ClusterFailed, answers, first_line
from .successors import FilterFailed, FilterLost

#: Paths with more transitions than this may go on for ever within one instant.
MOST_LEVELS = 10_000
#: So many seconds may pass before what was found is kept.
LONG = 1.0
MANIFEST = "manifest.json"


@dataclass
class Progress:
    """What is kept of an exploration beside its shards."""

    level: int = 0
    depth: int = 0
    width: int = 1  # states of the last level
    states: int = 1
    transitions: int = 0
    met: Dict[int, Tuple[int, str]] = field(default_factory=dict)  # goal: level and fingerprint
    doubts: List[int] = field(default_factory=list)  # goals
    stopped: str = ""  # why it did not go to the end: "" or "early", "states", "levels"
    faults: List[str] = field(default_factory=list)
    ends: List[str] = field(default_factory=list)
    too_long: int = 0

    @property
    def complete(self) -> bool:
        return not (self.stopped or self.faults or self.too_long)


def owner_class(ray: Any) -> Any:
    """Shards as actors. What is found of an owner's own states does not leave it. A call costs a millisecond, as much
    as a hundred states: there are two in a level, and for an owner alone one."""

    @ray.remote(num_cpus=0, max_restarts=0)
    class Owner(Shard):
        told: Union[Expanded, Exception]

        def found(self, level: int, ranks: Any) -> Any:
            """Expands what it took in as a level, if it is not that yet. What is found, but for its own: a value for
            each other owner, or that value if there is one."""
            try:
                if ranks is not None:
                    self.commit(level, ranks)
                self.told, out = self.expand()
            except Exception as e:
                self.told = e
                raise
            self.mine = out.pop(self.number)
            return out[0] if len(out) == 1 else out

        def take_in(self, *others: Found) -> Any:
            if isinstance(self.told, Exception):
                raise self.told
            return (self.told, *self.absorb([self.mine, *others]))

        def alone(self, level: int, ranks: Any) -> Any:
            self.found(level, ranks)
            return self.take_in()

    return Owner


class Lost(Exception):
    """An owner did not answer."""


class Exploration:
    """One exploration of a model, by owners in step."""

    def __init__(
        self,
        ray: Any,
        model: str,
        arguments: Sequence[str],
        scc: Optional[str],
        header: Any,
        owners: int,
        folder: Optional[Folder],
        states: int,
        show: Callable[[Progress], None],
    ):
        self.ray, self.header, self.count, self.folder, self.most = ray, header, owners, folder, states
        self.of_owner = (owners, model, list(arguments), scc, header["digest"], folder)
        self.show, self.recovered = show, 0
        self.progress = Progress()
        self.safe = self.progress  # up to the last level that all owners have kept
        self.kept_at = time.monotonic()
        self.ranks: Optional[List[Any]] = None  # of the last level, if owners have not yet been told of them
        self.owner = owner_class(ray)
        self.owners = [self.new_owner(i) for i in range(owners)]
        self.searches = bool(header["checks"]) and all(c["plan"] is not None for c in header["checks"])

    # Owners ---------------------------------------------------------------------------

    def new_owner(self, i: int) -> Any:
        """On the nodes in turn, as many as they have processors. Owners wait more than they work, and ask Ray for no
        processor; by itself it would put all of them on one node."""
        from ray.util.scheduling_strategies import NodeAffinitySchedulingStrategy

        cores = sorted((n["NodeID"], int(n["Resources"].get("CPU", 0))) for n in self.ray.nodes() if n["Alive"])
        most = max((count for _, count in cores), default=0)
        places = [node for k in range(most) for node, count in cores if k < count]
        if not places:
            return self.owner.remote(i, *self.of_owner)
        strategy = NodeAffinitySchedulingStrategy(places[i % len(places)], soft=True)
        return self.owner.options(scheduling_strategy=strategy).remote(i, *self.of_owner)

    def get(self, futures: Sequence[Any]) -> List[Any]:
        try:
            return answers(self.ray, futures)
        except self.ray.exceptions.RayTaskError as e:
            cause = e.cause if isinstance(e.cause, Exception) else e
            lost = self.ray.exceptions
            if isinstance(cause, (lost.ObjectLostError, lost.RayActorError, FilterLost)):
                raise Lost(str(cause)) from None
            if isinstance(cause, (FilterFailed, BadFile)):
                raise ClusterFailed(str(cause), 3) from None
            if isinstance(cause, CannotKeep):
                raise cause from None
            raise
        except (
            self.ray.exceptions.RayActorError,
            self.ray.exceptions.ObjectLostError,
            self.ray.exceptions.WorkerCrashedError,
        ) as e:
            raise Lost(str(e)) from None

    def recover(self) -> None:
        """Every owner as it was after the last level that was kept; those that are lost begin anew."""
        if self.folder is None:
            raise ClusterFailed(
                "an owner was lost, and nothing was kept: --checkpoint tells where to keep shards", 4
            )
        self.recovered += 1
        self.progress, self.ranks = self.safe, None
        for i in range(self.count):
            try:
                level = self.ray.get(self.owners[i].level.remote(), timeout=60)
                if level == self.progress.level:
                    self.get([self.owners[i].roll_back.remote()])
                else:
                    self.get([self.owners[i].restore.remote(self.progress.level)])
            except (Lost, self.ray.exceptions.RayActorError, self.ray.exceptions.GetTimeoutError):
                self.ray.kill(self.owners[i])
                self.owners[i] = self.new_owner(i)
                self.get([self.owners[i].restore.remote(self.progress.level)])

    def steadily(self, work: Callable[[], Any]) -> Any:
        """Does it again with owners that are there."""
        lost: Optional[Lost] = None
        for _ in range(MOST_TRIES):
            try:
                if lost is not None:
                    self.recover()
                return work()
            except Lost as e:
                lost = e
        raise ClusterFailed("owners are lost again and again: %s" % first_line(str(lost)), 4)

    def start(self) -> None:
        """All owners with the initial state; nothing is kept yet."""
        lost: List[str] = []
        for k in range(MOST_TRIES):
            try:
                return self.begin()
            except Lost as e:
                lost = str(e).strip().splitlines()
                self.close()
                self.owners = [self.new_owner(i) for i in range(self.count)]
        raise ClusterFailed("owners do not start: %s" % " ".join(lost[-3:]), 4)

    # Keeping --------------------------------------------------------------------------

    def identity(self) -> Any:
        names = ["digest", "parameters", "program", "reductions", "exploration", "checks", "bounds"]
        return dict({k: self.header[k] for k in names}, owners=self.count, states=self.most)

    def keep(self) -> None:
        self.get([o.save.remote(self.progress.level, part) for o, part in zip(self.owners, self.ranks or [])])
        self.safe, self.ranks, self.kept_at = self.progress, None, time.monotonic()
        # Nobody reads the manifest of a folder that goes with this call.
        if self.folder is not None and self.folder.durable:
            self.folder.put(MANIFEST, json.dumps([self.identity(), self.progress.__dict__]).encode())

    def kept(self) -> bool:
        """Takes up what was kept by an earlier run, if there is anything."""
        data = self.folder.get(MANIFEST) if self.folder is not None else None
        if self.folder is None or data is None:
            return False
        try:
            identity, progress = json.loads(data)
            progress["met"] = {int(k): tuple(v) for k, v in progress["met"].items()}
            self.progress = self.safe = Progress(**progress)
        except (ValueError, TypeError, KeyError, AttributeError):
            raise ClusterFailed("%s is no manifest of a check" % self.folder.file(MANIFEST), 3) from None
        mine = json.loads(json.dumps(self.identity()))
        if identity != mine:
            other = ", ".join(k for k in mine if identity.get(k) != mine[k])
            raise ClusterFailed("%s is of another check: it differs in %s" % (self.folder.path, other), 3)
        return True

    # Levels ---------------------------------------------------------------------------

    def run(self, disturb: Optional[Callable[[Any], None]] = None) -> Progress:
        if not self.kept():
            self.start()
        else:
            self.steadily(lambda: self.get([o.restore.remote(self.progress.level) for o in self.owners]))
        if disturb is not None:
            disturb(self)
        while not self.progress.stopped and self.steadily(self.next_level):
            self.show(self.progress)
        return self.progress

    def begin(self) -> None:
        initial = self.header["initial"]
        fingerprint = bytes.fromhex(initial["fingerprint"])
        home = self.owners[owner_of(fingerprint, self.count)]
        too_long = int(bool(initial.get("too_long")))
        self.get([home.begin.remote(fingerprint, bytes.fromhex(initial["state"]), too_long)])
        self.ranks = [[0] if o is home else [] for o in self.owners]
        p = Progress(too_long=too_long)
        for goal, truth in enumerate(initial["goals"]):
            if truth is True:
                p.met[goal] = (0, initial["fingerprint"])
            elif truth is not False:
                p.doubts.append(goal)
        if self.decided(p):
            p.stopped = "early"
        self.progress = p
        self.keep()

    def decided(self, p: Progress) -> bool:
        return self.searches and len(p.met) == len(self.header["goals"])

    def next_level(self) -> bool:
        """Whether there are states to go on with. Nothing of it counts before it is whole."""
        p = copy.deepcopy(self.progress)
        expanded, taken = self.expand()
        keys = np.concatenate([keys for keys, _, _ in taken])
        order = np.argsort(keys, kind="stable")
        # What is met, by when: the rank of the state that is expanded, a new state before what is met ahead of it.
        events = [((key // CHOICES, 0, key), goal, truth) for _, goals, _ in taken for key, goal, truth in goals]
        events += [((rank, 1, rank), goal, truth) for told in expanded for rank, goal, truth in told.ahead]
        last = self.last_rank(p, keys[order])
        first: Dict[int, Tuple[int, int, int]] = {}
        for when, goal, truth in sorted(events):
            if goal in p.met or goal in first or (last is not None and when[0] > last):
                continue
            if truth == 1:
                first[goal] = when
            elif goal not in p.doubts:
                p.doubts.append(goal)
        for goal, when in first.items():
            p.met[goal] = self.place(when)
        if self.decided(p):
            last = max(when[0] for when in first.values())
            rest = last < p.width - 1 or bool(np.any(keys // CHOICES <= last))
            p.stopped = "early" if rest else ""
        elif last is not None:
            p.stopped = "states"
        if last is None:
            p.transitions += sum(told.transitions for told in expanded)
            fresh = len(keys)
        else:
            p.transitions += sum(self.get([o.transitions_up_to.remote(last) for o in self.owners]))
            fresh = int(np.count_nonzero(keys // CHOICES <= last))
        p.states += fresh
        p.faults += [t for told in expanded for rank, t in told.faults if last is None or rank <= last]
        p.ends += [t for told in expanded for t in told.ends]
        p.too_long += sum(too_long for _, _, too_long in taken)
        self.rank(p, [keys for keys, _, _ in taken], order, fresh)
        if p.stopped or fresh == 0 or time.monotonic() - self.kept_at > LONG:
            self.keep()
        return fresh > 0

    def expand(self) -> Tuple[List[Expanded], List[Any]]:
        """The last level. Of each owner, what it tells of its part, and of the states that it has taken in."""
        level, ranks = self.progress.level, self.ranks or [None] * self.count
        if self.count == 1:
            futures = [self.owners[0].alone.remote(level, ranks[0])]
        else:
            others = self.count - 1
            found = [o.found.options(num_returns=others).remote(level, r) for o, r in zip(self.owners, ranks)]
            of: List[List[Any]] = [[one] if others == 1 else list(one) for one in found]
            # Owners take in what the others have found as soon as that is there, without a word from here.
            futures = [
                o.take_in.remote(*[out[j - (i < j)] for i, out in enumerate(of) if i != j])
                for j, o in enumerate(self.owners)
            ]
        try:
            answers = self.get(futures)
        except Lost:
            self.hear(futures)
            raise
        return [told for told, *_ in answers], [taken for _, *taken in answers]

    def hear(self, futures: Sequence[Any]) -> None:
        """Ray tells the user of errors that nobody has heard of."""
        for future in futures:
            try:
                self.get([future])
            except (Lost, ClusterFailed):
                pass

    def last_rank(self, p: Progress, keys: Any) -> Optional[int]:
        """The last that may be expanded where states are bounded: the one after it has too many that are new."""
        room = self.most - p.states
        if len(keys) <= room:
            return None
        return int(keys[room] // CHOICES) - 1

    def place(self, when: Tuple[int, int, int]) -> Tuple[int, str]:
        _, ahead, value = when
        found = self.get([o.fingerprint_of.remote(value, bool(ahead)) for o in self.owners])
        level = self.progress.level + (0 if ahead else 1)
        return level, next(f for f in found if f is not None).hex()

    def rank(self, p: Progress, keys: Sequence[Any], order: Any, fresh: int) -> None:
        """What was taken in is the last level."""
        ranks = np.empty(len(order), dtype=np.int64)
        ranks[order] = np.arange(len(order))
        self.ranks = np.split(ranks, np.cumsum([len(k) for k in keys])[:-1])
        p.level, p.width = p.level + 1, len(order)
        p.depth = p.level if fresh > 0 else p.depth
        if p.level >= MOST_LEVELS and not p.stopped and fresh > 0:
            p.stopped = "levels"
        self.progress = p

    def choices(self, level: int, fingerprint: str) -> List[int]:
        """From the initial state to one that was found, backwards by fingerprints."""
        found, at = [], bytes.fromhex(fingerprint)
        for k in range(level, 0, -1):
            owner = owner_of(at, self.count)
            at, choice = self.steadily(lambda: self.get([self.owners[owner].step_to.remote(k, at)])[0])
            found.append(choice)
        return found[::-1]

    def close(self) -> None:
        for o in self.owners:
            self.ray.kill(o)
