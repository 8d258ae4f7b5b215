"""Wandering: long runs of a team, where it has too many states to look at all of them."""
