"""Proving: verdicts about all runs above the text, from a process that works in the background."""
