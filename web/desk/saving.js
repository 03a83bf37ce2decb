"use strict";

/** The file: what of the text is saved, and what is done when somebody else has changed it meanwhile. */
const Saving = (() => {
  /** @type {Writing} */
  let editor;
  /** @type {{name: string, path: string | null}} */
  let file;
  /** @type {string | null} the version of the file that the text came from */
  let saved = null;
  let clean = -1;
  let busy = false;
  /** @type {() => void} */
  let changed = () => {};

  /**
   * @param {Writing} of @param {{name: string, path: string | null}} which @param {string | null} digest
   * @param {() => void} hear
   */
  function start(of, which, digest, hear) {
    editor = of;
    file = which;
    saved = digest;
    changed = hear;
    clean = editor.generation();
    window.addEventListener("beforeunload", (event) => {
      if (!unsaved()) return;
      event.preventDefault();
      event.returnValue = "";
    });
  }

  const unsaved = () => !editor.unchanged(clean);

  function download() {
    Dom.save(file.name, "text/plain;charset=utf-8", Source.outer(editor.text()));
  }

  async function save() {
    if (busy) return;
    if (file.path === null) {
      download();
      clean = editor.generation();
      Notices.say("Downloaded.");
      return changed();
    }
    await write(saved);
  }

  /** @param {string | null} over the version that may be written over */
  async function write(over) {
    busy = true;
    const generation = editor.generation();
    const text = Source.outer(editor.text());
    try {
      const { status, body } = await Server.attempt("save", { text, saved: over });
      if (status === 200) done(generation, body.saved, "Saved.");
      else if (status === 409 && body.saved !== "" && body.text === text) done(generation, body.saved, "Saved.");
      else if (status === 409) conflict(body);
      else Notices.show("save", `Not saved: ${body.error}.`);
    } catch (error) {
      if (!(error instanceof Server.Away)) throw error;
      Notices.show("save", "Not saved: the server does not answer. The text is kept in this tab.");
    } finally {
      busy = false;
      changed();
    }
  }

  /** @param {number} generation @param {string} digest @param {string} word */
  function done(generation, digest, word) {
    saved = digest;
    clean = generation;
    for (const name of ["save", "kept", "unreadable"]) Notices.close(name);
    Notices.say(word);
  }

  /** @param {{text: string, saved: string}} there */
  function conflict(there) {
    const gone = there.saved === "";
    const dialog = /** @type {HTMLDialogElement} */ (Dom.get("conflict"));
    const close = (/** @type {() => void} */ then) => () => {
      dialog.close();
      then();
      editor.focus();
      changed();
    };
    Dom.fill(
      dialog,
      Dom.make("h2", {
        id: "conflict-head",
        text: gone ? "The file is not there any more" : "The file has been changed by somebody else",
      }),
      Dom.make("p", {
        text: gone
          ? "It has been removed or renamed since it was read."
          : "What is on disk is not what this text came from. Nothing has been written.",
      }),
      Dom.make("div", { class: "choices" }, [
        Dom.button(gone ? "Write it anew" : "Write over it", close(() => write(gone ? null : there.saved)), {
          test: "conflict-overwrite",
        }),
        gone
          ? null
          : Dom.button("Take what is in the file", close(() => take(there)), {
            test: "conflict-take",
            title: "Undo brings your text back",
          }),
        Dom.button("Go on writing", close(() => {}), { class: "primary", test: "conflict-on", autofocus: true }),
      ]),
      gone ? null : Dom.make("p", { class: "quiet", text: "After taking what is in the file, undo (Ctrl-Z) brings your text back." }),
    );
    dialog.showModal();
  }

  /** @param {{text: string, saved: string}} there */
  function take(there) {
    editor.replace(Source.read(there.text));
    saved = there.saved;
    clean = editor.generation();
    Notices.say("This is what is in the file.");
  }

  /** @param {string | null} digest of the version that the text came from */
  function base(digest) {
    saved = digest;
  }

  return { start, save, download, take, base, unsaved, version: () => saved };
})();
