"""Movement steps of single processes (rule Steer, reading I-31)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any, Optional

from states import Process, Step


def is_steered(rules: Any, process: Process) -> bool:
    """Whether a law moves a process: a leaf of it has one, and none of it is fixed."""
    laws = any(rules.leaf(name).law is not None for name in process.bodies)
    return laws and not rules.is_fixed(process)


def having(rules: Any, process: Process, phase: Optional[str]) -> Process:
    """In a phase, if it is steered; what was not steered begins with a step that is over."""
    if not rules.model.local:
        return process
    if not is_steered(rules, process):
        return replace(forgotten(process), step=None)
    if phase is None:
        return having(rules, forgotten(process), "due")
    waited = max(body.waited for body in process.bodies.values())
    return replace(process, step=Step(rules.model.timestep - waited, phase))


def forgotten(process: Process) -> Process:
    """With no time since a law was asked."""
    bodies = {n: replace(body, waited=Fraction(0)) for n, body in process.bodies.items()}
    return replace(process, bodies=bodies)


def joined(rules: Any, p: Process, q: Process, whole: Process) -> Process:
    """The step of a whole is over, unless what is steered of both was so at this instant."""
    phases = {x.step.phase for x in (p, q) if x.step is not None}
    return having(rules, whole, "steered" if phases == {"steered"} else "due")


def struck(process: Process) -> Process:
    """A step is over when a collision of its process is resolved."""
    if process.step is None or process.step.phase != "moving":
        return process
    return replace(process, step=replace(process.step, phase="due"))


def passed(process: Process, d: Fraction) -> Process:
    """The time d of a step."""
    if process.step is None:
        return process
    left = process.step.remaining - d
    bodies = {n: replace(body, waited=body.waited + d) for n, body in process.bodies.items()}
    return replace(process, bodies=bodies, step=Step(left, "moving" if left else "due"))


def begun(rules: Any, process: Process) -> Process:
    """In a new step, after the laws were asked."""
    return having(rules, forgotten(process), "steered")
