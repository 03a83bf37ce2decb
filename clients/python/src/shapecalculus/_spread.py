"""Simulations and sweeps by Ray: what ``scc simulate`` and ``scc sweep`` write, made by many machines."""

from __future__ import annotations

import os
import re
import tempfile
from dataclasses import dataclass
from typing import Any, Callable, List, Mapping, Optional, Sequence

from . import numbers
from ._files import Folder
from ._guard import USAGE
from ._parts import Done, PartsProgress, Spread, Work, failed, header, run, understood
from ._program import scc_path
from ._ray import Gauges, connect, told
from ._waiting import MANY, ClusterFailed
from .sweeps import Record, lines_of, sweep_records


@dataclass
class Outcome:
    """How it ended. ``code`` is the exit code that ``scc`` has for the whole."""

    count: int  #: runs or points
    code: int = 0
    warnings: str = ""  #: about the model
    not_there: int = 0  #: runs that were over before the last time, or points at which the model is invalid
    again: int = 0  #: how often parts were lost and done again

    def note(self, done: Done) -> None:
        counted = re.search(r"(\d+) runs? did not come|invalid at (\d+) of", done.said)
        self.not_there += int(counted.group(1) or counted.group(2)) if counted else 0
        self.code = max(self.code, 2 if done.code else 0)


@dataclass(frozen=True)
class Place:
    """Where work is done, and how it is watched."""

    address: Optional[str] = None
    deadline: float = 60
    checkpoint: Optional[str] = None
    progress: Optional[Callable[[PartsProgress], None]] = None
    disturb: Optional[Callable[[Any], None]] = None
    ends: bool = False  #: the process ends with this work, and a Ray that was started here with the process


def spread(work: Work, runs: Optional[int], where: Place, write: Callable[[bytes], Any]) -> Outcome:
    """Writes what ``scc`` would, from the first line on, as soon as all before it is there. ``runs`` of a simulation;
    a sweep has as many points as its grid."""
    if work.model == "-":
        raise ClusterFailed(MANY, USAGE)
    with told():
        asked = header(work, "jsonl")
        first_line = asked.text if work.form == "jsonl" else header(work, "csv").text
        grid = understood(work, asked.text)
        count = points(grid) if runs is None else runs
        outcome = Outcome(count, warnings=asked.said)
        folder = None if where.checkpoint is None else Folder(where.checkpoint)
        if folder is not None:
            folder.make()
        ray = connect(where.address, where.deadline)
        parts = Spread(ray, work, count, folder, asked.text, first_line)
        parts.begin()
        gauges = Gauges(ray, done="Runs or points that are done", wanted="Runs or points that are wanted")

        def show(p: PartsProgress) -> None:
            gauges.set(done=p.done, wanted=p.all)
            if where.progress is not None:
                where.progress(p)

        write(first_line)
        for done in parts.run(show, where.disturb, where.ends and where.address is None):
            write(done.text[len(first_line) :])
            outcome.note(done)
        outcome.again = parts.tries.again
    if work.command == "sweep" and outcome.not_there == count:
        outcome.code = 3
    return outcome


def points(asked: Any) -> int:
    count = 1
    for axis in asked["grid"]:
        count *= len(axis["values"])
    return count


def summed_up(
    work: Work, runs: int, where: Place, form: str, options: Sequence[str], write: Callable[[bytes], Any]
) -> Outcome:
    """A simulation of which all runs together are told: they are made by many, and summed up here."""
    with tempfile.TemporaryDirectory() as scratch:
        path = os.path.join(scratch, "runs.jsonl")
        with open(path, "wb") as f:
            outcome = spread(work, runs, where, f.write)
        command = [scc_path(work.scc), work.command, work.model, *work.arguments, "--format", form, "--summary"]
        done = run([*command, *options, "--resume", path])
    if done.code not in (0, 2) or not done.text.endswith(b"\n"):
        raise failed(done, "the summary")
    write(done.text)
    return outcome


