"""Shrinking: a failure with fewer stimuli and smaller values, and the scenario that it is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from aseme_dsl.play.run import Played
from aseme_dsl.play.scenario import Receives, Scenario, Script, Stimulus
from aseme_dsl.play.sight.deciding import agents_about
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.monitor.rules import AfterFirst, At, InOrder, LeadsTo, Sometime, conditions_of
from aseme_dsl.source import Span

MOST = 500
"""So many runs are made for one failure at the most."""

Run = Callable[[Script, Mapping[str, object]], Played | None]
"""Plays a script with inputs; None if it cannot be played."""


@dataclass(frozen=True, slots=True)
class Shrunk:
    """A smaller run in which the same expectation is broken, and the stimuli that it does not need."""

    run: Played
    script: Script
    inputs: Mapping[str, object]
    dropped: tuple[Span, ...]


def shrunk(script: Script, inputs: Mapping[str, object], found: Played, play: Run) -> Shrunk:
    """Drop stimuli one by one, then move the values towards 0, as long as the same expectation is broken.

    What has not come does not come without stimuli, either. So such a failure is the same only if the agents
    end in the same states. What the agents in question know when it is broken, or have acted on, is kept: who
    reads the smaller run would miss it.
    """
    left = MOST

    def fails(smaller: Script, values: Mapping[str, object]) -> Played | None:
        nonlocal left
        left -= 1
        run = play(smaller, values) if left >= 0 else None
        is_same = run is not None and run.broken == found.broken
        return run if is_same and run is not None and run.assumption == found.assumption else None

    # `by T` counts from a stimulus, which the text needs then.
    needed = {item.rule.since for item in script.expectations if isinstance(item.rule, Sometime)}
    best = found
    dropped: list[Span] = []
    known = _known(script, found) if _is_awaited(script, found) else ()
    for item in script.stimuli:
        if (item.trigger is None and item.moment in needed) or item in known:
            continue
        smaller = replace(script, stimuli=tuple(other for other in script.stimuli if other is not item))
        run = fails(smaller, inputs)
        if (
            run is not None
            and _is_alike(run, found)
            and (not _is_awaited(script, found) or _as_far(run, found))
        ):
            script, best = smaller, run
            dropped.append(item.span)
    values = dict(inputs)
    for given in script.inputs:
        passing, failing = min(max(0, given.least), given.most), values[given.name]
        assert isinstance(failing, int | float)
        tried = int(passing) if given.is_whole else passing
        while abs(failing - passing) >= (1 if given.is_whole else 1e-3):
            run = fails(script, {**values, given.name: tried})
            if run is None:
                passing = tried
            else:
                values[given.name], best, failing = tried, run, tried
            tried = _between(passing, failing, given.is_whole)
            if tried in (passing, failing):
                break
    return Shrunk(best, script, values, tuple(dropped))


def _known(script: Script, run: Played) -> tuple[Stimulus, ...]:
    """The stimuli of which the agents may still know something that the broken expectation is about.

    These are all but a message that a later one has replaced, on a channel without a history.
    """
    assert run.broken is not None
    agents = agents_about(script.conditions, conditions_of(script.expectations[run.broken].rule))
    found: list[Stimulus] = []
    later: set[tuple[str, str]] = set()
    for item in sorted(script.stimuli, key=lambda item: -item.moment):
        act = item.act
        is_about = agents is None or act.agent in agents
        if not is_about or item.moment > run.end:
            continue
        is_plain = isinstance(act, Receives) and act.content.performative is None and item.trigger is None
        if not isinstance(act, Receives) or not is_plain or ".data." in act.content.channel:
            found.append(item)
        elif (key := (act.agent, act.content.channel)) not in later:
            later.add(key)
            found.append(item)
    return tuple(found)


def _is_awaited(script: Script, run: Played) -> bool:
    """Whether the expectation is broken because something has not come."""
    assert run.broken is not None
    rule = script.expectations[run.broken].rule
    return isinstance(rule, Sometime | At | AfterFirst | InOrder | LeadsTo)


def _is_alike(run: Played, found: Played) -> bool:
    """Whether the expectation is broken by the same: what it reads, what came instead, who failed and why."""
    return (run.read, run.near, run.failures) == (found.read, found.near, found.failures)


def _as_far(run: Played, found: Played) -> bool:
    """Whether a run has come as far as another one."""
    assert found.broken is not None
    stages = (each.states[found.broken].stage for each in (run, found))
    return len(set(stages)) == 1 and run.ends == found.ends


def _between(one: float, other: float, is_whole: bool) -> float:
    middle = (one + other) / 2
    return int(middle) if is_whole else middle


def text_of(scenario: Scenario, script: Script, case: Shrunk, seed: int) -> str:
    """The scenario of the smaller run: without what it does not need, with its values in a table."""
    edits = [(span, "") for span in case.dropped]
    names = ", ".join(item.name for item in script.inputs)
    values = ", ".join(_written(case.inputs[item.name], item.span) for item in script.inputs)
    for place, item in enumerate(script.inputs):
        edits.append((item.span, "" if place else f"table ({names}) {{ ({values}) }}"))
    block = scenario.block
    assert block is not None  # it was played
    text, end = "", block.start
    for span, new in sorted(edits, key=lambda edit: edit[0].start):
        text += block.source.text[end : span.start] + new
        end = span.end
    text += block.source.text[end : block.end]
    title = scenario.span.text
    begun = scenario.span.start - block.start
    text = f'{text[:begun]}{title[:-1]}, shrunk"{text[begun + len(title) :]}'
    lines = [line for line in text.split("\n") if line.strip()]
    return f"// fails with seed {seed}\n" + "\n".join(lines) + "\n"


def _written(value: object, span: Span) -> str:
    """A value as the file writes it; that of a range of durations is in ns."""
    is_duration = span.text.rstrip().endswith("s") or span.text.rstrip().endswith("min")
    return f"{float(str(value)) / 1e6:.6f}".rstrip("0").rstrip(".") + "ms" if is_duration else str(value)


__all__ = ["Shrunk", "shrunk", "text_of"]
