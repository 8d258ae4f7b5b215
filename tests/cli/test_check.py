"""`asemec check`."""

from __future__ import annotations

import json
import os
import re
import sys
from pathlib import Path
from urllib.parse import urlparse

import pytest

from tests.cli.support import BAD, GOOD, WARNED, Here, asemec, command
from tests.conftest import Snapshot
from tests.support.terminal import shown


def test_a_good_file(here: Here, folder: Path) -> None:
    done = here("check", "good.aseme")
    assert (done.code, done.out, done.err) == (0, "no problems found in 1 file\n", "")


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
    own = [line for line in GOOD.splitlines(keepends=True) if not line.startswith("message Seen")]
    (folder / "deep" / "other.aseme").write_text('import "shared.aseme"\n' + "".join(own))
    (folder / "deep" / "shared.aseme").write_text("message Seen { bool ball  bool home }")
    done = here("check", ".")
    assert done.code == 1
    assert done.out.splitlines()[-1].endswith("in 4 files")
    assert "other.aseme" not in done.out
    assert here("check").out == done.out


def test_a_file_that_others_import_needs_no_system(here: Here, folder: Path) -> None:
    (folder / "shared.aseme").write_text("message Seen { bool ball }\ntopic eyes { state Seen }\n")
    done = here("check", "shared.aseme")
    assert (done.code, done.out) == (0, "no problems found in 1 file\n")
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
    assert asemec("check", "-", input=GOOD.encode()).out == "no problems found in 1 file\n"
    done = asemec("check", "-", input=b"\xef\xbb\xbfsystem A }")
    assert done.code == 1
    assert "<stdin>:1:10" in done.out
    assert asemec("check", "-", input=b"\xff").code == 1


def test_patterns(here: Here, folder: Path) -> None:
    assert here("check", "g*.aseme").out == "no problems found in 1 file\n"
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
    (folder / "warned.aseme").write_text(WARNED)
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
    assert [item["chart"] for item in good.pop("certified")] == ["iac.robot"]
    assert good == {
        "format": 1,
        "files": 1,
        "errors": 0,
        "warnings": 0,
        "notes": 0,
        "diagnostics": [],
        "unchecked_choices": 0,
        "suppressed": [],
    }


class TestWithoutZ3:
    """Conditions are compared by z3, which is an extra: without it, that is said once."""

    @pytest.fixture(autouse=True)
    def without(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        hidden = tmp_path / "hidden"
        hidden.mkdir()
        (hidden / "z3.py").write_text("raise ImportError('not installed')\n")
        monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(hidden), *sys.path]))

    def test_a_line_after_the_summary_says_what_was_not_done(self, folder: Path) -> None:
        (folder / "bad.aseme").write_text(CHOICE)
        done = asemec("check", "bad.aseme", cwd=folder)
        install = 'pip install "aseme-dsl[check]"'
        assert (
            done.out == "no problems found in 1 file\n"
            f"1 choice was not checked for overlaps and gaps; to enable this: {install}\n"
        )
        assert done.code == 0
        assert asemec("check", "--json", "bad.aseme", cwd=folder).json["unchecked_choices"] == 1

    def test_where_there_is_no_such_choice_nothing_is_said(self, folder: Path) -> None:
        assert asemec("check", "good.aseme", cwd=folder).out == "no problems found in 1 file\n"

    def test_what_is_allowed_in_case_it_is_looked_for_is_not_idle(self, folder: Path) -> None:
        allowed = CHOICE.replace("  enter Walk", "  // asemec: allow(W411) it waits\n    enter Walk")
        (folder / "bad.aseme").write_text(allowed)
        assert "W011" not in asemec("check", "bad.aseme", cwd=folder).out


CHOICE = GOOD.replace("else\n    leave", "[eyes.state.Seen.home && eyes.state.Seen.ball]\n    leave")


