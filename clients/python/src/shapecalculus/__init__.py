"""Exact answers about collisions, contacts and models of the Shape Calculus, from ``scc oracle``.

    from shapecalculus import Oracle

    with Oracle() as oracle:
        ...
"""

from .commands import check, estimate, simulate, sweep, trace, view
from .diagnostics import CommandFailed, Diagnostic, Place
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
from .results import Estimate, Estimated, Moment, Simulated, SimulatedRun, Swept, Traced, TraceStep, Viewed
from .runs import Run
from .sweeps import Record, sweep_records
from .where import Bound, Checked, CurvePoint, Form, Part, Polyhedron, Region, Starts, Verdict, Where, wheres

__version__ = "0.1.0"

__all__ = [
    "Batch", "Body", "Bond", "Bound", "Check", "Checked", "CommandFailed", "Condition", "Contact", "CurvePoint",
    "DeclaredLeaf", "Description", "Diagnostic", "Estimate", "Estimated", "Evaluation", "Fault", "Feature", "Fixed",
    "Form", "FormulaRefused", "Future", "InternalError", "InvalidParams", "InvalidRequest", "Label", "Leaf",
    "LimitExceeded", "MassProperties", "Meeting", "MethodNotFound", "Model", "ModelRefused", "Moment", "Motion",
    "MovementStep", "NoTransitions", "NotInContact", "NotPossible", "Oracle", "OracleError", "PROTOCOL", "Pair",
    "ParseError", "Part", "Place", "Polyhedron", "Process", "Record", "Region", "Replay", "Request", "RequestError",
    "Response", "Run", "ServiceError", "Shape", "ShapeRefused", "ShapeReport", "ShapeWarning", "Simulated",
    "SimulatedRun", "Starts", "State", "Step", "Stopped", "Successors", "Swept", "Touch", "TraceStep", "Traced",
    "Transition", "UnknownHandle", "Verdict", "Viewed", "Where", "check", "estimate", "simulate", "sweep",
    "sweep_records", "trace", "view", "wheres",
]
