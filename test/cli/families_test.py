#!/usr/bin/env python3
"""A family has the members that its loops give it, be they none.

    families_test.py SCC [--count N] [--seed N]

Random models declare a family in loops over 1..n and use it: in `motion`, `network` and quantifiers. For n from 0 to 2
the verdicts and the numbers of states are those of the same model with the loops written out, in which a family
without members does not occur. A channel that only the family has is known without members, too: there is no bond of
it, and no event. What only the family uses is used. A name that no loop declares is refused. The last line is
'N passed, N failed'.
"""
import argparse
import json
import os
import random
import subprocess
import sys
import tempfile

HEAD = """import <solids>
param n = 0
process p = solids.Cube(1) mass 1 velocity (1,0,0) [nil]
process q = solids.Cube(1) mass 1 at translate (4,0,0) [nil]
"""
LOOPS = {  # the head of a loop, and its indices for n
    "for i in 1..n": lambda n: [(i,) for i in range(1, n + 1)],
    "for i in 1..2*n if i mod 2 = 0": lambda n: [(i,) for i in range(1, 2 * n + 1) if i % 2 == 0],
    "for i in 0..n-1": lambda n: [(i,) for i in range(n)],
    "for i in 1..n, j in 1..i": lambda n: [(i, j) for i in range(1, n + 1) for j in range(1, i + 1)],
    "for i in 1..2, j in i..n": lambda n: [(i, j) for i in (1, 2) for j in range(i, n + 1)],
    "for i in 1..2, j in 1..2 if i + j <= n": lambda n: [(i, j) for i in (1, 2) for j in (1, 2) if i + j <= n],
}
# What only the family uses, and its behaviour with a channel that only the family has.
CHANNELS = [
    ("", "<a, {right}>. nil"),
    ("", "<a, {left}>. omega(a, {left}). nil"),
    ("", "eps(1). rho({<a, {right}>}). nil"),
    ("let pause = 1\nlet t = pause\nbehaviour Free on solids.Cube(1) = <a, {right}>. Held\n"
     "behaviour Held on solids.Cube(1) = eps(t). nil", "Free"),
    ("behaviour Free(c) = <~c, {left}>. Held(c)\nbehaviour Held(c) = omega(c, {left}). nil", "Free(a)"),
    ("behaviour Free[k] = Half\nbehaviour Half = <a, {right}>. nil", "Free[1]"),
]
OF_CHANNEL = {  # an atom, and what it is without members
    "bonds(a) = 0": "0 = 0", "bonds(a) >= 1": "0 >= 1", "bonds(a, p, q) = 0": "0 = 0", "offers(p, a)": "false",
    "offers(q, ~a)": "false", "event bind(a)": "false", "event weak(a)": "false", "event strong(a, p)": "false",
    "event split(a)": "false",
}
BODIES = [  # with the index, and a place of its own
    "process f[{i}] = solids.Cube(1) mass 1 {at} [nil]",
    "process f[{i}] = solids.Cube(1) mass 1 velocity (0,0,1) {at} [nil]",
    "fixed f[{i}] = solids.Cube(1) {at}",
    "process g[{i}] = f[{i}]: solids.Cube(1) mass 1 {at} [nil]",
]
ATOMS = ["x(b) > {k}", "z(b) >= {k}", "vz(b) = {k}", "touching(b, p)", "x(b) < x(q)"]
OVER = {
    "forall": lambda fs: " and ".join(fs) or "true",
    "exists": lambda fs: " or ".join(fs) or "false",
    "count": lambda fs: " + ".join(f"(if {f} then 1 else 0)" for f in fs) or "0",
}


def quantified(chance):
    word = chance.choice(list(OVER))
    atom = "(" + chance.choice(ATOMS).format(k=chance.randint(-1, 3)) + ")"
    relation = f"{chance.choice(['=', '<=', '>'])} {chance.randint(0, 2)}" if word == "count" else ""

    def short(name):
        return f"(count(b in {name}: {atom}) {relation})" if word == "count" else f"({word} b in {name}: {atom})"

    def long(members):
        each = [atom.replace("(b", f"({m}").replace("b)", f"{m})") if "touching" in atom
                else atom.replace("(b)", f"({m})") for m in members]
        return f"(({OVER[word](each)}) {relation})"
    return short, long


