"use strict";

/**
 * A leaf at its place: its corners, or of one of very many the ends of a box around it.
 * @typedef {{ leaf: number, points: Triple[], low: number[], high: number[], fixed: boolean, matrix: Float64Array }} Box
 * @typedef {ReturnType<typeof Shapes.part>} Part
 */

/** What a picture is to hold, and from where it does. */
const Frame = (() => {

  /**
   * Where each body is from a place that is told exactly, in floats: the picture need not be exact.
   * @param {Bodies} bodies @param {Course} course @param {Moving[]} present @param {bigint[]} base
   * @returns {Box[]}
   */
  function boxes(bodies, course, present, base) {
    const from = Motion.target({ n: base, d: 1n }), many = present.length > 500;
    return present.flatMap((body) => body.process.leaves.map((place) => {
      const { leaf } = place, { fixed } = bodies.leaves[leaf], matrix = new Float64Array(12), r = bodies.sizes[leaf];
      course.place(body, place, from, matrix);
      const ends = (/** @type {number} */ s) => /** @type {Triple} */ ([matrix[0] + s * r, matrix[1] + s * r, matrix[2] + s * r]);
      const points = many && !fixed ? [ends(-1), ends(1)]
        : bodies.models[leaf].flatMap((p) => p.points).map((p) => Pick.toWorld(matrix, p));
      return { leaf, points, ...range(points), fixed, matrix };
    }));
  }

  /** @param {number[][]} points */
  function range(points) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const p of points)
      for (let i = 0; i < 3; i++) {
        low[i] = Math.min(low[i], p[i]);
        high[i] = Math.max(high[i], p[i]);
      }
    return { low, high };
  }

  /** @param {{ low: number[], high: number[] }} box */
  const size = ({ low, high }) => Math.hypot(...high.map((h, i) => h - low[i]));

  /**
   * All that moves, and what is fixed, unless it is much larger: of that, what is beside those that move. A wall around
   * others may be larger than any other one; of what is larger and matters, more is seen.
   * @param {Box[]} all @param {ReturnType<typeof Walls.find>} walls @param {Set<number>} matters leaves
   */
  function whole(all, walls, matters) {
    const moving = all.filter((b) => !b.fixed);
    const main = moving.length ? moving : all;
    const around = range(main.flatMap((b) => [b.low, b.high])), wide = size(around);
    const points = main.flatMap((b) => b.points);
    for (const b of all) {
      if (!b.fixed) continue;
      const room = (matters.has(b.leaf) ? 0.5 : 0.25) * wide;
      const low = b.low.map((l, i) => Math.max(l, around.low[i] - room));
      const high = b.high.map((h, i) => Math.min(h, around.high[i] + room));
      if (size(b) <= (walls.get(b.leaf) ? 12 : 2) * wide) points.push(...b.points);
      else if (low.every((l, i) => l <= high[i])) points.push(/** @type {Triple} */ (low), /** @type {Triple} */ (high));
    }
    const box = range(points);
    if (!box.low.every(Number.isFinite) || !box.high.every(Number.isFinite)) return null;
    return { points, ...box, size: size(box) };
  }

  /**
   * From where an orbit sees all points, as large as may be.
   * @param {Triple[]} points @param {Orbit} orbit @param {number} width @param {number} height
   * @param {{ left: number, below: number }} taken how much of the picture is covered
   */
  function fit(points, orbit, width, height, { left, below }) {
    const back = orbit.direction;
    const right = Shapes.unit(Shapes.cross(orbit.way(0, 1, 0), back)), up = Shapes.cross(back, right);
    const seen = points.map((p) => [Shapes.dot(p, right), Shapes.dot(p, up), Shapes.dot(p, back)]);
    // Words have some room at the border.
    const room = Math.min(30, 0.1 * Math.min(width, height));
    const tall = Camera.slope * Math.max(0.3, 1 - (2 * room + below) / Math.max(1, height));
    const wide = (Camera.slope * Math.max(1, width - 2 * room - left)) / Math.max(1, height);
    const { low, high } = range(seen), middle = low.map((l, i) => (l + high[i]) / 2);
    // A point alone has no size, and any distance shows it.
    const least = size({ low, high }) > 0 ? 0 : 1e-6;
    let distance = least;
    for (let round = 0; round < 4; round++) {
      distance = least;
      for (const p of seen) {
        const depth = orbit.parallel ? 0 : p[2] - middle[2];
        distance = Math.max(distance, Math.abs(p[0] - middle[0]) / wide + depth, Math.abs(p[1] - middle[1]) / tall + depth);
      }
      // In perspective, what is near takes more room than what is far: the middle moves accordingly.
      const flat = seen.map((p) => {
        const away = orbit.parallel ? distance : distance - (p[2] - middle[2]);
        return [((p[0] - middle[0]) / away) * distance, ((p[1] - middle[1]) / away) * distance];
      });
      for (const i of [0, 1]) {
        let low = Infinity, high = -Infinity;
        for (const p of flat) {
          low = Math.min(low, p[i]);
          high = Math.max(high, p[i]);
        }
        middle[i] += (low + high) / 2;
      }
    }
    const pixel = (2 * distance * Camera.slope) / Math.max(1, height);
    middle[0] -= (left * pixel) / 2;
    middle[1] -= (below * pixel) / 2;
    const at = [0, 1, 2].map((i) => middle[0] * right[i] + middle[1] * up[i] + middle[2] * back[i]);
    return { at, distance: 1.02 * distance };
  }

  return { boxes, range, whole, fit, size };
})();
