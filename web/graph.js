"use strict";

/** A drawing of the state graph, in layers by the number of steps from the beginning. */
const Graph = (() => {
  /** States up to which a drawing is of use. */
  const most = 400;
  const gap = { x: 46, y: 58 };
  const svg = { margin: 26, node: 9 };
  /** @type {Player} */
  let player;
  /** @type {HTMLElement} */
  let box;
  /**
   * The states that are drawn, by their numbers in the drawing.
   * @type {number[]}
   */
  let states = [];
  /** @type {Map<number, SVGElement>} */
  const nodes = new Map();
  /** @type {Map<number, {x: number, y: number}>} */
  const places = new Map();
  /** @type {Map<string, SVGElement>} */
  const lines = new Map();
  let drawn = false;
  /** Whether what is near the run is drawn alone. */
  let partly = false;
  let scale = 1;
  /** @type {SVGElement | null} */
  let picture = null;

  /** @param {Player} of */
  function start(of) {
    player = of;
    box = Dom.get("graph");
    player.on("run", () => {
      if (partly) again();
      else if (drawn) way();
    });
    player.on("move", () => drawn && here());
    player.on("grow", again);
  }

  /** More is known, or another part of it is to be drawn: at once where one sees it. */
  function again() {
    if (!drawn) return;
    drawn = false;
    if (Dom.get("graph-panel").hidden) return;
    const focused = [...nodes].find(([, node]) => node === document.activeElement);
    show();
    const node = focused && nodes.get(focused[0]);
    if (node) /** @type {any} */ (node).focus({ preventScroll: true });
  }

  /** Draws it, if that was not done yet. */
  function show() {
    if (!drawn) draw();
    drawn = true;
    way();
    here();
  }

  /** What is said of how much is known. */
  function known() {
    const all = player.data.states, { graph } = player.data;
    if (graph && graph.complete) return `All ${graph.states} states that there are.`;
    if (Live.on)
      return `${states.length} states were looked at so far; the graph grows as you go on.` +
        (partly ? ` The ${most} nearest to the run are drawn.` : "");
    if (!graph) return `The file holds the ${all.length} states of its runs.`;
    return `${graph.states} states, of ${graph.expanded} of which all that can happen is known: ` +
      `the graph was followed up to the bound of ${graph.bound} states.`;
  }

  /** Of many states that were looked at, those that are nearest to the run. */
  function near() {
    const all = player.data.states, wanted = new Set(states);
    const found = new Set([player.run.start, ...player.run.steps.map((step) => step.to)].filter((n) => wanted.has(n)));
    for (const state of found) {
      if (found.size >= most) break;
      for (const { to } of all[state].next || []) if (to !== null && wanted.has(to) && found.size < most) found.add(to);
    }
    return [...found].slice(0, most);
  }

  function draw() {
    const all = player.data.states;
    states = [];
    for (const map of [nodes, places, lines]) map.clear();
    const first = picture === null;
    picture = null;
    // What comes after the end of a run is no state of the graph: nothing but turning goes on there.
    const after = new Set(player.runs.flatMap((run) => run.steps.filter((step) => step.tail).map((step) => step.to)));
    all.forEach((state, index) => {
      if (state.next !== null && !after.has(index)) states.push(index);
    });
    partly = Live.on && states.length > most;
    const note = known();
    if (partly) states = near();
    if (states.length === 0 || states.length > most) {
      const why =
        states.length === 0
          ? "The file holds no states of which all that can happen is known."
          : `It is not drawn: more than ${most} states would tell little. Choices can be walked one by one.`;
      Dom.fill(
        box,
        Dom.make("p", { class: "empty", text: note, test: "graph-note" }),
        Dom.make("p", { class: "empty", text: why }),
      );
      return;
    }
    const number = new Map(states.map((state, i) => [state, i]));
    for (const state of states)
      for (const choice of all[state].next || []) {
        if (choice.to !== null && !number.has(choice.to) && states.length < 2 * most) {
          number.set(choice.to, states.length);
          states.push(choice.to);
        }
      }
    /** @type {[number, number][]} */
    const edges = [];
    /** @type {Map<string, DataChoice[]>} */
    const by = new Map();
    for (const [from, i] of number)
      for (const choice of all[from].next || []) {
        const to = choice.to === null ? undefined : number.get(choice.to);
        if (to === undefined) continue;
        const key = `${from}-${choice.to}`;
        if (!by.has(key)) edges.push([i, to]);
        by.set(key, (by.get(key) || []).concat(choice));
      }
    const roots = player.runs.map((run) => number.get(run.start)).filter((i) => i !== undefined);
    const { order } = Layers.place(states.length, edges, /** @type {number[]} */ (roots));
    const widest = Math.max(...order.map((layer) => layer.length));
    const width = 2 * svg.margin + (widest - 1) * gap.x;
    const height = 2 * svg.margin + (order.length - 1) * gap.y;
    order.forEach((layer, depth) =>
      layer.forEach((node, i) => {
        const shift = width / 2 + (i - (layer.length - 1) / 2) * gap.x;
        places.set(states[node], { x: shift, y: svg.margin + depth * gap.y });
      }),
    );
    picture = Dom.draw("svg", {
      viewBox: `0 0 ${width} ${height}`,
      width,
      height,
      role: "group",
      "aria-label": `Graph of ${states.length} states`,
    });
    const edgeLayer = Dom.draw("g", { class: "edges" });
    for (const [a, b] of edges)
      edgeLayer.append(edge(states[a], states[b], by.get(`${states[a]}-${states[b]}`) || []));
    const nodeLayer = Dom.draw("g", { class: "nodes" });
    for (const layer of order) for (const i of layer) nodeLayer.append(node(states[i]));
    picture.append(edgeLayer, nodeLayer);
    const tools = Dom.make("div", { class: "graph-tools" }, [
      Dom.make("p", { class: "quiet", text: note, test: "graph-note" }),
      Dom.button("−", () => zoom(scale / 1.25), { "aria-label": "Smaller" }),
      Dom.button("+", () => zoom(scale * 1.25), { "aria-label": "Larger" }),
      Dom.button("Fit", fit, {}),
      Dom.button("SVG", () => Dom.save("graph.svg", "image/svg+xml", file()), { title: "Save the drawing" }),
    ]);
    Dom.fill(box, tools, Dom.make("div", { class: "graph-view", keydown: walk }, [picture]));
    if (first) fit();
    else zoom(scale);
  }

  /** @param {number} to */
  function zoom(to) {
    if (!picture) return;
    scale = Math.max(0.15, Math.min(3, to));
    const [, , width, height] = (picture.getAttribute("viewBox") || "0 0 1 1").split(" ").map(Number);
    picture.setAttribute("width", String(Math.round(width * scale)));
    picture.setAttribute("height", String(Math.round(height * scale)));
  }

  function fit() {
    if (!picture || !picture.parentElement) return;
    const [, , width, height] = (picture.getAttribute("viewBox") || "0 0 1 1").split(" ").map(Number);
    const view = picture.parentElement;
    zoom(
      Math.min(1.6, Math.max(0.5, Math.min((view.clientWidth - 4) / width, (view.clientHeight - 4) / height))),
    );
  }

  /** @param {number} from @param {number} to @param {DataChoice[]} choices */
  function edge(from, to, choices) {
    const a = /** @type {{x: number, y: number}} */ (places.get(from));
    const b = /** @type {{x: number, y: number}} */ (places.get(to));
    const kinds = new Set(choices.map((choice) => player.data.labels[choice.label].kind));
    const words = choices.map((choice) => Dom.clip(player.data.labels[choice.label].words, 200)).join("\n");
    const r = svg.node;
    let path;
    if (from === to) path = `M${a.x + r} ${a.y - 3}c16 -12 16 18 0 6`;
    else if (b.y > a.y) {
      const middle = (a.y + b.y) / 2;
      const bend = b.y - a.y > gap.y * 1.5 ? (b.x - a.x >= 0 ? 22 : -22) : 0;
      path = `M${a.x} ${a.y + r}C${a.x + bend} ${middle} ${b.x + bend} ${middle} ${b.x} ${b.y - r - 3}`;
    } else if (b.y === a.y) {
      path = `M${a.x} ${a.y + r}C${a.x} ${a.y + 32} ${b.x} ${b.y + 32} ${b.x} ${b.y + r + 3}`;
    } else {
      const side = a.x >= b.x ? 26 : -26;
      path = `M${a.x} ${a.y - r}C${a.x + side} ${a.y - 30} ${b.x + side} ${b.y + 30} ${b.x} ${b.y + r + 3}`;
    }
    const line = Dom.draw("path", { d: path, class: `edge kind-${[...kinds][0]}${b.y > a.y ? "" : " back"}` }, [
      Dom.draw("title", { text: words }),
    ]);
    lines.set(`${from}-${to}`, line);
    return line;
  }

  /** @param {number} state */
  function node(state) {
    const { x, y } = /** @type {{x: number, y: number}} */ (places.get(state));
    const of = player.data.states[state];
    const kind = of.next === null ? "away" : of.rests ? "rests" : of.stuck ? "stuck" : "";
    const said =
      `State ${state}` +
      (of.rests
        ? ", where nothing happens any more"
        : of.stuck
          ? ", stuck"
          : of.next === null
            ? ", not followed further"
            : `, ${of.next.length} possible`);
    const circle = Dom.draw(
      "g",
      {
        class: `node ${kind}`,
        role: "button",
        tabindex: "-1",
        "aria-label": said,
        "data-testid": `state-${state}`,
        transform: `translate(${x} ${y})`,
        click: () => visit(state),
      },
      [
        Dom.draw("circle", { r: svg.node }),
        Dom.draw("text", { class: "node-text", dy: "3.2", text: String(state) }),
        Dom.draw("title", { text: said }),
      ],
    );
    nodes.set(state, circle);
    return circle;
  }

  /** Marks the edges of the run that is shown. */
  function way() {
    for (const line of lines.values()) line.classList.remove("way");
    let from = player.run.start;
    for (const step of player.run.steps) {
      const line = lines.get(`${from}-${step.to}`);
      if (line) line.classList.add("way");
      from = step.to;
    }
  }

  /** Marks the state that is shown. */
  function here() {
    for (const line of picture ? picture.querySelectorAll(".edge.out") : []) line.classList.remove("out");
    for (const choice of player.data.states[player.state].next || []) {
      const line = lines.get(`${player.state}-${choice.to}`);
      if (line) line.classList.add("out");
    }
    let state = player.state;
    for (let k = player.legs; k > 0 && player.run.steps[k - 1].tail; k--) {
      state = k > 1 ? player.run.steps[k - 2].to : player.run.start;
    }
    const now = nodes.get(state);
    for (const node of nodes.values()) {
      if (node === now || !node.classList.contains("here")) continue;
      node.classList.remove("here");
      node.setAttribute("tabindex", "-1");
      node.removeAttribute("aria-current");
    }
    if (!now || now.classList.contains("here")) return;
    now.classList.add("here");
    now.setAttribute("aria-current", "true");
    now.setAttribute("tabindex", "0");
    const view = picture && picture.parentElement;
    const place = places.get(state);
    if (!view || !place) return;
    const [x, y] = [place.x * scale, place.y * scale];
    if (x < view.scrollLeft + 20 || x > view.scrollLeft + view.clientWidth - 20)
      view.scrollLeft = x - view.clientWidth / 2;
    if (y < view.scrollTop + 20 || y > view.scrollTop + view.clientHeight - 20)
      view.scrollTop = y - view.clientHeight / 2;
  }

  /**
   * Goes to a state: where the run has it, or by the shortest way from its beginning.
   * @param {number} state
   */
  function visit(state) {
    player.pause();
    const at = player.run.start === state ? 0 : player.run.steps.findIndex((step) => step.to === state) + 1;
    if (player.run.start === state || at > 0) player.go(at);
    else {
      const all = player.data.states;
      /** @type {Map<number, {from: number, choice: number}>} */
      const found = new Map();
      const queue = [player.run.start];
      for (let i = 0; i < queue.length && !found.has(state); i++) {
        (all[queue[i]].next || []).forEach((choice, k) => {
          if (choice.to === null || choice.to === player.run.start || found.has(choice.to)) return;
          found.set(choice.to, { from: queue[i], choice: k });
          queue.push(choice.to);
        });
      }
      const choices = [];
      for (let to = state; found.has(to);) {
        const step = /** @type {{from: number, choice: number}} */ (found.get(to));
        choices.push(step.choice);
        to = step.from;
      }
      if (choices.length > 0) player.walk(player.run.index, 0, choices.reverse());
    }
    const node = nodes.get(state);
    if (node) /** @type {any} */ (node).focus({ preventScroll: true });
  }

  /**
   * The arrows go to the nearest state in their direction; Enter goes there in the run.
   * @param {KeyboardEvent} event
   */
  function walk(event) {
    const from = [...nodes].find(([, node]) => node === event.target);
    if (!from) return;
    if (event.key === "Enter" || event.key === " ") {
      visit(from[0]);
    } else {
      /** @type {{[key: string]: [number, number]}} */
      const ways = { ArrowDown: [0, 1], ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowLeft: [-1, 0] };
      const way = ways[event.key];
      if (!way) return;
      const a = /** @type {{x: number, y: number}} */ (places.get(from[0]));
      let best = -1;
      let least = Infinity;
      for (const [state, b] of places) {
        const along = (b.x - a.x) * way[0] + (b.y - a.y) * way[1];
        const across = Math.abs((b.x - a.x) * way[1]) + Math.abs((b.y - a.y) * way[0]);
        if (along > 1 && along + 2 * across < least) [best, least] = [state, along + 2 * across];
      }
      const node = nodes.get(best);
      if (node) /** @type {any} */ (node).focus();
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** The drawing as a file of its own. */
  function file() {
    if (!picture) return "";
    const copy = /** @type {SVGElement} */ (picture.cloneNode(true));
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    copy.prepend(
      Dom.draw("style", {
        text:
          ".edge{fill:none;stroke:#666;stroke-width:1.2}.way{stroke-width:2.6;stroke:#0a6}" +
          ".node circle{fill:#fff;stroke:#333}.here circle{fill:#fc6}" +
          ".node-text{font:9px sans-serif;text-anchor:middle}",
      }),
    );
    return new XMLSerializer().serializeToString(copy);
  }

  return { start, show };
})();
