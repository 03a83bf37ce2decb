"use strict";

/** What stands around the bodies: the floor with its numbers, names, a legend, and where bodies have been. */
class Marks {
  /** @param {Scene} scene @param {HTMLElement} box */
  constructor(scene, box) {
    this.scene = scene;
    this.floor = new Floor(scene.gl);
    this.trails = new Trails(scene.data, scene.bodies, scene.gl);
    this.overlay = new Overlay(box);
    this.entries = this.#legend();
    /** @type {Corner} */
    this.corner = "left";
    /** Whether bodies have been brought into view: the legend then goes where they are not. */
    this.fresh = false;
  }

  /** There are other bodies. */
  learn() {
    this.entries = this.#legend();
  }

  /**
   * Where it is now.
   * @param {{ course: Course, legs: number, time: Rational }} now
   */
  place({ course, legs, time }) {
    const { orbit, bodies, options, floorAt } = this.scene;
    this.floor.place(orbit, floorAt, bodies.colors, options.grid);
    this.floor.shadow.value = orbit.height > 0 ? bodies.colors.shadow : 0;
    this.trails.update(course, legs, time, orbit, options.trails);
  }

  /** Where the legend is: in which corner, and from where to where. */
  get legend() {
    return { legend: this.corner, box: this.overlay.room(this.entries, this.corner, this.#tools().height).box };
  }

  /** What colours and patterns mean. */
  #legend() {
    /** @type {{ text: string, color: number[], shape: "body" | "name" | "co", leaf?: number }[]} */
    const entries = [];
    const seen = new Set();
    for (const [leaf, { name, color, fixed, absorbs }] of this.scene.bodies.families.entries()) {
      const key = `${name} ${fixed} ${absorbs}`;
      if (seen.has(key)) continue;
      seen.add(key);
      const text = absorbs ? `${name} (absorbs)` : fixed ? `${name} (fixed)` : name;
      entries.push({ text, color, shape: "body", leaf });
    }
    const open = this.scene.data.behaviours.flatMap((b) => b.open);
    for (const [channel, color] of this.scene.bodies.channels)
      for (const co of [false, true])
        if (open.some((o) => o.channel === channel && o.co === co))
          entries.push({ text: `${co ? "~" : ""}${channel} (channel)`, color, shape: co ? "co" : "name" });
    return entries;
  }

  /**
   * All words of the picture.
   * @param {number} width @param {number} height
   */
  words(width, height) {
    const { overlay, floor } = this, { bodies, orbit, options } = this.scene;
    const { composed, frame } = this.scene;
    overlay.begin(width, height, frame.ratio, bodies.colors);
    const project = this.scene.projector(width, height);
    if (!composed || composed.axes) overlay.axes(orbit.camera.world);
    const tools = composed ? { height: 0, right: 0 } : this.#tools(), long = floor.step / orbit.pixel;
    if (composed ? composed.bar : options.grid)
      overlay.scale(long, floor.decimal(1n), tools.right > width - long - 30 ? tools.height : 0);
    if (composed?.clock && this.scene.now) overlay.clock(`t = ${Marks.time(this.scene.now.time)}`);
    if ((composed ? composed.legend : options.legend) && this.entries.length > 1) {
      if (this.fresh && !composed && !orbit.flight) this.#settle(project, tools.height);
      overlay.legend(this.entries.map((e) => (e.leaf === undefined ? e : { ...e, color: bodies.tints[e.leaf] })), this.corner, tools.height);
    }
    const at = (/** @type {Shown} */ s) => project(Pick.toWorld(s.matrix, bodies.centres[s.leaf]));
    const chosen = bodies.chosen ? bodies.byLeaf.get(bodies.chosen.leaf) : undefined;
    const { lit, words: changed } = this.scene.marked, called = new Set([...lit, ...changed.map((c) => c.leaf)]);
    const marked = bodies.shown.filter((s) => called.has(s.leaf));
    const named = options.names ? bodies.shown : chosen && !called.has(chosen.leaf) ? [chosen, ...marked] : marked;
    /** @type {{ shown: Shown, x: number, y: number, depth: number }[]} */
    const places = [];
    for (const shown of named) {
      const p = at(shown);
      if (p.seen && p.x > -50 && p.y > -20 && p.x < width + 50 && p.y < height + 20) places.push({ shown, ...p });
    }
    const first = (/** @type {Shown} */ s) => (s === chosen ? 2 : called.has(s.leaf) ? 1 : 0);
    places.sort((a, b) => first(b.shown) - first(a.shown) || a.depth - b.depth);
    const style = { size: 12, strong: true, color: bodies.colors.text };
    let said = 0;
    for (const { shown, x, y } of places.slice(0, 1000)) {
      if (said >= 250) break;
      const { name } = this.scene.bodies.leaves[shown.leaf], beside = shown === chosen ? [0, 16, -16, 32, -32] : [0];
      if (beside.some((by) => overlay.word(name, x, y + by, style)) || (shown === chosen && overlay.word(name, x, y, { ...style, force: true }))) said++;
      const small = { ...style, size: 11, color: Colors.css(bodies.colors.made), within: true };
      for (const { leaf, text } of changed)
        if (leaf === shown.leaf) [16, -16, 32].some((by) => overlay.word(text, x, y + by, small));
    }
    for (const { text, at: place, color } of this.scene.ghosts.words) {
      const p = project(place);
      const small = { ...style, size: 11, color: Colors.css(color), within: true };
      if (p.seen) [0, 16, -16, 32].some((by) => overlay.word(text, p.x, p.y + by, small));
    }
    if (options.grid) {
      const { x, y, z } = bodies.colors;
      for (const n of floor.numbers((p) => orbit.camera.at(p), width, height, tools.height))
        if (this.scene.pick(n.x, n.y, 0) === null) {
          const color = Colors.css(Colors.mix([x, y, z][n.axis], bodies.colors.grid, 0.35));
          overlay.word(n.text, n.x, n.y, { size: 10.5, color, within: true });
        }
    }
    const pointed = !composed && this.scene.pointer && bodies.hovered;
    if (this.scene.pointer && pointed)
      overlay.word(this.#told(pointed), this.scene.pointer.x, this.scene.pointer.y - 18, { ...style, size: 11.5, force: true, within: true });
  }

  /**
   * A time in few letters.
   * @param {Rational} time
   */
  static time(time) {
    const exact = Rational.text(time).replace(/\/1$/, "");
    return exact.length <= 12 ? exact : Rational.toNumber(time).toPrecision(6);
  }

  /**
   * Puts the legend into the corner in which it covers the fewest bodies, besides walls; of several, the first.
   * @param {ReturnType<Scene["projector"]>} project @param {number} margin
   */
  #settle(project, margin) {
    const { bodies, walls, orbit } = this.scene, [x, y, z] = orbit.camera.world, seen = [];
    for (const shown of bodies.shown) {
      if (walls.has(shown.leaf)) continue;
      const at = Pick.toWorld(shown.matrix, bodies.centres[shown.leaf]), r = bodies.sizes[shown.leaf];
      const p = project(at), q = project([at[0] + r * x, at[1] + r * y, at[2] + r * z]);
      if (p.seen) seen.push({ x: p.x, y: p.y, r: Math.hypot(q.x - p.x, q.y - p.y) });
    }
    let least = Infinity;
    for (const corner of Overlay.corners) {
      const { box: [left, top, right, bottom], rows } = this.overlay.room(this.entries, corner, margin);
      const covered = seen.filter((s) => Math.hypot(s.x - Math.max(left, Math.min(right, s.x)), s.y - Math.max(top, Math.min(bottom, s.y))) < s.r).length;
      const score = covered + this.entries.length - rows;
      if (score < least) [this.corner, least] = [corner, score];
    }
    this.fresh = false;
  }

  /**
   * How much of a picture is under the legend and under the buttons, unless that is a good part of it.
   * @param {number} width @param {number} height
   */
  taken(width, height) {
    const legend = this.scene.options.legend && this.entries.length > 1 ? this.overlay.long(this.entries) : 0;
    const below = this.#tools().height;
    return { left: legend < 0.3 * width ? legend : 0, below: below < 0.3 * height ? below : 0 };
  }

  /** How much of the picture is under the buttons below: from below, and from the left. */
  #tools() {
    const parent = this.scene.box.parentElement, bar = parent && parent.querySelector("[role=toolbar]");
    const box = this.scene.box.getBoundingClientRect(), of = bar && bar.getBoundingClientRect();
    if (!of || of.height === 0 || of.top < box.top + box.height / 2) return { height: 0, right: 0 };
    return { height: Math.max(0, box.bottom - of.top), right: of.right - box.left };
  }

  /**
   * The name of what is pointed at, and the channels that are open on it.
   * @param {Chosen} chosen
   */
  #told({ leaf, part, kind, index }) {
    const of = this.scene.bodies.leaves[leaf];
    const in_ = typeof part === "number" ? of.parts[part] : undefined;
    if (!in_ || !kind || typeof index !== "number") return of.name;
    const solid = this.scene.data.solids[in_.solid];
    const name = kind === "face" ? solid.faces[index].name : kind === "edge" ? solid.edges[index].name : solid.corners[index];
    const shown = this.scene.bodies.byLeaf.get(leaf);
    const open = !shown ? [] : this.scene.data.behaviours[shown.place.behaviour].open
      .filter((o) => o.sites.some((s) => s[0] === part && s[1] === kind && s[2] === index))
      .map((o) => (o.co ? "~" : "") + o.channel);
    return `${in_.name}.${name}${open.length ? ": " + open.join(", ") : ""}`;
  }
}
