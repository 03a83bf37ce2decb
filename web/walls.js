"use strict";

/**
 * Which fixed bodies are walls: those around other bodies, and those that are much larger than all that moves.
 *
 * The faces of a wall that are between the eye and what it is around are cut away.
 */
const Walls = (() => {
  /** Of many bodies some are looked at. */
  const some = 40;

  /**
   * Whether a body is seen from a place along most of its axes: whoever is there is within it.
   * @param {Part[]} parts @param {Triple} from
   */
  function around(parts, from) {
    const ways = /** @type {Triple[]} */ ([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]);
    const met = ways.filter((way) => parts.some((part) => {
      const hit = Pick.enter(part, from, way);
      return hit !== null && hit.t > 0;
    }));
    return met.length > 3;
  }

  /** @param {{ low: number[], high: number[] }} box */
  const middle = ({ low, high }) => low.map((l, i) => (l + high[i]) / 2);

  /**
   * The leaves that are walls, each with a place in what it is around, as the leaf sees it, if it is by itself.
   * @param {Bodies} bodies @param {Box[]} boxes
   * @returns {Map<number, Triple | null>}
   */
  function find(bodies, boxes) {
    /** @type {Map<number, Triple | null>} */
    const found = new Map();
    const moving = boxes.filter((b) => !b.fixed);
    const largest = moving.reduce((most, b) => Math.max(most, Frame.size(b)), 0);
    for (const wall of boxes) {
      if (!wall.fixed) continue;
      const within = boxes.filter((b) => b !== wall && Frame.size(b) < Frame.size(wall) &&
        middle(b).every((x, i) => wall.low[i] < x && x < wall.high[i]));
      const every = Math.ceil(within.length / some);
      const parts = bodies.models[wall.leaf], { matrix: m } = wall;
      const places = within.filter((_, i) => i % every === 0)
        .map((b) => Pick.toBody(m, middle(b).map((x, i) => x - m[i])));
      const heart = parts.length < 200 ? places.find((at) => around(parts, at)) : undefined;
      if (heart || (largest > 0 && Frame.size(wall) > 4 * largest)) found.set(wall.leaf, heart || null);
    }
    return found;
  }

  return { find };
})();
