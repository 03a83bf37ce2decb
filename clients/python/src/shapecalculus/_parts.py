"""Work that falls into parts, which do not depend on each other, as tasks of Ray: see specs/cluster.md.

Each part is a ``scc simulate`` or ``scc sweep`` with ``--part``, on whatever machine; what they write, one after the
other, is what one ``scc`` writes that does it all.
"""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
from dataclasses import dataclass, replace
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Set

from ._files import BadFile, Folder
from ._guard import FAULT, LIMITS, STOPPED, VERDICTS
from ._program import scc_path, why_not
from ._waiting import MOST_TRIES, ClusterFailed, first_line, ready

#: More parts than anybody has tasks: the first of them is empty, and tells the first line.
NO_PART = "1/1000000000000000"
#: A part of which scc itself was ended so often is no accident.
MOST_DEATHS = 5
#: The exit code of an invalid model, or of another invalid input.
INVALID = 3
#: Parts that work has, as long as there are enough of them: what is lost with a machine is done again.
PARTS = 64


@dataclass(frozen=True)
class Work:
    """What is asked for."""

    command: str  #: simulate or sweep
    model: str
    arguments: List[str]
    form: str  #: csv or jsonl
    scc: Optional[str]

    def part(self, which: str, form: str) -> List[str]:
        options = ["--jobs", "1", "--format", form, "--part", which]
        return [scc_path(self.scc), self.command, self.model, *self.arguments, *options]


@dataclass(frozen=True)
class Done:
    """A part that was done."""

    code: int
    said: str  #: on standard error
    text: bytes


@dataclass
class PartsProgress:
    what: str  #: runs or points
    done: int
    all: int


def without_name(said: str) -> str:
    return re.sub(r"^scc: ", "", said.strip())


def run(command: Sequence[str]) -> Done:
    try:
        p = subprocess.run(list(command), stdin=subprocess.DEVNULL, capture_output=True, check=False)
    except OSError as e:
        code = STOPPED if e.errno in LIMITS else INVALID
        return Done(code, why_not(command[0], e) + "\n", b"")
    said = p.stderr.decode(errors="replace")
    if p.returncode < 0:
        # Ended by its own fault, or by somebody who wanted the memory.
        own = -p.returncode in (signal.SIGSEGV, signal.SIGBUS, signal.SIGILL, signal.SIGFPE, signal.SIGABRT)
        said += "scc was ended by signal %d\n" % -p.returncode
        return Done(FAULT if own else STOPPED, said, p.stdout)
    return Done(p.returncode, said, p.stdout)


def failed(done: Done, what: str) -> ClusterFailed:
    """What is told where scc has not done what it was asked. Its own verdicts are none of the whole."""
    said = without_name(done.said)
    if done.code in VERDICTS or not said:
        said = "%s has exit code %d, and is not what scc writes%s" % (what, done.code, said and ": " + said)
    return ClusterFailed(said, INVALID if done.code in VERDICTS else done.code)


def header(work: Work, form: str) -> Done:
    """The first line of all, or ClusterFailed with what is wrong."""
    done = run(work.part(NO_PART, form))
    if done.code != 0 or done.text.count(b"\n") != 1 or not done.text.endswith(b"\n"):
        raise failed(done, "the first line of the %s" % work.command)
    return done


def understood(work: Work, line: bytes) -> Any:
    """The first line in JSON."""
    try:
        document = json.loads(line)
        if document["format"] == {"simulate": "scc-simulation", "sweep": "scc-sweep"}[work.command]:
            return document
    except (ValueError, LookupError, TypeError, RecursionError):
        pass
    raise failed(Done(0, "", line), "the first line of the %s" % work.command)


def do_part(work: Work, which: str, first: bytes) -> Done:
    """On some machine. Lines of CSV do not tell of which model they are."""
    if work.form == "csv":
        told = run(work.part(NO_PART, "jsonl"))
        if told.code != 0:
            return told
        if told.text != first:
            return Done(3, "%s is another text on some machine than here\n" % work.model, b"")
    return run(work.part(which, work.form))


class Tries:
    """How often tasks were lost. Ray does lost tasks again by itself; those that it gives up are given to it once more."""

    def __init__(self, ray: Any):
        self.ray = ray
        self.again = 0  # how often tasks were lost and done again
        self.of: Dict[int, int] = {}  # how often each of them was

    def task(self, work: Callable[..., Done]) -> Any:
        return self.ray.remote(num_cpus=1, max_retries=MOST_TRIES, scheduling_strategy="SPREAD")(work)

    def got(self, part: int, future: Any) -> Optional[Done]:
        """What a task has come to; None if it was lost, and is to be done again."""
        lost = self.ray.exceptions
        try:
            done: Done = self.ray.get(future)
        except (lost.WorkerCrashedError, lost.NodeDiedError, lost.ObjectLostError, lost.OutOfMemoryError) as e:
            self.was_lost(part, str(e), MOST_TRIES)
            return None
        if done.code in (STOPPED, FAULT):
            self.was_lost(part, done.said or "scc has exit code %d" % done.code, MOST_DEATHS)
            return None
        return done

    def was_lost(self, part: int, why: str, most: int) -> None:
        self.again += 1
        self.of[part] = self.of.get(part, 0) + 1
        if self.of[part] >= most:
            raise ClusterFailed(
                "part %d is lost again and again: %s" % (part + 1, first_line(without_name(why))), STOPPED
            )


