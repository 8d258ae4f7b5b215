"""What `asemec why` and `asemec whynot` have in common: a question to a trace, and its answer."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import duration_of
from aseme_dsl.cli.replay import difference_lines
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
    from aseme_dsl.play.asking.question import Question
    from aseme_dsl.play.asking.said import Said

Title = Callable[["Question", str | None, "Answer"], str]
"""What stands above an answer; it is given the trace as it was written."""

DEPTH = 4
"""`play.asking.question.DEPTH`, which takes long to import."""

WHAT_HELP = (
    "WHAT is a state (`Kick`), a transition (`Walk -> Kick`), an agent message (`inform Done`) or a channel"
    " (`team.signal.Pass`). TRACE is a trace, or a file, a project directory or an output directory, which"
    " stands for the trace of its last run. Default: the project in the current directory."
)


def question(command: CommandT) -> CommandT:
    """The arguments and options of a question."""
    at = "Time in the run, such as 12.5s: after all that was done by then."
    depth = f"How many agents to ask, one for another, why a message was not sent.  [default: {DEPTH}]"
    command = colour_option(json_option(command))
    command = click.option("--depth", type=click.IntRange(0, 9), default=DEPTH, metavar="N", help=depth)(
        command
    )
    command = click.option("--at", "moment", metavar="TIME", required=True, callback=duration_of, help=at)(
        command
    )
    command = click.argument("trace", required=False, type=FilePath(), metavar="[TRACE]")(command)
    return click.argument("agent", metavar="AGENT")(click.argument("what", metavar="WHAT")(command))


def answer(asked: Question, trace: str | None, as_json: bool, colour: str, title: Title) -> int:
    """Ask, and print the answer; 1 if the trace cannot be read."""
    from aseme_dsl.play.asking.question import NotAsked
    from aseme_dsl.play.replay import NotReplayable
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.project.testing.asking import Differs, NoSuchAgent, questions
    from aseme_dsl.runtime.time.clock import shown
    from aseme_dsl.runtime.trace.trace_files import TraceError

    files, problems = all_traces_of(() if trace is None else (trace,))
    print_diagnostics(problems, colour)
    if problems or not files:
        return 1
    own = f"trace.{asked.agent}.jsonl"  # where each agent had a process of its own
    path = next((item for item in files if item.name.startswith(own)), files[0])
    try:
        with questions(path) as trace_asked:
            found = trace_asked.answer(asked)
    except NoSuchAgent as problem:
        print_diagnostics(not_in_traces([asked.agent], problem.team, [path]), colour)
        return 1
    except NotAsked as problem:
        raise click.UsageError(f"{problem}.") from problem
    except NotReplayable as problem:
        say_unreadable(f"{path} cannot be replayed: {problem}", path, colour)
        return 1
    except Differs as problem:
        text = f"{path} gives no sure answer: its replay differs from what was recorded"
        say_unreadable("\n".join((text, *difference_lines(problem.difference))), path, colour)
        return 1
    except TraceError as problem:
        say_unreadable(problem, path, colour)
        return 1
    if as_json:
        print_json(_as_json(asked, found))
        return 0
    end = "" if found.now == asked.at else ", the end of the trace,"
    click.echo(f"at {shown(found.now)}{end} {asked.agent} {found.where}")
    click.echo(title(asked, trace, found))
    for line in lines(found.said, 1):
        click.echo(line)
    return 0


def lines(said: Sequence[Said], depth: int) -> Iterator[str]:
    """What is said, with what explains it indented."""
    for item in said:
        yield f"{'  ' * depth}{item.text}"
        yield from lines(item.inside, depth + 1)


def _as_json(asked: Question, found: Answer) -> dict[str, object]:
    return {
        "format": 1,
        "agent": asked.agent,
        "what": asked.what,
        "time_ns": found.now,
        "where": found.where,
        "is_so": found.is_so,
        "said": [_said(item) for item in found.said],
    }


def _said(item: Said) -> dict[str, object]:
    return {"text": item.text, "inside": [_said(inner) for inner in item.inside]}
