"""`asemec check`: check files for errors."""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.report import Report, form_of, print_report, report_options
from aseme_dsl.cli.shared import (
    TARGETS_HELP,
    colour_option,
    diagnostics_json,
    plural,
    print_diagnostics,
    standard_input,
    summary,
    targets_argument,
    watch_option,
)
from aseme_dsl.diagnostics import Severity, has_errors
from aseme_dsl.diagnostics.problems.syntax.entries import Hole

if TYPE_CHECKING:
    from aseme_dsl.cli.watching import Done
    from aseme_dsl.project.building.project import Checked
    from aseme_dsl.project.building.workshop import Workshop
    from aseme_dsl.project.editing.fix import Fixed

_INSTALL_Z3 = 'pip install "aseme-dsl[check]"'


@click.command(
    short_help="Check files for errors.",
    help=f"Report the errors, warnings and notes of files. {TARGETS_HELP}",
    epilog="Example: asemec check team.aseme   ·   asemec check --strict --format sarif -o report.sarif",
)
@targets_argument
@click.option("--strict", is_flag=True, help="Exit with 1 for warnings and holes, too.")
@click.option("--fix", "mend", is_flag=True, help="Apply unambiguous fixes to the files.")
@click.option("--diff", is_flag=True, help="With --fix: print the changes, do not write them.")
@click.option(
    "--compatible-with",
    "old",
    metavar="OLD",
    help="Also compare with another version: which messages robots of the two builds refuse. OLD is a file, a"
    " project, the output of a build or a git revision. Exit with 1 if some are.",
)
@watch_option
@report_options("-o", "--output")
@colour_option
def command(
    targets: tuple[str, ...],
    strict: bool,
    mend: bool,
    diff: bool,
    old: str | None,
    watch: bool,
    form: str | None,
    as_json: bool,
    report: Path | None,
    colour: str,
) -> int:
    """Print the diagnostics and a summary; 1 if there is an error."""
    from aseme_dsl.project.building.project import check, inputs_of

    form = form_of(form, as_json, report)
    if diff and not mend:
        raise click.UsageError("--diff requires --fix.")
    if diff and (form != "text" or report is not None):
        raise click.UsageError("--diff prints changes, not a report: not with --format or -o.")
    if mend and "-" in targets:
        raise click.UsageError("--fix changes files: not with standard input.")
    if old is not None and (mend or watch or "-" in targets or form not in ("text", "json")):
        raise click.UsageError("--compatible-with compares files: not with --fix, --watch or a report.")
    if watch:
        from aseme_dsl.cli import watching

        watching.refuse_to_watch(targets, form, report)
        if mend:
            raise click.UsageError("--watch only checks, --fix changes files: choose one.")
        return watching.watch(partial(_once, targets), targets, None, None, colour)
    inputs = inputs_of(targets, standard_input)
    if not mend:
        checked = check(inputs)
        if old is not None and not has_errors(checked.diagnostics):
            return _compare(checked, old, form, report, colour, strict)
        failed = _report(checked, None, form, report, colour, strict)
        return int(failed or _is_bad(checked, strict))
    from aseme_dsl.project.editing.fix import difference, fix, write_fixed

    fixed = fix(inputs)
    if diff:
        click.echo(difference(fixed), nl=False)
        print_diagnostics(fixed.checked.diagnostics, colour)
        return int(bool(fixed.after) or _is_bad(fixed.checked, strict))
    written = write_fixed(fixed)
    if has_errors(written.diagnostics):
        print_diagnostics(written.diagnostics, colour)
        return 1
    failed = _report(fixed.checked, fixed, form, report, colour, strict)
    return int(failed or _is_bad(fixed.checked, strict))


