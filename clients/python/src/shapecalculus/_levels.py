"""One exploration of a model by owners, which Ray starts, watches and starts again: see specs/cluster.md."""

from __future__ import annotations

import json
import secrets
import time
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Optional, Sequence, Set

from ._files import BadFile, CannotKeep, Folder
from ._owner import Owner
from ._waiting import LONG, MOST_TRIES, ClusterFailed, answers, first_line, look
from .successors import FilterFailed, FilterLost

#: So many milliseconds may pass before what was found is kept.
EVERY = 1000
#: Seconds that owners have to find each other, which a busy machine may take.
MEET = 60
#: Seconds within which all owners that fail have said why.
REASONS = 2.0
MANIFEST = "manifest.json"


@dataclass
class Progress:
    """How far an exploration has come."""

    level: int = 0
    depth: int = 0
    states: int = 1
    transitions: int = 0
    runs: Dict[int, List[int]] = field(default_factory=dict)  # by goal that is met: the choices of a run
    doubts: List[int] = field(default_factory=list)  # goals
    open: List[int] = field(default_factory=list)  # goals that may be met after states that were not expanded
    stopped: str = ""  # why it did not go to the end: "" or "early", "states", "levels", "late"
    cycle: Optional[Dict[str, Any]] = None  # a run that comes back within one instant: "from" and "choices"
    conclusions: Dict[int, Any] = field(default_factory=dict)  # by check: of one that is more than a search
    faults: List[str] = field(default_factory=list)
    ends: List[str] = field(default_factory=list)
    too_long: int = 0
    messages: int = 0  # between owners
    bytes: int = 0

    @property
    def complete(self) -> bool:
        return not (self.stopped or self.faults or self.too_long)


def progress_of(told: Any) -> Progress:
    if "going" in told:
        return Progress(**told["going"])
    rest = {k: told[k] for k in ("doubts", "open", "cycle", "faults", "ends", "too_long", "messages", "bytes")}
    runs = {run["goal"]: run["choices"] for run in told["runs"]}
    conclusions = {c["check"]: c for c in told.get("conclusions", [])}
    return Progress(runs=runs, conclusions=conclusions, stopped=told["stopped"] or "", **told["found"], **rest)


def owner_class(ray: Any) -> Any:
    """Owners as actors. They are asked when something is to be told, and not for each level."""

    @ray.remote(num_cpus=0, max_restarts=0, max_concurrency=8)
    class OwnerActor:
        def __init__(self, number: int, count: int, of_model: Sequence[Any], digest: str, folder: Any, here: bool):
            self.number, self.count, self.of_model, self.folder = number, count, of_model, folder
            self.digest = digest
            self.here = here
            self.owner: Any = None
            self.saved: Dict[int, Set[int]] = {}

        def start(self) -> str:
            """A new process. Where the others call it."""
            if self.owner is not None:
                self.owner.close()
            self.saved = {}
            address = "127.0.0.1" if self.here else ray.util.get_node_ip_address()
            arguments = [self.number, self.count, *self.of_model, address, self.folder, self.kept]
            self.owner = Owner(*arguments)
            if self.owner.header["digest"] != self.digest:
                self.owner.close()
                raise FilterFailed("%s is another text here than where the check was asked for" % self.of_model[0])
            return "%s:%d" % (address, self.owner.port())

        def begin(self, asked: Any, level: Optional[int], first: Any, identity: Any) -> None:
            self.first, self.identity = first, identity
            self.owner.begin(asked, level)

        def news(self, times: int) -> Any:
            return self.owner.news(times)

        def kept(self, level: int, explored: Any) -> None:
            if self.number == 0:
                self.all_kept(0, level, explored)
            else:
                self.first.all_kept.remote(self.number, level, explored)

        def all_kept(self, number: int, level: int, explored: Any) -> None:
            """Of the first owner: once all have a level, an exploration may go on from there."""
            owners = self.saved.setdefault(level, set())
            owners.add(number)
            if len(owners) == self.count:
                self.folder.put(MANIFEST, json.dumps([self.identity, explored]).encode())
                self.saved = {}
                self.owner.go_on()

    return OwnerActor


class Lost(Exception):
    """An owner did not answer."""


