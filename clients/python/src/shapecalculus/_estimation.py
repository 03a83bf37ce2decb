"""Estimates by Ray: what ``scc estimate`` writes, of runs that many machines make. One ``scc estimate --elsewhere``, on
the machine of the command, asks for runs and judges them; tasks make them, by ``scc estimate --make``."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from ._guard import FAULT, STOPPED, UNWRITTEN, USAGE, VERDICTS
from ._parts import INVALID, Done, PartsProgress, Tries, failed, run
from ._program import scc_path, why_not
from ._ray import Gauges, connect, told
from ._spread import Place, defined, option
from ._waiting import MANY, ClusterFailed, ready

#: The beginning of a line that asks for runs; everything after the last one is the report.
WANTED = b'{"wanted":'

#: Each part reads the model anew: it has so many runs at least, and each processor so many parts at most.
RUNS_OF_PART = 10
PARTS_OF_CORE = 4


@dataclass(frozen=True)
class Question:
    """What is estimated. A run depends on this alone, and on its number."""

    model: str
    arguments: List[str]
    scc: Optional[str]

    def command(self, *options: str) -> List[str]:
        return [scc_path(self.scc), "estimate", self.model, *self.arguments, *options]


def do_runs(question: Question, turn: int, first: int, upto: int, of: str) -> Done:
    """Some runs, on some machine, without the line before them; ``of`` tells what they have to be runs of."""
    done = run(question.command("--make", "%d:%d-%d" % (turn, first, upto)))
    if done.code != 0:
        return done
    lines = done.text.splitlines(keepends=True)
    try:
        made = json.loads(lines[0])["of"]
    except (ValueError, LookupError, TypeError, RecursionError):
        return Done(FAULT, "scc does not say of what the runs are that it makes\n", b"")
    if made != of:
        return Done(INVALID, "%s or scc is another one on some machine than here\n" % question.model, b"")
    if len(lines) != 1 + upto - first or not done.text.endswith(b"\n"):
        return Done(FAULT, "scc has not made the runs %d to %d\n" % (first, upto - 1), b"")
    return Done(0, done.said, b"".join(lines[1:]))


class Runs:
    """Makes runs by tasks."""

    def __init__(self, ray: Any, question: Question):
        self.ray, self.tries = ray, Tries(ray)
        self.question = Question(os.path.abspath(question.model), question.arguments, question.scc)
        self.task = self.tries.task(do_runs)
        self.parts = PARTS_OF_CORE * int(ray.cluster_resources().get("CPU", 1))

    def make(self, asked: Any, write: Callable[[bytes], None]) -> None:
        """Those that are asked for, in order, each part as soon as it and those before it are there."""
        wanted, of = asked["wanted"], asked["of"]
        first, count = wanted["from"], wanted["to"] - wanted["from"]
        parts = max(1, min(count // RUNS_OF_PART, self.parts))
        self.tries.of = {}

        def start(k: int) -> Any:
            bounds: Tuple[int, ...] = tuple(first + i * count // parts for i in (k, k + 1))
            return self.task.remote(self.question, wanted["turn"], *bounds, of)

        futures = {start(k): k for k in range(parts)}
        there: Dict[int, Done] = {}
        turn = 0
        while turn < parts:
            for future in ready(self.ray, list(futures)):
                part = futures.pop(future)
                done = self.tries.got(part, future)
                if done is None:
                    futures[start(part)] = part
                elif done.code != 0:
                    raise failed(done, "a part of the runs")
                else:
                    there[part] = done
            while turn in there:
                write(there.pop(turn).text)
                turn += 1


def estimated(
    model: str,
    where: Place,
    write: Callable[[bytes], Any],
    *,
    options: Sequence[str] = (),
    of_answer: Sequence[str] = (),
    defines: Optional[Dict[str, str]] = None,
    scc: Optional[str] = None,
) -> Done:
    """Writes what ``scc estimate`` does. ``options`` say what is estimated, and ``of_answer`` what is told of it. The
    result has its exit code, and what it says on standard error."""
    if model == "-":
        raise ClusterFailed(MANY, USAGE)
    question = Question(model, [*defined(defines or {}), *options], scc)
    kept = option("store", where.checkpoint)
    with told(), tempfile.TemporaryFile() as said:
        judge = started(question.command("--elsewhere", *of_answer, *kept), said)
        try:
            runs: Optional[Runs] = None
            gauges: Optional[Gauges] = None
            done, text = 0, b""
            assert judge.stdin is not None and judge.stdout is not None
            for line in judge.stdout:
                if not line.startswith(WANTED):
                    text = line + judge.stdout.read()
                    break
                asked = json.loads(line)
                if runs is None or gauges is None:
                    ray = connect(where.address, where.deadline)
                    gauges = Gauges(ray, done="Runs or points that are done", wanted="Runs or points that are wanted")
                    runs = Runs(ray, question)
                    if where.disturb is not None:
                        where.disturb(runs)
                runs.make(asked, lambda data: give(judge, data))
                done += asked["wanted"]["to"] - asked["wanted"]["from"]
                gauges.set(done=done, wanted=done)
                if where.progress is not None:
                    where.progress(PartsProgress("runs", done, done))
            judge.stdin.close()
            code = judge.wait()
        finally:
            judge.kill()
            judge.wait()
        said.seek(0)
        outcome = Done(code, said.read().decode(errors="replace"), text)
    if code not in (*VERDICTS, INVALID, STOPPED, USAGE, UNWRITTEN) or code in VERDICTS and not text:
        raise failed(outcome, "the estimate")
    write(text)
    return outcome


def started(command: Sequence[str], said: Any) -> "subprocess.Popen[bytes]":
    try:
        return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=said)
    except OSError as e:
        raise ClusterFailed(why_not(command[0], e), 3) from None


def give(judge: "subprocess.Popen[bytes]", data: bytes) -> None:
    """Runs. One that has ended meanwhile, as by --seconds, wants no more of them."""
    assert judge.stdin is not None
    try:
        judge.stdin.write(data)
        judge.stdin.flush()
    except OSError:
        pass


def estimate(
    model: str,
    *,
    address: Optional[str] = None,
    checkpoint: Optional[str] = None,
    deadline: float = 60,
    progress: Optional[Callable[[PartsProgress], None]] = None,
    disturb: Optional[Callable[[Any], None]] = None,
    options: Sequence[str] = (),
    defines: Optional[Dict[str, str]] = None,
    scc: Optional[str] = None,
) -> Any:
    """The document of ``scc estimate --json``, of runs that all processors of a cluster make: the same one, however many
    there are. ``options`` are those of the command, as ``["--width", "1/100"]``; runs are kept in the folder
    ``checkpoint`` of this machine, and gone on with. ``disturb`` is called before the first are made (for tests)."""
    pieces: List[bytes] = []
    where = Place(address, deadline, checkpoint, progress, disturb)
    arguments = dict(options=options, of_answer=["--json"], defines=defines, scc=scc)
    done = estimated(model, where, pieces.append, **arguments)  # type: ignore[arg-type]
    if done.code not in VERDICTS:
        raise failed(done, "the estimate")
    return json.loads(b"".join(pieces))
