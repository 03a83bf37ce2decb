"use strict";

/** The line in which any number or formula is asked for. */
const Wanted = (() => {
  /** @type {HTMLInputElement} */
  let input;
  /** @type {HTMLElement} */
  let wrong;
  /** @type {HTMLElement} */
  let note;

  /** @param {HTMLElement} box where it goes @param {(text: string) => void} ask @param {string} hint */
  function start(box, ask, hint) {
    input = Dom.make("input", {
      type: "text",
      "aria-label": "Any number or formula",
      "aria-describedby": "plot-wrong",
      placeholder: hint,
      spellcheck: "false",
      autocomplete: "off",
      maxlength: 10000,
      test: "plot-input",
    });
    wrong = Dom.make("p", { id: "plot-wrong", class: "plot-wrong", role: "alert", hidden: true, test: "plot-wrong" });
    const form = Dom.make("form", { class: "plot-ask" }, [
      input, Dom.make("button", { type: "submit", text: "Plot", test: "plot-add" }),
    ]);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const text = input.value.trim();
      wrong.hidden = true;
      input.value = "";
      if (text !== "") ask(text);
    });
    input.addEventListener("input", () => {
      wrong.hidden = true;
    });
    note = Dom.make("p", { class: "plot-wrong", role: "status", hidden: true, test: "plot-note" });
    box.append(form, wrong, note);
  }

  /**
   * Says what is wrong with a text, and marks where; it can be mended, unless another one has been begun.
   * @param {string} text @param {string} why @param {number} from @param {number} to the characters that are marked
   */
  function refuse(text, why, from, to) {
    if (input.value === "") input.value = text;
    wrong.hidden = false;
    const mark = Dom.make("mark", { text: text.slice(from, to) || "\u00a0" });
    const [before, after] = [Dom.clip(text.slice(0, from), 300), Dom.clip(text.slice(to), 300)];
    Dom.fill(
      wrong,
      Dom.make("bdi", { class: "code" }, [before, mark, after]),
      Dom.make("bdi", { class: "words", text: why }),
    );
    input.scrollIntoView({ block: "nearest" });
  }

  /**
   * Says something of the plots that are shown, or nothing.
   * @param {string} text
   */
  function say(text) {
    note.hidden = text === "";
    Dom.fill(note, Dom.make("bdi", { class: "words", text }));
  }

  return { start, refuse, say };
})();
