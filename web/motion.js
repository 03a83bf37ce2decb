"use strict";

/**
 * Where a process is, so long after it came: exactly, and as floats relative to some point.
 *
 * A process goes in a straight line, and one with a turn about its centre of mass as well, by the Cayley map of its spin
 * (rule Turn): t after it came its rotation is the quaternion 1 + spin (since + t) / 2, times how it was turned at the
 * start of that turn. All of it is computed over integers, with one division at the end.
 *
 * @typedef {{ n: bigint[], d: bigint }} Ints  Integers over one denominator.
 * @typedef {{ n: number[], d: number }} Floats  The same as floats, each a whole number below 2^53 in size.
 * @typedef {Ints & { numbers: Floats | null }} Target  What floats are relative to.
 * @typedef {{ n: bigint, d: bigint }} Age  How long ago the process came; need not be in lowest terms.
 * @typedef {[bigint, bigint, bigint, bigint]} Quaternion  w, x, y, z.
 * @typedef {{ at: Ints, velocity: Ints, turned: Quaternion, numbers: { at: number[], velocity: number[], d: number } | null,
 *   matrix: number[] | null }} Straight
 * @typedef {{ centre: Ints, velocity: Ints, arm: Ints, spin: Ints, since: Rational, turned: Quaternion }} Turning
 */
