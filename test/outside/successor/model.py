"""A model: its leaves, shapes, behaviours, laws and settings, and its declared processes."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import Any, Dict, List, Optional, Tuple

import terms
from rates import chance_of_rate
from solids import Feature, Solid
from syntax import Refused, read, read_behaviour
from vectors import IDENTITY, ZERO, Matrix, Vector, add, apply, cross, dot, multiply, scale

Site = Tuple[Optional[str], Feature]  # the part (None: the leaf is one solid), and its feature


class Undefined(Exception):
    """An expression has no value: a division by zero."""


class Part:
    """A solid of a leaf, in the leaf's own space or, turned and scaled, about its reference."""

    def __init__(self, name: Optional[str], solid: Solid, mass: Optional[Fraction], **motion: Any):
        self.name, self.solid, self.mass, self.motion = name, solid, mass, motion


class Leaf:
    """A basic or compound shape of the network, with all that never changes of it."""

    def __init__(self, name: str, parts: List[Part], fixed: bool) -> None:
        self.name, self.parts, self.fixed = name, parts, fixed
        self.by_name = {part.name: part for part in parts}
        self.absorbs = False
        self.law: Optional[Any] = None  # an expression of a vector, or what gives several
        shares = []
        for part in parts:
            volume, centroid = part.solid.volume_and_centroid()
            shares.append((volume if fixed else part.mass, centroid))
        whole = sum(share for share, _ in shares)
        centre = ZERO
        for share, centroid in shares:
            centre = add(centre, scale(Fraction(share) / whole, centroid))
        self.centroid = centre  # from the reference point
        self.inside = shares[0][1]  # the centroid of the first part
        self.mass = None if fixed else whole

    def active(self, alone: frozenset, sites: frozenset) -> frozenset:
        """The active surface of a channel (Definitions 4.2 and 5.1): of some features alone
        (I-34), and of others with their closure."""
        found = set(alone)
        for part in {part for part, _ in sites}:
            solid = self.by_name[part].solid
            own = frozenset(feature for p, feature in sites if p == part)
            found |= {(part, feature) for feature in solid.closure(own)}
        return frozenset(found)

    def text(self, site: Site) -> str:
        part, feature = site
        inner = self.by_name[part].solid.text(feature)
        return ".".join([self.name] + ([part] if part else []) + [inner])


