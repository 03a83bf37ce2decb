"""The oracle: a process of ``scc oracle``, with a method for each of its requests."""

from __future__ import annotations

import functools
import itertools
import json
from collections import deque
from types import TracebackType
from typing import TYPE_CHECKING, Any, Callable, Deque, Dict, Generic, Iterable, Iterator, List, Mapping, Optional
from typing import Sequence, Tuple, Type, TypeVar, Union

from . import _handles, requests
from ._program import scc_path
from ._service import Service
from .errors import RequestError, ServiceError, from_json
from .geometry import Meeting
from .models import Description
from .numbers import VectorLike, integer, vector_to_text
from .requests import Request, ShapeLike

if TYPE_CHECKING:
    from typing_extensions import Concatenate, ParamSpec

    P = ParamSpec("P")

T = TypeVar("T")

#: The version of specs/oracle.md that this client speaks.
PROTOCOL = 1

#: A cast of a bulk call: a, b, offset, velocity.
Cast = Tuple[ShapeLike, ShapeLike, VectorLike, VectorLike]

# A line of a batch has at most so many requests and (but for a single long request) bytes: enough that what is done
# once for each line does not count, and few enough that client and service work at the same time.
_REQUESTS = 512
_BYTES = 1 << 20
# So many lines are on their way while the answers to one are read.
_AHEAD = 2

_to_json = json.JSONEncoder(separators=(",", ":"), ensure_ascii=True, allow_nan=False).encode


def _read(line: bytes) -> Any:
    try:
        return json.loads(line)
    except (ValueError, RecursionError) as error:
        raise ServiceError("the service says what is no JSON: %r" % line[:200]) from error


def _is_answer(answer: Any, number: int) -> bool:
    """Whether that is the answer to the request of that number: its result, or why it is refused."""
    if not isinstance(answer, dict):
        return False
    if "error" in answer:
        return _is_refusal(answer) and answer.get("id") in (number, None)
    return "result" in answer and answer.get("id") == number


def _is_refusal(answer: Any) -> bool:
    error = answer.get("error") if isinstance(answer, dict) else None
    return isinstance(error, dict) and isinstance(error.get("code"), int) and "message" in error


def _understood(request: Request[T], result: Any, owner: str) -> T:
    try:
        answer = request.read(result)
    except (LookupError, TypeError, ValueError, ArithmeticError, AttributeError) as error:
        text = _shown(result)
        raise ServiceError("the service's answer to %s is none: %s" % (request.method, text)) from error
    return _handles.owned(answer, owner)  # type: ignore[no-any-return]


def _shown(answer: Any) -> str:
    text = repr(answer)
    return text if len(text) <= 200 else text[:200] + "..."


class Future(Generic[T]):
    """The answer to a request of a batch, to be had once the batch has been sent."""

    __slots__ = ("_request", "_owner", "_result", "_error", "_done")

    def __init__(self, request: Request[T], owner: str) -> None:
        self._request = request
        self._owner = owner
        self._result: Optional[T] = None
        self._error: Optional[RequestError] = None
        self._done = False

    @property
    def done(self) -> bool:
        return self._done

    def error(self) -> Optional[RequestError]:
        """Why the request was refused; None if it was answered."""
        if not self._done:
            raise RuntimeError("the batch has not been sent")
        return self._error

    def result(self) -> T:
        """The answer. Raises what the request would have raised by itself."""
        error = self.error()
        if error is not None:
            raise error
        return self._result  # type: ignore[return-value]

    def _settle(self, answer: Mapping[str, Any]) -> None:
        if "error" in answer:
            self._error = from_json(answer["error"])
        else:
            self._result = _understood(self._request, answer["result"], self._owner)
        self._done = True


def _at_once(make: Callable[P, Request[T]]) -> Callable[Concatenate[Oracle, P], T]:
    @functools.wraps(make)
    def method(self: Oracle, *args: P.args, **kwargs: P.kwargs) -> T:
        return self.ask(make(*args, **kwargs))

    return method  # type: ignore[return-value]


def _later(make: Callable[P, Request[T]]) -> Callable[Concatenate[Batch, P], Future[T]]:
    @functools.wraps(make)
    def method(self: Batch, *args: P.args, **kwargs: P.kwargs) -> Future[T]:
        return self.add(make(*args, **kwargs))

    return method  # type: ignore[return-value]


