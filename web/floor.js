"use strict";

/** The floor: a grid of whole multiples of a step, and the axes where they are near. */
class Floor {
  /** How many steps of it are seen around what is looked at. */
  static reach = 15;

  static program = {
    vertex: `
      uniform mat4 camera; uniform float ground; uniform float step; uniform float reach;
      uniform vec3 first; uniform vec3 second; uniform vec3 up; in vec3 position; out vec2 vAt; out vec3 vWorld;
      void main() {
        vAt = position.xz * reach;
        vWorld = vAt.x * step * first + vAt.y * step * second + ground * up;
        gl_Position = camera * vec4(vWorld, 1.0);
      }`,
    fragment: `
      uniform float reach; uniform vec2 shift; uniform vec2 origin; uniform vec3 grid;
      uniform vec3 firstInk; uniform vec3 secondInk; uniform float shadow; in vec2 vAt; in vec3 vWorld; out vec4 color;
      ${Shaders.shaded}
      float lines(vec2 p, float width) {
        vec2 f = fwidth(p);
        vec2 near = clamp(0.5 * width + 0.5 - abs(fract(p - 0.5) - 0.5) / f, 0.0, 1.0) * (1.0 - smoothstep(0.15, 0.5, f));
        return max(near.x, near.y);
      }
      void main() {
        vec2 p = vAt + shift;
        float seen = max(0.28 * lines(p, 1.0), 0.5 * lines(p / 5.0, 1.2));
        vec3 ink = grid;
        vec2 axes = clamp(1.4 - abs(vAt - origin) / fwidth(vAt), 0.0, 1.0);
        if (axes.y > 0.0) { ink = mix(ink, firstInk, axes.y); seen = max(seen, 0.9 * axes.y); }
        if (axes.x > 0.0) { ink = mix(ink, secondInk, axes.x); seen = max(seen, 0.9 * axes.x); }
        float dark = shadow > 0.0 ? shadow * shaded(vWorld, up) : 0.0, whole = 1.0 - (1.0 - seen) * (1.0 - dark);
        color = vec4(ink * seen / max(whole, 1e-4), whole * (1.0 - smoothstep(0.45, 1.0, length(vAt) / reach)));
      }`,
  };

  /** @param {Gl} gl */
  constructor(gl) {
    this.shadow = { value: 0 };
    this.uniforms = {
      ...Kind.shared, shadow: this.shadow, ground: { value: 0 }, step: { value: 1 }, reach: { value: Floor.reach }, shift: { value: [0, 0] },
      origin: { value: [0, 0] }, grid: { value: [0, 0, 0] },
      // The axes of the floor, and their colours.
      first: { value: [0, 0, 0] }, second: { value: [0, 0, 0] },
      firstInk: { value: [0, 0, 0] }, secondInk: { value: [0, 0, 0] },
    };
    const corners = [-1, 0, -1, -1, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0, -1];
    const mesh = new Mesh([new Store(Float32Array.from(corners), [[Gl.at.position, 3]])]);
    /** @type {GlThing} */
    this.thing = {
      mesh, paint: { program: Floor.program, uniforms: this.uniforms, blend: true, flat: true, both: true }, order: -8, visible: true,
    };
    gl.add(this.thing);
    this.step = 1;
    this.ground = 0;
    this.upright = Orbit.uprights.y;
    /** The last multiple of the step before the target, along both axes, and how far it is, in steps. */
    this.whole = [0n, 0n];
    this.rest = [0, 0];
    /** Digits of the step: lead times a power of ten. */
    this.power = 0;
    this.lead = 1;
  }

  /**
   * A step of 1, 2 or 5 times a power of ten.
   * @param {number} x @returns {{ lead: number, power: number }}
   */
  static round(x) {
    const power = Math.floor(Math.log10(x)), lead = x / 10 ** power;
    return lead < 1.5 ? { lead: 1, power } : lead < 3.5 ? { lead: 2, power } : lead < 7.5 ? { lead: 5, power }
      : { lead: 1, power: power + 1 };
  }

