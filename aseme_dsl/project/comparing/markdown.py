"""Markdown: what is different between two versions, as a comment on a change."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.project.comparing.behaviour import Verdict
from aseme_dsl.project.comparing.report import Report, place, short, story

MARK = "<!-- asemec diff -->"
"""The first line, by which a job finds its earlier comment."""
_SIGNS = {"equal": "✅", "different": "⚠️", "undecided": "❔"}


def markdown(report: Report, pictures: tuple[str, ...] = ()) -> Iterator[str]:
    """The report in Markdown of GitHub; `pictures` are addresses or paths of drawings."""
    yield MARK
    yield f"### {_SIGNS[report.verdict.value]} `{report.old.name}` → `{report.new.name}`: {report.summary}"
    yield ""
    for result in report.results:
        if result.is_unchanged:
            continue
        yield f"**{_SIGNS[result.verdict.value]} {result.what}**: {result.verdict.value}, {result.bounds}"
        yield ""
        for difference in result.found.differences if result.found is not None else ():
            first = (*difference.only_old, *difference.only_new)[0]
            who = "only the old version" if difference.only_old else "only the new version"
            yield f"<details><summary>{who} {_escaped(short(first.text))}</summary>"
            yield ""
            yield "```text"
            yield from (line.replace("```", "'''") for line in story(difference))
            yield "```"
            yield ""
            yield "</details>"
            yield ""
    unchanged = [item.what for item in report.results if item.is_unchanged]
    if unchanged:
        yield f"Unchanged: {', '.join(unchanged)}."
        yield ""
    if report.structure.changes:
        count = len(report.structure.changes)
        yield f"<details><summary>{count} change{'s' if count > 1 else ''} in the model</summary>"
        yield ""
        yield "| | what | old | new |"
        yield "| --- | --- | --- | --- |"
        for item in report.structure.changes:
            cells = [_cell(part) for part in (item.old, item.new)]
            yield f"| {item.sort.value} | {_escaped(item.element.title)} | {cells[0]} | {cells[1]} |"
        yield ""
        yield "</details>"
        yield ""
    for address in pictures:
        yield f"![what was changed]({address})"
    if report.verdict is Verdict.UNDECIDED:
        yield "_Not all runs were compared: a larger `--budget` may decide it._"


def _cell(item: object) -> str:
    from aseme_dsl.project.comparing.elements import Element

    if not isinstance(item, Element):
        return ""
    text = short(item.text).replace("`", "'").replace("|", "\\|")
    return f"`{text}` ({place(item)})"


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("|", "\\|")


__all__ = ["MARK", "markdown"]
