"""Chances of rates (rule Lot): the exponential function, by fractions alone."""

from __future__ import annotations

from fractions import Fraction
from typing import Optional, Tuple

CLOSE = Fraction(1, 2**40)
GREATEST = 1000


def chance_of_rate(
    rate: Fraction, step: Fraction, greatest: Optional[int] = GREATEST
) -> Optional[Fraction]:
    """The fraction of the least denominator near enough to 1 - exp(-rate step); None for a rate
    that may not be written."""
    x = rate * step
    if x < 0 or (greatest is not None and x > greatest):
        return None
    if x == 0:
        return Fraction(0)
    bits = 64
    while True:
        low, high = survival(x, bits)  # of exp(-x)
        spans = []
        for v in (1 - high, 1 - low):
            room = CLOSE * min(v, 1 - v)
            spans.append((v - room, v + room))
        (a, b), (c, d) = spans
        # v is between 1 - high and 1 - low, and both ends of what is near enough grow with it
        if low > 0 and c < b:
            inner, outer = simplest(c, b), simplest(a, d)
            if inner == outer:
                return inner
        bits *= 2


def survival(x: Fraction, bits: int) -> Tuple[Fraction, Fraction]:
    """Bounds of exp(-x), x > 0: 1 over those of exp(x / 2^k), squared k times."""
    k = 0
    while x > 1:
        x, k = x / 2, k + 1
    # the sum of x^n / n! up to a term t is less than exp(x) by at most 2t, as x <= 1
    total, term, n = Fraction(1), Fraction(1), 0
    while term > Fraction(1, 2 ** (bits + 1)):
        n += 1
        term = term * x / n
        total += term
    low, high = total, total + 2 * term
    unit = 2 ** (bits + 4)
    for i in range(k + 1):
        low, high = Fraction(low * unit // 1, unit), Fraction(-(-high * unit // 1), unit)
        if i < k:
            low, high = low * low, high * high
    return 1 / high, 1 / low


def simplest(low: Fraction, high: Fraction) -> Fraction:
    """The fraction of the least denominator, then the least one, between two positive numbers."""
    whole = low // 1
    if whole + 1 < high:
        return Fraction(whole + 1)
    if low == whole:
        # whole + 1/n < high for the least n
        n = 1 / (high - whole) // 1 + 1
        return whole + Fraction(1, int(n))
    return whole + 1 / simplest(1 / (high - whole), 1 / (low - whole))
