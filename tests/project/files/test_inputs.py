"""Which files a command line means."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from aseme_dsl.project.files.inputs import Inputs, find_inputs
from aseme_dsl.source import Source


def find(*arguments: str | Path, standard_input: bytes = b"") -> Inputs:
    return find_inputs([str(argument) for argument in arguments], lambda: standard_input)


def names(inputs: Inputs) -> list[str]:
    return [root.path if isinstance(root, Source) else root.name for root in inputs.roots]


@pytest.fixture
def project(tmp_path: Path) -> Path:
    (tmp_path / "one.aseme").write_text("system One")
    (tmp_path / "two.aseme").write_text("// the second\n/* system\n*/ system Two")
    (tmp_path / "deep" / "er").mkdir(parents=True)
    (tmp_path / "deep" / "er" / "three.aseme").write_text("language 1 system Three")
    (tmp_path / "deep" / "shared.aseme").write_text(
        '// system no\n/* system no */ enum E { system } import "system x.aseme" message M { int system }'
    )
    (tmp_path / "notes.txt").write_text("system Notes")
    (tmp_path / ".hidden").mkdir()
    (tmp_path / ".hidden" / "four.aseme").write_text("system Four")
    (tmp_path / "venv").mkdir()
    (tmp_path / "venv" / "pyvenv.cfg").write_text("")
    (tmp_path / "venv" / "five.aseme").write_text("system Five")
    return tmp_path


def test_a_file_is_itself_whatever_it_is_called(project: Path) -> None:
    assert names(find(project / "notes.txt")) == ["notes.txt"]


def test_a_missing_file_is_left_to_the_reader(tmp_path: Path) -> None:
    inputs = find(tmp_path / "missing.aseme")
    assert (names(inputs), inputs.diagnostics) == (["missing.aseme"], ())


def test_a_folder_gives_its_systems_and_sets_other_files_apart(project: Path) -> None:
    inputs = find(project)
    assert names(inputs) == ["one.aseme", "two.aseme", "three.aseme"]
    assert [path.name for path in inputs.others] == ["shared.aseme"]
    assert inputs.diagnostics == ()


def test_a_pattern_is_matched_here(project: Path) -> None:
    assert names(find(project / "*.aseme")) == ["one.aseme", "two.aseme"]
    assert names(find(project / "**" / "t*")) == ["three.aseme", "two.aseme"]


def test_a_file_may_be_called_like_a_pattern(tmp_path: Path) -> None:
    (tmp_path / "a[1].aseme").write_text("system A")
    (tmp_path / "a1.aseme").write_text("system B")
    assert names(find(tmp_path / "a[1].aseme")) == ["a[1].aseme"]


def test_each_file_once_in_the_order_given(project: Path) -> None:
    link = project / "link.aseme"
    link.symlink_to(project / "two.aseme")
    found = find(project / "two.aseme", project / "one.aseme", project / "*.aseme", link)
    assert sorted(names(found)) in (["link.aseme", "one.aseme"], ["one.aseme", "two.aseme"])
    assert os.path.realpath(str(found.roots[0])) == os.path.realpath(project / "two.aseme")


def test_a_file_that_is_named_is_a_root_even_without_a_system(project: Path) -> None:
    inputs = find(project, project / "deep" / "shared.aseme")
    assert "shared.aseme" in names(inputs)
    assert inputs.others == ()


@pytest.mark.parametrize("argument", ["*.aseme", ".", "nothing?"])
def test_nothing_found_is_an_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, argument: str) -> None:
    monkeypatch.chdir(tmp_path)
    inputs = find(argument)
    assert [item.code for item in inputs.diagnostics] == ["E001"]
    assert argument in inputs.diagnostics[0].message


def test_standard_input_with_and_without_mark() -> None:
    for content in (b"system A // \xcf\x89", b"\xef\xbb\xbfsystem A // \xcf\x89"):
        (root,) = find("-", "-", standard_input=content).roots
        assert isinstance(root, Source)
        assert (root.path, root.text) == ("<stdin>", "system A // ω")


@pytest.mark.parametrize(
    ("content", "word"), [(b"a\nb\xff", "byte 0xff in line 2"), (b"sys\0tem", "byte 3 is NUL")]
)
def test_standard_input_that_is_no_text(content: bytes, word: str) -> None:
    inputs = find("-", standard_input=content)
    assert inputs.roots == ()
    assert [item.code for item in inputs.diagnostics] == ["E002"]
    assert word in inputs.diagnostics[0].message


def test_standard_input_that_cannot_be_read() -> None:
    def closed() -> bytes:
        raise OSError(9, "Bad file descriptor")

    assert [item.code for item in find_inputs(["-"], closed).diagnostics] == ["E001"]


def test_a_path_with_nul_does_not_crash() -> None:
    assert names(find("a\0b.aseme")) == ["a\0b.aseme"]
