"use strict";

/** Puts the page together. */
const Main = (() => {
  /**
   * What the page tells to those who test it, or drive it from the console, as `window.scc`: where one is, with all
   * numbers as exact texts, and ways to go elsewhere.
   * @param {Player} player @param {Scene | null} scene
   */
  function probe(player, scene) {
    return {
      version: 1,
      data: player.data,
      state: () => ({
        run: player.run.name,
        way: player.run.way,
        legs: player.legs,
        time: Rational.text(player.time),
        state: player.state,
        playing: player.playing,
        bodies: bodies(player),
      }),
      floats: () => floats(player),
      runs: () => player.runs.map((run) => ({ name: run.name, index: run.index, steps: run.steps.length })),
      link: () => Links.text(),
      work: () => (scene ? scene.work : null),
      moved: () => scene !== null && scene.moved,
      inView: () => scene === null || scene.inView(),
      look: () => (scene ? scene.look() : null),
      file: (/** @type {any} */ wishes) => Export.bytes(wishes),
      command: (/** @type {any} */ wishes) => Export.command(wishes || {}),
      schedule: () => Export.schedule(),
      compare: (/** @type {number | null} */ index) => Compare.choose(index === null ? null : player.runs[index]),
      compared: () => Compare.say(),
      marks: () => (scene ? marks(player, scene) : null),
      sight: (/** @type {number[]} */ point) => (scene ? scene.sight(point) : null),
      open: (/** @type {number} */ index) => player.open(player.runs[index]),
      go: (/** @type {number} */ legs, /** @type {string | undefined} */ time) =>
        player.go(legs, time === undefined ? undefined : Rational.of(time)),
      seek: (/** @type {string} */ time) => player.seek(Rational.of(time)),
      choose: (/** @type {number} */ choice) => player.choose(choice),
      busy: () => Live.busy() || Values.busy(),
      plots: () => Plots.told(),
      spread: () => Spread.now(),
      // Where a page from disk has exact values: a text, null where there is none; or what is wrong with the formula.
      evaluate: (/** @type {string} */ text) => Formulas.evaluate(text),
    };
  }

  /**
   * All bodies, by their names.
   * @param {Player} player
   */
  function bodies(player) {
    /** @type {{[name: string]: {position: string[], velocity: string[], behaviour: string}}} */
    const all = {};
    for (const body of player.course.bodiesAfter(player.legs, player.time)) {
      for (const place of body.process.leaves) {
        all[player.course.leaves[place.leaf].name] = {
          position: player.course.position(body, place).map(Rational.text),
          velocity: body.process.velocity.map((/** @type {string} */ v) => Rational.text(Rational.of(v))),
          behaviour: player.data.behaviours[place.behaviour].text,
        };
      }
    }
    return all;
  }

  /**
   * Where the scene has all bodies, relative to the origin, by their names.
   * @param {Player} player
   */
  function floats(player) {
    const origin = Motion.target({ n: [0n, 0n, 0n], d: 1n });
    const out = new Float64Array(12);
    /** @type {{[name: string]: number[]}} */
    const all = {};
    for (const body of player.course.bodiesAfter(player.legs, player.time)) {
      for (const place of body.process.leaves) {
        player.course.place(body, place, origin, out);
        all[player.course.leaves[place.leaf].name] = [...out.slice(0, 3)];
      }
    }
    return all;
  }

  /**
   * What is marked in the scene, by names.
   * @param {Player} player @param {Scene} scene
   */
  function marks(player, scene) {
    const { lit, words, ends, before, gone } = scene.marked, name = (/** @type {number} */ leaf) => player.course.leaves[leaf].name;
    return {
      lit: lit.map(name),
      words: words.map(({ leaf, text }) => `${name(leaf)}: ${text}`),
      ends: ends.map(({ leaf, site, made }) => `${name(leaf)} ${site.join(" ")} ${made ? "made" : "split"}`),
      before: before.map(({ course, body, place }) => [name(place.leaf), ...course.position(body, place).map(Rational.text)]),
      gone: gone.map(({ course, body, place }) => [name(place.leaf), ...course.position(body, place).map(Rational.text)]),
    };
  }

  /** @param {PageData} data */
  function head(data) {
    Dom.get("title").textContent = Dom.clip(data.name, 2000);
    Dom.get("title").title = Dom.clip(data.name, 400);
    Dom.get("model").append(Dom.make("pre", { class: "source", dir: "ltr", text: data.text }));
  }

  /**
   * The values of parameters: those of the document, and of the start that is shown.
   * @param {Player} player
   */
  function about(player) {
    const values = Exactly.values({ ...player.data.parameters, ...player.run.values });
    Dom.fill(Dom.get("about"), Dom.make("bdi", { text: Dom.clip(values, 400) }));
    Dom.get("about").title = Dom.clip(values, 2000);
  }

  /**
   * The scene, or null where it cannot be drawn: then the page says why.
   * @param {PageData} data
   */
  function stage(data) {
    const box = Dom.get("scene");
    let why = /** @type {string | null} */ (null);
    try {
      const scene = new Scene(box, data, {
        onPick: (/** @type {Chosen | null} */ found) => {
          if (found) Tabs.show("details");
          Details.select(found);
        },
      });
      why = Scene.why;
      if (!why) return scene;
    } catch (error) {
      why = String(error instanceof Error ? error.message : error);
    }
    box.hidden = true;
    Dom.get("scene-tools").hidden = true;
    const told = Dom.get("scene-why");
    told.hidden = false;
    Dom.fill(
      told,
      Dom.make("p", { text: `The scene cannot be drawn here: ${why}.` }),
      Dom.make("p", {
        text: "All else is there: runs, events, choices, plots, and the exact places of bodies below Bodies.",
      }),
    );
    Tabs.show("details");
    return null;
  }

  /**
   * Whether all numbers of rows in the data are those of rows: a file may have been changed.
   * @param {PageData} data
   */
  function hold(data) {
    for (const name of /** @type {const} */ (["states", "runs", "leaves", "labels", "processes", "behaviours", "solids", "plots"]))
      if (!Array.isArray(data[name])) throw new Error(`the file holds no ${name}`);
    if (data.states.length === 0) throw new Error("the file holds no states");
    // A simulation may have been interrupted before its first run.
    if (data.runs.length === 0 && !data.spread) throw new Error("the file holds no runs");
    /** @param {string} what @param {any} n @param {{ length: number }} rows @param {string} row */
    const one = (what, n, { length }, row) => {
      if (!Number.isInteger(n) || n < 0 || n >= length) throw new Error(`the file has no ${row} ${Dom.clip(String(n), 40)}, which ${what} names`);
    };
    data.runs.forEach((run, i) => {
      if (run.start === null) return;
      one(`run ${i}`, run.start, data.states, "state");
      for (const step of run.steps || []) {
        one(`a step of run ${i}`, step.to, data.states, "state");
        one(`a step of run ${i}`, step.label, data.labels, "label");
      }
    });
    data.states.forEach((state, i) => {
      // One is told by an earlier one.
      if (state.of !== null) one(`state ${i}`, state.of, { length: i }, "earlier state");
      for (const process of state.come) one(`state ${i}`, process, data.processes, "process");
      for (const next of state.next || []) {
        one(`state ${i}`, next.label, data.labels, "label");
        if (next.to !== null) one(`state ${i}`, next.to, data.states, "state");
      }
    });
    data.processes.forEach((process, i) => {
      for (const place of process.leaves) {
        one(`process ${i}`, place.leaf, data.leaves, "body");
        one(`process ${i}`, place.behaviour, data.behaviours, "behaviour");
      }
    });
    data.leaves.forEach((leaf, i) => {
      for (const part of leaf.parts) one(`body ${i}`, part.solid, data.solids, "solid");
    });
  }

  function start() {
    const text = Dom.get("data").textContent || "";
    /** @type {PageData} */
    const data = JSON.parse(text);
    if (data.format !== "scc-view" || data.version !== 1)
      throw new Error("the data is of another version than the page");
    hold(data);
    head(data);
    Channels.start(data);
    const player = new Player(data);
    player.on("run", about);
    about(player);
    Live.start();
    Grow.start(player);
    Regions.start(player);
    Spread.start(player);
    Channels.start(data);
    Tabs.start();
    Rules.start(data);
    const scene = stage(data);
    Compare.start(player, scene);
    Timeline.start(player);
    Runs.start(player);
    Choices.start(player);
    Events.start(player);
    Details.start(player);
    Plots.start(player);
    Graph.start(player);
    Tools.start(player, scene);
    Export.start(player, scene);
    Keys.start(player);
    if (scene) {
      let start = Exactly.values(player.run.values);
      const draw = () => {
        scene.playing = player.playing;
        scene.mark(Marked.now(player, scene.bodies.colors));
        scene.show(player.course, player.legs, player.time);
        const now = Exactly.values(player.run.values);
        if (now !== start) scene.restart();
        start = now;
      };
      player.on("move", draw);
      player.on("grow", () => scene.learn());
      Details.onSelect((selection) => {
        scene.select(selection);
        draw();
      });
      draw();
      scene.fit();
    }
    Links.start(player, scene);
    Object.defineProperty(window, "scc", { value: probe(player, scene) });
    document.body.setAttribute("data-ready", "true");
  }

  /** A page that cannot be shown says so. */
  function open() {
    try {
      start();
    } catch (error) {
      const box = Dom.get("notice");
      box.hidden = false;
      box.textContent = `This page cannot be shown: ${error instanceof Error ? error.message : error}.`;
      throw error;
    }
  }

  return { open };
})();

Main.open();
