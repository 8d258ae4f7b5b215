"""Access: an activity uses only the channels and variables that its `.aseme` file declares for it."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

from aseme_dsl.runtime.chart.plan import ActivityInfo, ModuleInfo, Variable
from aseme_dsl.runtime.time.clock import shown


class UndeclaredError(LookupError):
    """An activity or module uses what it does not declare; the text has the line to add."""


def check_read(info: ActivityInfo, channel: str) -> None:
    """Raises UndeclaredError if the activity does not declare that it reads a channel."""
    if channel not in info.reads:
        raise _undeclared(info, "reads", channel, info.reads)


def check_publish(info: ActivityInfo, channel: str) -> None:
    """Raises UndeclaredError if the activity does not declare that it writes a channel."""
    if channel not in info.writes:
        raise _undeclared(info, "writes", channel, info.writes)


def check_look_back(info: ActivityInfo, channel: str, duration: int | None) -> int:
    """How far back the activity looks, in ns: so far, or (None) as far as it declares.

    Raises:
        UndeclaredError: it declares less, or nothing.
    """
    check_read(info, channel)
    kept = dict(info.histories).get(channel, 0)
    if duration is None and kept:
        return kept
    if duration is not None and duration <= kept:
        return duration
    wanted = shown(duration).replace(" ", "") if duration is not None else "…"
    how = (
        f"reads the history of {channel}"
        if duration is None
        else f"looks back {shown(duration)} at {channel}"
    )
    declared = f"it declares {shown(kept)}" if kept else "it declares no history of it"
    raise UndeclaredError(
        f"{_who(info)} {how}, and {declared}: {_line(info, f'reads {channel} for {wanted}')}"
    )


def check_get(info: ActivityInfo, variable: Variable, name: str) -> None:
    """Raises UndeclaredError for a role's variable that the activity does not declare to read.

    The variables of a participant are there for its activities.
    """
    if variable.scope is None and name not in info.reads_variables:
        raise _undeclared(info, "reads", name, info.reads_variables, "the variable ")


def check_set(info: ActivityInfo, variable: Variable, name: str) -> None:
    """Raises UndeclaredError for a role's variable that the activity does not declare to write."""
    if variable.scope is None and name not in info.variables:
        raise _undeclared(info, "writes", name, info.variables, "the variable ")


def _undeclared(
    info: ActivityInfo, clause: str, name: str, declared: Iterable[str], what: str = ""
) -> UndeclaredError:
    near = get_close_matches(name, declared, 1, 0.8)
    meant = f" (did you mean {near[0]}?)" if near else ""
    text = f"{_who(info)} {clause} {what}{name}, which it does not declare{meant}"
    return UndeclaredError(f"{text}: {_line(info, f'{clause} {name}')}")


def _who(info: ActivityInfo) -> str:
    return f"{'module' if isinstance(info, ModuleInfo) else 'activity'} {info.name}"


def _line(info: ActivityInfo, clause: str) -> str:
    block = "modules" if isinstance(info, ModuleInfo) else "activities"
    return f"add `{block} {{ {info.name} {clause} }}` to the .aseme file"


__all__ = ["UndeclaredError", "check_get", "check_look_back", "check_publish", "check_read", "check_set"]
