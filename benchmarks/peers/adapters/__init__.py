"""One module a peer: `maker(behaviour, bb)` makes what machines have in common, and returns what makes one.

The blackboard is a dictionary; guards read it and actions change it as a user of the library would write
them. Of several ways to use a library, each takes the fastest one that means the same.
"""
