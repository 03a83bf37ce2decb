"use strict";

/** What stands around the bodies: the floor with its numbers, the axes, names, and where bodies have been. */
class Marks {
  /** @param {any} scene of three.js @param {HTMLElement} box */
  constructor(scene, box) {
    this.scene = scene;
    this.labels = document.createElement("div");
    this.labels.setAttribute("aria-hidden", "true");
    Object.assign(this.labels.style, { position: "absolute", inset: "0", overflow: "hidden", pointerEvents: "none" });
    box.append(this.labels);
    /** @type {HTMLElement[]} */
    this.spare = [];
    this.used = 0;
    this.floor = this.#lines(0.35);
    this.axes = this.#lines(1);
    this.paths = this.#lines(0.8);
    this.dark = false;
  }

  /** @param {number} opacity */
  #lines(opacity) {
    const geometry = new THREE.BufferGeometry();
    const material = new THREE.LineBasicMaterial({ vertexColors: THREE.VertexColors, transparent: opacity < 1, opacity });
    const object = new THREE.LineSegments(geometry, material);
    object.frustumCulled = false;
    object.renderOrder = -1;
    this.scene.add(object);
    return object;
  }

  /**
   * @param {any} object @param {number[]} points @param {number[]} colors
   */
  #fill(object, points, colors) {
    object.geometry.dispose();
    object.geometry = new THREE.BufferGeometry();
    object.geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    object.geometry.setAttribute("color", new THREE.Float32BufferAttribute(colors, 3));
    object.visible = points.length > 0;
  }

  /**
   * A step of 1, 2 or 5 times a power of ten.
   * @param {number} x
   */
  static step(x) {
    const power = 10 ** Math.floor(Math.log10(x)), lead = x / power;
    return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
  }

  /**
   * The floor at a height, around what is looked at, and the axes where they cross it.
   * @param {number} height relative to the target @param {number[]} origin of the world, relative to the target
   * @param {number} distance of the camera @param {boolean} shown
   */
  ground(height, origin, distance, shown) {
    const step = Marks.step(distance / 10), half = 12;
    /** @type {{ text: string, at: number[] }[]} */
    this.numbers = [];
    this.unit = step;
    if (!shown) {
      this.#fill(this.floor, [], []);
      this.#fill(this.axes, [], []);
      return;
    }
    /** @type {number[]} */
    const points = [];
    /** @type {number[]} */
    const colors = [];
    const grey = this.dark ? [0.45, 0.52, 0.6] : [0.55, 0.6, 0.66];
    // Lines of whole multiples of the step, of the world.
    const k = [0, 2].map((i) => Math.round(-origin[i] / step));
    const at = (/** @type {number} */ axis, /** @type {number} */ n) => origin[axis] + n * step;
    for (let i = -half; i <= half; i++) {
      points.push(at(0, k[0] + i), height, at(2, k[1] - half), at(0, k[0] + i), height, at(2, k[1] + half));
      points.push(at(0, k[0] - half), height, at(2, k[1] + i), at(0, k[0] + half), height, at(2, k[1] + i));
      for (let j = 0; j < 4; j++) colors.push(...grey);
      if (i % 2) continue;
      const text = (/** @type {number} */ n) => String(Number((n * step).toPrecision(12)));
      if (Math.abs(k[0] + i) < 1e15) this.numbers.push({ text: text(k[0] + i), at: [at(0, k[0] + i), height, at(2, k[1] + half)] });
      if (Math.abs(k[1] + i) < 1e15) this.numbers.push({ text: text(k[1] + i), at: [at(0, k[0] - half), height, at(2, k[1] + i)] });
    }
    this.#fill(this.floor, points, colors);
    const long = 1.6 * step;
    const axes = origin.every((x) => Math.abs(x) < 40 * step);
    const red = [0.85, 0.25, 0.2], green = [0.2, 0.62, 0.3], blue = [0.2, 0.45, 0.9];
    const [x, y, z] = origin;
    this.#fill(
      this.axes,
      axes ? [x, y, z, x + long, y, z, x, y, z, x, y + long, z, x, y, z, x, y, z + long] : [],
      axes ? [...red, ...red, ...green, ...green, ...blue, ...blue] : [],
    );
    if (axes)
      this.numbers.push({ text: "x", at: [x + 1.1 * long, y, z] }, { text: "y", at: [x, y + 1.1 * long, z] },
        { text: "z", at: [x, y, z + 1.1 * long] });
  }

  /**
   * Where bodies have been.
   * @param {{ points: number[], color: number[] }[]} trails
   */
  trails(trails) {
    /** @type {number[]} */
    const points = [];
    /** @type {number[]} */
    const colors = [];
    for (const { points: p, color } of trails)
      for (let i = 0; i + 5 < p.length; i += 3) {
        points.push(p[i], p[i + 1], p[i + 2], p[i + 3], p[i + 4], p[i + 5]);
        colors.push(...color.slice(0, 3), ...color.slice(0, 3));
      }
    this.#fill(this.paths, points, colors);
  }

  begin() { this.used = 0; }

  /**
   * A word on the picture.
   * @param {string} text @param {{ x: number, y: number }} at in pixels @param {boolean} strong
   */
  word(text, at, strong) {
    let label = this.spare[this.used];
    if (!label) {
      label = document.createElement("div");
      this.labels.append(label);
      this.spare.push(label);
      Object.assign(label.style, {
        position: "absolute", left: "0", top: "0", maxWidth: "16em", overflow: "hidden", textOverflow: "ellipsis",
        whiteSpace: "nowrap", unicodeBidi: "isolate",
      });
    }
    this.used++;
    const clipped = text.length > 60 ? text.slice(0, 59) + "…" : text;
    if (label.textContent !== clipped) label.textContent = clipped;
    Object.assign(label.style, {
      display: "block",
      fontSize: strong ? "12px" : "10.5px",
      color: strong ? (this.dark ? "#e3e8ef" : "#1d2430") : this.dark ? "#8794a5" : "#6b7686",
      textShadow: strong ? (this.dark ? "0 0 3px #000, 0 0 3px #000" : "0 0 3px #fff, 0 0 3px #fff") : "none",
      transform: `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px) translate(-50%, -50%)`,
    });
  }

  end() {
    for (let i = this.used; i < this.spare.length; i++) this.spare[i].style.display = "none";
  }
}
