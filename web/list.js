"use strict";

/**
 * A list of any length of which only the rows in view are elements. It is a listbox: the arrows move in it,
 * and a
 * screen reader is told how long it is.
 */
class List {
  /**
   * @param {HTMLElement} box where it goes
   * @param {{label: string, height: number, row: (index: number, row: HTMLElement) => void,
   *          choose: (index: number) => void, step?: (index: number) => void, name?: (index: number) => number, empty?: string,
   *          test?: string}}
   * options
   *        `row` fills the element of a row; `choose` is called when the user points at one, `step` when keys
   * lead
   *        to one (`choose`, if it is not given)
   */
  constructor(box, options) {
    this.options = options;
    this.count = 0;
    this.current = -1;
    List.made += 1;
    this.id = `list-${List.made}`;
    this.inner = Dom.make("div", { class: "list-inner", role: "presentation" });
    this.box = Dom.make(
      "div",
      {
        class: "list",
        role: "listbox",
        tabindex: "0",
        "aria-label": options.label,
        test: options.test,
        scroll: () => this.draw(),
        keydown: (/** @type {KeyboardEvent} */ event) => this.key(event),
      },
      [this.inner],
    );
    this.nothing = Dom.make("p", { class: "empty", text: options.empty || "Nothing.", hidden: true });
    box.append(this.box, this.nothing);
    /** @type {Map<number, HTMLElement>} */
    this.rows = new Map();
    new ResizeObserver(() => this.draw()).observe(this.box);
  }

  /** @param {number} count @param {number} current the row that is marked, or -1 */
  show(count, current) {
    this.count = count;
    this.current = current;
    this.box.hidden = count === 0;
    this.nothing.hidden = count > 0;
    this.inner.style.height = `${count * this.options.height}px`;
    for (const row of this.rows.values()) row.remove();
    this.rows.clear();
    this.reveal();
    this.draw();
  }

  /**
   * Marks another row.
   * @param {number} current
   */
  mark(current) {
    if (current === this.current) return;
    this.dress(this.rows.get(this.current), false);
    this.current = current;
    this.dress(this.rows.get(current), true);
    this.reveal();
    this.draw();
  }

  /** Fills the rows anew. */
  refresh() {
    for (const [index, row] of this.rows) {
      row.replaceChildren();
      this.options.row(index, row);
    }
  }

  /** Scrolls as far as is needed to see the marked row. */
  reveal() {
    if (this.current < 0) return;
    const { height } = this.options;
    const top = this.current * height;
    const seen = this.box.clientHeight;
    if (top < this.box.scrollTop) this.box.scrollTop = Math.max(0, top - height);
    else if (top + height > this.box.scrollTop + seen) this.box.scrollTop = top + 2 * height - seen;
  }

  draw() {
    const { height } = this.options;
    const first = Math.max(0, Math.floor(this.box.scrollTop / height) - 4);
    const last = Math.min(this.count, Math.ceil((this.box.scrollTop + this.box.clientHeight) / height) + 4);
    for (const [index, row] of this.rows) {
      if (index >= first && index < last) continue;
      row.remove();
      this.rows.delete(index);
    }
    for (let index = first; index < last; index++) {
      if (!this.rows.has(index)) this.make(index);
    }
    if (this.rows.has(this.current))
      this.box.setAttribute("aria-activedescendant", `${this.id}-${this.current}`);
    else this.box.removeAttribute("aria-activedescendant");
  }

  /** @param {number} index */
  make(index) {
    const row = Dom.make("div", {
      class: "row",
      role: "option",
      id: `${this.id}-${index}`,
      "aria-setsize": this.count,
      "aria-posinset": index + 1,
      "data-index": this.options.name ? this.options.name(index) : index,
      click: () => this.options.choose(index),
    });
    row.style.top = `${index * this.options.height}px`;
    row.style.height = `${this.options.height}px`;
    this.options.row(index, row);
    this.dress(row, index === this.current);
    this.rows.set(index, row);
    const after = [...this.rows.keys()].filter((other) => other > index);
    const next = after.length === 0 ? null : this.rows.get(Math.min(...after)) || null;
    this.inner.insertBefore(row, next);
  }

  /** @param {HTMLElement | undefined} row @param {boolean} here */
  dress(row, here) {
    if (!row) return;
    row.classList.toggle("here", here);
    row.setAttribute("aria-selected", String(here));
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const page = Math.max(1, Math.floor(this.box.clientHeight / this.options.height) - 1);
    /** @type {{[key: string]: number}} */
    const moves = {
      ArrowDown: 1,
      ArrowUp: -1,
      PageDown: page,
      PageUp: -page,
      Home: -this.count,
      End: this.count,
    };
    const move = moves[event.key];
    if (move === undefined || this.count === 0) return;
    event.preventDefault();
    event.stopPropagation();
    (this.options.step || this.options.choose)(Math.max(0, Math.min(this.count - 1, this.current + move)));
  }
}
List.made = 0;
