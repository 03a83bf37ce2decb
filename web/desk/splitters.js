"use strict";

/** Lines between two parts of the page, moved by the mouse or by arrows. */
const Splitters = (() => {
  /**
   * @param {HTMLElement} line @param {HTMLElement} whole what is parted
   * @param {{property: string, across: boolean, least: number, most: number, first: number}} how
   *        the part of the first side in percent, told to the style as `property`; `across`: sides are beside each other
   */
  function make(line, whole, how) {
    const name = `scc-desk ${how.property}`;
    let part = how.first;

    /** @param {number} to */
    function set(to) {
      part = Math.max(how.least, Math.min(how.most, to));
      whole.style.setProperty(how.property, `${part}%`);
      line.setAttribute("aria-valuenow", String(Math.round(part)));
    }

    function keep() {
      try {
        window.localStorage.setItem(name, String(part));
      } catch (_) {
        // Then it is so until the page is left.
      }
    }

    /** @param {PointerEvent} event */
    function move(event) {
      const { left, top, width, height } = whole.getBoundingClientRect();
      set(how.across ? (100 * (event.clientX - left)) / width : (100 * (event.clientY - top)) / height);
    }

    line.setAttribute("aria-valuemin", String(how.least));
    line.setAttribute("aria-valuemax", String(how.most));
    line.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      line.focus();
      line.setPointerCapture(event.pointerId);
      document.body.classList.add("dragging");
    });
    line.addEventListener("pointermove", (event) => {
      if (line.hasPointerCapture(event.pointerId)) move(event);
    });
    for (const end of ["pointerup", "pointercancel"])
      line.addEventListener(end, () => {
        document.body.classList.remove("dragging");
        keep();
      });
    line.addEventListener("dblclick", () => {
      set(how.first);
      keep();
    });
    line.addEventListener("keydown", (event) => {
      /** @type {{[key: string]: number}} */
      const moves = {
        [how.across ? "ArrowLeft" : "ArrowUp"]: part - 2,
        [how.across ? "ArrowRight" : "ArrowDown"]: part + 2,
        Home: how.least,
        End: how.most,
        Enter: how.first,
      };
      if (moves[event.key] === undefined) return;
      event.preventDefault();
      set(moves[event.key]);
      keep();
    });
    let before = NaN;
    try {
      before = parseFloat(window.localStorage.getItem(name) || "");
    } catch (_) {
      // As at first.
    }
    set(Number.isFinite(before) ? before : how.first);
  }

  return { make };
})();
