"""Spin: a team, or a protocol alone, as a model for SPIN."""
