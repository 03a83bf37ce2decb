"use strict";

/**
 * What numbers and formulas about a state mean, over exact fractions: rule by rule what `scc` evaluates, of what the page's
 * data has. A value that does not exist is a {@link Nothing}, with the reason.
 *
 * @typedef {{ process: DataProcess, place: DataPlace, body: Moving }} Seat  A leaf in its process.
 * @typedef {{ data: PageData, leaves: DataLeaf[], state: number, time: Rational | null, bodies: Moving[],
 *   seats: Map<number, Seat> }} View  A state, some time after it was reached; without a time where several runs lead to it.
 * @typedef {Rational | boolean | Nothing} Value
 * @typedef {{ type: "number" | "truth", run: (view: View) => Value, needs?: Set<number> | null }} Compiled
 *   A formula as a function; at last, the leaves that it depends on, or null: on all.
 * @typedef {Map<string, { leaf?: number, value?: Rational }>} Bound  Variables of quantifiers.
 */
class Nothing {
  /** @param {string} why */
  constructor(why) {
    this.why = why;
  }
}

const Meaning = (() => {
  const axes = ["x", "y", "z"];
  const has = (/** @type {object} */ of, /** @type {string} */ name) => Object.prototype.hasOwnProperty.call(of, name);

  /**
   * @param {PageData} data @param {DataLeaf[]} leaves @param {number} state @param {Moving[]} bodies @param {Rational | null} time
   * @returns {View}
   */
  function view(data, leaves, state, bodies, time) {
    /** @type {Map<number, Seat>} */
    const seats = new Map();
    for (const body of bodies)
      for (const place of body.process.leaves) seats.set(place.leaf, { process: body.process, place, body });
    return { data, leaves, state, time, bodies, seats };
  }

  /**
   * A state of the graph, as it is when it is reached.
   * @param {PageData} data @param {number} state
   */
  function reached(data, state) {
    const bodies = Course.whole(data, state).map(([index, age]) => {
      const body = new Moving(data.processes[index], index, Rational.zero);
      body.at(age);
      return body;
    });
    return view(data, data.leaves, state, bodies, null);
  }

  // Vectors.
  /** @typedef {Rational[]} Vector */
  const plus = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a.map((x, i) => Rational.add(x, b[i]));
  const minus = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a.map((x, i) => Rational.sub(x, b[i]));
  const square = (/** @type {Vector} */ a) => a.reduce((sum, x) => Rational.add(sum, Rational.mul(x, x)), Rational.zero);
  const exact = (/** @type {string[]} */ texts) => texts.map(Rational.of);
  const scaled = (/** @type {Rational} */ k, /** @type {Vector} */ a) => a.map((x) => Rational.mul(k, x));
  const cross = (/** @type {Vector} */ a, /** @type {Vector} */ b) => [0, 1, 2].map((i) =>
    Rational.sub(Rational.mul(a[(i + 1) % 3], b[(i + 2) % 3]), Rational.mul(a[(i + 2) % 3], b[(i + 1) % 3])));

  /** @param {View} of @param {number} leaf @param {Seat} seat the centroid of its shape */
  function centroid({ leaves }, leaf, { body, place }) {
    const motion = Course.motion(body, place), at = Motion.position(motion, body.age), turn = Motion.orientation(motion, body.age);
    const arm = exact(leaves[leaf].centroid);
    const rows = [0, 1, 2].map((i) => [0, 1, 2].reduce(
      (sum, k) => Rational.add(sum, Rational.mul(Rational.make(turn.n[3 * i + k], turn.d), arm[k])), Rational.zero));
    return plus(at.n.map((n) => Rational.make(n, at.d)), rows);
  }

  /** @param {View} of @param {number} leaf @param {Seat} seat of its centroid: v + w × r */
  function velocity(of, leaf, seat) {
    const { velocity, turn } = seat.process, own = exact(velocity);
    if (!turn) return own;
    const centre = plus(exact(turn.centre), scaled(seat.body.age, own));
    return plus(own, cross(exact(turn.spin), minus(centroid(of, leaf, seat), centre)));
  }

  const spin = (/** @type {Seat} */ { process }) => (process.turn ? exact(process.turn.spin) : [Rational.zero, Rational.zero, Rational.zero]);

  /** @param {View} of @param {number} leaf @returns {Seat | Nothing} */
  function seat(of, leaf) {
    const { name } = of.leaves[leaf];
    return of.seats.get(leaf) || new Nothing(`${name} is gone, and nowhere: ask for gone(${name}) first`);
  }

  /** @param {number} leaf @param {(seat: Seat, view: View) => Value} f @returns {(view: View) => Value} */
  const ofLeaf = (leaf, f) => (view) => {
    const found = seat(view, leaf);
    return found instanceof Nothing ? found : f(found, view);
  };

  /**
   * What has no place: of who is gone, nothing is so, and there is none of it.
   * @template {Value} T
   * @param {number} leaf @param {T} gone @param {(seat: Seat, view: View) => T} f @returns {(view: View) => T}
   */
  const ofAny = (leaf, gone, f) => (view) => {
    const found = view.seats.get(leaf);
    return found ? f(found, view) : gone;
  };

  /** @param {DataBond} bond @param {number} p @param {number} q */
  const joins = ({ ends: [a, b] }, p, q) => (a.leaf === p && b.leaf === q) || (a.leaf === q && b.leaf === p);
  const whole = (/** @type {number} */ n) => /** @type {Rational} */ (Rational.make(BigInt(n), 1n));

  /** @type {{ [name: string]: (leaf: number) => Compiled }} */
  const ofOne = {
    size: (leaf) => ({ type: "number", run: ofAny(leaf, Rational.zero, ({ process }, { leaves }) =>
      whole(process.leaves.reduce((sum, place) => sum + leaves[place.leaf].parts.length, 0))) }),
    speed2: (leaf) => ({ type: "number", run: ofLeaf(leaf, (seat, view) => square(velocity(view, leaf, seat))) }),
    spin2: (leaf) => ({ type: "number", run: ofLeaf(leaf, (seat) => square(spin(seat))) }),
    gone: (leaf) => ({ type: "truth", run: (view) => !view.seats.has(leaf) }),
  };
  axes.forEach((axis, i) => {
    ofOne[axis] = (leaf) => ({ type: "number", run: ofLeaf(leaf, (seat, view) => centroid(view, leaf, seat)[i]) });
    ofOne[`v${axis}`] = (leaf) => ({ type: "number", run: ofLeaf(leaf, (seat, view) => velocity(view, leaf, seat)[i]) });
    ofOne[`w${axis}`] = (leaf) => ({ type: "number", run: ofLeaf(leaf, (seat) => spin(seat)[i]) });
  });

  /** @type {{ [name: string]: (p: number, q: number) => Compiled }} */
  const ofTwo = {
    distance2: (p, q) => ({ type: "number", run: ofLeaf(p, (a, view) => {
      const b = seat(view, q);
      return b instanceof Nothing ? b : square(minus(centroid(view, p, a), centroid(view, q, b)));
    }) }),
    bound: (p, q) => ({ type: "truth", run: ofAny(p, /** @type {boolean} */ (false), ({ process }) => process.bonds.some((bond) => joins(bond, p, q))) }),
    same: (p, q) => ({ type: "truth", run: ofAny(p, /** @type {boolean} */ (false), ({ process }) => process.leaves.some(({ leaf }) => leaf === q)) }),
  };

  /** @type {{ [name: string]: (args: Rational[]) => Rational }} */
  const ofNumbers = {
    min: (args) => args.reduce((a, b) => (Rational.cmp(b, a) < 0 ? b : a)),
    max: (args) => args.reduce((a, b) => (Rational.cmp(b, a) > 0 ? b : a)),
    abs: ([a]) => (Rational.sign(a) < 0 ? Rational.neg(a) : a),
    sign: ([a]) => whole(Rational.sign(a)),
  };

  /** @param {View} view @param {(process: DataProcess, mass: Rational, velocity: Vector) => Rational | Nothing} f of what is not fixed */
  function sum(view, f) {
    let all = Rational.zero;
    for (const { process } of view.bodies) {
      if (process.mass === null) continue;
      const part = f(process, Rational.of(process.mass), exact(process.velocity));
      if (part instanceof Nothing) return part;
      all = Rational.add(all, part);
    }
    return all;
  }

  const served = "can be asked for where a page is served (scc serve)";

  /** @type {{ [name: string]: Compiled }} */
  const alone = {
    processes: { type: "number", run: ({ bodies }) => whole(bodies.length) },
    time: { type: "number", run: ({ time }) => time || new Nothing("several times belong to the state") },
    energy: { type: "number", run: (view) => sum(view, (process, mass, v) => process.turn
      ? new Nothing(`the energy of what spins ${served}`) : Rational.mul(Rational.mul(Rational.make(1n, 2n), mass), square(v))) },
    quiescent: { type: "truth", run: ({ data, state }) => {
      const { next, rests } = data.states[state];
      return next === null ? new Nothing("it is not known what can happen there") : rests;
    } },
  };

  /**
   * A text as a function of states, or an exception `Reader.Wrong`.
   * @param {PageData} data @param {DataLeaf[]} leaves @param {{ [name: string]: string }} values of parameters
   * @param {string} text @returns {Compiled}
   */
  function compile(data, leaves, values, text) {
    const named = new Map(leaves.map(({ name }, i) => [name, i]));
    const channels = new Set([
      ...data.behaviours.flatMap(({ open, releases }) => [...open.map(({ channel }) => channel), ...releases]),
      ...data.processes.flatMap(({ bonds }) => bonds.map(({ name }) => name)),
    ]);
    const written = (/** @type {string} */ word) => data.text.split(/[^A-Za-z0-9_']+/).includes(word);
    let size = 0, wide = false;
    /** @type {Set<number>} */
    const needs = new Set();

    /** @param {string} why @param {Term} at @returns {never} */
    const wrong = (why, at) => {
      throw new Reader.Wrong(why, at.at);
    };

    /** @param {Term} term @param {Bound} bound @returns {string} the name that a path is, with its indices */
    function label(term, bound) {
      let at = 0;
      return JSON.parse(term.name || "[]").map((/** @type {[string, number]} */ [name, count]) => {
        const indices = (term.args || []).slice(at, (at += count)).map((index) => {
          const value = constant(index, bound);
          return value.d === 1n ? String(value.n) : wrong("an index is a whole number", index);
        });
        return count === 0 ? name : `${name}[${indices.join(",")}]`;
      }).join(".");
    }

    /** @param {Term} term @param {Bound} bound */
    function leaf(term, bound) {
      if (term.kind !== "path") return wrong("the name of a body is expected here", term);
      const name = label(term, bound), variable = bound.get(name);
      if (variable && variable.leaf !== undefined) {
        needs.add(variable.leaf);
        return variable.leaf;
      }
      const found = named.get(name);
      if (found !== undefined) needs.add(found);
      return found ?? wrong(`there is no body “${Dom.clip(name, 60)}”`, term);
    }

    /** @param {Term} term @param {Bound} bound */
    function channel(term, bound) {
      const name = term.kind === "co" ? term.name || "" : term.kind === "path" ? label(term, bound) : wrong("the name of a channel is expected here", term);
      if (!channels.has(name) && !written(name)) wrong(`no body has a channel “${Dom.clip(name, 60)}”`, term);
      return name;
    }

    /** @param {Term} term @param {Bound} bound @returns {Rational} */
    function constant(term, bound) {
      const value = number(term, bound).run(/** @type {any} */ ({ constant: true, seats: new Map(), bodies: [], time: null, data, leaves, state: -1 }));
      if (!(value instanceof Nothing) && typeof value !== "boolean" && settled(term, bound)) return value;
      return wrong("a number that does not change is expected here", term);
    }

    /** @param {Term} term @param {Bound} bound @returns {boolean} whether it depends on no state */
    function settled(term, bound) {
      if (term.kind === "call") return has(ofNumbers, term.name || "") && (term.args || []).every((a) => settled(a, bound));
      if (term.kind === "path") return bound.has(label(term, bound)) || has(values, label(term, bound));
      return term.kind !== "each" && (term.args || []).every((a) => settled(a, bound));
    }

    /** @param {Term} term @param {Bound} bound */
    const number = (term, bound) => typed(term, bound, "number", "a number is expected here");
    /** @param {Term} term @param {Bound} bound */
    const truth = (term, bound) => typed(term, bound, "truth", "what holds or not is expected here");

    /** @param {Term} term @param {Bound} bound @param {"number" | "truth"} type @param {string} why */
    function typed(term, bound, type, why) {
      const made = term_(term, bound);
      return made.type === type ? made : wrong(why, term);
    }

    /** @param {Term} term @param {Bound} bound @returns {Compiled} */
    function term_(term, bound) {
      if (++size > 20000) wrong("the formula is too long", term);
      const args = term.args || [];
      switch (term.kind) {
        case "number": return { type: "number", run: () => /** @type {Rational} */ (term.value) };
        case "true": case "false": return { type: "truth", run: () => term.kind === "true" };
        case "neg": return lift([number(args[0], bound)], ([a]) => Rational.neg(a));
        case "not": {
          const inner = truth(args[0], bound);
          return { type: "truth", run: (view) => {
            const value = inner.run(view);
            return value instanceof Nothing ? value : !value;
          } };
        }
        case "binary": return ["and", "or", "=>"].includes(term.op || "") ? connective(term.op || "", args, bound) : arithmetic(term, args, bound);
        case "compare": return comparison(term, args, bound);
        case "if": return choice(args, bound);
        case "each": return quantified(term, bound);
        case "call": return call(term, args, bound);
        case "path": return path(term, bound);
        default: return wrong("a value is expected here", term);
      }
    }

    /** @param {Compiled[]} parts @param {(values: Rational[]) => Value} f @param {"number" | "truth"} [type] @returns {Compiled} */
    const lift = (parts, f, type = "number") => ({ type, run: (view) => {
      /** @type {Rational[]} */
      const found = [];
      for (const part of parts) {
        const value = part.run(view);
        if (value instanceof Nothing) return value;
        found.push(/** @type {Rational} */ (value));
      }
      return f(found);
    } });

    /**
     * Of truths some of which are not known: what the others decide.
     * @param {Compiled[]} parts @param {boolean} some @returns {Compiled}
     */
    const joined = (parts, some) => ({ type: "truth", run: (view) => {
      /** @type {Nothing | null} */
      let open = null;
      for (const part of parts) {
        const value = part.run(view);
        if (value === some) return some;
        if (value instanceof Nothing) open = open || value;
      }
      return open || !some;
    } });

    /** @param {Compiled} part @returns {Compiled} */
    const negated = (part) => ({ type: "truth", run: (view) => {
      const value = part.run(view);
      return value instanceof Nothing ? value : !value;
    } });

    /** @param {string} op @param {Term[]} args @param {Bound} bound */
    function connective(op, args, bound) {
      const [a, b] = args.map((arg) => truth(arg, bound));
      return op === "and" ? joined([a, b], false) : joined([op === "or" ? a : negated(a), b], true);
    }

    /** @param {Term} term @param {Term[]} args @param {Bound} bound */
    function arithmetic(term, args, bound) {
      const parts = args.map((arg) => number(arg, bound));
      switch (term.op) {
        case "+": return lift(parts, ([a, b]) => Rational.add(a, b));
        case "-": return lift(parts, ([a, b]) => Rational.sub(a, b));
        case "*": return lift(parts, ([a, b]) => Rational.mul(a, b));
        case "/": return lift(parts, ([a, b]) => (Rational.sign(b) === 0 ? new Nothing("division by zero") : Rational.div(a, b)));
        default: return wrong("`mod` of what changes cannot stand in a formula", term);
      }
    }

    /** @type {{ [op: string]: (order: number) => boolean }} */
    const orders = {
      "<": (o) => o < 0, "<=": (o) => o <= 0, ">": (o) => o > 0, ">=": (o) => o >= 0, "=": (o) => o === 0, "!=": (o) => o !== 0,
    };

    /** @param {Term} term @param {Term[]} args @param {Bound} bound @returns {Compiled} */
    function comparison(term, args, bound) {
      const op = term.op || "=", at = args.findIndex((arg) => arg.kind === "call" && arg.name === "behaviour");
      if (at < 0) return lift(args.map((arg) => number(arg, bound)), ([a, b]) => orders[op](Rational.cmp(a, b)), "truth");
      if (op !== "=" && op !== "!=") wrong("a behaviour is compared by = and !=", term);
      const [subject] = args[at].args || [], other = args[1 - at];
      if (!subject || (args[at].args || []).length !== 1) wrong("`behaviour` takes one body", args[at]);
      const name = other.kind === "path" ? label(other, bound) : wrong(`the name of a behaviour is expected here; one with values ${served}`, other);
      if (!data.behaviours.some(({ origin }) => origin === name) && !written(name)) wrong(`there is no behaviour “${Dom.clip(name, 60)}”`, other);
      const is = ofAny(leaf(subject, bound), /** @type {boolean} */ (false), ({ place }) => data.behaviours[place.behaviour].origin === name);
      return { type: "truth", run: (view) => is(view) === (op === "=") };
    }

    /** @param {Term[]} args @param {Bound} bound @returns {Compiled} */
    function choice([c, a, b], bound) {
      const condition = truth(c, bound), yes = term_(a, bound), no = term_(b, bound);
      if (yes.type !== no.type) wrong("both parts are numbers, or both hold or not", b);
      if (yes.type === "truth") return joined([joined([condition, yes], false), joined([negated(condition), no], false)], true);
      return { type: "number", run: (view) => {
        const value = condition.run(view);
        return value instanceof Nothing ? value : value ? yes.run(view) : no.run(view);
      } };
    }

    /** @param {Term} term @param {Bound} bound @returns {Compiled} */
    function quantified(term, bound) {
      const [body] = term.args || [], variable = term.name || "";
      const parts = members(term, bound).map((value) => truth(body, new Map(bound).set(variable, value)));
      if (term.op === "forall") return joined(parts, false);
      if (term.op === "exists") return joined(parts, true);
      return { type: "number", run: (view) => {
        let count = 0;
        for (const part of parts) {
          const value = part.run(view);
          if (value instanceof Nothing) return value;
          if (value) count++;
        }
        return whole(count);
      } };
    }

    /** @param {Term} term @param {Bound} bound @returns {{ leaf?: number, value?: Rational }[]} */
    function members(term, bound) {
      const [low, high] = term.over || [];
      if (!high) {
        if (low.kind !== "path") return wrong("a template or a family of bodies is expected here", low);
        const name = label(low, bound);
        const found = [...leaves.keys()].filter((i) => leaves[i].template === name);
        const family = [...leaves.keys()].filter((i) => leaves[i].name === name || leaves[i].name.startsWith(`${name}[`) && !leaves[i].name.includes("."));
        if (found.length + family.length === 0) wrong(`there are no bodies “${Dom.clip(name, 60)}”`, low);
        return (found.length > 0 ? found : family).map((leaf) => ({ leaf }));
      }
      const [from, to] = [low, high].map((end) => constant(end, bound));
      if (from.d !== 1n || to.d !== 1n || to.n - from.n > 10000n) wrong("a range has whole ends, and not too many numbers", high);
      /** @type {{ value: Rational }[]} */
      const all = [];
      for (let n = from.n; n <= to.n; n++) all.push({ value: Rational.make(n, 1n) });
      const { filter } = term;
      if (!filter) return all;
      return all.filter((value) => {
        if (!(filter.args || []).every((arg) => settled(arg, new Map(bound).set(term.name || "", value)))) wrong("what restricts a range does not change", filter);
        return truth(filter, new Map(bound).set(term.name || "", value)).run(/** @type {any} */ ({})) === true;
      });
    }

    /** @param {Term} term @param {Term[]} args @param {Bound} bound @returns {Compiled} */
    function call(term, args, bound) {
      const name = term.name || "", takes = (/** @type {number} */ n, /** @type {string} */ what) => {
        if (args.length !== n) wrong(`“${name}” takes ${what}`, term);
      };
      if (has(ofOne, name)) {
        takes(1, "one body");
        return ofOne[name](leaf(args[0], bound));
      }
      if (has(ofTwo, name)) {
        takes(2, "two bodies");
        return ofTwo[name](leaf(args[0], bound), leaf(args[1], bound));
      }
      if (has(ofNumbers, name)) {
        if (args.length === 0 || (name !== "min" && name !== "max" && args.length > 1)) wrong(`“${name}” takes ${name === "abs" || name === "sign" ? "one number" : "numbers"}`, term);
        return lift(args.map((arg) => number(arg, bound)), ofNumbers[name]);
      }
      if (name === "bonds") return bonds(term, args, bound);
      if (name === "offers") {
        takes(2, "a body and a channel");
        const wanted = channel(args[1], bound), co = args[1].kind === "co";
        return { type: "truth", run: ofAny(leaf(args[0], bound), /** @type {boolean} */ (false), ({ place }) => {
          const { open, releases } = data.behaviours[place.behaviour];
          return open.some((one) => one.channel === wanted && (!co || one.co)) || (!co && releases.includes(wanted));
        }) };
      }
      if (name === "touching") return wrong(`whether bodies touch ${served}`, term);
      if (name === "behaviour") return wrong("a behaviour is compared with a name, as in behaviour(p) = K", term);
      return wrong(`there is no function “${Dom.clip(name, 60)}” here; more ${served}`, term);
    }

    /** @param {Term} term @param {Term[]} args @param {Bound} bound @returns {Compiled} */
    function bonds(term, args, bound) {
      if (![0, 1, 3].includes(args.length)) wrong("“bonds” takes a channel, or a channel and two bodies", term);
      const name = args.length > 0 ? channel(args[0], bound) : null;
      const is = (/** @type {DataBond} */ bond) => name === null || bond.name === name;
      if (args.length < 3) {
        wide = true;
        return { type: "number", run: ({ bodies }) => whole(bodies.reduce((sum, { process }) => sum + process.bonds.filter(is).length, 0)) };
      }
      const [p, q] = [leaf(args[1], bound), leaf(args[2], bound)];
      return { type: "number", run: ofAny(p, Rational.zero, ({ process }) => whole(process.bonds.filter((bond) => is(bond) && joins(bond, p, q)).length)) };
    }

    /** @param {Term} term @param {Bound} bound @returns {Compiled} */
    function path(term, bound) {
      const name = label(term, bound), variable = bound.get(name);
      if (variable) return variable.value ? { type: "number", run: () => /** @type {Rational} */ (variable.value) } : wrong("say what of a body is meant, as in x(p)", term);
      if (has(values, name)) {
        const value = Rational.of(values[name]);
        return { type: "number", run: () => value };
      }
      if (has(alone, name)) {
        wide = wide || name === "processes" || name === "energy";
        return alone[name];
      }
      const axis = /^momentum\.([xyz])$/.exec(name);
      wide = wide || axis !== null;
      if (axis) return { type: "number", run: (view) => sum(view, (_, mass, v) => Rational.mul(mass, v[axes.indexOf(axis[1])])) };
      if (named.has(name)) return wrong("say what of a body is meant, as in x(p)", term);
      return wrong(`the page does not know “${Dom.clip(name, 60)}”; the names that a model defines ${served}`, term);
    }

    const made = term_(Reader.read(text), new Map());
    return { ...made, needs: wide ? null : needs };
  }

  return { compile, view, reached };
})();
