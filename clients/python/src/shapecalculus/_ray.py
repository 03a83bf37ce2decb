"""Ray: getting there, what it tells, and what is told on its dashboard."""

from __future__ import annotations

import logging
import os
import threading
import time
from contextlib import contextmanager
from typing import Any, Dict, Iterator, List, Optional

from ._files import BadFile, CannotKeep
from ._guard import STOPPED
from ._waiting import ClusterFailed
from .successors import FilterFailed, FilterLost


#: What Ray says where machines are too busy to begin in its time; it is asked again then.
BUSY = ("Initialization failure", "timed out during startup")


def connect(address: Optional[str], deadline: float) -> Any:
    """Ray, started here if there is no address. The deadline is in seconds."""
    try:
        # What is lost is seen to here.
        os.environ.setdefault("RAY_IGNORE_UNHANDLED_ERRORS", "1")
        import ray
    except ImportError:
        raise ClusterFailed("Ray is not installed: pip install 'shapecalculus[cluster]'", 64) from None
    if ray.is_initialized():
        return ray
    # What it tells of a connection that is lost comes as an exception as well.
    logging.getLogger("ray.util.client").setLevel(logging.CRITICAL)
    failure: List[BaseException] = []

    end = time.monotonic() + deadline

    def start() -> None:
        try:
            if address is None:
                # By itself Ray would join one that runs here already.
                ray.init(address="local", include_dashboard=False, log_to_driver=False, logging_level=logging.ERROR)
            else:
                ray.init(address=address, log_to_driver=False, logging_level=logging.ERROR)
        except Exception as e:  # whatever Ray says of an address
            if any(text in str(e) for text in BUSY) and time.monotonic() < end - 1:
                time.sleep(1)
                start()
            else:
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


def of_ray(e: Exception) -> bool:
    """Whether it comes from Ray, which has more exceptions than its own when its head is lost."""
    at = e.__traceback__
    while at is not None and at.tb_next is not None:
        at = at.tb_next
    where = at.tb_frame.f_globals.get("__name__", "") if at is not None else ""
    return type(e).__module__.startswith("ray.") or where.startswith("ray.")


@contextmanager
def told() -> Iterator[None]:
    """What goes wrong, as ClusterFailed."""
    try:
        yield
    except FilterLost as e:
        raise ClusterFailed("scc was lost: %s" % e, STOPPED) from None
    except (FilterFailed, BadFile) as e:
        raise ClusterFailed(str(e), 3) from None
    except CannotKeep as e:
        raise ClusterFailed("nothing can be kept: %s" % e, 74) from None
    except Exception as e:
        if not of_ray(e):
            raise
        said = str(e).strip().splitlines() or [type(e).__name__]
        raise ClusterFailed("Ray: %s" % said[-1], 4) from None


class Here:
    """Numbers of this process on Ray's dashboard, and where its metrics are exported."""

    def __init__(self, descriptions: Dict[str, str]):
        from ray.util.metrics import Gauge

        self.all: Dict[str, Any] = {
            name: Gauge("scc_" + name, description=text) for name, text in descriptions.items()
        }

    def set(self, values: Dict[str, float]) -> None:
        for name, value in values.items():
            self.all[name].set(value)


class Gauges:
    """Numbers on Ray's dashboard. A client of a cluster (``ray://``) is no part of it: an actor tells them there."""

    def __init__(self, ray: Any, **descriptions: str):
        from ray.util.client import ray as client

        here: Any = client
        self.there = ray.remote(num_cpus=0)(Here).remote(descriptions) if here.is_connected() else None
        self.here = Here(descriptions) if self.there is None else None

    def set(self, **values: float) -> None:
        if self.here is not None:
            self.here.set(values)
        elif self.there is not None:
            self.there.set.remote(values)
