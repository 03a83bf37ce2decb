"use strict";

/** Colours of channels: in the scene, where they are open, and beside their names. */
const Channels = (() => {
  /**
   * The hue of a channel, from 0 to 1.
   * @param {string} name
   */
  function hue(name) {
    let hash = 0;
    for (const c of name) hash = (hash * 31 + c.charCodeAt(0)) % 997;
    return (hash % 12) / 12 + 0.04;
  }

  /**
   * A patch of the colour that the scene shows; striped for a co-name, as there.
   * @param {string} name @param {boolean} co
   */
  function patch(name, co) {
    const made = Dom.make("span", { class: co ? "patch co" : "patch", "aria-hidden": "true" });
    made.style.setProperty("--hue", String(Math.round(hue(name) * 360) % 360));
    return made;
  }

  return { hue, patch };
})();
