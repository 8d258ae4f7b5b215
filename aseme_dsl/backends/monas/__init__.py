"""monas: Python modules in the style of the Monas robot architecture, run by `aseme_dsl.runtime`."""

from aseme_dsl.backends.monas.generate import BACKEND

__all__ = ["BACKEND"]
