"use strict";

/**
 * What is marked in the scene: the bodies that the reasons of a verdict name, and what the last step has changed.
 *
 * @typedef {{ lit: number[], words: { leaf: number, text: string }[], ends: { leaf: number, site: DataSite, made: boolean }[],
 *   before: Ghost[], gone: Ghost[] }} Marking  lit: leaves; words: of changes, beside leaves; ends: of bonds that were made or
 *   split; before: bodies where they were before the step; gone: those that matter, where they were last.
 */
const Marked = (() => {
  /** @type {Marking} */
  const none = { lit: [], words: [], ends: [], before: [], gone: [] };
  /** So many changes have words in the scene. */
  const most = 12;

  /**
   * What a text calls within parentheses: there are the bodies of the functions of states, as in behaviour(p) = Bound.
   * @param {string} text @param {string[]} names longest first
   * @returns {string[]}
   */
  function called(text, names) {
    const found = [];
    let depth = 0;
    for (let i = 0; i < text.length; i++) {
      if (text[i] === "(") depth++;
      else if (text[i] === ")") depth--;
      else if (depth > 0 && (i === 0 || !/[\w.\]]/.test(text[i - 1]))) {
        const name = names.find((one) => text.startsWith(one, i) && !/[\w[]/.test(text[i + one.length] || ""));
        if (name === undefined) continue;
        found.push(name);
        i += name.length - 1;
      }
    }
    return found;
  }

  /**
   * The claims that rest on no other ones.
   * @param {DataArgument} argument @returns {string[]}
   */
  const grounds = ({ claim, because, parts }) => (parts.length > 0 ? parts.flatMap(grounds) : [claim, ...because]);

  /** @type {WeakMap<PlayedRun, { lit: number[], counts: boolean }>} */
  const known = new WeakMap();

  /**
   * The leaves that the reasons of a run name; without reasons, those of its formula.
   * @param {PlayedRun} run @param {DataLeaf[]} leaves
   */
  const named = (run, leaves) => about(run, leaves).lit;

  /**
   * What the reasons of a run are about: the leaves that they name, and whether they count the bodies that are there.
   * @param {PlayedRun} run @param {DataLeaf[]} leaves
   */
  function about(run, leaves) {
    const had = known.get(run);
    if (had) return had;
    const texts = [...(run.facts || []), ...(run.argument ? grounds(run.argument) : [])];
    const names = leaves.map((leaf) => leaf.name).filter((name) => name !== "").sort((a, b) => b.length - a.length);
    const of = (/** @type {string[]} */ all) => new Set(all.flatMap((text) => called(text, names)));
    let found = of(texts);
    if (found.size === 0 && run.check && !run.bare) found = of([run.check.formula]);
    const lit = leaves.flatMap((leaf, i) => (found.has(leaf.name) ? [i] : []));
    const made = { lit, counts: run.check !== null && !run.bare && [...texts, run.check.formula].some((text) => /\bprocesses\b/.test(text)) };
    known.set(run, made);
    return made;
  }

  /**
   * The bodies that reasons are about and that are gone, where they were last.
   * @param {Player} player @param {number[]} tint @param {Set<number>} told those of which the step says it
   * @returns {Ghost[]}
   */
  function gone({ course, legs, run }, tint, told) {
    const { lit, counts } = about(run, course.leaves);
    return (counts ? course.gone(legs) : lit).filter((leaf) => !told.has(leaf)).slice(0, most).flatMap((leaf) => {
      const last = course.last(leaf, legs);
      return last === null ? [] : [{ course, body: last.body, place: last.place, tint, word: word(course, leaf) }];
    });
  }

  /** @param {Course} course @param {number} leaf what is written beside the outline of one that is gone */
  const word = (course, leaf) => `${Dom.clip(course.leaves[leaf].name, 40)}: gone`;

  /**
   * What is marked now. While a run is played, nothing changes in steps.
   * @param {Player} player @param {{ before: number[] }} colors
   * @returns {Marking}
   */
  function now(player, colors) {
    const { course, legs, run } = player, lit = named(run, course.leaves);
    if (player.playing) return { ...none, lit, gone: gone(player, colors.before, new Set()) };
    const { changes } = Changes.now(player);
    const words = changes.flatMap(({ leaf, what, before, after }) =>
      leaf !== null && what === "behaviour" ? [{ leaf, text: `${Dom.clip(before, 22)} → ${Dom.clip(after, 22)}` }] : []);
    const ends = changes.flatMap(({ ends, after }) =>
      (ends || []).map(({ leaf, site }) => ({ leaf, site, made: after === "made" })));
    const was = before(player, legs, changes, colors.before);
    const told = new Set(was.map(({ place }) => place.leaf));
    return { lit, words: words.slice(0, most), ends, before: was, gone: gone(player, colors.before, told) };
  }

  /**
   * Bodies where they were before they moved, or went.
   * @param {Player} player @param {number} legs @param {Change[]} changes @param {number[]} tint
   */
  function before(player, legs, changes, tint) {
    const { course } = player, past = player.between ? legs : legs - 1;
    const moved = new Map(changes.flatMap(({ leaf, what, after }) =>
      leaf !== null && (what === "place" || after === "gone") ? [[leaf, after === "gone" ? word(course, leaf) : undefined]] : []));
    if (moved.size === 0) return [];
    const at = player.instant(past), bodies = course.bodiesAfter(past, at);
    return bodies.flatMap((body) => body.process.leaves.flatMap((place) => {
      if (!moved.has(place.leaf)) return [];
      return [{ course, body: Ghosts.still(body, at), place, tint, word: moved.get(place.leaf) }];
    }));
  }

  return { now, named, none };
})();
