"use strict";

/**
 * The bodies of a state, drawn in space.
 *
 * @typedef {{ width: number, height: number, ratio: number, background: string, legend: boolean, bar: boolean, clock: boolean,
 *   axes: boolean }} Composition  A picture for a file: its size in pixels of the page, how many of its pixels are in one,
 *   what is behind all, and what is written on it.
 *
 * `Scene.why` tells why nothing can be drawn, if so: then the rest of the page does without.
 */
class Scene {
  /** @type {string | null} */
  static why = null;

  /** @param {HTMLElement} box @param {PageData} data @param {{ onPick?: (found: Chosen | null) => void }} callbacks */
  constructor(box, data, callbacks) {
    this.box = box;
    this.data = data;
    this.callbacks = callbacks;
    /** @type {{ [option: string]: any }} */
    this.options = {
      names: false, velocities: false, spins: false, trails: false, grid: true, legend: true, marks: true, projection: "perspective",
      up: "y", theme: "light",
    };
    /** @type {number | null} */
    this.followed = null;
    /** What a frame took besides the drawing by the graphics card, in milliseconds. */
    this.work = 0;
    this.waiting = false;
    this.fitted = false;
    /** The size of the picture into which all bodies were last brought. */
    this.shape = "";
    /** Whether the camera was moved by hand since all bodies were last brought into view. */
    this.moved = false;
    /** Whether the run is played. */
    this.playing = false;
    /**
     * What was shown when it was last looked whether bodies have left the picture.
     * @type {{ course: Course, legs: number, time: Rational } | null}
     */
    this.looked = null;
    /**
     * How high the floor is.
     * @type {Rational}
     */
    this.floorAt = Rational.zero;
    /** The middle of what moves in the whole run. */
    this.heart = [Rational.zero, Rational.zero, Rational.zero];
    /** @type {Course | null} of which walls are known */
    this.course = null;
    /** @type {ReturnType<typeof Walls.find>} */
    this.walls = Object.assign(new Map(), { shared: new Set() });
    /**
     * Of these, those that are not around others by themselves; where others move in the run; and from where both are told.
     * @type {{ boxes: Box[], places: number[][], base: bigint[], sight: string }}
     */
    this.slabs = { boxes: [], places: [], base: [0n, 0n, 0n], sight: "" };
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
    /** @type {Gl} */
    this.gl = none;
    /** @type {Orbit} */
    this.orbit = none;
    /** @type {Bodies} */
    this.bodies = none;
    /** @type {Marks} */
    this.marks = none;
    /** @type {Ghosts} */
    this.ghosts = none;
    /** What is marked, if marks are wanted; and bodies of another run. */
    this.marking = Marked.none;
    /** @type {Ghost[]} */
    this.others = [];
    /**
     * How the picture is drawn for a file, while it is.
     * @type {Composition | null}
     */
    this.composed = null;
    const gl = Gl.on(this.canvas, () => this.refresh());
    if (!gl) {
      Scene.why = "this browser offers no WebGL 2 here";
      return;
    }
    this.gl = gl;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-roledescription", "scene");
    this.canvas.setAttribute("aria-label",
      "The bodies in space. Keys: w a s d turn, with shift they move, z and shift z zoom. " +
      "All that is seen is told in Bodies.");
    Object.assign(this.canvas.style,
      { position: "absolute", inset: "0", width: "100%", height: "100%", touchAction: "none" });
    box.append(this.canvas);
    this.orbit = new Orbit(this.canvas, () => this.refresh());
    this.bodies = new Bodies(data, gl);
    this.marks = new Marks(this, box);
    this.ghosts = new Ghosts(data, this.bodies, gl);
    this.#listen();
    new ResizeObserver(() => {
      if (this.fitted && this.shape !== `${box.clientWidth} ${box.clientHeight}`) this.restart();
      this.refresh();
    }).observe(box);
  }

  get dark() { return this.options.theme === "dark"; }

  /**
   * Shows the state after so many legs of a run, at a time.
   * @param {Course} course @param {number} legs @param {Rational} time
   */
  show(course, legs, time) {
    this.now = { course, legs, time };
    if (!Scene.why && this.bodies.setLeaves(course.leaves)) this.marks.learn();
    if (!Scene.why && course !== this.course) this.#around(course);
    this.refresh();
  }

