// The scopes that the TextMate grammar gives to places of texts.
//
//   node scopes.js EXTENSION < ASKED    a line of JSON for each text: {"text": …, "places": [line and column, …]}
//
// For each text a line of JSON with the innermost scope at each place. Lines end with "\n", and a column counts units of
// UTF-16 from 0. The packages are those of the extension (npm).
"use strict";

const fs = require("fs");
const path = require("path");

const extension = path.resolve(process.argv[2]);
const of = (name) => require(path.join(extension, ".made/node_modules", name));
const textmate = of("vscode-textmate");
const oniguruma = of("vscode-oniguruma");

async function main() {
  const wasm = fs.readFileSync(path.join(extension, ".made/node_modules/vscode-oniguruma/release/onig.wasm"));
  await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
  const file = path.join(extension, "syntaxes/scc.tmLanguage.json");
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => textmate.parseRawGrammar(fs.readFileSync(file, "utf8"), file),
  });
  const grammar = await registry.loadGrammar("source.scc");
  for (const asked of fs.readFileSync(0, "utf8").split("\n")) {
    if (asked === "") continue;
    const { text, places } = JSON.parse(asked);
    let state = textmate.INITIAL;
    const lines = text.split("\n").map((line) => {
      const { tokens, ruleStack } = grammar.tokenizeLine(line, state);
      state = ruleStack;
      return tokens;
    });
    const scopes = places.map(([line, column]) => {
      const token = lines[line].find((one) => one.startIndex <= column && column < one.endIndex);
      return token ? token.scopes[token.scopes.length - 1] : "";
    });
    process.stdout.write(JSON.stringify(scopes) + "\n");
  }
}

main();
