"use strict";

/**
 * What is chosen of a solid: a face, an edge (by its ends), a vertex, or what is wrong.
 * @typedef {{ face?: number, edge?: [number, number], vertex?: number, wrong?: number }} SolidSpot
 */

/** A solid in space: its faces and edges, their names, and what is wrong at its place. */
class SolidScene {
  /** @type {string | null} */
  static why = typeof THREE === "undefined" ? "this file was written without the library three.js, which draws it" : null;

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
    this.renderer = none;
    /** @type {Orbit} */
    this.orbit = none;
    /** @type {Overlay} */
    this.overlay = none;
    if (SolidScene.why) return;
    const context = SolidScene.#context(this.canvas);
    if (!context) {
      SolidScene.why = "this browser offers no WebGL here";
      return;
    }
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, context });
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

  /** @param {HTMLCanvasElement} canvas @returns {RenderingContext | null} */
  static #context(canvas) {
    try {
      return canvas.getContext("webgl", { alpha: true, antialias: true });
    } catch (_) {
      return null;
    }
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
    const flat = at.map((p) => new THREE.Vector2(p[(axis + 1) % 3], p[(axis + 2) % 3]));
    /** @type {number[][]} */
    const found = corners.length < 3 ? [] : THREE.ShapeUtils.triangulateShape(flat, []);
    return found.map((t) => t.map((i) => corners[i]));
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
    const geometry = (/** @type {number} */ points) => {
      const g = new THREE.BufferGeometry();
      g.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * points), 3));
      return g;
    };
    const faces = geometry(3 * this.triangles.length);
    faces.setAttribute("color", new THREE.BufferAttribute(new Float32Array(9 * this.triangles.length), 3));
    this.mesh = new THREE.Mesh(faces, new THREE.MeshBasicMaterial({
      vertexColors: THREE.VertexColors, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    }));
    this.lines = new THREE.LineSegments(geometry(2 * this.edges.length), new THREE.LineBasicMaterial());
    for (const drawn of [this.mesh, this.lines]) drawn.frustumCulled = false;
    this.scene = new THREE.Scene();
    this.scene.add(this.mesh, this.lines);
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
    const { orbit, renderer } = this, ratio = Math.min(2, window.devicePixelRatio || 1);
    renderer.setPixelRatio(ratio);
    renderer.setSize(width, height, false);
    this.places = this.corners.map((p) => p.map((x, i) => Rational.toNumber(Rational.sub(x, orbit.at[i]))));
    orbit.place(width, height, 4 * this.radius + Math.hypot(...(this.places[0] || [0])));
    this.#fill();
    renderer.render(this.scene, orbit.camera);
    this.#words(width, height, ratio);
  }

  #fill() {
    const { faces } = this.marked(), spot = this.chosen || {}, [vx, vy, vz] = this.orbit.direction;
    const position = this.mesh.geometry.attributes.position, color = this.mesh.geometry.attributes.color;
    const bad = [0.85, 0.25, 0.2], plain = [0.36, 0.62, 0.82];
    this.triangles.forEach(({ face, corners }, t) => {
      const at = corners.map((v) => this.places[v]), n = SolidScene.normal(at), long = Math.hypot(...n) || 1;
      const light = 0.55 + 0.45 * Math.abs((n[0] * (vx + 0.2) + n[1] * (vy + 0.35) + n[2] * vz) / long / 1.1);
      const base = spot.face === face ? SolidScene.gold : faces.has(face) ? bad : plain;
      at.forEach((p, k) => {
        position.setXYZ(3 * t + k, p[0], p[1], p[2]);
        color.setXYZ(3 * t + k, base[0] * light, base[1] * light, base[2] * light);
      });
    });
    const ends = this.lines.geometry.attributes.position;
    this.edges.forEach(([a, b], i) => {
      ends.setXYZ(2 * i, ...this.places[a]);
      ends.setXYZ(2 * i + 1, ...this.places[b]);
    });
    for (const attribute of [position, color, ends]) attribute.needsUpdate = true;
    this.lines.material.color.setRGB(...this.colors.line);
  }

  /** @param {number} width @param {number} height @returns {(p: number[]) => { x: number, y: number, depth: number }} */
  projector(width, height) {
    const { camera } = this.orbit, v = new THREE.Vector3();
    return (p) => {
      v.set(p[0], p[1], p[2]).project(camera);
      return { x: (0.5 + v.x / 2) * width, y: (0.5 - v.y / 2) * height, depth: v.z };
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
    overlay.axes(this.orbit.camera.matrixWorld.elements);
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
    const ray = new THREE.Raycaster();
    ray.setFromCamera({ x: (2 * x) / width - 1, y: 1 - (2 * y) / height }, this.orbit.camera);
    this.mesh.geometry.boundingSphere = null;
    const [hit] = ray.intersectObject(this.mesh);
    const front = hit ? project(hit.point.toArray()).depth : 1;
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
    return hit ? { face: this.triangles[Math.floor(hit.faceIndex)].face } : null;
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
    this.canvas.addEventListener("webglcontextrestored", () => this.refresh());
  }
}
