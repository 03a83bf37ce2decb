// Verdicts of a model, and the run of its first choices, step by step: node oracle.js SCC MODEL [SECONDS]
// No answer is waited for longer than so many seconds, 90 unless told.
const { spawn } = require("child_process");
const { readFileSync } = require("fs");
const { createInterface } = require("readline");

const [, , scc, file, seconds = "90"] = process.argv;
if (!file || !(Number(seconds) > 0)) {
  console.error("usage: node oracle.js SCC MODEL [SECONDS]");
  process.exit(2);
}
const oracle = spawn(scc, ["oracle"], { stdio: ["pipe", "pipe", "inherit"] });
const over = new Promise((_, reject) => {
  oracle.on("error", (error) => reject(new Error(`scc oracle cannot be started: ${error.message}`)));
  // All that it has written was read before this.
  oracle.on("close", (code, signal) => reject(new Error(`scc oracle has ended (${signal || `exit code ${code}`})`)));
});
over.catch(() => {}); // is told where an answer is waited for
oracle.stdin.on("error", () => {}); // it has ended, which is told as such
const answers = createInterface({ input: oracle.stdout })[Symbol.asyncIterator]();
let asked = 0;

async function ask(method, params) {
  const id = ++asked;
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`scc oracle has not answered ${method} within ${seconds} seconds`)), 1000 * seconds);
  });
  oracle.stdin.write(JSON.stringify({ jsonrpc: "2.0", id, method, params }) + "\n");
  const line = answers.next().then(({ done, value }) => (done ? over : value)); // it never ends without the process
  const answer = await Promise.race([line, over, late]).finally(() => clearTimeout(timer));
  const { id: of, result, error } = read(answer);
  if (error) throw new Error(`${error.message} ${JSON.stringify(error.data)}`);
  if (of !== id || result === undefined) throw new Error(`this is no answer to ${method}: ${answer.slice(0, 100)}`);
  return result;
}

function read(line) {
  try {
    return Object(JSON.parse(line));
  } catch (_) {
    throw new Error(`scc oracle has written what is no JSON: ${line.slice(0, 100)}`);
  }
}

async function main() {
  const text = readFileSync(file, "utf8");
  for (const check of (await ask("model.check", { text })).properties) console.log(`${check.name}: ${check.text}`);
  const { model } = await ask("model.load", { text });
  for (const path = []; ; path.push(0)) {
    const { time, transitions, ending } = await ask("successors", { model, path, states: "none" });
    console.log(`${time} ${transitions.length > 0 ? transitions[0].label.text : ending}`);
    if (transitions.length === 0) break;
  }
}

main()
  .catch((error) => {
    console.error(error.message);
    process.exitCode = 1;
  })
  .finally(() => (process.exitCode ? oracle.kill("SIGKILL") : oracle.stdin.end()));