# Parts --------------------------------------------------------------------------------


class Spread:
    """The parts of some work, from a checkpoint or by tasks."""

    def __init__(self, ray: Any, work: Work, count: int, folder: Optional[Folder], asked: bytes, first_line: bytes):
        self.ray, self.work, self.count, self.folder = ray, work, count, folder
        self.what = "runs" if work.command == "simulate" else "points"
        self.asked, self.first_line = asked, first_line
        cores = int(ray.cluster_resources().get("CPU", 1))
        self.parts = min(count, max(PARTS, 8 * cores))
        self.left: Set[int] = set()  # parts that are not done
        self.tries = Tries(ray)
        self.task = self.tries.task(do_part)

    # Keeping --------------------------------------------------------------------------

    def file(self, part: int) -> str:
        return "%d.part" % part

    def begin(self) -> None:
        """Takes up what an earlier call has done, and how it had cut the work; nothing is written before."""
        self.fit()
        self.left = {k for k in range(self.parts) if self.kept(k) is None}

    def fit(self) -> None:
        if self.folder is None:
            return
        mine = {
            "command": self.work.command,
            "arguments": self.work.arguments,
            "format": self.work.form,
            "asked": understood(self.work, self.asked),
            "count": self.count,
        }
        data = self.folder.get("parts.json")
        if data is None:
            self.folder.put("parts.json", json.dumps(dict(mine, parts=self.parts)).encode())
            return
        there = json.loads(data)
        other = ", ".join(k for k in mine if there[k] != mine[k])
        if other:
            raise ClusterFailed("%s is of other work: it differs in %s" % (self.folder.path, other), 3)
        self.parts = there["parts"]

    def kept(self, part: int) -> Optional[Done]:
        data = self.folder.get(self.file(part)) if self.folder is not None else None
        if data is None:
            return None
        about, text = data.split(b"\n", 1)
        code, said = json.loads(about)
        return Done(code, said, text)

    def keep(self, part: int, done: Done) -> None:
        if self.folder is not None:
            self.folder.put(self.file(part), json.dumps([done.code, done.said]).encode() + b"\n" + done.text)

    # Doing ----------------------------------------------------------------------------

    def size(self, part: int) -> int:
        return (part + 1) * self.count // self.parts - part * self.count // self.parts

    def start(self, part: int) -> Any:
        there = replace(self.work, model=os.path.abspath(self.work.model))
        return self.task.remote(there, "%d/%d" % (part + 1, self.parts), self.asked)

    def got(self, part: int, future: Any) -> Optional[Done]:
        """What a task has come to; None if it was lost, and is to be done again."""
        done = self.tries.got(part, future)
        if done is None:
            return None
        whole = done.text.startswith(self.first_line) and done.text.endswith(b"\n")
        if done.code not in (0, 2, INVALID) or not whole:
            raise failed(done, "part %d" % (part + 1))
        return done

    def run(
        self,
        progress: Callable[[PartsProgress], None],
        disturb: Optional[Callable[[Any], None]],
        ray_ends: bool = False,
    ) -> Iterator[Done]:
        """All parts in order, each as soon as those before it are there. What is not waited for is cancelled, unless Ray
        ends anyway: Ray 2.60 crashes at times where a task ends while it is cancelled."""
        there: Dict[int, Done] = {}
        left = self.left
        told = PartsProgress(self.what, self.count - sum(self.size(k) for k in left), self.count)
        futures: Dict[Any, int] = {}
        try:
            futures.update((self.start(k), k) for k in sorted(left))
            progress(told)
            if disturb is not None:
                disturb(self)
            for turn in range(self.parts):
                while turn in left:
                    for future in ready(self.ray, list(futures)):
                        part = futures.pop(future)
                        done = self.got(part, future)
                        if done is None:
                            futures[self.start(part)] = part
                            continue
                        self.keep(part, done)
                        if self.folder is None:
                            there[part] = done
                        left.discard(part)
                        told.done += self.size(part)
                        progress(told)
                found = there.pop(turn, None) or self.kept(turn)
                if found is None:
                    assert self.folder is not None
                    raise BadFile("%s is gone" % self.folder.file(self.file(turn)))
                yield found
        finally:
            for future in () if ray_ends else futures:
                self.ray.cancel(future)
