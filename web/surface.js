"use strict";

/**
 * The surface of a leaf that is made of several convex parts: what touches is one body, without the faces between its
 * parts, and without lines where two of them go on in one plane.
 *
 * All of it in floats, for drawing alone.
 */
const Surface = (() => {
  /** @typedef {[number, number, number]} Point */
  /** @typedef {ReturnType<typeof Shapes.part>} Part */

  /** @param {Part[]} parts */
  const grain = (parts) => 1e-6 * Math.max(...parts.map((p) => p.radius), 1e-30);

  /**
   * What is left of a convex polygon without another one of its plane, as convex polygons.
   * @param {Point[]} polygon @param {Point[]} other @param {Point} normal of the other @param {number} eps
   */
  function without(polygon, other, normal, eps) {
    /** @type {Point[][]} */
    const left = [];
    let inside = polygon;
    for (let i = 0; i < other.length && inside.length > 2; i++) {
      const a = other[i], b = other[(i + 1) % other.length];
      const out = Shapes.unit(Shapes.cross(Shapes.sub(b, a), normal));
      const height = (/** @type {Point} */ p) => Shapes.dot(out, Shapes.sub(p, a));
      const beyond = cut(inside, height, eps);
      if (beyond.length > 2) left.push(beyond);
      inside = cut(inside, (p) => -height(p), eps);
    }
    return inside.length > 2 ? left : [polygon];
  }

  /**
   * The part of a polygon that is above.
   * @param {Point[]} polygon @param {(p: Point) => number} height @param {number} eps
   */
  function cut(polygon, height, eps) {
    /** @type {Point[]} */
    const kept = [];
    let most = 0;
    polygon.forEach((p, i) => {
      const q = polygon[(i + 1) % polygon.length], a = height(p), b = height(q);
      most = Math.max(most, a);
      if (a >= -eps) kept.push(p);
      if ((a > eps && b < -eps) || (a < -eps && b > eps)) kept.push(Shapes.between(p, q, a / (a - b)));
    });
    return most > eps ? kept : [];
  }

  /**
   * The faces that are seen.
   * @param {Part[]} parts @returns {{ corners: Point[], normal: Point }[]}
   */
  function faces(parts) {
    const eps = grain(parts);
    const all = parts.flatMap((p, part) =>
      p.faces.map((f) => ({ part, normal: f.normal, corners: f.corners.map((i) => p.points[i]) })));
    const seen = [];
    for (const f of all) {
      let left = [f.corners];
      for (const g of all) {
        if (g.part === f.part || Shapes.dot(f.normal, g.normal) > -1 + 1e-9) continue;
        if (Math.abs(Shapes.dot(f.normal, Shapes.sub(g.corners[0], f.corners[0]))) > eps) continue;
        left = left.flatMap((polygon) => without(polygon, g.corners, g.normal, eps));
      }
      for (const corners of left) seen.push({ corners, normal: f.normal });
    }
    return seen;
  }

  /**
   * The edges that are sharp, as pairs of points.
   * @param {Part[]} parts
   */
  function edges(parts) {
    const eps = grain(parts);
    const planes = parts.map((p) =>
      p.faces.map((f) => ({ normal: f.normal, at: Shapes.dot(f.normal, p.points[f.corners[0]]) })));
    /** @type {number[]} */
    const lines = [];
    /** @type {Set<string>} */
    const known = new Set();
    const name = (/** @type {Point} */ p) => p.map((x) => Math.round(x / (8 * eps)) + 0).join(",");
    for (const [part, p] of parts.entries())
      for (const [i, j] of p.edges) {
        const a = p.points[i], b = p.points[j], d = Shapes.sub(b, a);
        // It may be sharp in some places only: it changes where it crosses a plane of another part.
        const cuts = [0, 1];
        for (const [other, of] of planes.entries())
          if (other !== part && parts.length < 200)
            for (const { normal, at } of of) {
              const fall = Shapes.dot(normal, d), t = (at - Shapes.dot(normal, a)) / fall;
              if (Math.abs(fall) > eps && t > 1e-6 && t < 1 - 1e-6) cuts.push(t);
            }
        cuts.sort((x, y) => x - y);
        let from = 0;
        cuts.forEach((t, k) => {
          const last = k + 1 === cuts.length, to = last ? t : cuts[k + 1];
          if (!last && to - t < 1e-6) return;
          if (!last && sharp(planes, Shapes.between(a, b, (t + to) / 2), Shapes.unit(d), eps)) return;
          // The lines that stay together are one.
          if (t - from > 1e-6) put(Shapes.between(a, b, from), Shapes.between(a, b, t));
          from = to;
        });
      }
    return lines;

    /** @param {Point} a @param {Point} b */
    function put(a, b) {
      const key = [name(a), name(b)].sort().join(" ");
      if (known.has(key)) return;
      known.add(key);
      lines.push(...a, ...b);
    }
  }

  /**
   * Whether the surface has an edge at a point along a direction: it has none within a body, nor within a plane.
   * @param {{ normal: Point, at: number }[][]} planes of the parts @param {Point} p @param {Point} way @param {number} eps
   */
  function sharp(planes, p, way, eps) {
    const [u, v] = Shapes.across(way);
    /** @type {[number, number][][]} of each part that is there, the normals of its faces, across the direction */
    const wedges = [];
    for (const of of planes) {
      const heights = of.map((f) => Shapes.dot(f.normal, p) - f.at);
      if (heights.some((h) => h > eps)) continue;
      const active = of.filter((_, i) => heights[i] > -eps);
      if (active.length === 0) return false;
      wedges.push(active.map((f) => [Shapes.dot(f.normal, u), Shapes.dot(f.normal, v)]));
    }
    const turns = wedges.flat().flatMap(([x, y]) => [Math.atan2(y, x) + Math.PI / 2, Math.atan2(y, x) - Math.PI / 2]);
    const angles = turns.map((t) => ((t % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI)).sort((x, y) => x - y);
    let full = 0, changes = 0;
    /** @type {boolean[]} */
    const seen = [];
    angles.forEach((t, i) => {
      const wide = i + 1 < angles.length ? angles[i + 1] - t : angles[0] + 2 * Math.PI - t;
      if (wide < 1e-6) return;
      const x = Math.cos(t + wide / 2), y = Math.sin(t + wide / 2);
      const within = wedges.some((w) => w.every(([nx, ny]) => nx * x + ny * y <= 1e-9));
      if (within) full += wide;
      seen.push(within);
    });
    seen.forEach((s, i) => {
      if (s !== seen[(i + 1) % seen.length]) changes++;
    });
    if (full > 2 * Math.PI - 1e-4) return false;
    return !(changes === 2 && Math.abs(full - Math.PI) < 1e-4);
  }

  return { faces, edges };
})();
