"""Simulated surroundings that come with the package: each is a world for the port of the runtime."""
