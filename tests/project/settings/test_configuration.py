"""What a project says in its pyproject.toml."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.diagnostics import Diagnostic, render_text
from aseme_dsl.project.files.duration import duration
from aseme_dsl.project.settings.configuration import Configuration, find_configuration, read_configuration


def read(folder: Path, text: str) -> tuple[Configuration, tuple[Diagnostic, ...]]:
    (folder / "pyproject.toml").write_text(text, "utf-8")
    return read_configuration(folder / "pyproject.toml")


def problem(folder: Path, text: str) -> Diagnostic:
    _, diagnostics = read(folder, text)
    (only,) = diagnostics
    return only


def test_everything_that_can_be_said(tmp_path: Path) -> None:
    configuration, diagnostics = read(
        tmp_path,
        """
        [tool.asemec]
        files = ["team.aseme"]
        output = "generated"
        backends = ["monas"]
        activities = "skills"
        templates = "templates"
        max_states = 5000
        labels = "original"
        expressions = "inline"

        [tool.asemec.run]
        world = "field.world:match"
        progress = "field.world:notes"
        summary = "field.world:result"
        duration = "1.5min"
        seed = 7
        trace = "trace.jsonl"
        """,
    )
    assert diagnostics == ()
    assert configuration.files == (tmp_path / "team.aseme",)
    assert configuration.output == tmp_path / "generated"
    assert configuration.backends == ("monas",)
    assert configuration.activities == tmp_path / "skills"
    assert configuration.max_states == 5000
    run = configuration.run
    assert run is not None
    assert (run.world, run.duration, run.seed) == ("field.world:match", 90_000_000_000, 7)


def test_the_nearest_project_upwards_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    deep = tmp_path / "a" / "b" / "c"
    deep.mkdir(parents=True)
    (tmp_path / "pyproject.toml").write_text('[tool.asemec]\noutput = "outer"')
    assert find_configuration(deep)[0].output == tmp_path / "outer"
    (tmp_path / "a" / "pyproject.toml").write_text("[project]\nname = 'another'")
    assert find_configuration(deep)[0].output is None
    (deep / "pyproject.toml").write_text('[tool.asemec]\noutput = "inner"')
    monkeypatch.chdir(deep)
    assert find_configuration(Path())[0].output == Path("inner")
    monkeypatch.chdir(tmp_path)
    assert find_configuration(Path("a/b/c"))[0].output == Path("a/b/c/inner")
    (deep / "d").mkdir()
    monkeypatch.chdir(deep / "d")
    found = find_configuration(Path())[0].output
    assert found is not None
    assert found.resolve() == deep / "inner"


def test_without_a_project_nothing_is_said(tmp_path: Path) -> None:
    assert find_configuration(tmp_path / "missing")[1] == ()


def test_an_unknown_key_is_named_with_its_place(tmp_path: Path) -> None:
    found = problem(tmp_path, '[project]\noutputs = 1\n[tool.asemec]\noutputs = "out"\n')
    text = render_text([found])
    assert found.code == "E010"
    assert "pyproject.toml:4:1" in text
    assert "did you mean `output`?" in text


def test_a_key_of_a_table_inside_is_told_where_it_belongs(tmp_path: Path) -> None:
    found = problem(tmp_path, '[tool.asemec]\nworld = "place:make"\n')
    assert "it belongs into [tool.asemec.run]" in render_text([found])


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("output = 3", "`output` must be a path in quotes"),
        ('output = ""', "a path in quotes"),
        ('backends = "monas"', "a list of names"),
        ("backends = []", "a list of names"),
        ("max_states = 0", "a whole number from 1 on"),
        ("max_states = true", "a whole number from 1 on"),
        ('labels = "mine"', "one of plain, original"),
        ("run = 3", "`run` must be a table: [tool.asemec.run]"),
        ('files = "a.aseme"', "a list of paths"),
        ('run.duration = "5"', 'a duration in quotes, such as "60s"'),
        ('run.duration = "0s"', "a duration in quotes"),
        ('run.world = "module"', 'a Python function, such as "module:name"'),
        ("run.seed = 1.5", "a whole number"),
    ],
)
def test_a_wrong_value_is_told_what_is_expected(tmp_path: Path, line: str, words: str) -> None:
    found = problem(tmp_path, f"[tool.asemec]\n{line}\n")
    assert found.code == "E010"
    assert words in found.message
    assert found.span is not None
    assert found.span.line == 2


def test_the_rest_of_a_table_with_a_mistake_counts(tmp_path: Path) -> None:
    configuration, diagnostics = read(tmp_path, '[tool.asemec]\noutput = 3\ntemplates = "t"\nfoo = 1')
    assert configuration.templates == tmp_path / "t"
    assert [item.code for item in diagnostics] == ["E010", "E010"]


def test_a_place_in_an_inline_table_is_its_line(tmp_path: Path) -> None:
    found = problem(tmp_path, "[tool]\nasemec = { run = { sed = 1 } }\n")
    assert found.span is not None
    assert "did you mean `seed`?" in (found.hint or "")


@pytest.mark.parametrize(
    ("text", "line"),
    [("[tool.asemec\n", 1), ("a = 1\nb = = 2\n", 2), ('a = "', 1), ("a = [\n1,\n", 2)],
)
def test_malformed_toml_has_a_place(tmp_path: Path, text: str, line: int) -> None:
    found = problem(tmp_path, text)
    assert found.code == "E010"
    assert "not valid TOML" in found.message
    assert found.span is not None
    assert found.span.line == line
    assert render_text([found])


def test_a_project_file_that_is_no_text(tmp_path: Path) -> None:
    (tmp_path / "pyproject.toml").write_bytes(b"\xff\xfe")
    assert [item.code for item in find_configuration(tmp_path)[1]] == ["E002"]


@pytest.mark.parametrize("text", ['tool = "x"', "[tool]\nasemec = 3"])
def test_a_tool_table_that_is_none(tmp_path: Path, text: str) -> None:
    _, diagnostics = read(tmp_path, text)
    assert [item.code for item in diagnostics] == (["E010"] if "asemec" in text else [])


@pytest.mark.parametrize(
    ("text", "nanoseconds"), [("200ms", 200_000_000), ("1.5s", 1_500_000_000), (" 2min ", 120_000_000_000)]
)
def test_durations(text: str, nanoseconds: int) -> None:
    assert duration(text) == nanoseconds


@pytest.mark.parametrize("text", ["", "5", "s", "-1s", "1h", "1e9s", "٣s", "99999999999min"])
def test_no_durations(text: str) -> None:
    with pytest.raises(ValueError, match=r"duration|century"):
        duration(text)
