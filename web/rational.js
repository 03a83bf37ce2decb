"use strict";

/**
 * Exact fractions, and the floats nearest to them.
 *
 * @typedef {{ readonly n: bigint, readonly d: bigint }} Rational  In lowest terms, d > 0.
 */
const Rational = (() => {
  /** @param {bigint} a @param {bigint} b */
  function gcd(a, b) {
    if (a < 0n) a = -a;
    while (b !== 0n) [a, b] = [b, a % b];
    return a;
  }

  /** @param {bigint} n @param {bigint} d not zero @returns {Rational} */
  function make(n, d) {
    if (d < 0n) { n = -n; d = -d; }
    if (d === 1n) return { n, d };
    const g = gcd(n, d);
    return g === 1n ? { n, d } : { n: n / g, d: d / g };
  }

  /** @param {string} text "p/q" or "p" @returns {Rational} */
  function of(text) {
    const slash = text.indexOf("/");
    if (slash < 0) return { n: BigInt(text), d: 1n };
    const d = text.slice(slash + 1);
    return d === "1" ? { n: BigInt(text.slice(0, slash)), d: 1n } : make(BigInt(text.slice(0, slash)), BigInt(d));
  }

  const zero = { n: 0n, d: 1n };
  const one = { n: 1n, d: 1n };

  /** @param {Rational} a @param {Rational} b */
  const add = (a, b) => (a.d === b.d ? make(a.n + b.n, a.d) : make(a.n * b.d + b.n * a.d, a.d * b.d));
  /** @param {Rational} a @param {Rational} b */
  const sub = (a, b) => (a.d === b.d ? make(a.n - b.n, a.d) : make(a.n * b.d - b.n * a.d, a.d * b.d));
  /** @param {Rational} a @param {Rational} b */
  const mul = (a, b) => make(a.n * b.n, a.d * b.d);
  /** @param {Rational} a @param {Rational} b not zero */
  const div = (a, b) => make(a.n * b.d, a.d * b.n);
  /** @param {Rational} a @returns {Rational} */
  const neg = (a) => ({ n: -a.n, d: a.d });
  /** @param {Rational} a */
  const sign = (a) => (a.n > 0n ? 1 : a.n < 0n ? -1 : 0);
  /** @param {Rational} a @param {Rational} b */
  const cmp = (a, b) => {
    const c = a.n * b.d - b.n * a.d;
    return c > 0n ? 1 : c < 0n ? -1 : 0;
  };

  /**
   * "p/q", or "p" of a whole number.
   * @param {Rational} a
   */
  const text = (a) => (a.d === 1n ? String(a.n) : `${a.n}/${a.d}`);

  const safe = 9007199254740992n; // 2^53: integers up to it are floats

  /**
   * About the number of bits; never less, and at most three more.
   * @param {bigint} a not negative
   */
  const bits = (a) => 4 * a.toString(16).length;

  /**
   * The float nearest to n/d, of two the even one, as IEEE 754 divides.
   * @param {bigint} n @param {bigint} d positive
   */
  function ratio(n, d) {
    if (n < safe && n > -safe && d < safe) return Number(n) / Number(d);
    const negative = n < 0n;
    const m = negative ? -n : n;
    const size = bits(m) - bits(d); // of the quotient, up to 3
    let x;
    if (size > -1000) {
      // More bits than a float has, and one that tells whether any of the others is set: then a conversion rounds right.
      const shift = 70 - size;
      const high = shift >= 0 ? m << BigInt(shift) : m;
      const low = shift >= 0 ? d : d << BigInt(-shift);
      const q = high / low;
      x = Number(q * low === high ? q << 1n : (q << 1n) | 1n);
      // In two steps, each of which is exact: a power of two may be too small or too great for a float.
      const half = Math.trunc(-(shift + 1) / 2);
      x = x * 2 ** half * 2 ** (-(shift + 1) - half);
    } else {
      // Multiples of 2^-1074, which is the least float, from two more bits and the mark of a rest. Where there are 53 bits or
      // more of them, the conversion rounds, and it alone: rounding twice may end at another float.
      const high = m << 1076n;
      let q = high / d;
      if (q * d !== high) q |= 1n;
      if (q >> 55n !== 0n) x = Number(q) * 2 ** -512 * 2 ** -564;
      else {
        const rest = q & 3n;
        q >>= 2n;
        if (rest === 3n || (rest === 2n && (q & 1n) === 1n)) q += 1n;
        x = Number(q) * 2 ** -1074;
      }
    }
    return negative ? -x : x;
  }

  /** @param {Rational} a */
  const toNumber = (a) => ratio(a.n, a.d);

  const view = new DataView(new ArrayBuffer(8));

  /**
   * The number that a float is.
   * @param {number} x finite @returns {Rational}
   */
  function fromNumber(x) {
    if (Number.isSafeInteger(x)) return { n: BigInt(x), d: 1n };
    view.setFloat64(0, x);
    const word = view.getBigUint64(0);
    const exponent = Number((word >> 52n) & 2047n);
    const fraction = word & 4503599627370495n;
    const m = exponent === 0 ? fraction : fraction | 4503599627370496n;
    const power = Math.max(exponent, 1) - 1075;
    const n = word >> 63n === 1n ? -m : m;
    return power >= 0 ? { n: n << BigInt(power), d: 1n } : make(n, 1n << BigInt(-power));
  }

  /** @param {number} power at least 0 */
  const ten = (power) => 10n ** BigInt(power);

  /**
   * A decimal for people, of so many significant digits: the nearest, of two the one farther from zero; and whether it is
   * the number itself.
   * @param {Rational} a @param {number} [digits]
   */
  function decimal(a, digits = 6) {
    if (a.n === 0n) return { text: "0", exact: true };
    const size = a.n < 0n ? -a.n : a.n;
    // The power of ten of the first digit: the lengths tell it but for 1.
    let first = String(size).length - String(a.d).length;
    if (first < 0 ? size * ten(-first) < a.d : size < a.d * ten(first)) first--;
    /** @param {number} power of ten of the last digit */
    const rounded = (power) => {
      const [n, d] = power < 0 ? [size * ten(-power), a.d] : [size, a.d * ten(power)];
      const digits = (2n * n + d) / (2n * d);
      return { digits, exact: digits * d === n };
    };
    let found = rounded(first - digits + 1);
    // Rounded up to a power of ten, it has one digit more.
    if (found.digits >= ten(digits)) found = rounded(++first - digits + 1);
    const power = first < -5 || first > 8 ? `e${first}` : "";
    const places = power ? digits - 1 : Math.max(0, digits - 1 - first);
    const whole = power ? found.digits : found.digits * ten(Math.max(0, first - digits + 1));
    const all = String(whole).padStart(places + 1, "0");
    const fraction = all.slice(all.length - places).replace(/0+$/, "");
    const text = all.slice(0, all.length - places) + (places && fraction ? "." + fraction : "") + power;
    return { text: a.n < 0n ? "-" + text : text, exact: found.exact };
  }

  return { make, of, zero, one, add, sub, mul, div, neg, sign, cmp, text, decimal, ratio, toNumber, fromNumber };
})();
