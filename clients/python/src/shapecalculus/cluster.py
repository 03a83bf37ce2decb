"""Checks, simulations and sweeps of models on many machines, by Ray (specs/cluster.md). Needs the extra ``cluster``:
ray, fsspec.

from shapecalculus import cluster

report = cluster.check("model.sc")                                # on all cores of this machine
report = cluster.check("model.sc", address="ray://head:10001")    # on a cluster
"""

from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from ._estimation import estimate
from ._files import Folder, place
from ._guard import USAGE
from ._levels import Exploration, Progress
from ._parts import PartsProgress
from ._ray import Gauges, connect, told
from ._spread import simulate, sweep
from ._waiting import MANY, ClusterFailed
from .successors import Filter, FilterFailed, FilterLost

__all__ = [
    "ClusterFailed",
    "NotServed",
    "PartsProgress",
    "Progress",
    "Report",
    "Verdict",
    "check",
    "connect",
    "estimate",
    "simulate",
    "sweep",
]


#: Reasons why a verdict that a run would show has none. What follows is what scc says.
REFUSED = "its run could not be rebuilt: this is a fault of scc: "
LOST = "its run could not be rebuilt, as scc was lost: "


class NotServed(ClusterFailed):
    """A property that is not decided on a cluster, or not in this order."""

    def __init__(self, message: str):
        super().__init__(message, 64)


@dataclass(frozen=True)
class Verdict:
    name: str
    formula: str
    kind: str  #: holds, holds-up-to-bound, violated, measured or undecided, as in ``scc check --json``
    reasons: List[str]
    schedule: Optional[Any]  #: of a run that shows it, for ``scc trace --schedule``; only of searches
    values: Optional[List[Any]] = None  #: of one that is measured: the numbers, as in ``scc check --json``
    text: Optional[str] = None  #: the same in words


@dataclass
class Report:
    states: int = 0
    transitions: int = 0
    depth: Optional[int] = 0  #: None if owners go in any order, or in that of time
    complete: bool = True
    properties: List[Verdict] = field(default_factory=list)
    dead_ends: List[str] = field(default_factory=list)
    #: A run that goes on for ever within one instant: "cycle", how many transitions lead to the state to which it comes
    #: back, and its "schedule". None if there is none, or if owners go in any order.
    zeno: Optional[Dict[str, Any]] = None
    faults: List[str] = field(default_factory=list)
    recovered: int = 0  #: how often owners were lost and started again
    seconds: float = 0.0  #: of the explorations, without the start of Ray and of the owners
    owners: int = 0
    unkept: List[str] = field(default_factory=list)  #: properties of which nothing is kept, though that was asked for


# Verdicts -----------------------------------------------------------------------------


def both(a: str, b: str) -> str:
    """As good as the worst of them."""
    return next(k for k in ("violated", "undecided", "holds-up-to-bound", "holds") if k in (a, b))


def either(a: str, b: str) -> str:
    """As good as the best of them."""
    return next(k for k in ("holds", "holds-up-to-bound", "undecided", "violated") if k in (a, b))


def reasons_of(p: Progress, most: int, header: Any) -> List[str]:
    found = {
        "states": ["the bound of %d states" % most],
        "levels": ["the bound of %s transitions without passing time" % header["bounds"]["instant"]],
    }.get(p.stopped, [])
    return found + (["a number that is too long (--bits)"] if p.too_long else []) + sorted(set(p.faults))


def verdict(plan: Any, p: Progress) -> str:
    ((kind, of),) = plan.items()
    if kind == "now":
        return {True: "holds", False: "violated"}.get(of, "undecided") if isinstance(of, bool) else "undecided"
    if kind in ("all", "any"):
        parts = [verdict(part, p) for part in of]
        result = "holds" if kind == "all" else "violated"
        for k, part in enumerate(parts):
            result = both(result, part) if kind == "all" else part if k == 0 else either(result, part)
        return result
    if of in p.runs:
        return "holds" if kind == "possibly" else "violated"
    if of not in p.open and of not in p.doubts:
        return "violated" if kind == "possibly" else "holds"
    bounded = of not in p.doubts and not p.faults and p.stopped != "levels"
    return "holds-up-to-bound" if kind == "always" and bounded else "undecided"


def goal_shown(plan: Any, p: Progress) -> Optional[int]:
    """The goal of which a run shows the verdict, of a property that is one search."""
    if plan is None:
        return None
    ((kind, of),) = plan.items()
    return of if kind in ("possibly", "always") and of in p.runs else None


