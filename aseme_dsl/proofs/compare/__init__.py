"""Compare: the shortest run that one version of a statechart can do and the other cannot.

- `decisions`: what is left open is decided once for both versions
- `unread`: messages whose content is decided when it is read
- `staging`: the generated statechart of a version, with all that comes from outside left open
- `side`: one version in a run, and what is seen of it
- `normal`: what of a state can still make a difference
- `inputs`: what may happen to both versions next
- `search`: all states of both together, the nearest first
"""
