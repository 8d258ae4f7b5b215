"""The coverage of a system in words, for people, and as data, for programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import islice

from aseme_dsl.play.coverage.measure import Coverage, Item, Kind, Share, Status

FORMAT = 1
_WIDEST = 100


def percent_text(share: Share) -> str:
    """A share in whole percent, never rounded up to 100."""
    if share.percent is None:
        return "-"
    return f"{int(share.percent)}%"


def lines(coverage: Coverage) -> Iterator[str]:
    """A table of all kinds, then what was not covered, with its place."""
    yield f"coverage of {coverage.system}: {origin(coverage)}"
    for note in coverage.notes:
        yield f"  {note}"
    yield f"{'':12} {'covered':>7} {'of':>6}"
    for kind in Kind:
        share = coverage.share(kind)
        if share.total or share.never:
            yield f"{kind:12} {share.covered:7} {share.total:6} {percent_text(share):>5}{_beside(share)}"
    for status, title in _TITLES.items():
        left = [item for item in coverage.items if item.status is status]
        if left:
            yield ""
            yield title
            yield from _listed(left, status)


_TITLES = {
    Status.MISSED: "not covered",
    Status.NEVER: "can never be reached",
    Status.UNMEASURED: "not measured",
}


def origin(coverage: Coverage) -> str:
    """What it was measured from."""
    counts = [(coverage.scenarios, "scenario"), (coverage.traces, "trace")]
    said = [f"{count} {noun}{'' if count == 1 else 's'}" for count, noun in counts if count]
    return ", ".join(said) or "no runs"


def _beside(share: Share) -> str:
    said = [
        f"{count} {words}"
        for count, words in ((share.never, "can never be reached"), (share.unmeasured, "not measured"))
        if count
    ]
    return f"   {', '.join(said)}" if said else ""


def _listed(items: Sequence[Item], status: Status) -> Iterator[str]:
    """The first items with their places: those of the project, then those of libraries. The rest is counted.

    What is inside a state that was missed is only counted with it, and so are items that read alike: those of
    the instances of a formula.
    """
    missed = {(item.of, item.label) for item in items if item.kind is Kind.STATES}
    inside: Counter[tuple[str, str, Kind]] = Counter()
    alike: Counter[tuple[Kind, str]] = Counter()
    shown: list[Item] = []
    for item in items:
        if status is Status.UNMEASURED and item.kind is Kind.CONDITIONS:
            alike[item.kind, item.reason] += 1
        elif (top := _missed_around(item, missed)) is not None:
            inside[item.of, top, item.kind] += 1
        else:
            shown.append(item)
    lines: Counter[tuple[Kind, str, str]] = Counter()
    for item in sorted(shown, key=_is_of_a_library):
        of = f"{item.of}: " if item.of else ""
        reason = f": {item.reason}" if item.reason else ""
        hidden = [
            counted(inside[item.of, item.label, kind], kind)
            for kind in Kind
            if item.kind is Kind.STATES and inside[item.of, item.label, kind]
        ]
        behind = f", with {', '.join(hidden)} inside" if hidden else ""
        place = "" if item.span is None else f"  {item.span}"
        text = f"  {_SINGULAR[item.kind]:10} {of}{_cut(item.name)}{reason}{behind}"
        lines[item.kind, text, place] += 1
    most = _MOST[status]
    for (_, text, place), count in islice(lines.items(), most):
        yield f"{text}{f', in {count} instances' if count > 1 else ''}{place}"
    left: Counter[Kind] = Counter()
    for (kind, _, _), count in islice(lines.items(), most, None):
        left[kind] += count
    if left:
        yield f"  ... and {', '.join(counted(left[kind], kind) for kind in Kind if left[kind])} (all: --json)"
    for (kind, reason), count in alike.items():
        yield f"  {counted(count, kind)}: {reason}"


_MOST = {Status.MISSED: 20, Status.NEVER: 10, Status.UNMEASURED: 10}
"""So many lines of each list are shown."""


def _is_of_a_library(item: Item) -> bool:
    return item.span is not None and item.span.source.path.startswith("<")


def _missed_around(item: Item, missed: Collection[tuple[str, str]]) -> str | None:
    """The outermost missed state that a state, transition or condition is inside of."""
    if not item.label:
        return None
    parts = item.label.split(".")
    last = len(parts) if item.kind is Kind.STATES else len(parts) + 1
    around = (".".join(parts[:end]) for end in range(1, last))
    return next((label for label in around if (item.of, label) in missed), None)


def counted(count: int, kind: Kind) -> str:
    """A number of items of a kind."""
    return f"{count} {_SINGULAR[kind] if count == 1 else kind}"


_SINGULAR = {
    Kind.GOALS: "goal",
    Kind.USE_CASES: "use case",
    Kind.FORMULAS: "formula",
    Kind.STATES: "state",
    Kind.TRANSITIONS: "transition",
    Kind.CONDITIONS: "condition",
    Kind.OUTCOMES: "outcome",
}


def _cut(text: str) -> str:
    return text if len(text) <= _WIDEST else f"{text[: _WIDEST - 1]}…"


def data(coverage: Coverage) -> dict[str, object]:
    """The coverage for programs: the shares by kind, then every item."""
    return {
        "system": coverage.system,
        "scenarios": coverage.scenarios,
        "traces": coverage.traces,
        "notes": list(coverage.notes),
        "shares": {_key(kind): _share(coverage.share(kind)) for kind in Kind},
        "items": [
            {
                "kind": _SINGULAR[item.kind],
                "of": item.of,
                "name": item.name,
                "status": str(item.status),
                "times": item.times,
                "reason": item.reason,
                "label": item.label,
                "number": item.number,
                "place": "" if item.span is None else str(item.span),
            }
            for item in coverage.items
        ],
    }


def _share(share: Share) -> dict[str, object]:
    return {
        "covered": share.covered,
        "total": share.total,
        "percent": None if share.percent is None else round(share.percent, 2),
        "never": share.never,
        "not_measured": share.unmeasured,
    }


def _key(kind: Kind) -> str:
    return kind.replace(" ", "_")


def below(coverage: Coverage, wanted: Iterable[tuple[Kind, float]]) -> Iterator[str]:
    """What is covered too little, in words."""
    for kind, least in wanted:
        share = coverage.share(kind)
        if share.percent is None:
            yield f"{kind} were not measured, but {least:g}% of them are wanted"
        elif share.percent < least:
            yield f"{share.percent:.1f}% of the {kind} are covered, but {least:g}% are wanted"


def kind_of(word: str) -> Kind | None:
    """A kind by the word for it, as an option has it."""
    found = word.strip().lower().replace("-", " ").replace("_", " ")
    return next((kind for kind in Kind if kind == found), None)


__all__ = ["below", "counted", "data", "kind_of", "lines", "origin", "percent_text"]
