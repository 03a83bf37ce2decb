"use strict";

/**
 * The checks that a text declares, in their order: each with its name and the offset of its word. Texts in comments and
 * strings are none.
 * @param {string} text @returns {{name: string, offset: number}[]}
 */
function checksOf(text) {
  const found = [];
  const token = /\/\/[^\r\n]*|"(?:[^"\\\r\n]|\\.)*"?|\/\*|\*\/|[A-Za-z][A-Za-z0-9_']*/g;
  let depth = 0;
  let declaring = -1;
  for (let match = token.exec(text); match; match = token.exec(text)) {
    const word = match[0];
    if (word === "/*") depth += 1;
    else if (word === "*/") depth = Math.max(0, depth - 1);
    else if (depth > 0) {
      // A comment of lines within one of a block is text of it: what ends the block may stand there.
      if (word.startsWith("//") || word.startsWith('"')) token.lastIndex = match.index + 1;
    } else if (declaring >= 0) {
      if (/^[A-Za-z]/.test(word)) found.push({ name: word, offset: declaring });
      if (!word.startsWith("//")) declaring = -1;
    } else if (word === "check") declaring = match.index;
  }
  return found;
}

/**
 * The check in which an offset of the text is: the last one that begins before it, since a declaration goes up to the next
 * one; before the first of them there is none.
 * @param {string} text @param {number} offset @returns {string | undefined}
 */
function checkAt(text, offset) {
  const before = checksOf(text).filter((check) => check.offset <= offset);
  return before.length > 0 ? before[before.length - 1].name : undefined;
}

module.exports = { checksOf, checkAt };
