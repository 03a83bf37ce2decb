"""Random small models of two to five bodies, of which many touch, collide and bind.

Bodies stand on a grid of halves and have small whole velocities, so that several collide at one
instant, edges meet edges, and some rest against each other from the start.
"""

from __future__ import annotations

import random
import re
from fractions import Fraction
from functools import lru_cache
from typing import Dict, List, Optional, Set, Tuple

import contact
from model import Leaf, Model
from solids import Feature
from vectors import Vector, add, cross, sub

SOLIDS = {
    "Cube": """vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]""",
    "Prism": """vertices p (0,0,0)  q (2,0,0)  r (0,2,0)  s (0,0,2)  t (2,0,2)  u (0,2,2)
  faces    low [p,r,q]  high [s,t,u]  south [p,q,t,s]  west [p,s,u,r]  slope [q,r,u,t]""",
    "Tetra": """vertices k (0,0,0)  l (2,0,0)  m (0,2,0)  n (0,0,2)
  faces    xy [k,m,l]  xz [k,l,n]  yz [k,n,m]  far [l,m,n]""",
    "Pyramid": """vertices a (-1,-1,0)  b (1,-1,0)  c (1,1,0)  d (-1,1,0)  o (0,0,1)
  faces    base [a,d,c,b]  s1 [a,b,o]  s2 [b,c,o]  s3 [c,d,o]  s4 [d,a,o]""",
}
WALL = "shape Wall = Cube scaled (6, 1/2, 6)"
SCALES = ["1", "1", "1", "1/2", "2", "3/2"]
WEIGHTS = [
    "", "", " weight 2", " weight 3", " weight 1/2", " weight 0", " weight mass",
    " weight 1 + x*x", " weight if y > 0 then 1 else 0",
]  # fmt: skip
TURNS = ["(1,0,0,1)", "(1,1,0,0)", "(0,0,0,1)", "(1,1,1,1)", "(1,0,1,0)", "(2,0,0,1)"]


class Shape:
    """A declared shape: its text, and the names of its parts (None: it has none)."""

    def __init__(self, name: str, text: str, parts: List[Optional[str]]) -> None:
        self.name, self.text, self.parts = name, text, parts


def vector_text(v: Vector) -> str:
    return "(%s, %s, %s)" % v


def half(rng: random.Random, bound: int) -> Fraction:
    """A multiple of 1/2, mostly of 1."""
    step = 2 if rng.random() < 0.7 else 1
    return Fraction(rng.randrange(-2 * bound, 2 * bound + 1, step), 2)


def scaled(rng: random.Random) -> str:
    if rng.random() < 0.6:
        return ""
    return " scaled (%s, %s, %s)" % tuple(rng.choice(SCALES) for _ in range(3))


@lru_cache(maxsize=1000)
def leaf_of(text: str) -> Leaf:
    """The leaf t of a model, which is given the solids above that it names."""
    texts = ["shape %s {\n  %s\n}" % item for item in SOLIDS.items() if item[0] in text]
    if "Wall" in text:
        texts = ["shape Cube {\n  %s\n}" % SOLIDS["Cube"], WALL]
    return Model("\n".join(texts) + "\n" + text).leaves["t"]


