"""`asemec trace`: summarise, filter or convert traces."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import (
    FilePath,
    check_outputs,
    colour_option,
    json_option,
    moment_of,
    not_in_traces,
    plural,
    print_diagnostics,
    print_json,
    refuse,
    say_unreadable,
    targets_argument,
)
from aseme_dsl.diagnostics import has_errors

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from aseme_dsl.diagnostics import Diagnostic
    from aseme_dsl.project.playing.traces import FileSum, Filter
    from aseme_dsl.runtime.trace.trace_reading import TraceReader

_NANOSECONDS = 1e9


def _kinds(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem[str]]:
    from click.shell_completion import CompletionItem

    from aseme_dsl.project.playing.traces import kinds

    found = kinds().items()
    return [CompletionItem(kind, help=text) for kind, text in found if kind.startswith(incomplete)]


def _known_kinds(
    context: click.Context, parameter: click.Parameter, values: tuple[str, ...]
) -> tuple[str, ...]:
    from aseme_dsl.diagnostics import closest
    from aseme_dsl.project.playing.traces import kinds

    for value in values:
        if value not in kinds():
            near = closest(value, kinds())
            hint = f"Did you mean {near!r}?" if near else f"Record kinds: {', '.join(kinds())}."
            raise click.BadParameter(f"unknown record kind {value!r}. {hint}")
    return values


@click.command(
    short_help="Summarise, filter or convert traces.",
    help="Summarise traces, list their records, or write the records to another file. Filters of one kind are"
    " alternatives; filters of different kinds must all match. TARGET is a trace (JSON Lines or MCAP, or the"
    " TARGET.part of a killed run). A file, a project directory or an output directory stands for the traces"
    " of its last run. Default: the project in the current directory.",
    epilog="Example: asemec trace out/trace.jsonl.gz --lines --agent robot1 --from 12.5s --to 14s",
)
@targets_argument
@click.option("--lines", is_flag=True, help="List the records instead of a summary.")
@click.option("--agent", "agents", multiple=True, metavar="NAME", help="Only records about this agent.")
@click.option(
    "--kind",
    "kinds",
    multiple=True,
    metavar="KIND",
    callback=_known_kinds,
    shell_complete=_kinds,
    help="Only records of this kind: step, activity, message, fault, ...",
)
@click.option(
    "--channel",
    "channels",
    multiple=True,
    metavar="CHANNEL",
    help="Only channels with this name or pattern: 'vision.*'.",
)
@click.option(
    "--state",
    "states",
    multiple=True,
    metavar="STATE",
    help="Only records about this state: a name, a label or an activity.",
)
@click.option("--from", "since", metavar="TIME", callback=moment_of, help="Start of the time range: 12.5s.")
@click.option("--to", "until", metavar="TIME", callback=moment_of, help="End of the time range.")
@click.option(
    "-o",
    "--output",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="Output file: MCAP if it ends in .mcap, else JSON Lines, compressed if it ends in .gz.",
)
@json_option
@colour_option
def command(
    targets: tuple[str, ...],
    lines: bool,
    agents: tuple[str, ...],
    kinds: tuple[str, ...],
    channels: tuple[str, ...],
    states: tuple[str, ...],
    since: int | None,
    until: int | None,
    output: Path | None,
    as_json: bool,
    colour: str,
) -> int:
    """Sum up, list or convert; 1 if a file cannot be read or written, or is not whole."""
    from aseme_dsl.project.playing.traces import Filter
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.runtime.trace.trace_files import TraceError
    from aseme_dsl.runtime.trace.trace_reading import TraceReader

    files, problems = all_traces_of(targets)
    if output is not None and len(files) > 1:
        raise click.UsageError("-o converts one trace: name one.")
    if output is not None and lines:
        raise click.UsageError("-o writes the records to a file, --lines prints them: choose one.")
    if output is not None:
        check_outputs([(output, "trace")], files)
    wanted = Filter(agents, kinds, channels, states, since, until)
    sums: list[FileSum] = []
    print_diagnostics(problems, colour)
    code = int(has_errors(problems))
    if unknown := _unknown_agents(files, agents):
        return refuse(unknown, as_json, colour)
    for number, path in enumerate(files):
        try:
            reader = TraceReader(path)
            if output is not None:
                code = max(code, _convert(reader, wanted, output, as_json, colour))
                continue
            if lines:
                _list(reader, wanted, as_json)
            else:
                sums.append(_sum(reader, wanted))
                if not as_json:
                    click.echo("\n".join(_shown(sums[-1], blank_before=number > 0)))
        except TraceError as problem:
            say_unreadable(problem, path, colour)
            code = 1
            continue
        if reader.problem is not None:
            say_unreadable(reader.problem, reader.path, colour)
            code = 1
    if as_json and not lines and output is None:
        print_json({"traces": sums})
    return code


def _unknown_agents(files: Sequence[Path], agents: Sequence[str]) -> list[Diagnostic]:
    """What is wrong with the agents that are asked for: those that are in no team and that no line names."""
    from aseme_dsl.project.playing.traces import Filter
    from aseme_dsl.runtime.trace.records import agents_of
    from aseme_dsl.runtime.trace.trace_files import TraceError
    from aseme_dsl.runtime.trace.trace_reading import TraceReader

    unknown = list(dict.fromkeys(agents))
    team: dict[str, None] = {}
    for path in files:
        if not unknown:
            return []
        try:
            for line in TraceReader(path):
                if line.number == 1:
                    team.update(dict.fromkeys(agent["name"] for agent in agents_of(line.record)))
                record = line.record
                unknown = [name for name in unknown if name not in team and not Filter((name,)).wants(record)]
                if not unknown:
                    return []
        except TraceError:
            return []  # which is said when it is read once more
    return not_in_traces(unknown, team, files)


def _convert(reader: TraceReader, wanted: Filter, output: Path, as_json: bool, colour: str) -> int:
    from aseme_dsl.project.playing.traces import convert

    number = convert(reader, wanted, output)
    if reader.problem is not None:
        say_unreadable(reader.problem, reader.path, colour)
    if as_json:
        print_json({"file": str(output), "lines": number, "problem": reader.problem})
    else:
        click.echo(f"{output}: {plural(number, 'record')}")
    return int(reader.problem is not None)


def _list(reader: TraceReader, wanted: Filter, as_json: bool) -> None:
    """The lines: as they are, or a table."""
    from aseme_dsl.project.playing.traces import told
    from aseme_dsl.runtime.trace.records import agents_of
    from aseme_dsl.runtime.trace.state_names import StateNames
    from aseme_dsl.runtime.trace.trace_reading import fitting

    width = 5
    names = StateNames()
    for line in reader:
        record = line.record
        with fitting(reader.path, line):
            names.take(record)
            if line.number == 1:
                wanted = wanted.of_run(record)
                width = max([width, *(len(agent["name"]) for agent in agents_of(record))])
            is_wanted = wanted.wants(record)
            text = line.text if as_json or not is_wanted else told(record, names)
        if is_wanted and as_json:
            sys.stdout.write(f"{text}\n")
        elif is_wanted:
            moment = record["time"] / _NANOSECONDS
            start = f"{moment:13.6f}  {record.get('agent', ''):<{width}}  {record['kind']:<12}"
            sys.stdout.write(f"{start}  {text}\n")


def _sum(reader: TraceReader, wanted: Filter) -> FileSum:
    from aseme_dsl.project.playing.traces import FileSum, Summary
    from aseme_dsl.runtime.trace.trace_reading import fitting

    summary = Summary()
    for line in reader:
        if line.number == 1:
            wanted = wanted.of_run(line.record)
            summary.begin(line.record, wanted)
        if wanted.wants(line.record):
            with fitting(reader.path, line):
                summary.add(line.record)
    return FileSum(file=str(reader.path), problem=reader.problem, **summary.result())


def _shown(result: FileSum, blank_before: bool) -> Iterator[str]:
    if blank_before:
        yield ""
    clock = f"started {result['start']}" if result["start"] else "virtual time"
    yield f"{result['file']}: {result['system']}, seed {result['seed']}, {clock}"
    span = f"{_seconds(result['from'])} to {_seconds(result['to'])}, {plural(result['lines'], 'record')}"
    yield f"{span}{f', ended: {reason}' if (reason := result['reason']) else ''}"
    if result["missing"]:
        yield f"{plural(result['missing'], 'record')} missing: the disk was slower than the run"
    yield from _table(
        ("agent", "role", "steps", "activities", "crashes", "faults", "failure"),
        [
            (a["name"], a["role"], a["steps"], a["activities"], a["crashes"], a["faults"], a["error"] or "")
            for a in result["agents"]
        ],
    )
    span_ns = max(1, result["to"] - result["from"])
    yield from _table(
        ("agent", "state", "label", "times", "time", "share"),
        [
            (
                agent["name"],
                state["name"],
                state["label"],
                state["times"],
                _seconds(state["lasted"]),
                f"{state['lasted'] / span_ns:.0%}",
            )
            for agent in result["agents"]
            for state in agent["states"]
        ],
    )
    yield from _table(
        ("channel", "messages", "from"),
        [
            (item["channel"], item["messages"], ", ".join(f"{who} {n}" for who, n in item["from"].items()))
            for item in result["channels"]
        ],
    )
    yield from _table(
        ("protocol", "opened", "joined", "left", "messages"),
        [(p["protocol"], p["open"], p["join"], p["leave"], p["messages"]) for p in result["protocols"]],
    )
    yield from _table(("times", "fault"), [(item["times"], item["reason"]) for item in result["faults"]])


def _table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> Iterator[str]:
    """A table with its head, after a blank line; nothing, if it has no rows. Numbers stand right."""
    if not rows:
        return
    yield ""
    texts = [[str(cell) for cell in row] for row in rows]
    widths = [max(len(row[column]) for row in [list(head), *texts]) for column in range(len(head))]
    right = [_is_number(rows[0][column]) for column in range(len(head))]
    for row in [list(head), *texts]:
        cells = [
            cell.rjust(width) if is_right else cell.ljust(width)
            for cell, width, is_right in zip(row, widths, right, strict=True)
        ]
        yield "  ".join(cells).rstrip()


def _is_number(cell: object) -> bool:
    return isinstance(cell, int) or (isinstance(cell, str) and cell[:1].isdigit() and cell[-1:] in "s%")


def _seconds(moment: int) -> str:
    return f"{moment / _NANOSECONDS:.3f} s"
