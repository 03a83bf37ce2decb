#!/usr/bin/env python3
"""Counts the values of interfaces whose documentation is missing, or cannot be read alone.

    docstrings.py [--list | --strict] FOLDER…

A value has documentation if a comment (** … *) stands right behind it, or right before it. It cannot be read alone if it
begins with "Of", "The same" or "Whether" (DEVEL.md, "Words"). The last line is
'N values: N without documentation, N that cannot be read alone'; --list names them; --strict as well, and ends with an
error if there are any.
"""
import re
import sys

import sources

ITEM = re.compile(r'\s*(val|external|type|module|exception|include|open|end|and|sig)\b')
ELLIPTIC = re.compile(r'(Of|The same|Whether|That of|Those)\b')


def comment_from(lines, i):
    """The text of the comment that begins in line i, and the line after it."""
    text, depth = [], 0
    while i < len(lines):
        text.append(lines[i])
        depth += lines[i].count('(*') - lines[i].count('*)')
        i += 1
        if depth <= 0:
            break
    return '\n'.join(text), i


def values(lines):
    """Each value with the text of its documentation, or None."""
    i, before = 0, None
    while i < len(lines):
        line = lines[i]
        if line.strip().startswith('(*'):
            text, i = comment_from(lines, i)
            before = text.strip() if text.strip().startswith('(**') and not text.strip().startswith('(** {') else None
            continue
        if not re.match(r'\s*(val|external)\b', line):
            before = None
            i += 1
            continue
        name, documented = re.match(r'\s*(?:val|external)\s+(\S+|\( \S+ \))', line).group(1), before
        before = None
        # To the end of its type: comments stand inside of it, too.
        i += 1
        while i < len(lines) and lines[i].strip() and not lines[i].strip().startswith('(*') and not ITEM.match(lines[i]):
            i += 1
        if i < len(lines) and lines[i].strip().startswith('(**') and not lines[i].strip().startswith('(** {'):
            documented, i = comment_from(lines, i)
        yield name, documented


def main(arguments):
    listed = '--list' in arguments or '--strict' in arguments
    without = elliptic = count = 0
    for folder in (a for a in arguments if not a.startswith('--')):
        for file in sources.under(folder, '.mli'):
            # The parser's is written by menhir.
            if file.name == 'parser.mli':
                continue
            for name, documentation in values(file.read_text().split('\n')):
                count += 1
                if documentation is None:
                    without += 1
                    if listed:
                        print(f'{file}: {name}: without documentation')
                elif ELLIPTIC.match(documentation.strip()[3:].strip()):
                    elliptic += 1
                    if listed:
                        print(f'{file}: {name}: cannot be read alone')
    print(f'{count} values: {without} without documentation, {elliptic} that cannot be read alone')
    return '--strict' in arguments and (without or elliptic or not count)


sys.exit(1 if main(sys.argv[1:]) else 0)
