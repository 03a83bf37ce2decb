"""Waiting for what Ray is to do. By itself it waits for ever where no node is left to do it."""

from __future__ import annotations

from typing import Any, List, Sequence

from ._guard import STOPPED, Failed

#: Seconds after which it is asked whether anything is left to wait for.
LONG = 5.0
#: What is lost so often, an owner in one level or a task, is no accident.
MOST_TRIES = 20
#: Why a model on standard input is refused.
MANY = "the model is read by many: it has to be a file"


class ClusterFailed(Failed):
    """The work came to no end. ``code`` is the exit code of ``scc-cluster``."""


def first_line(text: str) -> str:
    return (text.strip().splitlines() or ["nothing is said of it"])[0]


def look(ray: Any) -> None:
    """ClusterFailed where the node that this process works through is lost."""
    mine = ray.get_runtime_context().get_node_id()
    if not any(n["Alive"] and n["NodeID"] == mine for n in ray.nodes()):
        raise ClusterFailed("the cluster is lost: its node here has died", STOPPED)


def answers(ray: Any, futures: Sequence[Any]) -> List[Any]:
    """As ``ray.get``."""
    while True:
        try:
            return list(ray.get(list(futures), timeout=LONG))
        except ray.exceptions.GetTimeoutError:
            look(ray)


def ready(ray: Any, futures: Sequence[Any]) -> List[Any]:
    """Those that are there, once any is: as ``ray.wait``."""
    while True:
        found, _ = ray.wait(list(futures), num_returns=1, timeout=LONG)
        if found:
            return list(found)
        look(ray)
