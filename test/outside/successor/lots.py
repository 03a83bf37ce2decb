"""Weak splits that are left to chance (rule Lot, reading I-39)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product
from typing import Any, Dict, FrozenSet, Iterator, List, Optional, Tuple

import terms
from model import Undefined
from rates import chance_of_rate
from states import FIRST, RELEASE, UNDECIDED, Bond, End, Lot, Process, State

Drawn = Dict[FrozenSet[Tuple[str, terms.Term]], Fraction]  # what the ends of a bond come to


class Lots:
    """Rule Lot, of the rules of a model."""

    model: Any

    # What ends offer.

    def matching(self, process: Process, name: str, end: End) -> List[terms.Term]:
        """The summands that let go of the end of a bond; of those without a chance equal ones are
        one (Successors)."""
        leaf, site = end
        found: List[terms.Term] = []
        for s in self.summands(leaf, process.bodies[leaf]):  # type: ignore[attr-defined]
            fits = s[0] == "weak" and s[1] == name and site in s[2] and self.offers(s)
            if fits and (s[3] is not None or s not in found):
                found.append(s)
        return found

    def offers(self, summand: terms.Term) -> bool:
        return summand[3] is None or summand[3][1] != 0

    def free_ways(self, process: Process, name: str, end: End) -> List[terms.Term]:
        """Those of them without a chance."""
        return [s for s in self.matching(process, name, end) if self.is_free(s)]  # type: ignore

    def end_chances(
        self, process: Process, name: str, end: End
    ) -> Optional[Dict[terms.Term, Fraction]]:
        """By which summands an end lets go, with their chances; None if it is free."""
        odds = [(s, *s[3]) for s in self.matching(process, name, end) if s[3] is not None]
        rate = sum((value for _, word, value in odds if word == "rate"), Fraction(0))
        within = chance_of_rate(rate, self.model.split_step, greatest=None)
        found: Dict[terms.Term, Fraction] = {}
        for s, word, value in odds:
            q = value if word == "chance" else within * value / rate
            found[s] = found.get(s, Fraction(0)) + q
        return found or None

    def applies(self, process: Process, bond: Bond) -> bool:
        """Whether lots are drawn for a bond."""
        name, ends = bond
        return all(self.matching(process, name, end) for end in ends) and any(
            self.end_chances(process, name, end) for end in ends
        )

    def left_to_chance(self, process: Process) -> bool:
        return any(self.applies(process, bond) for bond in process.bonds)

    # When lots are drawn.

    def to_split_instant(self, state: State) -> Optional[Fraction]:
        """Until the next split instant of the network; None if no lot would be drawn there."""
        if state.since is None or not any(map(self.left_to_chance, state.processes)):
            return None
        return self.model.split_step - state.since

    def since(self, state: State, d: Fraction) -> Optional[Fraction]:
        """The time since the last split instant, when time has passed."""
        return None if state.since is None else (state.since + d) % self.model.split_step

    def pending(self, state: State) -> State:
        """As soon as time has passed: at a split instant lots are pending."""
        if state.since != 0:
            return state
        processes = []
        for p in state.processes:
            lots = frozenset(Lot(bond) for bond in p.bonds if self.applies(p, bond))
            processes.append(replace(p, lots=lots))
        return replace(state, processes=tuple(processes))

    # Who is first.

    def goes_first(self, process: Process) -> Any:
        """By which processes are compared: by their velocities, then as in Draw."""
        return process.velocity, self.place(process)  # type: ignore[attr-defined]

    def place_of(self, process: Process, end: End) -> Any:
        """By which ends are compared: by their leaves as in Draw, then by their features."""
        name, (part, feature) = end
        body, leaf = process.bodies[name], self.leaf(name)  # type: ignore[attr-defined]
        parts = [p.name for p in leaf.parts]
        features = list(leaf.by_name[part].solid.features())
        own = (parts.index(part), features.index(feature))
        return self.place_of_leaf(name, body), own  # type: ignore[attr-defined]

    def in_order(self, process: Process, lots: Any) -> List[Lot]:
        def ends(lot: Lot) -> Any:
            return sorted(self.place_of(process, end) for end in lot.bond[1])

        return sorted(lots, key=ends)

    # What comes next.

    def drawings_of_lots(self, state: State) -> List[Tuple[Any, State]]:
        """The first that is left to do in the network: to draw, to be first, to choose, to release;
        none if no lots are pending."""
        waiting = sorted((p for p in state.processes if p.lots), key=self.goes_first)
        if not waiting:
            return []
        return (
            self.to_draw_lots(state, waiting)
            or self.to_be_first(state, waiting)
            or self.to_choose(state, waiting)
            or self.to_release(state, waiting)
        )

    def to_draw_lots(self, state: State, waiting: List[Process]) -> List[Tuple[Any, State]]:
        for process in waiting:
            for lot in self.in_order(process, process.lots):
                if lot.decided == UNDECIDED:
                    return list(self.decisions(state, process, lot))
        return []

    def to_be_first(self, state: State, waiting: List[Process]) -> List[Tuple[Any, State]]:
        for process in waiting:
            for lots in self.clusters_of(process):
                if len(lots) > 1 and not any(lot.decided == FIRST for lot in lots):
                    share = Fraction(1, len(lots))
                    return [
                        (self.lot_label(lot, FIRST, share),
                         self.decided(state, process, lot, FIRST, lot.by))
                        for lot in lots
                    ]  # fmt: skip
        return []

    def to_choose(self, state: State, waiting: List[Process]) -> List[Tuple[Any, State]]:
        several = [
            (process, lot)
            for process in waiting
            for lot in self.released_now(process)
            if len(self.ways_to_go(process, lot)) > 1
        ]
        if len(several) < 2:
            return []
        process, lot = several[0]
        return [
            (("lot", "choose", *lot.bond, None),
             self.decided(state, process, lot, lot.decided, frozenset(way.items())))
            for way in self.ways_to_go(process, lot)
        ]  # fmt: skip

    def to_release(self, state: State, waiting: List[Process]) -> List[Tuple[Any, State]]:
        """All that are released now, at once: one transition for each way."""
        now = [self.released_now(process) for process in waiting]
        ways = [
            [self.ways_to_go(process, lot) for lot in lots]
            for process, lots in zip(waiting, now)
        ]  # fmt: skip
        found = []
        for chosen in product(*(product(*of_process) for of_process in ways)):
            released, pieces = {}, []
            for process, lots, taken in zip(waiting, now, chosen):
                summands = {leaf: s for way in taken for leaf, s in way.items()}
                bonds = [lot.bond for lot in lots]
                pushes, new = self.outcome(process, bonds, summands)  # type: ignore
                released.update(pushes)
                others = process.lots - set(lots)
                for piece in self.fall_apart(process, pushes, new):  # type: ignore
                    left = self.left_to_release(piece, others)
                    pieces.append(replace(piece, lots=left))
            told = [(*bond, push or None) for bond, push in released.items()]
            label = ("weak", *told[0]) if len(told) == 1 else ("weaks", frozenset(told))
            found.append((label, state.having(waiting, pieces)))
        return found

    def clusters_of(self, process: Process) -> List[List[Lot]]:
        """Bonds that are to be released, with those that they hang together with."""
        found, left = [], self.in_order(process, process.lots)
        while left:
            found.append(self.together(left))
            left = [lot for lot in left if lot not in found[-1]]
        return found

    def released_now(self, process: Process) -> List[Lot]:
        """Of those that hang together the only one, or the first."""
        clusters = self.clusters_of(process)
        return [next((lot for lot in lots if lot.decided == FIRST), lots[0]) for lots in clusters]

    def ways_to_go(self, process: Process, lot: Lot) -> List[Dict[str, terms.Term]]:
        """By which summands its ends may let go. Of those with the same push and continuation the
        one that is written first tells the way."""
        name, ends = lot.bond
        drawn = dict(lot.by)
        choices = []
        for end in ends:
            if end[0] in drawn:
                choices.append([(end[0], drawn[end[0]])])
                continue
            found: Dict[Any, terms.Term] = {}
            for s in self.free_ways(process, name, end):
                found.setdefault(s[-2:], s)
            choices.append([(end[0], s) for s in found.values()])
        return [dict(way) for way in product(*choices)]

    # What is drawn.

    def lot_label(self, lot: Lot, decision: str, chance: Fraction) -> Any:
        return ("lot", decision, *lot.bond, chance)

    def decisions(self, state: State, process: Process, lot: Lot) -> Iterator[Tuple[Any, State]]:
        """To draw."""
        ways = self.ways_out(process, lot.bond)
        for by, chance in ways.items():
            label = self.lot_label(lot, RELEASE, chance)
            yield label, self.decided(state, process, lot, RELEASE, by)
        kept = 1 - sum(ways.values(), Fraction(0))
        if kept:
            after = replace(process, lots=process.lots - {lot})
            yield self.lot_label(lot, "keep", kept), state.having([process], [after])

    def ways_out(self, process: Process, bond: Bond) -> Drawn:
        """By what both ends of a bond let go, with the probabilities."""
        name, ends = bond
        drawn = []
        for end in ends:
            chances = self.end_chances(process, name, end)
            if chances is None:
                continue
            if sum(chances.values()) > 1:
                raise Undefined
            drawn.append([((end[0], s), q) for s, q in chances.items()])
        return {
            frozenset(way for way, _ in ways): self.both([q for _, q in ways])
            for ways in product(*drawn)
        }

    def both(self, chances: List[Fraction]) -> Fraction:
        """The probability that independent ends let go."""
        found = Fraction(1)
        for q in chances:
            found *= q
        return found

    def decided(
        self, state: State, process: Process, lot: Lot, decision: str, by: Any
    ) -> State:
        lots = process.lots - {lot} | {Lot(lot.bond, decision, by)}
        return state.having([process], [replace(process, lots=lots)])

    def together(self, lots: List[Lot]) -> List[Lot]:
        """The first of some, with all that hang together with it by leaves."""
        found, left = lots[:1], lots[1:]
        grown = True
        while grown:
            leaves = {leaf for lot in found for leaf, _ in lot.bond[1]}
            more = [lot for lot in left if any(leaf in leaves for leaf, _ in lot.bond[1])]
            left = [lot for lot in left if lot not in more]
            found, grown = found + more, bool(more)
        return found

    # After a release.

    def left_to_release(self, piece: Process, others: Any) -> FrozenSet[Lot]:
        """Those of a piece whose ends still offer what they have drawn."""
        return frozenset(lot for lot in others if lot.bond in piece.bonds and self.holds(piece, lot))

    def holds(self, process: Process, lot: Lot) -> bool:
        name, ends = lot.bond
        drawn = dict(lot.by)
        return all(
            drawn[end[0]] in self.matching(process, name, end)
            if end[0] in drawn
            else bool(self.free_ways(process, name, end))
            for end in ends
        )


def lots_wait(state: State) -> bool:
    """Whether lots are pending."""
    return any(p.lots for p in state.processes)
