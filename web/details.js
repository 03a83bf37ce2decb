"use strict";

/** The bodies, to choose from, and all that is known of the one that is selected, exactly. */
const Details = (() => {
  /** @type {Player} */
  let player;
  /** @type {List} */
  let list;
  /** @type {HTMLElement} */
  let facts;
  /** @type {Chosen | null} */
  let selected = null;
  /** @type {((selection: Chosen | null) => void)[]} */
  const listeners = [];
  let last = 0;

  /** @param {Player} of */
  function start(of) {
    player = of;
    const box = Dom.get("details");
    const holder = Dom.make("div", { class: "bodies" });
    facts = Dom.make("div", { class: "facts-box", test: "selected", "aria-live": "off" });
    box.append(holder, facts);
    list = new List(holder, {
      label: "Bodies",
      height: 30,
      row,
      choose: (leaf) => select({ leaf }),
      test: "bodies-list",
      empty: "There are no bodies.",
    });
    list.show(player.course.leaves.length, -1);
    list.box.style.height = `${30 * Math.min(player.course.leaves.length, 30) + 2}px`;
    player.on("move", () => {
      // Exact numbers are made anew while the run is played, but not for each frame.
      const now = performance.now();
      if (!player.playing || now - last > 200) show(now);
    });
    document.addEventListener("tab", () => {
      list.draw();
      show(0);
    });
    show(0);
  }

  /** @param {number} leaf @param {HTMLElement} element */
  function row(leaf, element) {
    const of = player.course.leaves[leaf];
    element.append(
      Channels.body(leaf),
      Dom.name(Dom.clip(of.name, 300), "name clipped"),
      Dom.make("span", { class: "row-side quiet" }, [
        Dom.make("bdi", { class: "clipped", text: Dom.clip(of.template, 80) }),
        of.fixed ? "\u00a0· fixed" : "",
      ]),
    );
  }

  /**
   * Calls a listener whenever something else is selected.
   * @param {(selection: Chosen | null) => void} listener
   */
  function onSelect(listener) {
    listeners.push(listener);
  }

  /** @param {Chosen | null} selection */
  function select(selection) {
    selected = selection;
    list.mark(selection ? selection.leaf : -1);
    show(0);
    for (const listener of listeners) listener(selection);
  }

  /** What is selected. */
  function selection() {
    return selected;
  }

  /**
   * The body of a leaf now, and its entry there.
   * @param {number} leaf
   */
  function body(leaf) {
    for (const body of player.course.bodiesAfter(player.legs, player.time)) {
      const place = body.process.leaves.find((/** @type {DataPlace} */ one) => one.leaf === leaf);
      if (place) return { body, place };
    }
    return null;
  }

  /** @param {number} now */
  function show(now) {
    if (Tabs.shown() !== "details") return;
    last = now;
    if (selected === null) {
      Dom.fill(
        facts,
        Dom.make("p", { class: "empty", text: "Point at a body in the scene, or choose one above." }),
      );
      return;
    }
    const leaf = player.course.leaves[selected.leaf];
    const found = body(selected.leaf);
    const name = Dom.make("h3", {}, [Dom.make("bdi", { text: Dom.clip(leaf.name, 12000) })]);
    if (!found) {
      const last = player.course.last(selected.leaf, player.legs);
      Dom.fill(facts, name, Dom.make("p", { class: "empty", text: "This body is not there now." }),
        last === null ? null : Dom.make("dl", { class: "facts" }, [
          ...line("gone since", Exactly.show(last.body.time)), ...vector("last position", player.course.position(last.body, last.place))]));
      return;
    }
    const { process } = found.body, of = selected.leaf;
    const behaviour = player.data.behaviours[found.place.behaviour];
    Dom.fill(
      facts,
      name,
      feature(leaf),
      Dom.make("dl", { class: "facts" }, [
        ...line("at time", Exactly.show(player.time)),
        ...vector("position", player.course.position(found.body, found.place)),
        ...(leaf.fixed
          ? line("velocity", Dom.make("span", { text: "fixed" }))
          : vector("velocity", process.velocity.map(Rational.of))),
        ...(process.turn ? vector("spin", process.turn.spin.map(Rational.of)) : []),
        ...line(
          "behaviour",
          Dom.make("span", {}, [
            Dom.make("bdi", { class: "code", text: Dom.clip(behaviour.text, 12000), test: "behaviour" }),
            player.between ? Dom.make("span", { class: "quiet", text: " as at the last event" }) : null,
          ]),
        ),
        ...line("offers", offers(leaf, behaviour)),
        ...line("bonds", bonds(process, selected.leaf)),
        ...(process.leaves.length < 2 ? [] : line("one with", others(process, selected.leaf))),
        ...line(
          "mass",
          leaf.mass === null
            ? Dom.make("span", { text: "without bound" })
            : Exactly.show(Rational.of(leaf.mass)),
        ),
        ...line("template", Dom.make("bdi", { text: Dom.clip(leaf.template, 400) })),
      ]),
      Dom.make("p", { class: "facts-buttons" }, [
        Dom.button("Its events", () => Events.of(of), { class: "small", test: "its-events" }),
        Dom.button("Clear", () => select(null), { class: "small" }),
      ]),
    );
  }

  /** @param {string} name @param {Node | null} value @returns {Node[]} */
  function line(name, value) {
    return value === null
      ? []
      : [Dom.make("dt", { text: name }), Dom.make("dd", { test: `fact-${name}` }, [value])];
  }

  /** @param {string} name @param {Rational[]} v */
  function vector(name, v) {
    return line(
      name,
      Dom.make(
        "span",
        { class: "vector" },
        v.map((x, i) =>
          Dom.make("span", { class: "component" }, [
            Dom.make("span", { class: "axis", text: "xyz"[i] }),
            Exactly.show(x),
          ]),
        ),
      ),
    );
  }

  /**
   * The feature that is selected, by its name.
   * @param {DataLeaf} leaf
   */
  function feature(leaf) {
    if (!selected || typeof selected.part !== "number") return null;
    return Dom.make("p", { class: "feature", test: "feature" }, [
      Dom.make("bdi", {
        text: site(leaf, [selected.part, selected.kind || "face", selected.index || 0], selected.kind),
      }),
    ]);
  }

  /**
   * The name of a feature.
   * @param {DataLeaf} leaf @param {DataSite} at @param {SiteKind | null} [kind]
   */
  function site(leaf, at, kind) {
    const part = leaf.parts[at[0]];
    if (!part) return "";
    if (kind === null) return part.name;
    const solid = player.data.solids[part.solid];
    const name =
      at[1] === "face"
        ? solid.faces[at[2]] && solid.faces[at[2]].name
        : at[1] === "edge"
          ? solid.edges[at[2]] && solid.edges[at[2]].name
          : solid.corners[at[2]];
    const words = { face: "face", edge: "edge", vertex: "corner" };
    return kind ? `${words[at[1]]} ${name} of ${part.name}` : `${part.name}.${name}`;
  }

  /** @param {DataLeaf} leaf @param {DataBehaviour} behaviour */
  function offers(leaf, behaviour) {
    if (behaviour.open.length === 0) return Dom.make("span", { class: "quiet", text: "nothing now" });
    return Dom.make(
      "ul",
      { class: "plain" },
      behaviour.open.slice(0, 100).map((open) =>
        Dom.make("li", {}, [
          Channels.patch(open.channel, open.co),
          Dom.make("bdi", { class: "channel", text: (open.co ? "~" : "") + open.channel }),
          " on ",
          Dom.make("bdi", { text: Dom.clip(open.sites.map((at) => site(leaf, at)).join(", "), 1000) }),
        ]),
      ),
    );
  }

  /** @param {DataProcess} process @param {number} leaf */
  function bonds(process, leaf) {
    const held = process.bonds.filter((bond) => bond.ends.some((end) => end.leaf === leaf));
    if (held.length === 0) return null;
    return Dom.make(
      "ul",
      { class: "plain" },
      held
        .slice(0, 100)
        .map((bond) =>
          Dom.make("li", {}, [
            Channels.patch(bond.name, false),
            Dom.make("bdi", { class: "channel", text: bond.name }),
            ": ",
            Dom.make("bdi", { text: bond.ends.map((end) => end.text).join(" and ") }),
          ]),
        ),
    );
  }

  /** @param {DataProcess} process @param {number} leaf */
  function others(process, leaf) {
    const rest = process.leaves.filter((place) => place.leaf !== leaf);
    return Dom.make(
      "span",
      {},
      rest
        .slice(0, 40)
        .flatMap((place, i) => [
          i === 0 ? "" : ", ",
          Dom.button(Dom.clip(player.course.leaves[place.leaf].name, 80), () => select({ leaf: place.leaf }), {
            class: "link",
          }),
        ])
        .concat(rest.length > 40 ? ` and ${rest.length - 40} more` : ""),
    );
  }

  return { start, select, selection, onSelect };
})();
