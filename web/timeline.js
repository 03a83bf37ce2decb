"use strict";

/**
 * The line of time: each event as a tick, those of one instant one above the other; the part of it that is
 * seen, which
 * the plots share.
 */
const Timeline = (() => {
  /** Free at both sides of the line, in pixels; the plots leave the same. */
  const margin = 14;
  /** @type {Player} */
  let player;
  /** @type {HTMLElement} */
  let box;
  /** @type {HTMLCanvasElement} */
  let canvas;
  /** @type {HTMLElement} */
  let cursor;
  const range = { from: 0, to: 1 };
  /**
   * Events by their instants: of each, the time, the first and the number of positions of the run.
   * @type {Instant[]}
   */
  let instants = [];
  let dragging = false;
  /** @type {(() => void)[]} */
  const listeners = [];

  /** @typedef {{time: number, first: number, count: number}} Instant */

  /** @param {Player} of */
  function start(of) {
    player = of;
    box = Dom.get("timeline");
    canvas = /** @type {HTMLCanvasElement} */ (box.querySelector("canvas"));
    cursor = Dom.make("div", { class: "cursor", "aria-hidden": "true" });
    box.append(cursor);
    player.on("run", open);
    player.on("move", move);
    new ResizeObserver(changed).observe(box);
    box.addEventListener("pointerdown", press);
    box.addEventListener("pointermove", (event) => (dragging ? drag(event) : point(event)));
    box.addEventListener("pointerup", () => {
      dragging = false;
    });
    box.addEventListener("pointercancel", () => {
      dragging = false;
    });
    box.addEventListener("pointerleave", () => {
      Dom.get("hint").hidden = true;
    });
    box.addEventListener("wheel", wheel, { passive: false });
    open();
  }

  /**
   * Calls a listener whenever another part of time is seen.
   * @param {() => void} listener
   */
  function onRange(listener) {
    listeners.push(listener);
  }

  function open() {
    instants = [];
    const legs = player.course.legs;
    for (let k = 0; k < legs.length; k++) {
      if (Rational.sign(legs[k].duration) !== 0) continue;
      const last = instants[instants.length - 1];
      const joined =
        last &&
        last.first + last.count === k + 1 &&
        Rational.cmp(legs[k].start, legs[last.first - 1].start) === 0;
      if (joined) last.count += 1;
      else instants.push({ time: player.instants[k], first: k + 1, count: 1 });
    }
    box.setAttribute("aria-valuemin", "0");
    box.setAttribute("aria-valuemax", String(player.end));
    look(0, player.end || 1);
    move();
  }

  /**
   * Shows a part of time.
   * @param {number} from @param {number} to
   */
  function look(from, to) {
    const whole = player.end || 1;
    const width = Math.max(whole * 1e-9, Math.min(to - from, whole));
    range.from = Math.max(0, Math.min(from, whole - width));
    range.to = range.from + width;
    changed();
  }

  /**
   * Shows less of time, or more, about an instant.
   * @param {number} factor @param {number} [about]
   */
  function zoom(factor, about) {
    const at = about === undefined ? player.clock : about;
    const inside = at >= range.from && at <= range.to ? at : (range.from + range.to) / 2;
    look(inside - (inside - range.from) * factor, inside + (range.to - inside) * factor);
  }

  function changed() {
    paint();
    place();
    for (const listener of listeners) listener();
  }

  /**
   * Pixels from the left of the line of time.
   * @param {number} time @param {number} width of the whole box
   */
  function x(time, width) {
    return margin + ((time - range.from) / (range.to - range.from)) * (width - 2 * margin);
  }

  /** @param {number} pixel */
  function timeAt(pixel) {
    const width = box.clientWidth - 2 * margin;
    return range.from + (Math.max(0, Math.min(width, pixel - margin)) / width) * (range.to - range.from);
  }

  /**
   * Steps of an axis: round numbers, no more than so many.
   * @param {number} from @param {number} to @param {number} count
   */
  function steps(from, to, count) {
    const least = (to - from) / Math.max(1, count);
    const power = 10 ** Math.floor(Math.log10(least));
    const step = power * ([1, 2, 5].find((lead) => lead * power >= least * (1 - 1e-9)) || 10);
    const made = [];
    for (let i = Math.ceil(from / step - 1e-9); i * step <= to + step * 1e-9 && made.length < 100; i++) {
      // Where floats are coarser than the step, one stands for several.
      if (made[made.length - 1] !== i * step) made.push(i * step);
    }
    return made;
  }

  /**
   * What is written at the steps of an axis: with as many digits as tell them apart, so that no two are the same.
   * @param {number[]} values @param {number} [digits] at least
   * @returns {[number, string][]}
   */
  function labels(values, digits = 6) {
    for (let count = digits; ; count++) {
      const texts = values.map((value) => Exactly.decimal(value, count));
      if (count >= 17 || new Set(texts).size === texts.length)
        return values.map((value, i) => /** @type {[number, string]} */ ([value, texts[i]])).filter(([, text], i) => i === 0 || text !== texts[i - 1]);
    }
  }

  function paint() {
    const width = box.clientWidth;
    const height = box.clientHeight;
    if (width === 0) return;
    const sharp = window.devicePixelRatio || 1;
    canvas.width = Math.round(width * sharp);
    canvas.height = Math.round(height * sharp);
    const pen = canvas.getContext("2d");
    if (!pen) return;
    const style = getComputedStyle(document.documentElement);
    const colour = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
    pen.scale(sharp, sharp);
    pen.clearRect(0, 0, width, height);
    const floor = height - 18;
    pen.fillStyle = colour("--line");
    pen.fillRect(margin, floor, width - 2 * margin, 1);
    pen.font = "11px system-ui, sans-serif";
    pen.textAlign = "center";
    // Longer words need more room.
    let marks = labels(steps(range.from, range.to, width / 90));
    const longest = Math.max(...marks.map(([, text]) => pen.measureText(text).width));
    if (longest > 80) marks = labels(steps(range.from, range.to, width / (longest + 20)));
    for (const [time, text] of marks) {
      const at = x(time, width);
      pen.fillStyle = colour("--line");
      pen.fillRect(Math.round(at), floor, 1, 5);
      pen.fillStyle = colour("--quiet");
      pen.fillText(text, Math.max(margin, Math.min(width - margin, at)), height - 3);
    }
    const kinds = new Map();
    const tint = (/** @type {string} */ kind) => {
      if (!kinds.has(kind)) kinds.set(kind, colour(`--k-${kind}`) || colour("--accent"));
      return kinds.get(kind);
    };
    const other = Compare.other(), band = floor - 8;
    ticks(pen, width, floor, other ? 0.62 * band : band, tint);
    if (other) beside(pen, width, floor, colour("--other"));
  }

  /**
   * The events of a second run, above those of the first one, and where both part.
   * @param {CanvasRenderingContext2D} pen @param {number} width @param {number} floor @param {string} tint
   */
  function beside(pen, width, floor, tint) {
    const other = Compare.other(), parts = Compare.when(), band = floor - 8;
    if (!other) return;
    pen.fillStyle = tint;
    for (const { time } of Compare.events(other)) {
      const at = Rational.toNumber(time);
      if (at >= range.from && at <= range.to) pen.fillRect(Math.round(x(at, width)) - 2, 6, 5, 0.26 * band);
    }
    if (!parts) return;
    const at = Math.round(x(Rational.toNumber(parts), width));
    pen.font = "600 12px system-ui, sans-serif";
    // After the end of the line, as far as it can be drawn.
    if (Rational.toNumber(parts) > player.end && range.to >= player.end) pen.fillText("≠ →", width - 18, 13);
    if (at < 0 || at > width || Rational.toNumber(parts) > player.end) return;
    pen.strokeStyle = tint;
    pen.setLineDash([4, 3]);
    pen.beginPath();
    pen.moveTo(at + 0.5, 0);
    pen.lineTo(at + 0.5, floor + 5);
    pen.stroke();
    pen.setLineDash([]);
    pen.fillText("≠", Math.max(8, Math.min(width - 8, at + (at > width - 20 ? -9 : 9))), 13);
  }

  /**
   * Draws the events that are seen: ticks; or where there are more than can be told apart, how many there are of each
   * kind (the height is the root of how many).
   * @param {CanvasRenderingContext2D} pen @param {number} width @param {number} floor @param {number} band their height
   * @param {(kind: string) => string} tint
   */
  function ticks(pen, width, floor, band, tint) {
    const seen = instants.filter((instant) => instant.time >= range.from && instant.time <= range.to);
    const kind = (/** @type {number} */ legs) => player.data.labels[player.run.steps[legs - 1].label].kind;
    if (seen.length <= width / 4) {
      const tick = seen.length > width / 12 ? 2 : 5;
      for (const { time, first, count } of seen) {
        const at = Math.round(x(time, width)) - 2;
        const each = band / count;
        const gap = each > 4 ? 1.5 : 0;
        for (let i = 0; i < count; i++) {
          pen.fillStyle = tint(kind(first + i));
          pen.fillRect(at, floor - 2 - each * (i + 1) + gap, tick, Math.max(0.5, each - gap));
        }
      }
      return;
    }
    /** @type {Map<number, Map<string, number>>} */
    const piles = new Map();
    const pileOf = (/** @type {Map<string, number>} */ pile) =>
      [...pile.values()].reduce((sum, many) => sum + many, 0);
    let highest = 1;
    for (const { time, first, count } of seen) {
      const at = Math.floor(x(time, width) / 4);
      const pile = piles.get(at) || new Map();
      piles.set(at, pile);
      for (let i = 0; i < count; i++) pile.set(kind(first + i), (pile.get(kind(first + i)) || 0) + 1);
      highest = Math.max(highest, pileOf(pile));
    }
    for (const [at, pile] of piles) {
      let top = floor - 1;
      for (const [name, many] of [...pile].sort()) {
        const high = (many / pileOf(pile)) * Math.sqrt(pileOf(pile) / highest) * band;
        top -= high;
        pen.fillStyle = tint(name);
        pen.fillRect(at * 4, top, 3, high);
      }
    }
  }

  function move() {
    box.setAttribute("aria-valuenow", String(player.clock));
    if (!player.playing) {
      box.setAttribute(
        "aria-valuetext",
        Dom.clip(`time ${Exactly.both(player.time)}, step ${player.legs} of ${player.course.legs.length}`, 200),
      );
    }
    if (player.playing && player.clock > range.to && range.to < player.end) {
      const width = range.to - range.from;
      look(player.clock - width / 10, player.clock + width * 0.9);
    }
    place();
  }

  function place() {
    const at = x(player.clock, box.clientWidth);
    cursor.hidden = at < 0 || at > box.clientWidth;
    cursor.style.transform = `translateX(${at.toFixed(2)}px)`;
  }

  /**
   * The position of the run to which the pointer points, or null.
   * @param {PointerEvent} event
   */
  function near(event) {
    const place = box.getBoundingClientRect();
    const width = box.clientWidth;
    const pixel = event.clientX - place.left;
    const time = timeAt(pixel);
    let low = 0;
    let high = instants.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (instants[middle].time < time) low = middle + 1;
      else high = middle;
    }
    const reach = event.pointerType === "touch" ? 14 : 7;
    const found = [instants[low - 1], instants[low]]
      .filter((instant) => instant && Math.abs(x(instant.time, width) - pixel) <= reach)
      .sort((a, b) => Math.abs(a.time - time) - Math.abs(b.time - time))[0];
    if (!found) return null;
    const floor = box.clientHeight - 18;
    const up = (floor - (event.clientY - place.top)) / (floor - 8);
    return {
      instant: found,
      legs: found.first + Math.max(0, Math.min(found.count - 1, Math.floor(up * found.count))),
    };
  }

  /** @param {PointerEvent} event */
  function press(event) {
    if (event.button !== 0) return;
    player.pause();
    const found = near(event);
    if (found) player.go(found.legs);
    else seek(event);
    dragging = true;
    box.setPointerCapture(event.pointerId);
  }

  /** @param {PointerEvent} event */
  function drag(event) {
    // A pointer that rests on a tick stays there.
    if (Math.abs(event.movementX) > 0) seek(event);
  }

  /** @param {PointerEvent} event */
  function seek(event) {
    const time = timeAt(event.clientX - box.getBoundingClientRect().left);
    player.seek(time >= player.end ? player.course.duration : Exactly.grid(time));
  }

  /** @param {PointerEvent} event */
  function point(event) {
    const hint = Dom.get("hint");
    const found = near(event);
    hint.hidden = found === null;
    if (!found) return;
    const { instant, legs } = found;
    Dom.fill(
      hint,
      Dom.make("strong", { text: `at ${Exactly.both(player.instant(instant.first))}` }),
      " ",
      Dom.name(Dom.clip(Events.words(legs), 160)),
      instant.count > 1
        ? Dom.make("span", { class: "quiet", text: ` (${legs - instant.first + 1} of ${instant.count})` })
        : null,
    );
    const width = box.clientWidth;
    const half = Math.min(hint.offsetWidth / 2, width / 2);
    hint.style.left = `${Math.max(half, Math.min(width - half, x(instant.time, width)))}px`;
  }

  /** @param {WheelEvent} event */
  function wheel(event) {
    event.preventDefault();
    const width = range.to - range.from;
    const sideways = event.shiftKey ? event.deltaY : event.deltaX;
    if (Math.abs(sideways) > Math.abs(event.shiftKey ? 0 : event.deltaY)) {
      const by = (sideways / Math.max(1, box.clientWidth)) * width;
      look(range.from + by, range.to + by);
    } else {
      zoom(Math.exp(event.deltaY / 500), timeAt(event.clientX - box.getBoundingClientRect().left));
    }
  }

  return { start, onRange, range, x, steps, labels, zoom, look, paint, margin };
})();
