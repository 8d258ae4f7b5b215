"""Explore: all runs of a team, with the agents, the bus and the conversations that run.

- `surroundings`: time stands still, and what is on its way waits
- `deciding`: what is left open in a run, and what is tried for it
- `coming`: what comes to agents from outside, and from their own activities
- `ages`: what time alone brings
- `memory`, `team_layout`, `relevant`: the state of a team, to come back to and to compare
- `reducing`: what makes no difference any more
- `explored`: a team with its next moves
- `apart`, `needed`: which agents and regions need not be looked at together
- `search`: all its states, the nearest first
- `questions`: what these say
"""
