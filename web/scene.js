"use strict";

/**
 * The bodies of a state, drawn in space.
 *
 * `Scene.why` tells why nothing can be drawn, if so: then the rest of the page does without.
 */
class Scene {
  /** @type {string | null} */
  static why = typeof THREE === "undefined" ? "this file was written without the library three.js, which draws it" : null;

  /** @param {HTMLElement} box @param {PageData} data @param {{ onPick?: (found: Chosen | null) => void }} callbacks */
  constructor(box, data, callbacks) {
    this.box = box;
    this.data = data;
    this.callbacks = callbacks;
    /** @type {{ [option: string]: any }} */
    this.options = {
      names: false, velocities: false, spins: false, trails: false, grid: true, legend: true, projection: "perspective",
      theme: "light",
    };
    /** @type {number | null} */
    this.followed = null;
    /** What a frame took besides the drawing by the graphics card, in milliseconds. */
    this.work = 0;
    this.waiting = false;
    this.fitted = false;
    this.size = "";
    /**
     * How high the floor is.
     * @type {Rational}
     */
    this.floorAt = typeof Rational === "undefined" ? /** @type {any} */ (null) : Rational.zero;
    /** @type {{ course: Course, legs: number, time: Rational } | null} */
    this.now = null;
    /**
     * Where the pointer is, while it only points.
     * @type {{ x: number, y: number } | null}
     */
    this.pointer = null;
    this.still = window.matchMedia("(prefers-reduced-motion: reduce)");
    this.canvas = document.createElement("canvas");
    // These are there wherever something can be drawn at all.
    const none = /** @type {any} */ (null);
    this.renderer = none;
    /** @type {Orbit} */
    this.orbit = none;
    /** @type {Floor} */
    this.floor = none;
    /** @type {Bodies} */
    this.bodies = none;
    /** @type {Trails} */
    this.trails = none;
    /** @type {Overlay} */
    this.overlay = none;
    /** @type {ReturnType<Scene["legend"]>} */
    this.entries = [];
    if (Scene.why) return;
    const context = Scene.#context(this.canvas);
    if (!context) {
      Scene.why = "this browser offers no WebGL here";
      return;
    }
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, context });
    this.renderer.autoClear = false;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-roledescription", "scene");
    this.canvas.setAttribute("aria-label",
      "The bodies in space. Keys: w a s d turn, with shift they move, z and shift z zoom. All that is seen is told in Bodies.");
    Object.assign(this.canvas.style, { position: "absolute", inset: "0", width: "100%", height: "100%", touchAction: "none" });
    box.append(this.canvas);
    this.scene = new THREE.Scene();
    this.above = new THREE.Scene();
    this.orbit = new Orbit(this.canvas, () => this.refresh());
    this.floor = new Floor(this.scene);
    this.bodies = new Bodies(data, this.scene, this.above);
    this.trails = new Trails(data, this.bodies, this.scene);
    this.overlay = new Overlay(box);
    this.entries = this.legend();
    this.#listen();
    new ResizeObserver(() => this.refresh()).observe(box);
  }

  /** @param {HTMLCanvasElement} canvas @returns {RenderingContext | null} */
  static #context(canvas) {
    const wanted = { alpha: true, antialias: true, stencil: true, premultipliedAlpha: true };
    try {
      return canvas.getContext("webgl", wanted);
    } catch (_) {
      return null;
    }
  }

  get dark() { return this.options.theme === "dark"; }

  /** What colours and patterns mean. */
  legend() {
    /** @type {{ text: string, color: number[], shape: "body" | "name" | "co" | "fixed" }[]} */
    const entries = [];
    const seen = new Set();
    for (const { name, color, fixed, absorbs } of this.bodies.families) {
      const key = `${name} ${fixed} ${absorbs}`;
      if (seen.has(key)) continue;
      seen.add(key);
      const text = absorbs ? `${name} (absorbs)` : fixed ? `${name} (fixed)` : name;
      entries.push({ text, color, shape: fixed ? "fixed" : "body" });
    }
    const open = this.data.behaviours.flatMap((b) => b.open);
    for (const [channel, color] of this.bodies.channels)
      for (const co of [false, true])
        if (open.some((o) => o.channel === channel && o.co === co))
          entries.push({ text: co ? `~${channel}` : channel, color, shape: co ? "co" : "name" });
    return entries;
  }

  /**
   * Shows the state after so many legs of a run, at a time.
   * @param {Course} course @param {number} legs @param {Rational} time
   */
  show(course, legs, time) {
    this.now = { course, legs, time };
    if (!Scene.why && this.bodies.setLeaves(course.leaves)) this.entries = this.legend();
    this.refresh();
  }

  /** Draws when the browser is next ready to. */
  refresh() {
    if (this.waiting || !this.now || Scene.why) return;
    this.waiting = true;
    window.requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  /** Draws now. */
  draw() {
    const now = this.now, width = this.box.clientWidth, height = this.box.clientHeight;
    if (!now || width === 0 || height === 0) return;
    const began = performance.now();
    const { orbit, bodies, options } = this;
    const present = now.course.bodiesAfter(now.legs, now.time);
    this.#goAlong(now.course, present);
    bodies.update(now.course, present, orbit.target);
    orbit.place(width, height, this.#extent());
    this.floor.place(orbit.at, orbit.distance, this.floorAt, bodies.colors, options.grid);
    this.#shared(width, height);
    bodies.arrows(/** @type {any} */ (options), orbit.distance);
    this.trails.update(now.course, now.legs, now.time, orbit, options.trails);
    if (this.pointer) this.#hover(this.pointer);
    if (!bodies.last.bodies) bodies.update(now.course, present, orbit.target);
    bodies.finish();
    this.#words(width, height);
    this.work = performance.now() - began;
    this.renderer.clear();
    this.renderer.render(this.scene, orbit.camera);
    this.renderer.clearDepth();
    this.renderer.render(this.above, orbit.camera);
  }

  /** @param {number} width @param {number} height */
  #shared(width, height) {
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    if (this.size !== `${width} ${height} ${ratio}`) {
      this.size = `${width} ${height} ${ratio}`;
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
    }
    const { floor, orbit } = this;
    Kind.shared.size.value.set(width, height);
    Kind.shared.near.value = orbit.parallel ? 0 : orbit.camera.near;
    Kind.shared.ground.value = floor.ground + 1e-3 * floor.step;
    Kind.shared.shadow.value = this.options.grid && orbit.direction.y > 0 ? this.bodies.colors.shadow : 0;
  }

  /** @param {Course} course @param {Moving[]} present */
  #goAlong(course, present) {
    if (this.followed === null || this.orbit.flight) return;
    for (const body of present)
      for (const place of body.process.leaves)
        if (place.leaf === this.followed) this.orbit.lookAt(course.position(body, place).map(Rational.toNumber));
  }

  /** @param {number} width @param {number} height */
  #words(width, height) {
    const { overlay, bodies, orbit, floor, options } = this;
    overlay.begin(width, height, Math.min(2, window.devicePixelRatio || 1), bodies.colors);
    const project = this.projector(width, height);
    overlay.axes(orbit.camera.matrixWorld.elements);
    const tools = this.#tools(), long = floor.step / orbit.pixel;
    if (options.grid) overlay.scale(long, floor.decimal(1n), tools.right > width - long - 30 ? tools.height : 0);
    if (options.legend && this.entries.length > 1) overlay.legend(this.entries);
    const at = (/** @type {Shown} */ s) => project(Pick.toWorld(s.matrix, bodies.centres[s.leaf]));
    const chosen = bodies.chosen ? bodies.byLeaf.get(bodies.chosen.leaf) : undefined;
    const named = options.names ? bodies.shown : chosen ? [chosen] : [];
    /** @type {{ shown: Shown, x: number, y: number, depth: number }[]} */
    const places = [];
    for (const shown of named) {
      const p = at(shown);
      if (p.seen && p.x > -50 && p.y > -20 && p.x < width + 50 && p.y < height + 20) places.push({ shown, ...p });
    }
    places.sort((a, b) => (b.shown === chosen ? 1 : 0) - (a.shown === chosen ? 1 : 0) || a.depth - b.depth);
    const style = { size: 12, strong: true, color: bodies.colors.text };
    let said = 0;
    for (const { shown, x, y } of places.slice(0, 1000)) {
      if (said >= 250) break;
      if (overlay.word(this.bodies.leaves[shown.leaf].name, x, y, { ...style, force: shown === chosen })) said++;
    }
    if (options.grid) {
      const { x, z } = bodies.colors;
      for (const n of floor.numbers(this.#clip(), width, height, tools.height))
        if (!this.#covered(n.x, n.y)) overlay.word(n.text, n.x, n.y, { size: 10.5, color: Colors.css(Colors.mix(n.axis ? z : x, bodies.colors.grid, 0.35)) });
    }
    const pointed = this.pointer && bodies.hovered;
    if (this.pointer && pointed)
      overlay.word(this.#told(pointed), this.pointer.x, this.pointer.y - 18, { ...style, size: 11.5, force: true });
  }

  /** How much of the picture is under the buttons below: from below, and from the left. */
  #tools() {
    const parent = this.box.parentElement, bar = parent && parent.querySelector("[role=toolbar]");
    const box = this.box.getBoundingClientRect(), of = bar && bar.getBoundingClientRect();
    if (!of || of.height === 0 || of.top < box.top + box.height / 2) return { height: 0, right: 0 };
    return { height: Math.max(0, box.bottom - of.top), right: of.right - box.left };
  }

  /**
   * Whether a body that is not seen through is at a pixel.
   * @param {number} x @param {number} y
   */
  #covered(x, y) {
    const found = this.pick(x, y, 0);
    return found !== null && !this.bodies.leaves[found.leaf].fixed;
  }

  /**
   * The name of what is pointed at, and the channels that are open on it.
   * @param {Chosen} chosen
   */
  #told({ leaf, part, kind, index }) {
    const of = this.bodies.leaves[leaf];
    const in_ = typeof part === "number" ? of.parts[part] : undefined;
    if (!in_ || !kind || typeof index !== "number") return of.name;
    const solid = this.data.solids[in_.solid];
    const name = kind === "face" ? solid.faces[index].name : kind === "edge" ? solid.edges[index].name : solid.corners[index];
    const shown = this.bodies.byLeaf.get(leaf);
    const open = !shown ? [] : this.data.behaviours[shown.place.behaviour].open
      .filter((o) => o.sites.some((s) => s[0] === part && s[1] === kind && s[2] === index))
      .map((o) => (o.co ? "~" : "") + o.channel);
    return `${in_.name}.${name}${open.length ? ": " + open.join(", ") : ""}`;
  }

  /** @returns {(p: number[]) => number[]} from points relative to the target to clip space */
  #clip() {
    const camera = this.orbit.camera;
    const inverse = new THREE.Matrix4().getInverse(camera.matrixWorld);
    const m = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, inverse).elements;
    return (p) => [0, 1, 2, 3].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);
  }

  /**
   * From points relative to the target to pixels.
   * @param {number} width @param {number} height
   */
  projector(width, height) {
    const clip = this.#clip();
    return (/** @type {number[]} */ p) => {
      const [x, y, z, w] = clip(p);
      return { x: (0.5 + x / w / 2) * width, y: (0.5 - y / w / 2) * height, depth: z / w, seen: w > 0 };
    };
  }

  /** How far what is shown reaches from the target. */
  #extent() {
    let far = this.orbit.distance;
    for (const { matrix: m, size } of this.bodies.shown)
      far = Math.max(far, Math.sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) + size);
    return far;
  }

  /** Sees all bodies: those that move, and what is fixed unless it is much larger; at first, those of the whole run. */
  fit() {
    const now = this.now;
    if (!now || Scene.why) return;
    const { course, legs, time } = now;
    const here = Frame.boxes(this.bodies, course, course.bodiesAfter(legs, time));
    let all = here;
    if (!this.fitted)
      for (let i = 0; i <= 8; i++) {
        const at = Rational.mul(course.duration, Rational.make(BigInt(i), 8n));
        all = all.concat(Frame.boxes(this.bodies, course, course.bodiesAt(at)).filter((b) => !b.fixed));
      }
    let seen = Frame.whole(here);
    const later = Frame.whole(all);
    if (!seen || !later) return;
    if (later.size < 3.5 * seen.size) seen = later;
    const { at, distance } = Frame.fit(seen.points, this.orbit, this.box.clientWidth, this.box.clientHeight);
    const { lead, power } = Floor.round(distance / 9), step = lead * 10 ** power;
    this.floorAt = Rational.fromNumber(Math.floor(seen.low[1] / step + 1e-6) * step);
    this.followed = null;
    this.orbit.fly(at, distance, this.still.matches || !this.fitted);
    this.fitted = true;
    this.refresh();
  }

  /** @param {{ [option: string]: any }} options */
  setOptions(options) {
    const dark = this.dark;
    Object.assign(this.options, options);
    if (Scene.why) return;
    this.orbit.parallel = this.options.projection === "orthographic";
    if (dark !== this.dark) this.bodies.setTheme(this.dark);
    this.refresh();
  }

  /** @param {number | null} leaf */
  follow(leaf) {
    this.followed = leaf;
    this.refresh();
  }

  /** @param {Chosen | null} chosen */
  select(chosen) {
    if (Scene.why) return;
    this.bodies.chosen = chosen;
    this.bodies.relay();
    this.refresh();
  }

  camera() { return Scene.why ? {} : this.orbit.save(); }

  /** @param {{ [key: string]: any }} camera */
  setCamera(camera) {
    if (Scene.why) return;
    this.orbit.load(camera);
    this.fitted = true;
    this.options.projection = this.orbit.parallel ? "orthographic" : "perspective";
    this.refresh();
  }

  #listen() {
    let from = { x: 0, y: 0 }, held = 0;
    const at = (/** @type {PointerEvent} */ e) => {
      const box = this.canvas.getBoundingClientRect();
      return { x: e.clientX - box.left, y: e.clientY - box.top };
    };
    const point = (/** @type {{ x: number, y: number } | null} */ to) => {
      this.pointer = to;
      if (!to && this.bodies.hovered) {
        this.bodies.hovered = null;
        this.bodies.relay();
      }
      this.refresh();
    };
    this.canvas.addEventListener("pointerdown", (e) => {
      from = at(e);
      held++;
      point(null);
    });
    this.canvas.addEventListener("pointermove", (e) => {
      if (e.pointerType === "mouse" && e.buttons === 0) point(at(e));
    });
    this.canvas.addEventListener("pointerleave", () => point(null));
    this.canvas.addEventListener("pointercancel", () => { held = 0; });
    this.canvas.addEventListener("pointerup", (e) => {
      const to = at(e), many = held > 1;
      held = Math.max(0, held - 1);
      if (e.button !== 0 || many || Math.hypot(to.x - from.x, to.y - from.y) > 4) return;
      const found = this.pick(to.x, to.y, e.pointerType === "touch" ? 16 : 8);
      if (this.callbacks.onPick) this.callbacks.onPick(found);
    });
    this.canvas.addEventListener("webglcontextrestored", () => this.refresh());
  }

  /** @param {{ x: number, y: number }} pointer */
  #hover(pointer) {
    const found = this.pick(pointer.x, pointer.y);
    if (JSON.stringify(found) === JSON.stringify(this.bodies.hovered)) return;
    this.bodies.hovered = found;
    this.bodies.relay();
    this.canvas.style.cursor = found ? "pointer" : "grab";
  }

  /**
   * What is seen at a pixel.
   * @param {number} x @param {number} y @param {number} [near] how near a corner is meant
   * @returns {Chosen | null}
   */
  pick(x, y, near = 8) {
    const width = this.box.clientWidth, height = this.box.clientHeight, camera = this.orbit.camera;
    const end = (/** @type {number} */ z) => new THREE.Vector3((2 * x) / width - 1, 1 - (2 * y) / height, z).unproject(camera);
    const a = end(-1), b = end(1);
    const hit = Pick.first(this.bodies.shown, [a.x, a.y, a.z], [b.x - a.x, b.y - a.y, b.z - a.z]);
    if (!hit) return null;
    const { kind, index } = Pick.feature(hit.shown, hit.part, hit.face, this.projector(width, height), x, y, near);
    return { leaf: hit.shown.leaf, part: hit.part, kind, index };
  }
}
