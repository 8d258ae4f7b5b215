"""`asemec sniff`: the agent messages of a run as text, as Mermaid or as a picture."""

from __future__ import annotations

import json
import re
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace
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
    refuse_options,
    say_unreadable,
    targets_argument,
)
from aseme_dsl.diagnostics.problems.running import WithJson
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.diagrams.sequence.sequence import Row, SequenceDiagram
    from aseme_dsl.project.playing.sniff import Wanted
    from aseme_dsl.runtime.trace.records import Record
    from aseme_dsl.runtime.trace.trace_reading import Line

_PAUSE = 0.1
"""Seconds between two looks at a trace that is being written."""
_SUFFIXES = {".svg": "svg", ".mmd": "mermaid", ".mermaid": "mermaid", ".txt": "text"}
_SUFFIX_OF = {"svg": ".svg", "mermaid": ".mmd", "text": ".txt"}


@click.command(
    short_help="Show the agent messages of a run.",
    help="Show the agent messages of a run as text, as a Mermaid sequence diagram or as an SVG picture."
    " Filters of one kind are alternatives; filters of different kinds must all match. TARGET is a trace, a"
    " file, a project directory or an output directory; several are the processes of one run. Default: the"
    " project in the current directory.",
    epilog="Example: asemec sniff out --protocol contract_net -o talk.svg   ·   asemec sniff out --follow",
)
@targets_argument
@click.option("-f", "--follow", is_flag=True, help="Print messages as they are sent, until the run ends.")
@click.option(
    "--conversation",
    "conversations",
    multiple=True,
    metavar="NAME",
    help="Only conversations with this name or pattern: 'auction-*'.",
)
@click.option(
    "--protocol", "protocols", multiple=True, metavar="NAME", help="Only messages of this protocol."
)
@click.option("--agent", "agents", multiple=True, metavar="NAME", help="Only messages to or from this agent.")
@click.option("--from", "since", metavar="TIME", callback=moment_of, help="Start of the time range: 12.5s.")
@click.option("--to", "until", metavar="TIME", callback=moment_of, help="End of the time range.")
@click.option(
    "--format",
    "format_",
    type=click.Choice(["text", "mermaid", "svg"]),
    help="Output format.  [default: by the suffix of the output file, else text]",
)
@click.option(
    "-o",
    "--output",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="Output file: .svg, .mmd or .txt. A long picture continues in FILE-2, FILE-3, …",
)
@click.option("--each", is_flag=True, help="One file per conversation: FILE-CONVERSATION.")
@click.option(
    "--group/--no-group",
    "group",
    default=None,
    help="In diagrams, draw the agents of a role as one lifeline, from three on.  [default: with more than 12"
    " agents]",
)
@click.option(
    "--page",
    type=click.Choice(["a4", "screen"]),
    help="Divide a picture into pages of this size.  [default: pages of 60 rows]",
)
@json_option
@colour_option
def command(
    targets: tuple[str, ...],
    follow: bool,
    conversations: tuple[str, ...],
    protocols: tuple[str, ...],
    agents: tuple[str, ...],
    since: int | None,
    until: int | None,
    format_: str | None,
    output: Path | None,
    each: bool,
    group: bool | None,
    page: str | None,
    as_json: bool,
    colour: str,
) -> int:
    """Show or write; 1 if a trace cannot be read or is not whole."""
    from aseme_dsl.project.playing.sniff import Wanted
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.runtime.trace.trace_files import TraceError

    if as_json and format_ is not None and output is None:
        where = ", ".join(targets) or "."
        return refuse_options([WithJson("--format")], where, as_json, colour)
    format_ = _format(format_, output)
    if each and output is None:
        raise click.UsageError("--each requires -o.")
    if group is not None and format_ == "text":
        raise click.UsageError("--group and --no-group require a diagram: -o FILE.svg or --format mermaid.")
    if page is not None and (format_ != "svg" or output is None):
        raise click.UsageError("--page requires a picture: -o FILE.svg.")
    if follow and (output is not None or format_ != "text"):
        raise click.UsageError("--follow prints text: not with --format or -o.")
    wanted = Wanted(conversations, protocols, agents, since, until)
    paths, problems = all_traces_of(targets, following=follow)
    if problems:
        print_diagnostics(problems, colour)
        return 1
    try:
        if follow:
            return _follow(paths, wanted, as_json, colour)
        return _show(paths, wanted, _Form(format_, output, each, group, page), as_json, colour)
    except TraceError as problem:
        say_unreadable(problem, paths[0], colour)
        return 1


