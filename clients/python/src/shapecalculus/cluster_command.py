"""``scc-cluster check``, ``simulate`` and ``sweep``: by Ray (specs/cluster.md)."""

from __future__ import annotations

import json
import os
import sys
import time
from typing import Any, Callable, List, Optional

from . import cluster
from ._command_line import parser
from ._spread import Outcome, Place, simulated, swept


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


def tell(report: cluster.Report, as_json: bool) -> None:
    if as_json:
        print(
            json.dumps(
                {
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
                    "properties": [v.__dict__ for v in report.properties],
                },
                indent=1,
            )
        )
        return
    for v in report.properties:
        print("%s: %s\n  %s" % (v.name, v.kind.replace("holds-up-to-bound", "holds up to the bound"), v.formula))
        for reason in v.reasons:
            print("    %s" % reason)
        if v.schedule is not None:
            print("    shown by a run of %d transitions" % len(v.schedule["choices"]))
    for text in report.dead_ends + report.faults:
        print(text)
    print(
        "explored: %d states, %d transitions, depth %d%s"
        % (report.states, report.transitions, report.depth, "; complete" if report.complete else "")
    )


def write(report: cluster.Report, folder: str) -> None:
    os.makedirs(folder, exist_ok=True)
    for v in report.properties:
        if v.schedule is not None:
            with open(os.path.join(folder, v.name + ".json"), "w", encoding="utf-8") as f:
                json.dump(v.schedule, f, indent=1)


def code_of(report: cluster.Report) -> int:
    kinds = {v.kind for v in report.properties}
    if "violated" in kinds:
        return 1
    return 2 if "undecided" in kinds or (not report.properties and not report.complete) else 0


def check(given: Any) -> int:
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
        scc=given.scc,
        progress=shown(time.time()),
    )
    clear()
    if given.witness:
        write(report, given.witness)
    tell(report, given.json)
    return code_of(report)


# Simulations and sweeps -----------------------------------------------------------------


class Output:
    """A file that is made when there is something to write, or standard output."""

    def __init__(self, path: Optional[str]):
        self.path, self.file = path, None if path not in (None, "-") else sys.stdout.buffer

    def write(self, data: bytes) -> None:
        if self.file is None:
            self.file = open(str(self.path), "wb")
        self.file.write(data)
        self.file.flush()


def counted() -> Optional[Callable[[cluster.PartsProgress], None]]:
    if not sys.stderr.isatty():
        return None

    def show(p: cluster.PartsProgress) -> None:
        sys.stderr.write("\r\033[K%d of %d %s" % (p.done, p.all, p.what))
        sys.stderr.flush()

    return show


def spread(given: Any) -> int:
    where = Place(given.address, given.deadline, given.checkpoint, counted(), ends=True)
    out = Output(given.output)
    if given.command == "sweep":
        bounds = ("depth", "time", "states", "seconds", "memory", "bits")
        options = ["--%s=%s" % (b, getattr(given, b)) for b in bounds if getattr(given, b) is not None]
        defines = ["=".join(d) for d in given.define]
        outcome = swept(given.model, defines, where, out.write, form=given.format, options=options, scc=given.scc)
    else:
        outcome = simulated(
            given.model,
            given.runs,
            given.observe,
            given.every,
            given.until,
            where,
            out.write,
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


def noted(command: str, o: Outcome) -> None:
    sys.stderr.write(o.warnings)
    if o.not_there and command == "sweep":
        sys.stderr.write("scc-cluster: the model is invalid at %d of %d points\n" % (o.not_there, o.count))
    elif o.not_there:
        runs = "1 run" if o.not_there == 1 else "%d runs" % o.not_there
        sys.stderr.write("scc-cluster: %s did not come to the last time; what was not observed is empty\n" % runs)


# All of them ----------------------------------------------------------------------------


def main(arguments: Optional[List[str]] = None) -> int:
    given = parser().parse_args(arguments)
    try:
        code = check(given) if given.command == "check" else spread(given)
        sys.stdout.flush()
    except cluster.ClusterFailed as e:
        clear()
        print("scc-cluster: %s" % e, file=sys.stderr)
        code = e.code
    except KeyboardInterrupt:
        clear()
        print("scc-cluster: interrupted; the same --checkpoint goes on from what was kept", file=sys.stderr)
        code = 4
    except OSError as e:
        clear()
        print("scc-cluster: cannot write: %s" % e, file=sys.stderr)
        code = 74
    if code in (69, 74):
        # A thread may still wait for an address that answers nothing, or an output be full.
        os._exit(code)
    return code


if __name__ == "__main__":
    sys.exit(main())
