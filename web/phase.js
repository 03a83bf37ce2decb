"use strict";

/** One number against another along the run, within the part of time that is seen. */
const Phase = (() => {
  const height = 220, edge = { left: 64, right: 14, top: 8, bottom: 34 };

  /**
   * @param {Player} player @param {number[]} plots two of them: across and up @param {number} wide
   * @returns {{ figure: HTMLElement, move: () => void }} which shows where one is
   */
  function make(player, [across, up], wide) {
    const width = Math.min(wide, 460);
    const { from, to } = Timeline.range, points = trace(player, [across, up], from, to);
    const [xs, ys] = [0, 1].map((k) => room(points.flat().map((point) => point[k])));
    const x = (/** @type {number} */ value) => edge.left + ((value - xs.low) / (xs.high - xs.low)) * (width - edge.left - edge.right);
    const y = (/** @type {number} */ value) => height - edge.bottom - ((value - ys.low) / (ys.high - ys.low)) * (height - edge.top - edge.bottom);
    const texts = [across, up].map((plot) => Dom.clip(Formulas.text(plot), 60));
    const picture = Dom.draw("svg", {
      class: "chart phase", width, height, viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `${texts[1]} against ${texts[0]}`,
    });
    const word = (/** @type {string} */ text, /** @type {any} */ at) => Dom.draw("text", { ...at, text, class: "plot-tick", "font-size": 10, "font-family": "sans-serif", fill: "#777" });
    for (const [value, text] of Timeline.labels(Timeline.steps(xs.low, xs.high, 5), 4))
      picture.append(Dom.draw("line", { class: "plot-grid", x1: x(value), x2: x(value), y1: edge.top, y2: height - edge.bottom, stroke: "#8884" }),
        word(text, { x: x(value), y: height - edge.bottom + 13, "text-anchor": "middle" }));
    for (const [value, text] of Timeline.labels(Timeline.steps(ys.low, ys.high, 5), 4))
      picture.append(Dom.draw("line", { class: "plot-grid", x1: edge.left, x2: width - edge.right, y1: y(value), y2: y(value), stroke: "#8884" }),
        word(text, { x: edge.left - 5, y: y(value) + 3, "text-anchor": "end" }));
    picture.append(word(texts[0], { x: (edge.left + width - edge.right) / 2, y: height - 6, "text-anchor": "middle" }),
      word(texts[1], { transform: `translate(12 ${(height - edge.bottom) / 2}) rotate(-90)`, "text-anchor": "middle" }));
    const path = points.filter((stroke) => stroke.length > 1)
      .map((stroke) => "M" + stroke.map(([a, b]) => `${x(a).toFixed(2)} ${y(b).toFixed(2)}`).join("L")).join("");
    if (path !== "") picture.append(Dom.draw("path", { class: "plot-line", d: path, fill: "none", stroke: "#2a7de1", "stroke-width": 1.6, "stroke-linejoin": "round" }));
    const dot = Dom.draw("circle", { class: "plot-dot", r: 4 });
    picture.append(dot);
    const move = () => {
      const [a, b] = [across, up].map((plot) => Values.exact(player, player.legs, plot, player.time));
      const there = typeof a !== "string" && typeof b !== "string";
      dot.setAttribute("visibility", there ? "visible" : "hidden");
      if (there) dot.setAttribute("transform", `translate(${x(Rational.toNumber(a)).toFixed(2)} ${y(Rational.toNumber(b)).toFixed(2)})`);
    };
    return { figure: Dom.make("figure", { class: "plot", test: "phase" }, [/** @type {any} */ (picture)]), move };
  }

  /**
   * Pairs of values, of strokes that hang together: exact at the ends of legs and at instants between.
   * @param {Player} player @param {number[]} plots @param {number} from @param {number} to
   */
  function trace(player, plots, from, to) {
    const { instants, course } = player, legs = course.legs.length;
    /** @type {[number, number][][]} */
    const strokes = [[]];
    const seen = [...Array(legs + 1).keys()].filter((k) => instants[k + 1] >= from && instants[k] <= to);
    // What is about all of many bodies takes longer.
    const slow = course.leaves.length > 200 && plots.some((plot) => plot >= player.data.plots.length && Formulas.wide(plot - player.data.plots.length));
    const every = Math.max(1, Math.ceil(seen.length / (slow ? 100 : 2000)));
    for (let i = 0; i < seen.length; i += every) {
      const k = seen[i], start = player.instant(k), span = Rational.sub(player.until(k), start);
      const parts = every > 1 || Rational.sign(span) === 0 ? 1 : Math.max(1, Math.min(64, Math.ceil(600 / seen.length)));
      for (let part = 0; part <= (every > 1 ? 0 : parts); part++) {
        const time = Rational.add(start, Rational.mul(span, Rational.make(BigInt(part), BigInt(parts))));
        const [a, b] = plots.map((plot) => Values.exact(player, k, plot, time));
        const now = Rational.toNumber(time);
        if (typeof a === "string" || typeof b === "string") strokes.push([]);
        else if (now >= from && now <= to) strokes[strokes.length - 1].push([Rational.toNumber(a), Rational.toNumber(b)]);
      }
    }
    return strokes;
  }

  /** @param {number[]} values some room around them */
  function room(values) {
    const low = values.reduce((a, b) => Math.min(a, b), Infinity), high = values.reduce((a, b) => Math.max(a, b), -Infinity);
    if (!(low <= high)) return { low: 0, high: 1 };
    const free = high - low < 1e-12 * Math.max(1, Math.abs(high)) ? Math.max(1, 1e-6 * Math.abs(high)) : (high - low) * 0.06;
    return { low: low - free, high: high + free };
  }

  return { make };
})();
