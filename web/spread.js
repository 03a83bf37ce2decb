"use strict";

/**
 * All runs of a simulation: how many of them have which values at a time of its table, as bars. Those of the page are
 * chosen by a bar in which they are.
 */
const Spread = (() => {
  /** So many observables are drawn at once. */
  const most = 12;
  /** Bars have their numbers written above and below them, if there are no more than this many. */
  const few = 8;

  /** @type {Player} */
  let player;
  /** @type {DataSpread} */
  let data;
  /** @type {Rational[]} */
  let times = [];
  /** Which time is shown. */
  let at = 0;
  /** The first observable that is drawn. */
  let from = 0;
  /** Whether the clock is moved from here, so that the time that is shown stays. */
  let held = false;
  /** @type {HTMLInputElement} */
  let slider;
  /** @type {HTMLElement} */
  let clock;
  /** @type {HTMLElement} */
  let apart;
  /** @type {HTMLElement} */
  let figures;
  /** @type {HTMLElement} */
  let told;
  /**
   * The observables of which the numbers are shown exactly.
   * @type {Set<number>}
   */
  const open = new Set();

  /** @typedef {{ from: Rational, width: Rational, single: boolean, counts: number[] }} Bars */

  /** @param {Player} of */
  function start(of) {
    player = of;
    if (!player.data.spread) {
      Dom.get("spread").remove();
      return;
    }
    data = player.data.spread;
    times = data.times.map(Rational.of);
    slider = Dom.make("input", {
      type: "range", min: 0, max: times.length - 1, step: 1, value: 0, "aria-label": "Time of the table", test: "spread-time",
      input: () => go(Number(slider.value)),
      keydown: (/** @type {KeyboardEvent} */ event) => event.stopPropagation(),
    });
    clock = Dom.make("span", { class: "spread-clock", test: "spread-clock" });
    apart = Dom.make("p", { class: "quiet", test: "spread-apart" });
    figures = Dom.make("div", {});
    told = Dom.make("p", { class: "spread-told", role: "status", test: "spread-told" });
    Dom.fill(
      Dom.get("spread"),
      Dom.make("p", { test: "spread-runs", text: about() }),
      Dom.make("div", { class: "spread-when" }, [
        Dom.button("‹", () => go(at - 1), { class: "small", "aria-label": "Earlier time of the table", test: "spread-earlier" }),
        slider,
        Dom.button("›", () => go(at + 1), { class: "small", "aria-label": "Later time of the table", test: "spread-later" }),
      ]),
      clock, apart, chooser(), told, figures, legend(),
    );
    player.on("run", draw);
    player.on("move", () => {
      if (held) return;
      const now = last(player.time);
      if (now !== at) show(now);
      else values();
    });
    at = last(player.time);
    draw();
  }

  const count = (/** @type {number} */ n, /** @type {string} */ word) => `${n.toLocaleString("en").replace(/,/g, " ")} ${word}${n === 1 ? "" : "s"}`;

  /** What is counted here, and which runs the page has. */
  function about() {
    const { asked, made, first, shown, hurried } = data;
    const all = made === asked ? `${count(made, "run")}, from number ${first} on.` : `${count(made, "run")}, from number ${first} on; the command ended before ${count(asked, "run")}.`;
    const numbers = shown.map(({ run }) => run), straight = numbers.every((n, i) => n === numbers[0] + i);
    const which = straight && numbers.length > 2 ? `${numbers[0]} to ${numbers[numbers.length - 1]}` : numbers.join(", ");
    const fitting = hurried ? ", as many as there was time for after an interruption" : numbers.length < Math.min(20, made) ? ", as many as fit" : "";
    return numbers.length === 0 ? `${all} The page shows none of them.` : `${all} The page shows ${numbers.length} of them${fitting}: ${which}.`;
  }

  /** Of many observables, some are drawn at once. */
  function chooser() {
    const all = data.observables.length;
    if (all <= most) return null;
    const pages = [...Array(Math.ceil(all / most)).keys()].map((page) => page * most);
    const select = Dom.make("select", {
      "aria-label": "Observables", test: "spread-which",
      change: () => {
        from = Number(select.value);
        draw();
      },
    }, pages.map((first) => Dom.make("option", { value: first, text: `Observables ${first + 1} to ${Math.min(all, first + most)} of ${all}` })));
    return select;
  }

  function legend() {
    return Dom.make("ul", { class: "spread-legend quiet" }, [
      Dom.make("li", { class: "spread-has", text: "has runs of the page: press it to see one" }),
      Dom.make("li", { class: "spread-lacks", text: "has other runs alone" }),
      Dom.make("li", { class: "spread-here", text: "has the run that is seen" }),
    ]);
  }

  /**
   * The last time of the table that is not after a time.
   * @param {Rational} time
   */
  function last(time) {
    let low = 0, high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (Rational.cmp(times[middle], time) <= 0) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /**
   * Shows a time, here and in the scene.
   * @param {number} index
   */
  function go(index) {
    const to = Math.max(0, Math.min(times.length - 1, index));
    Dom.tell(told, "");
    hold(() => {
      player.pause();
      player.seek(times[to]);
    });
    show(to);
  }

  /** @param {() => void} move */
  function hold(move) {
    held = true;
    try {
      move();
    } finally {
      held = false;
    }
  }

  /** @param {number} index */
  function show(index) {
    at = index;
    draw();
  }

  /** Which run of the page is seen, if it is one of the table. */
  const seen = () => (player.run.way ? -1 : player.run.index);

  /**
   * The value that a run of the page has.
   * @param {number} run @param {number} observable
   */
  function value(run, observable) {
    const text = data.shown[run] ? data.shown[run].values[at][observable] : null;
    return text === null ? null : Rational.of(text);
  }

  /** @param {DataCell} cell @returns {Bars | null} */
  function bars({ from, width, single, counts }) {
    if (from === undefined || width === undefined || !counts) return null;
    return { from: Rational.of(from), width: Rational.of(width), single: single === true, counts };
  }

  /** @param {Bars} bars @param {Rational | null} value which bar has it */
  function bar({ from, width }, value) {
    if (value === null) return -1;
    const { n, d } = Rational.div(Rational.sub(value, from), width);
    return Number((n - (((n % d) + d) % d)) / d);
  }

  /** @param {Bars} bars @param {number} i where a bar begins */
  const edge = (bars, i) => Rational.add(bars.from, Rational.mul(bars.width, Rational.of(String(i))));

  const short = (/** @type {Rational} */ r) => Rational.decimal(r, 4).text;

  function draw() {
    slider.value = String(at);
    slider.setAttribute("aria-valuetext", `t = ${Exactly.both(times[at])}`);
    Dom.fill(clock, "t = ", Exactly.show(times[at]));
    const { over, cut, made } = data;
    const lines = [
      over[at] > 0 ? `${count(over[at], "run")} of ${count(made, "run")} had ended before, with no value now.` : "",
      cut[at] > 0 ? `${count(cut[at], "run")} of ${count(made, "run")} had been cut short by the interruption of the command.` : "",
    ];
    Dom.tell(apart, lines.filter((line) => line !== "").join(" "));
    apart.hidden = apart.textContent === "";
    const focus = document.activeElement instanceof HTMLElement && figures.contains(document.activeElement)
      ? document.activeElement.getAttribute("data-testid") : null;
    const some = data.observables.slice(from, from + most).map((_, k) => figure(from + k));
    Dom.fill(figures, ...some);
    const again = focus && figures.querySelector(`[data-testid="${focus}"]`);
    if (again instanceof HTMLElement) again.focus({ preventScroll: true });
    values();
  }

  /** @param {number} observable */
  function figure(observable) {
    const cell = data.cells[at][observable], found = bars(cell);
    const text = data.observables[observable];
    return Dom.make("figure", { class: "spread-figure", test: `spread-${observable}` }, [
      Dom.make("figcaption", {}, [Dom.name(Dom.clip(text, 300))]),
      found ? chart(observable, found, Dom.clip(text, 80)) : Dom.make("p", { class: "quiet", text: "No run has a value now." }),
      cell.none > 0 ? Dom.make("p", { class: "quiet", test: `spread-none-${observable}`,
        text: `${count(cell.none, "run")} that went on ${cell.none === 1 ? "has" : "have"} no value.` }) : null,
      found ? numbers(observable, cell, found) : null,
      Dom.make("p", { class: "spread-this", test: `spread-this-${observable}` }),
    ]);
  }

  /**
   * Least, mean and greatest: rounded, and exactly on demand.
   * @param {number} observable @param {DataCell} cell @param {Bars} bars
   */
  function numbers(observable, { least, mean, greatest }, { counts }) {
    const all = counts.reduce((a, b) => a + b, 0);
    /** @type {[string, string | { near: string } | undefined][]} */
    const rows = [["least", least], ["mean", mean], ["greatest", greatest]];
    const near = (/** @type {string | { near: string } | undefined} */ text) => {
      if (text === undefined) return "";
      if (typeof text !== "string") return `≈ ${text.near}`;
      const decimal = Rational.decimal(Rational.of(text), 5);
      return (decimal.exact ? "" : "≈ ") + decimal.text;
    };
    const exactly = (/** @type {string | { near: string } | undefined} */ text) => typeof text === "string" ? [Exactly.show(Rational.of(text))]
      : text ? [Dom.make("span", { class: "exact", text: `≈ ${text.near}` }),
        Dom.make("span", { class: "near", text: "All its digits are too many for the page: scc simulate --summary writes them." })] : [];
    const details = Dom.make("details", { open: open.has(observable), test: `spread-exact-${observable}` }, [
      Dom.make("summary", { text: `${count(all, "value")}: ${rows.map(([name, text]) => `${name} ${near(text)}`).join(", ")}` }),
      Dom.make("dl", { class: "facts" }, [
        Dom.make("dt", { text: "count" }), Dom.make("dd", { text: String(all) }),
        ...rows.flatMap(([name, text]) => [Dom.make("dt", { text: name }), Dom.make("dd", {}, exactly(text))]),
      ]),
    ]);
    details.addEventListener("toggle", () => {
      if (details.open) open.add(observable);
      else open.delete(observable);
    });
    return details;
  }

  /**
   * The bars, each with the runs that it has.
   * @param {number} observable @param {Bars} bars_ @param {string} name
   */
  function chart(observable, bars_, name) {
    const { counts, single } = bars_, high = counts.reduce((a, b) => Math.max(a, b), 1);
    const inside = counts.map(() => /** @type {number[]} */ ([]));
    data.shown.forEach((_, run) => {
      const i = bar(bars_, value(run, observable));
      if (inside[i]) inside[i].push(run);
    });
    const here = bar(bars_, seen() < 0 ? null : value(seen(), observable));
    const chosen = here >= 0 && counts[here] > 0 ? here : counts.findIndex((n) => n > 0);
    const written = counts.length <= few;
    const columns = counts.map((n, i) => {
      const range = single ? `${Exactly.both(edge(bars_, i))}` : `from ${Exactly.both(edge(bars_, i))} to below ${Exactly.both(edge(bars_, i + 1))}`;
      const fill = Dom.make("span", { class: "spread-fill" });
      fill.style.height = n === 0 ? "0" : `max(3px, ${((100 * n) / high).toFixed(2)}%)`;
      const above = written && n > 0 ? Dom.make("span", { class: "spread-count", text: String(n) }) : null;
      if (n === 0) return Dom.make("span", { class: "spread-bar empty", title: `${name}: ${range}: no run` });
      const of = inside[i].map((run) => data.shown[run].run);
      const words = `${name}: ${range}: ${count(n, "run")}. ${of.length === 0 ? "None of them is on the page" : `On the page: ${of.length === 1 ? "run" : "runs"} ${of.join(", ")}`}.`;
      return Dom.make("button", {
        type: "button", class: `spread-bar${of.length > 0 ? " has" : ""}${i === here ? " here" : ""}`, "aria-label": words, title: words,
        tabindex: i === chosen ? "0" : "-1", "aria-current": i === here ? "true" : null, test: `spread-${observable}-bar-${i}`,
        click: () => choose(observable, i, inside[i], n),
      }, [above, fill]);
    });
    return Dom.make("div", { class: "spread-chart" }, [
      written ? null : Dom.make("span", { class: "spread-high", text: count(high, "run"), "aria-hidden": "true" }),
      Dom.make("div", { class: "spread-bars", role: "group", "aria-label": `${name} at t = ${Exactly.text(times[at])}`, keydown: walk }, columns),
      axis(bars_),
    ]);
  }

  /** @param {Bars} bars what is written below them */
  function axis(bars) {
    const { counts, single } = bars, size = counts.length;
    const every = single ? size : size + 1, shift = single ? 0.5 : 0;
    const all = [...Array(every).keys()], texts = all.map((i) => short(edge(bars, i)));
    // Of more than fit into a narrow panel, some at equal distances.
    const room = Math.max(2, Math.floor(34 / Math.max(...texts.map((text) => text.length), 1)));
    const step = Math.ceil((every - 1) / Math.max(1, room - 1)) || 1;
    return Dom.make("div", { class: "spread-axis", "aria-hidden": "true" }, all.filter((i) => i % step === 0).map((i) => {
      const label = Dom.make("span", { text: texts[i] });
      label.style.left = `${((100 * (i + shift)) / size).toFixed(2)}%`;
      return label;
    }));
  }

  /** @param {KeyboardEvent} event from bar to bar */
  function walk(event) {
    const row = /** @type {HTMLElement} */ (event.currentTarget);
    const all = /** @type {HTMLElement[]} */ ([...row.querySelectorAll("button")]), now = all.indexOf(/** @type {any} */ (document.activeElement));
    /** @type {{ [key: string]: number }} */
    const moves = { ArrowLeft: now - 1, ArrowRight: now + 1, Home: 0, End: all.length - 1 };
    if (now < 0 || moves[event.key] === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const to = all[Math.max(0, Math.min(all.length - 1, moves[event.key]))];
    for (const one of all) one.tabIndex = one === to ? 0 : -1;
    to.focus();
  }

  /**
   * Shows a run of a bar: the next one, if it is one of them that is seen.
   * @param {number} observable @param {number} i @param {number[]} runs of the page @param {number} all
   */
  function choose(observable, i, runs, all) {
    const text = Dom.clip(data.observables[observable], 80);
    if (runs.length === 0) {
      Dom.tell(told, `${all === 1 ? "The run" : `The ${count(all, "run")}`} of this bar of ${text} ${all === 1 ? "is" : "are"} not on the page.`);
      return;
    }
    const next = runs[(runs.indexOf(seen()) + 1) % runs.length];
    const run = player.runs.find((one) => one.index === next && one.way === null);
    if (run) hold(() => visit(run, times[at]));
    draw();
    const number = data.shown[next].run;
    const early = run && Rational.cmp(player.course.duration, times[at]) < 0 ? ` The page shows it up to t = ${Exactly.both(player.course.duration)}.` : "";
    Dom.tell(told, `Run ${number}, ${runs.indexOf(next) + 1} of ${count(runs.length, "run")} of the page in this bar.${early}`);
  }

  /**
   * Shows a run at a time.
   * @param {PlayedRun} run @param {Rational} time
   */
  function visit(run, time) {
    if (run !== player.run) player.open(run, 0);
    player.seek(time);
  }

  /**
   * Shows another run of a simulation at the time at which one is.
   * @param {PlayedRun} run
   */
  function open_(run) {
    const { time } = player;
    hold(() => visit(run, time));
    Dom.tell(told, "");
    show(last(time));
  }

  /** What the run that is seen has. */
  function values() {
    data.observables.slice(from, from + most).forEach((_, k) => {
      const line = figures.querySelector(`[data-testid="spread-this-${from + k}"]`);
      if (!line) return;
      const run = seen(), now = run < 0 ? null : value(run, from + k);
      const word = run < 0 || !data.shown[run] ? "" : `Run ${data.shown[run].run}: `;
      Dom.tell(line, word === "" ? "" : word + (now === null ? "no value" : Exactly.both(now)));
    });
  }

  /** Whether the page is of a simulation. */
  const there = () => data !== undefined;

  /** The time of the table that is shown, and what the run that is seen has then, as exact texts. */
  function now() {
    return there() ? { time: data.times[at], run: seen(), values: seen() < 0 ? null : data.shown[seen()].values[at] } : null;
  }

  return { start, there, open: open_, now };
})();