# Checks -------------------------------------------------------------------------------


def has_bounds(header: Any) -> bool:
    """Whether it matters when states are reached."""
    return header["horizon"] is not None or any(goal["within"] is not None for goal in header["goals"])


#: What is served of bounds of time, and where not.
BOUNDS = "%s: bounds of time need the order of time, and not --order any"


def listed(checks: Sequence[Any]) -> str:
    return ", ".join("`%s`" % c["name"] for c in checks)


def served(header: Any, order: str) -> None:
    if order == "any" and has_bounds(header):
        raise NotServed(BOUNDS % listed([c for c in header["checks"] if not c["premise"]]))


def evaluated(header: Any) -> bool:
    """Whether there is more than searches: operators of time within others, probabilities or means."""
    return any(c["plan"] is None and not c["premise"] for c in header["checks"])


def arguments_of(defines: Dict[str, str], checks: Sequence[str], options: Sequence[str]) -> List[str]:
    given = [w for name, value in defines.items() for w in ("-D", "%s=%s" % (name, value))]
    return given + [w for name in checks for w in ("--check", name)] + list(options)


def check(
    model: str,
    *,
    address: Optional[str] = None,
    owners: Optional[int] = None,
    defines: Optional[Dict[str, str]] = None,
    checks: Sequence[str] = (),
    options: Sequence[str] = (),
    states: int = 1 << 40,
    checkpoint: Optional[str] = None,
    deadline: float = 60,
    searches: bool = False,
    order: str = "levels",
    memory: Optional[int] = None,
    scc: Optional[str] = None,
    progress: Optional[Callable[[Progress], None]] = None,
    disturb: Optional[Callable[[Any], None]] = None,
) -> Report:
    """The verdicts of a model, with the numbers, and the runs of searches, of ``scc check --no-reduce order,draws``.

    ``address`` is that of a cluster; without one, Ray is started here. ``owners`` is how many processes share the
    states (by default one for each processor). Shards are kept in the folder ``checkpoint`` about once a second (a
    path that all machines share, or an address of fsspec): lost owners begin again from there, and so does a later call.
    Without it, and without an address, they are kept in a folder that is removed in the end. ``searches``: properties
    that are more than a search are left undecided; else the first owner evaluates them in the end, on the graph of all
    owners without its geometry. ``order``: "levels"; "time", in which states are
    taken in the order of the times at which they are reached, as by ``scc check --shortest time``; or "any", with which
    owners do not wait for each other, and runs need not be the shortest. Where a property has a bound of time, "levels"
    is "time". Levels alone are kept. ``memory``: MiB that each owner takes for its tables, beyond which they are in files.
    ``options`` go to ``scc successors``; ``disturb``
    is called with each exploration once its owners are there (for tests)."""
    if model == "-":
        raise ClusterFailed(MANY, USAGE)
    if order != "levels" and checkpoint is not None:
        raise ClusterFailed("with --order %s nothing is kept: --checkpoint needs --order levels" % order, USAGE)
    given = arguments_of(defines or {}, checks, options)
    report = Report()
    with told(), tempfile.TemporaryDirectory() as scratch:
        numbers = explorations(model, given, order, scc)
        base = checkpoint or (scratch if address is None else None)
        folders: Dict[int, Optional[Folder]] = dict.fromkeys(numbers)
        if base is not None:
            folders = {number: Folder(place(base, str(number)), checkpoint is not None) for number in numbers}
        for folder in folders.values():
            if folder is not None:
                folder.make()
        ray = connect(address, deadline)
        for number, folder in folders.items():
            of_this = given + ["--exploration", str(number)]
            here = address is None
            keeps = checkpoint is not None
            asked: Dict[str, Any] = {"states": states, "order": order, "evaluate": not searches}
            if memory is not None:
                asked["memory"] = memory
            explored(ray, model, of_this, scc, owners, folder, asked, here, keeps, progress, disturb, report)
    return report


def explorations(model: str, given: List[str], order: str, scc: Optional[str]) -> List[int]:
    """Their numbers. All are looked at before anything is explored."""
    count, number = 1, 0
    while number < count:
        number += 1
        f = Filter(model, given + ["--exploration", str(number)], scc=scc)
        f.close()
        served(f.header, order)
        count = f.header["explorations"]
    return list(range(1, count + 1))


