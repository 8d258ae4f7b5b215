"""Comparing: what is different between two versions of a system.

- `versions`: a file, a folder or a revision, as something to compile
- `elements`: what a system consists of, each with its place
- `structure`: what of it was added, removed, changed or renamed
- `behaviour`: the shortest runs that one version can do and the other cannot
- `report`, `markdown`: all of it as text
- `pictures`: the drawing of a statechart with what was changed
"""
