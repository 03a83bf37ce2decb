"""Magics for notebooks, by IPython (``pip install 'shapecalculus[notebook]'``).

    %load_ext shapecalculus.notebook

``%%scc COMMAND [OPTIONS]`` runs a command of scc on the model in the cell. ``%%scc model NAME`` checks that the cell is a
model, and makes it the variable NAME. ``%scc COMMAND MODEL [OPTIONS]`` runs a command on a file, or on a variable that
is a model. Options are those of the command line; ``%scc COMMAND --help`` shows the manual.

The result is the object that the function of the same name returns (``shapecalculus.check`` and so on): verdicts, rows
and frames of pandas. Simulations and sweeps are drawn as well. ``view`` shows a page in a frame, or, with ``--svg``, a
picture; ``shape`` shows a report and a picture. The other commands show what they print.

Ctrl-C, or Interrupt in the menu, ends a command, and the result is what was found. If the kernel is killed, so is scc.
"""

from __future__ import annotations

import io
import os
import re
import shlex
import tempfile
from typing import Any, Callable, Dict, List, Optional, Tuple

import IPython.display
from IPython.core.error import UsageError
from IPython.core.magic import Magics, line_cell_magic, magics_class

from . import _calls, _display, _process
from ._source import Source, argument
from .diagnostics import CommandFailed, of_messages
from .models import Model

#: Options that decide how and where a command prints, which the magic does.
_OURS = ("--json", "--format", "--output", "-o", "--resume", "--part", "--data", "--human", "--itf", "--color")
# It has no types.
_show: Any = IPython.display
_USAGE = "%%scc COMMAND [OPTIONS] above a model, %%scc model NAME, or %scc COMMAND MODEL [OPTIONS]"


def text(model: str) -> str:
    """The text of a model as an argument: without a line end it would be taken for a path."""
    return model if model.endswith("\n") else model + "\n"


class Printed:
    """What a command has printed, and, of a solid, its picture."""

    def __init__(self, text: str, svg: str = "", alt: str = "") -> None:
        self.text = text
        self.svg = svg
        self._alt = alt

    def __repr__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        picture = _display.picture(self.svg, self._alt) if self.svg else ""
        return picture + _display.messages([self.text] if self.text else [])


class ModelRefused(CommandFailed):
    """A command had no result. A notebook shows what scc says of the cell, and not where in this package it was said."""

    def _render_traceback_(self) -> List[str]:
        return [self.text.rstrip() or str(self)]


class _Line:
    """The line of progress below a cell, which is written over."""

    def __init__(self) -> None:
        self._handle: Any = None

    def show(self, text: str) -> None:
        html = _show.HTML('<pre style="opacity:0.7">%s</pre>' % _display.escaped(text))
        if self._handle is None:
            self._handle = _show.display(html, display_id=True)
        else:
            self._handle.update(html)

    def clear(self) -> None:
        if self._handle is not None:
            self._handle.update(_show.HTML(""))


def _plotted(result: Any) -> None:
    """Shows the plot of a result, where there are matplotlib and something to draw."""
    try:
        axes = result.plot()
    except (ImportError, ValueError):
        return
    file = io.BytesIO()
    axes.figure.savefig(file, format="png", dpi=110)
    _show.display(_show.Image(file.getvalue(), alt=result._line()[1:-1]))


def _check(model: Source, words: List[str], tell: Callable[[str], object]) -> Any:
    return _calls.check(model, words, None, tell)


def _estimate(model: Source, words: List[str], tell: Callable[[str], object]) -> Any:
    return _calls.estimate(model, words, None, tell)


def _simulate(model: Source, words: List[str], tell: Callable[[str], object]) -> Any:
    summary = "--summary" in words
    result = _calls.simulate(
        model, ["--format=jsonl", *words], None, tell, output=None, resume=None, summary=summary, format="jsonl"
    )
    _plotted(result)
    return result


def _sweep(model: Source, words: List[str], tell: Callable[[str], object]) -> Any:
    result = _calls.sweep(model, ["--format=jsonl", *words], None, tell, output=None, resume=None, part=None, format="jsonl")
    _plotted(result)
    return result


def _trace(model: Source, words: List[str], tell: Callable[[str], object]) -> Any:
    return _calls.trace(model, words, None, None, output=None, human=False, itf=False)


def _view(model: Source, words: List[str], tell: Callable[[str], object]) -> Any:
    return _calls.view(model, words, None, tell, output=None)


_COMMANDS: Dict[str, Callable[[Source, List[str], Callable[[str], object]], Any]] = {
    "check": _check,
    "estimate": _estimate,
    "simulate": _simulate,
    "sweep": _sweep,
    "trace": _trace,
    "view": _view,
}


