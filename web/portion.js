"use strict";

/**
 * Which part of the state graph is drawn: all that was looked at, or what is near the present state; and chains of states
 * as one node each.
 *
 * @typedef {{ states: number[] }} Knot  A node of the drawing: a state, or a chain of several, in their order.
 * @typedef {{ spots: Knot[], edges: [number, number][], choices: DataChoice[][], layers: number[] | null,
 *   left: number }} Drawing  Of each edge, what leads along it; `left`: how many states are left out.
 */
const Portion = (() => {
  /** Chains are folded that have so many states between their ends. */
  const shortest = 3;

  /**
   * All states of the graph: those that were looked at, and where these lead.
   * @param {Player} player
   */
  function all(player) {
    const { states } = player.data;
    // What comes after the end of a run is no state of the graph: nothing but turning goes on there.
    const after = new Set(player.runs.flatMap((run) => run.steps.filter((step) => step.tail).map((step) => step.to)));
    /** @type {number[]} */
    const looked = [];
    // Beyond its bound, the file has where the choices of its runs lead, but not among what is possible.
    for (const run of player.runs) {
      let from = run.start;
      for (const { choice, label, to } of run.steps) {
        const taken = choice === null ? undefined : (states[from].next || [])[choice];
        if (taken && taken.to === null && taken.label === label) taken.to = to;
        from = to;
      }
    }
    states.forEach((state, index) => {
      if (state.next !== null && !after.has(index)) looked.push(index);
    });
    const found = new Set(looked);
    for (const state of looked) for (const { to } of states[state].next || []) if (to !== null) found.add(to);
    return { looked: looked.length, states: [...found] };
  }

  /**
   * Those that are so many steps before or after a state, and how many: before it the number is negative. Of very many,
   * the nearest.
   * @param {DataState[]} all @param {number[]} among @param {number} centre @param {number} steps @param {number} most
   */
  function near(all, among, centre, steps, most) {
    const wanted = new Set(among);
    /** @type {Map<number, number[]>} */
    const into = new Map();
    for (const from of among)
      for (const { to } of all[from].next || []) if (to !== null) into.set(to, (into.get(to) || []).concat(from));
    const after = (/** @type {number} */ n) => (all[n].next || []).flatMap(({ to }) => (to === null ? [] : [to]));
    const sides = [new Map([[centre, 0]]), new Map([[centre, 0]])];
    const ways = [after, (/** @type {number} */ n) => into.get(n) || []];
    /** @type {Map<number, number>} */
    const found = new Map([[centre, 0]]);
    for (let k = 1; k <= steps; k++)
      for (const side of [0, 1])
        for (const [state, far] of sides[side])
          if (far === k - 1)
            for (const to of ways[side](state)) {
              if (!wanted.has(to) || sides[side].has(to) || (!found.has(to) && found.size >= most)) continue;
              sides[side].set(to, k);
              if (!found.has(to)) found.set(to, side === 0 ? k : -k);
            }
    return found;
  }

  /**
   * @param {DataState[]} all @param {number[]} states @param {Map<number, number> | null} far their layers, if known
   * @param {boolean} folding @param {Set<number>} kept what is no part of a chain
   * @returns {Drawing}
   */
  function drawing(all, states, far, folding, kept) {
    const wanted = new Set(states);
    /** @type {Map<number, Map<number, DataChoice[]>>} */
    const out = new Map();
    /** @type {Map<number, Set<number>>} */
    const into = new Map(states.map((state) => [state, new Set()]));
    for (const from of states) {
      /** @type {Map<number, DataChoice[]>} */
      const to = new Map();
      for (const choice of all[from].next || [])
        if (choice.to !== null && wanted.has(choice.to)) {
          to.set(choice.to, (to.get(choice.to) || []).concat(choice));
          /** @type {Set<number>} */ (into.get(choice.to)).add(from);
        }
      out.set(from, to);
    }
    // A state with one way in and one way out, which nothing else tells apart.
    const plain = (/** @type {number} */ n) =>
      !kept.has(n) && /** @type {any} */ (out.get(n)).size === 1 && /** @type {any} */ (into.get(n)).size === 1 &&
      !out.get(n)?.has(n) && all[n].next !== null && all[n].stuck === null;
    /** @type {Map<number, number>} */
    const spotOf = new Map();
    /** @type {Knot[]} */
    const spots = [];
    const chains = folding ? chained(states, plain, out, into) : [];
    const inside = new Map(chains.flatMap((chain) => chain.map((state) => [state, chain])));
    for (const state of states) {
      if (spotOf.has(state)) continue;
      const chain = inside.get(state) || [state];
      for (const one of chain) spotOf.set(one, spots.length);
      spots.push({ states: chain });
    }
    /** @type {[number, number][]} */
    const edges = [];
    /** @type {DataChoice[][]} */
    const choices = [];
    for (const [from, to] of out)
      for (const [state, all] of to) {
        const [a, b] = [/** @type {number} */ (spotOf.get(from)), /** @type {number} */ (spotOf.get(state))];
        if (a === b && spots[a].states.length > 1) continue;
        edges.push([a, b]);
        choices.push(all);
      }
    return { spots, edges, choices, layers: far && levels(spots, far), left: 0 };
  }

  /**
   * The longest chains of plain states.
   * @param {number[]} states @param {(state: number) => boolean} plain
   * @param {Map<number, Map<number, DataChoice[]>>} out @param {Map<number, Set<number>>} into
   */
  function chained(states, plain, out, into) {
    const only = (/** @type {Iterable<number>} */ of) => [...of][0];
    const seen = new Set();
    /** @type {number[][]} */
    const chains = [];
    for (const state of states) {
      if (seen.has(state) || !plain(state)) continue;
      let first = state;
      for (let back = only(into.get(first) || []); plain(back) && back !== state; back = only(into.get(first) || [])) first = back;
      const chain = [first];
      for (let on = only(out.get(first)?.keys() || []); plain(on) && on !== first; on = only(out.get(on)?.keys() || [])) chain.push(on);
      for (const one of chain) seen.add(one);
      if (chain.length >= shortest) chains.push(chain);
    }
    return chains;
  }

  /**
   * Layers from 0 on, without gaps.
   * @param {Knot[]} spots @param {Map<number, number>} far
   */
  function levels(spots, far) {
    const own = spots.map(({ states }) => /** @type {number} */ (far.get(states[0])));
    const sorted = [...new Set(own)].sort((a, b) => a - b);
    const at = new Map(sorted.map((level, i) => [level, i]));
    return own.map((level) => /** @type {number} */ (at.get(level)));
  }

  return { all, near, drawing };
})();
