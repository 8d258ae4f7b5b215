"""Lines of the tables in `docs/project/security.md`: each has a test, and each test of a line has its line.

A test says which line it tests: `@line("another user of this machine", "connect to the bus")`, with the first
two cells of the row as they stand in the page; for what listens, `@line("team", "in one process")`.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

F = TypeVar("F", bound=Callable[..., object])

PAGE = Path(__file__).resolve().parents[2] / "docs" / "project" / "security.md"


def line(who: str, what: str) -> Callable[[F], F]:
    """Marks a test as that of a line."""

    def mark(test: F) -> F:
        return test

    return mark


def lines_of_the_page() -> list[tuple[str, str]]:
    """The first two cells of each row of the tables with `who`, `what` as their first columns.

    Of a row of the table with `team`, `opens`, it is "team" and its first cell.
    """
    found: list[tuple[str, str]] = []
    inside = teams = False
    for text in PAGE.read_text("utf-8").splitlines():
        cells = [cell.strip() for cell in text.strip().strip("|").split("|")]
        if not text.startswith("|"):
            inside = teams = False
        elif cells[:2] == ["who", "what"]:
            inside = True
        elif cells[:2] == ["team", "opens"]:
            teams = True
        elif not set(text) <= set("|- :"):
            if inside:
                found.append((cells[0], cells[1]))
            elif teams:
                found.append(("team", cells[0]))
    return found


def lines_of_tests() -> dict[tuple[str, str], str]:
    """Which line is tested by which test."""
    found: dict[tuple[str, str], str] = {}
    tests = Path(__file__).parents[1]
    # What needs SPADE or mango is in the second lane; what sees Windows stands with the commands.
    elsewhere = (*tests.glob("platforms/test_*.py"), tests / "cli/test_windows.py")
    for path in sorted((*tests.glob("security/test_*.py"), *elsewhere)):
        for node in ast.parse(path.read_text("utf-8")).body:
            if not isinstance(node, ast.FunctionDef):
                continue
            for mark in node.decorator_list:
                if isinstance(mark, ast.Call) and isinstance(mark.func, ast.Name) and mark.func.id == "line":
                    who, what = (
                        argument.value for argument in mark.args if isinstance(argument, ast.Constant)
                    )
                    found[str(who), str(what)] = f"{path.name}::{node.name}"
    return found