class Model:
    """What ``read`` has read, worked out."""

    def __init__(self, text: str) -> None:
        self.values: Dict[str, Any] = {}
        self.shapes: Dict[str, List[Part]] = {}
        self.behaviours: Dict[str, Any] = {}
        self.leaves: Dict[str, Leaf] = {}
        self.declared: Dict[str, dict] = {}  # by process
        self.bonds: List[Any] = []
        self.network: Optional[List[str]] = None
        self.motions: List[Tuple[Optional[str], Any, dict]] = []
        self.settings: Dict[str, Any] = {}
        self.rounding: Dict[str, Fraction] = {}
        self.local, self.steady = False, False
        self._bodies: Dict[Tuple[str, str], terms.Term] = {}
        items = read(text)
        for item in items:
            if item[0] == "behaviour":
                self.behaviours[item[1]] = item[2]
        self._declare(items, {})
        self._assemble()

    # Expressions.

    def number(self, expr: Any, env: dict) -> Any:
        """The value of an expression: a number, or a truth value."""
        kind = expr[0]
        if kind == "number":
            return expr[1]
        if kind in ("true", "false"):
            return kind == "true"
        if kind == "name":
            if expr[1] in env:
                return env[expr[1]]
            if expr[1] in self.values:
                value = self.values[expr[1]]
                return self.number(value[1], {**env, **value[2]}) if is_let(value) else value
            if expr[1] in env.get("", {}):
                return env[""][expr[1]]
            raise Refused("no such name: %s" % expr[1])
        if kind == "if":
            return self.number(expr[2] if self.number(expr[1], env) else expr[3], env)
        if kind == "and":
            return self.number(expr[1], env) and self.number(expr[2], env)
        if kind == "or":
            return self.number(expr[1], env) or self.number(expr[2], env)
        if kind == "not":
            return not self.number(expr[1], env)
        if kind == "negate":
            return times(-1, self.number(expr[1], env))
        if kind == "vector":
            return tuple(self.number(e, env) for e in expr[1])
        if kind == "component":
            return self.number(expr[1], env)["xyz".index(expr[2])]
        if kind == "call" and expr[1] == "round":
            value, step = (self.number(e, env) for e in expr[2])
            return nearest(value, step)
        if kind == "call" and expr[1] in FUNCTIONS:
            return FUNCTIONS[expr[1]](*(self.number(e, env) for e in expr[2]))
        if kind in OPERATORS:
            left, right = self.number(expr[1], env), self.number(expr[2], env)
            if kind == "/" and right == 0:
                raise Undefined
            return OPERATORS[kind](left, right)
        raise Refused("cannot work out %s" % kind)

    def vector(self, exprs: Any, env: dict) -> Vector:
        return tuple(Fraction(self.number(e, env)) for e in exprs)  # type: ignore

    # Declarations.

    def _declare(self, items: List[Any], env: dict) -> None:
        for item in items:
            word = item[0]
            if word == "param":
                self.values[item[1]] = self.number(item[2], env)
            elif word == "let":
                self.values[item[1]] = ("let", item[2], dict(env))
            elif word in ("timestep", "split_step", "resolution"):
                self.settings[word] = self.number(item[1], env)
                self.local = self.local or "local" in item[2:]
                self.steady = self.steady or "steady" in item[2:]
            elif word in ("dynamics", "collisions", "binding", "bonds", "blocked"):
                self.settings[word] = item[1]
            elif word == "round":
                self.rounding[item[1]] = self.number(item[2], env)
            elif word == "shape":
                self.shapes[item[1]] = self._template(item[2], env)
            elif word == "compound":
                self.shapes[item[1]] = [
                    self._part(name, solid, attributes, env) for name, solid, attributes in item[2]
                ]
            elif word in ("process", "fixed"):
                self._process(word, item[1], item[2], env)
            elif word == "bond":
                self.bonds.append((item[1], env))
            elif word == "network":
                self.network = [self.path_text(p, env) for p in item[1]]
            elif word == "motion":
                target = None if item[1] is None else self.path_text(item[1], env)
                self.motions.append((target, item[2], env))
            elif word == "for":
                self._loop(item[1], item[2], env)

    def _loop(self, ranges: List[Any], body: List[Any], env: dict) -> None:
        if not ranges:
            return self._declare(body, env)
        name, low, high = ranges[0]
        for i in range(int(self.number(low, env)), int(self.number(high, env)) + 1):
            self._loop(ranges[1:], body, {**env, name: Fraction(i)})

    def _template(self, solid: Any, env: dict) -> List[Part]:
        if solid[0] == "template":
            vertices = [(v, self.vector(p, env)) for v, p in solid[1]]
            return [Part(None, Solid(vertices, solid[2]), None)]
        if solid[0] == "shape":
            return self.shapes[solid[1]]
        factors = self.vector(solid[2], env)
        linear = diagonal(factors)
        return [
            Part(p.name, p.solid.mapped(linear), p.mass, **p.motion)
            for p in self._template(solid[1], env)
        ]

    def _part(self, name: str, solid: Any, attributes: dict, env: dict) -> Part:
        linear, offset = self._place(attributes.get("at"), env)
        template = self._template(solid, env)[0]
        return Part(
            name,
            template.solid.mapped(linear, offset),
            self.number(attributes["mass"], env) if "mass" in attributes else None,
            velocity=self.vector(attributes["velocity"], env) if "velocity" in attributes else ZERO,
            spin=self.vector(attributes["spin"], env) if "spin" in attributes else ZERO,
        )

    def _place(self, transforms: Optional[list], env: dict) -> Tuple[Matrix, Vector]:
        linear, offset = IDENTITY, ZERO
        for word, value in reversed(transforms or []):
            if word == "translate":
                step, move = IDENTITY, self.vector(value, env)
            elif word == "scale":
                step, move = diagonal(self.vector(value, env)), ZERO
            elif word == "rotate":
                step = rotation([Fraction(self.number(e, env)) for e in value])
                move = ZERO
            else:
                rows = [[Fraction(self.number(e, env)) for e in row] for row in value]
                step = tuple(tuple(row[:3]) for row in rows[:3])  # type: ignore
                move = tuple(row[3] for row in rows[:3])  # type: ignore
            linear, offset = multiply(step, linear), add(apply(step, offset), move)
        return linear, offset

    def _process(self, word: str, name: Any, chain: Any, env: dict) -> None:
        process = self.segment_text(name, env)
        leaves = []
        for declared in chain[0]:
            label = process if declared["label"] is None else None
            leaf_name = label or self.segment_text(declared["label"], env)
            linear, offset = self._place(declared.get("at"), env)
            template = self._template(declared["solid"], env)
            parts = [Part(p.name, p.solid.mapped(linear), p.mass, **p.motion) for p in template]
            if parts[0].name is None:
                mass = self.number(declared["mass"], env) if "mass" in declared else None
                parts[0].mass = None if mass is None else Fraction(mass)
            leaf = Leaf(leaf_name, parts, word == "fixed")
            leaf.absorbs = "absorb" in declared
            self.leaves[leaf_name] = leaf
            moves = parts[0].motion if parts[0].motion else {"velocity": ZERO, "spin": ZERO}
            velocity = declared.get("velocity")
            spin = declared.get("spin")
            leaves.append(
                {
                    "name": leaf_name,
                    "position": offset,
                    "velocity": moves["velocity"]
                    if velocity is None
                    else self.vector(velocity, env),
                    "spin": moves["spin"] if spin is None else self.vector(spin, env),
                    "behaviour": declared["behaviour"] or ("nil",),
                    "env": env,
                }
            )
        family = name[0] if name[1] is not None else None
        self.declared[process] = {
            "leaves": leaves, "bonds": [(b, env) for b in chain[1]], "family": family,
        }  # fmt: skip

    # Names.

    def segment_text(self, segment: Any, env: dict) -> str:
        name, indices = segment
        if indices is None:
            return name
        return "%s[%s]" % (name, ",".join(str(self.number(i, env)) for i in indices))

    def path_text(self, path: Any, env: dict) -> str:
        return ".".join(self.segment_text(s, env) for s in path)

    def site(self, leaf: Leaf, feature: Any, env: dict) -> Site:
        """A feature of a leaf as it is written: with the leaf's name before it or without."""
        segments = [self.segment_text(s, env) for s in feature[0]]
        more = len(segments) > 1 or feature[1] is not None
        if segments and more and segments[0] == leaf.name and leaf.name not in leaf.by_name:
            segments = segments[1:]
        part: Optional[str] = None
        if feature[1] is None:
            if None not in leaf.by_name:
                part, segments = segments[0], segments[1:]
            return (part, leaf.by_name[part].solid.named(segments[0]))
        corners = []
        for path in feature[1]:
            names = [self.segment_text(s, env) for s in path]
            if len(names) > 1 and names[0] == leaf.name and leaf.name not in leaf.by_name:
                names = names[1:]
            if len(names) == 2:
                segments = names[:1]
            corners.append(names[-1])
        if None not in leaf.by_name:
            part = segments[0]
        return (part, leaf.by_name[part].solid.by_vertices(corners))

    def end(self, feature: Any, env: dict) -> Tuple[str, Site]:
        """The end of a bond: a leaf and a site of it."""
        first = feature[0][0] if feature[0] else feature[1][0][0]
        leaf = self.leaves[self.segment_text(first, env)]
        return (leaf.name, self.site(leaf, feature, env))

    # Behaviours.

    def term(self, leaf: Leaf, written: Any, env: dict) -> terms.Term:
        """A behaviour as it is written, with the features of a leaf."""
        kind = written[0]
        if kind == "nil":
            return terms.NIL
        if kind == "name":
            if written[1] not in self.behaviours:
                raise Refused("no such behaviour: %s" % written[1])
            return ("name", self.settled(written[1]))
        if kind == "sum":
            return terms.total([self.term(leaf, t, env) for t in written[1]])
        then = self.term(leaf, written[2], env)
        if kind == "wait":
            return terms.wait(Fraction(self.number(written[1], env)), then)

        def sites(channel: Any) -> frozenset:
            """Channels are equal when their names and active surfaces are (I-17, I-34)."""
            members = [(only, self.site(leaf, f, env)) for only, f in channel[2]]
            alone, others = (frozenset(s for o, s in members if o is x) for x in (True, False))
            return leaf.active(alone, others)

        if kind == "open":
            return ("open", written[1][0], written[1][1], sites(written[1]), then)
        if kind == "weak":
            push, odds = self.push(written[3], env), self.odds(written[4], env)
            return ("weak", written[1][1], sites(written[1]), odds, push, then)
        entries = frozenset((c[1], sites(c)) for c in written[1])
        return ("strong", entries, self.push(written[3], env), then)

    def settled(self, name: str) -> str:
        """Rule Eps0: the last name that an eps(0) brings up as a name unfolds outside of sums."""
        found, after_delay, rest = name, False, self.behaviours.get(name)
        while rest is not None and rest[0] in ("name", "wait"):
            if rest[0] == "wait":
                if self.number(rest[1], {}) != 0:
                    break
                after_delay, rest = True, rest[2]
            else:
                found = rest[1] if after_delay else found
                after_delay, rest = False, self.behaviours.get(rest[1])
        return found

    def push(self, written: Any, env: dict) -> Fraction:
        """Reading I-36: what a split says of the impulse that drives the pieces apart."""
        found = Fraction(self.number(written, env))
        if found < 0:
            raise Refused("a push that pulls (I-36)")
        return found

    def odds(self, written: Any, env: dict) -> Optional[Tuple[str, Fraction]]:
        """Rule Lot: the chance or the rate of a weak split; None where it is a free choice."""
        if written is None:
            return None
        word, value = written[0], Fraction(self.number(written[1], env))
        found = value if word == "chance" else chance_of_rate(value, self.split_step)
        if found is None or not 0 <= found <= 1:
            raise Refused("no probability (Lot)")
        return word, value

    def lookup(self, leaf: Leaf) -> terms.Lookup:
        def body(name: str) -> terms.Term:
            key = (leaf.name, name)
            if key not in self._bodies:
                self._bodies[key] = self.term(leaf, self.behaviours[name], {})
            return self._bodies[key]

        return body

    def read_term(self, leaf: Leaf, text: str) -> terms.Term:
        return self.term(leaf, written(text), {})

    # The network.

    def _assemble(self) -> None:
        taking = [
            p for p, d in self.declared.items()
            if self.network is None or p in self.network or d["family"] in self.network
        ]  # fmt: skip
        home = {leaf["name"]: p for p in taking for leaf in self.declared[p]["leaves"]}
        all_leaves = self.leaves
        joined = []
        for p in taking:
            joined += self.declared[p]["bonds"]
        for bond, env in self.bonds:
            ends = [self.end(f, env) for f in bond[1]]
            if all(leaf in home for leaf, _ in ends):
                joined.append((bond, env))
        self.timestep = Fraction(self.settings.get("timestep", 1))
        self.split_step = self.settings.get("split_step", self.timestep)
        self.initial_leaves = {}
        for p in taking:
            for leaf in self.declared[p]["leaves"]:
                leaf["term"] = self.term(all_leaves[leaf["name"]], leaf["behaviour"], leaf["env"])
                self.initial_leaves[leaf["name"]] = leaf
        self.initial_bonds = [
            (bond[0], frozenset(self.end(f, env) for f in bond[1])) for bond, env in joined
        ]
        self.leaves = {name: leaf for name, leaf in all_leaves.items() if name in home}
        for name, leaf in self.leaves.items():
            self._law(leaf, home[name])
        self.steered = any(leaf.law is not None for leaf in self.leaves.values())
        spins = any(leaf["spin"] != ZERO for leaf in self.initial_leaves.values())
        laws = [leaf.law[0] for leaf in self.leaves.values() if leaf.law is not None]
        spins = spins or any(map(gives_spin, laws))
        self.rigid = spins or "dynamics" in self.settings
        self.together = self.settings.get("collisions") == "together"
        self.by_contact = self.settings.get("binding") == "contact"
        self.cyclic = self.settings.get("bonds") == "cyclic"
        self.blocked = self.settings.get("blocked", "bounce")
        if self.blocked != "bounce" and (self.rigid or "velocity" in self.rounding):
            raise Refused("walkers that do not bounce in a rigid model, or rounded (Blocked)")
        if self.rigid and self.by_contact:
            raise Refused("binding contact in a rigid model (I-33)")
        behaviours = list(self.behaviours.values())
        behaviours += [leaf["behaviour"] for leaf in self.initial_leaves.values()]
        self.only = any(any(only for only, _ in c[2]) for b in behaviours for c in channels(b))
        self.pushes = any(pushes(b) for b in behaviours)
        self.lots = self._left_to_chance()
        if self.only and self.by_contact:
            raise Refused("features without their closure, and binding contact (I-34)")

    def _left_to_chance(self) -> bool:
        """Whether a behaviour that a leaf may come to leaves a split to chance (Lot)."""
        names: List[str] = []
        texts = [leaf["behaviour"] for leaf in self.initial_leaves.values()]
        while texts:
            odds, named = says_odds(texts.pop())
            if odds:
                return True
            texts += [self.behaviours[name] for name in named if name not in names]
            names += named
        return False

    def _law(self, leaf: Leaf, process: str) -> None:
        """The most special law counts."""
        family = self.declared[process]["family"]
        leaf_family = leaf.name.split("[")[0] if "[" in leaf.name else None
        best = -1
        for target, law, env in self.motions:
            ranks = [None, family, leaf_family, process, leaf.name]
            if target is None:
                rank = 0
            elif target in ranks:
                rank = max(i for i, t in enumerate(ranks) if t == target)
            else:
                continue
            if rank > best and not leaf.fixed:
                best, leaf.law = rank, None if law is None else (law, env)