class TestReports:
    @pytest.mark.parametrize("form", ["text", "json", "sarif", "github", "junit", "codequality"])
    def test_what_it_says(self, here: Here, folder: Path, snapshot: Snapshot, form: str) -> None:
        (folder / "allowed.aseme").write_text(
            WARNED.replace("  liveness", "  // asemec: allow(W300) as in the paper\n  liveness")
        )
        done = here("check", "--format", form, "bad.aseme", "allowed.aseme")
        assert done.code == 1
        report = done.out
        if form == "sarif":  # the texts of the pages are not what this is about
            log = json.loads(report)
            for rule in log["runs"][0]["tool"]["driver"]["rules"]:
                assert rule["help"]["text"]
                rule["help"] = {"text": "…"}
            report = json.dumps(log, indent=2, ensure_ascii=False) + "\n"
        snapshot(report, f"check.{form}")

    @pytest.mark.parametrize("form", ["text", "json", "sarif", "github", "junit", "codequality"])
    def test_a_file_gets_what_would_be_printed(self, here: Here, folder: Path, form: str) -> None:
        here("check", "--format", "junit", "good.aseme", "-o", "report")  # the last one
        printed = here("check", "--format", form, "bad.aseme")
        done = here("check", "--format", form, "bad.aseme", "-o", "report")
        assert (done.code, done.err) == (1, "")
        assert done.out == "2 errors in 1 file\n"
        assert (folder / "report").read_text("utf-8") == printed.out
        assert sorted(path.name for path in folder.iterdir()) == ["bad.aseme", "good.aseme", "report"]

    @pytest.mark.parametrize("form", ["text", "json", "sarif", "github", "junit", "codequality"])
    def test_a_report_takes_the_place_of_a_report_and_of_nothing_else(
        self, here: Here, folder: Path, form: str
    ) -> None:
        for name in ("good.aseme", "bad.aseme"):
            for _ in range(2):
                assert here("check", "--format", form, name, "-o", "report").code == int(name == "bad.aseme")
        (folder / "mine").write_text("my own words\n")
        done = here("check", "--format", form, "good.aseme", "-o", "mine")
        assert done.code == 2 and "mine is there already, and is not a report that asemec wrote" in done.err
        assert (folder / "mine").read_text() == "my own words\n"

    def test_a_report_goes_where_a_link_leads_and_into_a_pipe(self, here: Here, folder: Path) -> None:
        (folder / "link").symlink_to("there.json")
        assert here("check", "good.aseme", "--json", "-o", "link").code == 0
        assert (folder / "link").is_symlink()
        assert (folder / "there.json").read_text().startswith("{")
        assert here("check", "good.aseme", "--json", "-o", "/dev/stdout").code == 0
        assert Path("/dev/null").is_char_device()
        assert here("check", "good.aseme", "-o", "/dev/null").code == 0
        assert Path("/dev/null").is_char_device()

    def test_a_report_that_cannot_be_written(self, here: Here, folder: Path) -> None:
        (folder / "report").mkdir()
        done = here("check", "good.aseme", "-o", "report")
        assert done.code == 1
        assert "error[E009]: report is a folder" in done.err
        done = here("check", "good.aseme", "-o", "good.aseme/report")
        assert done.code == 1
        assert "error[E009]" in done.err

    @pytest.mark.parametrize(
        "arguments",
        [
            ("-o", "good.aseme"),
            ("--json", "--format", "sarif"),
            ("--format", "xml"),
            ("--diff",),
            ("--fix", "-"),
            ("--fix", "--diff", "--json"),
        ],
    )
    def test_wrong_use(self, here: Here, folder: Path, arguments: tuple[str, ...]) -> None:
        before = (folder / "good.aseme").read_bytes()
        assert here("check", "good.aseme", *arguments).code == 2
        assert (folder / "good.aseme").read_bytes() == before

    def test_strict_failures_of_junit(self, here: Here, folder: Path) -> None:
        (folder / "warned.aseme").write_text(WARNED)
        assert '<failure type="W300"' not in here("check", "--format", "junit", "warned.aseme").out
        assert '<failure type="W300"' in here("check", "--strict", "--format", "junit", "warned.aseme").out


