"use strict";

// What the page evaluates by itself: `node formulas.js WEB DATA RUN`, with formulas and times on standard input as JSON:
// [[[legs, time]…], [formula…]]. Prints, for each formula, what is wrong with it or its values at these instants.

const fs = require("fs");
const { load } = require("./load.js");

const [web, file, index] = process.argv.slice(2);
const scripts = ["rational.js", "twofold.js", "motion.js", "course.js", "dom.js", "exactly.js", "reader.js", "meaning.js"];
const { Rational, Course, Reader, Meaning, Nothing } = load(web, scripts, ["Rational", "Course", "Reader", "Meaning", "Nothing"]);

const data = JSON.parse(fs.readFileSync(file, "utf8"));
const course = new Course(data, data.runs[Number(index)]);
const [instants, formulas] = JSON.parse(fs.readFileSync(0, "utf8"));

const views = instants.map(([legs, text]) => {
  const time = Rational.of(text), state = legs === 0 ? course.start : course.legs[legs - 1].after;
  const of = (bodies) => Meaning.view(data, course.leaves, state, bodies, time);
  return ({ needs }) => of(needs ? course.some(needs, legs, time) : course.bodiesAfter(legs, time));
});

const found = formulas.map((text) => {
  try {
    const formula = Meaning.compile(data, course.leaves, data.parameters, text);
    return views.map((view) => {
      const value = formula.run(view(formula));
      return value instanceof Nothing ? null : typeof value === "boolean" ? (value ? "1" : "0") : Rational.text(value);
    });
  } catch (error) {
    if (!(error instanceof Reader.Wrong)) throw error;
    return { wrong: error.message, at: error.at, whole: error.whole };
  }
});
console.log(JSON.stringify(found));