def channels(written: Any) -> List[Any]:
    """All channels of a behaviour, as it is written."""
    kind = written[0]
    if kind == "sum":
        return [channel for term in written[1] for channel in channels(term)]
    if kind in ("nil", "name"):
        return []
    own = {"open": written[1:2], "weak": written[1:2], "strong": written[1], "wait": []}[kind]
    return list(own) + channels(written[2])


def pushes(written: Any) -> bool:
    """Whether a split of a behaviour, as it is written, drives apart what it releases (I-36)."""
    kind = written[0]
    if kind == "sum":
        return any(pushes(term) for term in written[1])
    if kind in ("nil", "name"):
        return False
    own = kind in ("weak", "strong") and written[3] != ("number", 0)
    return own or pushes(written[2])


def gives_spin(law: Any) -> bool:
    """Whether a law gives a spin."""
    if law[0] == "gives":
        return law[2] is not None
    return any(kick[2] is not None for kick in law[1]) if law[0] == "choose" else law[1][3] is not None


def says_odds(written: Any) -> Tuple[bool, List[str]]:
    """Whether a behaviour, as it is written, leaves a split to chance, and what it names."""
    kind = written[0]
    if kind == "name":
        return False, [written[1]]
    if kind == "nil":
        return False, []
    inner = [says_odds(term) for term in (written[1] if kind == "sum" else [written[2]])]
    odds = kind == "weak" and written[4] is not None
    return odds or any(o for o, _ in inner), [name for _, named in inner for name in named]


