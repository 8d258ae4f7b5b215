"""Report: what was found, for people, for programs or for services, printed or in a file."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import click

from aseme_dsl import __version__
from aseme_dsl.cli.shared import FORMAT, CommandT, FilePath, check_outputs, print_diagnostics
from aseme_dsl.diagnostics import Diagnostic, Suppressed, has_errors, render_text
from aseme_dsl.records import dataclass

FORMATS = ("text", "json", "sarif", "github", "junit", "codequality")


@dataclass(frozen=True, slots=True)
class Report:
    """What a command has found: `files` is what it looked at, `command` its name in a test report.

    `result` is what `--json` says, but for the version of its format; `closing` are the lines that people
    read at the end. `strict`: a warning is as bad as an error.
    """

    command: str
    diagnostics: Sequence[Diagnostic]
    suppressed: Sequence[Suppressed]
    files: Sequence[str]
    result: Callable[[], dict[str, object]]
    closing: str
    strict: bool = False


def report_options(*names: str) -> Callable[[CommandT], CommandT]:
    """`--format`, `--json`, and under `names` the file for the report: `form`, `as_json` and `report`."""

    def add(command: CommandT) -> CommandT:
        command = click.option(
            *names,
            "report",
            type=FilePath(path_type=Path),
            metavar="REPORT",
            help="Report file.  [default: standard output]",
        )(command)
        command = click.option("--json", "as_json", is_flag=True, help="Short for --format json.")(command)
        return click.option(
            "--format",
            "form",
            type=click.Choice(FORMATS),
            help="Output format; github: workflow commands, codequality: GitLab.  [default: text]",
        )(command)

    return add


def form_of(form: str | None, as_json: bool, report: Path | None) -> str:
    """The format that the options mean; what contradicts itself is wrong use."""
    if as_json and form not in (None, "json"):
        raise click.UsageError(f"--json contradicts --format {form}.")
    if report is not None and report.suffix == ".aseme":
        raise click.UsageError(f"{report} is a source file name: choose another one for the report.")
    if report is not None:
        check_outputs([(report, "report")])
    return "json" if as_json else form or "text"


def print_report(report: Report, form: str, file: Path | None, colour: str) -> bool:
    """Print the report or write it into the file; whether it could not be written."""
    text = text_of(report, form)
    if file is None:
        click.echo(text, nl=False)
        return False
    from aseme_dsl.project.files.write import write_file

    written = write_file(file, text.encode("utf-8", "backslashreplace"))
    print_diagnostics(written.diagnostics, colour)
    return has_errors(written.diagnostics)


def text_of(report: Report, form: str) -> str:
    """The report in one of the formats, as it goes into a file."""
    if form == "sarif":
        from aseme_dsl.diagnostics.sarif import sarif

        return _json_text(sarif(report.diagnostics, report.suppressed, version=__version__))
    if form == "github":
        from aseme_dsl.diagnostics.github import github

        return github(report.diagnostics)
    if form == "junit":
        from aseme_dsl.diagnostics.junit import junit

        return junit(report.diagnostics, report.files, name=f"asemec {report.command}", strict=report.strict)
    if form == "codequality":
        from aseme_dsl.diagnostics.codequality import codequality

        return _json_text(codequality(report.diagnostics))
    if form == "json":
        return _json_text({"format": FORMAT, **report.result()})
    text = render_text(report.diagnostics)
    return text + ("\n" if text and report.closing else "") + report.closing


def _json_text(value: object) -> str:
    import json

    return json.dumps(value, indent=2, ensure_ascii=False) + "\n"
