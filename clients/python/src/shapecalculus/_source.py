"""What a command reads: a model by its path, as a text, or loaded by an oracle; and the words of its options."""

from __future__ import annotations

import contextlib
import os
import tempfile
from typing import Generator, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from . import numbers
from .models import Model
from .numbers import Number

#: The path of a file.
Path = Union[str, "os.PathLike[str]"]
#: A model: the path of a file, the text of a model, or what ``Oracle.load_model`` returned. A ``str`` with a line end,
#: or an empty one, is a text; each other ``str`` is a path.
Source = Union[str, "os.PathLike[str]", Model]
#: Of a parameter: its value, or the two ends of a range, or a text as ``-D`` takes it: ``"[1,3)"``.
Setting = Union[Number, Tuple[Number, Number]]
#: Of a parameter of a sweep: its values, or a text as ``-D`` takes it: ``"1..10"``, ``"0:2:1/8"``.
Values = Union[str, Sequence[Number], "range"]
#: One, or several.
Texts = Union[str, Iterable[str]]

STANDARD_INPUT = "<standard input>"


def _written(folder: str, model: Model) -> str:
    """Writes the texts to the folder. The path of the model."""
    main = "model.sc"
    while main in model.files:
        main = "_" + main
    for name, text in {**model.files, main: model.text}.items():
        inside = os.path.normpath(name)
        if os.path.isabs(inside) or inside.split(os.sep)[0] == os.pardir:
            raise ValueError("a file of a model is not below its folder: %r" % name)
        path = os.path.join(folder, inside)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(text)
    return os.path.join(folder, main)


@contextlib.contextmanager
def argument(model: Source) -> Generator[Tuple[str, Optional[str]], None, None]:
    """The argument of a command for it, and what the command reads. Texts with files beside them are written to a
    folder, until the command has ended."""
    if not isinstance(model, (str, os.PathLike, Model)):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise TypeError("no model: %r; a model is a path, a text or a Model" % (model,))
    if isinstance(model, Model):
        if model.files:
            with tempfile.TemporaryDirectory(prefix="shapecalculus-") as folder:
                yield _written(folder, model), None
        else:
            yield "-", model.text
    elif isinstance(model, str) and (model == "" or "\n" in model or "\r" in model):
        yield "-", model
    else:
        path = os.fspath(model)
        # scc reads standard input for "-", and takes what begins so for an option.
        yield os.path.join(".", path) if path.startswith("-") else path, None


# Options: the words of the command line. None, False and nothing have none.


def flag(name: str, value: bool) -> List[str]:
    if not isinstance(value, bool):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise TypeError("%s is True or False, not %r" % (name, value))
    return [name] if value else []


def _one(name: str, text: str) -> List[str]:
    return ["%s=%s" % (name, text)]


def number(name: str, value: Optional[Number]) -> List[str]:
    return [] if value is None else _one(name, str(numbers.to_json(value)))


def seconds(name: str, value: Optional[Number]) -> List[str]:
    """Of the clock: as decimals, since nothing depends on them exactly."""
    return [] if value is None else _one(name, repr(float(numbers.exact(value))))


def integer(name: str, value: Optional[int]) -> List[str]:
    return [] if value is None else _one(name, numbers.digits(numbers.integer(value)))


def text(name: str, value: Optional[str]) -> List[str]:
    if value is not None and not isinstance(value, str):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise TypeError("%s is a text, not %r" % (name, value))
    return [] if value is None else _one(name, value)


def path(name: str, value: Optional[Path]) -> List[str]:
    return [] if value is None else _one(name, os.fspath(value))


def texts(name: str, value: Optional[Texts]) -> List[str]:
    """An option that may be given several times."""
    several: Iterable[str] = [] if value is None else [value] if isinstance(value, str) else value
    return [word for one in several for word in text(name, one)]


def listed(name: str, value: Optional[Texts]) -> List[str]:
    """An option with names between commas."""
    return [] if value is None else _one(name, value if isinstance(value, str) else ",".join(value))


def numbered(name: str, value: Union[None, str, Sequence[Number]]) -> List[str]:
    """An option with numbers between commas."""
    if value is None or isinstance(value, str):
        return text(name, value)
    return _one(name, ",".join(str(numbers.to_json(x)) for x in value))


def other(name: str, value: Union[None, Number, Path]) -> List[str]:
    """An option with a value of its own."""
    if isinstance(value, os.PathLike):
        return path(name, value)
    return text(name, value) if value is None or isinstance(value, str) else number(name, value)


def each(name: str, value: Optional[Mapping[str, Number]]) -> List[str]:
    """An option with a number for a name."""
    return [w for key, x in (value or {}).items() for w in _one(name, "%s=%s" % (key, numbers.to_json(x)))]


def _loaded(model: Source) -> Mapping[str, Number]:
    return model.given if isinstance(model, Model) else {}


def define(model: Source, value: Optional[Mapping[str, Setting]]) -> List[str]:
    """Parameters, with their values or ranges: those with which the model was loaded, but for what is given."""
    words: List[str] = []
    for name, setting in {**_loaded(model), **(value or {})}.items():
        if isinstance(setting, str):
            said = setting
        elif isinstance(setting, (tuple, list)):
            ends: Sequence[Number] = setting
            said = "[%s]" % ",".join(str(numbers.to_json(end)) for end in ends)
        else:
            said = str(numbers.to_json(setting))
        words += _one("--define", "%s=%s" % (name, said))
    return words


def grid(model: Source, value: Mapping[str, Values]) -> List[str]:
    """Parameters, with the values of each: those with which the model was loaded, but for what is given."""
    words: List[str] = []
    given: Mapping[str, Values] = {**{name: [x] for name, x in _loaded(model).items()}, **value}
    if not given:
        raise ValueError("a sweep needs a parameter with its values, as in {'n': [1, 2, 5]} or {'n': '1..10'}")
    for name, values in given.items():
        if len(values) == 0:
            raise ValueError("the parameter %s has no values: a sweep needs one or more" % name)
        said = values if isinstance(values, str) else ",".join(str(numbers.to_json(x)) for x in values)
        words += _one("--define", "%s=%s" % (name, said))
    return words
