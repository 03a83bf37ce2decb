"use strict";

/**
 * The bodies of a state as they are drawn: what is open on them, their bonds, what is selected, and how they move.
 *
 * What there is to draw is laid out when it changes; from then on, only what moves is placed anew.
 *
 * @typedef {{ leaf: number, parts: ReturnType<typeof Shapes.part>[], matrix: Float64Array, size: number, moves: boolean,
 *   body: Moving, place: DataPlace, drawn: { kind: Kind, k: number }[], heart?: { value: number[] } }} Shown  A leaf as it is drawn;
 *   heart: that of a wall, see {@link KindStyle}.
 */
class Bodies {
  /** @param {PageData} data @param {Gl} gl */
  constructor(data, gl) {
    this.data = data;
    this.gl = gl;
    /** @type {DataLeaf[]} */
    this.leaves = [];
    /** @type {ReturnType<typeof Shapes.part>[][]} of each leaf */
    this.models = [];
    /** @type {number[]} */
    this.sizes = [];
    /** The size of the middle one of those that move. */
    this.usual = 0;
    /**
     * Leaves that are walls, each with its heart.
     * @type {Map<number, { value: number[] }>}
     */
    this.walls = new Map();
    /**
     * Walls that are cut away, besides those that are around others by themselves.
     * @type {Set<number>}
     */
    this.cut = new Set();
    /** The heart of walls that are not around others by themselves: the middle of all that moves. */
    this.heart = { value: [0, 0, 0, 0] };
    /**
     * Walls that are around others together: behind one that is cut away there is another one.
     * @type {Set<number>}
     */
    this.shared = new Set();
    /** @type {[number, number, number][]} */
    this.centres = [];
    /** @type {ReturnType<typeof Colors.ofLeaves>} */
    this.families = [];
    /** @type {number[][]} */
    this.tints = [];
    /**
     * Leaves of one shape are drawn together.
     * @type {number[]}
     */
    this.shapes = [];
    this.channels = Colors.ofChannels(data.behaviours);
    /** @type {Map<string, Kind>} */
    this.kinds = new Map();
    /** @type {(Kind | undefined)[]} of each leaf */
    this.whole = [];
    /** @type {Map<number, { kind: Kind, tint: number[] }[]>} by behaviour and leaf */
    this.opens = new Map();
    this.colors = Colors.theme(false);
    /** @type {Shown[]} */
    this.shown = [];
    /** @type {Shown[]} those that move */
    this.moving = [];
    /** @type {Map<number, Shown>} */
    this.byLeaf = new Map();
    /** @type {Chosen | null} */
    this.chosen = null;
    /**
     * What is marked of them.
     * @type {{ lit: number[], ends: Marking["ends"] }}
     */
    this.marked = { lit: [], ends: [] };
    /** @type {Chosen | null} what the pointer is on */
    this.hovered = null;
    /**
     * What was laid out, and placed.
     * @type {{ bodies: Moving[] | null, target: Target | null }}
     */
    this.last = { bodies: null, target: null };
    /** The longest velocity and spin of so many processes. */
    this.fastest = 0;
    this.widest = 0;
    this.measured = 0;
    this.#measure();
    this.setLeaves(data.leaves);
  }

