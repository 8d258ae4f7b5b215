"""Story pictures: what happened in a scenario that failed, as a sequence diagram."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from aseme_dsl.diagrams.sequence.sequence import Arrow, Lifeline, Mark, Row, SequenceDiagram
from aseme_dsl.diagrams.sequence.sequence_svg import drawn
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.project.testing.verdicts import ScenarioResult


def pictures(results: Iterable[ScenarioResult]) -> Iterator[tuple[str, str]]:
    """An SVG for each result with a story, with a name for its file; names are different."""
    all_ = [item for item in results if item.story]
    for name, item in zip(file_names(item.name for item in all_), all_, strict=True):
        yield f"{name}.svg", drawn(diagram_of(item))


def file_names(titles: Iterable[str]) -> list[str]:
    """A name for a file for each scenario, all different."""
    names: dict[str, None] = {}
    for title in titles:
        plain = re.sub(r"[^\w.-]+", "-", title).strip("-.") or "scenario"
        name = next(it for it in (plain, *(f"{plain}-{n}" for n in range(2, 10_000))) if it not in names)
        names[name] = None
    return list(names)


def diagram_of(result: ScenarioResult) -> SequenceDiagram:
    """The story of a result, up to the expectation that was broken."""
    inside = dict.fromkeys(name for item in result.story for name in (item.agent, *item.to))
    roles = dict(result.team)
    names = (*(name for name in roles if name in inside), *(name for name in inside if name not in roles))
    lifelines = tuple(Lifeline(name, roles.get(name, "")) for name in names)
    place = f"{result.span}: " if result.span is not None else ""
    title = f"{result.name} (seed {result.seed})"
    return SequenceDiagram(title, lifelines, tuple(map(_row, result.story)), (f"{place}{result.reason}",))


def _row(item: Happened) -> Row:
    if item.to:
        return Arrow(item.moment, item.agent, item.to, item.sent, "")
    awaited = "; ".join(text.removeprefix("- ") for text in item.details if text.startswith("- "))
    return Mark(item.moment, item.agent, f"{item.line} {awaited}".rstrip())


__all__ = ["diagram_of", "file_names", "pictures"]
