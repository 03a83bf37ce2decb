"use strict";

/**
 * @typedef {{from: number, to: number, severity: string, title: string}} Underlined
 * @typedef {{
 *   text: () => string,
 *   reset: (text: string) => void,
 *   replace: (text: string) => void,
 *   generation: () => number,
 *   unchanged: (generation: number) => boolean,
 *   cursor: () => number,
 *   line: (index: number) => {line: number, ch: number},
 *   reveal: (from: number, to: number) => void,
 *   go: (from: number, to: number) => void,
 *   place: (index: number) => {left: number, bottom: number, top: number} | null,
 *   mark: (all: Underlined[]) => (() => {from: number, to: number} | null)[],
 *   focus: () => void,
 *   refresh: () => void,
 *   box: HTMLElement,
 *   on: (event: "change" | "cursor", heard: () => void) => void,
 *   point: (index: (index: number | null, left: number, bottom: number, top: number) => void) => void,
 *   jump: (to: (index: number) => void) => void,
 * }} Writing
 */

/**
 * The smallest piece of a text that differs from another one: what is put in its place keeps marks and the history small.
 * @param {string} before @param {string} after
 */
function pieceThatDiffers(before, after) {
  const least = Math.min(before.length, after.length);
  let from = 0;
  while (from < least && before.charCodeAt(from) === after.charCodeAt(from)) from += 1;
  let end = 0;
  while (
    end < least - from &&
    before.charCodeAt(before.length - 1 - end) === after.charCodeAt(after.length - 1 - end)
  )
    end += 1;
  return { from, to: before.length - end, text: after.slice(from, after.length - end) };
}

/** The editor, by CodeMirror. */
const RichEditor = (() => {
  // Marks of direction as well: nothing of a text hides.
  const special =
    /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u00a0\u00ad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\ufff9-\ufffc]/;

  /** @param {HTMLElement} box @param {string} label @returns {Writing} */
  function make(box, label) {
    Language.define();
    const editor = CodeMirror(box, {
      mode: "shape-calculus",
      theme: "scc",
      lineNumbers: true,
      gutters: ["problems", "CodeMirror-linenumbers"],
      indentUnit: 2,
      tabSize: 2,
      matchBrackets: true,
      styleActiveLine: true,
      specialChars: special,
      screenReaderLabel: label,
      extraKeys: {
        Tab: (/** @type {CmEditor} */ cm) =>
          cm.somethingSelected() ? cm.indentSelection("add") : cm.replaceSelection("  "),
        "Shift-Tab": (/** @type {CmEditor} */ cm) => cm.indentSelection("subtract"),
        "Ctrl-/": "toggleComment",
        "Cmd-/": "toggleComment",
      },
    });
    leave(editor);
    /** @type {CmMark[]} */
    let marks = [];
    const index = (/** @type {CmPosition} */ at) => editor.indexFromPos(at);
    const at = (/** @type {number} */ i) => editor.posFromIndex(i);
    const input = editor.getInputField();
    input.setAttribute("aria-describedby", "leaving");
    input.setAttribute("data-testid", "text");

    /** @param {string} text */
    function replace(text) {
      const piece = pieceThatDiffers(editor.getValue(), text);
      if (piece.from === piece.to && piece.text === "") return;
      editor.replaceRange(piece.text, at(piece.from), at(piece.to), "+replace");
    }

    /** @param {Underlined[]} all */
    function mark(all) {
      return editor.operation(() => {
        for (const one of marks) one.clear();
        editor.clearGutter("problems");
        marks = all.map((one) =>
          editor.markText(at(one.from), at(one.to), { className: `problem problem-${one.severity}` }),
        );
        gutter(editor, all, at);
        return marks.map((one) => () => {
          const found = one.find();
          return found ? { from: index(found.from), to: index(found.to) } : null;
        });
      });
    }

    return {
      box,
      text: () => editor.getValue("\n"),
      reset: (text) => {
        editor.setValue(text);
        editor.clearHistory();
      },
      replace,
      generation: () => editor.changeGeneration(true),
      unchanged: (generation) => editor.isClean(generation),
      cursor: () => index(editor.getCursor()),
      line: (i) => at(i),
      reveal: (from, to) => {
        editor.setSelection(at(from), at(to));
        editor.scrollIntoView({ from: at(from), to: at(to) }, 60);
      },
      go: (from, to) => {
        editor.setSelection(at(from), at(to));
        editor.scrollIntoView({ from: at(from), to: at(to) }, 60);
        editor.focus();
      },
      place: (i) => editor.charCoords(at(i), "window"),
      mark,
      focus: () => editor.focus(),
      refresh: () => editor.refresh(),
      on: (event, heard) => editor.on(event === "change" ? "changes" : "cursorActivity", () => heard()),
      point: (heard) => point(editor, heard),
      jump: (to) =>
        editor.on("mousedown", (_, event) => {
          if (!(event.ctrlKey || event.metaKey) || event.button !== 0) return;
          event.preventDefault();
          to(index(editor.coordsChar({ left: event.clientX, top: event.clientY }, "window")));
        }),
    };
  }

  /**
   * Escape and then the tabulator leads on to the next element.
   * @param {CmEditor} editor
   */
  function leave(editor) {
    let free = false;
    editor.on("keydown", (_, event) => {
      if (event.key === "Tab" && free) event.codemirrorIgnore = true;
      if (event.key !== "Shift") free = event.key === "Escape";
    });
    editor.on("focus", () => {
      free = false;
    });
  }

  /**
   * A sign at each line with problems, of the worst of them.
   * @param {CmEditor} editor @param {Underlined[]} all @param {(i: number) => CmPosition} at
   */
  function gutter(editor, all, at) {
    /** @type {Map<number, Underlined[]>} */
    const lines = new Map();
    for (const one of all) {
      const { line } = at(one.from);
      lines.set(line, [...(lines.get(line) || []), one]);
    }
    for (const [line, here] of lines) {
      const worst = here.some((one) => one.severity === "error") ? "error" : "warning";
      const title = here.map((one) => one.title).join("\n");
      editor.setGutterMarker(
        line,
        "problems",
        Dom.make("span", { class: `sign-${worst}`, title, text: worst === "error" ? "●" : "▲" }),
      );
    }
  }

  /**
   * @param {CmEditor} editor
   * @param {(index: number | null, left: number, bottom: number, top: number) => void} heard
   */
  function point(editor, heard) {
    const wrapper = editor.getWrapperElement();
    wrapper.addEventListener("mousemove", (event) => {
      const within = event.target instanceof Element && event.target.closest(".CodeMirror-line") !== null;
      if (!within || event.buttons !== 0) return heard(null, 0, 0, 0);
      const at = editor.coordsChar({ left: event.clientX, top: event.clientY }, "window");
      // Beyond the end of a line there is nothing.
      if (at.outside) return heard(null, 0, 0, 0);
      const box = editor.charCoords(at, "window");
      heard(editor.indexFromPos(at), event.clientX, box.bottom, box.top);
    });
    wrapper.addEventListener("mouseleave", () => heard(null, 0, 0, 0));
    wrapper.addEventListener("mousedown", () => heard(null, 0, 0, 0));
  }

  return { make };
})();
