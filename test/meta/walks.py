#!/usr/bin/env python3
"""Checks that each row of the walks in DEVEL.md names a file of lib/ and functions that it defines, and that each
module that lib/index.mld names is there.

    walks.py ROOT
"""

import os
import re
import sys

import sources


def rows(text):
    """The rows of the tables of the chapter, as (file, functions)."""
    chapter = text.split("\n## Five walks\n", 1)[1].split("\n## ", 1)[0]
    for line in chapter.split("\n"):
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if len(cells) == 3 and cells[0].startswith("`"):
            yield cells[0].strip("`"), re.findall(r"`(\w+)`", cells[1])


def faults(root):
    """What does not fit the code, and the number of rows."""
    found, number = [], 0
    with open(os.path.join(root, "DEVEL.md")) as file:
        text = file.read()
    for path, functions in rows(text):
        number += 1
        source = os.path.join(root, "lib", path)
        if not os.path.exists(source):
            found.append(f"{path}: there is no such file")
            continue
        with open(source) as file:
            code = file.read()
        if not functions:
            found.append(f"{path}: a row without a function")
        for name in functions:
            if not re.search(rf"^\s*(let|and)( rec)? {name}\b", code, re.M):
                found.append(f"{path}: it defines no `{name}`")
    return found, number


def libraries(root):
    """The folder of each library, by its name."""
    folders = {}
    for path in sources.under(os.path.join(root, "lib"), "dune"):
        for name in re.findall(r"\(name (scc_\w+)\)", path.read_text()):
            folders[name] = path.parent
    return folders


def missing_modules(root):
    """The references of the index page that lead nowhere, and the number of all."""
    folders = libraries(root)
    with open(os.path.join(root, "lib", "index.mld")) as file:
        references = re.findall(r"\{!(\w+)(?:\.(\w+))?\}", file.read())
    found = []
    for library, module in references:
        folder = folders.get(library.lower())
        source = module and folder and os.path.join(folder, module.lower())
        there = folder and (not module or any(os.path.exists(source + ending) for ending in (".ml", ".mly", ".mll")))
        if not there:
            found.append(f"lib/index.mld: there is no {library}{'.' if module else ''}{module}")
    return found, len(references)


def main():
    found, number = faults(sys.argv[1])
    missing, references = missing_modules(sys.argv[1])
    found += missing
    if number < 50:
        found.append(f"DEVEL.md: {number} rows of walks, and 50 at least are expected")
    if references < 80:
        found.append(f"lib/index.mld: {references} references, and 80 at least are expected")
    for fault in found:
        print(fault)
    print(f"{number} rows of walks, {references} references, {len(found)} faults")
    sys.exit(1 if found else 0)


main()
