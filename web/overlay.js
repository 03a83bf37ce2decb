"use strict";

/** Words and small drawings over the picture: names, numbers of the floor, which way the axes go, a scale, a legend. */
class Overlay {
  /** How high a row of the legend is. */
  static row = 17;
  /**
   * Where the legend can be.
   * @typedef {"left" | "right" | "low left" | "low right"} Corner
   * @type {Corner[]}
   */
  static corners = ["left", "right", "low left", "low right"];

  /** @param {HTMLElement} box */
  constructor(box) {
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("aria-hidden", "true");
    Object.assign(this.canvas.style,
      { position: "absolute", inset: "0", width: "100%", height: "100%", pointerEvents: "none" });
    box.append(this.canvas);
    this.pen = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    this.colors = Colors.theme(false);
    this.width = 0;
    this.height = 0;
    /**
     * Where words are already.
     * @type {number[][]}
     */
    this.taken = [];
    const family = getComputedStyle(box).fontFamily;
    this.font = family && family.length < 300 ? family : "sans-serif";
  }

  /** @param {number} width @param {number} height @param {number} ratio @param {ReturnType<typeof Colors.theme>} colors */
  begin(width, height, ratio, colors) {
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    this.width = width;
    this.height = height;
    this.colors = colors;
    this.taken = [];
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.pen.clearRect(0, 0, width, height);
    this.pen.textBaseline = "middle";
    this.pen.lineJoin = "round";
  }

  /** @param {string} text */
  static clip(text) {
    return text.length > 48 ? text.slice(0, 47) + "…" : text;
  }

  /**
   * A word, with a seam of the background around it. False where another one is already.
   * @param {string} text @param {number} x @param {number} y
   * @param {{ size?: number, color?: string, align?: "center" | "left" | "right", strong?: boolean, force?: boolean,
   *   within?: boolean }} [style] within: it is moved so that all of it is seen
   */
  word(text, x, y, style = {}) {
    const { size = 11, color = this.colors.quiet, align = "center", strong = false, force = false } = style;
    const pen = this.pen, said = Overlay.clip(text);
    pen.font = `${strong ? "600 " : ""}${size}px ${this.font}`;
    const wide = pen.measureText(said).width;
    let left = align === "center" ? x - wide / 2 : align === "right" ? x - wide : x;
    if (style.within) left = Math.max(4, Math.min(this.width - wide - 4, left));
    const room = [left - 3, y - size / 2 - 2, left + wide + 3, y + size / 2 + 2];
    if (room[2] < 0 || room[0] > this.width || room[3] < 0 || room[1] > this.height) return false;
    const meets = (/** @type {number[]} */ t) => t[0] < room[2] && room[0] < t[2] && t[1] < room[3] && room[1] < t[3];
    if (!force && this.taken.some(meets)) return false;
    this.taken.push(room);
    pen.textAlign = "left";
    pen.lineWidth = 3;
    pen.strokeStyle = this.colors.halo;
    pen.globalAlpha = 0.85;
    pen.strokeText(said, left, y);
    pen.globalAlpha = 1;
    pen.fillStyle = color;
    pen.fillText(said, left, y);
    return true;
  }

  /**
   * Which way the axes go, in the corner.
   * @param {number[]} matrix of the camera: its first column points right, its second up, its third to the viewer
   */
  axes(matrix) {
    const x0 = this.width - 42, y0 = 42, long = 22, pen = this.pen;
    const all = [0, 1, 2].map((i) => ({
      name: "xyz"[i], color: Colors.css([this.colors.x, this.colors.y, this.colors.z][i]),
      x: matrix[i], y: -matrix[4 + i], depth: matrix[8 + i],
    }));
    pen.lineWidth = 2;
    pen.lineCap = "round";
    for (const a of all.sort((p, q) => p.depth - q.depth)) {
      pen.strokeStyle = a.color;
      pen.globalAlpha = a.depth < -0.2 ? 0.6 : 1;
      pen.beginPath();
      pen.moveTo(x0, y0);
      pen.lineTo(x0 + long * a.x, y0 + long * a.y);
      pen.stroke();
      pen.globalAlpha = 1;
      this.word(a.name, x0 + 1.42 * long * a.x, y0 + 1.42 * long * a.y, { color: a.color, strong: true, force: true });
    }
  }

