// Runs a peer on Node for the benchmark: a JSON line of what to do in, a JSON line of what came of it out.
//
//     node --expose-gc worker.mjs FOLDER ADAPTER      (FOLDER: where node_modules is)

import { createRequire } from "node:module";
import { join } from "node:path";
import { createInterface } from "node:readline";

const [folder, adapter] = process.argv.slice(2);
const require = createRequire(join(folder, "package.json"));
const { maker, distribution } = (await import(`./${adapter}.mjs`)).default(require);

const machines = new Map();

/** A blackboard with all flags false, no message, and all counters 0. */
function blackboard(behaviour) {
  const bb = {};
  for (const flag of behaviour.flags) bb[flag] = false;
  for (const [message] of behaviour.messages) bb[message] = null;
  for (const counter of behaviour.counters) bb[counter] = 0;
  return bb;
}

/** What is set before an event, as a function; undefined if it is nothing. */
function changes(change) {
  if (change.length === 0) return undefined;
  const statements = change.map(([flag, value]) => {
    const [name, member] = flag.split(".");
    return member === undefined ? `bb.${name} = ${value};` : `bb.${name} = { ${member}: ${value} };`;
  });
  return new Function("bb", statements.join(""));
}

/** A running machine with what drives it through its steps once. */
function prepare(behaviour) {
  const bb = blackboard(behaviour);
  const send = maker(behaviour, bb)();
  const steps = behaviour.steps.map(([event, change]) => [event, changes(change)]);
  /** So many steps. */
  const follow = (many) => {
    for (let n = 0; n < many; n++) {
      const [event, change] = steps[n % steps.length];
      if (change) change(bb);
      send(event);
    }
  };
  /** All steps, so many times. */
  const drive = (times) => {
    for (let n = 0; n < times; n++) {
      for (const [event, change] of steps) {
        if (change) change(bb);
        send(event);
      }
    }
  };
  return { bb, follow, drive };
}

function cpu() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}

function answer(order) {
  switch (order.do) {
    case "version":
      return { version: require(`${distribution}/package.json`).version, runtime: `Node ${process.versions.node}` };
    case "check": {
      const { bb, follow } = prepare(order.behaviour);
      follow(order.steps);
      return { counters: Object.fromEntries(order.behaviour.counters.map((counter) => [counter, bb[counter]])) };
    }
    case "load": {
      const begun = cpu();
      machines.set(order.behaviour.name, prepare(order.behaviour));
      return { seconds: cpu() - begun };
    }
    case "time": {
      const { drive } = machines.get(order.name);
      const begun = cpu();
      drive(order.times);
      return { seconds: cpu() - begun };
    }
    case "memory": {
      const make = maker(order.behaviour, blackboard(order.behaviour));
      const kept = [make()];
      globalThis.gc();
      const before = process.memoryUsage().heapUsed;
      const begun = cpu();
      for (let n = 0; n < order.instances; n++) kept.push(make());
      const seconds = cpu() - begun;
      globalThis.gc();
      const bytes = process.memoryUsage().heapUsed - before;
      return { bytes: bytes / order.instances, seconds: seconds / order.instances };
    }
  }
  throw new Error(`unknown order ${order.do}`);
}

for await (const line of createInterface({ input: process.stdin })) {
  let found;
  try {
    found = answer(JSON.parse(line));
  } catch (error) {
    found = { error: String(error) };
  }
  process.stdout.write(JSON.stringify(found) + "\n");
}
