"""Which service a shape or a model is of: all of them number theirs alike, so that another one would take it for its own."""

from __future__ import annotations

import dataclasses
import uuid
from typing import Any, Iterator, Mapping, Optional

from .geometry import Shape
from .models import Model


class Handle(str):
    """The name that a service has for a shape or model; ``owner`` tells the service."""

    owner: str

    def __new__(cls, name: str, owner: str) -> Handle:
        handle = super().__new__(cls, name)
        handle.owner = owner
        return handle

    def __reduce__(self) -> Any:
        return (Handle, (str(self), self.owner))


def new_owner() -> str:
    """Of no other service, in no other process either."""
    return uuid.uuid4().hex


def owned(answer: Any, owner: str) -> Any:
    """The answer of a service, which is to be asked with it."""
    if isinstance(answer, (Shape, Model)):
        return dataclasses.replace(answer, handle=Handle(answer.handle, owner))
    return answer


def check(handle: Optional[str], owner: str) -> None:
    """ValueError for what another service made; a plain text is taken as it is."""
    if isinstance(handle, Handle) and handle.owner != owner:
        raise ValueError("%r is a shape or model of another Oracle: each has its own, so make it with this one" % str(handle))


def _named(params: Mapping[str, Any]) -> Iterator[Any]:
    for name in ("a", "b", "shape", "model"):
        yield params.get(name)


def check_all(params: Mapping[str, Any], owner: str) -> None:
    """``check`` of whatever is named in a request."""
    for handle in _named(params):
        check(handle, owner)
    for touch in params.get("touching", ()):
        for handle in _named(touch):
            check(handle, owner)
