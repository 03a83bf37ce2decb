#!/usr/bin/env python3
"""Finds sentences of too many words in Markdown files.

    sentences.py [--limit N] FILE…

Of a folder, all files are read whose names end in '.md'. A sentence of more than N words, 40 unless --limit says
otherwise, is an error: a line 'FILE:LINE: N words: SENTENCE' for each, and exit code 1. The last line of the output is
'N sentences: N of over N words'.

Paragraphs, headings, list items and table cells are blocks: no sentence continues from one block into the next. A list
can so take the long part of a sentence. Blocks of code have no sentences. A code span counts as one word, a link as the
words of its text, and a sign without a letter or digit, such as '=' or '+', as none.

    python3 -m doctest sentences.py    # the examples in this file
"""
import re
import sys
from pathlib import Path

import sources

FENCE = re.compile(r'\s*(```|~~~)')
ITEM = re.compile(r'(\s*)([-*+]|\d+[.)])\s+')
RULE = re.compile(r'\s*\|?[\s:|-]+\|?\s*$')
HEADING = re.compile(r'\s*#+\s')
CODE = re.compile(r'(`+)(?!`)(.+?)(?<!`)\1(?!`)', re.S)
LINK = re.compile(r'!?\[([^\]]*)\]\([^)\s]*\)')
COMMENT = re.compile(r'<!--.*?-->', re.S)

# A full stop behind one of these ends no sentence.
SHORT = {'e.g.', 'i.e.', 'cf.', 'vs.', 'fig.', 'figs.', 'no.', 'nos.', 'sec.', 'ch.', 'def.', 'eq.', 'approx.', 'et al.',
         'ca.', 'p.', 'pp.', 'vol.', 'dr.', 'st.', 'resp.'}
# These end one if a capital follows.
OPEN = {'etc.', 'al.'}
END = re.compile(r'[.!?…]["\')\]*_”’]*$')


def fill(match, text):
    """The text in place of the match, with the match's line breaks behind it."""
    return text + '\n' * match.group(0).count('\n')


def without_marks(text):
    """The text with one word for each code span, links as their texts, and without comments and emphasis.

    >>> without_marks('See `a b. C` in [the book](book.md), *now*.')
    'See `…` in the book, now.'
    """
    text = COMMENT.sub(lambda m: fill(m, ''), text)
    text = CODE.sub(lambda m: fill(m, '`…`'), text)
    text = LINK.sub(lambda m: m.group(1), text)
    return re.sub(r'(?<![\w\\])[*_]{1,3}(?=\S)|(?<=\S)[*_]{1,3}(?!\w)', '', text)


def ends(word, following):
    """True if a sentence ends with this word, when that one (or None) follows.

    >>> [ends(w, f) for w, f in [('end.', 'The'), ('end.', 'scc'), ('end', 'The'), ('`…`.', 'So'), ('stop.)', 'It')]]
    [True, True, False, True, True]
    >>> [ends(w, f) for w, f in [('e.g.', 'this'), ('(cf.', 'Moreau)'), ('etc.', 'The'), ('etc.', 'as'), ('R.', 'An')]]
    [False, False, True, False, True]
    >>> [ends(w, f) for w, f in [('…,', 'n'), ('1,', '…'), ('c₁,…', 'Then'), ('time…', 'is'), ('really?"', 'asks')]]
    [False, False, True, False, True]
    """
    if following is None:
        return True
    if not END.search(word):
        return False
    bare = word.lstrip('("\'[*_“‘').rstrip('")\']*_”’')
    low = bare.lower()
    if low in SHORT or re.fullmatch(r'(?:[A-Z]\.){2,}', bare):
        return False
    if low in OPEN or bare.endswith('…') or bare.endswith('...'):
        return bool(re.match(r'["\'(\[“‘]*[A-Z]', following)) and bare not in ('…', '...')
    return True


