"use strict";

/** Places the nodes of a graph in layers by their distance from the first ones, with few crossings of edges. */
const Layers = (() => {
  /**
   * @param {number} count nodes 0 … count - 1
   * @param {[number, number][]} edges
   * @param {number[]} roots
   * @returns {{layer: number[], order: number[][]}} the layer of each node; the nodes of each, left to right
   */
  function place(count, edges, roots) {
    /** @type {number[][]} */
    const out = Array.from({ length: count }, () => []);
    for (const [a, b] of edges) if (a !== b) out[a].push(b);
    const layer = new Array(count).fill(-1);
    /** @type {number[][]} */
    const order = [];
    const spread = (/** @type {number[]} */ from) => {
      /** @type {number[]} */
      const queue = [];
      for (const node of from)
        if (layer[node] < 0) {
          layer[node] = 0;
          queue.push(node);
        }
      for (let i = 0; i < queue.length; i++) {
        const node = queue[i];
        (order[layer[node]] = order[layer[node]] || []).push(node);
        for (const to of out[node])
          if (layer[to] < 0) {
            layer[to] = layer[node] + 1;
            queue.push(to);
          }
      }
    };
    spread(roots);
    for (let node = 0; node < count; node++) spread([node]);
    sweep(order, layer, edges);
    return { layer, order };
  }

  /**
   * Sorts each layer by the middles of the neighbours, down and up; the best that was seen stays.
   * @param {number[][]} order @param {number[]} layer @param {[number, number][]} edges
   */
  function sweep(order, layer, edges) {
    /** @type {number[][]} */
    const above = layer.map(() => []);
    /** @type {number[][]} */
    const below = layer.map(() => []);
    for (const [a, b] of edges) {
      if (layer[a] < layer[b]) {
        above[b].push(a);
        below[a].push(b);
      } else if (layer[a] > layer[b]) {
        above[a].push(b);
        below[b].push(a);
      }
    }
    const at = new Array(layer.length).fill(0);
    const number = (/** @type {number[]} */ nodes) =>
      nodes.forEach((node, i) => {
        at[node] = nodes.length === 1 ? 0.5 : i / (nodes.length - 1);
      });
    order.forEach(number);
    let best = order.map((nodes) => nodes.slice());
    let fewest = crossings(order, layer, edges);
    for (let round = 0; round < 12 && fewest > 0; round++) {
      const down = round % 2 === 0;
      const by = down ? above : below;
      for (const nodes of down ? order : order.slice().reverse()) {
        const middle = new Map(
          nodes.map((node) => [
            node,
            by[node].length === 0
              ? at[node]
              : by[node].reduce((sum, other) => sum + at[other], 0) / by[node].length,
          ]),
        );
        nodes.sort(
          (a, b) => /** @type {number} */ (middle.get(a)) - /** @type {number} */ (middle.get(b)) || a - b,
        );
        number(nodes);
      }
      const now = crossings(order, layer, edges);
      if (now < fewest) {
        fewest = now;
        best = order.map((nodes) => nodes.slice());
      }
    }
    best.forEach((nodes, i) => {
      order[i] = nodes;
    });
  }

  /**
   * How many edges between layers beside each other cross.
   * @param {number[][]} order @param {number[]} layer @param {[number, number][]} edges
   */
  function crossings(order, layer, edges) {
    const at = new Array(layer.length).fill(0);
    for (const nodes of order)
      nodes.forEach((node, i) => {
        at[node] = i;
      });
    /** @type {[number, number][][]} */
    const between = order.map(() => []);
    for (const [a, b] of edges) if (layer[b] === layer[a] + 1) between[layer[a]].push([at[a], at[b]]);
    let count = 0;
    for (const pairs of between) {
      for (let i = 0; i < pairs.length; i++)
        for (let j = 0; j < i; j++) {
          if ((pairs[i][0] - pairs[j][0]) * (pairs[i][1] - pairs[j][1]) < 0) count += 1;
        }
    }
    return count;
  }

  return { place };
})();
