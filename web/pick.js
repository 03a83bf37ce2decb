"use strict";

/**
 * What is under a pointer: a part of a leaf, and the face, edge or corner of it.
 */
const Pick = (() => {
  /**
   * A point of the leaf, relative to the target.
   * @param {Float64Array} m @param {number[]} p
   * @returns {[number, number, number]}
   */
  function toWorld(m, p) {
    return /** @type {[number, number, number]} */ (
      [0, 1, 2].map((i) => m[i] + m[3 + 3 * i] * p[0] + m[4 + 3 * i] * p[1] + m[5 + 3 * i] * p[2]));
  }

  /**
   * A direction seen from the leaf.
   * @param {Float64Array} m @param {number[]} v
   * @returns {[number, number, number]}
   */
  function toBody(m, v) {
    return /** @type {[number, number, number]} */ (
      [0, 1, 2].map((i) => m[3 + i] * v[0] + m[6 + i] * v[1] + m[9 + i] * v[2]));
  }

  /**
   * Where a ray enters a convex part, and where it leaves it: the faces, and how far along the ray.
   * @param {Part} part @param {Triple} from @param {Triple} way
   */
  function enter(part, from, way) {
    let first = -Infinity, last = Infinity, face = -1, other = -1;
    const flat = 1e-14 * Math.hypot(...way), beside = 1e-9 * part.radius;
    for (const [i, f] of part.faces.entries()) {
      const q = part.points[f.corners[0]];
      const height = Shapes.dot(f.normal, Shapes.sub(from, q)), fall = Shapes.dot(f.normal, way);
      if (Math.abs(fall) < flat) {
        if (height > beside) return null;
        continue;
      }
      const t = -height / fall;
      if (fall < 0) {
        if (t > first) { first = t; face = i; }
      } else if (t < last) { last = t; other = i; }
    }
    return face >= 0 && other >= 0 && first <= last ? { face, t: first, other, last } : null;
  }

  /**
   * The same for a part of a wall, of which one sees the faces alone that have the eye and its heart at one side.
   * @param {Part} part @param {Triple} from @param {Triple} way @param {Triple} heart
   */
  function see(part, from, way, heart) {
    const hit = enter(part, from, way);
    if (!hit) return null;
    const before = (/** @type {number} */ i) => {
      const { normal, corners } = part.faces[i];
      return Shapes.dot(normal, Shapes.sub(heart, part.points[corners[0]])) > 0;
    };
    if (before(hit.face)) return hit;
    return before(hit.other) ? null : { face: hit.other, t: hit.last };
  }

  /**
   * The feature that is meant: a corner or an edge of the face, if it is within so many pixels.
   * @param {Shown} shown @param {number} index of the part @param {number} face
   * @param {(p: number[]) => { x: number, y: number }} project @param {number} x @param {number} y @param {number} near
   * @returns {{ kind: SiteKind, index: number }}
   */
  function feature(shown, index, face, project, x, y, near) {
    const part = shown.parts[index], around = part.faces[face].corners;
    const seen = new Map(around.map((i) => [i, project(toWorld(shown.matrix, part.points[i]))]));
    for (const [i, p] of seen) if (Math.hypot(p.x - x, p.y - y) < near) return { kind: "vertex", index: i };
    for (const [i, [a, b]] of part.edges.entries()) {
      const p = seen.get(a), q = seen.get(b);
      if (!p || !q) continue;
      const dx = q.x - p.x, dy = q.y - p.y;
      const t = Math.max(0, Math.min(1, ((x - p.x) * dx + (y - p.y) * dy) / (dx * dx + dy * dy || 1)));
      if (Math.hypot(p.x + t * dx - x, p.y + t * dy - y) < 0.6 * near) return { kind: "edge", index: i };
    }
    return { kind: "face", index: face };
  }

  /**
   * What a ray hits first.
   * @param {Shown[]} all @param {number[]} origin @param {number[]} way of the ray, relative to the target
   */
  function first(all, origin, way) {
    let best = null;
    const long = way[0] ** 2 + way[1] ** 2 + way[2] ** 2;
    for (const shown of all) {
      const m = shown.matrix;
      // Most bodies are not near the ray.
      const x = m[0] - origin[0], y = m[1] - origin[1], z = m[2] - origin[2];
      const t = (x * way[0] + y * way[1] + z * way[2]) / long;
      if ((x - t * way[0]) ** 2 + (y - t * way[1]) ** 2 + (z - t * way[2]) ** 2 > 1.0001 * shown.size ** 2) continue;
      const from = toBody(m, [origin[0] - m[0], origin[1] - m[1], origin[2] - m[2]]), along = toBody(m, way);
      for (const [index, part] of shown.parts.entries()) {
        const hit = shown.heart ? see(part, from, along, heartOf(shown)) : enter(part, from, along);
        if (!hit || !(hit.t > 0)) continue;
        if (!best || hit.t < best.t) best = { shown, part: index, face: hit.face, t: hit.t };
      }
    }
    return best;
  }

  /**
   * Where the heart of a wall is, as its leaf sees it.
   * @param {Shown} shown @returns {Triple}
   */
  function heartOf({ heart, matrix: m }) {
    const [x, y, z, own] = heart ? heart.value : [0, 0, 0, 1];
    return own ? [x, y, z] : toBody(m, [x - m[0], y - m[1], z - m[2]]);
  }

  return { first, enter, feature, toWorld, toBody };
})();
