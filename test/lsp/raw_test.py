"""What no client should send to `scc lsp`: raw_test.py SCC FOLDER. The last line is 'N passed, N failed'."""

import json
import os
import sys
import time

from wire import Server

passed = failed = 0


def check(what, holds, found=None):
    global passed, failed
    if holds:
        passed += 1
    else:
        failed += 1
        print(f"FAILED: {what}: {found!r}")


def code(answer):
    return answer.get("error", {}).get("code")


def alive(server, what):
    """The server still answers."""
    check(f"after {what} it answers", code(server.ask("textDocument/unheard", {})) == -32601)


SMALL = "shape Cube = box(2, 2, 2)\nprocess p = Cube mass 1 [nil]\ncheck c : always x(p) = 0\n"


def framing(scc):
    server = Server(scc)
    for what, bytes_ in [
        ("a header without a length", b"Content-Type: x\r\n\r\n"),
        ("a length that is no number", b"Content-Length: many\r\n\r\n"),
        ("a negative length", b"Content-Length: -1\r\n\r\n"),
        ("two lengths", b"Content-Length: 2\r\nContent-Length: 2\r\n\r\n"),
        ("no header at all", b"hello\r\n\r\n"),
        ("another encoding", b"Content-Length: 2\r\nContent-Type: text; charset=utf-16\r\n\r\n"),
        ("a header without an end", b"x" * 20000 + b"\r\n"),
    ]:
        server.raw(bytes_)
        answer = server.next()
        check(what, answer is not None and code(answer) == -32700 and answer["id"] is None, answer)
        check(f"a request after {what}", code(server.ask("textDocument/hover", {})) == -32002)
    for what, text, wanted in [
        ("no JSON", b"{", -32700),
        ("nothing", b"", -32700),
        ("a text", b'"x"', -32600),
        ("a batch", b'[{"jsonrpc":"2.0","id":1,"method":"initialize"}]', -32600),
        ("another version", b'{"jsonrpc":"1.0","id":1,"method":"initialize"}', -32600),
        ("an id that is an object", b'{"jsonrpc":"2.0","id":{},"method":"initialize"}', -32600),
        ("params that are a number", b'{"jsonrpc":"2.0","id":1,"method":"initialize","params":3}', -32600),
        ("no UTF-8", b'{"jsonrpc":"2.0","id":1,"method":"\xff"}', -32700),
        ("deep JSON", b"[" * 100000, -32700),
        ("an id that is a fraction", b'{"jsonrpc":"2.0","id":1.5,"method":"initialize"}', -32600),
        ("half a surrogate pair", b'{"jsonrpc":"2.0","id":1,"method":"\\ud800"}', -32700),
        ("no method, no result", b'{"jsonrpc":"2.0"}', -32600),
    ]:
        server.raw(b"Content-Length: %d\r\n\r\n%s" % (len(text), text))
        answer = server.next()
        check(what, code(answer) == wanted, answer)
    for method in ["5", "null", "true", "[]", "{}", "1.5"]:
        for id in ["77", '"a"']:
            text = b'{"jsonrpc":"2.0","id":%s,"method":%s}' % (id.encode(), method.encode())
            server.raw(b"Content-Length: %d\r\n\r\n%s" % (len(text), text))
            answer = server.next()
            check(f"the method {method}", code(answer) == -32600 and answer["id"] == json.loads(id), answer)
    for text, words in [
        (b"", "empty"),
        (b'{"jsonrpc":"2.0","id":1.5,"method":"x"}', "neither an integer nor a text"),
        (b'"\\ud800"', "surrogate"),
        (b"[" * 201 + b"]" * 201, "cannot be read: values are nested deeper than 200"),
        (b"9" * 30, "too many digits"),
        (b"{", "this is not JSON"),
    ]:
        server.raw(b"Content-Length: %d\r\n\r\n%s" % (len(text), text))
        answer = server.next()
        check(f"the words of {words}", words in answer["error"]["message"], answer)
    check("a request before initialize", code(server.ask("textDocument/hover", {})) == -32002)
    server.notify("textDocument/didOpen", {})
    check("a piece of a header at a time", True)
    message = json.dumps({"jsonrpc": "2.0", "id": 77, "method": "initialize", "params": {"capabilities": {}}}).encode()
    for byte in b"content-length:%d\n\n" % len(message) + message:
        server.raw(bytes([byte]))
    check("bytes one by one", "result" in server.answer(77))
    check("initialize twice", code(server.ask("initialize", {"capabilities": {}})) == -32600)
    alive(server, "all that")
    check("shutdown", server.ask("shutdown", None)["result"] is None)
    check("a request after shutdown", code(server.ask("textDocument/hover", {})) == -32600)
    server.notify("exit", None)
    check("exit after shutdown", server.wait() == 0)


