"use strict";

/** The buttons of the page: playing, the scene, dark and light, which panels are seen. */
const Tools = (() => {
  /** @type {Player} */
  let player;
  /** @type {Scene | null} */
  let scene;
  /**
   * What the scene shows, by the names of its options.
   * @type {{[option: string]: any}}
   */
  const options = {
    names: false,
    velocities: false,
    spins: false,
    trails: false,
    marks: true,
    legend: true,
    grid: true,
    projection: "perspective",
    up: "y",
  };
  /**
   * Those that are shown or not, as they are at first.
   * @type {{[option: string]: boolean}}
   */
  const usual = Object.fromEntries(["names", "velocities", "spins", "trails", "marks", "legend", "grid"].map((name) => [name, options[name]]));
  /** @type {{[id: string]: HTMLButtonElement}} */
  const made = {};

  /** @param {Player} of @param {Scene | null} shown */
  function start(of, shown) {
    player = of;
    scene = shown;
    transport();
    if (scene) views();
    theme();
    switches();
  }

  /**
   * Drawings of buttons, within 16 × 16.
   * @type {{[icon: string]: string}}
   */
  const icons = {
    first: "M3 3v10M13 3L6 8l7 5z",
    previous: "M11.5 3L4.5 8l7 5z",
    play: "M5 3l8 5-8 5z",
    pause: "M5 3v10M11 3v10",
    next: "M4.5 3l7 5-7 5z",
    last: "M13 3v10M3 3l7 5-7 5z",
    narrow: "M2 8h4M4 6l2 2-2 2M14 8h-4M12 6l-2 2 2 2",
    wide: "M6 8H2M4 6L2 8l2 2M10 8h4M12 6l2 2-2 2",
  };

  /**
   * Draws a button.
   * @param {HTMLElement} button @param {string} icon
   */
  function picture(button, icon) {
    button.replaceChildren(
      Dom.draw("svg", { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": "true", class: "icon" }, [
        Dom.draw("path", { d: icons[icon] }),
      ]),
    );
  }

  function transport() {
    const time = Dom.make("input", {
      type: "text",
      id: "time",
      class: "time-input",
      "aria-label": "Time, as an exact number",
      spellcheck: "false",
      autocomplete: "off",
      test: "time",
      change: () => go(time),
      keydown: (/** @type {KeyboardEvent} */ event) => {
        if (event.key === "Enter") go(time);
        if (event.key === "Escape") time.blur();
      },
    });
    const near = Dom.make("span", { class: "near", test: "time-near" });
    const wrong = Dom.make("span", { class: "wrong", role: "alert", hidden: true, id: "time-wrong", test: "time-wrong" });
    time.setAttribute("aria-describedby", "time-wrong");
    time.addEventListener("input", () => {
      wrong.hidden = true;
    });
    const step = Dom.make("span", { class: "quiet step", test: "step", title: "Steps taken, of all" });
    const speed = Dom.make("span", { class: "speed", test: "speed" });
    const play = press("play", "", "Play (space)", () => player.toggle());
    play.classList.add("primary");
    Dom.fill(
      Dom.get("transport"),
      Dom.make("span", { class: "group" }, [
        press("first", "", "To the beginning (Home)", () => player.first()),
        press("previous", "", "One event back (left arrow)", () => player.previous()),
        play,
        press("next", "", "One event on (right arrow)", () => player.next()),
        press("last", "", "To the end (End)", () => player.finish()),
      ]),
      Dom.make("span", { class: "group clock" }, [Dom.make("label", { for: "time", text: "t =" }), time, near, wrong]),
      step,
      Dom.make("span", { class: "group push" }, [
        press("slower", "−", "Slower (-)", () => player.hasten(player.speed / 2)),
        speed,
        press("faster", "+", "Faster (+)", () => player.hasten(player.speed * 2)),
      ]),
      Dom.make("span", { class: "group" }, [
        press("narrow", "", "See less of time, about now", () => Timeline.zoom(0.5)),
        press("wide", "", "See more of time", () => Timeline.zoom(2)),
        press("whole", "All", "See all of time", () => Timeline.look(0, player.end)),
      ]),
    );
    const show = () => {
      const exact = Exactly.text(player.time);
      if (document.activeElement !== time) time.value = player.playing ? Exactly.decimal(player.clock) : exact;
      // As wide as the number, within reason; all of it is in its title.
      if (!player.playing) time.style.width = `${Math.max(9, Math.min(32, exact.length + 2))}ch`;
      time.title = player.playing ? "" : Exactly.both(player.time);
      Dom.tell(near, !player.playing && exact.includes("/") ? Exactly.told(player.time) : "");
      Dom.tell(step, `${player.legs} / ${player.course.legs.length}`);
    };
    const state = () => {
      picture(play, player.playing ? "pause" : "play");
      play.setAttribute("aria-label", player.playing ? "Pause (space)" : "Play (space)");
      play.title = player.playing ? "Pause (space)" : "Play (space)";
      const factor = player.speed < 1 ? `1/${1 / player.speed}` : String(player.speed);
      Dom.tell(speed, `× ${factor}`);
      speed.title = `A second shows ${Exactly.decimal(player.rate * player.speed)} of model time`;
      show();
    };
    player.on("move", show);
    player.on("play", state);
    player.on("run", state);
    state();
  }

  /** @param {HTMLInputElement} input */
  function go(input) {
    const wanted = input.value.trim().replace("−", "-"), near = Number(wanted);
    const time = Exactly.read(wanted) || (wanted !== "" && Number.isFinite(near) ? Rational.fromNumber(near) : null);
    const wrong = Dom.get("time-wrong");
    player.pause();
    // Left as it is: what was said before stays.
    if (wanted === Exactly.text(player.time)) return;
    const why = wanted === "" ? null
      : time === null ? `“${Dom.clip(wanted, 40)}” is no number, such as 5/2 or 2.5`
        : Rational.sign(time) < 0 ? "the run begins at 0"
          : Rational.cmp(time, player.course.duration) > 0 ? `the run ends at ${Exactly.both(player.course.duration)}` : null;
    if (time && Rational.cmp(time, player.time) !== 0) player.seek(time);
    Dom.tell(wrong, why || "");
    wrong.hidden = why === null;
    input.value = Exactly.text(player.time);
  }

  /** @param {string} id @param {string} text @param {string} title @param {() => void} action */
  function press(id, text, title, action) {
    // What has no words is called by its title.
    const label = /^[A-Z]/.test(text) ? null : title;
    made[id] = Dom.button(text, action, { id: `tool-${id}`, test: id, title, "aria-label": label });
    if (icons[id]) picture(made[id], id);
    return made[id];
  }

  function views() {
    const bar = Dom.get("scene-tools");
    const toggle = (/** @type {string} */ option, /** @type {string} */ text, /** @type {string} */ title) => {
      const button = press(option, text, title, () => set(option, !options[option]));
      button.setAttribute("aria-pressed", String(options[option]));
      return button;
    };
    const projection = press("projection", "Perspective", "Perspective, or parallel (o)", () =>
      set("projection", options.projection === "perspective" ? "orthographic" : "perspective"),
    );
    const up = press("up", "Up: y", "Which axis points up: y, z or x (u)", () =>
      set("up", { y: "z", z: "x", x: "y" }[/** @type {"x" | "y" | "z"} */ (options.up)]),
    );
    Dom.fill(
      bar,
      toggle("names", "Names", "Names of the bodies (n)"),
      toggle("velocities", "Velocities", "Velocities as arrows (v)"),
      toggle("spins", "Spins", "Spins as arrows"),
      toggle("trails", "Trails", "Where bodies have been (r)"),
      toggle("marks", "Marks", "The bodies that reasons name, and what the last step has changed (m)"),
      toggle("legend", "Legend", "What colours and patterns mean"),
      toggle("grid", "Grid", "The grid on the floor"),
      projection,
      up,
      press("fit", "Fit", "See all bodies (f)", () => scene && scene.fit()),
      press("follow", "Follow", "Go along with the selected body", follow),
    );
    made.follow.setAttribute("aria-pressed", "false");
    if (scene) scene.setOptions(options);
  }

  function follow() {
    if (!scene) return;
    const on = made.follow.getAttribute("aria-pressed") !== "true";
    const chosen = Details.selection();
    if (on && !chosen) {
      Dom.tell(Dom.get("live"), "Select a body first, to go along with it.");
      Tabs.show("details");
      return;
    }
    scene.follow(on && chosen ? chosen.leaf : null);
    made.follow.setAttribute("aria-pressed", String(on));
  }

  /** @param {string} option @param {any} value */
  function set(option, value) {
    options[option] = value;
    tell(option);
    document.dispatchEvent(new CustomEvent("view"));
    if (scene) {
      scene.setOptions(options);
      scene.show(player.course, player.legs, player.time);
    }
  }

  /**
   * Says on its button what an option is.
   * @param {string} option
   */
  function tell(option) {
    const button = made[option], value = options[option];
    if (!button) return;
    if (option === "projection") button.textContent = value === "perspective" ? "Perspective" : "Parallel";
    else if (option === "up") button.textContent = `Up: ${value}`;
    else button.setAttribute("aria-pressed", String(value));
  }

  /** Learns what an address has changed in the scene. */
  function learn() {
    if (!scene) return;
    for (const option of ["projection", "up"]) {
      options[option] = scene.options[option];
      tell(option);
    }
  }

  /** @param {string} option */
  function flip(option) {
    if (!made[option] || !scene) return;
    made[option].click();
  }

  function theme() {
    const served = document.querySelector('meta[name="scc-live"]') !== null;
    Theme.start(Dom.get("theme"), served, (is) => {
      if (scene) scene.setOptions({ ...options, theme: is });
      Timeline.paint();
      if (scene) scene.show(player.course, player.legs, player.time);
    });
  }

  /** The scene is narrower beside the graph. */
  function graph() {
    Graph.show();
    requestAnimationFrame(() => requestAnimationFrame(() => scene && scene.fit()));
  }

  function switches() {
    /** @type {[string, string, () => void][]} */
    const panels = [
      ["graph-switch", "graph-panel", graph],
      ["plots-switch", "plots-panel", () => Plots.draw()],
    ];
    for (const [id, panel, shown] of panels) {
      const button = Dom.get(id);
      button.addEventListener("click", () => {
        const on = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", String(on));
        Dom.get(panel).hidden = !on;
        document.body.classList.toggle(panel, on);
        if (on) shown();
        document.dispatchEvent(new CustomEvent("graph"));
      });
    }
  }

  /** What is shown in the scene, or left out, that is not so at first: of what the camera does not say. */
  const switched = () => Object.keys(usual).filter((option) => options[option] !== usual[option]);

  /**
   * Shows and leaves out what an address says.
   * @param {string[]} names of what is not as it is at first @returns {boolean} whether all of them are known
   */
  function load(names) {
    for (const option of Object.keys(usual)) {
      options[option] = usual[option] !== names.includes(option);
      tell(option);
    }
    if (scene) {
      scene.setOptions(options);
      scene.show(player.course, player.legs, player.time);
    }
    return names.every((name) => Object.keys(usual).includes(name));
  }

  return { start, flip, learn, switched, load };
})();
