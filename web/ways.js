"use strict";

/** Runs of one's own: so many legs of a run of the file, and then by choices out of what its states make possible. */
const Ways = (() => {
  /** How many of them are kept. */
  const most = 8;

  /**
   * What leads to a position of a run: so many legs of a run of the file, and choices.
   * @param {PlayedRun} run @param {number} legs @returns {{base: number, legs: number, choices: number[]}}
   */
  function until(run, legs) {
    const way = run.way || { base: run.index, legs, choices: [] };
    const kept = Math.min(way.legs, legs);
    return { base: way.base, legs: kept, choices: way.choices.slice(0, legs - kept) };
  }

  /**
   * The run of a way, or null where the file has none.
   * @param {PageData} data @param {PlayedRun} from @param {number} legs @param {number[]} choices
   * @returns {PlayedRun | null}
   */
  function make(data, from, legs, choices) {
    if (!(legs >= 0 && legs <= from.steps.length)) return null;
    /** @type {DataStep[]} */
    const steps = from.steps.slice(0, legs);
    let state = legs === 0 ? from.start : steps[legs - 1].to;
    for (const choice of choices) {
      const next = data.states[state].next;
      const taken = next && next[choice];
      if (!taken || taken.to === null) return null;
      steps.push({ choice, label: taken.label, to: taken.to, rules: taken.rules });
      state = taken.to;
    }
    return {
      name: `own way from ${from.name}`,
      check: null,
      start: from.start,
      steps,
      rest: "0/1",
      index: from.index,
      way: { base: from.index, legs, choices },
      values: from.values,
      leaves: from.leaves,
    };
  }

  /**
   * Runs with one more: it takes the place of those that it goes on from, and of the oldest where there are many.
   * @param {PlayedRun[]} runs @param {PlayedRun} run
   */
  function among(runs, run) {
    const others = runs.filter((other) => !begins(run, other));
    const old = others.filter((other) => other.way).slice(0, -(most - 1));
    return others.filter((other) => !old.includes(other)).concat(run);
  }

  /**
   * Whether a way begins with another one.
   * @param {PlayedRun} run @param {PlayedRun} other
   */
  function begins(run, other) {
    const [a, b] = [run.way, other.way];
    if (a === null || b === null || a.base !== b.base || a.legs !== b.legs) return false;
    return b.choices.every((choice, i) => choice === a.choices[i]);
  }

  /**
   * Choices that lead on from a position of a run, always by what is possible first: until nothing is, a state comes
   * again, the file ends, or there are so many.
   * @param {PageData} data @param {PlayedRun} run @param {number} legs @param {number} count
   */
  function onwards(data, run, legs, count) {
    const met = [run.start, ...run.steps.slice(0, legs).map((step) => step.to)];
    const seen = new Set(met);
    /** @type {number[]} */
    const choices = [];
    let state = met[legs];
    while (choices.length < count) {
      const next = data.states[state].next || [];
      const choice = next.findIndex((one) => one.to !== null);
      const to = choice < 0 ? null : next[choice].to;
      if (to === null) break;
      choices.push(choice);
      state = to;
      if (seen.has(to)) break;
      seen.add(to);
    }
    return choices;
  }

  return { until, make, among, onwards };
})();
