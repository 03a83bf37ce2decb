"use strict";

/**
 * What can be written at a place of a text: the names that fit there, and words with their grammar. The text may be half
 * written, so it is looked at word by word.
 *
 * @typedef {{name: string, kind: string, put: string}} Offer  `put` is what is written
 * @typedef {{text: string, at: number}} Piece a name, a number or a sign
 * @typedef {{word: string, name: string, pieces: Piece[]}} Item
 */
const Offers = (() => {
  const piece = /\/\/[^\n]*|\/\*[\s\S]*?(?:\*\/|$)|"(?:[^"\\\n]|\\.)*"?|[A-Za-zĀāĒēĪīŌōŪūȲȳḠḡ][\w'ĀāĒēĪīŌōŪūȲȳḠḡ\u0304\u0305]*|\d+|\S/g;
  const isName = (/** @type {string} */ text) => /^[A-Za-zĀāĒēĪīŌōŪūȲȳḠḡ]/.test(text);

  /** How a declaration, a setting or a part of a behaviour is written. */
  const grammar = /** @type {{[word: string]: string}} */ ({
    model: "model NAME", param: "param NAME = NUMBER", let: "let NAME = EXPRESSION", import: 'import NAME from "FILE"',
    check: "check NAME : always FORMULA", shape: "shape NAME { vertices a (0,0,0) … faces f [a,b,c] … }",
    compound: "compound NAME { part a : SHAPE mass 1 … glue }", behaviour: "behaviour NAME on SHAPE = <CHANNEL, {FEATURE}>. nil",
    process: "process NAME = SHAPE mass 1 velocity (0,0,0) at translate (0,0,0) [nil]",
    fixed: "fixed NAME = SHAPE at translate (0,0,0)", for: "for i in 1..3 { … }", motion: "motion NAME = (vx, vy, vz)",
    timestep: "timestep NUMBER", split_step: "split_step NUMBER", dynamics: "dynamics constant_spin", network: "network { NAMES }",
    resolution: "resolution NUMBER", collisions: "collisions in_turn", binding: "binding collision", bonds: "bonds acyclic",
    bond: "bond <CHANNEL, {BODY.FEATURE, BODY.FEATURE}>",
    part: "part NAME : SHAPE mass 1", omega: "omega(CHANNEL, {FEATURE}). nil", rho: "rho({<CHANNEL, {FEATURE}>}). nil",
    eps: "eps(NUMBER). nil", translate: "translate (0,0,0)", rotate: "rotate quaternion(1,0,0,0)", mass: "mass 1",
    velocity: "velocity (0,0,0)", spin: "spin (0,0,0)", scaled: "scaled (1,1,1)",
  });
  const beginning = "behaviour binding bond bonds check collisions compound dynamics fixed for import let model motion param process resolution shape split_step timestep".split(" ");
  const attributes = "at mass velocity spin translate rotate scale scaled".split(" ");
  const begins = new Set([...beginning.filter((word) => word !== "for"), "network"]);
  const boxes = "left right front back bottom top a b c d e f g h".split(" ");

  /** @param {string} text @returns {Piece[]} */
  function pieces(text) {
    const all = [...text.matchAll(piece)].map((found) => ({ text: found[0], at: found.index || 0 }));
    return all.filter((one) => !/^(\/\/|\/\*|")/.test(one.text));
  }

  /** @param {Piece[]} all @returns {Item[]} */
  function items(all) {
    /** @type {Item[]} */
    const found = [];
    all.forEach((one, i) => {
      // `bonds(rope)` and `<bond, …>` begin nothing.
      const next = all[i + 1] ? all[i + 1].text : "", before = i > 0 ? all[i - 1].text : "";
      if ((one.text === "bond" ? next === "<" : begins.has(one.text) && /^\w/.test(next || "x")) && !/^[<~,(.]$/.test(before))
        found.push({ word: one.text, name: isName(next) ? next : "", pieces: [] });
      if (found.length > 0) found[found.length - 1].pieces.push(one);
    });
    return found;
  }

  /** @param {string[]} names */
  const unique = (names) => [...new Set(names)];

  /**
   * The channels of a text.
   * @param {Piece[]} all
   */
  function channels(all) {
    return unique(all.flatMap((one, i) => {
      const before = all.slice(Math.max(0, i - 3), i).map((p) => p.text).join("");
      const opened = /<~?$|(omega|ω)\(~?$/.test(before) && all[i + 1] && all[i + 1].text === ",";
      return isName(one.text) && (opened || before.endsWith("<~")) ? [one.text] : [];
    }));
  }

  /**
   * The features of a shape: its corners and faces, those of its parts, or those of the shape that it is an image of.
   * @param {Item[]} all @param {string} name @param {number} depth
   * @returns {string[]}
   */
  function features(all, name, depth) {
    if (name === "box" || name === "Cube") {
      if (!all.some((item) => item.word === "shape" && item.name === name)) return boxes;
    }
    const item = all.find((one) => (one.word === "shape" || one.word === "compound") && one.name === name);
    if (!item || depth > 8) return [];
    const p = item.pieces.map((one) => one.text);
    /** @type {string[]} */
    const found = [];
    let inside = "";
    p.forEach((word, i) => {
      if (word === "vertices" || word === "faces" || word === "hull") inside = word;
      if (word === "part") inside = "";
      if (isName(word) && inside !== "" && p[i + 1] === (inside === "faces" ? "[" : "(") && word !== "hull") found.push(word);
      if (p[i - 1] === "part" && isName(word)) {
        const of = solid(p, p.indexOf(":", i) + 1);
        found.push(word, ...features(all, of, depth + 1).map((feature) => `${word}.${feature}`));
      }
    });
    const image = p.indexOf("=");
    if (found.length === 0 && image > 0) return features(all, solid(p, image + 1), depth + 1);
    return found;
  }

  /**
   * The name of the solid that begins there; of `solids.Cube`, the second one.
   * @param {string[]} p @param {number} i
   */
  const solid = (p, i) => (p[i + 1] === "." ? p[i + 2] : p[i]) || "";

  /**
   * The shapes of an item: of a process, what it is made of; of a behaviour, what it is on, or the shapes of the processes
   * that have it.
   * @param {Item[]} all @param {Item} item
   * @returns {string[]}
   */
  function shapes(all, item) {
    const p = item.pieces.map((one) => one.text);
    if (item.word !== "behaviour")
      return unique(p.flatMap((word, i) => (word === "=" || word === ":" ? [solid(p, i + 1), ...(p[i + 2] === ":" ? [solid(p, i + 3)] : [])] : [])));
    const on = p.indexOf("on");
    if (on > 0 && on < (p.indexOf("=") + 1 || p.length)) return [solid(p, on + 1)];
    const having = new Set([item.name]);
    for (let more = true; more; ) {
      more = false;
      for (const one of all)
        if (one.word === "behaviour" && !having.has(one.name) && one.pieces.some((q) => having.has(q.text))) {
          having.add(one.name);
          more = true;
        }
    }
    const made = all.filter((one) => (one.word === "process" || one.word === "fixed") && one.pieces.some((q) => having.has(q.text)));
    return unique(made.flatMap((one) => shapes(all, one)));
  }

  /** @param {Item[]} all @param {string[]} of */
  function featuresOf(all, of) {
    const found = unique(of.flatMap((name) => features(all, name, 0)));
    if (found.length > 0) return found;
    return unique(all.flatMap((item) => (item.word === "shape" || item.word === "compound" ? features(all, item.name, 0) : [])));
  }

  /**
   * Brackets that are open.
   * @param {Piece[]} all @returns {number[]}
   */
  function open(all) {
    /** @type {number[]} */
    const found = [];
    all.forEach((one, i) => {
      if (/^[[({]$/.test(one.text)) found.push(i);
      if (/^[\])}]$/.test(one.text)) found.pop();
    });
    return found;
  }

  /**
   * @param {string} text @param {number} at
   * @returns {{from: number, all: Offer[]}} `from` is where the word begins that is being written
   */
  function at(text, at) {
    const begun = /[A-Za-zĀāĒēĪīŌōŪūȲȳḠḡ][\w'ĀāĒēĪīŌōŪūȲȳḠḡ\u0304\u0305]*$/.exec(text.slice(0, at));
    const from = begun ? begun.index : at;
    const before = pieces(text.slice(0, from));
    // In a comment or a string nothing is offered.
    const marked = pieces(`${text.slice(0, from)} x`);
    if (marked.length === before.length) return { from, all: [] };
    const rest = begun ? text.slice(at).replace(/^[\w']+/, "") : text.slice(at);
    const known = pieces(`${text.slice(0, from)} ${rest}`);
    const found = offers(items(known), known, before);
    const word = text.slice(from, at).toLowerCase();
    const fits = found.filter((one) => one.name.toLowerCase().startsWith(word));
    return { from, all: fits.filter((one, i) => fits.findIndex((other) => other.name === one.name) === i) };
  }

  /** @param {Item[]} all @param {Piece[]} known @param {Piece[]} before */
  function offers(all, known, before) {
    const own = items(before), here = own[own.length - 1];
    const word = here ? here.word : "", p = (here ? here.pieces : before).map((one) => one.text);
    const last = p[p.length - 1] || "", opened = open(here ? here.pieces : before);
    const top = opened.length > 0 ? opened[opened.length - 1] : -1, bracket = top < 0 ? "" : p[top];
    const whole = here ? all.find((one) => one.word === word && one.name === here.name) || here : here;
    /** @param {...string} kinds */
    const declared = (...kinds) => unique(all.filter((one) => kinds.includes(one.word) && one.name !== "").map((one) => one.name));
    const names = (/** @type {string} */ kind, /** @type {string[]} */ list) => list.map((name) => ({ name, kind, put: name }));
    const words = (/** @type {string[]} */ list) => list.map((name) => ({ name, kind: grammar[name] || "word", put: name }));
    const process = ["process", "fixed", "behaviour", "bond"].includes(word);
    const solids = () => [...names("shape", [...declared("shape", "compound"), "box", "prism", "pyramid"])];
    const behaviours = () => [...names("behaviour", declared("behaviour")), ...words(["nil", "omega", "rho", "eps"])];

    if (process && (last === "~" || last === "<" || (last === "(" && /^(omega|ω)$/.test(p[p.length - 2] || ""))))
      return names("channel", channels(known));
    if (process && bracket === "{" && last === ".") return names("feature", inside(all, owner(p), /** @type {Item} */ (whole)));
    if (process && bracket === "{" && p[top - 1] === ",")
      return [...names("feature", featuresOf(all, shapes(all, /** @type {Item} */ (whole)))), ...words(["only"]),
        ...names("body", word === "behaviour" ? [] : [...leaves(/** @type {Item} */ (whole)), ...declared("process", "fixed")])];
    // After the name of a channel there are features, in brackets.
    if (process && last === "," && bracket !== "{" && /^[<~]$/.test(p[p.length - 3] || "")) return [];
    if (word === "behaviour" && last === "on") return solids();
    if ((word === "process" || word === "fixed" || word === "compound" || word === "shape") && (last === "=" || last === ":") && bracket !== "[")
      return [...solids(), ...(word === "shape" ? words(["mesh", "hull"]) : [])];
    if (process && (bracket === "[" || (word === "behaviour" && p.includes("="))) && /^[[.+=(,]$/.test(last)) return behaviours();
    const blank = last === "" || /^[\]}]$/.test(last);
    const bodies = names("body", [...declared("process", "fixed"), ...all.flatMap(leaves)]);
    const values = [...names("value", declared("param", "let"))];
    if (word === "process" || word === "fixed") return [...words(attributes), ...values, ...words(beginning)];
    if (blank || top < 0 && !/^[=:+*<>(,-]$/.test(last) && word !== "check") return [...words(beginning), ...values, ...bodies, ...rest()];
    return [...bodies, ...values, ...rest()];

    function rest() {
      const channel = names("channel", channels(known)), shape = names("shape", declared("shape", "compound"));
      return [...channel, ...shape, ...behaviours(), ...words(Language.words)];
    }
  }

  /**
   * Whose feature stands after the dot: `q` of `q.`, and of `q[i].`.
   * @param {string[]} p
   */
  const owner = (p) => (p[p.length - 2] === "]" ? p[p.lastIndexOf("[") - 1] : p[p.length - 2]);

  /**
   * The features of a part, or of a body.
   * @param {Item[]} all @param {string} name @param {Item} item
   */
  function inside(all, name, item) {
    const parts = featuresOf(all, shapes(all, item)).filter((one) => one.startsWith(`${name}.`));
    if (parts.length > 0) return parts.map((one) => one.slice(name.length + 1));
    const body = all.find((one) => (one.word === "process" || one.word === "fixed") && (one.name === name || leaves(one).includes(name)));
    return body ? featuresOf(all, shapes(all, body)) : [];
  }

  /**
   * The bodies of a process that are named: `a : Cube`, `a[i] : Cube`.
   * @param {Item} item
   */
  function leaves(item) {
    const p = item.pieces.map((one) => one.text);
    return item.word !== "process" ? [] : p.filter((name, i) => {
      if (!isName(name) || i < 2) return false;
      const after = p[i + 1] === "[" ? p[p.indexOf("]", i) + 1] : p[i + 1];
      return after === ":";
    });
  }

  return { at };
})();
