"use strict";

// Answers questions of numbers_test.py, one JSON array a line: `node numbers.js WEB`.

const readline = require("readline");
const { load } = require("./load.js");

const scripts = ["rational.js", "twofold.js", "motion.js", "course.js", "camera.js", "polygon.js"];
const { Rational, Motion, Course, Camera, Polygon } =
  load(process.argv[2], scripts, ["Rational", "Motion", "Course", "Camera", "Polygon"]);

/** A float as its bits, so that nothing is lost on the way. */
function bits(x) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  return view.getBigUint64(0).toString();
}

const answers = {
  binary: (op, a, b) => Rational.text(Rational[op](Rational.of(a), Rational.of(b))),
  cmp: (a, b) => Rational.cmp(Rational.of(a), Rational.of(b)),
  float: (a) => bits(Rational.toNumber(Rational.of(a))),
  decimal: (a, digits) => {
    const { text, exact } = Rational.decimal(Rational.of(a), digits);
    return [text, exact];
  },
  back: (a) => Rational.text(Rational.fromNumber(Rational.toNumber(Rational.of(a)))),
  // Where a course has its bodies at a time: exact positions, matrices, and floats relative to a target.
  course: (data, run, questions) => {
    const course = new Course(data, run);
    const out = new Float64Array(12);
    return questions.map(({ legs, time, target }) => {
      const now = Rational.of(time);
      const aim = Motion.target(Motion.ints(target));
      const bodies = legs === null ? course.bodiesAt(now) : course.bodiesAfter(legs, now);
      return bodies.map((body) => [body.index, Rational.text(body.age), body.process.leaves.map((place) => {
        course.place(body, place, aim, out);
        return {
          leaf: place.leaf,
          position: course.position(body, place).map(Rational.text),
          matrix: course.orientation(body, place).map(Rational.text),
          floats: Array.from(out.slice(0, 3), bits),
          turned: Array.from(out.slice(3), bits),
        };
      })]);
    });
  },
  triangles: (corners) => Polygon.triangles(corners),
  // Where in the picture, and how deep, are both ends of a ray, and the point that is looked at.
  camera: (back, distance, up, lens, [x, y]) => {
    const camera = new Camera();
    camera.stand(back, distance, up);
    camera.see(...lens);
    const { from, way } = camera.ray(x, y);
    return [from, from.map((p, i) => p + way[i]), [0, 0, 0], up].map((p) => {
      const [a, b, c, w] = camera.at(p);
      return [a / w, b / w, c / w];
    });
  },
};

readline.createInterface({ input: process.stdin }).on("line", (line) => {
  const [name, ...rest] = JSON.parse(line);
  console.log(JSON.stringify(answers[name](...rest)));
});
