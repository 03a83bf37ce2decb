"use strict";

/**
 * Drawing by WebGL 2, as little of it as the pages need.
 *
 * All that the graphics card holds is made from what is here when it is first drawn, and again after a lost context.
 */

/** Numbers of corners, or of copies of a mesh. Who changes them sets `changed`. */
class Store {
  /**
   * @param {Float32Array} data @param {[number, number][]} parts the place of each input, and how many numbers it has
   * @param {boolean} [each] whether they are of copies
   */
  constructor(data, parts, each = false) {
    this.data = data;
    this.parts = parts;
    this.each = each;
    this.changed = true;
    /** How many numbers are in use. */
    this.used = data.length;
  }

  /** @param {Float32Array} data */
  fill(data) {
    this.data = data;
    this.used = data.length;
    this.changed = true;
  }
}

/** Triangles: of each three corners, or of each three numbers of an index. */
class Mesh {
  /** @param {Store[]} stores @param {Uint32Array} [index] */
  constructor(stores, index) {
    this.stores = stores;
    this.index = index;
    this.changed = true;
    /** How many corners are drawn, and how many times. */
    this.count = index ? index.length : stores[0].data.length / stores[0].parts.reduce((sum, [, size]) => sum + size, 0);
    this.copies = 1;
  }

  /** @param {Uint32Array} index */
  fill(index) {
    this.index = index;
    this.changed = true;
  }
}

/**
 * The two texts of a program.
 * @typedef {{ vertex: string, fragment: string }} GlProgram
 * @typedef {{ [name: string]: { value: number | ArrayLike<number> } }} GlUniforms
 *
 * How something is drawn. blend: it lets through what is behind it; over: it is not
 * hidden by anything; flat: it leaves the depth as it is; both: both sides are seen; offset: of its depth, by slope and
 * by units; mask: it is not drawn itself, but where it would be seen nothing is drawn that is to be around masks.
 * @typedef {{ program: GlProgram, uniforms: GlUniforms, blend?: boolean, over?: boolean, flat?: boolean, both?: boolean,
 *   offset?: [number, number], mask?: "is" | "around" }} GlPaint
 *
 * What is drawn: first all that is opaque, then the others, each in their order. casts: it has a shadow.
 * @typedef {{ mesh: Mesh, paint: GlPaint, order: number, visible: boolean, casts?: boolean }} GlThing
 */

class Gl {
  /** Where programs find their inputs. */
  static at = { position: 0, normal: 1, pattern: 2, other: 3, side: 4, color: 5, row0: 6, row1: 7, row2: 8, tint: 9 };

  /** How many pixels a picture of shadows has along a side. */
  static grain = 1024;

  static head = "#version 300 es\nprecision highp float;\n";

  /**
   * What draws on a canvas, or null where the browser has no WebGL 2.
   * @param {HTMLCanvasElement} canvas @param {() => void} restored
   */
  static on(canvas, restored) {
    try {
      const gl = canvas.getContext("webgl2", { alpha: true, antialias: true, stencil: true, premultipliedAlpha: true });
      return gl ? new Gl(canvas, gl, restored) : null;
    } catch (_) {
      return null;
    }
  }

