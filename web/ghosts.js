"use strict";

/**
 * Outlines of bodies where they are not now: where they were before a step, or where they are in another run. A line
 * leads from there to where the body is.
 *
 * @typedef {{ course: Course, body: Moving, place: DataPlace, tint: number[], word?: string }} Ghost  body: one of its own,
 *   at the time that is drawn.
 */
class Ghosts {
  /** @param {PageData} data @param {Bodies} bodies @param {Gl} gl */
  constructor(data, bodies, gl) {
    this.data = data;
    this.bodies = bodies;
    this.gl = gl;
    /** @type {Map<string, Kind>} */
    this.kinds = new Map();
    /** @type {WeakMap<DataLeaf, { kind: Kind, centre: [number, number, number] }>} */
    this.known = new WeakMap();
    this.ways = new Kind({ lines: [0, 0, 0, 0, 0, 0] }, { own: true, line: 1.2, lineOpacity: 0.7, ghost: 0.3 });
    this.ways.push([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], [0, 0, 0, 0]);
    this.ways.finish();
    gl.add(...this.ways.things);
    this.out = new Float64Array(12);
    /**
     * Where words are, relative to the target.
     * @type {{ text: string, at: [number, number, number], color: number[] }[]}
     */
    this.words = [];
  }

  /**
   * A body of a process by itself, at a time.
   * @param {Moving} body @param {Rational} time
   */
  static still(body, time) {
    const made = new Moving(body.process, body.index, body.since);
    made.at(time);
    return made;
  }

  /** @param {DataLeaf} leaf */
  #of(leaf) {
    const known = this.known.get(leaf);
    if (known) return known;
    const parts = leaf.parts.map((p) => Shapes.part(this.data, p));
    const name = JSON.stringify(leaf.parts.map((p) => [p.solid, p.offset]));
    let kind = this.kinds.get(name);
    if (!kind) {
      kind = new Kind({ lines: Surface.edges(parts) }, { own: true, line: 2, lineOpacity: 0.9, ghost: 0.25, order: 2 });
      this.kinds.set(name, kind);
      this.gl.add(...kind.things);
    }
    const made = { kind, centre: Shapes.middle(parts.flatMap((p) => p.points)) };
    this.known.set(leaf, made);
    return made;
  }

  /** @param {Ghost[]} ghosts @param {Target} target */
  draw(ghosts, target) {
    for (const kind of this.kinds.values()) kind.clear();
    this.words = [];
    /** @type {number[]} */
    const lines = [], colors = [];
    for (const { course, body, place, tint, word } of ghosts) {
      const { kind, centre } = this.#of(course.leaves[place.leaf]);
      course.place(body, place, target, this.out);
      kind.push(this.out, [...tint, 0]);
      const from = Pick.toWorld(this.out, centre), now = this.bodies.byLeaf.get(place.leaf);
      if (word) this.words.push({ text: word, at: from, color: tint });
      if (!now) continue;
      lines.push(...from, ...Pick.toWorld(now.matrix, this.bodies.centres[place.leaf]));
      colors.push(...tint, ...tint);
    }
    for (const kind of this.kinds.values()) kind.finish();
    for (const thing of this.ways.things) thing.visible = lines.length > 0;
    if (lines.length) this.ways.draw(lines, colors);
  }
}
