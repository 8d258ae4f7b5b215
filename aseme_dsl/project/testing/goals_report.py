"""The goals of a system in words, for people, and as data, for programs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aseme_dsl.play.coverage.goals import Goals, GoalSum, Named


def lines(found: Goals) -> Iterator[str]:
    """Each goal with what serves it, then what dangles."""
    yield f"{_counted(len(found.goals), 'goal')} of {found.system}"
    for goal in found.goals:
        yield ""
        yield f"{goal.name} ({goal.actor}){f': {goal.text}' if goal.text else ''}  {goal.span}"
        yield from _rows("use case", goal.use_cases)
        yield from _rows("formula", goal.formulas)
        yield from _rows("state", goal.states)
        yield from _rows("scenario", goal.scenarios)
        if found.runs:
            yield f"  {_reached(goal, found)}"
    if found.dangling:
        yield ""
        yield "dangling"
    for item in found.dangling:
        of = f"{item.item.of}: " if item.item.of else ""
        place = "" if item.item.span is None else f"  {item.item.span}"
        yield f"  {item.kind:9} {of}{item.item.name}: {item.reason}{place}"


def _rows(word: str, items: Sequence[Named]) -> Iterator[str]:
    for item in items:
        of = f"{item.of}: " if item.of else ""
        yield f"  {word:9} {of}{item.name}  {item.span}"


def _reached(goal: GoalSum, found: Goals) -> str:
    """A file of coverage says of all its scenarios and traces together what they have reached."""
    if not goal.times:
        return f"never reached in {_counted(found.played, 'run')}"
    times = "once" if goal.times == 1 else f"{goal.times} times"
    if found.played == found.runs:
        return f"reached {times}, in {goal.runs} of {_counted(found.runs, 'run')}"
    return f"reached {times}, in {goal.runs} of {_counted(found.runs, 'file')} with {found.played} runs"


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def data(found: Goals) -> dict[str, object]:
    """The goals for programs."""
    return {
        "system": found.system,
        "runs": found.runs,
        "played": found.played,
        "goals": [
            {
                "name": goal.name,
                "actor": goal.actor,
                "text": goal.text,
                "place": str(goal.span),
                "use_cases": [_data(item) for item in goal.use_cases],
                "formulas": [_data(item) for item in goal.formulas],
                "states": [_data(item) for item in goal.states],
                "scenarios": [_data(item) for item in goal.scenarios],
                "times": goal.times,
                "runs": goal.runs,
            }
            for goal in found.goals
        ],
        "dangling": [
            {"kind": item.kind, **_data(item.item), "reason": item.reason} for item in found.dangling
        ],
    }


def _data(item: Named) -> dict[str, str]:
    return {"of": item.of, "name": item.name, "place": "" if item.span is None else str(item.span)}


__all__ = ["data", "lines"]
