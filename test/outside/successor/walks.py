"""Random models of walkers that do not bounce (rule Blocked), close to each other and to walls.

Bodies stand on a grid, mostly of their own width, and are kicked along it: into walls and nooks, into the place that
another one leaves, two into one place, along edges and corners. Some bind, some are absorbed, some do not draw.
"""

from __future__ import annotations

import random
from fractions import Fraction
from typing import List, Optional, Tuple

from generate import SOLIDS, Shape, leaf_of, overlap, vector_text
from model import Leaf
from vectors import Vector, sub

SHAPES = {
    "Unit": "shape Unit = Cube scaled (1/2, 1/2, 1/2)",
    "Slab": "shape Slab = Cube scaled (1, 1/2, 1/2)",
    "Half": "shape Half = Cube scaled (1/4, 1/2, 1/2)",
    "Big": "shape Big = Cube scaled (1, 1, 1/2)",
    "Wedge": "shape Wedge = Prism scaled (1/2, 1/2, 1/2)",
    "Roof": "shape Roof = Pyramid scaled (1/2, 1/2, 1)",
    "Bar": """compound Bar {
  part u : Unit mass 1
  part v : Unit mass 1 at translate (1, 0, 0)
  glue u.right ~ v.left
}""",
    "Ell": """compound Ell {
  part u : Unit mass 1
  part v : Unit mass 2 at translate (1, 0, 0)
  part w : Unit mass 1 at translate (0, 1, 0)
  glue u.right ~ v.left
  glue u.back ~ w.front
}""",
}
NEEDS = {"Wedge": ["Prism"], "Roof": ["Pyramid"]}
PARTS = {"Bar": ["u", "v"], "Ell": ["u", "v", "w"]}
AXES = ["(1,0,0)", "(-1,0,0)", "(0,1,0)", "(0,-1,0)"]
MORE = ["(0,0,0)", "(1,1,0)", "(-1,1,0)", "(2,0,0)", "(0,-2,0)", "(1/2,0,0)", "(0,3,0)", "(1,0,1)", "(0,0,1)", "(1,1,1)"]  # fmt: skip


def text_of(name: str) -> str:
    solids = NEEDS.get(name, ["Cube"])
    texts = ["shape %s {\n  %s\n}" % (s, SOLIDS[s]) for s in solids]
    return "\n".join(texts + ([SHAPES["Unit"]] if name in PARTS else []) + [SHAPES[name]])