class Exploration:
    """One exploration of a model by owners."""

    def __init__(
        self,
        ray: Any,
        model: str,
        arguments: Sequence[str],
        scc: Optional[str],
        header: Any,
        owners: int,
        folder: Optional[Folder],
        asked: Dict[str, Any],
        here: bool,
        show: Callable[[Progress], None],
    ):
        self.ray, self.header, self.count, self.folder, self.asked = ray, header, owners, folder, asked
        self.of_owner = (owners, (model, list(arguments), scc), header["digest"], folder, here)
        self.show, self.recovered, self.seconds = show, 0, 0.0
        self.owner = owner_class(ray)
        self.owners = [self.new_owner(i) for i in range(owners)]

    # Owners ---------------------------------------------------------------------------

    def new_owner(self, i: int) -> Any:
        """On the nodes in turn, as many as they have processors. Owners ask Ray for no processor; by itself it would put
        all of them on one node."""
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

    def started(self) -> List[str]:
        """All owners with new processes; those that are lost begin anew. Their addresses."""
        starts = [o.start.remote() for o in self.owners]
        found: List[str] = []
        for i, start in enumerate(starts):
            try:
                found += self.get([start])
            except Lost:
                self.ray.kill(self.owners[i])
                self.owners[i] = self.new_owner(i)
                found += self.get([self.owners[i].start.remote()])
        return found

    def begin(self) -> None:
        asked = dict(self.asked, peers=self.started(), secret=secrets.token_hex(32), run=secrets.token_hex(8))
        asked.update(deadline=MEET * 1000)
        if self.asked["order"] == "levels":
            asked.update(every=EVERY)
        level = self.kept_level()
        if level is None and self.folder is not None:
            # Before there is anything to keep it is known whether it can be kept.
            self.folder.put(MANIFEST, json.dumps([self.identity(), None]).encode())
        self.get([o.begin.remote(asked, level, self.owners[0], self.identity()) for o in self.owners])

    # Keeping --------------------------------------------------------------------------

    def identity(self) -> Any:
        names = ["digest", "parameters", "program", "reductions", "exploration", "checks", "bounds"]
        asked = {k: value for k, value in self.asked.items() if k != "memory"}
        identity = dict({k: self.header[k] for k in names}, owners=self.count, asked=asked)
        return json.loads(json.dumps(identity))

    def kept_level(self) -> Optional[int]:
        """That all owners have kept, by this command or an earlier one; None if there is none."""
        data = self.folder.get(MANIFEST) if self.folder is not None else None
        if self.folder is None or data is None:
            return None
        try:
            identity, explored = json.loads(data)
            level = None if explored is None else int(explored["level"])
            different = [k for k, value in self.identity().items() if identity.get(k) != value]
        except (ValueError, TypeError, KeyError, AttributeError):
            raise ClusterFailed("%s is no manifest of a check" % self.folder.file(MANIFEST), 3) from None
        if different:
            raise ClusterFailed(
                "%s is of another check: it differs in %s" % (self.folder.path, ", ".join(different)), 3
            )
        return level

    # The work -------------------------------------------------------------------------

    def run(self, disturb: Optional[Callable[[Any], None]] = None) -> Progress:
        lost: Optional[Lost] = None
        for k in range(MOST_TRIES):
            try:
                self.begin()
                begun = time.monotonic()
                if k == 0 and disturb is not None:
                    disturb(self)
                p = self.watch()
                self.seconds = time.monotonic() - begun
                return p
            except Lost as e:
                lost = e
                if self.folder is None and self.asked["order"] == "levels":
                    raise ClusterFailed(
                        "an owner was lost, and nothing was kept: --checkpoint tells where to keep shards: %s"
                        % first_line(str(e)),
                        4,
                    ) from None
                self.recovered += 1
        raise ClusterFailed("owners are lost again and again: %s" % first_line(str(lost)), 4)

    def watch(self) -> Progress:
        """Until the first owner tells what was found. The others tell nothing but how they fail."""
        news = {o.news.remote(0): o for o in self.owners}
        first = next(iter(news))
        while True:
            ready, _ = self.ray.wait(list(news), num_returns=1, timeout=LONG)
            if not ready:
                look(self.ray)
                continue
            if ready[0] != first:
                self.why(list(news), ready[0])
            try:
                ((told, times),) = self.get(ready)
            except Lost:
                self.why(list(news), first)
                raise
            p = progress_of(told)
            self.show(p)
            if "found" in told:
                return p
            owner = news.pop(first)
            first = owner.news.remote(times)
            news = {first: owner, **news}

    def why(self, news: List[Any], failed: Any) -> None:
        """Owners that lose one of them fail as well. One that says more than that it has lost another tells the reason."""
        ready, _ = self.ray.wait(news, num_returns=len(news), timeout=REASONS)
        last: Optional[Lost] = None
        for future in [failed, *(f for f in ready if f != failed)]:
            try:
                self.get([future])
            except Lost as e:
                last = last or e
        raise last or Lost("an owner has ended")

    def close(self) -> None:
        for o in self.owners:
            self.ray.kill(o)