def too_large(scc):
    server = Server(scc)
    server.initialize()
    piece = b"x" * (1 << 20)
    server.raw(b"Content-Length: %d\r\n\r\n" % (129 << 20))
    for _ in range(129):
        server.raw(piece)
    check("a message of 129 MiB", code(server.next()) == -32700)
    alive(server, "a large message")
    check("exit code", server.end() == 0)


def endings(scc):
    for what, wanted, act in [
        ("the end of the input at once", 1, lambda s: None),
        ("the end of the input after initialize", 1, lambda s: s.initialize()),
        ("exit without shutdown", 1, lambda s: (s.initialize(), s.notify("exit", None))),
        ("the end of the input after shutdown", 0, lambda s: (s.initialize(), s.ask("shutdown", None))),
        ("the end of the input within a header", 1, lambda s: s.raw(b"Content-Len")),
        ("the end of the input within a message", 1, lambda s: s.raw(b"Content-Length: 100\r\n\r\n{")),
    ]:
        server = Server(scc)
        act(server)
        begun = time.monotonic()
        found = server.wait()
        check(what, found == wanted, found)
        check(f"{what}, soon", time.monotonic() - begun < 30)


def params(scc, folder):
    server = Server(scc)
    server.initialize()
    uri = f"file://{folder}/small.sc"
    position = {"line": 0, "character": 7}
    methods = "hover definition references documentHighlight completion signatureHelp prepareRename documentSymbol foldingRange formatting codeLens codeAction inlayHint semanticTokens/full semanticTokens/full/delta semanticTokens/range rangeFormatting rename".split()
    for method in methods:
        name = f"textDocument/{method}"
        for what, given in [
            ("no params", None), ("an array", []), ("a document that is not open", {"textDocument": {"uri": "file:///none.sc"}, "position": position}),
            ("an address that is a number", {"textDocument": {"uri": 3}, "position": position}),
        ]:
            found = code(server.ask(name, given))
            check(f"{name} with {what}", found == -32602, found)
    server.open(uri, SMALL)
    document = {"uri": uri}
    for method in "hover definition completion prepareRename".split():
        for what, place in [("no place", None), ("a place of texts", {"line": "0", "character": "1"})]:
            found = code(server.ask(f"textDocument/{method}", {"textDocument": document, "position": place}))
            check(f"{method} with {what}", found == -32602, found)
        for place in [(-1, -1), (10**9, 10**9), (0, 10**15), (10**15, 0)]:
            answer = server.ask(f"textDocument/{method}", {"textDocument": document, "position": {"line": place[0], "character": place[1]}})
            check(f"{method} at {place}", "result" in answer or code(answer) == -32803, answer)
    for name in ["if", "process", "", "two words", "9a", "_", "_a", "'a", "a-b", "ā", "x" * 100000 + " ", "p\nq"]:
        answer = server.ask("textDocument/rename", {"textDocument": document, "position": {"line": 1, "character": 9}, "newName": name})
        check(f"the name {name[:20]!r}", code(answer) == -32803, answer)
    for command, arguments in [("scc.unheard", []), ("scc.check", []), ("scc.check", [3]), ("scc.check", ["file:///none.sc"]), ("scc.showRun", [uri, 7])]:
        found = code(server.ask("workspace/executeCommand", {"command": command, "arguments": arguments}))
        check(f"{command} {arguments}", found == -32602, found)
    found = server.ask("workspace/executeCommand", {"command": "scc.check", "arguments": [uri, "none"]})
    check("a check that is not there", code(found) == -32803 and found["error"]["message"].startswith("the model has no check `none`"), found)
    found = server.ask("workspace/executeCommand", {"command": "scc.showRun", "arguments": [uri, "none"]})
    check("a run of a check that is not there", code(found) == -32803 and found["error"]["message"].startswith("the model has no check `none`"), found)
    # Notifications that make no sense are told in the log, and change nothing.
    for name, given in [
        ("textDocument/didChange", {"textDocument": {"uri": "file:///none.sc", "version": 2}, "contentChanges": []}),
        ("textDocument/didChange", {}), ("textDocument/didOpen", {"textDocument": 3}), ("textDocument/didClose", None),
        ("textDocument/didChange", {"textDocument": {"uri": uri, "version": 2}, "contentChanges": [{"range": {}, "text": ""}]}),
        ("workspace/didChangeWatchedFiles", {"changes": "all"}), ("window/workDoneProgress/cancel", {"token": "none"}), ("$/setTrace", {"value": "off"}),
        ("$/cancelRequest", {"id": 4711}), ("$/cancelRequest", {}), ("unheard", {}),
    ]:
        server.notify(name, given)
        alive(server, f"{name} {given}")
    server.send({"jsonrpc": "2.0", "id": 4711, "result": None})
    server.send({"jsonrpc": "2.0", "id": "x", "error": {"code": 1, "message": ""}})
    alive(server, "answers to nothing")
    # Changes: reversed ranges, places past the end, one after the other.
    server.change(uri, 3, [
        {"range": {"start": {"line": 1, "character": 12}, "end": {"line": 1, "character": 8}}, "text": "q = "},
        {"range": {"start": {"line": 99, "character": 0}, "end": {"line": 99, "character": 9}}, "text": "// end\n"},
        {"range": {"start": {"line": 2, "character": 99}, "end": {"line": 2, "character": 99}}, "text": " // more"},
    ])
    symbols = server.ask("textDocument/documentSymbol", {"textDocument": document})["result"]
    check("changes one after the other", [s["name"] for s in symbols] == ["Cube", "q", "c"], symbols)
    check("an unsaved file", server.end() == 0)


