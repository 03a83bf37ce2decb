"use strict";

/**
 * What a tab keeps over a reload: the text that is not saved and which version of the file it came from, and the
 * documents that are shown.
 */
const Keep = (() => {
  /**
   * @typedef {{text: string | null, saved: string | null, server: string, documents: any, link: string,
   *            automatic: boolean}} Kept
   */
  let name = "scc-desk";
  let timer = 0;
  /** @type {() => Kept} */
  let make;
  let full = false;

  /** @param {string} file @param {() => Kept} how */
  function start(file, how) {
    name = `scc-desk ${file}`;
    make = how;
    window.addEventListener("pagehide", write);
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") write();
    });
  }

  /** @returns {Kept | null} */
  function read() {
    try {
      const kept = JSON.parse(window.sessionStorage.getItem(name) || "null");
      return kept !== null && typeof kept === "object" ? kept : null;
    } catch (_) {
      return null;
    }
  }

  function later() {
    window.clearTimeout(timer);
    timer = window.setTimeout(write, 400);
  }

  function write() {
    window.clearTimeout(timer);
    try {
      window.sessionStorage.setItem(name, JSON.stringify(make()));
      if (full) Notices.close("full");
      full = false;
    } catch (_) {
      if (!full)
        Notices.show("full", "The browser has no room to keep this text over a reload: save it before.");
      full = true;
    }
  }

  return { start, read, later, write };
})();
