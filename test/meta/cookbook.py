#!/usr/bin/env python3
"""The pages of specs/cookbook show their models as they are, and what the program prints.

    cookbook.py SCC ROOT            the last line is 'N passed, N failed'
    cookbook.py SCC ROOT --write    puts what is so into the pages, where it does not fit what they say

A page has its models in fences, ```sc NAME.sc, each the text of that file; every model is on a page. Its commands and what they
print are transcripts (transcripts.py), which run in a copy of ROOT's models. Every page is in the list of README.md.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

from transcripts import blocks, fits, transcripts

FENCE = re.compile(r"^```sc (\S+)\n(.*?)^```", re.M | re.S)


def printed(command, folder, environment):
    """The lines that a command prints."""
    run = subprocess.run(command, shell=True, cwd=folder, env=environment, text=True, timeout=600,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return run.stdout.rstrip("\n").split("\n") if run.stdout.strip() else []


class Book:
    """The pages, in a folder in which their commands run."""

    def __init__(self, scc, root, folder, write):
        self.pages, self.folder, self.write = os.path.join(root, "specs", "cookbook"), folder, write
        self.shown, self.passed, self.failed = set(), 0, 0
        for name in ("cookbook", "models"):
            shutil.copytree(os.path.join(root, "specs", name), os.path.join(folder, "specs", name))
        # copies of a build are read-only
        for base, folders, files in os.walk(folder):
            for name in folders + files:
                os.chmod(os.path.join(base, name), 0o755)
        os.mkdir(os.path.join(folder, "bin"))
        os.symlink(os.path.abspath(scc), os.path.join(folder, "bin", "scc"))
        path = os.path.join(folder, "bin") + os.pathsep + os.environ["PATH"]
        self.environment = {**os.environ, "PATH": path}

    def expect(self, holds, what):
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print(what)

    def model(self, page, name, text):
        """The text of a model, which the page shows as the given one."""
        self.shown.add(name)
        path = os.path.join(self.pages, name)
        if not os.path.exists(path):
            self.expect(False, f"{page}: there is no {name}")
            return text
        with open(path, encoding="utf-8") as file:
            wanted = file.read()
        if not self.write:
            self.expect(text == wanted, f"{page}: {name} has another text")
        return wanted

    def page(self, name):
        """Checks a page, or writes it."""
        path = os.path.join(self.pages, name)
        with open(path, encoding="utf-8") as file:
            content = file.read()
        content = FENCE.sub(lambda m: f"```sc {m[1]}\n{self.model(name, m[1], m[2])}```", content)
        edits = []
        for first, block in blocks(content):
            for at, command, said in transcripts(block):
                got = printed(command, self.folder, self.environment)
                edits.append((first + at, len(said), got if not fits(said, got) else said))
                if not self.write:
                    shown = "\n".join("  " + line for line in got)
                    self.expect(fits(said, got), f"specs/cookbook/{name}:{first + at}: $ {command}\n{shown}")
        self.expect(edits, f"{name} has no command")
        if self.write:
            lines = content.split("\n")
            for start, count, got in reversed(edits):
                lines[start:start + count] = ["    " + line if line else "" for line in got]
            with open(path, "w", encoding="utf-8") as file:
                file.write("\n".join(lines))


def main():
    scc, root = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as folder:
        book = Book(scc, root, folder, "--write" in sys.argv)
        names = sorted(os.listdir(book.pages))
        pages = [name for name in names if name.endswith(".md") and name != "README.md"]
        for name in pages:
            book.page(name)
        for name in names:
            if name.endswith(".sc"):
                book.expect(name in book.shown, f"{name} is on no page")
        with open(os.path.join(book.pages, "README.md"), encoding="utf-8") as file:
            listed = re.findall(r"\]\(([a-z-]+\.md)\)", file.read())
        book.expect(sorted(listed) == pages, "README.md lists other pages")
    print(f"{book.passed} passed, {book.failed} failed")
    return 1 if book.failed or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
