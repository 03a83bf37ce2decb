"use strict";

/**
 * Where the camera stands when one axis of space points up on the page: that axis, those of the floor, and whether the second
 * of these points to the front or away, so that the first one points to the right.
 * @typedef {{ up: number, floor: [number, number], front: 1 | -1 }} Upright
 */

/**
 * The camera: it looks at a target from some distance, and goes around it. The target is exact, and all that is drawn is
 * told relative to it, so that nothing shakes far from the origin.
 */
class Orbit {
  /** @type {{ [axis: string]: Upright }} */
  static uprights = {
    x: { up: 0, floor: [1, 2], front: -1 },
    y: { up: 1, floor: [0, 2], front: 1 },
    z: { up: 2, floor: [0, 1], front: -1 },
  };

  /** @param {HTMLCanvasElement} canvas @param {() => void} changed */
  constructor(canvas, changed) {
    this.canvas = canvas;
    this.changed = changed;
    /** @type {Rational[]} */
    this.at = [Rational.zero, Rational.zero, Rational.zero];
    this.target = Motion.target({ n: [0n, 0n, 0n], d: 1n });
    this.distance = 20;
    /** From where all is seen: how near and how far one may go depends on it. */
    this.usual = 20;
    /** Around the axis that points up, from the front to the right; and above the floor. In radians. */
    this.turn = 0.5;
    this.height = 0.42;
    this.parallel = false;
    /** The name of the axis that points up. */
    this.up = "y";
    /**
     * Where it is going.
     * @type {{ frame: number } | null}
     */
    this.flight = null;
    this.camera = new Camera();
    /** How high the picture is. */
    this.tall = 0;
    this.#listen();
  }

  get upright() { return Orbit.uprights[this.up]; }

  /**
   * A direction of the page in space.
   * @param {number} right @param {number} up @param {number} front @returns {[number, number, number]}
   */
  way(right, up, front) {
    const to = this.upright, v = /** @type {[number, number, number]} */ ([0, 0, 0]);
    v[to.floor[0]] = right;
    v[to.up] = up;
    v[to.floor[1]] = to.front * front;
    return v;
  }

  /** Where the camera is, relative to the target: a direction of length 1. */
  get direction() {
    const c = Math.cos(this.height);
    return this.way(c * Math.sin(this.turn), Math.sin(this.height), c * Math.cos(this.turn));
  }

  /**
   * Looks at a place, near enough: numbers stay short when they are multiples of a power of two that is small beside the
   * distance.
   * @param {number[]} place
   */
  lookAt(place) {
    const step = 2 ** Math.floor(Math.log2(this.distance) - 12);
    this.setTarget(place.map((x) => Rational.fromNumber(Math.round(x / step) * step)));
  }

  /**
   * Looks at an exact place from a distance, at once.
   * @param {Rational[]} at @param {number} distance
   */
  stand(at, distance) {
    this.stop();
    this.distance = distance;
    this.setTarget(at);
    this.changed();
  }

  /**
   * The same as {@link lookAt} of an exact place, however far away it is.
   * @param {Rational[]} place
   */
  goTo(place) {
    const whole = place.map((x) => x.n / x.d);
    const step = 2 ** Math.floor(Math.log2(this.distance) - 12);
    this.setTarget(place.map((x, i) => {
      const rest = Rational.toNumber(Rational.sub(x, { n: whole[i], d: 1n }));
      return Rational.add({ n: whole[i], d: 1n }, Rational.fromNumber(Math.round(rest / step) * step));
    }));
  }

  /** @param {Rational[]} at */
  setTarget(at) {
    this.at = at;
    this.target = Motion.target(Motion.ints(at.map(Rational.text)));
  }

  /**
   * Goes to a place and a distance: at once, or on a short way where motion is wanted.
   * @param {number[]} place @param {number} distance @param {boolean} still
   */
  fly(place, distance, still) {
    this.stop();
    const from = this.at.map(Rational.toNumber), near = this.distance;
    const far = place.some((x, i) => !(Math.abs(x - from[i]) < 1e3 * (distance + near)));
    if (still || far || document.hidden) {
      this.distance = distance;
      this.lookAt(place);
      this.changed();
      return;
    }
    let begun = 0;
    const flight = (this.flight = { frame: 0 });
    const step = (/** @type {number} */ now) => {
      if (this.flight !== flight) return;
      if (begun === 0) begun = now;
      const t = Math.min(1, (now - begun) / 260), s = t * t * (3 - 2 * t);
      this.distance = near * (distance / near) ** s;
      this.lookAt(place.map((x, i) => from[i] + s * (x - from[i])));
      this.changed();
      if (t < 1) flight.frame = window.requestAnimationFrame(step);
      else this.flight = null;
    };
    flight.frame = window.requestAnimationFrame(step);
  }

  /** Stays where it is. */
  stop() {
    if (this.flight) window.cancelAnimationFrame(this.flight.frame);
    this.flight = null;
  }

  /**
   * Moves the target by floats, exactly.
   * @param {number[]} by
   */
  pan(by) {
    this.stop();
    const step = 2 ** Math.floor(Math.log2(this.distance) - 14);
    const moved = by.map((x, i) =>
      Rational.add(this.at[i], Rational.fromNumber(Math.round(x / step) * step)));
    this.setTarget(moved);
    this.changed();
  }

