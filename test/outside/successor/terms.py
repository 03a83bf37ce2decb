"""Behaviours (chapter 2 of the rule book), as terms with features of the leaf's own shape.

    ("nil",)
    ("open", barred, name, sites, then)           <a,{..}>. then
    ("weak", name, sites, odds, push, then)       omega(a,{..}) push(j) chance q. then, with the odds
                                                  ("chance", q) or ("rate", r), or None: free
    ("strong", {(name, sites), ..}, push, then)   rho({..}) push(j). then
    ("wait", t, then)                             eps(t). then, t > 0
    ("sum", (term, ...))                          of at least two, none of them a sum
    ("name", K)

``sites`` is the active surface, a frozenset of (part, feature): channels are equal when their names
and active surfaces are (I-17, I-34). A push of 0 is none (I-36). A ``Lookup`` gives the bodies
of names.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Callable, Iterator, List, Optional, Tuple

Term = Tuple[Any, ...]
NIL: Term = ("nil",)

Lookup = Callable[[str], Term]


def total(terms: List[Term]) -> Term:
    """A sum in its flat form."""
    flat: List[Term] = []
    for term in terms:
        flat += term[1] if term[0] == "sum" else (term,)
    return flat[0] if len(flat) == 1 else ("sum", tuple(flat))


def wait(t: Fraction, then: Term) -> Term:
    """Rule Eps0: eps(0). B is B."""
    return then if t == 0 else ("wait", t, then)


def summands(term: Term, lookup: Lookup) -> Iterator[Term]:
    """What a behaviour may do: its prefixes, one for each way to choose it (Sum, Def)."""
    if term[0] == "sum":
        for inner in term[1]:
            yield from summands(inner, lookup)
    elif term[0] == "name":
        yield from summands(lookup(term[1]), lookup)
    elif term[0] in ("open", "weak", "strong"):
        yield term


def horizon(term: Term, lookup: Lookup) -> Optional[Fraction]:
    """The least time left in an exposed eps, None if there is none."""
    if term[0] == "wait":
        return term[1]
    if term[0] == "name":
        return horizon(lookup(term[1]), lookup)
    if term[0] == "sum":
        found = [h for h in (horizon(t, lookup) for t in term[1]) if h is not None]
        return min(found) if found else None
    return None


def grown(term: Term, d: Fraction, lookup: Lookup) -> Term:
    """Rule TimeBehaviour: what a behaviour becomes in the time d > 0, as it stands."""
    if term[0] == "wait":
        if d <= term[1]:
            return wait(term[1] - d, term[2])
        return grown(term[2], d - term[1], lookup)
    if term[0] == "name":
        body = lookup(term[1])
        return term if horizon(body, lookup) is None else grown(body, d, lookup)
    if term[0] == "sum":
        return total([grown(t, d, lookup) for t in term[1]])
    return term


def aged(
    term: Term, origin: Optional[str], d: Fraction, lookup: Lookup
) -> Tuple[Term, Optional[str]]:
    """What a behaviour and its origin become in the time d > 0 (TimeBehaviour, I-14 and I-17).

    A name that the whole behaviour becomes is the new origin; one that is left of a sum is not.
    """
    after = grown(term, d, lookup)
    if after == term:
        return term, origin
    if after[0] == "name":
        return after, after[1]
    return without_repetition(after, lookup), origin


def left_to_chance(term: Term, lookup: Lookup, seen: Tuple[str, ...] = ()) -> bool:
    """Whether it offers something by chance, or will when time has passed."""
    if term[0] == "weak":
        return term[3] is not None
    if term[0] == "wait":
        return left_to_chance(term[2], lookup, seen)
    if term[0] == "name":
        return term[1] not in seen and left_to_chance(lookup(term[1]), lookup, (*seen, term[1]))
    return term[0] == "sum" and any(left_to_chance(t, lookup, seen) for t in term[1])


def without_repetition(term: Term, lookup: Lookup) -> Term:
    """Reading I-17: a sum that time has changed, without nil and without repetition; a single
    summand that goes on ageing is kept a summand, beside nil. Chances add (Lot)."""
    if term[0] != "sum":
        return term
    kept: List[Term] = []
    for inner in term[1]:
        if inner != NIL and (inner not in kept or left_to_chance(inner, lookup)):
            kept.append(inner)
    if len(kept) == 1 and horizon(kept[0], lookup) is not None:
        kept.append(NIL)
    return total(kept) if kept else NIL


def origin_of(term: Term) -> Optional[str]:
    """The origin of a behaviour that a transition has led to."""
    return term[1] if term[0] == "name" else None
