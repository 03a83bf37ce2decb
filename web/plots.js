"use strict";

/** Numbers over time, below each other and aligned with the timeline. */
const Plots = (() => {
  const height = 84;
  /** Plots beyond this many are not drawn at once. */
  const most = 12;
  /** @type {Player} */
  let player;
  /** @type {HTMLElement} */
  let box;
  /** @type {HTMLElement} */
  let rows;
  /** @type {HTMLElement} */
  let menu;
  /**
   * The plots that are shown.
   * @type {number[]}
   */
  let chosen = [];
  /** @type {Drawn[]} */
  let drawn = [];

  /**
   * @typedef {{plot: number, value: HTMLElement, picture: SVGElement, cursor: SVGElement, dot: SVGElement,
   *            y: (value: number) => number, words: HTMLElement | null}} Drawn
   */

  /** @param {Player} of */
  function start(of) {
    player = of;
    box = Dom.get("plots");
    Formulas.start(player, draw, (text, why, start, stop) => {
      refused();
      others();
      Wanted.refuse(text, why, start, stop);
    });
    rows = Dom.make("div", { class: "plot-rows" });
    menu = Dom.make("div", { class: "plot-menu" });
    const choose = Dom.make("details", { class: "plot-choose" }, [
      Dom.make("summary", { text: "Choose", test: "plots-choose" }),
      menu,
    ]);
    choose.addEventListener("keydown", (event) => {
      if (event.key === "Escape") choose.open = false;
    });
    const toggle = Dom.button("x–y", () => {
      oppose(!against);
      rows.lastElementChild?.scrollIntoView({ block: "nearest" });
      document.dispatchEvent(new CustomEvent("plots"));
    }, { title: "The first two numbers, one against the other", test: "plots-phase", "aria-pressed": "false" });
    oppose = (on) => {
      against = on;
      toggle.setAttribute("aria-pressed", String(against));
      draw();
    };
    Dom.get("plots-head").after(
      Dom.make("div", { class: "plot-tools" }, [
        choose,
        toggle,
        Dom.button("SVG", () => Dom.save("plots.svg", "image/svg+xml", file()), {
          title: "Save the plots as a drawing",
          test: "plots-svg",
        }),
        Dom.button("CSV", () => Dom.save("plots.csv", "text/csv", Values.csv(player, numbers())), {
          title: "Save the numbers at all events, exact and as floats",
          test: "plots-csv",
        }),
      ]),
    );
    Wanted.start(box, (text) => {
      add([text]);
      const last = rows.lastElementChild;
      if (last) last.scrollIntoView({ block: "nearest" });
    }, hints());
    box.append(rows);
    const all = player.data.plots.map((_, plot) => plot);
    chosen = all.filter((plot) => Values.varies(player, plot)).slice(0, 2);
    if (chosen.length === 0) chosen = all.slice(0, 2);
    first = chosen;
    player.on("run", draw);
    player.on("move", move);
    player.on("grow", draw);
    Timeline.onRange(draw);
    Values.onProgress(draw);
    new ResizeObserver(draw).observe(rows);
    list();
    draw();
  }

  /**
   * Plots formulas of one's own.
   * @param {string[]} texts
   */
  function add(texts) {
    const own = texts.slice(0, most).map((text) => player.data.plots.length + Formulas.add(text));
    keep(chosen.filter((plot) => !own.includes(plot)).concat(own));
    others();
  }

  /**
   * Shows plots, the last ones if there are too many; those that are left out are named.
   * @param {number[]} plots
   */
  function keep(plots) {
    out = plots.slice(0, -most);
    chosen = plots.slice(-most);
    say();
  }

  /**
   * The plots that gave way to those that were chosen last.
   * @type {number[]}
   */
  let out = [];

  /** Names the plots that were left out. */
  function say() {
    const names = out.map((plot) => Dom.clip(Formulas.text(plot), 60));
    Wanted.say(names.length === 0 ? "" : `At most ${most} plots are shown. Not shown any more: ${names.join(", ")}. See Choose.`);
  }

  /** A formula that is refused, perhaps after a while, gives its place back to the plot that it has taken it from. */
  function refused() {
    const left = chosen.filter(Formulas.there), free = chosen.length - left.length;
    if (free === 0) return;
    out = out.filter(Formulas.there);
    chosen = out.slice(-free).concat(left);
    out = out.slice(0, -free);
    say();
  }

  /** The names of bodies that move, for examples. */
  const moving = () => player.data.leaves.filter((leaf) => !leaf.fixed && leaf.name.length <= 30).map((leaf) => leaf.name);

  /** Formulas that can be written. */
  function hints() {
    const [a, b] = moving();
    const of = b ? [`x(${a})`, `distance2(${a}, ${b})`, `bound(${a}, ${b})`] : a ? [`x(${a})`, `speed2(${a})`] : ["time"];
    return `Any number or formula, such as ${[...of, "bonds()"].join(", ")}`;
  }

  /** What is said where there is no plot. */
  function nothing() {
    const [a] = moving();
    const write = `Write a number above${a ? `, such as x(${a})` : ""}.`;
    return player.data.plots.length === 0 ? `The checks of the model name no numbers. ${write}`
      : `No plot is chosen. Choose one, or write it: any number${a ? `, such as x(${a})` : ""}.`;
  }

  /** Two numbers are shown against each other. */
  let against = false;
  /**
   * Shows two numbers against each other, or not.
   * @type {(on: boolean) => void}
   */
  let oppose = () => {};
  /**
   * The numbers of the document that are shown at first.
   * @type {number[]}
   */
  let first = [];

  /** The numbers of the document that are shown, if these are others than at first; and whether two are against each other. */
  function save() {
    const shown = chosen.filter((plot) => plot < player.data.plots.length);
    return { numbers: shown.join() === first.join() ? null : shown, against };
  }

  /**
   * Shows numbers of the document, beside one's own, and two against each other.
   * @param {number[] | null} numbers @param {boolean} on
   */
  function load(numbers, on) {
    const own = chosen.filter((plot) => plot >= player.data.plots.length);
    keep((numbers || first).concat(own));
    list();
    oppose(on);
  }

  /** The first two numbers that are shown, one against the other, with the present instant. */
  function pair() {
    const two = numbers().filter((plot) => Formulas.kind(plot) !== "state").slice(0, 2);
    phase = null;
    if (!against) return null;
    if (two.length < 2) return Dom.make("p", { class: "empty", text: "Choose two numbers to see one against the other." });
    const { figure, move } = Phase.make(player, two, wide());
    phase = move;
    return figure;
  }

  /** @type {(() => void) | null} */
  let phase = null;

  /** Other plots are shown. */
  function others() {
    list();
    draw();
    document.dispatchEvent(new CustomEvent("plots"));
  }

  /** The texts of those of one's own that are shown. */
  function own() {
    return chosen.filter((plot) => plot >= player.data.plots.length).map(Formulas.text);
  }

  /** What is told of those that are shown, as exact texts. */
  function told() {
    return chosen.map((plot) => {
      const kind = Formulas.kind(plot);
      const value = kind === "temporal" ? null : Values.exact(player, player.legs, plot, player.time);
      return { plot, text: Formulas.text(plot), kind, value: value === null || typeof value === "string" ? value : Rational.text(value) };
    });
  }

  /** The boxes by which plots are chosen. */
  function list() {
    Dom.fill(
      menu,
      ...[...player.data.plots.slice(0, 500).keys(), ...Formulas.own()].map((index) => {
        const tick = Dom.make("input", {
          type: "checkbox",
          checked: chosen.includes(index),
          change: () => {
            chosen = chosen.filter((other) => other !== index);
            if (tick.checked) keep(chosen.concat(index));
            else {
              out = [];
              say();
            }
            chosen.sort((a, b) => a - b);
            if (chosen.length === most) list();
            draw();
            document.dispatchEvent(new CustomEvent("plots"));
          },
        });
        return Dom.make("label", {}, [tick, Dom.name(Dom.clip(Formulas.text(index), 300), "clipped")]);
      }),
    );
  }

  /** How wide drawings are: as the line of time, also where a bar to scroll by covers their margin. */
  const wide = () => (rows && rows.clientWidth > 0 ? box.offsetWidth : 0);

  function draw() {
    const width = wide();
    if (width === 0 || Dom.get("plots-panel").hidden) return;
    drawn = [];
    Formulas.look(chosen);
    const held = rows.contains(document.activeElement) && document.activeElement;
    Dom.fill(
      rows,
      ...chosen.map((plot) => {
        if (Formulas.kind(plot) === "temporal") return judged(plot);
        const value = Dom.make("span", { class: "plot-value", test: `plot-value-${plot}` });
        const { picture, y, empty } = chart(plot, width);
        const cursor = Dom.draw("line", { class: "plot-cursor", y1: 0, y2: height });
        const dot = Dom.draw("circle", { class: "plot-dot", r: 3.5 });
        picture.append(cursor, dot);
        // Without any value there is nothing to draw: why there is none is told whole.
        const words = empty ? Dom.make("p", { class: "quiet plot-words", test: `plot-why-${plot}` }) : null;
        drawn.push({ plot, value, picture, cursor, dot, y, words });
        picture.addEventListener("pointerdown", (event) => seek(/** @type {PointerEvent} */ (event), picture));
        picture.addEventListener("pointermove", (event) => {
          if (/** @type {PointerEvent} */ (event).buttons === 1)
            seek(/** @type {PointerEvent} */ (event), picture);
        });
        return Dom.make("figure", { class: "plot", test: `plot-${plot}` }, [
          Dom.make("figcaption", {}, [name(plot), value, remove(plot)]),
          words || /** @type {any} */ (picture),
        ]);
      }),
      pair(),
      chosen.length === 0 ? Dom.make("p", { class: "empty", test: "plots-none", text: nothing() }) : null,
    );
    // What had the focus is made anew.
    const again = held && rows.querySelector(`[data-testid="${held.getAttribute("data-testid")}"]`);
    if (again instanceof HTMLElement) again.focus({ preventScroll: true });
    move();
  }

  /** @param {number} plot */
  const name = (plot) => Dom.name(Dom.clip(Formulas.text(plot), 300), "clipped");

  /**
   * What takes a formula of one's own away.
   * @param {number} plot
   */
  function remove(plot) {
    if (plot < player.data.plots.length) return null;
    const away = () => {
      Formulas.drop(plot);
      chosen = chosen.filter(Formulas.there);
      others();
    };
    return Dom.button("×", away, { class: "small plot-remove", "aria-label": "Remove this plot", test: `remove-${plot}` });
  }

  /**
   * A formula about whole runs has no values over time: it is judged.
   * @param {number} plot
   */
  function judged(plot) {
    return Dom.make("figure", { class: "plot", test: `plot-${plot}` }, [
      Dom.make("figcaption", {}, [name(plot), remove(plot)]),
      Dom.make("div", { class: "plot-words" }, Formulas.words(plot)),
    ]);
  }

  /**
   * The drawing of one number, and where a value is on it.
   * @param {number} plot @param {number} width
   */
  function chart(plot, width) {
    const { from, to } = Timeline.range;
    const strokes = Values.points(player, plot, from, to, width);
    const other = plot < player.data.plots.length ? Compare.other() : null;
    const others = other ? Values.points(other, plot, from, to, width) : [];
    let [low, high] = [Infinity, -Infinity];
    for (const stroke of [...strokes, ...others])
      for (const [, value] of stroke) {
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    const truth = Formulas.kind(plot) === "state";
    if (truth || !(low <= high)) [low, high] = [0, 1];
    // What does not change has some room, more of it where numbers are so great that one more is the same float; so has what
    // changes by a few floats.
    const pad = Math.max(Math.abs(high) < 1e-6 ? Math.abs(high) : 1, 1e-12 * Math.abs(high));
    if (high - low <= 1e-14 * Math.abs(high)) [low, high] = [low - pad || -1, high + pad || 1];
    const free = (high - low) * 0.12;
    const y = (/** @type {number} */ value) =>
      height - 6 - ((value - low + free) / (high - low + 2 * free)) * (height - 12);
    const x = (/** @type {number} */ time) => Timeline.x(time, width);
    const picture = Dom.draw("svg", {
      class: "chart",
      width,
      height,
      viewBox: `0 0 ${width} ${height}`,
      role: "img",
      "aria-label": Dom.clip(
        `${Formulas.text(plot)} over time, from ${said(truth, low)} to ${said(truth, high)}`,
        300,
      ),
    });
    for (const time of Timeline.steps(from, to, width / 90)) {
      picture.append(
        Dom.draw("line", { class: "plot-grid", x1: x(time), x2: x(time), y1: 0, y2: height, stroke: "#8884" }),
      );
    }
    const marks = truth ? [0, 1].map((value) => /** @type {[number, string]} */ ([value, said(truth, value)]))
      : Timeline.labels(Timeline.steps(low, high, 3), 4);
    /** @type {SVGElement[]} */
    const ticks = [];
    for (const [value, text] of marks) {
      picture.append(
        Dom.draw("line", {
          class: "plot-grid",
          x1: Timeline.margin,
          x2: width - Timeline.margin,
          y1: y(value),
          y2: y(value),
          stroke: "#8884",
        }),
      );
      ticks.push(Dom.draw("text", {
        class: "plot-tick", x: Timeline.margin + 3, y: y(value) - 3, text, "font-size": 10, "font-family": "sans-serif", fill: "#777",
      }));
    }
    // Those of a second run are below.
    const beside = others.map((stroke) =>
      "M" + stroke.map(([time, value]) => `${x(time).toFixed(2)} ${y(value).toFixed(2)}`).join("L") + (stroke.length > 1 ? "" : "h0"));
    if (beside.length > 0)
      picture.append(Dom.draw("path", {
        class: "plot-line other", d: beside.join(""), "stroke-width": 2, "stroke-dasharray": "6 4", fill: "none", stroke: "#00809c",
        "stroke-linecap": "round",
      }));
    const path = strokes
      .filter((stroke) => stroke.length > 1)
      .map(
        (stroke) =>
          "M" + stroke.map(([time, value]) => `${x(time).toFixed(2)} ${y(value).toFixed(2)}`).join("L"),
      )
      .join("");
    // What is so for an instant alone is a point.
    const dots = strokes
      .filter((stroke) => stroke.length === 1)
      .map(([[time, value]]) => `M${x(time).toFixed(2)} ${y(value).toFixed(2)}h0`)
      .join("");
    const pen = { fill: "none", stroke: "#2a7de1", "stroke-linecap": "round", "stroke-linejoin": "round" };
    if (path !== "")
      picture.append(Dom.draw("path", { class: "plot-line", d: path, "stroke-width": 1.6, ...pen }));
    if (dots !== "")
      picture.append(Dom.draw("path", { class: "plot-line", d: dots, "stroke-width": 5, ...pen }));
    // Words are over all lines.
    picture.append(...ticks);
    return { picture, y, empty: strokes.length === 0 && others.length === 0 };
  }

  /** @param {boolean} truth @param {number} value */
  const said = (truth, value) => (truth ? (value === 1 ? "true" : "false") : Exactly.decimal(value));

  /** When the values of one's own were last told. */
  let last = 0;

  function move() {
    if (Dom.get("plots-panel").hidden) return;
    const width = wide();
    const at = Timeline.x(player.clock, width).toFixed(2);
    const inside = player.clock >= Timeline.range.from && player.clock <= Timeline.range.to;
    if (phase) phase();
    // What is about all of very many bodies takes a good part of a frame: while the run is played, it is told now and then.
    const many = player.playing && player.course.leaves.length > 200, now = performance.now(), rest = many && now - last < 250;
    if (!rest) last = now;
    for (const { plot, value, cursor, dot, y, words } of drawn) {
      cursor.setAttribute("transform", `translate(${at} 0)`);
      cursor.setAttribute("visibility", inside ? "visible" : "hidden");
      if (rest && plot >= player.data.plots.length) continue;
      const now = Values.exact(player, player.legs, plot, player.time);
      dot.setAttribute("visibility", inside && typeof now !== "string" ? "visible" : "hidden");
      if (typeof now === "string") {
        if (words) Dom.tell(words, now);
        else Dom.tell(value, Dom.clip(now, 80));
        continue;
      }
      if (words) Dom.tell(words, "");
      const near = Rational.toNumber(now);
      if (Number.isFinite(near)) dot.setAttribute("transform", `translate(${at} ${y(near).toFixed(2)})`);
      const exact = Exactly.text(now);
      if (Formulas.kind(plot) === "state") Dom.tell(value, said(true, near));
      else Dom.tell(value, player.playing || exact.length > 28 ? Rational.decimal(now).text : Exactly.both(now));
    }
  }

  /** @param {PointerEvent} event @param {SVGElement} picture */
  function seek(event, picture) {
    const width = wide() - 2 * Timeline.margin;
    const part = (event.clientX - picture.getBoundingClientRect().left - Timeline.margin) / width;
    const { from, to } = Timeline.range;
    const time = from + Math.max(0, Math.min(1, part)) * (to - from);
    player.pause();
    player.seek(time >= player.end ? player.course.duration : Exactly.grid(time));
  }

  /** The plots that are shown and have values over time. */
  const numbers = () => chosen.filter((plot) => Formulas.kind(plot) !== "temporal");

  /** These as a file of its own. */
  function file() {
    const width = 900, chosen = numbers();
    const whole = (height + 26) * chosen.length + 24;
    const picture = Dom.draw("svg", {
      xmlns: "http://www.w3.org/2000/svg",
      width,
      height: whole,
      viewBox: `0 0 ${width} ${whole}`,
    });
    picture.append(Dom.draw("rect", { width, height: whole, fill: "#fff" }));
    chosen.forEach((plot, i) => {
      const row = Dom.draw("g", { transform: `translate(0 ${i * (height + 26) + 20})` });
      row.append(
        Dom.draw("text", {
          x: Timeline.margin,
          y: -5,
          "font-size": 12,
          "font-family": "sans-serif",
          text: Dom.clip(Formulas.text(plot), 120),
        }),
        ...chart(plot, width).picture.childNodes,
      );
      picture.append(row);
    });
    const { from, to } = Timeline.range;
    for (const [time, text] of Timeline.labels(Timeline.steps(from, to, 10))) {
      picture.append(
        Dom.draw("text", {
          x: Timeline.x(time, width),
          y: whole - 8,
          "font-size": 11,
          "font-family": "sans-serif",
          "text-anchor": "middle",
          text,
        }),
      );
    }
    return new XMLSerializer().serializeToString(picture);
  }

  return { start, draw, add, own, told, save, load };
})();
