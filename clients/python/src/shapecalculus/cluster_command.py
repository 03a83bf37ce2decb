"""``scc-cluster check MODEL``: checks by Ray (specs/cluster.md)."""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from typing import Any, Callable, List, Optional

from . import cluster

EXITS = """exit codes: 0 all hold, 1 a property is violated, 2 something is undecided, 3 the model is invalid or a
shard is not to be read, 4 interrupted, or an owner is lost for good, 64 a wrong command line or a property that is not
served, 69 the cluster does not answer"""


def define(text: str) -> List[str]:
    name, equals, value = text.partition("=")
    if not name or not equals:
        raise argparse.ArgumentTypeError("`%s' is not of the form name=value" % text)
    return [name, value]


def positive(kind: Callable[[str], Any]) -> Callable[[str], Any]:
    def parse(text: str) -> Any:
        try:
            value = kind(text)
        except ValueError:
            value = 0
        if not value > 0:
            raise argparse.ArgumentTypeError("`%s' is no positive number" % text)
        return value

    return parse


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> Any:
        self.exit(64, "scc-cluster: %s\n" % message)


def parser() -> argparse.ArgumentParser:
    top = Parser(
        prog="scc-cluster", description="Checks of the Shape Calculus on many machines, by Ray.", epilog=EXITS
    )
    commands = top.add_subparsers(dest="command", required=True)
    p = commands.add_parser("check", help="explore a model, and decide its searches", epilog=EXITS)
    p.add_argument("model", help="the model, at a path that all machines share")
    p.add_argument("--address", help="of a Ray cluster; without one, Ray is started here")
    p.add_argument("--owners", type=positive(int), metavar="N", help="processes among which states are shared")
    p.add_argument("-D", "--define", type=define, action="append", default=[], metavar="NAME=VALUE")
    p.add_argument("--check", action="append", default=[], metavar="NAME", help="this property alone; repeatable")
    p.add_argument(
        "--searches", action="store_true", help="leave properties undecided that are more than searches"
    )
    p.add_argument(
        "--states", type=positive(int), default=1 << 40, metavar="N", help="keep at most so many states"
    )
    p.add_argument("--no-reduce", action="append", default=[], metavar="NAME,...")
    p.add_argument("--checkpoint", metavar="FOLDER", help="keep each level there, and go on from what is there")
    p.add_argument(
        "--deadline",
        type=positive(float),
        default=60.0,
        metavar="S",
        help="wait so long for an answer of the address",
    )
    p.add_argument("--witness", metavar="FOLDER", help="write the schedule of each run that shows something")
    p.add_argument("--json", action="store_true")
    p.add_argument("--scc", help="the program; by default the environment variable SCC, or scc")
    return top


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


def main(arguments: Optional[List[str]] = None) -> int:
    given = parser().parse_args(arguments)
    options = [w for names in given.no_reduce for w in ("--no-reduce", names)]
    try:
        report = cluster.check(
            given.model,
            address=given.address,
            owners=given.owners,
            defines=dict(given.define),
            checks=given.check,
            options=options,
            states=given.states,
            checkpoint=given.checkpoint,
            deadline=given.deadline,
            searches=given.searches,
            scc=given.scc,
            progress=shown(time.time()),
        )
    except cluster.ClusterFailed as e:
        print("scc-cluster: %s" % e, file=sys.stderr)
        code = e.code
    except KeyboardInterrupt:
        print("scc-cluster: interrupted; what was kept is gone on with by the same --checkpoint", file=sys.stderr)
        code = 4
    else:
        if given.witness:
            write(report, given.witness)
        tell(report, given.json)
        code = code_of(report)
    sys.stdout.flush()
    # A thread may still wait for an address that answers nothing.
    if code == 69:
        os._exit(code)
    return code


if __name__ == "__main__":
    sys.exit(main())
