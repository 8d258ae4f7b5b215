"""`asemec check`: what is wrong with files."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from aseme_dsl import __version__
from aseme_dsl.cli.shared import (
    FILES_HELP,
    FORMAT,
    FilePath,
    colour_option,
    diagnostics_json,
    plural,
    print_diagnostics,
    standard_input,
    summary,
)
from aseme_dsl.diagnostics import Severity, has_errors

if TYPE_CHECKING:
    from aseme_dsl.build.fix import Fixed
    from aseme_dsl.build.project import Checked

_INSTALL_Z3 = 'pip install "aseme-dsl[check]"'

FORMATS = ("text", "json", "sarif", "github", "junit")


@click.command(
    short_help="Say what is wrong with files.",
    help=f"Say everything that is wrong with files, and what is not said yet. {FILES_HELP}"
    " Without FILE: what the project's pyproject.toml names, or every file below here.",
    epilog="Example: asemec check team.aseme   ·   asemec check --strict --format sarif -o report.sarif",
)
@click.argument("files", nargs=-1, metavar="[FILE]...", type=FilePath())
@click.option("--strict", is_flag=True, help="Let warnings count as errors for the exit code.")
@click.option("--fix", "mend", is_flag=True, help="Mend what has one right answer, in the files.")
@click.option("--diff", is_flag=True, help="With --fix: change nothing, show what would change.")
@click.option(
    "--format",
    "form",
    type=click.Choice(FORMATS),
    help="How to say it: for people, for programs, for code scanning, as GitHub workflow commands, as a test"
    " report.  [default: text]",
)
@click.option("--json", "as_json", is_flag=True, help="The same as --format json.")
@click.option(
    "-o",
    "--output",
    type=FilePath(path_type=Path),
    metavar="REPORT",
    help="Write the report into this file.  [default: standard output]",
)
@colour_option
def command(
    files: tuple[str, ...],
    strict: bool,
    mend: bool,
    diff: bool,
    form: str | None,
    as_json: bool,
    output: Path | None,
    colour: str,
) -> int:
    """Print the diagnostics and a summary; 1 if there is an error."""
    from aseme_dsl.build.project import check, inputs_of

    form = _form(form, as_json, output)
    if diff and not mend:
        raise click.UsageError("--diff shows what --fix would change: give both.")
    if diff and (form != "text" or output is not None):
        raise click.UsageError("--diff prints a difference, which is no report: leave --format and -o away.")
    if mend and "-" in files:
        raise click.UsageError("--fix changes files, and standard input is none.")
    inputs = inputs_of(files, standard_input)
    if not mend:
        checked = check(inputs)
        failed = _report(checked, None, form, output, colour, strict)
        return int(failed or _is_bad(checked, strict))
    from aseme_dsl.build.fix import difference, fix, write_fixed

    fixed = fix(inputs)
    if diff:
        click.echo(difference(fixed), nl=False)
        print_diagnostics(fixed.checked.diagnostics, colour)
        return int(bool(fixed.after) or _is_bad(fixed.checked, strict))
    written = write_fixed(fixed)
    if has_errors(written.diagnostics):
        print_diagnostics(written.diagnostics, colour)
        return 1
    failed = _report(fixed.checked, fixed, form, output, colour, strict)
    return int(failed or _is_bad(fixed.checked, strict))


def _form(form: str | None, as_json: bool, output: Path | None) -> str:
    if as_json and form not in (None, "json"):
        raise click.UsageError(f"--json is --format json, and not --format {form}.")
    if output is not None and output.suffix == ".aseme":
        raise click.UsageError(f"{output} is the name of a source: give the report another one.")
    return "json" if as_json else form or "text"


def _is_bad(checked: Checked, strict: bool) -> bool:
    bad = {Severity.ERROR, Severity.WARNING} if strict else {Severity.ERROR}
    return any(item.severity in bad for item in checked.diagnostics)


def _report(
    checked: Checked, fixed: Fixed | None, form: str, output: Path | None, colour: str, strict: bool
) -> bool:
    """Print or write the report; whether it could not be written."""
    if form == "text" and output is None:
        if fixed is not None:
            _print_mended(fixed)
        print_diagnostics(checked.diagnostics, colour, error=False)
        click.echo(("\n" if checked.diagnostics else "") + _summary(checked))
        if checked.diagnostics and sys.stdout.isatty():
            click.echo(_tip(checked))
        return False
    text = _text(checked, fixed, form, strict)
    if output is None:
        click.echo(text, nl=False)
        return False
    from aseme_dsl.build.write import write_file

    written = write_file(output, text.encode("utf-8", "backslashreplace"))
    print_diagnostics(written.diagnostics, colour)
    if fixed is not None:
        _print_mended(fixed)
    click.echo(_summary(checked))
    return has_errors(written.diagnostics)


def _summary(checked: Checked) -> str:
    said = summary(checked.diagnostics, len(checked.files))
    if checked.unchecked:
        number = plural(checked.unchecked, "choice")
        were = "was" if checked.unchecked == 1 else "were"
        said += f"\n{number} {were} not checked for overlaps and gaps; to do so: {_INSTALL_Z3}"
    return said


def _tip(checked: Checked) -> str:
    """What somebody at a terminal may do next."""
    from aseme_dsl.build.fix import is_mendable

    worst = min(checked.diagnostics, key=lambda item: list(Severity).index(item.severity))
    tip = f"asemec explain {worst.code} tells more"
    number = sum(map(is_mendable, checked.diagnostics))
    return tip if not number else f"{tip}; asemec check --fix mends {plural(number, 'problem')}"


def _text(checked: Checked, fixed: Fixed | None, form: str, strict: bool) -> str:
    """The report, as it goes into a file."""
    if form == "sarif":
        from aseme_dsl.diagnostics.sarif import sarif

        log = sarif(checked.diagnostics, checked.suppressed, version=__version__)
        return json.dumps(log, indent=2, ensure_ascii=False) + "\n"
    if form == "github":
        from aseme_dsl.diagnostics.github import github

        return github(checked.diagnostics)
    if form == "junit":
        from aseme_dsl.diagnostics.junit import junit

        return junit(checked.diagnostics, checked.files, strict=strict)
    if form == "json":
        return json.dumps(_json(checked, fixed), indent=2, ensure_ascii=False) + "\n"
    from aseme_dsl.diagnostics import render_text

    text = render_text(checked.diagnostics)
    return text + ("\n" if text else "") + _summary(checked) + "\n"


def _json(checked: Checked, fixed: Fixed | None) -> dict[str, Any]:
    from aseme_dsl.diagnostics import render_json
    from aseme_dsl.diagnostics.render import suppressed_json

    result = {"format": FORMAT, "files": len(checked.files), **diagnostics_json(checked.diagnostics)}
    result["unchecked_choices"] = checked.unchecked
    result["suppressed"] = suppressed_json(checked.suppressed)
    if fixed is not None:
        result["mended"] = render_json(fixed.mended)
    return result


def _print_mended(fixed: Fixed) -> None:
    for item in fixed.mended:
        changed = "; ".join(_change(edit.span.text, edit.text) for edit in item.changes)
        click.echo(f"{item.span}: mended[{item.code}]: {changed}")
    if fixed.mended:
        number = plural(len(fixed.mended), "problem")
        click.echo(f"{number} mended in {plural(len(fixed.after), 'file')}\n")


def _change(before: str, after: str) -> str:
    old, new = (" ".join(text.split()) for text in (before, after))
    if not new:
        return f"without `{old}`"
    return f"`{old}` -> `{new}`" if old else f"with `{new}`"
