"""Random edits of models by `scc lsp`: sweep.py SCC [SHARE [SEED]]. The last line is 'N passed, N failed'.

Of every SHARE-th model of specs/, after each edit: the change of the words, applied to the old words, gives the new ones;
the words of a range are some of them; and laying out a range leaves the layout of the whole alone."""

import pathlib
import random
import sys
import tempfile

from wire import Server

SPECS = pathlib.Path(__file__).parents[2] / "specs"
PIECES = ["\n", " ", "\n\n", "// é𝄞 x\n", "/* a\r\n b */", "let k1 = 2\n", "process", "(", "}", "x", "\r\n", "\"", "0", "<~a"]
passed = failed = 0


def check(what, holds, found=None):
    global passed, failed
    passed, failed = (passed + 1, failed) if holds else (passed, failed + 1)
    if not holds:
        print(f"FAILED: {what}: {found!r}")


class Text:
    """A text with places of lines and units of UTF-16."""

    def __init__(self, text):
        self.text = text
        self.starts = [0]
        k = 0
        while k < len(text):
            k += 2 if text[k : k + 2] == "\r\n" else 1
            if text[k - 1] in "\r\n":
                self.starts.append(k)

    def place(self, at):
        line = max(k for k, start in enumerate(self.starts) if start <= at)
        return {"line": line, "character": len(self.text[self.starts[line] : at].encode("utf-16-le")) // 2}

    def offset(self, place):
        if place["line"] >= len(self.starts):
            return len(self.text)
        start = self.starts[place["line"]]
        return start + len(self.text[start:].encode("utf-16-le")[: 2 * place["character"]].decode("utf-16-le"))

    def range(self, a, b):
        # a place between the two marks of a line end is the end of the line
        a, b = (k - 1 if self.text[k - 1 : k + 1] == "\r\n" else k for k in (a, b))
        return a, b, {"start": self.place(a), "end": self.place(b)}

    def edited(self, edits):
        text = self.text
        for edit in sorted(edits, key=lambda e: -self.offset(e["range"]["start"])):
            a, b = self.offset(edit["range"]["start"]), self.offset(edit["range"]["end"])
            text = text[:a] + edit["newText"] + text[b:]
        return text


def words(data):
    """Absolute places of the words."""
    line = character = 0
    found = []
    for k in range(0, len(data), 5):
        character = data[k + 1] + (character if data[k] == 0 else 0)
        line += data[k]
        found.append((line, character, *data[k + 2 : k + 5]))
    return found


def layout(server, uri, text):
    server.open(uri, text)
    answer = server.ask("textDocument/formatting", {"textDocument": {"uri": uri}, "options": {"tabSize": 2, "insertSpaces": True}})
    return None if answer["result"] is None else Text(text).edited(answer["result"])


def sweep(server, path, dice):
    uri, other = "file:///sweep/" + path.name, "file:///sweep/other-" + path.name
    text = path.read_bytes().decode()
    server.open(uri, text)
    document = {"textDocument": {"uri": uri}}
    answer = server.ask("textDocument/semanticTokens/full", document)["result"]
    if answer is None:
        return check(f"{path.name} has words", path.suffix != ".sc")
    sent, data = answer["resultId"], answer["data"]
    for version in range(2, 6):
        places = Text(text)
        a = dice.randint(0, len(text))
        a, b, span = places.range(a, min(len(text), a + dice.choice([0, 0, 1, 5, 60])))
        put = dice.choice(PIECES)
        text = text[:a] + put + text[b:]
        server.change(uri, version, [{"range": span, "text": put}])
        answer = server.ask("textDocument/semanticTokens/full/delta", {**document, "previousResultId": sent})["result"]
        sent = answer["resultId"]
        check(f"{path.name}: at most one edit", len(answer["edits"]) <= 1, answer)
        for edit in answer["edits"]:
            data[edit["start"] : edit["start"] + edit["deleteCount"]] = edit["data"]
        whole = server.ask("textDocument/semanticTokens/full", document)["result"]["data"]
        check(f"{path.name}: the words after a change", data == whole, text)
        places = Text(text)
        a = dice.randint(0, len(text))
        _, _, span = places.range(a, min(len(text), a + 300))
        some = server.ask("textDocument/semanticTokens/range", {**document, "range": span})["result"]["data"]
        check(f"{path.name}: words of a range", set(words(some)) <= set(words(whole)), text)
    # of a text without errors
    text = path.read_bytes().decode()
    for _ in range(2):
        k = dice.choice([k for k, c in enumerate(text) if c == " "] or [0])
        text = text[:k] + dice.choice(["  ", "\n", " "]) + text[k:]
    before = layout(server, other, text)
    places = Text(text)
    a = dice.randint(0, len(text))
    a, b, span = places.range(a, min(len(text), a + dice.choice([0, 50, 500])))
    asked = {"textDocument": {"uri": other}, "range": span, "options": {"tabSize": 2, "insertSpaces": True}}
    edits = server.ask("textDocument/rangeFormatting", asked)["result"]
    if before is not None:
        check(f"{path.name}: layout of a range", layout(server, other, places.edited(edits)) == before, (text, span, edits))
    else:
        check(f"{path.name}: a text with errors", edits is None, edits)
    for closing in (uri, other):
        server.notify("textDocument/didClose", {"textDocument": {"uri": closing}})


if __name__ == "__main__":
    share = int(sys.argv[2]) if len(sys.argv) > 2 else 12
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    paths = sorted(p for p in SPECS.rglob("*") if p.suffix in (".sc", ".osc", ".xml"))[seed % share :: share]
    with tempfile.TemporaryDirectory() as folder:
        server = Server(sys.argv[1], folder)
        server.initialize()
        for path in paths:
            try:
                path.read_bytes().decode()
            except UnicodeDecodeError:
                continue
            sweep(server, path, random.Random(f"{seed} {path.name}"))
        check("the end", server.end() == 0)
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)
