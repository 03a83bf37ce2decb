"""What ``scc-cluster check``, ``simulate``, ``sweep`` and ``estimate`` do and write, by Ray (specs/cluster.md)."""

from __future__ import annotations

import io
import json
import os
import sys
import time
from typing import Any, Callable, List, Optional

from . import cluster
from ._estimation import estimated
from ._guard import FAULT, STOPPED, UNWRITTEN, Failed
from ._spread import Outcome, Place, option, simulated, swept

#: What writes to standard output.
Write = Callable[[bytes], None]


def shown(start: float) -> Optional[Callable[[cluster.Progress], None]]:
    if not sys.stderr.isatty():
        return None

    def show(p: cluster.Progress) -> None:
        rate = p.states / max(1e-9, time.time() - start)
        sys.stderr.write(
            "\r\033[Klevel %d: %d states, %d transitions, %d states/s" % (p.level, p.states, p.transitions, rate)
        )
        sys.stderr.flush()

    return show


def clear() -> None:
    if sys.stderr.isatty():
        sys.stderr.write("\r\033[K")


def as_text(report: cluster.Report) -> str:
    lines: List[str] = []
    for v in report.properties:
        kind = v.text or v.kind.replace("holds-up-to-bound", "holds up to the bound")
        lines += ["%s: %s" % (v.name, kind), "  " + v.formula]
        lines += ["    %s" % reason for reason in v.reasons]
        if v.schedule is not None:
            lines.append("    shown by a run of %d transitions" % len(v.schedule["choices"]))
    lines += report.dead_ends + report.faults
    if report.zeno is not None:
        lines.append("Zeno behaviour: a run that goes on for ever within one instant")
        if report.zeno["schedule"] is None:
            lines.append("    " + report.zeno["reason"])
        else:
            steps = len(report.zeno["schedule"]["choices"])
            said = "    after %d transitions, the next %d again and again"
            lines.append(said % (report.zeno["cycle"], steps - report.zeno["cycle"]))
    end = "; complete" if report.complete else ""
    depth = "" if report.depth is None else ", depth %d" % report.depth
    lines.append("explored: %d states, %d transitions%s%s" % (report.states, report.transitions, depth, end))
    return "\n".join(lines) + "\n"


def as_json(report: cluster.Report) -> str:
    document = {
        "format": "scc-cluster-check",
        "version": 1,
        "explored": {
            "states": report.states,
            "transitions": report.transitions,
            "depth": report.depth,
            "complete": report.complete,
        },
        "recovered": report.recovered,
        "dead_ends": report.dead_ends,
        "faults": report.faults,
        "zeno": report.zeno,
        "properties": [v.__dict__ for v in report.properties],
    }
    return json.dumps(document, indent=1) + "\n"


def write(report: cluster.Report, folder: str) -> None:
    os.makedirs(folder, exist_ok=True)
    schedules = {v.name: v.schedule for v in report.properties}
    if report.zeno is not None:
        schedules["zeno-behaviour"] = report.zeno["schedule"]  # no property has this name
    for name, schedule in schedules.items():
        if schedule is not None:
            with open(os.path.join(folder, name + ".json"), "w", encoding="utf-8") as f:
                json.dump(schedule, f, indent=1)


def code_of(report: cluster.Report) -> int:
    kinds = {v.kind for v in report.properties}
    for prefix, code in ((cluster.REFUSED, FAULT), (cluster.LOST, STOPPED)):
        if any(reason.startswith(prefix) for v in report.properties for reason in v.reasons):
            return code
    if "violated" in kinds:
        return 1
    if any(v.kind == "measured" and v.reasons for v in report.properties):
        return 2
    return 2 if "undecided" in kinds or (not report.properties and not report.complete) else 0


def advice(report: cluster.Report, took: float) -> str:
    """Whether one process would have been faster. It takes about as long as all owners together, or less."""
    alone = report.seconds * report.owners
    if alone >= took:
        return ""
    said = "scc-cluster: `scc check` would have been faster: %d states take it about %.1f s, and this took %.1f s\n"
    return said % (report.states, alone, took)


