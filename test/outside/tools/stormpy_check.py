"""Storm, through stormpy, against the verdicts of scc check.

The graph of each model is exported with its instants, in Storm's exact format (DRN) and as explicit files in Storm's
dialect. An MDP without chance: EF p is that Pmax [F p] = 1, AF p that Pmin [F p] = 1, AG p that Pmin [G p] = 1, EG p
that Pmax [G p] = 1. What is asked of formulas with nested operators is told by the export itself. Operators with a bound
of time are decided by the least and the greatest time (the reward model) until the predicate is met.
"""

import json
import re
from fractions import Fraction

import stormpy

from common import MODELS, Run, models

STATES = 4000

# Models whose graph is not finite, or long in the making, with the bounds within which it is explored. Of a graph that
# is cut off no formula is compared, or only those with a bound of time: what both formats tell of it can be seen in few
# states.
BOUNDS = {
    "far": ["--states", "300"],
    "figure1": ["--time", "20"],
    "gas": ["--time", "1"],
    "glycolysis": ["--states", "300"],
    "gravity": ["--time", "3"],
    "metronome": ["--states", "300"],
    "parting": ["--states", "300"],
    "raft": ["--states", "300"],
    "ratchet": ["--states", "300"],
    "tumble": ["--states", "300"],
    "window": ["--states", "300"],
}

# The transitions that chance decides (rules Draw and Lot).
CHANCE = ("draw(", "lot(", "first(")

SIMPLE = re.compile(r"(possibly|always|eventually|EF|AG|AF|EG) (.*?)(?: within (.+))?$")


def number(value):
    """A reward of Storm as a fraction, or None when it is infinite."""
    text = str(value)
    return None if "inf" in text else Fraction(text)


class Storm:
    """A model that Storm has read."""

    def __init__(self, model):
        self.model = model

    def label(self, name):
        # A label that holds nowhere is not in a DRN file.
        if not self.model.labeling.contains_label(name):
            self.model.labeling.add_label(name)
        return f'"{name}"'

    def ask(self, question):
        formula = stormpy.parse_properties(question)[0]
        return stormpy.model_checking(self.model, formula)

    def value(self, question):
        return self.ask(question).get_value(0)

    def holds(self, question):
        return bool(self.ask(question).get_truth_values_vector()[0])


def unbounded(storm, operator, p, by_chance):
    """Whether the operator holds of the label p; None where probabilities do not tell, as runs matter that have none."""
    if by_chance:
        if operator in ("possibly", "EF"):
            return storm.value(f"Pmax=? [F {p}]") > 0
        if operator not in ("always", "AG"):
            return None
    question, wanted = {
        "possibly": (f"Pmax=? [F {p}]", 1),
        "EF": (f"Pmax=? [F {p}]", 1),
        "eventually": (f"Pmin=? [F {p}]", 1),
        "AF": (f"Pmin=? [F {p}]", 1),
        "always": (f"Pmin=? [G {p}]", 1),
        "AG": (f"Pmin=? [G {p}]", 1),
        "EG": (f"Pmax=? [G {p}]", 1),
    }[operator]
    return storm.value(question) == wanted


def least(storm, goal):
    return number(storm.value(f'R{{"time"}}min=? [F {goal}]'))


def greatest(storm, goal):
    return number(storm.value(f'R{{"time"}}max=? [F {goal}]'))


def below(a, b, or_equal):
    return a is not None and (a < b or (or_equal and a == b))


def reached_within(storm, goal, bound):
    """EF [<= bound]. A stretch of time may begin right after the instant at which Storm meets it."""
    attained = f'{goal} & !{storm.label("right_after")}'
    return below(least(storm, goal), bound, False) or below(least(storm, attained), bound, True)


def within(storm, operator, p, bound):
    """The same with a bound of time; None where times alone do not tell."""
    if operator == "possibly":
        return reached_within(storm, p, bound)
    if operator == "always":
        return not reached_within(storm, f"!{p}", bound)
    if operator == "eventually":
        latest = greatest(storm, p)
        if latest != bound:
            return below(latest, bound, False)
        attained = f'{p} & !{storm.label("right_after")}'
        return True if greatest(storm, attained) == bound else None
    return None