class Generator:
    def __init__(self, rng: random.Random, rigid: bool = False) -> None:
        self.rng, self.rigid = rng, rigid
        self.shapes: List[Shape] = []
        self.lines: List[str] = []
        self.walls = False
        self.behaviours: Dict[str, str] = {}  # of bodies, by name
        self.absorbers: Set[str] = set()
        self.laws = rng.random() < 0.3
        self.draws = self.laws and rng.random() < 0.3  # rule Draw
        self.together = rng.random() < 0.35  # reading I-32
        self.by_contact = not rigid and rng.random() < 0.35  # reading I-33
        self.pushes = rng.random() < 0.5  # reading I-36
        self.lots = rng.random() < 0.4  # rule Lot
        self.cyclic = rng.random() < 0.35  # reading I-37
        self.spins: Dict[str, Vector] = {}  # of bodies, by name
        self.centres: Dict[str, Vector] = {}

    # Shapes.

    def basic(self, i: int) -> Shape:
        solid = self.rng.choice(["Cube", "Cube", "Cube", "Prism", "Tetra", "Pyramid"])
        name = "B%d" % i
        return Shape(name, "shape %s = %s%s" % (name, solid, scaled(self.rng)), [None])

    def compound(self, i: int) -> Optional[Shape]:
        """Two or three parts, each put against one before, glued by their highest pair."""
        rng, name = self.rng, "C%d" % i
        parts: List[Tuple[str, str, Leaf, Vector]] = []
        glues: List[str] = []
        for part in ["u", "v", "w"][: rng.choice([2, 2, 3])]:
            for _ in range(40):
                solid = rng.choice(["Cube", "Cube", "Prism", "Tetra"]) + scaled(rng)
                leaf = self.leaf_of("t = %s mass 1 [nil]" % solid)
                if not parts:
                    parts.append((part, solid, leaf, (Fraction(0), Fraction(0), Fraction(0))))
                    break
                other = rng.choice(parts)
                offset = snug(rng, other[2], leaf)
                if offset is None:
                    continue
                at = add(other[3], offset)
                if any(overlap(p[2], leaf, sub(at, p[3])) for p in parts):
                    continue
                f, g = highest(other[2], leaf, offset)
                first, second = (lf.parts[0].solid.text(x) for lf, x in ((other[2], f), (leaf, g)))
                glues.append("  glue %s.%s ~ %s.%s" % (other[0], first, part, second))
                parts.append((part, solid, leaf, at))
                break
        if len(parts) < 2:
            return None
        lines = ["compound %s {" % name]
        for part, solid, _, at in parts:
            mass = rng.choice(["1", "2", "1/2"])
            lines.append(
                "  part %s : %s mass %s at translate %s" % (part, solid, mass, vector_text(at))
            )
        lines += glues + ["}"]
        return Shape(name, "\n".join(lines), [p[0] for p in parts])

    def leaf_of(self, declaration: str) -> Leaf:
        """The leaf that a declaration of a process t makes, with the shapes so far."""
        texts = [s.text for s in self.shapes if s.name == declaration.split()[2]]
        return leaf_of("\n".join(texts) + "\nprocess " + declaration)

    # Behaviours.

    def sites(self, leaf: Leaf) -> str:
        """A list of features: often all faces, or all of a kind, or a few."""
        rng = self.rng
        everything = [
            (part, part.solid.text(f), f[0]) for part in leaf.parts for f in part.solid.features()
        ]
        faces = [x for x in everything if x[2] == "face"]
        draw = rng.random()
        if draw < 0.45:
            chosen = faces
        elif draw < 0.7:
            chosen = rng.sample(faces, rng.randint(1, len(faces)))
        elif draw < 0.85:
            kind = rng.choice(["vertex", "edge"])
            chosen = [x for x in everything if x[2] == kind]
        else:
            chosen = rng.sample(everything, rng.randint(1, 3))
        alone = not self.by_contact and rng.random() < 0.3  # reading I-34
        texts = [
            "only " * (alone and rng.random() < 0.7) + (p.name + "." if p.name else "") + t
            for p, t, _ in chosen
        ]
        return "{%s}" % ", ".join(texts)

    def term(self, leaf: Leaf, names: List[str], depth: int) -> str:
        rng = self.rng
        draw = rng.random()
        if depth <= 0 or draw < 0.12:
            return rng.choice(names + ["nil"])
        then = "(%s)" % self.behaviour(leaf, names, depth - 1)
        channel = rng.choice(["a", "a", "b"])
        if draw < 0.5:
            return "<%s%s, %s>. %s" % (rng.choice(["", "~"]), channel, self.sites(leaf), then)
        if draw < 0.66:
            return "omega(%s, %s)%s%s. %s" % (
                channel, self.sites(leaf), self.push(), self.odds(), then,
            )  # fmt: skip
        if draw < 0.84:
            entries = []
            for _ in range(rng.choice([1, 1, 1, 2])):
                name = rng.choice(["a", "a", "b"])
                entries.append("<%s, %s>" % (name, self.sites(leaf)))
            return "rho({%s})%s. %s" % (", ".join(entries), self.push(), then)
        delay = rng.choice(["1/2", "1", "1", "3/2", "2", "1/3", "0"])
        if delay == "0":
            return "eps(0). (%s)" % self.guarded(leaf, names, depth - 1)
        return "eps(%s). %s" % (delay, then)

    def push(self) -> str:
        """What a release says of the impulse that drives the pieces apart: often nothing."""
        if not self.pushes or self.rng.random() < 0.4:
            return ""
        return " push(%s)" % self.rng.choice(["1", "1", "1/2", "2", "3/2", "1/3", "0"])

    def odds(self) -> str:
        """What a weak split says of its chance (Lot): in half of the cases nothing."""
        if not self.lots or self.rng.random() < 0.5:
            return ""
        rates = ["rate 1", "rate 1/3", "rate (1/8 + 2)", "rate 0", "rate 40"]
        chances = ["1/2", "1/2", "1/3", "1/4", "2/3", "1/8", "1", "0", "(1 - 1/5)"]
        if self.rng.random() < 0.2:
            return " " + self.rng.choice(rates)
        return " chance " + self.rng.choice(chances)

    def guarded(self, leaf: Leaf, names: List[str], depth: int) -> str:
        """A term that is no name."""
        return "<%s, %s>. %s" % (
            self.rng.choice(["a", "~a", "b", "~b"]), self.sites(leaf), self.rng.choice(names),
        )  # fmt: skip

    def behaviour(self, leaf: Leaf, names: List[str], depth: int) -> str:
        count = self.rng.choice([1, 1, 2, 2, 2, 3])
        return " + ".join(self.term(leaf, names, depth) for _ in range(count))

    def opening(self, leaf: Leaf, names: List[str]) -> str:
        """A channel that is open from the start, and a way to release what it binds."""
        rng = self.rng
        sites = self.sites(leaf)
        release = rng.choice(["omega(a, %s)", "rho({<a, %s>})", "eps(1). omega(a, %s)"]) % sites
        odds = self.odds() if "omega" in release else ""
        release += "%s%s. %s" % (self.push(), odds, rng.choice(names + ["nil"]))
        if rng.random() < 0.4:
            release = "(%s)" % (release + " + " + self.term(leaf, names, 1))
        delay = "eps(%s). " % rng.choice(["1/2", "1", "2"]) if self.late(rng) else ""
        return "%s<%sa, %s>. %s" % (delay, rng.choice(["", "~"]), sites, release)

    def late(self, rng: random.Random) -> bool:
        """Whether a channel opens later, perhaps between bodies that rest against each other."""
        return self.by_contact and rng.random() < 0.3

    def definitions(self, shape: Shape, leaf: Leaf) -> List[str]:
        """Definitions for a shape, the first of which names come; guarded: no bare names."""
        rng = self.rng
        names = ["K%d%s" % (i, shape.name) for i in range(rng.choice([1, 2, 3]))]
        for name in names:
            summands = []
            for _ in range(self.rng.choice([1, 2, 2, 3])):
                for _ in range(20):
                    if rng.random() < 0.4:
                        summands.append(self.opening(leaf, names))
                        break
                    text = self.term(leaf, names, 2)
                    if text not in names and not text.startswith("eps(0)"):
                        summands.append(text)
                        break
            self.lines.append(
                "behaviour %s on %s = %s" % (name, shape.name, " + ".join(summands or ["nil"]))
            )
        return names

    # Squares.

    def linking(self, leaf: Leaf) -> str:
        """A behaviour that binds with several neighbours, and lets go of one or two."""
        rng = self.rng
        names = ["Link0", "Link1"]

        def sites() -> str:
            every = rng.random() < 0.7
            return "{left, right, top, bottom}" if every else self.sites(leaf)

        summands = []
        for _ in range(rng.choice([1, 2, 2, 3])):
            draw, name = rng.random(), rng.choice("aab")
            if draw < 0.5:
                text = "<%s%s, %s>" % (rng.choice(["", "~"]), name, sites())
            elif draw < 0.7:
                text = "omega(%s, %s)%s%s" % (name, sites(), self.push(), self.odds())
            else:
                several = ["<%s, %s>" % (n, sites()) for n in (name, rng.choice("aab"))]
                entries = ", ".join(several[: rng.choice([1, 2, 2])])
                text = "rho({%s})%s" % (entries, self.push())
            delay = "eps(%s). " % rng.choice(["1/2", "1"]) if rng.random() < 0.3 else ""
            summands.append("%s%s. %s" % (delay, text, rng.choice(names + ["nil"])))
        return " + ".join(summands)

    def square(self, placed: List[Tuple[str, Leaf, Vector, str]]) -> List[str]:
        """Four cubes far away, and three or four bonds around (I-37)."""
        rng = self.rng
        self.shapes.append(Shape("Ring", "shape Ring = Cube", [None]))
        leaf = self.leaf_of("t = Ring mass 1 [nil]")
        for i in range(2):
            self.lines.append("behaviour Link%d on Ring = %s" % (i, self.linking(leaf)))
        speed = "(%d, 0, 1)" % rng.choice([0, 0, -8])
        for i, (x, z) in enumerate([(0, 0), (2, 0), (2, 2), (0, 2)]):
            at = (Fraction(60 + x), Fraction(0), Fraction(z))
            self.lines.append(
                "process s%d = Ring mass %s velocity %s at translate %s"
                % (i, rng.choice("112"), speed, vector_text(at))
            )
            some = [self.linking(leaf), "Link0", "Link1"]
            self.behaviours["s%d" % i] = rng.choice(some)
            placed.append(("s%d" % i, leaf, at, speed))
        sides = [("right", "left"), ("top", "bottom"), ("left", "right"), ("bottom", "top")]
        bonds = [
            "bond <%s, {s%d.%s, s%d.%s}>" % (rng.choice("aab"), i, f, (i + 1) % 4, g)
            for i, (f, g) in enumerate(sides)
        ]
        rng.shuffle(bonds)
        return bonds[: rng.choice([3, 3, 4])]

    # Clusters that fall apart by lot.

    def tearing(self, leaf: Leaf) -> str:
        """A behaviour that lets go of several neighbours: by lot, freely, or now one, now another."""
        rng = self.rng
        names = ["Tear0", "Tear1", "Tear2"]
        summands = []
        for _ in range(rng.choice([1, 2, 2, 3, 3])):
            draw, name = rng.random(), rng.choice("aaab")
            sides = ["left", "right", "top", "bottom", "front", "back"]
            some = sides if rng.random() < 0.7 else rng.sample(sides, rng.choice([2, 3, 4]))
            sites = "{%s}" % ", ".join(some) if rng.random() < 0.9 else self.sites(leaf)
            text = "omega(%s, %s)%s%s" % (name, sites, self.push(), self.odds())
            if draw < 0.08:
                text = "rho({<%s, %s>})%s" % (name, sites, self.push())
            elif draw < 0.2:
                text = "<%s%s, %s>" % (rng.choice(["", "~"]), name, sites)
            delay = "eps(%s). " % rng.choice(["1/2", "1"]) if rng.random() < 0.15 else ""
            then = rng.choice([*names, *names, "nil", text.split(" push")[0] + ". nil"])
            summands += ["%s%s. %s" % (delay, text, then)] * rng.choice([1, 1, 1, 1, 2])
        return " + ".join(summands)

    def cluster(self, number: int, placed: List[Tuple[str, Leaf, Vector, str]]) -> List[str]:
        """Cubes of a lattice far away that hang together by bonds: a tree of them, or with rings."""
        rng = self.rng
        if not any(shape.name == "Node" for shape in self.shapes):
            self.shapes.append(Shape("Node", "shape Node = Cube", [None]))
            leaf = self.leaf_of("t = Node mass 1 [nil]")
            for i in range(3):
                self.lines.append("behaviour Tear%d on Node = %s" % (i, self.tearing(leaf)))
        leaf = self.leaf_of("t = Node mass 1 [nil]")
        cells, sides = [(0, 0, 0)], {0: ("right", "left"), 1: ("back", "front"), 2: ("top", "bottom")}
        names, bonds = list(range(9)), []
        rng.shuffle(names)
        origin = (Fraction(-60 + 40 * number), Fraction(90), Fraction(0))
        speed = (Fraction(rng.choice([0, 0, 8, -8])), Fraction(0), Fraction(0))
        spin = self.spin() if self.rigid else (Fraction(0),) * 3
        for i in range(rng.choice([2, 3, 3] if self.rigid else [2, 3, 3, 4, 4, 5])):
            joined = False
            while not joined:
                near, axis, sign = rng.choice(cells), rng.choice([0, 0, 1, 2]), rng.choice([-1, 1])
                cell = tuple(x + sign * (k == axis) for k, x in enumerate(near)) if i else cells[0]
                joined = not i or cell not in cells
            if i:
                cells.append(cell)  # type: ignore[arg-type]
            name = "n%d%d" % (number, names[i])
            at = add(origin, tuple(Fraction(2 * x) for x in cell))  # type: ignore[arg-type]
            for j in range(i):
                apart = [x - y for x, y in zip(cell, cells[j])]
                if sum(map(abs, apart)) != 1:
                    continue
                if cells[j] != near and not (self.cyclic and rng.random() < 0.8):
                    continue
                k = next(k for k in range(3) if apart[k])
                f, g = sides[k][:: -apart[k]]  # of this one, and of the other
                other = "n%d%d" % (number, names[j])
                bonds.append("bond <%s, {%s.%s, %s.%s}>" % (rng.choice("aaab"), name, f, other, g))
            velocity = vector_text(add(speed, cross(spin, sub(at, origin))))  # type: ignore[arg-type]
            self.spins[name] = spin  # type: ignore[assignment]
            self.lines.append(
                "process %s = Node mass %s velocity %s%s at translate %s"
                % (name, rng.choice("112"), velocity, self.spin_text(name), vector_text(at))
            )
            some = [self.tearing(leaf), "Tear0", "Tear1", "Tear2"]
            self.behaviours[name] = rng.choice(some)
            placed.append((name, leaf, at, velocity))
        rng.shuffle(bonds)
        return bonds

    # The network.

    def network(self) -> str:
        rng = self.rng
        for i in range(rng.choice([1, 2, 2, 3])):
            shape = self.compound(i) if rng.random() < 0.35 else self.basic(i)
            if shape is not None:
                self.shapes.append(shape)
        leaves: Dict[str, Leaf] = {}
        names: Dict[str, List[str]] = {}
        for shape in self.shapes:
            mass = "" if shape.parts[0] else " mass 1"
            leaves[shape.name] = self.leaf_of("t = %s%s [nil]" % (shape.name, mass))
            names[shape.name] = self.definitions(shape, leaves[shape.name])
        placed: List[Tuple[str, Leaf, Vector, str]] = []
        bonds: List[str] = []
        dense = rng.choice([3, 4, 5])
        if rng.random() < 0.25:
            wall = self.leaf_of("t = Wall mass 1 [nil]")
            at = (Fraction(0), Fraction(-4), Fraction(0))
            placed.append(("floor", wall, at, "0"))
            absorbs = self.takes("floor", 0.3)
            self.lines.append("fixed floor = Wall%s at translate %s" % (absorbs, vector_text(at)))
            self.behaviours["floor"] = "nil"
            self.walls = True
        for i in range(rng.choice([2, 3, 3, 4, 4, 5])):
            shape = rng.choice(self.shapes)
            turn = rng.choice(TURNS) if rng.random() < 0.2 else None
            at_text = " * rotate quaternion %s" % turn if turn else ""
            mass = "" if shape.parts[0] else " mass %s" % rng.choice(["1", "1", "2", "3", "1/2"])
            fixed = rng.random() < 0.15
            leaf = leaves[shape.name]
            if turn:
                leaf = self.leaf_of(
                    "t = %s%s at translate (0,0,0)%s [nil]" % (shape.name, mass, at_text)
                )
            velocity = tuple(Fraction(rng.choice([-2, -1, -1, 0, 0, 1, 1, 2])) for _ in range(3))
            if rng.random() < 0.3:
                velocity = (velocity[0], Fraction(0), Fraction(0))
            bound = rng.random() < 0.35 and placed
            for _ in range(30):
                other = rng.choice(placed) if placed else None
                if other and (bound or rng.random() < 0.35):
                    offset = snug(rng, other[1], leaf)
                    if offset is None:
                        continue
                    at = add(other[2], offset)
                else:
                    other = None
                    at = tuple(half(rng, dense) for _ in range(3))
                    if rng.random() < 0.5:
                        at = (at[0], rng.choice([at[1], Fraction(0)]), Fraction(0))
                if any(overlap(p[1], leaf, sub(at, p[2])) for p in placed):
                    continue
                name = "p%d" % i
                behaviour = rng.choice(names[shape.name] + ["nil"] * (rng.random() < 0.3))
                if rng.random() < 0.25:
                    behaviour = self.behaviour(leaf, names[shape.name], 2)
                declared = None
                if other and bound and other[0] not in self.absorbers:
                    pair = self.any_pair(other[1], leaf, sub(at, other[2]))
                    if pair:
                        channel = rng.choice("aab")
                        bonds.append(
                            "bond <%s, {%s.%s, %s.%s}>"
                            % (channel, other[0], pair[0], name, pair[1])
                        )
                        declared = other[3]
                        release = self.release(channel, names[shape.name])
                        if release:
                            alone = "only " * (not self.by_contact and rng.random() < 0.2)
                            behaviour = release % ((alone + pair[1],) * release.count("%s"))
                            at_other = release % ((alone + pair[0],) * release.count("%s"))
                            self.reword(other[0], at_other, names[shape.name])
                if rng.random() < 0.75:
                    velocity = self.towards(at, placed)
                if self.rigid and not fixed:
                    self.spins[name] = self.spin()
                self.centres[name] = add(at, leaf.centroid)
                speed = declared or ("0" if fixed else vector_text(velocity))
                if declared and declared != "0" and self.rigid:
                    speed = self.carried(name, other[0], declared)
                if declared == "0" or (fixed and not declared):
                    self.spins.pop(name, None)
                placed.append((name, leaf, at, speed))
                place = " at translate %s%s" % (vector_text(at), at_text)
                self.behaviours[name] = behaviour
                if fixed and not (declared and declared != "0"):
                    absorbs = "" if declared else self.takes(name, 0.4)
                    self.lines.append("fixed %s = %s%s%s" % (name, shape.name, absorbs, place))
                else:
                    shown = "(0,0,0)" if speed == "0" else speed
                    self.lines.append(
                        "process %s = %s%s velocity %s%s%s"
                        % (name, shape.name, mass, shown, self.spin_text(name), place)
                    )
                break
        if self.cyclic and rng.random() < 0.7:
            bonds += self.square(placed)
        if self.lots and rng.random() < 0.6:
            for number in range(1 if self.rigid else rng.choice([1, 2])):
                bonds += self.cluster(number, placed)
        if self.laws:
            self.law(placed)
        for i, line in enumerate(self.lines):
            words = line.split()
            if words[0] in ("process", "fixed") and words[1] not in self.absorbers:
                self.lines[i] = "%s [%s]" % (line, self.behaviours[words[1]])
        own = rng.choice([" local", " local", " steady", ""]) if self.laws else ""
        head = ["timestep %s%s" % (rng.choice(["1", "1/2", "2", "1/3"]), own)]
        head += ["collisions together"] * self.together + ["binding contact"] * self.by_contact
        head += ["collisions drawn"] * (not self.together and len(self.lines) % 3 == 0)
        head += ["bonds cyclic"] * self.cyclic
        if rng.random() < 0.4:
            head.append("split_step %s" % rng.choice(["1/2", "1", "3/4", "2", "1/3"]))
        if self.rigid:
            head += self.settings()
        elif rng.random() < 0.3:
            head.append("round velocity %s" % rng.choice(["1/2", "1/2", "1/4", "2^-6"]))
        head += ["shape %s {\n  %s\n}" % item for item in SOLIDS.items()]
        if self.walls:
            head.append(WALL)
        return "\n".join(head + [s.text for s in self.shapes] + self.lines + bonds) + "\n"

    def takes(self, name: str, share: float) -> str:
        """Lets a fixed body absorb what hits it, or not."""
        if self.rng.random() >= share:
            return ""
        self.absorbers.add(name)
        return " absorb"

    # Turning.

    def settings(self) -> List[str]:
        rng = self.rng
        head = ["dynamics %s" % rng.choice(["constant_spin", "constant_spin", "free_body"])]
        if rng.random() < 0.8:
            head.append("resolution 1/%d" % rng.choice([64, 1024, 1000, 2**20]))
        if rng.random() < 0.4:
            head.append("round orientation 2^-%d" % rng.choice([4, 8, 20]))
        if rng.random() < 0.4:
            head.append("round velocity 2^-%d" % rng.choice([3, 6, 20]))
        return head

    def spin(self) -> Vector:
        rng = self.rng
        if rng.random() < 0.3:
            return (Fraction(0),) * 3  # type: ignore[return-value]
        axis = rng.randrange(4)
        found = [Fraction(rng.choice([-2, -1, -1, 1, 1, 2]), rng.choice([2, 4, 4])) for _ in "xyz"]
        if axis < 3:
            found = [x if i == axis else Fraction(0) for i, x in enumerate(found)]
        return tuple(found)  # type: ignore[return-value]

    def spin_text(self, name: str) -> str:
        spin = self.spins.get(name)
        return " spin " + vector_text(spin) if spin and any(spin) else ""

    def carried(self, name: str, other: str, speed: str) -> str:
        """The velocity of a body that is bound to another one: v + w x (c - c')."""
        spin = self.spins.get(other, (Fraction(0),) * 3)
        self.spins[name] = spin
        v = tuple(Fraction(x) for x in speed.strip("()").split(","))
        arm = sub(self.centres[name], self.centres[other])
        return vector_text(add(v, cross(spin, arm)))  # type: ignore[arg-type]

    def towards(self, at: Vector, placed: List[Tuple[str, Leaf, Vector, str]]) -> Vector:
        """A velocity towards the middle, or towards another body."""
        goal = self.rng.choice(placed)[2] if placed else (Fraction(0),) * 3
        if self.rng.random() < 0.5:
            goal = (Fraction(0),) * 3
        found = []
        for here, there in zip(at, goal):
            sign = (there > here) - (there < here)
            found.append(Fraction(sign * self.rng.choice([0, 1, 1, 2])))
        return tuple(found)  # type: ignore[return-value]

    def release(self, channel: str, names: List[str]) -> Optional[str]:
        """A behaviour for both ends of a bond, with places for their sites, that releases it."""
        rng = self.rng
        if rng.random() < 0.25:
            return None
        weak, strong = "omega(%s, {%%s})" % channel, "rho({<%s, {%%s}>})" % channel
        if rng.random() < 0.35:
            return strong + self.push() + ". nil"
        if self.lots and rng.random() < 0.6:
            strong = weak

        def split() -> str:
            kind = rng.choice([weak, strong, strong])
            return kind + self.push() + (self.odds() if "omega" in kind else "")

        parts = [split()]
        while rng.random() < (0.5 if self.lots else 0.3) and len(parts) < 3:
            parts.append(split())
        delays = ["", "", "eps(1). ", "eps(1/2). ", "eps(3/2). "]
        return " + ".join("%s%s. nil" % (rng.choice(delays), part) for part in parts)

    def reword(self, name: str, behaviour: str, names: List[str]) -> None:
        """Gives a body that was placed another behaviour, or a further summand or entry."""
        old = self.behaviours[name]
        draw = self.rng.random()
        single = r"rho\(\{(<[^()]*>)\}\)( push\([^()]*\))?\. nil"
        first, second = (re.fullmatch(single, text) for text in (old, behaviour))
        if first and second and draw < 0.6:
            entries, push = "%s, %s" % (first[1], second[1]), second[2] or ""
            behaviour = "rho({%s})%s. nil" % (entries, push)
        elif draw < 0.85:
            behaviour = old + " + " + behaviour
        self.behaviours[name] = behaviour

    def any_pair(self, a: Leaf, b: Leaf, offset: Vector) -> Optional[Tuple[str, str]]:
        """Some pair of features that touch, often the highest of two parts."""
        found = []
        for part1 in a.parts:
            for part2 in b.parts:
                if contact.relation(part1.solid, part2.solid, offset) == "touching":
                    for f, g, d in contact.touching_pairs(part1.solid, part2.solid, offset):
                        texts = tuple(
                            (p.name + "." if p.name else "") + p.solid.text(x)
                            for p, x in ((part1, f), (part2, g))
                        )
                        found += [texts] * (1 + 3 * d)
        return self.rng.choice(found) if found else None  # type: ignore[return-value]

    def law(self, placed: List[Tuple[str, Leaf, Vector, str]]) -> None:
        rng = self.rng
        laws = [
            "(vx, vy - dt, vz)", "(vx, vy, vz - 2*dt)", "(-x, -y, vz)", "(vx/2, vy, -vz)",
            "(if x > 0 then -1 else 1, vy, vz)", "(0, -1, 0)", "(round(vx, 1/2), vy, vz)",
            "(vx - x*dt/mass, vy, vz)", "(1 - time, vy, 0)",
        ]  # fmt: skip
        if self.draws:
            laws = laws[:4] + [self.choosing() for _ in range(4)]
        if self.rigid and rng.random() < 0.5:
            laws = [self.spun(law) for law in laws]
        if rng.random() < 0.5:
            general = [law for law in laws if not law.startswith("diffuse")]
            self.lines.append("motion %s" % rng.choice(general))
        fixed = {line.split()[1] for line in self.lines if line.startswith("fixed")}
        for name, _, _, _ in placed:
            if name not in fixed and rng.random() < 0.4:
                self.lines.append("motion %s = %s" % (name, rng.choice(laws + ["inertial"])))


    def spun(self, law: str) -> str:
        """The law with a spin, or with some (I-24)."""
        rng = self.rng
        spins = ["(wx, wy, wz + dt/8)", "(0, 0, 1/3)", "(wy, wx, -wz)", "(x/9, 0, wz/2)", "(0, 0, 0)", "(1/4, mass/9, 0)"]
        if law.startswith("diffuse"):
            return law[:-1] + ", turning = %s)" % rng.choice(["1/9", "(0, 0, 1/3)", "0", "(1/4, 1/99, 0)"])
        if not law.startswith("choose"):
            return law + " spin " + rng.choice(spins) if rng.random() < 0.7 else law
        if " for " in law or rng.random() < 0.2:
            return law
        return "choose { %s, (0, 0, 1) spin %s }" % (law[9:-2], rng.choice(spins))

    def choosing(self) -> str:
        """A law that leaves the velocity to chance (Draw); in a few states it has no value."""
        rng = self.rng
        if rng.random() < 0.2:
            more = rng.choice(["", "", ", (vx, 0, -1)", ", (vx, vy, vz)/2, h = 2", ", h = 3", ", (0, dt, 0), 3"])
            return "diffuse(%s%s)" % (rng.choice(["1/8", "1/3", "(1/4, 0, 1/2)"]), more)
        if rng.random() < 0.1:
            return rng.choice(
                [
                    "choose { for i in -1..1, j in 0..1: (vx, vy, vz)/2 + (i, j, 0)"
                    " weight 1/(1 + i*i + j) }",
                    "choose { (1/x, 0, 0) weight if x = 0 then 0 else 1, (0, y, 1) weight 1/2 }",
                    "choose { (-1, 0, 0) weight x, (1, 0, 0) weight 2, (0, 1, 0) weight -y*y*0 }",
                    "choose { (1, vy, 0) weight 1 - vx, (-1, vy, 0) weight 1 + vx }",
                ]
            )
        kicks = []
        for _ in range(rng.choice([1, 2, 2, 2, 3, 3, 4])):
            kick = self.kick()
            kicks += [kick + rng.choice(WEIGHTS)] * rng.choice([1, 1, 1, 1, 2])
            if rng.random() < 0.15:
                kicks.append(kick + rng.choice(WEIGHTS))
        if rng.random() < 0.2:
            kicks.append("for i in -1..1: (i, 0, vz) weight 2 - i*i")
        kicks.append(self.kick())
        rng.shuffle(kicks)
        return "choose { %s }" % ", ".join(kicks)

    def kick(self) -> str:
        """A velocity: on a lattice, one that rounding changes, or one of what is seen."""
        rng = self.rng
        step = rng.choice(["1", "1", "1", "1/2", "1/3", "2/7"])
        lattice = "(%s)" % ", ".join("%d*%s" % (rng.choice([-1, 0, 0, 1]), step) for _ in "xyz")
        seen = ["(vx, vy, vz) + %s", "(vx, vy, vz)/2 - %s", "-(vx, 0, vz) + 2*%s", "(-x, -y, vz)"]
        seen += ["(1 - time, vy, 0)", "(vx, vy - dt, vz)", "(0, mass/2, -1)", "(vx, vy, vz)"]
        text = rng.choice(seen) if rng.random() < 0.4 else "%s"
        return text % lattice if "%s" in text else text