  /** @param {HTMLCanvasElement} canvas @param {WebGL2RenderingContext} gl @param {() => void} restored */
  constructor(canvas, gl, restored) {
    this.canvas = canvas;
    this.gl = gl;
    /** @type {GlThing[]} */
    this.things = [];
    this.sorted = true;
    this.#begin();
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.#begin();
      restored();
    });
  }

  /** The card holds nothing yet. */
  #begin() {
    /** @type {{ frame: WebGLFramebuffer, texture: WebGLTexture } | null} */
    this.shadows = null;
    /** @type {WeakMap<Store, { buffer: WebGLBuffer, size: number }>} */
    this.buffers = new WeakMap();
    /** @type {WeakMap<Mesh, { array: WebGLVertexArrayObject, index: WebGLBuffer | null }>} */
    this.arrays = new WeakMap();
    /** @type {Map<GlProgram, { program: WebGLProgram, inputs: { name: string, set: (value: any) => void }[] }>} */
    this.programs = new Map();
  }

  /** @param {GlThing[]} things */
  add(...things) {
    this.things.push(...things);
    this.sorted = false;
  }

  /**
   * They are not drawn any more.
   * @param {GlThing[]} things
   */
  remove(...things) {
    const gone = new Set(things);
    this.things = this.things.filter((thing) => !gone.has(thing));
    for (const { mesh } of things) {
      const held = this.arrays?.get(mesh);
      if (held) {
        this.gl.deleteVertexArray(held.array);
        this.gl.deleteBuffer(held.index);
        this.arrays?.delete(mesh);
      }
      for (const store of mesh.stores) {
        this.gl.deleteBuffer(this.buffers?.get(store)?.buffer ?? null);
        this.buffers?.delete(store);
      }
    }
  }

  /** @param {number} width @param {number} height in pixels of the page @param {number} ratio pixels of the picture in one */
  size(width, height, ratio) {
    const wide = Math.floor(width * ratio + 1e-6), high = Math.floor(height * ratio + 1e-6);
    if (this.canvas.width === wide && this.canvas.height === high) return;
    this.canvas.width = wide;
    this.canvas.height = high;
  }

  /** @param {Store} store */
  #store(store) {
    const { gl } = this, { data, used } = store;
    let held = this.buffers?.get(store);
    if (!held) {
      held = { buffer: /** @type {WebGLBuffer} */ (gl.createBuffer()), size: -1 };
      this.buffers?.set(store, held);
      store.changed = true;
    }
    if (!store.changed) return held.buffer;
    store.changed = false;
    gl.bindBuffer(gl.ARRAY_BUFFER, held.buffer);
    if (held.size !== data.length) gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    else if (used > 0) gl.bufferSubData(gl.ARRAY_BUFFER, 0, data, 0, used);
    held.size = data.length;
    return held.buffer;
  }

  /** @param {Mesh} mesh */
  #bind(mesh) {
    const { gl } = this, held = this.arrays?.get(mesh);
    const buffers = mesh.stores.map((store) => this.#store(store));
    const array = held ? held.array : /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
    gl.bindVertexArray(array);
    if (!held) {
      mesh.stores.forEach(({ parts, each }, i) => {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffers[i]);
        const stride = 4 * parts.reduce((sum, [, size]) => sum + size, 0);
        let offset = 0;
        for (const [place, size] of parts) {
          gl.enableVertexAttribArray(place);
          gl.vertexAttribPointer(place, size, gl.FLOAT, false, stride, offset);
          gl.vertexAttribDivisor(place, each ? 1 : 0);
          offset += 4 * size;
        }
      });
      const index = mesh.index ? gl.createBuffer() : null;
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, index);
      this.arrays?.set(mesh, { array, index });
    }
    if (mesh.index && (mesh.changed || !held)) gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.index, gl.DYNAMIC_DRAW);
    mesh.changed = false;
  }

  /** @param {GlProgram} texts */
  #program(texts) {
    const { gl } = this, known = this.programs?.get(texts);
    if (known) return known;
    const program = /** @type {WebGLProgram} */ (gl.createProgram());
    for (const [kind, text] of /** @type {[number, string][]} */ ([[gl.VERTEX_SHADER, texts.vertex], [gl.FRAGMENT_SHADER, texts.fragment]])) {
      const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
      gl.shaderSource(shader, Gl.head + text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      gl.deleteShader(shader);
    }
    for (const [name, place] of Object.entries(Gl.at)) gl.bindAttribLocation(program, place, name);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      const said = (gl.getAttachedShaders(program) || []).map((shader) => gl.getShaderInfoLog(shader)).join(" ");
      throw new Error(`a program of the graphics card: ${gl.getProgramInfoLog(program)} ${said}`);
    }
    const made = { program, inputs: this.#inputs(program) };
    this.programs?.set(texts, made);
    return made;
  }

  /** @param {WebGLProgram} program */
  #inputs(program) {
    const { gl } = this, count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0, inputs = [];
    for (let i = 0; i < count; i++) {
      const about = gl.getActiveUniform(program, i);
      if (!about) continue;
      const at = gl.getUniformLocation(program, about.name);
      /** @type {{ [type: number]: (value: any) => void }} */
      const ways = {
        [gl.FLOAT]: (value) => gl.uniform1f(at, value),
        [gl.FLOAT_VEC2]: (value) => gl.uniform2fv(at, value),
        [gl.FLOAT_VEC3]: (value) => gl.uniform3fv(at, value),
        [gl.FLOAT_VEC4]: (value) => gl.uniform4fv(at, value),
        [gl.FLOAT_MAT4]: (value) => gl.uniformMatrix4fv(at, false, value),
        [gl.SAMPLER_2D_SHADOW]: () => gl.bindTexture(gl.TEXTURE_2D, this.#shadows().texture),
      };
      inputs.push({ name: about.name, set: ways[about.type] });
    }
    return inputs;
  }

  /** @param {GlPaint} paint */
  #set({ blend, over, flat, both, offset, mask }) {
    const { gl } = this;
    /** @param {number} what @param {unknown} on */
    const able = (what, on) => (on ? gl.enable(what) : gl.disable(what));
    able(gl.BLEND, blend);
    able(gl.DEPTH_TEST, !over);
    able(gl.CULL_FACE, !both);
    able(gl.POLYGON_OFFSET_FILL, offset);
    gl.depthMask(!flat && !over);
    if (offset) gl.polygonOffset(...offset);
    able(gl.STENCIL_TEST, mask);
    gl.colorMask(mask !== "is", mask !== "is", mask !== "is", mask !== "is");
    if (!mask) return;
    gl.stencilFunc(mask === "is" ? gl.ALWAYS : gl.NOTEQUAL, 1, 1);
    gl.stencilOp(gl.KEEP, gl.KEEP, mask === "is" ? gl.REPLACE : gl.KEEP);
  }

  /**
   * Draws all anew.
   * @param {ArrayLike<number>} camera from the world to clip space, by columns
   */
  draw(camera) {
    const { gl } = this;
    if (gl.isContextLost()) return;
    if (!this.sorted) {
      this.things.sort((a, b) => Number(a.paint.blend || 0) - Number(b.paint.blend || 0) || a.order - b.order);
      this.sorted = true;
    }
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.depthMask(true);
    gl.colorMask(true, true, true, true);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.depthFunc(gl.LEQUAL);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    for (const { mesh, paint, visible } of this.things) if (visible) this.#one(mesh, paint, camera);
    gl.bindVertexArray(null);
  }

  /** @param {Mesh} mesh @param {GlPaint} paint @param {ArrayLike<number>} camera */
  #one(mesh, paint, camera) {
    if (mesh.count === 0 || mesh.copies === 0) return;
    const { gl } = this, { program, inputs } = this.#program(paint.program);
    gl.useProgram(program);
    for (const { name, set } of inputs) set(name === "camera" ? camera : paint.uniforms[name]?.value);
    this.#set(paint);
    this.#bind(mesh);
    if (mesh.index) gl.drawElementsInstanced(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0, mesh.copies);
    else gl.drawArraysInstanced(gl.TRIANGLES, 0, mesh.count, mesh.copies);
  }

  /** The depths of all that casts shadows, as the light sees it. */
  #shadows() {
    if (this.shadows) return this.shadows;
    const { gl } = this, texture = /** @type {WebGLTexture} */ (gl.createTexture());
    const frame = /** @type {WebGLFramebuffer} */ (gl.createFramebuffer());
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, Gl.grain, Gl.grain);
    for (const [name, value] of [
      [gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
      [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE], [gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE],
    ]) gl.texParameteri(gl.TEXTURE_2D, name, value);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, texture, 0);
    gl.drawBuffers([gl.NONE]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.shadows = { frame, texture };
    return this.shadows;
  }

  /**
   * Which shadows there are, until the next time.
   * @param {ArrayLike<number>} light from the world to clip space, as the light sees it @param {GlProgram} program
   */
  shade(light, program) {
    const { gl } = this;
    if (gl.isContextLost()) return;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#shadows().frame);
    gl.viewport(0, 0, Gl.grain, Gl.grain);
    gl.depthMask(true);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.depthFunc(gl.LEQUAL);
    for (const { mesh, paint: { uniforms }, visible, casts } of this.things)
      if (visible && casts) this.#one(mesh, { program, uniforms, both: true }, light);
    gl.bindVertexArray(null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
}
