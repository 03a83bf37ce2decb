"use strict";

/** The verdicts of the last check. Each leads to the run that shows it. */
const Verdicts = (() => {
  /** @type {Rows} */
  let list;
  /** @type {Verdict[]} */
  let all = [];

  /** @param {HTMLElement} box */
  function start(box) {
    list = new Rows(box, {
      label: "Verdicts",
      empty: "Not checked yet.",
      test: "verdicts",
      choose: (k) => Documents.run(all[k].name),
    });
  }

  /** @param {Verdict} one */
  function kind(one) {
    if (one.verdict === "violated") return "violated";
    return one.verdict === "holds" ? "holds" : "undecided";
  }

  /** @param {Verdict[]} verdicts @param {boolean} interrupted */
  function show(verdicts, interrupted) {
    all = verdicts;
    list.fill(all.map(row), "The model has no checks.");
    const kinds = all.map(kind);
    list.mark(kinds.indexOf("violated"));
    const count = (/** @type {string} */ one) => kinds.filter((is) => is === one).length;
    const parts = [
      [count("holds"), count("holds") === 1 ? "holds" : "hold"],
      [count("violated"), "violated"],
      [count("undecided"), "undecided"],
    ].filter(([n]) => n !== 0);
    const words = parts.map(([n, what]) => `${n} ${what}`).join(", ");
    const told = words === "" ? "no checks" : words;
    Dom.tell(Dom.get("verdicts-count"), `${told}${interrupted ? ", stopped" : ""}`);
    Notices.say(`Checked: ${told}${interrupted ? ", stopped before the end" : ""}.`);
  }

  /** @param {Verdict} one */
  function row(one) {
    const formula = one.formula ? Dom.make("bdi", { class: "formula quiet", text: Dom.clip(one.formula, 600) }) : null;
    return Dom.make(
      "div",
      { class: `verdict-row verdict-${kind(one)}`, "data-name": one.name, "data-verdict": one.verdict },
      [
        Dom.make("div", { class: "verdict-top" }, [
          Dom.name(one.name, "name"),
          Dom.make("span", { class: "verdict", text: one.verdict.replace(/-/g, " ") }),
        ]),
        formula,
        one.text !== one.verdict ? Dom.make("bdi", { class: "quiet", text: Dom.clip(one.text, 600) }) : null,
      ],
    );
  }

  return { start, show, all: () => all };
})();
