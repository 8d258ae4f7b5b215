"""Checks of what the participants of a protocol send to each other."""
