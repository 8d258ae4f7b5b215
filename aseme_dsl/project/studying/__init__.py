"""Studying: many runs and measurements, and what they say."""
