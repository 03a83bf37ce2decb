#!/usr/bin/env python3
"""The package of the extension for Visual Studio Code has what it should, and its bundle loads.

    package_test.py WORK    makes it in the folder WORK, by editors/vscode/package.sh; exit code 0 if all is right
"""
import json
import os
import subprocess
import sys
import zipfile

from corpus import ROOT

WANTED = {
    "[Content_Types].xml", "extension.vsixmanifest", "extension/package.json", "extension/readme.md", "extension/LICENSE.txt",
    "extension/language-configuration.json", "extension/dist/extension.js", "extension/snippets/scc.json",
    "extension/syntaxes/scc.tmLanguage.json"}


def main():
    path = os.path.join(os.path.abspath(sys.argv[1]), "scc.vsix")
    made = subprocess.run([os.path.join(ROOT, "editors", "vscode", "package.sh"), path], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    if made.returncode:
        print(made.stdout)
        return 1
    with zipfile.ZipFile(path) as archive:
        names = set(archive.namelist())
        archive.extractall(sys.argv[1])
    if names != WANTED:
        print(f"missing: {sorted(WANTED - names)}, more: {sorted(names - WANTED)}")
        return 1
    folder = os.path.join(os.path.abspath(sys.argv[1]), "extension")
    with open(os.path.join(folder, "package.json"), encoding="utf-8") as file:
        main_file = json.load(file)["main"]
    # All that the bundle needs is in it, but for the editor itself.
    loads = ("const m = require('module'), load = m._load, seen = new Proxy(function () {}, "
             "{get: (t, k) => k === Symbol.toPrimitive ? () => '1.90.0' : k === 'prototype' ? t.prototype : seen, "
             "apply: () => seen, construct: () => ({})});"
             "m._load = (n, ...r) => n === 'vscode' ? seen : load(n, ...r);"
             f"const e = require({json.dumps(os.path.join(folder, main_file))});"
             "process.exit(typeof e.activate === 'function' && typeof e.deactivate === 'function' ? 0 : 1)")
    done = subprocess.run(["node", "-e", loads], check=False)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
