"use strict";

/**
 * The numbers that the checks name, along a run: of each state, n(t)/d(t) while only time passes, t after it.
 */
const Values = (() => {
  /** @typedef {{n: number[], d: number[], flat: boolean}} Rounded a piece in floats; straight if it is linear */

  /** @type {Map<DataPiece, Rounded | null>} */
  const rounded = new Map();

  /** @param {PageData} data @param {number} state @param {number} plot @returns {DataPiece | null} */
  function piece(data, state, plot) {
    const values = data.states[state].values;
    return (values && values[plot]) || null;
  }

  /** @param {string[]} coefficients @param {Rational} t */
  function exactly(coefficients, t) {
    let sum = Rational.zero;
    for (let i = coefficients.length - 1; i >= 0; i--)
      sum = Rational.add(Rational.mul(sum, t), Rational.of(coefficients[i]));
    return sum;
  }

  /**
   * The exact value so long after a state, or why there is none.
   * @param {PageData} data @param {number} state @param {number} plot @param {Rational} age
   * @returns {Rational | string}
   */
  function exact(data, state, plot, age) {
    const found = piece(data, state, plot);
    if (!found) return "not in the file";
    if (found.n === undefined || found.d === undefined) return found.none || "none";
    const below = exactly(found.d, age);
    return Rational.sign(below) === 0 ? "not defined" : Rational.div(exactly(found.n, age), below);
  }

  /** @param {PageData} data @param {number} state @param {number} plot @returns {Rounded | null} */
  function floats(data, state, plot) {
    const found = piece(data, state, plot);
    if (!found || found.n === undefined || found.d === undefined) return null;
    let made = rounded.get(found);
    if (made === undefined) {
      const number = (/** @type {string} */ s) => Rational.toNumber(Rational.of(s));
      made = {
        n: found.n.map(number),
        d: found.d.map(number),
        flat: found.n.length <= 2 && found.d.length <= 1,
      };
      rounded.set(found, made);
    }
    return made;
  }

  /** @param {number[]} coefficients @param {number} t */
  function horner(coefficients, t) {
    let sum = 0;
    for (let i = coefficients.length - 1; i >= 0; i--) sum = sum * t + coefficients[i];
    return sum;
  }

  /** @param {Rounded} of @param {number} t */
  function at(of, t) {
    return horner(of.n, t) / horner(of.d, t);
  }

  /**
   * Points of a plot within a part of time: runs of points that hang together, [time, value] each.
   * @param {Player} player
   * @param {number} plot
   * @param {number} from
   * @param {number} to
   * @param {number} width pixels
   * @returns {[number, number][][]}
   */
  function points(player, plot, from, to, width) {
    /** @type {[number, number][][]} */
    const strokes = [];
    /** @type {[number, number][]} */
    let stroke = [];
    const end = () => {
      if (stroke.length > 0) strokes.push(stroke);
      stroke = [];
    };
    const add = (/** @type {number} */ time, /** @type {number} */ value) => {
      if (!Number.isFinite(value)) {
        end();
        return;
      }
      const last = stroke[stroke.length - 1];
      if (last && last[0] === time && Math.abs(last[1] - value) > 1e-9 * Math.max(1, Math.abs(value))) end();
      if (last && stroke.length > 0 && last[0] === time) return;
      stroke.push([time, value]);
    };
    const legs = player.course.legs.length;
    const instants = player.instants;
    let low = 0;
    for (let high = legs; low < high;) {
      const middle = (low + high) >> 1;
      if (instants[middle + 1] < from) low = middle + 1;
      else high = middle;
    }
    for (let k = low; k <= legs && instants[k] <= to; k++) {
      const state = k === 0 ? player.run.start : player.course.legs[k - 1].after;
      const curve = floats(player.data, state, plot);
      const [a, b] = [instants[k], instants[k + 1]];
      if (!curve) {
        end();
        continue;
      }
      const [first, last] = [Math.max(a, from), Math.min(b, to)];
      const count = curve.flat ? 1 : Math.max(1, Math.ceil(((last - first) / (to - from)) * width));
      add(first, at(curve, first - a));
      if (last > first)
        for (let i = 1; i <= count; i++) {
          const time = i === count ? last : first + ((last - first) * i) / count;
          add(time, at(curve, time - a));
        }
    }
    end();
    return strokes;
  }

  /**
   * Whether a number changes in a run.
   * @param {Player} player @param {number} plot
   */
  function varies(player, plot) {
    let last = "";
    const states = [player.run.start, ...player.run.steps.slice(0, 500).map((step) => step.to)];
    for (const [i, state] of states.entries()) {
      const found = piece(player.data, state, plot);
      if (!found || found.n === undefined || found.d === undefined) continue;
      if (found.n.length > 1 || found.d.length > 1) return true;
      const now = `${found.n[0] || "0/1"} ${found.d[0]}`;
      if (i > 0 && last !== "" && now !== last) return true;
      last = now;
    }
    return false;
  }

  /**
   * A table of plots: a row for each position of the run, and one for its end; of each number its exact text,
   * and the
   * nearest float.
   * @param {Player} player @param {number[]} plots
   */
  function csv(player, plots) {
    const quote = (/** @type {string} */ s) => (/[",\r\n]/.test(s) ? `"${s.replace(/"/g, '""')}"` : s);
    const names = plots.map((plot) => player.data.plots[plot].text);
    const rows = [
      ["step", "time", "time (float)", "event", ...names.flatMap((name) => [name, `${name} (float)`])],
    ];
    const row = (/** @type {number} */ k, /** @type {Rational} */ time, /** @type {string} */ event) => {
      const state = k === 0 ? player.run.start : player.course.legs[k - 1].after;
      const age = Rational.sub(time, player.instant(k));
      rows.push([
        String(k),
        Rational.text(time),
        String(Rational.toNumber(time)),
        event,
        ...plots.flatMap((plot) => {
          const value = exact(player.data, state, plot, age);
          return typeof value === "string"
            ? ["", ""]
            : [Rational.text(value), String(Rational.toNumber(value))];
        }),
      ]);
    };
    const legs = player.course.legs.length;
    for (let k = 0; k <= legs; k++) {
      row(k, player.instant(k), k === 0 ? "" : player.data.labels[player.run.steps[k - 1].label].text);
    }
    if (Rational.cmp(player.course.duration, player.instant(legs)) > 0)
      row(legs, player.course.duration, "end");
    return rows.map((cells) => cells.map(quote).join(",")).join("\r\n") + "\r\n";
  }

  return { exact, points, varies, csv };
})();