  #measure() {
    const { processes } = this.data;
    const every = Math.ceil((processes.length - this.measured) / 5000);
    const long = (/** @type {Vec | undefined} */ v) => (v ? Math.hypot(...Shapes.point(v)) : 0);
    for (let i = this.measured; i < processes.length; i += every) {
      this.fastest = Math.max(this.fastest, long(processes[i].velocity));
      this.widest = Math.max(this.widest, long(processes[i].turn?.spin));
    }
    this.measured = processes.length;
  }

  /** There are more behaviours and processes. */
  learn() {
    this.channels = Colors.ofChannels(this.data.behaviours);
    this.#measure();
  }

  /**
   * What bodies there are: a run may have some of its own.
   * @param {DataLeaf[]} leaves
   */
  setLeaves(leaves) {
    if (leaves === this.leaves) return false;
    this.leaves = leaves;
    this.models = leaves.map((leaf) => leaf.parts.map((p) => Shapes.part(this.data, p)));
    this.sizes = this.models.map((parts) => Math.max(...parts.map((p) => p.radius)));
    const moving = this.sizes.filter((_, leaf) => !leaves[leaf].fixed).sort((a, b) => a - b);
    this.usual = moving.length ? moving[moving.length >> 1] : 0;
    this.centres = this.models.map((parts) => Shapes.middle(parts.flatMap((p) => p.points)));
    this.families = Colors.ofLeaves(this.data, leaves);
    this.walls = new Map();
    this.#paint();
    this.shapes = Bodies.#numbers(leaves.map((leaf) =>
      JSON.stringify([leaf.fixed, leaf.absorbs, leaf.parts.map((p) => [p.solid, p.offset])])));
    this.#forget();
    return true;
  }

  /** @param {ReturnType<typeof Walls.find>} walls */
  setWalls(walls) {
    this.shared = walls.shared;
    this.walls = new Map([...walls].map(([leaf, heart]) => [leaf, heart ? { value: [...heart, 1] } : this.heart]));
    this.cut = new Set();
    this.#paint();
    this.#forget();
  }

  /**
   * Cuts away these walls, which are not around others by themselves, and no other ones.
   * @param {Set<number>} cut
   */
  setCut(cut) {
    if (cut.size === this.cut.size && [...cut].every((leaf) => this.cut.has(leaf))) return;
    this.cut = cut;
    this.whole = [];
    this.relay();
  }

  /**
   * The heart of a wall that is cut away.
   * @param {number} leaf
   */
  #heartOf(leaf) {
    const heart = this.walls.get(leaf);
    return heart === this.heart && !this.cut.has(leaf) ? undefined : heart;
  }

  /** What is fixed is near to the colour of the page, and walls are even more. */
  #paint() {
    this.tints = this.families.map(({ color, fixed }, leaf) => {
      const faint = this.walls.has(leaf) ? 0.75 : fixed ? 0.3 : 0;
      return [...Colors.mix(color, this.colors.wall, faint), 0];
    });
  }

  /** @param {string[]} texts @returns {number[]} the same number for the same text */
  static #numbers(texts) {
    /** @type {Map<string, number>} */
    const known = new Map();
    return texts.map((text) => {
      const n = known.get(text);
      if (n !== undefined) return n;
      known.set(text, known.size);
      return known.size - 1;
    });
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    this.colors = Colors.theme(dark);
    this.#paint();
    this.#forget();
  }

  /** All kinds are made anew when they are asked for next. */
  #forget() {
    this.gl.remove(...[...this.kinds.values()].flatMap((kind) => kind.things));
    this.kinds.clear();
    this.whole = [];
    this.opens.clear();
    this.last.bodies = null;
  }

  /**
   * The kind of that name, made when it is first asked for.
   * @param {string} name @param {() => Kind} make
   * @returns {Kind}
   */
  #kind(name, make) {
    const known = this.kinds.get(name);
    if (known) return known;
    const made = make();
    this.kinds.set(name, made);
    this.gl.add(...made.things);
    return made;
  }

  /** @param {number} leaf @returns {Kind} */
  #body(leaf) {
    const known = this.whole[leaf];
    if (known) return known;
    const { absorbs } = this.leaves[leaf], heart = this.#heartOf(leaf);
    const pane = heart === this.heart && !this.shared.has(leaf);
    const around = !heart ? "" : heart === this.heart ? (pane ? "pane" : "wall") : `wall ${heart.value}`;
    const kind = this.#kind(`body ${this.shapes[leaf]} ${around}`, () => {
      const made = new Kind(Shapes.body(this.models[leaf], this.sizes[leaf] / 4), {
        ...(heart ? { heart, lineOpacity: 0.6, pane } : { lineOpacity: 0.85 }), casts: true, stripes: absorbs, line: 1.3,
      });
      made.ink.value = this.colors.line;
      return made;
    });
    this.whole[leaf] = kind;
    return kind;
  }

  /**
   * How large a leaf is for what is drawn on it: marks of a body that is much larger than all others would hide these.
   * @param {number} leaf
   */
  #scale(leaf) {
    const size = this.sizes[leaf];
    return this.usual > 0 ? Math.min(size, Math.sqrt(2 * this.usual * size)) : size;
  }

  /**
   * What is open on a leaf.
   * @param {number} leaf @param {number} behaviour
   */
  #open(leaf, behaviour) {
    const key = behaviour * this.leaves.length + leaf;
    const known = this.opens.get(key);
    if (known) return known;
    const { open } = this.data.behaviours[behaviour];
    /** @type {Map<string, number>} */
    const ranks = new Map(), counts = new Map();
    for (const { sites } of open)
      for (const site of sites) counts.set(site.join(), (counts.get(site.join()) || 0) + 1);
    const made = open.flatMap(({ channel, co, sites }) => sites.map((site) => {
      const [part, kind, index] = site, count = counts.get(site.join()), rank = ranks.get(site.join()) || 0;
      ranks.set(site.join(), rank + 1);
      const name = `open ${co} ${site.join()} ${rank} ${count} ${this.shapes[leaf]}`;
      return {
        kind: this.#kind(name, () => {
          const shape = Shapes.feature(this.models[leaf][part], kind, index, this.#scale(leaf), co, rank, count);
          const style = { stripes: co, other: this.colors.plate, flat: kind === "face", pull: 1, line: 1.5, order: 1 };
          const one = new Kind(shape, style);
          one.ink.value = this.colors.plate;
          return one;
        }),
        tint: [...(this.channels.get(channel) || [1, 1, 1]), 0],
      };
    }));
    this.opens.set(key, made);
    return made;
  }

  /**
   * A mark around a feature: of what holds a bond, or is selected.
   * @param {string} what @param {number} leaf @param {DataSite} site @param {boolean} held
   */
  #mark(what, leaf, [part, kind, index], held) {
    return this.#kind(`${what} ${part} ${kind} ${index} ${this.shapes[leaf]}`, () => {
      const size = this.#scale(leaf), model = this.models[leaf][part];
      if (!held) return new Kind({ faces: Shapes.band(model, kind, index, size) }, { flat: true, ghost: 0.3, pull: 2, order: 2 });
      const faces = new Shapes.Triangles();
      Shapes.ball(faces, Shapes.middle(Shapes.corners(model, kind, index)), 0.06 * size);
      return new Kind({ faces, lines: Shapes.outline(model, kind, index, size) },
        { flat: true, own: true, line: 2.5, ghost: 0.45, pull: 3, order: 2 });
    });
  }

  /** @param {number} leaf */
  #around(leaf) {
    return this.#kind(`around ${this.shapes[leaf]}`, () =>
      new Kind({ lines: Surface.edges(this.models[leaf]) }, { own: true, line: 2, ghost: 0.35, pull: 2, order: 2 }));
  }

  /**
   * Shows the bodies where they are now.
   * @param {Course} course @param {Moving[]} bodies @param {Target} target
   */
  update(course, bodies, target) {
    if (bodies !== this.last.bodies) this.#lay(course, bodies, target);
    else {
      const some = target === this.last.target ? this.moving : this.shown;
      for (const s of some) {
        course.place(s.body, s.place, target, s.matrix);
        for (const { kind, k } of s.drawn) kind.move(k, s.matrix);
      }
    }
    this.last = { bodies, target };
  }

  /** Lays all out anew when it is shown next. */
  relay() { this.last.bodies = null; }

  /** @param {Course} course @param {Moving[]} bodies @param {Target} target */
  #lay(course, bodies, target) {
    for (const kind of this.kinds.values()) kind.clear();
    this.moving = [];
    this.byLeaf.clear();
    let n = 0;
    for (const body of bodies) {
      const moves = body.process.turn !== undefined || body.process.velocity.some((v) => v[0] !== "0");
      for (const place of body.process.leaves) {
        const leaf = place.leaf;
        const shown = (this.shown[n] = {
          leaf, parts: this.models[leaf], size: this.sizes[leaf], moves, body, place, drawn: [],
          heart: this.#heartOf(leaf),
          matrix: this.shown[n] ? this.shown[n].matrix : new Float64Array(12),
        });
        n++;
        course.place(body, place, target, shown.matrix);
        if (moves) this.moving.push(shown);
        this.byLeaf.set(leaf, shown);
        this.#draw(shown, this.#body(leaf), this.tints[leaf]);
        for (const { kind, tint } of this.#open(leaf, place.behaviour)) this.#draw(shown, kind, tint);
      }
      for (const bond of body.process.bonds)
        for (const end of bond.ends) {
          const at = this.byLeaf.get(end.leaf);
          if (at) this.#draw(at, this.#mark("bond", end.leaf, end.site, true), [...this.colors.bond, 0]);
        }
    }
    this.shown.length = n;
    this.#marked();
    if (this.hovered) this.#outline(this.hovered, "hover", [...this.colors.hover, 0]);
    if (this.chosen) this.#outline(this.chosen, "chosen", [...this.colors.chosen, 0]);
  }

  /**
   * Marks these leaves, and the ends of these bonds.
   * @param {{ lit: number[], ends: Marking["ends"] }} marked
   */
  mark({ lit, ends }) {
    if (JSON.stringify(this.marked) === JSON.stringify({ lit, ends })) return;
    this.marked = { lit, ends };
    this.relay();
  }

  #marked() {
    const { lit, made, split } = this.colors;
    for (const leaf of this.marked.lit) {
      const at = this.byLeaf.get(leaf);
      if (at) this.#draw(at, this.#halo(leaf), [...lit, 0]);
    }
    for (const end of this.marked.ends) {
      const at = this.byLeaf.get(end.leaf);
      if (at) this.#draw(at, this.#mark("bond", end.leaf, end.site, true), [...(end.made ? made : split), 0]);
    }
  }

  /**
   * A seam around a leaf: wide lines along its edges, where none of the leaves with seams is seen.
   * @param {number} leaf
   */
  #halo(leaf) {
    const heart = this.#heartOf(leaf);
    return this.#kind(`halo ${this.shapes[leaf]} ${heart ? heart.value : ""}`, () => {
      const { faces, lines } = Shapes.body(this.models[leaf], this.sizes[leaf]);
      return new Kind({ faces, lines }, { own: true, line: 9, pull: 3, order: -3, seam: true, ...(heart ? { heart } : {}) });
    });
  }

  /** @param {Chosen} chosen @param {string} what @param {number[]} tint */
  #outline({ leaf, part, kind, index }, what, tint) {
    const at = this.byLeaf.get(leaf);
    if (!at) return;
    this.#draw(at, this.#around(leaf), tint);
    const model = typeof part === "number" ? at.parts[part] : undefined;
    if (!model || !kind || typeof index !== "number") return;
    const all = kind === "vertex" ? model.points : kind === "edge" ? model.edges : model.faces;
    if (all[index]) this.#draw(at, this.#mark(what, leaf, [/** @type {number} */ (part), kind, index], false), tint);
  }

  /** @param {Shown} shown @param {Kind} kind @param {ArrayLike<number>} tint */
  #draw(shown, kind, tint) {
    shown.drawn.push({ kind, k: kind.push(shown.matrix, tint) });
  }

  /**
   * Arrows of velocities and spins, the longest a good part of the picture.
   * @param {{ velocities: boolean, spins: boolean }} options @param {number} distance of the camera
   */
  arrows({ velocities, spins }, distance) {
    const arrow = this.#kind("arrow", () => new Kind({ faces: Shapes.arrow() }, { ghost: 0.5, order: 3 }));
    const curl = this.#kind("curl", () => new Kind({ faces: Shapes.curl() }, { ghost: 0.3, order: 3 }));
    arrow.clear();
    curl.clear();
    if (!velocities && !spins) return;
    /** @type {Moving | null} */
    let last = null;
    for (const shown of this.moving) {
      if (shown.body === last) continue;
      last = shown.body;
      const centre = this.#centre(shown);
      const { velocity, turn } = shown.body.process;
      const long = 0.24 * distance, wide = 1.1 * shown.size;
      if (velocities) this.#pointer(arrow, centre, velocity, this.fastest, long, Math.min(long, 6 * shown.size), this.colors.velocity);
      if (spins && turn) this.#pointer(curl, centre, turn.spin, this.widest, 4 * wide, wide, this.colors.spin);
    }
  }

  /**
   * The middle of a process.
   * @param {Shown} shown one of its leaves
   */
  #centre(shown) {
    const all = shown.body.process.leaves.flatMap((place) => {
      const at = this.byLeaf.get(place.leaf);
      return at ? [Pick.toWorld(at.matrix, this.centres[place.leaf])] : [];
    });
    return Shapes.middle(all);
  }

  /**
   * @param {Kind} kind @param {number[]} at @param {Vec} vec @param {number} most @param {number} longest
   * @param {number} wide @param {number[]} color
   */
  #pointer(kind, at, vec, most, longest, wide, color) {
    const v = Shapes.point(vec), long = Math.hypot(...v);
    if (!(long > 0) || !(most > 0)) return;
    const l = longest * (0.25 + 0.75 * Math.min(1, long / most));
    const x = Shapes.unit(v), [y, z] = Shapes.across(x);
    // Along x it is as long as the vector tells; its width is the same for all.
    const m = [at[0], at[1], at[2]];
    for (let i = 0; i < 3; i++) m.push(l * x[i], wide * y[i], wide * z[i]);
    kind.push(m, [...color, 0]);
  }

  /** Ready to be drawn. */
  finish() {
    for (const kind of this.kinds.values()) kind.finish();
  }
}
