"use strict";

/**
 * The state graph: what is near the present state, or all of it. It is laid out in layers by the number of steps, beside
 * the page where it is large; few states are drawn to be read, and many as a map.
 */
const Graph = (() => {
  /** Nodes up to which each is drawn with its number. */
  const readable = 400;
  /** States up to which all of them are drawn at first. */
  const few = 60;
  /** @type {Player} */
  let player;
  /** @type {HTMLElement} */
  let box;
  /** @type {HTMLElement} */
  let view;
  /** @type {HTMLElement} */
  let note;
  /** What the user has chosen; null: by the size of the graph. */
  const wish = {
    /** @type {"near" | "all" | null} */ show: null,
    steps: 3,
    /** @type {boolean | null} */ fold: null,
    labels: false,
  };
  /** @type {{ looked: number, states: number[] } | null} */
  let known = null;
  /** @type {Drawing | null} */
  let drawing = null;
  /** @type {Map<number, number>} the node of each state */
  let spotOf = new Map();
  /** @type {ReturnType<typeof Sketch.make> | null} */
  let sketch = null;
  /** @type {ReturnType<typeof Depths.make> | null} */
  let map = null;
  /**
   * The states that were searched, and whether they were found.
   * @type {Map<number, boolean> | null}
   */
  let lit = null;
  let drawn = false;
  /** The state around which it is drawn. */
  let centre = -1;
  let scale = 1;
  let fitted = false;

  /** @param {Player} of */
  function start(of) {
    player = of;
    box = Dom.get("graph");
    player.on("run", () => {
      known = null;
      again();
    });
    player.on("move", () => drawn && here());
    player.on("grow", () => {
      known = null;
      again();
    });
  }

  /** More is known, or another part of it is to be drawn: at once where one sees it. */
  function again() {
    if (!drawn) return;
    drawn = false;
    if (!Dom.get("graph-panel").hidden) show();
  }

  /** Draws it, if that was not done yet. */
  function show() {
    if (!note) tools();
    if (!drawn) draw();
    drawn = true;
  }

  const all = () => known || (known = Portion.all(player));
  /** Whether what is near alone is drawn. */
  const partly = () => (wish.show || (all().states.length > few ? "near" : "all")) === "near";

  /** Why `scc check` may have another number. */
  const counted = () => (player.data.runs.some(({ check }) => check && /\bevent\b/.test(check.formula))
    ? " As checks ask about events, scc check counts a state once for each such event that has just led there." : "");

  /** What is said of how much is known. */
  function told() {
    const { data } = player, { graph } = data;
    if (graph && graph.complete) return `All ${graph.states} states that there are.${counted()}`;
    if (Live.on) return `${all().looked} states were looked at so far; the graph grows as you go on.`;
    if (!graph) return `The file holds the ${data.states.length} states of its runs.`;
    return `${graph.states} states, of ${graph.expanded} of which all that can happen is known: ` +
      `the graph was followed up to the bound of ${graph.bound} states.`;
  }

  /** @type {{ [name: string]: HTMLElement }} */
  const made = {};

  function tools() {
    note = Dom.make("p", { class: "quiet", test: "graph-note" });
    made.show = Dom.make("select", {
      "aria-label": "Which states", test: "graph-show",
      change: () => {
        wish.show = /** @type {any} */ (made.show).value;
        other();
      },
    }, [Dom.make("option", { value: "near", text: "Near here" }), Dom.make("option", { value: "all", text: "All" })]);
    made.steps = Dom.make("input", {
      type: "number", min: 1, max: 99, value: wish.steps, "aria-label": "Steps before and after", title: "Steps before and after",
      test: "graph-steps",
      change: () => {
        const wanted = Math.round(Number(/** @type {any} */ (made.steps).value));
        wish.steps = Math.max(1, Math.min(99, wanted || wish.steps));
        other();
      },
    });
    const toggle = (/** @type {string} */ name, /** @type {string} */ text, /** @type {string} */ title, /** @type {() => void} */ flip) => {
      made[name] = Dom.button(text, () => {
        flip();
        other();
      }, { title, test: `graph-${name}`, "aria-pressed": "false" });
      return made[name];
    };
    made.search = Dom.make("input", {
      type: "search", placeholder: "States where …, such as bonds() > 0", "aria-label": "States where a formula holds", spellcheck: "false",
      autocomplete: "off", maxlength: 10000, test: "graph-search",
      keydown: (/** @type {KeyboardEvent} */ event) => {
        if (event.key === "Enter") search();
      },
      input: () => {
        if (/** @type {any} */ (made.search).value === "") search();
      },
    });
    made.next = Dom.button("Next", () => toFound(), { title: "To the next state that is found", test: "graph-next", hidden: true });
    made.found = Dom.make("p", { class: "quiet", role: "status", test: "graph-found" });
    view = Dom.make("div", { class: "graph-view", keydown: walk });
    made.legend = Dom.make("ul", {});
    Dom.fill(
      box,
      Dom.make("div", { class: "graph-tools" }, [
        made.show, made.steps,
        toggle("fold", "Fold", "Draw states in a row as one", () => { wish.fold = !folding(); }),
        toggle("labels", "Labels", "What happens along the edges", () => { wish.labels = !wish.labels; }),
        Dom.button("−", () => zoom(1 / 1.25), { "aria-label": "Smaller" }),
        Dom.button("+", () => zoom(1.25), { "aria-label": "Larger" }),
        Dom.button("Fit", fit, {}),
        Dom.button("SVG", () => Dom.save("graph.svg", "image/svg+xml", file()), { title: "Save the drawing", test: "graph-svg" }),
      ]),
      Dom.make("div", { class: "graph-tools" }, [made.search, made.next]),
      Dom.make("div", { class: "graph-tools" }, [made.found]),
      Dom.make("div", { class: "graph-tools" }, [note]),
      Dom.make("details", { class: "graph-legend" }, [Dom.make("summary", { text: "Legend", test: "graph-legend" }), made.legend]),
      view,
    );
  }

  let searched = 0;

  /** Looks for the states in which a formula holds, some at a time, so that the page goes on meanwhile. */
  async function search() {
    const text = /** @type {any} */ (made.search).value.trim(), number = ++searched, { data, course, run } = player;
    const say = (/** @type {string} */ what, /** @type {boolean} */ wrong) => {
      made.found.classList.toggle("wrong", wrong);
      Dom.tell(made.found, what);
    };
    lit = null;
    made.next.hidden = true;
    say("", false);
    document.dispatchEvent(new CustomEvent("graph"));
    try {
      if (text !== "") {
        const formula = Meaning.compile(data, course.leaves, { ...data.parameters, ...run.values }, text);
        if (formula.type !== "truth") throw new Reader.Wrong("this is a number: compare it, as in … > 0", [0, text.length]);
        /** @type {Map<number, boolean>} */
        const found = new Map();
        let [count, open, why] = [0, 0, ""];
        for (const [i, state] of all().states.entries()) {
          if (i % 200 === 199) await new Promise((done) => setTimeout(done));
          if (number !== searched) return;
          const value = formula.run(Meaning.reached(data, state));
          if (value instanceof Nothing) [open, why] = [open + 1, value.why];
          else {
            found.set(state, value === true);
            if (value === true) count++;
          }
        }
        lit = found;
        made.next.hidden = count === 0;
        say(`It holds in ${count} of ${all().states.length} states.` + (open > 0 ? ` Of ${open} it is not known: ${why}.` : ""), false);
      }
    } catch (error) {
      if (!(error instanceof Reader.Wrong)) throw error;
      const [from, to] = error.at;
      say(error.whole ? "This is about whole runs. A formula about a state is expected." : `${Dom.clip(error.message, 200)}${to > from ? `: “${Dom.clip(text.slice(from, to), 60)}”` : ""}`, true);
    }
    again();
  }

  /** Goes to the next state that was found, by their numbers. */
  function toFound() {
    const found = [...(lit || [])].filter(([, is]) => is).map(([state]) => state).sort((a, b) => a - b);
    const state = found.find((one) => one > now()) ?? found[0];
    if (state !== undefined) visit([state]);
  }

  /** Other choices of the user. */
  function other() {
    drawn = fitted = false;
    document.dispatchEvent(new CustomEvent("graph"));
    show();
  }

  const folding = () => (wish.fold === null ? all().states.length > few : wish.fold);

  function draw() {
    const { states } = player.data, { looked, states: every } = all();
    made.show.toggleAttribute("data-near", partly());
    /** @type {any} */ (made.show).value = partly() ? "near" : "all";
    /** @type {any} */ (made.steps).value = wish.steps;
    made.steps.hidden = !partly();
    made.fold.setAttribute("aria-pressed", String(folding()));
    made.labels.setAttribute("aria-pressed", String(wish.labels));
    if (looked === 0) {
      drawing = sketch = map = null;
      Dom.tell(note, told());
      Dom.fill(view, Dom.make("p", { class: "empty", text: "The file holds no states of which all that can happen is known." }));
      return;
    }
    centre = now();
    const far = partly() ? Portion.near(states, every, centre, wish.steps, readable) : null;
    const starts = player.runs.map((run) => run.start);
    const kept = new Set(far ? [...starts, centre] : starts);
    drawing = Portion.drawing(states, far ? [...far.keys()] : every, far, folding(), kept);
    spotOf = new Map(drawing.spots.flatMap(({ states }, i) => states.map((state) => [state, i])));
    const count = drawing.spots.length, large = count > readable;
    Dom.tell(note, told() + (far ? ` ${far.size} of them are within ${wish.steps} steps of here.` : "") +
      (large ? " A map by depth: point at a dot." : ""));
    const roots = starts.flatMap((state) => spotOf.get(state) ?? []);
    const wanted = {
      count, edges: drawing.edges, roots, ...(drawing.layers ? { given: drawing.layers } : {}),
      ...(large ? { aspect: Math.max(0.2, view.clientWidth / Math.max(1, view.clientHeight)) } : {}),
    };
    const of = drawing;
    let done = false;
    Aside.place(wanted, (placed) => {
      done = true;
      if (of === drawing) paint(of, placed, large);
    });
    if (!done) Dom.fill(view, Dom.make("p", { class: "empty", text: `${count} states are laid out …`, test: "graph-waiting" }));
  }

  /** @param {Drawing} of @param {ReturnType<typeof Layers.place>} placed @param {boolean} large */
  function paint(of, placed, large) {
    const { data } = player;
    const focused = view.contains(document.activeElement) && document.activeElement;
    const label = focused && focused.getAttribute("data-testid");
    sketch = map = null;
    if (large) {
      map = Depths.make(data, of, placed, { lit, way, visit });
      Dom.fill(view, map.box);
    } else {
      sketch = Sketch.make({ data, drawing: of, placed, labels: wish.labels, lit, visit });
      Dom.fill(view, /** @type {any} */ (sketch.picture));
      if (!fitted) fit();
      else zoom(1);
      fitted = true;
    }
    view.classList.toggle("map", large);
    Dom.fill(made.legend, ...Sketch.legend(data, of, lit !== null));
    mark();
    const same = label && view.querySelector(`[data-testid="${label}"]`);
    const focus = same || (label && sketch && sketch.nodes[spotOf.get(centre) ?? -1]);
    if (focus) /** @type {any} */ (focus).focus({ preventScroll: true });
  }

  /** @param {number} factor */
  function zoom(factor) {
    if (map) return map.zoom(factor);
    if (!sketch) return;
    scale = Math.max(0.15, Math.min(3, scale * factor));
    const [width, height] = size(sketch.picture);
    sketch.picture.setAttribute("width", String(Math.round(width * scale)));
    sketch.picture.setAttribute("height", String(Math.round(height * scale)));
  }

  /** @param {SVGElement} picture @returns {[number, number]} */
  function size(picture) {
    const [, , width, height] = (picture.getAttribute("viewBox") || "0 0 1 1").split(" ").map(Number);
    return [width, height];
  }

  function fit() {
    if (map) return map.fit();
    if (!sketch) return;
    const [width, height] = size(sketch.picture);
    // Words stay large enough to be read.
    scale = Math.min(1.6, Math.max(wish.labels ? 1 : 0.5, Math.min((view.clientWidth - 4) / width, (view.clientHeight - 4) / height)));
    zoom(1);
  }

  /** The edges of the run that is shown, by their ends. */
  function way() {
    const found = new Set();
    let from = player.run.start;
    for (const step of player.run.steps) {
      found.add(`${spotOf.get(from)}-${spotOf.get(step.to)}`);
      from = step.to;
    }
    return found;
  }

  /** The state that is shown: after the end of a run, the one in which it ends. */
  function now() {
    let k = player.legs;
    while (k > 0 && player.run.steps[k - 1].tail) k--;
    return k > 0 ? player.run.steps[k - 1].to : player.run.start;
  }

  /** Another state is shown. */
  function here() {
    if (Dom.get("graph-panel").hidden) {
      // It is drawn anew when it is seen again.
      if (partly() && now() !== centre) drawn = false;
    } else if (partly() && now() !== centre) again();
    else mark();
  }

  /** Marks the state that is shown, what leads out of it, and the run. */
  function mark() {
    const state = now(), spot = spotOf.get(state);
    if (map) return map.here(spot);
    if (!sketch) return;
    const run = way();
    for (const [ends, line] of sketch.lines) {
      line.classList.toggle("way", run.has(ends));
      line.classList.remove("out");
    }
    for (const choice of player.data.states[state].next || []) {
      const line = choice.to === null ? undefined : sketch.lines.get(`${spot}-${spotOf.get(choice.to)}`);
      if (line) line.classList.add("out");
    }
    sketch.nodes.forEach((node, i) => {
      const is = i === spot;
      if (node.classList.contains("here") === is) return;
      node.classList.toggle("here", is);
      node.setAttribute("tabindex", is ? "0" : "-1");
      if (is) node.setAttribute("aria-current", "true");
      else node.removeAttribute("aria-current");
    });
    const place = spot === undefined ? undefined : sketch.places[spot];
    if (!place) return;
    const [x, y] = [place.x * scale, place.y * scale];
    if (x < view.scrollLeft + 20 || x > view.scrollLeft + view.clientWidth - 20)
      view.scrollLeft = x - view.clientWidth / 2;
    if (y < view.scrollTop + 20 || y > view.scrollTop + view.clientHeight - 20)
      view.scrollTop = y - view.clientHeight / 2;
  }

  /**
   * Goes to a state: of several in a row, to the one after that which is shown, or to the first.
   * @param {number[]} states
   */
  function visit(states) {
    const state = states[(states.indexOf(now()) + 1) % states.length];
    player.pause();
    const at = player.run.steps.findIndex((step) => step.to === state) + 1;
    if (player.run.start === state) player.go(0);
    else if (at > 0) player.go(at);
    else {
      const choices = shortest(player.run.start, state);
      if (choices.length > 0) player.walk(player.run.index, 0, choices);
    }
    const node = sketch && sketch.nodes[spotOf.get(state) ?? -1];
    if (node) /** @type {any} */ (node).focus({ preventScroll: true });
  }

  /**
   * The choices of a shortest way.
   * @param {number} from @param {number} to
   */
  function shortest(from, to) {
    const { states } = player.data;
    /** @type {Map<number, { from: number, choice: number }>} */
    const found = new Map();
    const queue = [from];
    for (let i = 0; i < queue.length && !found.has(to); i++) {
      (states[queue[i]].next || []).forEach((choice, k) => {
        if (choice.to === null || choice.to === from || found.has(choice.to)) return;
        found.set(choice.to, { from: queue[i], choice: k });
        queue.push(choice.to);
      });
    }
    const choices = [];
    for (let step = found.get(to); step; step = found.get(step.from)) choices.push(step.choice);
    return choices.reverse();
  }

  /**
   * The arrows go to the nearest node in their direction; Enter goes there in the run.
   * @param {KeyboardEvent} event
   */
  function walk(event) {
    const { nodes, places } = sketch || { nodes: [], places: [] };
    const from = nodes.findIndex((node) => node === event.target);
    if (from < 0 || !drawing) return;
    if (event.key === "Enter" || event.key === " ") visit(drawing.spots[from].states);
    else {
      /** @type {{[key: string]: [number, number]}} */
      const ways = { ArrowDown: [0, 1], ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowLeft: [-1, 0] };
      const way = ways[event.key];
      if (!way) return;
      const a = places[from];
      let best = -1, least = Infinity;
      places.forEach((b, i) => {
        const along = (b.x - a.x) * way[0] + (b.y - a.y) * way[1];
        const across = Math.abs((b.x - a.x) * way[1]) + Math.abs((b.y - a.y) * way[0]);
        if (along > 1 && along + 2 * across < least) [best, least] = [i, along + 2 * across];
      });
      if (best >= 0) /** @type {any} */ (nodes[best]).focus();
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** The drawing as a file of its own: of a map, of what is near. */
  function file() {
    if (!sketch) return "";
    const copy = /** @type {SVGElement} */ (sketch.picture.cloneNode(true));
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    copy.prepend(
      Dom.draw("style", {
        text:
          ".edge{fill:none;stroke:#666;stroke-width:1.2}.way{stroke-width:2.6;stroke:#0a6}" +
          ".node circle,.node rect{fill:#fff;stroke:#333}.here circle,.here rect{fill:#fc6}.lit circle,.lit rect{stroke-width:4}" +
          ".node-text{font:9px sans-serif;text-anchor:middle}.edge-text{font:8px sans-serif;text-anchor:middle}",
      }),
    );
    return new XMLSerializer().serializeToString(copy);
  }

  /** What the user has chosen, as words of an address. */
  function save() {
    if (!note) return "";
    return [
      Dom.get("graph-panel").hidden ? "" : "open", wish.show || "", wish.steps === 3 ? "" : String(wish.steps),
      wish.fold === null ? "" : wish.fold ? "fold" : "whole", wish.labels ? "labels" : "",
    ].filter(Boolean).join(".");
  }

  /** The formula of the search. */
  const sought = () => (note ? /** @type {any} */ (made.search).value.trim() : "");

  /**
   * Chooses what an address says.
   * @param {string} words @param {string} sought @returns {boolean} whether all of it is known
   */
  function load(words, sought) {
    const wanted = words === "" ? [] : words.split(".");
    const known = wanted.every((word) => /^(open|near|all|fold|whole|labels|[1-9][0-9]?)$/.test(word));
    for (const word of wanted) {
      if (word === "near" || word === "all") wish.show = word;
      else if (word === "fold" || word === "whole") wish.fold = word === "fold";
      else if (word === "labels") wish.labels = true;
      else if (/^[1-9][0-9]?$/.test(word)) wish.steps = Number(word);
    }
    if (!note) tools();
    /** @type {any} */ (made.search).value = sought;
    drawn = fitted = false;
    if (sought !== "") search();
    if (wanted.includes("open") && Dom.get("graph-panel").hidden) Dom.get("graph-switch").click();
    else if (!Dom.get("graph-panel").hidden) show();
    return known;
  }

  return { start, show, save, load, sought };
})();
