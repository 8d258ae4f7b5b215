"""Trace: what happened in a run, written and read."""