def export(run, source, name, words):
    """The model in both formats of Storm, and what the export says of it."""
    drn, tra = run.path(name + ".drn"), run.path(name + ".tra")
    for target, more in ((drn, []), (tra, ["--dialect", "storm"])):
        result = run.call("explore", source, "-o", target, "--instants", *more, *words)
        if result.returncode not in (0, 2):
            run.ok(False, f"{name}: scc explore: {result.stderr.strip()}")
            return None
    exact = Storm(stormpy.build_model_from_drn[stormpy.Rational](drn))
    floats = Storm(
        stormpy.build_model_from_explicit(tra, run.path(name + ".lab"), choice_labeling=run.path(name + ".clab"))
    )
    with open(run.path(name + ".names.json"), encoding="utf-8") as file:
        names = json.load(file)
    return exact, floats, names


def same_shape(run, name, exact, floats):
    """Both formats tell of the same graph, and so does the file of states. Where no action takes time, a DRN file has one
    more state, which is not reached, so that Storm knows its reward model."""
    with open(run.path(name + ".sta"), encoding="utf-8") as file:
        lines = file.read().splitlines()
    with open(run.path(name + ".drn"), encoding="utf-8") as file:
        extra = "\taction unreachable [1]\n" in file.read()
    shapes = [(m.model.nr_states, m.model.nr_transitions, m.model.nr_choices) for m in (exact, floats)]
    same = shapes[0] == tuple(number + extra for number in shapes[1])
    run.ok(
        same and floats.model.nr_states == len(lines) - 1 and len(set(lines)) == len(lines),
        f"{name}: the formats differ: {shapes}, {len(lines) - 1} states",
    )


def prism_dialect(run, source, name, words, storm):
    """PRISM's dialect, read as its manual says, against what Storm has read in its own."""
    tra = run.path(name + "-prism.tra")
    run.call("explore", source, "-o", tra, "--instants", *words)
    with open(tra, encoding="utf-8") as file:
        states, choices, transitions = map(int, file.readline().split())
        rows = [line.split() for line in file]
    model = storm.model
    matrix, first = model.transition_matrix, model.nondeterministic_choice_indices
    read = {}
    for i in range(model.nr_states):
        for k, row in enumerate(range(first[i], first[i + 1])):
            actions = sorted(model.choice_labeling.get_labels_of_choice(row))
            read[i, k] = (sorted((e.column, e.value) for e in matrix.get_row(row)), actions)
    ok = (states, choices, transitions) == (model.nr_states, model.nr_choices, model.nr_transitions)
    told = {}
    for i, k, j, p, a in rows:
        targets, actions = told.setdefault((int(i), int(k)), ([], []))
        targets.append((int(j), float(p)))
        actions[:] = [a]
    ok = ok and {place: (sorted(targets), actions) for place, (targets, actions) in told.items()} == read
    run.ok(ok and len(rows) == transitions, f"{name}: transitions in PRISM's dialect")
    with open(run.path(name + "-prism.lab"), encoding="utf-8") as file:
        names = dict(entry.split("=") for entry in file.readline().split())
        held = {int(i): {names[k].strip('"') for k in ks.split()} for i, ks in (line.split(":") for line in file)}
    labels = {i: set(model.labeling.get_labels_of_state(i)) for i in range(model.nr_states)}
    run.ok({i: held.get(i, set()) for i in labels} == labels, f"{name}: labels in PRISM's dialect")


def value(text, parameters):
    """A constant of the language, over the parameters of the model: numbers and + - * / alone."""
    names = {name: Fraction(q) for name, q in parameters.items()}
    exact = re.sub(r"[0-9]+(\.[0-9]+)?", lambda number: f"Fraction('{number.group()}')", text)
    return eval(exact, {"__builtins__": {}, "Fraction": Fraction}, names)


def measured(run, what, prop, question, exact, floats, truncated):
    """A number that was asked for: the same rational, and nearly the same float."""
    if question is None or truncated:
        run.skip(what, "the graph is not finite" if truncated else "beyond labels and rewards")
        return None
    answers = []
    for value, ask, about in zip(prop["values"], prop["asked"].split("; "), question.split("; ")):
        ours = None if value["low"] is None else Fraction(value["low"])
        theirs, near = number(exact.value(ask)), None
        same = value["low"] == value["high"] and ours == theirs
        if not about.startswith("R"):  # the explicit files have no rewards
            near = number(floats.value(about))
            same = same and abs(near - ours) <= abs(ours) / 1000
        answers.append(same)
        run.ok(same, f"{what}: scc: {ours}, Storm: {theirs}, in floats {near}: {ask}")
    return answers


