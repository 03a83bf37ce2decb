"""Exact numbers and vectors, as requests and answers have them."""

from __future__ import annotations

import operator
from decimal import Decimal
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


# Of requests.


def integer(number: SupportsIndex) -> int:
    """An integer of any library. TypeError for all else, also for floats: nothing is rounded."""
    try:
        return operator.index(number)
    except TypeError as error:
        raise TypeError("not an integer: %r, of the type %s" % (number, type(number).__name__)) from error


def _exact(number: Number) -> Fraction:
    if isinstance(number, (str, float, Decimal, Fraction)):
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


def to_json(number: Number) -> Union[int, str]:
    """A number as requests have it. ValueError for NaN, infinities and texts that are no number, else TypeError."""
    kind = type(number)
    if kind is int:
        return number  # type: ignore[return-value]
    try:
        value = _exact(number)
    except (OverflowError, ZeroDivisionError, ValueError) as error:
        raise ValueError("not a number: %r" % (number,)) from error
    if value.denominator == 1:
        return value.numerator
    return "%d/%d" % (value.numerator, value.denominator)


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
    if type(number) is int:
        return str(number)
    if type(number) is Fraction:
        return '"%d/%d"' % (number.numerator, number.denominator)
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
        return "%d,%d,%d" % (x, y, z)
    return "%s,%s,%s" % (to_text(x), to_text(y), to_text(z))


# Of answers.


def _integer(text: str) -> int:
    # Python reads no integers of more than 4300 digits, but decimals of any length.
    return int(text) if len(text) < 4000 else int(Decimal(text))


def fraction(text: str) -> Fraction:
    """Of "p/q"."""
    p, _, q = text.partition("/")
    return Fraction(_integer(p), _integer(q))


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
