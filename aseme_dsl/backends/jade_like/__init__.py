"""jade_like: the same statecharts as agents with behaviours, in the terms of JADE."""

from aseme_dsl.backends.jade_like.generate import BACKEND

__all__ = ["BACKEND"]
