"""Deciding: what is left open in a run, and what is tried for it.

- `choosing`: one answer after another
- `values`: what is tried, by what the document does with each value
- `lists`: texts that hold agents, and numbers in them that need not be tried
- `later`: contents of messages that are decided when they are read
- `arriving`: messages that are there, or not, when something looks for them
- `joining`: what comes at the same moment as something else
- `staging`: the statecharts of a team that is explored
- `acting`: what activities do
- `absence`: where it makes no difference whether a message has come
- `ahead`: the states that may be active from one on
"""
