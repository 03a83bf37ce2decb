#!/usr/bin/env python3
"""Writes src/shapecalculus/commands.py: a function for each command, with the options that scc has.

    signatures.py SCC > commands.py

The options are those of `SCC COMMAND --help`. What an option takes follows from the name of its value there. A test
compares the module with what this program writes; `dune promote` accepts the difference.
"""

import keyword
import re
import subprocess
import sys
import textwrap

# Options that are no arguments: how scc prints. The functions choose it.
OURS = {"--json", "--color", "--help", "--version", "--progress", "--elsewhere", "--make"}

# By the name of the value: its type, and the function of _source that makes words of it.
KINDS = {
    "N": ("int", "integer"),
    "J": ("int", "integer"),
    "K": ("int", "integer"),
    "SEED": ("int", "integer"),
    "PIXELS": ("Number", "number"),
    "S": ("Number", "seconds"),
    "T": ("Number", "number"),
    "W": ("Number", "number"),
    "C": ("Number", "number"),
    "STEP": ("Number", "number"),
    "TIME": ("Number", "number"),
    "FILE": ("Path", "path"),
    "DIR": ("Path", "path"),
    "NAME,...": ("Texts", "listed"),
    "X,Y": ("Texts", "listed"),
    "X,Y,Z": ("Union[str, Sequence[Number]]", "numbered"),
    "Q,...": ("Union[str, Sequence[Number]]", "numbered"),
    "NAME": ("str", "text"),
    "LINK": ("str", "text"),
    "FORMULA": ("str", "text"),
    "PROPERTY": ("str", "text"),
    "NUMBER": ("str", "text"),
    "FORMAT": ("str", "text"),
    "ORDER": ("str", "text"),
    "HOW": ("str", "text"),
    "POLICY": ("str", "text"),
    "START": ("str", "text"),
    "WHICH": ("str", "text"),
    "K/N": ("str", "text"),
}
OTHER = ("Union[Number, Path]", "other")

# The type of the result; and the options that decide where and how it is written.
COMMANDS = {
    "check": ("Checked", []),
    "estimate": ("Estimated", []),
    "simulate": ("Simulated", ["output", "resume", "summary", "format"]),
    "sweep": ("Swept", ["output", "resume", "part", "format"]),
    "trace": ("Traced", ["output", "human", "itf"]),
    "view": ("Viewed", ["output"]),
}

FIRST = {
    "check": "Explores a model and verifies its properties, as ``scc check`` does. Verdicts are no errors.",
    "estimate": "Estimates probabilities and means from random runs, as ``scc estimate`` does.",
    "simulate": "Makes random runs and observes them, as ``scc simulate`` does.",
    "sweep": "Checks a model over a grid of parameters, as ``scc sweep`` does.",
    "trace": "Follows one run, as ``scc trace`` does.",
    "view": "Makes a page or a picture of a model, as ``scc view`` does.",
}
LAST = (
    "``scc``: the program; by default that of the environment variable SCC, or the one that this package carries, or the "
    "one on the PATH. ``progress``: True shows progress on standard error, and a function gets each line of it. The "
    "first Ctrl-C ends the command, and the result is what was there then (``interrupted``); the second is a "
    "KeyboardInterrupt. Raises CommandFailed."
)
HEAD = '''"""The commands of scc, as functions. Written by signatures.py from the manuals of scc; do not edit."""

from __future__ import annotations

from typing import Mapping, Optional, Sequence, Union

from . import _calls
from . import _source as words
from ._process import Progress
from ._source import Path, Setting, Source, Texts, Values
from .numbers import Number
from .results import Estimated, Simulated, Swept, Traced, Viewed
from .where import Checked
'''