@dataclass(frozen=True, slots=True)
class _Form:
    """How messages are shown: the format and the file, one for each conversation, in groups, in pages."""

    format: str
    output: Path | None
    each: bool
    group: bool | None
    page: str | None


def _format(given: str | None, output: Path | None) -> str:
    if given is not None or output is None:
        return given or "text"
    found = _SUFFIXES.get(output.suffix.lower())
    if found is None:
        raise click.UsageError(f"{output}: unsupported suffix; use .svg, .mmd or .txt.")
    return found


# ---- as it comes ---------------------------------------------------------------------------------


def _follow(paths: Sequence[Path], wanted: Wanted, as_json: bool, colour: str) -> int:
    """Until all runs have ended, or the user interrupts."""
    from aseme_dsl.project.playing.following import RunFollower
    from aseme_dsl.project.playing.sniff import Sniffer, line_of
    from aseme_dsl.runtime.trace.records import agents_of

    traces = RunFollower(paths)
    sniffer = Sniffer(wanted)
    width = 5
    try:
        while not traces.finished:
            for number, record in traces.poll():
                if record["kind"] == "header":
                    sniffer.header(record)
                    width = max([width, *(len(agent["name"]) for agent in agents_of(record))])
                for row in sniffer.rows(traces.on_one_line(number, record)):
                    text = json.dumps(_row(row), ensure_ascii=False) if as_json else line_of(row, width)
                    sys.stdout.write(f"{text}\n")
            sys.stdout.flush()
            if not traces.finished:
                time.sleep(_PAUSE)
    except KeyboardInterrupt:
        return 0
    finally:
        traces.close()
        for _, problem in traces.problems:
            click.echo(problem, err=True)
        for text in sniffer.remarks():
            click.echo(text, err=True)
    unknown = not_in_traces(sniffer.unknown(), sniffer.team, paths)
    print_diagnostics(unknown, colour)
    return int(bool(unknown))


# ---- after the run -------------------------------------------------------------------------------


def _show(
    paths: Sequence[Path],
    wanted: Wanted,
    form: _Form,
    as_json: bool,
    colour: str,
) -> int:
    from aseme_dsl.project.playing.merging import Beginning, shifts
    from aseme_dsl.project.playing.sniff import Sniffer, line_of
    from aseme_dsl.runtime.trace.trace_reading import TraceReader, fitting

    sniffer = Sniffer(wanted)
    readers = [TraceReader(path) for path in paths]
    lines: list[tuple[Path, Line]] = []
    began = [Beginning() for _ in readers]
    ends: list[int] = []
    for reader, beginning in zip(readers, began, strict=True):
        for line in reader:
            with fitting(reader.path, line):
                beginning.add(line.record)
                if line.number == 1:
                    sniffer.header(line.record)
            lines.append((reader.path, line))
        ends.append(len(lines))
    if len(readers) > 1:
        parts = zip([0, *ends], ends, shifts(began), strict=False)
        lines = [
            (path, replace(line, record=_shifted(line.record, shift)))
            for start, end, shift in parts
            for path, line in lines[start:end]
        ]
        lines.sort(key=lambda item: item[1].record["time"])
    rows: list[Row] = []
    for path, line in lines:
        with fitting(path, line):
            rows += sniffer.rows(line.record)
    if unknown := not_in_traces(sniffer.unknown(), sniffer.team, paths):
        return refuse(unknown, as_json, colour)
    problems = [(reader.problem, reader.path) for reader in readers if reader.problem is not None]
    diagram = sniffer.diagram(rows)
    if form.output is None:
        if as_json:
            print_json({"rows": [_row(row) for row in rows], "remarks": list(diagram.remarks)})
        elif form.format == "text":
            width = max([5, *(len(line.name) for line in diagram.lifelines)])
            click.echo("\n".join(line_of(row, width) for row in rows) or "no agent messages in this trace")
            for text in diagram.remarks:
                click.echo(text, err=True)
        else:
            click.echo(_drawn(_in_groups(diagram, form), form), nl=False)
    else:
        files = _write(diagram, form, form.output, paths)
        if as_json:
            print_json({"files": [str(path) for path in files], "remarks": list(diagram.remarks)})
        else:
            shown = f"{plural(len(rows), 'row')} of {plural(len(diagram.conversations), 'conversation')}"
            click.echo(f"{', '.join(map(str, files))}: {shown}")
            for text in diagram.remarks:
                click.echo(text, err=True)
    for problem, path in problems:
        say_unreadable(problem, path, colour)
    return int(bool(problems))


