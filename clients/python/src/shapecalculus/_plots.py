"""Plots of simulations and sweeps, by matplotlib, which is imported when a plot is asked for."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Dict, List, Optional, Sequence

from . import _display
from .sweeps import Record

#: Runs that are drawn by themselves; of more, the first ones are.
RUNS = 50


def axes(given: Optional[Any]) -> Any:
    """The axes to draw into, or new ones. ImportError, with what to do, where there is no matplotlib."""
    if given is not None:
        return given
    try:
        from matplotlib.figure import Figure  # pyright: ignore
    except ImportError as error:
        raise ImportError("plots need matplotlib: python3 -m pip install matplotlib") from error
    made: Any = Figure(figsize=(7, 4), layout="constrained")
    return made.add_subplot()


def literal(text: str) -> str:
    """The text itself: matplotlib would set what is between two $ as a formula."""
    return text.replace("$", r"\$")


def number(value: Any) -> float:
    """The nearest float; NaN where there is no value."""
    if value is None:
        return math.nan
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def runs(times: Sequence[Fraction], names: Sequence[str], values: Sequence[Sequence[Sequence[Any]]], into: Any) -> Any:
    """Lines over time: a colour for each observable, a line for each run."""
    drawn = axes(into)
    across = [number(time) for time in times]
    shown = values[:RUNS]
    for i, name in enumerate(names):
        for k, run in enumerate(shown):
            line = [number(moment[i]) for moment in run]
            label = literal(name) if k == 0 else "_"
            faint = 1.0 if len(shown) == 1 else max(0.15, 1 / math.sqrt(len(shown)))
            drawn.plot(across[: len(line)], line, color="C%d" % (i % 10), alpha=faint, label=label)
    drawn.set_xlabel("time")
    legend(drawn)
    return drawn


def summary(moments: Sequence[Any], into: Any) -> Any:
    """The mean of each observable over time, and around it one standard deviation."""
    drawn = axes(into)
    names = list(dict.fromkeys(moment.observable for moment in moments))
    for i, name in enumerate(names):
        here = [moment for moment in moments if moment.observable == name]
        across = [number(moment.time) for moment in here]
        mean = [number(moment.mean) for moment in here]
        spread = [number(moment.deviation) for moment in here]
        colour = "C%d" % (i % 10)
        drawn.plot(across, mean, color=colour, label=literal("mean of " + name))
        low = [m - s for m, s in zip(mean, spread)]
        high = [m + s for m, s in zip(mean, spread)]
        drawn.fill_between(across, low, high, color=colour, alpha=0.2, linewidth=0)
    drawn.set_xlabel("time")
    legend(drawn)
    return drawn


#: The colours of verdicts, and the signs that say the same without colour.
_VERDICTS = {
    "holds": ("#1a7f37", "✓"),
    "holds-up-to-bound": ("#7fb98c", "✓"),
    "estimated_holds": ("#7fb98c", "✓"),
    "violated": ("#c9364b", "✗"),
    "estimated_violated": ("#e08c98", "✗"),
    "undecided": ("#d9a441", "?"),
}
#: So many curves are drawn, and so many points of a table of verdicts.
CURVES = 10
POINTS = 60


def _curves(records: Sequence[Record], along: str, fixed: Sequence[str]) -> Dict[str, List[Record]]:
    """The records with numbers, of each check and of each value of the other parameters, in the order of ``along``."""
    curves: Dict[str, List[Record]] = {}
    for record in records:
        if record["low"] is not None or record["high"] is not None:
            rest = ", ".join("%s = %s" % (name, _display.plain(record[name])) for name in fixed)
            curves.setdefault("%s%s" % (record["check"], " (%s)" % rest if rest else ""), []).append(record)
    return {name: sorted(found, key=lambda r: r[along]) for name, found in curves.items()}


def sweep(records: Sequence[Record], parameters: Sequence[str], into: Any) -> Any:
    """Curves over the first parameter: intervals of numbers, or, where there are no numbers, a table of verdicts."""
    checked = [record for record in records if record["check"] is not None]
    if not parameters or not checked:
        raise ValueError("nothing to plot: no point of the sweep has a check")
    curves = _curves(checked, parameters[0], parameters[1:])
    drawn = axes(into)
    if not curves:
        return verdicts(checked, parameters, drawn)
    for name, found in list(curves.items())[:CURVES]:
        across = [number(record[parameters[0]]) for record in found]
        lows, highs = [number(record["low"]) for record in found], [number(record["high"]) for record in found]
        middle = [(low + high) / 2 for low, high in zip(lows, highs)]
        (line,) = drawn.plot(across, middle, marker="o", label=literal(name))
        drawn.fill_between(across, lows, highs, color=line.get_color(), alpha=0.2, linewidth=0)
    if len(curves) > CURVES:
        drawn.set_title("%d of %d curves" % (CURVES, len(curves)))
    drawn.set_xlabel(literal(parameters[0]))
    legend(drawn)
    return drawn


def verdicts(records: Sequence[Record], parameters: Sequence[str], drawn: Any) -> Any:
    """A row for each check and a column for each point: the colour and the sign of its verdict."""
    points = list(dict.fromkeys(tuple(record[name] for name in parameters) for record in records))
    names = list(dict.fromkeys(str(record["check"]) for record in records))
    for record in records:
        column, row = points.index(tuple(record[name] for name in parameters)), names.index(str(record["check"]))
        colour, sign = _VERDICTS.get(record["verdict"], ("#8888", ""))
        if column < POINTS:
            drawn.fill_between([column - 0.5, column + 0.5], row - 0.5, row + 0.5, color=colour, linewidth=0)
            drawn.text(column, row, sign, ha="center", va="center", color="white")
    shown = points[:POINTS]
    if len(points) > POINTS:
        drawn.set_title("%d of %d points" % (POINTS, len(points)))
    drawn.set_yticks(range(len(names)), [literal(name) for name in names])
    labels = [", ".join(map(_display.plain, point)) for point in shown]
    drawn.set_xticks(range(len(shown)), labels, rotation=0 if sum(map(len, labels)) < 60 else 90)
    drawn.set_xlim(-0.5, len(shown) - 0.5)
    drawn.set_ylim(len(names) - 0.5, -0.5)
    drawn.set_xlabel(literal(", ".join(parameters)))
    return drawn


def legend(drawn: Any) -> None:
    """Names of what is drawn, beside it where there are many."""
    handles, labels = drawn.get_legend_handles_labels()
    if len(labels) > 8:
        drawn.legend(handles, labels, fontsize="small", loc="center left", bbox_to_anchor=(1.01, 0.5))
    elif labels:
        drawn.legend(handles, labels)
