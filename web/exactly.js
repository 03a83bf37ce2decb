"use strict";

/**
 * Numbers and motions in words: exact ones beside their decimals.
 */
const Exactly = (() => {
  /**
   * Decimal digits of a float, as short as is useful.
   * @param {number} x @param {number} [digits] significant ones
   */
  const decimal = (x, digits) =>
    Number.isFinite(x) ? Rational.decimal(Rational.fromNumber(x), digits).text : String(x);

  /**
   * Its decimals, and whether they are rounded: "= 0.5", "≈ 0.333333".
   * @param {Rational} r
   */
  function told(r) {
    const near = Rational.decimal(r);
    return `${near.exact ? "=" : "≈"} ${near.text}`;
  }

  /**
   * The exact text, "p/q" or "p".
   * @param {Rational} r
   */
  function text(r) {
    return Rational.text(r).replace(/\/1$/, "");
  }

  /**
   * The values of parameters: "n = 4, y = -5/2".
   * @param {{ [parameter: string]: string } | undefined} values
   */
  function values(values) {
    return Object.entries(values || {}).map(([name, value]) => `${name} = ${value.replace(/\/1$/, "")}`).join(", ");
  }

  /**
   * An exact number, and its decimals if these are another text.
   * @param {Rational} r
   */
  function both(r) {
    const exact = text(r);
    if (!exact.includes("/")) return exact;
    return `${exact} ${told(r)}`;
  }

  /**
   * An element that shows an exact number, in full, and its decimals beside it.
   * @param {Rational} r
   */
  function show(r) {
    const exact = text(r);
    const parts = [
      Dom.make("span", { class: "exact", text: exact, title: exact.length > 24 ? "exact" : null }),
    ];
    if (exact.includes("/"))
      parts.push(Dom.make("span", { class: "near", text: told(r) }));
    return Dom.make("span", { class: "number" }, parts);
  }

  /** So many characters of a number are told. */
  const longest = 40;

  /**
   * A text in which numbers of more digits than one can read are told by their decimals.
   * @param {string} text
   */
  const brief = (text) => text.replace(/-?\d+(?:\/\d+)?/g, (number) =>
    number.length <= longest ? number : `~${Rational.decimal(Rational.of(number)).text}`);

  /**
   * The nearest instant of the grid on which time is played.
   * @param {number} x
   */
  function grid(x) {
    return Rational.fromNumber(Math.round(x * 1048576) / 1048576);
  }

  /**
   * An exact number that a user or an address wrote, or null.
   * @param {string} s @returns {Rational | null}
   */
  function read(s) {
    const decimal = s.length > 20000 ? null : /^(-?[0-9]+)\.([0-9]+)$/.exec(s);
    if (decimal) return Rational.make(BigInt(decimal[1] + decimal[2]), 10n ** BigInt(decimal[2].length));
    if (s.length > 20000 || !/^-?[0-9]+(\/[0-9]*[1-9][0-9]*)?$/.test(s)) return null;
    return Rational.of(s);
  }

  return { decimal, told, text, brief, values, both, show, grid, read };
})();
