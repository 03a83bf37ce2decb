"""Exact vectors of three numbers, and the little linear algebra that the rules need."""

from __future__ import annotations

from fractions import Fraction
from math import gcd, lcm
from typing import List, Optional, Sequence, Tuple

Vector = Tuple[Fraction, Fraction, Fraction]
Matrix = Tuple[Vector, Vector, Vector]

ZERO: Vector = (Fraction(0), Fraction(0), Fraction(0))
IDENTITY: Matrix = (
    (Fraction(1), Fraction(0), Fraction(0)),
    (Fraction(0), Fraction(1), Fraction(0)),
    (Fraction(0), Fraction(0), Fraction(1)),
)


def add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(k, a: Vector) -> Vector:
    return (k * a[0], k * a[1], k * a[2])


def dot(a: Vector, b: Vector):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def apply(m: Matrix, a: Vector) -> Vector:
    return (dot(m[0], a), dot(m[1], a), dot(m[2], a))


def multiply(m: Matrix, n: Matrix) -> Matrix:
    columns = transpose(n)
    return tuple(tuple(dot(row, c) for c in columns) for row in m)  # type: ignore[return-value]


def transpose(m: Matrix) -> Matrix:
    return tuple(zip(*m))  # type: ignore[return-value]


def primitive(a: Vector) -> Optional[Vector]:
    """The shortest integer vector of the same direction; None for the zero vector."""
    common = lcm(*(x.denominator for x in a))
    whole = [int(x * common) for x in a]
    divisor = gcd(*whole)
    if divisor == 0:
        return None
    return (whole[0] // divisor, whole[1] // divisor, whole[2] // divisor)  # type: ignore


def solve(
    rows: Sequence[Sequence[Fraction]], right: Sequence[Fraction]
) -> Optional[List[Fraction]]:
    """The solution of a square system; None where it is singular."""
    n = len(rows)
    a = [[Fraction(x) for x in row] + [Fraction(b)] for row, b in zip(rows, right)]
    for i in range(n):
        pivot = next((r for r in range(i, n) if a[r][i] != 0), None)
        if pivot is None:
            return None
        a[i], a[pivot] = a[pivot], a[i]
        a[i] = [x / a[i][i] for x in a[i]]
        for r in range(n):
            if r != i and a[r][i] != 0:
                k = a[r][i]
                a[r] = [x - k * y for x, y in zip(a[r], a[i])]
    return [a[i][n] for i in range(n)]


def rank(vectors: Sequence[Vector]) -> int:
    """The dimension of what the vectors span."""
    first = next((v for v in vectors if v != ZERO), None)
    if first is None:
        return 0
    normals = [cross(first, v) for v in vectors]
    normal = next((n for n in normals if n != ZERO), None)
    if normal is None:
        return 1
    return 3 if any(dot(normal, v) != 0 for v in vectors) else 2