class Option:
    """An option of a command: its long name, the name of its value (None: a flag), and what its manual says."""

    def __init__(self, head, text):
        match = re.search(r"(--[a-z-]+)(?:=([^ ,]+(?:,[^ ]+)*))?", head)
        self.long, self.value, self.text = match[1], match[2], text
        self.required = "(required)" in head
        name = self.long[2:].replace("-", "_")
        self.name = name + "_" if keyword.iskeyword(name) else name
        self.several = "several times" in text or "Repeatable" in text

    def kind(self):
        """The type of the argument, and the words that it makes."""
        if self.value is None:
            return "bool", "words.flag(%r, %s)" % (self.long, self.name)
        if self.value == "NAME=VALUES":
            return "Mapping[str, Values]", "words.grid(model, %s)" % self.name
        if self.long == "--define":
            return "Mapping[str, Setting]", "words.define(model, %s)" % self.name
        if self.value == "NAME=VALUE":
            return "Mapping[str, Number]", "words.each(%r, %s)" % (self.long, self.name)
        if self.several:
            return "Texts", "words.texts(%r, %s)" % (self.long, self.name)
        kind, function = KINDS.get(self.value, OTHER)
        return kind, "words.%s(%r, %s)" % (function, self.long, self.name)

    def parameter(self):
        kind, _ = self.kind()
        if self.long == "--format":
            return '%s: %s = "jsonl"' % (self.name, kind)
        if self.value is None:
            return "%s: bool = False" % self.name
        return "%s: %s" % (self.name, kind) if self.required else "%s: Optional[%s] = None" % (self.name, kind)


def options(scc, command):
    """The options of a command, required ones first."""
    lines = subprocess.run([scc, command, "--help=plain"], check=True, capture_output=True, text=True).stdout.split("\n")
    found, before = [], ""
    for line in lines:
        if re.match(r" {7}-", line) and (before == "" or not before.startswith(" ")):
            found.append([line.strip(), []])
        elif re.match(r" {11}\S", line) and found and found[-1][1] is not None:
            found[-1][1].append(line.strip())
        elif found and line.strip() and not line.startswith(" " * 11):
            found.append(["", None])
        before = line
    all_ = [Option(head, " ".join(text)) for head, text in found if text is not None]
    all_ = [option for option in all_ if option.long not in OURS]
    return sorted(all_, key=lambda option: not option.required)


def wrapped(text, indent, hanging=""):
    return "\n".join(textwrap.wrap(text, 112, initial_indent=indent, subsequent_indent=indent + hanging,
                                   break_on_hyphens=False, break_long_words=False))


def docstring(command, all_):
    lines = [wrapped(FIRST[command] + " Options:", "    ").strip(), ""]
    for option in all_:
        text = option.text.replace("\\", "\\\\").replace('"""', "'''")
        lines.append(wrapped("``%s``: %s" % (option.name, text), "    ", "  "))
    lines += ["", wrapped(LAST, "    ")]
    return '    """%s\n    """' % "\n".join(lines)


def function(scc, command):
    result, again = COMMANDS[command]
    all_ = options(scc, command)
    star = sum(option.required for option in all_) if command == "sweep" else 0
    parameters = [option.parameter() for option in all_]
    parameters[star:star] = ["*"]
    if command == "sweep":
        parameters.append("options: Sequence[str] = ()")
    signature = ["model: Source", *parameters, "scc: Optional[str] = None", "progress: Progress = None"]
    lines = ["", "", "def %s(" % command, *("    %s," % p for p in signature), ") -> %s:" % result]
    lines.append(docstring(command, all_))
    lines.append("    given = [")
    lines += ["        *%s," % option.kind()[1] for option in all_]
    lines.append("        *options,\n    ]" if command == "sweep" else "    ]")
    more = "".join(", %s=%s" % (name, name) for name in again)
    lines.append("    return _calls.%s(model, given, scc, progress%s)" % (command, more))
    return "\n".join(lines).replace("'--", '"--').replace("', ", '", ')


def main():
    sys.stdout.write(HEAD + "".join(function(sys.argv[1], command) for command in COMMANDS) + "\n")


if __name__ == "__main__":
    main()
