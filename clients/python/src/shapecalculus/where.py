"""For which values of a model's parameters a check holds: what ``scc check --where --json`` says of each property."""

from __future__ import annotations

import math
import operator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import _display, frames, numbers
from .numbers import Number
from .runs import Run

Json = Mapping[str, Any]
#: A value for each parameter, by their names or in their order.
Point = Union[Mapping[str, Number], Sequence[Number]]
Row = Tuple[Fraction, ...]

#: An end of an interval of numbers: a Fraction, ``math.inf``, or None where it is not known.
Ends = Union[None, Fraction, float]

_NUMBERS = ("low", "high", "least_low", "least_high", "greatest_low", "greatest_high")
_COLUMNS = ("check", "verdict", *_NUMBERS, "bounds", "why")
_RELATIONS = {"<": operator.lt, "<=": operator.le, "=": operator.eq}


def _values(parameters: Sequence[str], point: Point) -> Row:
    if isinstance(point, Mapping):
        if set(point) != set(parameters):
            named = ", ".join(map(str, point))
            raise ValueError("a point has values of %s, not of %s" % (", ".join(parameters), named))
        given = [point[name] for name in parameters]
    else:
        if isinstance(point, str) or len(point) != len(parameters):
            raise ValueError("not %d numbers: %r" % (len(parameters), point))
        given = list(point)
    return tuple(numbers.exact(x) for x in given)


@dataclass(frozen=True)
class Polyhedron:
    """The points x with ``A x`` related to ``b``, row by row, by ``relations``: each of them ``<``, ``<=`` or ``=``.

    The columns of ``A`` are the ``parameters``. Without rows it is the whole space.
    """

    parameters: Tuple[str, ...]
    A: Tuple[Row, ...]
    b: Row
    relations: Tuple[str, ...]

    @classmethod
    def from_json(cls, parameters: Sequence[str], json: Sequence[Json]) -> Polyhedron:
        rows = []
        for constraint in json:
            coefficients: Dict[str, str] = constraint["coefficients"]
            unknown = set(coefficients) - set(parameters)
            if unknown:
                raise ValueError("coefficients of what is no parameter: %s" % ", ".join(sorted(unknown)))
            if constraint["relation"] not in _RELATIONS:
                raise ValueError("not a relation: %r" % (constraint["relation"],))
            rows.append(tuple(numbers.fraction(coefficients.get(name, "0/1")) for name in parameters))
        return cls(
            tuple(parameters),
            tuple(rows),
            tuple(numbers.fraction(constraint["bound"]) for constraint in json),
            tuple(constraint["relation"] for constraint in json),
        )

    def contains(self, point: Point) -> bool:
        """Whether the point is in it, exactly: borders are included where the relation says so."""
        x = _values(self.parameters, point)
        return all(
            _RELATIONS[relation](sum((a * v for a, v in zip(row, x)), Fraction(0)), bound)
            for row, relation, bound in zip(self.A, self.relations, self.b)
        )


@dataclass(frozen=True)
class Region:
    """Disjoint polyhedra, and their volume. It is empty if it has no pieces, not if its volume is 0.

    ``measure`` is None where the volume is not computed, as a piece has too many corners.
    """

    pieces: Tuple[Polyhedron, ...]
    measure: Optional[Fraction]

    @classmethod
    def from_json(cls, parameters: Sequence[str], json: Json) -> Region:
        pieces = tuple(Polyhedron.from_json(parameters, piece) for piece in json["pieces"])
        measure = json["measure"]
        return cls(pieces, None if measure is None else numbers.fraction(measure))

    def contains(self, point: Point) -> bool:
        return any(piece.contains(point) for piece in self.pieces)

    @property
    def is_empty(self) -> bool:
        return not self.pieces


