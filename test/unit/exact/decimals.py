"""Decimals for people, by Python's decimal, which divides and rounds once: what scc and its pages are held to."""

import decimal
from decimal import Decimal
from fractions import Fraction


def divided(x, digits, rounding):
    """The number to so many significant digits."""
    context = decimal.Context(prec=digits, rounding=rounding, Emin=decimal.MIN_EMIN, Emax=decimal.MAX_EMAX)
    return context.divide(Decimal(x.numerator), Decimal(x.denominator))


def first(x):
    """The power of ten of the first digit."""
    return divided(x, 1, decimal.ROUND_DOWN).adjusted()


def placed(x, places):
    """The number to so many places."""
    digits = first(x) + 1 + places if x else 0
    if digits > 0:
        return divided(x, digits, decimal.ROUND_HALF_UP)
    unit = Decimal((int(x < 0), (1,), -places))
    return unit if digits == 0 and 2 * abs(x) * 10**places >= 1 else Decimal(0)


def is_it(x, text):
    return Fraction(text) == x


def stripped(text):
    """Without zeros at the end of a fraction."""
    digits, e, power = text.partition("e")
    return (digits.rstrip("0").rstrip(".") if "." in digits else digits) + e + power


def fixed(x, places):
    return stripped(padded(x, places))


def padded(x, places):
    return f"{placed(x, places):.{places}f}"


def down(x, places):
    return fixed(Fraction(x.numerator * 10**places // x.denominator, 10**places), places)


def up(x, places):
    return fixed(-Fraction(-x.numerator * 10**places // x.denominator, 10**places), places)


def with_power(number, digits):
    sign, found, _ = number.as_tuple()
    found = "".join(map(str, found)).ljust(digits, "0")
    return f"{'-' * sign}{found[0]}{'.' * (digits > 1)}{found[1:]}e{number.adjusted()}"


def significant(x, digits, rounding=decimal.ROUND_HALF_UP):
    if not x:
        return "0"
    number = divided(x, digits, rounding)
    return stripped(with_power(number, digits) if not -5 <= number.adjusted() <= 8 else f"{number:f}")


def above(x, digits):
    return significant(x, digits, decimal.ROUND_CEILING)


def marked(x, _):
    plain = not x or Fraction(1, 1000) <= abs(x) < 10**9
    text = padded(x, 6) if plain else with_power(divided(x, 7, decimal.ROUND_HALF_UP), 7)
    return stripped(text) if is_it(x, text) else "~" + text


def exact(x, _):
    text = fixed(x, 12)
    return text if is_it(x, text) else "none"
