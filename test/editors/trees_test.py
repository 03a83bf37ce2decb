#!/usr/bin/env python3
"""The grammar for tree-sitter accepts what the real parser accepts, and finds the same trees.

    trees_test.py REFERENCE GRAMMAR.so [--count 10000] [--seed 1]

REFERENCE is reference.exe, and GRAMMAR.so the compiled grammar. Compared are all models, texts with each word of the
language in each place of a name, operators in the places of operators, and COUNT mutated models: tokens deleted, duplicated, swapped, replaced; expressions,
behaviours and other pieces in the places of others. Not compared are the limits of the language (numbers of thousands of
digits, depths of thousands), and a text without declarations: the grammar has none. It needs tree_sitter of PyPI; without
it the exit code is 3. The last line is 'N passed, N failed'.
"""
import argparse
import ctypes
import random
import sys
from collections import Counter

from corpus import Parser, models

LIMITS = {"SC0106", "SC0111", "SC0112"}
PLACES = (  # of names
    "model W", "param W = 1", "let a = W", "let a = W[1]", "let a = W.x + 1", "let a = b.W", "let a = b.W[2]", "let a = W(2)",
    "let a = b.W(2)", "let a = ~W", "let a = -W * 2 < W", "let a = if W then W else W", "import <W> (W as W)", "import <a> as W",
    "check W: AG W => W", "check a: A[W U W]", "check a: E[W U [1, 2] W]", "check a: forall W in W: W", "check a: event W",
    "check a: event W(W, W)", "check a: P >= W [ W U W ]", "check a: P = ? [ W at W ]", "check a: W leads_to W within W",
    "check a: possibly [<= W] W", "check a: count(W in W: W) = 1", "check a: count(i in W..2 if W: W) = 1",
    "dynamics W", "collisions W", "round W 1", "resolution W", "timestep W", "split_step W", "timestep 1 W", "network W || W[1]",
    "shape W = W", "shape W(W) = W.W(1) scaled W where W = 1", 'shape W = mesh "f" W', "shape a = hull { W (1) W (1, 2, 3) }",
    "shape W { vertices W (1,2,3) faces W [W, W] }", "compound W { part W : W glue W.W ~ W.[W] }",
    'compound W = decompose "f" W', "behaviour W = W", "behaviour W on W = W", "behaviour W[W] = W.W[1]", "behaviour W(W) = W(1)",
    "behaviour a = <W, {W}>. nil", "behaviour a = <~W, {W.W, [W, W], W.[W]}>. W", "behaviour a = <a, {only W, W[1].W}>. nil",
    "behaviour a = omega(W, {W}) W 1. nil", "behaviour a = omega(a, {b}) push(W) chance W. nil",
    "behaviour a = rho({<W, {W}>}). nil", "behaviour a = eps(W). W + W", "process W = W [W]", "process W[1] = W : W mass W [nil]",
    "process a = W[1] : W velocity W.W at translate W * scale W [nil] <W, {W, W}> W : W(1) [W]", "fixed W = W W",
    "fixed W = W spin W at matrix ((W,0,0,0),(0,W,0,0),(0,0,W,0),(0,0,0,W))", "bond <W, {W, W.W[W].[W]}>",
    "for W in 1..W if W { let W = 1 }", "motion W", "motion W = W spin W", "motion W(1)", "motion (W)", "motion W[1].W = inertial",
    "motion choose { W, for W in 1..2: W weight W }", "motion a = choose { W spin W weight W }", "W", "W W = 1", "let a = 1 W",
    "let a = W W b = 1", "process p = a mass m W 2 [nil]",
)
# Of expressions: each stands in the place of each letter of each other one, without brackets.
OPERATORS = (
    "L + R", "L - R", "L * R", "L / R", "L mod R", "-R", "L < R", "L = R", "L and R", "L or R", "L => R", "not R", "AG R",
    "AX R", "EF[1, 2] R", "possibly R", "always R within S", "eventually [<= S] R", "L leads_to R", "L leads_to R within S",
    "L leads_to[<= S] R", "if S then L else R", "forall i in S: R", "exists i in 1..S if L: R", "count(i in L: R)", "A[L U R]",
    "E[L U[1, 2] R]", "P >= S [ L U R ]", "P = ? [ R ]", "E = ? [ L at R ]", "f(L, R)", "(L, R, S)", "(R).x", "f(L).x", "event bind(L)")
