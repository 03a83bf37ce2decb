"""Velocities that laws of motion leave to chance (rules Draw and Diffuse, reading I-38)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Optional, Tuple

import steps
from model import Leaf, Undefined, rotation
from states import WAITS, Process, State
from syntax import Refused
from vectors import ZERO, Vector, add, apply, scale, sub

Chances = Dict[Vector, Fraction]  # velocities with their probabilities
Weighed = List[Tuple[Any, Fraction]]  # what gives a velocity if it is asked for, with its weight

MOST_PAIRS = 1000000


def chooses(leaf: Leaf) -> bool:
    """Whether the law of a leaf leaves its velocity to chance."""
    return leaf.law is not None and leaf.law[0][0] in ("choose", "diffuse")


class Draws:
    """Rule Draw, of the rules of a model."""

    model: Any

    # What laws give.

    def chances(self, leaf: Leaf, seen: Dict[str, Any]) -> Chances:
        """The velocities that the law of a leaf gives, for what it sees."""
        assert leaf.law is not None
        law, env = leaf.law
        env = {**env, "": seen}
        if law[0] == "choose":
            weighed = self.chosen(law[1], env)
        elif law[0] == "diffuse":
            weighed = self.diffused(law[1], env)
        else:
            weighed = [(lambda: self.velocity(law, env), Fraction(1))]
        return self.normalised(merged((give(), w) for give, w in weighed if self.counts(w)))

    def velocity(self, written: Any, env: dict) -> Vector:
        return tuple(Fraction(x) for x in self.model.number(written, env))  # type: ignore

    def counts(self, weight: Fraction) -> bool:
        """Whether a velocity of this weight is asked for."""
        return weight != 0

    def normalised(self, weights: Chances) -> Chances:
        whole = sum(weights.values(), Fraction(0))
        if whole == 0:
            raise Undefined
        return {velocity: weight / whole for velocity, weight in weights.items()}

    def chosen(self, kicks: List[Any], env: dict) -> Weighed:
        """The velocities of ``choose``."""
        found = []
        for ranges, written, weight in kicks:
            for inner in self.bound(ranges, env):
                w = Fraction(self.model.number(weight, inner))
                if w < 0:
                    raise Undefined
                found.append((lambda e=inner, v=written: self.velocity(v, e), w))
        return found

    def bound(self, ranges: List[Any], env: dict) -> Iterator[dict]:
        """All values of the indices of ``for``."""
        if not ranges:
            yield env
            return
        name, low, high = ranges[0]
        for i in range(int(self.model.number(low, env)), int(self.model.number(high, env)) + 1):
            yield from self.bound(ranges[1:], {**env, name: Fraction(i)})

    def diffused(self, written: List[Any], env: dict) -> Weighed:
        """Rule Diffuse, of its two or three arguments that are not left out."""
        constants = self.constant(written[0], env)
        if not isinstance(constants, tuple):
            constants = (constants,) * 3
        if min(constants) < 0:
            raise Undefined
        drift = self.velocity(written[1], env) if len(written) > 1 and written[1] is not None else ZERO
        step = self.model.timestep
        spread = 2 * step * sum(constants)
        if len(written) > 2:
            h = Fraction(self.constant(written[2], env))
        else:
            h = least_kick(Fraction(spread))
        if h <= 0 or h * h < spread:
            raise Undefined
        kicks = [(drift, 1 - spread / (h * h))]
        for axis, constant in enumerate(constants):
            for sign in (1, -1):
                kick = tuple(sign * h / step if i == axis else Fraction(0) for i in range(3))
                kicks.append((add(drift, kick), constant * step / (h * h)))  # type: ignore
        return [(lambda v=velocity: v, Fraction(weight)) for velocity, weight in kicks]

    def constant(self, written: Any, env: dict) -> Any:
        """What does not depend on the state."""
        try:
            return self.model.number(written, {**env, "": {}})
        except Refused:
            raise Undefined from None

    # What processes draw.

    def ways(self, process: Process, time: Fraction, dt: Fraction) -> Chances:
        """What a process that is steered may come to: each leaf by a draw of its own (I-38)."""
        sums: Chances = {ZERO: Fraction(1)}
        for name, body in process.bodies.items():
            leaf = self.leaf(name)  # type: ignore[attr-defined]
            if leaf.law is None:
                continue
            x, v = self.seen(process, name)  # type: ignore[attr-defined]
            seen = {
                "x": x[0], "y": x[1], "z": x[2], "vx": v[0], "vy": v[1], "vz": v[2],
                "mass": leaf.mass, "time": time, "dt": body.waited if self.model.local else dt,
            }  # fmt: skip
            kicks = self.chances(leaf, seen)
            if len(sums) * len(kicks) > MOST_PAIRS:
                raise Undefined
            sums = merged(
                (add(change, scale(self.share(process, leaf), sub(kick, v))), p * q)
                for change, p in sums.items()
                for kick, q in kicks.items()
            )
        return {add(process.velocity, change): p for change, p in sums.items()}

    def share(self, process: Process, leaf: Leaf) -> Fraction:
        """What the change of a leaf counts in that of the whole."""
        return leaf.mass / self.mass(process)  # type: ignore[attr-defined]

    def since_asked(self, state: State) -> Fraction:
        """The dt of laws, with movement steps of the network (I-10)."""
        return Fraction(0) if state.step is None else self.model.timestep - state.step.remaining

    def to_draw(self, state: State, asked: List[Process]) -> Optional[State]:
        """With all that are asked waiting to draw, or told what certain laws give them; None if
        no law of theirs chooses."""
        under_law = [p for p in asked if steps.is_steered(self, p)]
        if not any(self.draws(p) for p in under_law):
            return None
        waiting = []
        for p in under_law:
            ways = self.ways(p, state.time, self.since_asked(state))
            draw = WAITS if self.draws(p) else next(iter(ways))
            waiting.append(replace(self.stopped(p), draw=draw))
        return state.having(under_law, waiting)

    def draws(self, process: Process) -> bool:
        return any(chooses(self.leaf(name)) for name in process.bodies)  # type: ignore

    def stopped(self, process: Process) -> Process:
        """With its turn ended, and a new one due, as its laws see it."""
        return replace(process, lasts=None)

    def place(self, process: Process) -> Any:
        """The process that is least by this draws first: its leaves from the least on."""
        return sorted(self.place_of_leaf(name, body) for name, body in process.bodies.items())

    def place_of_leaf(self, name: str, body: Any) -> Any:
        """The reference point, the orientation, and the centroid of the first part in the world."""
        inside = self.leaf(name).inside  # type: ignore[attr-defined]
        if body.turned is not None:
            inside = apply(rotation([Fraction(q) for q in body.turned]), inside)
        return body.position, body.turned, add(body.position, inside)

    def drawings(self, state: State) -> List[Tuple[Any, State]]:
        """The draws of who goes first; none if nobody waits to draw."""
        waiting = [p for p in state.processes if p.draw == WAITS]
        if not waiting:
            return []
        first, found = min(waiting, key=self.place), []
        ways = self.ways(first, state.time, self.since_asked(state))
        for velocity, chance in ways.items():
            label = ("draw", self.first(first), velocity, chance)  # type: ignore[attr-defined]
            after = state.having([first], [replace(first, draw=velocity)])
            found.append((label, self.after_drawing(after)))
        return found

    def after_drawing(self, state: State) -> State:
        """What all draw takes effect by the last draw."""
        if waits(state):
            return state
        asked = [p for p in state.processes if p.draw is not None]
        return self.finished(self.steer_all(state, asked))  # type: ignore[attr-defined]


def waits(state: State) -> bool:
    """Whether somebody waits to draw."""
    return any(p.draw == WAITS for p in state.processes)


def merged(pairs: Any) -> Chances:
    """What is named twice has the sum of both."""
    found: Chances = {}
    for velocity, weight in pairs:
        found[velocity] = found.get(velocity, Fraction(0)) + weight
    return found


def least_kick(square: Fraction) -> Fraction:
    """The least power of two whose square is at least this; 1 for 0."""
    h = Fraction(1)
    if square == 0:
        return h
    while h * h < square:
        h *= 2
    while h * h / 4 >= square:
        h /= 2
    return h
