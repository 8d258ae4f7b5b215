"""ASEME in text: from a `.aseme` file through every AMOLA model to statecharts that run."""

from __future__ import annotations

__version__ = "0.1.0"