@dataclass(frozen=True)
class Where:
    """Where a check ``holds``, where it ``fails``, and where that is ``unknown``: disjoint, and together the ``range``.

    ``probability``: that it holds where the parameters are independent and uniform in their ranges; None where that
    depends on what is unknown, or where a volume is not computed. It is in ``probability_between`` in any case.
    """

    parameters: Tuple[str, ...]
    range: Polyhedron
    holds: Region
    fails: Region
    unknown: Region
    probability: Optional[Fraction]
    probability_between: Tuple[Fraction, Fraction]

    @classmethod
    def from_json(cls, json: Json) -> Where:
        """Of the member ``where`` of a property."""
        parameters = tuple(json["parameters"])
        if json["probability"] is None:
            low, high = map(numbers.fraction, json["probability_between"])
            probability = None
        else:
            low = high = probability = numbers.fraction(json["probability"])
        return cls(
            parameters,
            Polyhedron.from_json(parameters, json["range"]),
            Region.from_json(parameters, json),
            Region.from_json(parameters, json["fails"]),
            Region.from_json(parameters, json["unknown"]),
            probability,
            (low, high),
        )

    def contains(self, point: Point) -> bool:
        """Whether it is known to hold there."""
        return self.holds.contains(point)

    def outcome(self, point: Point) -> str:
        """``"holds"``, ``"fails"`` or ``"unknown"``. ValueError for a point that is not in the range."""
        for name, region in (("holds", self.holds), ("fails", self.fails), ("unknown", self.unknown)):
            if region.contains(point):
                return name
        raise ValueError("out of range: %r" % (point,))


def wheres(report: Json) -> Dict[str, Where]:
    """Of a report of ``scc check --where --json``, read by ``json.load``: by the names of its checks.

    Those of which it does not tell where they hold are left out.
    """
    return {check["name"]: Where.from_json(check["where"]) for check in report["properties"] if "where" in check}


@dataclass(frozen=True)
class Bound:
    """A bound that was met. ``limit``: ``"depth"``, ``"time"``, ``"instant"``, ``"states"``, ``"bits"``, ``"seconds"``,
    ``"memory"`` (in bytes), ``"interrupted"`` or ``"hash-compaction"``. ``origin``: ``"default"``, ``"user"``,
    ``"property"`` or ``"system"``."""

    limit: str
    value: Union[None, int, Fraction]
    origin: str

    @classmethod
    def from_json(cls, json: Json) -> Bound:
        value = json["value"]
        return cls(json["limit"], frames.exact(value) if isinstance(value, str) else value, json["origin"])

    def __str__(self) -> str:
        unit = " bytes" if self.limit == "memory" else ""
        return self.limit if self.value is None else "%s %s%s (%s)" % (self.limit, _display.plain(self.value), unit, self.origin)


def _between(json: Json) -> Tuple[Ends, Ends]:
    """Without a least end the number is infinite; without a greatest end alone, no bound of it is known."""
    if json["low"] is None:
        return math.inf, math.inf
    return numbers.fraction(json["low"]), frames.maybe(json["high"])


def _single(*betweens: Optional[Tuple[Ends, Ends]]) -> Ends:
    """The number that all these ends are; None if they are several, or none."""
    ends = {end for between in betweens if between is not None for end in between}
    return ends.pop() if len(ends) == 1 else None


@dataclass(frozen=True)
class Form:
    """A sum of parameters times their ``coefficients``, and a ``constant``."""

    parameters: Tuple[str, ...]
    coefficients: Row
    constant: Fraction

    @classmethod
    def from_json(cls, parameters: Sequence[str], json: Json) -> Form:
        row = tuple(numbers.fraction(json["coefficients"].get(name, "0/1")) for name in parameters)
        return cls(tuple(parameters), row, numbers.fraction(json["constant"]))

    def at(self, point: Point) -> Fraction:
        """Its value at the point."""
        terms = zip(self.coefficients, _values(self.parameters, point))
        return sum((a * x for a, x in terms), self.constant)


