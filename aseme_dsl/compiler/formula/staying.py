"""Staying: `on T` and `exit T`, the lines of control and of charts that lead nowhere."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from aseme_dsl.amola.statechart import TransitionKind
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

STAYING: Mapping[str, TransitionKind] = {"on": TransitionKind.ON, "exit": TransitionKind.EXIT}
"""The verbs of these lines, with what they mean."""


def check_staying(line: tree.Way | tree.StandingWay) -> Iterator[Diagnostic]:
    """What an `on` (E422) or `exit` (E424) line cannot wait for; that it does something (E423)."""
    state = (line.term if isinstance(line, tree.Way) else line.state).span.text
    written, name = line.expression, f"{line.verb} {state}"
    if line.verb.text == "exit":
        if written.events or written.condition is not None or written.when or written.otherwise:
            yield Diagnostic(
                "E424",
                f"`{name}` waits for nothing: it is done whenever `{state}` is left",
                _before_actions(written),
                hint=f"write `{name} : / …`; for a condition of leaving, write it on the way out",
            )
    elif written.otherwise:
        yield Diagnostic(
            "E422",
            f"`{name}` has no `else`: nothing is chosen here",
            _before_actions(written),
            hint=f"write when it is done: `{name} : when [ … ] / …`",
        )
    else:
        for event in written.events:
            if isinstance(event, tree.Raised) and event.name.text == "error":
                yield Diagnostic(
                    "E422",
                    f"`{name}` cannot take an `error`: what has failed stays failed until it is left",
                    event.span,
                    hint="take it on a way out: " + _WAYS_OUT[type(line)],
                )
    if not written.actions:
        when = "" if line.verb.text == "exit" else "… "
        yield Diagnostic(
            "E423",
            f"`{name}` does nothing",
            line.span,
            hint=f"write what is done: `{name} : {when}/ light = true`",
        )


_WAYS_OUT: Mapping[type, str] = {
    tree.Way: "`enter …`, `leave …` or `repeat …` with `error`",
    tree.StandingWay: "`0.2 -> 0.3 : error`",
}


def _before_actions(written: tree.TransitionExpression) -> Span:
    """The place of events, `else` and condition."""
    if not written.actions:
        return written.span
    text = written.span.source.text[written.span.start : written.actions[0].span.start]
    end = written.span.start + len(text.rstrip().removesuffix("/").rstrip())
    return Span(written.span.source, written.span.start, max(end, written.span.start))


__all__ = ["STAYING", "check_staying"]
