"""How a command of scc ran: what every result of one has."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Tuple

from .diagnostics import Diagnostic


@dataclass(frozen=True)
class Run:
    """One run of a command. ``interrupted``: Ctrl-C or a signal has ended it, and the result is what was there then.
    ``stopped``: so, or by a limit. ``output``: what was written to standard output, or to the file of the option
    ``output``. ``messages``: what was written to standard error. ``diagnostics``: warnings, and errors that did not
    prevent the result."""

    command: Tuple[str, ...]
    exit_code: int
    interrupted: bool
    output: bytes
    messages: str
    diagnostics: Tuple[Diagnostic, ...]

    @property
    def stopped(self) -> bool:
        return self.interrupted or self.exit_code == 4

    @property
    def text(self) -> str:
        """The output as a text."""
        return self.output.decode("utf-8")


class Result:
    """Of any command: how it ran."""

    run: Run

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C or a signal has ended it: it is what was there then."""
        return self.run.interrupted
