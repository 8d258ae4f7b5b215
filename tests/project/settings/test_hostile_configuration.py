"""A pyproject.toml that does harm is refused with its reason, at once."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.project.settings.configuration import read_configuration


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("a" + ".a" * 100_000 + " = 1", "a key has more than 200 parts"),
        ("[a" + ".a" * 100_000 + "]", "a key has more than 200 parts"),
        ('x = {y = 1, "a"' + ".a" * 100_000 + " = 1}", "a key has more than 200 parts"),
        ("x = " + "[" * 100_000, "too many lists or tables in each other"),
        ("x = " + "{a = " * 100_000, "too many lists or tables in each other"),
        ('[tool.asemec]\nfiles = ["a\\u0000b"]', "`files` must be"),
        ('[tool.asemec]\noutput = "a\\u0000b"', "`output` must be"),
    ],
    ids=["key", "table", "inside", "lists", "tables", "NUL in files", "NUL in output"],
)
def test_depth_and_names(tmp_path: Path, text: str, reason: str) -> None:
    path = tmp_path / "pyproject.toml"
    path.write_text(text, "utf-8")
    _, (problem,) = read_configuration(path)
    assert problem.code == "E010" and reason in problem.message


def test_size(tmp_path: Path) -> None:
    path = tmp_path / "pyproject.toml"
    with path.open("wb") as file:
        file.truncate(20 << 30)
    _, (problem,) = read_configuration(path)
    assert problem.code == "E001" and "larger than 1 MB" in problem.message


def test_many_dots_in_a_usual_file_are_fine(tmp_path: Path) -> None:
    path = tmp_path / "pyproject.toml"
    path.write_text("x = [" + ", ".join(["1.5"] * 1000) + "]\n[tool.asemec]\nfiles = ['a.aseme']\n", "utf-8")
    assert read_configuration(path)[1] == ()
