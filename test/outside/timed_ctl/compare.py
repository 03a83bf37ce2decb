"""Holds the evaluator of this folder against what lib/logic/ctl answers.

    compare.py --graphs PATH [--telling] [--show N] COUNT SEED

PATH is graphs.exe. Each answer on each of its COUNT lines is compared. Most numbers there are 0, 1 or infinite:
with --telling only the lines count on which one is not. Tells of what failed the N smallest graphs.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections import Counter
from typing import Any, Dict, Iterator, List, Tuple

import means
from formulas import Evaluator
from graph import Graph

Line = Dict[str, Any]
Answer = Tuple[str, Any, Any, Any]


def kind(formula: Any) -> str:
    """The kind of a question: its outermost operator, with its quantifier."""
    if isinstance(formula, str):
        return "predicate"
    if formula[0] in ("not", "and", "or"):
        return "boolean"
    quantifier = formula[1] if isinstance(formula[1], str) else formula[1][0]
    return quantifier + " " + formula[0]


def kind_of_mean(question: Line) -> str:
    what = "at" if "values" in question else "time" if "time until" in question else "events"
    return question["which"] + " " + what


def written(value: Any) -> Any:
    return None if value is None else str(value)


def answers(line: Line) -> Iterator[Answer]:
    """Of each question of a line: its kind, the question, what it was answered, and what is found here."""
    evaluator = Evaluator(Graph(line["states"]))
    for q in line["formulas"]:
        yield kind(q["formula"]), q, (q["truth"], q["along"]), evaluator.letters(q["formula"])
    for q in line["probabilities"]:
        least, most = (evaluator.probability(q["which"], q["of"], favour)[0][0] for favour in (False, True))
        yield q["which"] + " of " + q["of"][0], q, (q["least"], q["most"]), (str(least), str(most))
    for q in line["means"]:
        yield kind_of_mean(q), q, (q["least"], q["most"]), tuple(map(written, means.mean(evaluator, q)))


def read(graphs: str, count: int, seed: int) -> Iterator[Line]:
    with subprocess.Popen([os.path.abspath(graphs), str(count), str(seed)], stdout=subprocess.PIPE, text=True) as program:
        assert program.stdout is not None
        for text in program.stdout:
            yield json.loads(text)
    if program.returncode != 0:
        sys.exit(f"{graphs} ended with the code {program.returncode}")


def telling(line: Line) -> bool:
    """A probability is neither 0 nor 1, or a mean until something is positive and finite."""
    return any({q["least"], q["most"]} - {"0", "1"} for q in line["probabilities"]) or any(
        {q["least"], q["most"]} - {"0", means.INFINITE} for q in line["means"] if "at" not in q)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--graphs", required=True)
    parser.add_argument("--telling", action="store_true")
    parser.add_argument("--show", type=int, default=3)
    parser.add_argument("count", type=int)
    parser.add_argument("seed", type=int)
    options = parser.parse_args()
    passed: "Counter[str]" = Counter()
    failed: "Counter[str]" = Counter()
    lines = 0
    wrong: List[Tuple[int, Line, Any, Any]] = []
    for line in read(options.graphs, options.count, options.seed):
        lines += 1
        if options.telling and not telling(line):
            continue
        for name, question, told, found in answers(line):
            if told == found:
                passed[name] += 1
            else:
                failed[name] += 1
                wrong.append((len(json.dumps([line["states"], question])), line, question, found))
    for _, line, question, found in sorted(wrong, key=lambda w: w[0])[: options.show]:
        print("states:", json.dumps(line["states"]))
        print("lib/logic/ctl:", json.dumps(question))
        print("here:", json.dumps(found))
    for name in sorted(passed | failed):
        print(f"{name}: {passed[name]} passed, {failed[name]} failed")
    print(f"{sum(passed.values())} passed, {sum(failed.values())} failed")
    sys.exit(0 if lines == options.count and not failed else 1)


if __name__ == "__main__":
    main()