def _compare(checked: Checked, old: str, form: str, file: Path | None, colour: str, strict: bool) -> int:
    """Print the diagnostics, and what robots of an older version refuse; 1 if that is anything."""
    from aseme_dsl.cli.shared import print_json, refuse
    from aseme_dsl.project.comparing.compatible import as_json, compatibility, lines
    from aseme_dsl.project.comparing.versions import NotAVersion, opened

    systems = [one.system for one in checked.compiled if one.system is not None]
    if len(systems) != 1:
        raise click.UsageError(f"--compatible-with compares one system, and there are {len(systems)}.")
    try:
        with opened(old, str(checked.files[0])) as version:
            if version.system is None:
                return refuse(version.diagnostics, form == "json", colour)
            found = compatibility(version.system, systems[0])
    except NotAVersion as problem:
        raise click.UsageError(f"{problem}.") from problem
    failed = False
    if form == "json" and file is None:
        print_json({**_json(checked, None), "compatibility": as_json(found)})
    else:
        failed = _report(checked, None, form, file, colour, strict)
        for line in lines(found, old):
            click.echo(line)
    return int(failed or bool(found.incompatible) or _is_bad(checked, strict))


def _once(targets: tuple[str, ...], workshop: Workshop) -> Done:
    from aseme_dsl.cli.watching import Done
    from aseme_dsl.project.building.project import check, inputs_of

    checked = check(inputs_of(targets, standard_input), workshop=workshop)
    return Done(checked.diagnostics, checked.compiled, summary(checked.diagnostics, len(checked.files)))


def _is_bad(checked: Checked, strict: bool) -> bool:
    bad = {Severity.ERROR, Severity.WARNING} if strict else {Severity.ERROR}
    return any(
        item.severity in bad or (strict and isinstance(item.problem, Hole)) for item in checked.diagnostics
    )


def _report(
    checked: Checked, fixed: Fixed | None, form: str, file: Path | None, colour: str, strict: bool
) -> bool:
    """Print or write the report; whether it could not be written."""
    if form == "text" and file is None:
        if fixed is not None:
            _print_mended(fixed)
        print_diagnostics(checked.diagnostics, colour, error=False)
        click.echo(("\n" if checked.diagnostics else "") + _summary(checked))
        if checked.diagnostics and sys.stdout.isatty():
            click.echo(_tip(checked))
        return False
    report = Report(
        "check",
        checked.diagnostics,
        checked.suppressed,
        checked.files,
        partial(_json, checked, fixed),
        f"{_summary(checked)}\n",
        strict,
    )
    failed = print_report(report, form, file, colour)
    if file is not None:
        if fixed is not None:
            _print_mended(fixed)
        click.echo(_summary(checked))
    return failed


def _summary(checked: Checked) -> str:
    said = summary(checked.diagnostics, len(checked.files))
    if checked.unchecked:
        number = plural(checked.unchecked, "choice")
        were = "was" if checked.unchecked == 1 else "were"
        said += f"\n{number} {were} not checked for overlaps and gaps; to enable this: {_INSTALL_Z3}"
    return said


def _tip(checked: Checked) -> str:
    """A hint at the next command, for a user at a terminal."""
    from aseme_dsl.project.editing.fix import is_mendable

    worst = min(checked.diagnostics, key=lambda item: list(Severity).index(item.severity))
    tip = f"for details: asemec explain {worst.code}"
    number = sum(map(is_mendable, checked.diagnostics))
    return tip if not number else f"{tip}; to fix {plural(number, 'problem')}: asemec check --fix"


def _json(checked: Checked, fixed: Fixed | None) -> dict[str, object]:
    from dataclasses import asdict

    from aseme_dsl.diagnostics import render_json
    from aseme_dsl.diagnostics.render import suppressed_json

    result = {"files": len(checked.files), **diagnostics_json(checked.diagnostics)}
    result["unchecked_choices"] = checked.unchecked
    result["suppressed"] = suppressed_json(checked.suppressed)
    result["certified"] = [asdict(item) for one in checked.compiled for item in one.certificates]
    if fixed is not None:
        result["mended"] = render_json(fixed.mended)
    return result


def _print_mended(fixed: Fixed) -> None:
    for item in fixed.mended:
        changed = "; ".join(_change(edit.span.text, edit.text) for edit in item.changes)
        click.echo(f"{item.span}: fixed[{item.code}]: {changed}")
    if fixed.mended:
        number = plural(len(fixed.mended), "problem")
        click.echo(f"{number} fixed in {plural(len(fixed.after), 'file')}\n")


def _change(before: str, after: str) -> str:
    old, new = (" ".join(text.split()) for text in (before, after))
    if not new:
        return f"without `{old}`"
    return f"`{old}` -> `{new}`" if old else f"with `{new}`"
