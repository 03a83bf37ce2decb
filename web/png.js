"use strict";

/** How large a picture of PNG is on paper. */
const Png = (() => {
  /** @param {Uint8Array} bytes */
  function checksum(bytes) {
    let c = 0xffffffff;
    for (const byte of bytes) {
      c ^= byte;
      for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
    }
    return (c ^ 0xffffffff) >>> 0;
  }

  /**
   * The same picture, with so many pixels in an inch.
   * @param {Uint8Array} png @param {number} dpi
   */
  function sized(png, dpi) {
    const chunk = new Uint8Array(21), view = new DataView(chunk.buffer), metre = Math.round(dpi / 0.0254);
    view.setUint32(0, 9);
    chunk.set(new TextEncoder().encode("pHYs"), 4);
    view.setUint32(8, metre);
    view.setUint32(12, metre);
    chunk[16] = 1;
    view.setUint32(17, checksum(chunk.subarray(4, 17)));
    // It comes after the head: 8 bytes of the file, and 25 of the first chunk.
    const all = new Uint8Array(png.length + chunk.length);
    all.set(png.subarray(0, 33));
    all.set(chunk, 33);
    all.set(png.subarray(33), 33 + chunk.length);
    return all;
  }

  return { sized };
})();
