"""Explore: all runs of a team, with the agents, the bus and the conversations that run.

- `surroundings`: time stands still, and what is on its way waits
- `choosing`, `values`, `staging`, `acting`: what is left open in a run, and what is tried for it
- `ages`: what time alone brings
- `memory`, `team_layout`, `relevant`: the state of a team, to come back to and to compare
- `explored`: a team with its next moves
- `search`: all its states, the nearest first
- `questions`: what these say
"""
