"""The outermost guard of a program: the exit codes 0, 1 and 2 come from finished verdicts only.

The work is done by a process of its own, the *worker*. It hands over what it writes, and at last its verdict, by a
pipe that nobody else has. The guard alone has the standard output, and alone decides on the exit code. It gives the
code of a verdict only when it has a verdict, and has written all output before it. So it does not matter how the
worker ends, what a library prints, or which descriptors the worker closes. The guard hears SIGINT, SIGTERM and
SIGHUP at any time. Then, and at the end, it ends the worker and all processes of the worker's session. If the guard
is lost, they end as well.
"""

from __future__ import annotations

import errno
import io
import json
import os
import select
import shutil
import signal
import struct
import sys
import tempfile
import threading
import time
import traceback
from dataclasses import dataclass
from typing import Any, Callable, List, Optional, Tuple

STOPPED, USAGE, FAULT, UNWRITTEN = 4, 64, 70, 74
#: Exit codes that are verdicts of a worker; any other says why there is none.
VERDICTS = (0, 1, 2)

#: Seconds that a worker has to end by itself after its verdict, and after a signal.
PATIENCE, SOON = 5.0, 1.5
#: Seconds that a last word waits for a full pipe behind standard error.
LAST_WORD = 2.0
#: Kinds of messages of a worker.
OUTPUT, VERDICT = b"O", b"V"
HEARD = ("SIGINT", "SIGTERM", "SIGHUP")
LIMITS = (errno.EMFILE, errno.ENFILE, errno.ENOMEM, errno.EAGAIN)


class Failed(Exception):
    """The work came to no end. ``code`` is the exit code of the program, and the message is for people."""

    def __init__(self, message: str, code: int):
        super().__init__(message)
        self.code = code


@dataclass(frozen=True)
class Program:
    """A program of which the worker may be lost at any time."""

    name: str
    work: Callable[[Callable[[bytes], None]], int]  #: is given what writes to standard output; gives the exit code
    ending: Callable[[], None]  #: what the worker does after its verdict, which is no part of it
    lost: str  #: what it means that the worker ended without a verdict
    advice: str  #: how to go on after that, or after an interruption


class Interrupted(Exception):
    """A signal asks the program to end."""


class ReaderGone(Exception):
    """Nobody reads the standard output any more, which is the reader's choice."""


def told(e: BaseException, advice: str) -> Tuple[int, str]:
    """The exit code of an exception, and what is said of it."""
    if isinstance(e, Failed):
        return (FAULT if e.code in VERDICTS else e.code), str(e)
    if isinstance(e, (KeyboardInterrupt, Interrupted)):
        return STOPPED, "interrupted" + advice
    if isinstance(e, ReaderGone):
        return STOPPED, ""
    if isinstance(e, MemoryError) or isinstance(e, RuntimeError) and "can't start new thread" in str(e):
        return STOPPED, "a limit of resources: %s%s" % (str(e) or "out of memory", advice)
    if isinstance(e, OSError):
        if e.errno in LIMITS:
            return STOPPED, "a limit of resources: %s%s" % (e, advice)
        return UNWRITTEN, "cannot write: %s" % e
    trace = "".join(traceback.format_exception(type(e), e, e.__traceback__))
    return FAULT, "a fault of this program, please report it:\n%s" % trace.rstrip()


# Descriptors --------------------------------------------------------------------------


def reserve() -> List[int]:
    """The standard streams that are closed. They are opened as nothing, or other files would take their numbers."""
    closed = []
    for fd in (0, 1, 2):
        try:
            os.fstat(fd)
        except OSError:
            closed.append(fd)
            opened = os.open(os.devnull, os.O_RDWR)
            if opened != fd:
                os.dup2(opened, fd)
                os.close(opened)
            os.set_inheritable(fd, True)
    return closed


class _StandardError(io.RawIOBase):
    """Where a worker and its libraries print. What cannot be written is given up: it decides nothing."""

    def fileno(self) -> int:
        return 2

    def isatty(self) -> bool:
        return os.isatty(2)

    def writable(self) -> bool:
        return True

    def write(self, data: Any) -> int:
        left = memoryview(data)
        try:
            while left:
                left = left[os.write(2, left) :]
        except OSError:
            pass
        return len(data)


