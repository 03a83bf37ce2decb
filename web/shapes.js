"use strict";

/**
 * The geometries of bodies and of their features, about the leaf's point of reference, in floats: solids are small
 * numbers about their own origin.
 *
 * What is open is told by shape, and by colour only besides: a name is a plate on a face, a rod along an edge or a ball at
 * a corner; a co-name is a striped frame, a dashed rod, or a die. Several channels of one feature share its room.
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
   * @typedef {{ points: Point[], faces: { corners: number[], normal: Point }[], edges: [number, number][],
   *   centre: Point, radius: number }} Part  The radius is about the leaf's point of reference.
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
      radius: Math.max(...points.map((p) => Math.hypot(...p))),
    };
  }

  /** Triangles, each corner with its normal and how far along a pattern of stripes it is. */
  class Triangles {
    constructor() {
      /** @type {number[]} */
      this.positions = [];
      /** @type {number[]} */
      this.normals = [];
      /** @type {number[]} */
      this.patterns = [];
    }

    /**
     * A convex polygon.
     * @param {Point[]} corners @param {Point} n @param {(number[]) | ((p: Point) => number)} [along]
     */
    polygon(corners, n, along) {
      const pattern = (/** @type {number} */ i) => (!along ? 0.75 : Array.isArray(along) ? along[i] : along(corners[i]));
      for (let i = 1; i + 1 < corners.length; i++)
        for (const k of [0, i, i + 1]) {
          this.positions.push(...corners[k]);
          this.normals.push(...n);
          this.patterns.push(pattern(k));
        }
    }

    /**
     * A triangle with a normal at each corner.
     * @param {Point[]} corners @param {Point[]} normals
     */
    round(corners, normals) {
      corners.forEach((p, i) => {
        this.positions.push(...p);
        this.normals.push(...normals[i]);
        this.patterns.push(0.75);
      });
    }
  }

  /**
   * From a point so far along a direction.
   * @param {Point} p @param {number} t @param {Point} d @returns {Point}
   */
  const along = (p, t, d) => [p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]];

  /**
   * Between two points.
   * @param {Point} a @param {Point} b @param {number} t @returns {Point}
   */
  const between = (a, b, t) => along(a, t, sub(b, a));

  /**
   * Two directions across a direction.
   * @param {Point} d @returns {[Point, Point]} with d, in this order, a right-handed system: aside, up, d
   */
  function across(d) {
    const aside = unit(cross(d, Math.abs(d[1]) < 0.8 ? [0, 1, 0] : [1, 0, 0]));
    return [aside, cross(d, aside)];
  }

  /**
   * A whole leaf: the surface of all its parts together, and its sharp edges.
   * @param {Part[]} parts @param {number} stripe how wide the stripes of what absorbs are
   */
  function body(parts, stripe) {
    const faces = new Triangles();
    const pattern = (/** @type {Point} */ p) => (p[0] + p[1] + p[2]) / (1.7 * stripe);
    for (const { corners, normal } of Surface.faces(parts)) faces.polygon(corners, normal, pattern);
    return { faces, lines: Surface.edges(parts) };
  }

  /**
   * A ball, as an octahedron whose faces are divided twice.
   * @param {Triangles} into @param {Point} at @param {number} r
   */
  function ball(into, at, r) {
    const half = (/** @type {Point} */ p, /** @type {Point} */ q) => unit([p[0] + q[0], p[1] + q[1], p[2] + q[2]]);
    /** @param {Point} a @param {Point} b @param {Point} c @param {number} depth */
    const put = (a, b, c, depth) => {
      if (depth === 0) return into.round([a, b, c].map((p) => along(at, r, p)), [a, b, c]);
      const ab = half(a, b), bc = half(b, c), ca = half(c, a);
      for (const [p, q, s] of [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]) put(p, q, s, depth - 1);
    };
    for (const x of [1, -1]) for (const y of [1, -1]) for (const z of [1, -1]) {
      const a = /** @type {Point} */ ([x, 0, 0]), b = /** @type {Point} */ ([0, y, 0]), c = /** @type {Point} */ ([0, 0, z]);
      if (x * y * z > 0) put(a, b, c, 2);
      else put(a, c, b, 2);
    }
  }

  /**
   * A die with two of its faces' pairs striped.
   * @param {Triangles} into @param {Point} at @param {number} r half of its width
   */
  function die(into, at, r) {
    for (let i = 0; i < 3; i++)
      for (const s of [1, -1]) {
        const n = /** @type {Point} */ ([0, 0, 0]), u = /** @type {Point} */ ([0, 0, 0]), v = /** @type {Point} */ ([0, 0, 0]);
        n[i] = s;
        u[(i + 1) % 3] = s;
        v[(i + 2) % 3] = 1;
        const c = along(at, r, n);
        const corner = (/** @type {number} */ a, /** @type {number} */ b) => along(along(c, a * r, u), b * r, v);
        into.polygon([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], n, [0.25, 1.75, 1.75, 0.25]);
      }
  }

  /**
   * A rod with six sides and flat ends.
   * @param {Triangles} into @param {Point} a @param {Point} b @param {number} r
   */
  function rod(into, a, b, r) {
    const d = unit(sub(b, a)), [aside, up] = across(d);
    const around = [0, 1, 2, 3, 4, 5].map((i) => {
      const t = (i * Math.PI) / 3;
      return along(along([0, 0, 0], Math.cos(t), aside), Math.sin(t), up);
    });
    around.forEach((p, i) => {
      const q = around[(i + 1) % 6];
      into.polygon([along(a, r, p), along(a, r, q), along(b, r, q), along(b, r, p)], unit(between(p, q, 0.5)));
    });
    into.polygon(around.map((p) => along(b, r, p)), d);
    into.polygon(around.map((p) => along(a, r, p)).reverse(), [-d[0], -d[1], -d[2]]);
  }

  /**
   * @param {Triangles} into @param {Point} a middle of its ground @param {Point} tip @param {number} r of its ground
   */
  function cone(into, a, tip, r) {
    const d = unit(sub(tip, a)), [aside, up] = across(d), slope = r / Math.hypot(...sub(tip, a)), n = 14;
    const at = (/** @type {number} */ i) => {
      const t = (2 * Math.PI * i) / n;
      return along(along([0, 0, 0], Math.cos(t), aside), Math.sin(t), up);
    };
    for (let i = 0; i < n; i++) {
      const p = at(i), q = at(i + 1), m = at(i + 0.5);
      into.round([along(a, r, p), along(a, r, q), tip],
        [unit(along(p, slope, d)), unit(along(q, slope, d)), unit(along(m, slope, d))]);
      into.polygon([along(a, r, q), along(a, r, p), a], [-d[0], -d[1], -d[2]]);
    }
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
   * A feature that stands out, for a channel that is open on it.
   * @param {Part} p @param {SiteKind} kind @param {number} index @param {number} size of the body
   * @param {boolean} co @param {number} rank of the channel among those open there @param {number} count of these
   * @returns {{ faces: Triangles, lines: number[] }}
   */
  function feature(p, kind, index, size, co, rank, count) {
    const faces = new Triangles();
    /** @type {number[]} */
    const lines = [];
    const all = corners(p, kind, index);
    if (kind === "vertex") {
      const r = (0.075 * size * (rank + 1)) / count;
      if (co) die(faces, all[0], 0.85 * r);
      else ball(faces, all[0], r);
    } else if (kind === "edge") {
      // Each has its own part of the edge.
      const from = 0.04 + (0.92 * rank) / count, to = 0.04 + (0.92 * (rank + 1)) / count - (rank + 1 < count ? 0.04 : 0);
      const r = 0.032 * size, n = co ? 5 : 1;
      for (let i = 0; i < n; i++) {
        const t = (/** @type {number} */ x) => from + (to - from) * x;
        const end = co ? (i + 0.55) / (n - 0.45) : 1;
        rod(faces, between(all[0], all[1], t(i / (n - 0.45))), between(all[0], all[1], t(end)), r);
      }
    } else plate(faces, lines, all, p.faces[index].normal, size, co, rank, count);
    return { faces, lines };
  }

  /**
   * A plate on a face, or a frame; of several the first is the outermost.
   * @param {Triangles} faces @param {number[]} lines @param {Point[]} all @param {Point} n @param {number} size
   * @param {boolean} co @param {number} rank @param {number} count
   */
  function plate(faces, lines, all, n, size, co, rank, count) {
    const c = middle(all);
    const inset = (/** @type {number} */ t) => all.map((q) => along(between(c, q, t), 0.003 * size, n));
    const full = 0.74, outer = (full * (count - rank)) / count;
    const inner = rank + 1 < count ? outer - (full / count) * 0.8 : co ? outer * 0.55 : 0;
    const out = inset(outer);
    const loop = (/** @type {Point[]} */ points) =>
      points.forEach((q, i) => lines.push(...q, ...points[(i + 1) % points.length]));
    loop(out);
    if (inner <= 0) {
      faces.polygon(out, n);
      return;
    }
    const ins = inset(inner);
    loop(ins);
    out.forEach((q, i) => {
      const j = (i + 1) % out.length;
      const dashes = co ? 2 * Math.max(2, Math.min(6, Math.round(Math.hypot(...sub(out[j], q)) / (0.3 * size)))) : 1;
      for (let k = 0; k < dashes; k++) {
        const at = (/** @type {Point[]} */ of, /** @type {number} */ t) => between(of[i], of[j], t / dashes);
        const dark = co && k % 2 === 0 ? 0.25 : 0.75;
        faces.polygon([at(out, k), at(out, k + 1), at(ins, k + 1), at(ins, k)], n, () => dark);
      }
    });
  }

  /**
   * A band that tells which feature is meant: along the border of a face, or around an edge or a corner.
   * @param {Part} p @param {SiteKind} kind @param {number} index @param {number} size of the body
   */
  function band(p, kind, index, size) {
    const into = new Triangles();
    const all = corners(p, kind, index);
    if (kind === "vertex") ball(into, all[0], 0.09 * size);
    else if (kind === "edge") rod(into, all[0], all[1], 0.04 * size);
    else {
      const n = p.faces[index].normal, c = middle(all);
      const [out, ins] = [1, 0.87].map((t) => all.map((q) => along(between(c, q, t), 0.006 * size, n)));
      out.forEach((q, i) => into.polygon([q, out[(i + 1) % out.length], ins[(i + 1) % ins.length], ins[i]], n));
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
    rod(into, [0, 0, 0], [0.78, 0, 0], 0.026);
    cone(into, [0.76, 0, 0], [1, 0, 0], 0.075);
    return into;
  }

  /** An arrow that goes around x, the way that what spins about x turns. */
  function curl() {
    const into = new Triangles(), n = 30;
    rod(into, [-0.55, 0, 0], [0.55, 0, 0], 0.018);
    const at = (/** @type {number} */ i) => {
      const t = (1.55 * Math.PI * i) / n;
      return /** @type {Point} */ ([0, Math.cos(t), Math.sin(t)]);
    };
    for (let i = 0; i < n; i++) rod(into, at(i), at(i + 1.04), 0.024);
    const end = at(n), way = unit(cross([1, 0, 0], end));
    cone(into, end, along(end, 0.24, way), 0.075);
    return into;
  }

  return {
    point, sub, cross, dot, unit, middle, along, between, across, part, body, ball, rod, corners, feature, band, outline,
    arrow, curl, Triangles,
  };
})();
