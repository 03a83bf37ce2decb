"use strict";

/** What the page tells above all else, each by its own name, until it is over or closed. */
const Notices = (() => {
  /** @type {Map<string, HTMLElement>} */
  const shown = new Map();

  /**
   * @param {string} name @param {string} text
   * @param {{text: string, press: () => void, test?: string}[]} [choices] a press of one closes the notice
   * @param {boolean} [stays] it cannot be closed
   */
  function show(name, text, choices, stays) {
    close(name);
    const buttons = (choices || []).map((one) =>
      Dom.button(
        one.text,
        () => {
          if (!stays) close(name);
          one.press();
        },
        { class: "small", test: one.test },
      ),
    );
    if (!stays)
      buttons.push(
        Dom.button("✕", () => close(name), { class: "small bare", title: "Close", "aria-label": "Close" }),
      );
    const box = Dom.make("div", { class: "notice", test: `notice-${name}` }, [
      Dom.make("span", { class: "notice-text", text }),
      ...buttons,
    ]);
    shown.set(name, box);
    Dom.get("notices").append(box);
  }

  /** @param {string} name */
  function close(name) {
    const box = shown.get(name);
    if (!box) return;
    const had = box.contains(document.activeElement);
    box.remove();
    shown.delete(name);
    if (had) Desk.focus();
  }

  /**
   * A word for screen readers, and for who looks at the line below the text.
   * @param {string} text
   */
  function say(text) {
    Dom.tell(Dom.get("said"), text);
  }

  return { show, close, say };
})();
