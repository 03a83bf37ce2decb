#!/usr/bin/env python3
"""Checks that each row of the walks in DEVEL.md names a file of lib/ and functions that it defines.

    walks.py ROOT
"""

import os
import re
import sys


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


def main():
    found, number = faults(sys.argv[1])
    if number < 50:
        found.append(f"DEVEL.md: {number} rows of walks, and 50 at least are expected")
    for fault in found:
        print(fault)
    print(f"{number} rows of walks, {len(found)} faults")
    sys.exit(1 if found else 0)


main()