def words_and_symbols(scc, folder):
    """Words that have changed, layout of ranges, and symbols of the workspace, asked for as one should not."""
    server = Server(scc)
    capabilities = server.initialize()["capabilities"]
    wanted = capabilities["semanticTokensProvider"]["full"], capabilities["documentRangeFormattingProvider"], capabilities["workspaceSymbolProvider"]
    check("capabilities", wanted == ({"delta": True}, True, True), wanted)
    with open(os.path.join(folder, "brick.sc"), "w") as file:
        file.write("shape Brick = box(1, 1, 1)\nlet height = 2\n")
    uri, other = f"file://{folder}/wall.sc", f"file://{folder}/fence.sc"
    text = 'import "brick.sc" (Brick)\nprocess  p=Brick mass 1 [nil]\nlet  wall=1\n'

    def ask(method, **given):
        return server.ask(method, given)

    def delta(uri, id):
        return ask("textDocument/semanticTokens/full/delta", textDocument={"uri": uri}, previousResultId=id)

    def span(a, b, c, d):
        return {"start": {"line": a, "character": b}, "end": {"line": c, "character": d}}

    def laid_out(place):
        return ask("textDocument/rangeFormatting", textDocument={"uri": uri}, range=place, options={})

    def found(query):
        return [(s["name"], s["location"]["uri"].rsplit("/", 1)[-1]) for s in ask("workspace/symbol", query=query)["result"]]

    for what, given in [("no params", None), ("no query", {}), ("a query that is a number", {"query": 3}), ("an array", [])]:
        check(f"symbols with {what}", code(server.ask("workspace/symbol", given)) == -32602)
    check("symbols of nothing", found("") == [])
    server.open(uri, text)
    server.open(other, text)
    first = ask("textDocument/semanticTokens/full", textDocument={"uri": uri})["result"]
    check("ids differ", delta(other, "0")["result"]["resultId"] != first["resultId"])
    for id in ["", "0", "-1", "x" * 100000, first["resultId"] + " ", "é"]:
        answer = delta(uri, id)["result"]
        check(f"the id {id[:9]!r} gives all words", answer.get("data") == first["data"] and "edits" not in answer, answer)
    answer = delta(other, first["resultId"])["result"]
    check("an id of another document gives all words", "data" in answer, answer)
    for id in [None, 3, [], {}]:
        check(f"the id {id!r}", code(delta(uri, id)) == -32602)
    check("no id", code(ask("textDocument/semanticTokens/full/delta", textDocument={"uri": uri})) == -32602)
    last = delta(uri, "0")["result"]["resultId"]
    answer = delta(uri, last)["result"]
    check("nothing has changed", answer["edits"] == [] and answer["resultId"] != last, answer)
    server.change(uri, 2, [{"range": span(2, 0, 2, 3), "text": "// "}])
    check("an answer before the last one", "edits" in delta(uri, last)["result"])
    check("the first answer is too old", "data" in delta(uri, first["resultId"])["result"])
    server.change(uri, 3, [{"text": ""}])
    answer = delta(uri, delta(uri, "0")["result"]["resultId"])["result"]
    check("no words at all", answer["edits"] == [], answer)
    server.change(uri, 4, [{"text": text}])
    last = delta(uri, "0")["result"]["resultId"]
    server.notify("textDocument/didClose", {"textDocument": {"uri": uri}})
    check("words of a closed file", code(delta(uri, last)) == -32602)
    check("layout of a closed file", code(laid_out(span(0, 0, 9, 0))) == -32602)
    check("a symbol of a closed file", found("wall") == [("wall", "fence.sc")], found("wall"))
    server.open(uri, text)
    check("an id from before the file was closed", "data" in delta(uri, last)["result"])
    for place in [None, 3, [], {}, {"start": 3, "end": 4}, {"start": {"line": 0, "character": 0}}, {"start": {"line": "0", "character": 0}, "end": {"line": 0, "character": 0}}]:
        check(f"layout of the range {place!r}", code(laid_out(place)) == -32602)
    whole = ask("textDocument/formatting", textDocument={"uri": uri}, options={})["result"]
    beyond = 10**9
    for place in [span(-5, -5, beyond, beyond), span(beyond, beyond, 0, 0), span(1, 8, 2, beyond), span(0, 0, 3, 0)]:
        check(f"layout of {place}", laid_out(place)["result"] == whole, laid_out(place))
    for place in [span(beyond, 0, beyond, 9), span(3, 0, 3, 0)]:
        check(f"nothing at {place}", laid_out(place)["result"] == [], laid_out(place))
    check("one line", [e["newText"] for e in laid_out(span(2, 5, 2, 5))["result"]] == ["let wall = 1\n"], laid_out(span(2, 5, 2, 5)))
    server.change(uri, 5, [{"text": text + "process = "}])
    check("layout of a text with errors", laid_out(span(0, 0, 9, 0))["result"] is None)
    # Symbols: of imports, of texts without a folder, of files that vanish, and a great many.
    server.open("untitled:Untitled-1", 'import "brick.sc"\nlet alone = 1\n')
    check("a part of a name in another case", found("RICK")[0] == ("Brick", "brick.sc"), found("RICK"))
    check("an import of an import once", [f for f in found("height")] == [("height", "brick.sc")], found("height"))
    check("a text without a folder", found("alone") == [("alone", "untitled:Untitled-1")], found("alone"))
    check("no symbol", found("no such name") == [] and found("x" * 100000) == [] and found("\u0000é𝄞") == [])
    os.remove(os.path.join(folder, "brick.sc"))
    check("a file that vanishes", found("Brick") == [], found("Brick"))
    server.open(f"file://{folder}/many.sc", "".join(f"let m{k} = {k}\n" for k in range(5000)))
    many = found("m")
    check("at most 1 000, the closest first", len(many) == 1000 and found("M4711") == [("m4711", "many.sc")], len(many))
    serial = server.request("workspace/symbol", {"query": "m"})
    server.notify("$/cancelRequest", {"id": serial})
    answer = server.answer(serial)
    check("symbols that are cancelled, or come first", "result" in answer or code(answer) == -32800, answer)
    check("the end of words", server.end() == 0)