class Walks:
    def __init__(self, rng: random.Random) -> None:
        self.rng = rng
        self.lines: List[str] = []
        self.placed: List[Tuple[str, Leaf, Vector]] = []
        self.step = rng.choice(["1", "1", "1", "1/2", "2"])
        self.binds = rng.random() < 0.5
        self.flat = rng.random() < 0.7
        self.width, self.depth = rng.choice([(2, 1), (3, 1), (3, 2), (2, 2), (4, 2), (3, 3)])

    def fits(self, leaf: Leaf, at: Vector) -> bool:
        return not any(overlap(other, leaf, sub(at, there)) for _, other, there in self.placed)

    def leaf(self, shape: str) -> Leaf:
        mass = "" if shape in PARTS else " mass 1"
        return leaf_of(text_of(shape) + "\nprocess t = %s%s [nil]" % (shape, mass))

    def place(self) -> Vector:
        """A point of the grid of the room, sometimes between two of them."""
        rng = self.rng

        def coordinate(size: int) -> Fraction:
            shift = Fraction(rng.choice([1, -1]), rng.choice([2, 3])) if rng.random() < 0.15 else 0
            return Fraction(rng.randrange(size)) + shift

        z = Fraction(0) if self.flat else Fraction(rng.choice([0, 0, 1]))
        return coordinate(self.width), coordinate(self.depth), z

    def walls(self) -> None:
        """Around the room, some left out; each at the distance of the grid, or a little farther."""
        rng = self.rng
        w, d = self.width, self.depth
        sides = [
            ("west", (-1, Fraction(d - 1, 2)), (1, d + 2)), ("east", (w, Fraction(d - 1, 2)), (1, d + 2)),
            ("south", (Fraction(w - 1, 2), -1), (w, 1)), ("north", (Fraction(w - 1, 2), d), (w, 1)),
        ]  # fmt: skip
        for name, (x, y), (a, b) in sides:
            if rng.random() < 0.25:
                continue
            far = Fraction(1, 2) if rng.random() < 0.15 else Fraction(0)
            x += far * ((name == "east") - (name == "west"))
            y += far * ((name == "north") - (name == "south"))
            size = "(%s, %s, 2)" % (Fraction(a, 2), Fraction(b, 2))
            self.lines.append("shape Wall_%s = Cube scaled %s" % (name, size))
            at = (Fraction(x), Fraction(y), Fraction(0))
            leaf = leaf_of(text_of("Unit") + "\nshape Own = Cube scaled %s\nfixed t = Own [nil]" % size)
            if rng.random() < 0.1:
                self.lines.append("fixed %s = Wall_%s absorb at translate %s" % (name, name, vector_text(at)))
            else:
                behaviour = self.behaviour("Unit") if rng.random() < 0.3 else "nil"
                self.lines.append(
                    "fixed %s = Wall_%s at translate %s [%s]" % (name, name, vector_text(at), behaviour)
                )
            self.placed.append((name, leaf, at))

    def sites(self, shape: str) -> str:
        faces = {"Wedge": ["west", "south", "slope"], "Roof": ["base", "s1", "s2", "s3", "s4"]}.get(
            shape, ["left", "right", "front", "back", "top", "bottom"]
        )
        chosen = faces if self.rng.random() < 0.6 else self.rng.sample(faces, 2)
        parts = [p + "." for p in PARTS.get(shape, [])] or [""]
        return "{%s}" % ", ".join(p + f for p in parts for f in chosen)

    def behaviour(self, shape: str) -> str:
        """Often none, else a bond that may come apart, now or later."""
        rng = self.rng
        if not self.binds or rng.random() < 0.3:
            return "nil"
        sites = self.sites(shape)
        bar = rng.choice(["", "~"])
        then = rng.choice(
            [
                "nil", "omega(a, %s). nil", "omega(a, %s) chance 1/2. nil", "rho({<a, %s>}). nil",
                "eps(1). rho({<a, %s>}). nil", "eps(1/2). omega(a, %s) push(1). nil", "<~a, %s>. nil",
            ]
        )  # fmt: skip
        late = rng.choice(["", "", "eps(1). ", "eps(1/2). ", "eps(3/2). "])
        return "%s<%sa, %s>. %s" % (late, bar, sites, then % sites if "%s" in then else then)

    def law(self) -> Optional[str]:
        """A law that chooses, one that does not, or none."""
        rng = self.rng
        draw = rng.random()
        if draw < 0.12:
            return None
        if draw < 0.2:
            return rng.choice(["(vx, vy - dt, vz)", "(1, 0, 0)", "(-x, -y, 0)", "(vx/2, vy, 0)"])
        if draw < 0.28:
            return rng.choice(["diffuse(1/4)", "diffuse((1/2, 1/2, 0))", "diffuse(1/8, (1, 0, 0))", "diffuse((1/2, 0, 0), (0, 0, 0), 2)"])  # fmt: skip
        if draw < 0.33:
            return rng.choice(
                ["choose { (vx, vy, 0) + (1, 0, 0), (vx, vy, 0) - (1, 0, 0) }",
                 "choose { (-vx, 1, 0), (1, -vy, 0) }",
                 "choose { (1, 0, 0) weight if x > 1 then 0 else 1, (-1, 0, 0) }"]
            )  # fmt: skip
        kicks = rng.sample(AXES, rng.choice([1, 1, 2, 2, 4]))
        if rng.random() < 0.4:
            kicks += rng.sample(MORE, rng.choice([1, 1, 2]))
        speed = Fraction(1) / Fraction(self.step)
        times = "" if speed == 1 or rng.random() < 0.3 else "%s * " % (speed if speed.denominator == 1 else "(%s)" % speed)  # fmt: skip
        weight = lambda: rng.choice(["", "", "", " weight 2"])  # noqa: E731
        return "choose { %s }" % ", ".join(times + k + weight() for k in kicks)

    def body(self, i: int) -> None:
        rng, name = self.rng, "w%d" % i
        shape = rng.choice(["Unit"] * 6 + list(SHAPES))
        leaf = self.leaf(shape)
        for _ in range(30):
            at = self.place()
            if shape == "Slab" or shape == "Big":
                at = (at[0] + Fraction(1, 2), at[1] + Fraction(shape == "Big", 2), at[2])
            if shape == "Wedge":
                at = (at[0] - Fraction(1, 2), at[1] - Fraction(1, 2), at[2])
            if not self.fits(leaf, at):
                continue
            law, fixed = self.law(), rng.random() < 0.08
            mass = "" if shape in PARTS else " mass %s" % rng.choice("1112")
            velocity = "(0,0,0)"
            if rng.random() < (0.8 if law is None or "choose" not in law else 0.15):
                velocity = rng.choice(AXES + AXES + ["(1,1,0)", "(-2,0,0)"])
            place, behaviour = "at translate %s" % vector_text(at), self.behaviour(shape)
            if fixed:
                self.lines.append("fixed %s = %s %s [%s]" % (name, shape, place, behaviour))
            else:
                self.lines.append(
                    "process %s = %s%s velocity %s %s [%s]" % (name, shape, mass, velocity, place, behaviour)
                )
                if law is not None:
                    self.lines.append("motion %s = %s" % (name, law))
            self.placed.append((name, leaf, at))
            return

    def text(self) -> str:
        rng = self.rng
        if rng.random() < 0.8:
            self.walls()
        for i in range(rng.choice([1, 2, 2, 3, 3, 3, 4, 4])):
            self.body(i)
        head = ["timestep %s%s" % (self.step, rng.choice([" steady", " steady", " local", ""]))]
        head.append("blocked %s" % rng.choice(["stop", "wait", "wait"]))
        head += ["collisions together"] * (rng.random() < 0.3)
        head += ["binding contact"] * (self.binds and rng.random() < 0.3)
        head += ["bonds cyclic"] * (self.binds and rng.random() < 0.2)
        if rng.random() < 0.3:
            head.append("split_step %s" % rng.choice(["1/2", "1", "2"]))
        head += ["shape %s {\n  %s\n}" % item for item in SOLIDS.items()]
        return "\n".join(head + list(SHAPES.values()) + self.lines) + "\n"


def model(rng: random.Random) -> str:
    """The text of a random model with a body."""
    while True:
        text = Walks(rng).text()
        if "\nprocess" in text:
            return text
