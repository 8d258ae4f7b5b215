"""Proofs: what holds in all runs. Of one choice by z3; of a team by its states.

- `unknowns`: what a snapshot gives values to: messages, members, variables, timers, what functions return
- `evaluate`: whether a condition holds when some of them are known
- `encoding`: conditions as formulas of z3, with absence and faults exactly as they run
- `solver`: whether conditions can hold and fail together, and the simplest values that make them
- `ways`: the outgoing transitions of a state, through its choices
- `choice`: which choices are looked at, and what may be found
- `findings`: overlaps, gaps, and branches that are never or always open
- `prover`: z3, where it is installed
- `explore`: all runs of a team
"""