def refusals(scc, folder):
    """Words that say what is at fault: the text, what is asked for, or where it is written."""
    def write(name, text):
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)
        return f"file://{folder}/{name}"

    write("broken.sc", "shape Tile = box(1, 1, 1)\nshape Other = [\n")
    main = write("uses.sc", "import \"broken.sc\" as b\nprocess p = b.Tile mass 1 [nil]\n")
    small = write("pages.sc", SMALL)
    place = os.environ.get("TMPDIR")
    os.environ["TMPDIR"] = temporary = os.path.join(folder, "temporary")
    os.makedirs(temporary, exist_ok=True)
    server = Server(scc)
    if place is None:
        del os.environ["TMPDIR"]
    else:
        os.environ["TMPDIR"] = place
    server.initialize()
    server.open(main, open(main[7:]).read())
    answer = server.ask("textDocument/rename", {"textDocument": {"uri": main}, "position": {"line": 1, "character": 15}, "newName": "Stone"})
    check("an import with an error is named", code(answer) == -32803 and "broken.sc" in answer["error"]["message"], answer)
    server.open(small, SMALL)
    answer = server.ask("workspace/executeCommand", {"command": "scc.showRun", "arguments": [small]})
    page = answer.get("result", {}).get("page", "")
    check("a page", page.startswith("file://"), answer)
    inner = os.path.dirname(page[7:])
    # Nothing can be written to the folder of pages once it is not there.
    os.remove(page[7:])
    os.rmdir(inner)
    answer = server.ask("workspace/executeCommand", {"command": "scc.showRun", "arguments": [small]})
    words = answer.get("error", {}).get("message", "")
    check("a page that cannot be written", code(answer) == -32803 and inner in words and "cannot write" in words and "cannot be read" not in words, answer)
    check("the end after refusals", server.end() == 0)


