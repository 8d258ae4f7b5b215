"""Sequence: diagrams of what agents say to each other."""
