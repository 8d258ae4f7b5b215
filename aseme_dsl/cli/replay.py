"""`asemec replay`: make the steps of a recorded run again, and show the first difference."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.run_end import watched_data, watched_lines
from aseme_dsl.cli.shared import (
    colour_option,
    json_option,
    plural,
    print_diagnostics,
    print_json,
    say_unreadable,
    targets_argument,
)

if TYPE_CHECKING:
    from aseme_dsl.play.replay import Difference
    from aseme_dsl.project.testing.replaying import Replayed


@click.command(
    short_help="Make the steps of a recorded run again.",
    help="Make each step of a trace again, with the model that the trace has in it, and compare it with what"
    " was recorded. The first difference is shown. Properties and clauses are watched. TARGET is a trace"
    " (JSON Lines or MCAP). A file, a project directory or an output directory stands for the traces of its"
    " last run. Default: the project in the current directory.",
    epilog="Example: asemec replay out/trace.jsonl.gz --agent robot1",
)
@targets_argument
@click.option(
    "--agent", "agents", multiple=True, metavar="NAME", help="Only the steps of this agent. Repeatable."
)
@json_option
@colour_option
def command(targets: tuple[str, ...], agents: tuple[str, ...], as_json: bool, colour: str) -> int:
    """Replay; 1 if there is a difference, or a trace cannot be replayed."""
    from aseme_dsl.play.replay import NotReplayable
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.project.testing.replaying import replay
    from aseme_dsl.runtime.trace.trace_files import TraceError

    files, problems = all_traces_of(targets)
    print_diagnostics(problems, colour)
    code = int(bool(problems))
    found: list[Replayed] = []
    for path in files:
        try:
            found.append(replay(path, agents))
        except NotReplayable as problem:
            say_unreadable(f"{path} cannot be replayed: {problem}", path, colour)
            code = 1
        except TraceError as problem:
            say_unreadable(problem, path, colour)
            code = 1
        else:
            item = found[-1]
            is_broken = any(one.verdict == "broken" for one in item.watched)
            code |= int(item.difference is not None or item.problem is not None or is_broken)
            if not as_json:
                _show(found[-1], colour)
    if as_json:
        print_json({"format": 1, "traces": [_as_json(item) for item in found]})
    return code


def _show(item: Replayed, colour: str) -> None:
    if item.problem is not None:
        say_unreadable(item.problem, item.path, colour)
    found = item.difference
    who = f"{plural(item.steps, 'step')} of {', '.join(item.agents) or 'no agent'}"
    if found is None:
        click.echo(f"{item.path}: {who}: no difference")
    else:
        click.echo(f"{item.path}: {who}, up to a difference")
        for line in difference_lines(found):
            click.echo(line)
    for line in (*watched_lines(item.watched), *([item.unwatched] if item.unwatched else [])):
        click.echo(f"  {line}")


def difference_lines(found: Difference) -> tuple[str, ...]:
    """Where a replay differs, in words."""
    from aseme_dsl.runtime.time.clock import shown

    return (
        f"  {found.agent}, step {found.step} at {shown(found.time)}: {found.what}",
        f"    recorded: {'; '.join(found.expected) or 'none'}",
        f"    replayed: {'; '.join(found.got) or 'none'}",
    )


def _as_json(item: Replayed) -> dict[str, object]:
    found = item.difference
    difference = None
    if found is not None:
        difference = {
            "agent": found.agent,
            "time_ns": found.time,
            "step": found.step,
            "what": found.what,
            "recorded": list(found.expected),
            "replayed": list(found.got),
        }
    return {
        "trace": str(item.path),
        "agents": list(item.agents),
        "steps": item.steps,
        "difference": difference,
        "problem": item.problem,
        "watched": watched_data(item.watched),
    }
