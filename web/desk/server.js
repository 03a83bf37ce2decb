"use strict";

/**
 * Requests to the server of the page. While it does not answer, all who wait go on waiting, and it is tried again
 * every two seconds.
 */
const Server = (() => {
  const between = 2000;
  /** @type {Promise<void> | null} resolved when the server is back, while it does not answer */
  let back = null;
  /** @type {(away: boolean, why: string) => void} */
  let told = () => {};
  let leaving = false;
  /** The milliseconds of the last answer. */
  let took = 0;

  /** The server does not answer, or does not know this page any more. */
  class Away extends Error {}

  /** @param {number} ms @returns {Promise<void>} */
  const pause = (ms) => new Promise((done) => window.setTimeout(done, ms));

  /** @param {(away: boolean, why: string) => void} hear */
  function start(hear) {
    told = hear;
    // Requests that end because the page does say nothing of the server.
    window.addEventListener("pagehide", () => {
      leaving = true;
    });
    window.addEventListener("pageshow", () => {
      leaving = false;
    });
  }

  /**
   * @param {string} path @param {any} body
   * @returns {Promise<{status: number, body: any}>}
   */
  async function once(path, body) {
    const begun = performance.now();
    const answer = await window.fetch(path, {
      method: "POST",
      headers: { "content-type": "application/json" },
      body: JSON.stringify(body),
      cache: "no-store",
    });
    const read = await answer.json();
    took = performance.now() - begun;
    return { status: answer.status, body: read };
  }

  /** A request that changes nothing, to hear whether there is somebody. */
  const greeting = { jsonrpc: "2.0", id: 0, method: "service.describe" };

  async function untilBack() {
    for (;;) {
      await pause(between);
      try {
        const { status } = await once("ask", greeting);
        if (status !== 403) break;
        told(true, "Another service answers at this address: the one of this page has ended.");
      } catch (_) {
        // Not yet.
      }
    }
    back = null;
    told(false, "");
  }

  /** @param {string} why */
  function lost(why) {
    if (leaving) return;
    if (!back) {
      told(true, why);
      back = untilBack();
    }
  }

  /**
   * An answer, whatever its status.
   * @param {string} path @param {any} body
   * @returns {Promise<{status: number, body: any}>}
   */
  async function attempt(path, body) {
    for (let tried = 0; ; tried++) {
      let answer;
      try {
        answer = await once(path, body);
      } catch (_) {
        lost("The server does not answer.");
        throw new Away("the server does not answer");
      }
      if (answer.status === 403) {
        lost("Another service answers at this address: the one of this page has ended.");
        throw new Away("the server of this page has ended");
      }
      if (answer.status !== 503 || tried >= 20) return answer;
      await pause(Math.min(2000, 100 * 2 ** tried));
    }
  }

  /**
   * The same, as often as is needed until the server answers: for what may be asked twice.
   * @param {string} path @param {any} body
   */
  async function post(path, body) {
    for (;;) {
      try {
        return await attempt(path, body);
      } catch (error) {
        if (!(error instanceof Away)) throw error;
        if (leaving) return { status: 0, body: { error: "the page is left" } };
        await back;
      }
    }
  }

  let count = 0;

  /**
   * A question to the process that helps who writes: its result, or its error.
   * @param {string} method @param {any} params
   * @returns {Promise<{result: any} | {error: {code: number, message: string, data: any}}>}
   */
  async function ask(method, params) {
    count += 1;
    const { status, body } = await post("ask", { jsonrpc: "2.0", id: count, method, params });
    if (status === 200 && "result" in body) return { result: body.result };
    if (status === 200 && body.error) return { error: body.error };
    return { error: { code: status, message: String(body.error), data: {} } };
  }

  return { start, attempt, post, ask, pause, Away, away: () => back !== null, took: () => took };
})();
