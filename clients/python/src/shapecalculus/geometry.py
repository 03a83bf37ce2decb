"""Answers about shapes: what they are, how two touch, when they meet, and what they do then."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Mapping, Optional, Tuple

from . import numbers
from .numbers import Matrix, Vector

Json = Mapping[str, Any]


@dataclass(frozen=True)
class ShapeWarning:
    code: str
    message: str

    @classmethod
    def from_json(cls, json: Json) -> ShapeWarning:
        return cls(json["code"], json["message"])


@dataclass(frozen=True)
class Shape:
    """A convex solid that the service knows, by its ``handle``; the other members are figures about it."""

    handle: str
    vertices: int
    edges: int
    faces: int
    volume: Fraction
    centroid: Vector
    warnings: Tuple[ShapeWarning, ...] = ()

    @classmethod
    def from_json(cls, json: Json) -> Shape:
        return cls(
            json["shape"],
            json["vertices"],
            json["edges"],
            json["faces"],
            numbers.fraction(json["volume"]),
            numbers.vector(json["centroid"]),
            tuple(map(ShapeWarning.from_json, json["warnings"])),
        )


@dataclass(frozen=True)
class Fault:
    """Why something is no convex closed polyhedron."""

    kind: str
    code: str
    message: str
    hint: Optional[str]

    @classmethod
    def from_json(cls, json: Json) -> Fault:
        return cls(json["kind"], json["code"], json["message"], json["hint"])


@dataclass(frozen=True)
class Condition:
    """One of the seven of Definition 4.3, as printed; ``witness`` says why it fails."""

    number: int
    statement: str
    holds: bool
    witness: Optional[str]

    @classmethod
    def from_json(cls, json: Json) -> Condition:
        return cls(json["number"], json["statement"], json["holds"], json["witness"])


@dataclass(frozen=True)
class MassProperties:
    """Of the uniform solid; ``inertia`` is about the centroid, for density 1, ``inertia_of_mass`` for ``mass``."""

    volume: Fraction
    centroid: Vector
    inertia: Matrix
    mass: Fraction
    inertia_of_mass: Matrix

    @classmethod
    def from_json(cls, json: Json) -> MassProperties:
        return cls(
            numbers.fraction(json["volume"]),
            numbers.vector(json["centroid"]),
            numbers.matrix(json["inertia"]),
            numbers.fraction(json["mass"]),
            numbers.matrix(json["inertia_of_mass"]),
        )

    @classmethod
    def from_report(cls, json: Json) -> MassProperties:
        """As reports of shapes have them: for mass 1."""
        inertia = json["inertia_of_unit_mass"]
        return cls.from_json({**json, "mass": "1/1", "inertia_of_mass": inertia})


@dataclass(frozen=True)
class ShapeReport:
    """What is to be said about vertices and faces, whether they make a shape or not."""

    accepted: bool
    faults: Tuple[Fault, ...]
    warnings: Tuple[ShapeWarning, ...]
    conditions: Tuple[Condition, ...]
    euler: int
    mass_properties: Optional[MassProperties]
    edges: int

    @classmethod
    def from_json(cls, json: Json) -> ShapeReport:
        definition, mass = json["definition_4_3"], json["mass_properties"]
        return cls(
            json["accepted"],
            tuple(map(Fault.from_json, json["faults"])),
            tuple(map(ShapeWarning.from_json, json["warnings"])),
            tuple(map(Condition.from_json, definition["conditions"])),
            definition["euler"],
            None if mass is None else MassProperties.from_report(mass),
            json["edges"],
        )


@dataclass(frozen=True)
class Feature:
    """A vertex, an edge or a face; ``vertices`` are indices."""

    kind: str
    name: str
    vertices: Tuple[int, ...]

    @classmethod
    def from_json(cls, json: Json) -> Feature:
        return cls(json["kind"], json["name"], tuple(json["vertices"]))


@dataclass(frozen=True)
class Pair:
    """A feature of A and one of B that touch, and the dimension of what they share."""

    first: Feature
    second: Feature
    dimension: int

    @classmethod
    def from_json(cls, json: Json) -> Pair:
        first, second = Feature.from_json(json["first"]), Feature.from_json(json["second"])
        return cls(first, second, json["dimension"])


@dataclass(frozen=True)
class Contact:
    """How two shapes lie: ``relation`` is "apart", "touching", "interpenetrating", or "near" with a resolution.

    What does not apply is None or empty. ``gap`` and ``plane`` (normal, height) come with a resolution only,
    ``approaching`` with a velocity only.
    """

    relation: str
    region: Tuple[Vector, ...]
    normals: Tuple[Vector, ...]
    pairs: Tuple[Pair, ...]
    highest: Optional[Pair]
    approaching: Optional[bool]
    gap: Optional[Vector] = None
    plane: Optional[Tuple[Vector, Fraction]] = None

    @classmethod
    def from_json(cls, json: Json) -> Contact:
        highest, gap, plane = json["highest"], json.get("gap"), json.get("plane")
        return cls(
            json["relation"],
            tuple(map(numbers.vector, json["region"] or ())),
            tuple(map(numbers.vector, json["normals"] or ())),
            tuple(map(Pair.from_json, json["pairs"] or ())),
            None if highest is None else Pair.from_json(highest),
            json.get("approaching"),
            None if gap is None else numbers.vector(gap),
            None if plane is None else (numbers.vector(plane["normal"]), numbers.fraction(plane["height"])),
        )


class Meeting:
    """When two bodies meet: ``outcome`` is "never", "inside" (they interpenetrate at time 0) or "at".

    ``time`` is None for the first two. ``grid`` comes with turning bodies only: the time is then rounded down to a
    multiple of 2 to the power of -grid. Meetings are made by the million: the time is read when somebody asks for it.
    """

    __slots__ = ("outcome", "grid", "_exact")

    def __init__(self, outcome: str, exact: Optional[str] = None, grid: Optional[int] = None) -> None:
        self.outcome = outcome
        self.grid = grid
        self._exact = exact

    @property
    def time(self) -> Optional[Fraction]:
        return None if self._exact is None else numbers.fraction(self._exact)

    @property
    def collides(self) -> bool:
        """Whether they meet at a time (also at 0)."""
        return self._exact is not None

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Meeting):
            return NotImplemented
        return (self.outcome, self._exact, self.grid) == (other.outcome, other._exact, other.grid)

    def __hash__(self) -> int:
        return hash((self.outcome, self._exact, self.grid))

    def __repr__(self) -> str:
        grid = "" if self.grid is None else ", grid=%d" % self.grid
        return "Meeting(outcome=%r, time=%r%s)" % (self.outcome, self.time, grid)

    @classmethod
    def from_json(cls, json: Json) -> Meeting:
        time = json["time"]
        return cls(json["outcome"], None if time is None else time["exact"], json.get("grid"))


@dataclass(frozen=True)
class Motion:
    """What a body has after a response; ``spin`` is None where nothing turns."""

    velocity: Vector
    spin: Optional[Vector] = None

    @classmethod
    def from_json(cls, json: Json) -> Motion:
        spin = json.get("spin")
        return cls(numbers.vector(json["velocity"]), None if spin is None else numbers.vector(spin))


@dataclass(frozen=True)
class Response:
    """``outcome`` is "bounced", or "persistent": nothing approaches and nothing changes."""

    outcome: str
    first: Motion
    second: Motion

    @classmethod
    def from_json(cls, json: Json) -> Response:
        return cls(json["outcome"], Motion.from_json(json["first"]), Motion.from_json(json["second"]))
