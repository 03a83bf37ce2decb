"""``scc-cluster``: the program, within its guard. Ray is imported by the worker alone."""

from __future__ import annotations

import contextlib
import io
import sys
from typing import Callable, List, Optional

from ._guard import USAGE, Failed, Program, run

LOST = "the cluster is lost: the process that leads the work ended without a verdict"
ADVICE = "; the same --checkpoint goes on from what was kept"


def work(arguments: Optional[List[str]], out: Callable[[bytes], None]) -> int:
    from ._command_line import parser

    text = io.StringIO()
    try:
        with contextlib.redirect_stdout(text):
            given = parser().parse_args(arguments)
    except SystemExit:  # after its help
        out(text.getvalue().encode())
        return 0
    try:
        from . import _commands
    except ModuleNotFoundError as e:
        raise Failed("%s is not installed: pip install 'shapecalculus[cluster]'" % e.name, USAGE) from None
    by_name = {"check": _commands.check, "estimate": _commands.estimate}
    return by_name.get(given.command, _commands.spread)(given, out)


def ending() -> None:
    """Ray that was started here ends by itself, if it can."""
    if "ray" in sys.modules:
        sys.modules["ray"].shutdown()


def main(arguments: Optional[List[str]] = None) -> int:
    return run(Program("scc-cluster", lambda out: work(arguments, out), ending, LOST, ADVICE))


if __name__ == "__main__":
    sys.exit(main())
