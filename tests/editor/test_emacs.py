"""A walk through a project in Emacs, with the mode of `editors/emacs` and the real server."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.editor.test_neovim import ROOT, TEAM, WORLD
from tests.grammar.syntax.programs import laid_out

HERE = Path(__file__).parent


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What the walk has seen."""
    if shutil.which("emacs") is None:
        pytest.skip("NOT TRIED, for there is no emacs here: apt install emacs-nox elpa-eglot")
    folder = tmp_path_factory.mktemp("project")
    (folder / "pyproject.toml").write_text('[tool.asemec]\nactivities = "activities"\n')
    (folder / "activities").mkdir()
    (folder / "activities/look.py").write_text("class Look:\n    def execute(self, context): ...\n")
    (folder / "world.aseme").write_text(WORLD)
    (folder / "team.aseme").write_text("// The team.\n" + TEAM)
    result = folder / "result.json"
    variables = {
        "EMACS_RESULT": str(result),
        "ASEME_EDITORS": str(ROOT / "editors"),
        "ASEME_COMMAND": f"{sys.executable} -m aseme_dsl",
        "PYTHONPATH": str(ROOT),
        "HOME": str(folder),
    }
    done = subprocess.run(
        ["emacs", "-Q", "--batch", "-l", str(HERE / "emacs.el")],
        cwd=folder,
        env={**os.environ, **variables},
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
    )
    assert result.exists(), done.stdout + done.stderr
    found: dict[str, Any] = json.loads(result.read_text())
    assert "problem" not in found, (found, done.stderr)
    return found


def test_words_have_the_faces_of_their_kinds(seen: dict[str, Any]) -> None:
    assert seen["mode"] == "ASEME"
    kinds = ("keyword", "type", "builtin", "default", "comment-delimiter")
    assert [face.removeprefix("font-lock-").removesuffix("-face") for face in seen["faces"]] == list(kinds)


def test_the_indentation_is_that_of_fmt(seen: dict[str, Any]) -> None:
    assert seen["indented"] is True


def test_the_server_answers(seen: dict[str, Any]) -> None:
    if not seen["eglot"]:
        pytest.skip("NOT TRIED, for this Emacs has no eglot: apt install elpa-eglot, or Emacs 29")
    assert any("Kik" in each for each in seen["mistakes"])
    assert seen["renamed"].count("Shoot") == 2
    assert "srm player {\n" in seen["formatted"]


def test_the_class_of_an_activity_leads_to_the_model(seen: dict[str, Any]) -> None:
    if not seen["eglot"]:
        pytest.skip("NOT TRIED, for this Emacs has no eglot: apt install elpa-eglot, or Emacs 29")
    assert "team.aseme" in seen["where"]
    assert "Look every 100ms" in seen["where"] and "liveness {" in seen["where"]


REINDENT = """
(setq make-backup-files nil)
(add-to-list 'load-path (concat (getenv "ASEME_EDITORS") "/emacs"))
(require 'aseme-mode)
(dolist (file command-line-args-left)
  (find-file file)
  (aseme-mode)
  (indent-region (point-min) (point-max))
  (save-buffer))
(setq command-line-args-left nil)
"""


def test_a_file_that_is_laid_out_stays_as_it_is(tmp_path: Path) -> None:
    """`indent-region` keeps what continued lines are aligned with."""
    if shutil.which("emacs") is None:
        pytest.skip("NOT TRIED, for there is no emacs here: apt install emacs-nox elpa-eglot")
    script = tmp_path / "reindent.el"
    script.write_text(REINDENT)
    files = laid_out(tmp_path)
    command = ["emacs", "-Q", "--batch", "-l", str(script), *map(str, files)]
    environment = {**os.environ, "ASEME_EDITORS": str(ROOT / "editors"), "HOME": str(tmp_path)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    assert done.returncode == 0, done.stderr
    assert [path.name for path, text in files.items() if path.read_text("utf-8") != text] == []
