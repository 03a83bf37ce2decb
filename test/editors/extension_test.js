// What the extension for Visual Studio Code does, without Visual Studio Code: its commands, its panel with pages of the real
// program, its tasks, and what its package says.
//
//   node extension_test.js EXTENSION SCC REFERENCE ROOT    the last line is 'N passed, N failed'
"use strict";

const fs = require("fs");
const os = require("os");
const path = require("path");
const { spawnSync } = require("child_process");
const { vscode, said, values, listeners, document } = require("./vscode_stub.js");

const [extension, scc, reference, root] = process.argv.slice(2).map((one) => path.resolve(one));
const { activate, deactivate } = require(path.join(extension, "src/extension.js"));
const { checksOf, checkAt } = require(path.join(extension, "src/checks.js"));
const manifest = JSON.parse(fs.readFileSync(path.join(extension, "package.json"), "utf8"));
const work = fs.mkdtempSync(path.join(os.tmpdir(), "scc-extension-"));

let passed = 0;
let failed = 0;
function expect(what, holds, shown = "") {
  if (holds) passed += 1;
  else {
    failed += 1;
    console.log(`${what}: ${shown}`);
  }
}

const wait = (ms) => new Promise((done) => setTimeout(done, ms));
async function until(what, holds) {
  for (let i = 0; i < 12000 && !holds(); i += 1) await wait(50);
  expect(what, holds());
}

/** What the real parser says about texts. */
function parsed(texts) {
  const input = Buffer.concat(texts.flatMap((text) => [Buffer.from(`${Buffer.byteLength(text)}\n`), Buffer.from(text)]));
  const done = spawnSync(reference, { input, maxBuffer: 1 << 30 });
  return done.stdout.toString().trim().split("\n").map((line) => JSON.parse(line));
}

function findsChecks() {
  const folder = path.join(root, "specs/models");
  const files = fs.readdirSync(folder).filter((name) => name.endsWith(".sc"));
  const texts = files.map((name) => fs.readFileSync(path.join(folder, name), "utf8"));
  parsed(texts).forEach((answer, i) => {
    const bytes = Buffer.from(texts[i]);
    const starts = answer.nodes.filter(([kind]) => kind === "check_declaration").map(([, start]) => start);
    const wanted = starts.sort((a, b) => a - b).map((start) => bytes.subarray(0, start).toString().length);
    const found = checksOf(texts[i]);
    expect(`checks of ${files[i]}`, JSON.stringify(found.map((c) => c.offset)) === JSON.stringify(wanted), JSON.stringify(found));
  });
  const text = "/* check a : /* // */ x */ check b : y // check c : z\ncheck d: possibly x\n";
  expect("checks in comments are none", checksOf(text).map((c) => c.name).join() === "b,d");
  expect("before the first check is none", checkAt(text, 10) === undefined);
  expect("the last check before a place", checkAt(text, 40) === "b" && checkAt(text, text.length) === "d");
}

function saysTrueThings() {
  for (const file of [manifest.main.replace("dist", "src"), "language-configuration.json", "README.md",
    ...manifest.contributes.grammars.map((one) => one.path), ...manifest.contributes.snippets.map((one) => one.path)]) {
    expect(`${file} is there`, fs.existsSync(path.join(extension, file)));
  }
  for (const { command } of manifest.contributes.commands) expect(`${command} is registered`, command in said.commands);
  for (const command of Object.keys(said.commands)) {
    expect(`${command} is declared`, manifest.contributes.commands.some((one) => one.command === command));
  }
  JSON.parse(fs.readFileSync(path.join(extension, "language-configuration.json"), "utf8"));
  const { regexp } = manifest.contributes.problemMatchers[0].pattern;
  const pattern = new RegExp(regexp);
  const invalid = path.join(root, "specs/conformance/invalid");
  for (const file of fs.readdirSync(invalid).filter((name) => name.endsWith(".out"))) {
    for (const line of fs.readFileSync(path.join(invalid, file), "utf8").split("\n")) {
      const head = /^(\S+:\d+:\d+): (error|warning)\[(SC\d+)\]/.exec(line);
      const match = pattern.exec(line);
      if (head) expect(`the problem of ${file}`, match && `${match[1]}:${match[2]}:${match[3]}` === head[1], line);
    }
  }
}

function snippets() {
  const all = JSON.parse(fs.readFileSync(path.join(extension, "snippets/scc.json"), "utf8"));
  const texts = Object.values(all).map(({ body }) =>
    body.join("\n")
      .replace(/\$\{\d+\|([^,|]*)[^}]*\}/g, "$1")
      .replace(/\$\{\d+:([^{}]*(?:\{[^{}]*\})?[^{}]*)\}/g, "$1")
      .replace(/\$\d/g, ""));
  parsed(texts).forEach((answer, i) => {
    expect(`the snippet ${Object.keys(all)[i]}`, answer.codes.length === 0, `${answer.codes} ${texts[i]}`);
  });
  const model = path.join(work, "snippet.sc");
  fs.writeFileSync(model, texts[Object.keys(all).indexOf("Model")]);
  const done = spawnSync(scc, ["check", model]);
  expect("the model of the snippet holds", done.status === 0, done.stdout + done.stderr);
}

