"""`asemec observe`: whether the log of a run keeps the properties, clauses and protocols of a model."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import time_limit_of
from aseme_dsl.cli.shared import (
    FilePath,
    check_outputs,
    colour_option,
    folder_option,
    json_option,
    one_system,
    plural,
    print_diagnostics,
    print_json,
    refuse,
    refuse_unreadable,
    say_unreadable,
    targets_argument,
)
from aseme_dsl.cli.terminal import harmless
from aseme_dsl.diagnostics import Severity, has_errors

if TYPE_CHECKING:
    from aseme_dsl.project.observing.session import Observed, Session
    from aseme_dsl.project.observing.statements import Statement
    from aseme_dsl.project.observing.talks import Deviation, ProtocolSum

_WIDE = 10
"""The width of the verdicts."""


@click.command(
    short_help="Check the log of a run against the model.",
    help="Check whether the log of a run keeps the properties, clauses and protocols of its model. No step is"
    " made again, so that logs of other programs are checked, too. TARGET is a trace (JSON Lines or MCAP), or"
    " a log of agent messages (JSON Lines). A file, a project directory or an output directory stands for the"
    " traces of its last run. Several are the processes of one run. Default: the project in the current"
    " directory.",
    epilog="Example: asemec observe out   ·   asemec observe robots.jsonl --model team.aseme",
)
@targets_argument
@click.option(
    "--model",
    type=FilePath(),
    metavar="PATH",
    help="File or project to check against.  [default: the model in the trace]",
)
@click.option("--live", is_flag=True, help="Follow a run in progress, until it ends or Ctrl-C.")
@click.option(
    "--for", "duration", metavar="DURATION", callback=time_limit_of, help="With --live: stop after."
)
@click.option(
    "--from-start",
    is_flag=True,
    help="A conversation that seems to have begun before the log is an error.",
)
@folder_option("--stories", text="Directory for a sequence diagram of each story.")
@click.option("--strict", is_flag=True, help="Exit with 1 if something is undecided, or nothing was checked.")
@json_option
@colour_option
def command(
    targets: tuple[str, ...],
    model: str | None,
    live: bool,
    duration: int | None,
    from_start: bool,
    stories: Path | None,
    strict: bool,
    as_json: bool,
    colour: str,
) -> int:
    """Observe; 1 if something is broken, a protocol is not kept, or a log is not whole."""
    from aseme_dsl.play.replay import NotReplayable
    from aseme_dsl.project.observing.model import Model, model_of
    from aseme_dsl.project.observing.observe import observe
    from aseme_dsl.project.observing.session import NoModel, Session, Tell
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.runtime.trace.trace_files import MCAP_SUFFIX, TraceError

    if duration is not None and not live:
        raise click.UsageError("--for requires --live.")
    paths, wrong = all_traces_of(targets, following=live)
    if wrong:
        return refuse(wrong, as_json, colour)
    packed = next((path for path in paths if live and path.suffix == MCAP_SUFFIX), None)
    if packed is not None:
        raise click.UsageError(f"--live cannot follow {packed}: an MCAP file is read when it is complete.")
    given: Model | None = None
    if model is not None:
        compiled = one_system(model)
        found = [item for item in compiled.diagnostics if item.severity is not Severity.NOTE]
        if compiled.system is None or has_errors(found):
            return refuse(found, as_json, colour)
        given = model_of(compiled)
    tell = Tell(_say_statement, _say_deviation) if live and not as_json else Tell()
    session = Session(given, tell, from_start=from_start)
    problems: Sequence[tuple[Path, str]] = ()
    try:
        if live:
            observed, problems = _follow(paths, session, duration)
        else:
            observed, problems = observe(paths, session)
    except NoModel as problem:
        if paths[0].suffix == MCAP_SUFFIX:
            return refuse_unreadable(f"{paths[0]} is not an MCAP file", paths[0], as_json, colour)
        raise click.UsageError(f"{paths[0]} has no model in it: name it with --model FILE.") from problem
    except NotReplayable as problem:
        return refuse_unreadable(f"{paths[0]} cannot be observed: {problem}", paths[0], as_json, colour)
    except TraceError as problem:
        return refuse_unreadable(problem, paths[0], as_json, colour)
    if observed is None:
        return refuse_unreadable(f"no run has begun: {', '.join(map(str, paths))}", paths[0], as_json, colour)
    if as_json:
        print_json(_as_json(observed, paths, problems))
    else:
        _show(observed, paths, with_stories=not live)
    for path, text in problems:
        say_unreadable(text, path, colour)
    code = int(observed.is_broken or bool(problems) or (strict and not observed.is_decided))
    return code if stories is None else max(code, _draw(observed, stories, paths, colour))


def _follow(
    paths: Sequence[Path], session: Session, duration: int | None
) -> tuple[Observed | None, Sequence[tuple[Path, str]]]:
    from aseme_dsl.project.observing.live import Live

    end = None if duration is None else time.monotonic() + duration * 1e-9
    live = Live(paths, session)
    found = live.follow(lambda: end is not None and time.monotonic() > end)
    return found, live.problems


def _draw(observed: Observed, folder: Path, paths: Sequence[Path], colour: str) -> int:
    """Write the sequence diagram of each story; 1 if one cannot be written."""
    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.observing.pictures import drawn

    code = 0
    for name, text in drawn(observed):
        check_outputs([(folder / name, "talk")], paths)
        found = write_file(folder / name, text.encode("utf-8")).diagnostics
        print_diagnostics(found, colour)
        code = max(code, int(has_errors(found)))
    return code


# ---- for people ----------------------------------------------------------------------------------


def _show(observed: Observed, paths: Sequence[Path], *, with_stories: bool) -> None:
    click.echo(f"{', '.join(map(str, paths))}: {plural(observed.events, 'event')}")
    for statement in observed.statements:
        click.echo(harmless(_statement_line(statement)))
        if with_stories:
            _say_story(statement)
    for name, item in sorted(observed.protocols.items()):
        click.echo(harmless(_protocol_line(name, item)))
        if with_stories:
            _say_deviations([one for one in observed.deviations if one.message.protocol == name])
    if not observed.statements and not observed.protocols:
        click.echo("nothing to check: no property, no clause, and no message of a protocol of the model")
    for note in observed.notes:
        click.echo(harmless(f"note: {note}"))


def _statement_line(item: Statement) -> str:
    watched = item.watched
    text = watched.text.removeprefix(watched.verdict).removeprefix(": ").strip()
    return f"{watched.verdict:{_WIDE}} {text}{f': {item.reason}' if item.reason else ''}"


def _say_story(item: Statement) -> None:
    from aseme_dsl.play.sight.story import told

    for line in told(item.story):
        click.echo(harmless(f"    {line}"))


def _say_statement(item: Statement) -> None:
    click.echo(harmless(_statement_line(item)))
    _say_story(item)


def _protocol_line(name: str, item: ProtocolSum) -> str:
    verdict = _verdict(item)
    said = f"{plural(item.conversations, 'conversation')}, {plural(item.messages, 'message')}"
    more = [
        (item.broken, "not kept"),
        (item.from_the_middle, "begun before the log"),
        (item.early, "left early"),
        (item.unchecked, "with too many explanations"),
    ]
    parts = "".join(f", {number} {what}" for number, what in more if number)
    return f"{verdict:{_WIDE}} protocol {name}: {said}{parts}"


def _verdict(item: ProtocolSum) -> str:
    if item.broken:
        return "broken"
    return "undecided" if item.from_the_middle + item.unchecked >= item.conversations else "kept"


def _say_deviations(items: Sequence[Deviation]) -> None:
    """The first one with its story, the others in a line each."""
    for number, item in enumerate(items):
        for line in _deviation_lines(item) if number == 0 else [_deviation_line(item)]:
            click.echo(harmless(f"  {line}"))


def _say_deviation(item: Deviation) -> None:
    click.echo(f"{'broken':{_WIDE}} protocol {harmless(item.message.protocol)}:")
    for line in _deviation_lines(item):
        click.echo(harmless(f"  {line}"))


def _deviation_lines(item: Deviation) -> Iterator[str]:
    from aseme_dsl.project.observing.pictures import lines_of

    yield _deviation_line(item)
    yield item.instead
    for line in lines_of(item):
        yield f"  {line}"


def _deviation_line(item: Deviation) -> str:
    from aseme_dsl.runtime.time.clock import shown

    return f"at {shown(item.message.moment)} in {item.message.conversation}: {item.text} ({item.span})"


# ---- for programs --------------------------------------------------------------------------------


def _as_json(
    observed: Observed, paths: Sequence[Path], problems: Sequence[tuple[Path, str]]
) -> dict[str, object]:
    from aseme_dsl.play.sight.story import told
    from aseme_dsl.project.observing.pictures import lines_of

    return {
        "logs": [str(path) for path in paths],
        "events": observed.events,
        "statements": [
            {
                "of": item.watched.of,
                "at": str(item.watched.span),
                "verdict": item.watched.verdict,
                "time_ns": item.watched.time_ns,
                "reason": item.reason,
                "assumed": None if item.watched.assumed is None else str(item.watched.assumed),
                "story": list(told(item.story)),
            }
            for item in observed.statements
        ],
        "protocols": [
            {
                "protocol": name,
                "verdict": _verdict(item),
                "conversations": item.conversations,
                "messages": item.messages,
                "broken": item.broken,
                "from_the_middle": item.from_the_middle,
                "left_early": item.early,
                "unchecked": item.unchecked,
            }
            for name, item in sorted(observed.protocols.items())
        ],
        "deviations": [
            {
                "protocol": item.message.protocol,
                "conversation": item.message.conversation,
                "time_ns": item.message.moment,
                "agent": item.message.sender,
                "participant": item.part,
                "message": item.message.text,
                "to": list(item.message.to),
                "reason": item.reason,
                "allowed": list(item.allowed),
                "awaited": list(item.awaited),
                "at": str(item.span),
                "story": list(lines_of(item)),
            }
            for item in observed.deviations
        ],
        "notes": list(observed.notes),
        "problems": [problem for _, problem in problems],
    }