def _failed(command: str, done: _process.Done) -> ModelRefused:
    return ModelRefused(command, done.code, of_messages(done.messages), done.messages)


def _printed(command: str, words: List[str], read: Optional[str]) -> Printed:
    """A command that has no function in this package; ``read`` is its standard input."""
    done = _process.run([command, *words], read, None, None)
    said = done.out.decode("utf-8", "replace")
    if done.asked:
        raise KeyboardInterrupt
    if not said and done.code != 0:
        raise _failed(command, done)
    return Printed(said + done.messages)


def _shape(model: Source, words: List[str]) -> Printed:
    """The report on a polyhedron, and its picture."""
    if any(word == "--svg" or word.startswith("--svg=") for word in words):
        raise UsageError("%scc shape draws a picture in any case: leave --svg out")
    with argument(model) as (where, read), tempfile.TemporaryDirectory(prefix="shapecalculus-") as folder:
        path = os.path.join(folder, "shape.svg")
        if read is not None:  # scc shape reads files alone
            where = os.path.join(folder, "shape")
            with open(where, "w", encoding="utf-8", newline="") as file:
                file.write(read)
        printed = _printed("shape", ["--svg=" + path, *words, "--", where], None)
        said, drawn = printed.text, ""
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                drawn = file.read()
        if read is not None:  # the solid of a cell has no file
            said, drawn = said.replace(where, "solid"), drawn.replace(where, "solid")
        return Printed(said, drawn, "a drawing of the solid")


@magics_class
class SccMagics(Magics):
    """The magics %scc and %%scc."""

    @line_cell_magic
    def scc(self, line: str, cell: Optional[str] = None) -> Any:
        """Runs a command of scc: %%scc COMMAND [OPTIONS] above a model, or %scc COMMAND MODEL [OPTIONS]."""
        try:
            words = shlex.split(line)
        except ValueError as error:
            raise UsageError("%s: %s" % (error, line)) from None
        if not words or not re.fullmatch("[a-z]+", words[0]):
            raise UsageError("usage: " + _USAGE)
        command, *rest = words
        if "--help" in rest:
            return _printed(command, ["--help=plain"], None)
        if command in ("serve", "oracle", "successors"):
            raise UsageError("scc %s speaks to other programs until it is ended; it is no command for a cell" % command)
        self._allowed(command, rest)
        if command == "model":
            return self._named(rest, cell)
        model, options = (text(cell), rest) if cell is not None else self._model(command, rest)
        return self._run(command, model, options)

    def _allowed(self, command: str, words: List[str]) -> None:
        if command not in _COMMANDS:
            return
        for word in words:
            name = word.split("=")[0]
            if name in _OURS:
                raise UsageError("the magic chooses how scc %s prints: leave %s out" % (command, name))

    def _variables(self) -> Dict[str, Any]:
        shell: Any = self.shell
        names: Dict[str, Any] = shell.user_ns
        return names

    def _named(self, words: List[str], cell: Optional[str]) -> None:
        if cell is None or len(words) != 1 or not words[0].isidentifier():
            raise UsageError("usage: %%scc model NAME, above the text of a model")
        # Whether its checks hold does not matter here, so that nothing is explored.
        done = _process.run(["check", "--depth=0", "-"], cell, None, None)
        if done.asked:
            raise KeyboardInterrupt
        if done.code not in (0, 1, 2, 4):
            raise _failed("check", done)
        self._variables()[words[0]] = cell

    def _model(self, command: str, words: List[str]) -> Tuple[Source, List[str]]:
        if not words or words[0].startswith("-"):
            raise UsageError("usage: %%scc %s MODEL [OPTIONS]: a file, or a variable that is a model" % command)
        name, *options = words
        variable = self._variables().get(name) if name.isidentifier() else None
        if isinstance(variable, (str, Model)) and not os.path.exists(name):
            return (text(variable) if isinstance(variable, str) else variable), options
        return name, options

    def _run(self, command: str, model: Source, options: List[str]) -> Any:
        progress = _Line()
        try:
            if command in _COMMANDS:
                return _COMMANDS[command](model, options, progress.show)
            if command == "shape":
                return _shape(model, options)
            with argument(model) as (where, read):
                return _printed(command, [*options, "--", where], read)
        except CommandFailed as error:
            raise ModelRefused(error.command, error.exit_code, error.diagnostics, error.text) from None
        finally:
            progress.clear()


def load_ipython_extension(shell: Any) -> None:
    """What ``%load_ext shapecalculus.notebook`` calls."""
    shell.register_magics(SccMagics)
