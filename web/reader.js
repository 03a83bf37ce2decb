"use strict";

/**
 * Reads numbers and formulas about a state, as the language has them (specs/language.md): what a page that was opened from
 * disk can evaluate by itself.
 *
 * @typedef {{ kind: string, at: [number, number], name?: string, value?: Rational, args?: Term[], op?: string,
 *   over?: Term[], filter?: Term | null }} Term  With the characters between which it stands.
 */
const Reader = (() => {
  const temporal = new Set(["always", "possibly", "eventually", "AG", "EG", "AF", "EF", "AX", "EX", "leads_to", "within", "U"]);
  const words = new Set(["and", "or", "not", "if", "then", "else", "true", "false", "forall", "exists", "count", "in", "mod", "event", ...temporal]);
  const comparisons = ["<=", ">=", "!=", "<", ">", "="];
  /** Deeper ones are refused: reading them is recursive. */
  const deepest = 200;

  /** Why a text is no formula that can be evaluated here, and where. */
  class Wrong extends Error {
    /** @param {string} why @param {[number, number]} at @param {boolean} [whole] whether it is about whole runs */
    constructor(why, at, whole) {
      super(why);
      this.at = at;
      this.whole = whole === true;
    }
  }

  /** @typedef {{ text: string, kind: "number" | "name" | "mark" | "end", at: [number, number] }} Token */

  /** @param {string} text @returns {Token[]} */
  function tokens(text) {
    const all = /\s+|((?:2\^-[0-9]+|[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?))(?!\.?[0-9])|([A-Za-z][A-Za-z0-9_']*)|(<=|>=|!=|=>|\.\.|[()[\],:.~<>=+\-*/?])/y;
    /** @type {Token[]} */
    const found = [];
    while (all.lastIndex < text.length) {
      const from = all.lastIndex, match = all.exec(text);
      if (!match) {
        const sign = String.fromCodePoint(/** @type {number} */ (text.codePointAt(from)));
        throw new Wrong(`“${sign}” is not a mark of formulas`, [from, from + sign.length]);
      }
      const at = /** @type {[number, number]} */ ([from, all.lastIndex]);
      if (match[1]) found.push({ text: match[1], kind: "number", at });
      else if (match[2]) found.push({ text: match[2], kind: "name", at });
      else if (match[3]) found.push({ text: match[3], kind: "mark", at });
    }
    found.push({ text: "", kind: "end", at: [text.length, text.length] });
    return found;
  }

  /** Numbers of more digits than these, written out, are refused. */
  const digits = 20000;

  /**
   * An exact number as it is written: digits with a decimal point and an exponent, or a power of two.
   * @param {Token} token @returns {Rational}
   */
  function exact({ text, at }) {
    const [, whole = "", part = "", power = "0"] = /^([0-9]+)(?:\.([0-9]+))?(?:[eE]([+-]?[0-9]+))?$/.exec(text) || [];
    const half = text.startsWith("2^-") ? Number(text.slice(3)) : 0, exponent = Number(power) - part.length;
    if (text.length > digits || !(Math.abs(exponent) <= digits) || half > digits)
      throw new Wrong(`a number has at most ${digits} digits when it is written out`, at);
    if (half > 0 || whole === "") return Rational.make(1n, 2n ** BigInt(half));
    const n = BigInt(whole + part);
    return exponent >= 0 ? Rational.make(n * 10n ** BigInt(exponent), 1n) : Rational.make(n, 10n ** BigInt(-exponent));
  }

  /** @param {string} text @returns {Term} */
  function read(text) {
    const all = tokens(text);
    let next = 0, depth = 0;
    const now = () => all[next];
    const is = (/** @type {string} */ mark) => now().text === mark && now().kind !== "end";
    const take = () => all[next++];
    /** @param {string} why @returns {never} */
    const wrong = (why) => {
      throw new Wrong(why, now().at);
    };
    const runs = () => new Wrong("this is about whole runs", now().at, true);
    const expect = (/** @type {string} */ mark) => {
      if (is(mark)) return take();
      if (is("U")) throw runs();
      return wrong(`“${mark}” is expected here`);
    };
    /** @param {number} from @param {Omit<Term, "at">} term @returns {Term} */
    const made = (from, term) => ({ ...term, at: [all[from].at[0], all[next - 1].at[1]] });

    /** @param {() => Term} part @param {string[]} ops */
    function chain(part, ops) {
      const from = next;
      let left = part();
      while (ops.includes(now().text)) {
        const op = take().text;
        left = made(from, { kind: "binary", op, args: [left, part()] });
      }
      return left;
    }

    /** @returns {Term} */
    function formula() {
      if (++depth > deepest) wrong("it nests too deep");
      const from = next, left = chain(conjunction, ["or"]);
      depth--;
      if (is("leads_to")) throw runs();
      if (!is("=>")) return left;
      take();
      return made(from, { kind: "binary", op: "=>", args: [left, formula()] });
    }

    const conjunction = () => chain(negation, ["and"]);

    /** @returns {Term} */
    function negation() {
      const from = next;
      if (!is("not")) return comparison();
      take();
      if (++depth > deepest) wrong("it nests too deep");
      const term = made(from, { kind: "not", args: [negation()] });
      depth--;
      return term;
    }

    function comparison() {
      const from = next, left = sum();
      if (!comparisons.includes(now().text)) return left;
      const op = take().text, right = sum();
      if (comparisons.includes(now().text)) wrong("comparisons are put together by `and`");
      return made(from, { kind: "compare", op, args: [left, right] });
    }

    const sum = () => chain(product, ["+", "-"]);
    const product = () => chain(factor, ["*", "/", "mod"]);

    /** @returns {Term} */
    function factor() {
      const from = next;
      if (!is("-")) return primary();
      take();
      if (++depth > deepest) wrong("it nests too deep");
      const term = made(from, { kind: "neg", args: [factor()] });
      depth--;
      return term;
    }

    /** @returns {Term} */
    function primary() {
      const from = next, token = now();
      if (token.kind === "number") {
        take();
        return made(from, { kind: "number", value: exact(token) });
      }
      if (is("(")) {
        take();
        const inner = formula();
        if (!is(",")) {
          expect(")");
          return component(from, inner);
        }
        take();
        const second = formula();
        expect(",");
        const third = formula();
        expect(")");
        return component(from, made(from, { kind: "vector", args: [inner, second, third] }));
      }
      if (is("true") || is("false")) return made(from, { kind: take().text });
      if (is("if")) {
        take();
        const condition = formula();
        expect("then");
        const yes = formula();
        expect("else");
        const no = formula();
        return made(from, { kind: "if", args: [condition, yes, no] });
      }
      if (is("count") && all[next + 1].text === "(") {
        take();
        take();
        const term = quantified(from, "count");
        expect(")");
        return term;
      }
      if (is("forall") || is("exists")) return quantified(from, take().text);
      if (is("~")) {
        take();
        return made(from, { kind: "co", name: take().text });
      }
      if (token.kind !== "name") wrong(token.kind === "end" ? "the formula ends here" : "a value is expected here");
      if (is("event")) wrong("events can be asked for where a page is served (scc serve)");
      if (temporal.has(token.text)) throw runs();
      if (words.has(token.text) && !(is("mod") && all[next + 1].text === "(")) wrong("a value is expected here");
      return name();
    }

    /**
     * A component of what stands before it, if one is asked for.
     * @param {number} from @param {Term} term @returns {Term}
     */
    function component(from, term) {
      if (!is(".")) return term;
      take();
      const axis = take();
      if (!/^[xyz]$/.test(axis.text)) throw new Wrong("a vector has the components x, y and z", axis.at);
      return made(from, { kind: "component", name: axis.text, args: [term] });
    }

    /** @param {number} from @param {string} what @returns {Term} */
    function quantified(from, what) {
      const variable = take();
      if (variable.kind !== "name" || words.has(variable.text)) throw new Wrong("a name is expected here", variable.at);
      expect("in");
      const low = sum();
      /** @type {Term[]} */
      let over = [low];
      if (is("..")) {
        take();
        over = [low, sum()];
      }
      let filter = null;
      if (is("if")) {
        take();
        filter = formula();
      }
      expect(":");
      return made(from, { kind: "each", op: what, name: variable.text, over, filter, args: [formula()] });
    }

    /** A name with its indices, a part of one, or a function. @returns {Term} */
    function name() {
      const from = next;
      /** @type {{ name: string, indices: Term[] }[]} */
      const segments = [];
      for (;;) {
        const token = take();
        if (token.kind !== "name") throw new Wrong("a name is expected here", token.at);
        /** @type {Term[]} */
        let indices = [];
        if (is("[")) {
          take();
          indices = list("]");
        } else if (is("(") && segments.every((one) => one.indices.length === 0)) {
          take();
          const args = is(")") ? [] : list(")", true);
          if (args.length === 0) take();
          return component(from, made(from, { kind: "call", name: [...segments.map((one) => one.name), token.text].join("."), args }));
        }
        segments.push({ name: token.text, indices });
        if (!is(".")) break;
        take();
      }
      return made(from, { kind: "path", args: segments.flatMap((s) => s.indices), name: JSON.stringify(segments.map((s) => [s.name, s.indices.length])) });
    }

    /** @param {string} close @param {boolean} [whole] whether truths can stand there */
    function list(close, whole) {
      const found = [whole ? formula() : sum()];
      while (is(",")) {
        take();
        found.push(whole ? formula() : sum());
      }
      expect(close);
      return found;
    }

    const term = formula();
    if (now().kind !== "end") {
      // What a probability or a mean is of stands in brackets.
      if (temporal.has(now().text) || is("[") || is("?")) throw runs();
      wrong("the formula ends before this");
    }
    return term;
  }

  return { read, Wrong };
})();
