"use strict";

/**
 * Which fixed bodies are walls: those around other bodies, by themselves or several of them together, and those that are
 * much larger than all that moves.
 *
 * The faces of a wall that are between the eye and what it is around are cut away. Where it is not around anything by
 * itself, it is whole unless it would hide something that moves.
 */
const Walls = (() => {
  /** Of many bodies some are looked at. */
  const some = 40;

  const ways = /** @type {Triple[]} */ ([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]);

  /**
   * How far a body is from a place along a direction, if it is seen there.
   * @param {Part[]} parts @param {Triple} from @param {Triple} way
   */
  function distance(parts, from, way) {
    return parts.reduce((near, part) => {
      const hit = Pick.enter(part, from, way);
      return hit && hit.t > 0 ? Math.min(near, hit.t) : near;
    }, Infinity);
  }

  /**
   * Whether a body is seen from a place along most of its axes: whoever is there is within it.
   * @param {Part[]} parts @param {Triple} from
   */
  const around = (parts, from) => ways.filter((way) => distance(parts, from, way) < Infinity).length > 3;

  /** @param {{ low: number[], high: number[] }} box */
  const middle = ({ low, high }) => low.map((l, i) => (l + high[i]) / 2);

  /**
   * A place and a direction, as a body sees them.
   * @param {Float64Array} m @param {number[]} at @param {number[]} way @returns {[Triple, Triple]}
   */
  const seen = (m, at, way) => [Pick.toBody(m, at.map((x, i) => x - m[i])), Pick.toBody(m, way)];

  /**
   * Those that are around bodies together: they are seen along most axes.
   * @param {Bodies} bodies @param {Box[]} fixed @param {Box[]} moving
   */
  function together(bodies, fixed, moving) {
    const every = Math.ceil(moving.length / some), found = new Set();
    for (const b of moving.filter((_, i) => i % every === 0)) {
      const at = middle(b), met = ways.map((way) => {
        let nearest = Infinity, leaf = -1;
        for (const wall of fixed) {
          const t = distance(bodies.models[wall.leaf], ...seen(wall.matrix, at, way));
          if (t < nearest) [nearest, leaf] = [t, wall.leaf];
        }
        return leaf;
      }).filter((leaf) => leaf >= 0);
      if (met.length > 3) for (const leaf of met) found.add(leaf);
    }
    return found;
  }

  /**
   * The leaves that are walls, each with a place in what it is around, as the leaf sees it, if it is by itself; and which of
   * them are around others together.
   * @param {Bodies} bodies @param {Box[]} boxes
   * @returns {Map<number, Triple | null> & { shared: Set<number> }}
   */
  function find(bodies, boxes) {
    /** @type {Map<number, Triple | null>} */
    const found = new Map();
    const moving = boxes.filter((b) => !b.fixed), fixed = boxes.filter((b) => b.fixed);
    const largest = moving.reduce((most, b) => Math.max(most, Frame.size(b)), 0);
    const large = fixed.filter((b) => Frame.size(b) > 1.5 * largest && bodies.models[b.leaf].length < 200);
    const shared = large.length > 1 && large.length < 200 ? together(bodies, large, moving) : new Set();
    for (const wall of fixed) {
      const within = boxes.filter((b) => b !== wall && Frame.size(b) < Frame.size(wall) &&
        middle(b).every((x, i) => wall.low[i] < x && x < wall.high[i]));
      const every = Math.ceil(within.length / some);
      const parts = bodies.models[wall.leaf], { matrix: m } = wall;
      const places = within.filter((_, i) => i % every === 0)
        .map((b) => Pick.toBody(m, middle(b).map((x, i) => x - m[i])));
      const heart = parts.length < 200 ? places.find((at) => around(parts, at)) : undefined;
      if (heart || shared.has(wall.leaf) || (largest > 0 && Frame.size(wall) > 4 * largest)) found.set(wall.leaf, heart || null);
    }
    return Object.assign(found, { shared });
  }

  /**
   * Those of some walls that are between an eye and one of some places.
   * @param {Bodies} bodies @param {Box[]} walls @param {number[][]} places
   * @param {(place: number[]) => number[]} back the way from a place to the eye
   */
  function hiding(bodies, walls, places, back) {
    const ways = places.map(back), found = new Set();
    for (const { leaf, matrix } of walls) {
      const parts = bodies.models[leaf];
      if (parts.length < 200 && places.some((at, i) => distance(parts, ...seen(matrix, at, ways[i])) < 1)) found.add(leaf);
    }
    return found;
  }

  return { find, hiding, middle };
})();
