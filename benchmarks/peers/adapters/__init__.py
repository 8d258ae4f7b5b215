"""One module a peer: `maker(behaviour, bb)` makes what machines have in common, and returns what makes one.

It may take more, such as a `form`, that says which of several ways to use the library is meant.

The blackboard is a dictionary; guards read it and actions change it as a user of the library would write
them. Of several ways to use a library, each takes the fastest one that means the same.
"""
