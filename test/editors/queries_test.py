#!/usr/bin/env python3
"""The queries of the grammar for tree-sitter find in every model what they are for, by the real parser's trees.

    queries_test.py REFERENCE GRAMMAR.so

Tags are the declarations of names; folds begin and end where declarations do; definitions of names stand where the tree
has them; what is indented is in braces. Exit code 3: tree_sitter of PyPI is not there. The last line is 'N passed, N failed'.
"""
import os
import sys

from corpus import ROOT, Parser, models
from trees_test import grammar

QUERIES = os.path.join(ROOT, "editors", "tree-sitter-scc", "queries")
NAMED = ("shape", "compound", "behaviour", "process", "fixed", "param", "let", "check")
FOLDED = ("shape", "compound", "behaviour", "process", "fixed", "for", "motion", "network")


def spans(captures, *names):
    """The places of what has one of these names, or one that begins with it and a dot."""
    return {(node.start_byte, node.end_byte) for name, nodes in captures.items() for node in nodes
            if any(name == one or name.startswith(one + ".") for one in names)}


def declared(answer, kinds):
    return {(a, b) for kind, a, b in answer["nodes"] if kind in {one + "_declaration" for one in kinds}}


def main():
    try:
        import tree_sitter
    except ImportError:
        print("tree_sitter of PyPI is not there")
        return 3
    parser = grammar(sys.argv[2])
    real = Parser(sys.argv[1])

    def read(name):
        with open(os.path.join(QUERIES, name + ".scm"), encoding="utf-8") as file:
            return tree_sitter.QueryCursor(tree_sitter.Query(parser.language, file.read()))

    queries = {name: read(name) for name in ("tags", "folds", "indents", "locals")}
    passed = failed = 0
    for name, text in models():
        answer = real(text)
        if answer["codes"]:
            continue
        root = parser.parse(text).root_node
        found = {query: cursor.captures(root) for query, cursor in queries.items()}
        names = {(a, b) for kind, a, b in answer["nodes"] if kind == "name"}
        blocks = {(a, b) for kind, a, b in answer["tokens"] if kind == "block_comment"}
        for what, holds in (
                ("tags", spans(found["tags"], "definition") == declared(answer, NAMED)),
                ("folds", spans(found["folds"], "fold") == declared(answer, FOLDED) | blocks),
                ("locals", spans(found["locals"], "local.definition") <= names
                 and spans(found["locals"], "local.reference") <= names
                 and spans(found["locals"], "local.scope") >= declared(answer, ("for", "behaviour"))),
                ("indents", spans(found["indents"], "indent.end") == {
                    (a, b) for kind, a, b in answer["tokens"] if text[a:b] == b"}"})):
            if holds:
                passed += 1
            else:
                failed += 1
                print(f"{name}: {what}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
