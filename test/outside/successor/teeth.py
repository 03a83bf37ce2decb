"""Shows that the comparison can fail: rules are broken on this side, one by one.

    teeth.py --scc PATH [--models N] [NAME ...]

Each of these mistakes has to be noticed on some random model.
"""

from __future__ import annotations

import argparse
import random
import sys
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any, Callable, Dict

import compare
import contact
import draws
import generate
import lots
import response
import steps
import straight
import terms
import turning
from lots import Lot, lots_wait
from model import Leaf
from oracle import Oracle
from rates import chance_of_rate
from rounding import Rounding
from states import WAITS
from straight import Rules
from turning import Turning

Mistake = Callable[[], Any]


def replaced(owner: Any, name: str, value: Any) -> Mistake:
    """Puts a value in the place of another; what that gives puts it back."""

    def apply() -> Any:
        old = getattr(owner, name)
        setattr(owner, name, value)
        return lambda: setattr(owner, name, old)

    return apply


_covered, _touch, _dimension = response.covered, contact.touch, contact.dimension
_grown, _passed = terms.grown, Rules.passed
_clusters, _active, _steered = Rules.clusters, Leaf.active, Rules.steered
_driven_apart, _line, _taken = Rules.driven_apart, Rules.line, Rules.taken
_successors, _ways, _share = Rules.successors, Rules.ways, Rules.share


def every_direction(own: Any, n: Any, others: Any) -> bool:
    return False


def no_sum(a: Any, b: Any) -> bool:
    """Features touch where they share any point, as far as corners tell."""
    return _touch(a, b) or bool(set(a) & set(b))


def lazy_clock(self: Rules, before: Any, after: Any, d: Fraction) -> Any:
    if not self.releasable(after):
        return None
    return Fraction(0) if before.clock is None else (before.clock + d) % self.model.split_step


def eager_clock(self: Rules, before: Any, after: Any, d: Fraction) -> Any:
    if not self.releasable(after):
        return None
    if before.clock is None or self.horizon(before) == d:
        return Fraction(0)
    return (before.clock + d) % self.model.split_step


def nearest_normal(normals: Any, w: Any) -> Any:
    """Projects on one of the normals only."""
    best = max(normals, key=lambda n: (Fraction(contact.dot(n, w) ** 2, contact.dot(n, n)), n))
    k = Fraction(contact.dot(best, w), contact.dot(best, best))
    return tuple(k * x for x in best)


def one_by_one(self: Rules, state: Any) -> Any:
    return [[meeting] for meeting in self.collisions(state)]


def linked_by_all(self: Rules, state: Any) -> Any:
    fixed, self.is_fixed = self.is_fixed, lambda process: False  # type: ignore[method-assign]
    try:
        return _clusters(self, state)
    finally:
        self.is_fixed = fixed  # type: ignore[method-assign]


def collisions_alone(self: Rules, state: Any) -> Any:
    found = [(p, q, self.collision(p, q)) for p, q in combinations(state.processes, 2)]
    return [meeting for meeting in found if meeting[2] is not None]


def leaf_alone(self: Rules, cluster: Any) -> Any:
    """Nothing happens to who is more than a leaf."""
    return ((p, taker) for p, taker in _taken(self, cluster) if len(p.bodies) == 1)


def one_driven(self: Rules, pieces: Any, bond: Any, push: Fraction) -> Any:
    """Only one of two pieces takes its share of a push."""
    driven = _driven_apart(self, pieces, bond, push)
    changed = [i for i, piece in enumerate(pieces) if driven[i] is not piece]
    return [driven[i] if i in changed[:1] else piece for i, piece in enumerate(pieces)]


def any_two(self: Rules, process: Any) -> Any:
    """Every two leaves, bound or not."""
    return combinations(process.bodies, 2)


def not_urgent(self: Rules, state: Any) -> Any:
    """Time may pass although a ring may close."""
    found = _successors(self, state)
    if found and all(label[0] in ("weak", "close") for label, _ in found):
        d = self.delay(state)
        if d is not None:
            found.append((("time", d), self.settled(self.passed(state, d), "time")))
    return found


def first_way(pairs: Any) -> Any:
    """What is named twice counts as it is named first."""
    found: Dict[Any, Any] = {}
    for velocity, weight in pairs:
        found.setdefault(velocity, weight)
    return found


def plain_mean(self: Rules, process: Any, leaf: Leaf) -> Fraction:
    """All leaves count alike where something is drawn."""
    drawing = self.draws(process)
    return Fraction(1, len(process.bodies)) if drawing else _share(self, process, leaf)


