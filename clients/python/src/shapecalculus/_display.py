"""What results look like in a notebook: HTML, and one line of plain text.

Everything that comes from a model, such as names, formulas and messages, is escaped. Pictures are images, in which no
script runs. A page with scripts is in a frame of an origin of its own, which sees nothing of the notebook.
"""

from __future__ import annotations

import base64
import html
import math
from fractions import Fraction
from typing import Any, Dict, Iterable, List, Mapping, Protocol, Sequence

from . import numbers

#: A table shows so many rows; the result has all.
ROWS = 12
#: The longest text of a cell.
LONGEST = 400
#: The height of a page, in pixels.
HEIGHT = 640

_MARKS = {
    "holds": ("#116329", "✓"),
    "holds-up-to-bound": ("#116329", "✓"),
    "estimated_holds": ("#116329", "✓"),
    "violated": ("#a40e26", "✗"),
    "estimated_violated": ("#a40e26", "✗"),
    "undecided": ("#8a4600", "?"),
    "invalid": ("#a40e26", "✗"),
}


def escaped(text: str) -> str:
    return html.escape(text, quote=True)


def plain(value: Any) -> str:
    """A value as a short text: an exact number, or, where that is long, a decimal with the sign of rounding."""
    if value is None:
        return ""
    if isinstance(value, Fraction):
        # Python writes no long integers, so that their bits decide first.
        small = max(value.numerator.bit_length(), value.denominator.bit_length()) <= 64
        exact = str(value) if small else ""
        return exact if small and len(exact) <= 16 else "≈ " + numbers.rounded(value)
    if isinstance(value, int) and value.bit_length() > 3 * LONGEST:
        return "≈ " + numbers.rounded(value)
    if isinstance(value, float) and math.isinf(value):
        return "∞" if value > 0 else "-∞"
    text = str(value)
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"


def _cell(column: str, value: Any) -> str:
    text = escaped(plain(value))
    if column == "verdict" and value in _MARKS:
        colour, mark = _MARKS[value]
        text = '<span style="color:%s">%s %s</span>' % (colour, mark, text)
    align = "right" if isinstance(value, (int, float, Fraction)) and not isinstance(value, bool) else "left"
    return '<td style="text-align:%s">%s</td>' % (align, text)


def table(rows: Sequence[Mapping[str, Any]], columns: Iterable[str], caption: str = "", most: int = ROWS) -> str:
    """A table of the first rows. Columns that are empty in all rows are left out."""
    kept = [c for c in columns if any(row.get(c) not in (None, "") for row in rows)]
    lines = ["<table>"]
    if caption:
        lines.append('<caption style="text-align:left">%s</caption>' % escaped(caption))
    heads = "".join('<th style="text-align:left">%s</th>' % escaped(c) for c in kept)
    lines.append("<thead><tr>%s</tr></thead><tbody>" % heads)
    lines += ["<tr>%s</tr>" % "".join(_cell(c, row.get(c)) for c in kept) for row in rows[:most]]
    lines.append("</tbody></table>")
    if len(rows) > most:
        lines.append("<p>%d of %d rows; <code>.rows</code> has all</p>" % (most, len(rows)))
    return "\n".join(lines)


def page(content: str, height: int = HEIGHT) -> str:
    """A page of scc view, in a frame that may run scripts and save files, and nothing else: no windows, and no access
    to the notebook."""
    return (
        '<iframe sandbox="allow-scripts allow-downloads" title="The runs of a model" width="100%%" height="%d" '
        'style="border:1px solid #8888;box-sizing:border-box" srcdoc="%s"></iframe>' % (height, escaped(content))
    )


def picture(svg: str, alt: str) -> str:
    """A drawing, as an image: scripts in it do not run."""
    data = base64.b64encode(svg.encode("utf-8")).decode("ascii")
    return '<img style="max-width:100%%" alt="%s" src="data:image/svg+xml;base64,%s">' % (escaped(alt), data)


def messages(texts: Sequence[str]) -> str:
    """Warnings, as scc writes them."""
    return "".join("<pre>%s</pre>" % escaped(text) for text in texts)


def explored(report: Mapping[str, Any]) -> str:
    """How much was explored, and what ended it."""
    known = report["explored"]
    said = "%d states, %d transitions, depth %d" % (known["states"], known["transitions"], known["depth"])
    stopped: List[str] = list(dict.fromkeys(str(bound["limit"]) for bound in known["stopped_by"]))
    if stopped:
        return "%s; stopped by: %s" % (said, ", ".join(stopped))
    return said + ("; complete" if known["complete"] else "")


def counted(verdicts: Iterable[str]) -> str:
    """How many checks have each verdict, in one line."""
    counts: Dict[str, int] = {}
    for verdict in verdicts:
        counts[verdict] = counts.get(verdict, 0) + 1
    return ", ".join("%d %s" % (count, name) for name, count in counts.items()) or "no checks"


class Line(Protocol):
    """A result that has a line of plain text."""

    def _line(self) -> str: ...


def pretty(self: Line, printer: Any, cycle: bool) -> None:
    """How IPython prints a result, as its method ``_repr_pretty_``: in one line, not with all its fields."""
    printer.text(self._line())


def line(kind: str, text: str, interrupted: bool = False) -> str:
    """What a result is as plain text."""
    return "<%s: %s%s>" % (kind, text, ", interrupted" if interrupted else "")