class TestTerminal:
    def run(self, *arguments: str) -> str:
        """What somebody sees who is at a terminal."""
        return shown(command("check", *arguments))

    def test_codes_are_links_and_there_is_a_tip(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.delenv("NO_COLOR", raising=False)
        monkeypatch.setenv("TERM", "xterm")
        (folder / "warned.aseme").write_text(
            GOOD.replace("  liveness", "  // asemec: alow(W300)\n  liveness")
        )
        said = self.run("warned.aseme")
        link = re.search(r"\x1b\]8;;(file://[^\x1b]*/W014\.md)\x1b\\W014\x1b\]8;;\x1b\\", said)
        assert link is not None
        assert Path(urlparse(link[1]).path).read_text("utf-8").startswith("A comment")
        assert said.endswith(
            "1 warning in 1 file\nfor details: asemec explain W014; to fix 1 problem: asemec check --fix\n"
        )
        assert "explain" not in self.run("good.aseme")

    def test_without_colours_there_are_no_links(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setenv("NO_COLOR", "1")
        assert "\x1b" not in self.run("bad.aseme")


class TestPolicy:
    def write(self, folder: Path, text: str) -> None:
        (folder / "warned.aseme").write_text(WARNED)
        (folder / "pyproject.toml").write_text(f"[tool.asemec.diagnostics]\n{text}\n")

    def test_a_warning_that_is_an_error(self, here: Here, folder: Path) -> None:
        self.write(folder, 'W300 = "error"')
        done = here("check", "warned.aseme")
        assert done.code == 1
        assert "error[W300]" in done.out
        assert done.out.endswith("\n1 error in 1 file\n")
        assert here("check", "--json", "warned.aseme").json["diagnostics"][0]["severity"] == "error"
        assert here("check", "--format", "github", "warned.aseme").out.startswith("::error ")
        assert here("build", "warned.aseme").code == 1
        assert not (folder / "out").exists()

    def test_a_group_that_is_off(self, here: Here, folder: Path) -> None:
        self.write(folder, 'W3 = "off"')
        assert here("check", "--strict", "warned.aseme").out == "no problems found in 1 file\n"
        assert "W300" not in here("build", "warned.aseme").err

    def test_a_note_is_not_strict(self, here: Here, folder: Path) -> None:
        self.write(folder, 'W300 = "note"')
        done = here("check", "--strict", "warned.aseme")
        assert done.code == 0
        assert "note[W300]" in done.out

    def test_files_of_its_own(self, here: Here, folder: Path) -> None:
        self.write(folder, 'W3 = "error"\n\n[tool.asemec.diagnostics."drafts/*"]\nW300 = "off"')
        (folder / "drafts").mkdir()
        (folder / "drafts" / "draft.aseme").write_text(WARNED)
        assert here("check", "drafts").code == 0
        assert here("check", "warned.aseme").code == 1

    def test_its_mistakes(self, here: Here, folder: Path) -> None:
        self.write(
            folder,
            'w300 = "error"\nE200 = "off"\nW300 = "fatal"\nW301 = 3\nE201 = "error"\n'
            '\n[tool.asemec.diagnostics."drafts/*"]\n"x" = "off"\nW3.y = 1',
        )
        done = here("check", "warned.aseme")
        assert done.code == 1
        places = [line.split(": ")[:1][0] for line in done.out.splitlines() if "error[E010]" in line]
        assert places == [f"pyproject.toml:{line}:1" for line in (2, 3, 4, 5, 9, 10)]
        assert "did you mean `W300`?" in done.out
        assert "an error cannot be turned down or off" in done.out

    def test_no_table(self, here: Here, folder: Path) -> None:
        (folder / "pyproject.toml").write_text('[tool.asemec]\ndiagnostics = "off"\n')
        assert "`diagnostics` must be a table: [tool.asemec.diagnostics]" in here("check", "good.aseme").out


class TestFix:
    def test_it_mends_and_says_what_is_left(self, here: Here, folder: Path) -> None:
        text = BAD.replace("system Walker", "system Walker\r", 1).encode()
        (folder / "bad.aseme").write_bytes(b"\xef\xbb\xbf" + text)
        done = here("check", "--fix", "bad.aseme")
        assert done.code == 1
        lines = done.out.splitlines()
        assert lines[0].startswith("bad.aseme:8:")
        assert lines[0].endswith(": fixed[E502]: `Sen` -> `Seen`")
        assert lines[1] == "1 problem fixed in 1 file"
        assert lines[-1] == "1 error in 1 file"
        after = (folder / "bad.aseme").read_bytes()
        assert after == b"\xef\xbb\xbf" + text.replace(b"state.Sen.", b"state.Seen.")
        assert "fixed" not in here("check", "--fix", "bad.aseme").out

    def test_diff_shows_it_and_writes_nothing(self, here: Here, folder: Path) -> None:
        done = here("check", "--fix", "--diff", "bad.aseme")
        assert done.code == 1
        assert done.out.splitlines()[:2] == ["--- bad.aseme", "+++ bad.aseme"]
        assert "+    enter Walk  : [eyes.state.Seen.ball]" in done.out
        assert "error[E" in done.err, "what is not mended is said"
        assert (folder / "bad.aseme").read_text() == BAD
        assert here("check", "--fix", "--diff", "good.aseme").out == ""

    def test_json_says_what_was_mended(self, here: Here, folder: Path) -> None:
        result = here("check", "--fix", "--json", "bad.aseme").json
        assert [item["fix"] for item in result["mended"]] == ["Seen"]
        assert result["errors"] == 1

    def test_what_two_systems_import_is_mended_once(self, here: Here, folder: Path) -> None:
        (folder / "bad.aseme").unlink()
        (folder / "good.aseme").unlink()
        (folder / "shared.aseme").write_text("message Seen { boolean ball  boolean home }\n")
        for name in ("One", "Two"):
            text = GOOD.replace("system Walker", f'system {name}\nimport "shared.aseme"')
            text = text.replace("message Seen { bool ball  bool home }\n", "")
            (folder / f"{name}.aseme").write_text(text)
        done = here("check", "--fix")
        assert done.out.endswith("1 problem fixed in 1 file\n\nno problems found in 3 files\n")
        assert (folder / "shared.aseme").read_text() == "message Seen { bool ball  bool home }\n"


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
        assert here("check").out == "no problems found in 1 file\n"
        assert here("check", ".").out == "no problems found in 1 file\n"
        assert here("check", "*.aseme").code == 1

    def test_its_size_limit_counts(self, here: Here, folder: Path) -> None:
        (folder / "pyproject.toml").write_text("[tool.asemec]\nmax_states = 3\n")
        done = here("check", "good.aseme")
        assert "error[E304]" in done.out

    @pytest.mark.parametrize("text", ["[tool.asemec", "\udcff"])
    def test_a_file_that_is_no_configuration(self, here: Here, folder: Path, text: str) -> None:
        (folder / "pyproject.toml").write_text(text, "utf-8", "surrogateescape")
        assert here("check", "good.aseme").code == 1


def test_a_variable_that_only_the_code_reads_is_read(here: Here, folder: Path) -> None:
    (folder / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["count.aseme"]\nactivities = "activities"\n', "utf-8"
    )
    (folder / "count.aseme").write_text(
        "system S srm r { var n : int = 0 var m : int = 0\n"
        "liveness { r = Walk~ } activities { Walk takes 1s }\n"
        "control r { repeat Walk : / n = n + 1; m = 2 } }"
    )
    (folder / "activities").mkdir()
    (folder / "activities" / "walk.py").write_text(
        'class Walk:\n    def execute(self, context):\n        context.log(context.get_variable("n"))\n'
    )
    done = here("check", "count.aseme")
    assert "variable `m`" in done.out + done.err
    assert "variable `n`" not in done.out + done.err
