"""Tables for pandas, which is imported when a table is asked for."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

from . import numbers

Row = Dict[str, Any]


def exact(text: str) -> Fraction:
    """The number of a text "p/q", or of one with decimals."""
    return numbers.fraction(text) if "/" in text else numbers.decimal(text)


def maybe(text: Optional[str]) -> Optional[Fraction]:
    return None if text is None else exact(text)


def end(text: Optional[str]) -> Union[None, Fraction, float]:
    """An end of an interval, which may be infinite."""
    return math.inf if text == "infinite" else maybe(text)


def _float(value: Any) -> Any:
    if isinstance(value, Fraction):
        try:
            return float(value)
        except OverflowError:
            return math.inf if value > 0 else -math.inf
    return value


def as_floats(row: Mapping[str, Any]) -> Row:
    """The row with the nearest float for each Fraction."""
    return {name: _float(value) for name, value in row.items()}


def frame(rows: Sequence[Mapping[str, Any]], columns: Sequence[str], as_float: bool, numeric: Sequence[str]) -> Any:
    """A ``pandas.DataFrame``. ImportError, with what to do, where there is no pandas. ``numeric`` columns become columns
    of floats with ``as_float``, with NaN for None."""
    try:
        import pandas  # pyright: ignore
    except ImportError as error:
        raise ImportError("tables need pandas: python3 -m pip install pandas; without it, take .rows") from error
    table: List[Row] = [as_floats(row) if as_float else dict(row) for row in rows]
    library: Any = pandas
    made: Any = library.DataFrame(table, columns=list(columns), dtype=object)
    return made.astype({name: float for name in numeric}) if as_float else made
