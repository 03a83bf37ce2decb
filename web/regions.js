"use strict";

/**
 * For which values of the parameters checks hold: the plane of two of them, or the line of one, in which one points at a
 * start to see the run from there.
 */
const Regions = (() => {
  const width = 248, left = 58, top = 8, bottom = 36;
  const words = /** @type {{ [outcome: string]: string }} */ (
    { holds: "holds", fails: "fails", varies: "depends on what is not shown", unknown: "not known" });

  /** @type {Player} */
  let player;
  /** @type {DataWhere} */
  let where;
  let check = 0;
  /** @type {SVGElement[]} */
  let dots = [];
  /** @type {HTMLElement} */
  let told;

  /** @param {Player} of */
  function start(of) {
    player = of;
    if (!player.data.where) {
      Dom.get("where").remove();
      return;
    }
    where = player.data.where;
    player.on("run", mark);
    show();
  }

  const line = () => where.axes.length === 1;
  const height = () => (line() ? 60 : width);

  /** @param {number} axis @param {string} text in pixels, from the left or from above */
  function place(axis, text) {
    const { low, high } = where.axes[axis] || { low: { value: "0/1" }, high: { value: "1/1" } };
    const a = Rational.of(low.value), b = Rational.of(high.value);
    const part = Rational.toNumber(Rational.div(Rational.sub(Rational.of(text), a), Rational.sub(b, a)));
    return axis === 0 ? left + part * width : top + (1 - part) * height();
  }

  /** @param {[string, string]} p */
  const point = (p) => `${place(0, p[0]).toFixed(2)} ${place(1, p[1]).toFixed(2)}`;

  function show() {
    const size = { w: left + width + 10, h: top + height() + bottom };
    const shapes = [...where.regions.flatMap(region), ...axes(), ...samples()];
    const picture = Dom.draw("svg", {
      viewBox: `0 0 ${size.w} ${size.h}`, class: "where", role: "application", tabindex: "0", test: "where",
      "aria-label": "Where the check holds. Arrows go from start to start.",
      click: pointAt, keydown: key, pointermove: hover,
      pointerleave: () => {
        for (const dot of dots) dot.classList.remove("near");
        tell();
      },
    }, shapes);
    told = Dom.make("p", { class: "quiet", role: "status", test: "where-told" });
    Dom.fill(Dom.get("where"), chooser(), picture, legend(), told);
    mark();
  }

  function chooser() {
    return Dom.make("select", {
      "aria-label": "Check", test: "where-check",
      change: (/** @type {Event} */ e) => { check = Number(/** @type {HTMLSelectElement} */ (e.target).value); show(); },
    }, where.checks.map((name, i) => Dom.make("option", { value: i, selected: i === check, text: Dom.clip(name, 80) })));
  }

  function legend() {
    const seen = new Set(where.regions.map((r) => r.outcomes[check]));
    return Dom.make("ul", { class: "where-legend" }, [...seen].map((outcome) =>
      Dom.make("li", { class: `where-${outcome}` }, [words[outcome], share(outcome)])));
  }

  /** @param {string} outcome */
  function share(outcome) {
    let sum = Rational.zero;
    for (const r of where.regions) if (r.outcomes[check] === outcome) sum = Rational.add(sum, Rational.of(r.share));
    return ` in ${Rational.text(sum)} of the ranges`;
  }

  /** @param {DataRegion} r */
  function region(r) {
    const kind = `where-${r.outcomes[check]}`;
    return [
      ...r.polygons.map((p) => Dom.draw("path", { class: `${kind} area`, d: `M${p.map(point).join("L")}Z` })),
      ...r.lines.map(([a, b]) => Dom.draw("path", { class: `${kind} thin`, d: `M${point(a)}L${point(b)}` })),
      ...r.points.map((p) => Dom.draw("circle", { class: `${kind} thin`, cx: place(0, p[0]), cy: place(1, p[1]), r: 4 })),
    ];
  }

  /**
   * Round numbers of an axis, none of them twice, with what is written there.
   * @param {number} axis
   */
  function marks(axis) {
    const { low, high } = where.axes[axis];
    const [from, to] = [low, high].map((bound) => Rational.toNumber(Rational.of(bound.value)));
    const all = Timeline.labels(Timeline.steps(from, to, 6));
    // Numbers so long that they would cover each other: the ends alone.
    if (all.length > 1 && all.every(([, text]) => text.length <= 7))
      return all.map(([value, text]) => ({ part: (value - from) / (to - from), text }));
    return [[low, 0], [high, 1]].map(([bound, part]) => ({
      part: Number(part), text: Dom.clip(Exactly.text(Rational.of(/** @type {DataBound} */ (bound).value)), 12),
    }));
  }

  function axes() {
    const word = (/** @type {string} */ text, /** @type {any} */ at) => Dom.draw("text", { ...at, class: "axis", text });
    const tick = (/** @type {number} */ x, /** @type {number} */ y, /** @type {string} */ way) =>
      Dom.draw("path", { class: "tick", d: `M${x.toFixed(1)} ${y.toFixed(1)}${way}` });
    const base = top + height(), [x, y] = where.axes;
    /** @param {number} part */
    const side = (part) => (part < 0.05 ? "start" : part > 0.95 ? "end" : "middle");
    return [
      Dom.draw("path", { class: "tick", d: `M${left} ${top}V${base}H${left + width}` }),
      ...marks(0).flatMap(({ part, text }) => [
        tick(left + part * width, base, "v4"), word(text, { x: left + part * width, y: base + 15, "text-anchor": side(part) })]),
      word(Dom.clip(x.name, 24), { x: left + width / 2, y: base + 30, "text-anchor": "middle" }),
      ...(y ? [
        ...marks(1).flatMap(({ part, text }) => [
          tick(left, base - part * height(), "h-4"), word(text, { x: left - 6, y: base - part * height() + 4, "text-anchor": "end" })]),
        word(Dom.clip(y.name, 24), { "text-anchor": "middle", transform: `translate(11 ${top + height() / 2}) rotate(-90)` }),
      ] : []),
    ];
  }

  /** @param {DataSample} s */
  function at(s) {
    const [x, y] = where.axes.map((axis) => s.at[axis.name]);
    return { x: place(0, x), y: y === undefined ? top + height() / 2 : place(1, y) };
  }

  function samples() {
    dots = where.samples.map((s) => {
      const p = at(s);
      return Dom.draw("circle", { class: "sample", cx: p.x, cy: p.y, r: 2.2, "data-run": s.run });
    });
    return dots;
  }

  /**
   * The start that is nearest to the pointer.
   * @param {MouseEvent} event
   */
  function nearest(event) {
    const svg = /** @type {SVGSVGElement} */ (event.currentTarget);
    const box = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / box.width;
    const x = (event.clientX - box.left) * scale, y = (event.clientY - box.top) * scale;
    let best = -1, near = Infinity;
    where.samples.forEach((s, i) => {
      const p = at(s), d = Math.hypot(p.x - x, line() ? 0 : p.y - y);
      if (d < near) { near = d; best = i; }
    });
    return { best, near, x, y };
  }

  /** @param {MouseEvent} event */
  const pointAt = (event) => open(nearest(event).best);

  /**
   * Says which start is under the pointer, and what is so there.
   * @param {MouseEvent} event
   */
  function hover(event) {
    const { best, near } = nearest(event), sample = where.samples[best];
    dots.forEach((dot, i) => dot.classList.toggle("near", i === best && near < 14));
    if (!sample || near >= 14) return tell();
    const here = outcome(sample);
    Dom.tell(told, `${values(sample)}${here ? `: ${words[here]}` : ""}. Click to see the run from there.`);
  }

  /** @param {DataSample} s */
  const values = (s) => Object.keys(s.at).map((name) => `${Dom.clip(name, 40)} = ${Exactly.text(Rational.of(s.at[name]))}`).join(", ");

  /**
   * What is so at a start: of the region that has it inside. At borders, which belong to one side, nothing is said.
   * @param {DataSample} s
   */
  function outcome(s) {
    const [x, y] = where.axes.map((axis) => Rational.of(s.at[axis.name]));
    const p = [x, y || Rational.make(1n, 2n)];
    const inside = (/** @type {[string, string][]} */ polygon) => polygon.every(([ax, ay], i) => {
      const [bx, by] = polygon[(i + 1) % polygon.length].map(Rational.of), a = [Rational.of(ax), Rational.of(ay)];
      const side = Rational.sub(
        Rational.mul(Rational.sub(bx, a[0]), Rational.sub(p[1], a[1])), Rational.mul(Rational.sub(by, a[1]), Rational.sub(p[0], a[0])));
      return Rational.sign(side) > 0;
    });
    const found = where.regions.find((r) => r.polygons.some(inside));
    return found ? found.outcomes[check] : null;
  }

  /** @param {number} index of a sample */
  function open(index) {
    const sample = where.samples[index];
    const run = sample && player.runs.find((r) => r.way === null && r.index === sample.run);
    if (run) player.open(run);
  }

  /**
   * To the nearest start in a direction.
   * @param {KeyboardEvent} event
   */
  function key(event) {
    const way = /** @type {{ [key: string]: number[] }} */ (
      { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] })[event.key];
    if (!way) return;
    event.preventDefault();
    event.stopPropagation();
    const now = present(), from = now < 0 ? { x: left + width / 2, y: top + height() / 2 } : at(where.samples[now]);
    let best = -1, least = Infinity;
    where.samples.forEach((s, i) => {
      const p = at(s), along = (p.x - from.x) * way[0] + (p.y - from.y) * way[1];
      const aside = Math.abs((p.x - from.x) * way[1]) + Math.abs((p.y - from.y) * way[0]);
      if (i !== now && along > 0.01 && along + 3 * aside < least) { least = along + 3 * aside; best = i; }
    });
    open(best);
  }

  /** The sample whose run is shown. */
  const present = () => where.samples.findIndex((s) => s.run === player.run.index && player.run.way === null);

  function mark() {
    const now = present();
    dots.forEach((dot, i) => {
      dot.setAttribute("class", i === now ? "sample here" : "sample");
      dot.setAttribute("r", i === now ? "5" : "2.2");
    });
    tell();
  }

  /** Says which run is shown. */
  function tell() {
    const s = where.samples[present()];
    Dom.tell(told, s ? `The run from ${values(s)}` : "Point at a start, one of the dots, to see the run from there.");
  }

  return { start };
})();
