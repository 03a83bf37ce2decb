"use strict";

// Where the page puts each body at some instants of a run: `node positions.js WEB DATA RUN T…`, with the folder of the
// page's scripts, data of scc view, and the number of the run. Prints what it found as JSON, a list of an object for each
// instant.

const fs = require("fs");
const { load } = require("./load.js");

const [web, file, index, ...times] = process.argv.slice(2);
const { Rational, Motion, Course } =
  load(web, ["rational.js", "twofold.js", "motion.js", "course.js"], ["Rational", "Motion", "Course"]);

const data = JSON.parse(fs.readFileSync(file, "utf8"));
const course = new Course(data, data.runs[Number(index)]);
const out = new Float64Array(12);

// Floats are relative to a target: an odd one, and one far away.
const targets = [Motion.target({ n: [0n, 0n, 0n], d: 1n }), Motion.target({ n: [10n, -7n, 1n], d: 3n }),
  Motion.target({ n: [10n ** 40n, 1n, 0n], d: 7n })];

const found = times.map((text) => {
  const time = Rational.of(text);
  /** @type {{ [name: string]: unknown }} */
  const bodies = {};
  for (const body of course.bodiesAt(time))
    for (const place of body.process.leaves) {
      const floats = targets.map((target) => {
        course.place(body, place, target, out);
        return Array.from(out);
      });
      bodies[course.leaves[place.leaf].name] = {
        position: course.position(body, place).map(Rational.text),
        matrix: course.orientation(body, place).map(Rational.text),
        floats,
      };
    }
  return bodies;
});
console.log(JSON.stringify(found));
