"""Timed: how long things take where a team is explored.

- `zone`: what is known of the time since some moments, as bounds of differences
- `stamp`: moments that know from which move on they are counted
- `search`: all states of a team with all times, one for as many times as possible
- `schedule`: moments for the moves of one run
- `ties`: the same for a run that was found without times
"""
