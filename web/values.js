"use strict";

/**
 * The numbers of plots along a run: of each state, n(t)/d(t) while only time passes, t after it, perhaps in pieces.
 */
const Values = (() => {
  /**
   * @typedef {{n: number[], d: number[], flat: boolean}} Rounded a piece in floats; straight if it is linear
   * @typedef {{from: Rational, at: number, of: DataPiece}} Part what holds from a time since the state on
   */

  /** @type {WeakMap<DataPiece, Rounded | null>} */
  const rounded = new WeakMap();
  /** @type {WeakMap<DataPiece, Part[]>} */
  const divided = new WeakMap();

  /**
   * What a plot is after so many legs, and from which time before them on its time counts: for those of the file, from the
   * state that is reached by them.
   * @param {Player} player @param {number} legs @param {number} plot
   * @returns {{of: DataPiece | null, since: Rational, why: string}}
   */
  function piece(player, legs, plot) {
    const own = plot - player.data.plots.length;
    if (own >= 0) return Formulas.piece(own, legs);
    const state = legs === 0 ? player.run.start : player.course.legs[legs - 1].after;
    const values = player.data.states[state].values;
    return { of: (values && values[plot]) || null, since: player.instant(legs), why: Live.on ? "…" : "not in the file" };
  }

  /** @param {DataPiece} of @returns {Part[]} in the order of time */
  function parts(of) {
    let made = divided.get(of);
    if (!made) {
      made = (of.pieces || [{ ...of, from: "0/1" }]).map((part) => {
        const from = Rational.of(part.from);
        return { from, at: Rational.toNumber(from), of: part };
      });
      divided.set(of, made);
    }
    return made;
  }

  /** @param {string[]} coefficients @param {Rational} t */
  function exactly(coefficients, t) {
    let sum = Rational.zero;
    for (let i = coefficients.length - 1; i >= 0; i--)
      sum = Rational.add(Rational.mul(sum, t), Rational.of(coefficients[i]));
    return sum;
  }

  /**
   * The exact value after so many legs, at a time, or why there is none.
   * @param {Player} player @param {number} legs @param {number} plot @param {Rational} time
   * @returns {Rational | string}
   */
  function exact(player, legs, plot, time) {
    const own = plot - player.data.plots.length;
    if (own >= 0 && !Live.on) return Formulas.value(own, legs, time);
    const { of, since, why } = piece(player, legs, plot);
    if (!of) return why;
    const age = Rational.sub(time, since);
    // Of several that begin at one time, the first is what is so at that instant.
    const all = parts(of);
    const found = (all.find((part) => Rational.cmp(part.from, age) === 0) ||
      all.reduce((last, part) => (Rational.cmp(part.from, age) < 0 ? part : last))).of;
    if (found.n === undefined || found.d === undefined) return found.none || "none";
    const below = exactly(found.d, age);
    return Rational.sign(below) === 0 ? "not defined" : Rational.div(exactly(found.n, age), below);
  }

  /** @param {DataPiece} found @returns {Rounded | null} */
  function floats(found) {
    if (found.n === undefined || found.d === undefined) return null;
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
    const sampled = plot >= player.data.plots.length && !Live.on;
    let low = 0;
    for (let high = legs; low < high;) {
      const middle = (low + high) >> 1;
      if (instants[middle + 1] < from) low = middle + 1;
      else high = middle;
    }
    /** @param {Rounded} curve @param {number} a @param {number} b @param {number} zero */
    const draw = (curve, a, b, zero) => {
      const [first, last] = [Math.max(a, from), Math.min(b, to)];
      const count = curve.flat ? 1 : Math.max(1, Math.ceil(((last - first) / (to - from)) * width));
      add(first, at(curve, first - zero));
      if (last > first)
        for (let i = 1; i <= count; i++) {
          const time = i === count ? last : first + ((last - first) * i) / count;
          add(time, at(curve, time - zero));
        }
    };
    if (sampled) {
      let last = low;
      while (last < legs && instants[last + 1] <= to) last++;
      const slow = Formulas.wide(plot - player.data.plots.length) && player.course.leaves.length > many;
      // Of very many legs, some.
      const every = Math.max(1, Math.ceil((last - low + 1) / (slow ? fewer : most)));
      const all = samples(player, plot, { from, to, width, every, low, last });
      return slowly(plot, JSON.stringify([player.run.index, player.run.way, legs, from, to, width]), all, add, strokes, () => stroke);
    }
    for (let k = low; k <= legs && instants[k] <= to; k++) {
      const { of, since } = piece(player, k, plot);
      const [a, b] = [instants[k], instants[k + 1]];
      if (!of) {
        end();
        continue;
      }
      const zero = Rational.toNumber(since);
      const all = parts(of);
      all.forEach((part, i) => {
        const curve = floats(part.of);
        const begin = Math.max(a, zero + part.at);
        const over = i + 1 < all.length ? Math.min(b, zero + all[i + 1].at) : b;
        // Of what was over when the state was reached, nothing is left; what is so for an instant alone is a point.
        const passed = begin === over && b > a && i + 1 < all.length && part.at < all[i + 1].at;
        if (begin > over || begin > to || over < from || passed) return;
        if (curve) draw(curve, begin, over, zero);
        else end();
      });
    }
    end();
    return strokes;
  }

  /** So many legs are drawn of what is evaluated instant by instant; fewer of what is about all of more than so many bodies. */
  const most = 3000, fewer = 1000, many = 200;

  /**
   * Exact values at the beginning and the end of legs, and at each pixel between, in floats; one after the other, as each may
   * take a while.
   * @param {Player} player @param {number} plot
   * @param {{ from: number, to: number, width: number, every: number, low: number, last: number }} seen
   * @returns {Generator<[number, number]>} times with values
   */
  function* samples(player, plot, { from, to, width, every, low, last }) {
    for (let k = low; k <= last; k += every) {
      const [a, b] = [player.instants[k], player.instants[k + 1]];
      const one = (/** @type {number} */ at, /** @type {Rational} */ time) => {
        const value = exact(player, k, plot, time);
        return /** @type {[number, number]} */ ([at, typeof value === "string" ? NaN : Rational.toNumber(value)]);
      };
      const start = player.instant(k);
      yield one(a, start);
      if (b <= a || every > 1) continue;
      const [first, over] = [Math.max(a, from), Math.min(b, to)];
      const count = Math.ceil(((over - first) / (to - from)) * Math.min(width, 600));
      for (let i = 1; i < count; i++) {
        const at = first + ((over - first) * i) / count, time = Exactly.grid(at);
        if (Rational.cmp(time, start) > 0 && Rational.cmp(time, player.until(k)) < 0) yield one(at, time);
      }
      yield one(b, player.until(k));
    }
  }

  /** @typedef {{ key: string, strokes: () => [number, number][][], done: boolean }} Job  A drawing that is made piece by piece. */
  /** @type {Map<number, Job>} */
  const jobs = new Map();
  /** Milliseconds that a piece takes, and after which what there is so far is drawn. */
  const piecewise = 15, told = 500;
  /** @type {() => void} */
  let progress = () => {};

  /**
   * Calls a listener when more is known of what is evaluated piece by piece.
   * @param {() => void} listener
   */
  function onProgress(listener) {
    progress = listener;
  }

  /**
   * Takes what comes within the time of a piece. True when nothing is left.
   * @param {Generator<[number, number]>} all @param {(time: number, value: number) => void} add
   */
  function some(all, add) {
    const began = performance.now();
    do {
      const next = all.next();
      if (next.done) return true;
      add(...next.value);
    } while (performance.now() - began < piecewise);
    return false;
  }

  /**
   * What is known so far of a drawing. If it takes long, the page goes on meanwhile.
   * @param {number} plot @param {string} key what it is of @param {Generator<[number, number]>} all
   * @param {(time: number, value: number) => void} add @param {[number, number][][]} strokes
   * @param {() => [number, number][]} last what is not at its end
   */
  function slowly(plot, key, all, add, strokes, last) {
    const had = jobs.get(plot);
    if (had && had.key === key) return had.strokes();
    const job = { key, done: some(all, add), strokes: () => [...strokes, ...(last().length > 0 ? [last()] : [])] };
    jobs.set(plot, job);
    let drawn = performance.now();
    const on = () => {
      // Another part of time is drawn, or another run, or it was taken away.
      if (jobs.get(plot) !== job || !Formulas.there(plot)) return;
      job.done = some(all, add);
      if (job.done || performance.now() - drawn > told) {
        drawn = performance.now();
        progress();
      }
      if (!job.done) setTimeout(on);
    };
    if (!job.done) setTimeout(on);
    return job.strokes();
  }

  /** Whether drawings are being made piece by piece. */
  const busy = () => [...jobs].some(([plot, job]) => !job.done && Formulas.there(plot));

  /**
   * Whether a number changes in a run.
   * @param {Player} player @param {number} plot
   */
  function varies(player, plot) {
    let last = "";
    for (let i = 0; i <= Math.min(500, player.run.steps.length); i++) {
      const found = piece(player, i, plot).of;
      if (found && found.pieces) return true;
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
    const names = plots.map((plot) => Formulas.text(plot));
    const rows = [
      ["step", "time", "time (float)", "event", ...names.flatMap((name) => [name, `${name} (float)`])],
    ];
    const row = (/** @type {number} */ k, /** @type {Rational} */ time, /** @type {string} */ event) => {
      rows.push([
        String(k),
        Rational.text(time),
        String(Rational.toNumber(time)),
        event,
        ...plots.flatMap((plot) => {
          const value = exact(player, k, plot, time);
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

  return { exact, points, varies, csv, onProgress, busy };
})();
