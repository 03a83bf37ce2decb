"use strict";

/** What a served page learns of its document while one looks at it: states that are reached, and what is possible there. */
const Grow = (() => {
  /** @type {Player} */
  let player;
  /**
   * Why states cannot be looked at.
   * @type {Map<number, string>}
   */
  const refused = new Map();
  const tables = /** @type {const} */ (["solids", "behaviours", "processes", "labels", "states"]);

  /** @param {Player} of */
  function start(of) {
    player = of;
  }

  /** @param {PageData} data @returns {Had} */
  function had(data) {
    const { solids, behaviours, processes, labels, states } = data;
    return {
      solids: solids.length, behaviours: behaviours.length, processes: processes.length, labels: labels.length,
      states: states.length,
    };
  }

  /**
   * Adds what an answer tells to what was had when it was asked for. Rows that have come meanwhile are the same.
   * @param {PageData} data @param {Had} since @param {DataMore} more
   */
  function add(data, since, more) {
    for (const table of tables) {
      /** @type {any[]} */
      const rows = data[table];
      more[table].forEach((/** @type {any} */ row, /** @type {number} */ i) => {
        const n = since[table] + i;
        if (n === rows.length) rows.push(row);
      });
    }
    for (const [n, state] of more.looked) data.states[n] = state;
  }

  /**
   * @template T
   * @param {string} method @param {object} params @param {(result: any) => T} found
   * @param {{ still?: () => boolean, first?: boolean }} how
   */
  function look(method, params, found, how) {
    /** @type {Had} */
    let have;
    const asked = () => ({ ...params, have: (have = had(player.data)) });
    const take = (/** @type {any} */ result) => {
      const known = player.data.behaviours.length;
      add(player.data, have, result.more);
      if (player.data.behaviours.length > known) Channels.learn(player.data);
      player.tell("grow");
      return found(result);
    };
    return Live.ask(method, asked, take, how);
  }

  /**
   * Learns what is possible in a state.
   * @param {number} state @param {{ still?: () => boolean, first?: boolean }} [how]
   * @returns {Promise<boolean | null>} whether it is known then
   */
  async function expand(state, how = {}) {
    if (!known(state) && !refused.has(state))
      try {
        return await look("document.expand", { state }, () => true, how);
      } catch (error) {
        refused.set(state, said(error));
        player.tell("grow");
      }
    return known(state);
  }

  /**
   * Whether all is known of what is possible in a state, and where it leads.
   * @param {number} state
   */
  function known(state) {
    const next = player.data.states[state].next;
    return next !== null && next.every((choice) => choice.to !== null);
  }

  /**
   * Learns where choices lead, as far as they are possible.
   * @param {number} state @param {number[]} choices
   */
  const walk = (state, choices) => look("document.walk", { state, choices }, () => true, { first: true });

  /**
   * Learns where the first choices lead, one after the other.
   * @param {number} state @param {number} most
   */
  const onwards = (state, most) => look("document.onwards", { state, most }, () => true, { first: true });

  /** @param {any} error */
  const said = (error) => String(error instanceof Error ? error.message : error);

  /**
   * Why a state cannot be looked at, if it was tried.
   * @param {number} state
   */
  const why = (state) => refused.get(state) || null;

  return { start, had, add, expand, known, walk, onwards, why, said };
})();
