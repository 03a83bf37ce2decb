"use strict";

/**
 * The bodies of a state, drawn in space.
 *
 * `Scene.why` tells why nothing can be drawn at all; the constructor throws where a browser cannot draw.
 */
class Scene {
  /** @type {string | null} */
  static why = typeof THREE === "undefined" ? "this file was written without the library three.js, which draws it" : null;

  /** Told apart by those who see few colours, too. */
  static palette = [
    [0.90, 0.62, 0.0], [0.34, 0.71, 0.91], [0.0, 0.62, 0.45], [0.84, 0.37, 0.0], [0.80, 0.47, 0.65], [0.0, 0.45, 0.70],
    [0.88, 0.82, 0.26], [0.55, 0.42, 0.85], [0.60, 0.60, 0.60], [0.70, 0.25, 0.35],
  ];

  /** @param {HTMLElement} box @param {PageData} data @param {{ onPick?: (found: Chosen | null) => void }} callbacks */
  constructor(box, data, callbacks) {
    this.box = box;
    this.data = data;
    /** @type {{ [option: string]: any }} */
    this.options = { names: false, velocities: false, spins: false, trails: false, grid: true, projection: "perspective", theme: "light" };
    this.canvas = document.createElement("canvas");
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label",
      "The bodies in space. Keys: w a s d turn, with shift they move, z and shift z zoom. All that is seen is told below Bodies.");
    Object.assign(this.canvas.style, { position: "absolute", inset: "0", width: "100%", height: "100%", touchAction: "none" });
    try {
      this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
    } catch (error) {
      throw new Error("this browser has no WebGL");
    }
    box.append(this.canvas);
    this.scene = new THREE.Scene();
    this.orbit = new Orbit(this.canvas, () => this.refresh());
    this.marks = new Marks(this.scene, box);
    /** @type {Map<string, Kind>} */
    this.kinds = new Map();
    /** @type {DataLeaf[]} */
    this.leaves = [];
    /** @type {ReturnType<typeof Shapes.part>[][]} */
    this.models = [];
    /** @type {number[]} */
    this.sizes = [];
    /** @type {string[]} */
    this.shapes = [];
    this.colors = this.#families();
    this.#build(data.leaves);
    const fastest = (/** @type {(p: DataProcess) => Vec | undefined} */ of) =>
      Math.max(0, ...this.#some(data.processes).map((p) => Math.hypot(...(of(p) || ["0", "0", "0"]).map((t) => Rational.toNumber(Rational.of(t))))));
    this.fastest = fastest((p) => p.velocity);
    this.widest = fastest((p) => p.turn && p.turn.spin);
    /** @type {any[]} */
    this.shown = [];
    /** @type {Chosen | null} */
    this.chosen = null;
    /** @type {number | null} */
    this.followed = null;
    /** What a frame took besides the drawing, in milliseconds. */
    this.work = 0;
    /** What was drawn last: the size of the picture, and the height of the floor. */
    this.size = "";
    this.floor = 0;
    this.waiting = false;
    /** @type {{ course: Course, legs: number, time: Rational } | null} */
    this.now = null;
    this.#listen(callbacks);
    new ResizeObserver(() => this.refresh()).observe(box);
  }

