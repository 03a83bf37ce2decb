"use strict";

/** Colours of channels: in the scene, where they are open, and beside their names. */
const Channels = (() => {
  /** @type {Map<string, [number, number, number]>} */
  let colors = new Map();

  /** @param {PageData} data */
  function start(data) {
    colors = Colors.ofChannels(data.behaviours);
  }

  /**
   * A patch of the colour that the scene shows; a striped frame for a co-name, as there.
   * @param {string} name @param {boolean} co
   */
  function patch(name, co) {
    const made = Dom.make("span", { class: co ? "patch co" : "patch", "aria-hidden": "true" });
    made.style.setProperty("--patch", Colors.css(colors.get(name) || [1, 1, 1]));
    return made;
  }

  return { start, patch };
})();
