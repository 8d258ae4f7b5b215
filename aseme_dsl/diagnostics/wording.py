"""Wording: what the texts of problems have in common."""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def a(what: object) -> str:
    """`a bool`, `an int`, `a PlayerState`, `a use case`."""
    text = str(what)
    return f"{'an' if text[:1] in 'aeiouAEIO' and not text.startswith('use ') else 'a'} {text}"


def shown(text: str) -> str:
    """Characters in quotes; what cannot be printed by its number."""
    if len(text) > 40:
        text = text[:37] + "…"
    return "'" + "".join(c if c.isprintable() else f"U+{ord(c):04X}" for c in text) + "'"


def listed(names: Iterable[str], word: str = "and") -> str:
    """`a`, `b` and `c`."""
    shown = [f"`{name}`" for name in names]
    return " ".join([", ".join(shown[:-1]), word, shown[-1]]) if len(shown) > 1 else "".join(shown)


def first_of(names: Sequence[str], most: int) -> str:
    """`a`, `b` and `c`; of more than `most` names the first ones, and how many more there are."""
    if len(names) <= most:
        return listed(names)
    return ", ".join(f"`{name}`" for name in names[:most]) + f" and {len(names) - most} more"


def there_are(names: Sequence[str]) -> str:
    """there is `a`; there are `a` and `b`."""
    return ("there is " if len(names) == 1 else "there are ") + listed(names)


def did_you_mean(name: str) -> str:
    """The hint where one name is spelt alike."""
    return f"did you mean `{name}`?"


def called_now(name: str) -> str:
    """The hint where something was renamed."""
    return f"it is called `{name}` now"


def declared_by(libraries: Sequence[str]) -> str | None:
    """``"`import soccer` declares it"``, or None."""
    return " or ".join(f"`import {item}`" for item in libraries) + " declares it" if libraries else None


def carried_on(channels: Sequence[str]) -> str:
    """On which channels a message is."""
    return "the message is on " + listed(channels) if channels else "no topic carries this message"


def how_to_play(protocols: Iterable[str], participant: str, role: str) -> str:
    """What to write so that a role plays a participant of one of the protocols."""
    plays = listed((f"plays {protocol}.{participant}" for protocol in protocols), "or")
    return f"write {plays} in srm {role}"


__all__ = [
    "a",
    "called_now",
    "carried_on",
    "declared_by",
    "did_you_mean",
    "first_of",
    "how_to_play",
    "listed",
    "shown",
    "there_are",
]
