"""`asemec check`."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import GOOD, Here, asemec


def test_a_good_file(here: Here, folder: Path) -> None:
    done = here("check", "good.aseme")
    assert (done.code, done.out, done.err) == (0, "1 file is fine\n", "")


def test_all_errors_of_a_file_in_one_run(here: Here, folder: Path) -> None:
    done = here("check", "bad.aseme")
    assert done.code == 1
    assert "bad.aseme:8:" in done.out
    assert "did you mean `Seen`?" in done.out
    assert done.out.splitlines()[-1].startswith("2 errors")
    assert done.out.splitlines()[-1].endswith("in 1 file")
    assert done.err == ""


def test_everything_below_a_folder(here: Here, folder: Path) -> None:
    (folder / "deep").mkdir()
    (folder / "deep" / "other.aseme").write_text(
        'import "shared.aseme"\n' + GOOD.replace("message Seen", "message Sun")
    )
    (folder / "deep" / "shared.aseme").write_text("message Seen { bool ball  bool home }")
    done = here("check", ".")
    assert done.code == 1
    assert done.out.splitlines()[-1].endswith("in 4 files")
    assert "other.aseme" not in done.out
    assert here("check").out == done.out


def test_a_file_that_others_import_needs_no_system(here: Here, folder: Path) -> None:
    (folder / "shared.aseme").write_text("message Seen { bool ball }\ntopic eyes { state Seen }\n")
    done = here("check", "shared.aseme")
    assert (done.code, done.out) == (0, "1 file is fine\n")
    done = here("build", "shared.aseme")
    assert done.code == 1 and "E008" in done.err
    (folder / "shared.aseme").write_text("srm player { liveness { player = Look } }")
    done = here("check", "shared.aseme")
    assert done.code == 1 and "E008" in done.out


def test_a_library_that_nobody_imports_is_checked_too(here: Here, folder: Path) -> None:
    (folder / "bad.aseme").unlink()
    (folder / "shared.aseme").write_text("message Seen { bol ball }")
    done = here("check", ".")
    assert done.code == 1
    assert "shared.aseme:1:" in done.out
    assert "no system" not in done.out


def test_standard_input(folder: Path) -> None:
    assert asemec("check", "-", input=GOOD.encode()).out == "1 file is fine\n"
    done = asemec("check", "-", input=b"\xef\xbb\xbfsystem A }")
    assert done.code == 1
    assert "<stdin>:1:10" in done.out
    assert asemec("check", "-", input=b"\xff").code == 1


def test_patterns(here: Here, folder: Path) -> None:
    assert here("check", "g*.aseme").out == "1 file is fine\n"
    done = here("check", "x*.aseme")
    assert done.code == 1
    assert "no .aseme file matches x*.aseme" in done.out


def test_what_cannot_be_read(here: Here, folder: Path) -> None:
    (folder / "empty.aseme").write_text("")
    (folder / "binary.aseme").write_bytes(b"\x7fELF\0\0")
    (folder / "latin.aseme").write_bytes(b"system Caf\xe9")
    for name, code in (("missing", "E001"), ("binary", "E002"), ("latin", "E002")):
        done = here("check", f"{name}.aseme")
        assert done.code == 1
        assert f"error[{code}]" in done.out
    assert "goood.aseme" in here("check", "goood.aseme").out
    assert "did you mean `good.aseme`?" in here("check", "goood.aseme").out
    assert "empty" in here("check", "empty.aseme").out
    assert here("check", ".").code == 1


def test_strict_counts_warnings(here: Here, folder: Path) -> None:
    text = GOOD[: GOOD.index("  control")] + "}\n"
    (folder / "warned.aseme").write_text(text.replace("(Walk | Stand)+", "Walk . Stand || Walk"))
    done = here("check", "warned.aseme")
    assert "warning[W300]" in done.out
    assert done.code == 0
    assert here("check", "--strict", "warned.aseme").code == 1


def test_json(here: Here, folder: Path) -> None:
    result = here("check", "--json", "bad.aseme").json
    assert (result["format"], result["files"], result["errors"]) == (1, 1, 2)
    first = result["diagnostics"][0]
    assert first["severity"] == "error"
    assert first["place"]["file"] == "bad.aseme"
    assert first["place"]["line"] == 8
    good = here("check", "--json", "good.aseme").json
    assert good == {"format": 1, "files": 1, "errors": 0, "warnings": 0, "notes": 0, "diagnostics": []}


class TestConfiguration:
    def test_its_mistakes_are_errors(self, here: Here, folder: Path) -> None:
        (folder / "pyproject.toml").write_text("[tool.asemec]\nmax_state = 3\n")
        done = here("check", "good.aseme")
        assert done.code == 1
        assert "pyproject.toml:2:1: error[E010]" in done.out
        assert "did you mean `max_states`?" in done.out
        assert done.out.splitlines()[-1] == "1 error in 2 files"

    def test_its_files_are_checked_if_none_are_named(self, here: Here, folder: Path) -> None:
        (folder / "pyproject.toml").write_text('[tool.asemec]\nfiles = ["good.aseme"]\n')
        assert here("check").out == "1 file is fine\n"
        assert here("check", ".").code == 1

    def test_its_size_limit_counts(self, here: Here, folder: Path) -> None:
        (folder / "pyproject.toml").write_text("[tool.asemec]\nmax_states = 3\n")
        done = here("check", "good.aseme")
        assert "error[E304]" in done.out

    @pytest.mark.parametrize("text", ["[tool.asemec", "\udcff"])
    def test_a_file_that_is_no_configuration(self, here: Here, folder: Path, text: str) -> None:
        (folder / "pyproject.toml").write_text(text, "utf-8", "surrogateescape")
        assert here("check", "good.aseme").code == 1
