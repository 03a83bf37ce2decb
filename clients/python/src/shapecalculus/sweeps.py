"""Checks over a grid of parameters: what ``scc sweep`` says, as records."""

from __future__ import annotations

import json
import math
import os
import subprocess
from fractions import Fraction
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Union

from . import numbers
from ._service import how_ended, scc_path
from .errors import ServiceError

#: One line of a table: the parameters by their names, and ``check``, ``verdict``, ``low``, ``high``, ``least_low``,
#: ``least_high``, ``greatest_low``, ``greatest_high`` and ``why``.
Record = Dict[str, Any]

_NUMBERS = ("low", "high", "least_low", "least_high", "greatest_low", "greatest_high")


def _end(value: Optional[str]) -> Union[None, Fraction, float]:
    if value is None:
        return None
    return math.inf if value == "infinite" else numbers.fraction(value)


def _record(parameters: Mapping[str, str], check: Optional[str], verdict: str, why: str) -> Record:
    record: Record = {name: numbers.fraction(value) for name, value in parameters.items()}
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
    return record


def sweep_records(lines: Iterable[str]) -> List[Record]:
    """The records of the lines that ``scc sweep --format jsonl`` has written, of a file, say: one for each point and
    check, and one with the verdict ``"invalid"`` and no check for a point at which the model is invalid. Numbers are
    Fractions, ``math.inf`` or None; ``low`` and ``high`` are the ends over all schedulers. ``pandas.DataFrame`` takes
    the list as it is. ValueError for other lines."""
    records: List[Record] = []
    for number, line in enumerate(lines):
        document = json.loads(line)
        if number == 0:
            if not isinstance(document, dict) or document.get("format") != "scc-sweep":
                raise ValueError("no sweep: the first line is %s" % line.strip()[:100])
            continue
        refused = document["refused"]
        if refused is not None:
            why = "%s: %s" % (refused["code"], refused["message"])
            records.append(_record(document["parameters"], None, "invalid", why))
        records.extend(_of_check(document["parameters"], check) for check in document["checks"])
    return records


def lines_of(output: bytes) -> List[str]:
    """Not by ``str.splitlines``, which ends lines at characters that may stand in them."""
    return [line.decode() for line in output.splitlines()]


def sweep(
    model: Union[str, "os.PathLike[str]"],
    grid: Mapping[str, Sequence[numbers.Number]],
    *,
    scc: Optional[str] = None,
    jobs: int = 1,
    options: Sequence[str] = (),
) -> List[Record]:
    """Checks the model in a file with each combination of values of its parameters, those of the last one fastest, by
    ``jobs`` processes: see ``sweep_records``. ``options`` go to ``scc sweep`` as they are, such as ``["--states",
    "10000"]``. ServiceError where there is no table, with what scc says."""
    command = [scc_path(scc), "sweep", os.fspath(model), "--format", "jsonl"]
    command += ["--jobs", str(numbers.integer(jobs)), *options]
    for name, values in grid.items():
        command += ["-D", "%s=%s" % (name, ",".join(str(numbers.to_json(value)) for value in values))]
    try:
        result = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    except (OSError, ValueError) as error:
        raise ServiceError("cannot start %s: %s" % (command[0], error)) from error
    said = result.stderr.decode("utf-8", "replace").strip()
    if result.returncode not in (0, 2, 3) or not result.stdout:
        raise ServiceError("scc sweep ended%s: %s" % (how_ended(result.returncode, False), said))
    try:
        lines = lines_of(result.stdout)
        points = math.prod(len(axis["values"]) for axis in json.loads(lines[0])["grid"])
        if len(lines) != points + 1:
            raise ValueError("%d of %d points" % (len(lines) - 1, points))
        return sweep_records(lines)
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError) as error:
        raise ServiceError("what scc sweep says is no table: %s" % error) from error
