"""Graphviz must draw every picture, with the states, transitions and texts that the graph has. The pictures are of so many
states as SCC_STATES says, 40 if it says nothing: the layout of larger ones takes far longer."""

import json
import os
import shutil
import subprocess
from fractions import Fraction

from common import MODELS, Run, absent, models

STATES = int(os.environ.get("SCC_STATES", "40"))


def draw(path, picture, read):
    """Once for both, as laying out is what takes the time."""
    words = ["dot", path, "-Tsvg", "-o", picture, "-Tjson0", "-o", read]
    return subprocess.run(words, capture_output=True, text=True, timeout=600)


def seconds(lines):
    """The time in the text of an edge."""
    return Fraction(lines[0][len("time("):-1])


def one(run, what, source, words):
    dot, graph = run.path("graph.dot"), run.path("graph.json")
    for target in (dot, graph):
        extra = words if target == dot else [w for w in words if w != "--positions"]
        result = run.call("explore", source, "-o", target, "--states", str(STATES), *extra)
        if result.returncode not in (0, 2):
            run.ok(False, f"{what}: scc explore: {result.stderr.strip()}")
            return 0, 0
    picture, laid_out = run.path("graph.svg"), run.path("laid_out.json")
    drawn = draw(dot, picture, laid_out)
    run.ok(drawn.returncode == 0 and not drawn.stderr.strip(), f"{what}: dot: {drawn.stderr.strip()[:200]}")
    with open(laid_out, encoding="utf-8") as file:
        read = json.load(file)
    with open(graph, encoding="utf-8") as file:
        states = json.load(file)["states"]
    shown = {o["name"]: o for o in read["objects"] if o["name"].startswith("s") and o["name"] != "start"}
    names = {o["_gvid"]: o["name"] for o in read["objects"]}
    edges = [(names[e["tail"]], names[e["head"]], e.get("label", "")) for e in read.get("edges", [])]
    run.ok(("start", "s0", "") in edges, f"{what}: nothing points to the initial state")

    # What is not time is there, one for one; time leads on to where it leads in the graph, and lasts as long.
    events = sorted((s["number"], e["target"]) for s in states for e in s["edges"] if e["label"]["kind"] != "time")
    drawn_events = sorted(
        (int(a[1:]), int(b[1:])) for a, b, text in edges if a != "start" and not text.startswith("time(")
    )
    run.ok(events == drawn_events, f"{what}: not the events of the graph")
    after = {s["number"]: e for s in states for e in s["edges"] if e["label"]["kind"] == "time"}

    def follows(start, end, lasts):
        at, left = start, lasts
        while left > 0 and at in after:
            left -= Fraction(after[at]["label"]["duration"])
            at = after[at]["target"]
        return left == 0 and at == end

    times = [(int(a[1:]), int(b[1:]), seconds(text.split("\\n"))) for a, b, text in edges if text.startswith("time(")]
    run.ok(all(follows(*t) for t in times), f"{what}: time leads elsewhere")
    run.ok(
        {a for a, _, _ in times} == {n for n in after if f"s{n}" in shown},
        f"{what}: a passing of time is not shown",
    )

    # Marks of states.
    def styled(status, mark):
        return all(mark(shown[f"s{s['number']}"]) == (s["status"] == status) for s in states if f"s{s['number']}" in shown)

    run.ok(
        styled("unexplored", lambda o: "dashed" in o["style"]) and styled("quiescent", lambda o: o.get("peripheries") == "2"),
        f"{what}: marks of states",
    )
    return len(states), len(shown)


def main():
    run = Run("Graphviz draws the pictures")
    if shutil.which("dot") is None:
        absent("there is no Graphviz")
    for name in models():
        for words in ([], ["--positions"]):
            states, shown = one(run, " ".join([name] + words), f"{MODELS}/{name}.sc", words)
            if not words:
                print(f"  {name:20} {states:4} states, {shown:4} of them shown")
    run.end()


main()
