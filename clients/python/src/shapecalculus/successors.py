"""A client of ``scc successors``: states as bytes, and what follows them (specs/successors.md). Needs numpy."""

from __future__ import annotations

import json
import os
import struct
import subprocess
from dataclasses import dataclass
from typing import Any, List, Optional, Sequence

import numpy as np

#: The version of specs/successors.md that this client speaks.
VERSION = 1

FOLLOWS = ("moves", "rests", "ends", "stops", "fault", "error")


class FilterFailed(Exception):
    """The filter ended, or it does not speak this version. The message is what it said."""


@dataclass(frozen=True)
class Moves:
    """What follows some states, in columns: see specs/successors.md."""

    follows: Any  #: a number for each state, an index into FOLLOWS
    counts: Any  #: how many transitions each has
    ahead: Any  #: for each state, a number for each goal
    fingerprints: bytes  #: 16 bytes for each transition
    labels: Any  #: the number of each transition's label
    notes: Any  #: by the index of a state


@dataclass(frozen=True)
class Targets:
    too_long: Any
    goals: Any  #: for each target, a number for each goal: 0 false, 1 true, 2 undecided
    states: List[bytes]


def scc_path(scc: Optional[str]) -> str:
    return scc or os.environ.get("SCC") or "scc"


class Filter:
    """One ``scc successors`` in batches, about one exploration of a model."""

    def __init__(
        self, model: str, arguments: Sequence[str] = (), *, scc: Optional[str] = None, framing: str = "batches"
    ):
        command = [scc_path(scc), "successors", model, "--framing", framing, *arguments]
        try:
            self.process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
            )
        except OSError as e:
            raise FilterFailed("%s cannot be run: %s" % (command[0], e.strerror)) from None
        self.header = self._header()
        self.goals = len(self.header["goals"])

    def _header(self) -> Any:
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        if not line:
            raise self._failure()
        header = json.loads(line)
        if header.get("format") != "scc-successors" or header.get("version") != VERSION:
            raise FilterFailed(
                "the filter speaks version %s, and %d is understood" % (header.get("version"), VERSION)
            )
        return header

    def _failure(self) -> FilterFailed:
        assert self.process.stderr is not None
        said = self.process.stderr.read().decode(errors="replace").strip()
        return FilterFailed(said or "the filter ended with exit code %s" % self.process.wait())

    def _send(self, data: bytes) -> None:
        assert self.process.stdin is not None
        try:
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

    def _ask(self, kind: int, numbers: Any, data: bytes = b"") -> bytes:
        numbers = np.asarray(numbers, dtype="<u4")
        body = struct.pack("<II", kind, len(numbers)) + numbers.tobytes() + data
        self._send(struct.pack("<I", len(body)) + body)
        return self._frame()

    def expand(self, states: Sequence[bytes]) -> Moves:
        """The transitions of these states."""
        a = self._ask(2, [len(s) for s in states], b"".join(states))
        n, m, text = struct.unpack_from("<3I", a)
        at = 12
        follows = np.frombuffer(a, "u1", n, at)
        counts = np.frombuffer(a, "<u4", n, at + n)
        ahead = np.frombuffer(a, "u1", n * self.goals, at + 5 * n).reshape(n, self.goals)
        at += 5 * n + n * self.goals
        fingerprints = a[at : at + 16 * m]
        labels = np.frombuffer(a, "<u4", m, at + 16 * m)
        told = json.loads(a[at + 20 * m :]) if text else {}
        return Moves(follows, counts, ahead, fingerprints, labels, {d["index"]: d for d in told.get("notes", [])})

    def targets(self, places: Sequence[int]) -> Targets:
        """Of the transitions at these places of the last answer of :meth:`expand`."""
        a = self._ask(3, places)
        n, size, _ = struct.unpack_from("<3I", a)
        too_long = np.frombuffer(a, "u1", n, 12)
        goals = np.frombuffer(a, "u1", n * self.goals, 12 + n).reshape(n, self.goals)
        at = 12 + n + n * self.goals
        ends = at + 4 * n + np.cumsum(np.frombuffer(a, "<u4", n, at), dtype=np.int64)
        begins = [at + 4 * n] + ends.tolist()
        return Targets(too_long, goals, [a[i:j] for i, j in zip(begins, begins[1:])])

    def run(self, goal: int, choices: Sequence[int]) -> Any:
        """Of a filter in lines: the schedule of a run that was found, and the property that it is about."""
        self._send(json.dumps({"goal": goal, "choices": list(choices)}).encode() + b"\n")
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        if not line:
            raise self._failure()
        answer = json.loads(line)
        if "error" in answer:
            raise FilterFailed(answer["error"]["message"])
        return answer

    def close(self) -> None:
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            if pipe is not None:
                try:
                    pipe.close()
                except OSError:
                    pass
        self.process.terminate()
        self.process.wait()
