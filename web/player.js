"use strict";

/**
 * Where one is: the run that is shown, how many of its legs are taken, and the exact time; and the clock that
 * plays it.
 *
 * A run is cut into legs, one for each transition: passings of time, and events, which take none. So several
 * states may
 * be of one instant, and `legs` tells them apart. After the last leg, time passes on until the end of the run.
 */
class Player {
  /** @param {PageData} data */
  constructor(data) {
    this.data = data;
    /** @type {PlayedRun[]} the runs that there are, those of the file first */
    this.runs = Player.playable(data);
    /** @type {PlayedRun[]} of checks that no single run shows: the beginning */
    this.bare = Player.beginnings(data);
    /** @type {{[what: string]: ((player: Player) => void)[]}} */
    this.listeners = {};
    this.still = window.matchMedia("(prefers-reduced-motion: reduce)");
    this.playing = false;
    this.speed = 1;
    /** @type {PlayedRun} */
    this.run = this.runs.find((run) => run.check && run.check.verdict === "violated") || this.runs[0];
    this.course = new Course(data, this.run);
    this.legs = 0;
    /** @type {Rational} */
    this.time = Rational.zero;
    /** The instants of the legs, as floats; the last one is the end. */
    this.instants = new Float64Array(0);
    /** The instant that the last leg leads to. @type {Rational} */
    this.arrival = Rational.zero;
    this.end = 0;
    /** For how many seconds an event is shown while playing, and how much of time a second shows. */
    this.dwell = 0;
    this.rate = 1;
    /** Seconds since the event came into view that is shown for a moment while playing. */
    this.held = 0;
    this.frame = 0;
    this.last = 0;
    this.clock = 0;
    /** How often one has gone elsewhere. */
    this.moves = 0;
    this.measure();
    this.decide();
  }

  /**
   * The runs of the file that have states to show.
   * @param {PageData} data @returns {PlayedRun[]}
   */
  static playable(data) {
    /** @type {PlayedRun[]} */
    const runs = [];
    data.runs.forEach((run, index) => {
      if (run.start === null) return;
      runs.push({
        ...run,
        start: run.start,
        steps: run.steps || [],
        rest: run.rest || "0/1",
        index,
        way: null,
      });
    });
    const none = { name: "the beginning", check: null, start: 0, steps: [], rest: "0/1", index: -1, way: null };
    return runs.length === 0 ? [none] : runs;
  }

  /** How runs end that decide a check. */
  static decisive = ["state", "instant", "rests", "stops", "repeats", "passes", "goes_on"];

  /** @param {PageData} data @returns {PlayedRun[]} */
  static beginnings(data) {
    const first = data.runs.find((run) => run.start !== null && run.check === null && !run.sample && run.contrast === undefined);
    const start = first && first.start ? first.start : 0;
    return data.runs.flatMap((run, index) =>
      run.start === null ? [{ ...run, start, steps: [], rest: "0/1", index, way: null, bare: true }] : []);
  }

  /**
   * Calls a listener when something is so: "run", another run is shown; "move", another instant or state;
   * "play",
   * playing or speed are other ones; "grow", more is known of the document.
   * @param {string} what @param {(player: Player) => void} listener
   */
  on(what, listener) {
    (this.listeners[what] = this.listeners[what] || []).push(listener);
  }

  /** @param {string} what */
  tell(what) {
    for (const listener of this.listeners[what] || []) listener(this);
  }

  measure() {
    const { legs, duration } = this.course;
    this.instants = new Float64Array(legs.length + 2);
    for (let i = 0; i < legs.length; i++) this.instants[i] = Rational.toNumber(legs[i].start);
    this.arrival =
      legs.length === 0
        ? Rational.zero
        : Rational.add(legs[legs.length - 1].start, legs[legs.length - 1].duration);
    this.instants[legs.length] = Rational.toNumber(this.arrival);
    this.end = Rational.toNumber(duration);
    this.instants[legs.length + 1] = this.end;
    const events = legs.filter((leg) => Rational.sign(leg.duration) === 0).length;
    this.dwell = events === 0 ? 0 : Math.min(0.5, 8 / events);
    this.rate = Player.round(this.end / 12);
  }

  /**
   * The nearest of 1, 2 and 5 times a power of ten.
   * @param {number} x
   */
  static round(x) {
    if (!(x > 0)) return 1;
    const power = 10 ** Math.floor(Math.log10(x));
    const lead = x / power;
    return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
  }

  /**
   * Another run of the same document, without a clock of its own.
   * @param {Player} player @param {PlayedRun} run @param {Course} [course] @returns {Player}
   */
  static beside(player, run, course = new Course(player.data, run)) {
    const { data } = player;
    const made = /** @type {Player} */ (Object.create(Player.prototype));
    Object.assign(made, {
      data, run, course, runs: player.runs, bare: player.bare, listeners: {}, playing: false, speed: 1,
      legs: 0, time: Rational.zero, clock: 0, held: 0, moves: 0,
    });
    made.measure();
    return made;
  }

