"use strict";

/** A list in which arrows move, as high as its texts are. */
class Rows {
  /**
   * @param {HTMLElement} box
   * @param {{label: string, empty: string, test: string, step?: (index: number) => void, choose: (index: number) => void}} options
   *        `step`: the arrows lead to a row; `choose`: it is pressed, or Enter is
   */
  constructor(box, options) {
    this.options = options;
    this.current = -1;
    /** @type {HTMLElement[]} */
    this.rows = [];
    this.list = Dom.make("div", {
      class: "rows",
      role: "listbox",
      tabindex: "0",
      "aria-label": options.label,
      test: options.test,
      keydown: (/** @type {KeyboardEvent} */ event) => this.key(event),
    });
    this.nothing = Dom.make("p", { class: "empty", text: options.empty });
    box.append(this.list, this.nothing);
    this.fill([]);
  }

  /** @param {HTMLElement[]} rows @param {string} [empty] what is said where there are none */
  fill(rows, empty) {
    const kept = this.current < rows.length ? this.current : -1;
    this.rows = rows;
    rows.forEach((row, index) => {
      row.setAttribute("role", "option");
      row.id = `${this.options.test}-${index}`;
      row.addEventListener("click", () => {
        this.mark(index);
        this.options.choose(index);
      });
    });
    this.list.replaceChildren(...rows);
    this.list.hidden = rows.length === 0;
    this.nothing.hidden = rows.length > 0;
    if (empty !== undefined) Dom.tell(this.nothing, empty);
    this.current = -1;
    this.mark(kept);
  }

  /** @param {number} index */
  mark(index) {
    this.current = index;
    this.rows.forEach((row, k) => {
      row.classList.toggle("here", k === index);
      row.setAttribute("aria-selected", String(k === index));
    });
    const row = this.rows[index];
    if (row) {
      this.list.setAttribute("aria-activedescendant", row.id);
      row.scrollIntoView({ block: "nearest" });
    } else this.list.removeAttribute("aria-activedescendant");
  }

  /** @param {number} by */
  step(by) {
    if (this.rows.length === 0) return;
    const next = Math.max(0, Math.min(this.rows.length - 1, this.current + by));
    this.mark(next);
    if (this.options.step) this.options.step(next);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    /** @type {{[key: string]: number}} */
    const moves = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8, Home: -this.rows.length, End: this.rows.length };
    if (moves[event.key] !== undefined) this.step(moves[event.key]);
    else if (event.key === "Enter" && this.current >= 0) this.options.choose(this.current);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
