#!/usr/bin/env python3
"""Texts that would change how a terminal shows what is around them: scc writes them out, wherever they come from.

    test/limits/texts.py SCC [--every N] [--only TEXT] [--verbose]

Every command gets hostile texts at every place that takes one: as a command, an option, the value of each option of its
manual, the name of each file, and at every word of every kind of file. What it prints has no character that changes the
direction of the text, no control character, no byte that is not UTF-8, and no line that the text began. Data stay
as they are where they are text to be read again: what `scc fmt' and `scc translate' print. But what XML names by its number, as
&#x9b;, comes out as no raw control character there either. With --every 1 it is some
90 000 runs; without it a share, every 419th.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

EVIL = [
    "e\u202ev\u2066i\u202al\u2069", "e\x1b[31mv\x1b]0;x\x07il", "e\rv\x08i\x7f\x0bl", "e\u009bv\u0085il".encode(), b"e\x9bv\xe2\x80i\xffl",
    "e\nscc: FORGED",
]
FORGED = "scc: FORGED"
# In XML: the same by numbers.
REFERENCES = b"e&#x9b;v&#x85;i&#127;l"
MODEL = """model m
param v = 1
shape C = box(1,1,1)
behaviour K on C = <a, {top}>. eps(1). nil
process p = C mass 1 velocity (v,0,0) [K]
process q = C mass 1 velocity (-v,0,0) at translate (9,0,0) [nil]
check c : always x(p) < 2 within 3 // a comment
"""
OPEN = MODEL.replace("param v = 1", "param v in [1, 2]")
OFF = "OFF\n# a comment\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
OBJ = """# a comment
o solid
g side
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
usemtl red
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""
STL = "solid s\n" + "".join(
    "facet normal 0 0 0\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n" % f for f in (
        ("0 0 0", "0 1 0", "1 0 0"), ("0 0 0", "1 0 0", "0 0 1"), ("0 0 0", "0 0 1", "0 1 0"),
        ("1 0 0", "0 1 0", "0 0 1"))) + "endsolid s\n"
PLY = """ply
format ascii 1.0
comment a comment
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
"""
PGM = "P2\n# a comment\n8 8\n1\n" + "0 0 0 0 0 0 0 0\n" * 2 + "0 0 1 1 1 1 0 0\n" * 4 + "0 0 0 0 0 0 0 0\n" * 2
SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="8" height="8"><path fill="black" d="M 1 1 L 6 1 L 6 6 Z"/></svg>\n'
AUT = 'des (0, 3, 3)\n(0, "a b", 1)\n(1, "c", 2)\n(2, "d(x)", 0)\n'
CSV = "time,event,bodies,x,y,z\n0,state,p,0,0,0\n1,state,p,1,0,0\n"
X3D = """<X3D><Scene><Shape DEF="s"><IndexedFaceSet DEF="t" coordIndex="0 2 1 -1 0 1 3 -1 0 3 2 -1 1 2 3 -1">
<Coordinate point="0 0 0 1 0 0 0 1 0 0 0 1"/></IndexedFaceSet></Shape></Scene></X3D>
"""
OUT = "OUT"

# A command line of each kind; @name is a file of the folder.
LINES = [
    ["check", "@m.sc"], ["check", "@m.sc", "--json"], ["check", "@open.sc", "--where"], ["check", "@m.sc", "--coverage", "--stats"],
    ["trace", "@m.sc", "--steps", "3"], ["trace", "@m.sc", "--human"], ["trace", "@m.sc", "--schedule", "@trace.jsonl"],
    ["simulate", "@m.sc", "--runs", "1", "--observe", "x(p)", "--every", "1", "--until", "2"], ["estimate", "@m.sc", "--runs", "2"],
    ["sweep", "@m.sc", "-D", "v=1,2"], ["view", "@m.sc", "-o", OUT + ".html"], ["view", "@m.sc", "-o", OUT + ".svg", "--svg", "1"],
    ["view", "@m.sc", "--trace", "@trace.jsonl", "-o", OUT + ".html"],
    ["export", "@m.sc", "-o", OUT + ".csv", "--observe", "x(p)"], ["export", "@m.sc", "-o", OUT + ".x3d"],
    ["explore", "@m.sc", "-o", "-", "--format", "dot"], ["explore", "@m.sc", "-o", "-", "--format", "aut"],
    ["explain", "@witness.json"], ["explain", "@trace.jsonl", "@m.sc", "--check", "c"], ["compare", "@m.sc", "@m.sc"],
    ["compare", "@a.aut", "@b.aut"], ["compare", "@a.aut", "@b.aut", "--modulo", "trace"], ["conform", "@m.sc", "@trace.jsonl"],
    ["conform", "@m.sc", "@trace.csv"], ["diff", "@trace.jsonl", "@other.jsonl"], ["diff", "@trace.csv", "@trace.jsonl"],
    ["shape", "@m.sc:C"], ["shape", "@s.off"], ["shape", "@s.obj"], ["shape", "@s.stl"], ["shape", "@s.ply"], ["inflate", "@i.pgm", "-o", OUT + ".off"],
    ["inflate", "@i.svg", "-o", OUT + ".off"], ["decompose", "@s.obj"], ["decompose", "@s.off"], ["fmt", "--check", "@m.sc"], ["fmt", "@m.sc"],
    ["translate", "@m.sc", "--to", "xml"], ["translate", "@m.xml", "--to", "sc"], ["check", "@m.xml"], ["check", "@m.osc"], ["check", "@mesh.sc"],
]
# What is read of XML, and printed.
OF_XML = [
    ["translate", "@mesh.xml", "--to", "sc"], ["translate", "@mesh.xml", "--to", "xml"], ["translate", "@mesh.xml", "--to", "original"],
    ["fmt", "@mesh.xml"], ["check", "@mesh.xml"], ["check", "@mesh.xml", "--json"], ["trace", "@mesh.xml", "--steps", "2"],
    ["shape", "@s.x3d"], ["inflate", "@i.svg"],
]
# These print the text that was read, to be read again.
DATA = ("fmt", "translate")


