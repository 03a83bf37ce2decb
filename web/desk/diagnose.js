"use strict";

/**
 * Reads the text as one types: when it has not changed for a moment, one question at a time, and the longer an answer
 * takes, the more seldom it is asked for. An answer about an older text is not shown.
 */
const Diagnose = (() => {
  const shortest = 250;
  const longest = 5000;
  // Answers that say what cannot be looked at here, and nothing of the text.
  const elsewhere = new Set(["SC0902", "SC0903"]);
  /** @type {Writing} */
  let editor;
  /** @type {(sound: boolean) => void} */
  let told;
  let timer = 0;
  let took = 0;
  let busy = false;
  let changes = 0;
  let read = -1;

  /**
   * What the command line says of parameters.
   * @type {{[name: string]: any}}
   */
  let parameters = {};

  /**
   * @param {Writing} of @param {{[name: string]: any}} given values and ranges of parameters
   * @param {(sound: boolean) => void} hear whether the text has no errors
   */
  function start(of, given, hear) {
    editor = of;
    parameters = given;
    told = hear;
    editor.on("change", () => {
      changes += 1;
      later();
    });
    run();
  }

  function later() {
    window.clearTimeout(timer);
    timer = window.setTimeout(run, Math.min(longest, Math.max(shortest, 2 * took)));
  }

  async function run() {
    if (busy) return;
    busy = true;
    const of = changes;
    const text = editor.text();
    const answer = await Server.ask("model.load", { text: Source.outer(text), parameters, start: "simple" });
    took = Server.took();
    if ("result" in answer) await Server.ask("model.release", { model: answer.result.model });
    busy = false;
    if (of !== changes) return later();
    read = of;
    learn(text, answer);
  }

  /** @param {string} text @param {any} answer */
  function learn(text, answer) {
    if (answer.result) {
      Commands.checks(answer.result.checks.map((/** @type {{name: string}} */ one) => one.name));
      result(answer.result.warnings, true);
      return;
    }
    const { code, message, data } = answer.error;
    const diagnostics = data && data.diagnostics;
    if (!diagnostics) {
      Problems.unread();
      told(false);
      Notices.show("unread", `The text is not read as you type: ${message}.`);
      return;
    }
    const real = diagnostics.filter((/** @type {Diagnostic} */ d) => !elsewhere.has(d.code));
    const sound = !real.some((/** @type {Diagnostic} */ d) => d.severity === "error");
    if (sound) Commands.checks(names(text));
    result(real, sound);
  }

  /**
   * The checks of a text that is only read.
   * @param {string} text
   */
  function names(text) {
    return [...text.matchAll(/^\s*check\s+([A-Za-z][A-Za-z0-9_']*)\s*:/gm)].map((found) => found[1]);
  }

  /** @param {Diagnostic[]} diagnostics @param {boolean} sound */
  function result(diagnostics, sound) {
    Notices.close("unread");
    Problems.set("typed", diagnostics);
    told(sound);
  }

  return { start, fresh: () => read === changes };
})();
