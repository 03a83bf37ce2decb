"""itf-py must read the traces of scc trace --itf, and find in them what the trace in scc's own format says."""

import json
import os
from fractions import Fraction

import itf_py

from common import MODELS, Run, models

STATES = 2000


def numbers(value, place=""):
    """The places of bare JSON numbers in a state, #meta left out."""
    if isinstance(value, bool):
        return [place]
    if isinstance(value, (int, float)):
        return [place]
    if isinstance(value, list):
        return [p for i, v in enumerate(value) for p in numbers(v, f"{place}[{i}]")]
    if isinstance(value, dict):
        return [p for k, v in value.items() if k != "#meta" for p in numbers(v, f"{place}.{k}")]
    return []


def kind(value):
    """The type of a value as Apalache sees it; of collections, those of what they hold."""
    if isinstance(value, dict) and not hasattr(value, "_fields"):
        return ("map", frozenset(kind(k) for k in value), frozenset(kind(v) for v in value.values()))
    if isinstance(value, frozenset):
        return ("set", frozenset(kind(v) for v in value))
    if hasattr(value, "_fields"):
        return ("record", tuple((f, kind(getattr(value, f))) for f in value._fields))
    if isinstance(value, tuple):
        return ("tuple", tuple(kind(v) for v in value))
    return type(value).__name__


def compatible(a, b):
    """Types are equal, an empty collection being of any."""
    if isinstance(a, frozenset) and isinstance(b, frozenset):
        return len(a) <= 1 and len(b) <= 1 and all(compatible(x, y) for x in a for y in b)
    if isinstance(a, tuple) and isinstance(b, tuple):
        return len(a) == len(b) and all(compatible(x, y) for x, y in zip(a, b))
    return a == b


def fraction(pair):
    return Fraction(pair[0], pair[1])


def own_states(lines):
    """Action, time and state of each line of a trace in scc's own format."""
    for line in map(json.loads, lines):
        if line["type"] == "state":
            yield "init", line["time"], line["state"]
        elif line["type"] == "transition":
            yield line["label"]["text"], line["time"], line["state"]
        elif line["type"] == "instant":
            yield "pass", line["time"], line["state"]


def same(values, action, time, state):
    """Whether a state of the trace says what scc's own format says."""
    leaves = [(p, leaf) for p in state["processes"] for leaf in p["leaves"]]
    bonds = {(b["name"], *b["ends"]) for p in state["processes"] for b in p["bonds"]}
    return (
        values["action"] == action
        and fraction(values["time"]) == Fraction(time)
        and set(values["position"]) == {leaf["name"] for _, leaf in leaves}
        and all(
            [fraction(c) for c in values["position"][leaf["name"]]] == [Fraction(c) for c in leaf["position"]]
            and [fraction(c) for c in values["velocity"][leaf["name"]]] == [Fraction(c) for c in p["velocity"]]
            and values["behaviour"][leaf["name"]] == leaf["behaviour"]
            and values["origin"][leaf["name"]] == (leaf["origin"] or "")
            and values["process"][leaf["name"]] == p["leaves"][0]["name"]
            for p, leaf in leaves
        )
        and {(b.name, b.one, b.two) for b in values["bonds"]} == bonds
        and {n: fraction(c) for n, c in values["clock"].items()}
        == {p["leaves"][0]["name"]: Fraction(p["clock"]) for p in state["processes"] if p["clock"]}
    )


def one(run, what, model, words):
    """One run, in both formats; the number of its states."""
    path = run.path("trace.itf.json")
    made = run.call("trace", model, "--itf", "-o", path, *words)
    own = run.call("trace", model, *words)
    if made.returncode != own.returncode or made.returncode not in (0, 2, 4):
        run.ok(False, f"{what}: scc trace: {made.stderr.strip()}")
        return 0
    with open(path, encoding="utf-8") as file:
        raw = json.load(file)
    trace = itf_py.trace_from_json(raw)
    expected = list(own_states(own.stdout.splitlines()))
    run.ok(
        len(trace.states) == len(expected)
        and all(same(s.values, *e) for s, e in zip(trace.states, expected)),
        f"{what}: not the states of the trace",
    )
    run.ok(all(set(s.values) == set(trace.vars) for s in trace.states), f"{what}: variables are missing")
    bare = [p for state in raw["states"] for p in numbers(state)]
    run.ok(not bare, f"{what}: bare numbers at {bare[:3]}")
    kinds = [{name: kind(value) for name, value in s.values.items()} for s in trace.states]
    run.ok(
        all(compatible(kinds[0][v], k[v]) for k in kinds for v in trace.vars),
        f"{what}: a variable changes its type",
    )
    again = itf_py.trace_from_json(json.loads(json.dumps(itf_py.trace_to_json(trace))))
    run.ok([s.values for s in again.states] == [s.values for s in trace.states], f"{what}: not the same when written again")
    return len(trace.states)


def main():
    run = Run("itf-py reads the traces")
    for name in models():
        model = f"{MODELS}/{name}.sc"
        folder = run.path("runs-" + name)
        run.call("check", model, "--witness", folder, "--states", str(STATES))
        witnesses = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        states = 0
        for witness in witnesses:
            words = ["--schedule", os.path.join(folder, witness)]
            states += one(run, f"{name}, {witness}", model, words)
        for choice in ("first", "random:-7"):
            states += one(run, f"{name}, {choice}", model, ["--steps", "12", "--choose", choice])
        print(f"  {name:20} {len(witnesses):3} witnesses, 2 runs, {states:4} states")
    run.end()


main()
