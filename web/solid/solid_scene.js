"use strict";

/**
 * What is chosen of a solid: a face, an edge (by its ends), a vertex, or what is wrong.
 * @typedef {{ face?: number, edge?: [number, number], vertex?: number, wrong?: number }} SolidSpot
 */

/** A solid in space: its faces and edges, their names, and what is wrong at its place. */
class SolidScene {
  /** @type {string | null} */
  static why = null;

  static program = {
    vertex: `
      uniform mat4 camera; in vec3 position; in vec4 color; out vec3 vColor;
      void main() { vColor = color.rgb; gl_Position = camera * vec4(position, 1.0); }`,
    // What is inside is seen through holes: it is grey, and darker.
    fragment: `
      in vec3 vColor; out vec4 color;
      void main() {
        float grey = dot(vColor, vec3(0.33));
        color = vec4(gl_FrontFacing ? vColor : mix(vec3(grey), vColor, 0.3) * 0.62, 1.0);
      }`,
  };

  /** Of what is chosen: red is what is wrong. */
  static gold = [0.95, 0.7, 0.12];

  /** @param {HTMLElement} box @param {SolidData} data @param {(spot: SolidSpot | null) => void} picked */
  constructor(box, data, picked) {
    this.box = box;
    this.data = data;
    this.picked = picked;
    this.shows = { faces: true, vertices: false };
    /** @type {SolidSpot | null} */
    this.chosen = null;
    this.corners = SolidScene.nearby(data.vertices.map(({ at }) => at.map(Rational.of)));
    /**
     * Relative to the target of the camera.
     * @type {number[][]}
     */
    this.places = [];
    this.edges = SolidScene.edgesOf(data);
    this.waiting = false;
    this.colors = Colors.theme(false);
    this.radius = 1;
    /**
     * Of each triangle, its face and its corners.
     * @type {{ face: number, corners: number[] }[]}
     */
    this.triangles = [];
    this.canvas = document.createElement("canvas");
    const none = /** @type {any} */ (null);
    /** @type {Gl} */
    this.gl = none;
    /** @type {Orbit} */
    this.orbit = none;
    /** @type {Overlay} */
    this.overlay = none;
    /** @type {Store} */
    this.faces = none;
    /** @type {Kind} */
    this.lines = none;
    const gl = Gl.on(this.canvas, () => this.refresh());
    if (!gl) {
      SolidScene.why = "this browser offers no WebGL 2 here";
      return;
    }
    this.gl = gl;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label",
      "The solid in space. Keys: w a s d turn, with shift they move, z and shift z zoom. All that is seen is told beside it.");
    Object.assign(this.canvas.style,
      { position: "absolute", inset: "0", width: "100%", height: "100%", touchAction: "none" });
    box.append(this.canvas);
    this.orbit = new Orbit(this.canvas, () => this.refresh());
    this.overlay = new Overlay(box);
    this.#build();
    this.#listen();
    new ResizeObserver(() => this.refresh()).observe(box);
  }

  /**
   * The same points about the first of them, in a unit that makes them about 1 wide: then floats tell them apart
   * wherever they are, and however small the solid is.
   * @param {Rational[][]} points
   */
  static nearby(points) {
    const about = points.map((p) => p.map((x, i) => Rational.sub(x, points[0][i])));
    const bits = (/** @type {bigint} */ n) => (n < 0n ? -n : n).toString(2).length;
    const sizes = about.flat().filter((x) => x.n !== 0n).map((x) => bits(x.n) - bits(x.d));
    const power = sizes.reduce((a, b) => Math.max(a, b), -Infinity);
    if (!Number.isFinite(power)) return about;
    const unit = Rational.make(power < 0 ? 2n ** BigInt(-power) : 1n, power > 0 ? 2n ** BigInt(power) : 1n);
    return about.map((p) => p.map((x) => Rational.mul(x, unit)));
  }

  /**
   * Each edge of a face once, by its ends.
   * @param {SolidData} data @returns {[number, number][]}
   */
  static edgesOf(data) {
    /** @type {Map<string, [number, number]>} */
    const all = new Map();
    for (const { corners } of data.faces)
      corners.forEach((v, i) => {
        const w = corners[(i + 1) % corners.length], a = Math.min(v, w), b = Math.max(v, w);
        if (a !== b) all.set(`${a} ${b}`, [a, b]);
      });
    return [...all.values()];
  }

  /**
   * Triangles of a face, as it is seen along the axis that it is turned to the most.
   * @param {number[]} corners
   */
  #triangles(corners) {
    const at = corners.map((v) => this.corners[v].map(Rational.toNumber)), n = SolidScene.normal(at);
    const axis = [0, 1, 2].reduce((best, i) => (Math.abs(n[i]) > Math.abs(n[best]) ? i : best), 0);
    const flat = at.map((p) => /** @type {[number, number]} */ ([p[(axis + 1) % 3], p[(axis + 2) % 3]]));
    return Polygon.triangles(flat).map((t) => t.map((i) => corners[i]));
  }

  /**
   * Newell's: of any closed line, twice the area that it goes around.
   * @param {number[][]} at
   */
  static normal(at) {
    const n = [0, 0, 0];
    at.forEach((p, i) => {
      const q = at[(i + 1) % at.length];
      for (let k = 0; k < 3; k++) {
        const [a, b] = [(k + 1) % 3, (k + 2) % 3];
        n[k] += (p[a] - q[a]) * (p[b] + q[b]);
      }
    });
    return n;
  }

  #build() {
    this.triangles = this.data.faces.flatMap(({ corners }, face) =>
      this.#triangles(corners).map((t) => ({ face, corners: t })));
    const { position, color } = Gl.at;
    this.faces = new Store(new Float32Array(18 * this.triangles.length), [[position, 3], [color, 3]]);
    this.gl.add({
      mesh: new Mesh([this.faces]), order: 0, visible: true,
      paint: { program: SolidScene.program, uniforms: {}, both: true, offset: [1, 1] },
    });
    this.lines = new Kind({ lines: [0, 0, 0, 0, 0, 0] }, { line: 1.3 });
    this.lines.push([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], [0, 0, 0, 0]);
    this.lines.finish();
    this.gl.add(...this.lines.things);
  }

  /** @param {string} theme */
  setTheme(theme) {
    this.colors = Colors.theme(theme === "dark");
    this.refresh();
  }

  /** @param {SolidSpot | null} spot */
  choose(spot) {
    this.chosen = spot;
    this.refresh();
  }

  /** Sees all of it. */
  fit() {
    if (SolidScene.why || this.corners.length === 0) return;
    const ends = [0, 1, 2].map((i) => {
      const all = this.corners.map((p) => p[i]);
      const least = all.reduce((a, b) => (Rational.cmp(a, b) <= 0 ? a : b));
      const most = all.reduce((a, b) => (Rational.cmp(a, b) >= 0 ? a : b));
      const middle = Rational.mul(Rational.add(least, most), Rational.make(1n, 2n));
      return { middle, long: Rational.toNumber(Rational.sub(most, least)) };
    });
    const radius = Math.hypot(...ends.map((e) => e.long)) / 2 || 1;
    this.radius = radius;
    const narrow = Math.min(1, this.box.clientWidth / Math.max(1, this.box.clientHeight));
    this.orbit.stand(ends.map((e) => e.middle), (3.2 * radius) / Math.max(0.3, narrow));
  }

  refresh() {
    if (this.waiting || SolidScene.why) return;
    this.waiting = true;
    window.requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  /** What is chosen or wrong, by what it is. */
  marked() {
    const { wrong } = this.data, spot = this.chosen || {};
    const all = spot.wrong !== undefined ? [wrong[spot.wrong]] : wrong;
    const faces = new Set(all.flatMap((w) => w.faces));
    return { all, faces };
  }

  draw() {
    const width = this.box.clientWidth, height = this.box.clientHeight;
    if (width === 0 || height === 0) return;
    const { orbit, gl } = this, ratio = Math.min(2, window.devicePixelRatio || 1);
    gl.size(width, height, ratio);
    this.places = this.corners.map((p) => p.map((x, i) => Rational.toNumber(Rational.sub(x, orbit.at[i]))));
    orbit.place(width, height, 4 * this.radius + Math.hypot(...(this.places[0] || [0])));
    Kind.shared.size.value = [width, height];
    Kind.shared.near.value = orbit.parallel ? 0 : 1;
    this.#fill();
    gl.draw(orbit.camera.clip);
    this.#words(width, height, ratio);
  }

  #fill() {
    const { faces } = this.marked(), spot = this.chosen || {}, [vx, vy, vz] = this.orbit.direction;
    const { data } = this.faces;
    const bad = [0.85, 0.25, 0.2], plain = [0.36, 0.62, 0.82];
    this.triangles.forEach(({ face, corners }, t) => {
      const at = corners.map((v) => this.places[v]), n = SolidScene.normal(at), long = Math.hypot(...n) || 1;
      const light = 0.55 + 0.45 * Math.abs((n[0] * (vx + 0.2) + n[1] * (vy + 0.35) + n[2] * vz) / long / 1.1);
      const base = spot.face === face ? SolidScene.gold : faces.has(face) ? bad : plain;
      at.forEach((p, k) => {
        data.set(p, 18 * t + 6 * k);
        data.set(base.map((c) => c * light), 18 * t + 6 * k + 3);
      });
    });
    this.faces.changed = true;
    this.lines.ink.value = this.colors.line;
    this.lines.draw(this.edges.flatMap(([a, b]) => [...this.places[a], ...this.places[b]]));
  }

  /** @param {number} width @param {number} height @returns {(p: number[]) => { x: number, y: number, depth: number }} */
  projector(width, height) {
    const { camera } = this.orbit;
    return (p) => {
      const [x, y, z, w] = camera.at(p);
      return { x: (0.5 + x / w / 2) * width, y: (0.5 - y / w / 2) * height, depth: z / w };
    };
  }

  /**
   * The mean of the corners.
   * @param {number[]} corners
   */
  middle(corners) {
    return [0, 1, 2].map((i) => corners.reduce((s, v) => s + this.places[v][i], 0) / Math.max(1, corners.length));
  }

  /** @param {number} width @param {number} height @param {number} ratio */
  #words(width, height, ratio) {
    const { overlay, data, colors } = this, spot = this.chosen || {};
    overlay.begin(width, height, ratio, colors);
    const project = this.projector(width, height), pen = overlay.pen;
    overlay.axes(this.orbit.camera.world);
    const red = Colors.css([0.8, 0.1, 0.1]), gold = Colors.css(SolidScene.gold);
    const stroke = (/** @type {[number, number]} */ [a, b], /** @type {string} */ color) => {
      const p = project(this.places[a]), q = project(this.places[b]);
      pen.strokeStyle = color;
      pen.lineWidth = 4;
      pen.lineCap = "round";
      pen.beginPath();
      pen.moveTo(p.x, p.y);
      pen.lineTo(q.x, q.y);
      pen.stroke();
    };
    const ring = (/** @type {number} */ v, /** @type {string} */ color) => {
      const p = project(this.places[v]);
      pen.strokeStyle = color;
      pen.lineWidth = 3;
      pen.beginPath();
      pen.arc(p.x, p.y, 7, 0, 2 * Math.PI);
      pen.stroke();
    };
    /** @type {Map<string, { at: number[], badges: string[] }>} */
    const badges = new Map();
    for (const wrong of this.marked().all) {
      for (const edge of wrong.edges) stroke(edge, red);
      for (const v of wrong.vertices) ring(v, red);
      const at = wrong.vertices.length ? this.places[wrong.vertices[0]] : wrong.edges.length ? this.middle(wrong.edges[0])
        : wrong.faces.length ? this.middle(data.faces[wrong.faces[0]].corners) : null;
      if (!at) continue;
      const there = badges.get(at.join()) || { at, badges: [] };
      badges.set(at.join(), there);
      there.badges.push(wrong.badge);
    }
    for (const { at, badges: told } of badges.values()) {
      const p = project(at);
      overlay.word(told.join(", "), p.x + 11, p.y - 11,
        { size: 13, strong: true, color: red, align: "left", force: true });
    }
    if (spot.edge) stroke(spot.edge, gold);
    if (spot.vertex !== undefined) ring(spot.vertex, gold);
    const turnedTo = data.faces.map(({ corners }) => this.#turnedTo(corners));
    const behind = new Set(data.faces.flatMap(({ corners }) => corners));
    data.faces.forEach(({ corners }, i) => turnedTo[i] && corners.forEach((v) => behind.delete(v)));
    data.faces.forEach(({ name, corners }, i) => {
      if (!turnedTo[i] || (!this.shows.faces && spot.face !== i)) return;
      const p = project(this.middle(corners));
      overlay.word(name, p.x, p.y, { size: 12, strong: spot.face === i, color: colors.text, force: spot.face === i });
    });
    data.vertices.forEach(({ name }, v) => {
      const named = spot.vertex === v || (spot.edge && spot.edge.includes(v));
      if (!named && (!this.shows.vertices || behind.has(v))) return;
      const p = project(this.places[v]);
      overlay.word(name, p.x, p.y - 12, { size: 11, color: colors.quiet, strong: named, force: named });
    });
  }

  /**
   * Whether a face shows its outside.
   * @param {number[]} corners
   */
  #turnedTo(corners) {
    const n = SolidScene.normal(corners.map((v) => this.places[v])), d = this.orbit.direction;
    const middle = this.middle(corners);
    const to = this.orbit.parallel ? d : d.map((x, k) => x * this.orbit.distance - middle[k]);
    return corners.length > 2 && n[0] * to[0] + n[1] * to[1] + n[2] * to[2] > 0;
  }

  /**
   * What is seen at a pixel: a vertex before an edge before a face, unless it is hidden.
   * @param {number} x @param {number} y @returns {SolidSpot | null}
   */
  pick(x, y) {
    const width = this.box.clientWidth, height = this.box.clientHeight, project = this.projector(width, height);
    const hit = this.#hit(this.orbit.camera.ray((2 * x) / width - 1, 1 - (2 * y) / height));
    const front = hit ? project(hit.at).depth : 1;
    const near = (/** @type {number} */ depth) => depth <= front + 2e-3 * (1 - front) + 1e-6;
    const places = this.places.map(project);
    let best = -1, least = 10;
    places.forEach((p, v) => {
      const d = Math.hypot(p.x - x, p.y - y);
      if (d < least && near(p.depth)) [best, least] = [v, d];
    });
    if (best >= 0) return { vertex: best };
    least = 6;
    /** @type {[number, number] | null} */
    let edge = null;
    for (const [a, b] of this.edges) {
      const p = places[a], q = places[b], dx = q.x - p.x, dy = q.y - p.y;
      const t = Math.max(0, Math.min(1, ((x - p.x) * dx + (y - p.y) * dy) / (dx * dx + dy * dy || 1)));
      const d = Math.hypot(p.x + t * dx - x, p.y + t * dy - y);
      if (d < least && near(p.depth + t * (q.depth - p.depth))) [edge, least] = [[a, b], d];
    }
    if (edge) return { edge };
    return hit ? { face: hit.face } : null;
  }

  /**
   * The first face that a ray meets, and where.
   * @param {{ from: Triple, way: Triple }} ray
   */
  #hit({ from, way }) {
    const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let best = -1, first = Infinity;
    for (const { face, corners: [i, j, k] } of this.triangles) {
      const a = this.places[i];
      const [p, q, r] = [this.places[j], this.places[k], from].map((b) => /** @type {Triple} */ (b.map((x, c) => x - a[c])));
      const across = Camera.cross(way, q), size = dot(p, across), aside = Camera.cross(r, p);
      const u = dot(r, across) / size, v = dot(way, aside) / size, t = dot(q, aside) / size;
      // Where the ray is along the triangle, these are no numbers, or infinite.
      if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < first) [best, first] = [face, t];
    }
    return best < 0 ? null : { face: best, at: from.map((x, c) => x + first * way[c]) };
  }

  #listen() {
    let from = { x: 0, y: 0 };
    const at = (/** @type {PointerEvent} */ e) => {
      const box = this.canvas.getBoundingClientRect();
      return { x: e.clientX - box.left, y: e.clientY - box.top };
    };
    this.canvas.addEventListener("pointerdown", (e) => {
      from = at(e);
    });
    this.canvas.addEventListener("pointerup", (e) => {
      const to = at(e);
      if (e.button === 0 && Math.hypot(to.x - from.x, to.y - from.y) <= 4) this.picked(this.pick(to.x, to.y));
    });
  }
}
