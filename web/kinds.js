"use strict";

/** The programs that draw what {@link Kind} has. */
const Shaders = (() => {
  const rows = "attribute vec4 row0; attribute vec4 row1; attribute vec4 row2; attribute vec4 tint;";

  const faceVertex = `
    ${rows} attribute float pattern; uniform float flatten; uniform float ground; uniform vec3 up;
    varying vec3 vNormal; varying vec4 vTint; varying float vPattern;
    void main() {
      vec4 p = vec4(position, 1.0);
      vec3 world = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
      vNormal = vec3(dot(row0.xyz, normal), dot(row1.xyz, normal), dot(row2.xyz, normal));
      vTint = tint;
      vPattern = pattern;
      if (flatten > 0.5) world = mix(world, vec3(ground), up);
      gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
    }`;

  // Light from above and from the right of the front, so that each side of a cube has its own shade.
  const faceFragment = `
    uniform float stripes; uniform float opacity; uniform float flatness; uniform vec3 other;
    uniform vec3 light; varying vec3 vNormal; varying vec4 vTint; varying float vPattern;
    void main() {
      float shine = 0.56 + 0.48 * (0.5 + 0.5 * dot(normalize(vNormal), light));
      vec3 base = vTint.rgb;
      if (stripes > 0.5 && fract(vPattern) < 0.5) base = mix(base, other, 0.72);
      gl_FragColor = vec4(base * mix(shine, 1.0, flatness), opacity * (1.0 - vTint.a));
    }`;

  const shadowFragment = `
    uniform vec3 color; uniform float opacity;
    void main() { gl_FragColor = vec4(color, opacity); }`;

  // Lines of so many pixels. What is behind the camera is cut off first.
  const lineVertex = `
    ${rows} attribute vec3 other; attribute float side; attribute vec4 color4;
    uniform vec2 size; uniform float width; uniform float near; uniform float pull; uniform float fade;
    varying vec4 vColor;
    vec4 place(vec3 q) {
      vec4 p = vec4(q, 1.0);
      return projectionMatrix * viewMatrix * vec4(dot(row0, p), dot(row1, p), dot(row2, p), 1.0);
    }
    void main() {
      vec4 a = place(position), b = place(other);
      if (a.w < near && b.w > near) a = mix(a, b, (near - a.w) / (b.w - a.w));
      else if (b.w < near && a.w > near) b = mix(b, a, (near - b.w) / (a.w - b.w));
      vec2 d = (b.xy / b.w - a.xy / a.w) * size;
      // The edges of what is small in the picture would hide it.
      float seen = fade > 0.5 ? smoothstep(1.0, 12.0, 0.5 * length(d)) : 1.0;
      d = length(d) > 0.0 ? normalize(d) : vec2(0.0);
      a.xy += (side * vec2(-d.y, d.x) - 0.5 * d) * width * a.w / size;
      a.z -= pull * a.w;
      vColor = vec4(mix(tint.rgb, color4.rgb, color4.a), seen * (1.0 - tint.a));
      gl_Position = a;
    }`;

  const lineFragment = `
    uniform vec3 color; uniform float opacity; uniform float own;
    varying vec4 vColor;
    void main() { gl_FragColor = vec4(mix(color, vColor.rgb, own), opacity * vColor.a); }`;

  return { faceVertex, faceFragment, shadowFragment, lineVertex, lineFragment };
})();

/**
 * What is drawn many times: one geometry, and for each time it is drawn a place, a rotation and a colour.
 *
 * They come as {@link Motion.place} writes them: x y z, then the rotation by rows.
 */
class Kind {
  /**
   * What all of them share: the size of the picture, how near is too near, where the floor is, which way is up, and from
   * where the light comes.
   */
  static shared = {
    size: { value: typeof THREE === "undefined" ? null : new THREE.Vector2(1, 1) },
    near: { value: 0 },
    ground: { value: 0 },
    up: { value: typeof THREE === "undefined" ? null : new THREE.Vector3(0, 1, 0) },
    light: { value: typeof THREE === "undefined" ? null : new THREE.Vector3(0, 1, 0) },
    shadow: { value: 0.1 },
  };

  /** After all layers of glass. */
  static last = 1e6;

