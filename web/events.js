"use strict";

/** The events of the run in words, the present one marked; and what is said of where one is. */
const Events = (() => {
  /** @type {Player} */
  let player;
  /** @type {List} */
  let list;
  let told = 0;
  let timer = 0;
  /**
   * The positions of the run that are listed.
   * @type {number[]}
   */
  let shown = [];
  /**
   * Which are listed: "" all but passings of time, "all", or those of one kind; those in which a body takes part; and those
   * whose words have this text.
   * @type {{ kind: string, text: string, exact: boolean, leaf: number | null }}
   */
  const wish = { kind: "", text: "", exact: false, leaf: null };
  /** Bodies up to which all can be chosen; of more, those that have events. */
  const many = 2000;
  /**
   * Positions that the user keeps in view, by runs.
   * @type {WeakMap<PlayedRun, Set<number>>}
   */
  const pins = new WeakMap();
  /** @type {{ kinds: HTMLSelectElement, bodies: HTMLSelectElement, found: HTMLElement, pins: HTMLElement }} */
  let made;

  /** @param {Player} of */
  function start(of) {
    player = of;
    tools(Dom.get("events"));
    list = new List(Dom.get("events"), {
      label: "Events of the run",
      height: 44,
      row: (index, element) => row(shown[index], element),
      name: (index) => shown[index],
      choose: (index) => go(shown[index]),
      empty: "No event of the run is so.",
      test: "events-list",
    });
    list.box.addEventListener("keydown", (event) => {
      if (event.key !== "p" || event.ctrlKey || event.altKey || event.metaKey) return;
      event.stopPropagation();
      pin(player.legs);
    });
    player.on("run", show);
    player.on("move", move);
    player.on("grow", now);
    show();
    move();
  }

  /** @param {number} legs */
  function go(legs) {
    player.pause();
    player.go(legs);
  }

  /** @param {HTMLElement} box */
  function tools(box) {
    const kinds = Dom.make("select", {
      "aria-label": "Which events", test: "events-kind",
      change: () => {
        wish.kind = kinds.value;
        show();
      },
    });
    const bodies = Dom.make("select", {
      "aria-label": "Events of which body", test: "events-body",
      change: () => of(bodies.value === "" ? null : Number(bodies.value)),
    });
    const text = Dom.make("input", {
      type: "search", placeholder: "Search", "aria-label": "Search in events", spellcheck: "false", autocomplete: "off", test: "events-search",
      input: () => {
        wish.text = text.value.trim().toLowerCase();
        show();
      },
      keydown: (/** @type {KeyboardEvent} */ event) => {
        if (event.key === "Enter") go(next());
      },
    });
    const exact = Dom.button("Exact", () => {
      wish.exact = !wish.exact;
      exact.setAttribute("aria-pressed", String(wish.exact));
      list.refresh();
    }, { title: "Times as exact fractions, in full", test: "events-exact", "aria-pressed": "false" });
    made = { kinds, bodies, found: Dom.make("span", { class: "quiet", role: "status", test: "events-found" }), pins: Dom.make("div", { class: "pins", test: "pins" }) };
    box.append(Dom.make("div", { class: "event-tools" }, [kinds, bodies, text, exact, made.found]), made.pins);
  }

  /**
   * Lists the events in which a body takes part, and selects it; or all of them.
   * @param {number | null} leaf
   */
  function of(leaf) {
    wish.leaf = leaf;
    if (leaf !== null) Details.select({ leaf });
    show();
  }

  /** The position of the next one that is listed, or of the first. */
  const next = () => shown.find((legs) => legs > player.legs) ?? shown[0] ?? player.legs;

  /** Which kinds of events there are to choose. */
  function choices() {
    const seen = new Set(player.run.steps.map((step) => player.data.labels[step.label].kind));
    const option = (/** @type {string} */ value, /** @type {string} */ text) => Dom.make("option", { value, text, selected: value === wish.kind });
    if (wish.kind !== "all" && !seen.has(wish.kind)) wish.kind = "";
    Dom.fill(made.kinds, option("", "Events"), option("all", "With time"), ...[...seen].sort().map((kind) => option(kind, Sketch.kinds[kind] || kind)));
    made.kinds.value = wish.kind;
    bodies();
  }

  /** @type {{ run: PlayedRun, steps: number } | null} of which the bodies are listed */
  let offered = null;

  /** Which bodies there are to choose: those that take part in events, and the others. */
  function bodies() {
    const { run, course, data } = player, { leaves } = course;
    if (wish.leaf !== null && !leaves[wish.leaf]) wish.leaf = null;
    if (offered === null || offered.run !== run || offered.steps !== run.steps.length) {
      const active = new Set(run.steps.flatMap((step) => data.labels[step.label].leaves || []));
      const group = (/** @type {string} */ label, /** @type {(leaf: number) => boolean} */ is) => {
        const all = [...leaves.keys()].filter(is).slice(0, many);
        return all.length === 0 ? null : Dom.make("optgroup", { label }, all.map((leaf) => Dom.make("option", { value: leaf, text: Dom.clip(leaves[leaf].name, 60) })));
      };
      Dom.fill(made.bodies, Dom.make("option", { value: "", text: "Any body" }), group("With events", (leaf) => active.has(leaf)),
        leaves.length > many ? null : group("Without events", (leaf) => !active.has(leaf)));
      offered = { run, steps: run.steps.length };
    }
    const value = wish.leaf === null ? "" : String(wish.leaf);
    if (value !== "" && ![...made.bodies.options].some((option) => option.value === value))
      made.bodies.append(Dom.make("option", { value, text: Dom.clip(leaves[Number(value)].name, 60) }));
    made.bodies.value = value;
  }

  /**
   * Whether a position of the run is listed.
   * @param {number} legs
   */
  function listed(legs) {
    const { kind, text, leaf } = wish, last = legs === player.course.legs.length;
    if (leaf !== null && (legs === 0 || !(label(legs).leaves || []).includes(leaf))) return false;
    if (legs === 0) return (kind === "" || kind === "all") && words(0).includes(text);
    const is = label(legs);
    if (kind === "" ? is.kind === "time" && !(last && text === "") : kind !== "all" && is.kind !== kind) return false;
    return text === "" || `${is.words} ${is.text} ${Exactly.text(player.instant(legs))}`.toLowerCase().includes(text);
  }

  function show() {
    choices();
    shown = [];
    for (let legs = 0; legs <= player.course.legs.length; legs++) if (listed(legs)) shown.push(legs);
    const name = wish.leaf === null ? "" : Dom.clip(player.course.leaves[wish.leaf].name, 60);
    const plain = wish.text === "" && wish.kind === "";
    list.nothing.textContent = name === "" ? "No event of the run is so."
      : plain ? `${name} takes part in no event of this run.` : `No such event of the run has ${name}.`;
    list.show(shown.length, place(player.legs));
    Dom.tell(made.found, wish.kind === "" && wish.text === "" && wish.leaf === null ? "" : `${shown.length} of ${player.course.legs.length + 1}`);
    pinned();
  }

  /**
   * The row of a position: of what is not listed, the one before it, or -1.
   * @param {number} legs
   */
  function place(legs) {
    let low = 0, high = shown.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (shown[middle] <= legs) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /** Those that are kept in view. */
  const kept = () => {
    let own = pins.get(player.run);
    if (!own) pins.set(player.run, (own = new Set()));
    return own;
  };

  /** @param {number} legs */
  function pin(legs) {
    const own = kept();
    if (!own.delete(legs)) own.add(legs);
    pinned();
    list.refresh();
  }

  function pinned() {
    made.pins.hidden = kept().size === 0;
    Dom.fill(made.pins, ...[...kept()].sort((a, b) => a - b).map((legs) => Dom.make("div", { class: `pin kind-${kind(legs)}` }, [
      Dom.make("span", { class: "dot", "aria-hidden": "true" }),
      Dom.button(Dom.clip(words(legs), 300), () => go(legs), { class: "link clipped", test: `pinned-${legs}` }),
      Dom.make("span", { class: "time", text: short(player.instant(legs)), title: Exactly.both(player.instant(legs)) }),
      unpin(legs),
    ])));
  }

  /** @param {number} legs of one that is pinned */
  const unpin = (legs) => Dom.button("×", () => pin(legs),
    { class: "link pin-button", "aria-label": "Unpin", title: "Unpin", test: `unpin-${legs}` });

  /** @param {number} legs */
  const kind = (legs) => (legs === 0 ? "start" : label(legs).kind);

  /**
   * The words of what led to a position of the run.
   * @param {number} legs
   */
  function words(legs) {
    if (legs === 0) return "the beginning";
    return label(legs).words || label(legs).text;
  }

  /** @param {number} legs @returns {DataLabel} */
  function label(legs) {
    return player.data.labels[player.run.steps[legs - 1].label];
  }

  /** @param {number} index @param {HTMLElement} element */
  function row(index, element) {
    const rules = index === 0 ? [] : player.run.steps[index - 1].rules;
    const time = player.instant(index), exact = Exactly.text(time);
    element.classList.add(`kind-${kind(index)}`);
    // Time has passed since the row before.
    const before = shown[place(index) - 1];
    element.classList.toggle("later", before !== undefined && Rational.cmp(player.instant(before), time) < 0);
    element.append(
      Dom.make("span", { class: "dot", "aria-hidden": "true" }),
      Dom.make("span", { class: "row-text" }, [Dom.name(Dom.clip(words(index), 600), "words clipped")]),
      Dom.make("span", { class: "row-side" }, [
        Dom.make("span", { class: wish.exact ? "time whole" : "time", text: wish.exact ? exact : short(time), title: Exactly.both(time) }),
        wish.exact && exact.length > 20 ? null : Dom.make("span", {}, [
          // No button, as a row is one choice of a list; by keys, p pins the present event.
          Dom.make("span", {
            class: "link pin-button", text: kept().has(index) ? "×" : "Pin", title: kept().has(index) ? "Unpin" : "Keep it in view (p)",
            "aria-hidden": "true", test: `pin-${index}`,
            click: (/** @type {Event} */ event) => {
              event.stopPropagation();
              pin(index);
            },
          }),
          rules.length === 0
            ? null
            : Dom.make("span", {
                class: "link",
                text: rules[0],
                click: (/** @type {Event} */ event) => {
                  event.stopPropagation();
                  player.go(index);
                  Rules.show(rules[0]);
                },
              }),
        ]),
      ]),
    );
  }

  /** @param {Rational} time */
  function short(time) {
    const exact = Exactly.text(time);
    return exact.length <= 10 ? exact : Exactly.told(time);
  }

  function move() {
    list.mark(place(player.legs));
    if (player.playing) {
      // While the run is played, an event is told at most every two seconds, and time as decimals.
      if (player.legs === told) return;
    }
    told = player.legs;
    now();
  }

  function now() {
    const legs = player.legs;
    const count = player.course.legs.length;
    const box = Dom.get("now");
    const after = player.between && !player.playing;
    const rules = legs === 0 ? [] : player.run.steps[legs - 1].rules;
    Dom.fill(
      box,
      Dom.make("p", { class: `now-words kind-${kind(legs)}` }, [
        Dom.make("span", { class: "dot", "aria-hidden": "true" }),
        Dom.make("bdi", { class: "words", text: words(legs), test: "now-words" }),
      ]),
      Dom.make("dl", { class: "facts" }, [
        Dom.make("dt", { text: "at time" }),
        Dom.make("dd", {}, [Exactly.show(player.instant(legs))]),
        after ? Dom.make("dt", { text: "now at" }) : null,
        after ? Dom.make("dd", {}, [Exactly.show(player.time)]) : null,
        Dom.make("dt", { text: "step" }),
        Dom.make("dd", { text: `${legs} of ${count}`, test: "now-step" }),
        rules.length === 0 ? null : Dom.make("dt", { text: rules.length === 1 ? "rule" : "rules" }),
        rules.length === 0
          ? null
          : Dom.make(
              "dd",
              {},
              rules.map((rule) => Rules.link(rule)),
            ),
      ]),
      player.playing ? null : Changes.show(player),
      ending(legs === count),
    );
    announce(`${words(legs)}. Step ${legs} of ${count}, time ${Exactly.both(player.time)}.`);
  }

  /**
   * What is said where the run ends.
   * @param {boolean} last
   */
  function ending(last) {
    const state = player.data.states[player.state];
    const said = state.stuck
      ? `Nothing can happen, and no time can pass: ${state.stuck}`
      : state.rests
        ? "Nothing will ever happen again."
        : last && player.run.way === null && typeof player.run.cycle === "number"
          ? `From here on the run repeats all from step ${player.run.cycle} on, for ever.`
          : null;
    return said === null ? null : Dom.make("p", { class: "quiet", text: said });
  }

  /** @param {string} text */
  function announce(text) {
    clearTimeout(timer);
    timer = window.setTimeout(
      () => Dom.tell(Dom.get("live"), Dom.clip(text, 500)),
      player.playing ? 1500 : 150,
    );
  }

  return { start, words, of };
})();
