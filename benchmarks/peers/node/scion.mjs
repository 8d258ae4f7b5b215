// SCION: its core, which interprets SCXML's semantics, on a model of states as objects.

import { actionFunction, guardFunction } from "./code.mjs";

export default function adapter(require) {
  const { Statechart } = require("@scion-scxml/core");

  function maker(behaviour, bb) {
    const definition = (state) => {
      const found = { id: state.name };
      if (state.entry.length) found.onEntry = actionFunction(state.entry, bb);
      if (state.exit.length) found.onExit = actionFunction(state.exit, bb);
      if (state.kind === "and") found.$type = "parallel";
      if (state.children.length) found.states = state.children.map(definition);
      if (state.transitions.length) {
        found.transitions = state.transitions.map(({ event, target, guard }) => {
          const item = event ? { event, target } : { target };
          if (guard.length) item.cond = guardFunction(guard, bb);
          return item;
        });
      }
      return found;
    };
    // A model that is not made by a function is copied as JSON, without its functions.
    const model = () => definition(behaviour.root);
    const events = Object.fromEntries(behaviour.steps.map(([event]) => [event, { name: event }]));
    return () => {
      const chart = new Statechart(model);
      chart.start();
      return (event) => chart.gen(events[event]);
    };
  }

  return { maker, distribution: "@scion-scxml/core" };
}
