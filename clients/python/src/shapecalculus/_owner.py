"""An owner: a process ``scc successors --owner K/N`` that keeps a part of the states and exchanges states with the
others by itself (specs/successors.md). What it keeps goes to a folder. Knows nothing of Ray."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
import threading
from typing import Any, Callable, List, Optional, Sequence

from ._files import BadFile, CannotKeep, Folder
from ._guard import UNWRITTEN
from .successors import FilterFailed, FilterLost, Program


def file_name(owner: int, level: int) -> str:
    return "%d-%d.shard" % (owner, level)


class Owner(Program):
    """One of ``count``, from 0. What it tells comes in a thread. ``kept`` is called there with each level that is in the
    folder, and what is explored up to there."""

    def __init__(
        self,
        number: int,
        count: int,
        model: str,
        arguments: Sequence[str],
        scc: Optional[str],
        address: str,
        folder: Optional[Folder],
        kept: Callable[[int, Any], None],
    ):
        self.number, self.folder, self.kept, self.address = number, folder, kept, address
        self.scratch = tempfile.mkdtemp(prefix="scc-owner-")
        self.changed = threading.Condition()
        self.told: Any = None  # what it told last
        self.times = 0  # how often
        self.failure: Optional[Exception] = None
        self.closing = False
        where = ["--owner", "%d/%d" % (number + 1, count), "--listen", address]
        try:
            super().__init__(model, [*arguments, *where], scc)
        except BaseException:
            shutil.rmtree(self.scratch, ignore_errors=True)
            raise
        threading.Thread(target=self._listen, daemon=True).start()

    def port(self) -> int:
        return int(self.header["owner"]["port"])

    def begin(self, asked: Any, level: Optional[int]) -> None:
        """With these peers and bounds; from a level that is in the folder, or from the beginning."""
        restore = [] if level is None else self._restored(level)
        asked = dict(asked, folder=self.scratch, restore=restore)
        if self.folder is None:
            asked = {k: v for k, v in asked.items() if k != "every"}
        self._send(json.dumps(asked).encode() + b"\n")

    def go_on(self) -> None:
        """All owners have what was kept last in the folder."""
        try:
            self._send(b"\n")
        except FilterFailed:
            pass  # Who waits for it hears of it.

    def _restored(self, level: int) -> List[str]:
        """The files that have the levels up to this one, in order."""
        assert self.folder is not None
        found: List[str] = []
        while level >= 0:
            name = file_name(self.number, level)
            data = self.folder.get(name)
            if data is None:
                raise BadFile("%s is not there" % self.folder.file(name))
            first, _, rest = data.partition(b"\n")
            found.append(os.path.join(self.scratch, name))
            try:
                with open(found[-1], "wb") as f:
                    f.write(rest)
            except OSError as e:
                raise CannotKeep("%s: %s" % (found[-1], e.strerror)) from None
            level = int(first) - 1
        return found[::-1]

    # What it tells ----------------------------------------------------------------------

    def _listen(self) -> None:
        assert self.process.stdout is not None
        try:
            for line in self.process.stdout:
                told = self._read(line)
                if "kept" in told:
                    self._keep(told)
                else:
                    self._tell(told)
            self._fail(self._ended())
        except (FilterFailed, CannotKeep) as e:
            self._fail(e)
        except (OSError, ValueError) as e:  # it is closed meanwhile
            self._fail(FilterLost(str(e)))

    def _ended(self) -> Exception:
        failure = self._failure()
        return CannotKeep(str(failure)) if self.process.returncode == UNWRITTEN else failure

    def _keep(self, told: Any) -> None:
        assert self.folder is not None
        kept = told["kept"]
        with open(kept["file"], "rb") as f:
            data = b"%d\n" % kept["from"] + f.read()
        os.remove(kept["file"])
        self.folder.put(file_name(self.number, kept["level"]), data)
        self.kept(kept["level"], told["explored"])

    def _tell(self, told: Any) -> None:
        with self.changed:
            self.told, self.times = told, self.times + 1
            self.changed.notify_all()

    def _fail(self, e: Exception) -> None:
        with self.changed:
            self.failure = e
            self.changed.notify_all()

    def news(self, times: int) -> Any:
        """What it tells, once it has told more often; and how often. Its failure is an exception."""
        with self.changed:
            self.changed.wait_for(lambda: self.times > times or self.failure is not None or self.closing)
            if self.times > times:
                return self.told, self.times
            raise self.failure or FilterLost("the owner is closed")

    def close(self) -> None:
        with self.changed:
            self.closing = True
            self.changed.notify_all()
        super().close()
        shutil.rmtree(self.scratch, ignore_errors=True)