def _write(diagram: SequenceDiagram, form: _Form, output: Path, read: Sequence[Path]) -> list[Path]:
    """The files: one a page of each picture."""
    from aseme_dsl.project.files.outputs import marked
    from aseme_dsl.project.playing.sniff import of_conversation

    diagrams = [(output, diagram)]
    if form.each:
        diagrams = [(_named(output, name), of_conversation(diagram, name)) for name in diagram.conversations]
    files: list[tuple[Path, str]] = []
    for path, item in diagrams:
        for number, text in enumerate(_pages(_in_groups(item, form), form), 1):
            files.append((path if number == 1 else _named(path, str(number)), text))
    check_outputs([(file, "talk") for file, _ in files], read)
    for file, text in files:
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(marked(text.encode(), _SUFFIX_OF[form.format], "sniff"))
        except OSError as problem:
            raise click.ClickException(f"{file} cannot be written: {problem.strerror}") from problem
    return [file for file, _ in files]


def _named(path: Path, what: str) -> Path:
    """A file beside another one, called after something else besides."""
    return path.with_name(f"{path.stem}-{re.sub(r'[^A-Za-z0-9_.-]', '_', what)}{path.suffix}")


def _in_groups(diagram: SequenceDiagram, form: _Form) -> SequenceDiagram:
    """The diagram with groups where they are asked for, or where it has many agents."""
    from aseme_dsl.diagrams.sequence.groups import MOST, grouped

    if form.format == "text" or form.group is False:
        return diagram
    return grouped(diagram, 0 if form.group else MOST)


def _pages(diagram: SequenceDiagram, form: _Form) -> Iterator[str]:
    """The diagram in pages; what is text has one."""
    from aseme_dsl.diagrams.look.drawing import PageSize
    from aseme_dsl.diagrams.sequence.sequence import pages
    from aseme_dsl.diagrams.sequence.sequence_svg import pictures

    if form.format == "svg":
        yield from pictures(diagram, PageSize(form.page) if form.page is not None else None)
    else:
        yield from (_drawn(part, form) for part in ([diagram] if form.format == "text" else pages(diagram)))


def _drawn(diagram: SequenceDiagram, form: _Form) -> str:
    from aseme_dsl.diagrams.sequence.sequence_mermaid import mermaid
    from aseme_dsl.diagrams.sequence.sequence_svg import drawn
    from aseme_dsl.project.playing.sniff import line_of

    if form.format == "svg":
        return drawn(diagram)
    if form.format == "mermaid":
        return mermaid(diagram)
    width = max([5, *(len(line.name) for line in diagram.lifelines)])
    return "".join(f"{line}\n" for line in (*(line_of(row, width) for row in diagram.rows), *diagram.remarks))


def _row(row: Row) -> dict[str, object]:
    """A row as data: what is empty is left out."""
    return {name: value for name, value in asdict(row).items() if value not in ("", False)}


# ---- the times of several processes ----------------------------------------------------------------


def _shifted(record: Record, shift: int) -> Record:
    """A line with the time since the first of the processes began; they count from their own begin."""
    return record | {"time": record["time"] + shift} if shift else record
