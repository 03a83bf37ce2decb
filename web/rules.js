"use strict";

/** The entries of the rule book that the file carries along, as texts. */
const Rules = (() => {
  /** @type {PageData} */
  let data;
  /** @type {HTMLElement} */
  let box;

  /** @param {PageData} from */
  function start(from) {
    data = from;
    box = Dom.get("rule");
    const names = Object.keys(data.rules);
    Dom.fill(
      box,
      Dom.make("p", {
        class: "empty",
        text:
          names.length === 0
            ? "The file carries no rules."
            : "The name of a rule, beside an event, shows its entry in the rule book here.",
      }),
      index(names),
    );
  }

  /** @param {string[]} names */
  function index(names) {
    return Dom.make(
      "div",
      { class: "rule-index" },
      names.map((name) => link(name)),
    );
  }

  /**
   * A button that shows the entry of a rule.
   * @param {string} name
   */
  function link(name) {
    return Dom.button(
      name,
      (event) => {
        event.stopPropagation();
        show(name);
      },
      { class: "link", test: `rule-${name}`, title: `The rule ${name} in the rule book` },
    );
  }

  /**
   * Shows the entry of a rule.
   * @param {string} name
   */
  function show(name) {
    Tabs.show("rule");
    const text = Object.prototype.hasOwnProperty.call(data.rules, name) ? data.rules[name] : null;
    const head = Dom.make("h3", { text: `Rule ${name}`, tabindex: "-1", test: "rule-head" });
    if (text === null) {
      Dom.fill(box, head, Dom.make("p", { class: "empty", text: "The file does not carry this rule." }));
    } else {
      Dom.fill(
        box,
        head,
        ...blocks(text.replace(/^#+ .*\n/, "")),
        Dom.make("h3", { text: "All rules of this file" }),
        index(Object.keys(data.rules)),
      );
    }
    box.scrollTop = 0;
    head.focus({ preventScroll: window.innerWidth > 1100 });
  }

  /**
   * Paragraphs and lists of a text in Markdown.
   * @param {string} text @returns {HTMLElement[]}
   */
  function blocks(text) {
    /** @type {HTMLElement[]} */
    const made = [];
    for (const block of text.split(/\n\s*\n/)) {
      const lines = block.split("\n").filter((line) => line.trim() !== "");
      if (lines.length === 0) continue;
      if (/^\s*[-*] /.test(lines[0])) {
        const items = block
          .split(/\n(?=\s*[-*] )/)
          .map((item) => item.replace(/^\s*[-*] /, "").replace(/\s*\n\s*/g, " "));
        made.push(
          Dom.make(
            "ul",
            {},
            items.map((item) => spans("li", item)),
          ),
        );
      } else if (lines.every((line) => /^ {4}|^\||^```/.test(line))) {
        made.push(Dom.make("pre", { text: block }));
      } else {
        made.push(spans("p", lines.join(" ")));
      }
    }
    return made;
  }

  /** @param {"li" | "p"} tag @param {string} text */
  function spans(tag, text) {
    return Dom.make(
      tag,
      {},
      text.split(/(`[^`]*`|\*\*[^*]+\*\*|\*[^*]+\*)/).map((piece) => {
        if (/^`.*`$/s.test(piece)) return Dom.make("code", { text: piece.slice(1, -1) });
        if (/^\*\*.*\*\*$/s.test(piece)) return Dom.make("strong", { text: piece.slice(2, -2) });
        if (/^\*.*\*$/s.test(piece)) return Dom.make("em", { text: piece.slice(1, -1) });
        return piece;
      }),
    );
  }

  return { start, link, show };
})();
