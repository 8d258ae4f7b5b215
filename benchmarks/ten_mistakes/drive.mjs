// Plays XState's behaviour through the match of `world.py`: node drive.mjs FOLDER-WITH-behaviour.js
import { pathToFileURL } from "node:url";
import { createRequire } from "node:module";
import path from "node:path";

const file = path.resolve(process.argv[2], "behaviour.js");
const require = createRequire(file);
const line = (error) => String(error).split(/\s+/).join(" ");
const match = [
  ["done", 0.2, "kick"], ["done", 0.2, "search"], ["done", 5, "approach"],
  ["done", 5, "search"], ["done", 0.3, "approach"], ["whistle", 5, "search"],
];

async function main() {
  let actor, Phase;
  try {
    const { createActor } = require("xstate");
    const loaded = await import(pathToFileURL(file).href);
    Phase = loaded.default?.Phase ?? loaded.Phase;
    actor = createActor(loaded.default?.machine ?? loaded.machine);
  } catch (error) {
    return `when loaded: ${line(error)}`;
  }
  let failure;
  actor.subscribe({ error: (error) => { failure = error; } });
  actor.start();
  for (const [index, [type, distance, right]] of match.entries()) {
    actor.send({ type, ball: { distance, speed: 0 }, phase: Phase.playing });
    if (failure) return `at event ${index + 1}: ${line(failure)}`;
    const state = actor.getSnapshot().value;
    if (state !== right) return `nothing; after event ${index + 1} it is in \`${state}\`, not in \`${right}\``;
  }
  return "nothing; no difference in this match";
}
console.log(await main());
