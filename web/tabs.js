"use strict";

/** Panels of which one is seen at a time. */
const Tabs = (() => {
  /** @type {HTMLElement[]} */
  const panels = [];
  /** @type {HTMLButtonElement[]} */
  const heads = [];

  /** Makes the tabs of the page. */
  function start() {
    const bar = Dom.get("tabs");
    for (const panel of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(".tab"))) {
      const head = Dom.button(panel.dataset.title || panel.id, () => show(panel.id), {
        role: "tab",
        id: `${panel.id}-tab`,
        "aria-controls": panel.id,
        test: `tab-${panel.id}`,
      });
      panel.setAttribute("role", "tabpanel");
      panel.setAttribute("aria-labelledby", head.id);
      panel.setAttribute("tabindex", "0");
      panels.push(panel);
      heads.push(head);
      bar.append(head);
    }
    bar.addEventListener("keydown", (event) => {
      const at = heads.findIndex((head) => head.getAttribute("aria-selected") === "true");
      const move = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (move === 0) return;
      event.preventDefault();
      event.stopPropagation();
      const to = (at + move + heads.length) % heads.length;
      show(panels[to].id);
      heads[to].focus();
    });
    show(panels[0].id);
  }

  /** @param {string} id */
  function show(id) {
    panels.forEach((panel, i) => {
      const here = panel.id === id;
      panel.hidden = !here;
      heads[i].setAttribute("aria-selected", String(here));
      heads[i].tabIndex = here ? 0 : -1;
    });
    document.dispatchEvent(new CustomEvent("tab", { detail: id }));
  }

  /** Which panel is seen. */
  function shown() {
    const panel = panels.find((one) => !one.hidden);
    return panel ? panel.id : "";
  }

  return { start, show, shown };
})();
