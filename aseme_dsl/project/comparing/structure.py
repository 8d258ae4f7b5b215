"""Structure: what of a system was added, removed, changed or renamed."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from enum import StrEnum

from aseme_dsl.project.comparing.elements import Element
from aseme_dsl.records import dataclass

NAMED = ("activity", "state", "variable", "formula", "role", "protocol", "participant", "message", "enum")
"""What may get another name while all else stays the same."""


_BEFORE = 40
"""So much of two texts that are equal at first is shown before what is different (characters)."""


class Sort(StrEnum):
    """What has become of an element, with the sign that shows it."""

    ADDED = "added"
    REMOVED = "removed"
    CHANGED = "changed"
    RENAMED = "renamed"

    @property
    def sign(self) -> str:
        return {"added": "+", "removed": "-", "changed": "~", "renamed": "="}[self.value]


@dataclass(frozen=True, slots=True)
class Change:
    """What has become of an element: `old` is None for what was added, `new` for what was removed."""

    sort: Sort
    old: Element | None
    new: Element | None

    @property
    def element(self) -> Element:
        found = self.new or self.old
        assert found is not None
        return found


@dataclass(frozen=True, slots=True)
class Structure:
    """All changes, and the new names by kind and old name."""

    changes: tuple[Change, ...]
    names: Mapping[str, Mapping[str, str]]

    @property
    def only_names(self) -> bool:
        """Whether nothing that matters to runs is different but names."""
        return all(item.sort is Sort.RENAMED or not item.element.matters for item in self.changes)


def changes_of(old: Sequence[Element], new: Sequence[Element]) -> Structure:
    """What is different between the elements of two versions."""
    names: dict[str, dict[str, str]] = {}
    renamed: list[Change] = []
    current = tuple(old)
    while (found := _renaming(current, new)) is not None:
        before, after = found
        names.setdefault(before.kind, {})[before.name] = after.name
        original = next(
            (item for item in old if item.span == before.span and item.kind == before.kind), before
        )
        renamed.append(Change(Sort.RENAMED, original, after))
        current = tuple(_with_name(item, before, after) for item in current)
    theirs = {item.key: item for item in new}
    ours = {item.key: item for item in current}
    originals = {item.key: one for item, one in zip(current, old, strict=True)}
    changes = list(renamed)
    for key, item in ours.items():
        other = theirs.get(key)
        if other is None:
            changes.append(Change(Sort.REMOVED, originals[key], None))
        elif other.meaning != item.meaning:
            changes.append(Change(Sort.CHANGED, *_told_apart(originals[key], other)))
    changes += [Change(Sort.ADDED, None, item) for key, item in theirs.items() if key not in ours]
    return Structure(tuple(_without_consequences(changes)), names)


def _told_apart(old: Element, new: Element) -> tuple[Element, Element]:
    """Two elements with texts that differ: if only a `let` is another one, with what it stands for.

    That may be long: then the text begins shortly before the difference."""
    if old.text != new.text or old.whole == new.whole:
        return old, new
    pairs = enumerate(zip(old.whole, new.whole, strict=False))
    same = next((number for number, (one, other) in pairs if one != other), 0)
    begin = same - _BEFORE if same > 2 * _BEFORE else 0
    texts = [f"…{item.whole[begin:]}" if begin else item.whole for item in (old, new)]
    return replace(old, text=texts[0]), replace(new, text=texts[1])


def _renaming(old: Sequence[Element], new: Sequence[Element]) -> tuple[Element, Element] | None:
    """A pair of which one has become the other: with its name, less is different."""
    before = {item.key: item for item in old}
    after = {item.key: item for item in new}
    for kind in NAMED:
        gone = [item for key, item in before.items() if item.kind == kind and key not in after]
        came = [item for key, item in after.items() if item.kind == kind and key not in before]
        for one in gone:
            alike = [item for item in came if _masked(item) == _masked(one)]
            rivals = [item for item in gone if _masked(item) == _masked(one)]
            if len(alike) == len(rivals) == 1 or (len(alike) == 1 and len(gone) == 1):
                other = alike[0]
                now = _different(old, new)
                then = _different([_with_name(item, one, other) for item in old], new)
                if then <= now - 2 and _is_whole(one, other, old, new):
                    return one, other
    return None


def _is_whole(one: Element, other: Element, old: Sequence[Element], new: Sequence[Element]) -> bool:
    """Whether most of what speaks of one speaks of the other now, in the same way."""
    changed = [_with_name(item, one, other) for item in old]
    known = {(item.key, item.meaning) for item in new}
    about = [
        item
        for item, before in zip(changed, old, strict=True)
        if (item.key, item.meaning) != (before.key, before.meaning)
    ]
    same = [(item.key, item.meaning) in known for item in about if item.matters]
    return same.count(False) <= same.count(True) // 2


def _different(old: Iterable[Element], new: Iterable[Element]) -> int:
    first = {(item.key, item.meaning) for item in old}
    second = {(item.key, item.meaning) for item in new}
    return len(first ^ second)


def _masked(item: Element) -> tuple[str, str, str]:
    return item.kind, item.owner, _word(item.name).sub("·", item.meaning)


def _word(name: str) -> re.Pattern[str]:
    return re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")


def _with_name(item: Element, before: Element, after: Element) -> Element:
    """An element of the old version with what was called `before` called `after`."""
    word = _word(before.name)
    owner = before.owner
    if owner and before.kind in ("variable", "formula") and item.owner != owner:
        return item
    return replace(
        item,
        owner=word.sub(after.name, item.owner),
        name=word.sub(after.name, item.name),
        meaning=word.sub(after.name, item.meaning),
    )


def _without_consequences(changes: Sequence[Change]) -> list[Change]:
    """The changes without those that only follow from others: a new activity is a new state, too."""
    come = {(item.sort, item.element.name) for item in changes if item.element.kind == "activity"}
    owners = {(item.sort, item.element.name) for item in changes if item.element.kind in ("role", "protocol")}
    kept = []
    for item in changes:
        element = item.element
        is_state = element.kind == "state" and (item.sort, element.name.partition("#")[0]) in come
        if element.kind == "order" and item.sort is not Sort.CHANGED:
            continue
        if not is_state and (item.sort, element.owner.partition(".")[0]) not in owners:
            kept.append(item)
    return kept


__all__ = ["Change", "Sort", "Structure", "changes_of"]
