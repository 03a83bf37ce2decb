"""What laws of motion give, and leave to chance (Steer, Draw, Diffuse, I-24, I-38).

A motion is a tuple of the three numbers of a velocity, or of six: these, and those of a spin.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Optional, Tuple

import steps
from model import Leaf, Undefined, gives_spin, rotation
from states import WAITS, Process, State
from syntax import Refused
from vectors import ZERO, Vector, add, apply

Motion = Tuple[Fraction, ...]
Chances = Dict[Motion, Fraction]  # motions with their probabilities
Weighed = List[Tuple[Any, Fraction]]  # what gives a motion if it is asked for, with its weight

MOST_PAIRS = 1000000


def chooses(leaf: Leaf) -> bool:
    """Whether the law of a leaf leaves its velocity to chance."""
    return leaf.law is not None and leaf.law[0][0] in ("choose", "diffuse")


class Draws:
    """Rule Draw, of the rules of a model."""

    model: Any

    # What laws give.

    def chances(self, leaf: Leaf, seen: Dict[str, Any]) -> Chances:
        """The motions that the law of a leaf gives, for what it sees."""
        assert leaf.law is not None
        law, env = leaf.law
        env = {**env, "": seen}
        if law[0] == "choose":
            weighed = self.chosen(law[1], env)
        elif law[0] == "diffuse":
            weighed = self.diffused(law[1], env)
        else:
            weighed = [(lambda: self.motion(law[1], law[2], env), Fraction(1))]
        given = [(give(), w) for give, w in weighed if self.counts(w)]
        if gives_spin(law):
            given = [(m if len(m) == 6 else self.with_own_spin(m, seen), w) for m, w in given]
        return self.normalised(merged(given))

    def with_own_spin(self, motion: Motion, seen: Dict[str, Any]) -> Motion:
        """With the spin that there is, where the law does not give one (I-24)."""
        return motion + (seen["wx"], seen["wy"], seen["wz"])

    def velocity(self, written: Any, env: dict) -> Vector:
        return tuple(Fraction(x) for x in self.model.number(written, env))  # type: ignore

    def motion(self, velocity: Any, spin: Any, env: dict) -> Motion:
        given = self.velocity(velocity, env)
        return given if spin is None else given + self.velocity(spin, env)

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
        for ranges, velocity, spin, weight in kicks:
            for inner in self.bound(ranges, env):
                w = Fraction(self.model.number(weight, inner))
                if w < 0:
                    raise Undefined
                found.append((lambda e=inner, v=velocity, s=spin: self.motion(v, s, e), w))
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
        """Rule Diffuse."""
        diffusion, drifting, kick, turning = written
        constants = self.constants(diffusion, env)
        drift = ZERO if drifting is None else self.velocity(drifting, env)
        step = self.model.timestep
        spread = 2 * step * sum(constants)
        h = least_kick(Fraction(spread)) if kick is None else Fraction(self.constant(kick, env))
        if h <= 0 or h * h < spread:
            raise Undefined
        kicks = [(drift, 1 - spread / (h * h))]
        for axis, constant in enumerate(constants):
            for sign in (1, -1):
                kick = tuple(sign * h / step if i == axis else Fraction(0) for i in range(3))
                kicks.append((add(drift, kick), constant * step / (h * h)))  # type: ignore
        if turning is not None:
            turns = self.turns(self.constants(turning, env))
            kicks = [(v + w, p * q) for v, p in kicks for w, q in turns]
        return [(lambda m=motion: m, Fraction(weight)) for motion, weight in kicks]

    def turns(self, constants: Vector) -> List[Tuple[Vector, Fraction]]:
        """Spins for one step, with their chances."""
        step = self.model.timestep
        total = step * sum(constants)
        if total == 0:
            return [(ZERO, Fraction(1))]
        tangent = Fraction(1)
        if 1 - cosine(tangent) < total:
            raise Undefined
        while 1 - cosine(tangent / 2) >= total:
            tangent /= 2
        most, spin = 1 - cosine(tangent), 2 * tangent / step
        found = [(ZERO, 1 - total / most)]
        for axis, constant in enumerate(constants):
            for sign in (1, -1):
                about = tuple(sign * spin if i == axis else Fraction(0) for i in range(3))
                found.append((about, constant * step / (2 * most)))  # type: ignore
        return found

    def constants(self, written: Any, env: dict) -> Vector:
        """One for each axis."""
        found = self.constant(written, env)
        if not isinstance(found, tuple):
            found = (found,) * 3
        if min(found) < 0:
            raise Undefined
        return tuple(Fraction(x) for x in found)  # type: ignore

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
            w = self.spin_seen(process)
            seen = {
                "x": x[0], "y": x[1], "z": x[2], "vx": v[0], "vy": v[1], "vz": v[2],
                "wx": w[0], "wy": w[1], "wz": w[2],
                "mass": leaf.mass, "time": time, "dt": body.waited if self.model.local else dt,
            }  # fmt: skip
            kicks = self.chances(leaf, seen)
            if len(sums) * len(kicks) > MOST_PAIRS:
                raise Undefined
            sums = merged(
                (changed(change, self.share(process, leaf), kick, v + w), p * q)
                for change, p in sums.items()
                for kick, q in kicks.items()
            )
        now = process.velocity + self.spin_seen(process)
        return {tuple(a + b for a, b in zip(now, change)): p for change, p in sums.items()}

    def spin_seen(self, process: Process) -> Vector:
        """The spin of a process, as its laws see it: none in translation."""
        return ZERO

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
        for motion, chance in ways.items():
            label = ("draw", self.first(first), motion, chance)  # type: ignore[attr-defined]
            after = state.having([first], [replace(first, draw=motion)])
            found.append((label, self.after_drawing(after)))
        return found

    def after_drawing(self, state: State) -> State:
        """What all draw takes effect by the last draw."""
        if waits(state):
            return state
        asked = [p for p in state.processes if p.draw is not None]
        drawn = [set(p.bodies) for p in asked]
        rules: Any = self
        return rules.finished(rules.without_blocked_kicks(rules.steer_all(state, asked), drawn))


def waits(state: State) -> bool:
    """Whether somebody waits to draw."""
    return any(p.draw == WAITS for p in state.processes)


def merged(pairs: Any) -> Chances:
    """What is named twice has the sum of both."""
    found: Chances = {}
    for motion, weight in pairs:
        found[motion] = found.get(motion, Fraction(0)) + weight
    return found


def changed(change: Motion, share: Fraction, given: Motion, now: Motion) -> Motion:
    """With what a leaf asks for: a leaf without a spin changes none."""
    asked = tuple(share * (a - b) for a, b in zip(given, now))
    longer, shorter = (asked, change) if len(asked) > len(change) else (change, asked)
    return tuple(a + b for a, b in zip(longer, shorter)) + longer[len(shorter):]


def cosine(tangent: Fraction) -> Fraction:
    """Of the angle by which a step turns, at a spin of twice this by the timestep (Turn)."""
    if tangent > Fraction(1, 4):
        return 2 * cosine(tangent / 2) ** 2 - 1
    return (1 - tangent**2) / (1 + tangent**2)


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
