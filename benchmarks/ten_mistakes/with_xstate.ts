import { setup } from "xstate";

export enum Phase { idle, playing }
export enum Side { left, right }
export interface Ball { distance: number; speed: number }
type Seen = { ball: Ball; phase: Phase };

export const isStill = (speed: number): boolean => speed < 0.1;

export const machine = setup({
  types: { events: {} as ({ type: "done" } & Seen) | ({ type: "whistle" } & Seen) },
  guards: {
    isClose: ({ event }) => event.ball.distance < 0.3 && event.phase === Phase.playing,
    isFar: ({ event }) => event.ball.distance >= 0.3 || event.phase === Phase.idle,
    liesStill: ({ event }) => isStill(event.ball.speed),
  },
}).createMachine({
  id: "kicker",
  initial: "search",
  states: {
    search: {
      on: {
        done: [
          { target: "kick", guard: "isClose" },
          { target: "approach", guard: "isFar" },
        ],
      },
    },
    approach: { on: { done: { target: "search" }, whistle: { target: "search" } } },
    kick: { on: { done: { target: "search", guard: "liesStill" } } },
  },
});