def printed() -> Any:
    raw: Any = _StandardError()  # typeshed asks for a name, which no raw stream has
    return io.TextIOWrapper(raw, "utf-8", "backslashreplace", write_through=True)


# The worker ---------------------------------------------------------------------------


def _send(channel: int, kind: bytes, data: bytes) -> None:
    left = memoryview(kind + struct.pack("<Q", len(data)) + data)
    while left:
        left = left[os.write(channel, left) :]


def _work(program: Program, channel: int, guard: int, scratch: Optional[str]) -> None:
    """All of a worker. ``guard`` is the end of a pipe that ends when the guard does."""
    os.setsid()
    signal.set_wakeup_fd(-1)

    def stop(number: int, frame: Any) -> None:
        raise KeyboardInterrupt

    # A terminal tells the guard alone, as this is another session. The guard tells by SIGINT: at SIGTERM Ray writes
    # the account of a crash.
    for name in HEARD:
        signal.signal(getattr(signal, name), stop if name == "SIGINT" else signal.SIG_IGN)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    sys.stdout = sys.stderr = printed()
    if scratch is not None:
        tempfile.tempdir = scratch

    def watch() -> None:
        os.read(guard, 1)
        os.killpg(0, signal.SIGKILL)

    def write(data: bytes) -> None:
        if data:
            _send(channel, OUTPUT, data)

    try:
        threading.Thread(target=watch, daemon=True).start()
        code, said = program.work(write), ""
    except SystemExit:
        code, said = STOPPED, program.lost + program.advice
    except BaseException as e:
        code, said = told(e, program.advice)
    _send(channel, VERDICT, json.dumps([code, said]).encode())
    program.ending()


# The guard ----------------------------------------------------------------------------


