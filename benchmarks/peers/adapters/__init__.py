"""One module a peer: `start(behaviour, bb)` makes a running machine and returns what sends it an event.

The blackboard is a dictionary; guards read it and actions change it as a user of the library would write
them. Of several ways to use a library, each takes the fastest one that means the same.
"""
