"use strict";

/** @typedef {{name: string, kind: string, form: string | null}} Offer */

/**
 * A list, below the cursor, of what can be written there, as the server finds it. It is asked for by a key, and follows what is typed until something
 * is chosen, or nothing fits any more.
 */
const Complete = (() => {
  const most = 200;
  /** @type {Writing} */
  let editor;
  /** @type {HTMLElement} */
  let list;
  /** @type {Offer[]} */
  let offered = [];
  let from = 0;
  let chosen = 0;
  /** Whether what is chosen is being written. */
  let writing = false;
  /** Of the questions to the server: an answer to an earlier one is not shown. */
  let questions = 0;

  /** @param {Writing} of */
  function start(of) {
    editor = of;
    list = Dom.make("div", { id: "offers", role: "listbox", "aria-label": "What can be written here", hidden: true, test: "offers" });
    document.body.append(list);
    editor.on("change", () => !writing && !list.hidden && show(false));
    editor.on("cursor", () => {
      if (!writing && !list.hidden && (editor.cursor() < from || /\W/.test(editor.text().slice(from, editor.cursor())))) close();
    });
    document.addEventListener("keydown", key, true);
    document.addEventListener("mousedown", (event) => !list.contains(/** @type {Node} */ (event.target)) && close(), true);
    document.addEventListener("scroll", (event) => event.target !== list && follow(), true);
    window.addEventListener("resize", close);
  }

  function close() {
    questions += 1;
    list.hidden = true;
  }

  /** At the cursor, by a key. Where one word alone fits that has begun, it is written. */
  function here() {
    show(true);
  }

  /** @param {boolean} asked */
  async function show(asked) {
    questions += 1;
    const mine = questions, text = editor.text(), at = editor.cursor();
    const answer = await Server.ask("text.complete", { text: Source.outer(text), offset: Source.offset(text, at) });
    if (mine !== questions || editor.text() !== text || editor.cursor() !== at) return;
    const found = "result" in answer ? answer.result : { from: Source.offset(text, at), offers: [] };
    from = Source.places(text, [found.from])[0];
    const place = editor.place(from);
    const done = found.offers.length === 1 && found.offers[0].name.length === at - from;
    if (found.offers.length === 0 || !place || (done && !asked)) {
      close();
      if (asked) Notices.say("Nothing is known that fits here.");
      return;
    }
    offered = found.offers.slice(0, most);
    chosen = 0;
    if (asked && offered.length === 1 && at > from) return take(0);
    Hover.close();
    Dom.fill(list, ...offered.map(row));
    list.hidden = false;
    put(place);
    mark();
  }

  /** @param {Offer} offer @param {number} k */
  function row(offer, k) {
    return Dom.make("div", { class: "offer", role: "option", mousedown: (/** @type {Event} */ event) => { event.preventDefault(); take(k); } }, [
      Dom.make("bdi", { class: "offer-name", text: Dom.clip(offer.name, 80) }),
      Dom.make("span", { class: "quiet", text: offer.form || offer.kind }),
    ]);
  }

  /**
   * Below the place, or above it where there is no room.
   * @param {{left: number, bottom: number, top: number}} place
   */
  function put({ left, bottom, top }) {
    list.style.left = list.style.top = "0";
    const { width, height } = list.getBoundingClientRect();
    list.style.left = `${Math.max(6, Math.min(left, window.innerWidth - width - 6))}px`;
    list.style.top = `${bottom + 2 + height <= window.innerHeight ? bottom + 2 : Math.max(4, top - height - 2)}px`;
  }

  function mark() {
    [...list.children].forEach((one, k) => one.setAttribute("aria-selected", String(k === chosen)));
    const one = list.children[chosen];
    if (one) one.scrollIntoView({ block: "nearest" });
    Notices.say(`${offered[chosen].name}, ${offered[chosen].kind}, ${chosen + 1} of ${offered.length}`);
  }

  /** What is written may move the text. */
  function follow() {
    const place = list.hidden ? null : editor.place(from);
    if (place) put(place);
  }

  /** @param {number} k */
  function take(k) {
    const text = editor.text(), at = editor.cursor(), { name } = offered[k];
    close();
    writing = true;
    editor.replace(text.slice(0, from) + name + text.slice(at));
    editor.go(from + name.length, from + name.length);
    writing = false;
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (list.hidden || event.ctrlKey || event.metaKey || event.altKey) return;
    const by = /** @type {{[key: string]: number}} */ ({ ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 })[event.key];
    if (by !== undefined) {
      const next = chosen + by, n = offered.length;
      chosen = Math.abs(by) === 1 ? (next + n) % n : Math.max(0, Math.min(n - 1, next));
      mark();
    } else if (event.key === "Enter" || event.key === "Tab") take(chosen);
    else if (event.key === "Escape") close();
    else return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  return { start, here };
})();
