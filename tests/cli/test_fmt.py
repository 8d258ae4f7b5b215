"""`asemec fmt`."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from aseme_dsl import outside
from aseme_dsl.project.editing.format import format_file
from aseme_dsl.project.files.write import Disk
from tests.cli.support import Here

UGLY = "system   A\nlet a=1 // one\n"
NICE = "system A\nlet a = 1  // one\n"


@pytest.fixture
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "nice.aseme").write_text(NICE)
    (tmp_path / "ugly.aseme").write_text(UGLY)
    (tmp_path / "deep").mkdir()
    (tmp_path / "deep" / "library.aseme").write_text("let   b=2\n")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def mark(path: Path) -> tuple[int, int]:
    return path.stat().st_mtime_ns, path.stat().st_ino


def test_all_files_of_a_folder(here: Here, files: Path) -> None:
    before = mark(files / "nice.aseme")
    done = here("fmt", ".")
    assert done.code == 0
    assert done.err == ""
    assert done.out.splitlines() == [
        "ugly.aseme: formatted",
        "deep/library.aseme: formatted",
        "2 files formatted, 1 file unchanged",
    ]
    assert (files / "ugly.aseme").read_text() == NICE
    assert (files / "deep" / "library.aseme").read_text() == "let b = 2\n"
    assert mark(files / "nice.aseme") == before
    assert here("fmt").out == "3 files unchanged\n"


def test_without_files_all_of_the_project(here: Here, files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (files / "pyproject.toml").write_text('[tool.asemec]\nfiles = ["nice.aseme"]\n')
    monkeypatch.chdir(files / "deep")
    done = here("fmt", "--check")
    assert done.code == 1
    assert done.out.splitlines()[-1] == "2 files would be formatted, 1 file unchanged"
    (files / "pyproject.toml").write_text("[tool.asemec\n")
    assert here("fmt").code == 1


def test_patterns(here: Here, files: Path) -> None:
    assert here("fmt", "n*.aseme").out == "1 file unchanged\n"
    assert here("fmt", "x*.aseme").code == 1


def test_check_changes_nothing(here: Here, files: Path) -> None:
    done = here("fmt", "--check", "ugly.aseme", "nice.aseme")
    assert done.code == 1
    assert done.out == "ugly.aseme: would be formatted\n1 file would be formatted, 1 file unchanged\n"
    assert (files / "ugly.aseme").read_text() == UGLY
    assert here("fmt", "--check", "nice.aseme").code == 0


def test_diff_changes_nothing(here: Here, files: Path) -> None:
    done = here("fmt", "--diff", "ugly.aseme", "nice.aseme")
    assert done.code == 0
    assert done.out == (
        "--- ugly.aseme\n+++ ugly.aseme\n@@ -1,2 +1,2 @@\n"
        "-system   A\n-let a=1 // one\n+system A\n+let a = 1  // one\n"
    )
    assert done.err == "1 file would be formatted, 1 file unchanged\n"
    assert (files / "ugly.aseme").read_text() == UGLY
    both = here("fmt", "--check", "--diff", "ugly.aseme")
    assert both.code == 1
    assert both.out == done.out
    assert here("fmt", "--check", "--diff", "nice.aseme").out == ""


def test_colour(here: Here, files: Path) -> None:
    coloured = here("fmt", "--diff", "--color", "always", "ugly.aseme").out
    assert "\x1b[32m+system A" in coloured
    assert "\x1b[31m-system   A" in coloured
    assert "\x1b" not in here("fmt", "--diff", "ugly.aseme").out


def test_standard_input(here: Here, files: Path) -> None:
    done = here("fmt", "-", input=UGLY.encode())
    assert (done.code, done.out, done.err) == (0, NICE, "")
    done = here("fmt", "-", input=UGLY.replace("\n", "\r\n").encode())
    assert done.out == NICE.replace("\n", "\r\n")
    done = here("fmt", "--check", "-", input=UGLY.encode())
    assert (done.code, done.out.splitlines()[0]) == (1, "<stdin>: would be formatted")
    done = here("fmt", "--diff", "-", input=UGLY.encode())
    assert done.out.startswith("--- <stdin>\n")
    done = here("fmt", "-", input=b"system A }")
    assert (done.code, done.out) == (1, "")
    assert "<stdin>:1:10" in done.err


def test_a_file_with_mistakes_stays_and_others_go_on(here: Here, files: Path) -> None:
    (files / "bad.aseme").write_text("system   A }\n")
    done = here("fmt", "bad.aseme", "ugly.aseme")
    assert done.code == 1
    assert "bad.aseme:1:12" in done.err
    assert done.out == "ugly.aseme: formatted\n1 file formatted, 1 file skipped because of errors\n"
    assert (files / "bad.aseme").read_text() == "system   A }\n"
    assert (files / "ugly.aseme").read_text() == NICE
    assert here("fmt", "--check", "bad.aseme").code == 1


def test_only_syntax_counts(here: Here, files: Path) -> None:
    (files / "meaningless.aseme").write_text("let a = nothing_of_that_name\n")
    assert here("fmt", "meaningless.aseme").code == 0


def test_line_ends_mark_permissions_and_links_stay(here: Here, files: Path) -> None:
    ugly = files / "ugly.aseme"
    ugly.write_bytes(b"\xef\xbb\xbf" + UGLY.replace("\n", "\r\n").encode())
    ugly.chmod(0o640)
    (files / "link.aseme").symlink_to(ugly)
    assert here("fmt", "link.aseme").code == 0
    assert ugly.read_bytes() == b"\xef\xbb\xbf" + NICE.replace("\n", "\r\n").encode()
    assert ugly.stat().st_mode & 0o777 == 0o640
    assert (files / "link.aseme").is_symlink()
    assert sorted(path.name for path in files.iterdir()) == ["deep", "link.aseme", "nice.aseme", "ugly.aseme"]


def test_a_file_that_is_named_twice(here: Here, files: Path) -> None:
    assert here("fmt", "ugly.aseme", "./ugly.aseme").out == "ugly.aseme: formatted\n1 file formatted\n"


def test_files_that_cannot_be_read(here: Here, files: Path) -> None:
    (files / "latin.aseme").write_bytes(b"system Caf\xe9")
    (files / "binary.aseme").write_bytes(b"\0\1")
    for name, code in (("missing.aseme", "E001"), ("latin.aseme", "E002"), ("binary.aseme", "E002")):
        done = here("fmt", name)
        assert done.code == 1
        assert code in done.err


def test_json(here: Here, files: Path) -> None:
    result = here("fmt", "--check", "--json", "ugly.aseme", "nice.aseme")
    assert result.code == 1
    first, second = result.json["files"]
    assert (first["file"], first["changed"]) == ("ugly.aseme", True)
    assert "+system A" in first["difference"]
    assert (second["changed"], second["difference"]) == (False, "")
    assert result.json["errors"] == 0


def test_a_file_that_changes_meanwhile_stays(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ugly = files / "ugly.aseme"
    real = outside.read_bytes
    reads = []

    def read_bytes(path: str | os.PathLike[str], largest: int = outside.LARGEST) -> bytes:
        reads.append(path)
        if len(reads) == 2:
            ugly.write_text("system Other\n")
        return real(path, largest)

    monkeypatch.setattr(outside, "read_bytes", read_bytes)
    done = format_file(ugly, write=True)
    assert [item.code for item in done.diagnostics] == ["E009"]
    assert "has changed since it was read" in done.diagnostics[0].message
    assert ugly.read_text() == "system Other\n"


def test_a_file_that_vanishes_meanwhile(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ugly = files / "ugly.aseme"
    real = outside.read_bytes

    def read_bytes(path: str | os.PathLike[str], largest: int = outside.LARGEST) -> bytes:
        content = real(path, largest)
        Path(path).unlink()
        return content

    monkeypatch.setattr(outside, "read_bytes", read_bytes)
    done = format_file(ugly, write=True)
    assert [item.code for item in done.diagnostics] == ["E009"]
    assert not ugly.exists()


def test_a_full_disk_leaves_the_file(files: Path) -> None:
    class Full(Disk):
        def create(self, path: Path, content: bytes, mode: int | None) -> None:
            path.write_bytes(content[:3])
            raise OSError(28, "No space left on device", str(path))

    done = format_file(files / "ugly.aseme", write=True, disk=Full())
    assert [item.code for item in done.diagnostics] == ["E009"]
    assert (files / "ugly.aseme").read_text() == UGLY
    assert not list(files.glob(".asemec*"))


def test_a_read_only_file(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As `os.access` says it is: for root nothing is."""
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    done = format_file(files / "ugly.aseme", write=True)
    assert [item.message for item in done.diagnostics] == [f"{files / 'ugly.aseme'} is read-only"]
    assert (files / "ugly.aseme").read_text() == UGLY


def test_a_file_with_errors_is_not_called_fine(here: Here, files: Path) -> None:
    (files / "broken.aseme").write_text("system S srm {")
    done = here("fmt", "broken.aseme")
    assert (done.code, done.out) == (1, "1 file skipped because of errors\n")
