"""What the validations share: running scc, and a table of what was compared."""

import json
import os
import re
import shutil
import subprocess
import sys
import tarfile

MODELS = "specs/models"


class Run:
    """One check: NAME_check.py SCC FOLDER, where FOLDER is empty and for it alone."""

    def __init__(self, title):
        self.scc, self.folder = sys.argv[1:3]
        self.passed = 0
        self.failed = 0
        self.left_out = []
        print(title)

    def ok(self, condition, what):
        """Counts a comparison; prints it when it fails."""
        if condition:
            self.passed += 1
        else:
            self.failed += 1
            print(f"  FAILED: {what}")
        return condition

    def skip(self, what, why):
        self.left_out.append((what, why))

    def end(self):
        by_reason = {}
        for what, why in self.left_out:
            by_reason.setdefault(why, []).append(what)
        for why, what in by_reason.items():
            print(f"  left out, {why}: {', '.join(what)}")
        print(f"  {self.passed} passed, {self.failed} failed, {len(self.left_out)} left out")

    def path(self, name):
        return os.path.join(self.folder, name)

    def call(self, *words, timeout=600):
        return subprocess.run([self.scc, *words], capture_output=True, text=True, timeout=timeout)

    def verdicts(self, model, *words):
        """The report of scc check, or None when it refuses the model."""
        result = self.call("check", model, "--json", *words)
        report = json.loads(result.stdout)
        return report if report.get("format") == "scc-check" else None


def absent(what):
    """Ends the check: nothing was compared."""
    print(what)
    sys.exit(3)


def npm_pack(package, folder):
    """The archive of an npm package, of the version that its name has, fetched into the folder."""
    if shutil.which("npm") is None:
        absent("there is no npm")
    try:
        words = ["npm", "pack", "--silent", package]
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=600)
    except subprocess.TimeoutExpired:
        absent(f"npm does not get {package}")
    if done.returncode != 0:
        absent(f"npm does not get {package}: {done.stderr.strip()[-200:]}")
    return tarfile.open(os.path.join(folder, done.stdout.split()[-1]))


def models():
    names = sorted(name[:-3] for name in os.listdir(MODELS) if name.endswith(".sc"))
    return [name for name in names if not is_open(f"{MODELS}/{name}.sc")]


def is_open(model):
    """Its start, or the instants of its splits, are left open: its states are not listed one by one."""
    with open(model, encoding="utf-8") as file:
        return re.search(r"^(param \w+ in [\[(]|split_step any)", file.read(), re.M) is not None