  /**
   * @param {Orbit} orbit from where it is seen @param {Rational} height of the floor
   * @param {ReturnType<typeof Colors.theme>} colors @param {boolean} shown
   */
  place({ at, distance, upright }, height, colors, shown) {
    this.upright = upright;
    const { lead, power } = Floor.round(distance / 9);
    this.lead = lead;
    this.power = power;
    this.step = lead * 10 ** power;
    this.ground = Rational.toNumber(Rational.sub(height, at[upright.up]));
    const ten = 10n ** BigInt(Math.abs(power));
    const step = power < 0 ? Rational.make(BigInt(lead), ten) : Rational.make(BigInt(lead) * ten, 1n);
    upright.floor.forEach((axis, i) => {
      const steps = Rational.div(at[axis], step);
      let k = steps.n / steps.d;
      if (k * steps.d > steps.n) k -= 1n;
      this.whole[i] = k;
      this.rest[i] = Rational.toNumber(Rational.sub(steps, Rational.make(k, 1n)));
    });
    const u = this.uniforms;
    const near = (/** @type {number} */ i) => Math.max(-1e4, Math.min(1e4, -Number(this.whole[i]) - this.rest[i]));
    u.ground.value = this.ground;
    u.step.value = this.step;
    u.shift.value = [0, 1].map((i) => Number(((this.whole[i] % 5n) + 5n) % 5n) + this.rest[i]);
    u.origin.value = [near(0), near(1)];
    u.grid.value = colors.grid;
    const unit = (/** @type {number} */ axis) => [0, 1, 2].map((i) => (i === axis ? 1 : 0));
    const inks = upright.floor.map((axis) => [colors.x, colors.y, colors.z][axis]);
    [u.first.value, u.second.value] = upright.floor.map(unit);
    [u.firstInk.value, u.secondInk.value] = inks;
    this.thing.visible = shown;
  }

  /** Powers of ten beyond these are written as such: a grid of a large or small step has no room for its zeros. */
  static digits = 6;

  /**
   * A multiple of the step, in few letters, and in others than those beside it: as a decimal, or with a power of ten.
   * @param {bigint} n @param {boolean} [whole] with all its digits, if they are not too many
   */
  decimal(n, whole) {
    const most = whole ? 24 : Floor.digits;
    const digits = n * BigInt(this.lead), size = digits < 0n ? -digits : digits;
    const sign = digits < 0n ? "\u2212" : "", { power } = this;
    if (size === 0n) return "0";
    if (Math.abs(power) > Floor.digits) return sign + Floor.#scientific(String(size), power, most);
    if (power >= 0) return sign + Floor.#short(String(size) + "0".repeat(power), most + power);
    const text = String(size).padStart(1 - power, "0"), point = text.length + power;
    const part = text.slice(point).replace(/0+$/, "");
    return sign + Floor.#short(text.slice(0, point), most) + (part ? "." + part : "");
  }

