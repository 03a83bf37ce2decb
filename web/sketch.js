"use strict";

/**
 * The drawing of a state graph of which the nodes can be read: an element for each state, or chain of states, and for each
 * edge.
 */
const Sketch = (() => {
  const margin = 26, radius = 9;
  /** How wide a letter beside an edge is. */
  const letter = 5.1;
  /**
   * What transitions of a kind are called.
   * @type {{ [kind: string]: string }}
   */
  const kinds = {
    time: "time passes", bind: "a bond is made", close: "a bond closes a ring", bounce: "a bounce", absorb: "an absorption",
    weak: "a weak split", strong: "a strong split", draw: "a draw by chance", lot: "a lot by chance",
  };

  /**
   * @typedef {{ data: PageData, drawing: Drawing, placed: ReturnType<typeof Layers.place>, labels: boolean,
   *   lit: Map<number, boolean> | null, visit: (states: number[]) => void }} Shown
   * @typedef {{ picture: SVGElement, nodes: SVGElement[], lines: Map<string, SVGElement>,
   *   places: { x: number, y: number }[] }} Made  By the numbers of nodes, and by those of both ends.
   */

  /** @param {Shown} shown @returns {Made} */
  function make(shown) {
    const { drawing, placed, labels } = shown;
    const gap = labels ? { x: 132, y: 86 } : { x: 46, y: 58 };
    const places = drawing.spots.map((_, i) => ({ x: margin + placed.x[i] * gap.x, y: margin + placed.y[i] * gap.y }));
    const width = places.reduce((most, p) => Math.max(most, p.x), 0) + margin + (labels ? 50 : 0);
    const height = places.reduce((most, p) => Math.max(most, p.y), 0) + margin;
    const picture = Dom.draw("svg", {
      viewBox: `0 0 ${Math.round(width)} ${Math.round(height)}`, width: Math.round(width), height: Math.round(height),
      role: "group", "aria-label": `Graph of ${drawing.spots.length} nodes`,
    });
    const [below, words, above] = ["edges", "edge-words", "nodes"].map((name) => Dom.draw("g", { class: name }));
    /** @type {Map<string, SVGElement>} */
    const lines = new Map();
    const [outgoing, incoming] = [0, 1].map((end) => {
      const count = new Array(drawing.spots.length).fill(0);
      for (const ends of drawing.edges) count[ends[end]] += 1;
      return count;
    });
    /** @type {number[][]} */
    const taken = places.map(({ x, y }, i) => {
      const wide = drawing.spots[i].states.length > 1 ? 17 : radius + 1;
      return [x - wide, y - radius - 1, x + wide, y + radius + 1];
    });
    const free = (/** @type {number[]} */ room) => !taken.some((t) => t[0] < room[2] && room[0] < t[2] && t[1] < room[3] && room[1] < t[3]);
    drawing.edges.forEach(([a, b], i) => {
      const { path, at } = course(places[a], places[b], a === b, gap.y);
      const line = edge(shown, path, drawing.choices[i], places[b].y > places[a].y);
      lines.set(`${a}-${b}`, line);
      below.append(line);
      const text = said(shown, drawing.choices[i]);
      if (text === "") return;
      // Near the end that has this edge alone, and else at another height than those beside it.
      const first = outgoing[a] > 1 && incoming[b] === 1 ? 0.78 : incoming[b] > 1 && outgoing[a] === 1 ? 0.22 : 0.4 + 0.1 * (i % 3);
      // Where there is no room for it, it is said in the title of the edge alone.
      for (const part of [first, 0.5, 0.35, 0.65, 0.22, 0.78]) {
        const { x, y } = at(part), half = (letter * text.length) / 2, room = [x - half, y - 5, x + half, y + 5];
        if (!free(room)) continue;
        taken.push(room);
        words.append(Dom.draw("text", { class: "edge-text", x: x.toFixed(1), y: (y + 3).toFixed(1), text }));
        break;
      }
    });
    const nodes = drawing.spots.map(({ states }, i) => node(shown, states, places[i]));
    // In reading order, for those who go through them.
    for (const layer of placed.order) for (const i of layer) above.append(nodes[i]);
    picture.append(below, words, above);
    return { picture, nodes, lines, places };
  }

  /**
   * The line of an edge, and the place at a part of it.
   * @param {{ x: number, y: number }} a @param {{ x: number, y: number }} b @param {boolean} loop @param {number} gap
   */
  function course(a, b, loop, gap) {
    const r = radius;
    if (loop) return { path: `M${a.x + r} ${a.y - 3}c16 -12 16 18 0 6`, at: () => ({ x: a.x + r + 14, y: a.y }) };
    /** @type {[number, number][]} */
    let points;
    if (b.y > a.y) {
      const middle = (a.y + b.y) / 2, bend = b.y - a.y > gap * 1.5 ? (b.x - a.x >= 0 ? 22 : -22) : 0;
      points = [[a.x, a.y + r], [a.x + bend, middle], [b.x + bend, middle], [b.x, b.y - r - 3]];
    } else if (b.y === a.y) points = [[a.x, a.y + r], [a.x, a.y + 32], [b.x, b.y + 32], [b.x, b.y + r + 3]];
    else {
      const side = a.x >= b.x ? 26 : -26;
      points = [[a.x, a.y - r], [a.x + side, a.y - 30], [b.x + side, b.y + 30], [b.x, b.y + r + 3]];
    }
    const at = (/** @type {number} */ t) => {
      const weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
      const sum = (/** @type {number} */ k) => points.reduce((all, point, i) => all + weights[i] * point[k], 0);
      return { x: sum(0), y: sum(1) };
    };
    return { path: `M${points[0].join(" ")}C${points.slice(1).flat().join(" ")}`, at };
  }

  /**
   * The probability of one of several, or of all of them together; null where chance does not decide.
   * @param {DataChoice[]} choices
   */
  function chance(choices) {
    if (!choices.every((choice) => choice.chance !== undefined)) return null;
    return choices.reduce((sum, choice) => Rational.add(sum, Rational.of(choice.chance || "0/1")), Rational.zero);
  }

  /** @param {Shown} shown @param {DataChoice[]} choices */
  function said({ data, labels }, choices) {
    const p = chance(choices);
    const exact = p === null ? "" : Exactly.text(p);
    const likely = p === null ? "" : exact.length <= 8 ? exact : Exactly.told(p);
    if (!labels) return likely;
    const { words, text } = data.labels[choices[0].label];
    const more = choices.length > 1 ? ` +${choices.length - 1}` : "";
    return [likely, Dom.clip(words || text, likely === "" ? 24 : 18) + more].filter(Boolean).join(": ");
  }

  /** @param {Shown} shown @param {string} path @param {DataChoice[]} choices @param {boolean} down */
  function edge({ data }, path, choices, down) {
    const lines = choices.map((choice) => {
      const words = Dom.clip(data.labels[choice.label].words, 200);
      return choice.chance === undefined ? words : `${words}, with probability ${Exactly.text(Rational.of(choice.chance))}`;
    });
    const kind = data.labels[choices[0].label].kind;
    return Dom.draw("path", { d: path, class: `edge kind-${kind}${down ? "" : " back"}` }, [
      Dom.draw("title", { text: lines.join("\n") }),
    ]);
  }

  /** @param {PageData} data @param {number[]} states what is said of a node */
  function told(data, states) {
    if (states.length > 1)
      return `${states.length} states in a row, from ${states[0]} to ${states[states.length - 1]}`;
    const { rests, stuck, next } = data.states[states[0]];
    return `State ${states[0]}` + (rests ? ", where nothing happens any more" : stuck ? ", stuck"
      : next === null ? ", not followed further" : `, ${next.length} possible`);
  }

  /** @param {PageData} data @param {number[]} states */
  function kind(data, states) {
    const { rests, stuck, next } = data.states[states[0]];
    return states.length > 1 ? "chain" : next === null ? "away" : rests ? "rests" : stuck ? "stuck" : "";
  }

  /** @param {Shown} shown @param {number[]} states @param {{ x: number, y: number }} place */
  function node({ data, lit, visit }, states, { x, y }) {
    const text = told(data, states), chain = states.length > 1;
    const found = lit !== null && states.some((state) => lit.get(state));
    return Dom.draw("g", {
      class: `node ${kind(data, states)}${found ? " lit" : ""}`, role: "button", tabindex: "-1",
      "aria-label": found ? `${text}, found` : text, "data-testid": `state-${states[0]}`,
      transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`, click: () => visit(states),
    }, [
      chain ? Dom.draw("rect", { x: -16, y: -radius, width: 32, height: 2 * radius, rx: radius })
        : Dom.draw("circle", { r: radius }),
      Dom.draw("text", { class: "node-text", dy: "3.2", text: chain ? `… ${states.length} …` : String(states[0]) }),
      Dom.draw("title", { text }),
    ]);
  }

  /**
   * What colours and marks mean, of those that are there.
   * @param {PageData} data @param {Drawing} drawing @param {boolean} found whether states were searched
   */
  function legend(data, drawing, found) {
    const seen = new Set(drawing.choices.flatMap((all) => all.map((choice) => data.labels[choice.label].kind)));
    const marks = new Set(drawing.spots.map(({ states }) => kind(data, states)));
    /** @type {[string, string][]} */
    const dots = [["here", "the present state"]];
    if (found) dots.push(["lit", "found"]);
    if (marks.has("rests")) dots.push(["rests", "nothing happens any more"]);
    if (marks.has("stuck")) dots.push(["stuck", "stuck"]);
    if (marks.has("away")) dots.push(["away", "not followed further"]);
    if (marks.has("chain")) dots.push(["chain", "states in a row"]);
    const small = (/** @type {SVGElement} */ what) => Dom.draw("svg", { width: 26, height: 14, viewBox: "-13 -7 26 14", "aria-hidden": "true" }, [what]);
    return [
      ...Object.keys(kinds).filter((kind) => seen.has(kind)).map((kind) => Dom.make("li", {}, [
        small(Dom.draw("path", { class: `edge kind-${kind} full`, d: "M-12 0h24" })), kinds[kind]])),
      Dom.make("li", {}, [small(Dom.draw("path", { class: "edge way", d: "M-12 0h24" })), "the run that is shown"]),
      ...dots.map(([mark, words]) => Dom.make("li", {}, [
        small(Dom.draw("g", { class: `mark-node ${mark}` }, [mark === "chain"
          ? Dom.draw("rect", { x: -11, y: -5, width: 22, height: 10, rx: 5 }) : Dom.draw("circle", { r: 5.5 })])), words])),
    ];
  }

  return { make, told, kind, kinds, legend };
})();