  /**
   * How long something is, in the corner.
   * @param {number} pixels @param {string} text @param {number} margin how much of the picture is covered from below
   */
  scale(pixels, text, margin) {
    const right = this.width - 18, y = this.height - 16 - margin, pen = this.pen;
    if (!(pixels > 4 && pixels < this.width)) return;
    pen.strokeStyle = this.colors.quiet;
    pen.lineWidth = 1.5;
    pen.lineCap = "butt";
    pen.beginPath();
    pen.moveTo(right - pixels, y - 4);
    pen.lineTo(right - pixels, y);
    pen.lineTo(right, y);
    pen.lineTo(right, y - 4);
    pen.stroke();
    this.word(text, right - pixels / 2, y - 10, { force: true });
    this.taken.push([right - pixels - 8, y - 20, this.width, y + 16]);
  }

  /**
   * What time it is, in the corner.
   * @param {string} text
   */
  clock(text) {
    this.word(text, 14, this.height - 16, { size: 13, strong: true, align: "left", color: this.colors.text, force: true });
  }

  /**
   * How wide a legend is.
   * @param {{ text: string }[]} entries
   */
  long(entries) {
    this.pen.font = `11px ${this.font}`;
    return 30 + Math.max(...entries.slice(0, 100).map(({ text }) => this.pen.measureText(Overlay.clip(text)).width));
  }

  /**
   * Where a legend is in a corner: left, above, right, below; and how many of its rows have room there.
   * @param {{ text: string }[]} entries @param {Corner} corner @param {number} margin how much is covered from below
   */
  room(entries, corner, margin) {
    // Beside the arrows of the axes, and above the scale.
    const above = corner === "right" ? 92 : 0, below = (corner === "left" ? 90 : corner === "right" ? 50 : 24) + margin;
    const rows = Math.max(0, Math.min(entries.length, Math.floor((this.height - above - below) / Overlay.row)));
    const wide = this.long(entries), x = corner === "right" || corner === "low right" ? this.width - wide : 0;
    const y = corner === "left" || corner === "right" ? above : this.height - margin - (corner === "low right" ? 44 : 20) - rows * Overlay.row;
    return { box: [x, y, x + wide, y + 10 + rows * Overlay.row], rows };
  }

  /**
   * What colours and patterns mean.
   * @param {{ text: string, color: number[], shape: "body" | "name" | "co" }[]} entries
   * @param {Corner} corner @param {number} margin how much of the picture is covered from below
   */
  legend(entries, corner, margin) {
    const pen = this.pen, { box: [left, top], rows: most } = this.room(entries, corner, margin);
    entries.slice(0, most).forEach(({ text, color, shape }, i) => {
      const more = i + 1 === most && entries.length > most;
      const x = left + 14, y = top + 18 + i * Overlay.row;
      if (!more) this.#swatch(x, y, color, shape);
      this.word(more ? `${entries.length - i} more` : text, x + 12, y,
        { align: "left", color: this.colors.text, force: true });
    });
    pen.globalAlpha = 1;
  }

  /** @param {number} x @param {number} y @param {number[]} color @param {string} shape */
  #swatch(x, y, color, shape) {
    const pen = this.pen, r = 5;
    pen.fillStyle = Colors.css(color);
    pen.fillRect(x - r, y - r, 2 * r, 2 * r);
    pen.strokeStyle = shape === "body" ? this.colors.quiet : this.colors.text;
    pen.lineWidth = 1;
    pen.strokeRect(x - r, y - r, 2 * r, 2 * r);
    if (shape !== "co") return;
    pen.strokeStyle = Colors.css(this.colors.plate);
    pen.setLineDash([2.5, 2.5]);
    pen.lineWidth = 2.5;
    pen.strokeRect(x - r + 1, y - r + 1, 2 * r - 2, 2 * r - 2);
    pen.setLineDash([]);
    pen.fillStyle = this.colors.halo;
    pen.fillRect(x - 2, y - 2, 4, 4);
  }
}
