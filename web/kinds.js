"use strict";

/** The programs that draw what {@link Kind} has. */
const Shaders = (() => {
  const rows = "uniform mat4 camera; in vec3 position; in vec4 row0; in vec4 row1; in vec4 row2; in vec4 tint;";

  const world = "vec4 p = vec4(position, 1.0); vec3 world = vec3(dot(row0, p), dot(row1, p), dot(row2, p));";

  // What is cut away of a wall: faces that are between an eye and its heart.
  const cut = `
    uniform vec4 heart;
    bool gone(vec3 world, vec3 n, vec4 eye) {
      vec4 q = vec4(heart.xyz, 1.0);
      vec3 middle = heart.w > 0.5 ? vec3(dot(row0, q), dot(row1, q), dot(row2, q)) : heart.xyz;
      return heart.w >= 0.0 && dot(n, middle - world) * dot(n, eye.xyz - eye.w * world) < 0.0;
    }
    const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0);`;

  const turned = "vec3 n = vec3(dot(row0.xyz, normal), dot(row1.xyz, normal), dot(row2.xyz, normal));";

  // How much of a place is in shadow, of what is straight above it and near: the place has a plane with a normal. Six looks
  // at the rim show that most places are all in the light or all in the dark.
  const shaded = `
    uniform highp sampler2DShadow shades; uniform mat4 shade; uniform vec3 up; uniform vec4 span; uniform float soft;
    float shaded(vec3 at, vec3 n) {
      float rise = dot(n, up);
      vec3 seen = 0.5 * (shade * vec4(at, 1.0)).xyz + 0.5;
      if (rise < 0.05 || any(greaterThan(abs(seen.xy - 0.5), 0.5 * span.zw))) return 0.0;
      // Where the plane goes on, it has no shadow of its own.
      vec2 slope = (mat3(shade) * n).xy * span.x / rise;
      float lit = 0.0, near = 0.002 * span.x * (1.0 + length(slope));
      vec2 d = vec2(soft, 0.0);
      for (int i = 0; i < 6; i++, d = mat2(0.5, 0.866, -0.866, 0.5) * d)
        lit += texture(shades, vec3(seen.xy + 0.5 * d / span.x, seen.z + 0.5 * (dot(slope, d) - near) / span.y));
      if (lit == 0.0 || lit == 6.0) return min(1.0, 1.6 * rise) * (1.0 - lit / 6.0);
      for (int i = 0; i < 14; i++) {
        d = mat2(-0.7374, 0.6755, -0.6755, -0.7374) * d;
        vec2 at = sqrt((float(i) + 0.5) / 14.0) * 0.9 * d;
        lit += texture(shades, vec3(seen.xy + 0.5 * at / span.x, seen.z + 0.5 * (dot(slope, at) - near) / span.y));
      }
      return min(1.0, 1.6 * rise) * (1.0 - lit / 20.0);
    }`;

  const face = {
    vertex: `
    ${rows} in vec3 normal; in float pattern; uniform vec4 eye; uniform float pane;
    ${cut}
    out vec3 vWorld; out vec3 vNormal; out vec4 vTint; out float vPattern;
    void main() {
      ${world}
      ${turned}
      vNormal = n;
      vWorld = world;
      vTint = tint;
      vPattern = pattern;
      gl_Position = camera * vec4(world, 1.0);
      if (gone(world, n, eye) != (pane > 0.5)) gl_Position = nowhere;
      // The other side of a face hides the lines around it.
      else if (heart.w >= 0.0 && dot(n, eye.xyz - eye.w * world) < 0.0) gl_Position.z -= 8e-5 * gl_Position.w;
    }`,
    // Light from above and from the right of the front, so that each side of a cube has its own shade. The other side of
    // a face is seen of walls alone, where they are cut.
    fragment: `
    uniform float stripes; uniform float opacity; uniform float flatness; uniform vec3 ink; uniform vec3 light;
    uniform float shadow; in vec3 vWorld; in vec3 vNormal; in vec4 vTint; in float vPattern; out vec4 color;
    ${shaded}
    void main() {
      vec3 n = normalize(vNormal);
      float shine = 0.56 + 0.48 * (0.5 + 0.5 * dot(n, light));
      vec3 base = vTint.rgb;
      if (stripes > 0.5 && fract(vPattern) < 0.5) base = mix(base, ink, 0.72);
      shine = gl_FrontFacing ? mix(shine, 1.0, flatness) : 0.85;
      if (gl_FrontFacing && flatness < 1.0) shine *= 1.0 - shadow * shaded(vWorld, n);
      color = vec4(base * shine, opacity * (1.0 - vTint.a));
    }`,
  };

  const depth = {
    vertex: `
    ${rows} in vec3 normal; uniform vec3 up;
    ${cut}
    void main() {
      ${world}
      ${turned}
      gl_Position = gone(world, n, vec4(up, 0.0)) ? nowhere : camera * vec4(world, 1.0);
    }`,
    fragment: "void main() {}",
  };

  const line = {
    // Lines of so many pixels, and some more for a smooth border. What is behind the camera is cut off first.
    vertex: `
    ${rows} in vec3 other; in float side; in vec4 color;
    uniform vec2 size; uniform float width; uniform float near; uniform float pull; uniform float fade;
    out vec4 vColor; out float vAcross;
    vec4 place(vec3 q) {
      vec4 p = vec4(q, 1.0);
      return camera * vec4(dot(row0, p), dot(row1, p), dot(row2, p), 1.0);
    }
    void main() {
      vec4 a = place(position), b = place(other);
      if (a.w < near && b.w > near) a = mix(a, b, (near - a.w) / (b.w - a.w));
      else if (b.w < near && a.w > near) b = mix(b, a, (near - b.w) / (a.w - b.w));
      vec2 d = (b.xy / b.w - a.xy / a.w) * size;
      // The edges of what is small in the picture would hide it.
      float seen = fade > 0.5 ? smoothstep(1.0, 12.0, 0.5 * length(d)) : 1.0;
      d = length(d) > 0.0 ? normalize(d) : vec2(0.0);
      a.xy += (side * (width + 1.5) * vec2(-d.y, d.x) - 0.5 * width * d) * a.w / size;
      // At the other end of a ribbon its sides have changed places.
      vAcross = ((gl_VertexID & 2) == 0 ? 0.5 : -0.5) * side * (width + 1.5);
      a.z -= pull * a.w;
      vColor = vec4(mix(tint.rgb, color.rgb, color.a), seen * (1.0 - tint.a));
      gl_Position = a;
    }`,
    fragment: `
    uniform vec3 ink; uniform float opacity; uniform float own; uniform float width;
    in vec4 vColor; in float vAcross; out vec4 color;
    void main() {
      float seen = clamp((0.5 * width - abs(vAcross)) / fwidth(vAcross) + 0.5, 0.0, 1.0);
      color = vec4(mix(ink, vColor.rgb, own), opacity * seen * vColor.a);
    }`,
  };

  return { face, depth, line, shaded };
})();

