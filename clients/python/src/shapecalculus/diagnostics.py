"""What scc says is wrong, with its place; and the exception of a command that has no result."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, List, Mapping, Optional, Tuple

from .errors import ServiceError

Json = Mapping[str, Any]


@dataclass(frozen=True)
class Place:
    """A place in a text: ``file``, and ``line`` and ``column`` from 1; these are None where a whole file is meant."""

    file: str
    line: Optional[int] = None
    column: Optional[int] = None

    @classmethod
    def from_json(cls, json: Json) -> Place:
        return cls(json["file"], json["start"].get("line"), json["start"].get("column"))

    def __str__(self) -> str:
        return ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)


@dataclass(frozen=True)
class Diagnostic:
    """An error or a warning. ``code``, such as ``"SC0201"``, never changes its meaning; ``message`` is for people."""

    code: str
    severity: str
    message: str
    place: Optional[Place]
    hint: Optional[str] = None

    @classmethod
    def from_json(cls, json: Json) -> Diagnostic:
        place = json["place"]
        place = None if place is None else Place.from_json(place)
        return cls(json["code"], json["severity"], json["message"], place, json["hint"])

    def __str__(self) -> str:
        start = "" if self.place is None else "%s: " % self.place
        return "%s%s[%s]: %s" % (start, self.severity, self.code, self.message)


_HEAD = re.compile(r"(?:(?P<place>.*): )?(?P<severity>error|warning)\[(?P<code>SC[0-9]{4})\]: (?P<message>.*)")
_PLACE = re.compile(r"(?P<file>.*?):(?P<line>[0-9]+):(?P<column>[0-9]+)")
_HINT = re.compile(r" *= hint: (?P<hint>.*)")


def _place(text: Optional[str]) -> Optional[Place]:
    if text is None:
        return None
    match = _PLACE.fullmatch(text)
    return Place(match["file"], int(match["line"]), int(match["column"])) if match else Place(text)


def of_messages(messages: str) -> Tuple[Diagnostic, ...]:
    """The diagnostics among the lines that a command writes to standard error."""
    found: List[Diagnostic] = []
    for line in messages.split("\n"):
        head, hint = _HEAD.fullmatch(line), _HINT.fullmatch(line)
        if head:
            found.append(Diagnostic(head["code"], head["severity"], head["message"], _place(head["place"])))
        elif hint and found:
            last = found.pop()
            found.append(Diagnostic(last.code, last.severity, last.message, last.place, hint["hint"]))
    return tuple(found)


class CommandFailed(ServiceError):
    """A command of scc has no result. ``exit_code`` says why: 3, an input is invalid; 64, an option is wrong; 4, a limit
    of the system; 70, a fault of scc; 74, an output cannot be written; negative: a signal. ``code``, ``place`` and
    ``message`` are those of the first error, and all are in ``diagnostics``. ``text`` is what scc has said. ``result``: what it has
    found, where only a file beside it cannot be written; else None."""

    def __init__(
        self, command: str, exit_code: int, diagnostics: Tuple[Diagnostic, ...], text: str, result: Any = None
    ) -> None:
        errors = [d for d in diagnostics if d.severity == "error"]
        how = " (signal %d)" % -exit_code if exit_code < 0 else " (exit code %d)" % exit_code
        said = "\n".join(map(str, errors)) or text.strip()
        super().__init__("scc %s ended%s: %s" % (command, how, said))
        self.command = command
        self.exit_code = exit_code
        self.diagnostics = diagnostics
        self.text = text
        self.result = result
        self.code: Optional[str] = errors[0].code if errors else None
        self.place: Optional[Place] = errors[0].place if errors else None
        self.message: str = errors[0].message if errors else said

    def __reduce__(self) -> Tuple[Any, ...]:
        return (type(self), (self.command, self.exit_code, self.diagnostics, self.text, self.result))
