"""Mistakes in the code that tests have to notice: each is made in a copy of the source tree, alone.

A program of mistakes (`teeth.py` of laws/symbolic and of laws/networks) calls `main`. Its options are those of
`main`'s parser; its exit code is 0 if each mistake is noticed.
"""

from __future__ import annotations

import argparse
import os
import resource
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path
from typing import Dict, List, NamedTuple, Tuple

ROOT = Path(__file__).resolve().parents[2]
COPIED_FOLDERS = ("lib", "test", "specs", "bin", "clients", "scripts", "web")
COPIED_FILES = ("dune", "dune-project", "scc.opam")
SECONDS = 120
ADDRESS_SPACE = 3 << 30

# name: (file below the room, what stands there once, what is put in its place)
Mistakes = Dict[str, Tuple[str, str, str]]


class Test(NamedTuple):
    """A test: its program, relative to the root, as dune builds it; and a command that runs it, if not itself.

    The command runs in the root of the copy. A program that runs itself does so in its own source folder.
    """

    program: str
    command: Tuple[str, ...] = ()

    def name(self) -> str:
        return " ".join(self.command) or self.program


class Program(NamedTuple):
    """What a program of mistakes breaks, and which tests have to notice it, the quickest first."""

    about: str
    room: str
    mistakes: Mistakes
    tests: List[Test]


def build(tree: Path, tests: List[Test]) -> str:
    """What the compiler complains of."""
    done = subprocess.run(
        ["dune", "build", *(t.program for t in tests)],
        cwd=tree, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )
    return done.stdout if done.returncode else ""


def is_failure(line: str) -> bool:
    """Whether a line of a test's output reports a failure; the rest of the test is not needed then."""
    return "[FAIL]" in line or line.startswith(("differed: ", "failed: "))


def limit() -> None:
    """Limits the memory and the time on a processor of a test; it does not matter how busy the machine is."""
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))


def outcome(tree: Path, test: Test) -> str:
    """How a test fails: the line that reports it, or that it does not end; empty if it passes."""
    process = subprocess.Popen(
        test.command or (tree / "_build" / "default" / test.program,),
        cwd=tree if test.command else (tree / test.program).parent, text=True, errors="replace",
        env={**os.environ, "SCC_NO_SHRINKING": "1"}, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        preexec_fn=limit,
    )
    assert process.stdout
    failure = next((line.strip() for line in process.stdout if is_failure(line)), "")
    if failure:
        process.kill()
    process.stdout.close()
    code = process.wait()
    if not failure and code in (-signal.SIGXCPU, -signal.SIGKILL):
        return "it does not end"
    return failure or (f"exit code {code}" if code else "")


def noticed_by(tree: Path, tests: List[Test]) -> str:
    """The first test that fails, and how; empty if all pass."""
    for test in tests:
        failure = outcome(tree, test)
        if failure:
            return f"{test.name()} ({' '.join(failure.split())[:80]})"
    return ""


def places(program: Program) -> int:
    """Reports each mistake whose text is not there once, since the code has changed."""
    texts = {file: (ROOT / program.room / file).read_text() for file, _, _ in program.mistakes.values()}
    lost = [name for name, (file, old, _) in program.mistakes.items() if texts[file].count(old) != 1]
    for name in lost:
        print(f"no place for '{name}': what it replaces is not in {program.mistakes[name][0]} once")
    print(f"{len(program.mistakes) - len(lost)} passed, {len(lost)} failed")
    return 1 if lost else 0


def copy_to(tree: Path) -> None:
    for folder in COPIED_FOLDERS:
        shutil.copytree(ROOT / folder, tree / folder, dirs_exist_ok=True)
    for file in COPIED_FILES:
        shutil.copy(ROOT / file, tree / file)


def made(tree: Path, program: Program, name: str) -> Tuple[str, str]:
    """(which test notices a mistake, or empty; why the mistake cannot be made, or empty)."""
    file, old, new = program.mistakes[name]
    path = tree / program.room / file
    text = path.read_text()
    if text.count(old) != 1:
        return "", f"`{old}` is not there once"
    path.write_text(text.replace(old, new))
    try:
        complaint = build(tree, program.tests)
        return ("", complaint) if complaint else (noticed_by(tree, program.tests), "")
    finally:
        path.write_text(text)


def judge(tree: Path, program: Program, names: List[str]) -> int:
    copy_to(tree)
    first = build(tree, program.tests) or noticed_by(tree, program.tests)
    if first:
        print(f"without a mistake: {first}")
        return 1
    wrong = 0
    for name in names:
        by, complaint = made(tree, program, name)
        print(f"{name}: " + (f"noticed by {by}" if by else complaint[:600] or "NOT NOTICED"), flush=True)
        wrong += not by
    print(f"{len(names)} mistakes, {wrong} not noticed")
    return 1 if wrong else 0


def main(program: Program) -> int:
    options = argparse.ArgumentParser(
        description=program.about, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--tree", type=Path, help="where the copy is kept")
    options.add_argument("--places", action="store_true", help="only whether each can be made")
    options.add_argument("names", nargs="*", help="of mistakes; all by default")
    given = options.parse_args()
    unknown = [name for name in given.names if name not in program.mistakes]
    if unknown:
        options.error(f"there is no mistake '{unknown[0]}'")
    if given.places:
        return places(program)
    names = given.names or list(program.mistakes)
    if given.tree:
        return judge(given.tree, program, names)
    with tempfile.TemporaryDirectory() as folder:
        return judge(Path(folder), program, names)
