"""Holds the transitions that ``scc`` tells against those that the rules here give.

compare.py --scc PATH                 the conformance suite, and 60 random models
compare.py --scc PATH --models 5000 --seed 7 --no-suite
compare.py --scc PATH --file MODEL.sc ...
"""

from __future__ import annotations

import argparse
import json
import random
import re
import signal
import sys
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path
from typing import Any, List, Optional, Tuple

import generate
import walks
from draws import chooses
from lots import lots_wait
from model import Model, Undefined
from motion import Undecided
from oracle import Oracle, Refusal
from states import Process, State, label_of, state_of
from straight import Rules, Stopped
from syntax import Refused
from turning import Turning

HERE = Path(__file__).resolve().parent
SPLITS = ("weak", "weaks", "strong")


class Tally:
    """What was compared."""

    def __init__(self) -> None:
        self.counts: Counter = Counter()
        self.kinds: Counter = Counter()
        self.differences: List[str] = []
        self.passed_over: Counter = Counter()


def shown(here: Counter, told: Counter) -> str:
    """What only one side has; of targets of like labels, the processes that differ."""
    lines = []
    for sign, these, others in (("here", here, told), ("told", told, here)):
        for (label, key), count in these.items():
            lines.append("only %s: %d x %s" % (sign, count, plain(label)))
            alike = [set(told_apart(k)) for (other, k) in others if other == label]
            for line in told_apart(key):
                if not any(line in known for known in alike):
                    lines.append("      %s" % line)
    return "\n".join(lines)


def told_apart(key: Any) -> List[str]:
    processes, step, now, instant = key
    lines = ["%s, time %s, split instant %s" % (plain(step), plain(now), plain(instant))]
    for velocity, clock, bodies, bonds, spin, since, momentum, lasts, own, draw, lots in processes:
        lines.append(
            "v %s clock %s bonds %s step %s lasts %s draw %s lots %s"
            % tuple(plain(x) for x in (velocity, clock, bonds, own, lasts, draw, lots))
        )
        if any(body.turned for _, body in bodies):
            lines.append(
                "  spin %s since %s L %s" % (plain(spin), plain(since), plain(momentum))
            )
        for name, body in bodies:
            lines.append(
                "  %s at %s %s: %s (%s) waited %s"
                % (
                    name, plain(body.position), body.turned or "", plain(body.term),
                    body.origin, body.waited,
                )
            )
    return lines


def plain(value: Any) -> str:
    text = re.sub(r"Fraction\((-?\d+), (\d+)\)", r"\1/\2", repr(value))
    return re.sub(r"frozenset\(\{(('[^']*'|[^'])*?)\}\)", r"{\1}", text.replace("/1,", ","))


def compare_state(rules: Rules, answer: dict, state: State, tally: Tally) -> Optional[str]:
    """A difference in the transitions of one state, or None."""
    model = rules.model
    own = Counter({(label, after.key()): 1 for label, after in rules.successors(state)})
    told: Counter = Counter()
    drawn: List[Any] = []
    for t in answer["transitions"]:
        label = label_of(model, t["label"])
        after_time = state.time + (label[1] if label[0] == "time" else 0)
        told[(label, state_of(model, t["state"], str(after_time)).key())] += 1
        tally.kinds[label[0]] += 1
        if label[0] == "strong" and len(label[1]) > 1:
            tally.kinds["strong of several"] += 1
        if label[0] in SPLITS and of_a_ring(state, label, t["state"]):
            tally.kinds["split of a ring"] += 1
        if label[0] in SPLITS and pushes(label):
            tally.kinds["split with a push"] += 1
        if label[0] == "bounce" and len(label[1]) > 2:
            tally.kinds["bounce of several"] += 1
        if model.by_contact and label[0] == "bind" and not collide(rules, state, label):
            tally.kinds["bind by contact"] += 1
        if label[0] == "draw":
            drawn.append(label[2])
            words = ["(%s, %s, %s)" % label[2][i : i + 3] for i in range(0, len(label[2]), 3)]
            if t["label"]["text"] != "draw(%s, %s) chance(%s)" % (label[1], " spin ".join(words), label[3]):
                return "a label is written %s" % t["label"]["text"]
            after = state_of(model, t["state"], str(after_time))
            count_draw(rules, state, label, after, tally)
        if label[0] == "lot":
            if not written_as(t["label"]):
                return "a label is written %s" % t["label"]["text"]
            count_lot(rules, state, label, tally)
        elif label[0] in SPLITS and lots_wait(state):
            after = state_of(model, t["state"], str(after_time))
            count_release(state, label, after, tally)
    tally.counts["transitions"] += sum(told.values())
    tally.counts["states"] += 1
    if not told and answer["ending"] == "quiescent" and model.rigid:
        tally.counts["rest proved"] += 1
    if drawn != sorted(drawn):
        return "the draws are not in order: %s" % plain(drawn)
    if own != told:
        return shown(own - told, told - own)
    if (answer["ending"] is None) != bool(told):
        return "ending %s" % answer["ending"]
    return None


