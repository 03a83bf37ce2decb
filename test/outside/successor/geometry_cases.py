"""The cases of the conformance suite that ask about geometry, answered by the modules here."""

from __future__ import annotations

import json
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Tuple

import cast
import contact
import impact
import near
import response
from model import rotation
from motion import Flight, Undecided
from solids import Solid
from vectors import IDENTITY, ZERO, Vector, add, apply, primitive, scale, sub


def vector(told: Any) -> Vector:
    return tuple(number(x) for x in told)  # type: ignore[return-value]


def number(told: Any) -> Fraction:
    return Fraction(told["exact"] if isinstance(told, dict) else told)


def solid(params: dict) -> Solid:
    names = params.get("names", {})
    points = [vector(p) for p in params["vertices"]]
    vertices = names.get("vertices") or ["v%d" % i for i in range(len(points))]
    faces = names.get("faces") or ["f%d" % i for i in range(len(params["faces"]))]

    def corner(told: Any) -> str:
        return vertices[told] if isinstance(told, int) else told

    found = Solid(
        list(zip(vertices, points)),
        [(f, tuple(corner(i) for i in face)) for f, face in zip(faces, params["faces"])],
    )
    linear = IDENTITY
    if "linear" in params:
        linear = tuple(vector(row) for row in params["linear"])  # type: ignore[assignment]
    if "quaternion" in params:
        linear = rotation([Fraction(x) for x in params["quaternion"]])
    return found.mapped(linear)


def turned(params: dict, which: str) -> Any:
    q = params.get("turned_" + which)
    return rotation([Fraction(x) for x in q]) if q else IDENTITY


def straight_cast(params: dict, a: Solid, b: Solid) -> dict:
    offset, velocity = vector(params["offset"]), vector(params["velocity"])
    if contact.relation(a, b, offset) == "interpenetrating":
        return {"outcome": "inside", "time": None}
    t = contact.first_time_of_contact(a, b, offset, velocity)
    return {"outcome": "never", "time": None} if t is None else {"outcome": "at", "time": t}


def rigid_cast(params: dict, a: Solid, b: Solid) -> dict:
    movers = []
    offset = vector(params["offset"])
    for which, body, at in (("a", a, ZERO), ("b", b, offset)):
        turn = turned(params, which)
        _, centroid = body.volume_and_centroid()
        begun = body.mapped(turn)
        arm = scale(-1, apply(turn, centroid))
        if "arm_" + which in params:
            arm = vector(params["arm_" + which])
        begun = begun.mapped(IDENTITY, arm)
        spin = vector(params.get("spin_" + which, (0, 0, 0)))
        since = Fraction(params.get("since_" + which, 0))
        now, _ = Flight(ZERO, ZERO, spin, since).at(Fraction(0))
        centre = sub(at, apply(now, arm))
        velocity = vector(params["velocity"]) if which == "b" else ZERO
        movers.append(cast.Mover(begun, Flight(centre, velocity, spin, since)))
    if "grid" in params:
        grid = params["grid"]
    else:
        grid = cast.grid(movers[0], movers[1], Fraction(params["resolution"]))
    if cast.interiors_meet(movers[0].placed(Fraction(0)), movers[1].placed(Fraction(0))):
        return {"outcome": "inside", "time": None, "grid": grid}
    t = cast.Casting(*movers).first(Fraction(params["span"]), grid)
    outcome = "never" if t is None else "at"
    return {"outcome": outcome, "time": t, "grid": grid}


def named_pairs(a: Solid, b: Solid, pairs: Any) -> List[Tuple[str, str, int]]:
    return sorted((a.text(f), b.text(g), d) for f, g, d in pairs)


def contact_answer(params: dict, a: Solid, b: Solid) -> Optional[dict]:
    offset = vector(params["offset"])
    if "resolution" in params:
        a = a.mapped(turned(params, "a"))
        b = b.mapped(turned(params, "b"), offset)
        if contact.relation(a, b, ZERO) == "interpenetrating":
            return {"relation": "interpenetrating"}
        found = near.find(a, b, Fraction(params["resolution"]))
        if found is None:
            return {"relation": "apart"}
        answer: dict = {
            "relation": "touching" if found.gap == ZERO else "near",
            "gap": found.gap,
            "plane": found.plane,
        }
    else:
        relation = contact.relation(a, b, offset)
        if relation != "touching":
            return {"relation": relation}
        b = b.mapped(IDENTITY, offset)
        found = near.touching(a, b)
        answer = {"relation": relation}
        if "velocity" in params:
            answer["approaching"] = contact.approaching(a, b, ZERO, vector(params["velocity"]))
    answer["region"] = sorted(found.region)
    answer["normals"] = sorted(primitive(n) for n in found.normals)
    answer["pairs"] = named_pairs(a, b, found.pairs)
    return answer