@dataclass(frozen=True)
class Part:
    """A ``region`` of starts, and the ends between which a number is there. The forms are its ends as functions of the
    parameters; they are None where the ends do not depend on them."""

    region: Region
    low: Ends
    high: Ends
    low_form: Optional[Form]
    high_form: Optional[Form]

    @classmethod
    def from_json(cls, parameters: Sequence[str], json: Json) -> Part:
        low, high = (
            Form.from_json(parameters, json[name]) if name in json else None for name in ("low_form", "high_form")
        )
        return cls(Region.from_json(parameters, json), *_between(json), low, high)

    def at(self, point: Point) -> Tuple[Ends, Ends]:
        """The ends at a point of the region."""
        ends = ((self.low, self.low_form), (self.high, self.high_form))
        low, high = (end if form is None else form.at(point) for end, form in ends)
        return low, high


@dataclass(frozen=True)
class Starts:
    """A probability or a mean as a function of the start. It is between ``low`` and ``high`` for all starts; a
    ``high`` of None is no bound, as where a mean is infinite for some of them only. ``mean``
    has the ends of its mean over a uniform start; None where a volume is not computed. ``parts`` make up the whole range
    if ``check`` was called with ``where``; otherwise there are none. ``unknown``: the starts for which nothing is known of
    the mean of a number at a time, as where it has no value; None if there are none. ``low``, ``high`` and ``parts`` are
    those of all others, and ``mean`` is None if ``unknown`` has a volume."""

    low: Ends
    high: Ends
    mean: Optional[Tuple[Ends, Ends]]
    parts: Tuple[Part, ...]
    unknown: Optional[Region] = None

    @classmethod
    def from_json(cls, parameters: Sequence[str], json: Json) -> Starts:
        mean = None if json["mean"] is None else _between(json["mean"])
        parts = tuple(Part.from_json(parameters, part) for part in json.get("parts", []))
        unknown = Region.from_json(parameters, json["unknown"]) if "unknown" in json else None
        return cls(*_between(json), mean, parts, unknown)

    def at(self, point: Point) -> Tuple[Ends, Ends]:
        """The ends at a start; both are None if nothing is known there. ValueError for a point that is not in the range,
        or if there are no parts."""
        if self.parts and self.unknown is not None and self.unknown.contains(point):
            return None, None
        for part in self.parts:
            if part.region.contains(point):
                return part.at(point)
        raise ValueError("out of range: %r" % (point,) if self.parts else "without parts: check with where=True")


@dataclass(frozen=True)
class CurvePoint:
    """A row of a curve: the answer for all ends of the bound of time from ``time`` on (if ``after``: after it) up to the
    time of the next row. ``time`` has two ends, between which it is; they are equal if it is rational. ``least`` and
    ``greatest`` are as those of a verdict."""

    time: Tuple[Fraction, Fraction]
    after: bool
    least: Optional[Tuple[Ends, Ends]]
    greatest: Optional[Tuple[Ends, Ends]]

    @classmethod
    def from_json(cls, json: Json) -> CurvePoint:
        ends = {value["over"]: _between(value) for value in json["values"]}
        time = (numbers.fraction(json["time"]["low"]), numbers.fraction(json["time"]["high"]))
        return cls(time, json.get("after", False), ends.get("least"), ends.get("greatest"))

    @property
    def value(self) -> Ends:
        """The number, if it is one; else None."""
        return _single(self.least, self.greatest)