const Motion = (() => {
  const safe = 2 ** 53;

  /** @param {bigint} a @param {bigint} b */
  function gcd(a, b) {
    while (b !== 0n) [a, b] = [b, a % b];
    return a;
  }

  /** @param {readonly string[]} texts @returns {Ints} */
  function ints(texts) {
    const all = texts.map(Rational.of);
    let d = 1n;
    for (const r of all) d *= r.d / gcd(r.d, d);
    return { n: all.map((r) => r.n * (d / r.d)), d };
  }

  /** @param {bigint[]} a @param {bigint[]} b */
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

  /** @param {bigint[]} a @param {bigint[]} b */
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

  /** @param {Quaternion} p @param {Quaternion} q @returns {Quaternion} turns by q first */
  function product(p, q) {
    const v = cross(p.slice(1), q.slice(1));
    return [
      p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
      p[0] * q[1] + q[0] * p[1] + v[0],
      p[0] * q[2] + q[0] * p[2] + v[1],
      p[0] * q[3] + q[0] * p[3] + v[2],
    ];
  }

  /** @param {Quaternion} q */
  const norm = (q) => q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];

  /**
   * The image of a vector, times the norm.
   * @param {Quaternion} q @param {bigint[]} a
   */
  function turn(q, a) {
    const [w, ...u] = q;
    const along = 2n * dot(u, a), aside = cross(u, a), stay = w * w - dot(u, u);
    return [0, 1, 2].map((i) => stay * a[i] + along * u[i] + 2n * w * aside[i]);
  }

  /**
   * The rotation as a matrix by rows, times the norm.
   * @param {Quaternion} q
   */
  function matrix(q) {
    const x = turn(q, [1n, 0n, 0n]), y = turn(q, [0n, 1n, 0n]), z = turn(q, [0n, 0n, 1n]);
    return [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]];
  }

  /** @param {string[] | undefined} texts @returns {Quaternion} */
  const quaternion = (texts) => (texts ? /** @type {Quaternion} */ (texts.map(BigInt)) : [1n, 0n, 0n, 0n]);

  /** @param {Ints} a @param {Ints} b @returns {[bigint[], bigint[], bigint]} both over one denominator */
  function together(a, b) {
    const d = (a.d / gcd(a.d, b.d)) * b.d;
    return [a.n.map((n) => n * (d / a.d)), b.n.map((n) => n * (d / b.d)), d];
  }

  /** @param {bigint} a */
  const small = (a) => a < 9007199254740992n && a > -9007199254740992n;

  /** @param {DataProcess} process @param {DataPlace} place @returns {Straight} */
  function straight(process, place) {
    const [at, velocity, d] = together(ints(place.at), ints(process.velocity));
    const turned = quaternion(place.turned);
    const n = norm(turned);
    return {
      at: { n: at, d },
      velocity: { n: velocity, d },
      turned,
      numbers: [...at, ...velocity, d].every(small)
        ? { at: at.map(Number), velocity: velocity.map(Number), d: Number(d) } : null,
      matrix: turned[1] || turned[2] || turned[3] ? matrix(turned).map((m) => Rational.ratio(m, n)) : null,
    };
  }

  /** @param {DataProcess} process @param {DataPlace} place @returns {Turning} */
  function turning(process, place) {
    const of = /** @type {NonNullable<DataProcess["turn"]>} */ (process.turn);
    return {
      centre: ints(of.centre),
      velocity: ints(process.velocity),
      arm: ints(/** @type {string[]} */ (place.arm)),
      spin: ints(of.spin),
      since: Rational.of(of.since),
      turned: quaternion(place.turned),
    };
  }

  /**
   * How far it has turned since the start of its turn.
   * @param {Turning} m @param {Age} age @returns {Quaternion}
   */
  function rotation(m, age) {
    const n = m.since.n * age.d + age.n * m.since.d, d = m.since.d * age.d;
    return /** @type {Quaternion} */ ([2n * m.spin.d * d, ...m.spin.n.map((w) => w * n)]);
  }

  /**
   * Where the leaf's point of reference is.
   * @param {Straight | Turning} m @param {Age} age @returns {Ints}
   */
  function position(m, age) {
    if ("at" in m)
      return { n: m.at.n.map((a, i) => a * age.d + m.velocity.n[i] * age.n), d: m.at.d * age.d };
    const q = rotation(m, age);
    const arm = turn(q, m.arm.n), armD = norm(q) * m.arm.d;
    const goneD = m.velocity.d * age.d;
    return {
      n: m.centre.n.map((c, i) =>
        c * goneD * armD + m.velocity.n[i] * age.n * m.centre.d * armD + arm[i] * m.centre.d * goneD),
      d: m.centre.d * goneD * armD,
    };
  }

  /**
   * How the leaf is turned, as a matrix by rows.
   * @param {Straight | Turning} m @param {Age} age @returns {Ints}
   */
  function orientation(m, age) {
    const q = "at" in m ? m.turned : product(rotation(m, age), m.turned);
    return { n: matrix(q), d: norm(q) };
  }

  /**
   * As floats, each the nearest one to the exact number: the position relative to a target, in out[0..2], and the rows of
   * the rotation, in out[3..11].
   * @param {Straight | Turning} m @param {() => Age} age
   * @param {number} n @param {number} d the age once more, in floats that are whole numbers, or NaN
   * @param {Target} target @param {Float64Array | number[]} out
   */
  function place(m, age, n, d, target, out) {
    if (!("at" in m)) {
      const gone = age();
      write(position(m, gone), target, out);
      const o = orientation(m, gone);
      for (let i = 0; i < 9; i++) out[3 + i] = Rational.ratio(o.n[i], o.d);
      return;
    }
    if (m.matrix) for (let i = 0; i < 9; i++) out[3 + i] = m.matrix[i];
    else {
      out[3] = out[7] = out[11] = 1;
      out[4] = out[5] = out[6] = out[8] = out[9] = out[10] = 0;
    }
    if (!m.numbers || !target.numbers || !quick(m.numbers, n, d, target.numbers, out))
      write(position(m, age()), target, out);
  }

  /**
   * What floats are to be relative to.
   * @param {Ints} p @returns {Target}
   */
  function target(p) {
    const numbers = [...p.n, p.d].every(small) ? { n: p.n.map(Number), d: Number(p.d) } : null;
    return { n: p.n, d: p.d, numbers };
  }

  /** @param {Ints} p @param {Ints} target @param {Float64Array | number[]} out */
  function write(p, target, out) {
    for (let i = 0; i < 3; i++) out[i] = Rational.ratio(p.n[i] * target.d - target.n[i] * p.d, p.d * target.d);
  }

  /**
   * The same in floats, as long as all that comes up is a whole number that a float can be: then nothing is rounded but
   * the last quotient, to the nearest. False where that is not so; a product that is too great is never told as less.
   * @param {{ at: number[], velocity: number[], d: number }} m @param {number} n @param {number} d  of the age
   * @param {Floats} target @param {Float64Array | number[]} out
   */
  function quick(m, n, d, target, out) {
    const td = target.d, below = m.d * d;
    const all = below * td;
    if (!(Math.abs(n) < safe && d < safe && below < safe && all < safe)) return false;
    for (let i = 0; i < 3; i++) {
      const a = m.at[i] * d, b = m.velocity[i] * n;
      const here = a + b, c = here * td, e = target.n[i] * below;
      if (!(Math.abs(a) < safe && Math.abs(b) < safe && Math.abs(here) < safe)) return false;
      if (!(Math.abs(c) < safe && Math.abs(e) < safe && Math.abs(c - e) < safe)) return false;
      out[i] = (c - e) / all;
    }
    return true;
  }

  return { ints, straight, turning, position, orientation, target, place };
})();
