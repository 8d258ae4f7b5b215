"""Settings: what an editor says of proofs, at its start or later."""

from __future__ import annotations

import re
from dataclasses import replace

from aseme_dsl.editor.proving.proofs import Settings

MOST_ROBOTS = 16
_DURATION = re.compile(r"(\d+(?:\.\d+)?)\s*(ms|s|min)")
_SECONDS = {"ms": 0.001, "s": 1.0, "min": 60.0}


class WrongSetting(Exception):
    """A setting that means nothing; the text says which."""


def read_settings(given: object, before: Settings) -> Settings:
    """The settings with what an editor has said: `{"prove": {"onSave", "budget", "robots"}}`, also inside
    `aseme`.

    Raises:
        WrongSetting: one of them is none.
    """
    found = _member(given, "prove")
    if found is None:
        found = _member(_member(given, "aseme"), "prove")
    on_save, budget, robots = (_member(found, name) for name in ("onSave", "budget", "robots"))
    settings = before
    if on_save is not None:
        if not isinstance(on_save, bool):
            raise WrongSetting(f"prove.onSave is true or false, not {on_save}")
        settings = replace(settings, on_save=on_save)
    if budget is not None:
        duration = _DURATION.fullmatch(str(budget))
        if duration is None or float(duration[1]) <= 0:
            raise WrongSetting(f'prove.budget is a duration like "10s", not {budget}')
        settings = replace(settings, budget=float(duration[1]) * _SECONDS[duration[2]])
    if robots is not None:
        if isinstance(robots, bool) or not isinstance(robots, int) or not 1 <= robots <= MOST_ROBOTS:
            raise WrongSetting(f"prove.robots is a number from 1 to {MOST_ROBOTS}, not {robots}")
        settings = replace(settings, robots=robots)
    return settings


def _member(data: object, name: str) -> object:
    return data.get(name) if isinstance(data, dict) else getattr(data, name, None)


__all__ = ["WrongSetting", "read_settings"]
