// Verdicts of a model, and the run of its first choices, step by step: node oracle.js SCC MODEL
const { spawn } = require("child_process");
const { readFileSync } = require("fs");
const { createInterface } = require("readline");

const oracle = spawn(process.argv[2], ["oracle"], { stdio: ["pipe", "pipe", "inherit"] });
const answers = createInterface({ input: oracle.stdout })[Symbol.asyncIterator]();
async function ask(method, params) {
  oracle.stdin.write(JSON.stringify({ jsonrpc: "2.0", id: 1, method, params }) + "\n");
  const { result, error } = JSON.parse((await answers.next()).value);
  if (error) throw new Error(`${error.message} ${JSON.stringify(error.data)}`);
  return result;
}

async function main() {
  const text = readFileSync(process.argv[3], "utf8");
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
  .finally(() => oracle.stdin.end());
