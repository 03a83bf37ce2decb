"use strict";

/**
 * Places the nodes of a graph in layers, with few crossings of edges: by the middles of their neighbours (the method of
 * Sugiyama). It uses nothing else of the page, so that a worker can have it.
 */
const Layers = (() => {
  /**
   * @typedef {{ count: number, edges: [number, number][], roots: number[], given?: number[], aspect?: number }} Wanted
   *   Nodes 0 … count - 1; those of the first layer; the layers, where these are known; how wide the picture of a map is, in
   *   which layers are folded, beside its height.
   * @typedef {{ layer: number[], order: number[][], x: number[], y: number[] }} Placed  The layer of each node; the nodes
   *   of each layer, left to right; their places, those of neighbours in a row at least 1 from each other.
   */

  /** @param {Wanted} wanted @returns {Placed} */
  function place({ count, edges, roots, given, aspect }) {
    const layer = given || distances(count, edges, roots);
    /** @type {number[][]} */
    const order = Array.from({ length: layer.reduce((most, l) => Math.max(most, l + 1), 0) }, () => []);
    // In the order of a search through the graph, so that what belongs together stands together at first.
    for (const node of searched(count, edges, layer)) order[layer[node]].push(node);
    const sides = neighbours(layer, edges);
    sweep(order, layer, edges, sides);
    return { layer, order, ...(aspect ? folded(order, count, columns(order, aspect)) : spread(order, count, sides)) };
  }

  /**
   * How far nodes are from the roots; what these do not lead to begins anew.
   * @param {number} count @param {[number, number][]} edges @param {number[]} roots
   */
  function distances(count, edges, roots) {
    /** @type {number[][]} */
    const out = Array.from({ length: count }, () => []);
    for (const [a, b] of edges) out[a].push(b);
    const layer = new Array(count).fill(-1);
    const from = (/** @type {number[]} */ nodes) => {
      const queue = nodes.filter((node) => layer[node] < 0);
      for (const node of queue) layer[node] = 0;
      for (const node of queue)
        for (const to of out[node])
          if (layer[to] < 0) {
            layer[to] = layer[node] + 1;
            queue.push(to);
          }
    };
    from([...new Set(roots)]);
    for (let node = 0; node < count; node++) from([node]);
    return layer;
  }

  /** @param {number} count @param {[number, number][]} edges @param {number[]} layer */
  function searched(count, edges, layer) {
    /** @type {number[][]} */
    const out = Array.from({ length: count }, () => []);
    for (const [a, b] of edges) out[a].push(b);
    const seen = new Uint8Array(count);
    /** @type {number[]} */
    const found = [];
    const starts = [...Array(count).keys()].sort((a, b) => layer[a] - layer[b] || a - b);
    for (const start of starts) {
      const stack = [start];
      for (let node = stack.pop(); node !== undefined; node = stack.pop()) {
        if (seen[node]) continue;
        seen[node] = 1;
        found.push(node);
        for (let i = out[node].length - 1; i >= 0; i--) if (!seen[out[node][i]]) stack.push(out[node][i]);
      }
    }
    return found;
  }

  /**
   * Of each node, those that it has an edge with in a layer above, and below.
   * @param {number[]} layer @param {[number, number][]} edges
   */
  function neighbours(layer, edges) {
    /** @type {{ above: number[][], below: number[][] }} */
    const sides = { above: layer.map(() => []), below: layer.map(() => []) };
    for (const [a, b] of edges) {
      if (layer[a] === layer[b]) continue;
      const [upper, lower] = layer[a] < layer[b] ? [a, b] : [b, a];
      sides.above[lower].push(upper);
      sides.below[upper].push(lower);
    }
    return sides;
  }

  /**
   * Sorts each layer by the middles of the neighbours, down and up; the best that was seen stays.
   * @param {number[][]} order @param {number[]} layer @param {[number, number][]} edges
   * @param {{ above: number[][], below: number[][] }} sides
   */
  function sweep(order, layer, edges, sides) {
    const at = new Array(layer.length).fill(0), middle = new Array(layer.length).fill(0);
    const number = (/** @type {number[]} */ nodes) =>
      nodes.forEach((node, i) => {
        at[node] = nodes.length === 1 ? 0.5 : i / (nodes.length - 1);
      });
    order.forEach(number);
    let best = order.map((nodes) => nodes.slice());
    let fewest = crossings(order, layer, edges);
    for (let round = 0; round < 12 && fewest > 0; round++) {
      const down = round % 2 === 0, by = down ? sides.above : sides.below;
      for (const nodes of down ? order : order.slice().reverse()) {
        for (const node of nodes) {
          const all = by[node];
          middle[node] = all.length === 0 ? at[node] : all.reduce((sum, other) => sum + at[other], 0) / all.length;
        }
        nodes.sort((a, b) => middle[a] - middle[b] || at[a] - at[b] || a - b);
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
   * How many edges between layers beside each other cross: pairs in the wrong order, counted by a Fenwick tree.
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
    between.forEach((pairs, l) => {
      if (pairs.length < 2) return;
      pairs.sort((p, q) => p[0] - q[0] || p[1] - q[1]);
      const size = order[l + 1].length, tree = new Int32Array(size + 1);
      pairs.forEach(([, b], i) => {
        let upTo = 0;
        for (let k = b + 1; k > 0; k -= k & -k) upTo += tree[k];
        count += i - upTo;
        for (let k = b + 1; k <= size; k += k & -k) tree[k] += 1;
      });
    });
    return count;
  }

  /**
   * Places below and above the middles of the neighbours, as near as the order and the distance of 1 allow.
   * @param {number[][]} order @param {number} count @param {{ above: number[][], below: number[][] }} sides
   */
  function spread(order, count, sides) {
    const x = new Array(count).fill(0), y = new Array(count).fill(0);
    order.forEach((nodes, depth) => nodes.forEach((node, i) => {
      x[node] = i - (nodes.length - 1) / 2;
      y[node] = depth;
    }));
    for (let round = 0; round < 8; round++) {
      const down = round % 2 === 0, by = down ? sides.above : sides.below;
      for (const nodes of down ? order : order.slice().reverse()) apart(nodes, x, by);
    }
    const least = x.reduce((low, value) => Math.min(low, value), Infinity);
    return { x: x.map((value) => value - least), y };
  }

  /**
   * The places of a row nearest to the wanted ones, in the sense of least squares, at least 1 from each other: blocks
   * of nodes that stand at that distance move together (pool adjacent violators).
   * @param {number[]} nodes @param {number[]} x @param {number[][]} by
   */
  function apart(nodes, x, by) {
    /** @type {{ sum: number, size: number }[]} */
    const blocks = [];
    nodes.forEach((node, i) => {
      const all = by[node];
      const wanted = all.length === 0 ? x[node] : all.reduce((sum, other) => sum + x[other], 0) / all.length;
      let block = { sum: wanted - i, size: 1 };
      for (let last = blocks[blocks.length - 1]; last && last.sum * block.size >= block.sum * last.size; last = blocks[blocks.length - 1]) {
        blocks.pop();
        block = { sum: block.sum + last.sum, size: block.size + last.size };
      }
      blocks.push(block);
    });
    let i = 0;
    for (const { sum, size } of blocks) for (let k = 0; k < size; k++, i++) x[nodes[i]] = sum / size + i;
  }

  /**
   * So many columns that dots are as large as may be.
   * @param {number[][]} order @param {number} aspect
   */
  function columns(order, aspect) {
    const most = order.reduce((all, nodes) => Math.max(all, nodes.length), 1);
    let best = most, largest = 0;
    for (let count = 1; count <= most; count = Math.max(count + 1, Math.floor(count * 1.03))) {
      const rows = order.reduce((sum, nodes) => sum + Math.max(1, Math.ceil(nodes.length / count)) + 1, -1);
      const size = Math.min(aspect / count, 1 / rows);
      if (size > largest) [best, largest] = [count, size];
    }
    return best;
  }

  /**
   * A map by depth: each layer is a band of rows, so that it is as wide as so many columns; left and right stay.
   * @param {number[][]} order @param {number} count @param {number} columns
   */
  function folded(order, count, columns) {
    const x = new Array(count).fill(0), y = new Array(count).fill(0);
    let row = 0;
    for (const nodes of order) {
      const rows = Math.max(1, Math.ceil(nodes.length / columns)), wide = Math.ceil(nodes.length / rows);
      nodes.forEach((node, i) => {
        x[node] = (columns - wide) / 2 + Math.floor(i / rows);
        y[node] = row + (i % rows);
      });
      row += rows + 1;
    }
    return { x, y };
  }

  return { place, crossings };
})();
