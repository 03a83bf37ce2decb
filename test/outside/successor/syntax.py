"""Reads a model (specs/language.md): words, then declarations as plain tuples and lists.

Formulas of properties are passed over. What a declaration means is for ``model``.
"""

from __future__ import annotations

import re
import unicodedata
from fractions import Fraction
from typing import Any, Dict, List, Optional, Tuple


class Refused(Exception):
    """The text is not of the language, or of a part of it that is not read here."""


_WORDS = re.compile(
    r"""\s+ | //[^\n]* | (?P<number>2\^-?[0-9]+ | [0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?)
    | (?P<name>[A-Za-z][A-Za-z0-9_']*) | (?P<string>"(?:[^"\\]|\\.)*")
    | (?P<mark>\|\||<=|>=|!=|=>|\.\.|[-+*/=<>(){}\[\],.:~;])""",
    re.X,
)

_LETTERS = {
    "⟨": "<", "⟩": ">", "〈": "<", "〉": ">", "ω": "omega", "ρ": "rho", "ε": "eps",
    "·": ".", "‖": "||",
}  # fmt: skip

DECLARATIONS = {
    "model", "param", "timestep", "split_step", "dynamics", "collisions", "binding", "bonds", "blocked",
    "resolution", "round", "shape",
    "compound", "behaviour", "process", "fixed", "bond", "for", "network", "motion", "let",
    "check",
}  # fmt: skip


def words(text: str) -> List[Tuple[str, str]]:
    """The words of a text, each with its kind."""
    text = _comments(text)
    text = "".join(_LETTERS.get(c, c) for c in unicodedata.normalize("NFD", text))
    text = re.sub("([A-Za-z][A-Za-z0-9_'\u0304\u0305]*)", _bars, text)
    found, at = [], 0
    while at < len(text):
        match = _WORDS.match(text, at)
        if match is None:
            raise Refused("cannot read %r" % text[at : at + 20])
        at = match.end()
        if match.lastgroup:
            found.append((match.lastgroup, match.group(match.lastgroup)))
    found.append(("end", ""))
    return found


def _bars(match: "re.Match[str]") -> str:
    name = match.group(1)
    plain = name.replace("\u0304", "").replace("\u0305", "")
    return plain if plain == name else "~" + plain


def _comments(text: str) -> str:
    """Without /* ... */, which nest, and // ..."""
    out, depth, i = [], 0, 0
    while i < len(text):
        if depth == 0 and text.startswith("//", i):
            end = text.find("\n", i)
            i = len(text) if end < 0 else end
        elif text.startswith("/*", i):
            depth, i = depth + 1, i + 2
        elif depth and text.startswith("*/", i):
            depth, i = depth - 1, i + 2
        else:
            if depth == 0:
                out.append(text[i])
            i += 1
    return "".join(out)


def number(text: str) -> Fraction:
    if "^" in text:
        return Fraction(2) ** int(text.split("^")[1])
    return Fraction(text)


