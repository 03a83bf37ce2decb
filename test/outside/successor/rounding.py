"""What begins at once, what is rounded then (rule Round), and estimates of spins (rule Turn)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any, List, Optional

import near
from model import nearest, rotation
from motion import STILL, inverse, product, whole
from states import Process
from vectors import ZERO, Vector, add, apply, dot, sub


class Rounding:
    """Rule Round, of the rules of a model."""

    model: Any
    free = False

    def rounded(self, processes: List[Process], due: List[int]) -> List[Process]:
        """Rule Round."""
        if "orientation" in self.model.rounding:
            processes = self.rounded_orientations(processes, due)
        return self.rounded_velocities(processes, due)

    def rounded_velocities(self, processes: List[Process], due: List[int]) -> List[Process]:
        if "velocity" not in self.model.rounding:
            return processes
        step = self.model.rounding["velocity"]
        after = [self.slower(p, step) if i in due else p for i, p in enumerate(processes)]
        return self.at_once(processes, after)

    def at_once(self, before: List[Process], after: List[Process]) -> List[Process]:
        """Changes all processes but those that would collide then, and did not before."""
        old = set(self.colliding(before))
        while True:
            new = [pair for pair in self.colliding(after) if pair not in old]
            waiting = {i for pair in new for i in pair if after[i] is not before[i]}
            if not waiting:
                return after
            after = [before[i] if i in waiting else p for i, p in enumerate(after)]

    def slower(self, process: Process, step: Fraction) -> Process:
        """With a velocity and a spin, or angular momentum, that are rounded."""
        if self.is_fixed(process):
            return process
        velocity = nearest_vector(process.velocity, step)
        if not self.free:
            return replace(process, velocity=velocity, spin=nearest_vector(process.spin, step))
        inertia = self.inertia(process)
        power = Fraction(2) ** exponent(inertia[0][0] + inertia[1][1] + inertia[2][2])
        momentum = nearest_vector(process.momentum or ZERO, step * power)
        after = replace(process, velocity=velocity, momentum=momentum)
        return replace(after, spin=self.spin_now(after))

    def rounded_orientations(self, processes: List[Process], due: List[int]) -> List[Process]:
        most = 1 / self.model.rounding["orientation"]
        after, room = list(processes), [Fraction(0)] * len(processes)
        for i in due:
            turned = self.coarser(processes[i], most)
            if turned is not None:
                after[i] = turned
                room[i] = 2 / most * self.radius(processes[i])
        waiting = set()
        for i, j in combinations(range(len(processes)), 2):
            if room[i] + room[j] > 0 and not self.apart(
                processes[i], processes[j], room[i] + room[j]
            ):
                waiting |= {i, j}
        after = [processes[i] if i in waiting else p for i, p in enumerate(after)]
        return self.at_once(processes, after)

    def apart(self, p: Process, q: Process, room: Fraction) -> bool:
        """Whether two processes are farther apart than that."""
        for a in self.worlds(p):
            for b in self.worlds(q):
                start, end = near.shortest(a, b)
                d = sub(end, start)
                if dot(d, d) <= room * room:
                    return False
        return True

    def coarser(self, process: Process, most: Fraction) -> Optional[Process]:
        """With an orientation of shorter numbers, as a whole; None if they are short enough."""
        quaternions = [body.turned or STILL for body in process.bodies.values()]
        old = min(quaternions, key=lambda q: (max(abs(x) for x in q), q))
        greatest = max(abs(x) for x in old)
        if greatest <= most:
            return None
        new = tuple(nearest(x * most / greatest, Fraction(1)) for x in old)
        step = product(new, inverse(old))
        turn = rotation([Fraction(x) for x in step])
        centre = self.centre(process)
        bodies = {
            name: replace(
                body,
                position=add(centre, apply(turn, sub(body.position, centre))),
                turned=whole(product(step, body.turned or STILL)),
            )
            for name, body in process.bodies.items()
        }
        after = replace(process, bodies=bodies)
        return replace(after, spin=self.spin_now(after))


def nearest_vector(v: Vector, step: Fraction) -> Vector:
    return tuple(nearest(x, step) for x in v)  # type: ignore[return-value]


def estimate(v: Vector) -> Vector:
    """Components rounded to multiples of 2^(e-40), 2^e <= the greatest < 2^(e+1)."""
    most = max(abs(x) for x in v)
    if most == 0:
        return v
    e = exponent(most)
    step = Fraction(2) ** (e - 40)
    return tuple(nearest(x, step) for x in v)  # type: ignore[return-value]


def exponent(x: Fraction) -> int:
    """The e with 2^e <= x < 2^(e+1)."""
    e = x.numerator.bit_length() - x.denominator.bit_length()
    while Fraction(2) ** e > x:
        e -= 1
    while Fraction(2) ** (e + 1) <= x:
        e += 1
    return e