class Oracle:
    """A process of ``scc oracle``; close it, or use it in a ``with`` statement.

    ``scc`` is the program: a path, or a list of words to run it by (which need not be scc: any program that speaks the
    protocol); by default the path in the environment variable SCC, or else the program that this package carries, or
    else ``scc`` wherever PATH finds it. ``seconds`` and ``memory`` (MiB) are what a request may take; the service sees
    to that. ``timeout`` (seconds) is how long the client waits for a line of answers before it gives up the service; by
    default it waits for ever. The service belongs to the process that starts it, and ends when the oracle is dropped.
    """

    def __init__(
        self,
        scc: Union[str, Sequence[str], None] = None,
        *,
        seconds: Optional[int] = None,
        memory: Optional[int] = None,
        timeout: Optional[float] = None,
    ) -> None:
        command = [scc_path(scc), "oracle"] if scc is None or isinstance(scc, str) else list(scc)
        if seconds is not None:
            command += ["--seconds", str(integer(seconds))]
        if memory is not None:
            command += ["--memory", str(integer(memory))]
        self._ids = itertools.count(1)
        self._owner = _handles.new_owner()
        self._service = Service(command, timeout)
        try:
            self.description: Description = self.ask(requests.describe())
            if self.description.protocol != PROTOCOL:
                raise ServiceError("%s speaks protocol %s, and this client speaks %d"
                                   % (command[0], self.description.protocol, PROTOCOL))
        except BaseException:
            self._service.close()
            raise

    # One request.

    def ask(self, request: Request[T]) -> T:
        result = self.call(request.method, request.params)
        try:
            return _understood(request, result, self._owner)
        except ServiceError:
            self._service.close()
            raise

    def call(self, method: str, params: Mapping[str, Any]) -> Any:
        """A request in terms of the protocol: what stands in ``params`` is sent, and ``result`` is given back."""
        _handles.check_all(params, self._owner)
        number = next(self._ids)
        request = {"jsonrpc": "2.0", "id": number, "method": method, "params": params}
        line = _to_json(request).encode() + b"\n"
        try:
            self._service.send(line)
            answer = _read(self._service.receive())
        except BaseException:
            # Ctrl-C, say: the answer to this would be taken for that to the next one.
            self._service.abandon()
            raise
        if not _is_answer(answer, number):
            self._service.close()
            what = "it sends back what it is told" if answer == request else "it says %s" % _shown(answer)
            raise ServiceError("the service does not answer requests as scc oracle does: %s" % what)
        if "error" in answer:
            raise from_json(answer["error"])
        return answer["result"]

    define_shape = _at_once(requests.define_shape)
    check_shape = _at_once(requests.check_shape)
    mass = _at_once(requests.mass)
    release_shape = _at_once(requests.release_shape)
    contact = _at_once(requests.contact)
    first_time_of_contact = _at_once(requests.first_time_of_contact)
    response = _at_once(requests.response)
    load_model = _at_once(requests.load_model)
    release_model = _at_once(requests.release_model)
    successors = _at_once(requests.successors)
    step = _at_once(requests.step)
    replay = _at_once(requests.replay)
    evaluate = _at_once(requests.evaluate)
    check = _at_once(requests.check)
    describe = _at_once(requests.describe)

    # Many.

    def batch(self) -> Batch:
        """Requests to be sent together: ``with oracle.batch() as b: future = b.contact(...)``."""
        return Batch(self)

    def first_times_of_contact(self, casts: Iterable[Cast]) -> List[Meeting]:
        """``first_time_of_contact`` for each (a, b, offset, velocity), the fast way.

        Raises the error of the first one that is refused, with its number as ``index``.
        """
        meetings: List[Meeting] = []
        refused: List[RequestError] = []

        def take(first: int, answers: List[Any]) -> None:
            for index, answer in enumerate(answers, first):
                if "error" in answer:
                    refused.append(from_json(answer["error"], index))
                    continue
                result = answer["result"]
                try:
                    time = result["time"]
                    meetings.append(Meeting(result["outcome"], None if time is None else time["exact"]))
                except (LookupError, TypeError) as error:
                    text = "the service's answer to first_time_of_contact is none: %s" % _shown(result)
                    raise ServiceError(text) from error

        self._exchange(_cast_texts(casts, self._owner), take)
        if refused:
            raise refused[0]
        return meetings

    def _exchange(self, texts: Iterable[str], take: Callable[[int, List[Any]], None]) -> None:
        """Sends requests, whose ids count from 0, in batches, a few ahead of the answers.

        ``take`` is given the answers of each batch, and the number of the first.
        """
        on_their_way: Deque[Tuple[int, int]] = deque()
        service = self._service
        try:
            for first, count, line in _lines(texts):
                service.send(line)
                on_their_way.append((first, count))
                if len(on_their_way) > _AHEAD:
                    take(*self._answers(*on_their_way.popleft()))
            while on_their_way:
                take(*self._answers(*on_their_way.popleft()))
        except ServiceError:
            service.close()
            raise
        except Exception:
            # A mistake in what is sent: let the answers that are still to come be nobody's.
            try:
                for _ in on_their_way:
                    service.receive()
            except BaseException:
                service.abandon()
                raise
            raise
        except BaseException:
            service.abandon()
            raise

    def _answers(self, first: int, count: int) -> Tuple[int, List[Any]]:
        answers = _read(self._service.receive())
        if _is_refusal(answers):
            return first, [answers] * count  # the whole line was refused
        numbers = range(first, first + count)
        if not isinstance(answers, list) or len(answers) != count or not all(map(_is_answer, answers, numbers)):
            self._service.close()
            raise ServiceError("the service answered %d requests otherwise than one by one, in order" % count)
        return first, answers

    # Ends.

    def close(self) -> None:
        """Ends the service. Its shapes and models are gone."""
        self._service.close()

    def __enter__(self) -> Oracle:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], value: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.close()