def count_draw(rules: Rules, state: State, label: Any, after: State, tally: Tally) -> None:
    """What is special about a draw."""
    last = all(p.draw is None for p in after.processes)
    kinds = {
        "draw of a compound": len(process_of(state, label[1]).bodies) > 1,
        "draw of a spin": len(label[2]) > 3,
        "draw among others": sum(p.draw is not None for p in state.processes) > 1,
        "last draw": last,
        "last draw into a collision": last and bool(rules.hit(after)),
    }
    tally.kinds.update({kind: 1 for kind, found in kinds.items() if found})


def written_as(told: dict) -> bool:
    """Whether the text of a lot says what it says."""
    text = "%s(%s, %s)" % (told["decision"], told["name"], ", ".join(told["ends"]))
    if told["decision"] != "choose":
        text += " chance(%s)" % Fraction(told["chance"])
    return told["text"] == text


def count_lot(rules: Rules, state: State, label: Any, tally: Tally) -> None:
    """What is special about a lot."""
    process = next(p for p in state.processes if any(lot.bond == label[2:4] for lot in p.lots))
    drawing = [end for end in label[3] if rules.end_chances(process, label[2], end)]
    tally.kinds[label[1]] += 1
    tally.kinds["lot of both ends"] += len(drawing) > 1
    tally.kinds["lot among others"] += len(process.lots) > 1
    tally.kinds["lot of a ring"] += len(process.bonds) >= len(process.bodies)
    tally.kinds["several ways"] += any(
        len(rules.end_chances(process, label[2], end) or ()) > 1 for end in drawing
    )


def count_release(before: State, label: Any, after: State, tally: Tally) -> None:
    """What is special about a release, and what becomes of the other bonds that are to be released."""
    tally.kinds["released by lot"] += 1
    if label[0] == "weaks":
        processes = [p for p in before.processes if p.lots]
        tally.kinds["released at once, of one process"] += len(processes) == 1
        tally.kinds["released at once, of several"] += len(processes) > 1
    old, new = (sum(len(p.lots) for p in state.processes) for state in (before, after))
    tally.kinds["others stay to be released"] += new > 0
    tally.kinds["others are kept then"] += new < old - bonds_of(label)


def process_of(state: State, leaf: str) -> Process:
    return next(p for p in state.processes if leaf in p.bodies)


def pushes(label: Any) -> bool:
    """Whether a split drives apart what it releases (I-36)."""
    released = [label] if label[0] == "weak" else label[1]
    return any(bond[-1] is not None for bond in released)


def of_a_ring(state: State, label: Any, after: dict) -> bool:
    """Whether a split takes bonds of a ring: it makes fewer pieces than bonds go (I-37)."""
    return len(after["processes"]) - len(state.processes) < bonds_of(label)


def bonds_of(label: Any) -> int:
    """How many bonds a split releases."""
    return 1 if label[0] == "weak" else len(label[1])


def collide(rules: Rules, state: State, label: Any) -> bool:
    """Whether the two that bind collide."""
    p, q = (p for p in state.processes if any(leaf in p.bodies for leaf, _ in label[2]))
    return rules.collision(p, q) is not None


