"use strict";

/**
 * What numbers and formulas about a state mean, over exact fractions: rule by rule what `scc` evaluates, of what the page's
 * data has. A value that does not exist is a {@link Nothing}, with the reason.
 *
 * @typedef {{ process: DataProcess, place: DataPlace, body: Moving, centroid?: Rational[], velocity?: Rational[] }} Seat  A leaf
 *   in its process; what is known of it at this instant.
 * @typedef {{ data: PageData, leaves: DataLeaf[], state: number, time: Rational | null, bodies: Moving[],
 *   seats: Map<number, Seat> }} View  A state, some time after it was reached; without a time where several runs lead to it.
 * @typedef {Rational | boolean | Nothing} Value
 * @typedef {{ type: "number" | "truth" | "vector", run: (view: View) => Value, parts?: Compiled[], needs?: Set<number> | null }}
 *   Compiled  A formula as a function, a vector by its three parts; at last, the leaves that it depends on, or null: on all.
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
   * The name before a component, and the component; the whole name if there is none.
   * @param {string} name
   */
  const component = (name) => {
    const [, of = name, axis = ""] = /^(.*)\.([xyz])$/.exec(name) || [];
    return { of, axis };
  };

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
  function centroid(of, leaf, seat) {
    return (seat.centroid ??= centred(of, leaf, seat));
  }

  /** @param {View} of @param {number} leaf @param {Seat} seat */
  function centred({ leaves }, leaf, { body, place }) {
    const motion = Course.motion(body, place), at = Motion.position(motion, body.age), turn = Motion.orientation(motion, body.age);
    const arm = exact(leaves[leaf].centroid);
    const rows = [0, 1, 2].map((i) => [0, 1, 2].reduce(
      (sum, k) => Rational.add(sum, Rational.mul(Rational.make(turn.n[3 * i + k], turn.d), arm[k])), Rational.zero));
    return plus(at.n.map((n) => Rational.make(n, at.d)), rows);
  }

  /** @param {View} of @param {number} leaf @param {Seat} seat of its centroid: v + w × r */
  function velocity(of, leaf, seat) {
    return (seat.velocity ??= moved(of, leaf, seat));
  }

  /** @param {View} of @param {number} leaf @param {Seat} seat */
  function moved(of, leaf, seat) {
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

  /** @param {Rational} a */
  const floor = (a) => {
    const n = a.n / a.d;
    return /** @type {Rational} */ (Rational.make(a.n % a.d !== 0n && a.n < 0n ? n - 1n : n, 1n));
  };

  /**
   * What is of constants alone, since it would jump while a body moves.
   * @type {{ [name: string]: (args: Rational[]) => Rational }}
   */
  const ofConstants = {
    floor: ([a]) => floor(a),
    ceil: ([a]) => Rational.neg(floor(Rational.neg(a))),
    mod: ([a, b]) => Rational.sub(a, Rational.mul(b, floor(Rational.div(a, b)))),
    // Of two multiples that are equally near, the one farther from zero.
    round: ([a, b]) => {
      const part = Rational.div(a, b), near = floor(Rational.add(ofNumbers.abs([part]), /** @type {Rational} */ (Rational.make(1n, 2n))));
      return Rational.mul(b, Rational.sign(part) < 0 ? Rational.neg(near) : near);
    },
  };

  /** @param {View} view @param {(body: Moving, mass: Rational) => Rational} f of what is not fixed */
  const sum = (view, f) => view.bodies.reduce((all, body) =>
    (body.process.mass === null ? all : Rational.add(all, f(body, Rational.of(body.process.mass)))), Rational.zero);

  const dot = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a.reduce((sum, x, i) => Rational.add(sum, Rational.mul(x, b[i])), Rational.zero);
  const half = /** @type {Rational} */ (Rational.make(1n, 2n));

  /** @typedef {Vector[]} Matrix  Three rows. */
  const apply = (/** @type {Matrix} */ m, /** @type {Vector} */ v) => m.map((row) => dot(row, v));
  const transposed = (/** @type {Matrix} */ m) => [0, 1, 2].map((i) => m.map((row) => row[i]));
  const times = (/** @type {Matrix} */ a, /** @type {Matrix} */ b) => {
    const columns = transposed(b);
    return a.map((row) => columns.map((column) => dot(row, column)));
  };

  /**
   * The inertia of a process that turns, about its centre of mass, as it is turned: that of its leaves, each about its
   * centroid, and by the parallel axis theorem.
   * @param {View} view @param {Moving} body @param {Vector} centre @returns {Matrix}
   */
  function inertia(view, body, centre) {
    let sum = [0, 1, 2].map(() => [Rational.zero, Rational.zero, Rational.zero]);
    for (const place of body.process.leaves) {
      const { leaves } = view, of = leaves[place.leaf], seat = { process: body.process, place, body };
      const turn = Motion.orientation(Course.motion(body, place), body.age);
      const rows = [0, 1, 2].map((i) => [0, 1, 2].map((k) => Rational.make(turn.n[3 * i + k], turn.d)));
      const own = times(times(rows, /** @type {string[][]} */ (of.inertia).map(exact)), transposed(rows));
      const mass = Rational.of(of.mass || "0/1"), r = minus(centroid(view, place.leaf, seat), centre), far = square(r);
      sum = sum.map((row, i) => row.map((x, k) => Rational.add(Rational.add(x, own[i][k]),
        Rational.mul(mass, Rational.sub(i === k ? far : Rational.zero, Rational.mul(r[i], r[k]))))));
    }
    return sum;
  }

  /**
   * The solution of m v = b for a matrix with an inverse, by Cramer's rule.
   * @param {Matrix} m @param {Vector} b
   */
  function solved(m, b) {
    const columns = transposed(m), whole = dot(columns[0], cross(columns[1], columns[2]));
    return [0, 1, 2].map((i) => {
      const [p, q, r] = columns.map((column, k) => (k === i ? b : column));
      return Rational.div(dot(p, cross(q, r)), whole);
    });
  }

  /**
   * What a process that turns has of its turning: spin, inertia, and of a free body the angular momentum, which is kept.
   * @param {View} view @param {Moving} body
   */
  function turning(view, body) {
    const turn = /** @type {NonNullable<DataProcess["turn"]>} */ (body.process.turn), w = exact(turn.spin);
    const centre = plus(exact(turn.centre), scaled(body.age, exact(body.process.velocity)));
    return { w, inertia: inertia(view, body, centre), kept: turn.kept ? exact(turn.kept) : null };
  }

  /**
   * The energy of a process. That of a free body is that of what it keeps, unless its spin is along it.
   * @param {View} view @param {Moving} body @param {Rational} mass
   */
  function energy(view, body, mass) {
    const straight = Rational.mul(mass, square(exact(body.process.velocity)));
    if (!body.process.turn) return Rational.mul(half, straight);
    const { w, inertia, kept } = turning(view, body);
    const ball = inertia.every((row, i) => row.every((x, k) => Rational.cmp(x, i === k ? inertia[0][0] : Rational.zero) === 0));
    const along = kept !== null && cross(w, kept).every((x) => Rational.sign(x) === 0);
    const round = kept === null || ball || along ? dot(w, apply(inertia, w)) : dot(kept, solved(inertia, kept));
    return Rational.mul(half, Rational.add(straight, round));
  }

  /**
   * The angular momentum of a process about the origin.
   * @param {View} view @param {Moving} body @param {Rational} mass
   */
  function angular(view, body, mass) {
    const { process } = body, v = exact(process.velocity);
    if (process.turn) {
      const { w, inertia, kept } = turning(view, body), centre = plus(exact(process.turn.centre), scaled(body.age, v));
      return plus(scaled(mass, cross(centre, v)), kept || apply(inertia, w));
    }
    return process.leaves.reduce((sum, place) => {
      const own = Rational.of(view.leaves[place.leaf].mass || "0/1");
      return plus(sum, scaled(own, cross(centroid(view, place.leaf, { process, place, body }), v)));
    }, [Rational.zero, Rational.zero, Rational.zero]);
  }

  const served = "can be asked for where a page is served (scc serve)";

  /** @type {{ [name: string]: Compiled }} */
  const alone = {
    processes: { type: "number", run: ({ bodies }) => whole(bodies.length) },
    time: { type: "number", run: ({ time }) => time || new Nothing("several times belong to the state") },
    energy: { type: "number", run: (view) => sum(view, (body, mass) => energy(view, body, mass)) },
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
    // Templates and families of which there are no bodies.
    const declared = (/** @type {string} */ name) => [...data.text.matchAll(/\b(?:shape|compound|process|fixed)\s+([A-Za-z][A-Za-z0-9_']*)/g)].some(([, word]) => word === name.replace(/[[(].*$/, ""));
    let size = 0, wide = false, within = 0, seen = Infinity;
    /** @type {Set<number>} */
    const needs = new Set();
    const lets = data.lets || {};
    const places = new Map(Object.keys(lets).map((name, i) => [name, i]));
    /** @type {Map<string, Term>} what `let`s define, by their names, as far as it was read */
    const definitions = new Map();
    /** @param {string} name whether a definition of it is seen: within another one, if it stands before that one */
    const isDefined = (name) => (places.get(name) ?? Infinity) < seen;

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

    /**
     * What is made of a definition, which sees no variables of who uses it. What is wrong with it is wrong at its name.
     * @template T
     * @param {string} name @param {Term} term where the name stands @param {(definition: Term) => T} make @returns {T}
     */
    function defined(name, term, make) {
      if (within === 100) wrong("definitions nest too deep", term);
      const before = seen;
      within++;
      seen = /** @type {number} */ (places.get(name));
      try {
        let found = definitions.get(name);
        if (!found) definitions.set(name, (found = Reader.read(lets[name])));
        return make(found);
      } catch (error) {
        if (!(error instanceof Reader.Wrong)) throw error;
        const why = error.whole || within > 1 ? error.message : `in “${Dom.clip(name, 60)}”: ${error.message}`;
        throw new Reader.Wrong(why, term.at, error.whole);
      } finally {
        within--;
        seen = before;
      }
    }

    /** @param {Term} term @param {Bound} bound @returns {boolean} whether it depends on no state */
    function settled(term, bound) {
      if (term.kind === "call") return (has(ofNumbers, term.name || "") || has(ofConstants, term.name || "") || has(ofVectors, term.name || "")) && (term.args || []).every((a) => settled(a, bound));
      if (term.kind === "path") {
        const name = label(term, bound), { of } = component(name);
        if (bound.has(name) || has(values, name)) return true;
        return isDefined(of) && defined(of, term, (definition) => settled(definition, new Map()));
      }
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

    /** @param {Compiled[]} parts @returns {Compiled} */
    const vector = (parts) => ({ type: "vector", parts, run: () => new Nothing("a vector is no number") });

    /** @param {Term} term @param {Bound} bound @returns {Compiled[]} its parts */
    const parts = (term, bound) => {
      const made = term_(term, bound);
      return made.parts || wrong("a vector is expected here", term);
    };

    /** @type {{ [name: string]: (a: Compiled[], b: Compiled[]) => Compiled }} */
    const ofVectors = {
      dot: (a, b) => lift([...a, ...b], (all) => dot(all.slice(0, 3), all.slice(3))),
      // Each part from those that it needs, as some of the others may have no value.
      cross: (a, b) => vector([0, 1, 2].map((i) => {
        const [j, k] = [(i + 1) % 3, (i + 2) % 3];
        return lift([a[j], b[k], a[k], b[j]], ([p, q, r, s]) => Rational.sub(Rational.mul(p, q), Rational.mul(r, s)));
      })),
    };

    /** @param {Term} term @param {Bound} bound @returns {Compiled} */
    function term_(term, bound) {
      if (++size > 20000) wrong("the formula is too long", term);
      const args = term.args || [];
      switch (term.kind) {
        case "number": return { type: "number", run: () => /** @type {Rational} */ (term.value) };
        case "true": case "false": return { type: "truth", run: () => term.kind === "true" };
        case "neg": {
          const inner = term_(args[0], bound), minus = (/** @type {Compiled} */ one) => lift([one], ([a]) => Rational.neg(a));
          if (inner.parts) return vector(inner.parts.map(minus));
          return inner.type === "number" ? minus(inner) : wrong("a number is expected here", args[0]);
        }
        case "vector": return vector(args.map((arg) => number(arg, bound)));
        case "component": return parts(args[0], bound)[axes.indexOf(term.name || "x")];
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
      const op = term.op || "+";
      if (op === "mod") return constants("mod", term, args, bound);
      const [a, b] = args.map((arg) => term_(arg, bound));
      if (a.type === "truth") wrong("a number is expected here", args[0]);
      if (b.type === "truth") wrong("a number is expected here", args[1]);
      const one = (/** @type {Compiled} */ p, /** @type {Compiled} */ q) => operated(op, p, q);
      const { parts: v } = a, { parts: w } = b;
      if (!v && !w) return one(a, b);
      if (v && w && (op === "+" || op === "-")) return vector(v.map((x, i) => one(x, w[i])));
      if (!v && w && op === "*") return vector(w.map((x) => one(a, x)));
      if (v && !w && (op === "*" || op === "/")) return vector(v.map((x) => one(x, b)));
      return wrong("vectors are added and subtracted, and multiplied and divided by numbers; their products are dot(v, w) and cross(v, w)", term);
    }

    /** @param {string} op @param {Compiled} p @param {Compiled} q */
    function operated(op, p, q) {
      switch (op) {
        case "+": return lift([p, q], ([a, b]) => Rational.add(a, b));
        case "-": return lift([p, q], ([a, b]) => Rational.sub(a, b));
        case "*": return lift([p, q], ([a, b]) => Rational.mul(a, b));
        default: return lift([p, q], ([a, b]) => (Rational.sign(b) === 0 ? new Nothing("division by zero") : Rational.div(a, b)));
      }
    }

    /** @param {string} name @param {Term} term @param {Term[]} args @param {Bound} bound @returns {Compiled} */
    function constants(name, term, args, bound) {
      if (args.length !== (name === "mod" || name === "round" ? 2 : 1)) wrong(`“${name}” takes ${name === "mod" || name === "round" ? "two numbers" : "one number"}`, term);
      for (const arg of args) number(arg, bound);
      if (!args.every((arg) => settled(arg, bound))) wrong(`“${name}” of what changes cannot stand in a formula`, term);
      const all = args.map((arg) => constant(arg, bound));
      if (all[1] && Rational.sign(all[1]) === 0) wrong("division by zero", term);
      const value = ofConstants[name](all);
      return { type: "number", run: () => value };
    }

    /** @type {{ [op: string]: (order: number) => boolean }} */
    const orders = {
      "<": (o) => o < 0, "<=": (o) => o <= 0, ">": (o) => o > 0, ">=": (o) => o >= 0, "=": (o) => o === 0, "!=": (o) => o !== 0,
    };

    /** @param {Term} term @param {Term[]} args @param {Bound} bound @returns {Compiled} */
    function comparison(term, args, bound) {
      const op = term.op || "=", at = args.findIndex((arg) => arg.kind === "call" && arg.name === "behaviour");
      if (at < 0) return compared(op, args, bound);
      if (op !== "=" && op !== "!=") wrong("a behaviour is compared by = and !=", term);
      const [subject] = args[at].args || [], other = args[1 - at];
      if (!subject || (args[at].args || []).length !== 1) wrong("`behaviour` takes one body", args[at]);
      const name = other.kind === "path" ? label(other, bound) : wrong(`the name of a behaviour is expected here; one with values ${served}`, other);
      if (!data.behaviours.some(({ origin }) => origin === name) && !written(name)) wrong(`there is no behaviour “${Dom.clip(name, 60)}”`, other);
      const is = ofAny(leaf(subject, bound), /** @type {boolean} */ (false), ({ place }) => data.behaviours[place.behaviour].origin === name);
      return { type: "truth", run: (view) => is(view) === (op === "=") };
    }

    /** @param {string} op @param {Term[]} args @param {Bound} bound @returns {Compiled} */
    function compared(op, args, bound) {
      const [a, b] = args.map((arg) => term_(arg, bound));
      const both = (/** @type {Compiled} */ p, /** @type {Compiled} */ q, /** @type {string} */ how) =>
        lift([p, q], ([x, y]) => orders[how](Rational.cmp(x, y)), "truth");
      if (a.parts && b.parts) {
        if (op !== "=" && op !== "!=") wrong("vectors are compared by = and !=", args[0]);
        const same = joined(a.parts.map((x, i) => both(x, /** @type {Compiled[]} */ (b.parts)[i], "=")), false);
        return op === "=" ? same : negated(same);
      }
      const odd = a.type === "number" ? (b.type === "number" ? null : args[1]) : args[0];
      return odd ? wrong("a number is expected here", odd) : both(a, b, op);
    }

    /** @param {Term[]} args @param {Bound} bound @returns {Compiled} */
    function choice([c, a, b], bound) {
      const condition = truth(c, bound), yes = term_(a, bound), no = term_(b, bound);
      if (yes.type !== no.type) wrong("both parts are numbers, or both are vectors, or both hold or not", b);
      if (yes.type === "truth") return joined([joined([condition, yes], false), joined([negated(condition), no], false)], true);
      const either = (/** @type {Compiled} */ p, /** @type {Compiled} */ q) => /** @type {Compiled} */ ({ type: "number", run: (view) => {
        const value = condition.run(view);
        return value instanceof Nothing ? value : value ? p.run(view) : q.run(view);
      } });
      return yes.parts ? vector(yes.parts.map((p, i) => either(p, /** @type {Compiled[]} */ (no.parts)[i]))) : either(yes, no);
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
        if (low.kind !== "path" && low.kind !== "call") return wrong("a template or a family of bodies is expected here", low);
        const name = low.kind === "path" ? label(low, bound)
          : `${low.name}(${(low.args || []).map((arg) => Exactly.text(constant(arg, bound))).join(",")})`;
        // Of a template with parameters, its name alone is all of its instances.
        const found = [...leaves.keys()].filter((i) => leaves[i].template === name || leaves[i].template.startsWith(`${name}(`));
        const family = [...leaves.keys()].filter((i) => leaves[i].name === name || leaves[i].name.startsWith(`${name}[`) || leaves[i].name.startsWith(`${name}.`));
        if (found.length + family.length === 0 && !declared(name)) wrong(`there are no bodies “${Dom.clip(name, 60)}”`, low);
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
      if (has(ofConstants, name)) return constants(name, term, args, bound);
      if (has(ofVectors, name)) {
        takes(2, "two vectors");
        return ofVectors[name](parts(args[0], bound), parts(args[1], bound));
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
      const { of, axis } = component(name), none = new Map();
      if (isDefined(name)) return defined(name, term, (definition) => term_(definition, none));
      if (isDefined(of)) return defined(of, term, (definition) => parts(definition, none)[axes.indexOf(axis)]);
      if (has(alone, name)) {
        wide = wide || name === "processes" || name === "energy";
        return alone[name];
      }
      const k = of === "momentum" || of === "angular" ? axes.indexOf(axis) : -1;
      wide = wide || k >= 0;
      if (k >= 0 && of === "momentum") return { type: "number", run: (view) => sum(view, ({ process }, mass) => Rational.mul(mass, Rational.of(process.velocity[k]))) };
      if (k >= 0) return { type: "number", run: (view) => sum(view, (body, mass) => angular(view, body, mass)[k]) };
      if (named.has(name)) return wrong("say what of a body is meant, as in x(p)", term);
      return wrong(`the page does not know “${Dom.clip(name, 60)}”; what loops and imports define ${served}`, term);
    }

    const term = Reader.read(text), made = term_(term, new Map());
    if (made.type === "vector") wrong("a number is expected here, or what holds or not", term);
    return { ...made, needs: wide ? null : needs };
  }

  return { compile, view, reached };
})();
