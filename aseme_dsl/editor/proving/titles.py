"""Titles: what a verdict is called above the text, and what a counterexample becomes in a file."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from aseme_dsl.editor.proving.proofs import Answer
from aseme_dsl.editor.proving.questions import Question, bare
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.source import Source

LONGEST = 100
"""The largest number of characters of a title."""

_ORDER = ("REFUTED", "UNDECIDED", "PROVED")
_TITLE = re.compile(r'scenario "((?:\\.|[^"\\])*)"')


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
    return f"{said} · {name}{worst.of}: {worst.reason}"


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"


def addition(text: str, scenario: Mapping[str, str]) -> str | None:
    """What a file with a text gets at its end for a counterexample; None if it has that scenario already.

    A title that is in use gets a number. Roles that are there already are not added again.
    """
    case = scenario["text"]
    there = {found[1] for found in _TITLE.finditer(text)}
    found = _TITLE.match(case)
    assert found is not None
    if bare(format_source(Source("case.aseme", case)).text) in bare(text):
        return None
    title, number = found[1], 2
    while title in there:
        title, number = f"{found[1]} {number}", number + 1
    roles = [
        line
        for line in scenario["roles"].splitlines()
        if not re.search(rf"\bsrm\s+{re.escape(line.split()[1])}\b", text)
    ]
    added = "".join(f"{line}\n" for line in roles) + f'scenario "{title}"{case[found.end() :]}'
    between = "\n" if text.endswith("\n") or not text else "\n\n"
    return between + format_source(Source("case.aseme", added)).text


__all__ = ["addition", "running_title", "title_of"]