class Reader:
    """A recursive descent over the words."""

    def __init__(self, text: str) -> None:
        self.words = words(text)
        self.at = 0

    # Words.

    def peek(self, ahead: int = 0) -> str:
        i = self.at + ahead
        return self.words[i][1] if i < len(self.words) else ""

    def kind(self, ahead: int = 0) -> str:
        i = self.at + ahead
        return self.words[i][0] if i < len(self.words) else "end"

    def next(self) -> str:
        self.at += 1
        return self.words[self.at - 1][1]

    def accept(self, word: str) -> bool:
        if self.peek() == word and self.kind() != "string":
            self.at += 1
            return True
        return False

    def expect(self, word: str) -> None:
        if not self.accept(word):
            around = " ".join(w for _, w in self.words[max(0, self.at - 5) : self.at + 5])
            raise Refused("expected %s near: %s" % (word, around))

    def name(self) -> str:
        if self.kind() != "name":
            raise Refused("expected a name, not %r" % self.peek())
        return self.next()

    def separated(self, item, end: str) -> list:
        """Items with commas between, up to and with the word that ends them."""
        found = []
        if self.accept(end):
            return found
        while True:
            found.append(item())
            if not self.accept(","):
                self.expect(end)
                return found

    # Expressions, as (operator, operands ...).

    def expr(self) -> Any:
        if self.accept("if"):
            test = self.expr()
            self.expect("then")
            yes = self.expr()
            self.expect("else")
            return ("if", test, yes, self.expr())
        return self._either()

    def _either(self) -> Any:
        left = self._both()
        while self.accept("or"):
            left = ("or", left, self._both())
        return left

    def _both(self) -> Any:
        left = self._not()
        while self.accept("and"):
            left = ("and", left, self._not())
        return left

    def _not(self) -> Any:
        if self.accept("not"):
            return ("not", self._not())
        left = self.sum()
        for operator in ("=", "!=", "<=", ">=", "<", ">"):
            if self.accept(operator):
                return (operator, left, self.sum())
        return left

    def sum(self, indices: bool = True) -> Any:
        left = self._product(indices)
        while self.peek() in ("+", "-"):
            left = (self.next(), left, self._product(indices))
        return left

    def _product(self, indices: bool) -> Any:
        left = self._signed(indices)
        while self.peek() in ("*", "/"):
            left = (self.next(), left, self._signed(indices))
        return left

    def _signed(self, indices: bool) -> Any:
        if self.accept("-"):
            return ("negate", self._signed(indices))
        if self.kind() == "number":
            return ("number", number(self.next()))
        if self.accept("("):
            inner = self.expr()
            if self.accept(","):
                inner = ("vector", [inner, *self.separated(self.expr, ")")])
                if len(inner[1]) != 3:
                    raise Refused("a vector has three components")
            else:
                self.expect(")")
            return self._component(inner)
        if self.accept("true"):
            return ("true",)
        if self.accept("false"):
            return ("false",)
        name = self.name()
        if self.accept("("):
            return self._component(("call", name, self.separated(self.expr, ")")))
        if indices and self.peek() == "[":
            self.next()
            return ("member", name, self.separated(self.expr, "]"))
        return self._component(("name", name))

    def _component(self, vector: Any) -> Any:
        """A component of what was read, if it is asked for."""
        if self.peek() == "." and self.peek(1) in ("x", "y", "z") and self.peek(2) != "(":
            self.next()
            return ("component", vector, self.next())
        return vector

    def vector(self) -> Any:
        self.expect("(")
        found = self.separated(self.expr, ")")
        if len(found) != 3:
            raise Refused("a vector has three components")
        return found

    # Names with indices, and paths of them.

    def segment(self) -> Any:
        name = self.name()
        return (name, self.separated(self.expr, "]") if self.accept("[") else None)

    def path(self) -> List[Any]:
        found = [self.segment()]
        while self.accept("."):
            found.append(self.segment())
        return found

    # Features, channels, behaviours.

    def feature(self) -> Any:
        """(segments, None) or (segments, [vertices, each a path])."""
        segments: List[Any] = []
        while True:
            if self.accept("["):
                return (segments, self.separated(self.path, "]"))
            segments.append(self.segment())
            if not self.accept("."):
                return (segments, None)

    def features(self) -> List[Any]:
        self.expect("{")
        return self.separated(self.feature, "}")

    def members(self) -> List[Any]:
        """The features of a channel, each with whether it stands for itself alone (I-34)."""
        self.expect("{")
        first = self.at

        def member() -> Any:
            named = self.kind(1) == "name" or self.peek(1) == "[" or self.at == first
            only = named and self.accept("only")
            return (only, self.feature())

        return self.separated(member, "}")

    def channel(self) -> Any:
        self.expect("<")
        barred = self.accept("~")
        name = self.name()
        self.expect(",")
        members = self.members()
        self.expect(">")
        return (barred, name, members)

    def push(self) -> Any:
        """What a split says of the impulse that drives the pieces apart (I-36)."""
        if not self.accept("push"):
            return ("number", Fraction(0))
        self.expect("(")
        found = self.expr()
        self.expect(")")
        return found

    def odds(self) -> Any:
        """What a weak split says of its chance (Lot): a number, a quotient of two, a name, or what
        stands in brackets; None if nothing is said."""
        if self.peek() not in ("chance", "rate"):
            return None
        word = self.next()
        if self.accept("("):
            found = self.expr()
            self.expect(")")
        elif self.kind() == "number":
            found = ("number", number(self.next()))
            if self.accept("/"):
                found = ("/", found, ("number", number(self.next())))
        else:
            found = ("name", self.name())
        return (word, found)

    def behaviour(self) -> Any:
        terms = [self.term()]
        while self.accept("+"):
            terms.append(self.term())
        return terms[0] if len(terms) == 1 else ("sum", terms)

    def term(self) -> Any:
        if self.accept("nil"):
            return ("nil",)
        if self.accept("("):
            inner = self.behaviour()
            self.expect(")")
            return inner
        if self.peek() == "<":
            channel = self.channel()
            self.expect(".")
            return ("open", channel, self.term())
        if self.accept("omega"):
            self.expect("(")
            barred = self.accept("~")
            name = self.name()
            self.expect(",")
            members = self.members()
            self.expect(")")
            push, odds = self.push(), self.odds()
            self.expect(".")
            return ("weak", (barred, name, members), self.term(), push, odds)
        if self.accept("rho"):
            self.expect("(")
            self.expect("{")
            channels = self.separated(self.channel, "}")
            self.expect(")")
            push = self.push()
            self.expect(".")
            return ("strong", channels, self.term(), push)
        if self.accept("eps"):
            self.expect("(")
            delay = self.expr()
            self.expect(")")
            self.expect(".")
            return ("wait", delay, self.term())
        return ("name", self.name())

    # Shapes.

    def solid(self) -> Any:
        if self.peek() == "mesh":
            raise Refused("meshes are not read here")
        found: Any = ("shape", self.name())
        while self.accept("scaled"):
            found = ("scaled", found, self.vector())
        return found

    def transform(self) -> Any:
        found = []
        while True:
            word = self.next()
            if word == "translate":
                found.append((word, self.vector()))
            elif word == "scale":
                found.append((word, self.vector()))
            elif word == "rotate":
                self.expect("quaternion")
                self.expect("(")
                found.append((word, self.separated(self.expr, ")")))
            elif word == "matrix":

                def row() -> Any:
                    self.expect("(")
                    return self.separated(self.expr, ")")

                self.expect("(")
                found.append((word, self.separated(row, ")")))
            else:
                raise Refused("no transformation: %s" % word)
            if not self.accept("*"):
                return found

    def attributes(self) -> dict:
        found: dict = {}
        while True:
            if self.accept("mass"):
                found["mass"] = self.sum(indices=False)
            elif self.accept("velocity"):
                found["velocity"] = self.vector()
            elif self.accept("spin"):
                found["spin"] = self.vector()
            elif self.accept("absorb"):
                found["absorb"] = True
            elif self.accept("at"):
                found["at"] = self.transform()
            else:
                return found

    # Processes.

    def chain(self) -> Tuple[list, list]:
        """Leaves and bonds, without brackets (I-5)."""
        leaves, bonds = [], []
        while True:
            if self.accept("("):
                more, others = self.chain()
                self.expect(")")
                leaves += more
                bonds += others
            else:
                leaves.append(self.leaf())
            if self.peek() != "<":
                return leaves, bonds
            bonds.append(self.bond())

    def leaf(self) -> dict:
        label = None
        if self._labelled():
            label = self.segment()
            self.expect(":")
        solid = self.solid()
        found = self.attributes()
        found["label"], found["solid"], found["behaviour"] = label, solid, None
        if self.accept("["):
            found["behaviour"] = self.behaviour()
            self.expect("]")
        return found

    def _labelled(self) -> bool:
        """Whether a name, with indices or not, and a colon come next."""
        i, depth = 1, 0
        if self.peek(i) == "[":
            while True:
                depth += (self.peek(i) == "[") - (self.peek(i) == "]")
                i += 1
                if depth == 0 or self.kind(i) == "end":
                    break
        return self.peek(i) == ":"

    def bond(self) -> Any:
        self.expect("<")
        name = self.name()
        self.expect(",")
        ends = self.features()
        self.expect(">")
        return (name, ends)

    # Declarations.

    def items(self, end: str) -> List[Any]:
        found = []
        while self.peek() != end or (end == "" and self.kind() != "end"):
            item = self.item()
            if item is not None:
                found.append(item)
        return found

    def item(self) -> Optional[Any]:
        word = self.next()
        if word == "model":
            return (word, self.name())
        if word == "param":
            name = self.name()
            self.expect("=")
            return (word, name, self.expr())
        if word in ("timestep", "split_step", "resolution"):
            return self._setting(word)
        if word in ("dynamics", "collisions", "binding", "bonds", "blocked"):
            return (word, self.name())
        if word == "round":
            return (word, self.next(), self.expr())
        if word == "shape":
            return self._shape()
        if word == "compound":
            return self._compound()
        if word == "behaviour":
            name = self.name()
            if self.accept("on"):
                self.name()
            self.expect("=")
            return (word, name, self.behaviour())
        if word in ("process", "fixed"):
            name = self.segment()
            self.expect("=")
            return (word, name, self.chain())
        if word == "bond":
            return (word, self.bond())
        if word == "for":
            return self._loop()
        if word == "network":
            if self.accept("nil"):
                return (word, [])
            paths = [self.path()]
            while self.accept("||"):
                paths.append(self.path())
            return (word, paths)
        if word == "motion":
            return self._motion()
        if word in ("let", "check"):
            return self._named_formula(word)
        raise Refused("no declaration: %s" % word)

    def _setting(self, word: str) -> Any:
        value = self.expr()
        if word == "timestep" and self.peek() in ("local", "steady"):
            return (word, value, self.next())
        return (word, value)

    def _shape(self) -> Any:
        name = self.name()
        if self.accept("="):
            return ("shape", name, self.solid())
        self.expect("{")
        self.expect("vertices")
        vertices, faces = [], []
        while self.peek() != "faces":
            vertex = self.name()
            vertices.append((vertex, self.vector()))
        self.expect("faces")
        while not self.accept("}"):
            face = self.name()
            self.expect("[")
            faces.append((face, tuple(self.separated(self.name, "]"))))
        return ("shape", name, ("template", vertices, faces))

    def _compound(self) -> Any:
        name = self.name()
        if self.accept("="):
            raise Refused("drawn bodies are not read here")
        self.expect("{")
        parts, glues = [], []
        while not self.accept("}"):
            if self.accept("part"):
                part = self.name()
                self.expect(":")
                solid = self.solid()
                parts.append((part, solid, self.attributes()))
            else:
                self.expect("glue")
                first = self.feature()
                self.expect("~")
                glues.append((first, self.feature()))
        return ("compound", name, parts, glues)

    def _ranges(self) -> List[Any]:
        """Indices with their bounds."""
        ranges = []
        while True:
            name = self.name()
            self.expect("in")
            low = self.expr()
            self.expect("..")
            ranges.append((name, low, self.expr()))
            if not self.accept(","):
                return ranges

    def _loop(self) -> Any:
        ranges = self._ranges()
        self.expect("{")
        body = self.items("}")
        self.expect("}")
        return ("for", ranges, body)

    def _motion(self) -> Any:
        start = self.at
        target = None
        if self.kind() == "name" and self.peek() not in ("inertial", "choose"):
            target = self.path()
            if not self.accept("="):
                self.at, target = start, None
        if self.accept("inertial"):
            return ("motion", target, None)
        if self.accept("choose"):
            self.expect("{")
            return ("motion", target, ("choose", self.separated(self._kick, "}")))
        if self.peek() == "diffuse" and self.peek(1) == "(":
            self.at += 2
            return ("motion", target, ("diffuse", self._diffusion()))
        return ("motion", target, ("gives", self.expr(), self._spin()))

    def _spin(self) -> Any:
        return self.expr() if self.accept("spin") else None

    def _diffusion(self) -> List[Any]:
        """The constant of ``diffuse``, its drift, its kick and its constants of turning, None for what is not
        given."""
        by_name: Dict[str, Any] = {}

        def argument() -> Any:
            if self.peek() in ("h", "turning") and self.peek(1) == "=":
                name = self.peek()
                self.at += 2
                by_name[name] = self.expr()
                return None
            return self.expr()

        written = [e for e in self.separated(argument, ")") if e is not None]
        constant, drift, kick = written + [None] * (3 - len(written))
        return [constant, drift, by_name.get("h", kick), by_name.get("turning")]

    def _kick(self) -> Any:
        """A velocity of ``choose``, with its spin and its weight, and the indices that write many of them."""
        ranges = []
        if self.accept("for"):
            ranges = self._ranges()
            self.expect(":")
        velocity, spin = self.expr(), self._spin()
        weight = self.expr() if self.accept("weight") else ("number", Fraction(1))
        return (ranges, velocity, spin, weight)

    def _named_formula(self, word: str) -> Any:
        """A check is passed over; of a let, what is an expression of laws is kept."""
        name = self.name()
        self.expect("=" if word == "let" else ":")
        start = self.at
        if word == "let":
            try:
                value = self.expr()
                if self._ends():
                    return ("let", name, value)
            except Refused:
                pass
        self.at = start
        depth = 0
        while self.kind() != "end" and (depth or not self._ends()):
            depth += (self.peek() in "([{") - (self.peek() in ")]}")
            self.next()
        return None

    def _ends(self) -> bool:
        """Whether a new declaration begins here, or none is to come."""
        if self.kind() == "end" or self.peek() == "}":
            return True
        before = self.words[self.at - 1][1] if self.at else ""
        if before in ("event", ".", "(", ",", "=", "+", "-", "*", "/", "not", "and", "or", "in"):
            return False
        return self.kind() == "name" and self.peek() in DECLARATIONS and self.peek(1) != "("


def read(text: str) -> List[Any]:
    """The declarations of a model."""
    reader = Reader(text)
    found = reader.items("")
    if reader.kind() != "end":
        raise Refused("more than declarations")
    return found


def read_behaviour(text: str) -> Any:
    """A behaviour by itself, as states tell it."""
    reader = Reader(text)
    found = reader.behaviour()
    if reader.kind() != "end":
        raise Refused("more than a behaviour: %s" % text)
    return found