def option(name: str, value: Any) -> List[str]:
    return [] if value is None else ["--%s=%s" % (name, value)]


def defined(values: Mapping[str, str]) -> List[str]:
    return ["--define=%s=%s" % item for item in values.items()]


def simulated(
    model: str,
    runs: int,
    observe: Sequence[str],
    every: Any,
    until: Any,
    where: Place,
    write: Callable[[bytes], Any],
    *,
    seed: Any = 0,
    steps: Optional[int] = None,
    decimals: Optional[int] = None,
    summary: bool = False,
    quantiles: Sequence[Any] = (),
    plot: Optional[str] = None,
    form: str = "csv",
    defines: Optional[Mapping[str, str]] = None,
    scc: Optional[str] = None,
) -> Outcome:
    """What ``scc simulate`` writes, piece by piece."""
    arguments = defined(defines or {}) + option("runs", runs) + option("seed", seed) + option("steps", steps)
    arguments += option("every", every) + option("until", until)
    arguments += [w for formula in observe for w in option("observe", formula)]
    if not summary:
        if plot is not None:
            raise ClusterFailed("a plot goes with a summary; `scc simulate --resume --plot` draws from a file", 64)
        arguments += option("decimals", decimals)
        return spread(Work("simulate", model, arguments, form, scc), runs, where, write)
    ending = option("decimals", decimals) + option("plot", plot)
    ending += option("quantiles", ",".join(str(q) for q in quantiles) or None)
    return summed_up(Work("simulate", model, arguments, "jsonl", scc), runs, where, form, ending, write)


def simulate(
    model: str,
    *,
    runs: int,
    observe: Sequence[str],
    every: numbers.Number,
    until: numbers.Number,
    address: Optional[str] = None,
    checkpoint: Optional[str] = None,
    deadline: float = 60,
    progress: Optional[Callable[[PartsProgress], None]] = None,
    disturb: Optional[Callable[[Any], None]] = None,
    **options: Any,
) -> str:
    """What ``scc simulate`` writes, made by all processors of a cluster: the same text, however many there are.

    ``options`` are those of the command: ``seed``, ``steps``, ``decimals``, ``summary``, ``quantiles``, ``form``
    ("csv" or "jsonl"), ``defines``; and ``scc``, the program. What was done is kept in the folder ``checkpoint`` and
    gone on with; ``disturb`` is called once the parts are under way (for tests)."""
    pieces: List[bytes] = []
    where = Place(address, deadline, checkpoint, progress, disturb)
    times = numbers.to_json(every), numbers.to_json(until)
    simulated(model, numbers.integer(runs), observe, *times, where, pieces.append, **options)
    return b"".join(pieces).decode()


def swept(
    model: str,
    defines: Sequence[str],
    where: Place,
    write: Callable[[bytes], Any],
    *,
    form: str = "csv",
    options: Sequence[str] = (),
    scc: Optional[str] = None,
) -> Outcome:
    """What ``scc sweep`` writes, piece by piece."""
    arguments = ["--define=%s" % text for text in defines] + list(options)
    return spread(Work("sweep", model, arguments, form, scc), None, where, write)


def sweep(
    model: str,
    grid: Mapping[str, Sequence[numbers.Number]],
    *,
    address: Optional[str] = None,
    checkpoint: Optional[str] = None,
    deadline: float = 60,
    options: Sequence[str] = (),
    scc: Optional[str] = None,
    progress: Optional[Callable[[PartsProgress], None]] = None,
    disturb: Optional[Callable[[Any], None]] = None,
) -> List[Record]:
    """What ``shapecalculus.sweep`` gives, made by all processors of a cluster: see there, and ``simulate``."""
    pieces: List[bytes] = []
    where = Place(address, deadline, checkpoint, progress, disturb)
    defines = [
        "%s=%s" % (name, ",".join(str(numbers.to_json(v)) for v in values)) for name, values in grid.items()
    ]
    swept(model, defines, where, pieces.append, form="jsonl", options=options, scc=scc)
    return sweep_records(lines_of(b"".join(pieces)))
