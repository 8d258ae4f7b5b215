"""Monitors: small automata that decide, while a run goes, whether it does what it has to."""