TRICKY = (  # texts between tokens, and tokens that only what comes after them tells
    "let a = 1 /* a /* b */ c */ + 2", "let a = 1 /* a /* b */ + 2", "let a = 1 /* a */ b */", "let a = 1 // /* a\nlet b = 2 // */",
    "let a = 1 / /* b */ 0", "let a = 1 / // b\n 0.0", "let a = 1 / 0.5", "let a = 1 / 00", "let a = 1/0e5", "let a = 1/0x",
    "fixed a = b[1] /* c */ : c", "fixed a = b[1 /* ] */] : c", 'fixed a = b["]"] : c', "process a = b[c[1]] : d [e[1]] <a, {b, c}> e : f [nil]",
    "process a = b[1 let c : 2] : d", "process a = b [(c[1] : d)]", 'import "a\\"b" as c', 'import "a\\b"', 'import "a\\"', 'import "a\nb"',
    "param a in [1, 2]", "param a in (1, 2] check b : c", "let a = 1..2", "for i in 1..2.5 { }", "let a = 2^-3 - 2^-03", "let a = 1.e", "let a = 1e-5x",
    "\ufefflet a = 1", "let a = 1\x0c", "let a = 1\x0b", "let a = 1 // \x01", "behaviour b = ⟨a\u0304, {f}⟩ · ω(\u0101, {f}) . ε(1) · nil",
    "network a ‖ b || c", "let a = 1 < 2 < 3", "let a = 1 <= 2 = ?", "let a = not 1 < 2 = 3", "check a : b leads_to c leads_to d")


def combined(random, count):
    """Expressions of operators in the places of operators: all pairs, and COUNT deeper ones."""
    letters = ("L", "R", "S")

    def fill(template, inner):
        return "".join(inner(letter) if letter in letters else letter for letter in template)

    for outer in OPERATORS:
        for inner in OPERATORS:
            for place in letters:
                if place in outer:
                    yield fill(outer, lambda at: fill(inner, str.lower) if at == place else at.lower())
    for _ in range(count):
        def deeper(depth):
            return random.choice("abc12") if depth == 0 or random.random() < 0.2 else fill(
                random.choice(OPERATORS), lambda _: deeper(depth - 1))
        yield deeper(4)


def grammar(path):
    """The parser of tree-sitter for a compiled grammar."""
    import tree_sitter
    library = ctypes.cdll.LoadLibrary(path)
    library.tree_sitter_scc.restype = ctypes.c_void_p
    new = ctypes.pythonapi.PyCapsule_New
    new.restype, new.argtypes = ctypes.py_object, (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)
    return tree_sitter.Parser(tree_sitter.Language(new(library.tree_sitter_scc(), b"tree_sitter.Language", None)))


def nodes(tree, kinds):
    """The named nodes of these kinds, each as its kind, its first byte and the byte after its last one."""
    found = Counter()
    cursor = tree.walk()
    while True:
        node = cursor.node
        kind = "name" if node.type == "barred_name" else node.type
        if node.is_named and kind in kinds:
            found[(kind, node.start_byte, node.end_byte)] += 1
        if cursor.goto_first_child() or cursor.goto_next_sibling():
            continue
        while cursor.goto_parent():
            if cursor.goto_next_sibling():
                break
        else:
            return found


class Comparison:
    """Counts what agrees, and tells the first ten differences."""

    def __init__(self, real, parser):
        self.real, self.parser, self.agree, self.differ = real, parser, Counter(), 0

    def tell(self, name, text, what):
        self.differ += 1
        if self.differ <= 10:
            print(f"{name}: {what}\n{text.decode(errors='replace')}\n--")

    def __call__(self, name, text):
        """Whether the real parser accepts; its answer as well."""
        answer = self.real(text)
        if LIMITS & set(answer["codes"]):
            self.agree["beyond a limit, not compared"] += 1
            return answer
        tree = self.parser.parse(text)
        accepted = not answer["codes"]
        if tree.root_node.has_error == accepted:
            self.tell(name, text, f"the real parser {'accepts' if accepted else 'refuses'} ({answer['codes']}): {tree.root_node}")
        elif accepted:
            wanted = Counter(tuple(node) for node in answer["nodes"])
            got = nodes(tree, KINDS)
            if wanted != got:
                self.tell(name, text, f"trees differ: missing {sorted((wanted - got))[:5]}, more {sorted((got - wanted))[:5]}")
            else:
                self.agree["accepted, with the same trees"] += 1
        else:
            self.agree["refused"] += 1
        return answer


KINDS = {  # of nodes of reference.ml
    "name", "path", "number", "boolean", "co_name", "call", "qualified_call", "component", "vector", "negation", "not", "binary",
    "conditional", "count", "quantified", "temporal", "until", "measured", "leads_to", "event", "feature", "channel", "weak_channel",
    "nil", "opening", "weak_split", "strong_split", "delay", "sum", "behaviour_name", "string", "template_name", "scaled", "mesh",
    "template", "hull", "translate", "rotate", "scale", "matrix", "mass", "velocity", "spin", "absorb", "placement", "bond", "part",
    "glue", "leaf", "inertial", "law", "choose",
} | {kind + "_declaration" for kind in (
    "model", "import", "param", "timestep", "split_step", "setting", "resolution", "round", "shape", "compound", "behaviour",
    "process", "fixed", "bond", "for", "network", "motion", "let", "check")}

