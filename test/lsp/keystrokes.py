"""How long `scc lsp` takes to start, and to answer a keystroke in a model of 10 000 lines: keystrokes.py SCC.

A keystroke is a change of one character, and what editors ask at once after it: what can be written there, and how what
is called is called. The time is that until the last answer. What editors ask when nobody has typed for a moment, such as
colours, is answered by other processes, and is measured beside it. It prints one line for each bar, and ends with 'N passed, N failed'.
"""

import sys
import time

from wire import Server

START_MS, KEYSTROKE_MS = 100, 100


def model(lines):
    """A model of so many lines: shapes, behaviours, bodies, loops and checks."""
    text = ["model large", "param n = 3", "let far = 10 * n"]
    count = (lines - 3) // 10
    for i in range(count):
        text += [
            f"shape S{i} {{",
            "  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)",
            "           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)",
            "  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]",
            "           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]",
            "}",
            f"behaviour Open{i} on S{i} = <bond{i % 50}, {{right, top}}>. Bound{i}",
            f"behaviour Bound{i} on S{i} = eps(2). rho({{<bond{i % 50}, {{left, right}}>}}). nil",
            f"process p{i} = S{i} mass 3 velocity (2,0,0) at translate ({i} * far, 0, 0) [Open{i}]",
            f"check c{i} : eventually x(p{i}) >= {i} within 3",
        ]
    return "\n".join(text) + "\n"


def start(scc):
    begun = time.perf_counter()
    server = Server(scc)
    server.initialize()
    took = time.perf_counter() - begun
    server.end()
    return took


def keystrokes(scc, count):
    server = Server(scc)
    server.initialize()
    uri = "file:///nowhere/large.sc"
    lines = model(10_000).split("\n")
    server.open(uri, "\n".join(lines))
    took = []
    document = {"uri": uri}
    for k in range(count):
        line = 9 + 10 * ((k * 37) % 990)  # behaviours, and what is within their braces
        at = {"line": line, "character": lines[line].index("{") + 1}
        change = {"range": {"start": at, "end": at}, "text": "t"}
        version = k + 2
        begun = time.perf_counter()
        server.change(uri, version, [change])
        after = {"line": line, "character": at["character"] + 1}
        asked = [
            server.request("textDocument/completion", {"textDocument": document, "position": after}),
            server.request("textDocument/signatureHelp", {"textDocument": document, "position": after}),
        ]
        for serial in asked:
            answer = server.answer(serial)
            assert "result" in answer, answer
        took.append(time.perf_counter() - begun)
        lines[line] = lines[line][: at["character"]] + "t" + lines[line][at["character"] :]
        time.sleep(0.02)
    begun = time.perf_counter()
    answer = server.ask("textDocument/semanticTokens/full", {"textDocument": document})
    assert len(answer["result"]["data"]) > 5 * 50_000, answer
    colours = time.perf_counter() - begun
    server.end()
    return sorted(took), colours


def main(scc, count):
    failed = 0
    starts = sorted(start(scc) for _ in range(10))
    took, colours = keystrokes(scc, count)
    for what, seconds, bar in [
        ("start, median of 10", starts[5], START_MS),
        (f"keystroke in 10 000 lines, 99th percentile of {count}", took[int(0.99 * (len(took) - 1))], KEYSTROKE_MS),
    ]:
        within = 1000 * seconds <= bar
        failed += not within
        print(f"{what}: {1000 * seconds:.0f} ms, bar {bar} ms: {'within' if within else 'beyond'}")
    print(f"(keystroke: median {1000 * took[len(took) // 2]:.0f} ms; colours of all words: {1000 * colours:.0f} ms)")
    print(f"{2 - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200))