def switches(model: Model) -> List[str]:
    """What a model chooses that is not so if nothing is said."""
    found = ["together"] * model.together + ["by contact"] * model.by_contact
    found += ["laws"] * model.steered + ["local steps"] * (model.steered and model.local)
    found += ["steady steps"] * (model.steered and model.steady) + ["only"] * model.only
    found += ["blocked " + model.blocked] * (model.blocked != "bounce")
    found += ["draws"] * any(map(chooses, model.leaves.values()))
    found += ["pushes"] * model.pushes + ["cyclic"] * model.cyclic
    found += ["lots"] * model.lots
    found += ["absorption"] * any(leaf.absorbs for leaf in model.leaves.values())
    rounding = model.rounding if model.rigid else "velocity" in model.rounding
    return found + ["rounding"] * bool(rounding)


def choice(rng: random.Random, transitions: List[dict]) -> int:
    """One of the transitions; of splits and bonds rather than that time passes."""
    rare = [i for i, t in enumerate(transitions) if t["label"]["kind"] not in ("time", "bounce")]
    if rare and rng.random() < 0.5:
        return rng.choice(rare)
    return rng.randrange(len(transitions))


def digits(told: Any) -> int:
    """The length of the longest number; those of bodies that turn grow with each collision."""
    if isinstance(told, dict):
        return max(map(digits, told.values()), default=0)
    if isinstance(told, list):
        return max(map(digits, told), default=0)
    return len(told) if isinstance(told, str) and told[:1] in "-0123456789" else 0


NO_TRANSITIONS = -32006  # specs/oracle.md


def successors(oracle: Oracle, model: Any, path: List[int]) -> Optional[dict]:
    """What a path leads to, and its transitions; None if these cannot be computed."""
    try:
        return oracle.ask("successors", model=model, path=path, states="all")
    except Refusal as refusal:
        if refusal.error["code"] == NO_TRANSITIONS:
            return None
        raise


def chosen(model: Model, answer: dict, number: int, state: State) -> State:
    """The state that a transition leads to."""
    told = answer["transitions"][number]
    label = label_of(model, told["label"])
    now = state.time + (label[1] if label[0] == "time" else 0)
    return state_of(model, told["state"], str(now))


def given_up(rules: Rules, state: Optional[State], path: List[int]) -> Optional[str]:
    """A difference if the transitions of a state can be computed here (Persistent, laws)."""
    try:
        found = rules.successors(rules.initial() if state is None else state)
    except (Undefined, Stopped):
        return None
    return "no transitions told after %s, here: %s" % (path, plain([t[0] for t in found]))


def walk(
    oracle: Oracle, text: str, tally: Tally, rng: random.Random, steps: int, runs: int
) -> Optional[str]:
    """Random runs of a model; the first difference."""
    try:
        model = Model(text)
        rules = Turning(model) if model.rigid else Rules(model)
        loaded = oracle.ask("model.load", text=text)
    except (Refusal, Refused) as error:
        tally.passed_over[str(error)[:60]] += 1
        without_value = isinstance(error, Refusal) and "SC0601" in str(error)
        return given_up(rules, None, []) if without_value else None
    try:
        if loaded["rigid"] != model.rigid:
            return "rigid: %s" % loaded["rigid"]
        tally.counts["rigid models" if model.rigid else "models"] += 1
        for switch in switches(model):
            tally.counts[switch] += 1
        seen: set = set()
        for run in range(runs):
            path: List[int] = []
            state: Optional[State] = None
            for i in range(steps):
                answer = successors(oracle, loaded["model"], path)
                if answer is None:
                    tally.counts["without transitions"] += 1
                    return given_up(rules, state, path)
                state = state_of(model, answer["state"], answer["time"])
                if i == 0 and run == 0:
                    own = rules.initial()
                    if own.key() != state.key():
                        here, told = ((("initial",), s.key()) for s in (own, state))
                        return shown(Counter([here]), Counter([told]))
                if state.key() not in seen:
                    seen.add(state.key())
                    difference = compare_state(rules, answer, state, tally)
                    if difference:
                        return "after %s:\n%s\n%s" % (
                            path, "\n".join(told_apart(state.key())), difference,
                        )  # fmt: skip
                if not answer["transitions"] or digits(answer["state"]) > 150:
                    break
                path.append(choice(rng, answer["transitions"]))
                state = chosen(model, answer, path[-1], state)
    except (Undefined, Stopped) as error:
        return "no transitions here: %r" % error
    except Undecided as error:
        tally.passed_over[type(error).__name__] += 1
    except Refusal as error:
        tally.passed_over[str(error)[:60]] += 1
    finally:
        oracle.ask("model.release", model=loaded["model"])
    return None