class Model:
    """A family of one kind of body in one or two loops, with its uses."""

    def __init__(self, chance):
        self.body = chance.choice(BODIES)
        self.loops = chance.sample(list(LOOPS), chance.choice([1, 1, 2]))
        # the loops are on lines of their own in space; two loops have different numbers of indices or none in common
        arities = [len(LOOPS[head](3)[0]) for head in self.loops]
        if len(set(arities)) < len(arities):
            self.loops = self.loops[:1]
        self.nested = chance.random() < 0.3
        self.fixed = self.body.startswith("fixed")
        self.motion = None if self.fixed else chance.choice([None, "inertial", "(0, 0, 1)"])
        self.listed = chance.random() < 0.3
        self.checks = []
        self.declared, behaviour = chance.choice(CHANNELS) if chance.random() < 0.6 else ("", None)
        if self.fixed or behaviour is None:
            self.declared = behaviour = ""
        else:
            doubled = behaviour.replace("{", "{{").replace("}", "}}")
            self.body = self.body.replace("[nil]", "[" + doubled + "]")
        # A value and a template that nothing else uses.
        self.own = chance.random() < 0.5
        if self.own:
            self.declared += "\nlet side = 1\nshape Part = solids.Cube(side)"
            self.body = self.body.replace("solids.Cube(1)", "Part")
        for _ in range(chance.randint(1, 3)):
            operator = chance.choice(["always", "possibly", "eventually"])
            self.checks.append((operator, *quantified(chance)))
        if behaviour:
            self.checks += [(chance.choice(["always", "possibly"]), atom, of)
                            for atom, of in chance.sample(list(OF_CHANNEL.items()), 2)]

    def place(self, line, index):
        return f"at translate ({3 * index[0] - 20}, {6 + 30 * line}, {3 * index[-1] if len(index) > 1 else 0})"

    def members(self, n):
        return [(line, index) for line, head in enumerate(self.loops) for index in LOOPS[head](n)]

    def short(self):
        lines = [HEAD, self.declared]
        for line, head in enumerate(self.loops):
            names = "i, j" if "j in" in head else "i"
            at = f"at translate (3*i - 20, {6 + 30 * line}, {'3*j' if 'j in' in head else '0'})"
            body = self.body.format(i=names, at=at)
            if self.nested and ", j in" in head:
                outer, inner = head.split(", j in")
                lines.append(f"{outer} {{ for j in{inner} {{ {body} }} }}")
            else:
                lines.append(f"{head} {{ {body} }}")
        if self.motion:
            lines.append(f"motion f = {self.motion}")
        if self.listed:
            lines.append("network p || q || f")
        lines += [f"check c{k}: {operator} {text if isinstance(text, str) else text('f')} within 3"
                  for k, (operator, text, _) in enumerate(self.checks)]
        return "\n".join(lines) + "\n"

    def long(self, n):
        name = lambda index: f"f[{', '.join(map(str, index))}]"
        members = self.members(n)
        lines = [HEAD, self.declared]
        for line, index in members:
            lines.append(self.body.format(i=", ".join(map(str, index)), at=self.place(line, index)))
        if self.motion:
            lines += [f"motion {name(index)} = {self.motion}" for _, index in members]
        if self.listed:
            lines.append("network " + " || ".join(["p", "q"] + [name(index) for _, index in members]))
        names = [name(index) for _, index in members]
        for k, (operator, short, long) in enumerate(self.checks):
            of_channel = short if members else long
            lines.append(f"check c{k}: {operator} {of_channel if isinstance(long, str) else long(names)} within 3")
        return "\n".join(lines) + "\n"


def checked(scc, folder, text, *options):
    path = os.path.join(folder, "m.sc")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    run = subprocess.run([scc, "check", path, "--json", *options], capture_output=True, text=True, timeout=600)
    report = json.loads(run.stdout)
    if run.returncode == 3:
        return [d["code"] + ": " + d["message"] for d in report["diagnostics"] if d["severity"] == "error"]
    unused = [d["message"] for d in report["diagnostics"] if d["code"] == "SC0211"]
    return [(p["name"], p["verdict"]) for p in report["properties"]], report["explored"]["complete"], unused


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.count):
            model = Model(chance)
            cases = []
            for n in range(3):
                # In the written text of no members, what the family alone uses is not used.
                expected = checked(options.scc, folder, model.long(n))
                expected = (*expected[:2], []) if isinstance(expected, tuple) else expected
                cases.append((n, checked(options.scc, folder, model.short(), "-D", f"n={n}"), expected))
            unknown = model.short().replace("b in f:", "b in ff:")
            refused = checked(options.scc, folder, unknown)
            cases.append(("a misspelled name", refused, ["SC0201: unknown template `ff`"] * len(refused)))
            for what, found, expected in cases:
                if found == expected and (what == "a misspelled name" or isinstance(found, tuple)):
                    passed += 1
                else:
                    failed += 1
                    print(f"{what}:\n{model.short()}  loops: {found}\n  written out: {expected}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