def compare(run, name, prop, question, exact, floats, truncated, eventful, parameters, by_chance):
    """One check: the verdict of scc, and what Storm says in each format."""
    what = f"{name}.{prop['name']}"
    verdict = prop["verdict"]
    if verdict == "measured":
        return measured(run, what, prop, question, exact, floats, truncated)
    if verdict not in ("holds", "violated"):
        run.skip(what, "no verdict that is a proof")
        return None
    expected = verdict == "holds"
    simple = SIMPLE.match(prop["formula"])
    bound = simple and simple.group(3)
    answers = []
    if question is not None and not truncated:
        # Floats do not decide a probability that is the bound itself.
        if 'R{"time"}' not in question and not re.search(r"\bP(min|max)? *[<>]", prop["formula"]):
            answers.append(floats.holds(question))
        answers.append(exact.holds(prop["asked"]))
    # States do not tell of events.
    plain = not any(re.search(rf"\b{word}\b", prop["formula"]) for word in eventful)
    one = plain and len(re.findall(r"\b(possibly|always|eventually|[AE][FGX])\b|U\[| U ", prop["formula"])) == 1
    if simple and one:
        operator, label = simple.group(1), f"check_{prop['name']}"
        if bound is not None and by_chance:
            pass  # the expected time is not the least or the greatest
        elif bound is not None:
            answers.append(within(exact, operator, exact.label(label), value(bound, parameters)))
        elif not truncated:
            answers += [unbounded(m, operator, m.label(label), by_chance) for m in (exact, floats)]
    if not answers:
        why = "the graph is not finite" if truncated else "beyond labels and rewards"
        run.skip(what, why)
        return None
    if None in answers:
        run.skip(what, "the latest time is the bound itself, or runs of probability 0 matter")
        return None
    run.ok(all(a == expected for a in answers), f"{what}: scc: {expected}, Storm: {answers}: {prop['formula']}")
    return answers


def of_events(source):
    """The words that make a formula speak of events: `event`, and the names of lets that do."""
    words = ["event"]
    with open(source, encoding="utf-8") as file:
        for line in file:
            let = re.match(r"let (\w+)\s*=(.*)", line)
            if let and any(re.search(rf"\b{word}\b", let.group(2)) for word in words):
                words.append(let.group(1))
    return words


def one(run, source, name, words):
    report = run.verdicts(source, *words)
    if report is None:
        run.skip(name, "scc check refuses it")
        return
    exported = export(run, source, name, words)
    if exported is None:
        return
    exact, floats, names = exported
    same_shape(run, name, exact, floats)
    prism_dialect(run, source, name, words, floats)
    eventful = of_events(source)
    by_chance = any(action["text"].startswith(CHANCE) for action in names["actions"])
    truncated = any("TRUNCATED" in note for note in names["notes"])
    questions = {check["name"]: check["formula"] for check in names["checks"]}
    with open(run.path(name + ".drn"), encoding="utf-8") as file:
        asked = dict(re.findall(r"^// check (\S+): (.*)$", file.read(), re.M))
    compared = 0
    for prop in report["properties"]:
        prop["asked"] = asked[prop["name"]]
        question = questions[prop["name"]]
        known = (exact, floats, truncated, eventful, report["parameters"], by_chance)
        if compare(run, name, prop, question, *known) is not None:
            compared += 1
    total = len(report["properties"])
    print(f"  {name:20} {exact.model.nr_states:6} states  {compared:3} of {total:3} formulas compared")


def nested():
    """Model by model, the checks of nested.txt."""
    found = {}
    with open("test/outside/tools/nested.txt", encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                model, formula = line.strip().split(": ", 1)
                found.setdefault(model, []).append(formula)
    return found


def main():
    run = Run("Storm against the verdicts of scc check")
    for name in models():
        words = BOUNDS.get(name, [])
        if "--states" not in words:
            words = ["--states", str(STATES)] + words
        one(run, f"{MODELS}/{name}.sc", name, words)
    for name, formulas in nested().items():
        with open(f"{MODELS}/{name}.sc", encoding="utf-8") as file:
            text = file.read()
        lines = [line for line in text.splitlines() if not line.startswith("check ")]
        lines += [f"check nested{i} : {formula}" for i, formula in enumerate(formulas, 1)]
        source = run.path(name + "-nested.sc")
        with open(source, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")
        one(run, source, name + "-nested", ["--states", str(STATES)])
    # Free choices beside lots: what is asked has a least and a greatest answer.
    one(run, "test/outside/tools/loosening.sc", "loosening", [])
    # No action takes time: rewards are all 0.
    one(run, "test/outside/tools/instant.sc", "instant", [])
    run.end()


main()
