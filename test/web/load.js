"use strict";

// Loads scripts of the page, which share their names as the scripts of one page do, without a browser.

const fs = require("fs");
const path = require("path");
const vm = require("vm");

/**
 * The values of some names after the scripts are run: `load(folder, ["rational.js"], ["Rational"])`.
 */
function load(folder, scripts, names) {
  const context = vm.createContext({ console });
  for (const script of scripts) {
    const file = path.join(folder, script);
    vm.runInContext(fs.readFileSync(file, "utf8"), context, { filename: file });
  }
  return vm.runInContext(`({ ${names.join(", ")} })`, context);
}

module.exports = { load };
