"""The embedded field: a small world of two-dimensional robot soccer, in the standard library alone.

Units are centimetres, degrees (left positive), cm/s, and nanoseconds for time. A match is a world behind the
port of :mod:`aseme_dsl.runtime.world.body`; everything else a robot's activities need from here is data
(:mod:`~aseme_dsl.worlds.field.command`, :mod:`~aseme_dsl.worlds.field.percept`) and pure calculation
(:mod:`~aseme_dsl.worlds.field.skills`).
"""