def sentences(text, line=1):
    """The sentences of one block that begins in this line: of each its line, its words and its text.

    >>> [(n, count) for n, count, _ in sentences('One two. Three four\\nfive, e.g. six.\\nSeven = 7.')]
    [(1, 2), (1, 5), (3, 2)]
    >>> [count for _, count, _ in sentences('So `f U g` is it. x(p) + 1 is not.')]
    [4, 4]
    """
    words = []
    for row in without_marks(text).split('\n'):
        words += [(line, word) for word in row.split()]
        line += 1
    current = []
    for i, (_, word) in enumerate(words):
        current.append(words[i])
        if ends(word, words[i + 1][1] if i + 1 < len(words) else None):
            yield current[0][0], sum(1 for _, w in current if re.search(r'\w|`', w)), ' '.join(w for _, w in current)
            current = []


def cells(row):
    """The cells of a row of a table; a bar in a code span or behind a backslash parts none.

    >>> cells('| one | `a | b` | three \\\\| four |')
    ['one', '`a | b`', 'three \\\\| four']
    """
    hidden = CODE.sub(lambda m: m.group(0).replace('|', '\0'), row).replace('\\|', '\1')
    return [c.strip().replace('\0', '|').replace('\1', '\\|') for c in hidden.strip().strip('|').split('|')]


def blocks(text):
    r"""The blocks of a Markdown text, each with the number of its first line.

    >>> list(blocks('# A\nb\nc\n\n- d\n  e\n- f\n\ng\n\n    code\n\n```\ncode\n```\n| h | i |\n|---|---|\n| j | k |'))
    [(1, '# A'), (2, 'b\nc'), (5, 'd\n  e'), (7, 'f'), (9, 'g'), (16, 'h'), (16, 'i'), (18, 'j'), (18, 'k')]
    >>> list(blocks('- a\n\n  of the item\n\nb\n    c\n\n    code'))
    [(1, 'a'), (3, '  of the item'), (5, 'b\n    c')]
    >>> list(blocks('1.  a\n    - b\n\n      of b\n\n    of a\n\n          code of a'))
    [(1, 'a'), (2, 'b'), (4, '      of b'), (6, '    of a')]
    >>> list(blocks('a\n\n    b\n      1. code\n      - code'))
    [(1, 'a')]
    """
    first, lines, fenced, inside = 0, [], False, 0

    def flush():
        nonlocal lines
        done, lines = lines, []
        return [(first, '\n'.join(done))] if done else []

    for number, row in enumerate(text.split('\n'), 1):
        if FENCE.match(row):
            yield from flush()
            fenced = not fenced
            continue
        if fenced:
            continue
        if not row.strip():
            yield from flush()
            continue
        row = re.sub(r'^\s*>\s?', '', row)
        item, indent = ITEM.match(row), len(row) - len(row.lstrip())
        if not lines:
            if indent >= inside + 4:
                continue
            if not item:
                inside = min(inside, indent)
        if row.lstrip().startswith('|'):
            yield from flush()
            if not RULE.match(row):
                yield from ((number, c) for c in cells(row))
        elif HEADING.match(row):
            yield from flush()
            yield number, row
        else:
            if item:
                yield from flush()
                inside = item.end()
                row = row[inside:]
            if not lines:
                first = number
            lines.append(row)
    yield from flush()


def main(arguments):
    limit = 40
    if arguments[:1] == ['--limit']:
        limit, arguments = int(arguments[1]), arguments[2:]
    count = long = 0
    files = []
    for name in map(Path, arguments):
        files += sources.under(name, '.md') if name.is_dir() else [name]
    for file in files:
        for line, block in blocks(file.read_text(encoding='utf-8')):
            for at, words, sentence in sentences(block, line):
                count += 1
                if words > limit:
                    long += 1
                    print(f'{file}:{at}: {words} words: {sentence}')
    print(f'{count} sentences: {long} of over {limit} words')
    return 1 if long or not count else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