  /**
   * Goes to the time of another player: of several states of an instant, to the one after as many legs, if there is one.
   * @param {Player} player
   */
  beside({ legs, time }) {
    if (Rational.cmp(time, this.course.duration) > 0) time = this.course.duration;
    let high = this.after(time), low = high;
    if (Rational.cmp(this.instant(high), time) === 0)
      while (low > 0 && Rational.cmp(this.instant(low - 1), time) === 0) low--;
    this.place(Math.max(low, Math.min(high, legs)), time);
  }

  /** The state that the legs taken lead to. */
  get state() {
    return this.legs === 0 ? this.run.start : this.course.legs[this.legs - 1].after;
  }

  /**
   * The instant of that state.
   * @param {number} legs @returns {Rational}
   */
  instant(legs) {
    return legs < this.course.legs.length ? this.course.legs[legs].start : this.arrival;
  }

  /**
   * The latest instant that is shown with so many legs taken.
   * @param {number} legs @returns {Rational}
   */
  until(legs) {
    return legs < this.course.legs.length ? this.instant(legs + 1) : this.course.duration;
  }

  /** Whether time has passed since the last leg that is taken. */
  get between() {
    return Rational.cmp(this.time, this.instant(this.legs)) > 0;
  }

  /**
   * Goes where the run of a check that is violated leads: to the instant that decides, and not where time passes on
   * after it.
   */
  decide() {
    const { check } = this.run;
    if (check && check.verdict === "violated") this.conclude();
  }

  /** Goes where the run of a check leads: to the instant that decides, if it ends so. */
  conclude() {
    const decides = this.deciding();
    if (decides) this.place(decides.legs, decides.time);
    return decides !== null;
  }

  /** Where the run of a check leads: the instant that decides, or null if it does not end so. */
  deciding() {
    const { steps, finish } = this.run;
    if (!Player.decisive.includes(finish || "")) return null;
    const tail = steps.findIndex((step) => step.tail);
    const legs = tail < 0 ? steps.length : tail;
    return { legs, time: finish === "rests" ? this.instant(legs) : this.until(legs) };
  }

  /**
   * Shows another run, or the same one from its beginning.
   * @param {PlayedRun} run @param {number} [legs] @param {Rational} [time]
   */
  open(run, legs, time) {
    this.pause();
    this.run = run;
    this.course = new Course(this.data, run);
    this.measure();
    this.legs = 0;
    this.time = Rational.zero;
    this.place(legs || 0, time);
    if (legs === undefined) this.decide();
    this.tell("run");
    this.tell("move");
  }

  /** @param {number} legs @param {Rational} [time] */
  place(legs, time) {
    this.moves += 1;
    const k = Math.max(0, Math.min(this.course.legs.length, Math.floor(legs) || 0));
    const from = this.instant(k);
    const to = this.until(k);
    this.legs = k;
    this.time = !time || Rational.cmp(time, from) < 0 ? from : Rational.cmp(time, to) > 0 ? to : time;
    // The end of a passing of time is the state that it leads to.
    if (k < this.course.legs.length && Rational.cmp(this.time, to) === 0 && Rational.cmp(from, to) < 0)
      this.legs = k + 1;
    this.clock = Rational.toNumber(this.time);
    this.held = 0;
  }

  /**
   * Goes where so many legs are taken, at a time from then on.
   * @param {number} legs @param {Rational} [time]
   */
  go(legs, time) {
    this.place(legs, time);
    this.tell("move");
  }

  /**
   * Goes to a time: the last state of its instant.
   * @param {Rational} time
   */
  seek(time) {
    if (Rational.cmp(time, this.course.duration) > 0) time = this.course.duration;
    if (Rational.sign(time) < 0) time = Rational.zero;
    this.go(this.after(time), time);
  }

