"""Naming: from a name of the document to the names that Python and protobuf files give it."""

from __future__ import annotations

import keyword
import re


def snake_case(name: str) -> str:
    """`CheckForBall` as `check_for_ball`; what is written so already stays."""
    spaced = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name)
    return re.sub(r"_+", "_", spaced).lower()


def usable(name: str) -> str:
    """`name`, with an underscore behind it if it is one of Python's keywords."""
    return f"{name}_" if keyword.iskeyword(name) else name


def module_name(name: str) -> str:
    """The module of an activity: `CheckForBallObservation` is in `check_for_ball_observation`."""
    return usable(snake_case(name))


def class_name(name: str) -> str:
    """The class of an activity: `kick_ball` and `KickBall` are both `KickBall`, and `none` is `None_`."""
    return usable("".join(part[:1].upper() + part[1:] for part in name.split("_")) or "_")