/**
 * What is drawn many times: one geometry, and for each time it is drawn a place, a rotation and a colour.
 *
 * They come as {@link Motion.place} writes them: x y z, then the rotation by rows.
 */
class Kind {
  /**
   * What all of them share: the size of the picture, how near is too near, the eye (a place, or with a last 0 a
   * direction), from where the light comes, and shadows: which way is up, their matrix, half of the width and of the
   * height that they are of and the parts of the width in which there are any, how soft and how dark they are.
   */
  static shared = {
    size: { value: [1, 1] },
    near: { value: 0 },
    eye: { value: [0, 0, 0, 1] },
    light: { value: [0, 1, 0] },
    up: { value: [0, 1, 0] },
    shade: { value: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] },
    span: { value: [1, 1, 0, 0] },
    soft: { value: 0 },
    shadow: { value: 0 },
  };

  /** After all that is not seen through others. */
  static last = 1e6;

  /** How much is seen of a pane. */
  static clear = 0.22;

  /**
   * @typedef {{ stripes?: boolean, flat?: boolean, line?: number, lineOpacity?: number, own?: boolean, ghost?: number,
   *   casts?: boolean, pull?: number, order?: number, other?: number[], heart?: { value: number[] }, pane?: boolean, seam?: boolean }} KindStyle
   *   stripes: of the colour `other`; flat: without shades; line: width in pixels; own: lines of the colour that is
   *   pushed; ghost: how much is seen of lines and faces through what is in front of them; casts: it has a shadow; heart:
   *   it is a wall, of which faces between the eye and this place are cut away (last 1: of the body, 0: of the world); pane:
   *   what is cut away of it is seen as a pane; seam: its lines are drawn where no faces of such kinds are seen, and the faces are
   *   not drawn.
   * @param {{ faces?: { positions: number[], normals: number[], patterns: number[] }, lines?: number[] }} shape
   * @param {KindStyle} style
   */
  constructor(shape, style) {
    this.style = style;
    this.capacity = 0;
    this.count = 0;
    this.changed = false;
    const { row0, row1, row2, tint } = Gl.at;
    this.rows = new Store(new Float32Array(0), [[row0, 4], [row1, 4], [row2, 4]], true);
    this.tints = new Store(new Float32Array(0), [[tint, 4]], true);
    /** @type {GlThing[]} */
    this.things = [];
    /** The colour of lines, where it is not that of each body. */
    this.ink = { value: [0, 0, 0] };
    const order = style.order ?? 0;
    if (shape.faces && shape.faces.positions.length) this.#faces(shape.faces, order);
    if (shape.lines && shape.lines.length) this.#lines(Kind.ribbons(shape.lines), order + 1);
  }

  /** @param {{ positions: number[], normals: number[], patterns: number[] }} faces @param {number} order */
  #faces({ positions, normals, patterns }, order) {
    const { style } = this, pull = style.pull || 0, wall = style.heart !== undefined;
    const store = (/** @type {number[]} */ numbers, /** @type {number} */ at, /** @type {number} */ size) =>
      new Store(Float32Array.from(numbers), [[at, size]]);
    const mesh = new Mesh([
      store(positions, Gl.at.position, 3), store(normals, Gl.at.normal, 3), store(patterns, Gl.at.pattern, 1), this.rows, this.tints,
    ]);
    /** @param {number} opacity @param {Partial<GlPaint>} [more] @returns {GlPaint} */
    const paint = (opacity, more) => ({
      program: Shaders.face,
      uniforms: {
        ...Kind.shared, stripes: { value: style.stripes ? 1 : 0 }, ink: { value: style.other || [1, 1, 1] },
        opacity: { value: opacity }, flatness: { value: style.flat ? 1 : wall ? 0.6 : 0 }, heart: style.heart || { value: [0, 0, 0, -1] },
        pane: { value: 0 },
      },
      offset: [1 - pull, 1 - pull], both: wall,
      ...more,
    });
    this.#add(mesh, paint(1, style.seam ? { mask: "is", flat: true, offset: [1, 1] } : {}), style.seam ? Kind.last : order, style.casts);
    if (style.ghost) this.#add(mesh, paint(style.ghost, { blend: true, over: true }), Kind.last + order);
    if (!style.pane) return;
    const pane = paint(Kind.clear, { blend: true, flat: true, both: false });
    Object.assign(pane.uniforms, { pane: { value: 1 }, flatness: { value: 1 }, shadow: { value: 0 } });
    this.#add(mesh, pane, 20);
  }

  /** @param {ReturnType<typeof Kind.ribbons>} ribbons @param {number} order */
  #lines(ribbons, order) {
    const style = this.style, opacity = style.lineOpacity ?? 1, pull = 4e-5 * (1 + (style.pull || 0));
    const mesh = new Mesh([ribbons.store, this.rows, this.tints], ribbons.index);
    const paint = { width: style.line ?? 1.25, own: style.own, ink: this.ink };
    const drawn = Kind.line({ ...paint, opacity, fade: style.own !== true, pull });
    this.#add(mesh, style.seam ? { ...drawn, mask: "around" } : drawn, order);
    if (style.ghost)
      this.#add(mesh, { ...Kind.line({ ...paint, opacity: style.ghost }), over: true }, Kind.last + order);
  }

  /**
   * How lines are drawn.
   * @param {{ width: number, ink: { value: number[] }, own?: boolean, opacity?: number, pull?: number, fade?: boolean }} style
   * @returns {GlPaint}
   */
  static line({ width, ink, own, opacity, pull, fade }) {
    const { size, near } = Kind.shared;
    return {
      program: Shaders.line,
      uniforms: {
        ink, own: { value: own ? 1 : 0 }, opacity: { value: opacity ?? 1 }, width: { value: width },
        pull: { value: pull || 0 }, fade: { value: fade ? 1 : 0 }, size, near,
      },
      blend: true, flat: true, both: true,
    };
  }

  /**
   * What lines are drawn from: a ribbon for each pair of points.
   * @param {ArrayLike<number>} lines @param {ArrayLike<number>} [colors] red, green, blue of each point
   */
  static ribbons(lines, colors) {
    const n = lines.length / 6, wide = 11, data = new Float32Array(4 * wide * n), index = new Uint32Array(6 * n);
    for (let i = 0; i < n; i++) {
      for (let k = 0; k < 4; k++) {
        const here = 6 * i + (k < 2 ? 0 : 3), there = 6 * i + (k < 2 ? 3 : 0), at = wide * (4 * i + k);
        for (let c = 0; c < 3; c++) {
          data[at + c] = lines[here + c];
          data[at + 3 + c] = lines[there + c];
          if (colors) data[at + 7 + c] = colors[here + c];
        }
        data[at + 6] = k % 2 ? -1 : 1;
        if (colors) data[at + 10] = 1;
      }
      index.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3], 6 * i);
    }
    const { position, other, side, color } = Gl.at;
    return { store: new Store(data, [[position, 3], [other, 3], [side, 1], [color, 4]]), index };
  }

  /** @param {Mesh} mesh @param {GlPaint} paint @param {number} order @param {boolean} [casts] */
  #add(mesh, paint, order, casts) {
    this.things.push({ mesh, paint, order, visible: false, casts });
  }

  clear() {
    if (this.count === 0) return;
    this.count = 0;
    this.changed = true;
  }

  /**
   * One more of it.
   * @param {Float64Array | number[]} m @param {ArrayLike<number>} tint red, green, blue, and how much is seen through it
   * @returns {number} which one it is
   */
  push(m, tint) {
    if (this.count === this.capacity) this.#grow();
    const k = this.count++;
    this.move(k, m);
    for (let i = 0; i < 4; i++) this.tints.data[4 * k + i] = tint[i];
    this.tints.changed = true;
    return k;
  }

  /**
   * It is elsewhere.
   * @param {number} k which one @param {Float64Array | number[]} m
   */
  move(k, m) {
    const r = this.rows.data, at = 12 * k;
    r[at] = m[3]; r[at + 1] = m[4]; r[at + 2] = m[5]; r[at + 3] = m[0];
    r[at + 4] = m[6]; r[at + 5] = m[7]; r[at + 6] = m[8]; r[at + 7] = m[1];
    r[at + 8] = m[9]; r[at + 9] = m[10]; r[at + 10] = m[11]; r[at + 11] = m[2];
    this.changed = true;
  }

  #grow() {
    this.capacity = Math.max(4, 2 * this.capacity);
    for (const [store, size] of /** @type {[Store, number][]} */ ([[this.rows, 12], [this.tints, 4]])) {
      const more = new Float32Array(size * this.capacity);
      more.set(store.data);
      store.fill(more);
    }
  }

  /**
   * Other lines in the place of the former ones.
   * @param {number[]} lines @param {number[]} [colors]
   */
  draw(lines, colors) {
    const { mesh } = this.things[0], { store, index } = Kind.ribbons(lines, colors);
    mesh.stores[0].fill(store.data);
    mesh.fill(index);
    mesh.count = index.length;
  }

  /** Ready to be drawn. */
  finish() {
    if (!this.changed) return;
    this.changed = false;
    this.rows.changed = true;
    this.rows.used = 12 * this.count;
    this.tints.used = 4 * this.count;
    for (const thing of this.things) {
      thing.visible = this.count > 0;
      thing.mesh.copies = this.count;
    }
  }
}
