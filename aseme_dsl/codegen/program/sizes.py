"""From where on code is written in another way, since there is much of it."""

TABLE = 64
"""Regions with more numbers than this dispatch through a tuple of functions, others through comparisons."""

CHUNK = 64
"""So many numbers have a function together: a power of two."""

IN_LINE = 400
"""An event whose body has more lines than this has a method of its own."""

SHARED = 400
"""With more tests that need no event than this, for all events together, events share methods for them."""

BRANCHES = 8
"""More events than this are found in a table, fewer by comparisons."""

GUARDS = 8
"""So many conditions in a row are not looked at again before the blackboard has changed, if it is tracked.

With fewer, asking for that costs those who do not track theirs more than it saves those who do.
"""

LEGEND = 16
"""So many states are named where the class says what its slots mean."""

NESTED = 6
"""Regions in so many others, and in twice as many, have methods of their own."""

DEEP = 24
"""Code that is indented further moves into a method (CPython refuses more than 100 levels)."""
