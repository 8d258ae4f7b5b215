"""Proving: what holds in every run of a system, and the runs in which it does not."""
