"""Exact answers about collisions, contacts and models of the Shape Calculus, from ``scc oracle``.

    from shapecalculus import Oracle

    with Oracle() as oracle:
        ...
"""

from .errors import (
    FormulaRefused,
    InternalError,
    InvalidParams,
    InvalidRequest,
    LimitExceeded,
    MethodNotFound,
    ModelRefused,
    NotInContact,
    NotPossible,
    NoTransitions,
    OracleError,
    ParseError,
    RequestError,
    ServiceError,
    ShapeRefused,
    Stopped,
    UnknownHandle,
)
from .geometry import (
    Condition,
    Contact,
    Fault,
    Feature,
    MassProperties,
    Meeting,
    Motion,
    Pair,
    Response,
    Shape,
    ShapeReport,
    ShapeWarning,
)
from .models import (
    Bond,
    Check,
    DeclaredLeaf,
    Description,
    Evaluation,
    Label,
    Leaf,
    Model,
    MovementStep,
    Process,
    Replay,
    State,
    Step,
    Successors,
    Transition,
)
from .oracle import PROTOCOL, Batch, Future, Oracle
from .requests import Body, Fixed, Request, Touch
from .sweeps import Record, sweep, sweep_records
from .where import Checked, Polyhedron, Region, Where, wheres

__version__ = "0.1.0"

__all__ = [
    "Batch", "Body", "Bond", "Check", "Checked", "Condition", "Contact", "DeclaredLeaf", "Description", "Evaluation", "Fault",
    "Feature", "Fixed", "FormulaRefused", "Future", "InternalError", "InvalidParams", "InvalidRequest", "Label", "Leaf",
    "LimitExceeded", "MassProperties", "Meeting", "MethodNotFound", "Model", "ModelRefused", "Motion", "MovementStep",
    "NoTransitions", "NotInContact", "NotPossible", "Oracle", "OracleError", "PROTOCOL", "Pair", "ParseError",
    "Polyhedron", "Process", "Record", "Region", "Replay", "Request", "RequestError", "Response", "ServiceError", "Shape",
    "ShapeRefused", "ShapeReport", "ShapeWarning", "State", "Step", "Stopped", "Successors", "Touch", "Transition",
    "UnknownHandle", "Where", "sweep", "sweep_records", "wheres",
]