def summed_spins(change: Any, share: Any, given: Any, now: Any) -> Any:
    """Spins count by no mass."""
    found = _changed(change, share, given[:3], now[:3])
    spin = tuple(a - b for a, b in zip(given[3:], now[3:]))
    return found[:3] + tuple(a + b for a, b in zip(spin or _still, found[3:] or _still))


def one_turn(tangent: Fraction) -> Fraction:
    """As if a step were one turn, however far."""
    return (1 - tangent**2) / (1 + tangent**2)


def one_for_all(self: Rules, process: Any, time: Fraction, dt: Fraction) -> Any:
    """A whole draws by the law of its first leaf that chooses."""
    drawing = [name for name in process.bodies if draws.chooses(self.leaf(name))]
    if not drawing:
        return _ways(self, process, time, dt)
    alone = replace(process, bodies={drawing[0]: process.bodies[drawing[0]]})
    return _ways(self, alone, time, dt)


def at_once(self: Rules, state: Any) -> Any:
    """A velocity takes effect as soon as it is drawn."""
    after = [p if p.draw in (None, WAITS) else replace(p, velocity=p.draw) for p in state.processes]
    return _after_drawing(self, replace(state, processes=tuple(after)))


def time_and_draws(self: Rules, state: Any) -> Any:
    """Time may pass although somebody waits to draw."""
    found, d = _drawings(self, state), self.delay(state)
    if found and d:
        found.append((("time", d), self.settled(self.passed(state, d), "time")))
    return found


def in_any_order(self: Rules, state: Any) -> Any:
    """Everybody who waits may draw next."""
    found = []
    for p in state.processes:
        if p.draw == WAITS:
            self.place = lambda q: q is not p  # type: ignore[method-assign]
            found += _drawings(self, state)
            del self.place
    return found


def from_the_start(self: Rules) -> Any:
    """Lots are drawn at the start, too."""
    return self.pending(_initial(self))


def by_name(self: Rules, process: Any, lots: Any) -> Any:
    return sorted(lots, key=lambda lot: sorted(leaf for leaf, _ in lot.bond[1]))


def leaves_alone(self: Rules, process: Any, end: Any) -> Any:
    """The order of declaration before the position."""
    place, own = _place_of(self, process, end)
    return list(self.model.leaves).index(end[0]), place, own


def also_new(self: Rules, piece: Any, others: Any) -> Any:
    """What a release makes releasable draws at the same instant."""
    known = {lot.bond for lot in others}
    new = {Lot(b) for b in piece.bonds if b not in known and self.applies(piece, b)}
    return _left_to_release(self, piece, others) | new


def process_by_process(self: Rules, state: Any) -> Any:
    """One process draws and releases before the next one."""
    waiting = sorted((p for p in state.processes if p.lots), key=self.goes_first)[:1]
    if not waiting:
        return []
    return (
        self.to_draw_lots(state, waiting)
        or self.to_be_first(state, waiting)
        or self.to_choose(state, waiting)
        or self.to_release(state, waiting)
    )


def set_anew(self: Rules, state: Any, process: Any, lot: Any, decision: str, by: Any) -> Any:
    """A lot sets the split clock of its process."""
    after = _decided(self, state, process, lot, decision, by)
    return replace(after, processes=tuple(
        self.begun(p) if set(p.bodies) == set(process.bodies) else p for p in after.processes
    ))  # fmt: skip


def with_its_free_ways(self: Rules, process: Any, name: str, end: Any) -> Any:
    """Who has a chance may let go freely, too."""
    drawn = _end_chances(self, process, name, end)
    free = {s: Fraction(0) for s in self.matching(process, name, end) if s[3] is None}
    return {**drawn, **free} if drawn else drawn


def equal_ones_once(self: Rules, process: Any, name: str, end: Any) -> Any:
    """Equal summands have one chance together."""
    drawn = _end_chances(self, process, name, end)
    every = self.summands(end[0], process.bodies[end[0]])
    return drawn and {s: q / every.count(s) for s, q in drawn.items()}


def each_rate_alone(self: Rules, process: Any, name: str, end: Any) -> Any:
    """Rates do not compete."""
    drawn = _end_chances(self, process, name, end)
    step = self.model.split_step
    return drawn and {
        s: chance_of_rate(s[3][1], step) if s[3][0] == "rate" else q for s, q in drawn.items()
    }