  /** @param {number} width @param {number} height of the picture @param {number} radius of what there is to see */
  place(width, height, radius) {
    this.tall = height;
    const aspect = width / Math.max(1, height), depth = 4 * (this.distance + radius);
    this.camera.stand(this.direction, this.distance, this.way(0, 1, 0));
    if (this.parallel) this.camera.see(true, this.distance * Camera.slope, aspect, -depth, depth);
    else this.camera.see(false, Camera.slope, aspect, this.distance / 100, depth);
  }

  /** How long a pixel is, at the target. @returns {number} */
  get pixel() { return (2 * this.distance * Camera.slope) / Math.max(1, this.tall || this.canvas.clientHeight); }

  /** @param {number} dx @param {number} dy in pixels */
  around(dx, dy) {
    this.turn -= dx * 0.008;
    this.height = Math.max(-1.55, Math.min(1.55, this.height + dy * 0.008));
    this.changed();
  }

  /** @param {number} dx @param {number} dy in pixels */
  shift(dx, dy) {
    const { world } = this.camera;
    this.pan([0, 1, 2].map((i) => (dy * world[4 + i] - dx * world[i]) * this.pixel));
  }

  /**
   * Goes nearer, or away; what is under a pixel stays there.
   * @param {number} factor less than 1: nearer @param {number} [x] @param {number} [y] of the pixel, from the middle
   */
  zoom(factor, x = 0, y = 0) {
    this.stop();
    const distance = Math.max(5e-8 * this.usual, Math.min(5e10 * this.usual, this.distance * factor));
    const part = 1 - distance / this.distance;
    if (x !== 0 || y !== 0) this.shift(-x * part, -y * part);
    this.distance = distance;
    this.changed();
  }

  /** @returns {{ [key: string]: any }} what an address can hold */
  save() {
    const short = (/** @type {number} */ x) => Number(x.toPrecision(5));
    return {
      at: this.at.map(Rational.text), distance: short(this.distance), turn: short(this.turn), height: short(this.height),
      ...(this.parallel ? { parallel: true } : {}), ...(this.up === "y" ? {} : { up: this.up }),
    };
  }

  /** @param {{ [key: string]: any }} c */
  load(c) {
    const number = (/** @type {any} */ x) => typeof x === "number" && Number.isFinite(x);
    const fraction = (/** @type {any} */ x) => typeof x === "string" && x.length < 2000 && /^-?\d+(\/\d*[1-9]\d*)?$/.test(x);
    if (!Array.isArray(c.at) || c.at.length !== 3 || !c.at.every(fraction)) throw new Error("no camera");
    if (![c.distance, c.turn, c.height].every(number) || c.distance <= 0) throw new Error("no camera");
    this.stop();
    this.setTarget(c.at.map(Rational.of));
    this.distance = c.distance;
    this.turn = c.turn;
    this.height = Math.max(-1.55, Math.min(1.55, c.height));
    this.parallel = c.parallel === true;
    this.up = c.up === "x" || c.up === "z" ? c.up : "y";
    this.changed();
  }

  #listen() {
    /** @type {Map<number, { x: number, y: number }>} */
    const held = new Map();
    this.canvas.addEventListener("pointerdown", (e) => {
      this.canvas.setPointerCapture(e.pointerId);
      held.set(e.pointerId, { x: e.clientX, y: e.clientY });
    });
    this.canvas.addEventListener("pointerdown", () => this.stop());
    const release = (/** @type {PointerEvent} */ e) => held.delete(e.pointerId);
    this.canvas.addEventListener("pointerup", release);
    this.canvas.addEventListener("pointercancel", release);
    this.canvas.addEventListener("pointermove", (e) => {
      const was = held.get(e.pointerId);
      if (!was) return;
      const dx = e.clientX - was.x, dy = e.clientY - was.y;
      if (held.size === 1) {
        if (e.shiftKey || e.buttons & 6) this.shift(dx, dy); else this.around(dx, dy);
      } else if (held.size === 2) {
        const other = [...held].filter(([id]) => id !== e.pointerId)[0][1];
        const before = Math.hypot(was.x - other.x, was.y - other.y);
        const now = Math.hypot(e.clientX - other.x, e.clientY - other.y);
        if (before > 10 && now > 10) this.zoom(before / now);
        this.shift(dx / 2, dy / 2);
      }
      held.set(e.pointerId, { x: e.clientX, y: e.clientY });
    });
    this.canvas.addEventListener("wheel", (e) => {
      e.preventDefault();
      const box = this.canvas.getBoundingClientRect();
      this.zoom(2 ** (Math.max(-100, Math.min(100, e.deltaY * (e.deltaMode ? 30 : 1))) / 250),
        e.clientX - box.left - box.width / 2, e.clientY - box.top - box.height / 2);
    }, { passive: false });
    this.canvas.addEventListener("contextmenu", (e) => e.preventDefault());
    this.canvas.addEventListener("keydown", (e) => {
      const way = { a: [-1, 0], d: [1, 0], w: [0, -1], s: [0, 1] }[e.key.toLowerCase()];
      if (e.ctrlKey || e.metaKey || e.altKey) return;
      if (way) {
        if (e.shiftKey) this.shift(-30 * way[0], -30 * way[1]); else this.around(-15 * way[0], -15 * way[1]);
      } else if (e.key === "z") this.zoom(0.85);
      else if (e.key === "Z") this.zoom(1 / 0.85);
      else return;
      e.preventDefault();
      e.stopPropagation();
    });
  }
}