class Guard:
    """Of one worker. Signals are noted when they come, and looked at whenever something is waited for."""

    def __init__(self, program: Program):
        self.program = program
        self.pid = 0  # of the worker
        self.ended = False  # the pipe of the worker is
        self.received = bytearray()
        self.verdict: Optional[Tuple[int, str]] = None
        self.closed = reserve()
        self.woken, wake = os.pipe()
        for fd in (self.woken, wake):
            os.set_blocking(fd, False)
        signal.set_wakeup_fd(wake, warn_on_full_buffer=False)
        for name in HEARD:
            number = getattr(signal, name)
            # What was ignored from the start stays so, as by nohup.
            if signal.getsignal(number) != signal.SIG_IGN:
                signal.signal(number, lambda n, frame: None)
                signal.pthread_sigmask(signal.SIG_UNBLOCK, [number])

    def start(self, scratch: Optional[str]) -> None:
        self.channel, mine = os.pipe()
        guard, self.life = os.pipe()
        os.set_blocking(self.channel, False)
        self.pid = os.fork()
        if self.pid == 0:
            try:
                os.close(self.life)
                os.close(self.channel)
                _work(self.program, mine, guard, scratch)
            finally:
                os._exit(FAULT)
        os.close(mine)
        os.close(guard)

    # Waiting --------------------------------------------------------------------------

    def wait(self, fd: int, event: int, end: Optional[float] = None) -> bool:
        """Whether a descriptor is ready before a signal comes (which is an exception), or time is up."""
        poll = select.poll()
        poll.register(fd, event)
        poll.register(self.woken, select.POLLIN)
        while True:
            left = None if end is None else max(0.0, end - time.monotonic()) * 1000
            ready = [f for f, _ in poll.poll(left)]
            if self.woken in ready and any(n in self.numbers() for n in os.read(self.woken, 1 << 10)):
                raise Interrupted
            if fd in ready:
                return True
            if not ready:
                return False

    def numbers(self) -> List[int]:
        return [int(getattr(signal, name)) for name in HEARD]

    def write(self, fd: int, data: bytes, end: Optional[float] = None) -> None:
        """Never so much at once that a pipe could block."""
        left = memoryview(data)
        while left:
            if not self.wait(fd, select.POLLOUT, end):
                return
            try:
                left = left[os.write(fd, left[: select.PIPE_BUF]) :]
            except BlockingIOError:
                pass

    def put(self, data: bytes) -> None:
        try:
            if 1 in self.closed:
                raise OSError(errno.EBADF, os.strerror(errno.EBADF))
            self.write(1, data)
        except BrokenPipeError:
            raise ReaderGone from None
        except OSError as e:
            raise Failed("cannot write: standard output: %s" % (e.strerror or e), UNWRITTEN) from None

    def say(self, text: str, end: Optional[float] = None) -> None:
        """On standard error. What cannot be written is given up: the exit code tells it as well."""
        if text:
            clear = "\r\033[K" if os.isatty(2) else ""
            words = "%s%s: %s\n" % (clear, self.program.name, text)
            try:
                self.write(2, words.encode("utf-8", "backslashreplace"), end)
            except OSError:
                pass

    # The worker -----------------------------------------------------------------------

    def take(self, put: Callable[[bytes], None], end: Optional[float] = None) -> bool:
        """What the worker has sent since, if it sends anything in time."""
        if not self.wait(self.channel, select.POLLIN, end):
            return False
        try:
            data = os.read(self.channel, 1 << 16)
        except BlockingIOError:
            return True
        self.ended = not data
        self.received += data
        while len(self.received) >= 9:
            (size,) = struct.unpack_from("<Q", self.received, 1)
            if len(self.received) < 9 + size:
                break
            kind, body = bytes(self.received[:1]), bytes(self.received[9 : 9 + size])
            del self.received[: 9 + size]
            if kind == OUTPUT:
                put(body)
            else:
                code, said = json.loads(body)
                self.verdict = code, said
        return True

    def end(self) -> str:
        """Nothing of the worker and of what it has started is left. How it ended, in words."""
        try:
            os.killpg(self.pid, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            # It has not come so far as to lead a group, or nothing of it is left.
            os.kill(self.pid, signal.SIGKILL)
        _, status = os.waitpid(self.pid, 0)
        self.pid = 0
        if os.WIFSIGNALED(status):
            return "signal %d" % os.WTERMSIG(status)
        return "exit code %d" % os.WEXITSTATUS(status)

    def patiently(self, asked: bool) -> None:
        """Lets the worker end by itself; a signal meanwhile ends the patience."""
        end = time.monotonic() + (SOON if asked else PATIENCE)
        try:
            if asked:
                os.kill(self.pid, signal.SIGINT)
            while not self.ended and self.take(lambda data: None, end):
                pass
        except (Interrupted, ProcessLookupError):
            pass

    def result(self) -> Tuple[int, str]:
        """The exit code and what is said."""
        try:
            while self.verdict is None and not self.ended:
                self.take(self.put)
        except (Interrupted, ReaderGone, Failed) as e:
            self.patiently(True)
            self.end()
            return told(e, self.program.advice)
        verdict = self.verdict
        if verdict is not None:
            self.patiently(False)
        how = self.end()
        return verdict or (STOPPED, "%s (%s)%s" % (self.program.lost, how, self.program.advice))


def run(program: Program) -> int:
    """The exit code. To be called once, as all that a process does; before it has threads."""
    guard: Optional[Guard] = None
    scratch: Optional[str] = None
    try:
        guard = Guard(program)
        try:
            scratch = tempfile.mkdtemp(prefix=program.name + "-")
        except OSError:
            pass  # The worker makes its own, where it needs any.
        guard.start(scratch)
        code, said = guard.result()
    except BaseException as e:
        code, said = (STOPPED, str(e)) if isinstance(e, OSError) else told(e, program.advice)
        if guard is not None and guard.pid:
            guard.end()
    if scratch is not None:
        shutil.rmtree(scratch, ignore_errors=True)
    if guard is not None:
        try:
            guard.say(said, None if code in VERDICTS else time.monotonic() + LAST_WORD)
        except Interrupted:
            pass
    return code
