"use strict";

/** Puts the desk together. */
const Desk = (() => {
  /**
   * @typedef {{name: string, path: string | null, text: string, saved: string | null, unreadable: string | null,
   *   parameters: {[name: string]: any}}} DeskData
   */
  const stillness = 500;
  /** @type {DeskData} */
  let data;
  /** @type {Writing} */
  let editor;
  let automatic = true;
  let timer = 0;
  let begun = false;
  /** @type {string} where the view was before a reload, told once */
  let address = "";

  const outer = () => Source.outer(editor.text());

  function start() {
    data = JSON.parse(Dom.get("data").textContent || "");
    Dom.get("title").textContent = Dom.clip(data.name, 300);
    Dom.get("title").title = Dom.clip(data.path || data.name, 400);
    const label = "Text of the model";
    const make = typeof CodeMirror === "undefined" ? PlainEditor.make : RichEditor.make;
    editor = make(Dom.get("editor"), label);
    Keep.start(data.path || data.name, memory);
    const before = Keep.read();
    editor.reset(Source.read(data.text));
    Theme.start(Dom.get("theme"), true, () => {});
    Notices.say("");
    Problems.start(editor, Dom.get("problems"));
    Verdicts.start(Dom.get("verdicts"));
    Saving.start(editor, data, data.saved, draw);
    Documents.start(() => editor.text(), draw);
    Frames.start(Dom.get("frames"), (event) => Commands.key(event), over);
    Server.start(away);
    parts();
    Commands.start(commands());
    switches(before);
    editor.on("change", changed);
    editor.on("cursor", cursor);
    recall(before);
    if (data.unreadable !== null)
      Notices.show("unreadable", `The file cannot be read: ${Dom.clip(data.unreadable, 500)}.`);
    Hover.start(editor);
    Complete.start(editor);
    draw();
    cursor();
    Object.defineProperty(window, "desk", { value: probe() });
    editor.focus();
    document.body.setAttribute("data-ready", "true");
  }

  // What is kept over a reload.

  function memory() {
    return {
      text: Saving.unsaved() ? editor.text() : null,
      saved: Saving.version(),
      server: window.location.pathname,
      documents: Documents.memory(),
      link: Frames.link(),
      automatic,
    };
  }

  /** @param {ReturnType<typeof memory> | null} kept */
  async function recall(kept) {
    if (kept) {
      if (typeof kept.text === "string" && kept.text !== editor.text()) bring(kept.text, kept.saved);
    }
    if (kept && kept.server === window.location.pathname && kept.documents) {
      address = String(kept.link || "");
      await Documents.recall(kept.documents);
      address = "";
    }
    begun = true;
    Diagnose.start(editor, data.parameters, sound);
  }

  /** @param {string} text @param {string | null} saved */
  function bring(text, saved) {
    editor.replace(text);
    const other = saved !== data.saved;
    if (other) Saving.base(saved);
    const words = other
      ? "This is the text that you had not saved. The file has been changed by somebody else meanwhile."
      : "This is the text that you had not saved.";
    const back = data.path === null ? "Go back to the beginning" : "Go back to the file";
    Notices.show("kept", words, [{ text: back, press: original, test: "go-back" }]);
  }

  /** The text as it was when the page was loaded; undo brings the other one back. */
  function original() {
    Saving.take({ text: data.text, saved: /** @type {string} */ (data.saved) });
    draw();
    editor.focus();
  }

  /** Where the view begins: where it was before a reload. */
  function kept() {
    return address;
  }

  // As one types.

  function changed() {
    window.clearTimeout(timer);
    draw();
  }

  /** @param {boolean} isSound */
  function sound(isSound) {
    window.clearTimeout(timer);
    const fresh = Documents.shown() === null && Documents.working() === null;
    if (isSound && (automatic || fresh)) timer = window.setTimeout(refresh, begun && !fresh ? stillness : 0);
    draw();
  }

  /** Shows the text as it is now, if it is not shown. */
  function refresh() {
    const sum = Source.sum(editor.text());
    const shown = Documents.shown();
    const opening = Documents.opening();
    const checking = Documents.memory().making;
    if (opening ? opening.sum === sum : shown !== null && shown.sum === sum) return;
    if (checking !== null && checking.sum === sum) return;
    Documents.open("show", null);
  }

  function draw() {
    const working = Documents.working();
    const unsaved = Saving.unsaved();
    Dom.get("unsaved").hidden = !unsaved;
    document.title = `${unsaved ? "• " : ""}${Dom.clip(data.name, 100)} – scc`;
    /** @type {HTMLButtonElement} */ (Dom.get("stop")).disabled = working === null;
    Dom.tell(Dom.get("progress"), Documents.progress());
    Dom.get("working").hidden = working === null;
    const shown = Documents.shown();
    const checked = Documents.checked();
    const sum = shown || checked ? Source.sum(editor.text()) : "";
    Dom.get("older").hidden = shown === null || shown.sum === sum;
    Dom.get("verdicts-older").hidden = checked === null || checked.sum === sum;
    Dom.get("nothing").hidden = shown !== null;
    Dom.tell(
      Dom.get("nothing"),
      working ? "The view is being made …" : Problems.errors() ? "The view appears when the text has no errors." : "",
    );
    Keep.later();
  }

  function cursor() {
    const { line, ch } = editor.line(editor.cursor());
    Dom.tell(Dom.get("cursor"), `${line + 1}:${ch + 1}`);
    Dom.tell(Dom.get("ends"), Source.ends());
  }

  /** @param {boolean} isAway @param {string} why */
  function away(isAway, why) {
    const download = { text: "Download the text", press: () => Saving.download(), test: "download" };
    if (isAway)
      Notices.show("away", `${why} Your text is kept here. It is tried again every two seconds.`, [download], true);
    else {
      Notices.close("away");
      Notices.close("save");
      Notices.say("The server answers again.");
      draw();
    }
  }

  /** The document that is seen has ended: its process was killed, or gave its place to newer ones. */
  function over() {
    const again = { text: "Show the text as it is now", press: () => void Documents.open("show", null), test: "again" };
    Notices.show("document", "The document that is shown has ended: what is not known of it yet cannot be asked.", [again]);
  }

  // What can be done.

  async function format() {
    const before = editor.text();
    const answer = await Server.ask("text.format", { text: Source.outer(before) });
    if (editor.text() !== before) return;
    if ("result" in answer) {
      const cursorAt = editor.cursor();
      const after = Source.inner(answer.result.text);
      const at = sameLetter(before, cursorAt, after);
      editor.replace(after);
      editor.go(at, at);
      Notices.close("format");
      Notices.say(after === before ? "The text was formatted already." : "Formatted.");
      return;
    }
    const { message, data: more } = answer.error;
    if (more && more.diagnostics) Problems.set("typed", more.diagnostics);
    Notices.show("format", `The text cannot be formatted: ${Dom.clip(message, 400)}.`);
  }

  /**
   * The place after as many letters as are before a place, spaces not counted.
   * @param {string} before @param {number} place @param {string} after
   */
  function sameLetter(before, place, after) {
    let letters = before.slice(0, place).replace(/\s+/g, "").length;
    let at = 0;
    while (at < after.length && letters > 0) {
      if (!/\s/.test(after[at])) letters -= 1;
      at += 1;
    }
    return at;
  }

  /** @returns {{id: string, keys: string, title: string, run: () => void}[]} */
  function commands() {
    const file = data.path === null ? "Download the text: there is no file to save to" : "Save";
    if (data.path === null) Dom.get("save").textContent = "Download";
    return [
      { id: "save", keys: "Ctrl-S", title: file, run: () => Saving.save() },
      { id: "format", keys: "Alt-Shift-F", title: "Format the text", run: format },
      { id: "show", keys: "Alt-Enter", title: "Show the model, without checks", run: () => Documents.open("show", null) },
      { id: "check", keys: "Ctrl-Enter", title: "Check the model, and show it", run: () => Documents.open("check", Commands.chosen()) },
      { id: "stop", keys: "Alt-.", title: "Stop, with what is known so far", run: () => Documents.stop() },
      { id: "", keys: "F8", title: "Next problem", run: () => Problems.next(1) },
      { id: "", keys: "Shift-F8", title: "Problem before", run: () => Problems.next(-1) },
      { id: "", keys: "Ctrl-Space", title: "What can be written here?", run: () => Complete.here() },
      { id: "", keys: "Alt-H", title: "What is this name?", run: () => Hover.here() },
      { id: "", keys: "F12", title: "Where is this name declared?", run: () => Hover.declaration() },
      { id: "", keys: "F6", title: "From the text to the view, and back", run: across },
      { id: "", keys: "F1", title: "Keys", run: () => Dom.get("help").click() },
    ];
  }

  /** From the text to the view, and back. */
  function across() {
    const frame = document.querySelector("iframe.frame:not(.coming)");
    const there = document.activeElement === frame;
    side(there ? "text" : "view");
    if (there || !(frame instanceof HTMLIFrameElement)) editor.focus();
    else frame.focus();
  }

  // Parts of the page.

  function parts() {
    Splitters.make(Dom.get("splitter"), Dom.get("desk"), {
      property: "--text-part",
      across: true,
      least: 20,
      most: 80,
      first: 42,
    });
    Splitters.make(Dom.get("below-splitter"), Dom.get("text-side"), {
      property: "--editor-part",
      across: false,
      least: 25,
      most: 90,
      first: 72,
    });
    for (const name of ["text", "view"]) Dom.get(`to-${name}`).addEventListener("click", () => side(name));
    side("text");
  }

  /**
   * Where there is room for one alone: the text, or the view.
   * @param {string} name
   */
  function side(name) {
    document.body.setAttribute("data-side", name);
    for (const one of ["text", "view"]) Dom.get(`to-${one}`).setAttribute("aria-pressed", String(one === name));
    editor.refresh();
  }

  /** @param {{automatic: boolean} | null} before */
  function switches(before) {
    const box = /** @type {HTMLInputElement} */ (Dom.get("automatic"));
    box.checked = automatic = !(before && before.automatic === false);
    box.addEventListener("change", () => {
      automatic = box.checked;
      if (automatic && Diagnose.fresh()) sound(!Problems.errors());
      Keep.later();
    });
  }

  /** @param {number} from @param {number} to */
  function visit(from, to) {
    side("text");
    editor.go(from, to);
  }

  function probe() {
    return {
      version: 1,
      text: outer,
      set: (/** @type {string} */ text) => editor.replace(Source.inner(text)),
      cursor: () => editor.cursor(),
      go: (/** @type {number} */ index) => editor.go(index, index),
      diagnostics: () =>
        Problems.all().map(({ diagnostic, from, to, here }) => ({
          ...diagnostic,
          text: here ? editor.text().slice(from, to) : null,
        })),
      verdicts: () => Verdicts.all(),
      document: () => {
        const shown = Documents.shown();
        return shown && shown.id;
      },
      state: () => ({
        unsaved: Saving.unsaved(),
        saved: Saving.version(),
        working: Documents.working(),
        read: Diagnose.fresh(),
        away: Server.away(),
        older: !Dom.get("older").hidden,
        place: { line: editor.line(editor.cursor()).line, ch: editor.line(editor.cursor()).ch },
      }),
    };
  }

  return {
    start,
    visit,
    kept,
    automatic: () => automatic,
    focus: () => editor.focus(),
    file: () => data.path,
  };
})();

Desk.start();