@dataclass(frozen=True)
class Verdict:
    """Of one check. ``bounds``: those up to which it holds, or those by which it is undecided.
    ``reasons``: why it is undecided. ``least`` and ``greatest``: of a check that asks for a number, between which ends
    it is, over all schedulers. ``curve``: its rows, if ``check`` was called with ``curve`` for this check. ``starts``:
    how such a number depends on the start, in models with ranges, for "least" and "greatest"."""

    name: str
    formula: str
    verdict: str
    text: str
    bounds: Tuple[Bound, ...]
    reasons: Tuple[str, ...]
    least: Optional[Tuple[Ends, Ends]]
    greatest: Optional[Tuple[Ends, Ends]]
    witness: Optional[Json]
    curve: Tuple[CurvePoint, ...] = ()
    starts: Mapping[str, Starts] = field(default_factory=lambda: {})

    @classmethod
    def from_json(cls, json: Json) -> Verdict:
        met = [reason["bound"] for reason in json["reasons"] if reason["bound"] is not None]
        bounds = tuple(Bound.from_json(bound) for bound in [*json["bounds"], *met])
        ends = {value["over"]: _between(value) for value in json.get("values", [])}
        parameters = [known["parameter"] for known in json.get("over", {}).get("ranges", [])]
        return cls(
            json["name"],
            json["formula"],
            json["verdict"],
            json["text"],
            bounds,
            tuple(reason["text"] for reason in json["reasons"]),
            ends.get("least"),
            ends.get("greatest"),
            json["witness"],
            tuple(CurvePoint.from_json(point) for point in json.get("curve", [])),
            {start["over"]: Starts.from_json(parameters, start) for start in json.get("starts", [])},
        )

    @property
    def value(self) -> Ends:
        """The number that was asked for, if it is one; else None."""
        return _single(self.least, self.greatest)

    def row(self) -> Dict[str, Any]:
        low, high = self.least or (None, None), self.greatest or (None, None)
        return {
            "check": self.name,
            "verdict": self.verdict,
            "low": low[0],
            "high": high[1],
            "least_low": low[0],
            "least_high": low[1],
            "greatest_low": high[0],
            "greatest_high": high[1],
            "bounds": "; ".join(map(str, self.bounds)),
            "why": "; ".join(self.reasons),
        }


@dataclass(frozen=True)
class Checked:
    """What ``check`` tells: a verdict (``"holds"``, ``"holds-up-to-bound"``, ``"violated"``, ``"measured"``,
    ``"undecided"``) for each check by its name, where each holds if that was asked and found, and the report.

    ``checks`` has more of each, ``stopped_by`` says which bounds ended the exploration: none if it is ``complete``, or
    if all was decided before. ``run`` is None where an oracle has checked."""

    verdicts: Dict[str, str]
    where: Dict[str, Where]
    report: Json
    checks: Dict[str, Verdict] = field(default_factory=lambda: {})
    stopped_by: Tuple[Bound, ...] = ()
    complete: bool = False
    run: Optional[Run] = None

    @classmethod
    def from_json(cls, json: Json) -> Checked:
        explored = json["explored"]
        stopped_by = tuple(Bound.from_json(bound) for bound in explored["stopped_by"])
        checks = {check["name"]: Verdict.from_json(check) for check in json["properties"]}
        verdicts = {name: check.verdict for name, check in checks.items()}
        return cls(verdicts, wheres(json), json, checks, stopped_by, explored["complete"])

    def __getitem__(self, name: str) -> Verdict:
        """The verdict of the check with this name. KeyError if there is none."""
        return self.checks[name]

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C or a signal has ended it."""
        return any(bound.limit == "interrupted" for bound in self.stopped_by)

    @property
    def rows(self) -> List[Dict[str, Any]]:
        """A dictionary for each check."""
        return [check.row() for check in self.checks.values()]

    def to_dataframe(self, as_float: bool = False) -> Any:
        """``rows`` as a ``pandas.DataFrame``, with Fractions, or with floats."""
        return frames.frame(self.rows, _COLUMNS, as_float, _NUMBERS)

    def _line(self) -> str:
        said = _display.counted(self.verdicts.values())
        return _display.line("checked", "%s; %s" % (said, _display.explored(self.report)), self.interrupted)

    _repr_pretty_ = _display.pretty

    def _repr_html_(self) -> str:
        rows = [{**check.row(), "formula": check.formula, "verdict": check.verdict} for check in self.checks.values()]
        columns = ("check", "verdict", "formula", "low", "high", "bounds", "why")
        table = _display.table(rows, columns, _display.explored(self.report), most=200)
        return table + _display.messages([str(d) for d in self.run.diagnostics] if self.run else [])