  /**
   * @typedef {{ opacity?: number, stripes?: boolean, flat?: boolean, line?: number, lineOpacity?: number, own?: boolean,
   *   ghost?: number, shadow?: boolean, pull?: number, order?: number, other?: number[], layer?: number }} KindStyle
   *   opacity below 1: as of glass, of which the nearest surface alone is seen, and through it glass of lower layers; stripes: of the colour `other`; flat: without
   *   shades; line: width in pixels; own: lines of the colour that is pushed; ghost: how much is seen of lines and faces
   *   through what is in front of them.
   * @param {{ faces?: { positions: number[], normals: number[], patterns: number[] }, lines?: number[] }} shape
   * @param {KindStyle} style
   */
  constructor(shape, style) {
    this.style = style;
    this.capacity = 0;
    this.count = 0;
    this.changed = false;
    this.rows = new Float32Array(0);
    this.tints = new Float32Array(0);
    /** @type {any[]} */
    this.objects = [];
    /** @type {any[]} */
    this.geometries = [];
    /** The colour of lines, where it is not that of each body. */
    this.ink = { value: new THREE.Color(0x000000) };
    const order = style.order ?? 0;
    if (shape.faces && shape.faces.positions.length) this.#faces(shape.faces, order);
    if (shape.lines && shape.lines.length) this.#lines(Kind.ribbons(shape.lines), order + 1);
  }