  /**
   * How many legs lead to the last state of a time.
   * @param {Rational} time
   */
  after(time) {
    let low = 0;
    let high = this.course.legs.length;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (Rational.cmp(this.instant(middle), time) <= 0) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Whether a stop comes after this one. */
  get ended() {
    return this.legs === this.course.legs.length && Rational.cmp(this.time, this.course.duration) >= 0;
  }

  next() {
    this.pause();
    if (this.legs < this.course.legs.length) this.go(this.legs + 1);
    else this.go(this.legs, this.course.duration);
  }

  previous() {
    this.pause();
    this.go(this.between ? this.legs : this.legs - 1);
  }

  first() {
    this.pause();
    this.go(0);
  }

  finish() {
    this.pause();
    this.go(this.course.legs.length, this.course.duration);
  }

  /**
   * Goes somewhere when an answer has come, unless one has gone elsewhere meanwhile.
   * @param {Promise<any>} answer @param {() => boolean} there @returns {Promise<boolean | null>} null: one has
   */
  async later(answer, there) {
    this.pause();
    const { moves } = this;
    await answer.catch(() => null);
    return moves === this.moves ? there() : null;
  }

  /**
   * Takes a transition of the state that is shown, the one taken already or another: a run of its own.
   * @param {number} choice
   * @returns {boolean | Promise<boolean | null>} whether the state that it leads to is known; a served page may have to ask
   */
  choose(choice) {
    const next = this.data.states[this.state].next, taken = next && next[choice];
    if (!Live.on || (next && !taken) || (taken && taken.to !== null)) return this.take(choice);
    return this.later(Grow.walk(this.state, [choice]), () => this.take(choice));
  }

  /** @param {number} choice */
  take(choice) {
    const possible = this.data.states[this.state].next;
    const taken = possible && possible[choice];
    if (!taken || taken.to === null) return false;
    const leg = this.course.legs[this.legs];
    this.pause();
    if (leg && leg.choice === choice && leg.after === taken.to) {
      this.go(this.legs + 1);
      return true;
    }
    const { base, legs, choices } = Ways.until(this.run, this.legs);
    return this.follow(base, legs, choices.concat(choice));
  }

  /**
   * Shows the run that goes so many legs of a run of the file, and then by choices; and its end.
   * @param {number} base @param {number} legs @param {number[]} choices
   * @returns {boolean | Promise<boolean | null>} whether there is one; a served page may have to ask
   */
  walk(base, legs, choices) {
    const from = this.base(base);
    if (this.follow(base, legs, choices)) return true;
    if (!Live.on || !from || !(legs >= 0 && legs <= from.steps.length)) return false;
    const state = legs === 0 ? from.start : from.steps[legs - 1].to;
    return this.later(Grow.walk(state, choices), () => this.follow(base, legs, choices));
  }

  /** @param {number} index of a run of the file */
  base(index) {
    return this.runs.concat(this.bare).find((run) => run.way === null && run.index === index);
  }

  /** @param {number} base @param {number} legs @param {number[]} choices */
  follow(base, legs, choices) {
    const from = this.base(base);
    const run = from ? Ways.make(this.data, from, legs, choices) : null;
    if (!run) return false;
    this.runs = Ways.among(this.runs, run);
    this.open(run, run.steps.length);
    return true;
  }

  /**
   * Goes on from the state that is shown, always by what is possible first.
   * @param {number} most steps
   * @returns {boolean | Promise<boolean | null>} whether there was a step to take; a served page has to ask
   */
  goOn(most) {
    if (!Live.on) return this.onwards(most);
    return this.later(Grow.onwards(this.state, most), () => this.onwards(most));
  }

  /** @param {number} most */
  onwards(most) {
    const { base, legs, choices } = Ways.until(this.run, this.legs);
    const more = Ways.onwards(this.data, this.run, this.legs, most);
    const before = this.legs;
    if (more.length === 0 || !this.follow(base, legs, choices.concat(more))) return false;
    this.go(before);
    return true;
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.ended) this.go(0);
    if (this.ended || this.playing) return;
    this.moves += 1;
    this.playing = true;
    this.last = 0;
    this.held = 0;
    this.frame = requestAnimationFrame((now) => this.tick(now));
    this.tell("play");
  }

  pause() {
    if (!this.playing) return;
    cancelAnimationFrame(this.frame);
    this.playing = false;
    this.tell("play");
    this.tell("move");
  }

  /** @param {number} speed */
  hasten(speed) {
    this.speed = Math.max(1 / 64, Math.min(64, speed));
    this.tell("play");
  }

  /** @param {number} now */
  tick(now) {
    if (!this.playing) return;
    const passed = this.last === 0 ? 0 : Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    if (passed > 0) {
      if (this.still.matches) this.hop(passed * this.speed);
      else this.advance(passed * this.speed);
      this.tell("move");
    }
    if (this.ended) this.pause();
    else this.frame = requestAnimationFrame((later) => this.tick(later));
  }

  /**
   * Where motion is not wanted, playing goes from event to event.
   * @param {number} passed seconds
   */
  hop(passed) {
    this.held += passed;
    if (this.held < 1.5) return;
    if (this.legs < this.course.legs.length) this.place(this.legs + 1);
    else this.place(this.legs, this.course.duration);
  }

  /** @param {number} budget seconds */
  advance(budget) {
    const legs = this.course.legs;
    while (budget > 0 && !this.ended) {
      const k = this.legs;
      if (k < legs.length && Rational.sign(legs[k].duration) === 0) {
        const left = this.dwell - this.held;
        if (left > budget) {
          this.held += budget;
          return;
        }
        budget -= Math.max(0, left);
        this.legs = k + 1;
        this.held = 0;
      } else {
        const end = this.instants[k + 1];
        const need = (end - this.clock) / this.rate;
        if (need <= budget) {
          budget -= Math.max(0, need);
          const instant = this.until(k);
          this.legs = Math.min(k + 1, legs.length);
          this.time = instant;
          this.clock = end;
          this.held = 0;
        } else {
          this.clock += budget * this.rate;
          budget = 0;
          const near = Exactly.grid(this.clock);
          if (Rational.cmp(near, this.instant(k)) > 0 && Rational.cmp(near, this.until(k)) < 0)
            this.time = near;
        }
      }
    }
  }
}
