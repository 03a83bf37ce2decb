"use strict";

// Whether the desk offers each name of a model where it stands, and at its first letter: offers.js WEB MODEL…
// The last line is 'N passed, N failed'.

const fs = require("fs");
const { load } = require("./load.js");

const [web, ...models] = process.argv.slice(2);
const { Offers } = load(web, ["desk/language.js", "desk/offers.js"], ["Offers"]);
const counts = {};
let passed = 0, failed = 0;

function check(what, holds) {
  if (holds) passed += 1;
  else {
    failed += 1;
    console.log("FAILED:", what);
  }
}

function stands(model, text, kind, at, name) {
  counts[kind] = (counts[kind] || 0) + 1;
  const all = Offers.at(text, at).all.map((one) => one.name);
  const begun = Offers.at(text, at + 1);
  check(`${model}: ${name}, a ${kind}, at ${at}`, all.some((one) => one === name || one.startsWith(`${name}.`)));
  // A channel that is being written for the only time is nowhere else.
  const once = kind === "channel" && [...text.matchAll(new RegExp(`[<~(]\\s*${name}\\s*,`, "g"))].length < 2;
  check(`${model}: ${name} where its first letter stands`, begun.from === at && once || begun.all.some((one) => one.name.startsWith(name)));
}

function names(model, text) {
  for (const m of text.matchAll(/^([^/\n]*?)(<\s*~?\s*)([A-Za-z]\w*)(\s*,\s*\{\s*)([A-Za-z]\w*)/gm)) {
    const channel = m.index + m[1].length + m[2].length, feature = channel + m[3].length + m[4].length;
    stands(model, text, "channel", channel, m[3]);
    stands(model, text, "feature", feature, m[5]);
  }
  for (const m of text.matchAll(/^ *(?:process|fixed)\s+[\w[\]]+\s*=\s*([A-Z]\w*)/gm))
    stands(model, text, "shape", m.index + m[0].length - m[1].length, m[1]);
  for (const m of text.matchAll(/^ *process.*\[([A-Z]\w*)\] *$/gm))
    stands(model, text, "behaviour", m.index + m[0].lastIndexOf("[") + 1, m[1]);
  for (const m of text.matchAll(/^(process|behaviour|check|fixed|shape|param|let) /gm)) stands(model, text, "word", m.index, m[1]);
}

for (const model of models) names(model, fs.readFileSync(model, "utf8"));
for (const kind of ["channel", "feature", "shape", "behaviour", "word"]) check(`there are some of each ${kind}`, counts[kind] > 10);

// What fits alone is offered.
const shapes = "shape A { vertices p (0,0,0) q (1,0,0) faces f [p,q] }\nshape B { vertices u (0,0,0) faces g [u] }\nshape C = B scaled (1,1,1)\n";
const process_ = `${shapes}process one = A mass 1 [<~in, {f}>. nil]\n`;
for (const [text, wanted] of [
  [`${process_}process two = C mass 1 [<`, ["in"]],
  [`${process_}process two = C mass 1 [<in, {`, ["u", "g", "only", "one"]],
  [`${process_}behaviour X on A = omega(`, ["in"]],
  [`${process_}behaviour X on A = omega(in, {`, ["p", "q", "f", "only"]],
  [`${process_}process two = C mass 1 [<in, `, []],
  [`${process_}bond <in, {one.`, ["p", "q", "f"]],
  [`${process_}behaviour X on `, ["A", "B", "C", "box", "prism", "pyramid"]],
  [`${process_}// a comment <`, []],
  [`${process_}import "`, []],
])
  check(`${text.slice(process_.length)}: ${Offers.at(text, text.length).all.map((one) => one.name)}`,
    JSON.stringify(Offers.at(text, text.length).all.map((one) => one.name).filter((one) => one !== "two").sort()) === JSON.stringify(wanted.sort()));
// Any beginning of a text has an answer, in a time that grows with it.
const long = models.map((model) => fs.readFileSync(model, "utf8")).join("\n").slice(0, 60000);
for (let at = 0; at < long.length; at += 997) check(`an answer at ${at}`, Array.isArray(Offers.at(long.slice(0, at), at).all));
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
