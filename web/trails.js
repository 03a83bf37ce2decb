"use strict";

/**
 * Where bodies have been: a line for each, up to now.
 *
 * The lines of all that is over are computed once for a run, in the order in which it was over, so that those up to
 * some time are the first ones. They are relative to a point near what is looked at.
 */
class Trails {
  /** How many pieces of lines there are at most. */
  static most = 60000;

  /** @param {PageData} data @param {Bodies} bodies @param {Gl} gl */
  constructor(data, bodies, gl) {
    this.data = data;
    this.bodies = bodies;
    const made = () => {
      const kind = new Kind({ lines: [0, 0, 0, 0, 0, 0] }, { own: true, line: 2, lineOpacity: 0.75 });
      kind.push([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], [0, 0, 0, 0]);
      kind.finish();
      gl.add(...kind.things);
      return kind;
    };
    this.past = made();
    this.present = made();
    /** @type {Course | null} */
    this.course = null;
    this.base = Motion.target({ n: [0n, 0n, 0n], d: 1n });
    /**
     * After how many legs each piece is over.
     * @type {number[]}
     */
    this.ends = [];
    /**
     * Where processes that go straight began.
     * @type {Map<DataPlace, [number, number, number]>}
     */
    this.begins = new Map();
  }

  /**
   * @param {Course} course @param {number} legs @param {Rational} time @param {{ target: Target, distance: number }} orbit
   * @param {boolean} shown
   */
  update(course, legs, time, orbit, shown) {
    for (const kind of [this.past, this.present]) for (const o of kind.things) o.visible = shown && kind === this.past;
    if (!shown) return;
    let away = Trails.#between(this.base, orbit.target);
    if (course !== this.course || Math.hypot(...away) > 1e4 * orbit.distance) {
      this.course = course;
      this.base = orbit.target;
      this.begins.clear();
      this.#past(course);
      away = [0, 0, 0];
    }
    let low = 0, high = this.ends.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.ends[middle] <= legs) low = middle + 1; else high = middle;
    }
    for (const thing of this.past.things) {
      thing.visible = low > 0;
      thing.mesh.count = 6 * low;
    }
    const matrix = [...away, 1, 0, 0, 0, 1, 0, 0, 0, 1];
    this.past.move(0, matrix);
    this.present.move(0, matrix);
    for (const kind of [this.past, this.present]) kind.rows.changed = true;
    this.#present(course, time, away);
  }

  /** @param {Target} a @param {Target} b */
  static #between(a, b) {
    return [0, 1, 2].map((i) => Rational.ratio(a.n[i] * b.d - b.n[i] * a.d, a.d * b.d));
  }

  /**
   * Pieces of the line of a leaf while its process stays the same.
   * @param {Course} course @param {Segment} s @param {DataPlace} place @param {Rational} from @param {Rational} to
   * @param {number[]} lines @param {number[]} colors
   */
  #pieces(course, s, place, from, to, lines, colors) {
    const process = this.data.processes[s.index], out = new Float64Array(12), long = Rational.sub(to, from);
    const body = new Moving(process, s.index, s.since);
    const turned = process.turn ? Math.hypot(...Shapes.point(process.turn.spin)) * Rational.toNumber(long) : 0;
    const n = Math.max(1, Math.min(40, Math.ceil(4 * turned)));
    /** @type {number[] | null} */
    let last = null;
    for (let i = 0; i <= n; i++) {
      const at = Rational.add(from, Rational.mul(long, Rational.make(BigInt(i), BigInt(n))));
      body.at(at);
      course.place(body, place, this.base, out);
      const p = Pick.toWorld(out, this.bodies.centres[place.leaf]);
      if (last) {
        lines.push(...last, ...p);
        const c = this.bodies.tints[place.leaf];
        colors.push(c[0], c[1], c[2], c[0], c[1], c[2]);
      }
      last = p;
    }
  }

  /**
   * What of a process leaves a line.
   * @param {number} index of the process
   */
  #places(index) {
    const { leaves, velocity, turn } = this.data.processes[index];
    return turn || velocity.some((v) => !v.startsWith("0")) ? leaves.filter((p) => !this.bodies.leaves[p.leaf].fixed) : [];
  }

  /** @param {Course} course */
  #past(course) {
    const over = [...course.slots.values()].flat().filter((s) => s.to <= course.legs.length).sort((a, b) => a.to - b.to);
    /** @type {number[]} */
    const lines = [];
    /** @type {number[]} */
    const colors = [];
    this.ends = [];
    for (const s of over) {
      if (this.ends.length > Trails.most) break;
      const from = course.arrival(s.from), to = course.arrival(s.to);
      if (Rational.cmp(from, to) === 0) continue;
      for (const place of this.#places(s.index)) this.#pieces(course, s, place, from, to, lines, colors);
      while (this.ends.length < lines.length / 6) this.ends.push(s.to);
    }
    this.past.draw(lines, colors);
  }

  /**
   * The pieces that are not over. What goes straight is drawn from where its process began to where it is.
   * @param {Course} course @param {Rational} time @param {number[]} away of the target, from what lines are relative to
   */
  #present(course, time, away) {
    /** @type {number[]} */
    const lines = [];
    /** @type {number[]} */
    const colors = [];
    for (const shown of this.bodies.moving) {
      if (lines.length > 6 * 4000) break;
      const { body, place, leaf } = shown;
      if (this.bodies.leaves[leaf].fixed) continue;
      const begin = Rational.sign(body.since) < 0 ? Rational.zero : body.since;
      if (Rational.cmp(begin, time) >= 0) continue;
      if (body.process.turn) {
        this.#pieces(course, { index: body.index, since: body.since, from: 0, to: 0 }, place, begin, time, lines, colors);
        continue;
      }
      let from = this.begins.get(place);
      if (!from) {
        const start = new Moving(body.process, body.index, body.since), out = new Float64Array(12);
        start.at(begin);
        course.place(start, place, this.base, out);
        from = Pick.toWorld(out, this.bodies.centres[leaf]);
        this.begins.set(place, from);
      }
      const to = Pick.toWorld(shown.matrix, this.bodies.centres[leaf]), c = this.bodies.tints[leaf];
      lines.push(from[0], from[1], from[2], to[0] - away[0], to[1] - away[1], to[2] - away[2]);
      colors.push(c[0], c[1], c[2], c[0], c[1], c[2]);
    }
    for (const thing of this.present.things) thing.visible = lines.length > 0;
    if (lines.length) this.present.draw(lines, colors);
  }
}