@lru_cache(maxsize=1000)
def written(text: str) -> Any:
    return read_behaviour(text)


def times(a: Any, b: Any) -> Any:
    """A product of numbers, or of a number and a vector."""
    if isinstance(b, tuple):
        a, b = b, a
    return scale(b, a) if isinstance(a, tuple) else a * b


def plus(a: Any, b: Any) -> Any:
    return add(a, b) if isinstance(a, tuple) else a + b


def is_let(value: Any) -> bool:
    return isinstance(value, tuple) and value[0] == "let"


def nearest(value: Fraction, step: Fraction) -> Fraction:
    """The multiple of step nearest to a value; of two, the one farther from zero."""
    if step == 0:
        raise Undefined
    size = abs(Fraction(value) / step)
    whole = (2 * size + 1) // 2
    return whole * abs(step) * (1 if value >= 0 else -1)


def diagonal(factors: Vector) -> Matrix:
    x, y, z = factors
    o = Fraction(0)
    return ((x, o, o), (o, y, o), (o, o, z))


def rotation(q: List[Fraction]) -> Matrix:
    """The matrix of a quaternion of any length."""
    w, x, y, z = q
    s = w * w + x * x + y * y + z * z
    return (
        ((w * w + x * x - y * y - z * z) / s, 2 * (x * y - w * z) / s, 2 * (x * z + w * y) / s),
        (2 * (x * y + w * z) / s, (w * w - x * x + y * y - z * z) / s, 2 * (y * z - w * x) / s),
        (2 * (x * z - w * y) / s, 2 * (y * z + w * x) / s, (w * w - x * x - y * y + z * z) / s),
    )


FUNCTIONS = {
    "min": min,
    "max": max,
    "abs": abs,
    "sign": lambda a: (a > 0) - (a < 0),
    "dot": dot,
    "cross": cross,
}

OPERATORS = {
    "+": plus,
    "-": lambda a, b: plus(a, times(-1, b)),
    "*": times,
    "/": lambda a, b: times(a, 1 / Fraction(b)),
    "=": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
}
