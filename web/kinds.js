"use strict";

/** The programs that draw what {@link Kind} has. */
const Shaders = (() => {
  const vertexShader = `
    attribute vec4 row0; attribute vec4 row1; attribute vec4 row2; attribute vec4 tint;
    varying vec3 vNormal; varying vec4 vTint; varying vec3 vBody;
    void main() {
      vec4 p = vec4(position, 1.0);
      vec3 world = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
      vNormal = vec3(dot(row0.xyz, normal), dot(row1.xyz, normal), dot(row2.xyz, normal));
      vTint = tint;
      vBody = position;
      gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
    }`;

  // Light from above and from beside the viewer; stripes for what absorbs, and for co-names.
  const faceShader = `
    uniform vec3 light; uniform float stripes; uniform float stripeSize; uniform float opacity; uniform float flatness;
    varying vec3 vNormal; varying vec4 vTint; varying vec3 vBody;
    void main() {
      vec3 n = normalize(vNormal);
      float shine = 0.62 + 0.30 * max(dot(n, light), 0.0) + 0.12 * n.y;
      vec3 color = vTint.rgb * mix(shine, 1.0, flatness);
      if (stripes > 0.5) {
        float s = fract((vBody.x + vBody.y + vBody.z) / stripeSize);
        if (s < 0.5) color = mix(color, vec3(1.0), 0.55);
      }
      gl_FragColor = vec4(color + vec3(0.22) * vTint.a, opacity);
    }`;

  const lineShader = `
    uniform vec3 color; uniform float opacity; uniform float own;
    varying vec4 vTint;
    void main() { gl_FragColor = vec4(mix(color, vTint.rgb, own), opacity); }`;

  return { vertices: vertexShader, faces: faceShader, lines: lineShader };
})();

/**
 * What is drawn many times: one geometry, and for each time it is drawn a place, a rotation and a colour.
 *
 * They come as {@link Motion.place} writes them: x y z, then the rotation by rows.
 */
class Kind {
  /**
   * @param {{ faces?: { positions: number[], normals: number[] }, lines?: number[] }} shape
   * @param {{ opacity?: number, stripes?: boolean, stripeSize?: number, flat?: boolean, above?: boolean, lineOpacity?: number,
   *   ownLines?: boolean, order?: number, pull?: boolean }} style  above: seen through what is in front of it
   */
  constructor(shape, style) {
    this.capacity = 0;
    this.count = 0;
    this.rows = new Float32Array(0);
    this.tints = new Float32Array(0);
    /** @type {any[]} */
    this.objects = [];
    /** @type {any[]} */
    this.geometries = [];
    const blend = (style.opacity ?? 1) < 1;
    if (shape.faces) {
      const geometry = new THREE.InstancedBufferGeometry();
      geometry.setAttribute("position", new THREE.Float32BufferAttribute(shape.faces.positions, 3));
      geometry.setAttribute("normal", new THREE.Float32BufferAttribute(shape.faces.normals, 3));
      this.faces = new THREE.ShaderMaterial({
        vertexShader: Shaders.vertices,
        fragmentShader: Shaders.faces,
        uniforms: {
          light: { value: new THREE.Vector3(0.35, 0.75, 0.56) },
          stripes: { value: style.stripes ? 1 : 0 },
          stripeSize: { value: style.stripeSize ?? 1 },
          opacity: { value: style.opacity ?? 1 },
          flatness: { value: style.flat ? 1 : 0 },
        },
        transparent: blend || style.above === true,
        depthWrite: !blend && !style.above,
        depthTest: !style.above,
        side: THREE.FrontSide,
        polygonOffset: true,
        polygonOffsetFactor: style.pull ? -1 : 1,
        polygonOffsetUnits: style.pull ? -2 : 1,
      });
      this.#add(new THREE.Mesh(geometry, this.faces), geometry, style.order ?? (blend ? 2 : 0));
    }
    if (shape.lines) {
      const geometry = new THREE.InstancedBufferGeometry();
      geometry.setAttribute("position", new THREE.Float32BufferAttribute(shape.lines, 3));
      geometry.setAttribute("normal", new THREE.Float32BufferAttribute(new Float32Array(shape.lines.length), 3));
      this.edges = new THREE.ShaderMaterial({
        vertexShader: Shaders.vertices,
        fragmentShader: Shaders.lines,
        uniforms: {
          color: { value: new THREE.Color(0x000000) },
          opacity: { value: style.lineOpacity ?? 1 },
          own: { value: style.ownLines ? 1 : 0 },
        },
        transparent: (style.lineOpacity ?? 1) < 1 || style.above === true,
        depthTest: !style.above,
        depthWrite: !style.above,
      });
      this.#add(new THREE.LineSegments(geometry, this.edges), geometry, (style.order ?? 0) + 1);
    }
  }

  /**
   * @param {any} object @param {any} geometry @param {number} order
   */
  #add(object, geometry, order) {
    object.frustumCulled = false;
    object.renderOrder = order;
    this.objects.push(object);
    this.geometries.push(geometry);
  }

  clear() { this.count = 0; }

  /**
   * One more of it.
   * @param {Float64Array | number[]} m @param {number[]} tint red, green, blue, and how much brighter, from 0 to 1
   */
  push(m, tint) {
    if (this.count === this.capacity) this.#grow();
    const r = this.rows, at = 12 * this.count;
    r[at] = m[3]; r[at + 1] = m[4]; r[at + 2] = m[5]; r[at + 3] = m[0];
    r[at + 4] = m[6]; r[at + 5] = m[7]; r[at + 6] = m[8]; r[at + 7] = m[1];
    r[at + 8] = m[9]; r[at + 9] = m[10]; r[at + 10] = m[11]; r[at + 11] = m[2];
    this.tints.set(tint, 4 * this.count);
    this.count++;
  }

  #grow() {
    const old = { rows: this.rows, tints: this.tints };
    this.capacity = Math.max(4, 2 * this.capacity);
    this.rows = new Float32Array(12 * this.capacity);
    this.tints = new Float32Array(4 * this.capacity);
    this.rows.set(old.rows);
    this.tints.set(old.tints);
    this.buffer = new THREE.InstancedInterleavedBuffer(this.rows, 12, false, 1);
    this.colors = new THREE.InstancedBufferAttribute(this.tints, 4, false, 1);
    this.buffer.setUsage && this.buffer.setUsage(THREE.DynamicDrawUsage);
    for (const g of this.geometries) {
      for (let i = 0; i < 3; i++)
        g.setAttribute("row" + i, new THREE.InterleavedBufferAttribute(this.buffer, 4, 4 * i));
      g.setAttribute("tint", this.colors);
    }
  }

  /** Ready to be drawn. */
  finish() {
    for (const g of this.geometries) g.maxInstancedCount = this.count;
    for (const o of this.objects) o.visible = this.count > 0;
    if (this.count > 0) {
      this.buffer.needsUpdate = true;
      this.colors.needsUpdate = true;
    }
  }
}
