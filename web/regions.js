"use strict";

/**
 * For which values of the parameters checks hold, and how likely something is: the plane of two parameters, or the line of
 * one, in which one points at a start, or writes it. What is so at a start follows from the constraints of the regions, and
 * so is exact on their borders, too.
 */
const Regions = (() => {
  const width = 248, left = 58, top = 8, bottom = 36;
  const words = /** @type {{ [outcome: string]: string }} */ (
    { holds: "holds", fails: "fails", varies: "depends on what is not shown", unknown: "not known" });

  /** @type {Player} */
  let player;
  /** @type {DataWhere} */
  let where;
  /** Which of the checks is painted; after them come the numbers. */
  let check = 0;
  /**
   * The start that the user has chosen, by the axes.
   * @type {Rational[] | null}
   */
  let chosen = null;
  /** @type {SVGElement[]} */
  let dots = [];
  /** @type {HTMLElement} */
  let told;
  /** @type {HTMLElement} */
  let verdicts;
  /** @type {SVGElement} */
  let cross;
  /** @type {HTMLInputElement[]} */
  let fields = [];
  /**
   * The constraints of the regions, piece by piece: normal . start, a relation, and a number.
   * @type {{ normal: Rational[], relation: string, right: Rational }[][][]}
   */
  let pieces = [];

  /** @param {Player} of */
  function start(of) {
    player = of;
    if (!player.data.where) {
      Dom.get("where").remove();
      return;
    }
    where = player.data.where;
    pieces = where.regions.map((r) => r.pieces.map((piece) => piece.map(({ normal, relation, right }) =>
      ({ normal: normal.map(Rational.of), relation, right: Rational.of(right) }))));
    player.on("run", () => {
      // What the run begins with is the chosen start, too.
      if (present() >= 0) chosen = null;
      mark();
    });
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
    cross = Dom.draw("g", { class: "cross", visibility: "hidden" }, ["halo", "line"].map((name) => Dom.draw("path", { class: name })));
    const picture = Dom.draw("svg", {
      viewBox: `0 0 ${size.w} ${size.h}`, class: "where", role: "application", tabindex: "0", test: "where",
      "aria-label": "Where the check holds. Arrows go from start to start.",
      click: pointAt, keydown: key, pointermove: hover,
      pointerleave: () => {
        for (const dot of dots) dot.classList.remove("near");
        tell();
      },
    }, [...shapes, cross]);
    told = Dom.make("p", { class: "quiet", role: "status", test: "where-told" });
    verdicts = Dom.make("div", { class: "where-verdicts", test: "where-verdicts" });
    Dom.fill(Dom.get("where"), chooser(), picture, legend(), told, form(), verdicts);
    mark();
  }

  /** A start can be written, too. */
  function form() {
    const wrong = Dom.make("p", { class: "plot-wrong", role: "alert", hidden: true, id: "where-wrong", test: "where-wrong" });
    fields = where.axes.map((axis, i) => Dom.make("input", {
      type: "text", "aria-label": `Start: ${Dom.clip(axis.name, 80)}`, "aria-describedby": "where-wrong", spellcheck: "false",
      autocomplete: "off", maxlength: 1000, test: `where-start-${i}`,
    }));
    const box = Dom.make("form", { class: "where-start" }, [
      ...where.axes.flatMap((axis, i) => [Dom.make("label", {}, [Dom.name(`${Dom.clip(axis.name, 24)} =`), fields[i]])]),
      Dom.make("button", { type: "submit", text: "Look", test: "where-look", title: "What is so at this start" }),
      wrong,
    ]);
    box.addEventListener("submit", (event) => {
      event.preventDefault();
      const start = fields.map((field) => Exactly.read(field.value.trim().replace("−", "-")));
      const at = start.findIndex((value) => value === null);
      const out = at < 0 ? where.axes.findIndex((axis, i) => !within(axis, /** @type {Rational} */ (start[i]))) : -1;
      const why = at >= 0 ? `“${Dom.clip(fields[at].value, 40)}” is no number, such as 5/2 or 2.5`
        : out >= 0 ? `${where.axes[out].name} is ${range(where.axes[out])}` : "";
      Dom.tell(wrong, why);
      wrong.hidden = why === "";
      if (why === "") choose(/** @type {Rational[]} */ (start));
    });
    return box;
  }

  /** @param {DataWhere["axes"][number]} axis @param {Rational} value */
  function within({ low, high }, value) {
    const [below, above] = [Rational.cmp(value, Rational.of(low.value)), Rational.cmp(Rational.of(high.value), value)];
    return (low.included ? below >= 0 : below > 0) && (high.included ? above >= 0 : above > 0);
  }

  /** @param {DataWhere["axes"][number]} axis */
  const range = ({ low, high }) =>
    `from ${Exactly.text(Rational.of(low.value))}${low.included ? "" : " (not itself)"} to ${Exactly.text(Rational.of(high.value))}${high.included ? "" : " (not itself)"}`;

  /**
   * Looks at any start.
   * @param {Rational[]} start
   */
  function choose(start) {
    const same = where.samples.findIndex((s) => coordinates(s).every((value, i) => Rational.cmp(value, start[i]) === 0));
    if (same >= 0) return open(same);
    chosen = start;
    mark();
  }

  function chooser() {
    return Dom.make("select", {
      "aria-label": "Check", test: "where-check",
      change: (/** @type {Event} */ e) => { check = Number(/** @type {HTMLSelectElement} */ (e.target).value); show(); },
    }, [...where.checks, ...where.numbers.map(({ name }) => name)].map((name, i) =>
      Dom.make("option", { value: i, selected: i === check, text: Dom.clip(name, 80) })));
  }

  /** The number that is painted, if it is one: by its place among them. */
  const number = () => check - where.checks.length;

  function legend() {
    const k = number();
    if (k < 0) {
      const seen = [...new Set(where.regions.map((r) => r.outcomes[check]))];
      return Dom.make("ul", { class: "where-legend" }, seen.map((outcome) =>
        Dom.make("li", { class: `where-${outcome}` }, [words[outcome], share((r) => r.outcomes[check] === outcome)])));
    }
    const seen = [...new Set(where.regions.map((r) => r.values[k]))].sort((a, b) => (a ?? Infinity) - (b ?? Infinity));
    return Dom.make("ul", { class: "where-legend values", test: "where-values" }, seen.map((value) => Dom.make("li", {}, [
      /** @type {any} */ (Dom.draw("svg", { width: 12, height: 12, viewBox: "0 0 12 12", "aria-hidden": "true" }, [
        Dom.draw("rect", { x: 0.5, y: 0.5, width: 11, height: 11, rx: 2, fill: tint(k, value), class: "swatch" })])),
      valued(k, value), share((r) => r.values[k] === value)])));
  }

  /** @param {number} k of a number @param {number | null} value which of its values */
  function valued(k, value) {
    if (value === null) return words.varies;
    const { least, most, form } = where.numbers[k].values[value];
    if (form !== undefined) return form;
    if (least === null) return "infinite";
    const a = Rational.of(least), b = most === null ? null : Rational.of(most);
    if (b === null) return `at least ${Exactly.both(a)}`;
    return Rational.cmp(a, b) === 0 ? Exactly.both(a) : `from ${Exactly.both(a)} to ${Exactly.both(b)}`;
  }

  /** From the least value to the greatest one: all of them differ in their lightness, too. */
  const scale = [[254, 224, 110], [116, 196, 118], [44, 140, 150], [60, 82, 140], [68, 12, 90]];

  /**
   * The colour of a value.
   * @param {number} k of a number @param {number | null} value which of its values
   */
  function tint(k, value) {
    if (value === null) return "var(--quiet)";
    const end = (/** @type {string} */ x) => Rational.toNumber(Rational.of(x));
    const known = where.numbers[k].values[value];
    if (known.least === null && known.form !== undefined) return "var(--quiet)";
    const middle = where.numbers[k].values.map(({ least, most }) =>
      least === null ? Infinity : most === null ? end(least) : (end(least) + end(most)) / 2);
    const finite = middle.filter(Number.isFinite), low = Math.min(...finite), high = Math.max(...finite);
    if (!Number.isFinite(middle[value])) return `rgb(${scale[scale.length - 1].join(", ")})`;
    const part = (high > low ? (middle[value] - low) / (high - low) : 0.5) * (scale.length - 1);
    const i = Math.min(scale.length - 2, Math.floor(part)), rest = part - i;
    return `rgb(${scale[i].map((from, c) => Math.round(from + rest * (scale[i + 1][c] - from))).join(", ")})`;
  }

  /** @param {(r: DataRegion) => boolean} is */
  function share(is) {
    let sum = Rational.zero;
    for (const r of where.regions) if (is(r)) sum = Rational.add(sum, Rational.of(r.share));
    return Rational.sign(sum) === 0 ? ", for single values alone" : Rational.cmp(sum, Rational.one) === 0 ? " everywhere in the ranges"
      : ` in ${Rational.text(sum).replace(/\/1$/, "")} of the ranges`;
  }

  /** @param {DataRegion} r */
  function region(r) {
    const k = number(), kind = k < 0 ? `where-${r.outcomes[check]}` : "where-value";
    const [fill, stroke] = k < 0 ? [null, null] : [tint(k, r.values[k]), tint(k, r.values[k])];
    return [
      ...r.polygons.map((p) => Dom.draw("path", { class: `${kind} area`, d: `M${p.map(point).join("L")}Z`, fill })),
      ...r.borders.map(({ ends: [a, b], belongs }) =>
        Dom.draw("path", { class: belongs ? "border" : "border open", d: `M${point(a)}L${point(b)}` })),
      ...r.lines.map(([a, b]) => Dom.draw("path", { class: `${kind} thin`, d: `M${point(a)}L${point(b)}`, stroke })),
      ...r.points.map((p) => Dom.draw("circle", { class: `${kind} thin`, cx: place(0, p[0]), cy: place(1, p[1]), r: 4, stroke })),
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

  /** @param {Rational[]} start by the axes */
  const spot = ([x, y]) => ({ x: place(0, Rational.text(x)), y: y === undefined ? top + height() / 2 : place(1, Rational.text(y)) });

  /** @param {DataSample} s */
  const at = (s) => spot(coordinates(s));

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

  /**
   * The run from a start at the pointer, or what is so at the start there.
   * @param {MouseEvent} event
   */
  function pointAt(event) {
    const { best, near, x, y } = nearest(event);
    if (near < 7) open(best);
    else choose(startAt(x, y));
  }

  /**
   * A start at a place of the drawing: with the simplest numbers that are less than a pixel away.
   * @param {number} x @param {number} y @returns {Rational[]}
   */
  function startAt(x, y) {
    const parts = [(x - left) / width, 1 - (y - top) / height()];
    return where.axes.map(({ low, high }, i) => {
      const [a, b] = [Rational.of(low.value), Rational.of(high.value)], span = Rational.toNumber(Rational.sub(b, a));
      const part = Math.max(0, Math.min(1, parts[i])), wanted = Rational.toNumber(a) + part * span;
      const near = (0.75 * span) / (i === 0 ? width : height());
      let found = part === 0 ? a : part === 1 ? b : Rational.add(a, Rational.mul(Rational.fromNumber(part), Rational.sub(b, a)));
      for (let d = 1; d <= 1000; d++) {
        const n = Math.round(wanted * d);
        if (!(Math.abs(n / d - wanted) <= near)) continue;
        found = Rational.make(BigInt(n), BigInt(d));
        break;
      }
      return Rational.cmp(found, a) < 0 ? a : Rational.cmp(found, b) > 0 ? b : found;
    });
  }

  /**
   * Says which start is under the pointer, and what is so there.
   * @param {MouseEvent} event
   */
  function hover(event) {
    const { best, near, x, y } = nearest(event), sample = where.samples[best], on = sample !== undefined && near < 7;
    dots.forEach((dot, i) => dot.classList.toggle("near", on && i === best));
    if (x < left - 2 || x > left + width + 2 || y < top - 2 || y > top + height() + 2) return tell();
    const start = on ? coordinates(sample) : startAt(x, y), r = regionOf(start);
    Dom.tell(told, `${named(start)}: ${r ? outcome(r, check) : "outside of the ranges"}. ${on ? "Click to see the run from there." : "Click to look at this start."}`);
  }

  /** @param {DataSample} s by the axes */
  const coordinates = (s) => where.axes.map((axis) => Rational.of(s.at[axis.name]));

  /** @param {Rational[]} start */
  const named = (start) => where.axes.map(({ name }, i) => `${Dom.clip(name, 40)} = ${Exactly.text(start[i])}`).join(", ");

  /** @param {DataSample} s */
  const values = (s) => Object.keys(s.at).map((name) => `${Dom.clip(name, 40)} = ${Exactly.text(Rational.of(s.at[name]))}`).join(", ");

  /**
   * The region that has a start, by its constraints: on borders, too, it is one alone.
   * @param {Rational[]} start by the axes
   */
  function regionOf(start) {
    const at = [start[0], start[1] || Rational.make(1n, 2n)];
    const satisfied = (/** @type {{ normal: Rational[], relation: string, right: Rational }} */ { normal, relation, right }) => {
      const side = Rational.cmp(Rational.add(Rational.mul(normal[0], at[0]), Rational.mul(normal[1], at[1])), right);
      return relation === "<" ? side < 0 : relation === "<=" ? side <= 0 : side === 0;
    };
    const k = pieces.findIndex((all) => all.some((piece) => piece.every(satisfied)));
    return k < 0 ? null : where.regions[k];
  }

  /**
   * What is so in a region.
   * @param {DataRegion} r @param {number} i of a check, or after these of a number
   */
  function outcome(r, i) {
    const k = i - where.checks.length;
    return k < 0 ? words[r.outcomes[i]] : valued(k, r.values[k]);
  }

  /**
   * What is so at a start: of all checks and numbers; and the way to a run from there.
   * @param {Rational[]} start @param {number} sample the start of a run, which is the same, or -1
   */
  function judged(start, sample) {
    const r = regionOf(start), names = [...where.checks, ...where.numbers.map(({ name }) => name)];
    const rows = r === null ? [Dom.make("li", { text: "This start is outside of the ranges." })]
      : names.slice(0, 100).map((name, i) => {
        const kind = i < where.checks.length ? `where-${r.outcomes[i]}` : "where-value";
        return Dom.make("li", { class: kind }, [Dom.name(Dom.clip(name, 80)), `: ${outcome(r, i)}`]);
      });
    return [
      Dom.make("h3", {}, [Dom.make("bdi", { text: `At ${named(start)}` })]),
      Dom.make("ul", { class: "where-legend judged" }, rows),
      ...(sample >= 0 || r === null ? [] : elsewhere(start)),
    ];
  }

  /**
   * Where no run of the file begins: the nearest one that does, and how one gets a file with a run from there.
   * @param {Rational[]} start
   */
  function elsewhere(start) {
    const from = spot(start);
    let best = -1, least = Infinity;
    where.samples.forEach((s, i) => {
      const p = at(s), far = Math.hypot(p.x - from.x, p.y - from.y);
      if (far < least) [best, least] = [i, far];
    });
    const given = where.axes.map(({ name }, i) => `-D ${Export.quoted(`${name}=${Exactly.text(start[i])}`)}`).join(" ");
    return [
      Dom.make("p", {}, [
        "No run of the file begins there. ",
        best < 0 ? null : Dom.button(`The nearest one: ${values(where.samples[best])}`, () => open(best), { class: "link", test: "where-nearest" }),
      ]),
      Dom.make("p", { class: "quiet", text: "A page with the run from there:" }),
      Dom.make("pre", { class: "source command", dir: "ltr", tabindex: "0", text: `scc view ${Export.quoted(player.data.name)} ${given} -o start.html`, test: "where-command" }),
    ];
  }

  /** @param {number} index of a sample */
  function open(index) {
    const sample = where.samples[index];
    const run = sample && player.runs.find((r) => r.way === null && r.index === sample.run);
    chosen = null;
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
    const now = present();
    const from = chosen ? spot(chosen) : now < 0 ? { x: left + width / 2, y: top + height() / 2 } : at(where.samples[now]);
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
    const now = present(), start = chosen || (now < 0 ? null : coordinates(where.samples[now]));
    dots.forEach((dot, i) => {
      dot.setAttribute("class", i === now ? "sample here" : "sample");
      dot.setAttribute("r", i === now ? "5" : "2.2");
    });
    cross.setAttribute("visibility", chosen ? "visible" : "hidden");
    if (chosen) {
      const { x, y } = spot(chosen);
      for (const line of cross.children) line.setAttribute("d", `M${x - 8} ${y}h16M${x} ${y - 8}v16`);
    }
    if (start) fields.forEach((field, i) => { field.value = Exactly.text(start[i]); });
    Dom.fill(verdicts, ...(start ? judged(start, chosen ? -1 : now) : []));
    tell();
  }

  /** Says which run is shown. */
  function tell() {
    const s = where.samples[present()];
    Dom.tell(told, s ? `The run from ${values(s)}` : "Point at a start, or write one. From the dots there are runs.");
  }

  return { start };
})();
