"use strict";

/**
 * A film as a file of WebM: one track of pictures, in clusters that begin with a picture that needs no other one.
 *
 * @typedef {{ data: Uint8Array, time: number, key: boolean }} Picture  time: in milliseconds.
 */
const Webm = (() => {
  /** @typedef {(number | Uint8Array)[]} Bytes */

  /**
   * A number in so few bytes as it needs.
   * @param {number} n
   */
  function natural(n) {
    const bytes = [];
    do {
      bytes.unshift(n % 256);
      n = Math.floor(n / 256);
    } while (n > 0);
    return Uint8Array.from(bytes);
  }

  /** @param {string} text */
  const ascii = (text) => new TextEncoder().encode(text);

  /** @param {number} x */
  function float(x) {
    const bytes = new Uint8Array(8);
    new DataView(bytes.buffer).setFloat64(0, x);
    return bytes;
  }

  /**
   * The length of an element, in eight bytes.
   * @param {number} n
   */
  function long(n) {
    const bytes = new Uint8Array(8);
    for (let i = 7, rest = n; i > 0; i--, rest = Math.floor(rest / 256)) bytes[i] = rest % 256;
    bytes[0] = 1;
    return bytes;
  }

  /** @param {Uint8Array[]} parts */
  function join(parts) {
    const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) {
      all.set(part, at);
      at += part.length;
    }
    return all;
  }

  /** @param {number} id @param {Uint8Array[]} content */
  function element(id, ...content) {
    const inside = join(content);
    return join([natural(id), long(inside.length), inside]);
  }

  /** A cluster lasts no longer, as times within it are of 16 bits. */
  const longest = 30000;

  /**
   * @param {Picture[]} pictures in the order of time @returns {Picture[][]}
   */
  function clusters(pictures) {
    /** @type {Picture[][]} */
    const all = [];
    for (const picture of pictures) {
      const last = all[all.length - 1];
      if (!last || picture.key || picture.time - last[0].time >= longest) all.push([picture]);
      else last.push(picture);
    }
    return all;
  }

  /** @param {Picture[]} pictures */
  function cluster(pictures) {
    const from = pictures[0].time;
    const block = (/** @type {Picture} */ { data, time, key }) => {
      const after = time - from;
      return element(0xa3, Uint8Array.of(0x81, (after >> 8) & 255, after & 255, key ? 0x80 : 0), data);
    };
    return element(0x1f43b675, element(0xe7, natural(from)), ...pictures.map(block));
  }

  /**
   * @param {Picture[]} pictures @param {{ width: number, height: number, codec: "V_VP8" | "V_VP9", duration: number }} film
   *   duration: in milliseconds
   */
  function file(pictures, { width, height, codec, duration }) {
    const head = element(0x1a45dfa3,
      element(0x4286, natural(1)), element(0x42f7, natural(1)), element(0x42f2, natural(4)), element(0x42f3, natural(8)),
      element(0x4282, ascii("webm")), element(0x4287, natural(2)), element(0x4285, natural(2)));
    const about = element(0x1549a966,
      element(0x2ad7b1, natural(1000000)), element(0x4489, float(duration)), element(0x4d80, ascii("scc")), element(0x5741, ascii("scc")));
    const tracks = element(0x1654ae6b, element(0xae,
      element(0xd7, natural(1)), element(0x73c5, natural(1)), element(0x9c, natural(0)), element(0x83, natural(1)),
      element(0x86, ascii(codec)), element(0xe0, element(0xb0, natural(width)), element(0xba, natural(height)))));
    const parts = clusters(pictures), bodies = parts.map(cluster);
    let at = about.length + tracks.length;
    const cues = element(0x1c53bb6b, ...parts.map((part, i) => {
      const cue = element(0xbb, element(0xb3, natural(part[0].time)), element(0xb7, element(0xf7, natural(1)), element(0xf1, natural(at))));
      at += bodies[i].length;
      return cue;
    }));
    return join([head, element(0x18538067, about, tracks, ...bodies, cues)]);
  }

  return { file };
})();
