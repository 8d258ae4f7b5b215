"""The report of a bench: Markdown for people."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.project.studying.bench import Bench, Measured
from aseme_dsl.project.studying.table import table


def markdown(found: Bench, plot: str | None = None) -> str:
    """The report; with the picture that lies at `plot`, seen from it."""
    if found.traces:
        origin = f"Inputs from {', '.join(found.traces)}"
    else:
        origin = f"Seed {found.seed}"
    lines = [
        f"# {found.system}",
        "",
        f"{origin}; the code of all agents is imported in {found.load:.1f} ms of CPU. Times are CPU"
        " time of one thread, medians of interleaved rounds.",
        "",
        *([f"![CPU time of a step, by role]({plot})", ""] if plot is not None else []),
        *table(
            ("role", "states", "regions", "steps", "inputs", "activities started", "transitions taken"),
            [_reached(item) for item in found.roles],
            1,
        ),
        "",
        *table(
            ("role", "run as", "step, ns", "of the agent's", "idle tick, ns", "memory, bytes"),
            [row for item in found.roles for row in _rows(item, recorded=bool(found.traces))],
            2,
        ),
    ]
    notes = [f"- {problem}" for problem in found.problems]
    notes += [note for item in found.roles for note in _notes(item, several=len(found.traces) > 1)]
    if any(item.refused for item in found.roles):
        notes.append("- Where in the file that is, `asemec build --backend plain` says.")
    return "\n".join([*lines, *([""] if notes else []), *notes]) + "\n"


def _reached(item: Measured) -> tuple[str, ...]:
    """How large a role is, and how much of it the inputs have reached."""
    visited, taken = f"{item.visited} of {item.activities}", f"{item.taken} of {item.transitions}"
    return item.role, *map(str, (item.states, item.regions, item.steps, item.inputs)), visited, taken


def _rows(item: Measured, *, recorded: bool) -> Iterator[tuple[str, ...]]:
    if not item.ways:
        yield item.role, "not in the trace" if recorded else "nothing that it could take", "", "", "", ""
    for name, timed in item.ways.items():
        share = f"{timed.step / item.ways['agent'].step:.2f}"
        yield item.role, name, f"{timed.step:.0f}", share, f"{timed.idle:.0f}", f"{timed.memory:.0f}"


def _notes(item: Measured, *, several: bool) -> Iterator[str]:
    """What has to be said of a role."""
    if item.agents:
        names = [f"{one.agent} ({one.trace})" if several else one.agent for one in item.agents]
        yield f"- The inputs of `{item.role}` are those of {', '.join(names)}."
    for one in item.agents:
        if one.until:
            yield f"- `{item.role}`: {one.agent} is played {_counted(one.steps)} far: {one.until}."
    if item.starts > 1 and not item.agents:
        yield (
            f"- `{item.role}` came to its end before all inputs were played, and was begun"
            f" {item.starts} times. To begin is not timed."
        )
    if item.refused:
        yield f"- `{item.role}` has no plain statechart: {', '.join(item.refused)}."
    if item.one_by_one > item.steps:
        yield (
            f"- `{item.role}`: a plain statechart takes ends of activities and events one by one, in"
            f" {item.one_by_one} steps. The time is that of one step of the agent."
        )
    if item.left_out:
        yield f"- `{item.role}`: the plain statechart goes another way, and is not timed: {item.left_out}."


def _counted(steps: int) -> str:
    return "one step" if steps == 1 else f"{steps} steps"


__all__ = ["markdown"]
