"""The models of the repository, and what the real parser says about texts."""
import json
import os
import re
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDERS = ("specs", "test", "clients", "editors")
LEFT_OUT = {"_build", ".venv", ".made"}


def files(ending):
    """The paths of the files of the repository with this ending, sorted."""
    found = []
    for folder in FOLDERS:
        for base, folders, names in os.walk(os.path.join(ROOT, folder)):
            folders[:] = [name for name in folders if name not in LEFT_OUT]
            found += [os.path.join(base, name) for name in names if name.endswith(ending)]
    return sorted(found)


def models():
    """Pairs of a name and the bytes of a model: all files of models, and all examples of the reference of the language."""
    found = []
    for path in files(".sc"):
        with open(path, "rb") as file:
            found.append((os.path.relpath(path, ROOT), file.read()))
    with open(os.path.join(ROOT, "specs", "language.md"), encoding="utf-8") as file:
        examples = re.findall(r"^```sc\n(.*?)^```", file.read(), re.M | re.S)
    return found + [(f"specs/language.md, example {i}", text.encode()) for i, text in enumerate(examples, 1)]


class Parser:
    """The real parser (reference.ml), as a process."""

    def __init__(self, program):
        self.program = program
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def __call__(self, text):
        self.process.stdin.write(b"%d\n%b" % (len(text), text))
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def words(self):
        """The words of the language."""
        return subprocess.run([self.program, "words"], stdout=subprocess.PIPE, text=True, check=True).stdout.split()
