"""The behaviours as a careful engineer writes them by hand in Python: what everything else is compared with.

Each module has a class with `__slots__`, a method `start`, a method `send(event)` of if and elif, one number
for each region in which more than one state can be active, and a dictionary as its blackboard: the caller
sets the flags in it, the counters are in it. What ends of activities drive has a method `done(activity)`,
with a table where that is faster. `leaves` says which basic states are active, for the check.

`bb["n"] = bb["n"] + 1` is written out, as it is a quarter faster on a dictionary than `bb["n"] += 1`.
"""
