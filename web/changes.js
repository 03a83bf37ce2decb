"use strict";

/**
 * What a step of a run changes: places, velocities, spins, behaviours and bonds, before it and after it.
 * @typedef {{ leaf: number | null, name: string, what: string, before: string, after: string, ends?: DataBond["ends"] }} Change
 *   of a body, or of a bond, which has no leaf and ends
 */
const Changes = (() => {
  /** So many are listed; the places of so many bodies are compared, for not all that turn get elsewhere. */
  const listed = 12, compared = 40;

  /** @param {Rational[]} v */
  const vector = (v) => `(${v.map(Exactly.text).join(", ")})`;

  /** @param {[number, number, number] | string[]} v @returns {string} */
  const exact = (v) => vector(v.map((x) => Rational.of(String(x))));

  /**
   * The leaves of processes, each with its entry.
   * @param {DataProcess[]} processes
   */
  const places = (processes) =>
    new Map(processes.flatMap((process) => process.leaves.map((place) => [place.leaf, { process, place }])));

  /** @param {DataProcess[]} processes */
  const bonds = (processes) =>
    new Map(processes.flatMap((p) => p.bonds.map((b) => [`${b.name}: ${b.ends.map((end) => end.text).join(" and ")}`, b.ends])));

  /**
   * What an event changes, by the processes that it ends and those that it begins.
   * @param {PageData} data @param {Course} course @param {number} k the number of the leg, from 1 on
   * @returns {Change[]}
   */
  function byEvent(data, course, k) {
    const { ended, begun } = course.changed(k);
    const [old, now] = [places(ended), places(begun)];
    /** @type {Change[]} */
    const all = [];
    const leaves = [...new Set([...old.keys(), ...now.keys()])].sort((a, b) => a - b);
    for (const leaf of leaves) {
      const [a, b] = [old.get(leaf), now.get(leaf)], { name } = course.leaves[leaf];
      const add = (/** @type {string} */ what, /** @type {string} */ before, /** @type {string} */ after) => {
        if (before !== after) all.push({ leaf, name, what, before, after });
      };
      if (!a || !b) {
        add("", a ? "there" : "not there", b ? "there" : "gone");
        continue;
      }
      add("behaviour", data.behaviours[a.place.behaviour].text, data.behaviours[b.place.behaviour].text);
      add("velocity", exact(a.process.velocity), exact(b.process.velocity));
      const spin = (/** @type {DataProcess} */ p) => (p.turn ? exact(p.turn.spin) : "(0, 0, 0)");
      add("spin", spin(a.process), spin(b.process));
    }
    const [held, holds] = [bonds(ended), bonds(begun)];
    for (const [name, ends] of holds)
      if (!held.has(name)) all.push({ leaf: null, name, what: "bond", before: "none", after: "made", ends });
    for (const [name, ends] of held)
      if (!holds.has(name)) all.push({ leaf: null, name, what: "bond", before: "there", after: "split", ends });
    return all;
  }

  /** @param {Moving} body */
  const moves = ({ process }) => process.turn !== undefined || process.velocity.some((v) => !/^-?0(\/|$)/.test(v));

  /**
   * Where bodies are before and after some time has passed, and whether there are more that move than were compared.
   * @param {Course} course @param {number} legs that are over @param {Rational} from @param {Rational} to
   * @returns {{ changes: Change[], more: boolean }}
   */
  function byTime(course, legs, from, to) {
    if (Rational.cmp(from, to) >= 0) return { changes: [], more: false };
    let more = false;
    const at = (/** @type {Rational} */ time) => {
      const bodies = course.bodiesAfter(legs, time).filter(moves);
      more = bodies.length > compared;
      return new Map(bodies.slice(0, compared).flatMap((body) =>
        body.process.leaves.map((place) => [place.leaf, vector(course.position(body, place))])));
    };
    const before = at(from);
    const changes = [...at(to)].flatMap(([leaf, after]) => {
      const was = before.get(leaf);
      return was === undefined || was === after ? []
        : [{ leaf, name: course.leaves[leaf].name, what: "place", before: was, after }];
    });
    return { changes, more };
  }

  /**
   * What has changed since the state before: by the last step, or since it by the time that has passed. Events come
   * first.
   * @param {Player} player
   */
  function now(player) {
    const { course, legs, time } = player, leg = course.legs[legs - 1];
    if (player.between) return byTime(course, legs, player.instant(legs), time);
    if (!leg) return { changes: [], more: false };
    const { changes, more } = byTime(course, legs - 1, leg.start, player.instant(legs));
    return { changes: [...byEvent(player.data, course, legs), ...changes], more };
  }

  /**
   * A list of them, for people.
   * @param {Player} player
   */
  function show(player) {
    const { changes, more } = now(player);
    if (changes.length === 0) return null;
    const rest = changes.length - listed;
    const item = (/** @type {Change} */ { leaf, name, what, before, after }) => {
      const text = Dom.clip(name, 200);
      return Dom.make("li", { test: "change" }, [
        leaf === null ? Dom.make("bdi", { text }) : Dom.button(text, () => Details.select({ leaf }), { class: "link" }),
        Dom.make("span", { class: "quiet", text: ` ${what} ` }),
        Dom.make("bdi", { class: "was", text: Dom.clip(Exactly.brief(before), 160), title: Dom.clip(before, 2000) }),
        Dom.make("span", { class: "quiet", text: " → " }),
        Dom.make("bdi", { class: "is", text: Dom.clip(Exactly.brief(after), 160), title: Dom.clip(after, 2000) }),
      ]);
    };
    return Dom.make("div", { class: "changes" }, [
      Dom.make("h3", { text: player.between ? "Since the last event" : "Changed by this step" }),
      Dom.make("ul", { class: "plain" }, [
        ...changes.slice(0, listed).map(item),
        ...(rest > 0 || more ? [Dom.make("li", { class: "quiet", text: more ? "and others" : `and ${rest} more` })] : []),
      ]),
    ]);
  }

  return { now, show };
})();