  /** @param {{ positions: number[], normals: number[], patterns: number[] }} faces @param {number} order */
  #faces(faces, order) {
    const style = this.style, opacity = style.opacity ?? 1, glass = opacity < 1;
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(faces.positions, 3));
    geometry.setAttribute("normal", new THREE.Float32BufferAttribute(faces.normals, 3));
    geometry.setAttribute("pattern", new THREE.Float32BufferAttribute(faces.patterns, 1));
    this.geometries.push(geometry);
    const material = (/** @type {{ [key: string]: any }} */ more, /** @type {{ [key: string]: any }} */ uniforms) =>
      new THREE.ShaderMaterial({
        vertexShader: Shaders.faceVertex,
        fragmentShader: Shaders.faceFragment,
        uniforms: {
          stripes: { value: style.stripes ? 1 : 0 }, other: { value: new THREE.Vector3(...(style.other || [1, 1, 1])) },
          opacity: { value: opacity }, flatness: { value: style.flat ? 1 : 0 }, flatten: { value: 0 },
          ground: Kind.shared.ground, up: Kind.shared.up, light: Kind.shared.light, ...uniforms,
        },
        polygonOffset: true, polygonOffsetFactor: 1 - (style.pull || 0), polygonOffsetUnits: 1 - (style.pull || 0),
        ...more,
      });
    if (glass) {
      const first = order + 3 + 3 * (style.layer ?? 0);
      this.#add(geometry, new THREE.Mesh(geometry, material({ colorWrite: false, transparent: true }, {})), first);
      this.#add(geometry, new THREE.Mesh(geometry, material({ transparent: true, depthWrite: false }, {})), first + 1);
    } else this.#add(geometry, new THREE.Mesh(geometry, material({}, {})), order);
    if (style.ghost)
      this.#add(geometry, new THREE.Mesh(geometry, material(
        { transparent: true, depthTest: false, depthWrite: false }, { opacity: { value: style.ghost } })), Kind.last + order);
    if (style.shadow) {
      // Each place of the floor is darkened once.
      const shadow = new THREE.ShaderMaterial({
        vertexShader: Shaders.faceVertex, fragmentShader: Shaders.shadowFragment,
        uniforms: {
          flatten: { value: 1 }, ground: Kind.shared.ground, up: Kind.shared.up, opacity: Kind.shared.shadow,
          color: { value: new THREE.Color(0x000000) },
        },
        transparent: true, depthWrite: false, side: THREE.DoubleSide,
        stencilWrite: true, stencilRef: 1, stencilFunc: THREE.NotEqualStencilFunc, stencilZPass: THREE.ReplaceStencilOp,
      });
      this.#add(geometry, new THREE.Mesh(geometry, shadow), -5);
    }
  }

  /** @param {ReturnType<typeof Kind.ribbons>} ribbons @param {number} order */
  #lines(ribbons, order) {
    const style = this.style, opacity = style.lineOpacity ?? 1;
    const geometry = new THREE.InstancedBufferGeometry();
    Kind.fill(geometry, ribbons);
    this.geometries.push(geometry);
    const line = Kind.line({
      width: style.line ?? 1.25, own: style.own, opacity, fade: style.own !== true,
      pull: 4e-5 * (1 + (style.pull || 0)),
    });
    line.uniforms.color = this.ink;
    this.#add(geometry, new THREE.Mesh(geometry, line), style.opacity ? order + 4 + 3 * (style.layer ?? 0) : order);
    if (!style.ghost) return;
    const ghost = Kind.line({ width: style.line ?? 1.25, own: style.own, opacity: style.ghost });
    ghost.uniforms.color = this.ink;
    ghost.depthTest = false;
    this.#add(geometry, new THREE.Mesh(geometry, ghost), Kind.last + order);
  }

  /**
   * @param {{ width: number, own?: boolean, opacity?: number, pull?: number, fade?: boolean }} style
   * @returns {any} a material for lines
   */
  static line({ width, own, opacity, pull, fade }) {
    return new THREE.ShaderMaterial({
      vertexShader: Shaders.lineVertex,
      fragmentShader: Shaders.lineFragment,
      uniforms: {
        color: { value: new THREE.Color(0x000000) }, own: { value: own ? 1 : 0 }, opacity: { value: opacity ?? 1 },
        width: { value: width }, pull: { value: pull || 0 }, fade: { value: fade ? 1 : 0 },
        size: Kind.shared.size, near: Kind.shared.near,
      },
      transparent: true, depthWrite: false, side: THREE.DoubleSide,
    });
  }

  /**
   * What lines are drawn from: a ribbon for each pair of points.
   * @param {ArrayLike<number>} lines @param {ArrayLike<number>} [colors] red, green, blue of each point
   */
  static ribbons(lines, colors) {
    const n = lines.length / 6;
    const position = new Float32Array(12 * n), other = new Float32Array(12 * n), side = new Float32Array(4 * n);
    const color = new Float32Array(16 * n), index = new Uint32Array(6 * n);
    for (let i = 0; i < n; i++) {
      for (let k = 0; k < 4; k++) {
        const here = 6 * i + (k < 2 ? 0 : 3), there = 6 * i + (k < 2 ? 3 : 0);
        for (let c = 0; c < 3; c++) {
          position[12 * i + 3 * k + c] = lines[here + c];
          other[12 * i + 3 * k + c] = lines[there + c];
          if (colors) color[16 * i + 4 * k + c] = colors[here + c];
        }
        if (colors) color[16 * i + 4 * k + 3] = 1;
        side[4 * i + k] = k % 2 ? -1 : 1;
      }
      index.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3], 6 * i);
    }
    return { position, other, side, color, index };
  }

  /** @param {any} geometry @param {ReturnType<typeof Kind.ribbons>} ribbons */
  static fill(geometry, { position, other, side, color, index }) {
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("other", new THREE.BufferAttribute(other, 3));
    geometry.setAttribute("side", new THREE.BufferAttribute(side, 1));
    geometry.setAttribute("color4", new THREE.BufferAttribute(color, 4));
    geometry.setIndex(new THREE.BufferAttribute(position.length / 3 < 65536 ? Uint16Array.from(index) : index, 1));
  }

  /** @param {any} geometry @param {any} object @param {number} order */
  #add(geometry, object, order) {
    object.frustumCulled = false;
    object.matrixAutoUpdate = false;
    object.renderOrder = order;
    object.visible = false;
    this.objects.push(object);
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
    for (let i = 0; i < 4; i++) this.tints[4 * k + i] = tint[i];
    return k;
  }

  /**
   * It is elsewhere.
   * @param {number} k which one @param {Float64Array | number[]} m
   */
  move(k, m) {
    const r = this.rows, at = 12 * k;
    r[at] = m[3]; r[at + 1] = m[4]; r[at + 2] = m[5]; r[at + 3] = m[0];
    r[at + 4] = m[6]; r[at + 5] = m[7]; r[at + 6] = m[8]; r[at + 7] = m[1];
    r[at + 8] = m[9]; r[at + 9] = m[10]; r[at + 10] = m[11]; r[at + 11] = m[2];
    this.changed = true;
  }

  #grow() {
    const old = { rows: this.rows, tints: this.tints };
    this.capacity = Math.max(4, 2 * this.capacity);
    this.rows = new Float32Array(12 * this.capacity);
    this.tints = new Float32Array(4 * this.capacity);
    this.rows.set(old.rows);
    this.tints.set(old.tints);
    this.buffer = new THREE.InstancedInterleavedBuffer(this.rows, 12, 1);
    this.colors = new THREE.InstancedBufferAttribute(this.tints, 4, false, 1);
    this.buffer.setUsage(THREE.DynamicDrawUsage);
    this.colors.setUsage(THREE.DynamicDrawUsage);
    for (const g of this.geometries) {
      for (let i = 0; i < 3; i++)
        g.setAttribute("row" + i, new THREE.InterleavedBufferAttribute(this.buffer, 4, 4 * i));
      g.setAttribute("tint", this.colors);
    }
  }

  /** Ready to be drawn. */
  finish() {
    if (!this.changed) return;
    this.changed = false;
    for (const g of this.geometries) g.maxInstancedCount = this.count;
    for (const o of this.objects) o.visible = this.count > 0;
    if (this.count > 0) {
      this.buffer.needsUpdate = true;
      this.colors.needsUpdate = true;
    }
  }

  dispose() {
    for (const g of this.geometries) g.dispose();
    for (const o of this.objects) o.material.dispose();
  }
}
