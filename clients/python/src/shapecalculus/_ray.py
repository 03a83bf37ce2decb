"""Ray: getting there, what it tells, and what is told on its dashboard."""

from __future__ import annotations

import threading
from contextlib import contextmanager
from typing import Any, Dict, Iterator, List, Optional

from ._files import BadFile, CannotKeep
from ._levels import ClusterFailed
from .successors import FilterFailed


def connect(address: Optional[str], deadline: float) -> Any:
    """Ray, started here if there is no address. The deadline is in seconds."""
    try:
        import ray
    except ImportError:
        raise ClusterFailed("Ray is not installed: pip install 'shapecalculus[cluster]'", 64) from None
    if ray.is_initialized():
        return ray
    failure: List[BaseException] = []

    def start() -> None:
        try:
            if address is None:
                ray.init(include_dashboard=False, log_to_driver=False, logging_level="error")
            else:
                ray.init(address=address, log_to_driver=False, logging_level="error")
        except Exception as e:  # whatever Ray says of an address
            failure.append(e)

    if address is None:
        start()
    else:
        # Ray waits for an address that answers nothing for as long as it likes, and cannot be told otherwise.
        thread = threading.Thread(target=start, daemon=True)
        thread.start()
        thread.join(deadline)
        if thread.is_alive():
            raise ClusterFailed("%s does not answer within %g seconds" % (address, deadline), 69)
    if failure:
        said = str(failure[0]).strip().splitlines() or [type(failure[0]).__name__]
        raise ClusterFailed("%s cannot be reached: %s" % (address or "Ray here", said[0]), 69)
    return ray


@contextmanager
def told() -> Iterator[None]:
    """What goes wrong, as ClusterFailed."""
    try:
        yield
    except (FilterFailed, BadFile) as e:
        raise ClusterFailed(str(e), 3) from None
    except CannotKeep as e:
        raise ClusterFailed("nothing can be kept: %s" % e, 74) from None
    except Exception as e:
        if not type(e).__module__.startswith("ray."):
            raise
        said = str(e).strip().splitlines() or [type(e).__name__]
        raise ClusterFailed("Ray: %s" % said[-1], 4) from None


class Gauges:
    """Numbers on Ray's dashboard, and where its metrics are exported."""

    def __init__(self, **descriptions: str):
        from ray.util.metrics import Gauge

        self.all: Dict[str, Any] = {
            name: Gauge("scc_" + name, description=text) for name, text in descriptions.items()
        }

    def set(self, **values: float) -> None:
        for name, value in values.items():
            self.all[name].set(value)
