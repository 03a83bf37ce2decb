"use strict";

/**
 * Questions to the program that serves the page, one after the other. A page that was opened from disk asks nobody.
 *
 * @typedef {{ method: string, params: () => object, take: (result: any) => any, still: () => boolean,
 *   done: (value: any) => void, fail: (why: Error) => void }} Question
 *   What is sent is made when its turn comes, and the answer is taken before the next question is made. What nobody waits
 *   for any more is not asked.
 */
const Live = (() => {
  const meta = typeof document === "undefined" ? null : document.querySelector('meta[name="scc-live"]');
  const address = meta ? meta.getAttribute("content") || "" : "";
  /** Whether the page is served. */
  const on = address !== "";
  /** @type {Question[]} */
  const waiting = [];
  /** @type {Question | null} */
  let asked = null;
  let count = 0;
  /** Why nothing can be asked any more. */
  let over = "";
  /** @type {HTMLElement} */
  let sign;
  /** @type {HTMLElement} */
  let notice;
  /** What is seen after so many milliseconds of waiting. */
  const patience = 150;

  /** An answer that says why there is none. */
  class Refusal extends Error {
    /** @param {{ code: number, message: string, data?: any }} error */
    constructor(error) {
      super(error.message);
      this.code = error.code;
      this.data = error.data || {};
    }
  }

  function start() {
    if (!on) return;
    sign = Dom.make("span", { class: "asking quiet", role: "status", test: "asking" });
    Dom.get("about").after(sign);
    notice = Dom.make("p", { class: "notice", role: "alert", hidden: true, test: "served" });
    Dom.get("notice").after(notice);
  }

  /**
   * Asks, and takes the answer. Null where nobody waits for it any more.
   * @template T
   * @param {string} method @param {() => object} params @param {(result: any) => T} take
   * @param {{ still?: () => boolean, first?: boolean }} [how] `first`: before what is waiting
   * @returns {Promise<T | null>}
   */
  function ask(method, params, take, how = {}) {
    return new Promise((done, fail) => {
      const question = { method, params, take, still: how.still || (() => true), done, fail };
      if (how.first) waiting.unshift(question);
      else waiting.push(question);
      if (!asked) work();
    });
  }

  async function work() {
    for (let next = waiting.shift(); next; next = waiting.shift()) {
      asked = next;
      const late = setTimeout(show, patience);
      try {
        next.done(next.still() ? await put(next) : null);
      } catch (error) {
        next.fail(error instanceof Error ? error : new Error(String(error)));
      }
      clearTimeout(late);
      asked = null;
      if (waiting.length === 0) Dom.tell(sign, "");
    }
  }

  function show() {
    Dom.tell(sign, "Looking…");
  }

  /** @param {number} ms */
  const pause = (ms) => new Promise((done) => setTimeout(done, ms));

  /**
   * Sends a question until there is an answer, or no use.
   * @param {Question} question
   */
  async function put(question) {
    const body = JSON.stringify({ jsonrpc: "2.0", id: (count += 1), method: question.method, params: question.params() });
    for (let lost = 0, tries = 0; over === ""; tries++) {
      if (tries > 0 && !question.still()) return null;
      let answer;
      try {
        answer = await fetch(address, { method: "POST", headers: { "content-type": "application/json" }, body });
      } catch (_) {
        // One request may be lost. Where the next one is, too, the program has ended, or the way to it is interrupted.
        lost += 1;
        if (lost > 1) tell("The program that serves this page does not answer. It is asked again and again.");
        await pause(lost > 1 ? Math.min(5000, 500 * lost) : 100);
        continue;
      }
      notice.hidden = true;
      if (answer.status === 503) await pause(Math.min(2000, 200 * (tries + 1)));
      else return read(question, answer);
    }
    throw new Error(over);
  }

  /** @param {Question} question @param {Response} answer */
  async function read(question, answer) {
    const told = await answer.json().catch(() => ({}));
    if (answer.ok && told.error) throw new Refusal(told.error);
    if (answer.ok) return question.take(told.result);
    const why = typeof told.error === "string" ? told.error : `the answer has the status ${answer.status}`;
    if (![403, 410, 504].includes(answer.status)) throw new Error(why);
    over = why;
    document.body.setAttribute("data-over", "true");
    tell(`This page is not served any more: ${why}. What is known stays, and can be looked at.`);
    throw new Error(over);
  }

  /** @param {string} text */
  function tell(text) {
    notice.hidden = false;
    Dom.tell(notice, text);
  }

  /** Whether something is asked, or waits to be. */
  const busy = () => asked !== null || waiting.length > 0;

  return { on, start, ask, busy, Refusal };
})();
