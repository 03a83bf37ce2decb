#!/usr/bin/env python3
"""Runs the notebooks of clients/python/notebooks, and tries the magics in kernels: their output, what interrupts them, what
kills them, and markup in models. The package is the one that is installed, whose program it uses.

    notebooks.py [FOLDER]    notebooks with their outputs are written to the folder, to be looked at

The last line is 'N passed, N failed'.
"""

import html.parser
import json
import os
import pathlib
import signal
import sys
import tempfile
import time

import nbformat
from jupyter_client.manager import KernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

HERE = pathlib.Path(__file__).resolve().parent
NOTEBOOKS = HERE.parent.parent / "clients" / "python" / "notebooks"

#: What the outputs of each notebook say, and how many plots and pictures they have.
EXPECTED = {
    "tour": (["✗ violated", "Fraction(52, 81)", "holds-up-to-bound", "srcdoc=", "volume: 8/3", "SC0201"], 3, 2),
    "hexokinase": (["✗ violated", "srcdoc=", "{'holds'}", "possibly reacted within 3"], 1, 1),
    "meeting": (["Fraction(7, 18)", "((2, 0), 'fails')", "(('1.999', 0), 'holds')"], 1, 1),
    "ruin": (["171/211", "(Fraction(171, 211), Fraction(171, 211))", "1110/211", "True)"], 1, 0),
}

LOAD = "%load_ext shapecalculus.notebook"
MODEL = """import <solids>
process a = solids.Cube(1) mass 1 [nil]
process b = solids.Cube(1) mass 1 at translate (100, 0, 0) [nil]
process c = solids.Cube(1) mass 1 at translate (200, 0, 0) [nil]
timestep 1
motion a = choose { (1, 0, 0) weight 1, (0, 1, 0) weight 1, (0, 0, 1) weight 1 }
motion b = choose { (1, 0, 0) weight 1, (0, 1, 0) weight 1, (0, 0, 1) weight 1 }
motion c = choose { (1, 0, 0) weight 1, (0, 1, 0) weight 1, (0, 0, 1) weight 1 }
check never : always x(a) < 1000000
"""
ENDLESS = "%%scc check --states 1000000000\n" + MODEL
EVIL = "<script>alert(1)</script>"

passed = failed = 0


def expect(claim, holds, why=""):
    global passed, failed
    if holds:
        passed += 1
        print("ok: " + claim)
    else:
        failed += 1
        print("FAILED: %s %s" % (claim, why))


def run(cells, folder, allow_errors=False):
    """The cells, run as a notebook: the outputs of each."""
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    client = NotebookClient(
        notebook, timeout=600, kernel_name="python3", allow_errors=allow_errors, resources={"metadata": {"path": folder}}
    )
    client.execute()
    return [cell.outputs for cell in notebook.cells]


def texts(outputs):
    """All that outputs say, as HTML or plain."""
    said = []
    for output in outputs:
        said.append(output.get("text", ""))
        data = output.get("data", {})
        said += [data.get(kind, "") for kind in ("text/html", "text/plain")]
        said += output.get("traceback", [])
    return "\n".join(said)


def notebooks(folder):
    for path in sorted(NOTEBOOKS.glob("*.ipynb")):
        name = path.stem
        notebook = nbformat.read(path, 4)
        nbformat.validate(notebook)
        expect(name + ": it is kept without outputs", not any(c.get("outputs") for c in notebook.cells))
        resources = {"metadata": {"path": folder}}
        try:
            NotebookClient(notebook, timeout=600, kernel_name="python3", resources=resources).execute()
        except CellExecutionError as error:
            expect(name + ": it runs", False, str(error)[-2000:])
            continue
        nbformat.write(notebook, os.path.join(folder, path.name))
        outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
        said = texts(outputs)
        words, plots, pictures = EXPECTED[name]
        for word in words:
            expect("%s: it says %s" % (name, word), word in said)
        expect(name + ": nothing is on standard error", not any(o.get("name") == "stderr" for o in outputs))
        found = sum("image/png" in output.get("data", {}) for output in outputs)
        expect("%s: it has %d plots" % (name, plots), found == plots, found)
        expect("%s: it has %d pictures" % (name, pictures), said.count("data:image/svg+xml") == pictures)
    expect("all notebooks are known", {p.stem for p in NOTEBOOKS.glob("*.ipynb")} == set(EXPECTED))


