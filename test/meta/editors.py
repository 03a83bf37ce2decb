"""What the texts say about editors agrees: editors.py ROOT.

Each folder of editors/ is in its README, specs/editors.md names the same editors, and both name the same versions."""

import os
import re
import sys

NAMES = ["Visual Studio Code", "Vim", "Neovim", "Emacs"]
FOLDERS = {"vscode": "vscode", "vim": "vim/", "neovim": "neovim/", "emacs": "emacs/", "tree-sitter-scc": "tree-sitter-scc/"}


def newest(text, editor):
    """The versions that a text names with 'or newer'."""
    return set(re.findall(editor + r" ([0-9.]*[0-9]) or\s+newer", text))


def main(root):
    texts = {}
    for name in ["editors/README.md", "specs/editors.md"]:
        with open(os.path.join(root, name), encoding="utf-8") as file:
            texts[name] = file.read()
    readme, specs = texts.values()
    faults = []
    for folder in sorted(os.listdir(os.path.join(root, "editors"))):
        if os.path.isdir(os.path.join(root, "editors", folder)) and FOLDERS.get(folder, folder) not in readme:
            faults.append(f"editors/README.md does not name {folder}")
    for name in NAMES + ["editors/README.md", "tree-sitter"]:
        if name not in specs:
            faults.append(f"specs/editors.md does not name {name}")
    for editor in ["Neovim", "Emacs"]:
        here, there = newest(readme, editor), newest(specs, editor)
        if here != there or len(here) != 1:
            faults.append(f"{editor}: {sorted(here)} in editors/README.md, {sorted(there)} in specs/editors.md")
    print("\n".join(faults + [f"{len(NAMES)} editors, {len(faults)} faults"]))
    return 1 if faults else 0


sys.exit(main(sys.argv[1]))