  /**
   * How bodies are put together.
   * @param {DataLeaf[]} leaves
   */
  #build(leaves) {
    if (leaves === this.leaves) return;
    this.leaves = leaves;
    this.models = leaves.map((leaf) => leaf.parts.map((p) => Shapes.part(this.data, p)));
    this.sizes = this.models.map((parts) => Math.max(...parts.flatMap((p) => p.points.map((q) => Math.hypot(...q)))));
    this.shapes = leaves.map((leaf) => JSON.stringify(leaf.parts.map((p) => [p.solid, p.offset])));
  }

  /** @template T @param {T[]} all @returns {T[]} not more than a few thousand of them */
  #some(all) {
    const every = Math.ceil(all.length / 5000);
    return every <= 1 ? all : all.filter((_, i) => i % every === 0);
  }

  /** A colour for each family: what is named alike but for an index. */
  #families() {
    /** @type {Map<string, number>} */
    const families = new Map();
    const family = (/** @type {DataLeaf} */ leaf) => leaf.name.replace(/\[.*$/, "").replace(/[0-9]+$/, "");
    for (const leaf of this.data.leaves)
      if (!leaf.fixed && !families.has(family(leaf))) families.set(family(leaf), families.size);
    return this.data.leaves.map((leaf) => {
      if (leaf.absorbs) return [0.62, 0.45, 0.75, 0];
      if (leaf.fixed) return [0.58, 0.63, 0.69, 0];
      const color = Scene.palette[(families.get(family(leaf)) || 0) % Scene.palette.length];
      return [...color, 0];
    });
  }

  /**
   * The kind of that name, made when it is first asked for.
   * @param {string} name @param {() => Kind} make
   * @returns {Kind}
   */
  #kind(name, make) {
    const known = this.kinds.get(name);
    if (known) return known;
    const made = make();
    this.kinds.set(name, made);
    for (const object of made.objects) this.scene.add(object);
    this.#paint(made);
    return made;
  }

  /** @param {Kind} drawn */
  #paint(drawn) {
    if (drawn.edges && !drawn.edges.uniforms.own.value)
      drawn.edges.uniforms.color.value.set(this.dark ? 0x0a0d12 : 0x1b2430);
  }

  get dark() { return this.options.theme === "dark"; }

  /** @param {number} leaf */
  #body(leaf) {
    const { fixed, absorbs } = this.data.leaves[leaf];
    return this.#kind(`body ${fixed} ${absorbs} ${this.shapes[leaf]}`, () =>
      new Kind(Shapes.body(this.models[leaf]), {
        opacity: fixed ? 0.26 : 1, lineOpacity: fixed ? 0.35 : 0.75, stripes: absorbs, stripeSize: this.sizes[leaf] / 4,
      }));
  }

  /**
   * A feature that is open: names are plain, co-names are striped.
   * @param {number} leaf @param {DataSite} site @param {boolean} co
   */
  #open(leaf, [part, kind, index], co) {
    return this.#kind(`open ${co} ${part} ${kind} ${index} ${this.shapes[leaf]}`, () => {
      const size = this.sizes[leaf];
      return new Kind({ faces: Shapes.feature(this.models[leaf][part], kind, index, size) },
        { stripes: co, stripeSize: size / 5, flat: true, pull: true });
    });
  }

  /**
   * An outline that is seen through what is in front of it: of what holds a bond, or is selected.
   * @param {number} leaf @param {DataSite} site
   */
  #outline(leaf, [part, kind, index]) {
    return this.#kind(`outline ${part} ${kind} ${index} ${this.shapes[leaf]}`, () => {
      const size = this.sizes[leaf], model = this.models[leaf][part];
      const ball = new Shapes.Triangles();
      Shapes.ball(ball, Shapes.middle(Shapes.corners(model, kind, index)), 0.055 * size);
      return new Kind({ faces: ball, lines: Shapes.outline(model, kind, index, size) },
        { above: true, flat: true, ownLines: true, order: 5 });
    });
  }

  /** @param {number} leaf */
  #whole(leaf) {
    return this.#kind(`whole ${this.shapes[leaf]}`, () =>
      new Kind({ lines: Shapes.body(this.models[leaf]).lines }, { above: true, ownLines: true, lineOpacity: 0.7, order: 5 }));
  }

  #arrow() {
    return this.#kind("arrow", () => new Kind({ faces: Shapes.arrow() }, { order: 3 }));
  }

  /**
   * A colour for a channel: the same for all that may bind by it.
   * @param {string} name
   */
  #channel(name) {
    const color = new THREE.Color().setHSL(Channels.hue(name), 0.85, this.dark ? 0.62 : 0.5);
    return [color.r, color.g, color.b, 0];
  }

  /**
   * Shows the state after so many legs of a run, at a time.
   * @param {Course} course @param {number} legs @param {Rational} time
   */
  show(course, legs, time) {
    this.#build(course.leaves);
    this.now = { course, legs, time };
    this.refresh();
  }

  /** Draws when the browser is next ready to. */
  refresh() {
    if (this.waiting || !this.now) return;
    this.waiting = true;
    window.requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw() {
    const now = this.now, width = this.box.clientWidth, height = this.box.clientHeight;
    if (!now || width === 0 || height === 0) return;
    const began = performance.now();
    const bodies = now.course.bodiesAfter(now.legs, now.time);
    this.#goAlong(now.course, bodies);
    for (const kind of this.kinds.values()) kind.clear();
    this.#place(now.course, bodies);
    const radius = this.extent();
    this.orbit.place(width, height, radius);
    this.#surroundings(now);
    for (const kind of this.kinds.values()) kind.finish();
    this.#words(width, height);
    this.work = performance.now() - began;
    /** @type {string} */
    const size = `${width} ${height} ${window.devicePixelRatio}`;
    if (size !== this.size) {
      this.size = size;
      this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
      this.renderer.setSize(width, height, false);
    }
    this.renderer.render(this.scene, this.orbit.camera);
  }

  /** @param {Course} course @param {Moving[]} bodies */
  #goAlong(course, bodies) {
    if (this.followed === null) return;
    for (const body of bodies)
      for (const place of body.process.leaves)
        if (place.leaf === this.followed) this.orbit.lookAt(course.position(body, place).map(Rational.toNumber));
  }

  /** @param {Course} course @param {Moving[]} bodies */
  #place(course, bodies) {
    const target = this.orbit.target, data = this.data;
    let n = 0;
    for (const body of bodies) {
      const from = n;
      for (const place of body.process.leaves) {
        let shown = this.shown[n];
        if (!shown) this.shown[n] = shown = { leaf: 0, parts: [], matrix: new Float64Array(12), body, place };
        Object.assign(shown, { leaf: place.leaf, parts: this.models[place.leaf], body, place });
        course.place(body, place, target, shown.matrix);
        this.#body(place.leaf).push(shown.matrix, this.colors[place.leaf]);
        for (const channel of data.behaviours[place.behaviour].open) {
          const color = this.#channel(channel.channel);
          for (const site of channel.sites) this.#open(place.leaf, site, channel.co).push(shown.matrix, color);
        }
        n++;
      }
      for (const bond of body.process.bonds)
        for (const end of bond.ends) {
          const at = this.shown.slice(from, n).find((s) => s.leaf === end.leaf);
          if (at) this.#outline(end.leaf, end.site).push(at.matrix, this.dark ? [1, 1, 1, 0] : [0.05, 0.06, 0.1, 0]);
        }
      if (this.options.velocities) this.#pointer(body, this.shown[from], body.process.velocity, this.fastest, [0.15, 0.55, 0.95, 0]);
      if (this.options.spins && body.process.turn)
        this.#pointer(body, this.shown[from], body.process.turn.spin, this.widest, [0.95, 0.35, 0.65, 0]);
    }
    this.shown.length = n;
    const chosen = this.chosen;
    if (!chosen) return;
    const at = this.shown.find((s) => s.leaf === chosen.leaf);
    if (!at) return;
    const mark = this.dark ? [1, 0.85, 0.3, 0] : [0.85, 0.1, 0.3, 0];
    this.#whole(chosen.leaf).push(at.matrix, mark);
    const { part, kind, index } = chosen;
    if (part !== null && part !== undefined && kind && index !== null && index !== undefined)
      this.#outline(chosen.leaf, [part, kind, index]).push(at.matrix, mark);
  }

  /**
   * An arrow from the middle of a process, the longest of all a good part of the picture.
   * @param {Moving} body @param {any} shown @param {Vec} vec @param {number} most @param {number[]} color
   */
  #pointer(body, shown, vec, most, color) {
    const v = vec.map((t) => Rational.toNumber(Rational.of(t)));
    const long = Math.hypot(...v);
    if (!(long > 0) || !(most > 0) || this.data.leaves[shown.leaf].fixed) return;
    const length = (0.28 * this.orbit.distance * (0.15 + 0.85 * (long / most)));
    const x = Shapes.unit([v[0], v[1], v[2]]);
    const y = Shapes.unit(Shapes.cross(x, Math.abs(x[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0])), z = Shapes.cross(x, y);
    const m = shown.matrix, l = length;
    this.#arrow().push([m[0], m[1], m[2], l * x[0], l * y[0], l * z[0], l * x[1], l * y[1], l * z[1], l * x[2], l * y[2], l * z[2]], color);
  }

  /** @param {{ course: Course, legs: number, time: Rational }} now */
  #surroundings({ course, legs, time }) {
    const at = this.orbit.at.map(Rational.toNumber);
    this.marks.dark = this.dark;
    this.marks.ground(this.floor - at[1], at.map((x) => -x), this.orbit.distance, this.options.grid);
    const trails = [];
    if (this.options.trails)
      for (const shown of this.shown) {
        if (this.data.leaves[shown.leaf].fixed || trails.length >= 300) continue;
        trails.push({ points: course.trail(shown.leaf, legs, time, this.orbit.target), color: this.colors[shown.leaf] });
      }
    this.marks.trails(trails);
  }

  /** @param {number} width @param {number} height */
  #words(width, height) {
    const project = this.projector(width, height);
    this.marks.begin();
    for (const { text, at } of this.marks.numbers || []) {
      const p = project(at);
      if (p.seen && p.x > 8 && p.y > 8 && p.x < width - 8 && p.y < height - 8) this.marks.word(text, p, false);
    }
    const named = this.options.names ? this.shown.filter((s) => this.shown.length <= 60 || !this.data.leaves[s.leaf].fixed).slice(0, 200) : [];
    for (const shown of named) {
      const centre = Shapes.middle(shown.parts.map((/** @type {any} */ p) => p.centre));
      const p = project(Pick.toWorld(shown.matrix, centre));
      if (p.seen) this.marks.word(this.data.leaves[shown.leaf].name, p, true);
    }
    this.marks.end();
  }

  /**
   * From points relative to the target to pixels.
   * @param {number} width @param {number} height
   */
  projector(width, height) {
    const camera = this.orbit.camera;
    const m = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse.getInverse(camera.matrixWorld)).elements;
    return (/** @type {number[]} */ p) => {
      const row = (/** @type {number} */ i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i];
      const w = row(3);
      return { x: (0.5 + row(0) / w / 2) * width, y: (0.5 - row(1) / w / 2) * height, seen: w > 0 };
    };
  }

  /** How far what is shown reaches from the target. */
  extent() {
    let far = this.orbit.distance;
    for (const s of this.shown) far = Math.max(far, Math.hypot(s.matrix[0], s.matrix[1], s.matrix[2]) + this.sizes[s.leaf]);
    return far;
  }

  /** Sees all bodies: those that move, and what is fixed unless it is much larger. */
  fit() {
    if (!this.now) return;
    const { course, legs, time } = this.now;
    const zero = Motion.target({ n: [0n, 0n, 0n], d: 1n }), out = new Float64Array(12);
    /** @type {{ low: number[], high: number[], fixed: boolean }[]} */
    const all = [];
    for (const body of course.bodiesAfter(legs, time))
      for (const place of body.process.leaves) {
        course.place(body, place, zero, out);
        const points = this.models[place.leaf].flatMap((p) => p.points).map((p) => Pick.toWorld(out, p));
        const range = (/** @type {(...x: number[]) => number} */ f) => [0, 1, 2].map((i) => f(...points.map((p) => p[i])));
        all.push({ low: range(Math.min), high: range(Math.max), fixed: this.data.leaves[place.leaf].fixed });
      }
    const moving = all.filter((b) => !b.fixed);
    const box = (/** @type {typeof all} */ of) => ({
      low: [0, 1, 2].map((i) => Math.min(...of.map((b) => b.low[i]))),
      high: [0, 1, 2].map((i) => Math.max(...of.map((b) => b.high[i]))),
    });
    const size = (/** @type {{ low: number[], high: number[] }} */ b) => Math.hypot(...b.high.map((h, i) => h - b.low[i]));
    let seen = box(moving.length ? moving : all);
    const near = all.filter((b) => b.fixed && size(b) <= 3 * size(seen));
    if (moving.length && near.length) seen = box([...moving, ...near]);
    if (!seen.low.every(Number.isFinite)) return;
    this.floor = Math.min(seen.low[1], ...near.map((b) => b.low[1]));
    const aspect = this.box.clientWidth / Math.max(1, this.box.clientHeight) || 1;
    this.orbit.distance = Math.max(1e-6, 0.5 * size(seen)) / Math.sin((20 * Math.PI) / 180) / Math.min(1, aspect) * 0.92;
    this.orbit.lookAt(seen.low.map((l, i) => (l + seen.high[i]) / 2));
    this.refresh();
  }

  /** @param {{ [option: string]: any }} options */
  setOptions(options) {
    Object.assign(this.options, options);
    this.orbit.parallel = this.options.projection === "orthographic";
    for (const kind of this.kinds.values()) this.#paint(kind);
    this.refresh();
  }

  /** @param {number | null} leaf */
  follow(leaf) { this.followed = leaf; this.refresh(); }

  /** @param {Chosen | null} chosen */
  select(chosen) { this.chosen = chosen; this.refresh(); }

  camera() { return this.orbit.save(); }

  /** @param {{ [key: string]: any }} camera */
  setCamera(camera) {
    this.orbit.load(camera);
    this.options.projection = this.orbit.parallel ? "orthographic" : "perspective";
    this.refresh();
  }

  /** @param {{ onPick?: (found: Chosen | null) => void }} callbacks */
  #listen(callbacks) {
    let from = { x: 0, y: 0 };
    this.canvas.addEventListener("pointerdown", (e) => { from = { x: e.clientX, y: e.clientY }; });
    this.canvas.addEventListener("pointerup", (e) => {
      if (e.button !== 0 || Math.hypot(e.clientX - from.x, e.clientY - from.y) > 4) return;
      const box = this.canvas.getBoundingClientRect();
      const found = this.pick(e.clientX - box.left, e.clientY - box.top, e.pointerType === "touch" ? 16 : 8);
      if (callbacks.onPick) callbacks.onPick(found);
    });
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
    const hit = Pick.first(this.shown, [a.x, a.y, a.z], [b.x - a.x, b.y - a.y, b.z - a.z]);
    if (!hit) return null;
    const { kind, index } = Pick.feature(hit.shown, hit.part, hit.face, this.projector(width, height), x, y, near);
    return { leaf: hit.shown.leaf, part: hit.part, kind, index };
  }
}
