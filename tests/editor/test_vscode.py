"""The extension of VS Code, but for what needs VS Code itself (benchmarks/vscode_host.py has that)."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import aseme_dsl
from aseme_dsl.editor.answers.hints import DIAGRAM, RUN
from aseme_dsl.editor.authoring import CARRY_OUT, EXPLAIN

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "editors/vscode"
MANIFEST: dict[str, Any] = json.loads((FOLDER / "package.json").read_text("utf-8"))
CONTRIBUTES = MANIFEST["contributes"]
SOURCES = {path.name: path.read_text("utf-8") for path in sorted((FOLDER / "src").glob("*.js"))}
SETTINGS = json.loads((FOLDER / "language-configuration.json").read_text("utf-8"))


def test_it_has_the_version_of_the_package() -> None:
    assert MANIFEST["version"] == aseme_dsl.__version__
    assert json.loads((FOLDER / "package-lock.json").read_text("utf-8"))["version"] == aseme_dsl.__version__


def test_every_file_that_it_names_is_there() -> None:
    named = [MANIFEST["icon"], *(each["path"] for each in CONTRIBUTES["grammars"])]
    named += [CONTRIBUTES["languages"][0]["configuration"], *CONTRIBUTES["languages"][0]["icon"].values()]
    assert [name for name in named if not (FOLDER / name).is_file()] == []


def test_every_command_that_it_offers_is_there() -> None:
    registered = set(re.findall(r'registerCommand\("([\w.]+)"', SOURCES["extension.js"]))
    assert {each["command"] for each in CONTRIBUTES["commands"]} <= registered
    assert not registered & {CARRY_OUT, EXPLAIN}, "the client registers what the server offers itself"
    assert {DIAGRAM, RUN} <= registered, "what the server shows above a model or a team"


def test_every_setting_that_it_reads_is_there() -> None:
    read = set(re.findall(r'getConfiguration\("aseme"\)\.get\("([\w.]+)"', "".join(SOURCES.values())))
    assert read and {f"aseme.{name}" for name in read} <= set(CONTRIBUTES["configuration"]["properties"])


def test_the_problem_matcher_reads_what_check_prints(tmp_path: Path) -> None:
    (tmp_path / "team.aseme").write_text("system A\nteam T { a : b }\nsrm r { liveness { r = X [Y] } }\n")
    done = subprocess.run(
        [sys.executable, "-m", "aseme_dsl", "check", "team.aseme"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    pattern = CONTRIBUTES["problemPatterns"][0]
    found = [
        match
        for line in (done.stdout + done.stderr).splitlines()
        if (match := re.match(pattern["regexp"], line))
    ]
    parts = ("file", "line", "column", "severity", "code")
    assert [[match[pattern[part]] for part in parts] for match in found] == [
        ["team.aseme", "2", "14", "error", "E207"],
        ["team.aseme", "3", "26", "error", "E101"],
    ]


@pytest.mark.parametrize(
    ("line", "opens"),
    [
        ("srm r {", True),
        ("  liveness { // one", True),
        ("topic t { state Ball }", False),
        ('  engage "a { in a text"', False),
        ("// a { in a comment", False),
        ("}", False),
    ],
)
def test_what_a_line_leaves_open_is_indented(line: str, opens: bool) -> None:
    pattern = SETTINGS["indentationRules"]["increaseIndentPattern"]
    assert (re.search(pattern, line) is not None) == opens


def test_the_sources_are_javascript(tmp_path: Path) -> None:
    node = shutil.which("node")
    if node is None:
        pytest.skip("NOT TRIED, for there is no `node` here: install Node.js 20 or newer")
    files = [*(FOLDER / "src").glob("*.js"), *(FOLDER / "media").glob("*.js")]
    for path in files:
        copy = tmp_path / path.with_suffix(".mjs" if path.parent.name == "src" else ".js").name
        copy.write_text(path.read_text("utf-8"), "utf-8")
        done = subprocess.run([node, "--check", str(copy)], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
