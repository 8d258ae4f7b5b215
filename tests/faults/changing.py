"""Running teams that are changed to other versions of their texts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from aseme_dsl.runtime.activity.activities import ActivityFinder
from aseme_dsl.runtime.team.swap import Version
from aseme_dsl.runtime.trace.trace import Record
from tests.support.generated import Generated, generate


def version(
    what: str | Generated, activities: Mapping[str, type[Any]] | ActivityFinder | None = None
) -> Version:
    """A text as a version to change to."""
    made = what if isinstance(what, Generated) else generate(what)
    find: ActivityFinder = activities if callable(activities) else dict(activities or {}).get
    return Version(
        made.system.name,
        made.charts,
        find,
        {name: kind for name, kind in vars(made.messages).items() if isinstance(kind, type)},
        getattr(made.messages, "SCHEMA", None),
        made.package.MODEL,
        (made.folder,),
        team=made.package.TEAM,
        sources=made.package.SOURCES,
    )


def without(records: list[Record], *kinds: str) -> list[Record]:
    """The records but those of these kinds."""
    return [record for record in records if record["kind"] not in kinds]
