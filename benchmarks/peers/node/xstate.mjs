// XState 5: a machine from its configuration, and an actor of it.

import { actionFunction, guardFunction } from "./code.mjs";

export default function adapter(require) {
  const { createActor, createMachine } = require("xstate");

  function maker(behaviour, bb) {
    const definition = (state) => {
      const found = { id: state.name };
      if (state.entry.length) found.entry = actionFunction(state.entry, bb);
      if (state.exit.length) found.exit = actionFunction(state.exit, bb);
      if (state.kind === "and") found.type = "parallel";
      if (state.kind === "or") found.initial = state.children[0].name;
      if (state.children.length) {
        found.states = Object.fromEntries(state.children.map((child) => [child.name, definition(child)]));
      }
      for (const { event, target, guard } of state.transitions) {
        const item = { target: `#${target}`, reenter: true };
        if (guard.length) item.guard = guardFunction(guard, bb);
        if (!event) {
          (found.always ??= []).push(item);
          continue;
        }
        found.on ??= {};
        (found.on[event] ??= []).push(item);
      }
      return found;
    };
    const machine = createMachine(definition(behaviour.root));
    const events = Object.fromEntries(behaviour.steps.map(([event]) => [event, { type: event }]));
    return () => {
      const actor = createActor(machine).start();
      return (event) => actor.send(events[event]);
    };
  }

  return { maker, distribution: "xstate" };
}
