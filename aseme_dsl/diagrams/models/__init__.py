"""Models: one drawing a model."""
