"use strict";

/**
 * The text as the server has it, and as the editor has it: there lines end with "\n" alone, and places are counted in
 * UTF-16 units from the beginning; the server counts bytes of UTF-8. Line ends and the byte order mark of a file are kept.
 */
const Source = (() => {
  let end = "\n";
  let mark = "";

  /**
   * Learns from a file how its lines end. What it has most of is kept.
   * @param {string} text @returns {string} for the editor
   */
  function read(text) {
    mark = text.startsWith("\uFEFF") ? "\uFEFF" : "";
    const both = (text.match(/\r\n/g) || []).length;
    const all = (text.match(/\r\n?|\n/g) || []).length;
    end = 2 * both > all ? "\r\n" : "\n";
    return inner(text);
  }

  /** @param {string} text */
  function inner(text) {
    return text.replace(/^\uFEFF/, "").replace(/\r\n?/g, "\n");
  }

  /**
   * For the server, of what the editor has. Halves of characters, which no file can hold, become a mark.
   * @param {string} text
   */
  function outer(text) {
    const whole = text.replace(/[\uD800-\uDFFF]/gu, "\uFFFD");
    return mark + (end === "\n" ? whole : whole.replace(/\n/g, end));
  }

  /** @param {string} text @param {number} i */
  function bytesAt(text, i) {
    const unit = text.charCodeAt(i);
    if (unit === 10) return end.length;
    if (unit < 0x80) return 1;
    if (unit < 0x800) return 2;
    const next = unit >= 0xd800 && unit < 0xdc00 ? text.charCodeAt(i + 1) : 0;
    return next >= 0xdc00 && next < 0xe000 ? 4 : 3;
  }

  /**
   * Where bytes are in the text of the editor; the text is gone through once for all of them.
   * @param {string} text @param {number[]} offsets @returns {number[]}
   */
  function places(text, offsets) {
    const order = offsets.map((_, k) => k).sort((a, b) => offsets[a] - offsets[b]);
    const found = offsets.slice();
    let i = 0;
    let at = mark === "" ? 0 : 3;
    for (const k of order) {
      while (i < text.length && at < offsets[k]) {
        const bytes = bytesAt(text, i);
        at += bytes;
        i += bytes === 4 ? 2 : 1;
      }
      found[k] = i;
    }
    return found;
  }

  /**
   * The byte at which a place of the editor's text is.
   * @param {string} text @param {number} place
   */
  function offset(text, place) {
    let at = mark === "" ? 0 : 3;
    for (let i = 0; i < place; ) {
      const bytes = bytesAt(text, i);
      at += bytes;
      i += bytes === 4 ? 2 : 1;
    }
    return at;
  }

  /**
   * A short number by which equal texts are known within a tab.
   * @param {string} text
   */
  function sum(text) {
    let a = 0xdeadbeef;
    let b = 0x41c6ce57;
    for (let i = 0; i < text.length; i++) {
      const unit = text.charCodeAt(i);
      a = Math.imul(a ^ unit, 2654435761);
      b = Math.imul(b ^ unit, 1597334677);
    }
    return `${text.length}.${(a >>> 0).toString(36)}.${(b >>> 0).toString(36)}`;
  }

  const ends = () => (end === "\n" ? "LF" : "CRLF");

  return { read, inner, outer, places, offset, sum, ends };
})();
