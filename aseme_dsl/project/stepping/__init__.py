"""Stepping: a run in virtual time that a user takes from instant to instant, also backwards."""
