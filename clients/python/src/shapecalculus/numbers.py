"""Exact numbers and vectors, as requests and answers have them."""

from __future__ import annotations

import operator
import re
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal, InvalidOperation
from fractions import Fraction
from numbers import Rational
from typing import Any, List, Sequence, SupportsIndex, Tuple, Union

#: A number of a request. All are taken exactly: the float 0.1 is 3602879701896397/36028797018963968, and the text
#: "0.1" is 1/10. So are the integers, rationals and floats of other libraries, as numpy's: whatever has ``__index__`` or
#: ``as_integer_ratio``, or is a ``numbers.Rational``.
Number = Union[int, float, Fraction, Decimal, str, SupportsIndex, Rational, Any]
#: Three numbers.
VectorLike = Sequence[Number]
#: Four, w x y z, of any length but zero.
QuaternionLike = Sequence[Number]
#: Three rows.
MatrixLike = Sequence[VectorLike]

#: In answers.
Vector = Tuple[Fraction, Fraction, Fraction]
Matrix = Tuple[Vector, Vector, Vector]
Quaternion = Tuple[int, int, int, int]


# Python reads and writes no integers of more than 4300 digits, and of more than 640 where its user says so; but it does
# so with decimals of any length.
_DIGITS = 600
_BITS = 1990
#: From so many digits on an answer is a LongFraction.
_LONG = 4000
_QUOTIENT = re.compile(r"\s*([-+]?[0-9]+)/([0-9]+)\s*")

# Decimals with room for every exponent; a float has not.
_ROUNDED = Context(prec=6, Emax=MAX_EMAX, Emin=MIN_EMIN)


def digits(number: int) -> str:
    """All of them, however many."""
    return str(number) if number.bit_length() < _BITS else format(Decimal(number), "f")


def rounded(number: Union[int, Fraction]) -> str:
    """A decimal of six digits."""
    p, q = _ROUNDED.create_decimal(number.numerator), _ROUNDED.create_decimal(number.denominator)
    return str(_ROUNDED.normalize(_ROUNDED.divide(p, q)))


class LongFraction(Fraction):
    """A Fraction of an answer with so many digits that Python would not write it: as a text it is rounded."""

    def __str__(self) -> str:
        return "≈ " + rounded(self)

    def __repr__(self) -> str:
        return "<Fraction %s>" % self

    def __reduce__(self) -> Any:
        return (LongFraction, (self.numerator, self.denominator))


# Of requests.


def integer(number: SupportsIndex) -> int:
    """An integer of any library. TypeError for all else, also for floats: nothing is rounded."""
    try:
        return operator.index(number)
    except TypeError as error:
        raise TypeError("not an integer: %r, of the type %s" % (number, type(number).__name__)) from error


def _read(text: str) -> Fraction:
    if len(text) < _DIGITS:
        return Fraction(text)
    quotient = _QUOTIENT.fullmatch(text)
    return Fraction(_integer(quotient[1]), _integer(quotient[2])) if quotient else Fraction(Decimal(text))


def _exact(number: Number) -> Fraction:
    if isinstance(number, str):
        return _read(number)
    if isinstance(number, (float, Decimal, Fraction)):
        return Fraction(number)
    like: Any = number
    if hasattr(like, "__index__"):
        try:
            return Fraction(operator.index(like))
        except TypeError:
            pass  # an array of several numbers, say
    if isinstance(like, Rational):
        return Fraction(int(like.numerator), int(like.denominator))
    if hasattr(like, "as_integer_ratio"):
        p, q = like.as_integer_ratio()
        return Fraction(int(p), int(q))
    raise TypeError(
        "not a number: %r, of the type %s; numbers are int, float, Fraction, Decimal, texts as '1/3' and '0.25', and "
        "what has __index__ or as_integer_ratio" % (number, type(number).__name__)
    )


def exact(number: Number) -> Fraction:
    """A number of a request. ValueError for NaN, infinities and texts that are no number, else TypeError."""
    try:
        return _exact(number)
    except (OverflowError, ZeroDivisionError, ValueError, InvalidOperation) as error:
        raise ValueError("not a number: %r" % (number,)) from error


def _int_to_json(number: int) -> Union[int, str]:
    return number if number.bit_length() < _BITS else digits(number)


def to_json(number: Number) -> Union[int, str]:
    """A number as requests have it: an integer, or a text. Errors are those of ``exact``."""
    if type(number) is int:
        return _int_to_json(number)
    value = exact(number)
    if value.denominator == 1:
        return _int_to_json(value.numerator)
    return "%s/%s" % (digits(value.numerator), digits(value.denominator))


def _several(numbers: Sequence[Number], count: int) -> List[Union[int, str]]:
    if len(numbers) != count or isinstance(numbers, str):
        raise ValueError("not %d numbers: %r" % (count, numbers))
    return [to_json(x) for x in numbers]


def vector_to_json(vector: VectorLike) -> List[Union[int, str]]:
    return _several(vector, 3)


def quaternion_to_json(quaternion: QuaternionLike) -> List[Union[int, str]]:
    return _several(quaternion, 4)


def matrix_to_json(matrix: MatrixLike) -> List[List[Union[int, str]]]:
    if len(matrix) != 3:
        raise ValueError("not three rows: %r" % (matrix,))
    return [vector_to_json(row) for row in matrix]


def to_text(number: Number) -> str:
    """``to_json`` as JSON text, for requests by the thousand."""
    try:
        if type(number) is int:
            return str(number)
        if type(number) is Fraction:
            return '"%d/%d"' % (number.numerator, number.denominator)
    except ValueError:  # too many digits
        return '"%s"' % to_json(number)
    if type(number) is float:
        try:
            return '"%d/%d"' % number.as_integer_ratio()
        except OverflowError as error:
            raise ValueError("not a number: %r" % number) from error
    value = to_json(number)
    return str(value) if type(value) is int else '"%s"' % value


def vector_to_text(vector: VectorLike) -> str:
    if isinstance(vector, str) or len(vector) != 3:
        raise ValueError("not 3 numbers: %r" % (vector,))
    x, y, z = vector
    if type(x) is type(y) is type(z) is int:
        try:
            return "%d,%d,%d" % (x, y, z)
        except ValueError:  # too many digits
            pass
    return "%s,%s,%s" % (to_text(x), to_text(y), to_text(z))


# Of answers.


def _integer(text: str) -> int:
    return int(text) if len(text) < _DIGITS else int(Decimal(text))


def fraction(text: str) -> Fraction:
    """Of "p/q"."""
    p, _, q = text.partition("/")
    kind = Fraction if max(len(p), len(q)) < _LONG else LongFraction
    return kind(_integer(p), _integer(q))


def decimal(text: str) -> Fraction:
    """Of a text with decimals."""
    value = Fraction(Decimal(text))
    return value if len(text) < _LONG else LongFraction(value)


def vector(json: Sequence[str]) -> Vector:
    x, y, z = json
    return (fraction(x), fraction(y), fraction(z))


def matrix(json: Sequence[Sequence[str]]) -> Matrix:
    x, y, z = json
    return (vector(x), vector(y), vector(z))


def quaternion(json: Sequence[str]) -> Quaternion:
    w, x, y, z = json
    return (_integer(w), _integer(x), _integer(y), _integer(z))


def time(json: Any) -> Fraction:
    """Of {"exact", "float"}; the float is that of the fraction, which Python rounds as well."""
    return fraction(json["exact"])
