"""From the words of a command to its result."""

from __future__ import annotations

import json
import math
import os
from dataclasses import replace
from typing import Any, Callable, List, Optional, Sequence, Tuple, TypeVar

from . import _process
from ._process import Done, Progress
from ._source import STANDARD_INPUT, Path, Source, argument
from .diagnostics import CommandFailed, Diagnostic, Place, of_messages
from .errors import ServiceError
from .results import Estimated, Simulated, Swept, Traced, Viewed, documents
from .runs import Run
from .sweeps import records_of
from .where import Checked

T = TypeVar("T")


def _of_json(document: Any) -> Tuple[Diagnostic, ...]:
    entries: List[Any] = document.get("diagnostics", [])
    return tuple(Diagnostic.from_json(entry) for entry in entries)


def _named(diagnostics: Sequence[Diagnostic], argument: str) -> Tuple[Diagnostic, ...]:
    """The texts of a model have the names that they have for an oracle."""
    # Of a text alone there is no folder.
    folder = None if argument == "-" else os.path.dirname(argument) + os.sep

    def name(file: str) -> str:
        if file in (STANDARD_INPUT, argument):
            return "<model>"
        return file if folder is None or not file.startswith(folder) else file[len(folder) :]

    def renamed(d: Diagnostic) -> Diagnostic:
        return d if d.place is None else replace(d, place=Place(name(d.place.file), d.place.line, d.place.column))

    return tuple(map(renamed, diagnostics))


#: The exit code where a file beside the result cannot be written.
UNWRITTEN = 74


def _read(path: Path) -> bytes:
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return b""


def _result(done: Done, name: str, file: Optional[Path], given: Source, argument: str, make: Callable[[Run], T]) -> T:
    """The result that ``make`` reads, or why there is none."""
    output = done.out if file is None or done.code in (3, 64) else _read(file)
    document: Any = None
    if name in ("check", "estimate"):
        try:
            document = json.loads(output) if output else None
        except (ValueError, RecursionError):
            pass
    diagnostics = of_messages(done.messages) if document is None else _of_json(document)
    if not isinstance(given, (str, os.PathLike)) or argument == "-":
        diagnostics = _named(diagnostics, argument)
    text = done.messages or "\n".join(map(str, diagnostics))
    refused = document is not None and document.get("format") == "scc-diagnostics"
    if not refused and output and done.code in (0, 1, 2, 3, 4, UNWRITTEN):
        said = document is not None and any(
            bound["limit"] == "interrupted" for bound in document.get("explored", {}).get("stopped_by", [])
        )
        interrupted = done.code == 4 and (done.asked or said or "interrupted" in done.messages)
        try:
            result = make(Run(tuple(done.command), done.code, interrupted, output, done.messages, diagnostics))
            if done.code != UNWRITTEN:
                return result
        except (ValueError, LookupError, TypeError, AttributeError, RecursionError) as error:
            if not done.asked:
                raise ServiceError("what scc %s says is no table or report: %s" % (name, error)) from error
        else:
            raise CommandFailed(name, done.code, diagnostics, text, result)
    if done.asked:
        raise KeyboardInterrupt
    raise CommandFailed(name, done.code, diagnostics, text)


def call(
    name: str,
    make: Callable[[Run], T],
    model: Source,
    words: List[str],
    scc: Optional[str],
    progress: Progress,
    file: Optional[Path] = None,
) -> T:
    """Runs a command on a model. ``file``: where its output goes, if not to standard output."""
    with argument(model) as (where, text):
        done = _process.run([name, *words, "--", where], text, scc, progress)
        return _result(done, name, file, model, where, make)


# The commands. Options that decide where and how the result is written are given once more, by their names.


def check(model: Source, words: List[str], scc: Optional[str], progress: Progress) -> Checked:
    def make(run: Run) -> Checked:
        return replace(Checked.from_json(json.loads(run.output)), run=run)

    return call("check", make, model, ["--json", *words], scc, progress)


def estimate(model: Source, words: List[str], scc: Optional[str], progress: Progress) -> Estimated:
    return call("estimate", Estimated.made, model, ["--json", *words], scc, progress)


def _elsewhere(output: Optional[Path], resume: Optional[Path], summary: bool) -> Optional[Path]:
    if output is not None:
        return None if os.fspath(output) == "-" else output
    return None if summary else resume


def simulate(
    model: Source,
    words: List[str],
    scc: Optional[str],
    progress: Progress,
    *,
    output: Optional[Path],
    resume: Optional[Path],
    summary: bool,
    format: str,
) -> Simulated:
    make = Simulated.made if format == "jsonl" else Simulated.text_only
    return call("simulate", make, model, words, scc, progress, _elsewhere(output, resume, summary))


def sweep(
    model: Source,
    words: List[str],
    scc: Optional[str],
    progress: Progress,
    *,
    output: Optional[Path],
    resume: Optional[Path],
    part: Optional[str],
    format: str,
) -> Swept:
    def make(run: Run) -> Swept:
        if format != "jsonl":
            return Swept([], run)
        header, *rest = documents(run.output)
        points = math.prod(len(axis["values"]) for axis in header["grid"])
        if header["format"] != "scc-sweep" or (len(rest) != points and run.exit_code != 4 and part is None):
            raise ValueError("%d of %d points" % (len(rest), points))
        return Swept(records_of(rest), run, [axis["name"] for axis in header["grid"]])

    file = _elsewhere(output, resume, False)
    return call("sweep", make, model, words, scc, progress, file)


def trace(
    model: Source,
    words: List[str],
    scc: Optional[str],
    progress: Progress,
    *,
    output: Optional[Path],
    human: bool,
    itf: bool,
) -> Traced:
    make = Traced.text_only if human or itf else Traced.made
    return call("trace", make, model, words, scc, progress, _elsewhere(output, None, False))


def view(model: Source, words: List[str], scc: Optional[str], progress: Progress, *, output: Optional[Path]) -> Viewed:
    there = [] if output is not None else ["--output=-"]
    return call("view", Viewed.made, model, [*there, *words], scc, progress, _elsewhere(output, None, False))
