"""States: as values that can be compared, and as the JSON of ``scc`` tells them (rule State)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Dict, FrozenSet, List, Optional, Tuple

import terms
from model import Model, Site
from syntax import Reader
from vectors import ZERO, Vector

End = Tuple[str, Site]
Bond = Tuple[str, FrozenSet[End]]
WAITS = "waits"  # of a process that is to draw its velocity (rule Draw)
UNDECIDED, RELEASE, FIRST = "undecided", "release", "first"  # what lots have decided (rule Lot)


@dataclass(frozen=True)
class Body:
    """A leaf in a state."""

    position: Vector
    term: terms.Term
    origin: Optional[str]
    turned: Optional[Tuple[int, ...]] = None
    waited: Fraction = Fraction(0)  # since its law was asked, with local steps (I-31)


@dataclass(frozen=True)
class Step:
    """Where the network is in its movement step, or a process in its own."""

    remaining: Fraction
    phase: str


@dataclass(frozen=True)
class Lot:
    """A bond whose lots are pending: what they have decided, and by which summands of its leaves
    (rule Lot)."""

    bond: Bond
    decided: str = UNDECIDED
    by: FrozenSet[Tuple[str, terms.Term]] = frozenset()


@dataclass(frozen=True)
class Process:
    """Leaves that are bound to each other."""

    velocity: Vector
    clock: Optional[Fraction]
    bodies: Dict[str, Body]
    bonds: FrozenSet[Bond]
    spin: Vector = ZERO
    since: Fraction = Fraction(0)
    momentum: Optional[Vector] = None  # angular, of free bodies
    lasts: Optional[Fraction] = None  # a turn in all; None while one is due
    step: Optional[Step] = None  # of its own, with local steps (I-31)
    draw: Any = None  # while somebody waits to draw: WAITS, or the velocity to come
    lots: FrozenSet[Lot] = frozenset()  # that are pending

    def key(self) -> Any:
        return (
            self.velocity, self.clock, tuple(sorted(self.bodies.items(), key=lambda b: b[0])),
            self.bonds, self.spin, self.since, self.momentum, self.lasts, self.step,
            self.draw, self.lots,
        )  # fmt: skip


@dataclass(frozen=True)
class State:
    """Processes in no order (I-5), and the movement step."""

    processes: Tuple[Process, ...]
    step: Optional[Step]
    time: Fraction = field(default=Fraction(0))
    since: Optional[Fraction] = None  # the last split instant, where lots are drawn (I-39)

    def key(self) -> Any:
        def order(process: Process) -> str:
            return min(process.bodies)

        processes = tuple(p.key() for p in sorted(self.processes, key=order))
        since = self.since if processes else None  # processes tell it
        return (processes, self.step, self.time, since)

    def having(self, old: List[Process], new: List[Process]) -> "State":
        """With some processes in the place of others."""
        kept = tuple(p for p in self.processes if not any(p is o for o in old))
        return replace(self, processes=kept + tuple(new))


def vector(numbers: List[str]) -> Vector:
    return tuple(Fraction(x) for x in numbers)  # type: ignore[return-value]


def end_of(model: Model, text: str) -> End:
    return model.end(Reader(text).feature(), {})


def bond_of(model: Model, bond: dict) -> Bond:
    return (bond["name"], frozenset(end_of(model, e) for e in bond["ends"]))


def process_of(model: Model, told: dict) -> Process:
    bodies = {}
    for leaf in told["leaves"]:
        bodies[leaf["name"]] = Body(
            vector(leaf["position"]),
            model.read_term(model.leaves[leaf["name"]], leaf["behaviour"]),
            leaf["origin"],
            tuple(int(q) for q in leaf["turned"]) if "turned" in leaf else None,
            Fraction(leaf.get("waited", 0)),
        )
    return Process(
        vector(told["velocity"]),
        None if told["clock"] is None else Fraction(told["clock"]),
        bodies,
        frozenset(bond_of(model, b) for b in told["bonds"]),
        vector(told["spin"]) if "spin" in told else ZERO,
        Fraction(told.get("since", 0)),
        vector(told["angular_momentum"]) if "angular_momentum" in told else None,
        None if told.get("lasts") is None else Fraction(told["lasts"]),
        step_of(told.get("step")),
        draw_of(told.get("draw")),
        frozenset(lot_of(model, lot) for lot in told.get("lots", {"pending": []})["pending"]),
    )


def lot_of(model: Model, told: dict) -> Lot:
    """Rule Lot: a bond whose lots are pending."""
    by = {
        (way["leaf"], model.read_term(model.leaves[way["leaf"]], way["summand"]))
        for way in told["by"]
    }
    return Lot(bond_of(model, told), told["decided"], frozenset(by))


def draw_of(told: Any) -> Any:
    """Rule Draw: that a process waits, the velocity that it has drawn, or nothing."""
    if isinstance(told, dict):
        return vector(told["velocity"]) + vector(told["spin"])
    return vector(told) if isinstance(told, list) else told


def step_of(told: Optional[dict]) -> Optional[Step]:
    if told is None:
        return None
    return Step(Fraction(told["remaining"]), told["phase"])


def state_of(model: Model, told: dict, time: str) -> State:
    """The state that the JSON tells."""
    processes = tuple(process_of(model, p) for p in told["processes"])
    since = {p["lots"]["since"] if "lots" in p else None for p in told["processes"]}
    if len(since) > 1:
        raise ValueError("split instants of the network that are not the same for all")
    last = next(iter(since), None)
    step = step_of(told.get("step"))
    return State(processes, step, Fraction(time), None if last is None else Fraction(last))


def label_of(model: Model, told: dict) -> Any:
    """A label as a value that can be compared."""
    kind = told["kind"]
    if kind == "time":
        return ("time", Fraction(told["duration"]))
    if kind == "bounce":
        hits = frozenset(frozenset(pair) for pair in told["touching"])
        return ("bounce", tuple(told["between"]), hits)
    if kind == "draw":
        motion = vector(told["velocity"]) + (vector(told["spin"]) if "spin" in told else ())
        return (kind, told["process"], motion, Fraction(told["chance"]))
    if kind == "lot":
        chance = Fraction(told["chance"]) if "chance" in told else None
        return (kind, told["decision"], *bond_of(model, told), chance)
    if kind == "absorb":
        return (kind,) + tuple(told["between"])
    if "bonds" in told:
        released = frozenset(bond_of(model, b) + (push_of(b),) for b in told["bonds"])
        return ("weaks" if kind == "weak" else kind, released)
    if kind == "weak":
        return ("weak",) + bond_of(model, told) + (push_of(told),)
    return (kind,) + bond_of(model, told)


def push_of(told: dict) -> Optional[Fraction]:
    """The push of a bond that is released (I-36); None where it is 0."""
    return Fraction(told["push"]) if "push" in told else None
