"use strict";

/** Triangles of a polygon in the plane, by its ears. */
const Polygon = (() => {
  /** @typedef {[number, number]} Place */

  /**
   * Twice the area of a triangle, positive if it goes around to the left.
   * @param {Place} a @param {Place} b @param {Place} c
   */
  const area = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

  /** @param {Place[]} all */
  const whole = (all) => all.reduce((sum, p, i) => {
    const q = all[(i + 1) % all.length];
    return sum + p[0] * q[1] - p[1] * q[0];
  }, 0);

  /**
   * Triangles that cover a polygon, as triples of its corners, in its sense. Of one that crosses itself they are some.
   * @param {Place[]} corners @returns {[number, number, number][]}
   */
  function triangles(corners) {
    const sense = whole(corners) < 0 ? -1 : 1;
    const turn = (/** @type {number} */ i, /** @type {number} */ j, /** @type {number} */ k) =>
      sense * area(corners[i], corners[j], corners[k]);
    /** What is left: of each corner, the ones before and after it. */
    const n = corners.length, next = corners.map((_, i) => (i + 1) % n), last = corners.map((_, i) => (i + n - 1) % n);
    /** Corners that an ear may not hold: those that are not convex, which no longer come to be. */
    const hollow = new Set(corners.keys());
    const settle = (/** @type {number} */ i) => {
      if (turn(last[i], i, next[i]) > 0) hollow.delete(i);
    };
    for (let i = 0; i < n; i++) settle(i);
    const ear = (/** @type {number} */ i) => {
      const a = last[i], b = next[i];
      if (hollow.has(i)) return false;
      for (const k of hollow) {
        if (k === a || k === b) continue;
        const [p, q, r] = [turn(a, i, k), turn(i, b, k), turn(b, a, k)];
        const same = [a, b].some((c) => corners[c][0] === corners[k][0] && corners[c][1] === corners[k][1]);
        if (p >= 0 && q >= 0 && r >= 0 && !same) return false;
      }
      return true;
    };
    /** @type {[number, number, number][]} */
    const found = [];
    let at = 0, left = n, tried = 0;
    while (left > 2) {
      // Where no corner is an ear, the polygon crosses itself, or has no area there.
      if (tried < left && !ear(at)) {
        at = next[at];
        tried++;
        continue;
      }
      const a = last[at], b = next[at];
      if (turn(a, at, b) !== 0) found.push([a, at, b]);
      hollow.delete(at);
      next[a] = b;
      last[b] = a;
      left--;
      settle(a);
      settle(b);
      at = b;
      tried = 0;
    }
    return found;
  }

  return { triangles };
})();