  /**
   * Of a long number its last digits, which tell it from those beside it.
   * @param {string} digits @param {number} most that are shown
   */
  static #short(digits, most) {
    return digits.length > most + 3 ? "…" + digits.slice(-most) : digits;
  }

  /**
   * With one digit before the point, or with the last ones of many.
   * @param {string} digits @param {number} power of ten that they count @param {number} most that are shown
   */
  static #scientific(digits, power, most) {
    const many = digits.length > most + 3;
    const shown = many ? digits.slice(-most) : digits.replace(/0+$/, "");
    const raised = many ? power : power + digits.length - 1;
    const high = String(raised).replace(/./g, (sign) => (sign === "-" ? "\u207b" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)]));
    const first = many ? "…" + shown : shown.length > 1 ? `${shown[0]}.${shown.slice(1)}` : shown;
    return raised === 0 ? first : `${first}·10${high}`;
  }

  /**
   * A point of the floor.
   * @param {number} a along its first axis @param {number} b along the second
   */
  #point(a, b) {
    const { up, floor } = this.upright, p = [0, 0, 0];
    p[floor[0]] = a;
    p[floor[1]] = b;
    p[up] = this.ground;
    return p;
  }

  /**
   * Numbers at the ends of the grid's lines, where they leave the picture or the floor.
   * @param {(p: number[]) => number[]} clip to clip space @param {number} width @param {number} height
   * @param {number} margin how much of the picture is covered from below
   * @returns {{ text: string, axis: number, x: number, y: number }[]}
   */
  numbers(clip, width, height, margin) {
    const reach = 0.6 * Floor.reach;
    /** @type {{ text: string, axis: number, x: number, y: number }[]} */
    const found = [];
    /** @type {string[]} */
    const sides = [];
    for (const axis of [0, 1]) {
      /** @type {{ n: bigint, x: number, y: number, side: string }[]} */
      const ends = [];
      for (let i = -Math.floor(reach); i <= reach; i++) {
        const a = (i - this.rest[axis]) * this.step, half = Math.sqrt(Math.max(0, (reach * this.step) ** 2 - a * a));
        const point = (/** @type {number} */ b) => (axis === 0 ? this.#point(a, b) : this.#point(b, a));
        const end = Floor.#leaves(clip(point(-half)), clip(point(half)), width, height, margin);
        if (end) ends.push({ n: this.whole[axis] + BigInt(i), ...end });
      }
      // Those of one axis are at one side, those of the other at another one.
      const free = ["below", "left", "right", "within"].filter((side) => !sides.includes(side));
      const many = (/** @type {string} */ side) => ends.filter((e) => e.side === side).length;
      const side = free.reduce((best, other) => (many(other) > many(best) ? other : best));
      sides.push(side);
      const there = ends.filter((e) => e.side === side);
      const apart = side === "below" ? 44 : 30;
      const stride = [1n, 2n, 5n, 10n].find((by) => {
        const kept = there.filter((e) => e.n % by === 0n);
        return kept.every((e, i) => i === 0 || Math.hypot(e.x - kept[i - 1].x, e.y - kept[i - 1].y) > apart);
      }) || 20n;
      const kept = there.filter((e) => e.n % stride === 0n);
      kept.forEach((e, i) => {
        const of = this.upright.floor[axis], middle = i === kept.length >> 1;
        found.push({ text: middle ? `${"xyz"[of]} = ${this.decimal(e.n, true)}` : this.decimal(e.n), axis: of, x: e.x, y: e.y });
      });
    }
    return found;
  }

  /**
   * The end of a line that is nearer to the viewer, within the picture.
   * @param {number[]} a @param {number[]} b in clip space @param {number} width @param {number} height
   * @param {number} margin
   */
  static #leaves(a, b, width, height, margin) {
    const w = 1e-3 * Math.max(a[3], b[3]);
    if (!(w > 0)) return null;
    /** @param {number[]} p @param {number[]} q @param {number} t */
    const mix = (p, q, t) => p.map((x, i) => x + t * (q[i] - x));
    if (a[3] < w) a = mix(a, b, (w - a[3]) / (b[3] - a[3]));
    if (b[3] < w) b = mix(b, a, (w - b[3]) / (a[3] - b[3]));
    const pixel = (/** @type {number[]} */ p) => [(0.5 + p[0] / p[3] / 2) * width, (0.5 - p[1] / p[3] / 2) * height];
    const p = pixel(a), q = pixel(b), d = [q[0] - p[0], q[1] - p[1]];
    const low = [26, 14], high = [width - 26, height - 14 - margin];
    let from = 0, to = 1;
    for (const i of [0, 1]) {
      if (Math.abs(d[i]) < 1e-9) {
        if (p[i] < low[i] || p[i] > high[i]) return null;
        continue;
      }
      const s = (low[i] - p[i]) / d[i], t = (high[i] - p[i]) / d[i];
      from = Math.max(from, Math.min(s, t));
      to = Math.min(to, Math.max(s, t));
    }
    if (from >= to) return null;
    const t = d[1] > 0 ? to : from;
    const x = p[0] + t * d[0], y = p[1] + t * d[1];
    const side = y > high[1] - 1 ? "below" : x < low[0] + 1 ? "left" : x > high[0] - 1 ? "right" : "within";
    return { x, y, side };
  }
}