class Sweep:
    def __init__(self, args, folder):
        self.args, self.folder, self.number, self.passed, self.failed, self.shown = args, folder, 0, 0, 0, set()
        for name, text in (("m.sc", MODEL), ("open.sc", OPEN), ("s.off", OFF), ("s.obj", OBJ), ("s.stl", STL), ("s.ply", PLY), ("i.pgm", PGM), ("i.svg", SVG), ("s.x3d", X3D),
                           ("a.aut", AUT), ("b.aut", AUT.replace("d(x)", "e(x)")), ("trace.csv", CSV),
                           ("mesh.sc", MODEL.replace("box(1,1,1)", 'mesh "s.off"'))):
            self.write(name, text.encode())
        for words in (["trace", "m.sc", "-o", "trace.jsonl"], ["trace", "m.sc", "-D", "v=2", "-o", "other.jsonl"],
                      ["check", "m.sc", "--witness", "runs"], ["translate", "m.sc", "--to", "xml", "-o", "m.xml"],
                      ["translate", "m.sc", "--to", "original", "-o", "m.osc"], ["translate", "mesh.sc", "--to", "xml", "-o", "mesh.xml"]):
            subprocess.run([args.scc, *words], cwd=folder, capture_output=True)
        shutil.copy(self.path("runs/c.json"), self.path("witness.json"))
        os.mkdir(self.path("evil"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "wb") as file:
            file.write(text)

    def wanted(self, every):
        self.number += 1
        return self.number % every == 0

    def run(self, words, is_data):
        done = subprocess.run([self.args.scc, *words], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=120)
        printed = done.stderr if is_data else done.stdout + done.stderr
        wrong = fault(printed)
        if done.returncode not in (0, 1, 2, 3, 4, 64, 74):
            wrong = "exit code %d" % done.returncode
        self.passed, self.failed = (self.passed, self.failed + 1) if wrong else (self.passed + 1, self.failed)
        if wrong or self.args.verbose:
            print("%s %r: %s" % ("FAULT" if wrong else "ok   ", words, wrong or done.returncode), flush=True)

    # --- places of the command line ---

    def named(self, line):
        return [w[1:] if w.startswith("@") else w for w in line]

    def words(self, line, evil):
        """Each word of a command line replaced by a hostile one, and more of them."""
        plain = self.named(line)
        is_data = line[0] in DATA
        for i in range(len(plain)):
            for word in (evil, plain[i].encode() + evil, evil + plain[i].encode()):
                yield plain[:i] + [word] + plain[i + 1:], is_data
        for word in (b"--" + evil, b"--" + evil + b"=1", b"-" + evil, b"--help=" + evil, evil):
            yield plain + [word], is_data

    def options(self, command, evil):
        line = next(line for line in LINES if line[0] == command)
        manual = subprocess.run([self.args.scc, command, "--help=plain"], capture_output=True, text=True).stdout
        for option in sorted(set(re.findall(r"^       (?:-\w(?: [A-Z=]+)?, )?(--[a-z-]+)=[A-Z]", manual, re.M))):
            for value in (evil, b"v=" + evil, evil + b"=1", b"x(" + evil + b")", b"x(p) /* " + evil + b" */", b"none/" + evil,
                          b"1," + evil, evil + b".json", evil + b".svg"):
                yield self.named(line) + [option.encode() + b"=" + value], command in DATA

    def files(self, line, evil):
        """Each file by a hostile name: none, a folder, as it is, and in a folder of such a name."""
        for i, word in enumerate(line):
            if word.startswith("@"):
                name, colon, part = word[1:].partition(":")
                ending = os.path.splitext(name)[1].encode()
                there = evil.replace(b"/", b"_") + b" copy" + ending
                plain = self.named(line)
                tail = (colon + part).encode()
                yield "none", plain[:i] + [b"none" + there + tail] + plain[i + 1:]
                shutil.copyfile(self.path(name).encode(), os.path.join(self.folder.encode(), there))
                yield "there", plain[:i] + [there + tail] + plain[i + 1:]
                with open(os.path.join(self.folder.encode(), there), "ab") as file:
                    file.write(b"\n)broken{\n")
                yield "broken", plain[:i] + [there + tail] + plain[i + 1:]
                os.remove(os.path.join(self.folder.encode(), there))

    # --- places of files ---

    def contents(self, line, evil):
        """Each word, each text between quotes and each gap of each file of a command line."""
        for name in sorted({w[1:].partition(":")[0] for w in line if w.startswith("@")}):
            with open(self.path(name), "rb") as file:
                text = file.read()
            where = [m.span() for m in re.finditer(rb'"[^"]*"|[A-Za-z_]+|[0-9.]+|[^\sA-Za-z0-9_.]', text)]
            is_json = name.endswith((".json", ".jsonl"))
            step = max(1, len(where) // 120)
            for start, stop in where[::step]:
                word = text[start:stop]
                if is_json and word.startswith(b'"'):
                    # As JSON has it, and as it is.
                    escaped = json.dumps(evil.decode("utf-8", "replace"))[1:-1].encode()
                    news = [b'"' + escaped + b'"', b'"' + evil + b'"', word[:-1] + escaped + b'"']
                elif word.startswith(b'"'):
                    news = [b'"' + evil + b'"', word[:-1] + evil + b'"']
                else:
                    news = [evil, word + evil, word + b" " + evil]
                for new in news:
                    yield name, text[:start] + new + text[stop:]

    def references(self, line):
        """Characters by their numbers in each value and each text of a file of XML."""
        name = line[1][1:]
        with open(self.path(name), "rb") as file:
            text = file.read()
        for found in re.finditer(rb'(?<==")[^"]*|(?<=>)[^<>]*[^<>\s][^<>]*(?=<)', text):
            word = found.group()
            for new in (REFERENCES, word + REFERENCES, REFERENCES + word):
                yield name, text[:found.start()] + new + text[found.end():]

    def all(self):
        for line in OF_XML:
            for name, text in self.references(line):
                self.changed(line, name, text, is_data=False, every=min(3, self.args.every))
        evils = [e if isinstance(e, bytes) else e.encode() for e in EVIL]
        for evil in evils:
            self.line([evil], False)
            for command in sorted({line[0] for line in LINES}):
                for words, is_data in self.options(command, evil):
                    self.line(words, is_data)
            for line in LINES:
                for words, is_data in self.words(line, evil):
                    self.line(words, is_data)
                for _, words in self.files(line, evil):
                    self.line(words, line[0] in DATA and "--check" not in line)
                for name, text in self.contents(line, evil):
                    self.changed(line, name, text, is_data=line[0] in DATA, every=self.args.every)

    def changed(self, line, name, text, is_data, every):
        """A run with another content of a file."""
        if self.args.only in " ".join(line) and self.wanted(every):
            with open(self.path(name), "rb") as file:
                before = file.read()
            self.write(name, text)
            self.run(self.named(line), is_data)
            self.write(name, before)

    def line(self, words, is_data):
        words = [w if isinstance(w, bytes) else w.encode() for w in words]
        if self.args.only.encode() in b" ".join(words) and self.wanted(self.args.every):
            self.run(words, is_data)


def fault(printed):
    """What of a text would change how a terminal shows it."""
    try:
        text = printed.decode().replace("\r\n", "\n")  # lines of CSV
    except UnicodeDecodeError as e:
        return "no UTF-8: %r" % printed[max(0, e.start - 60):e.end + 20]
    found = re.search("[\u202a-\u202e\u2066-\u2069\x00-\x08\x0b-\x1f\x7f-\x9f]", text)
    if found:
        return "U+%04X: %r" % (ord(found.group()), text[max(0, found.start() - 80):found.end() + 20])
    if re.search("^" + FORGED, text, re.M):
        return "a line of its own: %r" % text[:200]
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scc", type=os.path.abspath)
    parser.add_argument("--every", type=int, default=419)
    parser.add_argument("--only", default="")
    parser.add_argument("--verbose", action="store_true")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        sweep = Sweep(args, folder)
        sweep.all()
        print("%d passed, %d failed" % (sweep.passed, sweep.failed))
        return 1 if sweep.failed else 0


if __name__ == "__main__":
    sys.exit(main())
