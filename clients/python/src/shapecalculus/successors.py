"""A client of ``scc successors`` (specs/successors.md): its process, and the runs that it replays."""

from __future__ import annotations

import json
import subprocess
import tempfile
from typing import Any, Optional, Sequence

from ._guard import FAULT, LIMITS, STOPPED
from ._program import scc_path, why_not

#: The version of specs/successors.md that this client speaks.
VERSION = 2

#: Seconds that a filter has to end by itself.
PATIENCE = 5.0


class FilterFailed(Exception):
    """The filter ended, or it does not speak this version. The message is what it said."""


class FilterLost(FilterFailed):
    """The filter was ended by a signal, a limit of resources or a fault: another one may come further."""


class Program:
    """One ``scc successors``, about one exploration of a model."""

    def __init__(self, model: str, arguments: Sequence[str], scc: Optional[str]):
        command = [scc_path(scc), "successors", model, *arguments]
        # A pipe that nobody reads yet would hold up a program that says much.
        self.said = tempfile.TemporaryFile()
        try:
            self.process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.said
            )
        except OSError as e:
            self.said.close()
            failure = FilterLost if e.errno in LIMITS else FilterFailed
            raise failure(why_not(command[0], e)) from None
        try:
            self.header = self._header()
        except BaseException:
            self.close()
            raise

    def _header(self) -> Any:
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        if not line:
            raise self._failure()
        header = self._read(line)
        if header.get("format") != "scc-successors" or header.get("version") != VERSION:
            raise FilterFailed(
                "the filter speaks version %s, and %d is understood" % (header.get("version"), VERSION)
            )
        return header

    def _read(self, line: bytes) -> Any:
        try:
            document = json.loads(line)
        except (ValueError, RecursionError):
            document = None
        if not isinstance(document, dict):
            if not line.endswith(b"\n"):
                raise self._failure()
            raise FilterFailed("this is no filter of scc: it says %r" % line[:100])
        return document

    def _failure(self) -> FilterFailed:
        """Of a filter that does not go on. It is ended, if it has only closed its streams."""
        self._end()
        self.said.seek(0)
        said = self.said.read().decode(errors="replace").strip()
        code = self.process.returncode
        how = "was ended by signal %d" % -code if code < 0 else "ended with exit code %d" % code
        failure = FilterLost if code < 0 or code in (STOPPED, FAULT) else FilterFailed
        return failure(said or "the filter " + how)

    def _end(self) -> None:
        try:
            self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()

    def _send(self, *parts: Any) -> None:
        assert self.process.stdin is not None
        try:
            for data in parts:
                self.process.stdin.write(data)
            self.process.stdin.flush()
        except OSError:
            raise self._failure() from None

    def close(self) -> None:
        self.process.terminate()
        for pipe in (self.process.stdin, self.process.stdout):
            if pipe is not None:
                try:
                    pipe.close()
                except OSError:
                    pass
        try:
            self._end()
        finally:
            self.said.close()


class Filter(Program):
    """One that answers lines."""

    def __init__(self, model: str, arguments: Sequence[str] = (), *, scc: Optional[str] = None):
        super().__init__(model, arguments, scc)

    def run(self, goal: int, choices: Sequence[int]) -> Any:
        """The schedule of a run that was found, and the property that it is about."""
        return self._replayed({"goal": goal, "choices": list(choices)})

    def cycle(self, start: int, choices: Sequence[int]) -> Any:
        """The schedule of a run that comes back within one instant, and how many transitions lead to where it does."""
        return self._replayed({"cycle": start, "choices": list(choices)})

    def _replayed(self, run: Any) -> Any:
        self._send(json.dumps(run).encode() + b"\n")
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        if not line:
            raise self._failure()
        answer = self._read(line)
        if "error" in answer:
            raise FilterFailed(answer["error"]["message"])
        return answer
