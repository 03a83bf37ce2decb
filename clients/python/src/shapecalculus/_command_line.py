"""The command line of ``scc-cluster``."""

from __future__ import annotations

import argparse
from typing import Any, Callable, List

from ._guard import USAGE, Failed

EXITS = """exit codes: 0 all hold, all runs came to their end, or all points are decided; 1 a property is violated; 2
something is undecided, a run was over early, or a point is invalid; 3 the model is invalid, or a checkpoint is of other
work or damaged; 4 interrupted, a limit of resources, or an owner, a part or the cluster is lost for good, or nobody
reads the output; 64 a wrong command line, or a property that is not served; 69 the cluster does not answer; 70 a fault
of the program; 74 something cannot be written"""

LIKE = (
    "What it writes is what `scc %s' does, on however many processors; see `scc %s --help' for what is asked for."
)


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
        if not 0 < value < float("inf"):
            raise argparse.ArgumentTypeError("`%s' is no positive number" % text)
        return value

    return parse


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> Any:
        raise Failed(message, USAGE)


def where(p: argparse.ArgumentParser, keeps: str) -> None:
    p.add_argument("model", help="the model, at a path that all machines share")
    g = p.add_argument_group("where it is done")
    g.add_argument(
        "--address", help="of a Ray cluster: ray://host:10001, host:6379 or auto; else Ray is started here"
    )
    g.add_argument(
        "--deadline", type=positive(float), default=60.0, metavar="S", help="wait so long for the address (60)"
    )
    g.add_argument("--checkpoint", metavar="FOLDER", help="keep %s there, and go on from what is there" % keeps)
    g.add_argument("--scc", help="the program, on each machine; by default the environment variable SCC, the one in this package, or scc")


def written(p: argparse.ArgumentParser) -> None:
    p.add_argument("--format", choices=["csv", "jsonl"], default="csv")
    p.add_argument("-o", "--output", metavar="FILE", help="write there instead of to standard output")


def parser() -> argparse.ArgumentParser:
    top = Parser(prog="scc-cluster", description="The Shape Calculus on many machines, by Ray.", epilog=EXITS)
    commands = top.add_subparsers(dest="command", required=True)

    p = commands.add_parser("check", help="explore a model, and decide its properties", epilog=EXITS)
    where(p, "levels")
    p.add_argument("--owners", type=positive(int), metavar="N", help="processes among which states are shared")
    p.add_argument("-D", "--define", type=define, action="append", default=[], metavar="NAME=VALUE")
    p.add_argument("--check", action="append", default=[], metavar="NAME", help="this property alone; repeatable")
    p.add_argument(
        "--searches", action="store_true", help="leave properties undecided that are more than searches"
    )
    p.add_argument(
        "--states", type=positive(int), default=1 << 40, metavar="N", help="keep at most so many states"
    )
    p.add_argument(
        "--order",
        choices=["levels", "time", "any"],
        default="levels",
        help="time: by the times at which states are reached; any: owners do not wait for each other, and runs need not be the shortest. Only levels are kept",
    )
    p.add_argument(
        "--memory",
        type=positive(int),
        metavar="MIB",
        help="so much of each owner's tables is in memory, and the rest in files",
    )
    p.add_argument("--no-reduce", action="append", default=[], metavar="NAME,...")
    p.add_argument("--witness", metavar="FOLDER", help="write the schedule of each run that shows something")
    p.add_argument("--json", action="store_true")

    p = commands.add_parser(
        "simulate", help="make many runs of a model", description=LIKE % ("simulate", "simulate"), epilog=EXITS
    )
    where(p, "runs")
    p.add_argument("-D", "--define", type=define, action="append", default=[], metavar="NAME=VALUE")
    p.add_argument("--runs", type=positive(int), required=True, metavar="N")
    p.add_argument("--observe", action="append", required=True, metavar="FORMULA", help="repeatable")
    p.add_argument("--every", required=True, metavar="STEP")
    p.add_argument("--until", required=True, metavar="TIME")
    p.add_argument("--seed", default="0")
    p.add_argument("--steps", metavar="N")
    p.add_argument("--decimals", metavar="K")
    p.add_argument("--summary", action="store_true")
    p.add_argument("--quantiles", metavar="Q,...", default="")
    p.add_argument("--plot", metavar="FILE", help="with --summary")
    written(p)

    p = commands.add_parser(
        "sweep", help="check a model over a grid", description=LIKE % ("sweep", "sweep"), epilog=EXITS
    )
    where(p, "points")
    p.add_argument("-D", "--define", type=define, action="append", required=True, metavar="NAME=VALUES")
    for bound in ("depth", "time", "states", "seconds", "memory", "bits"):
        p.add_argument("--" + bound, metavar="N", help="for each point by itself")
    written(p)

    p = commands.add_parser(
        "estimate",
        help="tell probabilities and means from many runs",
        description=LIKE % ("estimate", "estimate"),
        epilog=EXITS,
    )
    where(p, "runs (in a folder of this machine)")
    p.add_argument("-D", "--define", type=define, action="append", default=[], metavar="NAME=VALUE")
    for name in ("check", "property"):
        p.add_argument("--" + name, action="append", default=[], metavar="NAME" if name == "check" else "PROPERTY")
    for name in "confidence width runs most seed steps until free levels effort memory seconds".split():
        p.add_argument("--" + name)
    p.add_argument("--normal", action="store_true")
    p.add_argument("--json", action="store_true")
    return top