class Tags(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.found = set()
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.found.add(tag)
        self.found.update(name for name, _ in attributes if name.startswith("on"))


def markup(folder):
    """Models, options and names of files with markup: it is shown, and is none of the notebook."""
    odd = os.path.join(folder, EVIL.replace("/", "") + ".sc")
    with open(odd, "w", encoding="utf-8") as file:
        file.write(MODEL.replace("check never", "check unsure : possibly x(a) > 100\ncheck never") + "// %s\n" % EVIL)
    where = json.dumps(odd)
    cells = [
        LOAD,
        "%%scc check\nprocess p = " + EVIL + "\n",
        "%%scc check\nimport \"" + EVIL + ".sc\"\n",
        "%%scc check --check '" + EVIL + "'\n" + MODEL,
        "%scc check " + where + " --states 500",
        "%scc view " + where + " --states 500",
        "%scc view " + where + " --states 500 --svg 0 --names",
        "%scc simulate " + where + " --runs 2 --observe 'x(a) < 3' --every 1 --until 3",
        "%scc fmt " + where,
        "%scc " + EVIL,
        "%scc check " + EVIL,
    ]
    outputs = run(cells, folder, allow_errors=True)
    failing = [1, 2, 3, 9, 10]
    for number, (cell, shown) in enumerate(zip(cells, outputs)):
        errors = [o for o in shown if o["output_type"] == "error" or o.get("name") == "stderr"]
        expect("cell %d: whether it fails" % number, bool(errors) == (number in failing), texts(shown)[:500])
        tags = set()
        for output in shown:
            data = output.get("data", {}).get("text/html", "")
            tags |= Tags(data).found
            expect("cell %d: no script" % number, "<script" not in data)
        wanted = {"table", "caption", "thead", "tbody", "tr", "th", "td", "span", "pre", "p", "code", "img", "iframe"}
        expect("cell %d: its tags" % number, tags <= wanted, tags - wanted)
    said = texts(outputs[1])
    expect("a fault of a model is shown with its place", "<model>:1:13" in said or "<model>:1:" in said, said)
    expect("its place in this package is not", "notebook.py" not in said, said)


def commands(folder):
    """Wrong uses of the magics, and small ones."""
    cells = [
        LOAD,
        "%%scc model walk\n" + MODEL,
        "checked = %scc check walk --states 300\nprint(checked.verdicts)",
        "%scc check walk --json",
        "%scc",
        "%scc check",
        "%scc check 'walk",
        "%scc serve walk",
        "%scc nonsense walk",
        "%%scc model walk 2\n" + MODEL,
        "%%scc model broken\nprocess p = Nothing [nil]\n",
        "%scc check --help",
        "%scc translate walk --to xml",
        "%%scc check\n",
        "%scc check no-such-file.sc",
        "%scc check walk --no-such-option",
    ]
    outputs = [texts(o) for o in run(cells, folder, allow_errors=True)]
    said = {
        2: "{'never': 'holds-up-to-bound'}",
        3: "leave --json out",
        4: "usage: %%scc COMMAND",
        5: "usage: %scc check MODEL",
        6: "No closing quotation",
        7: "it is no command for a cell",
        8: "nonsense",
        9: "usage: %%scc model NAME",
        10: "SC0",
        11: "explore a model",
        12: "&lt;?xml",
        14: "cannot read",
        15: "no-such-option",
    }
    for number, words in said.items():
        expect("%r says %r" % (cells[number][:40], words), words in outputs[number], outputs[number][:600])


def left(mark):
    """The processes of a kernel that are programs scc, with or without workers."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open("/proc/%s/environ" % name, "rb") as file:
                ours = mark.encode() in file.read()
            target = os.readlink("/proc/%s/exe" % name)
        except OSError:
            continue
        if ours and os.path.basename(target) == "scc":
            found.append(int(name))
    return found


def wait(condition, seconds=600):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.1)
    return condition()


def working(folder):
    """A kernel in which a check runs that has no end, and the mark of its processes."""
    mark = "SCC_NOTEBOOK_TEST=%d" % time.monotonic_ns()
    manager = KernelManager(kernel_name="python3")
    manager.start_kernel(env=dict(os.environ, **dict([mark.split("=")])), cwd=folder)
    client = manager.blocking_client()
    client.start_channels()
    client.wait_for_ready(timeout=600)
    client.execute_interactive(LOAD, timeout=600)
    return mark, manager, client


def interrupted(folder):
    mark, manager, client = working(folder)
    client.execute(ENDLESS)
    expect("interrupt: the check runs", wait(lambda: len(left(mark)) > 0))
    time.sleep(2)
    manager.interrupt_kernel()
    said = ""
    while True:
        message = client.get_iopub_msg(timeout=600)
        if message["msg_type"] == "execute_result":
            said = message["content"]["data"]["text/plain"]
        if message["msg_type"] == "status" and message["content"]["execution_state"] == "idle" and said:
            break
        if message["msg_type"] == "error":
            said = str(message["content"])
            break
    expect("interrupt: the result is what was found", "interrupted" in said and "<checked:" in said, said[:800])
    expect("interrupt: nothing runs any more", wait(lambda: not left(mark), 60))
    client.stop_channels()
    manager.shutdown_kernel(now=True)


def killed(folder):
    mark, manager, client = working(folder)
    client.execute(ENDLESS)
    expect("kill: the check runs", wait(lambda: len(left(mark)) > 0))
    time.sleep(1)
    os.kill(manager.provisioner.process.pid, signal.SIGKILL)
    expect("kill: nothing runs any more", wait(lambda: not left(mark), 60), left(mark))
    client.stop_channels()
    manager.shutdown_kernel(now=True)


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = sys.argv[1] if len(sys.argv) > 1 else scratch
        os.makedirs(folder, exist_ok=True)
        for part in (notebooks, markup, commands, interrupted, killed):
            print("-- " + part.__name__, flush=True)
            part(folder)
    print("%d passed, %d failed" % (passed, failed))
    return 0 if failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
