"use strict";

/**
 * @typedef {{offset: number, line: number, column: number}} Spot
 * @typedef {{file: string, start: Spot, end: Spot}} Place
 * @typedef {{code: string, severity: string, message: string, place: Place | null,
 *            notes: {message: string, place: Place | null}[], hint: string | null}} Diagnostic
 *   Without a place it is about the model as a whole.
 * @typedef {{diagnostic: Diagnostic, from: number, to: number, here: boolean}} Problem
 */

/** What is wrong in the text: underlined at its place, told in a list below. */
const Problems = (() => {
  const most = 200;
  /** @type {Writing} */
  let editor;
  /** @type {Rows} */
  let list;
  /** @type {{[source: string]: Diagnostic[]}} */
  const found = { typed: [], made: [] };
  /** The text of the document in which `made` were found: they say nothing of another one. */
  let of = "";
  /** @type {Problem[]} */
  let all = [];
  /** @type {(() => {from: number, to: number} | null)[]} */
  let live = [];
  let told = "";
  let read = false;

  /** @param {Writing} of @param {HTMLElement} box */
  function start(of, box) {
    editor = of;
    list = new Rows(box, {
      label: "Problems",
      empty: "The text has not been read yet.",
      test: "problems",
      step: (k) => {
        const at = where(k);
        if (at) editor.reveal(at.from, at.to);
      },
      choose: (k) => visit(k),
    });
  }

  /**
   * What a source has found in a text: `typed`, as one types; `made`, as a document was made.
   * @param {string} source @param {Diagnostic[]} diagnostics
   */
  function set(source, diagnostics) {
    found[source] = diagnostics;
    if (source === "typed") read = true;
    if (source === "made") of = editor.text();
    show();
  }

  /** @param {Diagnostic} d whether its place is in this text */
  const isHere = ({ place }) => place !== null && (place.file === "<model>" || place.file === Desk.file());

  function unique() {
    /** @type {Map<string, Diagnostic>} */
    const known = new Map();
    for (const d of editor.text() === of ? [...found.typed, ...found.made] : found.typed) {
      const at = d.place && `${isHere(d) ? "" : d.place.file} ${d.place.start.offset}`;
      const key = `${d.code} ${at} ${d.message}`;
      if (!known.has(key)) known.set(key, d);
    }
    return [...known.values()];
  }

  /** Nobody could read the text as it is now: it is not known what is wrong with it. */
  function unread() {
    found.typed = [];
    read = false;
    show();
  }

  function show() {
    const text = editor.text();
    const diagnostics = unique();
    const places = Source.places(
      text,
      diagnostics.flatMap(({ place }) => (place ? [place.start.offset, place.end.offset] : [0, 0])),
    );
    all = diagnostics.map((diagnostic, k) => {
      const here = isHere(diagnostic);
      return { diagnostic, here, ...(here ? seen(text, places[2 * k], places[2 * k + 1]) : { from: 0, to: 0 }) };
    });
    all.sort((a, b) => Number(b.here) - Number(a.here) || a.from - b.from);
    const marked = all.filter((one) => one.here);
    const marks = editor.mark(
      marked.map(({ diagnostic, from, to }) => ({
        from,
        to,
        severity: diagnostic.severity,
        title: words(diagnostic),
      })),
    );
    live = all.map((one) => (one.here ? marks[marked.indexOf(one)] : () => null));
    list.fill(rows(), read ? "No problems." : "The text has not been read.");
    count();
  }

  /**
   * A place of nothing is seen as the character there, or before it.
   * @param {string} text @param {number} from @param {number} to
   */
  function seen(text, from, to) {
    if (to > from) return { from, to };
    if (from < text.length && text[from] !== "\n") return { from, to: from + 1 };
    let at = from;
    while (at > 0 && /\s/.test(text[at - 1])) at -= 1;
    return at === 0 ? { from, to: from } : { from: at - 1, to: at };
  }

  /** @param {Diagnostic} d */
  function words(d) {
    const hint = d.hint ? `\nHint: ${d.hint}` : "";
    return `${d.severity} ${d.code}: ${d.message}${hint}`;
  }

  function rows() {
    const made = all.slice(0, most).map(row);
    if (all.length > most)
      made.push(Dom.make("div", { class: "problem-row quiet", text: `and ${all.length - most} more` }));
    return made;
  }

  /** @param {Problem} problem */
  function row({ diagnostic: d, here }) {
    const error = d.severity === "error";
    const at = d.place && `${d.place.start.line}:${d.place.start.column}`;
    const notes = d.notes.map((note) => Dom.make("div", { class: "quiet", dir: "auto", text: Dom.clip(note.message, 2000) }));
    return Dom.make("div", { class: "problem-row", "data-code": d.code, "data-severity": d.severity }, [
      Dom.make("span", { class: error ? "sign-error" : "sign-warning", "aria-hidden": "true", text: error ? "●" : "▲" }),
      Dom.make("div", { class: "problem-words" }, [
        Dom.make("div", {}, [
          Dom.make("span", { class: "code-name", text: `${error ? "Error" : "Warning"} ${d.code} ` }),
          Dom.make("bdi", { text: Dom.clip(d.message, 4000) }),
        ]),
        ...notes,
        d.hint ? Dom.make("div", { class: "hint", dir: "auto", text: `Hint: ${Dom.clip(d.hint, 2000)}` }) : null,
        here && fixable(d) ? Dom.make("button", { class: "fix", type: "button", test: "fix", text: "Fix", click: (/** @type {Event} */ event) => { event.stopPropagation(); fix(d); } }) : null,
      ]),
      d.place && Dom.make("bdi", { class: "quiet where", text: here ? at : `${Dom.clip(d.place.file, 40)}:${at}` }),
    ]);
  }

  /**
   * Whether the server may know a change that mends it: hints of names, signs that are missing, what is not used.
   * @param {Diagnostic} d
   */
  const fixable = (d) => d.code === "SC0211" || d.code === "SC0113" || /^did you mean |`\*`|is one word$/.test(d.hint || "");

  /** @param {Diagnostic} d */
  async function fix(d) {
    const text = editor.text();
    const answer = await Server.ask("text.fixes", { text: Source.outer(text) });
    if (editor.text() !== text || d.place === null) return;
    const start = d.place.start.offset;
    const fixes = "result" in answer ? answer.result.fixes : [];
    const one = fixes.find((/** @type {{code: string, start: number}} */ f) => f.code === d.code && f.start === start);
    if (!one) return Notices.say("No change is known that mends this.");
    const { edits } = /** @type {{edits: {start: number, stop: number, text: string}[]}} */ (one);
    let fresh = text;
    for (const edit of [...edits].sort((a, b) => b.start - a.start)) {
      const [from, to] = Source.places(text, [edit.start, edit.stop]);
      fresh = fresh.slice(0, from) + edit.text + fresh.slice(to);
    }
    editor.replace(fresh);
    Notices.say(`Done: ${one.title}.`);
  }

  function count() {
    const errors = all.filter((one) => one.diagnostic.severity === "error").length;
    const warnings = all.length - errors;
    const parts = [number(errors, "error"), number(warnings, "warning")].filter((part) => part !== "");
    const text = parts.length > 0 ? parts.join(", ") : read ? "No problems" : "The text has not been read";
    const head = Dom.get("problems-count");
    Dom.tell(head, errors + warnings === 0 ? "" : String(errors + warnings));
    head.className = errors > 0 ? "count bad" : warnings > 0 ? "count open" : "count";
    if (text !== told) Notices.say(text + ".");
    told = text;
  }

  /** @param {number} n @param {string} what */
  const number = (n, what) => (n === 0 ? "" : n === 1 ? `1 ${what}` : `${n} ${what}s`);

  /**
   * Where it is now: the text may have changed since.
   * @param {number} k @returns {{from: number, to: number} | null}
   */
  function where(k) {
    if (!all[k] || !all[k].here) return null;
    return live[k]() || { from: all[k].from, to: all[k].to };
  }

  /** @param {number} k */
  function visit(k) {
    const at = where(k);
    if (at) Desk.visit(at.from, at.to);
  }

  /**
   * To the next problem of the text, or the one before.
   * @param {number} by 1 or -1
   */
  function next(by) {
    const places = all.map((_, k) => where(k)).filter((at) => at !== null);
    if (places.length === 0) return Notices.say("No problems.");
    const cursor = editor.cursor();
    const order = all.map((_, k) => k).filter((k) => where(k) !== null);
    const is = (/** @type {number} */ k) => /** @type {{from: number, to: number}} */ (where(k));
    const before = order.filter((k) => is(k).to < cursor || (is(k).from < cursor && is(k).to === cursor));
    const after = order.filter((k) => is(k).from > cursor);
    // The one that is selected has its end at the cursor.
    const k =
      by > 0
        ? after.length > 0 ? after[0] : order[0]
        : before.filter((b) => is(b).to < cursor).slice(-1)[0] ?? order[order.length - 1];
    list.mark(k);
    visit(k);
    Notices.say(words(all[k].diagnostic));
  }

  /**
   * Those at a place of the text.
   * @param {number} index
   */
  function at(index) {
    return all.filter((_, k) => {
      const place = where(k);
      return place !== null && place.from <= index && index <= place.to;
    });
  }

  const list_ = () => all;
  const errors = () => all.some((one) => one.diagnostic.severity === "error");

  return { start, set, unread, next, at, words, all: list_, errors };
})();
