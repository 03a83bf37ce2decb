"use strict";

/** What a name of the text is: told where the mouse rests, or at the cursor by a key; and the way to its declaration. */
const Hover = (() => {
  const rest = 350;
  /** @type {Writing} */
  let editor;
  /** @type {HTMLElement} */
  let tip;
  let timer = 0;
  /** The question that is answered last is the newest. */
  let asked = 0;
  let offered = true;

  /** @param {Writing} of */
  function start(of) {
    editor = of;
    tip = Dom.get("tip");
    let last = -1;
    editor.point((index, left, bottom, top) => {
      if (index === last) return;
      last = index === null ? -1 : index;
      window.clearTimeout(timer);
      asked += 1;
      if (index === null) return close();
      timer = window.setTimeout(() => show(index, left, bottom, top), rest);
    });
    editor.jump(declaration);
    editor.on("change", () => {
      // What is asked about the text before has no place in this one.
      window.clearTimeout(timer);
      asked += 1;
      close();
    });
    editor.on("cursor", close);
    document.addEventListener("scroll", close, true);
    document.addEventListener("keydown", (event) => event.key === "Escape" && close(), true);
  }

  function close() {
    tip.hidden = true;
  }

  /**
   * What stands there, or null; nothing where something else has been asked, or the text is another one.
   * @param {number} index
   */
  async function describe(index) {
    if (!offered) return null;
    asked += 1;
    const mine = asked;
    const text = editor.text();
    const answer = await Server.ask("text.describe", {
      text: Source.outer(text),
      offset: Source.offset(text, index),
    });
    if ("error" in answer) {
      if (answer.error.code === -32601) offered = false;
      return null;
    }
    return mine === asked ? answer.result.found : undefined;
  }

  /** @param {number} index @param {number} left @param {number} bottom @param {number} top */
  async function show(index, left, bottom, top) {
    const problems = Problems.at(index);
    const known = await describe(index);
    if (known === undefined) return;
    // Where there is an error, that nobody declares the name is told by it.
    const found = known && known.kind === "name" && problems.length > 0 ? null : known;
    if (!found && problems.length === 0) return close();
    Dom.fill(
      tip,
      ...problems.map(({ diagnostic: d }) =>
        Dom.make("div", { class: `tip-${d.severity}`, dir: "auto", text: Dom.clip(Problems.words(d), 1500) }),
      ),
      found ? about(found) : null,
    );
    tip.hidden = false;
    put(left, bottom, top);
  }

  /**
   * The first line says what it is; what follows is text of the model, or where it is explained.
   * @param {{text: string}} found
   */
  function about(found) {
    const [first, ...rest] = Dom.clip(found.text, 2000).split("\n");
    return Dom.make("div", {}, [
      Dom.make("div", { class: "tip-first", dir: "auto", text: first }),
      rest.length > 0 ? Dom.make("div", { class: "tip-rest", dir: "auto", text: rest.join("\n") }) : null,
    ]);
  }

  /** Below the place, or above it where there is no room. */
  function put(/** @type {number} */ left, /** @type {number} */ bottom, /** @type {number} */ top) {
    tip.style.left = "0";
    tip.style.top = "0";
    const { width, height } = tip.getBoundingClientRect();
    tip.style.left = `${Math.max(6, Math.min(left, window.innerWidth - width - 6))}px`;
    const below = bottom + 4 + height <= window.innerHeight;
    tip.style.top = `${below ? bottom + 4 : Math.max(4, top - height - 4)}px`;
  }

  /** At the cursor, by a key: a screen reader is told as well. */
  async function here() {
    const index = editor.cursor();
    const at = editor.place(index);
    if (!at) return;
    await show(index, at.left, at.bottom, at.top);
    Notices.say(tip.hidden ? "Nothing is known of what stands here." : tip.textContent || "");
  }

  /** @param {number} [from] */
  async function declaration(from) {
    const index = from === undefined ? editor.cursor() : from;
    const found = await describe(index);
    if (found === undefined) return;
    if (!found || !found.declared)
      return Notices.say(found ? "It has no declaration in this text." : "Nothing is known of what stands here.");
    const [start, stop] = Source.places(editor.text(), [found.declared.start, found.declared.stop]);
    Desk.visit(start, stop);
    Notices.say(`The declaration of ${Dom.clip(found.name, 80)}. Ctrl-U leads back.`);
  }

  return { start, here, declaration, close, open: () => !tip.hidden };
})();