EXPRESSIONS = {
    "path", "number", "boolean", "co_name", "call", "qualified_call", "component", "vector", "negation", "not", "binary",
    "conditional", "count", "quantified", "temporal", "until", "measured", "leads_to", "event"}
BEHAVIOURS = {"nil", "opening", "weak_split", "strong_split", "delay", "sum", "behaviour_name"}
SOLIDS = {"template_name", "scaled", "mesh", "hull"}


def family(kind):
    """Pieces of one family may stand in the places of each other."""
    for name, kinds in (("expression", EXPRESSIONS), ("behaviour", BEHAVIOURS), ("solid", SOLIDS)):
        if kind in kinds:
            return name
    return kind


class Mutations:
    """Mutated texts, of the tokens and pieces of all models."""

    def __init__(self, seed, parsed, words):
        self.random = random.Random(seed)
        self.parsed = parsed
        self.tokens = sorted({text[a:b] for text, answer in parsed for _, a, b in answer["tokens"]} | {w.encode() for w in words})
        self.marks = sorted({text[a:b] for text, answer in parsed for kind, a, b in answer["tokens"] if kind in ("word", "mark")})
        self.pieces = {}
        for text, answer in parsed:
            for kind, a, b in answer["nodes"]:
                if b - a < 200:
                    self.pieces.setdefault(family(kind), set()).add(text[a:b])
        self.pieces = {kind: sorted(texts) for kind, texts in self.pieces.items()}

    def edit(self, text, answer):
        """A change: where it begins and ends, and what stands there then."""
        choose = self.random.choice
        pieces = [node for node in answer["nodes"] if node[2] - node[1] < 200]
        if pieces and self.random.random() < 0.35:
            kind, a, b = choose(pieces)
            return a, b, choose(self.pieces[family(kind)])
        tokens = answer["tokens"]
        at = self.random.randrange(len(tokens))
        _, a, b = tokens[at]
        way = self.random.randrange(6)
        if way == 0:
            return a, b, b""
        if way == 1:
            return b, b, b" " + text[a:b]
        if way == 2:
            _, c, d = tokens[(at + 1) % len(tokens)]
            return (a, d, text[c:d] + text[b:c] + text[a:b]) if c >= b else (a, b, b"")
        if way == 3:
            return a, b, choose(self.marks)
        if way == 4:
            return b, b, b" " + choose(self.marks)
        return a, b, choose(self.tokens)

    def __iter__(self):
        while True:
            text, answer = self.random.choice(self.parsed)
            edits = sorted(self.edit(text, answer) for _ in range(self.random.choice((1, 1, 1, 2, 3))))
            result, end = b"", 0
            for a, b, new in edits:
                if a >= end:
                    result += text[end:a] + b" " + new + b" "
                    end = b
            yield result + text[end:]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("reference")
    arguments.add_argument("grammar")
    arguments.add_argument("--count", type=int, default=10000)
    arguments.add_argument("--seed", type=int, default=1)
    chosen = arguments.parse_args()
    try:
        parser = grammar(chosen.grammar)
    except ImportError:
        print("tree_sitter of PyPI is not there")
        return 3
    real = Parser(chosen.reference)
    compare = Comparison(real, parser)
    parsed = [(text, compare(name, text)) for name, text in models()]
    for word in real.words() + ["name", "any", "chance"]:
        for place in PLACES:
            compare("a word in a place of names", place.replace("W", word).encode())
            barred = "".join(letter + "\u0304" for letter in word)
            compare("a barred word", place.replace("W", barred).encode())
    for text in TRICKY:
        compare("a tricky text", text.encode())
    for text in combined(random.Random(chosen.seed), chosen.count // 2):
        compare("operators", f"check a : {text}".encode())
    usable = [(text, answer) for text, answer in parsed if not answer["codes"] and answer["tokens"]]
    mutated = iter(Mutations(chosen.seed, usable, real.words()))
    for i in range(chosen.count):
        compare(f"mutation {i} of seed {chosen.seed}", next(mutated))
    for what, count in sorted(compare.agree.items()):
        print(f"{what}: {count}")
    print(f"{sum(compare.agree.values())} passed, {compare.differ} failed")
    return 1 if compare.differ else 0


if __name__ == "__main__":
    sys.exit(main())
