"""Which scc is called: the one in this package, where it carries one, or one of the system."""

from __future__ import annotations

import errno
import os
import platform
import sys
from typing import List, Optional

#: Where a wheel made by ``scripts/package wheel`` has the program. A package installed from the source has none.
CARRIED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "program", "scc")

HINT = "install scc for this machine, and name it in the environment variable SCC"


def scc_path(scc: Optional[str]) -> str:
    """The program: the one that is named, or that of the environment variable SCC, or the one that this package
    carries, or the one that PATH finds."""
    return scc or os.environ.get("SCC") or (CARRIED if os.path.exists(CARRIED) else "scc")


def why_not(command: str, error: Exception) -> str:
    """Why a program could not be started, and what to do about it."""
    code = getattr(error, "errno", None)
    text = "cannot start %s: %s" % (command, getattr(error, "strerror", None) or error)
    if command == CARRIED and code == errno.ENOEXEC:
        machine = "%s on %s" % (platform.system(), platform.machine())
        return "%s: the program of this package is for another machine than this one (%s); %s" % (text, machine, HINT)
    if command == CARRIED and code in (errno.EACCES, errno.EPERM):
        return "%s: its folder may be mounted without the right to run programs; %s" % (text, HINT)
    if code == errno.ENOENT and os.path.exists(command):
        return "%s: a library or the loader that it names is missing on this system; %s" % (text, HINT)
    if code == errno.ENOENT:
        return "%s: name the program in the environment variable SCC, or put it on the PATH" % text
    return text


def main(words: Optional[List[str]] = None) -> int:
    """The command ``scc`` that a wheel installs: becomes the program of this package. It returns only if the program
    cannot be started: 69, after a message."""
    try:
        os.execv(CARRIED, ["scc", *(sys.argv[1:] if words is None else words)])
    except OSError as error:
        sys.stderr.write("scc: %s\n" % why_not(CARRIED, error))
    return 69
