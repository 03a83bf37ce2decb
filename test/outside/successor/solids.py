"""Convex solids with named features (Definitions 4.1 to 4.4), and their masses (rule Mass).

A feature is a pair: its kind ("vertex", "edge" or "face") and its vertices, as a tuple in the
order of the solid for a vertex and an edge; a face has the tuple that it is declared with.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Dict, FrozenSet, List, Sequence, Tuple

from vectors import ZERO, Matrix, Vector, add, apply, cross, dot, scale, sub

Feature = Tuple[str, Tuple[str, ...]]


class Solid:
    """A template seen through an affine map: vertices with places, faces with names."""

    def __init__(
        self,
        vertices: Sequence[Tuple[str, Vector]],
        faces: Sequence[Tuple[str, Tuple[str, ...]]],
    ) -> None:
        self.names = [name for name, _ in vertices]
        self.place: Dict[str, Vector] = dict(vertices)
        self.faces = list(faces)
        order = {name: i for i, name in enumerate(self.names)}
        self.order = order
        edges = set()
        for _, corners in self.faces:
            for u, w in zip(corners, corners[1:] + corners[:1]):
                edges.add((u, w) if order[u] < order[w] else (w, u))
        self.edges: List[Tuple[str, str]] = sorted(edges, key=lambda e: (order[e[0]], order[e[1]]))

        self._key = (tuple(self.place.items()), tuple(self.faces))
        self._hash = hash(self._key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Solid) and self._key == other._key

    def __hash__(self) -> int:
        return self._hash

    # Features.

    def features(self) -> List[Feature]:
        """All features: vertices, edges (unordered, I-1), faces."""
        return (
            [("vertex", (v,)) for v in self.names]
            + [("edge", e) for e in self.edges]
            + [("face", corners) for _, corners in self.faces]
        )

    def by_vertices(self, corners: Sequence[str]) -> Feature:
        """The feature that is given by its vertices; faces in any rotation (Definition 4.1)."""
        corners = tuple(corners)
        if len(corners) == 1:
            return self.named(corners[0])
        if len(corners) == 2:
            u, w = sorted(corners, key=lambda v: self.order[v])
            if (u, w) not in self.edges:
                raise ValueError("no such edge: %s" % (corners,))
            return ("edge", (u, w))
        for _, face in self.faces:
            for i in range(len(face)):
                if face[i:] + face[:i] == corners:
                    return ("face", face)
        raise ValueError("no such face: %s" % (corners,))

    def named(self, name: str) -> Feature:
        for face, corners in self.faces:
            if face == name:
                return ("face", corners)
        if name in self.place:
            return ("vertex", (name,))
        raise ValueError("no such feature: %s" % name)

    def closure(self, features: FrozenSet[Feature]) -> FrozenSet[Feature]:
        """Definition 4.2."""
        found = set(features)
        for kind, corners in features:
            if kind == "face":
                for u, w in zip(corners, corners[1:] + corners[:1]):
                    found.add(self.by_vertices((u, w)))
            for v in corners:
                found.add(("vertex", (v,)))
        return frozenset(found)

    def text(self, feature: Feature) -> str:
        """A feature as labels have it: a face by its name, an edge as [u,w], a vertex."""
        kind, corners = feature
        if kind == "face":
            return next(name for name, face in self.faces if face == corners)
        return corners[0] if kind == "vertex" else "[%s,%s]" % corners

    def points(self, feature: Feature) -> List[Vector]:
        return [self.place[v] for v in feature[1]]

    # Geometry.

    def normals(self) -> List[Vector]:
        """Outward normals of the faces, of any length."""
        found = []
        for _, corners in self.faces:
            a, b, c = (self.place[v] for v in corners[:3])
            found.append(cross(sub(b, a), sub(c, b)))
        return found

    def mapped(self, linear: Matrix, offset: Vector = ZERO) -> "Solid":
        return Solid(
            [(v, add(apply(linear, p), offset)) for v, p in self.place.items()], self.faces
        )

    def volume_and_centroid(self) -> Tuple[Fraction, Vector]:
        """Sums over signed tetrahedra from the origin (rule Mass)."""
        volume, moment = Fraction(0), ZERO
        for _, corners in self.faces:
            a = self.place[corners[0]]
            for u, w in zip(corners[1:], corners[2:]):
                b, c = self.place[u], self.place[w]
                six = dot(a, cross(b, c))
                volume += Fraction(six) / 6
                moment = add(moment, scale(Fraction(six) / 24, add(a, add(b, c))))
        return volume, scale(1 / volume, moment)
