"""One run of a command of scc: its output, its lines of progress, and how Ctrl-C ends it."""

from __future__ import annotations

import os
import selectors
import signal
import subprocess
import sys
import threading
from dataclasses import dataclass
from typing import IO, Callable, List, Optional, Sequence, Union

from ._lifeline import tied
from ._program import scc_path, why_not
from .errors import ServiceError

#: ``True`` shows lines of progress on standard error; a function gets each line.
Progress = Union[bool, Callable[[str], object], None]

_PREFIX = b"progress: "
_CHUNK = 1 << 16


@dataclass(frozen=True)
class Done:
    """How a command ended: its exit code, negative for a signal, what it wrote to standard output, and to standard
    error without lines of progress. ``asked`` is true if Ctrl-C came meanwhile."""

    command: Sequence[str]
    code: int
    out: bytes
    messages: str
    asked: bool


def shown(progress: Progress) -> Optional[Callable[[str], object]]:
    """The function that gets the lines, or None."""
    if progress is True:
        return lambda line: print(line, file=sys.stderr, flush=True)
    return progress or None


class _Messages:
    """Standard error of a command: lines of progress go to ``tell``, all others are kept."""

    def __init__(self, tell: Optional[Callable[[str], object]]) -> None:
        self._tell = tell
        self._rest = b""
        self._kept: List[bytes] = []

    def add(self, chunk: bytes) -> None:
        *lines, self._rest = (self._rest + chunk).split(b"\n")
        for line in lines:
            if self._tell is not None and line.startswith(_PREFIX):
                self._tell(line[len(_PREFIX) :].decode("utf-8", "replace"))
            else:
                self._kept.append(line + b"\n")

    def text(self) -> str:
        return b"".join([*self._kept, self._rest]).decode("utf-8", "replace")


class _Running:
    """A command at work. It writes and reads at the same time, so that no full pipe blocks it."""

    def __init__(self, process: "subprocess.Popen[bytes]", text: bytes, messages: _Messages) -> None:
        assert process.stdin is not None and process.stdout is not None and process.stderr is not None
        self._process = process
        self._left = memoryview(text)
        self._out: List[bytes] = []
        self._messages = messages
        self._stdin, self._stdout, self._stderr = process.stdin, process.stdout, process.stderr
        self._open = selectors.DefaultSelector()
        self._watch(process.stdout, selectors.EVENT_READ)
        self._watch(process.stderr, selectors.EVENT_READ)
        self._watch(process.stdin, selectors.EVENT_WRITE)

    def _watch(self, file: IO[bytes], events: int) -> None:
        os.set_blocking(file.fileno(), False)
        self._open.register(file, events)

    def _close(self, file: IO[bytes]) -> None:
        self._open.unregister(file)
        file.close()

    def _write(self) -> None:
        try:
            if self._left:
                self._left = self._left[os.write(self._stdin.fileno(), self._left[:_CHUNK]) :]
        except BlockingIOError:
            return
        except OSError:  # scc reads no more
            self._left = memoryview(b"")
        if not self._left:
            self._close(self._stdin)

    def _step(self) -> None:
        for key, _ in self._open.select():
            if key.fileobj is self._stdin:
                self._write()
                continue
            file = self._stdout if key.fileobj is self._stdout else self._stderr
            try:
                chunk = os.read(key.fd, _CHUNK)
            except BlockingIOError:
                continue
            if not chunk:
                self._close(file)
            elif file is self._stdout:
                self._out.append(chunk)
            else:
                self._messages.add(chunk)

    def to_its_end(self) -> None:
        while len(self._open.get_map()):
            self._step()
        self._process.wait()

    def end(self) -> None:
        """Whatever happens, nothing is left of it."""
        if self._process.poll() is None:
            self._process.kill()
            self._process.wait()
        self._open.close()
        for file in (self._stdin, self._stdout, self._stderr):
            file.close()

    @property
    def out(self) -> bytes:
        return b"".join(self._out)


class _CtrlC:
    """Passes the first Ctrl-C on to a process; the second one is a KeyboardInterrupt. Only where the main thread
    would be interrupted by a KeyboardInterrupt: handlers of others stay."""

    def __init__(self) -> None:
        self.asked = False
        self._process: Optional["subprocess.Popen[bytes]"] = None
        main = threading.current_thread() is threading.main_thread()
        self._ours = main and signal.getsignal(signal.SIGINT) is signal.default_int_handler

    def __enter__(self) -> _CtrlC:
        if self._ours:
            signal.signal(signal.SIGINT, self._came)
        return self

    def __exit__(self, *_: object) -> None:
        if self._ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)

    def _came(self, _signal: int, _frame: object) -> None:
        if self.asked:
            raise KeyboardInterrupt
        self.asked = True
        self._pass_on()

    def _pass_on(self) -> None:
        # A terminal has sent it, too: scc takes two signals within half a second for one.
        if self._process is not None and self._process.poll() is None:
            self._process.send_signal(signal.SIGINT)

    def started(self, process: "subprocess.Popen[bytes]") -> None:
        self._process = process
        if self.asked:
            self._pass_on()


def run(words: Sequence[str], text: Optional[str], scc: Optional[str], progress: Progress) -> Done:
    """Runs ``scc words``, with ``text`` as its standard input. The first Ctrl-C is passed on: scc ends with what it
    has. KeyboardInterrupt at the second one, ServiceError where the program cannot be started."""
    tell = shown(progress)
    command = [scc_path(scc), words[0], *(["--progress"] if tell is not None else []), *words[1:]]
    with _CtrlC() as ctrl_c:
        try:
            process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                bufsize=0,
                preexec_fn=tied(True),
            )
        except (OSError, ValueError) as error:  # of a name that no file can have, too
            raise ServiceError(why_not(command[0], error)) from error
        messages = _Messages(tell)
        running = _Running(process, (text or "").encode("utf-8"), messages)
        try:
            ctrl_c.started(process)
            running.to_its_end()
        finally:
            running.end()
        return Done(command, int(process.returncode), running.out, messages.text(), ctrl_c.asked)
