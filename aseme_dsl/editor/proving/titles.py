"""Titles: what a verdict is called above the text."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.editor.proving.proofs import Answer
from aseme_dsl.editor.proving.questions import Question

LONGEST = 100
"""The largest number of characters of a title."""

_ORDER = ("REFUTED", "UNDECIDED", "PROVED")


def title_of(question: Question, answers: Sequence[Answer], problem: str, is_current: bool) -> str:
    """The title of a question that nothing runs for."""
    ask = "prove all" if question.key == "all" else "prove"
    if problem:
        return _cut(f"{ask} · not proved: {problem}")
    if not answers:
        return ask
    text = _verdicts(answers)
    return _cut(text if is_current else f"changed since · {text}")


def running_title(seconds: float) -> str:
    """The title while a question is being answered."""
    return f"proving … ({seconds:.0f} s)"


def _verdicts(answers: Sequence[Answer]) -> str:
    worst = min(answers, key=lambda item: _ORDER.index(item.verdict))
    if len(answers) == 1:
        return f"{worst.verdict} · {worst.reason or worst.bounds}"
    counts = [(verdict, sum(item.verdict == verdict for item in answers)) for verdict in _ORDER]
    said = ", ".join(f"{count} {verdict}" for verdict, count in counts if count)
    if worst.verdict == "PROVED":
        return f"{said} · {worst.bounds}" if len({item.of for item in answers}) == 1 else said
    name = "" if len({item.name for item in answers}) == 1 else f"{worst.name} of "
    return f"{said} · {name}{worst.of}" + (f": {worst.reason}" if worst.reason else "")


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"


__all__ = ["running_title", "title_of"]