def response_answer(params: dict, shapes: Dict[str, Solid]) -> Optional[dict]:
    rigid = "resolution" in params
    contacts, solids, touching = [], [], []
    for pair in params["touching"]:
        a, b = shapes[pair["a"]], shapes[pair["b"]]
        offset = vector(pair["offset"])
        if rigid:
            at = vector(pair["at"])
            a = a.mapped(turned(pair, "a"), at)
            b = b.mapped(turned(pair, "b"), add(at, offset))
            found = near.find(a, b, Fraction(params["resolution"]))
            if found is None:
                return None
            contacts.append(found)
            solids.append((a, b))
        else:
            touching.append((a, b, offset))
    if rigid:
        bodies = []
        for told in (params["first"], params["second"]):
            if told.get("fixed"):
                bodies.append(impact.Rigid(None, ZERO, None, ZERO, ZERO))
            else:
                bodies.append(
                    impact.Rigid(
                        Fraction(told["mass"]),
                        vector(told["centre"]),
                        tuple(vector(row) for row in told["inertia"]),  # type: ignore[arg-type]
                        vector(told["velocity"]),
                        vector(told["spin"]),
                    )
                )
        after = impact.bounce(contacts, solids, *bodies)
        if after is None:
            return {"outcome": "persistent"}
        return {
            "outcome": "bounced",
            "first": {"velocity": after[0].velocity, "spin": after[0].spin},
            "second": {"velocity": after[1].velocity, "spin": after[1].spin},
        }
    sides = [params["first"], params["second"]]
    v = [ZERO if s.get("fixed") else vector(s["velocity"]) for s in sides]
    w = sub(v[1], v[0])
    tight = [contact.tight(*t) for t in touching]
    approaching = [contact.approaching(*t, w) for t in touching]
    if not any(approaching):
        return {"outcome": "persistent"}
    change = sub(response.reflect(response.directions(tight, approaching), w), w)
    if sides[0].get("fixed"):
        shares = (Fraction(0), Fraction(1))
    elif sides[1].get("fixed"):
        shares = (Fraction(1), Fraction(0))
    else:
        m1, m2 = Fraction(sides[0]["mass"]), Fraction(sides[1]["mass"])
        shares = (m2 / (m1 + m2), m1 / (m1 + m2))
    return {
        "outcome": "bounced",
        "first": {"velocity": sub(v[0], scale(shares[0], change))},
        "second": {"velocity": add(v[1], scale(shares[1], change))},
    }


def agrees(expected: Any, own: Any) -> bool:
    """Whether what is expected fits, in the members that are given here."""
    if isinstance(expected, dict) and "exact" in expected:
        return own is not None and Fraction(expected["exact"]) == own
    if isinstance(expected, dict) and "set" in expected:
        items = expected["set"]
        return len(items) == len(own) and all(any(agrees(e, o) for o in own) for e in items)
    if isinstance(expected, dict) and "first" in expected and isinstance(own, tuple):
        names = expected["first"]["name"], expected["second"]["name"]
        return (*names, expected["dimension"]) == own
    if isinstance(expected, dict) and "height" in expected:
        return agrees(expected["normal"], own[0]) and agrees(expected["height"], own[1])
    if isinstance(expected, dict):
        return all(agrees(e, own[k]) for k, e in expected.items() if k in own)
    if isinstance(expected, list):
        return len(expected) == len(own) and all(agrees(e, o) for e, o in zip(expected, own))
    return expected == own


def run(folder: Path, parts: List[str]) -> Iterator[Tuple[str, Optional[str]]]:
    """Each case, with a difference or None; only of some files, if parts of names are given."""
    for path in sorted(folder.glob("geometry/*.json")) + sorted(folder.glob("rules/*/cases.json")):
        if parts and not any(part in str(path) for part in parts):
            continue
        document = json.loads(path.read_text())
        shapes = {}
        for name, given in document.get("given", {}).items():
            if given["method"] == "shape.define":
                shapes["@" + name] = solid(given["params"])
        for case in document["cases"]:
            params, own = case["params"], None
            if "error" in case["expect"]:
                continue
            try:
                if case["method"] == "first_time_of_contact":
                    a, b = shapes[params["a"]], shapes[params["b"]]
                    own = (rigid_cast if "span" in params else straight_cast)(params, a, b)
                elif case["method"] == "contact":
                    own = contact_answer(params, shapes[params["a"]], shapes[params["b"]])
                elif case["method"] == "response":
                    own = response_answer(params, shapes)
                else:
                    continue
            except Undecided as error:
                yield case["id"], "undecided: %s" % error
                continue
            if own is None or not agrees(case["expect"]["result"], own):
                yield case["id"], "here %s\nexpected %s" % (own, json.dumps(case["expect"]))
            else:
                yield case["id"], None


if __name__ == "__main__":
    here = Path(__file__).resolve().parent
    parts = sys.argv[1:]
    count = wrong = 0
    for name, difference in run(here / "../../../specs/conformance", parts):
        count += 1
        if difference:
            wrong += 1
            print(name, difference[:3000], flush=True)
    print("%d cases, %d differences" % (count, wrong))
    sys.exit(1 if wrong else 0)
