"""A program that this process has started ends with it, even if this process is killed."""

from __future__ import annotations

import os
import signal
import sys
import threading
from typing import Any, Callable, Optional

_PR_SET_PDEATHSIG = 1


def _system() -> Any:
    if not sys.platform.startswith("linux"):
        return None
    try:
        import ctypes

        return ctypes.CDLL(None).prctl
    except (ImportError, OSError, AttributeError):
        return None


# Looked up here, since little may be done between fork and exec.
_PRCTL = _system()


def tied(parent_stays: bool) -> Optional[Callable[[], None]]:
    """What a child does before it becomes the program: it asks the system for SIGTERM at the end of the thread that
    has started it. None where there is no such thing, or where that thread may end before the program should: unless
    the caller waits (``parent_stays``), it has to be the main thread."""
    if _PRCTL is None or not (parent_stays or threading.current_thread() is threading.main_thread()):
        return None
    parent = os.getpid()

    def ask() -> None:
        _PRCTL(_PR_SET_PDEATHSIG, int(signal.SIGTERM), 0, 0, 0)
        if os.getppid() != parent:  # it has ended meanwhile
            os._exit(1)

    return ask
