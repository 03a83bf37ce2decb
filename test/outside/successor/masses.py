"""Tensors of inertia (rule Mass)."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from solids import Solid
from vectors import ZERO, Matrix, Vector, add, cross, dot, scale, sub

NOTHING: Matrix = (ZERO, ZERO, ZERO)


def plus(m: Matrix, n: Matrix) -> Matrix:
    return tuple(add(a, b) for a, b in zip(m, n))  # type: ignore[return-value]


def product_of(a: Vector, b: Vector) -> Matrix:
    return tuple(scale(x, b) for x in a)  # type: ignore[return-value]


def second_moment(solid: Solid, mass: Any, about: Vector) -> Matrix:
    """The integral of x x^T over a uniform solid of this mass, x from a point."""
    total, volume = NOTHING, Fraction(0)
    for _, corners in solid.faces:
        a = sub(solid.place[corners[0]], about)
        for u, w in zip(corners[1:], corners[2:]):
            b, c = sub(solid.place[u], about), sub(solid.place[w], about)
            six = dot(a, cross(b, c))
            volume += Fraction(six) / 6
            whole_sum = add(a, add(b, c))
            inner = product_of(whole_sum, whole_sum)
            for x in (a, b, c):
                inner = plus(inner, product_of(x, x))
            total = plus(total, tuple(scale(Fraction(six) / 120, r) for r in inner))  # type: ignore
    return tuple(scale(Fraction(mass) / volume, r) for r in total)  # type: ignore[return-value]


def from_moment(m: Matrix) -> Matrix:
    trace = m[0][0] + m[1][1] + m[2][2]
    rows = [[(trace if i == j else 0) - m[i][j] for j in range(3)] for i in range(3)]
    return tuple(tuple(row) for row in rows)  # type: ignore[return-value]


def point_inertia(mass: Any, r: Vector) -> Matrix:
    return from_moment(tuple(scale(mass, row) for row in product_of(r, r)))  # type: ignore