/** The name of the check that a page shows, or undefined. */
const shows = (panel, name) =>
  panel.webview.html.startsWith("<!DOCTYPE html>") && panel.webview.html.includes("scc-view") && panel.webview.html.includes(name);

async function panels() {
  const file = path.join(work, "hexokinase.sc");
  fs.copyFileSync(path.join(root, "specs/models/hexokinase.sc"), file);
  const model = document(file);
  const editor = { document: model, selection: { active: model.text.indexOf("check together") + 3 } };
  vscode.window.activeTextEditor = editor;
  await said.commands["scc.view"]();
  const [panel] = said.panels;
  expect("a panel beside", said.panels.length === 1 && panel.column.viewColumn === -2 && panel.options.enableScripts);
  expect("its title has the check at the cursor", panel.title === "hexokinase.sc: together", panel.title);
  expect("its page is that of the check", shows(panel, "together"), panel.webview.html.slice(0, 300));
  const first = panel.webview.html;
  const move = (to) => listeners.selection.forEach((then) => then({ textEditor: editor, selections: [{ active: to }] }));
  move(model.text.indexOf("check together") + 9);
  await wait(400);
  expect("within a check nothing is made anew", panel.webview.html === first);
  move(model.text.indexOf("check in_time"));
  move(model.text.indexOf("check reaction") + 7);
  await until("it follows the cursor", () => panel.title === "hexokinase.sc: reaction" && panel.webview.html !== first);
  await said.commands["scc.showRunHere"](model.uri.toString(), "surely");
  expect("the run of a named check, in the same panel", said.panels.length === 1 && panel.revealed === 1
    && panel.title === "hexokinase.sc: surely" && shows(panel, "surely"));
  const { middleware } = said.clients[0].client;
  await middleware.executeCommand("scc.showRun", [model.uri.toString(), "in_time"], () => expect("not of the server", false));
  expect("the run that a code lens shows", panel.title === "hexokinase.sc: in_time" && shows(panel, "in_time"));
  let passedOn;
  middleware.executeCommand("scc.check", [1], (...words) => (passedOn = words));
  expect("other commands are the server's", JSON.stringify(passedOn) === '["scc.check",[1]]');

  model.text = "process p = <b>Cube</b>\n";
  model.isDirty = true;
  await said.commands["scc.view"]();
  expect("a model is saved before it is shown", model.saved === 1);
  const words = panel.webview.html;
  expect("errors are told", words.includes("error[SC0110]") && words.includes("hexokinase.sc:1:"), words);
  expect("texts of models are no markup", words.includes("&lt;b&gt;Cube") && !words.includes("<b>"));
  expect("a page of words runs nothing", words.includes("default-src 'none'") && !/<script/.test(words));

  fs.copyFileSync(path.join(root, "specs/models/dimer.sc"), file);
  model.text = fs.readFileSync(file, "utf8");
  listeners.save.forEach((then) => then(model));
  await until("it follows the file", () => shows(panel, "dimer"));
  values.program = "/nowhere/scc";
  panel.dispose();
  await said.commands["scc.view"]();
  expect("without the program it says so", said.panels[1].webview.html.includes("There is no program /nowhere/scc"));
  values.program = scc;
}

async function tasks() {
  const file = path.join(root, "specs/models/dimer.sc");
  const model = document(file);
  vscode.window.activeTextEditor = { document: model, selection: { active: 0 } };
  await said.commands["scc.checkModel"]();
  const [task] = said.tasks;
  expect("a task that checks", task.problemMatchers === "$scc" && task.execution.args.join(" ") === `check ${file} --seconds=60`);
  const done = spawnSync(task.execution.process, task.execution.args, task.execution.options);
  expect("its command checks", done.stdout.toString().includes("properties"), done.stdout + done.stderr);
  await said.commands["scc.checkHere"]();
  expect("without a check at the cursor it says so", said.messages.pop() === "There is no check at the cursor.");
  await said.commands["scc.checkHere"](model.uri.toString(), "meets");
  expect("a task of one check", said.tasks[1].execution.args.slice(-2).join(" ") === "--check meets");
  const definition = { type: "scc", file, check: "meets" };
  expect("tasks of tasks.json", said.providers.scc.resolveTask({ definition }).definition === definition);
  vscode.window.activeTextEditor = { document: { languageId: "markdown" } };
  await said.commands["scc.checkModel"]();
  expect("of no model it says so", said.messages.pop() === "This is for the editor of a model (.sc).");
}

async function server() {
  expect("the server is started", said.clients.length === 1 && said.clients[0].started === 1
    && said.clients[0].server.command === scc && said.clients[0].server.args.join() === "lsp");
  await said.commands["scc.restart"]();
  expect("and started anew", said.clients[0].stopped === 1 && said.clients.length === 2);
  values.program = "/nowhere/scc";
  listeners.configuration.forEach((then) => then({ affectsConfiguration: (name) => name === "scc.program" }));
  await until("a server that does not start is told of", () => /did not start \(\/nowhere\/scc\)/.test(said.messages[0] || ""));
}

async function main() {
  values.program = scc;
  await activate({ subscriptions: [] });
  findsChecks();
  saysTrueThings();
  snippets();
  await panels();
  await tasks();
  await server();
  await deactivate();
  fs.rmSync(work, { recursive: true });
  console.log(`${passed} passed, ${failed} failed`);
  process.exitCode = failed ? 1 : 0;
}

main();
