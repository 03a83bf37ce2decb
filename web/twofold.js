"use strict";

/**
 * Sums and products of numbers that are held as two floats, high and low: about 105 bits, without allocation. Each
 * operation is within 2^-102 of the sizes of what it is made of.
 */
const Twofold = (() => {
  /** The low part of what the last of these functions gave. */
  const low = new Float64Array(1);

  /**
   * The high part of a + b.
   * @param {number} ah @param {number} al @param {number} bh @param {number} bl
   */
  function add(ah, al, bh, bl) {
    const sum = ah + bh;
    const part = sum - ah;
    const rest = ah - (sum - part) + (bh - part) + (al + bl);
    const high = sum + rest;
    low[0] = rest - (high - sum);
    return high;
  }

  /**
   * The high part of a b.
   * @param {number} ah @param {number} al @param {number} bh @param {number} bl
   */
  function mul(ah, al, bh, bl) {
    const product = ah * bh;
    const a = 134217729 * ah;
    const a1 = a - (a - ah);
    const a2 = ah - a1;
    const b = 134217729 * bh;
    const b1 = b - (b - bh);
    const b2 = bh - b1;
    const rest = a2 * b2 - (product - a1 * b1 - a2 * b1 - a1 * b2) + (ah * bl + al * bh);
    const high = product + rest;
    low[0] = rest - (high - product);
    return high;
  }

  /**
   * The high part of a / b.
   * @param {number} ah @param {number} al @param {number} bh @param {number} bl
   */
  function div(ah, al, bh, bl) {
    const first = ah / bh;
    const back = mul(first, 0, bh, bl);
    const left = add(ah, al, -back, -low[0]);
    const second = (left + low[0]) / bh;
    const high = first + second;
    low[0] = second - (high - first);
    return high;
  }

  /**
   * The high part of n / d. Numbers so great or so small that products of them might leave the range of floats are not
   * held: they are NaN here, and whoever asks goes the exact way.
   * @param {bigint} n @param {bigint} d
   */
  function of(n, d) {
    low[0] = 0;
    if (n === 0n) return 0;
    const high = Rational.ratio(n, d);
    if (!(Math.abs(high) < 1e60 && Math.abs(high) > 1e-60)) return NaN;
    const h = Rational.fromNumber(high);
    const rest = n * h.d - h.n * d;
    if (rest !== 0n) low[0] = Rational.ratio(rest, d * h.d);
    return high;
  }

  return { low, add, mul, div, of };
})();