def kept() -> List[Tuple[str, str]]:
    """Models of what random ones hardly ever come to."""
    return [(path.name, path.read_text()) for path in sorted(HERE.glob("models/*.sc"))]


def suite(folder: Path) -> List[str]:
    """The models of the conformance suite whose transitions are asked for."""
    texts = []
    for path in sorted(folder.glob("*/*.json")) + sorted(folder.glob("*/*/*.json")):
        document = json.loads(path.read_text())
        if not isinstance(document, dict):
            continue
        for given in document.get("given", {}).values():
            text = given["params"].get("text") if given["method"] == "model.load" else None
            if text and text not in texts and not given["params"].get("parameters"):
                texts.append(text)
    return texts


class TimeUp(Exception):
    """A model takes longer than it may."""


class Ended(Exception):
    """The comparison is told to end: what was compared is told."""


def raising(error: Any) -> Any:
    def handler(number: int, frame: Any) -> None:
        raise error()

    return handler


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scc", required=True)
    parser.add_argument("--models", type=int, default=60)
    parser.add_argument("--rigid", type=int, default=10, help="of bodies that turn")
    parser.add_argument("--walks", type=int, default=20, help="with walkers that do not bounce")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--steps", type=int, default=8)
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--no-suite", action="store_true")
    parser.add_argument("--stop", type=int, default=3, help="after so many differences")
    parser.add_argument("--only-rigid", action="store_true")
    parser.add_argument("--only-draws", action="store_true", help="laws that choose")
    parser.add_argument("--only-lots", action="store_true", help="splits left to chance")
    parser.add_argument("--seconds", type=int, default=0, help="for each model")
    parser.add_argument("--file", action="append", default=[])
    parser.add_argument("--suite", default=str(HERE / "../../../specs/conformance"))
    options = parser.parse_args()

    oracle = Oracle([options.scc, "oracle"])
    signal.signal(signal.SIGALRM, raising(TimeUp))
    signal.signal(signal.SIGTERM, raising(Ended))
    tally = Tally()
    began = time.time()
    texts = [(name, Path(name).read_text()) for name in options.file]
    if not options.no_suite and not texts:
        texts += kept() + [("suite %d" % i, t) for i, t in enumerate(suite(Path(options.suite)))]

    def numbered() -> Any:
        yield from texts
        if not options.file:
            for i in range(options.models):
                name = "random %d" % (options.seed * 1000000 + i)
                yield name, generate.model(random.Random(name))
            for i in range(options.rigid):
                name = "rigid %d" % (options.seed * 1000000 + i)
                yield name, generate.model(random.Random(name), rigid=True)
            for i in range(options.walks):
                name = "walks %d" % (options.seed * 1000000 + i)
                yield name, walks.model(random.Random(name))

    name = "the first"
    try:
        for name, text in numbered():
            if options.only_draws and not re.search(r"\b(choose|diffuse)\b", text):
                continue
            if options.only_lots and not re.search(r"\b(chance|rate)\b", text):
                continue
            if options.only_rigid and "spin" not in text and "dynamics" not in text:
                continue
            rng = random.Random("%s %d" % (name, options.seed))
            try:
                signal.alarm(options.seconds)
                difference = walk(oracle, text, tally, rng, options.steps, options.runs)
                signal.alarm(0)
            except TimeUp:
                tally.passed_over["longer than %d s" % options.seconds] += 1
                oracle.process.kill()
                oracle = Oracle([options.scc, "oracle"])
                continue
            if difference:
                tally.differences.append(name)
                print("DIFFERENCE in %s\n%s\n%s\n" % (name, text, difference), flush=True)
                if len(tally.differences) >= options.stop:
                    break
    except Ended:
        tally.passed_over["all from %s on" % name] += 1
    oracle.close()
    print(
        "%s; %s; passed over %s; %d differences; %.1f s"
        % (dict(tally.counts), dict(tally.kinds), dict(tally.passed_over),
           len(tally.differences), time.time() - began)
    )  # fmt: skip
    return 1 if tally.differences else 0


if __name__ == "__main__":
    sys.exit(main())
