"use strict";

/**
 * Elements of the page. Texts of a model become text nodes and attributes only, never markup.
 */
const Dom = (() => {
  /** @typedef {Node | string | null | undefined} Child */

  /**
   * A new element with attributes and children. `text` is its text, `test` its mark for tests, functions are
   * listeners; attributes that are null or false are left out.
   * @template {keyof HTMLElementTagNameMap} K
   * @param {K} tag
   * @param {{[name: string]: any}} [attributes]
   * @param {Child[]} [children]
   * @returns {HTMLElementTagNameMap[K]}
   */
  function make(tag, attributes, children) {
    const element = document.createElement(tag);
    dress(element, attributes || {});
    for (const child of children || []) if (child !== null && child !== undefined) element.append(child);
    return element;
  }

  /**
   * The same for drawings.
   * @param {string} tag
   * @param {{[name: string]: any}} [attributes]
   * @param {Child[]} [children]
   * @returns {SVGElement}
   */
  function draw(tag, attributes, children) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    dress(element, attributes || {});
    for (const child of children || []) if (child !== null && child !== undefined) element.append(child);
    return element;
  }

  /** @param {Element} element @param {{[name: string]: any}} attributes */
  function dress(element, attributes) {
    for (const name of Object.keys(attributes)) {
      const value = attributes[name];
      if (value === null || value === undefined || value === false) continue;
      if (typeof value === "function") element.addEventListener(name, value);
      else if (name === "text") element.textContent = value;
      else if (name === "test") element.setAttribute("data-testid", value);
      else element.setAttribute(name, value === true ? "" : String(value));
    }
  }

  /**
   * The element of the page with this identifier.
   * @param {string} id @returns {HTMLElement}
   */
  function get(id) {
    const element = document.getElementById(id);
    if (!element) throw new Error(`the page has no element ${id}`);
    return element;
  }

  /**
   * A text of the model on its own: its direction of writing does not touch what stands around it.
   * @param {string} text @param {string} [kind] a class
   */
  function name(text, kind) {
    return make("bdi", { text, class: kind || "name", title: text.length > 24 ? clip(text, 400) : null });
  }

  /**
   * At most so many characters of a text.
   * @param {string} text @param {number} length
   */
  function clip(text, length) {
    return text.length <= length ? text : text.slice(0, length - 1) + "…";
  }

  /**
   * A button.
   * @param {string} text @param {(event: MouseEvent) => void} press @param {{[name: string]: any}} [more]
   */
  function button(text, press, more) {
    return make("button", { type: "button", text, click: press, ...(more || {}) });
  }

  /** @param {Element} element @param {Child[]} children */
  function fill(element, ...children) {
    element.replaceChildren(
      ...children.filter((child) => child !== null && child !== undefined).map((c) => c || ""),
    );
  }

  /**
   * Offers a text, or bytes, as a file to save.
   * @param {string} file @param {string} type @param {string | Uint8Array} content
   */
  function save(file, type, content) {
    const address = URL.createObjectURL(new Blob([content], { type }));
    const link = make("a", { href: address, download: file });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  }

  /**
   * Sets the text of an element if it is another one: what has not changed is not announced again.
   * @param {Element} element @param {string} text
   */
  function tell(element, text) {
    if (element.textContent !== text) element.textContent = text;
  }

  return { make, draw, get, name, clip, button, fill, save, tell };
})();
