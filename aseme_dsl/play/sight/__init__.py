"""Sight: what is seen of a run: inside of agents, later than it happens, by one agent, and as a story."""