def explored(
    ray: Any,
    model: str,
    given: List[str],
    scc: Optional[str],
    owners: Optional[int],
    folder: Optional[Folder],
    asked: Dict[str, Any],
    here: bool,
    keeps: bool,
    progress: Optional[Callable[[Progress], None]],
    disturb: Optional[Callable[[Any], None]],
    report: Report,
) -> None:
    lines = Filter(model, given, scc=scc)
    lines.close()  # until there are runs to be shown
    header = lines.header
    count = owners or max(1, int(ray.cluster_resources().get("CPU", 1)))
    if asked["order"] == "levels" and has_bounds(header):
        asked["order"] = "time"
    in_levels = asked["order"] == "levels"
    if not in_levels:
        folder = None
        report.unkept += [c["name"] for c in header["checks"] if keeps and not c["premise"]]
    if not evaluated(header):
        del asked["evaluate"]
    path, show = os.path.abspath(model), metrics(ray, progress)
    e = Exploration(ray, path, given, scc, header, count, folder, asked, here, show)
    try:
        p = e.run(disturb)
        report.states += p.states
        report.transitions += p.transitions
        deepest = in_levels and report.depth is not None
        report.depth = max(report.depth or 0, p.depth) if deepest else None
        report.seconds, report.owners = report.seconds + e.seconds, count
        report.complete = report.complete and p.complete
        report.dead_ends = sorted(set(report.dead_ends) | set(p.ends))
        report.faults = sorted(set(report.faults) | set(p.faults))
        for k, c in enumerate(header["checks"]):
            if k in p.conclusions:
                report.properties.append(concluded(c, p, asked["states"], header, p.conclusions[k]))
            elif not c["premise"]:
                goal = goal_shown(c["plan"], p)
                choices = None if goal is None else p.runs[goal]
                schedule, why = (None, []) if choices is None else replayed(model, given, scc, goal, choices)
                report.properties.append(shown(c, p, asked["states"], header, schedule, why))
        if p.cycle is not None and report.zeno is None:
            report.zeno = comes_back(model, given, scc, p.cycle)
        report.recovered += e.recovered
    finally:
        e.close()


def replayed(
    model: str, given: List[str], scc: Optional[str], goal: Any, choices: List[int]
) -> Tuple[Optional[Any], List[str]]:
    """The schedule of a run, or why there is none. The verdict does not depend on it."""
    try:
        lines = Filter(model, given, scc=scc)
        try:
            return lines.run(goal, choices)["schedule"], []
        finally:
            lines.close()
    except FilterLost as e:
        return None, [LOST + str(e)]
    except FilterFailed as e:
        return None, [REFUSED + str(e)]


def comes_back(model: str, given: List[str], scc: Optional[str], found: Dict[str, Any]) -> Dict[str, Any]:
    """A cycle in which no time passes, by the rules; or as it was found, if these are not to be had."""
    try:
        lines = Filter(model, given, scc=scc)
        try:
            return dict(lines.cycle(found["from"], found["choices"]))
        finally:
            lines.close()
    except FilterFailed as e:
        return {"cycle": found["from"], "schedule": None, "reason": REFUSED + str(e)}


def shown(
    c: Any, p: Progress, states: int, header: Any, schedule: Optional[Any], why: List[str]
) -> Verdict:
    if c["plan"] is None:
        return Verdict(c["name"], c["formula"], "undecided", ["it is more than a search"], None)
    kind = verdict(c["plan"], p)
    reasons = reasons_of(p, states, header) if kind in ("undecided", "holds-up-to-bound") else []
    return Verdict(c["name"], c["formula"], kind, reasons + why, schedule)


def concluded(c: Any, p: Progress, states: int, header: Any, found: Any) -> Verdict:
    """Of a property that is more than a search."""
    reasons = list(found["reasons"])
    if found["unexplored"] and found["verdict"] in ("undecided", "measured", "holds-up-to-bound"):
        reasons += reasons_of(p, states, header)
    return Verdict(c["name"], c["formula"], found["verdict"], reasons, None, found.get("values"), found.get("text"))


def metrics(ray: Any, progress: Optional[Callable[[Progress], None]]) -> Callable[[Progress], None]:
    """Tells how far it is, on Ray's dashboard as well."""
    gauges = Gauges(ray, **{name: "%s of the exploration" % name for name in ("states", "transitions", "level")})

    def show(p: Progress) -> None:
        gauges.set(states=p.states, transitions=p.transitions, level=p.level)
        if progress is not None:
            progress(p)

    return show
