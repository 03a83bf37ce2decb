"use strict";

/**
 * A second run beside the one that is shown: its bodies are outlines in the same scene, at the same time. Says where both
 * part, and what differs now.
 *
 * @typedef {{ legs: number, label: string, time: Rational }} Happening  An event: its leg, from 0 on, and when it is.
 * @typedef {{ same: number, here: Happening | null, there: Happening | null, start: boolean, until: Rational | null }} Parting
 *   same: how many events are the same at first; here, there: the next one of each run, if they part; start: whether the runs
 *   begin in different states; until: if they do not part, how far both are known, null for ever.
 *
 * @typedef {{ after: After, straight: boolean }} End  How a run goes on; straight: whether bodies then go straight on.
 */
const Compare = (() => {
  /** So many differences are told. */
  const told = 8;
  /** @type {Player} */
  let player;
  /** @type {Scene | null} */
  let scene;
  /**
   * Where the other run is.
   * @type {Player | null}
   */
  let second = null;
  /** @type {Parting} */
  let parting = { same: 0, here: null, there: null, start: false, until: null };
  /**
   * How the other run goes on after what is told of it.
   * @type {End}
   */
  let end = { after: "open", straight: false };
  /**
   * Where the other run was left by a switch, and how often one had moved then.
   * @type {{ run: PlayedRun, legs: number, time: Rational, moves: number } | null}
   */
  let left = null;
  /**
   * The run that was shown last.
   * @type {PlayedRun}
   */
  let former;
  /** @type {HTMLSelectElement} */
  let menu;
  /** @type {HTMLElement} */
  let now;
  /**
   * Those that can be chosen.
   * @type {PlayedRun[]}
   */
  let runs = [];

  /** @param {Player} of @param {Scene | null} shown */
  function start(of, shown) {
    player = of;
    scene = shown;
    former = player.run;
    menu = Dom.make("select", {
      id: "compare-with", test: "compare-with", "aria-label": "Compare with another run",
      title: "Compare with another run (k)", change: () => choose(runs[menu.selectedIndex - 1] || null),
    });
    Dom.get("runs-head").after(menu);
    now = Dom.make("span", { test: "compare-now" });
    player.on("run", opened);
    player.on("grow", list);
    player.on("move", move);
    list();
  }

  /** The run that is compared with, and where it is now. */
  const other = () => second;

  function opened() {
    if (second && second.run === player.run) begin(former === player.run ? null : former);
    else if (second) begin(second.run);
    former = player.run;
    list();
  }

  /** The nearest run that does otherwise, or that of which this one does otherwise; or the next one. */
  function natural() {
    const { index, way, contrast } = player.run;
    const beside = way ? player.base(index) : contrast !== undefined ? player.base(index - 1) : player.base(index + 1);
    return (way || contrast !== undefined || (beside && beside.contrast !== undefined)) && beside && !beside.bare ? beside : null;
  }

  function list() {
    const first = natural();
    runs = player.runs.filter((run) => run !== player.run && run !== first).slice(0, 500);
    if (first) runs.unshift(first);
    menu.hidden = runs.length === 0;
    const name = (/** @type {PlayedRun} */ run) => Dom.make("option", { text: Dom.clip(run.name, 60) });
    Dom.fill(menu, Dom.make("option", { text: second ? "Compare with none" : "Compare with …" }), ...runs.map(name));
    menu.selectedIndex = second ? runs.indexOf(second.run) + 1 : 0;
  }

  /** @param {PlayedRun | null} run */
  function begin(run) {
    second = null;
    if (run) {
      const { data } = player, one = Player.beside(player, player.run), two = Player.beside(player, run);
      const longer = Rational.cmp(one.course.duration, two.course.duration) > 0 ? one : two;
      const known = (/** @type {Player} */ of) => {
        const whole = Further.prolong(data, of.run, longer.course.duration);
        return whole === of.run ? of : Player.beside(player, of.run, new Course(data, whole));
      };
      second = known(two);
      end = { after: Further.after(data, run), straight: Further.straight(second.course) };
      parting = part(known(one), second, longer.course.duration);
    }
    move();
  }

  /**
   * Compares with a run, or with none.
   * @param {PlayedRun | null} run
   */
  function choose(run) {
    begin(run === player.run ? null : run);
    list();
    show();
    Timeline.paint();
    Plots.draw();
    if (scene) scene.refresh();
    document.dispatchEvent(new CustomEvent("compare"));
  }

  /** Shows the other run at this time; without one, the nearest that does otherwise is compared with. */
  function change() {
    if (second) {
      // A second switch restores the former run, place and time.
      const { run, legs, time } = left && left.run === second.run && left.moves === player.moves ? left : second;
      const from = { run: player.run, legs: player.legs, time: player.time };
      player.open(run, legs, time);
      left = { ...from, moves: player.moves };
      if (second.run === from.run && Rational.cmp(player.time, from.time) === 0) second.place(from.legs, from.time);
      show();
      document.dispatchEvent(new CustomEvent("compare"));
    } else if (runs.length > 0) choose(natural() || runs[0]);
  }

  /**
   * The events of a run.
   * @param {Player} of @returns {Happening[]}
   */
  const events = ({ course, data }) => course.legs.flatMap((leg) =>
    Rational.sign(leg.duration) === 0 ? [{ legs: leg.index, label: leg.label.words || leg.label.text, time: leg.start }] : []);

  /**
   * Where two runs part, as far as both are known: how time is cut into steps makes no difference.
   * @param {Player} one @param {Player} two @param {Rational} time up to which it is looked for @returns {Parting}
   */
  function part(one, two, time) {
    const [first, second] = [one, two].map((of) => all(of, time));
    const [a, b] = [first.events, second.events], start = one.run.start !== two.run.start;
    let same = 0;
    while (!start && same < Math.min(a.length, b.length) &&
      a[same].label === b[same].label && Rational.cmp(a[same].time, b[same].time) === 0) same++;
    const here = a[same] || null, there = b[same] || null;
    const [more, { until }] = here ? [here, second] : [there, first];
    // What comes when the run without it is not followed any more is no difference.
    if (start || (here && there) || (more && (!until || Rational.cmp(more.time, until) < 0)))
      return { same, here, there, start, until: null };
    const [u, v] = [first.until, second.until];
    const least = !u ? v : !v || Rational.cmp(u, v) < 0 ? u : v;
    return { same, here: null, there: null, start, until: least };
  }

  /**
   * The events of a run, also those after its states where it goes on by the same steps elsewhere; and before which time they
   * are all known.
   * @param {Player} of @param {Rational} time up to which they are looked for
   */
  function all(of, time) {
    const further = Further.rounds(of.data, of.run, of.course, time);
    return further ? { events: [...events(of), ...further.events], until: further.until } : { events: events(of), until: known(of) };
  }

  /**
   * Before which time all events of a run are known: null, for ever.
   * @param {Player} of
   */
  function known({ data, run, course }) {
    const after = Further.after(data, run);
    return after === "rests" || after === "stops" ? null : course.duration;
  }

  /** Whether the other run is known where this one is. */
  function followed(at = player) {
    if (!second) return false;
    const { duration } = second.course, after = Rational.cmp(at.time, duration);
    if (after < 0 || (after > 0 && end.after === "rests")) return after < 0 || end.straight;
    if (after > 0) return false;
    // More events at its last instant may come.
    return end.after === "rests" || end.after === "stops" || at.legs - first(at) <= second.course.legs.length - first(second);
  }

  /**
   * After how many legs the instant begins at which a run is.
   * @param {Player} of
   */
  function first(of) {
    let low = of.legs;
    while (low > 0 && Rational.cmp(of.instant(low - 1), of.time) === 0) low--;
    return low;
  }

  /** When the runs part, or null if they do not, as far as is known. */
  function when() {
    const { here, there, start } = parting;
    if (!second) return null;
    if (start) return Rational.zero;
    if (here && there) return Rational.cmp(here.time, there.time) < 0 ? here.time : there.time;
    return here ? here.time : there ? there.time : null;
  }

  /** Whether the runs part after the end of this one. */
  function beyond() {
    const time = when();
    return time !== null && Rational.cmp(time, player.course.duration) > 0;
  }

  /** Goes to the state from which the runs go on differently. */
  function difference() {
    const time = when();
    if (!time || beyond()) {
      if (second) Dom.tell(Dom.get("live"), words());
      return;
    }
    player.pause();
    const { here } = parting;
    if (here && Rational.cmp(here.time, time) === 0) player.go(here.legs, time);
    else player.seek(time);
  }

  /** The difference in words. */
  function words() {
    const { same, here, there, start, until } = parting;
    if (start) return "The runs begin in different states.";
    const first = same === 0 ? "No event is the same" : same === 1 ? "The first event is the same" : `The first ${same} events are the same`;
    const at = (/** @type {Rational} */ time) => `time ${Dom.clip(Exactly.text(time), 30)}`;
    if (until) {
      const count = same === 0 ? "no event" : same === 1 ? "1 event" : `${same} events`;
      return `The same as far as both are followed: ${count}, until ${at(until)}.`;
    }
    if (!here && !there) return `${same === 0 ? "Both runs are without events" : "All events are the same"}.`;
    const said = (/** @type {Happening | null} */ what) =>
      what ? `${Dom.clip(what.label, 100)}, at ${at(what.time)}` : "no event";
    const out = beyond() ? " That is after the end of what is shown of this run: switch to go there." : "";
    return `${first}. Then here: ${said(here)}. There: ${said(there)}.${out}`;
  }

  function move() {
    if (second) {
      bring(player);
      if (!player.playing) show();
    }
    if (scene) scene.others = second ? ghosts(scene) : [];
  }

  /**
   * Brings the other run to the time of a player.
   * @param {Player} at
   */
  function bring(at) {
    if (!second) return;
    second.beside(at);
    if (Rational.cmp(at.time, second.time) > 0 && followed(at)) second.time = at.time;
  }

  /**
   * Bodies of the other run that are elsewhere than in this one, or behave differently.
   * @param {Scene} scene @param {Player} [at] where this run is
   */
  function ghosts(scene, at = player) {
    if (!second || !followed(at)) return [];
    const { course, legs, time } = second, tint = scene.bodies.colors.other, here = place(at);
    let words = 0;
    return course.bodiesAfter(legs, time).flatMap((body) => body.process.leaves.flatMap((at) => {
      const same = here.get(at.leaf);
      const alike = same !== undefined && same.behaviour === at.behaviour;
      if (same && same.where === where(course, body, at) && alike) return [];
      const word = alike || words++ >= told ? undefined : Dom.clip(player.data.behaviours[at.behaviour].text, 30);
      return [{ course, body: Ghosts.still(body, time), place: at, tint, word: same ? word : undefined }];
    }));
  }

  const out = new Float64Array(12);
  const origin = Motion.target({ n: [0n, 0n, 0n], d: 1n });

  /**
   * Where a leaf is and how it is turned; floats are the nearest to the exact numbers.
   * @param {Course} course @param {Moving} body @param {DataPlace} place
   */
  function where(course, body, place) {
    course.place(body, place, origin, out);
    return out.join();
  }

  /**
   * Where all leaves are, and how they behave.
   * @param {Player} of
   */
  const place = ({ course, legs, time }) =>
    new Map(course.bodiesAfter(legs, time).flatMap((body) => body.process.leaves.map((at) =>
      [at.leaf, { where: where(course, body, at), behaviour: at.behaviour, name: course.leaves[at.leaf].name }])));

  /** What differs now: bodies, each with how. */
  function differences() {
    if (!second || !followed()) return [];
    const [here, there] = [place(player), place(second)], text = (/** @type {number} */ b) => player.data.behaviours[b].text;
    return [...new Set([...here.keys(), ...there.keys()])].sort((a, b) => a - b).flatMap((leaf) => {
      const [a, b] = [here.get(leaf), there.get(leaf)];
      if (!a) return b ? [`${b.name} (there alone)`] : [];
      if (!b) return [`${a.name} (here alone)`];
      const how = [
        a.where === b.where ? "" : "place",
        a.behaviour === b.behaviour ? "" : `behaviour ${Dom.clip(text(a.behaviour), 40)}, there ${Dom.clip(text(b.behaviour), 40)}`,
      ].filter((x) => x !== "");
      return how.length === 0 ? [] : [`${a.name} (${how.join("; ")})`];
    });
  }

  /** What is said of the other run where what is told of it has ended. */
  function further() {
    if (!second || Rational.cmp(player.time, second.course.duration) <= 0)
      return second && !followed() ? "The other run is not followed further." : "";
    if (end.after === "stops") return "The other run is over: no more time passes there.";
    if (end.after !== "rests") return "The other run is not followed further.";
    return `Nothing more happens in the other run${end.straight ? "" : "; its bodies are not followed further"}.`;
  }

  function show() {
    const box = Dom.get("compare");
    box.hidden = second === null;
    if (!second) return;
    const all = differences(), rest = all.length - told;
    Dom.tell(now, [
      !followed() ? "" : all.length === 0 ? "Nothing differs now."
        : `Different now: ${all.slice(0, told).join(", ")}${rest > 0 ? ` and ${rest} more` : ""}.`,
      further(),
    ].join(" ").trim());
    const head = `${player.run.index} ${second.run.index} ${second.run.name} ${player.run.name}`;
    if (box.dataset.of === head && box.firstChild) return;
    box.dataset.of = head;
    Dom.fill(
      box,
      Dom.make("span", { class: "compare-buttons" }, [
        Dom.button("Switch", change, { test: "compare-switch", class: "small", title: "Show the other run at this time (k)" }),
        when() && !beyond() ? Dom.button("Difference", difference, { test: "compare-difference", class: "small", title: "To the first difference (j)" }) : null,
      ]),
      Dom.make("p", { role: "status" }, [
        Dom.make("span", { class: "compare-mark", "aria-hidden": "true" }),
        "There: ", Dom.name(Dom.clip(second.run.name, 200)), ". ",
        Dom.make("bdi", { test: "compare-words", text: words() }), " ", now,
      ]),
    );
  }

  /**
   * Brings the other run to the time of a player, for the scene.
   * @param {Player} at
   */
  function stage(at) {
    if (!second || !scene) return;
    bring(at);
    scene.others = ghosts(scene, at);
  }

  /** What is compared, for tests. */
  function say() {
    if (!second) return null;
    const time = when();
    return {
      run: second.run.name, legs: second.legs, followed: followed(), now: now.textContent, time: Rational.text(second.time), words: words(), differences: differences(),
      parts: time && Rational.text(time),
    };
  }

  return { start, other, choose, change, difference, when, events, stage, say };
})();
