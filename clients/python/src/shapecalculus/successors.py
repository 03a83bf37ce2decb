"""A client of ``scc successors``: states as bytes, and what follows them (specs/successors.md). Needs numpy."""

from __future__ import annotations

import json
import struct
import subprocess
import tempfile
import threading
from dataclasses import dataclass
from typing import Any, Iterator, List, Optional, Sequence

import numpy as np

from ._guard import FAULT, LIMITS, STOPPED
from ._program import scc_path, why_not

#: The version of specs/successors.md that this client speaks.
VERSION = 2

FOLLOWS = ("moves", "rests", "ends", "stops", "fault", "error")


#: Seconds that a filter has to end by itself.
PATIENCE = 5.0


class FilterFailed(Exception):
    """The filter ended, or it does not speak this version. The message is what it said."""


class FilterLost(FilterFailed):
    """The filter was ended by a signal, a limit of resources or a fault: another one may come further."""


@dataclass(frozen=True)
class States:
    """States one after the other, in columns; in frames of the filter, or cut out of them."""

    prints: Any  #: fingerprints: a row of four numbers for each state
    too_long: Any
    goals: Any  #: for each state, a number for each goal: 0 false, 1 true, 2 undecided
    lengths: Any
    data: Any  #: the bytes of all states


@dataclass(frozen=True)
class News:
    """Of the targets of some transitions, those that had not been told before."""

    sources: Any  #: for each target, the index of the state before it
    choices: Any  #: the place of the transition among those of that state
    states: States


@dataclass(frozen=True)
class Told:
    """What follows some states: see specs/successors.md."""

    follows: Any  #: a number for each state, an index into FOLLOWS
    counts: Any  #: how many transitions each has
    notes: Any  #: by the index of a state
    homes: List[News]


def widen(pipe: Any) -> None:
    """Fewer turns between the two ends, where the system can."""
    try:
        import fcntl

        fcntl.fcntl(pipe.fileno(), 1031, 1 << 20)  # F_SETPIPE_SZ, of Linux
    except (ImportError, OSError, ValueError):
        pass


class Filter:
    """One ``scc successors`` in batches, about one exploration of a model."""

    def __init__(
        self, model: str, arguments: Sequence[str] = (), *, scc: Optional[str] = None, framing: str = "batches"
    ):
        command = [scc_path(scc), "successors", model, "--framing", framing, *arguments]
        # A pipe that nobody reads yet would hold up a filter that says much.
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
            for pipe in (self.process.stdin, self.process.stdout):
                widen(pipe)
            self.header = self._header()
            self.goals = len(self.header["goals"])
        except BaseException:
            self.close()
            raise
        self.remembers = False  # something since keep was called last

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

    def _frame(self) -> bytes:
        assert self.process.stdout is not None
        head = self.process.stdout.read(4)
        if len(head) < 4:
            raise self._failure()
        (size,) = struct.unpack("<I", head)
        body = self.process.stdout.read(size)
        if len(body) < size:
            raise self._failure()
        return body

    def _ask(self, kind: int, numbers: Any, data: Any = b"") -> bytes:
        self._request(kind, numbers, data)
        return self._frame()

    def _request(self, kind: int, numbers: Any, data: Any) -> None:
        numbers = np.asarray(numbers, dtype="<u4")
        head = struct.pack("<3I", 8 + numbers.nbytes + len(data), kind, len(numbers))
        self._send(head + numbers.tobytes(), data)

    def news(self, lengths: Any, data: Any, homes: int, batch: int) -> Iterator[Told]:
        """What follows these states, so many at a time, and of the targets what is not remembered, for each home. All
        is remembered. The filter works on the next ones meanwhile."""
        ends = np.concatenate([[0], np.cumsum(lengths, dtype=np.int64)])
        places = [(i, min(i + batch, len(lengths))) for i in range(0, len(lengths), batch)]

        def ask() -> None:
            try:
                for i, j in places:
                    numbers = np.concatenate([[homes], lengths[i:j]])
                    self._request(4, numbers, data[int(ends[i]) : int(ends[j])])
            except FilterFailed:
                pass  # Whoever waits for the answer finds out.

        self.remembers = True
        asking = threading.Thread(target=ask, daemon=True)
        asking.start()
        for _ in places:
            yield self._told()
        asking.join()

    def _told(self) -> Told:
        a = self._frame()
        n, homes, text = struct.unpack_from("<3I", a)
        counts = np.frombuffer(a, "<u4", n, 12)
        follows = np.frombuffer(a, "u1", n, 12 + 4 * n)
        told = json.loads(a[12 + (5 + self.goals) * n :]) if text else {}
        notes = {d["index"]: d for d in told.get("notes", [])}
        return Told(follows, counts, notes, [self._home() for _ in range(homes)])

    def _home(self) -> News:
        a = self._frame()
        n, size, _ = struct.unpack_from("<3I", a)
        prints = np.frombuffer(a, "<u4", 4 * n, 12).reshape(n, 4)
        sources, choices, lengths = np.frombuffer(a, "<u4", 3 * n, 12 + 16 * n).reshape(3, n)
        at = 12 + 28 * n
        too_long = np.frombuffer(a, "u1", n, at)
        goals = np.frombuffer(a, "u1", n * self.goals, at + n).reshape(n, self.goals)
        data = np.frombuffer(a, "u1", size, at + n + n * self.goals)
        return News(sources, choices, States(prints, too_long, goals, lengths, data))

    def meet(self, prints: Any) -> Any:
        """Of each of these fingerprints, 0 if it was remembered when :meth:`keep` was called last; else a number, the
        same for the same ones. All are remembered."""
        self.remembers = True
        a = self._ask(5, [], np.ascontiguousarray(prints, "<u4").tobytes())
        return np.frombuffer(a, "<u4", len(prints), 4)

    def keep(self) -> None:
        """What is remembered stays so."""
        self._ask(6, [0])
        self.remembers = False

    def forget(self, all_of_it: bool = False) -> None:
        """What is remembered since :meth:`keep` was called last."""
        if self.remembers or all_of_it:
            self._ask(6, [2 if all_of_it else 1])
            self.remembers = False

    def run(self, goal: int, choices: Sequence[int]) -> Any:
        """Of a filter in lines: the schedule of a run that was found, and the property that it is about."""
        self._send(json.dumps({"goal": goal, "choices": list(choices)}).encode() + b"\n")
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        if not line:
            raise self._failure()
        answer = self._read(line)
        if "error" in answer:
            raise FilterFailed(answer["error"]["message"])
        return answer

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
