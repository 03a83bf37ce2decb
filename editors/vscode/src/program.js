"use strict";

const { spawn } = require("child_process");

// A page has some megabytes; more than this is no page of a model that a person looks at.
const LARGEST = 256 * 1024 * 1024;

/**
 * Runs a program to its end.
 * @param {string} program @param {string[]} args @param {string} folder @param {AbortSignal} [signal]
 * @returns {Promise<{code: number | null, out: string, err: string}>} what it wrote. It is rejected if the program cannot be
 *   started (`code` of the error is ENOENT if there is none), writes too much, or is stopped (`name` is AbortError).
 */
function run(program, args, folder, signal) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd: folder, signal, stdio: ["ignore", "pipe", "pipe"] });
    /** @type {Buffer[]} */
    const out = [];
    /** @type {Buffer[]} */
    const err = [];
    let size = 0;
    /** @param {Buffer[]} to */
    const collect = (to) => (/** @type {Buffer} */ data) => {
      size += data.length;
      if (size > LARGEST) {
        child.kill();
        reject(new Error(`${program} wrote more than ${LARGEST} bytes`));
      } else to.push(data);
    };
    child.stdout.on("data", collect(out));
    child.stderr.on("data", collect(err));
    child.on("error", reject);
    child.on("close", (code) => {
      resolve({ code, out: Buffer.concat(out).toString("utf8"), err: Buffer.concat(err).toString("utf8") });
    });
  });
}

module.exports = { run };