_initial, _place_of, _left_to_release = Rules.initial, Rules.place_of, Rules.left_to_release
_decided, _end_chances, _in_order = Rules.decided, Rules.end_chances, Rules.in_order
_free_ways, _to_release = Rules.free_ways, Rules.to_release
_waits = straight.waits
_changed, _still = draws.changed, (Fraction(0),) * 3
_after_drawing, _drawings = Rules.after_drawing, Rules.drawings

MISTAKES: Dict[str, Mistake] = {
    "I-13: every direction counts": replaced(response, "covered", every_direction),
    "Response: the steepest normal alone": replaced(response, "project", nearest_normal),
    "I-3: shared points": replaced(contact, "touch", no_sum),
    "Bind: all dimensions alike": replaced(contact, "dimension", lambda a, b: 0),
    "I-9: a further bond leaves the clock alone": replaced(Rules, "aged_clock", lazy_clock),
    "I-9: each eps sets the clock": replaced(Rules, "aged_clock", eager_clock),
    "I-17: repetition is kept": replaced(terms, "without_repetition", lambda t, lookup: t),
    "I-7: any set of bonds reacts": replaced(straight, "hangs_together", lambda bonds: True),
    "Ftoc: a graze is a collision": replaced(
        contact, "approaching",
        lambda a, b, o, w: all(contact.dot(n, w) <= 0 for n in contact.tight(a, b, o)),
    ),
    "I-15: no steering at contact": replaced(
        Rules, "steered", lambda self, process, time, dt: process
    ),
    "I-31: steps go on through collisions": replaced(steps, "struck", lambda process: process),
    "I-31: a whole is steered once more": replaced(
        steps, "joined", lambda rules, p, q, whole: steps.having(rules, whole, "due")
    ),
    "I-32: one by one": replaced(Rules, "clusters", one_by_one),
    "I-32: what is fixed links too": replaced(Rules, "clusters", linked_by_all),
    "I-33: only what collides binds": replaced(Rules, "collisions", collisions_alone),
    "I-33: time passes by": replaced(Rules, "to_binding", lambda self, state: None),
    "I-34: only has its closure": replaced(
        Leaf, "active", lambda self, alone, sites: _active(self, frozenset(), alone | sites)
    ),
    "I-34: the others have none": replaced(
        Leaf, "active", lambda self, alone, sites: _active(self, alone | sites, frozenset())
        if alone else _active(self, alone, sites)
    ),
    "Round: nobody waits": replaced(Rounding, "at_once", lambda self, before, after: after),
    "Round: at collisions alone": replaced(
        Rules, "steered", lambda self, process, time, dt: replace(
            _steered(self, process, time, dt), lasts=process.lasts
        )
    ),
    "I-35: collisions end steps": replaced(
        Rules, "ends_step", lambda self, kind: kind in ("bind", "bounce")
    ),
    "Absorb: it bounces": replaced(Rules, "taken", lambda self, cluster: iter(())),
    "Absorb: a leaf alone goes": replaced(Rules, "taken", leaf_alone),
    "Absorb: steps go on": replaced(
        Rules, "ends_step",
        lambda self, kind: kind in ("bind", "bounce") and not self.model.steady
    ),
    "I-36: one end is driven": replaced(Rules, "driven_apart", one_driven),
    "I-36: from centroid to centroid": replaced(
        Rules, "line", lambda self, normals, one, two: _line(self, [], one, two)
    ),
    "I-37: two bonds of two leaves": replaced(Rules, "unbound", any_two),
    "I-37: bonds are a tree": replaced(Rules, "closings", lambda self, state: []),
    "Close: time may pass": replaced(Rules, "successors", not_urgent),
    "Draw: weights are chances": replaced(Rules, "normalised", lambda self, weights: weights),
    "Draw: named twice, counted once": replaced(draws, "merged", first_way),
    "Draw: weight 0 is drawn": replaced(Rules, "counts", lambda self, weight: True),
    "Draw: masses do not count": replaced(Rules, "share", plain_mean),
    "Draw: velocities change one by one": replaced(Rules, "after_drawing", at_once),
    "Draw: by name": replaced(Rules, "place", lambda self, process: self.first(process)),
    "Draw: in the order of declaration": replaced(
        Rules, "place", lambda self, process: list(self.model.leaves).index(self.first(process))
    ),
    "Draw: the last one first": replaced(
        Rules, "place", lambda self, process: max(b.position for b in process.bodies.values())
    ),
    "Draw: in any order": replaced(Rules, "drawings", in_any_order),
    "Draw: time may pass": replaced(Rules, "drawings", time_and_draws),
    "Draw: a turn goes on until all have drawn": replaced(
        Turning, "stopped", lambda self, process: process
    ),
    "Draw: turns begin before all have drawn": replaced(straight, "waits", lambda state: False),
    "I-38: one draw moves the whole": replaced(Rules, "ways", one_for_all),
    "I-24: a law without a spin stops it": replaced(
        Rules, "with_own_spin", lambda self, motion, seen: motion + _still
    ),
    "I-24: a given spin is not kept": replaced(
        Turning, "spun", lambda self, process, spin: replace(process, spin=spin)
    ),
    "I-24: spins add up in a whole": replaced(draws, "changed", summed_spins),
    "Diffuse: turns by the angle of one turn": replaced(draws, "cosine", one_turn),
    "Diffuse: any kick": replaced(draws, "least_kick", lambda square: Fraction(4)),
    "Lot: drawn at the start": replaced(Rules, "initial", from_the_start),
    "Lot: bonds by name": replaced(Rules, "in_order", by_name),
    "Lot: leaves as they are declared": replaced(Rules, "place_of", leaves_alone),
    "Lot: the last bond first": replaced(
        Rules, "in_order", lambda self, process, lots: _in_order(self, process, lots)[::-1]
    ),
    "Lot: chances of both ends are added": replaced(
        Rules, "both", lambda self, chances: sum(chances, Fraction(0))
    ),
    "Lot: laws are asked before": replaced(straight, "lots_wait", lambda state: False),
    "Lot: turns begin when all lots are drawn": replaced(
        turning, "waits", lambda state: _waits(state) or lots_wait(state)
    ),
    "Lot: one process after the other": replaced(Rules, "drawings_of_lots", process_by_process),
    "Lot: one process releases after the other": replaced(
        Rules, "to_release", lambda self, state, waiting: _to_release(self, state, waiting[:1])
    ),
    "Lot: nobody chooses before": replaced(Rules, "to_choose", lambda self, state, waiting: []),
    "Lot: the first of them is first": replaced(Rules, "together", lambda self, lots: lots[:1]),
    "Lot: whoever is left is first": replaced(Rules, "together", lambda self, lots: lots),
    "Lot: nothing left of the offer, and released": replaced(
        Rules, "holds", lambda self, process, lot: True
    ),
    "Lot: the others are kept": replaced(Rules, "holds", lambda self, process, lot: False),
    "Lot: what becomes releasable draws at once": replaced(Rules, "left_to_release", also_new),
    "Lot: a free choice as well": replaced(Rules, "is_free", lambda self, summand: True),
    "Lot: chance 0 offers": replaced(Rules, "offers", lambda self, summand: True),
    "Lot: equal summands count once": replaced(Rules, "end_chances", equal_ones_once),
    "Lot: rates do not compete": replaced(Rules, "end_chances", each_rate_alone),
    "Lot: who has a chance is free too": replaced(Rules, "end_chances", with_its_free_ways),
    "Lot: a free end takes the first": replaced(
        Rules, "free_ways", lambda self, *end: _free_ways(self, *end)[:1]
    ),
    "Lot: rates are chances": replaced(
        lots, "chance_of_rate", lambda rate, step, greatest=None: rate * step
    ),
    "Lot: lots set split clocks": replaced(Rules, "decided", set_anew),
    "I-39: time passes over split instants": replaced(
        Rules, "to_split_instant", lambda self, state: None
    ),
    "I-39: the instants go on from the last event": replaced(
        Rules, "since", lambda self, state, d: None if state.since is None else
        d % self.model.split_step
    ),
    "I-36: along the first normal": replaced(
        Rules, "line", lambda self, normals, one, two: normals[0]
    ),
}  # fmt: skip


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scc", required=True)
    parser.add_argument("--models", type=int, default=400)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    missed = 0
    for name, mistake in MISTAKES.items():
        if options.names and not any(part in name for part in options.names):
            continue
        undo = mistake()
        oracle = Oracle([options.scc, "oracle"])
        found = None
        kept = compare.kept()
        for i in range(len(kept) + options.models):
            seed = "random %d" % (1000000 + i - len(kept))
            text = kept[i][1] if i < len(kept) else generate.model(random.Random(seed))
            rng = random.Random("%s 1" % seed)
            try:
                if compare.walk(oracle, text, compare.Tally(), rng, 8, 1):
                    found = i
                    break
            except (AssertionError, IndexError, ZeroDivisionError, RecursionError):
                found = i
                break
        undo()
        oracle.close()
        missed += found is None
        print("%s: %s" % (name, "missed" if found is None else "model %d" % found), flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
