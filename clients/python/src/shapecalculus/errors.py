"""What can go wrong, as exceptions.

OracleError
    ServiceError        the service cannot be started, has ended, or is too slow: make a new Oracle
    RequestError        the service refuses a request, and goes on: code, message, data; one class for each code
"""

from __future__ import annotations

from typing import Any, Dict, Mapping, Optional, Tuple, Type


class OracleError(Exception):
    """Any failure of a request or of the service."""


class ServiceError(OracleError):
    """The service cannot be started, has ended, is too slow, or says what is no answer. Of no use any more."""


class RequestError(OracleError):
    """The service refused a request.

    ``code`` and ``data`` are for programs, as in specs/oracle.md; ``message`` is for people and may change. ``index``
    is the number of the request in a bulk call (from 0), and None elsewhere.
    """

    def __init__(self, code: int, message: str, data: Mapping[str, Any], index: Optional[int] = None) -> None:
        where = "" if index is None else "request %d: " % index
        super().__init__("%s%s (%d)" % (where, message, code))
        self.code = code
        self.message = message
        self.data = data
        self.index = index

    def __reduce__(self) -> Tuple[Any, ...]:
        # By default it would be made anew from its text alone: processes hand exceptions on to each other.
        return (type(self), (self.code, self.message, self.data, self.index), self.__dict__)


class ParseError(RequestError):
    """What was sent is no JSON; not by this client, unless a number is a text like ``"1/"``."""


class InvalidRequest(RequestError):
    """What was sent is no request."""


class MethodNotFound(RequestError):
    """The service is of a version without this request."""


class InvalidParams(RequestError):
    """``data["at"]``: what is missing, unknown, or not what it should be."""


class InternalError(RequestError):
    """A fault of scc: please report it."""


class LimitExceeded(RequestError):
    """``data["limit"]`` and ``data["most"]``: see ``Oracle.description.limits``."""


class UnknownHandle(RequestError):
    """``data["handle"]``: a shape or model that was never given, or was released."""


class ShapeRefused(RequestError):
    """``data["faults"]``: why it is no convex closed polyhedron, the most telling first."""


class ModelRefused(RequestError):
    """``data["diagnostics"]``, with codes, places and messages."""


class Stopped(RequestError):
    """``data["limit"]``: "seconds" or "memory", of which the request needed more than it may."""


class NotPossible(RequestError):
    """A choice that cannot be made. ``data["at"]``: how many were followed; ``data["possible"]``: labels there."""


class NoTransitions(RequestError):
    """The transitions of a state cannot be computed; ``data["diagnostics"]``."""


class FormulaRefused(RequestError):
    """``data["diagnostics"]``, with places in the formula."""


class NotInContact(RequestError):
    """A response of bodies that do not touch. ``data["at"]``: which pair; ``data["relation"]``: how it is."""


_CLASSES: Dict[int, Type[RequestError]] = {
    -32700: ParseError,
    -32600: InvalidRequest,
    -32601: MethodNotFound,
    -32602: InvalidParams,
    -32603: InternalError,
    -32000: LimitExceeded,
    -32001: UnknownHandle,
    -32002: ShapeRefused,
    -32003: ModelRefused,
    -32004: Stopped,
    -32005: NotPossible,
    -32006: NoTransitions,
    -32007: FormulaRefused,
    -32008: NotInContact,
}


def from_json(error: Mapping[str, Any], index: Optional[int] = None) -> RequestError:
    code = error["code"]
    return _CLASSES.get(code, RequestError)(code, error["message"], error.get("data") or {}, index)
