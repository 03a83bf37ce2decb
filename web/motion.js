"use strict";

/**
 * Where a process is, so long after it came: exactly, and as floats relative to some point.
 *
 * A process goes in a straight line, and one with a turn about its centre of mass as well, by the Cayley map of its spin
 * (rule Turn): t after it came its rotation is the quaternion 1 + spin (since + t) / 2, times how it was turned at the
 * start of that turn. All of it is computed over integers, with one division at the end.
 *
 * @typedef {{ n: bigint[], d: bigint }} Ints  Integers over one denominator.
 * @typedef {{ at: Ints, name: number }} Anchor  A place that floats are held relative to, with its number.
 * @typedef {Ints & { anchor: Anchor, high: number[], low: number[] }} Target  What floats are relative to: exactly, and
 *   from the anchor by twofold floats.
 * @typedef {{ n: bigint, d: bigint }} Age  How long ago the process came; need not be in lowest terms.
 * @typedef {[bigint, bigint, bigint, bigint]} Quaternion  w, x, y, z.
 * @typedef {{ at: Ints, velocity: Ints, turned: Quaternion, matrix: number[] | null, held: Held | null }} Straight
 * @typedef {{ centre: Ints, velocity: Ints, arm: Ints, spin: Ints, since: Rational, turned: Quaternion,
 *   held: Held | null }} Turning
 * @typedef {{ anchor: number, floats: Float64Array, quadrics: Float64Array | null, speed: number }} Held  A motion in
 *   twofold floats: its place at first (3) and velocity (3); what turns, see {@link turned}.
 */
