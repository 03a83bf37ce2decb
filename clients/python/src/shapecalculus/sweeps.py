"""Checks over a grid of parameters: what ``scc sweep`` says, as records."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from typing import Any, Dict, Iterable, List, Mapping, Optional, Union

from . import numbers

#: One line of a table: the parameters by their names, and ``check``, ``verdict``, ``low``, ``high``, ``least_low``,
#: ``least_high``, ``greatest_low``, ``greatest_high`` and ``why``; of estimates ``estimate`` and ``runs`` as well, where
#: ``low`` and ``high`` are the ends of the interval. A parameter with one of these names has it in brackets: ``(low)``.
Record = Dict[str, Any]

_NUMBERS = ("low", "high", "least_low", "least_high", "greatest_low", "greatest_high")
#: The columns after those of the parameters.
COLUMNS = ("check", "verdict", *_NUMBERS, "why")
_APPROXIMATE = "the interval is approximate: right if the mean of the runs is normal"
#: The columns of estimates, after these.
ESTIMATES = ("estimate", "runs")


def column(parameter: str) -> str:
    """The column of a parameter: in brackets where another column has its name."""
    return "(%s)" % parameter if parameter in COLUMNS or parameter in ESTIMATES else parameter


def _end(value: Optional[str]) -> Union[None, Fraction, float]:
    if value is None:
        return None
    return math.inf if value == "infinite" else numbers.fraction(value)


def _record(parameters: Mapping[str, str], check: Optional[str], verdict: str, why: str) -> Record:
    record: Record = {column(name): numbers.fraction(value) for name, value in parameters.items()}
    record.update(check=check, verdict=verdict, **{name: None for name in _NUMBERS}, why=why)
    return record


def _of_check(parameters: Mapping[str, str], check: Mapping[str, Any]) -> Record:
    record = _record(parameters, check["name"], check["verdict"], "; ".join(check["reasons"]))
    values = check["values"]
    for value in values:
        record[value["over"] + "_low"] = _end(value["low"])
        record[value["over"] + "_high"] = _end(value["high"])
    if values:
        record["low"] = _end(values[0]["low"])
        record["high"] = _end(values[-1]["high"])
    made = check.get("estimate")
    if made is not None:
        low, high = ("infinite", "infinite") if made["infinite"] else (made["low"], made["high"])
        value = "infinite" if made["infinite"] else made["value"]
        record.update(low=_end(low), high=_end(high), estimate=_end(value), runs=made["runs"])
        if made.get("approximate"):
            record["why"] = "; ".join([*check["reasons"], _APPROXIMATE])
    return record


def sweep_records(lines: Iterable[str]) -> List[Record]:
    """The records of the lines that ``scc sweep --format jsonl`` has written, of a file, say: one for each point and
    check, and one with the verdict ``"invalid"`` and no check for a point at which the model is invalid. Numbers are
    Fractions, ``math.inf`` or None; ``low`` and ``high`` are the ends over all schedulers. ``pandas.DataFrame`` takes
    the list as it is. ValueError for other lines."""
    documents: List[Any] = []
    for number, line in enumerate(lines):
        document = json.loads(line)
        if number > 0:
            documents.append(document)
        elif not isinstance(document, dict) or document.get("format") != "scc-sweep":  # pyright: ignore
            raise ValueError("no sweep: the first line is %s" % line.strip()[:100])
    return records_of(documents)


def records_of(points: Iterable[Mapping[str, Any]]) -> List[Record]:
    """``sweep_records``, of the lines after the first one, read as JSON."""
    records: List[Record] = []
    for point in points:
        refused = point["refused"]
        if refused is not None:
            why = "%s: %s" % (refused["code"], refused["message"])
            records.append(_record(point["parameters"], None, "invalid", why))
        records.extend(_of_check(point["parameters"], check) for check in point["checks"])
    return records


def lines_of(output: bytes) -> List[str]:
    """Not by ``str.splitlines``, which ends lines at characters that may stand in them."""
    return [line.decode() for line in output.splitlines()]
