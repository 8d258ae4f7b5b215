"""Backends: models to code for a platform."""
