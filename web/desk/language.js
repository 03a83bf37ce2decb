"use strict";

/** The words of the modelling language (specs/language.md), and how its texts are coloured. */
const Language = (() => {
  const words = (
    "A AF AG AX E EF EG EX F G U X absorb always and as at behaviour binding blocked bond bonds check choose collisions compound " +
    "count decompose dynamics else eps event eventually exists faces false fixed for forall glue grid hull if import in inertial leads_to " +
    "let local mass matrix merge mesh mod model motion network nil not omega on only or orient param part possibly process push " +
    "quaternion resolution rho rotate round scale scaled shape snap spin split_step steady then timestep translate true union " +
    "velocity vertices weight weld where within"
  ).split(" ");
  const known = new Set(words);
  // What follows them is a name.
  const declaring = new Set(
    "behaviour check compound fixed let model param part process shape forall exists for".split(" "),
  );
  const literal = new Set(["true", "false", "nil"]);
  const functions = new Set("min max abs sign floor ceil dot cross".split(" "));
  const name = /^[A-Za-zĀāĒēĪīŌōŪūȲȳḠḡ][A-Za-z0-9_'ĀāĒēĪīŌōŪūȲȳḠḡ\u0304\u0305]*/;
  const number = /^(?:2\^-\d+|\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)/;

  /** @typedef {{comments: number, depth: number, last: string}} State */

  /** @param {CmStream} stream @param {State} state */
  function comment(stream, state) {
    while (state.comments > 0 && !stream.eol()) {
      if (stream.match("/*")) state.comments += 1;
      else if (stream.match("*/")) state.comments -= 1;
      else stream.next();
    }
    return "comment";
  }

  /**
   * Words that are a single letter are so only where an operator stands: `A[f U g]`.
   * @param {string} word @param {string} last @param {CmStream} stream
   */
  function kind(word, last, stream) {
    if (last === "~" || (last === "<" && stream.match(/^\s*,\s*\{/, false))) return "channel";
    if (/[Āāēīōūȳḡ\u0304\u0305]/.test(word)) return "channel";
    if (declaring.has(last) && !(last === "for" && word === "all")) return "def";
    if (word === "A" || word === "E") return stream.peek() === "[" ? "keyword" : null;
    if (word === "F" || word === "G" || word === "X") return null;
    if (literal.has(word)) return "atom";
    if (known.has(word)) return "keyword";
    return functions.has(word) && stream.peek() === "(" ? "builtin" : null;
  }

  /** @param {CmStream} stream @param {State} state */
  function token(stream, state) {
    if (state.comments > 0) return comment(stream, state);
    if (stream.eatSpace()) return null;
    if (stream.match("//")) {
      stream.skipToEnd();
      return "comment";
    }
    if (stream.match("/*")) {
      state.comments = 1;
      return comment(stream, state);
    }
    const last = state.last;
    if (stream.match(/^"(?:[^"\\]|\\.)*"?/)) {
      state.last = '"';
      return "string";
    }
    if (stream.match(number)) {
      state.last = "0";
      return "number";
    }
    const found = stream.match(name);
    if (found) {
      state.last = found[0];
      return kind(found[0], last, stream);
    }
    if (stream.match(/^[ωρϱεϵ]/)) {
      state.last = "";
      return "keyword";
    }
    const sign = stream.next() || "";
    state.last = sign;
    if (/[[({]/.test(sign)) state.depth += 1;
    if (/[\])}]/.test(sign)) state.depth = Math.max(0, state.depth - 1);
    return /[<>⟨⟩=!+\-*/~|‖.·]/.test(sign) ? "operator" : null;
  }

  /** Tells CodeMirror. */
  function define() {
    CodeMirror.defineMode("shape-calculus", () => ({
      /** @returns {State} */
      startState: () => ({ comments: 0, depth: 0, last: "" }),
      copyState: (/** @type {State} */ state) => ({ ...state }),
      token,
      indent: (/** @type {State} */ state, /** @type {string} */ after) =>
        2 * Math.max(0, state.depth - (/^[\])}]/.test(after) ? 1 : 0)),
      electricInput: /^\s*[\])}]$/,
      lineComment: "//",
      blockCommentStart: "/*",
      blockCommentEnd: "*/",
      fold: "brace",
    }));
  }

  return { words, define };
})();