const Motion = (() => {
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

  /** @param {DataProcess} process @param {DataPlace} place @returns {Straight} */
  function straight(process, place) {
    const [at, velocity, d] = together(ints(place.at), ints(process.velocity));
    const turned = quaternion(place.turned);
    const n = norm(turned);
    return {
      at: { n: at, d },
      velocity: { n: velocity, d },
      turned,
      held: null,
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
      held: null,
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

  // The last anchor: targets near it share it.
  /** @type {Anchor} */
  let anchor = { at: { n: [0n, 0n, 0n], d: 1n }, name: 0 };

  /**
   * What floats are to be relative to.
   * @param {Ints} p @returns {Target}
   */
  function target(p) {
    let from = away(p, anchor.at);
    if (!from.every((x) => Math.abs(x.high) < 1e6)) {
      anchor = { at: { n: p.n, d: p.d }, name: anchor.name + 1 };
      from = away(p, anchor.at);
    }
    return { n: p.n, d: p.d, anchor, high: from.map((x) => x.high), low: from.map((x) => x.low) };
  }

  /**
   * One place from another, by twofold floats.
   * @param {Ints} p @param {Ints} q
   */
  function away(p, q) {
    return p.n.map((n, i) => {
      const high = Twofold.of(n * q.d - q.n[i] * p.d, p.d * q.d);
      return { high, low: Twofold.low[0] };
    });
  }

  /**
   * The motion in twofold floats.
   *
   * Where it turns, x = C(s w) a, w half the spin, is (a + s (q + s p)) / (1 + s² |w|²) with q = 2 w × a and
   * p = 2 (w·a) w - |w|² a. Four vectors turn: the arm, and the columns of the rotation at the start of the turn. Of each of
   * their coordinates the quadrics hold a, q and p; and at the end |w|² and how long ago the turn began.
   * @param {Straight | Turning} m @param {Anchor} to @returns {Held}
   */
  function hold(m, to) {
    const start = "at" in m ? m.at : m.centre;
    const floats = new Float64Array(12);
    away(start, to.at).forEach((x, i) => { floats[2 * i] = x.high; floats[2 * i + 1] = x.low; });
    m.velocity.n.forEach((n, i) => {
      floats[6 + 2 * i] = Twofold.of(n, m.velocity.d);
      floats[7 + 2 * i] = Twofold.low[0];
    });
    if ("at" in m) return { anchor: to.name, floats, quadrics: null, speed: 0 };
    const quadrics = new Float64Array(76);
    const put = (/** @type {number} */ at, /** @type {bigint} */ n, /** @type {bigint} */ d) => {
      quadrics[at] = Twofold.of(n, d);
      quadrics[at + 1] = Twofold.low[0];
    };
    const w = m.spin.n, wd = 2n * m.spin.d, w2 = dot(w, w);
    const turned = matrix(m.turned), n2 = norm(m.turned);
    const vectors = [m.arm, ...[0, 1, 2].map((k) => ({ n: [turned[k], turned[k + 3], turned[k + 6]], d: n2 }))];
    vectors.forEach((a, k) => {
      const q = cross(w, a.n), along = dot(w, a.n);
      for (let i = 0; i < 3; i++) {
        const at = 18 * k + 6 * i;
        put(at, a.n[i], a.d);
        put(at + 2, 2n * q[i], wd * a.d);
        put(at + 4, 2n * along * w[i] - w2 * a.n[i], wd * wd * a.d);
      }
    });
    put(72, w2, wd * wd);
    put(74, m.since.n, m.since.d);
    const arm = Math.hypot(quadrics[0], quadrics[6], quadrics[12]);
    return { anchor: to.name, floats, quadrics, speed: 4 * Math.sqrt(quadrics[72]) * (1 + arm) };
  }

  /**
   * As floats, each the nearest one to the exact number: the position relative to a target, in out[0..2], and the rows of
   * the rotation, in out[3..11].
   *
   * What is computed in twofold floats is within 2^-96 of the sizes of what is added: some ten operations, each within
   * 2^-102. Where the whole of that span rounds to one float, it is the nearest one. Else, which is rare but where the result
   * is 0, exact arithmetic decides.
   * @param {Straight | Turning} m @param {Moving} body @param {Target} target @param {Float64Array | number[]} out
   */
  function place(m, body, target, out) {
    const held = m.held !== null && m.held.anchor === target.anchor.name ? m.held : (m.held = hold(m, target.anchor));
    const f = held.floats, { low, add, mul } = Twofold;
    const { timeHigh, timeLow, sinceHigh, sinceLow } = body;
    const age = add(timeHigh, timeLow, -sinceHigh, -sinceLow), ageLow = low[0];
    const ages = Math.abs(timeHigh) + Math.abs(sinceHigh);
    if (held.quadrics === null) {
      for (let i = 0; i < 3; i++) {
        const v = f[6 + 2 * i];
        let high = mul(age, ageLow, v, f[7 + 2 * i]);
        high = add(high, low[0], f[2 * i], f[2 * i + 1]);
        high = add(high, low[0], -target.high[i], -target.low[i]);
        const within = (ages * Math.abs(v) + Math.abs(f[2 * i]) + Math.abs(target.high[i])) * 2 ** -96;
        const nearest = high + (low[0] + within);
        out[i] = nearest === high + (low[0] - within) ? nearest : exactly(m, body, target, i);
      }
      const r = /** @type {Straight} */ (m).matrix;
      if (r) for (let i = 0; i < 9; i++) out[3 + i] = r[i];
      else {
        out[3] = out[7] = out[11] = 1;
        out[4] = out[5] = out[6] = out[8] = out[9] = out[10] = 0;
      }
      return;
    }
    const q = held.quadrics;
    const s = add(age, ageLow, q[74], q[75]), sLow = low[0];
    let y = mul(s, sLow, s, sLow);
    y = mul(y, low[0], q[72], q[73]);
    y = add(y, low[0], 1, 0);
    const yLow = low[0];
    const lost = held.speed * (ages + Math.abs(q[74]));
    for (let k = 0; k < 12; k++) {
      const at = 6 * k;
      if (k >= 3 && q[at] === 0 && q[at + 2] === 0 && q[at + 4] === 0) {
        out[entry(k)] = 0;
        continue;
      }
      let x = mul(s, sLow, q[at + 4], q[at + 5]);
      x = add(x, low[0], q[at + 2], q[at + 3]);
      x = mul(s, sLow, x, low[0]);
      x = add(x, low[0], q[at], q[at + 1]);
      let high = Twofold.div(x, low[0], y, yLow);
      let size = Math.abs(q[at]) + Math.abs(s) * (Math.abs(q[at + 2]) + Math.abs(s * q[at + 4])) + lost;
      if (k < 3) {
        const xLow = low[0], v = f[6 + 2 * k];
        let here = mul(age, ageLow, v, f[7 + 2 * k]);
        here = add(here, low[0], f[2 * k], f[2 * k + 1]);
        here = add(here, low[0], -target.high[k], -target.low[k]);
        high = add(here, low[0], high, xLow);
        size += ages * Math.abs(v) + Math.abs(f[2 * k]) + Math.abs(target.high[k]);
      }
      const within = size * 2 ** -96;
      const nearest = high + (low[0] + within);
      const i = entry(k);
      out[i] = nearest === high + (low[0] - within) ? nearest : exactly(m, body, target, i);
    }
  }

  /**
   * Where in the result a coordinate of what turns is: columns of the rotation, in rows.
   * @param {number} k
   */
  const entry = (k) => (k < 3 ? k : 3 + 3 * (k % 3) + Math.floor(k / 3) - 1);

  /**
   * One number of the result, by exact arithmetic.
   * @param {Straight | Turning} m @param {Moving} body @param {Target} target @param {number} i
   */
  function exactly(m, body, target, i) {
    if (i < 3) {
      const p = position(m, body.gone());
      return Rational.ratio(p.n[i] * target.d - target.n[i] * p.d, p.d * target.d);
    }
    const o = orientation(m, body.gone());
    return Rational.ratio(o.n[i - 3], o.d);
  }

  return { ints, straight, turning, position, orientation, target, place };
})();
