"""The pages of scc view, simulate --view, shape --view and serve, by axe (npm's axe-core): no violations of any of its rules, in
light and dark, in a wide and in a narrow window, with each tab and panel open. None of the package becomes part of this
project.
"""

import os
import subprocess
import sys

from common import Run, absent, npm_pack

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "web"))

import browser  # noqa: E402

PACKAGE = "axe-core@4.14.1"
AXE = """
  const [done] = arguments;
  axe.run(document, { resultTypes: ["violations"], iframes: false }).then(
    ({ violations }) => done(violations.map(({ id, nodes }) => [id, ...nodes.slice(0, 3).map((node) => node.target.join(" "))])),
    (error) => done([String(error)]));"""
SIZES = [(1400, 900), (400, 700)]
#: What is opened on a page of a model, one after the other: marks of buttons.
PANELS = ["tab-details", "tab-rules", "tab-source", "tab-where", "graph-switch", "graph-legend", "export", "export-close", "help"]
#: A run with choices and bonds; open starts; chances.
MODELS = ["hexokinase", "meeting", "ruin"]
FAULTY = "shape Cube { }\nprocess p = Cube mass 1 [nil]\n"
HOLE = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"


def judge(run, b, axe, what):
    b.js(axe)
    # The text of the editor scrolls with the cursor of its field, which has the focus.
    found = [one for one in b.driver.execute_async_script(AXE) if one != ["scrollable-region-focusable", ".CodeMirror-scroll"]]
    run.ok(found == [], f"{what}: {found}")


def each(run, b, axe, name, show, panels=()):
    """Judges a page, in both themes and sizes, and then with each of these opened."""
    for theme in ["light", "dark"]:
        b.prefer(color_scheme=theme, reduced_motion="reduce")
        for size in SIZES:
            b.size(*size)
            show()
            judge(run, b, axe, f"{name}, {theme}, {size[0]} wide")
            for panel in panels if size == SIZES[0] else ():
                there = b.js("""
                  const button = document.querySelector(`[data-testid="${arguments[0]}"]`);
                  if (!button || button.hidden || !button.getClientRects().length) return false;
                  button.click();
                  return true;""", panel)
                if there:
                    judge(run, b, axe, f"{name}, {theme}, {size[0]} wide, {panel}")


def written(run, name, text):
    with open(run.path(name), "w", encoding="utf-8") as file:
        file.write(text)
    return run.path(name)


def made(run, page, *words):
    run.call(*words, page)
    return run.ok(os.path.exists(page), f"{words}: no page")


def desk(run, b, axe, model, name):
    served = subprocess.Popen([run.scc, "serve", model], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        told = next((line for line in served.stdout if "http://" in line), "")
        address = told[told.find("http://"):].split()[0] if told else ""

        def show():
            b.driver.get(address)
            b.wait('return document.body && document.body.dataset.ready === "true" && desk.state().read')
            if name == "the desk":
                b.wait("return desk.document() !== null")

        if run.ok(address, f"{name} is not served"):
            each(run, b, axe, name, show)
    finally:
        served.terminate()
        served.wait()


def main():
    missing = browser.missing()
    if missing:
        absent(missing)
    run = Run("Pages have no violations of axe's rules")
    with npm_pack(PACKAGE, run.folder) as pack:
        axe = pack.extractfile("package/axe.min.js").read().decode()
    b = browser.Browser()
    try:
        for model in MODELS:
            page = run.path(f"{model}.html")
            if made(run, page, "view", f"specs/models/{model}.sc", "--seconds", "20", "-o"):
                each(run, b, axe, model, lambda: b.open(page), PANELS)
        page = run.path("runs.html")
        if made(run, page, "simulate", "specs/models/brownian.sc", "--runs", "20", "--observe", "x(ligand)", "--every", "2", "--until", "8", "--view"):
            each(run, b, axe, "runs", lambda: b.open(page))
        for name, text in [("solid", None), ("hole", HOLE)]:
            page = run.path(f"{name}.html")
            solid = written(run, f"{name}.off", text) if text else "specs/conformance/solids/" + sorted(os.listdir("specs/conformance/solids"))[0]
            if made(run, page, "shape", solid, "--view"):
                each(run, b, axe, name, lambda: b.open(page))
        desk(run, b, axe, "specs/models/hexokinase.sc", "the desk")
        desk(run, b, axe, written(run, "faulty.sc", FAULTY), "the desk of a faulty model")
        without = browser.Browser(flags=browser.WITHOUT_SCENES)
        try:
            each(run, without, axe, "a page without a scene", lambda: without.open(run.path("hexokinase.html")))
        finally:
            without.quit()
    finally:
        b.quit()
    run.end()


main()
