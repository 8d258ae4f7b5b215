// Reads {grammar, packages, texts} as JSON and prints the tokens that VS Code's own engine finds in each
// text: [line, start, end, scope], without blanks.
"use strict";
const { readFileSync } = require("node:fs");
const { createRequire } = require("node:module");
const { join } = require("node:path");

const order = JSON.parse(readFileSync(0, "utf-8"));
const from = createRequire(join(order.packages, "package.json"));
const oniguruma = from("vscode-oniguruma");
const { INITIAL, Registry, parseRawGrammar } = from("vscode-textmate");

async function main() {
  await oniguruma.loadWASM(readFileSync(from.resolve("vscode-oniguruma/release/onig.wasm")).buffer);
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (sources) => new oniguruma.OnigScanner(sources),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => parseRawGrammar(readFileSync(order.grammar, "utf-8"), order.grammar),
  });
  const grammar = await registry.loadGrammar("source.aseme");
  const results = order.texts.map((text) => {
    const tokens = [];
    let state = INITIAL;
    text.split("\n").forEach((line, number) => {
      const found = grammar.tokenizeLine(line, state);
      state = found.ruleStack;
      for (const { startIndex, endIndex, scopes } of found.tokens) {
        const end = Math.min(endIndex, line.length);
        if (line.slice(startIndex, end).trim()) tokens.push([number, startIndex, end, scopes.at(-1)]);
      }
    });
    return tokens;
  });
  process.stdout.write(JSON.stringify(results));
}

main();
