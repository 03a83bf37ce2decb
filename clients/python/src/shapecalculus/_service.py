"""The process of the service and its pipes: lines out, lines in, in order, without threads.

Both ends of a pipe may be full at the same time: the service waits until somebody reads its answers, and does not read
requests meanwhile. So nothing here blocks but ``receive``, which writes what is left to write while it waits.
"""

from __future__ import annotations

import os
import select
import subprocess
import time
import weakref
from typing import List, Optional, Sequence

from ._lifeline import tied
from ._program import why_not
from .errors import ServiceError

_CHUNK = 1 << 18
# Seconds: poll takes no more milliseconds than an int of C has room for.
_LONGEST_WAIT = 1_000_000
# Seconds that a service has to end by itself when it is asked to, and when nobody waits for its answer any more.
_PATIENTLY, _SHORTLY = 5.0, 0.2


def how_ended(code: Optional[int], killed: bool) -> str:
    if code is None or killed:
        return ""
    return " (signal %d)" % -code if code < 0 else " (exit code %d)" % code


def _ended(process: "subprocess.Popen[bytes]", owner: int, patience: float) -> bool:
    """Closes the pipes of a service, and ends it if this process, ``owner``, has started it. Whether it was killed."""
    killed = False
    try:
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                pipe.close()
        if os.getpid() == owner:
            process.wait(patience)
    except subprocess.TimeoutExpired:
        pass
    finally:
        # Also when Ctrl-C comes meanwhile.
        if os.getpid() == owner and process.poll() is None:
            killed = True
            process.kill()
            process.wait()
    return killed


class Service:
    """One process of ``command``. ``timeout`` (seconds) bounds each wait for an answer; None or infinity: for ever."""

    def __init__(self, command: Sequence[str], timeout: Optional[float] = None) -> None:
        if timeout is not None:
            timeout = float(timeout)
            if not timeout >= 0:
                raise ValueError("timeout is a number of seconds, at least 0, not %r" % timeout)
            timeout = None if timeout == float("inf") else timeout
        try:
            self._process = subprocess.Popen(
                list(command), stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0, preexec_fn=tied(False)
            )
        except (OSError, ValueError) as error:  # of a name that no file can have, too
            raise ServiceError(why_not(command[0], error)) from error
        assert self._process.stdin is not None and self._process.stdout is not None
        self._stdin, self._stdout = self._process.stdin, self._process.stdout
        self._in = self._stdin.fileno()
        self._out = self._stdout.fileno()
        os.set_blocking(self._in, False)
        os.set_blocking(self._out, False)
        self._poll = select.poll()
        self._poll.register(self._out, select.POLLIN)
        self._writing = False
        self._timeout = timeout
        self._to_write: memoryview = memoryview(b"")
        self._read: List[bytes] = []  # an unfinished line
        self._lines: List[bytes] = []  # finished ones, the next one last
        self._closed = False
        self._killed = False  # by this client
        self._started_by = os.getpid()
        # Of one that nobody has closed. At the end of Python the system closes its pipes.
        self._dropped = weakref.finalize(self, _ended, self._process, self._started_by, _SHORTLY)
        self._dropped.atexit = False

    @property
    def pid(self) -> int:
        return self._process.pid

    def _is_ours(self) -> None:
        # After a fork two processes would read the answers from one pipe.
        if os.getpid() != self._started_by:
            raise ServiceError("this service belongs to the process that started it: make an Oracle in each process")
        if self._closed:
            raise ServiceError("the oracle is closed")

    # Requests.

    def send(self, line: bytes) -> None:
        """Queues a line (with its newline), and writes what can be written at once."""
        self._is_ours()
        rest = self._to_write
        self._to_write = memoryview(bytes(rest) + line if rest else line)
        self._write()

    def _write(self) -> None:
        try:
            while self._to_write:
                self._to_write = self._to_write[os.write(self._in, self._to_write) :]
        except BlockingIOError:
            pass
        except OSError as error:
            raise self._lost("no longer reads: %s" % error) from error
        waiting = len(self._to_write) > 0
        if waiting != self._writing:
            self._writing = waiting
            if waiting:
                self._poll.register(self._in, select.POLLOUT)
            else:
                self._poll.unregister(self._in)

    # Answers.

    def receive(self) -> bytes:
        """The next line, without its newline."""
        self._is_ours()
        limit = None if self._timeout is None else time.monotonic() + self._timeout
        while not self._lines:
            left = None if limit is None else max(0.0, limit - time.monotonic())
            events = self._poll.poll(None if left is None else min(left, _LONGEST_WAIT) * 1000)
            if not events and left is not None and left > _LONGEST_WAIT:
                continue
            if not events:
                raise self._lost("gave no answer within %g s" % (self._timeout or 0))
            for fd, _ in events:
                if fd == self._in:
                    self._write()
                else:
                    self._take()
        return self._lines.pop()

    def _take(self) -> None:
        try:
            chunk = os.read(self._out, _CHUNK)
        except BlockingIOError:
            return
        if not chunk:
            raise self._lost("has ended")
        if b"\n" not in chunk:
            self._read.append(chunk)
            return
        lines = b"".join(self._read + [chunk]).split(b"\n")
        rest = lines.pop()
        self._read = [rest] if rest else []
        lines.reverse()
        self._lines = lines

    # Ends.

    def _lost(self, what: str) -> ServiceError:
        """Ends a service that cannot be used any more, and says why."""
        self._stop(_SHORTLY)
        return ServiceError("the service %s%s" % (what, how_ended(self._process.returncode, self._killed)))

    def close(self) -> Optional[int]:
        """Closes its input, waits until it ends and returns its exit code; again: the same. In another process than the
        one that started it, only the pipes of that process are closed; there is no exit code."""
        self._stop(_PATIENTLY)
        return self._process.returncode if os.getpid() == self._started_by else None

    def abandon(self) -> None:
        """Ends it, though it may be at work on a request."""
        self._stop(_SHORTLY)

    def _stop(self, patience: float) -> None:
        if self._closed:
            return
        self._closed = True
        self._killed = _ended(self._process, self._started_by, patience)
        self._dropped.detach()
