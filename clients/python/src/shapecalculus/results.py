"""What the commands of scc answer, as objects: simulations, estimates, traces, sweeps and pages."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

from . import _display, _plots, frames, numbers
from .models import Label, State
from .runs import Result, Run
from .sweeps import COLUMNS, ESTIMATES, Record, column

Json = Mapping[str, Any]


def documents(output: bytes) -> List[Json]:
    """JSON Lines. A line without its end is left out: its writing was interrupted."""
    return [json.loads(line) for line in output.split(b"\n")[:-1]]


# Simulations.


@dataclass(frozen=True)
class SimulatedRun:
    """One run: ``values`` by time, and then by observable. None: there is no value. ``ended``: why it was over before
    the last time."""

    number: int
    seed: int
    values: Tuple[Tuple[Optional[Fraction], ...], ...]
    ended: Optional[str]

    @classmethod
    def from_json(cls, json: Json) -> SimulatedRun:
        values = tuple(tuple(frames.maybe(x) for x in row) for row in json["values"])
        return cls(json["run"], int(json["seed"]), values, json["ended"])


@dataclass(frozen=True)
class Moment:
    """A summary of all runs: one observable at one time. ``count`` runs have a value there."""

    time: Fraction
    observable: str
    count: int
    mean: Optional[Fraction]
    variance: Optional[Fraction]
    deviation: Optional[Fraction]
    least: Optional[Fraction]
    quantiles: Tuple[Tuple[Fraction, Optional[Fraction]], ...]
    greatest: Optional[Fraction]

    @classmethod
    def from_json(cls, json: Json) -> Moment:
        mean, variance, deviation = (frames.maybe(json[name]) for name in ("mean", "variance", "deviation"))
        quantiles = tuple((numbers.fraction(q["of"]), frames.maybe(q["value"])) for q in json["quantiles"])
        least, greatest = frames.maybe(json["least"]), frames.maybe(json["greatest"])
        time = frames.exact(json["time"])
        return cls(time, json["observable"], json["count"], mean, variance, deviation, least, quantiles, greatest)

    def row(self) -> Dict[str, Any]:
        row: Dict[str, Any] = {name: value for name, value in self.__dict__.items() if name != "quantiles"}
        row.update(("quantile %s" % of, value) for of, value in self.quantiles)
        return row


@dataclass(frozen=True)
class Simulated(Result):
    """What ``simulate`` has observed: ``runs``, or with ``summary`` the ``summary`` of all. There are fewer than the
    requested runs after an interruption. With ``format="csv"`` there is only ``run.text``."""

    header: Json
    observables: Tuple[str, ...]
    times: Tuple[Fraction, ...]
    runs: Tuple[SimulatedRun, ...]
    summary: Tuple[Moment, ...]
    run: Run

    @classmethod
    def text_only(cls, run: Run) -> Simulated:
        return cls({}, (), (), (), (), run)

    @classmethod
    def made(cls, run: Run) -> Simulated:
        header, *rest = documents(run.output)
        whole = header["summary"] is not None
        return cls(
            header,
            tuple(header["observables"]),
            tuple(numbers.fraction(time) for time in header["times"]),
            () if whole else tuple(SimulatedRun.from_json(line) for line in rest),
            tuple(Moment.from_json(line) for line in rest) if whole else (),
            run,
        )

    @property
    def columns(self) -> Tuple[str, ...]:
        """The observables, as columns: in brackets where a column of the table has that name."""
        ours = ("run", "time", "ended")
        return tuple("(%s)" % name if name in ours else name for name in self.observables)

    def _rows(self) -> Iterator[Dict[str, Any]]:
        for run in self.runs:
            for time, values in zip(self.times, run.values):
                yield {"run": run.number, "time": time, **dict(zip(self.columns, values)), "ended": run.ended}

    @property
    def rows(self) -> List[Dict[str, Any]]:
        """A dictionary for each run and time, or with ``summary`` for each time and observable."""
        return [moment.row() for moment in self.summary] if self.summary else list(self._rows())

    def to_dataframe(self, as_float: bool = False) -> Any:
        """``rows`` as a ``pandas.DataFrame``, with Fractions, or with floats."""
        rows = self.rows
        columns = list(rows[0]) if rows else ["run", "time", *self.columns, "ended"]
        exact = [name for name in columns if name not in ("run", "ended", "observable", "count")]
        return frames.frame(rows, columns, as_float, exact)

    def plot(self, ax: Optional[Any] = None) -> Any:
        """Draws the observables over time, with matplotlib: each run, or with ``summary`` means and deviations. Into
        the axes ``ax``, or into new ones; these are returned."""
        if self.summary:
            return _plots.summary(self.summary, ax)
        if not self.runs:
            raise ValueError("nothing to plot: there are no runs here")
        return _plots.runs(self.times, self.columns, [run.values for run in self.runs], ax)

    def _line(self) -> str:
        runs = "a summary" if self.summary else "%d runs" % len(self.runs)
        said = "%s of %s, at %d times" % (runs, ", ".join(self.observables), len(self.times))
        return _display.line("simulated", said if self.header else "a text of %d bytes" % len(self.run.output), self.interrupted)

    _repr_pretty_ = _display.pretty

    def _repr_html_(self) -> str:
        if not self.header:
            return _display.messages([self.run.text])
        rows = self.rows
        return _display.table(rows, rows[0] if rows else ())


# Estimates.


@dataclass(frozen=True)
class Estimate:
    """One property. ``verdict``: ``"estimated"``, ``"sampled"``, ``"estimated_holds"``, ``"estimated_violated"`` or ``"undecided"``.
    ``kind``: ``"probability"``, ``"mean"``, ``"normal"`` (a mean whose interval is
    approximate), ``"sample"`` (no interval follows), ``"infinite"``, or None where there is
    no value. The number is between ``low`` and ``high`` with the confidence of the estimates; of a mean one of them
    is None if the number has no least or no greatest value. ``mean`` and ``deviation`` are those of the runs. ``counts``: how the runs ended."""

    name: str
    property: str
    verdict: str
    kind: Optional[str]
    low: Optional[Fraction]
    high: Optional[Fraction]
    mean: Optional[Fraction]
    deviation: Optional[Fraction]
    runs: int
    counts: Mapping[str, int]
    chosen_evenly: bool
    reasons: Tuple[str, ...]

    @classmethod
    def from_json(cls, json: Json) -> Estimate:
        value: Json = json["value"] or {}
        counts = ("yes", "no", "numbers", "never", "free", "too_long", "no_value")
        low, high, mean, deviation = (frames.maybe(value.get(x)) for x in ("low", "high", "mean", "deviation"))
        return cls(
            json["name"],
            json["text"],
            json["verdict"],
            value.get("kind"),
            low,
            high,
            mean,
            deviation,
            json["runs"],
            {name: json[name] for name in counts},
            json["chosen_evenly"],
            tuple(json["reasons"]),
        )

    def row(self) -> Dict[str, Any]:
        row = {name: value for name, value in self.__dict__.items() if name not in ("counts", "reasons")}
        row.update(self.counts)
        row["why"] = "; ".join(self.reasons)
        return row


_ESTIMATE = (
    "name property verdict kind low high mean deviation runs yes no numbers never free too_long no_value "
    "chosen_evenly why"
).split()


@dataclass(frozen=True)
class Estimated(Result):
    """What ``estimate`` has found: an entry for each property, by its name, and why other checks were left out."""

    estimates: Tuple[Estimate, ...]
    left_out: Mapping[str, str]
    confidence: Fraction
    report: Json
    run: Run

    @classmethod
    def made(cls, run: Run) -> Estimated:
        report: Json = json.loads(run.output)
        return cls(
            tuple(Estimate.from_json(entry) for entry in report["properties"]),
            {entry["name"]: entry["reason"] for entry in report["left_out"]},
            numbers.fraction(report["confidence"]),
            report,
            run,
        )

    def __getitem__(self, name: str) -> Estimate:
        """The estimate of the property with this name. KeyError if there is none."""
        for estimate in self.estimates:
            if estimate.name == name:
                return estimate
        raise KeyError(name)

    @property
    def stopped(self) -> bool:
        """Ended before its runs were made: by a limit of seconds, or interrupted."""
        return bool(self.report["interrupted"])

    @property
    def rows(self) -> List[Dict[str, Any]]:
        """A dictionary for each property."""
        return [estimate.row() for estimate in self.estimates]

    def to_dataframe(self, as_float: bool = False) -> Any:
        """``rows`` as a ``pandas.DataFrame``, with Fractions, or with floats."""
        return frames.frame(self.rows, _ESTIMATE, as_float, ("low", "high", "mean", "deviation"))

    def _line(self) -> str:
        said = _display.counted(estimate.verdict for estimate in self.estimates)
        return _display.line("estimated", said, self.interrupted)

    _repr_pretty_ = _display.pretty

    def _repr_html_(self) -> str:
        columns = ("name", "verdict", "property", "low", "high", "mean", "deviation", "runs", "why")
        caption = "confidence %s" % self.confidence
        left = ["%s was left out: %s" % item for item in self.left_out.items()]
        return _display.table(self.rows, columns, caption, most=200) + _display.messages(left)


# Traces.


@dataclass(frozen=True)
class TraceStep:
    """A transition of a run. ``choice`` is its number among the ``of`` possible ones. ``time``: after it; so is
    ``state``, which is None with ``states="ends"``."""

    step: int
    choice: int
    of: int
    label: Label
    rules: Tuple[str, ...]
    time: Fraction
    state: Optional[State]

    @classmethod
    def from_json(cls, json: Json) -> TraceStep:
        state = json.get("state")
        return cls(
            json["step"],
            json["choice"],
            json["of"],
            Label.from_json(json["label"]),
            tuple(json["rules"]),
            numbers.fraction(json["time"]),
            None if state is None else State.from_json(state),
        )


_TRACE = ("step", "time", "event", "body", "x", "y", "z", "behaviour")


@dataclass(frozen=True, repr=False)
class Traced(Result):
    """A run of a model, from its ``initial`` state. ``last``: the state in which it was left. ``ending``: ``"open"``
    (at a bound), ``"quiescent"``, ``"stuck"``, ``"zeno"`` or ``"interrupted"``; None if it has no end. With ``human``
    or ``itf`` there is only ``run.text``. What a long run has is read when it is looked at."""

    run: Run
    is_text: bool = False

    @classmethod
    def text_only(cls, run: Run) -> Traced:
        return cls(run, True)

    @classmethod
    def made(cls, run: Run) -> Traced:
        made = cls(run)
        # Whether it is a trace at all. Of a long one, what is looked at is read when it is looked at.
        if made.header["format"] != "scc-trace" or made.ending is not None and made.time is None:
            raise ValueError("no trace")
        return made

    @cached_property
    def _texts(self) -> List[bytes]:
        return [] if self.is_text else self.run.output.split(b"\n")[:-1]

    def _latest(self, member: str) -> Any:
        """A member of the last line that has it."""
        for text in reversed(self._texts):
            line = json.loads(text)
            if member in line:
                return line[member]
        return None

    @cached_property
    def header(self) -> Json:
        return {} if self.is_text else json.loads(self._texts[0])

    @cached_property
    def lines(self) -> Tuple[Json, ...]:
        return tuple(json.loads(text) for text in self._texts)

    @cached_property
    def steps(self) -> Tuple[TraceStep, ...]:
        return tuple(TraceStep.from_json(line) for line in self.lines if line["type"] == "transition")

    @cached_property
    def initial(self) -> Optional[State]:
        for text in self._texts:
            line = json.loads(text)
            if "state" in line:
                return State.from_json(line["state"])
        return None

    @cached_property
    def last(self) -> Optional[State]:
        state = self._latest("state")
        return None if state is None else State.from_json(state)

    @cached_property
    def time(self) -> Optional[Fraction]:
        time = self._latest("time")
        return None if time is None else numbers.fraction(time)

    @cached_property
    def ending(self) -> Optional[str]:
        last = json.loads(self._texts[-1]) if self._texts else {}
        return last["ending"] if last.get("type") == "end" else None

    def __repr__(self) -> str:
        return self._line()

    def _states(self) -> Iterator[Tuple[int, Fraction, Optional[Label], State]]:
        if self.initial is not None:
            yield 0, Fraction(0), None, self.initial
        for step in self.steps:
            if step.state is not None:
                yield step.step, step.time, step.label, step.state
        after = self.lines[-2:-1]
        if self.ending is not None and self.last is not None and after and after[0]["type"] in ("state", "instant"):
            if self.steps or after[0]["type"] == "instant":
                yield len(self.steps), numbers.fraction(after[0]["time"]), None, self.last

    @property
    def rows(self) -> List[Dict[str, Any]]:
        """A dictionary for each state of the trace and each body in it."""
        rows: List[Dict[str, Any]] = []
        for step, time, label, state in self._states():
            event = None if label is None else label.text
            for process in state.processes:
                for leaf in process.leaves:
                    x, y, z = leaf.position
                    row = {"step": step, "time": time, "event": event, "body": leaf.name}
                    rows.append({**row, "x": x, "y": y, "z": z, "behaviour": leaf.behaviour})
        return rows

    def to_dataframe(self, as_float: bool = False) -> Any:
        """``rows`` as a ``pandas.DataFrame``, with Fractions, or with floats."""
        return frames.frame(self.rows, _TRACE, as_float, ("time", "x", "y", "z"))

    def _line(self) -> str:
        if not self.header:
            return _display.line("traced", "a text of %d bytes" % len(self.run.output), self.interrupted)
        said = "%d steps to time %s, %s" % (self._latest("step") or 0, _display.plain(self.time), self.ending)
        return _display.line("traced", said, self.interrupted)

    _repr_pretty_ = _display.pretty

    def _repr_html_(self) -> str:
        if not self.header:
            return _display.messages([self.run.text])
        return _display.table(self.rows, _TRACE, self._line()[1:-1], most=60)


# Sweeps.


class Swept(List[Record], Result):
    """The table of a sweep: a list of records (``sweep_records``), which tells how it was made. ``parameters``: their
    names."""

    def __init__(self, records: Sequence[Record], run: Run, parameters: Sequence[str] = ()) -> None:
        super().__init__(records)
        self.run = run
        self.parameters: Tuple[str, ...] = tuple(parameters)

    @property
    def columns(self) -> Tuple[str, ...]:
        """The parameters, as columns: in brackets where another column of the table has that name."""
        return tuple(map(column, self.parameters))

    @property
    def rows(self) -> List[Record]:
        """The records."""
        return list(self)

    def to_dataframe(self, as_float: bool = False) -> Any:
        """``rows`` as a ``pandas.DataFrame``, with Fractions, or with floats."""
        all_columns = [*COLUMNS, *(name for name in ESTIMATES if any(name in row for row in self.rows))]
        numeric = [name for name in all_columns if name not in ("check", "verdict", "why", "runs")]
        return frames.frame(self, [*self.columns, *all_columns], as_float, [*self.columns, *numeric])

    def plot(self, ax: Optional[Any] = None) -> Any:
        """Draws the numbers of checks over the first parameter, with matplotlib, or their verdicts: a curve for each
        check and each value of the other parameters. Into the axes ``ax``, or into new ones; these are returned."""
        return _plots.sweep(self, self.columns, ax)

    def _line(self) -> str:
        said = "%s over %s" % (_display.counted(row["verdict"] for row in self), ", ".join(self.parameters))
        return _display.line("swept", said, self.interrupted)

    _repr_pretty_ = _display.pretty

    def _repr_html_(self) -> str:
        columns = ("check", "verdict", "estimate", "low", "high", "runs", "why")
        return _display.table(self, [*self.columns, *columns])


# Pages.


@dataclass(frozen=True)
class Viewed(Result):
    """What ``view`` has written: a page (HTML), with ``svg`` a picture, or with ``data`` the JSON of a page. It is in the
    file of the option ``output``, and in ``content``; without ``output`` it is in ``content`` alone."""

    content: str
    run: Run

    @classmethod
    def made(cls, run: Run) -> Viewed:
        return cls(run.text, run)

    @property
    def data(self) -> Any:
        """The JSON of a page that was made with ``data``. ValueError for others."""
        return json.loads(self.content)

    def save(self, path: Union[str, Any]) -> None:
        """Writes ``content`` to a file."""
        with open(path, "wb") as file:
            file.write(self.run.output)

    def _line(self) -> str:
        kind = "picture" if self._is_picture else "page" if self._is_page else "data"
        return _display.line("viewed", "a %s of %d bytes" % (kind, len(self.run.output)), self.interrupted)

    _repr_pretty_ = _display.pretty

    @property
    def _is_picture(self) -> bool:
        return self.content.startswith("<svg")

    @property
    def _is_page(self) -> bool:
        return self.content.lower().startswith("<!doctype html")

    def _repr_html_(self) -> Optional[str]:
        if self._is_picture:
            return _display.picture(self.content, "a state of a model")
        return _display.page(self.content) if self._is_page else None
