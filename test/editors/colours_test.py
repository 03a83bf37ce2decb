#!/usr/bin/env python3
"""The colours of editors: every token of the real lexer, in every model, has a colour of its kind.

    colours_test.py REFERENCE WAY [GRAMMAR.so]

WAY is textmate, vim, emacs or tree-sitter (which has the compiled grammar besides). A word of the language that is a name in
its place may have the colour of either. Exit code 3: what it needs is not there. The last line is 'N passed, N failed'.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

from corpus import ROOT, Parser, models

HERE = os.path.dirname(os.path.abspath(__file__))
EDITORS = os.path.join(ROOT, "editors")
# By the kinds of reference.ml: what the name of a colour begins with.
KINDS = {
    "textmate": {
        "word": r"keyword\.|constant\.language|support\.constant\.event",
        "name": r"variable\.|entity\.|support\.",
        "barred_name": r"entity\.name\.tag",
        "number": r"constant\.numeric",
        "string": r"string\.|punctuation|constant\.character",
        "mark": r"keyword\.operator|punctuation\.",
        "label": r"punctuation\.",
        "line_comment": r"comment\.line",
        "block_comment": r"comment\.block",
    },
    "vim": {
        "word": r"scc(Keyword|Word|Constant)$",
        "name": r"scc(Name|Declared|Channel|Function|Atom)$",
        "barred_name": r"",
        "number": r"sccNumber$",
        "string": r"sccString$",
        "mark": r"sccOperator$|$",
        "label": r"$",
        "line_comment": r"sccComment$",
        "block_comment": r"sccComment$",
    },
    "emacs": {
        "word": r"font-lock-(keyword|constant)-face$",
        "name": r"(nil|font-lock-(type|function-name|variable-name|builtin)-face)$",
        "barred_name": r"",
        "number": r"font-lock-constant-face$",
        "string": r"font-lock-string-face$",
        "mark": r"nil$",
        "label": r"nil$",
        "line_comment": r"font-lock-comment(-delimiter)?-face$",
        "block_comment": r"font-lock-comment(-delimiter)?-face$",
    },
    "tree-sitter": {
        "word": r"keyword|boolean|constant\.builtin",
        "name": r"$|type|function|variable|property|constant|constructor|module|label|keyword$|keyword\.operator$",
        "barred_name": r"constructor",
        "number": r"number$",
        "string": r"string$",
        "mark": r"operator$|punctuation\.",
        "label": r"punctuation\.",
        "line_comment": r"comment$",
        "block_comment": r"comment$",
    },
}


class NotThere(Exception):
    """Something that is needed to look at the colours is not there."""


def need(program):
    if not shutil.which(program):
        raise NotThere(f"there is no {program}")


def by_textmate(texts, _work, _grammar):
    """Scopes by vscode-textmate; places are lines and columns of UTF-16."""
    need("node")
    extension = os.path.join(EDITORS, "vscode")
    if not os.path.isdir(os.path.join(extension, ".made", "node_modules", "vscode-textmate")):
        raise NotThere("the packages of editors/vscode are not installed")
    asked = []
    for _, text, places in texts:
        found = []
        for at in places:
            start = text.rfind(b"\n", 0, at) + 1
            found.append([text.count(b"\n", 0, at), len(text[start:at].decode().encode("utf-16-le")) // 2])
        asked.append(json.dumps({"text": text.decode(), "places": found}))
    done = subprocess.run(["node", os.path.join(HERE, "scopes.js"), extension], input="\n".join(asked), text=True,
                          stdout=subprocess.PIPE, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def written(texts, work, place):
    """Puts the texts into files and the places, by `place`, into a file of questions."""
    asked = os.path.join(work, "asked")
    with open(asked, "w", encoding="utf-8") as file:
        for i, (_, text, places) in enumerate(texts):
            path = os.path.join(work, f"{i}.sc")
            with open(path, "wb") as model:
                model.write(text)
            file.write(json.dumps({"path": path, "places": [place(text, at) for at in places]}) + "\n")
    return asked, os.path.join(work, "answer")


def answers(path):
    with open(path, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def by_vim(texts, work, _grammar):
    """Groups by Vim (vim-nox); places are lines and bytes."""
    need("vim.nox")

    def place(text, at):
        return [text.count(b"\n", 0, at) + 1, at - text.rfind(b"\n", 0, at)]

    asked, answer = written(texts, work, place)
    given = {"plugin": os.path.join(EDITORS, "vim"), "asked": asked, "answer": answer}
    subprocess.run(["vim.nox", "-es", "-u", "NONE", "-i", "NONE"]
                   + [word for name, value in given.items() for word in ("--cmd", f"let g:{name} = {value!r}")]
                   + ["-S", os.path.join(HERE, "groups.vim")], check=False, stdin=subprocess.DEVNULL, timeout=600)
    return answers(answer)


def by_emacs(texts, work, _grammar):
    """Faces by Emacs; places are characters."""
    need("emacs")
    asked, answer = written(texts, work, lambda text, at: len(text[:at].decode()) + 1)
    subprocess.run(["emacs", "-Q", "--batch", "-l", os.path.join(EDITORS, "emacs", "scc-mode.el"),
                    "-l", os.path.join(HERE, "faces.el"), "--", asked, answer], check=True, timeout=600)
    return answers(answer)


def by_tree_sitter(texts, _work, grammar):
    """Captures of highlights.scm, by tree_sitter; the last pattern that captures a node counts, as in Neovim."""
    try:
        import tree_sitter
    except ImportError:
        raise NotThere("tree_sitter of PyPI is not there") from None
    from trees_test import grammar as load
    parser = load(grammar)
    with open(os.path.join(EDITORS, "tree-sitter-scc", "queries", "highlights.scm"), encoding="utf-8") as file:
        query = tree_sitter.Query(parser.language, file.read())
    found = []
    for _, text, places in texts:
        colours, patterns = {}, {}
        for pattern, captures in tree_sitter.QueryCursor(query).matches(parser.parse(text).root_node):
            for name, nodes in captures.items():
                for node in nodes:
                    # A colour of a larger node is that of what is in it, if nothing in it has another one.
                    for at in (node.start_byte,) if node.child_count == 0 else range(node.start_byte, node.end_byte):
                        rank = (node.start_byte - node.end_byte, pattern)
                        if patterns.get(at, (-10 ** 9, -1)) <= rank:
                            colours[at], patterns[at] = name, rank
        found.append([colours.get(at, "") for at in places])
    return found


WAYS = {"textmate": by_textmate, "vim": by_vim, "emacs": by_emacs, "tree-sitter": by_tree_sitter}


def main():
    reference, way = sys.argv[1:3]
    real, texts = Parser(reference), []
    for name, text in models():
        answer = real(text)
        # Carriage returns alone are ends of lines for scc, and for no editor.
        if not answer["codes"] and not re.search(rb"\r(?!\n)", text):
            texts.append((name, text, answer["tokens"], {(a, b) for kind, a, b in answer["nodes"] if kind == "name"}))
    try:
        with tempfile.TemporaryDirectory() as work:
            found = WAYS[way]([(name, text, [a for _, a, _ in tokens]) for name, text, tokens, _ in texts], work,
                              (sys.argv[3:] or [None])[0])
    except NotThere as error:
        print(error)
        return 3
    if len(found) != len(texts):
        print(f"{len(found)} answers for {len(texts)} models")
        return 1
    passed = failed = told = 0
    for (name, text, tokens, names), colours in zip(texts, found):
        wrong = abs(len(tokens) - len(colours))
        for (kind, a, b), colour in zip(tokens, colours):
            wanted = KINDS[way][kind]
            good = re.match(wanted, colour) or (
                kind == "word" and (a, b) in names and re.match(KINDS[way]["name"], colour))
            if not good:
                wrong += 1
                told += 1
                if told <= 15:
                    start, end = text.rfind(b"\n", 0, a) + 1, text.find(b"\n", b)
                    print(f"{name}: the {kind} `{text[a:b].decode()}` is {colour!r} in: {text[start:end].decode()}")
        passed, failed = (passed, failed + 1) if wrong else (passed + 1, failed)
    print(f"models: {len(texts)}, their tokens: {sum(len(tokens) for _, _, tokens, _ in texts)}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
