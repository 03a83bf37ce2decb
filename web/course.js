"use strict";

/**
 * @typedef {{ index: number, label: DataLabel, start: Rational, duration: Rational, before: number, after: number,
 *   choice: number | null, rules: string[], tail: boolean }} Leg  A transition; its time counts from the start.
 * @typedef {{ index: number, since: Rational, from: number, to: number, body?: Moving }} Segment  A process of the
 *   states that come after so many legs, from..to - 1; its body, once it was asked for.
 */

/**
 * A run: its transitions, and where everything is at any time.
 */
class Course {
  /** @param {PageData} data @param {{ start: number, steps: DataStep[], rest: string, leaves?: DataLeaf[] }} run */
  constructor(data, run) {
    this.data = data;
    /** How bodies are put together. */
    this.leaves = run.leaves || data.leaves;
    this.start = run.start;
    /** @type {Leg[]} */
    this.legs = [];
    let now = Rational.zero, before = run.start;
    for (const [index, step] of run.steps.entries()) {
      const label = data.labels[step.label];
      const duration = label.duration ? Rational.of(label.duration) : Rational.zero;
      this.legs.push({
        index, label, start: now, duration, before, after: step.to,
        choice: step.choice, rules: step.rules, tail: step.tail === true,
      });
      if (label.duration) now = Rational.add(now, duration);
      before = step.to;
    }
    /** When the last leg is over. */
    this.over = now;
    this.duration = Rational.add(now, Rational.of(run.rest));
    /** @type {Map<number, Segment[]>} by first leaf */
    this.slots = new Map();
    this.#lay(run.start);
    /** @type {{ legs: number, bodies: Moving[] } | null} */
    this.latest = null;
    /** @type {Map<number, Segment[]> | null} */
    this.byLeaf = null;
  }

