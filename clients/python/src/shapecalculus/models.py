"""Answers about models: their states, what may happen in them, runs, and what formulas say."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Dict, Iterable, Mapping, Optional, Tuple, Union

from . import numbers
from .numbers import Quaternion, Vector

Json = Mapping[str, Any]


@dataclass(frozen=True)
class DeclaredLeaf:
    """A basic process of a model: its name, the name of its shape, and whether it never moves, or even absorbs."""

    name: str
    shape: str
    fixed: bool
    absorbs: bool = False

    @classmethod
    def from_json(cls, json: Json) -> DeclaredLeaf:
        return cls(json["name"], json["shape"], json["fixed"], json.get("absorbs", False))


@dataclass(frozen=True)
class Check:
    """A property that the model states, as text."""

    name: str
    formula: str


@dataclass(frozen=True)
class Model:
    """A model that the service knows, by its ``handle``. ``resolution`` is None where nothing turns."""

    handle: str
    digest: str
    name: Optional[str]
    parameters: Mapping[str, Fraction]
    rigid: bool
    resolution: Optional[Fraction]
    leaves: Tuple[DeclaredLeaf, ...]
    checks: Tuple[Check, ...]
    warnings: Tuple[Json, ...] = ()
    #: What it was loaded from: its text, the texts of files that it names, and the parameters that were given.
    text: str = field(default="", repr=False, compare=False)
    files: Mapping[str, str] = field(default_factory=lambda: {}, repr=False, compare=False)
    given: Mapping[str, Fraction] = field(default_factory=lambda: {}, repr=False, compare=False)

    def loaded_from(self, text: str, files: Mapping[str, str], given: Optional[Iterable[str]]) -> Model:
        """The same, with what it was loaded from. ``given``: the names of parameters; None for all."""
        values = self.parameters if given is None else {name: self.parameters[name] for name in given}
        return replace(self, text=text, files=dict(files), given=values)

    @classmethod
    def from_json(cls, json: Json) -> Model:
        resolution = json["resolution"]
        return cls(
            json["model"],
            json["digest"],
            json["name"],
            {name: numbers.fraction(value) for name, value in json["parameters"].items()},
            json["rigid"],
            None if resolution is None else numbers.fraction(resolution),
            tuple(DeclaredLeaf.from_json(leaf) for leaf in json["leaves"]),
            tuple(Check(check["name"], check["formula"]) for check in json["checks"]),
            tuple(json["warnings"]),
        )


@dataclass(frozen=True)
class Bond:
    name: str
    ends: Tuple[str, str]

    @classmethod
    def from_json(cls, json: Json) -> Bond:
        first, second = json["ends"]
        return cls(json["name"], (first, second))


@dataclass(frozen=True)
class Leaf:
    """A basic process in a state. ``turned`` is None where nothing turns; ``origin``: the definition it aged from."""

    name: str
    position: Vector
    behaviour: str
    origin: Optional[str]
    turned: Optional[Quaternion] = None

    @classmethod
    def from_json(cls, json: Json) -> Leaf:
        turned = json.get("turned")
        return cls(
            json["name"],
            numbers.vector(json["position"]),
            json["behaviour"],
            json["origin"],
            None if turned is None else numbers.quaternion(turned),
        )


@dataclass(frozen=True)
class Process:
    """A leaf, or several that are bound and move as one. ``clock``: since the split clock was set, or None.

    ``since`` and ``lasts``: how long ago its turn began, and how long it lasts in all; ``lasts`` is None while one is due.
    """

    velocity: Vector
    leaves: Tuple[Leaf, ...]
    bonds: Tuple[Bond, ...]
    clock: Optional[Fraction]
    spin: Optional[Vector] = None
    since: Optional[Fraction] = None
    lasts: Optional[Fraction] = None

    @classmethod
    def from_json(cls, json: Json) -> Process:
        clock, spin, since = json["clock"], json.get("spin"), json.get("since")
        lasts = json.get("lasts")
        return cls(
            numbers.vector(json["velocity"]),
            tuple(map(Leaf.from_json, json["leaves"])),
            tuple(map(Bond.from_json, json["bonds"])),
            None if clock is None else numbers.fraction(clock),
            None if spin is None else numbers.vector(spin),
            None if since is None else numbers.fraction(since),
            None if lasts is None else numbers.fraction(lasts),
        )


@dataclass(frozen=True)
class MovementStep:
    """Where the network is in its movement step: ``phase`` is "moving", "due" or "steered"."""

    remaining: Fraction
    phase: str

    @classmethod
    def from_json(cls, json: Json) -> MovementStep:
        return cls(numbers.fraction(json["remaining"]), json["phase"])


@dataclass(frozen=True)
class State:
    """All processes; ``step`` is None where nothing is steered; ``gone`` are the bodies that were absorbed."""

    processes: Tuple[Process, ...]
    step: Optional[MovementStep] = None
    gone: Tuple[str, ...] = ()

    @classmethod
    def from_json(cls, json: Json) -> State:
        step = json["step"]
        return cls(
            tuple(map(Process.from_json, json["processes"])),
            None if step is None else MovementStep.from_json(step),
            tuple(json.get("gone", ())),
        )

    def leaf(self, name: str) -> Leaf:
        """The leaf of that name; KeyError if there is none, or it is gone."""
        for process in self.processes:
            for leaf in process.leaves:
                if leaf.name == name:
                    return leaf
        raise KeyError(name)

    def process_of(self, name: str) -> Process:
        """The process which has the leaf of that name; KeyError if there is none, or it is gone."""
        for process in self.processes:
            if any(leaf.name == name for leaf in process.leaves):
                return process
        raise KeyError(name)


@dataclass(frozen=True)
class Label:
    """What a transition does: ``kind`` is "time", "bind", "close", "bounce", "absorb", "weak", "strong", "draw" or "lot".

    ``text`` says who takes part; ``touching``, of a bounce, which bodies (or parts of them) touch, in pairs. Of a
    draw, ``process`` is the first body of who draws, ``velocity`` what it draws, ``spin`` what it draws with it if a law
    gives one, and ``chance`` the probability. Of a lot, ``decision`` says of the bond ``name``, ``ends`` whether it is to "keep", to "release" or "first" to release,
    or to "choose" its way, which has no ``chance``. ``bonds`` are those of a strong split, and of a weak one of several.
    """

    kind: str
    text: str
    duration: Optional[Fraction] = None
    name: Optional[str] = None
    ends: Tuple[str, ...] = ()
    between: Tuple[str, ...] = ()
    bonds: Tuple[Bond, ...] = ()
    touching: Tuple[Tuple[str, str], ...] = ()
    process: Optional[str] = None
    velocity: Optional[Vector] = None
    chance: Optional[Fraction] = None
    decision: Optional[str] = None
    spin: Optional[Vector] = None

    @classmethod
    def from_json(cls, json: Json) -> Label:
        duration = json.get("duration")
        return cls(
            json["kind"],
            json["text"],
            None if duration is None else numbers.fraction(duration),
            json.get("name"),
            tuple(json.get("ends", ())),
            tuple(json.get("between", ())),
            tuple(map(Bond.from_json, json.get("bonds", ()))),
            tuple((one, two) for one, two in json.get("touching", ())),
            json.get("process"),
            None if "velocity" not in json else numbers.vector(json["velocity"]),
            None if "chance" not in json else numbers.fraction(json["chance"]),
            json.get("decision"),
            None if "spin" not in json else numbers.vector(json["spin"]),
        )


@dataclass(frozen=True)
class Transition:
    """``rules`` made it, the network's rule first. ``state`` (after it) only when asked for all states. ``chance`` is its
    probability if the model says ``collisions drawn`` and chance decides which of several comes first."""

    choice: int
    label: Label
    rules: Tuple[str, ...]
    state: Optional[State] = None
    rounded: Optional[Json] = None
    chance: Optional[Fraction] = None

    @classmethod
    def from_json(cls, json: Json) -> Transition:
        state = json.get("state")
        return cls(
            json["choice"],
            Label.from_json(json["label"]),
            tuple(json["rules"]),
            None if state is None else State.from_json(state),
            json.get("rounded"),
            None if "chance" not in json else numbers.fraction(json["chance"]),
        )


@dataclass(frozen=True)
class Successors:
    """What may happen in the state at ``path``. ``ending``: None, "quiescent" or "stuck"."""

    path: Tuple[int, ...]
    time: Fraction
    state: Optional[State]
    transitions: Tuple[Transition, ...]
    ending: Optional[str]

    @classmethod
    def from_json(cls, json: Json) -> Successors:
        state = json["state"]
        return cls(
            tuple(json["path"]),
            numbers.fraction(json["time"]),
            None if state is None else State.from_json(state),
            tuple(map(Transition.from_json, json["transitions"])),
            json["ending"],
        )


@dataclass(frozen=True)
class Step:
    """A transition taken; ``path``, ``time`` and ``state`` are those after it."""

    choice: int
    label: Label
    rules: Tuple[str, ...]
    path: Tuple[int, ...]
    time: Fraction
    state: State

    @classmethod
    def from_json(cls, json: Json) -> Step:
        return cls(
            json["choice"],
            Label.from_json(json["label"]),
            tuple(json["rules"]),
            tuple(json["path"]),
            numbers.fraction(json["time"]),
            State.from_json(json["state"]),
        )


@dataclass(frozen=True)
class Replay:
    """A run. ``lines`` are those of ``scc trace``, as JSON; ``ending``: "open", "quiescent", "stuck" or "zeno"."""

    lines: Tuple[Dict[str, Any], ...]
    steps: int
    time: Fraction
    ending: str

    @classmethod
    def from_json(cls, json: Json) -> Replay:
        return cls(tuple(json["lines"]), json["steps"], numbers.fraction(json["time"]), json["ending"])

    @property
    def labels(self) -> Tuple[Label, ...]:
        """Of its transitions, in order."""
        return tuple(Label.from_json(line["label"]) for line in self.lines if line["type"] == "transition")


@dataclass(frozen=True)
class Evaluation:
    """What a formula says in a state.

    ``kind`` is "state" (``value`` is a bool), "number" (a Fraction) or "temporal" (``verdict``, ``report`` and
    ``explored``, as in ``scc check --json``). A value that cannot be told is None, and ``reason`` says why.
    """

    kind: str
    value: Union[bool, Fraction, None] = None
    reason: Optional[str] = None
    verdict: Optional[str] = None
    report: Optional[Json] = None
    explored: Optional[Json] = None

    @classmethod
    def from_json(cls, json: Json) -> Evaluation:
        kind, value = json["kind"], json.get("value")
        if kind == "temporal":
            return cls(kind, None, None, json["verdict"], json["report"], json["explored"])
        if kind == "number" and value is not None:
            value = numbers.fraction(value["exact"])
        return cls(kind, value, json["reason"])


@dataclass(frozen=True)
class Description:
    """What the service is, what it can be asked, and its limits by name."""

    service: str
    protocol: int
    version: str
    semantics: str
    methods: Tuple[str, ...]
    limits: Mapping[str, int]

    @classmethod
    def from_json(cls, json: Json) -> Description:
        return cls(
            json["service"],
            json["protocol"],
            json["version"],
            json["semantics"],
            tuple(json["methods"]),
            dict(json["limits"]),
        )
