"""A walk through a project in Neovim, with the files of `editors/vim` and the real server."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).parent
ROOT = HERE.parents[1]

WORLD = """\
message Ball { bool visible  double distance }

topic vision { state Ball }
"""

TEAM = """\
system Team
import "world.aseme"

let near = vision.state.Ball.distance < 0.3

srm player {
  var ready : bool = true
  liveness { player = (Look | Kick)~ }
  control player {
    enter Kik  : [ready && near]
    enter Look : else
  }
  activities { Look every 100ms writes vision.state.Ball, ready }
}

team All { robot : player }
"""

PAGE = (ROOT / "docs/howto/editors/neovim.md").read_text("utf-8")


def settings(command: list[str]) -> str:
    """The init.lua of the documentation, for this checkout and a server of this Python."""
    (text,) = re.findall(r'```lua\n(.*?require\("aseme"\).*?)```', PAGE, re.DOTALL)
    here = text.replace("~/.local/share/nvim/site/pack/aseme/start/aseme", str(ROOT / "editors/vim"))
    changed = here.replace("setup()", f"setup({{ cmd = {{ {json.dumps(command)[1:-1]} }} }})")
    assert here != text and changed != here
    return changed


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What the walk has seen."""
    if shutil.which("nvim") is None:
        pytest.skip("NOT TRIED, for there is no nvim here: apt install neovim")
    folder = tmp_path_factory.mktemp("project")
    (folder / "pyproject.toml").write_text("[tool.asemec]\n")
    (folder / "world.aseme").write_text(WORLD)
    (folder / "team.aseme").write_text(TEAM)
    init = folder / "init.lua"
    init.write_text(settings([sys.executable, "-m", "aseme_dsl", "lsp"]))
    result = folder / "result.json"
    environment = {**os.environ, "NVIM_RESULT": str(result), "PYTHONPATH": str(ROOT)}
    environment |= {f"XDG_{name}_HOME": str(folder / name) for name in ("CONFIG", "DATA", "STATE", "CACHE")}
    command_line = ["nvim", "--headless", "-i", "NONE", "-n", "-u", str(init)]
    done = subprocess.run(
        [*command_line, "-c", f"luafile {HERE / 'neovim.lua'}"],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
    )
    assert result.exists(), done.stdout + done.stderr
    found: dict[str, Any] = json.loads(result.read_text())
    assert "problem" not in found, found
    return found | {
        "folder": str(folder),
        "files": {path.name: path.read_text() for path in folder.glob("*.aseme")},
    }


def test_the_server_is_started_in_the_projects_folder(seen: dict[str, Any]) -> None:
    assert seen["filetype"] == "aseme"
    assert seen["clients"] == [["asemec", seen["folder"]]]


def test_mistakes_are_shown_where_they_are(seen: dict[str, Any]) -> None:
    assert [each.partition(":")[0] for each in seen["mistakes"]] == ["10"]
    assert "Kik" in seen["mistakes"][0]


def test_completion_offers_the_terms_of_this_formula(seen: dict[str, Any]) -> None:
    assert {"Look", "Kick"} <= set(seen["completion"])
    assert "topic" not in seen["completion"]


def test_a_condition_pasted_from_kse_is_translated(seen: dict[str, Any]) -> None:
    assert [each.partition(":")[0] for each in seen["pasted"]] == ["10"]
    assert "an expression of KSE" in seen["pasted"][0]
    assert "has(vision.state.Ball)" in seen["offered"]
    assert seen["translated"] == "enter Kick  : [ready && near && has(vision.state.Ball)]"


def test_hover_says_what_a_name_is(seen: dict[str, Any]) -> None:
    assert "bool" in seen["hover"]


def test_the_definition_is_in_the_imported_file(seen: dict[str, Any]) -> None:
    assert seen["definition"].startswith("message Ball")


def test_a_name_is_changed_everywhere(seen: dict[str, Any]) -> None:
    assert seen["renamed"].count("Shoot") == 2
    assert "Kick" not in seen["renamed"]


def test_the_file_is_laid_out(seen: dict[str, Any]) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "aseme_dsl", "fmt", "-"],
        input=seen["renamed"],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    assert seen["formatted"] == done.stdout
    assert seen["files"]["team.aseme"] == seen["formatted"]


WHERE = """
local result = vim.env.NVIM_RESULT
local function walk()
  vim.cmd("edit activities/look.py")
  vim.wait(60000, function() return next(vim.lsp.buf_get_clients(0)) ~= nil end, 20)
  vim.fn.search("context")
  vim.lsp.buf.declaration()
  vim.wait(60000, function() return vim.fn.expand("%:t") == "team.aseme" end, 20)
  local there = vim.fn.expand("%:t") .. ": " .. vim.trim(vim.fn.getline("."))
  vim.lsp.buf.implementation()
  vim.wait(60000, function() return vim.fn.expand("%:t") == "look.py" end, 20)
  vim.fn.writefile({ there, vim.fn.expand("%:t") .. ": " .. vim.fn.getline(".") }, result)
end
local fine, problem = xpcall(walk, debug.traceback)
if not fine then vim.fn.writefile({ tostring(problem) }, result) end
vim.cmd("qall!")
"""


def test_the_class_of_an_activity_leads_to_the_model(tmp_path: Path) -> None:
    if shutil.which("nvim") is None:
        pytest.skip("NOT TRIED, for there is no nvim here: apt install neovim")
    (tmp_path / "pyproject.toml").write_text('[tool.asemec]\nactivities = "activities"\n')
    (tmp_path / "world.aseme").write_text(WORLD)
    (tmp_path / "team.aseme").write_text(TEAM.replace("Kik ", "Kick"))
    (tmp_path / "activities").mkdir()
    (tmp_path / "activities/look.py").write_text("class Look:\n    def execute(self, context): ...\n")
    (tmp_path / "init.lua").write_text(settings([sys.executable, "-m", "aseme_dsl", "lsp"]))
    (tmp_path / "where.lua").write_text(WHERE)
    environment = {**os.environ, "NVIM_RESULT": str(tmp_path / "result"), "PYTHONPATH": str(ROOT)}
    environment |= {f"XDG_{name}_HOME": str(tmp_path / name) for name in ("CONFIG", "DATA", "STATE", "CACHE")}
    command = ["nvim", "--headless", "-i", "NONE", "-n", "-u", "init.lua", "-c", "luafile where.lua"]
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL
    )
    assert (tmp_path / "result").exists(), done.stdout + done.stderr
    assert (tmp_path / "result").read_text().splitlines() == [
        "team.aseme: activities { Look every 100ms writes vision.state.Ball, ready }",
        "look.py: class Look:",
    ]
