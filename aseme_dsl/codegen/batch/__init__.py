"""Batch: the steps of a plain class for thousands of instances at once."""
