"use strict";

/** The editor where CodeMirror is not there: what the browser has, without colours and underlines. */
const PlainEditor = (() => {
  /** @param {HTMLElement} box @param {string} label @returns {Writing} */
  function make(box, label) {
    const area = Dom.make("textarea", {
      class: "plain",
      "aria-label": label,
      spellcheck: "false",
      autocapitalize: "off",
      autocomplete: "off",
      wrap: "off",
      test: "text",
    });
    box.append(area);
    let changes = 0;
    /** @type {Map<number, string>} */
    const texts = new Map();
    /** @type {(() => void)[]} */
    const heard = [];
    const changed = () => {
      changes += 1;
      for (const one of heard) one();
    };
    area.addEventListener("input", changed);

    /** @param {number} from @param {number} to */
    function reveal(from, to) {
      area.setSelectionRange(from, to);
      const height = parseFloat(getComputedStyle(area).lineHeight) || 18;
      area.scrollTop = Math.max(0, height * (line(from).line - 5));
    }

    /** @param {number} index */
    function line(index) {
      const before = area.value.slice(0, index);
      const at = before.lastIndexOf("\n");
      return { line: before.split("\n").length - 1, ch: index - at - 1 };
    }

    return {
      box,
      text: () => area.value,
      reset: (text) => {
        area.value = text;
        changed();
      },
      replace: (text) => {
        const piece = pieceThatDiffers(area.value, text);
        area.setRangeText(piece.text, piece.from, piece.to, "end");
        changed();
      },
      generation: () => {
        texts.clear();
        texts.set(changes, area.value);
        return changes;
      },
      unchanged: (generation) => generation === changes || texts.get(generation) === area.value,
      cursor: () => area.selectionStart,
      line,
      reveal,
      go: (from, to) => {
        reveal(from, to);
        area.focus();
      },
      place: () => {
        const { left, bottom, top } = area.getBoundingClientRect();
        return { left: left + 20, bottom: Math.min(bottom, top + 60), top };
      },
      mark: (all) => all.map(() => () => null),
      focus: () => area.focus(),
      refresh: () => {},
      on: (event, hear) => {
        if (event === "change") heard.push(hear);
        else for (const one of ["keyup", "mouseup", "input"]) area.addEventListener(one, hear);
      },
      point: () => {},
      jump: () => {},
    };
  }

  return { make };
})();
