"use strict";

/**
 * Numbers and formulas that somebody writes, plotted along the run that is shown beside those of the document. A page that
 * is served asks for them; one that was opened from disk evaluates them itself, at each instant (`Meaning`).
 *
 * @typedef {{ key: string, path: number[], through: number, lasts: boolean, parameters: { [name: string]: string } | null }}
 *   Asked  What leads to a run: choices from the initial state, perhaps with other values of parameters; after the last of
 *   them, time alone passes until so many legs are taken, and `lasts` if any does.
 * @typedef {{ text: string, kind: "" | "number" | "state" | "temporal", known: Map<string, DataPiece[] | string>,
 *   asked: string, judged: Judged | null }} Formula  Its values along runs, or why there are none.
 * @typedef {{ run: PlayedRun, legs: number, text: string, facts: string[], choices: number[] }} Judged
 */
const Formulas = (() => {
  /** @type {Player} */
  let player;
  /** @type {Formula[]} */
  let all = [];
  /** @type {() => void} */
  let changed = () => {};
  /** @type {(text: string, why: string, start: number, stop: number) => void} */
  let refuse = () => {};
  /** The model has no handle. */
  const nobody = "not in models with parameters without values, or bonds that are released at any instant";
  /** Values along so many runs are kept of each. */
  const kept = 20;
  /** How far a verdict is looked for: other questions wait meanwhile. */
  const limits = { states: 20000, seconds: 20 };

  /**
   * @param {Player} of @param {() => void} redraw when values have come
   * @param {(text: string, why: string, start: number, stop: number) => void} wrong tells what is wrong with a text, and
   *   between which of its characters
   */
  function start(of, redraw, wrong) {
    player = of;
    changed = redraw;
    refuse = wrong;
  }

  /**
   * The number of a formula, which is a new one if need be.
   * @param {string} text
   */
  function add(text) {
    const found = all.findIndex((one) => one.text === text);
    if (found >= 0) return found;
    all.push({ text, kind: "", known: new Map(), asked: "", judged: null });
    return all.length - 1;
  }

  /**
   * @param {number} plot one of the document, or after these one's own; without a text when it is taken away
   */
  function text(plot) {
    const { plots } = player.data;
    return plot < plots.length ? plots[plot].text : all[plot - plots.length].text;
  }

  /** @param {number} plot */
  function kind(plot) {
    const { plots } = player.data;
    return plot < plots.length ? "number" : all[plot - plots.length].kind;
  }

  /**
   * Of the formulas of a page from disk, what they are for the bodies of a run.
   * @type {WeakMap<DataLeaf[], Map<string, Compiled>>}
   */
  const compiled = new WeakMap();

  /**
   * @param {string} text @returns {Compiled} or an exception `Reader.Wrong`
   */
  function compile(text) {
    const { data, course, run } = player, values = { ...data.parameters, ...run.values };
    let known = compiled.get(course.leaves);
    if (!known) compiled.set(course.leaves, (known = new Map()));
    const key = JSON.stringify([text, values]);
    let found = known.get(key);
    if (!found) known.set(key, (found = Meaning.compile(data, course.leaves, values, text)));
    return found;
  }

  /** @param {Compiled} formula @param {number} state @param {number} legs @param {Rational} time */
  function at({ run, needs }, state, legs, time) {
    const { data, course } = player, bodies = needs ? course.some(needs, legs, time) : course.bodiesAfter(legs, time);
    return run(Meaning.view(data, course.leaves, state, bodies, time));
  }

  /**
   * The exact value of one's own after so many legs, at a time, in a page from disk; a truth is 1 or 0.
   * @param {number} own @param {number} legs @param {Rational} time @returns {Rational | string} or why there is none
   */
  function value(own, legs, time) {
    const { course, run } = player;
    try {
      const state = legs === 0 ? run.start : course.legs[legs - 1].after;
      const found = at(compile(all[own].text), state, legs, time);
      return found instanceof Nothing ? found.why : typeof found === "boolean" ? (found ? Rational.one : Rational.zero) : found;
    } catch (error) {
      return Grow.said(error);
    }
  }

  /**
   * What a formula is at the instant that is shown, by the page itself.
   * @param {string} text
   */
  function evaluate(text) {
    const { legs, time, state } = player;
    try {
      const found = at(compile(text), state, legs, time);
      return found instanceof Nothing ? { value: null, why: found.why } : { value: typeof found === "boolean" ? found : Rational.text(found) };
    } catch (error) {
      if (!(error instanceof Reader.Wrong)) throw error;
      return { wrong: error.message, at: error.at, whole: error.whole };
    }
  }

  /**
   * Learns what somebody's text is, in a page from disk: if it is none, it is refused.
   * @param {Formula} formula
   */
  function learn(formula) {
    try {
      formula.kind = compile(formula.text).type === "truth" ? "state" : "number";
    } catch (error) {
      if (!(error instanceof Reader.Wrong)) throw error;
      if (error.whole) formula.kind = "temporal";
      else {
        drop(player.data.plots.length + all.indexOf(formula));
        refuse(formula.text, error.message, ...error.at);
      }
    }
  }

  /** @type {WeakMap<PlayedRun, Asked | string>} */
  const ways = new WeakMap();

  /**
   * What leads to a run, or why it cannot be said.
   * @param {PlayedRun} run @returns {Asked | string}
   */
  function way(run) {
    let found = ways.get(run);
    if (found === undefined) ways.set(run, (found = find(run)));
    return found;
  }

  /** @param {PlayedRun} run @returns {Asked | string} */
  function find(run) {
    const { data } = player;
    const values = run.values && Object.keys(run.values).length > 0 ? run.values : null;
    if (!values && run.start !== 0) return "the run does not begin in the initial state";
    /** @type {number[]} */
    const path = [];
    let state = run.start;
    for (const step of run.steps) {
      const next = data.states[state].next, taken = next && step.choice !== null ? next[step.choice] : null;
      // Less time passes than could: no choice leads there.
      if (step.choice === null || step.tail || (taken && taken.label !== step.label)) break;
      path.push(step.choice);
      state = step.to;
    }
    let through = path.length;
    while (through < run.steps.length && data.labels[run.steps[through].label].duration) through++;
    const parameters = values ? { ...data.parameters, ...values } : null;
    const lasts = run.steps.length > path.length || Rational.sign(Rational.of(run.rest)) > 0;
    return { key: `${JSON.stringify(parameters)} ${path.map((choice) => `${choice}.`).join("")}`, path, through, lasts, parameters };
  }

  /**
   * What was told of a formula along a way, or along one that goes on from it: that tells what is so at each instant, and
   * while time passes only of the states that both leave by the same choice.
   * @param {Formula} formula @param {Asked} asked
   */
  function told(formula, asked) {
    const exactly = formula.known.get(asked.key);
    if (exactly !== undefined || asked.lasts) return exactly;
    for (const [key, values] of formula.known)
      if (typeof values !== "string" && key.startsWith(asked.key)) return values;
    return undefined;
  }

  /**
   * What a formula is after so many legs of the run that is shown, and from when on its time counts.
   * @param {number} own @param {number} legs
   * @returns {{ of: DataPiece | null, since: Rational, why: string }}
   */
  function piece(own, legs) {
    const asked = way(player.run), none = (/** @type {string} */ why) => ({ of: null, since: Rational.zero, why });
    if (typeof asked === "string") return none(asked);
    const values = told(all[own], asked);
    if (values === undefined) return none("…");
    if (typeof values === "string") return none(values);
    if (legs > asked.through) return none("not known after less time than could pass");
    const k = Math.min(legs, asked.path.length);
    return { of: values[k] || null, since: player.instant(k), why: "none" };
  }

  /**
   * The handle of the model with the values of a run.
   * @type {Map<string, Promise<string>>}
   */
  const handles = new Map();

  /** @param {{ [name: string]: string } | null} parameters */
  function model(parameters) {
    if (!parameters) return Promise.resolve("m1");
    const key = JSON.stringify(parameters);
    let handle = handles.get(key);
    if (!handle) {
      const params = () => ({ text: player.data.text, parameters });
      const loaded = Live.ask("model.load", params, (result) => result.model);
      handle = /** @type {Promise<string>} */ (loaded);
      handles.set(key, handle);
    }
    return handle;
  }

  /**
   * Asks for what is not known of these along the run that is shown.
   * @param {number[]} plots
   */
  function look(plots) {
    for (const plot of plots) {
      const formula = all[plot - player.data.plots.length];
      if (!formula || formula.kind === "temporal") continue;
      if (Live.on) along(formula);
      else if (formula.kind === "") learn(formula);
    }
  }

  /** @param {Formula} formula */
  async function along(formula) {
    const asked = way(player.run);
    if (typeof asked === "string" || told(formula, asked) !== undefined || formula.asked === asked.key) return;
    const { key, path, parameters } = asked;
    const still = () => formula.asked === key && all.includes(formula);
    formula.asked = key;
    try {
      const handle = await model(parameters);
      const params = () => ({ model: handle, path, formula: formula.text });
      await Live.ask("values", params, (result) => {
        formula.kind = result.kind;
        keep(formula, key, result.values);
      }, { still });
    } catch (error) {
      wrong(formula, key, error);
    }
    if (formula.asked === key) formula.asked = "";
    changed();
  }

  /** @param {Formula} formula @param {string} key @param {DataPiece[] | string} values */
  function keep(formula, key, values) {
    formula.known.set(key, values);
    for (const old of formula.known.keys()) if (formula.known.size > kept) formula.known.delete(old);
  }

  /**
   * Why there is no answer: the text is no formula, or one about whole runs, or something else.
   * @param {Formula} formula @param {string} key @param {any} error
   */
  function wrong(formula, key, error) {
    const { code, data } = error instanceof Live.Refusal ? error : { code: 0, data: {} };
    if (code === -32602 && data.at === "formula") formula.kind = "temporal";
    else if (code === -32001) keep(formula, key, nobody);
    else if (code !== -32007) keep(formula, key, Grow.said(error));
    else if (all.includes(formula)) {
      drop(player.data.plots.length + all.indexOf(formula));
      const first = (data.diagnostics || [])[0];
      const at = (/** @type {any} */ end) => characters(formula.text, end ? end.offset : 0);
      if (first) refuse(formula.text, first.message, at(first.place && first.place.start), at(first.place && first.place.end));
      else refuse(formula.text, Grow.said(error), 0, 0);
    }
  }

  /**
   * How many characters so many bytes are.
   * @param {string} text @param {number} bytes
   */
  function characters(text, bytes) {
    return new TextDecoder().decode(new TextEncoder().encode(text).slice(0, bytes)).length;
  }

  /**
   * Whether a plot is there: a text that was refused is none any more.
   * @param {number} plot
   */
  const there = (plot) => text(plot) !== "";

  /**
   * Takes one of one's own away; the numbers of the others stay.
   * @param {number} plot
   */
  function drop(plot) {
    const at = plot - player.data.plots.length;
    all[at] = { ...all[at], text: "" };
  }

  /**
   * Whether one of one's own is about all bodies, in a page from disk.
   * @param {number} own
   */
  function wide(own) {
    try {
      return compile(all[own].text).needs === null;
    } catch (_) {
      return false;
    }
  }

  /** The plots that are one's own. */
  const own = () => all.map((_, i) => player.data.plots.length + i).filter(there);

  /**
   * Judges a formula about whole runs at the state that is shown.
   * @param {number} plot
   */
  async function judge(plot) {
    const formula = all[plot - player.data.plots.length], { run, legs } = player, asked = way(run);
    const say = (/** @type {Partial<Judged>} */ said) => {
      formula.judged = { run, legs, text: "", facts: [], choices: [], ...said };
      changed();
    };
    if (typeof asked === "string" || legs > asked.path.length) {
      say({ text: typeof asked === "string" ? asked : "no choices lead to this state: less time has passed than could" });
      return;
    }
    try {
      const handle = await model(asked.parameters), path = asked.path.slice(0, legs);
      const params = () => ({ model: handle, path, formula: formula.text, limits });
      await Live.ask("evaluate", params, ({ report, explored }) => say(verdict(report, explored)));
    } catch (error) {
      say({ text: Grow.said(error) });
    }
  }

  /** @param {any} report @param {any} explored @returns {Partial<Judged>} */
  function verdict(report, explored) {
    const steps = (report.witness && report.witness.steps) || [];
    const part = steps.findIndex((/** @type {any} */ step) => typeof step.choice !== "number");
    const choices = (part < 0 ? steps : steps.slice(0, part)).map((/** @type {any} */ step) => step.choice);
    const states = explored.states === 1 ? "one state" : `${explored.states} states`;
    const reasons = (report.reasons || []).filter((/** @type {any} */ why) => typeof why === "string");
    return {
      text: `${[report.text, ...reasons].join("; ")} (${states} looked at)`, choices,
      facts: (report.witness && report.witness.facts) || [],
    };
  }

  /**
   * What is said of a formula about whole runs.
   * @param {number} plot
   */
  function words(plot) {
    const formula = all[plot - player.data.plots.length], judged = formula.judged;
    if (!Live.on)
      return [Dom.make("p", { class: "quiet", text: "It is about whole runs: `scc check` judges it, and `scc serve` from any state." })];
    const button = Dom.button("Judge here", () => judge(plot), { class: "small", test: `judge-${plot}` });
    if (!judged) return [Dom.make("p", { class: "quiet", text: "It is about whole runs. " }), button];
    const where = `From step ${judged.legs} of ${judged.run.name} on: `;
    return [
      Dom.make("p", { test: `judged-${plot}` }, [Dom.make("bdi", { text: Dom.clip(where + judged.text, 1000) })]),
      ...judged.facts.slice(0, 3).map((fact) => Dom.make("p", { class: "quiet" }, [Dom.make("bdi", { text: fact })])),
      Dom.make("p", {}, [button, judged.choices.length > 0 ? follow(judged) : null]),
    ];
  }

  /**
   * The run that shows a verdict, as a way of one's own.
   * @param {Judged} judged
   */
  function follow(judged) {
    const { base, legs, choices } = Ways.until(judged.run, judged.legs);
    const to = async () => {
      if (await player.walk(base, legs, choices.concat(judged.choices))) player.go(judged.legs);
    };
    return Dom.button("Show its run", to, { class: "small", test: "judged-run" });
  }

  return { start, wide, add, drop, text, kind, piece, value, evaluate, look, own, there, words };
})();
