"""Story pictures: what happened in a scenario that failed, as a sequence diagram."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.diagrams.sequence.sequence import Arrow, Lifeline, Mark, Row, SequenceDiagram
from aseme_dsl.diagrams.sequence.sequence_svg import drawn
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.project.testing.verdicts import ScenarioResult

_LONGEST = 80
"""The names of files are not longer (letters)."""


def pictures(results: Iterable[ScenarioResult]) -> Iterator[tuple[str, str]]:
    """An SVG for each result with a story, with a name for its file; names are different."""
    all_ = [item for item in results if item.story]
    for name, item in zip(file_names(item.name for item in all_), all_, strict=True):
        yield f"{name}.svg", drawn(diagram_of(item))


def file_names(titles: Iterable[str], otherwise: str = "scenario") -> list[str]:
    """A name for a file for each story, all different; `otherwise` is that of a title without letters."""
    names: dict[str, None] = {}
    for title in titles:
        plain = re.sub(r"[^\w.-]+", "-", title).strip("-.")[:_LONGEST] or otherwise
        name = next(it for it in (plain, *(f"{plain}-{n}" for n in range(2, 10_000))) if it not in names)
        names[name] = None
    return list(names)


def diagram_of(result: ScenarioResult) -> SequenceDiagram:
    """The story of a result, up to the expectation that was broken."""
    place = f"{result.span}: " if result.span is not None else ""
    title = f"{result.name} (seed {result.seed})"
    return diagram_of_story(title, result.story, f"{place}{result.reason}", dict(result.team))


def diagram_of_story(
    title: str, story: Iterable[Happened], remark: str, roles: Mapping[str, str]
) -> SequenceDiagram:
    """A story with what is to be said of it; `roles` are those of the agents, in the order of the team."""
    items = tuple(story)
    inside = dict.fromkeys(name for item in items for name in (item.agent, *item.to))
    names = (*(name for name in roles if name in inside), *(name for name in inside if name not in roles))
    lifelines = tuple(Lifeline(name, roles.get(name, "")) for name in names)
    return SequenceDiagram(title, lifelines, tuple(map(_row, items)), (remark,))


def _row(item: Happened) -> Row:
    if item.to:
        return Arrow(item.moment, item.agent, item.to, item.sent, "")
    awaited = "; ".join(text.removeprefix("- ") for text in item.details if text.startswith("- "))
    return Mark(item.moment, item.agent, f"{item.line} {awaited}".rstrip())


__all__ = ["diagram_of", "diagram_of_story", "file_names", "pictures"]
