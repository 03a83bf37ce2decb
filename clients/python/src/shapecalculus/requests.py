"""The requests of the protocol, each with its params and how its answer is read.

``Oracle`` has a method for each that sends it at once, ``Batch`` one that puts it into the batch; their parameters are
documented here. The names of what is asked, and what it means, are those of specs/oracle.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, Generic, Iterable, List, Literal, Mapping, Optional, Sequence, Tuple, TypeVar, Union

from .geometry import Contact, MassProperties, Meeting, Response, Shape, ShapeReport
from .models import Description, Evaluation, Model, Replay, Step, Successors
from .numbers import (
    MatrixLike,
    Number,
    QuaternionLike,
    VectorLike,
    integer,
    matrix_to_json,
    quaternion_to_json,
    to_json,
    vector_to_json,
)
from .where import Checked

T = TypeVar("T")

Params = Dict[str, Any]
ShapeLike = Union[Shape, str]
ModelLike = Union[Model, str]
#: A choice: its index, the text of its label, or both in an object.
Choice = Union[int, str, Mapping[str, Union[int, str]]]
#: A value of a parameter, or the two ends of a range that it is narrowed to.
Setting = Union[Number, Sequence[Number]]


@dataclass(frozen=True)
class Request(Generic[T]):
    """``read`` makes the answer of the member ``result``."""

    method: str
    params: Params
    read: Callable[[Any], T]


@dataclass(frozen=True)
class Touch:
    """Two parts that touch, one of the first body and one of the second. ``at`` and turns: of turning bodies."""

    a: ShapeLike
    b: ShapeLike
    offset: VectorLike
    turned_a: Optional[QuaternionLike] = None
    turned_b: Optional[QuaternionLike] = None
    at: Optional[VectorLike] = None


@dataclass(frozen=True)
class Body:
    """A body that moves. The last three members are those of turning bodies: in the world, about the centre of mass."""

    mass: Number
    velocity: VectorLike
    centre: Optional[VectorLike] = None
    inertia: Optional[MatrixLike] = None
    spin: Optional[VectorLike] = None


@dataclass(frozen=True)
class Fixed:
    """A body that nothing moves."""


def _shape(shape: ShapeLike) -> str:
    return shape if isinstance(shape, str) else shape.handle


def _model(model: ModelLike) -> str:
    return model if isinstance(model, str) else model.handle


def _set(params: Params, write: Callable[[Any], Any], **members: Any) -> None:
    """Those that are not None."""
    for name, value in members.items():
        if value is not None:
            params[name] = write(value)


def _limited(params: Params, seconds: Optional[Number]) -> Params:
    if seconds is not None:
        params["limits"] = {"seconds": to_json(seconds)}
    return params


def _explored(
    params: Params, seconds: Optional[Number], states: Optional[int], depth: Optional[int], time: Optional[Number]
) -> Params:
    """With the limits of an exploration."""
    limits: Params = _limited(params, seconds).get("limits", {})
    _set(limits, integer, states=states, depth=depth)
    _set(limits, to_json, time=time)
    if limits:
        params["limits"] = limits
    return params


# Shapes.


def _corner(corner: Union[int, str]) -> Union[int, str]:
    return corner if isinstance(corner, str) else integer(corner)


def _polyhedron(
    vertices: Iterable[VectorLike],
    faces: Iterable[Sequence[Union[int, str]]],
    vertex_names: Optional[Iterable[str]],
    face_names: Optional[Iterable[str]],
) -> Params:
    params: Params = {
        "vertices": [vector_to_json(v) for v in vertices],
        "faces": [[_corner(corner) for corner in face] for face in faces],
    }
    names: Params = {}
    _set(names, list, vertices=vertex_names, faces=face_names)
    if names:
        params["names"] = names
    return params


def define_shape(
    vertices: Iterable[VectorLike],
    faces: Iterable[Sequence[Union[int, str]]],
    *,
    vertex_names: Optional[Iterable[str]] = None,
    face_names: Optional[Iterable[str]] = None,
    linear: Optional[MatrixLike] = None,
    quaternion: Optional[QuaternionLike] = None,
) -> Request[Shape]:
    """Makes a shape of ``vertices`` and ``faces``: indices (or names) of vertices, counter-clockwise from outside.

    It is seen through the matrix ``linear``, or turned by ``quaternion``. Raises ShapeRefused.
    """
    params = _polyhedron(vertices, faces, vertex_names, face_names)
    _set(params, matrix_to_json, linear=linear)
    _set(params, quaternion_to_json, quaternion=quaternion)
    return Request("shape.define", params, Shape.from_json)


def check_shape(
    vertices: Iterable[VectorLike],
    faces: Iterable[Sequence[Union[int, str]]],
    *,
    vertex_names: Optional[Iterable[str]] = None,
    face_names: Optional[Iterable[str]] = None,
) -> Request[ShapeReport]:
    """Whether these make a shape, and why not."""
    return Request("shape.check", _polyhedron(vertices, faces, vertex_names, face_names), ShapeReport.from_json)


def mass(
    shape: ShapeLike,
    *,
    mass: Optional[Number] = None,
    turned: Optional[QuaternionLike] = None,
    at: Optional[VectorLike] = None,
) -> Request[MassProperties]:
    """Volume, centroid and inertia of a shape of that mass (1), in the world."""
    params: Params = {"shape": _shape(shape)}
    _set(params, to_json, mass=mass)
    _set(params, quaternion_to_json, turned=turned)
    _set(params, vector_to_json, at=at)
    return Request("shape.mass", params, MassProperties.from_json)


def release_shape(shape: ShapeLike) -> Request[None]:
    """Makes room for another shape; the handle is never used again."""
    return Request("shape.release", {"shape": _shape(shape)}, lambda _: None)


# Contact.


def contact(
    a: ShapeLike,
    b: ShapeLike,
    offset: VectorLike,
    *,
    velocity: Optional[VectorLike] = None,
    resolution: Optional[Number] = None,
    turned_a: Optional[QuaternionLike] = None,
    turned_b: Optional[QuaternionLike] = None,
) -> Request[Contact]:
    """How B, at ``offset`` from A, lies to A; with ``velocity`` (of B less that of A) whether they approach.

    With ``resolution`` shapes that are no farther apart than that count as near; only then they may be turned.
    """
    params: Params = {"a": _shape(a), "b": _shape(b), "offset": vector_to_json(offset)}
    _set(params, vector_to_json, velocity=velocity)
    _set(params, to_json, resolution=resolution)
    _set(params, quaternion_to_json, turned_a=turned_a, turned_b=turned_b)
    return Request("contact", params, Contact.from_json)


def first_time_of_contact(
    a: ShapeLike,
    b: ShapeLike,
    offset: VectorLike,
    velocity: VectorLike,
    *,
    span: Optional[Number] = None,
    until: Optional[Number] = None,
    resolution: Optional[Number] = None,
    grid: Optional[int] = None,
    phase: Union[Number, Literal["turn"], None] = None,
    turned_a: Optional[QuaternionLike] = None,
    turned_b: Optional[QuaternionLike] = None,
    spin_a: Optional[VectorLike] = None,
    spin_b: Optional[VectorLike] = None,
    since_a: Optional[Number] = None,
    since_b: Optional[Number] = None,
    arm_a: Optional[VectorLike] = None,
    arm_b: Optional[VectorLike] = None,
    seconds: Optional[Number] = None,
) -> Request[Meeting]:
    """When B, at ``offset`` from A and with ``velocity`` (less that of A), first collides with A.

    With ``span`` or ``until`` and either ``resolution`` or ``grid`` for bodies that turn: within that time, on a grid of
    instants. It counts from now, or since ``phase``. To stop where ``scc trace`` does, ask with ``until`` and with
    ``phase="turn"``, that is from the start of the last turn that one of the two began.
    """
    params: Params = {
        "a": _shape(a),
        "b": _shape(b),
        "offset": vector_to_json(offset),
        "velocity": vector_to_json(velocity),
    }
    _set(params, to_json, span=span, until=until, resolution=resolution, since_a=since_a, since_b=since_b)
    _set(params, lambda p: p if p == "turn" else to_json(p), phase=phase)
    _set(params, integer, grid=grid)
    _set(params, quaternion_to_json, turned_a=turned_a, turned_b=turned_b)
    _set(params, vector_to_json, spin_a=spin_a, spin_b=spin_b, arm_a=arm_a, arm_b=arm_b)
    return Request("first_time_of_contact", _limited(params, seconds), Meeting.from_json)


def _touch(touch: Union[Touch, Tuple[ShapeLike, ShapeLike, VectorLike]]) -> Params:
    touch = touch if isinstance(touch, Touch) else Touch(*touch)
    params: Params = {"a": _shape(touch.a), "b": _shape(touch.b), "offset": vector_to_json(touch.offset)}
    _set(params, quaternion_to_json, turned_a=touch.turned_a, turned_b=touch.turned_b)
    _set(params, vector_to_json, at=touch.at)
    return params


def _body(body: Union[Body, Fixed]) -> Params:
    if isinstance(body, Fixed):
        return {"fixed": True}
    params: Params = {"mass": to_json(body.mass), "velocity": vector_to_json(body.velocity)}
    _set(params, vector_to_json, centre=body.centre, spin=body.spin)
    _set(params, matrix_to_json, inertia=body.inertia)
    return params


def response(
    touching: Iterable[Union[Touch, Tuple[ShapeLike, ShapeLike, VectorLike]]],
    first: Union[Body, Fixed],
    second: Union[Body, Fixed],
    *,
    resolution: Optional[Number] = None,
) -> Request[Response]:
    """The velocities of two bodies after they have met. ``touching``: all pairs (a, b, offset) of parts that touch."""
    params: Params = {"touching": [_touch(t) for t in touching], "first": _body(first), "second": _body(second)}
    _set(params, to_json, resolution=resolution)
    return Request("response", params, Response.from_json)


# Models.


def _setting(setting: Setting) -> Any:
    return [to_json(end) for end in setting] if isinstance(setting, (tuple, list)) else to_json(setting)


def _text(
    text: str, files: Optional[Mapping[str, str]], parameters: Optional[Mapping[str, Setting]]
) -> Params:
    params: Params = {"text": text}
    _set(params, dict, files=files)
    if parameters is not None:
        params["parameters"] = {name: _setting(setting) for name, setting in parameters.items()}
    return params


def _seeded(member: str, word: Optional[str], seed: Optional[int]) -> Any:
    if seed is None:
        if word == "random":
            raise ValueError('%s="random" takes a seed: %s="random", seed=1' % (member, member))
        return word
    if word not in (None, "random"):
        raise ValueError('a seed goes with %s="random", and not with %r' % (member, word))
    return {"random": integer(seed)}


def load_model(
    text: str,
    *,
    files: Optional[Mapping[str, str]] = None,
    parameters: Optional[Mapping[str, Setting]] = None,
    start: Optional[str] = None,
    seed: Optional[int] = None,
    seconds: Optional[Number] = None,
) -> Request[Model]:
    """Reads a model. ``files``: the texts of the meshes that it names. Raises ModelRefused.

    Where parameters have ranges and no value, ``start="simple"`` chooses simple ones, and ``start="random"`` with a
    ``seed`` (a seed alone will do) others; the answer's ``parameters`` tell which.
    """
    params = _text(text, files, parameters)
    if start is not None or seed is not None:
        params["start"] = _seeded("start", start, seed)
    given = tuple(parameters or ()) if "start" not in params else None
    return Request(
        "model.load",
        _limited(params, seconds),
        lambda json: Model.from_json(json).loaded_from(text, files or {}, given),
    )


def check(
    text: str,
    *,
    where: bool = False,
    prove: bool = False,
    files: Optional[Mapping[str, str]] = None,
    parameters: Optional[Mapping[str, Setting]] = None,
    states: Optional[int] = None,
    depth: Optional[int] = None,
    time: Optional[Number] = None,
    seconds: Optional[Number] = None,
) -> Request[Checked]:
    """Verdicts for the checks of a model, over all values of parameters that have ranges, and with ``where`` for which.

    What ``parameters`` gives a value is known, what it gives two is narrowed to the range between them, both ends
    included. With ``prove`` an invariant is looked for before anything is explored. The limits are those of the
    exploration. Raises ModelRefused, also for ``where`` where no parameter has a
    range.
    """
    params = _text(text, files, parameters)
    if where:
        params["where"] = True
    if prove:
        params["prove"] = True
    return Request("model.check", _explored(params, seconds, states, depth, time), Checked.from_json)


def release_model(model: ModelLike) -> Request[None]:
    """Makes room for another model; the handle is never used again."""
    return Request("model.release", {"model": _model(model)}, lambda _: None)


def _path(path: Iterable[int]) -> List[int]:
    return [integer(choice) for choice in path]


def _choice(choice: Choice) -> Any:
    if isinstance(choice, str):
        return choice
    if isinstance(choice, Mapping):
        return {name: value if isinstance(value, str) else integer(value) for name, value in choice.items()}
    return integer(choice)


def successors(
    model: ModelLike, path: Sequence[int] = (), *, states: str = "here", seconds: Optional[Number] = None
) -> Request[Successors]:
    """All that may happen in the state that ``path`` leads to. ``states``: "here", "all" or "none"."""
    params: Params = {"model": _model(model), "path": _path(path), "states": states}
    return Request("successors", _limited(params, seconds), Successors.from_json)


def step(
    model: ModelLike, path: Sequence[int], choice: Union[int, str], *, seconds: Optional[Number] = None
) -> Request[Step]:
    """Takes a transition, told by its index or the text of its label. Raises NotPossible."""
    params: Params = {"model": _model(model), "path": _path(path), "choice": _choice(choice)}
    return Request("step", _limited(params, seconds), Step.from_json)


def replay(
    model: ModelLike,
    choices: Optional[Iterable[Choice]] = None,
    *,
    offset: Optional[Number] = None,
    choose: Optional[str] = None,
    seed: Optional[int] = None,
    steps: Optional[int] = None,
    time: Optional[Number] = None,
    states: str = "all",
    seconds: Optional[Number] = None,
) -> Request[Replay]:
    """Follows ``choices``, or chooses: ``choose="first"``, or ``choose="random"`` with a ``seed`` (a seed alone will do).

    ``states``: "all" or "ends".
    """
    params: Params = {"model": _model(model), "states": states}
    if choices is not None:
        params["choices"] = [_choice(c) for c in choices]
    if choose is not None or seed is not None:
        params["choose"] = _seeded("choose", choose, seed)
    _set(params, to_json, offset=offset, time=time)
    _set(params, integer, steps=steps)
    return Request("replay", _limited(params, seconds), Replay.from_json)


def evaluate(
    model: ModelLike,
    formula: str,
    path: Sequence[int] = (),
    *,
    states: Optional[int] = None,
    depth: Optional[int] = None,
    time: Optional[Number] = None,
    seconds: Optional[Number] = None,
) -> Request[Evaluation]:
    """What ``formula`` says in the state that ``path`` leads to; limits are those of the exploration, if any."""
    params: Params = {"model": _model(model), "path": _path(path), "formula": formula}
    return Request("evaluate", _explored(params, seconds, states, depth, time), Evaluation.from_json)


def describe() -> Request[Description]:
    """What the service is, and its limits."""
    return Request("service.describe", {}, Description.from_json)




def cast_template(a: ShapeLike, b: ShapeLike) -> str:
    """A request for first_time_of_contact without its numbers: to be filled with id, offset and velocity."""
    for handle in (_shape(a), _shape(b)):
        if not handle.isalnum():
            raise ValueError("not a handle: %r" % handle)
    return (
        '{"jsonrpc":"2.0","id":%%d,"method":"first_time_of_contact","params":{"a":"%s","b":"%s",'
        '"offset":[%%s],"velocity":[%%s]}}' % (_shape(a), _shape(b))
    )