def cancelling(scc, folder):
    server = Server(scc)
    server.initialize({"window": {"workDoneProgress": True}})
    uri = f"file://{folder}/endless.sc"
    # A walker on a line without an end: its states never recur.
    server.open(uri, "shape Cube = box(1, 1, 1)\nprocess p = Cube mass 1 [nil]\nmotion p = choose { (1, 0, 0), (-1, 0, 0), (0, 1/3, 0), (0, 0, 1/7) }\ntimestep 1\ncheck far : always x(p) < 1000000\n")
    serial = server.request("workspace/executeCommand", {"command": "scc.check", "arguments": [uri]})
    tokens, reports = set(), 0
    while reports < 2:
        message = server.next()
        if message.get("method") == "window/workDoneProgress/create":
            tokens.add(message["params"]["token"])
            server.send({"jsonrpc": "2.0", "id": message["id"], "result": None})
        if message.get("method") == "$/progress":
            check("progress has its token", message["params"]["token"] in tokens)
            reports += message["params"]["value"]["kind"] == "report"
    alive(server, "a check has begun")
    server.notify("$/cancelRequest", {"id": serial})
    check("a check that is cancelled", code(server.answer(serial)) == -32800)
    # Those that wait are cancelled as well.
    first = server.serial + 1
    messages = b""
    for k in range(50):
        data = json.dumps({"jsonrpc": "2.0", "id": first + k, "method": "textDocument/documentSymbol", "params": {"textDocument": {"uri": uri}}}).encode()
        messages += b"Content-Length: %d\r\n\r\n" % len(data) + data
    data = json.dumps({"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": first + 49}}).encode()
    server.raw(messages + b"Content-Length: %d\r\n\r\n" % len(data) + data)
    server.serial = first + 49
    check("a request that waits is cancelled", code(server.answer(first + 49)) == -32800)
    serial = server.request("workspace/executeCommand", {"command": "scc.check", "arguments": [uri]})
    check("the end while a check runs", server.end() == 0)


