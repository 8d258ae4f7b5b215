"""What `asemec why` and `asemec whynot` have in common: a question to a trace, and its answer."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import duration_of
from aseme_dsl.cli.shared import (
    CommandT,
    FilePath,
    colour_option,
    json_option,
    not_in_traces,
    print_diagnostics,
    print_json,
    say_unreadable,
)

if TYPE_CHECKING:
    from aseme_dsl.play.asking.answer import Answer
    from aseme_dsl.play.asking.telling import Said

WHAT_HELP = (
    "WHAT is a state (`Kick`), a transition (`Walk -> Kick`), an agent message (`inform Done`) or a channel"
    " (`team.signal.Pass`). TRACE is a trace, or a file, a project directory or an output directory, which"
    " stands for the trace of its last run. Default: the project in the current directory."
)


def question(command: CommandT) -> CommandT:
    """The arguments and options of a question."""
    at = "Time in the run, such as 12.5s: after all that was done by then."
    depth = "How many times to ask back why another agent has not sent a message.  [default: 1]"
    command = colour_option(json_option(command))
    command = click.option("--depth", type=click.IntRange(0, 9), default=1, metavar="N", help=depth)(command)
    command = click.option("--at", "moment", metavar="TIME", required=True, callback=duration_of, help=at)(
        command
    )
    command = click.argument("trace", required=False, type=FilePath(), metavar="[TRACE]")(command)
    return click.argument("agent", metavar="AGENT")(click.argument("what", metavar="WHAT")(command))


def answer(
    agent: str,
    what: str,
    trace: str | None,
    moment: int,
    depth: int,
    as_json: bool,
    colour: str,
    is_why: bool,
    title: Callable[[Answer], str],
) -> int:
    """Ask, and print the answer; 1 if the trace cannot be read."""
    from aseme_dsl.play.asking.question import NotAsked, goal_of
    from aseme_dsl.play.replay import NotReplayable
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.project.testing.asking import NoSuchAgent, questions
    from aseme_dsl.runtime.time.clock import shown
    from aseme_dsl.runtime.trace.trace_files import TraceError

    files, problems = all_traces_of(() if trace is None else (trace,))
    print_diagnostics(problems, colour)
    if problems or not files:
        return 1
    own = f"trace.{agent}.jsonl"  # where each agent had a process of its own
    path = next((item for item in files if item.name.startswith(own)), files[0])
    try:
        with questions(path) as trace_asked:
            asking = trace_asked.at(agent, moment, depth)
            goal = goal_of(asking.teller.plan, what)
            found = trace_asked.why(agent, moment, goal, depth) if is_why else asking.whynot(goal)
            where = asking.where(goal)
            now = asking.moment.now
    except NoSuchAgent as problem:
        print_diagnostics(not_in_traces([agent], problem.team, [path]), colour)
        return 1
    except NotAsked as problem:
        raise click.UsageError(f"{problem}.") from problem
    except NotReplayable as problem:
        say_unreadable(f"{path} cannot be replayed: {problem}", path, colour)
        return 1
    except TraceError as problem:
        say_unreadable(problem, path, colour)
        return 1
    if as_json:
        print_json(_as_json(agent, what, now, where, found))
        return 0
    end = "" if now == moment else ", the end of the trace,"
    click.echo(f"at {shown(now)}{end} {agent} {where}")
    click.echo(title(found))
    for line in lines(found.said, 1):
        click.echo(line)
    return 0


def lines(said: Sequence[Said], depth: int) -> Iterator[str]:
    """What is said, with what explains it indented."""
    for item in said:
        yield f"{'  ' * depth}{item.text}"
        yield from lines(item.inside, depth + 1)


def _as_json(agent: str, what: str, now: int, where: str, found: Answer) -> dict[str, object]:
    return {
        "format": 1,
        "agent": agent,
        "what": what,
        "time_ns": now,
        "where": where,
        "is_so": found.is_so,
        "said": [_said(item) for item in found.said],
    }


def _said(item: Said) -> dict[str, object]:
    return {"text": item.text, "inside": [_said(inner) for inner in item.inside]}
