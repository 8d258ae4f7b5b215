"""`asemec explain`: explain diagnostic codes."""

from __future__ import annotations

import re
import shutil
import sys
import textwrap
from collections.abc import Iterator
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import colour_option, json_option, print_json, wants_colour
from aseme_dsl.diagnostics import CODES, GROUPS, Code, Diagnostic, Severity, closest, render_json, render_text

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from aseme_dsl.diagnostics.pages import Example, Page

_COLOURS = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.NOTE: "cyan"}
_WIDEST = 100
"""Longer lines are hard to read, however wide the terminal is."""


def _codes(context: click.Context, parameter: click.Parameter, written: tuple[str, ...]) -> tuple[str, ...]:
    """The codes as people copy them: `E200`, `e200` or `error[E200]`; `W4` or `W41` are all that begin so.

    Raises:
        click.UsageError: There is no such code.
    """
    codes = []
    for text in written:
        copied = re.fullmatch(r"(?:\w*\[)?(\w+)\]?", text)
        code = copied[1].upper() if copied else text
        group = [item for item in CODES if re.fullmatch(r"[EWN]\d{1,2}", code) and item.startswith(code)]
        if group:
            codes += group
            continue
        if code not in CODES:
            near = closest(code, CODES)
            hint = f"Did you mean {near!r}?" if near else "`asemec explain` lists all codes."
            raise click.UsageError(f"Unknown code {text!r}. {hint}", context)
        codes.append(code)
    return tuple(codes)


def _completions(
    context: click.Context, parameter: click.Parameter, incomplete: str
) -> list[CompletionItem[str]]:
    from click.shell_completion import CompletionItem

    wanted = incomplete.upper()
    return [CompletionItem(code, help=item.title) for code, item in CODES.items() if code.startswith(wanted)]


@click.command(
    short_help="Explain diagnostic codes.",
    help="Explain each CODE: its meaning, why it matters, the fix, and an example before and after the fix."
    " Without CODE, list all codes.",
    epilog="Example: asemec explain E200   ·   asemec explain W4",
)
@click.argument("codes", nargs=-1, metavar="[CODE]...", callback=_codes, shell_complete=_completions)
@json_option
@colour_option
def command(codes: tuple[str, ...], as_json: bool, colour: str) -> int:
    """Print the page of each code, or the list of all codes."""
    if as_json:
        entries = (
            [_page_json(code) for code in codes] if codes else [_code_json(item) for item in CODES.values()]
        )
        print_json({"codes": entries})
        return 0
    painted = wants_colour(colour, sys.stdout)
    lines = _pages(codes, painted) if codes else _list()
    click.echo("\n".join(lines), color=painted)
    return 0


def _list() -> Iterator[str]:
    """All codes by group."""
    for digit, group in GROUPS.items():
        yield click.style(group, bold=True)
        for item in CODES.values():
            if item.code[1] == digit:
                yield f"  {_painted(item.code, item)}  {item.title}"
        yield ""
    yield "For details: asemec explain CODE"


def _pages(codes: tuple[str, ...], painted: bool) -> Iterator[str]:
    from aseme_dsl.diagnostics.pages import page

    for number, code in enumerate(dict.fromkeys(codes)):
        if number:
            yield ""
        yield from _page(page(code), painted)


def _page(page: Page, painted: bool) -> Iterator[str]:
    entry = CODES[page.code]
    yield f"{_painted(f'{page.severity}[{page.code}]', entry)}: {click.style(page.title, bold=True)}"
    width = min(shutil.get_terminal_size().columns, _WIDEST)
    for paragraph in re.split(r"\n\s*\n", page.text):
        yield ""
        yield from _wrapped(paragraph, width)
    yield from ("", click.style("Wrong:", fg="red"))
    yield from _example(page.wrong)
    says = _diagnostics(page.wrong)
    if not page.wrong.console and page.code not in {item.code for item in says}:
        yield from (
            "",
            "(The output of asemec requires a package that is not installed: see `asemec doctor`.)",
        )
    elif says:
        yield from ("", "Output:", "")
        yield textwrap.indent(render_text(says, colour=painted), "  ").rstrip("\n")
    yield from ("", click.style("Right:", fg="green"))
    yield from _example(page.right)


def _wrapped(paragraph: str, width: int) -> Iterator[str]:
    """A paragraph or a list, filled."""
    for item in re.split(r"\n(?=- )", paragraph):
        yield from textwrap.wrap(
            item,
            width,
            subsequent_indent="  " if item.startswith("- ") else "",
            break_long_words=False,
            break_on_hyphens=False,
        )


def _example(example: Example) -> Iterator[str]:
    """The files of an example, with their names where one alone would not be clear, and its console."""
    several = len(example.files) > 1 or any(file.language != "aseme" for file in example.files)
    for file in example.files:
        yield ""
        if several:
            yield f"  {file.name}:"
        yield textwrap.indent(file.text, "    ").rstrip("\n")
    if example.console:
        yield ""
        yield textwrap.indent(example.console, "    ").rstrip("\n")


def _diagnostics(example: Example) -> tuple[Diagnostic, ...]:
    from aseme_dsl.project.building.examples import diagnostics_of

    return diagnostics_of(example)


def _painted(text: str, code: Code) -> str:
    return click.style(text, fg=_COLOURS[Severity(code.severity)], bold=True)


def _code_json(code: Code) -> dict[str, object]:
    return {
        "code": code.code,
        "severity": code.severity,
        "title": code.title,
        "group": GROUPS[code.code[1]],
    }


def _page_json(code: str) -> dict[str, object]:
    from aseme_dsl.diagnostics.pages import page

    found = page(code)
    return {
        **_code_json(CODES[code]),
        "text": found.text,
        "wrong": _example_json(found.wrong),
        "right": _example_json(found.right),
    }


def _example_json(example: Example) -> dict[str, object]:
    return {
        "files": [{"name": file.name, "text": file.text} for file in example.files],
        "console": example.console or None,
        "diagnostics": render_json(_diagnostics(example)),
    }