def until(server, uri, wanted):
    """Waits for diagnostics of these codes alone; there is no answer if they never come."""
    while True:
        found = {d["code"] for d in server.diagnostics(uri, 0)}
        if found <= wanted and bool(found) == bool(wanted):
            return


def files(scc, folder):
    def write(name, text):
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)

    server = Server(scc)
    server.initialize()
    at = lambda name: f"file://{folder}/{name}"
    main = 'import "part.sc" (Cube)\nprocess p = Cube mass 1 [nil]\n'
    codes = lambda found: [d["code"] for d in found]
    server.open(at("main.sc"), main)
    check("an import that is missing", "SC0101" in codes(server.diagnostics(at("main.sc"), 1)))
    write("part.sc", "shape Cube = box(1, 1, 1)\n")
    server.notify("workspace/didChangeWatchedFiles", {"changes": [{"uri": at("part.sc"), "type": 1}]})
    check("an import that appears", server.diagnostics(at("main.sc"), 1) == [])
    server.open(at("part.sc"), "shape Kube = box(1, 1, 1)\n")
    found = server.diagnostics(at("main.sc"), 1)
    check("the text of an open import", set(codes(found)) == {"SC0201"}, found)
    server.change(at("part.sc"), 2, [{"text": "shape Cube = box(1, 0, 1)\n"}])
    until(server, at("main.sc"), set())
    check("a changed import changes its users", True)
    os.remove(os.path.join(folder, "part.sc"))
    server.notify("textDocument/didClose", {"textDocument": {"uri": at("part.sc")}})
    until(server, at("main.sc"), {"SC0101", "SC0201"})
    check("a file that vanishes", True)
    write("a.sc", 'import "b.sc"\nshape A = box(1, 1, 1)\n')
    write("b.sc", 'import "a.sc"\nshape B = box(1, 1, 1)\n')
    server.open(at("cycle.sc"), 'import "a.sc"\nprocess p = a.A mass 1 [nil]\n')
    found = server.diagnostics(at("b.sc"), 0) + server.diagnostics(at("cycle.sc"), 1)
    check("a cycle of imports", "SC0216" in codes(found), found)
    answer = server.ask("textDocument/references", {"textDocument": {"uri": at("cycle.sc")}, "position": {"line": 1, "character": 14}, "context": {"includeDeclaration": True}})
    check("references through a cycle", len(answer["result"]) == 2, answer)
    many = 10_000
    for k in range(many):
        write(f"m{k}.sc", f"shape S{k} = box(1, 1, 1)\n")
    server.open(at("many.sc"), "".join(f'import "m{k}.sc"\n' for k in range(many)) + "process p = m7.S7 mass 1 [nil]\n")
    server.diagnostics(at("many.sc"), 1, seconds=120)
    check("10 000 imports", True)
    answer = server.ask("textDocument/definition", {"textDocument": {"uri": at("many.sc")}, "position": {"line": many, "character": 16}})
    check("a definition among them", answer["result"] and answer["result"][0]["uri"].endswith("/m7.sc"), answer)
    server.open("untitled:Untitled-1", main)
    found = server.diagnostics("untitled:Untitled-1", 1)
    check("an import of a text without a folder", "SC0101" in codes(found), found)
    other = Server(scc)
    other.initialize()
    other.open(at("main.sc"), main)
    check("two servers on one folder", "SC0101" in codes(other.diagnostics(at("main.sc"), 1)))
    check("both end", other.end() == 0 and server.end() == 0)


if __name__ == "__main__":
    scc, folder = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    folder = os.path.abspath(folder)
    framing(scc)
    too_large(scc)
    endings(scc)
    params(scc, folder)
    words_and_symbols(scc, folder)
    refusals(scc, folder)
    cancelling(scc, folder)
    files(scc, folder)
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)
