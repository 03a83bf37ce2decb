"""The proof that nothing will ever happen again (rule Quiescent)."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations
from typing import Any, List

import cast
import contact
import steps
from model import diagonal
from solids import Solid
from states import Process, State
from vectors import ZERO, sub

CUBE = Solid(
    [
        ("".join("-+"[i > 0] for i in (x, y, z)), (Fraction(x), Fraction(y), Fraction(z)))
        for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)
    ],
    [
        ("left", ("---", "--+", "-++", "-+-")), ("right", ("+--", "++-", "+++", "+-+")),
        ("front", ("---", "+--", "+-+", "--+")), ("back", ("-+-", "-++", "+++", "++-")),
        ("bottom", ("---", "-+-", "++-", "+--")), ("top", ("--+", "+-+", "+++", "-++")),
    ],
)  # fmt: skip


class Rest:
    """Rule Quiescent, of the rules of a rigid model."""

    model: Any
    free: bool
    resolution: Fraction

    def at_rest(self, state: State) -> bool:
        """Rule Quiescent: whether it is proved that no event can happen ever again."""
        for process in state.processes:
            if steps.is_steered(self, process) or process.clock is not None:
                return False
            if self.left_to_chance(process) or self.horizon(process) is not None or self.to_be_rounded(process):
                return False
        return all(self.known(self.never_meet, *pair) for pair in combinations(state.processes, 2))

    def to_be_rounded(self, process: Process) -> bool:
        """Whether a velocity or spin, or an angular momentum, of what spins waits for Round."""
        step = self.model.rounding.get("velocity")
        if step is None or process.spin == ZERO:
            return False
        after = self.slower(process, step)
        old, new = ((p.velocity, p.momentum if self.free else p.spin) for p in (process, after))
        return old != new

    def never_meet(self, p: Process, q: Process) -> bool:
        """Whether the hulls of no two parts ever meet."""
        w = sub(q.velocity, p.velocity)
        if w == ZERO and self.neither_spins(p, q):
            return True
        for a in self.hulls(p):
            for b in self.hulls(q):
                if contact.relation(a, b, ZERO) == "interpenetrating":
                    return False
                if contact.first_time_of_contact(a, b, ZERO, w) is not None:
                    return False
        return True

    def hulls(self, process: Process) -> List[Solid]:
        """Of each part: itself, or a cube about the ball that it turns in."""
        if process.spin == ZERO:
            return self.worlds(process)
        centre, found = self.centre(process), []
        for _, _, mover in self.movers(process):
            half = cast.reach(mover) + 2 * self.resolution
            found.append(CUBE.mapped(diagonal((half, half, half)), centre))
        return found
