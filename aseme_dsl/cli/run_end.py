"""The end of a run on a terminal: its exit code, its JSON and what it left open."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import CommandT
from aseme_dsl.cli.terminal import harmless

if TYPE_CHECKING:
    from aseme_dsl.project.testing.watching import Watched
    from aseme_dsl.runtime.team.team import RunResult

WAITING = "waiting"
"""What `--allow` accepts: agents that nothing pending can wake are not a failure of the run."""


def allow_option(command: CommandT) -> CommandT:
    """`--allow waiting`."""
    text = "Exit with 0 even if agents are idle or in a deadlock."
    return click.option("--allow", "allowed", type=click.Choice([WAITING]), multiple=True, help=text)(command)


def exit_code(result: RunResult, allowed: Iterable[str], interrupted: int) -> int:
    """The exit code of a run: 1 if an agent has failed or waits for ever, or the trace is not whole."""
    if result.reason == "interrupted":
        return interrupted
    stuck = result.stuck and WAITING not in allowed
    return int(bool(result.failed or stuck or result.trace_error is not None))


def end_data(result: RunResult) -> dict[str, object]:
    """What a run left open, and its faults, as JSON."""
    from dataclasses import asdict

    return {
        "idle_since": result.idle_since,
        "stuck": list(result.stuck),
        "idle": [agent.name for agent in result.agents if agent.idle],
        "conversations": [asdict(item) for item in result.conversations],
        "unread": [asdict(item) for item in result.unread],
        "fault_kinds": [asdict(item) for item in result.faults],
    }


def end_lines(result: RunResult) -> Iterator[str]:
    """What to say about the end of a run besides its time; nothing about one that left nothing open."""
    from aseme_dsl.project.playing.run_end import end_lines

    return map(harmless, end_lines(result))


def watched_data(watched: Iterable[Watched]) -> list[dict[str, object]]:
    """What has become of the properties and clauses, as JSON."""
    return [
        {"of": item.of, "at": str(item.span), "verdict": item.verdict, "time_ns": item.time_ns}
        for item in watched
    ]


def watched_lines(watched: Sequence[Watched]) -> Iterator[str]:
    """What to say of properties and clauses at the end of a run."""
    for item in watched:
        if item.verdict != "kept":
            yield harmless(item.text)
    if kept := sum(item.verdict == "kept" for item in watched):
        yield f"{kept} of {len(watched)} statements of properties and clauses are kept"
