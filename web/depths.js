"use strict";

/** A map of a large state graph by depth: a dot for each state, those of each number of steps in a band of their own. */
const Depths = (() => {
  /** Edges up to which all are drawn; of more, those of the run and of the present state. */
  const most = 30000;

  /**
   * @typedef {{ box: HTMLElement, here: (spot: number | undefined) => void, zoom: (factor: number) => void,
   *   fit: () => void, place: (spot: number) => { x: number, y: number } }} Map
   */

  /**
   * @param {PageData} data @param {Drawing} drawing @param {ReturnType<typeof Layers.place>} placed
   * @param {{ lit: { get: (state: number) => boolean | undefined } | null, way: () => Set<string>, visit: (states: number[]) => void }} of
   *   The edges of the run that is shown, by both ends.
   */
  function make(data, drawing, placed, { lit, way, visit }) {
    const canvas = Dom.make("canvas", { "aria-hidden": "true" });
    const hint = Dom.make("p", { class: "map-hint", hidden: true });
    const box = Dom.make("div", {
      class: "graph-map", tabindex: "0", role: "application", test: "graph-map",
      "aria-label": `Map of ${drawing.spots.length} states by depth. Arrows go from state to state, Enter goes there.`,
    }, [canvas, hint]);
    // Between neighbours in a row there is more room than between rows, where there is.
    const look = { scale: 10, stretch: 1, x: 0, y: 0 };
    /** @type {number | undefined} */
    let now;
    /** @type {number | undefined} */
    let pointed;
    let waiting = 0, fitted = false;
    /** Whether the user has moved the map: then it stays where it is. */
    let moved = false;
    const wide = placed.x.reduce((a, b) => Math.max(a, b), 0) + 1, high = placed.y.reduce((a, b) => Math.max(a, b), 0) + 1;
    /** @type {number[][]} */
    const beside = drawing.spots.map(() => []);
    drawing.edges.forEach(([a, b], i) => {
      beside[a].push(i);
      if (a !== b) beside[b].push(i);
    });

    function later() {
      if (waiting === 0) waiting = requestAnimationFrame(() => {
        waiting = 0;
        paint();
      });
    }

    const X = (/** @type {number} */ i) => (placed.x[i] + 0.5) * look.scale * look.stretch + look.x;
    const Y = (/** @type {number} */ i) => (placed.y[i] + 0.5) * look.scale + look.y;

    function paint() {
      const width = box.clientWidth, height = box.clientHeight, sharp = window.devicePixelRatio || 1;
      if (width === 0 || height === 0) return;
      if (!fitted) fit();
      canvas.width = Math.round(width * sharp);
      canvas.height = Math.round(height * sharp);
      const pen = canvas.getContext("2d");
      if (!pen) return;
      const style = getComputedStyle(document.documentElement);
      const colour = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
      pen.scale(sharp, sharp);
      pen.font = "10px system-ui, sans-serif";
      pen.fillStyle = colour("--quiet");
      placed.order.forEach((nodes, depth) => {
        if (nodes.length === 0) return;
        const y = nodes.reduce((least, i) => Math.min(least, Y(i)), Infinity);
        if (depth % (look.scale < 5 ? 10 : 5) === 0) pen.fillText(String(depth), 3, y + 3);
      });
      const stroke = (/** @type {(i: number) => boolean} */ wanted, /** @type {string} */ style, /** @type {number} */ line, /** @type {number} */ alpha) => {
        pen.strokeStyle = style;
        pen.lineWidth = line;
        pen.globalAlpha = alpha;
        pen.beginPath();
        drawing.edges.forEach(([a, b], i) => {
          if (!wanted(i)) return;
          pen.moveTo(X(a), Y(a));
          pen.lineTo(X(b), Y(b));
        });
        pen.stroke();
        pen.globalAlpha = 1;
      };
      if (drawing.edges.length <= most) stroke(() => true, colour("--quiet"), 0.6, 0.16);
      const run = way();
      stroke((i) => run.has(drawing.edges[i].join("-")), colour("--accent"), 2, 0.9);
      const around = pointed === undefined ? now : pointed;
      if (around !== undefined) {
        const own = new Set(beside[around]);
        stroke((i) => own.has(i), colour("--text"), 1.2, 0.9);
      }
      const r = Math.max(1.2, Math.min(8, look.scale * 0.34));
      const tints = { "": colour("--quiet"), chain: colour("--quiet"), away: colour("--line"), rests: colour("--text"), stuck: colour("--bad") };
      drawing.spots.forEach(({ states }, i) => {
        const x = X(i), y = Y(i);
        if (x < -r || y < -r || x > width + r || y > height + r) return;
        const found = lit !== null && states.some((state) => lit.get(state));
        pen.fillStyle = found ? colour("--k-bounce") : tints[/** @type {""} */ (Sketch.kind(data, states))];
        const size = found ? r * 1.35 : r;
        pen.beginPath();
        pen.arc(x, y, size, 0, 2 * Math.PI);
        pen.fill();
      });
      ring(pen, now, colour("--accent"), r + 3);
      ring(pen, pointed, colour("--text"), r + 2);
    }

    /** @param {CanvasRenderingContext2D} pen @param {number | undefined} spot @param {string} style @param {number} r */
    function ring(pen, spot, style, r) {
      if (spot === undefined) return;
      pen.strokeStyle = style;
      pen.lineWidth = 2.5;
      pen.beginPath();
      pen.arc(X(spot), Y(spot), r, 0, 2 * Math.PI);
      pen.stroke();
    }

    function fit() {
      const width = box.clientWidth - 24, height = box.clientHeight - 8;
      if (width <= 0 || height <= 0) return;
      fitted = true;
      moved = false;
      look.scale = Math.max(0.5, Math.min(30, width / wide, height / high));
      look.stretch = Math.max(1, Math.min(2.5, width / wide / look.scale));
      look.x = 20 + (width - wide * look.scale * look.stretch) / 2;
      look.y = 4 + (height - high * look.scale) / 2;
      later();
    }

    /** @param {number} factor @param {number} [x] @param {number} [y] */
    function zoom(factor, x = box.clientWidth / 2, y = box.clientHeight / 2) {
      const scale = Math.max(0.5, Math.min(60, look.scale * factor));
      moved = true;
      look.x = x - ((x - look.x) * scale) / look.scale;
      look.y = y - ((y - look.y) * scale) / look.scale;
      look.scale = scale;
      later();
    }

    /** @param {MouseEvent} event */
    function at(event) {
      const from = canvas.getBoundingClientRect();
      return { x: event.clientX - from.left, y: event.clientY - from.top };
    }

    /** @param {{ x: number, y: number }} p the node that is near, if any */
    function nearest({ x, y }) {
      let best, least = 14;
      drawing.spots.forEach((_, i) => {
        const far = Math.hypot(X(i) - x, Y(i) - y);
        if (far < least) [best, least] = [i, far];
      });
      return /** @type {number | undefined} */ (best);
    }

    /** @param {number | undefined} spot */
    function point(spot) {
      pointed = spot;
      hint.hidden = spot === undefined;
      if (spot !== undefined) Dom.tell(hint, `${Sketch.told(data, drawing.spots[spot].states)}, after ${placed.layer[spot]} steps`);
      later();
    }

    /** @type {{ x: number, y: number, moved: boolean } | null} */
    let held = null;
    box.addEventListener("pointerdown", (event) => {
      held = { ...at(event), moved: false };
      box.setPointerCapture(event.pointerId);
    });
    box.addEventListener("pointermove", (event) => {
      const p = at(event);
      if (!held) return point(nearest(p));
      if (!held.moved && Math.hypot(p.x - held.x, p.y - held.y) < 4) return;
      look.x += p.x - held.x;
      look.y += p.y - held.y;
      held = { ...p, moved: true };
      moved = true;
      later();
    });
    box.addEventListener("pointerup", (event) => {
      const spot = held && !held.moved ? nearest(at(event)) : undefined;
      held = null;
      if (spot !== undefined) visit(drawing.spots[spot].states);
    });
    box.addEventListener("pointerleave", () => point(undefined));
    box.addEventListener("wheel", (event) => {
      event.preventDefault();
      const p = at(event);
      zoom(Math.exp(-event.deltaY / 400), p.x, p.y);
    }, { passive: false });
    box.addEventListener("keydown", (event) => {
      /** @type {{[key: string]: [number, number]}} */
      const ways = { ArrowDown: [0, 1], ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowLeft: [-1, 0] };
      const way = ways[event.key], from = pointed === undefined ? now : pointed;
      if (way) {
        let best, least = Infinity;
        drawing.spots.forEach((_, i) => {
          const dx = from === undefined ? placed.x[i] : placed.x[i] - placed.x[from];
          const dy = from === undefined ? placed.y[i] : placed.y[i] - placed.y[from];
          const along = dx * way[0] + dy * way[1], across = Math.abs(dx * way[1]) + Math.abs(dy * way[0]);
          if (along > 0.01 && along + 2 * across < least) [best, least] = [i, along + 2 * across];
        });
        if (best !== undefined) point(best);
      } else if (event.key === "Enter" && from !== undefined) visit(drawing.spots[from].states);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    new ResizeObserver(() => {
      fitted = fitted && moved;
      later();
    }).observe(box);
    return {
      box, zoom, fit,
      here: (/** @type {number | undefined} */ spot) => {
        now = spot;
        later();
      },
      place: (/** @type {number} */ spot) => ({ x: X(spot), y: Y(spot) }),
    };
  }

  return { make };
})();
