"""Files of a checkpoint: in a folder, or at an address of fsspec. Each begins with a line that has its version and
a digest of the rest, so that damage and other files are recognised, and never believed."""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass
from typing import Any, Optional

#: Changes whenever what a checkpoint holds does.
VERSION = b"scc-cluster 4 "


class BadFile(Exception):
    """It is there, and not what was kept. The message names it."""


class CannotKeep(Exception):
    """A file could not be written or read, by the system's account. The message names it."""


def place(folder: str, name: str) -> str:
    return "%s/%s" % (folder.rstrip("/"), name)


def open_file(path: str, mode: str) -> Any:
    if "://" in path:
        try:
            import fsspec

            opened: Any = fsspec.open(path, mode)
            return opened.open()
        except (ImportError, ValueError) as e:  # nothing there knows such addresses
            raise CannotKeep("%s: %s" % (path, e)) from None
    return open(path, mode)


def make_folder(path: str) -> None:
    if "://" not in path:
        try:
            os.makedirs(path, exist_ok=True)
        except OSError as e:
            raise CannotKeep("%s: %s" % (path, e.strerror)) from None


def put_file(path: str, data: bytes, durable: bool = True) -> None:
    """As a whole or not at all, where the place is a folder. What is durable survives a power cut."""
    head = VERSION + hashlib.sha256(data).hexdigest().encode() + b"\n"
    try:
        if "://" in path:
            with open_file(path, "wb") as f:
                f.write(head + data)
            return
        with open(path + ".new", "wb") as f:
            f.write(head)
            f.write(data)
            if durable:
                f.flush()
                os.fsync(f.fileno())
        os.replace(path + ".new", path)
        if not durable:
            return
        # The name is durable only when the folder is.
        folder = os.open(os.path.dirname(path) or ".", os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)
    except OSError as e:
        raise CannotKeep("%s: %s" % (path, e.strerror or e)) from None


def get_file(path: str) -> Optional[bytes]:
    """What was put there; None if there is no file."""
    try:
        with open_file(path, "rb") as f:
            head: bytes = f.readline(len(VERSION) + 65)
            data: bytes = f.read()
    except FileNotFoundError:
        return None
    except OSError as e:
        raise CannotKeep("%s: %s" % (path, e.strerror or e)) from None
    if not head.startswith(VERSION):
        raise BadFile("%s is no file of a checkpoint, or of another version of this program" % path)
    if head[len(VERSION) :] != hashlib.sha256(data).hexdigest().encode() + b"\n":
        raise BadFile("%s is damaged: its digest is another one" % path)
    return data


@dataclass(frozen=True)
class Folder:
    """Where files of a checkpoint are. What only has to outlive the owners of one call need not be durable."""

    path: str
    durable: bool = True

    def file(self, name: str) -> str:
        return place(self.path, name)

    def make(self) -> None:
        make_folder(self.path)

    def put(self, name: str, data: bytes) -> None:
        put_file(self.file(name), data, self.durable)

    def get(self, name: str) -> Optional[bytes]:
        return get_file(self.file(name))
