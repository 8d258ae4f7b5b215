"""AMOLA: the models of ASEME as plain immutable data; every element carries its span."""
