"""Report: what is different between two versions, for people and for programs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aseme_dsl.project.comparing.behaviour import Result, Verdict, is_declared
from aseme_dsl.project.comparing.elements import Element
from aseme_dsl.project.comparing.structure import Change, Sort, Structure
from aseme_dsl.project.comparing.versions import Compiled
from aseme_dsl.proofs.compare.search import Difference
from aseme_dsl.proofs.compare.side import Seen
from aseme_dsl.records import dataclass

SHOWN = 100
"""So many characters of a line of a document are shown."""


@dataclass(frozen=True, slots=True)
class Report:
    """All that was found of two versions."""

    old: Compiled
    new: Compiled
    structure: Structure
    results: tuple[Result, ...]

    @property
    def verdict(self) -> Verdict:
        """DIFFERENT if any run or declaration is; else UNDECIDED if anything is."""
        found = [item.verdict for item in self.results]
        if Verdict.DIFFERENT in found or any(map(is_declared, self.structure.changes)):
            return Verdict.DIFFERENT
        return Verdict.UNDECIDED if Verdict.UNDECIDED in found else Verdict.EQUAL

    @property
    def summary(self) -> str:
        """The answer in one line."""
        match self.verdict:
            case Verdict.DIFFERENT:
                return "the behaviour is different"
            case Verdict.UNDECIDED:
                return "no difference in behaviour was found, but not all was compared"
            case Verdict.EQUAL:
                renamed = any(item.sort is Sort.RENAMED for item in self.structure.changes)
                return "no difference in behaviour" + (", but in names" if renamed else "")


def lines(report: Report) -> Iterator[str]:
    """The report for people."""
    yield f"{report.old.name} -> {report.new.name}: {report.summary}"
    if report.structure.changes:
        yield ""
        for change in report.structure.changes:
            yield from _change(report, change)
    for result in report.results:
        if result.verdict is not Verdict.EQUAL or not result.is_unchanged:
            yield ""
            yield f"{result.what}: {result.verdict.value}, {result.bounds}"
            for difference in result.found.differences if result.found is not None else ():
                yield ""
                yield from (f"  {line}".rstrip() for line in story(difference))
    unchanged = [item.what for item in report.results if item.is_unchanged]
    if unchanged and len(unchanged) < len(report.results):
        yield ""
        yield f"unchanged: {', '.join(unchanged)}"


def _change(report: Report, change: Change) -> Iterator[str]:
    sign = change.sort.sign
    old, new = change.old, change.new
    match change.sort:
        case Sort.ADDED:
            assert new is not None
            yield f"{sign} {new.title}  ({place(new)})"
            yield from _text("  +", new)
        case Sort.REMOVED:
            assert old is not None
            yield f"{sign} {old.title}  ({place(old)})"
            yield from _text("  -", old)
        case Sort.CHANGED:
            assert old is not None and new is not None
            yield f"{sign} {new.title}  ({place(old)} -> {place(new)})"
            yield from _text("  -", old)
            yield from _text("  +", new)
        case Sort.RENAMED:
            assert old is not None and new is not None
            yield f"{sign} {old.title} is called {new.name} now  ({place(old)} -> {place(new)})"


def _text(sign: str, element: Element) -> Iterator[str]:
    text = short(element.text)
    if text and text != element.name:
        yield f"{sign} {text}"


def place(element: Element) -> str:
    """`team.aseme:12`."""
    return f"{element.span.source.path.rpartition('/')[2]}:{element.span.line}"


def short(text: str) -> str:
    """A text in one line, cut where it is long."""
    text = " ".join(text.split())
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 1]}…"


def story(difference: Difference) -> Iterator[str]:
    """The run up to the difference, a line each, and what each version does then."""
    events = difference.story
    for number, event in enumerate(events, 1):
        decided = f" ({'; '.join(event.decided)})" if event.decided else ""
        seen = f": {', '.join(item.text for item in event.seen)}" if event.seen else ""
        yield f"{number:>2}  {event.move.text}{decided}{seen}"
    yield from _does("OLD", difference.only_old)
    yield from _does("NEW", difference.only_new)


def _does(word: str, seen: Sequence[Seen]) -> Iterator[str]:
    if not seen:
        yield f"{word} does nothing more"
    for item in seen:
        at = f"  ({short(item.at)})" if item.at else ""
        yield f"{word} {item.text}{at}"


def as_json(report: Report) -> dict[str, object]:
    """The report for programs."""
    return {
        "format": 1,
        "old": report.old.name,
        "new": report.new.name,
        "verdict": report.verdict.value,
        "changes": [
            {
                "change": item.sort.value,
                "kind": item.element.kind,
                "of": item.element.owner,
                "name": item.element.name,
                "old": _element_json(item.old),
                "new": _element_json(item.new),
            }
            for item in report.structure.changes
        ],
        "results": [
            {
                "what": item.what,
                "verdict": item.verdict.value,
                "bounds": item.bounds,
                "differences": [
                    _difference_json(one)
                    for one in (item.found.differences if item.found is not None else ())
                ],
            }
            for item in report.results
        ],
    }


def _element_json(item: Element | None) -> dict[str, object] | None:
    if item is None:
        return None
    name = item.span.source.path.rpartition("/")[2]
    return {"name": item.name, "text": item.text, "file": name, "line": item.span.line}


def _difference_json(item: Difference) -> dict[str, object]:
    return {
        "run": [
            {
                "time": event.time / 1_000_000_000,
                "input": event.move.text,
                "decided": list(event.decided),
                "both": [seen.text for seen in event.seen],
            }
            for event in item.story
        ],
        "old": [{"text": seen.text, "at": seen.at} for seen in item.only_old],
        "new": [{"text": seen.text, "at": seen.at} for seen in item.only_new],
    }


__all__ = ["Report", "as_json", "lines", "place", "short", "story"]
