"""How a body turns (rule Turn): the Cayley map, and quaternions of whole numbers."""

from __future__ import annotations

from fractions import Fraction
from math import comb, gcd, lcm
from typing import Any, List, Sequence, Tuple

from model import rotation
from vectors import Matrix, Vector, cross, dot

Quaternion = Tuple[int, int, int, int]
Polynomial = List[Fraction]

STILL: Quaternion = (1, 0, 0, 0)


def cayley(u: Vector) -> Matrix:
    """C(u), the matrix of the quaternion 1 + u: it turns by 2 atan|u| about u."""
    return rotation([Fraction(1), *u])


def product(p: Sequence, q: Sequence) -> Tuple:
    """The quaternion product: q first, then p."""
    u, v = tuple(p[1:]), tuple(q[1:])
    w = cross(u, v)
    return (p[0] * q[0] - dot(u, v),) + tuple(p[0] * b + q[0] * a + c for a, b, c in zip(u, v, w))


def whole(q: Sequence) -> Quaternion:
    """The same rotation as integers without a common factor, the first that is not 0 positive."""
    q = [Fraction(x) for x in q]
    common = 1
    for x in q:
        common = common * x.denominator // gcd(common, x.denominator)
    ints = [int(x * common) for x in q]
    divisor = 0
    for x in ints:
        divisor = gcd(divisor, x)
    sign = 1 if next(x for x in ints if x) > 0 else -1
    return tuple(sign * x // divisor for x in ints)  # type: ignore[return-value]


def inverse(q: Sequence) -> Tuple:
    return (q[0], -q[1], -q[2], -q[3])


# Polynomials in time, the constant first.


def plus(p: Polynomial, q: Polynomial) -> Polynomial:
    n = max(len(p), len(q))
    return [(p[i] if i < len(p) else 0) + (q[i] if i < len(q) else 0) for i in range(n)]


def times(p: Polynomial, q: Polynomial) -> Polynomial:
    found: List[Any] = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            found[i + j] += a * b
    return found


def minus(p: Polynomial) -> Polynomial:
    return [-a for a in p]


def integers(*polynomials: Polynomial) -> List[Polynomial]:
    """The same polynomials, all times one positive number, with whole coefficients."""
    common = lcm(*(int(a.denominator) for p in polynomials for a in p))
    return [[int(a * common) for a in p] for p in polynomials]


class Flight:
    """A body that turns about a centre: where its points are at the time t from now.

    A point that was at r from the centre when the turn began, ``since`` ago, is at
    ``centre + velocity t + C(spin (since + t) / 2) r``. With D = 1 + |spin|^2 (since + t)^2 / 4
    and M = D C both are polynomials in t; both are kept times a number that makes them whole.
    """

    def __init__(self, centre: Vector, velocity: Vector, spin: Vector, since: Fraction) -> None:
        self.centre, self.velocity, self.spin, self.since = centre, velocity, spin, since
        half = tuple(Fraction(x) / 2 for x in spin)
        s = Fraction(since)
        square = dot(half, half)
        tau = [s, Fraction(1)]
        tau2 = times(tau, tau)
        self.d: Polynomial = plus([Fraction(1)], times([square], tau2))
        self.m: List[List[Polynomial]] = []
        skew = [
            [Fraction(0), -half[2], half[1]],
            [half[2], Fraction(0), -half[0]],
            [-half[1], half[0], Fraction(0)],
        ]
        for i in range(3):
            row = []
            for j in range(3):
                entry = times([2 * half[i] * half[j]], tau2)
                entry = plus(entry, times([2 * skew[i][j]], tau))
                if i == j:
                    entry = plus(entry, plus([Fraction(1)], times([-square], tau2)))
                row.append(entry)
            self.m.append(row)
        self.d, *entries = integers(self.d, *(entry for row in self.m for entry in row))
        self.m = [entries[i : i + 3] for i in (0, 3, 6)]

    def turned(self, r: Vector) -> List[Polynomial]:
        """M r, of a vector as it was when the turn began."""
        found = []
        for row in self.m:
            total: Polynomial = [0]  # type: ignore[list-item]
            for entry, x in zip(row, r):
                if x:
                    total = plus(total, [x * a for a in entry])
            found.append(total)
        return found

    def at(self, t: Fraction) -> Tuple[Matrix, Vector]:
        """The turn so far, and where the centre is."""
        half = tuple(Fraction(x) * (self.since + t) / 2 for x in self.spin)
        centre = tuple(c + v * t for c, v in zip(self.centre, self.velocity))
        return cayley(half), centre  # type: ignore[return-value,arg-type]


def inner(p: Sequence[Polynomial], q: Sequence[Polynomial]) -> Polynomial:
    total: Polynomial = [0]  # type: ignore[list-item]
    for a, b in zip(p, q):
        total = plus(total, times(a, b))
    return total


def outer(p: Sequence[Polynomial], q: Sequence[Polynomial]) -> List[Polynomial]:
    def entry(i: int, j: int) -> Polynomial:
        return plus(times(p[i], q[j]), minus(times(p[j], q[i])))

    return [entry(1, 2), entry(2, 0), entry(0, 1)]


# Signs.


def never_negative(p: Polynomial, low: Fraction, high: Fraction) -> bool:
    """Whether p >= 0 on [low, high], exactly."""
    b = bernstein(p, low, high)
    return _never_negative(b, 40)


def _never_negative(b: List[int], depth: int) -> bool:
    if b[0] < 0 or b[-1] < 0:
        return False
    if all(x >= 0 for x in b):
        return True
    if depth == 0:
        raise Undecided("a root that is hardly one")
    left, right = split(b)
    return _never_negative(left, depth - 1) and _never_negative(right, depth - 1)


class Undecided(Exception):
    """More digits would be needed than are tried."""


def bernstein(p: Polynomial, low: Fraction, high: Fraction) -> List[int]:
    """The coefficients in Bernstein's form on [low, high] of a positive multiple of p, whole."""
    n = len(p) - 1
    (whole_p,) = integers(p)
    common = lcm(int(low.denominator), int(high.denominator))
    start, width = int(low * common), int((high - low) * common)
    shifted = [0] * (n + 1)
    for i, a in enumerate(whole_p):  # p((start + width x) / common), times common^n
        for k in range(i + 1):
            shifted[k] += a * comb(i, k) * start ** (i - k) * width**k * common ** (n - i)
    weight = lcm(*(comb(n, k) for k in range(n + 1)))
    scaled = [s * (weight // comb(n, k)) for k, s in enumerate(shifted)]
    return [sum(comb(i, k) * scaled[k] for k in range(i + 1)) for i in range(n + 1)]


def split(b: List[int]) -> Tuple[List[int], List[int]]:
    """De Casteljau's halves, both times 2^n."""
    n, row = len(b) - 1, b
    left, right = [b[0] << n], [b[-1] << n]
    while len(row) > 1:
        row = [x + y for x, y in zip(row, row[1:])]
        left.append(row[0] << (len(row) - 1))
        right.append(row[-1] << (len(row) - 1))
    return left, right[::-1]
