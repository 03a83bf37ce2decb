"use strict";

/** What can be done: buttons, and keys that work wherever one is on the page. */
const Commands = (() => {
  /** @typedef {{id: string, keys: string, title: string, run: () => void}} Command */
  /** @type {Command[]} */
  let all = [];
  /** @type {HTMLSelectElement} */
  let choice;
  const anyCheck = "";
  const mac = /Mac|iPhone|iPad/.test(navigator.platform);

  /** @param {Command[]} commands `id` is that of a button, or "" */
  function start(commands) {
    all = commands;
    choice = /** @type {HTMLSelectElement} */ (Dom.get("which"));
    for (const one of all) {
      if (one.id === "") continue;
      const button = Dom.get(one.id);
      button.title = `${one.title} (${shown(one.keys)})`;
      button.setAttribute("aria-keyshortcuts", one.keys.replace("Ctrl", "Control").replace(/-/g, "+"));
      button.addEventListener("click", () => one.run());
    }
    document.addEventListener("keydown", key, true);
    checks([]);
    help();
  }

  /** @param {string} keys */
  const shown = (keys) => (mac ? keys.replace("Ctrl", "⌘") : keys);

  /**
   * As they are written in the table: modifiers, then the key.
   * @param {KeyboardEvent} event
   */
  function pressed(event) {
    // With Alt, some systems make another character of the key.
    const letter = event.code === "Space" ? "Space" : /^Key[A-Z]$/.test(event.code) && event.altKey ? event.code.slice(3) : event.key;
    const name = letter.length === 1 ? letter.toUpperCase() : letter;
    const dot = event.code === "Period" && event.altKey ? "." : name;
    return `${event.ctrlKey || event.metaKey ? "Ctrl-" : ""}${event.altKey ? "Alt-" : ""}${event.shiftKey ? "Shift-" : ""}${dot}`;
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
    const name = pressed(event);
    const found = all.find((one) => one.keys === name);
    if (!found) return;
    event.preventDefault();
    event.stopPropagation();
    const button = found.id === "" ? null : Dom.get(found.id);
    if (!(button instanceof HTMLButtonElement && button.disabled)) found.run();
  }

  /**
   * The checks that can be chosen; the one that was, stays.
   * @param {string[]} names
   */
  function checks(names) {
    const before = choice.value;
    const unique = [...new Set(names)];
    choice.replaceChildren(
      Dom.make("option", { value: anyCheck, text: "all checks" }),
      ...unique.map((name) => Dom.make("option", { value: name, text: Dom.clip(name, 60) })),
    );
    choice.value = unique.includes(before) ? before : anyCheck;
  }

  const chosen = () => (choice.value === anyCheck ? null : choice.value);

  function help() {
    const dialog = /** @type {HTMLDialogElement} */ (Dom.get("keys"));
    const more = [
      ["Ctrl-F", "find; Ctrl-Shift-R replaces"],
      ["Ctrl-/", "comment lines, or not"],
      ["Ctrl-U", "back to where the cursor was"],
      ["Esc Tab", "leave the text for what comes next"],
    ];
    const rows = [...all.map((one) => [one.keys, one.title]), ...more];
    Dom.fill(
      dialog,
      Dom.make("h2", { id: "keys-head", text: "Keys" }),
      Dom.make(
        "dl",
        { class: "keys" },
        rows.flatMap(([keys, title]) => [
          Dom.make(
            "dt",
            {},
            keys.split(" ").map((one) => Dom.make("kbd", { text: shown(one) })),
          ),
          Dom.make("dd", { text: title.charAt(0).toLowerCase() + title.slice(1) }),
        ]),
      ),
      Dom.make("p", {
        class: "quiet",
        text: "The mouse resting on a name tells what it is; Ctrl and a press lead to its declaration. The view has keys of its own: ? tells them there.",
      }),
      Dom.make("p", {}, [Dom.button("Close", () => dialog.close(), { test: "keys-close" })]),
    );
    dialog.addEventListener("click", (event) => {
      if (event.target === dialog) dialog.close();
    });
    Dom.get("help").addEventListener("click", () => dialog.showModal());
  }

  return { start, key, checks, chosen };
})();