class Batch:
    """Requests that are sent together, when the ``with`` statement ends or by ``send``.

    Each method gives a future at once. A request cannot use the answer of another one of its batch.
    """

    def __init__(self, oracle: Oracle) -> None:
        self._oracle = oracle
        self._futures: List[Future[Any]] = []

    def add(self, request: Request[T]) -> Future[T]:
        _handles.check_all(request.params, self._oracle._owner)
        future = Future(request, self._oracle._owner)
        self._futures.append(future)
        return future

    define_shape = _later(requests.define_shape)
    check_shape = _later(requests.check_shape)
    mass = _later(requests.mass)
    release_shape = _later(requests.release_shape)
    contact = _later(requests.contact)
    first_time_of_contact = _later(requests.first_time_of_contact)
    response = _later(requests.response)
    load_model = _later(requests.load_model)
    release_model = _later(requests.release_model)
    successors = _later(requests.successors)
    step = _later(requests.step)
    replay = _later(requests.replay)
    evaluate = _later(requests.evaluate)
    check = _later(requests.check)
    describe = _later(requests.describe)

    def send(self) -> None:
        """Sends what has been added since, and waits for all answers; refusals are kept in their futures."""
        futures, self._futures = self._futures, []

        def take(first: int, answers: List[Any]) -> None:
            for future, answer in zip(futures[first : first + len(answers)], answers):
                future._settle(answer)

        self._oracle._exchange(map(_text, itertools.count(), futures), take)

    def __enter__(self) -> Batch:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], value: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        if kind is None:
            self.send()


# Lines.


def _text(number: int, future: Future[Any]) -> str:
    request = future._request
    return _to_json({"jsonrpc": "2.0", "id": number, "method": request.method, "params": request.params})


def _cast_texts(casts: Iterable[Cast], owner: str = "") -> Iterator[str]:
    templates: Dict[Tuple[str, str], str] = {}
    number = 0
    for a, b, offset, velocity in casts:
        key = (a if isinstance(a, str) else a.handle, b if isinstance(b, str) else b.handle)
        _handles.check(key[0], owner)
        _handles.check(key[1], owner)
        template = templates.get(key)
        if template is None:
            template = templates[key] = requests.cast_template(*key)
        yield template % (number, vector_to_text(offset), vector_to_text(velocity))
        number += 1


def _lines(texts: Iterable[str]) -> Iterator[Tuple[int, int, bytes]]:
    """Batches: the number of the first request, how many there are, and the line."""
    first = 0
    batch: List[str] = []
    size = 0
    for text in texts:
        if batch and (len(batch) == _REQUESTS or size + len(text) > _BYTES):
            yield first, len(batch), _batch(batch)
            first += len(batch)
            batch, size = [], 0
        batch.append(text)
        size += len(text) + 1
    if batch:
        yield first, len(batch), _batch(batch)


def _batch(texts: Sequence[str]) -> bytes:
    return ("[" + ",".join(texts) + "]\n").encode()
