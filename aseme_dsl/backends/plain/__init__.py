"""The plain backend: each role's statechart as one ordinary Python class, for programs without agents."""

from aseme_dsl.backends.plain.generate import BACKEND, PlainBackend

__all__ = ["BACKEND", "PlainBackend"]
