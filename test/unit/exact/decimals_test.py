"""Decimals of scc against Python's decimal: decimals_test.py DECIMALS [CASES].

Numbers of all sizes, ties and their neighbours on both sides, and those that round up to a power of ten.
"""

import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import decimals

draw = random.Random(19)


def number():
    sign = draw.choice([1, 1, -1])
    shift = Fraction(10) ** draw.choice([0, 0, 0, 1, 3, -3, 5, -6, 8, 9, 12, -13, 40, -40, 400, -400])
    digits = draw.randrange(1, 15)
    whole = draw.choice([draw.randrange(10**digits), 10**digits - 1, 10**digits, 10**digits + 1])
    tail = draw.choice([
        Fraction(0), Fraction(1, 2), Fraction(1, 2) + Fraction(1, 10**60), Fraction(1, 2) - Fraction(1, 10**60),
        Fraction(1, 10**draw.randrange(1, 30)), 1 - Fraction(1, 10**draw.randrange(1, 30)),
        Fraction(draw.randrange(1, 999), 999), Fraction(draw.randrange(1, 10**20), 10**20),
        Fraction(19999999, 20000000),
    ])
    return sign * (whole + tail) * shift


def questions(count):
    hand = [Fraction(199999999999, 100), 1 - Fraction(1, 10**9), Fraction(99999995, 10**7), Fraction(0),
            Fraction(1, 2),
            Fraction(-1, 10**7), Fraction(-5, 10**7), Fraction(10**60), Fraction(10**60 + 1), Fraction(1, 10**70),
            Fraction(10**9), Fraction(10**9) - Fraction(1, 10**7), Fraction(1, 1000) - Fraction(1, 10**12)]
    for i in range(count):
        x = hand[i] if i < len(hand) else number()
        for what in ("fixed", "padded", "down", "up", "significant", "marked", "exact"):
            yield what, draw.randrange(1, 13), x
        yield "above", draw.randrange(1, 13), abs(x)


def main():
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    asked = list(questions(count))
    lines = "".join(f"{what} {digits} {x.numerator}/{x.denominator}\n" for what, digits, x in asked)
    scc = subprocess.run([Path(sys.argv[1]).resolve()], input=lines, stdout=subprocess.PIPE, text=True, check=True)
    answers = scc.stdout.splitlines()
    assert len(answers) == len(asked), (len(answers), len(asked))
    wrong = 0
    for (what, digits, x), found in zip(asked, answers):
        expected = getattr(decimals, what)(x, digits)
        if found != expected:
            wrong += 1
            if wrong <= 10:
                print(f"{what} {digits} of {x}: {found}, and not {expected}")
    assert not wrong, f"{wrong} of {len(asked)} decimals are wrong"
    print(f"{len(asked)} decimals are as Python's")


if __name__ == "__main__":
    main()
