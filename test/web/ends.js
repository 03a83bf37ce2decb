"use strict";

// Where the runs of checks lead on the page: `node ends.js WEB DATA`, with the folder of the page's scripts and data of
// scc view. Prints as JSON, for each run of a check that one instant decides: its number, the time, and the processes there.

const fs = require("fs");
const { load } = require("./load.js");

const [web, file] = process.argv.slice(2);
const { Rational, Player } = load(web,
  ["rational.js", "twofold.js", "motion.js", "course.js", "player.js"], ["Rational", "Player"]);

const data = JSON.parse(fs.readFileSync(file, "utf8"));
const runs = Player.playable(data);
const found = [];
for (const run of runs.filter((one) => one.check)) {
  const at = Player.beside({ data, runs, bare: [] }, run);
  if (!at.conclude()) continue;
  const last = at.legs === 0 ? null : data.labels[run.steps[at.legs - 1].label].kind;
  const processes = at.course.bodiesAfter(at.legs, at.time).map((body) => ({
    velocity: body.process.velocity,
    turns: body.process.turn !== undefined,
    bonds: body.process.bonds.map((bond) => ({
      name: bond.name, bodies: bond.ends.map((end) => at.course.leaves[end.leaf].name),
    })),
    leaves: body.process.leaves.map((place) => ({
      name: at.course.leaves[place.leaf].name,
      parts: at.course.leaves[place.leaf].parts,
      behaviour: data.behaviours[place.behaviour],
      position: at.course.position(body, place).map(Rational.text),
      matrix: at.course.orientation(body, place).map(Rational.text),
    })),
  }));
  found.push({ run: run.index, time: Rational.text(at.time), legs: at.legs, last, processes });
}
console.log(JSON.stringify(found));