def overlap(a: Leaf, b: Leaf, offset: Vector) -> bool:
    return any(
        contact.relation(p.solid, q.solid, offset) == "interpenetrating"
        for p in a.parts
        for q in b.parts
    )


def snug(rng: random.Random, a: Leaf, b: Leaf) -> Optional[Vector]:
    """An offset from a at which b touches it: moved along an axis until it does."""
    p, q = rng.choice(a.parts).solid, rng.choice(b.parts).solid
    direction = [Fraction(0)] * 3
    axis = rng.randrange(3)
    direction[axis] = Fraction(rng.choice([-1, 1]))
    start = [half(rng, 2) for _ in range(3)]
    start[axis] = -9 * direction[axis]
    velocity = tuple(direction)
    t = contact.first_time_of_contact(p, q, tuple(start), velocity)  # type: ignore[arg-type]
    if t is None:
        return None
    return tuple(s + t * v for s, v in zip(start, velocity))  # type: ignore[return-value]


def highest(a: Leaf, b: Leaf, offset: Vector) -> Tuple[Feature, Feature]:
    """Rule Highest, of two leaves of one part each: the pair with the others in its closures."""
    pairs = contact.touching_pairs(a.parts[0].solid, b.parts[0].solid, offset)
    most = max(d for _, _, d in pairs)
    for f, g, d in pairs:
        if d == most:
            return f, g
    raise AssertionError


def model(rng: random.Random, rigid: bool = False) -> str:
    """The text of a random model; one that does not fit the language is made again."""
    while True:
        maker = Generator(rng, rigid)
        text = maker.network()
        if "process" in text or "fixed" in text:
            return text
