"use strict";

/** Lays a graph out beside the page, in a worker, so that one goes on meanwhile. */
const Aside = (() => {
  /** So many nodes and edges are placed at once, without a worker. */
  const few = 600;
  /** @type {Worker | null | undefined} null where there can be none */
  let worker;
  /** @type {Map<number, (placed: ReturnType<typeof Layers.place>) => void>} */
  let waiting = new Map();
  let asked = 0;

  /** The worker's text is that of the script of this page that has `Layers`. */
  function start() {
    const script = [...document.scripts].find((one) => (one.textContent || "").includes("\nconst Layers = "));
    if (!script) return null;
    const text = `${script.textContent}\nonmessage = ({ data }) => postMessage([data[0], Layers.place(data[1])]);`;
    try {
      const address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
      const made = new Worker(address);
      made.onmessage = ({ data: [number, placed] }) => {
        const answer = waiting.get(number);
        waiting.delete(number);
        if (answer) answer(placed);
      };
      made.onerror = () => {
        // Not allowed here: what waits is done by the page itself.
        worker = null;
        const lost = waiting;
        waiting = new Map();
        for (const [number, again] of redo) if (lost.has(number)) again();
        redo.clear();
      };
      return made;
    } catch (_) {
      return null;
    }
  }

  /** @type {Map<number, () => void>} */
  const redo = new Map();

  /**
   * Calls `then` with the places, at once where there are few nodes. Only the last request is answered.
   * @param {Parameters<typeof Layers.place>[0]} wanted @param {(placed: ReturnType<typeof Layers.place>) => void} then
   */
  function place(wanted, then) {
    waiting.clear();
    redo.clear();
    asked += 1;
    const number = asked;
    if (wanted.count + wanted.edges.length <= few) return then(Layers.place(wanted));
    if (worker === undefined) worker = start();
    if (!worker) return then(Layers.place(wanted));
    waiting.set(number, then);
    redo.set(number, () => then(Layers.place(wanted)));
    worker.postMessage([number, wanted]);
  }

  return { place };
})();
