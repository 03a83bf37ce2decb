"use strict";

/** @typedef {[number, number, number]} Triple */

/** From where one sees: a place, three directions, and what comes between near and far. Matrices are by columns. */
class Camera {
  /** Half of the angle from below to above. */
  static slope = Math.tan((20 * Math.PI) / 180);

  constructor() {
    /** Its own directions right, up and back, and its place, in the world. */
    this.world = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    /** From the world to clip space, in which what is as near as can be has the depth 1, however large or small the world is. */
    this.clip = this.world;
    this.parallel = false;
    /** Half of the picture, at distance 1 or anywhere. */
    this.half = [1, 1];
    this.near = 0.1;
    this.far = 1000;
  }

  /**
   * It stands somewhere and looks back to the origin.
   * @param {Triple} back where it is: a direction of length 1 @param {number} distance @param {Triple} up
   */
  stand(back, distance, up) {
    const right = Camera.cross(up, back), long = Math.hypot(...right);
    const r = /** @type {Triple} */ (right.map((x) => x / long)), u = Camera.cross(back, r);
    this.world = [...r, 0, ...u, 0, ...back, 0, ...back.map((x) => x * distance), 1];
  }

  /**
   * @param {boolean} parallel @param {number} half of its height, as in `half` @param {number} aspect
   * @param {number} near @param {number} far
   */
  see(parallel, half, aspect, near, far) {
    Object.assign(this, { parallel, half: [half * aspect, half], near, far });
    const [x, y] = this.half, deep = far - near, w = this.world;
    const lens = parallel
      ? [1 / x, 0, 0, 0, 0, 1 / y, 0, 0, 0, 0, -2 / deep, 0, 0, 0, -(far + near) / deep, 1]
      : [1 / x, 0, 0, 0, 0, 1 / y, 0, 0, 0, 0, -(far + near) / deep, -1, 0, 0, (-2 * far * near) / deep, 0];
    const axes = [0, 4, 8].map((i) => w.slice(i, i + 3));
    // The way back from its own directions: these are orthonormal.
    const view = [0, 1, 2].flatMap((i) => [axes[0][i], axes[1][i], axes[2][i], 0]);
    const at = w.slice(12, 15), away = axes.map((a) => -(a[0] * at[0] + a[1] * at[1] + a[2] * at[2]));
    const unit = parallel ? 1 : near;
    this.clip = Camera.product(lens, [...view, ...away, 1]).map((x) => x / unit);
  }

  /**
   * What is under a place of the picture: a point near by, and the way from there to what is farthest.
   * @param {number} x @param {number} y from -1 to 1
   * @returns {{ from: Triple, way: Triple }}
   */
  ray(x, y) {
    const { near, far, parallel, half, world: w } = this, a = x * half[0], b = y * half[1];
    const point = (/** @type {number} */ depth) => {
      const wide = parallel ? 1 : depth;
      return /** @type {Triple} */ ([0, 1, 2].map((i) => w[12 + i] + a * wide * w[i] + b * wide * w[4 + i] - depth * w[8 + i]));
    };
    const from = point(near), to = point(far);
    return { from, way: [to[0] - from[0], to[1] - from[1], to[2] - from[2]] };
  }

  /**
   * A point in clip space.
   * @param {ArrayLike<number>} p
   */
  at(p) {
    const m = this.clip;
    return [0, 1, 2, 3].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);
  }

  /** @param {Triple} a @param {Triple} b @returns {Triple} */
  static cross(a, b) {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  }

  /** @param {number[]} a @param {number[]} b */
  static product(a, b) {
    const c = [];
    for (let j = 0; j < 16; j += 4)
      for (let i = 0; i < 4; i++)
        c.push(a[i] * b[j] + a[4 + i] * b[j + 1] + a[8 + i] * b[j + 2] + a[12 + i] * b[j + 3]);
    return c;
  }
}
