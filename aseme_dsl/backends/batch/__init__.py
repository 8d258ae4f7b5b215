"""batch: thousands of instances of a statechart at once, with NumPy or numba."""

from aseme_dsl.backends.batch.generate import BACKEND

__all__ = ["BACKEND"]
