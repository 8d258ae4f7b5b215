"""Observing: whether logs of real runs keep the properties, the clauses and the protocols of a model."""