def check(given: Any, out: Write) -> int:
    begin = time.monotonic()
    report = cluster.check(
        given.model,
        address=given.address,
        owners=given.owners,
        defines=dict(given.define),
        checks=given.check,
        options=[w for names in given.no_reduce for w in ("--no-reduce", names)],
        states=given.states,
        checkpoint=given.checkpoint,
        deadline=given.deadline,
        searches=given.searches,
        order=given.order,
        memory=given.memory,
        scc=given.scc,
        progress=shown(time.time()),
    )
    clear()
    unwritten: Optional[OSError] = None
    try:
        if given.witness:
            write(report, given.witness)
    except OSError as e:
        unwritten = e  # The report is told all the same.
    text = as_json(report) if given.json else as_text(report)
    out(text.encode("utf-8", "backslashreplace"))
    if report.unkept:
        names = ", ".join("`%s`" % name for name in report.unkept)
        sys.stderr.write("scc-cluster: nothing was kept of %s: bounds of time need the order of time\n" % names)
    sys.stderr.write(advice(report, time.monotonic() - begin))
    if unwritten is not None:
        raise unwritten
    return code_of(report)


# Simulations and sweeps -----------------------------------------------------------------


class File:
    """One that is made when there is something to write."""

    def __init__(self, path: str):
        self.path = path
        self.file: Optional[io.FileIO] = None

    def write(self, data: bytes) -> None:
        try:
            if self.file is None:
                self.file = open(self.path, "wb", buffering=0)
            left = memoryview(data)
            while left:
                left = left[self.file.write(left) :]
        except OSError as e:
            raise Failed("cannot write: %s: %s" % (self.path, e.strerror or e), UNWRITTEN) from None


def counted() -> Optional[Callable[[cluster.PartsProgress], None]]:
    if not sys.stderr.isatty():
        return None

    def show(p: cluster.PartsProgress) -> None:
        sys.stderr.write("\r\033[K%d of %d %s" % (p.done, p.all, p.what))
        sys.stderr.flush()

    return show


def spread(given: Any, out: Write) -> int:
    where = Place(given.address, given.deadline, given.checkpoint, counted(), ends=True)
    write = out if given.output in (None, "-") else File(given.output).write
    if given.command == "sweep":
        bounds = ("depth", "time", "states", "seconds", "memory", "bits")
        options = ["--%s=%s" % (b, getattr(given, b)) for b in bounds if getattr(given, b) is not None]
        defines = ["=".join(d) for d in given.define]
        outcome = swept(given.model, defines, where, write, form=given.format, options=options, scc=given.scc)
    else:
        outcome = simulated(
            given.model,
            given.runs,
            given.observe,
            given.every,
            given.until,
            where,
            write,
            seed=given.seed,
            steps=given.steps,
            decimals=given.decimals,
            summary=given.summary,
            quantiles=[q for q in given.quantiles.split(",") if q],
            plot=given.plot,
            form=given.format,
            defines=dict(given.define),
            scc=given.scc,
        )
    clear()
    noted(given.command, outcome)
    return outcome.code


def estimate(given: Any, out: Write) -> int:
    where = Place(given.address, given.deadline, given.checkpoint, counted())
    names = "confidence width runs most seed steps until free levels effort memory".split()
    options = [w for name in names for w in option(name, getattr(given, name))]
    options += [w for name in ("check", "property") for text in getattr(given, name) for w in option(name, text)]
    options += ["--normal"] if given.normal else []
    of_answer = (["--json"] if given.json else []) + option("seconds", given.seconds)
    done = estimated(
        given.model, where, out, options=options, of_answer=of_answer, defines=dict(given.define), scc=given.scc
    )
    clear()
    sys.stderr.write(done.said)
    return done.code


def noted(command: str, o: Outcome) -> None:
    sys.stderr.write(o.warnings)
    if o.not_there and command == "sweep":
        sys.stderr.write("scc-cluster: the model is invalid at %d of %d points\n" % (o.not_there, o.count))
    elif o.not_there:
        runs = "1 run" if o.not_there == 1 else "%d runs" % o.not_there
        sys.stderr.write("scc-cluster: %s did not come to the last time; what was not observed is empty\n" % runs)
