"use strict";

/**
 * How a run goes on after the last step that the page has of it.
 *
 * @typedef {"rests" | "stops" | "repeats" | "open"} After  rests: time passes for ever, and nothing else happens; stops: no
 *   time passes; repeats: its last steps come again, for ever; open: that is not known.
 */
const Further = (() => {
  /** The greatest number of steps that a run has after its period was repeated. */
  const most = 2000;

  /** @param {PageData} data @param {PlayedRun} run @returns {After} */
  function after(data, run) {
    const states = [run.start, ...run.steps.map((step) => step.to)], last = states[states.length - 1];
    const finish = run.way ? "" : run.finish || "";
    if (data.states[last].stuck || finish === "stops" || finish === "stuck") return "stops";
    if (data.states[last].rests || finish === "rests" || finish === "quiescent") return "rests";
    if (finish === "repeats" && typeof run.cycle === "number" && states[run.cycle] === last) return "repeats";
    return "open";
  }

  /**
   * A run with its last steps again and again, if it repeats, until it takes more than some time.
   * @param {PageData} data @param {PlayedRun} run @param {Rational} time
   */
  function prolong(data, run, time) {
    const again = after(data, run) === "repeats" ? run.steps.slice(run.cycle || 0) : [];
    const length = (/** @type {DataStep[]} */ steps) => steps.reduce((sum, { label }) =>
      Rational.add(sum, Rational.of(data.labels[label].duration || "0/1")), Rational.zero);
    const period = length(again), steps = [...run.steps];
    if (Rational.sign(period) === 0) return run;
    for (let end = length(steps); Rational.cmp(end, time) <= 0 && steps.length + again.length <= most; end = Rational.add(end, period))
      steps.push(...again);
    return { ...run, steps, rest: "0/1" };
  }

  /**
   * Whether what moves at the end of a run goes straight on.
   * @param {Course} course
   */
  const straight = (course) =>
    course.bodiesAfter(course.legs.length, course.duration).every((body) => !body.process.turn);

  /**
   * What happens in a run that goes on by the same steps elsewhere, after what the page has of it: no states, as all that moves
   * is elsewhere each time. Up to a time, and one round more.
   * @param {PageData} data @param {PlayedRun} run @param {Course} course @param {Rational} time
   * @returns {{ events: { legs: number, label: string, time: Rational }[], until: Rational } | null}
   */
  function rounds(data, run, course, time) {
    if (run.way || run.finish !== "repeats" || typeof run.cycle !== "number" || after(data, run) !== "open") return null;
    const again = run.steps.slice(run.cycle).map(({ label }) => data.labels[label]);
    if (again.every(({ duration }) => !duration)) return null;
    const events = [];
    let now = course.duration, legs = run.steps.length;
    for (let over = false; !over && legs + again.length <= most;) {
      over = Rational.cmp(now, time) > 0;
      for (const label of again) {
        if (label.duration) now = Rational.add(now, Rational.of(label.duration));
        else events.push({ legs, label: label.words || label.text, time: now });
        legs++;
      }
    }
    return { events, until: now };
  }

  return { after, prolong, straight, rounds };
})();