  /**
   * What is a wall in a run, and the middle of what moves in it.
   * @param {Course} course
   */
  #around(course) {
    const first = course.bodiesAt(Rational.zero), { base, based } = this.#near(course, first);
    const here = Frame.boxes(this.bodies, course, first, base), walls = Walls.find(this.bodies, here);
    const same = JSON.stringify([...walls]) === JSON.stringify([...this.walls]);
    if (!same || course.leaves !== this.course?.leaves) this.bodies.setWalls(walls);
    const moving = here.concat(this.#later(course, base)).filter((b) => !b.fixed);
    const { low, high } = Frame.range((moving.length ? moving : here).flatMap((b) => [b.low, b.high]));
    this.heart = low.map((l, i) => based((l + high[i]) / 2, i));
    this.walls = walls;
    this.course = course;
    const every = Math.ceil(moving.length / 100);
    this.slabs = {
      boxes: here.filter((b) => walls.get(b.leaf) === null), places: moving.filter((_, i) => i % every === 0).map(Walls.middle), base, sight: "",
    };
  }

  /** Cuts away what would hide something that moves in the run. */
  #cut() {
    const { orbit, slabs: { boxes, places, base, sight } } = this;
    const now = JSON.stringify([orbit.direction, orbit.distance, orbit.parallel, orbit.at.map(Rational.text)]);
    if (boxes.length === 0 || now === sight) return;
    this.slabs.sight = now;
    const { direction, distance, parallel } = orbit;
    const target = orbit.at.map((x, i) => Rational.toNumber(Rational.sub(x, { n: base[i], d: 1n })));
    const eye = target.map((x, i) => x + direction[i] * distance), far = direction.map((x) => 1e3 * distance * x);
    this.bodies.setCut(Walls.hiding(this.bodies, boxes, places, (at) => (parallel ? far : eye.map((x, i) => x - at[i]))));
  }

  /**
   * So far from the origin that floats from there would lose what is between bodies, one counts from a body.
   * @param {Course} course @param {Moving[]} present
   */
  #near(course, present) {
    const first = present.length ? course.position(present[0], present[0].process.leaves[0]) : [];
    const far = first.some((x) => Math.abs(Rational.toNumber(x)) > 1e6);
    const base = far ? first.map((x) => x.n / x.d) : [0n, 0n, 0n];
    const based = (/** @type {number} */ x, /** @type {number} */ i) =>
      Rational.add({ n: base[i], d: 1n }, Rational.fromNumber(x));
    return { far, base, based };
  }

  /**
   * Where all that moves is at some instants of a run.
   * @param {Course} course @param {bigint[]} base
   */
  #later(course, base) {
    const instants = course.leaves.length > 500 ? [0, 4, 8] : [0, 1, 2, 3, 4, 5, 6, 7, 8];
    return instants.flatMap((i) => {
      const at = Rational.mul(course.duration, Rational.make(BigInt(i), 8n));
      return Frame.boxes(this.bodies, course, course.bodiesAt(at), base).filter((b) => !b.fixed);
    });
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

  /** How large the picture is, and how many of its pixels are in one of the page. */
  get frame() {
    if (this.composed) return this.composed;
    return { width: this.box.clientWidth, height: this.box.clientHeight, ratio: Math.min(2, window.devicePixelRatio || 1) };
  }

  /**
   * A picture of its own, with all words. Afterwards, the scene is to be restored.
   * @param {Composition} form @returns {HTMLCanvasElement}
   */
  compose(form) {
    if (form.background === "white" && this.dark) this.bodies.setTheme(false);
    this.composed = form;
    this.draw();
    const { width, height } = this.canvas, made = document.createElement("canvas");
    Object.assign(made, { width, height });
    const pen = /** @type {CanvasRenderingContext2D} */ (made.getContext("2d"));
    if (form.background !== "transparent") {
      pen.fillStyle = form.background === "white" ? "#ffffff" : getComputedStyle(document.documentElement).getPropertyValue("--panel");
      pen.fillRect(0, 0, width, height);
    }
    pen.drawImage(this.canvas, 0, 0);
    pen.drawImage(this.marks.overlay.canvas, 0, 0);
    return made;
  }

  /** Draws for the page again. */
  restore() {
    this.composed = null;
    this.bodies.setTheme(this.dark);
    this.draw();
  }

  /** Draws now. */
  draw() {
    const now = this.now, { width, height } = this.frame;
    if (!now || width === 0 || height === 0) return;
    const began = performance.now();
    const { orbit, bodies, options } = this;
    const present = now.course.bodiesAfter(now.legs, now.time);
    this.#goAlong(now.course, present);
    const marking = this.marked;
    bodies.mark(marking);
    this.#cut();
    bodies.update(now.course, present, orbit.target);
    orbit.place(width, height, this.#extent());
    this.marks.place(now);
    this.#shared(width, height);
    bodies.arrows(/** @type {any} */ (options), orbit.distance);
    if (this.pointer && !this.composed) this.#hover(this.pointer);
    if (!bodies.last.bodies) bodies.update(now.course, present, orbit.target);
    bodies.finish();
    this.ghosts.draw([...marking.before, ...marking.gone, ...this.others], orbit.target);
    this.marks.words(width, height);
    this.work = performance.now() - began;
    this.gl.shade(Kind.shared.shade.value, Shaders.depth);
    this.gl.draw(orbit.camera.clip);
    if (this.looked === now || this.composed) return;
    this.looked = now;
    if (this.fitted && !orbit.flight && this.followed === null && this.#lost(width, height)) this.restart();
  }

  /**
   * Whether what is not fixed has left the picture: a body, or of a run that is played all of them.
   * @param {number} width @param {number} height
   */
  #lost(width, height) {
    let out = false;
    for (const here of this.#within(width, height)) {
      if (here === this.playing) return !here;
      out ||= !here;
    }
    return out;
  }

  /**
   * Whether each body that is not fixed is in the picture.
   * @param {number} width @param {number} height @returns {Generator<boolean>}
   */
  *#within(width, height) {
    const { byLeaf, leaves } = this.bodies, project = this.projector(width, height);
    for (const { leaf, matrix: m } of byLeaf.values()) {
      if (leaves[leaf].fixed) continue;
      const { x, y, seen } = project([m[0], m[1], m[2]]);
      yield seen && x > 0 && x < width && y > 0 && y < height;
    }
  }

  /** Whether a body that is not fixed is in the picture. */
  inView() {
    if (Scene.why) return true;
    this.draw();
    const { width, height } = this.frame;
    for (const here of this.#within(width, height)) if (here) return true;
    return false;
  }

  /** What is marked now. */
  get marked() { return this.options.marks ? this.marking : Marked.none; }

  /**
   * Marks bodies and changes.
   * @param {Marking} marking
   */
  mark(marking) {
    this.marking = marking;
    this.refresh();
  }

  /** @param {number} width @param {number} height */
  #shared(width, height) {
    this.gl.size(width, height, this.frame.ratio);
    const { orbit } = this;
    Kind.shared.size.value = [width, height];
    Kind.shared.near.value = orbit.parallel ? 0 : 1;
    Kind.shared.up.value = orbit.way(0, 1, 0);
    Kind.shared.light.value = orbit.way(0.33, 0.8, 0.5);
    const eye = orbit.direction;
    Kind.shared.eye.value = orbit.parallel ? [...eye, 0] : [...eye.map((x) => x * orbit.distance), 1];
    this.bodies.heart.value = [...this.heart.map((x, i) => Rational.toNumber(Rational.sub(x, orbit.at[i]))), 0];
    this.#shade();
  }

  /** Shadows are straight below what has them, as far as the floor is seen. */
  #shade() {
    const { orbit, bodies } = this, { upright, distance } = orbit, wide = 1.7 * distance, { shared } = Kind;
    const { up, floor: [first, second] } = upright, high = 2 * Math.max(wide, this.#extent());
    const m = new Array(16).fill(0);
    m[4 * first] = 1 / wide;
    m[4 * second + 1] = 1 / wide;
    m[4 * up + 2] = -1 / high;
    m[15] = 1;
    shared.shade.value = m;
    const soft = Math.max(0.003 * wide, Math.min(0.03 * wide, 0.18 * bodies.usual));
    const reach = [first, second].map((axis) =>
      bodies.shown.reduce((far, s) => Math.max(far, Math.abs(s.matrix[axis]) + s.size), 0) + 2 * soft);
    shared.span.value = [wide, high, ...reach.map((x) => Math.min(0.98, x / wide))];
    shared.soft.value = soft;
    shared.shadow.value = 0.3;
  }

  /** @param {Course} course @param {Moving[]} present */
  #goAlong(course, present) {
    if (this.followed === null || this.orbit.flight) return;
    for (const body of present)
      for (const place of body.process.leaves)
        if (place.leaf === this.followed) this.orbit.goTo(course.position(body, place));
  }

  /**
   * From points relative to the target to pixels.
   * @param {number} width @param {number} height
   */
  projector(width, height) {
    const { camera } = this.orbit;
    return (/** @type {number[]} */ p) => {
      const [x, y, z, w] = camera.at(p);
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

  /**
   * What there is to see: bodies that move, and what is fixed unless it is much larger; at first, those of the whole run;
   * what reasons name, and what is gone, where it was last; and a whole place near them, from which they are told.
   * @param {{ course: Course, legs: number, time: Rational }} now
   */
  #seen(now) {
    const { course, legs, time } = now;
    const present = course.bodiesAfter(legs, time);
    const { far, base, based } = this.#near(course, present);
    const { lit, before, gone } = this.marking, matters = new Set([...lit, ...(course.legs[legs - 1]?.label.leaves || [])]);
    const outlines = [...before, ...gone].flatMap((ghost) =>
      Frame.boxes(this.bodies, ghost.course, [ghost.body], base).filter((b) => b.leaf === ghost.place.leaf));
    const here = Frame.boxes(this.bodies, course, present, base).concat(outlines);
    let seen = Frame.whole(here, this.walls, matters);
    const later = Frame.whole(this.fitted ? here : here.concat(this.#later(course, base)), this.walls, matters);
    if (!seen || !later) return null;
    if (later.size < 4 * seen.size) seen = later;
    return { seen, far, based };
  }

  /**
   * Puts the floor below what there is to see.
   * @param {{ seen: { low: number[] }, based: (x: number, i: number) => Rational }} of
   * @param {number} distance from which it is seen
   */
  #level({ seen, based }, distance) {
    const { lead, power } = Floor.round(distance / 9), step = lead * 10 ** power, { up } = this.orbit.upright;
    this.floorAt = based(Math.floor(seen.low[up] / step + 1e-6) * step, up);
  }

  /** Another start is shown: its bodies are brought into view, unless the camera was moved by hand. */
  restart() {
    if (this.moved) return;
    this.fitted = false;
    this.fit();
  }

  /** Sees all bodies. */
  fit() {
    const of = this.now && !Scene.why ? this.#seen(this.now) : null;
    if (!of) return;
    this.moved = false;
    const { seen, far, based } = of;
    const { clientWidth: width, clientHeight: height } = this.box;
    this.shape = `${width} ${height}`;
    const { at, distance } = Frame.fit(seen.points, this.orbit, width, height, this.marks.taken(width, height));
    this.#level(of, distance);
    this.orbit.usual = distance;
    this.marks.fresh = true;
    if (far) this.orbit.stand(at.map(based), distance);
    else this.orbit.fly(at, distance, this.still.matches || !this.fitted);
    this.fitted = true;
    this.refresh();
  }

  /** @param {{ [option: string]: any }} options */
  setOptions(options) {
    const dark = this.dark;
    Object.assign(this.options, options);
    if (Scene.why) return;
    this.orbit.parallel = this.options.projection === "orthographic";
    if (this.options.up !== this.orbit.up) {
      this.orbit.up = this.options.up;
      this.fitted = false;
      this.fit();
    }
    if (dark !== this.dark) this.bodies.setTheme(this.dark);
    this.refresh();
  }

  /** More is known of the document. */
  learn() {
    this.bodies.learn();
    this.marks.learn();
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

  /** Which axis points up, how high the floor is, from where one looks, and where the legend is, for tests. */
  look() {
    const { up, direction } = this.orbit;
    return { up, floor: Rational.text(this.floorAt), from: direction, ...this.marks.legend };
  }

  /**
   * What is at a point of space, for tests: its pixel, the colour there, and the body that is picked.
   * @param {number[]} point
   */
  sight(point) {
    const width = this.box.clientWidth, height = this.box.clientHeight;
    this.draw();
    const at = this.orbit.at.map(Rational.toNumber);
    const { x, y } = this.projector(width, height)(point.map((c, i) => c - at[i]));
    const { gl } = this.gl, color = new Uint8Array(4), scale = this.canvas.width / width;
    gl.readPixels(Math.round(x * scale), Math.round((height - y) * scale), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, color);
    const found = this.pick(x, y);
    return { at: [x, y], color: [...color], name: found && this.bodies.leaves[found.leaf].name };
  }

  /** @param {{ [key: string]: any }} camera */
  setCamera(camera) {
    if (Scene.why) return;
    this.orbit.load(camera);
    this.moved = true;
    this.fitted = this.options.up === this.orbit.up;
    this.options.up = this.orbit.up;
    const of = !this.fitted && this.now ? this.#seen(this.now) : null;
    if (of) this.#level(of, this.orbit.distance);
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
      else this.moved = true;
    });
    for (const event of ["wheel", "keydown"])
      this.canvas.addEventListener(event, () => { this.moved = true; }, { passive: true });
    this.canvas.addEventListener("pointerleave", () => point(null));
    this.canvas.addEventListener("pointercancel", () => { held = 0; });
    this.canvas.addEventListener("pointerup", (e) => {
      const to = at(e), many = held > 1;
      held = Math.max(0, held - 1);
      if (e.button !== 0 || many || Math.hypot(to.x - from.x, to.y - from.y) > 4) return;
      const found = this.pick(to.x, to.y, e.pointerType === "touch" ? 16 : 8);
      if (this.callbacks.onPick) this.callbacks.onPick(found);
    });
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
    const { width, height } = this.frame;
    const { from, way } = this.orbit.camera.ray((2 * x) / width - 1, 1 - (2 * y) / height);
    const hit = Pick.first(this.bodies.shown, from, way);
    if (!hit) return null;
    const { kind, index } = Pick.feature(hit.shown, hit.part, hit.face, this.projector(width, height), x, y, near);
    return { leaf: hit.shown.leaf, part: hit.part, kind, index };
  }
}
