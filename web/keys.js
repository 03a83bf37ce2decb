"use strict";

/** What the keyboard does wherever one is on the page, and the help that tells it. */
const Keys = (() => {
  /** @type {[string, string][]} */
  const help = [
    ["space", "play, pause"],
    ["← →", "one event back, on"],
    ["Home End", "to the beginning, to the end"],
    [", .", "a little back, on in time"],
    ["+ −", "faster, slower"],
    ["[ ]", "previous, next run"],
    ["k j", "compare, switch between the runs; to where they part"],
    ["x", "choices: arrows and Enter take one"],
    ["e", "list of events"],
    ["b", "list of bodies"],
    ["g", "state graph"],
    ["p", "plots"],
    ["f", "see all bodies"],
    ["n v r m", "names, velocities, trails, marks"],
    ["o u", "projection, which axis points up"],
    ["t", "dark, light"],
    ["c", "copy a link to what is shown"],
    ["i", "save a picture or a film of it"],
    ["Esc", "nothing selected"],
    ["?", "this help"],
  ];
  /** @type {Player} */
  let player;
  /** @type {HTMLDialogElement} */
  let dialog;

  /** @param {Player} of */
  function start(of) {
    player = of;
    dialog = /** @type {HTMLDialogElement} */ (Dom.get("keys"));
    Dom.fill(
      dialog,
      Dom.make("h2", { id: "keys-head", text: "Keys" }),
      Dom.make(
        "dl",
        { class: "keys" },
        help.flatMap(([keys, text]) => [
          Dom.make(
            "dt",
            {},
            keys.split(" ").map((key) => Dom.make("kbd", { text: key })),
          ),
          Dom.make("dd", { text }),
        ]),
      ),
      Dom.make("p", {
        class: "quiet",
        text:
          "In the scene: drag to turn, drag with the right button or two fingers to move, " +
          "wheel or pinch to go nearer; a press selects what is there. " +
          "On the line of time: the wheel shows more or less of it.",
      }),
      about(),
      Dom.make("p", {}, [Dom.button("Close", () => dialog.close(), { test: "keys-close" })]),
    );
    dialog.addEventListener("click", (event) => {
      if (event.target === dialog) dialog.close();
    });
    Dom.get("help").addEventListener("click", open);
    document.addEventListener("keydown", key);
    release();
  }

  /** From its top: what has the focus is at its end. */
  function open() {
    dialog.showModal();
    dialog.scrollTop = 0;
  }

  /** Keys go on working on the page after one has chosen from a list by the pointer, or pressed Escape in a field. */
  function release() {
    let pointed = false;
    document.addEventListener("pointerdown", (event) => {
      pointed = event.target instanceof HTMLSelectElement;
    }, true);
    document.addEventListener("keydown", (event) => {
      if (event.target instanceof HTMLSelectElement && event.key !== "Enter") pointed = false;
      const field = event.target instanceof HTMLSelectElement || event.target instanceof HTMLInputElement;
      if (event.key === "Escape" && field && !document.querySelector("dialog[open]")) /** @type {HTMLElement} */ (event.target).blur();
    });
    document.addEventListener("change", (event) => {
      if (pointed && event.target instanceof HTMLSelectElement && !document.querySelector("dialog[open]")) event.target.blur();
    });
  }

  function about() {
    const { data } = player;
    return Dom.make("p", { class: "quiet" }, [
      "Made by scc, semantics ",
      Dom.make("bdi", { text: data.semantics }),
      ", of the model ",
      Dom.make("bdi", { text: Dom.clip(data.model || data.name, 200) }),
      " (",
      Dom.make("bdi", {
        class: "exact",
        text: data.digest,
      }),
      ").",
    ]);
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]")) return;
    const at = /** @type {HTMLElement} */ (event.target);
    if (
      /^(INPUT|TEXTAREA|SELECT)$/.test(at.tagName) &&
      /** @type {HTMLInputElement} */ (at).type !== "checkbox"
    )
      return;
    // Space and Enter press the button that has the focus.
    const pressed = /^(BUTTON|SUMMARY|INPUT|A)$/.test(at.tagName);
    if (pressed && (event.key === " " || event.key === "Enter")) return;
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  /** @param {string} id */
  const press = (id) => () => Dom.get(id).click();

  /** @param {number} part of what is seen of time */
  function nudge(part) {
    player.pause();
    const by = (Timeline.range.to - Timeline.range.from) * part;
    const to = player.clock + by;
    player.seek(to >= player.end ? player.course.duration : Exactly.grid(Math.max(0, to)));
  }

  /** @type {{[key: string]: () => void}} */
  const actions = {
    " ": () => player.toggle(),
    ArrowRight: () => player.next(),
    ArrowLeft: () => player.previous(),
    Home: () => player.first(),
    End: () => player.finish(),
    ",": () => nudge(-0.01),
    ".": () => nudge(0.01),
    "+": () => player.hasten(player.speed * 2),
    "=": () => player.hasten(player.speed * 2),
    "-": () => player.hasten(player.speed / 2),
    "[": () => Runs.step(-1),
    "]": () => Runs.step(1),
    k: () => Compare.change(),
    j: () => Compare.difference(),
    x: () => Choices.focus(),
    e: () => focus("events-list"),
    b: () => {
      Tabs.show("details");
      focus("bodies-list");
    },
    g: press("graph-switch"),
    p: press("plots-switch"),
    t: press("theme"),
    c: press("cite"),
    i: () => Export.open(),
    f: () => Tools.flip("fit"),
    n: () => Tools.flip("names"),
    v: () => Tools.flip("velocities"),
    r: () => Tools.flip("trails"),
    m: () => Tools.flip("marks"),
    o: () => Tools.flip("projection"),
    u: () => Tools.flip("up"),
    Escape: () => Details.select(null),
    "?": open,
  };

  /** @param {string} test */
  function focus(test) {
    const found = document.querySelector(`[data-testid="${test}"]`);
    if (found instanceof HTMLElement) found.focus();
  }

  return { start };
})();
