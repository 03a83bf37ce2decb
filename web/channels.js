"use strict";

/** The colours of the scene, beside the names of bodies and channels. */
const Channels = (() => {
  /** @type {Map<string, [number, number, number]>} */
  let channels = new Map();
  /** @type {[number, number, number][]} */
  let leaves = [];

  /** @param {PageData} data */
  function start(data) {
    channels = Colors.ofChannels(data.behaviours);
    leaves = Colors.ofLeaves(data, data.leaves).map((leaf) => leaf.color);
  }

  /**
   * A patch of a colour.
   * @param {[number, number, number] | undefined} color @param {string} kind a class
   */
  function swatch(color, kind) {
    const made = Dom.make("span", { class: kind, "aria-hidden": "true" });
    const [r, g, b] = (color || [1, 1, 1]).map((part) => Math.round(255 * part));
    made.style.setProperty("--patch", `rgb(${r}, ${g}, ${b})`);
    return made;
  }

  /**
   * Of a channel; striped for a co-name, as in the scene.
   * @param {string} name @param {boolean} co
   */
  const patch = (name, co) => swatch(channels.get(name), co ? "patch co" : "patch");

  /**
   * Of a body.
   * @param {number} leaf
   */
  const body = (leaf) => swatch(leaves[leaf], "patch body");

  /**
   * More behaviours, and perhaps channels, are known.
   * @param {PageData} data
   */
  function learn(data) {
    channels = Colors.ofChannels(data.behaviours);
  }

  return { start, learn, patch, body };
})();