  /**
   * What comes and goes, leg by leg.
   * @param {number} start
   */
  #lay(start) {
    for (const [index] of Course.whole(this.data, start)) this.#enter(index, Rational.zero, 0);
    for (const leg of this.legs) {
      const k = leg.index + 1;
      const state = this.data.states[leg.after];
      const now = leg.label.duration ? Rational.add(leg.start, leg.duration) : leg.start;
      if (state.of === leg.before && Rational.cmp(Rational.of(state.after), leg.duration) === 0) {
        for (const first of state.gone) this.#leave(first, k);
        for (const index of state.come) this.#enter(index, now, k);
      } else this.#become(leg.after, now, k);
    }
    for (const segments of this.slots.values())
      for (const s of segments) if (s.to < 0) s.to = this.legs.length + 1;
  }

  /**
   * A state that is told by another one than that before: only what differs is new.
   * @param {number} state @param {Rational} now @param {number} k
   */
  #become(state, now, k) {
    const whole = new Map(Course.whole(this.data, state).map(([index, age]) => [this.#first(index), { index, age }]));
    for (const [first, segments] of this.slots) {
      const s = segments[segments.length - 1];
      if (s.to >= 0) continue;
      const next = whole.get(first);
      if (next && next.index === s.index && Rational.cmp(Rational.sub(now, next.age), s.since) === 0) whole.delete(first);
      else this.#leave(first, k);
    }
    for (const { index, age } of whole.values()) this.#enter(index, Rational.sub(now, age), k);
  }

  /** @param {number} index of a process */
  #first(index) { return this.data.processes[index].leaves[0].leaf; }

  /** @param {number} index @param {Rational} since @param {number} k */
  #enter(index, since, k) {
    const first = this.#first(index);
    const segments = this.slots.get(first);
    const segment = { index, since, from: k, to: -1 };
    if (segments) segments.push(segment); else this.slots.set(first, [segment]);
  }

  /** @param {number} first @param {number} k */
  #leave(first, k) {
    const segments = this.slots.get(first);
    if (segments) segments[segments.length - 1].to = k;
  }

  /** @type {WeakMap<PageData, Map<number, [number, Rational][]>>} */
  static #wholes = new WeakMap();

  /**
   * The processes of a state, each with how long ago it came.
   * @param {PageData} data @param {number} state @returns {[number, Rational][]}
   */
  static whole(data, state) {
    let known = Course.#wholes.get(data);
    if (!known) Course.#wholes.set(data, (known = new Map()));
    const chain = [];
    /** @type {number | null} */
    let at = state;
    while (at !== null && !known.has(at)) { chain.push(at); at = data.states[at].of; }
    let bodies = new Map((at === null ? [] : known.get(at) || []).map((b) => [data.processes[b[0]].leaves[0].leaf, b]));
    for (const k of chain.reverse()) {
      const { after, gone, come } = data.states[k];
      const later = Rational.of(after);
      for (const first of gone) bodies.delete(first);
      if (Rational.sign(later) !== 0)
        for (const [first, [index, age]] of bodies) bodies.set(first, [index, Rational.add(age, later)]);
      for (const index of come) bodies.set(data.processes[index].leaves[0].leaf, [index, Rational.zero]);
    }
    const all = [...bodies.values()];
    if (known.size * all.length < 500000) known.set(state, all);
    return all;
  }

  /**
   * How many legs are over at a time.
   * @param {Rational} time
   */
  legsAt(time) {
    let low = 0, high = this.legs.length;
    while (low < high) {
      const middle = (low + high) >> 1, leg = this.legs[middle];
      if (Rational.cmp(Rational.add(leg.start, leg.duration), time) <= 0) low = middle + 1; else high = middle;
    }
    return low;
  }

  /**
   * Of several states of one instant, the last.
   * @param {Rational} time
   */
  bodiesAt(time) { return this.bodiesAfter(this.legsAt(time), time); }

  /**
   * When so many legs are over, at a time before the next one is.
   * @param {number} k @param {Rational} time
   */
  bodiesAfter(k, time) {
    if (!this.latest || this.latest.legs !== k) this.latest = { legs: k, bodies: this.#present(k) };
    const high = Twofold.of(time.n, time.d), low = Twofold.low[0];
    for (const body of this.latest.bodies) body.at(time, high, low);
    return this.latest.bodies;
  }

  /**
   * The bodies that some leaves are in, as `bodiesAfter` has them: of large networks, without the others.
   * @param {Iterable<number>} leaves @param {number} k @param {Rational} time
   */
  some(leaves, k, time) {
    const all = this.#segments();
    /** @type {Set<Moving>} */
    const found = new Set();
    for (const leaf of leaves) {
      const own = all.get(leaf) || [], s = own[Course.#upTo(own, k) - 1];
      if (!s || k >= s.to) continue;
      if (!s.body) s.body = new Moving(this.data.processes[s.index], s.index, s.since);
      s.body.at(time);
      found.add(s.body);
    }
    return [...found];
  }

  /** The segments of each leaf, in their order. */
  #segments() {
    if (this.byLeaf) return this.byLeaf;
    /** @type {Map<number, Segment[]>} */
    const all = new Map();
    for (const segments of this.slots.values())
      for (const s of segments)
        for (const { leaf } of this.data.processes[s.index].leaves) {
          const own = all.get(leaf);
          if (own) own.push(s);
          else all.set(leaf, [s]);
        }
    // Of those that begin together, what lasts comes last.
    for (const own of all.values()) own.sort((a, b) => a.from - b.from || a.to - b.to);
    return (this.byLeaf = all);
  }

  /**
   * Where a leaf was last, if it was there and is gone when so many legs are over; and how many were over when it went.
   * @param {number} leaf @param {number} k
   * @returns {{ body: Moving, place: DataPlace, legs: number } | null}
   */
  last(leaf, k) {
    const own = this.#segments().get(leaf) || [], s = own[Course.#upTo(own, k) - 1];
    if (!s || k < s.to) return null;
    const process = this.data.processes[s.index], body = new Moving(process, s.index, s.since);
    body.at(this.arrival(s.to));
    return { body, place: /** @type {DataPlace} */ (process.leaves.find((place) => place.leaf === leaf)), legs: s.to };
  }

  /**
   * The leaves that are gone when so many legs are over.
   * @param {number} k
   */
  gone(k) { return [...this.#segments().keys()].filter((leaf) => this.last(leaf, k) !== null).sort((a, b) => a - b); }

  /**
   * How many of the segments begin when k legs are over, or before.
   * @param {Segment[]} segments @param {number} k
   */
  static #upTo(segments, k) {
    let low = 0, high = segments.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (segments[middle].from <= k) low = middle + 1; else high = middle;
    }
    return low;
  }

  /** @param {number} k @returns {Moving[]} */
  #present(k) {
    const bodies = [];
    for (const segments of this.slots.values()) {
      const s = segments[Course.#upTo(segments, k) - 1];
      if (!s || k >= s.to) continue;
      if (!s.body) s.body = new Moving(this.data.processes[s.index], s.index, s.since);
      bodies.push(s.body);
    }
    return bodies.sort((a, b) => a.process.leaves[0].leaf - b.process.leaves[0].leaf);
  }

  /**
   * The processes that a leg ends, and those that it begins.
   * @param {number} k the number of the leg, from 1 on
   */
  changed(k) {
    /** @type {{ ended: DataProcess[], begun: DataProcess[] }} */
    const found = { ended: [], begun: [] };
    const process = (/** @type {Segment} */ s) => this.data.processes[s.index];
    for (const segments of this.slots.values()) {
      const at = Course.#upTo(segments, k), last = segments[at - 1];
      if (last && last.from === k) found.begun.push(process(last));
      const old = last && last.from === k ? segments[at - 2] : last;
      if (old && old.to === k) found.ended.push(process(old));
    }
    return found;
  }

  /**
   * Kept with the place, as it is asked for in each frame.
   * @param {Moving} body @param {DataPlace} place one of the leaves of its process
   * @returns {ReturnType<typeof Motion.straight> | ReturnType<typeof Motion.turning>}
   */
  static motion(body, place) {
    const kept = /** @type {DataPlace & { motion?: ReturnType<typeof Course.motion> }} */ (place);
    if (!kept.motion)
      kept.motion = body.process.turn ? Motion.turning(body.process, place) : Motion.straight(body.process, place);
    return kept.motion;
  }

  /**
   * Where the point of reference of a leaf is.
   * @param {Moving} body @param {DataPlace} place @returns {[Rational, Rational, Rational]}
   */
  position(body, place) {
    const p = Motion.position(Course.motion(body, place), body.age);
    return /** @type {[Rational, Rational, Rational]} */ (p.n.map((n) => Rational.make(n, p.d)));
  }

  /**
   * How a leaf is turned: a matrix by rows.
   * @param {Moving} body @param {DataPlace} place @returns {Rational[]}
   */
  orientation(body, place) {
    const o = Motion.orientation(Course.motion(body, place), body.age);
    return o.n.map((n) => Rational.make(n, o.d));
  }

  /**
   * The same as floats, each the nearest to the exact number: the position relative to the target in out[0..2], the rows
   * of the rotation in out[3..11].
   * @param {Moving} body @param {DataPlace} place @param {Target} target {@link Motion.target}
   * @param {Float64Array | number[]} out
   */
  place(body, place, target, out) {
    Motion.place(Course.motion(body, place), body, target, out);
  }

  /**
   * When so many legs were over.
   * @param {number} k
   */
  arrival(k) { return k < this.legs.length ? this.legs[k].start : this.over; }
}

/** A process of a state, on its way since an instant: its age is made when it is asked for. */
class Moving {
  /** @param {DataProcess} process @param {number} index @param {Rational} since */
  constructor(process, index, since) {
    this.process = process;
    this.index = index;
    this.since = since;
    this.sinceHigh = Twofold.of(since.n, since.d);
    this.sinceLow = Twofold.low[0];
    this.time = since;
    this.timeHigh = this.sinceHigh;
    this.timeLow = this.sinceLow;
  }

  /**
   * At another time, which may be told as a twofold float as well.
   * @param {Rational} time @param {number} [high] @param {number} [low]
   */
  at(time, high = Twofold.of(time.n, time.d), low = Twofold.low[0]) {
    this.time = time;
    this.timeHigh = high;
    this.timeLow = low;
  }

  get age() { return Rational.sub(this.time, this.since); }

  /** The age without the work of lowest terms. */
  gone() {
    const { time, since } = this;
    return time.d === since.d ? { n: time.n - since.n, d: time.d }
      : { n: time.n * since.d - since.n * time.d, d: time.d * since.d };
  }
}
