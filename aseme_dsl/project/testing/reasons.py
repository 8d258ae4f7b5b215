"""Reasons: why an expectation is broken, in a sentence."""

from __future__ import annotations

import re
from typing import assert_never

from aseme_dsl.play.run import Played
from aseme_dsl.play.scenario import Breached, Condition, Expectation, Failed, Faulty, InPlaces, Script
from aseme_dsl.runtime.chart.board import NEVER
from aseme_dsl.runtime.monitor.rules import (
    AfterFirst,
    Always,
    At,
    Before,
    InOrder,
    LeadsTo,
    Never,
    NotWithin,
    Sometime,
    Until,
)
from aseme_dsl.runtime.time.clock import readable, shown
from aseme_dsl.source import Span

_LONG = 80
"""A longer condition is cut off (characters)."""


def broken(item: Expectation, script: Script, run: Played) -> str:
    """Why an expectation was broken in a run: what has not come, what came, what was not so, and when."""
    end = readable(run.end)
    parts = [_text(part, item, script) for part in item.parts]
    first, last = (parts[0], parts[-1]) if parts else ("what it speaks of", "what has to follow")
    said = "; ".join(filter(None, (run.near, run.read)))
    so = f": {said}" if said else ""
    match item.rule:
        case Never(condition=condition) if isinstance(script.conditions[condition], Failed):
            name, why = next(iter(run.failures.items()))
            return f"{name} has failed at {end}: {why}"
        case Never(condition=condition) if isinstance(script.conditions[condition], Faulty):
            return f"a fault at {end}: {run.faults[-1]}"
        case Never(condition=condition) if isinstance(script.conditions[condition], Breached):
            return run.read
        case Never(condition=condition) if _is_count(script.conditions[condition]):
            return f"too many at once at {end}{so}"
        case InOrder(conditions=(_, _, *_)):
            return _not_in_order(item, script, run)
        case Sometime(since=since, until=until):
            span = f"from {shown(since)} to {shown(until)}" if since else f"by {end}"
            return f"{first} has not come {span}{so}"
        case InOrder():
            return f"{first} has not come by {end}{so}"
        case LeadsTo(within=within):
            when = "" if within is None else f" at {readable(run.end - within)}"
            return f"{first} came{when}, but {last} has not come by {end}{so}"
        case Never(before=before):
            limit = "" if before == NEVER else f", before {shown(before)}"
            return f"{first} came at {end}{limit}{so}"
        case Before():
            return f"{last} came at {end}, but {first} had not come{so}"
        case NotWithin(within=within):
            return f"{last} came at {end}, less than {shown(within)} after {first}{so}"
        case AfterFirst(after=after):
            return f"{last} is not so at {end}, {shown(after)} after {first}{so}"
        case Until():
            return f"{first} is not so at {end}, and {last} has not come{so}"
        case At() | Always():
            return f"{first} is not so at {end}{so}"
        case _:
            assert_never(item.rule)


def _not_in_order(item: Expectation, script: Script, run: Played) -> str:
    """Which part of an order is missing, and when that before it came."""
    assert run.broken is not None
    stage = run.states[run.broken].stage
    texts = [_text(part, item, script) for part in item.parts]
    missing = f"{texts[stage]} (part {stage + 1} of {len(texts)}) has not come by {readable(run.end)}"
    assert isinstance(item.rule, InOrder)
    early = run.came.get(item.rule.conditions[stage])
    told = [f"it came at {readable(early)}, too early"] if early is not None else []
    near = "; ".join([*told, *([run.near] if run.near else [])])
    near = f": {near}" if near else ""
    if not stage:
        return f"{missing}{near}"
    came = run.reached.get(run.broken, 0)
    return f"{missing}{near}; the part before, {texts[stage - 1]}, came at {readable(came)}"


def _text(part: Span, item: Expectation, script: Script) -> str:
    """A condition as the file has it, with what the row of a table gives the columns."""
    begin = item.span.start + len("every") if isinstance(item.rule, LeadsTo) else item.span.start
    which = re.search(r"\b(some|every|any)\s+$", part.source.text[begin : part.start])
    said = " ".join([which[1] if which is not None else "", *part.text.split()]).strip()
    for name, cell in script.cells.items():
        said = re.sub(rf"(?<![\w.])(?<!\w\s=\s){re.escape(name)}(?![\w.])", cell, said)
    return f"`{said if len(said) <= _LONG else f'{said[: _LONG - 1]}…'}`"


def _is_count(condition: Condition) -> bool:
    return isinstance(condition, InPlaces) and condition.least > 1


__all__ = ["broken"]
