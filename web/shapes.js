"use strict";

/**
 * The geometries of bodies and of their features, about the leaf's point of reference, in floats: solids are small
 * numbers about their own origin.
 */
const Shapes = (() => {
  /** @typedef {[number, number, number]} Point */

  /** @param {Vec} v @returns {Point} */
  const point = (v) => /** @type {Point} */ (v.map((t) => Rational.toNumber(Rational.of(t))));

  /** @param {Point} a @param {Point} b @returns {Point} */
  const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

  /** @param {Point} a @param {Point} b @returns {Point} */
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

  /** @param {Point} a @param {Point} b */
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

  /** @param {Point} a @returns {Point} */
  function unit(a) {
    const l = Math.sqrt(dot(a, a)) || 1;
    return [a[0] / l, a[1] / l, a[2] / l];
  }

  /** @param {Point[]} all @returns {Point} */
  function middle(all) {
    const s = [0, 0, 0];
    for (const p of all) for (let i = 0; i < 3; i++) s[i] += p[i];
    return /** @type {Point} */ (s.map((x) => x / all.length));
  }

  /**
   * The normal of a polygon, by Newell's sum.
   * @param {Point[]} all
   */
  function normal(all) {
    let n = /** @type {Point} */ ([0, 0, 0]);
    for (let i = 1; i + 1 < all.length; i++) {
      const c = cross(sub(all[i], all[0]), sub(all[i + 1], all[0]));
      n = [n[0] + c[0], n[1] + c[1], n[2] + c[2]];
    }
    return unit(n);
  }

  /**
   * @typedef {{ points: Point[], faces: { corners: number[], normal: Point }[], edges: [number, number][], centre: Point }} Part
   * @param {PageData} data @param {DataPart} part @returns {Part}
   */
  function part(data, part) {
    const solid = data.solids[part.solid], offset = point(part.offset);
    const points = solid.vertices.map((v) => {
      const p = point(v);
      return /** @type {Point} */ ([p[0] + offset[0], p[1] + offset[1], p[2] + offset[2]]);
    });
    return {
      points,
      faces: solid.faces.map((f) => ({ corners: f.corners, normal: normal(f.corners.map((i) => points[i])) })),
      edges: solid.edges.map((e) => /** @type {[number, number]} */ ([e.corners[0], e.corners[1]])),
      centre: middle(points),
    };
  }

  /** Triangles of a convex polygon. */
  class Triangles {
    constructor() {
      /** @type {number[]} */
      this.positions = [];
      /** @type {number[]} */
      this.normals = [];
    }

    /**
     * @param {Point[]} corners @param {Point} n
     */
    polygon(corners, n) {
      for (let i = 1; i + 1 < corners.length; i++) {
        this.positions.push(...corners[0], ...corners[i], ...corners[i + 1]);
        this.normals.push(...n, ...n, ...n);
      }
    }
  }

  /**
   * A whole leaf: all its parts.
   * @param {Part[]} parts
   */
  function body(parts) {
    const faces = new Triangles();
    /** @type {number[]} */
    const lines = [];
    for (const p of parts) {
      for (const f of p.faces) faces.polygon(f.corners.map((i) => p.points[i]), f.normal);
      for (const [a, b] of p.edges) lines.push(...p.points[a], ...p.points[b]);
    }
    return { faces, lines };
  }

  /**
   * A ball, as an octahedron whose faces are divided once.
   * @param {Triangles} into @param {Point} at @param {number} r
   */
  function ball(into, at, r) {

    const put = (/** @type {Point[]} */ t) => {
      const world = t.map((p) => /** @type {Point} */ ([at[0] + r * p[0], at[1] + r * p[1], at[2] + r * p[2]]));
      into.positions.push(...world[0], ...world[1], ...world[2]);
      into.normals.push(...t[0], ...t[1], ...t[2]);
    };
    for (const sx of [1, -1]) for (const sy of [1, -1]) for (const sz of [1, -1]) {
      const a = /** @type {Point} */ ([sx, 0, 0]), b = /** @type {Point} */ ([0, sy, 0]), c = /** @type {Point} */ ([0, 0, sz]);
      const half = (/** @type {Point} */ p, /** @type {Point} */ q) => unit([p[0] + q[0], p[1] + q[1], p[2] + q[2]]);
      const ab = half(a, b), bc = half(b, c), ca = half(c, a);
      const all = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
      for (const t of all) put(sx * sy * sz > 0 ? t : [t[0], t[2], t[1]]);
    }

  }

  /**
   * A rod with four sides.
   * @param {Triangles} into @param {Point} a @param {Point} b @param {number} r
   */
  function rod(into, a, b, r) {
    const along = unit(sub(b, a));
    const aside = unit(cross(along, Math.abs(along[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0]));
    const up = cross(along, aside);
    const around = [0, 1, 2, 3, 4, 5].map((i) => {
      const c = Math.cos((i * Math.PI) / 3), s = Math.sin((i * Math.PI) / 3);
      return /** @type {Point} */ ([0, 1, 2].map((k) => c * aside[k] + s * up[k]));
    });
    const off = (/** @type {Point} */ p, /** @type {Point} */ d) =>
      /** @type {Point} */ ([p[0] + r * d[0], p[1] + r * d[1], p[2] + r * d[2]]);
    around.forEach((d, i) => {
      const e = around[(i + 1) % 6];
      into.polygon([off(a, d), off(a, e), off(b, e), off(b, d)], unit([d[0] + e[0], d[1] + e[1], d[2] + e[2]]));
    });
  }

  /**
   * The points of a feature.
   * @param {Part} p @param {SiteKind} kind @param {number} index
   */
  function corners(p, kind, index) {
    return kind === "vertex" ? [p.points[index]]
      : kind === "edge" ? p.edges[index].map((i) => p.points[i])
      : p.faces[index].corners.map((i) => p.points[i]);
  }

  /**
   * A feature that stands out: a plate on a face, a rod along an edge, a ball at a corner.
   * @param {Part} p @param {SiteKind} kind @param {number} index @param {number} size of the body
   */
  function feature(p, kind, index, size) {
    const into = new Triangles();
    const all = corners(p, kind, index);
    if (kind === "vertex") ball(into, all[0], 0.07 * size);
    else if (kind === "edge") rod(into, all[0], all[1], 0.035 * size);
    else {
      const n = p.faces[index].normal, c = middle(all);
      const inner = all.map((q) => /** @type {Point} */ ([0, 1, 2].map((i) => c[i] + 0.72 * (q[i] - c[i]) + 0.004 * size * n[i])));
      into.polygon(inner, n);
    }
    return into;
  }

  /**
   * Its outline, as lines; a corner as a small cross.
   * @param {Part} p @param {SiteKind} kind @param {number} index @param {number} size
   */
  function outline(p, kind, index, size) {
    const all = corners(p, kind, index);
    /** @type {number[]} */
    const lines = [];
    if (kind === "vertex")
      for (let i = 0; i < 3; i++) {
        const a = [...all[0]], b = [...all[0]];
        a[i] -= 0.12 * size;
        b[i] += 0.12 * size;
        lines.push(...a, ...b);
      }
    else for (let i = 0; i < all.length; i++) lines.push(...all[i], ...all[(i + 1) % all.length]);
    return lines;
  }

  /** An arrow from the origin along x, of length 1. */
  function arrow() {
    const into = new Triangles();
    rod(into, [0, 0, 0], [0.78, 0, 0], 0.028);
    const tip = /** @type {Point} */ ([1, 0, 0]);
    for (let i = 0; i < 8; i++) {
      const at = (/** @type {number} */ k) =>
        /** @type {Point} */ ([0.74, 0.085 * Math.cos((k * Math.PI) / 4), 0.085 * Math.sin((k * Math.PI) / 4)]);
      const a = at(i), b = at(i + 1);
      into.polygon([a, b, tip], unit([0.33, a[1] + b[1], a[2] + b[2]]));
      into.polygon([b, a, [0.74, 0, 0]], [-1, 0, 0]);
    }
    return into;
  }

  return { point, sub, cross, dot, unit, middle, part, body, ball, rod, corners, feature, outline, arrow, Triangles };
})();
